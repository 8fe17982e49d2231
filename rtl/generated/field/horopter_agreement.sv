// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2918 bits, pipeline 894 bits, memories 58067 bits.
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
  logic [5:0] sum_2389;
  assign sum_2389 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3393;
  assign difference_3393 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_3641;
  assign difference_3641 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_3874;
  assign less_3874 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_3875;
  assign sum_3875 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_3876;
  assign select_3876 = less_3874 ? {sum_3875, cfg_height_i[5:3]} : 8'h0;
  logic not_3911;
  assign not_3911 = ~cfg_prove_i;

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
  logic [2:0] select_472;
  assign select_472 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_474;
  assign select_474 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [7:0] select_477;
  assign select_477 = ({select_474, select_472} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:116
  logic [7:0] select_478;
  assign select_478 = select_472[0] ? averager_place_q : select_477;
  // hls/stages/census.hpp:41
  logic or_479;
  assign or_479 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_482;
  assign and_482 = (select_472[0] & or_479) & (select_478 < 8'hbd);
  // hls/stages/census.hpp:41
  logic [2:0] select_487;
  assign select_487 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_474 : 6'h0;
  // hls/stages/census.hpp:50
  logic equal_504;
  assign equal_504 = select_472 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_505;
  assign equal_505 = select_487 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_506;
  assign and_506 = equal_505 & and_482;
  // hls/stages/agreement.hpp:263
  logic and_508;
  assign and_508 = sample_pair_whole_q & (equal_504 & and_506);
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:610
  logic equal_528;
  assign equal_528 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:581
  logic or_529;
  assign or_529 = so | equal_528;
  // hls/stages/agreement.hpp:704
  logic not_530;
  assign not_530 = ~or_529;
  // hls/stages/agreement.hpp:601
  logic equal_531;
  assign equal_531 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_533;
  assign equal_533 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:579
  logic [7:0] sum_534;
  assign sum_534 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_535;
  assign select_535 = run_shift_q[5] ? x_q : sum_534;
  logic less_536;
  assign less_536 = {2'h0, last_q} < select_535;
  // hls/stages/agreement.hpp:216
  logic not_537;
  assign not_537 = ~less_536;
  // hls/stages/agreement.hpp:141
  logic and_538;
  assign and_538 = equal_533 & not_537;
  logic and_540;
  assign and_540 = not_530 & ((~equal_531) & and_538);
  // hls/stages/census.hpp:41
  logic [5:0] select_567;
  assign select_567 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_567 : 6'h0;
  // hls/stages/agreement.hpp:141
  logic select_624;
  assign select_624 = equal_531 ? not_537 : and_538;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:770
  logic [6:0] sum_644;
  assign sum_644 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:141
  logic and_649;
  assign and_649 = equal_531 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_644} < select_535))));
  logic select_650;
  assign select_650 = or_529 ? not_537 : and_649;
  // hls/stages/agreement.hpp:778
  logic equal_653;
  assign equal_653 = {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:782
  logic or_655;
  assign or_655 = equal_653 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:794
  logic [5:0] right;
  assign right = sum_534[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:182
  logic and_1871;
  assign and_1871 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:263
  logic [2:0] select_2036;
  assign select_2036 = sample_pair_whole_q ? (sample_last_q ? (select_487 + 3'h1) : select_487) : raster_at_y_q;
  logic [5:0] select_2038;
  assign select_2038 = sample_pair_whole_q ? (select_474 + {5'h0, equal_504}) : raster_at_column_q;
  logic [5:0] select_2041;
  assign select_2041 = sample_pair_whole_q ? (sample_last_q ? (select_567 + {5'h0, equal_505}) : select_567) : raster_at_row_q;
  logic select_2045;
  assign select_2045 = sample_pair_whole_q ? (sample_last_q ? (or_479 & (~raster_final_row_q)) : or_479) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2047;
  assign select_2047 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:263
  logic select_2051;
  assign select_2051 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2295;
  assign equal_2295 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:451
  logic and_2296;
  assign and_2296 = and_508 & equal_2295;
  // hls/stages/agreement.hpp:510
  logic select_2299;
  assign select_2299 = (and_2296 | (~ends_cell_q)) ? and_2296 : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2299 ? (and_2296 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2303;
  assign select_2303 = select_2299 ? (and_2296 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2306;
  assign select_2306 = select_2299 ? (following_last_shift_q & (~and_2296)) : run_last_shift_q;
  // hls/stages/agreement.hpp:594
  logic and_2309;
  assign and_2309 = run_last_shift_q & equal_531;
  // hls/stages/agreement.hpp:603
  logic select_2311;
  assign select_2311 = equal_531 ? (~run_last_shift_q) : equal_533;
  // hls/stages/agreement.hpp:607
  logic equal_2312;
  assign equal_2312 = run_phase_q == 3'h1;
  logic not_2315;
  assign not_2315 = ~select_2311;
  // hls/stages/agreement.hpp:610
  logic equal_2317;
  assign equal_2317 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2318;
  assign and_2318 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2319;
  assign select_2319 = equal_2317 ? 2'h1 : {2{and_2318}};
  logic [2:0] select_2321;
  assign select_2321 = (and_2309 | (select_2311 | equal_2312)) ? (equal_2312 ? 3'h2 : {not_2315, {2{select_2311}}}) : (equal_528 ? 3'h6 : {select_2319[0], select_2319});
  // hls/stages/agreement.hpp:594
  logic and_2324;
  assign and_2324 = select_2311 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2327;
  assign select_2327 = (plan_shift_q[5] & select_2311) ? value : 7'h0;
  logic [1:0] or_2328;
  assign or_2328 = {2{so}} | select_2327[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] select_2329;
  assign select_2329 = select_2311 ? plan_columns_q : 8'h0;
  logic [6:0] or_2332;
  assign or_2332 = select_2329[6:0] | ((equal_2312 | equal_2317) ? whole_q : 7'h0);
  logic [1:0] or_2333;
  assign or_2333 = {2{and_2309}} | or_2332[3:2];
  // hls/stages/agreement.hpp:621
  logic [6:0] or_2335;
  assign or_2335 = {or_2332[6:4], or_2333, or_2332[1:0]} | (equal_528 ? drawn_q : 7'h0);
  logic [4:0] or_2336;
  assign or_2336 = {5{so}} | {or_2335[6], or_2335[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2340;
  assign not_2340 = ~run_shift_q[5];
  logic [6:0] difference_2342;
  assign difference_2342 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2343;
  assign select_2343 = equal_531 ? ({{7{not_2340}}, 1'b1} + run_span_q) : {difference_2342[6], difference_2342};
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2347;
  assign select_2347 = and_2296 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2349;
  assign select_2349 = select_2299 ? {select_2347[6], select_2347} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2352;
  assign select_2352 = select_2299 ? (and_2296 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:507
  logic [5:0] select_2360;
  assign select_2360 = and_508 ? (equal_2295 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2363;
  assign select_2363 = and_508 ? (equal_2295 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2366;
  assign select_2366 = and_508 ? (equal_2295 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2380;
  assign select_2380 = (ends_cell_q | select_2299) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_531 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2384;
  assign and_2384 = (~select_2299) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic [6:0] sum_2385;
  assign sum_2385 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:447
  logic select_2387;
  assign select_2387 = equal_2295 ? ({sum_2385[6], cfg_height_i[8:3]} == {1'b0, sum_2385[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:361
  logic or_2769;
  assign or_2769 = select_474[0] | select_567[5];
  logic [7:0] sum_2770;
  assign sum_2770 = {1'b0, select_474[2:1], or_2769, select_567[4:1]} + 8'h1;
  logic less_2771;
  assign less_2771 = {sum_2770, select_567[0], select_487, 1'b0} < {4'h0, cfg_height_i};

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
  assign fresh_re = s0_en & and_540;
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
  assign left_re = s0_en & (or_529 ? not_537 : select_624);
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
  assign right_codes_raddr = equal_531 ? sum_534[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_530 & select_624);
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
  assign best_left_raddr = or_529 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_650;
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
      left_first_q <= and_1871 ? left_first_q : marks_first_i;
      right_q <= (~and_1871) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1871;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_472 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2036;
      raster_at_column_q <= select_2038;
      raster_at_row_q <= select_2041;
      raster_at_live_q <= select_2045;
      raster_rows_left_q <= sample_pair_whole_q ? select_2047 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2051;
      averager_place_q <= sample_pair_whole_q ? select_478 : averager_place_q;
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
      plan_shift_q <= equal_531 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2343;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2349;
      columns_left_q <= select_2352;
      last_q <= and_508 ? (equal_2295 ? column : last_q) : last_q;
      least_q <= select_2360;
      whole_q <= select_2363;
      drawn_q <= select_2366;
      age_q <= select_2299 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2299 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2380;
      ends_q <= and_2384;
      final_row_q <= and_508 ? select_2387 : final_row_q;
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
  logic [2:0] select_472_s1_q;
  logic [5:0] select_474_s1_q;
  logic [7:0] select_478_s1_q;
  logic and_482_s1_q;
  logic equal_488_s1_q;
  logic [5:0] column_s1_q;
  logic and_506_s1_q;
  logic and_508_s1_q;
  logic so_s1_q;
  logic equal_528_s1_q;
  logic or_529_s1_q;
  logic equal_531_s1_q;
  logic less_536_s1_q;
  logic not_537_s1_q;
  logic and_540_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_650_s1_q;
  logic select_657_s1_q;
  logic and_1459_s1_q;
  logic [5:0] right_s1_q;
  logic select_1468_s1_q;
  logic equal_1477_s1_q;
  logic equal_1596_s1_q;
  logic equal_2295_s1_q;
  logic and_2296_s1_q;
  logic not_2772_s1_q;
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
      select_472_s1_q <= select_472;
      select_474_s1_q <= select_474;
      select_478_s1_q <= select_478;
      and_482_s1_q <= and_482;
      equal_488_s1_q <= select_487 == 3'h0;
      column_s1_q <= column;
      and_506_s1_q <= and_506;
      and_508_s1_q <= and_508;
      so_s1_q <= so;
      equal_528_s1_q <= equal_528;
      or_529_s1_q <= or_529;
      equal_531_s1_q <= equal_531;
      less_536_s1_q <= less_536;
      not_537_s1_q <= not_537;
      and_540_s1_q <= and_540;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_650_s1_q <= select_650;
      select_657_s1_q <= or_655 ? equal_653 : (~age_q[3]);
      and_1459_s1_q <= not_530 & and_649;
      right_s1_q <= right;
      select_1468_s1_q <= or_655 ? equal_653 : ({x[7:6], last_q} == {2'h0, x[5:0]});
      equal_1477_s1_q <= run_phase_q == 3'h7;
      equal_1596_s1_q <= {or_479, select_487} == 4'hc;
      equal_2295_s1_q <= equal_2295;
      and_2296_s1_q <= and_2296;
      not_2772_s1_q <= ~less_2771;
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
  logic not_628;
  assign not_628 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:656
  logic and_629;
  assign and_629 = left_rdata_q[12] & not_628;
  logic and_630;
  assign and_630 = left_rdata_q[28] & not_628;
  logic and_631;
  assign and_631 = left_rdata_q[44] & not_628;
  logic and_632;
  assign and_632 = left_rdata_q[60] & not_628;
  // hls/stages/agreement.hpp:657
  logic and_636;
  assign and_636 = right_codes_rdata_q[12] & not_628;
  logic and_637;
  assign and_637 = right_codes_rdata_q[25] & not_628;
  logic and_638;
  assign and_638 = right_codes_rdata_q[38] & not_628;
  logic and_639;
  assign and_639 = right_codes_rdata_q[51] & not_628;
  logic and_640;
  assign and_640 = right_codes_rdata_q[64] & not_628;
  logic and_641;
  assign and_641 = right_codes_rdata_q[77] & not_628;
  // hls/stages/agreement.hpp:212
  logic and_663;
  assign and_663 = left_rdata_q[44] & not_537_s1_q;
  logic and_664;
  assign and_664 = right_codes_rdata_q[38] & not_537_s1_q;
  logic [11:0] select_665;
  assign select_665 = less_536_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_666;
  assign select_666 = less_536_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_670;
  assign select_670 = and_663 ? (and_664 ? (~(select_665 ^ select_666)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_676;
  assign parity_676 = ^select_670[5:3];
  logic parity_679;
  assign parity_679 = ^select_670[8:6];
  logic parity_682;
  assign parity_682 = ^select_670[11:3];
  // hls/stages/agreement.hpp:212
  logic and_686;
  assign and_686 = left_rdata_q[60] & not_537_s1_q;
  logic and_687;
  assign and_687 = right_codes_rdata_q[51] & not_537_s1_q;
  logic [11:0] select_688;
  assign select_688 = less_536_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_689;
  assign select_689 = less_536_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_693;
  assign select_693 = and_686 ? (and_687 ? (~(select_688 ^ select_689)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_696;
  assign parity_696 = ^select_693[8:6];
  logic parity_699;
  assign parity_699 = ^select_693[11:9];
  // hls/stages/agreement.hpp:212
  logic and_703;
  assign and_703 = left_rdata_q[76] & not_537_s1_q;
  logic and_704;
  assign and_704 = right_codes_rdata_q[64] & not_537_s1_q;
  logic [11:0] select_705;
  assign select_705 = less_536_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_706;
  assign select_706 = less_536_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_710;
  assign select_710 = and_703 ? (and_704 ? (~(select_705 ^ select_706)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_716;
  assign parity_716 = ^select_710[2:0];
  logic parity_719;
  assign parity_719 = ^select_710[5:3];
  logic parity_722;
  assign parity_722 = ^select_710[8:0];
  logic parity_728;
  assign parity_728 = ^select_710[11:9];
  logic parity_731;
  assign parity_731 = ^select_693[2:0];
  logic parity_734;
  assign parity_734 = ^{select_710[11:9], select_693[5:0]};
  logic parity_737;
  assign parity_737 = ^{select_710, select_693, select_670[2:0]};
  logic xor_738;
  assign xor_738 = parity_682 ^ parity_737;
  // hls/stages/count_bits.hpp:23
  logic or_742;
  assign or_742 = (select_670[1:0] == 2'h3) | (select_670[2] & (select_670[0] | select_670[1]));
  // hls/stages/count_bits.hpp:25
  logic or_746;
  assign or_746 = (select_693[7:6] == 2'h3) | (select_693[8] & (select_693[6] | select_693[7]));
  logic or_750;
  assign or_750 = (select_693[10:9] == 2'h3) | (select_693[11] & (select_693[9] | select_693[10]));
  // hls/stages/count_bits.hpp:23
  logic or_758;
  assign or_758 = (select_710[7:6] == 2'h3) | (select_710[8] & (~(select_710[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_762;
  assign or_762 = (select_710[1:0] == 2'h3) | (select_710[2] & (select_710[0] | select_710[1]));
  logic or_766;
  assign or_766 = (select_710[4:3] == 2'h3) | (select_710[5] & (select_710[3] | select_710[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_769;
  assign parity_769 = ^{or_766, or_762, or_758};
  // hls/stages/count_bits.hpp:23
  logic or_773;
  assign or_773 = (select_693[4:3] == 2'h3) | (select_693[5] & (select_693[3] | select_693[4]));
  // hls/stages/count_bits.hpp:25
  logic or_777;
  assign or_777 = (select_710[10:9] == 2'h3) | (select_710[11] & (select_710[9] | select_710[10]));
  logic or_781;
  assign or_781 = (select_693[1:0] == 2'h3) | (select_693[2] & (select_693[0] | select_693[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_784;
  assign parity_784 = ^{or_781, or_777, or_773};
  logic parity_787;
  assign parity_787 = ^{or_781, or_777, or_773, or_766, or_762, or_758, or_750, or_746, or_742};
  // hls/stages/count_bits.hpp:25
  logic and_788;
  assign and_788 = parity_682 & parity_737;
  logic or_792;
  assign or_792 = (parity_676 & parity_679) | ((^select_670[11:9]) & (parity_676 | parity_679));
  logic and_795;
  assign and_795 = (^{select_693[11:6], select_670[2:0]}) & (parity_722 | parity_734);
  logic or_796;
  assign or_796 = (parity_722 & parity_734) | and_795;
  // hls/stages/count_bits.hpp:23
  logic or_803;
  assign or_803 = (select_670[10:9] == 2'h3) | (select_670[11] & (select_670[9] | select_670[10]));
  // hls/stages/count_bits.hpp:25
  logic or_807;
  assign or_807 = (select_670[4:3] == 2'h3) | (select_670[5] & (select_670[3] | select_670[4]));
  logic or_811;
  assign or_811 = (select_670[7:6] == 2'h3) | (select_670[8] & (select_670[6] | select_670[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_814;
  assign parity_814 = ^{or_811, or_807, or_803};
  // hls/stages/count_bits.hpp:25
  logic or_818;
  assign or_818 = (parity_696 & parity_699) | ((^select_670[2:0]) & (parity_696 | parity_699));
  logic or_822;
  assign or_822 = (parity_716 & parity_719) | ((^select_710[8:6]) & (parity_716 | parity_719));
  logic or_826;
  assign or_826 = (parity_728 & parity_731) | ((^select_693[5:3]) & (parity_728 | parity_731));
  // hls/stages/count_bits.hpp:24
  logic parity_829;
  assign parity_829 = ^{or_826, or_822, or_818};
  logic parity_832;
  assign parity_832 = ^{or_826, or_822, or_818, or_811, or_807, or_803, or_796, or_792, and_788};
  logic xor_833;
  assign xor_833 = parity_787 ^ parity_832;
  // hls/stages/count_bits.hpp:25
  logic and_834;
  assign and_834 = parity_787 & parity_832;
  logic or_838;
  assign or_838 = (parity_769 & parity_784) | ((^{or_750, or_746, or_742}) & (parity_769 | parity_784));
  logic or_842;
  assign or_842 = (parity_814 & parity_829) | ((^{or_796, or_792, and_788}) & (parity_814 | parity_829));
  logic or_849;
  assign or_849 = (or_746 & or_750) | (or_742 & (or_746 | or_750));
  logic or_853;
  assign or_853 = (or_762 & or_766) | (or_758 & (or_762 | or_766));
  logic or_857;
  assign or_857 = (or_777 & or_781) | (or_773 & (or_777 | or_781));
  // hls/stages/count_bits.hpp:24
  logic parity_860;
  assign parity_860 = ^{or_857, or_853, or_849};
  // hls/stages/count_bits.hpp:25
  logic or_864;
  assign or_864 = (or_792 & or_796) | (and_788 & (or_792 | or_796));
  logic or_868;
  assign or_868 = (or_807 & or_811) | (or_803 & (or_807 | or_811));
  logic or_872;
  assign or_872 = (or_822 & or_826) | (or_818 & (or_822 | or_826));
  // hls/stages/count_bits.hpp:24
  logic parity_875;
  assign parity_875 = ^{or_872, or_868, or_864};
  logic parity_878;
  assign parity_878 = ^{or_872, or_868, or_864, or_857, or_853, or_849, or_842, or_838, and_834};
  // hls/stages/count_bits.hpp:25
  logic or_882;
  assign or_882 = (parity_860 & parity_875) | ((^{or_842, or_838, and_834}) & (parity_860 | parity_875));
  logic or_886;
  assign or_886 = (or_838 & or_842) | (and_834 & (or_838 | or_842));
  logic or_890;
  assign or_890 = (or_853 & or_857) | (or_849 & (or_853 | or_857));
  logic or_894;
  assign or_894 = (or_868 & or_872) | (or_864 & (or_868 | or_872));
  // hls/stages/count_bits.hpp:24
  logic parity_899;
  assign parity_899 = ^{or_894, or_890, or_886, or_882};
  // hls/stages/count_bits.hpp:25
  logic or_903;
  assign or_903 = (or_890 & or_894) | (or_886 & (or_890 | or_894));
  logic and_904;
  assign and_904 = or_882 & (^{or_894, or_890, or_886});
  // hls/stages/count_bits.hpp:24
  logic xor_905;
  assign xor_905 = or_903 ^ and_904;
  // hls/stages/count_bits.hpp:27
  logic and_906;
  assign and_906 = or_903 & and_904;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_907;
  assign select_907 = equal_531_s1_q ? {and_906, xor_905, parity_899, parity_878, xor_833, xor_738} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_529_s1_q ? 6'h0 : select_907;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_918;
  assign select_918 = (slot_s1_q[0] ? and_704 : and_687) ? (~(select_666 ^ (slot_s1_q[0] ? select_705 : select_688))) : 12'h0;
  logic [11:0] select_919;
  assign select_919 = and_663 ? select_918 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_925;
  assign parity_925 = ^select_919[5:3];
  logic parity_928;
  assign parity_928 = ^select_919[8:6];
  logic parity_931;
  assign parity_931 = ^select_919[11:3];
  // hls/stages/agreement.hpp:212
  logic and_935;
  assign and_935 = right_codes_rdata_q[77] & not_537_s1_q;
  logic [11:0] select_937;
  assign select_937 = less_536_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_941;
  assign select_941 = (slot_s1_q[0] ? and_935 : and_704) ? (~(select_689 ^ (slot_s1_q[0] ? select_937 : select_705))) : 12'h0;
  logic [11:0] select_942;
  assign select_942 = and_686 ? select_941 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_945;
  assign parity_945 = ^select_942[8:6];
  logic parity_948;
  assign parity_948 = ^select_942[11:9];
  // hls/stages/agreement.hpp:718
  logic select_953;
  assign select_953 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_537_s1_q) : and_935;
  logic [11:0] select_955;
  assign select_955 = slot_s1_q[0] ? (less_536_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_937;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_959;
  assign select_959 = and_703 ? (select_953 ? (~(select_706 ^ select_955)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_965;
  assign parity_965 = ^select_959[2:0];
  logic parity_968;
  assign parity_968 = ^select_959[5:3];
  logic parity_971;
  assign parity_971 = ^select_959[8:0];
  logic parity_977;
  assign parity_977 = ^select_959[11:9];
  logic parity_980;
  assign parity_980 = ^select_942[2:0];
  logic parity_983;
  assign parity_983 = ^{select_959[11:9], select_942[5:0]};
  logic parity_986;
  assign parity_986 = ^{select_959, select_942, select_919[2:0]};
  logic xor_987;
  assign xor_987 = parity_931 ^ parity_986;
  // hls/stages/count_bits.hpp:23
  logic or_991;
  assign or_991 = (select_919[1:0] == 2'h3) | (select_919[2] & (select_919[0] | select_919[1]));
  // hls/stages/count_bits.hpp:25
  logic or_995;
  assign or_995 = (select_942[7:6] == 2'h3) | (select_942[8] & (select_942[6] | select_942[7]));
  logic or_999;
  assign or_999 = (select_942[10:9] == 2'h3) | (select_942[11] & (select_942[9] | select_942[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1007;
  assign or_1007 = (select_959[7:6] == 2'h3) | (select_959[8] & (~(select_959[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1011;
  assign or_1011 = (select_959[1:0] == 2'h3) | (select_959[2] & (select_959[0] | select_959[1]));
  logic or_1015;
  assign or_1015 = (select_959[4:3] == 2'h3) | (select_959[5] & (select_959[3] | select_959[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1018;
  assign parity_1018 = ^{or_1015, or_1011, or_1007};
  // hls/stages/count_bits.hpp:23
  logic or_1022;
  assign or_1022 = (select_942[4:3] == 2'h3) | (select_942[5] & (select_942[3] | select_942[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1026;
  assign or_1026 = (select_959[10:9] == 2'h3) | (select_959[11] & (select_959[9] | select_959[10]));
  logic or_1030;
  assign or_1030 = (select_942[1:0] == 2'h3) | (select_942[2] & (select_942[0] | select_942[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1033;
  assign parity_1033 = ^{or_1030, or_1026, or_1022};
  logic parity_1036;
  assign parity_1036 = ^{or_1030, or_1026, or_1022, or_1015, or_1011, or_1007, or_999, or_995, or_991};
  // hls/stages/count_bits.hpp:25
  logic and_1037;
  assign and_1037 = parity_931 & parity_986;
  logic or_1041;
  assign or_1041 = (parity_925 & parity_928) | ((^select_919[11:9]) & (parity_925 | parity_928));
  logic and_1044;
  assign and_1044 = (^{select_942[11:6], select_919[2:0]}) & (parity_971 | parity_983);
  logic or_1045;
  assign or_1045 = (parity_971 & parity_983) | and_1044;
  // hls/stages/count_bits.hpp:23
  logic or_1052;
  assign or_1052 = (select_919[10:9] == 2'h3) | (select_919[11] & (select_919[9] | select_919[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1056;
  assign or_1056 = (select_919[4:3] == 2'h3) | (select_919[5] & (select_919[3] | select_919[4]));
  logic or_1060;
  assign or_1060 = (select_919[7:6] == 2'h3) | (select_919[8] & (select_919[6] | select_919[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1063;
  assign parity_1063 = ^{or_1060, or_1056, or_1052};
  // hls/stages/count_bits.hpp:25
  logic or_1067;
  assign or_1067 = (parity_945 & parity_948) | ((^select_919[2:0]) & (parity_945 | parity_948));
  logic or_1071;
  assign or_1071 = (parity_965 & parity_968) | ((^select_959[8:6]) & (parity_965 | parity_968));
  logic or_1075;
  assign or_1075 = (parity_977 & parity_980) | ((^select_942[5:3]) & (parity_977 | parity_980));
  // hls/stages/count_bits.hpp:24
  logic parity_1078;
  assign parity_1078 = ^{or_1075, or_1071, or_1067};
  logic parity_1081;
  assign parity_1081 = ^{or_1075, or_1071, or_1067, or_1060, or_1056, or_1052, or_1045, or_1041, and_1037};
  logic xor_1082;
  assign xor_1082 = parity_1036 ^ parity_1081;
  // hls/stages/count_bits.hpp:25
  logic and_1083;
  assign and_1083 = parity_1036 & parity_1081;
  logic or_1087;
  assign or_1087 = (parity_1018 & parity_1033) | ((^{or_999, or_995, or_991}) & (parity_1018 | parity_1033));
  logic or_1091;
  assign or_1091 = (parity_1063 & parity_1078) | ((^{or_1045, or_1041, and_1037}) & (parity_1063 | parity_1078));
  logic or_1098;
  assign or_1098 = (or_995 & or_999) | (or_991 & (or_995 | or_999));
  logic or_1102;
  assign or_1102 = (or_1011 & or_1015) | (or_1007 & (or_1011 | or_1015));
  logic or_1106;
  assign or_1106 = (or_1026 & or_1030) | (or_1022 & (or_1026 | or_1030));
  // hls/stages/count_bits.hpp:24
  logic parity_1109;
  assign parity_1109 = ^{or_1106, or_1102, or_1098};
  // hls/stages/count_bits.hpp:25
  logic or_1113;
  assign or_1113 = (or_1041 & or_1045) | (and_1037 & (or_1041 | or_1045));
  logic or_1117;
  assign or_1117 = (or_1056 & or_1060) | (or_1052 & (or_1056 | or_1060));
  logic or_1121;
  assign or_1121 = (or_1071 & or_1075) | (or_1067 & (or_1071 | or_1075));
  // hls/stages/count_bits.hpp:24
  logic parity_1124;
  assign parity_1124 = ^{or_1121, or_1117, or_1113};
  logic parity_1127;
  assign parity_1127 = ^{or_1121, or_1117, or_1113, or_1106, or_1102, or_1098, or_1091, or_1087, and_1083};
  // hls/stages/count_bits.hpp:25
  logic or_1131;
  assign or_1131 = (parity_1109 & parity_1124) | ((^{or_1091, or_1087, and_1083}) & (parity_1109 | parity_1124));
  logic or_1135;
  assign or_1135 = (or_1087 & or_1091) | (and_1083 & (or_1087 | or_1091));
  logic or_1139;
  assign or_1139 = (or_1102 & or_1106) | (or_1098 & (or_1102 | or_1106));
  logic or_1143;
  assign or_1143 = (or_1117 & or_1121) | (or_1113 & (or_1117 | or_1121));
  // hls/stages/count_bits.hpp:24
  logic parity_1148;
  assign parity_1148 = ^{or_1143, or_1139, or_1135, or_1131};
  // hls/stages/count_bits.hpp:25
  logic or_1152;
  assign or_1152 = (or_1139 & or_1143) | (or_1135 & (or_1139 | or_1143));
  logic and_1153;
  assign and_1153 = or_1131 & (^{or_1143, or_1139, or_1135});
  // hls/stages/count_bits.hpp:24
  logic xor_1154;
  assign xor_1154 = or_1152 ^ and_1153;
  // hls/stages/count_bits.hpp:27
  logic and_1155;
  assign and_1155 = or_1152 & and_1153;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1156;
  assign select_1156 = equal_531_s1_q ? {and_1155, xor_1154, parity_1148, parity_1127, xor_1082, xor_987} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_529_s1_q ? 6'h0 : select_1156;
  // hls/stages/agreement.hpp:212
  logic and_1164;
  assign and_1164 = right_codes_rdata_q[25] & not_537_s1_q;
  // hls/stages/agreement.hpp:718
  logic select_1165;
  assign select_1165 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_537_s1_q) : and_1164;
  // hls/stages/agreement.hpp:212
  logic [11:0] select_1167;
  assign select_1167 = less_536_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:718
  logic [11:0] select_1168;
  assign select_1168 = slot_s1_q[0] ? (less_536_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1167;
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1172;
  assign select_1172 = and_663 ? (select_1165 ? (~(select_666 ^ select_1168)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1178;
  assign parity_1178 = ^select_1172[5:3];
  logic parity_1181;
  assign parity_1181 = ^select_1172[8:6];
  logic parity_1184;
  assign parity_1184 = ^select_1172[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1192;
  assign select_1192 = (slot_s1_q[0] ? and_1164 : and_664) ? (~(select_689 ^ (slot_s1_q[0] ? select_1167 : select_665))) : 12'h0;
  logic [11:0] select_1193;
  assign select_1193 = and_686 ? select_1192 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1196;
  assign parity_1196 = ^select_1193[8:6];
  logic parity_1199;
  assign parity_1199 = ^select_1193[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1207;
  assign select_1207 = (slot_s1_q[0] ? and_664 : and_687) ? (~(select_706 ^ (slot_s1_q[0] ? select_665 : select_688))) : 12'h0;
  logic [11:0] select_1208;
  assign select_1208 = and_703 ? select_1207 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1214;
  assign parity_1214 = ^select_1208[2:0];
  logic parity_1217;
  assign parity_1217 = ^select_1208[5:3];
  logic parity_1220;
  assign parity_1220 = ^select_1208[8:0];
  logic parity_1226;
  assign parity_1226 = ^select_1208[11:9];
  logic parity_1229;
  assign parity_1229 = ^select_1193[2:0];
  logic parity_1232;
  assign parity_1232 = ^{select_1208[11:9], select_1193[5:0]};
  logic parity_1235;
  assign parity_1235 = ^{select_1208, select_1193, select_1172[2:0]};
  logic xor_1236;
  assign xor_1236 = parity_1184 ^ parity_1235;
  // hls/stages/count_bits.hpp:23
  logic or_1240;
  assign or_1240 = (select_1172[1:0] == 2'h3) | (select_1172[2] & (select_1172[0] | select_1172[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1244;
  assign or_1244 = (select_1193[7:6] == 2'h3) | (select_1193[8] & (select_1193[6] | select_1193[7]));
  logic or_1248;
  assign or_1248 = (select_1193[10:9] == 2'h3) | (select_1193[11] & (select_1193[9] | select_1193[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1256;
  assign or_1256 = (select_1208[7:6] == 2'h3) | (select_1208[8] & (~(select_1208[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1260;
  assign or_1260 = (select_1208[1:0] == 2'h3) | (select_1208[2] & (select_1208[0] | select_1208[1]));
  logic or_1264;
  assign or_1264 = (select_1208[4:3] == 2'h3) | (select_1208[5] & (select_1208[3] | select_1208[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1267;
  assign parity_1267 = ^{or_1264, or_1260, or_1256};
  // hls/stages/count_bits.hpp:23
  logic or_1271;
  assign or_1271 = (select_1193[4:3] == 2'h3) | (select_1193[5] & (select_1193[3] | select_1193[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1275;
  assign or_1275 = (select_1208[10:9] == 2'h3) | (select_1208[11] & (select_1208[9] | select_1208[10]));
  logic or_1279;
  assign or_1279 = (select_1193[1:0] == 2'h3) | (select_1193[2] & (select_1193[0] | select_1193[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1282;
  assign parity_1282 = ^{or_1279, or_1275, or_1271};
  logic parity_1285;
  assign parity_1285 = ^{or_1279, or_1275, or_1271, or_1264, or_1260, or_1256, or_1248, or_1244, or_1240};
  // hls/stages/count_bits.hpp:25
  logic and_1286;
  assign and_1286 = parity_1184 & parity_1235;
  logic or_1290;
  assign or_1290 = (parity_1178 & parity_1181) | ((^select_1172[11:9]) & (parity_1178 | parity_1181));
  logic and_1293;
  assign and_1293 = (^{select_1193[11:6], select_1172[2:0]}) & (parity_1220 | parity_1232);
  logic or_1294;
  assign or_1294 = (parity_1220 & parity_1232) | and_1293;
  // hls/stages/count_bits.hpp:23
  logic or_1301;
  assign or_1301 = (select_1172[10:9] == 2'h3) | (select_1172[11] & (select_1172[9] | select_1172[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1305;
  assign or_1305 = (select_1172[4:3] == 2'h3) | (select_1172[5] & (select_1172[3] | select_1172[4]));
  logic or_1309;
  assign or_1309 = (select_1172[7:6] == 2'h3) | (select_1172[8] & (select_1172[6] | select_1172[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1312;
  assign parity_1312 = ^{or_1309, or_1305, or_1301};
  // hls/stages/count_bits.hpp:25
  logic or_1316;
  assign or_1316 = (parity_1196 & parity_1199) | ((^select_1172[2:0]) & (parity_1196 | parity_1199));
  logic or_1320;
  assign or_1320 = (parity_1214 & parity_1217) | ((^select_1208[8:6]) & (parity_1214 | parity_1217));
  logic or_1324;
  assign or_1324 = (parity_1226 & parity_1229) | ((^select_1193[5:3]) & (parity_1226 | parity_1229));
  // hls/stages/count_bits.hpp:24
  logic parity_1327;
  assign parity_1327 = ^{or_1324, or_1320, or_1316};
  logic parity_1330;
  assign parity_1330 = ^{or_1324, or_1320, or_1316, or_1309, or_1305, or_1301, or_1294, or_1290, and_1286};
  logic xor_1331;
  assign xor_1331 = parity_1285 ^ parity_1330;
  // hls/stages/count_bits.hpp:25
  logic and_1332;
  assign and_1332 = parity_1285 & parity_1330;
  logic or_1336;
  assign or_1336 = (parity_1267 & parity_1282) | ((^{or_1248, or_1244, or_1240}) & (parity_1267 | parity_1282));
  logic or_1340;
  assign or_1340 = (parity_1312 & parity_1327) | ((^{or_1294, or_1290, and_1286}) & (parity_1312 | parity_1327));
  logic or_1347;
  assign or_1347 = (or_1244 & or_1248) | (or_1240 & (or_1244 | or_1248));
  logic or_1351;
  assign or_1351 = (or_1260 & or_1264) | (or_1256 & (or_1260 | or_1264));
  logic or_1355;
  assign or_1355 = (or_1275 & or_1279) | (or_1271 & (or_1275 | or_1279));
  // hls/stages/count_bits.hpp:24
  logic parity_1358;
  assign parity_1358 = ^{or_1355, or_1351, or_1347};
  // hls/stages/count_bits.hpp:25
  logic or_1362;
  assign or_1362 = (or_1290 & or_1294) | (and_1286 & (or_1290 | or_1294));
  logic or_1366;
  assign or_1366 = (or_1305 & or_1309) | (or_1301 & (or_1305 | or_1309));
  logic or_1370;
  assign or_1370 = (or_1320 & or_1324) | (or_1316 & (or_1320 | or_1324));
  // hls/stages/count_bits.hpp:24
  logic parity_1373;
  assign parity_1373 = ^{or_1370, or_1366, or_1362};
  logic parity_1376;
  assign parity_1376 = ^{or_1370, or_1366, or_1362, or_1355, or_1351, or_1347, or_1340, or_1336, and_1332};
  // hls/stages/count_bits.hpp:25
  logic or_1380;
  assign or_1380 = (parity_1358 & parity_1373) | ((^{or_1340, or_1336, and_1332}) & (parity_1358 | parity_1373));
  logic or_1384;
  assign or_1384 = (or_1336 & or_1340) | (and_1332 & (or_1336 | or_1340));
  logic or_1388;
  assign or_1388 = (or_1351 & or_1355) | (or_1347 & (or_1351 | or_1355));
  logic or_1392;
  assign or_1392 = (or_1366 & or_1370) | (or_1362 & (or_1366 | or_1370));
  // hls/stages/count_bits.hpp:24
  logic parity_1397;
  assign parity_1397 = ^{or_1392, or_1388, or_1384, or_1380};
  // hls/stages/count_bits.hpp:25
  logic or_1401;
  assign or_1401 = (or_1388 & or_1392) | (or_1384 & (or_1388 | or_1392));
  logic and_1402;
  assign and_1402 = or_1380 & (^{or_1392, or_1388, or_1384});
  // hls/stages/count_bits.hpp:24
  logic xor_1403;
  assign xor_1403 = or_1401 ^ and_1402;
  // hls/stages/count_bits.hpp:27
  logic and_1404;
  assign and_1404 = or_1401 & and_1402;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1405;
  assign select_1405 = equal_531_s1_q ? {and_1404, xor_1403, parity_1397, parity_1376, xor_1331, xor_1236} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_529_s1_q ? 6'h0 : select_1405;
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:929
  logic [5:0] select_1463;
  assign select_1463 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:932
  logic and_1483;
  assign and_1483 = (or_529_s1_q & (left_rdata_q[61] & not_537_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1505;
  assign or_1505 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/patches.hpp:330
  logic [5:0] select_1516;
  assign select_1516 = so_s1_q ? x_s1_q[5:0] : (or_529_s1_q ? (less_536_s1_q ? 6'h0 : select_1463) : 6'h0);
  // hls/stages/patches.hpp:114
  logic and_1590;
  assign and_1590 = (select_472_s1_q == 3'h0) & (select_474_s1_q == 6'h0);
  // hls/stages/patches.hpp:382
  logic not_1591;
  assign not_1591 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_1594;
  assign not_1594 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:352
  logic and_1595;
  assign and_1595 = patches_capturing_q & not_1594;
  // hls/stages/patches.hpp:302
  logic equal_1598;
  assign equal_1598 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:117
  logic and_1603;
  assign and_1603 = (not_1591 & (patches_work_q == 3'h0)) & (~(and_1595 | ((~equal_1596_s1_q) | (~equal_1598))));
  // hls/stages/patches.hpp:520
  logic equal_1690;
  assign equal_1690 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:498
  logic not_1691;
  assign not_1691 = ~equal_1690;
  // hls/stages/patches.hpp:491
  logic equal_1692;
  assign equal_1692 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:444
  logic not_1693;
  assign not_1693 = ~equal_1692;
  // hls/stages/patches.hpp:485
  logic equal_1694;
  assign equal_1694 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:159
  logic equal_1695;
  assign equal_1695 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:520
  logic or_1696;
  assign or_1696 = equal_1694 | equal_1695;
  // hls/stages/patches.hpp:446
  logic not_1697;
  assign not_1697 = ~patches_second_q;
  // hls/stages/patches.hpp:363
  logic [4:0] select_1719;
  assign select_1719 = and_1603 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:118
  logic [4:0] select_1720;
  assign select_1720 = and_1590 ? select_1719 : patches_row_q;
  // hls/stages/patches.hpp:117
  logic and_1722;
  assign and_1722 = and_1595 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:118
  logic select_1726;
  assign select_1726 = and_1590 ? (and_1603 | (and_1595 & (~and_1722))) : patches_capturing_q;
  // hls/stages/patches.hpp:176
  logic and_1734;
  assign and_1734 = not_1691 & (not_1693 & (or_1696 & (patches_second_q & equal_1695)));
  // hls/stages/patches.hpp:159
  logic not_1751;
  assign not_1751 = ~equal_1695;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_1767;
  assign select_1767 = and_1590 ? {select_1719[4], select_1719[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:444
  logic and_1777;
  assign and_1777 = not_1691 & (or_1696 & not_1693);
  // hls/stages/agreement.hpp:447
  logic select_2392;
  assign select_2392 = equal_2295_s1_q ? (~({row_s1_q, 1'b0} < {sum_2389, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2597;
  assign and_2597 = and_508_s1_q & (equal_2295_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:308
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:118
  logic [3:0] select_2707;
  assign select_2707 = and_1590 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2708;
  assign select_2708 = sample_pair_whole_s1_q ? select_2707 : patches_phase_q;
  // hls/stages/patches.hpp:363
  logic and_2709;
  assign and_2709 = not_1594 & equal_1596_s1_q;
  logic [8:0] select_2710;
  assign select_2710 = and_2709 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2711;
  assign select_2711 = and_2709 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2712;
  assign select_2712 = sample_pair_first_s1_q ? select_2710 : select_2711;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2714;
  assign select_2714 = sample_pair_whole_s1_q ? (and_1590 ? select_2712[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2716;
  assign select_2716 = sample_pair_whole_s1_q ? (and_1590 ? select_2712[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2719;
  assign select_2719 = sample_pair_whole_s1_q ? (equal_1598 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2721;
  assign select_2721 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_1598}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:321
  logic equal_2722;
  assign equal_2722 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:322
  logic not_2723;
  assign not_2723 = ~equal_2722;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2725;
  assign select_2725 = sample_pair_whole_s1_q ? (phase + {not_2723, 1'b1, not_2723, equal_2722}) : patches_first_band_rows_to_next_q;
  logic select_2726;
  assign select_2726 = sample_pair_whole_s1_q ? equal_2722 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:457
  logic equal_2727;
  assign equal_2727 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:79
  logic [3:0] select_2731;
  assign select_2731 = equal_2727 ? ((select_2708 == 4'h6) ? 4'h0 : (select_2708 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2732;
  assign equal_2732 = select_2731 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_2735;
  assign select_2735 = equal_2295_s1_q ? (equal_2732 ? 4'h6 : (select_2731 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:79
  logic [4:0] select_2737;
  assign select_2737 = equal_2727 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_2739;
  assign select_2739 = equal_2295_s1_q ? (select_2737 + {4'h0, equal_2732}) : patches_choosing_number_q;
  logic select_2743;
  assign select_2743 = equal_2295_s1_q ? ((6'h2 < row_s1_q) & equal_2732) : patches_chooses_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_2746;
  assign select_2746 = and_508_s1_q ? (equal_2295_s1_q ? select_2737 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:118
  logic select_2774;
  assign select_2774 = and_1590 ? (and_1603 ? not_2772_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:383
  logic or_2813;
  assign or_2813 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:385
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:179
  logic and_2819;
  assign and_2819 = equal_1690 & not_1697;
  // hls/stages/patches.hpp:389
  logic and_2820;
  assign and_2820 = not_1751 & and_2819;
  logic [1:0] select_2822;
  assign select_2822 = equal_1692 ? 2'h0 : (equal_1694 ? 2'h3 : {equal_1695, and_2820});
  // hls/stages/patches.hpp:270
  logic equal_2824;
  assign equal_2824 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:268
  logic not_2825;
  assign not_2825 = ~equal_2824;
  // hls/stages/patches.hpp:270
  logic equal_2826;
  assign equal_2826 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:266
  logic not_2827;
  assign not_2827 = ~equal_2826;
  // hls/stages/patches.hpp:274
  logic not_2829;
  assign not_2829 = ~(patches_following_q == 3'h2);
  logic and_2832;
  assign and_2832 = (~(patches_following_q == 3'h1)) & not_2829;
  // hls/stages/patches.hpp:387
  logic [1:0] select_2833;
  assign select_2833 = equal_2826 ? 2'h2 : {and_2832, not_2829};
  logic [3:0] select_2834;
  assign select_2834 = equal_2824 ? 4'h2 : {select_2833, {2{not_2827}}};
  // hls/stages/patches.hpp:395
  logic not_2837;
  assign not_2837 = ~or_2813;
  // hls/stages/patches.hpp:384
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:396
  logic [11:0] select_2842;
  assign select_2842 = or_2813 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:179
  logic [4:0] select_2844;
  assign select_2844 = or_2813 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1298; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_529_s1_q ? select_1463 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_650_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:757; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
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

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:757; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
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

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:758; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
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

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:769; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign left_we = s1_en & and_540_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_632, left_rdata_q[59:45], and_631, left_rdata_q[43:29], and_630, left_rdata_q[27:13], and_629, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_540_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_641, right_codes_rdata_q[76:65], and_640, right_codes_rdata_q[63:52], and_639, right_codes_rdata_q[50:39], and_638, right_codes_rdata_q[37:26], and_637, right_codes_rdata_q[24:13], and_636, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_508_s1_q ? (equal_2295_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_508_s1_q ? select_2392 : lower_half_q;
      patches_phase_q <= select_2708;
      patches_band_rows_rows_to_next_q <= select_2714;
      patches_band_rows_number_q <= select_2716;
      patches_next_band_rows_to_next_q <= select_2719;
      patches_next_band_number_q <= select_2721;
      patches_first_band_rows_to_next_q <= select_2725;
      patches_first_band_number_q <= select_2726;
      patches_choosing_rows_to_next_q <= and_508_s1_q ? select_2735 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_508_s1_q ? select_2739 : patches_choosing_number_q;
      patches_chooses_q <= and_508_s1_q ? select_2743 : patches_chooses_q;
      patches_choosing_band_q <= select_2746;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_1726 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_2774 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_1720 : patches_row_q;
      patches_work_q <= or_2813 ? following : patches_work_q;
      patches_second_q <= not_1591 & (patches_second_q | (patches_ends_q & equal_1690));
      patches_following_q <= equal_1690 ? {2'h0, and_2819} : {equal_1692, select_2822};
      patches_following_beats_q <= {select_2834, not_2825};
      patches_begins_q <= sample_pair_whole_s1_q & (and_1590 & and_1722);
      patches_ends_q <= not_2837 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2842;
      patches_code_row_q <= select_2844;
      patches_column_q <= or_2813 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2837 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_472_s2_q;
  logic [5:0] select_474_s2_q;
  logic [7:0] select_478_s2_q;
  logic and_482_s2_q;
  logic equal_488_s2_q;
  logic [5:0] column_s2_q;
  logic and_506_s2_q;
  logic and_508_s2_q;
  logic so_s2_q;
  logic equal_528_s2_q;
  logic or_529_s2_q;
  logic less_536_s2_q;
  logic not_537_s2_q;
  logic equal_569_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_657_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1158_s2_q;
  logic [5:0] select_1407_s2_q;
  logic and_1459_s2_q;
  logic [5:0] right_s2_q;
  logic select_1468_s2_q;
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
  logic and_2598_s2_q;
  logic and_2600_s2_q;
  logic or_2813_s2_q;
  logic not_2837_s2_q;
  logic less_3619_s2_q;
  logic equal_3824_s2_q;
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
      select_472_s2_q <= select_472_s1_q;
      select_474_s2_q <= select_474_s1_q;
      select_478_s2_q <= select_478_s1_q;
      and_482_s2_q <= and_482_s1_q;
      equal_488_s2_q <= equal_488_s1_q;
      column_s2_q <= column_s1_q;
      and_506_s2_q <= and_506_s1_q;
      and_508_s2_q <= and_508_s1_q;
      so_s2_q <= so_s1_q;
      equal_528_s2_q <= equal_528_s1_q;
      or_529_s2_q <= or_529_s1_q;
      less_536_s2_q <= less_536_s1_q;
      not_537_s2_q <= not_537_s1_q;
      equal_569_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_657_s2_q <= select_657_s1_q;
      column_2_s2_q <= column_2;
      select_1158_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1407_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1459_s2_q <= and_1459_s1_q;
      right_s2_q <= right_s1_q;
      select_1468_s2_q <= select_1468_s1_q;
      equal_1477_s2_q <= equal_1477_s1_q;
      and_1484_s2_q <= not_537_s1_q & and_1483;
      and_1487_s2_q <= (or_529_s1_q & (left_rdata_q[62] & not_537_s1_q)) & and_1483;
      and_1491_s2_q <= not_537_s1_q & (or_529_s1_q & (left_rdata_q[63] & not_537_s1_q));
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
      and_2598_s2_q <= and_2296_s1_q & and_2597;
      and_2600_s2_q <= and_2296_s1_q & (~and_2597);
      or_2813_s2_q <= or_2813;
      not_2837_s2_q <= not_2837;
      less_3619_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3824_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic and_483;
  assign and_483 = sample_pair_whole_s2_q & and_482_s2_q;
  // hls/stages/agreement.hpp:772
  logic not_659;
  assign not_659 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_660;
  assign less_660 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:231
  logic and_662;
  assign and_662 = not_659 & (~less_660);
  // hls/stages/agreement.hpp:762
  logic [5:0] select_909;
  assign select_909 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_910;
  assign difference_910 = {1'b0, column_2_s2_q} - {1'b0, select_909};
  logic [7:0] sum_912;
  assign sum_912 = {difference_910[6], difference_910} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:739
  logic [7:0] select_913;
  assign select_913 = slot_s2_q[0] ? chosen_score_q : sum_912;
  // hls/stages/agreement.hpp:762
  logic [6:0] difference_1159;
  assign difference_1159 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1158_s2_q};
  // hls/stages/agreement.hpp:733
  logic equal_1160;
  assign equal_1160 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:762
  logic [7:0] sum_1162;
  assign sum_1162 = {difference_1159[6], difference_1159} + (equal_1160 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1408;
  assign difference_1408 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1407_s2_q};
  logic [7:0] sum_1410;
  assign sum_1410 = {difference_1408[6], difference_1408} + (equal_1160 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:735
  logic less_1411;
  assign less_1411 = sum_1162 < sum_1410;
  logic [7:0] select_1412;
  assign select_1412 = less_1411 ? sum_1410 : sum_1162;
  logic less_1413;
  assign less_1413 = select_913 < select_1412;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_662 ? (less_1413 ? select_1412 : select_913) : 8'h0;
  // hls/stages/agreement.hpp:783
  logic or_1417;
  assign or_1417 = select_657_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1418;
  assign select_1418 = or_1417 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:704
  logic not_1419;
  assign not_1419 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:736
  logic [1:0] select_1420;
  assign select_1420 = less_1411 ? {slot_s2_q[0], not_1419} : 2'h0;
  logic [2:0] select_1422;
  assign select_1422 = less_1413 ? {select_1420, not_1419} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:788
  logic [2:0] select_1423;
  assign select_1423 = or_1417 ? select_1422 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1424;
  assign select_1424 = or_1417 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:785
  logic equal_1425;
  assign equal_1425 = select_1422 == 3'h1;
  logic equal_1426;
  assign equal_1426 = select_1422 == 3'h2;
  logic not_1427;
  assign not_1427 = ~equal_1426;
  logic [2:0] select_1428;
  assign select_1428 = equal_1425 ? 3'h2 : {not_1427, {2{equal_1426}}};
  // hls/stages/agreement.hpp:227
  logic [7:0] select_1431;
  assign select_1431 = slot_s2_q[0] ? 8'h0 : sum_912;
  // hls/stages/agreement.hpp:785
  logic [7:0] select_1433;
  assign select_1433 = select_1428[1] ? (select_1428[0] ? before_1_q : sum_1162) : (select_1428[0] ? sum_1162 : select_1431);
  logic [7:0] select_1434;
  assign select_1434 = select_1428[2] ? (select_1428[0] ? before_2_q : before_0_q) : select_1433;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1435;
  assign select_1435 = or_1417 ? select_1434 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:786
  logic [1:0] select_1436;
  assign select_1436 = equal_1425 ? 2'h0 : {not_1427, equal_1426};
  logic [7:0] select_1438;
  assign select_1438 = select_1436[1] ? sum_1410 : (select_1436[0] ? before_2_q : before_0_q);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1439;
  assign select_1439 = or_1417 ? select_1438 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1441;
  assign sum_1441 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1442;
  assign sum_1442 = {1'b0, before_v} + sum_1441;
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1443;
  assign select_1443 = slot_s2_q[0] ? chosen_near_q : sum_1442;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1445;
  assign sum_1445 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1446;
  assign sum_1446 = {1'b0, before_v_2} + sum_1445;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1448;
  assign sum_1448 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1449;
  assign sum_1449 = {1'b0, before_v_3} + sum_1448;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1451;
  assign select_1451 = (sum_1446 < sum_1449) ? sum_1449 : sum_1446;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_662 ? ((select_1443 < select_1451) ? select_1451 : select_1443) : 7'h0;
  // hls/stages/agreement.hpp:788
  logic or_1456;
  assign or_1456 = select_657_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:792
  logic [6:0] select_1457;
  assign select_1457 = or_1456 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1458;
  assign select_1458 = or_1456 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:797
  logic or_1470;
  assign or_1470 = select_1468_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1471;
  assign select_1471 = or_1470 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1472;
  assign select_1472 = or_1470 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1474;
  assign or_1474 = select_1468_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1475;
  assign select_1475 = or_1474 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1476;
  assign select_1476 = or_1474 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic not_1478;
  assign not_1478 = ~equal_1477_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1488;
  assign and_1488 = not_537_s2_q & and_1487_s2_q;
  // hls/stages/agreement.hpp:935
  logic select_1494;
  assign select_1494 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1497;
  assign difference_1497 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:943
  logic [9:0] sum_1498;
  assign sum_1498 = {difference_1497[8], difference_1497} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1500;
  assign and_1500 = (and_1487_s2_q & select_1494) & ({{22{sum_1498[9]}}, sum_1498} < 32'h3);
  logic and_1501;
  assign and_1501 = not_537_s2_q & and_1500;
  logic and_1507;
  assign and_1507 = not_537_s2_q & (and_1500 & or_1505_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1508;
  assign select_1508 = less_536_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_529_s2_q ? {select_1508, and_1507, and_1501, and_1491_s2_q, and_1488, and_1484_s2_q, not_537_s2_q} : 15'h0;
  // hls/stages/patches.hpp:330
  logic and_1510;
  assign and_1510 = ends_cell_s2_q & shift_2[0];
  logic and_1512;
  assign and_1512 = not_1478 & (so_s2_q & and_1510);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1620;
  assign select_1620 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1620[16:7])) ? 8'h7f : select_1620[7:0];
  // hls/stages/patches.hpp:164
  logic [7:0] pixel;
  assign pixel = equal_1695_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1695_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:486
  logic less_1783;
  assign less_1783 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:487
  logic or_1784;
  assign or_1784 = equal_1694_s2_q | less_1783;
  // hls/stages/patches.hpp:490
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1789;
  assign select_1789 = equal_1694_s2_q ? patches_column_s2_q[0] : (or_1784 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1790;
  assign not_1790 = ~or_1784;
  // hls/stages/patches.hpp:487
  logic [4:0] sum_1791;
  assign sum_1791 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:489
  logic [4:0] select_1794;
  assign select_1794 = or_1784 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1791) + 5'h1) : sum_1791;
  // hls/stages/patches.hpp:491
  logic [4:0] select_1795;
  assign select_1795 = equal_1694_s2_q ? 5'h0 : select_1794;
  logic or_1796;
  assign or_1796 = equal_1694_s2_q | equal_1692_s2_q;
  // hls/stages/patches.hpp:467
  logic equal_1798;
  assign equal_1798 = patches_column_s2_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s2_q == 5'h11;
  logic equal_1800;
  assign equal_1800 = patches_column_s2_q == 5'h18;
  // hls/stages/patches.hpp:469
  logic and_1802;
  assign and_1802 = of_row & (~equal_1800);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1798 ? 2'h3 : {equal_1800, and_1802};
  // hls/stages/patches.hpp:455
  logic [8:0] sum_1805;
  assign sum_1805 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1806;
  assign sum_1806 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1805, pixel_2[0]} - {1'b0, sum_1806, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:457
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
  // hls/stages/patches.hpp:453
  logic [8:0] sum_1815;
  assign sum_1815 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1816;
  assign sum_1816 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1815};
  logic [10:0] sum_1817;
  assign sum_1817 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1816, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1818;
  assign sum_1818 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1817[10:1];
  // hls/stages/patches.hpp:454
  logic [11:0] smooth;
  assign smooth = {sum_1818, sum_1817[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:456
  logic [12:0] sum_1820;
  assign sum_1820 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1821;
  assign sum_1821 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1822;
  assign difference_1822 = {1'b0, sum_1820, smooth[0]} - {1'b0, sum_1821, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:468
  logic or_1828;
  assign or_1828 = (((patches_column_s2_q == 5'ha) | of_row) | equal_1800) | equal_1798;
  // hls/stages/patches.hpp:463
  logic and_1833;
  assign and_1833 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:176
  logic and_1837;
  assign and_1837 = not_1693_s2_q & (or_1696_s2_q & (or_1828 & (equal_1695_s2_q & and_1833)));
  // hls/stages/patches.hpp:164
  logic and_1847;
  assign and_1847 = (~(equal_1695_s2_q | (~and_1833))) & (~patches_column_s2_q[4]);
  // hls/stages/patches.hpp:176
  logic and_1851;
  assign and_1851 = not_1693_s2_q & (or_1696_s2_q & (and_1847 & (patches_column_s2_q == 5'hf)));
  // hls/stages/patches.hpp:532
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
  // hls/stages/patches.hpp:546
  logic select_1860;
  assign select_1860 = equal_1856 ? (less_1853 & (less_1853 & not_1857)) : less_1853;
  // hls/stages/patches.hpp:176
  logic and_1863;
  assign and_1863 = equal_1690_s2_q & (less_1853 ? (not_1855 & select_1860) : select_1860);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1892;
  assign sum_1892 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:227
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
  // hls/stages/agreement.hpp:735
  logic less_2404;
  assign less_2404 = select_1431 < select_1412;
  // hls/stages/agreement.hpp:227
  logic [6:0] select_2406;
  assign select_2406 = slot_s2_q[0] ? 7'h0 : sum_1442;
  // hls/stages/registration.hpp:76
  logic less_2495;
  assign less_2495 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2497;
  assign select_2497 = or_529_s2_q ? (less_536_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2499;
  assign select_2499 = or_529_s2_q ? (less_536_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2501;
  assign select_2501 = or_529_s2_q ? (less_536_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2499} - {1'b0, select_2501};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2503;
  assign select_2503 = rise[8] ? select_2499 : select_2501;
  logic [8:0] difference_2504;
  assign difference_2504 = {1'b0, select_2497} - {1'b0, select_2503};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2504[8] ? 8'h0 : difference_2504[7:0];
  // hls/stages/registration.hpp:37
  logic not_2506;
  assign not_2506 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2495 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2506};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2508;
  assign xor_2508 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2508};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2514;
  assign select_2514 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2495 ? {taken, 1'b1} : {not_2506, select_2514, not_2506};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2516;
  assign sum_2516 = {left, 1'b1} + {taken_2, less_2495};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2518;
  assign select_2518 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_2601;
  assign select_2601 = and_2600_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2603;
  assign select_2603 = and_2598_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2601[15]}}, select_2601});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2604;
  assign select_2604 = and_2600_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2604[15]}}, select_2604};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2606;
  assign select_2606 = and_2598_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_2607;
  assign and_2607 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2607 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:179
  logic select_2852;
  assign select_2852 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:176
  logic [11:0] select_2855;
  assign select_2855 = equal_1692_s2_q ? patches_smooth_values_0_q : (or_1696_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_2857;
  assign select_2857 = or_1696_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2859;
  assign select_2859 = equal_1690_s2_q ? patches_smooth_values_1_q : (equal_1692_s2_q ? patches_smooth_values_1_q : select_2857);
  logic [11:0] select_2860;
  assign select_2860 = or_1696_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2862;
  assign select_2862 = equal_1690_s2_q ? patches_smooth_values_2_q : (equal_1692_s2_q ? patches_smooth_values_2_q : select_2860);
  logic [11:0] select_2863;
  assign select_2863 = or_1696_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2865;
  assign select_2865 = equal_1690_s2_q ? patches_smooth_values_3_q : (equal_1692_s2_q ? patches_smooth_values_3_q : select_2863);
  logic [10:0] select_2867;
  assign select_2867 = equal_1692_s2_q ? patches_down_values_0_q : (or_1696_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_2870;
  assign select_2870 = equal_1692_s2_q ? patches_down_values_1_q : (or_1696_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_2873;
  assign select_2873 = equal_1692_s2_q ? patches_down_values_2_q : (or_1696_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_2876;
  assign select_2876 = equal_1692_s2_q ? patches_down_values_3_q : (or_1696_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:167
  logic and_2913;
  assign and_2913 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:403
  logic [4:0] select_2918;
  assign select_2918 = or_2813_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:405
  logic [3:0] select_2920;
  assign select_2920 = and_2913 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:176
  logic [4:0] select_3276;
  assign select_3276 = equal_1690_s2_q ? patches_summed_down_by_q : (equal_1692_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:542
  logic and_3309;
  assign and_3309 = less_1853 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:546
  logic select_3312;
  assign select_3312 = equal_1856 ? (less_1853 ? (not_1857 & and_3309) : and_3309) : and_3309;
  // hls/stages/patches.hpp:176
  logic select_3315;
  assign select_3315 = equal_1690_s2_q ? (less_1853 ? (not_1855 & select_3312) : select_3312) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3631;
  assign select_3631 = so_s2_q ? (and_2607 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3633;
  assign sum_3633 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3634;
  assign select_3634 = sum_1892[5] ? {1'b1, sum_1892[4:0], region_across_rest_q[2:0]} : sum_3633;
  // hls/stages/agreement.hpp:447
  logic [7:0] select_3636;
  assign select_3636 = equal_2295_s2_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3639;
  assign select_3639 = equal_2295_s2_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_478_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_483;
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
  assign census_memory_re = s2_en & and_508_s2_q;
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
  assign shown_right_re = s2_en & and_1512;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:789; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
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
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1458, select_1457, select_1439, select_1435, select_1424, select_1423, select_1418};
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
      chosen_score_q <= less_2404 ? select_1412 : select_1431;
      chosen_near_q <= (select_2406 < select_1451) ? select_1451 : select_2406;
      chosen_place_q <= less_2404 ? {select_1420, not_1419} : 3'h2;
      before_0_q <= select_1431;
      before_1_q <= sum_1162;
      before_2_q <= sum_1410;
      registration_displacement_over_q <= so_s2_q ? sum_2516[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2518;
      registration_slope_row_q <= select_2603;
      registration_slope_change_q <= select_2606;
      registration_slope_q <= so_s2_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_2837_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2837_s2_q & select_2852;
      patches_smooth_values_0_q <= equal_1690_s2_q ? patches_smooth_values_0_q : select_2855;
      patches_smooth_values_1_q <= select_2859;
      patches_smooth_values_2_q <= select_2862;
      patches_smooth_values_3_q <= select_2865;
      patches_down_values_0_q <= equal_1690_s2_q ? patches_down_values_0_q : select_2867;
      patches_down_values_1_q <= equal_1690_s2_q ? patches_down_values_1_q : select_2870;
      patches_down_values_2_q <= equal_1690_s2_q ? patches_down_values_2_q : select_2873;
      patches_down_values_3_q <= equal_1690_s2_q ? patches_down_values_3_q : select_2876;
      patches_down_by_q <= or_2813_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2913});
      patches_along_q <= select_2918;
      patches_match_row_q <= or_2813_s2_q ? 4'h0 : select_2920;
      patches_summed_last_q <= not_1691_s2_q & (equal_1692_s2_q & and_2913);
      patches_summed_down_by_q <= select_3276;
      patches_step_q <= or_2813_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3315;
      region_across_rest_q <= select_3631;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3634;
      columns_begin_rest_q <= and_508_s2_q ? select_3636 : columns_begin_rest_q;
      columns_begin_back_q <= and_508_s2_q ? select_3639 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_912;
      sums_0_sum_sums_values_0_q <= sum_1162;
      sums_0_sum_sums_values_1_q <= equal_1160 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1410;
      sums_1_sum_sums_values_1_q <= equal_1160 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [2:0] select_472_s3_q;
  logic [5:0] select_474_s3_q;
  logic [7:0] select_478_s3_q;
  logic and_482_s3_q;
  logic and_483_s3_q;
  logic equal_488_s3_q;
  logic [5:0] column_s3_q;
  logic and_506_s3_q;
  logic and_508_s3_q;
  logic so_s3_q;
  logic equal_569_s3_q;
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
  logic less_2532_s3_q;
  logic less_2889_s3_q;
  logic equal_3232_s3_q;
  logic equal_3316_s3_q;
  logic less_3619_s3_q;
  logic equal_3824_s3_q;
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
      select_472_s3_q <= select_472_s2_q;
      select_474_s3_q <= select_474_s2_q;
      select_478_s3_q <= select_478_s2_q;
      and_482_s3_q <= and_482_s2_q;
      and_483_s3_q <= and_483;
      equal_488_s3_q <= equal_488_s2_q;
      column_s3_q <= column_s2_q;
      and_506_s3_q <= and_506_s2_q;
      and_508_s3_q <= and_508_s2_q;
      so_s3_q <= so_s2_q;
      equal_569_s3_q <= equal_569_s2_q;
      equal_1477_s3_q <= equal_1477_s2_q;
      not_1478_s3_q <= not_1478;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1512_s3_q <= and_1512;
      select_1516_s3_q <= select_1516_s2_q;
      and_1521_s3_q <= not_1478 & (so_s2_q ? and_1510 : (equal_528_s2_q & shift_2[4]));
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
      less_2532_s3_q <= select_2499 < select_2501;
      less_2889_s3_q <= 4'he < patches_column_s2_q[4:1];
      equal_3232_s3_q <= patches_match_row_q == 4'h0;
      equal_3316_s3_q <= patches_step_q[6:5] == 2'h2;
      less_3619_s3_q <= less_3619_s2_q;
      equal_3824_s3_q <= equal_3824_s2_q;
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
  logic [11:0] select_486;
  assign select_486 = select_472_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_490;
  assign sum_490 = select_486 + (equal_488_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_492;
  assign sum_492 = {4'h0, sample_pair_pixel_1_q} + (select_472_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_494;
  assign sum_494 = sum_492 + (equal_488_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = select_472_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_498;
  assign and_498 = whole & (averager_memory_rdata_q[24] | equal_488_s3_q);
  // hls/stages/agreement.hpp:404
  logic all_of_skin;
  assign all_of_skin = select_472_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_502;
  assign and_502 = all_of_skin & (averager_memory_rdata_q[25] | equal_488_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_482_s3_q ? sum_490[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_511;
  assign equal_511 = select_472_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_511 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_514;
  assign select_514 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_482_s3_q ? sum_494[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_511 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_518;
  assign select_518 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_519;
  assign and_519 = and_482_s3_q & and_498;
  // hls/stages/census.hpp:126
  logic select_521;
  assign select_521 = equal_511 ? and_519 : (averager_mask_q & and_519);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_521;
  // hls/stages/census.hpp:206
  logic and_523;
  assign and_523 = and_482_s3_q & and_502;
  // hls/stages/census.hpp:126
  logic select_525;
  assign select_525 = equal_511 ? and_523 : (averager_of_skin_q & and_523);
  // hls/stages/agreement.hpp:263
  logic and_526;
  assign and_526 = sample_pair_whole_s3_q & select_525;
  // hls/stages/census.hpp:294
  logic less_542;
  assign less_542 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_543;
  assign less_543 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_544;
  assign less_544 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_545;
  assign less_545 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_546;
  assign less_546 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_547;
  assign less_547 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_548;
  assign less_548 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_549;
  assign less_549 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_550;
  assign less_550 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_551;
  assign less_551 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_552;
  assign less_552 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_553;
  assign less_553 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_554;
  assign less_554 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_555;
  assign less_555 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_556;
  assign less_556 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_557;
  assign less_557 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_558;
  assign less_558 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_559;
  assign less_559 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_560;
  assign less_560 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_561;
  assign less_561 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_562;
  assign less_562 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_563;
  assign less_563 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_564;
  assign less_564 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_565;
  assign less_565 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:442
  logic equal_566;
  assign equal_566 = column_s3_q == 6'h0;
  logic [3:0] select_570;
  assign select_570 = equal_569_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_571;
  assign select_571 = equal_566 ? {select_570, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_572;
  assign select_572 = equal_566 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_573;
  assign and_573 = select_571[4] & select_572[3];
  // hls/stages/census.hpp:286
  logic and_575;
  assign and_575 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_577;
  assign and_577 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_575);
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_577;
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
  logic [9:0] difference_600;
  assign difference_600 = {1'b0, select_514} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_601;
  assign xor_601 = difference_600[8:0] ^ {9{difference_600[9]}};
  logic [9:0] sum_602;
  assign sum_602 = {9'h0, difference_600[9]} + {1'b0, xor_601};
  logic [9:0] difference_603;
  assign difference_603 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_604;
  assign xor_604 = difference_603[8:0] ^ {9{difference_603[9]}};
  logic [9:0] sum_605;
  assign sum_605 = {9'h0, difference_603[9]} + {1'b0, xor_604};
  logic [9:0] difference_607;
  assign difference_607 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_608;
  assign xor_608 = difference_607[8:0] ^ {9{difference_607[9]}};
  logic [9:0] sum_609;
  assign sum_609 = {9'h0, difference_607[9]} + {1'b0, xor_608};
  logic [10:0] sum_610;
  assign sum_610 = ({1'b0, sum_602} + {1'b0, sum_605}) + {1'b0, sum_609};
  logic [9:0] difference_611;
  assign difference_611 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_612;
  assign xor_612 = difference_611[8:0] ^ {9{difference_611[9]}};
  logic [9:0] sum_613;
  assign sum_613 = {9'h0, difference_611[9]} + {1'b0, xor_612};
  logic [9:0] difference_615;
  assign difference_615 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_616;
  assign xor_616 = difference_615[8:0] ^ {9{difference_615[9]}};
  // hls/stages/agreement.hpp:193
  logic not_1517;
  assign not_1517 = ~so_s3_q;
  // hls/stages/patches.hpp:330
  logic and_1518;
  assign and_1518 = not_1517 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1070
  logic equal_1522;
  assign equal_1522 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1525;
  assign select_1525 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1084
  logic [3:0] select_1527;
  assign select_1527 = equal_1522 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1525});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1528;
  assign sum_1528 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:330
  logic [3:0] select_1529;
  assign select_1529 = equal_1477_s3_q ? select_1527 : {sum_1528, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:201
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
  // hls/stages/agreement.hpp:1116
  logic and_1548;
  assign and_1548 = (~equal_1538) & ((~equal_1540) & ((~equal_1542) & (~equal_1544)));
  logic and_1552;
  assign and_1552 = (~equal_1530) & ((~equal_1532) & ((~equal_1534) & ((~equal_1536) & and_1548)));
  // hls/stages/agreement.hpp:1071
  logic less_1553;
  assign less_1553 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1557;
  assign or_1557 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:955
  logic [4:0] sum_1562;
  assign sum_1562 = {1'b0, last_s3_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:250
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
  // hls/stages/patches.hpp:330
  logic and_1571;
  assign and_1571 = so_s3_q & and_1570;
  logic select_1572;
  assign select_1572 = equal_1477_s3_q ? (x_s3_q[6] & (equal_1522 ? and_1552 : (less_1553 & (~or_1557)))) : and_1571;
  // hls/stages/registration.hpp:258
  logic not_1574;
  assign not_1574 = ~lower_half_s3_q;
  logic [3:0] select_1575;
  assign select_1575 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_1574, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_1574};
  // hls/stages/patches.hpp:363
  logic [1:0] select_1604;
  assign select_1604 = and_1603_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1605;
  assign select_1605 = and_1603_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_1606;
  assign select_1606 = and_1590_s3_q ? {select_1605, select_1604[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:118
  logic [1:0] select_1607;
  assign select_1607 = and_1590_s3_q ? select_1604 : patches_fetch_q;
  logic equal_1608;
  assign equal_1608 = select_1607 == 2'h0;
  // hls/stages/patches.hpp:95
  logic right_3;
  assign right_3 = {3'h0, last_s3_q[5:1]} < x_s3_q;
  // hls/stages/patches.hpp:330
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
  // hls/stages/patches.hpp:90
  logic [9:0] sum_1636;
  assign sum_1636 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:964
  logic and_1638;
  assign and_1638 = shift_2_s3_q[3] & ({{4{sum_1636[9]}}, sum_1636, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:96
  logic and_1643;
  assign and_1643 = ({4'h0, last_s3_q[5:1]} < ({1'b0, x_s3_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:98
  logic equal_1644;
  assign equal_1644 = x_s3_q == 8'h0;
  // hls/stages/patches.hpp:94
  logic [9:0] sum_1650;
  assign sum_1650 = {2'h0, x_s3_q} + {{4{shift_2_s3_q[10]}}, shift_2_s3_q[10:5]};
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1652;
  assign sum_1652 = {sum_1650[9], sum_1650[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:964
  logic and_1655;
  assign and_1655 = ($signed(9'h0) < $signed(sum_1650[9:1])) & (~($signed({5'h0, last_s3_q}) < $signed({sum_1652, sum_1650[0]})));
  logic and_1656;
  assign and_1656 = (~(and_1643 | (equal_1644 | (~(x_s3_q < {2'h0, last_s3_q}))))) & and_1655;
  // hls/stages/patches.hpp:330
  logic and_1659;
  assign and_1659 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_1617_s3_q & and_1638) & and_1656));
  logic and_1661;
  assign and_1661 = not_1478_s3_q & (so_s3_q & and_1659);
  // hls/stages/patches.hpp:148
  logic and_1663;
  assign and_1663 = and_1661 & (~patches_fixed_q);
  // hls/stages/patches.hpp:330
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
  // hls/stages/patches.hpp:330
  logic [7:0] select_1680;
  assign select_1680 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_1681;
  assign select_1681 = equal_1477_s3_q ? 8'h0 : select_1680;
  // hls/stages/patches.hpp:333
  logic [21:0] select_1682;
  assign select_1682 = and_1663 ? {select_1681, select_1671, select_1667, and_1661} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:105
  logic equal_1683;
  assign equal_1683 = x_s3_q == {2'h0, last_s3_q};
  // hls/stages/patches.hpp:330
  logic and_1687;
  assign and_1687 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (and_1643 | equal_1683)));
  logic and_1688;
  assign and_1688 = not_1478_s3_q & and_1687;
  // hls/stages/patches.hpp:334
  logic and_1689;
  assign and_1689 = patches_chooses_s3_q & and_1688;
  // hls/stages/patches.hpp:118
  logic [4:0] select_1703;
  assign select_1703 = and_1590_s3_q ? select_1605 : patches_band_q;
  // hls/stages/patches.hpp:343
  logic equal_1704;
  assign equal_1704 = {patches_choosing_band_s3_q, and_1616} == {select_1703, select_1607[1]};
  // hls/stages/patches.hpp:472
  logic [2:0] sum_1804;
  assign sum_1804 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:476
  logic [1:0] sum_1842;
  assign sum_1842 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_1879;
  assign select_1879 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_1882;
  assign or_1882 = select_1879[7] | (~({select_1879[5], select_1879[3], select_1879[1]} == 3'h0));
  // hls/stages/agreement.hpp:991
  logic or_1885;
  assign or_1885 = select_1879[7] | (~({select_1879[6], select_1879[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:990
  logic or_1888;
  assign or_1888 = select_1879[7] | (~(select_1879[6:4] == 3'h0));
  // hls/stages/patches.hpp:330
  logic [5:0] select_1889;
  assign select_1889 = equal_1477_s3_q ? x_s3_q[5:0] : {region_row_q, or_1888, or_1885, or_1882};
  // hls/stages/agreement.hpp:1070
  logic not_1890;
  assign not_1890 = ~equal_1522;
  // hls/stages/agreement.hpp:1000
  logic or_1894;
  assign or_1894 = (~sum_1892_s3_q) | equal_1683;
  // hls/stages/patches.hpp:330
  logic and_1897;
  assign and_1897 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_1894));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_1918;
  assign and_1918 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:960
  logic select_1919;
  assign select_1919 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_1919);
  // hls/stages/agreement.hpp:960
  logic select_1922;
  assign select_1922 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_1919 ? select_1922 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1198
  logic select_1925;
  assign select_1925 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1202
  logic select_1926;
  assign select_1926 = left_first_s3_q ? select_1925 : read_half_q;
  logic or_1927;
  assign or_1927 = left_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1203
  logic [8:0] select_1928;
  assign select_1928 = or_1927 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1204
  logic [9:0] select_1930;
  assign select_1930 = left_first_s3_q ? 10'h1 : (or_1927 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1207
  logic and_1931;
  assign and_1931 = select_1928[8] & select_1930[9];
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = and_1931 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1218
  logic [5:0] select_1934;
  assign select_1934 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1936;
  assign select_1936 = left_first_s3_q ? 11'h0 : (seen_base_q + {5'h0, select_1934});
  // hls/stages/agreement.hpp:1228
  logic equal_1937;
  assign equal_1937 = seen_x_q == 3'h7;
  logic [7:0] select_1939;
  assign select_1939 = and_1931 ? 8'h0 : (seen_column_q + {7'h0, equal_1937});
  // hls/stages/agreement.hpp:1235
  logic [10:0] index;
  assign index = select_1936 + {3'h0, select_1939};
  // hls/stages/agreement.hpp:1188
  logic [11:0] sum_1941;
  assign sum_1941 = {1'b0, {2{select_1926}}, 2'h0, {2{select_1926}}, 1'b0, {2{select_1926}}, 1'b0, select_1926} + {1'b0, index};
  // hls/stages/agreement.hpp:1201
  logic not_1942;
  assign not_1942 = ~left_first_s3_q;
  // hls/stages/agreement.hpp:422
  logic and_1944;
  assign and_1944 = not_1942 & (began_q | and_1931);
  // hls/stages/agreement.hpp:1229
  logic [2:0] select_1946;
  assign select_1946 = and_1931 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1234
  logic and_1948;
  assign and_1948 = and_1944 & (select_1946 == 3'h0);
  logic less_1949;
  assign less_1949 = select_1939 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:424
  logic and_1950;
  assign and_1950 = and_1948 & less_1949;
  logic and_1951;
  assign and_1951 = and_1871_s3_q & and_1950;
  // hls/stages/agreement.hpp:265
  logic select_1953;
  assign select_1953 = and_1871_s3_q ? (left_first_s3_q ? and_1950 : and_1951) : and_1951;
  // hls/stages/agreement.hpp:1053
  logic [7:0] sum_1955;
  assign sum_1955 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1955[7], sum_1955, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1188
  logic [11:0] sum_1957;
  assign sum_1957 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:976
  logic and_1958;
  assign and_1958 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_1959;
  assign and_1959 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_1960;
  assign and_1960 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_1961;
  assign and_1961 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_1963;
  assign sum_1963 = {1'b0, and_1960} + ({1'b0, textured_s3_q} + {1'b0, and_1961});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1958} + ({2'h0, and_1959} + {1'b0, sum_1963});
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_1966;
  assign select_1966 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1967;
  assign difference_1967 = {1'b0, textured_2} - {1'b0, select_1966};
  logic [4:0] t;
  assign t = {difference_1967[3], difference_1967} + (equal_1644 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_1972;
  assign select_1972 = shift_2_s3_q[0] ? (sum_1892_s3_q ? select_1879 : {select_1879[6:0], 1'b0}) : select_1879;
  // hls/stages/agreement.hpp:992
  logic or_1975;
  assign or_1975 = select_1972[7] | (~({select_1972[5], select_1972[3], select_1972[1]} == 3'h0));
  // hls/stages/agreement.hpp:976
  logic and_1992;
  assign and_1992 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_1993;
  assign and_1993 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_1994;
  assign and_1994 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_1995;
  assign and_1995 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_1997;
  assign sum_1997 = {1'b0, and_1994} + ({1'b0, shown} + {1'b0, and_1995});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_1992} + ({2'h0, and_1993} + {1'b0, sum_1997});
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_2000;
  assign select_2000 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2001;
  assign difference_2001 = {1'b0, shown_2} - {1'b0, select_2000};
  logic [4:0] around;
  assign around = {difference_2001[3], difference_2001} + (equal_1644 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_2004;
  assign sum_2004 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:976
  logic and_2008;
  assign and_2008 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2009;
  assign and_2009 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2010;
  assign and_2010 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2011;
  assign and_2011 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_2013;
  assign sum_2013 = {1'b0, and_2010} + ({1'b0, near} + {1'b0, and_2011});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2008} + ({2'h0, and_2009} + {1'b0, sum_2013});
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_2016;
  assign select_2016 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2017;
  assign difference_2017 = {1'b0, near_2} - {1'b0, select_2016};
  logic [4:0] n;
  assign n = {difference_2017[3], difference_2017} + (equal_1644 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/patches.hpp:330
  logic and_2029;
  assign and_2029 = ends_cell_s3_q & (and_2025_s3_q & (~({1'b0, sum_1562, last_s3_q[1:0]} < x_s3_q)));
  logic and_2031;
  assign and_2031 = not_1478_s3_q & (so_s3_q & and_2029);
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2063;
  assign select_2063 = sample_pair_whole_s3_q ? (and_506_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2065;
  assign select_2065 = sample_pair_whole_s3_q ? (and_506_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2084;
  assign select_2084 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2086;
  assign select_2086 = sample_pair_whole_s3_q ? (and_506_s3_q ? select_521 : averager_mask_q) : averager_mask_q;
  logic select_2088;
  assign select_2088 = sample_pair_whole_s3_q ? (and_506_s3_q ? select_525 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2089;
  assign select_2089 = and_508_s3_q ? select_514 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2090;
  assign select_2090 = and_508_s3_q ? select_518 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2092;
  assign select_2092 = and_508_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2093;
  assign select_2093 = and_508_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2094;
  assign select_2094 = and_508_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2095;
  assign select_2095 = and_508_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2096;
  assign select_2096 = and_508_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2097;
  assign select_2097 = and_508_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2098;
  assign select_2098 = and_508_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2099;
  assign select_2099 = and_508_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2100;
  assign select_2100 = and_508_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2101;
  assign select_2101 = and_508_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2102;
  assign select_2102 = and_508_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2103;
  assign select_2103 = and_508_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2104;
  assign select_2104 = and_508_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2105;
  assign select_2105 = and_508_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2106;
  assign select_2106 = and_508_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2107;
  assign select_2107 = and_508_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2108;
  assign select_2108 = and_508_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2109;
  assign select_2109 = and_508_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2110;
  assign select_2110 = and_508_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2111;
  assign select_2111 = and_508_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2112;
  assign select_2112 = and_508_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2113;
  assign select_2113 = and_508_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2114;
  assign select_2114 = and_508_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2115;
  assign select_2115 = and_508_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2116;
  assign select_2116 = and_508_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2117;
  assign select_2117 = and_508_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2118;
  assign select_2118 = and_508_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2119;
  assign select_2119 = and_508_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2120;
  assign select_2120 = and_508_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2121;
  assign select_2121 = and_508_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2122;
  assign select_2122 = and_508_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2123;
  assign select_2123 = and_508_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2124;
  assign select_2124 = and_508_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2125;
  assign select_2125 = and_508_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2126;
  assign select_2126 = and_508_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2127;
  assign select_2127 = and_508_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2128;
  assign select_2128 = and_508_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2129;
  assign select_2129 = and_508_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2130;
  assign select_2130 = and_508_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2131;
  assign select_2131 = and_508_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2132;
  assign select_2132 = and_508_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2133;
  assign select_2133 = and_508_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2134;
  assign select_2134 = and_508_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2135;
  assign select_2135 = and_508_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2136;
  assign select_2136 = and_508_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2137;
  assign select_2137 = and_508_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2138;
  assign select_2138 = and_508_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2139;
  assign select_2139 = and_508_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2140;
  assign select_2140 = and_508_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2141;
  assign select_2141 = and_508_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2142;
  assign select_2142 = and_508_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2143;
  assign select_2143 = and_508_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2144;
  assign select_2144 = and_508_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2146;
  assign difference_2146 = {1'b0, select_518} - {1'b0, census_columns_values_0_cell_0_right_q};
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
  assign difference_2192 = {1'b0, select_514} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2192[9]} + (difference_2192[8:0] ^ {9{difference_2192[9]}});
  logic [9:0] difference_2204;
  assign difference_2204 = {1'b0, select_518} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2204[9]} + (difference_2204[8:0] ^ {9{difference_2204[9]}});
  // hls/stages/agreement.hpp:507
  logic and_2411;
  assign and_2411 = and_508_s3_q & (equal_569_s3_q & equal_2295_s3_q);
  // hls/stages/patches.hpp:330
  logic and_2415;
  assign and_2415 = not_1478_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:976
  logic and_2435;
  assign and_2435 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2436;
  assign and_2436 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2437;
  assign and_2437 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2438;
  assign and_2438 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2440;
  assign sum_2440 = {1'b0, and_2437} + ({1'b0, explained} + {1'b0, and_2438});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2435} + ({2'h0, and_2436} + {1'b0, sum_2440});
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2443;
  assign select_2443 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2444;
  assign difference_2444 = {1'b0, explained_2} - {1'b0, select_2443};
  logic [4:0] e;
  assign e = {difference_2444[3], difference_2444} + (equal_1644 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2447;
  assign sum_2447 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/patches.hpp:330
  logic and_2476;
  assign and_2476 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2520;
  assign select_2520 = equal_1477_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2522;
  assign select_2522 = equal_1477_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2523;
  assign equal_2523 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:250
  logic and_2527;
  assign and_2527 = shift_2_s3_q[3] & less_1617_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2531;
  assign sum_2531 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2533;
  assign difference_2533 = {sum_2531, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2534;
  assign select_2534 = less_2532_s3_q ? difference_2533 : {sum_2531, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2535;
  assign select_2535 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2531, shift_2_s3_q[11], 5'h0} : select_2534;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2535[7]}}, select_2535} - {sum_1634[9], sum_1634, sum_1630[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2538;
  assign select_2538 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2538[11:7])) ? 12'h7f : select_2538;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2559;
  assign difference_2559 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2561;
  assign and_2561 = and_2527 & ($signed(difference_2559) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2574;
  assign less_2574 = $signed(difference_2559) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:330
  logic select_2582;
  assign select_2582 = so_s3_q ? (equal_2523 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2585;
  assign select_2585 = so_s3_q ? (equal_1618 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2590;
  assign select_2590 = (sum_1528 == 2'h2) ? (registration_fresh_q & (~select_1575)) : registration_fresh_q;
  // hls/stages/patches.hpp:330
  logic [3:0] select_2592;
  assign select_2592 = so_s3_q ? (and_1570 ? select_2590 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2594;
  assign select_2594 = and_2411 ? 4'hf : (equal_1477_s3_q ? registration_fresh_q : select_2592);
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1525;
  // hls/stages/registration.hpp:258
  logic not_2615;
  assign not_2615 = ~quarter_2[1];
  logic [3:0] select_2616;
  assign select_2616 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2615, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2615};
  // hls/stages/patches.hpp:83
  logic parity_2750;
  assign parity_2750 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_2751;
  assign select_2751 = equal_2295_s3_q ? {patches_chance_q[14:0], parity_2750} : patches_chance_q;
  // hls/stages/patches.hpp:335
  logic not_2753;
  assign not_2753 = ~and_1688;
  // hls/stages/patches.hpp:100
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:102
  logic [4:0] select_2755;
  assign select_2755 = right_3 ? last_s3_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2755};
  // hls/stages/patches.hpp:330
  logic and_2761;
  assign and_2761 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (~(x_s3_q < {2'h0, from}))));
  // hls/stages/patches.hpp:148
  logic and_2765;
  assign and_2765 = not_2753 & (patches_fixed_q | ((not_1478_s3_q & and_2761) & and_1663));
  // hls/stages/patches.hpp:344
  logic not_2778;
  assign not_2778 = ~select_1607[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_2780;
  assign select_2780 = sample_pair_whole_s3_q ? (equal_1608 ? select_1607 : {not_2778, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:508
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:176
  logic [51:0] select_2879;
  assign select_2879 = or_1696_s3_q ? {less_1824_s3_q, less_1823_s3_q, less_1814_s3_q, less_1813_s3_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2881;
  assign select_2881 = equal_1690_s3_q ? patches_codes_at_q : (equal_1692_s3_q ? other[55:4] : select_2879);
  // hls/stages/patches.hpp:491
  logic [27:0] word;
  assign word = or_1796_s3_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:507
  logic [27:0] select_2884;
  assign select_2884 = (patches_along_s3_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:176
  logic [27:0] select_2886;
  assign select_2886 = equal_1692_s3_q ? (new_row_s3_q ? word : select_2884) : patches_codes_further_q;
  // hls/stages/patches.hpp:509
  logic [55:0] select_2888;
  assign select_2888 = less_1783_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:479
  logic [55:0] select_2890;
  assign select_2890 = less_2889_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:176
  logic [55:0] select_2892;
  assign select_2892 = or_1696_s3_q ? (equal_1695_s3_q ? patches_next_codes_q : select_2890) : patches_next_codes_q;
  logic [55:0] select_2894;
  assign select_2894 = equal_1690_s3_q ? patches_next_codes_q : (equal_1692_s3_q ? select_2888 : select_2892);
  // hls/stages/count_bits.hpp:24
  logic parity_2899;
  assign parity_2899 = ^{less_1824_s3_q, less_1823_s3_q, less_1814_s3_q, less_1813_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_2903;
  assign or_2903 = ({less_1814_s3_q, less_1813_s3_q} == 2'h3) | (less_1823_s3_q & (less_1814_s3_q | less_1813_s3_q));
  logic and_2904;
  assign and_2904 = less_1824_s3_q & (^{less_1823_s3_q, less_1814_s3_q, less_1813_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2905;
  assign xor_2905 = or_2903 ^ and_2904;
  // hls/stages/count_bits.hpp:27
  logic and_2906;
  assign and_2906 = or_2903 & and_2904;
  // hls/stages/patches.hpp:176
  logic [2:0] select_2908;
  assign select_2908 = or_1696_s3_q ? (and_1847_s3_q ? {and_2906, xor_2905, parity_2899} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:159
  logic [9:0] sum_2912;
  assign sum_2912 = {7'h0, patches_set_q} + (equal_1695_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:508
  logic [47:0] select_2922;
  assign select_2922 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:176
  logic [47:0] select_2924;
  assign select_2924 = equal_1690_s3_q ? patches_left_row_q : (equal_1692_s3_q ? select_2922 : patches_left_row_q);
  // hls/stages/patches.hpp:510
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2922;
  // hls/stages/count_bits.hpp:24
  logic xor_2928;
  assign xor_2928 = bits[17] ^ (^{select_2922[16:15], other[16:15]});
  logic xor_2931;
  assign xor_2931 = bits[11] ^ (^{select_2922[10:9], other[10:9]});
  logic xor_2934;
  assign xor_2934 = bits[14] ^ (^{select_2922[13:12], other[13:12]});
  logic xor_2937;
  assign xor_2937 = xor_2928 ^ (^{select_2922[14:9], other[14:9]});
  logic xor_2940;
  assign xor_2940 = bits[47] ^ (^{select_2922[46:45], other[46:45]});
  logic xor_2943;
  assign xor_2943 = bits[8] ^ (^{select_2922[7:6], other[7:6]});
  logic xor_2946;
  assign xor_2946 = bits[2] ^ (^{select_2922[1:0], other[1:0]});
  logic xor_2949;
  assign xor_2949 = bits[5] ^ (^{select_2922[4:3], other[4:3]});
  logic xor_2952;
  assign xor_2952 = xor_2943 ^ (^{select_2922[5:0], other[5:0]});
  logic parity_2954;
  assign parity_2954 = ^{select_2922[47:45], select_2922[8:0], other[47:45], other[8:0]};
  logic xor_2955;
  assign xor_2955 = xor_2937 ^ parity_2954;
  logic xor_2958;
  assign xor_2958 = bits[44] ^ (^{select_2922[43:42], other[43:42]});
  logic xor_2961;
  assign xor_2961 = bits[38] ^ (^{select_2922[37:36], other[37:36]});
  logic xor_2964;
  assign xor_2964 = bits[41] ^ (^{select_2922[40:39], other[40:39]});
  logic xor_2970;
  assign xor_2970 = bits[26] ^ (^{select_2922[25:24], other[25:24]});
  logic xor_2973;
  assign xor_2973 = bits[20] ^ (^{select_2922[19:18], other[19:18]});
  logic xor_2976;
  assign xor_2976 = bits[23] ^ (^{select_2922[22:21], other[22:21]});
  logic xor_2979;
  assign xor_2979 = xor_2970 ^ (^{select_2922[23:18], other[23:18]});
  logic xor_2982;
  assign xor_2982 = bits[35] ^ (^{select_2922[34:33], other[34:33]});
  logic xor_2985;
  assign xor_2985 = bits[29] ^ (^{select_2922[28:27], other[28:27]});
  logic xor_2988;
  assign xor_2988 = bits[32] ^ (^{select_2922[31:30], other[31:30]});
  logic xor_2991;
  assign xor_2991 = xor_2982 ^ (^{select_2922[32:27], other[32:27]});
  logic xor_2992;
  assign xor_2992 = xor_2979 ^ xor_2991;
  // hls/stages/count_bits.hpp:25
  logic or_3000;
  assign or_3000 = (xor_2931 & xor_2934) | (xor_2928 & (xor_2931 | xor_2934));
  logic or_3004;
  assign or_3004 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3008;
  assign or_3008 = (xor_2946 & xor_2949) | (xor_2943 & (xor_2946 | xor_2949));
  // hls/stages/count_bits.hpp:23
  logic or_3015;
  assign or_3015 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3019;
  assign or_3019 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3023;
  assign or_3023 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3026;
  assign parity_3026 = ^{or_3023, or_3019, or_3015};
  // hls/stages/count_bits.hpp:23
  logic or_3030;
  assign or_3030 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3034;
  assign or_3034 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3038;
  assign or_3038 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3041;
  assign parity_3041 = ^{or_3038, or_3034, or_3030};
  logic parity_3044;
  assign parity_3044 = ^{or_3038, or_3034, or_3030, or_3023, or_3019, or_3015, or_3008, or_3004, or_3000};
  // hls/stages/count_bits.hpp:23
  logic or_3048;
  assign or_3048 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3052;
  assign or_3052 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3056;
  assign or_3056 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3064;
  assign or_3064 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3068;
  assign or_3068 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3072;
  assign or_3072 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3075;
  assign parity_3075 = ^{or_3072, or_3068, or_3064};
  // hls/stages/count_bits.hpp:23
  logic or_3079;
  assign or_3079 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3083;
  assign or_3083 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3087;
  assign or_3087 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3090;
  assign parity_3090 = ^{or_3087, or_3083, or_3079};
  logic parity_3093;
  assign parity_3093 = ^{or_3087, or_3083, or_3079, or_3072, or_3068, or_3064, or_3056, or_3052, or_3048};
  // hls/stages/count_bits.hpp:25
  logic or_3097;
  assign or_3097 = (xor_2961 & xor_2964) | (xor_2958 & (xor_2961 | xor_2964));
  logic or_3101;
  assign or_3101 = (xor_2973 & xor_2976) | (xor_2970 & (xor_2973 | xor_2976));
  logic or_3105;
  assign or_3105 = (xor_2985 & xor_2988) | (xor_2982 & (xor_2985 | xor_2988));
  // hls/stages/count_bits.hpp:24
  logic parity_3108;
  assign parity_3108 = ^{or_3105, or_3101, or_3097};
  // hls/stages/count_bits.hpp:25
  logic and_3109;
  assign and_3109 = xor_2955 & (^{xor_2992, select_2922[44:36], other[44:36]});
  logic or_3113;
  assign or_3113 = (xor_2940 & xor_2952) | (xor_2937 & (xor_2940 | xor_2952));
  logic and_3116;
  assign and_3116 = (xor_2958 ^ (^{select_2922[41:36], other[41:36]})) & (xor_2979 | xor_2991);
  logic or_3117;
  assign or_3117 = (xor_2979 & xor_2991) | and_3116;
  // hls/stages/count_bits.hpp:24
  logic parity_3120;
  assign parity_3120 = ^{or_3117, or_3113, and_3109};
  logic parity_3123;
  assign parity_3123 = ^{or_3117, or_3113, and_3109, or_3105, or_3101, or_3097, or_3087, or_3083, or_3079, or_3072, or_3068, or_3064, or_3056, or_3052, or_3048};
  logic parity_3125;
  assign parity_3125 = ^{or_3117, or_3113, and_3109, or_3105, or_3101, or_3097, or_3087, or_3083, or_3079, or_3072, or_3068, or_3064, or_3056, or_3052, or_3048, or_3038, or_3034, or_3030, or_3023, or_3019, or_3015, or_3008, or_3004, or_3000};
  // hls/stages/count_bits.hpp:25
  logic and_3126;
  assign and_3126 = parity_3044 & parity_3123;
  logic or_3130;
  assign or_3130 = (parity_3026 & parity_3041) | ((^{or_3008, or_3004, or_3000}) & (parity_3026 | parity_3041));
  logic or_3134;
  assign or_3134 = (parity_3108 & parity_3120) | (parity_3093 & (parity_3108 | parity_3120));
  logic or_3141;
  assign or_3141 = (parity_3075 & parity_3090) | ((^{or_3056, or_3052, or_3048}) & (parity_3075 | parity_3090));
  logic or_3145;
  assign or_3145 = (or_3101 & or_3105) | (or_3097 & (or_3101 | or_3105));
  logic or_3149;
  assign or_3149 = (or_3113 & or_3117) | (and_3109 & (or_3113 | or_3117));
  // hls/stages/count_bits.hpp:23
  logic or_3156;
  assign or_3156 = (or_3052 & or_3056) | (or_3048 & (or_3052 | or_3056));
  // hls/stages/count_bits.hpp:25
  logic or_3160;
  assign or_3160 = (or_3068 & or_3072) | (or_3064 & (or_3068 | or_3072));
  logic or_3164;
  assign or_3164 = (or_3083 & or_3087) | (or_3079 & (or_3083 | or_3087));
  // hls/stages/count_bits.hpp:24
  logic parity_3167;
  assign parity_3167 = ^{or_3164, or_3160, or_3156};
  // hls/stages/count_bits.hpp:23
  logic or_3171;
  assign or_3171 = (or_3004 & or_3008) | (or_3000 & (or_3004 | or_3008));
  // hls/stages/count_bits.hpp:25
  logic or_3175;
  assign or_3175 = (or_3019 & or_3023) | (or_3015 & (or_3019 | or_3023));
  logic or_3179;
  assign or_3179 = (or_3034 & or_3038) | (or_3030 & (or_3034 | or_3038));
  // hls/stages/count_bits.hpp:24
  logic parity_3182;
  assign parity_3182 = ^{or_3179, or_3175, or_3171};
  logic parity_3185;
  assign parity_3185 = ^{or_3179, or_3175, or_3171, or_3164, or_3160, or_3156, or_3149, or_3145, or_3141};
  logic parity_3187;
  assign parity_3187 = ^{or_3179, or_3175, or_3171, or_3164, or_3160, or_3156, or_3149, or_3145, or_3141, or_3134, or_3130, and_3126};
  // hls/stages/count_bits.hpp:25
  logic or_3191;
  assign or_3191 = (or_3145 & or_3149) | (or_3141 & (or_3145 | or_3149));
  logic or_3195;
  assign or_3195 = (or_3160 & or_3164) | (or_3156 & (or_3160 | or_3164));
  logic or_3199;
  assign or_3199 = (or_3175 & or_3179) | (or_3171 & (or_3175 | or_3179));
  // hls/stages/count_bits.hpp:24
  logic parity_3202;
  assign parity_3202 = ^{or_3199, or_3195, or_3191};
  // hls/stages/count_bits.hpp:25
  logic and_3203;
  assign and_3203 = (^{or_3134, or_3130, and_3126}) & parity_3185;
  logic or_3207;
  assign or_3207 = (or_3130 & or_3134) | (and_3126 & (or_3130 | or_3134));
  logic or_3211;
  assign or_3211 = (parity_3167 & parity_3182) | ((^{or_3149, or_3145, or_3141}) & (parity_3167 | parity_3182));
  // hls/stages/count_bits.hpp:24
  logic parity_3214;
  assign parity_3214 = ^{or_3211, or_3207, and_3203};
  // hls/stages/count_bits.hpp:25
  logic and_3216;
  assign and_3216 = parity_3202 & parity_3214;
  logic or_3220;
  assign or_3220 = (or_3195 & or_3199) | (or_3191 & (or_3195 | or_3199));
  logic or_3224;
  assign or_3224 = (or_3207 & or_3211) | (and_3203 & (or_3207 | or_3211));
  // hls/stages/patches.hpp:176
  logic [4:0] select_3269;
  assign select_3269 = equal_1692_s3_q ? patches_along_s3_q : patches_summed_row_column_q;
  logic select_3272;
  assign select_3272 = equal_1690_s3_q ? patches_summed_first_q : (equal_1692_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:542
  logic [9:0] select_3279;
  assign select_3279 = less_1853_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3282;
  assign select_3282 = equal_1856_s3_q ? (less_1853_s3_q ? (equal_1856_s3_q ? 10'h0 : select_3279) : 10'h0) : select_3279;
  logic [9:0] select_3284;
  assign select_3284 = less_1853_s3_q ? (equal_1854_s3_q ? 10'h0 : select_3282) : select_3282;
  // hls/stages/patches.hpp:542
  logic [4:0] select_3286;
  assign select_3286 = less_1853_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3289;
  assign select_3289 = equal_1856_s3_q ? (less_1853_s3_q ? (equal_1856_s3_q ? 5'h0 : select_3286) : 5'h0) : select_3286;
  logic [4:0] select_3291;
  assign select_3291 = less_1853_s3_q ? (equal_1854_s3_q ? 5'h0 : select_3289) : select_3289;
  // hls/stages/patches.hpp:542
  logic [4:0] select_3293;
  assign select_3293 = less_1853_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3296;
  assign select_3296 = equal_1856_s3_q ? (less_1853_s3_q ? (equal_1856_s3_q ? 5'h0 : select_3293) : 5'h0) : select_3293;
  logic [4:0] select_3298;
  assign select_3298 = less_1853_s3_q ? (equal_1854_s3_q ? 5'h0 : select_3296) : select_3296;
  // hls/stages/patches.hpp:542
  logic and_3301;
  assign and_3301 = less_1853_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:546
  logic select_3304;
  assign select_3304 = equal_1856_s3_q ? (less_1853_s3_q ? (not_1857_s3_q & and_3301) : and_3301) : and_3301;
  // hls/stages/patches.hpp:176
  logic select_3307;
  assign select_3307 = equal_1690_s3_q ? (less_1853_s3_q ? (not_1855_s3_q & select_3304) : select_3304) : patches_read_first_q;
  // hls/stages/patches.hpp:170
  logic or_3318;
  assign or_3318 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3319;
  assign and_3319 = patches_read_searches_s3_q & or_3318;
  // hls/stages/patches.hpp:526
  logic [4:0] select_3320;
  assign select_3320 = and_3319 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:533
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3320};
  // hls/stages/patches.hpp:542
  logic and_3324;
  assign and_3324 = less_1853_s3_q & (equal_3316_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:546
  logic select_3327;
  assign select_3327 = equal_1856_s3_q ? (less_1853_s3_q ? (not_1857_s3_q & and_3324) : and_3324) : and_3324;
  // hls/stages/patches.hpp:176
  logic select_3330;
  assign select_3330 = equal_1690_s3_q ? (less_1853_s3_q ? (not_1855_s3_q & select_3327) : select_3327) : patches_read_above_q;
  // hls/stages/patches.hpp:542
  logic and_3333;
  assign and_3333 = less_1853_s3_q & (equal_3316_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:546
  logic select_3336;
  assign select_3336 = equal_1856_s3_q ? (less_1853_s3_q ? (not_1857_s3_q & and_3333) : and_3333) : and_3333;
  // hls/stages/patches.hpp:176
  logic select_3339;
  assign select_3339 = equal_1690_s3_q ? (less_1853_s3_q ? (not_1855_s3_q & select_3336) : select_3336) : patches_read_below_q;
  // hls/stages/patches.hpp:539
  logic [6:0] sum_3340;
  assign sum_3340 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:540
  logic [9:0] select_3343;
  assign select_3343 = (equal_3316_s3_q & ({sum_3340[6], sum_3340} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3344;
  assign select_3344 = less_1853_s3_q ? select_3343 : 10'h3ff;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3346;
  assign select_3346 = less_1853_s3_q ? (equal_1856_s3_q ? 10'h3ff : select_3344) : 10'h3ff;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3347;
  assign select_3347 = equal_1856_s3_q ? select_3346 : select_3344;
  logic [9:0] select_3349;
  assign select_3349 = less_1853_s3_q ? (equal_1854_s3_q ? 10'h3ff : select_3347) : select_3347;
  // hls/stages/patches.hpp:525
  logic [14:0] select_3351;
  assign select_3351 = and_3319 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:176
  logic [9:0] select_3352;
  assign select_3352 = equal_1690_s3_q ? select_3351[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3353;
  assign select_3353 = equal_1690_s3_q ? select_3351[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:527
  logic [9:0] select_3355;
  assign select_3355 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:528
  logic [9:0] select_3357;
  assign select_3357 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:529
  logic [9:0] select_3360;
  assign select_3360 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3361;
  assign select_3361 = patches_read_first_q ? patches_read_far_q : select_3360;
  // hls/stages/patches.hpp:580
  logic [9:0] difference_3364;
  assign difference_3364 = select_3361 - select_3351[9:0];
  // hls/stages/patches.hpp:565
  logic less_3394;
  assign less_3394 = select_3355 < select_3357;
  // hls/stages/patches.hpp:571
  logic [1:0] sum_3395;
  assign sum_3395 = select_3320[4:3] + 2'h3;
  // hls/stages/patches.hpp:566
  logic [9:0] high;
  assign high = less_3394 ? select_3357 : select_3355;
  logic [9:0] low;
  assign low = (select_3357 < select_3355) ? select_3357 : select_3355;
  // hls/stages/patches.hpp:567
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3351[9:0];
  // hls/stages/patches.hpp:569
  logic not_3402;
  assign not_3402 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3403;
  assign sum_3403 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3405;
  assign not_3405 = ~({eight, 3'h0} < {1'b0, sum_3403, fall[0]});
  logic [1:0] sum_3406;
  assign sum_3406 = {1'b0, not_3402} + {1'b0, not_3405};
  // hls/stages/patches.hpp:570
  logic [10:0] sum_3407;
  assign sum_3407 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3409;
  assign not_3409 = ~({eight, 3'h0} < {sum_3407, fall[1:0]});
  logic not_3412;
  assign not_3412 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3413;
  assign sum_3413 = {1'b0, not_3409} + {1'b0, not_3412};
  // hls/stages/patches.hpp:569
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3406} + {1'b0, sum_3413};
  // hls/stages/patches.hpp:572
  logic [7:0] select_3416;
  assign select_3416 = less_3394 ? ({sum_3395, select_3320[2:0], 3'h0} - {5'h0, fraction}) : {sum_3395, select_3320[2:0], fraction};
  // hls/stages/agreement.hpp:1086
  logic equal_3579;
  assign equal_3579 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/patches.hpp:330
  logic select_3616;
  assign select_3616 = equal_1477_s3_q ? shown_shown_q : (so_s3_q ? select_1919 : shown_shown_q);
  logic select_3618;
  assign select_3618 = equal_1477_s3_q ? shown_nearer_q : (so_s3_q ? select_1922 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3620;
  assign sum_3620 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3622;
  assign select_3622 = less_3619_s3_q ? (sum_3620[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3624;
  assign select_3624 = equal_2295_s3_q ? (equal_569_s3_q ? 3'h0 : select_3622) : region_row_q;
  // hls/stages/patches.hpp:330
  logic [7:0] select_3629;
  assign select_3629 = equal_1477_s3_q ? select_1879 : (so_s3_q ? (ends_cell_s3_q ? select_1972 : select_1879) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3643;
  assign select_3643 = equal_569_s3_q ? {{2{difference_3641[6]}}, difference_3641} : (less_3619_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_3645;
  assign select_3645 = and_508_s3_q ? (equal_2295_s3_q ? select_3643 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [6:0] select_3647;
  assign select_3647 = equal_569_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_3649;
  assign select_3649 = and_508_s3_q ? (equal_2295_s3_q ? select_3647 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3650;
  assign sum_3650 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3651;
  assign select_3651 = sum_3620[7] ? {1'b1, sum_3620[6:0], region_down_rest_q[0]} : sum_3650;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3620[7];
  // hls/stages/agreement.hpp:447
  logic select_3655;
  assign select_3655 = equal_2295_s3_q ? (equal_569_s3_q | (less_3619_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_3660;
  assign or_3660 = segment_starts_q | not_1517;
  // hls/stages/agreement.hpp:976
  logic select_3663;
  assign select_3663 = shift_2_s3_q[0] ? (sum_1892_s3_q ? (equal_1683 & or_1894) : or_1894) : or_3660;
  // hls/stages/patches.hpp:330
  logic select_3666;
  assign select_3666 = equal_1477_s3_q ? or_3660 : (so_s3_q ? (ends_cell_s3_q ? select_3663 : or_3660) : or_3660);
  logic [2:0] select_3740;
  assign select_3740 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_3742;
  assign select_3742 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3744;
  assign select_3744 = equal_1477_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3742 : box_textured_columns_values_1_q);
  logic [2:0] select_3745;
  assign select_3745 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3747;
  assign select_3747 = equal_1477_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_3745 : box_textured_columns_values_2_q);
  logic [2:0] select_3748;
  assign select_3748 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3750;
  assign select_3750 = equal_1477_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_3748 : box_textured_columns_values_3_q);
  logic [2:0] select_3751;
  assign select_3751 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3753;
  assign select_3753 = equal_1477_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_3751 : box_textured_columns_values_4_q);
  logic [4:0] select_3755;
  assign select_3755 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3758;
  assign select_3758 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3760;
  assign select_3760 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3762;
  assign select_3762 = equal_1477_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_3760 : box_explained_columns_values_1_q);
  logic [2:0] select_3763;
  assign select_3763 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3765;
  assign select_3765 = equal_1477_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_3763 : box_explained_columns_values_2_q);
  logic [2:0] select_3766;
  assign select_3766 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3768;
  assign select_3768 = equal_1477_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_3766 : box_explained_columns_values_3_q);
  logic [2:0] select_3769;
  assign select_3769 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3771;
  assign select_3771 = equal_1477_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_3769 : box_explained_columns_values_4_q);
  logic [4:0] select_3773;
  assign select_3773 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3774;
  assign select_3774 = equal_1477_s3_q ? box_explained_sum_sums_values_0_q : select_3773;
  logic [2:0] select_3776;
  assign select_3776 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3778;
  assign select_3778 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3780;
  assign select_3780 = equal_1477_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_3778 : box_shown_columns_values_1_q);
  logic [2:0] select_3781;
  assign select_3781 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3783;
  assign select_3783 = equal_1477_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_3781 : box_shown_columns_values_2_q);
  logic [2:0] select_3784;
  assign select_3784 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3786;
  assign select_3786 = equal_1477_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_3784 : box_shown_columns_values_3_q);
  logic [2:0] select_3787;
  assign select_3787 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3789;
  assign select_3789 = equal_1477_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_3787 : box_shown_columns_values_4_q);
  logic [4:0] select_3791;
  assign select_3791 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_3794;
  assign select_3794 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3796;
  assign select_3796 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3798;
  assign select_3798 = equal_1477_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_3796 : box_nearer_columns_values_1_q);
  logic [2:0] select_3799;
  assign select_3799 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3801;
  assign select_3801 = equal_1477_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_3799 : box_nearer_columns_values_2_q);
  logic [2:0] select_3802;
  assign select_3802 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3804;
  assign select_3804 = equal_1477_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_3802 : box_nearer_columns_values_3_q);
  logic [2:0] select_3805;
  assign select_3805 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3807;
  assign select_3807 = equal_1477_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_3805 : box_nearer_columns_values_4_q);
  logic [4:0] select_3809;
  assign select_3809 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_3812;
  assign select_3812 = so_s3_q ? (ends_cell_s3_q ? and_1960 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3815;
  assign select_3815 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_3817;
  assign select_3817 = equal_1477_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_3815 : centres_values_0_of_skin_q);
  logic select_3818;
  assign select_3818 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3820;
  assign select_3820 = equal_1477_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_3818 : centres_values_1_textured_q);
  logic select_3821;
  assign select_3821 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3823;
  assign select_3823 = equal_1477_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_3821 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:447
  logic [10:0] select_3827;
  assign select_3827 = equal_2295_s3_q ? (equal_3824_s3_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [5:0] select_3830;
  assign select_3830 = and_508_s3_q ? (equal_2295_s3_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1198
  logic xor_3831;
  assign xor_3831 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:424
  logic select_3833;
  assign select_3833 = and_1871_s3_q ? (left_first_s3_q ? xor_3831 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:265
  logic select_3835;
  assign select_3835 = and_1871_s3_q ? (left_first_s3_q ? xor_3831 : select_3833) : write_half_q;
  logic select_3837;
  assign select_3837 = left_first_s3_q ? select_1925 : (and_1871_s3_q ? select_1926 : read_half_q);
  logic and_3841;
  assign and_3841 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_3850;
  assign select_3850 = left_first_s3_q ? 10'h1 : (and_1871_s3_q ? select_1930 : rows_passed_q);
  logic [8:0] select_3853;
  assign select_3853 = left_first_s3_q ? {select_1928[7:0], or_1927} : (and_1871_s3_q ? {select_1928[7:0], or_1927} : columns_passed_q);
  logic select_3856;
  assign select_3856 = left_first_s3_q ? marks_last_s3_q : (and_1871_s3_q ? marks_last_s3_q : line_ended_q);
  logic select_3859;
  assign select_3859 = left_first_s3_q ? and_1944 : (and_1871_s3_q ? and_1944 : began_q);
  logic [2:0] select_3862;
  assign select_3862 = left_first_s3_q ? select_1946 : (and_1871_s3_q ? select_1946 : seen_x_q);
  // hls/stages/agreement.hpp:1227
  logic [2:0] select_3867;
  assign select_3867 = left_first_s3_q ? 3'h0 : (and_1931 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:265
  logic [2:0] select_3869;
  assign select_3869 = left_first_s3_q ? 3'h0 : (and_1871_s3_q ? select_3867 : seen_y_q);
  logic [7:0] select_3872;
  assign select_3872 = left_first_s3_q ? select_1939 : (and_1871_s3_q ? select_1939 : seen_column_q);
  // hls/stages/agreement.hpp:422
  logic [7:0] select_3878;
  assign select_3878 = left_first_s3_q ? select_3876 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:265
  logic [7:0] select_3880;
  assign select_3880 = left_first_s3_q ? select_3876 : (and_1871_s3_q ? select_3878 : seen_rows_left_q);
  // hls/stages/agreement.hpp:422
  logic and_3885;
  assign and_3885 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:265
  logic select_3887;
  assign select_3887 = left_first_s3_q ? and_3885 : (and_1871_s3_q ? and_3885 : at_cell_end_q);
  logic select_3890;
  assign select_3890 = left_first_s3_q ? next_row : (and_1871_s3_q ? next_row : was_next_row_q);
  logic [10:0] select_3893;
  assign select_3893 = left_first_s3_q ? 11'h0 : (and_1871_s3_q ? select_1936 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_3959;
  assign not_3959 = ~quarter[1];
  logic [3:0] select_3960;
  assign select_3960 = quarter[0] ? {quarter[1], 1'b0, not_3959, 1'b0} : {1'b0, quarter[1], 1'b0, not_3959};

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

  // Memory patches_choices, 64 x 22, DISTANCE 12, hls/stages/patches.hpp:745; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
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

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1319; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
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

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1330; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
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
  assign averager_memory_waddr = select_478_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_483_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_502, and_498, sum_494, sum_490};
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
  assign census_memory_we = s3_en & and_508_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_526, whole_2, select_518, select_514};
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
      census_filled_q <= and_508_s3_q ? {select_572[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_508_s3_q ? select_571 : rows_passed_above_q;
      registration_slope_here_q <= select_2520;
      registration_expected_q <= select_2522;
      registration_of_right_q <= equal_1477_s3_q ? registration_of_right_q : select_2582;
      registration_was_inside_q <= equal_1477_s3_q ? registration_was_inside_q : select_2585;
      registration_fresh_q <= select_2594;
      patches_chance_q <= and_508_s3_q ? select_2751 : patches_chance_q;
      patches_fixed_q <= and_2765;
      patches_choice_valid_q <= and_1688 ? (select_1682[0] & not_2753) : select_1682[0];
      patches_choice_column_q <= select_1682[7:1];
      patches_choice_shift_q <= select_1682[13:8];
      patches_choice_slope_q <= select_1682[21:14];
      patches_band_q <= sample_pair_whole_s3_q ? select_1703 : patches_band_q;
      patches_fetch_q <= select_2780;
      patches_codes_at_q <= select_2881;
      patches_codes_further_q <= equal_1690_s3_q ? patches_codes_further_q : select_2886;
      patches_next_codes_q <= select_2894;
      patches_set_q <= equal_1690_s3_q ? 3'h0 : (equal_1692_s3_q ? 3'h0 : select_2908);
      patches_size_q <= sum_2912;
      patches_left_row_q <= select_2924;
      patches_summed_row_column_q <= equal_1690_s3_q ? patches_summed_row_column_q : select_3269;
      patches_summed_first_q <= select_3272;
      patches_read_row_differing_q <= equal_1690_s3_q ? select_3284 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1690_s3_q ? select_3291 : patches_read_row_column_q;
      patches_read_at_q <= equal_1690_s3_q ? select_3298 : patches_read_at_q;
      patches_read_first_q <= select_3307;
      patches_read_above_q <= select_3330;
      patches_read_below_q <= select_3339;
      patches_read_far_q <= equal_1690_s3_q ? select_3349 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3352;
      patches_peak_best_column_q <= select_3353;
      patches_peak_row_q <= equal_1690_s3_q ? select_3320 : patches_peak_row_q;
      patches_peak_above_q <= equal_1690_s3_q ? select_3355 : patches_peak_above_q;
      patches_peak_below_q <= equal_1690_s3_q ? select_3357 : patches_peak_below_q;
      patches_peak_far_q <= equal_1690_s3_q ? select_3361 : patches_peak_far_q;
      shown_shown_q <= select_3616;
      shown_nearer_q <= select_3618;
      region_row_q <= and_508_s3_q ? select_3624 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3629;
      region_down_rest_q <= select_3645;
      region_down_back_q <= select_3649;
      region_down_next_q <= select_3651;
      region_fresh_q <= and_508_s3_q ? select_3655 : region_fresh_q;
      segment_starts_q <= select_3666;
      centres_values_0_textured_q <= equal_1477_s3_q ? centres_values_0_textured_q : select_3812;
      centres_values_0_of_skin_q <= select_3817;
      centres_values_1_textured_q <= select_3820;
      centres_values_1_of_skin_q <= select_3823;
      map_row_q <= and_508_s3_q ? select_3827 : map_row_q;
      map_width_q <= select_3830;
      write_half_q <= select_3835;
      read_half_q <= and_1871_s3_q ? select_3837 : read_half_q;
      done_q <= and_1871_s3_q ? (not_1942 & and_3841) : and_3841;
      drew_q <= so_s3_q;
      said_q <= equal_1477_s3_q & equal_3579;
      rows_passed_q <= and_1871_s3_q ? select_3850 : rows_passed_q;
      columns_passed_q <= and_1871_s3_q ? select_3853 : columns_passed_q;
      line_ended_q <= and_1871_s3_q ? select_3856 : line_ended_q;
      began_q <= and_1871_s3_q ? select_3859 : began_q;
      seen_x_q <= and_1871_s3_q ? select_3862 : seen_x_q;
      seen_y_q <= and_1871_s3_q ? select_3869 : seen_y_q;
      seen_column_q <= and_1871_s3_q ? select_3872 : seen_column_q;
      seen_rows_left_q <= and_1871_s3_q ? select_3880 : seen_rows_left_q;
      at_cell_end_q <= and_1871_s3_q ? select_3887 : at_cell_end_q;
      was_next_row_q <= and_1871_s3_q ? select_3890 : was_next_row_q;
      seen_base_q <= and_1871_s3_q ? select_3893 : seen_base_q;
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
      averager_running_0_q <= sample_pair_whole_s3_q ? select_486 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_492 : averager_running_1_q;
      averager_total_0_q <= select_2063;
      averager_total_1_q <= select_2065;
      census_columns_values_0_cell_0_left_q <= select_2089;
      census_columns_values_0_cell_0_right_q <= select_2090;
      census_columns_values_0_cell_0_mask_q <= and_508_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
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
      sharpness_last_mean_0_q <= and_508_s3_q ? select_514 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_508_s3_q ? select_518 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1477_s3_q ? box_textured_columns_values_0_q : select_3740;
      box_textured_columns_values_1_q <= select_3744;
      box_textured_columns_values_2_q <= select_3747;
      box_textured_columns_values_3_q <= select_3750;
      box_textured_columns_values_4_q <= select_3753;
      box_textured_sum_sums_values_0_q <= equal_1477_s3_q ? box_textured_sum_sums_values_0_q : select_3755;
      box_explained_columns_values_0_q <= equal_1477_s3_q ? box_explained_columns_values_0_q : select_3758;
      box_explained_columns_values_1_q <= select_3762;
      box_explained_columns_values_2_q <= select_3765;
      box_explained_columns_values_3_q <= select_3768;
      box_explained_columns_values_4_q <= select_3771;
      box_explained_sum_sums_values_0_q <= select_3774;
      box_shown_columns_values_0_q <= equal_1477_s3_q ? box_shown_columns_values_0_q : select_3776;
      box_shown_columns_values_1_q <= select_3780;
      box_shown_columns_values_2_q <= select_3783;
      box_shown_columns_values_3_q <= select_3786;
      box_shown_columns_values_4_q <= select_3789;
      box_shown_sum_sums_values_0_q <= equal_1477_s3_q ? box_shown_sum_sums_values_0_q : select_3791;
      box_nearer_columns_values_0_q <= equal_1477_s3_q ? box_nearer_columns_values_0_q : select_3794;
      box_nearer_columns_values_1_q <= select_3798;
      box_nearer_columns_values_2_q <= select_3801;
      box_nearer_columns_values_3_q <= select_3804;
      box_nearer_columns_values_4_q <= select_3807;
      box_nearer_sum_sums_values_0_q <= equal_1477_s3_q ? box_nearer_sum_sums_values_0_q : select_3809;
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
  logic [2:0] select_472_s4_q;
  logic [5:0] select_474_s4_q;
  logic [5:0] column_s4_q;
  logic and_506_s4_q;
  logic and_508_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_511_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
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
  logic less_559_s4_q;
  logic less_560_s4_q;
  logic less_561_s4_q;
  logic less_562_s4_q;
  logic less_563_s4_q;
  logic less_564_s4_q;
  logic less_565_s4_q;
  logic and_573_s4_q;
  logic and_598_s4_q;
  logic and_599_s4_q;
  logic [11:0] sum_614_s4_q;
  logic [9:0] sum_617_s4_q;
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
  logic and_2411_s4_q;
  logic and_2415_s4_q;
  logic not_2449_s4_q;
  logic and_2477_s4_q;
  logic and_2526_s4_q;
  logic and_2527_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2561_s4_q;
  logic and_2575_s4_q;
  logic equal_2618_s4_q;
  logic parity_2996_s4_q;
  logic parity_3125_s4_q;
  logic parity_3187_s4_q;
  logic xor_3215_s4_q;
  logic parity_3227_s4_q;
  logic or_3231_s4_q;
  logic equal_3232_s4_q;
  logic [4:0] select_3351_s4_q;
  logic equal_3363_s4_q;
  logic less_3365_s4_q;
  logic less_3366_s4_q;
  logic or_3371_s4_q;
  logic [7:0] select_3416_s4_q;
  logic equal_3579_s4_q;
  logic and_3896_s4_q;
  logic equal_3962_s4_q;
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
      select_472_s4_q <= select_472_s3_q;
      select_474_s4_q <= select_474_s3_q;
      column_s4_q <= column_s3_q;
      and_506_s4_q <= and_506_s3_q;
      and_508_s4_q <= and_508_s3_q;
      grey_s4_q <= grey;
      equal_511_s4_q <= equal_511;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
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
      less_559_s4_q <= less_559;
      less_560_s4_q <= less_560;
      less_561_s4_q <= less_561;
      less_562_s4_q <= less_562;
      less_563_s4_q <= less_563;
      less_564_s4_q <= less_564;
      less_565_s4_q <= less_565;
      and_573_s4_q <= and_573;
      and_598_s4_q <= whole_22 & and_573;
      and_599_s4_q <= census_columns_values_1_cell_2_mask_q & and_573;
      sum_614_s4_q <= {1'b0, sum_610} + {2'h0, sum_613};
      sum_617_s4_q <= {9'h0, difference_615[9]} + {1'b0, xor_616};
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
      and_2411_s4_q <= and_2411;
      and_2415_s4_q <= and_2415;
      not_2449_s4_q <= ~({sum_2447, e[0]} < {2'h0, t});
      and_2477_s4_q <= not_1478_s3_q & and_2476;
      and_2526_s4_q <= not_1478_s3_q & (so_s3_q & (half_ends & equal_2523));
      and_2527_s4_q <= and_2527;
      residual_s4_q <= residual[7:0];
      and_2561_s4_q <= and_2561;
      and_2575_s4_q <= and_2527 & less_2574;
      equal_2618_s4_q <= (registration_fresh_q & select_2616) == 4'h0;
      parity_2996_s4_q <= ^{xor_2992, xor_2955, select_2922[44:36], other[44:36]};
      parity_3125_s4_q <= parity_3125;
      parity_3187_s4_q <= parity_3187;
      xor_3215_s4_q <= parity_3202 ^ parity_3214;
      parity_3227_s4_q <= ^{or_3224, or_3220, and_3216};
      or_3231_s4_q <= (or_3220 & or_3224) | (and_3216 & (or_3220 | or_3224));
      equal_3232_s4_q <= equal_3232_s3_q;
      select_3351_s4_q <= select_3351[14:10];
      equal_3363_s4_q <= select_3320[3:0] == 4'h0;
      less_3365_s4_q <= {difference_3364, 3'h0} < {3'h0, sum_2912};
      less_3366_s4_q <= select_3361 < select_3351[9:0];
      or_3371_s4_q <= (sum_2912 < 10'h39) | ({1'b0, sum_2912[9:1]} < select_3351[9:0]);
      select_3416_s4_q <= select_3416;
      equal_3579_s4_q <= equal_3579;
      and_3896_s4_q <= and_2031 & (sum_1957 == sum_1941);
      equal_3962_s4_q <= (registration_fresh_q & select_3960) == 4'h0;
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
  assign texture = sum_614_s4_q + {2'h0, sum_617_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_619;
  assign sum_619 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_621;
  assign sum_621 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_619});
  // hls/stages/census.hpp:303
  logic less_622;
  assign less_622 = 9'h4 < sum_621[13:5];
  logic and_623;
  assign and_623 = and_573_s4_q & less_622;
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
  // hls/stages/patches.hpp:343
  logic [21:0] select_1706;
  assign select_1706 = and_1705_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1682_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:119
  logic select_1708;
  assign select_1708 = equal_1608_s4_q ? patches_place_0_valid_q : (select_1607_s4_q ? patches_place_0_valid_q : select_1706[0]);
  // hls/stages/patches.hpp:344
  logic [20:0] select_1709;
  assign select_1709 = select_1607_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1706[21:1];
  // hls/stages/patches.hpp:119
  logic [6:0] select_1710;
  assign select_1710 = equal_1608_s4_q ? patches_place_0_column_q : select_1709[6:0];
  logic [5:0] select_1711;
  assign select_1711 = equal_1608_s4_q ? patches_place_0_shift_q : select_1709[12:7];
  // hls/stages/patches.hpp:314
  logic [6:0] sum_1712;
  assign sum_1712 = select_1710 + {select_1711[5], select_1711};
  // hls/stages/patches.hpp:315
  logic [5:0] sum_1713;
  assign sum_1713 = sum_1712[6:1] + 6'h3f;
  // hls/stages/patches.hpp:123
  logic equal_1714;
  assign equal_1714 = {sum_1713[5], select_474_s4_q, select_472_s4_q} == {1'b0, sum_1713[4:0], sum_1712[0], 3'h4};
  // hls/stages/patches.hpp:125
  logic or_1716;
  assign or_1716 = and_1590_s4_q | (select_1708 & equal_1714);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_1717;
  assign select_1717 = or_1716 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:125
  logic [5:0] select_1727;
  assign select_1727 = or_1716 ? {and_1590_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:129
  logic and_1729;
  assign and_1729 = select_1726_s4_q & (~select_1727[5]);
  // hls/stages/patches.hpp:119
  logic select_1737;
  assign select_1737 = equal_1608_s4_q ? patches_place_1_valid_q : (select_1607_s4_q ? select_1706[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:344
  logic [20:0] select_1738;
  assign select_1738 = select_1607_s4_q ? select_1706[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:119
  logic [6:0] select_1739;
  assign select_1739 = equal_1608_s4_q ? patches_place_1_column_q : select_1738[6:0];
  logic [5:0] select_1740;
  assign select_1740 = equal_1608_s4_q ? patches_place_1_shift_q : select_1738[12:7];
  // hls/stages/patches.hpp:314
  logic [6:0] sum_1741;
  assign sum_1741 = select_1739 + {select_1740[5], select_1740};
  // hls/stages/patches.hpp:315
  logic [5:0] sum_1742;
  assign sum_1742 = sum_1741[6:1] + 6'h3f;
  // hls/stages/patches.hpp:123
  logic equal_1743;
  assign equal_1743 = {sum_1742[5], select_474_s4_q, select_472_s4_q} == {1'b0, sum_1742[4:0], sum_1741[0], 3'h4};
  // hls/stages/patches.hpp:125
  logic or_1745;
  assign or_1745 = and_1590_s4_q | (select_1737 & equal_1743);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_1746;
  assign select_1746 = or_1745 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:125
  logic [5:0] select_1747;
  assign select_1747 = or_1745 ? {and_1590_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:129
  logic and_1749;
  assign and_1749 = select_1726_s4_q & (~select_1747[5]);
  // hls/stages/patches.hpp:310
  logic [6:0] sum_1756;
  assign sum_1756 = select_1710 + 7'h7f;
  // hls/stages/patches.hpp:124
  logic equal_1757;
  assign equal_1757 = {sum_1756[6], select_474_s4_q, select_472_s4_q} == {1'b0, sum_1756[5:0], 3'h4};
  // hls/stages/patches.hpp:126
  logic or_1759;
  assign or_1759 = and_1590_s4_q | (select_1708 & equal_1757);
  logic [4:0] select_1760;
  assign select_1760 = or_1759 ? {and_1590_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:310
  logic [6:0] sum_1761;
  assign sum_1761 = select_1739 + 7'h7f;
  // hls/stages/patches.hpp:124
  logic equal_1762;
  assign equal_1762 = {sum_1761[6], select_474_s4_q, select_472_s4_q} == {1'b0, sum_1761[5:0], 3'h4};
  // hls/stages/patches.hpp:126
  logic [4:0] select_1765;
  assign select_1765 = (and_1590_s4_q | (select_1737 & equal_1762)) ? {and_1590_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:134
  logic [3:0] column_5;
  assign column_5 = select_1760[4] ? select_1765[3:0] : select_1760[3:0];
  // hls/stages/agreement.hpp:263
  logic select_1768;
  assign select_1768 = or_1759 ? and_1590_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:134
  logic and_1774;
  assign and_1774 = (select_1726_s4_q & (select_1720_s4_q[3] ^ select_1720_s4_q[4])) & ((~select_1760[4]) | (~select_1765[4]));
  // hls/stages/patches.hpp:176
  logic less_1865;
  assign less_1865 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:177
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
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1901;
  assign select_1901 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:867
  logic [5:0] sum_1902;
  assign sum_1902 = {5'h0, textured_s4_q} + select_1901;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_1904;
  assign sum_1904 = {4'h0, sum_1902} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1906;
  assign select_1906 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:867
  logic [5:0] sum_1907;
  assign sum_1907 = {5'h0, explained_s4_q} + select_1906;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_1909;
  assign sum_1909 = {4'h0, sum_1907} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [5:0] select_1912;
  assign select_1912 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:868
  logic [5:0] sum_1913;
  assign sum_1913 = {5'h0, and_1911_s4_q} + select_1912;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_1915;
  assign sum_1915 = {4'h0, sum_1913} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1043
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
  // hls/stages/agreement.hpp:976
  logic and_1991;
  assign and_1991 = good_known_q & (~((good_q & select_1987) == 48'h0));
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_1970_s4_q ? and_1991 : not_2006_s4_q;
  // hls/stages/agreement.hpp:1054
  logic and_2021;
  assign and_2021 = is_seen & less_2020_s4_q;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2055;
  assign select_2055 = sample_pair_whole_s4_q ? (and_506_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2057;
  assign select_2057 = sample_pair_whole_s4_q ? (and_506_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2059;
  assign select_2059 = sample_pair_whole_s4_q ? (and_506_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2061;
  assign select_2061 = sample_pair_whole_s4_q ? (and_506_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
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
  assign detail = {3'h0, size} + (equal_511_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2073;
  assign select_2073 = sample_pair_whole_s4_q ? (and_506_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
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
  assign detail_2 = {3'h0, size_2} + (equal_511_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2081;
  assign select_2081 = sample_pair_whole_s4_q ? (and_506_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2164;
  assign sum_2164 = sum_2160_s4_q + {2'h0, sum_2163_s4_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2166;
  assign select_2166 = and_508_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2167;
  assign select_2167 = and_508_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2168;
  assign select_2168 = and_508_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2169;
  assign select_2169 = and_508_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2172;
  assign sum_2172 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2164};
  logic [13:0] sum_2174;
  assign sum_2174 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2172});
  // hls/stages/census.hpp:305
  logic and_2176;
  assign and_2176 = and_598_s4_q & (9'h4 < sum_2174[13:5]);
  // hls/stages/census.hpp:306
  logic and_2177;
  assign and_2177 = and_598_s4_q & less_622;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2178;
  assign sum_2178 = census_left_misses_q + {{17{and_2177}}, and_2176, 1'b0, and_2176};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2180;
  assign select_2180 = and_508_s4_q ? (equal_2171_s4_q ? 20'h0 : sum_2178) : census_left_misses_q;
  // hls/stages/agreement.hpp:263
  logic [27:0] select_2185;
  assign select_2185 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:507
  logic select_2188;
  assign select_2188 = and_508_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2191;
  assign and_2191 = whole_2_s4_q & (~(column_s4_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:444
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
  // hls/stages/agreement.hpp:444
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
  // hls/stages/agreement.hpp:203
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
  // hls/stages/agreement.hpp:207
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
  // hls/stages/agreement.hpp:207
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
  // hls/stages/agreement.hpp:207
  logic select_2263;
  assign select_2263 = drew_q ? (equal_2224 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:207
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
  // hls/stages/agreement.hpp:207
  logic select_2274;
  assign select_2274 = drew_q ? (equal_2224 ? select_2272 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2275;
  assign xor_2275 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2278;
  assign select_2278 = (equal_2268 | xor_2275) ? (five_times_2[0] & xor_2275) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2280;
  assign select_2280 = drew_q ? (equal_2224 ? select_2278 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2281;
  assign xor_2281 = sharpness_comparing_contrast_0_q[1] ^ and_2235;
  logic select_2284;
  assign select_2284 = (equal_2268 | xor_2281) ? (and_2235 & xor_2281) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2286;
  assign select_2286 = drew_q ? (equal_2224 ? select_2284 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2287;
  assign xor_2287 = sharpness_comparing_contrast_1_q[1] ^ and_2245;
  logic select_2290;
  assign select_2290 = (equal_2268 | xor_2287) ? (and_2245 & xor_2287) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2292;
  assign select_2292 = drew_q ? (equal_2224 ? select_2290 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2417;
  assign select_2417 = and_2411_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2415_s4_q});
  // hls/stages/patches.hpp:330
  logic and_2420;
  assign and_2420 = not_1478_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2425;
  assign and_2425 = not_1478_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2430;
  assign and_2430 = not_1478_s4_q & (drew_q & (ends_cell_s4_q & and_1911_s4_q));
  // hls/stages/agreement.hpp:1047
  logic not_2434;
  assign not_2434 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1048
  logic not_2451;
  assign not_2451 = ~(equal_1970_s4_q ? and_1991 : not_2449_s4_q);
  // hls/stages/patches.hpp:330
  logic and_2454;
  assign and_2454 = ends_cell_s4_q & (not_2434 & (centres_values_1_textured_s4_q & not_2451));
  logic and_2456;
  assign and_2456 = not_1478_s4_q & (drew_q & and_2454);
  // hls/stages/agreement.hpp:1074
  logic less_2459;
  assign less_2459 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2460;
  assign select_2460 = less_2459 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2463;
  assign select_2463 = less_2459 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2464;
  assign sum_2464 = {1'b0, select_2463} + {3'h0, select_2463[9:2]};
  logic and_2466;
  assign and_2466 = (~(select_2460[9:4] == 6'h0)) & ({sum_2464, select_2463[1:0]} < {3'h0, select_2460});
  // hls/stages/agreement.hpp:1084
  logic [9:0] select_2469;
  assign select_2469 = x_s4_q[6] ? (equal_1522_s4_q ? 10'h0 : (and_2466 ? select_2460 : 10'h0)) : 10'h0;
  // hls/stages/patches.hpp:330
  logic [9:0] select_2470;
  assign select_2470 = equal_1477_s4_q ? select_2469 : 10'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2472;
  assign select_2472 = and_2411_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2470});
  logic [13:0] select_2479;
  assign select_2479 = and_2411_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2477_s4_q});
  // hls/stages/agreement.hpp:1052
  logic and_2481;
  assign and_2481 = not_2434 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/patches.hpp:330
  logic and_2484;
  assign and_2484 = not_1478_s4_q & (drew_q & (ends_cell_s4_q & and_2481));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2486;
  assign select_2486 = and_2411_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2484});
  // hls/stages/agreement.hpp:1052
  logic and_2488;
  assign and_2488 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2451);
  // hls/stages/patches.hpp:330
  logic and_2492;
  assign and_2492 = not_1478_s4_q & (drew_q & (ends_cell_s4_q & (not_2434 & and_2488)));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2494;
  assign select_2494 = and_2411_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2492});
  // hls/stages/patches.hpp:330
  logic [7:0] select_2543;
  assign select_2543 = drew_q ? (equal_1618_s4_q ? (and_2527_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2544;
  assign select_2544 = equal_1477_s4_q ? 8'h0 : select_2543;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2546;
  assign select_2546 = and_2526_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2544[7]}}, select_2544});
  // hls/stages/patches.hpp:330
  logic and_2549;
  assign and_2549 = not_1478_s4_q & (drew_q & (and_2527_s4_q & equal_1618_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2551;
  assign select_2551 = and_2526_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2549});
  // hls/stages/registration.hpp:107
  logic and_2553;
  assign and_2553 = and_2527_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/patches.hpp:330
  logic [1:0] select_2555;
  assign select_2555 = drew_q ? (equal_1618_s4_q ? {and_2553, and_2527_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2556;
  assign select_2556 = equal_1477_s4_q ? 2'h0 : select_2555;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2557;
  assign sum_2557 = registration_half_votes_down_q + {{5{select_2556[1]}}, select_2556};
  // hls/stages/patches.hpp:330
  logic [1:0] select_2563;
  assign select_2563 = drew_q ? (equal_1618_s4_q ? {and_2561_s4_q, and_2527_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2564;
  assign select_2564 = equal_1477_s4_q ? 2'h0 : select_2563;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2565;
  assign sum_2565 = registration_half_votes_up_q + {{5{select_2564[1]}}, select_2564};
  // hls/stages/registration.hpp:107
  logic and_2568;
  assign and_2568 = and_2527_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/patches.hpp:330
  logic [1:0] select_2570;
  assign select_2570 = drew_q ? (equal_1618_s4_q ? {and_2568, and_2527_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2571;
  assign select_2571 = equal_1477_s4_q ? 2'h0 : select_2570;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2572;
  assign sum_2572 = registration_half_half_votes_down_q + {{5{select_2571[1]}}, select_2571};
  // hls/stages/patches.hpp:330
  logic [1:0] select_2577;
  assign select_2577 = drew_q ? (equal_1618_s4_q ? {and_2575_s4_q, and_2527_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2578;
  assign select_2578 = equal_1477_s4_q ? 2'h0 : select_2577;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2579;
  assign sum_2579 = registration_half_half_votes_up_q + {{5{select_2578[1]}}, select_2578};
  // hls/stages/patches.hpp:330
  logic and_2613;
  assign and_2613 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & less_1553_s4_q));
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2620;
  assign select_2620 = or_1557_s4_q ? 12'h0 : (equal_2618_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2623;
  assign select_2623 = x_s4_q[6] ? (equal_1522_s4_q ? 12'h0 : (less_1553_s4_q ? select_2620 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:330
  logic [11:0] select_2624;
  assign select_2624 = equal_1477_s4_q ? select_2623 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2625;
  assign and_2625 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_2628;
  assign and_2628 = not_1890_s4_q & (less_1553_s4_q & ({and_2625, x_s4_q[0]} == 2'h0));
  // hls/stages/patches.hpp:330
  logic and_2630;
  assign and_2630 = equal_1477_s4_q & (x_s4_q[6] & and_2628);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2632;
  assign sum_2632 = {{2{select_2624[11]}}, select_2624} + (and_2630 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_2635;
  assign select_2635 = or_1557_s4_q ? 12'h0 : (equal_2618_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_2638;
  assign select_2638 = x_s4_q[6] ? (equal_1522_s4_q ? 12'h0 : (less_1553_s4_q ? select_2635 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:330
  logic [11:0] select_2639;
  assign select_2639 = equal_1477_s4_q ? select_2638 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2641;
  assign sum_2641 = {{2{select_2639[11]}}, select_2639} + (and_2630 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2643;
  assign not_2643 = ~all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_2646;
  assign and_2646 = not_1890_s4_q & (less_1553_s4_q & (x_s4_q[2:0] == {all_s4_q, not_2643, 1'b0}));
  // hls/stages/patches.hpp:330
  logic and_2652;
  assign and_2652 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & (less_1553_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_2653;
  assign not_2653 = ~and_2652;
  logic less_2654;
  assign less_2654 = $signed({9'h1, {2{not_2653}}, and_2652}) < $signed(registration_up_q[13:2]);
  logic select_2655;
  assign select_2655 = (equal_1477_s4_q & (x_s4_q[6] & and_2646)) ? less_2654 : registration_enough_q;
  // hls/stages/agreement.hpp:1084
  logic and_2659;
  assign and_2659 = x_s4_q[6] & (not_1890_s4_q & (less_1553_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:330
  logic and_2660;
  assign and_2660 = equal_1477_s4_q & and_2659;
  // hls/stages/registration.hpp:242
  logic less_2661;
  assign less_2661 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2663;
  assign less_2663 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2665;
  assign equal_2665 = x_s4_q[2:0] == 3'h7;
  // hls/stages/patches.hpp:330
  logic and_2669;
  assign and_2669 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & (less_1553_s4_q & equal_2665)));
  // hls/stages/agreement.hpp:1084
  logic and_2676;
  assign and_2676 = x_s4_q[6] & (not_1890_s4_q & (less_1553_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2679;
  assign equal_2679 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1084
  logic and_2682;
  assign and_2682 = not_1890_s4_q & (less_1553_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_2679));
  // hls/stages/registration.hpp:244
  logic and_2686;
  assign and_2686 = (equal_1477_s4_q & (x_s4_q[6] & and_2682)) & (less_2663 | less_2661);
  // hls/stages/agreement.hpp:1084
  logic and_2691;
  assign and_2691 = not_1890_s4_q & (less_1553_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_2679)));
  // hls/stages/registration.hpp:244
  logic and_2694;
  assign and_2694 = registration_votes_up_q & registration_other_down_q;
  logic select_2696;
  assign select_2696 = registration_votes_down_q ? (registration_other_up_q | and_2694) : and_2694;
  // hls/stages/registration.hpp:138
  logic and_2698;
  assign and_2698 = (equal_1477_s4_q & (x_s4_q[6] & and_2691)) & (registration_other_enough_q & select_2696);
  // hls/stages/registration.hpp:245
  logic or_2701;
  assign or_2701 = registration_moved_q | (registration_enough_q & (and_2686 | and_2698));
  // hls/stages/agreement.hpp:263
  logic [7:0] select_2785;
  assign select_2785 = sample_pair_whole_s4_q ? (equal_1608_s4_q ? patches_place_0_slope_q : select_1709[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_2790;
  assign select_2790 = sample_pair_whole_s4_q ? (equal_1608_s4_q ? patches_place_1_slope_q : select_1738[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:119
  logic select_2792;
  assign select_2792 = equal_1608_s4_q ? patches_valid_0_q : (select_1607_s4_q ? patches_valid_0_q : select_1706[0]);
  // hls/stages/agreement.hpp:263
  logic select_2795;
  assign select_2795 = sample_pair_whole_s4_q ? (and_1729 ? (sample_present_s4_q & select_2792) : select_2792) : patches_valid_0_q;
  // hls/stages/patches.hpp:119
  logic select_2797;
  assign select_2797 = equal_1608_s4_q ? patches_valid_1_q : (select_1607_s4_q ? select_1706[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_2800;
  assign select_2800 = sample_pair_whole_s4_q ? (and_1749 ? (sample_present_s4_q & select_2797) : select_2797) : patches_valid_1_q;
  logic [5:0] select_2803;
  assign select_2803 = sample_pair_whole_s4_q ? (select_1727[5] ? {1'b1, select_1727[4:0]} : (select_1727 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2806;
  assign select_2806 = sample_pair_whole_s4_q ? (select_1747[5] ? {1'b1, select_1747[4:0]} : (select_1747 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_2809;
  assign select_2809 = sample_pair_whole_s4_q ? (select_1760[4] ? {1'b1, select_1760[3:0]} : (select_1760 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2812;
  assign select_2812 = sample_pair_whole_s4_q ? (select_1765[4] ? {1'b1, select_1765[3:0]} : (select_1765 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:511
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3231_s4_q, parity_3227_s4_q, xor_3215_s4_q, parity_3187_s4_q, parity_3125_s4_q, parity_2996_s4_q} + (equal_3232_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:176
  logic [9:0] select_3236;
  assign select_3236 = equal_1690_s4_q ? patches_sums_values_0_q : (equal_1692_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3237;
  assign select_3237 = equal_1692_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3239;
  assign select_3239 = equal_1692_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3241;
  assign select_3241 = equal_1692_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3243;
  assign select_3243 = equal_1692_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3245;
  assign select_3245 = equal_1692_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3247;
  assign select_3247 = equal_1692_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3249;
  assign select_3249 = equal_1692_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3251;
  assign select_3251 = equal_1692_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3253;
  assign select_3253 = equal_1692_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3255;
  assign select_3255 = equal_1692_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3257;
  assign select_3257 = equal_1692_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3259;
  assign select_3259 = equal_1692_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3261;
  assign select_3261 = equal_1692_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3263;
  assign select_3263 = equal_1692_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3265;
  assign select_3265 = equal_1692_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3267;
  assign select_3267 = equal_1692_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:585
  logic or_3372;
  assign or_3372 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3371_s4_q;
  logic or_3375;
  assign or_3375 = equal_3363_s4_q | (less_3365_s4_q | (less_3366_s4_q | or_3372));
  // hls/stages/patches.hpp:565
  logic not_3376;
  assign not_3376 = ~or_3375;
  // hls/stages/patches.hpp:546
  logic and_3377;
  assign and_3377 = equal_1856_s4_q & not_3376;
  // hls/stages/patches.hpp:176
  logic and_3380;
  assign and_3380 = equal_1690_s4_q & (less_1853_s4_q ? (not_1855_s4_q & and_3377) : and_3377);
  // hls/stages/patches.hpp:636
  logic not_3381;
  assign not_3381 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:546
  logic and_3383;
  assign and_3383 = equal_1856_s4_q & (patches_second_s4_q & not_3376);
  // hls/stages/patches.hpp:176
  logic and_3386;
  assign and_3386 = equal_1690_s4_q & (less_1853_s4_q ? (not_1855_s4_q & and_3383) : and_3383);
  // hls/stages/patches.hpp:636
  logic not_3387;
  assign not_3387 = ~and_3386;
  // hls/stages/patches.hpp:180
  logic and_3389;
  assign and_3389 = and_3380 & (not_3381 & not_3387);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3391;
  assign sum_3391 = {7'h0, and_3389} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:583
  logic [7:0] select_3417;
  assign select_3417 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:582
  logic [5:0] select_3418;
  assign select_3418 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3419;
  assign sum_3419 = {2'h0, select_3351_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3420;
  assign sum_3420 = {select_3418[5], select_3418} + {{3{sum_3419[3]}}, sum_3419};
  // hls/stages/patches.hpp:583
  logic [17:0] product_3421;
  assign product_3421 = $signed({{10{select_3417[7]}}, select_3417}) * $signed({{8{sum_3420[6]}}, sum_3420, select_3351_s4_q[2:0]});
  // hls/stages/patches.hpp:584
  logic [13:0] difference_3422;
  assign difference_3422 = {{6{select_3416_s4_q[7]}}, select_3416_s4_q} - {product_3421[17], product_3421[17:5]};
  // hls/stages/patches.hpp:590
  logic less_3423;
  assign less_3423 = $signed({{7{difference_3393[6]}}, difference_3393}) < $signed(difference_3422);
  // hls/stages/patches.hpp:546
  logic and_3426;
  assign and_3426 = equal_1856_s4_q & (not_3376 & (~less_3423));
  // hls/stages/patches.hpp:176
  logic and_3429;
  assign and_3429 = equal_1690_s4_q & (less_1853_s4_q ? (not_1855_s4_q & and_3426) : and_3426);
  // hls/stages/patches.hpp:639
  logic and_3430;
  assign and_3430 = and_3429 & and_3389;
  logic [7:0] sum_3431;
  assign sum_3431 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3430};
  // hls/stages/patches.hpp:546
  logic and_3435;
  assign and_3435 = not_3376 & (~($signed(difference_3422) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3436;
  assign and_3436 = equal_1856_s4_q & and_3435;
  // hls/stages/patches.hpp:176
  logic and_3439;
  assign and_3439 = equal_1690_s4_q & (less_1853_s4_q ? (not_1855_s4_q & and_3436) : and_3436);
  // hls/stages/patches.hpp:640
  logic and_3440;
  assign and_3440 = and_3439 & and_3389;
  logic [7:0] sum_3441;
  assign sum_3441 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3440};
  // hls/stages/patches.hpp:180
  logic and_3443;
  assign and_3443 = and_3380 & (and_3386 & not_3381);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3445;
  assign sum_3445 = {7'h0, and_3443} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:639
  logic and_3447;
  assign and_3447 = and_3429 & and_3443;
  logic [7:0] sum_3448;
  assign sum_3448 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3447};
  // hls/stages/patches.hpp:640
  logic and_3450;
  assign and_3450 = and_3439 & and_3443;
  logic [7:0] sum_3451;
  assign sum_3451 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3450};
  // hls/stages/patches.hpp:180
  logic and_3453;
  assign and_3453 = and_3380 & (patches_lower_s4_q & not_3387);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3455;
  assign sum_3455 = {7'h0, and_3453} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:639
  logic and_3457;
  assign and_3457 = and_3429 & and_3453;
  logic [7:0] sum_3458;
  assign sum_3458 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3457};
  // hls/stages/patches.hpp:640
  logic and_3460;
  assign and_3460 = and_3439 & and_3453;
  logic [7:0] sum_3461;
  assign sum_3461 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3460};
  // hls/stages/patches.hpp:180
  logic and_3463;
  assign and_3463 = and_3380 & (patches_lower_s4_q & and_3386);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3465;
  assign sum_3465 = {7'h0, and_3463} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:639
  logic and_3467;
  assign and_3467 = and_3429 & and_3463;
  logic [7:0] sum_3468;
  assign sum_3468 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3467};
  // hls/stages/patches.hpp:640
  logic and_3470;
  assign and_3470 = and_3439 & and_3463;
  logic [7:0] sum_3471;
  assign sum_3471 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3470};
  // hls/stages/agreement.hpp:1154
  logic equal_3472;
  assign equal_3472 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1072
  logic less_3473;
  assign less_3473 = x_s4_q[5:3] < 3'h3;
  // hls/stages/patches.hpp:330
  logic and_3477;
  assign and_3477 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & (equal_3472 & less_3473)));
  // hls/stages/agreement.hpp:1084
  logic and_3482;
  assign and_3482 = x_s4_q[6] & (not_1890_s4_q & (less_3473 & (x_s4_q[2:0] == 3'h1)));
  // hls/stages/patches.hpp:330
  logic and_3483;
  assign and_3483 = equal_1477_s4_q & and_3482;
  // hls/stages/patches.hpp:607
  logic [7:0] or_3485;
  assign or_3485 = (and_3477 ? patches_quarters_0_places_q : 8'h0) | (and_3483 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1084
  logic and_3489;
  assign and_3489 = x_s4_q[6] & (not_1890_s4_q & (less_3473 & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/patches.hpp:330
  logic and_3490;
  assign and_3490 = equal_1477_s4_q & and_3489;
  // hls/stages/agreement.hpp:1084
  logic and_3496;
  assign and_3496 = x_s4_q[6] & (not_1890_s4_q & (less_3473 & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:330
  logic and_3497;
  assign and_3497 = equal_1477_s4_q & and_3496;
  // hls/stages/patches.hpp:607
  logic [7:0] or_3499;
  assign or_3499 = (or_3485 | (and_3490 ? patches_quarters_2_places_q : 8'h0)) | (and_3497 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:191
  logic select_3503;
  assign select_3503 = (x_s4_q[5:3] == 3'h2) ? x_s4_q[1] : (x_s4_q[0] & (x_s4_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:330
  logic and_3507;
  assign and_3507 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & (less_3473 & select_3503)));
  // hls/stages/patches.hpp:608
  logic [7:0] select_3509;
  assign select_3509 = and_3477 ? (and_3507 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3511;
  assign select_3511 = and_3483 ? (and_3507 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3514;
  assign select_3514 = and_3490 ? (and_3507 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3517;
  assign select_3517 = and_3497 ? (and_3507 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:609
  logic [7:0] select_3520;
  assign select_3520 = and_3477 ? (and_3507 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3522;
  assign select_3522 = and_3483 ? (and_3507 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3525;
  assign select_3525 = and_3490 ? (and_3507 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3528;
  assign select_3528 = and_3497 ? (and_3507 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:194
  logic [4:0] sum_3530;
  assign sum_3530 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1084
  logic and_3534;
  assign and_3534 = x_s4_q[6] & (not_1890_s4_q & (less_3473 & (sum_3530[4:2] == 3'h0)));
  // hls/stages/patches.hpp:330
  logic and_3535;
  assign and_3535 = equal_1477_s4_q & and_3534;
  // hls/stages/patches.hpp:604
  logic [7:0] select_3538;
  assign select_3538 = and_3535 ? (patches_word_places_q + (and_3483 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3541;
  assign select_3541 = and_3535 ? (patches_word_up_q + (and_3483 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3544;
  assign select_3544 = and_3535 ? (patches_word_down_q + (and_3483 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3548;
  assign select_3548 = ($signed(difference_3422[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3422[5:0];
  logic [5:0] select_3549;
  assign select_3549 = ($signed(14'h10) < $signed(difference_3422)) ? 6'h10 : select_3548;
  // hls/stages/patches.hpp:546
  logic [5:0] select_3551;
  assign select_3551 = equal_1856_s4_q ? (or_3375 ? 6'h0 : select_3549) : 6'h0;
  logic [5:0] select_3553;
  assign select_3553 = less_1853_s4_q ? (equal_1854_s4_q ? 6'h0 : select_3551) : select_3551;
  // hls/stages/patches.hpp:642
  logic [5:0] select_3555;
  assign select_3555 = and_3380 ? (equal_1690_s4_q ? select_3553 : 6'h0) : 6'h0;
  logic [11:0] sum_3556;
  assign sum_3556 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3555[5]}}, select_3555};
  // hls/stages/patches.hpp:330
  logic and_3560;
  assign and_3560 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q & (equal_2665 & less_3473)));
  // hls/stages/agreement.hpp:1084
  logic and_3564;
  assign and_3564 = x_s4_q[6] & (not_1890_s4_q & (less_3473 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:330
  logic and_3565;
  assign and_3565 = equal_1477_s4_q & and_3564;
  // hls/stages/patches.hpp:629
  logic [7:0] select_3567;
  assign select_3567 = and_3560 ? (and_3565 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:631
  logic or_3571;
  assign or_3571 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:632
  logic or_3574;
  assign or_3574 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:633
  logic [8:0] sum_3575;
  assign sum_3575 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:628
  logic select_3577;
  assign select_3577 = and_3560 ? (and_3565 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:330
  logic and_3582;
  assign and_3582 = equal_1477_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_3579_s4_q));
  // hls/stages/patches.hpp:180
  logic and_3584;
  assign and_3584 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:628
  logic [2:0] select_3586;
  assign select_3586 = and_3565 ? {and_3584, patches_found_q[2:1]} : (and_3560 ? {and_3584, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:627
  logic or_3590;
  assign or_3590 = patches_partly_q | (patches_doubted_q & (~and_3565));
  // hls/stages/patches.hpp:628
  logic select_3593;
  assign select_3593 = and_3560 ? (and_3565 ? or_3590 : (and_3560 ? or_3590 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:626
  logic select_3594;
  assign select_3594 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:617
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:618
  logic select_3604;
  assign select_3604 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:619
  logic and_3610;
  assign and_3610 = patches_frame_ended_q & (~patches_age_q[9]);
  logic [9:0] sum_3611;
  assign sum_3611 = patches_age_q + {9'h0, and_3610};
  logic [9:0] select_3614;
  assign select_3614 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3611)) : sum_3611;
  // hls/stages/agreement.hpp:1126
  logic or_3671;
  assign or_3671 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1148
  logic equal_3673;
  assign equal_3673 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1158
  logic select_3679;
  assign select_3679 = (equal_3673 & equal_3472) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_3682;
  assign sum_3682 = {1'b0, select_2463} + {2'h0, select_2463[9:1]};
  logic select_3685;
  assign select_3685 = (select_2460[9:3] == 7'h0) ? ((~or_3671) & (~select_3679)) : (~({sum_3682, select_2463[0]} < {2'h0, select_2460}));
  // hls/stages/agreement.hpp:1084
  logic [47:0] select_3687;
  assign select_3687 = x_s4_q[6] ? (equal_1522_s4_q ? good_q : {select_3685, good_q[47:1]}) : good_q;
  // hls/stages/patches.hpp:330
  logic select_3691;
  assign select_3691 = equal_1477_s4_q ? ((x_s4_q[6] & good_known_q) | equal_3579_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1148
  logic equal_3692;
  assign equal_3692 = x_s4_q[6:3] == 4'ha;
  logic equal_3694;
  assign equal_3694 = x_s4_q[6:3] == 4'h9;
  logic equal_3695;
  assign equal_3695 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3697;
  assign select_3697 = equal_3694 ? counts_skin_unproven_q : (equal_3695 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3692 ? counts_nearer_q : select_3697;
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1161
  logic select_3700;
  assign select_3700 = (equal_3692 & equal_3472) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1086
  logic not_3701;
  assign not_3701 = ~hidden_for_q[7];
  logic [7:0] select_3703;
  assign select_3703 = select_3700 ? (hidden_for_q + {7'h0, not_3701}) : 8'h0;
  // hls/stages/patches.hpp:330
  logic [7:0] select_3705;
  assign select_3705 = equal_1477_s4_q ? (equal_3579_s4_q ? select_3703 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3706;
  assign select_3706 = equal_3472 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_3708;
  assign select_3708 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3710;
  assign select_3710 = equal_3695 ? cfg_unproven_skin_limit_i : (equal_3673 ? cfg_unproven_limit_i : select_3708);
  logic [7:0] limit;
  assign limit = equal_3692 ? cfg_regions_limit_i : (equal_3694 ? cfg_hidden_limit_i : select_3710);
  // hls/stages/agreement.hpp:1161
  logic not_3713;
  assign not_3713 = ~x_s4_q[2];
  logic [3:0] select_3714;
  assign select_3714 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_3713, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_3713};
  logic [7:0] select_3715;
  assign select_3715 = x_s4_q[0] ? {select_3714[3], 1'b0, select_3714[2], 1'b0, select_3714[1], 1'b0, select_3714[0], 1'b0} : {1'b0, select_3714[3], 1'b0, select_3714[2], 1'b0, select_3714[1], 1'b0, select_3714[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_3719;
  assign select_3719 = equal_3694 ? counts_skin_supervised_q : (equal_3695 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3692 ? counts_textured_q : select_3719;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_3721;
  assign select_3721 = ((limit & select_3715) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3706} + {1'b0, select_3721};
  // hls/stages/patches.hpp:330
  logic select_3726;
  assign select_3726 = equal_1477_s4_q ? (equal_3472 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1159
  logic and_3731;
  assign and_3731 = too_much_q & (~(equal_3695 & equal_3472));
  // hls/stages/agreement.hpp:1160
  logic select_3736;
  assign select_3736 = (over[14] & equal_3472) ? (and_3731 | ((equal_3695 | equal_3694) | (x_s4_q[6:3] == 4'hf))) : and_3731;
  // hls/stages/agreement.hpp:1202
  logic select_3844;
  assign select_3844 = left_first_s4_q ? done_s4_q : proven_q;
  // hls/stages/agreement.hpp:265
  logic select_3846;
  assign select_3846 = left_first_s4_q ? done_s4_q : (and_1871_s4_q ? select_3844 : proven_q);
  // hls/stages/agreement.hpp:1235
  logic [1:0] select_3897;
  assign select_3897 = and_3896_s4_q ? {and_2021, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1236
  logic and_3898;
  assign and_3898 = select_3844 & less_3874;
  // hls/stages/agreement.hpp:424
  logic select_3901;
  assign select_3901 = and_1948_s4_q ? (less_1949_s4_q ? (select_3897[0] & and_3898) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:265
  logic select_3903;
  assign select_3903 = left_first_s4_q ? select_3901 : (and_1871_s4_q ? select_3901 : seen_q);
  logic select_3904;
  assign select_3904 = and_1871_s4_q ? select_3903 : seen_q;
  // hls/stages/agreement.hpp:424
  logic select_3907;
  assign select_3907 = and_1948_s4_q ? (less_1949_s4_q ? (select_3897[1] & and_3898) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:265
  logic select_3909;
  assign select_3909 = left_first_s4_q ? select_3907 : (and_1871_s4_q ? select_3907 : nearer_q);
  logic select_3910;
  assign select_3910 = and_1871_s4_q ? select_3909 : nearer_q;
  // hls/stages/agreement.hpp:1169
  logic or_3918;
  assign or_3918 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1171
  logic not_3926;
  assign not_3926 = ~(or_3671 | not_3911);
  // hls/stages/patches.hpp:330
  logic and_3930;
  assign and_3930 = equal_1477_s4_q & (equal_3579_s4_q & (not_3926 & (select_3679 | select_3736)));
  logic and_3933;
  assign and_3933 = equal_3579_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1088
  logic or_3937;
  assign or_3937 = select_2274 | (select_2286 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/patches.hpp:330
  logic and_3944;
  assign and_3944 = equal_1477_s4_q & (equal_3579_s4_q & (not_3926 & (select_2280 | select_2292)));
  // hls/stages/agreement.hpp:1088
  logic and_3949;
  assign and_3949 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3703 < cfg_hidden_frames_i));
  // hls/stages/patches.hpp:330
  logic and_3956;
  assign and_3956 = equal_1477_s4_q & (x_s4_q[6] & (not_1890_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_3964;
  assign select_3964 = equal_1544_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_3962_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_3965;
  assign select_3965 = equal_1542_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3964;
  logic [31:0] select_3966;
  assign select_3966 = equal_1540_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3965;
  logic [31:0] select_3967;
  assign select_3967 = equal_1538_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3966;
  logic [31:0] select_3968;
  assign select_3968 = equal_1536_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3967;
  logic [31:0] select_3969;
  assign select_3969 = equal_1534_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_3968;
  logic [31:0] select_3970;
  assign select_3970 = equal_1532_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_3969;
  logic [31:0] select_3971;
  assign select_3971 = equal_1530_s4_q ? {9'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_3970;
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_3972;
  assign select_3972 = less_2459 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1084
  logic [31:0] select_3973;
  assign select_3973 = equal_1522_s4_q ? select_3971 : {2'h0, select_3972, select_2463, select_2460};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_508_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s4_q, and_623, and_599_s4_q, and_598_s4_q, and_573_s4_q, less_565_s4_q, less_564_s4_q, less_563_s4_q, less_562_s4_q, less_561_s4_q, less_560_s4_q, less_559_s4_q, less_558_s4_q, less_557_s4_q, less_556_s4_q, less_555_s4_q, less_554_s4_q, less_553_s4_q, less_552_s4_q, less_551_s4_q, less_550_s4_q, less_549_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q, less_545_s4_q, less_544_s4_q, less_543_s4_q, less_542_s4_q};
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
      sharpness_sums_detail_0_q <= and_508_s4_q ? select_2202 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_508_s4_q ? select_2214 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_508_s4_q ? sum_2218 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_508_s4_q ? sum_2222 : sharpness_sums_contrast_1_q;
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
      counts_supervised_q <= select_2417;
      counts_textured_q <= and_2411_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2420});
      counts_explained_q <= and_2411_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2425});
      counts_nearer_q <= and_2411_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2430});
      counts_unproven_q <= and_2411_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2456});
      counts_regions_bad_q <= select_2472;
      counts_skin_supervised_q <= select_2479;
      counts_skin_textured_q <= select_2486;
      counts_skin_unproven_q <= select_2494;
      registration_half_across_q <= select_2546;
      registration_half_measured_q <= select_2551;
      registration_half_votes_down_q <= and_2526_s4_q ? 7'h0 : sum_2557;
      registration_half_votes_up_q <= and_2526_s4_q ? 7'h0 : sum_2565;
      registration_half_half_votes_down_q <= and_2526_s4_q ? 7'h0 : sum_2572;
      registration_half_half_votes_up_q <= and_2526_s4_q ? 7'h0 : sum_2579;
      registration_down_q <= and_2613 ? sum_2632 : registration_down_q;
      registration_up_q <= and_2613 ? sum_2641 : registration_up_q;
      registration_enough_q <= select_2655;
      registration_votes_down_q <= and_2660 ? less_2661 : registration_votes_down_q;
      registration_votes_up_q <= and_2660 ? less_2663 : registration_votes_up_q;
      registration_other_enough_q <= and_2669 ? select_2655 : registration_other_enough_q;
      registration_other_down_q <= and_2669 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2669 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1477_s4_q & and_2676)) & or_2701;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_1708 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_1710 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_1711 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2785;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_1737 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_1739 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_1740 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2790;
      patches_valid_0_q <= select_2795;
      patches_valid_1_q <= select_2800;
      patches_right_next_0_q <= select_2803;
      patches_right_next_1_q <= select_2806;
      patches_left_next_0_q <= select_2809;
      patches_left_next_1_q <= select_2812;
      patches_sums_values_0_q <= select_3236;
      patches_sums_values_1_q <= equal_1690_s4_q ? patches_sums_values_1_q : select_3237;
      patches_sums_values_2_q <= equal_1690_s4_q ? patches_sums_values_2_q : select_3239;
      patches_sums_values_3_q <= equal_1690_s4_q ? patches_sums_values_3_q : select_3241;
      patches_sums_values_4_q <= equal_1690_s4_q ? patches_sums_values_4_q : select_3243;
      patches_sums_values_5_q <= equal_1690_s4_q ? patches_sums_values_5_q : select_3245;
      patches_sums_values_6_q <= equal_1690_s4_q ? patches_sums_values_6_q : select_3247;
      patches_sums_values_7_q <= equal_1690_s4_q ? patches_sums_values_7_q : select_3249;
      patches_sums_values_8_q <= equal_1690_s4_q ? patches_sums_values_8_q : select_3251;
      patches_sums_values_9_q <= equal_1690_s4_q ? patches_sums_values_9_q : select_3253;
      patches_sums_values_10_q <= equal_1690_s4_q ? patches_sums_values_10_q : select_3255;
      patches_sums_values_11_q <= equal_1690_s4_q ? patches_sums_values_11_q : select_3257;
      patches_sums_values_12_q <= equal_1690_s4_q ? patches_sums_values_12_q : select_3259;
      patches_sums_values_13_q <= equal_1690_s4_q ? patches_sums_values_13_q : select_3261;
      patches_sums_values_14_q <= equal_1690_s4_q ? patches_sums_values_14_q : select_3263;
      patches_sums_values_15_q <= equal_1690_s4_q ? patches_sums_values_15_q : select_3265;
      patches_sums_values_16_q <= equal_1690_s4_q ? patches_sums_values_16_q : select_3267;
      patches_best_differing_q <= select_1878[9:0];
      patches_best_column_q <= select_1878[14:10];
      patches_quarters_0_places_q <= sum_3391;
      patches_quarters_0_up_q <= sum_3431;
      patches_quarters_0_down_q <= sum_3441;
      patches_quarters_1_places_q <= sum_3445;
      patches_quarters_1_up_q <= sum_3448;
      patches_quarters_1_down_q <= sum_3451;
      patches_quarters_2_places_q <= sum_3455;
      patches_quarters_2_up_q <= sum_3458;
      patches_quarters_2_down_q <= sum_3461;
      patches_quarters_3_places_q <= sum_3465;
      patches_quarters_3_up_q <= sum_3468;
      patches_quarters_3_down_q <= sum_3471;
      patches_word_places_q <= or_3499;
      patches_word_up_q <= ((select_3509 | select_3511) | select_3514) | select_3517;
      patches_word_down_q <= ((select_3520 | select_3522) | select_3525) | select_3528;
      patches_sum_places_q <= select_3538;
      patches_sum_up_q <= select_3541;
      patches_sum_down_q <= select_3544;
      patches_across_q <= sum_3556;
      patches_places_q <= select_3567;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3571;
      patches_partly_q <= or_3574;
      patches_clear_limit_q <= sum_3575[8:2];
      patches_complete_q <= select_3577;
      patches_frame_ended_q <= and_3582;
      patches_round_ends_q <= patches_complete_q & and_3582;
      patches_found_q <= and_3560 ? select_3586 : patches_found_q;
      patches_doubted_q <= select_3593;
      patches_doubted_before_q <= select_3594;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3604;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3614;
      segment_textured_q <= select_1901 + {5'h0, and_2420};
      segment_explained_q <= select_1906 + {5'h0, and_2425};
      segment_nearer_q <= select_1912 + {5'h0, and_2430};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1477_s4_q ? select_3687 : good_q;
      good_known_q <= select_3691;
      hidden_for_q <= select_3705;
      product_q <= equal_1477_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3726;
      disagree_q <= equal_1477_s4_q ? select_3679 : disagree_q;
      too_much_q <= equal_1477_s4_q ? select_3736 : too_much_q;
      hides_q <= equal_1477_s4_q ? select_3700 : hides_q;
      proven_q <= and_1871_s4_q ? select_3846 : proven_q;
      seen_q <= select_3904;
      nearer_q <= select_3910;
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
      census_changes_values_0_left_q <= and_508_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_508_s4_q ? sum_2164 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2166;
      census_changes_values_1_right_q <= select_2167;
      census_changes_values_2_left_q <= select_2168;
      census_changes_values_2_right_q <= select_2169;
      sharpness_last_mask_q <= and_508_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_508_s4_q ? select_2185[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_508_s4_q ? select_2185[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_3848_s5_q;
  logic or_3912_s5_q;
  logic and_3913_s5_q;
  logic and_3921_s5_q;
  logic and_3924_s5_q;
  logic and_3930_s5_q;
  logic and_3934_s5_q;
  logic and_3940_s5_q;
  logic and_3944_s5_q;
  logic and_3952_s5_q;
  logic and_3956_s5_q;
  logic [5:0] select_3958_s5_q;
  logic [31:0] select_3975_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= marks_last_s4_q;
      and_3848_s5_q <= said_q;
      or_3912_s5_q <= not_3911 | select_3904;
      and_3913_s5_q <= cfg_prove_i & select_3910;
      and_3921_s5_q <= equal_1477_s4_q & (equal_3579_s4_q & (cfg_prove_i & or_3918));
      and_3924_s5_q <= equal_1477_s4_q & (equal_3579_s4_q & (cfg_prove_i & or_3671));
      and_3930_s5_q <= and_3930;
      and_3934_s5_q <= equal_1477_s4_q & and_3933;
      and_3940_s5_q <= equal_1477_s4_q & (equal_3579_s4_q & (not_3926 & or_3937));
      and_3944_s5_q <= and_3944;
      and_3952_s5_q <= equal_1477_s4_q & (equal_3579_s4_q & (cfg_prove_i & and_3949));
      and_3956_s5_q <= and_3956;
      select_3958_s5_q <= equal_1477_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3975_s5_q <= equal_1477_s4_q ? (x_s4_q[6] ? select_3973 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_3912_s5_q;
  assign marks_nearer_o = and_3913_s5_q;
  assign verdict_valid_o = and_3848_s5_q;
  assign verdict_unproven_yet_o = and_3921_s5_q;
  assign verdict_untextured_o = and_3924_s5_q;
  assign verdict_disagree_o = and_3930_s5_q;
  assign verdict_moved_o = and_3934_s5_q;
  assign verdict_unsharp_left_o = and_3940_s5_q;
  assign verdict_unsharp_right_o = and_3944_s5_q;
  assign verdict_hidden_o = and_3952_s5_q;
  assign frame_valid_o = and_3956_s5_q;
  assign frame_index_o = select_3958_s5_q;
  assign frame_word_o = select_3975_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_3575[1:0], sum_3530[1:0], product_3421[4:0], sum_2516[0], detail_4[1:0], detail_3[1:0], sum_2174[4:0], sum_1630[0], sum_1626[0], sum_621[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
