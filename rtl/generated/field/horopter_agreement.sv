// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2896 bits, pipeline 894 bits, memories 58067 bits.
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
  logic [5:0] sum_2382;
  assign sum_2382 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3386;
  assign difference_3386 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_3614;
  assign difference_3614 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_3847;
  assign less_3847 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_3848;
  assign sum_3848 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_3849;
  assign select_3849 = less_3847 ? {sum_3848, cfg_height_i[5:3]} : 8'h0;
  logic not_3884;
  assign not_3884 = ~cfg_prove_i;

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
  logic [2:0] select_465;
  assign select_465 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_467;
  assign select_467 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [7:0] select_470;
  assign select_470 = ({select_467, select_465} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:116
  logic [7:0] select_471;
  assign select_471 = select_465[0] ? averager_place_q : select_470;
  // hls/stages/census.hpp:41
  logic or_472;
  assign or_472 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_475;
  assign and_475 = (select_465[0] & or_472) & (select_471 < 8'hbd);
  // hls/stages/census.hpp:41
  logic [2:0] select_480;
  assign select_480 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_467 : 6'h0;
  // hls/stages/census.hpp:50
  logic equal_497;
  assign equal_497 = select_465 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_498;
  assign equal_498 = select_480 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_499;
  assign and_499 = equal_498 & and_475;
  // hls/stages/agreement.hpp:263
  logic and_501;
  assign and_501 = sample_pair_whole_q & (equal_497 & and_499);
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:610
  logic equal_521;
  assign equal_521 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:581
  logic or_522;
  assign or_522 = so | equal_521;
  // hls/stages/agreement.hpp:704
  logic not_523;
  assign not_523 = ~or_522;
  // hls/stages/agreement.hpp:601
  logic equal_524;
  assign equal_524 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_526;
  assign equal_526 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:579
  logic [7:0] sum_527;
  assign sum_527 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_528;
  assign select_528 = run_shift_q[5] ? x_q : sum_527;
  logic less_529;
  assign less_529 = {2'h0, last_q} < select_528;
  // hls/stages/agreement.hpp:216
  logic not_530;
  assign not_530 = ~less_529;
  // hls/stages/agreement.hpp:141
  logic and_531;
  assign and_531 = equal_526 & not_530;
  logic and_533;
  assign and_533 = not_523 & ((~equal_524) & and_531);
  // hls/stages/census.hpp:41
  logic [5:0] select_560;
  assign select_560 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_560 : 6'h0;
  // hls/stages/agreement.hpp:141
  logic select_617;
  assign select_617 = equal_524 ? not_530 : and_531;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:770
  logic [6:0] sum_637;
  assign sum_637 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:141
  logic and_642;
  assign and_642 = equal_524 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_637} < select_528))));
  logic select_643;
  assign select_643 = or_522 ? not_530 : and_642;
  // hls/stages/agreement.hpp:778
  logic equal_646;
  assign equal_646 = {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:782
  logic or_648;
  assign or_648 = equal_646 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:794
  logic [5:0] right;
  assign right = sum_527[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:182
  logic and_1864;
  assign and_1864 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:263
  logic [2:0] select_2029;
  assign select_2029 = sample_pair_whole_q ? (sample_last_q ? (select_480 + 3'h1) : select_480) : raster_at_y_q;
  logic [5:0] select_2031;
  assign select_2031 = sample_pair_whole_q ? (select_467 + {5'h0, equal_497}) : raster_at_column_q;
  logic [5:0] select_2034;
  assign select_2034 = sample_pair_whole_q ? (sample_last_q ? (select_560 + {5'h0, equal_498}) : select_560) : raster_at_row_q;
  logic select_2038;
  assign select_2038 = sample_pair_whole_q ? (sample_last_q ? (or_472 & (~raster_final_row_q)) : or_472) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2040;
  assign select_2040 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:263
  logic select_2044;
  assign select_2044 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2288;
  assign equal_2288 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:451
  logic and_2289;
  assign and_2289 = and_501 & equal_2288;
  // hls/stages/agreement.hpp:510
  logic select_2292;
  assign select_2292 = (and_2289 | (~ends_cell_q)) ? and_2289 : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2292 ? (and_2289 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2296;
  assign select_2296 = select_2292 ? (and_2289 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2299;
  assign select_2299 = select_2292 ? (following_last_shift_q & (~and_2289)) : run_last_shift_q;
  // hls/stages/agreement.hpp:594
  logic and_2302;
  assign and_2302 = run_last_shift_q & equal_524;
  // hls/stages/agreement.hpp:603
  logic select_2304;
  assign select_2304 = equal_524 ? (~run_last_shift_q) : equal_526;
  // hls/stages/agreement.hpp:607
  logic equal_2305;
  assign equal_2305 = run_phase_q == 3'h1;
  logic not_2308;
  assign not_2308 = ~select_2304;
  // hls/stages/agreement.hpp:610
  logic equal_2310;
  assign equal_2310 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2311;
  assign and_2311 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2312;
  assign select_2312 = equal_2310 ? 2'h1 : {2{and_2311}};
  logic [2:0] select_2314;
  assign select_2314 = (and_2302 | (select_2304 | equal_2305)) ? (equal_2305 ? 3'h2 : {not_2308, {2{select_2304}}}) : (equal_521 ? 3'h6 : {select_2312[0], select_2312});
  // hls/stages/agreement.hpp:594
  logic and_2317;
  assign and_2317 = select_2304 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2320;
  assign select_2320 = (plan_shift_q[5] & select_2304) ? value : 7'h0;
  logic [1:0] or_2321;
  assign or_2321 = {2{so}} | select_2320[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] select_2322;
  assign select_2322 = select_2304 ? plan_columns_q : 8'h0;
  logic [6:0] or_2325;
  assign or_2325 = select_2322[6:0] | ((equal_2305 | equal_2310) ? whole_q : 7'h0);
  logic [1:0] or_2326;
  assign or_2326 = {2{and_2302}} | or_2325[3:2];
  // hls/stages/agreement.hpp:621
  logic [6:0] or_2328;
  assign or_2328 = {or_2325[6:4], or_2326, or_2325[1:0]} | (equal_521 ? drawn_q : 7'h0);
  logic [4:0] or_2329;
  assign or_2329 = {5{so}} | {or_2328[6], or_2328[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2333;
  assign not_2333 = ~run_shift_q[5];
  logic [6:0] difference_2335;
  assign difference_2335 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2336;
  assign select_2336 = equal_524 ? ({{7{not_2333}}, 1'b1} + run_span_q) : {difference_2335[6], difference_2335};
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2340;
  assign select_2340 = and_2289 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2342;
  assign select_2342 = select_2292 ? {select_2340[6], select_2340} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2345;
  assign select_2345 = select_2292 ? (and_2289 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:507
  logic [5:0] select_2353;
  assign select_2353 = and_501 ? (equal_2288 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2356;
  assign select_2356 = and_501 ? (equal_2288 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2359;
  assign select_2359 = and_501 ? (equal_2288 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2373;
  assign select_2373 = (ends_cell_q | select_2292) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_524 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2377;
  assign and_2377 = (~select_2292) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic [6:0] sum_2378;
  assign sum_2378 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:447
  logic select_2380;
  assign select_2380 = equal_2288 ? ({sum_2378[6], cfg_height_i[8:3]} == {1'b0, sum_2378[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:352
  logic or_2762;
  assign or_2762 = select_467[0] | select_560[5];
  logic [7:0] sum_2763;
  assign sum_2763 = {1'b0, select_467[2:1], or_2762, select_560[4:1]} + 8'h1;
  logic less_2764;
  assign less_2764 = {sum_2763, select_560[0], select_480, 1'b0} < {4'h0, cfg_height_i};

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
  assign fresh_re = s0_en & and_533;
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
  assign left_re = s0_en & (or_522 ? not_530 : select_617);
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
  assign right_codes_raddr = equal_524 ? sum_527[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_523 & select_617);
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
  assign best_left_raddr = or_522 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_643;
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
      left_first_q <= and_1864 ? left_first_q : marks_first_i;
      right_q <= (~and_1864) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1864;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_465 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2029;
      raster_at_column_q <= select_2031;
      raster_at_row_q <= select_2034;
      raster_at_live_q <= select_2038;
      raster_rows_left_q <= sample_pair_whole_q ? select_2040 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2044;
      averager_place_q <= sample_pair_whole_q ? select_471 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2296;
      run_last_shift_q <= select_2299;
      run_span_q <= select_2292 ? (and_2289 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2314;
      following_shift_q <= select_2304 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2317;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2320[6], or_2321, select_2320[3:0]};
      following_columns_q <= {select_2322[7], or_2329[4], or_2328[5:4], or_2329[3:0]};
      plan_shift_q <= equal_524 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2336;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2342;
      columns_left_q <= select_2345;
      last_q <= and_501 ? (equal_2288 ? column : last_q) : last_q;
      least_q <= select_2353;
      whole_q <= select_2356;
      drawn_q <= select_2359;
      age_q <= select_2292 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2292 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2373;
      ends_q <= and_2377;
      final_row_q <= and_501 ? select_2380 : final_row_q;
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
  logic [2:0] select_465_s1_q;
  logic [5:0] select_467_s1_q;
  logic [7:0] select_471_s1_q;
  logic and_475_s1_q;
  logic equal_481_s1_q;
  logic [5:0] column_s1_q;
  logic and_499_s1_q;
  logic and_501_s1_q;
  logic so_s1_q;
  logic equal_521_s1_q;
  logic or_522_s1_q;
  logic equal_524_s1_q;
  logic less_529_s1_q;
  logic not_530_s1_q;
  logic and_533_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_643_s1_q;
  logic select_650_s1_q;
  logic and_1452_s1_q;
  logic [5:0] right_s1_q;
  logic select_1461_s1_q;
  logic equal_1470_s1_q;
  logic equal_1589_s1_q;
  logic equal_2288_s1_q;
  logic and_2289_s1_q;
  logic not_2765_s1_q;
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
      select_465_s1_q <= select_465;
      select_467_s1_q <= select_467;
      select_471_s1_q <= select_471;
      and_475_s1_q <= and_475;
      equal_481_s1_q <= select_480 == 3'h0;
      column_s1_q <= column;
      and_499_s1_q <= and_499;
      and_501_s1_q <= and_501;
      so_s1_q <= so;
      equal_521_s1_q <= equal_521;
      or_522_s1_q <= or_522;
      equal_524_s1_q <= equal_524;
      less_529_s1_q <= less_529;
      not_530_s1_q <= not_530;
      and_533_s1_q <= and_533;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_643_s1_q <= select_643;
      select_650_s1_q <= or_648 ? equal_646 : (~age_q[3]);
      and_1452_s1_q <= not_523 & and_642;
      right_s1_q <= right;
      select_1461_s1_q <= or_648 ? equal_646 : ({x[7:6], last_q} == {2'h0, x[5:0]});
      equal_1470_s1_q <= run_phase_q == 3'h7;
      equal_1589_s1_q <= {or_472, select_480} == 4'hc;
      equal_2288_s1_q <= equal_2288;
      and_2289_s1_q <= and_2289;
      not_2765_s1_q <= ~less_2764;
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
  logic not_621;
  assign not_621 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:656
  logic and_622;
  assign and_622 = left_rdata_q[12] & not_621;
  logic and_623;
  assign and_623 = left_rdata_q[28] & not_621;
  logic and_624;
  assign and_624 = left_rdata_q[44] & not_621;
  logic and_625;
  assign and_625 = left_rdata_q[60] & not_621;
  // hls/stages/agreement.hpp:657
  logic and_629;
  assign and_629 = right_codes_rdata_q[12] & not_621;
  logic and_630;
  assign and_630 = right_codes_rdata_q[25] & not_621;
  logic and_631;
  assign and_631 = right_codes_rdata_q[38] & not_621;
  logic and_632;
  assign and_632 = right_codes_rdata_q[51] & not_621;
  logic and_633;
  assign and_633 = right_codes_rdata_q[64] & not_621;
  logic and_634;
  assign and_634 = right_codes_rdata_q[77] & not_621;
  // hls/stages/agreement.hpp:212
  logic and_656;
  assign and_656 = left_rdata_q[44] & not_530_s1_q;
  logic and_657;
  assign and_657 = right_codes_rdata_q[38] & not_530_s1_q;
  logic [11:0] select_658;
  assign select_658 = less_529_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_659;
  assign select_659 = less_529_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_663;
  assign select_663 = and_656 ? (and_657 ? (~(select_658 ^ select_659)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_669;
  assign parity_669 = ^select_663[5:3];
  logic parity_672;
  assign parity_672 = ^select_663[8:6];
  logic parity_675;
  assign parity_675 = ^select_663[11:3];
  // hls/stages/agreement.hpp:212
  logic and_679;
  assign and_679 = left_rdata_q[60] & not_530_s1_q;
  logic and_680;
  assign and_680 = right_codes_rdata_q[51] & not_530_s1_q;
  logic [11:0] select_681;
  assign select_681 = less_529_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_682;
  assign select_682 = less_529_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_686;
  assign select_686 = and_679 ? (and_680 ? (~(select_681 ^ select_682)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_689;
  assign parity_689 = ^select_686[8:6];
  logic parity_692;
  assign parity_692 = ^select_686[11:9];
  // hls/stages/agreement.hpp:212
  logic and_696;
  assign and_696 = left_rdata_q[76] & not_530_s1_q;
  logic and_697;
  assign and_697 = right_codes_rdata_q[64] & not_530_s1_q;
  logic [11:0] select_698;
  assign select_698 = less_529_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_699;
  assign select_699 = less_529_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_703;
  assign select_703 = and_696 ? (and_697 ? (~(select_698 ^ select_699)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_709;
  assign parity_709 = ^select_703[2:0];
  logic parity_712;
  assign parity_712 = ^select_703[5:3];
  logic parity_715;
  assign parity_715 = ^select_703[8:0];
  logic parity_721;
  assign parity_721 = ^select_703[11:9];
  logic parity_724;
  assign parity_724 = ^select_686[2:0];
  logic parity_727;
  assign parity_727 = ^{select_703[11:9], select_686[5:0]};
  logic parity_730;
  assign parity_730 = ^{select_703, select_686, select_663[2:0]};
  logic xor_731;
  assign xor_731 = parity_675 ^ parity_730;
  // hls/stages/count_bits.hpp:23
  logic or_735;
  assign or_735 = (select_663[1:0] == 2'h3) | (select_663[2] & (select_663[0] | select_663[1]));
  // hls/stages/count_bits.hpp:25
  logic or_739;
  assign or_739 = (select_686[7:6] == 2'h3) | (select_686[8] & (select_686[6] | select_686[7]));
  logic or_743;
  assign or_743 = (select_686[10:9] == 2'h3) | (select_686[11] & (select_686[9] | select_686[10]));
  // hls/stages/count_bits.hpp:23
  logic or_751;
  assign or_751 = (select_703[7:6] == 2'h3) | (select_703[8] & (~(select_703[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_755;
  assign or_755 = (select_703[1:0] == 2'h3) | (select_703[2] & (select_703[0] | select_703[1]));
  logic or_759;
  assign or_759 = (select_703[4:3] == 2'h3) | (select_703[5] & (select_703[3] | select_703[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_762;
  assign parity_762 = ^{or_759, or_755, or_751};
  // hls/stages/count_bits.hpp:23
  logic or_766;
  assign or_766 = (select_686[4:3] == 2'h3) | (select_686[5] & (select_686[3] | select_686[4]));
  // hls/stages/count_bits.hpp:25
  logic or_770;
  assign or_770 = (select_703[10:9] == 2'h3) | (select_703[11] & (select_703[9] | select_703[10]));
  logic or_774;
  assign or_774 = (select_686[1:0] == 2'h3) | (select_686[2] & (select_686[0] | select_686[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_777;
  assign parity_777 = ^{or_774, or_770, or_766};
  logic parity_780;
  assign parity_780 = ^{or_774, or_770, or_766, or_759, or_755, or_751, or_743, or_739, or_735};
  // hls/stages/count_bits.hpp:25
  logic and_781;
  assign and_781 = parity_675 & parity_730;
  logic or_785;
  assign or_785 = (parity_669 & parity_672) | ((^select_663[11:9]) & (parity_669 | parity_672));
  logic and_788;
  assign and_788 = (^{select_686[11:6], select_663[2:0]}) & (parity_715 | parity_727);
  logic or_789;
  assign or_789 = (parity_715 & parity_727) | and_788;
  // hls/stages/count_bits.hpp:23
  logic or_796;
  assign or_796 = (select_663[10:9] == 2'h3) | (select_663[11] & (select_663[9] | select_663[10]));
  // hls/stages/count_bits.hpp:25
  logic or_800;
  assign or_800 = (select_663[4:3] == 2'h3) | (select_663[5] & (select_663[3] | select_663[4]));
  logic or_804;
  assign or_804 = (select_663[7:6] == 2'h3) | (select_663[8] & (select_663[6] | select_663[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_807;
  assign parity_807 = ^{or_804, or_800, or_796};
  // hls/stages/count_bits.hpp:25
  logic or_811;
  assign or_811 = (parity_689 & parity_692) | ((^select_663[2:0]) & (parity_689 | parity_692));
  logic or_815;
  assign or_815 = (parity_709 & parity_712) | ((^select_703[8:6]) & (parity_709 | parity_712));
  logic or_819;
  assign or_819 = (parity_721 & parity_724) | ((^select_686[5:3]) & (parity_721 | parity_724));
  // hls/stages/count_bits.hpp:24
  logic parity_822;
  assign parity_822 = ^{or_819, or_815, or_811};
  logic parity_825;
  assign parity_825 = ^{or_819, or_815, or_811, or_804, or_800, or_796, or_789, or_785, and_781};
  logic xor_826;
  assign xor_826 = parity_780 ^ parity_825;
  // hls/stages/count_bits.hpp:25
  logic and_827;
  assign and_827 = parity_780 & parity_825;
  logic or_831;
  assign or_831 = (parity_762 & parity_777) | ((^{or_743, or_739, or_735}) & (parity_762 | parity_777));
  logic or_835;
  assign or_835 = (parity_807 & parity_822) | ((^{or_789, or_785, and_781}) & (parity_807 | parity_822));
  logic or_842;
  assign or_842 = (or_739 & or_743) | (or_735 & (or_739 | or_743));
  logic or_846;
  assign or_846 = (or_755 & or_759) | (or_751 & (or_755 | or_759));
  logic or_850;
  assign or_850 = (or_770 & or_774) | (or_766 & (or_770 | or_774));
  // hls/stages/count_bits.hpp:24
  logic parity_853;
  assign parity_853 = ^{or_850, or_846, or_842};
  // hls/stages/count_bits.hpp:25
  logic or_857;
  assign or_857 = (or_785 & or_789) | (and_781 & (or_785 | or_789));
  logic or_861;
  assign or_861 = (or_800 & or_804) | (or_796 & (or_800 | or_804));
  logic or_865;
  assign or_865 = (or_815 & or_819) | (or_811 & (or_815 | or_819));
  // hls/stages/count_bits.hpp:24
  logic parity_868;
  assign parity_868 = ^{or_865, or_861, or_857};
  logic parity_871;
  assign parity_871 = ^{or_865, or_861, or_857, or_850, or_846, or_842, or_835, or_831, and_827};
  // hls/stages/count_bits.hpp:25
  logic or_875;
  assign or_875 = (parity_853 & parity_868) | ((^{or_835, or_831, and_827}) & (parity_853 | parity_868));
  logic or_879;
  assign or_879 = (or_831 & or_835) | (and_827 & (or_831 | or_835));
  logic or_883;
  assign or_883 = (or_846 & or_850) | (or_842 & (or_846 | or_850));
  logic or_887;
  assign or_887 = (or_861 & or_865) | (or_857 & (or_861 | or_865));
  // hls/stages/count_bits.hpp:24
  logic parity_892;
  assign parity_892 = ^{or_887, or_883, or_879, or_875};
  // hls/stages/count_bits.hpp:25
  logic or_896;
  assign or_896 = (or_883 & or_887) | (or_879 & (or_883 | or_887));
  logic and_897;
  assign and_897 = or_875 & (^{or_887, or_883, or_879});
  // hls/stages/count_bits.hpp:24
  logic xor_898;
  assign xor_898 = or_896 ^ and_897;
  // hls/stages/count_bits.hpp:27
  logic and_899;
  assign and_899 = or_896 & and_897;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_900;
  assign select_900 = equal_524_s1_q ? {and_899, xor_898, parity_892, parity_871, xor_826, xor_731} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_522_s1_q ? 6'h0 : select_900;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_911;
  assign select_911 = (slot_s1_q[0] ? and_697 : and_680) ? (~(select_659 ^ (slot_s1_q[0] ? select_698 : select_681))) : 12'h0;
  logic [11:0] select_912;
  assign select_912 = and_656 ? select_911 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_918;
  assign parity_918 = ^select_912[5:3];
  logic parity_921;
  assign parity_921 = ^select_912[8:6];
  logic parity_924;
  assign parity_924 = ^select_912[11:3];
  // hls/stages/agreement.hpp:212
  logic and_928;
  assign and_928 = right_codes_rdata_q[77] & not_530_s1_q;
  logic [11:0] select_930;
  assign select_930 = less_529_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_934;
  assign select_934 = (slot_s1_q[0] ? and_928 : and_697) ? (~(select_682 ^ (slot_s1_q[0] ? select_930 : select_698))) : 12'h0;
  logic [11:0] select_935;
  assign select_935 = and_679 ? select_934 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_938;
  assign parity_938 = ^select_935[8:6];
  logic parity_941;
  assign parity_941 = ^select_935[11:9];
  // hls/stages/agreement.hpp:718
  logic select_946;
  assign select_946 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_530_s1_q) : and_928;
  logic [11:0] select_948;
  assign select_948 = slot_s1_q[0] ? (less_529_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_930;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_952;
  assign select_952 = and_696 ? (select_946 ? (~(select_699 ^ select_948)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_958;
  assign parity_958 = ^select_952[2:0];
  logic parity_961;
  assign parity_961 = ^select_952[5:3];
  logic parity_964;
  assign parity_964 = ^select_952[8:0];
  logic parity_970;
  assign parity_970 = ^select_952[11:9];
  logic parity_973;
  assign parity_973 = ^select_935[2:0];
  logic parity_976;
  assign parity_976 = ^{select_952[11:9], select_935[5:0]};
  logic parity_979;
  assign parity_979 = ^{select_952, select_935, select_912[2:0]};
  logic xor_980;
  assign xor_980 = parity_924 ^ parity_979;
  // hls/stages/count_bits.hpp:23
  logic or_984;
  assign or_984 = (select_912[1:0] == 2'h3) | (select_912[2] & (select_912[0] | select_912[1]));
  // hls/stages/count_bits.hpp:25
  logic or_988;
  assign or_988 = (select_935[7:6] == 2'h3) | (select_935[8] & (select_935[6] | select_935[7]));
  logic or_992;
  assign or_992 = (select_935[10:9] == 2'h3) | (select_935[11] & (select_935[9] | select_935[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1000;
  assign or_1000 = (select_952[7:6] == 2'h3) | (select_952[8] & (~(select_952[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1004;
  assign or_1004 = (select_952[1:0] == 2'h3) | (select_952[2] & (select_952[0] | select_952[1]));
  logic or_1008;
  assign or_1008 = (select_952[4:3] == 2'h3) | (select_952[5] & (select_952[3] | select_952[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1011;
  assign parity_1011 = ^{or_1008, or_1004, or_1000};
  // hls/stages/count_bits.hpp:23
  logic or_1015;
  assign or_1015 = (select_935[4:3] == 2'h3) | (select_935[5] & (select_935[3] | select_935[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1019;
  assign or_1019 = (select_952[10:9] == 2'h3) | (select_952[11] & (select_952[9] | select_952[10]));
  logic or_1023;
  assign or_1023 = (select_935[1:0] == 2'h3) | (select_935[2] & (select_935[0] | select_935[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1026;
  assign parity_1026 = ^{or_1023, or_1019, or_1015};
  logic parity_1029;
  assign parity_1029 = ^{or_1023, or_1019, or_1015, or_1008, or_1004, or_1000, or_992, or_988, or_984};
  // hls/stages/count_bits.hpp:25
  logic and_1030;
  assign and_1030 = parity_924 & parity_979;
  logic or_1034;
  assign or_1034 = (parity_918 & parity_921) | ((^select_912[11:9]) & (parity_918 | parity_921));
  logic and_1037;
  assign and_1037 = (^{select_935[11:6], select_912[2:0]}) & (parity_964 | parity_976);
  logic or_1038;
  assign or_1038 = (parity_964 & parity_976) | and_1037;
  // hls/stages/count_bits.hpp:23
  logic or_1045;
  assign or_1045 = (select_912[10:9] == 2'h3) | (select_912[11] & (select_912[9] | select_912[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1049;
  assign or_1049 = (select_912[4:3] == 2'h3) | (select_912[5] & (select_912[3] | select_912[4]));
  logic or_1053;
  assign or_1053 = (select_912[7:6] == 2'h3) | (select_912[8] & (select_912[6] | select_912[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1056;
  assign parity_1056 = ^{or_1053, or_1049, or_1045};
  // hls/stages/count_bits.hpp:25
  logic or_1060;
  assign or_1060 = (parity_938 & parity_941) | ((^select_912[2:0]) & (parity_938 | parity_941));
  logic or_1064;
  assign or_1064 = (parity_958 & parity_961) | ((^select_952[8:6]) & (parity_958 | parity_961));
  logic or_1068;
  assign or_1068 = (parity_970 & parity_973) | ((^select_935[5:3]) & (parity_970 | parity_973));
  // hls/stages/count_bits.hpp:24
  logic parity_1071;
  assign parity_1071 = ^{or_1068, or_1064, or_1060};
  logic parity_1074;
  assign parity_1074 = ^{or_1068, or_1064, or_1060, or_1053, or_1049, or_1045, or_1038, or_1034, and_1030};
  logic xor_1075;
  assign xor_1075 = parity_1029 ^ parity_1074;
  // hls/stages/count_bits.hpp:25
  logic and_1076;
  assign and_1076 = parity_1029 & parity_1074;
  logic or_1080;
  assign or_1080 = (parity_1011 & parity_1026) | ((^{or_992, or_988, or_984}) & (parity_1011 | parity_1026));
  logic or_1084;
  assign or_1084 = (parity_1056 & parity_1071) | ((^{or_1038, or_1034, and_1030}) & (parity_1056 | parity_1071));
  logic or_1091;
  assign or_1091 = (or_988 & or_992) | (or_984 & (or_988 | or_992));
  logic or_1095;
  assign or_1095 = (or_1004 & or_1008) | (or_1000 & (or_1004 | or_1008));
  logic or_1099;
  assign or_1099 = (or_1019 & or_1023) | (or_1015 & (or_1019 | or_1023));
  // hls/stages/count_bits.hpp:24
  logic parity_1102;
  assign parity_1102 = ^{or_1099, or_1095, or_1091};
  // hls/stages/count_bits.hpp:25
  logic or_1106;
  assign or_1106 = (or_1034 & or_1038) | (and_1030 & (or_1034 | or_1038));
  logic or_1110;
  assign or_1110 = (or_1049 & or_1053) | (or_1045 & (or_1049 | or_1053));
  logic or_1114;
  assign or_1114 = (or_1064 & or_1068) | (or_1060 & (or_1064 | or_1068));
  // hls/stages/count_bits.hpp:24
  logic parity_1117;
  assign parity_1117 = ^{or_1114, or_1110, or_1106};
  logic parity_1120;
  assign parity_1120 = ^{or_1114, or_1110, or_1106, or_1099, or_1095, or_1091, or_1084, or_1080, and_1076};
  // hls/stages/count_bits.hpp:25
  logic or_1124;
  assign or_1124 = (parity_1102 & parity_1117) | ((^{or_1084, or_1080, and_1076}) & (parity_1102 | parity_1117));
  logic or_1128;
  assign or_1128 = (or_1080 & or_1084) | (and_1076 & (or_1080 | or_1084));
  logic or_1132;
  assign or_1132 = (or_1095 & or_1099) | (or_1091 & (or_1095 | or_1099));
  logic or_1136;
  assign or_1136 = (or_1110 & or_1114) | (or_1106 & (or_1110 | or_1114));
  // hls/stages/count_bits.hpp:24
  logic parity_1141;
  assign parity_1141 = ^{or_1136, or_1132, or_1128, or_1124};
  // hls/stages/count_bits.hpp:25
  logic or_1145;
  assign or_1145 = (or_1132 & or_1136) | (or_1128 & (or_1132 | or_1136));
  logic and_1146;
  assign and_1146 = or_1124 & (^{or_1136, or_1132, or_1128});
  // hls/stages/count_bits.hpp:24
  logic xor_1147;
  assign xor_1147 = or_1145 ^ and_1146;
  // hls/stages/count_bits.hpp:27
  logic and_1148;
  assign and_1148 = or_1145 & and_1146;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1149;
  assign select_1149 = equal_524_s1_q ? {and_1148, xor_1147, parity_1141, parity_1120, xor_1075, xor_980} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_522_s1_q ? 6'h0 : select_1149;
  // hls/stages/agreement.hpp:212
  logic and_1157;
  assign and_1157 = right_codes_rdata_q[25] & not_530_s1_q;
  // hls/stages/agreement.hpp:718
  logic select_1158;
  assign select_1158 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_530_s1_q) : and_1157;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1160;
  assign select_1160 = less_529_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:718
  logic [11:0] select_1161;
  assign select_1161 = slot_s1_q[0] ? (less_529_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1160;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1165;
  assign select_1165 = and_656 ? (select_1158 ? (~(select_659 ^ select_1161)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1171;
  assign parity_1171 = ^select_1165[5:3];
  logic parity_1174;
  assign parity_1174 = ^select_1165[8:6];
  logic parity_1177;
  assign parity_1177 = ^select_1165[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1185;
  assign select_1185 = (slot_s1_q[0] ? and_1157 : and_657) ? (~(select_682 ^ (slot_s1_q[0] ? select_1160 : select_658))) : 12'h0;
  logic [11:0] select_1186;
  assign select_1186 = and_679 ? select_1185 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1189;
  assign parity_1189 = ^select_1186[8:6];
  logic parity_1192;
  assign parity_1192 = ^select_1186[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1200;
  assign select_1200 = (slot_s1_q[0] ? and_657 : and_680) ? (~(select_699 ^ (slot_s1_q[0] ? select_658 : select_681))) : 12'h0;
  logic [11:0] select_1201;
  assign select_1201 = and_696 ? select_1200 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1207;
  assign parity_1207 = ^select_1201[2:0];
  logic parity_1210;
  assign parity_1210 = ^select_1201[5:3];
  logic parity_1213;
  assign parity_1213 = ^select_1201[8:0];
  logic parity_1219;
  assign parity_1219 = ^select_1201[11:9];
  logic parity_1222;
  assign parity_1222 = ^select_1186[2:0];
  logic parity_1225;
  assign parity_1225 = ^{select_1201[11:9], select_1186[5:0]};
  logic parity_1228;
  assign parity_1228 = ^{select_1201, select_1186, select_1165[2:0]};
  logic xor_1229;
  assign xor_1229 = parity_1177 ^ parity_1228;
  // hls/stages/count_bits.hpp:23
  logic or_1233;
  assign or_1233 = (select_1165[1:0] == 2'h3) | (select_1165[2] & (select_1165[0] | select_1165[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1237;
  assign or_1237 = (select_1186[7:6] == 2'h3) | (select_1186[8] & (select_1186[6] | select_1186[7]));
  logic or_1241;
  assign or_1241 = (select_1186[10:9] == 2'h3) | (select_1186[11] & (select_1186[9] | select_1186[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1249;
  assign or_1249 = (select_1201[7:6] == 2'h3) | (select_1201[8] & (~(select_1201[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1253;
  assign or_1253 = (select_1201[1:0] == 2'h3) | (select_1201[2] & (select_1201[0] | select_1201[1]));
  logic or_1257;
  assign or_1257 = (select_1201[4:3] == 2'h3) | (select_1201[5] & (select_1201[3] | select_1201[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1260;
  assign parity_1260 = ^{or_1257, or_1253, or_1249};
  // hls/stages/count_bits.hpp:23
  logic or_1264;
  assign or_1264 = (select_1186[4:3] == 2'h3) | (select_1186[5] & (select_1186[3] | select_1186[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1268;
  assign or_1268 = (select_1201[10:9] == 2'h3) | (select_1201[11] & (select_1201[9] | select_1201[10]));
  logic or_1272;
  assign or_1272 = (select_1186[1:0] == 2'h3) | (select_1186[2] & (select_1186[0] | select_1186[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1275;
  assign parity_1275 = ^{or_1272, or_1268, or_1264};
  logic parity_1278;
  assign parity_1278 = ^{or_1272, or_1268, or_1264, or_1257, or_1253, or_1249, or_1241, or_1237, or_1233};
  // hls/stages/count_bits.hpp:25
  logic and_1279;
  assign and_1279 = parity_1177 & parity_1228;
  logic or_1283;
  assign or_1283 = (parity_1171 & parity_1174) | ((^select_1165[11:9]) & (parity_1171 | parity_1174));
  logic and_1286;
  assign and_1286 = (^{select_1186[11:6], select_1165[2:0]}) & (parity_1213 | parity_1225);
  logic or_1287;
  assign or_1287 = (parity_1213 & parity_1225) | and_1286;
  // hls/stages/count_bits.hpp:23
  logic or_1294;
  assign or_1294 = (select_1165[10:9] == 2'h3) | (select_1165[11] & (select_1165[9] | select_1165[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1298;
  assign or_1298 = (select_1165[4:3] == 2'h3) | (select_1165[5] & (select_1165[3] | select_1165[4]));
  logic or_1302;
  assign or_1302 = (select_1165[7:6] == 2'h3) | (select_1165[8] & (select_1165[6] | select_1165[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1305;
  assign parity_1305 = ^{or_1302, or_1298, or_1294};
  // hls/stages/count_bits.hpp:25
  logic or_1309;
  assign or_1309 = (parity_1189 & parity_1192) | ((^select_1165[2:0]) & (parity_1189 | parity_1192));
  logic or_1313;
  assign or_1313 = (parity_1207 & parity_1210) | ((^select_1201[8:6]) & (parity_1207 | parity_1210));
  logic or_1317;
  assign or_1317 = (parity_1219 & parity_1222) | ((^select_1186[5:3]) & (parity_1219 | parity_1222));
  // hls/stages/count_bits.hpp:24
  logic parity_1320;
  assign parity_1320 = ^{or_1317, or_1313, or_1309};
  logic parity_1323;
  assign parity_1323 = ^{or_1317, or_1313, or_1309, or_1302, or_1298, or_1294, or_1287, or_1283, and_1279};
  logic xor_1324;
  assign xor_1324 = parity_1278 ^ parity_1323;
  // hls/stages/count_bits.hpp:25
  logic and_1325;
  assign and_1325 = parity_1278 & parity_1323;
  logic or_1329;
  assign or_1329 = (parity_1260 & parity_1275) | ((^{or_1241, or_1237, or_1233}) & (parity_1260 | parity_1275));
  logic or_1333;
  assign or_1333 = (parity_1305 & parity_1320) | ((^{or_1287, or_1283, and_1279}) & (parity_1305 | parity_1320));
  logic or_1340;
  assign or_1340 = (or_1237 & or_1241) | (or_1233 & (or_1237 | or_1241));
  logic or_1344;
  assign or_1344 = (or_1253 & or_1257) | (or_1249 & (or_1253 | or_1257));
  logic or_1348;
  assign or_1348 = (or_1268 & or_1272) | (or_1264 & (or_1268 | or_1272));
  // hls/stages/count_bits.hpp:24
  logic parity_1351;
  assign parity_1351 = ^{or_1348, or_1344, or_1340};
  // hls/stages/count_bits.hpp:25
  logic or_1355;
  assign or_1355 = (or_1283 & or_1287) | (and_1279 & (or_1283 | or_1287));
  logic or_1359;
  assign or_1359 = (or_1298 & or_1302) | (or_1294 & (or_1298 | or_1302));
  logic or_1363;
  assign or_1363 = (or_1313 & or_1317) | (or_1309 & (or_1313 | or_1317));
  // hls/stages/count_bits.hpp:24
  logic parity_1366;
  assign parity_1366 = ^{or_1363, or_1359, or_1355};
  logic parity_1369;
  assign parity_1369 = ^{or_1363, or_1359, or_1355, or_1348, or_1344, or_1340, or_1333, or_1329, and_1325};
  // hls/stages/count_bits.hpp:25
  logic or_1373;
  assign or_1373 = (parity_1351 & parity_1366) | ((^{or_1333, or_1329, and_1325}) & (parity_1351 | parity_1366));
  logic or_1377;
  assign or_1377 = (or_1329 & or_1333) | (and_1325 & (or_1329 | or_1333));
  logic or_1381;
  assign or_1381 = (or_1344 & or_1348) | (or_1340 & (or_1344 | or_1348));
  logic or_1385;
  assign or_1385 = (or_1359 & or_1363) | (or_1355 & (or_1359 | or_1363));
  // hls/stages/count_bits.hpp:24
  logic parity_1390;
  assign parity_1390 = ^{or_1385, or_1381, or_1377, or_1373};
  // hls/stages/count_bits.hpp:25
  logic or_1394;
  assign or_1394 = (or_1381 & or_1385) | (or_1377 & (or_1381 | or_1385));
  logic and_1395;
  assign and_1395 = or_1373 & (^{or_1385, or_1381, or_1377});
  // hls/stages/count_bits.hpp:24
  logic xor_1396;
  assign xor_1396 = or_1394 ^ and_1395;
  // hls/stages/count_bits.hpp:27
  logic and_1397;
  assign and_1397 = or_1394 & and_1395;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1398;
  assign select_1398 = equal_524_s1_q ? {and_1397, xor_1396, parity_1390, parity_1369, xor_1324, xor_1229} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_522_s1_q ? 6'h0 : select_1398;
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:929
  logic [5:0] select_1456;
  assign select_1456 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:932
  logic and_1476;
  assign and_1476 = (or_522_s1_q & (left_rdata_q[61] & not_530_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1498;
  assign or_1498 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/patches.hpp:321
  logic [5:0] select_1509;
  assign select_1509 = so_s1_q ? x_s1_q[5:0] : (or_522_s1_q ? (less_529_s1_q ? 6'h0 : select_1456) : 6'h0);
  // hls/stages/patches.hpp:105
  logic and_1583;
  assign and_1583 = (select_465_s1_q == 3'h0) & (select_467_s1_q == 6'h0);
  // hls/stages/patches.hpp:373
  logic not_1584;
  assign not_1584 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_1587;
  assign not_1587 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:343
  logic and_1588;
  assign and_1588 = patches_capturing_q & not_1587;
  // hls/stages/patches.hpp:293
  logic equal_1591;
  assign equal_1591 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:108
  logic and_1596;
  assign and_1596 = (not_1584 & (patches_work_q == 3'h0)) & (~(and_1588 | ((~equal_1589_s1_q) | (~equal_1591))));
  // hls/stages/patches.hpp:511
  logic equal_1683;
  assign equal_1683 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:489
  logic not_1684;
  assign not_1684 = ~equal_1683;
  // hls/stages/patches.hpp:482
  logic equal_1685;
  assign equal_1685 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:435
  logic not_1686;
  assign not_1686 = ~equal_1685;
  // hls/stages/patches.hpp:476
  logic equal_1687;
  assign equal_1687 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:150
  logic equal_1688;
  assign equal_1688 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:511
  logic or_1689;
  assign or_1689 = equal_1687 | equal_1688;
  // hls/stages/patches.hpp:437
  logic not_1690;
  assign not_1690 = ~patches_second_q;
  // hls/stages/patches.hpp:354
  logic [4:0] select_1712;
  assign select_1712 = and_1596 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:109
  logic [4:0] select_1713;
  assign select_1713 = and_1583 ? select_1712 : patches_row_q;
  // hls/stages/patches.hpp:108
  logic and_1715;
  assign and_1715 = and_1588 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:109
  logic select_1719;
  assign select_1719 = and_1583 ? (and_1596 | (and_1588 & (~and_1715))) : patches_capturing_q;
  // hls/stages/patches.hpp:167
  logic and_1727;
  assign and_1727 = not_1684 & (not_1686 & (or_1689 & (patches_second_q & equal_1688)));
  // hls/stages/patches.hpp:150
  logic not_1744;
  assign not_1744 = ~equal_1688;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1760;
  assign select_1760 = and_1583 ? {select_1712[4], select_1712[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:435
  logic and_1770;
  assign and_1770 = not_1684 & (or_1689 & not_1686);
  // hls/stages/agreement.hpp:447
  logic select_2385;
  assign select_2385 = equal_2288_s1_q ? (~({row_s1_q, 1'b0} < {sum_2382, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2590;
  assign and_2590 = and_501_s1_q & (equal_2288_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:299
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:109
  logic [3:0] select_2700;
  assign select_2700 = and_1583 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2701;
  assign select_2701 = sample_pair_whole_s1_q ? select_2700 : patches_phase_q;
  // hls/stages/patches.hpp:354
  logic and_2702;
  assign and_2702 = not_1587 & equal_1589_s1_q;
  logic [8:0] select_2703;
  assign select_2703 = and_2702 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2704;
  assign select_2704 = and_2702 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2705;
  assign select_2705 = sample_pair_first_s1_q ? select_2703 : select_2704;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2707;
  assign select_2707 = sample_pair_whole_s1_q ? (and_1583 ? select_2705[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2709;
  assign select_2709 = sample_pair_whole_s1_q ? (and_1583 ? select_2705[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2712;
  assign select_2712 = sample_pair_whole_s1_q ? (equal_1591 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2714;
  assign select_2714 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_1591}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:312
  logic equal_2715;
  assign equal_2715 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:313
  logic not_2716;
  assign not_2716 = ~equal_2715;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2718;
  assign select_2718 = sample_pair_whole_s1_q ? (phase + {not_2716, 1'b1, not_2716, equal_2715}) : patches_first_band_rows_to_next_q;
  logic select_2719;
  assign select_2719 = sample_pair_whole_s1_q ? equal_2715 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:457
  logic equal_2720;
  assign equal_2720 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:70
  logic [3:0] select_2724;
  assign select_2724 = equal_2720 ? ((select_2701 == 4'h6) ? 4'h0 : (select_2701 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2725;
  assign equal_2725 = select_2724 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_2728;
  assign select_2728 = equal_2288_s1_q ? (equal_2725 ? 4'h6 : (select_2724 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:70
  logic [4:0] select_2730;
  assign select_2730 = equal_2720 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_2732;
  assign select_2732 = equal_2288_s1_q ? (select_2730 + {4'h0, equal_2725}) : patches_choosing_number_q;
  logic select_2736;
  assign select_2736 = equal_2288_s1_q ? ((6'h2 < row_s1_q) & equal_2725) : patches_chooses_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_2739;
  assign select_2739 = and_501_s1_q ? (equal_2288_s1_q ? select_2730 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:109
  logic select_2767;
  assign select_2767 = and_1583 ? (and_1596 ? not_2765_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:374
  logic or_2806;
  assign or_2806 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:376
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:170
  logic and_2812;
  assign and_2812 = equal_1683 & not_1690;
  // hls/stages/patches.hpp:380
  logic and_2813;
  assign and_2813 = not_1744 & and_2812;
  logic [1:0] select_2815;
  assign select_2815 = equal_1685 ? 2'h0 : (equal_1687 ? 2'h3 : {equal_1688, and_2813});
  // hls/stages/patches.hpp:261
  logic equal_2817;
  assign equal_2817 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:259
  logic not_2818;
  assign not_2818 = ~equal_2817;
  // hls/stages/patches.hpp:261
  logic equal_2819;
  assign equal_2819 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:257
  logic not_2820;
  assign not_2820 = ~equal_2819;
  // hls/stages/patches.hpp:265
  logic not_2822;
  assign not_2822 = ~(patches_following_q == 3'h2);
  logic and_2825;
  assign and_2825 = (~(patches_following_q == 3'h1)) & not_2822;
  // hls/stages/patches.hpp:378
  logic [1:0] select_2826;
  assign select_2826 = equal_2819 ? 2'h2 : {and_2825, not_2822};
  logic [3:0] select_2827;
  assign select_2827 = equal_2817 ? 4'h2 : {select_2826, {2{not_2820}}};
  // hls/stages/patches.hpp:386
  logic not_2830;
  assign not_2830 = ~or_2806;
  // hls/stages/patches.hpp:375
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:387
  logic [11:0] select_2835;
  assign select_2835 = or_2806 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:170
  logic [4:0] select_2837;
  assign select_2837 = or_2806 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1298; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_522_s1_q ? select_1456 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_643_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:740; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s1_en & (not_1684 & (not_1686 & (or_1689 & (equal_1688 & not_1690))));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:740; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s1_en & and_1727;
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:741; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s1_en & (not_1684 & (not_1686 & (not_1744 & or_1689)));
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:752; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign patches_columns_above_re = s1_en & and_1770;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_533_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_625, left_rdata_q[59:45], and_624, left_rdata_q[43:29], and_623, left_rdata_q[27:13], and_622, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_533_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_634, right_codes_rdata_q[76:65], and_633, right_codes_rdata_q[63:52], and_632, right_codes_rdata_q[50:39], and_631, right_codes_rdata_q[37:26], and_630, right_codes_rdata_q[24:13], and_629, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_501_s1_q ? (equal_2288_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_501_s1_q ? select_2385 : lower_half_q;
      patches_phase_q <= select_2701;
      patches_band_rows_rows_to_next_q <= select_2707;
      patches_band_rows_number_q <= select_2709;
      patches_next_band_rows_to_next_q <= select_2712;
      patches_next_band_number_q <= select_2714;
      patches_first_band_rows_to_next_q <= select_2718;
      patches_first_band_number_q <= select_2719;
      patches_choosing_rows_to_next_q <= and_501_s1_q ? select_2728 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_501_s1_q ? select_2732 : patches_choosing_number_q;
      patches_chooses_q <= and_501_s1_q ? select_2736 : patches_chooses_q;
      patches_choosing_band_q <= select_2739;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_1719 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_2767 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_1713 : patches_row_q;
      patches_work_q <= or_2806 ? following : patches_work_q;
      patches_second_q <= not_1584 & (patches_second_q | (patches_ends_q & equal_1683));
      patches_following_q <= equal_1683 ? {2'h0, and_2812} : {equal_1685, select_2815};
      patches_following_beats_q <= {select_2827, not_2818};
      patches_begins_q <= sample_pair_whole_s1_q & (and_1583 & and_1715);
      patches_ends_q <= not_2830 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2835;
      patches_code_row_q <= select_2837;
      patches_column_q <= or_2806 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2830 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_465_s2_q;
  logic [5:0] select_467_s2_q;
  logic [7:0] select_471_s2_q;
  logic and_475_s2_q;
  logic equal_481_s2_q;
  logic [5:0] column_s2_q;
  logic and_499_s2_q;
  logic and_501_s2_q;
  logic so_s2_q;
  logic equal_521_s2_q;
  logic or_522_s2_q;
  logic less_529_s2_q;
  logic not_530_s2_q;
  logic equal_562_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_650_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1151_s2_q;
  logic [5:0] select_1400_s2_q;
  logic and_1452_s2_q;
  logic [5:0] right_s2_q;
  logic select_1461_s2_q;
  logic equal_1470_s2_q;
  logic and_1477_s2_q;
  logic and_1480_s2_q;
  logic and_1484_s2_q;
  logic or_1498_s2_q;
  logic [5:0] select_1509_s2_q;
  logic and_1583_s2_q;
  logic and_1596_s2_q;
  logic less_1610_s2_q;
  logic equal_1683_s2_q;
  logic not_1684_s2_q;
  logic equal_1685_s2_q;
  logic not_1686_s2_q;
  logic equal_1687_s2_q;
  logic equal_1688_s2_q;
  logic or_1689_s2_q;
  logic [4:0] select_1713_s2_q;
  logic select_1719_s2_q;
  logic [3:0] select_1760_s2_q;
  logic and_1770_s2_q;
  logic and_1864_s2_q;
  logic select_1866_s2_q;
  logic and_1869_s2_q;
  logic and_2018_s2_q;
  logic equal_2164_s2_q;
  logic equal_2288_s2_q;
  logic and_2591_s2_q;
  logic and_2593_s2_q;
  logic or_2806_s2_q;
  logic not_2830_s2_q;
  logic less_3592_s2_q;
  logic equal_3797_s2_q;
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
      select_465_s2_q <= select_465_s1_q;
      select_467_s2_q <= select_467_s1_q;
      select_471_s2_q <= select_471_s1_q;
      and_475_s2_q <= and_475_s1_q;
      equal_481_s2_q <= equal_481_s1_q;
      column_s2_q <= column_s1_q;
      and_499_s2_q <= and_499_s1_q;
      and_501_s2_q <= and_501_s1_q;
      so_s2_q <= so_s1_q;
      equal_521_s2_q <= equal_521_s1_q;
      or_522_s2_q <= or_522_s1_q;
      less_529_s2_q <= less_529_s1_q;
      not_530_s2_q <= not_530_s1_q;
      equal_562_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_650_s2_q <= select_650_s1_q;
      column_2_s2_q <= column_2;
      select_1151_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1400_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1452_s2_q <= and_1452_s1_q;
      right_s2_q <= right_s1_q;
      select_1461_s2_q <= select_1461_s1_q;
      equal_1470_s2_q <= equal_1470_s1_q;
      and_1477_s2_q <= not_530_s1_q & and_1476;
      and_1480_s2_q <= (or_522_s1_q & (left_rdata_q[62] & not_530_s1_q)) & and_1476;
      and_1484_s2_q <= not_530_s1_q & (or_522_s1_q & (left_rdata_q[63] & not_530_s1_q));
      or_1498_s2_q <= or_1498;
      select_1509_s2_q <= select_1509;
      and_1583_s2_q <= and_1583;
      and_1596_s2_q <= and_1596;
      less_1610_s2_q <= 5'h4 < row_q[5:1];
      equal_1683_s2_q <= equal_1683;
      not_1684_s2_q <= not_1684;
      equal_1685_s2_q <= equal_1685;
      not_1686_s2_q <= not_1686;
      equal_1687_s2_q <= equal_1687;
      equal_1688_s2_q <= equal_1688;
      or_1689_s2_q <= or_1689;
      select_1713_s2_q <= select_1713;
      select_1719_s2_q <= select_1719;
      select_1760_s2_q <= select_1760;
      and_1770_s2_q <= and_1770;
      and_1864_s2_q <= sample_pair_whole_q;
      select_1866_s2_q <= left_first_q;
      and_1869_s2_q <= right_q;
      and_2018_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2164_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_2288_s2_q <= equal_2288_s1_q;
      and_2591_s2_q <= and_2289_s1_q & and_2590;
      and_2593_s2_q <= and_2289_s1_q & (~and_2590);
      or_2806_s2_q <= or_2806;
      not_2830_s2_q <= not_2830;
      less_3592_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3797_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic and_476;
  assign and_476 = sample_pair_whole_s2_q & and_475_s2_q;
  // hls/stages/agreement.hpp:772
  logic not_652;
  assign not_652 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_653;
  assign less_653 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:231
  logic and_655;
  assign and_655 = not_652 & (~less_653);
  // hls/stages/agreement.hpp:762
  logic [5:0] select_902;
  assign select_902 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_903;
  assign difference_903 = {1'b0, column_2_s2_q} - {1'b0, select_902};
  logic [7:0] sum_905;
  assign sum_905 = {difference_903[6], difference_903} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:739
  logic [7:0] select_906;
  assign select_906 = slot_s2_q[0] ? chosen_score_q : sum_905;
  // hls/stages/agreement.hpp:762
  logic [6:0] difference_1152;
  assign difference_1152 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1151_s2_q};
  // hls/stages/agreement.hpp:733
  logic equal_1153;
  assign equal_1153 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:762
  logic [7:0] sum_1155;
  assign sum_1155 = {difference_1152[6], difference_1152} + (equal_1153 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1401;
  assign difference_1401 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1400_s2_q};
  logic [7:0] sum_1403;
  assign sum_1403 = {difference_1401[6], difference_1401} + (equal_1153 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:735
  logic less_1404;
  assign less_1404 = sum_1155 < sum_1403;
  logic [7:0] select_1405;
  assign select_1405 = less_1404 ? sum_1403 : sum_1155;
  logic less_1406;
  assign less_1406 = select_906 < select_1405;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_655 ? (less_1406 ? select_1405 : select_906) : 8'h0;
  // hls/stages/agreement.hpp:783
  logic or_1410;
  assign or_1410 = select_650_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1411;
  assign select_1411 = or_1410 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:704
  logic not_1412;
  assign not_1412 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:736
  logic [1:0] select_1413;
  assign select_1413 = less_1404 ? {slot_s2_q[0], not_1412} : 2'h0;
  logic [2:0] select_1415;
  assign select_1415 = less_1406 ? {select_1413, not_1412} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:788
  logic [2:0] select_1416;
  assign select_1416 = or_1410 ? select_1415 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1417;
  assign select_1417 = or_1410 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:785
  logic equal_1418;
  assign equal_1418 = select_1415 == 3'h1;
  logic equal_1419;
  assign equal_1419 = select_1415 == 3'h2;
  logic not_1420;
  assign not_1420 = ~equal_1419;
  logic [2:0] select_1421;
  assign select_1421 = equal_1418 ? 3'h2 : {not_1420, {2{equal_1419}}};
  // hls/stages/agreement.hpp:227
  logic [7:0] select_1424;
  assign select_1424 = slot_s2_q[0] ? 8'h0 : sum_905;
  // hls/stages/agreement.hpp:785
  logic [7:0] select_1426;
  assign select_1426 = select_1421[1] ? (select_1421[0] ? before_1_q : sum_1155) : (select_1421[0] ? sum_1155 : select_1424);
  logic [7:0] select_1427;
  assign select_1427 = select_1421[2] ? (select_1421[0] ? before_2_q : before_0_q) : select_1426;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1428;
  assign select_1428 = or_1410 ? select_1427 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:786
  logic [1:0] select_1429;
  assign select_1429 = equal_1418 ? 2'h0 : {not_1420, equal_1419};
  logic [7:0] select_1431;
  assign select_1431 = select_1429[1] ? sum_1403 : (select_1429[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1432;
  assign select_1432 = or_1410 ? select_1431 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1434;
  assign sum_1434 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1435;
  assign sum_1435 = {1'b0, before_v} + sum_1434;
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1436;
  assign select_1436 = slot_s2_q[0] ? chosen_near_q : sum_1435;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1438;
  assign sum_1438 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1439;
  assign sum_1439 = {1'b0, before_v_2} + sum_1438;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1441;
  assign sum_1441 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1442;
  assign sum_1442 = {1'b0, before_v_3} + sum_1441;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1444;
  assign select_1444 = (sum_1439 < sum_1442) ? sum_1442 : sum_1439;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_655 ? ((select_1436 < select_1444) ? select_1444 : select_1436) : 7'h0;
  // hls/stages/agreement.hpp:788
  logic or_1449;
  assign or_1449 = select_650_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:792
  logic [6:0] select_1450;
  assign select_1450 = or_1449 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1451;
  assign select_1451 = or_1449 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:797
  logic or_1463;
  assign or_1463 = select_1461_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1464;
  assign select_1464 = or_1463 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1465;
  assign select_1465 = or_1463 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1467;
  assign or_1467 = select_1461_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1468;
  assign select_1468 = or_1467 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1469;
  assign select_1469 = or_1467 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic not_1471;
  assign not_1471 = ~equal_1470_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1481;
  assign and_1481 = not_530_s2_q & and_1480_s2_q;
  // hls/stages/agreement.hpp:935
  logic select_1487;
  assign select_1487 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1490;
  assign difference_1490 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:943
  logic [9:0] sum_1491;
  assign sum_1491 = {difference_1490[8], difference_1490} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1493;
  assign and_1493 = (and_1480_s2_q & select_1487) & ({{22{sum_1491[9]}}, sum_1491} < 32'h3);
  logic and_1494;
  assign and_1494 = not_530_s2_q & and_1493;
  logic and_1500;
  assign and_1500 = not_530_s2_q & (and_1493 & or_1498_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1501;
  assign select_1501 = less_529_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_522_s2_q ? {select_1501, and_1500, and_1494, and_1484_s2_q, and_1481, and_1477_s2_q, not_530_s2_q} : 15'h0;
  // hls/stages/patches.hpp:321
  logic and_1503;
  assign and_1503 = ends_cell_s2_q & shift_2[0];
  logic and_1505;
  assign and_1505 = not_1471 & (so_s2_q & and_1503);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1613;
  assign select_1613 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1613[16:7])) ? 8'h7f : select_1613[7:0];
  // hls/stages/patches.hpp:155
  logic [7:0] pixel;
  assign pixel = equal_1688_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1688_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:477
  logic less_1776;
  assign less_1776 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:478
  logic or_1777;
  assign or_1777 = equal_1687_s2_q | less_1776;
  // hls/stages/patches.hpp:481
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1782;
  assign select_1782 = equal_1687_s2_q ? patches_column_s2_q[0] : (or_1777 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1783;
  assign not_1783 = ~or_1777;
  // hls/stages/patches.hpp:478
  logic [4:0] sum_1784;
  assign sum_1784 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:480
  logic [4:0] select_1787;
  assign select_1787 = or_1777 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1784) + 5'h1) : sum_1784;
  // hls/stages/patches.hpp:482
  logic [4:0] select_1788;
  assign select_1788 = equal_1687_s2_q ? 5'h0 : select_1787;
  logic or_1789;
  assign or_1789 = equal_1687_s2_q | equal_1685_s2_q;
  // hls/stages/patches.hpp:458
  logic equal_1791;
  assign equal_1791 = patches_column_s2_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s2_q == 5'h11;
  logic equal_1793;
  assign equal_1793 = patches_column_s2_q == 5'h18;
  // hls/stages/patches.hpp:460
  logic and_1795;
  assign and_1795 = of_row & (~equal_1793);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1791 ? 2'h3 : {equal_1793, and_1795};
  // hls/stages/patches.hpp:446
  logic [8:0] sum_1798;
  assign sum_1798 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1799;
  assign sum_1799 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1798, pixel_2[0]} - {1'b0, sum_1799, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:448
  logic [11:0] sum_1801;
  assign sum_1801 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1802;
  assign sum_1802 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1801[11], sum_1801};
  logic [13:0] sum_1803;
  assign sum_1803 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1802, down_2[1]};
  logic [12:0] sum_1804;
  assign sum_1804 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1803[13:1];
  logic [14:0] sum_1805;
  assign sum_1805 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1804, sum_1803[0], down_2[0]};
  // hls/stages/patches.hpp:444
  logic [8:0] sum_1808;
  assign sum_1808 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1809;
  assign sum_1809 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1808};
  logic [10:0] sum_1810;
  assign sum_1810 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1809, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1811;
  assign sum_1811 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1810[10:1];
  // hls/stages/patches.hpp:445
  logic [11:0] smooth;
  assign smooth = {sum_1811, sum_1810[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:447
  logic [12:0] sum_1813;
  assign sum_1813 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1814;
  assign sum_1814 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1815;
  assign difference_1815 = {1'b0, sum_1813, smooth[0]} - {1'b0, sum_1814, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:459
  logic or_1821;
  assign or_1821 = (((patches_column_s2_q == 5'ha) | of_row) | equal_1793) | equal_1791;
  // hls/stages/patches.hpp:454
  logic and_1826;
  assign and_1826 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:167
  logic and_1830;
  assign and_1830 = not_1686_s2_q & (or_1689_s2_q & (or_1821 & (equal_1688_s2_q & and_1826)));
  // hls/stages/patches.hpp:155
  logic and_1840;
  assign and_1840 = (~(equal_1688_s2_q | (~and_1826))) & (~patches_column_s2_q[4]);
  // hls/stages/patches.hpp:167
  logic and_1844;
  assign and_1844 = not_1686_s2_q & (or_1689_s2_q & (and_1840 & (patches_column_s2_q == 5'hf)));
  // hls/stages/patches.hpp:523
  logic less_1846;
  assign less_1846 = patches_step_q[4:0] < 5'h11;
  logic equal_1847;
  assign equal_1847 = patches_step_q[6:5] == 2'h0;
  logic not_1848;
  assign not_1848 = ~equal_1847;
  logic equal_1849;
  assign equal_1849 = patches_step_q[6:5] == 2'h3;
  logic not_1850;
  assign not_1850 = ~equal_1849;
  // hls/stages/patches.hpp:537
  logic select_1853;
  assign select_1853 = equal_1849 ? (less_1846 & (less_1846 & not_1850)) : less_1846;
  // hls/stages/patches.hpp:167
  logic and_1856;
  assign and_1856 = equal_1683_s2_q & (less_1846 ? (not_1848 & select_1853) : select_1853);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1885;
  assign sum_1885 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:227
  logic [5:0] select_2388;
  assign select_2388 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2389;
  assign select_2389 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2390;
  assign select_2390 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2391;
  assign select_2391 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2392;
  assign select_2392 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2393;
  assign select_2393 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  // hls/stages/agreement.hpp:735
  logic less_2397;
  assign less_2397 = select_1424 < select_1405;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2399;
  assign select_2399 = slot_s2_q[0] ? 7'h0 : sum_1435;
  // hls/stages/registration.hpp:76
  logic less_2488;
  assign less_2488 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2490;
  assign select_2490 = or_522_s2_q ? (less_529_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2492;
  assign select_2492 = or_522_s2_q ? (less_529_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2494;
  assign select_2494 = or_522_s2_q ? (less_529_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2492} - {1'b0, select_2494};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2496;
  assign select_2496 = rise[8] ? select_2492 : select_2494;
  logic [8:0] difference_2497;
  assign difference_2497 = {1'b0, select_2490} - {1'b0, select_2496};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2497[8] ? 8'h0 : difference_2497[7:0];
  // hls/stages/registration.hpp:37
  logic not_2499;
  assign not_2499 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2488 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2499};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2501;
  assign xor_2501 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2501};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2507;
  assign select_2507 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2488 ? {taken, 1'b1} : {not_2499, select_2507, not_2499};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2509;
  assign sum_2509 = {left, 1'b1} + {taken_2, less_2488};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2511;
  assign select_2511 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2594;
  assign select_2594 = and_2593_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2596;
  assign select_2596 = and_2591_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2594[15]}}, select_2594});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2597;
  assign select_2597 = and_2593_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2597[15]}}, select_2597};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2599;
  assign select_2599 = and_2591_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_2600;
  assign and_2600 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2600 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:170
  logic select_2845;
  assign select_2845 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:167
  logic [11:0] select_2848;
  assign select_2848 = equal_1685_s2_q ? patches_smooth_values_0_q : (or_1689_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_2850;
  assign select_2850 = or_1689_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2852;
  assign select_2852 = equal_1683_s2_q ? patches_smooth_values_1_q : (equal_1685_s2_q ? patches_smooth_values_1_q : select_2850);
  logic [11:0] select_2853;
  assign select_2853 = or_1689_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2855;
  assign select_2855 = equal_1683_s2_q ? patches_smooth_values_2_q : (equal_1685_s2_q ? patches_smooth_values_2_q : select_2853);
  logic [11:0] select_2856;
  assign select_2856 = or_1689_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2858;
  assign select_2858 = equal_1683_s2_q ? patches_smooth_values_3_q : (equal_1685_s2_q ? patches_smooth_values_3_q : select_2856);
  logic [10:0] select_2860;
  assign select_2860 = equal_1685_s2_q ? patches_down_values_0_q : (or_1689_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_2863;
  assign select_2863 = equal_1685_s2_q ? patches_down_values_1_q : (or_1689_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_2866;
  assign select_2866 = equal_1685_s2_q ? patches_down_values_2_q : (or_1689_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_2869;
  assign select_2869 = equal_1685_s2_q ? patches_down_values_3_q : (or_1689_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:158
  logic and_2906;
  assign and_2906 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:394
  logic [4:0] select_2911;
  assign select_2911 = or_2806_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:396
  logic [3:0] select_2913;
  assign select_2913 = and_2906 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:167
  logic [4:0] select_3269;
  assign select_3269 = equal_1683_s2_q ? patches_summed_down_by_q : (equal_1685_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:533
  logic and_3302;
  assign and_3302 = less_1846 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:537
  logic select_3305;
  assign select_3305 = equal_1849 ? (less_1846 ? (not_1850 & and_3302) : and_3302) : and_3302;
  // hls/stages/patches.hpp:167
  logic select_3308;
  assign select_3308 = equal_1683_s2_q ? (less_1846 ? (not_1848 & select_3305) : select_3305) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3604;
  assign select_3604 = so_s2_q ? (and_2600 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3606;
  assign sum_3606 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3607;
  assign select_3607 = sum_1885[5] ? {1'b1, sum_1885[4:0], region_across_rest_q[2:0]} : sum_3606;
  // hls/stages/agreement.hpp:447
  logic [7:0] select_3609;
  assign select_3609 = equal_2288_s2_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3612;
  assign select_3612 = equal_2288_s2_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_471_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_476;
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
  assign census_memory_re = s2_en & and_501_s2_q;
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
  assign shown_right_re = s2_en & and_1505;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:757; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1788, not_1783, select_1782};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & or_1789;
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:758; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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
  assign patches_left_codes_re = s2_en & (not_1684_s2_q & (new_row & equal_1685_s2_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:772; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
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
  assign patches_rows_re = s2_en & and_1856;
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
  assign seen_columns_re = s2_en & and_1505;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1452_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1451, select_1450, select_1432, select_1428, select_1417, select_1416, select_1411};
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
  assign best_right_we = s2_en & and_1452_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1469, select_1468, select_1465, select_1464};
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
  assign patches_columns_above_we = s2_en & and_1770_s2_q;
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
      chosen_score_q <= less_2397 ? select_1405 : select_1424;
      chosen_near_q <= (select_2399 < select_1444) ? select_1444 : select_2399;
      chosen_place_q <= less_2397 ? {select_1413, not_1412} : 3'h2;
      before_0_q <= select_1424;
      before_1_q <= sum_1155;
      before_2_q <= sum_1403;
      registration_displacement_over_q <= so_s2_q ? sum_2509[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2511;
      registration_slope_row_q <= select_2596;
      registration_slope_change_q <= select_2599;
      registration_slope_q <= so_s2_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_2830_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2830_s2_q & select_2845;
      patches_smooth_values_0_q <= equal_1683_s2_q ? patches_smooth_values_0_q : select_2848;
      patches_smooth_values_1_q <= select_2852;
      patches_smooth_values_2_q <= select_2855;
      patches_smooth_values_3_q <= select_2858;
      patches_down_values_0_q <= equal_1683_s2_q ? patches_down_values_0_q : select_2860;
      patches_down_values_1_q <= equal_1683_s2_q ? patches_down_values_1_q : select_2863;
      patches_down_values_2_q <= equal_1683_s2_q ? patches_down_values_2_q : select_2866;
      patches_down_values_3_q <= equal_1683_s2_q ? patches_down_values_3_q : select_2869;
      patches_down_by_q <= or_2806_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2906});
      patches_along_q <= select_2911;
      patches_match_row_q <= or_2806_s2_q ? 4'h0 : select_2913;
      patches_summed_last_q <= not_1684_s2_q & (equal_1685_s2_q & and_2906);
      patches_summed_down_by_q <= select_3269;
      patches_step_q <= or_2806_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3308;
      region_across_rest_q <= select_3604;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3607;
      columns_begin_rest_q <= and_501_s2_q ? select_3609 : columns_begin_rest_q;
      columns_begin_back_q <= and_501_s2_q ? select_3612 : columns_begin_back_q;
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
      middle_sum_columns_values_1_q <= select_2388;
      middle_sum_columns_values_2_q <= select_2389;
      middle_sum_columns_values_3_q <= select_2390;
      middle_sum_columns_values_4_q <= select_2391;
      middle_sum_columns_values_5_q <= select_2392;
      middle_sum_columns_values_6_q <= select_2393;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_905;
      sums_0_sum_sums_values_0_q <= sum_1155;
      sums_0_sum_sums_values_1_q <= equal_1153 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1403;
      sums_1_sum_sums_values_1_q <= equal_1153 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [2:0] select_465_s3_q;
  logic [5:0] select_467_s3_q;
  logic [7:0] select_471_s3_q;
  logic and_475_s3_q;
  logic and_476_s3_q;
  logic equal_481_s3_q;
  logic [5:0] column_s3_q;
  logic and_499_s3_q;
  logic and_501_s3_q;
  logic so_s3_q;
  logic equal_562_s3_q;
  logic equal_1470_s3_q;
  logic not_1471_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1505_s3_q;
  logic [5:0] select_1509_s3_q;
  logic and_1514_s3_q;
  logic and_1583_s3_q;
  logic and_1596_s3_q;
  logic less_1610_s3_q;
  logic [7:0] change_s3_q;
  logic equal_1683_s3_q;
  logic equal_1685_s3_q;
  logic equal_1688_s3_q;
  logic or_1689_s3_q;
  logic [4:0] select_1713_s3_q;
  logic select_1719_s3_q;
  logic [3:0] select_1760_s3_q;
  logic less_1776_s3_q;
  logic new_row_s3_q;
  logic or_1789_s3_q;
  logic [1:0] of_row_2_s3_q;
  logic less_1806_s3_q;
  logic less_1807_s3_q;
  logic less_1816_s3_q;
  logic less_1817_s3_q;
  logic and_1831_s3_q;
  logic and_1840_s3_q;
  logic and_1845_s3_q;
  logic less_1846_s3_q;
  logic equal_1847_s3_q;
  logic not_1848_s3_q;
  logic equal_1849_s3_q;
  logic not_1850_s3_q;
  logic and_1864_s3_q;
  logic select_1866_s3_q;
  logic and_1869_s3_q;
  logic sum_1885_s3_q;
  logic textured_s3_q;
  logic and_2018_s3_q;
  logic equal_2164_s3_q;
  logic equal_2288_s3_q;
  logic less_2525_s3_q;
  logic less_2882_s3_q;
  logic equal_3225_s3_q;
  logic equal_3309_s3_q;
  logic less_3592_s3_q;
  logic equal_3797_s3_q;
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
      select_465_s3_q <= select_465_s2_q;
      select_467_s3_q <= select_467_s2_q;
      select_471_s3_q <= select_471_s2_q;
      and_475_s3_q <= and_475_s2_q;
      and_476_s3_q <= and_476;
      equal_481_s3_q <= equal_481_s2_q;
      column_s3_q <= column_s2_q;
      and_499_s3_q <= and_499_s2_q;
      and_501_s3_q <= and_501_s2_q;
      so_s3_q <= so_s2_q;
      equal_562_s3_q <= equal_562_s2_q;
      equal_1470_s3_q <= equal_1470_s2_q;
      not_1471_s3_q <= not_1471;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1505_s3_q <= and_1505;
      select_1509_s3_q <= select_1509_s2_q;
      and_1514_s3_q <= not_1471 & (so_s2_q ? and_1503 : (equal_521_s2_q & shift_2[4]));
      and_1583_s3_q <= and_1583_s2_q;
      and_1596_s3_q <= and_1596_s2_q;
      less_1610_s3_q <= less_1610_s2_q;
      change_s3_q <= change;
      equal_1683_s3_q <= equal_1683_s2_q;
      equal_1685_s3_q <= equal_1685_s2_q;
      equal_1688_s3_q <= equal_1688_s2_q;
      or_1689_s3_q <= or_1689_s2_q;
      select_1713_s3_q <= select_1713_s2_q;
      select_1719_s3_q <= select_1719_s2_q;
      select_1760_s3_q <= select_1760_s2_q;
      less_1776_s3_q <= less_1776;
      new_row_s3_q <= new_row;
      or_1789_s3_q <= or_1789;
      of_row_2_s3_q <= of_row_2;
      less_1806_s3_q <= $signed(15'h100) < $signed(sum_1805);
      less_1807_s3_q <= $signed(sum_1805[14:8]) < $signed(7'h7f);
      less_1816_s3_q <= $signed(15'h100) < $signed(difference_1815);
      less_1817_s3_q <= $signed(difference_1815[14:8]) < $signed(7'h7f);
      and_1831_s3_q <= not_1684_s2_q & and_1830;
      and_1840_s3_q <= and_1840;
      and_1845_s3_q <= not_1684_s2_q & and_1844;
      less_1846_s3_q <= less_1846;
      equal_1847_s3_q <= equal_1847;
      not_1848_s3_q <= not_1848;
      equal_1849_s3_q <= equal_1849;
      not_1850_s3_q <= not_1850;
      and_1864_s3_q <= and_1864_s2_q;
      select_1866_s3_q <= select_1866_s2_q;
      and_1869_s3_q <= and_1869_s2_q;
      sum_1885_s3_q <= sum_1885[5];
      textured_s3_q <= textured;
      and_2018_s3_q <= and_2018_s2_q;
      equal_2164_s3_q <= equal_2164_s2_q;
      equal_2288_s3_q <= equal_2288_s2_q;
      less_2525_s3_q <= select_2492 < select_2494;
      less_2882_s3_q <= 4'he < patches_column_s2_q[4:1];
      equal_3225_s3_q <= patches_match_row_q == 4'h0;
      equal_3309_s3_q <= patches_step_q[6:5] == 2'h2;
      less_3592_s3_q <= less_3592_s2_q;
      equal_3797_s3_q <= equal_3797_s2_q;
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
  logic [11:0] select_479;
  assign select_479 = select_465_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_483;
  assign sum_483 = select_479 + (equal_481_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_485;
  assign sum_485 = {4'h0, sample_pair_pixel_1_q} + (select_465_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_487;
  assign sum_487 = sum_485 + (equal_481_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = select_465_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_491;
  assign and_491 = whole & (averager_memory_rdata_q[24] | equal_481_s3_q);
  // hls/stages/agreement.hpp:404
  logic all_of_skin;
  assign all_of_skin = select_465_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_495;
  assign and_495 = all_of_skin & (averager_memory_rdata_q[25] | equal_481_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_475_s3_q ? sum_483[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_504;
  assign equal_504 = select_465_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_504 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_507;
  assign select_507 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_475_s3_q ? sum_487[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_504 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_511;
  assign select_511 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_512;
  assign and_512 = and_475_s3_q & and_491;
  // hls/stages/census.hpp:126
  logic select_514;
  assign select_514 = equal_504 ? and_512 : (averager_mask_q & and_512);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_514;
  // hls/stages/census.hpp:206
  logic and_516;
  assign and_516 = and_475_s3_q & and_495;
  // hls/stages/census.hpp:126
  logic select_518;
  assign select_518 = equal_504 ? and_516 : (averager_of_skin_q & and_516);
  // hls/stages/agreement.hpp:263
  logic and_519;
  assign and_519 = sample_pair_whole_s3_q & select_518;
  // hls/stages/census.hpp:294
  logic less_535;
  assign less_535 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_536;
  assign less_536 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_537;
  assign less_537 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_538;
  assign less_538 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_539;
  assign less_539 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_540;
  assign less_540 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_541;
  assign less_541 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_542;
  assign less_542 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_543;
  assign less_543 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_544;
  assign less_544 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_545;
  assign less_545 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_546;
  assign less_546 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_547;
  assign less_547 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_548;
  assign less_548 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_549;
  assign less_549 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_550;
  assign less_550 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_551;
  assign less_551 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_552;
  assign less_552 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_553;
  assign less_553 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_554;
  assign less_554 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_555;
  assign less_555 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_556;
  assign less_556 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_557;
  assign less_557 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_558;
  assign less_558 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:442
  logic equal_559;
  assign equal_559 = column_s3_q == 6'h0;
  logic [3:0] select_563;
  assign select_563 = equal_562_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_564;
  assign select_564 = equal_559 ? {select_563, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_565;
  assign select_565 = equal_559 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_566;
  assign and_566 = select_564[4] & select_565[3];
  // hls/stages/census.hpp:286
  logic and_568;
  assign and_568 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_570;
  assign and_570 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_568);
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_570;
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
  logic [9:0] difference_593;
  assign difference_593 = {1'b0, select_507} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_594;
  assign xor_594 = difference_593[8:0] ^ {9{difference_593[9]}};
  logic [9:0] sum_595;
  assign sum_595 = {9'h0, difference_593[9]} + {1'b0, xor_594};
  logic [9:0] difference_596;
  assign difference_596 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_597;
  assign xor_597 = difference_596[8:0] ^ {9{difference_596[9]}};
  logic [9:0] sum_598;
  assign sum_598 = {9'h0, difference_596[9]} + {1'b0, xor_597};
  logic [9:0] difference_600;
  assign difference_600 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_601;
  assign xor_601 = difference_600[8:0] ^ {9{difference_600[9]}};
  logic [9:0] sum_602;
  assign sum_602 = {9'h0, difference_600[9]} + {1'b0, xor_601};
  logic [10:0] sum_603;
  assign sum_603 = ({1'b0, sum_595} + {1'b0, sum_598}) + {1'b0, sum_602};
  logic [9:0] difference_604;
  assign difference_604 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_605;
  assign xor_605 = difference_604[8:0] ^ {9{difference_604[9]}};
  logic [9:0] sum_606;
  assign sum_606 = {9'h0, difference_604[9]} + {1'b0, xor_605};
  logic [9:0] difference_608;
  assign difference_608 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_609;
  assign xor_609 = difference_608[8:0] ^ {9{difference_608[9]}};
  // hls/stages/agreement.hpp:193
  logic not_1510;
  assign not_1510 = ~so_s3_q;
  // hls/stages/patches.hpp:321
  logic and_1511;
  assign and_1511 = not_1510 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1070
  logic equal_1515;
  assign equal_1515 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1518;
  assign select_1518 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1084
  logic [3:0] select_1520;
  assign select_1520 = equal_1515 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1518});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1521;
  assign sum_1521 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:321
  logic [3:0] select_1522;
  assign select_1522 = equal_1470_s3_q ? select_1520 : {sum_1521, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:192
  logic equal_1523;
  assign equal_1523 = x_s3_q[5:0] == 6'h3f;
  logic equal_1525;
  assign equal_1525 = x_s3_q[5:0] == 6'h3e;
  logic equal_1527;
  assign equal_1527 = x_s3_q[5:0] == 6'h3d;
  logic equal_1529;
  assign equal_1529 = x_s3_q[5:0] == 6'h3c;
  logic equal_1531;
  assign equal_1531 = x_s3_q[5:0] == 6'h3b;
  logic equal_1533;
  assign equal_1533 = x_s3_q[5:0] == 6'h36;
  logic equal_1535;
  assign equal_1535 = x_s3_q[5:0] == 6'h35;
  logic equal_1537;
  assign equal_1537 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1116
  logic and_1541;
  assign and_1541 = (~equal_1531) & ((~equal_1533) & ((~equal_1535) & (~equal_1537)));
  logic and_1545;
  assign and_1545 = (~equal_1523) & ((~equal_1525) & ((~equal_1527) & ((~equal_1529) & and_1541)));
  // hls/stages/agreement.hpp:1071
  logic less_1546;
  assign less_1546 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1550;
  assign or_1550 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:955
  logic [4:0] sum_1555;
  assign sum_1555 = {1'b0, last_s3_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2_s3_q[0] & ({2'h0, sum_1555, last_s3_q[1]} < x_s3_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1561;
  assign sum_1561 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1563;
  assign and_1563 = half_ends & ({{3{sum_1561[4]}}, sum_1561} < 8'h3);
  // hls/stages/patches.hpp:321
  logic and_1564;
  assign and_1564 = so_s3_q & and_1563;
  logic select_1565;
  assign select_1565 = equal_1470_s3_q ? (x_s3_q[6] & (equal_1515 ? and_1545 : (less_1546 & (~or_1550)))) : and_1564;
  // hls/stages/registration.hpp:258
  logic not_1567;
  assign not_1567 = ~lower_half_s3_q;
  logic [3:0] select_1568;
  assign select_1568 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1567, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1567};
  // hls/stages/patches.hpp:354
  logic [1:0] select_1597;
  assign select_1597 = and_1596_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1598;
  assign select_1598 = and_1596_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_1599;
  assign select_1599 = and_1583_s3_q ? {select_1598, select_1597[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:109
  logic [1:0] select_1600;
  assign select_1600 = and_1583_s3_q ? select_1597 : patches_fetch_q;
  logic equal_1601;
  assign equal_1601 = select_1600 == 2'h0;
  // hls/stages/patches.hpp:86
  logic right_3;
  assign right_3 = {3'h0, last_s3_q[5:1]} < x_s3_q;
  // hls/stages/patches.hpp:321
  logic and_1609;
  assign and_1609 = not_1471_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1611;
  assign equal_1611 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1611 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1617;
  assign select_1617 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_1618;
  assign select_1618 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_1619;
  assign sum_1619 = {{2{select_1617[6]}}, select_1617} + {select_1618[7], select_1618};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1620;
  assign select_1620 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_1621;
  assign select_1621 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_1622;
  assign sum_1622 = {{2{select_1620[7]}}, select_1620[7:1]} + {select_1621[7], select_1621};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1623;
  assign sum_1623 = {{3{sum_1619[8]}}, sum_1619[8:1]} + {sum_1622[8], sum_1622, select_1620[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1624;
  assign select_1624 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_1625;
  assign select_1625 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_1626;
  assign difference_1626 = {{2{select_1624[7]}}, select_1624[7:1]} - {select_1625[7], select_1625};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1627;
  assign sum_1627 = {difference_1626, select_1624[0]} + {sum_1623[10], sum_1623[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1611 ? {sum_1627, sum_1623[1]} : registration_expected_q;
  // hls/stages/patches.hpp:81
  logic [9:0] sum_1629;
  assign sum_1629 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:964
  logic and_1631;
  assign and_1631 = shift_2_s3_q[3] & ({{4{sum_1629[9]}}, sum_1629, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:87
  logic and_1636;
  assign and_1636 = ({4'h0, last_s3_q[5:1]} < ({1'b0, x_s3_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:89
  logic equal_1637;
  assign equal_1637 = x_s3_q == 8'h0;
  // hls/stages/patches.hpp:85
  logic [9:0] sum_1643;
  assign sum_1643 = {2'h0, x_s3_q} + {{4{shift_2_s3_q[10]}}, shift_2_s3_q[10:5]};
  // hls/stages/patches.hpp:89
  logic [9:0] sum_1645;
  assign sum_1645 = {sum_1643[9], sum_1643[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:964
  logic and_1648;
  assign and_1648 = ($signed(9'h0) < $signed(sum_1643[9:1])) & (~($signed({5'h0, last_s3_q}) < $signed({sum_1645, sum_1643[0]})));
  logic and_1649;
  assign and_1649 = (~(and_1636 | (equal_1637 | (~(x_s3_q < {2'h0, last_s3_q}))))) & and_1648;
  // hls/stages/patches.hpp:321
  logic and_1652;
  assign and_1652 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_1610_s3_q & and_1631) & and_1649));
  logic and_1654;
  assign and_1654 = not_1471_s3_q & (so_s3_q & and_1652);
  // hls/stages/patches.hpp:139
  logic and_1656;
  assign and_1656 = and_1654 & (~patches_fixed_q);
  // hls/stages/patches.hpp:321
  logic [6:0] select_1659;
  assign select_1659 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  logic [6:0] select_1660;
  assign select_1660 = equal_1470_s3_q ? 7'h0 : select_1659;
  logic [5:0] select_1662;
  assign select_1662 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_1664;
  assign select_1664 = equal_1470_s3_q ? 6'h0 : (so_s3_q ? select_1662 : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1665;
  assign sum_1665 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_1627[9]}}, sum_1627[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1668;
  assign select_1668 = ($signed(sum_1665[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1665[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1611 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1665[12:7])) ? 8'h7f : select_1668);
  // hls/stages/patches.hpp:321
  logic [7:0] select_1673;
  assign select_1673 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_1674;
  assign select_1674 = equal_1470_s3_q ? 8'h0 : select_1673;
  // hls/stages/patches.hpp:324
  logic [21:0] select_1675;
  assign select_1675 = and_1656 ? {select_1674, select_1664, select_1660, and_1654} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:96
  logic equal_1676;
  assign equal_1676 = x_s3_q == {2'h0, last_s3_q};
  // hls/stages/patches.hpp:321
  logic and_1680;
  assign and_1680 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (and_1636 | equal_1676)));
  logic and_1681;
  assign and_1681 = not_1471_s3_q & and_1680;
  // hls/stages/patches.hpp:325
  logic and_1682;
  assign and_1682 = patches_chooses_s3_q & and_1681;
  // hls/stages/patches.hpp:109
  logic [4:0] select_1696;
  assign select_1696 = and_1583_s3_q ? select_1598 : patches_band_q;
  // hls/stages/patches.hpp:334
  logic equal_1697;
  assign equal_1697 = {patches_choosing_band_s3_q, and_1609} == {select_1696, select_1600[1]};
  // hls/stages/patches.hpp:463
  logic [2:0] sum_1797;
  assign sum_1797 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:467
  logic [1:0] sum_1835;
  assign sum_1835 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1872;
  assign select_1872 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_1875;
  assign or_1875 = select_1872[7] | (~({select_1872[5], select_1872[3], select_1872[1]} == 3'h0));
  // hls/stages/agreement.hpp:991
  logic or_1878;
  assign or_1878 = select_1872[7] | (~({select_1872[6], select_1872[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:990
  logic or_1881;
  assign or_1881 = select_1872[7] | (~(select_1872[6:4] == 3'h0));
  // hls/stages/patches.hpp:321
  logic [5:0] select_1882;
  assign select_1882 = equal_1470_s3_q ? x_s3_q[5:0] : {region_row_q, or_1881, or_1878, or_1875};
  // hls/stages/agreement.hpp:1070
  logic not_1883;
  assign not_1883 = ~equal_1515;
  // hls/stages/agreement.hpp:1000
  logic or_1887;
  assign or_1887 = (~sum_1885_s3_q) | equal_1676;
  // hls/stages/patches.hpp:321
  logic and_1890;
  assign and_1890 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_1887));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_1911;
  assign and_1911 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:960
  logic select_1912;
  assign select_1912 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_1912);
  // hls/stages/agreement.hpp:960
  logic select_1915;
  assign select_1915 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_1912 ? select_1915 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1198
  logic select_1918;
  assign select_1918 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1202
  logic select_1919;
  assign select_1919 = left_first_s3_q ? select_1918 : read_half_q;
  logic or_1920;
  assign or_1920 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1203
  logic [8:0] select_1921;
  assign select_1921 = or_1920 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1204
  logic [9:0] select_1923;
  assign select_1923 = left_first_s3_q ? 10'h1 : (or_1920 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1207
  logic and_1924;
  assign and_1924 = select_1921[8] & select_1923[9];
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = and_1924 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1218
  logic [5:0] select_1927;
  assign select_1927 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1929;
  assign select_1929 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_1927});
  // hls/stages/agreement.hpp:1228
  logic equal_1930;
  assign equal_1930 = seen_x_q == 3'h7;
  logic [7:0] select_1932;
  assign select_1932 = and_1924 ? 8'h0 : (seen_column_q + {7'h0, equal_1930});
  // hls/stages/agreement.hpp:1235
  logic [10:0] index;
  assign index = select_1929 + {3'h0, select_1932};
  // hls/stages/agreement.hpp:1188
  logic [11:0] sum_1934;
  assign sum_1934 = {1'b0, {2{select_1919}}, 2'h0, {2{select_1919}}, 1'b0, {2{select_1919}}, 1'b0, select_1919} + {1'b0, index};
  // hls/stages/agreement.hpp:1201
  logic not_1935;
  assign not_1935 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:422
  logic and_1937;
  assign and_1937 = not_1935 & (began_q | and_1924);
  // hls/stages/agreement.hpp:1229
  logic [2:0] select_1939;
  assign select_1939 = and_1924 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1234
  logic and_1941;
  assign and_1941 = and_1937 & (select_1939 == 3'h0);
  logic less_1942;
  assign less_1942 = select_1932 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:424
  logic and_1943;
  assign and_1943 = and_1941 & less_1942;
  logic and_1944;
  assign and_1944 = and_1864_s3_q & and_1943;
  // hls/stages/agreement.hpp:265
  logic select_1946;
  assign select_1946 = and_1864_s3_q ? (left_first_s3_q ? and_1943 : and_1944) : and_1944;
  // hls/stages/agreement.hpp:1053
  logic [7:0] sum_1948;
  assign sum_1948 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1948[7], sum_1948, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1188
  logic [11:0] sum_1950;
  assign sum_1950 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:976
  logic and_1951;
  assign and_1951 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_1952;
  assign and_1952 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_1953;
  assign and_1953 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_1954;
  assign and_1954 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_1956;
  assign sum_1956 = {1'b0, and_1953} + ({1'b0, textured_s3_q} + {1'b0, and_1954});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1951} + ({2'h0, and_1952} + {1'b0, sum_1956});
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_1959;
  assign select_1959 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1960;
  assign difference_1960 = {1'b0, textured_2} - {1'b0, select_1959};
  logic [4:0] t;
  assign t = {difference_1960[3], difference_1960} + (equal_1637 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_1965;
  assign select_1965 = shift_2_s3_q[0] ? (sum_1885_s3_q ? select_1872 : {select_1872[6:0], 1'b0}) : select_1872;
  // hls/stages/agreement.hpp:992
  logic or_1968;
  assign or_1968 = select_1965[7] | (~({select_1965[5], select_1965[3], select_1965[1]} == 3'h0));
  // hls/stages/agreement.hpp:976
  logic and_1985;
  assign and_1985 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_1986;
  assign and_1986 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_1987;
  assign and_1987 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_1988;
  assign and_1988 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_1990;
  assign sum_1990 = {1'b0, and_1987} + ({1'b0, shown} + {1'b0, and_1988});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1985} + ({2'h0, and_1986} + {1'b0, sum_1990});
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_1993;
  assign select_1993 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_1994;
  assign difference_1994 = {1'b0, shown_2} - {1'b0, select_1993};
  logic [4:0] around;
  assign around = {difference_1994[3], difference_1994} + (equal_1637 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_1997;
  assign sum_1997 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:976
  logic and_2001;
  assign and_2001 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2002;
  assign and_2002 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2003;
  assign and_2003 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2004;
  assign and_2004 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_2006;
  assign sum_2006 = {1'b0, and_2003} + ({1'b0, near} + {1'b0, and_2004});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2001} + ({2'h0, and_2002} + {1'b0, sum_2006});
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_2009;
  assign select_2009 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2010;
  assign difference_2010 = {1'b0, near_2} - {1'b0, select_2009};
  logic [4:0] n;
  assign n = {difference_2010[3], difference_2010} + (equal_1637 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/patches.hpp:321
  logic and_2022;
  assign and_2022 = ends_cell_s3_q & (and_2018_s3_q & (~({1'b0, sum_1555, last_s3_q[1:0]} < x_s3_q)));
  logic and_2024;
  assign and_2024 = not_1471_s3_q & (so_s3_q & and_2022);
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2056;
  assign select_2056 = sample_pair_whole_s3_q ? (and_499_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2058;
  assign select_2058 = sample_pair_whole_s3_q ? (and_499_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2077;
  assign select_2077 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2079;
  assign select_2079 = sample_pair_whole_s3_q ? (and_499_s3_q ? select_514 : averager_mask_q) : averager_mask_q;
  logic select_2081;
  assign select_2081 = sample_pair_whole_s3_q ? (and_499_s3_q ? select_518 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2082;
  assign select_2082 = and_501_s3_q ? select_507 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2083;
  assign select_2083 = and_501_s3_q ? select_511 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2085;
  assign select_2085 = and_501_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2086;
  assign select_2086 = and_501_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2087;
  assign select_2087 = and_501_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2088;
  assign select_2088 = and_501_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2089;
  assign select_2089 = and_501_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2090;
  assign select_2090 = and_501_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2091;
  assign select_2091 = and_501_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2092;
  assign select_2092 = and_501_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2093;
  assign select_2093 = and_501_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2094;
  assign select_2094 = and_501_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2095;
  assign select_2095 = and_501_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2096;
  assign select_2096 = and_501_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2097;
  assign select_2097 = and_501_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2098;
  assign select_2098 = and_501_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2099;
  assign select_2099 = and_501_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2100;
  assign select_2100 = and_501_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2101;
  assign select_2101 = and_501_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2102;
  assign select_2102 = and_501_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2103;
  assign select_2103 = and_501_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2104;
  assign select_2104 = and_501_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2105;
  assign select_2105 = and_501_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2106;
  assign select_2106 = and_501_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2107;
  assign select_2107 = and_501_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2108;
  assign select_2108 = and_501_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2109;
  assign select_2109 = and_501_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2110;
  assign select_2110 = and_501_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2111;
  assign select_2111 = and_501_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2112;
  assign select_2112 = and_501_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2113;
  assign select_2113 = and_501_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2114;
  assign select_2114 = and_501_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2115;
  assign select_2115 = and_501_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2116;
  assign select_2116 = and_501_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2117;
  assign select_2117 = and_501_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2118;
  assign select_2118 = and_501_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2119;
  assign select_2119 = and_501_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2120;
  assign select_2120 = and_501_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2121;
  assign select_2121 = and_501_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2122;
  assign select_2122 = and_501_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2123;
  assign select_2123 = and_501_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2124;
  assign select_2124 = and_501_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2125;
  assign select_2125 = and_501_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2126;
  assign select_2126 = and_501_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2127;
  assign select_2127 = and_501_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2128;
  assign select_2128 = and_501_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2129;
  assign select_2129 = and_501_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2130;
  assign select_2130 = and_501_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2131;
  assign select_2131 = and_501_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2132;
  assign select_2132 = and_501_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2133;
  assign select_2133 = and_501_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2134;
  assign select_2134 = and_501_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2135;
  assign select_2135 = and_501_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2136;
  assign select_2136 = and_501_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2137;
  assign select_2137 = and_501_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2139;
  assign difference_2139 = {1'b0, select_511} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2140;
  assign xor_2140 = difference_2139[8:0] ^ {9{difference_2139[9]}};
  logic [9:0] sum_2141;
  assign sum_2141 = {9'h0, difference_2139[9]} + {1'b0, xor_2140};
  logic [9:0] difference_2142;
  assign difference_2142 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2143;
  assign xor_2143 = difference_2142[8:0] ^ {9{difference_2142[9]}};
  logic [9:0] sum_2144;
  assign sum_2144 = {9'h0, difference_2142[9]} + {1'b0, xor_2143};
  logic [9:0] difference_2146;
  assign difference_2146 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2147;
  assign xor_2147 = difference_2146[8:0] ^ {9{difference_2146[9]}};
  logic [9:0] sum_2148;
  assign sum_2148 = {9'h0, difference_2146[9]} + {1'b0, xor_2147};
  logic [10:0] sum_2149;
  assign sum_2149 = ({1'b0, sum_2141} + {1'b0, sum_2144}) + {1'b0, sum_2148};
  logic [9:0] difference_2150;
  assign difference_2150 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2151;
  assign xor_2151 = difference_2150[8:0] ^ {9{difference_2150[9]}};
  logic [9:0] sum_2152;
  assign sum_2152 = {9'h0, difference_2150[9]} + {1'b0, xor_2151};
  logic [9:0] difference_2154;
  assign difference_2154 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2155;
  assign xor_2155 = difference_2154[8:0] ^ {9{difference_2154[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2185;
  assign difference_2185 = {1'b0, select_507} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2185[9]} + (difference_2185[8:0] ^ {9{difference_2185[9]}});
  logic [9:0] difference_2197;
  assign difference_2197 = {1'b0, select_511} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2197[9]} + (difference_2197[8:0] ^ {9{difference_2197[9]}});
  // hls/stages/agreement.hpp:507
  logic and_2404;
  assign and_2404 = and_501_s3_q & (equal_562_s3_q & equal_2288_s3_q);
  // hls/stages/patches.hpp:321
  logic and_2408;
  assign and_2408 = not_1471_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:976
  logic and_2428;
  assign and_2428 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2429;
  assign and_2429 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2430;
  assign and_2430 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2431;
  assign and_2431 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2433;
  assign sum_2433 = {1'b0, and_2430} + ({1'b0, explained} + {1'b0, and_2431});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2428} + ({2'h0, and_2429} + {1'b0, sum_2433});
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2436;
  assign select_2436 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2437;
  assign difference_2437 = {1'b0, explained_2} - {1'b0, select_2436};
  logic [4:0] e;
  assign e = {difference_2437[3], difference_2437} + (equal_1637 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2440;
  assign sum_2440 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/patches.hpp:321
  logic and_2469;
  assign and_2469 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2513;
  assign select_2513 = equal_1470_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2515;
  assign select_2515 = equal_1470_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2516;
  assign equal_2516 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:250
  logic and_2520;
  assign and_2520 = shift_2_s3_q[3] & less_1610_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2524;
  assign sum_2524 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2526;
  assign difference_2526 = {sum_2524, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2527;
  assign select_2527 = less_2525_s3_q ? difference_2526 : {sum_2524, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2528;
  assign select_2528 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2524, shift_2_s3_q[11], 5'h0} : select_2527;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2528[7]}}, select_2528} - {sum_1627[9], sum_1627, sum_1623[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2531;
  assign select_2531 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2531[11:7])) ? 12'h7f : select_2531;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2552;
  assign difference_2552 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2554;
  assign and_2554 = and_2520 & ($signed(difference_2552) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2567;
  assign less_2567 = $signed(difference_2552) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:321
  logic select_2575;
  assign select_2575 = so_s3_q ? (equal_2516 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2578;
  assign select_2578 = so_s3_q ? (equal_1611 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2583;
  assign select_2583 = (sum_1521 == 2'h2) ? (registration_fresh_q & (~select_1568)) : registration_fresh_q;
  // hls/stages/patches.hpp:321
  logic [3:0] select_2585;
  assign select_2585 = so_s3_q ? (and_1563 ? select_2583 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2587;
  assign select_2587 = and_2404 ? 4'hf : (equal_1470_s3_q ? registration_fresh_q : select_2585);
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1518;
  // hls/stages/registration.hpp:258
  logic not_2608;
  assign not_2608 = ~quarter_2[1];
  logic [3:0] select_2609;
  assign select_2609 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2608, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2608};
  // hls/stages/patches.hpp:74
  logic parity_2743;
  assign parity_2743 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_2744;
  assign select_2744 = equal_2288_s3_q ? {patches_chance_q[14:0], parity_2743} : patches_chance_q;
  // hls/stages/patches.hpp:326
  logic not_2746;
  assign not_2746 = ~and_1681;
  // hls/stages/patches.hpp:91
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:93
  logic [4:0] select_2748;
  assign select_2748 = right_3 ? last_s3_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2748};
  // hls/stages/patches.hpp:321
  logic and_2754;
  assign and_2754 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (~(x_s3_q < {2'h0, from}))));
  // hls/stages/patches.hpp:139
  logic and_2758;
  assign and_2758 = not_2746 & (patches_fixed_q | ((not_1471_s3_q & and_2754) & and_1656));
  // hls/stages/patches.hpp:335
  logic not_2771;
  assign not_2771 = ~select_1600[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_2773;
  assign select_2773 = sample_pair_whole_s3_q ? (equal_1601 ? select_1600 : {not_2771, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:499
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:167
  logic [51:0] select_2872;
  assign select_2872 = or_1689_s3_q ? {less_1817_s3_q, less_1816_s3_q, less_1807_s3_q, less_1806_s3_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2874;
  assign select_2874 = equal_1683_s3_q ? patches_codes_at_q : (equal_1685_s3_q ? other[55:4] : select_2872);
  // hls/stages/patches.hpp:482
  logic [27:0] word;
  assign word = or_1789_s3_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:498
  logic [27:0] select_2877;
  assign select_2877 = (patches_along_s3_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:167
  logic [27:0] select_2879;
  assign select_2879 = equal_1685_s3_q ? (new_row_s3_q ? word : select_2877) : patches_codes_further_q;
  // hls/stages/patches.hpp:500
  logic [55:0] select_2881;
  assign select_2881 = less_1776_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:470
  logic [55:0] select_2883;
  assign select_2883 = less_2882_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:167
  logic [55:0] select_2885;
  assign select_2885 = or_1689_s3_q ? (equal_1688_s3_q ? patches_next_codes_q : select_2883) : patches_next_codes_q;
  logic [55:0] select_2887;
  assign select_2887 = equal_1683_s3_q ? patches_next_codes_q : (equal_1685_s3_q ? select_2881 : select_2885);
  // hls/stages/count_bits.hpp:24
  logic parity_2892;
  assign parity_2892 = ^{less_1817_s3_q, less_1816_s3_q, less_1807_s3_q, less_1806_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_2896;
  assign or_2896 = ({less_1807_s3_q, less_1806_s3_q} == 2'h3) | (less_1816_s3_q & (less_1807_s3_q | less_1806_s3_q));
  logic and_2897;
  assign and_2897 = less_1817_s3_q & (^{less_1816_s3_q, less_1807_s3_q, less_1806_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2898;
  assign xor_2898 = or_2896 ^ and_2897;
  // hls/stages/count_bits.hpp:27
  logic and_2899;
  assign and_2899 = or_2896 & and_2897;
  // hls/stages/patches.hpp:167
  logic [2:0] select_2901;
  assign select_2901 = or_1689_s3_q ? (and_1840_s3_q ? {and_2899, xor_2898, parity_2892} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:150
  logic [9:0] sum_2905;
  assign sum_2905 = {7'h0, patches_set_q} + (equal_1688_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:499
  logic [47:0] select_2915;
  assign select_2915 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:167
  logic [47:0] select_2917;
  assign select_2917 = equal_1683_s3_q ? patches_left_row_q : (equal_1685_s3_q ? select_2915 : patches_left_row_q);
  // hls/stages/patches.hpp:501
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2915;
  // hls/stages/count_bits.hpp:24
  logic xor_2921;
  assign xor_2921 = bits[17] ^ (^{select_2915[16:15], other[16:15]});
  logic xor_2924;
  assign xor_2924 = bits[11] ^ (^{select_2915[10:9], other[10:9]});
  logic xor_2927;
  assign xor_2927 = bits[14] ^ (^{select_2915[13:12], other[13:12]});
  logic xor_2930;
  assign xor_2930 = xor_2921 ^ (^{select_2915[14:9], other[14:9]});
  logic xor_2933;
  assign xor_2933 = bits[47] ^ (^{select_2915[46:45], other[46:45]});
  logic xor_2936;
  assign xor_2936 = bits[8] ^ (^{select_2915[7:6], other[7:6]});
  logic xor_2939;
  assign xor_2939 = bits[2] ^ (^{select_2915[1:0], other[1:0]});
  logic xor_2942;
  assign xor_2942 = bits[5] ^ (^{select_2915[4:3], other[4:3]});
  logic xor_2945;
  assign xor_2945 = xor_2936 ^ (^{select_2915[5:0], other[5:0]});
  logic parity_2947;
  assign parity_2947 = ^{select_2915[47:45], select_2915[8:0], other[47:45], other[8:0]};
  logic xor_2948;
  assign xor_2948 = xor_2930 ^ parity_2947;
  logic xor_2951;
  assign xor_2951 = bits[44] ^ (^{select_2915[43:42], other[43:42]});
  logic xor_2954;
  assign xor_2954 = bits[38] ^ (^{select_2915[37:36], other[37:36]});
  logic xor_2957;
  assign xor_2957 = bits[41] ^ (^{select_2915[40:39], other[40:39]});
  logic xor_2963;
  assign xor_2963 = bits[26] ^ (^{select_2915[25:24], other[25:24]});
  logic xor_2966;
  assign xor_2966 = bits[20] ^ (^{select_2915[19:18], other[19:18]});
  logic xor_2969;
  assign xor_2969 = bits[23] ^ (^{select_2915[22:21], other[22:21]});
  logic xor_2972;
  assign xor_2972 = xor_2963 ^ (^{select_2915[23:18], other[23:18]});
  logic xor_2975;
  assign xor_2975 = bits[35] ^ (^{select_2915[34:33], other[34:33]});
  logic xor_2978;
  assign xor_2978 = bits[29] ^ (^{select_2915[28:27], other[28:27]});
  logic xor_2981;
  assign xor_2981 = bits[32] ^ (^{select_2915[31:30], other[31:30]});
  logic xor_2984;
  assign xor_2984 = xor_2975 ^ (^{select_2915[32:27], other[32:27]});
  logic xor_2985;
  assign xor_2985 = xor_2972 ^ xor_2984;
  // hls/stages/count_bits.hpp:25
  logic or_2993;
  assign or_2993 = (xor_2924 & xor_2927) | (xor_2921 & (xor_2924 | xor_2927));
  logic or_2997;
  assign or_2997 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3001;
  assign or_3001 = (xor_2939 & xor_2942) | (xor_2936 & (xor_2939 | xor_2942));
  // hls/stages/count_bits.hpp:23
  logic or_3008;
  assign or_3008 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3012;
  assign or_3012 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3016;
  assign or_3016 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3019;
  assign parity_3019 = ^{or_3016, or_3012, or_3008};
  // hls/stages/count_bits.hpp:23
  logic or_3023;
  assign or_3023 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3027;
  assign or_3027 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3031;
  assign or_3031 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3034;
  assign parity_3034 = ^{or_3031, or_3027, or_3023};
  logic parity_3037;
  assign parity_3037 = ^{or_3031, or_3027, or_3023, or_3016, or_3012, or_3008, or_3001, or_2997, or_2993};
  // hls/stages/count_bits.hpp:23
  logic or_3041;
  assign or_3041 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3045;
  assign or_3045 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3049;
  assign or_3049 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3057;
  assign or_3057 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3061;
  assign or_3061 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3065;
  assign or_3065 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3068;
  assign parity_3068 = ^{or_3065, or_3061, or_3057};
  // hls/stages/count_bits.hpp:23
  logic or_3072;
  assign or_3072 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3076;
  assign or_3076 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3080;
  assign or_3080 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3083;
  assign parity_3083 = ^{or_3080, or_3076, or_3072};
  logic parity_3086;
  assign parity_3086 = ^{or_3080, or_3076, or_3072, or_3065, or_3061, or_3057, or_3049, or_3045, or_3041};
  // hls/stages/count_bits.hpp:25
  logic or_3090;
  assign or_3090 = (xor_2954 & xor_2957) | (xor_2951 & (xor_2954 | xor_2957));
  logic or_3094;
  assign or_3094 = (xor_2966 & xor_2969) | (xor_2963 & (xor_2966 | xor_2969));
  logic or_3098;
  assign or_3098 = (xor_2978 & xor_2981) | (xor_2975 & (xor_2978 | xor_2981));
  // hls/stages/count_bits.hpp:24
  logic parity_3101;
  assign parity_3101 = ^{or_3098, or_3094, or_3090};
  // hls/stages/count_bits.hpp:25
  logic and_3102;
  assign and_3102 = xor_2948 & (^{xor_2985, select_2915[44:36], other[44:36]});
  logic or_3106;
  assign or_3106 = (xor_2933 & xor_2945) | (xor_2930 & (xor_2933 | xor_2945));
  logic and_3109;
  assign and_3109 = (xor_2951 ^ (^{select_2915[41:36], other[41:36]})) & (xor_2972 | xor_2984);
  logic or_3110;
  assign or_3110 = (xor_2972 & xor_2984) | and_3109;
  // hls/stages/count_bits.hpp:24
  logic parity_3113;
  assign parity_3113 = ^{or_3110, or_3106, and_3102};
  logic parity_3116;
  assign parity_3116 = ^{or_3110, or_3106, and_3102, or_3098, or_3094, or_3090, or_3080, or_3076, or_3072, or_3065, or_3061, or_3057, or_3049, or_3045, or_3041};
  logic parity_3118;
  assign parity_3118 = ^{or_3110, or_3106, and_3102, or_3098, or_3094, or_3090, or_3080, or_3076, or_3072, or_3065, or_3061, or_3057, or_3049, or_3045, or_3041, or_3031, or_3027, or_3023, or_3016, or_3012, or_3008, or_3001, or_2997, or_2993};
  // hls/stages/count_bits.hpp:25
  logic and_3119;
  assign and_3119 = parity_3037 & parity_3116;
  logic or_3123;
  assign or_3123 = (parity_3019 & parity_3034) | ((^{or_3001, or_2997, or_2993}) & (parity_3019 | parity_3034));
  logic or_3127;
  assign or_3127 = (parity_3101 & parity_3113) | (parity_3086 & (parity_3101 | parity_3113));
  logic or_3134;
  assign or_3134 = (parity_3068 & parity_3083) | ((^{or_3049, or_3045, or_3041}) & (parity_3068 | parity_3083));
  logic or_3138;
  assign or_3138 = (or_3094 & or_3098) | (or_3090 & (or_3094 | or_3098));
  logic or_3142;
  assign or_3142 = (or_3106 & or_3110) | (and_3102 & (or_3106 | or_3110));
  // hls/stages/count_bits.hpp:23
  logic or_3149;
  assign or_3149 = (or_3045 & or_3049) | (or_3041 & (or_3045 | or_3049));
  // hls/stages/count_bits.hpp:25
  logic or_3153;
  assign or_3153 = (or_3061 & or_3065) | (or_3057 & (or_3061 | or_3065));
  logic or_3157;
  assign or_3157 = (or_3076 & or_3080) | (or_3072 & (or_3076 | or_3080));
  // hls/stages/count_bits.hpp:24
  logic parity_3160;
  assign parity_3160 = ^{or_3157, or_3153, or_3149};
  // hls/stages/count_bits.hpp:23
  logic or_3164;
  assign or_3164 = (or_2997 & or_3001) | (or_2993 & (or_2997 | or_3001));
  // hls/stages/count_bits.hpp:25
  logic or_3168;
  assign or_3168 = (or_3012 & or_3016) | (or_3008 & (or_3012 | or_3016));
  logic or_3172;
  assign or_3172 = (or_3027 & or_3031) | (or_3023 & (or_3027 | or_3031));
  // hls/stages/count_bits.hpp:24
  logic parity_3175;
  assign parity_3175 = ^{or_3172, or_3168, or_3164};
  logic parity_3178;
  assign parity_3178 = ^{or_3172, or_3168, or_3164, or_3157, or_3153, or_3149, or_3142, or_3138, or_3134};
  logic parity_3180;
  assign parity_3180 = ^{or_3172, or_3168, or_3164, or_3157, or_3153, or_3149, or_3142, or_3138, or_3134, or_3127, or_3123, and_3119};
  // hls/stages/count_bits.hpp:25
  logic or_3184;
  assign or_3184 = (or_3138 & or_3142) | (or_3134 & (or_3138 | or_3142));
  logic or_3188;
  assign or_3188 = (or_3153 & or_3157) | (or_3149 & (or_3153 | or_3157));
  logic or_3192;
  assign or_3192 = (or_3168 & or_3172) | (or_3164 & (or_3168 | or_3172));
  // hls/stages/count_bits.hpp:24
  logic parity_3195;
  assign parity_3195 = ^{or_3192, or_3188, or_3184};
  // hls/stages/count_bits.hpp:25
  logic and_3196;
  assign and_3196 = (^{or_3127, or_3123, and_3119}) & parity_3178;
  logic or_3200;
  assign or_3200 = (or_3123 & or_3127) | (and_3119 & (or_3123 | or_3127));
  logic or_3204;
  assign or_3204 = (parity_3160 & parity_3175) | ((^{or_3142, or_3138, or_3134}) & (parity_3160 | parity_3175));
  // hls/stages/count_bits.hpp:24
  logic parity_3207;
  assign parity_3207 = ^{or_3204, or_3200, and_3196};
  // hls/stages/count_bits.hpp:25
  logic and_3209;
  assign and_3209 = parity_3195 & parity_3207;
  logic or_3213;
  assign or_3213 = (or_3188 & or_3192) | (or_3184 & (or_3188 | or_3192));
  logic or_3217;
  assign or_3217 = (or_3200 & or_3204) | (and_3196 & (or_3200 | or_3204));
  // hls/stages/patches.hpp:167
  logic [4:0] select_3262;
  assign select_3262 = equal_1685_s3_q ? patches_along_s3_q : patches_summed_row_column_q;
  logic select_3265;
  assign select_3265 = equal_1683_s3_q ? patches_summed_first_q : (equal_1685_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:533
  logic [9:0] select_3272;
  assign select_3272 = less_1846_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3275;
  assign select_3275 = equal_1849_s3_q ? (less_1846_s3_q ? (equal_1849_s3_q ? 10'h0 : select_3272) : 10'h0) : select_3272;
  logic [9:0] select_3277;
  assign select_3277 = less_1846_s3_q ? (equal_1847_s3_q ? 10'h0 : select_3275) : select_3275;
  // hls/stages/patches.hpp:533
  logic [4:0] select_3279;
  assign select_3279 = less_1846_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:537
  logic [4:0] select_3282;
  assign select_3282 = equal_1849_s3_q ? (less_1846_s3_q ? (equal_1849_s3_q ? 5'h0 : select_3279) : 5'h0) : select_3279;
  logic [4:0] select_3284;
  assign select_3284 = less_1846_s3_q ? (equal_1847_s3_q ? 5'h0 : select_3282) : select_3282;
  // hls/stages/patches.hpp:533
  logic [4:0] select_3286;
  assign select_3286 = less_1846_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:537
  logic [4:0] select_3289;
  assign select_3289 = equal_1849_s3_q ? (less_1846_s3_q ? (equal_1849_s3_q ? 5'h0 : select_3286) : 5'h0) : select_3286;
  logic [4:0] select_3291;
  assign select_3291 = less_1846_s3_q ? (equal_1847_s3_q ? 5'h0 : select_3289) : select_3289;
  // hls/stages/patches.hpp:533
  logic and_3294;
  assign and_3294 = less_1846_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:537
  logic select_3297;
  assign select_3297 = equal_1849_s3_q ? (less_1846_s3_q ? (not_1850_s3_q & and_3294) : and_3294) : and_3294;
  // hls/stages/patches.hpp:167
  logic select_3300;
  assign select_3300 = equal_1683_s3_q ? (less_1846_s3_q ? (not_1848_s3_q & select_3297) : select_3297) : patches_read_first_q;
  // hls/stages/patches.hpp:161
  logic or_3311;
  assign or_3311 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3312;
  assign and_3312 = patches_read_searches_s3_q & or_3311;
  // hls/stages/patches.hpp:517
  logic [4:0] select_3313;
  assign select_3313 = and_3312 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:524
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3313};
  // hls/stages/patches.hpp:533
  logic and_3317;
  assign and_3317 = less_1846_s3_q & (equal_3309_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:537
  logic select_3320;
  assign select_3320 = equal_1849_s3_q ? (less_1846_s3_q ? (not_1850_s3_q & and_3317) : and_3317) : and_3317;
  // hls/stages/patches.hpp:167
  logic select_3323;
  assign select_3323 = equal_1683_s3_q ? (less_1846_s3_q ? (not_1848_s3_q & select_3320) : select_3320) : patches_read_above_q;
  // hls/stages/patches.hpp:533
  logic and_3326;
  assign and_3326 = less_1846_s3_q & (equal_3309_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:537
  logic select_3329;
  assign select_3329 = equal_1849_s3_q ? (less_1846_s3_q ? (not_1850_s3_q & and_3326) : and_3326) : and_3326;
  // hls/stages/patches.hpp:167
  logic select_3332;
  assign select_3332 = equal_1683_s3_q ? (less_1846_s3_q ? (not_1848_s3_q & select_3329) : select_3329) : patches_read_below_q;
  // hls/stages/patches.hpp:530
  logic [6:0] sum_3333;
  assign sum_3333 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:531
  logic [9:0] select_3336;
  assign select_3336 = (equal_3309_s3_q & ({sum_3333[6], sum_3333} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:533
  logic [9:0] select_3337;
  assign select_3337 = less_1846_s3_q ? select_3336 : 10'h3ff;
  // hls/stages/patches.hpp:534
  logic [9:0] select_3339;
  assign select_3339 = less_1846_s3_q ? (equal_1849_s3_q ? 10'h3ff : select_3337) : 10'h3ff;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3340;
  assign select_3340 = equal_1849_s3_q ? select_3339 : select_3337;
  logic [9:0] select_3342;
  assign select_3342 = less_1846_s3_q ? (equal_1847_s3_q ? 10'h3ff : select_3340) : select_3340;
  // hls/stages/patches.hpp:516
  logic [14:0] select_3344;
  assign select_3344 = and_3312 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:167
  logic [9:0] select_3345;
  assign select_3345 = equal_1683_s3_q ? select_3344[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3346;
  assign select_3346 = equal_1683_s3_q ? select_3344[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:518
  logic [9:0] select_3348;
  assign select_3348 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:519
  logic [9:0] select_3350;
  assign select_3350 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:520
  logic [9:0] select_3353;
  assign select_3353 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3354;
  assign select_3354 = patches_read_first_q ? patches_read_far_q : select_3353;
  // hls/stages/patches.hpp:571
  logic [9:0] difference_3357;
  assign difference_3357 = select_3354 - select_3344[9:0];
  // hls/stages/patches.hpp:556
  logic less_3387;
  assign less_3387 = select_3348 < select_3350;
  // hls/stages/patches.hpp:562
  logic [1:0] sum_3388;
  assign sum_3388 = select_3313[4:3] + 2'h3;
  // hls/stages/patches.hpp:557
  logic [9:0] high;
  assign high = less_3387 ? select_3350 : select_3348;
  logic [9:0] low;
  assign low = (select_3350 < select_3348) ? select_3350 : select_3348;
  // hls/stages/patches.hpp:558
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3344[9:0];
  // hls/stages/patches.hpp:560
  logic not_3395;
  assign not_3395 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3396;
  assign sum_3396 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3398;
  assign not_3398 = ~({eight, 3'h0} < {1'b0, sum_3396, fall[0]});
  logic [1:0] sum_3399;
  assign sum_3399 = {1'b0, not_3395} + {1'b0, not_3398};
  // hls/stages/patches.hpp:561
  logic [10:0] sum_3400;
  assign sum_3400 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3402;
  assign not_3402 = ~({eight, 3'h0} < {sum_3400, fall[1:0]});
  logic not_3405;
  assign not_3405 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3406;
  assign sum_3406 = {1'b0, not_3402} + {1'b0, not_3405};
  // hls/stages/patches.hpp:560
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3399} + {1'b0, sum_3406};
  // hls/stages/patches.hpp:563
  logic [7:0] select_3409;
  assign select_3409 = less_3387 ? ({sum_3388, select_3313[2:0], 3'h0} - {5'h0, fraction}) : {sum_3388, select_3313[2:0], fraction};
  // hls/stages/agreement.hpp:1086
  logic equal_3568;
  assign equal_3568 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/patches.hpp:321
  logic select_3589;
  assign select_3589 = equal_1470_s3_q ? shown_shown_q : (so_s3_q ? select_1912 : shown_shown_q);
  logic select_3591;
  assign select_3591 = equal_1470_s3_q ? shown_nearer_q : (so_s3_q ? select_1915 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3593;
  assign sum_3593 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3595;
  assign select_3595 = less_3592_s3_q ? (sum_3593[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3597;
  assign select_3597 = equal_2288_s3_q ? (equal_562_s3_q ? 3'h0 : select_3595) : region_row_q;
  // hls/stages/patches.hpp:321
  logic [7:0] select_3602;
  assign select_3602 = equal_1470_s3_q ? select_1872 : (so_s3_q ? (ends_cell_s3_q ? select_1965 : select_1872) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3616;
  assign select_3616 = equal_562_s3_q ? {{2{difference_3614[6]}}, difference_3614} : (less_3592_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_3618;
  assign select_3618 = and_501_s3_q ? (equal_2288_s3_q ? select_3616 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [6:0] select_3620;
  assign select_3620 = equal_562_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_3622;
  assign select_3622 = and_501_s3_q ? (equal_2288_s3_q ? select_3620 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3623;
  assign sum_3623 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3624;
  assign select_3624 = sum_3593[7] ? {1'b1, sum_3593[6:0], region_down_rest_q[0]} : sum_3623;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3593[7];
  // hls/stages/agreement.hpp:447
  logic select_3628;
  assign select_3628 = equal_2288_s3_q ? (equal_562_s3_q | (less_3592_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_3633;
  assign or_3633 = segment_starts_q | not_1510;
  // hls/stages/agreement.hpp:976
  logic select_3636;
  assign select_3636 = shift_2_s3_q[0] ? (sum_1885_s3_q ? (equal_1676 & or_1887) : or_1887) : or_3633;
  // hls/stages/patches.hpp:321
  logic select_3639;
  assign select_3639 = equal_1470_s3_q ? or_3633 : (so_s3_q ? (ends_cell_s3_q ? select_3636 : or_3633) : or_3633);
  logic [2:0] select_3713;
  assign select_3713 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_3715;
  assign select_3715 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3717;
  assign select_3717 = equal_1470_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3715 : box_textured_columns_values_1_q);
  logic [2:0] select_3718;
  assign select_3718 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3720;
  assign select_3720 = equal_1470_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_3718 : box_textured_columns_values_2_q);
  logic [2:0] select_3721;
  assign select_3721 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3723;
  assign select_3723 = equal_1470_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_3721 : box_textured_columns_values_3_q);
  logic [2:0] select_3724;
  assign select_3724 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3726;
  assign select_3726 = equal_1470_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_3724 : box_textured_columns_values_4_q);
  logic [4:0] select_3728;
  assign select_3728 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3731;
  assign select_3731 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3733;
  assign select_3733 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3735;
  assign select_3735 = equal_1470_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_3733 : box_explained_columns_values_1_q);
  logic [2:0] select_3736;
  assign select_3736 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3738;
  assign select_3738 = equal_1470_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_3736 : box_explained_columns_values_2_q);
  logic [2:0] select_3739;
  assign select_3739 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3741;
  assign select_3741 = equal_1470_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_3739 : box_explained_columns_values_3_q);
  logic [2:0] select_3742;
  assign select_3742 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3744;
  assign select_3744 = equal_1470_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_3742 : box_explained_columns_values_4_q);
  logic [4:0] select_3746;
  assign select_3746 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3747;
  assign select_3747 = equal_1470_s3_q ? box_explained_sum_sums_values_0_q : select_3746;
  logic [2:0] select_3749;
  assign select_3749 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3751;
  assign select_3751 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3753;
  assign select_3753 = equal_1470_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_3751 : box_shown_columns_values_1_q);
  logic [2:0] select_3754;
  assign select_3754 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3756;
  assign select_3756 = equal_1470_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_3754 : box_shown_columns_values_2_q);
  logic [2:0] select_3757;
  assign select_3757 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3759;
  assign select_3759 = equal_1470_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_3757 : box_shown_columns_values_3_q);
  logic [2:0] select_3760;
  assign select_3760 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3762;
  assign select_3762 = equal_1470_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_3760 : box_shown_columns_values_4_q);
  logic [4:0] select_3764;
  assign select_3764 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_3767;
  assign select_3767 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3769;
  assign select_3769 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3771;
  assign select_3771 = equal_1470_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_3769 : box_nearer_columns_values_1_q);
  logic [2:0] select_3772;
  assign select_3772 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3774;
  assign select_3774 = equal_1470_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_3772 : box_nearer_columns_values_2_q);
  logic [2:0] select_3775;
  assign select_3775 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3777;
  assign select_3777 = equal_1470_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_3775 : box_nearer_columns_values_3_q);
  logic [2:0] select_3778;
  assign select_3778 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3780;
  assign select_3780 = equal_1470_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_3778 : box_nearer_columns_values_4_q);
  logic [4:0] select_3782;
  assign select_3782 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_3785;
  assign select_3785 = so_s3_q ? (ends_cell_s3_q ? and_1953 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3788;
  assign select_3788 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_3790;
  assign select_3790 = equal_1470_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_3788 : centres_values_0_of_skin_q);
  logic select_3791;
  assign select_3791 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3793;
  assign select_3793 = equal_1470_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_3791 : centres_values_1_textured_q);
  logic select_3794;
  assign select_3794 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3796;
  assign select_3796 = equal_1470_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_3794 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:447
  logic [10:0] select_3800;
  assign select_3800 = equal_2288_s3_q ? (equal_3797_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [5:0] select_3803;
  assign select_3803 = and_501_s3_q ? (equal_2288_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1198
  logic xor_3804;
  assign xor_3804 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:424
  logic select_3806;
  assign select_3806 = and_1864_s3_q ? (left_first_s3_q ? xor_3804 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:265
  logic select_3808;
  assign select_3808 = and_1864_s3_q ? (left_first_s3_q ? xor_3804 : select_3806) : write_half_q;
  logic select_3810;
  assign select_3810 = left_first_s3_q ? select_1918 : (and_1864_s3_q ? select_1919 : read_half_q);
  logic and_3814;
  assign and_3814 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_3823;
  assign select_3823 = left_first_s3_q ? 10'h1 : (and_1864_s3_q ? select_1923 : rows_passed_q);
  logic [8:0] select_3826;
  assign select_3826 = left_first_s3_q ? {select_1921[7:0], or_1920} : (and_1864_s3_q ? {select_1921[7:0], or_1920} : columns_passed_q);
  logic select_3829;
  assign select_3829 = left_first_s3_q ? marks_last_s3_q : (and_1864_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_3832;
  assign select_3832 = left_first_s3_q ? and_1937 : (and_1864_s3_q ? and_1937 : began_q);
  logic [2:0] select_3835;
  assign select_3835 = left_first_s3_q ? select_1939 : (and_1864_s3_q ? select_1939 : seen_x_q);
  // hls/stages/agreement.hpp:1227
  logic [2:0] select_3840;
  assign select_3840 = left_first_s3_q ? 3'h0 : (and_1924 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:265
  logic [2:0] select_3842;
  assign select_3842 = left_first_s3_q ? 3'h0 : (and_1864_s3_q ? select_3840 : seen_y_q);
  logic [7:0] select_3845;
  assign select_3845 = left_first_s3_q ? select_1932 : (and_1864_s3_q ? select_1932 : seen_column_q);
  // hls/stages/agreement.hpp:422
  logic [7:0] select_3851;
  assign select_3851 = left_first_s3_q ? select_3849 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:265
  logic [7:0] select_3853;
  assign select_3853 = left_first_s3_q ? select_3849 : (and_1864_s3_q ? select_3851 : seen_rows_left_q);
  // hls/stages/agreement.hpp:422
  logic and_3858;
  assign and_3858 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:265
  logic select_3860;
  assign select_3860 = left_first_s3_q ? and_3858 : (and_1864_s3_q ? and_3858 : at_cell_end_q);
  logic select_3863;
  assign select_3863 = left_first_s3_q ? next_row : (and_1864_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_3866;
  assign select_3866 = left_first_s3_q ? 11'h0 : (and_1864_s3_q ? select_1929 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_3933;
  assign not_3933 = ~quarter[1];
  logic [3:0] select_3934;
  assign select_3934 = quarter[0] ? {quarter[1], 1'b0, not_3933, 1'b0} : {1'b0, quarter[1], 1'b0, not_3933};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1522;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_1565;
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 22, DISTANCE 12, hls/stages/patches.hpp:728; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [21:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 22'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1599;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_1601));
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
  assign regions_raddr = select_1882;
  logic regions_re;
  assign regions_re = s3_en & (equal_1470_s3_q ? (x_s3_q[6] & not_1883) : and_1890);
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
  assign map_raddr = sum_1934;
  logic map_re;
  assign map_re = s3_en & select_1946;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_471_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_476_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_495, and_491, sum_487, sum_483};
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
  assign census_memory_we = s3_en & and_501_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_519, whole_2, select_511, select_507};
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
  assign shown_right_waddr = select_1509_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1514_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1511, not_1510};
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
  assign patches_right_codes_waddr = {sum_1797, patches_code_row_s3_q[1:0], of_row_2_s3_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_1831_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1817_s3_q, less_1816_s3_q, less_1807_s3_q, less_1806_s3_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1835, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_1845_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1817_s3_q, less_1816_s3_q, less_1807_s3_q, less_1806_s3_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s3_en & and_1505_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1911, textured_s3_q};
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
      averager_running_of_skin_q <= select_2077;
      averager_mask_q <= select_2079;
      averager_of_skin_q <= select_2081;
      census_filled_q <= and_501_s3_q ? {select_565[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_501_s3_q ? select_564 : rows_passed_above_q;
      registration_slope_here_q <= select_2513;
      registration_expected_q <= select_2515;
      registration_of_right_q <= equal_1470_s3_q ? registration_of_right_q : select_2575;
      registration_was_inside_q <= equal_1470_s3_q ? registration_was_inside_q : select_2578;
      registration_fresh_q <= select_2587;
      patches_chance_q <= and_501_s3_q ? select_2744 : patches_chance_q;
      patches_fixed_q <= and_2758;
      patches_choice_valid_q <= and_1681 ? (select_1675[0] & not_2746) : select_1675[0];
      patches_choice_column_q <= select_1675[7:1];
      patches_choice_shift_q <= select_1675[13:8];
      patches_choice_slope_q <= select_1675[21:14];
      patches_band_q <= sample_pair_whole_s3_q ? select_1696 : patches_band_q;
      patches_fetch_q <= select_2773;
      patches_codes_at_q <= select_2874;
      patches_codes_further_q <= equal_1683_s3_q ? patches_codes_further_q : select_2879;
      patches_next_codes_q <= select_2887;
      patches_set_q <= equal_1683_s3_q ? 3'h0 : (equal_1685_s3_q ? 3'h0 : select_2901);
      patches_size_q <= sum_2905;
      patches_left_row_q <= select_2917;
      patches_summed_row_column_q <= equal_1683_s3_q ? patches_summed_row_column_q : select_3262;
      patches_summed_first_q <= select_3265;
      patches_read_row_differing_q <= equal_1683_s3_q ? select_3277 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1683_s3_q ? select_3284 : patches_read_row_column_q;
      patches_read_at_q <= equal_1683_s3_q ? select_3291 : patches_read_at_q;
      patches_read_first_q <= select_3300;
      patches_read_above_q <= select_3323;
      patches_read_below_q <= select_3332;
      patches_read_far_q <= equal_1683_s3_q ? select_3342 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3345;
      patches_peak_best_column_q <= select_3346;
      patches_peak_row_q <= equal_1683_s3_q ? select_3313 : patches_peak_row_q;
      patches_peak_above_q <= equal_1683_s3_q ? select_3348 : patches_peak_above_q;
      patches_peak_below_q <= equal_1683_s3_q ? select_3350 : patches_peak_below_q;
      patches_peak_far_q <= equal_1683_s3_q ? select_3354 : patches_peak_far_q;
      shown_shown_q <= select_3589;
      shown_nearer_q <= select_3591;
      region_row_q <= and_501_s3_q ? select_3597 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3602;
      region_down_rest_q <= select_3618;
      region_down_back_q <= select_3622;
      region_down_next_q <= select_3624;
      region_fresh_q <= and_501_s3_q ? select_3628 : region_fresh_q;
      segment_starts_q <= select_3639;
      centres_values_0_textured_q <= equal_1470_s3_q ? centres_values_0_textured_q : select_3785;
      centres_values_0_of_skin_q <= select_3790;
      centres_values_1_textured_q <= select_3793;
      centres_values_1_of_skin_q <= select_3796;
      map_row_q <= and_501_s3_q ? select_3800 : map_row_q;
      map_width_q <= select_3803;
      write_half_q <= select_3808;
      read_half_q <= and_1864_s3_q ? select_3810 : read_half_q;
      done_q <= and_1864_s3_q ? (not_1935 & and_3814) : and_3814;
      drew_q <= so_s3_q;
      said_q <= equal_1470_s3_q & equal_3568;
      rows_passed_q <= and_1864_s3_q ? select_3823 : rows_passed_q;
      columns_passed_q <= and_1864_s3_q ? select_3826 : columns_passed_q;
      line_ended_q <= and_1864_s3_q ? select_3829 : line_ended_q;
      began_q <= and_1864_s3_q ? select_3832 : began_q;
      seen_x_q <= and_1864_s3_q ? select_3835 : seen_x_q;
      seen_y_q <= and_1864_s3_q ? select_3842 : seen_y_q;
      seen_column_q <= and_1864_s3_q ? select_3845 : seen_column_q;
      seen_rows_left_q <= and_1864_s3_q ? select_3853 : seen_rows_left_q;
      at_cell_end_q <= and_1864_s3_q ? select_3860 : at_cell_end_q;
      was_next_row_q <= and_1864_s3_q ? select_3863 : was_next_row_q;
      seen_base_q <= and_1864_s3_q ? select_3866 : seen_base_q;
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
      left_pixel_q <= and_1864_s3_q ? left_pixel_q : pixel_0_s3_q;
      averager_running_0_q <= sample_pair_whole_s3_q ? select_479 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_485 : averager_running_1_q;
      averager_total_0_q <= select_2056;
      averager_total_1_q <= select_2058;
      census_columns_values_0_cell_0_left_q <= select_2082;
      census_columns_values_0_cell_0_right_q <= select_2083;
      census_columns_values_0_cell_0_mask_q <= and_501_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2085;
      census_columns_values_0_cell_1_right_q <= select_2086;
      census_columns_values_0_cell_1_mask_q <= select_2087;
      census_columns_values_0_cell_2_left_q <= select_2088;
      census_columns_values_0_cell_2_right_q <= select_2089;
      census_columns_values_0_cell_2_mask_q <= select_2090;
      census_columns_values_0_cell_2_of_skin_q <= select_2091;
      census_columns_values_0_cell_3_left_q <= select_2092;
      census_columns_values_0_cell_3_right_q <= select_2093;
      census_columns_values_0_cell_3_mask_q <= select_2094;
      census_columns_values_0_cell_4_left_q <= select_2095;
      census_columns_values_0_cell_4_right_q <= select_2096;
      census_columns_values_0_cell_4_mask_q <= select_2097;
      census_columns_values_1_cell_0_left_q <= select_2098;
      census_columns_values_1_cell_0_right_q <= select_2099;
      census_columns_values_1_cell_0_mask_q <= select_2100;
      census_columns_values_1_cell_1_left_q <= select_2101;
      census_columns_values_1_cell_1_right_q <= select_2102;
      census_columns_values_1_cell_1_mask_q <= select_2103;
      census_columns_values_1_cell_2_left_q <= select_2104;
      census_columns_values_1_cell_2_right_q <= select_2105;
      census_columns_values_1_cell_2_mask_q <= select_2106;
      census_columns_values_1_cell_2_of_skin_q <= select_2107;
      census_columns_values_1_cell_3_left_q <= select_2108;
      census_columns_values_1_cell_3_right_q <= select_2109;
      census_columns_values_1_cell_3_mask_q <= select_2110;
      census_columns_values_1_cell_4_left_q <= select_2111;
      census_columns_values_1_cell_4_right_q <= select_2112;
      census_columns_values_1_cell_4_mask_q <= select_2113;
      census_columns_values_2_cell_0_left_q <= select_2114;
      census_columns_values_2_cell_0_right_q <= select_2115;
      census_columns_values_2_cell_0_mask_q <= select_2116;
      census_columns_values_2_cell_1_left_q <= select_2117;
      census_columns_values_2_cell_1_right_q <= select_2118;
      census_columns_values_2_cell_1_mask_q <= select_2119;
      census_columns_values_2_cell_2_left_q <= select_2120;
      census_columns_values_2_cell_2_right_q <= select_2121;
      census_columns_values_2_cell_2_mask_q <= select_2122;
      census_columns_values_2_cell_3_left_q <= select_2123;
      census_columns_values_2_cell_3_right_q <= select_2124;
      census_columns_values_2_cell_3_mask_q <= select_2125;
      census_columns_values_2_cell_4_left_q <= select_2126;
      census_columns_values_2_cell_4_right_q <= select_2127;
      census_columns_values_2_cell_4_mask_q <= select_2128;
      census_columns_values_3_cell_0_mask_q <= select_2129;
      census_columns_values_3_cell_1_left_q <= select_2130;
      census_columns_values_3_cell_1_right_q <= select_2131;
      census_columns_values_3_cell_1_mask_q <= select_2132;
      census_columns_values_3_cell_2_mask_q <= select_2133;
      census_columns_values_3_cell_3_left_q <= select_2134;
      census_columns_values_3_cell_3_right_q <= select_2135;
      census_columns_values_3_cell_3_mask_q <= select_2136;
      census_columns_values_3_cell_4_mask_q <= select_2137;
      sharpness_last_mean_0_q <= and_501_s3_q ? select_507 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_501_s3_q ? select_511 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1470_s3_q ? box_textured_columns_values_0_q : select_3713;
      box_textured_columns_values_1_q <= select_3717;
      box_textured_columns_values_2_q <= select_3720;
      box_textured_columns_values_3_q <= select_3723;
      box_textured_columns_values_4_q <= select_3726;
      box_textured_sum_sums_values_0_q <= equal_1470_s3_q ? box_textured_sum_sums_values_0_q : select_3728;
      box_explained_columns_values_0_q <= equal_1470_s3_q ? box_explained_columns_values_0_q : select_3731;
      box_explained_columns_values_1_q <= select_3735;
      box_explained_columns_values_2_q <= select_3738;
      box_explained_columns_values_3_q <= select_3741;
      box_explained_columns_values_4_q <= select_3744;
      box_explained_sum_sums_values_0_q <= select_3747;
      box_shown_columns_values_0_q <= equal_1470_s3_q ? box_shown_columns_values_0_q : select_3749;
      box_shown_columns_values_1_q <= select_3753;
      box_shown_columns_values_2_q <= select_3756;
      box_shown_columns_values_3_q <= select_3759;
      box_shown_columns_values_4_q <= select_3762;
      box_shown_sum_sums_values_0_q <= equal_1470_s3_q ? box_shown_sum_sums_values_0_q : select_3764;
      box_nearer_columns_values_0_q <= equal_1470_s3_q ? box_nearer_columns_values_0_q : select_3767;
      box_nearer_columns_values_1_q <= select_3771;
      box_nearer_columns_values_2_q <= select_3774;
      box_nearer_columns_values_3_q <= select_3777;
      box_nearer_columns_values_4_q <= select_3780;
      box_nearer_sum_sums_values_0_q <= equal_1470_s3_q ? box_nearer_sum_sums_values_0_q : select_3782;
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
  logic [2:0] select_465_s4_q;
  logic [5:0] select_467_s4_q;
  logic [5:0] column_s4_q;
  logic and_499_s4_q;
  logic and_501_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_504_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
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
  logic less_558_s4_q;
  logic and_566_s4_q;
  logic and_591_s4_q;
  logic and_592_s4_q;
  logic [11:0] sum_607_s4_q;
  logic [9:0] sum_610_s4_q;
  logic equal_1470_s4_q;
  logic not_1471_s4_q;
  logic equal_1515_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1521_s4_q;
  logic equal_1523_s4_q;
  logic equal_1525_s4_q;
  logic equal_1527_s4_q;
  logic equal_1529_s4_q;
  logic equal_1531_s4_q;
  logic equal_1533_s4_q;
  logic equal_1535_s4_q;
  logic equal_1537_s4_q;
  logic less_1546_s4_q;
  logic or_1550_s4_q;
  logic equal_1570_s4_q;
  logic and_1580_s4_q;
  logic and_1583_s4_q;
  logic select_1600_s4_q;
  logic equal_1601_s4_q;
  logic and_1609_s4_q;
  logic equal_1611_s4_q;
  logic select_1675_s4_q;
  logic and_1682_s4_q;
  logic equal_1683_s4_q;
  logic equal_1685_s4_q;
  logic and_1698_s4_q;
  logic [4:0] select_1713_s4_q;
  logic select_1719_s4_q;
  logic [3:0] select_1760_s4_q;
  logic less_1846_s4_q;
  logic equal_1847_s4_q;
  logic not_1848_s4_q;
  logic equal_1849_s4_q;
  logic and_1864_s4_q;
  logic select_1866_s4_q;
  logic and_1869_s4_q;
  logic or_1875_s4_q;
  logic or_1878_s4_q;
  logic or_1881_s4_q;
  logic not_1883_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1904_s4_q;
  logic and_1909_s4_q;
  logic and_1941_s4_q;
  logic less_1942_s4_q;
  logic [11:0] sum_1950_s4_q;
  logic equal_1963_s4_q;
  logic or_1968_s4_q;
  logic or_1971_s4_q;
  logic or_1974_s4_q;
  logic not_1999_s4_q;
  logic less_2013_s4_q;
  logic and_2024_s4_q;
  logic [11:0] sum_2153_s4_q;
  logic [9:0] sum_2156_s4_q;
  logic equal_2164_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2404_s4_q;
  logic and_2408_s4_q;
  logic not_2442_s4_q;
  logic and_2470_s4_q;
  logic and_2519_s4_q;
  logic and_2520_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2554_s4_q;
  logic and_2568_s4_q;
  logic equal_2611_s4_q;
  logic parity_2989_s4_q;
  logic parity_3118_s4_q;
  logic parity_3180_s4_q;
  logic xor_3208_s4_q;
  logic parity_3220_s4_q;
  logic or_3224_s4_q;
  logic equal_3225_s4_q;
  logic [4:0] select_3344_s4_q;
  logic equal_3356_s4_q;
  logic less_3358_s4_q;
  logic less_3359_s4_q;
  logic or_3364_s4_q;
  logic [7:0] select_3409_s4_q;
  logic equal_3568_s4_q;
  logic and_3869_s4_q;
  logic equal_3936_s4_q;
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
      select_465_s4_q <= select_465_s3_q;
      select_467_s4_q <= select_467_s3_q;
      column_s4_q <= column_s3_q;
      and_499_s4_q <= and_499_s3_q;
      and_501_s4_q <= and_501_s3_q;
      grey_s4_q <= grey;
      equal_504_s4_q <= equal_504;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
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
      less_558_s4_q <= less_558;
      and_566_s4_q <= and_566;
      and_591_s4_q <= whole_22 & and_566;
      and_592_s4_q <= census_columns_values_1_cell_2_mask_q & and_566;
      sum_607_s4_q <= {1'b0, sum_603} + {2'h0, sum_606};
      sum_610_s4_q <= {9'h0, difference_608[9]} + {1'b0, xor_609};
      equal_1470_s4_q <= equal_1470_s3_q;
      not_1471_s4_q <= not_1471_s3_q;
      equal_1515_s4_q <= equal_1515;
      all_s4_q <= all;
      sum_1521_s4_q <= sum_1521;
      equal_1523_s4_q <= equal_1523;
      equal_1525_s4_q <= equal_1525;
      equal_1527_s4_q <= equal_1527;
      equal_1529_s4_q <= equal_1529;
      equal_1531_s4_q <= equal_1531;
      equal_1533_s4_q <= equal_1533;
      equal_1535_s4_q <= equal_1535;
      equal_1537_s4_q <= equal_1537;
      less_1546_s4_q <= less_1546;
      or_1550_s4_q <= or_1550;
      equal_1570_s4_q <= (registration_fresh_q & select_1568) == 4'h0;
      and_1580_s4_q <= not_1471_s3_q & and_1564;
      and_1583_s4_q <= and_1583_s3_q;
      select_1600_s4_q <= select_1600[1];
      equal_1601_s4_q <= equal_1601;
      and_1609_s4_q <= and_1609;
      equal_1611_s4_q <= equal_1611;
      select_1675_s4_q <= select_1675[0];
      and_1682_s4_q <= and_1682;
      equal_1683_s4_q <= equal_1683_s3_q;
      equal_1685_s4_q <= equal_1685_s3_q;
      and_1698_s4_q <= and_1682 & equal_1697;
      select_1713_s4_q <= select_1713_s3_q;
      select_1719_s4_q <= select_1719_s3_q;
      select_1760_s4_q <= select_1760_s3_q;
      less_1846_s4_q <= less_1846_s3_q;
      equal_1847_s4_q <= equal_1847_s3_q;
      not_1848_s4_q <= not_1848_s3_q;
      equal_1849_s4_q <= equal_1849_s3_q;
      and_1864_s4_q <= and_1864_s3_q;
      select_1866_s4_q <= select_1866_s3_q;
      and_1869_s4_q <= and_1869_s3_q;
      or_1875_s4_q <= or_1875;
      or_1878_s4_q <= or_1878;
      or_1881_s4_q <= or_1881;
      not_1883_s4_q <= not_1883;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1904_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_1909_s4_q <= not_1471_s3_q & and_1890;
      and_1941_s4_q <= and_1941;
      less_1942_s4_q <= less_1942;
      sum_1950_s4_q <= sum_1950;
      equal_1963_s4_q <= t[4:1] == 4'h0;
      or_1968_s4_q <= or_1968;
      or_1971_s4_q <= select_1965[7] | (~({select_1965[6], select_1965[3:2]} == 3'h0));
      or_1974_s4_q <= select_1965[7] | (~(select_1965[6:4] == 3'h0));
      not_1999_s4_q <= ~({sum_1997, around[0]} < {2'h0, t});
      less_2013_s4_q <= {1'b0, around[4:1]} < n;
      and_2024_s4_q <= and_2024;
      sum_2153_s4_q <= {1'b0, sum_2149} + {2'h0, sum_2152};
      sum_2156_s4_q <= {9'h0, difference_2154[9]} + {1'b0, xor_2155};
      equal_2164_s4_q <= equal_2164_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2404_s4_q <= and_2404;
      and_2408_s4_q <= and_2408;
      not_2442_s4_q <= ~({sum_2440, e[0]} < {2'h0, t});
      and_2470_s4_q <= not_1471_s3_q & and_2469;
      and_2519_s4_q <= not_1471_s3_q & (so_s3_q & (half_ends & equal_2516));
      and_2520_s4_q <= and_2520;
      residual_s4_q <= residual[7:0];
      and_2554_s4_q <= and_2554;
      and_2568_s4_q <= and_2520 & less_2567;
      equal_2611_s4_q <= (registration_fresh_q & select_2609) == 4'h0;
      parity_2989_s4_q <= ^{xor_2985, xor_2948, select_2915[44:36], other[44:36]};
      parity_3118_s4_q <= parity_3118;
      parity_3180_s4_q <= parity_3180;
      xor_3208_s4_q <= parity_3195 ^ parity_3207;
      parity_3220_s4_q <= ^{or_3217, or_3213, and_3209};
      or_3224_s4_q <= (or_3213 & or_3217) | (and_3209 & (or_3213 | or_3217));
      equal_3225_s4_q <= equal_3225_s3_q;
      select_3344_s4_q <= select_3344[14:10];
      equal_3356_s4_q <= select_3313[3:0] == 4'h0;
      less_3358_s4_q <= {difference_3357, 3'h0} < {3'h0, sum_2905};
      less_3359_s4_q <= select_3354 < select_3344[9:0];
      or_3364_s4_q <= (sum_2905 < 10'h39) | ({1'b0, sum_2905[9:1]} < select_3344[9:0]);
      select_3409_s4_q <= select_3409;
      equal_3568_s4_q <= equal_3568;
      and_3869_s4_q <= and_2024 & (sum_1950 == sum_1934);
      equal_3936_s4_q <= (registration_fresh_q & select_3934) == 4'h0;
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
  logic [2:0] patches_found_q;
  logic [7:0] patches_round_places_q;
  logic [11:0] patches_round_across_q;
  logic [2:0] patches_round_moved_q;
  logic patches_suspected_q;
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
  assign texture = sum_607_s4_q + {2'h0, sum_610_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_612;
  assign sum_612 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_614;
  assign sum_614 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_612});
  // hls/stages/census.hpp:303
  logic less_615;
  assign less_615 = 9'h4 < sum_614[13:5];
  logic and_616;
  assign and_616 = and_566_s4_q & less_615;
  // hls/stages/registration.hpp:265
  logic equal_1572;
  assign equal_1572 = sum_1521_s4_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1521_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1574;
  assign select_1574 = equal_1572 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1575;
  assign sum_1575 = (equal_1570_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1574[13]}}, select_1574};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1521_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1578;
  assign select_1578 = equal_1572 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1579;
  assign sum_1579 = (equal_1570_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1578[6]}}, select_1578};
  // hls/stages/patches.hpp:334
  logic [21:0] select_1699;
  assign select_1699 = and_1698_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1675_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:110
  logic select_1701;
  assign select_1701 = equal_1601_s4_q ? patches_place_0_valid_q : (select_1600_s4_q ? patches_place_0_valid_q : select_1699[0]);
  // hls/stages/patches.hpp:335
  logic [20:0] select_1702;
  assign select_1702 = select_1600_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1699[21:1];
  // hls/stages/patches.hpp:110
  logic [6:0] select_1703;
  assign select_1703 = equal_1601_s4_q ? patches_place_0_column_q : select_1702[6:0];
  logic [5:0] select_1704;
  assign select_1704 = equal_1601_s4_q ? patches_place_0_shift_q : select_1702[12:7];
  // hls/stages/patches.hpp:305
  logic [6:0] sum_1705;
  assign sum_1705 = select_1703 + {select_1704[5], select_1704};
  // hls/stages/patches.hpp:306
  logic [5:0] sum_1706;
  assign sum_1706 = sum_1705[6:1] + 6'h3f;
  // hls/stages/patches.hpp:114
  logic equal_1707;
  assign equal_1707 = {sum_1706[5], select_467_s4_q, select_465_s4_q} == {1'b0, sum_1706[4:0], sum_1705[0], 3'h4};
  // hls/stages/patches.hpp:116
  logic or_1709;
  assign or_1709 = and_1583_s4_q | (select_1701 & equal_1707);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_1710;
  assign select_1710 = or_1709 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:116
  logic [5:0] select_1720;
  assign select_1720 = or_1709 ? {and_1583_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:120
  logic and_1722;
  assign and_1722 = select_1719_s4_q & (~select_1720[5]);
  // hls/stages/patches.hpp:110
  logic select_1730;
  assign select_1730 = equal_1601_s4_q ? patches_place_1_valid_q : (select_1600_s4_q ? select_1699[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:335
  logic [20:0] select_1731;
  assign select_1731 = select_1600_s4_q ? select_1699[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:110
  logic [6:0] select_1732;
  assign select_1732 = equal_1601_s4_q ? patches_place_1_column_q : select_1731[6:0];
  logic [5:0] select_1733;
  assign select_1733 = equal_1601_s4_q ? patches_place_1_shift_q : select_1731[12:7];
  // hls/stages/patches.hpp:305
  logic [6:0] sum_1734;
  assign sum_1734 = select_1732 + {select_1733[5], select_1733};
  // hls/stages/patches.hpp:306
  logic [5:0] sum_1735;
  assign sum_1735 = sum_1734[6:1] + 6'h3f;
  // hls/stages/patches.hpp:114
  logic equal_1736;
  assign equal_1736 = {sum_1735[5], select_467_s4_q, select_465_s4_q} == {1'b0, sum_1735[4:0], sum_1734[0], 3'h4};
  // hls/stages/patches.hpp:116
  logic or_1738;
  assign or_1738 = and_1583_s4_q | (select_1730 & equal_1736);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_1739;
  assign select_1739 = or_1738 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:116
  logic [5:0] select_1740;
  assign select_1740 = or_1738 ? {and_1583_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:120
  logic and_1742;
  assign and_1742 = select_1719_s4_q & (~select_1740[5]);
  // hls/stages/patches.hpp:301
  logic [6:0] sum_1749;
  assign sum_1749 = select_1703 + 7'h7f;
  // hls/stages/patches.hpp:115
  logic equal_1750;
  assign equal_1750 = {sum_1749[6], select_467_s4_q, select_465_s4_q} == {1'b0, sum_1749[5:0], 3'h4};
  // hls/stages/patches.hpp:117
  logic or_1752;
  assign or_1752 = and_1583_s4_q | (select_1701 & equal_1750);
  logic [4:0] select_1753;
  assign select_1753 = or_1752 ? {and_1583_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:301
  logic [6:0] sum_1754;
  assign sum_1754 = select_1732 + 7'h7f;
  // hls/stages/patches.hpp:115
  logic equal_1755;
  assign equal_1755 = {sum_1754[6], select_467_s4_q, select_465_s4_q} == {1'b0, sum_1754[5:0], 3'h4};
  // hls/stages/patches.hpp:117
  logic [4:0] select_1758;
  assign select_1758 = (and_1583_s4_q | (select_1730 & equal_1755)) ? {and_1583_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:125
  logic [3:0] column_5;
  assign column_5 = select_1753[4] ? select_1758[3:0] : select_1753[3:0];
  // hls/stages/agreement.hpp:263
  logic select_1761;
  assign select_1761 = or_1752 ? and_1583_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:125
  logic and_1767;
  assign and_1767 = (select_1719_s4_q & (select_1713_s4_q[3] ^ select_1713_s4_q[4])) & ((~select_1753[4]) | (~select_1758[4]));
  // hls/stages/patches.hpp:167
  logic less_1858;
  assign less_1858 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:168
  logic not_1859;
  assign not_1859 = ~less_1858;
  logic [1:0] select_1860;
  assign select_1860 = patches_summed_first_s4_q ? 2'h2 : {less_1858, not_1859};
  logic [12:0] select_1862;
  assign select_1862 = select_1860[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1870;
  assign select_1870 = select_1860[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1869_s4_q, 1'b0, select_1866_s4_q, left_pixel_q};
  logic [14:0] select_1871;
  assign select_1871 = (select_1860 == 2'h2) ? {select_1862[12:8], patches_sums_values_0_q[9:8], select_1862[7:0]} : select_1870;
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1894;
  assign select_1894 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:867
  logic [5:0] sum_1895;
  assign sum_1895 = {5'h0, textured_s4_q} + select_1894;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_1897;
  assign sum_1897 = {4'h0, sum_1895} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1899;
  assign select_1899 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:867
  logic [5:0] sum_1900;
  assign sum_1900 = {5'h0, explained_s4_q} + select_1899;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_1902;
  assign sum_1902 = {4'h0, sum_1900} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1905;
  assign select_1905 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:868
  logic [5:0] sum_1906;
  assign sum_1906 = {5'h0, and_1904_s4_q} + select_1905;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_1908;
  assign sum_1908 = {4'h0, sum_1906} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1043
  logic not_1975;
  assign not_1975 = ~region_row_s4_q[2];
  logic [2:0] select_1976;
  assign select_1976 = region_row_s4_q[1] ? {1'b0, not_1975, 1'b0} : {region_row_s4_q[2], 1'b0, not_1975};
  logic [5:0] select_1977;
  assign select_1977 = region_row_s4_q[0] ? {select_1976[2], 1'b0, select_1976[1], 1'b0, select_1976[0], 1'b0} : {1'b0, select_1976[2], 1'b0, select_1976[1], 1'b0, select_1976[0]};
  logic [11:0] select_1978;
  assign select_1978 = or_1974_s4_q ? {select_1977[5], 1'b0, select_1977[4], 1'b0, select_1977[3], 1'b0, select_1977[2], 1'b0, select_1977[1], 1'b0, select_1977[0], 1'b0} : {1'b0, select_1977[5], 1'b0, select_1977[4], 1'b0, select_1977[3], 1'b0, select_1977[2], 1'b0, select_1977[1], 1'b0, select_1977[0]};
  logic [23:0] select_1979;
  assign select_1979 = or_1971_s4_q ? {select_1978[11], 1'b0, select_1978[10], 1'b0, select_1978[9], 1'b0, select_1978[8], 1'b0, select_1978[7], 1'b0, select_1978[6], 1'b0, select_1978[5], 1'b0, select_1978[4], 1'b0, select_1978[3], 1'b0, select_1978[2], 1'b0, select_1978[1], 1'b0, select_1978[0], 1'b0} : {1'b0, select_1978[11], 1'b0, select_1978[10], 1'b0, select_1978[9], 1'b0, select_1978[8], 1'b0, select_1978[7], 1'b0, select_1978[6], 1'b0, select_1978[5], 1'b0, select_1978[4], 1'b0, select_1978[3], 1'b0, select_1978[2], 1'b0, select_1978[1], 1'b0, select_1978[0]};
  logic [47:0] select_1980;
  assign select_1980 = or_1968_s4_q ? {select_1979[23], 1'b0, select_1979[22], 1'b0, select_1979[21], 1'b0, select_1979[20], 1'b0, select_1979[19], 1'b0, select_1979[18], 1'b0, select_1979[17], 1'b0, select_1979[16], 1'b0, select_1979[15], 1'b0, select_1979[14], 1'b0, select_1979[13], 1'b0, select_1979[12], 1'b0, select_1979[11], 1'b0, select_1979[10], 1'b0, select_1979[9], 1'b0, select_1979[8], 1'b0, select_1979[7], 1'b0, select_1979[6], 1'b0, select_1979[5], 1'b0, select_1979[4], 1'b0, select_1979[3], 1'b0, select_1979[2], 1'b0, select_1979[1], 1'b0, select_1979[0], 1'b0} : {1'b0, select_1979[23], 1'b0, select_1979[22], 1'b0, select_1979[21], 1'b0, select_1979[20], 1'b0, select_1979[19], 1'b0, select_1979[18], 1'b0, select_1979[17], 1'b0, select_1979[16], 1'b0, select_1979[15], 1'b0, select_1979[14], 1'b0, select_1979[13], 1'b0, select_1979[12], 1'b0, select_1979[11], 1'b0, select_1979[10], 1'b0, select_1979[9], 1'b0, select_1979[8], 1'b0, select_1979[7], 1'b0, select_1979[6], 1'b0, select_1979[5], 1'b0, select_1979[4], 1'b0, select_1979[3], 1'b0, select_1979[2], 1'b0, select_1979[1], 1'b0, select_1979[0]};
  // hls/stages/agreement.hpp:976
  logic and_1984;
  assign and_1984 = good_known_q & (~((good_q & select_1980) == 48'h0));
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_1963_s4_q ? and_1984 : not_1999_s4_q;
  // hls/stages/agreement.hpp:1054
  logic and_2014;
  assign and_2014 = is_seen & less_2013_s4_q;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2048;
  assign select_2048 = sample_pair_whole_s4_q ? (and_499_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2050;
  assign select_2050 = sample_pair_whole_s4_q ? (and_499_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2052;
  assign select_2052 = sample_pair_whole_s4_q ? (and_499_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2054;
  assign select_2054 = sample_pair_whole_s4_q ? (and_499_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2059;
  assign sum_2059 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2060;
  assign difference_2060 = {1'b0, sum_2059[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2061;
  assign xor_2061 = {difference_2060[8:0], sum_2059[0]} ^ {10{difference_2060[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2060[9]} + {1'b0, xor_2061};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_504_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2066;
  assign select_2066 = sample_pair_whole_s4_q ? (and_499_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2067;
  assign sum_2067 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2068;
  assign difference_2068 = {1'b0, sum_2067[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2069;
  assign xor_2069 = {difference_2068[8:0], sum_2067[0]} ^ {10{difference_2068[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2068[9]} + {1'b0, xor_2069};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_504_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2074;
  assign select_2074 = sample_pair_whole_s4_q ? (and_499_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2157;
  assign sum_2157 = sum_2153_s4_q + {2'h0, sum_2156_s4_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2159;
  assign select_2159 = and_501_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2160;
  assign select_2160 = and_501_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2161;
  assign select_2161 = and_501_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2162;
  assign select_2162 = and_501_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2165;
  assign sum_2165 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2157};
  logic [13:0] sum_2167;
  assign sum_2167 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2165});
  // hls/stages/census.hpp:305
  logic and_2169;
  assign and_2169 = and_591_s4_q & (9'h4 < sum_2167[13:5]);
  // hls/stages/census.hpp:306
  logic and_2170;
  assign and_2170 = and_591_s4_q & less_615;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2171;
  assign sum_2171 = census_left_misses_q + {{17{and_2170}}, and_2169, 1'b0, and_2169};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2173;
  assign select_2173 = and_501_s4_q ? (equal_2164_s4_q ? 20'h0 : sum_2171) : census_left_misses_q;
  // hls/stages/agreement.hpp:263
  logic [27:0] select_2178;
  assign select_2178 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:507
  logic select_2181;
  assign select_2181 = and_501_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2184;
  assign and_2184 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:444
  logic and_2190;
  assign and_2190 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2191;
  assign and_2191 = and_2184 & and_2190;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2178[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2193;
  assign select_2193 = and_2191 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2195;
  assign select_2195 = equal_2164_s4_q ? {11'h0, select_2193} : (sharpness_sums_detail_0_q + {11'h0, select_2193});
  // hls/stages/agreement.hpp:444
  logic and_2202;
  assign and_2202 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2203;
  assign and_2203 = and_2184 & and_2202;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2178[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2205;
  assign select_2205 = and_2203 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2207;
  assign select_2207 = equal_2164_s4_q ? {11'h0, select_2205} : (sharpness_sums_detail_1_q + {11'h0, select_2205});
  logic [8:0] select_2210;
  assign select_2210 = and_2191 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2211;
  assign sum_2211 = (equal_2164_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2210};
  logic [8:0] select_2214;
  assign select_2214 = and_2203 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2215;
  assign sum_2215 = (equal_2164_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2214};
  // hls/stages/agreement.hpp:203
  logic equal_2217;
  assign equal_2217 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2218;
  assign less_2218 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2219;
  assign less_2219 = x_s4_q[4:0] < 5'h3;
  logic not_2220;
  assign not_2220 = ~x_s4_q[1];
  logic [2:0] select_2221;
  assign select_2221 = x_s4_q[0] ? {1'b0, not_2220, 1'b0} : {x_s4_q[1], 1'b0, not_2220};
  logic [5:0] select_2222;
  assign select_2222 = slot_s4_q[2] ? {select_2221[2], 1'b0, select_2221[1], 1'b0, select_2221[0], 1'b0} : {1'b0, select_2221[2], 1'b0, select_2221[1], 1'b0, select_2221[0]};
  logic [11:0] select_2223;
  assign select_2223 = slot_s4_q[1] ? {select_2222[5], 1'b0, select_2222[4], 1'b0, select_2222[3], 1'b0, select_2222[2], 1'b0, select_2222[1], 1'b0, select_2222[0], 1'b0} : {1'b0, select_2222[5], 1'b0, select_2222[4], 1'b0, select_2222[3], 1'b0, select_2222[2], 1'b0, select_2222[1], 1'b0, select_2222[0]};
  logic [23:0] select_2224;
  assign select_2224 = slot_s4_q[0] ? {select_2223[11], 1'b0, select_2223[10], 1'b0, select_2223[9], 1'b0, select_2223[8], 1'b0, select_2223[7], 1'b0, select_2223[6], 1'b0, select_2223[5], 1'b0, select_2223[4], 1'b0, select_2223[3], 1'b0, select_2223[2], 1'b0, select_2223[1], 1'b0, select_2223[0], 1'b0} : {1'b0, select_2223[11], 1'b0, select_2223[10], 1'b0, select_2223[9], 1'b0, select_2223[8], 1'b0, select_2223[7], 1'b0, select_2223[6], 1'b0, select_2223[5], 1'b0, select_2223[4], 1'b0, select_2223[3], 1'b0, select_2223[2], 1'b0, select_2223[1], 1'b0, select_2223[0]};
  // hls/stages/census.hpp:372
  logic and_2228;
  assign and_2228 = less_2219 & (~((sharpness_sums_contrast_1_q & select_2224) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2230;
  assign select_2230 = (less_2218 & and_2228) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2230};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2233;
  assign select_2233 = equal_2217 ? (less_2218 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2238;
  assign and_2238 = less_2219 & (~((sharpness_sums_contrast_0_q & select_2224) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2240;
  assign select_2240 = (less_2218 & and_2238) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2240};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2243;
  assign select_2243 = equal_2217 ? (less_2218 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2245;
  assign select_2245 = equal_2217 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2247;
  assign select_2247 = equal_2217 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2249;
  assign select_2249 = equal_2217 ? {sharpness_comparing_contrast_0_q[0], and_2238} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2251;
  assign select_2251 = equal_2217 ? {sharpness_comparing_contrast_1_q[0], and_2228} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:207
  logic select_2256;
  assign select_2256 = drew_q ? (equal_2217 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:207
  logic select_2260;
  assign select_2260 = drew_q ? (equal_2217 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2261;
  assign equal_2261 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2262;
  assign xor_2262 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2265;
  assign select_2265 = (equal_2261 | xor_2262) ? (five_times[0] & xor_2262) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2267;
  assign select_2267 = drew_q ? (equal_2217 ? select_2265 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2268;
  assign xor_2268 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2271;
  assign select_2271 = (equal_2261 | xor_2268) ? (five_times_2[0] & xor_2268) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2273;
  assign select_2273 = drew_q ? (equal_2217 ? select_2271 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2274;
  assign xor_2274 = sharpness_comparing_contrast_0_q[1] ^ and_2228;
  logic select_2277;
  assign select_2277 = (equal_2261 | xor_2274) ? (and_2228 & xor_2274) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2279;
  assign select_2279 = drew_q ? (equal_2217 ? select_2277 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2280;
  assign xor_2280 = sharpness_comparing_contrast_1_q[1] ^ and_2238;
  logic select_2283;
  assign select_2283 = (equal_2261 | xor_2280) ? (and_2238 & xor_2280) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2285;
  assign select_2285 = drew_q ? (equal_2217 ? select_2283 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2410;
  assign select_2410 = and_2404_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2408_s4_q});
  // hls/stages/patches.hpp:321
  logic and_2413;
  assign and_2413 = not_1471_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2418;
  assign and_2418 = not_1471_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2423;
  assign and_2423 = not_1471_s4_q & (drew_q & (ends_cell_s4_q & and_1904_s4_q));
  // hls/stages/agreement.hpp:1047
  logic not_2427;
  assign not_2427 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1048
  logic not_2444;
  assign not_2444 = ~(equal_1963_s4_q ? and_1984 : not_2442_s4_q);
  // hls/stages/patches.hpp:321
  logic and_2447;
  assign and_2447 = ends_cell_s4_q & (not_2427 & (centres_values_1_textured_s4_q & not_2444));
  logic and_2449;
  assign and_2449 = not_1471_s4_q & (drew_q & and_2447);
  // hls/stages/agreement.hpp:1074
  logic less_2452;
  assign less_2452 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2453;
  assign select_2453 = less_2452 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2456;
  assign select_2456 = less_2452 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2457;
  assign sum_2457 = {1'b0, select_2456} + {3'h0, select_2456[9:2]};
  logic and_2459;
  assign and_2459 = (~(select_2453[9:4] == 6'h0)) & ({sum_2457, select_2456[1:0]} < {3'h0, select_2453});
  // hls/stages/agreement.hpp:1084
  logic [9:0] select_2462;
  assign select_2462 = x_s4_q[6] ? (equal_1515_s4_q ? 10'h0 : (and_2459 ? select_2453 : 10'h0)) : 10'h0;
  // hls/stages/patches.hpp:321
  logic [9:0] select_2463;
  assign select_2463 = equal_1470_s4_q ? select_2462 : 10'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2465;
  assign select_2465 = and_2404_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2463});
  logic [13:0] select_2472;
  assign select_2472 = and_2404_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2470_s4_q});
  // hls/stages/agreement.hpp:1052
  logic and_2474;
  assign and_2474 = not_2427 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/patches.hpp:321
  logic and_2477;
  assign and_2477 = not_1471_s4_q & (drew_q & (ends_cell_s4_q & and_2474));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2479;
  assign select_2479 = and_2404_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2477});
  // hls/stages/agreement.hpp:1052
  logic and_2481;
  assign and_2481 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2444);
  // hls/stages/patches.hpp:321
  logic and_2485;
  assign and_2485 = not_1471_s4_q & (drew_q & (ends_cell_s4_q & (not_2427 & and_2481)));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2487;
  assign select_2487 = and_2404_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2485});
  // hls/stages/patches.hpp:321
  logic [7:0] select_2536;
  assign select_2536 = drew_q ? (equal_1611_s4_q ? (and_2520_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2537;
  assign select_2537 = equal_1470_s4_q ? 8'h0 : select_2536;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2539;
  assign select_2539 = and_2519_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2537[7]}}, select_2537});
  // hls/stages/patches.hpp:321
  logic and_2542;
  assign and_2542 = not_1471_s4_q & (drew_q & (and_2520_s4_q & equal_1611_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2544;
  assign select_2544 = and_2519_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2542});
  // hls/stages/registration.hpp:107
  logic and_2546;
  assign and_2546 = and_2520_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/patches.hpp:321
  logic [1:0] select_2548;
  assign select_2548 = drew_q ? (equal_1611_s4_q ? {and_2546, and_2520_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2549;
  assign select_2549 = equal_1470_s4_q ? 2'h0 : select_2548;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2550;
  assign sum_2550 = registration_half_votes_down_q + {{5{select_2549[1]}}, select_2549};
  // hls/stages/patches.hpp:321
  logic [1:0] select_2556;
  assign select_2556 = drew_q ? (equal_1611_s4_q ? {and_2554_s4_q, and_2520_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2557;
  assign select_2557 = equal_1470_s4_q ? 2'h0 : select_2556;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2558;
  assign sum_2558 = registration_half_votes_up_q + {{5{select_2557[1]}}, select_2557};
  // hls/stages/registration.hpp:107
  logic and_2561;
  assign and_2561 = and_2520_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/patches.hpp:321
  logic [1:0] select_2563;
  assign select_2563 = drew_q ? (equal_1611_s4_q ? {and_2561, and_2520_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2564;
  assign select_2564 = equal_1470_s4_q ? 2'h0 : select_2563;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2565;
  assign sum_2565 = registration_half_half_votes_down_q + {{5{select_2564[1]}}, select_2564};
  // hls/stages/patches.hpp:321
  logic [1:0] select_2570;
  assign select_2570 = drew_q ? (equal_1611_s4_q ? {and_2568_s4_q, and_2520_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2571;
  assign select_2571 = equal_1470_s4_q ? 2'h0 : select_2570;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2572;
  assign sum_2572 = registration_half_half_votes_up_q + {{5{select_2571[1]}}, select_2571};
  // hls/stages/patches.hpp:321
  logic and_2606;
  assign and_2606 = equal_1470_s4_q & (x_s4_q[6] & (not_1883_s4_q & less_1546_s4_q));
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2613;
  assign select_2613 = or_1550_s4_q ? 12'h0 : (equal_2611_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2616;
  assign select_2616 = x_s4_q[6] ? (equal_1515_s4_q ? 12'h0 : (less_1546_s4_q ? select_2613 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:321
  logic [11:0] select_2617;
  assign select_2617 = equal_1470_s4_q ? select_2616 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2618;
  assign and_2618 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_2621;
  assign and_2621 = not_1883_s4_q & (less_1546_s4_q & ({and_2618, x_s4_q[0]} == 2'h0));
  // hls/stages/patches.hpp:321
  logic and_2623;
  assign and_2623 = equal_1470_s4_q & (x_s4_q[6] & and_2621);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2625;
  assign sum_2625 = {{2{select_2617[11]}}, select_2617} + (and_2623 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2628;
  assign select_2628 = or_1550_s4_q ? 12'h0 : (equal_2611_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2631;
  assign select_2631 = x_s4_q[6] ? (equal_1515_s4_q ? 12'h0 : (less_1546_s4_q ? select_2628 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:321
  logic [11:0] select_2632;
  assign select_2632 = equal_1470_s4_q ? select_2631 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2634;
  assign sum_2634 = {{2{select_2632[11]}}, select_2632} + (and_2623 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2636;
  assign not_2636 = ~all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_2639;
  assign and_2639 = not_1883_s4_q & (less_1546_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2636, 1'b0}));
  // hls/stages/patches.hpp:321
  logic and_2645;
  assign and_2645 = equal_1470_s4_q & (x_s4_q[6] & (not_1883_s4_q & (less_1546_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_2646;
  assign not_2646 = ~and_2645;
  logic less_2647;
  assign less_2647 = $signed({9'h1, {2{not_2646}}, and_2645}) < $signed(registration_up_q[13:2]);
  logic select_2648;
  assign select_2648 = (equal_1470_s4_q & (x_s4_q[6] & and_2639)) ? less_2647 : registration_enough_q;
  // hls/stages/agreement.hpp:1084
  logic and_2652;
  assign and_2652 = x_s4_q[6] & (not_1883_s4_q & (less_1546_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:321
  logic and_2653;
  assign and_2653 = equal_1470_s4_q & and_2652;
  // hls/stages/registration.hpp:242
  logic less_2654;
  assign less_2654 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2656;
  assign less_2656 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1084
  logic and_2661;
  assign and_2661 = x_s4_q[6] & (not_1883_s4_q & (less_1546_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/patches.hpp:321
  logic and_2662;
  assign and_2662 = equal_1470_s4_q & and_2661;
  // hls/stages/agreement.hpp:1084
  logic and_2669;
  assign and_2669 = x_s4_q[6] & (not_1883_s4_q & (less_1546_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2672;
  assign equal_2672 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1084
  logic and_2675;
  assign and_2675 = not_1883_s4_q & (less_1546_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2672));
  // hls/stages/registration.hpp:244
  logic and_2679;
  assign and_2679 = (equal_1470_s4_q & (x_s4_q[6] & and_2675)) & (less_2656 | less_2654);
  // hls/stages/agreement.hpp:1084
  logic and_2684;
  assign and_2684 = not_1883_s4_q & (less_1546_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2672)));
  // hls/stages/registration.hpp:244
  logic and_2687;
  assign and_2687 = registration_votes_up_q & registration_other_down_q;
  logic select_2689;
  assign select_2689 = registration_votes_down_q ? (registration_other_up_q | and_2687) : and_2687;
  // hls/stages/registration.hpp:138
  logic and_2691;
  assign and_2691 = (equal_1470_s4_q & (x_s4_q[6] & and_2684)) & (registration_other_enough_q & select_2689);
  // hls/stages/registration.hpp:245
  logic or_2694;
  assign or_2694 = registration_moved_q | (registration_enough_q & (and_2679 | and_2691));
  // hls/stages/agreement.hpp:263
  logic [7:0] select_2778;
  assign select_2778 = sample_pair_whole_s4_q ? (equal_1601_s4_q ? patches_place_0_slope_q : select_1702[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_2783;
  assign select_2783 = sample_pair_whole_s4_q ? (equal_1601_s4_q ? patches_place_1_slope_q : select_1731[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:110
  logic select_2785;
  assign select_2785 = equal_1601_s4_q ? patches_valid_0_q : (select_1600_s4_q ? patches_valid_0_q : select_1699[0]);
  // hls/stages/agreement.hpp:263
  logic select_2788;
  assign select_2788 = sample_pair_whole_s4_q ? (and_1722 ? (sample_present_s4_q & select_2785) : select_2785) : patches_valid_0_q;
  // hls/stages/patches.hpp:110
  logic select_2790;
  assign select_2790 = equal_1601_s4_q ? patches_valid_1_q : (select_1600_s4_q ? select_1699[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_2793;
  assign select_2793 = sample_pair_whole_s4_q ? (and_1742 ? (sample_present_s4_q & select_2790) : select_2790) : patches_valid_1_q;
  logic [5:0] select_2796;
  assign select_2796 = sample_pair_whole_s4_q ? (select_1720[5] ? {1'b1, select_1720[4:0]} : (select_1720 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2799;
  assign select_2799 = sample_pair_whole_s4_q ? (select_1740[5] ? {1'b1, select_1740[4:0]} : (select_1740 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_2802;
  assign select_2802 = sample_pair_whole_s4_q ? (select_1753[4] ? {1'b1, select_1753[3:0]} : (select_1753 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2805;
  assign select_2805 = sample_pair_whole_s4_q ? (select_1758[4] ? {1'b1, select_1758[3:0]} : (select_1758 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:502
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3224_s4_q, parity_3220_s4_q, xor_3208_s4_q, parity_3180_s4_q, parity_3118_s4_q, parity_2989_s4_q} + (equal_3225_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:167
  logic [9:0] select_3229;
  assign select_3229 = equal_1683_s4_q ? patches_sums_values_0_q : (equal_1685_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3230;
  assign select_3230 = equal_1685_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3232;
  assign select_3232 = equal_1685_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3234;
  assign select_3234 = equal_1685_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3236;
  assign select_3236 = equal_1685_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3238;
  assign select_3238 = equal_1685_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3240;
  assign select_3240 = equal_1685_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3242;
  assign select_3242 = equal_1685_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3244;
  assign select_3244 = equal_1685_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3246;
  assign select_3246 = equal_1685_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3248;
  assign select_3248 = equal_1685_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3250;
  assign select_3250 = equal_1685_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3252;
  assign select_3252 = equal_1685_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3254;
  assign select_3254 = equal_1685_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3256;
  assign select_3256 = equal_1685_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3258;
  assign select_3258 = equal_1685_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3260;
  assign select_3260 = equal_1685_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:576
  logic or_3365;
  assign or_3365 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3364_s4_q;
  logic or_3368;
  assign or_3368 = equal_3356_s4_q | (less_3358_s4_q | (less_3359_s4_q | or_3365));
  // hls/stages/patches.hpp:556
  logic not_3369;
  assign not_3369 = ~or_3368;
  // hls/stages/patches.hpp:537
  logic and_3370;
  assign and_3370 = equal_1849_s4_q & not_3369;
  // hls/stages/patches.hpp:167
  logic and_3373;
  assign and_3373 = equal_1683_s4_q & (less_1846_s4_q ? (not_1848_s4_q & and_3370) : and_3370);
  // hls/stages/patches.hpp:619
  logic not_3374;
  assign not_3374 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:537
  logic and_3376;
  assign and_3376 = equal_1849_s4_q & (patches_second_s4_q & not_3369);
  // hls/stages/patches.hpp:167
  logic and_3379;
  assign and_3379 = equal_1683_s4_q & (less_1846_s4_q ? (not_1848_s4_q & and_3376) : and_3376);
  // hls/stages/patches.hpp:619
  logic not_3380;
  assign not_3380 = ~and_3379;
  // hls/stages/patches.hpp:171
  logic and_3382;
  assign and_3382 = and_3373 & (not_3374 & not_3380);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3384;
  assign sum_3384 = {7'h0, and_3382} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:574
  logic [7:0] select_3410;
  assign select_3410 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:573
  logic [5:0] select_3411;
  assign select_3411 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3412;
  assign sum_3412 = {2'h0, select_3344_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3413;
  assign sum_3413 = {select_3411[5], select_3411} + {{3{sum_3412[3]}}, sum_3412};
  // hls/stages/patches.hpp:574
  logic [17:0] product_3414;
  assign product_3414 = $signed({{10{select_3410[7]}}, select_3410}) * $signed({{8{sum_3413[6]}}, sum_3413, select_3344_s4_q[2:0]});
  // hls/stages/patches.hpp:575
  logic [13:0] difference_3415;
  assign difference_3415 = {{6{select_3409_s4_q[7]}}, select_3409_s4_q} - {product_3414[17], product_3414[17:5]};
  // hls/stages/patches.hpp:581
  logic less_3416;
  assign less_3416 = $signed({{7{difference_3386[6]}}, difference_3386}) < $signed(difference_3415);
  // hls/stages/patches.hpp:537
  logic and_3419;
  assign and_3419 = equal_1849_s4_q & (not_3369 & (~less_3416));
  // hls/stages/patches.hpp:167
  logic and_3422;
  assign and_3422 = equal_1683_s4_q & (less_1846_s4_q ? (not_1848_s4_q & and_3419) : and_3419);
  // hls/stages/patches.hpp:622
  logic and_3423;
  assign and_3423 = and_3422 & and_3382;
  logic [7:0] sum_3424;
  assign sum_3424 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3423};
  // hls/stages/patches.hpp:537
  logic and_3428;
  assign and_3428 = not_3369 & (~($signed(difference_3415) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3429;
  assign and_3429 = equal_1849_s4_q & and_3428;
  // hls/stages/patches.hpp:167
  logic and_3432;
  assign and_3432 = equal_1683_s4_q & (less_1846_s4_q ? (not_1848_s4_q & and_3429) : and_3429);
  // hls/stages/patches.hpp:623
  logic and_3433;
  assign and_3433 = and_3432 & and_3382;
  logic [7:0] sum_3434;
  assign sum_3434 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3433};
  // hls/stages/patches.hpp:171
  logic and_3436;
  assign and_3436 = and_3373 & (and_3379 & not_3374);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3438;
  assign sum_3438 = {7'h0, and_3436} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:622
  logic and_3440;
  assign and_3440 = and_3422 & and_3436;
  logic [7:0] sum_3441;
  assign sum_3441 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3440};
  // hls/stages/patches.hpp:623
  logic and_3443;
  assign and_3443 = and_3432 & and_3436;
  logic [7:0] sum_3444;
  assign sum_3444 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3443};
  // hls/stages/patches.hpp:171
  logic and_3446;
  assign and_3446 = and_3373 & (patches_lower_s4_q & not_3380);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3448;
  assign sum_3448 = {7'h0, and_3446} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:622
  logic and_3450;
  assign and_3450 = and_3422 & and_3446;
  logic [7:0] sum_3451;
  assign sum_3451 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3450};
  // hls/stages/patches.hpp:623
  logic and_3453;
  assign and_3453 = and_3432 & and_3446;
  logic [7:0] sum_3454;
  assign sum_3454 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3453};
  // hls/stages/patches.hpp:171
  logic and_3456;
  assign and_3456 = and_3373 & (patches_lower_s4_q & and_3379);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3458;
  assign sum_3458 = {7'h0, and_3456} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:622
  logic and_3460;
  assign and_3460 = and_3422 & and_3456;
  logic [7:0] sum_3461;
  assign sum_3461 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3460};
  // hls/stages/patches.hpp:623
  logic and_3463;
  assign and_3463 = and_3432 & and_3456;
  logic [7:0] sum_3464;
  assign sum_3464 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3463};
  // hls/stages/agreement.hpp:1154
  logic equal_3465;
  assign equal_3465 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1072
  logic less_3466;
  assign less_3466 = x_s4_q[5:3] < 3'h3;
  // hls/stages/patches.hpp:321
  logic and_3470;
  assign and_3470 = equal_1470_s4_q & (x_s4_q[6] & (not_1883_s4_q & (equal_3465 & less_3466)));
  // hls/stages/agreement.hpp:1084
  logic and_3475;
  assign and_3475 = x_s4_q[6] & (not_1883_s4_q & (less_3466 & (x_s4_q[2:0] == 3'h1)));
  // hls/stages/patches.hpp:321
  logic and_3476;
  assign and_3476 = equal_1470_s4_q & and_3475;
  // hls/stages/patches.hpp:598
  logic [7:0] or_3478;
  assign or_3478 = (and_3470 ? patches_quarters_0_places_q : 8'h0) | (and_3476 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1084
  logic and_3482;
  assign and_3482 = x_s4_q[6] & (not_1883_s4_q & (less_3466 & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/patches.hpp:321
  logic and_3483;
  assign and_3483 = equal_1470_s4_q & and_3482;
  // hls/stages/agreement.hpp:1084
  logic and_3489;
  assign and_3489 = x_s4_q[6] & (not_1883_s4_q & (less_3466 & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:321
  logic and_3490;
  assign and_3490 = equal_1470_s4_q & and_3489;
  // hls/stages/patches.hpp:598
  logic [7:0] or_3492;
  assign or_3492 = (or_3478 | (and_3483 ? patches_quarters_2_places_q : 8'h0)) | (and_3490 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:182
  logic select_3496;
  assign select_3496 = (x_s4_q[5:3] == 3'h2) ? x_s4_q[1] : (x_s4_q[0] & (x_s4_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:321
  logic and_3500;
  assign and_3500 = equal_1470_s4_q & (x_s4_q[6] & (not_1883_s4_q & (less_3466 & select_3496)));
  // hls/stages/patches.hpp:599
  logic [7:0] select_3502;
  assign select_3502 = and_3470 ? (and_3500 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3504;
  assign select_3504 = and_3476 ? (and_3500 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3507;
  assign select_3507 = and_3483 ? (and_3500 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3510;
  assign select_3510 = and_3490 ? (and_3500 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:600
  logic [7:0] select_3513;
  assign select_3513 = and_3470 ? (and_3500 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3515;
  assign select_3515 = and_3476 ? (and_3500 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3518;
  assign select_3518 = and_3483 ? (and_3500 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3521;
  assign select_3521 = and_3490 ? (and_3500 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:185
  logic [4:0] sum_3523;
  assign sum_3523 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1084
  logic and_3527;
  assign and_3527 = x_s4_q[6] & (not_1883_s4_q & (less_3466 & (sum_3523[4:2] == 3'h0)));
  // hls/stages/patches.hpp:321
  logic and_3528;
  assign and_3528 = equal_1470_s4_q & and_3527;
  // hls/stages/patches.hpp:595
  logic [7:0] select_3531;
  assign select_3531 = and_3528 ? (patches_word_places_q + (and_3476 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3534;
  assign select_3534 = and_3528 ? (patches_word_up_q + (and_3476 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3537;
  assign select_3537 = and_3528 ? (patches_word_down_q + (and_3476 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:582
  logic [5:0] select_3541;
  assign select_3541 = ($signed(difference_3415[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3415[5:0];
  logic [5:0] select_3542;
  assign select_3542 = ($signed(14'h10) < $signed(difference_3415)) ? 6'h10 : select_3541;
  // hls/stages/patches.hpp:537
  logic [5:0] select_3544;
  assign select_3544 = equal_1849_s4_q ? (or_3368 ? 6'h0 : select_3542) : 6'h0;
  logic [5:0] select_3546;
  assign select_3546 = less_1846_s4_q ? (equal_1847_s4_q ? 6'h0 : select_3544) : select_3544;
  // hls/stages/patches.hpp:625
  logic [5:0] select_3548;
  assign select_3548 = and_3373 ? (equal_1683_s4_q ? select_3546 : 6'h0) : 6'h0;
  logic [11:0] sum_3549;
  assign sum_3549 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3548[5]}}, select_3548};
  // hls/stages/patches.hpp:321
  logic and_3553;
  assign and_3553 = equal_1470_s4_q & (x_s4_q[6] & (not_1883_s4_q & (equal_2672 & less_3466)));
  // hls/stages/agreement.hpp:1084
  logic and_3557;
  assign and_3557 = x_s4_q[6] & (not_1883_s4_q & (less_3466 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:321
  logic and_3558;
  assign and_3558 = equal_1470_s4_q & and_3557;
  // hls/stages/patches.hpp:614
  logic [7:0] select_3560;
  assign select_3560 = and_3553 ? (and_3558 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:616
  logic or_3564;
  assign or_3564 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:613
  logic select_3566;
  assign select_3566 = and_3553 ? (and_3558 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:171
  logic and_3572;
  assign and_3572 = patches_complete_q & (equal_1470_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_3568_s4_q)));
  logic and_3573;
  assign and_3573 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:613
  logic [2:0] select_3575;
  assign select_3575 = and_3558 ? {and_3573, patches_found_q[2:1]} : (and_3553 ? {and_3573, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:607
  logic equal_3580;
  assign equal_3580 = patches_found_q == 3'h0;
  logic now_2;
  assign now_2 = ~equal_3580;
  // hls/stages/patches.hpp:612
  logic select_3584;
  assign select_3584 = patches_round_ends_q ? (patches_suspected_q & now_2) : patches_moved_q;
  logic select_3587;
  assign select_3587 = patches_round_ends_q ? (patches_suspected_q | (patches_settled_q | equal_3580)) : patches_settled_q;
  // hls/stages/agreement.hpp:1126
  logic or_3644;
  assign or_3644 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1148
  logic equal_3646;
  assign equal_3646 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1158
  logic select_3652;
  assign select_3652 = (equal_3646 & equal_3465) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_3655;
  assign sum_3655 = {1'b0, select_2456} + {2'h0, select_2456[9:1]};
  logic select_3658;
  assign select_3658 = (select_2453[9:3] == 7'h0) ? ((~or_3644) & (~select_3652)) : (~({sum_3655, select_2456[0]} < {2'h0, select_2453}));
  // hls/stages/agreement.hpp:1084
  logic [47:0] select_3660;
  assign select_3660 = x_s4_q[6] ? (equal_1515_s4_q ? good_q : {select_3658, good_q[47:1]}) : good_q;
  // hls/stages/patches.hpp:321
  logic select_3664;
  assign select_3664 = equal_1470_s4_q ? ((x_s4_q[6] & good_known_q) | equal_3568_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1148
  logic equal_3665;
  assign equal_3665 = x_s4_q[6:3] == 4'ha;
  logic equal_3667;
  assign equal_3667 = x_s4_q[6:3] == 4'h9;
  logic equal_3668;
  assign equal_3668 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3670;
  assign select_3670 = equal_3667 ? counts_skin_unproven_q : (equal_3668 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3665 ? counts_nearer_q : select_3670;
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1161
  logic select_3673;
  assign select_3673 = (equal_3665 & equal_3465) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1086
  logic not_3674;
  assign not_3674 = ~hidden_for_q[7];
  logic [7:0] select_3676;
  assign select_3676 = select_3673 ? (hidden_for_q + {7'h0, not_3674}) : 8'h0;
  // hls/stages/patches.hpp:321
  logic [7:0] select_3678;
  assign select_3678 = equal_1470_s4_q ? (equal_3568_s4_q ? select_3676 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3679;
  assign select_3679 = equal_3465 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_3681;
  assign select_3681 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3683;
  assign select_3683 = equal_3668 ? cfg_unproven_skin_limit_i : (equal_3646 ? cfg_unproven_limit_i : select_3681);
  logic [7:0] limit;
  assign limit = equal_3665 ? cfg_regions_limit_i : (equal_3667 ? cfg_hidden_limit_i : select_3683);
  // hls/stages/agreement.hpp:1161
  logic not_3686;
  assign not_3686 = ~x_s4_q[2];
  logic [3:0] select_3687;
  assign select_3687 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_3686, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_3686};
  logic [7:0] select_3688;
  assign select_3688 = x_s4_q[0] ? {select_3687[3], 1'b0, select_3687[2], 1'b0, select_3687[1], 1'b0, select_3687[0], 1'b0} : {1'b0, select_3687[3], 1'b0, select_3687[2], 1'b0, select_3687[1], 1'b0, select_3687[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3692;
  assign select_3692 = equal_3667 ? counts_skin_supervised_q : (equal_3668 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3665 ? counts_textured_q : select_3692;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3694;
  assign select_3694 = ((limit & select_3688) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3679} + {1'b0, select_3694};
  // hls/stages/patches.hpp:321
  logic select_3699;
  assign select_3699 = equal_1470_s4_q ? (equal_3465 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1159
  logic and_3704;
  assign and_3704 = too_much_q & (~(equal_3668 & equal_3465));
  // hls/stages/agreement.hpp:1160
  logic select_3709;
  assign select_3709 = (over[14] & equal_3465) ? (and_3704 | ((equal_3668 | equal_3667) | (x_s4_q[6:3] == 4'hf))) : and_3704;
  // hls/stages/agreement.hpp:1202
  logic select_3817;
  assign select_3817 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:265
  logic select_3819;
  assign select_3819 = left_first_s4_q ? done_s4_q : (and_1864_s4_q ? select_3817 : proven_q);
  // hls/stages/agreement.hpp:1235
  logic [1:0] select_3870;
  assign select_3870 = and_3869_s4_q ? {and_2014, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1236
  logic and_3871;
  assign and_3871 = select_3817 & less_3847;
  // hls/stages/agreement.hpp:424
  logic select_3874;
  assign select_3874 = and_1941_s4_q ? (less_1942_s4_q ? (select_3870[0] & and_3871) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:265
  logic select_3876;
  assign select_3876 = left_first_s4_q ? select_3874 : (and_1864_s4_q ? select_3874 : seen_q);
  logic select_3877;
  assign select_3877 = and_1864_s4_q ? select_3876 : seen_q;
  // hls/stages/agreement.hpp:424
  logic select_3880;
  assign select_3880 = and_1941_s4_q ? (less_1942_s4_q ? (select_3870[1] & and_3871) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:265
  logic select_3882;
  assign select_3882 = left_first_s4_q ? select_3880 : (and_1864_s4_q ? select_3880 : nearer_q);
  logic select_3883;
  assign select_3883 = and_1864_s4_q ? select_3882 : nearer_q;
  // hls/stages/agreement.hpp:1169
  logic or_3892;
  assign or_3892 = ((~(cfg_patch_limit_i == 6'h3f)) & (~patches_settled_q)) | (~proven_q);
  // hls/stages/agreement.hpp:1171
  logic not_3900;
  assign not_3900 = ~(or_3644 | not_3884);
  // hls/stages/patches.hpp:321
  logic and_3904;
  assign and_3904 = equal_1470_s4_q & (equal_3568_s4_q & (not_3900 & (select_3652 | select_3709)));
  logic and_3907;
  assign and_3907 = equal_3568_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1088
  logic or_3911;
  assign or_3911 = select_2267 | (select_2279 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/patches.hpp:321
  logic and_3918;
  assign and_3918 = equal_1470_s4_q & (equal_3568_s4_q & (not_3900 & (select_2273 | select_2285)));
  // hls/stages/agreement.hpp:1088
  logic and_3923;
  assign and_3923 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3676 < cfg_hidden_frames_i));
  // hls/stages/patches.hpp:321
  logic and_3930;
  assign and_3930 = equal_1470_s4_q & (x_s4_q[6] & (not_1883_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3938;
  assign select_3938 = equal_1537_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_3936_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_3939;
  assign select_3939 = equal_1535_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3938;
  logic [31:0] select_3940;
  assign select_3940 = equal_1533_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3939;
  logic [31:0] select_3941;
  assign select_3941 = equal_1531_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3940;
  logic [31:0] select_3942;
  assign select_3942 = equal_1529_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3941;
  logic [31:0] select_3943;
  assign select_3943 = equal_1527_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_3942;
  logic [31:0] select_3944;
  assign select_3944 = equal_1525_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_3943;
  logic [31:0] select_3945;
  assign select_3945 = equal_1523_s4_q ? {9'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3944;
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_3946;
  assign select_3946 = less_2452 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1084
  logic [31:0] select_3947;
  assign select_3947 = equal_1515_s4_q ? select_3945 : {2'h0, select_3946, select_2456, select_2453};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_501_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_616, and_592_s4_q, and_591_s4_q, and_566_s4_q, less_558_s4_q, less_557_s4_q, less_556_s4_q, less_555_s4_q, less_554_s4_q, less_553_s4_q, less_552_s4_q, less_551_s4_q, less_550_s4_q, less_549_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q, less_545_s4_q, less_544_s4_q, less_543_s4_q, less_542_s4_q, less_541_s4_q, less_540_s4_q, less_539_s4_q, less_538_s4_q, less_537_s4_q, less_536_s4_q, less_535_s4_q};
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
  assign registration_sums_waddr = {sum_1521_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1580_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1579, sum_1575};
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
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_1609_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_1682_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1675_s4_q};
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
  assign patches_right_0_waddr = {select_1713_s4_q, select_1710};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_1722);
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
  assign patches_right_1_waddr = {select_1713_s4_q, select_1739};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_1742);
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
  assign patches_left_waddr = {select_1761, select_1760_s4_q, column_5};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_1767);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1871;
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
  assign regions_waddr = {region_row_s4_q, or_1881_s4_q, or_1878_s4_q, or_1875_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1909_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1908, sum_1902, sum_1897};
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
  assign map_waddr = sum_1950_s4_q;
  logic map_we;
  assign map_we = s4_en & and_2024_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2014, is_seen};
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
      patches_found_q <= 3'h0;
      patches_round_places_q <= 8'h0;
      patches_round_across_q <= 12'h0;
      patches_round_moved_q <= 3'h0;
      patches_suspected_q <= 1'b0;
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
      census_left_misses_q <= select_2173;
      sharpness_before_last_mask_q <= select_2181;
      sharpness_sums_detail_0_q <= and_501_s4_q ? select_2195 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_501_s4_q ? select_2207 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_501_s4_q ? sum_2211 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_501_s4_q ? sum_2215 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2233 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2243 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2245 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2247 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2249 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2251 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2256;
      sharpness_comparing_carry_1_q <= select_2260;
      sharpness_comparing_less_detail_0_q <= select_2267;
      sharpness_comparing_less_detail_1_q <= select_2273;
      sharpness_comparing_less_contrast_0_q <= select_2279;
      sharpness_comparing_less_contrast_1_q <= select_2285;
      counts_supervised_q <= select_2410;
      counts_textured_q <= and_2404_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2413});
      counts_explained_q <= and_2404_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2418});
      counts_nearer_q <= and_2404_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2423});
      counts_unproven_q <= and_2404_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2449});
      counts_regions_bad_q <= select_2465;
      counts_skin_supervised_q <= select_2472;
      counts_skin_textured_q <= select_2479;
      counts_skin_unproven_q <= select_2487;
      registration_half_across_q <= select_2539;
      registration_half_measured_q <= select_2544;
      registration_half_votes_down_q <= and_2519_s4_q ? 7'h0 : sum_2550;
      registration_half_votes_up_q <= and_2519_s4_q ? 7'h0 : sum_2558;
      registration_half_half_votes_down_q <= and_2519_s4_q ? 7'h0 : sum_2565;
      registration_half_half_votes_up_q <= and_2519_s4_q ? 7'h0 : sum_2572;
      registration_down_q <= and_2606 ? sum_2625 : registration_down_q;
      registration_up_q <= and_2606 ? sum_2634 : registration_up_q;
      registration_enough_q <= select_2648;
      registration_votes_down_q <= and_2653 ? less_2654 : registration_votes_down_q;
      registration_votes_up_q <= and_2653 ? less_2656 : registration_votes_up_q;
      registration_other_enough_q <= and_2662 ? select_2648 : registration_other_enough_q;
      registration_other_down_q <= and_2662 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2662 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1470_s4_q & and_2669)) & or_2694;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_1701 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_1703 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_1704 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2778;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_1730 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_1732 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_1733 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2783;
      patches_valid_0_q <= select_2788;
      patches_valid_1_q <= select_2793;
      patches_right_next_0_q <= select_2796;
      patches_right_next_1_q <= select_2799;
      patches_left_next_0_q <= select_2802;
      patches_left_next_1_q <= select_2805;
      patches_sums_values_0_q <= select_3229;
      patches_sums_values_1_q <= equal_1683_s4_q ? patches_sums_values_1_q : select_3230;
      patches_sums_values_2_q <= equal_1683_s4_q ? patches_sums_values_2_q : select_3232;
      patches_sums_values_3_q <= equal_1683_s4_q ? patches_sums_values_3_q : select_3234;
      patches_sums_values_4_q <= equal_1683_s4_q ? patches_sums_values_4_q : select_3236;
      patches_sums_values_5_q <= equal_1683_s4_q ? patches_sums_values_5_q : select_3238;
      patches_sums_values_6_q <= equal_1683_s4_q ? patches_sums_values_6_q : select_3240;
      patches_sums_values_7_q <= equal_1683_s4_q ? patches_sums_values_7_q : select_3242;
      patches_sums_values_8_q <= equal_1683_s4_q ? patches_sums_values_8_q : select_3244;
      patches_sums_values_9_q <= equal_1683_s4_q ? patches_sums_values_9_q : select_3246;
      patches_sums_values_10_q <= equal_1683_s4_q ? patches_sums_values_10_q : select_3248;
      patches_sums_values_11_q <= equal_1683_s4_q ? patches_sums_values_11_q : select_3250;
      patches_sums_values_12_q <= equal_1683_s4_q ? patches_sums_values_12_q : select_3252;
      patches_sums_values_13_q <= equal_1683_s4_q ? patches_sums_values_13_q : select_3254;
      patches_sums_values_14_q <= equal_1683_s4_q ? patches_sums_values_14_q : select_3256;
      patches_sums_values_15_q <= equal_1683_s4_q ? patches_sums_values_15_q : select_3258;
      patches_sums_values_16_q <= equal_1683_s4_q ? patches_sums_values_16_q : select_3260;
      patches_best_differing_q <= select_1871[9:0];
      patches_best_column_q <= select_1871[14:10];
      patches_quarters_0_places_q <= sum_3384;
      patches_quarters_0_up_q <= sum_3424;
      patches_quarters_0_down_q <= sum_3434;
      patches_quarters_1_places_q <= sum_3438;
      patches_quarters_1_up_q <= sum_3441;
      patches_quarters_1_down_q <= sum_3444;
      patches_quarters_2_places_q <= sum_3448;
      patches_quarters_2_up_q <= sum_3451;
      patches_quarters_2_down_q <= sum_3454;
      patches_quarters_3_places_q <= sum_3458;
      patches_quarters_3_up_q <= sum_3461;
      patches_quarters_3_down_q <= sum_3464;
      patches_word_places_q <= or_3492;
      patches_word_up_q <= ((select_3502 | select_3504) | select_3507) | select_3510;
      patches_word_down_q <= ((select_3513 | select_3515) | select_3518) | select_3521;
      patches_sum_places_q <= select_3531;
      patches_sum_up_q <= select_3534;
      patches_sum_down_q <= select_3537;
      patches_across_q <= sum_3549;
      patches_places_q <= select_3560;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3564;
      patches_complete_q <= select_3566;
      patches_round_ends_q <= and_3572;
      patches_found_q <= and_3553 ? select_3575 : patches_found_q;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_suspected_q <= patches_round_ends_q ? now_2 : patches_suspected_q;
      patches_moved_q <= select_3584;
      patches_settled_q <= select_3587;
      segment_textured_q <= select_1894 + {5'h0, and_2413};
      segment_explained_q <= select_1899 + {5'h0, and_2418};
      segment_nearer_q <= select_1905 + {5'h0, and_2423};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1470_s4_q ? select_3660 : good_q;
      good_known_q <= select_3664;
      hidden_for_q <= select_3678;
      product_q <= equal_1470_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3699;
      disagree_q <= equal_1470_s4_q ? select_3652 : disagree_q;
      too_much_q <= equal_1470_s4_q ? select_3709 : too_much_q;
      hides_q <= equal_1470_s4_q ? select_3673 : hides_q;
      proven_q <= and_1864_s4_q ? select_3819 : proven_q;
      seen_q <= select_3877;
      nearer_q <= select_3883;
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
      averager_quarter_1_0_q <= select_2048;
      averager_quarter_1_1_q <= select_2050;
      averager_quarter_2_0_q <= select_2052;
      averager_quarter_2_1_q <= select_2054;
      averager_detail_0_q <= select_2066;
      averager_detail_1_q <= select_2074;
      census_changes_values_0_left_q <= and_501_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_501_s4_q ? sum_2157 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2159;
      census_changes_values_1_right_q <= select_2160;
      census_changes_values_2_left_q <= select_2161;
      census_changes_values_2_right_q <= select_2162;
      sharpness_last_mask_q <= and_501_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_501_s4_q ? select_2178[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_501_s4_q ? select_2178[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_3821_s5_q;
  logic or_3885_s5_q;
  logic and_3886_s5_q;
  logic and_3895_s5_q;
  logic and_3898_s5_q;
  logic and_3904_s5_q;
  logic and_3908_s5_q;
  logic and_3914_s5_q;
  logic and_3918_s5_q;
  logic and_3926_s5_q;
  logic and_3930_s5_q;
  logic [5:0] select_3932_s5_q;
  logic [31:0] select_3949_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_3821_s5_q <= said_q;
      or_3885_s5_q <= not_3884 | select_3877;
      and_3886_s5_q <= cfg_prove_i & select_3883;
      and_3895_s5_q <= equal_1470_s4_q & (equal_3568_s4_q & (cfg_prove_i & or_3892));
      and_3898_s5_q <= equal_1470_s4_q & (equal_3568_s4_q & (cfg_prove_i & or_3644));
      and_3904_s5_q <= and_3904;
      and_3908_s5_q <= equal_1470_s4_q & and_3907;
      and_3914_s5_q <= equal_1470_s4_q & (equal_3568_s4_q & (not_3900 & or_3911));
      and_3918_s5_q <= and_3918;
      and_3926_s5_q <= equal_1470_s4_q & (equal_3568_s4_q & (cfg_prove_i & and_3923));
      and_3930_s5_q <= and_3930;
      select_3932_s5_q <= equal_1470_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3949_s5_q <= equal_1470_s4_q ? (x_s4_q[6] ? select_3947 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_3885_s5_q;
  assign marks_nearer_o = and_3886_s5_q;
  assign verdict_valid_o = and_3821_s5_q;
  assign verdict_unproven_yet_o = and_3895_s5_q;
  assign verdict_untextured_o = and_3898_s5_q;
  assign verdict_disagree_o = and_3904_s5_q;
  assign verdict_moved_o = and_3908_s5_q;
  assign verdict_unsharp_left_o = and_3914_s5_q;
  assign verdict_unsharp_right_o = and_3918_s5_q;
  assign verdict_hidden_o = and_3926_s5_q;
  assign frame_valid_o = and_3930_s5_q;
  assign frame_index_o = select_3932_s5_q;
  assign frame_word_o = select_3949_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_3523[1:0], product_3414[4:0], sum_2509[0], detail_4[1:0], detail_3[1:0], sum_2167[4:0], sum_1623[0], sum_1619[0], sum_614[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
