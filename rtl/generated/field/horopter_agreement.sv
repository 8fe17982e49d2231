// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2899 bits, pipeline 894 bits, memories 58067 bits.
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
  logic [5:0] sum_2380;
  assign sum_2380 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3384;
  assign difference_3384 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_3605;
  assign difference_3605 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_3838;
  assign less_3838 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_3839;
  assign sum_3839 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_3840;
  assign select_3840 = less_3838 ? {sum_3839, cfg_height_i[5:3]} : 8'h0;
  logic not_3875;
  assign not_3875 = ~cfg_prove_i;

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
  logic [2:0] select_464;
  assign select_464 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_466;
  assign select_466 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [7:0] select_469;
  assign select_469 = ({select_466, select_464} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:116
  logic [7:0] select_470;
  assign select_470 = select_464[0] ? averager_place_q : select_469;
  // hls/stages/census.hpp:41
  logic or_471;
  assign or_471 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_474;
  assign and_474 = (select_464[0] & or_471) & (select_470 < 8'hbd);
  // hls/stages/census.hpp:41
  logic [2:0] select_479;
  assign select_479 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_466 : 6'h0;
  // hls/stages/census.hpp:50
  logic equal_496;
  assign equal_496 = select_464 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_497;
  assign equal_497 = select_479 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_498;
  assign and_498 = equal_497 & and_474;
  // hls/stages/agreement.hpp:263
  logic and_500;
  assign and_500 = sample_pair_whole_q & (equal_496 & and_498);
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:610
  logic equal_520;
  assign equal_520 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:581
  logic or_521;
  assign or_521 = so | equal_520;
  // hls/stages/agreement.hpp:704
  logic not_522;
  assign not_522 = ~or_521;
  // hls/stages/agreement.hpp:601
  logic equal_523;
  assign equal_523 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_525;
  assign equal_525 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:579
  logic [7:0] sum_526;
  assign sum_526 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_527;
  assign select_527 = run_shift_q[5] ? x_q : sum_526;
  logic less_528;
  assign less_528 = {2'h0, last_q} < select_527;
  // hls/stages/agreement.hpp:216
  logic not_529;
  assign not_529 = ~less_528;
  // hls/stages/agreement.hpp:141
  logic and_530;
  assign and_530 = equal_525 & not_529;
  logic and_532;
  assign and_532 = not_522 & ((~equal_523) & and_530);
  // hls/stages/census.hpp:41
  logic [5:0] select_559;
  assign select_559 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_559 : 6'h0;
  // hls/stages/agreement.hpp:141
  logic select_616;
  assign select_616 = equal_523 ? not_529 : and_530;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:770
  logic [6:0] sum_636;
  assign sum_636 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:141
  logic and_641;
  assign and_641 = equal_523 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_636} < select_527))));
  logic select_642;
  assign select_642 = or_521 ? not_529 : and_641;
  // hls/stages/agreement.hpp:778
  logic equal_645;
  assign equal_645 = {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:782
  logic or_647;
  assign or_647 = equal_645 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:794
  logic [5:0] right;
  assign right = sum_526[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:182
  logic and_1862;
  assign and_1862 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:263
  logic [2:0] select_2027;
  assign select_2027 = sample_pair_whole_q ? (sample_last_q ? (select_479 + 3'h1) : select_479) : raster_at_y_q;
  logic [5:0] select_2029;
  assign select_2029 = sample_pair_whole_q ? (select_466 + {5'h0, equal_496}) : raster_at_column_q;
  logic [5:0] select_2032;
  assign select_2032 = sample_pair_whole_q ? (sample_last_q ? (select_559 + {5'h0, equal_497}) : select_559) : raster_at_row_q;
  logic select_2036;
  assign select_2036 = sample_pair_whole_q ? (sample_last_q ? (or_471 & (~raster_final_row_q)) : or_471) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2038;
  assign select_2038 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:263
  logic select_2042;
  assign select_2042 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2286;
  assign equal_2286 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:451
  logic and_2287;
  assign and_2287 = and_500 & equal_2286;
  // hls/stages/agreement.hpp:510
  logic select_2290;
  assign select_2290 = (and_2287 | (~ends_cell_q)) ? and_2287 : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2290 ? (and_2287 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2294;
  assign select_2294 = select_2290 ? (and_2287 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2297;
  assign select_2297 = select_2290 ? (following_last_shift_q & (~and_2287)) : run_last_shift_q;
  // hls/stages/agreement.hpp:594
  logic and_2300;
  assign and_2300 = run_last_shift_q & equal_523;
  // hls/stages/agreement.hpp:603
  logic select_2302;
  assign select_2302 = equal_523 ? (~run_last_shift_q) : equal_525;
  // hls/stages/agreement.hpp:607
  logic equal_2303;
  assign equal_2303 = run_phase_q == 3'h1;
  logic not_2306;
  assign not_2306 = ~select_2302;
  // hls/stages/agreement.hpp:610
  logic equal_2308;
  assign equal_2308 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2309;
  assign and_2309 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2310;
  assign select_2310 = equal_2308 ? 2'h1 : {2{and_2309}};
  logic [2:0] select_2312;
  assign select_2312 = (and_2300 | (select_2302 | equal_2303)) ? (equal_2303 ? 3'h2 : {not_2306, {2{select_2302}}}) : (equal_520 ? 3'h6 : {select_2310[0], select_2310});
  // hls/stages/agreement.hpp:594
  logic and_2315;
  assign and_2315 = select_2302 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2318;
  assign select_2318 = (plan_shift_q[5] & select_2302) ? value : 7'h0;
  logic [1:0] or_2319;
  assign or_2319 = {2{so}} | select_2318[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] select_2320;
  assign select_2320 = select_2302 ? plan_columns_q : 8'h0;
  logic [6:0] or_2323;
  assign or_2323 = select_2320[6:0] | ((equal_2303 | equal_2308) ? whole_q : 7'h0);
  logic [1:0] or_2324;
  assign or_2324 = {2{and_2300}} | or_2323[3:2];
  // hls/stages/agreement.hpp:621
  logic [6:0] or_2326;
  assign or_2326 = {or_2323[6:4], or_2324, or_2323[1:0]} | (equal_520 ? drawn_q : 7'h0);
  logic [4:0] or_2327;
  assign or_2327 = {5{so}} | {or_2326[6], or_2326[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2331;
  assign not_2331 = ~run_shift_q[5];
  logic [6:0] difference_2333;
  assign difference_2333 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2334;
  assign select_2334 = equal_523 ? ({{7{not_2331}}, 1'b1} + run_span_q) : {difference_2333[6], difference_2333};
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2338;
  assign select_2338 = and_2287 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2340;
  assign select_2340 = select_2290 ? {select_2338[6], select_2338} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2343;
  assign select_2343 = select_2290 ? (and_2287 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:507
  logic [5:0] select_2351;
  assign select_2351 = and_500 ? (equal_2286 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2354;
  assign select_2354 = and_500 ? (equal_2286 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2357;
  assign select_2357 = and_500 ? (equal_2286 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2371;
  assign select_2371 = (ends_cell_q | select_2290) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_523 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2375;
  assign and_2375 = (~select_2290) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic [6:0] sum_2376;
  assign sum_2376 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:447
  logic select_2378;
  assign select_2378 = equal_2286 ? ({sum_2376[6], cfg_height_i[8:3]} == {1'b0, sum_2376[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:353
  logic or_2760;
  assign or_2760 = select_466[0] | select_559[5];
  logic [7:0] sum_2761;
  assign sum_2761 = {1'b0, select_466[2:1], or_2760, select_559[4:1]} + 8'h1;
  logic less_2762;
  assign less_2762 = {sum_2761, select_559[0], select_479, 1'b0} < {4'h0, cfg_height_i};

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1294; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 29'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_532;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:1295; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [76:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 77'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (or_521 ? not_529 : select_616);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:1296; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_523 ? sum_526[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_522 & select_616);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 46, DISTANCE 12, hls/stages/agreement.hpp:1297; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [45:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 46'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_521 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_642;
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
      left_first_q <= and_1862 ? left_first_q : marks_first_i;
      right_q <= (~and_1862) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1862;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_464 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2027;
      raster_at_column_q <= select_2029;
      raster_at_row_q <= select_2032;
      raster_at_live_q <= select_2036;
      raster_rows_left_q <= sample_pair_whole_q ? select_2038 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2042;
      averager_place_q <= sample_pair_whole_q ? select_470 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2294;
      run_last_shift_q <= select_2297;
      run_span_q <= select_2290 ? (and_2287 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2312;
      following_shift_q <= select_2302 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2315;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2318[6], or_2319, select_2318[3:0]};
      following_columns_q <= {select_2320[7], or_2327[4], or_2326[5:4], or_2327[3:0]};
      plan_shift_q <= equal_523 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2334;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2340;
      columns_left_q <= select_2343;
      last_q <= and_500 ? (equal_2286 ? column : last_q) : last_q;
      least_q <= select_2351;
      whole_q <= select_2354;
      drawn_q <= select_2357;
      age_q <= select_2290 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2290 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2371;
      ends_q <= and_2375;
      final_row_q <= and_500 ? select_2378 : final_row_q;
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
  logic [2:0] select_464_s1_q;
  logic [5:0] select_466_s1_q;
  logic [7:0] select_470_s1_q;
  logic and_474_s1_q;
  logic equal_480_s1_q;
  logic [5:0] column_s1_q;
  logic and_498_s1_q;
  logic and_500_s1_q;
  logic so_s1_q;
  logic equal_520_s1_q;
  logic or_521_s1_q;
  logic equal_523_s1_q;
  logic less_528_s1_q;
  logic not_529_s1_q;
  logic and_532_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_642_s1_q;
  logic select_649_s1_q;
  logic and_1451_s1_q;
  logic [5:0] right_s1_q;
  logic select_1460_s1_q;
  logic equal_1469_s1_q;
  logic equal_1588_s1_q;
  logic equal_2286_s1_q;
  logic and_2287_s1_q;
  logic not_2763_s1_q;
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
      select_464_s1_q <= select_464;
      select_466_s1_q <= select_466;
      select_470_s1_q <= select_470;
      and_474_s1_q <= and_474;
      equal_480_s1_q <= select_479 == 3'h0;
      column_s1_q <= column;
      and_498_s1_q <= and_498;
      and_500_s1_q <= and_500;
      so_s1_q <= so;
      equal_520_s1_q <= equal_520;
      or_521_s1_q <= or_521;
      equal_523_s1_q <= equal_523;
      less_528_s1_q <= less_528;
      not_529_s1_q <= not_529;
      and_532_s1_q <= and_532;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_642_s1_q <= select_642;
      select_649_s1_q <= or_647 ? equal_645 : (~age_q[3]);
      and_1451_s1_q <= not_522 & and_641;
      right_s1_q <= right;
      select_1460_s1_q <= or_647 ? equal_645 : ({x[7:6], last_q} == {2'h0, x[5:0]});
      equal_1469_s1_q <= run_phase_q == 3'h7;
      equal_1588_s1_q <= {or_471, select_479} == 4'hc;
      equal_2286_s1_q <= equal_2286;
      and_2287_s1_q <= and_2287;
      not_2763_s1_q <= ~less_2762;
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
  logic not_620;
  assign not_620 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:656
  logic and_621;
  assign and_621 = left_rdata_q[12] & not_620;
  logic and_622;
  assign and_622 = left_rdata_q[28] & not_620;
  logic and_623;
  assign and_623 = left_rdata_q[44] & not_620;
  logic and_624;
  assign and_624 = left_rdata_q[60] & not_620;
  // hls/stages/agreement.hpp:657
  logic and_628;
  assign and_628 = right_codes_rdata_q[12] & not_620;
  logic and_629;
  assign and_629 = right_codes_rdata_q[25] & not_620;
  logic and_630;
  assign and_630 = right_codes_rdata_q[38] & not_620;
  logic and_631;
  assign and_631 = right_codes_rdata_q[51] & not_620;
  logic and_632;
  assign and_632 = right_codes_rdata_q[64] & not_620;
  logic and_633;
  assign and_633 = right_codes_rdata_q[77] & not_620;
  // hls/stages/agreement.hpp:212
  logic and_655;
  assign and_655 = left_rdata_q[44] & not_529_s1_q;
  logic and_656;
  assign and_656 = right_codes_rdata_q[38] & not_529_s1_q;
  logic [11:0] select_657;
  assign select_657 = less_528_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_658;
  assign select_658 = less_528_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_662;
  assign select_662 = and_655 ? (and_656 ? (~(select_657 ^ select_658)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_668;
  assign parity_668 = ^select_662[5:3];
  logic parity_671;
  assign parity_671 = ^select_662[8:6];
  logic parity_674;
  assign parity_674 = ^select_662[11:3];
  // hls/stages/agreement.hpp:212
  logic and_678;
  assign and_678 = left_rdata_q[60] & not_529_s1_q;
  logic and_679;
  assign and_679 = right_codes_rdata_q[51] & not_529_s1_q;
  logic [11:0] select_680;
  assign select_680 = less_528_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_681;
  assign select_681 = less_528_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_685;
  assign select_685 = and_678 ? (and_679 ? (~(select_680 ^ select_681)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_688;
  assign parity_688 = ^select_685[8:6];
  logic parity_691;
  assign parity_691 = ^select_685[11:9];
  // hls/stages/agreement.hpp:212
  logic and_695;
  assign and_695 = left_rdata_q[76] & not_529_s1_q;
  logic and_696;
  assign and_696 = right_codes_rdata_q[64] & not_529_s1_q;
  logic [11:0] select_697;
  assign select_697 = less_528_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_698;
  assign select_698 = less_528_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_702;
  assign select_702 = and_695 ? (and_696 ? (~(select_697 ^ select_698)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_708;
  assign parity_708 = ^select_702[2:0];
  logic parity_711;
  assign parity_711 = ^select_702[5:3];
  logic parity_714;
  assign parity_714 = ^select_702[8:0];
  logic parity_720;
  assign parity_720 = ^select_702[11:9];
  logic parity_723;
  assign parity_723 = ^select_685[2:0];
  logic parity_726;
  assign parity_726 = ^{select_702[11:9], select_685[5:0]};
  logic parity_729;
  assign parity_729 = ^{select_702, select_685, select_662[2:0]};
  logic xor_730;
  assign xor_730 = parity_674 ^ parity_729;
  // hls/stages/count_bits.hpp:23
  logic or_734;
  assign or_734 = (select_662[1:0] == 2'h3) | (select_662[2] & (select_662[0] | select_662[1]));
  // hls/stages/count_bits.hpp:25
  logic or_738;
  assign or_738 = (select_685[7:6] == 2'h3) | (select_685[8] & (select_685[6] | select_685[7]));
  logic or_742;
  assign or_742 = (select_685[10:9] == 2'h3) | (select_685[11] & (select_685[9] | select_685[10]));
  // hls/stages/count_bits.hpp:23
  logic or_750;
  assign or_750 = (select_702[7:6] == 2'h3) | (select_702[8] & (~(select_702[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_754;
  assign or_754 = (select_702[1:0] == 2'h3) | (select_702[2] & (select_702[0] | select_702[1]));
  logic or_758;
  assign or_758 = (select_702[4:3] == 2'h3) | (select_702[5] & (select_702[3] | select_702[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_761;
  assign parity_761 = ^{or_758, or_754, or_750};
  // hls/stages/count_bits.hpp:23
  logic or_765;
  assign or_765 = (select_685[4:3] == 2'h3) | (select_685[5] & (select_685[3] | select_685[4]));
  // hls/stages/count_bits.hpp:25
  logic or_769;
  assign or_769 = (select_702[10:9] == 2'h3) | (select_702[11] & (select_702[9] | select_702[10]));
  logic or_773;
  assign or_773 = (select_685[1:0] == 2'h3) | (select_685[2] & (select_685[0] | select_685[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_776;
  assign parity_776 = ^{or_773, or_769, or_765};
  logic parity_779;
  assign parity_779 = ^{or_773, or_769, or_765, or_758, or_754, or_750, or_742, or_738, or_734};
  // hls/stages/count_bits.hpp:25
  logic and_780;
  assign and_780 = parity_674 & parity_729;
  logic or_784;
  assign or_784 = (parity_668 & parity_671) | ((^select_662[11:9]) & (parity_668 | parity_671));
  logic and_787;
  assign and_787 = (^{select_685[11:6], select_662[2:0]}) & (parity_714 | parity_726);
  logic or_788;
  assign or_788 = (parity_714 & parity_726) | and_787;
  // hls/stages/count_bits.hpp:23
  logic or_795;
  assign or_795 = (select_662[10:9] == 2'h3) | (select_662[11] & (select_662[9] | select_662[10]));
  // hls/stages/count_bits.hpp:25
  logic or_799;
  assign or_799 = (select_662[4:3] == 2'h3) | (select_662[5] & (select_662[3] | select_662[4]));
  logic or_803;
  assign or_803 = (select_662[7:6] == 2'h3) | (select_662[8] & (select_662[6] | select_662[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_806;
  assign parity_806 = ^{or_803, or_799, or_795};
  // hls/stages/count_bits.hpp:25
  logic or_810;
  assign or_810 = (parity_688 & parity_691) | ((^select_662[2:0]) & (parity_688 | parity_691));
  logic or_814;
  assign or_814 = (parity_708 & parity_711) | ((^select_702[8:6]) & (parity_708 | parity_711));
  logic or_818;
  assign or_818 = (parity_720 & parity_723) | ((^select_685[5:3]) & (parity_720 | parity_723));
  // hls/stages/count_bits.hpp:24
  logic parity_821;
  assign parity_821 = ^{or_818, or_814, or_810};
  logic parity_824;
  assign parity_824 = ^{or_818, or_814, or_810, or_803, or_799, or_795, or_788, or_784, and_780};
  logic xor_825;
  assign xor_825 = parity_779 ^ parity_824;
  // hls/stages/count_bits.hpp:25
  logic and_826;
  assign and_826 = parity_779 & parity_824;
  logic or_830;
  assign or_830 = (parity_761 & parity_776) | ((^{or_742, or_738, or_734}) & (parity_761 | parity_776));
  logic or_834;
  assign or_834 = (parity_806 & parity_821) | ((^{or_788, or_784, and_780}) & (parity_806 | parity_821));
  logic or_841;
  assign or_841 = (or_738 & or_742) | (or_734 & (or_738 | or_742));
  logic or_845;
  assign or_845 = (or_754 & or_758) | (or_750 & (or_754 | or_758));
  logic or_849;
  assign or_849 = (or_769 & or_773) | (or_765 & (or_769 | or_773));
  // hls/stages/count_bits.hpp:24
  logic parity_852;
  assign parity_852 = ^{or_849, or_845, or_841};
  // hls/stages/count_bits.hpp:25
  logic or_856;
  assign or_856 = (or_784 & or_788) | (and_780 & (or_784 | or_788));
  logic or_860;
  assign or_860 = (or_799 & or_803) | (or_795 & (or_799 | or_803));
  logic or_864;
  assign or_864 = (or_814 & or_818) | (or_810 & (or_814 | or_818));
  // hls/stages/count_bits.hpp:24
  logic parity_867;
  assign parity_867 = ^{or_864, or_860, or_856};
  logic parity_870;
  assign parity_870 = ^{or_864, or_860, or_856, or_849, or_845, or_841, or_834, or_830, and_826};
  // hls/stages/count_bits.hpp:25
  logic or_874;
  assign or_874 = (parity_852 & parity_867) | ((^{or_834, or_830, and_826}) & (parity_852 | parity_867));
  logic or_878;
  assign or_878 = (or_830 & or_834) | (and_826 & (or_830 | or_834));
  logic or_882;
  assign or_882 = (or_845 & or_849) | (or_841 & (or_845 | or_849));
  logic or_886;
  assign or_886 = (or_860 & or_864) | (or_856 & (or_860 | or_864));
  // hls/stages/count_bits.hpp:24
  logic parity_891;
  assign parity_891 = ^{or_886, or_882, or_878, or_874};
  // hls/stages/count_bits.hpp:25
  logic or_895;
  assign or_895 = (or_882 & or_886) | (or_878 & (or_882 | or_886));
  logic and_896;
  assign and_896 = or_874 & (^{or_886, or_882, or_878});
  // hls/stages/count_bits.hpp:24
  logic xor_897;
  assign xor_897 = or_895 ^ and_896;
  // hls/stages/count_bits.hpp:27
  logic and_898;
  assign and_898 = or_895 & and_896;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_899;
  assign select_899 = equal_523_s1_q ? {and_898, xor_897, parity_891, parity_870, xor_825, xor_730} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_521_s1_q ? 6'h0 : select_899;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_910;
  assign select_910 = (slot_s1_q[0] ? and_696 : and_679) ? (~(select_658 ^ (slot_s1_q[0] ? select_697 : select_680))) : 12'h0;
  logic [11:0] select_911;
  assign select_911 = and_655 ? select_910 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_917;
  assign parity_917 = ^select_911[5:3];
  logic parity_920;
  assign parity_920 = ^select_911[8:6];
  logic parity_923;
  assign parity_923 = ^select_911[11:3];
  // hls/stages/agreement.hpp:212
  logic and_927;
  assign and_927 = right_codes_rdata_q[77] & not_529_s1_q;
  logic [11:0] select_929;
  assign select_929 = less_528_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_933;
  assign select_933 = (slot_s1_q[0] ? and_927 : and_696) ? (~(select_681 ^ (slot_s1_q[0] ? select_929 : select_697))) : 12'h0;
  logic [11:0] select_934;
  assign select_934 = and_678 ? select_933 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_937;
  assign parity_937 = ^select_934[8:6];
  logic parity_940;
  assign parity_940 = ^select_934[11:9];
  // hls/stages/agreement.hpp:718
  logic select_945;
  assign select_945 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_529_s1_q) : and_927;
  logic [11:0] select_947;
  assign select_947 = slot_s1_q[0] ? (less_528_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_929;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_951;
  assign select_951 = and_695 ? (select_945 ? (~(select_698 ^ select_947)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_957;
  assign parity_957 = ^select_951[2:0];
  logic parity_960;
  assign parity_960 = ^select_951[5:3];
  logic parity_963;
  assign parity_963 = ^select_951[8:0];
  logic parity_969;
  assign parity_969 = ^select_951[11:9];
  logic parity_972;
  assign parity_972 = ^select_934[2:0];
  logic parity_975;
  assign parity_975 = ^{select_951[11:9], select_934[5:0]};
  logic parity_978;
  assign parity_978 = ^{select_951, select_934, select_911[2:0]};
  logic xor_979;
  assign xor_979 = parity_923 ^ parity_978;
  // hls/stages/count_bits.hpp:23
  logic or_983;
  assign or_983 = (select_911[1:0] == 2'h3) | (select_911[2] & (select_911[0] | select_911[1]));
  // hls/stages/count_bits.hpp:25
  logic or_987;
  assign or_987 = (select_934[7:6] == 2'h3) | (select_934[8] & (select_934[6] | select_934[7]));
  logic or_991;
  assign or_991 = (select_934[10:9] == 2'h3) | (select_934[11] & (select_934[9] | select_934[10]));
  // hls/stages/count_bits.hpp:23
  logic or_999;
  assign or_999 = (select_951[7:6] == 2'h3) | (select_951[8] & (~(select_951[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1003;
  assign or_1003 = (select_951[1:0] == 2'h3) | (select_951[2] & (select_951[0] | select_951[1]));
  logic or_1007;
  assign or_1007 = (select_951[4:3] == 2'h3) | (select_951[5] & (select_951[3] | select_951[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1010;
  assign parity_1010 = ^{or_1007, or_1003, or_999};
  // hls/stages/count_bits.hpp:23
  logic or_1014;
  assign or_1014 = (select_934[4:3] == 2'h3) | (select_934[5] & (select_934[3] | select_934[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1018;
  assign or_1018 = (select_951[10:9] == 2'h3) | (select_951[11] & (select_951[9] | select_951[10]));
  logic or_1022;
  assign or_1022 = (select_934[1:0] == 2'h3) | (select_934[2] & (select_934[0] | select_934[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1025;
  assign parity_1025 = ^{or_1022, or_1018, or_1014};
  logic parity_1028;
  assign parity_1028 = ^{or_1022, or_1018, or_1014, or_1007, or_1003, or_999, or_991, or_987, or_983};
  // hls/stages/count_bits.hpp:25
  logic and_1029;
  assign and_1029 = parity_923 & parity_978;
  logic or_1033;
  assign or_1033 = (parity_917 & parity_920) | ((^select_911[11:9]) & (parity_917 | parity_920));
  logic and_1036;
  assign and_1036 = (^{select_934[11:6], select_911[2:0]}) & (parity_963 | parity_975);
  logic or_1037;
  assign or_1037 = (parity_963 & parity_975) | and_1036;
  // hls/stages/count_bits.hpp:23
  logic or_1044;
  assign or_1044 = (select_911[10:9] == 2'h3) | (select_911[11] & (select_911[9] | select_911[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1048;
  assign or_1048 = (select_911[4:3] == 2'h3) | (select_911[5] & (select_911[3] | select_911[4]));
  logic or_1052;
  assign or_1052 = (select_911[7:6] == 2'h3) | (select_911[8] & (select_911[6] | select_911[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1055;
  assign parity_1055 = ^{or_1052, or_1048, or_1044};
  // hls/stages/count_bits.hpp:25
  logic or_1059;
  assign or_1059 = (parity_937 & parity_940) | ((^select_911[2:0]) & (parity_937 | parity_940));
  logic or_1063;
  assign or_1063 = (parity_957 & parity_960) | ((^select_951[8:6]) & (parity_957 | parity_960));
  logic or_1067;
  assign or_1067 = (parity_969 & parity_972) | ((^select_934[5:3]) & (parity_969 | parity_972));
  // hls/stages/count_bits.hpp:24
  logic parity_1070;
  assign parity_1070 = ^{or_1067, or_1063, or_1059};
  logic parity_1073;
  assign parity_1073 = ^{or_1067, or_1063, or_1059, or_1052, or_1048, or_1044, or_1037, or_1033, and_1029};
  logic xor_1074;
  assign xor_1074 = parity_1028 ^ parity_1073;
  // hls/stages/count_bits.hpp:25
  logic and_1075;
  assign and_1075 = parity_1028 & parity_1073;
  logic or_1079;
  assign or_1079 = (parity_1010 & parity_1025) | ((^{or_991, or_987, or_983}) & (parity_1010 | parity_1025));
  logic or_1083;
  assign or_1083 = (parity_1055 & parity_1070) | ((^{or_1037, or_1033, and_1029}) & (parity_1055 | parity_1070));
  logic or_1090;
  assign or_1090 = (or_987 & or_991) | (or_983 & (or_987 | or_991));
  logic or_1094;
  assign or_1094 = (or_1003 & or_1007) | (or_999 & (or_1003 | or_1007));
  logic or_1098;
  assign or_1098 = (or_1018 & or_1022) | (or_1014 & (or_1018 | or_1022));
  // hls/stages/count_bits.hpp:24
  logic parity_1101;
  assign parity_1101 = ^{or_1098, or_1094, or_1090};
  // hls/stages/count_bits.hpp:25
  logic or_1105;
  assign or_1105 = (or_1033 & or_1037) | (and_1029 & (or_1033 | or_1037));
  logic or_1109;
  assign or_1109 = (or_1048 & or_1052) | (or_1044 & (or_1048 | or_1052));
  logic or_1113;
  assign or_1113 = (or_1063 & or_1067) | (or_1059 & (or_1063 | or_1067));
  // hls/stages/count_bits.hpp:24
  logic parity_1116;
  assign parity_1116 = ^{or_1113, or_1109, or_1105};
  logic parity_1119;
  assign parity_1119 = ^{or_1113, or_1109, or_1105, or_1098, or_1094, or_1090, or_1083, or_1079, and_1075};
  // hls/stages/count_bits.hpp:25
  logic or_1123;
  assign or_1123 = (parity_1101 & parity_1116) | ((^{or_1083, or_1079, and_1075}) & (parity_1101 | parity_1116));
  logic or_1127;
  assign or_1127 = (or_1079 & or_1083) | (and_1075 & (or_1079 | or_1083));
  logic or_1131;
  assign or_1131 = (or_1094 & or_1098) | (or_1090 & (or_1094 | or_1098));
  logic or_1135;
  assign or_1135 = (or_1109 & or_1113) | (or_1105 & (or_1109 | or_1113));
  // hls/stages/count_bits.hpp:24
  logic parity_1140;
  assign parity_1140 = ^{or_1135, or_1131, or_1127, or_1123};
  // hls/stages/count_bits.hpp:25
  logic or_1144;
  assign or_1144 = (or_1131 & or_1135) | (or_1127 & (or_1131 | or_1135));
  logic and_1145;
  assign and_1145 = or_1123 & (^{or_1135, or_1131, or_1127});
  // hls/stages/count_bits.hpp:24
  logic xor_1146;
  assign xor_1146 = or_1144 ^ and_1145;
  // hls/stages/count_bits.hpp:27
  logic and_1147;
  assign and_1147 = or_1144 & and_1145;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1148;
  assign select_1148 = equal_523_s1_q ? {and_1147, xor_1146, parity_1140, parity_1119, xor_1074, xor_979} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_521_s1_q ? 6'h0 : select_1148;
  // hls/stages/agreement.hpp:212
  logic and_1156;
  assign and_1156 = right_codes_rdata_q[25] & not_529_s1_q;
  // hls/stages/agreement.hpp:718
  logic select_1157;
  assign select_1157 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_529_s1_q) : and_1156;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1159;
  assign select_1159 = less_528_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:718
  logic [11:0] select_1160;
  assign select_1160 = slot_s1_q[0] ? (less_528_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1159;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1164;
  assign select_1164 = and_655 ? (select_1157 ? (~(select_658 ^ select_1160)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1170;
  assign parity_1170 = ^select_1164[5:3];
  logic parity_1173;
  assign parity_1173 = ^select_1164[8:6];
  logic parity_1176;
  assign parity_1176 = ^select_1164[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1184;
  assign select_1184 = (slot_s1_q[0] ? and_1156 : and_656) ? (~(select_681 ^ (slot_s1_q[0] ? select_1159 : select_657))) : 12'h0;
  logic [11:0] select_1185;
  assign select_1185 = and_678 ? select_1184 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1188;
  assign parity_1188 = ^select_1185[8:6];
  logic parity_1191;
  assign parity_1191 = ^select_1185[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1199;
  assign select_1199 = (slot_s1_q[0] ? and_656 : and_679) ? (~(select_698 ^ (slot_s1_q[0] ? select_657 : select_680))) : 12'h0;
  logic [11:0] select_1200;
  assign select_1200 = and_695 ? select_1199 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1206;
  assign parity_1206 = ^select_1200[2:0];
  logic parity_1209;
  assign parity_1209 = ^select_1200[5:3];
  logic parity_1212;
  assign parity_1212 = ^select_1200[8:0];
  logic parity_1218;
  assign parity_1218 = ^select_1200[11:9];
  logic parity_1221;
  assign parity_1221 = ^select_1185[2:0];
  logic parity_1224;
  assign parity_1224 = ^{select_1200[11:9], select_1185[5:0]};
  logic parity_1227;
  assign parity_1227 = ^{select_1200, select_1185, select_1164[2:0]};
  logic xor_1228;
  assign xor_1228 = parity_1176 ^ parity_1227;
  // hls/stages/count_bits.hpp:23
  logic or_1232;
  assign or_1232 = (select_1164[1:0] == 2'h3) | (select_1164[2] & (select_1164[0] | select_1164[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1236;
  assign or_1236 = (select_1185[7:6] == 2'h3) | (select_1185[8] & (select_1185[6] | select_1185[7]));
  logic or_1240;
  assign or_1240 = (select_1185[10:9] == 2'h3) | (select_1185[11] & (select_1185[9] | select_1185[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1248;
  assign or_1248 = (select_1200[7:6] == 2'h3) | (select_1200[8] & (~(select_1200[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1252;
  assign or_1252 = (select_1200[1:0] == 2'h3) | (select_1200[2] & (select_1200[0] | select_1200[1]));
  logic or_1256;
  assign or_1256 = (select_1200[4:3] == 2'h3) | (select_1200[5] & (select_1200[3] | select_1200[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1259;
  assign parity_1259 = ^{or_1256, or_1252, or_1248};
  // hls/stages/count_bits.hpp:23
  logic or_1263;
  assign or_1263 = (select_1185[4:3] == 2'h3) | (select_1185[5] & (select_1185[3] | select_1185[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1267;
  assign or_1267 = (select_1200[10:9] == 2'h3) | (select_1200[11] & (select_1200[9] | select_1200[10]));
  logic or_1271;
  assign or_1271 = (select_1185[1:0] == 2'h3) | (select_1185[2] & (select_1185[0] | select_1185[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1274;
  assign parity_1274 = ^{or_1271, or_1267, or_1263};
  logic parity_1277;
  assign parity_1277 = ^{or_1271, or_1267, or_1263, or_1256, or_1252, or_1248, or_1240, or_1236, or_1232};
  // hls/stages/count_bits.hpp:25
  logic and_1278;
  assign and_1278 = parity_1176 & parity_1227;
  logic or_1282;
  assign or_1282 = (parity_1170 & parity_1173) | ((^select_1164[11:9]) & (parity_1170 | parity_1173));
  logic and_1285;
  assign and_1285 = (^{select_1185[11:6], select_1164[2:0]}) & (parity_1212 | parity_1224);
  logic or_1286;
  assign or_1286 = (parity_1212 & parity_1224) | and_1285;
  // hls/stages/count_bits.hpp:23
  logic or_1293;
  assign or_1293 = (select_1164[10:9] == 2'h3) | (select_1164[11] & (select_1164[9] | select_1164[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1297;
  assign or_1297 = (select_1164[4:3] == 2'h3) | (select_1164[5] & (select_1164[3] | select_1164[4]));
  logic or_1301;
  assign or_1301 = (select_1164[7:6] == 2'h3) | (select_1164[8] & (select_1164[6] | select_1164[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1304;
  assign parity_1304 = ^{or_1301, or_1297, or_1293};
  // hls/stages/count_bits.hpp:25
  logic or_1308;
  assign or_1308 = (parity_1188 & parity_1191) | ((^select_1164[2:0]) & (parity_1188 | parity_1191));
  logic or_1312;
  assign or_1312 = (parity_1206 & parity_1209) | ((^select_1200[8:6]) & (parity_1206 | parity_1209));
  logic or_1316;
  assign or_1316 = (parity_1218 & parity_1221) | ((^select_1185[5:3]) & (parity_1218 | parity_1221));
  // hls/stages/count_bits.hpp:24
  logic parity_1319;
  assign parity_1319 = ^{or_1316, or_1312, or_1308};
  logic parity_1322;
  assign parity_1322 = ^{or_1316, or_1312, or_1308, or_1301, or_1297, or_1293, or_1286, or_1282, and_1278};
  logic xor_1323;
  assign xor_1323 = parity_1277 ^ parity_1322;
  // hls/stages/count_bits.hpp:25
  logic and_1324;
  assign and_1324 = parity_1277 & parity_1322;
  logic or_1328;
  assign or_1328 = (parity_1259 & parity_1274) | ((^{or_1240, or_1236, or_1232}) & (parity_1259 | parity_1274));
  logic or_1332;
  assign or_1332 = (parity_1304 & parity_1319) | ((^{or_1286, or_1282, and_1278}) & (parity_1304 | parity_1319));
  logic or_1339;
  assign or_1339 = (or_1236 & or_1240) | (or_1232 & (or_1236 | or_1240));
  logic or_1343;
  assign or_1343 = (or_1252 & or_1256) | (or_1248 & (or_1252 | or_1256));
  logic or_1347;
  assign or_1347 = (or_1267 & or_1271) | (or_1263 & (or_1267 | or_1271));
  // hls/stages/count_bits.hpp:24
  logic parity_1350;
  assign parity_1350 = ^{or_1347, or_1343, or_1339};
  // hls/stages/count_bits.hpp:25
  logic or_1354;
  assign or_1354 = (or_1282 & or_1286) | (and_1278 & (or_1282 | or_1286));
  logic or_1358;
  assign or_1358 = (or_1297 & or_1301) | (or_1293 & (or_1297 | or_1301));
  logic or_1362;
  assign or_1362 = (or_1312 & or_1316) | (or_1308 & (or_1312 | or_1316));
  // hls/stages/count_bits.hpp:24
  logic parity_1365;
  assign parity_1365 = ^{or_1362, or_1358, or_1354};
  logic parity_1368;
  assign parity_1368 = ^{or_1362, or_1358, or_1354, or_1347, or_1343, or_1339, or_1332, or_1328, and_1324};
  // hls/stages/count_bits.hpp:25
  logic or_1372;
  assign or_1372 = (parity_1350 & parity_1365) | ((^{or_1332, or_1328, and_1324}) & (parity_1350 | parity_1365));
  logic or_1376;
  assign or_1376 = (or_1328 & or_1332) | (and_1324 & (or_1328 | or_1332));
  logic or_1380;
  assign or_1380 = (or_1343 & or_1347) | (or_1339 & (or_1343 | or_1347));
  logic or_1384;
  assign or_1384 = (or_1358 & or_1362) | (or_1354 & (or_1358 | or_1362));
  // hls/stages/count_bits.hpp:24
  logic parity_1389;
  assign parity_1389 = ^{or_1384, or_1380, or_1376, or_1372};
  // hls/stages/count_bits.hpp:25
  logic or_1393;
  assign or_1393 = (or_1380 & or_1384) | (or_1376 & (or_1380 | or_1384));
  logic and_1394;
  assign and_1394 = or_1372 & (^{or_1384, or_1380, or_1376});
  // hls/stages/count_bits.hpp:24
  logic xor_1395;
  assign xor_1395 = or_1393 ^ and_1394;
  // hls/stages/count_bits.hpp:27
  logic and_1396;
  assign and_1396 = or_1393 & and_1394;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1397;
  assign select_1397 = equal_523_s1_q ? {and_1396, xor_1395, parity_1389, parity_1368, xor_1323, xor_1228} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_521_s1_q ? 6'h0 : select_1397;
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:929
  logic [5:0] select_1455;
  assign select_1455 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:932
  logic and_1475;
  assign and_1475 = (or_521_s1_q & (left_rdata_q[61] & not_529_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1497;
  assign or_1497 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/patches.hpp:322
  logic [5:0] select_1508;
  assign select_1508 = so_s1_q ? x_s1_q[5:0] : (or_521_s1_q ? (less_528_s1_q ? 6'h0 : select_1455) : 6'h0);
  // hls/stages/patches.hpp:104
  logic and_1582;
  assign and_1582 = (select_464_s1_q == 3'h0) & (select_466_s1_q == 6'h0);
  // hls/stages/patches.hpp:374
  logic not_1583;
  assign not_1583 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_1586;
  assign not_1586 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:344
  logic and_1587;
  assign and_1587 = patches_capturing_q & not_1586;
  // hls/stages/patches.hpp:294
  logic equal_1590;
  assign equal_1590 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:107
  logic and_1595;
  assign and_1595 = (not_1583 & (patches_work_q == 3'h0)) & (~(and_1587 | ((~equal_1588_s1_q) | (~equal_1590))));
  // hls/stages/patches.hpp:512
  logic equal_1682;
  assign equal_1682 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:490
  logic not_1683;
  assign not_1683 = ~equal_1682;
  // hls/stages/patches.hpp:483
  logic equal_1684;
  assign equal_1684 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:436
  logic not_1685;
  assign not_1685 = ~equal_1684;
  // hls/stages/patches.hpp:477
  logic equal_1686;
  assign equal_1686 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:149
  logic equal_1687;
  assign equal_1687 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:512
  logic or_1688;
  assign or_1688 = equal_1686 | equal_1687;
  // hls/stages/patches.hpp:438
  logic not_1689;
  assign not_1689 = ~patches_second_q;
  // hls/stages/patches.hpp:355
  logic [4:0] select_1711;
  assign select_1711 = and_1595 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:108
  logic [4:0] select_1712;
  assign select_1712 = and_1582 ? select_1711 : patches_row_q;
  // hls/stages/patches.hpp:107
  logic and_1714;
  assign and_1714 = and_1587 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:108
  logic select_1718;
  assign select_1718 = and_1582 ? (and_1595 | (and_1587 & (~and_1714))) : patches_capturing_q;
  // hls/stages/patches.hpp:166
  logic and_1726;
  assign and_1726 = not_1683 & (not_1685 & (or_1688 & (patches_second_q & equal_1687)));
  // hls/stages/patches.hpp:149
  logic not_1743;
  assign not_1743 = ~equal_1687;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1759;
  assign select_1759 = and_1582 ? {select_1711[4], select_1711[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:436
  logic and_1769;
  assign and_1769 = not_1683 & (or_1688 & not_1685);
  // hls/stages/agreement.hpp:447
  logic select_2383;
  assign select_2383 = equal_2286_s1_q ? (~({row_s1_q, 1'b0} < {sum_2380, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2588;
  assign and_2588 = and_500_s1_q & (equal_2286_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:300
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:108
  logic [3:0] select_2698;
  assign select_2698 = and_1582 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2699;
  assign select_2699 = sample_pair_whole_s1_q ? select_2698 : patches_phase_q;
  // hls/stages/patches.hpp:355
  logic and_2700;
  assign and_2700 = not_1586 & equal_1588_s1_q;
  logic [8:0] select_2701;
  assign select_2701 = and_2700 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2702;
  assign select_2702 = and_2700 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2703;
  assign select_2703 = sample_pair_first_s1_q ? select_2701 : select_2702;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2705;
  assign select_2705 = sample_pair_whole_s1_q ? (and_1582 ? select_2703[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2707;
  assign select_2707 = sample_pair_whole_s1_q ? (and_1582 ? select_2703[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2710;
  assign select_2710 = sample_pair_whole_s1_q ? (equal_1590 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2712;
  assign select_2712 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_1590}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:313
  logic equal_2713;
  assign equal_2713 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:314
  logic not_2714;
  assign not_2714 = ~equal_2713;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2716;
  assign select_2716 = sample_pair_whole_s1_q ? (phase + {not_2714, 1'b1, not_2714, equal_2713}) : patches_first_band_rows_to_next_q;
  logic select_2717;
  assign select_2717 = sample_pair_whole_s1_q ? equal_2713 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:457
  logic equal_2718;
  assign equal_2718 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:69
  logic [3:0] select_2722;
  assign select_2722 = equal_2718 ? ((select_2699 == 4'h6) ? 4'h0 : (select_2699 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2723;
  assign equal_2723 = select_2722 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_2726;
  assign select_2726 = equal_2286_s1_q ? (equal_2723 ? 4'h6 : (select_2722 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:69
  logic [4:0] select_2728;
  assign select_2728 = equal_2718 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_2730;
  assign select_2730 = equal_2286_s1_q ? (select_2728 + {4'h0, equal_2723}) : patches_choosing_number_q;
  logic select_2734;
  assign select_2734 = equal_2286_s1_q ? ((6'h2 < row_s1_q) & equal_2723) : patches_chooses_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_2737;
  assign select_2737 = and_500_s1_q ? (equal_2286_s1_q ? select_2728 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:108
  logic select_2765;
  assign select_2765 = and_1582 ? (and_1595 ? not_2763_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:375
  logic or_2804;
  assign or_2804 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:377
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:169
  logic and_2810;
  assign and_2810 = equal_1682 & not_1689;
  // hls/stages/patches.hpp:381
  logic and_2811;
  assign and_2811 = not_1743 & and_2810;
  logic [1:0] select_2813;
  assign select_2813 = equal_1684 ? 2'h0 : (equal_1686 ? 2'h3 : {equal_1687, and_2811});
  // hls/stages/patches.hpp:262
  logic equal_2815;
  assign equal_2815 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:260
  logic not_2816;
  assign not_2816 = ~equal_2815;
  // hls/stages/patches.hpp:262
  logic equal_2817;
  assign equal_2817 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:258
  logic not_2818;
  assign not_2818 = ~equal_2817;
  // hls/stages/patches.hpp:266
  logic not_2820;
  assign not_2820 = ~(patches_following_q == 3'h2);
  logic and_2823;
  assign and_2823 = (~(patches_following_q == 3'h1)) & not_2820;
  // hls/stages/patches.hpp:379
  logic [1:0] select_2824;
  assign select_2824 = equal_2817 ? 2'h2 : {and_2823, not_2820};
  logic [3:0] select_2825;
  assign select_2825 = equal_2815 ? 4'h2 : {select_2824, {2{not_2818}}};
  // hls/stages/patches.hpp:387
  logic not_2828;
  assign not_2828 = ~or_2804;
  // hls/stages/patches.hpp:376
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:388
  logic [11:0] select_2833;
  assign select_2833 = or_2804 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:169
  logic [4:0] select_2835;
  assign select_2835 = or_2804 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1298; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_521_s1_q ? select_1455 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_642_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:737; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s1_en & (not_1683 & (not_1685 & (or_1688 & (equal_1687 & not_1689))));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:737; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s1_en & and_1726;
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:738; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s1_en & (not_1683 & (not_1685 & (not_1743 & or_1688)));
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:749; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 32'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s1_en & and_1769;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_532_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_624, left_rdata_q[59:45], and_623, left_rdata_q[43:29], and_622, left_rdata_q[27:13], and_621, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_532_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_633, right_codes_rdata_q[76:65], and_632, right_codes_rdata_q[63:52], and_631, right_codes_rdata_q[50:39], and_630, right_codes_rdata_q[37:26], and_629, right_codes_rdata_q[24:13], and_628, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_500_s1_q ? (equal_2286_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_500_s1_q ? select_2383 : lower_half_q;
      patches_phase_q <= select_2699;
      patches_band_rows_rows_to_next_q <= select_2705;
      patches_band_rows_number_q <= select_2707;
      patches_next_band_rows_to_next_q <= select_2710;
      patches_next_band_number_q <= select_2712;
      patches_first_band_rows_to_next_q <= select_2716;
      patches_first_band_number_q <= select_2717;
      patches_choosing_rows_to_next_q <= and_500_s1_q ? select_2726 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_500_s1_q ? select_2730 : patches_choosing_number_q;
      patches_chooses_q <= and_500_s1_q ? select_2734 : patches_chooses_q;
      patches_choosing_band_q <= select_2737;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_1718 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_2765 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_1712 : patches_row_q;
      patches_work_q <= or_2804 ? following : patches_work_q;
      patches_second_q <= not_1583 & (patches_second_q | (patches_ends_q & equal_1682));
      patches_following_q <= equal_1682 ? {2'h0, and_2810} : {equal_1684, select_2813};
      patches_following_beats_q <= {select_2825, not_2816};
      patches_begins_q <= sample_pair_whole_s1_q & (and_1582 & and_1714);
      patches_ends_q <= not_2828 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2833;
      patches_code_row_q <= select_2835;
      patches_column_q <= or_2804 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2828 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_464_s2_q;
  logic [5:0] select_466_s2_q;
  logic [7:0] select_470_s2_q;
  logic and_474_s2_q;
  logic equal_480_s2_q;
  logic [5:0] column_s2_q;
  logic and_498_s2_q;
  logic and_500_s2_q;
  logic so_s2_q;
  logic equal_520_s2_q;
  logic or_521_s2_q;
  logic less_528_s2_q;
  logic not_529_s2_q;
  logic equal_561_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_649_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1150_s2_q;
  logic [5:0] select_1399_s2_q;
  logic and_1451_s2_q;
  logic [5:0] right_s2_q;
  logic select_1460_s2_q;
  logic equal_1469_s2_q;
  logic and_1476_s2_q;
  logic and_1479_s2_q;
  logic and_1483_s2_q;
  logic or_1497_s2_q;
  logic [5:0] select_1508_s2_q;
  logic and_1582_s2_q;
  logic and_1595_s2_q;
  logic less_1609_s2_q;
  logic equal_1682_s2_q;
  logic not_1683_s2_q;
  logic equal_1684_s2_q;
  logic not_1685_s2_q;
  logic equal_1686_s2_q;
  logic equal_1687_s2_q;
  logic or_1688_s2_q;
  logic [4:0] select_1712_s2_q;
  logic select_1718_s2_q;
  logic [3:0] select_1759_s2_q;
  logic and_1769_s2_q;
  logic and_1862_s2_q;
  logic select_1864_s2_q;
  logic and_1867_s2_q;
  logic and_2016_s2_q;
  logic equal_2162_s2_q;
  logic equal_2286_s2_q;
  logic and_2589_s2_q;
  logic and_2591_s2_q;
  logic or_2804_s2_q;
  logic not_2828_s2_q;
  logic less_3583_s2_q;
  logic equal_3788_s2_q;
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
      select_464_s2_q <= select_464_s1_q;
      select_466_s2_q <= select_466_s1_q;
      select_470_s2_q <= select_470_s1_q;
      and_474_s2_q <= and_474_s1_q;
      equal_480_s2_q <= equal_480_s1_q;
      column_s2_q <= column_s1_q;
      and_498_s2_q <= and_498_s1_q;
      and_500_s2_q <= and_500_s1_q;
      so_s2_q <= so_s1_q;
      equal_520_s2_q <= equal_520_s1_q;
      or_521_s2_q <= or_521_s1_q;
      less_528_s2_q <= less_528_s1_q;
      not_529_s2_q <= not_529_s1_q;
      equal_561_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_649_s2_q <= select_649_s1_q;
      column_2_s2_q <= column_2;
      select_1150_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1399_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1451_s2_q <= and_1451_s1_q;
      right_s2_q <= right_s1_q;
      select_1460_s2_q <= select_1460_s1_q;
      equal_1469_s2_q <= equal_1469_s1_q;
      and_1476_s2_q <= not_529_s1_q & and_1475;
      and_1479_s2_q <= (or_521_s1_q & (left_rdata_q[62] & not_529_s1_q)) & and_1475;
      and_1483_s2_q <= not_529_s1_q & (or_521_s1_q & (left_rdata_q[63] & not_529_s1_q));
      or_1497_s2_q <= or_1497;
      select_1508_s2_q <= select_1508;
      and_1582_s2_q <= and_1582;
      and_1595_s2_q <= and_1595;
      less_1609_s2_q <= 5'h4 < row_q[5:1];
      equal_1682_s2_q <= equal_1682;
      not_1683_s2_q <= not_1683;
      equal_1684_s2_q <= equal_1684;
      not_1685_s2_q <= not_1685;
      equal_1686_s2_q <= equal_1686;
      equal_1687_s2_q <= equal_1687;
      or_1688_s2_q <= or_1688;
      select_1712_s2_q <= select_1712;
      select_1718_s2_q <= select_1718;
      select_1759_s2_q <= select_1759;
      and_1769_s2_q <= and_1769;
      and_1862_s2_q <= sample_pair_whole_q;
      select_1864_s2_q <= left_first_q;
      and_1867_s2_q <= right_q;
      and_2016_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2162_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_2286_s2_q <= equal_2286_s1_q;
      and_2589_s2_q <= and_2287_s1_q & and_2588;
      and_2591_s2_q <= and_2287_s1_q & (~and_2588);
      or_2804_s2_q <= or_2804;
      not_2828_s2_q <= not_2828;
      less_3583_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3788_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic and_475;
  assign and_475 = sample_pair_whole_s2_q & and_474_s2_q;
  // hls/stages/agreement.hpp:772
  logic not_651;
  assign not_651 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_652;
  assign less_652 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:231
  logic and_654;
  assign and_654 = not_651 & (~less_652);
  // hls/stages/agreement.hpp:762
  logic [5:0] select_901;
  assign select_901 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_902;
  assign difference_902 = {1'b0, column_2_s2_q} - {1'b0, select_901};
  logic [7:0] sum_904;
  assign sum_904 = {difference_902[6], difference_902} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:739
  logic [7:0] select_905;
  assign select_905 = slot_s2_q[0] ? chosen_score_q : sum_904;
  // hls/stages/agreement.hpp:762
  logic [6:0] difference_1151;
  assign difference_1151 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1150_s2_q};
  // hls/stages/agreement.hpp:733
  logic equal_1152;
  assign equal_1152 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:762
  logic [7:0] sum_1154;
  assign sum_1154 = {difference_1151[6], difference_1151} + (equal_1152 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1400;
  assign difference_1400 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1399_s2_q};
  logic [7:0] sum_1402;
  assign sum_1402 = {difference_1400[6], difference_1400} + (equal_1152 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:735
  logic less_1403;
  assign less_1403 = sum_1154 < sum_1402;
  logic [7:0] select_1404;
  assign select_1404 = less_1403 ? sum_1402 : sum_1154;
  logic less_1405;
  assign less_1405 = select_905 < select_1404;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_654 ? (less_1405 ? select_1404 : select_905) : 8'h0;
  // hls/stages/agreement.hpp:783
  logic or_1409;
  assign or_1409 = select_649_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1410;
  assign select_1410 = or_1409 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:704
  logic not_1411;
  assign not_1411 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:736
  logic [1:0] select_1412;
  assign select_1412 = less_1403 ? {slot_s2_q[0], not_1411} : 2'h0;
  logic [2:0] select_1414;
  assign select_1414 = less_1405 ? {select_1412, not_1411} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:788
  logic [2:0] select_1415;
  assign select_1415 = or_1409 ? select_1414 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1416;
  assign select_1416 = or_1409 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:785
  logic equal_1417;
  assign equal_1417 = select_1414 == 3'h1;
  logic equal_1418;
  assign equal_1418 = select_1414 == 3'h2;
  logic not_1419;
  assign not_1419 = ~equal_1418;
  logic [2:0] select_1420;
  assign select_1420 = equal_1417 ? 3'h2 : {not_1419, {2{equal_1418}}};
  // hls/stages/agreement.hpp:227
  logic [7:0] select_1423;
  assign select_1423 = slot_s2_q[0] ? 8'h0 : sum_904;
  // hls/stages/agreement.hpp:785
  logic [7:0] select_1425;
  assign select_1425 = select_1420[1] ? (select_1420[0] ? before_1_q : sum_1154) : (select_1420[0] ? sum_1154 : select_1423);
  logic [7:0] select_1426;
  assign select_1426 = select_1420[2] ? (select_1420[0] ? before_2_q : before_0_q) : select_1425;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1427;
  assign select_1427 = or_1409 ? select_1426 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:786
  logic [1:0] select_1428;
  assign select_1428 = equal_1417 ? 2'h0 : {not_1419, equal_1418};
  logic [7:0] select_1430;
  assign select_1430 = select_1428[1] ? sum_1402 : (select_1428[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1431;
  assign select_1431 = or_1409 ? select_1430 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1433;
  assign sum_1433 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1434;
  assign sum_1434 = {1'b0, before_v} + sum_1433;
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1435;
  assign select_1435 = slot_s2_q[0] ? chosen_near_q : sum_1434;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1437;
  assign sum_1437 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1438;
  assign sum_1438 = {1'b0, before_v_2} + sum_1437;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1440;
  assign sum_1440 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1441;
  assign sum_1441 = {1'b0, before_v_3} + sum_1440;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1443;
  assign select_1443 = (sum_1438 < sum_1441) ? sum_1441 : sum_1438;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_654 ? ((select_1435 < select_1443) ? select_1443 : select_1435) : 7'h0;
  // hls/stages/agreement.hpp:788
  logic or_1448;
  assign or_1448 = select_649_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:792
  logic [6:0] select_1449;
  assign select_1449 = or_1448 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1450;
  assign select_1450 = or_1448 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:797
  logic or_1462;
  assign or_1462 = select_1460_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1463;
  assign select_1463 = or_1462 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1464;
  assign select_1464 = or_1462 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1466;
  assign or_1466 = select_1460_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1467;
  assign select_1467 = or_1466 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1468;
  assign select_1468 = or_1466 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic not_1470;
  assign not_1470 = ~equal_1469_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1480;
  assign and_1480 = not_529_s2_q & and_1479_s2_q;
  // hls/stages/agreement.hpp:935
  logic select_1486;
  assign select_1486 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1489;
  assign difference_1489 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:943
  logic [9:0] sum_1490;
  assign sum_1490 = {difference_1489[8], difference_1489} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1492;
  assign and_1492 = (and_1479_s2_q & select_1486) & ({{22{sum_1490[9]}}, sum_1490} < 32'h3);
  logic and_1493;
  assign and_1493 = not_529_s2_q & and_1492;
  logic and_1499;
  assign and_1499 = not_529_s2_q & (and_1492 & or_1497_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1500;
  assign select_1500 = less_528_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_521_s2_q ? {select_1500, and_1499, and_1493, and_1483_s2_q, and_1480, and_1476_s2_q, not_529_s2_q} : 15'h0;
  // hls/stages/patches.hpp:322
  logic and_1502;
  assign and_1502 = ends_cell_s2_q & shift_2[0];
  logic and_1504;
  assign and_1504 = not_1470 & (so_s2_q & and_1502);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1612;
  assign select_1612 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1612[16:7])) ? 8'h7f : select_1612[7:0];
  // hls/stages/patches.hpp:154
  logic [7:0] pixel;
  assign pixel = equal_1687_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1687_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:478
  logic less_1775;
  assign less_1775 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:479
  logic or_1776;
  assign or_1776 = equal_1686_s2_q | less_1775;
  // hls/stages/patches.hpp:482
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1781;
  assign select_1781 = equal_1686_s2_q ? patches_column_s2_q[0] : (or_1776 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1782;
  assign not_1782 = ~or_1776;
  // hls/stages/patches.hpp:479
  logic [4:0] sum_1783;
  assign sum_1783 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:481
  logic [4:0] select_1786;
  assign select_1786 = or_1776 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1783) + 5'h1) : sum_1783;
  // hls/stages/patches.hpp:483
  logic [4:0] select_1787;
  assign select_1787 = equal_1686_s2_q ? 5'h0 : select_1786;
  logic or_1788;
  assign or_1788 = equal_1686_s2_q | equal_1684_s2_q;
  // hls/stages/patches.hpp:459
  logic equal_1790;
  assign equal_1790 = patches_column_s2_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s2_q == 5'h11;
  logic equal_1792;
  assign equal_1792 = patches_column_s2_q == 5'h18;
  // hls/stages/patches.hpp:461
  logic and_1794;
  assign and_1794 = of_row & (~equal_1792);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1790 ? 2'h3 : {equal_1792, and_1794};
  // hls/stages/patches.hpp:447
  logic [8:0] sum_1797;
  assign sum_1797 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1798;
  assign sum_1798 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1797, pixel_2[0]} - {1'b0, sum_1798, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:449
  logic [11:0] sum_1800;
  assign sum_1800 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1801;
  assign sum_1801 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1800[11], sum_1800};
  logic [13:0] sum_1802;
  assign sum_1802 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1801, down_2[1]};
  logic [12:0] sum_1803;
  assign sum_1803 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1802[13:1];
  logic [14:0] sum_1804;
  assign sum_1804 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1803, sum_1802[0], down_2[0]};
  // hls/stages/patches.hpp:445
  logic [8:0] sum_1807;
  assign sum_1807 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1808;
  assign sum_1808 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1807};
  logic [10:0] sum_1809;
  assign sum_1809 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1808, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1810;
  assign sum_1810 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1809[10:1];
  // hls/stages/patches.hpp:446
  logic [11:0] smooth;
  assign smooth = {sum_1810, sum_1809[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:448
  logic [12:0] sum_1812;
  assign sum_1812 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1813;
  assign sum_1813 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1814;
  assign difference_1814 = {1'b0, sum_1812, smooth[0]} - {1'b0, sum_1813, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:460
  logic or_1820;
  assign or_1820 = (((patches_column_s2_q == 5'ha) | of_row) | equal_1792) | equal_1790;
  // hls/stages/patches.hpp:455
  logic and_1825;
  assign and_1825 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:166
  logic and_1829;
  assign and_1829 = not_1685_s2_q & (or_1688_s2_q & (or_1820 & (equal_1687_s2_q & and_1825)));
  // hls/stages/patches.hpp:154
  logic and_1839;
  assign and_1839 = (~(equal_1687_s2_q | (~and_1825))) & (~patches_column_s2_q[4]);
  // hls/stages/patches.hpp:166
  logic and_1843;
  assign and_1843 = not_1685_s2_q & (or_1688_s2_q & (and_1839 & (patches_column_s2_q == 5'hf)));
  // hls/stages/patches.hpp:524
  logic less_1845;
  assign less_1845 = patches_step_q[4:0] < 5'h11;
  logic equal_1846;
  assign equal_1846 = patches_step_q[6:5] == 2'h0;
  logic not_1847;
  assign not_1847 = ~equal_1846;
  logic equal_1848;
  assign equal_1848 = patches_step_q[6:5] == 2'h3;
  logic not_1849;
  assign not_1849 = ~equal_1848;
  // hls/stages/patches.hpp:538
  logic select_1852;
  assign select_1852 = equal_1848 ? (less_1845 & (less_1845 & not_1849)) : less_1845;
  // hls/stages/patches.hpp:166
  logic and_1855;
  assign and_1855 = equal_1682_s2_q & (less_1845 ? (not_1847 & select_1852) : select_1852);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1883;
  assign sum_1883 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:227
  logic [5:0] select_2386;
  assign select_2386 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2387;
  assign select_2387 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2388;
  assign select_2388 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2389;
  assign select_2389 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2390;
  assign select_2390 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2391;
  assign select_2391 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:735
  logic less_2395;
  assign less_2395 = select_1423 < select_1404;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2397;
  assign select_2397 = slot_s2_q[0] ? 7'h0 : sum_1434;
  // hls/stages/registration.hpp:76
  logic less_2486;
  assign less_2486 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2488;
  assign select_2488 = or_521_s2_q ? (less_528_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2490;
  assign select_2490 = or_521_s2_q ? (less_528_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2492;
  assign select_2492 = or_521_s2_q ? (less_528_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2490} - {1'b0, select_2492};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2494;
  assign select_2494 = rise[8] ? select_2490 : select_2492;
  logic [8:0] difference_2495;
  assign difference_2495 = {1'b0, select_2488} - {1'b0, select_2494};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2495[8] ? 8'h0 : difference_2495[7:0];
  // hls/stages/registration.hpp:37
  logic not_2497;
  assign not_2497 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2486 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2497};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2499;
  assign xor_2499 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2499};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2505;
  assign select_2505 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2486 ? {taken, 1'b1} : {not_2497, select_2505, not_2497};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2507;
  assign sum_2507 = {left, 1'b1} + {taken_2, less_2486};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2509;
  assign select_2509 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2592;
  assign select_2592 = and_2591_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2594;
  assign select_2594 = and_2589_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2592[15]}}, select_2592});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2595;
  assign select_2595 = and_2591_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2595[15]}}, select_2595};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2597;
  assign select_2597 = and_2589_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_2598;
  assign and_2598 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2598 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:169
  logic select_2843;
  assign select_2843 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:166
  logic [11:0] select_2846;
  assign select_2846 = equal_1684_s2_q ? patches_smooth_values_0_q : (or_1688_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_2848;
  assign select_2848 = or_1688_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2850;
  assign select_2850 = equal_1682_s2_q ? patches_smooth_values_1_q : (equal_1684_s2_q ? patches_smooth_values_1_q : select_2848);
  logic [11:0] select_2851;
  assign select_2851 = or_1688_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2853;
  assign select_2853 = equal_1682_s2_q ? patches_smooth_values_2_q : (equal_1684_s2_q ? patches_smooth_values_2_q : select_2851);
  logic [11:0] select_2854;
  assign select_2854 = or_1688_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2856;
  assign select_2856 = equal_1682_s2_q ? patches_smooth_values_3_q : (equal_1684_s2_q ? patches_smooth_values_3_q : select_2854);
  logic [10:0] select_2858;
  assign select_2858 = equal_1684_s2_q ? patches_down_values_0_q : (or_1688_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_2861;
  assign select_2861 = equal_1684_s2_q ? patches_down_values_1_q : (or_1688_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_2864;
  assign select_2864 = equal_1684_s2_q ? patches_down_values_2_q : (or_1688_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_2867;
  assign select_2867 = equal_1684_s2_q ? patches_down_values_3_q : (or_1688_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:157
  logic and_2904;
  assign and_2904 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:395
  logic [4:0] select_2909;
  assign select_2909 = or_2804_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:397
  logic [3:0] select_2911;
  assign select_2911 = and_2904 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:166
  logic [4:0] select_3267;
  assign select_3267 = equal_1682_s2_q ? patches_summed_down_by_q : (equal_1684_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:534
  logic and_3300;
  assign and_3300 = less_1845 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:538
  logic select_3303;
  assign select_3303 = equal_1848 ? (less_1845 ? (not_1849 & and_3300) : and_3300) : and_3300;
  // hls/stages/patches.hpp:166
  logic select_3306;
  assign select_3306 = equal_1682_s2_q ? (less_1845 ? (not_1847 & select_3303) : select_3303) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3595;
  assign select_3595 = so_s2_q ? (and_2598 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3597;
  assign sum_3597 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3598;
  assign select_3598 = sum_1883[5] ? {1'b1, sum_1883[4:0], region_across_rest_q[2:0]} : sum_3597;
  // hls/stages/agreement.hpp:447
  logic [7:0] select_3600;
  assign select_3600 = equal_2286_s2_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3603;
  assign select_3603 = equal_2286_s2_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_470_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_475;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:334; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [77:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = column_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & and_500_s2_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1299; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1504;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:754; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1787, not_1782, select_1781};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & or_1788;
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:755; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s2_en & (not_1683_s2_q & (new_row & equal_1684_s2_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:769; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s2_en & and_1855;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1326; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1504;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1451_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1450, select_1449, select_1431, select_1427, select_1416, select_1415, select_1410};
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
  assign best_right_we = s2_en & and_1451_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1468, select_1467, select_1464, select_1463};
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
  assign patches_columns_above_we = s2_en & and_1769_s2_q;
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
      chosen_score_q <= less_2395 ? select_1404 : select_1423;
      chosen_near_q <= (select_2397 < select_1443) ? select_1443 : select_2397;
      chosen_place_q <= less_2395 ? {select_1412, not_1411} : 3'h2;
      before_0_q <= select_1423;
      before_1_q <= sum_1154;
      before_2_q <= sum_1402;
      registration_displacement_over_q <= so_s2_q ? sum_2507[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2509;
      registration_slope_row_q <= select_2594;
      registration_slope_change_q <= select_2597;
      registration_slope_q <= so_s2_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_2828_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2828_s2_q & select_2843;
      patches_smooth_values_0_q <= equal_1682_s2_q ? patches_smooth_values_0_q : select_2846;
      patches_smooth_values_1_q <= select_2850;
      patches_smooth_values_2_q <= select_2853;
      patches_smooth_values_3_q <= select_2856;
      patches_down_values_0_q <= equal_1682_s2_q ? patches_down_values_0_q : select_2858;
      patches_down_values_1_q <= equal_1682_s2_q ? patches_down_values_1_q : select_2861;
      patches_down_values_2_q <= equal_1682_s2_q ? patches_down_values_2_q : select_2864;
      patches_down_values_3_q <= equal_1682_s2_q ? patches_down_values_3_q : select_2867;
      patches_down_by_q <= or_2804_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2904});
      patches_along_q <= select_2909;
      patches_match_row_q <= or_2804_s2_q ? 4'h0 : select_2911;
      patches_summed_last_q <= not_1683_s2_q & (equal_1684_s2_q & and_2904);
      patches_summed_down_by_q <= select_3267;
      patches_step_q <= or_2804_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3306;
      region_across_rest_q <= select_3595;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3598;
      columns_begin_rest_q <= and_500_s2_q ? select_3600 : columns_begin_rest_q;
      columns_begin_back_q <= and_500_s2_q ? select_3603 : columns_begin_back_q;
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
      middle_sum_columns_values_1_q <= select_2386;
      middle_sum_columns_values_2_q <= select_2387;
      middle_sum_columns_values_3_q <= select_2388;
      middle_sum_columns_values_4_q <= select_2389;
      middle_sum_columns_values_5_q <= select_2390;
      middle_sum_columns_values_6_q <= select_2391;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_904;
      sums_0_sum_sums_values_0_q <= sum_1154;
      sums_0_sum_sums_values_1_q <= equal_1152 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1402;
      sums_1_sum_sums_values_1_q <= equal_1152 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [4:0] patches_along_s3_q;
  logic patches_summed_last_s3_q;
  logic [4:0] patches_summed_down_by_s3_q;
  logic [4:0] patches_step_s3_q;
  logic patches_read_searches_s3_q;
  logic [2:0] select_464_s3_q;
  logic [5:0] select_466_s3_q;
  logic [7:0] select_470_s3_q;
  logic and_474_s3_q;
  logic and_475_s3_q;
  logic equal_480_s3_q;
  logic [5:0] column_s3_q;
  logic and_498_s3_q;
  logic and_500_s3_q;
  logic so_s3_q;
  logic equal_561_s3_q;
  logic equal_1469_s3_q;
  logic not_1470_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1504_s3_q;
  logic [5:0] select_1508_s3_q;
  logic and_1513_s3_q;
  logic and_1582_s3_q;
  logic and_1595_s3_q;
  logic less_1609_s3_q;
  logic [7:0] change_s3_q;
  logic equal_1682_s3_q;
  logic equal_1684_s3_q;
  logic equal_1687_s3_q;
  logic or_1688_s3_q;
  logic [4:0] select_1712_s3_q;
  logic select_1718_s3_q;
  logic [3:0] select_1759_s3_q;
  logic less_1775_s3_q;
  logic new_row_s3_q;
  logic or_1788_s3_q;
  logic [1:0] of_row_2_s3_q;
  logic less_1805_s3_q;
  logic less_1806_s3_q;
  logic less_1815_s3_q;
  logic less_1816_s3_q;
  logic and_1830_s3_q;
  logic and_1839_s3_q;
  logic and_1844_s3_q;
  logic less_1845_s3_q;
  logic equal_1846_s3_q;
  logic not_1847_s3_q;
  logic equal_1848_s3_q;
  logic not_1849_s3_q;
  logic and_1862_s3_q;
  logic select_1864_s3_q;
  logic and_1867_s3_q;
  logic sum_1883_s3_q;
  logic textured_s3_q;
  logic and_2016_s3_q;
  logic equal_2162_s3_q;
  logic equal_2286_s3_q;
  logic less_2523_s3_q;
  logic less_2880_s3_q;
  logic equal_3223_s3_q;
  logic equal_3307_s3_q;
  logic less_3583_s3_q;
  logic equal_3788_s3_q;
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
      patches_along_s3_q <= patches_along_q;
      patches_summed_last_s3_q <= patches_summed_last_q;
      patches_summed_down_by_s3_q <= patches_summed_down_by_q;
      patches_step_s3_q <= patches_step_q[4:0];
      patches_read_searches_s3_q <= patches_read_searches_q;
      select_464_s3_q <= select_464_s2_q;
      select_466_s3_q <= select_466_s2_q;
      select_470_s3_q <= select_470_s2_q;
      and_474_s3_q <= and_474_s2_q;
      and_475_s3_q <= and_475;
      equal_480_s3_q <= equal_480_s2_q;
      column_s3_q <= column_s2_q;
      and_498_s3_q <= and_498_s2_q;
      and_500_s3_q <= and_500_s2_q;
      so_s3_q <= so_s2_q;
      equal_561_s3_q <= equal_561_s2_q;
      equal_1469_s3_q <= equal_1469_s2_q;
      not_1470_s3_q <= not_1470;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1504_s3_q <= and_1504;
      select_1508_s3_q <= select_1508_s2_q;
      and_1513_s3_q <= not_1470 & (so_s2_q ? and_1502 : (equal_520_s2_q & shift_2[4]));
      and_1582_s3_q <= and_1582_s2_q;
      and_1595_s3_q <= and_1595_s2_q;
      less_1609_s3_q <= less_1609_s2_q;
      change_s3_q <= change;
      equal_1682_s3_q <= equal_1682_s2_q;
      equal_1684_s3_q <= equal_1684_s2_q;
      equal_1687_s3_q <= equal_1687_s2_q;
      or_1688_s3_q <= or_1688_s2_q;
      select_1712_s3_q <= select_1712_s2_q;
      select_1718_s3_q <= select_1718_s2_q;
      select_1759_s3_q <= select_1759_s2_q;
      less_1775_s3_q <= less_1775;
      new_row_s3_q <= new_row;
      or_1788_s3_q <= or_1788;
      of_row_2_s3_q <= of_row_2;
      less_1805_s3_q <= $signed(15'h100) < $signed(sum_1804);
      less_1806_s3_q <= $signed(sum_1804[14:8]) < $signed(7'h7f);
      less_1815_s3_q <= $signed(15'h100) < $signed(difference_1814);
      less_1816_s3_q <= $signed(difference_1814[14:8]) < $signed(7'h7f);
      and_1830_s3_q <= not_1683_s2_q & and_1829;
      and_1839_s3_q <= and_1839;
      and_1844_s3_q <= not_1683_s2_q & and_1843;
      less_1845_s3_q <= less_1845;
      equal_1846_s3_q <= equal_1846;
      not_1847_s3_q <= not_1847;
      equal_1848_s3_q <= equal_1848;
      not_1849_s3_q <= not_1849;
      and_1862_s3_q <= and_1862_s2_q;
      select_1864_s3_q <= select_1864_s2_q;
      and_1867_s3_q <= and_1867_s2_q;
      sum_1883_s3_q <= sum_1883[5];
      textured_s3_q <= textured;
      and_2016_s3_q <= and_2016_s2_q;
      equal_2162_s3_q <= equal_2162_s2_q;
      equal_2286_s3_q <= equal_2286_s2_q;
      less_2523_s3_q <= select_2490 < select_2492;
      less_2880_s3_q <= 4'he < patches_column_s2_q[4:1];
      equal_3223_s3_q <= patches_match_row_q == 4'h0;
      equal_3307_s3_q <= patches_step_q[6:5] == 2'h2;
      less_3583_s3_q <= less_3583_s2_q;
      equal_3788_s3_q <= equal_3788_s2_q;
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
  logic [51:0] patches_codes_at_q;
  logic [27:0] patches_codes_further_q;
  logic [55:0] patches_next_codes_q;
  logic [2:0] patches_set_q;
  logic [9:0] patches_size_q;
  logic [47:0] patches_left_row_q;
  logic [4:0] patches_summed_row_column_q;
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
  logic [11:0] select_478;
  assign select_478 = select_464_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_482;
  assign sum_482 = select_478 + (equal_480_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_484;
  assign sum_484 = {4'h0, sample_pair_pixel_1_q} + (select_464_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_486;
  assign sum_486 = sum_484 + (equal_480_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = select_464_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_490;
  assign and_490 = whole & (averager_memory_rdata_q[24] | equal_480_s3_q);
  // hls/stages/agreement.hpp:404
  logic all_of_skin;
  assign all_of_skin = select_464_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_494;
  assign and_494 = all_of_skin & (averager_memory_rdata_q[25] | equal_480_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_474_s3_q ? sum_482[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_503;
  assign equal_503 = select_464_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_503 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_506;
  assign select_506 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_474_s3_q ? sum_486[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_503 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_510;
  assign select_510 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_511;
  assign and_511 = and_474_s3_q & and_490;
  // hls/stages/census.hpp:126
  logic select_513;
  assign select_513 = equal_503 ? and_511 : (averager_mask_q & and_511);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_513;
  // hls/stages/census.hpp:206
  logic and_515;
  assign and_515 = and_474_s3_q & and_494;
  // hls/stages/census.hpp:126
  logic select_517;
  assign select_517 = equal_503 ? and_515 : (averager_of_skin_q & and_515);
  // hls/stages/agreement.hpp:263
  logic and_518;
  assign and_518 = sample_pair_whole_s3_q & select_517;
  // hls/stages/census.hpp:294
  logic less_534;
  assign less_534 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_535;
  assign less_535 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_536;
  assign less_536 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_537;
  assign less_537 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_538;
  assign less_538 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_539;
  assign less_539 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_540;
  assign less_540 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_541;
  assign less_541 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_542;
  assign less_542 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_543;
  assign less_543 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_544;
  assign less_544 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_545;
  assign less_545 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_546;
  assign less_546 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_547;
  assign less_547 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_548;
  assign less_548 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_549;
  assign less_549 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_550;
  assign less_550 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_551;
  assign less_551 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_552;
  assign less_552 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_553;
  assign less_553 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_554;
  assign less_554 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_555;
  assign less_555 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_556;
  assign less_556 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_557;
  assign less_557 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:442
  logic equal_558;
  assign equal_558 = column_s3_q == 6'h0;
  logic [3:0] select_562;
  assign select_562 = equal_561_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_563;
  assign select_563 = equal_558 ? {select_562, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_564;
  assign select_564 = equal_558 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_565;
  assign and_565 = select_563[4] & select_564[3];
  // hls/stages/census.hpp:286
  logic and_567;
  assign and_567 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_569;
  assign and_569 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_567);
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_569;
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
  logic [9:0] difference_592;
  assign difference_592 = {1'b0, select_506} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_593;
  assign xor_593 = difference_592[8:0] ^ {9{difference_592[9]}};
  logic [9:0] sum_594;
  assign sum_594 = {9'h0, difference_592[9]} + {1'b0, xor_593};
  logic [9:0] difference_595;
  assign difference_595 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_596;
  assign xor_596 = difference_595[8:0] ^ {9{difference_595[9]}};
  logic [9:0] sum_597;
  assign sum_597 = {9'h0, difference_595[9]} + {1'b0, xor_596};
  logic [9:0] difference_599;
  assign difference_599 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_600;
  assign xor_600 = difference_599[8:0] ^ {9{difference_599[9]}};
  logic [9:0] sum_601;
  assign sum_601 = {9'h0, difference_599[9]} + {1'b0, xor_600};
  logic [10:0] sum_602;
  assign sum_602 = ({1'b0, sum_594} + {1'b0, sum_597}) + {1'b0, sum_601};
  logic [9:0] difference_603;
  assign difference_603 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_604;
  assign xor_604 = difference_603[8:0] ^ {9{difference_603[9]}};
  logic [9:0] sum_605;
  assign sum_605 = {9'h0, difference_603[9]} + {1'b0, xor_604};
  logic [9:0] difference_607;
  assign difference_607 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_608;
  assign xor_608 = difference_607[8:0] ^ {9{difference_607[9]}};
  // hls/stages/agreement.hpp:193
  logic not_1509;
  assign not_1509 = ~so_s3_q;
  // hls/stages/patches.hpp:322
  logic and_1510;
  assign and_1510 = not_1509 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1070
  logic equal_1514;
  assign equal_1514 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1517;
  assign select_1517 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1084
  logic [3:0] select_1519;
  assign select_1519 = equal_1514 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1517});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1520;
  assign sum_1520 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:322
  logic [3:0] select_1521;
  assign select_1521 = equal_1469_s3_q ? select_1519 : {sum_1520, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:193
  logic equal_1522;
  assign equal_1522 = x_s3_q[5:0] == 6'h3f;
  logic equal_1524;
  assign equal_1524 = x_s3_q[5:0] == 6'h3e;
  logic equal_1526;
  assign equal_1526 = x_s3_q[5:0] == 6'h3d;
  logic equal_1528;
  assign equal_1528 = x_s3_q[5:0] == 6'h3c;
  logic equal_1530;
  assign equal_1530 = x_s3_q[5:0] == 6'h3b;
  logic equal_1532;
  assign equal_1532 = x_s3_q[5:0] == 6'h36;
  logic equal_1534;
  assign equal_1534 = x_s3_q[5:0] == 6'h35;
  logic equal_1536;
  assign equal_1536 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1116
  logic and_1540;
  assign and_1540 = (~equal_1530) & ((~equal_1532) & ((~equal_1534) & (~equal_1536)));
  logic and_1544;
  assign and_1544 = (~equal_1522) & ((~equal_1524) & ((~equal_1526) & ((~equal_1528) & and_1540)));
  // hls/stages/agreement.hpp:1071
  logic less_1545;
  assign less_1545 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1549;
  assign or_1549 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:955
  logic [4:0] sum_1554;
  assign sum_1554 = {1'b0, last_s3_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2_s3_q[0] & ({2'h0, sum_1554, last_s3_q[1]} < x_s3_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1560;
  assign sum_1560 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1562;
  assign and_1562 = half_ends & ({{3{sum_1560[4]}}, sum_1560} < 8'h3);
  // hls/stages/patches.hpp:322
  logic and_1563;
  assign and_1563 = so_s3_q & and_1562;
  logic select_1564;
  assign select_1564 = equal_1469_s3_q ? (x_s3_q[6] & (equal_1514 ? and_1544 : (less_1545 & (~or_1549)))) : and_1563;
  // hls/stages/registration.hpp:258
  logic not_1566;
  assign not_1566 = ~lower_half_s3_q;
  logic [3:0] select_1567;
  assign select_1567 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1566, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1566};
  // hls/stages/patches.hpp:355
  logic [1:0] select_1596;
  assign select_1596 = and_1595_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1597;
  assign select_1597 = and_1595_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_1598;
  assign select_1598 = and_1582_s3_q ? {select_1597, select_1596[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:108
  logic [1:0] select_1599;
  assign select_1599 = and_1582_s3_q ? select_1596 : patches_fetch_q;
  logic equal_1600;
  assign equal_1600 = select_1599 == 2'h0;
  // hls/stages/patches.hpp:85
  logic right_3;
  assign right_3 = {3'h0, last_s3_q[5:1]} < x_s3_q;
  // hls/stages/patches.hpp:322
  logic and_1608;
  assign and_1608 = not_1470_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1610;
  assign equal_1610 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1610 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1616;
  assign select_1616 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_1617;
  assign select_1617 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_1618;
  assign sum_1618 = {{2{select_1616[6]}}, select_1616} + {select_1617[7], select_1617};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1619;
  assign select_1619 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_1620;
  assign select_1620 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_1621;
  assign sum_1621 = {{2{select_1619[7]}}, select_1619[7:1]} + {select_1620[7], select_1620};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1622;
  assign sum_1622 = {{3{sum_1618[8]}}, sum_1618[8:1]} + {sum_1621[8], sum_1621, select_1619[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1623;
  assign select_1623 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_1624;
  assign select_1624 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_1625;
  assign difference_1625 = {{2{select_1623[7]}}, select_1623[7:1]} - {select_1624[7], select_1624};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1626;
  assign sum_1626 = {difference_1625, select_1623[0]} + {sum_1622[10], sum_1622[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1610 ? {sum_1626, sum_1622[1]} : registration_expected_q;
  // hls/stages/patches.hpp:80
  logic [9:0] sum_1628;
  assign sum_1628 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:964
  logic and_1630;
  assign and_1630 = shift_2_s3_q[3] & ({{4{sum_1628[9]}}, sum_1628, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:86
  logic and_1635;
  assign and_1635 = ({4'h0, last_s3_q[5:1]} < ({1'b0, x_s3_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:88
  logic equal_1636;
  assign equal_1636 = x_s3_q == 8'h0;
  // hls/stages/patches.hpp:84
  logic [9:0] sum_1642;
  assign sum_1642 = {2'h0, x_s3_q} + {{4{shift_2_s3_q[10]}}, shift_2_s3_q[10:5]};
  // hls/stages/patches.hpp:88
  logic [9:0] sum_1644;
  assign sum_1644 = {sum_1642[9], sum_1642[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:964
  logic and_1647;
  assign and_1647 = ($signed(9'h0) < $signed(sum_1642[9:1])) & (~($signed({5'h0, last_s3_q}) < $signed({sum_1644, sum_1642[0]})));
  logic and_1648;
  assign and_1648 = (~(and_1635 | (equal_1636 | (~(x_s3_q < {2'h0, last_s3_q}))))) & and_1647;
  // hls/stages/patches.hpp:322
  logic and_1651;
  assign and_1651 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_1609_s3_q & and_1630) & and_1648));
  logic and_1653;
  assign and_1653 = not_1470_s3_q & (so_s3_q & and_1651);
  // hls/stages/patches.hpp:138
  logic and_1655;
  assign and_1655 = and_1653 & (~patches_fixed_q);
  // hls/stages/patches.hpp:322
  logic [6:0] select_1658;
  assign select_1658 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  logic [6:0] select_1659;
  assign select_1659 = equal_1469_s3_q ? 7'h0 : select_1658;
  logic [5:0] select_1661;
  assign select_1661 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_1663;
  assign select_1663 = equal_1469_s3_q ? 6'h0 : (so_s3_q ? select_1661 : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1664;
  assign sum_1664 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_1626[9]}}, sum_1626[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1667;
  assign select_1667 = ($signed(sum_1664[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1664[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1610 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1664[12:7])) ? 8'h7f : select_1667);
  // hls/stages/patches.hpp:322
  logic [7:0] select_1672;
  assign select_1672 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_1673;
  assign select_1673 = equal_1469_s3_q ? 8'h0 : select_1672;
  // hls/stages/patches.hpp:325
  logic [21:0] select_1674;
  assign select_1674 = and_1655 ? {select_1673, select_1663, select_1659, and_1653} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:95
  logic equal_1675;
  assign equal_1675 = x_s3_q == {2'h0, last_s3_q};
  // hls/stages/patches.hpp:322
  logic and_1679;
  assign and_1679 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (and_1635 | equal_1675)));
  logic and_1680;
  assign and_1680 = not_1470_s3_q & and_1679;
  // hls/stages/patches.hpp:326
  logic and_1681;
  assign and_1681 = patches_chooses_s3_q & and_1680;
  // hls/stages/patches.hpp:108
  logic [4:0] select_1695;
  assign select_1695 = and_1582_s3_q ? select_1597 : patches_band_q;
  // hls/stages/patches.hpp:335
  logic equal_1696;
  assign equal_1696 = {patches_choosing_band_s3_q, and_1608} == {select_1695, select_1599[1]};
  // hls/stages/patches.hpp:464
  logic [2:0] sum_1796;
  assign sum_1796 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:468
  logic [1:0] sum_1834;
  assign sum_1834 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1870;
  assign select_1870 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_1873;
  assign or_1873 = select_1870[7] | (~({select_1870[5], select_1870[3], select_1870[1]} == 3'h0));
  // hls/stages/agreement.hpp:991
  logic or_1876;
  assign or_1876 = select_1870[7] | (~({select_1870[6], select_1870[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:990
  logic or_1879;
  assign or_1879 = select_1870[7] | (~(select_1870[6:4] == 3'h0));
  // hls/stages/patches.hpp:322
  logic [5:0] select_1880;
  assign select_1880 = equal_1469_s3_q ? x_s3_q[5:0] : {region_row_q, or_1879, or_1876, or_1873};
  // hls/stages/agreement.hpp:1070
  logic not_1881;
  assign not_1881 = ~equal_1514;
  // hls/stages/agreement.hpp:1000
  logic or_1885;
  assign or_1885 = (~sum_1883_s3_q) | equal_1675;
  // hls/stages/patches.hpp:322
  logic and_1888;
  assign and_1888 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_1885));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_1909;
  assign and_1909 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:960
  logic select_1910;
  assign select_1910 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_1910);
  // hls/stages/agreement.hpp:960
  logic select_1913;
  assign select_1913 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_1910 ? select_1913 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1198
  logic select_1916;
  assign select_1916 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1202
  logic select_1917;
  assign select_1917 = left_first_s3_q ? select_1916 : read_half_q;
  logic or_1918;
  assign or_1918 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1203
  logic [8:0] select_1919;
  assign select_1919 = or_1918 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1204
  logic [9:0] select_1921;
  assign select_1921 = left_first_s3_q ? 10'h1 : (or_1918 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1207
  logic and_1922;
  assign and_1922 = select_1919[8] & select_1921[9];
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = and_1922 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1218
  logic [5:0] select_1925;
  assign select_1925 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1927;
  assign select_1927 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_1925});
  // hls/stages/agreement.hpp:1228
  logic equal_1928;
  assign equal_1928 = seen_x_q == 3'h7;
  logic [7:0] select_1930;
  assign select_1930 = and_1922 ? 8'h0 : (seen_column_q + {7'h0, equal_1928});
  // hls/stages/agreement.hpp:1235
  logic [10:0] index;
  assign index = select_1927 + {3'h0, select_1930};
  // hls/stages/agreement.hpp:1188
  logic [11:0] sum_1932;
  assign sum_1932 = {1'b0, {2{select_1917}}, 2'h0, {2{select_1917}}, 1'b0, {2{select_1917}}, 1'b0, select_1917} + {1'b0, index};
  // hls/stages/agreement.hpp:1201
  logic not_1933;
  assign not_1933 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:422
  logic and_1935;
  assign and_1935 = not_1933 & (began_q | and_1922);
  // hls/stages/agreement.hpp:1229
  logic [2:0] select_1937;
  assign select_1937 = and_1922 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1234
  logic and_1939;
  assign and_1939 = and_1935 & (select_1937 == 3'h0);
  logic less_1940;
  assign less_1940 = select_1930 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:424
  logic and_1941;
  assign and_1941 = and_1939 & less_1940;
  logic and_1942;
  assign and_1942 = and_1862_s3_q & and_1941;
  // hls/stages/agreement.hpp:265
  logic select_1944;
  assign select_1944 = and_1862_s3_q ? (left_first_s3_q ? and_1941 : and_1942) : and_1942;
  // hls/stages/agreement.hpp:1053
  logic [7:0] sum_1946;
  assign sum_1946 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1946[7], sum_1946, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1188
  logic [11:0] sum_1948;
  assign sum_1948 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:976
  logic and_1949;
  assign and_1949 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_1950;
  assign and_1950 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_1951;
  assign and_1951 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_1952;
  assign and_1952 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_1954;
  assign sum_1954 = {1'b0, and_1951} + ({1'b0, textured_s3_q} + {1'b0, and_1952});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1949} + ({2'h0, and_1950} + {1'b0, sum_1954});
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_1957;
  assign select_1957 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1958;
  assign difference_1958 = {1'b0, textured_2} - {1'b0, select_1957};
  logic [4:0] t;
  assign t = {difference_1958[3], difference_1958} + (equal_1636 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_1963;
  assign select_1963 = shift_2_s3_q[0] ? (sum_1883_s3_q ? select_1870 : {select_1870[6:0], 1'b0}) : select_1870;
  // hls/stages/agreement.hpp:992
  logic or_1966;
  assign or_1966 = select_1963[7] | (~({select_1963[5], select_1963[3], select_1963[1]} == 3'h0));
  // hls/stages/agreement.hpp:976
  logic and_1983;
  assign and_1983 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_1984;
  assign and_1984 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_1985;
  assign and_1985 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_1986;
  assign and_1986 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_1988;
  assign sum_1988 = {1'b0, and_1985} + ({1'b0, shown} + {1'b0, and_1986});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1983} + ({2'h0, and_1984} + {1'b0, sum_1988});
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_1991;
  assign select_1991 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_1992;
  assign difference_1992 = {1'b0, shown_2} - {1'b0, select_1991};
  logic [4:0] around;
  assign around = {difference_1992[3], difference_1992} + (equal_1636 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_1995;
  assign sum_1995 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:976
  logic and_1999;
  assign and_1999 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2000;
  assign and_2000 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2001;
  assign and_2001 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2002;
  assign and_2002 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_2004;
  assign sum_2004 = {1'b0, and_2001} + ({1'b0, near} + {1'b0, and_2002});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_1999} + ({2'h0, and_2000} + {1'b0, sum_2004});
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_2007;
  assign select_2007 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2008;
  assign difference_2008 = {1'b0, near_2} - {1'b0, select_2007};
  logic [4:0] n;
  assign n = {difference_2008[3], difference_2008} + (equal_1636 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/patches.hpp:322
  logic and_2020;
  assign and_2020 = ends_cell_s3_q & (and_2016_s3_q & (~({1'b0, sum_1554, last_s3_q[1:0]} < x_s3_q)));
  logic and_2022;
  assign and_2022 = not_1470_s3_q & (so_s3_q & and_2020);
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2054;
  assign select_2054 = sample_pair_whole_s3_q ? (and_498_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2056;
  assign select_2056 = sample_pair_whole_s3_q ? (and_498_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2075;
  assign select_2075 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2077;
  assign select_2077 = sample_pair_whole_s3_q ? (and_498_s3_q ? select_513 : averager_mask_q) : averager_mask_q;
  logic select_2079;
  assign select_2079 = sample_pair_whole_s3_q ? (and_498_s3_q ? select_517 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2080;
  assign select_2080 = and_500_s3_q ? select_506 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2081;
  assign select_2081 = and_500_s3_q ? select_510 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2083;
  assign select_2083 = and_500_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2084;
  assign select_2084 = and_500_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2085;
  assign select_2085 = and_500_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2086;
  assign select_2086 = and_500_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2087;
  assign select_2087 = and_500_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2088;
  assign select_2088 = and_500_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2089;
  assign select_2089 = and_500_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2090;
  assign select_2090 = and_500_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2091;
  assign select_2091 = and_500_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2092;
  assign select_2092 = and_500_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2093;
  assign select_2093 = and_500_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2094;
  assign select_2094 = and_500_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2095;
  assign select_2095 = and_500_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2096;
  assign select_2096 = and_500_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2097;
  assign select_2097 = and_500_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2098;
  assign select_2098 = and_500_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2099;
  assign select_2099 = and_500_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2100;
  assign select_2100 = and_500_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2101;
  assign select_2101 = and_500_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2102;
  assign select_2102 = and_500_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2103;
  assign select_2103 = and_500_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2104;
  assign select_2104 = and_500_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2105;
  assign select_2105 = and_500_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2106;
  assign select_2106 = and_500_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2107;
  assign select_2107 = and_500_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2108;
  assign select_2108 = and_500_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2109;
  assign select_2109 = and_500_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2110;
  assign select_2110 = and_500_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2111;
  assign select_2111 = and_500_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2112;
  assign select_2112 = and_500_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2113;
  assign select_2113 = and_500_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2114;
  assign select_2114 = and_500_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2115;
  assign select_2115 = and_500_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2116;
  assign select_2116 = and_500_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2117;
  assign select_2117 = and_500_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2118;
  assign select_2118 = and_500_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2119;
  assign select_2119 = and_500_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2120;
  assign select_2120 = and_500_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2121;
  assign select_2121 = and_500_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2122;
  assign select_2122 = and_500_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2123;
  assign select_2123 = and_500_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2124;
  assign select_2124 = and_500_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2125;
  assign select_2125 = and_500_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2126;
  assign select_2126 = and_500_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2127;
  assign select_2127 = and_500_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2128;
  assign select_2128 = and_500_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2129;
  assign select_2129 = and_500_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2130;
  assign select_2130 = and_500_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2131;
  assign select_2131 = and_500_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2132;
  assign select_2132 = and_500_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2133;
  assign select_2133 = and_500_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2134;
  assign select_2134 = and_500_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2135;
  assign select_2135 = and_500_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2137;
  assign difference_2137 = {1'b0, select_510} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2138;
  assign xor_2138 = difference_2137[8:0] ^ {9{difference_2137[9]}};
  logic [9:0] sum_2139;
  assign sum_2139 = {9'h0, difference_2137[9]} + {1'b0, xor_2138};
  logic [9:0] difference_2140;
  assign difference_2140 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2141;
  assign xor_2141 = difference_2140[8:0] ^ {9{difference_2140[9]}};
  logic [9:0] sum_2142;
  assign sum_2142 = {9'h0, difference_2140[9]} + {1'b0, xor_2141};
  logic [9:0] difference_2144;
  assign difference_2144 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2145;
  assign xor_2145 = difference_2144[8:0] ^ {9{difference_2144[9]}};
  logic [9:0] sum_2146;
  assign sum_2146 = {9'h0, difference_2144[9]} + {1'b0, xor_2145};
  logic [10:0] sum_2147;
  assign sum_2147 = ({1'b0, sum_2139} + {1'b0, sum_2142}) + {1'b0, sum_2146};
  logic [9:0] difference_2148;
  assign difference_2148 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2149;
  assign xor_2149 = difference_2148[8:0] ^ {9{difference_2148[9]}};
  logic [9:0] sum_2150;
  assign sum_2150 = {9'h0, difference_2148[9]} + {1'b0, xor_2149};
  logic [9:0] difference_2152;
  assign difference_2152 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2153;
  assign xor_2153 = difference_2152[8:0] ^ {9{difference_2152[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2183;
  assign difference_2183 = {1'b0, select_506} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2183[9]} + (difference_2183[8:0] ^ {9{difference_2183[9]}});
  logic [9:0] difference_2195;
  assign difference_2195 = {1'b0, select_510} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2195[9]} + (difference_2195[8:0] ^ {9{difference_2195[9]}});
  // hls/stages/agreement.hpp:507
  logic and_2402;
  assign and_2402 = and_500_s3_q & (equal_561_s3_q & equal_2286_s3_q);
  // hls/stages/patches.hpp:322
  logic and_2406;
  assign and_2406 = not_1470_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:976
  logic and_2426;
  assign and_2426 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2427;
  assign and_2427 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2428;
  assign and_2428 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2429;
  assign and_2429 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2431;
  assign sum_2431 = {1'b0, and_2428} + ({1'b0, explained} + {1'b0, and_2429});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2426} + ({2'h0, and_2427} + {1'b0, sum_2431});
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2434;
  assign select_2434 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2435;
  assign difference_2435 = {1'b0, explained_2} - {1'b0, select_2434};
  logic [4:0] e;
  assign e = {difference_2435[3], difference_2435} + (equal_1636 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2438;
  assign sum_2438 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/patches.hpp:322
  logic and_2467;
  assign and_2467 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2511;
  assign select_2511 = equal_1469_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2513;
  assign select_2513 = equal_1469_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2514;
  assign equal_2514 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:250
  logic and_2518;
  assign and_2518 = shift_2_s3_q[3] & less_1609_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2522;
  assign sum_2522 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2524;
  assign difference_2524 = {sum_2522, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2525;
  assign select_2525 = less_2523_s3_q ? difference_2524 : {sum_2522, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2526;
  assign select_2526 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2522, shift_2_s3_q[11], 5'h0} : select_2525;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2526[7]}}, select_2526} - {sum_1626[9], sum_1626, sum_1622[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2529;
  assign select_2529 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2529[11:7])) ? 12'h7f : select_2529;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2550;
  assign difference_2550 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2552;
  assign and_2552 = and_2518 & ($signed(difference_2550) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2565;
  assign less_2565 = $signed(difference_2550) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:322
  logic select_2573;
  assign select_2573 = so_s3_q ? (equal_2514 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2576;
  assign select_2576 = so_s3_q ? (equal_1610 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2581;
  assign select_2581 = (sum_1520 == 2'h2) ? (registration_fresh_q & (~select_1567)) : registration_fresh_q;
  // hls/stages/patches.hpp:322
  logic [3:0] select_2583;
  assign select_2583 = so_s3_q ? (and_1562 ? select_2581 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2585;
  assign select_2585 = and_2402 ? 4'hf : (equal_1469_s3_q ? registration_fresh_q : select_2583);
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1517;
  // hls/stages/registration.hpp:258
  logic not_2606;
  assign not_2606 = ~quarter_2[1];
  logic [3:0] select_2607;
  assign select_2607 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2606, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2606};
  // hls/stages/patches.hpp:73
  logic parity_2741;
  assign parity_2741 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_2742;
  assign select_2742 = equal_2286_s3_q ? {patches_chance_q[14:0], parity_2741} : patches_chance_q;
  // hls/stages/patches.hpp:327
  logic not_2744;
  assign not_2744 = ~and_1680;
  // hls/stages/patches.hpp:90
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:92
  logic [4:0] select_2746;
  assign select_2746 = right_3 ? last_s3_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2746};
  // hls/stages/patches.hpp:322
  logic and_2752;
  assign and_2752 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (~(x_s3_q < {2'h0, from}))));
  // hls/stages/patches.hpp:138
  logic and_2756;
  assign and_2756 = not_2744 & (patches_fixed_q | ((not_1470_s3_q & and_2752) & and_1655));
  // hls/stages/patches.hpp:336
  logic not_2769;
  assign not_2769 = ~select_1599[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_2771;
  assign select_2771 = sample_pair_whole_s3_q ? (equal_1600 ? select_1599 : {not_2769, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:500
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:166
  logic [51:0] select_2870;
  assign select_2870 = or_1688_s3_q ? {less_1816_s3_q, less_1815_s3_q, less_1806_s3_q, less_1805_s3_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2872;
  assign select_2872 = equal_1682_s3_q ? patches_codes_at_q : (equal_1684_s3_q ? other[55:4] : select_2870);
  // hls/stages/patches.hpp:483
  logic [27:0] word;
  assign word = or_1788_s3_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:499
  logic [27:0] select_2875;
  assign select_2875 = (patches_along_s3_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:166
  logic [27:0] select_2877;
  assign select_2877 = equal_1684_s3_q ? (new_row_s3_q ? word : select_2875) : patches_codes_further_q;
  // hls/stages/patches.hpp:501
  logic [55:0] select_2879;
  assign select_2879 = less_1775_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:471
  logic [55:0] select_2881;
  assign select_2881 = less_2880_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:166
  logic [55:0] select_2883;
  assign select_2883 = or_1688_s3_q ? (equal_1687_s3_q ? patches_next_codes_q : select_2881) : patches_next_codes_q;
  logic [55:0] select_2885;
  assign select_2885 = equal_1682_s3_q ? patches_next_codes_q : (equal_1684_s3_q ? select_2879 : select_2883);
  // hls/stages/count_bits.hpp:24
  logic parity_2890;
  assign parity_2890 = ^{less_1816_s3_q, less_1815_s3_q, less_1806_s3_q, less_1805_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_2894;
  assign or_2894 = ({less_1806_s3_q, less_1805_s3_q} == 2'h3) | (less_1815_s3_q & (less_1806_s3_q | less_1805_s3_q));
  logic and_2895;
  assign and_2895 = less_1816_s3_q & (^{less_1815_s3_q, less_1806_s3_q, less_1805_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2896;
  assign xor_2896 = or_2894 ^ and_2895;
  // hls/stages/count_bits.hpp:27
  logic and_2897;
  assign and_2897 = or_2894 & and_2895;
  // hls/stages/patches.hpp:166
  logic [2:0] select_2899;
  assign select_2899 = or_1688_s3_q ? (and_1839_s3_q ? {and_2897, xor_2896, parity_2890} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:149
  logic [9:0] sum_2903;
  assign sum_2903 = {7'h0, patches_set_q} + (equal_1687_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:500
  logic [47:0] select_2913;
  assign select_2913 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:166
  logic [47:0] select_2915;
  assign select_2915 = equal_1682_s3_q ? patches_left_row_q : (equal_1684_s3_q ? select_2913 : patches_left_row_q);
  // hls/stages/patches.hpp:502
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2913;
  // hls/stages/count_bits.hpp:24
  logic xor_2919;
  assign xor_2919 = bits[17] ^ (^{select_2913[16:15], other[16:15]});
  logic xor_2922;
  assign xor_2922 = bits[11] ^ (^{select_2913[10:9], other[10:9]});
  logic xor_2925;
  assign xor_2925 = bits[14] ^ (^{select_2913[13:12], other[13:12]});
  logic xor_2928;
  assign xor_2928 = xor_2919 ^ (^{select_2913[14:9], other[14:9]});
  logic xor_2931;
  assign xor_2931 = bits[47] ^ (^{select_2913[46:45], other[46:45]});
  logic xor_2934;
  assign xor_2934 = bits[8] ^ (^{select_2913[7:6], other[7:6]});
  logic xor_2937;
  assign xor_2937 = bits[2] ^ (^{select_2913[1:0], other[1:0]});
  logic xor_2940;
  assign xor_2940 = bits[5] ^ (^{select_2913[4:3], other[4:3]});
  logic xor_2943;
  assign xor_2943 = xor_2934 ^ (^{select_2913[5:0], other[5:0]});
  logic parity_2945;
  assign parity_2945 = ^{select_2913[47:45], select_2913[8:0], other[47:45], other[8:0]};
  logic xor_2946;
  assign xor_2946 = xor_2928 ^ parity_2945;
  logic xor_2949;
  assign xor_2949 = bits[44] ^ (^{select_2913[43:42], other[43:42]});
  logic xor_2952;
  assign xor_2952 = bits[38] ^ (^{select_2913[37:36], other[37:36]});
  logic xor_2955;
  assign xor_2955 = bits[41] ^ (^{select_2913[40:39], other[40:39]});
  logic xor_2961;
  assign xor_2961 = bits[26] ^ (^{select_2913[25:24], other[25:24]});
  logic xor_2964;
  assign xor_2964 = bits[20] ^ (^{select_2913[19:18], other[19:18]});
  logic xor_2967;
  assign xor_2967 = bits[23] ^ (^{select_2913[22:21], other[22:21]});
  logic xor_2970;
  assign xor_2970 = xor_2961 ^ (^{select_2913[23:18], other[23:18]});
  logic xor_2973;
  assign xor_2973 = bits[35] ^ (^{select_2913[34:33], other[34:33]});
  logic xor_2976;
  assign xor_2976 = bits[29] ^ (^{select_2913[28:27], other[28:27]});
  logic xor_2979;
  assign xor_2979 = bits[32] ^ (^{select_2913[31:30], other[31:30]});
  logic xor_2982;
  assign xor_2982 = xor_2973 ^ (^{select_2913[32:27], other[32:27]});
  logic xor_2983;
  assign xor_2983 = xor_2970 ^ xor_2982;
  // hls/stages/count_bits.hpp:25
  logic or_2991;
  assign or_2991 = (xor_2922 & xor_2925) | (xor_2919 & (xor_2922 | xor_2925));
  logic or_2995;
  assign or_2995 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_2999;
  assign or_2999 = (xor_2937 & xor_2940) | (xor_2934 & (xor_2937 | xor_2940));
  // hls/stages/count_bits.hpp:23
  logic or_3006;
  assign or_3006 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3010;
  assign or_3010 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3014;
  assign or_3014 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3017;
  assign parity_3017 = ^{or_3014, or_3010, or_3006};
  // hls/stages/count_bits.hpp:23
  logic or_3021;
  assign or_3021 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3025;
  assign or_3025 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3029;
  assign or_3029 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3032;
  assign parity_3032 = ^{or_3029, or_3025, or_3021};
  logic parity_3035;
  assign parity_3035 = ^{or_3029, or_3025, or_3021, or_3014, or_3010, or_3006, or_2999, or_2995, or_2991};
  // hls/stages/count_bits.hpp:23
  logic or_3039;
  assign or_3039 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3043;
  assign or_3043 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3047;
  assign or_3047 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3055;
  assign or_3055 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3059;
  assign or_3059 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3063;
  assign or_3063 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3066;
  assign parity_3066 = ^{or_3063, or_3059, or_3055};
  // hls/stages/count_bits.hpp:23
  logic or_3070;
  assign or_3070 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3074;
  assign or_3074 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3078;
  assign or_3078 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3081;
  assign parity_3081 = ^{or_3078, or_3074, or_3070};
  logic parity_3084;
  assign parity_3084 = ^{or_3078, or_3074, or_3070, or_3063, or_3059, or_3055, or_3047, or_3043, or_3039};
  // hls/stages/count_bits.hpp:25
  logic or_3088;
  assign or_3088 = (xor_2952 & xor_2955) | (xor_2949 & (xor_2952 | xor_2955));
  logic or_3092;
  assign or_3092 = (xor_2964 & xor_2967) | (xor_2961 & (xor_2964 | xor_2967));
  logic or_3096;
  assign or_3096 = (xor_2976 & xor_2979) | (xor_2973 & (xor_2976 | xor_2979));
  // hls/stages/count_bits.hpp:24
  logic parity_3099;
  assign parity_3099 = ^{or_3096, or_3092, or_3088};
  // hls/stages/count_bits.hpp:25
  logic and_3100;
  assign and_3100 = xor_2946 & (^{xor_2983, select_2913[44:36], other[44:36]});
  logic or_3104;
  assign or_3104 = (xor_2931 & xor_2943) | (xor_2928 & (xor_2931 | xor_2943));
  logic and_3107;
  assign and_3107 = (xor_2949 ^ (^{select_2913[41:36], other[41:36]})) & (xor_2970 | xor_2982);
  logic or_3108;
  assign or_3108 = (xor_2970 & xor_2982) | and_3107;
  // hls/stages/count_bits.hpp:24
  logic parity_3111;
  assign parity_3111 = ^{or_3108, or_3104, and_3100};
  logic parity_3114;
  assign parity_3114 = ^{or_3108, or_3104, and_3100, or_3096, or_3092, or_3088, or_3078, or_3074, or_3070, or_3063, or_3059, or_3055, or_3047, or_3043, or_3039};
  logic parity_3116;
  assign parity_3116 = ^{or_3108, or_3104, and_3100, or_3096, or_3092, or_3088, or_3078, or_3074, or_3070, or_3063, or_3059, or_3055, or_3047, or_3043, or_3039, or_3029, or_3025, or_3021, or_3014, or_3010, or_3006, or_2999, or_2995, or_2991};
  // hls/stages/count_bits.hpp:25
  logic and_3117;
  assign and_3117 = parity_3035 & parity_3114;
  logic or_3121;
  assign or_3121 = (parity_3017 & parity_3032) | ((^{or_2999, or_2995, or_2991}) & (parity_3017 | parity_3032));
  logic or_3125;
  assign or_3125 = (parity_3099 & parity_3111) | (parity_3084 & (parity_3099 | parity_3111));
  logic or_3132;
  assign or_3132 = (parity_3066 & parity_3081) | ((^{or_3047, or_3043, or_3039}) & (parity_3066 | parity_3081));
  logic or_3136;
  assign or_3136 = (or_3092 & or_3096) | (or_3088 & (or_3092 | or_3096));
  logic or_3140;
  assign or_3140 = (or_3104 & or_3108) | (and_3100 & (or_3104 | or_3108));
  // hls/stages/count_bits.hpp:23
  logic or_3147;
  assign or_3147 = (or_3043 & or_3047) | (or_3039 & (or_3043 | or_3047));
  // hls/stages/count_bits.hpp:25
  logic or_3151;
  assign or_3151 = (or_3059 & or_3063) | (or_3055 & (or_3059 | or_3063));
  logic or_3155;
  assign or_3155 = (or_3074 & or_3078) | (or_3070 & (or_3074 | or_3078));
  // hls/stages/count_bits.hpp:24
  logic parity_3158;
  assign parity_3158 = ^{or_3155, or_3151, or_3147};
  // hls/stages/count_bits.hpp:23
  logic or_3162;
  assign or_3162 = (or_2995 & or_2999) | (or_2991 & (or_2995 | or_2999));
  // hls/stages/count_bits.hpp:25
  logic or_3166;
  assign or_3166 = (or_3010 & or_3014) | (or_3006 & (or_3010 | or_3014));
  logic or_3170;
  assign or_3170 = (or_3025 & or_3029) | (or_3021 & (or_3025 | or_3029));
  // hls/stages/count_bits.hpp:24
  logic parity_3173;
  assign parity_3173 = ^{or_3170, or_3166, or_3162};
  logic parity_3176;
  assign parity_3176 = ^{or_3170, or_3166, or_3162, or_3155, or_3151, or_3147, or_3140, or_3136, or_3132};
  logic parity_3178;
  assign parity_3178 = ^{or_3170, or_3166, or_3162, or_3155, or_3151, or_3147, or_3140, or_3136, or_3132, or_3125, or_3121, and_3117};
  // hls/stages/count_bits.hpp:25
  logic or_3182;
  assign or_3182 = (or_3136 & or_3140) | (or_3132 & (or_3136 | or_3140));
  logic or_3186;
  assign or_3186 = (or_3151 & or_3155) | (or_3147 & (or_3151 | or_3155));
  logic or_3190;
  assign or_3190 = (or_3166 & or_3170) | (or_3162 & (or_3166 | or_3170));
  // hls/stages/count_bits.hpp:24
  logic parity_3193;
  assign parity_3193 = ^{or_3190, or_3186, or_3182};
  // hls/stages/count_bits.hpp:25
  logic and_3194;
  assign and_3194 = (^{or_3125, or_3121, and_3117}) & parity_3176;
  logic or_3198;
  assign or_3198 = (or_3121 & or_3125) | (and_3117 & (or_3121 | or_3125));
  logic or_3202;
  assign or_3202 = (parity_3158 & parity_3173) | ((^{or_3140, or_3136, or_3132}) & (parity_3158 | parity_3173));
  // hls/stages/count_bits.hpp:24
  logic parity_3205;
  assign parity_3205 = ^{or_3202, or_3198, and_3194};
  // hls/stages/count_bits.hpp:25
  logic and_3207;
  assign and_3207 = parity_3193 & parity_3205;
  logic or_3211;
  assign or_3211 = (or_3186 & or_3190) | (or_3182 & (or_3186 | or_3190));
  logic or_3215;
  assign or_3215 = (or_3198 & or_3202) | (and_3194 & (or_3198 | or_3202));
  // hls/stages/patches.hpp:166
  logic [4:0] select_3260;
  assign select_3260 = equal_1684_s3_q ? patches_along_s3_q : patches_summed_row_column_q;
  logic select_3263;
  assign select_3263 = equal_1682_s3_q ? patches_summed_first_q : (equal_1684_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:534
  logic [9:0] select_3270;
  assign select_3270 = less_1845_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3273;
  assign select_3273 = equal_1848_s3_q ? (less_1845_s3_q ? (equal_1848_s3_q ? 10'h0 : select_3270) : 10'h0) : select_3270;
  logic [9:0] select_3275;
  assign select_3275 = less_1845_s3_q ? (equal_1846_s3_q ? 10'h0 : select_3273) : select_3273;
  // hls/stages/patches.hpp:534
  logic [4:0] select_3277;
  assign select_3277 = less_1845_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:538
  logic [4:0] select_3280;
  assign select_3280 = equal_1848_s3_q ? (less_1845_s3_q ? (equal_1848_s3_q ? 5'h0 : select_3277) : 5'h0) : select_3277;
  logic [4:0] select_3282;
  assign select_3282 = less_1845_s3_q ? (equal_1846_s3_q ? 5'h0 : select_3280) : select_3280;
  // hls/stages/patches.hpp:534
  logic [4:0] select_3284;
  assign select_3284 = less_1845_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:538
  logic [4:0] select_3287;
  assign select_3287 = equal_1848_s3_q ? (less_1845_s3_q ? (equal_1848_s3_q ? 5'h0 : select_3284) : 5'h0) : select_3284;
  logic [4:0] select_3289;
  assign select_3289 = less_1845_s3_q ? (equal_1846_s3_q ? 5'h0 : select_3287) : select_3287;
  // hls/stages/patches.hpp:534
  logic and_3292;
  assign and_3292 = less_1845_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:538
  logic select_3295;
  assign select_3295 = equal_1848_s3_q ? (less_1845_s3_q ? (not_1849_s3_q & and_3292) : and_3292) : and_3292;
  // hls/stages/patches.hpp:166
  logic select_3298;
  assign select_3298 = equal_1682_s3_q ? (less_1845_s3_q ? (not_1847_s3_q & select_3295) : select_3295) : patches_read_first_q;
  // hls/stages/patches.hpp:160
  logic or_3309;
  assign or_3309 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3310;
  assign and_3310 = patches_read_searches_s3_q & or_3309;
  // hls/stages/patches.hpp:518
  logic [4:0] select_3311;
  assign select_3311 = and_3310 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:525
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3311};
  // hls/stages/patches.hpp:534
  logic and_3315;
  assign and_3315 = less_1845_s3_q & (equal_3307_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:538
  logic select_3318;
  assign select_3318 = equal_1848_s3_q ? (less_1845_s3_q ? (not_1849_s3_q & and_3315) : and_3315) : and_3315;
  // hls/stages/patches.hpp:166
  logic select_3321;
  assign select_3321 = equal_1682_s3_q ? (less_1845_s3_q ? (not_1847_s3_q & select_3318) : select_3318) : patches_read_above_q;
  // hls/stages/patches.hpp:534
  logic and_3324;
  assign and_3324 = less_1845_s3_q & (equal_3307_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:538
  logic select_3327;
  assign select_3327 = equal_1848_s3_q ? (less_1845_s3_q ? (not_1849_s3_q & and_3324) : and_3324) : and_3324;
  // hls/stages/patches.hpp:166
  logic select_3330;
  assign select_3330 = equal_1682_s3_q ? (less_1845_s3_q ? (not_1847_s3_q & select_3327) : select_3327) : patches_read_below_q;
  // hls/stages/patches.hpp:531
  logic [6:0] sum_3331;
  assign sum_3331 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:532
  logic [9:0] select_3334;
  assign select_3334 = (equal_3307_s3_q & ({sum_3331[6], sum_3331} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:534
  logic [9:0] select_3335;
  assign select_3335 = less_1845_s3_q ? select_3334 : 10'h3ff;
  // hls/stages/patches.hpp:535
  logic [9:0] select_3337;
  assign select_3337 = less_1845_s3_q ? (equal_1848_s3_q ? 10'h3ff : select_3335) : 10'h3ff;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3338;
  assign select_3338 = equal_1848_s3_q ? select_3337 : select_3335;
  logic [9:0] select_3340;
  assign select_3340 = less_1845_s3_q ? (equal_1846_s3_q ? 10'h3ff : select_3338) : select_3338;
  // hls/stages/patches.hpp:517
  logic [14:0] select_3342;
  assign select_3342 = and_3310 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:166
  logic [9:0] select_3343;
  assign select_3343 = equal_1682_s3_q ? select_3342[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3344;
  assign select_3344 = equal_1682_s3_q ? select_3342[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:519
  logic [9:0] select_3346;
  assign select_3346 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:520
  logic [9:0] select_3348;
  assign select_3348 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:521
  logic [9:0] select_3351;
  assign select_3351 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3352;
  assign select_3352 = patches_read_first_q ? patches_read_far_q : select_3351;
  // hls/stages/patches.hpp:572
  logic [9:0] difference_3355;
  assign difference_3355 = select_3352 - select_3342[9:0];
  // hls/stages/patches.hpp:557
  logic less_3385;
  assign less_3385 = select_3346 < select_3348;
  // hls/stages/patches.hpp:563
  logic [1:0] sum_3386;
  assign sum_3386 = select_3311[4:3] + 2'h3;
  // hls/stages/patches.hpp:558
  logic [9:0] high;
  assign high = less_3385 ? select_3348 : select_3346;
  logic [9:0] low;
  assign low = (select_3348 < select_3346) ? select_3348 : select_3346;
  // hls/stages/patches.hpp:559
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3342[9:0];
  // hls/stages/patches.hpp:561
  logic not_3393;
  assign not_3393 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3394;
  assign sum_3394 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3396;
  assign not_3396 = ~({eight, 3'h0} < {1'b0, sum_3394, fall[0]});
  logic [1:0] sum_3397;
  assign sum_3397 = {1'b0, not_3393} + {1'b0, not_3396};
  // hls/stages/patches.hpp:562
  logic [10:0] sum_3398;
  assign sum_3398 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3400;
  assign not_3400 = ~({eight, 3'h0} < {sum_3398, fall[1:0]});
  logic not_3403;
  assign not_3403 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3404;
  assign sum_3404 = {1'b0, not_3400} + {1'b0, not_3403};
  // hls/stages/patches.hpp:561
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3397} + {1'b0, sum_3404};
  // hls/stages/patches.hpp:564
  logic [7:0] select_3407;
  assign select_3407 = less_3385 ? ({sum_3386, select_3311[2:0], 3'h0} - {5'h0, fraction}) : {sum_3386, select_3311[2:0], fraction};
  // hls/stages/agreement.hpp:1086
  logic equal_3563;
  assign equal_3563 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/patches.hpp:322
  logic select_3580;
  assign select_3580 = equal_1469_s3_q ? shown_shown_q : (so_s3_q ? select_1910 : shown_shown_q);
  logic select_3582;
  assign select_3582 = equal_1469_s3_q ? shown_nearer_q : (so_s3_q ? select_1913 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3584;
  assign sum_3584 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3586;
  assign select_3586 = less_3583_s3_q ? (sum_3584[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3588;
  assign select_3588 = equal_2286_s3_q ? (equal_561_s3_q ? 3'h0 : select_3586) : region_row_q;
  // hls/stages/patches.hpp:322
  logic [7:0] select_3593;
  assign select_3593 = equal_1469_s3_q ? select_1870 : (so_s3_q ? (ends_cell_s3_q ? select_1963 : select_1870) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3607;
  assign select_3607 = equal_561_s3_q ? {{2{difference_3605[6]}}, difference_3605} : (less_3583_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_3609;
  assign select_3609 = and_500_s3_q ? (equal_2286_s3_q ? select_3607 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [6:0] select_3611;
  assign select_3611 = equal_561_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_3613;
  assign select_3613 = and_500_s3_q ? (equal_2286_s3_q ? select_3611 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3614;
  assign sum_3614 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3615;
  assign select_3615 = sum_3584[7] ? {1'b1, sum_3584[6:0], region_down_rest_q[0]} : sum_3614;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3584[7];
  // hls/stages/agreement.hpp:447
  logic select_3619;
  assign select_3619 = equal_2286_s3_q ? (equal_561_s3_q | (less_3583_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_3624;
  assign or_3624 = segment_starts_q | not_1509;
  // hls/stages/agreement.hpp:976
  logic select_3627;
  assign select_3627 = shift_2_s3_q[0] ? (sum_1883_s3_q ? (equal_1675 & or_1885) : or_1885) : or_3624;
  // hls/stages/patches.hpp:322
  logic select_3630;
  assign select_3630 = equal_1469_s3_q ? or_3624 : (so_s3_q ? (ends_cell_s3_q ? select_3627 : or_3624) : or_3624);
  logic [2:0] select_3704;
  assign select_3704 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_3706;
  assign select_3706 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3708;
  assign select_3708 = equal_1469_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3706 : box_textured_columns_values_1_q);
  logic [2:0] select_3709;
  assign select_3709 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3711;
  assign select_3711 = equal_1469_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_3709 : box_textured_columns_values_2_q);
  logic [2:0] select_3712;
  assign select_3712 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3714;
  assign select_3714 = equal_1469_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_3712 : box_textured_columns_values_3_q);
  logic [2:0] select_3715;
  assign select_3715 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3717;
  assign select_3717 = equal_1469_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_3715 : box_textured_columns_values_4_q);
  logic [4:0] select_3719;
  assign select_3719 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3722;
  assign select_3722 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3724;
  assign select_3724 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3726;
  assign select_3726 = equal_1469_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_3724 : box_explained_columns_values_1_q);
  logic [2:0] select_3727;
  assign select_3727 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3729;
  assign select_3729 = equal_1469_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_3727 : box_explained_columns_values_2_q);
  logic [2:0] select_3730;
  assign select_3730 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3732;
  assign select_3732 = equal_1469_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_3730 : box_explained_columns_values_3_q);
  logic [2:0] select_3733;
  assign select_3733 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3735;
  assign select_3735 = equal_1469_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_3733 : box_explained_columns_values_4_q);
  logic [4:0] select_3737;
  assign select_3737 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3738;
  assign select_3738 = equal_1469_s3_q ? box_explained_sum_sums_values_0_q : select_3737;
  logic [2:0] select_3740;
  assign select_3740 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3742;
  assign select_3742 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3744;
  assign select_3744 = equal_1469_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_3742 : box_shown_columns_values_1_q);
  logic [2:0] select_3745;
  assign select_3745 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3747;
  assign select_3747 = equal_1469_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_3745 : box_shown_columns_values_2_q);
  logic [2:0] select_3748;
  assign select_3748 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3750;
  assign select_3750 = equal_1469_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_3748 : box_shown_columns_values_3_q);
  logic [2:0] select_3751;
  assign select_3751 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3753;
  assign select_3753 = equal_1469_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_3751 : box_shown_columns_values_4_q);
  logic [4:0] select_3755;
  assign select_3755 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_3758;
  assign select_3758 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3760;
  assign select_3760 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3762;
  assign select_3762 = equal_1469_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_3760 : box_nearer_columns_values_1_q);
  logic [2:0] select_3763;
  assign select_3763 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3765;
  assign select_3765 = equal_1469_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_3763 : box_nearer_columns_values_2_q);
  logic [2:0] select_3766;
  assign select_3766 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3768;
  assign select_3768 = equal_1469_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_3766 : box_nearer_columns_values_3_q);
  logic [2:0] select_3769;
  assign select_3769 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3771;
  assign select_3771 = equal_1469_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_3769 : box_nearer_columns_values_4_q);
  logic [4:0] select_3773;
  assign select_3773 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_3776;
  assign select_3776 = so_s3_q ? (ends_cell_s3_q ? and_1951 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3779;
  assign select_3779 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_3781;
  assign select_3781 = equal_1469_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_3779 : centres_values_0_of_skin_q);
  logic select_3782;
  assign select_3782 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3784;
  assign select_3784 = equal_1469_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_3782 : centres_values_1_textured_q);
  logic select_3785;
  assign select_3785 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3787;
  assign select_3787 = equal_1469_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_3785 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:447
  logic [10:0] select_3791;
  assign select_3791 = equal_2286_s3_q ? (equal_3788_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [5:0] select_3794;
  assign select_3794 = and_500_s3_q ? (equal_2286_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1198
  logic xor_3795;
  assign xor_3795 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:424
  logic select_3797;
  assign select_3797 = and_1862_s3_q ? (left_first_s3_q ? xor_3795 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:265
  logic select_3799;
  assign select_3799 = and_1862_s3_q ? (left_first_s3_q ? xor_3795 : select_3797) : write_half_q;
  logic select_3801;
  assign select_3801 = left_first_s3_q ? select_1916 : (and_1862_s3_q ? select_1917 : read_half_q);
  logic and_3805;
  assign and_3805 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_3814;
  assign select_3814 = left_first_s3_q ? 10'h1 : (and_1862_s3_q ? select_1921 : rows_passed_q);
  logic [8:0] select_3817;
  assign select_3817 = left_first_s3_q ? {select_1919[7:0], or_1918} : (and_1862_s3_q ? {select_1919[7:0], or_1918} : columns_passed_q);
  logic select_3820;
  assign select_3820 = left_first_s3_q ? marks_last_s3_q : (and_1862_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_3823;
  assign select_3823 = left_first_s3_q ? and_1935 : (and_1862_s3_q ? and_1935 : began_q);
  logic [2:0] select_3826;
  assign select_3826 = left_first_s3_q ? select_1937 : (and_1862_s3_q ? select_1937 : seen_x_q);
  // hls/stages/agreement.hpp:1227
  logic [2:0] select_3831;
  assign select_3831 = left_first_s3_q ? 3'h0 : (and_1922 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:265
  logic [2:0] select_3833;
  assign select_3833 = left_first_s3_q ? 3'h0 : (and_1862_s3_q ? select_3831 : seen_y_q);
  logic [7:0] select_3836;
  assign select_3836 = left_first_s3_q ? select_1930 : (and_1862_s3_q ? select_1930 : seen_column_q);
  // hls/stages/agreement.hpp:422
  logic [7:0] select_3842;
  assign select_3842 = left_first_s3_q ? select_3840 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:265
  logic [7:0] select_3844;
  assign select_3844 = left_first_s3_q ? select_3840 : (and_1862_s3_q ? select_3842 : seen_rows_left_q);
  // hls/stages/agreement.hpp:422
  logic and_3849;
  assign and_3849 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:265
  logic select_3851;
  assign select_3851 = left_first_s3_q ? and_3849 : (and_1862_s3_q ? and_3849 : at_cell_end_q);
  logic select_3854;
  assign select_3854 = left_first_s3_q ? next_row : (and_1862_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_3857;
  assign select_3857 = left_first_s3_q ? 11'h0 : (and_1862_s3_q ? select_1927 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_3924;
  assign not_3924 = ~quarter[1];
  logic [3:0] select_3925;
  assign select_3925 = quarter[0] ? {quarter[1], 1'b0, not_3924, 1'b0} : {1'b0, quarter[1], 1'b0, not_3924};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1521;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_1564;
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 22, DISTANCE 12, hls/stages/patches.hpp:725; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [21:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 22'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1598;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_1600));
  logic [21:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1319; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1880;
  logic regions_re;
  assign regions_re = s3_en & (equal_1469_s3_q ? (x_s3_q[6] & not_1881) : and_1888);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1330; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_1932;
  logic map_re;
  assign map_re = s3_en & select_1944;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_470_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_475_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_494, and_490, sum_486, sum_482};
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
  assign census_memory_we = s3_en & and_500_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_518, whole_2, select_510, select_506};
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
  assign shown_right_waddr = select_1508_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1513_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1510, not_1509};
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
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1796, patches_code_row_s3_q[1:0], of_row_2_s3_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_1830_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1816_s3_q, less_1815_s3_q, less_1806_s3_q, less_1805_s3_q, patches_codes_at_q[51:28]};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_codes_we) begin
      if (patches_right_codes_re && patches_right_codes_raddr == patches_right_codes_waddr) begin
        $error("patches_right_codes: address %0d is read less than DISTANCE steps after its write", patches_right_codes_waddr);
      end
      if (patches_right_codes_waddr >= 7'd112) $error("patches_right_codes: write outside, address %0d", patches_right_codes_waddr);
    end
    if (rst_ni && patches_right_codes_re && patches_right_codes_raddr >= 7'd112) $error("patches_right_codes: read outside, address %0d", patches_right_codes_raddr);
  end
`endif

  // Memory patches_left_codes, write
  logic [3:0] patches_left_codes_waddr;
  assign patches_left_codes_waddr = {sum_1834, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_1844_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1816_s3_q, less_1815_s3_q, less_1806_s3_q, less_1805_s3_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s3_en & and_1504_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1909, textured_s3_q};
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
      patches_codes_at_q <= 52'h0;
      patches_codes_further_q <= 28'h0;
      patches_next_codes_q <= 56'h0;
      patches_set_q <= 3'h0;
      patches_size_q <= 10'h0;
      patches_left_row_q <= 48'h0;
      patches_summed_row_column_q <= 5'h0;
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
      averager_running_of_skin_q <= select_2075;
      averager_mask_q <= select_2077;
      averager_of_skin_q <= select_2079;
      census_filled_q <= and_500_s3_q ? {select_564[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_500_s3_q ? select_563 : rows_passed_above_q;
      registration_slope_here_q <= select_2511;
      registration_expected_q <= select_2513;
      registration_of_right_q <= equal_1469_s3_q ? registration_of_right_q : select_2573;
      registration_was_inside_q <= equal_1469_s3_q ? registration_was_inside_q : select_2576;
      registration_fresh_q <= select_2585;
      patches_chance_q <= and_500_s3_q ? select_2742 : patches_chance_q;
      patches_fixed_q <= and_2756;
      patches_choice_valid_q <= and_1680 ? (select_1674[0] & not_2744) : select_1674[0];
      patches_choice_column_q <= select_1674[7:1];
      patches_choice_shift_q <= select_1674[13:8];
      patches_choice_slope_q <= select_1674[21:14];
      patches_band_q <= sample_pair_whole_s3_q ? select_1695 : patches_band_q;
      patches_fetch_q <= select_2771;
      patches_codes_at_q <= select_2872;
      patches_codes_further_q <= equal_1682_s3_q ? patches_codes_further_q : select_2877;
      patches_next_codes_q <= select_2885;
      patches_set_q <= equal_1682_s3_q ? 3'h0 : (equal_1684_s3_q ? 3'h0 : select_2899);
      patches_size_q <= sum_2903;
      patches_left_row_q <= select_2915;
      patches_summed_row_column_q <= equal_1682_s3_q ? patches_summed_row_column_q : select_3260;
      patches_summed_first_q <= select_3263;
      patches_read_row_differing_q <= equal_1682_s3_q ? select_3275 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1682_s3_q ? select_3282 : patches_read_row_column_q;
      patches_read_at_q <= equal_1682_s3_q ? select_3289 : patches_read_at_q;
      patches_read_first_q <= select_3298;
      patches_read_above_q <= select_3321;
      patches_read_below_q <= select_3330;
      patches_read_far_q <= equal_1682_s3_q ? select_3340 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3343;
      patches_peak_best_column_q <= select_3344;
      patches_peak_row_q <= equal_1682_s3_q ? select_3311 : patches_peak_row_q;
      patches_peak_above_q <= equal_1682_s3_q ? select_3346 : patches_peak_above_q;
      patches_peak_below_q <= equal_1682_s3_q ? select_3348 : patches_peak_below_q;
      patches_peak_far_q <= equal_1682_s3_q ? select_3352 : patches_peak_far_q;
      shown_shown_q <= select_3580;
      shown_nearer_q <= select_3582;
      region_row_q <= and_500_s3_q ? select_3588 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3593;
      region_down_rest_q <= select_3609;
      region_down_back_q <= select_3613;
      region_down_next_q <= select_3615;
      region_fresh_q <= and_500_s3_q ? select_3619 : region_fresh_q;
      segment_starts_q <= select_3630;
      centres_values_0_textured_q <= equal_1469_s3_q ? centres_values_0_textured_q : select_3776;
      centres_values_0_of_skin_q <= select_3781;
      centres_values_1_textured_q <= select_3784;
      centres_values_1_of_skin_q <= select_3787;
      map_row_q <= and_500_s3_q ? select_3791 : map_row_q;
      map_width_q <= select_3794;
      write_half_q <= select_3799;
      read_half_q <= and_1862_s3_q ? select_3801 : read_half_q;
      done_q <= and_1862_s3_q ? (not_1933 & and_3805) : and_3805;
      drew_q <= so_s3_q;
      said_q <= equal_1469_s3_q & equal_3563;
      rows_passed_q <= and_1862_s3_q ? select_3814 : rows_passed_q;
      columns_passed_q <= and_1862_s3_q ? select_3817 : columns_passed_q;
      line_ended_q <= and_1862_s3_q ? select_3820 : line_ended_q;
      began_q <= and_1862_s3_q ? select_3823 : began_q;
      seen_x_q <= and_1862_s3_q ? select_3826 : seen_x_q;
      seen_y_q <= and_1862_s3_q ? select_3833 : seen_y_q;
      seen_column_q <= and_1862_s3_q ? select_3836 : seen_column_q;
      seen_rows_left_q <= and_1862_s3_q ? select_3844 : seen_rows_left_q;
      at_cell_end_q <= and_1862_s3_q ? select_3851 : at_cell_end_q;
      was_next_row_q <= and_1862_s3_q ? select_3854 : was_next_row_q;
      seen_base_q <= and_1862_s3_q ? select_3857 : seen_base_q;
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
      left_pixel_q <= and_1862_s3_q ? left_pixel_q : pixel_0_s3_q;
      averager_running_0_q <= sample_pair_whole_s3_q ? select_478 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_484 : averager_running_1_q;
      averager_total_0_q <= select_2054;
      averager_total_1_q <= select_2056;
      census_columns_values_0_cell_0_left_q <= select_2080;
      census_columns_values_0_cell_0_right_q <= select_2081;
      census_columns_values_0_cell_0_mask_q <= and_500_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2083;
      census_columns_values_0_cell_1_right_q <= select_2084;
      census_columns_values_0_cell_1_mask_q <= select_2085;
      census_columns_values_0_cell_2_left_q <= select_2086;
      census_columns_values_0_cell_2_right_q <= select_2087;
      census_columns_values_0_cell_2_mask_q <= select_2088;
      census_columns_values_0_cell_2_of_skin_q <= select_2089;
      census_columns_values_0_cell_3_left_q <= select_2090;
      census_columns_values_0_cell_3_right_q <= select_2091;
      census_columns_values_0_cell_3_mask_q <= select_2092;
      census_columns_values_0_cell_4_left_q <= select_2093;
      census_columns_values_0_cell_4_right_q <= select_2094;
      census_columns_values_0_cell_4_mask_q <= select_2095;
      census_columns_values_1_cell_0_left_q <= select_2096;
      census_columns_values_1_cell_0_right_q <= select_2097;
      census_columns_values_1_cell_0_mask_q <= select_2098;
      census_columns_values_1_cell_1_left_q <= select_2099;
      census_columns_values_1_cell_1_right_q <= select_2100;
      census_columns_values_1_cell_1_mask_q <= select_2101;
      census_columns_values_1_cell_2_left_q <= select_2102;
      census_columns_values_1_cell_2_right_q <= select_2103;
      census_columns_values_1_cell_2_mask_q <= select_2104;
      census_columns_values_1_cell_2_of_skin_q <= select_2105;
      census_columns_values_1_cell_3_left_q <= select_2106;
      census_columns_values_1_cell_3_right_q <= select_2107;
      census_columns_values_1_cell_3_mask_q <= select_2108;
      census_columns_values_1_cell_4_left_q <= select_2109;
      census_columns_values_1_cell_4_right_q <= select_2110;
      census_columns_values_1_cell_4_mask_q <= select_2111;
      census_columns_values_2_cell_0_left_q <= select_2112;
      census_columns_values_2_cell_0_right_q <= select_2113;
      census_columns_values_2_cell_0_mask_q <= select_2114;
      census_columns_values_2_cell_1_left_q <= select_2115;
      census_columns_values_2_cell_1_right_q <= select_2116;
      census_columns_values_2_cell_1_mask_q <= select_2117;
      census_columns_values_2_cell_2_left_q <= select_2118;
      census_columns_values_2_cell_2_right_q <= select_2119;
      census_columns_values_2_cell_2_mask_q <= select_2120;
      census_columns_values_2_cell_3_left_q <= select_2121;
      census_columns_values_2_cell_3_right_q <= select_2122;
      census_columns_values_2_cell_3_mask_q <= select_2123;
      census_columns_values_2_cell_4_left_q <= select_2124;
      census_columns_values_2_cell_4_right_q <= select_2125;
      census_columns_values_2_cell_4_mask_q <= select_2126;
      census_columns_values_3_cell_0_mask_q <= select_2127;
      census_columns_values_3_cell_1_left_q <= select_2128;
      census_columns_values_3_cell_1_right_q <= select_2129;
      census_columns_values_3_cell_1_mask_q <= select_2130;
      census_columns_values_3_cell_2_mask_q <= select_2131;
      census_columns_values_3_cell_3_left_q <= select_2132;
      census_columns_values_3_cell_3_right_q <= select_2133;
      census_columns_values_3_cell_3_mask_q <= select_2134;
      census_columns_values_3_cell_4_mask_q <= select_2135;
      sharpness_last_mean_0_q <= and_500_s3_q ? select_506 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_500_s3_q ? select_510 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1469_s3_q ? box_textured_columns_values_0_q : select_3704;
      box_textured_columns_values_1_q <= select_3708;
      box_textured_columns_values_2_q <= select_3711;
      box_textured_columns_values_3_q <= select_3714;
      box_textured_columns_values_4_q <= select_3717;
      box_textured_sum_sums_values_0_q <= equal_1469_s3_q ? box_textured_sum_sums_values_0_q : select_3719;
      box_explained_columns_values_0_q <= equal_1469_s3_q ? box_explained_columns_values_0_q : select_3722;
      box_explained_columns_values_1_q <= select_3726;
      box_explained_columns_values_2_q <= select_3729;
      box_explained_columns_values_3_q <= select_3732;
      box_explained_columns_values_4_q <= select_3735;
      box_explained_sum_sums_values_0_q <= select_3738;
      box_shown_columns_values_0_q <= equal_1469_s3_q ? box_shown_columns_values_0_q : select_3740;
      box_shown_columns_values_1_q <= select_3744;
      box_shown_columns_values_2_q <= select_3747;
      box_shown_columns_values_3_q <= select_3750;
      box_shown_columns_values_4_q <= select_3753;
      box_shown_sum_sums_values_0_q <= equal_1469_s3_q ? box_shown_sum_sums_values_0_q : select_3755;
      box_nearer_columns_values_0_q <= equal_1469_s3_q ? box_nearer_columns_values_0_q : select_3758;
      box_nearer_columns_values_1_q <= select_3762;
      box_nearer_columns_values_2_q <= select_3765;
      box_nearer_columns_values_3_q <= select_3768;
      box_nearer_columns_values_4_q <= select_3771;
      box_nearer_sum_sums_values_0_q <= equal_1469_s3_q ? box_nearer_sum_sums_values_0_q : select_3773;
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
  logic [2:0] select_464_s4_q;
  logic [5:0] select_466_s4_q;
  logic [5:0] column_s4_q;
  logic and_498_s4_q;
  logic and_500_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_503_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
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
  logic less_556_s4_q;
  logic less_557_s4_q;
  logic and_565_s4_q;
  logic and_590_s4_q;
  logic and_591_s4_q;
  logic [11:0] sum_606_s4_q;
  logic [9:0] sum_609_s4_q;
  logic equal_1469_s4_q;
  logic not_1470_s4_q;
  logic equal_1514_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1520_s4_q;
  logic equal_1522_s4_q;
  logic equal_1524_s4_q;
  logic equal_1526_s4_q;
  logic equal_1528_s4_q;
  logic equal_1530_s4_q;
  logic equal_1532_s4_q;
  logic equal_1534_s4_q;
  logic equal_1536_s4_q;
  logic less_1545_s4_q;
  logic or_1549_s4_q;
  logic equal_1569_s4_q;
  logic and_1579_s4_q;
  logic and_1582_s4_q;
  logic select_1599_s4_q;
  logic equal_1600_s4_q;
  logic and_1608_s4_q;
  logic equal_1610_s4_q;
  logic select_1674_s4_q;
  logic and_1681_s4_q;
  logic equal_1682_s4_q;
  logic equal_1684_s4_q;
  logic and_1697_s4_q;
  logic [4:0] select_1712_s4_q;
  logic select_1718_s4_q;
  logic [3:0] select_1759_s4_q;
  logic less_1845_s4_q;
  logic equal_1846_s4_q;
  logic not_1847_s4_q;
  logic equal_1848_s4_q;
  logic and_1862_s4_q;
  logic select_1864_s4_q;
  logic and_1867_s4_q;
  logic or_1873_s4_q;
  logic or_1876_s4_q;
  logic or_1879_s4_q;
  logic not_1881_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1902_s4_q;
  logic and_1907_s4_q;
  logic and_1939_s4_q;
  logic less_1940_s4_q;
  logic [11:0] sum_1948_s4_q;
  logic equal_1961_s4_q;
  logic or_1966_s4_q;
  logic or_1969_s4_q;
  logic or_1972_s4_q;
  logic not_1997_s4_q;
  logic less_2011_s4_q;
  logic and_2022_s4_q;
  logic [11:0] sum_2151_s4_q;
  logic [9:0] sum_2154_s4_q;
  logic equal_2162_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2402_s4_q;
  logic and_2406_s4_q;
  logic not_2440_s4_q;
  logic and_2468_s4_q;
  logic and_2517_s4_q;
  logic and_2518_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2552_s4_q;
  logic and_2566_s4_q;
  logic equal_2609_s4_q;
  logic parity_2987_s4_q;
  logic parity_3116_s4_q;
  logic parity_3178_s4_q;
  logic xor_3206_s4_q;
  logic parity_3218_s4_q;
  logic or_3222_s4_q;
  logic equal_3223_s4_q;
  logic [4:0] select_3342_s4_q;
  logic equal_3354_s4_q;
  logic less_3356_s4_q;
  logic less_3357_s4_q;
  logic or_3362_s4_q;
  logic [7:0] select_3407_s4_q;
  logic equal_3563_s4_q;
  logic and_3860_s4_q;
  logic equal_3927_s4_q;
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
      patches_summed_row_column_s4_q <= patches_summed_row_column_q;
      patches_summed_first_s4_q <= patches_summed_first_q;
      patches_summed_last_s4_q <= patches_summed_last_s3_q;
      patches_summed_down_by_s4_q <= patches_summed_down_by_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      done_s4_q <= done_q;
      select_464_s4_q <= select_464_s3_q;
      select_466_s4_q <= select_466_s3_q;
      column_s4_q <= column_s3_q;
      and_498_s4_q <= and_498_s3_q;
      and_500_s4_q <= and_500_s3_q;
      grey_s4_q <= grey;
      equal_503_s4_q <= equal_503;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
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
      less_556_s4_q <= less_556;
      less_557_s4_q <= less_557;
      and_565_s4_q <= and_565;
      and_590_s4_q <= whole_22 & and_565;
      and_591_s4_q <= census_columns_values_1_cell_2_mask_q & and_565;
      sum_606_s4_q <= {1'b0, sum_602} + {2'h0, sum_605};
      sum_609_s4_q <= {9'h0, difference_607[9]} + {1'b0, xor_608};
      equal_1469_s4_q <= equal_1469_s3_q;
      not_1470_s4_q <= not_1470_s3_q;
      equal_1514_s4_q <= equal_1514;
      all_s4_q <= all;
      sum_1520_s4_q <= sum_1520;
      equal_1522_s4_q <= equal_1522;
      equal_1524_s4_q <= equal_1524;
      equal_1526_s4_q <= equal_1526;
      equal_1528_s4_q <= equal_1528;
      equal_1530_s4_q <= equal_1530;
      equal_1532_s4_q <= equal_1532;
      equal_1534_s4_q <= equal_1534;
      equal_1536_s4_q <= equal_1536;
      less_1545_s4_q <= less_1545;
      or_1549_s4_q <= or_1549;
      equal_1569_s4_q <= (registration_fresh_q & select_1567) == 4'h0;
      and_1579_s4_q <= not_1470_s3_q & and_1563;
      and_1582_s4_q <= and_1582_s3_q;
      select_1599_s4_q <= select_1599[1];
      equal_1600_s4_q <= equal_1600;
      and_1608_s4_q <= and_1608;
      equal_1610_s4_q <= equal_1610;
      select_1674_s4_q <= select_1674[0];
      and_1681_s4_q <= and_1681;
      equal_1682_s4_q <= equal_1682_s3_q;
      equal_1684_s4_q <= equal_1684_s3_q;
      and_1697_s4_q <= and_1681 & equal_1696;
      select_1712_s4_q <= select_1712_s3_q;
      select_1718_s4_q <= select_1718_s3_q;
      select_1759_s4_q <= select_1759_s3_q;
      less_1845_s4_q <= less_1845_s3_q;
      equal_1846_s4_q <= equal_1846_s3_q;
      not_1847_s4_q <= not_1847_s3_q;
      equal_1848_s4_q <= equal_1848_s3_q;
      and_1862_s4_q <= and_1862_s3_q;
      select_1864_s4_q <= select_1864_s3_q;
      and_1867_s4_q <= and_1867_s3_q;
      or_1873_s4_q <= or_1873;
      or_1876_s4_q <= or_1876;
      or_1879_s4_q <= or_1879;
      not_1881_s4_q <= not_1881;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1902_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_1907_s4_q <= not_1470_s3_q & and_1888;
      and_1939_s4_q <= and_1939;
      less_1940_s4_q <= less_1940;
      sum_1948_s4_q <= sum_1948;
      equal_1961_s4_q <= t[4:1] == 4'h0;
      or_1966_s4_q <= or_1966;
      or_1969_s4_q <= select_1963[7] | (~({select_1963[6], select_1963[3:2]} == 3'h0));
      or_1972_s4_q <= select_1963[7] | (~(select_1963[6:4] == 3'h0));
      not_1997_s4_q <= ~({sum_1995, around[0]} < {2'h0, t});
      less_2011_s4_q <= {1'b0, around[4:1]} < n;
      and_2022_s4_q <= and_2022;
      sum_2151_s4_q <= {1'b0, sum_2147} + {2'h0, sum_2150};
      sum_2154_s4_q <= {9'h0, difference_2152[9]} + {1'b0, xor_2153};
      equal_2162_s4_q <= equal_2162_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2402_s4_q <= and_2402;
      and_2406_s4_q <= and_2406;
      not_2440_s4_q <= ~({sum_2438, e[0]} < {2'h0, t});
      and_2468_s4_q <= not_1470_s3_q & and_2467;
      and_2517_s4_q <= not_1470_s3_q & (so_s3_q & (half_ends & equal_2514));
      and_2518_s4_q <= and_2518;
      residual_s4_q <= residual[7:0];
      and_2552_s4_q <= and_2552;
      and_2566_s4_q <= and_2518 & less_2565;
      equal_2609_s4_q <= (registration_fresh_q & select_2607) == 4'h0;
      parity_2987_s4_q <= ^{xor_2983, xor_2946, select_2913[44:36], other[44:36]};
      parity_3116_s4_q <= parity_3116;
      parity_3178_s4_q <= parity_3178;
      xor_3206_s4_q <= parity_3193 ^ parity_3205;
      parity_3218_s4_q <= ^{or_3215, or_3211, and_3207};
      or_3222_s4_q <= (or_3211 & or_3215) | (and_3207 & (or_3211 | or_3215));
      equal_3223_s4_q <= equal_3223_s3_q;
      select_3342_s4_q <= select_3342[14:10];
      equal_3354_s4_q <= select_3311[3:0] == 4'h0;
      less_3356_s4_q <= {difference_3355, 2'h0} < {2'h0, sum_2903};
      less_3357_s4_q <= select_3352 < select_3342[9:0];
      or_3362_s4_q <= (sum_2903 < 10'h39) | ({1'b0, sum_2903[9:1]} < select_3342[9:0]);
      select_3407_s4_q <= select_3407;
      equal_3563_s4_q <= equal_3563;
      and_3860_s4_q <= and_2022 & (sum_1948 == sum_1932);
      equal_3927_s4_q <= (registration_fresh_q & select_3925) == 4'h0;
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
  logic patches_settled_q;
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
  assign texture = sum_606_s4_q + {2'h0, sum_609_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_611;
  assign sum_611 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_613;
  assign sum_613 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_611});
  // hls/stages/census.hpp:303
  logic less_614;
  assign less_614 = 9'h4 < sum_613[13:5];
  logic and_615;
  assign and_615 = and_565_s4_q & less_614;
  // hls/stages/registration.hpp:265
  logic equal_1571;
  assign equal_1571 = sum_1520_s4_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1520_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1573;
  assign select_1573 = equal_1571 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1574;
  assign sum_1574 = (equal_1569_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1573[13]}}, select_1573};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1520_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1577;
  assign select_1577 = equal_1571 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1578;
  assign sum_1578 = (equal_1569_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1577[6]}}, select_1577};
  // hls/stages/patches.hpp:335
  logic [21:0] select_1698;
  assign select_1698 = and_1697_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1674_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:109
  logic select_1700;
  assign select_1700 = equal_1600_s4_q ? patches_place_0_valid_q : (select_1599_s4_q ? patches_place_0_valid_q : select_1698[0]);
  // hls/stages/patches.hpp:336
  logic [20:0] select_1701;
  assign select_1701 = select_1599_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1698[21:1];
  // hls/stages/patches.hpp:109
  logic [6:0] select_1702;
  assign select_1702 = equal_1600_s4_q ? patches_place_0_column_q : select_1701[6:0];
  logic [5:0] select_1703;
  assign select_1703 = equal_1600_s4_q ? patches_place_0_shift_q : select_1701[12:7];
  // hls/stages/patches.hpp:306
  logic [6:0] sum_1704;
  assign sum_1704 = select_1702 + {select_1703[5], select_1703};
  // hls/stages/patches.hpp:307
  logic [5:0] sum_1705;
  assign sum_1705 = sum_1704[6:1] + 6'h3f;
  // hls/stages/patches.hpp:113
  logic equal_1706;
  assign equal_1706 = {sum_1705[5], select_466_s4_q, select_464_s4_q} == {1'b0, sum_1705[4:0], sum_1704[0], 3'h4};
  // hls/stages/patches.hpp:115
  logic or_1708;
  assign or_1708 = and_1582_s4_q | (select_1700 & equal_1706);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_1709;
  assign select_1709 = or_1708 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:115
  logic [5:0] select_1719;
  assign select_1719 = or_1708 ? {and_1582_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:119
  logic and_1721;
  assign and_1721 = select_1718_s4_q & (~select_1719[5]);
  // hls/stages/patches.hpp:109
  logic select_1729;
  assign select_1729 = equal_1600_s4_q ? patches_place_1_valid_q : (select_1599_s4_q ? select_1698[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:336
  logic [20:0] select_1730;
  assign select_1730 = select_1599_s4_q ? select_1698[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:109
  logic [6:0] select_1731;
  assign select_1731 = equal_1600_s4_q ? patches_place_1_column_q : select_1730[6:0];
  logic [5:0] select_1732;
  assign select_1732 = equal_1600_s4_q ? patches_place_1_shift_q : select_1730[12:7];
  // hls/stages/patches.hpp:306
  logic [6:0] sum_1733;
  assign sum_1733 = select_1731 + {select_1732[5], select_1732};
  // hls/stages/patches.hpp:307
  logic [5:0] sum_1734;
  assign sum_1734 = sum_1733[6:1] + 6'h3f;
  // hls/stages/patches.hpp:113
  logic equal_1735;
  assign equal_1735 = {sum_1734[5], select_466_s4_q, select_464_s4_q} == {1'b0, sum_1734[4:0], sum_1733[0], 3'h4};
  // hls/stages/patches.hpp:115
  logic or_1737;
  assign or_1737 = and_1582_s4_q | (select_1729 & equal_1735);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_1738;
  assign select_1738 = or_1737 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:115
  logic [5:0] select_1739;
  assign select_1739 = or_1737 ? {and_1582_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:119
  logic and_1741;
  assign and_1741 = select_1718_s4_q & (~select_1739[5]);
  // hls/stages/patches.hpp:302
  logic [6:0] sum_1748;
  assign sum_1748 = select_1702 + 7'h7f;
  // hls/stages/patches.hpp:114
  logic equal_1749;
  assign equal_1749 = {sum_1748[6], select_466_s4_q, select_464_s4_q} == {1'b0, sum_1748[5:0], 3'h4};
  // hls/stages/patches.hpp:116
  logic or_1751;
  assign or_1751 = and_1582_s4_q | (select_1700 & equal_1749);
  logic [4:0] select_1752;
  assign select_1752 = or_1751 ? {and_1582_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:302
  logic [6:0] sum_1753;
  assign sum_1753 = select_1731 + 7'h7f;
  // hls/stages/patches.hpp:114
  logic equal_1754;
  assign equal_1754 = {sum_1753[6], select_466_s4_q, select_464_s4_q} == {1'b0, sum_1753[5:0], 3'h4};
  // hls/stages/patches.hpp:116
  logic [4:0] select_1757;
  assign select_1757 = (and_1582_s4_q | (select_1729 & equal_1754)) ? {and_1582_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:124
  logic [3:0] column_5;
  assign column_5 = select_1752[4] ? select_1757[3:0] : select_1752[3:0];
  // hls/stages/agreement.hpp:263
  logic select_1760;
  assign select_1760 = or_1751 ? and_1582_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:124
  logic and_1766;
  assign and_1766 = (select_1718_s4_q & (select_1712_s4_q[3] ^ select_1712_s4_q[4])) & ((~select_1752[4]) | (~select_1757[4]));
  // hls/stages/patches.hpp:166
  logic less_1857;
  assign less_1857 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:167
  logic not_1858;
  assign not_1858 = ~less_1857;
  logic [1:0] select_1859;
  assign select_1859 = patches_summed_first_s4_q ? 2'h2 : {less_1857, not_1858};
  logic [12:0] select_1860;
  assign select_1860 = select_1859[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1868;
  assign select_1868 = select_1859[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1867_s4_q, 1'b0, select_1864_s4_q, left_pixel_q};
  logic [14:0] select_1869;
  assign select_1869 = select_1859[1] ? {select_1860[12:8], patches_sums_values_0_q[9:8], select_1860[7:0]} : select_1868;
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1892;
  assign select_1892 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:867
  logic [5:0] sum_1893;
  assign sum_1893 = {5'h0, textured_s4_q} + select_1892;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_1895;
  assign sum_1895 = {4'h0, sum_1893} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1897;
  assign select_1897 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:867
  logic [5:0] sum_1898;
  assign sum_1898 = {5'h0, explained_s4_q} + select_1897;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_1900;
  assign sum_1900 = {4'h0, sum_1898} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1903;
  assign select_1903 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:868
  logic [5:0] sum_1904;
  assign sum_1904 = {5'h0, and_1902_s4_q} + select_1903;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_1906;
  assign sum_1906 = {4'h0, sum_1904} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1043
  logic not_1973;
  assign not_1973 = ~region_row_s4_q[2];
  logic [2:0] select_1974;
  assign select_1974 = region_row_s4_q[1] ? {1'b0, not_1973, 1'b0} : {region_row_s4_q[2], 1'b0, not_1973};
  logic [5:0] select_1975;
  assign select_1975 = region_row_s4_q[0] ? {select_1974[2], 1'b0, select_1974[1], 1'b0, select_1974[0], 1'b0} : {1'b0, select_1974[2], 1'b0, select_1974[1], 1'b0, select_1974[0]};
  logic [11:0] select_1976;
  assign select_1976 = or_1972_s4_q ? {select_1975[5], 1'b0, select_1975[4], 1'b0, select_1975[3], 1'b0, select_1975[2], 1'b0, select_1975[1], 1'b0, select_1975[0], 1'b0} : {1'b0, select_1975[5], 1'b0, select_1975[4], 1'b0, select_1975[3], 1'b0, select_1975[2], 1'b0, select_1975[1], 1'b0, select_1975[0]};
  logic [23:0] select_1977;
  assign select_1977 = or_1969_s4_q ? {select_1976[11], 1'b0, select_1976[10], 1'b0, select_1976[9], 1'b0, select_1976[8], 1'b0, select_1976[7], 1'b0, select_1976[6], 1'b0, select_1976[5], 1'b0, select_1976[4], 1'b0, select_1976[3], 1'b0, select_1976[2], 1'b0, select_1976[1], 1'b0, select_1976[0], 1'b0} : {1'b0, select_1976[11], 1'b0, select_1976[10], 1'b0, select_1976[9], 1'b0, select_1976[8], 1'b0, select_1976[7], 1'b0, select_1976[6], 1'b0, select_1976[5], 1'b0, select_1976[4], 1'b0, select_1976[3], 1'b0, select_1976[2], 1'b0, select_1976[1], 1'b0, select_1976[0]};
  logic [47:0] select_1978;
  assign select_1978 = or_1966_s4_q ? {select_1977[23], 1'b0, select_1977[22], 1'b0, select_1977[21], 1'b0, select_1977[20], 1'b0, select_1977[19], 1'b0, select_1977[18], 1'b0, select_1977[17], 1'b0, select_1977[16], 1'b0, select_1977[15], 1'b0, select_1977[14], 1'b0, select_1977[13], 1'b0, select_1977[12], 1'b0, select_1977[11], 1'b0, select_1977[10], 1'b0, select_1977[9], 1'b0, select_1977[8], 1'b0, select_1977[7], 1'b0, select_1977[6], 1'b0, select_1977[5], 1'b0, select_1977[4], 1'b0, select_1977[3], 1'b0, select_1977[2], 1'b0, select_1977[1], 1'b0, select_1977[0], 1'b0} : {1'b0, select_1977[23], 1'b0, select_1977[22], 1'b0, select_1977[21], 1'b0, select_1977[20], 1'b0, select_1977[19], 1'b0, select_1977[18], 1'b0, select_1977[17], 1'b0, select_1977[16], 1'b0, select_1977[15], 1'b0, select_1977[14], 1'b0, select_1977[13], 1'b0, select_1977[12], 1'b0, select_1977[11], 1'b0, select_1977[10], 1'b0, select_1977[9], 1'b0, select_1977[8], 1'b0, select_1977[7], 1'b0, select_1977[6], 1'b0, select_1977[5], 1'b0, select_1977[4], 1'b0, select_1977[3], 1'b0, select_1977[2], 1'b0, select_1977[1], 1'b0, select_1977[0]};
  // hls/stages/agreement.hpp:976
  logic and_1982;
  assign and_1982 = good_known_q & (~((good_q & select_1978) == 48'h0));
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_1961_s4_q ? and_1982 : not_1997_s4_q;
  // hls/stages/agreement.hpp:1054
  logic and_2012;
  assign and_2012 = is_seen & less_2011_s4_q;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2046;
  assign select_2046 = sample_pair_whole_s4_q ? (and_498_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2048;
  assign select_2048 = sample_pair_whole_s4_q ? (and_498_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2050;
  assign select_2050 = sample_pair_whole_s4_q ? (and_498_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2052;
  assign select_2052 = sample_pair_whole_s4_q ? (and_498_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2057;
  assign sum_2057 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2058;
  assign difference_2058 = {1'b0, sum_2057[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2059;
  assign xor_2059 = {difference_2058[8:0], sum_2057[0]} ^ {10{difference_2058[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2058[9]} + {1'b0, xor_2059};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_503_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2064;
  assign select_2064 = sample_pair_whole_s4_q ? (and_498_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2065;
  assign sum_2065 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2066;
  assign difference_2066 = {1'b0, sum_2065[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2067;
  assign xor_2067 = {difference_2066[8:0], sum_2065[0]} ^ {10{difference_2066[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2066[9]} + {1'b0, xor_2067};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_503_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2072;
  assign select_2072 = sample_pair_whole_s4_q ? (and_498_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2155;
  assign sum_2155 = sum_2151_s4_q + {2'h0, sum_2154_s4_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2157;
  assign select_2157 = and_500_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2158;
  assign select_2158 = and_500_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2159;
  assign select_2159 = and_500_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2160;
  assign select_2160 = and_500_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2163;
  assign sum_2163 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2155};
  logic [13:0] sum_2165;
  assign sum_2165 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2163});
  // hls/stages/census.hpp:305
  logic and_2167;
  assign and_2167 = and_590_s4_q & (9'h4 < sum_2165[13:5]);
  // hls/stages/census.hpp:306
  logic and_2168;
  assign and_2168 = and_590_s4_q & less_614;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2169;
  assign sum_2169 = census_left_misses_q + {{17{and_2168}}, and_2167, 1'b0, and_2167};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2171;
  assign select_2171 = and_500_s4_q ? (equal_2162_s4_q ? 20'h0 : sum_2169) : census_left_misses_q;
  // hls/stages/agreement.hpp:263
  logic [27:0] select_2176;
  assign select_2176 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:507
  logic select_2179;
  assign select_2179 = and_500_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2182;
  assign and_2182 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:444
  logic and_2188;
  assign and_2188 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2189;
  assign and_2189 = and_2182 & and_2188;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2176[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2191;
  assign select_2191 = and_2189 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2193;
  assign select_2193 = equal_2162_s4_q ? {11'h0, select_2191} : (sharpness_sums_detail_0_q + {11'h0, select_2191});
  // hls/stages/agreement.hpp:444
  logic and_2200;
  assign and_2200 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2201;
  assign and_2201 = and_2182 & and_2200;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2176[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2203;
  assign select_2203 = and_2201 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2205;
  assign select_2205 = equal_2162_s4_q ? {11'h0, select_2203} : (sharpness_sums_detail_1_q + {11'h0, select_2203});
  logic [8:0] select_2208;
  assign select_2208 = and_2189 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2209;
  assign sum_2209 = (equal_2162_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2208};
  logic [8:0] select_2212;
  assign select_2212 = and_2201 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2213;
  assign sum_2213 = (equal_2162_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2212};
  // hls/stages/agreement.hpp:203
  logic equal_2215;
  assign equal_2215 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2216;
  assign less_2216 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2217;
  assign less_2217 = x_s4_q[4:0] < 5'h3;
  logic not_2218;
  assign not_2218 = ~x_s4_q[1];
  logic [2:0] select_2219;
  assign select_2219 = x_s4_q[0] ? {1'b0, not_2218, 1'b0} : {x_s4_q[1], 1'b0, not_2218};
  logic [5:0] select_2220;
  assign select_2220 = slot_s4_q[2] ? {select_2219[2], 1'b0, select_2219[1], 1'b0, select_2219[0], 1'b0} : {1'b0, select_2219[2], 1'b0, select_2219[1], 1'b0, select_2219[0]};
  logic [11:0] select_2221;
  assign select_2221 = slot_s4_q[1] ? {select_2220[5], 1'b0, select_2220[4], 1'b0, select_2220[3], 1'b0, select_2220[2], 1'b0, select_2220[1], 1'b0, select_2220[0], 1'b0} : {1'b0, select_2220[5], 1'b0, select_2220[4], 1'b0, select_2220[3], 1'b0, select_2220[2], 1'b0, select_2220[1], 1'b0, select_2220[0]};
  logic [23:0] select_2222;
  assign select_2222 = slot_s4_q[0] ? {select_2221[11], 1'b0, select_2221[10], 1'b0, select_2221[9], 1'b0, select_2221[8], 1'b0, select_2221[7], 1'b0, select_2221[6], 1'b0, select_2221[5], 1'b0, select_2221[4], 1'b0, select_2221[3], 1'b0, select_2221[2], 1'b0, select_2221[1], 1'b0, select_2221[0], 1'b0} : {1'b0, select_2221[11], 1'b0, select_2221[10], 1'b0, select_2221[9], 1'b0, select_2221[8], 1'b0, select_2221[7], 1'b0, select_2221[6], 1'b0, select_2221[5], 1'b0, select_2221[4], 1'b0, select_2221[3], 1'b0, select_2221[2], 1'b0, select_2221[1], 1'b0, select_2221[0]};
  // hls/stages/census.hpp:372
  logic and_2226;
  assign and_2226 = less_2217 & (~((sharpness_sums_contrast_1_q & select_2222) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2228;
  assign select_2228 = (less_2216 & and_2226) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2228};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2231;
  assign select_2231 = equal_2215 ? (less_2216 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2236;
  assign and_2236 = less_2217 & (~((sharpness_sums_contrast_0_q & select_2222) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2238;
  assign select_2238 = (less_2216 & and_2236) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2238};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2241;
  assign select_2241 = equal_2215 ? (less_2216 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2243;
  assign select_2243 = equal_2215 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2245;
  assign select_2245 = equal_2215 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2247;
  assign select_2247 = equal_2215 ? {sharpness_comparing_contrast_0_q[0], and_2236} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2249;
  assign select_2249 = equal_2215 ? {sharpness_comparing_contrast_1_q[0], and_2226} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:207
  logic select_2254;
  assign select_2254 = drew_q ? (equal_2215 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:207
  logic select_2258;
  assign select_2258 = drew_q ? (equal_2215 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2259;
  assign equal_2259 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2260;
  assign xor_2260 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2263;
  assign select_2263 = (equal_2259 | xor_2260) ? (five_times[0] & xor_2260) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2265;
  assign select_2265 = drew_q ? (equal_2215 ? select_2263 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2266;
  assign xor_2266 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2269;
  assign select_2269 = (equal_2259 | xor_2266) ? (five_times_2[0] & xor_2266) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2271;
  assign select_2271 = drew_q ? (equal_2215 ? select_2269 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2272;
  assign xor_2272 = sharpness_comparing_contrast_0_q[1] ^ and_2226;
  logic select_2275;
  assign select_2275 = (equal_2259 | xor_2272) ? (and_2226 & xor_2272) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2277;
  assign select_2277 = drew_q ? (equal_2215 ? select_2275 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2278;
  assign xor_2278 = sharpness_comparing_contrast_1_q[1] ^ and_2236;
  logic select_2281;
  assign select_2281 = (equal_2259 | xor_2278) ? (and_2236 & xor_2278) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2283;
  assign select_2283 = drew_q ? (equal_2215 ? select_2281 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2408;
  assign select_2408 = and_2402_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2406_s4_q});
  // hls/stages/patches.hpp:322
  logic and_2411;
  assign and_2411 = not_1470_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2416;
  assign and_2416 = not_1470_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2421;
  assign and_2421 = not_1470_s4_q & (drew_q & (ends_cell_s4_q & and_1902_s4_q));
  // hls/stages/agreement.hpp:1047
  logic not_2425;
  assign not_2425 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1048
  logic not_2442;
  assign not_2442 = ~(equal_1961_s4_q ? and_1982 : not_2440_s4_q);
  // hls/stages/patches.hpp:322
  logic and_2445;
  assign and_2445 = ends_cell_s4_q & (not_2425 & (centres_values_1_textured_s4_q & not_2442));
  logic and_2447;
  assign and_2447 = not_1470_s4_q & (drew_q & and_2445);
  // hls/stages/agreement.hpp:1074
  logic less_2450;
  assign less_2450 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2451;
  assign select_2451 = less_2450 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2454;
  assign select_2454 = less_2450 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2455;
  assign sum_2455 = {1'b0, select_2454} + {3'h0, select_2454[9:2]};
  logic and_2457;
  assign and_2457 = (~(select_2451[9:4] == 6'h0)) & ({sum_2455, select_2454[1:0]} < {3'h0, select_2451});
  // hls/stages/agreement.hpp:1084
  logic [9:0] select_2460;
  assign select_2460 = x_s4_q[6] ? (equal_1514_s4_q ? 10'h0 : (and_2457 ? select_2451 : 10'h0)) : 10'h0;
  // hls/stages/patches.hpp:322
  logic [9:0] select_2461;
  assign select_2461 = equal_1469_s4_q ? select_2460 : 10'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2463;
  assign select_2463 = and_2402_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2461});
  logic [13:0] select_2470;
  assign select_2470 = and_2402_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2468_s4_q});
  // hls/stages/agreement.hpp:1052
  logic and_2472;
  assign and_2472 = not_2425 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/patches.hpp:322
  logic and_2475;
  assign and_2475 = not_1470_s4_q & (drew_q & (ends_cell_s4_q & and_2472));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2477;
  assign select_2477 = and_2402_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2475});
  // hls/stages/agreement.hpp:1052
  logic and_2479;
  assign and_2479 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2442);
  // hls/stages/patches.hpp:322
  logic and_2483;
  assign and_2483 = not_1470_s4_q & (drew_q & (ends_cell_s4_q & (not_2425 & and_2479)));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2485;
  assign select_2485 = and_2402_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2483});
  // hls/stages/patches.hpp:322
  logic [7:0] select_2534;
  assign select_2534 = drew_q ? (equal_1610_s4_q ? (and_2518_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2535;
  assign select_2535 = equal_1469_s4_q ? 8'h0 : select_2534;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2537;
  assign select_2537 = and_2517_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2535[7]}}, select_2535});
  // hls/stages/patches.hpp:322
  logic and_2540;
  assign and_2540 = not_1470_s4_q & (drew_q & (and_2518_s4_q & equal_1610_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2542;
  assign select_2542 = and_2517_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2540});
  // hls/stages/registration.hpp:107
  logic and_2544;
  assign and_2544 = and_2518_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/patches.hpp:322
  logic [1:0] select_2546;
  assign select_2546 = drew_q ? (equal_1610_s4_q ? {and_2544, and_2518_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2547;
  assign select_2547 = equal_1469_s4_q ? 2'h0 : select_2546;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2548;
  assign sum_2548 = registration_half_votes_down_q + {{5{select_2547[1]}}, select_2547};
  // hls/stages/patches.hpp:322
  logic [1:0] select_2554;
  assign select_2554 = drew_q ? (equal_1610_s4_q ? {and_2552_s4_q, and_2518_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2555;
  assign select_2555 = equal_1469_s4_q ? 2'h0 : select_2554;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2556;
  assign sum_2556 = registration_half_votes_up_q + {{5{select_2555[1]}}, select_2555};
  // hls/stages/registration.hpp:107
  logic and_2559;
  assign and_2559 = and_2518_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/patches.hpp:322
  logic [1:0] select_2561;
  assign select_2561 = drew_q ? (equal_1610_s4_q ? {and_2559, and_2518_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2562;
  assign select_2562 = equal_1469_s4_q ? 2'h0 : select_2561;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2563;
  assign sum_2563 = registration_half_half_votes_down_q + {{5{select_2562[1]}}, select_2562};
  // hls/stages/patches.hpp:322
  logic [1:0] select_2568;
  assign select_2568 = drew_q ? (equal_1610_s4_q ? {and_2566_s4_q, and_2518_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2569;
  assign select_2569 = equal_1469_s4_q ? 2'h0 : select_2568;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2570;
  assign sum_2570 = registration_half_half_votes_up_q + {{5{select_2569[1]}}, select_2569};
  // hls/stages/patches.hpp:322
  logic and_2604;
  assign and_2604 = equal_1469_s4_q & (x_s4_q[6] & (not_1881_s4_q & less_1545_s4_q));
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2611;
  assign select_2611 = or_1549_s4_q ? 12'h0 : (equal_2609_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2614;
  assign select_2614 = x_s4_q[6] ? (equal_1514_s4_q ? 12'h0 : (less_1545_s4_q ? select_2611 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:322
  logic [11:0] select_2615;
  assign select_2615 = equal_1469_s4_q ? select_2614 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2616;
  assign and_2616 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_2619;
  assign and_2619 = not_1881_s4_q & (less_1545_s4_q & ({and_2616, x_s4_q[0]} == 2'h0));
  // hls/stages/patches.hpp:322
  logic and_2621;
  assign and_2621 = equal_1469_s4_q & (x_s4_q[6] & and_2619);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2623;
  assign sum_2623 = {{2{select_2615[11]}}, select_2615} + (and_2621 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2626;
  assign select_2626 = or_1549_s4_q ? 12'h0 : (equal_2609_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2629;
  assign select_2629 = x_s4_q[6] ? (equal_1514_s4_q ? 12'h0 : (less_1545_s4_q ? select_2626 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:322
  logic [11:0] select_2630;
  assign select_2630 = equal_1469_s4_q ? select_2629 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2632;
  assign sum_2632 = {{2{select_2630[11]}}, select_2630} + (and_2621 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2634;
  assign not_2634 = ~all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_2637;
  assign and_2637 = not_1881_s4_q & (less_1545_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2634, 1'b0}));
  // hls/stages/patches.hpp:322
  logic and_2643;
  assign and_2643 = equal_1469_s4_q & (x_s4_q[6] & (not_1881_s4_q & (less_1545_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_2644;
  assign not_2644 = ~and_2643;
  logic less_2645;
  assign less_2645 = $signed({9'h1, {2{not_2644}}, and_2643}) < $signed(registration_up_q[13:2]);
  logic select_2646;
  assign select_2646 = (equal_1469_s4_q & (x_s4_q[6] & and_2637)) ? less_2645 : registration_enough_q;
  // hls/stages/agreement.hpp:1084
  logic and_2650;
  assign and_2650 = x_s4_q[6] & (not_1881_s4_q & (less_1545_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:322
  logic and_2651;
  assign and_2651 = equal_1469_s4_q & and_2650;
  // hls/stages/registration.hpp:242
  logic less_2652;
  assign less_2652 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2654;
  assign less_2654 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1084
  logic and_2659;
  assign and_2659 = x_s4_q[6] & (not_1881_s4_q & (less_1545_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/patches.hpp:322
  logic and_2660;
  assign and_2660 = equal_1469_s4_q & and_2659;
  // hls/stages/agreement.hpp:1084
  logic and_2667;
  assign and_2667 = x_s4_q[6] & (not_1881_s4_q & (less_1545_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2670;
  assign equal_2670 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1084
  logic and_2673;
  assign and_2673 = not_1881_s4_q & (less_1545_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2670));
  // hls/stages/registration.hpp:244
  logic and_2677;
  assign and_2677 = (equal_1469_s4_q & (x_s4_q[6] & and_2673)) & (less_2654 | less_2652);
  // hls/stages/agreement.hpp:1084
  logic and_2682;
  assign and_2682 = not_1881_s4_q & (less_1545_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2670)));
  // hls/stages/registration.hpp:244
  logic and_2685;
  assign and_2685 = registration_votes_up_q & registration_other_down_q;
  logic select_2687;
  assign select_2687 = registration_votes_down_q ? (registration_other_up_q | and_2685) : and_2685;
  // hls/stages/registration.hpp:138
  logic and_2689;
  assign and_2689 = (equal_1469_s4_q & (x_s4_q[6] & and_2682)) & (registration_other_enough_q & select_2687);
  // hls/stages/registration.hpp:245
  logic or_2692;
  assign or_2692 = registration_moved_q | (registration_enough_q & (and_2677 | and_2689));
  // hls/stages/agreement.hpp:263
  logic [7:0] select_2776;
  assign select_2776 = sample_pair_whole_s4_q ? (equal_1600_s4_q ? patches_place_0_slope_q : select_1701[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_2781;
  assign select_2781 = sample_pair_whole_s4_q ? (equal_1600_s4_q ? patches_place_1_slope_q : select_1730[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:109
  logic select_2783;
  assign select_2783 = equal_1600_s4_q ? patches_valid_0_q : (select_1599_s4_q ? patches_valid_0_q : select_1698[0]);
  // hls/stages/agreement.hpp:263
  logic select_2786;
  assign select_2786 = sample_pair_whole_s4_q ? (and_1721 ? (sample_present_s4_q & select_2783) : select_2783) : patches_valid_0_q;
  // hls/stages/patches.hpp:109
  logic select_2788;
  assign select_2788 = equal_1600_s4_q ? patches_valid_1_q : (select_1599_s4_q ? select_1698[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_2791;
  assign select_2791 = sample_pair_whole_s4_q ? (and_1741 ? (sample_present_s4_q & select_2788) : select_2788) : patches_valid_1_q;
  logic [5:0] select_2794;
  assign select_2794 = sample_pair_whole_s4_q ? (select_1719[5] ? {1'b1, select_1719[4:0]} : (select_1719 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2797;
  assign select_2797 = sample_pair_whole_s4_q ? (select_1739[5] ? {1'b1, select_1739[4:0]} : (select_1739 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_2800;
  assign select_2800 = sample_pair_whole_s4_q ? (select_1752[4] ? {1'b1, select_1752[3:0]} : (select_1752 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2803;
  assign select_2803 = sample_pair_whole_s4_q ? (select_1757[4] ? {1'b1, select_1757[3:0]} : (select_1757 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:503
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3222_s4_q, parity_3218_s4_q, xor_3206_s4_q, parity_3178_s4_q, parity_3116_s4_q, parity_2987_s4_q} + (equal_3223_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:166
  logic [9:0] select_3227;
  assign select_3227 = equal_1682_s4_q ? patches_sums_values_0_q : (equal_1684_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3228;
  assign select_3228 = equal_1684_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3230;
  assign select_3230 = equal_1684_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3232;
  assign select_3232 = equal_1684_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3234;
  assign select_3234 = equal_1684_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3236;
  assign select_3236 = equal_1684_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3238;
  assign select_3238 = equal_1684_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3240;
  assign select_3240 = equal_1684_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3242;
  assign select_3242 = equal_1684_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3244;
  assign select_3244 = equal_1684_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3246;
  assign select_3246 = equal_1684_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3248;
  assign select_3248 = equal_1684_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3250;
  assign select_3250 = equal_1684_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3252;
  assign select_3252 = equal_1684_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3254;
  assign select_3254 = equal_1684_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3256;
  assign select_3256 = equal_1684_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3258;
  assign select_3258 = equal_1684_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:577
  logic or_3363;
  assign or_3363 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3362_s4_q;
  logic or_3366;
  assign or_3366 = equal_3354_s4_q | (less_3356_s4_q | (less_3357_s4_q | or_3363));
  // hls/stages/patches.hpp:557
  logic not_3367;
  assign not_3367 = ~or_3366;
  // hls/stages/patches.hpp:538
  logic and_3368;
  assign and_3368 = equal_1848_s4_q & not_3367;
  // hls/stages/patches.hpp:166
  logic and_3371;
  assign and_3371 = equal_1682_s4_q & (less_1845_s4_q ? (not_1847_s4_q & and_3368) : and_3368);
  // hls/stages/patches.hpp:616
  logic not_3372;
  assign not_3372 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:538
  logic and_3374;
  assign and_3374 = equal_1848_s4_q & (patches_second_s4_q & not_3367);
  // hls/stages/patches.hpp:166
  logic and_3377;
  assign and_3377 = equal_1682_s4_q & (less_1845_s4_q ? (not_1847_s4_q & and_3374) : and_3374);
  // hls/stages/patches.hpp:616
  logic not_3378;
  assign not_3378 = ~and_3377;
  // hls/stages/patches.hpp:170
  logic and_3380;
  assign and_3380 = and_3371 & (not_3372 & not_3378);
  // hls/stages/patches.hpp:618
  logic [7:0] sum_3382;
  assign sum_3382 = {7'h0, and_3380} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:575
  logic [7:0] select_3408;
  assign select_3408 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:574
  logic [5:0] select_3409;
  assign select_3409 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3410;
  assign sum_3410 = {2'h0, select_3342_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3411;
  assign sum_3411 = {select_3409[5], select_3409} + {{3{sum_3410[3]}}, sum_3410};
  // hls/stages/patches.hpp:575
  logic [17:0] product_3412;
  assign product_3412 = $signed({{10{select_3408[7]}}, select_3408}) * $signed({{8{sum_3411[6]}}, sum_3411, select_3342_s4_q[2:0]});
  // hls/stages/patches.hpp:576
  logic [13:0] difference_3413;
  assign difference_3413 = {{6{select_3407_s4_q[7]}}, select_3407_s4_q} - {product_3412[17], product_3412[17:5]};
  // hls/stages/patches.hpp:582
  logic less_3414;
  assign less_3414 = $signed({{7{difference_3384[6]}}, difference_3384}) < $signed(difference_3413);
  // hls/stages/patches.hpp:538
  logic and_3417;
  assign and_3417 = equal_1848_s4_q & (not_3367 & (~less_3414));
  // hls/stages/patches.hpp:166
  logic and_3420;
  assign and_3420 = equal_1682_s4_q & (less_1845_s4_q ? (not_1847_s4_q & and_3417) : and_3417);
  // hls/stages/patches.hpp:619
  logic and_3421;
  assign and_3421 = and_3420 & and_3380;
  logic [7:0] sum_3422;
  assign sum_3422 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3421};
  // hls/stages/patches.hpp:538
  logic and_3426;
  assign and_3426 = not_3367 & (~($signed(difference_3413) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3427;
  assign and_3427 = equal_1848_s4_q & and_3426;
  // hls/stages/patches.hpp:166
  logic and_3430;
  assign and_3430 = equal_1682_s4_q & (less_1845_s4_q ? (not_1847_s4_q & and_3427) : and_3427);
  // hls/stages/patches.hpp:620
  logic and_3431;
  assign and_3431 = and_3430 & and_3380;
  logic [7:0] sum_3432;
  assign sum_3432 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3431};
  // hls/stages/patches.hpp:170
  logic and_3434;
  assign and_3434 = and_3371 & (and_3377 & not_3372);
  // hls/stages/patches.hpp:618
  logic [7:0] sum_3436;
  assign sum_3436 = {7'h0, and_3434} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:619
  logic and_3438;
  assign and_3438 = and_3420 & and_3434;
  logic [7:0] sum_3439;
  assign sum_3439 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3438};
  // hls/stages/patches.hpp:620
  logic and_3441;
  assign and_3441 = and_3430 & and_3434;
  logic [7:0] sum_3442;
  assign sum_3442 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3441};
  // hls/stages/patches.hpp:170
  logic and_3444;
  assign and_3444 = and_3371 & (patches_lower_s4_q & not_3378);
  // hls/stages/patches.hpp:618
  logic [7:0] sum_3446;
  assign sum_3446 = {7'h0, and_3444} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:619
  logic and_3448;
  assign and_3448 = and_3420 & and_3444;
  logic [7:0] sum_3449;
  assign sum_3449 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3448};
  // hls/stages/patches.hpp:620
  logic and_3451;
  assign and_3451 = and_3430 & and_3444;
  logic [7:0] sum_3452;
  assign sum_3452 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3451};
  // hls/stages/patches.hpp:170
  logic and_3454;
  assign and_3454 = and_3371 & (patches_lower_s4_q & and_3377);
  // hls/stages/patches.hpp:618
  logic [7:0] sum_3456;
  assign sum_3456 = {7'h0, and_3454} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:619
  logic and_3458;
  assign and_3458 = and_3420 & and_3454;
  logic [7:0] sum_3459;
  assign sum_3459 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3458};
  // hls/stages/patches.hpp:620
  logic and_3461;
  assign and_3461 = and_3430 & and_3454;
  logic [7:0] sum_3462;
  assign sum_3462 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3461};
  // hls/stages/agreement.hpp:1072
  logic less_3463;
  assign less_3463 = x_s4_q[5:3] < 3'h5;
  // hls/stages/agreement.hpp:1154
  logic equal_3464;
  assign equal_3464 = x_s4_q[2:0] == 3'h0;
  // hls/stages/registration.hpp:150
  logic not_3465;
  assign not_3465 = ~x_s4_q[4];
  // hls/stages/registration.hpp:157
  logic not_3466;
  assign not_3466 = ~x_s4_q[3];
  // hls/stages/patches.hpp:182
  logic and_3467;
  assign and_3467 = not_3465 & not_3466;
  logic [1:0] select_3468;
  assign select_3468 = x_s4_q[4] ? {1'b1, x_s4_q[3]} : {not_3466, 1'b1};
  logic [3:0] select_3469;
  assign select_3469 = x_s4_q[5] ? {{2{and_3467}}, 2'h0} : {not_3466, not_3465, select_3468};
  // hls/stages/agreement.hpp:1084
  logic and_3473;
  assign and_3473 = x_s4_q[6] & (not_1881_s4_q & (less_3463 & (equal_3464 & select_3469[0])));
  // hls/stages/patches.hpp:322
  logic and_3474;
  assign and_3474 = equal_1469_s4_q & and_3473;
  // hls/stages/patches.hpp:182
  logic equal_3476;
  assign equal_3476 = x_s4_q[2:0] == 3'h1;
  // hls/stages/agreement.hpp:1084
  logic and_3480;
  assign and_3480 = x_s4_q[6] & (not_1881_s4_q & (less_3463 & (select_3469[1] & equal_3476)));
  // hls/stages/patches.hpp:322
  logic and_3481;
  assign and_3481 = equal_1469_s4_q & and_3480;
  // hls/stages/patches.hpp:599
  logic [7:0] or_3483;
  assign or_3483 = (and_3474 ? patches_quarters_0_places_q : 8'h0) | (and_3481 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1084
  logic and_3487;
  assign and_3487 = not_1881_s4_q & (less_3463 & (select_3469[2] & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/patches.hpp:322
  logic and_3489;
  assign and_3489 = equal_1469_s4_q & (x_s4_q[6] & and_3487);
  // hls/stages/agreement.hpp:1084
  logic and_3495;
  assign and_3495 = not_1881_s4_q & (less_3463 & (select_3469[3] & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:322
  logic and_3497;
  assign and_3497 = equal_1469_s4_q & (x_s4_q[6] & and_3495);
  // hls/stages/patches.hpp:599
  logic [7:0] or_3499;
  assign or_3499 = (or_3483 | (and_3489 ? patches_quarters_2_places_q : 8'h0)) | (and_3497 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:600
  logic [7:0] or_3502;
  assign or_3502 = (and_3474 ? patches_quarters_0_up_q : 8'h0) | (and_3481 ? patches_quarters_1_up_q : 8'h0);
  logic [7:0] or_3506;
  assign or_3506 = (or_3502 | (and_3489 ? patches_quarters_2_up_q : 8'h0)) | (and_3497 ? patches_quarters_3_up_q : 8'h0);
  // hls/stages/patches.hpp:601
  logic [7:0] or_3509;
  assign or_3509 = (and_3474 ? patches_quarters_0_down_q : 8'h0) | (and_3481 ? patches_quarters_1_down_q : 8'h0);
  logic [7:0] or_3513;
  assign or_3513 = (or_3509 | (and_3489 ? patches_quarters_2_down_q : 8'h0)) | (and_3497 ? patches_quarters_3_down_q : 8'h0);
  // hls/stages/patches.hpp:186
  logic [4:0] sum_3514;
  assign sum_3514 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1084
  logic and_3518;
  assign and_3518 = x_s4_q[6] & (not_1881_s4_q & (less_3463 & (sum_3514[4:2] == 3'h0)));
  // hls/stages/patches.hpp:322
  logic and_3519;
  assign and_3519 = equal_1469_s4_q & and_3518;
  logic and_3523;
  assign and_3523 = equal_1469_s4_q & (x_s4_q[6] & (not_1881_s4_q & (less_3463 & equal_3476)));
  // hls/stages/patches.hpp:596
  logic [7:0] select_3526;
  assign select_3526 = and_3519 ? (patches_word_places_q + (and_3523 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3529;
  assign select_3529 = and_3519 ? (patches_word_up_q + (and_3523 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3532;
  assign select_3532 = and_3519 ? (patches_word_down_q + (and_3523 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:583
  logic [5:0] select_3536;
  assign select_3536 = ($signed(difference_3413[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3413[5:0];
  logic [5:0] select_3537;
  assign select_3537 = ($signed(14'h10) < $signed(difference_3413)) ? 6'h10 : select_3536;
  // hls/stages/patches.hpp:538
  logic [5:0] select_3539;
  assign select_3539 = equal_1848_s4_q ? (or_3366 ? 6'h0 : select_3537) : 6'h0;
  logic [5:0] select_3541;
  assign select_3541 = less_1845_s4_q ? (equal_1846_s4_q ? 6'h0 : select_3539) : select_3539;
  // hls/stages/patches.hpp:622
  logic [5:0] select_3543;
  assign select_3543 = and_3371 ? (equal_1682_s4_q ? select_3541 : 6'h0) : 6'h0;
  logic [11:0] sum_3544;
  assign sum_3544 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3543[5]}}, select_3543};
  // hls/stages/patches.hpp:322
  logic and_3548;
  assign and_3548 = equal_1469_s4_q & (x_s4_q[6] & (not_1881_s4_q & (equal_2670 & less_3463)));
  // hls/stages/agreement.hpp:1084
  logic and_3552;
  assign and_3552 = x_s4_q[6] & (not_1881_s4_q & (less_3463 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:322
  logic and_3553;
  assign and_3553 = equal_1469_s4_q & and_3552;
  // hls/stages/patches.hpp:611
  logic [7:0] select_3555;
  assign select_3555 = and_3548 ? (and_3553 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:613
  logic or_3559;
  assign or_3559 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:610
  logic select_3561;
  assign select_3561 = and_3548 ? (and_3553 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:170
  logic and_3567;
  assign and_3567 = patches_complete_q & (equal_1469_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_3563_s4_q)));
  logic and_3568;
  assign and_3568 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:610
  logic [4:0] select_3570;
  assign select_3570 = and_3553 ? {and_3568, patches_found_q[4:1]} : (and_3548 ? {and_3568, patches_found_q[4:1]} : patches_found_q);
  // hls/stages/patches.hpp:608
  logic select_3577;
  assign select_3577 = patches_round_ends_q ? (~(patches_found_q == 5'h0)) : patches_moved_q;
  // hls/stages/agreement.hpp:1126
  logic or_3635;
  assign or_3635 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1148
  logic equal_3637;
  assign equal_3637 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1158
  logic select_3643;
  assign select_3643 = (equal_3637 & equal_3464) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_3646;
  assign sum_3646 = {1'b0, select_2454} + {2'h0, select_2454[9:1]};
  logic select_3649;
  assign select_3649 = (select_2451[9:3] == 7'h0) ? ((~or_3635) & (~select_3643)) : (~({sum_3646, select_2454[0]} < {2'h0, select_2451}));
  // hls/stages/agreement.hpp:1084
  logic [47:0] select_3651;
  assign select_3651 = x_s4_q[6] ? (equal_1514_s4_q ? good_q : {select_3649, good_q[47:1]}) : good_q;
  // hls/stages/patches.hpp:322
  logic select_3655;
  assign select_3655 = equal_1469_s4_q ? ((x_s4_q[6] & good_known_q) | equal_3563_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1148
  logic equal_3656;
  assign equal_3656 = x_s4_q[6:3] == 4'ha;
  logic equal_3658;
  assign equal_3658 = x_s4_q[6:3] == 4'h9;
  logic equal_3659;
  assign equal_3659 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3661;
  assign select_3661 = equal_3658 ? counts_skin_unproven_q : (equal_3659 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3656 ? counts_nearer_q : select_3661;
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1161
  logic select_3664;
  assign select_3664 = (equal_3656 & equal_3464) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1086
  logic not_3665;
  assign not_3665 = ~hidden_for_q[7];
  logic [7:0] select_3667;
  assign select_3667 = select_3664 ? (hidden_for_q + {7'h0, not_3665}) : 8'h0;
  // hls/stages/patches.hpp:322
  logic [7:0] select_3669;
  assign select_3669 = equal_1469_s4_q ? (equal_3563_s4_q ? select_3667 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3670;
  assign select_3670 = equal_3464 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_3672;
  assign select_3672 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3674;
  assign select_3674 = equal_3659 ? cfg_unproven_skin_limit_i : (equal_3637 ? cfg_unproven_limit_i : select_3672);
  logic [7:0] limit;
  assign limit = equal_3656 ? cfg_regions_limit_i : (equal_3658 ? cfg_hidden_limit_i : select_3674);
  // hls/stages/agreement.hpp:1161
  logic not_3677;
  assign not_3677 = ~x_s4_q[2];
  logic [3:0] select_3678;
  assign select_3678 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_3677, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_3677};
  logic [7:0] select_3679;
  assign select_3679 = x_s4_q[0] ? {select_3678[3], 1'b0, select_3678[2], 1'b0, select_3678[1], 1'b0, select_3678[0], 1'b0} : {1'b0, select_3678[3], 1'b0, select_3678[2], 1'b0, select_3678[1], 1'b0, select_3678[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3683;
  assign select_3683 = equal_3658 ? counts_skin_supervised_q : (equal_3659 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3656 ? counts_textured_q : select_3683;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3685;
  assign select_3685 = ((limit & select_3679) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3670} + {1'b0, select_3685};
  // hls/stages/patches.hpp:322
  logic select_3690;
  assign select_3690 = equal_1469_s4_q ? (equal_3464 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1159
  logic and_3695;
  assign and_3695 = too_much_q & (~(equal_3659 & equal_3464));
  // hls/stages/agreement.hpp:1160
  logic select_3700;
  assign select_3700 = (over[14] & equal_3464) ? (and_3695 | ((equal_3659 | equal_3658) | (x_s4_q[6:3] == 4'hf))) : and_3695;
  // hls/stages/agreement.hpp:1202
  logic select_3808;
  assign select_3808 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:265
  logic select_3810;
  assign select_3810 = left_first_s4_q ? done_s4_q : (and_1862_s4_q ? select_3808 : proven_q);
  // hls/stages/agreement.hpp:1235
  logic [1:0] select_3861;
  assign select_3861 = and_3860_s4_q ? {and_2012, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1236
  logic and_3862;
  assign and_3862 = select_3808 & less_3838;
  // hls/stages/agreement.hpp:424
  logic select_3865;
  assign select_3865 = and_1939_s4_q ? (less_1940_s4_q ? (select_3861[0] & and_3862) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:265
  logic select_3867;
  assign select_3867 = left_first_s4_q ? select_3865 : (and_1862_s4_q ? select_3865 : seen_q);
  logic select_3868;
  assign select_3868 = and_1862_s4_q ? select_3867 : seen_q;
  // hls/stages/agreement.hpp:424
  logic select_3871;
  assign select_3871 = and_1939_s4_q ? (less_1940_s4_q ? (select_3861[1] & and_3862) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:265
  logic select_3873;
  assign select_3873 = left_first_s4_q ? select_3871 : (and_1862_s4_q ? select_3871 : nearer_q);
  logic select_3874;
  assign select_3874 = and_1862_s4_q ? select_3873 : nearer_q;
  // hls/stages/agreement.hpp:1169
  logic or_3883;
  assign or_3883 = ((~(cfg_patch_limit_i == 6'h3f)) & (~patches_settled_q)) | (~proven_q);
  // hls/stages/agreement.hpp:1171
  logic not_3891;
  assign not_3891 = ~(or_3635 | not_3875);
  // hls/stages/patches.hpp:322
  logic and_3895;
  assign and_3895 = equal_1469_s4_q & (equal_3563_s4_q & (not_3891 & (select_3643 | select_3700)));
  logic and_3898;
  assign and_3898 = equal_3563_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1088
  logic or_3902;
  assign or_3902 = select_2265 | (select_2277 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/patches.hpp:322
  logic and_3909;
  assign and_3909 = equal_1469_s4_q & (equal_3563_s4_q & (not_3891 & (select_2271 | select_2283)));
  // hls/stages/agreement.hpp:1088
  logic and_3914;
  assign and_3914 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3667 < cfg_hidden_frames_i));
  // hls/stages/patches.hpp:322
  logic and_3921;
  assign and_3921 = equal_1469_s4_q & (x_s4_q[6] & (not_1881_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3929;
  assign select_3929 = equal_1536_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_3927_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_3930;
  assign select_3930 = equal_1534_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3929;
  logic [31:0] select_3931;
  assign select_3931 = equal_1532_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3930;
  logic [31:0] select_3932;
  assign select_3932 = equal_1530_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3931;
  logic [31:0] select_3933;
  assign select_3933 = equal_1528_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3932;
  logic [31:0] select_3934;
  assign select_3934 = equal_1526_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_3933;
  logic [31:0] select_3935;
  assign select_3935 = equal_1524_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_3934;
  logic [31:0] select_3936;
  assign select_3936 = equal_1522_s4_q ? {7'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3935;
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_3937;
  assign select_3937 = less_2450 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1084
  logic [31:0] select_3938;
  assign select_3938 = equal_1514_s4_q ? select_3936 : {2'h0, select_3937, select_2454, select_2451};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_500_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_615, and_591_s4_q, and_590_s4_q, and_565_s4_q, less_557_s4_q, less_556_s4_q, less_555_s4_q, less_554_s4_q, less_553_s4_q, less_552_s4_q, less_551_s4_q, less_550_s4_q, less_549_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q, less_545_s4_q, less_544_s4_q, less_543_s4_q, less_542_s4_q, less_541_s4_q, less_540_s4_q, less_539_s4_q, less_538_s4_q, less_537_s4_q, less_536_s4_q, less_535_s4_q, less_534_s4_q};
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
  assign registration_sums_waddr = {sum_1520_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1579_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1578, sum_1574};
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
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_1608_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_1681_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1674_s4_q};
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
  assign patches_right_0_waddr = {select_1712_s4_q, select_1709};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_1721);
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
  assign patches_right_1_waddr = {select_1712_s4_q, select_1738};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_1741);
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
  assign patches_left_waddr = {select_1760, select_1759_s4_q, column_5};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_1766);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1869;
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
  assign regions_waddr = {region_row_s4_q, or_1879_s4_q, or_1876_s4_q, or_1873_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1907_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1906, sum_1900, sum_1895};
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
  assign map_waddr = sum_1948_s4_q;
  logic map_we;
  assign map_we = s4_en & and_2022_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2012, is_seen};
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
      patches_settled_q <= 1'b0;
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
      census_left_misses_q <= select_2171;
      sharpness_before_last_mask_q <= select_2179;
      sharpness_sums_detail_0_q <= and_500_s4_q ? select_2193 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_500_s4_q ? select_2205 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_500_s4_q ? sum_2209 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_500_s4_q ? sum_2213 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2231 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2241 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2243 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2245 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2247 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2249 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2254;
      sharpness_comparing_carry_1_q <= select_2258;
      sharpness_comparing_less_detail_0_q <= select_2265;
      sharpness_comparing_less_detail_1_q <= select_2271;
      sharpness_comparing_less_contrast_0_q <= select_2277;
      sharpness_comparing_less_contrast_1_q <= select_2283;
      counts_supervised_q <= select_2408;
      counts_textured_q <= and_2402_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2411});
      counts_explained_q <= and_2402_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2416});
      counts_nearer_q <= and_2402_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2421});
      counts_unproven_q <= and_2402_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2447});
      counts_regions_bad_q <= select_2463;
      counts_skin_supervised_q <= select_2470;
      counts_skin_textured_q <= select_2477;
      counts_skin_unproven_q <= select_2485;
      registration_half_across_q <= select_2537;
      registration_half_measured_q <= select_2542;
      registration_half_votes_down_q <= and_2517_s4_q ? 7'h0 : sum_2548;
      registration_half_votes_up_q <= and_2517_s4_q ? 7'h0 : sum_2556;
      registration_half_half_votes_down_q <= and_2517_s4_q ? 7'h0 : sum_2563;
      registration_half_half_votes_up_q <= and_2517_s4_q ? 7'h0 : sum_2570;
      registration_down_q <= and_2604 ? sum_2623 : registration_down_q;
      registration_up_q <= and_2604 ? sum_2632 : registration_up_q;
      registration_enough_q <= select_2646;
      registration_votes_down_q <= and_2651 ? less_2652 : registration_votes_down_q;
      registration_votes_up_q <= and_2651 ? less_2654 : registration_votes_up_q;
      registration_other_enough_q <= and_2660 ? select_2646 : registration_other_enough_q;
      registration_other_down_q <= and_2660 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2660 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1469_s4_q & and_2667)) & or_2692;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_1700 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_1702 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_1703 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2776;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_1729 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_1731 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_1732 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2781;
      patches_valid_0_q <= select_2786;
      patches_valid_1_q <= select_2791;
      patches_right_next_0_q <= select_2794;
      patches_right_next_1_q <= select_2797;
      patches_left_next_0_q <= select_2800;
      patches_left_next_1_q <= select_2803;
      patches_sums_values_0_q <= select_3227;
      patches_sums_values_1_q <= equal_1682_s4_q ? patches_sums_values_1_q : select_3228;
      patches_sums_values_2_q <= equal_1682_s4_q ? patches_sums_values_2_q : select_3230;
      patches_sums_values_3_q <= equal_1682_s4_q ? patches_sums_values_3_q : select_3232;
      patches_sums_values_4_q <= equal_1682_s4_q ? patches_sums_values_4_q : select_3234;
      patches_sums_values_5_q <= equal_1682_s4_q ? patches_sums_values_5_q : select_3236;
      patches_sums_values_6_q <= equal_1682_s4_q ? patches_sums_values_6_q : select_3238;
      patches_sums_values_7_q <= equal_1682_s4_q ? patches_sums_values_7_q : select_3240;
      patches_sums_values_8_q <= equal_1682_s4_q ? patches_sums_values_8_q : select_3242;
      patches_sums_values_9_q <= equal_1682_s4_q ? patches_sums_values_9_q : select_3244;
      patches_sums_values_10_q <= equal_1682_s4_q ? patches_sums_values_10_q : select_3246;
      patches_sums_values_11_q <= equal_1682_s4_q ? patches_sums_values_11_q : select_3248;
      patches_sums_values_12_q <= equal_1682_s4_q ? patches_sums_values_12_q : select_3250;
      patches_sums_values_13_q <= equal_1682_s4_q ? patches_sums_values_13_q : select_3252;
      patches_sums_values_14_q <= equal_1682_s4_q ? patches_sums_values_14_q : select_3254;
      patches_sums_values_15_q <= equal_1682_s4_q ? patches_sums_values_15_q : select_3256;
      patches_sums_values_16_q <= equal_1682_s4_q ? patches_sums_values_16_q : select_3258;
      patches_best_differing_q <= select_1869[9:0];
      patches_best_column_q <= select_1869[14:10];
      patches_quarters_0_places_q <= sum_3382;
      patches_quarters_0_up_q <= sum_3422;
      patches_quarters_0_down_q <= sum_3432;
      patches_quarters_1_places_q <= sum_3436;
      patches_quarters_1_up_q <= sum_3439;
      patches_quarters_1_down_q <= sum_3442;
      patches_quarters_2_places_q <= sum_3446;
      patches_quarters_2_up_q <= sum_3449;
      patches_quarters_2_down_q <= sum_3452;
      patches_quarters_3_places_q <= sum_3456;
      patches_quarters_3_up_q <= sum_3459;
      patches_quarters_3_down_q <= sum_3462;
      patches_word_places_q <= or_3499;
      patches_word_up_q <= or_3506;
      patches_word_down_q <= or_3513;
      patches_sum_places_q <= select_3526;
      patches_sum_up_q <= select_3529;
      patches_sum_down_q <= select_3532;
      patches_across_q <= sum_3544;
      patches_places_q <= select_3555;
      patches_enough_q <= {3'h0, and_3553, 1'b0} < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3559;
      patches_complete_q <= select_3561;
      patches_round_ends_q <= and_3567;
      patches_found_q <= and_3548 ? select_3570 : patches_found_q;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_moved_q <= select_3577;
      patches_settled_q <= patches_round_ends_q | patches_settled_q;
      segment_textured_q <= select_1892 + {5'h0, and_2411};
      segment_explained_q <= select_1897 + {5'h0, and_2416};
      segment_nearer_q <= select_1903 + {5'h0, and_2421};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1469_s4_q ? select_3651 : good_q;
      good_known_q <= select_3655;
      hidden_for_q <= select_3669;
      product_q <= equal_1469_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3690;
      disagree_q <= equal_1469_s4_q ? select_3643 : disagree_q;
      too_much_q <= equal_1469_s4_q ? select_3700 : too_much_q;
      hides_q <= equal_1469_s4_q ? select_3664 : hides_q;
      proven_q <= and_1862_s4_q ? select_3810 : proven_q;
      seen_q <= select_3868;
      nearer_q <= select_3874;
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
      averager_quarter_1_0_q <= select_2046;
      averager_quarter_1_1_q <= select_2048;
      averager_quarter_2_0_q <= select_2050;
      averager_quarter_2_1_q <= select_2052;
      averager_detail_0_q <= select_2064;
      averager_detail_1_q <= select_2072;
      census_changes_values_0_left_q <= and_500_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_500_s4_q ? sum_2155 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2157;
      census_changes_values_1_right_q <= select_2158;
      census_changes_values_2_left_q <= select_2159;
      census_changes_values_2_right_q <= select_2160;
      sharpness_last_mask_q <= and_500_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_500_s4_q ? select_2176[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_500_s4_q ? select_2176[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_3812_s5_q;
  logic or_3876_s5_q;
  logic and_3877_s5_q;
  logic and_3886_s5_q;
  logic and_3889_s5_q;
  logic and_3895_s5_q;
  logic and_3899_s5_q;
  logic and_3905_s5_q;
  logic and_3909_s5_q;
  logic and_3917_s5_q;
  logic and_3921_s5_q;
  logic [5:0] select_3923_s5_q;
  logic [31:0] select_3940_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_3812_s5_q <= said_q;
      or_3876_s5_q <= not_3875 | select_3868;
      and_3877_s5_q <= cfg_prove_i & select_3874;
      and_3886_s5_q <= equal_1469_s4_q & (equal_3563_s4_q & (cfg_prove_i & or_3883));
      and_3889_s5_q <= equal_1469_s4_q & (equal_3563_s4_q & (cfg_prove_i & or_3635));
      and_3895_s5_q <= and_3895;
      and_3899_s5_q <= equal_1469_s4_q & and_3898;
      and_3905_s5_q <= equal_1469_s4_q & (equal_3563_s4_q & (not_3891 & or_3902));
      and_3909_s5_q <= and_3909;
      and_3917_s5_q <= equal_1469_s4_q & (equal_3563_s4_q & (cfg_prove_i & and_3914));
      and_3921_s5_q <= and_3921;
      select_3923_s5_q <= equal_1469_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3940_s5_q <= equal_1469_s4_q ? (x_s4_q[6] ? select_3938 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_3876_s5_q;
  assign marks_nearer_o = and_3877_s5_q;
  assign verdict_valid_o = and_3812_s5_q;
  assign verdict_unproven_yet_o = and_3886_s5_q;
  assign verdict_untextured_o = and_3889_s5_q;
  assign verdict_disagree_o = and_3895_s5_q;
  assign verdict_moved_o = and_3899_s5_q;
  assign verdict_unsharp_left_o = and_3905_s5_q;
  assign verdict_unsharp_right_o = and_3909_s5_q;
  assign verdict_hidden_o = and_3917_s5_q;
  assign frame_valid_o = and_3921_s5_q;
  assign frame_index_o = select_3923_s5_q;
  assign frame_word_o = select_3940_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_3514[1:0], product_3412[4:0], sum_2507[0], detail_4[1:0], detail_3[1:0], sum_2165[4:0], sum_1622[0], sum_1618[0], sum_613[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
