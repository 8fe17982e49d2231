// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2948 bits, pipeline 895 bits, memories 58067 bits.
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
  input  logic [4:0] cfg_on_skin_limit_i,
  input  logic cfg_alarm_before_i,
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
  output logic verdict_overlooked_o,
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
  logic [5:0] sum_2389;
  assign sum_2389 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3402;
  assign difference_3402 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_3677;
  assign difference_3677 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_3910;
  assign less_3910 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_3911;
  assign sum_3911 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_3912;
  assign select_3912 = less_3910 ? {sum_3911, cfg_height_i[5:3]} : 8'h0;
  logic not_3947;
  assign not_3947 = ~cfg_prove_i;

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
  logic shift_first_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_483;
  assign select_483 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_485;
  assign select_485 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [7:0] select_488;
  assign select_488 = ({select_485, select_483} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:116
  logic [7:0] select_489;
  assign select_489 = select_483[0] ? averager_place_q : select_488;
  // hls/stages/census.hpp:41
  logic or_490;
  assign or_490 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:408
  logic and_493;
  assign and_493 = (select_483[0] & or_490) & (select_489 < 8'hbd);
  // hls/stages/census.hpp:41
  logic [2:0] select_498;
  assign select_498 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:267
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_485 : 6'h0;
  // hls/stages/census.hpp:50
  logic equal_515;
  assign equal_515 = select_483 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_516;
  assign equal_516 = select_498 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_517;
  assign and_517 = equal_516 & and_493;
  // hls/stages/agreement.hpp:267
  logic and_519;
  assign and_519 = sample_pair_whole_q & (equal_515 & and_517);
  // hls/stages/agreement.hpp:191
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:614
  logic equal_539;
  assign equal_539 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:585
  logic or_540;
  assign or_540 = so | equal_539;
  // hls/stages/agreement.hpp:708
  logic not_541;
  assign not_541 = ~or_540;
  // hls/stages/agreement.hpp:605
  logic equal_542;
  assign equal_542 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:606
  logic equal_544;
  assign equal_544 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:583
  logic [7:0] sum_545;
  assign sum_545 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:585
  logic [7:0] select_546;
  assign select_546 = run_shift_q[5] ? x_q : sum_545;
  logic less_547;
  assign less_547 = {2'h0, last_q} < select_546;
  // hls/stages/agreement.hpp:219
  logic not_548;
  assign not_548 = ~less_547;
  // hls/stages/agreement.hpp:144
  logic and_549;
  assign and_549 = equal_544 & not_548;
  logic and_551;
  assign and_551 = not_541 & ((~equal_542) & and_549);
  // hls/stages/census.hpp:41
  logic [5:0] select_578;
  assign select_578 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:267
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_578 : 6'h0;
  // hls/stages/agreement.hpp:144
  logic select_635;
  assign select_635 = equal_542 ? not_548 : and_549;
  // hls/stages/agreement.hpp:786
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:784
  logic [6:0] sum_655;
  assign sum_655 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:144
  logic and_660;
  assign and_660 = equal_542 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_655} < select_546))));
  logic select_661;
  assign select_661 = or_540 ? not_548 : and_660;
  // hls/stages/agreement.hpp:807
  logic [5:0] right;
  assign right = sum_545[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:185
  logic and_1871;
  assign and_1871 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:267
  logic [2:0] select_2036;
  assign select_2036 = sample_pair_whole_q ? (sample_last_q ? (select_498 + 3'h1) : select_498) : raster_at_y_q;
  logic [5:0] select_2038;
  assign select_2038 = sample_pair_whole_q ? (select_485 + {5'h0, equal_515}) : raster_at_column_q;
  logic [5:0] select_2041;
  assign select_2041 = sample_pair_whole_q ? (sample_last_q ? (select_578 + {5'h0, equal_516}) : select_578) : raster_at_row_q;
  logic select_2045;
  assign select_2045 = sample_pair_whole_q ? (sample_last_q ? (or_490 & (~raster_final_row_q)) : or_490) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2047;
  assign select_2047 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:267
  logic select_2051;
  assign select_2051 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:450
  logic equal_2295;
  assign equal_2295 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:455
  logic and_2296;
  assign and_2296 = and_519 & equal_2295;
  // hls/stages/agreement.hpp:514
  logic select_2299;
  assign select_2299 = (and_2296 | (~ends_cell_q)) ? and_2296 : ends_q;
  // hls/stages/agreement.hpp:520
  logic [2:0] now;
  assign now = select_2299 ? (and_2296 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:525
  logic [5:0] select_2303;
  assign select_2303 = select_2299 ? (and_2296 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2306;
  assign select_2306 = select_2299 ? (following_last_shift_q & (~and_2296)) : run_last_shift_q;
  // hls/stages/agreement.hpp:598
  logic and_2309;
  assign and_2309 = run_last_shift_q & equal_542;
  // hls/stages/agreement.hpp:607
  logic select_2311;
  assign select_2311 = equal_542 ? (~run_last_shift_q) : equal_544;
  // hls/stages/agreement.hpp:611
  logic equal_2312;
  assign equal_2312 = run_phase_q == 3'h1;
  logic not_2315;
  assign not_2315 = ~select_2311;
  // hls/stages/agreement.hpp:614
  logic equal_2317;
  assign equal_2317 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:598
  logic and_2318;
  assign and_2318 = final_row_q & so;
  // hls/stages/agreement.hpp:611
  logic [1:0] select_2319;
  assign select_2319 = equal_2317 ? 2'h1 : {2{and_2318}};
  logic [2:0] select_2321;
  assign select_2321 = (and_2309 | (select_2311 | equal_2312)) ? (equal_2312 ? 3'h2 : {not_2315, {2{select_2311}}}) : (equal_539 ? 3'h6 : {select_2319[0], select_2319});
  // hls/stages/agreement.hpp:598
  logic and_2324;
  assign and_2324 = select_2311 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:621
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2327;
  assign select_2327 = (plan_shift_q[5] & select_2311) ? value : 7'h0;
  logic [1:0] or_2328;
  assign or_2328 = {2{so}} | select_2327[5:4];
  // hls/stages/agreement.hpp:624
  logic [7:0] select_2329;
  assign select_2329 = select_2311 ? plan_columns_q : 8'h0;
  logic [6:0] or_2332;
  assign or_2332 = select_2329[6:0] | ((equal_2312 | equal_2317) ? whole_q : 7'h0);
  logic [1:0] or_2333;
  assign or_2333 = {2{and_2309}} | or_2332[3:2];
  // hls/stages/agreement.hpp:625
  logic [6:0] or_2335;
  assign or_2335 = {or_2332[6:4], or_2333, or_2332[1:0]} | (equal_539 ? drawn_q : 7'h0);
  logic [4:0] or_2336;
  assign or_2336 = {5{so}} | {or_2335[6], or_2335[3:0]};
  // hls/stages/agreement.hpp:631
  logic not_2340;
  assign not_2340 = ~run_shift_q[5];
  logic [6:0] difference_2342;
  assign difference_2342 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2343;
  assign select_2343 = equal_542 ? ({{7{not_2340}}, 1'b1} + run_span_q) : {difference_2342[6], difference_2342};
  // hls/stages/agreement.hpp:514
  logic [6:0] select_2347;
  assign select_2347 = and_2296 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:517
  logic [7:0] select_2349;
  assign select_2349 = select_2299 ? {select_2347[6], select_2347} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2352;
  assign select_2352 = select_2299 ? (and_2296 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:511
  logic [5:0] select_2360;
  assign select_2360 = and_519 ? (equal_2295 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2363;
  assign select_2363 = and_519 ? (equal_2295 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2366;
  assign select_2366 = and_519 ? (equal_2295 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:522
  logic select_2380;
  assign select_2380 = (ends_cell_q | select_2299) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_542 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:517
  logic and_2384;
  assign and_2384 = (~select_2299) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:467
  logic [6:0] sum_2385;
  assign sum_2385 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:451
  logic select_2387;
  assign select_2387 = equal_2295 ? ({sum_2385[6], cfg_height_i[8:3]} == {1'b0, sum_2385[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:370
  logic or_2778;
  assign or_2778 = select_485[0] | select_578[5];
  logic [7:0] sum_2779;
  assign sum_2779 = {1'b0, select_485[2:1], or_2778, select_578[4:1]} + 8'h1;
  logic less_2780;
  assign less_2780 = {sum_2779, select_578[0], select_498, 1'b0} < {4'h0, cfg_height_i};

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1309; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
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
  assign fresh_re = s0_en & and_551;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:1310; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign left_re = s0_en & (or_540 ? not_548 : select_635);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:1311; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_542 ? sum_545[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_541 & select_635);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 46, DISTANCE 12, hls/stages/agreement.hpp:1312; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [45:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 46'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_540 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_661;
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
      shift_first_q <= 1'b0;
    end else if (s0_en) begin
      left_first_q <= and_1871 ? left_first_q : marks_first_i;
      right_q <= (~and_1871) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1871;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_483 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2036;
      raster_at_column_q <= select_2038;
      raster_at_row_q <= select_2041;
      raster_at_live_q <= select_2045;
      raster_rows_left_q <= sample_pair_whole_q ? select_2047 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2051;
      averager_place_q <= sample_pair_whole_q ? select_489 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2303;
      run_last_shift_q <= select_2306;
      run_span_q <= select_2299 ? (and_2296 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2321;
      following_shift_q <= select_2311 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2324;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2327[6], or_2328, select_2327[3:0]};
      following_columns_q <= {select_2329[7], or_2336[4], or_2335[5:4], or_2336[3:0]};
      plan_shift_q <= equal_542 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2343;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2349;
      columns_left_q <= select_2352;
      last_q <= and_519 ? (equal_2295 ? column : last_q) : last_q;
      least_q <= select_2360;
      whole_q <= select_2363;
      drawn_q <= select_2366;
      age_q <= select_2299 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2299 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2380;
      ends_q <= and_2384;
      final_row_q <= and_519 ? select_2387 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
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
  logic shift_first_s1_q;
  logic [2:0] select_483_s1_q;
  logic [5:0] select_485_s1_q;
  logic [7:0] select_489_s1_q;
  logic and_493_s1_q;
  logic equal_499_s1_q;
  logic [5:0] column_s1_q;
  logic and_517_s1_q;
  logic and_519_s1_q;
  logic so_s1_q;
  logic equal_539_s1_q;
  logic or_540_s1_q;
  logic equal_542_s1_q;
  logic less_547_s1_q;
  logic not_548_s1_q;
  logic and_551_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_661_s1_q;
  logic and_1459_s1_q;
  logic [5:0] right_s1_q;
  logic equal_1467_s1_q;
  logic equal_1477_s1_q;
  logic equal_1596_s1_q;
  logic equal_2295_s1_q;
  logic and_2296_s1_q;
  logic not_2781_s1_q;
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
      shift_first_s1_q <= shift_first_q;
      select_483_s1_q <= select_483;
      select_485_s1_q <= select_485;
      select_489_s1_q <= select_489;
      and_493_s1_q <= and_493;
      equal_499_s1_q <= select_498 == 3'h0;
      column_s1_q <= column;
      and_517_s1_q <= and_517;
      and_519_s1_q <= and_519;
      so_s1_q <= so;
      equal_539_s1_q <= equal_539;
      or_540_s1_q <= or_540;
      equal_542_s1_q <= equal_542;
      less_547_s1_q <= less_547;
      not_548_s1_q <= not_548;
      and_551_s1_q <= and_551;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_661_s1_q <= select_661;
      and_1459_s1_q <= not_541 & and_660;
      right_s1_q <= right;
      equal_1467_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      equal_1477_s1_q <= run_phase_q == 3'h7;
      equal_1596_s1_q <= {or_490, select_498} == 4'hc;
      equal_2295_s1_q <= equal_2295;
      and_2296_s1_q <= and_2296;
      not_2781_s1_q <= ~less_2780;
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
  // hls/stages/agreement.hpp:657
  logic not_639;
  assign not_639 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:660
  logic and_640;
  assign and_640 = left_rdata_q[12] & not_639;
  logic and_641;
  assign and_641 = left_rdata_q[28] & not_639;
  logic and_642;
  assign and_642 = left_rdata_q[44] & not_639;
  logic and_643;
  assign and_643 = left_rdata_q[60] & not_639;
  // hls/stages/agreement.hpp:661
  logic and_647;
  assign and_647 = right_codes_rdata_q[12] & not_639;
  logic and_648;
  assign and_648 = right_codes_rdata_q[25] & not_639;
  logic and_649;
  assign and_649 = right_codes_rdata_q[38] & not_639;
  logic and_650;
  assign and_650 = right_codes_rdata_q[51] & not_639;
  logic and_651;
  assign and_651 = right_codes_rdata_q[64] & not_639;
  logic and_652;
  assign and_652 = right_codes_rdata_q[77] & not_639;
  // hls/stages/agreement.hpp:215
  logic and_667;
  assign and_667 = left_rdata_q[44] & not_548_s1_q;
  logic and_668;
  assign and_668 = right_codes_rdata_q[38] & not_548_s1_q;
  logic [11:0] select_669;
  assign select_669 = less_547_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_670;
  assign select_670 = less_547_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_674;
  assign select_674 = and_667 ? (and_668 ? (~(select_669 ^ select_670)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_680;
  assign parity_680 = ^select_674[5:3];
  logic parity_683;
  assign parity_683 = ^select_674[8:6];
  logic parity_686;
  assign parity_686 = ^select_674[11:3];
  // hls/stages/agreement.hpp:215
  logic and_690;
  assign and_690 = left_rdata_q[60] & not_548_s1_q;
  logic and_691;
  assign and_691 = right_codes_rdata_q[51] & not_548_s1_q;
  logic [11:0] select_692;
  assign select_692 = less_547_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_693;
  assign select_693 = less_547_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_697;
  assign select_697 = and_690 ? (and_691 ? (~(select_692 ^ select_693)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_700;
  assign parity_700 = ^select_697[8:6];
  logic parity_703;
  assign parity_703 = ^select_697[11:9];
  // hls/stages/agreement.hpp:215
  logic and_707;
  assign and_707 = left_rdata_q[76] & not_548_s1_q;
  logic and_708;
  assign and_708 = right_codes_rdata_q[64] & not_548_s1_q;
  logic [11:0] select_709;
  assign select_709 = less_547_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_710;
  assign select_710 = less_547_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_714;
  assign select_714 = and_707 ? (and_708 ? (~(select_709 ^ select_710)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_720;
  assign parity_720 = ^select_714[2:0];
  logic parity_723;
  assign parity_723 = ^select_714[5:3];
  logic parity_726;
  assign parity_726 = ^select_714[8:0];
  logic parity_732;
  assign parity_732 = ^select_714[11:9];
  logic parity_735;
  assign parity_735 = ^select_697[2:0];
  logic parity_738;
  assign parity_738 = ^{select_714[11:9], select_697[5:0]};
  logic parity_741;
  assign parity_741 = ^{select_714, select_697, select_674[2:0]};
  logic xor_742;
  assign xor_742 = parity_686 ^ parity_741;
  // hls/stages/count_bits.hpp:23
  logic or_746;
  assign or_746 = (select_674[1:0] == 2'h3) | (select_674[2] & (select_674[0] | select_674[1]));
  // hls/stages/count_bits.hpp:25
  logic or_750;
  assign or_750 = (select_697[7:6] == 2'h3) | (select_697[8] & (select_697[6] | select_697[7]));
  logic or_754;
  assign or_754 = (select_697[10:9] == 2'h3) | (select_697[11] & (select_697[9] | select_697[10]));
  // hls/stages/count_bits.hpp:23
  logic or_762;
  assign or_762 = (select_714[7:6] == 2'h3) | (select_714[8] & (~(select_714[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_766;
  assign or_766 = (select_714[1:0] == 2'h3) | (select_714[2] & (select_714[0] | select_714[1]));
  logic or_770;
  assign or_770 = (select_714[4:3] == 2'h3) | (select_714[5] & (select_714[3] | select_714[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_773;
  assign parity_773 = ^{or_770, or_766, or_762};
  // hls/stages/count_bits.hpp:23
  logic or_777;
  assign or_777 = (select_697[4:3] == 2'h3) | (select_697[5] & (select_697[3] | select_697[4]));
  // hls/stages/count_bits.hpp:25
  logic or_781;
  assign or_781 = (select_714[10:9] == 2'h3) | (select_714[11] & (select_714[9] | select_714[10]));
  logic or_785;
  assign or_785 = (select_697[1:0] == 2'h3) | (select_697[2] & (select_697[0] | select_697[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_788;
  assign parity_788 = ^{or_785, or_781, or_777};
  logic parity_791;
  assign parity_791 = ^{or_785, or_781, or_777, or_770, or_766, or_762, or_754, or_750, or_746};
  // hls/stages/count_bits.hpp:25
  logic and_792;
  assign and_792 = parity_686 & parity_741;
  logic or_796;
  assign or_796 = (parity_680 & parity_683) | ((^select_674[11:9]) & (parity_680 | parity_683));
  logic and_799;
  assign and_799 = (^{select_697[11:6], select_674[2:0]}) & (parity_726 | parity_738);
  logic or_800;
  assign or_800 = (parity_726 & parity_738) | and_799;
  // hls/stages/count_bits.hpp:23
  logic or_807;
  assign or_807 = (select_674[10:9] == 2'h3) | (select_674[11] & (select_674[9] | select_674[10]));
  // hls/stages/count_bits.hpp:25
  logic or_811;
  assign or_811 = (select_674[4:3] == 2'h3) | (select_674[5] & (select_674[3] | select_674[4]));
  logic or_815;
  assign or_815 = (select_674[7:6] == 2'h3) | (select_674[8] & (select_674[6] | select_674[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_818;
  assign parity_818 = ^{or_815, or_811, or_807};
  // hls/stages/count_bits.hpp:25
  logic or_822;
  assign or_822 = (parity_700 & parity_703) | ((^select_674[2:0]) & (parity_700 | parity_703));
  logic or_826;
  assign or_826 = (parity_720 & parity_723) | ((^select_714[8:6]) & (parity_720 | parity_723));
  logic or_830;
  assign or_830 = (parity_732 & parity_735) | ((^select_697[5:3]) & (parity_732 | parity_735));
  // hls/stages/count_bits.hpp:24
  logic parity_833;
  assign parity_833 = ^{or_830, or_826, or_822};
  logic parity_836;
  assign parity_836 = ^{or_830, or_826, or_822, or_815, or_811, or_807, or_800, or_796, and_792};
  logic xor_837;
  assign xor_837 = parity_791 ^ parity_836;
  // hls/stages/count_bits.hpp:25
  logic and_838;
  assign and_838 = parity_791 & parity_836;
  logic or_842;
  assign or_842 = (parity_773 & parity_788) | ((^{or_754, or_750, or_746}) & (parity_773 | parity_788));
  logic or_846;
  assign or_846 = (parity_818 & parity_833) | ((^{or_800, or_796, and_792}) & (parity_818 | parity_833));
  logic or_853;
  assign or_853 = (or_750 & or_754) | (or_746 & (or_750 | or_754));
  logic or_857;
  assign or_857 = (or_766 & or_770) | (or_762 & (or_766 | or_770));
  logic or_861;
  assign or_861 = (or_781 & or_785) | (or_777 & (or_781 | or_785));
  // hls/stages/count_bits.hpp:24
  logic parity_864;
  assign parity_864 = ^{or_861, or_857, or_853};
  // hls/stages/count_bits.hpp:25
  logic or_868;
  assign or_868 = (or_796 & or_800) | (and_792 & (or_796 | or_800));
  logic or_872;
  assign or_872 = (or_811 & or_815) | (or_807 & (or_811 | or_815));
  logic or_876;
  assign or_876 = (or_826 & or_830) | (or_822 & (or_826 | or_830));
  // hls/stages/count_bits.hpp:24
  logic parity_879;
  assign parity_879 = ^{or_876, or_872, or_868};
  logic parity_882;
  assign parity_882 = ^{or_876, or_872, or_868, or_861, or_857, or_853, or_846, or_842, and_838};
  // hls/stages/count_bits.hpp:25
  logic or_886;
  assign or_886 = (parity_864 & parity_879) | ((^{or_846, or_842, and_838}) & (parity_864 | parity_879));
  logic or_890;
  assign or_890 = (or_842 & or_846) | (and_838 & (or_842 | or_846));
  logic or_894;
  assign or_894 = (or_857 & or_861) | (or_853 & (or_857 | or_861));
  logic or_898;
  assign or_898 = (or_872 & or_876) | (or_868 & (or_872 | or_876));
  // hls/stages/count_bits.hpp:24
  logic parity_903;
  assign parity_903 = ^{or_898, or_894, or_890, or_886};
  // hls/stages/count_bits.hpp:25
  logic or_907;
  assign or_907 = (or_894 & or_898) | (or_890 & (or_894 | or_898));
  logic and_908;
  assign and_908 = or_886 & (^{or_898, or_894, or_890});
  // hls/stages/count_bits.hpp:24
  logic xor_909;
  assign xor_909 = or_907 ^ and_908;
  // hls/stages/count_bits.hpp:27
  logic and_910;
  assign and_910 = or_907 & and_908;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_911;
  assign select_911 = equal_542_s1_q ? {and_910, xor_909, parity_903, parity_882, xor_837, xor_742} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_540_s1_q ? 6'h0 : select_911;
  // hls/stages/agreement.hpp:673
  logic [11:0] select_922;
  assign select_922 = (slot_s1_q[0] ? and_708 : and_691) ? (~(select_670 ^ (slot_s1_q[0] ? select_709 : select_692))) : 12'h0;
  logic [11:0] select_923;
  assign select_923 = and_667 ? select_922 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_929;
  assign parity_929 = ^select_923[5:3];
  logic parity_932;
  assign parity_932 = ^select_923[8:6];
  logic parity_935;
  assign parity_935 = ^select_923[11:3];
  // hls/stages/agreement.hpp:215
  logic and_939;
  assign and_939 = right_codes_rdata_q[77] & not_548_s1_q;
  logic [11:0] select_941;
  assign select_941 = less_547_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_945;
  assign select_945 = (slot_s1_q[0] ? and_939 : and_708) ? (~(select_693 ^ (slot_s1_q[0] ? select_941 : select_709))) : 12'h0;
  logic [11:0] select_946;
  assign select_946 = and_690 ? select_945 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_949;
  assign parity_949 = ^select_946[8:6];
  logic parity_952;
  assign parity_952 = ^select_946[11:9];
  // hls/stages/agreement.hpp:722
  logic select_957;
  assign select_957 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_548_s1_q) : and_939;
  logic [11:0] select_959;
  assign select_959 = slot_s1_q[0] ? (less_547_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_941;
  // hls/stages/agreement.hpp:673
  logic [11:0] select_963;
  assign select_963 = and_707 ? (select_957 ? (~(select_710 ^ select_959)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_969;
  assign parity_969 = ^select_963[2:0];
  logic parity_972;
  assign parity_972 = ^select_963[5:3];
  logic parity_975;
  assign parity_975 = ^select_963[8:0];
  logic parity_981;
  assign parity_981 = ^select_963[11:9];
  logic parity_984;
  assign parity_984 = ^select_946[2:0];
  logic parity_987;
  assign parity_987 = ^{select_963[11:9], select_946[5:0]};
  logic parity_990;
  assign parity_990 = ^{select_963, select_946, select_923[2:0]};
  logic xor_991;
  assign xor_991 = parity_935 ^ parity_990;
  // hls/stages/count_bits.hpp:23
  logic or_995;
  assign or_995 = (select_923[1:0] == 2'h3) | (select_923[2] & (select_923[0] | select_923[1]));
  // hls/stages/count_bits.hpp:25
  logic or_999;
  assign or_999 = (select_946[7:6] == 2'h3) | (select_946[8] & (select_946[6] | select_946[7]));
  logic or_1003;
  assign or_1003 = (select_946[10:9] == 2'h3) | (select_946[11] & (select_946[9] | select_946[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1011;
  assign or_1011 = (select_963[7:6] == 2'h3) | (select_963[8] & (~(select_963[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1015;
  assign or_1015 = (select_963[1:0] == 2'h3) | (select_963[2] & (select_963[0] | select_963[1]));
  logic or_1019;
  assign or_1019 = (select_963[4:3] == 2'h3) | (select_963[5] & (select_963[3] | select_963[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1022;
  assign parity_1022 = ^{or_1019, or_1015, or_1011};
  // hls/stages/count_bits.hpp:23
  logic or_1026;
  assign or_1026 = (select_946[4:3] == 2'h3) | (select_946[5] & (select_946[3] | select_946[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1030;
  assign or_1030 = (select_963[10:9] == 2'h3) | (select_963[11] & (select_963[9] | select_963[10]));
  logic or_1034;
  assign or_1034 = (select_946[1:0] == 2'h3) | (select_946[2] & (select_946[0] | select_946[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1037;
  assign parity_1037 = ^{or_1034, or_1030, or_1026};
  logic parity_1040;
  assign parity_1040 = ^{or_1034, or_1030, or_1026, or_1019, or_1015, or_1011, or_1003, or_999, or_995};
  // hls/stages/count_bits.hpp:25
  logic and_1041;
  assign and_1041 = parity_935 & parity_990;
  logic or_1045;
  assign or_1045 = (parity_929 & parity_932) | ((^select_923[11:9]) & (parity_929 | parity_932));
  logic and_1048;
  assign and_1048 = (^{select_946[11:6], select_923[2:0]}) & (parity_975 | parity_987);
  logic or_1049;
  assign or_1049 = (parity_975 & parity_987) | and_1048;
  // hls/stages/count_bits.hpp:23
  logic or_1056;
  assign or_1056 = (select_923[10:9] == 2'h3) | (select_923[11] & (select_923[9] | select_923[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1060;
  assign or_1060 = (select_923[4:3] == 2'h3) | (select_923[5] & (select_923[3] | select_923[4]));
  logic or_1064;
  assign or_1064 = (select_923[7:6] == 2'h3) | (select_923[8] & (select_923[6] | select_923[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1067;
  assign parity_1067 = ^{or_1064, or_1060, or_1056};
  // hls/stages/count_bits.hpp:25
  logic or_1071;
  assign or_1071 = (parity_949 & parity_952) | ((^select_923[2:0]) & (parity_949 | parity_952));
  logic or_1075;
  assign or_1075 = (parity_969 & parity_972) | ((^select_963[8:6]) & (parity_969 | parity_972));
  logic or_1079;
  assign or_1079 = (parity_981 & parity_984) | ((^select_946[5:3]) & (parity_981 | parity_984));
  // hls/stages/count_bits.hpp:24
  logic parity_1082;
  assign parity_1082 = ^{or_1079, or_1075, or_1071};
  logic parity_1085;
  assign parity_1085 = ^{or_1079, or_1075, or_1071, or_1064, or_1060, or_1056, or_1049, or_1045, and_1041};
  logic xor_1086;
  assign xor_1086 = parity_1040 ^ parity_1085;
  // hls/stages/count_bits.hpp:25
  logic and_1087;
  assign and_1087 = parity_1040 & parity_1085;
  logic or_1091;
  assign or_1091 = (parity_1022 & parity_1037) | ((^{or_1003, or_999, or_995}) & (parity_1022 | parity_1037));
  logic or_1095;
  assign or_1095 = (parity_1067 & parity_1082) | ((^{or_1049, or_1045, and_1041}) & (parity_1067 | parity_1082));
  logic or_1102;
  assign or_1102 = (or_999 & or_1003) | (or_995 & (or_999 | or_1003));
  logic or_1106;
  assign or_1106 = (or_1015 & or_1019) | (or_1011 & (or_1015 | or_1019));
  logic or_1110;
  assign or_1110 = (or_1030 & or_1034) | (or_1026 & (or_1030 | or_1034));
  // hls/stages/count_bits.hpp:24
  logic parity_1113;
  assign parity_1113 = ^{or_1110, or_1106, or_1102};
  // hls/stages/count_bits.hpp:25
  logic or_1117;
  assign or_1117 = (or_1045 & or_1049) | (and_1041 & (or_1045 | or_1049));
  logic or_1121;
  assign or_1121 = (or_1060 & or_1064) | (or_1056 & (or_1060 | or_1064));
  logic or_1125;
  assign or_1125 = (or_1075 & or_1079) | (or_1071 & (or_1075 | or_1079));
  // hls/stages/count_bits.hpp:24
  logic parity_1128;
  assign parity_1128 = ^{or_1125, or_1121, or_1117};
  logic parity_1131;
  assign parity_1131 = ^{or_1125, or_1121, or_1117, or_1110, or_1106, or_1102, or_1095, or_1091, and_1087};
  // hls/stages/count_bits.hpp:25
  logic or_1135;
  assign or_1135 = (parity_1113 & parity_1128) | ((^{or_1095, or_1091, and_1087}) & (parity_1113 | parity_1128));
  logic or_1139;
  assign or_1139 = (or_1091 & or_1095) | (and_1087 & (or_1091 | or_1095));
  logic or_1143;
  assign or_1143 = (or_1106 & or_1110) | (or_1102 & (or_1106 | or_1110));
  logic or_1147;
  assign or_1147 = (or_1121 & or_1125) | (or_1117 & (or_1121 | or_1125));
  // hls/stages/count_bits.hpp:24
  logic parity_1152;
  assign parity_1152 = ^{or_1147, or_1143, or_1139, or_1135};
  // hls/stages/count_bits.hpp:25
  logic or_1156;
  assign or_1156 = (or_1143 & or_1147) | (or_1139 & (or_1143 | or_1147));
  logic and_1157;
  assign and_1157 = or_1135 & (^{or_1147, or_1143, or_1139});
  // hls/stages/count_bits.hpp:24
  logic xor_1158;
  assign xor_1158 = or_1156 ^ and_1157;
  // hls/stages/count_bits.hpp:27
  logic and_1159;
  assign and_1159 = or_1156 & and_1157;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_1160;
  assign select_1160 = equal_542_s1_q ? {and_1159, xor_1158, parity_1152, parity_1131, xor_1086, xor_991} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_540_s1_q ? 6'h0 : select_1160;
  // hls/stages/agreement.hpp:215
  logic and_1168;
  assign and_1168 = right_codes_rdata_q[25] & not_548_s1_q;
  // hls/stages/agreement.hpp:722
  logic select_1169;
  assign select_1169 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_548_s1_q) : and_1168;
  // hls/stages/agreement.hpp:215
  logic [11:0] select_1171;
  assign select_1171 = less_547_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:722
  logic [11:0] select_1172;
  assign select_1172 = slot_s1_q[0] ? (less_547_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1171;
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1176;
  assign select_1176 = and_667 ? (select_1169 ? (~(select_670 ^ select_1172)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1182;
  assign parity_1182 = ^select_1176[5:3];
  logic parity_1185;
  assign parity_1185 = ^select_1176[8:6];
  logic parity_1188;
  assign parity_1188 = ^select_1176[11:3];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1196;
  assign select_1196 = (slot_s1_q[0] ? and_1168 : and_668) ? (~(select_693 ^ (slot_s1_q[0] ? select_1171 : select_669))) : 12'h0;
  logic [11:0] select_1197;
  assign select_1197 = and_690 ? select_1196 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1200;
  assign parity_1200 = ^select_1197[8:6];
  logic parity_1203;
  assign parity_1203 = ^select_1197[11:9];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1211;
  assign select_1211 = (slot_s1_q[0] ? and_668 : and_691) ? (~(select_710 ^ (slot_s1_q[0] ? select_669 : select_692))) : 12'h0;
  logic [11:0] select_1212;
  assign select_1212 = and_707 ? select_1211 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1218;
  assign parity_1218 = ^select_1212[2:0];
  logic parity_1221;
  assign parity_1221 = ^select_1212[5:3];
  logic parity_1224;
  assign parity_1224 = ^select_1212[8:0];
  logic parity_1230;
  assign parity_1230 = ^select_1212[11:9];
  logic parity_1233;
  assign parity_1233 = ^select_1197[2:0];
  logic parity_1236;
  assign parity_1236 = ^{select_1212[11:9], select_1197[5:0]};
  logic parity_1239;
  assign parity_1239 = ^{select_1212, select_1197, select_1176[2:0]};
  logic xor_1240;
  assign xor_1240 = parity_1188 ^ parity_1239;
  // hls/stages/count_bits.hpp:23
  logic or_1244;
  assign or_1244 = (select_1176[1:0] == 2'h3) | (select_1176[2] & (select_1176[0] | select_1176[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1248;
  assign or_1248 = (select_1197[7:6] == 2'h3) | (select_1197[8] & (select_1197[6] | select_1197[7]));
  logic or_1252;
  assign or_1252 = (select_1197[10:9] == 2'h3) | (select_1197[11] & (select_1197[9] | select_1197[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1260;
  assign or_1260 = (select_1212[7:6] == 2'h3) | (select_1212[8] & (~(select_1212[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1264;
  assign or_1264 = (select_1212[1:0] == 2'h3) | (select_1212[2] & (select_1212[0] | select_1212[1]));
  logic or_1268;
  assign or_1268 = (select_1212[4:3] == 2'h3) | (select_1212[5] & (select_1212[3] | select_1212[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1271;
  assign parity_1271 = ^{or_1268, or_1264, or_1260};
  // hls/stages/count_bits.hpp:23
  logic or_1275;
  assign or_1275 = (select_1197[4:3] == 2'h3) | (select_1197[5] & (select_1197[3] | select_1197[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1279;
  assign or_1279 = (select_1212[10:9] == 2'h3) | (select_1212[11] & (select_1212[9] | select_1212[10]));
  logic or_1283;
  assign or_1283 = (select_1197[1:0] == 2'h3) | (select_1197[2] & (select_1197[0] | select_1197[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1286;
  assign parity_1286 = ^{or_1283, or_1279, or_1275};
  logic parity_1289;
  assign parity_1289 = ^{or_1283, or_1279, or_1275, or_1268, or_1264, or_1260, or_1252, or_1248, or_1244};
  // hls/stages/count_bits.hpp:25
  logic and_1290;
  assign and_1290 = parity_1188 & parity_1239;
  logic or_1294;
  assign or_1294 = (parity_1182 & parity_1185) | ((^select_1176[11:9]) & (parity_1182 | parity_1185));
  logic and_1297;
  assign and_1297 = (^{select_1197[11:6], select_1176[2:0]}) & (parity_1224 | parity_1236);
  logic or_1298;
  assign or_1298 = (parity_1224 & parity_1236) | and_1297;
  // hls/stages/count_bits.hpp:23
  logic or_1305;
  assign or_1305 = (select_1176[10:9] == 2'h3) | (select_1176[11] & (select_1176[9] | select_1176[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1309;
  assign or_1309 = (select_1176[4:3] == 2'h3) | (select_1176[5] & (select_1176[3] | select_1176[4]));
  logic or_1313;
  assign or_1313 = (select_1176[7:6] == 2'h3) | (select_1176[8] & (select_1176[6] | select_1176[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1316;
  assign parity_1316 = ^{or_1313, or_1309, or_1305};
  // hls/stages/count_bits.hpp:25
  logic or_1320;
  assign or_1320 = (parity_1200 & parity_1203) | ((^select_1176[2:0]) & (parity_1200 | parity_1203));
  logic or_1324;
  assign or_1324 = (parity_1218 & parity_1221) | ((^select_1212[8:6]) & (parity_1218 | parity_1221));
  logic or_1328;
  assign or_1328 = (parity_1230 & parity_1233) | ((^select_1197[5:3]) & (parity_1230 | parity_1233));
  // hls/stages/count_bits.hpp:24
  logic parity_1331;
  assign parity_1331 = ^{or_1328, or_1324, or_1320};
  logic parity_1334;
  assign parity_1334 = ^{or_1328, or_1324, or_1320, or_1313, or_1309, or_1305, or_1298, or_1294, and_1290};
  logic xor_1335;
  assign xor_1335 = parity_1289 ^ parity_1334;
  // hls/stages/count_bits.hpp:25
  logic and_1336;
  assign and_1336 = parity_1289 & parity_1334;
  logic or_1340;
  assign or_1340 = (parity_1271 & parity_1286) | ((^{or_1252, or_1248, or_1244}) & (parity_1271 | parity_1286));
  logic or_1344;
  assign or_1344 = (parity_1316 & parity_1331) | ((^{or_1298, or_1294, and_1290}) & (parity_1316 | parity_1331));
  logic or_1351;
  assign or_1351 = (or_1248 & or_1252) | (or_1244 & (or_1248 | or_1252));
  logic or_1355;
  assign or_1355 = (or_1264 & or_1268) | (or_1260 & (or_1264 | or_1268));
  logic or_1359;
  assign or_1359 = (or_1279 & or_1283) | (or_1275 & (or_1279 | or_1283));
  // hls/stages/count_bits.hpp:24
  logic parity_1362;
  assign parity_1362 = ^{or_1359, or_1355, or_1351};
  // hls/stages/count_bits.hpp:25
  logic or_1366;
  assign or_1366 = (or_1294 & or_1298) | (and_1290 & (or_1294 | or_1298));
  logic or_1370;
  assign or_1370 = (or_1309 & or_1313) | (or_1305 & (or_1309 | or_1313));
  logic or_1374;
  assign or_1374 = (or_1324 & or_1328) | (or_1320 & (or_1324 | or_1328));
  // hls/stages/count_bits.hpp:24
  logic parity_1377;
  assign parity_1377 = ^{or_1374, or_1370, or_1366};
  logic parity_1380;
  assign parity_1380 = ^{or_1374, or_1370, or_1366, or_1359, or_1355, or_1351, or_1344, or_1340, and_1336};
  // hls/stages/count_bits.hpp:25
  logic or_1384;
  assign or_1384 = (parity_1362 & parity_1377) | ((^{or_1344, or_1340, and_1336}) & (parity_1362 | parity_1377));
  logic or_1388;
  assign or_1388 = (or_1340 & or_1344) | (and_1336 & (or_1340 | or_1344));
  logic or_1392;
  assign or_1392 = (or_1355 & or_1359) | (or_1351 & (or_1355 | or_1359));
  logic or_1396;
  assign or_1396 = (or_1370 & or_1374) | (or_1366 & (or_1370 | or_1374));
  // hls/stages/count_bits.hpp:24
  logic parity_1401;
  assign parity_1401 = ^{or_1396, or_1392, or_1388, or_1384};
  // hls/stages/count_bits.hpp:25
  logic or_1405;
  assign or_1405 = (or_1392 & or_1396) | (or_1388 & (or_1392 | or_1396));
  logic and_1406;
  assign and_1406 = or_1384 & (^{or_1396, or_1392, or_1388});
  // hls/stages/count_bits.hpp:24
  logic xor_1407;
  assign xor_1407 = or_1405 ^ and_1406;
  // hls/stages/count_bits.hpp:27
  logic and_1408;
  assign and_1408 = or_1405 & and_1406;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_1409;
  assign select_1409 = equal_542_s1_q ? {and_1408, xor_1407, parity_1401, parity_1380, xor_1335, xor_1240} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_540_s1_q ? 6'h0 : select_1409;
  // hls/stages/agreement.hpp:940
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:941
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:942
  logic [5:0] select_1463;
  assign select_1463 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:945
  logic and_1483;
  assign and_1483 = (or_540_s1_q & (left_rdata_q[61] & not_548_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:238
  logic or_1505;
  assign or_1505 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:776
  logic [5:0] select_1516;
  assign select_1516 = so_s1_q ? x_s1_q[5:0] : (or_540_s1_q ? (less_547_s1_q ? 6'h0 : select_1463) : 6'h0);
  // hls/stages/patches.hpp:122
  logic and_1590;
  assign and_1590 = (select_483_s1_q == 3'h0) & (select_485_s1_q == 6'h0);
  // hls/stages/patches.hpp:391
  logic not_1591;
  assign not_1591 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_1594;
  assign not_1594 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:361
  logic and_1595;
  assign and_1595 = patches_capturing_q & not_1594;
  // hls/stages/patches.hpp:311
  logic equal_1598;
  assign equal_1598 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1603;
  assign and_1603 = (not_1591 & (patches_work_q == 3'h0)) & (~(and_1595 | ((~equal_1596_s1_q) | (~equal_1598))));
  // hls/stages/patches.hpp:529
  logic equal_1690;
  assign equal_1690 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:507
  logic not_1691;
  assign not_1691 = ~equal_1690;
  // hls/stages/patches.hpp:500
  logic equal_1692;
  assign equal_1692 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:453
  logic not_1693;
  assign not_1693 = ~equal_1692;
  // hls/stages/patches.hpp:494
  logic equal_1694;
  assign equal_1694 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1695;
  assign equal_1695 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:529
  logic or_1696;
  assign or_1696 = equal_1694 | equal_1695;
  // hls/stages/patches.hpp:455
  logic not_1697;
  assign not_1697 = ~patches_second_q;
  // hls/stages/patches.hpp:372
  logic [4:0] select_1719;
  assign select_1719 = and_1603 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1720;
  assign select_1720 = and_1590 ? select_1719 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1722;
  assign and_1722 = and_1595 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1726;
  assign select_1726 = and_1590 ? (and_1603 | (and_1595 & (~and_1722))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_1734;
  assign and_1734 = not_1691 & (not_1693 & (or_1696 & (patches_second_q & equal_1695)));
  // hls/stages/patches.hpp:167
  logic not_1751;
  assign not_1751 = ~equal_1695;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_1767;
  assign select_1767 = and_1590 ? {select_1719[4], select_1719[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:453
  logic and_1777;
  assign and_1777 = not_1691 & (or_1696 & not_1693);
  // hls/stages/agreement.hpp:451
  logic select_2392;
  assign select_2392 = equal_2295_s1_q ? (~({row_s1_q, 1'b0} < {sum_2389, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:511
  logic and_2606;
  assign and_2606 = and_519_s1_q & (equal_2295_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2716;
  assign select_2716 = and_1590 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_2717;
  assign select_2717 = sample_pair_whole_s1_q ? select_2716 : patches_phase_q;
  // hls/stages/patches.hpp:372
  logic and_2718;
  assign and_2718 = not_1594 & equal_1596_s1_q;
  logic [8:0] select_2719;
  assign select_2719 = and_2718 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2720;
  assign select_2720 = and_2718 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2721;
  assign select_2721 = sample_pair_first_s1_q ? select_2719 : select_2720;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_2723;
  assign select_2723 = sample_pair_whole_s1_q ? (and_1590 ? select_2721[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2725;
  assign select_2725 = sample_pair_whole_s1_q ? (and_1590 ? select_2721[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2728;
  assign select_2728 = sample_pair_whole_s1_q ? (equal_1598 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2730;
  assign select_2730 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_1598}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2731;
  assign equal_2731 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_2732;
  assign not_2732 = ~equal_2731;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_2734;
  assign select_2734 = sample_pair_whole_s1_q ? (phase + {not_2732, 1'b1, not_2732, equal_2731}) : patches_first_band_rows_to_next_q;
  logic select_2735;
  assign select_2735 = sample_pair_whole_s1_q ? equal_2731 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:461
  logic equal_2736;
  assign equal_2736 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2740;
  assign select_2740 = equal_2736 ? ((select_2717 == 4'h6) ? 4'h0 : (select_2717 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2741;
  assign equal_2741 = select_2740 == 4'h0;
  // hls/stages/agreement.hpp:451
  logic [3:0] select_2744;
  assign select_2744 = equal_2295_s1_q ? (equal_2741 ? 4'h6 : (select_2740 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2746;
  assign select_2746 = equal_2736 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:451
  logic [4:0] select_2748;
  assign select_2748 = equal_2295_s1_q ? (select_2746 + {4'h0, equal_2741}) : patches_choosing_number_q;
  logic select_2752;
  assign select_2752 = equal_2295_s1_q ? ((6'h2 < row_s1_q) & equal_2741) : patches_chooses_q;
  // hls/stages/agreement.hpp:511
  logic [4:0] select_2755;
  assign select_2755 = and_519_s1_q ? (equal_2295_s1_q ? select_2746 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:126
  logic select_2783;
  assign select_2783 = and_1590 ? (and_1603 ? not_2781_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:392
  logic or_2822;
  assign or_2822 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:394
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_2828;
  assign and_2828 = equal_1690 & not_1697;
  // hls/stages/patches.hpp:398
  logic and_2829;
  assign and_2829 = not_1751 & and_2828;
  logic [1:0] select_2831;
  assign select_2831 = equal_1692 ? 2'h0 : (equal_1694 ? 2'h3 : {equal_1695, and_2829});
  // hls/stages/patches.hpp:279
  logic equal_2833;
  assign equal_2833 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_2834;
  assign not_2834 = ~equal_2833;
  // hls/stages/patches.hpp:279
  logic equal_2835;
  assign equal_2835 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_2836;
  assign not_2836 = ~equal_2835;
  // hls/stages/patches.hpp:283
  logic not_2838;
  assign not_2838 = ~(patches_following_q == 3'h2);
  logic and_2841;
  assign and_2841 = (~(patches_following_q == 3'h1)) & not_2838;
  // hls/stages/patches.hpp:396
  logic [1:0] select_2842;
  assign select_2842 = equal_2835 ? 2'h2 : {and_2841, not_2838};
  logic [3:0] select_2843;
  assign select_2843 = equal_2833 ? 4'h2 : {select_2842, {2{not_2836}}};
  // hls/stages/patches.hpp:404
  logic not_2846;
  assign not_2846 = ~or_2822;
  // hls/stages/patches.hpp:393
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:405
  logic [11:0] select_2851;
  assign select_2851 = or_2822 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_2853;
  assign select_2853 = or_2822 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1313; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_540_s1_q ? select_1463 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_661_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s1_en & (not_1691 & (not_1693 & (or_1696 & (equal_1695 & not_1697))));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s1_en & and_1734;
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s1_en & (not_1691 & (not_1693 & (not_1751 & or_1696)));
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:786; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign patches_columns_above_re = s1_en & and_1777;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_551_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_643, left_rdata_q[59:45], and_642, left_rdata_q[43:29], and_641, left_rdata_q[27:13], and_640, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_551_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_652, right_codes_rdata_q[76:65], and_651, right_codes_rdata_q[63:52], and_650, right_codes_rdata_q[50:39], and_649, right_codes_rdata_q[37:26], and_648, right_codes_rdata_q[24:13], and_647, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_519_s1_q ? (equal_2295_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_519_s1_q ? select_2392 : lower_half_q;
      patches_phase_q <= select_2717;
      patches_band_rows_rows_to_next_q <= select_2723;
      patches_band_rows_number_q <= select_2725;
      patches_next_band_rows_to_next_q <= select_2728;
      patches_next_band_number_q <= select_2730;
      patches_first_band_rows_to_next_q <= select_2734;
      patches_first_band_number_q <= select_2735;
      patches_choosing_rows_to_next_q <= and_519_s1_q ? select_2744 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_519_s1_q ? select_2748 : patches_choosing_number_q;
      patches_chooses_q <= and_519_s1_q ? select_2752 : patches_chooses_q;
      patches_choosing_band_q <= select_2755;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_1726 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_2783 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_1720 : patches_row_q;
      patches_work_q <= or_2822 ? following : patches_work_q;
      patches_second_q <= not_1591 & (patches_second_q | (patches_ends_q & equal_1690));
      patches_following_q <= equal_1690 ? {2'h0, and_2828} : {equal_1692, select_2831};
      patches_following_beats_q <= {select_2843, not_2834};
      patches_begins_q <= sample_pair_whole_s1_q & (and_1590 & and_1722);
      patches_ends_q <= not_2846 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2851;
      patches_code_row_q <= select_2853;
      patches_column_q <= or_2822 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2846 & (patches_column_q == 5'h1e);
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
  logic shift_first_s2_q;
  logic [4:0] patches_band_rows_number_s2_q;
  logic patches_chooses_s2_q;
  logic [4:0] patches_choosing_band_s2_q;
  logic patches_lower_s2_q;
  logic patches_second_s2_q;
  logic [4:0] patches_code_row_s2_q;
  logic [4:0] patches_column_s2_q;
  logic [2:0] select_483_s2_q;
  logic [5:0] select_485_s2_q;
  logic [7:0] select_489_s2_q;
  logic and_493_s2_q;
  logic equal_499_s2_q;
  logic [5:0] column_s2_q;
  logic and_517_s2_q;
  logic and_519_s2_q;
  logic so_s2_q;
  logic equal_539_s2_q;
  logic or_540_s2_q;
  logic less_547_s2_q;
  logic not_548_s2_q;
  logic equal_580_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1162_s2_q;
  logic [5:0] select_1411_s2_q;
  logic and_1459_s2_q;
  logic [5:0] right_s2_q;
  logic equal_1467_s2_q;
  logic equal_1477_s2_q;
  logic and_1484_s2_q;
  logic and_1487_s2_q;
  logic and_1491_s2_q;
  logic or_1505_s2_q;
  logic [5:0] select_1516_s2_q;
  logic and_1590_s2_q;
  logic and_1603_s2_q;
  logic less_1617_s2_q;
  logic equal_1690_s2_q;
  logic not_1691_s2_q;
  logic equal_1692_s2_q;
  logic not_1693_s2_q;
  logic equal_1694_s2_q;
  logic equal_1695_s2_q;
  logic or_1696_s2_q;
  logic [4:0] select_1720_s2_q;
  logic select_1726_s2_q;
  logic [3:0] select_1767_s2_q;
  logic and_1777_s2_q;
  logic and_1871_s2_q;
  logic select_1873_s2_q;
  logic and_1876_s2_q;
  logic and_2025_s2_q;
  logic equal_2171_s2_q;
  logic equal_2295_s2_q;
  logic and_2607_s2_q;
  logic and_2609_s2_q;
  logic or_2822_s2_q;
  logic not_2846_s2_q;
  logic less_3655_s2_q;
  logic equal_3860_s2_q;
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
      shift_first_s2_q <= shift_first_s1_q;
      patches_band_rows_number_s2_q <= patches_band_rows_number_q;
      patches_chooses_s2_q <= patches_chooses_q;
      patches_choosing_band_s2_q <= patches_choosing_band_q;
      patches_lower_s2_q <= patches_lower_q;
      patches_second_s2_q <= patches_second_q;
      patches_code_row_s2_q <= patches_code_row_q;
      patches_column_s2_q <= patches_column_q;
      select_483_s2_q <= select_483_s1_q;
      select_485_s2_q <= select_485_s1_q;
      select_489_s2_q <= select_489_s1_q;
      and_493_s2_q <= and_493_s1_q;
      equal_499_s2_q <= equal_499_s1_q;
      column_s2_q <= column_s1_q;
      and_517_s2_q <= and_517_s1_q;
      and_519_s2_q <= and_519_s1_q;
      so_s2_q <= so_s1_q;
      equal_539_s2_q <= equal_539_s1_q;
      or_540_s2_q <= or_540_s1_q;
      less_547_s2_q <= less_547_s1_q;
      not_548_s2_q <= not_548_s1_q;
      equal_580_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      column_2_s2_q <= column_2;
      select_1162_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1411_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1459_s2_q <= and_1459_s1_q;
      right_s2_q <= right_s1_q;
      equal_1467_s2_q <= equal_1467_s1_q;
      equal_1477_s2_q <= equal_1477_s1_q;
      and_1484_s2_q <= not_548_s1_q & and_1483;
      and_1487_s2_q <= (or_540_s1_q & (left_rdata_q[62] & not_548_s1_q)) & and_1483;
      and_1491_s2_q <= not_548_s1_q & (or_540_s1_q & (left_rdata_q[63] & not_548_s1_q));
      or_1505_s2_q <= or_1505;
      select_1516_s2_q <= select_1516;
      and_1590_s2_q <= and_1590;
      and_1603_s2_q <= and_1603;
      less_1617_s2_q <= 5'h4 < row_q[5:1];
      equal_1690_s2_q <= equal_1690;
      not_1691_s2_q <= not_1691;
      equal_1692_s2_q <= equal_1692;
      not_1693_s2_q <= not_1693;
      equal_1694_s2_q <= equal_1694;
      equal_1695_s2_q <= equal_1695;
      or_1696_s2_q <= or_1696;
      select_1720_s2_q <= select_1720;
      select_1726_s2_q <= select_1726;
      select_1767_s2_q <= select_1767;
      and_1777_s2_q <= and_1777;
      and_1871_s2_q <= sample_pair_whole_q;
      select_1873_s2_q <= left_first_q;
      and_1876_s2_q <= right_q;
      and_2025_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2171_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_2295_s2_q <= equal_2295_s1_q;
      and_2607_s2_q <= and_2296_s1_q & and_2606;
      and_2609_s2_q <= and_2296_s1_q & (~and_2606);
      or_2822_s2_q <= or_2822;
      not_2846_s2_q <= not_2846;
      less_3655_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3860_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic shift_allowed_q;
  logic shift_not_right_q;
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
  logic and_494;
  assign and_494 = sample_pair_whole_s2_q & and_493_s2_q;
  // hls/stages/agreement.hpp:795
  logic or_664;
  assign or_664 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:796
  logic select_666;
  assign select_666 = or_664 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:766
  logic [5:0] select_913;
  assign select_913 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_914;
  assign difference_914 = {1'b0, column_2_s2_q} - {1'b0, select_913};
  logic [7:0] sum_916;
  assign sum_916 = {difference_914[6], difference_914} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:743
  logic [7:0] select_917;
  assign select_917 = slot_s2_q[0] ? chosen_score_q : sum_916;
  // hls/stages/agreement.hpp:766
  logic [6:0] difference_1163;
  assign difference_1163 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1162_s2_q};
  // hls/stages/agreement.hpp:737
  logic equal_1164;
  assign equal_1164 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:766
  logic [7:0] sum_1166;
  assign sum_1166 = {difference_1163[6], difference_1163} + (equal_1164 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1412;
  assign difference_1412 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1411_s2_q};
  logic [7:0] sum_1414;
  assign sum_1414 = {difference_1412[6], difference_1412} + (equal_1164 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:739
  logic less_1415;
  assign less_1415 = sum_1166 < sum_1414;
  logic [7:0] select_1416;
  assign select_1416 = less_1415 ? sum_1414 : sum_1166;
  logic less_1417;
  assign less_1417 = select_917 < select_1416;
  // hls/stages/agreement.hpp:789
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1417 ? select_1416 : select_917) : 8'h0;
  // hls/stages/agreement.hpp:796
  logic or_1421;
  assign or_1421 = select_666 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:801
  logic [5:0] select_1422;
  assign select_1422 = or_1421 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:708
  logic not_1423;
  assign not_1423 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:740
  logic [1:0] select_1424;
  assign select_1424 = less_1415 ? {slot_s2_q[0], not_1423} : 2'h0;
  logic [2:0] select_1426;
  assign select_1426 = less_1417 ? {select_1424, not_1423} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:801
  logic [2:0] select_1427;
  assign select_1427 = or_1421 ? select_1426 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1428;
  assign select_1428 = or_1421 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:798
  logic equal_1429;
  assign equal_1429 = select_1426 == 3'h1;
  logic or_1432;
  assign or_1432 = equal_1429 | (~(select_1426 == 3'h2));
  logic [7:0] select_1434;
  assign select_1434 = or_1432 ? before_0_q : before_1_q;
  logic [7:0] select_1435;
  assign select_1435 = equal_1429 ? (or_1432 ? sum_1166 : {7'h0, shift_not_right_q}) : select_1434;
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1436;
  assign select_1436 = or_1421 ? select_1435 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1439;
  assign select_1439 = or_1421 ? (equal_1429 ? select_1434 : (or_1432 ? sum_1414 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1441;
  assign sum_1441 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1442;
  assign sum_1442 = {1'b0, before_v} + sum_1441;
  // hls/stages/agreement.hpp:743
  logic [6:0] select_1443;
  assign select_1443 = slot_s2_q[0] ? chosen_near_q : sum_1442;
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1445;
  assign sum_1445 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1446;
  assign sum_1446 = {1'b0, before_v_2} + sum_1445;
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1448;
  assign sum_1448 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1449;
  assign sum_1449 = {1'b0, before_v_3} + sum_1448;
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1451;
  assign select_1451 = (sum_1446 < sum_1449) ? sum_1449 : sum_1446;
  // hls/stages/agreement.hpp:790
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1443 < select_1451) ? select_1451 : select_1443) : 7'h0;
  // hls/stages/agreement.hpp:801
  logic or_1456;
  assign or_1456 = select_666 | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1457;
  assign select_1457 = or_1456 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1458;
  assign select_1458 = or_1456 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:809
  logic select_1468;
  assign select_1468 = or_664 ? shift_first_s2_q : equal_1467_s2_q;
  // hls/stages/agreement.hpp:810
  logic or_1470;
  assign or_1470 = select_1468 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:814
  logic [7:0] select_1471;
  assign select_1471 = or_1470 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1472;
  assign select_1472 = or_1470 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1474;
  assign or_1474 = select_1468 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:818
  logic [6:0] select_1475;
  assign select_1475 = or_1474 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1476;
  assign select_1476 = or_1474 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:968
  logic not_1478;
  assign not_1478 = ~equal_1477_s2_q;
  // hls/stages/agreement.hpp:238
  logic and_1488;
  assign and_1488 = not_548_s2_q & and_1487_s2_q;
  // hls/stages/agreement.hpp:948
  logic select_1494;
  assign select_1494 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:949
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic [8:0] difference_1497;
  assign difference_1497 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:956
  logic [9:0] sum_1498;
  assign sum_1498 = {difference_1497[8], difference_1497} + 10'h1;
  // hls/stages/agreement.hpp:238
  logic and_1500;
  assign and_1500 = (and_1487_s2_q & select_1494) & ({{22{sum_1498[9]}}, sum_1498} < 32'h3);
  logic and_1501;
  assign and_1501 = not_548_s2_q & and_1500;
  logic and_1507;
  assign and_1507 = not_548_s2_q & (and_1500 & or_1505_s2_q);
  // hls/stages/agreement.hpp:144
  logic [8:0] select_1508;
  assign select_1508 = less_547_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_540_s2_q ? {select_1508, and_1507, and_1501, and_1491_s2_q, and_1488, and_1484_s2_q, not_548_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:776
  logic and_1510;
  assign and_1510 = ends_cell_s2_q & shift_2[0];
  logic and_1512;
  assign and_1512 = not_1478 & (so_s2_q & and_1510);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1620;
  assign select_1620 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1620[16:7])) ? 8'h7f : select_1620[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1695_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1695_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:495
  logic less_1783;
  assign less_1783 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:496
  logic or_1784;
  assign or_1784 = equal_1694_s2_q | less_1783;
  // hls/stages/patches.hpp:499
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1789;
  assign select_1789 = equal_1694_s2_q ? patches_column_s2_q[0] : (or_1784 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1790;
  assign not_1790 = ~or_1784;
  // hls/stages/patches.hpp:496
  logic [4:0] sum_1791;
  assign sum_1791 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:498
  logic [4:0] select_1794;
  assign select_1794 = or_1784 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1791) + 5'h1) : sum_1791;
  // hls/stages/patches.hpp:500
  logic [4:0] select_1795;
  assign select_1795 = equal_1694_s2_q ? 5'h0 : select_1794;
  logic or_1796;
  assign or_1796 = equal_1694_s2_q | equal_1692_s2_q;
  // hls/stages/patches.hpp:476
  logic equal_1798;
  assign equal_1798 = patches_column_s2_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s2_q == 5'h11;
  logic equal_1800;
  assign equal_1800 = patches_column_s2_q == 5'h18;
  // hls/stages/patches.hpp:478
  logic and_1802;
  assign and_1802 = of_row & (~equal_1800);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1798 ? 2'h3 : {equal_1800, and_1802};
  // hls/stages/patches.hpp:464
  logic [8:0] sum_1805;
  assign sum_1805 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1806;
  assign sum_1806 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1805, pixel_2[0]} - {1'b0, sum_1806, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:466
  logic [11:0] sum_1808;
  assign sum_1808 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1809;
  assign sum_1809 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1808[11], sum_1808};
  logic [13:0] sum_1810;
  assign sum_1810 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1809, down_2[1]};
  logic [12:0] sum_1811;
  assign sum_1811 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1810[13:1];
  logic [14:0] sum_1812;
  assign sum_1812 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1811, sum_1810[0], down_2[0]};
  // hls/stages/patches.hpp:462
  logic [8:0] sum_1815;
  assign sum_1815 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1816;
  assign sum_1816 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1815};
  logic [10:0] sum_1817;
  assign sum_1817 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1816, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1818;
  assign sum_1818 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1817[10:1];
  // hls/stages/patches.hpp:463
  logic [11:0] smooth;
  assign smooth = {sum_1818, sum_1817[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:465
  logic [12:0] sum_1820;
  assign sum_1820 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1821;
  assign sum_1821 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1822;
  assign difference_1822 = {1'b0, sum_1820, smooth[0]} - {1'b0, sum_1821, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:477
  logic or_1828;
  assign or_1828 = (((patches_column_s2_q == 5'ha) | of_row) | equal_1800) | equal_1798;
  // hls/stages/patches.hpp:472
  logic and_1833;
  assign and_1833 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_1837;
  assign and_1837 = not_1693_s2_q & (or_1696_s2_q & (or_1828 & (equal_1695_s2_q & and_1833)));
  // hls/stages/patches.hpp:172
  logic and_1847;
  assign and_1847 = (~(equal_1695_s2_q | (~and_1833))) & (~patches_column_s2_q[4]);
  // hls/stages/patches.hpp:184
  logic and_1851;
  assign and_1851 = not_1693_s2_q & (or_1696_s2_q & (and_1847 & (patches_column_s2_q == 5'hf)));
  // hls/stages/patches.hpp:541
  logic less_1853;
  assign less_1853 = patches_step_q[4:0] < 5'h11;
  logic equal_1854;
  assign equal_1854 = patches_step_q[6:5] == 2'h0;
  logic not_1855;
  assign not_1855 = ~equal_1854;
  logic equal_1856;
  assign equal_1856 = patches_step_q[6:5] == 2'h3;
  logic not_1857;
  assign not_1857 = ~equal_1856;
  // hls/stages/patches.hpp:555
  logic select_1860;
  assign select_1860 = equal_1856 ? (less_1853 & (less_1853 & not_1857)) : less_1853;
  // hls/stages/patches.hpp:184
  logic and_1863;
  assign and_1863 = equal_1690_s2_q & (less_1853 ? (not_1855 & select_1860) : select_1860);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1892;
  assign sum_1892 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:253
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:230
  logic [5:0] select_2395;
  assign select_2395 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2396;
  assign select_2396 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2397;
  assign select_2397 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2398;
  assign select_2398 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2399;
  assign select_2399 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2400;
  assign select_2400 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2404;
  assign select_2404 = slot_s2_q[0] ? 8'h0 : sum_916;
  // hls/stages/agreement.hpp:739
  logic less_2405;
  assign less_2405 = select_2404 < select_1416;
  // hls/stages/agreement.hpp:230
  logic [6:0] select_2407;
  assign select_2407 = slot_s2_q[0] ? 7'h0 : sum_1442;
  // hls/stages/agreement.hpp:776
  logic not_2412;
  assign not_2412 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2413;
  assign less_2413 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/registration.hpp:76
  logic less_2504;
  assign less_2504 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:144
  logic [7:0] select_2506;
  assign select_2506 = or_540_s2_q ? (less_547_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2508;
  assign select_2508 = or_540_s2_q ? (less_547_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2510;
  assign select_2510 = or_540_s2_q ? (less_547_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
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
  // hls/stages/agreement.hpp:248
  logic [4:0] select_2527;
  assign select_2527 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2610;
  assign select_2610 = and_2609_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2612;
  assign select_2612 = and_2607_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2610[15]}}, select_2610});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2613;
  assign select_2613 = and_2609_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2613[15]}}, select_2613};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2615;
  assign select_2615 = and_2607_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:144
  logic and_2616;
  assign and_2616 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2616 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_2861;
  assign select_2861 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_2864;
  assign select_2864 = equal_1692_s2_q ? patches_smooth_values_0_q : (or_1696_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_2866;
  assign select_2866 = or_1696_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2868;
  assign select_2868 = equal_1690_s2_q ? patches_smooth_values_1_q : (equal_1692_s2_q ? patches_smooth_values_1_q : select_2866);
  logic [11:0] select_2869;
  assign select_2869 = or_1696_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2871;
  assign select_2871 = equal_1690_s2_q ? patches_smooth_values_2_q : (equal_1692_s2_q ? patches_smooth_values_2_q : select_2869);
  logic [11:0] select_2872;
  assign select_2872 = or_1696_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2874;
  assign select_2874 = equal_1690_s2_q ? patches_smooth_values_3_q : (equal_1692_s2_q ? patches_smooth_values_3_q : select_2872);
  logic [10:0] select_2876;
  assign select_2876 = equal_1692_s2_q ? patches_down_values_0_q : (or_1696_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_2879;
  assign select_2879 = equal_1692_s2_q ? patches_down_values_1_q : (or_1696_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_2882;
  assign select_2882 = equal_1692_s2_q ? patches_down_values_2_q : (or_1696_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_2885;
  assign select_2885 = equal_1692_s2_q ? patches_down_values_3_q : (or_1696_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_2922;
  assign and_2922 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:412
  logic [4:0] select_2927;
  assign select_2927 = or_2822_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:414
  logic [3:0] select_2929;
  assign select_2929 = and_2922 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3285;
  assign select_3285 = equal_1690_s2_q ? patches_summed_down_by_q : (equal_1692_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:551
  logic and_3318;
  assign and_3318 = less_1853 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:555
  logic select_3321;
  assign select_3321 = equal_1856 ? (less_1853 ? (not_1857 & and_3318) : and_3318) : and_3318;
  // hls/stages/patches.hpp:184
  logic select_3324;
  assign select_3324 = equal_1690_s2_q ? (less_1853 ? (not_1855 & select_3321) : select_3321) : patches_read_searches_q;
  // hls/stages/agreement.hpp:200
  logic [8:0] select_3667;
  assign select_3667 = so_s2_q ? (and_2616 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3669;
  assign sum_3669 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3670;
  assign select_3670 = sum_1892[5] ? {1'b1, sum_1892[4:0], region_across_rest_q[2:0]} : sum_3669;
  // hls/stages/agreement.hpp:451
  logic [7:0] select_3672;
  assign select_3672 = equal_2295_s2_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3675;
  assign select_3675 = equal_2295_s2_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_489_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_494;
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
  assign census_memory_re = s2_en & and_519_s2_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1314; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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
  assign shown_right_re = s2_en & and_1512;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:791; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1795, not_1790, select_1789};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & or_1796;
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:792; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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
  assign patches_left_codes_re = s2_en & (not_1691_s2_q & (new_row & equal_1692_s2_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:806; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
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
  assign patches_rows_re = s2_en & and_1863;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1341; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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
  assign seen_columns_re = s2_en & and_1512;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1459_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1458, select_1457, select_1439, select_1436, select_1428, select_1427, select_1422};
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
  assign best_right_we = s2_en & and_1459_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1476, select_1475, select_1472, select_1471};
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
  assign patches_columns_above_we = s2_en & and_1777_s2_q;
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
      shift_allowed_q <= 1'b0;
      shift_not_right_q <= 1'b0;
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
      chosen_score_q <= less_2405 ? select_1416 : select_2404;
      chosen_near_q <= (select_2407 < select_1451) ? select_1451 : select_2407;
      chosen_place_q <= less_2405 ? {select_1424, not_1423} : 3'h2;
      before_0_q <= select_2404;
      before_1_q <= sum_1166;
      before_2_q <= sum_1414;
      shift_allowed_q <= not_2412 & (~less_2413);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s2_q ? sum_2525[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2527;
      registration_slope_row_q <= select_2612;
      registration_slope_change_q <= select_2615;
      registration_slope_q <= so_s2_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_2846_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2846_s2_q & select_2861;
      patches_smooth_values_0_q <= equal_1690_s2_q ? patches_smooth_values_0_q : select_2864;
      patches_smooth_values_1_q <= select_2868;
      patches_smooth_values_2_q <= select_2871;
      patches_smooth_values_3_q <= select_2874;
      patches_down_values_0_q <= equal_1690_s2_q ? patches_down_values_0_q : select_2876;
      patches_down_values_1_q <= equal_1690_s2_q ? patches_down_values_1_q : select_2879;
      patches_down_values_2_q <= equal_1690_s2_q ? patches_down_values_2_q : select_2882;
      patches_down_values_3_q <= equal_1690_s2_q ? patches_down_values_3_q : select_2885;
      patches_down_by_q <= or_2822_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2922});
      patches_along_q <= select_2927;
      patches_match_row_q <= or_2822_s2_q ? 4'h0 : select_2929;
      patches_summed_last_q <= not_1691_s2_q & (equal_1692_s2_q & and_2922);
      patches_summed_down_by_q <= select_3285;
      patches_step_q <= or_2822_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3324;
      region_across_rest_q <= select_3667;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3670;
      columns_begin_rest_q <= and_519_s2_q ? select_3672 : columns_begin_rest_q;
      columns_begin_back_q <= and_519_s2_q ? select_3675 : columns_begin_back_q;
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
      middle_sum_columns_values_1_q <= select_2395;
      middle_sum_columns_values_2_q <= select_2396;
      middle_sum_columns_values_3_q <= select_2397;
      middle_sum_columns_values_4_q <= select_2398;
      middle_sum_columns_values_5_q <= select_2399;
      middle_sum_columns_values_6_q <= select_2400;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_916;
      sums_0_sum_sums_values_0_q <= sum_1166;
      sums_0_sum_sums_values_1_q <= equal_1164 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1414;
      sums_1_sum_sums_values_1_q <= equal_1164 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [2:0] select_483_s3_q;
  logic [5:0] select_485_s3_q;
  logic [7:0] select_489_s3_q;
  logic and_493_s3_q;
  logic and_494_s3_q;
  logic equal_499_s3_q;
  logic [5:0] column_s3_q;
  logic and_517_s3_q;
  logic and_519_s3_q;
  logic so_s3_q;
  logic equal_580_s3_q;
  logic equal_1477_s3_q;
  logic not_1478_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1512_s3_q;
  logic [5:0] select_1516_s3_q;
  logic and_1521_s3_q;
  logic and_1590_s3_q;
  logic and_1603_s3_q;
  logic less_1617_s3_q;
  logic [7:0] change_s3_q;
  logic equal_1690_s3_q;
  logic equal_1692_s3_q;
  logic equal_1695_s3_q;
  logic or_1696_s3_q;
  logic [4:0] select_1720_s3_q;
  logic select_1726_s3_q;
  logic [3:0] select_1767_s3_q;
  logic less_1783_s3_q;
  logic new_row_s3_q;
  logic or_1796_s3_q;
  logic [1:0] of_row_2_s3_q;
  logic less_1813_s3_q;
  logic less_1814_s3_q;
  logic less_1823_s3_q;
  logic less_1824_s3_q;
  logic and_1838_s3_q;
  logic and_1847_s3_q;
  logic and_1852_s3_q;
  logic less_1853_s3_q;
  logic equal_1854_s3_q;
  logic not_1855_s3_q;
  logic equal_1856_s3_q;
  logic not_1857_s3_q;
  logic and_1871_s3_q;
  logic select_1873_s3_q;
  logic and_1876_s3_q;
  logic sum_1892_s3_q;
  logic textured_s3_q;
  logic and_2025_s3_q;
  logic equal_2171_s3_q;
  logic equal_2295_s3_q;
  logic less_2541_s3_q;
  logic less_2898_s3_q;
  logic equal_3241_s3_q;
  logic equal_3325_s3_q;
  logic less_3655_s3_q;
  logic equal_3860_s3_q;
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
      select_483_s3_q <= select_483_s2_q;
      select_485_s3_q <= select_485_s2_q;
      select_489_s3_q <= select_489_s2_q;
      and_493_s3_q <= and_493_s2_q;
      and_494_s3_q <= and_494;
      equal_499_s3_q <= equal_499_s2_q;
      column_s3_q <= column_s2_q;
      and_517_s3_q <= and_517_s2_q;
      and_519_s3_q <= and_519_s2_q;
      so_s3_q <= so_s2_q;
      equal_580_s3_q <= equal_580_s2_q;
      equal_1477_s3_q <= equal_1477_s2_q;
      not_1478_s3_q <= not_1478;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1512_s3_q <= and_1512;
      select_1516_s3_q <= select_1516_s2_q;
      and_1521_s3_q <= not_1478 & (so_s2_q ? and_1510 : (equal_539_s2_q & shift_2[4]));
      and_1590_s3_q <= and_1590_s2_q;
      and_1603_s3_q <= and_1603_s2_q;
      less_1617_s3_q <= less_1617_s2_q;
      change_s3_q <= change;
      equal_1690_s3_q <= equal_1690_s2_q;
      equal_1692_s3_q <= equal_1692_s2_q;
      equal_1695_s3_q <= equal_1695_s2_q;
      or_1696_s3_q <= or_1696_s2_q;
      select_1720_s3_q <= select_1720_s2_q;
      select_1726_s3_q <= select_1726_s2_q;
      select_1767_s3_q <= select_1767_s2_q;
      less_1783_s3_q <= less_1783;
      new_row_s3_q <= new_row;
      or_1796_s3_q <= or_1796;
      of_row_2_s3_q <= of_row_2;
      less_1813_s3_q <= $signed(15'h100) < $signed(sum_1812);
      less_1814_s3_q <= $signed(sum_1812[14:8]) < $signed(7'h7f);
      less_1823_s3_q <= $signed(15'h100) < $signed(difference_1822);
      less_1824_s3_q <= $signed(difference_1822[14:8]) < $signed(7'h7f);
      and_1838_s3_q <= not_1691_s2_q & and_1837;
      and_1847_s3_q <= and_1847;
      and_1852_s3_q <= not_1691_s2_q & and_1851;
      less_1853_s3_q <= less_1853;
      equal_1854_s3_q <= equal_1854;
      not_1855_s3_q <= not_1855;
      equal_1856_s3_q <= equal_1856;
      not_1857_s3_q <= not_1857;
      and_1871_s3_q <= and_1871_s2_q;
      select_1873_s3_q <= select_1873_s2_q;
      and_1876_s3_q <= and_1876_s2_q;
      sum_1892_s3_q <= sum_1892[5];
      textured_s3_q <= textured;
      and_2025_s3_q <= and_2025_s2_q;
      equal_2171_s3_q <= equal_2171_s2_q;
      equal_2295_s3_q <= equal_2295_s2_q;
      less_2541_s3_q <= select_2508 < select_2510;
      less_2898_s3_q <= 4'he < patches_column_s2_q[4:1];
      equal_3241_s3_q <= patches_match_row_q == 4'h0;
      equal_3325_s3_q <= patches_step_q[6:5] == 2'h2;
      less_3655_s3_q <= less_3655_s2_q;
      equal_3860_s3_q <= equal_3860_s2_q;
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
  logic [11:0] select_497;
  assign select_497 = select_483_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_501;
  assign sum_501 = select_497 + (equal_499_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_503;
  assign sum_503 = {4'h0, sample_pair_pixel_1_q} + (select_483_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_505;
  assign sum_505 = sum_503 + (equal_499_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:408
  logic whole;
  assign whole = select_483_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_509;
  assign and_509 = whole & (averager_memory_rdata_q[24] | equal_499_s3_q);
  // hls/stages/agreement.hpp:408
  logic all_of_skin;
  assign all_of_skin = select_483_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_513;
  assign and_513 = all_of_skin & (averager_memory_rdata_q[25] | equal_499_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_493_s3_q ? sum_501[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_522;
  assign equal_522 = select_483_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_522 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:267
  logic [8:0] select_525;
  assign select_525 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_493_s3_q ? sum_505[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_522 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:267
  logic [8:0] select_529;
  assign select_529 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_530;
  assign and_530 = and_493_s3_q & and_509;
  // hls/stages/census.hpp:126
  logic select_532;
  assign select_532 = equal_522 ? and_530 : (averager_mask_q & and_530);
  // hls/stages/agreement.hpp:267
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_532;
  // hls/stages/census.hpp:206
  logic and_534;
  assign and_534 = and_493_s3_q & and_513;
  // hls/stages/census.hpp:126
  logic select_536;
  assign select_536 = equal_522 ? and_534 : (averager_of_skin_q & and_534);
  // hls/stages/agreement.hpp:267
  logic and_537;
  assign and_537 = sample_pair_whole_s3_q & select_536;
  // hls/stages/census.hpp:294
  logic less_553;
  assign less_553 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_554;
  assign less_554 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_555;
  assign less_555 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_556;
  assign less_556 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_557;
  assign less_557 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_558;
  assign less_558 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_559;
  assign less_559 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_560;
  assign less_560 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_561;
  assign less_561 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_562;
  assign less_562 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_563;
  assign less_563 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_564;
  assign less_564 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_565;
  assign less_565 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_566;
  assign less_566 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_567;
  assign less_567 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_568;
  assign less_568 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_569;
  assign less_569 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_570;
  assign less_570 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_571;
  assign less_571 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_572;
  assign less_572 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_573;
  assign less_573 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_574;
  assign less_574 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_575;
  assign less_575 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_576;
  assign less_576 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:446
  logic equal_577;
  assign equal_577 = column_s3_q == 6'h0;
  logic [3:0] select_581;
  assign select_581 = equal_580_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:447
  logic [4:0] select_582;
  assign select_582 = equal_577 ? {select_581, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_583;
  assign select_583 = equal_577 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_584;
  assign and_584 = select_582[4] & select_583[3];
  // hls/stages/census.hpp:286
  logic and_586;
  assign and_586 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_588;
  assign and_588 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_586);
  // hls/stages/agreement.hpp:447
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_588;
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
  logic [9:0] difference_611;
  assign difference_611 = {1'b0, select_525} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_612;
  assign xor_612 = difference_611[8:0] ^ {9{difference_611[9]}};
  logic [9:0] sum_613;
  assign sum_613 = {9'h0, difference_611[9]} + {1'b0, xor_612};
  logic [9:0] difference_614;
  assign difference_614 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_615;
  assign xor_615 = difference_614[8:0] ^ {9{difference_614[9]}};
  logic [9:0] sum_616;
  assign sum_616 = {9'h0, difference_614[9]} + {1'b0, xor_615};
  logic [9:0] difference_618;
  assign difference_618 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_619;
  assign xor_619 = difference_618[8:0] ^ {9{difference_618[9]}};
  logic [9:0] sum_620;
  assign sum_620 = {9'h0, difference_618[9]} + {1'b0, xor_619};
  logic [10:0] sum_621;
  assign sum_621 = ({1'b0, sum_613} + {1'b0, sum_616}) + {1'b0, sum_620};
  logic [9:0] difference_622;
  assign difference_622 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_623;
  assign xor_623 = difference_622[8:0] ^ {9{difference_622[9]}};
  logic [9:0] sum_624;
  assign sum_624 = {9'h0, difference_622[9]} + {1'b0, xor_623};
  logic [9:0] difference_626;
  assign difference_626 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_627;
  assign xor_627 = difference_626[8:0] ^ {9{difference_626[9]}};
  // hls/stages/agreement.hpp:196
  logic not_1517;
  assign not_1517 = ~so_s3_q;
  // hls/stages/agreement.hpp:776
  logic and_1518;
  assign and_1518 = not_1517 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1083
  logic equal_1522;
  assign equal_1522 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1084
  logic [1:0] select_1525;
  assign select_1525 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1097
  logic [3:0] select_1527;
  assign select_1527 = equal_1522 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1525});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1528;
  assign sum_1528 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:776
  logic [3:0] select_1529;
  assign select_1529 = equal_1477_s3_q ? select_1527 : {sum_1528, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1530;
  assign equal_1530 = x_s3_q[5:0] == 6'h3f;
  logic equal_1532;
  assign equal_1532 = x_s3_q[5:0] == 6'h3e;
  logic equal_1534;
  assign equal_1534 = x_s3_q[5:0] == 6'h3d;
  logic equal_1536;
  assign equal_1536 = x_s3_q[5:0] == 6'h3c;
  logic equal_1538;
  assign equal_1538 = x_s3_q[5:0] == 6'h3b;
  logic equal_1540;
  assign equal_1540 = x_s3_q[5:0] == 6'h36;
  logic equal_1542;
  assign equal_1542 = x_s3_q[5:0] == 6'h35;
  logic equal_1544;
  assign equal_1544 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1129
  logic and_1548;
  assign and_1548 = (~equal_1538) & ((~equal_1540) & ((~equal_1542) & (~equal_1544)));
  logic and_1552;
  assign and_1552 = (~equal_1530) & ((~equal_1532) & ((~equal_1534) & ((~equal_1536) & and_1548)));
  // hls/stages/agreement.hpp:1084
  logic less_1553;
  assign less_1553 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1557;
  assign or_1557 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:968
  logic [4:0] sum_1562;
  assign sum_1562 = {1'b0, last_s3_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:253
  logic right_2;
  assign right_2 = shift_2_s3_q[0] & ({2'h0, sum_1562, last_s3_q[1]} < x_s3_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1568;
  assign sum_1568 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1570;
  assign and_1570 = half_ends & ({{3{sum_1568[4]}}, sum_1568} < 8'h3);
  // hls/stages/agreement.hpp:776
  logic and_1571;
  assign and_1571 = so_s3_q & and_1570;
  logic select_1572;
  assign select_1572 = equal_1477_s3_q ? (x_s3_q[6] & (equal_1522 ? and_1552 : (less_1553 & (~or_1557)))) : and_1571;
  // hls/stages/registration.hpp:258
  logic not_1574;
  assign not_1574 = ~lower_half_s3_q;
  logic [3:0] select_1575;
  assign select_1575 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1574, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1574};
  // hls/stages/patches.hpp:372
  logic [1:0] select_1604;
  assign select_1604 = and_1603_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1605;
  assign select_1605 = and_1603_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:267
  logic [5:0] select_1606;
  assign select_1606 = and_1590_s3_q ? {select_1605, select_1604[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1607;
  assign select_1607 = and_1590_s3_q ? select_1604 : patches_fetch_q;
  logic equal_1608;
  assign equal_1608 = select_1607 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s3_q[5:1]} < x_s3_q;
  // hls/stages/agreement.hpp:776
  logic and_1616;
  assign and_1616 = not_1478_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1618;
  assign equal_1618 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1618 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1624;
  assign select_1624 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_1625;
  assign select_1625 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_1626;
  assign sum_1626 = {{2{select_1624[6]}}, select_1624} + {select_1625[7], select_1625};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1627;
  assign select_1627 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_1628;
  assign select_1628 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_1629;
  assign sum_1629 = {{2{select_1627[7]}}, select_1627[7:1]} + {select_1628[7], select_1628};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1630;
  assign sum_1630 = {{3{sum_1626[8]}}, sum_1626[8:1]} + {sum_1629[8], sum_1629, select_1627[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1631;
  assign select_1631 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_1632;
  assign select_1632 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_1633;
  assign difference_1633 = {{2{select_1631[7]}}, select_1631[7:1]} - {select_1632[7], select_1632};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1634;
  assign sum_1634 = {difference_1633, select_1631[0]} + {sum_1630[10], sum_1630[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1618 ? {sum_1634, sum_1630[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1636;
  assign sum_1636 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:977
  logic and_1638;
  assign and_1638 = shift_2_s3_q[3] & ({{4{sum_1636[9]}}, sum_1636, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:104
  logic and_1643;
  assign and_1643 = ({4'h0, last_s3_q[5:1]} < ({1'b0, x_s3_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:106
  logic equal_1644;
  assign equal_1644 = x_s3_q == 8'h0;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1650;
  assign sum_1650 = {2'h0, x_s3_q} + {{4{shift_2_s3_q[10]}}, shift_2_s3_q[10:5]};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1652;
  assign sum_1652 = {sum_1650[9], sum_1650[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:977
  logic and_1655;
  assign and_1655 = ($signed(9'h0) < $signed(sum_1650[9:1])) & (~($signed({5'h0, last_s3_q}) < $signed({sum_1652, sum_1650[0]})));
  logic and_1656;
  assign and_1656 = (~(and_1643 | (equal_1644 | (~(x_s3_q < {2'h0, last_s3_q}))))) & and_1655;
  // hls/stages/agreement.hpp:776
  logic and_1659;
  assign and_1659 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_1617_s3_q & and_1638) & and_1656));
  logic and_1661;
  assign and_1661 = not_1478_s3_q & (so_s3_q & and_1659);
  // hls/stages/patches.hpp:156
  logic and_1663;
  assign and_1663 = and_1661 & (~patches_fixed_q);
  // hls/stages/agreement.hpp:776
  logic [6:0] select_1666;
  assign select_1666 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  logic [6:0] select_1667;
  assign select_1667 = equal_1477_s3_q ? 7'h0 : select_1666;
  logic [5:0] select_1669;
  assign select_1669 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_1671;
  assign select_1671 = equal_1477_s3_q ? 6'h0 : (so_s3_q ? select_1669 : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1672;
  assign sum_1672 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_1634[9]}}, sum_1634[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1675;
  assign select_1675 = ($signed(sum_1672[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1672[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1618 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1672[12:7])) ? 8'h7f : select_1675);
  // hls/stages/agreement.hpp:776
  logic [7:0] select_1680;
  assign select_1680 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_1681;
  assign select_1681 = equal_1477_s3_q ? 8'h0 : select_1680;
  // hls/stages/patches.hpp:342
  logic [21:0] select_1682;
  assign select_1682 = and_1663 ? {select_1681, select_1671, select_1667, and_1661} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:113
  logic equal_1683;
  assign equal_1683 = x_s3_q == {2'h0, last_s3_q};
  // hls/stages/agreement.hpp:776
  logic and_1687;
  assign and_1687 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (and_1643 | equal_1683)));
  logic and_1688;
  assign and_1688 = not_1478_s3_q & and_1687;
  // hls/stages/patches.hpp:343
  logic and_1689;
  assign and_1689 = patches_chooses_s3_q & and_1688;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1703;
  assign select_1703 = and_1590_s3_q ? select_1605 : patches_band_q;
  // hls/stages/patches.hpp:352
  logic equal_1704;
  assign equal_1704 = {patches_choosing_band_s3_q, and_1616} == {select_1703, select_1607[1]};
  // hls/stages/patches.hpp:481
  logic [2:0] sum_1804;
  assign sum_1804 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:485
  logic [1:0] sum_1842;
  assign sum_1842 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:200
  logic [7:0] select_1879;
  assign select_1879 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1005
  logic or_1882;
  assign or_1882 = select_1879[7] | (~({select_1879[5], select_1879[3], select_1879[1]} == 3'h0));
  // hls/stages/agreement.hpp:1004
  logic or_1885;
  assign or_1885 = select_1879[7] | (~({select_1879[6], select_1879[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1003
  logic or_1888;
  assign or_1888 = select_1879[7] | (~(select_1879[6:4] == 3'h0));
  // hls/stages/agreement.hpp:776
  logic [5:0] select_1889;
  assign select_1889 = equal_1477_s3_q ? x_s3_q[5:0] : {region_row_q, or_1888, or_1885, or_1882};
  // hls/stages/agreement.hpp:1083
  logic not_1890;
  assign not_1890 = ~equal_1522;
  // hls/stages/agreement.hpp:1013
  logic or_1894;
  assign or_1894 = (~sum_1892_s3_q) | equal_1683;
  // hls/stages/agreement.hpp:776
  logic and_1897;
  assign and_1897 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_1894));
  // hls/stages/agreement.hpp:253
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_1918;
  assign and_1918 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:973
  logic select_1919;
  assign select_1919 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:253
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_1919);
  // hls/stages/agreement.hpp:973
  logic select_1922;
  assign select_1922 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:253
  logic near;
  assign near = shift_2_s3_q[0] & (select_1919 ? select_1922 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1212
  logic select_1925;
  assign select_1925 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1216
  logic select_1926;
  assign select_1926 = left_first_s3_q ? select_1925 : read_half_q;
  logic or_1927;
  assign or_1927 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1217
  logic [8:0] select_1928;
  assign select_1928 = or_1927 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1218
  logic [9:0] select_1930;
  assign select_1930 = left_first_s3_q ? 10'h1 : (or_1927 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1221
  logic and_1931;
  assign and_1931 = select_1928[8] & select_1930[9];
  // hls/stages/agreement.hpp:426
  logic next_row;
  assign next_row = and_1931 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1232
  logic [5:0] select_1934;
  assign select_1934 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1936;
  assign select_1936 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_1934});
  // hls/stages/agreement.hpp:1242
  logic equal_1937;
  assign equal_1937 = seen_x_q == 3'h7;
  logic [7:0] select_1939;
  assign select_1939 = and_1931 ? 8'h0 : (seen_column_q + {7'h0, equal_1937});
  // hls/stages/agreement.hpp:1249
  logic [10:0] index;
  assign index = select_1936 + {3'h0, select_1939};
  // hls/stages/agreement.hpp:1202
  logic [11:0] sum_1941;
  assign sum_1941 = {1'b0, {2{select_1926}}, 2'h0, {2{select_1926}}, 1'b0, {2{select_1926}}, 1'b0, select_1926} + {1'b0, index};
  // hls/stages/agreement.hpp:1215
  logic not_1942;
  assign not_1942 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:426
  logic and_1944;
  assign and_1944 = not_1942 & (began_q | and_1931);
  // hls/stages/agreement.hpp:1243
  logic [2:0] select_1946;
  assign select_1946 = and_1931 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1248
  logic and_1948;
  assign and_1948 = and_1944 & (select_1946 == 3'h0);
  logic less_1949;
  assign less_1949 = select_1939 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:428
  logic and_1950;
  assign and_1950 = and_1948 & less_1949;
  logic and_1951;
  assign and_1951 = and_1871_s3_q & and_1950;
  // hls/stages/agreement.hpp:269
  logic select_1953;
  assign select_1953 = and_1871_s3_q ? (left_first_s3_q ? and_1950 : and_1951) : and_1951;
  // hls/stages/agreement.hpp:1066
  logic [7:0] sum_1955;
  assign sum_1955 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1955[7], sum_1955, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1202
  logic [11:0] sum_1957;
  assign sum_1957 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:989
  logic and_1958;
  assign and_1958 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_1959;
  assign and_1959 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_1960;
  assign and_1960 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_1961;
  assign and_1961 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1042
  logic [1:0] sum_1963;
  assign sum_1963 = {1'b0, and_1960} + ({1'b0, textured_s3_q} + {1'b0, and_1961});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1958} + ({2'h0, and_1959} + {1'b0, sum_1963});
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_1966;
  assign select_1966 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1967;
  assign difference_1967 = {1'b0, textured_2} - {1'b0, select_1966};
  logic [4:0] t;
  assign t = {difference_1967[3], difference_1967} + (equal_1644 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:989
  logic [7:0] select_1972;
  assign select_1972 = shift_2_s3_q[0] ? (sum_1892_s3_q ? select_1879 : {select_1879[6:0], 1'b0}) : select_1879;
  // hls/stages/agreement.hpp:1005
  logic or_1975;
  assign or_1975 = select_1972[7] | (~({select_1972[5], select_1972[3], select_1972[1]} == 3'h0));
  // hls/stages/agreement.hpp:989
  logic and_1992;
  assign and_1992 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_1993;
  assign and_1993 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_1994;
  assign and_1994 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_1995;
  assign and_1995 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1044
  logic [1:0] sum_1997;
  assign sum_1997 = {1'b0, and_1994} + ({1'b0, shown} + {1'b0, and_1995});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1992} + ({2'h0, and_1993} + {1'b0, sum_1997});
  // hls/stages/agreement.hpp:1051
  logic [2:0] select_2000;
  assign select_2000 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2001;
  assign difference_2001 = {1'b0, shown_2} - {1'b0, select_2000};
  logic [4:0] around;
  assign around = {difference_2001[3], difference_2001} + (equal_1644 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1058
  logic [5:0] sum_2004;
  assign sum_2004 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:989
  logic and_2008;
  assign and_2008 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2009;
  assign and_2009 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2010;
  assign and_2010 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2011;
  assign and_2011 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1045
  logic [1:0] sum_2013;
  assign sum_2013 = {1'b0, and_2010} + ({1'b0, near} + {1'b0, and_2011});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2008} + ({2'h0, and_2009} + {1'b0, sum_2013});
  // hls/stages/agreement.hpp:1052
  logic [2:0] select_2016;
  assign select_2016 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2017;
  assign difference_2017 = {1'b0, near_2} - {1'b0, select_2016};
  logic [4:0] n;
  assign n = {difference_2017[3], difference_2017} + (equal_1644 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:776
  logic and_2029;
  assign and_2029 = ends_cell_s3_q & (and_2025_s3_q & (~({1'b0, sum_1562, last_s3_q[1:0]} < x_s3_q)));
  logic and_2031;
  assign and_2031 = not_1478_s3_q & (so_s3_q & and_2029);
  // hls/stages/agreement.hpp:267
  logic [10:0] select_2063;
  assign select_2063 = sample_pair_whole_s3_q ? (and_517_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2065;
  assign select_2065 = sample_pair_whole_s3_q ? (and_517_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2084;
  assign select_2084 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2086;
  assign select_2086 = sample_pair_whole_s3_q ? (and_517_s3_q ? select_532 : averager_mask_q) : averager_mask_q;
  logic select_2088;
  assign select_2088 = sample_pair_whole_s3_q ? (and_517_s3_q ? select_536 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:511
  logic [8:0] select_2089;
  assign select_2089 = and_519_s3_q ? select_525 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2090;
  assign select_2090 = and_519_s3_q ? select_529 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2092;
  assign select_2092 = and_519_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2093;
  assign select_2093 = and_519_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2094;
  assign select_2094 = and_519_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2095;
  assign select_2095 = and_519_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2096;
  assign select_2096 = and_519_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2097;
  assign select_2097 = and_519_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2098;
  assign select_2098 = and_519_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2099;
  assign select_2099 = and_519_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2100;
  assign select_2100 = and_519_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2101;
  assign select_2101 = and_519_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2102;
  assign select_2102 = and_519_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2103;
  assign select_2103 = and_519_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2104;
  assign select_2104 = and_519_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2105;
  assign select_2105 = and_519_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2106;
  assign select_2106 = and_519_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2107;
  assign select_2107 = and_519_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2108;
  assign select_2108 = and_519_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2109;
  assign select_2109 = and_519_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2110;
  assign select_2110 = and_519_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2111;
  assign select_2111 = and_519_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2112;
  assign select_2112 = and_519_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2113;
  assign select_2113 = and_519_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2114;
  assign select_2114 = and_519_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2115;
  assign select_2115 = and_519_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2116;
  assign select_2116 = and_519_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2117;
  assign select_2117 = and_519_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2118;
  assign select_2118 = and_519_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2119;
  assign select_2119 = and_519_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2120;
  assign select_2120 = and_519_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2121;
  assign select_2121 = and_519_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2122;
  assign select_2122 = and_519_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2123;
  assign select_2123 = and_519_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2124;
  assign select_2124 = and_519_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2125;
  assign select_2125 = and_519_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2126;
  assign select_2126 = and_519_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2127;
  assign select_2127 = and_519_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2128;
  assign select_2128 = and_519_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2129;
  assign select_2129 = and_519_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2130;
  assign select_2130 = and_519_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2131;
  assign select_2131 = and_519_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2132;
  assign select_2132 = and_519_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2133;
  assign select_2133 = and_519_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2134;
  assign select_2134 = and_519_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2135;
  assign select_2135 = and_519_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2136;
  assign select_2136 = and_519_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2137;
  assign select_2137 = and_519_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2138;
  assign select_2138 = and_519_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2139;
  assign select_2139 = and_519_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2140;
  assign select_2140 = and_519_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2141;
  assign select_2141 = and_519_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2142;
  assign select_2142 = and_519_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2143;
  assign select_2143 = and_519_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2144;
  assign select_2144 = and_519_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2146;
  assign difference_2146 = {1'b0, select_529} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2147;
  assign xor_2147 = difference_2146[8:0] ^ {9{difference_2146[9]}};
  logic [9:0] sum_2148;
  assign sum_2148 = {9'h0, difference_2146[9]} + {1'b0, xor_2147};
  logic [9:0] difference_2149;
  assign difference_2149 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2150;
  assign xor_2150 = difference_2149[8:0] ^ {9{difference_2149[9]}};
  logic [9:0] sum_2151;
  assign sum_2151 = {9'h0, difference_2149[9]} + {1'b0, xor_2150};
  logic [9:0] difference_2153;
  assign difference_2153 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2154;
  assign xor_2154 = difference_2153[8:0] ^ {9{difference_2153[9]}};
  logic [9:0] sum_2155;
  assign sum_2155 = {9'h0, difference_2153[9]} + {1'b0, xor_2154};
  logic [10:0] sum_2156;
  assign sum_2156 = ({1'b0, sum_2148} + {1'b0, sum_2151}) + {1'b0, sum_2155};
  logic [9:0] difference_2157;
  assign difference_2157 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2158;
  assign xor_2158 = difference_2157[8:0] ^ {9{difference_2157[9]}};
  logic [9:0] sum_2159;
  assign sum_2159 = {9'h0, difference_2157[9]} + {1'b0, xor_2158};
  logic [9:0] difference_2161;
  assign difference_2161 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2162;
  assign xor_2162 = difference_2161[8:0] ^ {9{difference_2161[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2192;
  assign difference_2192 = {1'b0, select_525} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2192[9]} + (difference_2192[8:0] ^ {9{difference_2192[9]}});
  logic [9:0] difference_2204;
  assign difference_2204 = {1'b0, select_529} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2204[9]} + (difference_2204[8:0] ^ {9{difference_2204[9]}});
  // hls/stages/agreement.hpp:511
  logic and_2420;
  assign and_2420 = and_519_s3_q & (equal_580_s3_q & equal_2295_s3_q);
  // hls/stages/agreement.hpp:776
  logic and_2424;
  assign and_2424 = not_1478_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:989
  logic and_2444;
  assign and_2444 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2445;
  assign and_2445 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2446;
  assign and_2446 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2447;
  assign and_2447 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1043
  logic [1:0] sum_2449;
  assign sum_2449 = {1'b0, and_2446} + ({1'b0, explained} + {1'b0, and_2447});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2444} + ({2'h0, and_2445} + {1'b0, sum_2449});
  // hls/stages/agreement.hpp:1050
  logic [2:0] select_2452;
  assign select_2452 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2453;
  assign difference_2453 = {1'b0, explained_2} - {1'b0, select_2452};
  logic [4:0] e;
  assign e = {difference_2453[3], difference_2453} + (equal_1644 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1057
  logic [5:0] sum_2456;
  assign sum_2456 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:776
  logic and_2485;
  assign and_2485 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2529;
  assign select_2529 = equal_1477_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2531;
  assign select_2531 = equal_1477_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2532;
  assign equal_2532 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:253
  logic and_2536;
  assign and_2536 = shift_2_s3_q[3] & less_1617_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2540;
  assign sum_2540 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2542;
  assign difference_2542 = {sum_2540, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2543;
  assign select_2543 = less_2541_s3_q ? difference_2542 : {sum_2540, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2544;
  assign select_2544 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2540, shift_2_s3_q[11], 5'h0} : select_2543;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2544[7]}}, select_2544} - {sum_1634[9], sum_1634, sum_1630[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2547;
  assign select_2547 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2547[11:7])) ? 12'h7f : select_2547;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2568;
  assign difference_2568 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2570;
  assign and_2570 = and_2536 & ($signed(difference_2568) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2583;
  assign less_2583 = $signed(difference_2568) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:776
  logic select_2591;
  assign select_2591 = so_s3_q ? (equal_2532 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2594;
  assign select_2594 = so_s3_q ? (equal_1618 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2599;
  assign select_2599 = (sum_1528 == 2'h2) ? (registration_fresh_q & (~select_1575)) : registration_fresh_q;
  // hls/stages/agreement.hpp:776
  logic [3:0] select_2601;
  assign select_2601 = so_s3_q ? (and_1570 ? select_2599 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2603;
  assign select_2603 = and_2420 ? 4'hf : (equal_1477_s3_q ? registration_fresh_q : select_2601);
  // hls/stages/agreement.hpp:1084
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1525;
  // hls/stages/registration.hpp:258
  logic not_2624;
  assign not_2624 = ~quarter_2[1];
  logic [3:0] select_2625;
  assign select_2625 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2624, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2624};
  // hls/stages/patches.hpp:91
  logic parity_2759;
  assign parity_2759 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:451
  logic [15:0] select_2760;
  assign select_2760 = equal_2295_s3_q ? {patches_chance_q[14:0], parity_2759} : patches_chance_q;
  // hls/stages/patches.hpp:344
  logic not_2762;
  assign not_2762 = ~and_1688;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_2764;
  assign select_2764 = right_3 ? last_s3_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2764};
  // hls/stages/agreement.hpp:776
  logic and_2770;
  assign and_2770 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (~(x_s3_q < {2'h0, from}))));
  // hls/stages/patches.hpp:156
  logic and_2774;
  assign and_2774 = not_2762 & (patches_fixed_q | ((not_1478_s3_q & and_2770) & and_1663));
  // hls/stages/patches.hpp:353
  logic not_2787;
  assign not_2787 = ~select_1607[1];
  // hls/stages/agreement.hpp:267
  logic [1:0] select_2789;
  assign select_2789 = sample_pair_whole_s3_q ? (equal_1608 ? select_1607 : {not_2787, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:517
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_2888;
  assign select_2888 = or_1696_s3_q ? {less_1824_s3_q, less_1823_s3_q, less_1814_s3_q, less_1813_s3_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2890;
  assign select_2890 = equal_1690_s3_q ? patches_codes_at_q : (equal_1692_s3_q ? other[55:4] : select_2888);
  // hls/stages/patches.hpp:500
  logic [27:0] word;
  assign word = or_1796_s3_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:516
  logic [27:0] select_2893;
  assign select_2893 = (patches_along_s3_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_2895;
  assign select_2895 = equal_1692_s3_q ? (new_row_s3_q ? word : select_2893) : patches_codes_further_q;
  // hls/stages/patches.hpp:518
  logic [55:0] select_2897;
  assign select_2897 = less_1783_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:488
  logic [55:0] select_2899;
  assign select_2899 = less_2898_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_2901;
  assign select_2901 = or_1696_s3_q ? (equal_1695_s3_q ? patches_next_codes_q : select_2899) : patches_next_codes_q;
  logic [55:0] select_2903;
  assign select_2903 = equal_1690_s3_q ? patches_next_codes_q : (equal_1692_s3_q ? select_2897 : select_2901);
  // hls/stages/count_bits.hpp:24
  logic parity_2908;
  assign parity_2908 = ^{less_1824_s3_q, less_1823_s3_q, less_1814_s3_q, less_1813_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_2912;
  assign or_2912 = ({less_1814_s3_q, less_1813_s3_q} == 2'h3) | (less_1823_s3_q & (less_1814_s3_q | less_1813_s3_q));
  logic and_2913;
  assign and_2913 = less_1824_s3_q & (^{less_1823_s3_q, less_1814_s3_q, less_1813_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2914;
  assign xor_2914 = or_2912 ^ and_2913;
  // hls/stages/count_bits.hpp:27
  logic and_2915;
  assign and_2915 = or_2912 & and_2913;
  // hls/stages/patches.hpp:184
  logic [2:0] select_2917;
  assign select_2917 = or_1696_s3_q ? (and_1847_s3_q ? {and_2915, xor_2914, parity_2908} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_2921;
  assign sum_2921 = {7'h0, patches_set_q} + (equal_1695_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:517
  logic [47:0] select_2931;
  assign select_2931 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_2933;
  assign select_2933 = equal_1690_s3_q ? patches_left_row_q : (equal_1692_s3_q ? select_2931 : patches_left_row_q);
  // hls/stages/patches.hpp:519
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2931;
  // hls/stages/count_bits.hpp:24
  logic xor_2937;
  assign xor_2937 = bits[17] ^ (^{select_2931[16:15], other[16:15]});
  logic xor_2940;
  assign xor_2940 = bits[11] ^ (^{select_2931[10:9], other[10:9]});
  logic xor_2943;
  assign xor_2943 = bits[14] ^ (^{select_2931[13:12], other[13:12]});
  logic xor_2946;
  assign xor_2946 = xor_2937 ^ (^{select_2931[14:9], other[14:9]});
  logic xor_2949;
  assign xor_2949 = bits[47] ^ (^{select_2931[46:45], other[46:45]});
  logic xor_2952;
  assign xor_2952 = bits[8] ^ (^{select_2931[7:6], other[7:6]});
  logic xor_2955;
  assign xor_2955 = bits[2] ^ (^{select_2931[1:0], other[1:0]});
  logic xor_2958;
  assign xor_2958 = bits[5] ^ (^{select_2931[4:3], other[4:3]});
  logic xor_2961;
  assign xor_2961 = xor_2952 ^ (^{select_2931[5:0], other[5:0]});
  logic parity_2963;
  assign parity_2963 = ^{select_2931[47:45], select_2931[8:0], other[47:45], other[8:0]};
  logic xor_2964;
  assign xor_2964 = xor_2946 ^ parity_2963;
  logic xor_2967;
  assign xor_2967 = bits[44] ^ (^{select_2931[43:42], other[43:42]});
  logic xor_2970;
  assign xor_2970 = bits[38] ^ (^{select_2931[37:36], other[37:36]});
  logic xor_2973;
  assign xor_2973 = bits[41] ^ (^{select_2931[40:39], other[40:39]});
  logic xor_2979;
  assign xor_2979 = bits[26] ^ (^{select_2931[25:24], other[25:24]});
  logic xor_2982;
  assign xor_2982 = bits[20] ^ (^{select_2931[19:18], other[19:18]});
  logic xor_2985;
  assign xor_2985 = bits[23] ^ (^{select_2931[22:21], other[22:21]});
  logic xor_2988;
  assign xor_2988 = xor_2979 ^ (^{select_2931[23:18], other[23:18]});
  logic xor_2991;
  assign xor_2991 = bits[35] ^ (^{select_2931[34:33], other[34:33]});
  logic xor_2994;
  assign xor_2994 = bits[29] ^ (^{select_2931[28:27], other[28:27]});
  logic xor_2997;
  assign xor_2997 = bits[32] ^ (^{select_2931[31:30], other[31:30]});
  logic xor_3000;
  assign xor_3000 = xor_2991 ^ (^{select_2931[32:27], other[32:27]});
  logic xor_3001;
  assign xor_3001 = xor_2988 ^ xor_3000;
  // hls/stages/count_bits.hpp:25
  logic or_3009;
  assign or_3009 = (xor_2940 & xor_2943) | (xor_2937 & (xor_2940 | xor_2943));
  logic or_3013;
  assign or_3013 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3017;
  assign or_3017 = (xor_2955 & xor_2958) | (xor_2952 & (xor_2955 | xor_2958));
  // hls/stages/count_bits.hpp:23
  logic or_3024;
  assign or_3024 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3028;
  assign or_3028 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3032;
  assign or_3032 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3035;
  assign parity_3035 = ^{or_3032, or_3028, or_3024};
  // hls/stages/count_bits.hpp:23
  logic or_3039;
  assign or_3039 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3043;
  assign or_3043 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3047;
  assign or_3047 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3050;
  assign parity_3050 = ^{or_3047, or_3043, or_3039};
  logic parity_3053;
  assign parity_3053 = ^{or_3047, or_3043, or_3039, or_3032, or_3028, or_3024, or_3017, or_3013, or_3009};
  // hls/stages/count_bits.hpp:23
  logic or_3057;
  assign or_3057 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3061;
  assign or_3061 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3065;
  assign or_3065 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3073;
  assign or_3073 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3077;
  assign or_3077 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3081;
  assign or_3081 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3084;
  assign parity_3084 = ^{or_3081, or_3077, or_3073};
  // hls/stages/count_bits.hpp:23
  logic or_3088;
  assign or_3088 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3092;
  assign or_3092 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3096;
  assign or_3096 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3099;
  assign parity_3099 = ^{or_3096, or_3092, or_3088};
  logic parity_3102;
  assign parity_3102 = ^{or_3096, or_3092, or_3088, or_3081, or_3077, or_3073, or_3065, or_3061, or_3057};
  // hls/stages/count_bits.hpp:25
  logic or_3106;
  assign or_3106 = (xor_2970 & xor_2973) | (xor_2967 & (xor_2970 | xor_2973));
  logic or_3110;
  assign or_3110 = (xor_2982 & xor_2985) | (xor_2979 & (xor_2982 | xor_2985));
  logic or_3114;
  assign or_3114 = (xor_2994 & xor_2997) | (xor_2991 & (xor_2994 | xor_2997));
  // hls/stages/count_bits.hpp:24
  logic parity_3117;
  assign parity_3117 = ^{or_3114, or_3110, or_3106};
  // hls/stages/count_bits.hpp:25
  logic and_3118;
  assign and_3118 = xor_2964 & (^{xor_3001, select_2931[44:36], other[44:36]});
  logic or_3122;
  assign or_3122 = (xor_2949 & xor_2961) | (xor_2946 & (xor_2949 | xor_2961));
  logic and_3125;
  assign and_3125 = (xor_2967 ^ (^{select_2931[41:36], other[41:36]})) & (xor_2988 | xor_3000);
  logic or_3126;
  assign or_3126 = (xor_2988 & xor_3000) | and_3125;
  // hls/stages/count_bits.hpp:24
  logic parity_3129;
  assign parity_3129 = ^{or_3126, or_3122, and_3118};
  logic parity_3132;
  assign parity_3132 = ^{or_3126, or_3122, and_3118, or_3114, or_3110, or_3106, or_3096, or_3092, or_3088, or_3081, or_3077, or_3073, or_3065, or_3061, or_3057};
  logic parity_3134;
  assign parity_3134 = ^{or_3126, or_3122, and_3118, or_3114, or_3110, or_3106, or_3096, or_3092, or_3088, or_3081, or_3077, or_3073, or_3065, or_3061, or_3057, or_3047, or_3043, or_3039, or_3032, or_3028, or_3024, or_3017, or_3013, or_3009};
  // hls/stages/count_bits.hpp:25
  logic and_3135;
  assign and_3135 = parity_3053 & parity_3132;
  logic or_3139;
  assign or_3139 = (parity_3035 & parity_3050) | ((^{or_3017, or_3013, or_3009}) & (parity_3035 | parity_3050));
  logic or_3143;
  assign or_3143 = (parity_3117 & parity_3129) | (parity_3102 & (parity_3117 | parity_3129));
  logic or_3150;
  assign or_3150 = (parity_3084 & parity_3099) | ((^{or_3065, or_3061, or_3057}) & (parity_3084 | parity_3099));
  logic or_3154;
  assign or_3154 = (or_3110 & or_3114) | (or_3106 & (or_3110 | or_3114));
  logic or_3158;
  assign or_3158 = (or_3122 & or_3126) | (and_3118 & (or_3122 | or_3126));
  // hls/stages/count_bits.hpp:23
  logic or_3165;
  assign or_3165 = (or_3061 & or_3065) | (or_3057 & (or_3061 | or_3065));
  // hls/stages/count_bits.hpp:25
  logic or_3169;
  assign or_3169 = (or_3077 & or_3081) | (or_3073 & (or_3077 | or_3081));
  logic or_3173;
  assign or_3173 = (or_3092 & or_3096) | (or_3088 & (or_3092 | or_3096));
  // hls/stages/count_bits.hpp:24
  logic parity_3176;
  assign parity_3176 = ^{or_3173, or_3169, or_3165};
  // hls/stages/count_bits.hpp:23
  logic or_3180;
  assign or_3180 = (or_3013 & or_3017) | (or_3009 & (or_3013 | or_3017));
  // hls/stages/count_bits.hpp:25
  logic or_3184;
  assign or_3184 = (or_3028 & or_3032) | (or_3024 & (or_3028 | or_3032));
  logic or_3188;
  assign or_3188 = (or_3043 & or_3047) | (or_3039 & (or_3043 | or_3047));
  // hls/stages/count_bits.hpp:24
  logic parity_3191;
  assign parity_3191 = ^{or_3188, or_3184, or_3180};
  logic parity_3194;
  assign parity_3194 = ^{or_3188, or_3184, or_3180, or_3173, or_3169, or_3165, or_3158, or_3154, or_3150};
  logic parity_3196;
  assign parity_3196 = ^{or_3188, or_3184, or_3180, or_3173, or_3169, or_3165, or_3158, or_3154, or_3150, or_3143, or_3139, and_3135};
  // hls/stages/count_bits.hpp:25
  logic or_3200;
  assign or_3200 = (or_3154 & or_3158) | (or_3150 & (or_3154 | or_3158));
  logic or_3204;
  assign or_3204 = (or_3169 & or_3173) | (or_3165 & (or_3169 | or_3173));
  logic or_3208;
  assign or_3208 = (or_3184 & or_3188) | (or_3180 & (or_3184 | or_3188));
  // hls/stages/count_bits.hpp:24
  logic parity_3211;
  assign parity_3211 = ^{or_3208, or_3204, or_3200};
  // hls/stages/count_bits.hpp:25
  logic and_3212;
  assign and_3212 = (^{or_3143, or_3139, and_3135}) & parity_3194;
  logic or_3216;
  assign or_3216 = (or_3139 & or_3143) | (and_3135 & (or_3139 | or_3143));
  logic or_3220;
  assign or_3220 = (parity_3176 & parity_3191) | ((^{or_3158, or_3154, or_3150}) & (parity_3176 | parity_3191));
  // hls/stages/count_bits.hpp:24
  logic parity_3223;
  assign parity_3223 = ^{or_3220, or_3216, and_3212};
  // hls/stages/count_bits.hpp:25
  logic and_3225;
  assign and_3225 = parity_3211 & parity_3223;
  logic or_3229;
  assign or_3229 = (or_3204 & or_3208) | (or_3200 & (or_3204 | or_3208));
  logic or_3233;
  assign or_3233 = (or_3216 & or_3220) | (and_3212 & (or_3216 | or_3220));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3278;
  assign select_3278 = equal_1692_s3_q ? patches_along_s3_q : patches_summed_row_column_q;
  logic select_3281;
  assign select_3281 = equal_1690_s3_q ? patches_summed_first_q : (equal_1692_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:551
  logic [9:0] select_3288;
  assign select_3288 = less_1853_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3291;
  assign select_3291 = equal_1856_s3_q ? (less_1853_s3_q ? (equal_1856_s3_q ? 10'h0 : select_3288) : 10'h0) : select_3288;
  logic [9:0] select_3293;
  assign select_3293 = less_1853_s3_q ? (equal_1854_s3_q ? 10'h0 : select_3291) : select_3291;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3295;
  assign select_3295 = less_1853_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3298;
  assign select_3298 = equal_1856_s3_q ? (less_1853_s3_q ? (equal_1856_s3_q ? 5'h0 : select_3295) : 5'h0) : select_3295;
  logic [4:0] select_3300;
  assign select_3300 = less_1853_s3_q ? (equal_1854_s3_q ? 5'h0 : select_3298) : select_3298;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3302;
  assign select_3302 = less_1853_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3305;
  assign select_3305 = equal_1856_s3_q ? (less_1853_s3_q ? (equal_1856_s3_q ? 5'h0 : select_3302) : 5'h0) : select_3302;
  logic [4:0] select_3307;
  assign select_3307 = less_1853_s3_q ? (equal_1854_s3_q ? 5'h0 : select_3305) : select_3305;
  // hls/stages/patches.hpp:551
  logic and_3310;
  assign and_3310 = less_1853_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:555
  logic select_3313;
  assign select_3313 = equal_1856_s3_q ? (less_1853_s3_q ? (not_1857_s3_q & and_3310) : and_3310) : and_3310;
  // hls/stages/patches.hpp:184
  logic select_3316;
  assign select_3316 = equal_1690_s3_q ? (less_1853_s3_q ? (not_1855_s3_q & select_3313) : select_3313) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3327;
  assign or_3327 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3328;
  assign and_3328 = patches_read_searches_s3_q & or_3327;
  // hls/stages/patches.hpp:535
  logic [4:0] select_3329;
  assign select_3329 = and_3328 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:542
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3329};
  // hls/stages/patches.hpp:551
  logic and_3333;
  assign and_3333 = less_1853_s3_q & (equal_3325_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:555
  logic select_3336;
  assign select_3336 = equal_1856_s3_q ? (less_1853_s3_q ? (not_1857_s3_q & and_3333) : and_3333) : and_3333;
  // hls/stages/patches.hpp:184
  logic select_3339;
  assign select_3339 = equal_1690_s3_q ? (less_1853_s3_q ? (not_1855_s3_q & select_3336) : select_3336) : patches_read_above_q;
  // hls/stages/patches.hpp:551
  logic and_3342;
  assign and_3342 = less_1853_s3_q & (equal_3325_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:555
  logic select_3345;
  assign select_3345 = equal_1856_s3_q ? (less_1853_s3_q ? (not_1857_s3_q & and_3342) : and_3342) : and_3342;
  // hls/stages/patches.hpp:184
  logic select_3348;
  assign select_3348 = equal_1690_s3_q ? (less_1853_s3_q ? (not_1855_s3_q & select_3345) : select_3345) : patches_read_below_q;
  // hls/stages/patches.hpp:548
  logic [6:0] sum_3349;
  assign sum_3349 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:549
  logic [9:0] select_3352;
  assign select_3352 = (equal_3325_s3_q & ({sum_3349[6], sum_3349} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3353;
  assign select_3353 = less_1853_s3_q ? select_3352 : 10'h3ff;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3355;
  assign select_3355 = less_1853_s3_q ? (equal_1856_s3_q ? 10'h3ff : select_3353) : 10'h3ff;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3356;
  assign select_3356 = equal_1856_s3_q ? select_3355 : select_3353;
  logic [9:0] select_3358;
  assign select_3358 = less_1853_s3_q ? (equal_1854_s3_q ? 10'h3ff : select_3356) : select_3356;
  // hls/stages/patches.hpp:534
  logic [14:0] select_3360;
  assign select_3360 = and_3328 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3361;
  assign select_3361 = equal_1690_s3_q ? select_3360[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3362;
  assign select_3362 = equal_1690_s3_q ? select_3360[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:536
  logic [9:0] select_3364;
  assign select_3364 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3366;
  assign select_3366 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3369;
  assign select_3369 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3370;
  assign select_3370 = patches_read_first_q ? patches_read_far_q : select_3369;
  // hls/stages/patches.hpp:589
  logic [9:0] difference_3373;
  assign difference_3373 = select_3370 - select_3360[9:0];
  // hls/stages/patches.hpp:574
  logic less_3403;
  assign less_3403 = select_3364 < select_3366;
  // hls/stages/patches.hpp:580
  logic [1:0] sum_3404;
  assign sum_3404 = select_3329[4:3] + 2'h3;
  // hls/stages/patches.hpp:575
  logic [9:0] high;
  assign high = less_3403 ? select_3366 : select_3364;
  logic [9:0] low;
  assign low = (select_3366 < select_3364) ? select_3366 : select_3364;
  // hls/stages/patches.hpp:576
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3360[9:0];
  // hls/stages/patches.hpp:578
  logic not_3411;
  assign not_3411 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3412;
  assign sum_3412 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3414;
  assign not_3414 = ~({eight, 3'h0} < {1'b0, sum_3412, fall[0]});
  logic [1:0] sum_3415;
  assign sum_3415 = {1'b0, not_3411} + {1'b0, not_3414};
  // hls/stages/patches.hpp:579
  logic [10:0] sum_3416;
  assign sum_3416 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3418;
  assign not_3418 = ~({eight, 3'h0} < {sum_3416, fall[1:0]});
  logic not_3421;
  assign not_3421 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3422;
  assign sum_3422 = {1'b0, not_3418} + {1'b0, not_3421};
  // hls/stages/patches.hpp:578
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3415} + {1'b0, sum_3422};
  // hls/stages/patches.hpp:581
  logic [7:0] select_3425;
  assign select_3425 = less_3403 ? ({sum_3404, select_3329[2:0], 3'h0} - {5'h0, fraction}) : {sum_3404, select_3329[2:0], fraction};
  // hls/stages/agreement.hpp:1099
  logic equal_3588;
  assign equal_3588 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:776
  logic select_3652;
  assign select_3652 = equal_1477_s3_q ? shown_shown_q : (so_s3_q ? select_1919 : shown_shown_q);
  logic select_3654;
  assign select_3654 = equal_1477_s3_q ? shown_nearer_q : (so_s3_q ? select_1922 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3656;
  assign sum_3656 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:451
  logic [2:0] select_3658;
  assign select_3658 = less_3655_s3_q ? (sum_3656[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3660;
  assign select_3660 = equal_2295_s3_q ? (equal_580_s3_q ? 3'h0 : select_3658) : region_row_q;
  // hls/stages/agreement.hpp:776
  logic [7:0] select_3665;
  assign select_3665 = equal_1477_s3_q ? select_1879 : (so_s3_q ? (ends_cell_s3_q ? select_1972 : select_1879) : 8'h1);
  // hls/stages/agreement.hpp:451
  logic [8:0] select_3679;
  assign select_3679 = equal_580_s3_q ? {{2{difference_3677[6]}}, difference_3677} : (less_3655_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:511
  logic [8:0] select_3681;
  assign select_3681 = and_519_s3_q ? (equal_2295_s3_q ? select_3679 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:451
  logic [6:0] select_3683;
  assign select_3683 = equal_580_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:511
  logic [6:0] select_3685;
  assign select_3685 = and_519_s3_q ? (equal_2295_s3_q ? select_3683 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3686;
  assign sum_3686 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3687;
  assign select_3687 = sum_3656[7] ? {1'b1, sum_3656[6:0], region_down_rest_q[0]} : sum_3686;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3656[7];
  // hls/stages/agreement.hpp:451
  logic select_3691;
  assign select_3691 = equal_2295_s3_q ? (equal_580_s3_q | (less_3655_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:200
  logic or_3696;
  assign or_3696 = segment_starts_q | not_1517;
  // hls/stages/agreement.hpp:989
  logic select_3699;
  assign select_3699 = shift_2_s3_q[0] ? (sum_1892_s3_q ? (equal_1683 & or_1894) : or_1894) : or_3696;
  // hls/stages/agreement.hpp:776
  logic select_3702;
  assign select_3702 = equal_1477_s3_q ? or_3696 : (so_s3_q ? (ends_cell_s3_q ? select_3699 : or_3696) : or_3696);
  logic [2:0] select_3776;
  assign select_3776 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_3778;
  assign select_3778 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3780;
  assign select_3780 = equal_1477_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3778 : box_textured_columns_values_1_q);
  logic [2:0] select_3781;
  assign select_3781 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3783;
  assign select_3783 = equal_1477_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_3781 : box_textured_columns_values_2_q);
  logic [2:0] select_3784;
  assign select_3784 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3786;
  assign select_3786 = equal_1477_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_3784 : box_textured_columns_values_3_q);
  logic [2:0] select_3787;
  assign select_3787 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3789;
  assign select_3789 = equal_1477_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_3787 : box_textured_columns_values_4_q);
  logic [4:0] select_3791;
  assign select_3791 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3794;
  assign select_3794 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3796;
  assign select_3796 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3798;
  assign select_3798 = equal_1477_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_3796 : box_explained_columns_values_1_q);
  logic [2:0] select_3799;
  assign select_3799 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3801;
  assign select_3801 = equal_1477_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_3799 : box_explained_columns_values_2_q);
  logic [2:0] select_3802;
  assign select_3802 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3804;
  assign select_3804 = equal_1477_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_3802 : box_explained_columns_values_3_q);
  logic [2:0] select_3805;
  assign select_3805 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3807;
  assign select_3807 = equal_1477_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_3805 : box_explained_columns_values_4_q);
  logic [4:0] select_3809;
  assign select_3809 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3810;
  assign select_3810 = equal_1477_s3_q ? box_explained_sum_sums_values_0_q : select_3809;
  logic [2:0] select_3812;
  assign select_3812 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3814;
  assign select_3814 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3816;
  assign select_3816 = equal_1477_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_3814 : box_shown_columns_values_1_q);
  logic [2:0] select_3817;
  assign select_3817 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3819;
  assign select_3819 = equal_1477_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_3817 : box_shown_columns_values_2_q);
  logic [2:0] select_3820;
  assign select_3820 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3822;
  assign select_3822 = equal_1477_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_3820 : box_shown_columns_values_3_q);
  logic [2:0] select_3823;
  assign select_3823 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3825;
  assign select_3825 = equal_1477_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_3823 : box_shown_columns_values_4_q);
  logic [4:0] select_3827;
  assign select_3827 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_3830;
  assign select_3830 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3832;
  assign select_3832 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3834;
  assign select_3834 = equal_1477_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_3832 : box_nearer_columns_values_1_q);
  logic [2:0] select_3835;
  assign select_3835 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3837;
  assign select_3837 = equal_1477_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_3835 : box_nearer_columns_values_2_q);
  logic [2:0] select_3838;
  assign select_3838 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3840;
  assign select_3840 = equal_1477_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_3838 : box_nearer_columns_values_3_q);
  logic [2:0] select_3841;
  assign select_3841 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3843;
  assign select_3843 = equal_1477_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_3841 : box_nearer_columns_values_4_q);
  logic [4:0] select_3845;
  assign select_3845 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_3848;
  assign select_3848 = so_s3_q ? (ends_cell_s3_q ? and_1960 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3851;
  assign select_3851 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_3853;
  assign select_3853 = equal_1477_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_3851 : centres_values_0_of_skin_q);
  logic select_3854;
  assign select_3854 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3856;
  assign select_3856 = equal_1477_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_3854 : centres_values_1_textured_q);
  logic select_3857;
  assign select_3857 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3859;
  assign select_3859 = equal_1477_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_3857 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:451
  logic [10:0] select_3863;
  assign select_3863 = equal_2295_s3_q ? (equal_3860_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:511
  logic [5:0] select_3866;
  assign select_3866 = and_519_s3_q ? (equal_2295_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1212
  logic xor_3867;
  assign xor_3867 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:428
  logic select_3869;
  assign select_3869 = and_1871_s3_q ? (left_first_s3_q ? xor_3867 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:269
  logic select_3871;
  assign select_3871 = and_1871_s3_q ? (left_first_s3_q ? xor_3867 : select_3869) : write_half_q;
  logic select_3873;
  assign select_3873 = left_first_s3_q ? select_1925 : (and_1871_s3_q ? select_1926 : read_half_q);
  logic and_3877;
  assign and_3877 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_3886;
  assign select_3886 = left_first_s3_q ? 10'h1 : (and_1871_s3_q ? select_1930 : rows_passed_q);
  logic [8:0] select_3889;
  assign select_3889 = left_first_s3_q ? {select_1928[7:0], or_1927} : (and_1871_s3_q ? {select_1928[7:0], or_1927} : columns_passed_q);
  logic select_3892;
  assign select_3892 = left_first_s3_q ? marks_last_s3_q : (and_1871_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_3895;
  assign select_3895 = left_first_s3_q ? and_1944 : (and_1871_s3_q ? and_1944 : began_q);
  logic [2:0] select_3898;
  assign select_3898 = left_first_s3_q ? select_1946 : (and_1871_s3_q ? select_1946 : seen_x_q);
  // hls/stages/agreement.hpp:1241
  logic [2:0] select_3903;
  assign select_3903 = left_first_s3_q ? 3'h0 : (and_1931 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:269
  logic [2:0] select_3905;
  assign select_3905 = left_first_s3_q ? 3'h0 : (and_1871_s3_q ? select_3903 : seen_y_q);
  logic [7:0] select_3908;
  assign select_3908 = left_first_s3_q ? select_1939 : (and_1871_s3_q ? select_1939 : seen_column_q);
  // hls/stages/agreement.hpp:426
  logic [7:0] select_3914;
  assign select_3914 = left_first_s3_q ? select_3912 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:269
  logic [7:0] select_3916;
  assign select_3916 = left_first_s3_q ? select_3912 : (and_1871_s3_q ? select_3914 : seen_rows_left_q);
  // hls/stages/agreement.hpp:426
  logic and_3921;
  assign and_3921 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:269
  logic select_3923;
  assign select_3923 = left_first_s3_q ? and_3921 : (and_1871_s3_q ? and_3921 : at_cell_end_q);
  logic select_3926;
  assign select_3926 = left_first_s3_q ? next_row : (and_1871_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_3929;
  assign select_3929 = left_first_s3_q ? 11'h0 : (and_1871_s3_q ? select_1936 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_3998;
  assign not_3998 = ~quarter[1];
  logic [3:0] select_3999;
  assign select_3999 = quarter[0] ? {quarter[1], 1'b0, not_3998, 1'b0} : {1'b0, quarter[1], 1'b0, not_3998};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1529;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_1572;
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 22, DISTANCE 12, hls/stages/patches.hpp:762; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [21:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 22'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1606;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_1608));
  logic [21:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1334; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1889;
  logic regions_re;
  assign regions_re = s3_en & (equal_1477_s3_q ? (x_s3_q[6] & not_1890) : and_1897);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1345; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_1941;
  logic map_re;
  assign map_re = s3_en & select_1953;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_489_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_494_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_513, and_509, sum_505, sum_501};
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
  assign census_memory_we = s3_en & and_519_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_537, whole_2, select_529, select_525};
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
  assign shown_right_waddr = select_1516_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1521_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1518, not_1517};
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
  assign patches_right_codes_waddr = {sum_1804, patches_code_row_s3_q[1:0], of_row_2_s3_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_1838_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1824_s3_q, less_1823_s3_q, less_1814_s3_q, less_1813_s3_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1842, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_1852_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1824_s3_q, less_1823_s3_q, less_1814_s3_q, less_1813_s3_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s3_en & and_1512_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1918, textured_s3_q};
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
      averager_running_of_skin_q <= select_2084;
      averager_mask_q <= select_2086;
      averager_of_skin_q <= select_2088;
      census_filled_q <= and_519_s3_q ? {select_583[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_519_s3_q ? select_582 : rows_passed_above_q;
      registration_slope_here_q <= select_2529;
      registration_expected_q <= select_2531;
      registration_of_right_q <= equal_1477_s3_q ? registration_of_right_q : select_2591;
      registration_was_inside_q <= equal_1477_s3_q ? registration_was_inside_q : select_2594;
      registration_fresh_q <= select_2603;
      patches_chance_q <= and_519_s3_q ? select_2760 : patches_chance_q;
      patches_fixed_q <= and_2774;
      patches_choice_valid_q <= and_1688 ? (select_1682[0] & not_2762) : select_1682[0];
      patches_choice_column_q <= select_1682[7:1];
      patches_choice_shift_q <= select_1682[13:8];
      patches_choice_slope_q <= select_1682[21:14];
      patches_band_q <= sample_pair_whole_s3_q ? select_1703 : patches_band_q;
      patches_fetch_q <= select_2789;
      patches_codes_at_q <= select_2890;
      patches_codes_further_q <= equal_1690_s3_q ? patches_codes_further_q : select_2895;
      patches_next_codes_q <= select_2903;
      patches_set_q <= equal_1690_s3_q ? 3'h0 : (equal_1692_s3_q ? 3'h0 : select_2917);
      patches_size_q <= sum_2921;
      patches_left_row_q <= select_2933;
      patches_summed_row_column_q <= equal_1690_s3_q ? patches_summed_row_column_q : select_3278;
      patches_summed_first_q <= select_3281;
      patches_read_row_differing_q <= equal_1690_s3_q ? select_3293 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1690_s3_q ? select_3300 : patches_read_row_column_q;
      patches_read_at_q <= equal_1690_s3_q ? select_3307 : patches_read_at_q;
      patches_read_first_q <= select_3316;
      patches_read_above_q <= select_3339;
      patches_read_below_q <= select_3348;
      patches_read_far_q <= equal_1690_s3_q ? select_3358 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3361;
      patches_peak_best_column_q <= select_3362;
      patches_peak_row_q <= equal_1690_s3_q ? select_3329 : patches_peak_row_q;
      patches_peak_above_q <= equal_1690_s3_q ? select_3364 : patches_peak_above_q;
      patches_peak_below_q <= equal_1690_s3_q ? select_3366 : patches_peak_below_q;
      patches_peak_far_q <= equal_1690_s3_q ? select_3370 : patches_peak_far_q;
      shown_shown_q <= select_3652;
      shown_nearer_q <= select_3654;
      region_row_q <= and_519_s3_q ? select_3660 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3665;
      region_down_rest_q <= select_3681;
      region_down_back_q <= select_3685;
      region_down_next_q <= select_3687;
      region_fresh_q <= and_519_s3_q ? select_3691 : region_fresh_q;
      segment_starts_q <= select_3702;
      centres_values_0_textured_q <= equal_1477_s3_q ? centres_values_0_textured_q : select_3848;
      centres_values_0_of_skin_q <= select_3853;
      centres_values_1_textured_q <= select_3856;
      centres_values_1_of_skin_q <= select_3859;
      map_row_q <= and_519_s3_q ? select_3863 : map_row_q;
      map_width_q <= select_3866;
      write_half_q <= select_3871;
      read_half_q <= and_1871_s3_q ? select_3873 : read_half_q;
      done_q <= and_1871_s3_q ? (not_1942 & and_3877) : and_3877;
      drew_q <= so_s3_q;
      said_q <= equal_1477_s3_q & equal_3588;
      rows_passed_q <= and_1871_s3_q ? select_3886 : rows_passed_q;
      columns_passed_q <= and_1871_s3_q ? select_3889 : columns_passed_q;
      line_ended_q <= and_1871_s3_q ? select_3892 : line_ended_q;
      began_q <= and_1871_s3_q ? select_3895 : began_q;
      seen_x_q <= and_1871_s3_q ? select_3898 : seen_x_q;
      seen_y_q <= and_1871_s3_q ? select_3905 : seen_y_q;
      seen_column_q <= and_1871_s3_q ? select_3908 : seen_column_q;
      seen_rows_left_q <= and_1871_s3_q ? select_3916 : seen_rows_left_q;
      at_cell_end_q <= and_1871_s3_q ? select_3923 : at_cell_end_q;
      was_next_row_q <= and_1871_s3_q ? select_3926 : was_next_row_q;
      seen_base_q <= and_1871_s3_q ? select_3929 : seen_base_q;
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
      left_pixel_q <= and_1871_s3_q ? left_pixel_q : pixel_0_s3_q;
      averager_running_0_q <= sample_pair_whole_s3_q ? select_497 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_503 : averager_running_1_q;
      averager_total_0_q <= select_2063;
      averager_total_1_q <= select_2065;
      census_columns_values_0_cell_0_left_q <= select_2089;
      census_columns_values_0_cell_0_right_q <= select_2090;
      census_columns_values_0_cell_0_mask_q <= and_519_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2092;
      census_columns_values_0_cell_1_right_q <= select_2093;
      census_columns_values_0_cell_1_mask_q <= select_2094;
      census_columns_values_0_cell_2_left_q <= select_2095;
      census_columns_values_0_cell_2_right_q <= select_2096;
      census_columns_values_0_cell_2_mask_q <= select_2097;
      census_columns_values_0_cell_2_of_skin_q <= select_2098;
      census_columns_values_0_cell_3_left_q <= select_2099;
      census_columns_values_0_cell_3_right_q <= select_2100;
      census_columns_values_0_cell_3_mask_q <= select_2101;
      census_columns_values_0_cell_4_left_q <= select_2102;
      census_columns_values_0_cell_4_right_q <= select_2103;
      census_columns_values_0_cell_4_mask_q <= select_2104;
      census_columns_values_1_cell_0_left_q <= select_2105;
      census_columns_values_1_cell_0_right_q <= select_2106;
      census_columns_values_1_cell_0_mask_q <= select_2107;
      census_columns_values_1_cell_1_left_q <= select_2108;
      census_columns_values_1_cell_1_right_q <= select_2109;
      census_columns_values_1_cell_1_mask_q <= select_2110;
      census_columns_values_1_cell_2_left_q <= select_2111;
      census_columns_values_1_cell_2_right_q <= select_2112;
      census_columns_values_1_cell_2_mask_q <= select_2113;
      census_columns_values_1_cell_2_of_skin_q <= select_2114;
      census_columns_values_1_cell_3_left_q <= select_2115;
      census_columns_values_1_cell_3_right_q <= select_2116;
      census_columns_values_1_cell_3_mask_q <= select_2117;
      census_columns_values_1_cell_4_left_q <= select_2118;
      census_columns_values_1_cell_4_right_q <= select_2119;
      census_columns_values_1_cell_4_mask_q <= select_2120;
      census_columns_values_2_cell_0_left_q <= select_2121;
      census_columns_values_2_cell_0_right_q <= select_2122;
      census_columns_values_2_cell_0_mask_q <= select_2123;
      census_columns_values_2_cell_1_left_q <= select_2124;
      census_columns_values_2_cell_1_right_q <= select_2125;
      census_columns_values_2_cell_1_mask_q <= select_2126;
      census_columns_values_2_cell_2_left_q <= select_2127;
      census_columns_values_2_cell_2_right_q <= select_2128;
      census_columns_values_2_cell_2_mask_q <= select_2129;
      census_columns_values_2_cell_3_left_q <= select_2130;
      census_columns_values_2_cell_3_right_q <= select_2131;
      census_columns_values_2_cell_3_mask_q <= select_2132;
      census_columns_values_2_cell_4_left_q <= select_2133;
      census_columns_values_2_cell_4_right_q <= select_2134;
      census_columns_values_2_cell_4_mask_q <= select_2135;
      census_columns_values_3_cell_0_mask_q <= select_2136;
      census_columns_values_3_cell_1_left_q <= select_2137;
      census_columns_values_3_cell_1_right_q <= select_2138;
      census_columns_values_3_cell_1_mask_q <= select_2139;
      census_columns_values_3_cell_2_mask_q <= select_2140;
      census_columns_values_3_cell_3_left_q <= select_2141;
      census_columns_values_3_cell_3_right_q <= select_2142;
      census_columns_values_3_cell_3_mask_q <= select_2143;
      census_columns_values_3_cell_4_mask_q <= select_2144;
      sharpness_last_mean_0_q <= and_519_s3_q ? select_525 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_519_s3_q ? select_529 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1477_s3_q ? box_textured_columns_values_0_q : select_3776;
      box_textured_columns_values_1_q <= select_3780;
      box_textured_columns_values_2_q <= select_3783;
      box_textured_columns_values_3_q <= select_3786;
      box_textured_columns_values_4_q <= select_3789;
      box_textured_sum_sums_values_0_q <= equal_1477_s3_q ? box_textured_sum_sums_values_0_q : select_3791;
      box_explained_columns_values_0_q <= equal_1477_s3_q ? box_explained_columns_values_0_q : select_3794;
      box_explained_columns_values_1_q <= select_3798;
      box_explained_columns_values_2_q <= select_3801;
      box_explained_columns_values_3_q <= select_3804;
      box_explained_columns_values_4_q <= select_3807;
      box_explained_sum_sums_values_0_q <= select_3810;
      box_shown_columns_values_0_q <= equal_1477_s3_q ? box_shown_columns_values_0_q : select_3812;
      box_shown_columns_values_1_q <= select_3816;
      box_shown_columns_values_2_q <= select_3819;
      box_shown_columns_values_3_q <= select_3822;
      box_shown_columns_values_4_q <= select_3825;
      box_shown_sum_sums_values_0_q <= equal_1477_s3_q ? box_shown_sum_sums_values_0_q : select_3827;
      box_nearer_columns_values_0_q <= equal_1477_s3_q ? box_nearer_columns_values_0_q : select_3830;
      box_nearer_columns_values_1_q <= select_3834;
      box_nearer_columns_values_2_q <= select_3837;
      box_nearer_columns_values_3_q <= select_3840;
      box_nearer_columns_values_4_q <= select_3843;
      box_nearer_sum_sums_values_0_q <= equal_1477_s3_q ? box_nearer_sum_sums_values_0_q : select_3845;
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
  logic [2:0] select_483_s4_q;
  logic [5:0] select_485_s4_q;
  logic [5:0] column_s4_q;
  logic and_517_s4_q;
  logic and_519_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_522_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic less_553_s4_q;
  logic less_554_s4_q;
  logic less_555_s4_q;
  logic less_556_s4_q;
  logic less_557_s4_q;
  logic less_558_s4_q;
  logic less_559_s4_q;
  logic less_560_s4_q;
  logic less_561_s4_q;
  logic less_562_s4_q;
  logic less_563_s4_q;
  logic less_564_s4_q;
  logic less_565_s4_q;
  logic less_566_s4_q;
  logic less_567_s4_q;
  logic less_568_s4_q;
  logic less_569_s4_q;
  logic less_570_s4_q;
  logic less_571_s4_q;
  logic less_572_s4_q;
  logic less_573_s4_q;
  logic less_574_s4_q;
  logic less_575_s4_q;
  logic less_576_s4_q;
  logic and_584_s4_q;
  logic and_609_s4_q;
  logic and_610_s4_q;
  logic [11:0] sum_625_s4_q;
  logic [9:0] sum_628_s4_q;
  logic equal_1477_s4_q;
  logic not_1478_s4_q;
  logic equal_1522_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1528_s4_q;
  logic equal_1530_s4_q;
  logic equal_1532_s4_q;
  logic equal_1534_s4_q;
  logic equal_1536_s4_q;
  logic equal_1538_s4_q;
  logic equal_1540_s4_q;
  logic equal_1542_s4_q;
  logic equal_1544_s4_q;
  logic less_1553_s4_q;
  logic or_1557_s4_q;
  logic equal_1577_s4_q;
  logic and_1587_s4_q;
  logic and_1590_s4_q;
  logic select_1607_s4_q;
  logic equal_1608_s4_q;
  logic and_1616_s4_q;
  logic equal_1618_s4_q;
  logic select_1682_s4_q;
  logic and_1689_s4_q;
  logic equal_1690_s4_q;
  logic equal_1692_s4_q;
  logic and_1705_s4_q;
  logic [4:0] select_1720_s4_q;
  logic select_1726_s4_q;
  logic [3:0] select_1767_s4_q;
  logic less_1853_s4_q;
  logic equal_1854_s4_q;
  logic not_1855_s4_q;
  logic equal_1856_s4_q;
  logic and_1871_s4_q;
  logic select_1873_s4_q;
  logic and_1876_s4_q;
  logic or_1882_s4_q;
  logic or_1885_s4_q;
  logic or_1888_s4_q;
  logic not_1890_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_1911_s4_q;
  logic and_1916_s4_q;
  logic and_1948_s4_q;
  logic less_1949_s4_q;
  logic [11:0] sum_1957_s4_q;
  logic equal_1970_s4_q;
  logic or_1975_s4_q;
  logic or_1978_s4_q;
  logic or_1981_s4_q;
  logic not_2006_s4_q;
  logic less_2020_s4_q;
  logic and_2031_s4_q;
  logic [11:0] sum_2160_s4_q;
  logic [9:0] sum_2163_s4_q;
  logic equal_2171_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2420_s4_q;
  logic and_2424_s4_q;
  logic not_2458_s4_q;
  logic and_2486_s4_q;
  logic and_2535_s4_q;
  logic and_2536_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2570_s4_q;
  logic and_2584_s4_q;
  logic equal_2627_s4_q;
  logic parity_3005_s4_q;
  logic parity_3134_s4_q;
  logic parity_3196_s4_q;
  logic xor_3224_s4_q;
  logic parity_3236_s4_q;
  logic or_3240_s4_q;
  logic equal_3241_s4_q;
  logic [4:0] select_3360_s4_q;
  logic equal_3372_s4_q;
  logic less_3374_s4_q;
  logic less_3375_s4_q;
  logic or_3380_s4_q;
  logic [7:0] select_3425_s4_q;
  logic equal_3588_s4_q;
  logic and_3932_s4_q;
  logic equal_4001_s4_q;
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
      select_483_s4_q <= select_483_s3_q;
      select_485_s4_q <= select_485_s3_q;
      column_s4_q <= column_s3_q;
      and_517_s4_q <= and_517_s3_q;
      and_519_s4_q <= and_519_s3_q;
      grey_s4_q <= grey;
      equal_522_s4_q <= equal_522;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      less_553_s4_q <= less_553;
      less_554_s4_q <= less_554;
      less_555_s4_q <= less_555;
      less_556_s4_q <= less_556;
      less_557_s4_q <= less_557;
      less_558_s4_q <= less_558;
      less_559_s4_q <= less_559;
      less_560_s4_q <= less_560;
      less_561_s4_q <= less_561;
      less_562_s4_q <= less_562;
      less_563_s4_q <= less_563;
      less_564_s4_q <= less_564;
      less_565_s4_q <= less_565;
      less_566_s4_q <= less_566;
      less_567_s4_q <= less_567;
      less_568_s4_q <= less_568;
      less_569_s4_q <= less_569;
      less_570_s4_q <= less_570;
      less_571_s4_q <= less_571;
      less_572_s4_q <= less_572;
      less_573_s4_q <= less_573;
      less_574_s4_q <= less_574;
      less_575_s4_q <= less_575;
      less_576_s4_q <= less_576;
      and_584_s4_q <= and_584;
      and_609_s4_q <= whole_22 & and_584;
      and_610_s4_q <= census_columns_values_1_cell_2_mask_q & and_584;
      sum_625_s4_q <= {1'b0, sum_621} + {2'h0, sum_624};
      sum_628_s4_q <= {9'h0, difference_626[9]} + {1'b0, xor_627};
      equal_1477_s4_q <= equal_1477_s3_q;
      not_1478_s4_q <= not_1478_s3_q;
      equal_1522_s4_q <= equal_1522;
      all_s4_q <= all;
      sum_1528_s4_q <= sum_1528;
      equal_1530_s4_q <= equal_1530;
      equal_1532_s4_q <= equal_1532;
      equal_1534_s4_q <= equal_1534;
      equal_1536_s4_q <= equal_1536;
      equal_1538_s4_q <= equal_1538;
      equal_1540_s4_q <= equal_1540;
      equal_1542_s4_q <= equal_1542;
      equal_1544_s4_q <= equal_1544;
      less_1553_s4_q <= less_1553;
      or_1557_s4_q <= or_1557;
      equal_1577_s4_q <= (registration_fresh_q & select_1575) == 4'h0;
      and_1587_s4_q <= not_1478_s3_q & and_1571;
      and_1590_s4_q <= and_1590_s3_q;
      select_1607_s4_q <= select_1607[1];
      equal_1608_s4_q <= equal_1608;
      and_1616_s4_q <= and_1616;
      equal_1618_s4_q <= equal_1618;
      select_1682_s4_q <= select_1682[0];
      and_1689_s4_q <= and_1689;
      equal_1690_s4_q <= equal_1690_s3_q;
      equal_1692_s4_q <= equal_1692_s3_q;
      and_1705_s4_q <= and_1689 & equal_1704;
      select_1720_s4_q <= select_1720_s3_q;
      select_1726_s4_q <= select_1726_s3_q;
      select_1767_s4_q <= select_1767_s3_q;
      less_1853_s4_q <= less_1853_s3_q;
      equal_1854_s4_q <= equal_1854_s3_q;
      not_1855_s4_q <= not_1855_s3_q;
      equal_1856_s4_q <= equal_1856_s3_q;
      and_1871_s4_q <= and_1871_s3_q;
      select_1873_s4_q <= select_1873_s3_q;
      and_1876_s4_q <= and_1876_s3_q;
      or_1882_s4_q <= or_1882;
      or_1885_s4_q <= or_1885;
      or_1888_s4_q <= or_1888;
      not_1890_s4_q <= not_1890;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_1911_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_1916_s4_q <= not_1478_s3_q & and_1897;
      and_1948_s4_q <= and_1948;
      less_1949_s4_q <= less_1949;
      sum_1957_s4_q <= sum_1957;
      equal_1970_s4_q <= t[4:1] == 4'h0;
      or_1975_s4_q <= or_1975;
      or_1978_s4_q <= select_1972[7] | (~({select_1972[6], select_1972[3:2]} == 3'h0));
      or_1981_s4_q <= select_1972[7] | (~(select_1972[6:4] == 3'h0));
      not_2006_s4_q <= ~({sum_2004, around[0]} < {2'h0, t});
      less_2020_s4_q <= {1'b0, around[4:1]} < n;
      and_2031_s4_q <= and_2031;
      sum_2160_s4_q <= {1'b0, sum_2156} + {2'h0, sum_2159};
      sum_2163_s4_q <= {9'h0, difference_2161[9]} + {1'b0, xor_2162};
      equal_2171_s4_q <= equal_2171_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2420_s4_q <= and_2420;
      and_2424_s4_q <= and_2424;
      not_2458_s4_q <= ~({sum_2456, e[0]} < {2'h0, t});
      and_2486_s4_q <= not_1478_s3_q & and_2485;
      and_2535_s4_q <= not_1478_s3_q & (so_s3_q & (half_ends & equal_2532));
      and_2536_s4_q <= and_2536;
      residual_s4_q <= residual[7:0];
      and_2570_s4_q <= and_2570;
      and_2584_s4_q <= and_2536 & less_2583;
      equal_2627_s4_q <= (registration_fresh_q & select_2625) == 4'h0;
      parity_3005_s4_q <= ^{xor_3001, xor_2964, select_2931[44:36], other[44:36]};
      parity_3134_s4_q <= parity_3134;
      parity_3196_s4_q <= parity_3196;
      xor_3224_s4_q <= parity_3211 ^ parity_3223;
      parity_3236_s4_q <= ^{or_3233, or_3229, and_3225};
      or_3240_s4_q <= (or_3229 & or_3233) | (and_3225 & (or_3229 | or_3233));
      equal_3241_s4_q <= equal_3241_s3_q;
      select_3360_s4_q <= select_3360[14:10];
      equal_3372_s4_q <= select_3329[3:0] == 4'h0;
      less_3374_s4_q <= {difference_3373, 3'h0} < {3'h0, sum_2921};
      less_3375_s4_q <= select_3370 < select_3360[9:0];
      or_3380_s4_q <= (sum_2921 < 10'h39) | ({1'b0, sum_2921[9:1]} < select_3360[9:0]);
      select_3425_s4_q <= select_3425;
      equal_3588_s4_q <= equal_3588;
      and_3932_s4_q <= and_2031 & (sum_1957 == sum_1941);
      equal_4001_s4_q <= (registration_fresh_q & select_3999) == 4'h0;
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
  logic patches_partly_q;
  logic [6:0] patches_clear_limit_q;
  logic patches_complete_q;
  logic patches_frame_ended_q;
  logic patches_round_ends_q;
  logic [2:0] patches_found_q;
  logic patches_doubted_q;
  logic patches_doubted_before_q;
  logic [7:0] patches_round_places_q;
  logic [11:0] patches_round_across_q;
  logic [2:0] patches_round_moved_q;
  logic [7:0] patches_round_on_skin_q;
  logic [7:0] patches_on_skin_q;
  logic [7:0] patches_on_skin_most_q;
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  logic patches_suspected_q;
  logic patches_moved_q;
  logic patches_twice_q;
  logic patches_clear_q;
  logic [9:0] patches_age_q;
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
  assign texture = sum_625_s4_q + {2'h0, sum_628_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_630;
  assign sum_630 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_632;
  assign sum_632 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_630});
  // hls/stages/census.hpp:303
  logic less_633;
  assign less_633 = 9'h4 < sum_632[13:5];
  logic and_634;
  assign and_634 = and_584_s4_q & less_633;
  // hls/stages/registration.hpp:265
  logic equal_1579;
  assign equal_1579 = sum_1528_s4_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1528_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1581;
  assign select_1581 = equal_1579 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1582;
  assign sum_1582 = (equal_1577_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1581[13]}}, select_1581};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1528_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1585;
  assign select_1585 = equal_1579 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1586;
  assign sum_1586 = (equal_1577_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1585[6]}}, select_1585};
  // hls/stages/patches.hpp:352
  logic [21:0] select_1706;
  assign select_1706 = and_1705_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1682_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1708;
  assign select_1708 = equal_1608_s4_q ? patches_place_0_valid_q : (select_1607_s4_q ? patches_place_0_valid_q : select_1706[0]);
  // hls/stages/patches.hpp:353
  logic [20:0] select_1709;
  assign select_1709 = select_1607_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1706[21:1];
  // hls/stages/patches.hpp:127
  logic [6:0] select_1710;
  assign select_1710 = equal_1608_s4_q ? patches_place_0_column_q : select_1709[6:0];
  logic [5:0] select_1711;
  assign select_1711 = equal_1608_s4_q ? patches_place_0_shift_q : select_1709[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1712;
  assign sum_1712 = select_1710 + {select_1711[5], select_1711};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1713;
  assign sum_1713 = sum_1712[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1714;
  assign equal_1714 = {sum_1713[5], select_485_s4_q, select_483_s4_q} == {1'b0, sum_1713[4:0], sum_1712[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1716;
  assign or_1716 = and_1590_s4_q | (select_1708 & equal_1714);
  // hls/stages/agreement.hpp:267
  logic [4:0] select_1717;
  assign select_1717 = or_1716 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1727;
  assign select_1727 = or_1716 ? {and_1590_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1729;
  assign and_1729 = select_1726_s4_q & (~select_1727[5]);
  // hls/stages/patches.hpp:127
  logic select_1737;
  assign select_1737 = equal_1608_s4_q ? patches_place_1_valid_q : (select_1607_s4_q ? select_1706[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:353
  logic [20:0] select_1738;
  assign select_1738 = select_1607_s4_q ? select_1706[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [6:0] select_1739;
  assign select_1739 = equal_1608_s4_q ? patches_place_1_column_q : select_1738[6:0];
  logic [5:0] select_1740;
  assign select_1740 = equal_1608_s4_q ? patches_place_1_shift_q : select_1738[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1741;
  assign sum_1741 = select_1739 + {select_1740[5], select_1740};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1742;
  assign sum_1742 = sum_1741[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1743;
  assign equal_1743 = {sum_1742[5], select_485_s4_q, select_483_s4_q} == {1'b0, sum_1742[4:0], sum_1741[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1745;
  assign or_1745 = and_1590_s4_q | (select_1737 & equal_1743);
  // hls/stages/agreement.hpp:267
  logic [4:0] select_1746;
  assign select_1746 = or_1745 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1747;
  assign select_1747 = or_1745 ? {and_1590_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1749;
  assign and_1749 = select_1726_s4_q & (~select_1747[5]);
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1756;
  assign sum_1756 = select_1710 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1757;
  assign equal_1757 = {sum_1756[6], select_485_s4_q, select_483_s4_q} == {1'b0, sum_1756[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_1759;
  assign or_1759 = and_1590_s4_q | (select_1708 & equal_1757);
  logic [4:0] select_1760;
  assign select_1760 = or_1759 ? {and_1590_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1761;
  assign sum_1761 = select_1739 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1762;
  assign equal_1762 = {sum_1761[6], select_485_s4_q, select_483_s4_q} == {1'b0, sum_1761[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_1765;
  assign select_1765 = (and_1590_s4_q | (select_1737 & equal_1762)) ? {and_1590_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_5;
  assign column_5 = select_1760[4] ? select_1765[3:0] : select_1760[3:0];
  // hls/stages/agreement.hpp:267
  logic select_1768;
  assign select_1768 = or_1759 ? and_1590_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_1774;
  assign and_1774 = (select_1726_s4_q & (select_1720_s4_q[3] ^ select_1720_s4_q[4])) & ((~select_1760[4]) | (~select_1765[4]));
  // hls/stages/patches.hpp:184
  logic less_1865;
  assign less_1865 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1866;
  assign not_1866 = ~less_1865;
  logic [1:0] select_1867;
  assign select_1867 = patches_summed_first_s4_q ? 2'h2 : {less_1865, not_1866};
  logic [12:0] select_1869;
  assign select_1869 = select_1867[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1877;
  assign select_1877 = select_1867[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1876_s4_q, 1'b0, select_1873_s4_q, left_pixel_q};
  logic [14:0] select_1878;
  assign select_1878 = (select_1867 == 2'h2) ? {select_1869[12:8], patches_sums_values_0_q[9:8], select_1869[7:0]} : select_1877;
  // hls/stages/agreement.hpp:879
  logic [5:0] select_1901;
  assign select_1901 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:880
  logic [5:0] sum_1902;
  assign sum_1902 = {5'h0, textured_s4_q} + select_1901;
  // hls/stages/agreement.hpp:1016
  logic [9:0] sum_1904;
  assign sum_1904 = {4'h0, sum_1902} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:879
  logic [5:0] select_1906;
  assign select_1906 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:880
  logic [5:0] sum_1907;
  assign sum_1907 = {5'h0, explained_s4_q} + select_1906;
  // hls/stages/agreement.hpp:1017
  logic [9:0] sum_1909;
  assign sum_1909 = {4'h0, sum_1907} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:879
  logic [5:0] select_1912;
  assign select_1912 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:881
  logic [5:0] sum_1913;
  assign sum_1913 = {5'h0, and_1911_s4_q} + select_1912;
  // hls/stages/agreement.hpp:1018
  logic [9:0] sum_1915;
  assign sum_1915 = {4'h0, sum_1913} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1056
  logic not_1982;
  assign not_1982 = ~region_row_s4_q[2];
  logic [2:0] select_1983;
  assign select_1983 = region_row_s4_q[1] ? {1'b0, not_1982, 1'b0} : {region_row_s4_q[2], 1'b0, not_1982};
  logic [5:0] select_1984;
  assign select_1984 = region_row_s4_q[0] ? {select_1983[2], 1'b0, select_1983[1], 1'b0, select_1983[0], 1'b0} : {1'b0, select_1983[2], 1'b0, select_1983[1], 1'b0, select_1983[0]};
  logic [11:0] select_1985;
  assign select_1985 = or_1981_s4_q ? {select_1984[5], 1'b0, select_1984[4], 1'b0, select_1984[3], 1'b0, select_1984[2], 1'b0, select_1984[1], 1'b0, select_1984[0], 1'b0} : {1'b0, select_1984[5], 1'b0, select_1984[4], 1'b0, select_1984[3], 1'b0, select_1984[2], 1'b0, select_1984[1], 1'b0, select_1984[0]};
  logic [23:0] select_1986;
  assign select_1986 = or_1978_s4_q ? {select_1985[11], 1'b0, select_1985[10], 1'b0, select_1985[9], 1'b0, select_1985[8], 1'b0, select_1985[7], 1'b0, select_1985[6], 1'b0, select_1985[5], 1'b0, select_1985[4], 1'b0, select_1985[3], 1'b0, select_1985[2], 1'b0, select_1985[1], 1'b0, select_1985[0], 1'b0} : {1'b0, select_1985[11], 1'b0, select_1985[10], 1'b0, select_1985[9], 1'b0, select_1985[8], 1'b0, select_1985[7], 1'b0, select_1985[6], 1'b0, select_1985[5], 1'b0, select_1985[4], 1'b0, select_1985[3], 1'b0, select_1985[2], 1'b0, select_1985[1], 1'b0, select_1985[0]};
  logic [47:0] select_1987;
  assign select_1987 = or_1975_s4_q ? {select_1986[23], 1'b0, select_1986[22], 1'b0, select_1986[21], 1'b0, select_1986[20], 1'b0, select_1986[19], 1'b0, select_1986[18], 1'b0, select_1986[17], 1'b0, select_1986[16], 1'b0, select_1986[15], 1'b0, select_1986[14], 1'b0, select_1986[13], 1'b0, select_1986[12], 1'b0, select_1986[11], 1'b0, select_1986[10], 1'b0, select_1986[9], 1'b0, select_1986[8], 1'b0, select_1986[7], 1'b0, select_1986[6], 1'b0, select_1986[5], 1'b0, select_1986[4], 1'b0, select_1986[3], 1'b0, select_1986[2], 1'b0, select_1986[1], 1'b0, select_1986[0], 1'b0} : {1'b0, select_1986[23], 1'b0, select_1986[22], 1'b0, select_1986[21], 1'b0, select_1986[20], 1'b0, select_1986[19], 1'b0, select_1986[18], 1'b0, select_1986[17], 1'b0, select_1986[16], 1'b0, select_1986[15], 1'b0, select_1986[14], 1'b0, select_1986[13], 1'b0, select_1986[12], 1'b0, select_1986[11], 1'b0, select_1986[10], 1'b0, select_1986[9], 1'b0, select_1986[8], 1'b0, select_1986[7], 1'b0, select_1986[6], 1'b0, select_1986[5], 1'b0, select_1986[4], 1'b0, select_1986[3], 1'b0, select_1986[2], 1'b0, select_1986[1], 1'b0, select_1986[0]};
  // hls/stages/agreement.hpp:989
  logic and_1991;
  assign and_1991 = good_known_q & (~((good_q & select_1987) == 48'h0));
  // hls/stages/agreement.hpp:1058
  logic is_seen;
  assign is_seen = equal_1970_s4_q ? and_1991 : not_2006_s4_q;
  // hls/stages/agreement.hpp:1067
  logic and_2021;
  assign and_2021 = is_seen & less_2020_s4_q;
  // hls/stages/agreement.hpp:267
  logic [8:0] select_2055;
  assign select_2055 = sample_pair_whole_s4_q ? (and_517_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2057;
  assign select_2057 = sample_pair_whole_s4_q ? (and_517_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2059;
  assign select_2059 = sample_pair_whole_s4_q ? (and_517_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2061;
  assign select_2061 = sample_pair_whole_s4_q ? (and_517_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2066;
  assign sum_2066 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2067;
  assign difference_2067 = {1'b0, sum_2066[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2068;
  assign xor_2068 = {difference_2067[8:0], sum_2066[0]} ^ {10{difference_2067[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2067[9]} + {1'b0, xor_2068};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_522_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:267
  logic [13:0] select_2073;
  assign select_2073 = sample_pair_whole_s4_q ? (and_517_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2074;
  assign sum_2074 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2075;
  assign difference_2075 = {1'b0, sum_2074[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2076;
  assign xor_2076 = {difference_2075[8:0], sum_2074[0]} ^ {10{difference_2075[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2075[9]} + {1'b0, xor_2076};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_522_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:267
  logic [13:0] select_2081;
  assign select_2081 = sample_pair_whole_s4_q ? (and_517_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2164;
  assign sum_2164 = sum_2160_s4_q + {2'h0, sum_2163_s4_q};
  // hls/stages/agreement.hpp:511
  logic [11:0] select_2166;
  assign select_2166 = and_519_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2167;
  assign select_2167 = and_519_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2168;
  assign select_2168 = and_519_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2169;
  assign select_2169 = and_519_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2172;
  assign sum_2172 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2164};
  logic [13:0] sum_2174;
  assign sum_2174 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2172});
  // hls/stages/census.hpp:305
  logic and_2176;
  assign and_2176 = and_609_s4_q & (9'h4 < sum_2174[13:5]);
  // hls/stages/census.hpp:306
  logic and_2177;
  assign and_2177 = and_609_s4_q & less_633;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2178;
  assign sum_2178 = census_left_misses_q + {{17{and_2177}}, and_2176, 1'b0, and_2176};
  // hls/stages/agreement.hpp:511
  logic [19:0] select_2180;
  assign select_2180 = and_519_s4_q ? (equal_2171_s4_q ? 20'h0 : sum_2178) : census_left_misses_q;
  // hls/stages/agreement.hpp:267
  logic [27:0] select_2185;
  assign select_2185 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:511
  logic select_2188;
  assign select_2188 = and_519_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2191;
  assign and_2191 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:448
  logic and_2197;
  assign and_2197 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2198;
  assign and_2198 = and_2191 & and_2197;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2185[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2200;
  assign select_2200 = and_2198 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2202;
  assign select_2202 = equal_2171_s4_q ? {11'h0, select_2200} : (sharpness_sums_detail_0_q + {11'h0, select_2200});
  // hls/stages/agreement.hpp:448
  logic and_2209;
  assign and_2209 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2210;
  assign and_2210 = and_2191 & and_2209;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2185[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2212;
  assign select_2212 = and_2210 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2214;
  assign select_2214 = equal_2171_s4_q ? {11'h0, select_2212} : (sharpness_sums_detail_1_q + {11'h0, select_2212});
  logic [8:0] select_2217;
  assign select_2217 = and_2198 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2218;
  assign sum_2218 = (equal_2171_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2217};
  logic [8:0] select_2221;
  assign select_2221 = and_2210 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2222;
  assign sum_2222 = (equal_2171_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2221};
  // hls/stages/agreement.hpp:206
  logic equal_2224;
  assign equal_2224 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2225;
  assign less_2225 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2226;
  assign less_2226 = x_s4_q[4:0] < 5'h3;
  logic not_2227;
  assign not_2227 = ~x_s4_q[1];
  logic [2:0] select_2228;
  assign select_2228 = x_s4_q[0] ? {1'b0, not_2227, 1'b0} : {x_s4_q[1], 1'b0, not_2227};
  logic [5:0] select_2229;
  assign select_2229 = slot_s4_q[2] ? {select_2228[2], 1'b0, select_2228[1], 1'b0, select_2228[0], 1'b0} : {1'b0, select_2228[2], 1'b0, select_2228[1], 1'b0, select_2228[0]};
  logic [11:0] select_2230;
  assign select_2230 = slot_s4_q[1] ? {select_2229[5], 1'b0, select_2229[4], 1'b0, select_2229[3], 1'b0, select_2229[2], 1'b0, select_2229[1], 1'b0, select_2229[0], 1'b0} : {1'b0, select_2229[5], 1'b0, select_2229[4], 1'b0, select_2229[3], 1'b0, select_2229[2], 1'b0, select_2229[1], 1'b0, select_2229[0]};
  logic [23:0] select_2231;
  assign select_2231 = slot_s4_q[0] ? {select_2230[11], 1'b0, select_2230[10], 1'b0, select_2230[9], 1'b0, select_2230[8], 1'b0, select_2230[7], 1'b0, select_2230[6], 1'b0, select_2230[5], 1'b0, select_2230[4], 1'b0, select_2230[3], 1'b0, select_2230[2], 1'b0, select_2230[1], 1'b0, select_2230[0], 1'b0} : {1'b0, select_2230[11], 1'b0, select_2230[10], 1'b0, select_2230[9], 1'b0, select_2230[8], 1'b0, select_2230[7], 1'b0, select_2230[6], 1'b0, select_2230[5], 1'b0, select_2230[4], 1'b0, select_2230[3], 1'b0, select_2230[2], 1'b0, select_2230[1], 1'b0, select_2230[0]};
  // hls/stages/census.hpp:372
  logic and_2235;
  assign and_2235 = less_2226 & (~((sharpness_sums_contrast_1_q & select_2231) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2237;
  assign select_2237 = (less_2225 & and_2235) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2237};
  // hls/stages/agreement.hpp:210
  logic [17:0] select_2240;
  assign select_2240 = equal_2224 ? (less_2225 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2245;
  assign and_2245 = less_2226 & (~((sharpness_sums_contrast_0_q & select_2231) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2247;
  assign select_2247 = (less_2225 & and_2245) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2247};
  // hls/stages/agreement.hpp:210
  logic [17:0] select_2250;
  assign select_2250 = equal_2224 ? (less_2225 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2252;
  assign select_2252 = equal_2224 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2254;
  assign select_2254 = equal_2224 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2256;
  assign select_2256 = equal_2224 ? {sharpness_comparing_contrast_0_q[0], and_2245} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2258;
  assign select_2258 = equal_2224 ? {sharpness_comparing_contrast_1_q[0], and_2235} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:210
  logic select_2263;
  assign select_2263 = drew_q ? (equal_2224 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:210
  logic select_2267;
  assign select_2267 = drew_q ? (equal_2224 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2268;
  assign equal_2268 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2269;
  assign xor_2269 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2272;
  assign select_2272 = (equal_2268 | xor_2269) ? (five_times[0] & xor_2269) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:210
  logic select_2274;
  assign select_2274 = drew_q ? (equal_2224 ? select_2272 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2275;
  assign xor_2275 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2278;
  assign select_2278 = (equal_2268 | xor_2275) ? (five_times_2[0] & xor_2275) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:210
  logic select_2280;
  assign select_2280 = drew_q ? (equal_2224 ? select_2278 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2281;
  assign xor_2281 = sharpness_comparing_contrast_0_q[1] ^ and_2235;
  logic select_2284;
  assign select_2284 = (equal_2268 | xor_2281) ? (and_2235 & xor_2281) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:210
  logic select_2286;
  assign select_2286 = drew_q ? (equal_2224 ? select_2284 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2287;
  assign xor_2287 = sharpness_comparing_contrast_1_q[1] ^ and_2245;
  logic select_2290;
  assign select_2290 = (equal_2268 | xor_2287) ? (and_2245 & xor_2287) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:210
  logic select_2292;
  assign select_2292 = drew_q ? (equal_2224 ? select_2290 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2426;
  assign select_2426 = and_2420_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2424_s4_q});
  // hls/stages/agreement.hpp:776
  logic and_2429;
  assign and_2429 = not_1478_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2434;
  assign and_2434 = not_1478_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2439;
  assign and_2439 = not_1478_s4_q & (drew_q & (ends_cell_s4_q & and_1911_s4_q));
  // hls/stages/agreement.hpp:1060
  logic not_2443;
  assign not_2443 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1061
  logic not_2460;
  assign not_2460 = ~(equal_1970_s4_q ? and_1991 : not_2458_s4_q);
  // hls/stages/agreement.hpp:776
  logic and_2463;
  assign and_2463 = ends_cell_s4_q & (not_2443 & (centres_values_1_textured_s4_q & not_2460));
  logic and_2465;
  assign and_2465 = not_1478_s4_q & (drew_q & and_2463);
  // hls/stages/agreement.hpp:1087
  logic less_2468;
  assign less_2468 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2469;
  assign select_2469 = less_2468 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2472;
  assign select_2472 = less_2468 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1088
  logic [10:0] sum_2473;
  assign sum_2473 = {1'b0, select_2472} + {3'h0, select_2472[9:2]};
  logic and_2475;
  assign and_2475 = (~(select_2469[9:4] == 6'h0)) & ({sum_2473, select_2472[1:0]} < {3'h0, select_2469});
  // hls/stages/agreement.hpp:1097
  logic [9:0] select_2478;
  assign select_2478 = x_s4_q[6] ? (equal_1522_s4_q ? 10'h0 : (and_2475 ? select_2469 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:776
  logic [9:0] select_2479;
  assign select_2479 = equal_1477_s4_q ? select_2478 : 10'h0;
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2481;
  assign select_2481 = and_2420_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2479});
  logic [13:0] select_2488;
  assign select_2488 = and_2420_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2486_s4_q});
  // hls/stages/agreement.hpp:1065
  logic and_2490;
  assign and_2490 = not_2443 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:776
  logic and_2493;
  assign and_2493 = not_1478_s4_q & (drew_q & (ends_cell_s4_q & and_2490));
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2495;
  assign select_2495 = and_2420_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2493});
  // hls/stages/agreement.hpp:1065
  logic and_2497;
  assign and_2497 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2460);
  // hls/stages/agreement.hpp:776
  logic and_2501;
  assign and_2501 = not_1478_s4_q & (drew_q & (ends_cell_s4_q & (not_2443 & and_2497)));
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2503;
  assign select_2503 = and_2420_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2501});
  // hls/stages/agreement.hpp:776
  logic [7:0] select_2552;
  assign select_2552 = drew_q ? (equal_1618_s4_q ? (and_2536_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2553;
  assign select_2553 = equal_1477_s4_q ? 8'h0 : select_2552;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2555;
  assign select_2555 = and_2535_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2553[7]}}, select_2553});
  // hls/stages/agreement.hpp:776
  logic and_2558;
  assign and_2558 = not_1478_s4_q & (drew_q & (and_2536_s4_q & equal_1618_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2560;
  assign select_2560 = and_2535_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2558});
  // hls/stages/registration.hpp:107
  logic and_2562;
  assign and_2562 = and_2536_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:776
  logic [1:0] select_2564;
  assign select_2564 = drew_q ? (equal_1618_s4_q ? {and_2562, and_2536_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2565;
  assign select_2565 = equal_1477_s4_q ? 2'h0 : select_2564;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2566;
  assign sum_2566 = registration_half_votes_down_q + {{5{select_2565[1]}}, select_2565};
  // hls/stages/agreement.hpp:776
  logic [1:0] select_2572;
  assign select_2572 = drew_q ? (equal_1618_s4_q ? {and_2570_s4_q, and_2536_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2573;
  assign select_2573 = equal_1477_s4_q ? 2'h0 : select_2572;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2574;
  assign sum_2574 = registration_half_votes_up_q + {{5{select_2573[1]}}, select_2573};
  // hls/stages/registration.hpp:107
  logic and_2577;
  assign and_2577 = and_2536_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:776
  logic [1:0] select_2579;
  assign select_2579 = drew_q ? (equal_1618_s4_q ? {and_2577, and_2536_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2580;
  assign select_2580 = equal_1477_s4_q ? 2'h0 : select_2579;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2581;
  assign sum_2581 = registration_half_half_votes_down_q + {{5{select_2580[1]}}, select_2580};
  // hls/stages/agreement.hpp:776
  logic [1:0] select_2586;
  assign select_2586 = drew_q ? (equal_1618_s4_q ? {and_2584_s4_q, and_2536_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2587;
  assign select_2587 = equal_1477_s4_q ? 2'h0 : select_2586;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2588;
  assign sum_2588 = registration_half_half_votes_up_q + {{5{select_2587[1]}}, select_2587};
  // hls/stages/agreement.hpp:776
  logic and_2622;
  assign and_2622 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & less_1553_s4_q));
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2629;
  assign select_2629 = or_1557_s4_q ? 12'h0 : (equal_2627_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1097
  logic [11:0] select_2632;
  assign select_2632 = x_s4_q[6] ? (equal_1522_s4_q ? 12'h0 : (less_1553_s4_q ? select_2629 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:776
  logic [11:0] select_2633;
  assign select_2633 = equal_1477_s4_q ? select_2632 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2634;
  assign and_2634 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1097
  logic and_2637;
  assign and_2637 = not_1890_s4_q & (less_1553_s4_q & ({and_2634, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:776
  logic and_2639;
  assign and_2639 = equal_1477_s4_q & (x_s4_q[6] & and_2637);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2641;
  assign sum_2641 = {{2{select_2633[11]}}, select_2633} + (and_2639 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_2644;
  assign select_2644 = or_1557_s4_q ? 12'h0 : (equal_2627_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1097
  logic [11:0] select_2647;
  assign select_2647 = x_s4_q[6] ? (equal_1522_s4_q ? 12'h0 : (less_1553_s4_q ? select_2644 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:776
  logic [11:0] select_2648;
  assign select_2648 = equal_1477_s4_q ? select_2647 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2650;
  assign sum_2650 = {{2{select_2648[11]}}, select_2648} + (and_2639 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2652;
  assign not_2652 = ~all_s4_q;
  // hls/stages/agreement.hpp:1097
  logic and_2655;
  assign and_2655 = not_1890_s4_q & (less_1553_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2652, 1'b0}));
  // hls/stages/agreement.hpp:776
  logic and_2661;
  assign and_2661 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & (less_1553_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_2662;
  assign not_2662 = ~and_2661;
  logic less_2663;
  assign less_2663 = $signed({9'h1, {2{not_2662}}, and_2661}) < $signed(registration_up_q[13:2]);
  logic select_2664;
  assign select_2664 = (equal_1477_s4_q & (x_s4_q[6] & and_2655)) ? less_2663 : registration_enough_q;
  // hls/stages/agreement.hpp:1097
  logic and_2668;
  assign and_2668 = x_s4_q[6] & (not_1890_s4_q & (less_1553_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:776
  logic and_2669;
  assign and_2669 = equal_1477_s4_q & and_2668;
  // hls/stages/registration.hpp:242
  logic less_2670;
  assign less_2670 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2672;
  assign less_2672 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2674;
  assign equal_2674 = x_s4_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:776
  logic and_2678;
  assign and_2678 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & (less_1553_s4_q & equal_2674)));
  // hls/stages/agreement.hpp:1097
  logic and_2685;
  assign and_2685 = x_s4_q[6] & (not_1890_s4_q & (less_1553_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2688;
  assign equal_2688 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1097
  logic and_2691;
  assign and_2691 = not_1890_s4_q & (less_1553_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2688));
  // hls/stages/registration.hpp:244
  logic and_2695;
  assign and_2695 = (equal_1477_s4_q & (x_s4_q[6] & and_2691)) & (less_2672 | less_2670);
  // hls/stages/agreement.hpp:1097
  logic and_2700;
  assign and_2700 = not_1890_s4_q & (less_1553_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2688)));
  // hls/stages/registration.hpp:244
  logic and_2703;
  assign and_2703 = registration_votes_up_q & registration_other_down_q;
  logic select_2705;
  assign select_2705 = registration_votes_down_q ? (registration_other_up_q | and_2703) : and_2703;
  // hls/stages/registration.hpp:138
  logic and_2707;
  assign and_2707 = (equal_1477_s4_q & (x_s4_q[6] & and_2700)) & (registration_other_enough_q & select_2705);
  // hls/stages/registration.hpp:245
  logic or_2710;
  assign or_2710 = registration_moved_q | (registration_enough_q & (and_2695 | and_2707));
  // hls/stages/agreement.hpp:267
  logic [7:0] select_2794;
  assign select_2794 = sample_pair_whole_s4_q ? (equal_1608_s4_q ? patches_place_0_slope_q : select_1709[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_2799;
  assign select_2799 = sample_pair_whole_s4_q ? (equal_1608_s4_q ? patches_place_1_slope_q : select_1738[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_2801;
  assign select_2801 = equal_1608_s4_q ? patches_valid_0_q : (select_1607_s4_q ? patches_valid_0_q : select_1706[0]);
  // hls/stages/agreement.hpp:267
  logic select_2804;
  assign select_2804 = sample_pair_whole_s4_q ? (and_1729 ? (sample_present_s4_q & select_2801) : select_2801) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_2806;
  assign select_2806 = equal_1608_s4_q ? patches_valid_1_q : (select_1607_s4_q ? select_1706[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:267
  logic select_2809;
  assign select_2809 = sample_pair_whole_s4_q ? (and_1749 ? (sample_present_s4_q & select_2806) : select_2806) : patches_valid_1_q;
  logic [5:0] select_2812;
  assign select_2812 = sample_pair_whole_s4_q ? (select_1727[5] ? {1'b1, select_1727[4:0]} : (select_1727 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2815;
  assign select_2815 = sample_pair_whole_s4_q ? (select_1747[5] ? {1'b1, select_1747[4:0]} : (select_1747 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_2818;
  assign select_2818 = sample_pair_whole_s4_q ? (select_1760[4] ? {1'b1, select_1760[3:0]} : (select_1760 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2821;
  assign select_2821 = sample_pair_whole_s4_q ? (select_1765[4] ? {1'b1, select_1765[3:0]} : (select_1765 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:520
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3240_s4_q, parity_3236_s4_q, xor_3224_s4_q, parity_3196_s4_q, parity_3134_s4_q, parity_3005_s4_q} + (equal_3241_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3245;
  assign select_3245 = equal_1690_s4_q ? patches_sums_values_0_q : (equal_1692_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3246;
  assign select_3246 = equal_1692_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3248;
  assign select_3248 = equal_1692_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3250;
  assign select_3250 = equal_1692_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3252;
  assign select_3252 = equal_1692_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3254;
  assign select_3254 = equal_1692_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3256;
  assign select_3256 = equal_1692_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3258;
  assign select_3258 = equal_1692_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3260;
  assign select_3260 = equal_1692_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3262;
  assign select_3262 = equal_1692_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3264;
  assign select_3264 = equal_1692_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3266;
  assign select_3266 = equal_1692_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3268;
  assign select_3268 = equal_1692_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3270;
  assign select_3270 = equal_1692_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3272;
  assign select_3272 = equal_1692_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3274;
  assign select_3274 = equal_1692_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3276;
  assign select_3276 = equal_1692_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:594
  logic or_3381;
  assign or_3381 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3380_s4_q;
  logic or_3384;
  assign or_3384 = equal_3372_s4_q | (less_3374_s4_q | (less_3375_s4_q | or_3381));
  // hls/stages/patches.hpp:574
  logic not_3385;
  assign not_3385 = ~or_3384;
  // hls/stages/patches.hpp:555
  logic and_3386;
  assign and_3386 = equal_1856_s4_q & not_3385;
  // hls/stages/patches.hpp:184
  logic and_3389;
  assign and_3389 = equal_1690_s4_q & (less_1853_s4_q ? (not_1855_s4_q & and_3386) : and_3386);
  // hls/stages/patches.hpp:652
  logic not_3390;
  assign not_3390 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:555
  logic and_3392;
  assign and_3392 = equal_1856_s4_q & (patches_second_s4_q & not_3385);
  // hls/stages/patches.hpp:184
  logic and_3395;
  assign and_3395 = equal_1690_s4_q & (less_1853_s4_q ? (not_1855_s4_q & and_3392) : and_3392);
  // hls/stages/patches.hpp:652
  logic not_3396;
  assign not_3396 = ~and_3395;
  // hls/stages/patches.hpp:188
  logic and_3398;
  assign and_3398 = and_3389 & (not_3390 & not_3396);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3400;
  assign sum_3400 = {7'h0, and_3398} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:592
  logic [7:0] select_3426;
  assign select_3426 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3427;
  assign select_3427 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3428;
  assign sum_3428 = {2'h0, select_3360_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3429;
  assign sum_3429 = {select_3427[5], select_3427} + {{3{sum_3428[3]}}, sum_3428};
  // hls/stages/patches.hpp:592
  logic [17:0] product_3430;
  assign product_3430 = $signed({{10{select_3426[7]}}, select_3426}) * $signed({{8{sum_3429[6]}}, sum_3429, select_3360_s4_q[2:0]});
  // hls/stages/patches.hpp:593
  logic [13:0] difference_3431;
  assign difference_3431 = {{6{select_3425_s4_q[7]}}, select_3425_s4_q} - {product_3430[17], product_3430[17:5]};
  // hls/stages/patches.hpp:599
  logic less_3432;
  assign less_3432 = $signed({{7{difference_3402[6]}}, difference_3402}) < $signed(difference_3431);
  // hls/stages/patches.hpp:555
  logic and_3435;
  assign and_3435 = equal_1856_s4_q & (not_3385 & (~less_3432));
  // hls/stages/patches.hpp:184
  logic and_3438;
  assign and_3438 = equal_1690_s4_q & (less_1853_s4_q ? (not_1855_s4_q & and_3435) : and_3435);
  // hls/stages/patches.hpp:655
  logic and_3439;
  assign and_3439 = and_3438 & and_3398;
  logic [7:0] sum_3440;
  assign sum_3440 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3439};
  // hls/stages/patches.hpp:555
  logic and_3444;
  assign and_3444 = not_3385 & (~($signed(difference_3431) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3445;
  assign and_3445 = equal_1856_s4_q & and_3444;
  // hls/stages/patches.hpp:184
  logic and_3448;
  assign and_3448 = equal_1690_s4_q & (less_1853_s4_q ? (not_1855_s4_q & and_3445) : and_3445);
  // hls/stages/patches.hpp:656
  logic and_3449;
  assign and_3449 = and_3448 & and_3398;
  logic [7:0] sum_3450;
  assign sum_3450 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3449};
  // hls/stages/patches.hpp:188
  logic and_3452;
  assign and_3452 = and_3389 & (and_3395 & not_3390);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3454;
  assign sum_3454 = {7'h0, and_3452} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:655
  logic and_3456;
  assign and_3456 = and_3438 & and_3452;
  logic [7:0] sum_3457;
  assign sum_3457 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3456};
  // hls/stages/patches.hpp:656
  logic and_3459;
  assign and_3459 = and_3448 & and_3452;
  logic [7:0] sum_3460;
  assign sum_3460 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3459};
  // hls/stages/patches.hpp:188
  logic and_3462;
  assign and_3462 = and_3389 & (patches_lower_s4_q & not_3396);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3464;
  assign sum_3464 = {7'h0, and_3462} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:655
  logic and_3466;
  assign and_3466 = and_3438 & and_3462;
  logic [7:0] sum_3467;
  assign sum_3467 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3466};
  // hls/stages/patches.hpp:656
  logic and_3469;
  assign and_3469 = and_3448 & and_3462;
  logic [7:0] sum_3470;
  assign sum_3470 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3469};
  // hls/stages/patches.hpp:188
  logic and_3472;
  assign and_3472 = and_3389 & (patches_lower_s4_q & and_3395);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3474;
  assign sum_3474 = {7'h0, and_3472} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:655
  logic and_3476;
  assign and_3476 = and_3438 & and_3472;
  logic [7:0] sum_3477;
  assign sum_3477 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3476};
  // hls/stages/patches.hpp:656
  logic and_3479;
  assign and_3479 = and_3448 & and_3472;
  logic [7:0] sum_3480;
  assign sum_3480 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3479};
  // hls/stages/agreement.hpp:1167
  logic equal_3481;
  assign equal_3481 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1085
  logic less_3482;
  assign less_3482 = x_s4_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:776
  logic and_3486;
  assign and_3486 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & (equal_3481 & less_3482)));
  // hls/stages/agreement.hpp:1097
  logic and_3491;
  assign and_3491 = x_s4_q[6] & (not_1890_s4_q & (less_3482 & (x_s4_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:776
  logic and_3492;
  assign and_3492 = equal_1477_s4_q & and_3491;
  // hls/stages/patches.hpp:618
  logic [7:0] or_3494;
  assign or_3494 = (and_3486 ? patches_quarters_0_places_q : 8'h0) | (and_3492 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1097
  logic and_3498;
  assign and_3498 = x_s4_q[6] & (not_1890_s4_q & (less_3482 & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:776
  logic and_3499;
  assign and_3499 = equal_1477_s4_q & and_3498;
  // hls/stages/agreement.hpp:1097
  logic and_3505;
  assign and_3505 = x_s4_q[6] & (not_1890_s4_q & (less_3482 & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:776
  logic and_3506;
  assign and_3506 = equal_1477_s4_q & and_3505;
  // hls/stages/patches.hpp:618
  logic [7:0] or_3508;
  assign or_3508 = (or_3494 | (and_3499 ? patches_quarters_2_places_q : 8'h0)) | (and_3506 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_3512;
  assign select_3512 = (x_s4_q[5:3] == 3'h2) ? x_s4_q[1] : (x_s4_q[0] & (x_s4_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:776
  logic and_3516;
  assign and_3516 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & (less_3482 & select_3512)));
  // hls/stages/patches.hpp:619
  logic [7:0] select_3518;
  assign select_3518 = and_3486 ? (and_3516 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3520;
  assign select_3520 = and_3492 ? (and_3516 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3523;
  assign select_3523 = and_3499 ? (and_3516 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3526;
  assign select_3526 = and_3506 ? (and_3516 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:620
  logic [7:0] select_3529;
  assign select_3529 = and_3486 ? (and_3516 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3531;
  assign select_3531 = and_3492 ? (and_3516 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3534;
  assign select_3534 = and_3499 ? (and_3516 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3537;
  assign select_3537 = and_3506 ? (and_3516 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3539;
  assign sum_3539 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1097
  logic and_3543;
  assign and_3543 = x_s4_q[6] & (not_1890_s4_q & (less_3482 & (sum_3539[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:776
  logic and_3544;
  assign and_3544 = equal_1477_s4_q & and_3543;
  // hls/stages/patches.hpp:615
  logic [7:0] select_3547;
  assign select_3547 = and_3544 ? (patches_word_places_q + (and_3492 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3550;
  assign select_3550 = and_3544 ? (patches_word_up_q + (and_3492 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3553;
  assign select_3553 = and_3544 ? (patches_word_down_q + (and_3492 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:601
  logic [5:0] select_3557;
  assign select_3557 = ($signed(difference_3431[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3431[5:0];
  logic [5:0] select_3558;
  assign select_3558 = ($signed(14'h10) < $signed(difference_3431)) ? 6'h10 : select_3557;
  // hls/stages/patches.hpp:555
  logic [5:0] select_3560;
  assign select_3560 = equal_1856_s4_q ? (or_3384 ? 6'h0 : select_3558) : 6'h0;
  logic [5:0] select_3562;
  assign select_3562 = less_1853_s4_q ? (equal_1854_s4_q ? 6'h0 : select_3560) : select_3560;
  // hls/stages/patches.hpp:658
  logic [5:0] select_3564;
  assign select_3564 = and_3389 ? (equal_1690_s4_q ? select_3562 : 6'h0) : 6'h0;
  logic [11:0] sum_3565;
  assign sum_3565 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3564[5]}}, select_3564};
  // hls/stages/agreement.hpp:776
  logic and_3569;
  assign and_3569 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & (equal_2674 & less_3482)));
  // hls/stages/agreement.hpp:1097
  logic and_3573;
  assign and_3573 = x_s4_q[6] & (not_1890_s4_q & (less_3482 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:776
  logic and_3574;
  assign and_3574 = equal_1477_s4_q & and_3573;
  // hls/stages/patches.hpp:642
  logic [7:0] select_3576;
  assign select_3576 = and_3569 ? (and_3574 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:644
  logic or_3580;
  assign or_3580 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:645
  logic or_3583;
  assign or_3583 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic [8:0] sum_3584;
  assign sum_3584 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:641
  logic select_3586;
  assign select_3586 = and_3569 ? (and_3574 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/agreement.hpp:776
  logic and_3591;
  assign and_3591 = equal_1477_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_3588_s4_q));
  // hls/stages/patches.hpp:188
  logic and_3593;
  assign and_3593 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:641
  logic [2:0] select_3595;
  assign select_3595 = and_3574 ? {and_3593, patches_found_q[2:1]} : (and_3569 ? {and_3593, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:640
  logic or_3599;
  assign or_3599 = patches_partly_q | (patches_doubted_q & (~and_3574));
  // hls/stages/patches.hpp:641
  logic select_3602;
  assign select_3602 = and_3569 ? (and_3574 ? or_3599 : (and_3569 ? or_3599 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:639
  logic select_3603;
  assign select_3603 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:628
  logic [7:0] select_3607;
  assign select_3607 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:600
  logic [10:0] sum_3609;
  assign sum_3609 = {sum_3429[6], sum_3429, select_3360_s4_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:555
  logic and_3612;
  assign and_3612 = equal_1856_s4_q & (not_3385 & ({{5{sum_3609[10]}}, sum_3609} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_3615;
  assign and_3615 = equal_1690_s4_q & (less_1853_s4_q ? (not_1855_s4_q & and_3612) : and_3612);
  // hls/stages/patches.hpp:188
  logic and_3616;
  assign and_3616 = and_3389 & and_3615;
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3617;
  assign sum_3617 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3616};
  // hls/stages/patches.hpp:649
  logic [12:0] product_3618;
  assign product_3618 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_3576};
  // hls/stages/patches.hpp:188
  logic and_3624;
  assign and_3624 = (~(patches_on_skin_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_q);
  logic select_3629;
  assign select_3629 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:629
  logic or_3633;
  assign or_3633 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:630
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:631
  logic select_3640;
  assign select_3640 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:632
  logic and_3646;
  assign and_3646 = patches_frame_ended_q & (~patches_age_q[9]);
  logic [9:0] sum_3647;
  assign sum_3647 = patches_age_q + {9'h0, and_3646};
  logic [9:0] select_3650;
  assign select_3650 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3647)) : sum_3647;
  // hls/stages/agreement.hpp:1139
  logic or_3707;
  assign or_3707 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1161
  logic equal_3709;
  assign equal_3709 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1170
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1171
  logic select_3715;
  assign select_3715 = (equal_3709 & equal_3481) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1090
  logic [10:0] sum_3718;
  assign sum_3718 = {1'b0, select_2472} + {2'h0, select_2472[9:1]};
  logic select_3721;
  assign select_3721 = (select_2469[9:3] == 7'h0) ? ((~or_3707) & (~select_3715)) : (~({sum_3718, select_2472[0]} < {2'h0, select_2469}));
  // hls/stages/agreement.hpp:1097
  logic [47:0] select_3723;
  assign select_3723 = x_s4_q[6] ? (equal_1522_s4_q ? good_q : {select_3721, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:776
  logic select_3727;
  assign select_3727 = equal_1477_s4_q ? ((x_s4_q[6] & good_known_q) | equal_3588_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1161
  logic equal_3728;
  assign equal_3728 = x_s4_q[6:3] == 4'ha;
  logic equal_3730;
  assign equal_3730 = x_s4_q[6:3] == 4'h9;
  logic equal_3731;
  assign equal_3731 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1080
  logic [13:0] select_3733;
  assign select_3733 = equal_3730 ? counts_skin_unproven_q : (equal_3731 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3728 ? counts_nearer_q : select_3733;
  // hls/stages/agreement.hpp:1166
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1174
  logic select_3736;
  assign select_3736 = (equal_3728 & equal_3481) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1099
  logic not_3737;
  assign not_3737 = ~hidden_for_q[7];
  logic [7:0] select_3739;
  assign select_3739 = select_3736 ? (hidden_for_q + {7'h0, not_3737}) : 8'h0;
  // hls/stages/agreement.hpp:776
  logic [7:0] select_3741;
  assign select_3741 = equal_1477_s4_q ? (equal_3588_s4_q ? select_3739 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1174
  logic [13:0] select_3742;
  assign select_3742 = equal_3481 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1080
  logic [7:0] select_3744;
  assign select_3744 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3746;
  assign select_3746 = equal_3731 ? cfg_unproven_skin_limit_i : (equal_3709 ? cfg_unproven_limit_i : select_3744);
  logic [7:0] limit;
  assign limit = equal_3728 ? cfg_regions_limit_i : (equal_3730 ? cfg_hidden_limit_i : select_3746);
  // hls/stages/agreement.hpp:1174
  logic not_3749;
  assign not_3749 = ~x_s4_q[2];
  logic [3:0] select_3750;
  assign select_3750 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_3749, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_3749};
  logic [7:0] select_3751;
  assign select_3751 = x_s4_q[0] ? {select_3750[3], 1'b0, select_3750[2], 1'b0, select_3750[1], 1'b0, select_3750[0], 1'b0} : {1'b0, select_3750[3], 1'b0, select_3750[2], 1'b0, select_3750[1], 1'b0, select_3750[0]};
  // hls/stages/agreement.hpp:1080
  logic [13:0] select_3755;
  assign select_3755 = equal_3730 ? counts_skin_supervised_q : (equal_3731 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3728 ? counts_textured_q : select_3755;
  // hls/stages/agreement.hpp:1174
  logic [13:0] select_3757;
  assign select_3757 = ((limit & select_3751) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3742} + {1'b0, select_3757};
  // hls/stages/agreement.hpp:776
  logic select_3762;
  assign select_3762 = equal_1477_s4_q ? (equal_3481 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1172
  logic and_3767;
  assign and_3767 = too_much_q & (~(equal_3731 & equal_3481));
  // hls/stages/agreement.hpp:1173
  logic select_3772;
  assign select_3772 = (over[14] & equal_3481) ? (and_3767 | ((equal_3731 | equal_3730) | (x_s4_q[6:3] == 4'hf))) : and_3767;
  // hls/stages/agreement.hpp:1216
  logic select_3880;
  assign select_3880 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:269
  logic select_3882;
  assign select_3882 = left_first_s4_q ? done_s4_q : (and_1871_s4_q ? select_3880 : proven_q);
  // hls/stages/agreement.hpp:1249
  logic [1:0] select_3933;
  assign select_3933 = and_3932_s4_q ? {and_2021, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1250
  logic and_3934;
  assign and_3934 = select_3880 & less_3910;
  // hls/stages/agreement.hpp:428
  logic select_3937;
  assign select_3937 = and_1948_s4_q ? (less_1949_s4_q ? (select_3933[0] & and_3934) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:269
  logic select_3939;
  assign select_3939 = left_first_s4_q ? select_3937 : (and_1871_s4_q ? select_3937 : seen_q);
  logic select_3940;
  assign select_3940 = and_1871_s4_q ? select_3939 : seen_q;
  // hls/stages/agreement.hpp:428
  logic select_3943;
  assign select_3943 = and_1948_s4_q ? (less_1949_s4_q ? (select_3933[1] & and_3934) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:269
  logic select_3945;
  assign select_3945 = left_first_s4_q ? select_3943 : (and_1871_s4_q ? select_3943 : nearer_q);
  logic select_3946;
  assign select_3946 = and_1871_s4_q ? select_3945 : nearer_q;
  // hls/stages/agreement.hpp:1182
  logic or_3954;
  assign or_3954 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1184
  logic not_3962;
  assign not_3962 = ~(or_3707 | not_3947);
  // hls/stages/agreement.hpp:776
  logic and_3966;
  assign and_3966 = equal_1477_s4_q & (equal_3588_s4_q & (not_3962 & (select_3715 | select_3772)));
  logic and_3969;
  assign and_3969 = equal_3588_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1101
  logic or_3973;
  assign or_3973 = select_2274 | (select_2286 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:776
  logic and_3980;
  assign and_3980 = equal_1477_s4_q & (equal_3588_s4_q & (not_3962 & (select_2280 | select_2292)));
  // hls/stages/agreement.hpp:1101
  logic and_3985;
  assign and_3985 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3739 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:776
  logic and_3991;
  assign and_3991 = equal_1477_s4_q & (equal_3588_s4_q & (cfg_prove_i & patches_overlooked_q));
  logic and_3995;
  assign and_3995 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_4003;
  assign select_4003 = equal_1544_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4001_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4004;
  assign select_4004 = equal_1542_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4003;
  logic [31:0] select_4005;
  assign select_4005 = equal_1540_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4004;
  logic [31:0] select_4006;
  assign select_4006 = equal_1538_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_4005;
  logic [31:0] select_4007;
  assign select_4007 = equal_1536_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_4006;
  logic [31:0] select_4008;
  assign select_4008 = equal_1534_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4007;
  logic [31:0] select_4009;
  assign select_4009 = equal_1532_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4008;
  logic [31:0] select_4010;
  assign select_4010 = equal_1530_s4_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4009;
  // hls/stages/agreement.hpp:1093
  logic [9:0] select_4011;
  assign select_4011 = less_2468 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1097
  logic [31:0] select_4012;
  assign select_4012 = equal_1522_s4_q ? select_4010 : {2'h0, select_4011, select_2472, select_2469};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_519_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_634, and_610_s4_q, and_609_s4_q, and_584_s4_q, less_576_s4_q, less_575_s4_q, less_574_s4_q, less_573_s4_q, less_572_s4_q, less_571_s4_q, less_570_s4_q, less_569_s4_q, less_568_s4_q, less_567_s4_q, less_566_s4_q, less_565_s4_q, less_564_s4_q, less_563_s4_q, less_562_s4_q, less_561_s4_q, less_560_s4_q, less_559_s4_q, less_558_s4_q, less_557_s4_q, less_556_s4_q, less_555_s4_q, less_554_s4_q, less_553_s4_q};
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
  assign registration_sums_waddr = {sum_1528_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_1587_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1586, sum_1582};
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
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_1616_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_1689_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1682_s4_q};
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
  assign patches_right_0_waddr = {select_1720_s4_q, select_1717};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_1729);
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
  assign patches_right_1_waddr = {select_1720_s4_q, select_1746};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_1749);
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
  assign patches_left_waddr = {select_1768, select_1767_s4_q, column_5};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_1774);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1878;
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
  assign regions_waddr = {region_row_s4_q, or_1888_s4_q, or_1885_s4_q, or_1882_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_1916_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1915, sum_1909, sum_1904};
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
  assign map_waddr = sum_1957_s4_q;
  logic map_we;
  assign map_we = s4_en & and_2031_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2021, is_seen};
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
      patches_partly_q <= 1'b0;
      patches_clear_limit_q <= 7'h0;
      patches_complete_q <= 1'b0;
      patches_frame_ended_q <= 1'b0;
      patches_round_ends_q <= 1'b0;
      patches_found_q <= 3'h0;
      patches_doubted_q <= 1'b0;
      patches_doubted_before_q <= 1'b0;
      patches_round_places_q <= 8'h0;
      patches_round_across_q <= 12'h0;
      patches_round_moved_q <= 3'h0;
      patches_round_on_skin_q <= 8'h0;
      patches_on_skin_q <= 8'h0;
      patches_on_skin_most_q <= 8'h0;
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
      patches_suspected_q <= 1'b0;
      patches_moved_q <= 1'b0;
      patches_twice_q <= 1'b0;
      patches_clear_q <= 1'b0;
      patches_age_q <= 10'h200;
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
      census_left_misses_q <= select_2180;
      sharpness_before_last_mask_q <= select_2188;
      sharpness_sums_detail_0_q <= and_519_s4_q ? select_2202 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_519_s4_q ? select_2214 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_519_s4_q ? sum_2218 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_519_s4_q ? sum_2222 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2240 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2250 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2252 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2254 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2256 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2258 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2263;
      sharpness_comparing_carry_1_q <= select_2267;
      sharpness_comparing_less_detail_0_q <= select_2274;
      sharpness_comparing_less_detail_1_q <= select_2280;
      sharpness_comparing_less_contrast_0_q <= select_2286;
      sharpness_comparing_less_contrast_1_q <= select_2292;
      counts_supervised_q <= select_2426;
      counts_textured_q <= and_2420_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2429});
      counts_explained_q <= and_2420_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2434});
      counts_nearer_q <= and_2420_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2439});
      counts_unproven_q <= and_2420_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2465});
      counts_regions_bad_q <= select_2481;
      counts_skin_supervised_q <= select_2488;
      counts_skin_textured_q <= select_2495;
      counts_skin_unproven_q <= select_2503;
      registration_half_across_q <= select_2555;
      registration_half_measured_q <= select_2560;
      registration_half_votes_down_q <= and_2535_s4_q ? 7'h0 : sum_2566;
      registration_half_votes_up_q <= and_2535_s4_q ? 7'h0 : sum_2574;
      registration_half_half_votes_down_q <= and_2535_s4_q ? 7'h0 : sum_2581;
      registration_half_half_votes_up_q <= and_2535_s4_q ? 7'h0 : sum_2588;
      registration_down_q <= and_2622 ? sum_2641 : registration_down_q;
      registration_up_q <= and_2622 ? sum_2650 : registration_up_q;
      registration_enough_q <= select_2664;
      registration_votes_down_q <= and_2669 ? less_2670 : registration_votes_down_q;
      registration_votes_up_q <= and_2669 ? less_2672 : registration_votes_up_q;
      registration_other_enough_q <= and_2678 ? select_2664 : registration_other_enough_q;
      registration_other_down_q <= and_2678 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2678 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1477_s4_q & and_2685)) & or_2710;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_1708 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_1710 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_1711 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2794;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_1737 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_1739 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_1740 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2799;
      patches_valid_0_q <= select_2804;
      patches_valid_1_q <= select_2809;
      patches_right_next_0_q <= select_2812;
      patches_right_next_1_q <= select_2815;
      patches_left_next_0_q <= select_2818;
      patches_left_next_1_q <= select_2821;
      patches_sums_values_0_q <= select_3245;
      patches_sums_values_1_q <= equal_1690_s4_q ? patches_sums_values_1_q : select_3246;
      patches_sums_values_2_q <= equal_1690_s4_q ? patches_sums_values_2_q : select_3248;
      patches_sums_values_3_q <= equal_1690_s4_q ? patches_sums_values_3_q : select_3250;
      patches_sums_values_4_q <= equal_1690_s4_q ? patches_sums_values_4_q : select_3252;
      patches_sums_values_5_q <= equal_1690_s4_q ? patches_sums_values_5_q : select_3254;
      patches_sums_values_6_q <= equal_1690_s4_q ? patches_sums_values_6_q : select_3256;
      patches_sums_values_7_q <= equal_1690_s4_q ? patches_sums_values_7_q : select_3258;
      patches_sums_values_8_q <= equal_1690_s4_q ? patches_sums_values_8_q : select_3260;
      patches_sums_values_9_q <= equal_1690_s4_q ? patches_sums_values_9_q : select_3262;
      patches_sums_values_10_q <= equal_1690_s4_q ? patches_sums_values_10_q : select_3264;
      patches_sums_values_11_q <= equal_1690_s4_q ? patches_sums_values_11_q : select_3266;
      patches_sums_values_12_q <= equal_1690_s4_q ? patches_sums_values_12_q : select_3268;
      patches_sums_values_13_q <= equal_1690_s4_q ? patches_sums_values_13_q : select_3270;
      patches_sums_values_14_q <= equal_1690_s4_q ? patches_sums_values_14_q : select_3272;
      patches_sums_values_15_q <= equal_1690_s4_q ? patches_sums_values_15_q : select_3274;
      patches_sums_values_16_q <= equal_1690_s4_q ? patches_sums_values_16_q : select_3276;
      patches_best_differing_q <= select_1878[9:0];
      patches_best_column_q <= select_1878[14:10];
      patches_quarters_0_places_q <= sum_3400;
      patches_quarters_0_up_q <= sum_3440;
      patches_quarters_0_down_q <= sum_3450;
      patches_quarters_1_places_q <= sum_3454;
      patches_quarters_1_up_q <= sum_3457;
      patches_quarters_1_down_q <= sum_3460;
      patches_quarters_2_places_q <= sum_3464;
      patches_quarters_2_up_q <= sum_3467;
      patches_quarters_2_down_q <= sum_3470;
      patches_quarters_3_places_q <= sum_3474;
      patches_quarters_3_up_q <= sum_3477;
      patches_quarters_3_down_q <= sum_3480;
      patches_word_places_q <= or_3508;
      patches_word_up_q <= ((select_3518 | select_3520) | select_3523) | select_3526;
      patches_word_down_q <= ((select_3529 | select_3531) | select_3534) | select_3537;
      patches_sum_places_q <= select_3547;
      patches_sum_up_q <= select_3550;
      patches_sum_down_q <= select_3553;
      patches_across_q <= sum_3565;
      patches_places_q <= select_3576;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3580;
      patches_partly_q <= or_3583;
      patches_clear_limit_q <= sum_3584[8:2];
      patches_complete_q <= select_3586;
      patches_frame_ended_q <= and_3591;
      patches_round_ends_q <= patches_complete_q & and_3591;
      patches_found_q <= and_3569 ? select_3595 : patches_found_q;
      patches_doubted_q <= select_3602;
      patches_doubted_before_q <= select_3603;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3607;
      patches_on_skin_q <= sum_3617;
      patches_on_skin_most_q <= product_3618[12:5];
      patches_large_q <= (~(cfg_on_skin_limit_i == 5'h1f)) & and_3624;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3629;
      patches_spoiled_q <= or_3633;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3640;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3650;
      segment_textured_q <= select_1901 + {5'h0, and_2429};
      segment_explained_q <= select_1906 + {5'h0, and_2434};
      segment_nearer_q <= select_1912 + {5'h0, and_2439};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1477_s4_q ? select_3723 : good_q;
      good_known_q <= select_3727;
      hidden_for_q <= select_3741;
      product_q <= equal_1477_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3762;
      disagree_q <= equal_1477_s4_q ? select_3715 : disagree_q;
      too_much_q <= equal_1477_s4_q ? select_3772 : too_much_q;
      hides_q <= equal_1477_s4_q ? select_3736 : hides_q;
      proven_q <= and_1871_s4_q ? select_3882 : proven_q;
      seen_q <= select_3940;
      nearer_q <= select_3946;
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
      averager_quarter_1_0_q <= select_2055;
      averager_quarter_1_1_q <= select_2057;
      averager_quarter_2_0_q <= select_2059;
      averager_quarter_2_1_q <= select_2061;
      averager_detail_0_q <= select_2073;
      averager_detail_1_q <= select_2081;
      census_changes_values_0_left_q <= and_519_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_519_s4_q ? sum_2164 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2166;
      census_changes_values_1_right_q <= select_2167;
      census_changes_values_2_left_q <= select_2168;
      census_changes_values_2_right_q <= select_2169;
      sharpness_last_mask_q <= and_519_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_519_s4_q ? select_2185[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_519_s4_q ? select_2185[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_3884_s5_q;
  logic or_3948_s5_q;
  logic and_3949_s5_q;
  logic and_3957_s5_q;
  logic and_3960_s5_q;
  logic and_3966_s5_q;
  logic and_3970_s5_q;
  logic and_3976_s5_q;
  logic and_3980_s5_q;
  logic and_3988_s5_q;
  logic and_3991_s5_q;
  logic and_3995_s5_q;
  logic [5:0] select_3997_s5_q;
  logic [31:0] select_4014_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_3884_s5_q <= said_q;
      or_3948_s5_q <= not_3947 | select_3940;
      and_3949_s5_q <= cfg_prove_i & select_3946;
      and_3957_s5_q <= equal_1477_s4_q & (equal_3588_s4_q & (cfg_prove_i & or_3954));
      and_3960_s5_q <= equal_1477_s4_q & (equal_3588_s4_q & (cfg_prove_i & or_3707));
      and_3966_s5_q <= and_3966;
      and_3970_s5_q <= equal_1477_s4_q & and_3969;
      and_3976_s5_q <= equal_1477_s4_q & (equal_3588_s4_q & (not_3962 & or_3973));
      and_3980_s5_q <= and_3980;
      and_3988_s5_q <= equal_1477_s4_q & (equal_3588_s4_q & (cfg_prove_i & and_3985));
      and_3991_s5_q <= and_3991;
      and_3995_s5_q <= and_3995;
      select_3997_s5_q <= equal_1477_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_4014_s5_q <= equal_1477_s4_q ? (x_s4_q[6] ? select_4012 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_3948_s5_q;
  assign marks_nearer_o = and_3949_s5_q;
  assign verdict_valid_o = and_3884_s5_q;
  assign verdict_unproven_yet_o = and_3957_s5_q;
  assign verdict_untextured_o = and_3960_s5_q;
  assign verdict_disagree_o = and_3966_s5_q;
  assign verdict_moved_o = and_3970_s5_q;
  assign verdict_unsharp_left_o = and_3976_s5_q;
  assign verdict_unsharp_right_o = and_3980_s5_q;
  assign verdict_hidden_o = and_3988_s5_q;
  assign verdict_overlooked_o = and_3991_s5_q;
  assign frame_valid_o = and_3995_s5_q;
  assign frame_index_o = select_3997_s5_q;
  assign frame_word_o = select_4014_s5_q;
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
  assign unused_bits = ^{over[13:0], product_3618[4:0], sum_3584[1:0], sum_3539[1:0], product_3430[4:0], sum_2525[0], detail_4[1:0], detail_3[1:0], sum_2174[4:0], sum_1630[0], sum_1626[0], sum_632[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
