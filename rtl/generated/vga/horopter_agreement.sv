// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2840 bits, pipeline 907 bits, memories 99716 bits.
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
  logic [5:0] sum_2797;
  assign sum_2797 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3773;
  assign difference_3773 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_3993;
  assign difference_3993 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4195;
  assign less_4195 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4196;
  assign sum_4196 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_4214;
  assign not_4214 = ~cfg_prove_i;

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
  logic [2:0] select_452;
  assign select_452 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_454;
  assign select_454 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [8:0] select_457;
  assign select_457 = ({select_454, select_452} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_458;
  assign select_458 = select_452[0] ? averager_place_q : select_457;
  // hls/stages/census.hpp:41
  logic or_459;
  assign or_459 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_462;
  assign and_462 = (select_452[0] & or_459) & (select_458[8:6] < 3'h5);
  // hls/stages/census.hpp:41
  logic [2:0] select_467;
  assign select_467 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_454 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_484;
  assign equal_484 = select_452 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_485;
  assign equal_485 = select_467 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_486;
  assign and_486 = equal_485 & and_462;
  // hls/stages/agreement.hpp:263
  logic and_488;
  assign and_488 = sample_pair_whole_q & (equal_484 & and_486);
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:610
  logic equal_508;
  assign equal_508 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:581
  logic or_509;
  assign or_509 = so | equal_508;
  logic not_510;
  assign not_510 = ~or_509;
  // hls/stages/agreement.hpp:601
  logic equal_511;
  assign equal_511 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_513;
  assign equal_513 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:579
  logic [7:0] sum_514;
  assign sum_514 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_515;
  assign select_515 = run_shift_q[5] ? x_q : sum_514;
  logic less_516;
  assign less_516 = {1'b0, last_q} < select_515;
  // hls/stages/agreement.hpp:216
  logic not_517;
  assign not_517 = ~less_516;
  // hls/stages/agreement.hpp:141
  logic and_518;
  assign and_518 = equal_513 & not_517;
  logic and_520;
  assign and_520 = not_510 & ((~equal_511) & and_518);
  // hls/stages/census.hpp:41
  logic [5:0] select_547;
  assign select_547 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_547 : 6'h0;
  // hls/stages/agreement.hpp:141
  logic select_604;
  assign select_604 = equal_511 ? not_517 : and_518;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:141
  logic and_628;
  assign and_628 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_515)));
  logic and_629;
  assign and_629 = equal_511 & and_628;
  logic select_630;
  assign select_630 = or_509 ? not_517 : and_629;
  // hls/stages/agreement.hpp:778
  logic equal_633;
  assign equal_633 = {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:782
  logic or_635;
  assign or_635 = equal_633 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:794
  logic [6:0] right;
  assign right = sum_514[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:263
  logic [2:0] select_2447;
  assign select_2447 = sample_pair_whole_q ? (sample_last_q ? (select_467 + 3'h1) : select_467) : raster_at_y_q;
  logic [6:0] select_2449;
  assign select_2449 = sample_pair_whole_q ? (select_454 + {6'h0, equal_484}) : raster_at_column_q;
  logic [5:0] select_2452;
  assign select_2452 = sample_pair_whole_q ? (sample_last_q ? (select_547 + {5'h0, equal_485}) : select_547) : raster_at_row_q;
  logic select_2456;
  assign select_2456 = sample_pair_whole_q ? (sample_last_q ? (or_459 & (~raster_final_row_q)) : or_459) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2458;
  assign select_2458 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:263
  logic select_2462;
  assign select_2462 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2706;
  assign equal_2706 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:451
  logic and_2707;
  assign and_2707 = and_488 & equal_2706;
  // hls/stages/agreement.hpp:510
  logic select_2710;
  assign select_2710 = (and_2707 | (~ends_cell_q)) ? and_2707 : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2710 ? (and_2707 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2714;
  assign select_2714 = select_2710 ? (and_2707 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2717;
  assign select_2717 = select_2710 ? (following_last_shift_q & (~and_2707)) : run_last_shift_q;
  // hls/stages/agreement.hpp:594
  logic and_2720;
  assign and_2720 = run_last_shift_q & equal_511;
  // hls/stages/agreement.hpp:603
  logic select_2722;
  assign select_2722 = equal_511 ? (~run_last_shift_q) : equal_513;
  // hls/stages/agreement.hpp:607
  logic equal_2723;
  assign equal_2723 = run_phase_q == 3'h1;
  logic not_2726;
  assign not_2726 = ~select_2722;
  // hls/stages/agreement.hpp:610
  logic equal_2728;
  assign equal_2728 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2729;
  assign and_2729 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2730;
  assign select_2730 = equal_2728 ? 2'h1 : {2{and_2729}};
  logic [2:0] select_2732;
  assign select_2732 = (and_2720 | (select_2722 | equal_2723)) ? (equal_2723 ? 3'h2 : {not_2726, {2{select_2722}}}) : (equal_508 ? 3'h6 : {select_2730[0], select_2730});
  // hls/stages/agreement.hpp:594
  logic and_2735;
  assign and_2735 = select_2722 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2738;
  assign select_2738 = (plan_shift_q[5] & select_2722) ? value : 7'h0;
  logic [1:0] or_2739;
  assign or_2739 = {2{so}} | select_2738[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] or_2743;
  assign or_2743 = (select_2722 ? plan_columns_q : 8'h0) | ((equal_2723 | equal_2728) ? whole_q : 8'h0);
  logic [1:0] or_2744;
  assign or_2744 = {2{and_2720}} | or_2743[3:2];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_2746;
  assign or_2746 = {or_2743[7:4], or_2744, or_2743[1:0]} | (equal_508 ? drawn_q : 8'h0);
  logic [4:0] or_2747;
  assign or_2747 = {5{so}} | {or_2746[6], or_2746[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2751;
  assign not_2751 = ~run_shift_q[5];
  logic [7:0] select_2754;
  assign select_2754 = equal_511 ? ({{7{not_2751}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2758;
  assign select_2758 = and_2707 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2760;
  assign select_2760 = select_2710 ? {select_2758[6], select_2758} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2763;
  assign select_2763 = select_2710 ? (and_2707 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:507
  logic [6:0] select_2771;
  assign select_2771 = and_488 ? (equal_2706 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2774;
  assign select_2774 = and_488 ? (equal_2706 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2777;
  assign select_2777 = and_488 ? (equal_2706 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2788;
  assign select_2788 = (ends_cell_q | select_2710) ? (~(now == 3'h6)) : (equal_511 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2792;
  assign and_2792 = (~select_2710) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic [6:0] sum_2793;
  assign sum_2793 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:447
  logic select_2795;
  assign select_2795 = equal_2706 ? ({sum_2793[6], cfg_height_i[8:3]} == {1'b0, sum_2793[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:325
  logic or_3159;
  assign or_3159 = select_454[0] | select_547[5];
  logic [7:0] sum_3160;
  assign sum_3160 = {1'b0, select_454[2:1], or_3159, select_547[4:1]} + 8'h1;
  logic less_3161;
  assign less_3161 = {sum_3160, select_547[0], select_467, 1'b0} < {4'h0, cfg_height_i};

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1292; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 30'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_520;
  logic [29:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [28:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[28:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:1293; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 78'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (or_509 ? not_517 : select_604);
  logic [77:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [76:0] left_rdata_q;
  assign left_rdata_q = left_word_q[76:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:1294; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [91:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 92'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_511 ? sum_514[6:0] : x_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_510 & select_604);
  logic [91:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [90:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[90:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 46 and parity, DISTANCE 12, hls/stages/agreement.hpp:1295; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [46:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 47'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_509 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_630;
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
      raster_at_x_q <= sample_pair_whole_q ? (select_452 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2447;
      raster_at_column_q <= select_2449;
      raster_at_row_q <= select_2452;
      raster_at_live_q <= select_2456;
      raster_rows_left_q <= sample_pair_whole_q ? select_2458 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2462;
      averager_place_q <= sample_pair_whole_q ? select_458 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2714;
      run_last_shift_q <= select_2717;
      run_span_q <= select_2710 ? (and_2707 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2732;
      following_shift_q <= select_2722 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2735;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2738[6], or_2739, select_2738[3:0]};
      following_columns_q <= {or_2746[7], or_2747[4], or_2746[5:4], or_2747[3:0]};
      plan_shift_q <= equal_511 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2754;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2760;
      columns_left_q <= select_2763;
      last_q <= and_488 ? (equal_2706 ? column : last_q) : last_q;
      least_q <= select_2771;
      whole_q <= select_2774;
      drawn_q <= select_2777;
      age_q <= select_2710 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2710 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2788;
      ends_q <= and_2792;
      final_row_q <= and_488 ? select_2795 : final_row_q;
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
  logic [2:0] select_452_s1_q;
  logic [6:0] select_454_s1_q;
  logic [8:0] select_458_s1_q;
  logic and_462_s1_q;
  logic equal_468_s1_q;
  logic [6:0] column_s1_q;
  logic and_486_s1_q;
  logic and_488_s1_q;
  logic so_s1_q;
  logic equal_508_s1_q;
  logic or_509_s1_q;
  logic equal_511_s1_q;
  logic less_516_s1_q;
  logic not_517_s1_q;
  logic and_520_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_630_s1_q;
  logic select_637_s1_q;
  logic and_1912_s1_q;
  logic [6:0] right_s1_q;
  logic select_1921_s1_q;
  logic equal_1930_s1_q;
  logic equal_2049_s1_q;
  logic equal_2706_s1_q;
  logic and_2707_s1_q;
  logic not_3162_s1_q;
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
      select_452_s1_q <= select_452;
      select_454_s1_q <= select_454;
      select_458_s1_q <= select_458;
      and_462_s1_q <= and_462;
      equal_468_s1_q <= select_467 == 3'h0;
      column_s1_q <= column;
      and_486_s1_q <= and_486;
      and_488_s1_q <= and_488;
      so_s1_q <= so;
      equal_508_s1_q <= equal_508;
      or_509_s1_q <= or_509;
      equal_511_s1_q <= equal_511;
      less_516_s1_q <= less_516;
      not_517_s1_q <= not_517;
      and_520_s1_q <= and_520;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_630_s1_q <= select_630;
      select_637_s1_q <= or_635 ? equal_633 : (~age_q[3]);
      and_1912_s1_q <= not_510 & and_629;
      right_s1_q <= right;
      select_1921_s1_q <= or_635 ? equal_633 : ({x[7], last_q} == {1'b0, x[6:0]});
      equal_1930_s1_q <= run_phase_q == 3'h7;
      equal_2049_s1_q <= {or_459, select_467} == 4'hc;
      equal_2706_s1_q <= equal_2706;
      and_2707_s1_q <= and_2707;
      not_3162_s1_q <= ~less_3161;
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
  logic not_608;
  assign not_608 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:656
  logic and_609;
  assign and_609 = left_rdata_q[12] & not_608;
  logic and_610;
  assign and_610 = left_rdata_q[28] & not_608;
  logic and_611;
  assign and_611 = left_rdata_q[44] & not_608;
  logic and_612;
  assign and_612 = left_rdata_q[60] & not_608;
  // hls/stages/agreement.hpp:657
  logic and_616;
  assign and_616 = right_codes_rdata_q[12] & not_608;
  logic and_617;
  assign and_617 = right_codes_rdata_q[25] & not_608;
  logic and_618;
  assign and_618 = right_codes_rdata_q[38] & not_608;
  logic and_619;
  assign and_619 = right_codes_rdata_q[51] & not_608;
  logic and_620;
  assign and_620 = right_codes_rdata_q[64] & not_608;
  logic and_621;
  assign and_621 = right_codes_rdata_q[77] & not_608;
  // hls/stages/agreement.hpp:212
  logic and_643;
  assign and_643 = left_rdata_q[44] & not_517_s1_q;
  logic and_644;
  assign and_644 = right_codes_rdata_q[38] & not_517_s1_q;
  logic [11:0] select_645;
  assign select_645 = less_516_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_646;
  assign select_646 = less_516_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_650;
  assign select_650 = and_643 ? (and_644 ? (~(select_645 ^ select_646)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_656;
  assign parity_656 = ^select_650[5:3];
  logic parity_659;
  assign parity_659 = ^select_650[8:6];
  logic parity_662;
  assign parity_662 = ^select_650[11:3];
  // hls/stages/agreement.hpp:212
  logic and_666;
  assign and_666 = left_rdata_q[60] & not_517_s1_q;
  logic and_667;
  assign and_667 = right_codes_rdata_q[51] & not_517_s1_q;
  logic [11:0] select_668;
  assign select_668 = less_516_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_669;
  assign select_669 = less_516_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_673;
  assign select_673 = and_666 ? (and_667 ? (~(select_668 ^ select_669)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_676;
  assign parity_676 = ^select_673[8:6];
  logic parity_679;
  assign parity_679 = ^select_673[11:9];
  // hls/stages/agreement.hpp:212
  logic and_683;
  assign and_683 = left_rdata_q[76] & not_517_s1_q;
  logic and_684;
  assign and_684 = right_codes_rdata_q[64] & not_517_s1_q;
  logic [11:0] select_685;
  assign select_685 = less_516_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_686;
  assign select_686 = less_516_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_690;
  assign select_690 = and_683 ? (and_684 ? (~(select_685 ^ select_686)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_696;
  assign parity_696 = ^select_690[2:0];
  logic parity_699;
  assign parity_699 = ^select_690[5:3];
  logic parity_702;
  assign parity_702 = ^select_690[8:0];
  logic parity_708;
  assign parity_708 = ^select_690[11:9];
  logic parity_711;
  assign parity_711 = ^select_673[2:0];
  logic parity_714;
  assign parity_714 = ^{select_690[11:9], select_673[5:0]};
  logic parity_717;
  assign parity_717 = ^{select_690, select_673, select_650[2:0]};
  logic xor_718;
  assign xor_718 = parity_662 ^ parity_717;
  // hls/stages/count_bits.hpp:23
  logic or_722;
  assign or_722 = (select_650[1:0] == 2'h3) | (select_650[2] & (select_650[0] | select_650[1]));
  // hls/stages/count_bits.hpp:25
  logic or_726;
  assign or_726 = (select_673[7:6] == 2'h3) | (select_673[8] & (select_673[6] | select_673[7]));
  logic or_730;
  assign or_730 = (select_673[10:9] == 2'h3) | (select_673[11] & (select_673[9] | select_673[10]));
  // hls/stages/count_bits.hpp:23
  logic or_738;
  assign or_738 = (select_690[7:6] == 2'h3) | (select_690[8] & (~(select_690[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_742;
  assign or_742 = (select_690[1:0] == 2'h3) | (select_690[2] & (select_690[0] | select_690[1]));
  logic or_746;
  assign or_746 = (select_690[4:3] == 2'h3) | (select_690[5] & (select_690[3] | select_690[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_749;
  assign parity_749 = ^{or_746, or_742, or_738};
  // hls/stages/count_bits.hpp:23
  logic or_753;
  assign or_753 = (select_673[4:3] == 2'h3) | (select_673[5] & (select_673[3] | select_673[4]));
  // hls/stages/count_bits.hpp:25
  logic or_757;
  assign or_757 = (select_690[10:9] == 2'h3) | (select_690[11] & (select_690[9] | select_690[10]));
  logic or_761;
  assign or_761 = (select_673[1:0] == 2'h3) | (select_673[2] & (select_673[0] | select_673[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_764;
  assign parity_764 = ^{or_761, or_757, or_753};
  logic parity_767;
  assign parity_767 = ^{or_761, or_757, or_753, or_746, or_742, or_738, or_730, or_726, or_722};
  // hls/stages/count_bits.hpp:25
  logic and_768;
  assign and_768 = parity_662 & parity_717;
  logic or_772;
  assign or_772 = (parity_656 & parity_659) | ((^select_650[11:9]) & (parity_656 | parity_659));
  logic and_775;
  assign and_775 = (^{select_673[11:6], select_650[2:0]}) & (parity_702 | parity_714);
  logic or_776;
  assign or_776 = (parity_702 & parity_714) | and_775;
  // hls/stages/count_bits.hpp:23
  logic or_783;
  assign or_783 = (select_650[10:9] == 2'h3) | (select_650[11] & (select_650[9] | select_650[10]));
  // hls/stages/count_bits.hpp:25
  logic or_787;
  assign or_787 = (select_650[4:3] == 2'h3) | (select_650[5] & (select_650[3] | select_650[4]));
  logic or_791;
  assign or_791 = (select_650[7:6] == 2'h3) | (select_650[8] & (select_650[6] | select_650[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_794;
  assign parity_794 = ^{or_791, or_787, or_783};
  // hls/stages/count_bits.hpp:25
  logic or_798;
  assign or_798 = (parity_676 & parity_679) | ((^select_650[2:0]) & (parity_676 | parity_679));
  logic or_802;
  assign or_802 = (parity_696 & parity_699) | ((^select_690[8:6]) & (parity_696 | parity_699));
  logic or_806;
  assign or_806 = (parity_708 & parity_711) | ((^select_673[5:3]) & (parity_708 | parity_711));
  // hls/stages/count_bits.hpp:24
  logic parity_809;
  assign parity_809 = ^{or_806, or_802, or_798};
  logic parity_812;
  assign parity_812 = ^{or_806, or_802, or_798, or_791, or_787, or_783, or_776, or_772, and_768};
  logic xor_813;
  assign xor_813 = parity_767 ^ parity_812;
  // hls/stages/count_bits.hpp:25
  logic and_814;
  assign and_814 = parity_767 & parity_812;
  logic or_818;
  assign or_818 = (parity_749 & parity_764) | ((^{or_730, or_726, or_722}) & (parity_749 | parity_764));
  logic or_822;
  assign or_822 = (parity_794 & parity_809) | ((^{or_776, or_772, and_768}) & (parity_794 | parity_809));
  logic or_829;
  assign or_829 = (or_726 & or_730) | (or_722 & (or_726 | or_730));
  logic or_833;
  assign or_833 = (or_742 & or_746) | (or_738 & (or_742 | or_746));
  logic or_837;
  assign or_837 = (or_757 & or_761) | (or_753 & (or_757 | or_761));
  // hls/stages/count_bits.hpp:24
  logic parity_840;
  assign parity_840 = ^{or_837, or_833, or_829};
  // hls/stages/count_bits.hpp:25
  logic or_844;
  assign or_844 = (or_772 & or_776) | (and_768 & (or_772 | or_776));
  logic or_848;
  assign or_848 = (or_787 & or_791) | (or_783 & (or_787 | or_791));
  logic or_852;
  assign or_852 = (or_802 & or_806) | (or_798 & (or_802 | or_806));
  // hls/stages/count_bits.hpp:24
  logic parity_855;
  assign parity_855 = ^{or_852, or_848, or_844};
  logic parity_858;
  assign parity_858 = ^{or_852, or_848, or_844, or_837, or_833, or_829, or_822, or_818, and_814};
  // hls/stages/count_bits.hpp:25
  logic or_862;
  assign or_862 = (parity_840 & parity_855) | ((^{or_822, or_818, and_814}) & (parity_840 | parity_855));
  logic or_866;
  assign or_866 = (or_818 & or_822) | (and_814 & (or_818 | or_822));
  logic or_870;
  assign or_870 = (or_833 & or_837) | (or_829 & (or_833 | or_837));
  logic or_874;
  assign or_874 = (or_848 & or_852) | (or_844 & (or_848 | or_852));
  // hls/stages/count_bits.hpp:24
  logic parity_879;
  assign parity_879 = ^{or_874, or_870, or_866, or_862};
  // hls/stages/count_bits.hpp:25
  logic or_883;
  assign or_883 = (or_870 & or_874) | (or_866 & (or_870 | or_874));
  logic and_884;
  assign and_884 = or_862 & (^{or_874, or_870, or_866});
  // hls/stages/count_bits.hpp:24
  logic xor_885;
  assign xor_885 = or_883 ^ and_884;
  // hls/stages/count_bits.hpp:27
  logic and_886;
  assign and_886 = or_883 & and_884;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_887;
  assign select_887 = equal_511_s1_q ? {and_886, xor_885, parity_879, parity_858, xor_813, xor_718} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_509_s1_q ? 6'h0 : select_887;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_889;
  assign select_889 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_890;
  assign difference_890 = {1'b0, column_2} - {1'b0, select_889};
  logic [7:0] sum_892;
  assign sum_892 = {difference_890[6], difference_890} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] select_896;
  assign select_896 = and_643 ? (and_667 ? (~(select_668 ^ select_646)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_902;
  assign parity_902 = ^select_896[5:3];
  logic parity_905;
  assign parity_905 = ^select_896[8:6];
  logic parity_908;
  assign parity_908 = ^select_896[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_915;
  assign select_915 = and_666 ? (and_684 ? (~(select_685 ^ select_669)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_918;
  assign parity_918 = ^select_915[8:6];
  logic parity_921;
  assign parity_921 = ^select_915[11:9];
  // hls/stages/agreement.hpp:212
  logic and_925;
  assign and_925 = right_codes_rdata_q[77] & not_517_s1_q;
  logic [11:0] select_926;
  assign select_926 = less_516_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_930;
  assign select_930 = and_683 ? (and_925 ? (~(select_926 ^ select_686)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_936;
  assign parity_936 = ^select_930[2:0];
  logic parity_939;
  assign parity_939 = ^select_930[5:3];
  logic parity_942;
  assign parity_942 = ^select_930[8:0];
  logic parity_948;
  assign parity_948 = ^select_930[11:9];
  logic parity_951;
  assign parity_951 = ^select_915[2:0];
  logic parity_954;
  assign parity_954 = ^{select_930[11:9], select_915[5:0]};
  logic parity_957;
  assign parity_957 = ^{select_930, select_915, select_896[2:0]};
  logic xor_958;
  assign xor_958 = parity_908 ^ parity_957;
  // hls/stages/count_bits.hpp:23
  logic or_962;
  assign or_962 = (select_896[1:0] == 2'h3) | (select_896[2] & (select_896[0] | select_896[1]));
  // hls/stages/count_bits.hpp:25
  logic or_966;
  assign or_966 = (select_915[7:6] == 2'h3) | (select_915[8] & (select_915[6] | select_915[7]));
  logic or_970;
  assign or_970 = (select_915[10:9] == 2'h3) | (select_915[11] & (select_915[9] | select_915[10]));
  // hls/stages/count_bits.hpp:23
  logic or_978;
  assign or_978 = (select_930[7:6] == 2'h3) | (select_930[8] & (~(select_930[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_982;
  assign or_982 = (select_930[1:0] == 2'h3) | (select_930[2] & (select_930[0] | select_930[1]));
  logic or_986;
  assign or_986 = (select_930[4:3] == 2'h3) | (select_930[5] & (select_930[3] | select_930[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_989;
  assign parity_989 = ^{or_986, or_982, or_978};
  // hls/stages/count_bits.hpp:23
  logic or_993;
  assign or_993 = (select_915[4:3] == 2'h3) | (select_915[5] & (select_915[3] | select_915[4]));
  // hls/stages/count_bits.hpp:25
  logic or_997;
  assign or_997 = (select_930[10:9] == 2'h3) | (select_930[11] & (select_930[9] | select_930[10]));
  logic or_1001;
  assign or_1001 = (select_915[1:0] == 2'h3) | (select_915[2] & (select_915[0] | select_915[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1004;
  assign parity_1004 = ^{or_1001, or_997, or_993};
  logic parity_1007;
  assign parity_1007 = ^{or_1001, or_997, or_993, or_986, or_982, or_978, or_970, or_966, or_962};
  // hls/stages/count_bits.hpp:25
  logic and_1008;
  assign and_1008 = parity_908 & parity_957;
  logic or_1012;
  assign or_1012 = (parity_902 & parity_905) | ((^select_896[11:9]) & (parity_902 | parity_905));
  logic and_1015;
  assign and_1015 = (^{select_915[11:6], select_896[2:0]}) & (parity_942 | parity_954);
  logic or_1016;
  assign or_1016 = (parity_942 & parity_954) | and_1015;
  // hls/stages/count_bits.hpp:23
  logic or_1023;
  assign or_1023 = (select_896[10:9] == 2'h3) | (select_896[11] & (select_896[9] | select_896[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1027;
  assign or_1027 = (select_896[4:3] == 2'h3) | (select_896[5] & (select_896[3] | select_896[4]));
  logic or_1031;
  assign or_1031 = (select_896[7:6] == 2'h3) | (select_896[8] & (select_896[6] | select_896[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1034;
  assign parity_1034 = ^{or_1031, or_1027, or_1023};
  // hls/stages/count_bits.hpp:25
  logic or_1038;
  assign or_1038 = (parity_918 & parity_921) | ((^select_896[2:0]) & (parity_918 | parity_921));
  logic or_1042;
  assign or_1042 = (parity_936 & parity_939) | ((^select_930[8:6]) & (parity_936 | parity_939));
  logic or_1046;
  assign or_1046 = (parity_948 & parity_951) | ((^select_915[5:3]) & (parity_948 | parity_951));
  // hls/stages/count_bits.hpp:24
  logic parity_1049;
  assign parity_1049 = ^{or_1046, or_1042, or_1038};
  logic parity_1052;
  assign parity_1052 = ^{or_1046, or_1042, or_1038, or_1031, or_1027, or_1023, or_1016, or_1012, and_1008};
  logic xor_1053;
  assign xor_1053 = parity_1007 ^ parity_1052;
  // hls/stages/count_bits.hpp:25
  logic and_1054;
  assign and_1054 = parity_1007 & parity_1052;
  logic or_1058;
  assign or_1058 = (parity_989 & parity_1004) | ((^{or_970, or_966, or_962}) & (parity_989 | parity_1004));
  logic or_1062;
  assign or_1062 = (parity_1034 & parity_1049) | ((^{or_1016, or_1012, and_1008}) & (parity_1034 | parity_1049));
  logic or_1069;
  assign or_1069 = (or_966 & or_970) | (or_962 & (or_966 | or_970));
  logic or_1073;
  assign or_1073 = (or_982 & or_986) | (or_978 & (or_982 | or_986));
  logic or_1077;
  assign or_1077 = (or_997 & or_1001) | (or_993 & (or_997 | or_1001));
  // hls/stages/count_bits.hpp:24
  logic parity_1080;
  assign parity_1080 = ^{or_1077, or_1073, or_1069};
  // hls/stages/count_bits.hpp:25
  logic or_1084;
  assign or_1084 = (or_1012 & or_1016) | (and_1008 & (or_1012 | or_1016));
  logic or_1088;
  assign or_1088 = (or_1027 & or_1031) | (or_1023 & (or_1027 | or_1031));
  logic or_1092;
  assign or_1092 = (or_1042 & or_1046) | (or_1038 & (or_1042 | or_1046));
  // hls/stages/count_bits.hpp:24
  logic parity_1095;
  assign parity_1095 = ^{or_1092, or_1088, or_1084};
  logic parity_1098;
  assign parity_1098 = ^{or_1092, or_1088, or_1084, or_1077, or_1073, or_1069, or_1062, or_1058, and_1054};
  // hls/stages/count_bits.hpp:25
  logic or_1102;
  assign or_1102 = (parity_1080 & parity_1095) | ((^{or_1062, or_1058, and_1054}) & (parity_1080 | parity_1095));
  logic or_1106;
  assign or_1106 = (or_1058 & or_1062) | (and_1054 & (or_1058 | or_1062));
  logic or_1110;
  assign or_1110 = (or_1073 & or_1077) | (or_1069 & (or_1073 | or_1077));
  logic or_1114;
  assign or_1114 = (or_1088 & or_1092) | (or_1084 & (or_1088 | or_1092));
  // hls/stages/count_bits.hpp:24
  logic parity_1119;
  assign parity_1119 = ^{or_1114, or_1110, or_1106, or_1102};
  // hls/stages/count_bits.hpp:25
  logic or_1123;
  assign or_1123 = (or_1110 & or_1114) | (or_1106 & (or_1110 | or_1114));
  logic and_1124;
  assign and_1124 = or_1102 & (^{or_1114, or_1110, or_1106});
  // hls/stages/count_bits.hpp:24
  logic xor_1125;
  assign xor_1125 = or_1123 ^ and_1124;
  // hls/stages/count_bits.hpp:27
  logic and_1126;
  assign and_1126 = or_1123 & and_1124;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1127;
  assign select_1127 = equal_511_s1_q ? {and_1126, xor_1125, parity_1119, parity_1098, xor_1053, xor_958} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_509_s1_q ? 6'h0 : select_1127;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1129;
  assign select_1129 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1130;
  assign difference_1130 = {1'b0, column_3} - {1'b0, select_1129};
  logic [7:0] sum_1132;
  assign sum_1132 = {difference_1130[6], difference_1130} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:212
  logic and_1133;
  assign and_1133 = right_codes_rdata_q[25] & not_517_s1_q;
  logic [11:0] select_1134;
  assign select_1134 = less_516_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1138;
  assign select_1138 = and_643 ? (and_1133 ? (~(select_1134 ^ select_646)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1144;
  assign parity_1144 = ^select_1138[5:3];
  logic parity_1147;
  assign parity_1147 = ^select_1138[8:6];
  logic parity_1150;
  assign parity_1150 = ^select_1138[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1157;
  assign select_1157 = and_666 ? (and_644 ? (~(select_645 ^ select_669)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1160;
  assign parity_1160 = ^select_1157[8:6];
  logic parity_1163;
  assign parity_1163 = ^select_1157[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1170;
  assign select_1170 = and_683 ? (and_667 ? (~(select_668 ^ select_686)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1176;
  assign parity_1176 = ^select_1170[2:0];
  logic parity_1179;
  assign parity_1179 = ^select_1170[5:3];
  logic parity_1182;
  assign parity_1182 = ^select_1170[8:0];
  logic parity_1188;
  assign parity_1188 = ^select_1170[11:9];
  logic parity_1191;
  assign parity_1191 = ^select_1157[2:0];
  logic parity_1194;
  assign parity_1194 = ^{select_1170[11:9], select_1157[5:0]};
  logic parity_1197;
  assign parity_1197 = ^{select_1170, select_1157, select_1138[2:0]};
  logic xor_1198;
  assign xor_1198 = parity_1150 ^ parity_1197;
  // hls/stages/count_bits.hpp:23
  logic or_1202;
  assign or_1202 = (select_1138[1:0] == 2'h3) | (select_1138[2] & (select_1138[0] | select_1138[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1206;
  assign or_1206 = (select_1157[7:6] == 2'h3) | (select_1157[8] & (select_1157[6] | select_1157[7]));
  logic or_1210;
  assign or_1210 = (select_1157[10:9] == 2'h3) | (select_1157[11] & (select_1157[9] | select_1157[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1218;
  assign or_1218 = (select_1170[7:6] == 2'h3) | (select_1170[8] & (~(select_1170[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1222;
  assign or_1222 = (select_1170[1:0] == 2'h3) | (select_1170[2] & (select_1170[0] | select_1170[1]));
  logic or_1226;
  assign or_1226 = (select_1170[4:3] == 2'h3) | (select_1170[5] & (select_1170[3] | select_1170[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1229;
  assign parity_1229 = ^{or_1226, or_1222, or_1218};
  // hls/stages/count_bits.hpp:23
  logic or_1233;
  assign or_1233 = (select_1157[4:3] == 2'h3) | (select_1157[5] & (select_1157[3] | select_1157[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1237;
  assign or_1237 = (select_1170[10:9] == 2'h3) | (select_1170[11] & (select_1170[9] | select_1170[10]));
  logic or_1241;
  assign or_1241 = (select_1157[1:0] == 2'h3) | (select_1157[2] & (select_1157[0] | select_1157[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1244;
  assign parity_1244 = ^{or_1241, or_1237, or_1233};
  logic parity_1247;
  assign parity_1247 = ^{or_1241, or_1237, or_1233, or_1226, or_1222, or_1218, or_1210, or_1206, or_1202};
  // hls/stages/count_bits.hpp:25
  logic and_1248;
  assign and_1248 = parity_1150 & parity_1197;
  logic or_1252;
  assign or_1252 = (parity_1144 & parity_1147) | ((^select_1138[11:9]) & (parity_1144 | parity_1147));
  logic and_1255;
  assign and_1255 = (^{select_1157[11:6], select_1138[2:0]}) & (parity_1182 | parity_1194);
  logic or_1256;
  assign or_1256 = (parity_1182 & parity_1194) | and_1255;
  // hls/stages/count_bits.hpp:23
  logic or_1263;
  assign or_1263 = (select_1138[10:9] == 2'h3) | (select_1138[11] & (select_1138[9] | select_1138[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1267;
  assign or_1267 = (select_1138[4:3] == 2'h3) | (select_1138[5] & (select_1138[3] | select_1138[4]));
  logic or_1271;
  assign or_1271 = (select_1138[7:6] == 2'h3) | (select_1138[8] & (select_1138[6] | select_1138[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1274;
  assign parity_1274 = ^{or_1271, or_1267, or_1263};
  // hls/stages/count_bits.hpp:25
  logic or_1278;
  assign or_1278 = (parity_1160 & parity_1163) | ((^select_1138[2:0]) & (parity_1160 | parity_1163));
  logic or_1282;
  assign or_1282 = (parity_1176 & parity_1179) | ((^select_1170[8:6]) & (parity_1176 | parity_1179));
  logic or_1286;
  assign or_1286 = (parity_1188 & parity_1191) | ((^select_1157[5:3]) & (parity_1188 | parity_1191));
  // hls/stages/count_bits.hpp:24
  logic parity_1289;
  assign parity_1289 = ^{or_1286, or_1282, or_1278};
  logic parity_1292;
  assign parity_1292 = ^{or_1286, or_1282, or_1278, or_1271, or_1267, or_1263, or_1256, or_1252, and_1248};
  logic xor_1293;
  assign xor_1293 = parity_1247 ^ parity_1292;
  // hls/stages/count_bits.hpp:25
  logic and_1294;
  assign and_1294 = parity_1247 & parity_1292;
  logic or_1298;
  assign or_1298 = (parity_1229 & parity_1244) | ((^{or_1210, or_1206, or_1202}) & (parity_1229 | parity_1244));
  logic or_1302;
  assign or_1302 = (parity_1274 & parity_1289) | ((^{or_1256, or_1252, and_1248}) & (parity_1274 | parity_1289));
  logic or_1309;
  assign or_1309 = (or_1206 & or_1210) | (or_1202 & (or_1206 | or_1210));
  logic or_1313;
  assign or_1313 = (or_1222 & or_1226) | (or_1218 & (or_1222 | or_1226));
  logic or_1317;
  assign or_1317 = (or_1237 & or_1241) | (or_1233 & (or_1237 | or_1241));
  // hls/stages/count_bits.hpp:24
  logic parity_1320;
  assign parity_1320 = ^{or_1317, or_1313, or_1309};
  // hls/stages/count_bits.hpp:25
  logic or_1324;
  assign or_1324 = (or_1252 & or_1256) | (and_1248 & (or_1252 | or_1256));
  logic or_1328;
  assign or_1328 = (or_1267 & or_1271) | (or_1263 & (or_1267 | or_1271));
  logic or_1332;
  assign or_1332 = (or_1282 & or_1286) | (or_1278 & (or_1282 | or_1286));
  // hls/stages/count_bits.hpp:24
  logic parity_1335;
  assign parity_1335 = ^{or_1332, or_1328, or_1324};
  logic parity_1338;
  assign parity_1338 = ^{or_1332, or_1328, or_1324, or_1317, or_1313, or_1309, or_1302, or_1298, and_1294};
  // hls/stages/count_bits.hpp:25
  logic or_1342;
  assign or_1342 = (parity_1320 & parity_1335) | ((^{or_1302, or_1298, and_1294}) & (parity_1320 | parity_1335));
  logic or_1346;
  assign or_1346 = (or_1298 & or_1302) | (and_1294 & (or_1298 | or_1302));
  logic or_1350;
  assign or_1350 = (or_1313 & or_1317) | (or_1309 & (or_1313 | or_1317));
  logic or_1354;
  assign or_1354 = (or_1328 & or_1332) | (or_1324 & (or_1328 | or_1332));
  // hls/stages/count_bits.hpp:24
  logic parity_1359;
  assign parity_1359 = ^{or_1354, or_1350, or_1346, or_1342};
  // hls/stages/count_bits.hpp:25
  logic or_1363;
  assign or_1363 = (or_1350 & or_1354) | (or_1346 & (or_1350 | or_1354));
  logic and_1364;
  assign and_1364 = or_1342 & (^{or_1354, or_1350, or_1346});
  // hls/stages/count_bits.hpp:24
  logic xor_1365;
  assign xor_1365 = or_1363 ^ and_1364;
  // hls/stages/count_bits.hpp:27
  logic and_1366;
  assign and_1366 = or_1363 & and_1364;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1367;
  assign select_1367 = equal_511_s1_q ? {and_1366, xor_1365, parity_1359, parity_1338, xor_1293, xor_1198} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_509_s1_q ? 6'h0 : select_1367;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1369;
  assign select_1369 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1370;
  assign difference_1370 = {1'b0, column_4} - {1'b0, select_1369};
  logic [7:0] sum_1372;
  assign sum_1372 = {difference_1370[6], difference_1370} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1380;
  assign select_1380 = and_643 ? (and_684 ? (~(select_685 ^ select_646)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1386;
  assign parity_1386 = ^select_1380[5:3];
  logic parity_1389;
  assign parity_1389 = ^select_1380[8:6];
  logic parity_1392;
  assign parity_1392 = ^select_1380[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1399;
  assign select_1399 = and_666 ? (and_925 ? (~(select_926 ^ select_669)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1402;
  assign parity_1402 = ^select_1399[8:6];
  logic parity_1405;
  assign parity_1405 = ^select_1399[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] xor_1411;
  assign xor_1411 = (less_516_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_686;
  logic [11:0] select_1414;
  assign select_1414 = and_683 ? ((right_codes_rdata_q[90] & not_517_s1_q) ? (~xor_1411) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1420;
  assign parity_1420 = ^select_1414[2:0];
  logic parity_1423;
  assign parity_1423 = ^select_1414[5:3];
  logic parity_1426;
  assign parity_1426 = ^select_1414[8:0];
  logic parity_1432;
  assign parity_1432 = ^select_1414[11:9];
  logic parity_1435;
  assign parity_1435 = ^select_1399[2:0];
  logic parity_1438;
  assign parity_1438 = ^{select_1414[11:9], select_1399[5:0]};
  logic parity_1441;
  assign parity_1441 = ^{select_1414, select_1399, select_1380[2:0]};
  logic xor_1442;
  assign xor_1442 = parity_1392 ^ parity_1441;
  // hls/stages/count_bits.hpp:23
  logic or_1446;
  assign or_1446 = (select_1380[1:0] == 2'h3) | (select_1380[2] & (select_1380[0] | select_1380[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1450;
  assign or_1450 = (select_1399[7:6] == 2'h3) | (select_1399[8] & (select_1399[6] | select_1399[7]));
  logic or_1454;
  assign or_1454 = (select_1399[10:9] == 2'h3) | (select_1399[11] & (select_1399[9] | select_1399[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1462;
  assign or_1462 = (select_1414[7:6] == 2'h3) | (select_1414[8] & (~(select_1414[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1466;
  assign or_1466 = (select_1414[1:0] == 2'h3) | (select_1414[2] & (select_1414[0] | select_1414[1]));
  logic or_1470;
  assign or_1470 = (select_1414[4:3] == 2'h3) | (select_1414[5] & (select_1414[3] | select_1414[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1473;
  assign parity_1473 = ^{or_1470, or_1466, or_1462};
  // hls/stages/count_bits.hpp:23
  logic or_1477;
  assign or_1477 = (select_1399[4:3] == 2'h3) | (select_1399[5] & (select_1399[3] | select_1399[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1481;
  assign or_1481 = (select_1414[10:9] == 2'h3) | (select_1414[11] & (select_1414[9] | select_1414[10]));
  logic or_1485;
  assign or_1485 = (select_1399[1:0] == 2'h3) | (select_1399[2] & (select_1399[0] | select_1399[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1488;
  assign parity_1488 = ^{or_1485, or_1481, or_1477};
  logic parity_1491;
  assign parity_1491 = ^{or_1485, or_1481, or_1477, or_1470, or_1466, or_1462, or_1454, or_1450, or_1446};
  // hls/stages/count_bits.hpp:25
  logic and_1492;
  assign and_1492 = parity_1392 & parity_1441;
  logic or_1496;
  assign or_1496 = (parity_1386 & parity_1389) | ((^select_1380[11:9]) & (parity_1386 | parity_1389));
  logic and_1499;
  assign and_1499 = (^{select_1399[11:6], select_1380[2:0]}) & (parity_1426 | parity_1438);
  logic or_1500;
  assign or_1500 = (parity_1426 & parity_1438) | and_1499;
  // hls/stages/count_bits.hpp:23
  logic or_1507;
  assign or_1507 = (select_1380[10:9] == 2'h3) | (select_1380[11] & (select_1380[9] | select_1380[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1511;
  assign or_1511 = (select_1380[4:3] == 2'h3) | (select_1380[5] & (select_1380[3] | select_1380[4]));
  logic or_1515;
  assign or_1515 = (select_1380[7:6] == 2'h3) | (select_1380[8] & (select_1380[6] | select_1380[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1518;
  assign parity_1518 = ^{or_1515, or_1511, or_1507};
  // hls/stages/count_bits.hpp:25
  logic or_1522;
  assign or_1522 = (parity_1402 & parity_1405) | ((^select_1380[2:0]) & (parity_1402 | parity_1405));
  logic or_1526;
  assign or_1526 = (parity_1420 & parity_1423) | ((^select_1414[8:6]) & (parity_1420 | parity_1423));
  logic or_1530;
  assign or_1530 = (parity_1432 & parity_1435) | ((^select_1399[5:3]) & (parity_1432 | parity_1435));
  // hls/stages/count_bits.hpp:24
  logic parity_1533;
  assign parity_1533 = ^{or_1530, or_1526, or_1522};
  logic parity_1536;
  assign parity_1536 = ^{or_1530, or_1526, or_1522, or_1515, or_1511, or_1507, or_1500, or_1496, and_1492};
  logic xor_1537;
  assign xor_1537 = parity_1491 ^ parity_1536;
  // hls/stages/count_bits.hpp:25
  logic and_1538;
  assign and_1538 = parity_1491 & parity_1536;
  logic or_1542;
  assign or_1542 = (parity_1473 & parity_1488) | ((^{or_1454, or_1450, or_1446}) & (parity_1473 | parity_1488));
  logic or_1546;
  assign or_1546 = (parity_1518 & parity_1533) | ((^{or_1500, or_1496, and_1492}) & (parity_1518 | parity_1533));
  logic or_1553;
  assign or_1553 = (or_1450 & or_1454) | (or_1446 & (or_1450 | or_1454));
  logic or_1557;
  assign or_1557 = (or_1466 & or_1470) | (or_1462 & (or_1466 | or_1470));
  logic or_1561;
  assign or_1561 = (or_1481 & or_1485) | (or_1477 & (or_1481 | or_1485));
  // hls/stages/count_bits.hpp:24
  logic parity_1564;
  assign parity_1564 = ^{or_1561, or_1557, or_1553};
  // hls/stages/count_bits.hpp:25
  logic or_1568;
  assign or_1568 = (or_1496 & or_1500) | (and_1492 & (or_1496 | or_1500));
  logic or_1572;
  assign or_1572 = (or_1511 & or_1515) | (or_1507 & (or_1511 | or_1515));
  logic or_1576;
  assign or_1576 = (or_1526 & or_1530) | (or_1522 & (or_1526 | or_1530));
  // hls/stages/count_bits.hpp:24
  logic parity_1579;
  assign parity_1579 = ^{or_1576, or_1572, or_1568};
  logic parity_1582;
  assign parity_1582 = ^{or_1576, or_1572, or_1568, or_1561, or_1557, or_1553, or_1546, or_1542, and_1538};
  // hls/stages/count_bits.hpp:25
  logic or_1586;
  assign or_1586 = (parity_1564 & parity_1579) | ((^{or_1546, or_1542, and_1538}) & (parity_1564 | parity_1579));
  logic or_1590;
  assign or_1590 = (or_1542 & or_1546) | (and_1538 & (or_1542 | or_1546));
  logic or_1594;
  assign or_1594 = (or_1557 & or_1561) | (or_1553 & (or_1557 | or_1561));
  logic or_1598;
  assign or_1598 = (or_1572 & or_1576) | (or_1568 & (or_1572 | or_1576));
  // hls/stages/count_bits.hpp:24
  logic parity_1603;
  assign parity_1603 = ^{or_1598, or_1594, or_1590, or_1586};
  // hls/stages/count_bits.hpp:25
  logic or_1607;
  assign or_1607 = (or_1594 & or_1598) | (or_1590 & (or_1594 | or_1598));
  logic and_1608;
  assign and_1608 = or_1586 & (^{or_1598, or_1594, or_1590});
  // hls/stages/count_bits.hpp:24
  logic xor_1609;
  assign xor_1609 = or_1607 ^ and_1608;
  // hls/stages/count_bits.hpp:27
  logic and_1610;
  assign and_1610 = or_1607 & and_1608;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1611;
  assign select_1611 = equal_511_s1_q ? {and_1610, xor_1609, parity_1603, parity_1582, xor_1537, xor_1442} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_509_s1_q ? 6'h0 : select_1611;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1613;
  assign select_1613 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1614;
  assign difference_1614 = {1'b0, column_5} - {1'b0, select_1613};
  logic [7:0] sum_1616;
  assign sum_1616 = {difference_1614[6], difference_1614} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] not_1620;
  assign not_1620 = ~((less_516_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_646);
  logic [11:0] select_1622;
  assign select_1622 = and_643 ? ((right_codes_rdata_q[12] & not_517_s1_q) ? not_1620 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1628;
  assign parity_1628 = ^select_1622[5:3];
  logic parity_1631;
  assign parity_1631 = ^select_1622[8:6];
  logic parity_1634;
  assign parity_1634 = ^select_1622[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1641;
  assign select_1641 = and_666 ? (and_1133 ? (~(select_1134 ^ select_669)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1644;
  assign parity_1644 = ^select_1641[8:6];
  logic parity_1647;
  assign parity_1647 = ^select_1641[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1654;
  assign select_1654 = and_683 ? (and_644 ? (~(select_645 ^ select_686)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1660;
  assign parity_1660 = ^select_1654[2:0];
  logic parity_1663;
  assign parity_1663 = ^select_1654[5:3];
  logic parity_1666;
  assign parity_1666 = ^select_1654[8:0];
  logic parity_1672;
  assign parity_1672 = ^select_1654[11:9];
  logic parity_1675;
  assign parity_1675 = ^select_1641[2:0];
  logic parity_1678;
  assign parity_1678 = ^{select_1654[11:9], select_1641[5:0]};
  logic parity_1681;
  assign parity_1681 = ^{select_1654, select_1641, select_1622[2:0]};
  logic xor_1682;
  assign xor_1682 = parity_1634 ^ parity_1681;
  // hls/stages/count_bits.hpp:23
  logic or_1686;
  assign or_1686 = (select_1622[1:0] == 2'h3) | (select_1622[2] & (select_1622[0] | select_1622[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1690;
  assign or_1690 = (select_1641[7:6] == 2'h3) | (select_1641[8] & (select_1641[6] | select_1641[7]));
  logic or_1694;
  assign or_1694 = (select_1641[10:9] == 2'h3) | (select_1641[11] & (select_1641[9] | select_1641[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1702;
  assign or_1702 = (select_1654[7:6] == 2'h3) | (select_1654[8] & (~(select_1654[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1706;
  assign or_1706 = (select_1654[1:0] == 2'h3) | (select_1654[2] & (select_1654[0] | select_1654[1]));
  logic or_1710;
  assign or_1710 = (select_1654[4:3] == 2'h3) | (select_1654[5] & (select_1654[3] | select_1654[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1713;
  assign parity_1713 = ^{or_1710, or_1706, or_1702};
  // hls/stages/count_bits.hpp:23
  logic or_1717;
  assign or_1717 = (select_1641[4:3] == 2'h3) | (select_1641[5] & (select_1641[3] | select_1641[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1721;
  assign or_1721 = (select_1654[10:9] == 2'h3) | (select_1654[11] & (select_1654[9] | select_1654[10]));
  logic or_1725;
  assign or_1725 = (select_1641[1:0] == 2'h3) | (select_1641[2] & (select_1641[0] | select_1641[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1728;
  assign parity_1728 = ^{or_1725, or_1721, or_1717};
  logic parity_1731;
  assign parity_1731 = ^{or_1725, or_1721, or_1717, or_1710, or_1706, or_1702, or_1694, or_1690, or_1686};
  // hls/stages/count_bits.hpp:25
  logic and_1732;
  assign and_1732 = parity_1634 & parity_1681;
  logic or_1736;
  assign or_1736 = (parity_1628 & parity_1631) | ((^select_1622[11:9]) & (parity_1628 | parity_1631));
  logic and_1739;
  assign and_1739 = (^{select_1641[11:6], select_1622[2:0]}) & (parity_1666 | parity_1678);
  logic or_1740;
  assign or_1740 = (parity_1666 & parity_1678) | and_1739;
  // hls/stages/count_bits.hpp:23
  logic or_1747;
  assign or_1747 = (select_1622[10:9] == 2'h3) | (select_1622[11] & (select_1622[9] | select_1622[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1751;
  assign or_1751 = (select_1622[4:3] == 2'h3) | (select_1622[5] & (select_1622[3] | select_1622[4]));
  logic or_1755;
  assign or_1755 = (select_1622[7:6] == 2'h3) | (select_1622[8] & (select_1622[6] | select_1622[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1758;
  assign parity_1758 = ^{or_1755, or_1751, or_1747};
  // hls/stages/count_bits.hpp:25
  logic or_1762;
  assign or_1762 = (parity_1644 & parity_1647) | ((^select_1622[2:0]) & (parity_1644 | parity_1647));
  logic or_1766;
  assign or_1766 = (parity_1660 & parity_1663) | ((^select_1654[8:6]) & (parity_1660 | parity_1663));
  logic or_1770;
  assign or_1770 = (parity_1672 & parity_1675) | ((^select_1641[5:3]) & (parity_1672 | parity_1675));
  // hls/stages/count_bits.hpp:24
  logic parity_1773;
  assign parity_1773 = ^{or_1770, or_1766, or_1762};
  logic parity_1776;
  assign parity_1776 = ^{or_1770, or_1766, or_1762, or_1755, or_1751, or_1747, or_1740, or_1736, and_1732};
  logic xor_1777;
  assign xor_1777 = parity_1731 ^ parity_1776;
  // hls/stages/count_bits.hpp:25
  logic and_1778;
  assign and_1778 = parity_1731 & parity_1776;
  logic or_1782;
  assign or_1782 = (parity_1713 & parity_1728) | ((^{or_1694, or_1690, or_1686}) & (parity_1713 | parity_1728));
  logic or_1786;
  assign or_1786 = (parity_1758 & parity_1773) | ((^{or_1740, or_1736, and_1732}) & (parity_1758 | parity_1773));
  logic or_1793;
  assign or_1793 = (or_1690 & or_1694) | (or_1686 & (or_1690 | or_1694));
  logic or_1797;
  assign or_1797 = (or_1706 & or_1710) | (or_1702 & (or_1706 | or_1710));
  logic or_1801;
  assign or_1801 = (or_1721 & or_1725) | (or_1717 & (or_1721 | or_1725));
  // hls/stages/count_bits.hpp:24
  logic parity_1804;
  assign parity_1804 = ^{or_1801, or_1797, or_1793};
  // hls/stages/count_bits.hpp:25
  logic or_1808;
  assign or_1808 = (or_1736 & or_1740) | (and_1732 & (or_1736 | or_1740));
  logic or_1812;
  assign or_1812 = (or_1751 & or_1755) | (or_1747 & (or_1751 | or_1755));
  logic or_1816;
  assign or_1816 = (or_1766 & or_1770) | (or_1762 & (or_1766 | or_1770));
  // hls/stages/count_bits.hpp:24
  logic parity_1819;
  assign parity_1819 = ^{or_1816, or_1812, or_1808};
  logic parity_1822;
  assign parity_1822 = ^{or_1816, or_1812, or_1808, or_1801, or_1797, or_1793, or_1786, or_1782, and_1778};
  // hls/stages/count_bits.hpp:25
  logic or_1826;
  assign or_1826 = (parity_1804 & parity_1819) | ((^{or_1786, or_1782, and_1778}) & (parity_1804 | parity_1819));
  logic or_1830;
  assign or_1830 = (or_1782 & or_1786) | (and_1778 & (or_1782 | or_1786));
  logic or_1834;
  assign or_1834 = (or_1797 & or_1801) | (or_1793 & (or_1797 | or_1801));
  logic or_1838;
  assign or_1838 = (or_1812 & or_1816) | (or_1808 & (or_1812 | or_1816));
  // hls/stages/count_bits.hpp:24
  logic parity_1843;
  assign parity_1843 = ^{or_1838, or_1834, or_1830, or_1826};
  // hls/stages/count_bits.hpp:25
  logic or_1847;
  assign or_1847 = (or_1834 & or_1838) | (or_1830 & (or_1834 | or_1838));
  logic and_1848;
  assign and_1848 = or_1826 & (^{or_1838, or_1834, or_1830});
  // hls/stages/count_bits.hpp:24
  logic xor_1849;
  assign xor_1849 = or_1847 ^ and_1848;
  // hls/stages/count_bits.hpp:27
  logic and_1850;
  assign and_1850 = or_1847 & and_1848;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1851;
  assign select_1851 = equal_511_s1_q ? {and_1850, xor_1849, parity_1843, parity_1822, xor_1777, xor_1682} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_509_s1_q ? 6'h0 : select_1851;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1853;
  assign select_1853 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1854;
  assign difference_1854 = {1'b0, column_6} - {1'b0, select_1853};
  logic [7:0] sum_1856;
  assign sum_1856 = {difference_1854[6], difference_1854} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:929
  logic [6:0] select_1916;
  assign select_1916 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:932
  logic and_1936;
  assign and_1936 = (or_509_s1_q & (left_rdata_q[61] & not_517_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1958;
  assign or_1958 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/patches.hpp:303
  logic [6:0] select_1969;
  assign select_1969 = so_s1_q ? x_s1_q[6:0] : (or_509_s1_q ? (less_516_s1_q ? 7'h0 : select_1916) : 7'h0);
  // hls/stages/patches.hpp:94
  logic and_2043;
  assign and_2043 = (select_452_s1_q == 3'h0) & (select_454_s1_q == 7'h0);
  // hls/stages/patches.hpp:346
  logic not_2044;
  assign not_2044 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_2047;
  assign not_2047 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:316
  logic and_2048;
  assign and_2048 = patches_capturing_q & not_2047;
  // hls/stages/patches.hpp:276
  logic equal_2051;
  assign equal_2051 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:97
  logic and_2056;
  assign and_2056 = (not_2044 & (patches_work_q == 3'h0)) & (~(and_2048 | ((~equal_2049_s1_q) | (~equal_2051))));
  // hls/stages/patches.hpp:454
  logic equal_2139;
  assign equal_2139 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:435
  logic not_2140;
  assign not_2140 = ~equal_2139;
  // hls/stages/patches.hpp:454
  logic equal_2141;
  assign equal_2141 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:401
  logic not_2142;
  assign not_2142 = ~equal_2141;
  // hls/stages/patches.hpp:143
  logic equal_2143;
  assign equal_2143 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:454
  logic equal_2144;
  assign equal_2144 = patches_work_q == 3'h2;
  logic or_2145;
  assign or_2145 = equal_2143 | equal_2144;
  // hls/stages/patches.hpp:403
  logic not_2146;
  assign not_2146 = ~patches_second_q;
  // hls/stages/patches.hpp:327
  logic [4:0] select_2165;
  assign select_2165 = and_2056 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:98
  logic [4:0] select_2166;
  assign select_2166 = and_2043 ? select_2165 : patches_row_q;
  // hls/stages/patches.hpp:97
  logic and_2168;
  assign and_2168 = and_2048 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:98
  logic select_2172;
  assign select_2172 = and_2043 ? (and_2056 | (and_2048 & (~and_2168))) : patches_capturing_q;
  // hls/stages/patches.hpp:160
  logic and_2180;
  assign and_2180 = not_2140 & (not_2142 & (or_2145 & (patches_second_q & equal_2143)));
  // hls/stages/patches.hpp:143
  logic not_2194;
  assign not_2194 = ~equal_2143;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2208;
  assign select_2208 = and_2043 ? {select_2165[4], select_2165[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:401
  logic and_2218;
  assign and_2218 = not_2140 & (or_2145 & not_2142);
  // hls/stages/agreement.hpp:443
  logic [5:0] or_2581;
  assign or_2581 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:447
  logic select_2800;
  assign select_2800 = equal_2706_s1_q ? (~({row_s1_q, 1'b0} < {sum_2797, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_2986;
  assign and_2986 = and_488_s1_q & (equal_2706_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:282
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:98
  logic [3:0] select_3096;
  assign select_3096 = and_2043 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3097;
  assign select_3097 = sample_pair_whole_s1_q ? select_3096 : patches_phase_q;
  // hls/stages/patches.hpp:327
  logic and_3098;
  assign and_3098 = not_2047 & equal_2049_s1_q;
  logic [8:0] select_3099;
  assign select_3099 = and_3098 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3100;
  assign select_3100 = and_3098 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3101;
  assign select_3101 = sample_pair_first_s1_q ? select_3099 : select_3100;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3103;
  assign select_3103 = sample_pair_whole_s1_q ? (and_2043 ? select_3101[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3105;
  assign select_3105 = sample_pair_whole_s1_q ? (and_2043 ? select_3101[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3108;
  assign select_3108 = sample_pair_whole_s1_q ? (equal_2051 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3110;
  assign select_3110 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_2051}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:294
  logic equal_3111;
  assign equal_3111 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:295
  logic not_3112;
  assign not_3112 = ~equal_3111;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3114;
  assign select_3114 = sample_pair_whole_s1_q ? (phase + {not_3112, 1'b1, not_3112, equal_3111}) : patches_first_band_rows_to_next_q;
  logic select_3115;
  assign select_3115 = sample_pair_whole_s1_q ? equal_3111 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:457
  logic equal_3116;
  assign equal_3116 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:64
  logic [3:0] select_3120;
  assign select_3120 = equal_3116 ? ((select_3097 == 4'h6) ? 4'h0 : (select_3097 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3121;
  assign equal_3121 = select_3120 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_3124;
  assign select_3124 = equal_2706_s1_q ? (equal_3121 ? 4'h6 : (select_3120 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:64
  logic [4:0] select_3126;
  assign select_3126 = equal_3116 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_3128;
  assign select_3128 = equal_2706_s1_q ? (select_3126 + {4'h0, equal_3121}) : patches_choosing_number_q;
  logic select_3132;
  assign select_3132 = equal_2706_s1_q ? ((6'h2 < row_s1_q) & equal_3121) : patches_chooses_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_3135;
  assign select_3135 = and_488_s1_q ? (equal_2706_s1_q ? select_3126 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:98
  logic select_3164;
  assign select_3164 = and_2043 ? (and_2056 ? not_3162_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:347
  logic or_3201;
  assign or_3201 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:349
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:163
  logic and_3207;
  assign and_3207 = equal_2139 & not_2146;
  // hls/stages/patches.hpp:353
  logic and_3208;
  assign and_3208 = not_2194 & and_3207;
  logic [1:0] select_3210;
  assign select_3210 = equal_2141 ? 2'h0 : (equal_2144 ? 2'h3 : {equal_2143, and_3208});
  // hls/stages/patches.hpp:244
  logic equal_3212;
  assign equal_3212 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:242
  logic not_3213;
  assign not_3213 = ~equal_3212;
  // hls/stages/patches.hpp:244
  logic equal_3214;
  assign equal_3214 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:240
  logic not_3215;
  assign not_3215 = ~equal_3214;
  // hls/stages/patches.hpp:248
  logic not_3217;
  assign not_3217 = ~(patches_following_q == 3'h2);
  logic and_3220;
  assign and_3220 = (~(patches_following_q == 3'h1)) & not_3217;
  // hls/stages/patches.hpp:351
  logic [1:0] select_3221;
  assign select_3221 = equal_3214 ? 2'h2 : {and_3220, not_3217};
  logic [3:0] select_3222;
  assign select_3222 = equal_3212 ? 4'h2 : {select_3221, {2{not_3215}}};
  // hls/stages/patches.hpp:359
  logic not_3225;
  assign not_3225 = ~or_3201;
  // hls/stages/patches.hpp:348
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:360
  logic [11:0] select_3230;
  assign select_3230 = or_3201 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:163
  logic [4:0] select_3232;
  assign select_3232 = or_3201 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1296; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_509_s1_q ? select_1916 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_630_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:677; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s1_en & (not_2140 & (not_2142 & (or_2145 & (equal_2143 & not_2146))));
  logic [8:0] patches_right_0_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_word_q <= patches_right_0_mem[patches_right_0_raddr];
  end
  logic [7:0] patches_right_0_rdata_q;
  assign patches_right_0_rdata_q = patches_right_0_word_q[7:0];
  logic patches_right_0_read_q, patches_right_0_error;
  always_ff @(posedge clk_i) patches_right_0_read_q <= rst_ni & patches_right_0_re;
  assign patches_right_0_error = patches_right_0_read_q & ^patches_right_0_word_q;

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:677; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s1_en & and_2180;
  logic [8:0] patches_right_1_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_word_q <= patches_right_1_mem[patches_right_1_raddr];
  end
  logic [7:0] patches_right_1_rdata_q;
  assign patches_right_1_rdata_q = patches_right_1_word_q[7:0];
  logic patches_right_1_read_q, patches_right_1_error;
  always_ff @(posedge clk_i) patches_right_1_read_q <= rst_ni & patches_right_1_re;
  assign patches_right_1_error = patches_right_1_read_q & ^patches_right_1_word_q;

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:678; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s1_en & (not_2140 & (not_2142 & (not_2194 & or_2145)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:689; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 33'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s1_en & and_2218;
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
  assign left_we = s1_en & and_520_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_612, left_rdata_q[59:45], and_611, left_rdata_q[43:29], and_610, left_rdata_q[27:13], and_609, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_520_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_621, right_codes_rdata_q[76:65], and_620, right_codes_rdata_q[63:52], and_619, right_codes_rdata_q[50:39], and_618, right_codes_rdata_q[37:26], and_617, right_codes_rdata_q[24:13], and_616, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_488_s1_q ? (equal_2706_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_488_s1_q ? select_2800 : lower_half_q;
      patches_phase_q <= select_3097;
      patches_band_rows_rows_to_next_q <= select_3103;
      patches_band_rows_number_q <= select_3105;
      patches_next_band_rows_to_next_q <= select_3108;
      patches_next_band_number_q <= select_3110;
      patches_first_band_rows_to_next_q <= select_3114;
      patches_first_band_number_q <= select_3115;
      patches_choosing_rows_to_next_q <= and_488_s1_q ? select_3124 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_488_s1_q ? select_3128 : patches_choosing_number_q;
      patches_chooses_q <= and_488_s1_q ? select_3132 : patches_chooses_q;
      patches_choosing_band_q <= select_3135;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_2172 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_3164 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_2166 : patches_row_q;
      patches_work_q <= or_3201 ? following : patches_work_q;
      patches_second_q <= not_2044 & (patches_second_q | (patches_ends_q & equal_2139));
      patches_following_q <= equal_2139 ? {2'h0, and_3207} : {equal_2141, select_3210};
      patches_following_beats_q <= {select_3222, not_3213};
      patches_begins_q <= sample_pair_whole_s1_q & (and_2043 & and_2168);
      patches_ends_q <= not_3225 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3230;
      patches_code_row_q <= select_3232;
      patches_column_q <= or_3201 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3225 & (patches_column_q == 5'h1e);
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
      middle_sum_sum_sums_values_0_q <= sum_892;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1132;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1372;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1616;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1856;
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
  logic [2:0] select_452_s2_q;
  logic [6:0] select_454_s2_q;
  logic [8:0] select_458_s2_q;
  logic and_462_s2_q;
  logic equal_468_s2_q;
  logic [6:0] column_s2_q;
  logic and_486_s2_q;
  logic and_488_s2_q;
  logic so_s2_q;
  logic equal_508_s2_q;
  logic or_509_s2_q;
  logic less_516_s2_q;
  logic not_517_s2_q;
  logic equal_549_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_637_s2_q;
  logic and_1912_s2_q;
  logic [6:0] right_s2_q;
  logic select_1921_s2_q;
  logic equal_1930_s2_q;
  logic and_1937_s2_q;
  logic and_1940_s2_q;
  logic and_1944_s2_q;
  logic or_1958_s2_q;
  logic [6:0] select_1969_s2_q;
  logic and_2043_s2_q;
  logic and_2056_s2_q;
  logic less_2070_s2_q;
  logic equal_2139_s2_q;
  logic not_2140_s2_q;
  logic equal_2141_s2_q;
  logic not_2142_s2_q;
  logic equal_2143_s2_q;
  logic or_2145_s2_q;
  logic [4:0] select_2166_s2_q;
  logic select_2172_s2_q;
  logic [3:0] select_2208_s2_q;
  logic and_2218_s2_q;
  logic and_2436_s2_q;
  logic equal_2582_s2_q;
  logic equal_2706_s2_q;
  logic and_2987_s2_q;
  logic and_2989_s2_q;
  logic or_3201_s2_q;
  logic not_3225_s2_q;
  logic less_3971_s2_q;
  logic equal_4176_s2_q;
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
      select_452_s2_q <= select_452_s1_q;
      select_454_s2_q <= select_454_s1_q;
      select_458_s2_q <= select_458_s1_q;
      and_462_s2_q <= and_462_s1_q;
      equal_468_s2_q <= equal_468_s1_q;
      column_s2_q <= column_s1_q;
      and_486_s2_q <= and_486_s1_q;
      and_488_s2_q <= and_488_s1_q;
      so_s2_q <= so_s1_q;
      equal_508_s2_q <= equal_508_s1_q;
      or_509_s2_q <= or_509_s1_q;
      less_516_s2_q <= less_516_s1_q;
      not_517_s2_q <= not_517_s1_q;
      equal_549_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_637_s2_q <= select_637_s1_q;
      and_1912_s2_q <= and_1912_s1_q;
      right_s2_q <= right_s1_q;
      select_1921_s2_q <= select_1921_s1_q;
      equal_1930_s2_q <= equal_1930_s1_q;
      and_1937_s2_q <= not_517_s1_q & and_1936;
      and_1940_s2_q <= (or_509_s1_q & (left_rdata_q[62] & not_517_s1_q)) & and_1936;
      and_1944_s2_q <= not_517_s1_q & (or_509_s1_q & (left_rdata_q[63] & not_517_s1_q));
      or_1958_s2_q <= or_1958;
      select_1969_s2_q <= select_1969;
      and_2043_s2_q <= and_2043;
      and_2056_s2_q <= and_2056;
      less_2070_s2_q <= 5'h4 < row_q[5:1];
      equal_2139_s2_q <= equal_2139;
      not_2140_s2_q <= not_2140;
      equal_2141_s2_q <= equal_2141;
      not_2142_s2_q <= not_2142;
      equal_2143_s2_q <= equal_2143;
      or_2145_s2_q <= or_2145;
      select_2166_s2_q <= select_2166;
      select_2172_s2_q <= select_2172;
      select_2208_s2_q <= select_2208;
      and_2218_s2_q <= and_2218;
      and_2436_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2582_s2_q <= {column_s1_q[6], or_2581} == 7'h0;
      equal_2706_s2_q <= equal_2706_s1_q;
      and_2987_s2_q <= and_2707_s1_q & and_2986;
      and_2989_s2_q <= and_2707_s1_q & (~and_2986);
      or_3201_s2_q <= or_3201;
      not_3225_s2_q <= not_3225;
      less_3971_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4176_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [4:0] patches_summed_row_column_q;
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
  logic and_463;
  assign and_463 = sample_pair_whole_s2_q & and_462_s2_q;
  // hls/stages/agreement.hpp:772
  logic not_639;
  assign not_639 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_640;
  assign less_640 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:231
  logic and_642;
  assign and_642 = not_639 & (~less_640);
  // hls/stages/agreement.hpp:735
  logic less_1373;
  assign less_1373 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1374;
  assign select_1374 = less_1373 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1375;
  assign less_1375 = middle_sum_sum_sums_values_0_q < select_1374;
  logic [7:0] select_1376;
  assign select_1376 = less_1375 ? select_1374 : middle_sum_sum_sums_values_0_q;
  logic less_1857;
  assign less_1857 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1858;
  assign select_1858 = less_1857 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1859;
  assign less_1859 = select_1376 < select_1858;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_642 ? (less_1859 ? select_1858 : select_1376) : 8'h0;
  // hls/stages/agreement.hpp:783
  logic or_1863;
  assign or_1863 = select_637_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1864;
  assign select_1864 = or_1863 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:736
  logic or_1866;
  assign or_1866 = less_1373 | (~less_1375);
  logic [2:0] select_1867;
  assign select_1867 = less_1859 ? {less_1857, 2'h0} : {1'b0, or_1866, less_1375};
  // hls/stages/agreement.hpp:788
  logic [2:0] select_1868;
  assign select_1868 = or_1863 ? select_1867 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1869;
  assign select_1869 = or_1863 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:785
  logic equal_1870;
  assign equal_1870 = select_1867 == 3'h1;
  logic equal_1871;
  assign equal_1871 = select_1867 == 3'h2;
  logic not_1872;
  assign not_1872 = ~equal_1871;
  logic [1:0] select_1873;
  assign select_1873 = equal_1870 ? 2'h0 : {not_1872, equal_1871};
  logic [7:0] select_1874;
  assign select_1874 = select_1873[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1875;
  assign select_1875 = select_1873[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1877;
  assign select_1877 = or_1863 ? (select_1873[1] ? select_1874 : select_1875) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:786
  logic [2:0] select_1878;
  assign select_1878 = equal_1870 ? 3'h2 : {not_1872, {2{equal_1871}}};
  logic [7:0] select_1879;
  assign select_1879 = select_1878[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1880;
  assign select_1880 = select_1878[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic [7:0] select_1882;
  assign select_1882 = select_1878[2] ? sums_3_sum_sums_values_0_q : (select_1878[1] ? select_1879 : select_1880);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1883;
  assign select_1883 = or_1863 ? select_1882 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1885;
  assign sum_1885 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1886;
  assign sum_1886 = {1'b0, before_v} + sum_1885;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1888;
  assign sum_1888 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1889;
  assign sum_1889 = {1'b0, before_v_2} + sum_1888;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1891;
  assign sum_1891 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1892;
  assign sum_1892 = {1'b0, before_v_3} + sum_1891;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1894;
  assign select_1894 = (sum_1889 < sum_1892) ? sum_1892 : sum_1889;
  logic [6:0] select_1896;
  assign select_1896 = (sum_1886 < select_1894) ? select_1894 : sum_1886;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1898;
  assign sum_1898 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1899;
  assign sum_1899 = {1'b0, before_v_4} + sum_1898;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1901;
  assign sum_1901 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1902;
  assign sum_1902 = {1'b0, before_v_5} + sum_1901;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1904;
  assign select_1904 = (sum_1899 < sum_1902) ? sum_1902 : sum_1899;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_642 ? ((select_1896 < select_1904) ? select_1904 : select_1896) : 7'h0;
  // hls/stages/agreement.hpp:788
  logic or_1909;
  assign or_1909 = select_637_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:792
  logic [6:0] select_1910;
  assign select_1910 = or_1909 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1911;
  assign select_1911 = or_1909 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:797
  logic or_1923;
  assign or_1923 = select_1921_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1924;
  assign select_1924 = or_1923 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1925;
  assign select_1925 = or_1923 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1927;
  assign or_1927 = select_1921_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1928;
  assign select_1928 = or_1927 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1929;
  assign select_1929 = or_1927 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic not_1931;
  assign not_1931 = ~equal_1930_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1941;
  assign and_1941 = not_517_s2_q & and_1940_s2_q;
  // hls/stages/agreement.hpp:935
  logic select_1947;
  assign select_1947 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1950;
  assign difference_1950 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:943
  logic [9:0] sum_1951;
  assign sum_1951 = {difference_1950[8], difference_1950} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1953;
  assign and_1953 = (and_1940_s2_q & select_1947) & ({{22{sum_1951[9]}}, sum_1951} < 32'h3);
  logic and_1954;
  assign and_1954 = not_517_s2_q & and_1953;
  logic and_1960;
  assign and_1960 = not_517_s2_q & (and_1953 & or_1958_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1961;
  assign select_1961 = less_516_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_509_s2_q ? {select_1961, and_1960, and_1954, and_1944_s2_q, and_1941, and_1937_s2_q, not_517_s2_q} : 15'h0;
  // hls/stages/patches.hpp:303
  logic and_1963;
  assign and_1963 = ends_cell_s2_q & shift_2[0];
  logic and_1965;
  assign and_1965 = not_1931 & (so_s2_q & and_1963);
  // hls/stages/agreement.hpp:955
  logic [5:0] sum_2015;
  assign sum_2015 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2[0] & ({1'b0, sum_2015, last_s2_q[1]} < x_s2_q);
  // hls/stages/patches.hpp:75
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:250
  logic and_2071;
  assign and_2071 = shift_2[4] & less_2070_s2_q;
  // hls/stages/patches.hpp:76
  logic and_2075;
  assign and_2075 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:77
  logic equal_2076;
  assign equal_2076 = x_s2_q == 8'h0;
  // hls/stages/patches.hpp:74
  logic [9:0] sum_2082;
  assign sum_2082 = {2'h0, x_s2_q} + {{4{shift_2[11]}}, shift_2[11:6]};
  // hls/stages/patches.hpp:78
  logic [9:0] sum_2084;
  assign sum_2084 = {sum_2082[9], sum_2082[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:963
  logic and_2087;
  assign and_2087 = ($signed(9'h0) < $signed(sum_2082[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2084, sum_2082[0]})));
  logic and_2088;
  assign and_2088 = (~(and_2075 | (equal_2076 | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2087;
  // hls/stages/registration.hpp:215
  logic [16:0] select_2106;
  assign select_2106 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2106[16:7])) ? 8'h7f : select_2106[7:0];
  // hls/stages/patches.hpp:85
  logic equal_2132;
  assign equal_2132 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/patches.hpp:303
  logic and_2136;
  assign and_2136 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (and_2075 | equal_2132)));
  logic and_2137;
  assign and_2137 = not_1931 & and_2136;
  // hls/stages/patches.hpp:148
  logic [7:0] pixel;
  assign pixel = equal_2143_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2143_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:435
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  // hls/stages/patches.hpp:160
  logic and_2227;
  assign and_2227 = not_2140_s2_q & (equal_2141_s2_q & new_row);
  // hls/stages/patches.hpp:412
  logic [8:0] sum_2230;
  assign sum_2230 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2231;
  assign sum_2231 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2230, pixel_2[0]} - {1'b0, sum_2231, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:414
  logic [11:0] sum_2233;
  assign sum_2233 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2234;
  assign sum_2234 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2233[11], sum_2233};
  logic [13:0] sum_2235;
  assign sum_2235 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2234, down_2[1]};
  logic [12:0] sum_2236;
  assign sum_2236 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2235[13:1];
  logic [14:0] sum_2237;
  assign sum_2237 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2236, sum_2235[0], down_2[0]};
  // hls/stages/patches.hpp:410
  logic [8:0] sum_2240;
  assign sum_2240 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2241;
  assign sum_2241 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2240};
  logic [10:0] sum_2242;
  assign sum_2242 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2241, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2243;
  assign sum_2243 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2242[10:1];
  // hls/stages/patches.hpp:411
  logic [11:0] smooth;
  assign smooth = {sum_2243, sum_2242[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:413
  logic [12:0] sum_2245;
  assign sum_2245 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2246;
  assign sum_2246 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2247;
  assign difference_2247 = {1'b0, sum_2245, smooth[0]} - {1'b0, sum_2246, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:148
  logic and_2254;
  assign and_2254 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:160
  logic and_2258;
  assign and_2258 = or_2145_s2_q & ((equal_2143_s2_q & and_2254) & (patches_column_s2_q == 5'h1f));
  // hls/stages/patches.hpp:425
  logic or_2264;
  assign or_2264 = equal_2143_s2_q | (~and_2254);
  // hls/stages/patches.hpp:429
  logic and_2269;
  assign and_2269 = (~or_2264) & ((~patches_column_s2_q[4]) & (patches_column_s2_q == 5'hf));
  // hls/stages/patches.hpp:466
  logic less_2273;
  assign less_2273 = patches_step_q[4:0] < 5'h11;
  logic equal_2274;
  assign equal_2274 = patches_step_q[6:5] == 2'h0;
  logic not_2275;
  assign not_2275 = ~equal_2274;
  logic equal_2276;
  assign equal_2276 = patches_step_q[6:5] == 2'h3;
  logic not_2277;
  assign not_2277 = ~equal_2276;
  // hls/stages/patches.hpp:480
  logic select_2280;
  assign select_2280 = equal_2276 ? (less_2273 & (less_2273 & not_2277)) : less_2273;
  // hls/stages/patches.hpp:160
  logic and_2283;
  assign and_2283 = equal_2139_s2_q & (less_2273 ? (not_2275 & select_2280) : select_2280);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2304;
  assign sum_2304 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/patches.hpp:303
  logic and_2440;
  assign and_2440 = ends_cell_s2_q & (and_2436_s2_q & (~({sum_2015, last_s2_q[1:0]} < x_s2_q)));
  // hls/stages/registration.hpp:76
  logic less_2887;
  assign less_2887 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2889;
  assign select_2889 = or_509_s2_q ? (less_516_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2891;
  assign select_2891 = or_509_s2_q ? (less_516_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2893;
  assign select_2893 = or_509_s2_q ? (less_516_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2891} - {1'b0, select_2893};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2895;
  assign select_2895 = rise[8] ? select_2891 : select_2893;
  logic [8:0] difference_2896;
  assign difference_2896 = {1'b0, select_2889} - {1'b0, select_2895};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2896[8] ? 8'h0 : difference_2896[7:0];
  // hls/stages/registration.hpp:37
  logic not_2898;
  assign not_2898 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2887 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2898};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2900;
  assign xor_2900 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2900};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2906;
  assign select_2906 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2887 ? {taken, 1'b1} : {not_2898, select_2906, not_2898};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2908;
  assign sum_2908 = {left, 1'b1} + {taken_2, less_2887};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2910;
  assign select_2910 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:128
  logic [15:0] select_2990;
  assign select_2990 = and_2989_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:131
  logic [23:0] select_2992;
  assign select_2992 = and_2987_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2990[15]}}, select_2990});
  // hls/stages/registration.hpp:129
  logic [15:0] select_2993;
  assign select_2993 = and_2989_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2993[15]}}, select_2993};
  // hls/stages/registration.hpp:131
  logic [27:0] select_2995;
  assign select_2995 = and_2987_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_2996;
  assign and_2996 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:124
  logic [27:0] column_8;
  assign column_8 = registration_slope_q + (and_2996 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:68
  logic parity_3139;
  assign parity_3139 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_3140;
  assign select_3140 = equal_2706_s2_q ? {patches_chance_q[14:0], parity_3139} : patches_chance_q;
  // hls/stages/patches.hpp:80
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:81
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:82
  logic [5:0] select_3145;
  assign select_3145 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3145};
  // hls/stages/patches.hpp:303
  logic and_3151;
  assign and_3151 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:163
  logic select_3240;
  assign select_3240 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:160
  logic [11:0] select_3243;
  assign select_3243 = equal_2141_s2_q ? patches_smooth_values_0_q : (or_2145_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3245;
  assign select_3245 = or_2145_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3247;
  assign select_3247 = equal_2139_s2_q ? patches_smooth_values_1_q : (equal_2141_s2_q ? patches_smooth_values_1_q : select_3245);
  logic [11:0] select_3248;
  assign select_3248 = or_2145_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3250;
  assign select_3250 = equal_2139_s2_q ? patches_smooth_values_2_q : (equal_2141_s2_q ? patches_smooth_values_2_q : select_3248);
  logic [11:0] select_3251;
  assign select_3251 = or_2145_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3253;
  assign select_3253 = equal_2139_s2_q ? patches_smooth_values_3_q : (equal_2141_s2_q ? patches_smooth_values_3_q : select_3251);
  logic [10:0] select_3255;
  assign select_3255 = equal_2141_s2_q ? patches_down_values_0_q : (or_2145_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3258;
  assign select_3258 = equal_2141_s2_q ? patches_down_values_1_q : (or_2145_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3261;
  assign select_3261 = equal_2141_s2_q ? patches_down_values_2_q : (or_2145_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3264;
  assign select_3264 = equal_2141_s2_q ? patches_down_values_3_q : (or_2145_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:151
  logic and_3293;
  assign and_3293 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:367
  logic [4:0] select_3298;
  assign select_3298 = or_3201_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:369
  logic [3:0] select_3300;
  assign select_3300 = and_3293 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:160
  logic [4:0] select_3650;
  assign select_3650 = equal_2139_s2_q ? patches_summed_row_column_q : (equal_2141_s2_q ? patches_along_q : patches_summed_row_column_q);
  logic [4:0] select_3656;
  assign select_3656 = equal_2139_s2_q ? patches_summed_down_by_q : (equal_2141_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:476
  logic and_3689;
  assign and_3689 = less_2273 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:480
  logic select_3692;
  assign select_3692 = equal_2276 ? (less_2273 ? (not_2277 & and_3689) : and_3689) : and_3689;
  // hls/stages/patches.hpp:160
  logic select_3695;
  assign select_3695 = equal_2139_s2_q ? (less_2273 ? (not_2275 & select_3692) : select_3692) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_3983;
  assign select_3983 = so_s2_q ? (and_2996 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3985;
  assign sum_3985 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3986;
  assign select_3986 = sum_2304[5] ? {1'b1, sum_2304[4:0], region_across_rest_q[2:0]} : sum_3985;
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3988;
  assign select_3988 = equal_2706_s2_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_3991;
  assign select_3991 = equal_2706_s2_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_458_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_463;
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
  assign census_memory_re = s2_en & and_488_s2_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1297; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1965;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory patches_right_codes, 28 x 112 and parity, DISTANCE 12, hls/stages/patches.hpp:693; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [112:0] patches_right_codes_mem [0:27];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 28; i++) patches_right_codes_mem[i] = 113'h0;
`endif
  logic [4:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = patches_down_by_q + {1'b0, patches_match_row_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & and_2227;
  logic [112:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [111:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[111:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:694; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [48:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 49'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s2_en & and_2227;
  logic [48:0] patches_left_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_word_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end
  logic [47:0] patches_left_codes_rdata_q;
  assign patches_left_codes_rdata_q = patches_left_codes_word_q[47:0];
  logic patches_left_codes_read_q, patches_left_codes_error;
  always_ff @(posedge clk_i) patches_left_codes_read_q <= rst_ni & patches_left_codes_re;
  assign patches_left_codes_error = patches_left_codes_read_q & ^patches_left_codes_word_q;

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:708; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [15:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 16'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s2_en & and_2283;
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1324; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1965;
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
  assign best_left_we = s2_en & and_1912_s2_q;
  logic [45:0] best_left_wdata;
  assign best_left_wdata = {select_1911, select_1910, select_1883, select_1877, select_1869, select_1868, select_1864};
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
  assign best_right_we = s2_en & and_1912_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_1929, select_1928, select_1925, select_1924};
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
  assign patches_columns_above_we = s2_en & and_2218_s2_q;
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
      patches_summed_row_column_q <= 5'h0;
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
      registration_displacement_over_q <= so_s2_q ? sum_2908[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2910;
      registration_slope_row_q <= select_2992;
      registration_slope_change_q <= select_2995;
      registration_slope_q <= so_s2_q ? column_8 : {registration_slope_row_q, 4'h0};
      patches_chance_q <= and_488_s2_q ? select_3140 : patches_chance_q;
      patches_along_ends_q <= not_3225_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3225_s2_q & select_3240;
      patches_smooth_values_0_q <= equal_2139_s2_q ? patches_smooth_values_0_q : select_3243;
      patches_smooth_values_1_q <= select_3247;
      patches_smooth_values_2_q <= select_3250;
      patches_smooth_values_3_q <= select_3253;
      patches_down_values_0_q <= equal_2139_s2_q ? patches_down_values_0_q : select_3255;
      patches_down_values_1_q <= equal_2139_s2_q ? patches_down_values_1_q : select_3258;
      patches_down_values_2_q <= equal_2139_s2_q ? patches_down_values_2_q : select_3261;
      patches_down_values_3_q <= equal_2139_s2_q ? patches_down_values_3_q : select_3264;
      patches_down_by_q <= or_3201_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3293});
      patches_along_q <= select_3298;
      patches_match_row_q <= or_3201_s2_q ? 4'h0 : select_3300;
      patches_summed_row_column_q <= select_3650;
      patches_summed_last_q <= not_2140_s2_q & (equal_2141_s2_q & and_3293);
      patches_summed_down_by_q <= select_3656;
      patches_step_q <= or_3201_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3695;
      region_across_rest_q <= select_3983;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3986;
      columns_begin_rest_q <= and_488_s2_q ? select_3988 : columns_begin_rest_q;
      columns_begin_back_q <= and_488_s2_q ? select_3991 : columns_begin_back_q;
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
  logic patches_column_s3_q;
  logic [4:0] patches_summed_row_column_s3_q;
  logic patches_summed_last_s3_q;
  logic [4:0] patches_summed_down_by_s3_q;
  logic [4:0] patches_step_s3_q;
  logic patches_read_searches_s3_q;
  logic [2:0] select_452_s3_q;
  logic [6:0] select_454_s3_q;
  logic [8:0] select_458_s3_q;
  logic and_462_s3_q;
  logic and_463_s3_q;
  logic equal_468_s3_q;
  logic [6:0] column_s3_q;
  logic and_486_s3_q;
  logic and_488_s3_q;
  logic so_s3_q;
  logic equal_549_s3_q;
  logic equal_1930_s3_q;
  logic not_1931_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1965_s3_q;
  logic [6:0] select_1969_s3_q;
  logic and_1974_s3_q;
  logic right_2_s3_q;
  logic and_2043_s3_q;
  logic and_2056_s3_q;
  logic and_2069_s3_q;
  logic and_2071_s3_q;
  logic equal_2076_s3_q;
  logic and_2089_s3_q;
  logic [7:0] change_s3_q;
  logic equal_2132_s3_q;
  logic and_2137_s3_q;
  logic and_2138_s3_q;
  logic equal_2139_s3_q;
  logic equal_2141_s3_q;
  logic equal_2143_s3_q;
  logic or_2145_s3_q;
  logic [4:0] select_2166_s3_q;
  logic select_2172_s3_q;
  logic [3:0] select_2208_s3_q;
  logic new_row_s3_q;
  logic less_2238_s3_q;
  logic less_2239_s3_q;
  logic less_2248_s3_q;
  logic less_2249_s3_q;
  logic and_2260_s3_q;
  logic or_2264_s3_q;
  logic and_2272_s3_q;
  logic less_2273_s3_q;
  logic equal_2274_s3_q;
  logic not_2275_s3_q;
  logic equal_2276_s3_q;
  logic not_2277_s3_q;
  logic sum_2304_s3_q;
  logic textured_s3_q;
  logic and_2442_s3_q;
  logic equal_2582_s3_q;
  logic equal_2706_s3_q;
  logic less_2921_s3_q;
  logic and_3152_s3_q;
  logic equal_3612_s3_q;
  logic equal_3696_s3_q;
  logic less_3971_s3_q;
  logic equal_4176_s3_q;
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
      patches_column_s3_q <= patches_column_s2_q[4];
      patches_summed_row_column_s3_q <= patches_summed_row_column_q;
      patches_summed_last_s3_q <= patches_summed_last_q;
      patches_summed_down_by_s3_q <= patches_summed_down_by_q;
      patches_step_s3_q <= patches_step_q[4:0];
      patches_read_searches_s3_q <= patches_read_searches_q;
      select_452_s3_q <= select_452_s2_q;
      select_454_s3_q <= select_454_s2_q;
      select_458_s3_q <= select_458_s2_q;
      and_462_s3_q <= and_462_s2_q;
      and_463_s3_q <= and_463;
      equal_468_s3_q <= equal_468_s2_q;
      column_s3_q <= column_s2_q;
      and_486_s3_q <= and_486_s2_q;
      and_488_s3_q <= and_488_s2_q;
      so_s3_q <= so_s2_q;
      equal_549_s3_q <= equal_549_s2_q;
      equal_1930_s3_q <= equal_1930_s2_q;
      not_1931_s3_q <= not_1931;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1965_s3_q <= and_1965;
      select_1969_s3_q <= select_1969_s2_q;
      and_1974_s3_q <= not_1931 & (so_s2_q ? and_1963 : (equal_508_s2_q & shift_2[4]));
      right_2_s3_q <= right_2;
      and_2043_s3_q <= and_2043_s2_q;
      and_2056_s3_q <= and_2056_s2_q;
      and_2069_s3_q <= not_1931 & (so_s2_q & (ends_cell_s2_q & (shift_2[0] & right_3)));
      and_2071_s3_q <= and_2071;
      equal_2076_s3_q <= equal_2076;
      and_2089_s3_q <= and_2071 & and_2088;
      change_s3_q <= change;
      equal_2132_s3_q <= equal_2132;
      and_2137_s3_q <= and_2137;
      and_2138_s3_q <= patches_chooses_s2_q & and_2137;
      equal_2139_s3_q <= equal_2139_s2_q;
      equal_2141_s3_q <= equal_2141_s2_q;
      equal_2143_s3_q <= equal_2143_s2_q;
      or_2145_s3_q <= or_2145_s2_q;
      select_2166_s3_q <= select_2166_s2_q;
      select_2172_s3_q <= select_2172_s2_q;
      select_2208_s3_q <= select_2208_s2_q;
      new_row_s3_q <= new_row;
      less_2238_s3_q <= $signed(15'h100) < $signed(sum_2237);
      less_2239_s3_q <= $signed(sum_2237[14:8]) < $signed(7'h7f);
      less_2248_s3_q <= $signed(15'h100) < $signed(difference_2247);
      less_2249_s3_q <= $signed(difference_2247[14:8]) < $signed(7'h7f);
      and_2260_s3_q <= not_2140_s2_q & (not_2142_s2_q & and_2258);
      or_2264_s3_q <= or_2264;
      and_2272_s3_q <= not_2140_s2_q & (not_2142_s2_q & (or_2145_s2_q & and_2269));
      less_2273_s3_q <= less_2273;
      equal_2274_s3_q <= equal_2274;
      not_2275_s3_q <= not_2275;
      equal_2276_s3_q <= equal_2276;
      not_2277_s3_q <= not_2277;
      sum_2304_s3_q <= sum_2304[5];
      textured_s3_q <= textured;
      and_2442_s3_q <= not_1931 & (so_s2_q & and_2440);
      equal_2582_s3_q <= equal_2582_s2_q;
      equal_2706_s3_q <= equal_2706_s2_q;
      less_2921_s3_q <= select_2891 < select_2893;
      and_3152_s3_q <= not_1931 & and_3151;
      equal_3612_s3_q <= patches_match_row_q == 4'h0;
      equal_3696_s3_q <= patches_step_q[6:5] == 2'h2;
      less_3971_s3_q <= less_3971_s2_q;
      equal_4176_s3_q <= equal_4176_s2_q;
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
  logic [11:0] select_466;
  assign select_466 = select_452_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_470;
  assign sum_470 = select_466 + (equal_468_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_472;
  assign sum_472 = {4'h0, sample_pair_pixel_1_q} + (select_452_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_474;
  assign sum_474 = sum_472 + (equal_468_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = select_452_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_478;
  assign and_478 = whole & (averager_memory_rdata_q[24] | equal_468_s3_q);
  // hls/stages/agreement.hpp:404
  logic all_of_skin;
  assign all_of_skin = select_452_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_482;
  assign and_482 = all_of_skin & (averager_memory_rdata_q[25] | equal_468_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_462_s3_q ? sum_470[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_491;
  assign equal_491 = select_452_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_491 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_494;
  assign select_494 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_462_s3_q ? sum_474[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_491 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_498;
  assign select_498 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_499;
  assign and_499 = and_462_s3_q & and_478;
  // hls/stages/census.hpp:126
  logic select_501;
  assign select_501 = equal_491 ? and_499 : (averager_mask_q & and_499);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_501;
  // hls/stages/census.hpp:206
  logic and_503;
  assign and_503 = and_462_s3_q & and_482;
  // hls/stages/census.hpp:126
  logic select_505;
  assign select_505 = equal_491 ? and_503 : (averager_of_skin_q & and_503);
  // hls/stages/agreement.hpp:263
  logic and_506;
  assign and_506 = sample_pair_whole_s3_q & select_505;
  // hls/stages/census.hpp:294
  logic less_522;
  assign less_522 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_523;
  assign less_523 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_524;
  assign less_524 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_525;
  assign less_525 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_526;
  assign less_526 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_527;
  assign less_527 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_528;
  assign less_528 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_529;
  assign less_529 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_530;
  assign less_530 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_531;
  assign less_531 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_532;
  assign less_532 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_533;
  assign less_533 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_534;
  assign less_534 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_535;
  assign less_535 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_536;
  assign less_536 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_537;
  assign less_537 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_538;
  assign less_538 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_539;
  assign less_539 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_540;
  assign less_540 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_541;
  assign less_541 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_542;
  assign less_542 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_543;
  assign less_543 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_544;
  assign less_544 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_545;
  assign less_545 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:442
  logic equal_546;
  assign equal_546 = column_s3_q == 7'h0;
  logic [3:0] select_550;
  assign select_550 = equal_549_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_551;
  assign select_551 = equal_546 ? {select_550, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_552;
  assign select_552 = equal_546 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_553;
  assign and_553 = select_551[4] & select_552[3];
  // hls/stages/census.hpp:286
  logic and_555;
  assign and_555 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_557;
  assign and_557 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_555);
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_557;
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
  logic [9:0] difference_580;
  assign difference_580 = {1'b0, select_494} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_581;
  assign xor_581 = difference_580[8:0] ^ {9{difference_580[9]}};
  logic [9:0] sum_582;
  assign sum_582 = {9'h0, difference_580[9]} + {1'b0, xor_581};
  logic [9:0] difference_583;
  assign difference_583 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_584;
  assign xor_584 = difference_583[8:0] ^ {9{difference_583[9]}};
  logic [9:0] sum_585;
  assign sum_585 = {9'h0, difference_583[9]} + {1'b0, xor_584};
  logic [9:0] difference_587;
  assign difference_587 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_588;
  assign xor_588 = difference_587[8:0] ^ {9{difference_587[9]}};
  logic [9:0] sum_589;
  assign sum_589 = {9'h0, difference_587[9]} + {1'b0, xor_588};
  logic [10:0] sum_590;
  assign sum_590 = ({1'b0, sum_582} + {1'b0, sum_585}) + {1'b0, sum_589};
  logic [9:0] difference_591;
  assign difference_591 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_592;
  assign xor_592 = difference_591[8:0] ^ {9{difference_591[9]}};
  logic [9:0] sum_593;
  assign sum_593 = {9'h0, difference_591[9]} + {1'b0, xor_592};
  logic [9:0] difference_595;
  assign difference_595 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_596;
  assign xor_596 = difference_595[8:0] ^ {9{difference_595[9]}};
  // hls/stages/agreement.hpp:193
  logic not_1970;
  assign not_1970 = ~so_s3_q;
  // hls/stages/patches.hpp:303
  logic and_1971;
  assign and_1971 = not_1970 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1069
  logic equal_1975;
  assign equal_1975 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1115
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:146
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1070
  logic [1:0] select_1978;
  assign select_1978 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1083
  logic [3:0] select_1980;
  assign select_1980 = equal_1975 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1978});
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1981;
  assign sum_1981 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:303
  logic [3:0] select_1982;
  assign select_1982 = equal_1930_s3_q ? select_1980 : {sum_1981, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:184
  logic equal_1983;
  assign equal_1983 = x_s3_q[5:0] == 6'h3f;
  logic equal_1985;
  assign equal_1985 = x_s3_q[5:0] == 6'h3e;
  logic equal_1987;
  assign equal_1987 = x_s3_q[5:0] == 6'h3d;
  logic equal_1989;
  assign equal_1989 = x_s3_q[5:0] == 6'h3c;
  logic equal_1991;
  assign equal_1991 = x_s3_q[5:0] == 6'h3b;
  logic equal_1993;
  assign equal_1993 = x_s3_q[5:0] == 6'h36;
  logic equal_1995;
  assign equal_1995 = x_s3_q[5:0] == 6'h35;
  logic equal_1997;
  assign equal_1997 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1115
  logic and_2001;
  assign and_2001 = (~equal_1991) & ((~equal_1993) & ((~equal_1995) & (~equal_1997)));
  logic and_2005;
  assign and_2005 = (~equal_1983) & ((~equal_1985) & ((~equal_1987) & ((~equal_1989) & and_2001)));
  // hls/stages/agreement.hpp:1070
  logic less_2006;
  assign less_2006 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:147
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:159
  logic or_2010;
  assign or_2010 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_2021;
  assign sum_2021 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_2023;
  assign and_2023 = half_ends & ({{3{sum_2021[4]}}, sum_2021} < 8'h3);
  // hls/stages/patches.hpp:303
  logic and_2024;
  assign and_2024 = so_s3_q & and_2023;
  logic select_2025;
  assign select_2025 = equal_1930_s3_q ? (x_s3_q[6] & (equal_1975 ? and_2005 : (less_2006 & (~or_2010)))) : and_2024;
  // hls/stages/registration.hpp:255
  logic not_2027;
  assign not_2027 = ~lower_half_s3_q;
  logic [3:0] select_2028;
  assign select_2028 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_2027, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_2027};
  // hls/stages/patches.hpp:327
  logic [1:0] select_2057;
  assign select_2057 = and_2056_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2058;
  assign select_2058 = and_2056_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_2059;
  assign select_2059 = and_2043_s3_q ? {select_2058, select_2057[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:98
  logic [1:0] select_2060;
  assign select_2060 = and_2043_s3_q ? select_2057 : patches_fetch_q;
  logic equal_2061;
  assign equal_2061 = select_2060 == 2'h0;
  // hls/stages/patches.hpp:303
  logic and_2093;
  assign and_2093 = not_1931_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & and_2089_s3_q)));
  // hls/stages/patches.hpp:133
  logic and_2095;
  assign and_2095 = and_2093 & (~patches_fixed_q);
  // hls/stages/patches.hpp:303
  logic [7:0] select_2098;
  assign select_2098 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2099;
  assign select_2099 = equal_1930_s3_q ? 8'h0 : select_2098;
  logic [5:0] select_2101;
  assign select_2101 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_2103;
  assign select_2103 = equal_1930_s3_q ? 6'h0 : (so_s3_q ? select_2101 : 6'h0);
  // hls/stages/registration.hpp:83
  logic equal_2104;
  assign equal_2104 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2104 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:210
  logic [7:0] select_2110;
  assign select_2110 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2111;
  assign select_2111 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2112;
  assign difference_2112 = {{2{select_2110[7]}}, select_2110[7:1]} - {select_2111[7], select_2111};
  // hls/stages/registration.hpp:208
  logic [6:0] select_2113;
  assign select_2113 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2114;
  assign select_2114 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2115;
  assign sum_2115 = {{2{select_2113[6]}}, select_2113} + {select_2114[7], select_2114};
  // hls/stages/registration.hpp:209
  logic [7:0] select_2116;
  assign select_2116 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2117;
  assign select_2117 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2118;
  assign sum_2118 = {{2{select_2116[7]}}, select_2116[7:1]} + {select_2117[7], select_2117};
  // hls/stages/registration.hpp:211
  logic [10:0] sum_2119;
  assign sum_2119 = {{3{sum_2115[8]}}, sum_2115[8:1]} + {sum_2118[8], sum_2118, select_2116[0]};
  logic [9:0] sum_2120;
  assign sum_2120 = {difference_2112, select_2110[0]} + {sum_2119[10], sum_2119[10:2]};
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2121;
  assign sum_2121 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_2120[9]}}, sum_2120[9:2]};
  // hls/stages/registration.hpp:215
  logic [7:0] select_2124;
  assign select_2124 = ($signed(sum_2121[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2121[7:0];
  // hls/stages/registration.hpp:106
  logic [7:0] slope;
  assign slope = equal_2104 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2121[12:7])) ? 8'h7f : select_2124);
  // hls/stages/patches.hpp:303
  logic [7:0] select_2129;
  assign select_2129 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2130;
  assign select_2130 = equal_1930_s3_q ? 8'h0 : select_2129;
  // hls/stages/patches.hpp:306
  logic [22:0] select_2131;
  assign select_2131 = and_2095 ? {select_2130, select_2103, select_2099, and_2093} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:98
  logic [4:0] select_2152;
  assign select_2152 = and_2043_s3_q ? select_2058 : patches_band_q;
  // hls/stages/patches.hpp:100
  logic equal_2153;
  assign equal_2153 = {patches_choosing_band_s3_q, and_2069_s3_q} == {select_2152, select_2060[1]};
  // hls/stages/patches.hpp:423
  logic [2:0] sum_2229;
  assign sum_2229 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:427
  logic [1:0] sum_2262;
  assign sum_2262 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_2291;
  assign select_2291 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:991
  logic or_2294;
  assign or_2294 = select_2291[7] | (~({select_2291[5], select_2291[3], select_2291[1]} == 3'h0));
  // hls/stages/agreement.hpp:990
  logic or_2297;
  assign or_2297 = select_2291[7] | (~({select_2291[6], select_2291[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:989
  logic or_2300;
  assign or_2300 = select_2291[7] | (~(select_2291[6:4] == 3'h0));
  // hls/stages/patches.hpp:303
  logic [5:0] select_2301;
  assign select_2301 = equal_1930_s3_q ? x_s3_q[5:0] : {region_row_q, or_2300, or_2297, or_2294};
  // hls/stages/agreement.hpp:1069
  logic not_2302;
  assign not_2302 = ~equal_1975;
  // hls/stages/agreement.hpp:999
  logic or_2306;
  assign or_2306 = (~sum_2304_s3_q) | equal_2132_s3_q;
  // hls/stages/patches.hpp:303
  logic and_2309;
  assign and_2309 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_2306));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_2330;
  assign and_2330 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:960
  logic select_2331;
  assign select_2331 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_2331);
  // hls/stages/agreement.hpp:960
  logic select_2334;
  assign select_2334 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_2331 ? select_2334 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1200
  logic or_2337;
  assign or_2337 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1202
  logic [16:0] select_2339;
  assign select_2339 = marks_first_s3_q ? 17'h1 : (or_2337 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1201
  logic [8:0] select_2341;
  assign select_2341 = or_2337 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1209
  logic select_2343;
  assign select_2343 = cfg_compete_i ? (or_2337 & select_2339[16]) : (select_2341[8] & select_2339[9]);
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = select_2343 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1216
  logic [6:0] select_2346;
  assign select_2346 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2348;
  assign select_2348 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_2346});
  // hls/stages/agreement.hpp:1226
  logic equal_2349;
  assign equal_2349 = seen_x_q == 3'h7;
  logic [7:0] select_2351;
  assign select_2351 = select_2343 ? 8'h0 : (seen_column_q + {7'h0, equal_2349});
  // hls/stages/agreement.hpp:1233
  logic [12:0] index;
  assign index = select_2348 + {5'h0, select_2351};
  // hls/stages/agreement.hpp:1200
  logic select_2354;
  assign select_2354 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1186
  logic [7:0] sum_2355;
  assign sum_2355 = {1'b0, select_2354, 2'h0, select_2354, 1'b0, {2{select_2354}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1199
  logic not_2356;
  assign not_2356 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:422
  logic and_2358;
  assign and_2358 = not_2356 & (began_q | select_2343);
  // hls/stages/agreement.hpp:1227
  logic [2:0] select_2360;
  assign select_2360 = select_2343 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1232
  logic and_2362;
  assign and_2362 = and_2358 & (select_2360 == 3'h0);
  logic less_2363;
  assign less_2363 = select_2351 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1052
  logic [7:0] sum_2366;
  assign sum_2366 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2366[7]}}, sum_2366, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1186
  logic [7:0] sum_2368;
  assign sum_2368 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:975
  logic and_2369;
  assign and_2369 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_2370;
  assign and_2370 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_2371;
  assign and_2371 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_2372;
  assign and_2372 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1028
  logic [1:0] sum_2374;
  assign sum_2374 = {1'b0, and_2371} + ({1'b0, textured_s3_q} + {1'b0, and_2372});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2369} + ({2'h0, and_2370} + {1'b0, sum_2374});
  // hls/stages/agreement.hpp:1035
  logic [2:0] select_2377;
  assign select_2377 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2378;
  assign difference_2378 = {1'b0, textured_2} - {1'b0, select_2377};
  logic [4:0] t;
  assign t = {difference_2378[3], difference_2378} + (equal_2076_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:975
  logic [7:0] select_2383;
  assign select_2383 = shift_2_s3_q[0] ? (sum_2304_s3_q ? select_2291 : {select_2291[6:0], 1'b0}) : select_2291;
  // hls/stages/agreement.hpp:991
  logic or_2386;
  assign or_2386 = select_2383[7] | (~({select_2383[5], select_2383[3], select_2383[1]} == 3'h0));
  // hls/stages/agreement.hpp:975
  logic and_2403;
  assign and_2403 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_2404;
  assign and_2404 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_2405;
  assign and_2405 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_2406;
  assign and_2406 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2408;
  assign sum_2408 = {1'b0, and_2405} + ({1'b0, shown} + {1'b0, and_2406});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2403} + ({2'h0, and_2404} + {1'b0, sum_2408});
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2411;
  assign select_2411 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2412;
  assign difference_2412 = {1'b0, shown_2} - {1'b0, select_2411};
  logic [4:0] around;
  assign around = {difference_2412[3], difference_2412} + (equal_2076_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2415;
  assign sum_2415 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:975
  logic and_2419;
  assign and_2419 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2420;
  assign and_2420 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2421;
  assign and_2421 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2422;
  assign and_2422 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_2424;
  assign sum_2424 = {1'b0, and_2421} + ({1'b0, near} + {1'b0, and_2422});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2419} + ({2'h0, and_2420} + {1'b0, sum_2424});
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_2427;
  assign select_2427 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2428;
  assign difference_2428 = {1'b0, near_2} - {1'b0, select_2427};
  logic [4:0] n;
  assign n = {difference_2428[3], difference_2428} + (equal_2076_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2474;
  assign select_2474 = sample_pair_whole_s3_q ? (and_486_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2476;
  assign select_2476 = sample_pair_whole_s3_q ? (and_486_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2495;
  assign select_2495 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2497;
  assign select_2497 = sample_pair_whole_s3_q ? (and_486_s3_q ? select_501 : averager_mask_q) : averager_mask_q;
  logic select_2499;
  assign select_2499 = sample_pair_whole_s3_q ? (and_486_s3_q ? select_505 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2500;
  assign select_2500 = and_488_s3_q ? select_494 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2501;
  assign select_2501 = and_488_s3_q ? select_498 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2503;
  assign select_2503 = and_488_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2504;
  assign select_2504 = and_488_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2505;
  assign select_2505 = and_488_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2506;
  assign select_2506 = and_488_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2507;
  assign select_2507 = and_488_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2508;
  assign select_2508 = and_488_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2509;
  assign select_2509 = and_488_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2510;
  assign select_2510 = and_488_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2511;
  assign select_2511 = and_488_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2512;
  assign select_2512 = and_488_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2513;
  assign select_2513 = and_488_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2514;
  assign select_2514 = and_488_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2515;
  assign select_2515 = and_488_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2516;
  assign select_2516 = and_488_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2517;
  assign select_2517 = and_488_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2518;
  assign select_2518 = and_488_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2519;
  assign select_2519 = and_488_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2520;
  assign select_2520 = and_488_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2521;
  assign select_2521 = and_488_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2522;
  assign select_2522 = and_488_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2523;
  assign select_2523 = and_488_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2524;
  assign select_2524 = and_488_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2525;
  assign select_2525 = and_488_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2526;
  assign select_2526 = and_488_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2527;
  assign select_2527 = and_488_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2528;
  assign select_2528 = and_488_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2529;
  assign select_2529 = and_488_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2530;
  assign select_2530 = and_488_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2531;
  assign select_2531 = and_488_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2532;
  assign select_2532 = and_488_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2533;
  assign select_2533 = and_488_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2534;
  assign select_2534 = and_488_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2535;
  assign select_2535 = and_488_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2536;
  assign select_2536 = and_488_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2537;
  assign select_2537 = and_488_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2538;
  assign select_2538 = and_488_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2539;
  assign select_2539 = and_488_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2540;
  assign select_2540 = and_488_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2541;
  assign select_2541 = and_488_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2542;
  assign select_2542 = and_488_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2543;
  assign select_2543 = and_488_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2544;
  assign select_2544 = and_488_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2545;
  assign select_2545 = and_488_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2546;
  assign select_2546 = and_488_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2547;
  assign select_2547 = and_488_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2548;
  assign select_2548 = and_488_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2549;
  assign select_2549 = and_488_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2550;
  assign select_2550 = and_488_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2551;
  assign select_2551 = and_488_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2552;
  assign select_2552 = and_488_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2553;
  assign select_2553 = and_488_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2554;
  assign select_2554 = and_488_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2555;
  assign select_2555 = and_488_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2557;
  assign difference_2557 = {1'b0, select_498} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2558;
  assign xor_2558 = difference_2557[8:0] ^ {9{difference_2557[9]}};
  logic [9:0] sum_2559;
  assign sum_2559 = {9'h0, difference_2557[9]} + {1'b0, xor_2558};
  logic [9:0] difference_2560;
  assign difference_2560 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2561;
  assign xor_2561 = difference_2560[8:0] ^ {9{difference_2560[9]}};
  logic [9:0] sum_2562;
  assign sum_2562 = {9'h0, difference_2560[9]} + {1'b0, xor_2561};
  logic [9:0] difference_2564;
  assign difference_2564 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2565;
  assign xor_2565 = difference_2564[8:0] ^ {9{difference_2564[9]}};
  logic [9:0] sum_2566;
  assign sum_2566 = {9'h0, difference_2564[9]} + {1'b0, xor_2565};
  logic [10:0] sum_2567;
  assign sum_2567 = ({1'b0, sum_2559} + {1'b0, sum_2562}) + {1'b0, sum_2566};
  logic [9:0] difference_2568;
  assign difference_2568 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2569;
  assign xor_2569 = difference_2568[8:0] ^ {9{difference_2568[9]}};
  logic [9:0] sum_2570;
  assign sum_2570 = {9'h0, difference_2568[9]} + {1'b0, xor_2569};
  logic [9:0] difference_2572;
  assign difference_2572 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2573;
  assign xor_2573 = difference_2572[8:0] ^ {9{difference_2572[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2603;
  assign difference_2603 = {1'b0, select_494} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2603[9]} + (difference_2603[8:0] ^ {9{difference_2603[9]}});
  logic [9:0] difference_2615;
  assign difference_2615 = {1'b0, select_498} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2615[9]} + (difference_2615[8:0] ^ {9{difference_2615[9]}});
  // hls/stages/agreement.hpp:507
  logic and_2803;
  assign and_2803 = and_488_s3_q & (equal_549_s3_q & equal_2706_s3_q);
  // hls/stages/patches.hpp:303
  logic and_2807;
  assign and_2807 = not_1931_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:975
  logic and_2827;
  assign and_2827 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2828;
  assign and_2828 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2829;
  assign and_2829 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2830;
  assign and_2830 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_2832;
  assign sum_2832 = {1'b0, and_2829} + ({1'b0, explained} + {1'b0, and_2830});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2827} + ({2'h0, and_2828} + {1'b0, sum_2832});
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_2835;
  assign select_2835 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2836;
  assign difference_2836 = {1'b0, explained_2} - {1'b0, select_2835};
  logic [4:0] e;
  assign e = {difference_2836[3], difference_2836} + (equal_2076_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1043
  logic [5:0] sum_2839;
  assign sum_2839 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/patches.hpp:303
  logic and_2868;
  assign and_2868 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2912;
  assign select_2912 = equal_1930_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_2913;
  assign equal_2913 = slot_s3_q == 3'h4;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2920;
  assign sum_2920 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2922;
  assign difference_2922 = {sum_2920, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2923;
  assign select_2923 = less_2921_s3_q ? difference_2922 : {sum_2920, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2924;
  assign select_2924 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2920, shift_2_s3_q[11], 5'h0} : select_2923;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2924[7]}}, select_2924} - {sum_2120[9], sum_2120, sum_2119[1]};
  // hls/stages/registration.hpp:215
  logic [11:0] select_2927;
  assign select_2927 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2927[11:7])) ? 12'h7f : select_2927;
  // hls/stages/registration.hpp:202
  logic [12:0] difference_2948;
  assign difference_2948 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:106
  logic and_2950;
  assign and_2950 = and_2071_s3_q & ($signed(difference_2948) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:202
  logic less_2963;
  assign less_2963 = $signed(difference_2948) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:303
  logic select_2971;
  assign select_2971 = so_s3_q ? (equal_2913 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_2974;
  assign select_2974 = so_s3_q ? (equal_2104 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:266
  logic [3:0] select_2979;
  assign select_2979 = (sum_1981 == 2'h2) ? (registration_fresh_q & (~select_2028)) : registration_fresh_q;
  // hls/stages/patches.hpp:303
  logic [3:0] select_2981;
  assign select_2981 = so_s3_q ? (and_2023 ? select_2979 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:239
  logic [3:0] select_2983;
  assign select_2983 = and_2803 ? 4'hf : (equal_1930_s3_q ? registration_fresh_q : select_2981);
  // hls/stages/agreement.hpp:1070
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1978;
  // hls/stages/registration.hpp:255
  logic not_3004;
  assign not_3004 = ~quarter_2[1];
  logic [3:0] select_3005;
  assign select_3005 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3004, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3004};
  // hls/stages/patches.hpp:308
  logic not_3142;
  assign not_3142 = ~and_2137_s3_q;
  // hls/stages/patches.hpp:101
  logic not_3168;
  assign not_3168 = ~select_2060[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_3170;
  assign select_3170 = sample_pair_whole_s3_q ? (equal_2061 ? select_2060 : {not_3168, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:443
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_right_codes_rdata_q[55:0] : {patches_codes_high_q[3:0], patches_codes_low_q};
  // hls/stages/patches.hpp:160
  logic [51:0] select_3267;
  assign select_3267 = or_2145_s3_q ? {patches_codes_high_q[3:0], patches_codes_low_q[51:4]} : patches_codes_low_q;
  logic [51:0] select_3269;
  assign select_3269 = equal_2139_s3_q ? patches_codes_low_q : (equal_2141_s3_q ? other[55:4] : select_3267);
  // hls/stages/patches.hpp:443
  logic [55:0] select_3270;
  assign select_3270 = new_row_s3_q ? patches_right_codes_rdata_q[111:56] : {4'h0, patches_codes_high_q[55:4]};
  // hls/stages/patches.hpp:160
  logic [55:0] select_3271;
  assign select_3271 = or_2145_s3_q ? {less_2249_s3_q, less_2248_s3_q, less_2239_s3_q, less_2238_s3_q, patches_codes_high_q[55:4]} : patches_codes_high_q;
  logic [55:0] select_3273;
  assign select_3273 = equal_2139_s3_q ? patches_codes_high_q : (equal_2141_s3_q ? select_3270 : select_3271);
  // hls/stages/count_bits.hpp:24
  logic parity_3278;
  assign parity_3278 = ^{less_2249_s3_q, less_2248_s3_q, less_2239_s3_q, less_2238_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_3282;
  assign or_3282 = ({less_2239_s3_q, less_2238_s3_q} == 2'h3) | (less_2248_s3_q & (less_2239_s3_q | less_2238_s3_q));
  logic and_3283;
  assign and_3283 = less_2249_s3_q & (^{less_2248_s3_q, less_2239_s3_q, less_2238_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3284;
  assign xor_3284 = or_3282 ^ and_3283;
  // hls/stages/count_bits.hpp:27
  logic and_3285;
  assign and_3285 = or_3282 & and_3283;
  // hls/stages/patches.hpp:429
  logic [2:0] select_3287;
  assign select_3287 = or_2264_s3_q ? 3'h0 : (patches_column_s3_q ? 3'h0 : {and_3285, xor_3284, parity_3278});
  // hls/stages/patches.hpp:160
  logic [2:0] select_3290;
  assign select_3290 = equal_2139_s3_q ? 3'h0 : (equal_2141_s3_q ? 3'h0 : (or_2145_s3_q ? select_3287 : 3'h0));
  // hls/stages/patches.hpp:143
  logic [9:0] sum_3292;
  assign sum_3292 = {7'h0, patches_set_q} + (equal_2143_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:444
  logic [47:0] select_3302;
  assign select_3302 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:160
  logic [47:0] select_3304;
  assign select_3304 = equal_2139_s3_q ? patches_left_row_q : (equal_2141_s3_q ? select_3302 : patches_left_row_q);
  // hls/stages/patches.hpp:444
  logic [47:0] bits;
  assign bits = select_3302 ^ other[47:0];
  // hls/stages/count_bits.hpp:24
  logic xor_3308;
  assign xor_3308 = bits[17] ^ (^{select_3302[16:15], other[16:15]});
  logic xor_3311;
  assign xor_3311 = bits[11] ^ (^{select_3302[10:9], other[10:9]});
  logic xor_3314;
  assign xor_3314 = bits[14] ^ (^{select_3302[13:12], other[13:12]});
  logic xor_3317;
  assign xor_3317 = xor_3308 ^ (^{select_3302[14:9], other[14:9]});
  logic xor_3320;
  assign xor_3320 = bits[47] ^ (^{select_3302[46:45], other[46:45]});
  logic xor_3323;
  assign xor_3323 = bits[8] ^ (^{select_3302[7:6], other[7:6]});
  logic xor_3326;
  assign xor_3326 = bits[2] ^ (^{select_3302[1:0], other[1:0]});
  logic xor_3329;
  assign xor_3329 = bits[5] ^ (^{select_3302[4:3], other[4:3]});
  logic xor_3332;
  assign xor_3332 = xor_3323 ^ (^{select_3302[5:0], other[5:0]});
  logic parity_3334;
  assign parity_3334 = ^{select_3302[47:45], select_3302[8:0], other[47:45], other[8:0]};
  logic xor_3335;
  assign xor_3335 = xor_3317 ^ parity_3334;
  logic xor_3338;
  assign xor_3338 = bits[44] ^ (^{select_3302[43:42], other[43:42]});
  logic xor_3341;
  assign xor_3341 = bits[38] ^ (^{select_3302[37:36], other[37:36]});
  logic xor_3344;
  assign xor_3344 = bits[41] ^ (^{select_3302[40:39], other[40:39]});
  logic xor_3350;
  assign xor_3350 = bits[26] ^ (^{select_3302[25:24], other[25:24]});
  logic xor_3353;
  assign xor_3353 = bits[20] ^ (^{select_3302[19:18], other[19:18]});
  logic xor_3356;
  assign xor_3356 = bits[23] ^ (^{select_3302[22:21], other[22:21]});
  logic xor_3359;
  assign xor_3359 = xor_3350 ^ (^{select_3302[23:18], other[23:18]});
  logic xor_3362;
  assign xor_3362 = bits[35] ^ (^{select_3302[34:33], other[34:33]});
  logic xor_3365;
  assign xor_3365 = bits[29] ^ (^{select_3302[28:27], other[28:27]});
  logic xor_3368;
  assign xor_3368 = bits[32] ^ (^{select_3302[31:30], other[31:30]});
  logic xor_3371;
  assign xor_3371 = xor_3362 ^ (^{select_3302[32:27], other[32:27]});
  logic xor_3372;
  assign xor_3372 = xor_3359 ^ xor_3371;
  // hls/stages/count_bits.hpp:25
  logic or_3380;
  assign or_3380 = (xor_3311 & xor_3314) | (xor_3308 & (xor_3311 | xor_3314));
  logic or_3384;
  assign or_3384 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3388;
  assign or_3388 = (xor_3326 & xor_3329) | (xor_3323 & (xor_3326 | xor_3329));
  // hls/stages/count_bits.hpp:23
  logic or_3395;
  assign or_3395 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3399;
  assign or_3399 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3403;
  assign or_3403 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3406;
  assign parity_3406 = ^{or_3403, or_3399, or_3395};
  // hls/stages/count_bits.hpp:23
  logic or_3410;
  assign or_3410 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3414;
  assign or_3414 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3418;
  assign or_3418 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3421;
  assign parity_3421 = ^{or_3418, or_3414, or_3410};
  logic parity_3424;
  assign parity_3424 = ^{or_3418, or_3414, or_3410, or_3403, or_3399, or_3395, or_3388, or_3384, or_3380};
  // hls/stages/count_bits.hpp:23
  logic or_3428;
  assign or_3428 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3432;
  assign or_3432 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3436;
  assign or_3436 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3444;
  assign or_3444 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3448;
  assign or_3448 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3452;
  assign or_3452 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3455;
  assign parity_3455 = ^{or_3452, or_3448, or_3444};
  // hls/stages/count_bits.hpp:23
  logic or_3459;
  assign or_3459 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3463;
  assign or_3463 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3467;
  assign or_3467 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3470;
  assign parity_3470 = ^{or_3467, or_3463, or_3459};
  logic parity_3473;
  assign parity_3473 = ^{or_3467, or_3463, or_3459, or_3452, or_3448, or_3444, or_3436, or_3432, or_3428};
  // hls/stages/count_bits.hpp:25
  logic or_3477;
  assign or_3477 = (xor_3341 & xor_3344) | (xor_3338 & (xor_3341 | xor_3344));
  logic or_3481;
  assign or_3481 = (xor_3353 & xor_3356) | (xor_3350 & (xor_3353 | xor_3356));
  logic or_3485;
  assign or_3485 = (xor_3365 & xor_3368) | (xor_3362 & (xor_3365 | xor_3368));
  // hls/stages/count_bits.hpp:24
  logic parity_3488;
  assign parity_3488 = ^{or_3485, or_3481, or_3477};
  // hls/stages/count_bits.hpp:25
  logic and_3489;
  assign and_3489 = xor_3335 & (^{xor_3372, select_3302[44:36], other[44:36]});
  logic or_3493;
  assign or_3493 = (xor_3320 & xor_3332) | (xor_3317 & (xor_3320 | xor_3332));
  logic and_3496;
  assign and_3496 = (xor_3338 ^ (^{select_3302[41:36], other[41:36]})) & (xor_3359 | xor_3371);
  logic or_3497;
  assign or_3497 = (xor_3359 & xor_3371) | and_3496;
  // hls/stages/count_bits.hpp:24
  logic parity_3500;
  assign parity_3500 = ^{or_3497, or_3493, and_3489};
  logic parity_3503;
  assign parity_3503 = ^{or_3497, or_3493, and_3489, or_3485, or_3481, or_3477, or_3467, or_3463, or_3459, or_3452, or_3448, or_3444, or_3436, or_3432, or_3428};
  logic parity_3505;
  assign parity_3505 = ^{or_3497, or_3493, and_3489, or_3485, or_3481, or_3477, or_3467, or_3463, or_3459, or_3452, or_3448, or_3444, or_3436, or_3432, or_3428, or_3418, or_3414, or_3410, or_3403, or_3399, or_3395, or_3388, or_3384, or_3380};
  // hls/stages/count_bits.hpp:25
  logic and_3506;
  assign and_3506 = parity_3424 & parity_3503;
  logic or_3510;
  assign or_3510 = (parity_3406 & parity_3421) | ((^{or_3388, or_3384, or_3380}) & (parity_3406 | parity_3421));
  logic or_3514;
  assign or_3514 = (parity_3488 & parity_3500) | (parity_3473 & (parity_3488 | parity_3500));
  logic or_3521;
  assign or_3521 = (parity_3455 & parity_3470) | ((^{or_3436, or_3432, or_3428}) & (parity_3455 | parity_3470));
  logic or_3525;
  assign or_3525 = (or_3481 & or_3485) | (or_3477 & (or_3481 | or_3485));
  logic or_3529;
  assign or_3529 = (or_3493 & or_3497) | (and_3489 & (or_3493 | or_3497));
  // hls/stages/count_bits.hpp:23
  logic or_3536;
  assign or_3536 = (or_3432 & or_3436) | (or_3428 & (or_3432 | or_3436));
  // hls/stages/count_bits.hpp:25
  logic or_3540;
  assign or_3540 = (or_3448 & or_3452) | (or_3444 & (or_3448 | or_3452));
  logic or_3544;
  assign or_3544 = (or_3463 & or_3467) | (or_3459 & (or_3463 | or_3467));
  // hls/stages/count_bits.hpp:24
  logic parity_3547;
  assign parity_3547 = ^{or_3544, or_3540, or_3536};
  // hls/stages/count_bits.hpp:23
  logic or_3551;
  assign or_3551 = (or_3384 & or_3388) | (or_3380 & (or_3384 | or_3388));
  // hls/stages/count_bits.hpp:25
  logic or_3555;
  assign or_3555 = (or_3399 & or_3403) | (or_3395 & (or_3399 | or_3403));
  logic or_3559;
  assign or_3559 = (or_3414 & or_3418) | (or_3410 & (or_3414 | or_3418));
  // hls/stages/count_bits.hpp:24
  logic parity_3562;
  assign parity_3562 = ^{or_3559, or_3555, or_3551};
  logic parity_3565;
  assign parity_3565 = ^{or_3559, or_3555, or_3551, or_3544, or_3540, or_3536, or_3529, or_3525, or_3521};
  logic parity_3567;
  assign parity_3567 = ^{or_3559, or_3555, or_3551, or_3544, or_3540, or_3536, or_3529, or_3525, or_3521, or_3514, or_3510, and_3506};
  // hls/stages/count_bits.hpp:25
  logic or_3571;
  assign or_3571 = (or_3525 & or_3529) | (or_3521 & (or_3525 | or_3529));
  logic or_3575;
  assign or_3575 = (or_3540 & or_3544) | (or_3536 & (or_3540 | or_3544));
  logic or_3579;
  assign or_3579 = (or_3555 & or_3559) | (or_3551 & (or_3555 | or_3559));
  // hls/stages/count_bits.hpp:24
  logic parity_3582;
  assign parity_3582 = ^{or_3579, or_3575, or_3571};
  // hls/stages/count_bits.hpp:25
  logic and_3583;
  assign and_3583 = (^{or_3514, or_3510, and_3506}) & parity_3565;
  logic or_3587;
  assign or_3587 = (or_3510 & or_3514) | (and_3506 & (or_3510 | or_3514));
  logic or_3591;
  assign or_3591 = (parity_3547 & parity_3562) | ((^{or_3529, or_3525, or_3521}) & (parity_3547 | parity_3562));
  // hls/stages/count_bits.hpp:24
  logic parity_3594;
  assign parity_3594 = ^{or_3591, or_3587, and_3583};
  // hls/stages/count_bits.hpp:25
  logic and_3596;
  assign and_3596 = parity_3582 & parity_3594;
  logic or_3600;
  assign or_3600 = (or_3575 & or_3579) | (or_3571 & (or_3575 | or_3579));
  logic or_3604;
  assign or_3604 = (or_3587 & or_3591) | (and_3583 & (or_3587 | or_3591));
  // hls/stages/patches.hpp:160
  logic select_3652;
  assign select_3652 = equal_2139_s3_q ? patches_summed_first_q : (equal_2141_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:476
  logic [9:0] select_3659;
  assign select_3659 = less_2273_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:480
  logic [9:0] select_3662;
  assign select_3662 = equal_2276_s3_q ? (less_2273_s3_q ? (equal_2276_s3_q ? 10'h0 : select_3659) : 10'h0) : select_3659;
  logic [9:0] select_3664;
  assign select_3664 = less_2273_s3_q ? (equal_2274_s3_q ? 10'h0 : select_3662) : select_3662;
  // hls/stages/patches.hpp:476
  logic [4:0] select_3666;
  assign select_3666 = less_2273_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:480
  logic [4:0] select_3669;
  assign select_3669 = equal_2276_s3_q ? (less_2273_s3_q ? (equal_2276_s3_q ? 5'h0 : select_3666) : 5'h0) : select_3666;
  logic [4:0] select_3671;
  assign select_3671 = less_2273_s3_q ? (equal_2274_s3_q ? 5'h0 : select_3669) : select_3669;
  // hls/stages/patches.hpp:476
  logic [4:0] select_3673;
  assign select_3673 = less_2273_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:480
  logic [4:0] select_3676;
  assign select_3676 = equal_2276_s3_q ? (less_2273_s3_q ? (equal_2276_s3_q ? 5'h0 : select_3673) : 5'h0) : select_3673;
  logic [4:0] select_3678;
  assign select_3678 = less_2273_s3_q ? (equal_2274_s3_q ? 5'h0 : select_3676) : select_3676;
  // hls/stages/patches.hpp:476
  logic and_3681;
  assign and_3681 = less_2273_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:480
  logic select_3684;
  assign select_3684 = equal_2276_s3_q ? (less_2273_s3_q ? (not_2277_s3_q & and_3681) : and_3681) : and_3681;
  // hls/stages/patches.hpp:160
  logic select_3687;
  assign select_3687 = equal_2139_s3_q ? (less_2273_s3_q ? (not_2275_s3_q & select_3684) : select_3684) : patches_read_first_q;
  // hls/stages/patches.hpp:154
  logic or_3698;
  assign or_3698 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3699;
  assign and_3699 = patches_read_searches_s3_q & or_3698;
  // hls/stages/patches.hpp:460
  logic [4:0] select_3700;
  assign select_3700 = and_3699 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:467
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3700};
  // hls/stages/patches.hpp:476
  logic and_3704;
  assign and_3704 = less_2273_s3_q & (equal_3696_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:480
  logic select_3707;
  assign select_3707 = equal_2276_s3_q ? (less_2273_s3_q ? (not_2277_s3_q & and_3704) : and_3704) : and_3704;
  // hls/stages/patches.hpp:160
  logic select_3710;
  assign select_3710 = equal_2139_s3_q ? (less_2273_s3_q ? (not_2275_s3_q & select_3707) : select_3707) : patches_read_above_q;
  // hls/stages/patches.hpp:476
  logic and_3713;
  assign and_3713 = less_2273_s3_q & (equal_3696_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:480
  logic select_3716;
  assign select_3716 = equal_2276_s3_q ? (less_2273_s3_q ? (not_2277_s3_q & and_3713) : and_3713) : and_3713;
  // hls/stages/patches.hpp:160
  logic select_3719;
  assign select_3719 = equal_2139_s3_q ? (less_2273_s3_q ? (not_2275_s3_q & select_3716) : select_3716) : patches_read_below_q;
  // hls/stages/patches.hpp:473
  logic [6:0] sum_3720;
  assign sum_3720 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:474
  logic [9:0] select_3723;
  assign select_3723 = (equal_3696_s3_q & ({sum_3720[6], sum_3720} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:476
  logic [9:0] select_3724;
  assign select_3724 = less_2273_s3_q ? select_3723 : 10'h3ff;
  // hls/stages/patches.hpp:477
  logic [9:0] select_3726;
  assign select_3726 = less_2273_s3_q ? (equal_2276_s3_q ? 10'h3ff : select_3724) : 10'h3ff;
  // hls/stages/patches.hpp:480
  logic [9:0] select_3727;
  assign select_3727 = equal_2276_s3_q ? select_3726 : select_3724;
  logic [9:0] select_3729;
  assign select_3729 = less_2273_s3_q ? (equal_2274_s3_q ? 10'h3ff : select_3727) : select_3727;
  // hls/stages/patches.hpp:459
  logic [14:0] select_3731;
  assign select_3731 = and_3699 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:160
  logic [9:0] select_3732;
  assign select_3732 = equal_2139_s3_q ? select_3731[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3733;
  assign select_3733 = equal_2139_s3_q ? select_3731[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:461
  logic [9:0] select_3735;
  assign select_3735 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:462
  logic [9:0] select_3737;
  assign select_3737 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:463
  logic [9:0] select_3740;
  assign select_3740 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3741;
  assign select_3741 = patches_read_first_q ? patches_read_far_q : select_3740;
  // hls/stages/patches.hpp:514
  logic [9:0] difference_3744;
  assign difference_3744 = select_3741 - select_3731[9:0];
  // hls/stages/patches.hpp:499
  logic less_3774;
  assign less_3774 = select_3735 < select_3737;
  // hls/stages/patches.hpp:505
  logic [1:0] sum_3775;
  assign sum_3775 = select_3700[4:3] + 2'h3;
  // hls/stages/patches.hpp:500
  logic [9:0] high;
  assign high = less_3774 ? select_3737 : select_3735;
  logic [9:0] low;
  assign low = (select_3737 < select_3735) ? select_3737 : select_3735;
  // hls/stages/patches.hpp:501
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3731[9:0];
  // hls/stages/patches.hpp:503
  logic not_3782;
  assign not_3782 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3783;
  assign sum_3783 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3785;
  assign not_3785 = ~({eight, 3'h0} < {1'b0, sum_3783, fall[0]});
  logic [1:0] sum_3786;
  assign sum_3786 = {1'b0, not_3782} + {1'b0, not_3785};
  // hls/stages/patches.hpp:504
  logic [10:0] sum_3787;
  assign sum_3787 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3789;
  assign not_3789 = ~({eight, 3'h0} < {sum_3787, fall[1:0]});
  logic not_3792;
  assign not_3792 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3793;
  assign sum_3793 = {1'b0, not_3789} + {1'b0, not_3792};
  // hls/stages/patches.hpp:503
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3786} + {1'b0, sum_3793};
  // hls/stages/patches.hpp:506
  logic [7:0] select_3796;
  assign select_3796 = less_3774 ? ({sum_3775, select_3700[2:0], 3'h0} - {5'h0, fraction}) : {sum_3775, select_3700[2:0], fraction};
  // hls/stages/agreement.hpp:1085
  logic equal_3952;
  assign equal_3952 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/patches.hpp:303
  logic select_3968;
  assign select_3968 = equal_1930_s3_q ? shown_shown_q : (so_s3_q ? select_2331 : shown_shown_q);
  logic select_3970;
  assign select_3970 = equal_1930_s3_q ? shown_nearer_q : (so_s3_q ? select_2334 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3972;
  assign sum_3972 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3974;
  assign select_3974 = less_3971_s3_q ? (sum_3972[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3976;
  assign select_3976 = equal_2706_s3_q ? (equal_549_s3_q ? 3'h0 : select_3974) : region_row_q;
  // hls/stages/patches.hpp:303
  logic [7:0] select_3981;
  assign select_3981 = equal_1930_s3_q ? select_2291 : (so_s3_q ? (ends_cell_s3_q ? select_2383 : select_2291) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_3995;
  assign select_3995 = equal_549_s3_q ? {{2{difference_3993[6]}}, difference_3993} : (less_3971_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_3997;
  assign select_3997 = and_488_s3_q ? (equal_2706_s3_q ? select_3995 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [6:0] select_3999;
  assign select_3999 = equal_549_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_4001;
  assign select_4001 = and_488_s3_q ? (equal_2706_s3_q ? select_3999 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4002;
  assign sum_4002 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4003;
  assign select_4003 = sum_3972[7] ? {1'b1, sum_3972[6:0], region_down_rest_q[0]} : sum_4002;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3972[7];
  // hls/stages/agreement.hpp:447
  logic select_4007;
  assign select_4007 = equal_2706_s3_q ? (equal_549_s3_q | (less_3971_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_4012;
  assign or_4012 = segment_starts_q | not_1970;
  // hls/stages/agreement.hpp:975
  logic select_4015;
  assign select_4015 = shift_2_s3_q[0] ? (sum_2304_s3_q ? (equal_2132_s3_q & or_2306) : or_2306) : or_4012;
  // hls/stages/patches.hpp:303
  logic select_4018;
  assign select_4018 = equal_1930_s3_q ? or_4012 : (so_s3_q ? (ends_cell_s3_q ? select_4015 : or_4012) : or_4012);
  logic [2:0] select_4092;
  assign select_4092 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_4094;
  assign select_4094 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4096;
  assign select_4096 = equal_1930_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4094 : box_textured_columns_values_1_q);
  logic [2:0] select_4097;
  assign select_4097 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4099;
  assign select_4099 = equal_1930_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4097 : box_textured_columns_values_2_q);
  logic [2:0] select_4100;
  assign select_4100 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4102;
  assign select_4102 = equal_1930_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4100 : box_textured_columns_values_3_q);
  logic [2:0] select_4103;
  assign select_4103 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4105;
  assign select_4105 = equal_1930_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4103 : box_textured_columns_values_4_q);
  logic [4:0] select_4107;
  assign select_4107 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4110;
  assign select_4110 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4112;
  assign select_4112 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4114;
  assign select_4114 = equal_1930_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4112 : box_explained_columns_values_1_q);
  logic [2:0] select_4115;
  assign select_4115 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4117;
  assign select_4117 = equal_1930_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4115 : box_explained_columns_values_2_q);
  logic [2:0] select_4118;
  assign select_4118 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4120;
  assign select_4120 = equal_1930_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4118 : box_explained_columns_values_3_q);
  logic [2:0] select_4121;
  assign select_4121 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4123;
  assign select_4123 = equal_1930_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4121 : box_explained_columns_values_4_q);
  logic [4:0] select_4125;
  assign select_4125 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4126;
  assign select_4126 = equal_1930_s3_q ? box_explained_sum_sums_values_0_q : select_4125;
  logic [2:0] select_4128;
  assign select_4128 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4130;
  assign select_4130 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4132;
  assign select_4132 = equal_1930_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4130 : box_shown_columns_values_1_q);
  logic [2:0] select_4133;
  assign select_4133 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4135;
  assign select_4135 = equal_1930_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4133 : box_shown_columns_values_2_q);
  logic [2:0] select_4136;
  assign select_4136 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4138;
  assign select_4138 = equal_1930_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4136 : box_shown_columns_values_3_q);
  logic [2:0] select_4139;
  assign select_4139 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4141;
  assign select_4141 = equal_1930_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4139 : box_shown_columns_values_4_q);
  logic [4:0] select_4143;
  assign select_4143 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4146;
  assign select_4146 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4148;
  assign select_4148 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4150;
  assign select_4150 = equal_1930_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4148 : box_nearer_columns_values_1_q);
  logic [2:0] select_4151;
  assign select_4151 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4153;
  assign select_4153 = equal_1930_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4151 : box_nearer_columns_values_2_q);
  logic [2:0] select_4154;
  assign select_4154 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4156;
  assign select_4156 = equal_1930_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4154 : box_nearer_columns_values_3_q);
  logic [2:0] select_4157;
  assign select_4157 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4159;
  assign select_4159 = equal_1930_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4157 : box_nearer_columns_values_4_q);
  logic [4:0] select_4161;
  assign select_4161 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_4164;
  assign select_4164 = so_s3_q ? (ends_cell_s3_q ? and_2371 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4167;
  assign select_4167 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_4169;
  assign select_4169 = equal_1930_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_4167 : centres_values_0_of_skin_q);
  logic select_4170;
  assign select_4170 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4172;
  assign select_4172 = equal_1930_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_4170 : centres_values_1_textured_q);
  logic select_4173;
  assign select_4173 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4175;
  assign select_4175 = equal_1930_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_4173 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:447
  logic [12:0] select_4179;
  assign select_4179 = equal_2706_s3_q ? (equal_4176_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_4182;
  assign select_4182 = and_488_s3_q ? (equal_2706_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1225
  logic [2:0] select_4193;
  assign select_4193 = select_2343 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_4199;
  assign select_4199 = marks_first_s3_q ? (less_4195 ? {sum_4196, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1233
  logic and_4205;
  assign and_4205 = and_2442_s3_q & ({sum_2368, index_2[5:0]} == {sum_2355, index[5:0]});
  // hls/stages/registration.hpp:255
  logic not_4258;
  assign not_4258 = ~quarter[1];
  logic [3:0] select_4259;
  assign select_4259 = quarter[0] ? {quarter[1], 1'b0, not_4258, 1'b0} : {1'b0, quarter[1], 1'b0, not_4258};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:273; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1982;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_2025;
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:665; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [23:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 24'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_2059;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_2061));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1317; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2301;
  logic regions_re;
  assign regions_re = s3_en & (equal_1930_s3_q ? (x_s3_q[6] & not_2302) : and_2309);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1328; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2355, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_2362 & less_2363);
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
  assign averager_memory_waddr = select_458_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_463_s3_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_482, and_478, sum_474, sum_470};
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
  assign census_memory_we = s3_en & and_488_s3_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_506, whole_2, select_498, select_494};
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
  assign shown_right_waddr = select_1969_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1974_s3_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_1971, not_1970};
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
  logic [4:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_2229, patches_code_row_s3_q[1:0]};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_2260_s3_q;
  logic [111:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {less_2249_s3_q, less_2248_s3_q, less_2239_s3_q, less_2238_s3_q, patches_codes_high_q, patches_codes_low_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {^patches_right_codes_wdata, patches_right_codes_wdata};
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
  assign patches_left_codes_waddr = {sum_2262, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_2272_s3_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {less_2249_s3_q, less_2248_s3_q, less_2239_s3_q, less_2238_s3_q, patches_codes_high_q[55:12]};
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
  assign seen_columns_we = s3_en & and_1965_s3_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2330, textured_s3_q};
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
      averager_running_of_skin_q <= select_2495;
      averager_mask_q <= select_2497;
      averager_of_skin_q <= select_2499;
      census_filled_q <= and_488_s3_q ? {select_552[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_488_s3_q ? select_551 : rows_passed_above_q;
      registration_slope_here_q <= select_2912;
      registration_of_right_q <= equal_1930_s3_q ? registration_of_right_q : select_2971;
      registration_was_inside_q <= equal_1930_s3_q ? registration_was_inside_q : select_2974;
      registration_fresh_q <= select_2983;
      patches_fixed_q <= not_3142 & (patches_fixed_q | (and_3152_s3_q & and_2095));
      patches_choice_valid_q <= and_2137_s3_q ? (select_2131[0] & not_3142) : select_2131[0];
      patches_choice_column_q <= select_2131[8:1];
      patches_choice_shift_q <= select_2131[14:9];
      patches_choice_slope_q <= select_2131[22:15];
      patches_band_q <= sample_pair_whole_s3_q ? select_2152 : patches_band_q;
      patches_fetch_q <= select_3170;
      patches_codes_low_q <= select_3269;
      patches_codes_high_q <= select_3273;
      patches_set_q <= select_3290;
      patches_size_q <= sum_3292;
      patches_left_row_q <= select_3304;
      patches_summed_first_q <= select_3652;
      patches_read_row_differing_q <= equal_2139_s3_q ? select_3664 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2139_s3_q ? select_3671 : patches_read_row_column_q;
      patches_read_at_q <= equal_2139_s3_q ? select_3678 : patches_read_at_q;
      patches_read_first_q <= select_3687;
      patches_read_above_q <= select_3710;
      patches_read_below_q <= select_3719;
      patches_read_far_q <= equal_2139_s3_q ? select_3729 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3732;
      patches_peak_best_column_q <= select_3733;
      patches_peak_row_q <= equal_2139_s3_q ? select_3700 : patches_peak_row_q;
      patches_peak_above_q <= equal_2139_s3_q ? select_3735 : patches_peak_above_q;
      patches_peak_below_q <= equal_2139_s3_q ? select_3737 : patches_peak_below_q;
      patches_peak_far_q <= equal_2139_s3_q ? select_3741 : patches_peak_far_q;
      shown_shown_q <= select_3968;
      shown_nearer_q <= select_3970;
      region_row_q <= and_488_s3_q ? select_3976 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3981;
      region_down_rest_q <= select_3997;
      region_down_back_q <= select_4001;
      region_down_next_q <= select_4003;
      region_fresh_q <= and_488_s3_q ? select_4007 : region_fresh_q;
      segment_starts_q <= select_4018;
      centres_values_0_textured_q <= equal_1930_s3_q ? centres_values_0_textured_q : select_4164;
      centres_values_0_of_skin_q <= select_4169;
      centres_values_1_textured_q <= select_4172;
      centres_values_1_of_skin_q <= select_4175;
      map_row_q <= and_488_s3_q ? select_4179 : map_row_q;
      map_width_q <= select_4182;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2354;
      done_q <= not_2356 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      drew_q <= so_s3_q;
      said_q <= equal_1930_s3_q & equal_3952;
      rows_passed_q <= select_2339;
      columns_passed_q <= {select_2341[7:0], or_2337};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_2358;
      seen_x_q <= select_2360;
      seen_y_q <= marks_first_s3_q ? 3'h0 : select_4193;
      seen_column_q <= select_2351;
      seen_rows_left_q <= select_4199;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2348;
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
      averager_running_0_q <= sample_pair_whole_s3_q ? select_466 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_472 : averager_running_1_q;
      averager_total_0_q <= select_2474;
      averager_total_1_q <= select_2476;
      census_columns_values_0_cell_0_left_q <= select_2500;
      census_columns_values_0_cell_0_right_q <= select_2501;
      census_columns_values_0_cell_0_mask_q <= and_488_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2503;
      census_columns_values_0_cell_1_right_q <= select_2504;
      census_columns_values_0_cell_1_mask_q <= select_2505;
      census_columns_values_0_cell_2_left_q <= select_2506;
      census_columns_values_0_cell_2_right_q <= select_2507;
      census_columns_values_0_cell_2_mask_q <= select_2508;
      census_columns_values_0_cell_2_of_skin_q <= select_2509;
      census_columns_values_0_cell_3_left_q <= select_2510;
      census_columns_values_0_cell_3_right_q <= select_2511;
      census_columns_values_0_cell_3_mask_q <= select_2512;
      census_columns_values_0_cell_4_left_q <= select_2513;
      census_columns_values_0_cell_4_right_q <= select_2514;
      census_columns_values_0_cell_4_mask_q <= select_2515;
      census_columns_values_1_cell_0_left_q <= select_2516;
      census_columns_values_1_cell_0_right_q <= select_2517;
      census_columns_values_1_cell_0_mask_q <= select_2518;
      census_columns_values_1_cell_1_left_q <= select_2519;
      census_columns_values_1_cell_1_right_q <= select_2520;
      census_columns_values_1_cell_1_mask_q <= select_2521;
      census_columns_values_1_cell_2_left_q <= select_2522;
      census_columns_values_1_cell_2_right_q <= select_2523;
      census_columns_values_1_cell_2_mask_q <= select_2524;
      census_columns_values_1_cell_2_of_skin_q <= select_2525;
      census_columns_values_1_cell_3_left_q <= select_2526;
      census_columns_values_1_cell_3_right_q <= select_2527;
      census_columns_values_1_cell_3_mask_q <= select_2528;
      census_columns_values_1_cell_4_left_q <= select_2529;
      census_columns_values_1_cell_4_right_q <= select_2530;
      census_columns_values_1_cell_4_mask_q <= select_2531;
      census_columns_values_2_cell_0_left_q <= select_2532;
      census_columns_values_2_cell_0_right_q <= select_2533;
      census_columns_values_2_cell_0_mask_q <= select_2534;
      census_columns_values_2_cell_1_left_q <= select_2535;
      census_columns_values_2_cell_1_right_q <= select_2536;
      census_columns_values_2_cell_1_mask_q <= select_2537;
      census_columns_values_2_cell_2_left_q <= select_2538;
      census_columns_values_2_cell_2_right_q <= select_2539;
      census_columns_values_2_cell_2_mask_q <= select_2540;
      census_columns_values_2_cell_3_left_q <= select_2541;
      census_columns_values_2_cell_3_right_q <= select_2542;
      census_columns_values_2_cell_3_mask_q <= select_2543;
      census_columns_values_2_cell_4_left_q <= select_2544;
      census_columns_values_2_cell_4_right_q <= select_2545;
      census_columns_values_2_cell_4_mask_q <= select_2546;
      census_columns_values_3_cell_0_mask_q <= select_2547;
      census_columns_values_3_cell_1_left_q <= select_2548;
      census_columns_values_3_cell_1_right_q <= select_2549;
      census_columns_values_3_cell_1_mask_q <= select_2550;
      census_columns_values_3_cell_2_mask_q <= select_2551;
      census_columns_values_3_cell_3_left_q <= select_2552;
      census_columns_values_3_cell_3_right_q <= select_2553;
      census_columns_values_3_cell_3_mask_q <= select_2554;
      census_columns_values_3_cell_4_mask_q <= select_2555;
      sharpness_last_mean_0_q <= and_488_s3_q ? select_494 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_488_s3_q ? select_498 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1930_s3_q ? box_textured_columns_values_0_q : select_4092;
      box_textured_columns_values_1_q <= select_4096;
      box_textured_columns_values_2_q <= select_4099;
      box_textured_columns_values_3_q <= select_4102;
      box_textured_columns_values_4_q <= select_4105;
      box_textured_sum_sums_values_0_q <= equal_1930_s3_q ? box_textured_sum_sums_values_0_q : select_4107;
      box_explained_columns_values_0_q <= equal_1930_s3_q ? box_explained_columns_values_0_q : select_4110;
      box_explained_columns_values_1_q <= select_4114;
      box_explained_columns_values_2_q <= select_4117;
      box_explained_columns_values_3_q <= select_4120;
      box_explained_columns_values_4_q <= select_4123;
      box_explained_sum_sums_values_0_q <= select_4126;
      box_shown_columns_values_0_q <= equal_1930_s3_q ? box_shown_columns_values_0_q : select_4128;
      box_shown_columns_values_1_q <= select_4132;
      box_shown_columns_values_2_q <= select_4135;
      box_shown_columns_values_3_q <= select_4138;
      box_shown_columns_values_4_q <= select_4141;
      box_shown_sum_sums_values_0_q <= equal_1930_s3_q ? box_shown_sum_sums_values_0_q : select_4143;
      box_nearer_columns_values_0_q <= equal_1930_s3_q ? box_nearer_columns_values_0_q : select_4146;
      box_nearer_columns_values_1_q <= select_4150;
      box_nearer_columns_values_2_q <= select_4153;
      box_nearer_columns_values_3_q <= select_4156;
      box_nearer_columns_values_4_q <= select_4159;
      box_nearer_sum_sums_values_0_q <= equal_1930_s3_q ? box_nearer_sum_sums_values_0_q : select_4161;
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
  logic [2:0] select_452_s4_q;
  logic [6:0] select_454_s4_q;
  logic [6:0] column_s4_q;
  logic and_486_s4_q;
  logic and_488_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_491_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
  logic less_522_s4_q;
  logic less_523_s4_q;
  logic less_524_s4_q;
  logic less_525_s4_q;
  logic less_526_s4_q;
  logic less_527_s4_q;
  logic less_528_s4_q;
  logic less_529_s4_q;
  logic less_530_s4_q;
  logic less_531_s4_q;
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
  logic and_553_s4_q;
  logic and_578_s4_q;
  logic and_579_s4_q;
  logic [11:0] sum_594_s4_q;
  logic [9:0] sum_597_s4_q;
  logic equal_1930_s4_q;
  logic not_1931_s4_q;
  logic equal_1975_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1981_s4_q;
  logic equal_1983_s4_q;
  logic equal_1985_s4_q;
  logic equal_1987_s4_q;
  logic equal_1989_s4_q;
  logic equal_1991_s4_q;
  logic equal_1993_s4_q;
  logic equal_1995_s4_q;
  logic equal_1997_s4_q;
  logic less_2006_s4_q;
  logic or_2010_s4_q;
  logic equal_2030_s4_q;
  logic and_2040_s4_q;
  logic and_2043_s4_q;
  logic select_2060_s4_q;
  logic equal_2061_s4_q;
  logic and_2069_s4_q;
  logic and_2071_s4_q;
  logic equal_2104_s4_q;
  logic select_2131_s4_q;
  logic and_2138_s4_q;
  logic equal_2139_s4_q;
  logic equal_2141_s4_q;
  logic and_2154_s4_q;
  logic [4:0] select_2166_s4_q;
  logic select_2172_s4_q;
  logic [3:0] select_2208_s4_q;
  logic less_2273_s4_q;
  logic equal_2274_s4_q;
  logic not_2275_s4_q;
  logic equal_2276_s4_q;
  logic or_2294_s4_q;
  logic or_2297_s4_q;
  logic or_2300_s4_q;
  logic not_2302_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_2323_s4_q;
  logic and_2328_s4_q;
  logic and_2362_s4_q;
  logic less_2363_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_2368_s4_q;
  logic equal_2381_s4_q;
  logic or_2386_s4_q;
  logic or_2389_s4_q;
  logic or_2392_s4_q;
  logic not_2417_s4_q;
  logic less_2431_s4_q;
  logic and_2442_s4_q;
  logic [11:0] sum_2571_s4_q;
  logic [9:0] sum_2574_s4_q;
  logic equal_2582_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2803_s4_q;
  logic and_2807_s4_q;
  logic not_2841_s4_q;
  logic and_2869_s4_q;
  logic and_2916_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2950_s4_q;
  logic and_2964_s4_q;
  logic equal_3007_s4_q;
  logic parity_3376_s4_q;
  logic parity_3505_s4_q;
  logic parity_3567_s4_q;
  logic xor_3595_s4_q;
  logic parity_3607_s4_q;
  logic or_3611_s4_q;
  logic equal_3612_s4_q;
  logic [4:0] select_3731_s4_q;
  logic equal_3743_s4_q;
  logic less_3745_s4_q;
  logic less_3746_s4_q;
  logic or_3751_s4_q;
  logic [7:0] select_3796_s4_q;
  logic equal_3952_s4_q;
  logic and_4205_s4_q;
  logic and_4220_s4_q;
  logic equal_4261_s4_q;
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
      patches_summed_row_column_s4_q <= patches_summed_row_column_s3_q;
      patches_summed_first_s4_q <= patches_summed_first_q;
      patches_summed_last_s4_q <= patches_summed_last_s3_q;
      patches_summed_down_by_s4_q <= patches_summed_down_by_s3_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      select_452_s4_q <= select_452_s3_q;
      select_454_s4_q <= select_454_s3_q;
      column_s4_q <= column_s3_q;
      and_486_s4_q <= and_486_s3_q;
      and_488_s4_q <= and_488_s3_q;
      grey_s4_q <= grey;
      equal_491_s4_q <= equal_491;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
      less_522_s4_q <= less_522;
      less_523_s4_q <= less_523;
      less_524_s4_q <= less_524;
      less_525_s4_q <= less_525;
      less_526_s4_q <= less_526;
      less_527_s4_q <= less_527;
      less_528_s4_q <= less_528;
      less_529_s4_q <= less_529;
      less_530_s4_q <= less_530;
      less_531_s4_q <= less_531;
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
      and_553_s4_q <= and_553;
      and_578_s4_q <= whole_22 & and_553;
      and_579_s4_q <= census_columns_values_1_cell_2_mask_q & and_553;
      sum_594_s4_q <= {1'b0, sum_590} + {2'h0, sum_593};
      sum_597_s4_q <= {9'h0, difference_595[9]} + {1'b0, xor_596};
      equal_1930_s4_q <= equal_1930_s3_q;
      not_1931_s4_q <= not_1931_s3_q;
      equal_1975_s4_q <= equal_1975;
      all_s4_q <= all;
      sum_1981_s4_q <= sum_1981;
      equal_1983_s4_q <= equal_1983;
      equal_1985_s4_q <= equal_1985;
      equal_1987_s4_q <= equal_1987;
      equal_1989_s4_q <= equal_1989;
      equal_1991_s4_q <= equal_1991;
      equal_1993_s4_q <= equal_1993;
      equal_1995_s4_q <= equal_1995;
      equal_1997_s4_q <= equal_1997;
      less_2006_s4_q <= less_2006;
      or_2010_s4_q <= or_2010;
      equal_2030_s4_q <= (registration_fresh_q & select_2028) == 4'h0;
      and_2040_s4_q <= not_1931_s3_q & and_2024;
      and_2043_s4_q <= and_2043_s3_q;
      select_2060_s4_q <= select_2060[1];
      equal_2061_s4_q <= equal_2061;
      and_2069_s4_q <= and_2069_s3_q;
      and_2071_s4_q <= and_2071_s3_q;
      equal_2104_s4_q <= equal_2104;
      select_2131_s4_q <= select_2131[0];
      and_2138_s4_q <= and_2138_s3_q;
      equal_2139_s4_q <= equal_2139_s3_q;
      equal_2141_s4_q <= equal_2141_s3_q;
      and_2154_s4_q <= and_2138_s3_q & equal_2153;
      select_2166_s4_q <= select_2166_s3_q;
      select_2172_s4_q <= select_2172_s3_q;
      select_2208_s4_q <= select_2208_s3_q;
      less_2273_s4_q <= less_2273_s3_q;
      equal_2274_s4_q <= equal_2274_s3_q;
      not_2275_s4_q <= not_2275_s3_q;
      equal_2276_s4_q <= equal_2276_s3_q;
      or_2294_s4_q <= or_2294;
      or_2297_s4_q <= or_2297;
      or_2300_s4_q <= or_2300;
      not_2302_s4_q <= not_2302;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_2323_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_2328_s4_q <= not_1931_s3_q & and_2309;
      and_2362_s4_q <= and_2362;
      less_2363_s4_q <= less_2363;
      index_2_s4_q <= index_2[5:0];
      sum_2368_s4_q <= sum_2368;
      equal_2381_s4_q <= t[4:1] == 4'h0;
      or_2386_s4_q <= or_2386;
      or_2389_s4_q <= select_2383[7] | (~({select_2383[6], select_2383[3:2]} == 3'h0));
      or_2392_s4_q <= select_2383[7] | (~(select_2383[6:4] == 3'h0));
      not_2417_s4_q <= ~({sum_2415, around[0]} < {2'h0, t});
      less_2431_s4_q <= {1'b0, around[4:1]} < n;
      and_2442_s4_q <= and_2442_s3_q;
      sum_2571_s4_q <= {1'b0, sum_2567} + {2'h0, sum_2570};
      sum_2574_s4_q <= {9'h0, difference_2572[9]} + {1'b0, xor_2573};
      equal_2582_s4_q <= equal_2582_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2803_s4_q <= and_2803;
      and_2807_s4_q <= and_2807;
      not_2841_s4_q <= ~({sum_2839, e[0]} < {2'h0, t});
      and_2869_s4_q <= not_1931_s3_q & and_2868;
      and_2916_s4_q <= not_1931_s3_q & (so_s3_q & (half_ends & equal_2913));
      residual_s4_q <= residual[7:0];
      and_2950_s4_q <= and_2950;
      and_2964_s4_q <= and_2071_s3_q & less_2963;
      equal_3007_s4_q <= (registration_fresh_q & select_3005) == 4'h0;
      parity_3376_s4_q <= ^{xor_3372, xor_3335, select_3302[44:36], other[44:36]};
      parity_3505_s4_q <= parity_3505;
      parity_3567_s4_q <= parity_3567;
      xor_3595_s4_q <= parity_3582 ^ parity_3594;
      parity_3607_s4_q <= ^{or_3604, or_3600, and_3596};
      or_3611_s4_q <= (or_3600 & or_3604) | (and_3596 & (or_3600 | or_3604));
      equal_3612_s4_q <= equal_3612_s3_q;
      select_3731_s4_q <= select_3731[14:10];
      equal_3743_s4_q <= select_3700[3:0] == 4'h0;
      less_3745_s4_q <= {difference_3744, 2'h0} < {2'h0, sum_3292};
      less_3746_s4_q <= select_3741 < select_3731[9:0];
      or_3751_s4_q <= (sum_3292 < 10'h39) | ({1'b0, sum_3292[9:1]} < select_3731[9:0]);
      select_3796_s4_q <= select_3796;
      equal_3952_s4_q <= equal_3952;
      and_4205_s4_q <= and_4205;
      and_4220_s4_q <= equal_1930_s3_q & (equal_3952 & (cfg_prove_i & (~proven_q)));
      equal_4261_s4_q <= (registration_fresh_q & select_4259) == 4'h0;
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
  logic [7:0] patches_place_0_column_q;
  logic [5:0] patches_place_0_shift_q;
  logic [7:0] patches_place_0_slope_q;
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
  logic patches_complete_q;
  logic patches_round_ends_q;
  logic [4:0] patches_found_q;
  logic [7:0] patches_round_places_q;
  logic [11:0] patches_round_across_q;
  logic [4:0] patches_round_moved_q;
  logic patches_moved_q;
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
  assign texture = sum_594_s4_q + {2'h0, sum_597_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_599;
  assign sum_599 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_601;
  assign sum_601 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_599});
  // hls/stages/census.hpp:303
  logic less_602;
  assign less_602 = 9'h4 < sum_601[13:5];
  logic and_603;
  assign and_603 = and_553_s4_q & less_602;
  // hls/stages/registration.hpp:262
  logic equal_2032;
  assign equal_2032 = sum_1981_s4_q == 2'h0;
  // hls/stages/registration.hpp:260
  logic [6:0] down;
  assign down = sum_1981_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:262
  logic [13:0] select_2034;
  assign select_2034 = equal_2032 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2035;
  assign sum_2035 = (equal_2030_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2034[13]}}, select_2034};
  // hls/stages/registration.hpp:261
  logic [6:0] up;
  assign up = sum_1981_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:263
  logic [6:0] select_2038;
  assign select_2038 = equal_2032 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2039;
  assign sum_2039 = (equal_2030_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2038[6]}}, select_2038};
  // hls/stages/patches.hpp:100
  logic [22:0] select_2155;
  assign select_2155 = and_2154_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2131_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:101
  logic [21:0] select_2156;
  assign select_2156 = select_2060_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2155[22:1];
  // hls/stages/patches.hpp:105
  logic [7:0] select_2157;
  assign select_2157 = equal_2061_s4_q ? patches_place_0_column_q : select_2156[7:0];
  logic [5:0] select_2158;
  assign select_2158 = equal_2061_s4_q ? patches_place_0_shift_q : select_2156[13:8];
  // hls/stages/patches.hpp:287
  logic [7:0] sum_2159;
  assign sum_2159 = select_2157 + {{2{select_2158[5]}}, select_2158};
  // hls/stages/patches.hpp:288
  logic [6:0] sum_2160;
  assign sum_2160 = sum_2159[7:1] + 7'h7f;
  // hls/stages/patches.hpp:109
  logic equal_2161;
  assign equal_2161 = {sum_2160[6], select_454_s4_q, select_452_s4_q} == {1'b0, sum_2160[5:0], sum_2159[0], 3'h4};
  // hls/stages/patches.hpp:110
  logic or_2162;
  assign or_2162 = and_2043_s4_q | equal_2161;
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2163;
  assign select_2163 = or_2162 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:110
  logic [5:0] select_2173;
  assign select_2173 = or_2162 ? {and_2043_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:114
  logic and_2175;
  assign and_2175 = select_2172_s4_q & (~select_2173[5]);
  // hls/stages/patches.hpp:101
  logic [21:0] select_2182;
  assign select_2182 = select_2060_s4_q ? select_2155[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:105
  logic [7:0] select_2183;
  assign select_2183 = equal_2061_s4_q ? patches_place_1_column_q : select_2182[7:0];
  logic [5:0] select_2184;
  assign select_2184 = equal_2061_s4_q ? patches_place_1_shift_q : select_2182[13:8];
  // hls/stages/patches.hpp:287
  logic [7:0] sum_2185;
  assign sum_2185 = select_2183 + {{2{select_2184[5]}}, select_2184};
  // hls/stages/patches.hpp:288
  logic [6:0] sum_2186;
  assign sum_2186 = sum_2185[7:1] + 7'h7f;
  // hls/stages/patches.hpp:109
  logic equal_2187;
  assign equal_2187 = {sum_2186[6], select_454_s4_q, select_452_s4_q} == {1'b0, sum_2186[5:0], sum_2185[0], 3'h4};
  // hls/stages/patches.hpp:110
  logic or_2188;
  assign or_2188 = and_2043_s4_q | equal_2187;
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2189;
  assign select_2189 = or_2188 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:110
  logic [5:0] select_2190;
  assign select_2190 = or_2188 ? {and_2043_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:114
  logic and_2192;
  assign and_2192 = select_2172_s4_q & (~select_2190[5]);
  // hls/stages/patches.hpp:284
  logic [7:0] sum_2199;
  assign sum_2199 = select_2157 + 8'hff;
  // hls/stages/patches.hpp:109
  logic equal_2200;
  assign equal_2200 = {sum_2199[7], select_454_s4_q, select_452_s4_q} == {1'b0, sum_2199[6:0], 3'h4};
  // hls/stages/patches.hpp:111
  logic or_2201;
  assign or_2201 = and_2043_s4_q | equal_2200;
  logic [4:0] select_2202;
  assign select_2202 = or_2201 ? {and_2043_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:284
  logic [7:0] sum_2203;
  assign sum_2203 = select_2183 + 8'hff;
  // hls/stages/patches.hpp:109
  logic equal_2204;
  assign equal_2204 = {sum_2203[7], select_454_s4_q, select_452_s4_q} == {1'b0, sum_2203[6:0], 3'h4};
  // hls/stages/patches.hpp:111
  logic [4:0] select_2206;
  assign select_2206 = (and_2043_s4_q | equal_2204) ? {and_2043_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:119
  logic [3:0] column_7;
  assign column_7 = select_2202[4] ? select_2206[3:0] : select_2202[3:0];
  // hls/stages/agreement.hpp:263
  logic select_2209;
  assign select_2209 = or_2201 ? and_2043_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:119
  logic and_2215;
  assign and_2215 = (select_2172_s4_q & (select_2166_s4_q[3] ^ select_2166_s4_q[4])) & ((~select_2202[4]) | (~select_2206[4]));
  // hls/stages/patches.hpp:160
  logic less_2285;
  assign less_2285 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:161
  logic not_2286;
  assign not_2286 = ~less_2285;
  logic [1:0] select_2287;
  assign select_2287 = patches_summed_first_s4_q ? 2'h2 : {less_2285, not_2286};
  logic [12:0] select_2288;
  assign select_2288 = select_2287[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2289;
  assign select_2289 = select_2287[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2290;
  assign select_2290 = select_2287[1] ? {select_2288[12:8], patches_sums_values_0_q[9:8], select_2288[7:0]} : select_2289;
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2313;
  assign select_2313 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_2314;
  assign sum_2314 = {6'h0, textured_s4_q} + select_2313;
  // hls/stages/agreement.hpp:1002
  logic [9:0] sum_2316;
  assign sum_2316 = {3'h0, sum_2314} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2318;
  assign select_2318 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_2319;
  assign sum_2319 = {6'h0, explained_s4_q} + select_2318;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_2321;
  assign sum_2321 = {3'h0, sum_2319} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2324;
  assign select_2324 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:868
  logic [6:0] sum_2325;
  assign sum_2325 = {6'h0, and_2323_s4_q} + select_2324;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_2327;
  assign sum_2327 = {3'h0, sum_2325} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1042
  logic not_2393;
  assign not_2393 = ~region_row_s4_q[2];
  logic [2:0] select_2394;
  assign select_2394 = region_row_s4_q[1] ? {1'b0, not_2393, 1'b0} : {region_row_s4_q[2], 1'b0, not_2393};
  logic [5:0] select_2395;
  assign select_2395 = region_row_s4_q[0] ? {select_2394[2], 1'b0, select_2394[1], 1'b0, select_2394[0], 1'b0} : {1'b0, select_2394[2], 1'b0, select_2394[1], 1'b0, select_2394[0]};
  logic [11:0] select_2396;
  assign select_2396 = or_2392_s4_q ? {select_2395[5], 1'b0, select_2395[4], 1'b0, select_2395[3], 1'b0, select_2395[2], 1'b0, select_2395[1], 1'b0, select_2395[0], 1'b0} : {1'b0, select_2395[5], 1'b0, select_2395[4], 1'b0, select_2395[3], 1'b0, select_2395[2], 1'b0, select_2395[1], 1'b0, select_2395[0]};
  logic [23:0] select_2397;
  assign select_2397 = or_2389_s4_q ? {select_2396[11], 1'b0, select_2396[10], 1'b0, select_2396[9], 1'b0, select_2396[8], 1'b0, select_2396[7], 1'b0, select_2396[6], 1'b0, select_2396[5], 1'b0, select_2396[4], 1'b0, select_2396[3], 1'b0, select_2396[2], 1'b0, select_2396[1], 1'b0, select_2396[0], 1'b0} : {1'b0, select_2396[11], 1'b0, select_2396[10], 1'b0, select_2396[9], 1'b0, select_2396[8], 1'b0, select_2396[7], 1'b0, select_2396[6], 1'b0, select_2396[5], 1'b0, select_2396[4], 1'b0, select_2396[3], 1'b0, select_2396[2], 1'b0, select_2396[1], 1'b0, select_2396[0]};
  logic [47:0] select_2398;
  assign select_2398 = or_2386_s4_q ? {select_2397[23], 1'b0, select_2397[22], 1'b0, select_2397[21], 1'b0, select_2397[20], 1'b0, select_2397[19], 1'b0, select_2397[18], 1'b0, select_2397[17], 1'b0, select_2397[16], 1'b0, select_2397[15], 1'b0, select_2397[14], 1'b0, select_2397[13], 1'b0, select_2397[12], 1'b0, select_2397[11], 1'b0, select_2397[10], 1'b0, select_2397[9], 1'b0, select_2397[8], 1'b0, select_2397[7], 1'b0, select_2397[6], 1'b0, select_2397[5], 1'b0, select_2397[4], 1'b0, select_2397[3], 1'b0, select_2397[2], 1'b0, select_2397[1], 1'b0, select_2397[0], 1'b0} : {1'b0, select_2397[23], 1'b0, select_2397[22], 1'b0, select_2397[21], 1'b0, select_2397[20], 1'b0, select_2397[19], 1'b0, select_2397[18], 1'b0, select_2397[17], 1'b0, select_2397[16], 1'b0, select_2397[15], 1'b0, select_2397[14], 1'b0, select_2397[13], 1'b0, select_2397[12], 1'b0, select_2397[11], 1'b0, select_2397[10], 1'b0, select_2397[9], 1'b0, select_2397[8], 1'b0, select_2397[7], 1'b0, select_2397[6], 1'b0, select_2397[5], 1'b0, select_2397[4], 1'b0, select_2397[3], 1'b0, select_2397[2], 1'b0, select_2397[1], 1'b0, select_2397[0]};
  // hls/stages/agreement.hpp:975
  logic and_2402;
  assign and_2402 = good_known_q & (~((good_q & select_2398) == 48'h0));
  // hls/stages/agreement.hpp:1044
  logic is_seen;
  assign is_seen = equal_2381_s4_q ? and_2402 : not_2417_s4_q;
  // hls/stages/agreement.hpp:1053
  logic and_2432;
  assign and_2432 = is_seen & less_2431_s4_q;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2466;
  assign select_2466 = sample_pair_whole_s4_q ? (and_486_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2468;
  assign select_2468 = sample_pair_whole_s4_q ? (and_486_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2470;
  assign select_2470 = sample_pair_whole_s4_q ? (and_486_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2472;
  assign select_2472 = sample_pair_whole_s4_q ? (and_486_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2477;
  assign sum_2477 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2478;
  assign difference_2478 = {1'b0, sum_2477[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2479;
  assign xor_2479 = {difference_2478[8:0], sum_2477[0]} ^ {10{difference_2478[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2478[9]} + {1'b0, xor_2479};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_491_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2484;
  assign select_2484 = sample_pair_whole_s4_q ? (and_486_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2485;
  assign sum_2485 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2486;
  assign difference_2486 = {1'b0, sum_2485[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2487;
  assign xor_2487 = {difference_2486[8:0], sum_2485[0]} ^ {10{difference_2486[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2486[9]} + {1'b0, xor_2487};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_491_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2492;
  assign select_2492 = sample_pair_whole_s4_q ? (and_486_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2575;
  assign sum_2575 = sum_2571_s4_q + {2'h0, sum_2574_s4_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2577;
  assign select_2577 = and_488_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2578;
  assign select_2578 = and_488_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2579;
  assign select_2579 = and_488_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2580;
  assign select_2580 = and_488_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2583;
  assign sum_2583 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2575};
  logic [13:0] sum_2585;
  assign sum_2585 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2583});
  // hls/stages/census.hpp:305
  logic and_2587;
  assign and_2587 = and_578_s4_q & (9'h4 < sum_2585[13:5]);
  // hls/stages/census.hpp:306
  logic and_2588;
  assign and_2588 = and_578_s4_q & less_602;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2589;
  assign sum_2589 = census_left_misses_q + {{17{and_2588}}, and_2587, 1'b0, and_2587};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2591;
  assign select_2591 = and_488_s4_q ? (equal_2582_s4_q ? 20'h0 : sum_2589) : census_left_misses_q;
  // hls/stages/agreement.hpp:263
  logic [27:0] select_2596;
  assign select_2596 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:507
  logic select_2599;
  assign select_2599 = and_488_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2602;
  assign and_2602 = whole_2_s4_q & (~(column_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:444
  logic and_2608;
  assign and_2608 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2609;
  assign and_2609 = and_2602 & and_2608;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2596[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2611;
  assign select_2611 = and_2609 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2613;
  assign select_2613 = equal_2582_s4_q ? {11'h0, select_2611} : (sharpness_sums_detail_0_q + {11'h0, select_2611});
  // hls/stages/agreement.hpp:444
  logic and_2620;
  assign and_2620 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2621;
  assign and_2621 = and_2602 & and_2620;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2596[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2623;
  assign select_2623 = and_2621 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2625;
  assign select_2625 = equal_2582_s4_q ? {11'h0, select_2623} : (sharpness_sums_detail_1_q + {11'h0, select_2623});
  logic [8:0] select_2628;
  assign select_2628 = and_2609 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2629;
  assign sum_2629 = (equal_2582_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2628};
  logic [8:0] select_2632;
  assign select_2632 = and_2621 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2633;
  assign sum_2633 = (equal_2582_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2632};
  // hls/stages/agreement.hpp:203
  logic equal_2635;
  assign equal_2635 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2636;
  assign less_2636 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2637;
  assign less_2637 = x_s4_q[4:0] < 5'h3;
  logic not_2638;
  assign not_2638 = ~x_s4_q[1];
  logic [2:0] select_2639;
  assign select_2639 = x_s4_q[0] ? {1'b0, not_2638, 1'b0} : {x_s4_q[1], 1'b0, not_2638};
  logic [5:0] select_2640;
  assign select_2640 = slot_s4_q[2] ? {select_2639[2], 1'b0, select_2639[1], 1'b0, select_2639[0], 1'b0} : {1'b0, select_2639[2], 1'b0, select_2639[1], 1'b0, select_2639[0]};
  logic [11:0] select_2641;
  assign select_2641 = slot_s4_q[1] ? {select_2640[5], 1'b0, select_2640[4], 1'b0, select_2640[3], 1'b0, select_2640[2], 1'b0, select_2640[1], 1'b0, select_2640[0], 1'b0} : {1'b0, select_2640[5], 1'b0, select_2640[4], 1'b0, select_2640[3], 1'b0, select_2640[2], 1'b0, select_2640[1], 1'b0, select_2640[0]};
  logic [23:0] select_2642;
  assign select_2642 = slot_s4_q[0] ? {select_2641[11], 1'b0, select_2641[10], 1'b0, select_2641[9], 1'b0, select_2641[8], 1'b0, select_2641[7], 1'b0, select_2641[6], 1'b0, select_2641[5], 1'b0, select_2641[4], 1'b0, select_2641[3], 1'b0, select_2641[2], 1'b0, select_2641[1], 1'b0, select_2641[0], 1'b0} : {1'b0, select_2641[11], 1'b0, select_2641[10], 1'b0, select_2641[9], 1'b0, select_2641[8], 1'b0, select_2641[7], 1'b0, select_2641[6], 1'b0, select_2641[5], 1'b0, select_2641[4], 1'b0, select_2641[3], 1'b0, select_2641[2], 1'b0, select_2641[1], 1'b0, select_2641[0]};
  // hls/stages/census.hpp:372
  logic and_2646;
  assign and_2646 = less_2637 & (~((sharpness_sums_contrast_1_q & select_2642) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2648;
  assign select_2648 = (less_2636 & and_2646) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2648};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2651;
  assign select_2651 = equal_2635 ? (less_2636 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2656;
  assign and_2656 = less_2637 & (~((sharpness_sums_contrast_0_q & select_2642) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2658;
  assign select_2658 = (less_2636 & and_2656) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2658};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2661;
  assign select_2661 = equal_2635 ? (less_2636 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2663;
  assign select_2663 = equal_2635 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2665;
  assign select_2665 = equal_2635 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2667;
  assign select_2667 = equal_2635 ? {sharpness_comparing_contrast_0_q[0], and_2656} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2669;
  assign select_2669 = equal_2635 ? {sharpness_comparing_contrast_1_q[0], and_2646} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:207
  logic select_2674;
  assign select_2674 = drew_q ? (equal_2635 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:207
  logic select_2678;
  assign select_2678 = drew_q ? (equal_2635 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2679;
  assign equal_2679 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2680;
  assign xor_2680 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2683;
  assign select_2683 = (equal_2679 | xor_2680) ? (five_times[0] & xor_2680) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2685;
  assign select_2685 = drew_q ? (equal_2635 ? select_2683 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2686;
  assign xor_2686 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2689;
  assign select_2689 = (equal_2679 | xor_2686) ? (five_times_2[0] & xor_2686) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2691;
  assign select_2691 = drew_q ? (equal_2635 ? select_2689 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2692;
  assign xor_2692 = sharpness_comparing_contrast_0_q[1] ^ and_2646;
  logic select_2695;
  assign select_2695 = (equal_2679 | xor_2692) ? (and_2646 & xor_2692) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2697;
  assign select_2697 = drew_q ? (equal_2635 ? select_2695 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2698;
  assign xor_2698 = sharpness_comparing_contrast_1_q[1] ^ and_2656;
  logic select_2701;
  assign select_2701 = (equal_2679 | xor_2698) ? (and_2656 & xor_2698) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2703;
  assign select_2703 = drew_q ? (equal_2635 ? select_2701 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2809;
  assign select_2809 = and_2803_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2807_s4_q});
  // hls/stages/patches.hpp:303
  logic and_2812;
  assign and_2812 = not_1931_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2817;
  assign and_2817 = not_1931_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2822;
  assign and_2822 = not_1931_s4_q & (drew_q & (ends_cell_s4_q & and_2323_s4_q));
  // hls/stages/agreement.hpp:1046
  logic not_2826;
  assign not_2826 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1047
  logic not_2843;
  assign not_2843 = ~(equal_2381_s4_q ? and_2402 : not_2841_s4_q);
  // hls/stages/patches.hpp:303
  logic and_2846;
  assign and_2846 = ends_cell_s4_q & (not_2826 & (centres_values_1_textured_s4_q & not_2843));
  logic and_2848;
  assign and_2848 = not_1931_s4_q & (drew_q & and_2846);
  // hls/stages/agreement.hpp:1073
  logic less_2851;
  assign less_2851 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2852;
  assign select_2852 = less_2851 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2855;
  assign select_2855 = less_2851 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1074
  logic [10:0] sum_2856;
  assign sum_2856 = {1'b0, select_2855} + {3'h0, select_2855[9:2]};
  logic and_2858;
  assign and_2858 = (~(select_2852[9:4] == 6'h0)) & ({sum_2856, select_2855[1:0]} < {3'h0, select_2852});
  // hls/stages/agreement.hpp:1083
  logic [9:0] select_2861;
  assign select_2861 = x_s4_q[6] ? (equal_1975_s4_q ? 10'h0 : (and_2858 ? select_2852 : 10'h0)) : 10'h0;
  // hls/stages/patches.hpp:303
  logic [9:0] select_2862;
  assign select_2862 = equal_1930_s4_q ? select_2861 : 10'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2864;
  assign select_2864 = and_2803_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2862});
  logic [13:0] select_2871;
  assign select_2871 = and_2803_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2869_s4_q});
  // hls/stages/agreement.hpp:1051
  logic and_2873;
  assign and_2873 = not_2826 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/patches.hpp:303
  logic and_2876;
  assign and_2876 = not_1931_s4_q & (drew_q & (ends_cell_s4_q & and_2873));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2878;
  assign select_2878 = and_2803_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2876});
  // hls/stages/agreement.hpp:1051
  logic and_2880;
  assign and_2880 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2843);
  // hls/stages/patches.hpp:303
  logic and_2884;
  assign and_2884 = not_1931_s4_q & (drew_q & (ends_cell_s4_q & (not_2826 & and_2880)));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2886;
  assign select_2886 = and_2803_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2884});
  // hls/stages/patches.hpp:303
  logic [7:0] select_2932;
  assign select_2932 = drew_q ? (equal_2104_s4_q ? (and_2071_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2933;
  assign select_2933 = equal_1930_s4_q ? 8'h0 : select_2932;
  // hls/stages/registration.hpp:133
  logic [13:0] select_2935;
  assign select_2935 = and_2916_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2933[7]}}, select_2933});
  // hls/stages/patches.hpp:303
  logic and_2938;
  assign and_2938 = not_1931_s4_q & (drew_q & (and_2071_s4_q & equal_2104_s4_q));
  // hls/stages/registration.hpp:133
  logic [5:0] select_2940;
  assign select_2940 = and_2916_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2938});
  // hls/stages/registration.hpp:106
  logic and_2942;
  assign and_2942 = and_2071_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/patches.hpp:303
  logic [1:0] select_2944;
  assign select_2944 = drew_q ? (equal_2104_s4_q ? {and_2942, and_2071_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2945;
  assign select_2945 = equal_1930_s4_q ? 2'h0 : select_2944;
  // hls/stages/registration.hpp:181
  logic [6:0] sum_2946;
  assign sum_2946 = registration_half_votes_down_q + {{5{select_2945[1]}}, select_2945};
  // hls/stages/patches.hpp:303
  logic [1:0] select_2952;
  assign select_2952 = drew_q ? (equal_2104_s4_q ? {and_2950_s4_q, and_2071_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2953;
  assign select_2953 = equal_1930_s4_q ? 2'h0 : select_2952;
  // hls/stages/registration.hpp:182
  logic [6:0] sum_2954;
  assign sum_2954 = registration_half_votes_up_q + {{5{select_2953[1]}}, select_2953};
  // hls/stages/registration.hpp:106
  logic and_2957;
  assign and_2957 = and_2071_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/patches.hpp:303
  logic [1:0] select_2959;
  assign select_2959 = drew_q ? (equal_2104_s4_q ? {and_2957, and_2071_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2960;
  assign select_2960 = equal_1930_s4_q ? 2'h0 : select_2959;
  // hls/stages/registration.hpp:181
  logic [6:0] sum_2961;
  assign sum_2961 = registration_half_half_votes_down_q + {{5{select_2960[1]}}, select_2960};
  // hls/stages/patches.hpp:303
  logic [1:0] select_2966;
  assign select_2966 = drew_q ? (equal_2104_s4_q ? {and_2964_s4_q, and_2071_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2967;
  assign select_2967 = equal_1930_s4_q ? 2'h0 : select_2966;
  // hls/stages/registration.hpp:182
  logic [6:0] sum_2968;
  assign sum_2968 = registration_half_half_votes_up_q + {{5{select_2967[1]}}, select_2967};
  // hls/stages/patches.hpp:303
  logic and_3002;
  assign and_3002 = equal_1930_s4_q & (x_s4_q[6] & (not_2302_s4_q & less_2006_s4_q));
  // hls/stages/agreement.hpp:1071
  logic [11:0] select_3009;
  assign select_3009 = or_2010_s4_q ? 12'h0 : (equal_3007_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1083
  logic [11:0] select_3012;
  assign select_3012 = x_s4_q[6] ? (equal_1975_s4_q ? 12'h0 : (less_2006_s4_q ? select_3009 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:303
  logic [11:0] select_3013;
  assign select_3013 = equal_1930_s4_q ? select_3012 : 12'h0;
  // hls/stages/registration.hpp:152
  logic and_3014;
  assign and_3014 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1083
  logic and_3017;
  assign and_3017 = not_2302_s4_q & (less_2006_s4_q & ({and_3014, x_s4_q[0]} == 2'h0));
  // hls/stages/patches.hpp:303
  logic and_3019;
  assign and_3019 = equal_1930_s4_q & (x_s4_q[6] & and_3017);
  // hls/stages/registration.hpp:249
  logic [13:0] sum_3021;
  assign sum_3021 = {{2{select_3013[11]}}, select_3013} + (and_3019 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1071
  logic [11:0] select_3024;
  assign select_3024 = or_2010_s4_q ? 12'h0 : (equal_3007_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1083
  logic [11:0] select_3027;
  assign select_3027 = x_s4_q[6] ? (equal_1975_s4_q ? 12'h0 : (less_2006_s4_q ? select_3024 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:303
  logic [11:0] select_3028;
  assign select_3028 = equal_1930_s4_q ? select_3027 : 12'h0;
  // hls/stages/registration.hpp:250
  logic [13:0] sum_3030;
  assign sum_3030 = {{2{select_3028[11]}}, select_3028} + (and_3019 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:149
  logic not_3032;
  assign not_3032 = ~all_s4_q;
  // hls/stages/agreement.hpp:1083
  logic and_3035;
  assign and_3035 = not_2302_s4_q & (less_2006_s4_q & (x_s4_q[2:0] == {all_s4_q, not_3032, 1'b0}));
  // hls/stages/patches.hpp:303
  logic and_3041;
  assign and_3041 = equal_1930_s4_q & (x_s4_q[6] & (not_2302_s4_q & (less_2006_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:243
  logic not_3042;
  assign not_3042 = ~and_3041;
  logic less_3043;
  assign less_3043 = $signed({9'h1, {2{not_3042}}, and_3041}) < $signed(registration_up_q[13:2]);
  logic select_3044;
  assign select_3044 = (equal_1930_s4_q & (x_s4_q[6] & and_3035)) ? less_3043 : registration_enough_q;
  // hls/stages/agreement.hpp:1083
  logic and_3048;
  assign and_3048 = x_s4_q[6] & (not_2302_s4_q & (less_2006_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:303
  logic and_3049;
  assign and_3049 = equal_1930_s4_q & and_3048;
  // hls/stages/registration.hpp:239
  logic less_3050;
  assign less_3050 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3052;
  assign less_3052 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1083
  logic and_3057;
  assign and_3057 = x_s4_q[6] & (not_2302_s4_q & (less_2006_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/patches.hpp:303
  logic and_3058;
  assign and_3058 = equal_1930_s4_q & and_3057;
  // hls/stages/agreement.hpp:1083
  logic and_3065;
  assign and_3065 = x_s4_q[6] & (not_2302_s4_q & (less_2006_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:156
  logic equal_3068;
  assign equal_3068 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1083
  logic and_3071;
  assign and_3071 = not_2302_s4_q & (less_2006_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_3068));
  // hls/stages/registration.hpp:241
  logic and_3075;
  assign and_3075 = (equal_1930_s4_q & (x_s4_q[6] & and_3071)) & (less_3052 | less_3050);
  // hls/stages/agreement.hpp:1083
  logic and_3080;
  assign and_3080 = not_2302_s4_q & (less_2006_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_3068)));
  // hls/stages/registration.hpp:241
  logic and_3083;
  assign and_3083 = registration_votes_up_q & registration_other_down_q;
  logic select_3085;
  assign select_3085 = registration_votes_down_q ? (registration_other_up_q | and_3083) : and_3083;
  // hls/stages/registration.hpp:137
  logic and_3087;
  assign and_3087 = (equal_1930_s4_q & (x_s4_q[6] & and_3080)) & (registration_other_enough_q & select_3085);
  // hls/stages/registration.hpp:242
  logic or_3090;
  assign or_3090 = registration_moved_q | (registration_enough_q & (and_3075 | and_3087));
  // hls/stages/agreement.hpp:263
  logic [7:0] select_3174;
  assign select_3174 = sample_pair_whole_s4_q ? (equal_2061_s4_q ? patches_place_0_slope_q : select_2156[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3178;
  assign select_3178 = sample_pair_whole_s4_q ? (equal_2061_s4_q ? patches_place_1_slope_q : select_2182[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:105
  logic select_3180;
  assign select_3180 = equal_2061_s4_q ? patches_valid_0_q : (select_2060_s4_q ? patches_valid_0_q : select_2155[0]);
  // hls/stages/agreement.hpp:263
  logic select_3183;
  assign select_3183 = sample_pair_whole_s4_q ? (and_2175 ? (sample_present_s4_q & select_3180) : select_3180) : patches_valid_0_q;
  // hls/stages/patches.hpp:105
  logic select_3185;
  assign select_3185 = equal_2061_s4_q ? patches_valid_1_q : (select_2060_s4_q ? select_2155[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_3188;
  assign select_3188 = sample_pair_whole_s4_q ? (and_2192 ? (sample_present_s4_q & select_3185) : select_3185) : patches_valid_1_q;
  logic [5:0] select_3191;
  assign select_3191 = sample_pair_whole_s4_q ? (select_2173[5] ? {1'b1, select_2173[4:0]} : (select_2173 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3194;
  assign select_3194 = sample_pair_whole_s4_q ? (select_2190[5] ? {1'b1, select_2190[4:0]} : (select_2190 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3197;
  assign select_3197 = sample_pair_whole_s4_q ? (select_2202[4] ? {1'b1, select_2202[3:0]} : (select_2202 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3200;
  assign select_3200 = sample_pair_whole_s4_q ? (select_2206[4] ? {1'b1, select_2206[3:0]} : (select_2206 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:445
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3611_s4_q, parity_3607_s4_q, xor_3595_s4_q, parity_3567_s4_q, parity_3505_s4_q, parity_3376_s4_q} + (equal_3612_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:160
  logic [9:0] select_3616;
  assign select_3616 = equal_2139_s4_q ? patches_sums_values_0_q : (equal_2141_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3617;
  assign select_3617 = equal_2141_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3619;
  assign select_3619 = equal_2141_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3621;
  assign select_3621 = equal_2141_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3623;
  assign select_3623 = equal_2141_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3625;
  assign select_3625 = equal_2141_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3627;
  assign select_3627 = equal_2141_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3629;
  assign select_3629 = equal_2141_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3631;
  assign select_3631 = equal_2141_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3633;
  assign select_3633 = equal_2141_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3635;
  assign select_3635 = equal_2141_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3637;
  assign select_3637 = equal_2141_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3639;
  assign select_3639 = equal_2141_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3641;
  assign select_3641 = equal_2141_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3643;
  assign select_3643 = equal_2141_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3645;
  assign select_3645 = equal_2141_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3647;
  assign select_3647 = equal_2141_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:519
  logic or_3752;
  assign or_3752 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3751_s4_q;
  logic or_3755;
  assign or_3755 = equal_3743_s4_q | (less_3745_s4_q | (less_3746_s4_q | or_3752));
  // hls/stages/patches.hpp:499
  logic not_3756;
  assign not_3756 = ~or_3755;
  // hls/stages/patches.hpp:480
  logic and_3757;
  assign and_3757 = equal_2276_s4_q & not_3756;
  // hls/stages/patches.hpp:160
  logic and_3760;
  assign and_3760 = equal_2139_s4_q & (less_2273_s4_q ? (not_2275_s4_q & and_3757) : and_3757);
  // hls/stages/patches.hpp:557
  logic not_3761;
  assign not_3761 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:480
  logic and_3763;
  assign and_3763 = equal_2276_s4_q & (patches_second_s4_q & not_3756);
  // hls/stages/patches.hpp:160
  logic and_3766;
  assign and_3766 = equal_2139_s4_q & (less_2273_s4_q ? (not_2275_s4_q & and_3763) : and_3763);
  // hls/stages/patches.hpp:557
  logic not_3767;
  assign not_3767 = ~and_3766;
  // hls/stages/patches.hpp:164
  logic and_3769;
  assign and_3769 = and_3760 & (not_3761 & not_3767);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3771;
  assign sum_3771 = {7'h0, and_3769} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:517
  logic [7:0] select_3797;
  assign select_3797 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:516
  logic [5:0] select_3798;
  assign select_3798 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3799;
  assign sum_3799 = {2'h0, select_3731_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3800;
  assign sum_3800 = {select_3798[5], select_3798} + {{3{sum_3799[3]}}, sum_3799};
  // hls/stages/patches.hpp:517
  logic [17:0] product_3801;
  assign product_3801 = $signed({{10{select_3797[7]}}, select_3797}) * $signed({{8{sum_3800[6]}}, sum_3800, select_3731_s4_q[2:0]});
  // hls/stages/patches.hpp:518
  logic [13:0] difference_3802;
  assign difference_3802 = {{6{select_3796_s4_q[7]}}, select_3796_s4_q} - {product_3801[17], product_3801[17:5]};
  // hls/stages/patches.hpp:524
  logic less_3803;
  assign less_3803 = $signed({{7{difference_3773[6]}}, difference_3773}) < $signed(difference_3802);
  // hls/stages/patches.hpp:480
  logic and_3806;
  assign and_3806 = equal_2276_s4_q & (not_3756 & (~less_3803));
  // hls/stages/patches.hpp:160
  logic and_3809;
  assign and_3809 = equal_2139_s4_q & (less_2273_s4_q ? (not_2275_s4_q & and_3806) : and_3806);
  // hls/stages/patches.hpp:560
  logic and_3810;
  assign and_3810 = and_3809 & and_3769;
  logic [7:0] sum_3811;
  assign sum_3811 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3810};
  // hls/stages/patches.hpp:480
  logic and_3815;
  assign and_3815 = not_3756 & (~($signed(difference_3802) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3816;
  assign and_3816 = equal_2276_s4_q & and_3815;
  // hls/stages/patches.hpp:160
  logic and_3819;
  assign and_3819 = equal_2139_s4_q & (less_2273_s4_q ? (not_2275_s4_q & and_3816) : and_3816);
  // hls/stages/patches.hpp:561
  logic and_3820;
  assign and_3820 = and_3819 & and_3769;
  logic [7:0] sum_3821;
  assign sum_3821 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3820};
  // hls/stages/patches.hpp:164
  logic and_3823;
  assign and_3823 = and_3760 & (and_3766 & not_3761);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3825;
  assign sum_3825 = {7'h0, and_3823} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:560
  logic and_3827;
  assign and_3827 = and_3809 & and_3823;
  logic [7:0] sum_3828;
  assign sum_3828 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3827};
  // hls/stages/patches.hpp:561
  logic and_3830;
  assign and_3830 = and_3819 & and_3823;
  logic [7:0] sum_3831;
  assign sum_3831 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3830};
  // hls/stages/patches.hpp:164
  logic and_3833;
  assign and_3833 = and_3760 & (patches_lower_s4_q & not_3767);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3835;
  assign sum_3835 = {7'h0, and_3833} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:560
  logic and_3837;
  assign and_3837 = and_3809 & and_3833;
  logic [7:0] sum_3838;
  assign sum_3838 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3837};
  // hls/stages/patches.hpp:561
  logic and_3840;
  assign and_3840 = and_3819 & and_3833;
  logic [7:0] sum_3841;
  assign sum_3841 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3840};
  // hls/stages/patches.hpp:164
  logic and_3843;
  assign and_3843 = and_3760 & (patches_lower_s4_q & and_3766);
  // hls/stages/patches.hpp:559
  logic [7:0] sum_3845;
  assign sum_3845 = {7'h0, and_3843} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:560
  logic and_3847;
  assign and_3847 = and_3809 & and_3843;
  logic [7:0] sum_3848;
  assign sum_3848 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3847};
  // hls/stages/patches.hpp:561
  logic and_3850;
  assign and_3850 = and_3819 & and_3843;
  logic [7:0] sum_3851;
  assign sum_3851 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3850};
  // hls/stages/agreement.hpp:1071
  logic less_3852;
  assign less_3852 = x_s4_q[5:3] < 3'h5;
  // hls/stages/agreement.hpp:1153
  logic equal_3853;
  assign equal_3853 = x_s4_q[2:0] == 3'h0;
  // hls/stages/registration.hpp:149
  logic not_3854;
  assign not_3854 = ~x_s4_q[4];
  // hls/stages/registration.hpp:156
  logic not_3855;
  assign not_3855 = ~x_s4_q[3];
  // hls/stages/patches.hpp:175
  logic and_3856;
  assign and_3856 = not_3854 & not_3855;
  logic [1:0] select_3857;
  assign select_3857 = x_s4_q[4] ? {1'b1, x_s4_q[3]} : {not_3855, 1'b1};
  logic [3:0] select_3858;
  assign select_3858 = x_s4_q[5] ? {{2{and_3856}}, 2'h0} : {not_3855, not_3854, select_3857};
  // hls/stages/agreement.hpp:1083
  logic and_3862;
  assign and_3862 = x_s4_q[6] & (not_2302_s4_q & (less_3852 & (equal_3853 & select_3858[0])));
  // hls/stages/patches.hpp:303
  logic and_3863;
  assign and_3863 = equal_1930_s4_q & and_3862;
  // hls/stages/patches.hpp:175
  logic equal_3865;
  assign equal_3865 = x_s4_q[2:0] == 3'h1;
  // hls/stages/agreement.hpp:1083
  logic and_3869;
  assign and_3869 = x_s4_q[6] & (not_2302_s4_q & (less_3852 & (select_3858[1] & equal_3865)));
  // hls/stages/patches.hpp:303
  logic and_3870;
  assign and_3870 = equal_1930_s4_q & and_3869;
  // hls/stages/patches.hpp:541
  logic [7:0] or_3872;
  assign or_3872 = (and_3863 ? patches_quarters_0_places_q : 8'h0) | (and_3870 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1083
  logic and_3876;
  assign and_3876 = not_2302_s4_q & (less_3852 & (select_3858[2] & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/patches.hpp:303
  logic and_3878;
  assign and_3878 = equal_1930_s4_q & (x_s4_q[6] & and_3876);
  // hls/stages/agreement.hpp:1083
  logic and_3884;
  assign and_3884 = not_2302_s4_q & (less_3852 & (select_3858[3] & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:303
  logic and_3886;
  assign and_3886 = equal_1930_s4_q & (x_s4_q[6] & and_3884);
  // hls/stages/patches.hpp:541
  logic [7:0] or_3888;
  assign or_3888 = (or_3872 | (and_3878 ? patches_quarters_2_places_q : 8'h0)) | (and_3886 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:542
  logic [7:0] or_3891;
  assign or_3891 = (and_3863 ? patches_quarters_0_up_q : 8'h0) | (and_3870 ? patches_quarters_1_up_q : 8'h0);
  logic [7:0] or_3895;
  assign or_3895 = (or_3891 | (and_3878 ? patches_quarters_2_up_q : 8'h0)) | (and_3886 ? patches_quarters_3_up_q : 8'h0);
  // hls/stages/patches.hpp:543
  logic [7:0] or_3898;
  assign or_3898 = (and_3863 ? patches_quarters_0_down_q : 8'h0) | (and_3870 ? patches_quarters_1_down_q : 8'h0);
  logic [7:0] or_3902;
  assign or_3902 = (or_3898 | (and_3878 ? patches_quarters_2_down_q : 8'h0)) | (and_3886 ? patches_quarters_3_down_q : 8'h0);
  // hls/stages/patches.hpp:179
  logic [4:0] sum_3903;
  assign sum_3903 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1083
  logic and_3907;
  assign and_3907 = x_s4_q[6] & (not_2302_s4_q & (less_3852 & (sum_3903[4:2] == 3'h0)));
  // hls/stages/patches.hpp:303
  logic and_3908;
  assign and_3908 = equal_1930_s4_q & and_3907;
  logic and_3912;
  assign and_3912 = equal_1930_s4_q & (x_s4_q[6] & (not_2302_s4_q & (less_3852 & equal_3865)));
  // hls/stages/patches.hpp:538
  logic [7:0] select_3915;
  assign select_3915 = and_3908 ? (patches_word_places_q + (and_3912 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3918;
  assign select_3918 = and_3908 ? (patches_word_up_q + (and_3912 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3921;
  assign select_3921 = and_3908 ? (patches_word_down_q + (and_3912 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:525
  logic [5:0] select_3925;
  assign select_3925 = ($signed(difference_3802[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3802[5:0];
  logic [5:0] select_3926;
  assign select_3926 = ($signed(14'h10) < $signed(difference_3802)) ? 6'h10 : select_3925;
  // hls/stages/patches.hpp:480
  logic [5:0] select_3928;
  assign select_3928 = equal_2276_s4_q ? (or_3755 ? 6'h0 : select_3926) : 6'h0;
  logic [5:0] select_3930;
  assign select_3930 = less_2273_s4_q ? (equal_2274_s4_q ? 6'h0 : select_3928) : select_3928;
  // hls/stages/patches.hpp:563
  logic [5:0] select_3932;
  assign select_3932 = and_3760 ? (equal_2139_s4_q ? select_3930 : 6'h0) : 6'h0;
  logic [11:0] sum_3933;
  assign sum_3933 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3932[5]}}, select_3932};
  // hls/stages/patches.hpp:303
  logic and_3937;
  assign and_3937 = equal_1930_s4_q & (x_s4_q[6] & (not_2302_s4_q & (equal_3068 & less_3852)));
  // hls/stages/agreement.hpp:1083
  logic and_3941;
  assign and_3941 = x_s4_q[6] & (not_2302_s4_q & (less_3852 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:303
  logic and_3942;
  assign and_3942 = equal_1930_s4_q & and_3941;
  // hls/stages/patches.hpp:552
  logic [7:0] select_3944;
  assign select_3944 = and_3937 ? (and_3942 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:554
  logic or_3948;
  assign or_3948 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:551
  logic select_3950;
  assign select_3950 = and_3937 ? (and_3942 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:164
  logic and_3956;
  assign and_3956 = patches_complete_q & (equal_1930_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_3952_s4_q)));
  logic and_3957;
  assign and_3957 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3959;
  assign select_3959 = and_3942 ? {and_3957, patches_found_q[4:1]} : (and_3937 ? {and_3957, patches_found_q[4:1]} : patches_found_q);
  // hls/stages/patches.hpp:550
  logic select_3966;
  assign select_3966 = patches_round_ends_q ? (~(patches_found_q == 5'h0)) : patches_moved_q;
  // hls/stages/agreement.hpp:1125
  logic or_4023;
  assign or_4023 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1147
  logic equal_4025;
  assign equal_4025 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1156
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1157
  logic select_4031;
  assign select_4031 = (equal_4025 & equal_3853) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1076
  logic [10:0] sum_4034;
  assign sum_4034 = {1'b0, select_2855} + {2'h0, select_2855[9:1]};
  logic select_4037;
  assign select_4037 = (select_2852[9:3] == 7'h0) ? ((~or_4023) & (~select_4031)) : (~({sum_4034, select_2855[0]} < {2'h0, select_2852}));
  // hls/stages/agreement.hpp:1083
  logic [47:0] select_4039;
  assign select_4039 = x_s4_q[6] ? (equal_1975_s4_q ? good_q : {select_4037, good_q[47:1]}) : good_q;
  // hls/stages/patches.hpp:303
  logic select_4043;
  assign select_4043 = equal_1930_s4_q ? ((x_s4_q[6] & good_known_q) | equal_3952_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1147
  logic equal_4044;
  assign equal_4044 = x_s4_q[6:3] == 4'ha;
  logic equal_4046;
  assign equal_4046 = x_s4_q[6:3] == 4'h9;
  logic equal_4047;
  assign equal_4047 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1066
  logic [13:0] select_4049;
  assign select_4049 = equal_4046 ? counts_skin_unproven_q : (equal_4047 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4044 ? counts_nearer_q : select_4049;
  // hls/stages/agreement.hpp:1152
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1160
  logic select_4052;
  assign select_4052 = (equal_4044 & equal_3853) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1085
  logic not_4053;
  assign not_4053 = ~hidden_for_q[7];
  logic [7:0] select_4055;
  assign select_4055 = select_4052 ? (hidden_for_q + {7'h0, not_4053}) : 8'h0;
  // hls/stages/patches.hpp:303
  logic [7:0] select_4057;
  assign select_4057 = equal_1930_s4_q ? (equal_3952_s4_q ? select_4055 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1160
  logic [13:0] select_4058;
  assign select_4058 = equal_3853 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1066
  logic [7:0] select_4060;
  assign select_4060 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4062;
  assign select_4062 = equal_4047 ? cfg_unproven_skin_limit_i : (equal_4025 ? cfg_unproven_limit_i : select_4060);
  logic [7:0] limit;
  assign limit = equal_4044 ? cfg_regions_limit_i : (equal_4046 ? cfg_hidden_limit_i : select_4062);
  // hls/stages/agreement.hpp:1160
  logic not_4065;
  assign not_4065 = ~x_s4_q[2];
  logic [3:0] select_4066;
  assign select_4066 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_4065, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_4065};
  logic [7:0] select_4067;
  assign select_4067 = x_s4_q[0] ? {select_4066[3], 1'b0, select_4066[2], 1'b0, select_4066[1], 1'b0, select_4066[0], 1'b0} : {1'b0, select_4066[3], 1'b0, select_4066[2], 1'b0, select_4066[1], 1'b0, select_4066[0]};
  // hls/stages/agreement.hpp:1066
  logic [13:0] select_4071;
  assign select_4071 = equal_4046 ? counts_skin_supervised_q : (equal_4047 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_4044 ? counts_textured_q : select_4071;
  // hls/stages/agreement.hpp:1160
  logic [13:0] select_4073;
  assign select_4073 = ((limit & select_4067) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4058} + {1'b0, select_4073};
  // hls/stages/patches.hpp:303
  logic select_4078;
  assign select_4078 = equal_1930_s4_q ? (equal_3853 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1158
  logic and_4083;
  assign and_4083 = too_much_q & (~(equal_4047 & equal_3853));
  // hls/stages/agreement.hpp:1159
  logic select_4088;
  assign select_4088 = (over[14] & equal_3853) ? (and_4083 | ((equal_4047 | equal_4046) | (x_s4_q[6:3] == 4'hf))) : and_4083;
  // hls/stages/agreement.hpp:1233
  logic [1:0] select_4206;
  assign select_4206 = and_4205_s4_q ? {and_2432, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1234
  logic and_4207;
  assign and_4207 = proven_q & less_4195;
  // hls/stages/agreement.hpp:424
  logic select_4210;
  assign select_4210 = and_2362_s4_q ? (less_2363_s4_q ? (select_4206[0] & and_4207) : seen_q) : seen_q;
  logic select_4213;
  assign select_4213 = and_2362_s4_q ? (less_2363_s4_q ? (select_4206[1] & and_4207) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1169
  logic not_4225;
  assign not_4225 = ~(or_4023 | not_4214);
  // hls/stages/patches.hpp:303
  logic and_4229;
  assign and_4229 = equal_1930_s4_q & (equal_3952_s4_q & (not_4225 & (select_4031 | select_4088)));
  logic and_4232;
  assign and_4232 = equal_3952_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1087
  logic or_4236;
  assign or_4236 = select_2685 | (select_2697 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/patches.hpp:303
  logic and_4243;
  assign and_4243 = equal_1930_s4_q & (equal_3952_s4_q & (not_4225 & (select_2691 | select_2703)));
  // hls/stages/agreement.hpp:1087
  logic and_4248;
  assign and_4248 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4055 < cfg_hidden_frames_i));
  // hls/stages/patches.hpp:303
  logic and_4255;
  assign and_4255 = equal_1930_s4_q & (x_s4_q[6] & (not_2302_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1081
  logic [31:0] select_4263;
  assign select_4263 = equal_1997_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4261_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4264;
  assign select_4264 = equal_1995_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4263;
  logic [31:0] select_4265;
  assign select_4265 = equal_1993_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4264;
  logic [31:0] select_4266;
  assign select_4266 = equal_1991_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_4265;
  logic [31:0] select_4267;
  assign select_4267 = equal_1989_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_4266;
  logic [31:0] select_4268;
  assign select_4268 = equal_1987_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4267;
  logic [31:0] select_4269;
  assign select_4269 = equal_1985_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4268;
  logic [31:0] select_4270;
  assign select_4270 = equal_1983_s4_q ? {7'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4269;
  // hls/stages/agreement.hpp:1079
  logic [9:0] select_4271;
  assign select_4271 = less_2851 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1083
  logic [31:0] select_4272;
  assign select_4272 = equal_1975_s4_q ? select_4270 : {2'h0, select_4271, select_2855, select_2852};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_488_s4_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s4_q, and_603, and_579_s4_q, and_578_s4_q, and_553_s4_q, less_545_s4_q, less_544_s4_q, less_543_s4_q, less_542_s4_q, less_541_s4_q, less_540_s4_q, less_539_s4_q, less_538_s4_q, less_537_s4_q, less_536_s4_q, less_535_s4_q, less_534_s4_q, less_533_s4_q, less_532_s4_q, less_531_s4_q, less_530_s4_q, less_529_s4_q, less_528_s4_q, less_527_s4_q, less_526_s4_q, less_525_s4_q, less_524_s4_q, less_523_s4_q, less_522_s4_q};
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
  assign registration_sums_waddr = {sum_1981_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_2040_s4_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2039, sum_2035};
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
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_2069_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_2138_s4_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2131_s4_q};
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
  assign patches_right_0_waddr = {select_2166_s4_q, select_2163};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_2175);
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
  assign patches_right_1_waddr = {select_2166_s4_q, select_2189};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_2192);
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
  assign patches_left_waddr = {select_2209, select_2208_s4_q, column_7};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_2215);
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
  assign patches_rows_wdata = select_2290;
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
  assign regions_waddr = {region_row_s4_q, or_2300_s4_q, or_2297_s4_q, or_2294_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_2328_s4_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2327, sum_2321, sum_2316};
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
  assign map_waddr = {sum_2368_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_2442_s4_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2432, is_seen};
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
      patches_place_0_column_q <= 8'h0;
      patches_place_0_shift_q <= 6'h0;
      patches_place_0_slope_q <= 8'h0;
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
      patches_complete_q <= 1'b0;
      patches_round_ends_q <= 1'b0;
      patches_found_q <= 5'h0;
      patches_round_places_q <= 8'h0;
      patches_round_across_q <= 12'h0;
      patches_round_moved_q <= 5'h0;
      patches_moved_q <= 1'b0;
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
      census_left_misses_q <= select_2591;
      sharpness_before_last_mask_q <= select_2599;
      sharpness_sums_detail_0_q <= and_488_s4_q ? select_2613 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_488_s4_q ? select_2625 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_488_s4_q ? sum_2629 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_488_s4_q ? sum_2633 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2651 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2661 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2663 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2665 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2667 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2669 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2674;
      sharpness_comparing_carry_1_q <= select_2678;
      sharpness_comparing_less_detail_0_q <= select_2685;
      sharpness_comparing_less_detail_1_q <= select_2691;
      sharpness_comparing_less_contrast_0_q <= select_2697;
      sharpness_comparing_less_contrast_1_q <= select_2703;
      counts_supervised_q <= select_2809;
      counts_textured_q <= and_2803_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2812});
      counts_explained_q <= and_2803_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2817});
      counts_nearer_q <= and_2803_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2822});
      counts_unproven_q <= and_2803_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2848});
      counts_regions_bad_q <= select_2864;
      counts_skin_supervised_q <= select_2871;
      counts_skin_textured_q <= select_2878;
      counts_skin_unproven_q <= select_2886;
      registration_half_across_q <= select_2935;
      registration_half_measured_q <= select_2940;
      registration_half_votes_down_q <= and_2916_s4_q ? 7'h0 : sum_2946;
      registration_half_votes_up_q <= and_2916_s4_q ? 7'h0 : sum_2954;
      registration_half_half_votes_down_q <= and_2916_s4_q ? 7'h0 : sum_2961;
      registration_half_half_votes_up_q <= and_2916_s4_q ? 7'h0 : sum_2968;
      registration_down_q <= and_3002 ? sum_3021 : registration_down_q;
      registration_up_q <= and_3002 ? sum_3030 : registration_up_q;
      registration_enough_q <= select_3044;
      registration_votes_down_q <= and_3049 ? less_3050 : registration_votes_down_q;
      registration_votes_up_q <= and_3049 ? less_3052 : registration_votes_up_q;
      registration_other_enough_q <= and_3058 ? select_3044 : registration_other_enough_q;
      registration_other_down_q <= and_3058 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3058 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1930_s4_q & and_3065)) & or_3090;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_2157 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_2158 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3174;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_2183 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_2184 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3178;
      patches_valid_0_q <= select_3183;
      patches_valid_1_q <= select_3188;
      patches_right_next_0_q <= select_3191;
      patches_right_next_1_q <= select_3194;
      patches_left_next_0_q <= select_3197;
      patches_left_next_1_q <= select_3200;
      patches_sums_values_0_q <= select_3616;
      patches_sums_values_1_q <= equal_2139_s4_q ? patches_sums_values_1_q : select_3617;
      patches_sums_values_2_q <= equal_2139_s4_q ? patches_sums_values_2_q : select_3619;
      patches_sums_values_3_q <= equal_2139_s4_q ? patches_sums_values_3_q : select_3621;
      patches_sums_values_4_q <= equal_2139_s4_q ? patches_sums_values_4_q : select_3623;
      patches_sums_values_5_q <= equal_2139_s4_q ? patches_sums_values_5_q : select_3625;
      patches_sums_values_6_q <= equal_2139_s4_q ? patches_sums_values_6_q : select_3627;
      patches_sums_values_7_q <= equal_2139_s4_q ? patches_sums_values_7_q : select_3629;
      patches_sums_values_8_q <= equal_2139_s4_q ? patches_sums_values_8_q : select_3631;
      patches_sums_values_9_q <= equal_2139_s4_q ? patches_sums_values_9_q : select_3633;
      patches_sums_values_10_q <= equal_2139_s4_q ? patches_sums_values_10_q : select_3635;
      patches_sums_values_11_q <= equal_2139_s4_q ? patches_sums_values_11_q : select_3637;
      patches_sums_values_12_q <= equal_2139_s4_q ? patches_sums_values_12_q : select_3639;
      patches_sums_values_13_q <= equal_2139_s4_q ? patches_sums_values_13_q : select_3641;
      patches_sums_values_14_q <= equal_2139_s4_q ? patches_sums_values_14_q : select_3643;
      patches_sums_values_15_q <= equal_2139_s4_q ? patches_sums_values_15_q : select_3645;
      patches_sums_values_16_q <= equal_2139_s4_q ? patches_sums_values_16_q : select_3647;
      patches_best_differing_q <= select_2290[9:0];
      patches_best_column_q <= select_2290[14:10];
      patches_quarters_0_places_q <= sum_3771;
      patches_quarters_0_up_q <= sum_3811;
      patches_quarters_0_down_q <= sum_3821;
      patches_quarters_1_places_q <= sum_3825;
      patches_quarters_1_up_q <= sum_3828;
      patches_quarters_1_down_q <= sum_3831;
      patches_quarters_2_places_q <= sum_3835;
      patches_quarters_2_up_q <= sum_3838;
      patches_quarters_2_down_q <= sum_3841;
      patches_quarters_3_places_q <= sum_3845;
      patches_quarters_3_up_q <= sum_3848;
      patches_quarters_3_down_q <= sum_3851;
      patches_word_places_q <= or_3888;
      patches_word_up_q <= or_3895;
      patches_word_down_q <= or_3902;
      patches_sum_places_q <= select_3915;
      patches_sum_up_q <= select_3918;
      patches_sum_down_q <= select_3921;
      patches_across_q <= sum_3933;
      patches_places_q <= select_3944;
      patches_enough_q <= {4'h0, and_3942} < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3948;
      patches_complete_q <= select_3950;
      patches_round_ends_q <= and_3956;
      patches_found_q <= and_3937 ? select_3959 : patches_found_q;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_moved_q <= select_3966;
      segment_textured_q <= select_2313 + {6'h0, and_2812};
      segment_explained_q <= select_2318 + {6'h0, and_2817};
      segment_nearer_q <= select_2324 + {6'h0, and_2822};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1930_s4_q ? select_4039 : good_q;
      good_known_q <= select_4043;
      hidden_for_q <= select_4057;
      product_q <= equal_1930_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4078;
      disagree_q <= equal_1930_s4_q ? select_4031 : disagree_q;
      too_much_q <= equal_1930_s4_q ? select_4088 : too_much_q;
      hides_q <= equal_1930_s4_q ? select_4052 : hides_q;
      seen_q <= select_4210;
      nearer_q <= select_4213;
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
      averager_quarter_1_0_q <= select_2466;
      averager_quarter_1_1_q <= select_2468;
      averager_quarter_2_0_q <= select_2470;
      averager_quarter_2_1_q <= select_2472;
      averager_detail_0_q <= select_2484;
      averager_detail_1_q <= select_2492;
      census_changes_values_0_left_q <= and_488_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_488_s4_q ? sum_2575 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2577;
      census_changes_values_1_right_q <= select_2578;
      census_changes_values_2_left_q <= select_2579;
      census_changes_values_2_right_q <= select_2580;
      sharpness_last_mask_q <= and_488_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_488_s4_q ? select_2596[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_488_s4_q ? select_2596[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_4190_s5_q;
  logic or_4215_s5_q;
  logic and_4216_s5_q;
  logic and_4220_s5_q;
  logic and_4223_s5_q;
  logic and_4229_s5_q;
  logic and_4233_s5_q;
  logic and_4239_s5_q;
  logic and_4243_s5_q;
  logic and_4251_s5_q;
  logic and_4255_s5_q;
  logic [5:0] select_4257_s5_q;
  logic [31:0] select_4274_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_0_q;
      pixel_1_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_4190_s5_q <= said_q;
      or_4215_s5_q <= not_4214 | select_4210;
      and_4216_s5_q <= cfg_prove_i & select_4213;
      and_4220_s5_q <= and_4220_s4_q;
      and_4223_s5_q <= equal_1930_s4_q & (equal_3952_s4_q & (cfg_prove_i & or_4023));
      and_4229_s5_q <= and_4229;
      and_4233_s5_q <= equal_1930_s4_q & and_4232;
      and_4239_s5_q <= equal_1930_s4_q & (equal_3952_s4_q & (not_4225 & or_4236));
      and_4243_s5_q <= and_4243;
      and_4251_s5_q <= equal_1930_s4_q & (equal_3952_s4_q & (cfg_prove_i & and_4248));
      and_4255_s5_q <= and_4255;
      select_4257_s5_q <= equal_1930_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_4274_s5_q <= equal_1930_s4_q ? (x_s4_q[6] ? select_4272 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4215_s5_q;
  assign marks_nearer_o = and_4216_s5_q;
  assign verdict_valid_o = and_4190_s5_q;
  assign verdict_unproven_yet_o = and_4220_s5_q;
  assign verdict_untextured_o = and_4223_s5_q;
  assign verdict_disagree_o = and_4229_s5_q;
  assign verdict_moved_o = and_4233_s5_q;
  assign verdict_unsharp_left_o = and_4239_s5_q;
  assign verdict_unsharp_right_o = and_4243_s5_q;
  assign verdict_hidden_o = and_4251_s5_q;
  assign frame_valid_o = and_4255_s5_q;
  assign frame_index_o = select_4257_s5_q;
  assign frame_word_o = select_4274_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_3903[1:0], product_3801[4:0], sum_2908[0], detail_4[1:0], detail_3[1:0], sum_2585[4:0], sum_2119[0], sum_2115[0], sum_601[4:0], cfg_width_i[2:0]};

endmodule
