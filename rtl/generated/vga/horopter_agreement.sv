// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2931 bits, pipeline 913 bits, memories 99800 bits.
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
  input  logic [4:0] cfg_on_skin_limit_i,
  input  logic cfg_alarm_before_i,
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
  assign last = {1'b0, cfg_width_i[9:3]} + 8'hff;
  logic [5:0] sum_2844;
  assign sum_2844 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3841;
  assign difference_3841 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_4116;
  assign difference_4116 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4318;
  assign less_4318 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4319;
  assign sum_4319 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_4337;
  assign not_4337 = ~cfg_prove_i;

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
  logic shift_first_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_476;
  assign select_476 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_478;
  assign select_478 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [8:0] select_481;
  assign select_481 = ({select_478, select_476} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_482;
  assign select_482 = select_476[0] ? averager_place_q : select_481;
  // hls/stages/census.hpp:41
  logic or_483;
  assign or_483 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:408
  logic and_486;
  assign and_486 = (select_476[0] & or_483) & (select_482[8:6] < 3'h5);
  // hls/stages/census.hpp:41
  logic [2:0] select_491;
  assign select_491 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:267
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_478 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_508;
  assign equal_508 = select_476 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_509;
  assign equal_509 = select_491 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_510;
  assign and_510 = equal_509 & and_486;
  // hls/stages/agreement.hpp:267
  logic and_512;
  assign and_512 = sample_pair_whole_q & (equal_508 & and_510);
  // hls/stages/agreement.hpp:191
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:614
  logic equal_532;
  assign equal_532 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:585
  logic or_533;
  assign or_533 = so | equal_532;
  logic not_534;
  assign not_534 = ~or_533;
  // hls/stages/agreement.hpp:605
  logic equal_535;
  assign equal_535 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:606
  logic equal_537;
  assign equal_537 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:583
  logic [7:0] sum_538;
  assign sum_538 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:585
  logic [7:0] select_539;
  assign select_539 = run_shift_q[5] ? x_q : sum_538;
  logic less_540;
  assign less_540 = {1'b0, last_q} < select_539;
  // hls/stages/agreement.hpp:219
  logic not_541;
  assign not_541 = ~less_540;
  // hls/stages/agreement.hpp:144
  logic and_542;
  assign and_542 = equal_537 & not_541;
  logic and_544;
  assign and_544 = not_534 & ((~equal_535) & and_542);
  // hls/stages/census.hpp:41
  logic [5:0] select_571;
  assign select_571 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:267
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_571 : 6'h0;
  // hls/stages/agreement.hpp:144
  logic select_628;
  assign select_628 = equal_535 ? not_541 : and_542;
  // hls/stages/agreement.hpp:786
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:144
  logic and_652;
  assign and_652 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_539)));
  logic and_653;
  assign and_653 = equal_535 & and_652;
  logic select_654;
  assign select_654 = or_533 ? not_541 : and_653;
  // hls/stages/agreement.hpp:807
  logic [6:0] right;
  assign right = sum_538[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:267
  logic [2:0] select_2494;
  assign select_2494 = sample_pair_whole_q ? (sample_last_q ? (select_491 + 3'h1) : select_491) : raster_at_y_q;
  logic [6:0] select_2496;
  assign select_2496 = sample_pair_whole_q ? (select_478 + {6'h0, equal_508}) : raster_at_column_q;
  logic [5:0] select_2499;
  assign select_2499 = sample_pair_whole_q ? (sample_last_q ? (select_571 + {5'h0, equal_509}) : select_571) : raster_at_row_q;
  logic select_2503;
  assign select_2503 = sample_pair_whole_q ? (sample_last_q ? (or_483 & (~raster_final_row_q)) : or_483) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2505;
  assign select_2505 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:267
  logic select_2509;
  assign select_2509 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:450
  logic equal_2753;
  assign equal_2753 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:455
  logic and_2754;
  assign and_2754 = and_512 & equal_2753;
  // hls/stages/agreement.hpp:514
  logic select_2757;
  assign select_2757 = (and_2754 | (~ends_cell_q)) ? and_2754 : ends_q;
  // hls/stages/agreement.hpp:520
  logic [2:0] now;
  assign now = select_2757 ? (and_2754 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:525
  logic [5:0] select_2761;
  assign select_2761 = select_2757 ? (and_2754 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2764;
  assign select_2764 = select_2757 ? (following_last_shift_q & (~and_2754)) : run_last_shift_q;
  // hls/stages/agreement.hpp:598
  logic and_2767;
  assign and_2767 = run_last_shift_q & equal_535;
  // hls/stages/agreement.hpp:607
  logic select_2769;
  assign select_2769 = equal_535 ? (~run_last_shift_q) : equal_537;
  // hls/stages/agreement.hpp:611
  logic equal_2770;
  assign equal_2770 = run_phase_q == 3'h1;
  logic not_2773;
  assign not_2773 = ~select_2769;
  // hls/stages/agreement.hpp:614
  logic equal_2775;
  assign equal_2775 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:598
  logic and_2776;
  assign and_2776 = final_row_q & so;
  // hls/stages/agreement.hpp:611
  logic [1:0] select_2777;
  assign select_2777 = equal_2775 ? 2'h1 : {2{and_2776}};
  logic [2:0] select_2779;
  assign select_2779 = (and_2767 | (select_2769 | equal_2770)) ? (equal_2770 ? 3'h2 : {not_2773, {2{select_2769}}}) : (equal_532 ? 3'h6 : {select_2777[0], select_2777});
  // hls/stages/agreement.hpp:598
  logic and_2782;
  assign and_2782 = select_2769 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:621
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2785;
  assign select_2785 = (plan_shift_q[5] & select_2769) ? value : 7'h0;
  logic [1:0] or_2786;
  assign or_2786 = {2{so}} | select_2785[5:4];
  // hls/stages/agreement.hpp:624
  logic [7:0] or_2790;
  assign or_2790 = (select_2769 ? plan_columns_q : 8'h0) | ((equal_2770 | equal_2775) ? whole_q : 8'h0);
  logic [1:0] or_2791;
  assign or_2791 = {2{and_2767}} | or_2790[3:2];
  // hls/stages/agreement.hpp:625
  logic [7:0] or_2793;
  assign or_2793 = {or_2790[7:4], or_2791, or_2790[1:0]} | (equal_532 ? drawn_q : 8'h0);
  logic [4:0] or_2794;
  assign or_2794 = {5{so}} | {or_2793[6], or_2793[3:0]};
  // hls/stages/agreement.hpp:631
  logic not_2798;
  assign not_2798 = ~run_shift_q[5];
  logic [7:0] select_2801;
  assign select_2801 = equal_535 ? ({{7{not_2798}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:514
  logic [6:0] select_2805;
  assign select_2805 = and_2754 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:517
  logic [7:0] select_2807;
  assign select_2807 = select_2757 ? {select_2805[6], select_2805} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2810;
  assign select_2810 = select_2757 ? (and_2754 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:511
  logic [6:0] select_2818;
  assign select_2818 = and_512 ? (equal_2753 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2821;
  assign select_2821 = and_512 ? (equal_2753 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2824;
  assign select_2824 = and_512 ? (equal_2753 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:522
  logic select_2835;
  assign select_2835 = (ends_cell_q | select_2757) ? (~(now == 3'h6)) : (equal_535 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:517
  logic and_2839;
  assign and_2839 = (~select_2757) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:467
  logic [6:0] sum_2840;
  assign sum_2840 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:451
  logic select_2842;
  assign select_2842 = equal_2753 ? ({sum_2840[6], cfg_height_i[8:3]} == {1'b0, sum_2840[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:370
  logic or_3217;
  assign or_3217 = select_478[0] | select_571[5];
  logic [7:0] sum_3218;
  assign sum_3218 = {1'b0, select_478[2:1], or_3217, select_571[4:1]} + 8'h1;
  logic less_3219;
  assign less_3219 = {sum_3218, select_571[0], select_491, 1'b0} < {4'h0, cfg_height_i};

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1309; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 30'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_544;
  logic [29:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [28:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[28:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:1310; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 78'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (or_533 ? not_541 : select_628);
  logic [77:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [76:0] left_rdata_q;
  assign left_rdata_q = left_word_q[76:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:1311; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [91:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 92'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_535 ? sum_538[6:0] : x_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_534 & select_628);
  logic [91:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [90:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[90:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 46 and parity, DISTANCE 12, hls/stages/agreement.hpp:1312; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [46:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 47'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_533 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_654;
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
      shift_first_q <= 1'b0;
    end else if (s0_en) begin
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_476 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2494;
      raster_at_column_q <= select_2496;
      raster_at_row_q <= select_2499;
      raster_at_live_q <= select_2503;
      raster_rows_left_q <= sample_pair_whole_q ? select_2505 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2509;
      averager_place_q <= sample_pair_whole_q ? select_482 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2761;
      run_last_shift_q <= select_2764;
      run_span_q <= select_2757 ? (and_2754 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2779;
      following_shift_q <= select_2769 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2782;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2785[6], or_2786, select_2785[3:0]};
      following_columns_q <= {or_2793[7], or_2794[4], or_2793[5:4], or_2794[3:0]};
      plan_shift_q <= equal_535 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2801;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2807;
      columns_left_q <= select_2810;
      last_q <= and_512 ? (equal_2753 ? column : last_q) : last_q;
      least_q <= select_2818;
      whole_q <= select_2821;
      drawn_q <= select_2824;
      age_q <= select_2757 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2757 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2835;
      ends_q <= and_2839;
      final_row_q <= and_512 ? select_2842 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
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
  logic shift_first_s1_q;
  logic [2:0] select_476_s1_q;
  logic [6:0] select_478_s1_q;
  logic [8:0] select_482_s1_q;
  logic and_486_s1_q;
  logic equal_492_s1_q;
  logic [6:0] column_s1_q;
  logic and_510_s1_q;
  logic and_512_s1_q;
  logic so_s1_q;
  logic equal_532_s1_q;
  logic or_533_s1_q;
  logic equal_535_s1_q;
  logic less_540_s1_q;
  logic not_541_s1_q;
  logic and_544_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_654_s1_q;
  logic and_1926_s1_q;
  logic [6:0] right_s1_q;
  logic equal_1934_s1_q;
  logic equal_1944_s1_q;
  logic equal_2063_s1_q;
  logic equal_2753_s1_q;
  logic and_2754_s1_q;
  logic not_3220_s1_q;
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
      shift_first_s1_q <= shift_first_q;
      select_476_s1_q <= select_476;
      select_478_s1_q <= select_478;
      select_482_s1_q <= select_482;
      and_486_s1_q <= and_486;
      equal_492_s1_q <= select_491 == 3'h0;
      column_s1_q <= column;
      and_510_s1_q <= and_510;
      and_512_s1_q <= and_512;
      so_s1_q <= so;
      equal_532_s1_q <= equal_532;
      or_533_s1_q <= or_533;
      equal_535_s1_q <= equal_535;
      less_540_s1_q <= less_540;
      not_541_s1_q <= not_541;
      and_544_s1_q <= and_544;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_654_s1_q <= select_654;
      and_1926_s1_q <= not_534 & and_653;
      right_s1_q <= right;
      equal_1934_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      equal_1944_s1_q <= run_phase_q == 3'h7;
      equal_2063_s1_q <= {or_483, select_491} == 4'hc;
      equal_2753_s1_q <= equal_2753;
      and_2754_s1_q <= and_2754;
      not_3220_s1_q <= ~less_3219;
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
  // hls/stages/agreement.hpp:657
  logic not_632;
  assign not_632 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:660
  logic and_633;
  assign and_633 = left_rdata_q[12] & not_632;
  logic and_634;
  assign and_634 = left_rdata_q[28] & not_632;
  logic and_635;
  assign and_635 = left_rdata_q[44] & not_632;
  logic and_636;
  assign and_636 = left_rdata_q[60] & not_632;
  // hls/stages/agreement.hpp:661
  logic and_640;
  assign and_640 = right_codes_rdata_q[12] & not_632;
  logic and_641;
  assign and_641 = right_codes_rdata_q[25] & not_632;
  logic and_642;
  assign and_642 = right_codes_rdata_q[38] & not_632;
  logic and_643;
  assign and_643 = right_codes_rdata_q[51] & not_632;
  logic and_644;
  assign and_644 = right_codes_rdata_q[64] & not_632;
  logic and_645;
  assign and_645 = right_codes_rdata_q[77] & not_632;
  // hls/stages/agreement.hpp:215
  logic and_660;
  assign and_660 = left_rdata_q[44] & not_541_s1_q;
  logic and_661;
  assign and_661 = right_codes_rdata_q[38] & not_541_s1_q;
  logic [11:0] select_662;
  assign select_662 = less_540_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_663;
  assign select_663 = less_540_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_667;
  assign select_667 = and_660 ? (and_661 ? (~(select_662 ^ select_663)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_673;
  assign parity_673 = ^select_667[5:3];
  logic parity_676;
  assign parity_676 = ^select_667[8:6];
  logic parity_679;
  assign parity_679 = ^select_667[11:3];
  // hls/stages/agreement.hpp:215
  logic and_683;
  assign and_683 = left_rdata_q[60] & not_541_s1_q;
  logic and_684;
  assign and_684 = right_codes_rdata_q[51] & not_541_s1_q;
  logic [11:0] select_685;
  assign select_685 = less_540_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_686;
  assign select_686 = less_540_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_690;
  assign select_690 = and_683 ? (and_684 ? (~(select_685 ^ select_686)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_693;
  assign parity_693 = ^select_690[8:6];
  logic parity_696;
  assign parity_696 = ^select_690[11:9];
  // hls/stages/agreement.hpp:215
  logic and_700;
  assign and_700 = left_rdata_q[76] & not_541_s1_q;
  logic and_701;
  assign and_701 = right_codes_rdata_q[64] & not_541_s1_q;
  logic [11:0] select_702;
  assign select_702 = less_540_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_703;
  assign select_703 = less_540_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_707;
  assign select_707 = and_700 ? (and_701 ? (~(select_702 ^ select_703)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_713;
  assign parity_713 = ^select_707[2:0];
  logic parity_716;
  assign parity_716 = ^select_707[5:3];
  logic parity_719;
  assign parity_719 = ^select_707[8:0];
  logic parity_725;
  assign parity_725 = ^select_707[11:9];
  logic parity_728;
  assign parity_728 = ^select_690[2:0];
  logic parity_731;
  assign parity_731 = ^{select_707[11:9], select_690[5:0]};
  logic parity_734;
  assign parity_734 = ^{select_707, select_690, select_667[2:0]};
  logic xor_735;
  assign xor_735 = parity_679 ^ parity_734;
  // hls/stages/count_bits.hpp:23
  logic or_739;
  assign or_739 = (select_667[1:0] == 2'h3) | (select_667[2] & (select_667[0] | select_667[1]));
  // hls/stages/count_bits.hpp:25
  logic or_743;
  assign or_743 = (select_690[7:6] == 2'h3) | (select_690[8] & (select_690[6] | select_690[7]));
  logic or_747;
  assign or_747 = (select_690[10:9] == 2'h3) | (select_690[11] & (select_690[9] | select_690[10]));
  // hls/stages/count_bits.hpp:23
  logic or_755;
  assign or_755 = (select_707[7:6] == 2'h3) | (select_707[8] & (~(select_707[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_759;
  assign or_759 = (select_707[1:0] == 2'h3) | (select_707[2] & (select_707[0] | select_707[1]));
  logic or_763;
  assign or_763 = (select_707[4:3] == 2'h3) | (select_707[5] & (select_707[3] | select_707[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_766;
  assign parity_766 = ^{or_763, or_759, or_755};
  // hls/stages/count_bits.hpp:23
  logic or_770;
  assign or_770 = (select_690[4:3] == 2'h3) | (select_690[5] & (select_690[3] | select_690[4]));
  // hls/stages/count_bits.hpp:25
  logic or_774;
  assign or_774 = (select_707[10:9] == 2'h3) | (select_707[11] & (select_707[9] | select_707[10]));
  logic or_778;
  assign or_778 = (select_690[1:0] == 2'h3) | (select_690[2] & (select_690[0] | select_690[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_781;
  assign parity_781 = ^{or_778, or_774, or_770};
  logic parity_784;
  assign parity_784 = ^{or_778, or_774, or_770, or_763, or_759, or_755, or_747, or_743, or_739};
  // hls/stages/count_bits.hpp:25
  logic and_785;
  assign and_785 = parity_679 & parity_734;
  logic or_789;
  assign or_789 = (parity_673 & parity_676) | ((^select_667[11:9]) & (parity_673 | parity_676));
  logic and_792;
  assign and_792 = (^{select_690[11:6], select_667[2:0]}) & (parity_719 | parity_731);
  logic or_793;
  assign or_793 = (parity_719 & parity_731) | and_792;
  // hls/stages/count_bits.hpp:23
  logic or_800;
  assign or_800 = (select_667[10:9] == 2'h3) | (select_667[11] & (select_667[9] | select_667[10]));
  // hls/stages/count_bits.hpp:25
  logic or_804;
  assign or_804 = (select_667[4:3] == 2'h3) | (select_667[5] & (select_667[3] | select_667[4]));
  logic or_808;
  assign or_808 = (select_667[7:6] == 2'h3) | (select_667[8] & (select_667[6] | select_667[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_811;
  assign parity_811 = ^{or_808, or_804, or_800};
  // hls/stages/count_bits.hpp:25
  logic or_815;
  assign or_815 = (parity_693 & parity_696) | ((^select_667[2:0]) & (parity_693 | parity_696));
  logic or_819;
  assign or_819 = (parity_713 & parity_716) | ((^select_707[8:6]) & (parity_713 | parity_716));
  logic or_823;
  assign or_823 = (parity_725 & parity_728) | ((^select_690[5:3]) & (parity_725 | parity_728));
  // hls/stages/count_bits.hpp:24
  logic parity_826;
  assign parity_826 = ^{or_823, or_819, or_815};
  logic parity_829;
  assign parity_829 = ^{or_823, or_819, or_815, or_808, or_804, or_800, or_793, or_789, and_785};
  logic xor_830;
  assign xor_830 = parity_784 ^ parity_829;
  // hls/stages/count_bits.hpp:25
  logic and_831;
  assign and_831 = parity_784 & parity_829;
  logic or_835;
  assign or_835 = (parity_766 & parity_781) | ((^{or_747, or_743, or_739}) & (parity_766 | parity_781));
  logic or_839;
  assign or_839 = (parity_811 & parity_826) | ((^{or_793, or_789, and_785}) & (parity_811 | parity_826));
  logic or_846;
  assign or_846 = (or_743 & or_747) | (or_739 & (or_743 | or_747));
  logic or_850;
  assign or_850 = (or_759 & or_763) | (or_755 & (or_759 | or_763));
  logic or_854;
  assign or_854 = (or_774 & or_778) | (or_770 & (or_774 | or_778));
  // hls/stages/count_bits.hpp:24
  logic parity_857;
  assign parity_857 = ^{or_854, or_850, or_846};
  // hls/stages/count_bits.hpp:25
  logic or_861;
  assign or_861 = (or_789 & or_793) | (and_785 & (or_789 | or_793));
  logic or_865;
  assign or_865 = (or_804 & or_808) | (or_800 & (or_804 | or_808));
  logic or_869;
  assign or_869 = (or_819 & or_823) | (or_815 & (or_819 | or_823));
  // hls/stages/count_bits.hpp:24
  logic parity_872;
  assign parity_872 = ^{or_869, or_865, or_861};
  logic parity_875;
  assign parity_875 = ^{or_869, or_865, or_861, or_854, or_850, or_846, or_839, or_835, and_831};
  // hls/stages/count_bits.hpp:25
  logic or_879;
  assign or_879 = (parity_857 & parity_872) | ((^{or_839, or_835, and_831}) & (parity_857 | parity_872));
  logic or_883;
  assign or_883 = (or_835 & or_839) | (and_831 & (or_835 | or_839));
  logic or_887;
  assign or_887 = (or_850 & or_854) | (or_846 & (or_850 | or_854));
  logic or_891;
  assign or_891 = (or_865 & or_869) | (or_861 & (or_865 | or_869));
  // hls/stages/count_bits.hpp:24
  logic parity_896;
  assign parity_896 = ^{or_891, or_887, or_883, or_879};
  // hls/stages/count_bits.hpp:25
  logic or_900;
  assign or_900 = (or_887 & or_891) | (or_883 & (or_887 | or_891));
  logic and_901;
  assign and_901 = or_879 & (^{or_891, or_887, or_883});
  // hls/stages/count_bits.hpp:24
  logic xor_902;
  assign xor_902 = or_900 ^ and_901;
  // hls/stages/count_bits.hpp:27
  logic and_903;
  assign and_903 = or_900 & and_901;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_904;
  assign select_904 = equal_535_s1_q ? {and_903, xor_902, parity_896, parity_875, xor_830, xor_735} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_533_s1_q ? 6'h0 : select_904;
  // hls/stages/agreement.hpp:766
  logic [5:0] select_906;
  assign select_906 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_907;
  assign difference_907 = {1'b0, column_2} - {1'b0, select_906};
  logic [7:0] sum_909;
  assign sum_909 = {difference_907[6], difference_907} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:673
  logic [11:0] select_913;
  assign select_913 = and_660 ? (and_684 ? (~(select_685 ^ select_663)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_919;
  assign parity_919 = ^select_913[5:3];
  logic parity_922;
  assign parity_922 = ^select_913[8:6];
  logic parity_925;
  assign parity_925 = ^select_913[11:3];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_932;
  assign select_932 = and_683 ? (and_701 ? (~(select_702 ^ select_686)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_935;
  assign parity_935 = ^select_932[8:6];
  logic parity_938;
  assign parity_938 = ^select_932[11:9];
  // hls/stages/agreement.hpp:215
  logic and_942;
  assign and_942 = right_codes_rdata_q[77] & not_541_s1_q;
  logic [11:0] select_943;
  assign select_943 = less_540_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_947;
  assign select_947 = and_700 ? (and_942 ? (~(select_943 ^ select_703)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_953;
  assign parity_953 = ^select_947[2:0];
  logic parity_956;
  assign parity_956 = ^select_947[5:3];
  logic parity_959;
  assign parity_959 = ^select_947[8:0];
  logic parity_965;
  assign parity_965 = ^select_947[11:9];
  logic parity_968;
  assign parity_968 = ^select_932[2:0];
  logic parity_971;
  assign parity_971 = ^{select_947[11:9], select_932[5:0]};
  logic parity_974;
  assign parity_974 = ^{select_947, select_932, select_913[2:0]};
  logic xor_975;
  assign xor_975 = parity_925 ^ parity_974;
  // hls/stages/count_bits.hpp:23
  logic or_979;
  assign or_979 = (select_913[1:0] == 2'h3) | (select_913[2] & (select_913[0] | select_913[1]));
  // hls/stages/count_bits.hpp:25
  logic or_983;
  assign or_983 = (select_932[7:6] == 2'h3) | (select_932[8] & (select_932[6] | select_932[7]));
  logic or_987;
  assign or_987 = (select_932[10:9] == 2'h3) | (select_932[11] & (select_932[9] | select_932[10]));
  // hls/stages/count_bits.hpp:23
  logic or_995;
  assign or_995 = (select_947[7:6] == 2'h3) | (select_947[8] & (~(select_947[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_999;
  assign or_999 = (select_947[1:0] == 2'h3) | (select_947[2] & (select_947[0] | select_947[1]));
  logic or_1003;
  assign or_1003 = (select_947[4:3] == 2'h3) | (select_947[5] & (select_947[3] | select_947[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1006;
  assign parity_1006 = ^{or_1003, or_999, or_995};
  // hls/stages/count_bits.hpp:23
  logic or_1010;
  assign or_1010 = (select_932[4:3] == 2'h3) | (select_932[5] & (select_932[3] | select_932[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1014;
  assign or_1014 = (select_947[10:9] == 2'h3) | (select_947[11] & (select_947[9] | select_947[10]));
  logic or_1018;
  assign or_1018 = (select_932[1:0] == 2'h3) | (select_932[2] & (select_932[0] | select_932[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1021;
  assign parity_1021 = ^{or_1018, or_1014, or_1010};
  logic parity_1024;
  assign parity_1024 = ^{or_1018, or_1014, or_1010, or_1003, or_999, or_995, or_987, or_983, or_979};
  // hls/stages/count_bits.hpp:25
  logic and_1025;
  assign and_1025 = parity_925 & parity_974;
  logic or_1029;
  assign or_1029 = (parity_919 & parity_922) | ((^select_913[11:9]) & (parity_919 | parity_922));
  logic and_1032;
  assign and_1032 = (^{select_932[11:6], select_913[2:0]}) & (parity_959 | parity_971);
  logic or_1033;
  assign or_1033 = (parity_959 & parity_971) | and_1032;
  // hls/stages/count_bits.hpp:23
  logic or_1040;
  assign or_1040 = (select_913[10:9] == 2'h3) | (select_913[11] & (select_913[9] | select_913[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1044;
  assign or_1044 = (select_913[4:3] == 2'h3) | (select_913[5] & (select_913[3] | select_913[4]));
  logic or_1048;
  assign or_1048 = (select_913[7:6] == 2'h3) | (select_913[8] & (select_913[6] | select_913[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1051;
  assign parity_1051 = ^{or_1048, or_1044, or_1040};
  // hls/stages/count_bits.hpp:25
  logic or_1055;
  assign or_1055 = (parity_935 & parity_938) | ((^select_913[2:0]) & (parity_935 | parity_938));
  logic or_1059;
  assign or_1059 = (parity_953 & parity_956) | ((^select_947[8:6]) & (parity_953 | parity_956));
  logic or_1063;
  assign or_1063 = (parity_965 & parity_968) | ((^select_932[5:3]) & (parity_965 | parity_968));
  // hls/stages/count_bits.hpp:24
  logic parity_1066;
  assign parity_1066 = ^{or_1063, or_1059, or_1055};
  logic parity_1069;
  assign parity_1069 = ^{or_1063, or_1059, or_1055, or_1048, or_1044, or_1040, or_1033, or_1029, and_1025};
  logic xor_1070;
  assign xor_1070 = parity_1024 ^ parity_1069;
  // hls/stages/count_bits.hpp:25
  logic and_1071;
  assign and_1071 = parity_1024 & parity_1069;
  logic or_1075;
  assign or_1075 = (parity_1006 & parity_1021) | ((^{or_987, or_983, or_979}) & (parity_1006 | parity_1021));
  logic or_1079;
  assign or_1079 = (parity_1051 & parity_1066) | ((^{or_1033, or_1029, and_1025}) & (parity_1051 | parity_1066));
  logic or_1086;
  assign or_1086 = (or_983 & or_987) | (or_979 & (or_983 | or_987));
  logic or_1090;
  assign or_1090 = (or_999 & or_1003) | (or_995 & (or_999 | or_1003));
  logic or_1094;
  assign or_1094 = (or_1014 & or_1018) | (or_1010 & (or_1014 | or_1018));
  // hls/stages/count_bits.hpp:24
  logic parity_1097;
  assign parity_1097 = ^{or_1094, or_1090, or_1086};
  // hls/stages/count_bits.hpp:25
  logic or_1101;
  assign or_1101 = (or_1029 & or_1033) | (and_1025 & (or_1029 | or_1033));
  logic or_1105;
  assign or_1105 = (or_1044 & or_1048) | (or_1040 & (or_1044 | or_1048));
  logic or_1109;
  assign or_1109 = (or_1059 & or_1063) | (or_1055 & (or_1059 | or_1063));
  // hls/stages/count_bits.hpp:24
  logic parity_1112;
  assign parity_1112 = ^{or_1109, or_1105, or_1101};
  logic parity_1115;
  assign parity_1115 = ^{or_1109, or_1105, or_1101, or_1094, or_1090, or_1086, or_1079, or_1075, and_1071};
  // hls/stages/count_bits.hpp:25
  logic or_1119;
  assign or_1119 = (parity_1097 & parity_1112) | ((^{or_1079, or_1075, and_1071}) & (parity_1097 | parity_1112));
  logic or_1123;
  assign or_1123 = (or_1075 & or_1079) | (and_1071 & (or_1075 | or_1079));
  logic or_1127;
  assign or_1127 = (or_1090 & or_1094) | (or_1086 & (or_1090 | or_1094));
  logic or_1131;
  assign or_1131 = (or_1105 & or_1109) | (or_1101 & (or_1105 | or_1109));
  // hls/stages/count_bits.hpp:24
  logic parity_1136;
  assign parity_1136 = ^{or_1131, or_1127, or_1123, or_1119};
  // hls/stages/count_bits.hpp:25
  logic or_1140;
  assign or_1140 = (or_1127 & or_1131) | (or_1123 & (or_1127 | or_1131));
  logic and_1141;
  assign and_1141 = or_1119 & (^{or_1131, or_1127, or_1123});
  // hls/stages/count_bits.hpp:24
  logic xor_1142;
  assign xor_1142 = or_1140 ^ and_1141;
  // hls/stages/count_bits.hpp:27
  logic and_1143;
  assign and_1143 = or_1140 & and_1141;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_1144;
  assign select_1144 = equal_535_s1_q ? {and_1143, xor_1142, parity_1136, parity_1115, xor_1070, xor_975} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_533_s1_q ? 6'h0 : select_1144;
  // hls/stages/agreement.hpp:766
  logic [5:0] select_1146;
  assign select_1146 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1147;
  assign difference_1147 = {1'b0, column_3} - {1'b0, select_1146};
  logic [7:0] sum_1149;
  assign sum_1149 = {difference_1147[6], difference_1147} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:215
  logic and_1150;
  assign and_1150 = right_codes_rdata_q[25] & not_541_s1_q;
  logic [11:0] select_1151;
  assign select_1151 = less_540_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1155;
  assign select_1155 = and_660 ? (and_1150 ? (~(select_1151 ^ select_663)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1161;
  assign parity_1161 = ^select_1155[5:3];
  logic parity_1164;
  assign parity_1164 = ^select_1155[8:6];
  logic parity_1167;
  assign parity_1167 = ^select_1155[11:3];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1174;
  assign select_1174 = and_683 ? (and_661 ? (~(select_662 ^ select_686)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1177;
  assign parity_1177 = ^select_1174[8:6];
  logic parity_1180;
  assign parity_1180 = ^select_1174[11:9];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1187;
  assign select_1187 = and_700 ? (and_684 ? (~(select_685 ^ select_703)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1193;
  assign parity_1193 = ^select_1187[2:0];
  logic parity_1196;
  assign parity_1196 = ^select_1187[5:3];
  logic parity_1199;
  assign parity_1199 = ^select_1187[8:0];
  logic parity_1205;
  assign parity_1205 = ^select_1187[11:9];
  logic parity_1208;
  assign parity_1208 = ^select_1174[2:0];
  logic parity_1211;
  assign parity_1211 = ^{select_1187[11:9], select_1174[5:0]};
  logic parity_1214;
  assign parity_1214 = ^{select_1187, select_1174, select_1155[2:0]};
  logic xor_1215;
  assign xor_1215 = parity_1167 ^ parity_1214;
  // hls/stages/count_bits.hpp:23
  logic or_1219;
  assign or_1219 = (select_1155[1:0] == 2'h3) | (select_1155[2] & (select_1155[0] | select_1155[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1223;
  assign or_1223 = (select_1174[7:6] == 2'h3) | (select_1174[8] & (select_1174[6] | select_1174[7]));
  logic or_1227;
  assign or_1227 = (select_1174[10:9] == 2'h3) | (select_1174[11] & (select_1174[9] | select_1174[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1235;
  assign or_1235 = (select_1187[7:6] == 2'h3) | (select_1187[8] & (~(select_1187[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1239;
  assign or_1239 = (select_1187[1:0] == 2'h3) | (select_1187[2] & (select_1187[0] | select_1187[1]));
  logic or_1243;
  assign or_1243 = (select_1187[4:3] == 2'h3) | (select_1187[5] & (select_1187[3] | select_1187[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1246;
  assign parity_1246 = ^{or_1243, or_1239, or_1235};
  // hls/stages/count_bits.hpp:23
  logic or_1250;
  assign or_1250 = (select_1174[4:3] == 2'h3) | (select_1174[5] & (select_1174[3] | select_1174[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1254;
  assign or_1254 = (select_1187[10:9] == 2'h3) | (select_1187[11] & (select_1187[9] | select_1187[10]));
  logic or_1258;
  assign or_1258 = (select_1174[1:0] == 2'h3) | (select_1174[2] & (select_1174[0] | select_1174[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1261;
  assign parity_1261 = ^{or_1258, or_1254, or_1250};
  logic parity_1264;
  assign parity_1264 = ^{or_1258, or_1254, or_1250, or_1243, or_1239, or_1235, or_1227, or_1223, or_1219};
  // hls/stages/count_bits.hpp:25
  logic and_1265;
  assign and_1265 = parity_1167 & parity_1214;
  logic or_1269;
  assign or_1269 = (parity_1161 & parity_1164) | ((^select_1155[11:9]) & (parity_1161 | parity_1164));
  logic and_1272;
  assign and_1272 = (^{select_1174[11:6], select_1155[2:0]}) & (parity_1199 | parity_1211);
  logic or_1273;
  assign or_1273 = (parity_1199 & parity_1211) | and_1272;
  // hls/stages/count_bits.hpp:23
  logic or_1280;
  assign or_1280 = (select_1155[10:9] == 2'h3) | (select_1155[11] & (select_1155[9] | select_1155[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1284;
  assign or_1284 = (select_1155[4:3] == 2'h3) | (select_1155[5] & (select_1155[3] | select_1155[4]));
  logic or_1288;
  assign or_1288 = (select_1155[7:6] == 2'h3) | (select_1155[8] & (select_1155[6] | select_1155[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1291;
  assign parity_1291 = ^{or_1288, or_1284, or_1280};
  // hls/stages/count_bits.hpp:25
  logic or_1295;
  assign or_1295 = (parity_1177 & parity_1180) | ((^select_1155[2:0]) & (parity_1177 | parity_1180));
  logic or_1299;
  assign or_1299 = (parity_1193 & parity_1196) | ((^select_1187[8:6]) & (parity_1193 | parity_1196));
  logic or_1303;
  assign or_1303 = (parity_1205 & parity_1208) | ((^select_1174[5:3]) & (parity_1205 | parity_1208));
  // hls/stages/count_bits.hpp:24
  logic parity_1306;
  assign parity_1306 = ^{or_1303, or_1299, or_1295};
  logic parity_1309;
  assign parity_1309 = ^{or_1303, or_1299, or_1295, or_1288, or_1284, or_1280, or_1273, or_1269, and_1265};
  logic xor_1310;
  assign xor_1310 = parity_1264 ^ parity_1309;
  // hls/stages/count_bits.hpp:25
  logic and_1311;
  assign and_1311 = parity_1264 & parity_1309;
  logic or_1315;
  assign or_1315 = (parity_1246 & parity_1261) | ((^{or_1227, or_1223, or_1219}) & (parity_1246 | parity_1261));
  logic or_1319;
  assign or_1319 = (parity_1291 & parity_1306) | ((^{or_1273, or_1269, and_1265}) & (parity_1291 | parity_1306));
  logic or_1326;
  assign or_1326 = (or_1223 & or_1227) | (or_1219 & (or_1223 | or_1227));
  logic or_1330;
  assign or_1330 = (or_1239 & or_1243) | (or_1235 & (or_1239 | or_1243));
  logic or_1334;
  assign or_1334 = (or_1254 & or_1258) | (or_1250 & (or_1254 | or_1258));
  // hls/stages/count_bits.hpp:24
  logic parity_1337;
  assign parity_1337 = ^{or_1334, or_1330, or_1326};
  // hls/stages/count_bits.hpp:25
  logic or_1341;
  assign or_1341 = (or_1269 & or_1273) | (and_1265 & (or_1269 | or_1273));
  logic or_1345;
  assign or_1345 = (or_1284 & or_1288) | (or_1280 & (or_1284 | or_1288));
  logic or_1349;
  assign or_1349 = (or_1299 & or_1303) | (or_1295 & (or_1299 | or_1303));
  // hls/stages/count_bits.hpp:24
  logic parity_1352;
  assign parity_1352 = ^{or_1349, or_1345, or_1341};
  logic parity_1355;
  assign parity_1355 = ^{or_1349, or_1345, or_1341, or_1334, or_1330, or_1326, or_1319, or_1315, and_1311};
  // hls/stages/count_bits.hpp:25
  logic or_1359;
  assign or_1359 = (parity_1337 & parity_1352) | ((^{or_1319, or_1315, and_1311}) & (parity_1337 | parity_1352));
  logic or_1363;
  assign or_1363 = (or_1315 & or_1319) | (and_1311 & (or_1315 | or_1319));
  logic or_1367;
  assign or_1367 = (or_1330 & or_1334) | (or_1326 & (or_1330 | or_1334));
  logic or_1371;
  assign or_1371 = (or_1345 & or_1349) | (or_1341 & (or_1345 | or_1349));
  // hls/stages/count_bits.hpp:24
  logic parity_1376;
  assign parity_1376 = ^{or_1371, or_1367, or_1363, or_1359};
  // hls/stages/count_bits.hpp:25
  logic or_1380;
  assign or_1380 = (or_1367 & or_1371) | (or_1363 & (or_1367 | or_1371));
  logic and_1381;
  assign and_1381 = or_1359 & (^{or_1371, or_1367, or_1363});
  // hls/stages/count_bits.hpp:24
  logic xor_1382;
  assign xor_1382 = or_1380 ^ and_1381;
  // hls/stages/count_bits.hpp:27
  logic and_1383;
  assign and_1383 = or_1380 & and_1381;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_1384;
  assign select_1384 = equal_535_s1_q ? {and_1383, xor_1382, parity_1376, parity_1355, xor_1310, xor_1215} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_533_s1_q ? 6'h0 : select_1384;
  // hls/stages/agreement.hpp:766
  logic [5:0] select_1386;
  assign select_1386 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1387;
  assign difference_1387 = {1'b0, column_4} - {1'b0, select_1386};
  logic [7:0] sum_1389;
  assign sum_1389 = {difference_1387[6], difference_1387} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1397;
  assign select_1397 = and_660 ? (and_701 ? (~(select_702 ^ select_663)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1403;
  assign parity_1403 = ^select_1397[5:3];
  logic parity_1406;
  assign parity_1406 = ^select_1397[8:6];
  logic parity_1409;
  assign parity_1409 = ^select_1397[11:3];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1416;
  assign select_1416 = and_683 ? (and_942 ? (~(select_943 ^ select_686)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1419;
  assign parity_1419 = ^select_1416[8:6];
  logic parity_1422;
  assign parity_1422 = ^select_1416[11:9];
  // hls/stages/agreement.hpp:673
  logic [11:0] xor_1428;
  assign xor_1428 = (less_540_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_703;
  logic [11:0] select_1431;
  assign select_1431 = and_700 ? ((right_codes_rdata_q[90] & not_541_s1_q) ? (~xor_1428) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1437;
  assign parity_1437 = ^select_1431[2:0];
  logic parity_1440;
  assign parity_1440 = ^select_1431[5:3];
  logic parity_1443;
  assign parity_1443 = ^select_1431[8:0];
  logic parity_1449;
  assign parity_1449 = ^select_1431[11:9];
  logic parity_1452;
  assign parity_1452 = ^select_1416[2:0];
  logic parity_1455;
  assign parity_1455 = ^{select_1431[11:9], select_1416[5:0]};
  logic parity_1458;
  assign parity_1458 = ^{select_1431, select_1416, select_1397[2:0]};
  logic xor_1459;
  assign xor_1459 = parity_1409 ^ parity_1458;
  // hls/stages/count_bits.hpp:23
  logic or_1463;
  assign or_1463 = (select_1397[1:0] == 2'h3) | (select_1397[2] & (select_1397[0] | select_1397[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1467;
  assign or_1467 = (select_1416[7:6] == 2'h3) | (select_1416[8] & (select_1416[6] | select_1416[7]));
  logic or_1471;
  assign or_1471 = (select_1416[10:9] == 2'h3) | (select_1416[11] & (select_1416[9] | select_1416[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1479;
  assign or_1479 = (select_1431[7:6] == 2'h3) | (select_1431[8] & (~(select_1431[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1483;
  assign or_1483 = (select_1431[1:0] == 2'h3) | (select_1431[2] & (select_1431[0] | select_1431[1]));
  logic or_1487;
  assign or_1487 = (select_1431[4:3] == 2'h3) | (select_1431[5] & (select_1431[3] | select_1431[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1490;
  assign parity_1490 = ^{or_1487, or_1483, or_1479};
  // hls/stages/count_bits.hpp:23
  logic or_1494;
  assign or_1494 = (select_1416[4:3] == 2'h3) | (select_1416[5] & (select_1416[3] | select_1416[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1498;
  assign or_1498 = (select_1431[10:9] == 2'h3) | (select_1431[11] & (select_1431[9] | select_1431[10]));
  logic or_1502;
  assign or_1502 = (select_1416[1:0] == 2'h3) | (select_1416[2] & (select_1416[0] | select_1416[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1505;
  assign parity_1505 = ^{or_1502, or_1498, or_1494};
  logic parity_1508;
  assign parity_1508 = ^{or_1502, or_1498, or_1494, or_1487, or_1483, or_1479, or_1471, or_1467, or_1463};
  // hls/stages/count_bits.hpp:25
  logic and_1509;
  assign and_1509 = parity_1409 & parity_1458;
  logic or_1513;
  assign or_1513 = (parity_1403 & parity_1406) | ((^select_1397[11:9]) & (parity_1403 | parity_1406));
  logic and_1516;
  assign and_1516 = (^{select_1416[11:6], select_1397[2:0]}) & (parity_1443 | parity_1455);
  logic or_1517;
  assign or_1517 = (parity_1443 & parity_1455) | and_1516;
  // hls/stages/count_bits.hpp:23
  logic or_1524;
  assign or_1524 = (select_1397[10:9] == 2'h3) | (select_1397[11] & (select_1397[9] | select_1397[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1528;
  assign or_1528 = (select_1397[4:3] == 2'h3) | (select_1397[5] & (select_1397[3] | select_1397[4]));
  logic or_1532;
  assign or_1532 = (select_1397[7:6] == 2'h3) | (select_1397[8] & (select_1397[6] | select_1397[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1535;
  assign parity_1535 = ^{or_1532, or_1528, or_1524};
  // hls/stages/count_bits.hpp:25
  logic or_1539;
  assign or_1539 = (parity_1419 & parity_1422) | ((^select_1397[2:0]) & (parity_1419 | parity_1422));
  logic or_1543;
  assign or_1543 = (parity_1437 & parity_1440) | ((^select_1431[8:6]) & (parity_1437 | parity_1440));
  logic or_1547;
  assign or_1547 = (parity_1449 & parity_1452) | ((^select_1416[5:3]) & (parity_1449 | parity_1452));
  // hls/stages/count_bits.hpp:24
  logic parity_1550;
  assign parity_1550 = ^{or_1547, or_1543, or_1539};
  logic parity_1553;
  assign parity_1553 = ^{or_1547, or_1543, or_1539, or_1532, or_1528, or_1524, or_1517, or_1513, and_1509};
  logic xor_1554;
  assign xor_1554 = parity_1508 ^ parity_1553;
  // hls/stages/count_bits.hpp:25
  logic and_1555;
  assign and_1555 = parity_1508 & parity_1553;
  logic or_1559;
  assign or_1559 = (parity_1490 & parity_1505) | ((^{or_1471, or_1467, or_1463}) & (parity_1490 | parity_1505));
  logic or_1563;
  assign or_1563 = (parity_1535 & parity_1550) | ((^{or_1517, or_1513, and_1509}) & (parity_1535 | parity_1550));
  logic or_1570;
  assign or_1570 = (or_1467 & or_1471) | (or_1463 & (or_1467 | or_1471));
  logic or_1574;
  assign or_1574 = (or_1483 & or_1487) | (or_1479 & (or_1483 | or_1487));
  logic or_1578;
  assign or_1578 = (or_1498 & or_1502) | (or_1494 & (or_1498 | or_1502));
  // hls/stages/count_bits.hpp:24
  logic parity_1581;
  assign parity_1581 = ^{or_1578, or_1574, or_1570};
  // hls/stages/count_bits.hpp:25
  logic or_1585;
  assign or_1585 = (or_1513 & or_1517) | (and_1509 & (or_1513 | or_1517));
  logic or_1589;
  assign or_1589 = (or_1528 & or_1532) | (or_1524 & (or_1528 | or_1532));
  logic or_1593;
  assign or_1593 = (or_1543 & or_1547) | (or_1539 & (or_1543 | or_1547));
  // hls/stages/count_bits.hpp:24
  logic parity_1596;
  assign parity_1596 = ^{or_1593, or_1589, or_1585};
  logic parity_1599;
  assign parity_1599 = ^{or_1593, or_1589, or_1585, or_1578, or_1574, or_1570, or_1563, or_1559, and_1555};
  // hls/stages/count_bits.hpp:25
  logic or_1603;
  assign or_1603 = (parity_1581 & parity_1596) | ((^{or_1563, or_1559, and_1555}) & (parity_1581 | parity_1596));
  logic or_1607;
  assign or_1607 = (or_1559 & or_1563) | (and_1555 & (or_1559 | or_1563));
  logic or_1611;
  assign or_1611 = (or_1574 & or_1578) | (or_1570 & (or_1574 | or_1578));
  logic or_1615;
  assign or_1615 = (or_1589 & or_1593) | (or_1585 & (or_1589 | or_1593));
  // hls/stages/count_bits.hpp:24
  logic parity_1620;
  assign parity_1620 = ^{or_1615, or_1611, or_1607, or_1603};
  // hls/stages/count_bits.hpp:25
  logic or_1624;
  assign or_1624 = (or_1611 & or_1615) | (or_1607 & (or_1611 | or_1615));
  logic and_1625;
  assign and_1625 = or_1603 & (^{or_1615, or_1611, or_1607});
  // hls/stages/count_bits.hpp:24
  logic xor_1626;
  assign xor_1626 = or_1624 ^ and_1625;
  // hls/stages/count_bits.hpp:27
  logic and_1627;
  assign and_1627 = or_1624 & and_1625;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_1628;
  assign select_1628 = equal_535_s1_q ? {and_1627, xor_1626, parity_1620, parity_1599, xor_1554, xor_1459} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_533_s1_q ? 6'h0 : select_1628;
  // hls/stages/agreement.hpp:766
  logic [5:0] select_1630;
  assign select_1630 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1631;
  assign difference_1631 = {1'b0, column_5} - {1'b0, select_1630};
  logic [7:0] sum_1633;
  assign sum_1633 = {difference_1631[6], difference_1631} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:673
  logic [11:0] not_1637;
  assign not_1637 = ~((less_540_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_663);
  logic [11:0] select_1639;
  assign select_1639 = and_660 ? ((right_codes_rdata_q[12] & not_541_s1_q) ? not_1637 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1645;
  assign parity_1645 = ^select_1639[5:3];
  logic parity_1648;
  assign parity_1648 = ^select_1639[8:6];
  logic parity_1651;
  assign parity_1651 = ^select_1639[11:3];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1658;
  assign select_1658 = and_683 ? (and_1150 ? (~(select_1151 ^ select_686)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1661;
  assign parity_1661 = ^select_1658[8:6];
  logic parity_1664;
  assign parity_1664 = ^select_1658[11:9];
  // hls/stages/agreement.hpp:673
  logic [11:0] select_1671;
  assign select_1671 = and_700 ? (and_661 ? (~(select_662 ^ select_703)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1677;
  assign parity_1677 = ^select_1671[2:0];
  logic parity_1680;
  assign parity_1680 = ^select_1671[5:3];
  logic parity_1683;
  assign parity_1683 = ^select_1671[8:0];
  logic parity_1689;
  assign parity_1689 = ^select_1671[11:9];
  logic parity_1692;
  assign parity_1692 = ^select_1658[2:0];
  logic parity_1695;
  assign parity_1695 = ^{select_1671[11:9], select_1658[5:0]};
  logic parity_1698;
  assign parity_1698 = ^{select_1671, select_1658, select_1639[2:0]};
  logic xor_1699;
  assign xor_1699 = parity_1651 ^ parity_1698;
  // hls/stages/count_bits.hpp:23
  logic or_1703;
  assign or_1703 = (select_1639[1:0] == 2'h3) | (select_1639[2] & (select_1639[0] | select_1639[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1707;
  assign or_1707 = (select_1658[7:6] == 2'h3) | (select_1658[8] & (select_1658[6] | select_1658[7]));
  logic or_1711;
  assign or_1711 = (select_1658[10:9] == 2'h3) | (select_1658[11] & (select_1658[9] | select_1658[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1719;
  assign or_1719 = (select_1671[7:6] == 2'h3) | (select_1671[8] & (~(select_1671[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1723;
  assign or_1723 = (select_1671[1:0] == 2'h3) | (select_1671[2] & (select_1671[0] | select_1671[1]));
  logic or_1727;
  assign or_1727 = (select_1671[4:3] == 2'h3) | (select_1671[5] & (select_1671[3] | select_1671[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1730;
  assign parity_1730 = ^{or_1727, or_1723, or_1719};
  // hls/stages/count_bits.hpp:23
  logic or_1734;
  assign or_1734 = (select_1658[4:3] == 2'h3) | (select_1658[5] & (select_1658[3] | select_1658[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1738;
  assign or_1738 = (select_1671[10:9] == 2'h3) | (select_1671[11] & (select_1671[9] | select_1671[10]));
  logic or_1742;
  assign or_1742 = (select_1658[1:0] == 2'h3) | (select_1658[2] & (select_1658[0] | select_1658[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1745;
  assign parity_1745 = ^{or_1742, or_1738, or_1734};
  logic parity_1748;
  assign parity_1748 = ^{or_1742, or_1738, or_1734, or_1727, or_1723, or_1719, or_1711, or_1707, or_1703};
  // hls/stages/count_bits.hpp:25
  logic and_1749;
  assign and_1749 = parity_1651 & parity_1698;
  logic or_1753;
  assign or_1753 = (parity_1645 & parity_1648) | ((^select_1639[11:9]) & (parity_1645 | parity_1648));
  logic and_1756;
  assign and_1756 = (^{select_1658[11:6], select_1639[2:0]}) & (parity_1683 | parity_1695);
  logic or_1757;
  assign or_1757 = (parity_1683 & parity_1695) | and_1756;
  // hls/stages/count_bits.hpp:23
  logic or_1764;
  assign or_1764 = (select_1639[10:9] == 2'h3) | (select_1639[11] & (select_1639[9] | select_1639[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1768;
  assign or_1768 = (select_1639[4:3] == 2'h3) | (select_1639[5] & (select_1639[3] | select_1639[4]));
  logic or_1772;
  assign or_1772 = (select_1639[7:6] == 2'h3) | (select_1639[8] & (select_1639[6] | select_1639[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1775;
  assign parity_1775 = ^{or_1772, or_1768, or_1764};
  // hls/stages/count_bits.hpp:25
  logic or_1779;
  assign or_1779 = (parity_1661 & parity_1664) | ((^select_1639[2:0]) & (parity_1661 | parity_1664));
  logic or_1783;
  assign or_1783 = (parity_1677 & parity_1680) | ((^select_1671[8:6]) & (parity_1677 | parity_1680));
  logic or_1787;
  assign or_1787 = (parity_1689 & parity_1692) | ((^select_1658[5:3]) & (parity_1689 | parity_1692));
  // hls/stages/count_bits.hpp:24
  logic parity_1790;
  assign parity_1790 = ^{or_1787, or_1783, or_1779};
  logic parity_1793;
  assign parity_1793 = ^{or_1787, or_1783, or_1779, or_1772, or_1768, or_1764, or_1757, or_1753, and_1749};
  logic xor_1794;
  assign xor_1794 = parity_1748 ^ parity_1793;
  // hls/stages/count_bits.hpp:25
  logic and_1795;
  assign and_1795 = parity_1748 & parity_1793;
  logic or_1799;
  assign or_1799 = (parity_1730 & parity_1745) | ((^{or_1711, or_1707, or_1703}) & (parity_1730 | parity_1745));
  logic or_1803;
  assign or_1803 = (parity_1775 & parity_1790) | ((^{or_1757, or_1753, and_1749}) & (parity_1775 | parity_1790));
  logic or_1810;
  assign or_1810 = (or_1707 & or_1711) | (or_1703 & (or_1707 | or_1711));
  logic or_1814;
  assign or_1814 = (or_1723 & or_1727) | (or_1719 & (or_1723 | or_1727));
  logic or_1818;
  assign or_1818 = (or_1738 & or_1742) | (or_1734 & (or_1738 | or_1742));
  // hls/stages/count_bits.hpp:24
  logic parity_1821;
  assign parity_1821 = ^{or_1818, or_1814, or_1810};
  // hls/stages/count_bits.hpp:25
  logic or_1825;
  assign or_1825 = (or_1753 & or_1757) | (and_1749 & (or_1753 | or_1757));
  logic or_1829;
  assign or_1829 = (or_1768 & or_1772) | (or_1764 & (or_1768 | or_1772));
  logic or_1833;
  assign or_1833 = (or_1783 & or_1787) | (or_1779 & (or_1783 | or_1787));
  // hls/stages/count_bits.hpp:24
  logic parity_1836;
  assign parity_1836 = ^{or_1833, or_1829, or_1825};
  logic parity_1839;
  assign parity_1839 = ^{or_1833, or_1829, or_1825, or_1818, or_1814, or_1810, or_1803, or_1799, and_1795};
  // hls/stages/count_bits.hpp:25
  logic or_1843;
  assign or_1843 = (parity_1821 & parity_1836) | ((^{or_1803, or_1799, and_1795}) & (parity_1821 | parity_1836));
  logic or_1847;
  assign or_1847 = (or_1799 & or_1803) | (and_1795 & (or_1799 | or_1803));
  logic or_1851;
  assign or_1851 = (or_1814 & or_1818) | (or_1810 & (or_1814 | or_1818));
  logic or_1855;
  assign or_1855 = (or_1829 & or_1833) | (or_1825 & (or_1829 | or_1833));
  // hls/stages/count_bits.hpp:24
  logic parity_1860;
  assign parity_1860 = ^{or_1855, or_1851, or_1847, or_1843};
  // hls/stages/count_bits.hpp:25
  logic or_1864;
  assign or_1864 = (or_1851 & or_1855) | (or_1847 & (or_1851 | or_1855));
  logic and_1865;
  assign and_1865 = or_1843 & (^{or_1855, or_1851, or_1847});
  // hls/stages/count_bits.hpp:24
  logic xor_1866;
  assign xor_1866 = or_1864 ^ and_1865;
  // hls/stages/count_bits.hpp:27
  logic and_1867;
  assign and_1867 = or_1864 & and_1865;
  // hls/stages/agreement.hpp:144
  logic [5:0] select_1868;
  assign select_1868 = equal_535_s1_q ? {and_1867, xor_1866, parity_1860, parity_1839, xor_1794, xor_1699} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_533_s1_q ? 6'h0 : select_1868;
  // hls/stages/agreement.hpp:766
  logic [5:0] select_1870;
  assign select_1870 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1871;
  assign difference_1871 = {1'b0, column_6} - {1'b0, select_1870};
  logic [7:0] sum_1873;
  assign sum_1873 = {difference_1871[6], difference_1871} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:940
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:941
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:942
  logic [6:0] select_1930;
  assign select_1930 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:945
  logic and_1950;
  assign and_1950 = (or_533_s1_q & (left_rdata_q[61] & not_541_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:238
  logic or_1972;
  assign or_1972 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:776
  logic [6:0] select_1983;
  assign select_1983 = so_s1_q ? x_s1_q[6:0] : (or_533_s1_q ? (less_540_s1_q ? 7'h0 : select_1930) : 7'h0);
  // hls/stages/patches.hpp:122
  logic and_2057;
  assign and_2057 = (select_476_s1_q == 3'h0) & (select_478_s1_q == 7'h0);
  // hls/stages/patches.hpp:391
  logic not_2058;
  assign not_2058 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_2061;
  assign not_2061 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:361
  logic and_2062;
  assign and_2062 = patches_capturing_q & not_2061;
  // hls/stages/patches.hpp:311
  logic equal_2065;
  assign equal_2065 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2070;
  assign and_2070 = (not_2058 & (patches_work_q == 3'h0)) & (~(and_2062 | ((~equal_2063_s1_q) | (~equal_2065))));
  // hls/stages/patches.hpp:529
  logic equal_2157;
  assign equal_2157 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:507
  logic not_2158;
  assign not_2158 = ~equal_2157;
  // hls/stages/patches.hpp:500
  logic equal_2159;
  assign equal_2159 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:453
  logic not_2160;
  assign not_2160 = ~equal_2159;
  // hls/stages/patches.hpp:494
  logic equal_2161;
  assign equal_2161 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_2162;
  assign equal_2162 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:529
  logic or_2163;
  assign or_2163 = equal_2161 | equal_2162;
  // hls/stages/patches.hpp:455
  logic not_2164;
  assign not_2164 = ~patches_second_q;
  // hls/stages/patches.hpp:372
  logic [4:0] select_2186;
  assign select_2186 = and_2070 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2187;
  assign select_2187 = and_2057 ? select_2186 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2189;
  assign and_2189 = and_2062 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2193;
  assign select_2193 = and_2057 ? (and_2070 | (and_2062 & (~and_2189))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_2201;
  assign and_2201 = not_2158 & (not_2160 & (or_2163 & (patches_second_q & equal_2162)));
  // hls/stages/patches.hpp:167
  logic not_2218;
  assign not_2218 = ~equal_2162;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_2234;
  assign select_2234 = and_2057 ? {select_2186[4], select_2186[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:453
  logic and_2244;
  assign and_2244 = not_2158 & (or_2163 & not_2160);
  // hls/stages/agreement.hpp:447
  logic [5:0] or_2628;
  assign or_2628 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:451
  logic select_2847;
  assign select_2847 = equal_2753_s1_q ? (~({row_s1_q, 1'b0} < {sum_2844, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:511
  logic and_3044;
  assign and_3044 = and_512_s1_q & (equal_2753_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3154;
  assign select_3154 = and_2057 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_3155;
  assign select_3155 = sample_pair_whole_s1_q ? select_3154 : patches_phase_q;
  // hls/stages/patches.hpp:372
  logic and_3156;
  assign and_3156 = not_2061 & equal_2063_s1_q;
  logic [8:0] select_3157;
  assign select_3157 = and_3156 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3158;
  assign select_3158 = and_3156 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3159;
  assign select_3159 = sample_pair_first_s1_q ? select_3157 : select_3158;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_3161;
  assign select_3161 = sample_pair_whole_s1_q ? (and_2057 ? select_3159[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3163;
  assign select_3163 = sample_pair_whole_s1_q ? (and_2057 ? select_3159[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3166;
  assign select_3166 = sample_pair_whole_s1_q ? (equal_2065 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3168;
  assign select_3168 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_2065}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_3169;
  assign equal_3169 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_3170;
  assign not_3170 = ~equal_3169;
  // hls/stages/agreement.hpp:267
  logic [3:0] select_3172;
  assign select_3172 = sample_pair_whole_s1_q ? (phase + {not_3170, 1'b1, not_3170, equal_3169}) : patches_first_band_rows_to_next_q;
  logic select_3173;
  assign select_3173 = sample_pair_whole_s1_q ? equal_3169 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:461
  logic equal_3174;
  assign equal_3174 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3178;
  assign select_3178 = equal_3174 ? ((select_3155 == 4'h6) ? 4'h0 : (select_3155 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3179;
  assign equal_3179 = select_3178 == 4'h0;
  // hls/stages/agreement.hpp:451
  logic [3:0] select_3182;
  assign select_3182 = equal_2753_s1_q ? (equal_3179 ? 4'h6 : (select_3178 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3184;
  assign select_3184 = equal_3174 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:451
  logic [4:0] select_3186;
  assign select_3186 = equal_2753_s1_q ? (select_3184 + {4'h0, equal_3179}) : patches_choosing_number_q;
  logic select_3190;
  assign select_3190 = equal_2753_s1_q ? ((6'h2 < row_s1_q) & equal_3179) : patches_chooses_q;
  // hls/stages/agreement.hpp:511
  logic [4:0] select_3193;
  assign select_3193 = and_512_s1_q ? (equal_2753_s1_q ? select_3184 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:126
  logic select_3222;
  assign select_3222 = and_2057 ? (and_2070 ? not_3220_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:392
  logic or_3261;
  assign or_3261 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:394
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3267;
  assign and_3267 = equal_2157 & not_2164;
  // hls/stages/patches.hpp:398
  logic and_3268;
  assign and_3268 = not_2218 & and_3267;
  logic [1:0] select_3270;
  assign select_3270 = equal_2159 ? 2'h0 : (equal_2161 ? 2'h3 : {equal_2162, and_3268});
  // hls/stages/patches.hpp:279
  logic equal_3272;
  assign equal_3272 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3273;
  assign not_3273 = ~equal_3272;
  // hls/stages/patches.hpp:279
  logic equal_3274;
  assign equal_3274 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3275;
  assign not_3275 = ~equal_3274;
  // hls/stages/patches.hpp:283
  logic not_3277;
  assign not_3277 = ~(patches_following_q == 3'h2);
  logic and_3280;
  assign and_3280 = (~(patches_following_q == 3'h1)) & not_3277;
  // hls/stages/patches.hpp:396
  logic [1:0] select_3281;
  assign select_3281 = equal_3274 ? 2'h2 : {and_3280, not_3277};
  logic [3:0] select_3282;
  assign select_3282 = equal_3272 ? 4'h2 : {select_3281, {2{not_3275}}};
  // hls/stages/patches.hpp:404
  logic not_3285;
  assign not_3285 = ~or_3261;
  // hls/stages/patches.hpp:393
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:405
  logic [11:0] select_3290;
  assign select_3290 = or_3261 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3292;
  assign select_3292 = or_3261 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1313; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_533_s1_q ? select_1930 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_654_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s1_en & (not_2158 & (not_2160 & (or_2163 & (equal_2162 & not_2164))));
  logic [8:0] patches_right_0_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_word_q <= patches_right_0_mem[patches_right_0_raddr];
  end
  logic [7:0] patches_right_0_rdata_q;
  assign patches_right_0_rdata_q = patches_right_0_word_q[7:0];
  logic patches_right_0_read_q, patches_right_0_error;
  always_ff @(posedge clk_i) patches_right_0_read_q <= rst_ni & patches_right_0_re;
  assign patches_right_0_error = patches_right_0_read_q & ^patches_right_0_word_q;

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s1_en & and_2201;
  logic [8:0] patches_right_1_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_word_q <= patches_right_1_mem[patches_right_1_raddr];
  end
  logic [7:0] patches_right_1_rdata_q;
  assign patches_right_1_rdata_q = patches_right_1_word_q[7:0];
  logic patches_right_1_read_q, patches_right_1_error;
  always_ff @(posedge clk_i) patches_right_1_read_q <= rst_ni & patches_right_1_re;
  assign patches_right_1_error = patches_right_1_read_q & ^patches_right_1_word_q;

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s1_en & (not_2158 & (not_2160 & (not_2218 & or_2163)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:786; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign patches_columns_above_re = s1_en & and_2244;
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
  assign left_we = s1_en & and_544_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_636, left_rdata_q[59:45], and_635, left_rdata_q[43:29], and_634, left_rdata_q[27:13], and_633, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_544_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_645, right_codes_rdata_q[76:65], and_644, right_codes_rdata_q[63:52], and_643, right_codes_rdata_q[50:39], and_642, right_codes_rdata_q[37:26], and_641, right_codes_rdata_q[24:13], and_640, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_512_s1_q ? (equal_2753_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_512_s1_q ? select_2847 : lower_half_q;
      patches_phase_q <= select_3155;
      patches_band_rows_rows_to_next_q <= select_3161;
      patches_band_rows_number_q <= select_3163;
      patches_next_band_rows_to_next_q <= select_3166;
      patches_next_band_number_q <= select_3168;
      patches_first_band_rows_to_next_q <= select_3172;
      patches_first_band_number_q <= select_3173;
      patches_choosing_rows_to_next_q <= and_512_s1_q ? select_3182 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_512_s1_q ? select_3186 : patches_choosing_number_q;
      patches_chooses_q <= and_512_s1_q ? select_3190 : patches_chooses_q;
      patches_choosing_band_q <= select_3193;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_2193 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_3222 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_2187 : patches_row_q;
      patches_work_q <= or_3261 ? following : patches_work_q;
      patches_second_q <= not_2058 & (patches_second_q | (patches_ends_q & equal_2157));
      patches_following_q <= equal_2157 ? {2'h0, and_3267} : {equal_2159, select_3270};
      patches_following_beats_q <= {select_3282, not_3273};
      patches_begins_q <= sample_pair_whole_s1_q & (and_2057 & and_2189);
      patches_ends_q <= not_3285 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3290;
      patches_code_row_q <= select_3292;
      patches_column_q <= or_3261 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3285 & (patches_column_q == 5'h1e);
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
      middle_sum_sum_sums_values_0_q <= sum_909;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1149;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1389;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1633;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1873;
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
  logic shift_first_s2_q;
  logic [4:0] patches_band_rows_number_s2_q;
  logic patches_chooses_s2_q;
  logic [4:0] patches_choosing_band_s2_q;
  logic patches_lower_s2_q;
  logic patches_second_s2_q;
  logic [4:0] patches_code_row_s2_q;
  logic [4:0] patches_column_s2_q;
  logic [2:0] select_476_s2_q;
  logic [6:0] select_478_s2_q;
  logic [8:0] select_482_s2_q;
  logic and_486_s2_q;
  logic equal_492_s2_q;
  logic [6:0] column_s2_q;
  logic and_510_s2_q;
  logic and_512_s2_q;
  logic so_s2_q;
  logic equal_532_s2_q;
  logic or_533_s2_q;
  logic less_540_s2_q;
  logic not_541_s2_q;
  logic equal_573_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic and_1926_s2_q;
  logic [6:0] right_s2_q;
  logic equal_1934_s2_q;
  logic equal_1944_s2_q;
  logic and_1951_s2_q;
  logic and_1954_s2_q;
  logic and_1958_s2_q;
  logic or_1972_s2_q;
  logic [6:0] select_1983_s2_q;
  logic and_2057_s2_q;
  logic and_2070_s2_q;
  logic less_2084_s2_q;
  logic equal_2157_s2_q;
  logic not_2158_s2_q;
  logic equal_2159_s2_q;
  logic not_2160_s2_q;
  logic equal_2161_s2_q;
  logic equal_2162_s2_q;
  logic or_2163_s2_q;
  logic [4:0] select_2187_s2_q;
  logic select_2193_s2_q;
  logic [3:0] select_2234_s2_q;
  logic and_2244_s2_q;
  logic and_2483_s2_q;
  logic equal_2629_s2_q;
  logic equal_2753_s2_q;
  logic and_3045_s2_q;
  logic and_3047_s2_q;
  logic or_3261_s2_q;
  logic not_3285_s2_q;
  logic less_4094_s2_q;
  logic equal_4299_s2_q;
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
      shift_first_s2_q <= shift_first_s1_q;
      patches_band_rows_number_s2_q <= patches_band_rows_number_q;
      patches_chooses_s2_q <= patches_chooses_q;
      patches_choosing_band_s2_q <= patches_choosing_band_q;
      patches_lower_s2_q <= patches_lower_q;
      patches_second_s2_q <= patches_second_q;
      patches_code_row_s2_q <= patches_code_row_q;
      patches_column_s2_q <= patches_column_q;
      select_476_s2_q <= select_476_s1_q;
      select_478_s2_q <= select_478_s1_q;
      select_482_s2_q <= select_482_s1_q;
      and_486_s2_q <= and_486_s1_q;
      equal_492_s2_q <= equal_492_s1_q;
      column_s2_q <= column_s1_q;
      and_510_s2_q <= and_510_s1_q;
      and_512_s2_q <= and_512_s1_q;
      so_s2_q <= so_s1_q;
      equal_532_s2_q <= equal_532_s1_q;
      or_533_s2_q <= or_533_s1_q;
      less_540_s2_q <= less_540_s1_q;
      not_541_s2_q <= not_541_s1_q;
      equal_573_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      and_1926_s2_q <= and_1926_s1_q;
      right_s2_q <= right_s1_q;
      equal_1934_s2_q <= equal_1934_s1_q;
      equal_1944_s2_q <= equal_1944_s1_q;
      and_1951_s2_q <= not_541_s1_q & and_1950;
      and_1954_s2_q <= (or_533_s1_q & (left_rdata_q[62] & not_541_s1_q)) & and_1950;
      and_1958_s2_q <= not_541_s1_q & (or_533_s1_q & (left_rdata_q[63] & not_541_s1_q));
      or_1972_s2_q <= or_1972;
      select_1983_s2_q <= select_1983;
      and_2057_s2_q <= and_2057;
      and_2070_s2_q <= and_2070;
      less_2084_s2_q <= 5'h4 < row_q[5:1];
      equal_2157_s2_q <= equal_2157;
      not_2158_s2_q <= not_2158;
      equal_2159_s2_q <= equal_2159;
      not_2160_s2_q <= not_2160;
      equal_2161_s2_q <= equal_2161;
      equal_2162_s2_q <= equal_2162;
      or_2163_s2_q <= or_2163;
      select_2187_s2_q <= select_2187;
      select_2193_s2_q <= select_2193;
      select_2234_s2_q <= select_2234;
      and_2244_s2_q <= and_2244;
      and_2483_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2629_s2_q <= {column_s1_q[6], or_2628} == 7'h0;
      equal_2753_s2_q <= equal_2753_s1_q;
      and_3045_s2_q <= and_2754_s1_q & and_3044;
      and_3047_s2_q <= and_2754_s1_q & (~and_3044);
      or_3261_s2_q <= or_3261;
      not_3285_s2_q <= not_3285;
      less_4094_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4299_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic shift_allowed_q;
  logic shift_not_right_q;
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
  logic and_487;
  assign and_487 = sample_pair_whole_s2_q & and_486_s2_q;
  // hls/stages/agreement.hpp:795
  logic or_657;
  assign or_657 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:796
  logic select_659;
  assign select_659 = or_657 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:739
  logic less_1390;
  assign less_1390 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1391;
  assign select_1391 = less_1390 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1392;
  assign less_1392 = middle_sum_sum_sums_values_0_q < select_1391;
  logic [7:0] select_1393;
  assign select_1393 = less_1392 ? select_1391 : middle_sum_sum_sums_values_0_q;
  logic less_1874;
  assign less_1874 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1875;
  assign select_1875 = less_1874 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1876;
  assign less_1876 = select_1393 < select_1875;
  // hls/stages/agreement.hpp:789
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1876 ? select_1875 : select_1393) : 8'h0;
  // hls/stages/agreement.hpp:796
  logic or_1880;
  assign or_1880 = select_659 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:801
  logic [5:0] select_1881;
  assign select_1881 = or_1880 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:740
  logic or_1883;
  assign or_1883 = less_1390 | (~less_1392);
  logic [2:0] select_1884;
  assign select_1884 = less_1876 ? {less_1874, 2'h0} : {1'b0, or_1883, less_1392};
  // hls/stages/agreement.hpp:801
  logic [2:0] select_1885;
  assign select_1885 = or_1880 ? select_1884 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1886;
  assign select_1886 = or_1880 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:798
  logic equal_1887;
  assign equal_1887 = select_1884 == 3'h1;
  logic or_1890;
  assign or_1890 = equal_1887 | (~(select_1884 == 3'h2));
  logic [7:0] select_1892;
  assign select_1892 = or_1890 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1893;
  assign select_1893 = equal_1887 ? (or_1890 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1892;
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1894;
  assign select_1894 = or_1880 ? select_1893 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:798
  logic [7:0] select_1895;
  assign select_1895 = or_1890 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1897;
  assign select_1897 = or_1880 ? (equal_1887 ? select_1892 : select_1895) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1899;
  assign sum_1899 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1900;
  assign sum_1900 = {1'b0, before_v} + sum_1899;
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1902;
  assign sum_1902 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1903;
  assign sum_1903 = {1'b0, before_v_2} + sum_1902;
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1905;
  assign sum_1905 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1906;
  assign sum_1906 = {1'b0, before_v_3} + sum_1905;
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1908;
  assign select_1908 = (sum_1903 < sum_1906) ? sum_1906 : sum_1903;
  logic [6:0] select_1910;
  assign select_1910 = (sum_1900 < select_1908) ? select_1908 : sum_1900;
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1912;
  assign sum_1912 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1913;
  assign sum_1913 = {1'b0, before_v_4} + sum_1912;
  // hls/stages/agreement.hpp:767
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:768
  logic [6:0] sum_1915;
  assign sum_1915 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1916;
  assign sum_1916 = {1'b0, before_v_5} + sum_1915;
  // hls/stages/agreement.hpp:739
  logic [6:0] select_1918;
  assign select_1918 = (sum_1913 < sum_1916) ? sum_1916 : sum_1913;
  // hls/stages/agreement.hpp:790
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1910 < select_1918) ? select_1918 : select_1910) : 7'h0;
  // hls/stages/agreement.hpp:801
  logic or_1923;
  assign or_1923 = select_659 | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1924;
  assign select_1924 = or_1923 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1925;
  assign select_1925 = or_1923 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:809
  logic select_1935;
  assign select_1935 = or_657 ? shift_first_s2_q : equal_1934_s2_q;
  // hls/stages/agreement.hpp:810
  logic or_1937;
  assign or_1937 = select_1935 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:814
  logic [7:0] select_1938;
  assign select_1938 = or_1937 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1939;
  assign select_1939 = or_1937 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1941;
  assign or_1941 = select_1935 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:818
  logic [6:0] select_1942;
  assign select_1942 = or_1941 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1943;
  assign select_1943 = or_1941 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:968
  logic not_1945;
  assign not_1945 = ~equal_1944_s2_q;
  // hls/stages/agreement.hpp:238
  logic and_1955;
  assign and_1955 = not_541_s2_q & and_1954_s2_q;
  // hls/stages/agreement.hpp:948
  logic select_1961;
  assign select_1961 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:949
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic [8:0] difference_1964;
  assign difference_1964 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:956
  logic [9:0] sum_1965;
  assign sum_1965 = {difference_1964[8], difference_1964} + 10'h1;
  // hls/stages/agreement.hpp:238
  logic and_1967;
  assign and_1967 = (and_1954_s2_q & select_1961) & ({{22{sum_1965[9]}}, sum_1965} < 32'h3);
  logic and_1968;
  assign and_1968 = not_541_s2_q & and_1967;
  logic and_1974;
  assign and_1974 = not_541_s2_q & (and_1967 & or_1972_s2_q);
  // hls/stages/agreement.hpp:144
  logic [8:0] select_1975;
  assign select_1975 = less_540_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_533_s2_q ? {select_1975, and_1974, and_1968, and_1958_s2_q, and_1955, and_1951_s2_q, not_541_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:776
  logic and_1977;
  assign and_1977 = ends_cell_s2_q & shift_2[0];
  logic and_1979;
  assign and_1979 = not_1945 & (so_s2_q & and_1977);
  // hls/stages/agreement.hpp:968
  logic [5:0] sum_2029;
  assign sum_2029 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:253
  logic right_2;
  assign right_2 = shift_2[0] & ({1'b0, sum_2029, last_s2_q[1]} < x_s2_q);
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/registration.hpp:218
  logic [16:0] select_2087;
  assign select_2087 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2087[16:7])) ? 8'h7f : select_2087[7:0];
  // hls/stages/patches.hpp:104
  logic and_2110;
  assign and_2110 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:106
  logic equal_2111;
  assign equal_2111 = x_s2_q == 8'h0;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2117;
  assign sum_2117 = {2'h0, x_s2_q} + {{4{shift_2[11]}}, shift_2[11:6]};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2119;
  assign sum_2119 = {sum_2117[9], sum_2117[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:977
  logic and_2122;
  assign and_2122 = ($signed(9'h0) < $signed(sum_2117[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2119, sum_2117[0]})));
  logic and_2123;
  assign and_2123 = (~(and_2110 | (equal_2111 | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2122;
  // hls/stages/patches.hpp:113
  logic equal_2150;
  assign equal_2150 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:776
  logic and_2154;
  assign and_2154 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (and_2110 | equal_2150)));
  logic and_2155;
  assign and_2155 = not_1945 & and_2154;
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_2162_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2162_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:495
  logic less_2250;
  assign less_2250 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:496
  logic or_2251;
  assign or_2251 = equal_2161_s2_q | less_2250;
  // hls/stages/patches.hpp:499
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2256;
  assign select_2256 = equal_2161_s2_q ? patches_column_s2_q[0] : (or_2251 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2257;
  assign not_2257 = ~or_2251;
  // hls/stages/patches.hpp:496
  logic [4:0] sum_2258;
  assign sum_2258 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:498
  logic [4:0] select_2261;
  assign select_2261 = or_2251 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2258) + 5'h1) : sum_2258;
  // hls/stages/patches.hpp:500
  logic [4:0] select_2262;
  assign select_2262 = equal_2161_s2_q ? 5'h0 : select_2261;
  logic or_2263;
  assign or_2263 = equal_2161_s2_q | equal_2159_s2_q;
  // hls/stages/patches.hpp:476
  logic equal_2265;
  assign equal_2265 = patches_column_s2_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s2_q == 5'h11;
  logic equal_2267;
  assign equal_2267 = patches_column_s2_q == 5'h18;
  // hls/stages/patches.hpp:478
  logic and_2269;
  assign and_2269 = of_row & (~equal_2267);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2265 ? 2'h3 : {equal_2267, and_2269};
  // hls/stages/patches.hpp:464
  logic [8:0] sum_2272;
  assign sum_2272 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2273;
  assign sum_2273 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2272, pixel_2[0]} - {1'b0, sum_2273, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:466
  logic [11:0] sum_2275;
  assign sum_2275 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2276;
  assign sum_2276 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2275[11], sum_2275};
  logic [13:0] sum_2277;
  assign sum_2277 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2276, down_2[1]};
  logic [12:0] sum_2278;
  assign sum_2278 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2277[13:1];
  logic [14:0] sum_2279;
  assign sum_2279 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2278, sum_2277[0], down_2[0]};
  // hls/stages/patches.hpp:462
  logic [8:0] sum_2282;
  assign sum_2282 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2283;
  assign sum_2283 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2282};
  logic [10:0] sum_2284;
  assign sum_2284 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2283, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2285;
  assign sum_2285 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2284[10:1];
  // hls/stages/patches.hpp:463
  logic [11:0] smooth;
  assign smooth = {sum_2285, sum_2284[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:465
  logic [12:0] sum_2287;
  assign sum_2287 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2288;
  assign sum_2288 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2289;
  assign difference_2289 = {1'b0, sum_2287, smooth[0]} - {1'b0, sum_2288, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:477
  logic or_2295;
  assign or_2295 = (((patches_column_s2_q == 5'ha) | of_row) | equal_2267) | equal_2265;
  // hls/stages/patches.hpp:472
  logic and_2300;
  assign and_2300 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_2304;
  assign and_2304 = not_2160_s2_q & (or_2163_s2_q & (or_2295 & (equal_2162_s2_q & and_2300)));
  // hls/stages/patches.hpp:172
  logic and_2314;
  assign and_2314 = (~(equal_2162_s2_q | (~and_2300))) & (~patches_column_s2_q[4]);
  // hls/stages/patches.hpp:184
  logic and_2318;
  assign and_2318 = not_2160_s2_q & (or_2163_s2_q & (and_2314 & (patches_column_s2_q == 5'hf)));
  // hls/stages/patches.hpp:541
  logic less_2320;
  assign less_2320 = patches_step_q[4:0] < 5'h11;
  logic equal_2321;
  assign equal_2321 = patches_step_q[6:5] == 2'h0;
  logic not_2322;
  assign not_2322 = ~equal_2321;
  logic equal_2323;
  assign equal_2323 = patches_step_q[6:5] == 2'h3;
  logic not_2324;
  assign not_2324 = ~equal_2323;
  // hls/stages/patches.hpp:555
  logic select_2327;
  assign select_2327 = equal_2323 ? (less_2320 & (less_2320 & not_2324)) : less_2320;
  // hls/stages/patches.hpp:184
  logic and_2330;
  assign and_2330 = equal_2157_s2_q & (less_2320 ? (not_2322 & select_2327) : select_2327);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2351;
  assign sum_2351 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:253
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:776
  logic and_2487;
  assign and_2487 = ends_cell_s2_q & (and_2483_s2_q & (~({sum_2029, last_s2_q[1:0]} < x_s2_q)));
  logic not_2850;
  assign not_2850 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2851;
  assign less_2851 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/registration.hpp:76
  logic less_2942;
  assign less_2942 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:144
  logic [7:0] select_2944;
  assign select_2944 = or_533_s2_q ? (less_540_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2946;
  assign select_2946 = or_533_s2_q ? (less_540_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2948;
  assign select_2948 = or_533_s2_q ? (less_540_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2946} - {1'b0, select_2948};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2950;
  assign select_2950 = rise[8] ? select_2946 : select_2948;
  logic [8:0] difference_2951;
  assign difference_2951 = {1'b0, select_2944} - {1'b0, select_2950};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2951[8] ? 8'h0 : difference_2951[7:0];
  // hls/stages/registration.hpp:37
  logic not_2953;
  assign not_2953 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2942 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2953};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2955;
  assign xor_2955 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2955};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2961;
  assign select_2961 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2942 ? {taken, 1'b1} : {not_2953, select_2961, not_2953};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2963;
  assign sum_2963 = {left, 1'b1} + {taken_2, less_2942};
  // hls/stages/agreement.hpp:248
  logic [4:0] select_2965;
  assign select_2965 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_3048;
  assign select_3048 = and_3047_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3050;
  assign select_3050 = and_3045_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3048[15]}}, select_3048});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3051;
  assign select_3051 = and_3047_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3051[15]}}, select_3051};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3053;
  assign select_3053 = and_3045_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:144
  logic and_3054;
  assign and_3054 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_8;
  assign column_8 = registration_slope_q + (and_3054 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:91
  logic parity_3197;
  assign parity_3197 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:451
  logic [15:0] select_3198;
  assign select_3198 = equal_2753_s2_q ? {patches_chance_q[14:0], parity_3197} : patches_chance_q;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3203;
  assign select_3203 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3203};
  // hls/stages/agreement.hpp:776
  logic and_3209;
  assign and_3209 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:187
  logic select_3300;
  assign select_3300 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3303;
  assign select_3303 = equal_2159_s2_q ? patches_smooth_values_0_q : (or_2163_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3305;
  assign select_3305 = or_2163_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3307;
  assign select_3307 = equal_2157_s2_q ? patches_smooth_values_1_q : (equal_2159_s2_q ? patches_smooth_values_1_q : select_3305);
  logic [11:0] select_3308;
  assign select_3308 = or_2163_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3310;
  assign select_3310 = equal_2157_s2_q ? patches_smooth_values_2_q : (equal_2159_s2_q ? patches_smooth_values_2_q : select_3308);
  logic [11:0] select_3311;
  assign select_3311 = or_2163_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3313;
  assign select_3313 = equal_2157_s2_q ? patches_smooth_values_3_q : (equal_2159_s2_q ? patches_smooth_values_3_q : select_3311);
  logic [10:0] select_3315;
  assign select_3315 = equal_2159_s2_q ? patches_down_values_0_q : (or_2163_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3318;
  assign select_3318 = equal_2159_s2_q ? patches_down_values_1_q : (or_2163_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3321;
  assign select_3321 = equal_2159_s2_q ? patches_down_values_2_q : (or_2163_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3324;
  assign select_3324 = equal_2159_s2_q ? patches_down_values_3_q : (or_2163_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3361;
  assign and_3361 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:412
  logic [4:0] select_3366;
  assign select_3366 = or_3261_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:414
  logic [3:0] select_3368;
  assign select_3368 = and_3361 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3724;
  assign select_3724 = equal_2157_s2_q ? patches_summed_down_by_q : (equal_2159_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:551
  logic and_3757;
  assign and_3757 = less_2320 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:555
  logic select_3760;
  assign select_3760 = equal_2323 ? (less_2320 ? (not_2324 & and_3757) : and_3757) : and_3757;
  // hls/stages/patches.hpp:184
  logic select_3763;
  assign select_3763 = equal_2157_s2_q ? (less_2320 ? (not_2322 & select_3760) : select_3760) : patches_read_searches_q;
  // hls/stages/agreement.hpp:200
  logic [8:0] select_4106;
  assign select_4106 = so_s2_q ? (and_3054 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4108;
  assign sum_4108 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4109;
  assign select_4109 = sum_2351[5] ? {1'b1, sum_2351[4:0], region_across_rest_q[2:0]} : sum_4108;
  // hls/stages/agreement.hpp:451
  logic [8:0] select_4111;
  assign select_4111 = equal_2753_s2_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4114;
  assign select_4114 = equal_2753_s2_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_482_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_487;
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
  assign census_memory_re = s2_en & and_512_s2_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1314; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1979;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:791; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 29'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_2262, not_2257, select_2256};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & or_2263;
  logic [28:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [27:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[27:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:792; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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
  assign patches_left_codes_re = s2_en & (not_2158_s2_q & (new_row & equal_2159_s2_q));
  logic [48:0] patches_left_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_word_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end
  logic [47:0] patches_left_codes_rdata_q;
  assign patches_left_codes_rdata_q = patches_left_codes_word_q[47:0];
  logic patches_left_codes_read_q, patches_left_codes_error;
  always_ff @(posedge clk_i) patches_left_codes_read_q <= rst_ni & patches_left_codes_re;
  assign patches_left_codes_error = patches_left_codes_read_q & ^patches_left_codes_word_q;

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:806; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
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
  assign patches_rows_re = s2_en & and_2330;
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1341; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1979;
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
  assign best_left_we = s2_en & and_1926_s2_q;
  logic [45:0] best_left_wdata;
  assign best_left_wdata = {select_1925, select_1924, select_1897, select_1894, select_1886, select_1885, select_1881};
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
  assign best_right_we = s2_en & and_1926_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_1943, select_1942, select_1939, select_1938};
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
  assign patches_columns_above_we = s2_en & and_2244_s2_q;
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
      shift_allowed_q <= 1'b0;
      shift_not_right_q <= 1'b0;
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
      shift_allowed_q <= not_2850 & (~less_2851);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s2_q ? sum_2963[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2965;
      registration_slope_row_q <= select_3050;
      registration_slope_change_q <= select_3053;
      registration_slope_q <= so_s2_q ? column_8 : {registration_slope_row_q, 4'h0};
      patches_chance_q <= and_512_s2_q ? select_3198 : patches_chance_q;
      patches_along_ends_q <= not_3285_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3285_s2_q & select_3300;
      patches_smooth_values_0_q <= equal_2157_s2_q ? patches_smooth_values_0_q : select_3303;
      patches_smooth_values_1_q <= select_3307;
      patches_smooth_values_2_q <= select_3310;
      patches_smooth_values_3_q <= select_3313;
      patches_down_values_0_q <= equal_2157_s2_q ? patches_down_values_0_q : select_3315;
      patches_down_values_1_q <= equal_2157_s2_q ? patches_down_values_1_q : select_3318;
      patches_down_values_2_q <= equal_2157_s2_q ? patches_down_values_2_q : select_3321;
      patches_down_values_3_q <= equal_2157_s2_q ? patches_down_values_3_q : select_3324;
      patches_down_by_q <= or_3261_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3361});
      patches_along_q <= select_3366;
      patches_match_row_q <= or_3261_s2_q ? 4'h0 : select_3368;
      patches_summed_last_q <= not_2158_s2_q & (equal_2159_s2_q & and_3361);
      patches_summed_down_by_q <= select_3724;
      patches_step_q <= or_3261_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3763;
      region_across_rest_q <= select_4106;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4109;
      columns_begin_rest_q <= and_512_s2_q ? select_4111 : columns_begin_rest_q;
      columns_begin_back_q <= and_512_s2_q ? select_4114 : columns_begin_back_q;
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
  logic [2:0] select_476_s3_q;
  logic [6:0] select_478_s3_q;
  logic [8:0] select_482_s3_q;
  logic and_486_s3_q;
  logic and_487_s3_q;
  logic equal_492_s3_q;
  logic [6:0] column_s3_q;
  logic and_510_s3_q;
  logic and_512_s3_q;
  logic so_s3_q;
  logic equal_573_s3_q;
  logic equal_1944_s3_q;
  logic not_1945_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1979_s3_q;
  logic [6:0] select_1983_s3_q;
  logic and_1988_s3_q;
  logic right_2_s3_q;
  logic and_2057_s3_q;
  logic and_2070_s3_q;
  logic and_2083_s3_q;
  logic less_2084_s3_q;
  logic [7:0] change_s3_q;
  logic equal_2111_s3_q;
  logic and_2123_s3_q;
  logic equal_2150_s3_q;
  logic and_2155_s3_q;
  logic and_2156_s3_q;
  logic equal_2157_s3_q;
  logic equal_2159_s3_q;
  logic equal_2162_s3_q;
  logic or_2163_s3_q;
  logic [4:0] select_2187_s3_q;
  logic select_2193_s3_q;
  logic [3:0] select_2234_s3_q;
  logic less_2250_s3_q;
  logic new_row_s3_q;
  logic or_2263_s3_q;
  logic [1:0] of_row_2_s3_q;
  logic less_2280_s3_q;
  logic less_2281_s3_q;
  logic less_2290_s3_q;
  logic less_2291_s3_q;
  logic and_2305_s3_q;
  logic and_2314_s3_q;
  logic and_2319_s3_q;
  logic less_2320_s3_q;
  logic equal_2321_s3_q;
  logic not_2322_s3_q;
  logic equal_2323_s3_q;
  logic not_2324_s3_q;
  logic sum_2351_s3_q;
  logic textured_s3_q;
  logic and_2489_s3_q;
  logic equal_2629_s3_q;
  logic equal_2753_s3_q;
  logic less_2979_s3_q;
  logic and_3210_s3_q;
  logic less_3337_s3_q;
  logic equal_3680_s3_q;
  logic equal_3764_s3_q;
  logic less_4094_s3_q;
  logic equal_4299_s3_q;
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
      select_476_s3_q <= select_476_s2_q;
      select_478_s3_q <= select_478_s2_q;
      select_482_s3_q <= select_482_s2_q;
      and_486_s3_q <= and_486_s2_q;
      and_487_s3_q <= and_487;
      equal_492_s3_q <= equal_492_s2_q;
      column_s3_q <= column_s2_q;
      and_510_s3_q <= and_510_s2_q;
      and_512_s3_q <= and_512_s2_q;
      so_s3_q <= so_s2_q;
      equal_573_s3_q <= equal_573_s2_q;
      equal_1944_s3_q <= equal_1944_s2_q;
      not_1945_s3_q <= not_1945;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1979_s3_q <= and_1979;
      select_1983_s3_q <= select_1983_s2_q;
      and_1988_s3_q <= not_1945 & (so_s2_q ? and_1977 : (equal_532_s2_q & shift_2[4]));
      right_2_s3_q <= right_2;
      and_2057_s3_q <= and_2057_s2_q;
      and_2070_s3_q <= and_2070_s2_q;
      and_2083_s3_q <= not_1945 & (so_s2_q & (ends_cell_s2_q & (shift_2[0] & right_3)));
      less_2084_s3_q <= less_2084_s2_q;
      change_s3_q <= change;
      equal_2111_s3_q <= equal_2111;
      and_2123_s3_q <= and_2123;
      equal_2150_s3_q <= equal_2150;
      and_2155_s3_q <= and_2155;
      and_2156_s3_q <= patches_chooses_s2_q & and_2155;
      equal_2157_s3_q <= equal_2157_s2_q;
      equal_2159_s3_q <= equal_2159_s2_q;
      equal_2162_s3_q <= equal_2162_s2_q;
      or_2163_s3_q <= or_2163_s2_q;
      select_2187_s3_q <= select_2187_s2_q;
      select_2193_s3_q <= select_2193_s2_q;
      select_2234_s3_q <= select_2234_s2_q;
      less_2250_s3_q <= less_2250;
      new_row_s3_q <= new_row;
      or_2263_s3_q <= or_2263;
      of_row_2_s3_q <= of_row_2;
      less_2280_s3_q <= $signed(15'h100) < $signed(sum_2279);
      less_2281_s3_q <= $signed(sum_2279[14:8]) < $signed(7'h7f);
      less_2290_s3_q <= $signed(15'h100) < $signed(difference_2289);
      less_2291_s3_q <= $signed(difference_2289[14:8]) < $signed(7'h7f);
      and_2305_s3_q <= not_2158_s2_q & and_2304;
      and_2314_s3_q <= and_2314;
      and_2319_s3_q <= not_2158_s2_q & and_2318;
      less_2320_s3_q <= less_2320;
      equal_2321_s3_q <= equal_2321;
      not_2322_s3_q <= not_2322;
      equal_2323_s3_q <= equal_2323;
      not_2324_s3_q <= not_2324;
      sum_2351_s3_q <= sum_2351[5];
      textured_s3_q <= textured;
      and_2489_s3_q <= not_1945 & (so_s2_q & and_2487);
      equal_2629_s3_q <= equal_2629_s2_q;
      equal_2753_s3_q <= equal_2753_s2_q;
      less_2979_s3_q <= select_2946 < select_2948;
      and_3210_s3_q <= not_1945 & and_3209;
      less_3337_s3_q <= 4'he < patches_column_s2_q[4:1];
      equal_3680_s3_q <= patches_match_row_q == 4'h0;
      equal_3764_s3_q <= patches_step_q[6:5] == 2'h2;
      less_4094_s3_q <= less_4094_s2_q;
      equal_4299_s3_q <= equal_4299_s2_q;
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
  logic [11:0] select_490;
  assign select_490 = select_476_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_494;
  assign sum_494 = select_490 + (equal_492_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_496;
  assign sum_496 = {4'h0, sample_pair_pixel_1_q} + (select_476_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_498;
  assign sum_498 = sum_496 + (equal_492_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:408
  logic whole;
  assign whole = select_476_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_502;
  assign and_502 = whole & (averager_memory_rdata_q[24] | equal_492_s3_q);
  // hls/stages/agreement.hpp:408
  logic all_of_skin;
  assign all_of_skin = select_476_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_506;
  assign and_506 = all_of_skin & (averager_memory_rdata_q[25] | equal_492_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_486_s3_q ? sum_494[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_515;
  assign equal_515 = select_476_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_515 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:267
  logic [8:0] select_518;
  assign select_518 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_486_s3_q ? sum_498[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_515 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:267
  logic [8:0] select_522;
  assign select_522 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_523;
  assign and_523 = and_486_s3_q & and_502;
  // hls/stages/census.hpp:126
  logic select_525;
  assign select_525 = equal_515 ? and_523 : (averager_mask_q & and_523);
  // hls/stages/agreement.hpp:267
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_525;
  // hls/stages/census.hpp:206
  logic and_527;
  assign and_527 = and_486_s3_q & and_506;
  // hls/stages/census.hpp:126
  logic select_529;
  assign select_529 = equal_515 ? and_527 : (averager_of_skin_q & and_527);
  // hls/stages/agreement.hpp:267
  logic and_530;
  assign and_530 = sample_pair_whole_s3_q & select_529;
  // hls/stages/census.hpp:294
  logic less_546;
  assign less_546 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_547;
  assign less_547 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_548;
  assign less_548 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_549;
  assign less_549 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_550;
  assign less_550 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_551;
  assign less_551 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_552;
  assign less_552 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_553;
  assign less_553 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_554;
  assign less_554 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_555;
  assign less_555 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_556;
  assign less_556 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_557;
  assign less_557 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_558;
  assign less_558 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_559;
  assign less_559 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_560;
  assign less_560 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_561;
  assign less_561 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_562;
  assign less_562 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_563;
  assign less_563 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_564;
  assign less_564 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_565;
  assign less_565 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_566;
  assign less_566 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_567;
  assign less_567 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_568;
  assign less_568 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_569;
  assign less_569 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:446
  logic equal_570;
  assign equal_570 = column_s3_q == 7'h0;
  logic [3:0] select_574;
  assign select_574 = equal_573_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:447
  logic [4:0] select_575;
  assign select_575 = equal_570 ? {select_574, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_576;
  assign select_576 = equal_570 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_577;
  assign and_577 = select_575[4] & select_576[3];
  // hls/stages/census.hpp:286
  logic and_579;
  assign and_579 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_581;
  assign and_581 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_579);
  // hls/stages/agreement.hpp:447
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_581;
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
  logic [9:0] difference_604;
  assign difference_604 = {1'b0, select_518} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_605;
  assign xor_605 = difference_604[8:0] ^ {9{difference_604[9]}};
  logic [9:0] sum_606;
  assign sum_606 = {9'h0, difference_604[9]} + {1'b0, xor_605};
  logic [9:0] difference_607;
  assign difference_607 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_608;
  assign xor_608 = difference_607[8:0] ^ {9{difference_607[9]}};
  logic [9:0] sum_609;
  assign sum_609 = {9'h0, difference_607[9]} + {1'b0, xor_608};
  logic [9:0] difference_611;
  assign difference_611 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_612;
  assign xor_612 = difference_611[8:0] ^ {9{difference_611[9]}};
  logic [9:0] sum_613;
  assign sum_613 = {9'h0, difference_611[9]} + {1'b0, xor_612};
  logic [10:0] sum_614;
  assign sum_614 = ({1'b0, sum_606} + {1'b0, sum_609}) + {1'b0, sum_613};
  logic [9:0] difference_615;
  assign difference_615 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_616;
  assign xor_616 = difference_615[8:0] ^ {9{difference_615[9]}};
  logic [9:0] sum_617;
  assign sum_617 = {9'h0, difference_615[9]} + {1'b0, xor_616};
  logic [9:0] difference_619;
  assign difference_619 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_620;
  assign xor_620 = difference_619[8:0] ^ {9{difference_619[9]}};
  // hls/stages/agreement.hpp:196
  logic not_1984;
  assign not_1984 = ~so_s3_q;
  // hls/stages/agreement.hpp:776
  logic and_1985;
  assign and_1985 = not_1984 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1083
  logic equal_1989;
  assign equal_1989 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1084
  logic [1:0] select_1992;
  assign select_1992 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1097
  logic [3:0] select_1994;
  assign select_1994 = equal_1989 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1992});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1995;
  assign sum_1995 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:776
  logic [3:0] select_1996;
  assign select_1996 = equal_1944_s3_q ? select_1994 : {sum_1995, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1997;
  assign equal_1997 = x_s3_q[5:0] == 6'h3f;
  logic equal_1999;
  assign equal_1999 = x_s3_q[5:0] == 6'h3e;
  logic equal_2001;
  assign equal_2001 = x_s3_q[5:0] == 6'h3d;
  logic equal_2003;
  assign equal_2003 = x_s3_q[5:0] == 6'h3c;
  logic equal_2005;
  assign equal_2005 = x_s3_q[5:0] == 6'h3b;
  logic equal_2007;
  assign equal_2007 = x_s3_q[5:0] == 6'h36;
  logic equal_2009;
  assign equal_2009 = x_s3_q[5:0] == 6'h35;
  logic equal_2011;
  assign equal_2011 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1129
  logic and_2015;
  assign and_2015 = (~equal_2005) & ((~equal_2007) & ((~equal_2009) & (~equal_2011)));
  logic and_2019;
  assign and_2019 = (~equal_1997) & ((~equal_1999) & ((~equal_2001) & ((~equal_2003) & and_2015)));
  // hls/stages/agreement.hpp:1084
  logic less_2020;
  assign less_2020 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2024;
  assign or_2024 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2035;
  assign sum_2035 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_2037;
  assign and_2037 = half_ends & ({{3{sum_2035[4]}}, sum_2035} < 8'h3);
  // hls/stages/agreement.hpp:776
  logic and_2038;
  assign and_2038 = so_s3_q & and_2037;
  logic select_2039;
  assign select_2039 = equal_1944_s3_q ? (x_s3_q[6] & (equal_1989 ? and_2019 : (less_2020 & (~or_2024)))) : and_2038;
  // hls/stages/registration.hpp:258
  logic not_2041;
  assign not_2041 = ~lower_half_s3_q;
  logic [3:0] select_2042;
  assign select_2042 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_2041, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_2041};
  // hls/stages/patches.hpp:372
  logic [1:0] select_2071;
  assign select_2071 = and_2070_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2072;
  assign select_2072 = and_2070_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:267
  logic [5:0] select_2073;
  assign select_2073 = and_2057_s3_q ? {select_2072, select_2071[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2074;
  assign select_2074 = and_2057_s3_q ? select_2071 : patches_fetch_q;
  logic equal_2075;
  assign equal_2075 = select_2074 == 2'h0;
  // hls/stages/registration.hpp:83
  logic equal_2085;
  assign equal_2085 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2085 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2091;
  assign select_2091 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2092;
  assign select_2092 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2093;
  assign sum_2093 = {{2{select_2091[6]}}, select_2091} + {select_2092[7], select_2092};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2094;
  assign select_2094 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2095;
  assign select_2095 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2096;
  assign sum_2096 = {{2{select_2094[7]}}, select_2094[7:1]} + {select_2095[7], select_2095};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2097;
  assign sum_2097 = {{3{sum_2093[8]}}, sum_2093[8:1]} + {sum_2096[8], sum_2096, select_2094[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2098;
  assign select_2098 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2099;
  assign select_2099 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2100;
  assign difference_2100 = {{2{select_2098[7]}}, select_2098[7:1]} - {select_2099[7], select_2099};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2101;
  assign sum_2101 = {difference_2100, select_2098[0]} + {sum_2097[10], sum_2097[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2085 ? {sum_2101, sum_2097[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2103;
  assign sum_2103 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:977
  logic and_2105;
  assign and_2105 = shift_2_s3_q[3] & ({{4{sum_2103[9]}}, sum_2103, expected[1:0]} < 16'h29);
  // hls/stages/agreement.hpp:776
  logic and_2126;
  assign and_2126 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_2084_s3_q & and_2105) & and_2123_s3_q));
  logic and_2128;
  assign and_2128 = not_1945_s3_q & (so_s3_q & and_2126);
  // hls/stages/patches.hpp:156
  logic and_2130;
  assign and_2130 = and_2128 & (~patches_fixed_q);
  // hls/stages/agreement.hpp:776
  logic [7:0] select_2133;
  assign select_2133 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2134;
  assign select_2134 = equal_1944_s3_q ? 8'h0 : select_2133;
  logic [5:0] select_2136;
  assign select_2136 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_2138;
  assign select_2138 = equal_1944_s3_q ? 6'h0 : (so_s3_q ? select_2136 : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2139;
  assign sum_2139 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_2101[9]}}, sum_2101[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2142;
  assign select_2142 = ($signed(sum_2139[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2139[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2085 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2139[12:7])) ? 8'h7f : select_2142);
  // hls/stages/agreement.hpp:776
  logic [7:0] select_2147;
  assign select_2147 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2148;
  assign select_2148 = equal_1944_s3_q ? 8'h0 : select_2147;
  // hls/stages/patches.hpp:342
  logic [22:0] select_2149;
  assign select_2149 = and_2130 ? {select_2148, select_2138, select_2134, and_2128} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:126
  logic [4:0] select_2170;
  assign select_2170 = and_2057_s3_q ? select_2072 : patches_band_q;
  // hls/stages/patches.hpp:352
  logic equal_2171;
  assign equal_2171 = {patches_choosing_band_s3_q, and_2083_s3_q} == {select_2170, select_2074[1]};
  // hls/stages/patches.hpp:481
  logic [2:0] sum_2271;
  assign sum_2271 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:485
  logic [1:0] sum_2309;
  assign sum_2309 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:200
  logic [7:0] select_2338;
  assign select_2338 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1005
  logic or_2341;
  assign or_2341 = select_2338[7] | (~({select_2338[5], select_2338[3], select_2338[1]} == 3'h0));
  // hls/stages/agreement.hpp:1004
  logic or_2344;
  assign or_2344 = select_2338[7] | (~({select_2338[6], select_2338[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1003
  logic or_2347;
  assign or_2347 = select_2338[7] | (~(select_2338[6:4] == 3'h0));
  // hls/stages/agreement.hpp:776
  logic [5:0] select_2348;
  assign select_2348 = equal_1944_s3_q ? x_s3_q[5:0] : {region_row_q, or_2347, or_2344, or_2341};
  // hls/stages/agreement.hpp:1083
  logic not_2349;
  assign not_2349 = ~equal_1989;
  // hls/stages/agreement.hpp:1013
  logic or_2353;
  assign or_2353 = (~sum_2351_s3_q) | equal_2150_s3_q;
  // hls/stages/agreement.hpp:776
  logic and_2356;
  assign and_2356 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_2353));
  // hls/stages/agreement.hpp:253
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_2377;
  assign and_2377 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:973
  logic select_2378;
  assign select_2378 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:253
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_2378);
  // hls/stages/agreement.hpp:973
  logic select_2381;
  assign select_2381 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:253
  logic near;
  assign near = shift_2_s3_q[0] & (select_2378 ? select_2381 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1216
  logic or_2384;
  assign or_2384 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1218
  logic [16:0] select_2386;
  assign select_2386 = marks_first_s3_q ? 17'h1 : (or_2384 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1217
  logic [8:0] select_2388;
  assign select_2388 = or_2384 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1225
  logic select_2390;
  assign select_2390 = cfg_compete_i ? (or_2384 & select_2386[16]) : (select_2388[8] & select_2386[9]);
  // hls/stages/agreement.hpp:426
  logic next_row;
  assign next_row = select_2390 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1232
  logic [6:0] select_2393;
  assign select_2393 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2395;
  assign select_2395 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_2393});
  // hls/stages/agreement.hpp:1242
  logic equal_2396;
  assign equal_2396 = seen_x_q == 3'h7;
  logic [7:0] select_2398;
  assign select_2398 = select_2390 ? 8'h0 : (seen_column_q + {7'h0, equal_2396});
  // hls/stages/agreement.hpp:1249
  logic [12:0] index;
  assign index = select_2395 + {5'h0, select_2398};
  // hls/stages/agreement.hpp:1216
  logic select_2401;
  assign select_2401 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1202
  logic [7:0] sum_2402;
  assign sum_2402 = {1'b0, select_2401, 2'h0, select_2401, 1'b0, {2{select_2401}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1215
  logic not_2403;
  assign not_2403 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:426
  logic and_2405;
  assign and_2405 = not_2403 & (began_q | select_2390);
  // hls/stages/agreement.hpp:1243
  logic [2:0] select_2407;
  assign select_2407 = select_2390 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1248
  logic and_2409;
  assign and_2409 = and_2405 & (select_2407 == 3'h0);
  logic less_2410;
  assign less_2410 = select_2398 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1066
  logic [7:0] sum_2413;
  assign sum_2413 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2413[7]}}, sum_2413, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1202
  logic [7:0] sum_2415;
  assign sum_2415 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:989
  logic and_2416;
  assign and_2416 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_2417;
  assign and_2417 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_2418;
  assign and_2418 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_2419;
  assign and_2419 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1042
  logic [1:0] sum_2421;
  assign sum_2421 = {1'b0, and_2418} + ({1'b0, textured_s3_q} + {1'b0, and_2419});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2416} + ({2'h0, and_2417} + {1'b0, sum_2421});
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_2424;
  assign select_2424 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2425;
  assign difference_2425 = {1'b0, textured_2} - {1'b0, select_2424};
  logic [4:0] t;
  assign t = {difference_2425[3], difference_2425} + (equal_2111_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:989
  logic [7:0] select_2430;
  assign select_2430 = shift_2_s3_q[0] ? (sum_2351_s3_q ? select_2338 : {select_2338[6:0], 1'b0}) : select_2338;
  // hls/stages/agreement.hpp:1005
  logic or_2433;
  assign or_2433 = select_2430[7] | (~({select_2430[5], select_2430[3], select_2430[1]} == 3'h0));
  // hls/stages/agreement.hpp:989
  logic and_2450;
  assign and_2450 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_2451;
  assign and_2451 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_2452;
  assign and_2452 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_2453;
  assign and_2453 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1044
  logic [1:0] sum_2455;
  assign sum_2455 = {1'b0, and_2452} + ({1'b0, shown} + {1'b0, and_2453});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2450} + ({2'h0, and_2451} + {1'b0, sum_2455});
  // hls/stages/agreement.hpp:1051
  logic [2:0] select_2458;
  assign select_2458 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2459;
  assign difference_2459 = {1'b0, shown_2} - {1'b0, select_2458};
  logic [4:0] around;
  assign around = {difference_2459[3], difference_2459} + (equal_2111_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1058
  logic [5:0] sum_2462;
  assign sum_2462 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:989
  logic and_2466;
  assign and_2466 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2467;
  assign and_2467 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2468;
  assign and_2468 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2469;
  assign and_2469 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1045
  logic [1:0] sum_2471;
  assign sum_2471 = {1'b0, and_2468} + ({1'b0, near} + {1'b0, and_2469});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2466} + ({2'h0, and_2467} + {1'b0, sum_2471});
  // hls/stages/agreement.hpp:1052
  logic [2:0] select_2474;
  assign select_2474 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2475;
  assign difference_2475 = {1'b0, near_2} - {1'b0, select_2474};
  logic [4:0] n;
  assign n = {difference_2475[3], difference_2475} + (equal_2111_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:267
  logic [10:0] select_2521;
  assign select_2521 = sample_pair_whole_s3_q ? (and_510_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2523;
  assign select_2523 = sample_pair_whole_s3_q ? (and_510_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2542;
  assign select_2542 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2544;
  assign select_2544 = sample_pair_whole_s3_q ? (and_510_s3_q ? select_525 : averager_mask_q) : averager_mask_q;
  logic select_2546;
  assign select_2546 = sample_pair_whole_s3_q ? (and_510_s3_q ? select_529 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:511
  logic [8:0] select_2547;
  assign select_2547 = and_512_s3_q ? select_518 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2548;
  assign select_2548 = and_512_s3_q ? select_522 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2550;
  assign select_2550 = and_512_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2551;
  assign select_2551 = and_512_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2552;
  assign select_2552 = and_512_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2553;
  assign select_2553 = and_512_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2554;
  assign select_2554 = and_512_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2555;
  assign select_2555 = and_512_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2556;
  assign select_2556 = and_512_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2557;
  assign select_2557 = and_512_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2558;
  assign select_2558 = and_512_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2559;
  assign select_2559 = and_512_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2560;
  assign select_2560 = and_512_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2561;
  assign select_2561 = and_512_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2562;
  assign select_2562 = and_512_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2563;
  assign select_2563 = and_512_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2564;
  assign select_2564 = and_512_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2565;
  assign select_2565 = and_512_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2566;
  assign select_2566 = and_512_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2567;
  assign select_2567 = and_512_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2568;
  assign select_2568 = and_512_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2569;
  assign select_2569 = and_512_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2570;
  assign select_2570 = and_512_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2571;
  assign select_2571 = and_512_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2572;
  assign select_2572 = and_512_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2573;
  assign select_2573 = and_512_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2574;
  assign select_2574 = and_512_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2575;
  assign select_2575 = and_512_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2576;
  assign select_2576 = and_512_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2577;
  assign select_2577 = and_512_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2578;
  assign select_2578 = and_512_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2579;
  assign select_2579 = and_512_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2580;
  assign select_2580 = and_512_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2581;
  assign select_2581 = and_512_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2582;
  assign select_2582 = and_512_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2583;
  assign select_2583 = and_512_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2584;
  assign select_2584 = and_512_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2585;
  assign select_2585 = and_512_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2586;
  assign select_2586 = and_512_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2587;
  assign select_2587 = and_512_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2588;
  assign select_2588 = and_512_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2589;
  assign select_2589 = and_512_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2590;
  assign select_2590 = and_512_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2591;
  assign select_2591 = and_512_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2592;
  assign select_2592 = and_512_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2593;
  assign select_2593 = and_512_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2594;
  assign select_2594 = and_512_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2595;
  assign select_2595 = and_512_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2596;
  assign select_2596 = and_512_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2597;
  assign select_2597 = and_512_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2598;
  assign select_2598 = and_512_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2599;
  assign select_2599 = and_512_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2600;
  assign select_2600 = and_512_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2601;
  assign select_2601 = and_512_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2602;
  assign select_2602 = and_512_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2604;
  assign difference_2604 = {1'b0, select_522} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2605;
  assign xor_2605 = difference_2604[8:0] ^ {9{difference_2604[9]}};
  logic [9:0] sum_2606;
  assign sum_2606 = {9'h0, difference_2604[9]} + {1'b0, xor_2605};
  logic [9:0] difference_2607;
  assign difference_2607 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2608;
  assign xor_2608 = difference_2607[8:0] ^ {9{difference_2607[9]}};
  logic [9:0] sum_2609;
  assign sum_2609 = {9'h0, difference_2607[9]} + {1'b0, xor_2608};
  logic [9:0] difference_2611;
  assign difference_2611 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2612;
  assign xor_2612 = difference_2611[8:0] ^ {9{difference_2611[9]}};
  logic [9:0] sum_2613;
  assign sum_2613 = {9'h0, difference_2611[9]} + {1'b0, xor_2612};
  logic [10:0] sum_2614;
  assign sum_2614 = ({1'b0, sum_2606} + {1'b0, sum_2609}) + {1'b0, sum_2613};
  logic [9:0] difference_2615;
  assign difference_2615 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2616;
  assign xor_2616 = difference_2615[8:0] ^ {9{difference_2615[9]}};
  logic [9:0] sum_2617;
  assign sum_2617 = {9'h0, difference_2615[9]} + {1'b0, xor_2616};
  logic [9:0] difference_2619;
  assign difference_2619 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2620;
  assign xor_2620 = difference_2619[8:0] ^ {9{difference_2619[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2650;
  assign difference_2650 = {1'b0, select_518} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2650[9]} + (difference_2650[8:0] ^ {9{difference_2650[9]}});
  logic [9:0] difference_2662;
  assign difference_2662 = {1'b0, select_522} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2662[9]} + (difference_2662[8:0] ^ {9{difference_2662[9]}});
  // hls/stages/agreement.hpp:511
  logic and_2858;
  assign and_2858 = and_512_s3_q & (equal_573_s3_q & equal_2753_s3_q);
  // hls/stages/agreement.hpp:776
  logic and_2862;
  assign and_2862 = not_1945_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:989
  logic and_2882;
  assign and_2882 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2883;
  assign and_2883 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2884;
  assign and_2884 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2885;
  assign and_2885 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1043
  logic [1:0] sum_2887;
  assign sum_2887 = {1'b0, and_2884} + ({1'b0, explained} + {1'b0, and_2885});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2882} + ({2'h0, and_2883} + {1'b0, sum_2887});
  // hls/stages/agreement.hpp:1050
  logic [2:0] select_2890;
  assign select_2890 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2891;
  assign difference_2891 = {1'b0, explained_2} - {1'b0, select_2890};
  logic [4:0] e;
  assign e = {difference_2891[3], difference_2891} + (equal_2111_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1057
  logic [5:0] sum_2894;
  assign sum_2894 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:776
  logic and_2923;
  assign and_2923 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2967;
  assign select_2967 = equal_1944_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2969;
  assign select_2969 = equal_1944_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2970;
  assign equal_2970 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:253
  logic and_2974;
  assign and_2974 = shift_2_s3_q[3] & less_2084_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2978;
  assign sum_2978 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2980;
  assign difference_2980 = {sum_2978, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2981;
  assign select_2981 = less_2979_s3_q ? difference_2980 : {sum_2978, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2982;
  assign select_2982 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2978, shift_2_s3_q[11], 5'h0} : select_2981;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2982[7]}}, select_2982} - {sum_2101[9], sum_2101, sum_2097[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2985;
  assign select_2985 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2985[11:7])) ? 12'h7f : select_2985;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3006;
  assign difference_3006 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3008;
  assign and_3008 = and_2974 & ($signed(difference_3006) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3021;
  assign less_3021 = $signed(difference_3006) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:776
  logic select_3029;
  assign select_3029 = so_s3_q ? (equal_2970 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_3032;
  assign select_3032 = so_s3_q ? (equal_2085 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3037;
  assign select_3037 = (sum_1995 == 2'h2) ? (registration_fresh_q & (~select_2042)) : registration_fresh_q;
  // hls/stages/agreement.hpp:776
  logic [3:0] select_3039;
  assign select_3039 = so_s3_q ? (and_2037 ? select_3037 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3041;
  assign select_3041 = and_2858 ? 4'hf : (equal_1944_s3_q ? registration_fresh_q : select_3039);
  // hls/stages/agreement.hpp:1084
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1992;
  // hls/stages/registration.hpp:258
  logic not_3062;
  assign not_3062 = ~quarter_2[1];
  logic [3:0] select_3063;
  assign select_3063 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3062, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3062};
  // hls/stages/patches.hpp:344
  logic not_3200;
  assign not_3200 = ~and_2155_s3_q;
  // hls/stages/patches.hpp:353
  logic not_3226;
  assign not_3226 = ~select_2074[1];
  // hls/stages/agreement.hpp:267
  logic [1:0] select_3228;
  assign select_3228 = sample_pair_whole_s3_q ? (equal_2075 ? select_2074 : {not_3226, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:517
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3327;
  assign select_3327 = or_2163_s3_q ? {less_2291_s3_q, less_2290_s3_q, less_2281_s3_q, less_2280_s3_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3329;
  assign select_3329 = equal_2157_s3_q ? patches_codes_at_q : (equal_2159_s3_q ? other[55:4] : select_3327);
  // hls/stages/patches.hpp:500
  logic [27:0] word;
  assign word = or_2263_s3_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:516
  logic [27:0] select_3332;
  assign select_3332 = (patches_along_s3_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3334;
  assign select_3334 = equal_2159_s3_q ? (new_row_s3_q ? word : select_3332) : patches_codes_further_q;
  // hls/stages/patches.hpp:518
  logic [55:0] select_3336;
  assign select_3336 = less_2250_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:488
  logic [55:0] select_3338;
  assign select_3338 = less_3337_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3340;
  assign select_3340 = or_2163_s3_q ? (equal_2162_s3_q ? patches_next_codes_q : select_3338) : patches_next_codes_q;
  logic [55:0] select_3342;
  assign select_3342 = equal_2157_s3_q ? patches_next_codes_q : (equal_2159_s3_q ? select_3336 : select_3340);
  // hls/stages/count_bits.hpp:24
  logic parity_3347;
  assign parity_3347 = ^{less_2291_s3_q, less_2290_s3_q, less_2281_s3_q, less_2280_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_3351;
  assign or_3351 = ({less_2281_s3_q, less_2280_s3_q} == 2'h3) | (less_2290_s3_q & (less_2281_s3_q | less_2280_s3_q));
  logic and_3352;
  assign and_3352 = less_2291_s3_q & (^{less_2290_s3_q, less_2281_s3_q, less_2280_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3353;
  assign xor_3353 = or_3351 ^ and_3352;
  // hls/stages/count_bits.hpp:27
  logic and_3354;
  assign and_3354 = or_3351 & and_3352;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3356;
  assign select_3356 = or_2163_s3_q ? (and_2314_s3_q ? {and_3354, xor_3353, parity_3347} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3360;
  assign sum_3360 = {7'h0, patches_set_q} + (equal_2162_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:517
  logic [47:0] select_3370;
  assign select_3370 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3372;
  assign select_3372 = equal_2157_s3_q ? patches_left_row_q : (equal_2159_s3_q ? select_3370 : patches_left_row_q);
  // hls/stages/patches.hpp:519
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3370;
  // hls/stages/count_bits.hpp:24
  logic xor_3376;
  assign xor_3376 = bits[17] ^ (^{select_3370[16:15], other[16:15]});
  logic xor_3379;
  assign xor_3379 = bits[11] ^ (^{select_3370[10:9], other[10:9]});
  logic xor_3382;
  assign xor_3382 = bits[14] ^ (^{select_3370[13:12], other[13:12]});
  logic xor_3385;
  assign xor_3385 = xor_3376 ^ (^{select_3370[14:9], other[14:9]});
  logic xor_3388;
  assign xor_3388 = bits[47] ^ (^{select_3370[46:45], other[46:45]});
  logic xor_3391;
  assign xor_3391 = bits[8] ^ (^{select_3370[7:6], other[7:6]});
  logic xor_3394;
  assign xor_3394 = bits[2] ^ (^{select_3370[1:0], other[1:0]});
  logic xor_3397;
  assign xor_3397 = bits[5] ^ (^{select_3370[4:3], other[4:3]});
  logic xor_3400;
  assign xor_3400 = xor_3391 ^ (^{select_3370[5:0], other[5:0]});
  logic parity_3402;
  assign parity_3402 = ^{select_3370[47:45], select_3370[8:0], other[47:45], other[8:0]};
  logic xor_3403;
  assign xor_3403 = xor_3385 ^ parity_3402;
  logic xor_3406;
  assign xor_3406 = bits[44] ^ (^{select_3370[43:42], other[43:42]});
  logic xor_3409;
  assign xor_3409 = bits[38] ^ (^{select_3370[37:36], other[37:36]});
  logic xor_3412;
  assign xor_3412 = bits[41] ^ (^{select_3370[40:39], other[40:39]});
  logic xor_3418;
  assign xor_3418 = bits[26] ^ (^{select_3370[25:24], other[25:24]});
  logic xor_3421;
  assign xor_3421 = bits[20] ^ (^{select_3370[19:18], other[19:18]});
  logic xor_3424;
  assign xor_3424 = bits[23] ^ (^{select_3370[22:21], other[22:21]});
  logic xor_3427;
  assign xor_3427 = xor_3418 ^ (^{select_3370[23:18], other[23:18]});
  logic xor_3430;
  assign xor_3430 = bits[35] ^ (^{select_3370[34:33], other[34:33]});
  logic xor_3433;
  assign xor_3433 = bits[29] ^ (^{select_3370[28:27], other[28:27]});
  logic xor_3436;
  assign xor_3436 = bits[32] ^ (^{select_3370[31:30], other[31:30]});
  logic xor_3439;
  assign xor_3439 = xor_3430 ^ (^{select_3370[32:27], other[32:27]});
  logic xor_3440;
  assign xor_3440 = xor_3427 ^ xor_3439;
  // hls/stages/count_bits.hpp:25
  logic or_3448;
  assign or_3448 = (xor_3379 & xor_3382) | (xor_3376 & (xor_3379 | xor_3382));
  logic or_3452;
  assign or_3452 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3456;
  assign or_3456 = (xor_3394 & xor_3397) | (xor_3391 & (xor_3394 | xor_3397));
  // hls/stages/count_bits.hpp:23
  logic or_3463;
  assign or_3463 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3467;
  assign or_3467 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3471;
  assign or_3471 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3474;
  assign parity_3474 = ^{or_3471, or_3467, or_3463};
  // hls/stages/count_bits.hpp:23
  logic or_3478;
  assign or_3478 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3482;
  assign or_3482 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3486;
  assign or_3486 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3489;
  assign parity_3489 = ^{or_3486, or_3482, or_3478};
  logic parity_3492;
  assign parity_3492 = ^{or_3486, or_3482, or_3478, or_3471, or_3467, or_3463, or_3456, or_3452, or_3448};
  // hls/stages/count_bits.hpp:23
  logic or_3496;
  assign or_3496 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3500;
  assign or_3500 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3504;
  assign or_3504 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3512;
  assign or_3512 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3516;
  assign or_3516 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3520;
  assign or_3520 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3523;
  assign parity_3523 = ^{or_3520, or_3516, or_3512};
  // hls/stages/count_bits.hpp:23
  logic or_3527;
  assign or_3527 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3531;
  assign or_3531 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3535;
  assign or_3535 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3538;
  assign parity_3538 = ^{or_3535, or_3531, or_3527};
  logic parity_3541;
  assign parity_3541 = ^{or_3535, or_3531, or_3527, or_3520, or_3516, or_3512, or_3504, or_3500, or_3496};
  // hls/stages/count_bits.hpp:25
  logic or_3545;
  assign or_3545 = (xor_3409 & xor_3412) | (xor_3406 & (xor_3409 | xor_3412));
  logic or_3549;
  assign or_3549 = (xor_3421 & xor_3424) | (xor_3418 & (xor_3421 | xor_3424));
  logic or_3553;
  assign or_3553 = (xor_3433 & xor_3436) | (xor_3430 & (xor_3433 | xor_3436));
  // hls/stages/count_bits.hpp:24
  logic parity_3556;
  assign parity_3556 = ^{or_3553, or_3549, or_3545};
  // hls/stages/count_bits.hpp:25
  logic and_3557;
  assign and_3557 = xor_3403 & (^{xor_3440, select_3370[44:36], other[44:36]});
  logic or_3561;
  assign or_3561 = (xor_3388 & xor_3400) | (xor_3385 & (xor_3388 | xor_3400));
  logic and_3564;
  assign and_3564 = (xor_3406 ^ (^{select_3370[41:36], other[41:36]})) & (xor_3427 | xor_3439);
  logic or_3565;
  assign or_3565 = (xor_3427 & xor_3439) | and_3564;
  // hls/stages/count_bits.hpp:24
  logic parity_3568;
  assign parity_3568 = ^{or_3565, or_3561, and_3557};
  logic parity_3571;
  assign parity_3571 = ^{or_3565, or_3561, and_3557, or_3553, or_3549, or_3545, or_3535, or_3531, or_3527, or_3520, or_3516, or_3512, or_3504, or_3500, or_3496};
  logic parity_3573;
  assign parity_3573 = ^{or_3565, or_3561, and_3557, or_3553, or_3549, or_3545, or_3535, or_3531, or_3527, or_3520, or_3516, or_3512, or_3504, or_3500, or_3496, or_3486, or_3482, or_3478, or_3471, or_3467, or_3463, or_3456, or_3452, or_3448};
  // hls/stages/count_bits.hpp:25
  logic and_3574;
  assign and_3574 = parity_3492 & parity_3571;
  logic or_3578;
  assign or_3578 = (parity_3474 & parity_3489) | ((^{or_3456, or_3452, or_3448}) & (parity_3474 | parity_3489));
  logic or_3582;
  assign or_3582 = (parity_3556 & parity_3568) | (parity_3541 & (parity_3556 | parity_3568));
  logic or_3589;
  assign or_3589 = (parity_3523 & parity_3538) | ((^{or_3504, or_3500, or_3496}) & (parity_3523 | parity_3538));
  logic or_3593;
  assign or_3593 = (or_3549 & or_3553) | (or_3545 & (or_3549 | or_3553));
  logic or_3597;
  assign or_3597 = (or_3561 & or_3565) | (and_3557 & (or_3561 | or_3565));
  // hls/stages/count_bits.hpp:23
  logic or_3604;
  assign or_3604 = (or_3500 & or_3504) | (or_3496 & (or_3500 | or_3504));
  // hls/stages/count_bits.hpp:25
  logic or_3608;
  assign or_3608 = (or_3516 & or_3520) | (or_3512 & (or_3516 | or_3520));
  logic or_3612;
  assign or_3612 = (or_3531 & or_3535) | (or_3527 & (or_3531 | or_3535));
  // hls/stages/count_bits.hpp:24
  logic parity_3615;
  assign parity_3615 = ^{or_3612, or_3608, or_3604};
  // hls/stages/count_bits.hpp:23
  logic or_3619;
  assign or_3619 = (or_3452 & or_3456) | (or_3448 & (or_3452 | or_3456));
  // hls/stages/count_bits.hpp:25
  logic or_3623;
  assign or_3623 = (or_3467 & or_3471) | (or_3463 & (or_3467 | or_3471));
  logic or_3627;
  assign or_3627 = (or_3482 & or_3486) | (or_3478 & (or_3482 | or_3486));
  // hls/stages/count_bits.hpp:24
  logic parity_3630;
  assign parity_3630 = ^{or_3627, or_3623, or_3619};
  logic parity_3633;
  assign parity_3633 = ^{or_3627, or_3623, or_3619, or_3612, or_3608, or_3604, or_3597, or_3593, or_3589};
  logic parity_3635;
  assign parity_3635 = ^{or_3627, or_3623, or_3619, or_3612, or_3608, or_3604, or_3597, or_3593, or_3589, or_3582, or_3578, and_3574};
  // hls/stages/count_bits.hpp:25
  logic or_3639;
  assign or_3639 = (or_3593 & or_3597) | (or_3589 & (or_3593 | or_3597));
  logic or_3643;
  assign or_3643 = (or_3608 & or_3612) | (or_3604 & (or_3608 | or_3612));
  logic or_3647;
  assign or_3647 = (or_3623 & or_3627) | (or_3619 & (or_3623 | or_3627));
  // hls/stages/count_bits.hpp:24
  logic parity_3650;
  assign parity_3650 = ^{or_3647, or_3643, or_3639};
  // hls/stages/count_bits.hpp:25
  logic and_3651;
  assign and_3651 = (^{or_3582, or_3578, and_3574}) & parity_3633;
  logic or_3655;
  assign or_3655 = (or_3578 & or_3582) | (and_3574 & (or_3578 | or_3582));
  logic or_3659;
  assign or_3659 = (parity_3615 & parity_3630) | ((^{or_3597, or_3593, or_3589}) & (parity_3615 | parity_3630));
  // hls/stages/count_bits.hpp:24
  logic parity_3662;
  assign parity_3662 = ^{or_3659, or_3655, and_3651};
  // hls/stages/count_bits.hpp:25
  logic and_3664;
  assign and_3664 = parity_3650 & parity_3662;
  logic or_3668;
  assign or_3668 = (or_3643 & or_3647) | (or_3639 & (or_3643 | or_3647));
  logic or_3672;
  assign or_3672 = (or_3655 & or_3659) | (and_3651 & (or_3655 | or_3659));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3717;
  assign select_3717 = equal_2159_s3_q ? patches_along_s3_q : patches_summed_row_column_q;
  logic select_3720;
  assign select_3720 = equal_2157_s3_q ? patches_summed_first_q : (equal_2159_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:551
  logic [9:0] select_3727;
  assign select_3727 = less_2320_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3730;
  assign select_3730 = equal_2323_s3_q ? (less_2320_s3_q ? (equal_2323_s3_q ? 10'h0 : select_3727) : 10'h0) : select_3727;
  logic [9:0] select_3732;
  assign select_3732 = less_2320_s3_q ? (equal_2321_s3_q ? 10'h0 : select_3730) : select_3730;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3734;
  assign select_3734 = less_2320_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3737;
  assign select_3737 = equal_2323_s3_q ? (less_2320_s3_q ? (equal_2323_s3_q ? 5'h0 : select_3734) : 5'h0) : select_3734;
  logic [4:0] select_3739;
  assign select_3739 = less_2320_s3_q ? (equal_2321_s3_q ? 5'h0 : select_3737) : select_3737;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3741;
  assign select_3741 = less_2320_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3744;
  assign select_3744 = equal_2323_s3_q ? (less_2320_s3_q ? (equal_2323_s3_q ? 5'h0 : select_3741) : 5'h0) : select_3741;
  logic [4:0] select_3746;
  assign select_3746 = less_2320_s3_q ? (equal_2321_s3_q ? 5'h0 : select_3744) : select_3744;
  // hls/stages/patches.hpp:551
  logic and_3749;
  assign and_3749 = less_2320_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:555
  logic select_3752;
  assign select_3752 = equal_2323_s3_q ? (less_2320_s3_q ? (not_2324_s3_q & and_3749) : and_3749) : and_3749;
  // hls/stages/patches.hpp:184
  logic select_3755;
  assign select_3755 = equal_2157_s3_q ? (less_2320_s3_q ? (not_2322_s3_q & select_3752) : select_3752) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3766;
  assign or_3766 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3767;
  assign and_3767 = patches_read_searches_s3_q & or_3766;
  // hls/stages/patches.hpp:535
  logic [4:0] select_3768;
  assign select_3768 = and_3767 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:542
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3768};
  // hls/stages/patches.hpp:551
  logic and_3772;
  assign and_3772 = less_2320_s3_q & (equal_3764_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:555
  logic select_3775;
  assign select_3775 = equal_2323_s3_q ? (less_2320_s3_q ? (not_2324_s3_q & and_3772) : and_3772) : and_3772;
  // hls/stages/patches.hpp:184
  logic select_3778;
  assign select_3778 = equal_2157_s3_q ? (less_2320_s3_q ? (not_2322_s3_q & select_3775) : select_3775) : patches_read_above_q;
  // hls/stages/patches.hpp:551
  logic and_3781;
  assign and_3781 = less_2320_s3_q & (equal_3764_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:555
  logic select_3784;
  assign select_3784 = equal_2323_s3_q ? (less_2320_s3_q ? (not_2324_s3_q & and_3781) : and_3781) : and_3781;
  // hls/stages/patches.hpp:184
  logic select_3787;
  assign select_3787 = equal_2157_s3_q ? (less_2320_s3_q ? (not_2322_s3_q & select_3784) : select_3784) : patches_read_below_q;
  // hls/stages/patches.hpp:548
  logic [6:0] sum_3788;
  assign sum_3788 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:549
  logic [9:0] select_3791;
  assign select_3791 = (equal_3764_s3_q & ({sum_3788[6], sum_3788} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3792;
  assign select_3792 = less_2320_s3_q ? select_3791 : 10'h3ff;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3794;
  assign select_3794 = less_2320_s3_q ? (equal_2323_s3_q ? 10'h3ff : select_3792) : 10'h3ff;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3795;
  assign select_3795 = equal_2323_s3_q ? select_3794 : select_3792;
  logic [9:0] select_3797;
  assign select_3797 = less_2320_s3_q ? (equal_2321_s3_q ? 10'h3ff : select_3795) : select_3795;
  // hls/stages/patches.hpp:534
  logic [14:0] select_3799;
  assign select_3799 = and_3767 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3800;
  assign select_3800 = equal_2157_s3_q ? select_3799[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3801;
  assign select_3801 = equal_2157_s3_q ? select_3799[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:536
  logic [9:0] select_3803;
  assign select_3803 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3805;
  assign select_3805 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3808;
  assign select_3808 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3809;
  assign select_3809 = patches_read_first_q ? patches_read_far_q : select_3808;
  // hls/stages/patches.hpp:589
  logic [9:0] difference_3812;
  assign difference_3812 = select_3809 - select_3799[9:0];
  // hls/stages/patches.hpp:574
  logic less_3842;
  assign less_3842 = select_3803 < select_3805;
  // hls/stages/patches.hpp:580
  logic [1:0] sum_3843;
  assign sum_3843 = select_3768[4:3] + 2'h3;
  // hls/stages/patches.hpp:575
  logic [9:0] high;
  assign high = less_3842 ? select_3805 : select_3803;
  logic [9:0] low;
  assign low = (select_3805 < select_3803) ? select_3805 : select_3803;
  // hls/stages/patches.hpp:576
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3799[9:0];
  // hls/stages/patches.hpp:578
  logic not_3850;
  assign not_3850 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3851;
  assign sum_3851 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3853;
  assign not_3853 = ~({eight, 3'h0} < {1'b0, sum_3851, fall[0]});
  logic [1:0] sum_3854;
  assign sum_3854 = {1'b0, not_3850} + {1'b0, not_3853};
  // hls/stages/patches.hpp:579
  logic [10:0] sum_3855;
  assign sum_3855 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3857;
  assign not_3857 = ~({eight, 3'h0} < {sum_3855, fall[1:0]});
  logic not_3860;
  assign not_3860 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3861;
  assign sum_3861 = {1'b0, not_3857} + {1'b0, not_3860};
  // hls/stages/patches.hpp:578
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3854} + {1'b0, sum_3861};
  // hls/stages/patches.hpp:581
  logic [7:0] select_3864;
  assign select_3864 = less_3842 ? ({sum_3843, select_3768[2:0], 3'h0} - {5'h0, fraction}) : {sum_3843, select_3768[2:0], fraction};
  // hls/stages/agreement.hpp:1099
  logic equal_4027;
  assign equal_4027 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:776
  logic select_4091;
  assign select_4091 = equal_1944_s3_q ? shown_shown_q : (so_s3_q ? select_2378 : shown_shown_q);
  logic select_4093;
  assign select_4093 = equal_1944_s3_q ? shown_nearer_q : (so_s3_q ? select_2381 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4095;
  assign sum_4095 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:451
  logic [2:0] select_4097;
  assign select_4097 = less_4094_s3_q ? (sum_4095[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4099;
  assign select_4099 = equal_2753_s3_q ? (equal_573_s3_q ? 3'h0 : select_4097) : region_row_q;
  // hls/stages/agreement.hpp:776
  logic [7:0] select_4104;
  assign select_4104 = equal_1944_s3_q ? select_2338 : (so_s3_q ? (ends_cell_s3_q ? select_2430 : select_2338) : 8'h1);
  // hls/stages/agreement.hpp:451
  logic [8:0] select_4118;
  assign select_4118 = equal_573_s3_q ? {{2{difference_4116[6]}}, difference_4116} : (less_4094_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:511
  logic [8:0] select_4120;
  assign select_4120 = and_512_s3_q ? (equal_2753_s3_q ? select_4118 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:451
  logic [6:0] select_4122;
  assign select_4122 = equal_573_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:511
  logic [6:0] select_4124;
  assign select_4124 = and_512_s3_q ? (equal_2753_s3_q ? select_4122 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4125;
  assign sum_4125 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4126;
  assign select_4126 = sum_4095[7] ? {1'b1, sum_4095[6:0], region_down_rest_q[0]} : sum_4125;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4095[7];
  // hls/stages/agreement.hpp:451
  logic select_4130;
  assign select_4130 = equal_2753_s3_q ? (equal_573_s3_q | (less_4094_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:200
  logic or_4135;
  assign or_4135 = segment_starts_q | not_1984;
  // hls/stages/agreement.hpp:989
  logic select_4138;
  assign select_4138 = shift_2_s3_q[0] ? (sum_2351_s3_q ? (equal_2150_s3_q & or_2353) : or_2353) : or_4135;
  // hls/stages/agreement.hpp:776
  logic select_4141;
  assign select_4141 = equal_1944_s3_q ? or_4135 : (so_s3_q ? (ends_cell_s3_q ? select_4138 : or_4135) : or_4135);
  logic [2:0] select_4215;
  assign select_4215 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_4217;
  assign select_4217 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4219;
  assign select_4219 = equal_1944_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4217 : box_textured_columns_values_1_q);
  logic [2:0] select_4220;
  assign select_4220 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4222;
  assign select_4222 = equal_1944_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4220 : box_textured_columns_values_2_q);
  logic [2:0] select_4223;
  assign select_4223 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4225;
  assign select_4225 = equal_1944_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4223 : box_textured_columns_values_3_q);
  logic [2:0] select_4226;
  assign select_4226 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4228;
  assign select_4228 = equal_1944_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4226 : box_textured_columns_values_4_q);
  logic [4:0] select_4230;
  assign select_4230 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4233;
  assign select_4233 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4235;
  assign select_4235 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4237;
  assign select_4237 = equal_1944_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4235 : box_explained_columns_values_1_q);
  logic [2:0] select_4238;
  assign select_4238 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4240;
  assign select_4240 = equal_1944_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4238 : box_explained_columns_values_2_q);
  logic [2:0] select_4241;
  assign select_4241 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4243;
  assign select_4243 = equal_1944_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4241 : box_explained_columns_values_3_q);
  logic [2:0] select_4244;
  assign select_4244 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4246;
  assign select_4246 = equal_1944_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4244 : box_explained_columns_values_4_q);
  logic [4:0] select_4248;
  assign select_4248 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4249;
  assign select_4249 = equal_1944_s3_q ? box_explained_sum_sums_values_0_q : select_4248;
  logic [2:0] select_4251;
  assign select_4251 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4253;
  assign select_4253 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4255;
  assign select_4255 = equal_1944_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4253 : box_shown_columns_values_1_q);
  logic [2:0] select_4256;
  assign select_4256 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4258;
  assign select_4258 = equal_1944_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4256 : box_shown_columns_values_2_q);
  logic [2:0] select_4259;
  assign select_4259 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4261;
  assign select_4261 = equal_1944_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4259 : box_shown_columns_values_3_q);
  logic [2:0] select_4262;
  assign select_4262 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4264;
  assign select_4264 = equal_1944_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4262 : box_shown_columns_values_4_q);
  logic [4:0] select_4266;
  assign select_4266 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4269;
  assign select_4269 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4271;
  assign select_4271 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4273;
  assign select_4273 = equal_1944_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4271 : box_nearer_columns_values_1_q);
  logic [2:0] select_4274;
  assign select_4274 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4276;
  assign select_4276 = equal_1944_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4274 : box_nearer_columns_values_2_q);
  logic [2:0] select_4277;
  assign select_4277 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4279;
  assign select_4279 = equal_1944_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4277 : box_nearer_columns_values_3_q);
  logic [2:0] select_4280;
  assign select_4280 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4282;
  assign select_4282 = equal_1944_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4280 : box_nearer_columns_values_4_q);
  logic [4:0] select_4284;
  assign select_4284 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_4287;
  assign select_4287 = so_s3_q ? (ends_cell_s3_q ? and_2418 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4290;
  assign select_4290 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_4292;
  assign select_4292 = equal_1944_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_4290 : centres_values_0_of_skin_q);
  logic select_4293;
  assign select_4293 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4295;
  assign select_4295 = equal_1944_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_4293 : centres_values_1_textured_q);
  logic select_4296;
  assign select_4296 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4298;
  assign select_4298 = equal_1944_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_4296 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:451
  logic [12:0] select_4302;
  assign select_4302 = equal_2753_s3_q ? (equal_4299_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:511
  logic [6:0] select_4305;
  assign select_4305 = and_512_s3_q ? (equal_2753_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1241
  logic [2:0] select_4316;
  assign select_4316 = select_2390 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:426
  logic [7:0] select_4322;
  assign select_4322 = marks_first_s3_q ? (less_4318 ? {sum_4319, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1249
  logic and_4328;
  assign and_4328 = and_2489_s3_q & ({sum_2415, index_2[5:0]} == {sum_2402, index[5:0]});
  // hls/stages/registration.hpp:258
  logic not_4388;
  assign not_4388 = ~quarter[1];
  logic [3:0] select_4389;
  assign select_4389 = quarter[0] ? {quarter[1], 1'b0, not_4388, 1'b0} : {1'b0, quarter[1], 1'b0, not_4388};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1996;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_2039;
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:762; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [23:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 24'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_2073;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_2075));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1334; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2348;
  logic regions_re;
  assign regions_re = s3_en & (equal_1944_s3_q ? (x_s3_q[6] & not_2349) : and_2356);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1345; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2402, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_2409 & less_2410);
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
  assign averager_memory_waddr = select_482_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_487_s3_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_506, and_502, sum_498, sum_494};
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
  assign census_memory_we = s3_en & and_512_s3_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_530, whole_2, select_522, select_518};
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
  assign shown_right_waddr = select_1983_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1988_s3_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_1985, not_1984};
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
  assign patches_right_codes_waddr = {sum_2271, patches_code_row_s3_q[1:0], of_row_2_s3_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_2305_s3_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {less_2291_s3_q, less_2290_s3_q, less_2281_s3_q, less_2280_s3_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2309, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_2319_s3_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {less_2291_s3_q, less_2290_s3_q, less_2281_s3_q, less_2280_s3_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s3_en & and_1979_s3_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2377, textured_s3_q};
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
      averager_running_of_skin_q <= select_2542;
      averager_mask_q <= select_2544;
      averager_of_skin_q <= select_2546;
      census_filled_q <= and_512_s3_q ? {select_576[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_512_s3_q ? select_575 : rows_passed_above_q;
      registration_slope_here_q <= select_2967;
      registration_expected_q <= select_2969;
      registration_of_right_q <= equal_1944_s3_q ? registration_of_right_q : select_3029;
      registration_was_inside_q <= equal_1944_s3_q ? registration_was_inside_q : select_3032;
      registration_fresh_q <= select_3041;
      patches_fixed_q <= not_3200 & (patches_fixed_q | (and_3210_s3_q & and_2130));
      patches_choice_valid_q <= and_2155_s3_q ? (select_2149[0] & not_3200) : select_2149[0];
      patches_choice_column_q <= select_2149[8:1];
      patches_choice_shift_q <= select_2149[14:9];
      patches_choice_slope_q <= select_2149[22:15];
      patches_band_q <= sample_pair_whole_s3_q ? select_2170 : patches_band_q;
      patches_fetch_q <= select_3228;
      patches_codes_at_q <= select_3329;
      patches_codes_further_q <= equal_2157_s3_q ? patches_codes_further_q : select_3334;
      patches_next_codes_q <= select_3342;
      patches_set_q <= equal_2157_s3_q ? 3'h0 : (equal_2159_s3_q ? 3'h0 : select_3356);
      patches_size_q <= sum_3360;
      patches_left_row_q <= select_3372;
      patches_summed_row_column_q <= equal_2157_s3_q ? patches_summed_row_column_q : select_3717;
      patches_summed_first_q <= select_3720;
      patches_read_row_differing_q <= equal_2157_s3_q ? select_3732 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2157_s3_q ? select_3739 : patches_read_row_column_q;
      patches_read_at_q <= equal_2157_s3_q ? select_3746 : patches_read_at_q;
      patches_read_first_q <= select_3755;
      patches_read_above_q <= select_3778;
      patches_read_below_q <= select_3787;
      patches_read_far_q <= equal_2157_s3_q ? select_3797 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3800;
      patches_peak_best_column_q <= select_3801;
      patches_peak_row_q <= equal_2157_s3_q ? select_3768 : patches_peak_row_q;
      patches_peak_above_q <= equal_2157_s3_q ? select_3803 : patches_peak_above_q;
      patches_peak_below_q <= equal_2157_s3_q ? select_3805 : patches_peak_below_q;
      patches_peak_far_q <= equal_2157_s3_q ? select_3809 : patches_peak_far_q;
      shown_shown_q <= select_4091;
      shown_nearer_q <= select_4093;
      region_row_q <= and_512_s3_q ? select_4099 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4104;
      region_down_rest_q <= select_4120;
      region_down_back_q <= select_4124;
      region_down_next_q <= select_4126;
      region_fresh_q <= and_512_s3_q ? select_4130 : region_fresh_q;
      segment_starts_q <= select_4141;
      centres_values_0_textured_q <= equal_1944_s3_q ? centres_values_0_textured_q : select_4287;
      centres_values_0_of_skin_q <= select_4292;
      centres_values_1_textured_q <= select_4295;
      centres_values_1_of_skin_q <= select_4298;
      map_row_q <= and_512_s3_q ? select_4302 : map_row_q;
      map_width_q <= select_4305;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2401;
      done_q <= not_2403 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      drew_q <= so_s3_q;
      said_q <= equal_1944_s3_q & equal_4027;
      rows_passed_q <= select_2386;
      columns_passed_q <= {select_2388[7:0], or_2384};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_2405;
      seen_x_q <= select_2407;
      seen_y_q <= marks_first_s3_q ? 3'h0 : select_4316;
      seen_column_q <= select_2398;
      seen_rows_left_q <= select_4322;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2395;
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
      averager_running_0_q <= sample_pair_whole_s3_q ? select_490 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_496 : averager_running_1_q;
      averager_total_0_q <= select_2521;
      averager_total_1_q <= select_2523;
      census_columns_values_0_cell_0_left_q <= select_2547;
      census_columns_values_0_cell_0_right_q <= select_2548;
      census_columns_values_0_cell_0_mask_q <= and_512_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2550;
      census_columns_values_0_cell_1_right_q <= select_2551;
      census_columns_values_0_cell_1_mask_q <= select_2552;
      census_columns_values_0_cell_2_left_q <= select_2553;
      census_columns_values_0_cell_2_right_q <= select_2554;
      census_columns_values_0_cell_2_mask_q <= select_2555;
      census_columns_values_0_cell_2_of_skin_q <= select_2556;
      census_columns_values_0_cell_3_left_q <= select_2557;
      census_columns_values_0_cell_3_right_q <= select_2558;
      census_columns_values_0_cell_3_mask_q <= select_2559;
      census_columns_values_0_cell_4_left_q <= select_2560;
      census_columns_values_0_cell_4_right_q <= select_2561;
      census_columns_values_0_cell_4_mask_q <= select_2562;
      census_columns_values_1_cell_0_left_q <= select_2563;
      census_columns_values_1_cell_0_right_q <= select_2564;
      census_columns_values_1_cell_0_mask_q <= select_2565;
      census_columns_values_1_cell_1_left_q <= select_2566;
      census_columns_values_1_cell_1_right_q <= select_2567;
      census_columns_values_1_cell_1_mask_q <= select_2568;
      census_columns_values_1_cell_2_left_q <= select_2569;
      census_columns_values_1_cell_2_right_q <= select_2570;
      census_columns_values_1_cell_2_mask_q <= select_2571;
      census_columns_values_1_cell_2_of_skin_q <= select_2572;
      census_columns_values_1_cell_3_left_q <= select_2573;
      census_columns_values_1_cell_3_right_q <= select_2574;
      census_columns_values_1_cell_3_mask_q <= select_2575;
      census_columns_values_1_cell_4_left_q <= select_2576;
      census_columns_values_1_cell_4_right_q <= select_2577;
      census_columns_values_1_cell_4_mask_q <= select_2578;
      census_columns_values_2_cell_0_left_q <= select_2579;
      census_columns_values_2_cell_0_right_q <= select_2580;
      census_columns_values_2_cell_0_mask_q <= select_2581;
      census_columns_values_2_cell_1_left_q <= select_2582;
      census_columns_values_2_cell_1_right_q <= select_2583;
      census_columns_values_2_cell_1_mask_q <= select_2584;
      census_columns_values_2_cell_2_left_q <= select_2585;
      census_columns_values_2_cell_2_right_q <= select_2586;
      census_columns_values_2_cell_2_mask_q <= select_2587;
      census_columns_values_2_cell_3_left_q <= select_2588;
      census_columns_values_2_cell_3_right_q <= select_2589;
      census_columns_values_2_cell_3_mask_q <= select_2590;
      census_columns_values_2_cell_4_left_q <= select_2591;
      census_columns_values_2_cell_4_right_q <= select_2592;
      census_columns_values_2_cell_4_mask_q <= select_2593;
      census_columns_values_3_cell_0_mask_q <= select_2594;
      census_columns_values_3_cell_1_left_q <= select_2595;
      census_columns_values_3_cell_1_right_q <= select_2596;
      census_columns_values_3_cell_1_mask_q <= select_2597;
      census_columns_values_3_cell_2_mask_q <= select_2598;
      census_columns_values_3_cell_3_left_q <= select_2599;
      census_columns_values_3_cell_3_right_q <= select_2600;
      census_columns_values_3_cell_3_mask_q <= select_2601;
      census_columns_values_3_cell_4_mask_q <= select_2602;
      sharpness_last_mean_0_q <= and_512_s3_q ? select_518 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_512_s3_q ? select_522 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1944_s3_q ? box_textured_columns_values_0_q : select_4215;
      box_textured_columns_values_1_q <= select_4219;
      box_textured_columns_values_2_q <= select_4222;
      box_textured_columns_values_3_q <= select_4225;
      box_textured_columns_values_4_q <= select_4228;
      box_textured_sum_sums_values_0_q <= equal_1944_s3_q ? box_textured_sum_sums_values_0_q : select_4230;
      box_explained_columns_values_0_q <= equal_1944_s3_q ? box_explained_columns_values_0_q : select_4233;
      box_explained_columns_values_1_q <= select_4237;
      box_explained_columns_values_2_q <= select_4240;
      box_explained_columns_values_3_q <= select_4243;
      box_explained_columns_values_4_q <= select_4246;
      box_explained_sum_sums_values_0_q <= select_4249;
      box_shown_columns_values_0_q <= equal_1944_s3_q ? box_shown_columns_values_0_q : select_4251;
      box_shown_columns_values_1_q <= select_4255;
      box_shown_columns_values_2_q <= select_4258;
      box_shown_columns_values_3_q <= select_4261;
      box_shown_columns_values_4_q <= select_4264;
      box_shown_sum_sums_values_0_q <= equal_1944_s3_q ? box_shown_sum_sums_values_0_q : select_4266;
      box_nearer_columns_values_0_q <= equal_1944_s3_q ? box_nearer_columns_values_0_q : select_4269;
      box_nearer_columns_values_1_q <= select_4273;
      box_nearer_columns_values_2_q <= select_4276;
      box_nearer_columns_values_3_q <= select_4279;
      box_nearer_columns_values_4_q <= select_4282;
      box_nearer_sum_sums_values_0_q <= equal_1944_s3_q ? box_nearer_sum_sums_values_0_q : select_4284;
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
  logic [2:0] select_476_s4_q;
  logic [6:0] select_478_s4_q;
  logic [6:0] column_s4_q;
  logic and_510_s4_q;
  logic and_512_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_515_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
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
  logic less_566_s4_q;
  logic less_567_s4_q;
  logic less_568_s4_q;
  logic less_569_s4_q;
  logic and_577_s4_q;
  logic and_602_s4_q;
  logic and_603_s4_q;
  logic [11:0] sum_618_s4_q;
  logic [9:0] sum_621_s4_q;
  logic equal_1944_s4_q;
  logic not_1945_s4_q;
  logic equal_1989_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1995_s4_q;
  logic equal_1997_s4_q;
  logic equal_1999_s4_q;
  logic equal_2001_s4_q;
  logic equal_2003_s4_q;
  logic equal_2005_s4_q;
  logic equal_2007_s4_q;
  logic equal_2009_s4_q;
  logic equal_2011_s4_q;
  logic less_2020_s4_q;
  logic or_2024_s4_q;
  logic equal_2044_s4_q;
  logic and_2054_s4_q;
  logic and_2057_s4_q;
  logic select_2074_s4_q;
  logic equal_2075_s4_q;
  logic and_2083_s4_q;
  logic equal_2085_s4_q;
  logic select_2149_s4_q;
  logic and_2156_s4_q;
  logic equal_2157_s4_q;
  logic equal_2159_s4_q;
  logic and_2172_s4_q;
  logic [4:0] select_2187_s4_q;
  logic select_2193_s4_q;
  logic [3:0] select_2234_s4_q;
  logic less_2320_s4_q;
  logic equal_2321_s4_q;
  logic not_2322_s4_q;
  logic equal_2323_s4_q;
  logic or_2341_s4_q;
  logic or_2344_s4_q;
  logic or_2347_s4_q;
  logic not_2349_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_2370_s4_q;
  logic and_2375_s4_q;
  logic and_2409_s4_q;
  logic less_2410_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_2415_s4_q;
  logic equal_2428_s4_q;
  logic or_2433_s4_q;
  logic or_2436_s4_q;
  logic or_2439_s4_q;
  logic not_2464_s4_q;
  logic less_2478_s4_q;
  logic and_2489_s4_q;
  logic [11:0] sum_2618_s4_q;
  logic [9:0] sum_2621_s4_q;
  logic equal_2629_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2858_s4_q;
  logic and_2862_s4_q;
  logic not_2896_s4_q;
  logic and_2924_s4_q;
  logic and_2973_s4_q;
  logic and_2974_s4_q;
  logic [7:0] residual_s4_q;
  logic and_3008_s4_q;
  logic and_3022_s4_q;
  logic equal_3065_s4_q;
  logic parity_3444_s4_q;
  logic parity_3573_s4_q;
  logic parity_3635_s4_q;
  logic xor_3663_s4_q;
  logic parity_3675_s4_q;
  logic or_3679_s4_q;
  logic equal_3680_s4_q;
  logic [4:0] select_3799_s4_q;
  logic equal_3811_s4_q;
  logic less_3813_s4_q;
  logic less_3814_s4_q;
  logic or_3819_s4_q;
  logic [7:0] select_3864_s4_q;
  logic equal_4027_s4_q;
  logic and_4328_s4_q;
  logic not_4343_s4_q;
  logic equal_4391_s4_q;
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
      select_476_s4_q <= select_476_s3_q;
      select_478_s4_q <= select_478_s3_q;
      column_s4_q <= column_s3_q;
      and_510_s4_q <= and_510_s3_q;
      and_512_s4_q <= and_512_s3_q;
      grey_s4_q <= grey;
      equal_515_s4_q <= equal_515;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
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
      less_566_s4_q <= less_566;
      less_567_s4_q <= less_567;
      less_568_s4_q <= less_568;
      less_569_s4_q <= less_569;
      and_577_s4_q <= and_577;
      and_602_s4_q <= whole_22 & and_577;
      and_603_s4_q <= census_columns_values_1_cell_2_mask_q & and_577;
      sum_618_s4_q <= {1'b0, sum_614} + {2'h0, sum_617};
      sum_621_s4_q <= {9'h0, difference_619[9]} + {1'b0, xor_620};
      equal_1944_s4_q <= equal_1944_s3_q;
      not_1945_s4_q <= not_1945_s3_q;
      equal_1989_s4_q <= equal_1989;
      all_s4_q <= all;
      sum_1995_s4_q <= sum_1995;
      equal_1997_s4_q <= equal_1997;
      equal_1999_s4_q <= equal_1999;
      equal_2001_s4_q <= equal_2001;
      equal_2003_s4_q <= equal_2003;
      equal_2005_s4_q <= equal_2005;
      equal_2007_s4_q <= equal_2007;
      equal_2009_s4_q <= equal_2009;
      equal_2011_s4_q <= equal_2011;
      less_2020_s4_q <= less_2020;
      or_2024_s4_q <= or_2024;
      equal_2044_s4_q <= (registration_fresh_q & select_2042) == 4'h0;
      and_2054_s4_q <= not_1945_s3_q & and_2038;
      and_2057_s4_q <= and_2057_s3_q;
      select_2074_s4_q <= select_2074[1];
      equal_2075_s4_q <= equal_2075;
      and_2083_s4_q <= and_2083_s3_q;
      equal_2085_s4_q <= equal_2085;
      select_2149_s4_q <= select_2149[0];
      and_2156_s4_q <= and_2156_s3_q;
      equal_2157_s4_q <= equal_2157_s3_q;
      equal_2159_s4_q <= equal_2159_s3_q;
      and_2172_s4_q <= and_2156_s3_q & equal_2171;
      select_2187_s4_q <= select_2187_s3_q;
      select_2193_s4_q <= select_2193_s3_q;
      select_2234_s4_q <= select_2234_s3_q;
      less_2320_s4_q <= less_2320_s3_q;
      equal_2321_s4_q <= equal_2321_s3_q;
      not_2322_s4_q <= not_2322_s3_q;
      equal_2323_s4_q <= equal_2323_s3_q;
      or_2341_s4_q <= or_2341;
      or_2344_s4_q <= or_2344;
      or_2347_s4_q <= or_2347;
      not_2349_s4_q <= not_2349;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_2370_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_2375_s4_q <= not_1945_s3_q & and_2356;
      and_2409_s4_q <= and_2409;
      less_2410_s4_q <= less_2410;
      index_2_s4_q <= index_2[5:0];
      sum_2415_s4_q <= sum_2415;
      equal_2428_s4_q <= t[4:1] == 4'h0;
      or_2433_s4_q <= or_2433;
      or_2436_s4_q <= select_2430[7] | (~({select_2430[6], select_2430[3:2]} == 3'h0));
      or_2439_s4_q <= select_2430[7] | (~(select_2430[6:4] == 3'h0));
      not_2464_s4_q <= ~({sum_2462, around[0]} < {2'h0, t});
      less_2478_s4_q <= {1'b0, around[4:1]} < n;
      and_2489_s4_q <= and_2489_s3_q;
      sum_2618_s4_q <= {1'b0, sum_2614} + {2'h0, sum_2617};
      sum_2621_s4_q <= {9'h0, difference_2619[9]} + {1'b0, xor_2620};
      equal_2629_s4_q <= equal_2629_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2858_s4_q <= and_2858;
      and_2862_s4_q <= and_2862;
      not_2896_s4_q <= ~({sum_2894, e[0]} < {2'h0, t});
      and_2924_s4_q <= not_1945_s3_q & and_2923;
      and_2973_s4_q <= not_1945_s3_q & (so_s3_q & (half_ends & equal_2970));
      and_2974_s4_q <= and_2974;
      residual_s4_q <= residual[7:0];
      and_3008_s4_q <= and_3008;
      and_3022_s4_q <= and_2974 & less_3021;
      equal_3065_s4_q <= (registration_fresh_q & select_3063) == 4'h0;
      parity_3444_s4_q <= ^{xor_3440, xor_3403, select_3370[44:36], other[44:36]};
      parity_3573_s4_q <= parity_3573;
      parity_3635_s4_q <= parity_3635;
      xor_3663_s4_q <= parity_3650 ^ parity_3662;
      parity_3675_s4_q <= ^{or_3672, or_3668, and_3664};
      or_3679_s4_q <= (or_3668 & or_3672) | (and_3664 & (or_3668 | or_3672));
      equal_3680_s4_q <= equal_3680_s3_q;
      select_3799_s4_q <= select_3799[14:10];
      equal_3811_s4_q <= select_3768[3:0] == 4'h0;
      less_3813_s4_q <= {difference_3812, 3'h0} < {3'h0, sum_3360};
      less_3814_s4_q <= select_3809 < select_3799[9:0];
      or_3819_s4_q <= (sum_3360 < 10'h39) | ({1'b0, sum_3360[9:1]} < select_3799[9:0]);
      select_3864_s4_q <= select_3864;
      equal_4027_s4_q <= equal_4027;
      and_4328_s4_q <= and_4328;
      not_4343_s4_q <= ~proven_q;
      equal_4391_s4_q <= (registration_fresh_q & select_4389) == 4'h0;
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
  assign texture = sum_618_s4_q + {2'h0, sum_621_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_623;
  assign sum_623 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_625;
  assign sum_625 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_623});
  // hls/stages/census.hpp:303
  logic less_626;
  assign less_626 = 9'h4 < sum_625[13:5];
  logic and_627;
  assign and_627 = and_577_s4_q & less_626;
  // hls/stages/registration.hpp:265
  logic equal_2046;
  assign equal_2046 = sum_1995_s4_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1995_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2048;
  assign select_2048 = equal_2046 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2049;
  assign sum_2049 = (equal_2044_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2048[13]}}, select_2048};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1995_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2052;
  assign select_2052 = equal_2046 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2053;
  assign sum_2053 = (equal_2044_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2052[6]}}, select_2052};
  // hls/stages/patches.hpp:352
  logic [22:0] select_2173;
  assign select_2173 = and_2172_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2149_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2175;
  assign select_2175 = equal_2075_s4_q ? patches_place_0_valid_q : (select_2074_s4_q ? patches_place_0_valid_q : select_2173[0]);
  // hls/stages/patches.hpp:353
  logic [21:0] select_2176;
  assign select_2176 = select_2074_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2173[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2177;
  assign select_2177 = equal_2075_s4_q ? patches_place_0_column_q : select_2176[7:0];
  logic [5:0] select_2178;
  assign select_2178 = equal_2075_s4_q ? patches_place_0_shift_q : select_2176[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2179;
  assign sum_2179 = select_2177 + {{2{select_2178[5]}}, select_2178};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2180;
  assign sum_2180 = sum_2179[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2181;
  assign equal_2181 = {sum_2180[6], select_478_s4_q, select_476_s4_q} == {1'b0, sum_2180[5:0], sum_2179[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2183;
  assign or_2183 = and_2057_s4_q | (select_2175 & equal_2181);
  // hls/stages/agreement.hpp:267
  logic [4:0] select_2184;
  assign select_2184 = or_2183 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2194;
  assign select_2194 = or_2183 ? {and_2057_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_2196;
  assign and_2196 = select_2193_s4_q & (~select_2194[5]);
  // hls/stages/patches.hpp:127
  logic select_2204;
  assign select_2204 = equal_2075_s4_q ? patches_place_1_valid_q : (select_2074_s4_q ? select_2173[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:353
  logic [21:0] select_2205;
  assign select_2205 = select_2074_s4_q ? select_2173[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2206;
  assign select_2206 = equal_2075_s4_q ? patches_place_1_column_q : select_2205[7:0];
  logic [5:0] select_2207;
  assign select_2207 = equal_2075_s4_q ? patches_place_1_shift_q : select_2205[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2208;
  assign sum_2208 = select_2206 + {{2{select_2207[5]}}, select_2207};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2209;
  assign sum_2209 = sum_2208[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2210;
  assign equal_2210 = {sum_2209[6], select_478_s4_q, select_476_s4_q} == {1'b0, sum_2209[5:0], sum_2208[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2212;
  assign or_2212 = and_2057_s4_q | (select_2204 & equal_2210);
  // hls/stages/agreement.hpp:267
  logic [4:0] select_2213;
  assign select_2213 = or_2212 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2214;
  assign select_2214 = or_2212 ? {and_2057_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_2216;
  assign and_2216 = select_2193_s4_q & (~select_2214[5]);
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2223;
  assign sum_2223 = select_2177 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2224;
  assign equal_2224 = {sum_2223[7], select_478_s4_q, select_476_s4_q} == {1'b0, sum_2223[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_2226;
  assign or_2226 = and_2057_s4_q | (select_2175 & equal_2224);
  logic [4:0] select_2227;
  assign select_2227 = or_2226 ? {and_2057_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2228;
  assign sum_2228 = select_2206 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2229;
  assign equal_2229 = {sum_2228[7], select_478_s4_q, select_476_s4_q} == {1'b0, sum_2228[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_2232;
  assign select_2232 = (and_2057_s4_q | (select_2204 & equal_2229)) ? {and_2057_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_7;
  assign column_7 = select_2227[4] ? select_2232[3:0] : select_2227[3:0];
  // hls/stages/agreement.hpp:267
  logic select_2235;
  assign select_2235 = or_2226 ? and_2057_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_2241;
  assign and_2241 = (select_2193_s4_q & (select_2187_s4_q[3] ^ select_2187_s4_q[4])) & ((~select_2227[4]) | (~select_2232[4]));
  // hls/stages/patches.hpp:184
  logic less_2332;
  assign less_2332 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_2333;
  assign not_2333 = ~less_2332;
  logic [1:0] select_2334;
  assign select_2334 = patches_summed_first_s4_q ? 2'h2 : {less_2332, not_2333};
  logic [12:0] select_2335;
  assign select_2335 = select_2334[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2336;
  assign select_2336 = select_2334[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2337;
  assign select_2337 = select_2334[1] ? {select_2335[12:8], patches_sums_values_0_q[9:8], select_2335[7:0]} : select_2336;
  // hls/stages/agreement.hpp:879
  logic [6:0] select_2360;
  assign select_2360 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:880
  logic [6:0] sum_2361;
  assign sum_2361 = {6'h0, textured_s4_q} + select_2360;
  // hls/stages/agreement.hpp:1016
  logic [9:0] sum_2363;
  assign sum_2363 = {3'h0, sum_2361} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:879
  logic [6:0] select_2365;
  assign select_2365 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:880
  logic [6:0] sum_2366;
  assign sum_2366 = {6'h0, explained_s4_q} + select_2365;
  // hls/stages/agreement.hpp:1017
  logic [9:0] sum_2368;
  assign sum_2368 = {3'h0, sum_2366} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:879
  logic [6:0] select_2371;
  assign select_2371 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:881
  logic [6:0] sum_2372;
  assign sum_2372 = {6'h0, and_2370_s4_q} + select_2371;
  // hls/stages/agreement.hpp:1018
  logic [9:0] sum_2374;
  assign sum_2374 = {3'h0, sum_2372} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1056
  logic not_2440;
  assign not_2440 = ~region_row_s4_q[2];
  logic [2:0] select_2441;
  assign select_2441 = region_row_s4_q[1] ? {1'b0, not_2440, 1'b0} : {region_row_s4_q[2], 1'b0, not_2440};
  logic [5:0] select_2442;
  assign select_2442 = region_row_s4_q[0] ? {select_2441[2], 1'b0, select_2441[1], 1'b0, select_2441[0], 1'b0} : {1'b0, select_2441[2], 1'b0, select_2441[1], 1'b0, select_2441[0]};
  logic [11:0] select_2443;
  assign select_2443 = or_2439_s4_q ? {select_2442[5], 1'b0, select_2442[4], 1'b0, select_2442[3], 1'b0, select_2442[2], 1'b0, select_2442[1], 1'b0, select_2442[0], 1'b0} : {1'b0, select_2442[5], 1'b0, select_2442[4], 1'b0, select_2442[3], 1'b0, select_2442[2], 1'b0, select_2442[1], 1'b0, select_2442[0]};
  logic [23:0] select_2444;
  assign select_2444 = or_2436_s4_q ? {select_2443[11], 1'b0, select_2443[10], 1'b0, select_2443[9], 1'b0, select_2443[8], 1'b0, select_2443[7], 1'b0, select_2443[6], 1'b0, select_2443[5], 1'b0, select_2443[4], 1'b0, select_2443[3], 1'b0, select_2443[2], 1'b0, select_2443[1], 1'b0, select_2443[0], 1'b0} : {1'b0, select_2443[11], 1'b0, select_2443[10], 1'b0, select_2443[9], 1'b0, select_2443[8], 1'b0, select_2443[7], 1'b0, select_2443[6], 1'b0, select_2443[5], 1'b0, select_2443[4], 1'b0, select_2443[3], 1'b0, select_2443[2], 1'b0, select_2443[1], 1'b0, select_2443[0]};
  logic [47:0] select_2445;
  assign select_2445 = or_2433_s4_q ? {select_2444[23], 1'b0, select_2444[22], 1'b0, select_2444[21], 1'b0, select_2444[20], 1'b0, select_2444[19], 1'b0, select_2444[18], 1'b0, select_2444[17], 1'b0, select_2444[16], 1'b0, select_2444[15], 1'b0, select_2444[14], 1'b0, select_2444[13], 1'b0, select_2444[12], 1'b0, select_2444[11], 1'b0, select_2444[10], 1'b0, select_2444[9], 1'b0, select_2444[8], 1'b0, select_2444[7], 1'b0, select_2444[6], 1'b0, select_2444[5], 1'b0, select_2444[4], 1'b0, select_2444[3], 1'b0, select_2444[2], 1'b0, select_2444[1], 1'b0, select_2444[0], 1'b0} : {1'b0, select_2444[23], 1'b0, select_2444[22], 1'b0, select_2444[21], 1'b0, select_2444[20], 1'b0, select_2444[19], 1'b0, select_2444[18], 1'b0, select_2444[17], 1'b0, select_2444[16], 1'b0, select_2444[15], 1'b0, select_2444[14], 1'b0, select_2444[13], 1'b0, select_2444[12], 1'b0, select_2444[11], 1'b0, select_2444[10], 1'b0, select_2444[9], 1'b0, select_2444[8], 1'b0, select_2444[7], 1'b0, select_2444[6], 1'b0, select_2444[5], 1'b0, select_2444[4], 1'b0, select_2444[3], 1'b0, select_2444[2], 1'b0, select_2444[1], 1'b0, select_2444[0]};
  // hls/stages/agreement.hpp:989
  logic and_2449;
  assign and_2449 = good_known_q & (~((good_q & select_2445) == 48'h0));
  // hls/stages/agreement.hpp:1058
  logic is_seen;
  assign is_seen = equal_2428_s4_q ? and_2449 : not_2464_s4_q;
  // hls/stages/agreement.hpp:1067
  logic and_2479;
  assign and_2479 = is_seen & less_2478_s4_q;
  // hls/stages/agreement.hpp:267
  logic [8:0] select_2513;
  assign select_2513 = sample_pair_whole_s4_q ? (and_510_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2515;
  assign select_2515 = sample_pair_whole_s4_q ? (and_510_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2517;
  assign select_2517 = sample_pair_whole_s4_q ? (and_510_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2519;
  assign select_2519 = sample_pair_whole_s4_q ? (and_510_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2524;
  assign sum_2524 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2525;
  assign difference_2525 = {1'b0, sum_2524[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2526;
  assign xor_2526 = {difference_2525[8:0], sum_2524[0]} ^ {10{difference_2525[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2525[9]} + {1'b0, xor_2526};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_515_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:267
  logic [13:0] select_2531;
  assign select_2531 = sample_pair_whole_s4_q ? (and_510_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2532;
  assign sum_2532 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2533;
  assign difference_2533 = {1'b0, sum_2532[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2534;
  assign xor_2534 = {difference_2533[8:0], sum_2532[0]} ^ {10{difference_2533[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2533[9]} + {1'b0, xor_2534};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_515_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:267
  logic [13:0] select_2539;
  assign select_2539 = sample_pair_whole_s4_q ? (and_510_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2622;
  assign sum_2622 = sum_2618_s4_q + {2'h0, sum_2621_s4_q};
  // hls/stages/agreement.hpp:511
  logic [11:0] select_2624;
  assign select_2624 = and_512_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2625;
  assign select_2625 = and_512_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2626;
  assign select_2626 = and_512_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2627;
  assign select_2627 = and_512_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2630;
  assign sum_2630 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2622};
  logic [13:0] sum_2632;
  assign sum_2632 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2630});
  // hls/stages/census.hpp:305
  logic and_2634;
  assign and_2634 = and_602_s4_q & (9'h4 < sum_2632[13:5]);
  // hls/stages/census.hpp:306
  logic and_2635;
  assign and_2635 = and_602_s4_q & less_626;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2636;
  assign sum_2636 = census_left_misses_q + {{17{and_2635}}, and_2634, 1'b0, and_2634};
  // hls/stages/agreement.hpp:511
  logic [19:0] select_2638;
  assign select_2638 = and_512_s4_q ? (equal_2629_s4_q ? 20'h0 : sum_2636) : census_left_misses_q;
  // hls/stages/agreement.hpp:267
  logic [27:0] select_2643;
  assign select_2643 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:511
  logic select_2646;
  assign select_2646 = and_512_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2649;
  assign and_2649 = whole_2_s4_q & (~(column_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:448
  logic and_2655;
  assign and_2655 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2656;
  assign and_2656 = and_2649 & and_2655;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2643[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2658;
  assign select_2658 = and_2656 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2660;
  assign select_2660 = equal_2629_s4_q ? {11'h0, select_2658} : (sharpness_sums_detail_0_q + {11'h0, select_2658});
  // hls/stages/agreement.hpp:448
  logic and_2667;
  assign and_2667 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2668;
  assign and_2668 = and_2649 & and_2667;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2643[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2670;
  assign select_2670 = and_2668 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2672;
  assign select_2672 = equal_2629_s4_q ? {11'h0, select_2670} : (sharpness_sums_detail_1_q + {11'h0, select_2670});
  logic [8:0] select_2675;
  assign select_2675 = and_2656 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2676;
  assign sum_2676 = (equal_2629_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2675};
  logic [8:0] select_2679;
  assign select_2679 = and_2668 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2680;
  assign sum_2680 = (equal_2629_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2679};
  // hls/stages/agreement.hpp:206
  logic equal_2682;
  assign equal_2682 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2683;
  assign less_2683 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2684;
  assign less_2684 = x_s4_q[4:0] < 5'h3;
  logic not_2685;
  assign not_2685 = ~x_s4_q[1];
  logic [2:0] select_2686;
  assign select_2686 = x_s4_q[0] ? {1'b0, not_2685, 1'b0} : {x_s4_q[1], 1'b0, not_2685};
  logic [5:0] select_2687;
  assign select_2687 = slot_s4_q[2] ? {select_2686[2], 1'b0, select_2686[1], 1'b0, select_2686[0], 1'b0} : {1'b0, select_2686[2], 1'b0, select_2686[1], 1'b0, select_2686[0]};
  logic [11:0] select_2688;
  assign select_2688 = slot_s4_q[1] ? {select_2687[5], 1'b0, select_2687[4], 1'b0, select_2687[3], 1'b0, select_2687[2], 1'b0, select_2687[1], 1'b0, select_2687[0], 1'b0} : {1'b0, select_2687[5], 1'b0, select_2687[4], 1'b0, select_2687[3], 1'b0, select_2687[2], 1'b0, select_2687[1], 1'b0, select_2687[0]};
  logic [23:0] select_2689;
  assign select_2689 = slot_s4_q[0] ? {select_2688[11], 1'b0, select_2688[10], 1'b0, select_2688[9], 1'b0, select_2688[8], 1'b0, select_2688[7], 1'b0, select_2688[6], 1'b0, select_2688[5], 1'b0, select_2688[4], 1'b0, select_2688[3], 1'b0, select_2688[2], 1'b0, select_2688[1], 1'b0, select_2688[0], 1'b0} : {1'b0, select_2688[11], 1'b0, select_2688[10], 1'b0, select_2688[9], 1'b0, select_2688[8], 1'b0, select_2688[7], 1'b0, select_2688[6], 1'b0, select_2688[5], 1'b0, select_2688[4], 1'b0, select_2688[3], 1'b0, select_2688[2], 1'b0, select_2688[1], 1'b0, select_2688[0]};
  // hls/stages/census.hpp:372
  logic and_2693;
  assign and_2693 = less_2684 & (~((sharpness_sums_contrast_1_q & select_2689) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2695;
  assign select_2695 = (less_2683 & and_2693) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2695};
  // hls/stages/agreement.hpp:210
  logic [17:0] select_2698;
  assign select_2698 = equal_2682 ? (less_2683 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2703;
  assign and_2703 = less_2684 & (~((sharpness_sums_contrast_0_q & select_2689) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2705;
  assign select_2705 = (less_2683 & and_2703) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2705};
  // hls/stages/agreement.hpp:210
  logic [17:0] select_2708;
  assign select_2708 = equal_2682 ? (less_2683 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2710;
  assign select_2710 = equal_2682 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2712;
  assign select_2712 = equal_2682 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2714;
  assign select_2714 = equal_2682 ? {sharpness_comparing_contrast_0_q[0], and_2703} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2716;
  assign select_2716 = equal_2682 ? {sharpness_comparing_contrast_1_q[0], and_2693} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:210
  logic select_2721;
  assign select_2721 = drew_q ? (equal_2682 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:210
  logic select_2725;
  assign select_2725 = drew_q ? (equal_2682 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2726;
  assign equal_2726 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2727;
  assign xor_2727 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2730;
  assign select_2730 = (equal_2726 | xor_2727) ? (five_times[0] & xor_2727) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:210
  logic select_2732;
  assign select_2732 = drew_q ? (equal_2682 ? select_2730 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2733;
  assign xor_2733 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2736;
  assign select_2736 = (equal_2726 | xor_2733) ? (five_times_2[0] & xor_2733) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:210
  logic select_2738;
  assign select_2738 = drew_q ? (equal_2682 ? select_2736 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2739;
  assign xor_2739 = sharpness_comparing_contrast_0_q[1] ^ and_2693;
  logic select_2742;
  assign select_2742 = (equal_2726 | xor_2739) ? (and_2693 & xor_2739) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:210
  logic select_2744;
  assign select_2744 = drew_q ? (equal_2682 ? select_2742 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2745;
  assign xor_2745 = sharpness_comparing_contrast_1_q[1] ^ and_2703;
  logic select_2748;
  assign select_2748 = (equal_2726 | xor_2745) ? (and_2703 & xor_2745) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:210
  logic select_2750;
  assign select_2750 = drew_q ? (equal_2682 ? select_2748 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2864;
  assign select_2864 = and_2858_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2862_s4_q});
  // hls/stages/agreement.hpp:776
  logic and_2867;
  assign and_2867 = not_1945_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2872;
  assign and_2872 = not_1945_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2877;
  assign and_2877 = not_1945_s4_q & (drew_q & (ends_cell_s4_q & and_2370_s4_q));
  // hls/stages/agreement.hpp:1060
  logic not_2881;
  assign not_2881 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1061
  logic not_2898;
  assign not_2898 = ~(equal_2428_s4_q ? and_2449 : not_2896_s4_q);
  // hls/stages/agreement.hpp:776
  logic and_2901;
  assign and_2901 = ends_cell_s4_q & (not_2881 & (centres_values_1_textured_s4_q & not_2898));
  logic and_2903;
  assign and_2903 = not_1945_s4_q & (drew_q & and_2901);
  // hls/stages/agreement.hpp:1087
  logic less_2906;
  assign less_2906 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2907;
  assign select_2907 = less_2906 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2910;
  assign select_2910 = less_2906 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1088
  logic [10:0] sum_2911;
  assign sum_2911 = {1'b0, select_2910} + {3'h0, select_2910[9:2]};
  logic and_2913;
  assign and_2913 = (~(select_2907[9:4] == 6'h0)) & ({sum_2911, select_2910[1:0]} < {3'h0, select_2907});
  // hls/stages/agreement.hpp:1097
  logic [9:0] select_2916;
  assign select_2916 = x_s4_q[6] ? (equal_1989_s4_q ? 10'h0 : (and_2913 ? select_2907 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:776
  logic [9:0] select_2917;
  assign select_2917 = equal_1944_s4_q ? select_2916 : 10'h0;
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2919;
  assign select_2919 = and_2858_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2917});
  logic [13:0] select_2926;
  assign select_2926 = and_2858_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2924_s4_q});
  // hls/stages/agreement.hpp:1065
  logic and_2928;
  assign and_2928 = not_2881 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:776
  logic and_2931;
  assign and_2931 = not_1945_s4_q & (drew_q & (ends_cell_s4_q & and_2928));
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2933;
  assign select_2933 = and_2858_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2931});
  // hls/stages/agreement.hpp:1065
  logic and_2935;
  assign and_2935 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2898);
  // hls/stages/agreement.hpp:776
  logic and_2939;
  assign and_2939 = not_1945_s4_q & (drew_q & (ends_cell_s4_q & (not_2881 & and_2935)));
  // hls/stages/agreement.hpp:902
  logic [13:0] select_2941;
  assign select_2941 = and_2858_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2939});
  // hls/stages/agreement.hpp:776
  logic [7:0] select_2990;
  assign select_2990 = drew_q ? (equal_2085_s4_q ? (and_2974_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2991;
  assign select_2991 = equal_1944_s4_q ? 8'h0 : select_2990;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2993;
  assign select_2993 = and_2973_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2991[7]}}, select_2991});
  // hls/stages/agreement.hpp:776
  logic and_2996;
  assign and_2996 = not_1945_s4_q & (drew_q & (and_2974_s4_q & equal_2085_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2998;
  assign select_2998 = and_2973_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2996});
  // hls/stages/registration.hpp:107
  logic and_3000;
  assign and_3000 = and_2974_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:776
  logic [1:0] select_3002;
  assign select_3002 = drew_q ? (equal_2085_s4_q ? {and_3000, and_2974_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3003;
  assign select_3003 = equal_1944_s4_q ? 2'h0 : select_3002;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3004;
  assign sum_3004 = registration_half_votes_down_q + {{5{select_3003[1]}}, select_3003};
  // hls/stages/agreement.hpp:776
  logic [1:0] select_3010;
  assign select_3010 = drew_q ? (equal_2085_s4_q ? {and_3008_s4_q, and_2974_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3011;
  assign select_3011 = equal_1944_s4_q ? 2'h0 : select_3010;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3012;
  assign sum_3012 = registration_half_votes_up_q + {{5{select_3011[1]}}, select_3011};
  // hls/stages/registration.hpp:107
  logic and_3015;
  assign and_3015 = and_2974_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:776
  logic [1:0] select_3017;
  assign select_3017 = drew_q ? (equal_2085_s4_q ? {and_3015, and_2974_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3018;
  assign select_3018 = equal_1944_s4_q ? 2'h0 : select_3017;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3019;
  assign sum_3019 = registration_half_half_votes_down_q + {{5{select_3018[1]}}, select_3018};
  // hls/stages/agreement.hpp:776
  logic [1:0] select_3024;
  assign select_3024 = drew_q ? (equal_2085_s4_q ? {and_3022_s4_q, and_2974_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3025;
  assign select_3025 = equal_1944_s4_q ? 2'h0 : select_3024;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3026;
  assign sum_3026 = registration_half_half_votes_up_q + {{5{select_3025[1]}}, select_3025};
  // hls/stages/agreement.hpp:776
  logic and_3060;
  assign and_3060 = equal_1944_s4_q & (x_s4_q[6] & (not_2349_s4_q & less_2020_s4_q));
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_3067;
  assign select_3067 = or_2024_s4_q ? 12'h0 : (equal_3065_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1097
  logic [11:0] select_3070;
  assign select_3070 = x_s4_q[6] ? (equal_1989_s4_q ? 12'h0 : (less_2020_s4_q ? select_3067 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:776
  logic [11:0] select_3071;
  assign select_3071 = equal_1944_s4_q ? select_3070 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3072;
  assign and_3072 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1097
  logic and_3075;
  assign and_3075 = not_2349_s4_q & (less_2020_s4_q & ({and_3072, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:776
  logic and_3077;
  assign and_3077 = equal_1944_s4_q & (x_s4_q[6] & and_3075);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3079;
  assign sum_3079 = {{2{select_3071[11]}}, select_3071} + (and_3077 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1085
  logic [11:0] select_3082;
  assign select_3082 = or_2024_s4_q ? 12'h0 : (equal_3065_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1097
  logic [11:0] select_3085;
  assign select_3085 = x_s4_q[6] ? (equal_1989_s4_q ? 12'h0 : (less_2020_s4_q ? select_3082 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:776
  logic [11:0] select_3086;
  assign select_3086 = equal_1944_s4_q ? select_3085 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3088;
  assign sum_3088 = {{2{select_3086[11]}}, select_3086} + (and_3077 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3090;
  assign not_3090 = ~all_s4_q;
  // hls/stages/agreement.hpp:1097
  logic and_3093;
  assign and_3093 = not_2349_s4_q & (less_2020_s4_q & (x_s4_q[2:0] == {all_s4_q, not_3090, 1'b0}));
  // hls/stages/agreement.hpp:776
  logic and_3099;
  assign and_3099 = equal_1944_s4_q & (x_s4_q[6] & (not_2349_s4_q & (less_2020_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_3100;
  assign not_3100 = ~and_3099;
  logic less_3101;
  assign less_3101 = $signed({9'h1, {2{not_3100}}, and_3099}) < $signed(registration_up_q[13:2]);
  logic select_3102;
  assign select_3102 = (equal_1944_s4_q & (x_s4_q[6] & and_3093)) ? less_3101 : registration_enough_q;
  // hls/stages/agreement.hpp:1097
  logic and_3106;
  assign and_3106 = x_s4_q[6] & (not_2349_s4_q & (less_2020_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:776
  logic and_3107;
  assign and_3107 = equal_1944_s4_q & and_3106;
  // hls/stages/registration.hpp:242
  logic less_3108;
  assign less_3108 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3110;
  assign less_3110 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3112;
  assign equal_3112 = x_s4_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:776
  logic and_3116;
  assign and_3116 = equal_1944_s4_q & (x_s4_q[6] & (not_2349_s4_q & (less_2020_s4_q & equal_3112)));
  // hls/stages/agreement.hpp:1097
  logic and_3123;
  assign and_3123 = x_s4_q[6] & (not_2349_s4_q & (less_2020_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3126;
  assign equal_3126 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1097
  logic and_3129;
  assign and_3129 = not_2349_s4_q & (less_2020_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_3126));
  // hls/stages/registration.hpp:244
  logic and_3133;
  assign and_3133 = (equal_1944_s4_q & (x_s4_q[6] & and_3129)) & (less_3110 | less_3108);
  // hls/stages/agreement.hpp:1097
  logic and_3138;
  assign and_3138 = not_2349_s4_q & (less_2020_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_3126)));
  // hls/stages/registration.hpp:244
  logic and_3141;
  assign and_3141 = registration_votes_up_q & registration_other_down_q;
  logic select_3143;
  assign select_3143 = registration_votes_down_q ? (registration_other_up_q | and_3141) : and_3141;
  // hls/stages/registration.hpp:138
  logic and_3145;
  assign and_3145 = (equal_1944_s4_q & (x_s4_q[6] & and_3138)) & (registration_other_enough_q & select_3143);
  // hls/stages/registration.hpp:245
  logic or_3148;
  assign or_3148 = registration_moved_q | (registration_enough_q & (and_3133 | and_3145));
  // hls/stages/agreement.hpp:267
  logic [7:0] select_3233;
  assign select_3233 = sample_pair_whole_s4_q ? (equal_2075_s4_q ? patches_place_0_slope_q : select_2176[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3238;
  assign select_3238 = sample_pair_whole_s4_q ? (equal_2075_s4_q ? patches_place_1_slope_q : select_2205[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3240;
  assign select_3240 = equal_2075_s4_q ? patches_valid_0_q : (select_2074_s4_q ? patches_valid_0_q : select_2173[0]);
  // hls/stages/agreement.hpp:267
  logic select_3243;
  assign select_3243 = sample_pair_whole_s4_q ? (and_2196 ? (sample_present_s4_q & select_3240) : select_3240) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3245;
  assign select_3245 = equal_2075_s4_q ? patches_valid_1_q : (select_2074_s4_q ? select_2173[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:267
  logic select_3248;
  assign select_3248 = sample_pair_whole_s4_q ? (and_2216 ? (sample_present_s4_q & select_3245) : select_3245) : patches_valid_1_q;
  logic [5:0] select_3251;
  assign select_3251 = sample_pair_whole_s4_q ? (select_2194[5] ? {1'b1, select_2194[4:0]} : (select_2194 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3254;
  assign select_3254 = sample_pair_whole_s4_q ? (select_2214[5] ? {1'b1, select_2214[4:0]} : (select_2214 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3257;
  assign select_3257 = sample_pair_whole_s4_q ? (select_2227[4] ? {1'b1, select_2227[3:0]} : (select_2227 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3260;
  assign select_3260 = sample_pair_whole_s4_q ? (select_2232[4] ? {1'b1, select_2232[3:0]} : (select_2232 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:520
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3679_s4_q, parity_3675_s4_q, xor_3663_s4_q, parity_3635_s4_q, parity_3573_s4_q, parity_3444_s4_q} + (equal_3680_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3684;
  assign select_3684 = equal_2157_s4_q ? patches_sums_values_0_q : (equal_2159_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3685;
  assign select_3685 = equal_2159_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3687;
  assign select_3687 = equal_2159_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3689;
  assign select_3689 = equal_2159_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3691;
  assign select_3691 = equal_2159_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3693;
  assign select_3693 = equal_2159_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3695;
  assign select_3695 = equal_2159_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3697;
  assign select_3697 = equal_2159_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3699;
  assign select_3699 = equal_2159_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3701;
  assign select_3701 = equal_2159_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3703;
  assign select_3703 = equal_2159_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3705;
  assign select_3705 = equal_2159_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3707;
  assign select_3707 = equal_2159_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3709;
  assign select_3709 = equal_2159_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3711;
  assign select_3711 = equal_2159_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3713;
  assign select_3713 = equal_2159_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3715;
  assign select_3715 = equal_2159_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:594
  logic or_3820;
  assign or_3820 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3819_s4_q;
  logic or_3823;
  assign or_3823 = equal_3811_s4_q | (less_3813_s4_q | (less_3814_s4_q | or_3820));
  // hls/stages/patches.hpp:574
  logic not_3824;
  assign not_3824 = ~or_3823;
  // hls/stages/patches.hpp:555
  logic and_3825;
  assign and_3825 = equal_2323_s4_q & not_3824;
  // hls/stages/patches.hpp:184
  logic and_3828;
  assign and_3828 = equal_2157_s4_q & (less_2320_s4_q ? (not_2322_s4_q & and_3825) : and_3825);
  // hls/stages/patches.hpp:652
  logic not_3829;
  assign not_3829 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:555
  logic and_3831;
  assign and_3831 = equal_2323_s4_q & (patches_second_s4_q & not_3824);
  // hls/stages/patches.hpp:184
  logic and_3834;
  assign and_3834 = equal_2157_s4_q & (less_2320_s4_q ? (not_2322_s4_q & and_3831) : and_3831);
  // hls/stages/patches.hpp:652
  logic not_3835;
  assign not_3835 = ~and_3834;
  // hls/stages/patches.hpp:188
  logic and_3837;
  assign and_3837 = and_3828 & (not_3829 & not_3835);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3839;
  assign sum_3839 = {7'h0, and_3837} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:592
  logic [7:0] select_3865;
  assign select_3865 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3866;
  assign select_3866 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3867;
  assign sum_3867 = {2'h0, select_3799_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3868;
  assign sum_3868 = {select_3866[5], select_3866} + {{3{sum_3867[3]}}, sum_3867};
  // hls/stages/patches.hpp:592
  logic [17:0] product_3869;
  assign product_3869 = $signed({{10{select_3865[7]}}, select_3865}) * $signed({{8{sum_3868[6]}}, sum_3868, select_3799_s4_q[2:0]});
  // hls/stages/patches.hpp:593
  logic [13:0] difference_3870;
  assign difference_3870 = {{6{select_3864_s4_q[7]}}, select_3864_s4_q} - {product_3869[17], product_3869[17:5]};
  // hls/stages/patches.hpp:599
  logic less_3871;
  assign less_3871 = $signed({{7{difference_3841[6]}}, difference_3841}) < $signed(difference_3870);
  // hls/stages/patches.hpp:555
  logic and_3874;
  assign and_3874 = equal_2323_s4_q & (not_3824 & (~less_3871));
  // hls/stages/patches.hpp:184
  logic and_3877;
  assign and_3877 = equal_2157_s4_q & (less_2320_s4_q ? (not_2322_s4_q & and_3874) : and_3874);
  // hls/stages/patches.hpp:655
  logic and_3878;
  assign and_3878 = and_3877 & and_3837;
  logic [7:0] sum_3879;
  assign sum_3879 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3878};
  // hls/stages/patches.hpp:555
  logic and_3883;
  assign and_3883 = not_3824 & (~($signed(difference_3870) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3884;
  assign and_3884 = equal_2323_s4_q & and_3883;
  // hls/stages/patches.hpp:184
  logic and_3887;
  assign and_3887 = equal_2157_s4_q & (less_2320_s4_q ? (not_2322_s4_q & and_3884) : and_3884);
  // hls/stages/patches.hpp:656
  logic and_3888;
  assign and_3888 = and_3887 & and_3837;
  logic [7:0] sum_3889;
  assign sum_3889 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3888};
  // hls/stages/patches.hpp:188
  logic and_3891;
  assign and_3891 = and_3828 & (and_3834 & not_3829);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3893;
  assign sum_3893 = {7'h0, and_3891} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:655
  logic and_3895;
  assign and_3895 = and_3877 & and_3891;
  logic [7:0] sum_3896;
  assign sum_3896 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3895};
  // hls/stages/patches.hpp:656
  logic and_3898;
  assign and_3898 = and_3887 & and_3891;
  logic [7:0] sum_3899;
  assign sum_3899 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3898};
  // hls/stages/patches.hpp:188
  logic and_3901;
  assign and_3901 = and_3828 & (patches_lower_s4_q & not_3835);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3903;
  assign sum_3903 = {7'h0, and_3901} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:655
  logic and_3905;
  assign and_3905 = and_3877 & and_3901;
  logic [7:0] sum_3906;
  assign sum_3906 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3905};
  // hls/stages/patches.hpp:656
  logic and_3908;
  assign and_3908 = and_3887 & and_3901;
  logic [7:0] sum_3909;
  assign sum_3909 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3908};
  // hls/stages/patches.hpp:188
  logic and_3911;
  assign and_3911 = and_3828 & (patches_lower_s4_q & and_3834);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3913;
  assign sum_3913 = {7'h0, and_3911} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:655
  logic and_3915;
  assign and_3915 = and_3877 & and_3911;
  logic [7:0] sum_3916;
  assign sum_3916 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3915};
  // hls/stages/patches.hpp:656
  logic and_3918;
  assign and_3918 = and_3887 & and_3911;
  logic [7:0] sum_3919;
  assign sum_3919 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3918};
  // hls/stages/agreement.hpp:1167
  logic equal_3920;
  assign equal_3920 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1085
  logic less_3921;
  assign less_3921 = x_s4_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:776
  logic and_3925;
  assign and_3925 = equal_1944_s4_q & (x_s4_q[6] & (not_2349_s4_q & (equal_3920 & less_3921)));
  // hls/stages/agreement.hpp:1097
  logic and_3930;
  assign and_3930 = x_s4_q[6] & (not_2349_s4_q & (less_3921 & (x_s4_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:776
  logic and_3931;
  assign and_3931 = equal_1944_s4_q & and_3930;
  // hls/stages/patches.hpp:618
  logic [7:0] or_3933;
  assign or_3933 = (and_3925 ? patches_quarters_0_places_q : 8'h0) | (and_3931 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1097
  logic and_3937;
  assign and_3937 = x_s4_q[6] & (not_2349_s4_q & (less_3921 & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:776
  logic and_3938;
  assign and_3938 = equal_1944_s4_q & and_3937;
  // hls/stages/agreement.hpp:1097
  logic and_3944;
  assign and_3944 = x_s4_q[6] & (not_2349_s4_q & (less_3921 & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:776
  logic and_3945;
  assign and_3945 = equal_1944_s4_q & and_3944;
  // hls/stages/patches.hpp:618
  logic [7:0] or_3947;
  assign or_3947 = (or_3933 | (and_3938 ? patches_quarters_2_places_q : 8'h0)) | (and_3945 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_3951;
  assign select_3951 = (x_s4_q[5:3] == 3'h2) ? x_s4_q[1] : (x_s4_q[0] & (x_s4_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:776
  logic and_3955;
  assign and_3955 = equal_1944_s4_q & (x_s4_q[6] & (not_2349_s4_q & (less_3921 & select_3951)));
  // hls/stages/patches.hpp:619
  logic [7:0] select_3957;
  assign select_3957 = and_3925 ? (and_3955 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3959;
  assign select_3959 = and_3931 ? (and_3955 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3962;
  assign select_3962 = and_3938 ? (and_3955 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3965;
  assign select_3965 = and_3945 ? (and_3955 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:620
  logic [7:0] select_3968;
  assign select_3968 = and_3925 ? (and_3955 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3970;
  assign select_3970 = and_3931 ? (and_3955 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3973;
  assign select_3973 = and_3938 ? (and_3955 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3976;
  assign select_3976 = and_3945 ? (and_3955 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3978;
  assign sum_3978 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1097
  logic and_3982;
  assign and_3982 = x_s4_q[6] & (not_2349_s4_q & (less_3921 & (sum_3978[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:776
  logic and_3983;
  assign and_3983 = equal_1944_s4_q & and_3982;
  // hls/stages/patches.hpp:615
  logic [7:0] select_3986;
  assign select_3986 = and_3983 ? (patches_word_places_q + (and_3931 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3989;
  assign select_3989 = and_3983 ? (patches_word_up_q + (and_3931 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3992;
  assign select_3992 = and_3983 ? (patches_word_down_q + (and_3931 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:601
  logic [5:0] select_3996;
  assign select_3996 = ($signed(difference_3870[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3870[5:0];
  logic [5:0] select_3997;
  assign select_3997 = ($signed(14'h10) < $signed(difference_3870)) ? 6'h10 : select_3996;
  // hls/stages/patches.hpp:555
  logic [5:0] select_3999;
  assign select_3999 = equal_2323_s4_q ? (or_3823 ? 6'h0 : select_3997) : 6'h0;
  logic [5:0] select_4001;
  assign select_4001 = less_2320_s4_q ? (equal_2321_s4_q ? 6'h0 : select_3999) : select_3999;
  // hls/stages/patches.hpp:658
  logic [5:0] select_4003;
  assign select_4003 = and_3828 ? (equal_2157_s4_q ? select_4001 : 6'h0) : 6'h0;
  logic [11:0] sum_4004;
  assign sum_4004 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_4003[5]}}, select_4003};
  // hls/stages/agreement.hpp:776
  logic and_4008;
  assign and_4008 = equal_1944_s4_q & (x_s4_q[6] & (not_2349_s4_q & (equal_3112 & less_3921)));
  // hls/stages/agreement.hpp:1097
  logic and_4012;
  assign and_4012 = x_s4_q[6] & (not_2349_s4_q & (less_3921 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:776
  logic and_4013;
  assign and_4013 = equal_1944_s4_q & and_4012;
  // hls/stages/patches.hpp:642
  logic [7:0] select_4015;
  assign select_4015 = and_4008 ? (and_4013 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:644
  logic or_4019;
  assign or_4019 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:645
  logic or_4022;
  assign or_4022 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic [8:0] sum_4023;
  assign sum_4023 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:641
  logic select_4025;
  assign select_4025 = and_4008 ? (and_4013 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/agreement.hpp:776
  logic and_4030;
  assign and_4030 = equal_1944_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_4027_s4_q));
  // hls/stages/patches.hpp:188
  logic and_4032;
  assign and_4032 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:641
  logic [2:0] select_4034;
  assign select_4034 = and_4013 ? {and_4032, patches_found_q[2:1]} : (and_4008 ? {and_4032, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:640
  logic or_4038;
  assign or_4038 = patches_partly_q | (patches_doubted_q & (~and_4013));
  // hls/stages/patches.hpp:641
  logic select_4041;
  assign select_4041 = and_4008 ? (and_4013 ? or_4038 : (and_4008 ? or_4038 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:639
  logic select_4042;
  assign select_4042 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:628
  logic [7:0] select_4046;
  assign select_4046 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:600
  logic [10:0] sum_4048;
  assign sum_4048 = {sum_3868[6], sum_3868, select_3799_s4_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:555
  logic and_4051;
  assign and_4051 = equal_2323_s4_q & (not_3824 & ({{5{sum_4048[10]}}, sum_4048} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_4054;
  assign and_4054 = equal_2157_s4_q & (less_2320_s4_q ? (not_2322_s4_q & and_4051) : and_4051);
  // hls/stages/patches.hpp:188
  logic and_4055;
  assign and_4055 = and_3828 & and_4054;
  // hls/stages/patches.hpp:659
  logic [7:0] sum_4056;
  assign sum_4056 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4055};
  // hls/stages/patches.hpp:649
  logic [12:0] product_4057;
  assign product_4057 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_4015};
  // hls/stages/patches.hpp:188
  logic and_4063;
  assign and_4063 = (~(patches_on_skin_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_q);
  logic select_4068;
  assign select_4068 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:629
  logic or_4072;
  assign or_4072 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:630
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:631
  logic select_4079;
  assign select_4079 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:632
  logic and_4085;
  assign and_4085 = patches_frame_ended_q & (~patches_age_q[9]);
  logic [9:0] sum_4086;
  assign sum_4086 = patches_age_q + {9'h0, and_4085};
  logic [9:0] select_4089;
  assign select_4089 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4086)) : sum_4086;
  // hls/stages/agreement.hpp:1139
  logic or_4146;
  assign or_4146 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1161
  logic equal_4148;
  assign equal_4148 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1170
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1171
  logic select_4154;
  assign select_4154 = (equal_4148 & equal_3920) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1090
  logic [10:0] sum_4157;
  assign sum_4157 = {1'b0, select_2910} + {2'h0, select_2910[9:1]};
  logic select_4160;
  assign select_4160 = (select_2907[9:3] == 7'h0) ? ((~or_4146) & (~select_4154)) : (~({sum_4157, select_2910[0]} < {2'h0, select_2907}));
  // hls/stages/agreement.hpp:1097
  logic [47:0] select_4162;
  assign select_4162 = x_s4_q[6] ? (equal_1989_s4_q ? good_q : {select_4160, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:776
  logic select_4166;
  assign select_4166 = equal_1944_s4_q ? ((x_s4_q[6] & good_known_q) | equal_4027_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1161
  logic equal_4167;
  assign equal_4167 = x_s4_q[6:3] == 4'ha;
  logic equal_4169;
  assign equal_4169 = x_s4_q[6:3] == 4'h9;
  logic equal_4170;
  assign equal_4170 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1080
  logic [13:0] select_4172;
  assign select_4172 = equal_4169 ? counts_skin_unproven_q : (equal_4170 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4167 ? counts_nearer_q : select_4172;
  // hls/stages/agreement.hpp:1166
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1174
  logic select_4175;
  assign select_4175 = (equal_4167 & equal_3920) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1099
  logic not_4176;
  assign not_4176 = ~hidden_for_q[7];
  logic [7:0] select_4178;
  assign select_4178 = select_4175 ? (hidden_for_q + {7'h0, not_4176}) : 8'h0;
  // hls/stages/agreement.hpp:776
  logic [7:0] select_4180;
  assign select_4180 = equal_1944_s4_q ? (equal_4027_s4_q ? select_4178 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1174
  logic [13:0] select_4181;
  assign select_4181 = equal_3920 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1080
  logic [7:0] select_4183;
  assign select_4183 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4185;
  assign select_4185 = equal_4170 ? cfg_unproven_skin_limit_i : (equal_4148 ? cfg_unproven_limit_i : select_4183);
  logic [7:0] limit;
  assign limit = equal_4167 ? cfg_regions_limit_i : (equal_4169 ? cfg_hidden_limit_i : select_4185);
  // hls/stages/agreement.hpp:1174
  logic not_4188;
  assign not_4188 = ~x_s4_q[2];
  logic [3:0] select_4189;
  assign select_4189 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_4188, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_4188};
  logic [7:0] select_4190;
  assign select_4190 = x_s4_q[0] ? {select_4189[3], 1'b0, select_4189[2], 1'b0, select_4189[1], 1'b0, select_4189[0], 1'b0} : {1'b0, select_4189[3], 1'b0, select_4189[2], 1'b0, select_4189[1], 1'b0, select_4189[0]};
  // hls/stages/agreement.hpp:1080
  logic [13:0] select_4194;
  assign select_4194 = equal_4169 ? counts_skin_supervised_q : (equal_4170 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_4167 ? counts_textured_q : select_4194;
  // hls/stages/agreement.hpp:1174
  logic [13:0] select_4196;
  assign select_4196 = ((limit & select_4190) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4181} + {1'b0, select_4196};
  // hls/stages/agreement.hpp:776
  logic select_4201;
  assign select_4201 = equal_1944_s4_q ? (equal_3920 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1172
  logic and_4206;
  assign and_4206 = too_much_q & (~(equal_4170 & equal_3920));
  // hls/stages/agreement.hpp:1173
  logic select_4211;
  assign select_4211 = (over[14] & equal_3920) ? (and_4206 | ((equal_4170 | equal_4169) | (x_s4_q[6:3] == 4'hf))) : and_4206;
  // hls/stages/agreement.hpp:1249
  logic [1:0] select_4329;
  assign select_4329 = and_4328_s4_q ? {and_2479, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1250
  logic and_4330;
  assign and_4330 = proven_q & less_4318;
  // hls/stages/agreement.hpp:428
  logic select_4333;
  assign select_4333 = and_2409_s4_q ? (less_2410_s4_q ? (select_4329[0] & and_4330) : seen_q) : seen_q;
  logic select_4336;
  assign select_4336 = and_2409_s4_q ? (less_2410_s4_q ? (select_4329[1] & and_4330) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1182
  logic or_4344;
  assign or_4344 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4343_s4_q;
  // hls/stages/agreement.hpp:1184
  logic not_4352;
  assign not_4352 = ~(or_4146 | not_4337);
  // hls/stages/agreement.hpp:776
  logic and_4356;
  assign and_4356 = equal_1944_s4_q & (equal_4027_s4_q & (not_4352 & (select_4154 | select_4211)));
  logic and_4359;
  assign and_4359 = equal_4027_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1101
  logic or_4363;
  assign or_4363 = select_2732 | (select_2744 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:776
  logic and_4370;
  assign and_4370 = equal_1944_s4_q & (equal_4027_s4_q & (not_4352 & (select_2738 | select_2750)));
  // hls/stages/agreement.hpp:1101
  logic and_4375;
  assign and_4375 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4178 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:776
  logic and_4381;
  assign and_4381 = equal_1944_s4_q & (equal_4027_s4_q & (cfg_prove_i & patches_overlooked_q));
  logic and_4385;
  assign and_4385 = equal_1944_s4_q & (x_s4_q[6] & (not_2349_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1095
  logic [31:0] select_4393;
  assign select_4393 = equal_2011_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4391_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4394;
  assign select_4394 = equal_2009_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4393;
  logic [31:0] select_4395;
  assign select_4395 = equal_2007_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4394;
  logic [31:0] select_4396;
  assign select_4396 = equal_2005_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_4395;
  logic [31:0] select_4397;
  assign select_4397 = equal_2003_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_4396;
  logic [31:0] select_4398;
  assign select_4398 = equal_2001_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4397;
  logic [31:0] select_4399;
  assign select_4399 = equal_1999_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4398;
  logic [31:0] select_4400;
  assign select_4400 = equal_1997_s4_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4399;
  // hls/stages/agreement.hpp:1093
  logic [9:0] select_4401;
  assign select_4401 = less_2906 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1097
  logic [31:0] select_4402;
  assign select_4402 = equal_1989_s4_q ? select_4400 : {2'h0, select_4401, select_2910, select_2907};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_512_s4_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s4_q, and_627, and_603_s4_q, and_602_s4_q, and_577_s4_q, less_569_s4_q, less_568_s4_q, less_567_s4_q, less_566_s4_q, less_565_s4_q, less_564_s4_q, less_563_s4_q, less_562_s4_q, less_561_s4_q, less_560_s4_q, less_559_s4_q, less_558_s4_q, less_557_s4_q, less_556_s4_q, less_555_s4_q, less_554_s4_q, less_553_s4_q, less_552_s4_q, less_551_s4_q, less_550_s4_q, less_549_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q};
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
  assign registration_sums_waddr = {sum_1995_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_2054_s4_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2053, sum_2049};
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
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_2083_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_2156_s4_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2149_s4_q};
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
  assign patches_right_0_waddr = {select_2187_s4_q, select_2184};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_2196);
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
  assign patches_right_1_waddr = {select_2187_s4_q, select_2213};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_2216);
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
  assign patches_left_waddr = {select_2235, select_2234_s4_q, column_7};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_2241);
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
  assign patches_rows_wdata = select_2337;
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
  assign regions_waddr = {region_row_s4_q, or_2347_s4_q, or_2344_s4_q, or_2341_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_2375_s4_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2374, sum_2368, sum_2363};
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
  assign map_waddr = {sum_2415_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_2489_s4_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2479, is_seen};
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
      census_left_misses_q <= select_2638;
      sharpness_before_last_mask_q <= select_2646;
      sharpness_sums_detail_0_q <= and_512_s4_q ? select_2660 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_512_s4_q ? select_2672 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_512_s4_q ? sum_2676 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_512_s4_q ? sum_2680 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2698 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2708 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2710 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2712 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2714 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2716 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2721;
      sharpness_comparing_carry_1_q <= select_2725;
      sharpness_comparing_less_detail_0_q <= select_2732;
      sharpness_comparing_less_detail_1_q <= select_2738;
      sharpness_comparing_less_contrast_0_q <= select_2744;
      sharpness_comparing_less_contrast_1_q <= select_2750;
      counts_supervised_q <= select_2864;
      counts_textured_q <= and_2858_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2867});
      counts_explained_q <= and_2858_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2872});
      counts_nearer_q <= and_2858_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2877});
      counts_unproven_q <= and_2858_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2903});
      counts_regions_bad_q <= select_2919;
      counts_skin_supervised_q <= select_2926;
      counts_skin_textured_q <= select_2933;
      counts_skin_unproven_q <= select_2941;
      registration_half_across_q <= select_2993;
      registration_half_measured_q <= select_2998;
      registration_half_votes_down_q <= and_2973_s4_q ? 7'h0 : sum_3004;
      registration_half_votes_up_q <= and_2973_s4_q ? 7'h0 : sum_3012;
      registration_half_half_votes_down_q <= and_2973_s4_q ? 7'h0 : sum_3019;
      registration_half_half_votes_up_q <= and_2973_s4_q ? 7'h0 : sum_3026;
      registration_down_q <= and_3060 ? sum_3079 : registration_down_q;
      registration_up_q <= and_3060 ? sum_3088 : registration_up_q;
      registration_enough_q <= select_3102;
      registration_votes_down_q <= and_3107 ? less_3108 : registration_votes_down_q;
      registration_votes_up_q <= and_3107 ? less_3110 : registration_votes_up_q;
      registration_other_enough_q <= and_3116 ? select_3102 : registration_other_enough_q;
      registration_other_down_q <= and_3116 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3116 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1944_s4_q & and_3123)) & or_3148;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_2175 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_2177 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_2178 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3233;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_2204 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_2206 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_2207 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3238;
      patches_valid_0_q <= select_3243;
      patches_valid_1_q <= select_3248;
      patches_right_next_0_q <= select_3251;
      patches_right_next_1_q <= select_3254;
      patches_left_next_0_q <= select_3257;
      patches_left_next_1_q <= select_3260;
      patches_sums_values_0_q <= select_3684;
      patches_sums_values_1_q <= equal_2157_s4_q ? patches_sums_values_1_q : select_3685;
      patches_sums_values_2_q <= equal_2157_s4_q ? patches_sums_values_2_q : select_3687;
      patches_sums_values_3_q <= equal_2157_s4_q ? patches_sums_values_3_q : select_3689;
      patches_sums_values_4_q <= equal_2157_s4_q ? patches_sums_values_4_q : select_3691;
      patches_sums_values_5_q <= equal_2157_s4_q ? patches_sums_values_5_q : select_3693;
      patches_sums_values_6_q <= equal_2157_s4_q ? patches_sums_values_6_q : select_3695;
      patches_sums_values_7_q <= equal_2157_s4_q ? patches_sums_values_7_q : select_3697;
      patches_sums_values_8_q <= equal_2157_s4_q ? patches_sums_values_8_q : select_3699;
      patches_sums_values_9_q <= equal_2157_s4_q ? patches_sums_values_9_q : select_3701;
      patches_sums_values_10_q <= equal_2157_s4_q ? patches_sums_values_10_q : select_3703;
      patches_sums_values_11_q <= equal_2157_s4_q ? patches_sums_values_11_q : select_3705;
      patches_sums_values_12_q <= equal_2157_s4_q ? patches_sums_values_12_q : select_3707;
      patches_sums_values_13_q <= equal_2157_s4_q ? patches_sums_values_13_q : select_3709;
      patches_sums_values_14_q <= equal_2157_s4_q ? patches_sums_values_14_q : select_3711;
      patches_sums_values_15_q <= equal_2157_s4_q ? patches_sums_values_15_q : select_3713;
      patches_sums_values_16_q <= equal_2157_s4_q ? patches_sums_values_16_q : select_3715;
      patches_best_differing_q <= select_2337[9:0];
      patches_best_column_q <= select_2337[14:10];
      patches_quarters_0_places_q <= sum_3839;
      patches_quarters_0_up_q <= sum_3879;
      patches_quarters_0_down_q <= sum_3889;
      patches_quarters_1_places_q <= sum_3893;
      patches_quarters_1_up_q <= sum_3896;
      patches_quarters_1_down_q <= sum_3899;
      patches_quarters_2_places_q <= sum_3903;
      patches_quarters_2_up_q <= sum_3906;
      patches_quarters_2_down_q <= sum_3909;
      patches_quarters_3_places_q <= sum_3913;
      patches_quarters_3_up_q <= sum_3916;
      patches_quarters_3_down_q <= sum_3919;
      patches_word_places_q <= or_3947;
      patches_word_up_q <= ((select_3957 | select_3959) | select_3962) | select_3965;
      patches_word_down_q <= ((select_3968 | select_3970) | select_3973) | select_3976;
      patches_sum_places_q <= select_3986;
      patches_sum_up_q <= select_3989;
      patches_sum_down_q <= select_3992;
      patches_across_q <= sum_4004;
      patches_places_q <= select_4015;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4019;
      patches_partly_q <= or_4022;
      patches_clear_limit_q <= sum_4023[8:2];
      patches_complete_q <= select_4025;
      patches_frame_ended_q <= and_4030;
      patches_round_ends_q <= patches_complete_q & and_4030;
      patches_found_q <= and_4008 ? select_4034 : patches_found_q;
      patches_doubted_q <= select_4041;
      patches_doubted_before_q <= select_4042;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4046;
      patches_on_skin_q <= sum_4056;
      patches_on_skin_most_q <= product_4057[12:5];
      patches_large_q <= (~(cfg_on_skin_limit_i == 5'h1f)) & and_4063;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4068;
      patches_spoiled_q <= or_4072;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4079;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4089;
      segment_textured_q <= select_2360 + {6'h0, and_2867};
      segment_explained_q <= select_2365 + {6'h0, and_2872};
      segment_nearer_q <= select_2371 + {6'h0, and_2877};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1944_s4_q ? select_4162 : good_q;
      good_known_q <= select_4166;
      hidden_for_q <= select_4180;
      product_q <= equal_1944_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4201;
      disagree_q <= equal_1944_s4_q ? select_4154 : disagree_q;
      too_much_q <= equal_1944_s4_q ? select_4211 : too_much_q;
      hides_q <= equal_1944_s4_q ? select_4175 : hides_q;
      seen_q <= select_4333;
      nearer_q <= select_4336;
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
      averager_quarter_1_0_q <= select_2513;
      averager_quarter_1_1_q <= select_2515;
      averager_quarter_2_0_q <= select_2517;
      averager_quarter_2_1_q <= select_2519;
      averager_detail_0_q <= select_2531;
      averager_detail_1_q <= select_2539;
      census_changes_values_0_left_q <= and_512_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_512_s4_q ? sum_2622 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2624;
      census_changes_values_1_right_q <= select_2625;
      census_changes_values_2_left_q <= select_2626;
      census_changes_values_2_right_q <= select_2627;
      sharpness_last_mask_q <= and_512_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_512_s4_q ? select_2643[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_512_s4_q ? select_2643[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_4313_s5_q;
  logic or_4338_s5_q;
  logic and_4339_s5_q;
  logic and_4347_s5_q;
  logic and_4350_s5_q;
  logic and_4356_s5_q;
  logic and_4360_s5_q;
  logic and_4366_s5_q;
  logic and_4370_s5_q;
  logic and_4378_s5_q;
  logic and_4381_s5_q;
  logic and_4385_s5_q;
  logic [5:0] select_4387_s5_q;
  logic [31:0] select_4404_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_0_q;
      pixel_1_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_4313_s5_q <= said_q;
      or_4338_s5_q <= not_4337 | select_4333;
      and_4339_s5_q <= cfg_prove_i & select_4336;
      and_4347_s5_q <= equal_1944_s4_q & (equal_4027_s4_q & (cfg_prove_i & or_4344));
      and_4350_s5_q <= equal_1944_s4_q & (equal_4027_s4_q & (cfg_prove_i & or_4146));
      and_4356_s5_q <= and_4356;
      and_4360_s5_q <= equal_1944_s4_q & and_4359;
      and_4366_s5_q <= equal_1944_s4_q & (equal_4027_s4_q & (not_4352 & or_4363));
      and_4370_s5_q <= and_4370;
      and_4378_s5_q <= equal_1944_s4_q & (equal_4027_s4_q & (cfg_prove_i & and_4375));
      and_4381_s5_q <= and_4381;
      and_4385_s5_q <= and_4385;
      select_4387_s5_q <= equal_1944_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_4404_s5_q <= equal_1944_s4_q ? (x_s4_q[6] ? select_4402 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4338_s5_q;
  assign marks_nearer_o = and_4339_s5_q;
  assign verdict_valid_o = and_4313_s5_q;
  assign verdict_unproven_yet_o = and_4347_s5_q;
  assign verdict_untextured_o = and_4350_s5_q;
  assign verdict_disagree_o = and_4356_s5_q;
  assign verdict_moved_o = and_4360_s5_q;
  assign verdict_unsharp_left_o = and_4366_s5_q;
  assign verdict_unsharp_right_o = and_4370_s5_q;
  assign verdict_hidden_o = and_4378_s5_q;
  assign verdict_overlooked_o = and_4381_s5_q;
  assign frame_valid_o = and_4385_s5_q;
  assign frame_index_o = select_4387_s5_q;
  assign frame_word_o = select_4404_s5_q;
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
  assign unused_bits = ^{over[13:0], product_4057[4:0], sum_4023[1:0], sum_3978[1:0], product_3869[4:0], sum_2963[0], detail_4[1:0], detail_3[1:0], sum_2632[4:0], sum_2097[0], sum_2093[0], sum_625[4:0], cfg_width_i[2:0]};

endmodule
