// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2901 bits, pipeline 912 bits, memories 99800 bits.
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
  input  logic [5:0] cfg_patch_limit_i,
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
  logic [5:0] sum_2843;
  assign sum_2843 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3832;
  assign difference_3832 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_4080;
  assign difference_4080 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4282;
  assign less_4282 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4283;
  assign sum_4283 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_4301;
  assign not_4301 = ~cfg_prove_i;

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
  logic [2:0] select_465;
  assign select_465 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_467;
  assign select_467 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [8:0] select_470;
  assign select_470 = ({select_467, select_465} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_471;
  assign select_471 = select_465[0] ? averager_place_q : select_470;
  // hls/stages/census.hpp:41
  logic or_472;
  assign or_472 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_475;
  assign and_475 = (select_465[0] & or_472) & (select_471[8:6] < 3'h5);
  // hls/stages/census.hpp:41
  logic [2:0] select_480;
  assign select_480 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_467 : 7'h0;
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
  assign less_529 = {1'b0, last_q} < select_528;
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
  // hls/stages/agreement.hpp:141
  logic and_641;
  assign and_641 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_528)));
  logic and_642;
  assign and_642 = equal_524 & and_641;
  logic select_643;
  assign select_643 = or_522 ? not_530 : and_642;
  // hls/stages/agreement.hpp:778
  logic equal_646;
  assign equal_646 = {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:782
  logic or_648;
  assign or_648 = equal_646 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:794
  logic [6:0] right;
  assign right = sum_527[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:263
  logic [2:0] select_2493;
  assign select_2493 = sample_pair_whole_q ? (sample_last_q ? (select_480 + 3'h1) : select_480) : raster_at_y_q;
  logic [6:0] select_2495;
  assign select_2495 = sample_pair_whole_q ? (select_467 + {6'h0, equal_497}) : raster_at_column_q;
  logic [5:0] select_2498;
  assign select_2498 = sample_pair_whole_q ? (sample_last_q ? (select_560 + {5'h0, equal_498}) : select_560) : raster_at_row_q;
  logic select_2502;
  assign select_2502 = sample_pair_whole_q ? (sample_last_q ? (or_472 & (~raster_final_row_q)) : or_472) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2504;
  assign select_2504 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:263
  logic select_2508;
  assign select_2508 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2752;
  assign equal_2752 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:451
  logic and_2753;
  assign and_2753 = and_501 & equal_2752;
  // hls/stages/agreement.hpp:510
  logic select_2756;
  assign select_2756 = (and_2753 | (~ends_cell_q)) ? and_2753 : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2756 ? (and_2753 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2760;
  assign select_2760 = select_2756 ? (and_2753 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2763;
  assign select_2763 = select_2756 ? (following_last_shift_q & (~and_2753)) : run_last_shift_q;
  // hls/stages/agreement.hpp:594
  logic and_2766;
  assign and_2766 = run_last_shift_q & equal_524;
  // hls/stages/agreement.hpp:603
  logic select_2768;
  assign select_2768 = equal_524 ? (~run_last_shift_q) : equal_526;
  // hls/stages/agreement.hpp:607
  logic equal_2769;
  assign equal_2769 = run_phase_q == 3'h1;
  logic not_2772;
  assign not_2772 = ~select_2768;
  // hls/stages/agreement.hpp:610
  logic equal_2774;
  assign equal_2774 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2775;
  assign and_2775 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2776;
  assign select_2776 = equal_2774 ? 2'h1 : {2{and_2775}};
  logic [2:0] select_2778;
  assign select_2778 = (and_2766 | (select_2768 | equal_2769)) ? (equal_2769 ? 3'h2 : {not_2772, {2{select_2768}}}) : (equal_521 ? 3'h6 : {select_2776[0], select_2776});
  // hls/stages/agreement.hpp:594
  logic and_2781;
  assign and_2781 = select_2768 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2784;
  assign select_2784 = (plan_shift_q[5] & select_2768) ? value : 7'h0;
  logic [1:0] or_2785;
  assign or_2785 = {2{so}} | select_2784[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] or_2789;
  assign or_2789 = (select_2768 ? plan_columns_q : 8'h0) | ((equal_2769 | equal_2774) ? whole_q : 8'h0);
  logic [1:0] or_2790;
  assign or_2790 = {2{and_2766}} | or_2789[3:2];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_2792;
  assign or_2792 = {or_2789[7:4], or_2790, or_2789[1:0]} | (equal_521 ? drawn_q : 8'h0);
  logic [4:0] or_2793;
  assign or_2793 = {5{so}} | {or_2792[6], or_2792[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2797;
  assign not_2797 = ~run_shift_q[5];
  logic [7:0] select_2800;
  assign select_2800 = equal_524 ? ({{7{not_2797}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2804;
  assign select_2804 = and_2753 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2806;
  assign select_2806 = select_2756 ? {select_2804[6], select_2804} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2809;
  assign select_2809 = select_2756 ? (and_2753 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:507
  logic [6:0] select_2817;
  assign select_2817 = and_501 ? (equal_2752 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2820;
  assign select_2820 = and_501 ? (equal_2752 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2823;
  assign select_2823 = and_501 ? (equal_2752 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2834;
  assign select_2834 = (ends_cell_q | select_2756) ? (~(now == 3'h6)) : (equal_524 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2838;
  assign and_2838 = (~select_2756) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic [6:0] sum_2839;
  assign sum_2839 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:447
  logic select_2841;
  assign select_2841 = equal_2752 ? ({sum_2839[6], cfg_height_i[8:3]} == {1'b0, sum_2839[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:361
  logic or_3208;
  assign or_3208 = select_467[0] | select_560[5];
  logic [7:0] sum_3209;
  assign sum_3209 = {1'b0, select_467[2:1], or_3208, select_560[4:1]} + 8'h1;
  logic less_3210;
  assign less_3210 = {sum_3209, select_560[0], select_480, 1'b0} < {4'h0, cfg_height_i};

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1294; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 30'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_533;
  logic [29:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [28:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[28:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:1295; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 78'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (or_522 ? not_530 : select_617);
  logic [77:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [76:0] left_rdata_q;
  assign left_rdata_q = left_word_q[76:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:1296; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [91:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 92'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_524 ? sum_527[6:0] : x_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_523 & select_617);
  logic [91:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [90:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[90:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 46 and parity, DISTANCE 12, hls/stages/agreement.hpp:1297; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [46:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 47'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_522 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_643;
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
      raster_at_x_q <= sample_pair_whole_q ? (select_465 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2493;
      raster_at_column_q <= select_2495;
      raster_at_row_q <= select_2498;
      raster_at_live_q <= select_2502;
      raster_rows_left_q <= sample_pair_whole_q ? select_2504 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2508;
      averager_place_q <= sample_pair_whole_q ? select_471 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2760;
      run_last_shift_q <= select_2763;
      run_span_q <= select_2756 ? (and_2753 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2778;
      following_shift_q <= select_2768 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2781;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2784[6], or_2785, select_2784[3:0]};
      following_columns_q <= {or_2792[7], or_2793[4], or_2792[5:4], or_2793[3:0]};
      plan_shift_q <= equal_524 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2800;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2806;
      columns_left_q <= select_2809;
      last_q <= and_501 ? (equal_2752 ? column : last_q) : last_q;
      least_q <= select_2817;
      whole_q <= select_2820;
      drawn_q <= select_2823;
      age_q <= select_2756 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2756 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2834;
      ends_q <= and_2838;
      final_row_q <= and_501 ? select_2841 : final_row_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic sample_pair_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_present_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [6:0] last_s1_q;
  logic [3:0] age_s1_q;
  logic [2:0] slot_s1_q;
  logic ends_cell_s1_q;
  logic [2:0] select_465_s1_q;
  logic [6:0] select_467_s1_q;
  logic [8:0] select_471_s1_q;
  logic and_475_s1_q;
  logic equal_481_s1_q;
  logic [6:0] column_s1_q;
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
  logic and_1925_s1_q;
  logic [6:0] right_s1_q;
  logic select_1934_s1_q;
  logic equal_1943_s1_q;
  logic equal_2062_s1_q;
  logic equal_2752_s1_q;
  logic and_2753_s1_q;
  logic not_3211_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
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
      and_1925_s1_q <= not_523 & and_642;
      right_s1_q <= right;
      select_1934_s1_q <= or_648 ? equal_646 : ({x[7], last_q} == {1'b0, x[6:0]});
      equal_1943_s1_q <= run_phase_q == 3'h7;
      equal_2062_s1_q <= {or_472, select_480} == 4'hc;
      equal_2752_s1_q <= equal_2752;
      and_2753_s1_q <= and_2753;
      not_3211_s1_q <= ~less_3210;
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
  // hls/stages/agreement.hpp:762
  logic [5:0] select_902;
  assign select_902 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_903;
  assign difference_903 = {1'b0, column_2} - {1'b0, select_902};
  logic [7:0] sum_905;
  assign sum_905 = {difference_903[6], difference_903} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] select_909;
  assign select_909 = and_656 ? (and_680 ? (~(select_681 ^ select_659)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_915;
  assign parity_915 = ^select_909[5:3];
  logic parity_918;
  assign parity_918 = ^select_909[8:6];
  logic parity_921;
  assign parity_921 = ^select_909[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_928;
  assign select_928 = and_679 ? (and_697 ? (~(select_698 ^ select_682)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_931;
  assign parity_931 = ^select_928[8:6];
  logic parity_934;
  assign parity_934 = ^select_928[11:9];
  // hls/stages/agreement.hpp:212
  logic and_938;
  assign and_938 = right_codes_rdata_q[77] & not_530_s1_q;
  logic [11:0] select_939;
  assign select_939 = less_529_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_943;
  assign select_943 = and_696 ? (and_938 ? (~(select_939 ^ select_699)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_949;
  assign parity_949 = ^select_943[2:0];
  logic parity_952;
  assign parity_952 = ^select_943[5:3];
  logic parity_955;
  assign parity_955 = ^select_943[8:0];
  logic parity_961;
  assign parity_961 = ^select_943[11:9];
  logic parity_964;
  assign parity_964 = ^select_928[2:0];
  logic parity_967;
  assign parity_967 = ^{select_943[11:9], select_928[5:0]};
  logic parity_970;
  assign parity_970 = ^{select_943, select_928, select_909[2:0]};
  logic xor_971;
  assign xor_971 = parity_921 ^ parity_970;
  // hls/stages/count_bits.hpp:23
  logic or_975;
  assign or_975 = (select_909[1:0] == 2'h3) | (select_909[2] & (select_909[0] | select_909[1]));
  // hls/stages/count_bits.hpp:25
  logic or_979;
  assign or_979 = (select_928[7:6] == 2'h3) | (select_928[8] & (select_928[6] | select_928[7]));
  logic or_983;
  assign or_983 = (select_928[10:9] == 2'h3) | (select_928[11] & (select_928[9] | select_928[10]));
  // hls/stages/count_bits.hpp:23
  logic or_991;
  assign or_991 = (select_943[7:6] == 2'h3) | (select_943[8] & (~(select_943[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_995;
  assign or_995 = (select_943[1:0] == 2'h3) | (select_943[2] & (select_943[0] | select_943[1]));
  logic or_999;
  assign or_999 = (select_943[4:3] == 2'h3) | (select_943[5] & (select_943[3] | select_943[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1002;
  assign parity_1002 = ^{or_999, or_995, or_991};
  // hls/stages/count_bits.hpp:23
  logic or_1006;
  assign or_1006 = (select_928[4:3] == 2'h3) | (select_928[5] & (select_928[3] | select_928[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1010;
  assign or_1010 = (select_943[10:9] == 2'h3) | (select_943[11] & (select_943[9] | select_943[10]));
  logic or_1014;
  assign or_1014 = (select_928[1:0] == 2'h3) | (select_928[2] & (select_928[0] | select_928[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1017;
  assign parity_1017 = ^{or_1014, or_1010, or_1006};
  logic parity_1020;
  assign parity_1020 = ^{or_1014, or_1010, or_1006, or_999, or_995, or_991, or_983, or_979, or_975};
  // hls/stages/count_bits.hpp:25
  logic and_1021;
  assign and_1021 = parity_921 & parity_970;
  logic or_1025;
  assign or_1025 = (parity_915 & parity_918) | ((^select_909[11:9]) & (parity_915 | parity_918));
  logic and_1028;
  assign and_1028 = (^{select_928[11:6], select_909[2:0]}) & (parity_955 | parity_967);
  logic or_1029;
  assign or_1029 = (parity_955 & parity_967) | and_1028;
  // hls/stages/count_bits.hpp:23
  logic or_1036;
  assign or_1036 = (select_909[10:9] == 2'h3) | (select_909[11] & (select_909[9] | select_909[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1040;
  assign or_1040 = (select_909[4:3] == 2'h3) | (select_909[5] & (select_909[3] | select_909[4]));
  logic or_1044;
  assign or_1044 = (select_909[7:6] == 2'h3) | (select_909[8] & (select_909[6] | select_909[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1047;
  assign parity_1047 = ^{or_1044, or_1040, or_1036};
  // hls/stages/count_bits.hpp:25
  logic or_1051;
  assign or_1051 = (parity_931 & parity_934) | ((^select_909[2:0]) & (parity_931 | parity_934));
  logic or_1055;
  assign or_1055 = (parity_949 & parity_952) | ((^select_943[8:6]) & (parity_949 | parity_952));
  logic or_1059;
  assign or_1059 = (parity_961 & parity_964) | ((^select_928[5:3]) & (parity_961 | parity_964));
  // hls/stages/count_bits.hpp:24
  logic parity_1062;
  assign parity_1062 = ^{or_1059, or_1055, or_1051};
  logic parity_1065;
  assign parity_1065 = ^{or_1059, or_1055, or_1051, or_1044, or_1040, or_1036, or_1029, or_1025, and_1021};
  logic xor_1066;
  assign xor_1066 = parity_1020 ^ parity_1065;
  // hls/stages/count_bits.hpp:25
  logic and_1067;
  assign and_1067 = parity_1020 & parity_1065;
  logic or_1071;
  assign or_1071 = (parity_1002 & parity_1017) | ((^{or_983, or_979, or_975}) & (parity_1002 | parity_1017));
  logic or_1075;
  assign or_1075 = (parity_1047 & parity_1062) | ((^{or_1029, or_1025, and_1021}) & (parity_1047 | parity_1062));
  logic or_1082;
  assign or_1082 = (or_979 & or_983) | (or_975 & (or_979 | or_983));
  logic or_1086;
  assign or_1086 = (or_995 & or_999) | (or_991 & (or_995 | or_999));
  logic or_1090;
  assign or_1090 = (or_1010 & or_1014) | (or_1006 & (or_1010 | or_1014));
  // hls/stages/count_bits.hpp:24
  logic parity_1093;
  assign parity_1093 = ^{or_1090, or_1086, or_1082};
  // hls/stages/count_bits.hpp:25
  logic or_1097;
  assign or_1097 = (or_1025 & or_1029) | (and_1021 & (or_1025 | or_1029));
  logic or_1101;
  assign or_1101 = (or_1040 & or_1044) | (or_1036 & (or_1040 | or_1044));
  logic or_1105;
  assign or_1105 = (or_1055 & or_1059) | (or_1051 & (or_1055 | or_1059));
  // hls/stages/count_bits.hpp:24
  logic parity_1108;
  assign parity_1108 = ^{or_1105, or_1101, or_1097};
  logic parity_1111;
  assign parity_1111 = ^{or_1105, or_1101, or_1097, or_1090, or_1086, or_1082, or_1075, or_1071, and_1067};
  // hls/stages/count_bits.hpp:25
  logic or_1115;
  assign or_1115 = (parity_1093 & parity_1108) | ((^{or_1075, or_1071, and_1067}) & (parity_1093 | parity_1108));
  logic or_1119;
  assign or_1119 = (or_1071 & or_1075) | (and_1067 & (or_1071 | or_1075));
  logic or_1123;
  assign or_1123 = (or_1086 & or_1090) | (or_1082 & (or_1086 | or_1090));
  logic or_1127;
  assign or_1127 = (or_1101 & or_1105) | (or_1097 & (or_1101 | or_1105));
  // hls/stages/count_bits.hpp:24
  logic parity_1132;
  assign parity_1132 = ^{or_1127, or_1123, or_1119, or_1115};
  // hls/stages/count_bits.hpp:25
  logic or_1136;
  assign or_1136 = (or_1123 & or_1127) | (or_1119 & (or_1123 | or_1127));
  logic and_1137;
  assign and_1137 = or_1115 & (^{or_1127, or_1123, or_1119});
  // hls/stages/count_bits.hpp:24
  logic xor_1138;
  assign xor_1138 = or_1136 ^ and_1137;
  // hls/stages/count_bits.hpp:27
  logic and_1139;
  assign and_1139 = or_1136 & and_1137;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1140;
  assign select_1140 = equal_524_s1_q ? {and_1139, xor_1138, parity_1132, parity_1111, xor_1066, xor_971} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_522_s1_q ? 6'h0 : select_1140;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1142;
  assign select_1142 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1143;
  assign difference_1143 = {1'b0, column_3} - {1'b0, select_1142};
  logic [7:0] sum_1145;
  assign sum_1145 = {difference_1143[6], difference_1143} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:212
  logic and_1146;
  assign and_1146 = right_codes_rdata_q[25] & not_530_s1_q;
  logic [11:0] select_1147;
  assign select_1147 = less_529_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1151;
  assign select_1151 = and_656 ? (and_1146 ? (~(select_1147 ^ select_659)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1157;
  assign parity_1157 = ^select_1151[5:3];
  logic parity_1160;
  assign parity_1160 = ^select_1151[8:6];
  logic parity_1163;
  assign parity_1163 = ^select_1151[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1170;
  assign select_1170 = and_679 ? (and_657 ? (~(select_658 ^ select_682)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1173;
  assign parity_1173 = ^select_1170[8:6];
  logic parity_1176;
  assign parity_1176 = ^select_1170[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1183;
  assign select_1183 = and_696 ? (and_680 ? (~(select_681 ^ select_699)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1189;
  assign parity_1189 = ^select_1183[2:0];
  logic parity_1192;
  assign parity_1192 = ^select_1183[5:3];
  logic parity_1195;
  assign parity_1195 = ^select_1183[8:0];
  logic parity_1201;
  assign parity_1201 = ^select_1183[11:9];
  logic parity_1204;
  assign parity_1204 = ^select_1170[2:0];
  logic parity_1207;
  assign parity_1207 = ^{select_1183[11:9], select_1170[5:0]};
  logic parity_1210;
  assign parity_1210 = ^{select_1183, select_1170, select_1151[2:0]};
  logic xor_1211;
  assign xor_1211 = parity_1163 ^ parity_1210;
  // hls/stages/count_bits.hpp:23
  logic or_1215;
  assign or_1215 = (select_1151[1:0] == 2'h3) | (select_1151[2] & (select_1151[0] | select_1151[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1219;
  assign or_1219 = (select_1170[7:6] == 2'h3) | (select_1170[8] & (select_1170[6] | select_1170[7]));
  logic or_1223;
  assign or_1223 = (select_1170[10:9] == 2'h3) | (select_1170[11] & (select_1170[9] | select_1170[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1231;
  assign or_1231 = (select_1183[7:6] == 2'h3) | (select_1183[8] & (~(select_1183[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1235;
  assign or_1235 = (select_1183[1:0] == 2'h3) | (select_1183[2] & (select_1183[0] | select_1183[1]));
  logic or_1239;
  assign or_1239 = (select_1183[4:3] == 2'h3) | (select_1183[5] & (select_1183[3] | select_1183[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1242;
  assign parity_1242 = ^{or_1239, or_1235, or_1231};
  // hls/stages/count_bits.hpp:23
  logic or_1246;
  assign or_1246 = (select_1170[4:3] == 2'h3) | (select_1170[5] & (select_1170[3] | select_1170[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1250;
  assign or_1250 = (select_1183[10:9] == 2'h3) | (select_1183[11] & (select_1183[9] | select_1183[10]));
  logic or_1254;
  assign or_1254 = (select_1170[1:0] == 2'h3) | (select_1170[2] & (select_1170[0] | select_1170[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1257;
  assign parity_1257 = ^{or_1254, or_1250, or_1246};
  logic parity_1260;
  assign parity_1260 = ^{or_1254, or_1250, or_1246, or_1239, or_1235, or_1231, or_1223, or_1219, or_1215};
  // hls/stages/count_bits.hpp:25
  logic and_1261;
  assign and_1261 = parity_1163 & parity_1210;
  logic or_1265;
  assign or_1265 = (parity_1157 & parity_1160) | ((^select_1151[11:9]) & (parity_1157 | parity_1160));
  logic and_1268;
  assign and_1268 = (^{select_1170[11:6], select_1151[2:0]}) & (parity_1195 | parity_1207);
  logic or_1269;
  assign or_1269 = (parity_1195 & parity_1207) | and_1268;
  // hls/stages/count_bits.hpp:23
  logic or_1276;
  assign or_1276 = (select_1151[10:9] == 2'h3) | (select_1151[11] & (select_1151[9] | select_1151[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1280;
  assign or_1280 = (select_1151[4:3] == 2'h3) | (select_1151[5] & (select_1151[3] | select_1151[4]));
  logic or_1284;
  assign or_1284 = (select_1151[7:6] == 2'h3) | (select_1151[8] & (select_1151[6] | select_1151[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1287;
  assign parity_1287 = ^{or_1284, or_1280, or_1276};
  // hls/stages/count_bits.hpp:25
  logic or_1291;
  assign or_1291 = (parity_1173 & parity_1176) | ((^select_1151[2:0]) & (parity_1173 | parity_1176));
  logic or_1295;
  assign or_1295 = (parity_1189 & parity_1192) | ((^select_1183[8:6]) & (parity_1189 | parity_1192));
  logic or_1299;
  assign or_1299 = (parity_1201 & parity_1204) | ((^select_1170[5:3]) & (parity_1201 | parity_1204));
  // hls/stages/count_bits.hpp:24
  logic parity_1302;
  assign parity_1302 = ^{or_1299, or_1295, or_1291};
  logic parity_1305;
  assign parity_1305 = ^{or_1299, or_1295, or_1291, or_1284, or_1280, or_1276, or_1269, or_1265, and_1261};
  logic xor_1306;
  assign xor_1306 = parity_1260 ^ parity_1305;
  // hls/stages/count_bits.hpp:25
  logic and_1307;
  assign and_1307 = parity_1260 & parity_1305;
  logic or_1311;
  assign or_1311 = (parity_1242 & parity_1257) | ((^{or_1223, or_1219, or_1215}) & (parity_1242 | parity_1257));
  logic or_1315;
  assign or_1315 = (parity_1287 & parity_1302) | ((^{or_1269, or_1265, and_1261}) & (parity_1287 | parity_1302));
  logic or_1322;
  assign or_1322 = (or_1219 & or_1223) | (or_1215 & (or_1219 | or_1223));
  logic or_1326;
  assign or_1326 = (or_1235 & or_1239) | (or_1231 & (or_1235 | or_1239));
  logic or_1330;
  assign or_1330 = (or_1250 & or_1254) | (or_1246 & (or_1250 | or_1254));
  // hls/stages/count_bits.hpp:24
  logic parity_1333;
  assign parity_1333 = ^{or_1330, or_1326, or_1322};
  // hls/stages/count_bits.hpp:25
  logic or_1337;
  assign or_1337 = (or_1265 & or_1269) | (and_1261 & (or_1265 | or_1269));
  logic or_1341;
  assign or_1341 = (or_1280 & or_1284) | (or_1276 & (or_1280 | or_1284));
  logic or_1345;
  assign or_1345 = (or_1295 & or_1299) | (or_1291 & (or_1295 | or_1299));
  // hls/stages/count_bits.hpp:24
  logic parity_1348;
  assign parity_1348 = ^{or_1345, or_1341, or_1337};
  logic parity_1351;
  assign parity_1351 = ^{or_1345, or_1341, or_1337, or_1330, or_1326, or_1322, or_1315, or_1311, and_1307};
  // hls/stages/count_bits.hpp:25
  logic or_1355;
  assign or_1355 = (parity_1333 & parity_1348) | ((^{or_1315, or_1311, and_1307}) & (parity_1333 | parity_1348));
  logic or_1359;
  assign or_1359 = (or_1311 & or_1315) | (and_1307 & (or_1311 | or_1315));
  logic or_1363;
  assign or_1363 = (or_1326 & or_1330) | (or_1322 & (or_1326 | or_1330));
  logic or_1367;
  assign or_1367 = (or_1341 & or_1345) | (or_1337 & (or_1341 | or_1345));
  // hls/stages/count_bits.hpp:24
  logic parity_1372;
  assign parity_1372 = ^{or_1367, or_1363, or_1359, or_1355};
  // hls/stages/count_bits.hpp:25
  logic or_1376;
  assign or_1376 = (or_1363 & or_1367) | (or_1359 & (or_1363 | or_1367));
  logic and_1377;
  assign and_1377 = or_1355 & (^{or_1367, or_1363, or_1359});
  // hls/stages/count_bits.hpp:24
  logic xor_1378;
  assign xor_1378 = or_1376 ^ and_1377;
  // hls/stages/count_bits.hpp:27
  logic and_1379;
  assign and_1379 = or_1376 & and_1377;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1380;
  assign select_1380 = equal_524_s1_q ? {and_1379, xor_1378, parity_1372, parity_1351, xor_1306, xor_1211} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_522_s1_q ? 6'h0 : select_1380;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1382;
  assign select_1382 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1383;
  assign difference_1383 = {1'b0, column_4} - {1'b0, select_1382};
  logic [7:0] sum_1385;
  assign sum_1385 = {difference_1383[6], difference_1383} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1393;
  assign select_1393 = and_656 ? (and_697 ? (~(select_698 ^ select_659)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1399;
  assign parity_1399 = ^select_1393[5:3];
  logic parity_1402;
  assign parity_1402 = ^select_1393[8:6];
  logic parity_1405;
  assign parity_1405 = ^select_1393[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1412;
  assign select_1412 = and_679 ? (and_938 ? (~(select_939 ^ select_682)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1415;
  assign parity_1415 = ^select_1412[8:6];
  logic parity_1418;
  assign parity_1418 = ^select_1412[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] xor_1424;
  assign xor_1424 = (less_529_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_699;
  logic [11:0] select_1427;
  assign select_1427 = and_696 ? ((right_codes_rdata_q[90] & not_530_s1_q) ? (~xor_1424) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1433;
  assign parity_1433 = ^select_1427[2:0];
  logic parity_1436;
  assign parity_1436 = ^select_1427[5:3];
  logic parity_1439;
  assign parity_1439 = ^select_1427[8:0];
  logic parity_1445;
  assign parity_1445 = ^select_1427[11:9];
  logic parity_1448;
  assign parity_1448 = ^select_1412[2:0];
  logic parity_1451;
  assign parity_1451 = ^{select_1427[11:9], select_1412[5:0]};
  logic parity_1454;
  assign parity_1454 = ^{select_1427, select_1412, select_1393[2:0]};
  logic xor_1455;
  assign xor_1455 = parity_1405 ^ parity_1454;
  // hls/stages/count_bits.hpp:23
  logic or_1459;
  assign or_1459 = (select_1393[1:0] == 2'h3) | (select_1393[2] & (select_1393[0] | select_1393[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1463;
  assign or_1463 = (select_1412[7:6] == 2'h3) | (select_1412[8] & (select_1412[6] | select_1412[7]));
  logic or_1467;
  assign or_1467 = (select_1412[10:9] == 2'h3) | (select_1412[11] & (select_1412[9] | select_1412[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1475;
  assign or_1475 = (select_1427[7:6] == 2'h3) | (select_1427[8] & (~(select_1427[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1479;
  assign or_1479 = (select_1427[1:0] == 2'h3) | (select_1427[2] & (select_1427[0] | select_1427[1]));
  logic or_1483;
  assign or_1483 = (select_1427[4:3] == 2'h3) | (select_1427[5] & (select_1427[3] | select_1427[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1486;
  assign parity_1486 = ^{or_1483, or_1479, or_1475};
  // hls/stages/count_bits.hpp:23
  logic or_1490;
  assign or_1490 = (select_1412[4:3] == 2'h3) | (select_1412[5] & (select_1412[3] | select_1412[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1494;
  assign or_1494 = (select_1427[10:9] == 2'h3) | (select_1427[11] & (select_1427[9] | select_1427[10]));
  logic or_1498;
  assign or_1498 = (select_1412[1:0] == 2'h3) | (select_1412[2] & (select_1412[0] | select_1412[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1501;
  assign parity_1501 = ^{or_1498, or_1494, or_1490};
  logic parity_1504;
  assign parity_1504 = ^{or_1498, or_1494, or_1490, or_1483, or_1479, or_1475, or_1467, or_1463, or_1459};
  // hls/stages/count_bits.hpp:25
  logic and_1505;
  assign and_1505 = parity_1405 & parity_1454;
  logic or_1509;
  assign or_1509 = (parity_1399 & parity_1402) | ((^select_1393[11:9]) & (parity_1399 | parity_1402));
  logic and_1512;
  assign and_1512 = (^{select_1412[11:6], select_1393[2:0]}) & (parity_1439 | parity_1451);
  logic or_1513;
  assign or_1513 = (parity_1439 & parity_1451) | and_1512;
  // hls/stages/count_bits.hpp:23
  logic or_1520;
  assign or_1520 = (select_1393[10:9] == 2'h3) | (select_1393[11] & (select_1393[9] | select_1393[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1524;
  assign or_1524 = (select_1393[4:3] == 2'h3) | (select_1393[5] & (select_1393[3] | select_1393[4]));
  logic or_1528;
  assign or_1528 = (select_1393[7:6] == 2'h3) | (select_1393[8] & (select_1393[6] | select_1393[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1531;
  assign parity_1531 = ^{or_1528, or_1524, or_1520};
  // hls/stages/count_bits.hpp:25
  logic or_1535;
  assign or_1535 = (parity_1415 & parity_1418) | ((^select_1393[2:0]) & (parity_1415 | parity_1418));
  logic or_1539;
  assign or_1539 = (parity_1433 & parity_1436) | ((^select_1427[8:6]) & (parity_1433 | parity_1436));
  logic or_1543;
  assign or_1543 = (parity_1445 & parity_1448) | ((^select_1412[5:3]) & (parity_1445 | parity_1448));
  // hls/stages/count_bits.hpp:24
  logic parity_1546;
  assign parity_1546 = ^{or_1543, or_1539, or_1535};
  logic parity_1549;
  assign parity_1549 = ^{or_1543, or_1539, or_1535, or_1528, or_1524, or_1520, or_1513, or_1509, and_1505};
  logic xor_1550;
  assign xor_1550 = parity_1504 ^ parity_1549;
  // hls/stages/count_bits.hpp:25
  logic and_1551;
  assign and_1551 = parity_1504 & parity_1549;
  logic or_1555;
  assign or_1555 = (parity_1486 & parity_1501) | ((^{or_1467, or_1463, or_1459}) & (parity_1486 | parity_1501));
  logic or_1559;
  assign or_1559 = (parity_1531 & parity_1546) | ((^{or_1513, or_1509, and_1505}) & (parity_1531 | parity_1546));
  logic or_1566;
  assign or_1566 = (or_1463 & or_1467) | (or_1459 & (or_1463 | or_1467));
  logic or_1570;
  assign or_1570 = (or_1479 & or_1483) | (or_1475 & (or_1479 | or_1483));
  logic or_1574;
  assign or_1574 = (or_1494 & or_1498) | (or_1490 & (or_1494 | or_1498));
  // hls/stages/count_bits.hpp:24
  logic parity_1577;
  assign parity_1577 = ^{or_1574, or_1570, or_1566};
  // hls/stages/count_bits.hpp:25
  logic or_1581;
  assign or_1581 = (or_1509 & or_1513) | (and_1505 & (or_1509 | or_1513));
  logic or_1585;
  assign or_1585 = (or_1524 & or_1528) | (or_1520 & (or_1524 | or_1528));
  logic or_1589;
  assign or_1589 = (or_1539 & or_1543) | (or_1535 & (or_1539 | or_1543));
  // hls/stages/count_bits.hpp:24
  logic parity_1592;
  assign parity_1592 = ^{or_1589, or_1585, or_1581};
  logic parity_1595;
  assign parity_1595 = ^{or_1589, or_1585, or_1581, or_1574, or_1570, or_1566, or_1559, or_1555, and_1551};
  // hls/stages/count_bits.hpp:25
  logic or_1599;
  assign or_1599 = (parity_1577 & parity_1592) | ((^{or_1559, or_1555, and_1551}) & (parity_1577 | parity_1592));
  logic or_1603;
  assign or_1603 = (or_1555 & or_1559) | (and_1551 & (or_1555 | or_1559));
  logic or_1607;
  assign or_1607 = (or_1570 & or_1574) | (or_1566 & (or_1570 | or_1574));
  logic or_1611;
  assign or_1611 = (or_1585 & or_1589) | (or_1581 & (or_1585 | or_1589));
  // hls/stages/count_bits.hpp:24
  logic parity_1616;
  assign parity_1616 = ^{or_1611, or_1607, or_1603, or_1599};
  // hls/stages/count_bits.hpp:25
  logic or_1620;
  assign or_1620 = (or_1607 & or_1611) | (or_1603 & (or_1607 | or_1611));
  logic and_1621;
  assign and_1621 = or_1599 & (^{or_1611, or_1607, or_1603});
  // hls/stages/count_bits.hpp:24
  logic xor_1622;
  assign xor_1622 = or_1620 ^ and_1621;
  // hls/stages/count_bits.hpp:27
  logic and_1623;
  assign and_1623 = or_1620 & and_1621;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1624;
  assign select_1624 = equal_524_s1_q ? {and_1623, xor_1622, parity_1616, parity_1595, xor_1550, xor_1455} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_522_s1_q ? 6'h0 : select_1624;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1626;
  assign select_1626 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1627;
  assign difference_1627 = {1'b0, column_5} - {1'b0, select_1626};
  logic [7:0] sum_1629;
  assign sum_1629 = {difference_1627[6], difference_1627} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] not_1633;
  assign not_1633 = ~((less_529_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_659);
  logic [11:0] select_1635;
  assign select_1635 = and_656 ? ((right_codes_rdata_q[12] & not_530_s1_q) ? not_1633 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1641;
  assign parity_1641 = ^select_1635[5:3];
  logic parity_1644;
  assign parity_1644 = ^select_1635[8:6];
  logic parity_1647;
  assign parity_1647 = ^select_1635[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1654;
  assign select_1654 = and_679 ? (and_1146 ? (~(select_1147 ^ select_682)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1657;
  assign parity_1657 = ^select_1654[8:6];
  logic parity_1660;
  assign parity_1660 = ^select_1654[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1667;
  assign select_1667 = and_696 ? (and_657 ? (~(select_658 ^ select_699)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1673;
  assign parity_1673 = ^select_1667[2:0];
  logic parity_1676;
  assign parity_1676 = ^select_1667[5:3];
  logic parity_1679;
  assign parity_1679 = ^select_1667[8:0];
  logic parity_1685;
  assign parity_1685 = ^select_1667[11:9];
  logic parity_1688;
  assign parity_1688 = ^select_1654[2:0];
  logic parity_1691;
  assign parity_1691 = ^{select_1667[11:9], select_1654[5:0]};
  logic parity_1694;
  assign parity_1694 = ^{select_1667, select_1654, select_1635[2:0]};
  logic xor_1695;
  assign xor_1695 = parity_1647 ^ parity_1694;
  // hls/stages/count_bits.hpp:23
  logic or_1699;
  assign or_1699 = (select_1635[1:0] == 2'h3) | (select_1635[2] & (select_1635[0] | select_1635[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1703;
  assign or_1703 = (select_1654[7:6] == 2'h3) | (select_1654[8] & (select_1654[6] | select_1654[7]));
  logic or_1707;
  assign or_1707 = (select_1654[10:9] == 2'h3) | (select_1654[11] & (select_1654[9] | select_1654[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1715;
  assign or_1715 = (select_1667[7:6] == 2'h3) | (select_1667[8] & (~(select_1667[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1719;
  assign or_1719 = (select_1667[1:0] == 2'h3) | (select_1667[2] & (select_1667[0] | select_1667[1]));
  logic or_1723;
  assign or_1723 = (select_1667[4:3] == 2'h3) | (select_1667[5] & (select_1667[3] | select_1667[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1726;
  assign parity_1726 = ^{or_1723, or_1719, or_1715};
  // hls/stages/count_bits.hpp:23
  logic or_1730;
  assign or_1730 = (select_1654[4:3] == 2'h3) | (select_1654[5] & (select_1654[3] | select_1654[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1734;
  assign or_1734 = (select_1667[10:9] == 2'h3) | (select_1667[11] & (select_1667[9] | select_1667[10]));
  logic or_1738;
  assign or_1738 = (select_1654[1:0] == 2'h3) | (select_1654[2] & (select_1654[0] | select_1654[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1741;
  assign parity_1741 = ^{or_1738, or_1734, or_1730};
  logic parity_1744;
  assign parity_1744 = ^{or_1738, or_1734, or_1730, or_1723, or_1719, or_1715, or_1707, or_1703, or_1699};
  // hls/stages/count_bits.hpp:25
  logic and_1745;
  assign and_1745 = parity_1647 & parity_1694;
  logic or_1749;
  assign or_1749 = (parity_1641 & parity_1644) | ((^select_1635[11:9]) & (parity_1641 | parity_1644));
  logic and_1752;
  assign and_1752 = (^{select_1654[11:6], select_1635[2:0]}) & (parity_1679 | parity_1691);
  logic or_1753;
  assign or_1753 = (parity_1679 & parity_1691) | and_1752;
  // hls/stages/count_bits.hpp:23
  logic or_1760;
  assign or_1760 = (select_1635[10:9] == 2'h3) | (select_1635[11] & (select_1635[9] | select_1635[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1764;
  assign or_1764 = (select_1635[4:3] == 2'h3) | (select_1635[5] & (select_1635[3] | select_1635[4]));
  logic or_1768;
  assign or_1768 = (select_1635[7:6] == 2'h3) | (select_1635[8] & (select_1635[6] | select_1635[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1771;
  assign parity_1771 = ^{or_1768, or_1764, or_1760};
  // hls/stages/count_bits.hpp:25
  logic or_1775;
  assign or_1775 = (parity_1657 & parity_1660) | ((^select_1635[2:0]) & (parity_1657 | parity_1660));
  logic or_1779;
  assign or_1779 = (parity_1673 & parity_1676) | ((^select_1667[8:6]) & (parity_1673 | parity_1676));
  logic or_1783;
  assign or_1783 = (parity_1685 & parity_1688) | ((^select_1654[5:3]) & (parity_1685 | parity_1688));
  // hls/stages/count_bits.hpp:24
  logic parity_1786;
  assign parity_1786 = ^{or_1783, or_1779, or_1775};
  logic parity_1789;
  assign parity_1789 = ^{or_1783, or_1779, or_1775, or_1768, or_1764, or_1760, or_1753, or_1749, and_1745};
  logic xor_1790;
  assign xor_1790 = parity_1744 ^ parity_1789;
  // hls/stages/count_bits.hpp:25
  logic and_1791;
  assign and_1791 = parity_1744 & parity_1789;
  logic or_1795;
  assign or_1795 = (parity_1726 & parity_1741) | ((^{or_1707, or_1703, or_1699}) & (parity_1726 | parity_1741));
  logic or_1799;
  assign or_1799 = (parity_1771 & parity_1786) | ((^{or_1753, or_1749, and_1745}) & (parity_1771 | parity_1786));
  logic or_1806;
  assign or_1806 = (or_1703 & or_1707) | (or_1699 & (or_1703 | or_1707));
  logic or_1810;
  assign or_1810 = (or_1719 & or_1723) | (or_1715 & (or_1719 | or_1723));
  logic or_1814;
  assign or_1814 = (or_1734 & or_1738) | (or_1730 & (or_1734 | or_1738));
  // hls/stages/count_bits.hpp:24
  logic parity_1817;
  assign parity_1817 = ^{or_1814, or_1810, or_1806};
  // hls/stages/count_bits.hpp:25
  logic or_1821;
  assign or_1821 = (or_1749 & or_1753) | (and_1745 & (or_1749 | or_1753));
  logic or_1825;
  assign or_1825 = (or_1764 & or_1768) | (or_1760 & (or_1764 | or_1768));
  logic or_1829;
  assign or_1829 = (or_1779 & or_1783) | (or_1775 & (or_1779 | or_1783));
  // hls/stages/count_bits.hpp:24
  logic parity_1832;
  assign parity_1832 = ^{or_1829, or_1825, or_1821};
  logic parity_1835;
  assign parity_1835 = ^{or_1829, or_1825, or_1821, or_1814, or_1810, or_1806, or_1799, or_1795, and_1791};
  // hls/stages/count_bits.hpp:25
  logic or_1839;
  assign or_1839 = (parity_1817 & parity_1832) | ((^{or_1799, or_1795, and_1791}) & (parity_1817 | parity_1832));
  logic or_1843;
  assign or_1843 = (or_1795 & or_1799) | (and_1791 & (or_1795 | or_1799));
  logic or_1847;
  assign or_1847 = (or_1810 & or_1814) | (or_1806 & (or_1810 | or_1814));
  logic or_1851;
  assign or_1851 = (or_1825 & or_1829) | (or_1821 & (or_1825 | or_1829));
  // hls/stages/count_bits.hpp:24
  logic parity_1856;
  assign parity_1856 = ^{or_1851, or_1847, or_1843, or_1839};
  // hls/stages/count_bits.hpp:25
  logic or_1860;
  assign or_1860 = (or_1847 & or_1851) | (or_1843 & (or_1847 | or_1851));
  logic and_1861;
  assign and_1861 = or_1839 & (^{or_1851, or_1847, or_1843});
  // hls/stages/count_bits.hpp:24
  logic xor_1862;
  assign xor_1862 = or_1860 ^ and_1861;
  // hls/stages/count_bits.hpp:27
  logic and_1863;
  assign and_1863 = or_1860 & and_1861;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1864;
  assign select_1864 = equal_524_s1_q ? {and_1863, xor_1862, parity_1856, parity_1835, xor_1790, xor_1695} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_522_s1_q ? 6'h0 : select_1864;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1866;
  assign select_1866 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1867;
  assign difference_1867 = {1'b0, column_6} - {1'b0, select_1866};
  logic [7:0] sum_1869;
  assign sum_1869 = {difference_1867[6], difference_1867} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:929
  logic [6:0] select_1929;
  assign select_1929 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:932
  logic and_1949;
  assign and_1949 = (or_522_s1_q & (left_rdata_q[61] & not_530_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1971;
  assign or_1971 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/patches.hpp:330
  logic [6:0] select_1982;
  assign select_1982 = so_s1_q ? x_s1_q[6:0] : (or_522_s1_q ? (less_529_s1_q ? 7'h0 : select_1929) : 7'h0);
  // hls/stages/patches.hpp:114
  logic and_2056;
  assign and_2056 = (select_465_s1_q == 3'h0) & (select_467_s1_q == 7'h0);
  // hls/stages/patches.hpp:382
  logic not_2057;
  assign not_2057 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_2060;
  assign not_2060 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:352
  logic and_2061;
  assign and_2061 = patches_capturing_q & not_2060;
  // hls/stages/patches.hpp:302
  logic equal_2064;
  assign equal_2064 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:117
  logic and_2069;
  assign and_2069 = (not_2057 & (patches_work_q == 3'h0)) & (~(and_2061 | ((~equal_2062_s1_q) | (~equal_2064))));
  // hls/stages/patches.hpp:520
  logic equal_2156;
  assign equal_2156 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:498
  logic not_2157;
  assign not_2157 = ~equal_2156;
  // hls/stages/patches.hpp:491
  logic equal_2158;
  assign equal_2158 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:444
  logic not_2159;
  assign not_2159 = ~equal_2158;
  // hls/stages/patches.hpp:485
  logic equal_2160;
  assign equal_2160 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:159
  logic equal_2161;
  assign equal_2161 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:520
  logic or_2162;
  assign or_2162 = equal_2160 | equal_2161;
  // hls/stages/patches.hpp:446
  logic not_2163;
  assign not_2163 = ~patches_second_q;
  // hls/stages/patches.hpp:363
  logic [4:0] select_2185;
  assign select_2185 = and_2069 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:118
  logic [4:0] select_2186;
  assign select_2186 = and_2056 ? select_2185 : patches_row_q;
  // hls/stages/patches.hpp:117
  logic and_2188;
  assign and_2188 = and_2061 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:118
  logic select_2192;
  assign select_2192 = and_2056 ? (and_2069 | (and_2061 & (~and_2188))) : patches_capturing_q;
  // hls/stages/patches.hpp:176
  logic and_2200;
  assign and_2200 = not_2157 & (not_2159 & (or_2162 & (patches_second_q & equal_2161)));
  // hls/stages/patches.hpp:159
  logic not_2217;
  assign not_2217 = ~equal_2161;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2233;
  assign select_2233 = and_2056 ? {select_2185[4], select_2185[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:444
  logic and_2243;
  assign and_2243 = not_2157 & (or_2162 & not_2159);
  // hls/stages/agreement.hpp:443
  logic [5:0] or_2627;
  assign or_2627 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:447
  logic select_2846;
  assign select_2846 = equal_2752_s1_q ? (~({row_s1_q, 1'b0} < {sum_2843, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_3035;
  assign and_3035 = and_501_s1_q & (equal_2752_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:308
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:118
  logic [3:0] select_3145;
  assign select_3145 = and_2056 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3146;
  assign select_3146 = sample_pair_whole_s1_q ? select_3145 : patches_phase_q;
  // hls/stages/patches.hpp:363
  logic and_3147;
  assign and_3147 = not_2060 & equal_2062_s1_q;
  logic [8:0] select_3148;
  assign select_3148 = and_3147 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3149;
  assign select_3149 = and_3147 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3150;
  assign select_3150 = sample_pair_first_s1_q ? select_3148 : select_3149;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3152;
  assign select_3152 = sample_pair_whole_s1_q ? (and_2056 ? select_3150[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3154;
  assign select_3154 = sample_pair_whole_s1_q ? (and_2056 ? select_3150[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3157;
  assign select_3157 = sample_pair_whole_s1_q ? (equal_2064 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3159;
  assign select_3159 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_2064}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:321
  logic equal_3160;
  assign equal_3160 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:322
  logic not_3161;
  assign not_3161 = ~equal_3160;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3163;
  assign select_3163 = sample_pair_whole_s1_q ? (phase + {not_3161, 1'b1, not_3161, equal_3160}) : patches_first_band_rows_to_next_q;
  logic select_3164;
  assign select_3164 = sample_pair_whole_s1_q ? equal_3160 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:457
  logic equal_3165;
  assign equal_3165 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:79
  logic [3:0] select_3169;
  assign select_3169 = equal_3165 ? ((select_3146 == 4'h6) ? 4'h0 : (select_3146 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3170;
  assign equal_3170 = select_3169 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_3173;
  assign select_3173 = equal_2752_s1_q ? (equal_3170 ? 4'h6 : (select_3169 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:79
  logic [4:0] select_3175;
  assign select_3175 = equal_3165 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_3177;
  assign select_3177 = equal_2752_s1_q ? (select_3175 + {4'h0, equal_3170}) : patches_choosing_number_q;
  logic select_3181;
  assign select_3181 = equal_2752_s1_q ? ((6'h2 < row_s1_q) & equal_3170) : patches_chooses_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_3184;
  assign select_3184 = and_501_s1_q ? (equal_2752_s1_q ? select_3175 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:118
  logic select_3213;
  assign select_3213 = and_2056 ? (and_2069 ? not_3211_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:383
  logic or_3252;
  assign or_3252 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:385
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:179
  logic and_3258;
  assign and_3258 = equal_2156 & not_2163;
  // hls/stages/patches.hpp:389
  logic and_3259;
  assign and_3259 = not_2217 & and_3258;
  logic [1:0] select_3261;
  assign select_3261 = equal_2158 ? 2'h0 : (equal_2160 ? 2'h3 : {equal_2161, and_3259});
  // hls/stages/patches.hpp:270
  logic equal_3263;
  assign equal_3263 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:268
  logic not_3264;
  assign not_3264 = ~equal_3263;
  // hls/stages/patches.hpp:270
  logic equal_3265;
  assign equal_3265 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:266
  logic not_3266;
  assign not_3266 = ~equal_3265;
  // hls/stages/patches.hpp:274
  logic not_3268;
  assign not_3268 = ~(patches_following_q == 3'h2);
  logic and_3271;
  assign and_3271 = (~(patches_following_q == 3'h1)) & not_3268;
  // hls/stages/patches.hpp:387
  logic [1:0] select_3272;
  assign select_3272 = equal_3265 ? 2'h2 : {and_3271, not_3268};
  logic [3:0] select_3273;
  assign select_3273 = equal_3263 ? 4'h2 : {select_3272, {2{not_3266}}};
  // hls/stages/patches.hpp:395
  logic not_3276;
  assign not_3276 = ~or_3252;
  // hls/stages/patches.hpp:384
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:396
  logic [11:0] select_3281;
  assign select_3281 = or_3252 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:179
  logic [4:0] select_3283;
  assign select_3283 = or_3252 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1298; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_522_s1_q ? select_1929 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_643_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:757; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s1_en & (not_2157 & (not_2159 & (or_2162 & (equal_2161 & not_2163))));
  logic [8:0] patches_right_0_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_word_q <= patches_right_0_mem[patches_right_0_raddr];
  end
  logic [7:0] patches_right_0_rdata_q;
  assign patches_right_0_rdata_q = patches_right_0_word_q[7:0];
  logic patches_right_0_read_q, patches_right_0_error;
  always_ff @(posedge clk_i) patches_right_0_read_q <= rst_ni & patches_right_0_re;
  assign patches_right_0_error = patches_right_0_read_q & ^patches_right_0_word_q;

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:757; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s1_en & and_2200;
  logic [8:0] patches_right_1_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_word_q <= patches_right_1_mem[patches_right_1_raddr];
  end
  logic [7:0] patches_right_1_rdata_q;
  assign patches_right_1_rdata_q = patches_right_1_word_q[7:0];
  logic patches_right_1_read_q, patches_right_1_error;
  always_ff @(posedge clk_i) patches_right_1_read_q <= rst_ni & patches_right_1_re;
  assign patches_right_1_error = patches_right_1_read_q & ^patches_right_1_word_q;

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:758; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s1_en & (not_2157 & (not_2159 & (not_2217 & or_2162)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:769; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 33'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s1_en & and_2243;
  logic [32:0] patches_columns_above_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_word_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end
  logic [31:0] patches_columns_above_rdata_q;
  assign patches_columns_above_rdata_q = patches_columns_above_word_q[31:0];
  logic patches_columns_above_read_q, patches_columns_above_error;
  always_ff @(posedge clk_i) patches_columns_above_read_q <= rst_ni & patches_columns_above_re;
  assign patches_columns_above_error = patches_columns_above_read_q & ^patches_columns_above_word_q;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s1_q[6:0];
  logic left_we;
  assign left_we = s1_en & and_533_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_625, left_rdata_q[59:45], and_624, left_rdata_q[43:29], and_623, left_rdata_q[27:13], and_622, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_533_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_634, right_codes_rdata_q[76:65], and_633, right_codes_rdata_q[63:52], and_632, right_codes_rdata_q[50:39], and_631, right_codes_rdata_q[37:26], and_630, right_codes_rdata_q[24:13], and_629, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_501_s1_q ? (equal_2752_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_501_s1_q ? select_2846 : lower_half_q;
      patches_phase_q <= select_3146;
      patches_band_rows_rows_to_next_q <= select_3152;
      patches_band_rows_number_q <= select_3154;
      patches_next_band_rows_to_next_q <= select_3157;
      patches_next_band_number_q <= select_3159;
      patches_first_band_rows_to_next_q <= select_3163;
      patches_first_band_number_q <= select_3164;
      patches_choosing_rows_to_next_q <= and_501_s1_q ? select_3173 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_501_s1_q ? select_3177 : patches_choosing_number_q;
      patches_chooses_q <= and_501_s1_q ? select_3181 : patches_chooses_q;
      patches_choosing_band_q <= select_3184;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_2192 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_3213 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_2186 : patches_row_q;
      patches_work_q <= or_3252 ? following : patches_work_q;
      patches_second_q <= not_2057 & (patches_second_q | (patches_ends_q & equal_2156));
      patches_following_q <= equal_2156 ? {2'h0, and_3258} : {equal_2158, select_3261};
      patches_following_beats_q <= {select_3273, not_3264};
      patches_begins_q <= sample_pair_whole_s1_q & (and_2056 & and_2188);
      patches_ends_q <= not_3276 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3281;
      patches_code_row_q <= select_3283;
      patches_column_q <= or_3252 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3276 & (patches_column_q == 5'h1e);
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
      middle_sum_sum_sums_values_0_q <= sum_905;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1145;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1385;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1629;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1869;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic sample_pair_whole_s2_q;
  logic sample_present_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [6:0] last_s2_q;
  logic [1:0] age_s2_q;
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
  logic [6:0] select_467_s2_q;
  logic [8:0] select_471_s2_q;
  logic and_475_s2_q;
  logic equal_481_s2_q;
  logic [6:0] column_s2_q;
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
  logic and_1925_s2_q;
  logic [6:0] right_s2_q;
  logic select_1934_s2_q;
  logic equal_1943_s2_q;
  logic and_1950_s2_q;
  logic and_1953_s2_q;
  logic and_1957_s2_q;
  logic or_1971_s2_q;
  logic [6:0] select_1982_s2_q;
  logic and_2056_s2_q;
  logic and_2069_s2_q;
  logic less_2083_s2_q;
  logic equal_2156_s2_q;
  logic not_2157_s2_q;
  logic equal_2158_s2_q;
  logic not_2159_s2_q;
  logic equal_2160_s2_q;
  logic equal_2161_s2_q;
  logic or_2162_s2_q;
  logic [4:0] select_2186_s2_q;
  logic select_2192_s2_q;
  logic [3:0] select_2233_s2_q;
  logic and_2243_s2_q;
  logic and_2482_s2_q;
  logic equal_2628_s2_q;
  logic equal_2752_s2_q;
  logic and_3036_s2_q;
  logic and_3038_s2_q;
  logic or_3252_s2_q;
  logic not_3276_s2_q;
  logic less_4058_s2_q;
  logic equal_4263_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= sample_pair_first_q;
      marks_last_s2_q <= sample_last_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      last_s2_q <= last_s1_q;
      age_s2_q <= age_s1_q[2:1];
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
      and_1925_s2_q <= and_1925_s1_q;
      right_s2_q <= right_s1_q;
      select_1934_s2_q <= select_1934_s1_q;
      equal_1943_s2_q <= equal_1943_s1_q;
      and_1950_s2_q <= not_530_s1_q & and_1949;
      and_1953_s2_q <= (or_522_s1_q & (left_rdata_q[62] & not_530_s1_q)) & and_1949;
      and_1957_s2_q <= not_530_s1_q & (or_522_s1_q & (left_rdata_q[63] & not_530_s1_q));
      or_1971_s2_q <= or_1971;
      select_1982_s2_q <= select_1982;
      and_2056_s2_q <= and_2056;
      and_2069_s2_q <= and_2069;
      less_2083_s2_q <= 5'h4 < row_q[5:1];
      equal_2156_s2_q <= equal_2156;
      not_2157_s2_q <= not_2157;
      equal_2158_s2_q <= equal_2158;
      not_2159_s2_q <= not_2159;
      equal_2160_s2_q <= equal_2160;
      equal_2161_s2_q <= equal_2161;
      or_2162_s2_q <= or_2162;
      select_2186_s2_q <= select_2186;
      select_2192_s2_q <= select_2192;
      select_2233_s2_q <= select_2233;
      and_2243_s2_q <= and_2243;
      and_2482_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2628_s2_q <= {column_s1_q[6], or_2627} == 7'h0;
      equal_2752_s2_q <= equal_2752_s1_q;
      and_3036_s2_q <= and_2753_s1_q & and_3035;
      and_3038_s2_q <= and_2753_s1_q & (~and_3035);
      or_3252_s2_q <= or_3252;
      not_3276_s2_q <= not_3276;
      less_4058_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4263_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic [15:0] patches_chance_q;
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
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
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
  // hls/stages/agreement.hpp:735
  logic less_1386;
  assign less_1386 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1387;
  assign select_1387 = less_1386 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1388;
  assign less_1388 = middle_sum_sum_sums_values_0_q < select_1387;
  logic [7:0] select_1389;
  assign select_1389 = less_1388 ? select_1387 : middle_sum_sum_sums_values_0_q;
  logic less_1870;
  assign less_1870 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1871;
  assign select_1871 = less_1870 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1872;
  assign less_1872 = select_1389 < select_1871;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_655 ? (less_1872 ? select_1871 : select_1389) : 8'h0;
  // hls/stages/agreement.hpp:783
  logic or_1876;
  assign or_1876 = select_650_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1877;
  assign select_1877 = or_1876 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:736
  logic or_1879;
  assign or_1879 = less_1386 | (~less_1388);
  logic [2:0] select_1880;
  assign select_1880 = less_1872 ? {less_1870, 2'h0} : {1'b0, or_1879, less_1388};
  // hls/stages/agreement.hpp:788
  logic [2:0] select_1881;
  assign select_1881 = or_1876 ? select_1880 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1882;
  assign select_1882 = or_1876 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:785
  logic equal_1883;
  assign equal_1883 = select_1880 == 3'h1;
  logic equal_1884;
  assign equal_1884 = select_1880 == 3'h2;
  logic not_1885;
  assign not_1885 = ~equal_1884;
  logic [1:0] select_1886;
  assign select_1886 = equal_1883 ? 2'h0 : {not_1885, equal_1884};
  logic [7:0] select_1887;
  assign select_1887 = select_1886[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1888;
  assign select_1888 = select_1886[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1890;
  assign select_1890 = or_1876 ? (select_1886[1] ? select_1887 : select_1888) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:786
  logic [2:0] select_1891;
  assign select_1891 = equal_1883 ? 3'h2 : {not_1885, {2{equal_1884}}};
  logic [7:0] select_1892;
  assign select_1892 = select_1891[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1893;
  assign select_1893 = select_1891[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic [7:0] select_1895;
  assign select_1895 = select_1891[2] ? sums_3_sum_sums_values_0_q : (select_1891[1] ? select_1892 : select_1893);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1896;
  assign select_1896 = or_1876 ? select_1895 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1898;
  assign sum_1898 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1899;
  assign sum_1899 = {1'b0, before_v} + sum_1898;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1901;
  assign sum_1901 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1902;
  assign sum_1902 = {1'b0, before_v_2} + sum_1901;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1904;
  assign sum_1904 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1905;
  assign sum_1905 = {1'b0, before_v_3} + sum_1904;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1907;
  assign select_1907 = (sum_1902 < sum_1905) ? sum_1905 : sum_1902;
  logic [6:0] select_1909;
  assign select_1909 = (sum_1899 < select_1907) ? select_1907 : sum_1899;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1911;
  assign sum_1911 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1912;
  assign sum_1912 = {1'b0, before_v_4} + sum_1911;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1914;
  assign sum_1914 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1915;
  assign sum_1915 = {1'b0, before_v_5} + sum_1914;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1917;
  assign select_1917 = (sum_1912 < sum_1915) ? sum_1915 : sum_1912;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_655 ? ((select_1909 < select_1917) ? select_1917 : select_1909) : 7'h0;
  // hls/stages/agreement.hpp:788
  logic or_1922;
  assign or_1922 = select_650_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:792
  logic [6:0] select_1923;
  assign select_1923 = or_1922 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1924;
  assign select_1924 = or_1922 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:797
  logic or_1936;
  assign or_1936 = select_1934_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1937;
  assign select_1937 = or_1936 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1938;
  assign select_1938 = or_1936 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1940;
  assign or_1940 = select_1934_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1941;
  assign select_1941 = or_1940 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1942;
  assign select_1942 = or_1940 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic not_1944;
  assign not_1944 = ~equal_1943_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1954;
  assign and_1954 = not_530_s2_q & and_1953_s2_q;
  // hls/stages/agreement.hpp:935
  logic select_1960;
  assign select_1960 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1963;
  assign difference_1963 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:943
  logic [9:0] sum_1964;
  assign sum_1964 = {difference_1963[8], difference_1963} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1966;
  assign and_1966 = (and_1953_s2_q & select_1960) & ({{22{sum_1964[9]}}, sum_1964} < 32'h3);
  logic and_1967;
  assign and_1967 = not_530_s2_q & and_1966;
  logic and_1973;
  assign and_1973 = not_530_s2_q & (and_1966 & or_1971_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1974;
  assign select_1974 = less_529_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_522_s2_q ? {select_1974, and_1973, and_1967, and_1957_s2_q, and_1954, and_1950_s2_q, not_530_s2_q} : 15'h0;
  // hls/stages/patches.hpp:330
  logic and_1976;
  assign and_1976 = ends_cell_s2_q & shift_2[0];
  logic and_1978;
  assign and_1978 = not_1944 & (so_s2_q & and_1976);
  // hls/stages/agreement.hpp:955
  logic [5:0] sum_2028;
  assign sum_2028 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2[0] & ({1'b0, sum_2028, last_s2_q[1]} < x_s2_q);
  // hls/stages/patches.hpp:95
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/registration.hpp:218
  logic [16:0] select_2086;
  assign select_2086 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2086[16:7])) ? 8'h7f : select_2086[7:0];
  // hls/stages/patches.hpp:96
  logic and_2109;
  assign and_2109 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:98
  logic equal_2110;
  assign equal_2110 = x_s2_q == 8'h0;
  // hls/stages/patches.hpp:94
  logic [9:0] sum_2116;
  assign sum_2116 = {2'h0, x_s2_q} + {{4{shift_2[11]}}, shift_2[11:6]};
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2118;
  assign sum_2118 = {sum_2116[9], sum_2116[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:964
  logic and_2121;
  assign and_2121 = ($signed(9'h0) < $signed(sum_2116[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2118, sum_2116[0]})));
  logic and_2122;
  assign and_2122 = (~(and_2109 | (equal_2110 | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2121;
  // hls/stages/patches.hpp:105
  logic equal_2149;
  assign equal_2149 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/patches.hpp:330
  logic and_2153;
  assign and_2153 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (and_2109 | equal_2149)));
  logic and_2154;
  assign and_2154 = not_1944 & and_2153;
  // hls/stages/patches.hpp:164
  logic [7:0] pixel;
  assign pixel = equal_2161_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2161_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:486
  logic less_2249;
  assign less_2249 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:487
  logic or_2250;
  assign or_2250 = equal_2160_s2_q | less_2249;
  // hls/stages/patches.hpp:490
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2255;
  assign select_2255 = equal_2160_s2_q ? patches_column_s2_q[0] : (or_2250 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2256;
  assign not_2256 = ~or_2250;
  // hls/stages/patches.hpp:487
  logic [4:0] sum_2257;
  assign sum_2257 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:489
  logic [4:0] select_2260;
  assign select_2260 = or_2250 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2257) + 5'h1) : sum_2257;
  // hls/stages/patches.hpp:491
  logic [4:0] select_2261;
  assign select_2261 = equal_2160_s2_q ? 5'h0 : select_2260;
  logic or_2262;
  assign or_2262 = equal_2160_s2_q | equal_2158_s2_q;
  // hls/stages/patches.hpp:467
  logic equal_2264;
  assign equal_2264 = patches_column_s2_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s2_q == 5'h11;
  logic equal_2266;
  assign equal_2266 = patches_column_s2_q == 5'h18;
  // hls/stages/patches.hpp:469
  logic and_2268;
  assign and_2268 = of_row & (~equal_2266);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2264 ? 2'h3 : {equal_2266, and_2268};
  // hls/stages/patches.hpp:455
  logic [8:0] sum_2271;
  assign sum_2271 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2272;
  assign sum_2272 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2271, pixel_2[0]} - {1'b0, sum_2272, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:457
  logic [11:0] sum_2274;
  assign sum_2274 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2275;
  assign sum_2275 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2274[11], sum_2274};
  logic [13:0] sum_2276;
  assign sum_2276 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2275, down_2[1]};
  logic [12:0] sum_2277;
  assign sum_2277 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2276[13:1];
  logic [14:0] sum_2278;
  assign sum_2278 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2277, sum_2276[0], down_2[0]};
  // hls/stages/patches.hpp:453
  logic [8:0] sum_2281;
  assign sum_2281 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2282;
  assign sum_2282 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2281};
  logic [10:0] sum_2283;
  assign sum_2283 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2282, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2284;
  assign sum_2284 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2283[10:1];
  // hls/stages/patches.hpp:454
  logic [11:0] smooth;
  assign smooth = {sum_2284, sum_2283[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:456
  logic [12:0] sum_2286;
  assign sum_2286 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2287;
  assign sum_2287 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2288;
  assign difference_2288 = {1'b0, sum_2286, smooth[0]} - {1'b0, sum_2287, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:468
  logic or_2294;
  assign or_2294 = (((patches_column_s2_q == 5'ha) | of_row) | equal_2266) | equal_2264;
  // hls/stages/patches.hpp:463
  logic and_2299;
  assign and_2299 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:176
  logic and_2303;
  assign and_2303 = not_2159_s2_q & (or_2162_s2_q & (or_2294 & (equal_2161_s2_q & and_2299)));
  // hls/stages/patches.hpp:164
  logic and_2313;
  assign and_2313 = (~(equal_2161_s2_q | (~and_2299))) & (~patches_column_s2_q[4]);
  // hls/stages/patches.hpp:176
  logic and_2317;
  assign and_2317 = not_2159_s2_q & (or_2162_s2_q & (and_2313 & (patches_column_s2_q == 5'hf)));
  // hls/stages/patches.hpp:532
  logic less_2319;
  assign less_2319 = patches_step_q[4:0] < 5'h11;
  logic equal_2320;
  assign equal_2320 = patches_step_q[6:5] == 2'h0;
  logic not_2321;
  assign not_2321 = ~equal_2320;
  logic equal_2322;
  assign equal_2322 = patches_step_q[6:5] == 2'h3;
  logic not_2323;
  assign not_2323 = ~equal_2322;
  // hls/stages/patches.hpp:546
  logic select_2326;
  assign select_2326 = equal_2322 ? (less_2319 & (less_2319 & not_2323)) : less_2319;
  // hls/stages/patches.hpp:176
  logic and_2329;
  assign and_2329 = equal_2156_s2_q & (less_2319 ? (not_2321 & select_2326) : select_2326);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2350;
  assign sum_2350 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/patches.hpp:330
  logic and_2486;
  assign and_2486 = ends_cell_s2_q & (and_2482_s2_q & (~({sum_2028, last_s2_q[1:0]} < x_s2_q)));
  // hls/stages/registration.hpp:76
  logic less_2933;
  assign less_2933 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2935;
  assign select_2935 = or_522_s2_q ? (less_529_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2937;
  assign select_2937 = or_522_s2_q ? (less_529_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2939;
  assign select_2939 = or_522_s2_q ? (less_529_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2937} - {1'b0, select_2939};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2941;
  assign select_2941 = rise[8] ? select_2937 : select_2939;
  logic [8:0] difference_2942;
  assign difference_2942 = {1'b0, select_2935} - {1'b0, select_2941};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2942[8] ? 8'h0 : difference_2942[7:0];
  // hls/stages/registration.hpp:37
  logic not_2944;
  assign not_2944 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2933 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2944};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2946;
  assign xor_2946 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2946};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2952;
  assign select_2952 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2933 ? {taken, 1'b1} : {not_2944, select_2952, not_2944};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2954;
  assign sum_2954 = {left, 1'b1} + {taken_2, less_2933};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2956;
  assign select_2956 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_3039;
  assign select_3039 = and_3038_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3041;
  assign select_3041 = and_3036_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3039[15]}}, select_3039});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3042;
  assign select_3042 = and_3038_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3042[15]}}, select_3042};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3044;
  assign select_3044 = and_3036_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_3045;
  assign and_3045 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_8;
  assign column_8 = registration_slope_q + (and_3045 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:83
  logic parity_3188;
  assign parity_3188 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_3189;
  assign select_3189 = equal_2752_s2_q ? {patches_chance_q[14:0], parity_3188} : patches_chance_q;
  // hls/stages/patches.hpp:100
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:101
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:102
  logic [5:0] select_3194;
  assign select_3194 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3194};
  // hls/stages/patches.hpp:330
  logic and_3200;
  assign and_3200 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:179
  logic select_3291;
  assign select_3291 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:176
  logic [11:0] select_3294;
  assign select_3294 = equal_2158_s2_q ? patches_smooth_values_0_q : (or_2162_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3296;
  assign select_3296 = or_2162_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3298;
  assign select_3298 = equal_2156_s2_q ? patches_smooth_values_1_q : (equal_2158_s2_q ? patches_smooth_values_1_q : select_3296);
  logic [11:0] select_3299;
  assign select_3299 = or_2162_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3301;
  assign select_3301 = equal_2156_s2_q ? patches_smooth_values_2_q : (equal_2158_s2_q ? patches_smooth_values_2_q : select_3299);
  logic [11:0] select_3302;
  assign select_3302 = or_2162_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3304;
  assign select_3304 = equal_2156_s2_q ? patches_smooth_values_3_q : (equal_2158_s2_q ? patches_smooth_values_3_q : select_3302);
  logic [10:0] select_3306;
  assign select_3306 = equal_2158_s2_q ? patches_down_values_0_q : (or_2162_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3309;
  assign select_3309 = equal_2158_s2_q ? patches_down_values_1_q : (or_2162_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3312;
  assign select_3312 = equal_2158_s2_q ? patches_down_values_2_q : (or_2162_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3315;
  assign select_3315 = equal_2158_s2_q ? patches_down_values_3_q : (or_2162_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:167
  logic and_3352;
  assign and_3352 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:403
  logic [4:0] select_3357;
  assign select_3357 = or_3252_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:405
  logic [3:0] select_3359;
  assign select_3359 = and_3352 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:176
  logic [4:0] select_3715;
  assign select_3715 = equal_2156_s2_q ? patches_summed_down_by_q : (equal_2158_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:542
  logic and_3748;
  assign and_3748 = less_2319 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:546
  logic select_3751;
  assign select_3751 = equal_2322 ? (less_2319 ? (not_2323 & and_3748) : and_3748) : and_3748;
  // hls/stages/patches.hpp:176
  logic select_3754;
  assign select_3754 = equal_2156_s2_q ? (less_2319 ? (not_2321 & select_3751) : select_3751) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_4070;
  assign select_4070 = so_s2_q ? (and_3045 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4072;
  assign sum_4072 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4073;
  assign select_4073 = sum_2350[5] ? {1'b1, sum_2350[4:0], region_across_rest_q[2:0]} : sum_4072;
  // hls/stages/agreement.hpp:447
  logic [8:0] select_4075;
  assign select_4075 = equal_2752_s2_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4078;
  assign select_4078 = equal_2752_s2_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_471_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_476;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
  end
  logic [25:0] averager_memory_rdata_q;
  assign averager_memory_rdata_q = averager_memory_word_q[25:0];
  logic averager_memory_read_q, averager_memory_error;
  always_ff @(posedge clk_i) averager_memory_read_q <= rst_ni & averager_memory_re;
  assign averager_memory_error = averager_memory_read_q & ^averager_memory_word_q;

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
  assign census_memory_re = s2_en & and_501_s2_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1299; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1978;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 29'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_2261, not_2256, select_2255};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & or_2262;
  logic [28:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [27:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[27:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [48:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 49'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s2_en & (not_2157_s2_q & (new_row & equal_2158_s2_q));
  logic [48:0] patches_left_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_word_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end
  logic [47:0] patches_left_codes_rdata_q;
  assign patches_left_codes_rdata_q = patches_left_codes_word_q[47:0];
  logic patches_left_codes_read_q, patches_left_codes_error;
  always_ff @(posedge clk_i) patches_left_codes_read_q <= rst_ni & patches_left_codes_re;
  assign patches_left_codes_error = patches_left_codes_read_q & ^patches_left_codes_word_q;

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:789; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [15:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 16'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s2_en & and_2329;
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1326; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1978;
  logic [18:0] seen_columns_word_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_word_q <= seen_columns_mem[seen_columns_raddr];
  end
  logic [17:0] seen_columns_rdata_q;
  assign seen_columns_rdata_q = seen_columns_word_q[17:0];
  logic seen_columns_read_q, seen_columns_error;
  always_ff @(posedge clk_i) seen_columns_read_q <= rst_ni & seen_columns_re;
  assign seen_columns_error = seen_columns_read_q & ^seen_columns_word_q;

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q;
  logic best_left_we;
  assign best_left_we = s2_en & and_1925_s2_q;
  logic [45:0] best_left_wdata;
  assign best_left_wdata = {select_1924, select_1923, select_1896, select_1890, select_1882, select_1881, select_1877};
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
  assign best_right_we = s2_en & and_1925_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_1942, select_1941, select_1938, select_1937};
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

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s2_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s2_en & and_2243_s2_q;
  logic [31:0] patches_columns_above_wdata;
  assign patches_columns_above_wdata = {patches_columns_above_rdata_q[23:0], pixel_2};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_columns_above_we) patches_columns_above_mem[patches_columns_above_waddr] <= {^patches_columns_above_wdata, patches_columns_above_wdata};
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
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      patches_chance_q <= 16'h1;
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
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s2_en) begin
      registration_displacement_over_q <= so_s2_q ? sum_2954[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2956;
      registration_slope_row_q <= select_3041;
      registration_slope_change_q <= select_3044;
      registration_slope_q <= so_s2_q ? column_8 : {registration_slope_row_q, 4'h0};
      patches_chance_q <= and_501_s2_q ? select_3189 : patches_chance_q;
      patches_along_ends_q <= not_3276_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3276_s2_q & select_3291;
      patches_smooth_values_0_q <= equal_2156_s2_q ? patches_smooth_values_0_q : select_3294;
      patches_smooth_values_1_q <= select_3298;
      patches_smooth_values_2_q <= select_3301;
      patches_smooth_values_3_q <= select_3304;
      patches_down_values_0_q <= equal_2156_s2_q ? patches_down_values_0_q : select_3306;
      patches_down_values_1_q <= equal_2156_s2_q ? patches_down_values_1_q : select_3309;
      patches_down_values_2_q <= equal_2156_s2_q ? patches_down_values_2_q : select_3312;
      patches_down_values_3_q <= equal_2156_s2_q ? patches_down_values_3_q : select_3315;
      patches_down_by_q <= or_3252_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3352});
      patches_along_q <= select_3357;
      patches_match_row_q <= or_3252_s2_q ? 4'h0 : select_3359;
      patches_summed_last_q <= not_2157_s2_q & (equal_2158_s2_q & and_3352);
      patches_summed_down_by_q <= select_3715;
      patches_step_q <= or_3252_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3754;
      region_across_rest_q <= select_4070;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4073;
      columns_begin_rest_q <= and_501_s2_q ? select_4075 : columns_begin_rest_q;
      columns_begin_back_q <= and_501_s2_q ? select_4078 : columns_begin_back_q;
    end
  end

  logic [7:0] pixel_0_s3_q;
  logic [7:0] pixel_1_s3_q;
  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_present_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic [2:0] slot_s3_q;
  logic ends_cell_s3_q;
  logic lower_half_s3_q;
  logic [11:0] registration_slope_s3_q;
  logic [4:0] patches_band_rows_number_s3_q;
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
  logic [6:0] select_467_s3_q;
  logic [8:0] select_471_s3_q;
  logic and_475_s3_q;
  logic and_476_s3_q;
  logic equal_481_s3_q;
  logic [6:0] column_s3_q;
  logic and_499_s3_q;
  logic and_501_s3_q;
  logic so_s3_q;
  logic equal_562_s3_q;
  logic equal_1943_s3_q;
  logic not_1944_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1978_s3_q;
  logic [6:0] select_1982_s3_q;
  logic and_1987_s3_q;
  logic right_2_s3_q;
  logic and_2056_s3_q;
  logic and_2069_s3_q;
  logic and_2082_s3_q;
  logic less_2083_s3_q;
  logic [7:0] change_s3_q;
  logic equal_2110_s3_q;
  logic and_2122_s3_q;
  logic equal_2149_s3_q;
  logic and_2154_s3_q;
  logic and_2155_s3_q;
  logic equal_2156_s3_q;
  logic equal_2158_s3_q;
  logic equal_2161_s3_q;
  logic or_2162_s3_q;
  logic [4:0] select_2186_s3_q;
  logic select_2192_s3_q;
  logic [3:0] select_2233_s3_q;
  logic less_2249_s3_q;
  logic new_row_s3_q;
  logic or_2262_s3_q;
  logic [1:0] of_row_2_s3_q;
  logic less_2279_s3_q;
  logic less_2280_s3_q;
  logic less_2289_s3_q;
  logic less_2290_s3_q;
  logic and_2304_s3_q;
  logic and_2313_s3_q;
  logic and_2318_s3_q;
  logic less_2319_s3_q;
  logic equal_2320_s3_q;
  logic not_2321_s3_q;
  logic equal_2322_s3_q;
  logic not_2323_s3_q;
  logic sum_2350_s3_q;
  logic textured_s3_q;
  logic and_2488_s3_q;
  logic equal_2628_s3_q;
  logic equal_2752_s3_q;
  logic less_2970_s3_q;
  logic and_3201_s3_q;
  logic less_3328_s3_q;
  logic equal_3671_s3_q;
  logic equal_3755_s3_q;
  logic less_4058_s3_q;
  logic equal_4263_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      pixel_0_s3_q <= pixel_0_s2_q;
      pixel_1_s3_q <= pixel_1_s2_q;
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[1];
      slot_s3_q <= slot_s2_q;
      ends_cell_s3_q <= ends_cell_s2_q;
      lower_half_s3_q <= lower_half_s2_q;
      registration_slope_s3_q <= registration_slope_q[27:16];
      patches_band_rows_number_s3_q <= patches_band_rows_number_s2_q;
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
      equal_1943_s3_q <= equal_1943_s2_q;
      not_1944_s3_q <= not_1944;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1978_s3_q <= and_1978;
      select_1982_s3_q <= select_1982_s2_q;
      and_1987_s3_q <= not_1944 & (so_s2_q ? and_1976 : (equal_521_s2_q & shift_2[4]));
      right_2_s3_q <= right_2;
      and_2056_s3_q <= and_2056_s2_q;
      and_2069_s3_q <= and_2069_s2_q;
      and_2082_s3_q <= not_1944 & (so_s2_q & (ends_cell_s2_q & (shift_2[0] & right_3)));
      less_2083_s3_q <= less_2083_s2_q;
      change_s3_q <= change;
      equal_2110_s3_q <= equal_2110;
      and_2122_s3_q <= and_2122;
      equal_2149_s3_q <= equal_2149;
      and_2154_s3_q <= and_2154;
      and_2155_s3_q <= patches_chooses_s2_q & and_2154;
      equal_2156_s3_q <= equal_2156_s2_q;
      equal_2158_s3_q <= equal_2158_s2_q;
      equal_2161_s3_q <= equal_2161_s2_q;
      or_2162_s3_q <= or_2162_s2_q;
      select_2186_s3_q <= select_2186_s2_q;
      select_2192_s3_q <= select_2192_s2_q;
      select_2233_s3_q <= select_2233_s2_q;
      less_2249_s3_q <= less_2249;
      new_row_s3_q <= new_row;
      or_2262_s3_q <= or_2262;
      of_row_2_s3_q <= of_row_2;
      less_2279_s3_q <= $signed(15'h100) < $signed(sum_2278);
      less_2280_s3_q <= $signed(sum_2278[14:8]) < $signed(7'h7f);
      less_2289_s3_q <= $signed(15'h100) < $signed(difference_2288);
      less_2290_s3_q <= $signed(difference_2288[14:8]) < $signed(7'h7f);
      and_2304_s3_q <= not_2157_s2_q & and_2303;
      and_2313_s3_q <= and_2313;
      and_2318_s3_q <= not_2157_s2_q & and_2317;
      less_2319_s3_q <= less_2319;
      equal_2320_s3_q <= equal_2320;
      not_2321_s3_q <= not_2321;
      equal_2322_s3_q <= equal_2322;
      not_2323_s3_q <= not_2323;
      sum_2350_s3_q <= sum_2350[5];
      textured_s3_q <= textured;
      and_2488_s3_q <= not_1944 & (so_s2_q & and_2486);
      equal_2628_s3_q <= equal_2628_s2_q;
      equal_2752_s3_q <= equal_2752_s2_q;
      less_2970_s3_q <= select_2937 < select_2939;
      and_3201_s3_q <= not_1944 & and_3200;
      less_3328_s3_q <= 4'he < patches_column_s2_q[4:1];
      equal_3671_s3_q <= patches_match_row_q == 4'h0;
      equal_3755_s3_q <= patches_step_q[6:5] == 2'h2;
      less_4058_s3_q <= less_4058_s2_q;
      equal_4263_s3_q <= equal_4263_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
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
  logic patches_fixed_q;
  logic patches_choice_valid_q;
  logic [7:0] patches_choice_column_q;
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
  assign equal_559 = column_s3_q == 7'h0;
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
  logic not_1983;
  assign not_1983 = ~so_s3_q;
  // hls/stages/patches.hpp:330
  logic and_1984;
  assign and_1984 = not_1983 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1070
  logic equal_1988;
  assign equal_1988 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1991;
  assign select_1991 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1084
  logic [3:0] select_1993;
  assign select_1993 = equal_1988 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1991});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1994;
  assign sum_1994 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:330
  logic [3:0] select_1995;
  assign select_1995 = equal_1943_s3_q ? select_1993 : {sum_1994, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:201
  logic equal_1996;
  assign equal_1996 = x_s3_q[5:0] == 6'h3f;
  logic equal_1998;
  assign equal_1998 = x_s3_q[5:0] == 6'h3e;
  logic equal_2000;
  assign equal_2000 = x_s3_q[5:0] == 6'h3d;
  logic equal_2002;
  assign equal_2002 = x_s3_q[5:0] == 6'h3c;
  logic equal_2004;
  assign equal_2004 = x_s3_q[5:0] == 6'h3b;
  logic equal_2006;
  assign equal_2006 = x_s3_q[5:0] == 6'h36;
  logic equal_2008;
  assign equal_2008 = x_s3_q[5:0] == 6'h35;
  logic equal_2010;
  assign equal_2010 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1116
  logic and_2014;
  assign and_2014 = (~equal_2004) & ((~equal_2006) & ((~equal_2008) & (~equal_2010)));
  logic and_2018;
  assign and_2018 = (~equal_1996) & ((~equal_1998) & ((~equal_2000) & ((~equal_2002) & and_2014)));
  // hls/stages/agreement.hpp:1071
  logic less_2019;
  assign less_2019 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2023;
  assign or_2023 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2034;
  assign sum_2034 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_2036;
  assign and_2036 = half_ends & ({{3{sum_2034[4]}}, sum_2034} < 8'h3);
  // hls/stages/patches.hpp:330
  logic and_2037;
  assign and_2037 = so_s3_q & and_2036;
  logic select_2038;
  assign select_2038 = equal_1943_s3_q ? (x_s3_q[6] & (equal_1988 ? and_2018 : (less_2019 & (~or_2023)))) : and_2037;
  // hls/stages/registration.hpp:258
  logic not_2040;
  assign not_2040 = ~lower_half_s3_q;
  logic [3:0] select_2041;
  assign select_2041 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_2040, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_2040};
  // hls/stages/patches.hpp:363
  logic [1:0] select_2070;
  assign select_2070 = and_2069_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2071;
  assign select_2071 = and_2069_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_2072;
  assign select_2072 = and_2056_s3_q ? {select_2071, select_2070[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:118
  logic [1:0] select_2073;
  assign select_2073 = and_2056_s3_q ? select_2070 : patches_fetch_q;
  logic equal_2074;
  assign equal_2074 = select_2073 == 2'h0;
  // hls/stages/registration.hpp:83
  logic equal_2084;
  assign equal_2084 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2084 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2090;
  assign select_2090 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2091;
  assign select_2091 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2092;
  assign sum_2092 = {{2{select_2090[6]}}, select_2090} + {select_2091[7], select_2091};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2093;
  assign select_2093 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2094;
  assign select_2094 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2095;
  assign sum_2095 = {{2{select_2093[7]}}, select_2093[7:1]} + {select_2094[7], select_2094};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2096;
  assign sum_2096 = {{3{sum_2092[8]}}, sum_2092[8:1]} + {sum_2095[8], sum_2095, select_2093[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2097;
  assign select_2097 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2098;
  assign select_2098 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2099;
  assign difference_2099 = {{2{select_2097[7]}}, select_2097[7:1]} - {select_2098[7], select_2098};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2100;
  assign sum_2100 = {difference_2099, select_2097[0]} + {sum_2096[10], sum_2096[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2084 ? {sum_2100, sum_2096[1]} : registration_expected_q;
  // hls/stages/patches.hpp:90
  logic [9:0] sum_2102;
  assign sum_2102 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:964
  logic and_2104;
  assign and_2104 = shift_2_s3_q[3] & ({{4{sum_2102[9]}}, sum_2102, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:330
  logic and_2125;
  assign and_2125 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_2083_s3_q & and_2104) & and_2122_s3_q));
  logic and_2127;
  assign and_2127 = not_1944_s3_q & (so_s3_q & and_2125);
  // hls/stages/patches.hpp:148
  logic and_2129;
  assign and_2129 = and_2127 & (~patches_fixed_q);
  // hls/stages/patches.hpp:330
  logic [7:0] select_2132;
  assign select_2132 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2133;
  assign select_2133 = equal_1943_s3_q ? 8'h0 : select_2132;
  logic [5:0] select_2135;
  assign select_2135 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_2137;
  assign select_2137 = equal_1943_s3_q ? 6'h0 : (so_s3_q ? select_2135 : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2138;
  assign sum_2138 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_2100[9]}}, sum_2100[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2141;
  assign select_2141 = ($signed(sum_2138[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2138[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2084 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2138[12:7])) ? 8'h7f : select_2141);
  // hls/stages/patches.hpp:330
  logic [7:0] select_2146;
  assign select_2146 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2147;
  assign select_2147 = equal_1943_s3_q ? 8'h0 : select_2146;
  // hls/stages/patches.hpp:333
  logic [22:0] select_2148;
  assign select_2148 = and_2129 ? {select_2147, select_2137, select_2133, and_2127} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:118
  logic [4:0] select_2169;
  assign select_2169 = and_2056_s3_q ? select_2071 : patches_band_q;
  // hls/stages/patches.hpp:343
  logic equal_2170;
  assign equal_2170 = {patches_choosing_band_s3_q, and_2082_s3_q} == {select_2169, select_2073[1]};
  // hls/stages/patches.hpp:472
  logic [2:0] sum_2270;
  assign sum_2270 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:476
  logic [1:0] sum_2308;
  assign sum_2308 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_2337;
  assign select_2337 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_2340;
  assign or_2340 = select_2337[7] | (~({select_2337[5], select_2337[3], select_2337[1]} == 3'h0));
  // hls/stages/agreement.hpp:991
  logic or_2343;
  assign or_2343 = select_2337[7] | (~({select_2337[6], select_2337[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:990
  logic or_2346;
  assign or_2346 = select_2337[7] | (~(select_2337[6:4] == 3'h0));
  // hls/stages/patches.hpp:330
  logic [5:0] select_2347;
  assign select_2347 = equal_1943_s3_q ? x_s3_q[5:0] : {region_row_q, or_2346, or_2343, or_2340};
  // hls/stages/agreement.hpp:1070
  logic not_2348;
  assign not_2348 = ~equal_1988;
  // hls/stages/agreement.hpp:1000
  logic or_2352;
  assign or_2352 = (~sum_2350_s3_q) | equal_2149_s3_q;
  // hls/stages/patches.hpp:330
  logic and_2355;
  assign and_2355 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_2352));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_2376;
  assign and_2376 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:960
  logic select_2377;
  assign select_2377 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_2377);
  // hls/stages/agreement.hpp:960
  logic select_2380;
  assign select_2380 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_2377 ? select_2380 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1202
  logic or_2383;
  assign or_2383 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1204
  logic [16:0] select_2385;
  assign select_2385 = marks_first_s3_q ? 17'h1 : (or_2383 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1203
  logic [8:0] select_2387;
  assign select_2387 = or_2383 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1211
  logic select_2389;
  assign select_2389 = cfg_compete_i ? (or_2383 & select_2385[16]) : (select_2387[8] & select_2385[9]);
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = select_2389 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1218
  logic [6:0] select_2392;
  assign select_2392 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2394;
  assign select_2394 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_2392});
  // hls/stages/agreement.hpp:1228
  logic equal_2395;
  assign equal_2395 = seen_x_q == 3'h7;
  logic [7:0] select_2397;
  assign select_2397 = select_2389 ? 8'h0 : (seen_column_q + {7'h0, equal_2395});
  // hls/stages/agreement.hpp:1235
  logic [12:0] index;
  assign index = select_2394 + {5'h0, select_2397};
  // hls/stages/agreement.hpp:1202
  logic select_2400;
  assign select_2400 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1188
  logic [7:0] sum_2401;
  assign sum_2401 = {1'b0, select_2400, 2'h0, select_2400, 1'b0, {2{select_2400}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1201
  logic not_2402;
  assign not_2402 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:422
  logic and_2404;
  assign and_2404 = not_2402 & (began_q | select_2389);
  // hls/stages/agreement.hpp:1229
  logic [2:0] select_2406;
  assign select_2406 = select_2389 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1234
  logic and_2408;
  assign and_2408 = and_2404 & (select_2406 == 3'h0);
  logic less_2409;
  assign less_2409 = select_2397 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1053
  logic [7:0] sum_2412;
  assign sum_2412 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2412[7]}}, sum_2412, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1188
  logic [7:0] sum_2414;
  assign sum_2414 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:976
  logic and_2415;
  assign and_2415 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_2416;
  assign and_2416 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_2417;
  assign and_2417 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_2418;
  assign and_2418 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_2420;
  assign sum_2420 = {1'b0, and_2417} + ({1'b0, textured_s3_q} + {1'b0, and_2418});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2415} + ({2'h0, and_2416} + {1'b0, sum_2420});
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_2423;
  assign select_2423 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2424;
  assign difference_2424 = {1'b0, textured_2} - {1'b0, select_2423};
  logic [4:0] t;
  assign t = {difference_2424[3], difference_2424} + (equal_2110_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_2429;
  assign select_2429 = shift_2_s3_q[0] ? (sum_2350_s3_q ? select_2337 : {select_2337[6:0], 1'b0}) : select_2337;
  // hls/stages/agreement.hpp:992
  logic or_2432;
  assign or_2432 = select_2429[7] | (~({select_2429[5], select_2429[3], select_2429[1]} == 3'h0));
  // hls/stages/agreement.hpp:976
  logic and_2449;
  assign and_2449 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_2450;
  assign and_2450 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_2451;
  assign and_2451 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_2452;
  assign and_2452 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_2454;
  assign sum_2454 = {1'b0, and_2451} + ({1'b0, shown} + {1'b0, and_2452});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2449} + ({2'h0, and_2450} + {1'b0, sum_2454});
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_2457;
  assign select_2457 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2458;
  assign difference_2458 = {1'b0, shown_2} - {1'b0, select_2457};
  logic [4:0] around;
  assign around = {difference_2458[3], difference_2458} + (equal_2110_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_2461;
  assign sum_2461 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:976
  logic and_2465;
  assign and_2465 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2466;
  assign and_2466 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2467;
  assign and_2467 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2468;
  assign and_2468 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_2470;
  assign sum_2470 = {1'b0, and_2467} + ({1'b0, near} + {1'b0, and_2468});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2465} + ({2'h0, and_2466} + {1'b0, sum_2470});
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_2473;
  assign select_2473 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2474;
  assign difference_2474 = {1'b0, near_2} - {1'b0, select_2473};
  logic [4:0] n;
  assign n = {difference_2474[3], difference_2474} + (equal_2110_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2520;
  assign select_2520 = sample_pair_whole_s3_q ? (and_499_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2522;
  assign select_2522 = sample_pair_whole_s3_q ? (and_499_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2541;
  assign select_2541 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2543;
  assign select_2543 = sample_pair_whole_s3_q ? (and_499_s3_q ? select_514 : averager_mask_q) : averager_mask_q;
  logic select_2545;
  assign select_2545 = sample_pair_whole_s3_q ? (and_499_s3_q ? select_518 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2546;
  assign select_2546 = and_501_s3_q ? select_507 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2547;
  assign select_2547 = and_501_s3_q ? select_511 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2549;
  assign select_2549 = and_501_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2550;
  assign select_2550 = and_501_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2551;
  assign select_2551 = and_501_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2552;
  assign select_2552 = and_501_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2553;
  assign select_2553 = and_501_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2554;
  assign select_2554 = and_501_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2555;
  assign select_2555 = and_501_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2556;
  assign select_2556 = and_501_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2557;
  assign select_2557 = and_501_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2558;
  assign select_2558 = and_501_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2559;
  assign select_2559 = and_501_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2560;
  assign select_2560 = and_501_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2561;
  assign select_2561 = and_501_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2562;
  assign select_2562 = and_501_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2563;
  assign select_2563 = and_501_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2564;
  assign select_2564 = and_501_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2565;
  assign select_2565 = and_501_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2566;
  assign select_2566 = and_501_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2567;
  assign select_2567 = and_501_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2568;
  assign select_2568 = and_501_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2569;
  assign select_2569 = and_501_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2570;
  assign select_2570 = and_501_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2571;
  assign select_2571 = and_501_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2572;
  assign select_2572 = and_501_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2573;
  assign select_2573 = and_501_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2574;
  assign select_2574 = and_501_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2575;
  assign select_2575 = and_501_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2576;
  assign select_2576 = and_501_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2577;
  assign select_2577 = and_501_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2578;
  assign select_2578 = and_501_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2579;
  assign select_2579 = and_501_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2580;
  assign select_2580 = and_501_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2581;
  assign select_2581 = and_501_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2582;
  assign select_2582 = and_501_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2583;
  assign select_2583 = and_501_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2584;
  assign select_2584 = and_501_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2585;
  assign select_2585 = and_501_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2586;
  assign select_2586 = and_501_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2587;
  assign select_2587 = and_501_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2588;
  assign select_2588 = and_501_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2589;
  assign select_2589 = and_501_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2590;
  assign select_2590 = and_501_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2591;
  assign select_2591 = and_501_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2592;
  assign select_2592 = and_501_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2593;
  assign select_2593 = and_501_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2594;
  assign select_2594 = and_501_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2595;
  assign select_2595 = and_501_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2596;
  assign select_2596 = and_501_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2597;
  assign select_2597 = and_501_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2598;
  assign select_2598 = and_501_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2599;
  assign select_2599 = and_501_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2600;
  assign select_2600 = and_501_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2601;
  assign select_2601 = and_501_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2603;
  assign difference_2603 = {1'b0, select_511} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2604;
  assign xor_2604 = difference_2603[8:0] ^ {9{difference_2603[9]}};
  logic [9:0] sum_2605;
  assign sum_2605 = {9'h0, difference_2603[9]} + {1'b0, xor_2604};
  logic [9:0] difference_2606;
  assign difference_2606 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2607;
  assign xor_2607 = difference_2606[8:0] ^ {9{difference_2606[9]}};
  logic [9:0] sum_2608;
  assign sum_2608 = {9'h0, difference_2606[9]} + {1'b0, xor_2607};
  logic [9:0] difference_2610;
  assign difference_2610 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2611;
  assign xor_2611 = difference_2610[8:0] ^ {9{difference_2610[9]}};
  logic [9:0] sum_2612;
  assign sum_2612 = {9'h0, difference_2610[9]} + {1'b0, xor_2611};
  logic [10:0] sum_2613;
  assign sum_2613 = ({1'b0, sum_2605} + {1'b0, sum_2608}) + {1'b0, sum_2612};
  logic [9:0] difference_2614;
  assign difference_2614 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2615;
  assign xor_2615 = difference_2614[8:0] ^ {9{difference_2614[9]}};
  logic [9:0] sum_2616;
  assign sum_2616 = {9'h0, difference_2614[9]} + {1'b0, xor_2615};
  logic [9:0] difference_2618;
  assign difference_2618 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2619;
  assign xor_2619 = difference_2618[8:0] ^ {9{difference_2618[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2649;
  assign difference_2649 = {1'b0, select_507} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2649[9]} + (difference_2649[8:0] ^ {9{difference_2649[9]}});
  logic [9:0] difference_2661;
  assign difference_2661 = {1'b0, select_511} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2661[9]} + (difference_2661[8:0] ^ {9{difference_2661[9]}});
  // hls/stages/agreement.hpp:507
  logic and_2849;
  assign and_2849 = and_501_s3_q & (equal_562_s3_q & equal_2752_s3_q);
  // hls/stages/patches.hpp:330
  logic and_2853;
  assign and_2853 = not_1944_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:976
  logic and_2873;
  assign and_2873 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2874;
  assign and_2874 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2875;
  assign and_2875 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2876;
  assign and_2876 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2878;
  assign sum_2878 = {1'b0, and_2875} + ({1'b0, explained} + {1'b0, and_2876});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2873} + ({2'h0, and_2874} + {1'b0, sum_2878});
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2881;
  assign select_2881 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2882;
  assign difference_2882 = {1'b0, explained_2} - {1'b0, select_2881};
  logic [4:0] e;
  assign e = {difference_2882[3], difference_2882} + (equal_2110_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2885;
  assign sum_2885 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/patches.hpp:330
  logic and_2914;
  assign and_2914 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2958;
  assign select_2958 = equal_1943_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2960;
  assign select_2960 = equal_1943_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2961;
  assign equal_2961 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:250
  logic and_2965;
  assign and_2965 = shift_2_s3_q[3] & less_2083_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2969;
  assign sum_2969 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2971;
  assign difference_2971 = {sum_2969, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2972;
  assign select_2972 = less_2970_s3_q ? difference_2971 : {sum_2969, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2973;
  assign select_2973 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2969, shift_2_s3_q[11], 5'h0} : select_2972;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2973[7]}}, select_2973} - {sum_2100[9], sum_2100, sum_2096[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2976;
  assign select_2976 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2976[11:7])) ? 12'h7f : select_2976;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2997;
  assign difference_2997 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2999;
  assign and_2999 = and_2965 & ($signed(difference_2997) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3012;
  assign less_3012 = $signed(difference_2997) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:330
  logic select_3020;
  assign select_3020 = so_s3_q ? (equal_2961 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_3023;
  assign select_3023 = so_s3_q ? (equal_2084 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3028;
  assign select_3028 = (sum_1994 == 2'h2) ? (registration_fresh_q & (~select_2041)) : registration_fresh_q;
  // hls/stages/patches.hpp:330
  logic [3:0] select_3030;
  assign select_3030 = so_s3_q ? (and_2036 ? select_3028 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3032;
  assign select_3032 = and_2849 ? 4'hf : (equal_1943_s3_q ? registration_fresh_q : select_3030);
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1991;
  // hls/stages/registration.hpp:258
  logic not_3053;
  assign not_3053 = ~quarter_2[1];
  logic [3:0] select_3054;
  assign select_3054 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3053, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3053};
  // hls/stages/patches.hpp:335
  logic not_3191;
  assign not_3191 = ~and_2154_s3_q;
  // hls/stages/patches.hpp:344
  logic not_3217;
  assign not_3217 = ~select_2073[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_3219;
  assign select_3219 = sample_pair_whole_s3_q ? (equal_2074 ? select_2073 : {not_3217, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:508
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:176
  logic [51:0] select_3318;
  assign select_3318 = or_2162_s3_q ? {less_2290_s3_q, less_2289_s3_q, less_2280_s3_q, less_2279_s3_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3320;
  assign select_3320 = equal_2156_s3_q ? patches_codes_at_q : (equal_2158_s3_q ? other[55:4] : select_3318);
  // hls/stages/patches.hpp:491
  logic [27:0] word;
  assign word = or_2262_s3_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:507
  logic [27:0] select_3323;
  assign select_3323 = (patches_along_s3_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:176
  logic [27:0] select_3325;
  assign select_3325 = equal_2158_s3_q ? (new_row_s3_q ? word : select_3323) : patches_codes_further_q;
  // hls/stages/patches.hpp:509
  logic [55:0] select_3327;
  assign select_3327 = less_2249_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:479
  logic [55:0] select_3329;
  assign select_3329 = less_3328_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:176
  logic [55:0] select_3331;
  assign select_3331 = or_2162_s3_q ? (equal_2161_s3_q ? patches_next_codes_q : select_3329) : patches_next_codes_q;
  logic [55:0] select_3333;
  assign select_3333 = equal_2156_s3_q ? patches_next_codes_q : (equal_2158_s3_q ? select_3327 : select_3331);
  // hls/stages/count_bits.hpp:24
  logic parity_3338;
  assign parity_3338 = ^{less_2290_s3_q, less_2289_s3_q, less_2280_s3_q, less_2279_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_3342;
  assign or_3342 = ({less_2280_s3_q, less_2279_s3_q} == 2'h3) | (less_2289_s3_q & (less_2280_s3_q | less_2279_s3_q));
  logic and_3343;
  assign and_3343 = less_2290_s3_q & (^{less_2289_s3_q, less_2280_s3_q, less_2279_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3344;
  assign xor_3344 = or_3342 ^ and_3343;
  // hls/stages/count_bits.hpp:27
  logic and_3345;
  assign and_3345 = or_3342 & and_3343;
  // hls/stages/patches.hpp:176
  logic [2:0] select_3347;
  assign select_3347 = or_2162_s3_q ? (and_2313_s3_q ? {and_3345, xor_3344, parity_3338} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:159
  logic [9:0] sum_3351;
  assign sum_3351 = {7'h0, patches_set_q} + (equal_2161_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:508
  logic [47:0] select_3361;
  assign select_3361 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:176
  logic [47:0] select_3363;
  assign select_3363 = equal_2156_s3_q ? patches_left_row_q : (equal_2158_s3_q ? select_3361 : patches_left_row_q);
  // hls/stages/patches.hpp:510
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3361;
  // hls/stages/count_bits.hpp:24
  logic xor_3367;
  assign xor_3367 = bits[17] ^ (^{select_3361[16:15], other[16:15]});
  logic xor_3370;
  assign xor_3370 = bits[11] ^ (^{select_3361[10:9], other[10:9]});
  logic xor_3373;
  assign xor_3373 = bits[14] ^ (^{select_3361[13:12], other[13:12]});
  logic xor_3376;
  assign xor_3376 = xor_3367 ^ (^{select_3361[14:9], other[14:9]});
  logic xor_3379;
  assign xor_3379 = bits[47] ^ (^{select_3361[46:45], other[46:45]});
  logic xor_3382;
  assign xor_3382 = bits[8] ^ (^{select_3361[7:6], other[7:6]});
  logic xor_3385;
  assign xor_3385 = bits[2] ^ (^{select_3361[1:0], other[1:0]});
  logic xor_3388;
  assign xor_3388 = bits[5] ^ (^{select_3361[4:3], other[4:3]});
  logic xor_3391;
  assign xor_3391 = xor_3382 ^ (^{select_3361[5:0], other[5:0]});
  logic parity_3393;
  assign parity_3393 = ^{select_3361[47:45], select_3361[8:0], other[47:45], other[8:0]};
  logic xor_3394;
  assign xor_3394 = xor_3376 ^ parity_3393;
  logic xor_3397;
  assign xor_3397 = bits[44] ^ (^{select_3361[43:42], other[43:42]});
  logic xor_3400;
  assign xor_3400 = bits[38] ^ (^{select_3361[37:36], other[37:36]});
  logic xor_3403;
  assign xor_3403 = bits[41] ^ (^{select_3361[40:39], other[40:39]});
  logic xor_3409;
  assign xor_3409 = bits[26] ^ (^{select_3361[25:24], other[25:24]});
  logic xor_3412;
  assign xor_3412 = bits[20] ^ (^{select_3361[19:18], other[19:18]});
  logic xor_3415;
  assign xor_3415 = bits[23] ^ (^{select_3361[22:21], other[22:21]});
  logic xor_3418;
  assign xor_3418 = xor_3409 ^ (^{select_3361[23:18], other[23:18]});
  logic xor_3421;
  assign xor_3421 = bits[35] ^ (^{select_3361[34:33], other[34:33]});
  logic xor_3424;
  assign xor_3424 = bits[29] ^ (^{select_3361[28:27], other[28:27]});
  logic xor_3427;
  assign xor_3427 = bits[32] ^ (^{select_3361[31:30], other[31:30]});
  logic xor_3430;
  assign xor_3430 = xor_3421 ^ (^{select_3361[32:27], other[32:27]});
  logic xor_3431;
  assign xor_3431 = xor_3418 ^ xor_3430;
  // hls/stages/count_bits.hpp:25
  logic or_3439;
  assign or_3439 = (xor_3370 & xor_3373) | (xor_3367 & (xor_3370 | xor_3373));
  logic or_3443;
  assign or_3443 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3447;
  assign or_3447 = (xor_3385 & xor_3388) | (xor_3382 & (xor_3385 | xor_3388));
  // hls/stages/count_bits.hpp:23
  logic or_3454;
  assign or_3454 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3458;
  assign or_3458 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3462;
  assign or_3462 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3465;
  assign parity_3465 = ^{or_3462, or_3458, or_3454};
  // hls/stages/count_bits.hpp:23
  logic or_3469;
  assign or_3469 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3473;
  assign or_3473 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3477;
  assign or_3477 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3480;
  assign parity_3480 = ^{or_3477, or_3473, or_3469};
  logic parity_3483;
  assign parity_3483 = ^{or_3477, or_3473, or_3469, or_3462, or_3458, or_3454, or_3447, or_3443, or_3439};
  // hls/stages/count_bits.hpp:23
  logic or_3487;
  assign or_3487 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3491;
  assign or_3491 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3495;
  assign or_3495 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3503;
  assign or_3503 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3507;
  assign or_3507 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3511;
  assign or_3511 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3514;
  assign parity_3514 = ^{or_3511, or_3507, or_3503};
  // hls/stages/count_bits.hpp:23
  logic or_3518;
  assign or_3518 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3522;
  assign or_3522 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3526;
  assign or_3526 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3529;
  assign parity_3529 = ^{or_3526, or_3522, or_3518};
  logic parity_3532;
  assign parity_3532 = ^{or_3526, or_3522, or_3518, or_3511, or_3507, or_3503, or_3495, or_3491, or_3487};
  // hls/stages/count_bits.hpp:25
  logic or_3536;
  assign or_3536 = (xor_3400 & xor_3403) | (xor_3397 & (xor_3400 | xor_3403));
  logic or_3540;
  assign or_3540 = (xor_3412 & xor_3415) | (xor_3409 & (xor_3412 | xor_3415));
  logic or_3544;
  assign or_3544 = (xor_3424 & xor_3427) | (xor_3421 & (xor_3424 | xor_3427));
  // hls/stages/count_bits.hpp:24
  logic parity_3547;
  assign parity_3547 = ^{or_3544, or_3540, or_3536};
  // hls/stages/count_bits.hpp:25
  logic and_3548;
  assign and_3548 = xor_3394 & (^{xor_3431, select_3361[44:36], other[44:36]});
  logic or_3552;
  assign or_3552 = (xor_3379 & xor_3391) | (xor_3376 & (xor_3379 | xor_3391));
  logic and_3555;
  assign and_3555 = (xor_3397 ^ (^{select_3361[41:36], other[41:36]})) & (xor_3418 | xor_3430);
  logic or_3556;
  assign or_3556 = (xor_3418 & xor_3430) | and_3555;
  // hls/stages/count_bits.hpp:24
  logic parity_3559;
  assign parity_3559 = ^{or_3556, or_3552, and_3548};
  logic parity_3562;
  assign parity_3562 = ^{or_3556, or_3552, and_3548, or_3544, or_3540, or_3536, or_3526, or_3522, or_3518, or_3511, or_3507, or_3503, or_3495, or_3491, or_3487};
  logic parity_3564;
  assign parity_3564 = ^{or_3556, or_3552, and_3548, or_3544, or_3540, or_3536, or_3526, or_3522, or_3518, or_3511, or_3507, or_3503, or_3495, or_3491, or_3487, or_3477, or_3473, or_3469, or_3462, or_3458, or_3454, or_3447, or_3443, or_3439};
  // hls/stages/count_bits.hpp:25
  logic and_3565;
  assign and_3565 = parity_3483 & parity_3562;
  logic or_3569;
  assign or_3569 = (parity_3465 & parity_3480) | ((^{or_3447, or_3443, or_3439}) & (parity_3465 | parity_3480));
  logic or_3573;
  assign or_3573 = (parity_3547 & parity_3559) | (parity_3532 & (parity_3547 | parity_3559));
  logic or_3580;
  assign or_3580 = (parity_3514 & parity_3529) | ((^{or_3495, or_3491, or_3487}) & (parity_3514 | parity_3529));
  logic or_3584;
  assign or_3584 = (or_3540 & or_3544) | (or_3536 & (or_3540 | or_3544));
  logic or_3588;
  assign or_3588 = (or_3552 & or_3556) | (and_3548 & (or_3552 | or_3556));
  // hls/stages/count_bits.hpp:23
  logic or_3595;
  assign or_3595 = (or_3491 & or_3495) | (or_3487 & (or_3491 | or_3495));
  // hls/stages/count_bits.hpp:25
  logic or_3599;
  assign or_3599 = (or_3507 & or_3511) | (or_3503 & (or_3507 | or_3511));
  logic or_3603;
  assign or_3603 = (or_3522 & or_3526) | (or_3518 & (or_3522 | or_3526));
  // hls/stages/count_bits.hpp:24
  logic parity_3606;
  assign parity_3606 = ^{or_3603, or_3599, or_3595};
  // hls/stages/count_bits.hpp:23
  logic or_3610;
  assign or_3610 = (or_3443 & or_3447) | (or_3439 & (or_3443 | or_3447));
  // hls/stages/count_bits.hpp:25
  logic or_3614;
  assign or_3614 = (or_3458 & or_3462) | (or_3454 & (or_3458 | or_3462));
  logic or_3618;
  assign or_3618 = (or_3473 & or_3477) | (or_3469 & (or_3473 | or_3477));
  // hls/stages/count_bits.hpp:24
  logic parity_3621;
  assign parity_3621 = ^{or_3618, or_3614, or_3610};
  logic parity_3624;
  assign parity_3624 = ^{or_3618, or_3614, or_3610, or_3603, or_3599, or_3595, or_3588, or_3584, or_3580};
  logic parity_3626;
  assign parity_3626 = ^{or_3618, or_3614, or_3610, or_3603, or_3599, or_3595, or_3588, or_3584, or_3580, or_3573, or_3569, and_3565};
  // hls/stages/count_bits.hpp:25
  logic or_3630;
  assign or_3630 = (or_3584 & or_3588) | (or_3580 & (or_3584 | or_3588));
  logic or_3634;
  assign or_3634 = (or_3599 & or_3603) | (or_3595 & (or_3599 | or_3603));
  logic or_3638;
  assign or_3638 = (or_3614 & or_3618) | (or_3610 & (or_3614 | or_3618));
  // hls/stages/count_bits.hpp:24
  logic parity_3641;
  assign parity_3641 = ^{or_3638, or_3634, or_3630};
  // hls/stages/count_bits.hpp:25
  logic and_3642;
  assign and_3642 = (^{or_3573, or_3569, and_3565}) & parity_3624;
  logic or_3646;
  assign or_3646 = (or_3569 & or_3573) | (and_3565 & (or_3569 | or_3573));
  logic or_3650;
  assign or_3650 = (parity_3606 & parity_3621) | ((^{or_3588, or_3584, or_3580}) & (parity_3606 | parity_3621));
  // hls/stages/count_bits.hpp:24
  logic parity_3653;
  assign parity_3653 = ^{or_3650, or_3646, and_3642};
  // hls/stages/count_bits.hpp:25
  logic and_3655;
  assign and_3655 = parity_3641 & parity_3653;
  logic or_3659;
  assign or_3659 = (or_3634 & or_3638) | (or_3630 & (or_3634 | or_3638));
  logic or_3663;
  assign or_3663 = (or_3646 & or_3650) | (and_3642 & (or_3646 | or_3650));
  // hls/stages/patches.hpp:176
  logic [4:0] select_3708;
  assign select_3708 = equal_2158_s3_q ? patches_along_s3_q : patches_summed_row_column_q;
  logic select_3711;
  assign select_3711 = equal_2156_s3_q ? patches_summed_first_q : (equal_2158_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:542
  logic [9:0] select_3718;
  assign select_3718 = less_2319_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3721;
  assign select_3721 = equal_2322_s3_q ? (less_2319_s3_q ? (equal_2322_s3_q ? 10'h0 : select_3718) : 10'h0) : select_3718;
  logic [9:0] select_3723;
  assign select_3723 = less_2319_s3_q ? (equal_2320_s3_q ? 10'h0 : select_3721) : select_3721;
  // hls/stages/patches.hpp:542
  logic [4:0] select_3725;
  assign select_3725 = less_2319_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3728;
  assign select_3728 = equal_2322_s3_q ? (less_2319_s3_q ? (equal_2322_s3_q ? 5'h0 : select_3725) : 5'h0) : select_3725;
  logic [4:0] select_3730;
  assign select_3730 = less_2319_s3_q ? (equal_2320_s3_q ? 5'h0 : select_3728) : select_3728;
  // hls/stages/patches.hpp:542
  logic [4:0] select_3732;
  assign select_3732 = less_2319_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3735;
  assign select_3735 = equal_2322_s3_q ? (less_2319_s3_q ? (equal_2322_s3_q ? 5'h0 : select_3732) : 5'h0) : select_3732;
  logic [4:0] select_3737;
  assign select_3737 = less_2319_s3_q ? (equal_2320_s3_q ? 5'h0 : select_3735) : select_3735;
  // hls/stages/patches.hpp:542
  logic and_3740;
  assign and_3740 = less_2319_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:546
  logic select_3743;
  assign select_3743 = equal_2322_s3_q ? (less_2319_s3_q ? (not_2323_s3_q & and_3740) : and_3740) : and_3740;
  // hls/stages/patches.hpp:176
  logic select_3746;
  assign select_3746 = equal_2156_s3_q ? (less_2319_s3_q ? (not_2321_s3_q & select_3743) : select_3743) : patches_read_first_q;
  // hls/stages/patches.hpp:170
  logic or_3757;
  assign or_3757 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3758;
  assign and_3758 = patches_read_searches_s3_q & or_3757;
  // hls/stages/patches.hpp:526
  logic [4:0] select_3759;
  assign select_3759 = and_3758 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:533
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3759};
  // hls/stages/patches.hpp:542
  logic and_3763;
  assign and_3763 = less_2319_s3_q & (equal_3755_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:546
  logic select_3766;
  assign select_3766 = equal_2322_s3_q ? (less_2319_s3_q ? (not_2323_s3_q & and_3763) : and_3763) : and_3763;
  // hls/stages/patches.hpp:176
  logic select_3769;
  assign select_3769 = equal_2156_s3_q ? (less_2319_s3_q ? (not_2321_s3_q & select_3766) : select_3766) : patches_read_above_q;
  // hls/stages/patches.hpp:542
  logic and_3772;
  assign and_3772 = less_2319_s3_q & (equal_3755_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:546
  logic select_3775;
  assign select_3775 = equal_2322_s3_q ? (less_2319_s3_q ? (not_2323_s3_q & and_3772) : and_3772) : and_3772;
  // hls/stages/patches.hpp:176
  logic select_3778;
  assign select_3778 = equal_2156_s3_q ? (less_2319_s3_q ? (not_2321_s3_q & select_3775) : select_3775) : patches_read_below_q;
  // hls/stages/patches.hpp:539
  logic [6:0] sum_3779;
  assign sum_3779 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:540
  logic [9:0] select_3782;
  assign select_3782 = (equal_3755_s3_q & ({sum_3779[6], sum_3779} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3783;
  assign select_3783 = less_2319_s3_q ? select_3782 : 10'h3ff;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3785;
  assign select_3785 = less_2319_s3_q ? (equal_2322_s3_q ? 10'h3ff : select_3783) : 10'h3ff;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3786;
  assign select_3786 = equal_2322_s3_q ? select_3785 : select_3783;
  logic [9:0] select_3788;
  assign select_3788 = less_2319_s3_q ? (equal_2320_s3_q ? 10'h3ff : select_3786) : select_3786;
  // hls/stages/patches.hpp:525
  logic [14:0] select_3790;
  assign select_3790 = and_3758 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:176
  logic [9:0] select_3791;
  assign select_3791 = equal_2156_s3_q ? select_3790[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3792;
  assign select_3792 = equal_2156_s3_q ? select_3790[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:527
  logic [9:0] select_3794;
  assign select_3794 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:528
  logic [9:0] select_3796;
  assign select_3796 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:529
  logic [9:0] select_3799;
  assign select_3799 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3800;
  assign select_3800 = patches_read_first_q ? patches_read_far_q : select_3799;
  // hls/stages/patches.hpp:580
  logic [9:0] difference_3803;
  assign difference_3803 = select_3800 - select_3790[9:0];
  // hls/stages/patches.hpp:565
  logic less_3833;
  assign less_3833 = select_3794 < select_3796;
  // hls/stages/patches.hpp:571
  logic [1:0] sum_3834;
  assign sum_3834 = select_3759[4:3] + 2'h3;
  // hls/stages/patches.hpp:566
  logic [9:0] high;
  assign high = less_3833 ? select_3796 : select_3794;
  logic [9:0] low;
  assign low = (select_3796 < select_3794) ? select_3796 : select_3794;
  // hls/stages/patches.hpp:567
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3790[9:0];
  // hls/stages/patches.hpp:569
  logic not_3841;
  assign not_3841 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3842;
  assign sum_3842 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3844;
  assign not_3844 = ~({eight, 3'h0} < {1'b0, sum_3842, fall[0]});
  logic [1:0] sum_3845;
  assign sum_3845 = {1'b0, not_3841} + {1'b0, not_3844};
  // hls/stages/patches.hpp:570
  logic [10:0] sum_3846;
  assign sum_3846 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3848;
  assign not_3848 = ~({eight, 3'h0} < {sum_3846, fall[1:0]});
  logic not_3851;
  assign not_3851 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3852;
  assign sum_3852 = {1'b0, not_3848} + {1'b0, not_3851};
  // hls/stages/patches.hpp:569
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3845} + {1'b0, sum_3852};
  // hls/stages/patches.hpp:572
  logic [7:0] select_3855;
  assign select_3855 = less_3833 ? ({sum_3834, select_3759[2:0], 3'h0} - {5'h0, fraction}) : {sum_3834, select_3759[2:0], fraction};
  // hls/stages/agreement.hpp:1086
  logic equal_4018;
  assign equal_4018 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/patches.hpp:330
  logic select_4055;
  assign select_4055 = equal_1943_s3_q ? shown_shown_q : (so_s3_q ? select_2377 : shown_shown_q);
  logic select_4057;
  assign select_4057 = equal_1943_s3_q ? shown_nearer_q : (so_s3_q ? select_2380 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4059;
  assign sum_4059 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_4061;
  assign select_4061 = less_4058_s3_q ? (sum_4059[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4063;
  assign select_4063 = equal_2752_s3_q ? (equal_562_s3_q ? 3'h0 : select_4061) : region_row_q;
  // hls/stages/patches.hpp:330
  logic [7:0] select_4068;
  assign select_4068 = equal_1943_s3_q ? select_2337 : (so_s3_q ? (ends_cell_s3_q ? select_2429 : select_2337) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_4082;
  assign select_4082 = equal_562_s3_q ? {{2{difference_4080[6]}}, difference_4080} : (less_4058_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_4084;
  assign select_4084 = and_501_s3_q ? (equal_2752_s3_q ? select_4082 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [6:0] select_4086;
  assign select_4086 = equal_562_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_4088;
  assign select_4088 = and_501_s3_q ? (equal_2752_s3_q ? select_4086 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4089;
  assign sum_4089 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4090;
  assign select_4090 = sum_4059[7] ? {1'b1, sum_4059[6:0], region_down_rest_q[0]} : sum_4089;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4059[7];
  // hls/stages/agreement.hpp:447
  logic select_4094;
  assign select_4094 = equal_2752_s3_q ? (equal_562_s3_q | (less_4058_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_4099;
  assign or_4099 = segment_starts_q | not_1983;
  // hls/stages/agreement.hpp:976
  logic select_4102;
  assign select_4102 = shift_2_s3_q[0] ? (sum_2350_s3_q ? (equal_2149_s3_q & or_2352) : or_2352) : or_4099;
  // hls/stages/patches.hpp:330
  logic select_4105;
  assign select_4105 = equal_1943_s3_q ? or_4099 : (so_s3_q ? (ends_cell_s3_q ? select_4102 : or_4099) : or_4099);
  logic [2:0] select_4179;
  assign select_4179 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_4181;
  assign select_4181 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4183;
  assign select_4183 = equal_1943_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4181 : box_textured_columns_values_1_q);
  logic [2:0] select_4184;
  assign select_4184 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4186;
  assign select_4186 = equal_1943_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4184 : box_textured_columns_values_2_q);
  logic [2:0] select_4187;
  assign select_4187 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4189;
  assign select_4189 = equal_1943_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4187 : box_textured_columns_values_3_q);
  logic [2:0] select_4190;
  assign select_4190 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4192;
  assign select_4192 = equal_1943_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4190 : box_textured_columns_values_4_q);
  logic [4:0] select_4194;
  assign select_4194 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4197;
  assign select_4197 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4199;
  assign select_4199 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4201;
  assign select_4201 = equal_1943_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4199 : box_explained_columns_values_1_q);
  logic [2:0] select_4202;
  assign select_4202 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4204;
  assign select_4204 = equal_1943_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4202 : box_explained_columns_values_2_q);
  logic [2:0] select_4205;
  assign select_4205 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4207;
  assign select_4207 = equal_1943_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4205 : box_explained_columns_values_3_q);
  logic [2:0] select_4208;
  assign select_4208 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4210;
  assign select_4210 = equal_1943_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4208 : box_explained_columns_values_4_q);
  logic [4:0] select_4212;
  assign select_4212 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4213;
  assign select_4213 = equal_1943_s3_q ? box_explained_sum_sums_values_0_q : select_4212;
  logic [2:0] select_4215;
  assign select_4215 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4217;
  assign select_4217 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4219;
  assign select_4219 = equal_1943_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4217 : box_shown_columns_values_1_q);
  logic [2:0] select_4220;
  assign select_4220 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4222;
  assign select_4222 = equal_1943_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4220 : box_shown_columns_values_2_q);
  logic [2:0] select_4223;
  assign select_4223 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4225;
  assign select_4225 = equal_1943_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4223 : box_shown_columns_values_3_q);
  logic [2:0] select_4226;
  assign select_4226 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4228;
  assign select_4228 = equal_1943_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4226 : box_shown_columns_values_4_q);
  logic [4:0] select_4230;
  assign select_4230 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4233;
  assign select_4233 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4235;
  assign select_4235 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4237;
  assign select_4237 = equal_1943_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4235 : box_nearer_columns_values_1_q);
  logic [2:0] select_4238;
  assign select_4238 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4240;
  assign select_4240 = equal_1943_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4238 : box_nearer_columns_values_2_q);
  logic [2:0] select_4241;
  assign select_4241 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4243;
  assign select_4243 = equal_1943_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4241 : box_nearer_columns_values_3_q);
  logic [2:0] select_4244;
  assign select_4244 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4246;
  assign select_4246 = equal_1943_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4244 : box_nearer_columns_values_4_q);
  logic [4:0] select_4248;
  assign select_4248 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_4251;
  assign select_4251 = so_s3_q ? (ends_cell_s3_q ? and_2417 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4254;
  assign select_4254 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_4256;
  assign select_4256 = equal_1943_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_4254 : centres_values_0_of_skin_q);
  logic select_4257;
  assign select_4257 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4259;
  assign select_4259 = equal_1943_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_4257 : centres_values_1_textured_q);
  logic select_4260;
  assign select_4260 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4262;
  assign select_4262 = equal_1943_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_4260 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:447
  logic [12:0] select_4266;
  assign select_4266 = equal_2752_s3_q ? (equal_4263_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_4269;
  assign select_4269 = and_501_s3_q ? (equal_2752_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1227
  logic [2:0] select_4280;
  assign select_4280 = select_2389 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_4286;
  assign select_4286 = marks_first_s3_q ? (less_4282 ? {sum_4283, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1235
  logic and_4292;
  assign and_4292 = and_2488_s3_q & ({sum_2414, index_2[5:0]} == {sum_2401, index[5:0]});
  // hls/stages/registration.hpp:258
  logic not_4349;
  assign not_4349 = ~quarter[1];
  logic [3:0] select_4350;
  assign select_4350 = quarter[0] ? {quarter[1], 1'b0, not_4349, 1'b0} : {1'b0, quarter[1], 1'b0, not_4349};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1995;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_2038;
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:745; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [23:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 24'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_2072;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_2074));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1319; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2347;
  logic regions_re;
  assign regions_re = s3_en & (equal_1943_s3_q ? (x_s3_q[6] & not_2348) : and_2355);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1330; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2401, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_2408 & less_2409);
  logic [2:0] map_word_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_word_q <= map_mem[map_raddr];
  end
  logic [1:0] map_rdata_q;
  assign map_rdata_q = map_word_q[1:0];
  logic map_read_q, map_error;
  always_ff @(posedge clk_i) map_read_q <= rst_ni & map_re;
  assign map_error = map_read_q & ^map_word_q;

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_471_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_476_s3_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_495, and_491, sum_487, sum_483};
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

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_501_s3_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_519, whole_2, select_511, select_507};
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
  assign shown_right_waddr = select_1982_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1987_s3_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_1984, not_1983};
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

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_2270, patches_code_row_s3_q[1:0], of_row_2_s3_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_2304_s3_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {less_2290_s3_q, less_2289_s3_q, less_2280_s3_q, less_2279_s3_q, patches_codes_at_q[51:28]};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {^patches_right_codes_wdata, patches_right_codes_wdata};
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
  assign patches_left_codes_waddr = {sum_2308, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_2318_s3_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {less_2290_s3_q, less_2289_s3_q, less_2280_s3_q, less_2279_s3_q, patches_codes_at_q[51:8]};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {^patches_left_codes_wdata, patches_left_codes_wdata};
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
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s3_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s3_en & and_1978_s3_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2376, textured_s3_q};
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
      patches_fixed_q <= 1'b0;
      patches_choice_valid_q <= 1'b0;
      patches_choice_column_q <= 8'h0;
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
      sample_pair_pixel_0_q <= pixel_0_s3_q;
      sample_pair_pixel_1_q <= pixel_1_s3_q;
      sample_of_skin_q <= mask_s3_q;
      averager_running_mask_q <= sample_pair_whole_s3_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2541;
      averager_mask_q <= select_2543;
      averager_of_skin_q <= select_2545;
      census_filled_q <= and_501_s3_q ? {select_565[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_501_s3_q ? select_564 : rows_passed_above_q;
      registration_slope_here_q <= select_2958;
      registration_expected_q <= select_2960;
      registration_of_right_q <= equal_1943_s3_q ? registration_of_right_q : select_3020;
      registration_was_inside_q <= equal_1943_s3_q ? registration_was_inside_q : select_3023;
      registration_fresh_q <= select_3032;
      patches_fixed_q <= not_3191 & (patches_fixed_q | (and_3201_s3_q & and_2129));
      patches_choice_valid_q <= and_2154_s3_q ? (select_2148[0] & not_3191) : select_2148[0];
      patches_choice_column_q <= select_2148[8:1];
      patches_choice_shift_q <= select_2148[14:9];
      patches_choice_slope_q <= select_2148[22:15];
      patches_band_q <= sample_pair_whole_s3_q ? select_2169 : patches_band_q;
      patches_fetch_q <= select_3219;
      patches_codes_at_q <= select_3320;
      patches_codes_further_q <= equal_2156_s3_q ? patches_codes_further_q : select_3325;
      patches_next_codes_q <= select_3333;
      patches_set_q <= equal_2156_s3_q ? 3'h0 : (equal_2158_s3_q ? 3'h0 : select_3347);
      patches_size_q <= sum_3351;
      patches_left_row_q <= select_3363;
      patches_summed_row_column_q <= equal_2156_s3_q ? patches_summed_row_column_q : select_3708;
      patches_summed_first_q <= select_3711;
      patches_read_row_differing_q <= equal_2156_s3_q ? select_3723 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2156_s3_q ? select_3730 : patches_read_row_column_q;
      patches_read_at_q <= equal_2156_s3_q ? select_3737 : patches_read_at_q;
      patches_read_first_q <= select_3746;
      patches_read_above_q <= select_3769;
      patches_read_below_q <= select_3778;
      patches_read_far_q <= equal_2156_s3_q ? select_3788 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3791;
      patches_peak_best_column_q <= select_3792;
      patches_peak_row_q <= equal_2156_s3_q ? select_3759 : patches_peak_row_q;
      patches_peak_above_q <= equal_2156_s3_q ? select_3794 : patches_peak_above_q;
      patches_peak_below_q <= equal_2156_s3_q ? select_3796 : patches_peak_below_q;
      patches_peak_far_q <= equal_2156_s3_q ? select_3800 : patches_peak_far_q;
      shown_shown_q <= select_4055;
      shown_nearer_q <= select_4057;
      region_row_q <= and_501_s3_q ? select_4063 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4068;
      region_down_rest_q <= select_4084;
      region_down_back_q <= select_4088;
      region_down_next_q <= select_4090;
      region_fresh_q <= and_501_s3_q ? select_4094 : region_fresh_q;
      segment_starts_q <= select_4105;
      centres_values_0_textured_q <= equal_1943_s3_q ? centres_values_0_textured_q : select_4251;
      centres_values_0_of_skin_q <= select_4256;
      centres_values_1_textured_q <= select_4259;
      centres_values_1_of_skin_q <= select_4262;
      map_row_q <= and_501_s3_q ? select_4266 : map_row_q;
      map_width_q <= select_4269;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2400;
      done_q <= not_2402 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      drew_q <= so_s3_q;
      said_q <= equal_1943_s3_q & equal_4018;
      rows_passed_q <= select_2385;
      columns_passed_q <= {select_2387[7:0], or_2383};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_2404;
      seen_x_q <= select_2406;
      seen_y_q <= marks_first_s3_q ? 3'h0 : select_4280;
      seen_column_q <= select_2397;
      seen_rows_left_q <= select_4286;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2394;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
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
      averager_running_0_q <= sample_pair_whole_s3_q ? select_479 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_485 : averager_running_1_q;
      averager_total_0_q <= select_2520;
      averager_total_1_q <= select_2522;
      census_columns_values_0_cell_0_left_q <= select_2546;
      census_columns_values_0_cell_0_right_q <= select_2547;
      census_columns_values_0_cell_0_mask_q <= and_501_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2549;
      census_columns_values_0_cell_1_right_q <= select_2550;
      census_columns_values_0_cell_1_mask_q <= select_2551;
      census_columns_values_0_cell_2_left_q <= select_2552;
      census_columns_values_0_cell_2_right_q <= select_2553;
      census_columns_values_0_cell_2_mask_q <= select_2554;
      census_columns_values_0_cell_2_of_skin_q <= select_2555;
      census_columns_values_0_cell_3_left_q <= select_2556;
      census_columns_values_0_cell_3_right_q <= select_2557;
      census_columns_values_0_cell_3_mask_q <= select_2558;
      census_columns_values_0_cell_4_left_q <= select_2559;
      census_columns_values_0_cell_4_right_q <= select_2560;
      census_columns_values_0_cell_4_mask_q <= select_2561;
      census_columns_values_1_cell_0_left_q <= select_2562;
      census_columns_values_1_cell_0_right_q <= select_2563;
      census_columns_values_1_cell_0_mask_q <= select_2564;
      census_columns_values_1_cell_1_left_q <= select_2565;
      census_columns_values_1_cell_1_right_q <= select_2566;
      census_columns_values_1_cell_1_mask_q <= select_2567;
      census_columns_values_1_cell_2_left_q <= select_2568;
      census_columns_values_1_cell_2_right_q <= select_2569;
      census_columns_values_1_cell_2_mask_q <= select_2570;
      census_columns_values_1_cell_2_of_skin_q <= select_2571;
      census_columns_values_1_cell_3_left_q <= select_2572;
      census_columns_values_1_cell_3_right_q <= select_2573;
      census_columns_values_1_cell_3_mask_q <= select_2574;
      census_columns_values_1_cell_4_left_q <= select_2575;
      census_columns_values_1_cell_4_right_q <= select_2576;
      census_columns_values_1_cell_4_mask_q <= select_2577;
      census_columns_values_2_cell_0_left_q <= select_2578;
      census_columns_values_2_cell_0_right_q <= select_2579;
      census_columns_values_2_cell_0_mask_q <= select_2580;
      census_columns_values_2_cell_1_left_q <= select_2581;
      census_columns_values_2_cell_1_right_q <= select_2582;
      census_columns_values_2_cell_1_mask_q <= select_2583;
      census_columns_values_2_cell_2_left_q <= select_2584;
      census_columns_values_2_cell_2_right_q <= select_2585;
      census_columns_values_2_cell_2_mask_q <= select_2586;
      census_columns_values_2_cell_3_left_q <= select_2587;
      census_columns_values_2_cell_3_right_q <= select_2588;
      census_columns_values_2_cell_3_mask_q <= select_2589;
      census_columns_values_2_cell_4_left_q <= select_2590;
      census_columns_values_2_cell_4_right_q <= select_2591;
      census_columns_values_2_cell_4_mask_q <= select_2592;
      census_columns_values_3_cell_0_mask_q <= select_2593;
      census_columns_values_3_cell_1_left_q <= select_2594;
      census_columns_values_3_cell_1_right_q <= select_2595;
      census_columns_values_3_cell_1_mask_q <= select_2596;
      census_columns_values_3_cell_2_mask_q <= select_2597;
      census_columns_values_3_cell_3_left_q <= select_2598;
      census_columns_values_3_cell_3_right_q <= select_2599;
      census_columns_values_3_cell_3_mask_q <= select_2600;
      census_columns_values_3_cell_4_mask_q <= select_2601;
      sharpness_last_mean_0_q <= and_501_s3_q ? select_507 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_501_s3_q ? select_511 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1943_s3_q ? box_textured_columns_values_0_q : select_4179;
      box_textured_columns_values_1_q <= select_4183;
      box_textured_columns_values_2_q <= select_4186;
      box_textured_columns_values_3_q <= select_4189;
      box_textured_columns_values_4_q <= select_4192;
      box_textured_sum_sums_values_0_q <= equal_1943_s3_q ? box_textured_sum_sums_values_0_q : select_4194;
      box_explained_columns_values_0_q <= equal_1943_s3_q ? box_explained_columns_values_0_q : select_4197;
      box_explained_columns_values_1_q <= select_4201;
      box_explained_columns_values_2_q <= select_4204;
      box_explained_columns_values_3_q <= select_4207;
      box_explained_columns_values_4_q <= select_4210;
      box_explained_sum_sums_values_0_q <= select_4213;
      box_shown_columns_values_0_q <= equal_1943_s3_q ? box_shown_columns_values_0_q : select_4215;
      box_shown_columns_values_1_q <= select_4219;
      box_shown_columns_values_2_q <= select_4222;
      box_shown_columns_values_3_q <= select_4225;
      box_shown_columns_values_4_q <= select_4228;
      box_shown_sum_sums_values_0_q <= equal_1943_s3_q ? box_shown_sum_sums_values_0_q : select_4230;
      box_nearer_columns_values_0_q <= equal_1943_s3_q ? box_nearer_columns_values_0_q : select_4233;
      box_nearer_columns_values_1_q <= select_4237;
      box_nearer_columns_values_2_q <= select_4240;
      box_nearer_columns_values_3_q <= select_4243;
      box_nearer_columns_values_4_q <= select_4246;
      box_nearer_sum_sums_values_0_q <= equal_1943_s3_q ? box_nearer_sum_sums_values_0_q : select_4248;
    end
  end

  logic saturated_s4_q;
  logic marks_first_s4_q;
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
  logic [2:0] select_465_s4_q;
  logic [6:0] select_467_s4_q;
  logic [6:0] column_s4_q;
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
  logic equal_1943_s4_q;
  logic not_1944_s4_q;
  logic equal_1988_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1994_s4_q;
  logic equal_1996_s4_q;
  logic equal_1998_s4_q;
  logic equal_2000_s4_q;
  logic equal_2002_s4_q;
  logic equal_2004_s4_q;
  logic equal_2006_s4_q;
  logic equal_2008_s4_q;
  logic equal_2010_s4_q;
  logic less_2019_s4_q;
  logic or_2023_s4_q;
  logic equal_2043_s4_q;
  logic and_2053_s4_q;
  logic and_2056_s4_q;
  logic select_2073_s4_q;
  logic equal_2074_s4_q;
  logic and_2082_s4_q;
  logic equal_2084_s4_q;
  logic select_2148_s4_q;
  logic and_2155_s4_q;
  logic equal_2156_s4_q;
  logic equal_2158_s4_q;
  logic and_2171_s4_q;
  logic [4:0] select_2186_s4_q;
  logic select_2192_s4_q;
  logic [3:0] select_2233_s4_q;
  logic less_2319_s4_q;
  logic equal_2320_s4_q;
  logic not_2321_s4_q;
  logic equal_2322_s4_q;
  logic or_2340_s4_q;
  logic or_2343_s4_q;
  logic or_2346_s4_q;
  logic not_2348_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_2369_s4_q;
  logic and_2374_s4_q;
  logic and_2408_s4_q;
  logic less_2409_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_2414_s4_q;
  logic equal_2427_s4_q;
  logic or_2432_s4_q;
  logic or_2435_s4_q;
  logic or_2438_s4_q;
  logic not_2463_s4_q;
  logic less_2477_s4_q;
  logic and_2488_s4_q;
  logic [11:0] sum_2617_s4_q;
  logic [9:0] sum_2620_s4_q;
  logic equal_2628_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2849_s4_q;
  logic and_2853_s4_q;
  logic not_2887_s4_q;
  logic and_2915_s4_q;
  logic and_2964_s4_q;
  logic and_2965_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2999_s4_q;
  logic and_3013_s4_q;
  logic equal_3056_s4_q;
  logic parity_3435_s4_q;
  logic parity_3564_s4_q;
  logic parity_3626_s4_q;
  logic xor_3654_s4_q;
  logic parity_3666_s4_q;
  logic or_3670_s4_q;
  logic equal_3671_s4_q;
  logic [4:0] select_3790_s4_q;
  logic equal_3802_s4_q;
  logic less_3804_s4_q;
  logic less_3805_s4_q;
  logic or_3810_s4_q;
  logic [7:0] select_3855_s4_q;
  logic equal_4018_s4_q;
  logic and_4292_s4_q;
  logic not_4307_s4_q;
  logic equal_4352_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      saturated_s4_q <= saturated_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
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
      equal_1943_s4_q <= equal_1943_s3_q;
      not_1944_s4_q <= not_1944_s3_q;
      equal_1988_s4_q <= equal_1988;
      all_s4_q <= all;
      sum_1994_s4_q <= sum_1994;
      equal_1996_s4_q <= equal_1996;
      equal_1998_s4_q <= equal_1998;
      equal_2000_s4_q <= equal_2000;
      equal_2002_s4_q <= equal_2002;
      equal_2004_s4_q <= equal_2004;
      equal_2006_s4_q <= equal_2006;
      equal_2008_s4_q <= equal_2008;
      equal_2010_s4_q <= equal_2010;
      less_2019_s4_q <= less_2019;
      or_2023_s4_q <= or_2023;
      equal_2043_s4_q <= (registration_fresh_q & select_2041) == 4'h0;
      and_2053_s4_q <= not_1944_s3_q & and_2037;
      and_2056_s4_q <= and_2056_s3_q;
      select_2073_s4_q <= select_2073[1];
      equal_2074_s4_q <= equal_2074;
      and_2082_s4_q <= and_2082_s3_q;
      equal_2084_s4_q <= equal_2084;
      select_2148_s4_q <= select_2148[0];
      and_2155_s4_q <= and_2155_s3_q;
      equal_2156_s4_q <= equal_2156_s3_q;
      equal_2158_s4_q <= equal_2158_s3_q;
      and_2171_s4_q <= and_2155_s3_q & equal_2170;
      select_2186_s4_q <= select_2186_s3_q;
      select_2192_s4_q <= select_2192_s3_q;
      select_2233_s4_q <= select_2233_s3_q;
      less_2319_s4_q <= less_2319_s3_q;
      equal_2320_s4_q <= equal_2320_s3_q;
      not_2321_s4_q <= not_2321_s3_q;
      equal_2322_s4_q <= equal_2322_s3_q;
      or_2340_s4_q <= or_2340;
      or_2343_s4_q <= or_2343;
      or_2346_s4_q <= or_2346;
      not_2348_s4_q <= not_2348;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_2369_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_2374_s4_q <= not_1944_s3_q & and_2355;
      and_2408_s4_q <= and_2408;
      less_2409_s4_q <= less_2409;
      index_2_s4_q <= index_2[5:0];
      sum_2414_s4_q <= sum_2414;
      equal_2427_s4_q <= t[4:1] == 4'h0;
      or_2432_s4_q <= or_2432;
      or_2435_s4_q <= select_2429[7] | (~({select_2429[6], select_2429[3:2]} == 3'h0));
      or_2438_s4_q <= select_2429[7] | (~(select_2429[6:4] == 3'h0));
      not_2463_s4_q <= ~({sum_2461, around[0]} < {2'h0, t});
      less_2477_s4_q <= {1'b0, around[4:1]} < n;
      and_2488_s4_q <= and_2488_s3_q;
      sum_2617_s4_q <= {1'b0, sum_2613} + {2'h0, sum_2616};
      sum_2620_s4_q <= {9'h0, difference_2618[9]} + {1'b0, xor_2619};
      equal_2628_s4_q <= equal_2628_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2849_s4_q <= and_2849;
      and_2853_s4_q <= and_2853;
      not_2887_s4_q <= ~({sum_2885, e[0]} < {2'h0, t});
      and_2915_s4_q <= not_1944_s3_q & and_2914;
      and_2964_s4_q <= not_1944_s3_q & (so_s3_q & (half_ends & equal_2961));
      and_2965_s4_q <= and_2965;
      residual_s4_q <= residual[7:0];
      and_2999_s4_q <= and_2999;
      and_3013_s4_q <= and_2965 & less_3012;
      equal_3056_s4_q <= (registration_fresh_q & select_3054) == 4'h0;
      parity_3435_s4_q <= ^{xor_3431, xor_3394, select_3361[44:36], other[44:36]};
      parity_3564_s4_q <= parity_3564;
      parity_3626_s4_q <= parity_3626;
      xor_3654_s4_q <= parity_3641 ^ parity_3653;
      parity_3666_s4_q <= ^{or_3663, or_3659, and_3655};
      or_3670_s4_q <= (or_3659 & or_3663) | (and_3655 & (or_3659 | or_3663));
      equal_3671_s4_q <= equal_3671_s3_q;
      select_3790_s4_q <= select_3790[14:10];
      equal_3802_s4_q <= select_3759[3:0] == 4'h0;
      less_3804_s4_q <= {difference_3803, 3'h0} < {3'h0, sum_3351};
      less_3805_s4_q <= select_3800 < select_3790[9:0];
      or_3810_s4_q <= (sum_3351 < 10'h39) | ({1'b0, sum_3351[9:1]} < select_3790[9:0]);
      select_3855_s4_q <= select_3855;
      equal_4018_s4_q <= equal_4018;
      and_4292_s4_q <= and_4292;
      not_4307_s4_q <= ~proven_q;
      equal_4352_s4_q <= (registration_fresh_q & select_4350) == 4'h0;
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
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
  logic [7:0] patches_place_0_column_q;
  logic [5:0] patches_place_0_shift_q;
  logic [7:0] patches_place_0_slope_q;
  logic patches_place_1_valid_q;
  logic [7:0] patches_place_1_column_q;
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
  logic equal_2045;
  assign equal_2045 = sum_1994_s4_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1994_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2047;
  assign select_2047 = equal_2045 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2048;
  assign sum_2048 = (equal_2043_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2047[13]}}, select_2047};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1994_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2051;
  assign select_2051 = equal_2045 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2052;
  assign sum_2052 = (equal_2043_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2051[6]}}, select_2051};
  // hls/stages/patches.hpp:343
  logic [22:0] select_2172;
  assign select_2172 = and_2171_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2148_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:119
  logic select_2174;
  assign select_2174 = equal_2074_s4_q ? patches_place_0_valid_q : (select_2073_s4_q ? patches_place_0_valid_q : select_2172[0]);
  // hls/stages/patches.hpp:344
  logic [21:0] select_2175;
  assign select_2175 = select_2073_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2172[22:1];
  // hls/stages/patches.hpp:119
  logic [7:0] select_2176;
  assign select_2176 = equal_2074_s4_q ? patches_place_0_column_q : select_2175[7:0];
  logic [5:0] select_2177;
  assign select_2177 = equal_2074_s4_q ? patches_place_0_shift_q : select_2175[13:8];
  // hls/stages/patches.hpp:314
  logic [7:0] sum_2178;
  assign sum_2178 = select_2176 + {{2{select_2177[5]}}, select_2177};
  // hls/stages/patches.hpp:315
  logic [6:0] sum_2179;
  assign sum_2179 = sum_2178[7:1] + 7'h7f;
  // hls/stages/patches.hpp:123
  logic equal_2180;
  assign equal_2180 = {sum_2179[6], select_467_s4_q, select_465_s4_q} == {1'b0, sum_2179[5:0], sum_2178[0], 3'h4};
  // hls/stages/patches.hpp:125
  logic or_2182;
  assign or_2182 = and_2056_s4_q | (select_2174 & equal_2180);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2183;
  assign select_2183 = or_2182 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:125
  logic [5:0] select_2193;
  assign select_2193 = or_2182 ? {and_2056_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:129
  logic and_2195;
  assign and_2195 = select_2192_s4_q & (~select_2193[5]);
  // hls/stages/patches.hpp:119
  logic select_2203;
  assign select_2203 = equal_2074_s4_q ? patches_place_1_valid_q : (select_2073_s4_q ? select_2172[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:344
  logic [21:0] select_2204;
  assign select_2204 = select_2073_s4_q ? select_2172[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:119
  logic [7:0] select_2205;
  assign select_2205 = equal_2074_s4_q ? patches_place_1_column_q : select_2204[7:0];
  logic [5:0] select_2206;
  assign select_2206 = equal_2074_s4_q ? patches_place_1_shift_q : select_2204[13:8];
  // hls/stages/patches.hpp:314
  logic [7:0] sum_2207;
  assign sum_2207 = select_2205 + {{2{select_2206[5]}}, select_2206};
  // hls/stages/patches.hpp:315
  logic [6:0] sum_2208;
  assign sum_2208 = sum_2207[7:1] + 7'h7f;
  // hls/stages/patches.hpp:123
  logic equal_2209;
  assign equal_2209 = {sum_2208[6], select_467_s4_q, select_465_s4_q} == {1'b0, sum_2208[5:0], sum_2207[0], 3'h4};
  // hls/stages/patches.hpp:125
  logic or_2211;
  assign or_2211 = and_2056_s4_q | (select_2203 & equal_2209);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2212;
  assign select_2212 = or_2211 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:125
  logic [5:0] select_2213;
  assign select_2213 = or_2211 ? {and_2056_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:129
  logic and_2215;
  assign and_2215 = select_2192_s4_q & (~select_2213[5]);
  // hls/stages/patches.hpp:310
  logic [7:0] sum_2222;
  assign sum_2222 = select_2176 + 8'hff;
  // hls/stages/patches.hpp:124
  logic equal_2223;
  assign equal_2223 = {sum_2222[7], select_467_s4_q, select_465_s4_q} == {1'b0, sum_2222[6:0], 3'h4};
  // hls/stages/patches.hpp:126
  logic or_2225;
  assign or_2225 = and_2056_s4_q | (select_2174 & equal_2223);
  logic [4:0] select_2226;
  assign select_2226 = or_2225 ? {and_2056_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:310
  logic [7:0] sum_2227;
  assign sum_2227 = select_2205 + 8'hff;
  // hls/stages/patches.hpp:124
  logic equal_2228;
  assign equal_2228 = {sum_2227[7], select_467_s4_q, select_465_s4_q} == {1'b0, sum_2227[6:0], 3'h4};
  // hls/stages/patches.hpp:126
  logic [4:0] select_2231;
  assign select_2231 = (and_2056_s4_q | (select_2203 & equal_2228)) ? {and_2056_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:134
  logic [3:0] column_7;
  assign column_7 = select_2226[4] ? select_2231[3:0] : select_2226[3:0];
  // hls/stages/agreement.hpp:263
  logic select_2234;
  assign select_2234 = or_2225 ? and_2056_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:134
  logic and_2240;
  assign and_2240 = (select_2192_s4_q & (select_2186_s4_q[3] ^ select_2186_s4_q[4])) & ((~select_2226[4]) | (~select_2231[4]));
  // hls/stages/patches.hpp:176
  logic less_2331;
  assign less_2331 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:177
  logic not_2332;
  assign not_2332 = ~less_2331;
  logic [1:0] select_2333;
  assign select_2333 = patches_summed_first_s4_q ? 2'h2 : {less_2331, not_2332};
  logic [12:0] select_2334;
  assign select_2334 = select_2333[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2335;
  assign select_2335 = select_2333[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2336;
  assign select_2336 = select_2333[1] ? {select_2334[12:8], patches_sums_values_0_q[9:8], select_2334[7:0]} : select_2335;
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2359;
  assign select_2359 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_2360;
  assign sum_2360 = {6'h0, textured_s4_q} + select_2359;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_2362;
  assign sum_2362 = {3'h0, sum_2360} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2364;
  assign select_2364 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_2365;
  assign sum_2365 = {6'h0, explained_s4_q} + select_2364;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_2367;
  assign sum_2367 = {3'h0, sum_2365} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2370;
  assign select_2370 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:868
  logic [6:0] sum_2371;
  assign sum_2371 = {6'h0, and_2369_s4_q} + select_2370;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_2373;
  assign sum_2373 = {3'h0, sum_2371} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1043
  logic not_2439;
  assign not_2439 = ~region_row_s4_q[2];
  logic [2:0] select_2440;
  assign select_2440 = region_row_s4_q[1] ? {1'b0, not_2439, 1'b0} : {region_row_s4_q[2], 1'b0, not_2439};
  logic [5:0] select_2441;
  assign select_2441 = region_row_s4_q[0] ? {select_2440[2], 1'b0, select_2440[1], 1'b0, select_2440[0], 1'b0} : {1'b0, select_2440[2], 1'b0, select_2440[1], 1'b0, select_2440[0]};
  logic [11:0] select_2442;
  assign select_2442 = or_2438_s4_q ? {select_2441[5], 1'b0, select_2441[4], 1'b0, select_2441[3], 1'b0, select_2441[2], 1'b0, select_2441[1], 1'b0, select_2441[0], 1'b0} : {1'b0, select_2441[5], 1'b0, select_2441[4], 1'b0, select_2441[3], 1'b0, select_2441[2], 1'b0, select_2441[1], 1'b0, select_2441[0]};
  logic [23:0] select_2443;
  assign select_2443 = or_2435_s4_q ? {select_2442[11], 1'b0, select_2442[10], 1'b0, select_2442[9], 1'b0, select_2442[8], 1'b0, select_2442[7], 1'b0, select_2442[6], 1'b0, select_2442[5], 1'b0, select_2442[4], 1'b0, select_2442[3], 1'b0, select_2442[2], 1'b0, select_2442[1], 1'b0, select_2442[0], 1'b0} : {1'b0, select_2442[11], 1'b0, select_2442[10], 1'b0, select_2442[9], 1'b0, select_2442[8], 1'b0, select_2442[7], 1'b0, select_2442[6], 1'b0, select_2442[5], 1'b0, select_2442[4], 1'b0, select_2442[3], 1'b0, select_2442[2], 1'b0, select_2442[1], 1'b0, select_2442[0]};
  logic [47:0] select_2444;
  assign select_2444 = or_2432_s4_q ? {select_2443[23], 1'b0, select_2443[22], 1'b0, select_2443[21], 1'b0, select_2443[20], 1'b0, select_2443[19], 1'b0, select_2443[18], 1'b0, select_2443[17], 1'b0, select_2443[16], 1'b0, select_2443[15], 1'b0, select_2443[14], 1'b0, select_2443[13], 1'b0, select_2443[12], 1'b0, select_2443[11], 1'b0, select_2443[10], 1'b0, select_2443[9], 1'b0, select_2443[8], 1'b0, select_2443[7], 1'b0, select_2443[6], 1'b0, select_2443[5], 1'b0, select_2443[4], 1'b0, select_2443[3], 1'b0, select_2443[2], 1'b0, select_2443[1], 1'b0, select_2443[0], 1'b0} : {1'b0, select_2443[23], 1'b0, select_2443[22], 1'b0, select_2443[21], 1'b0, select_2443[20], 1'b0, select_2443[19], 1'b0, select_2443[18], 1'b0, select_2443[17], 1'b0, select_2443[16], 1'b0, select_2443[15], 1'b0, select_2443[14], 1'b0, select_2443[13], 1'b0, select_2443[12], 1'b0, select_2443[11], 1'b0, select_2443[10], 1'b0, select_2443[9], 1'b0, select_2443[8], 1'b0, select_2443[7], 1'b0, select_2443[6], 1'b0, select_2443[5], 1'b0, select_2443[4], 1'b0, select_2443[3], 1'b0, select_2443[2], 1'b0, select_2443[1], 1'b0, select_2443[0]};
  // hls/stages/agreement.hpp:976
  logic and_2448;
  assign and_2448 = good_known_q & (~((good_q & select_2444) == 48'h0));
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_2427_s4_q ? and_2448 : not_2463_s4_q;
  // hls/stages/agreement.hpp:1054
  logic and_2478;
  assign and_2478 = is_seen & less_2477_s4_q;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2512;
  assign select_2512 = sample_pair_whole_s4_q ? (and_499_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2514;
  assign select_2514 = sample_pair_whole_s4_q ? (and_499_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2516;
  assign select_2516 = sample_pair_whole_s4_q ? (and_499_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2518;
  assign select_2518 = sample_pair_whole_s4_q ? (and_499_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2523;
  assign sum_2523 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2524;
  assign difference_2524 = {1'b0, sum_2523[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2525;
  assign xor_2525 = {difference_2524[8:0], sum_2523[0]} ^ {10{difference_2524[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2524[9]} + {1'b0, xor_2525};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_504_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2530;
  assign select_2530 = sample_pair_whole_s4_q ? (and_499_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2531;
  assign sum_2531 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2532;
  assign difference_2532 = {1'b0, sum_2531[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2533;
  assign xor_2533 = {difference_2532[8:0], sum_2531[0]} ^ {10{difference_2532[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2532[9]} + {1'b0, xor_2533};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_504_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2538;
  assign select_2538 = sample_pair_whole_s4_q ? (and_499_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2621;
  assign sum_2621 = sum_2617_s4_q + {2'h0, sum_2620_s4_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2623;
  assign select_2623 = and_501_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2624;
  assign select_2624 = and_501_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2625;
  assign select_2625 = and_501_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2626;
  assign select_2626 = and_501_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2629;
  assign sum_2629 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2621};
  logic [13:0] sum_2631;
  assign sum_2631 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2629});
  // hls/stages/census.hpp:305
  logic and_2633;
  assign and_2633 = and_591_s4_q & (9'h4 < sum_2631[13:5]);
  // hls/stages/census.hpp:306
  logic and_2634;
  assign and_2634 = and_591_s4_q & less_615;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2635;
  assign sum_2635 = census_left_misses_q + {{17{and_2634}}, and_2633, 1'b0, and_2633};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2637;
  assign select_2637 = and_501_s4_q ? (equal_2628_s4_q ? 20'h0 : sum_2635) : census_left_misses_q;
  // hls/stages/agreement.hpp:263
  logic [27:0] select_2642;
  assign select_2642 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:507
  logic select_2645;
  assign select_2645 = and_501_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2648;
  assign and_2648 = whole_2_s4_q & (~(column_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:444
  logic and_2654;
  assign and_2654 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2655;
  assign and_2655 = and_2648 & and_2654;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2642[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2657;
  assign select_2657 = and_2655 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2659;
  assign select_2659 = equal_2628_s4_q ? {11'h0, select_2657} : (sharpness_sums_detail_0_q + {11'h0, select_2657});
  // hls/stages/agreement.hpp:444
  logic and_2666;
  assign and_2666 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2667;
  assign and_2667 = and_2648 & and_2666;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2642[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2669;
  assign select_2669 = and_2667 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2671;
  assign select_2671 = equal_2628_s4_q ? {11'h0, select_2669} : (sharpness_sums_detail_1_q + {11'h0, select_2669});
  logic [8:0] select_2674;
  assign select_2674 = and_2655 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2675;
  assign sum_2675 = (equal_2628_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2674};
  logic [8:0] select_2678;
  assign select_2678 = and_2667 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2679;
  assign sum_2679 = (equal_2628_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2678};
  // hls/stages/agreement.hpp:203
  logic equal_2681;
  assign equal_2681 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2682;
  assign less_2682 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2683;
  assign less_2683 = x_s4_q[4:0] < 5'h3;
  logic not_2684;
  assign not_2684 = ~x_s4_q[1];
  logic [2:0] select_2685;
  assign select_2685 = x_s4_q[0] ? {1'b0, not_2684, 1'b0} : {x_s4_q[1], 1'b0, not_2684};
  logic [5:0] select_2686;
  assign select_2686 = slot_s4_q[2] ? {select_2685[2], 1'b0, select_2685[1], 1'b0, select_2685[0], 1'b0} : {1'b0, select_2685[2], 1'b0, select_2685[1], 1'b0, select_2685[0]};
  logic [11:0] select_2687;
  assign select_2687 = slot_s4_q[1] ? {select_2686[5], 1'b0, select_2686[4], 1'b0, select_2686[3], 1'b0, select_2686[2], 1'b0, select_2686[1], 1'b0, select_2686[0], 1'b0} : {1'b0, select_2686[5], 1'b0, select_2686[4], 1'b0, select_2686[3], 1'b0, select_2686[2], 1'b0, select_2686[1], 1'b0, select_2686[0]};
  logic [23:0] select_2688;
  assign select_2688 = slot_s4_q[0] ? {select_2687[11], 1'b0, select_2687[10], 1'b0, select_2687[9], 1'b0, select_2687[8], 1'b0, select_2687[7], 1'b0, select_2687[6], 1'b0, select_2687[5], 1'b0, select_2687[4], 1'b0, select_2687[3], 1'b0, select_2687[2], 1'b0, select_2687[1], 1'b0, select_2687[0], 1'b0} : {1'b0, select_2687[11], 1'b0, select_2687[10], 1'b0, select_2687[9], 1'b0, select_2687[8], 1'b0, select_2687[7], 1'b0, select_2687[6], 1'b0, select_2687[5], 1'b0, select_2687[4], 1'b0, select_2687[3], 1'b0, select_2687[2], 1'b0, select_2687[1], 1'b0, select_2687[0]};
  // hls/stages/census.hpp:372
  logic and_2692;
  assign and_2692 = less_2683 & (~((sharpness_sums_contrast_1_q & select_2688) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2694;
  assign select_2694 = (less_2682 & and_2692) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2694};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2697;
  assign select_2697 = equal_2681 ? (less_2682 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2702;
  assign and_2702 = less_2683 & (~((sharpness_sums_contrast_0_q & select_2688) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2704;
  assign select_2704 = (less_2682 & and_2702) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2704};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2707;
  assign select_2707 = equal_2681 ? (less_2682 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2709;
  assign select_2709 = equal_2681 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2711;
  assign select_2711 = equal_2681 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2713;
  assign select_2713 = equal_2681 ? {sharpness_comparing_contrast_0_q[0], and_2702} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2715;
  assign select_2715 = equal_2681 ? {sharpness_comparing_contrast_1_q[0], and_2692} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:207
  logic select_2720;
  assign select_2720 = drew_q ? (equal_2681 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:207
  logic select_2724;
  assign select_2724 = drew_q ? (equal_2681 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2725;
  assign equal_2725 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2726;
  assign xor_2726 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2729;
  assign select_2729 = (equal_2725 | xor_2726) ? (five_times[0] & xor_2726) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2731;
  assign select_2731 = drew_q ? (equal_2681 ? select_2729 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2732;
  assign xor_2732 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2735;
  assign select_2735 = (equal_2725 | xor_2732) ? (five_times_2[0] & xor_2732) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2737;
  assign select_2737 = drew_q ? (equal_2681 ? select_2735 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2738;
  assign xor_2738 = sharpness_comparing_contrast_0_q[1] ^ and_2692;
  logic select_2741;
  assign select_2741 = (equal_2725 | xor_2738) ? (and_2692 & xor_2738) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2743;
  assign select_2743 = drew_q ? (equal_2681 ? select_2741 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2744;
  assign xor_2744 = sharpness_comparing_contrast_1_q[1] ^ and_2702;
  logic select_2747;
  assign select_2747 = (equal_2725 | xor_2744) ? (and_2702 & xor_2744) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2749;
  assign select_2749 = drew_q ? (equal_2681 ? select_2747 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2855;
  assign select_2855 = and_2849_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2853_s4_q});
  // hls/stages/patches.hpp:330
  logic and_2858;
  assign and_2858 = not_1944_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2863;
  assign and_2863 = not_1944_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2868;
  assign and_2868 = not_1944_s4_q & (drew_q & (ends_cell_s4_q & and_2369_s4_q));
  // hls/stages/agreement.hpp:1047
  logic not_2872;
  assign not_2872 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1048
  logic not_2889;
  assign not_2889 = ~(equal_2427_s4_q ? and_2448 : not_2887_s4_q);
  // hls/stages/patches.hpp:330
  logic and_2892;
  assign and_2892 = ends_cell_s4_q & (not_2872 & (centres_values_1_textured_s4_q & not_2889));
  logic and_2894;
  assign and_2894 = not_1944_s4_q & (drew_q & and_2892);
  // hls/stages/agreement.hpp:1074
  logic less_2897;
  assign less_2897 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2898;
  assign select_2898 = less_2897 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2901;
  assign select_2901 = less_2897 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2902;
  assign sum_2902 = {1'b0, select_2901} + {3'h0, select_2901[9:2]};
  logic and_2904;
  assign and_2904 = (~(select_2898[9:4] == 6'h0)) & ({sum_2902, select_2901[1:0]} < {3'h0, select_2898});
  // hls/stages/agreement.hpp:1084
  logic [9:0] select_2907;
  assign select_2907 = x_s4_q[6] ? (equal_1988_s4_q ? 10'h0 : (and_2904 ? select_2898 : 10'h0)) : 10'h0;
  // hls/stages/patches.hpp:330
  logic [9:0] select_2908;
  assign select_2908 = equal_1943_s4_q ? select_2907 : 10'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2910;
  assign select_2910 = and_2849_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2908});
  logic [13:0] select_2917;
  assign select_2917 = and_2849_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2915_s4_q});
  // hls/stages/agreement.hpp:1052
  logic and_2919;
  assign and_2919 = not_2872 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/patches.hpp:330
  logic and_2922;
  assign and_2922 = not_1944_s4_q & (drew_q & (ends_cell_s4_q & and_2919));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2924;
  assign select_2924 = and_2849_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2922});
  // hls/stages/agreement.hpp:1052
  logic and_2926;
  assign and_2926 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2889);
  // hls/stages/patches.hpp:330
  logic and_2930;
  assign and_2930 = not_1944_s4_q & (drew_q & (ends_cell_s4_q & (not_2872 & and_2926)));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2932;
  assign select_2932 = and_2849_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2930});
  // hls/stages/patches.hpp:330
  logic [7:0] select_2981;
  assign select_2981 = drew_q ? (equal_2084_s4_q ? (and_2965_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2982;
  assign select_2982 = equal_1943_s4_q ? 8'h0 : select_2981;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2984;
  assign select_2984 = and_2964_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2982[7]}}, select_2982});
  // hls/stages/patches.hpp:330
  logic and_2987;
  assign and_2987 = not_1944_s4_q & (drew_q & (and_2965_s4_q & equal_2084_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2989;
  assign select_2989 = and_2964_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2987});
  // hls/stages/registration.hpp:107
  logic and_2991;
  assign and_2991 = and_2965_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/patches.hpp:330
  logic [1:0] select_2993;
  assign select_2993 = drew_q ? (equal_2084_s4_q ? {and_2991, and_2965_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2994;
  assign select_2994 = equal_1943_s4_q ? 2'h0 : select_2993;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2995;
  assign sum_2995 = registration_half_votes_down_q + {{5{select_2994[1]}}, select_2994};
  // hls/stages/patches.hpp:330
  logic [1:0] select_3001;
  assign select_3001 = drew_q ? (equal_2084_s4_q ? {and_2999_s4_q, and_2965_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3002;
  assign select_3002 = equal_1943_s4_q ? 2'h0 : select_3001;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3003;
  assign sum_3003 = registration_half_votes_up_q + {{5{select_3002[1]}}, select_3002};
  // hls/stages/registration.hpp:107
  logic and_3006;
  assign and_3006 = and_2965_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/patches.hpp:330
  logic [1:0] select_3008;
  assign select_3008 = drew_q ? (equal_2084_s4_q ? {and_3006, and_2965_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3009;
  assign select_3009 = equal_1943_s4_q ? 2'h0 : select_3008;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3010;
  assign sum_3010 = registration_half_half_votes_down_q + {{5{select_3009[1]}}, select_3009};
  // hls/stages/patches.hpp:330
  logic [1:0] select_3015;
  assign select_3015 = drew_q ? (equal_2084_s4_q ? {and_3013_s4_q, and_2965_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3016;
  assign select_3016 = equal_1943_s4_q ? 2'h0 : select_3015;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3017;
  assign sum_3017 = registration_half_half_votes_up_q + {{5{select_3016[1]}}, select_3016};
  // hls/stages/patches.hpp:330
  logic and_3051;
  assign and_3051 = equal_1943_s4_q & (x_s4_q[6] & (not_2348_s4_q & less_2019_s4_q));
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_3058;
  assign select_3058 = or_2023_s4_q ? 12'h0 : (equal_3056_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_3061;
  assign select_3061 = x_s4_q[6] ? (equal_1988_s4_q ? 12'h0 : (less_2019_s4_q ? select_3058 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:330
  logic [11:0] select_3062;
  assign select_3062 = equal_1943_s4_q ? select_3061 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3063;
  assign and_3063 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_3066;
  assign and_3066 = not_2348_s4_q & (less_2019_s4_q & ({and_3063, x_s4_q[0]} == 2'h0));
  // hls/stages/patches.hpp:330
  logic and_3068;
  assign and_3068 = equal_1943_s4_q & (x_s4_q[6] & and_3066);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3070;
  assign sum_3070 = {{2{select_3062[11]}}, select_3062} + (and_3068 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_3073;
  assign select_3073 = or_2023_s4_q ? 12'h0 : (equal_3056_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_3076;
  assign select_3076 = x_s4_q[6] ? (equal_1988_s4_q ? 12'h0 : (less_2019_s4_q ? select_3073 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:330
  logic [11:0] select_3077;
  assign select_3077 = equal_1943_s4_q ? select_3076 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3079;
  assign sum_3079 = {{2{select_3077[11]}}, select_3077} + (and_3068 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3081;
  assign not_3081 = ~all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_3084;
  assign and_3084 = not_2348_s4_q & (less_2019_s4_q & (x_s4_q[2:0] == {all_s4_q, not_3081, 1'b0}));
  // hls/stages/patches.hpp:330
  logic and_3090;
  assign and_3090 = equal_1943_s4_q & (x_s4_q[6] & (not_2348_s4_q & (less_2019_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_3091;
  assign not_3091 = ~and_3090;
  logic less_3092;
  assign less_3092 = $signed({9'h1, {2{not_3091}}, and_3090}) < $signed(registration_up_q[13:2]);
  logic select_3093;
  assign select_3093 = (equal_1943_s4_q & (x_s4_q[6] & and_3084)) ? less_3092 : registration_enough_q;
  // hls/stages/agreement.hpp:1084
  logic and_3097;
  assign and_3097 = x_s4_q[6] & (not_2348_s4_q & (less_2019_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:330
  logic and_3098;
  assign and_3098 = equal_1943_s4_q & and_3097;
  // hls/stages/registration.hpp:242
  logic less_3099;
  assign less_3099 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3101;
  assign less_3101 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3103;
  assign equal_3103 = x_s4_q[2:0] == 3'h7;
  // hls/stages/patches.hpp:330
  logic and_3107;
  assign and_3107 = equal_1943_s4_q & (x_s4_q[6] & (not_2348_s4_q & (less_2019_s4_q & equal_3103)));
  // hls/stages/agreement.hpp:1084
  logic and_3114;
  assign and_3114 = x_s4_q[6] & (not_2348_s4_q & (less_2019_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3117;
  assign equal_3117 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1084
  logic and_3120;
  assign and_3120 = not_2348_s4_q & (less_2019_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_3117));
  // hls/stages/registration.hpp:244
  logic and_3124;
  assign and_3124 = (equal_1943_s4_q & (x_s4_q[6] & and_3120)) & (less_3101 | less_3099);
  // hls/stages/agreement.hpp:1084
  logic and_3129;
  assign and_3129 = not_2348_s4_q & (less_2019_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_3117)));
  // hls/stages/registration.hpp:244
  logic and_3132;
  assign and_3132 = registration_votes_up_q & registration_other_down_q;
  logic select_3134;
  assign select_3134 = registration_votes_down_q ? (registration_other_up_q | and_3132) : and_3132;
  // hls/stages/registration.hpp:138
  logic and_3136;
  assign and_3136 = (equal_1943_s4_q & (x_s4_q[6] & and_3129)) & (registration_other_enough_q & select_3134);
  // hls/stages/registration.hpp:245
  logic or_3139;
  assign or_3139 = registration_moved_q | (registration_enough_q & (and_3124 | and_3136));
  // hls/stages/agreement.hpp:263
  logic [7:0] select_3224;
  assign select_3224 = sample_pair_whole_s4_q ? (equal_2074_s4_q ? patches_place_0_slope_q : select_2175[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3229;
  assign select_3229 = sample_pair_whole_s4_q ? (equal_2074_s4_q ? patches_place_1_slope_q : select_2204[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:119
  logic select_3231;
  assign select_3231 = equal_2074_s4_q ? patches_valid_0_q : (select_2073_s4_q ? patches_valid_0_q : select_2172[0]);
  // hls/stages/agreement.hpp:263
  logic select_3234;
  assign select_3234 = sample_pair_whole_s4_q ? (and_2195 ? (sample_present_s4_q & select_3231) : select_3231) : patches_valid_0_q;
  // hls/stages/patches.hpp:119
  logic select_3236;
  assign select_3236 = equal_2074_s4_q ? patches_valid_1_q : (select_2073_s4_q ? select_2172[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_3239;
  assign select_3239 = sample_pair_whole_s4_q ? (and_2215 ? (sample_present_s4_q & select_3236) : select_3236) : patches_valid_1_q;
  logic [5:0] select_3242;
  assign select_3242 = sample_pair_whole_s4_q ? (select_2193[5] ? {1'b1, select_2193[4:0]} : (select_2193 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3245;
  assign select_3245 = sample_pair_whole_s4_q ? (select_2213[5] ? {1'b1, select_2213[4:0]} : (select_2213 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3248;
  assign select_3248 = sample_pair_whole_s4_q ? (select_2226[4] ? {1'b1, select_2226[3:0]} : (select_2226 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3251;
  assign select_3251 = sample_pair_whole_s4_q ? (select_2231[4] ? {1'b1, select_2231[3:0]} : (select_2231 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:511
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3670_s4_q, parity_3666_s4_q, xor_3654_s4_q, parity_3626_s4_q, parity_3564_s4_q, parity_3435_s4_q} + (equal_3671_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:176
  logic [9:0] select_3675;
  assign select_3675 = equal_2156_s4_q ? patches_sums_values_0_q : (equal_2158_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3676;
  assign select_3676 = equal_2158_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3678;
  assign select_3678 = equal_2158_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3680;
  assign select_3680 = equal_2158_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3682;
  assign select_3682 = equal_2158_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3684;
  assign select_3684 = equal_2158_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3686;
  assign select_3686 = equal_2158_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3688;
  assign select_3688 = equal_2158_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3690;
  assign select_3690 = equal_2158_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3692;
  assign select_3692 = equal_2158_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3694;
  assign select_3694 = equal_2158_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3696;
  assign select_3696 = equal_2158_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3698;
  assign select_3698 = equal_2158_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3700;
  assign select_3700 = equal_2158_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3702;
  assign select_3702 = equal_2158_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3704;
  assign select_3704 = equal_2158_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3706;
  assign select_3706 = equal_2158_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:585
  logic or_3811;
  assign or_3811 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3810_s4_q;
  logic or_3814;
  assign or_3814 = equal_3802_s4_q | (less_3804_s4_q | (less_3805_s4_q | or_3811));
  // hls/stages/patches.hpp:565
  logic not_3815;
  assign not_3815 = ~or_3814;
  // hls/stages/patches.hpp:546
  logic and_3816;
  assign and_3816 = equal_2322_s4_q & not_3815;
  // hls/stages/patches.hpp:176
  logic and_3819;
  assign and_3819 = equal_2156_s4_q & (less_2319_s4_q ? (not_2321_s4_q & and_3816) : and_3816);
  // hls/stages/patches.hpp:636
  logic not_3820;
  assign not_3820 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:546
  logic and_3822;
  assign and_3822 = equal_2322_s4_q & (patches_second_s4_q & not_3815);
  // hls/stages/patches.hpp:176
  logic and_3825;
  assign and_3825 = equal_2156_s4_q & (less_2319_s4_q ? (not_2321_s4_q & and_3822) : and_3822);
  // hls/stages/patches.hpp:636
  logic not_3826;
  assign not_3826 = ~and_3825;
  // hls/stages/patches.hpp:180
  logic and_3828;
  assign and_3828 = and_3819 & (not_3820 & not_3826);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3830;
  assign sum_3830 = {7'h0, and_3828} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:583
  logic [7:0] select_3856;
  assign select_3856 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:582
  logic [5:0] select_3857;
  assign select_3857 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3858;
  assign sum_3858 = {2'h0, select_3790_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3859;
  assign sum_3859 = {select_3857[5], select_3857} + {{3{sum_3858[3]}}, sum_3858};
  // hls/stages/patches.hpp:583
  logic [17:0] product_3860;
  assign product_3860 = $signed({{10{select_3856[7]}}, select_3856}) * $signed({{8{sum_3859[6]}}, sum_3859, select_3790_s4_q[2:0]});
  // hls/stages/patches.hpp:584
  logic [13:0] difference_3861;
  assign difference_3861 = {{6{select_3855_s4_q[7]}}, select_3855_s4_q} - {product_3860[17], product_3860[17:5]};
  // hls/stages/patches.hpp:590
  logic less_3862;
  assign less_3862 = $signed({{7{difference_3832[6]}}, difference_3832}) < $signed(difference_3861);
  // hls/stages/patches.hpp:546
  logic and_3865;
  assign and_3865 = equal_2322_s4_q & (not_3815 & (~less_3862));
  // hls/stages/patches.hpp:176
  logic and_3868;
  assign and_3868 = equal_2156_s4_q & (less_2319_s4_q ? (not_2321_s4_q & and_3865) : and_3865);
  // hls/stages/patches.hpp:639
  logic and_3869;
  assign and_3869 = and_3868 & and_3828;
  logic [7:0] sum_3870;
  assign sum_3870 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3869};
  // hls/stages/patches.hpp:546
  logic and_3874;
  assign and_3874 = not_3815 & (~($signed(difference_3861) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3875;
  assign and_3875 = equal_2322_s4_q & and_3874;
  // hls/stages/patches.hpp:176
  logic and_3878;
  assign and_3878 = equal_2156_s4_q & (less_2319_s4_q ? (not_2321_s4_q & and_3875) : and_3875);
  // hls/stages/patches.hpp:640
  logic and_3879;
  assign and_3879 = and_3878 & and_3828;
  logic [7:0] sum_3880;
  assign sum_3880 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3879};
  // hls/stages/patches.hpp:180
  logic and_3882;
  assign and_3882 = and_3819 & (and_3825 & not_3820);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3884;
  assign sum_3884 = {7'h0, and_3882} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:639
  logic and_3886;
  assign and_3886 = and_3868 & and_3882;
  logic [7:0] sum_3887;
  assign sum_3887 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3886};
  // hls/stages/patches.hpp:640
  logic and_3889;
  assign and_3889 = and_3878 & and_3882;
  logic [7:0] sum_3890;
  assign sum_3890 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3889};
  // hls/stages/patches.hpp:180
  logic and_3892;
  assign and_3892 = and_3819 & (patches_lower_s4_q & not_3826);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3894;
  assign sum_3894 = {7'h0, and_3892} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:639
  logic and_3896;
  assign and_3896 = and_3868 & and_3892;
  logic [7:0] sum_3897;
  assign sum_3897 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3896};
  // hls/stages/patches.hpp:640
  logic and_3899;
  assign and_3899 = and_3878 & and_3892;
  logic [7:0] sum_3900;
  assign sum_3900 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3899};
  // hls/stages/patches.hpp:180
  logic and_3902;
  assign and_3902 = and_3819 & (patches_lower_s4_q & and_3825);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3904;
  assign sum_3904 = {7'h0, and_3902} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:639
  logic and_3906;
  assign and_3906 = and_3868 & and_3902;
  logic [7:0] sum_3907;
  assign sum_3907 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3906};
  // hls/stages/patches.hpp:640
  logic and_3909;
  assign and_3909 = and_3878 & and_3902;
  logic [7:0] sum_3910;
  assign sum_3910 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3909};
  // hls/stages/agreement.hpp:1154
  logic equal_3911;
  assign equal_3911 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1072
  logic less_3912;
  assign less_3912 = x_s4_q[5:3] < 3'h3;
  // hls/stages/patches.hpp:330
  logic and_3916;
  assign and_3916 = equal_1943_s4_q & (x_s4_q[6] & (not_2348_s4_q & (equal_3911 & less_3912)));
  // hls/stages/agreement.hpp:1084
  logic and_3921;
  assign and_3921 = x_s4_q[6] & (not_2348_s4_q & (less_3912 & (x_s4_q[2:0] == 3'h1)));
  // hls/stages/patches.hpp:330
  logic and_3922;
  assign and_3922 = equal_1943_s4_q & and_3921;
  // hls/stages/patches.hpp:607
  logic [7:0] or_3924;
  assign or_3924 = (and_3916 ? patches_quarters_0_places_q : 8'h0) | (and_3922 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1084
  logic and_3928;
  assign and_3928 = x_s4_q[6] & (not_2348_s4_q & (less_3912 & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/patches.hpp:330
  logic and_3929;
  assign and_3929 = equal_1943_s4_q & and_3928;
  // hls/stages/agreement.hpp:1084
  logic and_3935;
  assign and_3935 = x_s4_q[6] & (not_2348_s4_q & (less_3912 & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:330
  logic and_3936;
  assign and_3936 = equal_1943_s4_q & and_3935;
  // hls/stages/patches.hpp:607
  logic [7:0] or_3938;
  assign or_3938 = (or_3924 | (and_3929 ? patches_quarters_2_places_q : 8'h0)) | (and_3936 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:191
  logic select_3942;
  assign select_3942 = (x_s4_q[5:3] == 3'h2) ? x_s4_q[1] : (x_s4_q[0] & (x_s4_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:330
  logic and_3946;
  assign and_3946 = equal_1943_s4_q & (x_s4_q[6] & (not_2348_s4_q & (less_3912 & select_3942)));
  // hls/stages/patches.hpp:608
  logic [7:0] select_3948;
  assign select_3948 = and_3916 ? (and_3946 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3950;
  assign select_3950 = and_3922 ? (and_3946 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3953;
  assign select_3953 = and_3929 ? (and_3946 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3956;
  assign select_3956 = and_3936 ? (and_3946 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:609
  logic [7:0] select_3959;
  assign select_3959 = and_3916 ? (and_3946 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3961;
  assign select_3961 = and_3922 ? (and_3946 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3964;
  assign select_3964 = and_3929 ? (and_3946 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3967;
  assign select_3967 = and_3936 ? (and_3946 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:194
  logic [4:0] sum_3969;
  assign sum_3969 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1084
  logic and_3973;
  assign and_3973 = x_s4_q[6] & (not_2348_s4_q & (less_3912 & (sum_3969[4:2] == 3'h0)));
  // hls/stages/patches.hpp:330
  logic and_3974;
  assign and_3974 = equal_1943_s4_q & and_3973;
  // hls/stages/patches.hpp:604
  logic [7:0] select_3977;
  assign select_3977 = and_3974 ? (patches_word_places_q + (and_3922 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3980;
  assign select_3980 = and_3974 ? (patches_word_up_q + (and_3922 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3983;
  assign select_3983 = and_3974 ? (patches_word_down_q + (and_3922 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3987;
  assign select_3987 = ($signed(difference_3861[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3861[5:0];
  logic [5:0] select_3988;
  assign select_3988 = ($signed(14'h10) < $signed(difference_3861)) ? 6'h10 : select_3987;
  // hls/stages/patches.hpp:546
  logic [5:0] select_3990;
  assign select_3990 = equal_2322_s4_q ? (or_3814 ? 6'h0 : select_3988) : 6'h0;
  logic [5:0] select_3992;
  assign select_3992 = less_2319_s4_q ? (equal_2320_s4_q ? 6'h0 : select_3990) : select_3990;
  // hls/stages/patches.hpp:642
  logic [5:0] select_3994;
  assign select_3994 = and_3819 ? (equal_2156_s4_q ? select_3992 : 6'h0) : 6'h0;
  logic [11:0] sum_3995;
  assign sum_3995 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3994[5]}}, select_3994};
  // hls/stages/patches.hpp:330
  logic and_3999;
  assign and_3999 = equal_1943_s4_q & (x_s4_q[6] & (not_2348_s4_q & (equal_3103 & less_3912)));
  // hls/stages/agreement.hpp:1084
  logic and_4003;
  assign and_4003 = x_s4_q[6] & (not_2348_s4_q & (less_3912 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:330
  logic and_4004;
  assign and_4004 = equal_1943_s4_q & and_4003;
  // hls/stages/patches.hpp:629
  logic [7:0] select_4006;
  assign select_4006 = and_3999 ? (and_4004 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:631
  logic or_4010;
  assign or_4010 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:632
  logic or_4013;
  assign or_4013 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:633
  logic [8:0] sum_4014;
  assign sum_4014 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:628
  logic select_4016;
  assign select_4016 = and_3999 ? (and_4004 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:330
  logic and_4021;
  assign and_4021 = equal_1943_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_4018_s4_q));
  // hls/stages/patches.hpp:180
  logic and_4023;
  assign and_4023 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:628
  logic [2:0] select_4025;
  assign select_4025 = and_4004 ? {and_4023, patches_found_q[2:1]} : (and_3999 ? {and_4023, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:627
  logic or_4029;
  assign or_4029 = patches_partly_q | (patches_doubted_q & (~and_4004));
  // hls/stages/patches.hpp:628
  logic select_4032;
  assign select_4032 = and_3999 ? (and_4004 ? or_4029 : (and_3999 ? or_4029 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:626
  logic select_4033;
  assign select_4033 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:617
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:618
  logic select_4043;
  assign select_4043 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:619
  logic and_4049;
  assign and_4049 = patches_frame_ended_q & (~patches_age_q[9]);
  logic [9:0] sum_4050;
  assign sum_4050 = patches_age_q + {9'h0, and_4049};
  logic [9:0] select_4053;
  assign select_4053 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4050)) : sum_4050;
  // hls/stages/agreement.hpp:1126
  logic or_4110;
  assign or_4110 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1148
  logic equal_4112;
  assign equal_4112 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1158
  logic select_4118;
  assign select_4118 = (equal_4112 & equal_3911) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_4121;
  assign sum_4121 = {1'b0, select_2901} + {2'h0, select_2901[9:1]};
  logic select_4124;
  assign select_4124 = (select_2898[9:3] == 7'h0) ? ((~or_4110) & (~select_4118)) : (~({sum_4121, select_2901[0]} < {2'h0, select_2898}));
  // hls/stages/agreement.hpp:1084
  logic [47:0] select_4126;
  assign select_4126 = x_s4_q[6] ? (equal_1988_s4_q ? good_q : {select_4124, good_q[47:1]}) : good_q;
  // hls/stages/patches.hpp:330
  logic select_4130;
  assign select_4130 = equal_1943_s4_q ? ((x_s4_q[6] & good_known_q) | equal_4018_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1148
  logic equal_4131;
  assign equal_4131 = x_s4_q[6:3] == 4'ha;
  logic equal_4133;
  assign equal_4133 = x_s4_q[6:3] == 4'h9;
  logic equal_4134;
  assign equal_4134 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_4136;
  assign select_4136 = equal_4133 ? counts_skin_unproven_q : (equal_4134 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4131 ? counts_nearer_q : select_4136;
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1161
  logic select_4139;
  assign select_4139 = (equal_4131 & equal_3911) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1086
  logic not_4140;
  assign not_4140 = ~hidden_for_q[7];
  logic [7:0] select_4142;
  assign select_4142 = select_4139 ? (hidden_for_q + {7'h0, not_4140}) : 8'h0;
  // hls/stages/patches.hpp:330
  logic [7:0] select_4144;
  assign select_4144 = equal_1943_s4_q ? (equal_4018_s4_q ? select_4142 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_4145;
  assign select_4145 = equal_3911 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_4147;
  assign select_4147 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4149;
  assign select_4149 = equal_4134 ? cfg_unproven_skin_limit_i : (equal_4112 ? cfg_unproven_limit_i : select_4147);
  logic [7:0] limit;
  assign limit = equal_4131 ? cfg_regions_limit_i : (equal_4133 ? cfg_hidden_limit_i : select_4149);
  // hls/stages/agreement.hpp:1161
  logic not_4152;
  assign not_4152 = ~x_s4_q[2];
  logic [3:0] select_4153;
  assign select_4153 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_4152, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_4152};
  logic [7:0] select_4154;
  assign select_4154 = x_s4_q[0] ? {select_4153[3], 1'b0, select_4153[2], 1'b0, select_4153[1], 1'b0, select_4153[0], 1'b0} : {1'b0, select_4153[3], 1'b0, select_4153[2], 1'b0, select_4153[1], 1'b0, select_4153[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_4158;
  assign select_4158 = equal_4133 ? counts_skin_supervised_q : (equal_4134 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_4131 ? counts_textured_q : select_4158;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_4160;
  assign select_4160 = ((limit & select_4154) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4145} + {1'b0, select_4160};
  // hls/stages/patches.hpp:330
  logic select_4165;
  assign select_4165 = equal_1943_s4_q ? (equal_3911 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1159
  logic and_4170;
  assign and_4170 = too_much_q & (~(equal_4134 & equal_3911));
  // hls/stages/agreement.hpp:1160
  logic select_4175;
  assign select_4175 = (over[14] & equal_3911) ? (and_4170 | ((equal_4134 | equal_4133) | (x_s4_q[6:3] == 4'hf))) : and_4170;
  // hls/stages/agreement.hpp:1235
  logic [1:0] select_4293;
  assign select_4293 = and_4292_s4_q ? {and_2478, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1236
  logic and_4294;
  assign and_4294 = proven_q & less_4282;
  // hls/stages/agreement.hpp:424
  logic select_4297;
  assign select_4297 = and_2408_s4_q ? (less_2409_s4_q ? (select_4293[0] & and_4294) : seen_q) : seen_q;
  logic select_4300;
  assign select_4300 = and_2408_s4_q ? (less_2409_s4_q ? (select_4293[1] & and_4294) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1169
  logic or_4308;
  assign or_4308 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4307_s4_q;
  // hls/stages/agreement.hpp:1171
  logic not_4316;
  assign not_4316 = ~(or_4110 | not_4301);
  // hls/stages/patches.hpp:330
  logic and_4320;
  assign and_4320 = equal_1943_s4_q & (equal_4018_s4_q & (not_4316 & (select_4118 | select_4175)));
  logic and_4323;
  assign and_4323 = equal_4018_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1088
  logic or_4327;
  assign or_4327 = select_2731 | (select_2743 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/patches.hpp:330
  logic and_4334;
  assign and_4334 = equal_1943_s4_q & (equal_4018_s4_q & (not_4316 & (select_2737 | select_2749)));
  // hls/stages/agreement.hpp:1088
  logic and_4339;
  assign and_4339 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4142 < cfg_hidden_frames_i));
  // hls/stages/patches.hpp:330
  logic and_4346;
  assign and_4346 = equal_1943_s4_q & (x_s4_q[6] & (not_2348_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_4354;
  assign select_4354 = equal_2010_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4352_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4355;
  assign select_4355 = equal_2008_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4354;
  logic [31:0] select_4356;
  assign select_4356 = equal_2006_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4355;
  logic [31:0] select_4357;
  assign select_4357 = equal_2004_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_4356;
  logic [31:0] select_4358;
  assign select_4358 = equal_2002_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_4357;
  logic [31:0] select_4359;
  assign select_4359 = equal_2000_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4358;
  logic [31:0] select_4360;
  assign select_4360 = equal_1998_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4359;
  logic [31:0] select_4361;
  assign select_4361 = equal_1996_s4_q ? {9'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4360;
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_4362;
  assign select_4362 = less_2897 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1084
  logic [31:0] select_4363;
  assign select_4363 = equal_1988_s4_q ? select_4361 : {2'h0, select_4362, select_2901, select_2898};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_501_s4_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s4_q, and_616, and_592_s4_q, and_591_s4_q, and_566_s4_q, less_558_s4_q, less_557_s4_q, less_556_s4_q, less_555_s4_q, less_554_s4_q, less_553_s4_q, less_552_s4_q, less_551_s4_q, less_550_s4_q, less_549_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q, less_545_s4_q, less_544_s4_q, less_543_s4_q, less_542_s4_q, less_541_s4_q, less_540_s4_q, less_539_s4_q, less_538_s4_q, less_537_s4_q, less_536_s4_q, less_535_s4_q};
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
  assign registration_sums_waddr = {sum_1994_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_2053_s4_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2052, sum_2048};
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

  // Memory patches_choices, write
  logic [5:0] patches_choices_waddr;
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_2082_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_2155_s4_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2148_s4_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {^patches_choices_wdata, patches_choices_wdata};
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
  assign patches_right_0_waddr = {select_2186_s4_q, select_2183};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_2195);
  logic [7:0] patches_right_0_wdata;
  assign patches_right_0_wdata = sample_pair_pixel_1_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= {^patches_right_0_wdata, patches_right_0_wdata};
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
  assign patches_right_1_waddr = {select_2186_s4_q, select_2212};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_2215);
  logic [7:0] patches_right_1_wdata;
  assign patches_right_1_wdata = sample_pair_pixel_1_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= {^patches_right_1_wdata, patches_right_1_wdata};
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
  assign patches_left_waddr = {select_2234, select_2233_s4_q, column_7};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_2240);
  logic [7:0] patches_left_wdata;
  assign patches_left_wdata = sample_pair_pixel_0_s4_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= {^patches_left_wdata, patches_left_wdata};
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
  logic [14:0] patches_rows_wdata;
  assign patches_rows_wdata = select_2336;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= {^patches_rows_wdata, patches_rows_wdata};
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
  assign regions_waddr = {region_row_s4_q, or_2346_s4_q, or_2343_s4_q, or_2340_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_2374_s4_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2373, sum_2367, sum_2362};
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
  assign map_waddr = {sum_2414_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_2488_s4_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2478, is_seen};
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
      patches_place_0_valid_q <= 1'b0;
      patches_place_0_column_q <= 8'h0;
      patches_place_0_shift_q <= 6'h0;
      patches_place_0_slope_q <= 8'h0;
      patches_place_1_valid_q <= 1'b0;
      patches_place_1_column_q <= 8'h0;
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
      census_left_misses_q <= select_2637;
      sharpness_before_last_mask_q <= select_2645;
      sharpness_sums_detail_0_q <= and_501_s4_q ? select_2659 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_501_s4_q ? select_2671 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_501_s4_q ? sum_2675 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_501_s4_q ? sum_2679 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2697 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2707 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2709 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2711 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2713 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2715 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2720;
      sharpness_comparing_carry_1_q <= select_2724;
      sharpness_comparing_less_detail_0_q <= select_2731;
      sharpness_comparing_less_detail_1_q <= select_2737;
      sharpness_comparing_less_contrast_0_q <= select_2743;
      sharpness_comparing_less_contrast_1_q <= select_2749;
      counts_supervised_q <= select_2855;
      counts_textured_q <= and_2849_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2858});
      counts_explained_q <= and_2849_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2863});
      counts_nearer_q <= and_2849_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2868});
      counts_unproven_q <= and_2849_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2894});
      counts_regions_bad_q <= select_2910;
      counts_skin_supervised_q <= select_2917;
      counts_skin_textured_q <= select_2924;
      counts_skin_unproven_q <= select_2932;
      registration_half_across_q <= select_2984;
      registration_half_measured_q <= select_2989;
      registration_half_votes_down_q <= and_2964_s4_q ? 7'h0 : sum_2995;
      registration_half_votes_up_q <= and_2964_s4_q ? 7'h0 : sum_3003;
      registration_half_half_votes_down_q <= and_2964_s4_q ? 7'h0 : sum_3010;
      registration_half_half_votes_up_q <= and_2964_s4_q ? 7'h0 : sum_3017;
      registration_down_q <= and_3051 ? sum_3070 : registration_down_q;
      registration_up_q <= and_3051 ? sum_3079 : registration_up_q;
      registration_enough_q <= select_3093;
      registration_votes_down_q <= and_3098 ? less_3099 : registration_votes_down_q;
      registration_votes_up_q <= and_3098 ? less_3101 : registration_votes_up_q;
      registration_other_enough_q <= and_3107 ? select_3093 : registration_other_enough_q;
      registration_other_down_q <= and_3107 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3107 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1943_s4_q & and_3114)) & or_3139;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_2174 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_2176 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_2177 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3224;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_2203 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_2205 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_2206 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3229;
      patches_valid_0_q <= select_3234;
      patches_valid_1_q <= select_3239;
      patches_right_next_0_q <= select_3242;
      patches_right_next_1_q <= select_3245;
      patches_left_next_0_q <= select_3248;
      patches_left_next_1_q <= select_3251;
      patches_sums_values_0_q <= select_3675;
      patches_sums_values_1_q <= equal_2156_s4_q ? patches_sums_values_1_q : select_3676;
      patches_sums_values_2_q <= equal_2156_s4_q ? patches_sums_values_2_q : select_3678;
      patches_sums_values_3_q <= equal_2156_s4_q ? patches_sums_values_3_q : select_3680;
      patches_sums_values_4_q <= equal_2156_s4_q ? patches_sums_values_4_q : select_3682;
      patches_sums_values_5_q <= equal_2156_s4_q ? patches_sums_values_5_q : select_3684;
      patches_sums_values_6_q <= equal_2156_s4_q ? patches_sums_values_6_q : select_3686;
      patches_sums_values_7_q <= equal_2156_s4_q ? patches_sums_values_7_q : select_3688;
      patches_sums_values_8_q <= equal_2156_s4_q ? patches_sums_values_8_q : select_3690;
      patches_sums_values_9_q <= equal_2156_s4_q ? patches_sums_values_9_q : select_3692;
      patches_sums_values_10_q <= equal_2156_s4_q ? patches_sums_values_10_q : select_3694;
      patches_sums_values_11_q <= equal_2156_s4_q ? patches_sums_values_11_q : select_3696;
      patches_sums_values_12_q <= equal_2156_s4_q ? patches_sums_values_12_q : select_3698;
      patches_sums_values_13_q <= equal_2156_s4_q ? patches_sums_values_13_q : select_3700;
      patches_sums_values_14_q <= equal_2156_s4_q ? patches_sums_values_14_q : select_3702;
      patches_sums_values_15_q <= equal_2156_s4_q ? patches_sums_values_15_q : select_3704;
      patches_sums_values_16_q <= equal_2156_s4_q ? patches_sums_values_16_q : select_3706;
      patches_best_differing_q <= select_2336[9:0];
      patches_best_column_q <= select_2336[14:10];
      patches_quarters_0_places_q <= sum_3830;
      patches_quarters_0_up_q <= sum_3870;
      patches_quarters_0_down_q <= sum_3880;
      patches_quarters_1_places_q <= sum_3884;
      patches_quarters_1_up_q <= sum_3887;
      patches_quarters_1_down_q <= sum_3890;
      patches_quarters_2_places_q <= sum_3894;
      patches_quarters_2_up_q <= sum_3897;
      patches_quarters_2_down_q <= sum_3900;
      patches_quarters_3_places_q <= sum_3904;
      patches_quarters_3_up_q <= sum_3907;
      patches_quarters_3_down_q <= sum_3910;
      patches_word_places_q <= or_3938;
      patches_word_up_q <= ((select_3948 | select_3950) | select_3953) | select_3956;
      patches_word_down_q <= ((select_3959 | select_3961) | select_3964) | select_3967;
      patches_sum_places_q <= select_3977;
      patches_sum_up_q <= select_3980;
      patches_sum_down_q <= select_3983;
      patches_across_q <= sum_3995;
      patches_places_q <= select_4006;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4010;
      patches_partly_q <= or_4013;
      patches_clear_limit_q <= sum_4014[8:2];
      patches_complete_q <= select_4016;
      patches_frame_ended_q <= and_4021;
      patches_round_ends_q <= patches_complete_q & and_4021;
      patches_found_q <= and_3999 ? select_4025 : patches_found_q;
      patches_doubted_q <= select_4032;
      patches_doubted_before_q <= select_4033;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4043;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4053;
      segment_textured_q <= select_2359 + {6'h0, and_2858};
      segment_explained_q <= select_2364 + {6'h0, and_2863};
      segment_nearer_q <= select_2370 + {6'h0, and_2868};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1943_s4_q ? select_4126 : good_q;
      good_known_q <= select_4130;
      hidden_for_q <= select_4144;
      product_q <= equal_1943_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4165;
      disagree_q <= equal_1943_s4_q ? select_4118 : disagree_q;
      too_much_q <= equal_1943_s4_q ? select_4175 : too_much_q;
      hides_q <= equal_1943_s4_q ? select_4139 : hides_q;
      seen_q <= select_4297;
      nearer_q <= select_4300;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
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
      left_pixel_q <= left_pixel_q;
      averager_quarter_1_0_q <= select_2512;
      averager_quarter_1_1_q <= select_2514;
      averager_quarter_2_0_q <= select_2516;
      averager_quarter_2_1_q <= select_2518;
      averager_detail_0_q <= select_2530;
      averager_detail_1_q <= select_2538;
      census_changes_values_0_left_q <= and_501_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_501_s4_q ? sum_2621 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2623;
      census_changes_values_1_right_q <= select_2624;
      census_changes_values_2_left_q <= select_2625;
      census_changes_values_2_right_q <= select_2626;
      sharpness_last_mask_q <= and_501_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_501_s4_q ? select_2642[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_501_s4_q ? select_2642[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_4277_s5_q;
  logic or_4302_s5_q;
  logic and_4303_s5_q;
  logic and_4311_s5_q;
  logic and_4314_s5_q;
  logic and_4320_s5_q;
  logic and_4324_s5_q;
  logic and_4330_s5_q;
  logic and_4334_s5_q;
  logic and_4342_s5_q;
  logic and_4346_s5_q;
  logic [5:0] select_4348_s5_q;
  logic [31:0] select_4365_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_0_q;
      pixel_1_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_4277_s5_q <= said_q;
      or_4302_s5_q <= not_4301 | select_4297;
      and_4303_s5_q <= cfg_prove_i & select_4300;
      and_4311_s5_q <= equal_1943_s4_q & (equal_4018_s4_q & (cfg_prove_i & or_4308));
      and_4314_s5_q <= equal_1943_s4_q & (equal_4018_s4_q & (cfg_prove_i & or_4110));
      and_4320_s5_q <= and_4320;
      and_4324_s5_q <= equal_1943_s4_q & and_4323;
      and_4330_s5_q <= equal_1943_s4_q & (equal_4018_s4_q & (not_4316 & or_4327));
      and_4334_s5_q <= and_4334;
      and_4342_s5_q <= equal_1943_s4_q & (equal_4018_s4_q & (cfg_prove_i & and_4339));
      and_4346_s5_q <= and_4346;
      select_4348_s5_q <= equal_1943_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_4365_s5_q <= equal_1943_s4_q ? (x_s4_q[6] ? select_4363 : 32'h0) : 32'h0;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (averager_memory_error | census_memory_error | fresh_error | left_error | right_codes_error | best_left_error | best_right_error | shown_right_error | registration_sums_error | patches_choices_error | patches_right_0_error | patches_right_1_error | patches_left_error | patches_columns_above_error | patches_right_codes_error | patches_left_codes_error | patches_rows_error | regions_error | seen_columns_error | map_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign pixel_1_o = pixel_1_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_4302_s5_q;
  assign marks_nearer_o = and_4303_s5_q;
  assign verdict_valid_o = and_4277_s5_q;
  assign verdict_unproven_yet_o = and_4311_s5_q;
  assign verdict_untextured_o = and_4314_s5_q;
  assign verdict_disagree_o = and_4320_s5_q;
  assign verdict_moved_o = and_4324_s5_q;
  assign verdict_unsharp_left_o = and_4330_s5_q;
  assign verdict_unsharp_right_o = and_4334_s5_q;
  assign verdict_hidden_o = and_4342_s5_q;
  assign frame_valid_o = and_4346_s5_q;
  assign frame_index_o = select_4348_s5_q;
  assign frame_word_o = select_4365_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_4014[1:0], sum_3969[1:0], product_3860[4:0], sum_2954[0], detail_4[1:0], detail_3[1:0], sum_2631[4:0], sum_2096[0], sum_2092[0], sum_614[4:0], cfg_width_i[2:0]};

endmodule
