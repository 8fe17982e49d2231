// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2870 bits, pipeline 889 bits, memories 58067 bits.
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
  input  logic [5:0] cfg_patch_limit_i,
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
  assign last = {2'h0, cfg_width_i[8:3]} + 8'hff;
  logic [5:0] sum_2358;
  assign sum_2358 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3354;
  assign difference_3354 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_3574;
  assign difference_3574 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_3807;
  assign less_3807 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_3808;
  assign sum_3808 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_3809;
  assign select_3809 = less_3807 ? {sum_3808, cfg_height_i[5:3]} : 8'h0;
  logic not_3844;
  assign not_3844 = ~cfg_prove_i;

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
  logic [5:0] last_q;
  logic [5:0] least_q;
  logic [6:0] whole_q;
  logic [6:0] drawn_q;
  logic [6:0] age_q;
  logic [2:0] slot_q;
  logic ends_cell_q;
  logic ends_q;
  logic final_row_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_462;
  assign select_462 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_464;
  assign select_464 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [7:0] select_467;
  assign select_467 = ({select_464, select_462} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:116
  logic [7:0] select_468;
  assign select_468 = select_462[0] ? averager_place_q : select_467;
  // hls/stages/census.hpp:41
  logic or_469;
  assign or_469 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_472;
  assign and_472 = (select_462[0] & or_469) & (select_468 < 8'hbd);
  // hls/stages/census.hpp:41
  logic [2:0] select_477;
  assign select_477 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_464 : 6'h0;
  // hls/stages/census.hpp:50
  logic equal_494;
  assign equal_494 = select_462 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_495;
  assign equal_495 = select_477 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_496;
  assign and_496 = equal_495 & and_472;
  // hls/stages/agreement.hpp:263
  logic and_498;
  assign and_498 = sample_pair_whole_q & (equal_494 & and_496);
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:610
  logic equal_518;
  assign equal_518 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:581
  logic or_519;
  assign or_519 = so | equal_518;
  // hls/stages/agreement.hpp:704
  logic not_520;
  assign not_520 = ~or_519;
  // hls/stages/agreement.hpp:601
  logic equal_521;
  assign equal_521 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_523;
  assign equal_523 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:579
  logic [7:0] sum_524;
  assign sum_524 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_525;
  assign select_525 = run_shift_q[5] ? x_q : sum_524;
  logic less_526;
  assign less_526 = {2'h0, last_q} < select_525;
  // hls/stages/agreement.hpp:216
  logic not_527;
  assign not_527 = ~less_526;
  // hls/stages/agreement.hpp:141
  logic and_528;
  assign and_528 = equal_523 & not_527;
  logic and_530;
  assign and_530 = not_520 & ((~equal_521) & and_528);
  // hls/stages/census.hpp:41
  logic [5:0] select_557;
  assign select_557 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_557 : 6'h0;
  // hls/stages/agreement.hpp:141
  logic select_614;
  assign select_614 = equal_521 ? not_527 : and_528;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:770
  logic [6:0] sum_634;
  assign sum_634 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:141
  logic and_639;
  assign and_639 = equal_521 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_634} < select_525))));
  logic select_640;
  assign select_640 = or_519 ? not_527 : and_639;
  // hls/stages/agreement.hpp:778
  logic equal_643;
  assign equal_643 = {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:782
  logic or_645;
  assign or_645 = equal_643 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:794
  logic [5:0] right;
  assign right = sum_524[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:182
  logic and_1840;
  assign and_1840 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:263
  logic [2:0] select_2005;
  assign select_2005 = sample_pair_whole_q ? (sample_last_q ? (select_477 + 3'h1) : select_477) : raster_at_y_q;
  logic [5:0] select_2007;
  assign select_2007 = sample_pair_whole_q ? (select_464 + {5'h0, equal_494}) : raster_at_column_q;
  logic [5:0] select_2010;
  assign select_2010 = sample_pair_whole_q ? (sample_last_q ? (select_557 + {5'h0, equal_495}) : select_557) : raster_at_row_q;
  logic select_2014;
  assign select_2014 = sample_pair_whole_q ? (sample_last_q ? (or_469 & (~raster_final_row_q)) : or_469) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2016;
  assign select_2016 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:263
  logic select_2020;
  assign select_2020 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2264;
  assign equal_2264 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:451
  logic and_2265;
  assign and_2265 = and_498 & equal_2264;
  // hls/stages/agreement.hpp:510
  logic select_2268;
  assign select_2268 = (and_2265 | (~ends_cell_q)) ? and_2265 : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2268 ? (and_2265 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2272;
  assign select_2272 = select_2268 ? (and_2265 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2275;
  assign select_2275 = select_2268 ? (following_last_shift_q & (~and_2265)) : run_last_shift_q;
  // hls/stages/agreement.hpp:594
  logic and_2278;
  assign and_2278 = run_last_shift_q & equal_521;
  // hls/stages/agreement.hpp:603
  logic select_2280;
  assign select_2280 = equal_521 ? (~run_last_shift_q) : equal_523;
  // hls/stages/agreement.hpp:607
  logic equal_2281;
  assign equal_2281 = run_phase_q == 3'h1;
  logic not_2284;
  assign not_2284 = ~select_2280;
  // hls/stages/agreement.hpp:610
  logic equal_2286;
  assign equal_2286 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2287;
  assign and_2287 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2288;
  assign select_2288 = equal_2286 ? 2'h1 : {2{and_2287}};
  logic [2:0] select_2290;
  assign select_2290 = (and_2278 | (select_2280 | equal_2281)) ? (equal_2281 ? 3'h2 : {not_2284, {2{select_2280}}}) : (equal_518 ? 3'h6 : {select_2288[0], select_2288});
  // hls/stages/agreement.hpp:594
  logic and_2293;
  assign and_2293 = select_2280 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2296;
  assign select_2296 = (plan_shift_q[5] & select_2280) ? value : 7'h0;
  logic [1:0] or_2297;
  assign or_2297 = {2{so}} | select_2296[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] select_2298;
  assign select_2298 = select_2280 ? plan_columns_q : 8'h0;
  logic [6:0] or_2301;
  assign or_2301 = select_2298[6:0] | ((equal_2281 | equal_2286) ? whole_q : 7'h0);
  logic [1:0] or_2302;
  assign or_2302 = {2{and_2278}} | or_2301[3:2];
  // hls/stages/agreement.hpp:621
  logic [6:0] or_2304;
  assign or_2304 = {or_2301[6:4], or_2302, or_2301[1:0]} | (equal_518 ? drawn_q : 7'h0);
  logic [4:0] or_2305;
  assign or_2305 = {5{so}} | {or_2304[6], or_2304[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2309;
  assign not_2309 = ~run_shift_q[5];
  logic [6:0] difference_2311;
  assign difference_2311 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2312;
  assign select_2312 = equal_521 ? ({{7{not_2309}}, 1'b1} + run_span_q) : {difference_2311[6], difference_2311};
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2316;
  assign select_2316 = and_2265 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2318;
  assign select_2318 = select_2268 ? {select_2316[6], select_2316} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2321;
  assign select_2321 = select_2268 ? (and_2265 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:507
  logic [5:0] select_2329;
  assign select_2329 = and_498 ? (equal_2264 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2332;
  assign select_2332 = and_498 ? (equal_2264 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2335;
  assign select_2335 = and_498 ? (equal_2264 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2349;
  assign select_2349 = (ends_cell_q | select_2268) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_521 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2353;
  assign and_2353 = (~select_2268) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic [6:0] sum_2354;
  assign sum_2354 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:447
  logic select_2356;
  assign select_2356 = equal_2264 ? ({sum_2354[6], cfg_height_i[8:3]} == {1'b0, sum_2354[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:344
  logic or_2738;
  assign or_2738 = select_464[0] | select_557[5];
  logic [7:0] sum_2739;
  assign sum_2739 = {1'b0, select_464[2:1], or_2738, select_557[4:1]} + 8'h1;
  logic less_2740;
  assign less_2740 = {sum_2739, select_557[0], select_477, 1'b0} < {4'h0, cfg_height_i};

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1293; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 29'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_530;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:1294; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [76:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 77'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (or_519 ? not_527 : select_614);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:1295; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_521 ? sum_524[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_520 & select_614);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 46, DISTANCE 12, hls/stages/agreement.hpp:1296; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [45:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 46'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_519 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_640;
  logic [45:0] best_left_rdata_q;
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
      last_q <= 6'h0;
      least_q <= 6'h0;
      whole_q <= 7'h0;
      drawn_q <= 7'h0;
      age_q <= 7'h0;
      slot_q <= 3'h0;
      ends_cell_q <= 1'b1;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
    end else if (s0_en) begin
      left_first_q <= and_1840 ? left_first_q : marks_first_i;
      right_q <= (~and_1840) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1840;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_462 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2005;
      raster_at_column_q <= select_2007;
      raster_at_row_q <= select_2010;
      raster_at_live_q <= select_2014;
      raster_rows_left_q <= sample_pair_whole_q ? select_2016 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2020;
      averager_place_q <= sample_pair_whole_q ? select_468 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2272;
      run_last_shift_q <= select_2275;
      run_span_q <= select_2268 ? (and_2265 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2290;
      following_shift_q <= select_2280 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2293;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2296[6], or_2297, select_2296[3:0]};
      following_columns_q <= {select_2298[7], or_2305[4], or_2304[5:4], or_2305[3:0]};
      plan_shift_q <= equal_521 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2312;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2318;
      columns_left_q <= select_2321;
      last_q <= and_498 ? (equal_2264 ? column : last_q) : last_q;
      least_q <= select_2329;
      whole_q <= select_2332;
      drawn_q <= select_2335;
      age_q <= select_2268 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2268 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2349;
      ends_q <= and_2353;
      final_row_q <= and_498 ? select_2356 : final_row_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic sample_pair_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_present_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [5:0] last_s1_q;
  logic [3:0] age_s1_q;
  logic [2:0] slot_s1_q;
  logic ends_cell_s1_q;
  logic [2:0] select_462_s1_q;
  logic [5:0] select_464_s1_q;
  logic [7:0] select_468_s1_q;
  logic and_472_s1_q;
  logic equal_478_s1_q;
  logic [5:0] column_s1_q;
  logic and_496_s1_q;
  logic and_498_s1_q;
  logic so_s1_q;
  logic equal_518_s1_q;
  logic or_519_s1_q;
  logic equal_521_s1_q;
  logic less_526_s1_q;
  logic not_527_s1_q;
  logic and_530_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_640_s1_q;
  logic select_647_s1_q;
  logic and_1449_s1_q;
  logic [5:0] right_s1_q;
  logic select_1458_s1_q;
  logic equal_1467_s1_q;
  logic equal_1586_s1_q;
  logic equal_2264_s1_q;
  logic and_2265_s1_q;
  logic not_2741_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      sample_pair_first_s1_q <= sample_pair_first_q;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      sample_present_s1_q <= sample_present_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      last_s1_q <= last_q;
      age_s1_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s1_q <= slot_q;
      ends_cell_s1_q <= ends_cell_q;
      select_462_s1_q <= select_462;
      select_464_s1_q <= select_464;
      select_468_s1_q <= select_468;
      and_472_s1_q <= and_472;
      equal_478_s1_q <= select_477 == 3'h0;
      column_s1_q <= column;
      and_496_s1_q <= and_496;
      and_498_s1_q <= and_498;
      so_s1_q <= so;
      equal_518_s1_q <= equal_518;
      or_519_s1_q <= or_519;
      equal_521_s1_q <= equal_521;
      less_526_s1_q <= less_526;
      not_527_s1_q <= not_527;
      and_530_s1_q <= and_530;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_640_s1_q <= select_640;
      select_647_s1_q <= or_645 ? equal_643 : (~age_q[3]);
      and_1449_s1_q <= not_520 & and_639;
      right_s1_q <= right;
      select_1458_s1_q <= or_645 ? equal_643 : ({x[7:6], last_q} == {2'h0, x[5:0]});
      equal_1467_s1_q <= run_phase_q == 3'h7;
      equal_1586_s1_q <= {or_469, select_477} == 4'hc;
      equal_2264_s1_q <= equal_2264;
      and_2265_s1_q <= and_2265;
      not_2741_s1_q <= ~less_2740;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [5:0] row_q;
  logic lower_half_q;
  logic [5:0] sums_0_columns_values_0_q;
  logic [5:0] sums_0_columns_values_1_q;
  logic [5:0] sums_0_columns_values_2_q;
  logic [5:0] sums_0_columns_values_3_q;
  logic [5:0] sums_0_columns_values_4_q;
  logic [5:0] sums_0_columns_values_5_q;
  logic [5:0] sums_0_columns_values_6_q;
  logic [5:0] sums_0_columns_values_7_q;
  logic [5:0] sums_0_columns_values_8_q;
  logic [5:0] sums_0_columns_values_9_q;
  logic [5:0] sums_0_columns_values_10_q;
  logic [5:0] sums_0_columns_values_11_q;
  logic [5:0] sums_0_columns_values_12_q;
  logic [5:0] sums_0_columns_values_13_q;
  logic [5:0] sums_1_columns_values_0_q;
  logic [5:0] sums_1_columns_values_1_q;
  logic [5:0] sums_1_columns_values_2_q;
  logic [5:0] sums_1_columns_values_3_q;
  logic [5:0] sums_1_columns_values_4_q;
  logic [5:0] sums_1_columns_values_5_q;
  logic [5:0] sums_1_columns_values_6_q;
  logic [5:0] sums_1_columns_values_7_q;
  logic [5:0] sums_1_columns_values_8_q;
  logic [5:0] sums_1_columns_values_9_q;
  logic [5:0] sums_1_columns_values_10_q;
  logic [5:0] sums_1_columns_values_11_q;
  logic [5:0] sums_1_columns_values_12_q;
  logic [5:0] sums_1_columns_values_13_q;
  logic [3:0] patches_phase_q;
  logic [3:0] patches_band_rows_rows_to_next_q;
  logic [4:0] patches_band_rows_number_q;
  logic [3:0] patches_next_band_rows_to_next_q;
  logic [4:0] patches_next_band_number_q;
  logic [3:0] patches_first_band_rows_to_next_q;
  logic patches_first_band_number_q;
  logic [3:0] patches_choosing_rows_to_next_q;
  logic [4:0] patches_choosing_number_q;
  logic patches_chooses_q;
  logic [4:0] patches_choosing_band_q;
  logic patches_capturing_q;
  logic patches_lower_q;
  logic [4:0] patches_row_q;
  logic [2:0] patches_work_q;
  logic patches_second_q;
  logic [2:0] patches_following_q;
  logic [4:0] patches_following_beats_q;
  logic patches_begins_q;
  logic patches_ends_q;
  logic [11:0] patches_remaining_q;
  logic [4:0] patches_code_row_q;
  logic [4:0] patches_column_q;
  logic patches_column_ends_q;
  // hls/stages/agreement.hpp:653
  logic not_618;
  assign not_618 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:656
  logic and_619;
  assign and_619 = left_rdata_q[12] & not_618;
  logic and_620;
  assign and_620 = left_rdata_q[28] & not_618;
  logic and_621;
  assign and_621 = left_rdata_q[44] & not_618;
  logic and_622;
  assign and_622 = left_rdata_q[60] & not_618;
  // hls/stages/agreement.hpp:657
  logic and_626;
  assign and_626 = right_codes_rdata_q[12] & not_618;
  logic and_627;
  assign and_627 = right_codes_rdata_q[25] & not_618;
  logic and_628;
  assign and_628 = right_codes_rdata_q[38] & not_618;
  logic and_629;
  assign and_629 = right_codes_rdata_q[51] & not_618;
  logic and_630;
  assign and_630 = right_codes_rdata_q[64] & not_618;
  logic and_631;
  assign and_631 = right_codes_rdata_q[77] & not_618;
  // hls/stages/agreement.hpp:212
  logic and_653;
  assign and_653 = left_rdata_q[44] & not_527_s1_q;
  logic and_654;
  assign and_654 = right_codes_rdata_q[38] & not_527_s1_q;
  logic [11:0] select_655;
  assign select_655 = less_526_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_656;
  assign select_656 = less_526_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_660;
  assign select_660 = and_653 ? (and_654 ? (~(select_655 ^ select_656)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_666;
  assign parity_666 = ^select_660[5:3];
  logic parity_669;
  assign parity_669 = ^select_660[8:6];
  logic parity_672;
  assign parity_672 = ^select_660[11:3];
  // hls/stages/agreement.hpp:212
  logic and_676;
  assign and_676 = left_rdata_q[60] & not_527_s1_q;
  logic and_677;
  assign and_677 = right_codes_rdata_q[51] & not_527_s1_q;
  logic [11:0] select_678;
  assign select_678 = less_526_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_679;
  assign select_679 = less_526_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_683;
  assign select_683 = and_676 ? (and_677 ? (~(select_678 ^ select_679)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_686;
  assign parity_686 = ^select_683[8:6];
  logic parity_689;
  assign parity_689 = ^select_683[11:9];
  // hls/stages/agreement.hpp:212
  logic and_693;
  assign and_693 = left_rdata_q[76] & not_527_s1_q;
  logic and_694;
  assign and_694 = right_codes_rdata_q[64] & not_527_s1_q;
  logic [11:0] select_695;
  assign select_695 = less_526_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_696;
  assign select_696 = less_526_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_700;
  assign select_700 = and_693 ? (and_694 ? (~(select_695 ^ select_696)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_706;
  assign parity_706 = ^select_700[2:0];
  logic parity_709;
  assign parity_709 = ^select_700[5:3];
  logic parity_712;
  assign parity_712 = ^select_700[8:0];
  logic parity_718;
  assign parity_718 = ^select_700[11:9];
  logic parity_721;
  assign parity_721 = ^select_683[2:0];
  logic parity_724;
  assign parity_724 = ^{select_700[11:9], select_683[5:0]};
  logic parity_727;
  assign parity_727 = ^{select_700, select_683, select_660[2:0]};
  logic xor_728;
  assign xor_728 = parity_672 ^ parity_727;
  // hls/stages/count_bits.hpp:23
  logic or_732;
  assign or_732 = (select_660[1:0] == 2'h3) | (select_660[2] & (select_660[0] | select_660[1]));
  // hls/stages/count_bits.hpp:25
  logic or_736;
  assign or_736 = (select_683[7:6] == 2'h3) | (select_683[8] & (select_683[6] | select_683[7]));
  logic or_740;
  assign or_740 = (select_683[10:9] == 2'h3) | (select_683[11] & (select_683[9] | select_683[10]));
  // hls/stages/count_bits.hpp:23
  logic or_748;
  assign or_748 = (select_700[7:6] == 2'h3) | (select_700[8] & (~(select_700[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_752;
  assign or_752 = (select_700[1:0] == 2'h3) | (select_700[2] & (select_700[0] | select_700[1]));
  logic or_756;
  assign or_756 = (select_700[4:3] == 2'h3) | (select_700[5] & (select_700[3] | select_700[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_759;
  assign parity_759 = ^{or_756, or_752, or_748};
  // hls/stages/count_bits.hpp:23
  logic or_763;
  assign or_763 = (select_683[4:3] == 2'h3) | (select_683[5] & (select_683[3] | select_683[4]));
  // hls/stages/count_bits.hpp:25
  logic or_767;
  assign or_767 = (select_700[10:9] == 2'h3) | (select_700[11] & (select_700[9] | select_700[10]));
  logic or_771;
  assign or_771 = (select_683[1:0] == 2'h3) | (select_683[2] & (select_683[0] | select_683[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_774;
  assign parity_774 = ^{or_771, or_767, or_763};
  logic parity_777;
  assign parity_777 = ^{or_771, or_767, or_763, or_756, or_752, or_748, or_740, or_736, or_732};
  // hls/stages/count_bits.hpp:25
  logic and_778;
  assign and_778 = parity_672 & parity_727;
  logic or_782;
  assign or_782 = (parity_666 & parity_669) | ((^select_660[11:9]) & (parity_666 | parity_669));
  logic and_785;
  assign and_785 = (^{select_683[11:6], select_660[2:0]}) & (parity_712 | parity_724);
  logic or_786;
  assign or_786 = (parity_712 & parity_724) | and_785;
  // hls/stages/count_bits.hpp:23
  logic or_793;
  assign or_793 = (select_660[10:9] == 2'h3) | (select_660[11] & (select_660[9] | select_660[10]));
  // hls/stages/count_bits.hpp:25
  logic or_797;
  assign or_797 = (select_660[4:3] == 2'h3) | (select_660[5] & (select_660[3] | select_660[4]));
  logic or_801;
  assign or_801 = (select_660[7:6] == 2'h3) | (select_660[8] & (select_660[6] | select_660[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_804;
  assign parity_804 = ^{or_801, or_797, or_793};
  // hls/stages/count_bits.hpp:25
  logic or_808;
  assign or_808 = (parity_686 & parity_689) | ((^select_660[2:0]) & (parity_686 | parity_689));
  logic or_812;
  assign or_812 = (parity_706 & parity_709) | ((^select_700[8:6]) & (parity_706 | parity_709));
  logic or_816;
  assign or_816 = (parity_718 & parity_721) | ((^select_683[5:3]) & (parity_718 | parity_721));
  // hls/stages/count_bits.hpp:24
  logic parity_819;
  assign parity_819 = ^{or_816, or_812, or_808};
  logic parity_822;
  assign parity_822 = ^{or_816, or_812, or_808, or_801, or_797, or_793, or_786, or_782, and_778};
  logic xor_823;
  assign xor_823 = parity_777 ^ parity_822;
  // hls/stages/count_bits.hpp:25
  logic and_824;
  assign and_824 = parity_777 & parity_822;
  logic or_828;
  assign or_828 = (parity_759 & parity_774) | ((^{or_740, or_736, or_732}) & (parity_759 | parity_774));
  logic or_832;
  assign or_832 = (parity_804 & parity_819) | ((^{or_786, or_782, and_778}) & (parity_804 | parity_819));
  logic or_839;
  assign or_839 = (or_736 & or_740) | (or_732 & (or_736 | or_740));
  logic or_843;
  assign or_843 = (or_752 & or_756) | (or_748 & (or_752 | or_756));
  logic or_847;
  assign or_847 = (or_767 & or_771) | (or_763 & (or_767 | or_771));
  // hls/stages/count_bits.hpp:24
  logic parity_850;
  assign parity_850 = ^{or_847, or_843, or_839};
  // hls/stages/count_bits.hpp:25
  logic or_854;
  assign or_854 = (or_782 & or_786) | (and_778 & (or_782 | or_786));
  logic or_858;
  assign or_858 = (or_797 & or_801) | (or_793 & (or_797 | or_801));
  logic or_862;
  assign or_862 = (or_812 & or_816) | (or_808 & (or_812 | or_816));
  // hls/stages/count_bits.hpp:24
  logic parity_865;
  assign parity_865 = ^{or_862, or_858, or_854};
  logic parity_868;
  assign parity_868 = ^{or_862, or_858, or_854, or_847, or_843, or_839, or_832, or_828, and_824};
  // hls/stages/count_bits.hpp:25
  logic or_872;
  assign or_872 = (parity_850 & parity_865) | ((^{or_832, or_828, and_824}) & (parity_850 | parity_865));
  logic or_876;
  assign or_876 = (or_828 & or_832) | (and_824 & (or_828 | or_832));
  logic or_880;
  assign or_880 = (or_843 & or_847) | (or_839 & (or_843 | or_847));
  logic or_884;
  assign or_884 = (or_858 & or_862) | (or_854 & (or_858 | or_862));
  // hls/stages/count_bits.hpp:24
  logic parity_889;
  assign parity_889 = ^{or_884, or_880, or_876, or_872};
  // hls/stages/count_bits.hpp:25
  logic or_893;
  assign or_893 = (or_880 & or_884) | (or_876 & (or_880 | or_884));
  logic and_894;
  assign and_894 = or_872 & (^{or_884, or_880, or_876});
  // hls/stages/count_bits.hpp:24
  logic xor_895;
  assign xor_895 = or_893 ^ and_894;
  // hls/stages/count_bits.hpp:27
  logic and_896;
  assign and_896 = or_893 & and_894;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_897;
  assign select_897 = equal_521_s1_q ? {and_896, xor_895, parity_889, parity_868, xor_823, xor_728} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_519_s1_q ? 6'h0 : select_897;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_908;
  assign select_908 = (slot_s1_q[0] ? and_694 : and_677) ? (~(select_656 ^ (slot_s1_q[0] ? select_695 : select_678))) : 12'h0;
  logic [11:0] select_909;
  assign select_909 = and_653 ? select_908 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_915;
  assign parity_915 = ^select_909[5:3];
  logic parity_918;
  assign parity_918 = ^select_909[8:6];
  logic parity_921;
  assign parity_921 = ^select_909[11:3];
  // hls/stages/agreement.hpp:212
  logic and_925;
  assign and_925 = right_codes_rdata_q[77] & not_527_s1_q;
  logic [11:0] select_927;
  assign select_927 = less_526_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_931;
  assign select_931 = (slot_s1_q[0] ? and_925 : and_694) ? (~(select_679 ^ (slot_s1_q[0] ? select_927 : select_695))) : 12'h0;
  logic [11:0] select_932;
  assign select_932 = and_676 ? select_931 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_935;
  assign parity_935 = ^select_932[8:6];
  logic parity_938;
  assign parity_938 = ^select_932[11:9];
  // hls/stages/agreement.hpp:718
  logic select_943;
  assign select_943 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_527_s1_q) : and_925;
  logic [11:0] select_945;
  assign select_945 = slot_s1_q[0] ? (less_526_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_927;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_949;
  assign select_949 = and_693 ? (select_943 ? (~(select_696 ^ select_945)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_955;
  assign parity_955 = ^select_949[2:0];
  logic parity_958;
  assign parity_958 = ^select_949[5:3];
  logic parity_961;
  assign parity_961 = ^select_949[8:0];
  logic parity_967;
  assign parity_967 = ^select_949[11:9];
  logic parity_970;
  assign parity_970 = ^select_932[2:0];
  logic parity_973;
  assign parity_973 = ^{select_949[11:9], select_932[5:0]};
  logic parity_976;
  assign parity_976 = ^{select_949, select_932, select_909[2:0]};
  logic xor_977;
  assign xor_977 = parity_921 ^ parity_976;
  // hls/stages/count_bits.hpp:23
  logic or_981;
  assign or_981 = (select_909[1:0] == 2'h3) | (select_909[2] & (select_909[0] | select_909[1]));
  // hls/stages/count_bits.hpp:25
  logic or_985;
  assign or_985 = (select_932[7:6] == 2'h3) | (select_932[8] & (select_932[6] | select_932[7]));
  logic or_989;
  assign or_989 = (select_932[10:9] == 2'h3) | (select_932[11] & (select_932[9] | select_932[10]));
  // hls/stages/count_bits.hpp:23
  logic or_997;
  assign or_997 = (select_949[7:6] == 2'h3) | (select_949[8] & (~(select_949[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1001;
  assign or_1001 = (select_949[1:0] == 2'h3) | (select_949[2] & (select_949[0] | select_949[1]));
  logic or_1005;
  assign or_1005 = (select_949[4:3] == 2'h3) | (select_949[5] & (select_949[3] | select_949[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1008;
  assign parity_1008 = ^{or_1005, or_1001, or_997};
  // hls/stages/count_bits.hpp:23
  logic or_1012;
  assign or_1012 = (select_932[4:3] == 2'h3) | (select_932[5] & (select_932[3] | select_932[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1016;
  assign or_1016 = (select_949[10:9] == 2'h3) | (select_949[11] & (select_949[9] | select_949[10]));
  logic or_1020;
  assign or_1020 = (select_932[1:0] == 2'h3) | (select_932[2] & (select_932[0] | select_932[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1023;
  assign parity_1023 = ^{or_1020, or_1016, or_1012};
  logic parity_1026;
  assign parity_1026 = ^{or_1020, or_1016, or_1012, or_1005, or_1001, or_997, or_989, or_985, or_981};
  // hls/stages/count_bits.hpp:25
  logic and_1027;
  assign and_1027 = parity_921 & parity_976;
  logic or_1031;
  assign or_1031 = (parity_915 & parity_918) | ((^select_909[11:9]) & (parity_915 | parity_918));
  logic and_1034;
  assign and_1034 = (^{select_932[11:6], select_909[2:0]}) & (parity_961 | parity_973);
  logic or_1035;
  assign or_1035 = (parity_961 & parity_973) | and_1034;
  // hls/stages/count_bits.hpp:23
  logic or_1042;
  assign or_1042 = (select_909[10:9] == 2'h3) | (select_909[11] & (select_909[9] | select_909[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1046;
  assign or_1046 = (select_909[4:3] == 2'h3) | (select_909[5] & (select_909[3] | select_909[4]));
  logic or_1050;
  assign or_1050 = (select_909[7:6] == 2'h3) | (select_909[8] & (select_909[6] | select_909[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1053;
  assign parity_1053 = ^{or_1050, or_1046, or_1042};
  // hls/stages/count_bits.hpp:25
  logic or_1057;
  assign or_1057 = (parity_935 & parity_938) | ((^select_909[2:0]) & (parity_935 | parity_938));
  logic or_1061;
  assign or_1061 = (parity_955 & parity_958) | ((^select_949[8:6]) & (parity_955 | parity_958));
  logic or_1065;
  assign or_1065 = (parity_967 & parity_970) | ((^select_932[5:3]) & (parity_967 | parity_970));
  // hls/stages/count_bits.hpp:24
  logic parity_1068;
  assign parity_1068 = ^{or_1065, or_1061, or_1057};
  logic parity_1071;
  assign parity_1071 = ^{or_1065, or_1061, or_1057, or_1050, or_1046, or_1042, or_1035, or_1031, and_1027};
  logic xor_1072;
  assign xor_1072 = parity_1026 ^ parity_1071;
  // hls/stages/count_bits.hpp:25
  logic and_1073;
  assign and_1073 = parity_1026 & parity_1071;
  logic or_1077;
  assign or_1077 = (parity_1008 & parity_1023) | ((^{or_989, or_985, or_981}) & (parity_1008 | parity_1023));
  logic or_1081;
  assign or_1081 = (parity_1053 & parity_1068) | ((^{or_1035, or_1031, and_1027}) & (parity_1053 | parity_1068));
  logic or_1088;
  assign or_1088 = (or_985 & or_989) | (or_981 & (or_985 | or_989));
  logic or_1092;
  assign or_1092 = (or_1001 & or_1005) | (or_997 & (or_1001 | or_1005));
  logic or_1096;
  assign or_1096 = (or_1016 & or_1020) | (or_1012 & (or_1016 | or_1020));
  // hls/stages/count_bits.hpp:24
  logic parity_1099;
  assign parity_1099 = ^{or_1096, or_1092, or_1088};
  // hls/stages/count_bits.hpp:25
  logic or_1103;
  assign or_1103 = (or_1031 & or_1035) | (and_1027 & (or_1031 | or_1035));
  logic or_1107;
  assign or_1107 = (or_1046 & or_1050) | (or_1042 & (or_1046 | or_1050));
  logic or_1111;
  assign or_1111 = (or_1061 & or_1065) | (or_1057 & (or_1061 | or_1065));
  // hls/stages/count_bits.hpp:24
  logic parity_1114;
  assign parity_1114 = ^{or_1111, or_1107, or_1103};
  logic parity_1117;
  assign parity_1117 = ^{or_1111, or_1107, or_1103, or_1096, or_1092, or_1088, or_1081, or_1077, and_1073};
  // hls/stages/count_bits.hpp:25
  logic or_1121;
  assign or_1121 = (parity_1099 & parity_1114) | ((^{or_1081, or_1077, and_1073}) & (parity_1099 | parity_1114));
  logic or_1125;
  assign or_1125 = (or_1077 & or_1081) | (and_1073 & (or_1077 | or_1081));
  logic or_1129;
  assign or_1129 = (or_1092 & or_1096) | (or_1088 & (or_1092 | or_1096));
  logic or_1133;
  assign or_1133 = (or_1107 & or_1111) | (or_1103 & (or_1107 | or_1111));
  // hls/stages/count_bits.hpp:24
  logic parity_1138;
  assign parity_1138 = ^{or_1133, or_1129, or_1125, or_1121};
  // hls/stages/count_bits.hpp:25
  logic or_1142;
  assign or_1142 = (or_1129 & or_1133) | (or_1125 & (or_1129 | or_1133));
  logic and_1143;
  assign and_1143 = or_1121 & (^{or_1133, or_1129, or_1125});
  // hls/stages/count_bits.hpp:24
  logic xor_1144;
  assign xor_1144 = or_1142 ^ and_1143;
  // hls/stages/count_bits.hpp:27
  logic and_1145;
  assign and_1145 = or_1142 & and_1143;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1146;
  assign select_1146 = equal_521_s1_q ? {and_1145, xor_1144, parity_1138, parity_1117, xor_1072, xor_977} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_519_s1_q ? 6'h0 : select_1146;
  // hls/stages/agreement.hpp:212
  logic and_1154;
  assign and_1154 = right_codes_rdata_q[25] & not_527_s1_q;
  // hls/stages/agreement.hpp:718
  logic select_1155;
  assign select_1155 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_527_s1_q) : and_1154;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1157;
  assign select_1157 = less_526_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:718
  logic [11:0] select_1158;
  assign select_1158 = slot_s1_q[0] ? (less_526_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1157;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1162;
  assign select_1162 = and_653 ? (select_1155 ? (~(select_656 ^ select_1158)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1168;
  assign parity_1168 = ^select_1162[5:3];
  logic parity_1171;
  assign parity_1171 = ^select_1162[8:6];
  logic parity_1174;
  assign parity_1174 = ^select_1162[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1182;
  assign select_1182 = (slot_s1_q[0] ? and_1154 : and_654) ? (~(select_679 ^ (slot_s1_q[0] ? select_1157 : select_655))) : 12'h0;
  logic [11:0] select_1183;
  assign select_1183 = and_676 ? select_1182 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1186;
  assign parity_1186 = ^select_1183[8:6];
  logic parity_1189;
  assign parity_1189 = ^select_1183[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1197;
  assign select_1197 = (slot_s1_q[0] ? and_654 : and_677) ? (~(select_696 ^ (slot_s1_q[0] ? select_655 : select_678))) : 12'h0;
  logic [11:0] select_1198;
  assign select_1198 = and_693 ? select_1197 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1204;
  assign parity_1204 = ^select_1198[2:0];
  logic parity_1207;
  assign parity_1207 = ^select_1198[5:3];
  logic parity_1210;
  assign parity_1210 = ^select_1198[8:0];
  logic parity_1216;
  assign parity_1216 = ^select_1198[11:9];
  logic parity_1219;
  assign parity_1219 = ^select_1183[2:0];
  logic parity_1222;
  assign parity_1222 = ^{select_1198[11:9], select_1183[5:0]};
  logic parity_1225;
  assign parity_1225 = ^{select_1198, select_1183, select_1162[2:0]};
  logic xor_1226;
  assign xor_1226 = parity_1174 ^ parity_1225;
  // hls/stages/count_bits.hpp:23
  logic or_1230;
  assign or_1230 = (select_1162[1:0] == 2'h3) | (select_1162[2] & (select_1162[0] | select_1162[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1234;
  assign or_1234 = (select_1183[7:6] == 2'h3) | (select_1183[8] & (select_1183[6] | select_1183[7]));
  logic or_1238;
  assign or_1238 = (select_1183[10:9] == 2'h3) | (select_1183[11] & (select_1183[9] | select_1183[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1246;
  assign or_1246 = (select_1198[7:6] == 2'h3) | (select_1198[8] & (~(select_1198[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1250;
  assign or_1250 = (select_1198[1:0] == 2'h3) | (select_1198[2] & (select_1198[0] | select_1198[1]));
  logic or_1254;
  assign or_1254 = (select_1198[4:3] == 2'h3) | (select_1198[5] & (select_1198[3] | select_1198[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1257;
  assign parity_1257 = ^{or_1254, or_1250, or_1246};
  // hls/stages/count_bits.hpp:23
  logic or_1261;
  assign or_1261 = (select_1183[4:3] == 2'h3) | (select_1183[5] & (select_1183[3] | select_1183[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1265;
  assign or_1265 = (select_1198[10:9] == 2'h3) | (select_1198[11] & (select_1198[9] | select_1198[10]));
  logic or_1269;
  assign or_1269 = (select_1183[1:0] == 2'h3) | (select_1183[2] & (select_1183[0] | select_1183[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1272;
  assign parity_1272 = ^{or_1269, or_1265, or_1261};
  logic parity_1275;
  assign parity_1275 = ^{or_1269, or_1265, or_1261, or_1254, or_1250, or_1246, or_1238, or_1234, or_1230};
  // hls/stages/count_bits.hpp:25
  logic and_1276;
  assign and_1276 = parity_1174 & parity_1225;
  logic or_1280;
  assign or_1280 = (parity_1168 & parity_1171) | ((^select_1162[11:9]) & (parity_1168 | parity_1171));
  logic and_1283;
  assign and_1283 = (^{select_1183[11:6], select_1162[2:0]}) & (parity_1210 | parity_1222);
  logic or_1284;
  assign or_1284 = (parity_1210 & parity_1222) | and_1283;
  // hls/stages/count_bits.hpp:23
  logic or_1291;
  assign or_1291 = (select_1162[10:9] == 2'h3) | (select_1162[11] & (select_1162[9] | select_1162[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1295;
  assign or_1295 = (select_1162[4:3] == 2'h3) | (select_1162[5] & (select_1162[3] | select_1162[4]));
  logic or_1299;
  assign or_1299 = (select_1162[7:6] == 2'h3) | (select_1162[8] & (select_1162[6] | select_1162[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1302;
  assign parity_1302 = ^{or_1299, or_1295, or_1291};
  // hls/stages/count_bits.hpp:25
  logic or_1306;
  assign or_1306 = (parity_1186 & parity_1189) | ((^select_1162[2:0]) & (parity_1186 | parity_1189));
  logic or_1310;
  assign or_1310 = (parity_1204 & parity_1207) | ((^select_1198[8:6]) & (parity_1204 | parity_1207));
  logic or_1314;
  assign or_1314 = (parity_1216 & parity_1219) | ((^select_1183[5:3]) & (parity_1216 | parity_1219));
  // hls/stages/count_bits.hpp:24
  logic parity_1317;
  assign parity_1317 = ^{or_1314, or_1310, or_1306};
  logic parity_1320;
  assign parity_1320 = ^{or_1314, or_1310, or_1306, or_1299, or_1295, or_1291, or_1284, or_1280, and_1276};
  logic xor_1321;
  assign xor_1321 = parity_1275 ^ parity_1320;
  // hls/stages/count_bits.hpp:25
  logic and_1322;
  assign and_1322 = parity_1275 & parity_1320;
  logic or_1326;
  assign or_1326 = (parity_1257 & parity_1272) | ((^{or_1238, or_1234, or_1230}) & (parity_1257 | parity_1272));
  logic or_1330;
  assign or_1330 = (parity_1302 & parity_1317) | ((^{or_1284, or_1280, and_1276}) & (parity_1302 | parity_1317));
  logic or_1337;
  assign or_1337 = (or_1234 & or_1238) | (or_1230 & (or_1234 | or_1238));
  logic or_1341;
  assign or_1341 = (or_1250 & or_1254) | (or_1246 & (or_1250 | or_1254));
  logic or_1345;
  assign or_1345 = (or_1265 & or_1269) | (or_1261 & (or_1265 | or_1269));
  // hls/stages/count_bits.hpp:24
  logic parity_1348;
  assign parity_1348 = ^{or_1345, or_1341, or_1337};
  // hls/stages/count_bits.hpp:25
  logic or_1352;
  assign or_1352 = (or_1280 & or_1284) | (and_1276 & (or_1280 | or_1284));
  logic or_1356;
  assign or_1356 = (or_1295 & or_1299) | (or_1291 & (or_1295 | or_1299));
  logic or_1360;
  assign or_1360 = (or_1310 & or_1314) | (or_1306 & (or_1310 | or_1314));
  // hls/stages/count_bits.hpp:24
  logic parity_1363;
  assign parity_1363 = ^{or_1360, or_1356, or_1352};
  logic parity_1366;
  assign parity_1366 = ^{or_1360, or_1356, or_1352, or_1345, or_1341, or_1337, or_1330, or_1326, and_1322};
  // hls/stages/count_bits.hpp:25
  logic or_1370;
  assign or_1370 = (parity_1348 & parity_1363) | ((^{or_1330, or_1326, and_1322}) & (parity_1348 | parity_1363));
  logic or_1374;
  assign or_1374 = (or_1326 & or_1330) | (and_1322 & (or_1326 | or_1330));
  logic or_1378;
  assign or_1378 = (or_1341 & or_1345) | (or_1337 & (or_1341 | or_1345));
  logic or_1382;
  assign or_1382 = (or_1356 & or_1360) | (or_1352 & (or_1356 | or_1360));
  // hls/stages/count_bits.hpp:24
  logic parity_1387;
  assign parity_1387 = ^{or_1382, or_1378, or_1374, or_1370};
  // hls/stages/count_bits.hpp:25
  logic or_1391;
  assign or_1391 = (or_1378 & or_1382) | (or_1374 & (or_1378 | or_1382));
  logic and_1392;
  assign and_1392 = or_1370 & (^{or_1382, or_1378, or_1374});
  // hls/stages/count_bits.hpp:24
  logic xor_1393;
  assign xor_1393 = or_1391 ^ and_1392;
  // hls/stages/count_bits.hpp:27
  logic and_1394;
  assign and_1394 = or_1391 & and_1392;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1395;
  assign select_1395 = equal_521_s1_q ? {and_1394, xor_1393, parity_1387, parity_1366, xor_1321, xor_1226} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_519_s1_q ? 6'h0 : select_1395;
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:929
  logic [5:0] select_1453;
  assign select_1453 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:932
  logic and_1473;
  assign and_1473 = (or_519_s1_q & (left_rdata_q[61] & not_527_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1495;
  assign or_1495 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/patches.hpp:313
  logic [5:0] select_1506;
  assign select_1506 = so_s1_q ? x_s1_q[5:0] : (or_519_s1_q ? (less_526_s1_q ? 6'h0 : select_1453) : 6'h0);
  // hls/stages/patches.hpp:99
  logic and_1580;
  assign and_1580 = (select_462_s1_q == 3'h0) & (select_464_s1_q == 6'h0);
  // hls/stages/patches.hpp:365
  logic not_1581;
  assign not_1581 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_1584;
  assign not_1584 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:335
  logic and_1585;
  assign and_1585 = patches_capturing_q & not_1584;
  // hls/stages/patches.hpp:285
  logic equal_1588;
  assign equal_1588 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:102
  logic and_1593;
  assign and_1593 = (not_1581 & (patches_work_q == 3'h0)) & (~(and_1585 | ((~equal_1586_s1_q) | (~equal_1588))));
  // hls/stages/patches.hpp:473
  logic equal_1680;
  assign equal_1680 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:454
  logic not_1681;
  assign not_1681 = ~equal_1680;
  // hls/stages/patches.hpp:473
  logic equal_1682;
  assign equal_1682 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:420
  logic not_1683;
  assign not_1683 = ~equal_1682;
  // hls/stages/patches.hpp:143
  logic equal_1684;
  assign equal_1684 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:473
  logic equal_1685;
  assign equal_1685 = patches_work_q == 3'h2;
  logic or_1686;
  assign or_1686 = equal_1684 | equal_1685;
  // hls/stages/patches.hpp:422
  logic not_1687;
  assign not_1687 = ~patches_second_q;
  // hls/stages/patches.hpp:346
  logic [4:0] select_1709;
  assign select_1709 = and_1593 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:103
  logic [4:0] select_1710;
  assign select_1710 = and_1580 ? select_1709 : patches_row_q;
  // hls/stages/patches.hpp:102
  logic and_1712;
  assign and_1712 = and_1585 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:103
  logic select_1716;
  assign select_1716 = and_1580 ? (and_1593 | (and_1585 & (~and_1712))) : patches_capturing_q;
  // hls/stages/patches.hpp:160
  logic and_1724;
  assign and_1724 = not_1681 & (not_1683 & (or_1686 & (patches_second_q & equal_1684)));
  // hls/stages/patches.hpp:143
  logic not_1741;
  assign not_1741 = ~equal_1684;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1757;
  assign select_1757 = and_1580 ? {select_1709[4], select_1709[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:420
  logic and_1767;
  assign and_1767 = not_1681 & (or_1686 & not_1683);
  // hls/stages/agreement.hpp:447
  logic select_2361;
  assign select_2361 = equal_2264_s1_q ? (~({row_s1_q, 1'b0} < {sum_2358, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2566;
  assign and_2566 = and_498_s1_q & (equal_2264_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:291
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:103
  logic [3:0] select_2676;
  assign select_2676 = and_1580 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2677;
  assign select_2677 = sample_pair_whole_s1_q ? select_2676 : patches_phase_q;
  // hls/stages/patches.hpp:346
  logic and_2678;
  assign and_2678 = not_1584 & equal_1586_s1_q;
  logic [8:0] select_2679;
  assign select_2679 = and_2678 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2680;
  assign select_2680 = and_2678 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2681;
  assign select_2681 = sample_pair_first_s1_q ? select_2679 : select_2680;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2683;
  assign select_2683 = sample_pair_whole_s1_q ? (and_1580 ? select_2681[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2685;
  assign select_2685 = sample_pair_whole_s1_q ? (and_1580 ? select_2681[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2688;
  assign select_2688 = sample_pair_whole_s1_q ? (equal_1588 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2690;
  assign select_2690 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_1588}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:304
  logic equal_2691;
  assign equal_2691 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:305
  logic not_2692;
  assign not_2692 = ~equal_2691;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2694;
  assign select_2694 = sample_pair_whole_s1_q ? (phase + {not_2692, 1'b1, not_2692, equal_2691}) : patches_first_band_rows_to_next_q;
  logic select_2695;
  assign select_2695 = sample_pair_whole_s1_q ? equal_2691 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:457
  logic equal_2696;
  assign equal_2696 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:64
  logic [3:0] select_2700;
  assign select_2700 = equal_2696 ? ((select_2677 == 4'h6) ? 4'h0 : (select_2677 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2701;
  assign equal_2701 = select_2700 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_2704;
  assign select_2704 = equal_2264_s1_q ? (equal_2701 ? 4'h6 : (select_2700 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:64
  logic [4:0] select_2706;
  assign select_2706 = equal_2696 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_2708;
  assign select_2708 = equal_2264_s1_q ? (select_2706 + {4'h0, equal_2701}) : patches_choosing_number_q;
  logic select_2712;
  assign select_2712 = equal_2264_s1_q ? ((6'h2 < row_s1_q) & equal_2701) : patches_chooses_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_2715;
  assign select_2715 = and_498_s1_q ? (equal_2264_s1_q ? select_2706 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:103
  logic select_2743;
  assign select_2743 = and_1580 ? (and_1593 ? not_2741_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:366
  logic or_2782;
  assign or_2782 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:368
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:163
  logic and_2788;
  assign and_2788 = equal_1680 & not_1687;
  // hls/stages/patches.hpp:372
  logic and_2789;
  assign and_2789 = not_1741 & and_2788;
  logic [1:0] select_2791;
  assign select_2791 = equal_1682 ? 2'h0 : (equal_1685 ? 2'h3 : {equal_1684, and_2789});
  // hls/stages/patches.hpp:253
  logic equal_2793;
  assign equal_2793 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:251
  logic not_2794;
  assign not_2794 = ~equal_2793;
  // hls/stages/patches.hpp:253
  logic equal_2795;
  assign equal_2795 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:249
  logic not_2796;
  assign not_2796 = ~equal_2795;
  // hls/stages/patches.hpp:257
  logic not_2798;
  assign not_2798 = ~(patches_following_q == 3'h2);
  logic and_2801;
  assign and_2801 = (~(patches_following_q == 3'h1)) & not_2798;
  // hls/stages/patches.hpp:370
  logic [1:0] select_2802;
  assign select_2802 = equal_2795 ? 2'h2 : {and_2801, not_2798};
  logic [3:0] select_2803;
  assign select_2803 = equal_2793 ? 4'h2 : {select_2802, {2{not_2796}}};
  // hls/stages/patches.hpp:378
  logic not_2806;
  assign not_2806 = ~or_2782;
  // hls/stages/patches.hpp:367
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:379
  logic [11:0] select_2811;
  assign select_2811 = or_2782 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:163
  logic [4:0] select_2813;
  assign select_2813 = or_2782 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1297; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_519_s1_q ? select_1453 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_640_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:697; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s1_en & (not_1681 & (not_1683 & (or_1686 & (equal_1684 & not_1687))));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:697; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s1_en & and_1724;
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:698; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s1_en & (not_1681 & (not_1683 & (not_1741 & or_1686)));
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:709; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 32'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s1_en & and_1767;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_530_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_622, left_rdata_q[59:45], and_621, left_rdata_q[43:29], and_620, left_rdata_q[27:13], and_619, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_530_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_631, right_codes_rdata_q[76:65], and_630, right_codes_rdata_q[63:52], and_629, right_codes_rdata_q[50:39], and_628, right_codes_rdata_q[37:26], and_627, right_codes_rdata_q[24:13], and_626, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      patches_phase_q <= 4'h0;
      patches_band_rows_rows_to_next_q <= 4'h0;
      patches_band_rows_number_q <= 5'h0;
      patches_next_band_rows_to_next_q <= 4'h0;
      patches_next_band_number_q <= 5'h0;
      patches_first_band_rows_to_next_q <= 4'h0;
      patches_first_band_number_q <= 1'b0;
      patches_choosing_rows_to_next_q <= 4'h0;
      patches_choosing_number_q <= 5'h0;
      patches_chooses_q <= 1'b0;
      patches_choosing_band_q <= 5'h0;
      patches_capturing_q <= 1'b0;
      patches_lower_q <= 1'b0;
      patches_row_q <= 5'h0;
      patches_work_q <= 3'h0;
      patches_second_q <= 1'b0;
      patches_following_q <= 3'h0;
      patches_following_beats_q <= 5'h0;
      patches_begins_q <= 1'b0;
      patches_ends_q <= 1'b0;
      patches_remaining_q <= 12'h0;
      patches_code_row_q <= 5'h0;
      patches_column_q <= 5'h0;
      patches_column_ends_q <= 1'b0;
    end else if (s1_en) begin
      row_q <= and_498_s1_q ? (equal_2264_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_498_s1_q ? select_2361 : lower_half_q;
      patches_phase_q <= select_2677;
      patches_band_rows_rows_to_next_q <= select_2683;
      patches_band_rows_number_q <= select_2685;
      patches_next_band_rows_to_next_q <= select_2688;
      patches_next_band_number_q <= select_2690;
      patches_first_band_rows_to_next_q <= select_2694;
      patches_first_band_number_q <= select_2695;
      patches_choosing_rows_to_next_q <= and_498_s1_q ? select_2704 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_498_s1_q ? select_2708 : patches_choosing_number_q;
      patches_chooses_q <= and_498_s1_q ? select_2712 : patches_chooses_q;
      patches_choosing_band_q <= select_2715;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_1716 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_2743 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_1710 : patches_row_q;
      patches_work_q <= or_2782 ? following : patches_work_q;
      patches_second_q <= not_1581 & (patches_second_q | (patches_ends_q & equal_1680));
      patches_following_q <= equal_1680 ? {2'h0, and_2788} : {equal_1682, select_2791};
      patches_following_beats_q <= {select_2803, not_2794};
      patches_begins_q <= sample_pair_whole_s1_q & (and_1580 & and_1712);
      patches_ends_q <= not_2806 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2811;
      patches_code_row_q <= select_2813;
      patches_column_q <= or_2782 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2806 & (patches_column_q == 5'h1e);
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    sums_0_columns_values_0_q = 6'h0;
    sums_0_columns_values_1_q = 6'h0;
    sums_0_columns_values_2_q = 6'h0;
    sums_0_columns_values_3_q = 6'h0;
    sums_0_columns_values_4_q = 6'h0;
    sums_0_columns_values_5_q = 6'h0;
    sums_0_columns_values_6_q = 6'h0;
    sums_0_columns_values_7_q = 6'h0;
    sums_0_columns_values_8_q = 6'h0;
    sums_0_columns_values_9_q = 6'h0;
    sums_0_columns_values_10_q = 6'h0;
    sums_0_columns_values_11_q = 6'h0;
    sums_0_columns_values_12_q = 6'h0;
    sums_0_columns_values_13_q = 6'h0;
    sums_1_columns_values_0_q = 6'h0;
    sums_1_columns_values_1_q = 6'h0;
    sums_1_columns_values_2_q = 6'h0;
    sums_1_columns_values_3_q = 6'h0;
    sums_1_columns_values_4_q = 6'h0;
    sums_1_columns_values_5_q = 6'h0;
    sums_1_columns_values_6_q = 6'h0;
    sums_1_columns_values_7_q = 6'h0;
    sums_1_columns_values_8_q = 6'h0;
    sums_1_columns_values_9_q = 6'h0;
    sums_1_columns_values_10_q = 6'h0;
    sums_1_columns_values_11_q = 6'h0;
    sums_1_columns_values_12_q = 6'h0;
    sums_1_columns_values_13_q = 6'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s1_en) begin
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_columns_values_7_q <= sums_0_columns_values_6_q;
      sums_0_columns_values_8_q <= sums_0_columns_values_7_q;
      sums_0_columns_values_9_q <= sums_0_columns_values_8_q;
      sums_0_columns_values_10_q <= sums_0_columns_values_9_q;
      sums_0_columns_values_11_q <= sums_0_columns_values_10_q;
      sums_0_columns_values_12_q <= sums_0_columns_values_11_q;
      sums_0_columns_values_13_q <= sums_0_columns_values_12_q;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_columns_values_7_q <= sums_1_columns_values_6_q;
      sums_1_columns_values_8_q <= sums_1_columns_values_7_q;
      sums_1_columns_values_9_q <= sums_1_columns_values_8_q;
      sums_1_columns_values_10_q <= sums_1_columns_values_9_q;
      sums_1_columns_values_11_q <= sums_1_columns_values_10_q;
      sums_1_columns_values_12_q <= sums_1_columns_values_11_q;
      sums_1_columns_values_13_q <= sums_1_columns_values_12_q;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic left_first_s2_q;
  logic sample_pair_whole_s2_q;
  logic sample_present_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [5:0] last_s2_q;
  logic [3:0] age_s2_q;
  logic [2:0] slot_s2_q;
  logic ends_cell_s2_q;
  logic lower_half_s2_q;
  logic [4:0] patches_band_rows_number_s2_q;
  logic patches_chooses_s2_q;
  logic [4:0] patches_choosing_band_s2_q;
  logic patches_lower_s2_q;
  logic patches_second_s2_q;
  logic [4:0] patches_code_row_s2_q;
  logic [4:0] patches_column_s2_q;
  logic [2:0] select_462_s2_q;
  logic [5:0] select_464_s2_q;
  logic [7:0] select_468_s2_q;
  logic and_472_s2_q;
  logic equal_478_s2_q;
  logic [5:0] column_s2_q;
  logic and_496_s2_q;
  logic and_498_s2_q;
  logic so_s2_q;
  logic equal_518_s2_q;
  logic or_519_s2_q;
  logic less_526_s2_q;
  logic not_527_s2_q;
  logic equal_559_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_647_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1148_s2_q;
  logic [5:0] select_1397_s2_q;
  logic and_1449_s2_q;
  logic [5:0] right_s2_q;
  logic select_1458_s2_q;
  logic equal_1467_s2_q;
  logic and_1474_s2_q;
  logic and_1477_s2_q;
  logic and_1481_s2_q;
  logic or_1495_s2_q;
  logic [5:0] select_1506_s2_q;
  logic and_1580_s2_q;
  logic and_1593_s2_q;
  logic less_1607_s2_q;
  logic equal_1680_s2_q;
  logic not_1681_s2_q;
  logic equal_1682_s2_q;
  logic not_1683_s2_q;
  logic equal_1684_s2_q;
  logic or_1686_s2_q;
  logic [4:0] select_1710_s2_q;
  logic select_1716_s2_q;
  logic [3:0] select_1757_s2_q;
  logic and_1767_s2_q;
  logic and_1840_s2_q;
  logic select_1842_s2_q;
  logic and_1845_s2_q;
  logic and_1994_s2_q;
  logic equal_2140_s2_q;
  logic equal_2264_s2_q;
  logic and_2567_s2_q;
  logic and_2569_s2_q;
  logic or_2782_s2_q;
  logic not_2806_s2_q;
  logic less_3552_s2_q;
  logic equal_3757_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= sample_last_q;
      left_first_s2_q <= sample_pair_first_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      last_s2_q <= last_s1_q;
      age_s2_q <= age_s1_q;
      slot_s2_q <= slot_s1_q;
      ends_cell_s2_q <= ends_cell_s1_q;
      lower_half_s2_q <= lower_half_q;
      patches_band_rows_number_s2_q <= patches_band_rows_number_q;
      patches_chooses_s2_q <= patches_chooses_q;
      patches_choosing_band_s2_q <= patches_choosing_band_q;
      patches_lower_s2_q <= patches_lower_q;
      patches_second_s2_q <= patches_second_q;
      patches_code_row_s2_q <= patches_code_row_q;
      patches_column_s2_q <= patches_column_q;
      select_462_s2_q <= select_462_s1_q;
      select_464_s2_q <= select_464_s1_q;
      select_468_s2_q <= select_468_s1_q;
      and_472_s2_q <= and_472_s1_q;
      equal_478_s2_q <= equal_478_s1_q;
      column_s2_q <= column_s1_q;
      and_496_s2_q <= and_496_s1_q;
      and_498_s2_q <= and_498_s1_q;
      so_s2_q <= so_s1_q;
      equal_518_s2_q <= equal_518_s1_q;
      or_519_s2_q <= or_519_s1_q;
      less_526_s2_q <= less_526_s1_q;
      not_527_s2_q <= not_527_s1_q;
      equal_559_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_647_s2_q <= select_647_s1_q;
      column_2_s2_q <= column_2;
      select_1148_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1397_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1449_s2_q <= and_1449_s1_q;
      right_s2_q <= right_s1_q;
      select_1458_s2_q <= select_1458_s1_q;
      equal_1467_s2_q <= equal_1467_s1_q;
      and_1474_s2_q <= not_527_s1_q & and_1473;
      and_1477_s2_q <= (or_519_s1_q & (left_rdata_q[62] & not_527_s1_q)) & and_1473;
      and_1481_s2_q <= not_527_s1_q & (or_519_s1_q & (left_rdata_q[63] & not_527_s1_q));
      or_1495_s2_q <= or_1495;
      select_1506_s2_q <= select_1506;
      and_1580_s2_q <= and_1580;
      and_1593_s2_q <= and_1593;
      less_1607_s2_q <= 5'h4 < row_q[5:1];
      equal_1680_s2_q <= equal_1680;
      not_1681_s2_q <= not_1681;
      equal_1682_s2_q <= equal_1682;
      not_1683_s2_q <= not_1683;
      equal_1684_s2_q <= equal_1684;
      or_1686_s2_q <= or_1686;
      select_1710_s2_q <= select_1710;
      select_1716_s2_q <= select_1716;
      select_1757_s2_q <= select_1757;
      and_1767_s2_q <= and_1767;
      and_1840_s2_q <= sample_pair_whole_q;
      select_1842_s2_q <= left_first_q;
      and_1845_s2_q <= right_q;
      and_1994_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2140_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_2264_s2_q <= equal_2264_s1_q;
      and_2567_s2_q <= and_2265_s1_q & and_2566;
      and_2569_s2_q <= and_2265_s1_q & (~and_2566);
      or_2782_s2_q <= or_2782;
      not_2806_s2_q <= not_2806;
      less_3552_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3757_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [5:0] middle_sum_columns_values_0_q;
  logic [5:0] middle_sum_columns_values_1_q;
  logic [5:0] middle_sum_columns_values_2_q;
  logic [5:0] middle_sum_columns_values_3_q;
  logic [5:0] middle_sum_columns_values_4_q;
  logic [5:0] middle_sum_columns_values_5_q;
  logic [5:0] middle_sum_columns_values_6_q;
  logic [7:0] middle_sum_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_0_q;
  logic [7:0] sums_0_sum_sums_values_1_q;
  logic [7:0] sums_1_sum_sums_values_0_q;
  logic [7:0] sums_1_sum_sums_values_1_q;
  logic [7:0] chosen_score_q;
  logic [6:0] chosen_near_q;
  logic [2:0] chosen_place_q;
  logic [7:0] before_0_q;
  logic [7:0] before_1_q;
  logic [7:0] before_2_q;
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic patches_along_ends_q;
  logic patches_match_row_ends_q;
  logic [11:0] patches_smooth_values_0_q;
  logic [11:0] patches_smooth_values_1_q;
  logic [11:0] patches_smooth_values_2_q;
  logic [11:0] patches_smooth_values_3_q;
  logic [10:0] patches_down_values_0_q;
  logic [10:0] patches_down_values_1_q;
  logic [10:0] patches_down_values_2_q;
  logic [10:0] patches_down_values_3_q;
  logic [4:0] patches_down_by_q;
  logic [4:0] patches_along_q;
  logic [3:0] patches_match_row_q;
  logic [4:0] patches_summed_row_column_q;
  logic patches_summed_last_q;
  logic [4:0] patches_summed_down_by_q;
  logic [6:0] patches_step_q;
  logic patches_read_searches_q;
  logic [8:0] region_across_rest_q;
  logic [6:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [7:0] columns_begin_rest_q;
  logic [6:0] columns_begin_back_q;
  // hls/stages/census.hpp:119
  logic and_473;
  assign and_473 = sample_pair_whole_s2_q & and_472_s2_q;
  // hls/stages/agreement.hpp:772
  logic not_649;
  assign not_649 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_650;
  assign less_650 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:231
  logic and_652;
  assign and_652 = not_649 & (~less_650);
  // hls/stages/agreement.hpp:762
  logic [5:0] select_899;
  assign select_899 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_900;
  assign difference_900 = {1'b0, column_2_s2_q} - {1'b0, select_899};
  logic [7:0] sum_902;
  assign sum_902 = {difference_900[6], difference_900} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:739
  logic [7:0] select_903;
  assign select_903 = slot_s2_q[0] ? chosen_score_q : sum_902;
  // hls/stages/agreement.hpp:762
  logic [6:0] difference_1149;
  assign difference_1149 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1148_s2_q};
  // hls/stages/agreement.hpp:733
  logic equal_1150;
  assign equal_1150 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:762
  logic [7:0] sum_1152;
  assign sum_1152 = {difference_1149[6], difference_1149} + (equal_1150 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1398;
  assign difference_1398 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1397_s2_q};
  logic [7:0] sum_1400;
  assign sum_1400 = {difference_1398[6], difference_1398} + (equal_1150 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:735
  logic less_1401;
  assign less_1401 = sum_1152 < sum_1400;
  logic [7:0] select_1402;
  assign select_1402 = less_1401 ? sum_1400 : sum_1152;
  logic less_1403;
  assign less_1403 = select_903 < select_1402;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_652 ? (less_1403 ? select_1402 : select_903) : 8'h0;
  // hls/stages/agreement.hpp:783
  logic or_1407;
  assign or_1407 = select_647_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1408;
  assign select_1408 = or_1407 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:704
  logic not_1409;
  assign not_1409 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:736
  logic [1:0] select_1410;
  assign select_1410 = less_1401 ? {slot_s2_q[0], not_1409} : 2'h0;
  logic [2:0] select_1412;
  assign select_1412 = less_1403 ? {select_1410, not_1409} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:788
  logic [2:0] select_1413;
  assign select_1413 = or_1407 ? select_1412 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1414;
  assign select_1414 = or_1407 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:785
  logic equal_1415;
  assign equal_1415 = select_1412 == 3'h1;
  logic equal_1416;
  assign equal_1416 = select_1412 == 3'h2;
  logic not_1417;
  assign not_1417 = ~equal_1416;
  logic [2:0] select_1418;
  assign select_1418 = equal_1415 ? 3'h2 : {not_1417, {2{equal_1416}}};
  // hls/stages/agreement.hpp:227
  logic [7:0] select_1421;
  assign select_1421 = slot_s2_q[0] ? 8'h0 : sum_902;
  // hls/stages/agreement.hpp:785
  logic [7:0] select_1423;
  assign select_1423 = select_1418[1] ? (select_1418[0] ? before_1_q : sum_1152) : (select_1418[0] ? sum_1152 : select_1421);
  logic [7:0] select_1424;
  assign select_1424 = select_1418[2] ? (select_1418[0] ? before_2_q : before_0_q) : select_1423;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1425;
  assign select_1425 = or_1407 ? select_1424 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:786
  logic [1:0] select_1426;
  assign select_1426 = equal_1415 ? 2'h0 : {not_1417, equal_1416};
  logic [7:0] select_1428;
  assign select_1428 = select_1426[1] ? sum_1400 : (select_1426[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1429;
  assign select_1429 = or_1407 ? select_1428 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1431;
  assign sum_1431 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1432;
  assign sum_1432 = {1'b0, before_v} + sum_1431;
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1433;
  assign select_1433 = slot_s2_q[0] ? chosen_near_q : sum_1432;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1435;
  assign sum_1435 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1436;
  assign sum_1436 = {1'b0, before_v_2} + sum_1435;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1438;
  assign sum_1438 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1439;
  assign sum_1439 = {1'b0, before_v_3} + sum_1438;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1441;
  assign select_1441 = (sum_1436 < sum_1439) ? sum_1439 : sum_1436;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_652 ? ((select_1433 < select_1441) ? select_1441 : select_1433) : 7'h0;
  // hls/stages/agreement.hpp:788
  logic or_1446;
  assign or_1446 = select_647_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:792
  logic [6:0] select_1447;
  assign select_1447 = or_1446 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1448;
  assign select_1448 = or_1446 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:797
  logic or_1460;
  assign or_1460 = select_1458_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1461;
  assign select_1461 = or_1460 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1462;
  assign select_1462 = or_1460 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1464;
  assign or_1464 = select_1458_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1465;
  assign select_1465 = or_1464 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1466;
  assign select_1466 = or_1464 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic not_1468;
  assign not_1468 = ~equal_1467_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1478;
  assign and_1478 = not_527_s2_q & and_1477_s2_q;
  // hls/stages/agreement.hpp:935
  logic select_1484;
  assign select_1484 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1487;
  assign difference_1487 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:943
  logic [9:0] sum_1488;
  assign sum_1488 = {difference_1487[8], difference_1487} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1490;
  assign and_1490 = (and_1477_s2_q & select_1484) & ({{22{sum_1488[9]}}, sum_1488} < 32'h3);
  logic and_1491;
  assign and_1491 = not_527_s2_q & and_1490;
  logic and_1497;
  assign and_1497 = not_527_s2_q & (and_1490 & or_1495_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1498;
  assign select_1498 = less_526_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_519_s2_q ? {select_1498, and_1497, and_1491, and_1481_s2_q, and_1478, and_1474_s2_q, not_527_s2_q} : 15'h0;
  // hls/stages/patches.hpp:313
  logic and_1500;
  assign and_1500 = ends_cell_s2_q & shift_2[0];
  logic and_1502;
  assign and_1502 = not_1468 & (so_s2_q & and_1500);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1610;
  assign select_1610 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1610[16:7])) ? 8'h7f : select_1610[7:0];
  // hls/stages/patches.hpp:148
  logic [7:0] pixel;
  assign pixel = equal_1684_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1684_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:454
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  // hls/stages/patches.hpp:160
  logic and_1776;
  assign and_1776 = not_1681_s2_q & (equal_1682_s2_q & new_row);
  // hls/stages/patches.hpp:431
  logic [8:0] sum_1779;
  assign sum_1779 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1780;
  assign sum_1780 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1779, pixel_2[0]} - {1'b0, sum_1780, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:433
  logic [11:0] sum_1782;
  assign sum_1782 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1783;
  assign sum_1783 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1782[11], sum_1782};
  logic [13:0] sum_1784;
  assign sum_1784 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1783, down_2[1]};
  logic [12:0] sum_1785;
  assign sum_1785 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1784[13:1];
  logic [14:0] sum_1786;
  assign sum_1786 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1785, sum_1784[0], down_2[0]};
  // hls/stages/patches.hpp:429
  logic [8:0] sum_1789;
  assign sum_1789 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1790;
  assign sum_1790 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1789};
  logic [10:0] sum_1791;
  assign sum_1791 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1790, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1792;
  assign sum_1792 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1791[10:1];
  // hls/stages/patches.hpp:430
  logic [11:0] smooth;
  assign smooth = {sum_1792, sum_1791[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:432
  logic [12:0] sum_1794;
  assign sum_1794 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1795;
  assign sum_1795 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1796;
  assign difference_1796 = {1'b0, sum_1794, smooth[0]} - {1'b0, sum_1795, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:148
  logic and_1803;
  assign and_1803 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:160
  logic and_1807;
  assign and_1807 = or_1686_s2_q & ((equal_1684_s2_q & and_1803) & (patches_column_s2_q == 5'h1f));
  // hls/stages/patches.hpp:444
  logic or_1813;
  assign or_1813 = equal_1684_s2_q | (~and_1803);
  // hls/stages/patches.hpp:448
  logic and_1818;
  assign and_1818 = (~or_1813) & ((~patches_column_s2_q[4]) & (patches_column_s2_q == 5'hf));
  // hls/stages/patches.hpp:485
  logic less_1822;
  assign less_1822 = patches_step_q[4:0] < 5'h11;
  logic equal_1823;
  assign equal_1823 = patches_step_q[6:5] == 2'h0;
  logic not_1824;
  assign not_1824 = ~equal_1823;
  logic equal_1825;
  assign equal_1825 = patches_step_q[6:5] == 2'h3;
  logic not_1826;
  assign not_1826 = ~equal_1825;
  // hls/stages/patches.hpp:499
  logic select_1829;
  assign select_1829 = equal_1825 ? (less_1822 & (less_1822 & not_1826)) : less_1822;
  // hls/stages/patches.hpp:160
  logic and_1832;
  assign and_1832 = equal_1680_s2_q & (less_1822 ? (not_1824 & select_1829) : select_1829);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1861;
  assign sum_1861 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:227
  logic [5:0] select_2364;
  assign select_2364 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2365;
  assign select_2365 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2366;
  assign select_2366 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2367;
  assign select_2367 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2368;
  assign select_2368 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2369;
  assign select_2369 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:735
  logic less_2373;
  assign less_2373 = select_1421 < select_1402;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2375;
  assign select_2375 = slot_s2_q[0] ? 7'h0 : sum_1432;
  // hls/stages/registration.hpp:76
  logic less_2464;
  assign less_2464 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2466;
  assign select_2466 = or_519_s2_q ? (less_526_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2468;
  assign select_2468 = or_519_s2_q ? (less_526_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2470;
  assign select_2470 = or_519_s2_q ? (less_526_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2468} - {1'b0, select_2470};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2472;
  assign select_2472 = rise[8] ? select_2468 : select_2470;
  logic [8:0] difference_2473;
  assign difference_2473 = {1'b0, select_2466} - {1'b0, select_2472};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2473[8] ? 8'h0 : difference_2473[7:0];
  // hls/stages/registration.hpp:37
  logic not_2475;
  assign not_2475 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2464 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2475};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2477;
  assign xor_2477 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2477};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2483;
  assign select_2483 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2464 ? {taken, 1'b1} : {not_2475, select_2483, not_2475};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2485;
  assign sum_2485 = {left, 1'b1} + {taken_2, less_2464};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2487;
  assign select_2487 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2570;
  assign select_2570 = and_2569_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2572;
  assign select_2572 = and_2567_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2570[15]}}, select_2570});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2573;
  assign select_2573 = and_2569_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2573[15]}}, select_2573};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2575;
  assign select_2575 = and_2567_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_2576;
  assign and_2576 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2576 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:163
  logic select_2821;
  assign select_2821 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:160
  logic [11:0] select_2824;
  assign select_2824 = equal_1682_s2_q ? patches_smooth_values_0_q : (or_1686_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_2826;
  assign select_2826 = or_1686_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2828;
  assign select_2828 = equal_1680_s2_q ? patches_smooth_values_1_q : (equal_1682_s2_q ? patches_smooth_values_1_q : select_2826);
  logic [11:0] select_2829;
  assign select_2829 = or_1686_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2831;
  assign select_2831 = equal_1680_s2_q ? patches_smooth_values_2_q : (equal_1682_s2_q ? patches_smooth_values_2_q : select_2829);
  logic [11:0] select_2832;
  assign select_2832 = or_1686_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2834;
  assign select_2834 = equal_1680_s2_q ? patches_smooth_values_3_q : (equal_1682_s2_q ? patches_smooth_values_3_q : select_2832);
  logic [10:0] select_2836;
  assign select_2836 = equal_1682_s2_q ? patches_down_values_0_q : (or_1686_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_2839;
  assign select_2839 = equal_1682_s2_q ? patches_down_values_1_q : (or_1686_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_2842;
  assign select_2842 = equal_1682_s2_q ? patches_down_values_2_q : (or_1686_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_2845;
  assign select_2845 = equal_1682_s2_q ? patches_down_values_3_q : (or_1686_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:151
  logic and_2874;
  assign and_2874 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:386
  logic [4:0] select_2879;
  assign select_2879 = or_2782_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:388
  logic [3:0] select_2881;
  assign select_2881 = and_2874 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:160
  logic [4:0] select_3231;
  assign select_3231 = equal_1680_s2_q ? patches_summed_row_column_q : (equal_1682_s2_q ? patches_along_q : patches_summed_row_column_q);
  logic [4:0] select_3237;
  assign select_3237 = equal_1680_s2_q ? patches_summed_down_by_q : (equal_1682_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:495
  logic and_3270;
  assign and_3270 = less_1822 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:499
  logic select_3273;
  assign select_3273 = equal_1825 ? (less_1822 ? (not_1826 & and_3270) : and_3270) : and_3270;
  // hls/stages/patches.hpp:160
  logic select_3276;
  assign select_3276 = equal_1680_s2_q ? (less_1822 ? (not_1824 & select_3273) : select_3273) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3564;
  assign select_3564 = so_s2_q ? (and_2576 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3566;
  assign sum_3566 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3567;
  assign select_3567 = sum_1861[5] ? {1'b1, sum_1861[4:0], region_across_rest_q[2:0]} : sum_3566;
  // hls/stages/agreement.hpp:447
  logic [7:0] select_3569;
  assign select_3569 = equal_2264_s2_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3572;
  assign select_3572 = equal_2264_s2_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_468_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_473;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:334; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = column_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & and_498_s2_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1298; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1502;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_right_codes, 28 x 112, DISTANCE 12, hls/stages/patches.hpp:713; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [111:0] patches_right_codes_mem [0:27];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 28; i++) patches_right_codes_mem[i] = 112'h0;
`endif
  logic [4:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = patches_down_by_q + {1'b0, patches_match_row_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & and_1776;
  logic [111:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:714; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s2_en & and_1776;
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:728; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s2_en & and_1832;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1325; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1502;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1449_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1448, select_1447, select_1429, select_1425, select_1414, select_1413, select_1408};
  end
`ifndef SYNTHESIS
  logic [5:0] best_left_raddr_s1_sim;
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
      if (best_left_waddr >= 6'd47) $error("best_left: write outside, address %0d", best_left_waddr);
    end
    if (rst_ni && best_left_re && best_left_raddr >= 6'd47) $error("best_left: read outside, address %0d", best_left_raddr);
  end
`endif

  // Memory best_right, write
  logic [5:0] best_right_waddr;
  assign best_right_waddr = right_s2_q;
  logic best_right_we;
  assign best_right_we = s2_en & and_1449_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1466, select_1465, select_1462, select_1461};
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

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s2_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s2_en & and_1767_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {patches_columns_above_rdata_q[23:0], pixel_2};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_columns_above_we) begin
      if (patches_columns_above_re && patches_columns_above_raddr == patches_columns_above_waddr) begin
        $error("patches_columns_above: address %0d is read less than DISTANCE steps after its write", patches_columns_above_waddr);
      end
    end
  end
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      chosen_score_q <= 8'h0;
      chosen_near_q <= 7'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      patches_along_ends_q <= 1'b0;
      patches_match_row_ends_q <= 1'b0;
      patches_smooth_values_0_q <= 12'h0;
      patches_smooth_values_1_q <= 12'h0;
      patches_smooth_values_2_q <= 12'h0;
      patches_smooth_values_3_q <= 12'h0;
      patches_down_values_0_q <= 11'h0;
      patches_down_values_1_q <= 11'h0;
      patches_down_values_2_q <= 11'h0;
      patches_down_values_3_q <= 11'h0;
      patches_down_by_q <= 5'h0;
      patches_along_q <= 5'h0;
      patches_match_row_q <= 4'h0;
      patches_summed_row_column_q <= 5'h0;
      patches_summed_last_q <= 1'b0;
      patches_summed_down_by_q <= 5'h0;
      patches_step_q <= 7'h0;
      patches_read_searches_q <= 1'b0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 7'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 8'h0;
      columns_begin_back_q <= 7'h0;
    end else if (s2_en) begin
      chosen_score_q <= less_2373 ? select_1402 : select_1421;
      chosen_near_q <= (select_2375 < select_1441) ? select_1441 : select_2375;
      chosen_place_q <= less_2373 ? {select_1410, not_1409} : 3'h2;
      before_0_q <= select_1421;
      before_1_q <= sum_1152;
      before_2_q <= sum_1400;
      registration_displacement_over_q <= so_s2_q ? sum_2485[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2487;
      registration_slope_row_q <= select_2572;
      registration_slope_change_q <= select_2575;
      registration_slope_q <= so_s2_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_2806_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2806_s2_q & select_2821;
      patches_smooth_values_0_q <= equal_1680_s2_q ? patches_smooth_values_0_q : select_2824;
      patches_smooth_values_1_q <= select_2828;
      patches_smooth_values_2_q <= select_2831;
      patches_smooth_values_3_q <= select_2834;
      patches_down_values_0_q <= equal_1680_s2_q ? patches_down_values_0_q : select_2836;
      patches_down_values_1_q <= equal_1680_s2_q ? patches_down_values_1_q : select_2839;
      patches_down_values_2_q <= equal_1680_s2_q ? patches_down_values_2_q : select_2842;
      patches_down_values_3_q <= equal_1680_s2_q ? patches_down_values_3_q : select_2845;
      patches_down_by_q <= or_2782_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2874});
      patches_along_q <= select_2879;
      patches_match_row_q <= or_2782_s2_q ? 4'h0 : select_2881;
      patches_summed_row_column_q <= select_3231;
      patches_summed_last_q <= not_1681_s2_q & (equal_1682_s2_q & and_2874);
      patches_summed_down_by_q <= select_3237;
      patches_step_q <= or_2782_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3276;
      region_across_rest_q <= select_3564;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3567;
      columns_begin_rest_q <= and_498_s2_q ? select_3569 : columns_begin_rest_q;
      columns_begin_back_q <= and_498_s2_q ? select_3572 : columns_begin_back_q;
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
    sums_0_sum_sums_values_0_q = 8'h0;
    sums_0_sum_sums_values_1_q = 8'h0;
    sums_1_sum_sums_values_0_q = 8'h0;
    sums_1_sum_sums_values_1_q = 8'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_2_s2_q;
      middle_sum_columns_values_1_q <= select_2364;
      middle_sum_columns_values_2_q <= select_2365;
      middle_sum_columns_values_3_q <= select_2366;
      middle_sum_columns_values_4_q <= select_2367;
      middle_sum_columns_values_5_q <= select_2368;
      middle_sum_columns_values_6_q <= select_2369;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_902;
      sums_0_sum_sums_values_0_q <= sum_1152;
      sums_0_sum_sums_values_1_q <= equal_1150 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1400;
      sums_1_sum_sums_values_1_q <= equal_1150 ? 8'h0 : sums_1_sum_sums_values_0_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic left_first_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_present_s3_q;
  logic [7:0] x_s3_q;
  logic [5:0] last_s3_q;
  logic age_s3_q;
  logic [2:0] slot_s3_q;
  logic ends_cell_s3_q;
  logic lower_half_s3_q;
  logic [11:0] registration_slope_s3_q;
  logic [4:0] patches_band_rows_number_s3_q;
  logic patches_chooses_s3_q;
  logic [4:0] patches_choosing_band_s3_q;
  logic patches_lower_s3_q;
  logic patches_second_s3_q;
  logic [4:0] patches_code_row_s3_q;
  logic patches_column_s3_q;
  logic [4:0] patches_summed_row_column_s3_q;
  logic patches_summed_last_s3_q;
  logic [4:0] patches_summed_down_by_s3_q;
  logic [4:0] patches_step_s3_q;
  logic patches_read_searches_s3_q;
  logic [2:0] select_462_s3_q;
  logic [5:0] select_464_s3_q;
  logic [7:0] select_468_s3_q;
  logic and_472_s3_q;
  logic and_473_s3_q;
  logic equal_478_s3_q;
  logic [5:0] column_s3_q;
  logic and_496_s3_q;
  logic and_498_s3_q;
  logic so_s3_q;
  logic equal_559_s3_q;
  logic equal_1467_s3_q;
  logic not_1468_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1502_s3_q;
  logic [5:0] select_1506_s3_q;
  logic and_1511_s3_q;
  logic and_1580_s3_q;
  logic and_1593_s3_q;
  logic less_1607_s3_q;
  logic [7:0] change_s3_q;
  logic equal_1680_s3_q;
  logic equal_1682_s3_q;
  logic equal_1684_s3_q;
  logic or_1686_s3_q;
  logic [4:0] select_1710_s3_q;
  logic select_1716_s3_q;
  logic [3:0] select_1757_s3_q;
  logic new_row_s3_q;
  logic less_1787_s3_q;
  logic less_1788_s3_q;
  logic less_1797_s3_q;
  logic less_1798_s3_q;
  logic and_1809_s3_q;
  logic or_1813_s3_q;
  logic and_1821_s3_q;
  logic less_1822_s3_q;
  logic equal_1823_s3_q;
  logic not_1824_s3_q;
  logic equal_1825_s3_q;
  logic not_1826_s3_q;
  logic and_1840_s3_q;
  logic select_1842_s3_q;
  logic and_1845_s3_q;
  logic sum_1861_s3_q;
  logic textured_s3_q;
  logic and_1994_s3_q;
  logic equal_2140_s3_q;
  logic equal_2264_s3_q;
  logic less_2501_s3_q;
  logic equal_3193_s3_q;
  logic equal_3277_s3_q;
  logic less_3552_s3_q;
  logic equal_3757_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      left_first_s3_q <= left_first_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      x_s3_q <= x_s2_q;
      last_s3_q <= last_s2_q;
      age_s3_q <= age_s2_q[2];
      slot_s3_q <= slot_s2_q;
      ends_cell_s3_q <= ends_cell_s2_q;
      lower_half_s3_q <= lower_half_s2_q;
      registration_slope_s3_q <= registration_slope_q[27:16];
      patches_band_rows_number_s3_q <= patches_band_rows_number_s2_q;
      patches_chooses_s3_q <= patches_chooses_s2_q;
      patches_choosing_band_s3_q <= patches_choosing_band_s2_q;
      patches_lower_s3_q <= patches_lower_s2_q;
      patches_second_s3_q <= patches_second_s2_q;
      patches_code_row_s3_q <= patches_code_row_s2_q;
      patches_column_s3_q <= patches_column_s2_q[4];
      patches_summed_row_column_s3_q <= patches_summed_row_column_q;
      patches_summed_last_s3_q <= patches_summed_last_q;
      patches_summed_down_by_s3_q <= patches_summed_down_by_q;
      patches_step_s3_q <= patches_step_q[4:0];
      patches_read_searches_s3_q <= patches_read_searches_q;
      select_462_s3_q <= select_462_s2_q;
      select_464_s3_q <= select_464_s2_q;
      select_468_s3_q <= select_468_s2_q;
      and_472_s3_q <= and_472_s2_q;
      and_473_s3_q <= and_473;
      equal_478_s3_q <= equal_478_s2_q;
      column_s3_q <= column_s2_q;
      and_496_s3_q <= and_496_s2_q;
      and_498_s3_q <= and_498_s2_q;
      so_s3_q <= so_s2_q;
      equal_559_s3_q <= equal_559_s2_q;
      equal_1467_s3_q <= equal_1467_s2_q;
      not_1468_s3_q <= not_1468;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1502_s3_q <= and_1502;
      select_1506_s3_q <= select_1506_s2_q;
      and_1511_s3_q <= not_1468 & (so_s2_q ? and_1500 : (equal_518_s2_q & shift_2[4]));
      and_1580_s3_q <= and_1580_s2_q;
      and_1593_s3_q <= and_1593_s2_q;
      less_1607_s3_q <= less_1607_s2_q;
      change_s3_q <= change;
      equal_1680_s3_q <= equal_1680_s2_q;
      equal_1682_s3_q <= equal_1682_s2_q;
      equal_1684_s3_q <= equal_1684_s2_q;
      or_1686_s3_q <= or_1686_s2_q;
      select_1710_s3_q <= select_1710_s2_q;
      select_1716_s3_q <= select_1716_s2_q;
      select_1757_s3_q <= select_1757_s2_q;
      new_row_s3_q <= new_row;
      less_1787_s3_q <= $signed(15'h100) < $signed(sum_1786);
      less_1788_s3_q <= $signed(sum_1786[14:8]) < $signed(7'h7f);
      less_1797_s3_q <= $signed(15'h100) < $signed(difference_1796);
      less_1798_s3_q <= $signed(difference_1796[14:8]) < $signed(7'h7f);
      and_1809_s3_q <= not_1681_s2_q & (not_1683_s2_q & and_1807);
      or_1813_s3_q <= or_1813;
      and_1821_s3_q <= not_1681_s2_q & (not_1683_s2_q & (or_1686_s2_q & and_1818));
      less_1822_s3_q <= less_1822;
      equal_1823_s3_q <= equal_1823;
      not_1824_s3_q <= not_1824;
      equal_1825_s3_q <= equal_1825;
      not_1826_s3_q <= not_1826;
      and_1840_s3_q <= and_1840_s2_q;
      select_1842_s3_q <= select_1842_s2_q;
      and_1845_s3_q <= and_1845_s2_q;
      sum_1861_s3_q <= sum_1861[5];
      textured_s3_q <= textured;
      and_1994_s3_q <= and_1994_s2_q;
      equal_2140_s3_q <= equal_2140_s2_q;
      equal_2264_s3_q <= equal_2264_s2_q;
      less_2501_s3_q <= select_2468 < select_2470;
      equal_3193_s3_q <= patches_match_row_q == 4'h0;
      equal_3277_s3_q <= patches_step_q[6:5] == 2'h2;
      less_3552_s3_q <= less_3552_s2_q;
      equal_3757_s3_q <= equal_3757_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic sample_of_skin_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
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
  logic [7:0] registration_slope_here_q;
  logic [10:0] registration_expected_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [3:0] registration_fresh_q;
  logic [15:0] patches_chance_q;
  logic patches_fixed_q;
  logic patches_choice_valid_q;
  logic [6:0] patches_choice_column_q;
  logic [5:0] patches_choice_shift_q;
  logic [7:0] patches_choice_slope_q;
  logic [4:0] patches_band_q;
  logic [1:0] patches_fetch_q;
  logic [51:0] patches_codes_low_q;
  logic [55:0] patches_codes_high_q;
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
  logic [47:0] patches_left_row_q;
  logic patches_summed_first_q;
  logic [9:0] patches_read_row_differing_q;
  logic [4:0] patches_read_row_column_q;
  logic [4:0] patches_read_at_q;
  logic patches_read_first_q;
  logic patches_read_above_q;
  logic patches_read_below_q;
  logic [9:0] patches_read_far_q;
  logic [9:0] patches_peak_best_differing_q;
  logic [4:0] patches_peak_best_column_q;
  logic [4:0] patches_peak_row_q;
  logic [9:0] patches_peak_above_q;
  logic [9:0] patches_peak_below_q;
  logic [9:0] patches_peak_far_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic [7:0] region_columns_q;
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
  logic [10:0] map_row_q;
  logic [5:0] map_width_q;
  logic write_half_q;
  logic read_half_q;
  logic done_q;
  logic drew_q;
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
  // hls/stages/census.hpp:112
  logic [11:0] select_476;
  assign select_476 = select_462_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_480;
  assign sum_480 = select_476 + (equal_478_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_482;
  assign sum_482 = {4'h0, sample_pair_pixel_1_q} + (select_462_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_484;
  assign sum_484 = sum_482 + (equal_478_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = select_462_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_488;
  assign and_488 = whole & (averager_memory_rdata_q[24] | equal_478_s3_q);
  // hls/stages/agreement.hpp:404
  logic all_of_skin;
  assign all_of_skin = select_462_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_492;
  assign and_492 = all_of_skin & (averager_memory_rdata_q[25] | equal_478_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_472_s3_q ? sum_480[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_501;
  assign equal_501 = select_462_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_501 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_504;
  assign select_504 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_472_s3_q ? sum_484[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_501 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_508;
  assign select_508 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_509;
  assign and_509 = and_472_s3_q & and_488;
  // hls/stages/census.hpp:126
  logic select_511;
  assign select_511 = equal_501 ? and_509 : (averager_mask_q & and_509);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_511;
  // hls/stages/census.hpp:206
  logic and_513;
  assign and_513 = and_472_s3_q & and_492;
  // hls/stages/census.hpp:126
  logic select_515;
  assign select_515 = equal_501 ? and_513 : (averager_of_skin_q & and_513);
  // hls/stages/agreement.hpp:263
  logic and_516;
  assign and_516 = sample_pair_whole_s3_q & select_515;
  // hls/stages/census.hpp:294
  logic less_532;
  assign less_532 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_533;
  assign less_533 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_534;
  assign less_534 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_535;
  assign less_535 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_536;
  assign less_536 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_537;
  assign less_537 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_538;
  assign less_538 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_539;
  assign less_539 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_540;
  assign less_540 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_541;
  assign less_541 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_542;
  assign less_542 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_543;
  assign less_543 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_544;
  assign less_544 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_545;
  assign less_545 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_546;
  assign less_546 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_547;
  assign less_547 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_548;
  assign less_548 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_549;
  assign less_549 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_550;
  assign less_550 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_551;
  assign less_551 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_552;
  assign less_552 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_553;
  assign less_553 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_554;
  assign less_554 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_555;
  assign less_555 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:442
  logic equal_556;
  assign equal_556 = column_s3_q == 6'h0;
  logic [3:0] select_560;
  assign select_560 = equal_559_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_561;
  assign select_561 = equal_556 ? {select_560, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_562;
  assign select_562 = equal_556 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_563;
  assign and_563 = select_561[4] & select_562[3];
  // hls/stages/census.hpp:286
  logic and_565;
  assign and_565 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_567;
  assign and_567 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_565);
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_567;
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
  logic [9:0] difference_590;
  assign difference_590 = {1'b0, select_504} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_591;
  assign xor_591 = difference_590[8:0] ^ {9{difference_590[9]}};
  logic [9:0] sum_592;
  assign sum_592 = {9'h0, difference_590[9]} + {1'b0, xor_591};
  logic [9:0] difference_593;
  assign difference_593 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_594;
  assign xor_594 = difference_593[8:0] ^ {9{difference_593[9]}};
  logic [9:0] sum_595;
  assign sum_595 = {9'h0, difference_593[9]} + {1'b0, xor_594};
  logic [9:0] difference_597;
  assign difference_597 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_598;
  assign xor_598 = difference_597[8:0] ^ {9{difference_597[9]}};
  logic [9:0] sum_599;
  assign sum_599 = {9'h0, difference_597[9]} + {1'b0, xor_598};
  logic [10:0] sum_600;
  assign sum_600 = ({1'b0, sum_592} + {1'b0, sum_595}) + {1'b0, sum_599};
  logic [9:0] difference_601;
  assign difference_601 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_602;
  assign xor_602 = difference_601[8:0] ^ {9{difference_601[9]}};
  logic [9:0] sum_603;
  assign sum_603 = {9'h0, difference_601[9]} + {1'b0, xor_602};
  logic [9:0] difference_605;
  assign difference_605 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_606;
  assign xor_606 = difference_605[8:0] ^ {9{difference_605[9]}};
  // hls/stages/agreement.hpp:193
  logic not_1507;
  assign not_1507 = ~so_s3_q;
  // hls/stages/patches.hpp:313
  logic and_1508;
  assign and_1508 = not_1507 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1070
  logic equal_1512;
  assign equal_1512 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1515;
  assign select_1515 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1084
  logic [3:0] select_1517;
  assign select_1517 = equal_1512 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1515});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1518;
  assign sum_1518 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:313
  logic [3:0] select_1519;
  assign select_1519 = equal_1467_s3_q ? select_1517 : {sum_1518, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:185
  logic equal_1520;
  assign equal_1520 = x_s3_q[5:0] == 6'h3f;
  logic equal_1522;
  assign equal_1522 = x_s3_q[5:0] == 6'h3e;
  logic equal_1524;
  assign equal_1524 = x_s3_q[5:0] == 6'h3d;
  logic equal_1526;
  assign equal_1526 = x_s3_q[5:0] == 6'h3c;
  logic equal_1528;
  assign equal_1528 = x_s3_q[5:0] == 6'h3b;
  logic equal_1530;
  assign equal_1530 = x_s3_q[5:0] == 6'h36;
  logic equal_1532;
  assign equal_1532 = x_s3_q[5:0] == 6'h35;
  logic equal_1534;
  assign equal_1534 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1116
  logic and_1538;
  assign and_1538 = (~equal_1528) & ((~equal_1530) & ((~equal_1532) & (~equal_1534)));
  logic and_1542;
  assign and_1542 = (~equal_1520) & ((~equal_1522) & ((~equal_1524) & ((~equal_1526) & and_1538)));
  // hls/stages/agreement.hpp:1071
  logic less_1543;
  assign less_1543 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1547;
  assign or_1547 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:955
  logic [4:0] sum_1552;
  assign sum_1552 = {1'b0, last_s3_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2_s3_q[0] & ({2'h0, sum_1552, last_s3_q[1]} < x_s3_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1558;
  assign sum_1558 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1560;
  assign and_1560 = half_ends & ({{3{sum_1558[4]}}, sum_1558} < 8'h3);
  // hls/stages/patches.hpp:313
  logic and_1561;
  assign and_1561 = so_s3_q & and_1560;
  logic select_1562;
  assign select_1562 = equal_1467_s3_q ? (x_s3_q[6] & (equal_1512 ? and_1542 : (less_1543 & (~or_1547)))) : and_1561;
  // hls/stages/registration.hpp:258
  logic not_1564;
  assign not_1564 = ~lower_half_s3_q;
  logic [3:0] select_1565;
  assign select_1565 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1564, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1564};
  // hls/stages/patches.hpp:346
  logic [1:0] select_1594;
  assign select_1594 = and_1593_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1595;
  assign select_1595 = and_1593_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_1596;
  assign select_1596 = and_1580_s3_q ? {select_1595, select_1594[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:103
  logic [1:0] select_1597;
  assign select_1597 = and_1580_s3_q ? select_1594 : patches_fetch_q;
  logic equal_1598;
  assign equal_1598 = select_1597 == 2'h0;
  // hls/stages/patches.hpp:80
  logic right_3;
  assign right_3 = {3'h0, last_s3_q[5:1]} < x_s3_q;
  // hls/stages/patches.hpp:313
  logic and_1606;
  assign and_1606 = not_1468_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1608;
  assign equal_1608 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1608 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1614;
  assign select_1614 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_1615;
  assign select_1615 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_1616;
  assign sum_1616 = {{2{select_1614[6]}}, select_1614} + {select_1615[7], select_1615};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1617;
  assign select_1617 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_1618;
  assign select_1618 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_1619;
  assign sum_1619 = {{2{select_1617[7]}}, select_1617[7:1]} + {select_1618[7], select_1618};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1620;
  assign sum_1620 = {{3{sum_1616[8]}}, sum_1616[8:1]} + {sum_1619[8], sum_1619, select_1617[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1621;
  assign select_1621 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_1622;
  assign select_1622 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_1623;
  assign difference_1623 = {{2{select_1621[7]}}, select_1621[7:1]} - {select_1622[7], select_1622};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1624;
  assign sum_1624 = {difference_1623, select_1621[0]} + {sum_1620[10], sum_1620[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1608 ? {sum_1624, sum_1620[1]} : registration_expected_q;
  // hls/stages/patches.hpp:75
  logic [9:0] sum_1626;
  assign sum_1626 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:964
  logic and_1628;
  assign and_1628 = shift_2_s3_q[3] & ({{4{sum_1626[9]}}, sum_1626, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:81
  logic and_1633;
  assign and_1633 = ({4'h0, last_s3_q[5:1]} < ({1'b0, x_s3_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:83
  logic equal_1634;
  assign equal_1634 = x_s3_q == 8'h0;
  // hls/stages/patches.hpp:79
  logic [9:0] sum_1640;
  assign sum_1640 = {2'h0, x_s3_q} + {{4{shift_2_s3_q[10]}}, shift_2_s3_q[10:5]};
  // hls/stages/patches.hpp:83
  logic [9:0] sum_1642;
  assign sum_1642 = {sum_1640[9], sum_1640[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:964
  logic and_1645;
  assign and_1645 = ($signed(9'h0) < $signed(sum_1640[9:1])) & (~($signed({5'h0, last_s3_q}) < $signed({sum_1642, sum_1640[0]})));
  logic and_1646;
  assign and_1646 = (~(and_1633 | (equal_1634 | (~(x_s3_q < {2'h0, last_s3_q}))))) & and_1645;
  // hls/stages/patches.hpp:313
  logic and_1649;
  assign and_1649 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_1607_s3_q & and_1628) & and_1646));
  logic and_1651;
  assign and_1651 = not_1468_s3_q & (so_s3_q & and_1649);
  // hls/stages/patches.hpp:133
  logic and_1653;
  assign and_1653 = and_1651 & (~patches_fixed_q);
  // hls/stages/patches.hpp:313
  logic [6:0] select_1656;
  assign select_1656 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  logic [6:0] select_1657;
  assign select_1657 = equal_1467_s3_q ? 7'h0 : select_1656;
  logic [5:0] select_1659;
  assign select_1659 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_1661;
  assign select_1661 = equal_1467_s3_q ? 6'h0 : (so_s3_q ? select_1659 : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1662;
  assign sum_1662 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_1624[9]}}, sum_1624[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1665;
  assign select_1665 = ($signed(sum_1662[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1662[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1608 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1662[12:7])) ? 8'h7f : select_1665);
  // hls/stages/patches.hpp:313
  logic [7:0] select_1670;
  assign select_1670 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_1671;
  assign select_1671 = equal_1467_s3_q ? 8'h0 : select_1670;
  // hls/stages/patches.hpp:316
  logic [21:0] select_1672;
  assign select_1672 = and_1653 ? {select_1671, select_1661, select_1657, and_1651} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:90
  logic equal_1673;
  assign equal_1673 = x_s3_q == {2'h0, last_s3_q};
  // hls/stages/patches.hpp:313
  logic and_1677;
  assign and_1677 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (and_1633 | equal_1673)));
  logic and_1678;
  assign and_1678 = not_1468_s3_q & and_1677;
  // hls/stages/patches.hpp:317
  logic and_1679;
  assign and_1679 = patches_chooses_s3_q & and_1678;
  // hls/stages/patches.hpp:103
  logic [4:0] select_1693;
  assign select_1693 = and_1580_s3_q ? select_1595 : patches_band_q;
  // hls/stages/patches.hpp:326
  logic equal_1694;
  assign equal_1694 = {patches_choosing_band_s3_q, and_1606} == {select_1693, select_1597[1]};
  // hls/stages/patches.hpp:442
  logic [2:0] sum_1778;
  assign sum_1778 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:446
  logic [1:0] sum_1811;
  assign sum_1811 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1848;
  assign select_1848 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_1851;
  assign or_1851 = select_1848[7] | (~({select_1848[5], select_1848[3], select_1848[1]} == 3'h0));
  // hls/stages/agreement.hpp:991
  logic or_1854;
  assign or_1854 = select_1848[7] | (~({select_1848[6], select_1848[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:990
  logic or_1857;
  assign or_1857 = select_1848[7] | (~(select_1848[6:4] == 3'h0));
  // hls/stages/patches.hpp:313
  logic [5:0] select_1858;
  assign select_1858 = equal_1467_s3_q ? x_s3_q[5:0] : {region_row_q, or_1857, or_1854, or_1851};
  // hls/stages/agreement.hpp:1070
  logic not_1859;
  assign not_1859 = ~equal_1512;
  // hls/stages/agreement.hpp:1000
  logic or_1863;
  assign or_1863 = (~sum_1861_s3_q) | equal_1673;
  // hls/stages/patches.hpp:313
  logic and_1866;
  assign and_1866 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_1863));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_1887;
  assign and_1887 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:960
  logic select_1888;
  assign select_1888 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_1888);
  // hls/stages/agreement.hpp:960
  logic select_1891;
  assign select_1891 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_1888 ? select_1891 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1197
  logic select_1894;
  assign select_1894 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1201
  logic select_1895;
  assign select_1895 = left_first_s3_q ? select_1894 : read_half_q;
  logic or_1896;
  assign or_1896 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1202
  logic [8:0] select_1897;
  assign select_1897 = or_1896 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1203
  logic [9:0] select_1899;
  assign select_1899 = left_first_s3_q ? 10'h1 : (or_1896 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1206
  logic and_1900;
  assign and_1900 = select_1897[8] & select_1899[9];
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = and_1900 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1217
  logic [5:0] select_1903;
  assign select_1903 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1905;
  assign select_1905 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_1903});
  // hls/stages/agreement.hpp:1227
  logic equal_1906;
  assign equal_1906 = seen_x_q == 3'h7;
  logic [7:0] select_1908;
  assign select_1908 = and_1900 ? 8'h0 : (seen_column_q + {7'h0, equal_1906});
  // hls/stages/agreement.hpp:1234
  logic [10:0] index;
  assign index = select_1905 + {3'h0, select_1908};
  // hls/stages/agreement.hpp:1187
  logic [11:0] sum_1910;
  assign sum_1910 = {1'b0, {2{select_1895}}, 2'h0, {2{select_1895}}, 1'b0, {2{select_1895}}, 1'b0, select_1895} + {1'b0, index};
  // hls/stages/agreement.hpp:1200
  logic not_1911;
  assign not_1911 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:422
  logic and_1913;
  assign and_1913 = not_1911 & (began_q | and_1900);
  // hls/stages/agreement.hpp:1228
  logic [2:0] select_1915;
  assign select_1915 = and_1900 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1233
  logic and_1917;
  assign and_1917 = and_1913 & (select_1915 == 3'h0);
  logic less_1918;
  assign less_1918 = select_1908 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:424
  logic and_1919;
  assign and_1919 = and_1917 & less_1918;
  logic and_1920;
  assign and_1920 = and_1840_s3_q & and_1919;
  // hls/stages/agreement.hpp:265
  logic select_1922;
  assign select_1922 = and_1840_s3_q ? (left_first_s3_q ? and_1919 : and_1920) : and_1920;
  // hls/stages/agreement.hpp:1053
  logic [7:0] sum_1924;
  assign sum_1924 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1924[7], sum_1924, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1187
  logic [11:0] sum_1926;
  assign sum_1926 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:976
  logic and_1927;
  assign and_1927 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_1928;
  assign and_1928 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_1929;
  assign and_1929 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_1930;
  assign and_1930 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_1932;
  assign sum_1932 = {1'b0, and_1929} + ({1'b0, textured_s3_q} + {1'b0, and_1930});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1927} + ({2'h0, and_1928} + {1'b0, sum_1932});
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_1935;
  assign select_1935 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1936;
  assign difference_1936 = {1'b0, textured_2} - {1'b0, select_1935};
  logic [4:0] t;
  assign t = {difference_1936[3], difference_1936} + (equal_1634 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_1941;
  assign select_1941 = shift_2_s3_q[0] ? (sum_1861_s3_q ? select_1848 : {select_1848[6:0], 1'b0}) : select_1848;
  // hls/stages/agreement.hpp:992
  logic or_1944;
  assign or_1944 = select_1941[7] | (~({select_1941[5], select_1941[3], select_1941[1]} == 3'h0));
  // hls/stages/agreement.hpp:976
  logic and_1961;
  assign and_1961 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_1962;
  assign and_1962 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_1963;
  assign and_1963 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_1964;
  assign and_1964 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_1966;
  assign sum_1966 = {1'b0, and_1963} + ({1'b0, shown} + {1'b0, and_1964});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1961} + ({2'h0, and_1962} + {1'b0, sum_1966});
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_1969;
  assign select_1969 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_1970;
  assign difference_1970 = {1'b0, shown_2} - {1'b0, select_1969};
  logic [4:0] around;
  assign around = {difference_1970[3], difference_1970} + (equal_1634 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_1973;
  assign sum_1973 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:976
  logic and_1977;
  assign and_1977 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_1978;
  assign and_1978 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_1979;
  assign and_1979 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_1980;
  assign and_1980 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_1982;
  assign sum_1982 = {1'b0, and_1979} + ({1'b0, near} + {1'b0, and_1980});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1977} + ({2'h0, and_1978} + {1'b0, sum_1982});
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_1985;
  assign select_1985 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_1986;
  assign difference_1986 = {1'b0, near_2} - {1'b0, select_1985};
  logic [4:0] n;
  assign n = {difference_1986[3], difference_1986} + (equal_1634 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/patches.hpp:313
  logic and_1998;
  assign and_1998 = ends_cell_s3_q & (and_1994_s3_q & (~({1'b0, sum_1552, last_s3_q[1:0]} < x_s3_q)));
  logic and_2000;
  assign and_2000 = not_1468_s3_q & (so_s3_q & and_1998);
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2032;
  assign select_2032 = sample_pair_whole_s3_q ? (and_496_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2034;
  assign select_2034 = sample_pair_whole_s3_q ? (and_496_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2053;
  assign select_2053 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2055;
  assign select_2055 = sample_pair_whole_s3_q ? (and_496_s3_q ? select_511 : averager_mask_q) : averager_mask_q;
  logic select_2057;
  assign select_2057 = sample_pair_whole_s3_q ? (and_496_s3_q ? select_515 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2058;
  assign select_2058 = and_498_s3_q ? select_504 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2059;
  assign select_2059 = and_498_s3_q ? select_508 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2061;
  assign select_2061 = and_498_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2062;
  assign select_2062 = and_498_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2063;
  assign select_2063 = and_498_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2064;
  assign select_2064 = and_498_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2065;
  assign select_2065 = and_498_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2066;
  assign select_2066 = and_498_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2067;
  assign select_2067 = and_498_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2068;
  assign select_2068 = and_498_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2069;
  assign select_2069 = and_498_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2070;
  assign select_2070 = and_498_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2071;
  assign select_2071 = and_498_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2072;
  assign select_2072 = and_498_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2073;
  assign select_2073 = and_498_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2074;
  assign select_2074 = and_498_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2075;
  assign select_2075 = and_498_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2076;
  assign select_2076 = and_498_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2077;
  assign select_2077 = and_498_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2078;
  assign select_2078 = and_498_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2079;
  assign select_2079 = and_498_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2080;
  assign select_2080 = and_498_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2081;
  assign select_2081 = and_498_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2082;
  assign select_2082 = and_498_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2083;
  assign select_2083 = and_498_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2084;
  assign select_2084 = and_498_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2085;
  assign select_2085 = and_498_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2086;
  assign select_2086 = and_498_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2087;
  assign select_2087 = and_498_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2088;
  assign select_2088 = and_498_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2089;
  assign select_2089 = and_498_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2090;
  assign select_2090 = and_498_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2091;
  assign select_2091 = and_498_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2092;
  assign select_2092 = and_498_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2093;
  assign select_2093 = and_498_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2094;
  assign select_2094 = and_498_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2095;
  assign select_2095 = and_498_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2096;
  assign select_2096 = and_498_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2097;
  assign select_2097 = and_498_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2098;
  assign select_2098 = and_498_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2099;
  assign select_2099 = and_498_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2100;
  assign select_2100 = and_498_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2101;
  assign select_2101 = and_498_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2102;
  assign select_2102 = and_498_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2103;
  assign select_2103 = and_498_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2104;
  assign select_2104 = and_498_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2105;
  assign select_2105 = and_498_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2106;
  assign select_2106 = and_498_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2107;
  assign select_2107 = and_498_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2108;
  assign select_2108 = and_498_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2109;
  assign select_2109 = and_498_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2110;
  assign select_2110 = and_498_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2111;
  assign select_2111 = and_498_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2112;
  assign select_2112 = and_498_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2113;
  assign select_2113 = and_498_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2115;
  assign difference_2115 = {1'b0, select_508} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2116;
  assign xor_2116 = difference_2115[8:0] ^ {9{difference_2115[9]}};
  logic [9:0] sum_2117;
  assign sum_2117 = {9'h0, difference_2115[9]} + {1'b0, xor_2116};
  logic [9:0] difference_2118;
  assign difference_2118 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2119;
  assign xor_2119 = difference_2118[8:0] ^ {9{difference_2118[9]}};
  logic [9:0] sum_2120;
  assign sum_2120 = {9'h0, difference_2118[9]} + {1'b0, xor_2119};
  logic [9:0] difference_2122;
  assign difference_2122 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2123;
  assign xor_2123 = difference_2122[8:0] ^ {9{difference_2122[9]}};
  logic [9:0] sum_2124;
  assign sum_2124 = {9'h0, difference_2122[9]} + {1'b0, xor_2123};
  logic [10:0] sum_2125;
  assign sum_2125 = ({1'b0, sum_2117} + {1'b0, sum_2120}) + {1'b0, sum_2124};
  logic [9:0] difference_2126;
  assign difference_2126 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2127;
  assign xor_2127 = difference_2126[8:0] ^ {9{difference_2126[9]}};
  logic [9:0] sum_2128;
  assign sum_2128 = {9'h0, difference_2126[9]} + {1'b0, xor_2127};
  logic [9:0] difference_2130;
  assign difference_2130 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2131;
  assign xor_2131 = difference_2130[8:0] ^ {9{difference_2130[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2161;
  assign difference_2161 = {1'b0, select_504} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2161[9]} + (difference_2161[8:0] ^ {9{difference_2161[9]}});
  logic [9:0] difference_2173;
  assign difference_2173 = {1'b0, select_508} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2173[9]} + (difference_2173[8:0] ^ {9{difference_2173[9]}});
  // hls/stages/agreement.hpp:507
  logic and_2380;
  assign and_2380 = and_498_s3_q & (equal_559_s3_q & equal_2264_s3_q);
  // hls/stages/patches.hpp:313
  logic and_2384;
  assign and_2384 = not_1468_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:976
  logic and_2404;
  assign and_2404 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2405;
  assign and_2405 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2406;
  assign and_2406 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2407;
  assign and_2407 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2409;
  assign sum_2409 = {1'b0, and_2406} + ({1'b0, explained} + {1'b0, and_2407});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2404} + ({2'h0, and_2405} + {1'b0, sum_2409});
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2412;
  assign select_2412 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2413;
  assign difference_2413 = {1'b0, explained_2} - {1'b0, select_2412};
  logic [4:0] e;
  assign e = {difference_2413[3], difference_2413} + (equal_1634 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2416;
  assign sum_2416 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/patches.hpp:313
  logic and_2445;
  assign and_2445 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2489;
  assign select_2489 = equal_1467_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2491;
  assign select_2491 = equal_1467_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2492;
  assign equal_2492 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:250
  logic and_2496;
  assign and_2496 = shift_2_s3_q[3] & less_1607_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2500;
  assign sum_2500 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2502;
  assign difference_2502 = {sum_2500, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2503;
  assign select_2503 = less_2501_s3_q ? difference_2502 : {sum_2500, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2504;
  assign select_2504 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2500, shift_2_s3_q[11], 5'h0} : select_2503;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2504[7]}}, select_2504} - {sum_1624[9], sum_1624, sum_1620[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2507;
  assign select_2507 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2507[11:7])) ? 12'h7f : select_2507;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2528;
  assign difference_2528 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2530;
  assign and_2530 = and_2496 & ($signed(difference_2528) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2543;
  assign less_2543 = $signed(difference_2528) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:313
  logic select_2551;
  assign select_2551 = so_s3_q ? (equal_2492 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2554;
  assign select_2554 = so_s3_q ? (equal_1608 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2559;
  assign select_2559 = (sum_1518 == 2'h2) ? (registration_fresh_q & (~select_1565)) : registration_fresh_q;
  // hls/stages/patches.hpp:313
  logic [3:0] select_2561;
  assign select_2561 = so_s3_q ? (and_1560 ? select_2559 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2563;
  assign select_2563 = and_2380 ? 4'hf : (equal_1467_s3_q ? registration_fresh_q : select_2561);
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1515;
  // hls/stages/registration.hpp:258
  logic not_2584;
  assign not_2584 = ~quarter_2[1];
  logic [3:0] select_2585;
  assign select_2585 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2584, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2584};
  // hls/stages/patches.hpp:68
  logic parity_2719;
  assign parity_2719 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_2720;
  assign select_2720 = equal_2264_s3_q ? {patches_chance_q[14:0], parity_2719} : patches_chance_q;
  // hls/stages/patches.hpp:318
  logic not_2722;
  assign not_2722 = ~and_1678;
  // hls/stages/patches.hpp:85
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:87
  logic [4:0] select_2724;
  assign select_2724 = right_3 ? last_s3_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2724};
  // hls/stages/patches.hpp:313
  logic and_2730;
  assign and_2730 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (~(x_s3_q < {2'h0, from}))));
  // hls/stages/patches.hpp:133
  logic and_2734;
  assign and_2734 = not_2722 & (patches_fixed_q | ((not_1468_s3_q & and_2730) & and_1653));
  // hls/stages/patches.hpp:327
  logic not_2747;
  assign not_2747 = ~select_1597[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_2749;
  assign select_2749 = sample_pair_whole_s3_q ? (equal_1598 ? select_1597 : {not_2747, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:462
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_right_codes_rdata_q[55:0] : {patches_codes_high_q[3:0], patches_codes_low_q};
  // hls/stages/patches.hpp:160
  logic [51:0] select_2848;
  assign select_2848 = or_1686_s3_q ? {patches_codes_high_q[3:0], patches_codes_low_q[51:4]} : patches_codes_low_q;
  logic [51:0] select_2850;
  assign select_2850 = equal_1680_s3_q ? patches_codes_low_q : (equal_1682_s3_q ? other[55:4] : select_2848);
  // hls/stages/patches.hpp:462
  logic [55:0] select_2851;
  assign select_2851 = new_row_s3_q ? patches_right_codes_rdata_q[111:56] : {4'h0, patches_codes_high_q[55:4]};
  // hls/stages/patches.hpp:160
  logic [55:0] select_2852;
  assign select_2852 = or_1686_s3_q ? {less_1798_s3_q, less_1797_s3_q, less_1788_s3_q, less_1787_s3_q, patches_codes_high_q[55:4]} : patches_codes_high_q;
  logic [55:0] select_2854;
  assign select_2854 = equal_1680_s3_q ? patches_codes_high_q : (equal_1682_s3_q ? select_2851 : select_2852);
  // hls/stages/count_bits.hpp:24
  logic parity_2859;
  assign parity_2859 = ^{less_1798_s3_q, less_1797_s3_q, less_1788_s3_q, less_1787_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_2863;
  assign or_2863 = ({less_1788_s3_q, less_1787_s3_q} == 2'h3) | (less_1797_s3_q & (less_1788_s3_q | less_1787_s3_q));
  logic and_2864;
  assign and_2864 = less_1798_s3_q & (^{less_1797_s3_q, less_1788_s3_q, less_1787_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2865;
  assign xor_2865 = or_2863 ^ and_2864;
  // hls/stages/count_bits.hpp:27
  logic and_2866;
  assign and_2866 = or_2863 & and_2864;
  // hls/stages/patches.hpp:448
  logic [2:0] select_2868;
  assign select_2868 = or_1813_s3_q ? 3'h0 : (patches_column_s3_q ? 3'h0 : {and_2866, xor_2865, parity_2859});
  // hls/stages/patches.hpp:160
  logic [2:0] select_2871;
  assign select_2871 = equal_1680_s3_q ? 3'h0 : (equal_1682_s3_q ? 3'h0 : (or_1686_s3_q ? select_2868 : 3'h0));
  // hls/stages/patches.hpp:143
  logic [9:0] sum_2873;
  assign sum_2873 = {7'h0, patches_set_q} + (equal_1684_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:463
  logic [47:0] select_2883;
  assign select_2883 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:160
  logic [47:0] select_2885;
  assign select_2885 = equal_1680_s3_q ? patches_left_row_q : (equal_1682_s3_q ? select_2883 : patches_left_row_q);
  // hls/stages/patches.hpp:463
  logic [47:0] bits;
  assign bits = select_2883 ^ other[47:0];
  // hls/stages/count_bits.hpp:24
  logic xor_2889;
  assign xor_2889 = bits[17] ^ (^{select_2883[16:15], other[16:15]});
  logic xor_2892;
  assign xor_2892 = bits[11] ^ (^{select_2883[10:9], other[10:9]});
  logic xor_2895;
  assign xor_2895 = bits[14] ^ (^{select_2883[13:12], other[13:12]});
  logic xor_2898;
  assign xor_2898 = xor_2889 ^ (^{select_2883[14:9], other[14:9]});
  logic xor_2901;
  assign xor_2901 = bits[47] ^ (^{select_2883[46:45], other[46:45]});
  logic xor_2904;
  assign xor_2904 = bits[8] ^ (^{select_2883[7:6], other[7:6]});
  logic xor_2907;
  assign xor_2907 = bits[2] ^ (^{select_2883[1:0], other[1:0]});
  logic xor_2910;
  assign xor_2910 = bits[5] ^ (^{select_2883[4:3], other[4:3]});
  logic xor_2913;
  assign xor_2913 = xor_2904 ^ (^{select_2883[5:0], other[5:0]});
  logic parity_2915;
  assign parity_2915 = ^{select_2883[47:45], select_2883[8:0], other[47:45], other[8:0]};
  logic xor_2916;
  assign xor_2916 = xor_2898 ^ parity_2915;
  logic xor_2919;
  assign xor_2919 = bits[44] ^ (^{select_2883[43:42], other[43:42]});
  logic xor_2922;
  assign xor_2922 = bits[38] ^ (^{select_2883[37:36], other[37:36]});
  logic xor_2925;
  assign xor_2925 = bits[41] ^ (^{select_2883[40:39], other[40:39]});
  logic xor_2931;
  assign xor_2931 = bits[26] ^ (^{select_2883[25:24], other[25:24]});
  logic xor_2934;
  assign xor_2934 = bits[20] ^ (^{select_2883[19:18], other[19:18]});
  logic xor_2937;
  assign xor_2937 = bits[23] ^ (^{select_2883[22:21], other[22:21]});
  logic xor_2940;
  assign xor_2940 = xor_2931 ^ (^{select_2883[23:18], other[23:18]});
  logic xor_2943;
  assign xor_2943 = bits[35] ^ (^{select_2883[34:33], other[34:33]});
  logic xor_2946;
  assign xor_2946 = bits[29] ^ (^{select_2883[28:27], other[28:27]});
  logic xor_2949;
  assign xor_2949 = bits[32] ^ (^{select_2883[31:30], other[31:30]});
  logic xor_2952;
  assign xor_2952 = xor_2943 ^ (^{select_2883[32:27], other[32:27]});
  logic xor_2953;
  assign xor_2953 = xor_2940 ^ xor_2952;
  // hls/stages/count_bits.hpp:25
  logic or_2961;
  assign or_2961 = (xor_2892 & xor_2895) | (xor_2889 & (xor_2892 | xor_2895));
  logic or_2965;
  assign or_2965 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_2969;
  assign or_2969 = (xor_2907 & xor_2910) | (xor_2904 & (xor_2907 | xor_2910));
  // hls/stages/count_bits.hpp:23
  logic or_2976;
  assign or_2976 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_2980;
  assign or_2980 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_2984;
  assign or_2984 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_2987;
  assign parity_2987 = ^{or_2984, or_2980, or_2976};
  // hls/stages/count_bits.hpp:23
  logic or_2991;
  assign or_2991 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_2995;
  assign or_2995 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_2999;
  assign or_2999 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3002;
  assign parity_3002 = ^{or_2999, or_2995, or_2991};
  logic parity_3005;
  assign parity_3005 = ^{or_2999, or_2995, or_2991, or_2984, or_2980, or_2976, or_2969, or_2965, or_2961};
  // hls/stages/count_bits.hpp:23
  logic or_3009;
  assign or_3009 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3013;
  assign or_3013 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3017;
  assign or_3017 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3025;
  assign or_3025 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3029;
  assign or_3029 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3033;
  assign or_3033 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3036;
  assign parity_3036 = ^{or_3033, or_3029, or_3025};
  // hls/stages/count_bits.hpp:23
  logic or_3040;
  assign or_3040 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3044;
  assign or_3044 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3048;
  assign or_3048 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3051;
  assign parity_3051 = ^{or_3048, or_3044, or_3040};
  logic parity_3054;
  assign parity_3054 = ^{or_3048, or_3044, or_3040, or_3033, or_3029, or_3025, or_3017, or_3013, or_3009};
  // hls/stages/count_bits.hpp:25
  logic or_3058;
  assign or_3058 = (xor_2922 & xor_2925) | (xor_2919 & (xor_2922 | xor_2925));
  logic or_3062;
  assign or_3062 = (xor_2934 & xor_2937) | (xor_2931 & (xor_2934 | xor_2937));
  logic or_3066;
  assign or_3066 = (xor_2946 & xor_2949) | (xor_2943 & (xor_2946 | xor_2949));
  // hls/stages/count_bits.hpp:24
  logic parity_3069;
  assign parity_3069 = ^{or_3066, or_3062, or_3058};
  // hls/stages/count_bits.hpp:25
  logic and_3070;
  assign and_3070 = xor_2916 & (^{xor_2953, select_2883[44:36], other[44:36]});
  logic or_3074;
  assign or_3074 = (xor_2901 & xor_2913) | (xor_2898 & (xor_2901 | xor_2913));
  logic and_3077;
  assign and_3077 = (xor_2919 ^ (^{select_2883[41:36], other[41:36]})) & (xor_2940 | xor_2952);
  logic or_3078;
  assign or_3078 = (xor_2940 & xor_2952) | and_3077;
  // hls/stages/count_bits.hpp:24
  logic parity_3081;
  assign parity_3081 = ^{or_3078, or_3074, and_3070};
  logic parity_3084;
  assign parity_3084 = ^{or_3078, or_3074, and_3070, or_3066, or_3062, or_3058, or_3048, or_3044, or_3040, or_3033, or_3029, or_3025, or_3017, or_3013, or_3009};
  logic parity_3086;
  assign parity_3086 = ^{or_3078, or_3074, and_3070, or_3066, or_3062, or_3058, or_3048, or_3044, or_3040, or_3033, or_3029, or_3025, or_3017, or_3013, or_3009, or_2999, or_2995, or_2991, or_2984, or_2980, or_2976, or_2969, or_2965, or_2961};
  // hls/stages/count_bits.hpp:25
  logic and_3087;
  assign and_3087 = parity_3005 & parity_3084;
  logic or_3091;
  assign or_3091 = (parity_2987 & parity_3002) | ((^{or_2969, or_2965, or_2961}) & (parity_2987 | parity_3002));
  logic or_3095;
  assign or_3095 = (parity_3069 & parity_3081) | (parity_3054 & (parity_3069 | parity_3081));
  logic or_3102;
  assign or_3102 = (parity_3036 & parity_3051) | ((^{or_3017, or_3013, or_3009}) & (parity_3036 | parity_3051));
  logic or_3106;
  assign or_3106 = (or_3062 & or_3066) | (or_3058 & (or_3062 | or_3066));
  logic or_3110;
  assign or_3110 = (or_3074 & or_3078) | (and_3070 & (or_3074 | or_3078));
  // hls/stages/count_bits.hpp:23
  logic or_3117;
  assign or_3117 = (or_3013 & or_3017) | (or_3009 & (or_3013 | or_3017));
  // hls/stages/count_bits.hpp:25
  logic or_3121;
  assign or_3121 = (or_3029 & or_3033) | (or_3025 & (or_3029 | or_3033));
  logic or_3125;
  assign or_3125 = (or_3044 & or_3048) | (or_3040 & (or_3044 | or_3048));
  // hls/stages/count_bits.hpp:24
  logic parity_3128;
  assign parity_3128 = ^{or_3125, or_3121, or_3117};
  // hls/stages/count_bits.hpp:23
  logic or_3132;
  assign or_3132 = (or_2965 & or_2969) | (or_2961 & (or_2965 | or_2969));
  // hls/stages/count_bits.hpp:25
  logic or_3136;
  assign or_3136 = (or_2980 & or_2984) | (or_2976 & (or_2980 | or_2984));
  logic or_3140;
  assign or_3140 = (or_2995 & or_2999) | (or_2991 & (or_2995 | or_2999));
  // hls/stages/count_bits.hpp:24
  logic parity_3143;
  assign parity_3143 = ^{or_3140, or_3136, or_3132};
  logic parity_3146;
  assign parity_3146 = ^{or_3140, or_3136, or_3132, or_3125, or_3121, or_3117, or_3110, or_3106, or_3102};
  logic parity_3148;
  assign parity_3148 = ^{or_3140, or_3136, or_3132, or_3125, or_3121, or_3117, or_3110, or_3106, or_3102, or_3095, or_3091, and_3087};
  // hls/stages/count_bits.hpp:25
  logic or_3152;
  assign or_3152 = (or_3106 & or_3110) | (or_3102 & (or_3106 | or_3110));
  logic or_3156;
  assign or_3156 = (or_3121 & or_3125) | (or_3117 & (or_3121 | or_3125));
  logic or_3160;
  assign or_3160 = (or_3136 & or_3140) | (or_3132 & (or_3136 | or_3140));
  // hls/stages/count_bits.hpp:24
  logic parity_3163;
  assign parity_3163 = ^{or_3160, or_3156, or_3152};
  // hls/stages/count_bits.hpp:25
  logic and_3164;
  assign and_3164 = (^{or_3095, or_3091, and_3087}) & parity_3146;
  logic or_3168;
  assign or_3168 = (or_3091 & or_3095) | (and_3087 & (or_3091 | or_3095));
  logic or_3172;
  assign or_3172 = (parity_3128 & parity_3143) | ((^{or_3110, or_3106, or_3102}) & (parity_3128 | parity_3143));
  // hls/stages/count_bits.hpp:24
  logic parity_3175;
  assign parity_3175 = ^{or_3172, or_3168, and_3164};
  // hls/stages/count_bits.hpp:25
  logic and_3177;
  assign and_3177 = parity_3163 & parity_3175;
  logic or_3181;
  assign or_3181 = (or_3156 & or_3160) | (or_3152 & (or_3156 | or_3160));
  logic or_3185;
  assign or_3185 = (or_3168 & or_3172) | (and_3164 & (or_3168 | or_3172));
  // hls/stages/patches.hpp:160
  logic select_3233;
  assign select_3233 = equal_1680_s3_q ? patches_summed_first_q : (equal_1682_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:495
  logic [9:0] select_3240;
  assign select_3240 = less_1822_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:499
  logic [9:0] select_3243;
  assign select_3243 = equal_1825_s3_q ? (less_1822_s3_q ? (equal_1825_s3_q ? 10'h0 : select_3240) : 10'h0) : select_3240;
  logic [9:0] select_3245;
  assign select_3245 = less_1822_s3_q ? (equal_1823_s3_q ? 10'h0 : select_3243) : select_3243;
  // hls/stages/patches.hpp:495
  logic [4:0] select_3247;
  assign select_3247 = less_1822_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:499
  logic [4:0] select_3250;
  assign select_3250 = equal_1825_s3_q ? (less_1822_s3_q ? (equal_1825_s3_q ? 5'h0 : select_3247) : 5'h0) : select_3247;
  logic [4:0] select_3252;
  assign select_3252 = less_1822_s3_q ? (equal_1823_s3_q ? 5'h0 : select_3250) : select_3250;
  // hls/stages/patches.hpp:495
  logic [4:0] select_3254;
  assign select_3254 = less_1822_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:499
  logic [4:0] select_3257;
  assign select_3257 = equal_1825_s3_q ? (less_1822_s3_q ? (equal_1825_s3_q ? 5'h0 : select_3254) : 5'h0) : select_3254;
  logic [4:0] select_3259;
  assign select_3259 = less_1822_s3_q ? (equal_1823_s3_q ? 5'h0 : select_3257) : select_3257;
  // hls/stages/patches.hpp:495
  logic and_3262;
  assign and_3262 = less_1822_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:499
  logic select_3265;
  assign select_3265 = equal_1825_s3_q ? (less_1822_s3_q ? (not_1826_s3_q & and_3262) : and_3262) : and_3262;
  // hls/stages/patches.hpp:160
  logic select_3268;
  assign select_3268 = equal_1680_s3_q ? (less_1822_s3_q ? (not_1824_s3_q & select_3265) : select_3265) : patches_read_first_q;
  // hls/stages/patches.hpp:154
  logic or_3279;
  assign or_3279 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3280;
  assign and_3280 = patches_read_searches_s3_q & or_3279;
  // hls/stages/patches.hpp:479
  logic [4:0] select_3281;
  assign select_3281 = and_3280 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:486
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3281};
  // hls/stages/patches.hpp:495
  logic and_3285;
  assign and_3285 = less_1822_s3_q & (equal_3277_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:499
  logic select_3288;
  assign select_3288 = equal_1825_s3_q ? (less_1822_s3_q ? (not_1826_s3_q & and_3285) : and_3285) : and_3285;
  // hls/stages/patches.hpp:160
  logic select_3291;
  assign select_3291 = equal_1680_s3_q ? (less_1822_s3_q ? (not_1824_s3_q & select_3288) : select_3288) : patches_read_above_q;
  // hls/stages/patches.hpp:495
  logic and_3294;
  assign and_3294 = less_1822_s3_q & (equal_3277_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:499
  logic select_3297;
  assign select_3297 = equal_1825_s3_q ? (less_1822_s3_q ? (not_1826_s3_q & and_3294) : and_3294) : and_3294;
  // hls/stages/patches.hpp:160
  logic select_3300;
  assign select_3300 = equal_1680_s3_q ? (less_1822_s3_q ? (not_1824_s3_q & select_3297) : select_3297) : patches_read_below_q;
  // hls/stages/patches.hpp:492
  logic [6:0] sum_3301;
  assign sum_3301 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:493
  logic [9:0] select_3304;
  assign select_3304 = (equal_3277_s3_q & ({sum_3301[6], sum_3301} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:495
  logic [9:0] select_3305;
  assign select_3305 = less_1822_s3_q ? select_3304 : 10'h3ff;
  // hls/stages/patches.hpp:496
  logic [9:0] select_3307;
  assign select_3307 = less_1822_s3_q ? (equal_1825_s3_q ? 10'h3ff : select_3305) : 10'h3ff;
  // hls/stages/patches.hpp:499
  logic [9:0] select_3308;
  assign select_3308 = equal_1825_s3_q ? select_3307 : select_3305;
  logic [9:0] select_3310;
  assign select_3310 = less_1822_s3_q ? (equal_1823_s3_q ? 10'h3ff : select_3308) : select_3308;
  // hls/stages/patches.hpp:478
  logic [14:0] select_3312;
  assign select_3312 = and_3280 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:160
  logic [9:0] select_3313;
  assign select_3313 = equal_1680_s3_q ? select_3312[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3314;
  assign select_3314 = equal_1680_s3_q ? select_3312[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:480
  logic [9:0] select_3316;
  assign select_3316 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:481
  logic [9:0] select_3318;
  assign select_3318 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:482
  logic [9:0] select_3321;
  assign select_3321 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3322;
  assign select_3322 = patches_read_first_q ? patches_read_far_q : select_3321;
  // hls/stages/patches.hpp:533
  logic [9:0] difference_3325;
  assign difference_3325 = select_3322 - select_3312[9:0];
  // hls/stages/patches.hpp:518
  logic less_3355;
  assign less_3355 = select_3316 < select_3318;
  // hls/stages/patches.hpp:524
  logic [1:0] sum_3356;
  assign sum_3356 = select_3281[4:3] + 2'h3;
  // hls/stages/patches.hpp:519
  logic [9:0] high;
  assign high = less_3355 ? select_3318 : select_3316;
  logic [9:0] low;
  assign low = (select_3318 < select_3316) ? select_3318 : select_3316;
  // hls/stages/patches.hpp:520
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3312[9:0];
  // hls/stages/patches.hpp:522
  logic not_3363;
  assign not_3363 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3364;
  assign sum_3364 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3366;
  assign not_3366 = ~({eight, 3'h0} < {1'b0, sum_3364, fall[0]});
  logic [1:0] sum_3367;
  assign sum_3367 = {1'b0, not_3363} + {1'b0, not_3366};
  // hls/stages/patches.hpp:523
  logic [10:0] sum_3368;
  assign sum_3368 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3370;
  assign not_3370 = ~({eight, 3'h0} < {sum_3368, fall[1:0]});
  logic not_3373;
  assign not_3373 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3374;
  assign sum_3374 = {1'b0, not_3370} + {1'b0, not_3373};
  // hls/stages/patches.hpp:522
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3367} + {1'b0, sum_3374};
  // hls/stages/patches.hpp:525
  logic [7:0] select_3377;
  assign select_3377 = less_3355 ? ({sum_3356, select_3281[2:0], 3'h0} - {5'h0, fraction}) : {sum_3356, select_3281[2:0], fraction};
  // hls/stages/agreement.hpp:1086
  logic equal_3533;
  assign equal_3533 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/patches.hpp:313
  logic select_3549;
  assign select_3549 = equal_1467_s3_q ? shown_shown_q : (so_s3_q ? select_1888 : shown_shown_q);
  logic select_3551;
  assign select_3551 = equal_1467_s3_q ? shown_nearer_q : (so_s3_q ? select_1891 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3553;
  assign sum_3553 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3555;
  assign select_3555 = less_3552_s3_q ? (sum_3553[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3557;
  assign select_3557 = equal_2264_s3_q ? (equal_559_s3_q ? 3'h0 : select_3555) : region_row_q;
  // hls/stages/patches.hpp:313
  logic [7:0] select_3562;
  assign select_3562 = equal_1467_s3_q ? select_1848 : (so_s3_q ? (ends_cell_s3_q ? select_1941 : select_1848) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3576;
  assign select_3576 = equal_559_s3_q ? {{2{difference_3574[6]}}, difference_3574} : (less_3552_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_3578;
  assign select_3578 = and_498_s3_q ? (equal_2264_s3_q ? select_3576 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [6:0] select_3580;
  assign select_3580 = equal_559_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_3582;
  assign select_3582 = and_498_s3_q ? (equal_2264_s3_q ? select_3580 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3583;
  assign sum_3583 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3584;
  assign select_3584 = sum_3553[7] ? {1'b1, sum_3553[6:0], region_down_rest_q[0]} : sum_3583;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3553[7];
  // hls/stages/agreement.hpp:447
  logic select_3588;
  assign select_3588 = equal_2264_s3_q ? (equal_559_s3_q | (less_3552_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_3593;
  assign or_3593 = segment_starts_q | not_1507;
  // hls/stages/agreement.hpp:976
  logic select_3596;
  assign select_3596 = shift_2_s3_q[0] ? (sum_1861_s3_q ? (equal_1673 & or_1863) : or_1863) : or_3593;
  // hls/stages/patches.hpp:313
  logic select_3599;
  assign select_3599 = equal_1467_s3_q ? or_3593 : (so_s3_q ? (ends_cell_s3_q ? select_3596 : or_3593) : or_3593);
  logic [2:0] select_3673;
  assign select_3673 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_3675;
  assign select_3675 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3677;
  assign select_3677 = equal_1467_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3675 : box_textured_columns_values_1_q);
  logic [2:0] select_3678;
  assign select_3678 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3680;
  assign select_3680 = equal_1467_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_3678 : box_textured_columns_values_2_q);
  logic [2:0] select_3681;
  assign select_3681 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3683;
  assign select_3683 = equal_1467_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_3681 : box_textured_columns_values_3_q);
  logic [2:0] select_3684;
  assign select_3684 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3686;
  assign select_3686 = equal_1467_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_3684 : box_textured_columns_values_4_q);
  logic [4:0] select_3688;
  assign select_3688 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3691;
  assign select_3691 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3693;
  assign select_3693 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3695;
  assign select_3695 = equal_1467_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_3693 : box_explained_columns_values_1_q);
  logic [2:0] select_3696;
  assign select_3696 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3698;
  assign select_3698 = equal_1467_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_3696 : box_explained_columns_values_2_q);
  logic [2:0] select_3699;
  assign select_3699 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3701;
  assign select_3701 = equal_1467_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_3699 : box_explained_columns_values_3_q);
  logic [2:0] select_3702;
  assign select_3702 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3704;
  assign select_3704 = equal_1467_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_3702 : box_explained_columns_values_4_q);
  logic [4:0] select_3706;
  assign select_3706 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3707;
  assign select_3707 = equal_1467_s3_q ? box_explained_sum_sums_values_0_q : select_3706;
  logic [2:0] select_3709;
  assign select_3709 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3711;
  assign select_3711 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3713;
  assign select_3713 = equal_1467_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_3711 : box_shown_columns_values_1_q);
  logic [2:0] select_3714;
  assign select_3714 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3716;
  assign select_3716 = equal_1467_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_3714 : box_shown_columns_values_2_q);
  logic [2:0] select_3717;
  assign select_3717 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3719;
  assign select_3719 = equal_1467_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_3717 : box_shown_columns_values_3_q);
  logic [2:0] select_3720;
  assign select_3720 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3722;
  assign select_3722 = equal_1467_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_3720 : box_shown_columns_values_4_q);
  logic [4:0] select_3724;
  assign select_3724 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_3727;
  assign select_3727 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3729;
  assign select_3729 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3731;
  assign select_3731 = equal_1467_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_3729 : box_nearer_columns_values_1_q);
  logic [2:0] select_3732;
  assign select_3732 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3734;
  assign select_3734 = equal_1467_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_3732 : box_nearer_columns_values_2_q);
  logic [2:0] select_3735;
  assign select_3735 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3737;
  assign select_3737 = equal_1467_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_3735 : box_nearer_columns_values_3_q);
  logic [2:0] select_3738;
  assign select_3738 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3740;
  assign select_3740 = equal_1467_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_3738 : box_nearer_columns_values_4_q);
  logic [4:0] select_3742;
  assign select_3742 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_3745;
  assign select_3745 = so_s3_q ? (ends_cell_s3_q ? and_1929 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3748;
  assign select_3748 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_3750;
  assign select_3750 = equal_1467_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_3748 : centres_values_0_of_skin_q);
  logic select_3751;
  assign select_3751 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3753;
  assign select_3753 = equal_1467_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_3751 : centres_values_1_textured_q);
  logic select_3754;
  assign select_3754 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3756;
  assign select_3756 = equal_1467_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_3754 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:447
  logic [10:0] select_3760;
  assign select_3760 = equal_2264_s3_q ? (equal_3757_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [5:0] select_3763;
  assign select_3763 = and_498_s3_q ? (equal_2264_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1197
  logic xor_3764;
  assign xor_3764 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:424
  logic select_3766;
  assign select_3766 = and_1840_s3_q ? (left_first_s3_q ? xor_3764 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:265
  logic select_3768;
  assign select_3768 = and_1840_s3_q ? (left_first_s3_q ? xor_3764 : select_3766) : write_half_q;
  logic select_3770;
  assign select_3770 = left_first_s3_q ? select_1894 : (and_1840_s3_q ? select_1895 : read_half_q);
  logic and_3774;
  assign and_3774 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_3783;
  assign select_3783 = left_first_s3_q ? 10'h1 : (and_1840_s3_q ? select_1899 : rows_passed_q);
  logic [8:0] select_3786;
  assign select_3786 = left_first_s3_q ? {select_1897[7:0], or_1896} : (and_1840_s3_q ? {select_1897[7:0], or_1896} : columns_passed_q);
  logic select_3789;
  assign select_3789 = left_first_s3_q ? marks_last_s3_q : (and_1840_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_3792;
  assign select_3792 = left_first_s3_q ? and_1913 : (and_1840_s3_q ? and_1913 : began_q);
  logic [2:0] select_3795;
  assign select_3795 = left_first_s3_q ? select_1915 : (and_1840_s3_q ? select_1915 : seen_x_q);
  // hls/stages/agreement.hpp:1226
  logic [2:0] select_3800;
  assign select_3800 = left_first_s3_q ? 3'h0 : (and_1900 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:265
  logic [2:0] select_3802;
  assign select_3802 = left_first_s3_q ? 3'h0 : (and_1840_s3_q ? select_3800 : seen_y_q);
  logic [7:0] select_3805;
  assign select_3805 = left_first_s3_q ? select_1908 : (and_1840_s3_q ? select_1908 : seen_column_q);
  // hls/stages/agreement.hpp:422
  logic [7:0] select_3811;
  assign select_3811 = left_first_s3_q ? select_3809 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:265
  logic [7:0] select_3813;
  assign select_3813 = left_first_s3_q ? select_3809 : (and_1840_s3_q ? select_3811 : seen_rows_left_q);
  // hls/stages/agreement.hpp:422
  logic and_3818;
  assign and_3818 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:265
  logic select_3820;
  assign select_3820 = left_first_s3_q ? and_3818 : (and_1840_s3_q ? and_3818 : at_cell_end_q);
  logic select_3823;
  assign select_3823 = left_first_s3_q ? next_row : (and_1840_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_3826;
  assign select_3826 = left_first_s3_q ? 11'h0 : (and_1840_s3_q ? select_1905 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_3888;
  assign not_3888 = ~quarter[1];
  logic [3:0] select_3889;
  assign select_3889 = quarter[0] ? {quarter[1], 1'b0, not_3888, 1'b0} : {1'b0, quarter[1], 1'b0, not_3888};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1519;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_1562;
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 22, DISTANCE 12, hls/stages/patches.hpp:685; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [21:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 22'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1596;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_1598));
  logic [21:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1318; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1858;
  logic regions_re;
  assign regions_re = s3_en & (equal_1467_s3_q ? (x_s3_q[6] & not_1859) : and_1866);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1329; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_1910;
  logic map_re;
  assign map_re = s3_en & select_1922;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_468_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_473_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_492, and_488, sum_484, sum_480};
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

  // Memory census_memory, write
  logic [5:0] census_memory_waddr;
  assign census_memory_waddr = column_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_498_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_516, whole_2, select_508, select_504};
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

  // Memory shown_right, write
  logic [5:0] shown_right_waddr;
  assign shown_right_waddr = select_1506_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1511_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1508, not_1507};
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

  // Memory patches_right_codes, write
  logic [4:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1778, patches_code_row_s3_q[1:0]};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_1809_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1798_s3_q, less_1797_s3_q, less_1788_s3_q, less_1787_s3_q, patches_codes_high_q, patches_codes_low_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 5'd28) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 5'd28) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1811, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_1821_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1798_s3_q, less_1797_s3_q, less_1788_s3_q, less_1787_s3_q, patches_codes_high_q[55:12]};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_codes_we) begin
      if (patches_left_codes_re && patches_left_codes_raddr == patches_left_codes_waddr) begin
        $error("patches_left_codes: address %0d is read less than DISTANCE steps after its write", patches_left_codes_waddr);
      end
      if (patches_left_codes_waddr >= 4'd12) $error("patches_left_codes: write outside, address %0d", patches_left_codes_waddr);
    end
    if (rst_ni && patches_left_codes_re && patches_left_codes_raddr >= 4'd12) $error("patches_left_codes: read outside, address %0d", patches_left_codes_raddr);
  end
`endif

  // Memory seen_columns, write
  logic [5:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s3_q[5:0];
  logic seen_columns_we;
  assign seen_columns_we = s3_en & and_1502_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1887, textured_s3_q};
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
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      sample_of_skin_q <= 1'b0;
      averager_running_mask_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      census_filled_q <= 4'h0;
      rows_passed_above_q <= 5'h0;
      registration_slope_here_q <= 8'h0;
      registration_expected_q <= 11'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      registration_fresh_q <= 4'hf;
      patches_chance_q <= 16'h1;
      patches_fixed_q <= 1'b0;
      patches_choice_valid_q <= 1'b0;
      patches_choice_column_q <= 7'h0;
      patches_choice_shift_q <= 6'h0;
      patches_choice_slope_q <= 8'h0;
      patches_band_q <= 5'h0;
      patches_fetch_q <= 2'h0;
      patches_codes_low_q <= 52'h0;
      patches_codes_high_q <= 56'h0;
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_first_q <= 1'b0;
      patches_read_row_differing_q <= 10'h0;
      patches_read_row_column_q <= 5'h0;
      patches_read_at_q <= 5'h0;
      patches_read_first_q <= 1'b0;
      patches_read_above_q <= 1'b0;
      patches_read_below_q <= 1'b0;
      patches_read_far_q <= 10'h3ff;
      patches_peak_best_differing_q <= 10'h0;
      patches_peak_best_column_q <= 5'h0;
      patches_peak_row_q <= 5'h0;
      patches_peak_above_q <= 10'h0;
      patches_peak_below_q <= 10'h0;
      patches_peak_far_q <= 10'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
      region_down_rest_q <= 9'h0;
      region_down_back_q <= 7'h0;
      region_down_next_q <= 9'h0;
      region_fresh_q <= 1'b1;
      segment_starts_q <= 1'b1;
      centres_values_0_textured_q <= 1'b0;
      centres_values_0_of_skin_q <= 1'b0;
      centres_values_1_textured_q <= 1'b0;
      centres_values_1_of_skin_q <= 1'b0;
      map_row_q <= 11'h0;
      map_width_q <= 6'h0;
      write_half_q <= 1'b0;
      read_half_q <= 1'b1;
      done_q <= 1'b0;
      drew_q <= 1'b0;
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
      sample_pair_pixel_0_q <= left_pixel_q;
      sample_pair_pixel_1_q <= pixel_0_s3_q;
      sample_of_skin_q <= mask_s3_q;
      averager_running_mask_q <= sample_pair_whole_s3_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2053;
      averager_mask_q <= select_2055;
      averager_of_skin_q <= select_2057;
      census_filled_q <= and_498_s3_q ? {select_562[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_498_s3_q ? select_561 : rows_passed_above_q;
      registration_slope_here_q <= select_2489;
      registration_expected_q <= select_2491;
      registration_of_right_q <= equal_1467_s3_q ? registration_of_right_q : select_2551;
      registration_was_inside_q <= equal_1467_s3_q ? registration_was_inside_q : select_2554;
      registration_fresh_q <= select_2563;
      patches_chance_q <= and_498_s3_q ? select_2720 : patches_chance_q;
      patches_fixed_q <= and_2734;
      patches_choice_valid_q <= and_1678 ? (select_1672[0] & not_2722) : select_1672[0];
      patches_choice_column_q <= select_1672[7:1];
      patches_choice_shift_q <= select_1672[13:8];
      patches_choice_slope_q <= select_1672[21:14];
      patches_band_q <= sample_pair_whole_s3_q ? select_1693 : patches_band_q;
      patches_fetch_q <= select_2749;
      patches_codes_low_q <= select_2850;
      patches_codes_high_q <= select_2854;
      patches_set_q <= select_2871;
      patches_size_q <= sum_2873;
      patches_left_row_q <= select_2885;
      patches_summed_first_q <= select_3233;
      patches_read_row_differing_q <= equal_1680_s3_q ? select_3245 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1680_s3_q ? select_3252 : patches_read_row_column_q;
      patches_read_at_q <= equal_1680_s3_q ? select_3259 : patches_read_at_q;
      patches_read_first_q <= select_3268;
      patches_read_above_q <= select_3291;
      patches_read_below_q <= select_3300;
      patches_read_far_q <= equal_1680_s3_q ? select_3310 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3313;
      patches_peak_best_column_q <= select_3314;
      patches_peak_row_q <= equal_1680_s3_q ? select_3281 : patches_peak_row_q;
      patches_peak_above_q <= equal_1680_s3_q ? select_3316 : patches_peak_above_q;
      patches_peak_below_q <= equal_1680_s3_q ? select_3318 : patches_peak_below_q;
      patches_peak_far_q <= equal_1680_s3_q ? select_3322 : patches_peak_far_q;
      shown_shown_q <= select_3549;
      shown_nearer_q <= select_3551;
      region_row_q <= and_498_s3_q ? select_3557 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3562;
      region_down_rest_q <= select_3578;
      region_down_back_q <= select_3582;
      region_down_next_q <= select_3584;
      region_fresh_q <= and_498_s3_q ? select_3588 : region_fresh_q;
      segment_starts_q <= select_3599;
      centres_values_0_textured_q <= equal_1467_s3_q ? centres_values_0_textured_q : select_3745;
      centres_values_0_of_skin_q <= select_3750;
      centres_values_1_textured_q <= select_3753;
      centres_values_1_of_skin_q <= select_3756;
      map_row_q <= and_498_s3_q ? select_3760 : map_row_q;
      map_width_q <= select_3763;
      write_half_q <= select_3768;
      read_half_q <= and_1840_s3_q ? select_3770 : read_half_q;
      done_q <= and_1840_s3_q ? (not_1911 & and_3774) : and_3774;
      drew_q <= so_s3_q;
      said_q <= equal_1467_s3_q & equal_3533;
      rows_passed_q <= and_1840_s3_q ? select_3783 : rows_passed_q;
      columns_passed_q <= and_1840_s3_q ? select_3786 : columns_passed_q;
      line_ended_q <= and_1840_s3_q ? select_3789 : line_ended_q;
      began_q <= and_1840_s3_q ? select_3792 : began_q;
      seen_x_q <= and_1840_s3_q ? select_3795 : seen_x_q;
      seen_y_q <= and_1840_s3_q ? select_3802 : seen_y_q;
      seen_column_q <= and_1840_s3_q ? select_3805 : seen_column_q;
      seen_rows_left_q <= and_1840_s3_q ? select_3813 : seen_rows_left_q;
      at_cell_end_q <= and_1840_s3_q ? select_3820 : at_cell_end_q;
      was_next_row_q <= and_1840_s3_q ? select_3823 : was_next_row_q;
      seen_base_q <= and_1840_s3_q ? select_3826 : seen_base_q;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
    averager_running_0_q = 12'h0;
    averager_running_1_q = 12'h0;
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
      left_pixel_q <= and_1840_s3_q ? left_pixel_q : pixel_0_s3_q;
      averager_running_0_q <= sample_pair_whole_s3_q ? select_476 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_482 : averager_running_1_q;
      averager_total_0_q <= select_2032;
      averager_total_1_q <= select_2034;
      census_columns_values_0_cell_0_left_q <= select_2058;
      census_columns_values_0_cell_0_right_q <= select_2059;
      census_columns_values_0_cell_0_mask_q <= and_498_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2061;
      census_columns_values_0_cell_1_right_q <= select_2062;
      census_columns_values_0_cell_1_mask_q <= select_2063;
      census_columns_values_0_cell_2_left_q <= select_2064;
      census_columns_values_0_cell_2_right_q <= select_2065;
      census_columns_values_0_cell_2_mask_q <= select_2066;
      census_columns_values_0_cell_2_of_skin_q <= select_2067;
      census_columns_values_0_cell_3_left_q <= select_2068;
      census_columns_values_0_cell_3_right_q <= select_2069;
      census_columns_values_0_cell_3_mask_q <= select_2070;
      census_columns_values_0_cell_4_left_q <= select_2071;
      census_columns_values_0_cell_4_right_q <= select_2072;
      census_columns_values_0_cell_4_mask_q <= select_2073;
      census_columns_values_1_cell_0_left_q <= select_2074;
      census_columns_values_1_cell_0_right_q <= select_2075;
      census_columns_values_1_cell_0_mask_q <= select_2076;
      census_columns_values_1_cell_1_left_q <= select_2077;
      census_columns_values_1_cell_1_right_q <= select_2078;
      census_columns_values_1_cell_1_mask_q <= select_2079;
      census_columns_values_1_cell_2_left_q <= select_2080;
      census_columns_values_1_cell_2_right_q <= select_2081;
      census_columns_values_1_cell_2_mask_q <= select_2082;
      census_columns_values_1_cell_2_of_skin_q <= select_2083;
      census_columns_values_1_cell_3_left_q <= select_2084;
      census_columns_values_1_cell_3_right_q <= select_2085;
      census_columns_values_1_cell_3_mask_q <= select_2086;
      census_columns_values_1_cell_4_left_q <= select_2087;
      census_columns_values_1_cell_4_right_q <= select_2088;
      census_columns_values_1_cell_4_mask_q <= select_2089;
      census_columns_values_2_cell_0_left_q <= select_2090;
      census_columns_values_2_cell_0_right_q <= select_2091;
      census_columns_values_2_cell_0_mask_q <= select_2092;
      census_columns_values_2_cell_1_left_q <= select_2093;
      census_columns_values_2_cell_1_right_q <= select_2094;
      census_columns_values_2_cell_1_mask_q <= select_2095;
      census_columns_values_2_cell_2_left_q <= select_2096;
      census_columns_values_2_cell_2_right_q <= select_2097;
      census_columns_values_2_cell_2_mask_q <= select_2098;
      census_columns_values_2_cell_3_left_q <= select_2099;
      census_columns_values_2_cell_3_right_q <= select_2100;
      census_columns_values_2_cell_3_mask_q <= select_2101;
      census_columns_values_2_cell_4_left_q <= select_2102;
      census_columns_values_2_cell_4_right_q <= select_2103;
      census_columns_values_2_cell_4_mask_q <= select_2104;
      census_columns_values_3_cell_0_mask_q <= select_2105;
      census_columns_values_3_cell_1_left_q <= select_2106;
      census_columns_values_3_cell_1_right_q <= select_2107;
      census_columns_values_3_cell_1_mask_q <= select_2108;
      census_columns_values_3_cell_2_mask_q <= select_2109;
      census_columns_values_3_cell_3_left_q <= select_2110;
      census_columns_values_3_cell_3_right_q <= select_2111;
      census_columns_values_3_cell_3_mask_q <= select_2112;
      census_columns_values_3_cell_4_mask_q <= select_2113;
      sharpness_last_mean_0_q <= and_498_s3_q ? select_504 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_498_s3_q ? select_508 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1467_s3_q ? box_textured_columns_values_0_q : select_3673;
      box_textured_columns_values_1_q <= select_3677;
      box_textured_columns_values_2_q <= select_3680;
      box_textured_columns_values_3_q <= select_3683;
      box_textured_columns_values_4_q <= select_3686;
      box_textured_sum_sums_values_0_q <= equal_1467_s3_q ? box_textured_sum_sums_values_0_q : select_3688;
      box_explained_columns_values_0_q <= equal_1467_s3_q ? box_explained_columns_values_0_q : select_3691;
      box_explained_columns_values_1_q <= select_3695;
      box_explained_columns_values_2_q <= select_3698;
      box_explained_columns_values_3_q <= select_3701;
      box_explained_columns_values_4_q <= select_3704;
      box_explained_sum_sums_values_0_q <= select_3707;
      box_shown_columns_values_0_q <= equal_1467_s3_q ? box_shown_columns_values_0_q : select_3709;
      box_shown_columns_values_1_q <= select_3713;
      box_shown_columns_values_2_q <= select_3716;
      box_shown_columns_values_3_q <= select_3719;
      box_shown_columns_values_4_q <= select_3722;
      box_shown_sum_sums_values_0_q <= equal_1467_s3_q ? box_shown_sum_sums_values_0_q : select_3724;
      box_nearer_columns_values_0_q <= equal_1467_s3_q ? box_nearer_columns_values_0_q : select_3727;
      box_nearer_columns_values_1_q <= select_3731;
      box_nearer_columns_values_2_q <= select_3734;
      box_nearer_columns_values_3_q <= select_3737;
      box_nearer_columns_values_4_q <= select_3740;
      box_nearer_sum_sums_values_0_q <= equal_1467_s3_q ? box_nearer_sum_sums_values_0_q : select_3742;
    end
  end

  logic saturated_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic left_first_s4_q;
  logic [7:0] sample_pair_pixel_0_s4_q;
  logic [7:0] sample_pair_pixel_1_s4_q;
  logic sample_pair_whole_s4_q;
  logic sample_present_s4_q;
  logic census_columns_values_1_cell_2_of_skin_s4_q;
  logic [7:0] x_s4_q;
  logic [2:0] slot_s4_q;
  logic ends_cell_s4_q;
  logic lower_half_s4_q;
  logic registration_of_right_s4_q;
  logic [4:0] patches_choosing_band_s4_q;
  logic patches_lower_s4_q;
  logic patches_second_s4_q;
  logic [4:0] patches_summed_row_column_s4_q;
  logic patches_summed_first_s4_q;
  logic patches_summed_last_s4_q;
  logic [4:0] patches_summed_down_by_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic centres_values_1_textured_s4_q;
  logic centres_values_1_of_skin_s4_q;
  logic done_s4_q;
  logic [2:0] select_462_s4_q;
  logic [5:0] select_464_s4_q;
  logic [5:0] column_s4_q;
  logic and_496_s4_q;
  logic and_498_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_501_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic less_532_s4_q;
  logic less_533_s4_q;
  logic less_534_s4_q;
  logic less_535_s4_q;
  logic less_536_s4_q;
  logic less_537_s4_q;
  logic less_538_s4_q;
  logic less_539_s4_q;
  logic less_540_s4_q;
  logic less_541_s4_q;
  logic less_542_s4_q;
  logic less_543_s4_q;
  logic less_544_s4_q;
  logic less_545_s4_q;
  logic less_546_s4_q;
  logic less_547_s4_q;
  logic less_548_s4_q;
  logic less_549_s4_q;
  logic less_550_s4_q;
  logic less_551_s4_q;
  logic less_552_s4_q;
  logic less_553_s4_q;
  logic less_554_s4_q;
  logic less_555_s4_q;
  logic and_563_s4_q;
  logic and_588_s4_q;
  logic and_589_s4_q;
  logic [11:0] sum_604_s4_q;
  logic [9:0] sum_607_s4_q;
  logic equal_1467_s4_q;
  logic not_1468_s4_q;
  logic equal_1512_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1518_s4_q;
  logic equal_1520_s4_q;
  logic equal_1522_s4_q;
  logic equal_1524_s4_q;
  logic equal_1526_s4_q;
  logic equal_1528_s4_q;
  logic equal_1530_s4_q;
  logic equal_1532_s4_q;
  logic equal_1534_s4_q;
  logic less_1543_s4_q;
  logic or_1547_s4_q;
  logic equal_1567_s4_q;
  logic and_1577_s4_q;
  logic and_1580_s4_q;
  logic select_1597_s4_q;
  logic equal_1598_s4_q;
  logic and_1606_s4_q;
  logic equal_1608_s4_q;
  logic select_1672_s4_q;
  logic and_1679_s4_q;
  logic equal_1680_s4_q;
  logic equal_1682_s4_q;
  logic and_1695_s4_q;
  logic [4:0] select_1710_s4_q;
  logic select_1716_s4_q;
  logic [3:0] select_1757_s4_q;
  logic less_1822_s4_q;
  logic equal_1823_s4_q;
  logic not_1824_s4_q;
  logic equal_1825_s4_q;
  logic and_1840_s4_q;
  logic select_1842_s4_q;
  logic and_1845_s4_q;
  logic or_1851_s4_q;
  logic or_1854_s4_q;
  logic or_1857_s4_q;
  logic not_1859_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1880_s4_q;
  logic and_1885_s4_q;
  logic and_1917_s4_q;
  logic less_1918_s4_q;
  logic [11:0] sum_1926_s4_q;
  logic equal_1939_s4_q;
  logic or_1944_s4_q;
  logic or_1947_s4_q;
  logic or_1950_s4_q;
  logic not_1975_s4_q;
  logic less_1989_s4_q;
  logic and_2000_s4_q;
  logic [11:0] sum_2129_s4_q;
  logic [9:0] sum_2132_s4_q;
  logic equal_2140_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2380_s4_q;
  logic and_2384_s4_q;
  logic not_2418_s4_q;
  logic and_2446_s4_q;
  logic and_2495_s4_q;
  logic and_2496_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2530_s4_q;
  logic and_2544_s4_q;
  logic equal_2587_s4_q;
  logic parity_2957_s4_q;
  logic parity_3086_s4_q;
  logic parity_3148_s4_q;
  logic xor_3176_s4_q;
  logic parity_3188_s4_q;
  logic or_3192_s4_q;
  logic equal_3193_s4_q;
  logic [4:0] select_3312_s4_q;
  logic equal_3324_s4_q;
  logic less_3326_s4_q;
  logic less_3327_s4_q;
  logic or_3332_s4_q;
  logic [7:0] select_3377_s4_q;
  logic equal_3533_s4_q;
  logic and_3829_s4_q;
  logic equal_3891_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      saturated_s4_q <= saturated_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      left_first_s4_q <= left_first_s3_q;
      sample_pair_pixel_0_s4_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s4_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s4_q <= sample_pair_whole_s3_q;
      sample_present_s4_q <= sample_present_s3_q;
      census_columns_values_1_cell_2_of_skin_s4_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s4_q <= x_s3_q;
      slot_s4_q <= slot_s3_q;
      ends_cell_s4_q <= ends_cell_s3_q;
      lower_half_s4_q <= lower_half_s3_q;
      registration_of_right_s4_q <= registration_of_right_q;
      patches_choosing_band_s4_q <= patches_choosing_band_s3_q;
      patches_lower_s4_q <= patches_lower_s3_q;
      patches_second_s4_q <= patches_second_s3_q;
      patches_summed_row_column_s4_q <= patches_summed_row_column_s3_q;
      patches_summed_first_s4_q <= patches_summed_first_q;
      patches_summed_last_s4_q <= patches_summed_last_s3_q;
      patches_summed_down_by_s4_q <= patches_summed_down_by_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      done_s4_q <= done_q;
      select_462_s4_q <= select_462_s3_q;
      select_464_s4_q <= select_464_s3_q;
      column_s4_q <= column_s3_q;
      and_496_s4_q <= and_496_s3_q;
      and_498_s4_q <= and_498_s3_q;
      grey_s4_q <= grey;
      equal_501_s4_q <= equal_501;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      less_532_s4_q <= less_532;
      less_533_s4_q <= less_533;
      less_534_s4_q <= less_534;
      less_535_s4_q <= less_535;
      less_536_s4_q <= less_536;
      less_537_s4_q <= less_537;
      less_538_s4_q <= less_538;
      less_539_s4_q <= less_539;
      less_540_s4_q <= less_540;
      less_541_s4_q <= less_541;
      less_542_s4_q <= less_542;
      less_543_s4_q <= less_543;
      less_544_s4_q <= less_544;
      less_545_s4_q <= less_545;
      less_546_s4_q <= less_546;
      less_547_s4_q <= less_547;
      less_548_s4_q <= less_548;
      less_549_s4_q <= less_549;
      less_550_s4_q <= less_550;
      less_551_s4_q <= less_551;
      less_552_s4_q <= less_552;
      less_553_s4_q <= less_553;
      less_554_s4_q <= less_554;
      less_555_s4_q <= less_555;
      and_563_s4_q <= and_563;
      and_588_s4_q <= whole_22 & and_563;
      and_589_s4_q <= census_columns_values_1_cell_2_mask_q & and_563;
      sum_604_s4_q <= {1'b0, sum_600} + {2'h0, sum_603};
      sum_607_s4_q <= {9'h0, difference_605[9]} + {1'b0, xor_606};
      equal_1467_s4_q <= equal_1467_s3_q;
      not_1468_s4_q <= not_1468_s3_q;
      equal_1512_s4_q <= equal_1512;
      all_s4_q <= all;
      sum_1518_s4_q <= sum_1518;
      equal_1520_s4_q <= equal_1520;
      equal_1522_s4_q <= equal_1522;
      equal_1524_s4_q <= equal_1524;
      equal_1526_s4_q <= equal_1526;
      equal_1528_s4_q <= equal_1528;
      equal_1530_s4_q <= equal_1530;
      equal_1532_s4_q <= equal_1532;
      equal_1534_s4_q <= equal_1534;
      less_1543_s4_q <= less_1543;
      or_1547_s4_q <= or_1547;
      equal_1567_s4_q <= (registration_fresh_q & select_1565) == 4'h0;
      and_1577_s4_q <= not_1468_s3_q & and_1561;
      and_1580_s4_q <= and_1580_s3_q;
      select_1597_s4_q <= select_1597[1];
      equal_1598_s4_q <= equal_1598;
      and_1606_s4_q <= and_1606;
      equal_1608_s4_q <= equal_1608;
      select_1672_s4_q <= select_1672[0];
      and_1679_s4_q <= and_1679;
      equal_1680_s4_q <= equal_1680_s3_q;
      equal_1682_s4_q <= equal_1682_s3_q;
      and_1695_s4_q <= and_1679 & equal_1694;
      select_1710_s4_q <= select_1710_s3_q;
      select_1716_s4_q <= select_1716_s3_q;
      select_1757_s4_q <= select_1757_s3_q;
      less_1822_s4_q <= less_1822_s3_q;
      equal_1823_s4_q <= equal_1823_s3_q;
      not_1824_s4_q <= not_1824_s3_q;
      equal_1825_s4_q <= equal_1825_s3_q;
      and_1840_s4_q <= and_1840_s3_q;
      select_1842_s4_q <= select_1842_s3_q;
      and_1845_s4_q <= and_1845_s3_q;
      or_1851_s4_q <= or_1851;
      or_1854_s4_q <= or_1854;
      or_1857_s4_q <= or_1857;
      not_1859_s4_q <= not_1859;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1880_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_1885_s4_q <= not_1468_s3_q & and_1866;
      and_1917_s4_q <= and_1917;
      less_1918_s4_q <= less_1918;
      sum_1926_s4_q <= sum_1926;
      equal_1939_s4_q <= t[4:1] == 4'h0;
      or_1944_s4_q <= or_1944;
      or_1947_s4_q <= select_1941[7] | (~({select_1941[6], select_1941[3:2]} == 3'h0));
      or_1950_s4_q <= select_1941[7] | (~(select_1941[6:4] == 3'h0));
      not_1975_s4_q <= ~({sum_1973, around[0]} < {2'h0, t});
      less_1989_s4_q <= {1'b0, around[4:1]} < n;
      and_2000_s4_q <= and_2000;
      sum_2129_s4_q <= {1'b0, sum_2125} + {2'h0, sum_2128};
      sum_2132_s4_q <= {9'h0, difference_2130[9]} + {1'b0, xor_2131};
      equal_2140_s4_q <= equal_2140_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2380_s4_q <= and_2380;
      and_2384_s4_q <= and_2384;
      not_2418_s4_q <= ~({sum_2416, e[0]} < {2'h0, t});
      and_2446_s4_q <= not_1468_s3_q & and_2445;
      and_2495_s4_q <= not_1468_s3_q & (so_s3_q & (half_ends & equal_2492));
      and_2496_s4_q <= and_2496;
      residual_s4_q <= residual[7:0];
      and_2530_s4_q <= and_2530;
      and_2544_s4_q <= and_2496 & less_2543;
      equal_2587_s4_q <= (registration_fresh_q & select_2585) == 4'h0;
      parity_2957_s4_q <= ^{xor_2953, xor_2916, select_2883[44:36], other[44:36]};
      parity_3086_s4_q <= parity_3086;
      parity_3148_s4_q <= parity_3148;
      xor_3176_s4_q <= parity_3163 ^ parity_3175;
      parity_3188_s4_q <= ^{or_3185, or_3181, and_3177};
      or_3192_s4_q <= (or_3181 & or_3185) | (and_3177 & (or_3181 | or_3185));
      equal_3193_s4_q <= equal_3193_s3_q;
      select_3312_s4_q <= select_3312[14:10];
      equal_3324_s4_q <= select_3281[3:0] == 4'h0;
      less_3326_s4_q <= {difference_3325, 2'h0} < {2'h0, sum_2873};
      less_3327_s4_q <= select_3322 < select_3312[9:0];
      or_3332_s4_q <= (sum_2873 < 10'h39) | ({1'b0, sum_2873[9:1]} < select_3312[9:0]);
      select_3377_s4_q <= select_3377;
      equal_3533_s4_q <= equal_3533;
      and_3829_s4_q <= and_2000 & (sum_1926 == sum_1910);
      equal_3891_s4_q <= (registration_fresh_q & select_3889) == 4'h0;
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
  logic patches_place_0_valid_q;
  logic [6:0] patches_place_0_column_q;
  logic [5:0] patches_place_0_shift_q;
  logic [7:0] patches_place_0_slope_q;
  logic patches_place_1_valid_q;
  logic [6:0] patches_place_1_column_q;
  logic [5:0] patches_place_1_shift_q;
  logic [7:0] patches_place_1_slope_q;
  logic patches_valid_0_q;
  logic patches_valid_1_q;
  logic [5:0] patches_right_next_0_q;
  logic [5:0] patches_right_next_1_q;
  logic [4:0] patches_left_next_0_q;
  logic [4:0] patches_left_next_1_q;
  logic [9:0] patches_sums_values_0_q;
  logic [9:0] patches_sums_values_1_q;
  logic [9:0] patches_sums_values_2_q;
  logic [9:0] patches_sums_values_3_q;
  logic [9:0] patches_sums_values_4_q;
  logic [9:0] patches_sums_values_5_q;
  logic [9:0] patches_sums_values_6_q;
  logic [9:0] patches_sums_values_7_q;
  logic [9:0] patches_sums_values_8_q;
  logic [9:0] patches_sums_values_9_q;
  logic [9:0] patches_sums_values_10_q;
  logic [9:0] patches_sums_values_11_q;
  logic [9:0] patches_sums_values_12_q;
  logic [9:0] patches_sums_values_13_q;
  logic [9:0] patches_sums_values_14_q;
  logic [9:0] patches_sums_values_15_q;
  logic [9:0] patches_sums_values_16_q;
  logic [9:0] patches_best_differing_q;
  logic [4:0] patches_best_column_q;
  logic [7:0] patches_quarters_0_places_q;
  logic [7:0] patches_quarters_0_up_q;
  logic [7:0] patches_quarters_0_down_q;
  logic [7:0] patches_quarters_1_places_q;
  logic [7:0] patches_quarters_1_up_q;
  logic [7:0] patches_quarters_1_down_q;
  logic [7:0] patches_quarters_2_places_q;
  logic [7:0] patches_quarters_2_up_q;
  logic [7:0] patches_quarters_2_down_q;
  logic [7:0] patches_quarters_3_places_q;
  logic [7:0] patches_quarters_3_up_q;
  logic [7:0] patches_quarters_3_down_q;
  logic [7:0] patches_word_places_q;
  logic [7:0] patches_word_up_q;
  logic [7:0] patches_word_down_q;
  logic [7:0] patches_sum_places_q;
  logic [7:0] patches_sum_up_q;
  logic [7:0] patches_sum_down_q;
  logic [11:0] patches_across_q;
  logic [7:0] patches_places_q;
  logic patches_enough_q;
  logic patches_mostly_q;
  logic patches_complete_q;
  logic patches_round_ends_q;
  logic [4:0] patches_found_q;
  logic [7:0] patches_round_places_q;
  logic [11:0] patches_round_across_q;
  logic [4:0] patches_round_moved_q;
  logic patches_moved_q;
  logic [5:0] segment_textured_q;
  logic [5:0] segment_explained_q;
  logic [5:0] segment_nearer_q;
  logic segment_started_q;
  logic [47:0] good_q;
  logic good_known_q;
  logic [7:0] hidden_for_q;
  logic [13:0] product_q;
  logic product_rest_q;
  logic disagree_q;
  logic too_much_q;
  logic hides_q;
  logic proven_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:270
  logic [11:0] texture;
  assign texture = sum_604_s4_q + {2'h0, sum_607_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_609;
  assign sum_609 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_611;
  assign sum_611 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_609});
  // hls/stages/census.hpp:303
  logic less_612;
  assign less_612 = 9'h4 < sum_611[13:5];
  logic and_613;
  assign and_613 = and_563_s4_q & less_612;
  // hls/stages/registration.hpp:265
  logic equal_1569;
  assign equal_1569 = sum_1518_s4_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1518_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1571;
  assign select_1571 = equal_1569 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1572;
  assign sum_1572 = (equal_1567_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1571[13]}}, select_1571};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1518_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1575;
  assign select_1575 = equal_1569 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1576;
  assign sum_1576 = (equal_1567_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1575[6]}}, select_1575};
  // hls/stages/patches.hpp:326
  logic [21:0] select_1696;
  assign select_1696 = and_1695_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1672_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:104
  logic select_1698;
  assign select_1698 = equal_1598_s4_q ? patches_place_0_valid_q : (select_1597_s4_q ? patches_place_0_valid_q : select_1696[0]);
  // hls/stages/patches.hpp:327
  logic [20:0] select_1699;
  assign select_1699 = select_1597_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1696[21:1];
  // hls/stages/patches.hpp:104
  logic [6:0] select_1700;
  assign select_1700 = equal_1598_s4_q ? patches_place_0_column_q : select_1699[6:0];
  logic [5:0] select_1701;
  assign select_1701 = equal_1598_s4_q ? patches_place_0_shift_q : select_1699[12:7];
  // hls/stages/patches.hpp:297
  logic [6:0] sum_1702;
  assign sum_1702 = select_1700 + {select_1701[5], select_1701};
  // hls/stages/patches.hpp:298
  logic [5:0] sum_1703;
  assign sum_1703 = sum_1702[6:1] + 6'h3f;
  // hls/stages/patches.hpp:108
  logic equal_1704;
  assign equal_1704 = {sum_1703[5], select_464_s4_q, select_462_s4_q} == {1'b0, sum_1703[4:0], sum_1702[0], 3'h4};
  // hls/stages/patches.hpp:110
  logic or_1706;
  assign or_1706 = and_1580_s4_q | (select_1698 & equal_1704);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_1707;
  assign select_1707 = or_1706 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:110
  logic [5:0] select_1717;
  assign select_1717 = or_1706 ? {and_1580_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:114
  logic and_1719;
  assign and_1719 = select_1716_s4_q & (~select_1717[5]);
  // hls/stages/patches.hpp:104
  logic select_1727;
  assign select_1727 = equal_1598_s4_q ? patches_place_1_valid_q : (select_1597_s4_q ? select_1696[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:327
  logic [20:0] select_1728;
  assign select_1728 = select_1597_s4_q ? select_1696[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:104
  logic [6:0] select_1729;
  assign select_1729 = equal_1598_s4_q ? patches_place_1_column_q : select_1728[6:0];
  logic [5:0] select_1730;
  assign select_1730 = equal_1598_s4_q ? patches_place_1_shift_q : select_1728[12:7];
  // hls/stages/patches.hpp:297
  logic [6:0] sum_1731;
  assign sum_1731 = select_1729 + {select_1730[5], select_1730};
  // hls/stages/patches.hpp:298
  logic [5:0] sum_1732;
  assign sum_1732 = sum_1731[6:1] + 6'h3f;
  // hls/stages/patches.hpp:108
  logic equal_1733;
  assign equal_1733 = {sum_1732[5], select_464_s4_q, select_462_s4_q} == {1'b0, sum_1732[4:0], sum_1731[0], 3'h4};
  // hls/stages/patches.hpp:110
  logic or_1735;
  assign or_1735 = and_1580_s4_q | (select_1727 & equal_1733);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_1736;
  assign select_1736 = or_1735 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:110
  logic [5:0] select_1737;
  assign select_1737 = or_1735 ? {and_1580_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:114
  logic and_1739;
  assign and_1739 = select_1716_s4_q & (~select_1737[5]);
  // hls/stages/patches.hpp:293
  logic [6:0] sum_1746;
  assign sum_1746 = select_1700 + 7'h7f;
  // hls/stages/patches.hpp:109
  logic equal_1747;
  assign equal_1747 = {sum_1746[6], select_464_s4_q, select_462_s4_q} == {1'b0, sum_1746[5:0], 3'h4};
  // hls/stages/patches.hpp:111
  logic or_1749;
  assign or_1749 = and_1580_s4_q | (select_1698 & equal_1747);
  logic [4:0] select_1750;
  assign select_1750 = or_1749 ? {and_1580_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:293
  logic [6:0] sum_1751;
  assign sum_1751 = select_1729 + 7'h7f;
  // hls/stages/patches.hpp:109
  logic equal_1752;
  assign equal_1752 = {sum_1751[6], select_464_s4_q, select_462_s4_q} == {1'b0, sum_1751[5:0], 3'h4};
  // hls/stages/patches.hpp:111
  logic [4:0] select_1755;
  assign select_1755 = (and_1580_s4_q | (select_1727 & equal_1752)) ? {and_1580_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:119
  logic [3:0] column_5;
  assign column_5 = select_1750[4] ? select_1755[3:0] : select_1750[3:0];
  // hls/stages/agreement.hpp:263
  logic select_1758;
  assign select_1758 = or_1749 ? and_1580_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:119
  logic and_1764;
  assign and_1764 = (select_1716_s4_q & (select_1710_s4_q[3] ^ select_1710_s4_q[4])) & ((~select_1750[4]) | (~select_1755[4]));
  // hls/stages/patches.hpp:160
  logic less_1834;
  assign less_1834 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:161
  logic not_1835;
  assign not_1835 = ~less_1834;
  logic [1:0] select_1836;
  assign select_1836 = patches_summed_first_s4_q ? 2'h2 : {less_1834, not_1835};
  logic [12:0] select_1838;
  assign select_1838 = select_1836[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1846;
  assign select_1846 = select_1836[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1845_s4_q, 1'b0, select_1842_s4_q, left_pixel_q};
  logic [14:0] select_1847;
  assign select_1847 = (select_1836 == 2'h2) ? {select_1838[12:8], patches_sums_values_0_q[9:8], select_1838[7:0]} : select_1846;
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1870;
  assign select_1870 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:867
  logic [5:0] sum_1871;
  assign sum_1871 = {5'h0, textured_s4_q} + select_1870;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_1873;
  assign sum_1873 = {4'h0, sum_1871} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1875;
  assign select_1875 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:867
  logic [5:0] sum_1876;
  assign sum_1876 = {5'h0, explained_s4_q} + select_1875;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_1878;
  assign sum_1878 = {4'h0, sum_1876} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1881;
  assign select_1881 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:868
  logic [5:0] sum_1882;
  assign sum_1882 = {5'h0, and_1880_s4_q} + select_1881;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_1884;
  assign sum_1884 = {4'h0, sum_1882} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1043
  logic not_1951;
  assign not_1951 = ~region_row_s4_q[2];
  logic [2:0] select_1952;
  assign select_1952 = region_row_s4_q[1] ? {1'b0, not_1951, 1'b0} : {region_row_s4_q[2], 1'b0, not_1951};
  logic [5:0] select_1953;
  assign select_1953 = region_row_s4_q[0] ? {select_1952[2], 1'b0, select_1952[1], 1'b0, select_1952[0], 1'b0} : {1'b0, select_1952[2], 1'b0, select_1952[1], 1'b0, select_1952[0]};
  logic [11:0] select_1954;
  assign select_1954 = or_1950_s4_q ? {select_1953[5], 1'b0, select_1953[4], 1'b0, select_1953[3], 1'b0, select_1953[2], 1'b0, select_1953[1], 1'b0, select_1953[0], 1'b0} : {1'b0, select_1953[5], 1'b0, select_1953[4], 1'b0, select_1953[3], 1'b0, select_1953[2], 1'b0, select_1953[1], 1'b0, select_1953[0]};
  logic [23:0] select_1955;
  assign select_1955 = or_1947_s4_q ? {select_1954[11], 1'b0, select_1954[10], 1'b0, select_1954[9], 1'b0, select_1954[8], 1'b0, select_1954[7], 1'b0, select_1954[6], 1'b0, select_1954[5], 1'b0, select_1954[4], 1'b0, select_1954[3], 1'b0, select_1954[2], 1'b0, select_1954[1], 1'b0, select_1954[0], 1'b0} : {1'b0, select_1954[11], 1'b0, select_1954[10], 1'b0, select_1954[9], 1'b0, select_1954[8], 1'b0, select_1954[7], 1'b0, select_1954[6], 1'b0, select_1954[5], 1'b0, select_1954[4], 1'b0, select_1954[3], 1'b0, select_1954[2], 1'b0, select_1954[1], 1'b0, select_1954[0]};
  logic [47:0] select_1956;
  assign select_1956 = or_1944_s4_q ? {select_1955[23], 1'b0, select_1955[22], 1'b0, select_1955[21], 1'b0, select_1955[20], 1'b0, select_1955[19], 1'b0, select_1955[18], 1'b0, select_1955[17], 1'b0, select_1955[16], 1'b0, select_1955[15], 1'b0, select_1955[14], 1'b0, select_1955[13], 1'b0, select_1955[12], 1'b0, select_1955[11], 1'b0, select_1955[10], 1'b0, select_1955[9], 1'b0, select_1955[8], 1'b0, select_1955[7], 1'b0, select_1955[6], 1'b0, select_1955[5], 1'b0, select_1955[4], 1'b0, select_1955[3], 1'b0, select_1955[2], 1'b0, select_1955[1], 1'b0, select_1955[0], 1'b0} : {1'b0, select_1955[23], 1'b0, select_1955[22], 1'b0, select_1955[21], 1'b0, select_1955[20], 1'b0, select_1955[19], 1'b0, select_1955[18], 1'b0, select_1955[17], 1'b0, select_1955[16], 1'b0, select_1955[15], 1'b0, select_1955[14], 1'b0, select_1955[13], 1'b0, select_1955[12], 1'b0, select_1955[11], 1'b0, select_1955[10], 1'b0, select_1955[9], 1'b0, select_1955[8], 1'b0, select_1955[7], 1'b0, select_1955[6], 1'b0, select_1955[5], 1'b0, select_1955[4], 1'b0, select_1955[3], 1'b0, select_1955[2], 1'b0, select_1955[1], 1'b0, select_1955[0]};
  // hls/stages/agreement.hpp:976
  logic and_1960;
  assign and_1960 = good_known_q & (~((good_q & select_1956) == 48'h0));
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_1939_s4_q ? and_1960 : not_1975_s4_q;
  // hls/stages/agreement.hpp:1054
  logic and_1990;
  assign and_1990 = is_seen & less_1989_s4_q;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2024;
  assign select_2024 = sample_pair_whole_s4_q ? (and_496_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2026;
  assign select_2026 = sample_pair_whole_s4_q ? (and_496_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2028;
  assign select_2028 = sample_pair_whole_s4_q ? (and_496_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2030;
  assign select_2030 = sample_pair_whole_s4_q ? (and_496_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2035;
  assign sum_2035 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2036;
  assign difference_2036 = {1'b0, sum_2035[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2037;
  assign xor_2037 = {difference_2036[8:0], sum_2035[0]} ^ {10{difference_2036[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2036[9]} + {1'b0, xor_2037};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_501_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2042;
  assign select_2042 = sample_pair_whole_s4_q ? (and_496_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2043;
  assign sum_2043 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2044;
  assign difference_2044 = {1'b0, sum_2043[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2045;
  assign xor_2045 = {difference_2044[8:0], sum_2043[0]} ^ {10{difference_2044[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2044[9]} + {1'b0, xor_2045};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_501_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2050;
  assign select_2050 = sample_pair_whole_s4_q ? (and_496_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2133;
  assign sum_2133 = sum_2129_s4_q + {2'h0, sum_2132_s4_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2135;
  assign select_2135 = and_498_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2136;
  assign select_2136 = and_498_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2137;
  assign select_2137 = and_498_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2138;
  assign select_2138 = and_498_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2141;
  assign sum_2141 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2133};
  logic [13:0] sum_2143;
  assign sum_2143 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2141});
  // hls/stages/census.hpp:305
  logic and_2145;
  assign and_2145 = and_588_s4_q & (9'h4 < sum_2143[13:5]);
  // hls/stages/census.hpp:306
  logic and_2146;
  assign and_2146 = and_588_s4_q & less_612;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2147;
  assign sum_2147 = census_left_misses_q + {{17{and_2146}}, and_2145, 1'b0, and_2145};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2149;
  assign select_2149 = and_498_s4_q ? (equal_2140_s4_q ? 20'h0 : sum_2147) : census_left_misses_q;
  // hls/stages/agreement.hpp:263
  logic [27:0] select_2154;
  assign select_2154 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:507
  logic select_2157;
  assign select_2157 = and_498_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2160;
  assign and_2160 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:444
  logic and_2166;
  assign and_2166 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2167;
  assign and_2167 = and_2160 & and_2166;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2154[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2169;
  assign select_2169 = and_2167 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2171;
  assign select_2171 = equal_2140_s4_q ? {11'h0, select_2169} : (sharpness_sums_detail_0_q + {11'h0, select_2169});
  // hls/stages/agreement.hpp:444
  logic and_2178;
  assign and_2178 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2179;
  assign and_2179 = and_2160 & and_2178;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2154[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2181;
  assign select_2181 = and_2179 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2183;
  assign select_2183 = equal_2140_s4_q ? {11'h0, select_2181} : (sharpness_sums_detail_1_q + {11'h0, select_2181});
  logic [8:0] select_2186;
  assign select_2186 = and_2167 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2187;
  assign sum_2187 = (equal_2140_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2186};
  logic [8:0] select_2190;
  assign select_2190 = and_2179 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2191;
  assign sum_2191 = (equal_2140_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2190};
  // hls/stages/agreement.hpp:203
  logic equal_2193;
  assign equal_2193 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2194;
  assign less_2194 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2195;
  assign less_2195 = x_s4_q[4:0] < 5'h3;
  logic not_2196;
  assign not_2196 = ~x_s4_q[1];
  logic [2:0] select_2197;
  assign select_2197 = x_s4_q[0] ? {1'b0, not_2196, 1'b0} : {x_s4_q[1], 1'b0, not_2196};
  logic [5:0] select_2198;
  assign select_2198 = slot_s4_q[2] ? {select_2197[2], 1'b0, select_2197[1], 1'b0, select_2197[0], 1'b0} : {1'b0, select_2197[2], 1'b0, select_2197[1], 1'b0, select_2197[0]};
  logic [11:0] select_2199;
  assign select_2199 = slot_s4_q[1] ? {select_2198[5], 1'b0, select_2198[4], 1'b0, select_2198[3], 1'b0, select_2198[2], 1'b0, select_2198[1], 1'b0, select_2198[0], 1'b0} : {1'b0, select_2198[5], 1'b0, select_2198[4], 1'b0, select_2198[3], 1'b0, select_2198[2], 1'b0, select_2198[1], 1'b0, select_2198[0]};
  logic [23:0] select_2200;
  assign select_2200 = slot_s4_q[0] ? {select_2199[11], 1'b0, select_2199[10], 1'b0, select_2199[9], 1'b0, select_2199[8], 1'b0, select_2199[7], 1'b0, select_2199[6], 1'b0, select_2199[5], 1'b0, select_2199[4], 1'b0, select_2199[3], 1'b0, select_2199[2], 1'b0, select_2199[1], 1'b0, select_2199[0], 1'b0} : {1'b0, select_2199[11], 1'b0, select_2199[10], 1'b0, select_2199[9], 1'b0, select_2199[8], 1'b0, select_2199[7], 1'b0, select_2199[6], 1'b0, select_2199[5], 1'b0, select_2199[4], 1'b0, select_2199[3], 1'b0, select_2199[2], 1'b0, select_2199[1], 1'b0, select_2199[0]};
  // hls/stages/census.hpp:372
  logic and_2204;
  assign and_2204 = less_2195 & (~((sharpness_sums_contrast_1_q & select_2200) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2206;
  assign select_2206 = (less_2194 & and_2204) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2206};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2209;
  assign select_2209 = equal_2193 ? (less_2194 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2214;
  assign and_2214 = less_2195 & (~((sharpness_sums_contrast_0_q & select_2200) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2216;
  assign select_2216 = (less_2194 & and_2214) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2216};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2219;
  assign select_2219 = equal_2193 ? (less_2194 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2221;
  assign select_2221 = equal_2193 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2223;
  assign select_2223 = equal_2193 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2225;
  assign select_2225 = equal_2193 ? {sharpness_comparing_contrast_0_q[0], and_2214} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2227;
  assign select_2227 = equal_2193 ? {sharpness_comparing_contrast_1_q[0], and_2204} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:207
  logic select_2232;
  assign select_2232 = drew_q ? (equal_2193 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:207
  logic select_2236;
  assign select_2236 = drew_q ? (equal_2193 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2237;
  assign equal_2237 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2238;
  assign xor_2238 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2241;
  assign select_2241 = (equal_2237 | xor_2238) ? (five_times[0] & xor_2238) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2243;
  assign select_2243 = drew_q ? (equal_2193 ? select_2241 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2244;
  assign xor_2244 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2247;
  assign select_2247 = (equal_2237 | xor_2244) ? (five_times_2[0] & xor_2244) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2249;
  assign select_2249 = drew_q ? (equal_2193 ? select_2247 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2250;
  assign xor_2250 = sharpness_comparing_contrast_0_q[1] ^ and_2204;
  logic select_2253;
  assign select_2253 = (equal_2237 | xor_2250) ? (and_2204 & xor_2250) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2255;
  assign select_2255 = drew_q ? (equal_2193 ? select_2253 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2256;
  assign xor_2256 = sharpness_comparing_contrast_1_q[1] ^ and_2214;
  logic select_2259;
  assign select_2259 = (equal_2237 | xor_2256) ? (and_2214 & xor_2256) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2261;
  assign select_2261 = drew_q ? (equal_2193 ? select_2259 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2386;
  assign select_2386 = and_2380_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2384_s4_q});
  // hls/stages/patches.hpp:313
  logic and_2389;
  assign and_2389 = not_1468_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2394;
  assign and_2394 = not_1468_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2399;
  assign and_2399 = not_1468_s4_q & (drew_q & (ends_cell_s4_q & and_1880_s4_q));
  // hls/stages/agreement.hpp:1047
  logic not_2403;
  assign not_2403 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1048
  logic not_2420;
  assign not_2420 = ~(equal_1939_s4_q ? and_1960 : not_2418_s4_q);
  // hls/stages/patches.hpp:313
  logic and_2423;
  assign and_2423 = ends_cell_s4_q & (not_2403 & (centres_values_1_textured_s4_q & not_2420));
  logic and_2425;
  assign and_2425 = not_1468_s4_q & (drew_q & and_2423);
  // hls/stages/agreement.hpp:1074
  logic less_2428;
  assign less_2428 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2429;
  assign select_2429 = less_2428 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2432;
  assign select_2432 = less_2428 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2433;
  assign sum_2433 = {1'b0, select_2432} + {3'h0, select_2432[9:2]};
  logic and_2435;
  assign and_2435 = (~(select_2429[9:4] == 6'h0)) & ({sum_2433, select_2432[1:0]} < {3'h0, select_2429});
  // hls/stages/agreement.hpp:1084
  logic [9:0] select_2438;
  assign select_2438 = x_s4_q[6] ? (equal_1512_s4_q ? 10'h0 : (and_2435 ? select_2429 : 10'h0)) : 10'h0;
  // hls/stages/patches.hpp:313
  logic [9:0] select_2439;
  assign select_2439 = equal_1467_s4_q ? select_2438 : 10'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2441;
  assign select_2441 = and_2380_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2439});
  logic [13:0] select_2448;
  assign select_2448 = and_2380_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2446_s4_q});
  // hls/stages/agreement.hpp:1052
  logic and_2450;
  assign and_2450 = not_2403 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/patches.hpp:313
  logic and_2453;
  assign and_2453 = not_1468_s4_q & (drew_q & (ends_cell_s4_q & and_2450));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2455;
  assign select_2455 = and_2380_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2453});
  // hls/stages/agreement.hpp:1052
  logic and_2457;
  assign and_2457 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2420);
  // hls/stages/patches.hpp:313
  logic and_2461;
  assign and_2461 = not_1468_s4_q & (drew_q & (ends_cell_s4_q & (not_2403 & and_2457)));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2463;
  assign select_2463 = and_2380_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2461});
  // hls/stages/patches.hpp:313
  logic [7:0] select_2512;
  assign select_2512 = drew_q ? (equal_1608_s4_q ? (and_2496_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2513;
  assign select_2513 = equal_1467_s4_q ? 8'h0 : select_2512;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2515;
  assign select_2515 = and_2495_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2513[7]}}, select_2513});
  // hls/stages/patches.hpp:313
  logic and_2518;
  assign and_2518 = not_1468_s4_q & (drew_q & (and_2496_s4_q & equal_1608_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2520;
  assign select_2520 = and_2495_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2518});
  // hls/stages/registration.hpp:107
  logic and_2522;
  assign and_2522 = and_2496_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/patches.hpp:313
  logic [1:0] select_2524;
  assign select_2524 = drew_q ? (equal_1608_s4_q ? {and_2522, and_2496_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2525;
  assign select_2525 = equal_1467_s4_q ? 2'h0 : select_2524;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2526;
  assign sum_2526 = registration_half_votes_down_q + {{5{select_2525[1]}}, select_2525};
  // hls/stages/patches.hpp:313
  logic [1:0] select_2532;
  assign select_2532 = drew_q ? (equal_1608_s4_q ? {and_2530_s4_q, and_2496_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2533;
  assign select_2533 = equal_1467_s4_q ? 2'h0 : select_2532;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2534;
  assign sum_2534 = registration_half_votes_up_q + {{5{select_2533[1]}}, select_2533};
  // hls/stages/registration.hpp:107
  logic and_2537;
  assign and_2537 = and_2496_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/patches.hpp:313
  logic [1:0] select_2539;
  assign select_2539 = drew_q ? (equal_1608_s4_q ? {and_2537, and_2496_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2540;
  assign select_2540 = equal_1467_s4_q ? 2'h0 : select_2539;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2541;
  assign sum_2541 = registration_half_half_votes_down_q + {{5{select_2540[1]}}, select_2540};
  // hls/stages/patches.hpp:313
  logic [1:0] select_2546;
  assign select_2546 = drew_q ? (equal_1608_s4_q ? {and_2544_s4_q, and_2496_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2547;
  assign select_2547 = equal_1467_s4_q ? 2'h0 : select_2546;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2548;
  assign sum_2548 = registration_half_half_votes_up_q + {{5{select_2547[1]}}, select_2547};
  // hls/stages/patches.hpp:313
  logic and_2582;
  assign and_2582 = equal_1467_s4_q & (x_s4_q[6] & (not_1859_s4_q & less_1543_s4_q));
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2589;
  assign select_2589 = or_1547_s4_q ? 12'h0 : (equal_2587_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2592;
  assign select_2592 = x_s4_q[6] ? (equal_1512_s4_q ? 12'h0 : (less_1543_s4_q ? select_2589 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:313
  logic [11:0] select_2593;
  assign select_2593 = equal_1467_s4_q ? select_2592 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2594;
  assign and_2594 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_2597;
  assign and_2597 = not_1859_s4_q & (less_1543_s4_q & ({and_2594, x_s4_q[0]} == 2'h0));
  // hls/stages/patches.hpp:313
  logic and_2599;
  assign and_2599 = equal_1467_s4_q & (x_s4_q[6] & and_2597);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2601;
  assign sum_2601 = {{2{select_2593[11]}}, select_2593} + (and_2599 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2604;
  assign select_2604 = or_1547_s4_q ? 12'h0 : (equal_2587_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2607;
  assign select_2607 = x_s4_q[6] ? (equal_1512_s4_q ? 12'h0 : (less_1543_s4_q ? select_2604 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:313
  logic [11:0] select_2608;
  assign select_2608 = equal_1467_s4_q ? select_2607 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2610;
  assign sum_2610 = {{2{select_2608[11]}}, select_2608} + (and_2599 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2612;
  assign not_2612 = ~all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_2615;
  assign and_2615 = not_1859_s4_q & (less_1543_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2612, 1'b0}));
  // hls/stages/patches.hpp:313
  logic and_2621;
  assign and_2621 = equal_1467_s4_q & (x_s4_q[6] & (not_1859_s4_q & (less_1543_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_2622;
  assign not_2622 = ~and_2621;
  logic less_2623;
  assign less_2623 = $signed({9'h1, {2{not_2622}}, and_2621}) < $signed(registration_up_q[13:2]);
  logic select_2624;
  assign select_2624 = (equal_1467_s4_q & (x_s4_q[6] & and_2615)) ? less_2623 : registration_enough_q;
  // hls/stages/agreement.hpp:1084
  logic and_2628;
  assign and_2628 = x_s4_q[6] & (not_1859_s4_q & (less_1543_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:313
  logic and_2629;
  assign and_2629 = equal_1467_s4_q & and_2628;
  // hls/stages/registration.hpp:242
  logic less_2630;
  assign less_2630 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2632;
  assign less_2632 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1084
  logic and_2637;
  assign and_2637 = x_s4_q[6] & (not_1859_s4_q & (less_1543_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/patches.hpp:313
  logic and_2638;
  assign and_2638 = equal_1467_s4_q & and_2637;
  // hls/stages/agreement.hpp:1084
  logic and_2645;
  assign and_2645 = x_s4_q[6] & (not_1859_s4_q & (less_1543_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2648;
  assign equal_2648 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1084
  logic and_2651;
  assign and_2651 = not_1859_s4_q & (less_1543_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2648));
  // hls/stages/registration.hpp:244
  logic and_2655;
  assign and_2655 = (equal_1467_s4_q & (x_s4_q[6] & and_2651)) & (less_2632 | less_2630);
  // hls/stages/agreement.hpp:1084
  logic and_2660;
  assign and_2660 = not_1859_s4_q & (less_1543_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2648)));
  // hls/stages/registration.hpp:244
  logic and_2663;
  assign and_2663 = registration_votes_up_q & registration_other_down_q;
  logic select_2665;
  assign select_2665 = registration_votes_down_q ? (registration_other_up_q | and_2663) : and_2663;
  // hls/stages/registration.hpp:138
  logic and_2667;
  assign and_2667 = (equal_1467_s4_q & (x_s4_q[6] & and_2660)) & (registration_other_enough_q & select_2665);
  // hls/stages/registration.hpp:245
  logic or_2670;
  assign or_2670 = registration_moved_q | (registration_enough_q & (and_2655 | and_2667));
  // hls/stages/agreement.hpp:263
  logic [7:0] select_2754;
  assign select_2754 = sample_pair_whole_s4_q ? (equal_1598_s4_q ? patches_place_0_slope_q : select_1699[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_2759;
  assign select_2759 = sample_pair_whole_s4_q ? (equal_1598_s4_q ? patches_place_1_slope_q : select_1728[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:104
  logic select_2761;
  assign select_2761 = equal_1598_s4_q ? patches_valid_0_q : (select_1597_s4_q ? patches_valid_0_q : select_1696[0]);
  // hls/stages/agreement.hpp:263
  logic select_2764;
  assign select_2764 = sample_pair_whole_s4_q ? (and_1719 ? (sample_present_s4_q & select_2761) : select_2761) : patches_valid_0_q;
  // hls/stages/patches.hpp:104
  logic select_2766;
  assign select_2766 = equal_1598_s4_q ? patches_valid_1_q : (select_1597_s4_q ? select_1696[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_2769;
  assign select_2769 = sample_pair_whole_s4_q ? (and_1739 ? (sample_present_s4_q & select_2766) : select_2766) : patches_valid_1_q;
  logic [5:0] select_2772;
  assign select_2772 = sample_pair_whole_s4_q ? (select_1717[5] ? {1'b1, select_1717[4:0]} : (select_1717 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2775;
  assign select_2775 = sample_pair_whole_s4_q ? (select_1737[5] ? {1'b1, select_1737[4:0]} : (select_1737 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_2778;
  assign select_2778 = sample_pair_whole_s4_q ? (select_1750[4] ? {1'b1, select_1750[3:0]} : (select_1750 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2781;
  assign select_2781 = sample_pair_whole_s4_q ? (select_1755[4] ? {1'b1, select_1755[3:0]} : (select_1755 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:464
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3192_s4_q, parity_3188_s4_q, xor_3176_s4_q, parity_3148_s4_q, parity_3086_s4_q, parity_2957_s4_q} + (equal_3193_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:160
  logic [9:0] select_3197;
  assign select_3197 = equal_1680_s4_q ? patches_sums_values_0_q : (equal_1682_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3198;
  assign select_3198 = equal_1682_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3200;
  assign select_3200 = equal_1682_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3202;
  assign select_3202 = equal_1682_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3204;
  assign select_3204 = equal_1682_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3206;
  assign select_3206 = equal_1682_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3208;
  assign select_3208 = equal_1682_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3210;
  assign select_3210 = equal_1682_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3212;
  assign select_3212 = equal_1682_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3214;
  assign select_3214 = equal_1682_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3216;
  assign select_3216 = equal_1682_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3218;
  assign select_3218 = equal_1682_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3220;
  assign select_3220 = equal_1682_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3222;
  assign select_3222 = equal_1682_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3224;
  assign select_3224 = equal_1682_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3226;
  assign select_3226 = equal_1682_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3228;
  assign select_3228 = equal_1682_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:538
  logic or_3333;
  assign or_3333 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3332_s4_q;
  logic or_3336;
  assign or_3336 = equal_3324_s4_q | (less_3326_s4_q | (less_3327_s4_q | or_3333));
  // hls/stages/patches.hpp:518
  logic not_3337;
  assign not_3337 = ~or_3336;
  // hls/stages/patches.hpp:499
  logic and_3338;
  assign and_3338 = equal_1825_s4_q & not_3337;
  // hls/stages/patches.hpp:160
  logic and_3341;
  assign and_3341 = equal_1680_s4_q & (less_1822_s4_q ? (not_1824_s4_q & and_3338) : and_3338);
  // hls/stages/patches.hpp:576
  logic not_3342;
  assign not_3342 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:499
  logic and_3344;
  assign and_3344 = equal_1825_s4_q & (patches_second_s4_q & not_3337);
  // hls/stages/patches.hpp:160
  logic and_3347;
  assign and_3347 = equal_1680_s4_q & (less_1822_s4_q ? (not_1824_s4_q & and_3344) : and_3344);
  // hls/stages/patches.hpp:576
  logic not_3348;
  assign not_3348 = ~and_3347;
  // hls/stages/patches.hpp:164
  logic and_3350;
  assign and_3350 = and_3341 & (not_3342 & not_3348);
  // hls/stages/patches.hpp:578
  logic [7:0] sum_3352;
  assign sum_3352 = {7'h0, and_3350} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:536
  logic [7:0] select_3378;
  assign select_3378 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:535
  logic [5:0] select_3379;
  assign select_3379 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3380;
  assign sum_3380 = {2'h0, select_3312_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3381;
  assign sum_3381 = {select_3379[5], select_3379} + {{3{sum_3380[3]}}, sum_3380};
  // hls/stages/patches.hpp:536
  logic [17:0] product_3382;
  assign product_3382 = $signed({{10{select_3378[7]}}, select_3378}) * $signed({{8{sum_3381[6]}}, sum_3381, select_3312_s4_q[2:0]});
  // hls/stages/patches.hpp:537
  logic [13:0] difference_3383;
  assign difference_3383 = {{6{select_3377_s4_q[7]}}, select_3377_s4_q} - {product_3382[17], product_3382[17:5]};
  // hls/stages/patches.hpp:543
  logic less_3384;
  assign less_3384 = $signed({{7{difference_3354[6]}}, difference_3354}) < $signed(difference_3383);
  // hls/stages/patches.hpp:499
  logic and_3387;
  assign and_3387 = equal_1825_s4_q & (not_3337 & (~less_3384));
  // hls/stages/patches.hpp:160
  logic and_3390;
  assign and_3390 = equal_1680_s4_q & (less_1822_s4_q ? (not_1824_s4_q & and_3387) : and_3387);
  // hls/stages/patches.hpp:579
  logic and_3391;
  assign and_3391 = and_3390 & and_3350;
  logic [7:0] sum_3392;
  assign sum_3392 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3391};
  // hls/stages/patches.hpp:499
  logic and_3396;
  assign and_3396 = not_3337 & (~($signed(difference_3383) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3397;
  assign and_3397 = equal_1825_s4_q & and_3396;
  // hls/stages/patches.hpp:160
  logic and_3400;
  assign and_3400 = equal_1680_s4_q & (less_1822_s4_q ? (not_1824_s4_q & and_3397) : and_3397);
  // hls/stages/patches.hpp:580
  logic and_3401;
  assign and_3401 = and_3400 & and_3350;
  logic [7:0] sum_3402;
  assign sum_3402 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3401};
  // hls/stages/patches.hpp:164
  logic and_3404;
  assign and_3404 = and_3341 & (and_3347 & not_3342);
  // hls/stages/patches.hpp:578
  logic [7:0] sum_3406;
  assign sum_3406 = {7'h0, and_3404} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:579
  logic and_3408;
  assign and_3408 = and_3390 & and_3404;
  logic [7:0] sum_3409;
  assign sum_3409 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3408};
  // hls/stages/patches.hpp:580
  logic and_3411;
  assign and_3411 = and_3400 & and_3404;
  logic [7:0] sum_3412;
  assign sum_3412 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3411};
  // hls/stages/patches.hpp:164
  logic and_3414;
  assign and_3414 = and_3341 & (patches_lower_s4_q & not_3348);
  // hls/stages/patches.hpp:578
  logic [7:0] sum_3416;
  assign sum_3416 = {7'h0, and_3414} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:579
  logic and_3418;
  assign and_3418 = and_3390 & and_3414;
  logic [7:0] sum_3419;
  assign sum_3419 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3418};
  // hls/stages/patches.hpp:580
  logic and_3421;
  assign and_3421 = and_3400 & and_3414;
  logic [7:0] sum_3422;
  assign sum_3422 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3421};
  // hls/stages/patches.hpp:164
  logic and_3424;
  assign and_3424 = and_3341 & (patches_lower_s4_q & and_3347);
  // hls/stages/patches.hpp:578
  logic [7:0] sum_3426;
  assign sum_3426 = {7'h0, and_3424} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:579
  logic and_3428;
  assign and_3428 = and_3390 & and_3424;
  logic [7:0] sum_3429;
  assign sum_3429 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3428};
  // hls/stages/patches.hpp:580
  logic and_3431;
  assign and_3431 = and_3400 & and_3424;
  logic [7:0] sum_3432;
  assign sum_3432 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3431};
  // hls/stages/agreement.hpp:1072
  logic less_3433;
  assign less_3433 = x_s4_q[5:3] < 3'h5;
  // hls/stages/agreement.hpp:1154
  logic equal_3434;
  assign equal_3434 = x_s4_q[2:0] == 3'h0;
  // hls/stages/registration.hpp:150
  logic not_3435;
  assign not_3435 = ~x_s4_q[4];
  // hls/stages/registration.hpp:157
  logic not_3436;
  assign not_3436 = ~x_s4_q[3];
  // hls/stages/patches.hpp:176
  logic and_3437;
  assign and_3437 = not_3435 & not_3436;
  logic [1:0] select_3438;
  assign select_3438 = x_s4_q[4] ? {1'b1, x_s4_q[3]} : {not_3436, 1'b1};
  logic [3:0] select_3439;
  assign select_3439 = x_s4_q[5] ? {{2{and_3437}}, 2'h0} : {not_3436, not_3435, select_3438};
  // hls/stages/agreement.hpp:1084
  logic and_3443;
  assign and_3443 = x_s4_q[6] & (not_1859_s4_q & (less_3433 & (equal_3434 & select_3439[0])));
  // hls/stages/patches.hpp:313
  logic and_3444;
  assign and_3444 = equal_1467_s4_q & and_3443;
  // hls/stages/patches.hpp:176
  logic equal_3446;
  assign equal_3446 = x_s4_q[2:0] == 3'h1;
  // hls/stages/agreement.hpp:1084
  logic and_3450;
  assign and_3450 = x_s4_q[6] & (not_1859_s4_q & (less_3433 & (select_3439[1] & equal_3446)));
  // hls/stages/patches.hpp:313
  logic and_3451;
  assign and_3451 = equal_1467_s4_q & and_3450;
  // hls/stages/patches.hpp:560
  logic [7:0] or_3453;
  assign or_3453 = (and_3444 ? patches_quarters_0_places_q : 8'h0) | (and_3451 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1084
  logic and_3457;
  assign and_3457 = not_1859_s4_q & (less_3433 & (select_3439[2] & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/patches.hpp:313
  logic and_3459;
  assign and_3459 = equal_1467_s4_q & (x_s4_q[6] & and_3457);
  // hls/stages/agreement.hpp:1084
  logic and_3465;
  assign and_3465 = not_1859_s4_q & (less_3433 & (select_3439[3] & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:313
  logic and_3467;
  assign and_3467 = equal_1467_s4_q & (x_s4_q[6] & and_3465);
  // hls/stages/patches.hpp:560
  logic [7:0] or_3469;
  assign or_3469 = (or_3453 | (and_3459 ? patches_quarters_2_places_q : 8'h0)) | (and_3467 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:561
  logic [7:0] or_3472;
  assign or_3472 = (and_3444 ? patches_quarters_0_up_q : 8'h0) | (and_3451 ? patches_quarters_1_up_q : 8'h0);
  logic [7:0] or_3476;
  assign or_3476 = (or_3472 | (and_3459 ? patches_quarters_2_up_q : 8'h0)) | (and_3467 ? patches_quarters_3_up_q : 8'h0);
  // hls/stages/patches.hpp:562
  logic [7:0] or_3479;
  assign or_3479 = (and_3444 ? patches_quarters_0_down_q : 8'h0) | (and_3451 ? patches_quarters_1_down_q : 8'h0);
  logic [7:0] or_3483;
  assign or_3483 = (or_3479 | (and_3459 ? patches_quarters_2_down_q : 8'h0)) | (and_3467 ? patches_quarters_3_down_q : 8'h0);
  // hls/stages/patches.hpp:180
  logic [4:0] sum_3484;
  assign sum_3484 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1084
  logic and_3488;
  assign and_3488 = x_s4_q[6] & (not_1859_s4_q & (less_3433 & (sum_3484[4:2] == 3'h0)));
  // hls/stages/patches.hpp:313
  logic and_3489;
  assign and_3489 = equal_1467_s4_q & and_3488;
  logic and_3493;
  assign and_3493 = equal_1467_s4_q & (x_s4_q[6] & (not_1859_s4_q & (less_3433 & equal_3446)));
  // hls/stages/patches.hpp:557
  logic [7:0] select_3496;
  assign select_3496 = and_3489 ? (patches_word_places_q + (and_3493 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3499;
  assign select_3499 = and_3489 ? (patches_word_up_q + (and_3493 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3502;
  assign select_3502 = and_3489 ? (patches_word_down_q + (and_3493 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:544
  logic [5:0] select_3506;
  assign select_3506 = ($signed(difference_3383[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3383[5:0];
  logic [5:0] select_3507;
  assign select_3507 = ($signed(14'h10) < $signed(difference_3383)) ? 6'h10 : select_3506;
  // hls/stages/patches.hpp:499
  logic [5:0] select_3509;
  assign select_3509 = equal_1825_s4_q ? (or_3336 ? 6'h0 : select_3507) : 6'h0;
  logic [5:0] select_3511;
  assign select_3511 = less_1822_s4_q ? (equal_1823_s4_q ? 6'h0 : select_3509) : select_3509;
  // hls/stages/patches.hpp:582
  logic [5:0] select_3513;
  assign select_3513 = and_3341 ? (equal_1680_s4_q ? select_3511 : 6'h0) : 6'h0;
  logic [11:0] sum_3514;
  assign sum_3514 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3513[5]}}, select_3513};
  // hls/stages/patches.hpp:313
  logic and_3518;
  assign and_3518 = equal_1467_s4_q & (x_s4_q[6] & (not_1859_s4_q & (equal_2648 & less_3433)));
  // hls/stages/agreement.hpp:1084
  logic and_3522;
  assign and_3522 = x_s4_q[6] & (not_1859_s4_q & (less_3433 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:313
  logic and_3523;
  assign and_3523 = equal_1467_s4_q & and_3522;
  // hls/stages/patches.hpp:571
  logic [7:0] select_3525;
  assign select_3525 = and_3518 ? (and_3523 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:573
  logic or_3529;
  assign or_3529 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:570
  logic select_3531;
  assign select_3531 = and_3518 ? (and_3523 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:164
  logic and_3537;
  assign and_3537 = patches_complete_q & (equal_1467_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_3533_s4_q)));
  logic and_3538;
  assign and_3538 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:570
  logic [4:0] select_3540;
  assign select_3540 = and_3523 ? {and_3538, patches_found_q[4:1]} : (and_3518 ? {and_3538, patches_found_q[4:1]} : patches_found_q);
  // hls/stages/patches.hpp:569
  logic select_3547;
  assign select_3547 = patches_round_ends_q ? (~(patches_found_q == 5'h0)) : patches_moved_q;
  // hls/stages/agreement.hpp:1126
  logic or_3604;
  assign or_3604 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1148
  logic equal_3606;
  assign equal_3606 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1158
  logic select_3612;
  assign select_3612 = (equal_3606 & equal_3434) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_3615;
  assign sum_3615 = {1'b0, select_2432} + {2'h0, select_2432[9:1]};
  logic select_3618;
  assign select_3618 = (select_2429[9:3] == 7'h0) ? ((~or_3604) & (~select_3612)) : (~({sum_3615, select_2432[0]} < {2'h0, select_2429}));
  // hls/stages/agreement.hpp:1084
  logic [47:0] select_3620;
  assign select_3620 = x_s4_q[6] ? (equal_1512_s4_q ? good_q : {select_3618, good_q[47:1]}) : good_q;
  // hls/stages/patches.hpp:313
  logic select_3624;
  assign select_3624 = equal_1467_s4_q ? ((x_s4_q[6] & good_known_q) | equal_3533_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1148
  logic equal_3625;
  assign equal_3625 = x_s4_q[6:3] == 4'ha;
  logic equal_3627;
  assign equal_3627 = x_s4_q[6:3] == 4'h9;
  logic equal_3628;
  assign equal_3628 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3630;
  assign select_3630 = equal_3627 ? counts_skin_unproven_q : (equal_3628 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3625 ? counts_nearer_q : select_3630;
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1161
  logic select_3633;
  assign select_3633 = (equal_3625 & equal_3434) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1086
  logic not_3634;
  assign not_3634 = ~hidden_for_q[7];
  logic [7:0] select_3636;
  assign select_3636 = select_3633 ? (hidden_for_q + {7'h0, not_3634}) : 8'h0;
  // hls/stages/patches.hpp:313
  logic [7:0] select_3638;
  assign select_3638 = equal_1467_s4_q ? (equal_3533_s4_q ? select_3636 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3639;
  assign select_3639 = equal_3434 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_3641;
  assign select_3641 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3643;
  assign select_3643 = equal_3628 ? cfg_unproven_skin_limit_i : (equal_3606 ? cfg_unproven_limit_i : select_3641);
  logic [7:0] limit;
  assign limit = equal_3625 ? cfg_regions_limit_i : (equal_3627 ? cfg_hidden_limit_i : select_3643);
  // hls/stages/agreement.hpp:1161
  logic not_3646;
  assign not_3646 = ~x_s4_q[2];
  logic [3:0] select_3647;
  assign select_3647 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_3646, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_3646};
  logic [7:0] select_3648;
  assign select_3648 = x_s4_q[0] ? {select_3647[3], 1'b0, select_3647[2], 1'b0, select_3647[1], 1'b0, select_3647[0], 1'b0} : {1'b0, select_3647[3], 1'b0, select_3647[2], 1'b0, select_3647[1], 1'b0, select_3647[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3652;
  assign select_3652 = equal_3627 ? counts_skin_supervised_q : (equal_3628 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3625 ? counts_textured_q : select_3652;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3654;
  assign select_3654 = ((limit & select_3648) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3639} + {1'b0, select_3654};
  // hls/stages/patches.hpp:313
  logic select_3659;
  assign select_3659 = equal_1467_s4_q ? (equal_3434 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1159
  logic and_3664;
  assign and_3664 = too_much_q & (~(equal_3628 & equal_3434));
  // hls/stages/agreement.hpp:1160
  logic select_3669;
  assign select_3669 = (over[14] & equal_3434) ? (and_3664 | ((equal_3628 | equal_3627) | (x_s4_q[6:3] == 4'hf))) : and_3664;
  // hls/stages/agreement.hpp:1201
  logic select_3777;
  assign select_3777 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:265
  logic select_3779;
  assign select_3779 = left_first_s4_q ? done_s4_q : (and_1840_s4_q ? select_3777 : proven_q);
  // hls/stages/agreement.hpp:1234
  logic [1:0] select_3830;
  assign select_3830 = and_3829_s4_q ? {and_1990, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1235
  logic and_3831;
  assign and_3831 = select_3777 & less_3807;
  // hls/stages/agreement.hpp:424
  logic select_3834;
  assign select_3834 = and_1917_s4_q ? (less_1918_s4_q ? (select_3830[0] & and_3831) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:265
  logic select_3836;
  assign select_3836 = left_first_s4_q ? select_3834 : (and_1840_s4_q ? select_3834 : seen_q);
  logic select_3837;
  assign select_3837 = and_1840_s4_q ? select_3836 : seen_q;
  // hls/stages/agreement.hpp:424
  logic select_3840;
  assign select_3840 = and_1917_s4_q ? (less_1918_s4_q ? (select_3830[1] & and_3831) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:265
  logic select_3842;
  assign select_3842 = left_first_s4_q ? select_3840 : (and_1840_s4_q ? select_3840 : nearer_q);
  logic select_3843;
  assign select_3843 = and_1840_s4_q ? select_3842 : nearer_q;
  // hls/stages/patches.hpp:313
  logic and_3850;
  assign and_3850 = equal_1467_s4_q & (equal_3533_s4_q & (cfg_prove_i & (~proven_q)));
  // hls/stages/agreement.hpp:1170
  logic not_3855;
  assign not_3855 = ~(or_3604 | not_3844);
  // hls/stages/patches.hpp:313
  logic and_3859;
  assign and_3859 = equal_1467_s4_q & (equal_3533_s4_q & (not_3855 & (select_3612 | select_3669)));
  logic and_3862;
  assign and_3862 = equal_3533_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1088
  logic or_3866;
  assign or_3866 = select_2243 | (select_2255 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/patches.hpp:313
  logic and_3873;
  assign and_3873 = equal_1467_s4_q & (equal_3533_s4_q & (not_3855 & (select_2249 | select_2261)));
  // hls/stages/agreement.hpp:1088
  logic and_3878;
  assign and_3878 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3636 < cfg_hidden_frames_i));
  // hls/stages/patches.hpp:313
  logic and_3885;
  assign and_3885 = equal_1467_s4_q & (x_s4_q[6] & (not_1859_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3893;
  assign select_3893 = equal_1534_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_3891_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_3894;
  assign select_3894 = equal_1532_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3893;
  logic [31:0] select_3895;
  assign select_3895 = equal_1530_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3894;
  logic [31:0] select_3896;
  assign select_3896 = equal_1528_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3895;
  logic [31:0] select_3897;
  assign select_3897 = equal_1526_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3896;
  logic [31:0] select_3898;
  assign select_3898 = equal_1524_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_3897;
  logic [31:0] select_3899;
  assign select_3899 = equal_1522_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_3898;
  logic [31:0] select_3900;
  assign select_3900 = equal_1520_s4_q ? {7'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3899;
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_3901;
  assign select_3901 = less_2428 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1084
  logic [31:0] select_3902;
  assign select_3902 = equal_1512_s4_q ? select_3900 : {2'h0, select_3901, select_2432, select_2429};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_498_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_613, and_589_s4_q, and_588_s4_q, and_563_s4_q, less_555_s4_q, less_554_s4_q, less_553_s4_q, less_552_s4_q, less_551_s4_q, less_550_s4_q, less_549_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q, less_545_s4_q, less_544_s4_q, less_543_s4_q, less_542_s4_q, less_541_s4_q, less_540_s4_q, less_539_s4_q, less_538_s4_q, less_537_s4_q, less_536_s4_q, less_535_s4_q, less_534_s4_q, less_533_s4_q, less_532_s4_q};
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

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1518_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1577_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1576, sum_1572};
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

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_1606_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_1679_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1672_s4_q};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_choices_we) begin
      if (patches_choices_re && patches_choices_raddr == patches_choices_waddr) begin
        $error("patches_choices: address %0d is read less than DISTANCE steps after its write", patches_choices_waddr);
      end
    end
  end
`endif

  // Memory patches_right_0, write
  logic [9:0] patches_right_0_waddr;
  assign patches_right_0_waddr = {select_1710_s4_q, select_1707};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_1719);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s4_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_0_raddr_s2_sim;
  logic patches_right_0_re_s2_sim;
  logic [9:0] patches_right_0_raddr_s3_sim;
  logic patches_right_0_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_0_re_s2_sim <= 1'b0;
      patches_right_0_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_0_re_s2_sim <= patches_right_0_re;
      patches_right_0_raddr_s2_sim <= patches_right_0_raddr;
      patches_right_0_re_s3_sim <= patches_right_0_re_s2_sim;
      patches_right_0_raddr_s3_sim <= patches_right_0_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_0_we) begin
      if (patches_right_0_re && patches_right_0_raddr == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s2_sim && patches_right_0_raddr_s2_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s3_sim && patches_right_0_raddr_s3_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
    end
  end
`endif

  // Memory patches_right_1, write
  logic [9:0] patches_right_1_waddr;
  assign patches_right_1_waddr = {select_1710_s4_q, select_1736};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_1739);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s4_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_1_raddr_s2_sim;
  logic patches_right_1_re_s2_sim;
  logic [9:0] patches_right_1_raddr_s3_sim;
  logic patches_right_1_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_1_re_s2_sim <= 1'b0;
      patches_right_1_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_1_re_s2_sim <= patches_right_1_re;
      patches_right_1_raddr_s2_sim <= patches_right_1_raddr;
      patches_right_1_re_s3_sim <= patches_right_1_re_s2_sim;
      patches_right_1_raddr_s3_sim <= patches_right_1_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_1_we) begin
      if (patches_right_1_re && patches_right_1_raddr == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s2_sim && patches_right_1_raddr_s2_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s3_sim && patches_right_1_raddr_s3_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
    end
  end
`endif

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1758, select_1757_s4_q, column_5};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_1764);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s4_q;
  end
`ifndef SYNTHESIS
  logic [8:0] patches_left_raddr_s2_sim;
  logic patches_left_re_s2_sim;
  logic [8:0] patches_left_raddr_s3_sim;
  logic patches_left_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_re_s2_sim <= 1'b0;
      patches_left_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_re_s2_sim <= patches_left_re;
      patches_left_raddr_s2_sim <= patches_left_raddr;
      patches_left_re_s3_sim <= patches_left_re_s2_sim;
      patches_left_raddr_s3_sim <= patches_left_raddr_s2_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_we) begin
      if (patches_left_re && patches_left_raddr == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s2_sim && patches_left_raddr_s2_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s3_sim && patches_left_raddr_s3_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
    end
  end
`endif

  // Memory patches_rows, write
  logic [4:0] patches_rows_waddr;
  assign patches_rows_waddr = patches_summed_down_by_s4_q;
  logic patches_rows_we;
  assign patches_rows_we = s4_en & patches_summed_last_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1847;
  end
`ifndef SYNTHESIS
  logic [4:0] patches_rows_raddr_s3_sim;
  logic patches_rows_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_rows_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      patches_rows_re_s3_sim <= patches_rows_re;
      patches_rows_raddr_s3_sim <= patches_rows_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_rows_we) begin
      if (patches_rows_re && patches_rows_raddr == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s3_sim && patches_rows_raddr_s3_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_waddr >= 5'd17) $error("patches_rows: write outside, address %0d", patches_rows_waddr);
    end
    if (rst_ni && patches_rows_re && patches_rows_raddr >= 5'd17) $error("patches_rows: read outside, address %0d", patches_rows_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s4_q, or_1857_s4_q, or_1854_s4_q, or_1851_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1885_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1884, sum_1878, sum_1873};
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
  assign map_waddr = sum_1926_s4_q;
  logic map_we;
  assign map_we = s4_en & and_2000_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_1990, is_seen};
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
      patches_place_0_valid_q <= 1'b0;
      patches_place_0_column_q <= 7'h0;
      patches_place_0_shift_q <= 6'h0;
      patches_place_0_slope_q <= 8'h0;
      patches_place_1_valid_q <= 1'b0;
      patches_place_1_column_q <= 7'h0;
      patches_place_1_shift_q <= 6'h0;
      patches_place_1_slope_q <= 8'h0;
      patches_valid_0_q <= 1'b0;
      patches_valid_1_q <= 1'b0;
      patches_right_next_0_q <= 6'h0;
      patches_right_next_1_q <= 6'h0;
      patches_left_next_0_q <= 5'h0;
      patches_left_next_1_q <= 5'h0;
      patches_sums_values_0_q <= 10'h0;
      patches_sums_values_1_q <= 10'h0;
      patches_sums_values_2_q <= 10'h0;
      patches_sums_values_3_q <= 10'h0;
      patches_sums_values_4_q <= 10'h0;
      patches_sums_values_5_q <= 10'h0;
      patches_sums_values_6_q <= 10'h0;
      patches_sums_values_7_q <= 10'h0;
      patches_sums_values_8_q <= 10'h0;
      patches_sums_values_9_q <= 10'h0;
      patches_sums_values_10_q <= 10'h0;
      patches_sums_values_11_q <= 10'h0;
      patches_sums_values_12_q <= 10'h0;
      patches_sums_values_13_q <= 10'h0;
      patches_sums_values_14_q <= 10'h0;
      patches_sums_values_15_q <= 10'h0;
      patches_sums_values_16_q <= 10'h0;
      patches_best_differing_q <= 10'h0;
      patches_best_column_q <= 5'h0;
      patches_quarters_0_places_q <= 8'h0;
      patches_quarters_0_up_q <= 8'h0;
      patches_quarters_0_down_q <= 8'h0;
      patches_quarters_1_places_q <= 8'h0;
      patches_quarters_1_up_q <= 8'h0;
      patches_quarters_1_down_q <= 8'h0;
      patches_quarters_2_places_q <= 8'h0;
      patches_quarters_2_up_q <= 8'h0;
      patches_quarters_2_down_q <= 8'h0;
      patches_quarters_3_places_q <= 8'h0;
      patches_quarters_3_up_q <= 8'h0;
      patches_quarters_3_down_q <= 8'h0;
      patches_word_places_q <= 8'h0;
      patches_word_up_q <= 8'h0;
      patches_word_down_q <= 8'h0;
      patches_sum_places_q <= 8'h0;
      patches_sum_up_q <= 8'h0;
      patches_sum_down_q <= 8'h0;
      patches_across_q <= 12'h0;
      patches_places_q <= 8'h0;
      patches_enough_q <= 1'b0;
      patches_mostly_q <= 1'b0;
      patches_complete_q <= 1'b0;
      patches_round_ends_q <= 1'b0;
      patches_found_q <= 5'h0;
      patches_round_places_q <= 8'h0;
      patches_round_across_q <= 12'h0;
      patches_round_moved_q <= 5'h0;
      patches_moved_q <= 1'b0;
      segment_textured_q <= 6'h0;
      segment_explained_q <= 6'h0;
      segment_nearer_q <= 6'h0;
      segment_started_q <= 1'b0;
      good_q <= 48'h0;
      good_known_q <= 1'b0;
      hidden_for_q <= 8'h0;
      product_q <= 14'h0;
      product_rest_q <= 1'b0;
      disagree_q <= 1'b0;
      too_much_q <= 1'b0;
      hides_q <= 1'b0;
      proven_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s4_en) begin
      census_left_misses_q <= select_2149;
      sharpness_before_last_mask_q <= select_2157;
      sharpness_sums_detail_0_q <= and_498_s4_q ? select_2171 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_498_s4_q ? select_2183 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_498_s4_q ? sum_2187 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_498_s4_q ? sum_2191 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2209 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2219 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2221 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2223 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2225 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2227 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2232;
      sharpness_comparing_carry_1_q <= select_2236;
      sharpness_comparing_less_detail_0_q <= select_2243;
      sharpness_comparing_less_detail_1_q <= select_2249;
      sharpness_comparing_less_contrast_0_q <= select_2255;
      sharpness_comparing_less_contrast_1_q <= select_2261;
      counts_supervised_q <= select_2386;
      counts_textured_q <= and_2380_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2389});
      counts_explained_q <= and_2380_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2394});
      counts_nearer_q <= and_2380_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2399});
      counts_unproven_q <= and_2380_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2425});
      counts_regions_bad_q <= select_2441;
      counts_skin_supervised_q <= select_2448;
      counts_skin_textured_q <= select_2455;
      counts_skin_unproven_q <= select_2463;
      registration_half_across_q <= select_2515;
      registration_half_measured_q <= select_2520;
      registration_half_votes_down_q <= and_2495_s4_q ? 7'h0 : sum_2526;
      registration_half_votes_up_q <= and_2495_s4_q ? 7'h0 : sum_2534;
      registration_half_half_votes_down_q <= and_2495_s4_q ? 7'h0 : sum_2541;
      registration_half_half_votes_up_q <= and_2495_s4_q ? 7'h0 : sum_2548;
      registration_down_q <= and_2582 ? sum_2601 : registration_down_q;
      registration_up_q <= and_2582 ? sum_2610 : registration_up_q;
      registration_enough_q <= select_2624;
      registration_votes_down_q <= and_2629 ? less_2630 : registration_votes_down_q;
      registration_votes_up_q <= and_2629 ? less_2632 : registration_votes_up_q;
      registration_other_enough_q <= and_2638 ? select_2624 : registration_other_enough_q;
      registration_other_down_q <= and_2638 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2638 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1467_s4_q & and_2645)) & or_2670;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_1698 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_1700 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_1701 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2754;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_1727 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_1729 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_1730 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2759;
      patches_valid_0_q <= select_2764;
      patches_valid_1_q <= select_2769;
      patches_right_next_0_q <= select_2772;
      patches_right_next_1_q <= select_2775;
      patches_left_next_0_q <= select_2778;
      patches_left_next_1_q <= select_2781;
      patches_sums_values_0_q <= select_3197;
      patches_sums_values_1_q <= equal_1680_s4_q ? patches_sums_values_1_q : select_3198;
      patches_sums_values_2_q <= equal_1680_s4_q ? patches_sums_values_2_q : select_3200;
      patches_sums_values_3_q <= equal_1680_s4_q ? patches_sums_values_3_q : select_3202;
      patches_sums_values_4_q <= equal_1680_s4_q ? patches_sums_values_4_q : select_3204;
      patches_sums_values_5_q <= equal_1680_s4_q ? patches_sums_values_5_q : select_3206;
      patches_sums_values_6_q <= equal_1680_s4_q ? patches_sums_values_6_q : select_3208;
      patches_sums_values_7_q <= equal_1680_s4_q ? patches_sums_values_7_q : select_3210;
      patches_sums_values_8_q <= equal_1680_s4_q ? patches_sums_values_8_q : select_3212;
      patches_sums_values_9_q <= equal_1680_s4_q ? patches_sums_values_9_q : select_3214;
      patches_sums_values_10_q <= equal_1680_s4_q ? patches_sums_values_10_q : select_3216;
      patches_sums_values_11_q <= equal_1680_s4_q ? patches_sums_values_11_q : select_3218;
      patches_sums_values_12_q <= equal_1680_s4_q ? patches_sums_values_12_q : select_3220;
      patches_sums_values_13_q <= equal_1680_s4_q ? patches_sums_values_13_q : select_3222;
      patches_sums_values_14_q <= equal_1680_s4_q ? patches_sums_values_14_q : select_3224;
      patches_sums_values_15_q <= equal_1680_s4_q ? patches_sums_values_15_q : select_3226;
      patches_sums_values_16_q <= equal_1680_s4_q ? patches_sums_values_16_q : select_3228;
      patches_best_differing_q <= select_1847[9:0];
      patches_best_column_q <= select_1847[14:10];
      patches_quarters_0_places_q <= sum_3352;
      patches_quarters_0_up_q <= sum_3392;
      patches_quarters_0_down_q <= sum_3402;
      patches_quarters_1_places_q <= sum_3406;
      patches_quarters_1_up_q <= sum_3409;
      patches_quarters_1_down_q <= sum_3412;
      patches_quarters_2_places_q <= sum_3416;
      patches_quarters_2_up_q <= sum_3419;
      patches_quarters_2_down_q <= sum_3422;
      patches_quarters_3_places_q <= sum_3426;
      patches_quarters_3_up_q <= sum_3429;
      patches_quarters_3_down_q <= sum_3432;
      patches_word_places_q <= or_3469;
      patches_word_up_q <= or_3476;
      patches_word_down_q <= or_3483;
      patches_sum_places_q <= select_3496;
      patches_sum_up_q <= select_3499;
      patches_sum_down_q <= select_3502;
      patches_across_q <= sum_3514;
      patches_places_q <= select_3525;
      patches_enough_q <= {3'h0, and_3523, 1'b0} < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3529;
      patches_complete_q <= select_3531;
      patches_round_ends_q <= and_3537;
      patches_found_q <= and_3518 ? select_3540 : patches_found_q;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_moved_q <= select_3547;
      segment_textured_q <= select_1870 + {5'h0, and_2389};
      segment_explained_q <= select_1875 + {5'h0, and_2394};
      segment_nearer_q <= select_1881 + {5'h0, and_2399};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1467_s4_q ? select_3620 : good_q;
      good_known_q <= select_3624;
      hidden_for_q <= select_3638;
      product_q <= equal_1467_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3659;
      disagree_q <= equal_1467_s4_q ? select_3612 : disagree_q;
      too_much_q <= equal_1467_s4_q ? select_3669 : too_much_q;
      hides_q <= equal_1467_s4_q ? select_3633 : hides_q;
      proven_q <= and_1840_s4_q ? select_3779 : proven_q;
      seen_q <= select_3837;
      nearer_q <= select_3843;
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
      averager_quarter_1_0_q <= select_2024;
      averager_quarter_1_1_q <= select_2026;
      averager_quarter_2_0_q <= select_2028;
      averager_quarter_2_1_q <= select_2030;
      averager_detail_0_q <= select_2042;
      averager_detail_1_q <= select_2050;
      census_changes_values_0_left_q <= and_498_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_498_s4_q ? sum_2133 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2135;
      census_changes_values_1_right_q <= select_2136;
      census_changes_values_2_left_q <= select_2137;
      census_changes_values_2_right_q <= select_2138;
      sharpness_last_mask_q <= and_498_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_498_s4_q ? select_2154[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_498_s4_q ? select_2154[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_3781_s5_q;
  logic or_3845_s5_q;
  logic and_3846_s5_q;
  logic and_3850_s5_q;
  logic and_3853_s5_q;
  logic and_3859_s5_q;
  logic and_3863_s5_q;
  logic and_3869_s5_q;
  logic and_3873_s5_q;
  logic and_3881_s5_q;
  logic and_3885_s5_q;
  logic [5:0] select_3887_s5_q;
  logic [31:0] select_3904_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_3781_s5_q <= said_q;
      or_3845_s5_q <= not_3844 | select_3837;
      and_3846_s5_q <= cfg_prove_i & select_3843;
      and_3850_s5_q <= and_3850;
      and_3853_s5_q <= equal_1467_s4_q & (equal_3533_s4_q & (cfg_prove_i & or_3604));
      and_3859_s5_q <= and_3859;
      and_3863_s5_q <= equal_1467_s4_q & and_3862;
      and_3869_s5_q <= equal_1467_s4_q & (equal_3533_s4_q & (not_3855 & or_3866));
      and_3873_s5_q <= and_3873;
      and_3881_s5_q <= equal_1467_s4_q & (equal_3533_s4_q & (cfg_prove_i & and_3878));
      and_3885_s5_q <= and_3885;
      select_3887_s5_q <= equal_1467_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3904_s5_q <= equal_1467_s4_q ? (x_s4_q[6] ? select_3902 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_3845_s5_q;
  assign marks_nearer_o = and_3846_s5_q;
  assign verdict_valid_o = and_3781_s5_q;
  assign verdict_unproven_yet_o = and_3850_s5_q;
  assign verdict_untextured_o = and_3853_s5_q;
  assign verdict_disagree_o = and_3859_s5_q;
  assign verdict_moved_o = and_3863_s5_q;
  assign verdict_unsharp_left_o = and_3869_s5_q;
  assign verdict_unsharp_right_o = and_3873_s5_q;
  assign verdict_hidden_o = and_3881_s5_q;
  assign frame_valid_o = and_3885_s5_q;
  assign frame_index_o = select_3887_s5_q;
  assign frame_word_o = select_3904_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_3484[1:0], product_3382[4:0], sum_2485[0], detail_4[1:0], detail_3[1:0], sum_2143[4:0], sum_1620[0], sum_1616[0], sum_611[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
