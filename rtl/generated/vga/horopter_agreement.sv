// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2904 bits, pipeline 912 bits, memories 99800 bits.
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
  logic [5:0] sum_2836;
  assign sum_2836 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3833;
  assign difference_3833 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_4081;
  assign difference_4081 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4283;
  assign less_4283 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4284;
  assign sum_4284 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_4302;
  assign not_4302 = ~cfg_prove_i;

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
  logic [2:0] select_468;
  assign select_468 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_470;
  assign select_470 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [8:0] select_473;
  assign select_473 = ({select_470, select_468} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_474;
  assign select_474 = select_468[0] ? averager_place_q : select_473;
  // hls/stages/census.hpp:41
  logic or_475;
  assign or_475 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:405
  logic and_478;
  assign and_478 = (select_468[0] & or_475) & (select_474[8:6] < 3'h5);
  // hls/stages/census.hpp:41
  logic [2:0] select_483;
  assign select_483 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:264
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_470 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_500;
  assign equal_500 = select_468 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_501;
  assign equal_501 = select_483 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_502;
  assign and_502 = equal_501 & and_478;
  // hls/stages/agreement.hpp:264
  logic and_504;
  assign and_504 = sample_pair_whole_q & (equal_500 & and_502);
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:611
  logic equal_524;
  assign equal_524 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:582
  logic or_525;
  assign or_525 = so | equal_524;
  logic not_526;
  assign not_526 = ~or_525;
  // hls/stages/agreement.hpp:602
  logic equal_527;
  assign equal_527 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:603
  logic equal_529;
  assign equal_529 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:580
  logic [7:0] sum_530;
  assign sum_530 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:582
  logic [7:0] select_531;
  assign select_531 = run_shift_q[5] ? x_q : sum_530;
  logic less_532;
  assign less_532 = {1'b0, last_q} < select_531;
  // hls/stages/agreement.hpp:216
  logic not_533;
  assign not_533 = ~less_532;
  // hls/stages/agreement.hpp:141
  logic and_534;
  assign and_534 = equal_529 & not_533;
  logic and_536;
  assign and_536 = not_526 & ((~equal_527) & and_534);
  // hls/stages/census.hpp:41
  logic [5:0] select_563;
  assign select_563 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:264
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_563 : 6'h0;
  // hls/stages/agreement.hpp:141
  logic select_620;
  assign select_620 = equal_527 ? not_533 : and_534;
  // hls/stages/agreement.hpp:783
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:141
  logic and_644;
  assign and_644 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_531)));
  logic and_645;
  assign and_645 = equal_527 & and_644;
  logic select_646;
  assign select_646 = or_525 ? not_533 : and_645;
  // hls/stages/agreement.hpp:804
  logic [6:0] right;
  assign right = sum_530[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:264
  logic [2:0] select_2486;
  assign select_2486 = sample_pair_whole_q ? (sample_last_q ? (select_483 + 3'h1) : select_483) : raster_at_y_q;
  logic [6:0] select_2488;
  assign select_2488 = sample_pair_whole_q ? (select_470 + {6'h0, equal_500}) : raster_at_column_q;
  logic [5:0] select_2491;
  assign select_2491 = sample_pair_whole_q ? (sample_last_q ? (select_563 + {5'h0, equal_501}) : select_563) : raster_at_row_q;
  logic select_2495;
  assign select_2495 = sample_pair_whole_q ? (sample_last_q ? (or_475 & (~raster_final_row_q)) : or_475) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2497;
  assign select_2497 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:264
  logic select_2501;
  assign select_2501 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:447
  logic equal_2745;
  assign equal_2745 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:452
  logic and_2746;
  assign and_2746 = and_504 & equal_2745;
  // hls/stages/agreement.hpp:511
  logic select_2749;
  assign select_2749 = (and_2746 | (~ends_cell_q)) ? and_2746 : ends_q;
  // hls/stages/agreement.hpp:517
  logic [2:0] now;
  assign now = select_2749 ? (and_2746 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:522
  logic [5:0] select_2753;
  assign select_2753 = select_2749 ? (and_2746 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2756;
  assign select_2756 = select_2749 ? (following_last_shift_q & (~and_2746)) : run_last_shift_q;
  // hls/stages/agreement.hpp:595
  logic and_2759;
  assign and_2759 = run_last_shift_q & equal_527;
  // hls/stages/agreement.hpp:604
  logic select_2761;
  assign select_2761 = equal_527 ? (~run_last_shift_q) : equal_529;
  // hls/stages/agreement.hpp:608
  logic equal_2762;
  assign equal_2762 = run_phase_q == 3'h1;
  logic not_2765;
  assign not_2765 = ~select_2761;
  // hls/stages/agreement.hpp:611
  logic equal_2767;
  assign equal_2767 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:595
  logic and_2768;
  assign and_2768 = final_row_q & so;
  // hls/stages/agreement.hpp:608
  logic [1:0] select_2769;
  assign select_2769 = equal_2767 ? 2'h1 : {2{and_2768}};
  logic [2:0] select_2771;
  assign select_2771 = (and_2759 | (select_2761 | equal_2762)) ? (equal_2762 ? 3'h2 : {not_2765, {2{select_2761}}}) : (equal_524 ? 3'h6 : {select_2769[0], select_2769});
  // hls/stages/agreement.hpp:595
  logic and_2774;
  assign and_2774 = select_2761 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:618
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2777;
  assign select_2777 = (plan_shift_q[5] & select_2761) ? value : 7'h0;
  logic [1:0] or_2778;
  assign or_2778 = {2{so}} | select_2777[5:4];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_2782;
  assign or_2782 = (select_2761 ? plan_columns_q : 8'h0) | ((equal_2762 | equal_2767) ? whole_q : 8'h0);
  logic [1:0] or_2783;
  assign or_2783 = {2{and_2759}} | or_2782[3:2];
  // hls/stages/agreement.hpp:622
  logic [7:0] or_2785;
  assign or_2785 = {or_2782[7:4], or_2783, or_2782[1:0]} | (equal_524 ? drawn_q : 8'h0);
  logic [4:0] or_2786;
  assign or_2786 = {5{so}} | {or_2785[6], or_2785[3:0]};
  // hls/stages/agreement.hpp:628
  logic not_2790;
  assign not_2790 = ~run_shift_q[5];
  logic [7:0] select_2793;
  assign select_2793 = equal_527 ? ({{7{not_2790}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:511
  logic [6:0] select_2797;
  assign select_2797 = and_2746 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:514
  logic [7:0] select_2799;
  assign select_2799 = select_2749 ? {select_2797[6], select_2797} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2802;
  assign select_2802 = select_2749 ? (and_2746 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:508
  logic [6:0] select_2810;
  assign select_2810 = and_504 ? (equal_2745 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2813;
  assign select_2813 = and_504 ? (equal_2745 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2816;
  assign select_2816 = and_504 ? (equal_2745 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:519
  logic select_2827;
  assign select_2827 = (ends_cell_q | select_2749) ? (~(now == 3'h6)) : (equal_527 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:514
  logic and_2831;
  assign and_2831 = (~select_2749) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:464
  logic [6:0] sum_2832;
  assign sum_2832 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:448
  logic select_2834;
  assign select_2834 = equal_2745 ? ({sum_2832[6], cfg_height_i[8:3]} == {1'b0, sum_2832[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:361
  logic or_3209;
  assign or_3209 = select_470[0] | select_563[5];
  logic [7:0] sum_3210;
  assign sum_3210 = {1'b0, select_470[2:1], or_3209, select_563[4:1]} + 8'h1;
  logic less_3211;
  assign less_3211 = {sum_3210, select_563[0], select_483, 1'b0} < {4'h0, cfg_height_i};

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1305; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 30'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_536;
  logic [29:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [28:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[28:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:1306; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 78'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (or_525 ? not_533 : select_620);
  logic [77:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [76:0] left_rdata_q;
  assign left_rdata_q = left_word_q[76:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:1307; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [91:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 92'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_527 ? sum_530[6:0] : x_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_526 & select_620);
  logic [91:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [90:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[90:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 46 and parity, DISTANCE 12, hls/stages/agreement.hpp:1308; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [46:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 47'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_525 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_646;
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
      raster_at_x_q <= sample_pair_whole_q ? (select_468 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2486;
      raster_at_column_q <= select_2488;
      raster_at_row_q <= select_2491;
      raster_at_live_q <= select_2495;
      raster_rows_left_q <= sample_pair_whole_q ? select_2497 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2501;
      averager_place_q <= sample_pair_whole_q ? select_474 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2753;
      run_last_shift_q <= select_2756;
      run_span_q <= select_2749 ? (and_2746 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2771;
      following_shift_q <= select_2761 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2774;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2777[6], or_2778, select_2777[3:0]};
      following_columns_q <= {or_2785[7], or_2786[4], or_2785[5:4], or_2786[3:0]};
      plan_shift_q <= equal_527 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2793;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2799;
      columns_left_q <= select_2802;
      last_q <= and_504 ? (equal_2745 ? column : last_q) : last_q;
      least_q <= select_2810;
      whole_q <= select_2813;
      drawn_q <= select_2816;
      age_q <= select_2749 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2749 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2827;
      ends_q <= and_2831;
      final_row_q <= and_504 ? select_2834 : final_row_q;
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
  logic [2:0] select_468_s1_q;
  logic [6:0] select_470_s1_q;
  logic [8:0] select_474_s1_q;
  logic and_478_s1_q;
  logic equal_484_s1_q;
  logic [6:0] column_s1_q;
  logic and_502_s1_q;
  logic and_504_s1_q;
  logic so_s1_q;
  logic equal_524_s1_q;
  logic or_525_s1_q;
  logic equal_527_s1_q;
  logic less_532_s1_q;
  logic not_533_s1_q;
  logic and_536_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_646_s1_q;
  logic and_1918_s1_q;
  logic [6:0] right_s1_q;
  logic equal_1926_s1_q;
  logic equal_1936_s1_q;
  logic equal_2055_s1_q;
  logic equal_2745_s1_q;
  logic and_2746_s1_q;
  logic not_3212_s1_q;
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
      select_468_s1_q <= select_468;
      select_470_s1_q <= select_470;
      select_474_s1_q <= select_474;
      and_478_s1_q <= and_478;
      equal_484_s1_q <= select_483 == 3'h0;
      column_s1_q <= column;
      and_502_s1_q <= and_502;
      and_504_s1_q <= and_504;
      so_s1_q <= so;
      equal_524_s1_q <= equal_524;
      or_525_s1_q <= or_525;
      equal_527_s1_q <= equal_527;
      less_532_s1_q <= less_532;
      not_533_s1_q <= not_533;
      and_536_s1_q <= and_536;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_646_s1_q <= select_646;
      and_1918_s1_q <= not_526 & and_645;
      right_s1_q <= right;
      equal_1926_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      equal_1936_s1_q <= run_phase_q == 3'h7;
      equal_2055_s1_q <= {or_475, select_483} == 4'hc;
      equal_2745_s1_q <= equal_2745;
      and_2746_s1_q <= and_2746;
      not_3212_s1_q <= ~less_3211;
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
  // hls/stages/agreement.hpp:654
  logic not_624;
  assign not_624 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:657
  logic and_625;
  assign and_625 = left_rdata_q[12] & not_624;
  logic and_626;
  assign and_626 = left_rdata_q[28] & not_624;
  logic and_627;
  assign and_627 = left_rdata_q[44] & not_624;
  logic and_628;
  assign and_628 = left_rdata_q[60] & not_624;
  // hls/stages/agreement.hpp:658
  logic and_632;
  assign and_632 = right_codes_rdata_q[12] & not_624;
  logic and_633;
  assign and_633 = right_codes_rdata_q[25] & not_624;
  logic and_634;
  assign and_634 = right_codes_rdata_q[38] & not_624;
  logic and_635;
  assign and_635 = right_codes_rdata_q[51] & not_624;
  logic and_636;
  assign and_636 = right_codes_rdata_q[64] & not_624;
  logic and_637;
  assign and_637 = right_codes_rdata_q[77] & not_624;
  // hls/stages/agreement.hpp:212
  logic and_652;
  assign and_652 = left_rdata_q[44] & not_533_s1_q;
  logic and_653;
  assign and_653 = right_codes_rdata_q[38] & not_533_s1_q;
  logic [11:0] select_654;
  assign select_654 = less_532_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_655;
  assign select_655 = less_532_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_659;
  assign select_659 = and_652 ? (and_653 ? (~(select_654 ^ select_655)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_665;
  assign parity_665 = ^select_659[5:3];
  logic parity_668;
  assign parity_668 = ^select_659[8:6];
  logic parity_671;
  assign parity_671 = ^select_659[11:3];
  // hls/stages/agreement.hpp:212
  logic and_675;
  assign and_675 = left_rdata_q[60] & not_533_s1_q;
  logic and_676;
  assign and_676 = right_codes_rdata_q[51] & not_533_s1_q;
  logic [11:0] select_677;
  assign select_677 = less_532_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_678;
  assign select_678 = less_532_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_682;
  assign select_682 = and_675 ? (and_676 ? (~(select_677 ^ select_678)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_685;
  assign parity_685 = ^select_682[8:6];
  logic parity_688;
  assign parity_688 = ^select_682[11:9];
  // hls/stages/agreement.hpp:212
  logic and_692;
  assign and_692 = left_rdata_q[76] & not_533_s1_q;
  logic and_693;
  assign and_693 = right_codes_rdata_q[64] & not_533_s1_q;
  logic [11:0] select_694;
  assign select_694 = less_532_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_695;
  assign select_695 = less_532_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_699;
  assign select_699 = and_692 ? (and_693 ? (~(select_694 ^ select_695)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_705;
  assign parity_705 = ^select_699[2:0];
  logic parity_708;
  assign parity_708 = ^select_699[5:3];
  logic parity_711;
  assign parity_711 = ^select_699[8:0];
  logic parity_717;
  assign parity_717 = ^select_699[11:9];
  logic parity_720;
  assign parity_720 = ^select_682[2:0];
  logic parity_723;
  assign parity_723 = ^{select_699[11:9], select_682[5:0]};
  logic parity_726;
  assign parity_726 = ^{select_699, select_682, select_659[2:0]};
  logic xor_727;
  assign xor_727 = parity_671 ^ parity_726;
  // hls/stages/count_bits.hpp:23
  logic or_731;
  assign or_731 = (select_659[1:0] == 2'h3) | (select_659[2] & (select_659[0] | select_659[1]));
  // hls/stages/count_bits.hpp:25
  logic or_735;
  assign or_735 = (select_682[7:6] == 2'h3) | (select_682[8] & (select_682[6] | select_682[7]));
  logic or_739;
  assign or_739 = (select_682[10:9] == 2'h3) | (select_682[11] & (select_682[9] | select_682[10]));
  // hls/stages/count_bits.hpp:23
  logic or_747;
  assign or_747 = (select_699[7:6] == 2'h3) | (select_699[8] & (~(select_699[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_751;
  assign or_751 = (select_699[1:0] == 2'h3) | (select_699[2] & (select_699[0] | select_699[1]));
  logic or_755;
  assign or_755 = (select_699[4:3] == 2'h3) | (select_699[5] & (select_699[3] | select_699[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_758;
  assign parity_758 = ^{or_755, or_751, or_747};
  // hls/stages/count_bits.hpp:23
  logic or_762;
  assign or_762 = (select_682[4:3] == 2'h3) | (select_682[5] & (select_682[3] | select_682[4]));
  // hls/stages/count_bits.hpp:25
  logic or_766;
  assign or_766 = (select_699[10:9] == 2'h3) | (select_699[11] & (select_699[9] | select_699[10]));
  logic or_770;
  assign or_770 = (select_682[1:0] == 2'h3) | (select_682[2] & (select_682[0] | select_682[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_773;
  assign parity_773 = ^{or_770, or_766, or_762};
  logic parity_776;
  assign parity_776 = ^{or_770, or_766, or_762, or_755, or_751, or_747, or_739, or_735, or_731};
  // hls/stages/count_bits.hpp:25
  logic and_777;
  assign and_777 = parity_671 & parity_726;
  logic or_781;
  assign or_781 = (parity_665 & parity_668) | ((^select_659[11:9]) & (parity_665 | parity_668));
  logic and_784;
  assign and_784 = (^{select_682[11:6], select_659[2:0]}) & (parity_711 | parity_723);
  logic or_785;
  assign or_785 = (parity_711 & parity_723) | and_784;
  // hls/stages/count_bits.hpp:23
  logic or_792;
  assign or_792 = (select_659[10:9] == 2'h3) | (select_659[11] & (select_659[9] | select_659[10]));
  // hls/stages/count_bits.hpp:25
  logic or_796;
  assign or_796 = (select_659[4:3] == 2'h3) | (select_659[5] & (select_659[3] | select_659[4]));
  logic or_800;
  assign or_800 = (select_659[7:6] == 2'h3) | (select_659[8] & (select_659[6] | select_659[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_803;
  assign parity_803 = ^{or_800, or_796, or_792};
  // hls/stages/count_bits.hpp:25
  logic or_807;
  assign or_807 = (parity_685 & parity_688) | ((^select_659[2:0]) & (parity_685 | parity_688));
  logic or_811;
  assign or_811 = (parity_705 & parity_708) | ((^select_699[8:6]) & (parity_705 | parity_708));
  logic or_815;
  assign or_815 = (parity_717 & parity_720) | ((^select_682[5:3]) & (parity_717 | parity_720));
  // hls/stages/count_bits.hpp:24
  logic parity_818;
  assign parity_818 = ^{or_815, or_811, or_807};
  logic parity_821;
  assign parity_821 = ^{or_815, or_811, or_807, or_800, or_796, or_792, or_785, or_781, and_777};
  logic xor_822;
  assign xor_822 = parity_776 ^ parity_821;
  // hls/stages/count_bits.hpp:25
  logic and_823;
  assign and_823 = parity_776 & parity_821;
  logic or_827;
  assign or_827 = (parity_758 & parity_773) | ((^{or_739, or_735, or_731}) & (parity_758 | parity_773));
  logic or_831;
  assign or_831 = (parity_803 & parity_818) | ((^{or_785, or_781, and_777}) & (parity_803 | parity_818));
  logic or_838;
  assign or_838 = (or_735 & or_739) | (or_731 & (or_735 | or_739));
  logic or_842;
  assign or_842 = (or_751 & or_755) | (or_747 & (or_751 | or_755));
  logic or_846;
  assign or_846 = (or_766 & or_770) | (or_762 & (or_766 | or_770));
  // hls/stages/count_bits.hpp:24
  logic parity_849;
  assign parity_849 = ^{or_846, or_842, or_838};
  // hls/stages/count_bits.hpp:25
  logic or_853;
  assign or_853 = (or_781 & or_785) | (and_777 & (or_781 | or_785));
  logic or_857;
  assign or_857 = (or_796 & or_800) | (or_792 & (or_796 | or_800));
  logic or_861;
  assign or_861 = (or_811 & or_815) | (or_807 & (or_811 | or_815));
  // hls/stages/count_bits.hpp:24
  logic parity_864;
  assign parity_864 = ^{or_861, or_857, or_853};
  logic parity_867;
  assign parity_867 = ^{or_861, or_857, or_853, or_846, or_842, or_838, or_831, or_827, and_823};
  // hls/stages/count_bits.hpp:25
  logic or_871;
  assign or_871 = (parity_849 & parity_864) | ((^{or_831, or_827, and_823}) & (parity_849 | parity_864));
  logic or_875;
  assign or_875 = (or_827 & or_831) | (and_823 & (or_827 | or_831));
  logic or_879;
  assign or_879 = (or_842 & or_846) | (or_838 & (or_842 | or_846));
  logic or_883;
  assign or_883 = (or_857 & or_861) | (or_853 & (or_857 | or_861));
  // hls/stages/count_bits.hpp:24
  logic parity_888;
  assign parity_888 = ^{or_883, or_879, or_875, or_871};
  // hls/stages/count_bits.hpp:25
  logic or_892;
  assign or_892 = (or_879 & or_883) | (or_875 & (or_879 | or_883));
  logic and_893;
  assign and_893 = or_871 & (^{or_883, or_879, or_875});
  // hls/stages/count_bits.hpp:24
  logic xor_894;
  assign xor_894 = or_892 ^ and_893;
  // hls/stages/count_bits.hpp:27
  logic and_895;
  assign and_895 = or_892 & and_893;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_896;
  assign select_896 = equal_527_s1_q ? {and_895, xor_894, parity_888, parity_867, xor_822, xor_727} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_525_s1_q ? 6'h0 : select_896;
  // hls/stages/agreement.hpp:763
  logic [5:0] select_898;
  assign select_898 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_899;
  assign difference_899 = {1'b0, column_2} - {1'b0, select_898};
  logic [7:0] sum_901;
  assign sum_901 = {difference_899[6], difference_899} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:670
  logic [11:0] select_905;
  assign select_905 = and_652 ? (and_676 ? (~(select_677 ^ select_655)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_911;
  assign parity_911 = ^select_905[5:3];
  logic parity_914;
  assign parity_914 = ^select_905[8:6];
  logic parity_917;
  assign parity_917 = ^select_905[11:3];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_924;
  assign select_924 = and_675 ? (and_693 ? (~(select_694 ^ select_678)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_927;
  assign parity_927 = ^select_924[8:6];
  logic parity_930;
  assign parity_930 = ^select_924[11:9];
  // hls/stages/agreement.hpp:212
  logic and_934;
  assign and_934 = right_codes_rdata_q[77] & not_533_s1_q;
  logic [11:0] select_935;
  assign select_935 = less_532_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_939;
  assign select_939 = and_692 ? (and_934 ? (~(select_935 ^ select_695)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_945;
  assign parity_945 = ^select_939[2:0];
  logic parity_948;
  assign parity_948 = ^select_939[5:3];
  logic parity_951;
  assign parity_951 = ^select_939[8:0];
  logic parity_957;
  assign parity_957 = ^select_939[11:9];
  logic parity_960;
  assign parity_960 = ^select_924[2:0];
  logic parity_963;
  assign parity_963 = ^{select_939[11:9], select_924[5:0]};
  logic parity_966;
  assign parity_966 = ^{select_939, select_924, select_905[2:0]};
  logic xor_967;
  assign xor_967 = parity_917 ^ parity_966;
  // hls/stages/count_bits.hpp:23
  logic or_971;
  assign or_971 = (select_905[1:0] == 2'h3) | (select_905[2] & (select_905[0] | select_905[1]));
  // hls/stages/count_bits.hpp:25
  logic or_975;
  assign or_975 = (select_924[7:6] == 2'h3) | (select_924[8] & (select_924[6] | select_924[7]));
  logic or_979;
  assign or_979 = (select_924[10:9] == 2'h3) | (select_924[11] & (select_924[9] | select_924[10]));
  // hls/stages/count_bits.hpp:23
  logic or_987;
  assign or_987 = (select_939[7:6] == 2'h3) | (select_939[8] & (~(select_939[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_991;
  assign or_991 = (select_939[1:0] == 2'h3) | (select_939[2] & (select_939[0] | select_939[1]));
  logic or_995;
  assign or_995 = (select_939[4:3] == 2'h3) | (select_939[5] & (select_939[3] | select_939[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_998;
  assign parity_998 = ^{or_995, or_991, or_987};
  // hls/stages/count_bits.hpp:23
  logic or_1002;
  assign or_1002 = (select_924[4:3] == 2'h3) | (select_924[5] & (select_924[3] | select_924[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1006;
  assign or_1006 = (select_939[10:9] == 2'h3) | (select_939[11] & (select_939[9] | select_939[10]));
  logic or_1010;
  assign or_1010 = (select_924[1:0] == 2'h3) | (select_924[2] & (select_924[0] | select_924[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1013;
  assign parity_1013 = ^{or_1010, or_1006, or_1002};
  logic parity_1016;
  assign parity_1016 = ^{or_1010, or_1006, or_1002, or_995, or_991, or_987, or_979, or_975, or_971};
  // hls/stages/count_bits.hpp:25
  logic and_1017;
  assign and_1017 = parity_917 & parity_966;
  logic or_1021;
  assign or_1021 = (parity_911 & parity_914) | ((^select_905[11:9]) & (parity_911 | parity_914));
  logic and_1024;
  assign and_1024 = (^{select_924[11:6], select_905[2:0]}) & (parity_951 | parity_963);
  logic or_1025;
  assign or_1025 = (parity_951 & parity_963) | and_1024;
  // hls/stages/count_bits.hpp:23
  logic or_1032;
  assign or_1032 = (select_905[10:9] == 2'h3) | (select_905[11] & (select_905[9] | select_905[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1036;
  assign or_1036 = (select_905[4:3] == 2'h3) | (select_905[5] & (select_905[3] | select_905[4]));
  logic or_1040;
  assign or_1040 = (select_905[7:6] == 2'h3) | (select_905[8] & (select_905[6] | select_905[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1043;
  assign parity_1043 = ^{or_1040, or_1036, or_1032};
  // hls/stages/count_bits.hpp:25
  logic or_1047;
  assign or_1047 = (parity_927 & parity_930) | ((^select_905[2:0]) & (parity_927 | parity_930));
  logic or_1051;
  assign or_1051 = (parity_945 & parity_948) | ((^select_939[8:6]) & (parity_945 | parity_948));
  logic or_1055;
  assign or_1055 = (parity_957 & parity_960) | ((^select_924[5:3]) & (parity_957 | parity_960));
  // hls/stages/count_bits.hpp:24
  logic parity_1058;
  assign parity_1058 = ^{or_1055, or_1051, or_1047};
  logic parity_1061;
  assign parity_1061 = ^{or_1055, or_1051, or_1047, or_1040, or_1036, or_1032, or_1025, or_1021, and_1017};
  logic xor_1062;
  assign xor_1062 = parity_1016 ^ parity_1061;
  // hls/stages/count_bits.hpp:25
  logic and_1063;
  assign and_1063 = parity_1016 & parity_1061;
  logic or_1067;
  assign or_1067 = (parity_998 & parity_1013) | ((^{or_979, or_975, or_971}) & (parity_998 | parity_1013));
  logic or_1071;
  assign or_1071 = (parity_1043 & parity_1058) | ((^{or_1025, or_1021, and_1017}) & (parity_1043 | parity_1058));
  logic or_1078;
  assign or_1078 = (or_975 & or_979) | (or_971 & (or_975 | or_979));
  logic or_1082;
  assign or_1082 = (or_991 & or_995) | (or_987 & (or_991 | or_995));
  logic or_1086;
  assign or_1086 = (or_1006 & or_1010) | (or_1002 & (or_1006 | or_1010));
  // hls/stages/count_bits.hpp:24
  logic parity_1089;
  assign parity_1089 = ^{or_1086, or_1082, or_1078};
  // hls/stages/count_bits.hpp:25
  logic or_1093;
  assign or_1093 = (or_1021 & or_1025) | (and_1017 & (or_1021 | or_1025));
  logic or_1097;
  assign or_1097 = (or_1036 & or_1040) | (or_1032 & (or_1036 | or_1040));
  logic or_1101;
  assign or_1101 = (or_1051 & or_1055) | (or_1047 & (or_1051 | or_1055));
  // hls/stages/count_bits.hpp:24
  logic parity_1104;
  assign parity_1104 = ^{or_1101, or_1097, or_1093};
  logic parity_1107;
  assign parity_1107 = ^{or_1101, or_1097, or_1093, or_1086, or_1082, or_1078, or_1071, or_1067, and_1063};
  // hls/stages/count_bits.hpp:25
  logic or_1111;
  assign or_1111 = (parity_1089 & parity_1104) | ((^{or_1071, or_1067, and_1063}) & (parity_1089 | parity_1104));
  logic or_1115;
  assign or_1115 = (or_1067 & or_1071) | (and_1063 & (or_1067 | or_1071));
  logic or_1119;
  assign or_1119 = (or_1082 & or_1086) | (or_1078 & (or_1082 | or_1086));
  logic or_1123;
  assign or_1123 = (or_1097 & or_1101) | (or_1093 & (or_1097 | or_1101));
  // hls/stages/count_bits.hpp:24
  logic parity_1128;
  assign parity_1128 = ^{or_1123, or_1119, or_1115, or_1111};
  // hls/stages/count_bits.hpp:25
  logic or_1132;
  assign or_1132 = (or_1119 & or_1123) | (or_1115 & (or_1119 | or_1123));
  logic and_1133;
  assign and_1133 = or_1111 & (^{or_1123, or_1119, or_1115});
  // hls/stages/count_bits.hpp:24
  logic xor_1134;
  assign xor_1134 = or_1132 ^ and_1133;
  // hls/stages/count_bits.hpp:27
  logic and_1135;
  assign and_1135 = or_1132 & and_1133;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1136;
  assign select_1136 = equal_527_s1_q ? {and_1135, xor_1134, parity_1128, parity_1107, xor_1062, xor_967} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_525_s1_q ? 6'h0 : select_1136;
  // hls/stages/agreement.hpp:763
  logic [5:0] select_1138;
  assign select_1138 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1139;
  assign difference_1139 = {1'b0, column_3} - {1'b0, select_1138};
  logic [7:0] sum_1141;
  assign sum_1141 = {difference_1139[6], difference_1139} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:212
  logic and_1142;
  assign and_1142 = right_codes_rdata_q[25] & not_533_s1_q;
  logic [11:0] select_1143;
  assign select_1143 = less_532_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1147;
  assign select_1147 = and_652 ? (and_1142 ? (~(select_1143 ^ select_655)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1153;
  assign parity_1153 = ^select_1147[5:3];
  logic parity_1156;
  assign parity_1156 = ^select_1147[8:6];
  logic parity_1159;
  assign parity_1159 = ^select_1147[11:3];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1166;
  assign select_1166 = and_675 ? (and_653 ? (~(select_654 ^ select_678)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1169;
  assign parity_1169 = ^select_1166[8:6];
  logic parity_1172;
  assign parity_1172 = ^select_1166[11:9];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1179;
  assign select_1179 = and_692 ? (and_676 ? (~(select_677 ^ select_695)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1185;
  assign parity_1185 = ^select_1179[2:0];
  logic parity_1188;
  assign parity_1188 = ^select_1179[5:3];
  logic parity_1191;
  assign parity_1191 = ^select_1179[8:0];
  logic parity_1197;
  assign parity_1197 = ^select_1179[11:9];
  logic parity_1200;
  assign parity_1200 = ^select_1166[2:0];
  logic parity_1203;
  assign parity_1203 = ^{select_1179[11:9], select_1166[5:0]};
  logic parity_1206;
  assign parity_1206 = ^{select_1179, select_1166, select_1147[2:0]};
  logic xor_1207;
  assign xor_1207 = parity_1159 ^ parity_1206;
  // hls/stages/count_bits.hpp:23
  logic or_1211;
  assign or_1211 = (select_1147[1:0] == 2'h3) | (select_1147[2] & (select_1147[0] | select_1147[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1215;
  assign or_1215 = (select_1166[7:6] == 2'h3) | (select_1166[8] & (select_1166[6] | select_1166[7]));
  logic or_1219;
  assign or_1219 = (select_1166[10:9] == 2'h3) | (select_1166[11] & (select_1166[9] | select_1166[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1227;
  assign or_1227 = (select_1179[7:6] == 2'h3) | (select_1179[8] & (~(select_1179[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1231;
  assign or_1231 = (select_1179[1:0] == 2'h3) | (select_1179[2] & (select_1179[0] | select_1179[1]));
  logic or_1235;
  assign or_1235 = (select_1179[4:3] == 2'h3) | (select_1179[5] & (select_1179[3] | select_1179[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1238;
  assign parity_1238 = ^{or_1235, or_1231, or_1227};
  // hls/stages/count_bits.hpp:23
  logic or_1242;
  assign or_1242 = (select_1166[4:3] == 2'h3) | (select_1166[5] & (select_1166[3] | select_1166[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1246;
  assign or_1246 = (select_1179[10:9] == 2'h3) | (select_1179[11] & (select_1179[9] | select_1179[10]));
  logic or_1250;
  assign or_1250 = (select_1166[1:0] == 2'h3) | (select_1166[2] & (select_1166[0] | select_1166[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1253;
  assign parity_1253 = ^{or_1250, or_1246, or_1242};
  logic parity_1256;
  assign parity_1256 = ^{or_1250, or_1246, or_1242, or_1235, or_1231, or_1227, or_1219, or_1215, or_1211};
  // hls/stages/count_bits.hpp:25
  logic and_1257;
  assign and_1257 = parity_1159 & parity_1206;
  logic or_1261;
  assign or_1261 = (parity_1153 & parity_1156) | ((^select_1147[11:9]) & (parity_1153 | parity_1156));
  logic and_1264;
  assign and_1264 = (^{select_1166[11:6], select_1147[2:0]}) & (parity_1191 | parity_1203);
  logic or_1265;
  assign or_1265 = (parity_1191 & parity_1203) | and_1264;
  // hls/stages/count_bits.hpp:23
  logic or_1272;
  assign or_1272 = (select_1147[10:9] == 2'h3) | (select_1147[11] & (select_1147[9] | select_1147[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1276;
  assign or_1276 = (select_1147[4:3] == 2'h3) | (select_1147[5] & (select_1147[3] | select_1147[4]));
  logic or_1280;
  assign or_1280 = (select_1147[7:6] == 2'h3) | (select_1147[8] & (select_1147[6] | select_1147[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1283;
  assign parity_1283 = ^{or_1280, or_1276, or_1272};
  // hls/stages/count_bits.hpp:25
  logic or_1287;
  assign or_1287 = (parity_1169 & parity_1172) | ((^select_1147[2:0]) & (parity_1169 | parity_1172));
  logic or_1291;
  assign or_1291 = (parity_1185 & parity_1188) | ((^select_1179[8:6]) & (parity_1185 | parity_1188));
  logic or_1295;
  assign or_1295 = (parity_1197 & parity_1200) | ((^select_1166[5:3]) & (parity_1197 | parity_1200));
  // hls/stages/count_bits.hpp:24
  logic parity_1298;
  assign parity_1298 = ^{or_1295, or_1291, or_1287};
  logic parity_1301;
  assign parity_1301 = ^{or_1295, or_1291, or_1287, or_1280, or_1276, or_1272, or_1265, or_1261, and_1257};
  logic xor_1302;
  assign xor_1302 = parity_1256 ^ parity_1301;
  // hls/stages/count_bits.hpp:25
  logic and_1303;
  assign and_1303 = parity_1256 & parity_1301;
  logic or_1307;
  assign or_1307 = (parity_1238 & parity_1253) | ((^{or_1219, or_1215, or_1211}) & (parity_1238 | parity_1253));
  logic or_1311;
  assign or_1311 = (parity_1283 & parity_1298) | ((^{or_1265, or_1261, and_1257}) & (parity_1283 | parity_1298));
  logic or_1318;
  assign or_1318 = (or_1215 & or_1219) | (or_1211 & (or_1215 | or_1219));
  logic or_1322;
  assign or_1322 = (or_1231 & or_1235) | (or_1227 & (or_1231 | or_1235));
  logic or_1326;
  assign or_1326 = (or_1246 & or_1250) | (or_1242 & (or_1246 | or_1250));
  // hls/stages/count_bits.hpp:24
  logic parity_1329;
  assign parity_1329 = ^{or_1326, or_1322, or_1318};
  // hls/stages/count_bits.hpp:25
  logic or_1333;
  assign or_1333 = (or_1261 & or_1265) | (and_1257 & (or_1261 | or_1265));
  logic or_1337;
  assign or_1337 = (or_1276 & or_1280) | (or_1272 & (or_1276 | or_1280));
  logic or_1341;
  assign or_1341 = (or_1291 & or_1295) | (or_1287 & (or_1291 | or_1295));
  // hls/stages/count_bits.hpp:24
  logic parity_1344;
  assign parity_1344 = ^{or_1341, or_1337, or_1333};
  logic parity_1347;
  assign parity_1347 = ^{or_1341, or_1337, or_1333, or_1326, or_1322, or_1318, or_1311, or_1307, and_1303};
  // hls/stages/count_bits.hpp:25
  logic or_1351;
  assign or_1351 = (parity_1329 & parity_1344) | ((^{or_1311, or_1307, and_1303}) & (parity_1329 | parity_1344));
  logic or_1355;
  assign or_1355 = (or_1307 & or_1311) | (and_1303 & (or_1307 | or_1311));
  logic or_1359;
  assign or_1359 = (or_1322 & or_1326) | (or_1318 & (or_1322 | or_1326));
  logic or_1363;
  assign or_1363 = (or_1337 & or_1341) | (or_1333 & (or_1337 | or_1341));
  // hls/stages/count_bits.hpp:24
  logic parity_1368;
  assign parity_1368 = ^{or_1363, or_1359, or_1355, or_1351};
  // hls/stages/count_bits.hpp:25
  logic or_1372;
  assign or_1372 = (or_1359 & or_1363) | (or_1355 & (or_1359 | or_1363));
  logic and_1373;
  assign and_1373 = or_1351 & (^{or_1363, or_1359, or_1355});
  // hls/stages/count_bits.hpp:24
  logic xor_1374;
  assign xor_1374 = or_1372 ^ and_1373;
  // hls/stages/count_bits.hpp:27
  logic and_1375;
  assign and_1375 = or_1372 & and_1373;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1376;
  assign select_1376 = equal_527_s1_q ? {and_1375, xor_1374, parity_1368, parity_1347, xor_1302, xor_1207} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_525_s1_q ? 6'h0 : select_1376;
  // hls/stages/agreement.hpp:763
  logic [5:0] select_1378;
  assign select_1378 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1379;
  assign difference_1379 = {1'b0, column_4} - {1'b0, select_1378};
  logic [7:0] sum_1381;
  assign sum_1381 = {difference_1379[6], difference_1379} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1389;
  assign select_1389 = and_652 ? (and_693 ? (~(select_694 ^ select_655)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1395;
  assign parity_1395 = ^select_1389[5:3];
  logic parity_1398;
  assign parity_1398 = ^select_1389[8:6];
  logic parity_1401;
  assign parity_1401 = ^select_1389[11:3];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1408;
  assign select_1408 = and_675 ? (and_934 ? (~(select_935 ^ select_678)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1411;
  assign parity_1411 = ^select_1408[8:6];
  logic parity_1414;
  assign parity_1414 = ^select_1408[11:9];
  // hls/stages/agreement.hpp:670
  logic [11:0] xor_1420;
  assign xor_1420 = (less_532_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_695;
  logic [11:0] select_1423;
  assign select_1423 = and_692 ? ((right_codes_rdata_q[90] & not_533_s1_q) ? (~xor_1420) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1429;
  assign parity_1429 = ^select_1423[2:0];
  logic parity_1432;
  assign parity_1432 = ^select_1423[5:3];
  logic parity_1435;
  assign parity_1435 = ^select_1423[8:0];
  logic parity_1441;
  assign parity_1441 = ^select_1423[11:9];
  logic parity_1444;
  assign parity_1444 = ^select_1408[2:0];
  logic parity_1447;
  assign parity_1447 = ^{select_1423[11:9], select_1408[5:0]};
  logic parity_1450;
  assign parity_1450 = ^{select_1423, select_1408, select_1389[2:0]};
  logic xor_1451;
  assign xor_1451 = parity_1401 ^ parity_1450;
  // hls/stages/count_bits.hpp:23
  logic or_1455;
  assign or_1455 = (select_1389[1:0] == 2'h3) | (select_1389[2] & (select_1389[0] | select_1389[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1459;
  assign or_1459 = (select_1408[7:6] == 2'h3) | (select_1408[8] & (select_1408[6] | select_1408[7]));
  logic or_1463;
  assign or_1463 = (select_1408[10:9] == 2'h3) | (select_1408[11] & (select_1408[9] | select_1408[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1471;
  assign or_1471 = (select_1423[7:6] == 2'h3) | (select_1423[8] & (~(select_1423[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1475;
  assign or_1475 = (select_1423[1:0] == 2'h3) | (select_1423[2] & (select_1423[0] | select_1423[1]));
  logic or_1479;
  assign or_1479 = (select_1423[4:3] == 2'h3) | (select_1423[5] & (select_1423[3] | select_1423[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1482;
  assign parity_1482 = ^{or_1479, or_1475, or_1471};
  // hls/stages/count_bits.hpp:23
  logic or_1486;
  assign or_1486 = (select_1408[4:3] == 2'h3) | (select_1408[5] & (select_1408[3] | select_1408[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1490;
  assign or_1490 = (select_1423[10:9] == 2'h3) | (select_1423[11] & (select_1423[9] | select_1423[10]));
  logic or_1494;
  assign or_1494 = (select_1408[1:0] == 2'h3) | (select_1408[2] & (select_1408[0] | select_1408[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1497;
  assign parity_1497 = ^{or_1494, or_1490, or_1486};
  logic parity_1500;
  assign parity_1500 = ^{or_1494, or_1490, or_1486, or_1479, or_1475, or_1471, or_1463, or_1459, or_1455};
  // hls/stages/count_bits.hpp:25
  logic and_1501;
  assign and_1501 = parity_1401 & parity_1450;
  logic or_1505;
  assign or_1505 = (parity_1395 & parity_1398) | ((^select_1389[11:9]) & (parity_1395 | parity_1398));
  logic and_1508;
  assign and_1508 = (^{select_1408[11:6], select_1389[2:0]}) & (parity_1435 | parity_1447);
  logic or_1509;
  assign or_1509 = (parity_1435 & parity_1447) | and_1508;
  // hls/stages/count_bits.hpp:23
  logic or_1516;
  assign or_1516 = (select_1389[10:9] == 2'h3) | (select_1389[11] & (select_1389[9] | select_1389[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1520;
  assign or_1520 = (select_1389[4:3] == 2'h3) | (select_1389[5] & (select_1389[3] | select_1389[4]));
  logic or_1524;
  assign or_1524 = (select_1389[7:6] == 2'h3) | (select_1389[8] & (select_1389[6] | select_1389[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1527;
  assign parity_1527 = ^{or_1524, or_1520, or_1516};
  // hls/stages/count_bits.hpp:25
  logic or_1531;
  assign or_1531 = (parity_1411 & parity_1414) | ((^select_1389[2:0]) & (parity_1411 | parity_1414));
  logic or_1535;
  assign or_1535 = (parity_1429 & parity_1432) | ((^select_1423[8:6]) & (parity_1429 | parity_1432));
  logic or_1539;
  assign or_1539 = (parity_1441 & parity_1444) | ((^select_1408[5:3]) & (parity_1441 | parity_1444));
  // hls/stages/count_bits.hpp:24
  logic parity_1542;
  assign parity_1542 = ^{or_1539, or_1535, or_1531};
  logic parity_1545;
  assign parity_1545 = ^{or_1539, or_1535, or_1531, or_1524, or_1520, or_1516, or_1509, or_1505, and_1501};
  logic xor_1546;
  assign xor_1546 = parity_1500 ^ parity_1545;
  // hls/stages/count_bits.hpp:25
  logic and_1547;
  assign and_1547 = parity_1500 & parity_1545;
  logic or_1551;
  assign or_1551 = (parity_1482 & parity_1497) | ((^{or_1463, or_1459, or_1455}) & (parity_1482 | parity_1497));
  logic or_1555;
  assign or_1555 = (parity_1527 & parity_1542) | ((^{or_1509, or_1505, and_1501}) & (parity_1527 | parity_1542));
  logic or_1562;
  assign or_1562 = (or_1459 & or_1463) | (or_1455 & (or_1459 | or_1463));
  logic or_1566;
  assign or_1566 = (or_1475 & or_1479) | (or_1471 & (or_1475 | or_1479));
  logic or_1570;
  assign or_1570 = (or_1490 & or_1494) | (or_1486 & (or_1490 | or_1494));
  // hls/stages/count_bits.hpp:24
  logic parity_1573;
  assign parity_1573 = ^{or_1570, or_1566, or_1562};
  // hls/stages/count_bits.hpp:25
  logic or_1577;
  assign or_1577 = (or_1505 & or_1509) | (and_1501 & (or_1505 | or_1509));
  logic or_1581;
  assign or_1581 = (or_1520 & or_1524) | (or_1516 & (or_1520 | or_1524));
  logic or_1585;
  assign or_1585 = (or_1535 & or_1539) | (or_1531 & (or_1535 | or_1539));
  // hls/stages/count_bits.hpp:24
  logic parity_1588;
  assign parity_1588 = ^{or_1585, or_1581, or_1577};
  logic parity_1591;
  assign parity_1591 = ^{or_1585, or_1581, or_1577, or_1570, or_1566, or_1562, or_1555, or_1551, and_1547};
  // hls/stages/count_bits.hpp:25
  logic or_1595;
  assign or_1595 = (parity_1573 & parity_1588) | ((^{or_1555, or_1551, and_1547}) & (parity_1573 | parity_1588));
  logic or_1599;
  assign or_1599 = (or_1551 & or_1555) | (and_1547 & (or_1551 | or_1555));
  logic or_1603;
  assign or_1603 = (or_1566 & or_1570) | (or_1562 & (or_1566 | or_1570));
  logic or_1607;
  assign or_1607 = (or_1581 & or_1585) | (or_1577 & (or_1581 | or_1585));
  // hls/stages/count_bits.hpp:24
  logic parity_1612;
  assign parity_1612 = ^{or_1607, or_1603, or_1599, or_1595};
  // hls/stages/count_bits.hpp:25
  logic or_1616;
  assign or_1616 = (or_1603 & or_1607) | (or_1599 & (or_1603 | or_1607));
  logic and_1617;
  assign and_1617 = or_1595 & (^{or_1607, or_1603, or_1599});
  // hls/stages/count_bits.hpp:24
  logic xor_1618;
  assign xor_1618 = or_1616 ^ and_1617;
  // hls/stages/count_bits.hpp:27
  logic and_1619;
  assign and_1619 = or_1616 & and_1617;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1620;
  assign select_1620 = equal_527_s1_q ? {and_1619, xor_1618, parity_1612, parity_1591, xor_1546, xor_1451} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_525_s1_q ? 6'h0 : select_1620;
  // hls/stages/agreement.hpp:763
  logic [5:0] select_1622;
  assign select_1622 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1623;
  assign difference_1623 = {1'b0, column_5} - {1'b0, select_1622};
  logic [7:0] sum_1625;
  assign sum_1625 = {difference_1623[6], difference_1623} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:670
  logic [11:0] not_1629;
  assign not_1629 = ~((less_532_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_655);
  logic [11:0] select_1631;
  assign select_1631 = and_652 ? ((right_codes_rdata_q[12] & not_533_s1_q) ? not_1629 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1637;
  assign parity_1637 = ^select_1631[5:3];
  logic parity_1640;
  assign parity_1640 = ^select_1631[8:6];
  logic parity_1643;
  assign parity_1643 = ^select_1631[11:3];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1650;
  assign select_1650 = and_675 ? (and_1142 ? (~(select_1143 ^ select_678)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1653;
  assign parity_1653 = ^select_1650[8:6];
  logic parity_1656;
  assign parity_1656 = ^select_1650[11:9];
  // hls/stages/agreement.hpp:670
  logic [11:0] select_1663;
  assign select_1663 = and_692 ? (and_653 ? (~(select_654 ^ select_695)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1669;
  assign parity_1669 = ^select_1663[2:0];
  logic parity_1672;
  assign parity_1672 = ^select_1663[5:3];
  logic parity_1675;
  assign parity_1675 = ^select_1663[8:0];
  logic parity_1681;
  assign parity_1681 = ^select_1663[11:9];
  logic parity_1684;
  assign parity_1684 = ^select_1650[2:0];
  logic parity_1687;
  assign parity_1687 = ^{select_1663[11:9], select_1650[5:0]};
  logic parity_1690;
  assign parity_1690 = ^{select_1663, select_1650, select_1631[2:0]};
  logic xor_1691;
  assign xor_1691 = parity_1643 ^ parity_1690;
  // hls/stages/count_bits.hpp:23
  logic or_1695;
  assign or_1695 = (select_1631[1:0] == 2'h3) | (select_1631[2] & (select_1631[0] | select_1631[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1699;
  assign or_1699 = (select_1650[7:6] == 2'h3) | (select_1650[8] & (select_1650[6] | select_1650[7]));
  logic or_1703;
  assign or_1703 = (select_1650[10:9] == 2'h3) | (select_1650[11] & (select_1650[9] | select_1650[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1711;
  assign or_1711 = (select_1663[7:6] == 2'h3) | (select_1663[8] & (~(select_1663[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1715;
  assign or_1715 = (select_1663[1:0] == 2'h3) | (select_1663[2] & (select_1663[0] | select_1663[1]));
  logic or_1719;
  assign or_1719 = (select_1663[4:3] == 2'h3) | (select_1663[5] & (select_1663[3] | select_1663[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1722;
  assign parity_1722 = ^{or_1719, or_1715, or_1711};
  // hls/stages/count_bits.hpp:23
  logic or_1726;
  assign or_1726 = (select_1650[4:3] == 2'h3) | (select_1650[5] & (select_1650[3] | select_1650[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1730;
  assign or_1730 = (select_1663[10:9] == 2'h3) | (select_1663[11] & (select_1663[9] | select_1663[10]));
  logic or_1734;
  assign or_1734 = (select_1650[1:0] == 2'h3) | (select_1650[2] & (select_1650[0] | select_1650[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1737;
  assign parity_1737 = ^{or_1734, or_1730, or_1726};
  logic parity_1740;
  assign parity_1740 = ^{or_1734, or_1730, or_1726, or_1719, or_1715, or_1711, or_1703, or_1699, or_1695};
  // hls/stages/count_bits.hpp:25
  logic and_1741;
  assign and_1741 = parity_1643 & parity_1690;
  logic or_1745;
  assign or_1745 = (parity_1637 & parity_1640) | ((^select_1631[11:9]) & (parity_1637 | parity_1640));
  logic and_1748;
  assign and_1748 = (^{select_1650[11:6], select_1631[2:0]}) & (parity_1675 | parity_1687);
  logic or_1749;
  assign or_1749 = (parity_1675 & parity_1687) | and_1748;
  // hls/stages/count_bits.hpp:23
  logic or_1756;
  assign or_1756 = (select_1631[10:9] == 2'h3) | (select_1631[11] & (select_1631[9] | select_1631[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1760;
  assign or_1760 = (select_1631[4:3] == 2'h3) | (select_1631[5] & (select_1631[3] | select_1631[4]));
  logic or_1764;
  assign or_1764 = (select_1631[7:6] == 2'h3) | (select_1631[8] & (select_1631[6] | select_1631[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1767;
  assign parity_1767 = ^{or_1764, or_1760, or_1756};
  // hls/stages/count_bits.hpp:25
  logic or_1771;
  assign or_1771 = (parity_1653 & parity_1656) | ((^select_1631[2:0]) & (parity_1653 | parity_1656));
  logic or_1775;
  assign or_1775 = (parity_1669 & parity_1672) | ((^select_1663[8:6]) & (parity_1669 | parity_1672));
  logic or_1779;
  assign or_1779 = (parity_1681 & parity_1684) | ((^select_1650[5:3]) & (parity_1681 | parity_1684));
  // hls/stages/count_bits.hpp:24
  logic parity_1782;
  assign parity_1782 = ^{or_1779, or_1775, or_1771};
  logic parity_1785;
  assign parity_1785 = ^{or_1779, or_1775, or_1771, or_1764, or_1760, or_1756, or_1749, or_1745, and_1741};
  logic xor_1786;
  assign xor_1786 = parity_1740 ^ parity_1785;
  // hls/stages/count_bits.hpp:25
  logic and_1787;
  assign and_1787 = parity_1740 & parity_1785;
  logic or_1791;
  assign or_1791 = (parity_1722 & parity_1737) | ((^{or_1703, or_1699, or_1695}) & (parity_1722 | parity_1737));
  logic or_1795;
  assign or_1795 = (parity_1767 & parity_1782) | ((^{or_1749, or_1745, and_1741}) & (parity_1767 | parity_1782));
  logic or_1802;
  assign or_1802 = (or_1699 & or_1703) | (or_1695 & (or_1699 | or_1703));
  logic or_1806;
  assign or_1806 = (or_1715 & or_1719) | (or_1711 & (or_1715 | or_1719));
  logic or_1810;
  assign or_1810 = (or_1730 & or_1734) | (or_1726 & (or_1730 | or_1734));
  // hls/stages/count_bits.hpp:24
  logic parity_1813;
  assign parity_1813 = ^{or_1810, or_1806, or_1802};
  // hls/stages/count_bits.hpp:25
  logic or_1817;
  assign or_1817 = (or_1745 & or_1749) | (and_1741 & (or_1745 | or_1749));
  logic or_1821;
  assign or_1821 = (or_1760 & or_1764) | (or_1756 & (or_1760 | or_1764));
  logic or_1825;
  assign or_1825 = (or_1775 & or_1779) | (or_1771 & (or_1775 | or_1779));
  // hls/stages/count_bits.hpp:24
  logic parity_1828;
  assign parity_1828 = ^{or_1825, or_1821, or_1817};
  logic parity_1831;
  assign parity_1831 = ^{or_1825, or_1821, or_1817, or_1810, or_1806, or_1802, or_1795, or_1791, and_1787};
  // hls/stages/count_bits.hpp:25
  logic or_1835;
  assign or_1835 = (parity_1813 & parity_1828) | ((^{or_1795, or_1791, and_1787}) & (parity_1813 | parity_1828));
  logic or_1839;
  assign or_1839 = (or_1791 & or_1795) | (and_1787 & (or_1791 | or_1795));
  logic or_1843;
  assign or_1843 = (or_1806 & or_1810) | (or_1802 & (or_1806 | or_1810));
  logic or_1847;
  assign or_1847 = (or_1821 & or_1825) | (or_1817 & (or_1821 | or_1825));
  // hls/stages/count_bits.hpp:24
  logic parity_1852;
  assign parity_1852 = ^{or_1847, or_1843, or_1839, or_1835};
  // hls/stages/count_bits.hpp:25
  logic or_1856;
  assign or_1856 = (or_1843 & or_1847) | (or_1839 & (or_1843 | or_1847));
  logic and_1857;
  assign and_1857 = or_1835 & (^{or_1847, or_1843, or_1839});
  // hls/stages/count_bits.hpp:24
  logic xor_1858;
  assign xor_1858 = or_1856 ^ and_1857;
  // hls/stages/count_bits.hpp:27
  logic and_1859;
  assign and_1859 = or_1856 & and_1857;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1860;
  assign select_1860 = equal_527_s1_q ? {and_1859, xor_1858, parity_1852, parity_1831, xor_1786, xor_1691} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_525_s1_q ? 6'h0 : select_1860;
  // hls/stages/agreement.hpp:763
  logic [5:0] select_1862;
  assign select_1862 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1863;
  assign difference_1863 = {1'b0, column_6} - {1'b0, select_1862};
  logic [7:0] sum_1865;
  assign sum_1865 = {difference_1863[6], difference_1863} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:937
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:938
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:939
  logic [6:0] select_1922;
  assign select_1922 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:942
  logic and_1942;
  assign and_1942 = (or_525_s1_q & (left_rdata_q[61] & not_533_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1964;
  assign or_1964 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:773
  logic [6:0] select_1975;
  assign select_1975 = so_s1_q ? x_s1_q[6:0] : (or_525_s1_q ? (less_532_s1_q ? 7'h0 : select_1922) : 7'h0);
  // hls/stages/patches.hpp:114
  logic and_2049;
  assign and_2049 = (select_468_s1_q == 3'h0) & (select_470_s1_q == 7'h0);
  // hls/stages/patches.hpp:382
  logic not_2050;
  assign not_2050 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_2053;
  assign not_2053 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:352
  logic and_2054;
  assign and_2054 = patches_capturing_q & not_2053;
  // hls/stages/patches.hpp:302
  logic equal_2057;
  assign equal_2057 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:117
  logic and_2062;
  assign and_2062 = (not_2050 & (patches_work_q == 3'h0)) & (~(and_2054 | ((~equal_2055_s1_q) | (~equal_2057))));
  // hls/stages/patches.hpp:520
  logic equal_2149;
  assign equal_2149 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:498
  logic not_2150;
  assign not_2150 = ~equal_2149;
  // hls/stages/patches.hpp:491
  logic equal_2151;
  assign equal_2151 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:444
  logic not_2152;
  assign not_2152 = ~equal_2151;
  // hls/stages/patches.hpp:485
  logic equal_2153;
  assign equal_2153 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:159
  logic equal_2154;
  assign equal_2154 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:520
  logic or_2155;
  assign or_2155 = equal_2153 | equal_2154;
  // hls/stages/patches.hpp:446
  logic not_2156;
  assign not_2156 = ~patches_second_q;
  // hls/stages/patches.hpp:363
  logic [4:0] select_2178;
  assign select_2178 = and_2062 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:118
  logic [4:0] select_2179;
  assign select_2179 = and_2049 ? select_2178 : patches_row_q;
  // hls/stages/patches.hpp:117
  logic and_2181;
  assign and_2181 = and_2054 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:118
  logic select_2185;
  assign select_2185 = and_2049 ? (and_2062 | (and_2054 & (~and_2181))) : patches_capturing_q;
  // hls/stages/patches.hpp:176
  logic and_2193;
  assign and_2193 = not_2150 & (not_2152 & (or_2155 & (patches_second_q & equal_2154)));
  // hls/stages/patches.hpp:159
  logic not_2210;
  assign not_2210 = ~equal_2154;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_2226;
  assign select_2226 = and_2049 ? {select_2178[4], select_2178[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:444
  logic and_2236;
  assign and_2236 = not_2150 & (or_2155 & not_2152);
  // hls/stages/agreement.hpp:444
  logic [5:0] or_2620;
  assign or_2620 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:448
  logic select_2839;
  assign select_2839 = equal_2745_s1_q ? (~({row_s1_q, 1'b0} < {sum_2836, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:508
  logic and_3036;
  assign and_3036 = and_504_s1_q & (equal_2745_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:308
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:118
  logic [3:0] select_3146;
  assign select_3146 = and_2049 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_3147;
  assign select_3147 = sample_pair_whole_s1_q ? select_3146 : patches_phase_q;
  // hls/stages/patches.hpp:363
  logic and_3148;
  assign and_3148 = not_2053 & equal_2055_s1_q;
  logic [8:0] select_3149;
  assign select_3149 = and_3148 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3150;
  assign select_3150 = and_3148 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3151;
  assign select_3151 = sample_pair_first_s1_q ? select_3149 : select_3150;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_3153;
  assign select_3153 = sample_pair_whole_s1_q ? (and_2049 ? select_3151[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3155;
  assign select_3155 = sample_pair_whole_s1_q ? (and_2049 ? select_3151[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3158;
  assign select_3158 = sample_pair_whole_s1_q ? (equal_2057 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3160;
  assign select_3160 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_2057}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:321
  logic equal_3161;
  assign equal_3161 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:322
  logic not_3162;
  assign not_3162 = ~equal_3161;
  // hls/stages/agreement.hpp:264
  logic [3:0] select_3164;
  assign select_3164 = sample_pair_whole_s1_q ? (phase + {not_3162, 1'b1, not_3162, equal_3161}) : patches_first_band_rows_to_next_q;
  logic select_3165;
  assign select_3165 = sample_pair_whole_s1_q ? equal_3161 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:458
  logic equal_3166;
  assign equal_3166 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:79
  logic [3:0] select_3170;
  assign select_3170 = equal_3166 ? ((select_3147 == 4'h6) ? 4'h0 : (select_3147 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3171;
  assign equal_3171 = select_3170 == 4'h0;
  // hls/stages/agreement.hpp:448
  logic [3:0] select_3174;
  assign select_3174 = equal_2745_s1_q ? (equal_3171 ? 4'h6 : (select_3170 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:79
  logic [4:0] select_3176;
  assign select_3176 = equal_3166 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:448
  logic [4:0] select_3178;
  assign select_3178 = equal_2745_s1_q ? (select_3176 + {4'h0, equal_3171}) : patches_choosing_number_q;
  logic select_3182;
  assign select_3182 = equal_2745_s1_q ? ((6'h2 < row_s1_q) & equal_3171) : patches_chooses_q;
  // hls/stages/agreement.hpp:508
  logic [4:0] select_3185;
  assign select_3185 = and_504_s1_q ? (equal_2745_s1_q ? select_3176 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:118
  logic select_3214;
  assign select_3214 = and_2049 ? (and_2062 ? not_3212_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:383
  logic or_3253;
  assign or_3253 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:385
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:179
  logic and_3259;
  assign and_3259 = equal_2149 & not_2156;
  // hls/stages/patches.hpp:389
  logic and_3260;
  assign and_3260 = not_2210 & and_3259;
  logic [1:0] select_3262;
  assign select_3262 = equal_2151 ? 2'h0 : (equal_2153 ? 2'h3 : {equal_2154, and_3260});
  // hls/stages/patches.hpp:270
  logic equal_3264;
  assign equal_3264 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:268
  logic not_3265;
  assign not_3265 = ~equal_3264;
  // hls/stages/patches.hpp:270
  logic equal_3266;
  assign equal_3266 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:266
  logic not_3267;
  assign not_3267 = ~equal_3266;
  // hls/stages/patches.hpp:274
  logic not_3269;
  assign not_3269 = ~(patches_following_q == 3'h2);
  logic and_3272;
  assign and_3272 = (~(patches_following_q == 3'h1)) & not_3269;
  // hls/stages/patches.hpp:387
  logic [1:0] select_3273;
  assign select_3273 = equal_3266 ? 2'h2 : {and_3272, not_3269};
  logic [3:0] select_3274;
  assign select_3274 = equal_3264 ? 4'h2 : {select_3273, {2{not_3267}}};
  // hls/stages/patches.hpp:395
  logic not_3277;
  assign not_3277 = ~or_3253;
  // hls/stages/patches.hpp:384
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:396
  logic [11:0] select_3282;
  assign select_3282 = or_3253 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:179
  logic [4:0] select_3284;
  assign select_3284 = or_3253 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1309; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_525_s1_q ? select_1922 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_646_s1_q;
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
  assign patches_right_0_re = s1_en & (not_2150 & (not_2152 & (or_2155 & (equal_2154 & not_2156))));
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
  assign patches_right_1_re = s1_en & and_2193;
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
  assign patches_left_re = s1_en & (not_2150 & (not_2152 & (not_2210 & or_2155)));
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
  assign patches_columns_above_re = s1_en & and_2236;
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
  assign left_we = s1_en & and_536_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_628, left_rdata_q[59:45], and_627, left_rdata_q[43:29], and_626, left_rdata_q[27:13], and_625, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_536_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_637, right_codes_rdata_q[76:65], and_636, right_codes_rdata_q[63:52], and_635, right_codes_rdata_q[50:39], and_634, right_codes_rdata_q[37:26], and_633, right_codes_rdata_q[24:13], and_632, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_504_s1_q ? (equal_2745_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_504_s1_q ? select_2839 : lower_half_q;
      patches_phase_q <= select_3147;
      patches_band_rows_rows_to_next_q <= select_3153;
      patches_band_rows_number_q <= select_3155;
      patches_next_band_rows_to_next_q <= select_3158;
      patches_next_band_number_q <= select_3160;
      patches_first_band_rows_to_next_q <= select_3164;
      patches_first_band_number_q <= select_3165;
      patches_choosing_rows_to_next_q <= and_504_s1_q ? select_3174 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_504_s1_q ? select_3178 : patches_choosing_number_q;
      patches_chooses_q <= and_504_s1_q ? select_3182 : patches_chooses_q;
      patches_choosing_band_q <= select_3185;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_2185 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_3214 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_2179 : patches_row_q;
      patches_work_q <= or_3253 ? following : patches_work_q;
      patches_second_q <= not_2050 & (patches_second_q | (patches_ends_q & equal_2149));
      patches_following_q <= equal_2149 ? {2'h0, and_3259} : {equal_2151, select_3262};
      patches_following_beats_q <= {select_3274, not_3265};
      patches_begins_q <= sample_pair_whole_s1_q & (and_2049 & and_2181);
      patches_ends_q <= not_3277 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3282;
      patches_code_row_q <= select_3284;
      patches_column_q <= or_3253 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3277 & (patches_column_q == 5'h1e);
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
      middle_sum_sum_sums_values_0_q <= sum_901;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1141;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1381;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1625;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1865;
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
  logic [2:0] select_468_s2_q;
  logic [6:0] select_470_s2_q;
  logic [8:0] select_474_s2_q;
  logic and_478_s2_q;
  logic equal_484_s2_q;
  logic [6:0] column_s2_q;
  logic and_502_s2_q;
  logic and_504_s2_q;
  logic so_s2_q;
  logic equal_524_s2_q;
  logic or_525_s2_q;
  logic less_532_s2_q;
  logic not_533_s2_q;
  logic equal_565_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic and_1918_s2_q;
  logic [6:0] right_s2_q;
  logic equal_1926_s2_q;
  logic equal_1936_s2_q;
  logic and_1943_s2_q;
  logic and_1946_s2_q;
  logic and_1950_s2_q;
  logic or_1964_s2_q;
  logic [6:0] select_1975_s2_q;
  logic and_2049_s2_q;
  logic and_2062_s2_q;
  logic less_2076_s2_q;
  logic equal_2149_s2_q;
  logic not_2150_s2_q;
  logic equal_2151_s2_q;
  logic not_2152_s2_q;
  logic equal_2153_s2_q;
  logic equal_2154_s2_q;
  logic or_2155_s2_q;
  logic [4:0] select_2179_s2_q;
  logic select_2185_s2_q;
  logic [3:0] select_2226_s2_q;
  logic and_2236_s2_q;
  logic and_2475_s2_q;
  logic equal_2621_s2_q;
  logic equal_2745_s2_q;
  logic and_3037_s2_q;
  logic and_3039_s2_q;
  logic or_3253_s2_q;
  logic not_3277_s2_q;
  logic less_4059_s2_q;
  logic equal_4264_s2_q;
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
      select_468_s2_q <= select_468_s1_q;
      select_470_s2_q <= select_470_s1_q;
      select_474_s2_q <= select_474_s1_q;
      and_478_s2_q <= and_478_s1_q;
      equal_484_s2_q <= equal_484_s1_q;
      column_s2_q <= column_s1_q;
      and_502_s2_q <= and_502_s1_q;
      and_504_s2_q <= and_504_s1_q;
      so_s2_q <= so_s1_q;
      equal_524_s2_q <= equal_524_s1_q;
      or_525_s2_q <= or_525_s1_q;
      less_532_s2_q <= less_532_s1_q;
      not_533_s2_q <= not_533_s1_q;
      equal_565_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      and_1918_s2_q <= and_1918_s1_q;
      right_s2_q <= right_s1_q;
      equal_1926_s2_q <= equal_1926_s1_q;
      equal_1936_s2_q <= equal_1936_s1_q;
      and_1943_s2_q <= not_533_s1_q & and_1942;
      and_1946_s2_q <= (or_525_s1_q & (left_rdata_q[62] & not_533_s1_q)) & and_1942;
      and_1950_s2_q <= not_533_s1_q & (or_525_s1_q & (left_rdata_q[63] & not_533_s1_q));
      or_1964_s2_q <= or_1964;
      select_1975_s2_q <= select_1975;
      and_2049_s2_q <= and_2049;
      and_2062_s2_q <= and_2062;
      less_2076_s2_q <= 5'h4 < row_q[5:1];
      equal_2149_s2_q <= equal_2149;
      not_2150_s2_q <= not_2150;
      equal_2151_s2_q <= equal_2151;
      not_2152_s2_q <= not_2152;
      equal_2153_s2_q <= equal_2153;
      equal_2154_s2_q <= equal_2154;
      or_2155_s2_q <= or_2155;
      select_2179_s2_q <= select_2179;
      select_2185_s2_q <= select_2185;
      select_2226_s2_q <= select_2226;
      and_2236_s2_q <= and_2236;
      and_2475_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2621_s2_q <= {column_s1_q[6], or_2620} == 7'h0;
      equal_2745_s2_q <= equal_2745_s1_q;
      and_3037_s2_q <= and_2746_s1_q & and_3036;
      and_3039_s2_q <= and_2746_s1_q & (~and_3036);
      or_3253_s2_q <= or_3253;
      not_3277_s2_q <= not_3277;
      less_4059_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4264_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic and_479;
  assign and_479 = sample_pair_whole_s2_q & and_478_s2_q;
  // hls/stages/agreement.hpp:792
  logic or_649;
  assign or_649 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:793
  logic select_651;
  assign select_651 = or_649 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:736
  logic less_1382;
  assign less_1382 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1383;
  assign select_1383 = less_1382 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1384;
  assign less_1384 = middle_sum_sum_sums_values_0_q < select_1383;
  logic [7:0] select_1385;
  assign select_1385 = less_1384 ? select_1383 : middle_sum_sum_sums_values_0_q;
  logic less_1866;
  assign less_1866 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1867;
  assign select_1867 = less_1866 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1868;
  assign less_1868 = select_1385 < select_1867;
  // hls/stages/agreement.hpp:786
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1868 ? select_1867 : select_1385) : 8'h0;
  // hls/stages/agreement.hpp:793
  logic or_1872;
  assign or_1872 = select_651 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:798
  logic [5:0] select_1873;
  assign select_1873 = or_1872 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:737
  logic or_1875;
  assign or_1875 = less_1382 | (~less_1384);
  logic [2:0] select_1876;
  assign select_1876 = less_1868 ? {less_1866, 2'h0} : {1'b0, or_1875, less_1384};
  // hls/stages/agreement.hpp:798
  logic [2:0] select_1877;
  assign select_1877 = or_1872 ? select_1876 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1878;
  assign select_1878 = or_1872 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:795
  logic equal_1879;
  assign equal_1879 = select_1876 == 3'h1;
  logic or_1882;
  assign or_1882 = equal_1879 | (~(select_1876 == 3'h2));
  logic [7:0] select_1884;
  assign select_1884 = or_1882 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1885;
  assign select_1885 = equal_1879 ? (or_1882 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1884;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_1886;
  assign select_1886 = or_1872 ? select_1885 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:795
  logic [7:0] select_1887;
  assign select_1887 = or_1882 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_1889;
  assign select_1889 = or_1872 ? (equal_1879 ? select_1884 : select_1887) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1891;
  assign sum_1891 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1892;
  assign sum_1892 = {1'b0, before_v} + sum_1891;
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1894;
  assign sum_1894 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1895;
  assign sum_1895 = {1'b0, before_v_2} + sum_1894;
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1897;
  assign sum_1897 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1898;
  assign sum_1898 = {1'b0, before_v_3} + sum_1897;
  // hls/stages/agreement.hpp:736
  logic [6:0] select_1900;
  assign select_1900 = (sum_1895 < sum_1898) ? sum_1898 : sum_1895;
  logic [6:0] select_1902;
  assign select_1902 = (sum_1892 < select_1900) ? select_1900 : sum_1892;
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1904;
  assign sum_1904 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1905;
  assign sum_1905 = {1'b0, before_v_4} + sum_1904;
  // hls/stages/agreement.hpp:764
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:765
  logic [6:0] sum_1907;
  assign sum_1907 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1908;
  assign sum_1908 = {1'b0, before_v_5} + sum_1907;
  // hls/stages/agreement.hpp:736
  logic [6:0] select_1910;
  assign select_1910 = (sum_1905 < sum_1908) ? sum_1908 : sum_1905;
  // hls/stages/agreement.hpp:787
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1902 < select_1910) ? select_1910 : select_1902) : 7'h0;
  // hls/stages/agreement.hpp:798
  logic or_1915;
  assign or_1915 = select_651 | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:802
  logic [6:0] select_1916;
  assign select_1916 = or_1915 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1917;
  assign select_1917 = or_1915 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:806
  logic select_1927;
  assign select_1927 = or_649 ? shift_first_s2_q : equal_1926_s2_q;
  // hls/stages/agreement.hpp:807
  logic or_1929;
  assign or_1929 = select_1927 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:811
  logic [7:0] select_1930;
  assign select_1930 = or_1929 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1931;
  assign select_1931 = or_1929 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1933;
  assign or_1933 = select_1927 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:815
  logic [6:0] select_1934;
  assign select_1934 = or_1933 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1935;
  assign select_1935 = or_1933 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:965
  logic not_1937;
  assign not_1937 = ~equal_1936_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1947;
  assign and_1947 = not_533_s2_q & and_1946_s2_q;
  // hls/stages/agreement.hpp:945
  logic select_1953;
  assign select_1953 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:946
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:952
  logic [8:0] difference_1956;
  assign difference_1956 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:953
  logic [9:0] sum_1957;
  assign sum_1957 = {difference_1956[8], difference_1956} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1959;
  assign and_1959 = (and_1946_s2_q & select_1953) & ({{22{sum_1957[9]}}, sum_1957} < 32'h3);
  logic and_1960;
  assign and_1960 = not_533_s2_q & and_1959;
  logic and_1966;
  assign and_1966 = not_533_s2_q & (and_1959 & or_1964_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1967;
  assign select_1967 = less_532_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_525_s2_q ? {select_1967, and_1966, and_1960, and_1950_s2_q, and_1947, and_1943_s2_q, not_533_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:773
  logic and_1969;
  assign and_1969 = ends_cell_s2_q & shift_2[0];
  logic and_1971;
  assign and_1971 = not_1937 & (so_s2_q & and_1969);
  // hls/stages/agreement.hpp:965
  logic [5:0] sum_2021;
  assign sum_2021 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2[0] & ({1'b0, sum_2021, last_s2_q[1]} < x_s2_q);
  // hls/stages/patches.hpp:95
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/registration.hpp:218
  logic [16:0] select_2079;
  assign select_2079 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2079[16:7])) ? 8'h7f : select_2079[7:0];
  // hls/stages/patches.hpp:96
  logic and_2102;
  assign and_2102 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:98
  logic equal_2103;
  assign equal_2103 = x_s2_q == 8'h0;
  // hls/stages/patches.hpp:94
  logic [9:0] sum_2109;
  assign sum_2109 = {2'h0, x_s2_q} + {{4{shift_2[11]}}, shift_2[11:6]};
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2111;
  assign sum_2111 = {sum_2109[9], sum_2109[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:974
  logic and_2114;
  assign and_2114 = ($signed(9'h0) < $signed(sum_2109[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2111, sum_2109[0]})));
  logic and_2115;
  assign and_2115 = (~(and_2102 | (equal_2103 | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2114;
  // hls/stages/patches.hpp:105
  logic equal_2142;
  assign equal_2142 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:773
  logic and_2146;
  assign and_2146 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (and_2102 | equal_2142)));
  logic and_2147;
  assign and_2147 = not_1937 & and_2146;
  // hls/stages/patches.hpp:164
  logic [7:0] pixel;
  assign pixel = equal_2154_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2154_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:486
  logic less_2242;
  assign less_2242 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:487
  logic or_2243;
  assign or_2243 = equal_2153_s2_q | less_2242;
  // hls/stages/patches.hpp:490
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2248;
  assign select_2248 = equal_2153_s2_q ? patches_column_s2_q[0] : (or_2243 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2249;
  assign not_2249 = ~or_2243;
  // hls/stages/patches.hpp:487
  logic [4:0] sum_2250;
  assign sum_2250 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:489
  logic [4:0] select_2253;
  assign select_2253 = or_2243 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2250) + 5'h1) : sum_2250;
  // hls/stages/patches.hpp:491
  logic [4:0] select_2254;
  assign select_2254 = equal_2153_s2_q ? 5'h0 : select_2253;
  logic or_2255;
  assign or_2255 = equal_2153_s2_q | equal_2151_s2_q;
  // hls/stages/patches.hpp:467
  logic equal_2257;
  assign equal_2257 = patches_column_s2_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s2_q == 5'h11;
  logic equal_2259;
  assign equal_2259 = patches_column_s2_q == 5'h18;
  // hls/stages/patches.hpp:469
  logic and_2261;
  assign and_2261 = of_row & (~equal_2259);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2257 ? 2'h3 : {equal_2259, and_2261};
  // hls/stages/patches.hpp:455
  logic [8:0] sum_2264;
  assign sum_2264 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2265;
  assign sum_2265 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2264, pixel_2[0]} - {1'b0, sum_2265, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:457
  logic [11:0] sum_2267;
  assign sum_2267 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2268;
  assign sum_2268 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2267[11], sum_2267};
  logic [13:0] sum_2269;
  assign sum_2269 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2268, down_2[1]};
  logic [12:0] sum_2270;
  assign sum_2270 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2269[13:1];
  logic [14:0] sum_2271;
  assign sum_2271 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2270, sum_2269[0], down_2[0]};
  // hls/stages/patches.hpp:453
  logic [8:0] sum_2274;
  assign sum_2274 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2275;
  assign sum_2275 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2274};
  logic [10:0] sum_2276;
  assign sum_2276 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2275, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2277;
  assign sum_2277 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2276[10:1];
  // hls/stages/patches.hpp:454
  logic [11:0] smooth;
  assign smooth = {sum_2277, sum_2276[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:456
  logic [12:0] sum_2279;
  assign sum_2279 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2280;
  assign sum_2280 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2281;
  assign difference_2281 = {1'b0, sum_2279, smooth[0]} - {1'b0, sum_2280, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:468
  logic or_2287;
  assign or_2287 = (((patches_column_s2_q == 5'ha) | of_row) | equal_2259) | equal_2257;
  // hls/stages/patches.hpp:463
  logic and_2292;
  assign and_2292 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:176
  logic and_2296;
  assign and_2296 = not_2152_s2_q & (or_2155_s2_q & (or_2287 & (equal_2154_s2_q & and_2292)));
  // hls/stages/patches.hpp:164
  logic and_2306;
  assign and_2306 = (~(equal_2154_s2_q | (~and_2292))) & (~patches_column_s2_q[4]);
  // hls/stages/patches.hpp:176
  logic and_2310;
  assign and_2310 = not_2152_s2_q & (or_2155_s2_q & (and_2306 & (patches_column_s2_q == 5'hf)));
  // hls/stages/patches.hpp:532
  logic less_2312;
  assign less_2312 = patches_step_q[4:0] < 5'h11;
  logic equal_2313;
  assign equal_2313 = patches_step_q[6:5] == 2'h0;
  logic not_2314;
  assign not_2314 = ~equal_2313;
  logic equal_2315;
  assign equal_2315 = patches_step_q[6:5] == 2'h3;
  logic not_2316;
  assign not_2316 = ~equal_2315;
  // hls/stages/patches.hpp:546
  logic select_2319;
  assign select_2319 = equal_2315 ? (less_2312 & (less_2312 & not_2316)) : less_2312;
  // hls/stages/patches.hpp:176
  logic and_2322;
  assign and_2322 = equal_2149_s2_q & (less_2312 ? (not_2314 & select_2319) : select_2319);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2343;
  assign sum_2343 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/agreement.hpp:773
  logic and_2479;
  assign and_2479 = ends_cell_s2_q & (and_2475_s2_q & (~({sum_2021, last_s2_q[1:0]} < x_s2_q)));
  logic not_2842;
  assign not_2842 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2843;
  assign less_2843 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/registration.hpp:76
  logic less_2934;
  assign less_2934 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2936;
  assign select_2936 = or_525_s2_q ? (less_532_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2938;
  assign select_2938 = or_525_s2_q ? (less_532_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2940;
  assign select_2940 = or_525_s2_q ? (less_532_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2938} - {1'b0, select_2940};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2942;
  assign select_2942 = rise[8] ? select_2938 : select_2940;
  logic [8:0] difference_2943;
  assign difference_2943 = {1'b0, select_2936} - {1'b0, select_2942};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2943[8] ? 8'h0 : difference_2943[7:0];
  // hls/stages/registration.hpp:37
  logic not_2945;
  assign not_2945 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2934 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2945};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2947;
  assign xor_2947 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2947};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2953;
  assign select_2953 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2934 ? {taken, 1'b1} : {not_2945, select_2953, not_2945};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2955;
  assign sum_2955 = {left, 1'b1} + {taken_2, less_2934};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2957;
  assign select_2957 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_3040;
  assign select_3040 = and_3039_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3042;
  assign select_3042 = and_3037_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3040[15]}}, select_3040});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3043;
  assign select_3043 = and_3039_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3043[15]}}, select_3043};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3045;
  assign select_3045 = and_3037_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_3046;
  assign and_3046 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_8;
  assign column_8 = registration_slope_q + (and_3046 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:83
  logic parity_3189;
  assign parity_3189 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:448
  logic [15:0] select_3190;
  assign select_3190 = equal_2745_s2_q ? {patches_chance_q[14:0], parity_3189} : patches_chance_q;
  // hls/stages/patches.hpp:100
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:101
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:102
  logic [5:0] select_3195;
  assign select_3195 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3195};
  // hls/stages/agreement.hpp:773
  logic and_3201;
  assign and_3201 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:179
  logic select_3292;
  assign select_3292 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:176
  logic [11:0] select_3295;
  assign select_3295 = equal_2151_s2_q ? patches_smooth_values_0_q : (or_2155_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3297;
  assign select_3297 = or_2155_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3299;
  assign select_3299 = equal_2149_s2_q ? patches_smooth_values_1_q : (equal_2151_s2_q ? patches_smooth_values_1_q : select_3297);
  logic [11:0] select_3300;
  assign select_3300 = or_2155_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3302;
  assign select_3302 = equal_2149_s2_q ? patches_smooth_values_2_q : (equal_2151_s2_q ? patches_smooth_values_2_q : select_3300);
  logic [11:0] select_3303;
  assign select_3303 = or_2155_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3305;
  assign select_3305 = equal_2149_s2_q ? patches_smooth_values_3_q : (equal_2151_s2_q ? patches_smooth_values_3_q : select_3303);
  logic [10:0] select_3307;
  assign select_3307 = equal_2151_s2_q ? patches_down_values_0_q : (or_2155_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3310;
  assign select_3310 = equal_2151_s2_q ? patches_down_values_1_q : (or_2155_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3313;
  assign select_3313 = equal_2151_s2_q ? patches_down_values_2_q : (or_2155_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3316;
  assign select_3316 = equal_2151_s2_q ? patches_down_values_3_q : (or_2155_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:167
  logic and_3353;
  assign and_3353 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:403
  logic [4:0] select_3358;
  assign select_3358 = or_3253_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:405
  logic [3:0] select_3360;
  assign select_3360 = and_3353 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:176
  logic [4:0] select_3716;
  assign select_3716 = equal_2149_s2_q ? patches_summed_down_by_q : (equal_2151_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:542
  logic and_3749;
  assign and_3749 = less_2312 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:546
  logic select_3752;
  assign select_3752 = equal_2315 ? (less_2312 ? (not_2316 & and_3749) : and_3749) : and_3749;
  // hls/stages/patches.hpp:176
  logic select_3755;
  assign select_3755 = equal_2149_s2_q ? (less_2312 ? (not_2314 & select_3752) : select_3752) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_4071;
  assign select_4071 = so_s2_q ? (and_3046 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4073;
  assign sum_4073 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4074;
  assign select_4074 = sum_2343[5] ? {1'b1, sum_2343[4:0], region_across_rest_q[2:0]} : sum_4073;
  // hls/stages/agreement.hpp:448
  logic [8:0] select_4076;
  assign select_4076 = equal_2745_s2_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4079;
  assign select_4079 = equal_2745_s2_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_474_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_479;
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
  assign census_memory_re = s2_en & and_504_s2_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1310; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1971;
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
  assign patches_right_codes_raddr = {select_2254, not_2249, select_2248};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & or_2255;
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
  assign patches_left_codes_re = s2_en & (not_2150_s2_q & (new_row & equal_2151_s2_q));
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
  assign patches_rows_re = s2_en & and_2322;
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1337; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1971;
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
  assign best_left_we = s2_en & and_1918_s2_q;
  logic [45:0] best_left_wdata;
  assign best_left_wdata = {select_1917, select_1916, select_1889, select_1886, select_1878, select_1877, select_1873};
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
  assign best_right_we = s2_en & and_1918_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_1935, select_1934, select_1931, select_1930};
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
  assign patches_columns_above_we = s2_en & and_2236_s2_q;
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
      shift_allowed_q <= not_2842 & (~less_2843);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s2_q ? sum_2955[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2957;
      registration_slope_row_q <= select_3042;
      registration_slope_change_q <= select_3045;
      registration_slope_q <= so_s2_q ? column_8 : {registration_slope_row_q, 4'h0};
      patches_chance_q <= and_504_s2_q ? select_3190 : patches_chance_q;
      patches_along_ends_q <= not_3277_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3277_s2_q & select_3292;
      patches_smooth_values_0_q <= equal_2149_s2_q ? patches_smooth_values_0_q : select_3295;
      patches_smooth_values_1_q <= select_3299;
      patches_smooth_values_2_q <= select_3302;
      patches_smooth_values_3_q <= select_3305;
      patches_down_values_0_q <= equal_2149_s2_q ? patches_down_values_0_q : select_3307;
      patches_down_values_1_q <= equal_2149_s2_q ? patches_down_values_1_q : select_3310;
      patches_down_values_2_q <= equal_2149_s2_q ? patches_down_values_2_q : select_3313;
      patches_down_values_3_q <= equal_2149_s2_q ? patches_down_values_3_q : select_3316;
      patches_down_by_q <= or_3253_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3353});
      patches_along_q <= select_3358;
      patches_match_row_q <= or_3253_s2_q ? 4'h0 : select_3360;
      patches_summed_last_q <= not_2150_s2_q & (equal_2151_s2_q & and_3353);
      patches_summed_down_by_q <= select_3716;
      patches_step_q <= or_3253_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3755;
      region_across_rest_q <= select_4071;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4074;
      columns_begin_rest_q <= and_504_s2_q ? select_4076 : columns_begin_rest_q;
      columns_begin_back_q <= and_504_s2_q ? select_4079 : columns_begin_back_q;
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
  logic [2:0] select_468_s3_q;
  logic [6:0] select_470_s3_q;
  logic [8:0] select_474_s3_q;
  logic and_478_s3_q;
  logic and_479_s3_q;
  logic equal_484_s3_q;
  logic [6:0] column_s3_q;
  logic and_502_s3_q;
  logic and_504_s3_q;
  logic so_s3_q;
  logic equal_565_s3_q;
  logic equal_1936_s3_q;
  logic not_1937_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1971_s3_q;
  logic [6:0] select_1975_s3_q;
  logic and_1980_s3_q;
  logic right_2_s3_q;
  logic and_2049_s3_q;
  logic and_2062_s3_q;
  logic and_2075_s3_q;
  logic less_2076_s3_q;
  logic [7:0] change_s3_q;
  logic equal_2103_s3_q;
  logic and_2115_s3_q;
  logic equal_2142_s3_q;
  logic and_2147_s3_q;
  logic and_2148_s3_q;
  logic equal_2149_s3_q;
  logic equal_2151_s3_q;
  logic equal_2154_s3_q;
  logic or_2155_s3_q;
  logic [4:0] select_2179_s3_q;
  logic select_2185_s3_q;
  logic [3:0] select_2226_s3_q;
  logic less_2242_s3_q;
  logic new_row_s3_q;
  logic or_2255_s3_q;
  logic [1:0] of_row_2_s3_q;
  logic less_2272_s3_q;
  logic less_2273_s3_q;
  logic less_2282_s3_q;
  logic less_2283_s3_q;
  logic and_2297_s3_q;
  logic and_2306_s3_q;
  logic and_2311_s3_q;
  logic less_2312_s3_q;
  logic equal_2313_s3_q;
  logic not_2314_s3_q;
  logic equal_2315_s3_q;
  logic not_2316_s3_q;
  logic sum_2343_s3_q;
  logic textured_s3_q;
  logic and_2481_s3_q;
  logic equal_2621_s3_q;
  logic equal_2745_s3_q;
  logic less_2971_s3_q;
  logic and_3202_s3_q;
  logic less_3329_s3_q;
  logic equal_3672_s3_q;
  logic equal_3756_s3_q;
  logic less_4059_s3_q;
  logic equal_4264_s3_q;
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
      select_468_s3_q <= select_468_s2_q;
      select_470_s3_q <= select_470_s2_q;
      select_474_s3_q <= select_474_s2_q;
      and_478_s3_q <= and_478_s2_q;
      and_479_s3_q <= and_479;
      equal_484_s3_q <= equal_484_s2_q;
      column_s3_q <= column_s2_q;
      and_502_s3_q <= and_502_s2_q;
      and_504_s3_q <= and_504_s2_q;
      so_s3_q <= so_s2_q;
      equal_565_s3_q <= equal_565_s2_q;
      equal_1936_s3_q <= equal_1936_s2_q;
      not_1937_s3_q <= not_1937;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1971_s3_q <= and_1971;
      select_1975_s3_q <= select_1975_s2_q;
      and_1980_s3_q <= not_1937 & (so_s2_q ? and_1969 : (equal_524_s2_q & shift_2[4]));
      right_2_s3_q <= right_2;
      and_2049_s3_q <= and_2049_s2_q;
      and_2062_s3_q <= and_2062_s2_q;
      and_2075_s3_q <= not_1937 & (so_s2_q & (ends_cell_s2_q & (shift_2[0] & right_3)));
      less_2076_s3_q <= less_2076_s2_q;
      change_s3_q <= change;
      equal_2103_s3_q <= equal_2103;
      and_2115_s3_q <= and_2115;
      equal_2142_s3_q <= equal_2142;
      and_2147_s3_q <= and_2147;
      and_2148_s3_q <= patches_chooses_s2_q & and_2147;
      equal_2149_s3_q <= equal_2149_s2_q;
      equal_2151_s3_q <= equal_2151_s2_q;
      equal_2154_s3_q <= equal_2154_s2_q;
      or_2155_s3_q <= or_2155_s2_q;
      select_2179_s3_q <= select_2179_s2_q;
      select_2185_s3_q <= select_2185_s2_q;
      select_2226_s3_q <= select_2226_s2_q;
      less_2242_s3_q <= less_2242;
      new_row_s3_q <= new_row;
      or_2255_s3_q <= or_2255;
      of_row_2_s3_q <= of_row_2;
      less_2272_s3_q <= $signed(15'h100) < $signed(sum_2271);
      less_2273_s3_q <= $signed(sum_2271[14:8]) < $signed(7'h7f);
      less_2282_s3_q <= $signed(15'h100) < $signed(difference_2281);
      less_2283_s3_q <= $signed(difference_2281[14:8]) < $signed(7'h7f);
      and_2297_s3_q <= not_2150_s2_q & and_2296;
      and_2306_s3_q <= and_2306;
      and_2311_s3_q <= not_2150_s2_q & and_2310;
      less_2312_s3_q <= less_2312;
      equal_2313_s3_q <= equal_2313;
      not_2314_s3_q <= not_2314;
      equal_2315_s3_q <= equal_2315;
      not_2316_s3_q <= not_2316;
      sum_2343_s3_q <= sum_2343[5];
      textured_s3_q <= textured;
      and_2481_s3_q <= not_1937 & (so_s2_q & and_2479);
      equal_2621_s3_q <= equal_2621_s2_q;
      equal_2745_s3_q <= equal_2745_s2_q;
      less_2971_s3_q <= select_2938 < select_2940;
      and_3202_s3_q <= not_1937 & and_3201;
      less_3329_s3_q <= 4'he < patches_column_s2_q[4:1];
      equal_3672_s3_q <= patches_match_row_q == 4'h0;
      equal_3756_s3_q <= patches_step_q[6:5] == 2'h2;
      less_4059_s3_q <= less_4059_s2_q;
      equal_4264_s3_q <= equal_4264_s2_q;
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
  logic [11:0] select_482;
  assign select_482 = select_468_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_486;
  assign sum_486 = select_482 + (equal_484_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_488;
  assign sum_488 = {4'h0, sample_pair_pixel_1_q} + (select_468_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_490;
  assign sum_490 = sum_488 + (equal_484_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:405
  logic whole;
  assign whole = select_468_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_494;
  assign and_494 = whole & (averager_memory_rdata_q[24] | equal_484_s3_q);
  // hls/stages/agreement.hpp:405
  logic all_of_skin;
  assign all_of_skin = select_468_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_498;
  assign and_498 = all_of_skin & (averager_memory_rdata_q[25] | equal_484_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_478_s3_q ? sum_486[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_507;
  assign equal_507 = select_468_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_507 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:264
  logic [8:0] select_510;
  assign select_510 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_478_s3_q ? sum_490[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_507 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:264
  logic [8:0] select_514;
  assign select_514 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_515;
  assign and_515 = and_478_s3_q & and_494;
  // hls/stages/census.hpp:126
  logic select_517;
  assign select_517 = equal_507 ? and_515 : (averager_mask_q & and_515);
  // hls/stages/agreement.hpp:264
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_517;
  // hls/stages/census.hpp:206
  logic and_519;
  assign and_519 = and_478_s3_q & and_498;
  // hls/stages/census.hpp:126
  logic select_521;
  assign select_521 = equal_507 ? and_519 : (averager_of_skin_q & and_519);
  // hls/stages/agreement.hpp:264
  logic and_522;
  assign and_522 = sample_pair_whole_s3_q & select_521;
  // hls/stages/census.hpp:294
  logic less_538;
  assign less_538 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_539;
  assign less_539 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_540;
  assign less_540 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_541;
  assign less_541 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_542;
  assign less_542 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_543;
  assign less_543 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_544;
  assign less_544 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_545;
  assign less_545 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_546;
  assign less_546 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_547;
  assign less_547 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_548;
  assign less_548 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_549;
  assign less_549 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_550;
  assign less_550 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_551;
  assign less_551 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_552;
  assign less_552 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_553;
  assign less_553 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_554;
  assign less_554 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_555;
  assign less_555 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_556;
  assign less_556 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_557;
  assign less_557 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_558;
  assign less_558 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_559;
  assign less_559 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_560;
  assign less_560 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_561;
  assign less_561 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:443
  logic equal_562;
  assign equal_562 = column_s3_q == 7'h0;
  logic [3:0] select_566;
  assign select_566 = equal_565_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:444
  logic [4:0] select_567;
  assign select_567 = equal_562 ? {select_566, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_568;
  assign select_568 = equal_562 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_569;
  assign and_569 = select_567[4] & select_568[3];
  // hls/stages/census.hpp:286
  logic and_571;
  assign and_571 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_573;
  assign and_573 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_571);
  // hls/stages/agreement.hpp:444
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_573;
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
  logic [9:0] difference_596;
  assign difference_596 = {1'b0, select_510} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_597;
  assign xor_597 = difference_596[8:0] ^ {9{difference_596[9]}};
  logic [9:0] sum_598;
  assign sum_598 = {9'h0, difference_596[9]} + {1'b0, xor_597};
  logic [9:0] difference_599;
  assign difference_599 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_600;
  assign xor_600 = difference_599[8:0] ^ {9{difference_599[9]}};
  logic [9:0] sum_601;
  assign sum_601 = {9'h0, difference_599[9]} + {1'b0, xor_600};
  logic [9:0] difference_603;
  assign difference_603 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_604;
  assign xor_604 = difference_603[8:0] ^ {9{difference_603[9]}};
  logic [9:0] sum_605;
  assign sum_605 = {9'h0, difference_603[9]} + {1'b0, xor_604};
  logic [10:0] sum_606;
  assign sum_606 = ({1'b0, sum_598} + {1'b0, sum_601}) + {1'b0, sum_605};
  logic [9:0] difference_607;
  assign difference_607 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_608;
  assign xor_608 = difference_607[8:0] ^ {9{difference_607[9]}};
  logic [9:0] sum_609;
  assign sum_609 = {9'h0, difference_607[9]} + {1'b0, xor_608};
  logic [9:0] difference_611;
  assign difference_611 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_612;
  assign xor_612 = difference_611[8:0] ^ {9{difference_611[9]}};
  // hls/stages/agreement.hpp:193
  logic not_1976;
  assign not_1976 = ~so_s3_q;
  // hls/stages/agreement.hpp:773
  logic and_1977;
  assign and_1977 = not_1976 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1080
  logic equal_1981;
  assign equal_1981 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1126
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1081
  logic [1:0] select_1984;
  assign select_1984 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1094
  logic [3:0] select_1986;
  assign select_1986 = equal_1981 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1984});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1987;
  assign sum_1987 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:773
  logic [3:0] select_1988;
  assign select_1988 = equal_1936_s3_q ? select_1986 : {sum_1987, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:201
  logic equal_1989;
  assign equal_1989 = x_s3_q[5:0] == 6'h3f;
  logic equal_1991;
  assign equal_1991 = x_s3_q[5:0] == 6'h3e;
  logic equal_1993;
  assign equal_1993 = x_s3_q[5:0] == 6'h3d;
  logic equal_1995;
  assign equal_1995 = x_s3_q[5:0] == 6'h3c;
  logic equal_1997;
  assign equal_1997 = x_s3_q[5:0] == 6'h3b;
  logic equal_1999;
  assign equal_1999 = x_s3_q[5:0] == 6'h36;
  logic equal_2001;
  assign equal_2001 = x_s3_q[5:0] == 6'h35;
  logic equal_2003;
  assign equal_2003 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1126
  logic and_2007;
  assign and_2007 = (~equal_1997) & ((~equal_1999) & ((~equal_2001) & (~equal_2003)));
  logic and_2011;
  assign and_2011 = (~equal_1989) & ((~equal_1991) & ((~equal_1993) & ((~equal_1995) & and_2007)));
  // hls/stages/agreement.hpp:1081
  logic less_2012;
  assign less_2012 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2016;
  assign or_2016 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2027;
  assign sum_2027 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_2029;
  assign and_2029 = half_ends & ({{3{sum_2027[4]}}, sum_2027} < 8'h3);
  // hls/stages/agreement.hpp:773
  logic and_2030;
  assign and_2030 = so_s3_q & and_2029;
  logic select_2031;
  assign select_2031 = equal_1936_s3_q ? (x_s3_q[6] & (equal_1981 ? and_2011 : (less_2012 & (~or_2016)))) : and_2030;
  // hls/stages/registration.hpp:258
  logic not_2033;
  assign not_2033 = ~lower_half_s3_q;
  logic [3:0] select_2034;
  assign select_2034 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_2033, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_2033};
  // hls/stages/patches.hpp:363
  logic [1:0] select_2063;
  assign select_2063 = and_2062_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2064;
  assign select_2064 = and_2062_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:264
  logic [5:0] select_2065;
  assign select_2065 = and_2049_s3_q ? {select_2064, select_2063[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:118
  logic [1:0] select_2066;
  assign select_2066 = and_2049_s3_q ? select_2063 : patches_fetch_q;
  logic equal_2067;
  assign equal_2067 = select_2066 == 2'h0;
  // hls/stages/registration.hpp:83
  logic equal_2077;
  assign equal_2077 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2077 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2083;
  assign select_2083 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2084;
  assign select_2084 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2085;
  assign sum_2085 = {{2{select_2083[6]}}, select_2083} + {select_2084[7], select_2084};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2086;
  assign select_2086 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2087;
  assign select_2087 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2088;
  assign sum_2088 = {{2{select_2086[7]}}, select_2086[7:1]} + {select_2087[7], select_2087};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2089;
  assign sum_2089 = {{3{sum_2085[8]}}, sum_2085[8:1]} + {sum_2088[8], sum_2088, select_2086[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2090;
  assign select_2090 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2091;
  assign select_2091 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2092;
  assign difference_2092 = {{2{select_2090[7]}}, select_2090[7:1]} - {select_2091[7], select_2091};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2093;
  assign sum_2093 = {difference_2092, select_2090[0]} + {sum_2089[10], sum_2089[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2077 ? {sum_2093, sum_2089[1]} : registration_expected_q;
  // hls/stages/patches.hpp:90
  logic [9:0] sum_2095;
  assign sum_2095 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:974
  logic and_2097;
  assign and_2097 = shift_2_s3_q[3] & ({{4{sum_2095[9]}}, sum_2095, expected[1:0]} < 16'h29);
  // hls/stages/agreement.hpp:773
  logic and_2118;
  assign and_2118 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_2076_s3_q & and_2097) & and_2115_s3_q));
  logic and_2120;
  assign and_2120 = not_1937_s3_q & (so_s3_q & and_2118);
  // hls/stages/patches.hpp:148
  logic and_2122;
  assign and_2122 = and_2120 & (~patches_fixed_q);
  // hls/stages/agreement.hpp:773
  logic [7:0] select_2125;
  assign select_2125 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2126;
  assign select_2126 = equal_1936_s3_q ? 8'h0 : select_2125;
  logic [5:0] select_2128;
  assign select_2128 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_2130;
  assign select_2130 = equal_1936_s3_q ? 6'h0 : (so_s3_q ? select_2128 : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2131;
  assign sum_2131 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_2093[9]}}, sum_2093[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2134;
  assign select_2134 = ($signed(sum_2131[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2131[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2077 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2131[12:7])) ? 8'h7f : select_2134);
  // hls/stages/agreement.hpp:773
  logic [7:0] select_2139;
  assign select_2139 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2140;
  assign select_2140 = equal_1936_s3_q ? 8'h0 : select_2139;
  // hls/stages/patches.hpp:333
  logic [22:0] select_2141;
  assign select_2141 = and_2122 ? {select_2140, select_2130, select_2126, and_2120} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:118
  logic [4:0] select_2162;
  assign select_2162 = and_2049_s3_q ? select_2064 : patches_band_q;
  // hls/stages/patches.hpp:343
  logic equal_2163;
  assign equal_2163 = {patches_choosing_band_s3_q, and_2075_s3_q} == {select_2162, select_2066[1]};
  // hls/stages/patches.hpp:472
  logic [2:0] sum_2263;
  assign sum_2263 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:476
  logic [1:0] sum_2301;
  assign sum_2301 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_2330;
  assign select_2330 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1002
  logic or_2333;
  assign or_2333 = select_2330[7] | (~({select_2330[5], select_2330[3], select_2330[1]} == 3'h0));
  // hls/stages/agreement.hpp:1001
  logic or_2336;
  assign or_2336 = select_2330[7] | (~({select_2330[6], select_2330[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1000
  logic or_2339;
  assign or_2339 = select_2330[7] | (~(select_2330[6:4] == 3'h0));
  // hls/stages/agreement.hpp:773
  logic [5:0] select_2340;
  assign select_2340 = equal_1936_s3_q ? x_s3_q[5:0] : {region_row_q, or_2339, or_2336, or_2333};
  // hls/stages/agreement.hpp:1080
  logic not_2341;
  assign not_2341 = ~equal_1981;
  // hls/stages/agreement.hpp:1010
  logic or_2345;
  assign or_2345 = (~sum_2343_s3_q) | equal_2142_s3_q;
  // hls/stages/agreement.hpp:773
  logic and_2348;
  assign and_2348 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_2345));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_2369;
  assign and_2369 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:970
  logic select_2370;
  assign select_2370 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_2370);
  // hls/stages/agreement.hpp:970
  logic select_2373;
  assign select_2373 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_2370 ? select_2373 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1212
  logic or_2376;
  assign or_2376 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1214
  logic [16:0] select_2378;
  assign select_2378 = marks_first_s3_q ? 17'h1 : (or_2376 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1213
  logic [8:0] select_2380;
  assign select_2380 = or_2376 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1221
  logic select_2382;
  assign select_2382 = cfg_compete_i ? (or_2376 & select_2378[16]) : (select_2380[8] & select_2378[9]);
  // hls/stages/agreement.hpp:423
  logic next_row;
  assign next_row = select_2382 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1228
  logic [6:0] select_2385;
  assign select_2385 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2387;
  assign select_2387 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_2385});
  // hls/stages/agreement.hpp:1238
  logic equal_2388;
  assign equal_2388 = seen_x_q == 3'h7;
  logic [7:0] select_2390;
  assign select_2390 = select_2382 ? 8'h0 : (seen_column_q + {7'h0, equal_2388});
  // hls/stages/agreement.hpp:1245
  logic [12:0] index;
  assign index = select_2387 + {5'h0, select_2390};
  // hls/stages/agreement.hpp:1212
  logic select_2393;
  assign select_2393 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1198
  logic [7:0] sum_2394;
  assign sum_2394 = {1'b0, select_2393, 2'h0, select_2393, 1'b0, {2{select_2393}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1211
  logic not_2395;
  assign not_2395 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:423
  logic and_2397;
  assign and_2397 = not_2395 & (began_q | select_2382);
  // hls/stages/agreement.hpp:1239
  logic [2:0] select_2399;
  assign select_2399 = select_2382 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1244
  logic and_2401;
  assign and_2401 = and_2397 & (select_2399 == 3'h0);
  logic less_2402;
  assign less_2402 = select_2390 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1063
  logic [7:0] sum_2405;
  assign sum_2405 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2405[7]}}, sum_2405, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1198
  logic [7:0] sum_2407;
  assign sum_2407 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:986
  logic and_2408;
  assign and_2408 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_2409;
  assign and_2409 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_2410;
  assign and_2410 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_2411;
  assign and_2411 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1039
  logic [1:0] sum_2413;
  assign sum_2413 = {1'b0, and_2410} + ({1'b0, textured_s3_q} + {1'b0, and_2411});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2408} + ({2'h0, and_2409} + {1'b0, sum_2413});
  // hls/stages/agreement.hpp:1046
  logic [2:0] select_2416;
  assign select_2416 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2417;
  assign difference_2417 = {1'b0, textured_2} - {1'b0, select_2416};
  logic [4:0] t;
  assign t = {difference_2417[3], difference_2417} + (equal_2103_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:986
  logic [7:0] select_2422;
  assign select_2422 = shift_2_s3_q[0] ? (sum_2343_s3_q ? select_2330 : {select_2330[6:0], 1'b0}) : select_2330;
  // hls/stages/agreement.hpp:1002
  logic or_2425;
  assign or_2425 = select_2422[7] | (~({select_2422[5], select_2422[3], select_2422[1]} == 3'h0));
  // hls/stages/agreement.hpp:986
  logic and_2442;
  assign and_2442 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_2443;
  assign and_2443 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_2444;
  assign and_2444 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_2445;
  assign and_2445 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1041
  logic [1:0] sum_2447;
  assign sum_2447 = {1'b0, and_2444} + ({1'b0, shown} + {1'b0, and_2445});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2442} + ({2'h0, and_2443} + {1'b0, sum_2447});
  // hls/stages/agreement.hpp:1048
  logic [2:0] select_2450;
  assign select_2450 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2451;
  assign difference_2451 = {1'b0, shown_2} - {1'b0, select_2450};
  logic [4:0] around;
  assign around = {difference_2451[3], difference_2451} + (equal_2103_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1055
  logic [5:0] sum_2454;
  assign sum_2454 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:986
  logic and_2458;
  assign and_2458 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2459;
  assign and_2459 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2460;
  assign and_2460 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2461;
  assign and_2461 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1042
  logic [1:0] sum_2463;
  assign sum_2463 = {1'b0, and_2460} + ({1'b0, near} + {1'b0, and_2461});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2458} + ({2'h0, and_2459} + {1'b0, sum_2463});
  // hls/stages/agreement.hpp:1049
  logic [2:0] select_2466;
  assign select_2466 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2467;
  assign difference_2467 = {1'b0, near_2} - {1'b0, select_2466};
  logic [4:0] n;
  assign n = {difference_2467[3], difference_2467} + (equal_2103_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:264
  logic [10:0] select_2513;
  assign select_2513 = sample_pair_whole_s3_q ? (and_502_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2515;
  assign select_2515 = sample_pair_whole_s3_q ? (and_502_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2534;
  assign select_2534 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2536;
  assign select_2536 = sample_pair_whole_s3_q ? (and_502_s3_q ? select_517 : averager_mask_q) : averager_mask_q;
  logic select_2538;
  assign select_2538 = sample_pair_whole_s3_q ? (and_502_s3_q ? select_521 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:508
  logic [8:0] select_2539;
  assign select_2539 = and_504_s3_q ? select_510 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2540;
  assign select_2540 = and_504_s3_q ? select_514 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2542;
  assign select_2542 = and_504_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2543;
  assign select_2543 = and_504_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2544;
  assign select_2544 = and_504_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2545;
  assign select_2545 = and_504_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2546;
  assign select_2546 = and_504_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2547;
  assign select_2547 = and_504_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2548;
  assign select_2548 = and_504_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2549;
  assign select_2549 = and_504_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2550;
  assign select_2550 = and_504_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2551;
  assign select_2551 = and_504_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2552;
  assign select_2552 = and_504_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2553;
  assign select_2553 = and_504_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2554;
  assign select_2554 = and_504_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2555;
  assign select_2555 = and_504_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2556;
  assign select_2556 = and_504_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2557;
  assign select_2557 = and_504_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2558;
  assign select_2558 = and_504_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2559;
  assign select_2559 = and_504_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2560;
  assign select_2560 = and_504_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2561;
  assign select_2561 = and_504_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2562;
  assign select_2562 = and_504_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2563;
  assign select_2563 = and_504_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2564;
  assign select_2564 = and_504_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2565;
  assign select_2565 = and_504_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2566;
  assign select_2566 = and_504_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2567;
  assign select_2567 = and_504_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2568;
  assign select_2568 = and_504_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2569;
  assign select_2569 = and_504_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2570;
  assign select_2570 = and_504_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2571;
  assign select_2571 = and_504_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2572;
  assign select_2572 = and_504_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2573;
  assign select_2573 = and_504_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2574;
  assign select_2574 = and_504_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2575;
  assign select_2575 = and_504_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2576;
  assign select_2576 = and_504_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2577;
  assign select_2577 = and_504_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2578;
  assign select_2578 = and_504_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2579;
  assign select_2579 = and_504_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2580;
  assign select_2580 = and_504_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2581;
  assign select_2581 = and_504_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2582;
  assign select_2582 = and_504_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2583;
  assign select_2583 = and_504_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2584;
  assign select_2584 = and_504_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2585;
  assign select_2585 = and_504_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2586;
  assign select_2586 = and_504_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2587;
  assign select_2587 = and_504_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2588;
  assign select_2588 = and_504_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2589;
  assign select_2589 = and_504_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2590;
  assign select_2590 = and_504_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2591;
  assign select_2591 = and_504_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2592;
  assign select_2592 = and_504_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2593;
  assign select_2593 = and_504_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2594;
  assign select_2594 = and_504_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2596;
  assign difference_2596 = {1'b0, select_514} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2597;
  assign xor_2597 = difference_2596[8:0] ^ {9{difference_2596[9]}};
  logic [9:0] sum_2598;
  assign sum_2598 = {9'h0, difference_2596[9]} + {1'b0, xor_2597};
  logic [9:0] difference_2599;
  assign difference_2599 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2600;
  assign xor_2600 = difference_2599[8:0] ^ {9{difference_2599[9]}};
  logic [9:0] sum_2601;
  assign sum_2601 = {9'h0, difference_2599[9]} + {1'b0, xor_2600};
  logic [9:0] difference_2603;
  assign difference_2603 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2604;
  assign xor_2604 = difference_2603[8:0] ^ {9{difference_2603[9]}};
  logic [9:0] sum_2605;
  assign sum_2605 = {9'h0, difference_2603[9]} + {1'b0, xor_2604};
  logic [10:0] sum_2606;
  assign sum_2606 = ({1'b0, sum_2598} + {1'b0, sum_2601}) + {1'b0, sum_2605};
  logic [9:0] difference_2607;
  assign difference_2607 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2608;
  assign xor_2608 = difference_2607[8:0] ^ {9{difference_2607[9]}};
  logic [9:0] sum_2609;
  assign sum_2609 = {9'h0, difference_2607[9]} + {1'b0, xor_2608};
  logic [9:0] difference_2611;
  assign difference_2611 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2612;
  assign xor_2612 = difference_2611[8:0] ^ {9{difference_2611[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2642;
  assign difference_2642 = {1'b0, select_510} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2642[9]} + (difference_2642[8:0] ^ {9{difference_2642[9]}});
  logic [9:0] difference_2654;
  assign difference_2654 = {1'b0, select_514} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2654[9]} + (difference_2654[8:0] ^ {9{difference_2654[9]}});
  // hls/stages/agreement.hpp:508
  logic and_2850;
  assign and_2850 = and_504_s3_q & (equal_565_s3_q & equal_2745_s3_q);
  // hls/stages/agreement.hpp:773
  logic and_2854;
  assign and_2854 = not_1937_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:986
  logic and_2874;
  assign and_2874 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2875;
  assign and_2875 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2876;
  assign and_2876 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2877;
  assign and_2877 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1040
  logic [1:0] sum_2879;
  assign sum_2879 = {1'b0, and_2876} + ({1'b0, explained} + {1'b0, and_2877});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2874} + ({2'h0, and_2875} + {1'b0, sum_2879});
  // hls/stages/agreement.hpp:1047
  logic [2:0] select_2882;
  assign select_2882 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2883;
  assign difference_2883 = {1'b0, explained_2} - {1'b0, select_2882};
  logic [4:0] e;
  assign e = {difference_2883[3], difference_2883} + (equal_2103_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1054
  logic [5:0] sum_2886;
  assign sum_2886 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:773
  logic and_2915;
  assign and_2915 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2959;
  assign select_2959 = equal_1936_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2961;
  assign select_2961 = equal_1936_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2962;
  assign equal_2962 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:250
  logic and_2966;
  assign and_2966 = shift_2_s3_q[3] & less_2076_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2970;
  assign sum_2970 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2972;
  assign difference_2972 = {sum_2970, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2973;
  assign select_2973 = less_2971_s3_q ? difference_2972 : {sum_2970, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2974;
  assign select_2974 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2970, shift_2_s3_q[11], 5'h0} : select_2973;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2974[7]}}, select_2974} - {sum_2093[9], sum_2093, sum_2089[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2977;
  assign select_2977 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2977[11:7])) ? 12'h7f : select_2977;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2998;
  assign difference_2998 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3000;
  assign and_3000 = and_2966 & ($signed(difference_2998) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3013;
  assign less_3013 = $signed(difference_2998) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:773
  logic select_3021;
  assign select_3021 = so_s3_q ? (equal_2962 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_3024;
  assign select_3024 = so_s3_q ? (equal_2077 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3029;
  assign select_3029 = (sum_1987 == 2'h2) ? (registration_fresh_q & (~select_2034)) : registration_fresh_q;
  // hls/stages/agreement.hpp:773
  logic [3:0] select_3031;
  assign select_3031 = so_s3_q ? (and_2029 ? select_3029 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3033;
  assign select_3033 = and_2850 ? 4'hf : (equal_1936_s3_q ? registration_fresh_q : select_3031);
  // hls/stages/agreement.hpp:1081
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1984;
  // hls/stages/registration.hpp:258
  logic not_3054;
  assign not_3054 = ~quarter_2[1];
  logic [3:0] select_3055;
  assign select_3055 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3054, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3054};
  // hls/stages/patches.hpp:335
  logic not_3192;
  assign not_3192 = ~and_2147_s3_q;
  // hls/stages/patches.hpp:344
  logic not_3218;
  assign not_3218 = ~select_2066[1];
  // hls/stages/agreement.hpp:264
  logic [1:0] select_3220;
  assign select_3220 = sample_pair_whole_s3_q ? (equal_2067 ? select_2066 : {not_3218, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:508
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:176
  logic [51:0] select_3319;
  assign select_3319 = or_2155_s3_q ? {less_2283_s3_q, less_2282_s3_q, less_2273_s3_q, less_2272_s3_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3321;
  assign select_3321 = equal_2149_s3_q ? patches_codes_at_q : (equal_2151_s3_q ? other[55:4] : select_3319);
  // hls/stages/patches.hpp:491
  logic [27:0] word;
  assign word = or_2255_s3_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:507
  logic [27:0] select_3324;
  assign select_3324 = (patches_along_s3_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:176
  logic [27:0] select_3326;
  assign select_3326 = equal_2151_s3_q ? (new_row_s3_q ? word : select_3324) : patches_codes_further_q;
  // hls/stages/patches.hpp:509
  logic [55:0] select_3328;
  assign select_3328 = less_2242_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:479
  logic [55:0] select_3330;
  assign select_3330 = less_3329_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:176
  logic [55:0] select_3332;
  assign select_3332 = or_2155_s3_q ? (equal_2154_s3_q ? patches_next_codes_q : select_3330) : patches_next_codes_q;
  logic [55:0] select_3334;
  assign select_3334 = equal_2149_s3_q ? patches_next_codes_q : (equal_2151_s3_q ? select_3328 : select_3332);
  // hls/stages/count_bits.hpp:24
  logic parity_3339;
  assign parity_3339 = ^{less_2283_s3_q, less_2282_s3_q, less_2273_s3_q, less_2272_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_3343;
  assign or_3343 = ({less_2273_s3_q, less_2272_s3_q} == 2'h3) | (less_2282_s3_q & (less_2273_s3_q | less_2272_s3_q));
  logic and_3344;
  assign and_3344 = less_2283_s3_q & (^{less_2282_s3_q, less_2273_s3_q, less_2272_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3345;
  assign xor_3345 = or_3343 ^ and_3344;
  // hls/stages/count_bits.hpp:27
  logic and_3346;
  assign and_3346 = or_3343 & and_3344;
  // hls/stages/patches.hpp:176
  logic [2:0] select_3348;
  assign select_3348 = or_2155_s3_q ? (and_2306_s3_q ? {and_3346, xor_3345, parity_3339} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:159
  logic [9:0] sum_3352;
  assign sum_3352 = {7'h0, patches_set_q} + (equal_2154_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:508
  logic [47:0] select_3362;
  assign select_3362 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:176
  logic [47:0] select_3364;
  assign select_3364 = equal_2149_s3_q ? patches_left_row_q : (equal_2151_s3_q ? select_3362 : patches_left_row_q);
  // hls/stages/patches.hpp:510
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3362;
  // hls/stages/count_bits.hpp:24
  logic xor_3368;
  assign xor_3368 = bits[17] ^ (^{select_3362[16:15], other[16:15]});
  logic xor_3371;
  assign xor_3371 = bits[11] ^ (^{select_3362[10:9], other[10:9]});
  logic xor_3374;
  assign xor_3374 = bits[14] ^ (^{select_3362[13:12], other[13:12]});
  logic xor_3377;
  assign xor_3377 = xor_3368 ^ (^{select_3362[14:9], other[14:9]});
  logic xor_3380;
  assign xor_3380 = bits[47] ^ (^{select_3362[46:45], other[46:45]});
  logic xor_3383;
  assign xor_3383 = bits[8] ^ (^{select_3362[7:6], other[7:6]});
  logic xor_3386;
  assign xor_3386 = bits[2] ^ (^{select_3362[1:0], other[1:0]});
  logic xor_3389;
  assign xor_3389 = bits[5] ^ (^{select_3362[4:3], other[4:3]});
  logic xor_3392;
  assign xor_3392 = xor_3383 ^ (^{select_3362[5:0], other[5:0]});
  logic parity_3394;
  assign parity_3394 = ^{select_3362[47:45], select_3362[8:0], other[47:45], other[8:0]};
  logic xor_3395;
  assign xor_3395 = xor_3377 ^ parity_3394;
  logic xor_3398;
  assign xor_3398 = bits[44] ^ (^{select_3362[43:42], other[43:42]});
  logic xor_3401;
  assign xor_3401 = bits[38] ^ (^{select_3362[37:36], other[37:36]});
  logic xor_3404;
  assign xor_3404 = bits[41] ^ (^{select_3362[40:39], other[40:39]});
  logic xor_3410;
  assign xor_3410 = bits[26] ^ (^{select_3362[25:24], other[25:24]});
  logic xor_3413;
  assign xor_3413 = bits[20] ^ (^{select_3362[19:18], other[19:18]});
  logic xor_3416;
  assign xor_3416 = bits[23] ^ (^{select_3362[22:21], other[22:21]});
  logic xor_3419;
  assign xor_3419 = xor_3410 ^ (^{select_3362[23:18], other[23:18]});
  logic xor_3422;
  assign xor_3422 = bits[35] ^ (^{select_3362[34:33], other[34:33]});
  logic xor_3425;
  assign xor_3425 = bits[29] ^ (^{select_3362[28:27], other[28:27]});
  logic xor_3428;
  assign xor_3428 = bits[32] ^ (^{select_3362[31:30], other[31:30]});
  logic xor_3431;
  assign xor_3431 = xor_3422 ^ (^{select_3362[32:27], other[32:27]});
  logic xor_3432;
  assign xor_3432 = xor_3419 ^ xor_3431;
  // hls/stages/count_bits.hpp:25
  logic or_3440;
  assign or_3440 = (xor_3371 & xor_3374) | (xor_3368 & (xor_3371 | xor_3374));
  logic or_3444;
  assign or_3444 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3448;
  assign or_3448 = (xor_3386 & xor_3389) | (xor_3383 & (xor_3386 | xor_3389));
  // hls/stages/count_bits.hpp:23
  logic or_3455;
  assign or_3455 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3459;
  assign or_3459 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3463;
  assign or_3463 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3466;
  assign parity_3466 = ^{or_3463, or_3459, or_3455};
  // hls/stages/count_bits.hpp:23
  logic or_3470;
  assign or_3470 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3474;
  assign or_3474 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3478;
  assign or_3478 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3481;
  assign parity_3481 = ^{or_3478, or_3474, or_3470};
  logic parity_3484;
  assign parity_3484 = ^{or_3478, or_3474, or_3470, or_3463, or_3459, or_3455, or_3448, or_3444, or_3440};
  // hls/stages/count_bits.hpp:23
  logic or_3488;
  assign or_3488 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3492;
  assign or_3492 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3496;
  assign or_3496 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3504;
  assign or_3504 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3508;
  assign or_3508 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3512;
  assign or_3512 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3515;
  assign parity_3515 = ^{or_3512, or_3508, or_3504};
  // hls/stages/count_bits.hpp:23
  logic or_3519;
  assign or_3519 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3523;
  assign or_3523 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3527;
  assign or_3527 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3530;
  assign parity_3530 = ^{or_3527, or_3523, or_3519};
  logic parity_3533;
  assign parity_3533 = ^{or_3527, or_3523, or_3519, or_3512, or_3508, or_3504, or_3496, or_3492, or_3488};
  // hls/stages/count_bits.hpp:25
  logic or_3537;
  assign or_3537 = (xor_3401 & xor_3404) | (xor_3398 & (xor_3401 | xor_3404));
  logic or_3541;
  assign or_3541 = (xor_3413 & xor_3416) | (xor_3410 & (xor_3413 | xor_3416));
  logic or_3545;
  assign or_3545 = (xor_3425 & xor_3428) | (xor_3422 & (xor_3425 | xor_3428));
  // hls/stages/count_bits.hpp:24
  logic parity_3548;
  assign parity_3548 = ^{or_3545, or_3541, or_3537};
  // hls/stages/count_bits.hpp:25
  logic and_3549;
  assign and_3549 = xor_3395 & (^{xor_3432, select_3362[44:36], other[44:36]});
  logic or_3553;
  assign or_3553 = (xor_3380 & xor_3392) | (xor_3377 & (xor_3380 | xor_3392));
  logic and_3556;
  assign and_3556 = (xor_3398 ^ (^{select_3362[41:36], other[41:36]})) & (xor_3419 | xor_3431);
  logic or_3557;
  assign or_3557 = (xor_3419 & xor_3431) | and_3556;
  // hls/stages/count_bits.hpp:24
  logic parity_3560;
  assign parity_3560 = ^{or_3557, or_3553, and_3549};
  logic parity_3563;
  assign parity_3563 = ^{or_3557, or_3553, and_3549, or_3545, or_3541, or_3537, or_3527, or_3523, or_3519, or_3512, or_3508, or_3504, or_3496, or_3492, or_3488};
  logic parity_3565;
  assign parity_3565 = ^{or_3557, or_3553, and_3549, or_3545, or_3541, or_3537, or_3527, or_3523, or_3519, or_3512, or_3508, or_3504, or_3496, or_3492, or_3488, or_3478, or_3474, or_3470, or_3463, or_3459, or_3455, or_3448, or_3444, or_3440};
  // hls/stages/count_bits.hpp:25
  logic and_3566;
  assign and_3566 = parity_3484 & parity_3563;
  logic or_3570;
  assign or_3570 = (parity_3466 & parity_3481) | ((^{or_3448, or_3444, or_3440}) & (parity_3466 | parity_3481));
  logic or_3574;
  assign or_3574 = (parity_3548 & parity_3560) | (parity_3533 & (parity_3548 | parity_3560));
  logic or_3581;
  assign or_3581 = (parity_3515 & parity_3530) | ((^{or_3496, or_3492, or_3488}) & (parity_3515 | parity_3530));
  logic or_3585;
  assign or_3585 = (or_3541 & or_3545) | (or_3537 & (or_3541 | or_3545));
  logic or_3589;
  assign or_3589 = (or_3553 & or_3557) | (and_3549 & (or_3553 | or_3557));
  // hls/stages/count_bits.hpp:23
  logic or_3596;
  assign or_3596 = (or_3492 & or_3496) | (or_3488 & (or_3492 | or_3496));
  // hls/stages/count_bits.hpp:25
  logic or_3600;
  assign or_3600 = (or_3508 & or_3512) | (or_3504 & (or_3508 | or_3512));
  logic or_3604;
  assign or_3604 = (or_3523 & or_3527) | (or_3519 & (or_3523 | or_3527));
  // hls/stages/count_bits.hpp:24
  logic parity_3607;
  assign parity_3607 = ^{or_3604, or_3600, or_3596};
  // hls/stages/count_bits.hpp:23
  logic or_3611;
  assign or_3611 = (or_3444 & or_3448) | (or_3440 & (or_3444 | or_3448));
  // hls/stages/count_bits.hpp:25
  logic or_3615;
  assign or_3615 = (or_3459 & or_3463) | (or_3455 & (or_3459 | or_3463));
  logic or_3619;
  assign or_3619 = (or_3474 & or_3478) | (or_3470 & (or_3474 | or_3478));
  // hls/stages/count_bits.hpp:24
  logic parity_3622;
  assign parity_3622 = ^{or_3619, or_3615, or_3611};
  logic parity_3625;
  assign parity_3625 = ^{or_3619, or_3615, or_3611, or_3604, or_3600, or_3596, or_3589, or_3585, or_3581};
  logic parity_3627;
  assign parity_3627 = ^{or_3619, or_3615, or_3611, or_3604, or_3600, or_3596, or_3589, or_3585, or_3581, or_3574, or_3570, and_3566};
  // hls/stages/count_bits.hpp:25
  logic or_3631;
  assign or_3631 = (or_3585 & or_3589) | (or_3581 & (or_3585 | or_3589));
  logic or_3635;
  assign or_3635 = (or_3600 & or_3604) | (or_3596 & (or_3600 | or_3604));
  logic or_3639;
  assign or_3639 = (or_3615 & or_3619) | (or_3611 & (or_3615 | or_3619));
  // hls/stages/count_bits.hpp:24
  logic parity_3642;
  assign parity_3642 = ^{or_3639, or_3635, or_3631};
  // hls/stages/count_bits.hpp:25
  logic and_3643;
  assign and_3643 = (^{or_3574, or_3570, and_3566}) & parity_3625;
  logic or_3647;
  assign or_3647 = (or_3570 & or_3574) | (and_3566 & (or_3570 | or_3574));
  logic or_3651;
  assign or_3651 = (parity_3607 & parity_3622) | ((^{or_3589, or_3585, or_3581}) & (parity_3607 | parity_3622));
  // hls/stages/count_bits.hpp:24
  logic parity_3654;
  assign parity_3654 = ^{or_3651, or_3647, and_3643};
  // hls/stages/count_bits.hpp:25
  logic and_3656;
  assign and_3656 = parity_3642 & parity_3654;
  logic or_3660;
  assign or_3660 = (or_3635 & or_3639) | (or_3631 & (or_3635 | or_3639));
  logic or_3664;
  assign or_3664 = (or_3647 & or_3651) | (and_3643 & (or_3647 | or_3651));
  // hls/stages/patches.hpp:176
  logic [4:0] select_3709;
  assign select_3709 = equal_2151_s3_q ? patches_along_s3_q : patches_summed_row_column_q;
  logic select_3712;
  assign select_3712 = equal_2149_s3_q ? patches_summed_first_q : (equal_2151_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:542
  logic [9:0] select_3719;
  assign select_3719 = less_2312_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3722;
  assign select_3722 = equal_2315_s3_q ? (less_2312_s3_q ? (equal_2315_s3_q ? 10'h0 : select_3719) : 10'h0) : select_3719;
  logic [9:0] select_3724;
  assign select_3724 = less_2312_s3_q ? (equal_2313_s3_q ? 10'h0 : select_3722) : select_3722;
  // hls/stages/patches.hpp:542
  logic [4:0] select_3726;
  assign select_3726 = less_2312_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3729;
  assign select_3729 = equal_2315_s3_q ? (less_2312_s3_q ? (equal_2315_s3_q ? 5'h0 : select_3726) : 5'h0) : select_3726;
  logic [4:0] select_3731;
  assign select_3731 = less_2312_s3_q ? (equal_2313_s3_q ? 5'h0 : select_3729) : select_3729;
  // hls/stages/patches.hpp:542
  logic [4:0] select_3733;
  assign select_3733 = less_2312_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:546
  logic [4:0] select_3736;
  assign select_3736 = equal_2315_s3_q ? (less_2312_s3_q ? (equal_2315_s3_q ? 5'h0 : select_3733) : 5'h0) : select_3733;
  logic [4:0] select_3738;
  assign select_3738 = less_2312_s3_q ? (equal_2313_s3_q ? 5'h0 : select_3736) : select_3736;
  // hls/stages/patches.hpp:542
  logic and_3741;
  assign and_3741 = less_2312_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:546
  logic select_3744;
  assign select_3744 = equal_2315_s3_q ? (less_2312_s3_q ? (not_2316_s3_q & and_3741) : and_3741) : and_3741;
  // hls/stages/patches.hpp:176
  logic select_3747;
  assign select_3747 = equal_2149_s3_q ? (less_2312_s3_q ? (not_2314_s3_q & select_3744) : select_3744) : patches_read_first_q;
  // hls/stages/patches.hpp:170
  logic or_3758;
  assign or_3758 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3759;
  assign and_3759 = patches_read_searches_s3_q & or_3758;
  // hls/stages/patches.hpp:526
  logic [4:0] select_3760;
  assign select_3760 = and_3759 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:533
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3760};
  // hls/stages/patches.hpp:542
  logic and_3764;
  assign and_3764 = less_2312_s3_q & (equal_3756_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:546
  logic select_3767;
  assign select_3767 = equal_2315_s3_q ? (less_2312_s3_q ? (not_2316_s3_q & and_3764) : and_3764) : and_3764;
  // hls/stages/patches.hpp:176
  logic select_3770;
  assign select_3770 = equal_2149_s3_q ? (less_2312_s3_q ? (not_2314_s3_q & select_3767) : select_3767) : patches_read_above_q;
  // hls/stages/patches.hpp:542
  logic and_3773;
  assign and_3773 = less_2312_s3_q & (equal_3756_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:546
  logic select_3776;
  assign select_3776 = equal_2315_s3_q ? (less_2312_s3_q ? (not_2316_s3_q & and_3773) : and_3773) : and_3773;
  // hls/stages/patches.hpp:176
  logic select_3779;
  assign select_3779 = equal_2149_s3_q ? (less_2312_s3_q ? (not_2314_s3_q & select_3776) : select_3776) : patches_read_below_q;
  // hls/stages/patches.hpp:539
  logic [6:0] sum_3780;
  assign sum_3780 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:540
  logic [9:0] select_3783;
  assign select_3783 = (equal_3756_s3_q & ({sum_3780[6], sum_3780} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3784;
  assign select_3784 = less_2312_s3_q ? select_3783 : 10'h3ff;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3786;
  assign select_3786 = less_2312_s3_q ? (equal_2315_s3_q ? 10'h3ff : select_3784) : 10'h3ff;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3787;
  assign select_3787 = equal_2315_s3_q ? select_3786 : select_3784;
  logic [9:0] select_3789;
  assign select_3789 = less_2312_s3_q ? (equal_2313_s3_q ? 10'h3ff : select_3787) : select_3787;
  // hls/stages/patches.hpp:525
  logic [14:0] select_3791;
  assign select_3791 = and_3759 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:176
  logic [9:0] select_3792;
  assign select_3792 = equal_2149_s3_q ? select_3791[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3793;
  assign select_3793 = equal_2149_s3_q ? select_3791[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:527
  logic [9:0] select_3795;
  assign select_3795 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:528
  logic [9:0] select_3797;
  assign select_3797 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:529
  logic [9:0] select_3800;
  assign select_3800 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3801;
  assign select_3801 = patches_read_first_q ? patches_read_far_q : select_3800;
  // hls/stages/patches.hpp:580
  logic [9:0] difference_3804;
  assign difference_3804 = select_3801 - select_3791[9:0];
  // hls/stages/patches.hpp:565
  logic less_3834;
  assign less_3834 = select_3795 < select_3797;
  // hls/stages/patches.hpp:571
  logic [1:0] sum_3835;
  assign sum_3835 = select_3760[4:3] + 2'h3;
  // hls/stages/patches.hpp:566
  logic [9:0] high;
  assign high = less_3834 ? select_3797 : select_3795;
  logic [9:0] low;
  assign low = (select_3797 < select_3795) ? select_3797 : select_3795;
  // hls/stages/patches.hpp:567
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3791[9:0];
  // hls/stages/patches.hpp:569
  logic not_3842;
  assign not_3842 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3843;
  assign sum_3843 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3845;
  assign not_3845 = ~({eight, 3'h0} < {1'b0, sum_3843, fall[0]});
  logic [1:0] sum_3846;
  assign sum_3846 = {1'b0, not_3842} + {1'b0, not_3845};
  // hls/stages/patches.hpp:570
  logic [10:0] sum_3847;
  assign sum_3847 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3849;
  assign not_3849 = ~({eight, 3'h0} < {sum_3847, fall[1:0]});
  logic not_3852;
  assign not_3852 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3853;
  assign sum_3853 = {1'b0, not_3849} + {1'b0, not_3852};
  // hls/stages/patches.hpp:569
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3846} + {1'b0, sum_3853};
  // hls/stages/patches.hpp:572
  logic [7:0] select_3856;
  assign select_3856 = less_3834 ? ({sum_3835, select_3760[2:0], 3'h0} - {5'h0, fraction}) : {sum_3835, select_3760[2:0], fraction};
  // hls/stages/agreement.hpp:1096
  logic equal_4019;
  assign equal_4019 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:773
  logic select_4056;
  assign select_4056 = equal_1936_s3_q ? shown_shown_q : (so_s3_q ? select_2370 : shown_shown_q);
  logic select_4058;
  assign select_4058 = equal_1936_s3_q ? shown_nearer_q : (so_s3_q ? select_2373 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4060;
  assign sum_4060 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:448
  logic [2:0] select_4062;
  assign select_4062 = less_4059_s3_q ? (sum_4060[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4064;
  assign select_4064 = equal_2745_s3_q ? (equal_565_s3_q ? 3'h0 : select_4062) : region_row_q;
  // hls/stages/agreement.hpp:773
  logic [7:0] select_4069;
  assign select_4069 = equal_1936_s3_q ? select_2330 : (so_s3_q ? (ends_cell_s3_q ? select_2422 : select_2330) : 8'h1);
  // hls/stages/agreement.hpp:448
  logic [8:0] select_4083;
  assign select_4083 = equal_565_s3_q ? {{2{difference_4081[6]}}, difference_4081} : (less_4059_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:508
  logic [8:0] select_4085;
  assign select_4085 = and_504_s3_q ? (equal_2745_s3_q ? select_4083 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:448
  logic [6:0] select_4087;
  assign select_4087 = equal_565_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:508
  logic [6:0] select_4089;
  assign select_4089 = and_504_s3_q ? (equal_2745_s3_q ? select_4087 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4090;
  assign sum_4090 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4091;
  assign select_4091 = sum_4060[7] ? {1'b1, sum_4060[6:0], region_down_rest_q[0]} : sum_4090;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4060[7];
  // hls/stages/agreement.hpp:448
  logic select_4095;
  assign select_4095 = equal_2745_s3_q ? (equal_565_s3_q | (less_4059_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_4100;
  assign or_4100 = segment_starts_q | not_1976;
  // hls/stages/agreement.hpp:986
  logic select_4103;
  assign select_4103 = shift_2_s3_q[0] ? (sum_2343_s3_q ? (equal_2142_s3_q & or_2345) : or_2345) : or_4100;
  // hls/stages/agreement.hpp:773
  logic select_4106;
  assign select_4106 = equal_1936_s3_q ? or_4100 : (so_s3_q ? (ends_cell_s3_q ? select_4103 : or_4100) : or_4100);
  logic [2:0] select_4180;
  assign select_4180 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_4182;
  assign select_4182 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4184;
  assign select_4184 = equal_1936_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4182 : box_textured_columns_values_1_q);
  logic [2:0] select_4185;
  assign select_4185 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4187;
  assign select_4187 = equal_1936_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4185 : box_textured_columns_values_2_q);
  logic [2:0] select_4188;
  assign select_4188 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4190;
  assign select_4190 = equal_1936_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4188 : box_textured_columns_values_3_q);
  logic [2:0] select_4191;
  assign select_4191 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4193;
  assign select_4193 = equal_1936_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4191 : box_textured_columns_values_4_q);
  logic [4:0] select_4195;
  assign select_4195 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4198;
  assign select_4198 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4200;
  assign select_4200 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4202;
  assign select_4202 = equal_1936_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4200 : box_explained_columns_values_1_q);
  logic [2:0] select_4203;
  assign select_4203 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4205;
  assign select_4205 = equal_1936_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4203 : box_explained_columns_values_2_q);
  logic [2:0] select_4206;
  assign select_4206 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4208;
  assign select_4208 = equal_1936_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4206 : box_explained_columns_values_3_q);
  logic [2:0] select_4209;
  assign select_4209 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4211;
  assign select_4211 = equal_1936_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4209 : box_explained_columns_values_4_q);
  logic [4:0] select_4213;
  assign select_4213 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4214;
  assign select_4214 = equal_1936_s3_q ? box_explained_sum_sums_values_0_q : select_4213;
  logic [2:0] select_4216;
  assign select_4216 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4218;
  assign select_4218 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4220;
  assign select_4220 = equal_1936_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4218 : box_shown_columns_values_1_q);
  logic [2:0] select_4221;
  assign select_4221 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4223;
  assign select_4223 = equal_1936_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4221 : box_shown_columns_values_2_q);
  logic [2:0] select_4224;
  assign select_4224 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4226;
  assign select_4226 = equal_1936_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4224 : box_shown_columns_values_3_q);
  logic [2:0] select_4227;
  assign select_4227 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4229;
  assign select_4229 = equal_1936_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4227 : box_shown_columns_values_4_q);
  logic [4:0] select_4231;
  assign select_4231 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4234;
  assign select_4234 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4236;
  assign select_4236 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4238;
  assign select_4238 = equal_1936_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4236 : box_nearer_columns_values_1_q);
  logic [2:0] select_4239;
  assign select_4239 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4241;
  assign select_4241 = equal_1936_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4239 : box_nearer_columns_values_2_q);
  logic [2:0] select_4242;
  assign select_4242 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4244;
  assign select_4244 = equal_1936_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4242 : box_nearer_columns_values_3_q);
  logic [2:0] select_4245;
  assign select_4245 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4247;
  assign select_4247 = equal_1936_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4245 : box_nearer_columns_values_4_q);
  logic [4:0] select_4249;
  assign select_4249 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_4252;
  assign select_4252 = so_s3_q ? (ends_cell_s3_q ? and_2410 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4255;
  assign select_4255 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_4257;
  assign select_4257 = equal_1936_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_4255 : centres_values_0_of_skin_q);
  logic select_4258;
  assign select_4258 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4260;
  assign select_4260 = equal_1936_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_4258 : centres_values_1_textured_q);
  logic select_4261;
  assign select_4261 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4263;
  assign select_4263 = equal_1936_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_4261 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:448
  logic [12:0] select_4267;
  assign select_4267 = equal_2745_s3_q ? (equal_4264_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:508
  logic [6:0] select_4270;
  assign select_4270 = and_504_s3_q ? (equal_2745_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1237
  logic [2:0] select_4281;
  assign select_4281 = select_2382 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:423
  logic [7:0] select_4287;
  assign select_4287 = marks_first_s3_q ? (less_4283 ? {sum_4284, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1245
  logic and_4293;
  assign and_4293 = and_2481_s3_q & ({sum_2407, index_2[5:0]} == {sum_2394, index[5:0]});
  // hls/stages/registration.hpp:258
  logic not_4350;
  assign not_4350 = ~quarter[1];
  logic [3:0] select_4351;
  assign select_4351 = quarter[0] ? {quarter[1], 1'b0, not_4350, 1'b0} : {1'b0, quarter[1], 1'b0, not_4350};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1988;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_2031;
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
  assign patches_choices_raddr = select_2065;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_2067));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1330; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2340;
  logic regions_re;
  assign regions_re = s3_en & (equal_1936_s3_q ? (x_s3_q[6] & not_2341) : and_2348);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1341; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2394, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_2401 & less_2402);
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
  assign averager_memory_waddr = select_474_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_479_s3_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_498, and_494, sum_490, sum_486};
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
  assign census_memory_we = s3_en & and_504_s3_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_522, whole_2, select_514, select_510};
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
  assign shown_right_waddr = select_1975_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1980_s3_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_1977, not_1976};
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
  assign patches_right_codes_waddr = {sum_2263, patches_code_row_s3_q[1:0], of_row_2_s3_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_2297_s3_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {less_2283_s3_q, less_2282_s3_q, less_2273_s3_q, less_2272_s3_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_2301, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_2311_s3_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {less_2283_s3_q, less_2282_s3_q, less_2273_s3_q, less_2272_s3_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s3_en & and_1971_s3_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2369, textured_s3_q};
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
      averager_running_of_skin_q <= select_2534;
      averager_mask_q <= select_2536;
      averager_of_skin_q <= select_2538;
      census_filled_q <= and_504_s3_q ? {select_568[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_504_s3_q ? select_567 : rows_passed_above_q;
      registration_slope_here_q <= select_2959;
      registration_expected_q <= select_2961;
      registration_of_right_q <= equal_1936_s3_q ? registration_of_right_q : select_3021;
      registration_was_inside_q <= equal_1936_s3_q ? registration_was_inside_q : select_3024;
      registration_fresh_q <= select_3033;
      patches_fixed_q <= not_3192 & (patches_fixed_q | (and_3202_s3_q & and_2122));
      patches_choice_valid_q <= and_2147_s3_q ? (select_2141[0] & not_3192) : select_2141[0];
      patches_choice_column_q <= select_2141[8:1];
      patches_choice_shift_q <= select_2141[14:9];
      patches_choice_slope_q <= select_2141[22:15];
      patches_band_q <= sample_pair_whole_s3_q ? select_2162 : patches_band_q;
      patches_fetch_q <= select_3220;
      patches_codes_at_q <= select_3321;
      patches_codes_further_q <= equal_2149_s3_q ? patches_codes_further_q : select_3326;
      patches_next_codes_q <= select_3334;
      patches_set_q <= equal_2149_s3_q ? 3'h0 : (equal_2151_s3_q ? 3'h0 : select_3348);
      patches_size_q <= sum_3352;
      patches_left_row_q <= select_3364;
      patches_summed_row_column_q <= equal_2149_s3_q ? patches_summed_row_column_q : select_3709;
      patches_summed_first_q <= select_3712;
      patches_read_row_differing_q <= equal_2149_s3_q ? select_3724 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2149_s3_q ? select_3731 : patches_read_row_column_q;
      patches_read_at_q <= equal_2149_s3_q ? select_3738 : patches_read_at_q;
      patches_read_first_q <= select_3747;
      patches_read_above_q <= select_3770;
      patches_read_below_q <= select_3779;
      patches_read_far_q <= equal_2149_s3_q ? select_3789 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3792;
      patches_peak_best_column_q <= select_3793;
      patches_peak_row_q <= equal_2149_s3_q ? select_3760 : patches_peak_row_q;
      patches_peak_above_q <= equal_2149_s3_q ? select_3795 : patches_peak_above_q;
      patches_peak_below_q <= equal_2149_s3_q ? select_3797 : patches_peak_below_q;
      patches_peak_far_q <= equal_2149_s3_q ? select_3801 : patches_peak_far_q;
      shown_shown_q <= select_4056;
      shown_nearer_q <= select_4058;
      region_row_q <= and_504_s3_q ? select_4064 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4069;
      region_down_rest_q <= select_4085;
      region_down_back_q <= select_4089;
      region_down_next_q <= select_4091;
      region_fresh_q <= and_504_s3_q ? select_4095 : region_fresh_q;
      segment_starts_q <= select_4106;
      centres_values_0_textured_q <= equal_1936_s3_q ? centres_values_0_textured_q : select_4252;
      centres_values_0_of_skin_q <= select_4257;
      centres_values_1_textured_q <= select_4260;
      centres_values_1_of_skin_q <= select_4263;
      map_row_q <= and_504_s3_q ? select_4267 : map_row_q;
      map_width_q <= select_4270;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2393;
      done_q <= not_2395 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      drew_q <= so_s3_q;
      said_q <= equal_1936_s3_q & equal_4019;
      rows_passed_q <= select_2378;
      columns_passed_q <= {select_2380[7:0], or_2376};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_2397;
      seen_x_q <= select_2399;
      seen_y_q <= marks_first_s3_q ? 3'h0 : select_4281;
      seen_column_q <= select_2390;
      seen_rows_left_q <= select_4287;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2387;
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
      averager_running_0_q <= sample_pair_whole_s3_q ? select_482 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_488 : averager_running_1_q;
      averager_total_0_q <= select_2513;
      averager_total_1_q <= select_2515;
      census_columns_values_0_cell_0_left_q <= select_2539;
      census_columns_values_0_cell_0_right_q <= select_2540;
      census_columns_values_0_cell_0_mask_q <= and_504_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2542;
      census_columns_values_0_cell_1_right_q <= select_2543;
      census_columns_values_0_cell_1_mask_q <= select_2544;
      census_columns_values_0_cell_2_left_q <= select_2545;
      census_columns_values_0_cell_2_right_q <= select_2546;
      census_columns_values_0_cell_2_mask_q <= select_2547;
      census_columns_values_0_cell_2_of_skin_q <= select_2548;
      census_columns_values_0_cell_3_left_q <= select_2549;
      census_columns_values_0_cell_3_right_q <= select_2550;
      census_columns_values_0_cell_3_mask_q <= select_2551;
      census_columns_values_0_cell_4_left_q <= select_2552;
      census_columns_values_0_cell_4_right_q <= select_2553;
      census_columns_values_0_cell_4_mask_q <= select_2554;
      census_columns_values_1_cell_0_left_q <= select_2555;
      census_columns_values_1_cell_0_right_q <= select_2556;
      census_columns_values_1_cell_0_mask_q <= select_2557;
      census_columns_values_1_cell_1_left_q <= select_2558;
      census_columns_values_1_cell_1_right_q <= select_2559;
      census_columns_values_1_cell_1_mask_q <= select_2560;
      census_columns_values_1_cell_2_left_q <= select_2561;
      census_columns_values_1_cell_2_right_q <= select_2562;
      census_columns_values_1_cell_2_mask_q <= select_2563;
      census_columns_values_1_cell_2_of_skin_q <= select_2564;
      census_columns_values_1_cell_3_left_q <= select_2565;
      census_columns_values_1_cell_3_right_q <= select_2566;
      census_columns_values_1_cell_3_mask_q <= select_2567;
      census_columns_values_1_cell_4_left_q <= select_2568;
      census_columns_values_1_cell_4_right_q <= select_2569;
      census_columns_values_1_cell_4_mask_q <= select_2570;
      census_columns_values_2_cell_0_left_q <= select_2571;
      census_columns_values_2_cell_0_right_q <= select_2572;
      census_columns_values_2_cell_0_mask_q <= select_2573;
      census_columns_values_2_cell_1_left_q <= select_2574;
      census_columns_values_2_cell_1_right_q <= select_2575;
      census_columns_values_2_cell_1_mask_q <= select_2576;
      census_columns_values_2_cell_2_left_q <= select_2577;
      census_columns_values_2_cell_2_right_q <= select_2578;
      census_columns_values_2_cell_2_mask_q <= select_2579;
      census_columns_values_2_cell_3_left_q <= select_2580;
      census_columns_values_2_cell_3_right_q <= select_2581;
      census_columns_values_2_cell_3_mask_q <= select_2582;
      census_columns_values_2_cell_4_left_q <= select_2583;
      census_columns_values_2_cell_4_right_q <= select_2584;
      census_columns_values_2_cell_4_mask_q <= select_2585;
      census_columns_values_3_cell_0_mask_q <= select_2586;
      census_columns_values_3_cell_1_left_q <= select_2587;
      census_columns_values_3_cell_1_right_q <= select_2588;
      census_columns_values_3_cell_1_mask_q <= select_2589;
      census_columns_values_3_cell_2_mask_q <= select_2590;
      census_columns_values_3_cell_3_left_q <= select_2591;
      census_columns_values_3_cell_3_right_q <= select_2592;
      census_columns_values_3_cell_3_mask_q <= select_2593;
      census_columns_values_3_cell_4_mask_q <= select_2594;
      sharpness_last_mean_0_q <= and_504_s3_q ? select_510 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_504_s3_q ? select_514 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1936_s3_q ? box_textured_columns_values_0_q : select_4180;
      box_textured_columns_values_1_q <= select_4184;
      box_textured_columns_values_2_q <= select_4187;
      box_textured_columns_values_3_q <= select_4190;
      box_textured_columns_values_4_q <= select_4193;
      box_textured_sum_sums_values_0_q <= equal_1936_s3_q ? box_textured_sum_sums_values_0_q : select_4195;
      box_explained_columns_values_0_q <= equal_1936_s3_q ? box_explained_columns_values_0_q : select_4198;
      box_explained_columns_values_1_q <= select_4202;
      box_explained_columns_values_2_q <= select_4205;
      box_explained_columns_values_3_q <= select_4208;
      box_explained_columns_values_4_q <= select_4211;
      box_explained_sum_sums_values_0_q <= select_4214;
      box_shown_columns_values_0_q <= equal_1936_s3_q ? box_shown_columns_values_0_q : select_4216;
      box_shown_columns_values_1_q <= select_4220;
      box_shown_columns_values_2_q <= select_4223;
      box_shown_columns_values_3_q <= select_4226;
      box_shown_columns_values_4_q <= select_4229;
      box_shown_sum_sums_values_0_q <= equal_1936_s3_q ? box_shown_sum_sums_values_0_q : select_4231;
      box_nearer_columns_values_0_q <= equal_1936_s3_q ? box_nearer_columns_values_0_q : select_4234;
      box_nearer_columns_values_1_q <= select_4238;
      box_nearer_columns_values_2_q <= select_4241;
      box_nearer_columns_values_3_q <= select_4244;
      box_nearer_columns_values_4_q <= select_4247;
      box_nearer_sum_sums_values_0_q <= equal_1936_s3_q ? box_nearer_sum_sums_values_0_q : select_4249;
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
  logic [2:0] select_468_s4_q;
  logic [6:0] select_470_s4_q;
  logic [6:0] column_s4_q;
  logic and_502_s4_q;
  logic and_504_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_507_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
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
  logic less_559_s4_q;
  logic less_560_s4_q;
  logic less_561_s4_q;
  logic and_569_s4_q;
  logic and_594_s4_q;
  logic and_595_s4_q;
  logic [11:0] sum_610_s4_q;
  logic [9:0] sum_613_s4_q;
  logic equal_1936_s4_q;
  logic not_1937_s4_q;
  logic equal_1981_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1987_s4_q;
  logic equal_1989_s4_q;
  logic equal_1991_s4_q;
  logic equal_1993_s4_q;
  logic equal_1995_s4_q;
  logic equal_1997_s4_q;
  logic equal_1999_s4_q;
  logic equal_2001_s4_q;
  logic equal_2003_s4_q;
  logic less_2012_s4_q;
  logic or_2016_s4_q;
  logic equal_2036_s4_q;
  logic and_2046_s4_q;
  logic and_2049_s4_q;
  logic select_2066_s4_q;
  logic equal_2067_s4_q;
  logic and_2075_s4_q;
  logic equal_2077_s4_q;
  logic select_2141_s4_q;
  logic and_2148_s4_q;
  logic equal_2149_s4_q;
  logic equal_2151_s4_q;
  logic and_2164_s4_q;
  logic [4:0] select_2179_s4_q;
  logic select_2185_s4_q;
  logic [3:0] select_2226_s4_q;
  logic less_2312_s4_q;
  logic equal_2313_s4_q;
  logic not_2314_s4_q;
  logic equal_2315_s4_q;
  logic or_2333_s4_q;
  logic or_2336_s4_q;
  logic or_2339_s4_q;
  logic not_2341_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_2362_s4_q;
  logic and_2367_s4_q;
  logic and_2401_s4_q;
  logic less_2402_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_2407_s4_q;
  logic equal_2420_s4_q;
  logic or_2425_s4_q;
  logic or_2428_s4_q;
  logic or_2431_s4_q;
  logic not_2456_s4_q;
  logic less_2470_s4_q;
  logic and_2481_s4_q;
  logic [11:0] sum_2610_s4_q;
  logic [9:0] sum_2613_s4_q;
  logic equal_2621_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2850_s4_q;
  logic and_2854_s4_q;
  logic not_2888_s4_q;
  logic and_2916_s4_q;
  logic and_2965_s4_q;
  logic and_2966_s4_q;
  logic [7:0] residual_s4_q;
  logic and_3000_s4_q;
  logic and_3014_s4_q;
  logic equal_3057_s4_q;
  logic parity_3436_s4_q;
  logic parity_3565_s4_q;
  logic parity_3627_s4_q;
  logic xor_3655_s4_q;
  logic parity_3667_s4_q;
  logic or_3671_s4_q;
  logic equal_3672_s4_q;
  logic [4:0] select_3791_s4_q;
  logic equal_3803_s4_q;
  logic less_3805_s4_q;
  logic less_3806_s4_q;
  logic or_3811_s4_q;
  logic [7:0] select_3856_s4_q;
  logic equal_4019_s4_q;
  logic and_4293_s4_q;
  logic not_4308_s4_q;
  logic equal_4353_s4_q;
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
      select_468_s4_q <= select_468_s3_q;
      select_470_s4_q <= select_470_s3_q;
      column_s4_q <= column_s3_q;
      and_502_s4_q <= and_502_s3_q;
      and_504_s4_q <= and_504_s3_q;
      grey_s4_q <= grey;
      equal_507_s4_q <= equal_507;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
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
      less_559_s4_q <= less_559;
      less_560_s4_q <= less_560;
      less_561_s4_q <= less_561;
      and_569_s4_q <= and_569;
      and_594_s4_q <= whole_22 & and_569;
      and_595_s4_q <= census_columns_values_1_cell_2_mask_q & and_569;
      sum_610_s4_q <= {1'b0, sum_606} + {2'h0, sum_609};
      sum_613_s4_q <= {9'h0, difference_611[9]} + {1'b0, xor_612};
      equal_1936_s4_q <= equal_1936_s3_q;
      not_1937_s4_q <= not_1937_s3_q;
      equal_1981_s4_q <= equal_1981;
      all_s4_q <= all;
      sum_1987_s4_q <= sum_1987;
      equal_1989_s4_q <= equal_1989;
      equal_1991_s4_q <= equal_1991;
      equal_1993_s4_q <= equal_1993;
      equal_1995_s4_q <= equal_1995;
      equal_1997_s4_q <= equal_1997;
      equal_1999_s4_q <= equal_1999;
      equal_2001_s4_q <= equal_2001;
      equal_2003_s4_q <= equal_2003;
      less_2012_s4_q <= less_2012;
      or_2016_s4_q <= or_2016;
      equal_2036_s4_q <= (registration_fresh_q & select_2034) == 4'h0;
      and_2046_s4_q <= not_1937_s3_q & and_2030;
      and_2049_s4_q <= and_2049_s3_q;
      select_2066_s4_q <= select_2066[1];
      equal_2067_s4_q <= equal_2067;
      and_2075_s4_q <= and_2075_s3_q;
      equal_2077_s4_q <= equal_2077;
      select_2141_s4_q <= select_2141[0];
      and_2148_s4_q <= and_2148_s3_q;
      equal_2149_s4_q <= equal_2149_s3_q;
      equal_2151_s4_q <= equal_2151_s3_q;
      and_2164_s4_q <= and_2148_s3_q & equal_2163;
      select_2179_s4_q <= select_2179_s3_q;
      select_2185_s4_q <= select_2185_s3_q;
      select_2226_s4_q <= select_2226_s3_q;
      less_2312_s4_q <= less_2312_s3_q;
      equal_2313_s4_q <= equal_2313_s3_q;
      not_2314_s4_q <= not_2314_s3_q;
      equal_2315_s4_q <= equal_2315_s3_q;
      or_2333_s4_q <= or_2333;
      or_2336_s4_q <= or_2336;
      or_2339_s4_q <= or_2339;
      not_2341_s4_q <= not_2341;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_2362_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_2367_s4_q <= not_1937_s3_q & and_2348;
      and_2401_s4_q <= and_2401;
      less_2402_s4_q <= less_2402;
      index_2_s4_q <= index_2[5:0];
      sum_2407_s4_q <= sum_2407;
      equal_2420_s4_q <= t[4:1] == 4'h0;
      or_2425_s4_q <= or_2425;
      or_2428_s4_q <= select_2422[7] | (~({select_2422[6], select_2422[3:2]} == 3'h0));
      or_2431_s4_q <= select_2422[7] | (~(select_2422[6:4] == 3'h0));
      not_2456_s4_q <= ~({sum_2454, around[0]} < {2'h0, t});
      less_2470_s4_q <= {1'b0, around[4:1]} < n;
      and_2481_s4_q <= and_2481_s3_q;
      sum_2610_s4_q <= {1'b0, sum_2606} + {2'h0, sum_2609};
      sum_2613_s4_q <= {9'h0, difference_2611[9]} + {1'b0, xor_2612};
      equal_2621_s4_q <= equal_2621_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2850_s4_q <= and_2850;
      and_2854_s4_q <= and_2854;
      not_2888_s4_q <= ~({sum_2886, e[0]} < {2'h0, t});
      and_2916_s4_q <= not_1937_s3_q & and_2915;
      and_2965_s4_q <= not_1937_s3_q & (so_s3_q & (half_ends & equal_2962));
      and_2966_s4_q <= and_2966;
      residual_s4_q <= residual[7:0];
      and_3000_s4_q <= and_3000;
      and_3014_s4_q <= and_2966 & less_3013;
      equal_3057_s4_q <= (registration_fresh_q & select_3055) == 4'h0;
      parity_3436_s4_q <= ^{xor_3432, xor_3395, select_3362[44:36], other[44:36]};
      parity_3565_s4_q <= parity_3565;
      parity_3627_s4_q <= parity_3627;
      xor_3655_s4_q <= parity_3642 ^ parity_3654;
      parity_3667_s4_q <= ^{or_3664, or_3660, and_3656};
      or_3671_s4_q <= (or_3660 & or_3664) | (and_3656 & (or_3660 | or_3664));
      equal_3672_s4_q <= equal_3672_s3_q;
      select_3791_s4_q <= select_3791[14:10];
      equal_3803_s4_q <= select_3760[3:0] == 4'h0;
      less_3805_s4_q <= {difference_3804, 3'h0} < {3'h0, sum_3352};
      less_3806_s4_q <= select_3801 < select_3791[9:0];
      or_3811_s4_q <= (sum_3352 < 10'h39) | ({1'b0, sum_3352[9:1]} < select_3791[9:0]);
      select_3856_s4_q <= select_3856;
      equal_4019_s4_q <= equal_4019;
      and_4293_s4_q <= and_4293;
      not_4308_s4_q <= ~proven_q;
      equal_4353_s4_q <= (registration_fresh_q & select_4351) == 4'h0;
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
  assign texture = sum_610_s4_q + {2'h0, sum_613_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_615;
  assign sum_615 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_617;
  assign sum_617 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_615});
  // hls/stages/census.hpp:303
  logic less_618;
  assign less_618 = 9'h4 < sum_617[13:5];
  logic and_619;
  assign and_619 = and_569_s4_q & less_618;
  // hls/stages/registration.hpp:265
  logic equal_2038;
  assign equal_2038 = sum_1987_s4_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1987_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2040;
  assign select_2040 = equal_2038 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2041;
  assign sum_2041 = (equal_2036_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2040[13]}}, select_2040};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1987_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2044;
  assign select_2044 = equal_2038 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2045;
  assign sum_2045 = (equal_2036_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2044[6]}}, select_2044};
  // hls/stages/patches.hpp:343
  logic [22:0] select_2165;
  assign select_2165 = and_2164_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2141_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:119
  logic select_2167;
  assign select_2167 = equal_2067_s4_q ? patches_place_0_valid_q : (select_2066_s4_q ? patches_place_0_valid_q : select_2165[0]);
  // hls/stages/patches.hpp:344
  logic [21:0] select_2168;
  assign select_2168 = select_2066_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2165[22:1];
  // hls/stages/patches.hpp:119
  logic [7:0] select_2169;
  assign select_2169 = equal_2067_s4_q ? patches_place_0_column_q : select_2168[7:0];
  logic [5:0] select_2170;
  assign select_2170 = equal_2067_s4_q ? patches_place_0_shift_q : select_2168[13:8];
  // hls/stages/patches.hpp:314
  logic [7:0] sum_2171;
  assign sum_2171 = select_2169 + {{2{select_2170[5]}}, select_2170};
  // hls/stages/patches.hpp:315
  logic [6:0] sum_2172;
  assign sum_2172 = sum_2171[7:1] + 7'h7f;
  // hls/stages/patches.hpp:123
  logic equal_2173;
  assign equal_2173 = {sum_2172[6], select_470_s4_q, select_468_s4_q} == {1'b0, sum_2172[5:0], sum_2171[0], 3'h4};
  // hls/stages/patches.hpp:125
  logic or_2175;
  assign or_2175 = and_2049_s4_q | (select_2167 & equal_2173);
  // hls/stages/agreement.hpp:264
  logic [4:0] select_2176;
  assign select_2176 = or_2175 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:125
  logic [5:0] select_2186;
  assign select_2186 = or_2175 ? {and_2049_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:129
  logic and_2188;
  assign and_2188 = select_2185_s4_q & (~select_2186[5]);
  // hls/stages/patches.hpp:119
  logic select_2196;
  assign select_2196 = equal_2067_s4_q ? patches_place_1_valid_q : (select_2066_s4_q ? select_2165[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:344
  logic [21:0] select_2197;
  assign select_2197 = select_2066_s4_q ? select_2165[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:119
  logic [7:0] select_2198;
  assign select_2198 = equal_2067_s4_q ? patches_place_1_column_q : select_2197[7:0];
  logic [5:0] select_2199;
  assign select_2199 = equal_2067_s4_q ? patches_place_1_shift_q : select_2197[13:8];
  // hls/stages/patches.hpp:314
  logic [7:0] sum_2200;
  assign sum_2200 = select_2198 + {{2{select_2199[5]}}, select_2199};
  // hls/stages/patches.hpp:315
  logic [6:0] sum_2201;
  assign sum_2201 = sum_2200[7:1] + 7'h7f;
  // hls/stages/patches.hpp:123
  logic equal_2202;
  assign equal_2202 = {sum_2201[6], select_470_s4_q, select_468_s4_q} == {1'b0, sum_2201[5:0], sum_2200[0], 3'h4};
  // hls/stages/patches.hpp:125
  logic or_2204;
  assign or_2204 = and_2049_s4_q | (select_2196 & equal_2202);
  // hls/stages/agreement.hpp:264
  logic [4:0] select_2205;
  assign select_2205 = or_2204 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:125
  logic [5:0] select_2206;
  assign select_2206 = or_2204 ? {and_2049_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:129
  logic and_2208;
  assign and_2208 = select_2185_s4_q & (~select_2206[5]);
  // hls/stages/patches.hpp:310
  logic [7:0] sum_2215;
  assign sum_2215 = select_2169 + 8'hff;
  // hls/stages/patches.hpp:124
  logic equal_2216;
  assign equal_2216 = {sum_2215[7], select_470_s4_q, select_468_s4_q} == {1'b0, sum_2215[6:0], 3'h4};
  // hls/stages/patches.hpp:126
  logic or_2218;
  assign or_2218 = and_2049_s4_q | (select_2167 & equal_2216);
  logic [4:0] select_2219;
  assign select_2219 = or_2218 ? {and_2049_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:310
  logic [7:0] sum_2220;
  assign sum_2220 = select_2198 + 8'hff;
  // hls/stages/patches.hpp:124
  logic equal_2221;
  assign equal_2221 = {sum_2220[7], select_470_s4_q, select_468_s4_q} == {1'b0, sum_2220[6:0], 3'h4};
  // hls/stages/patches.hpp:126
  logic [4:0] select_2224;
  assign select_2224 = (and_2049_s4_q | (select_2196 & equal_2221)) ? {and_2049_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:134
  logic [3:0] column_7;
  assign column_7 = select_2219[4] ? select_2224[3:0] : select_2219[3:0];
  // hls/stages/agreement.hpp:264
  logic select_2227;
  assign select_2227 = or_2218 ? and_2049_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:134
  logic and_2233;
  assign and_2233 = (select_2185_s4_q & (select_2179_s4_q[3] ^ select_2179_s4_q[4])) & ((~select_2219[4]) | (~select_2224[4]));
  // hls/stages/patches.hpp:176
  logic less_2324;
  assign less_2324 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:177
  logic not_2325;
  assign not_2325 = ~less_2324;
  logic [1:0] select_2326;
  assign select_2326 = patches_summed_first_s4_q ? 2'h2 : {less_2324, not_2325};
  logic [12:0] select_2327;
  assign select_2327 = select_2326[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2328;
  assign select_2328 = select_2326[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2329;
  assign select_2329 = select_2326[1] ? {select_2327[12:8], patches_sums_values_0_q[9:8], select_2327[7:0]} : select_2328;
  // hls/stages/agreement.hpp:876
  logic [6:0] select_2352;
  assign select_2352 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:877
  logic [6:0] sum_2353;
  assign sum_2353 = {6'h0, textured_s4_q} + select_2352;
  // hls/stages/agreement.hpp:1013
  logic [9:0] sum_2355;
  assign sum_2355 = {3'h0, sum_2353} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:876
  logic [6:0] select_2357;
  assign select_2357 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:877
  logic [6:0] sum_2358;
  assign sum_2358 = {6'h0, explained_s4_q} + select_2357;
  // hls/stages/agreement.hpp:1014
  logic [9:0] sum_2360;
  assign sum_2360 = {3'h0, sum_2358} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:876
  logic [6:0] select_2363;
  assign select_2363 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:878
  logic [6:0] sum_2364;
  assign sum_2364 = {6'h0, and_2362_s4_q} + select_2363;
  // hls/stages/agreement.hpp:1015
  logic [9:0] sum_2366;
  assign sum_2366 = {3'h0, sum_2364} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1053
  logic not_2432;
  assign not_2432 = ~region_row_s4_q[2];
  logic [2:0] select_2433;
  assign select_2433 = region_row_s4_q[1] ? {1'b0, not_2432, 1'b0} : {region_row_s4_q[2], 1'b0, not_2432};
  logic [5:0] select_2434;
  assign select_2434 = region_row_s4_q[0] ? {select_2433[2], 1'b0, select_2433[1], 1'b0, select_2433[0], 1'b0} : {1'b0, select_2433[2], 1'b0, select_2433[1], 1'b0, select_2433[0]};
  logic [11:0] select_2435;
  assign select_2435 = or_2431_s4_q ? {select_2434[5], 1'b0, select_2434[4], 1'b0, select_2434[3], 1'b0, select_2434[2], 1'b0, select_2434[1], 1'b0, select_2434[0], 1'b0} : {1'b0, select_2434[5], 1'b0, select_2434[4], 1'b0, select_2434[3], 1'b0, select_2434[2], 1'b0, select_2434[1], 1'b0, select_2434[0]};
  logic [23:0] select_2436;
  assign select_2436 = or_2428_s4_q ? {select_2435[11], 1'b0, select_2435[10], 1'b0, select_2435[9], 1'b0, select_2435[8], 1'b0, select_2435[7], 1'b0, select_2435[6], 1'b0, select_2435[5], 1'b0, select_2435[4], 1'b0, select_2435[3], 1'b0, select_2435[2], 1'b0, select_2435[1], 1'b0, select_2435[0], 1'b0} : {1'b0, select_2435[11], 1'b0, select_2435[10], 1'b0, select_2435[9], 1'b0, select_2435[8], 1'b0, select_2435[7], 1'b0, select_2435[6], 1'b0, select_2435[5], 1'b0, select_2435[4], 1'b0, select_2435[3], 1'b0, select_2435[2], 1'b0, select_2435[1], 1'b0, select_2435[0]};
  logic [47:0] select_2437;
  assign select_2437 = or_2425_s4_q ? {select_2436[23], 1'b0, select_2436[22], 1'b0, select_2436[21], 1'b0, select_2436[20], 1'b0, select_2436[19], 1'b0, select_2436[18], 1'b0, select_2436[17], 1'b0, select_2436[16], 1'b0, select_2436[15], 1'b0, select_2436[14], 1'b0, select_2436[13], 1'b0, select_2436[12], 1'b0, select_2436[11], 1'b0, select_2436[10], 1'b0, select_2436[9], 1'b0, select_2436[8], 1'b0, select_2436[7], 1'b0, select_2436[6], 1'b0, select_2436[5], 1'b0, select_2436[4], 1'b0, select_2436[3], 1'b0, select_2436[2], 1'b0, select_2436[1], 1'b0, select_2436[0], 1'b0} : {1'b0, select_2436[23], 1'b0, select_2436[22], 1'b0, select_2436[21], 1'b0, select_2436[20], 1'b0, select_2436[19], 1'b0, select_2436[18], 1'b0, select_2436[17], 1'b0, select_2436[16], 1'b0, select_2436[15], 1'b0, select_2436[14], 1'b0, select_2436[13], 1'b0, select_2436[12], 1'b0, select_2436[11], 1'b0, select_2436[10], 1'b0, select_2436[9], 1'b0, select_2436[8], 1'b0, select_2436[7], 1'b0, select_2436[6], 1'b0, select_2436[5], 1'b0, select_2436[4], 1'b0, select_2436[3], 1'b0, select_2436[2], 1'b0, select_2436[1], 1'b0, select_2436[0]};
  // hls/stages/agreement.hpp:986
  logic and_2441;
  assign and_2441 = good_known_q & (~((good_q & select_2437) == 48'h0));
  // hls/stages/agreement.hpp:1055
  logic is_seen;
  assign is_seen = equal_2420_s4_q ? and_2441 : not_2456_s4_q;
  // hls/stages/agreement.hpp:1064
  logic and_2471;
  assign and_2471 = is_seen & less_2470_s4_q;
  // hls/stages/agreement.hpp:264
  logic [8:0] select_2505;
  assign select_2505 = sample_pair_whole_s4_q ? (and_502_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2507;
  assign select_2507 = sample_pair_whole_s4_q ? (and_502_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2509;
  assign select_2509 = sample_pair_whole_s4_q ? (and_502_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2511;
  assign select_2511 = sample_pair_whole_s4_q ? (and_502_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2516;
  assign sum_2516 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2517;
  assign difference_2517 = {1'b0, sum_2516[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2518;
  assign xor_2518 = {difference_2517[8:0], sum_2516[0]} ^ {10{difference_2517[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2517[9]} + {1'b0, xor_2518};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_507_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:264
  logic [13:0] select_2523;
  assign select_2523 = sample_pair_whole_s4_q ? (and_502_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2524;
  assign sum_2524 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2525;
  assign difference_2525 = {1'b0, sum_2524[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2526;
  assign xor_2526 = {difference_2525[8:0], sum_2524[0]} ^ {10{difference_2525[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2525[9]} + {1'b0, xor_2526};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_507_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:264
  logic [13:0] select_2531;
  assign select_2531 = sample_pair_whole_s4_q ? (and_502_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2614;
  assign sum_2614 = sum_2610_s4_q + {2'h0, sum_2613_s4_q};
  // hls/stages/agreement.hpp:508
  logic [11:0] select_2616;
  assign select_2616 = and_504_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2617;
  assign select_2617 = and_504_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2618;
  assign select_2618 = and_504_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2619;
  assign select_2619 = and_504_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2622;
  assign sum_2622 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2614};
  logic [13:0] sum_2624;
  assign sum_2624 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2622});
  // hls/stages/census.hpp:305
  logic and_2626;
  assign and_2626 = and_594_s4_q & (9'h4 < sum_2624[13:5]);
  // hls/stages/census.hpp:306
  logic and_2627;
  assign and_2627 = and_594_s4_q & less_618;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2628;
  assign sum_2628 = census_left_misses_q + {{17{and_2627}}, and_2626, 1'b0, and_2626};
  // hls/stages/agreement.hpp:508
  logic [19:0] select_2630;
  assign select_2630 = and_504_s4_q ? (equal_2621_s4_q ? 20'h0 : sum_2628) : census_left_misses_q;
  // hls/stages/agreement.hpp:264
  logic [27:0] select_2635;
  assign select_2635 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:508
  logic select_2638;
  assign select_2638 = and_504_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2641;
  assign and_2641 = whole_2_s4_q & (~(column_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:445
  logic and_2647;
  assign and_2647 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2648;
  assign and_2648 = and_2641 & and_2647;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2635[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2650;
  assign select_2650 = and_2648 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2652;
  assign select_2652 = equal_2621_s4_q ? {11'h0, select_2650} : (sharpness_sums_detail_0_q + {11'h0, select_2650});
  // hls/stages/agreement.hpp:445
  logic and_2659;
  assign and_2659 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2660;
  assign and_2660 = and_2641 & and_2659;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2635[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2662;
  assign select_2662 = and_2660 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2664;
  assign select_2664 = equal_2621_s4_q ? {11'h0, select_2662} : (sharpness_sums_detail_1_q + {11'h0, select_2662});
  logic [8:0] select_2667;
  assign select_2667 = and_2648 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2668;
  assign sum_2668 = (equal_2621_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2667};
  logic [8:0] select_2671;
  assign select_2671 = and_2660 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2672;
  assign sum_2672 = (equal_2621_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2671};
  // hls/stages/agreement.hpp:203
  logic equal_2674;
  assign equal_2674 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2675;
  assign less_2675 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2676;
  assign less_2676 = x_s4_q[4:0] < 5'h3;
  logic not_2677;
  assign not_2677 = ~x_s4_q[1];
  logic [2:0] select_2678;
  assign select_2678 = x_s4_q[0] ? {1'b0, not_2677, 1'b0} : {x_s4_q[1], 1'b0, not_2677};
  logic [5:0] select_2679;
  assign select_2679 = slot_s4_q[2] ? {select_2678[2], 1'b0, select_2678[1], 1'b0, select_2678[0], 1'b0} : {1'b0, select_2678[2], 1'b0, select_2678[1], 1'b0, select_2678[0]};
  logic [11:0] select_2680;
  assign select_2680 = slot_s4_q[1] ? {select_2679[5], 1'b0, select_2679[4], 1'b0, select_2679[3], 1'b0, select_2679[2], 1'b0, select_2679[1], 1'b0, select_2679[0], 1'b0} : {1'b0, select_2679[5], 1'b0, select_2679[4], 1'b0, select_2679[3], 1'b0, select_2679[2], 1'b0, select_2679[1], 1'b0, select_2679[0]};
  logic [23:0] select_2681;
  assign select_2681 = slot_s4_q[0] ? {select_2680[11], 1'b0, select_2680[10], 1'b0, select_2680[9], 1'b0, select_2680[8], 1'b0, select_2680[7], 1'b0, select_2680[6], 1'b0, select_2680[5], 1'b0, select_2680[4], 1'b0, select_2680[3], 1'b0, select_2680[2], 1'b0, select_2680[1], 1'b0, select_2680[0], 1'b0} : {1'b0, select_2680[11], 1'b0, select_2680[10], 1'b0, select_2680[9], 1'b0, select_2680[8], 1'b0, select_2680[7], 1'b0, select_2680[6], 1'b0, select_2680[5], 1'b0, select_2680[4], 1'b0, select_2680[3], 1'b0, select_2680[2], 1'b0, select_2680[1], 1'b0, select_2680[0]};
  // hls/stages/census.hpp:372
  logic and_2685;
  assign and_2685 = less_2676 & (~((sharpness_sums_contrast_1_q & select_2681) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2687;
  assign select_2687 = (less_2675 & and_2685) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2687};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2690;
  assign select_2690 = equal_2674 ? (less_2675 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2695;
  assign and_2695 = less_2676 & (~((sharpness_sums_contrast_0_q & select_2681) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2697;
  assign select_2697 = (less_2675 & and_2695) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2697};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2700;
  assign select_2700 = equal_2674 ? (less_2675 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2702;
  assign select_2702 = equal_2674 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2704;
  assign select_2704 = equal_2674 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2706;
  assign select_2706 = equal_2674 ? {sharpness_comparing_contrast_0_q[0], and_2695} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2708;
  assign select_2708 = equal_2674 ? {sharpness_comparing_contrast_1_q[0], and_2685} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:207
  logic select_2713;
  assign select_2713 = drew_q ? (equal_2674 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:207
  logic select_2717;
  assign select_2717 = drew_q ? (equal_2674 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2718;
  assign equal_2718 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2719;
  assign xor_2719 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2722;
  assign select_2722 = (equal_2718 | xor_2719) ? (five_times[0] & xor_2719) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2724;
  assign select_2724 = drew_q ? (equal_2674 ? select_2722 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2725;
  assign xor_2725 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2728;
  assign select_2728 = (equal_2718 | xor_2725) ? (five_times_2[0] & xor_2725) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2730;
  assign select_2730 = drew_q ? (equal_2674 ? select_2728 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2731;
  assign xor_2731 = sharpness_comparing_contrast_0_q[1] ^ and_2685;
  logic select_2734;
  assign select_2734 = (equal_2718 | xor_2731) ? (and_2685 & xor_2731) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2736;
  assign select_2736 = drew_q ? (equal_2674 ? select_2734 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2737;
  assign xor_2737 = sharpness_comparing_contrast_1_q[1] ^ and_2695;
  logic select_2740;
  assign select_2740 = (equal_2718 | xor_2737) ? (and_2695 & xor_2737) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2742;
  assign select_2742 = drew_q ? (equal_2674 ? select_2740 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2856;
  assign select_2856 = and_2850_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2854_s4_q});
  // hls/stages/agreement.hpp:773
  logic and_2859;
  assign and_2859 = not_1937_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2864;
  assign and_2864 = not_1937_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2869;
  assign and_2869 = not_1937_s4_q & (drew_q & (ends_cell_s4_q & and_2362_s4_q));
  // hls/stages/agreement.hpp:1057
  logic not_2873;
  assign not_2873 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1058
  logic not_2890;
  assign not_2890 = ~(equal_2420_s4_q ? and_2441 : not_2888_s4_q);
  // hls/stages/agreement.hpp:773
  logic and_2893;
  assign and_2893 = ends_cell_s4_q & (not_2873 & (centres_values_1_textured_s4_q & not_2890));
  logic and_2895;
  assign and_2895 = not_1937_s4_q & (drew_q & and_2893);
  // hls/stages/agreement.hpp:1084
  logic less_2898;
  assign less_2898 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2899;
  assign select_2899 = less_2898 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2902;
  assign select_2902 = less_2898 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1085
  logic [10:0] sum_2903;
  assign sum_2903 = {1'b0, select_2902} + {3'h0, select_2902[9:2]};
  logic and_2905;
  assign and_2905 = (~(select_2899[9:4] == 6'h0)) & ({sum_2903, select_2902[1:0]} < {3'h0, select_2899});
  // hls/stages/agreement.hpp:1094
  logic [9:0] select_2908;
  assign select_2908 = x_s4_q[6] ? (equal_1981_s4_q ? 10'h0 : (and_2905 ? select_2899 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:773
  logic [9:0] select_2909;
  assign select_2909 = equal_1936_s4_q ? select_2908 : 10'h0;
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2911;
  assign select_2911 = and_2850_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2909});
  logic [13:0] select_2918;
  assign select_2918 = and_2850_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2916_s4_q});
  // hls/stages/agreement.hpp:1062
  logic and_2920;
  assign and_2920 = not_2873 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:773
  logic and_2923;
  assign and_2923 = not_1937_s4_q & (drew_q & (ends_cell_s4_q & and_2920));
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2925;
  assign select_2925 = and_2850_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2923});
  // hls/stages/agreement.hpp:1062
  logic and_2927;
  assign and_2927 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2890);
  // hls/stages/agreement.hpp:773
  logic and_2931;
  assign and_2931 = not_1937_s4_q & (drew_q & (ends_cell_s4_q & (not_2873 & and_2927)));
  // hls/stages/agreement.hpp:899
  logic [13:0] select_2933;
  assign select_2933 = and_2850_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2931});
  // hls/stages/agreement.hpp:773
  logic [7:0] select_2982;
  assign select_2982 = drew_q ? (equal_2077_s4_q ? (and_2966_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2983;
  assign select_2983 = equal_1936_s4_q ? 8'h0 : select_2982;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2985;
  assign select_2985 = and_2965_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2983[7]}}, select_2983});
  // hls/stages/agreement.hpp:773
  logic and_2988;
  assign and_2988 = not_1937_s4_q & (drew_q & (and_2966_s4_q & equal_2077_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2990;
  assign select_2990 = and_2965_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2988});
  // hls/stages/registration.hpp:107
  logic and_2992;
  assign and_2992 = and_2966_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:773
  logic [1:0] select_2994;
  assign select_2994 = drew_q ? (equal_2077_s4_q ? {and_2992, and_2966_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2995;
  assign select_2995 = equal_1936_s4_q ? 2'h0 : select_2994;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2996;
  assign sum_2996 = registration_half_votes_down_q + {{5{select_2995[1]}}, select_2995};
  // hls/stages/agreement.hpp:773
  logic [1:0] select_3002;
  assign select_3002 = drew_q ? (equal_2077_s4_q ? {and_3000_s4_q, and_2966_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3003;
  assign select_3003 = equal_1936_s4_q ? 2'h0 : select_3002;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3004;
  assign sum_3004 = registration_half_votes_up_q + {{5{select_3003[1]}}, select_3003};
  // hls/stages/registration.hpp:107
  logic and_3007;
  assign and_3007 = and_2966_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:773
  logic [1:0] select_3009;
  assign select_3009 = drew_q ? (equal_2077_s4_q ? {and_3007, and_2966_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3010;
  assign select_3010 = equal_1936_s4_q ? 2'h0 : select_3009;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3011;
  assign sum_3011 = registration_half_half_votes_down_q + {{5{select_3010[1]}}, select_3010};
  // hls/stages/agreement.hpp:773
  logic [1:0] select_3016;
  assign select_3016 = drew_q ? (equal_2077_s4_q ? {and_3014_s4_q, and_2966_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3017;
  assign select_3017 = equal_1936_s4_q ? 2'h0 : select_3016;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3018;
  assign sum_3018 = registration_half_half_votes_up_q + {{5{select_3017[1]}}, select_3017};
  // hls/stages/agreement.hpp:773
  logic and_3052;
  assign and_3052 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & less_2012_s4_q));
  // hls/stages/agreement.hpp:1082
  logic [11:0] select_3059;
  assign select_3059 = or_2016_s4_q ? 12'h0 : (equal_3057_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1094
  logic [11:0] select_3062;
  assign select_3062 = x_s4_q[6] ? (equal_1981_s4_q ? 12'h0 : (less_2012_s4_q ? select_3059 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:773
  logic [11:0] select_3063;
  assign select_3063 = equal_1936_s4_q ? select_3062 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3064;
  assign and_3064 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1094
  logic and_3067;
  assign and_3067 = not_2341_s4_q & (less_2012_s4_q & ({and_3064, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:773
  logic and_3069;
  assign and_3069 = equal_1936_s4_q & (x_s4_q[6] & and_3067);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3071;
  assign sum_3071 = {{2{select_3063[11]}}, select_3063} + (and_3069 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1082
  logic [11:0] select_3074;
  assign select_3074 = or_2016_s4_q ? 12'h0 : (equal_3057_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1094
  logic [11:0] select_3077;
  assign select_3077 = x_s4_q[6] ? (equal_1981_s4_q ? 12'h0 : (less_2012_s4_q ? select_3074 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:773
  logic [11:0] select_3078;
  assign select_3078 = equal_1936_s4_q ? select_3077 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3080;
  assign sum_3080 = {{2{select_3078[11]}}, select_3078} + (and_3069 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3082;
  assign not_3082 = ~all_s4_q;
  // hls/stages/agreement.hpp:1094
  logic and_3085;
  assign and_3085 = not_2341_s4_q & (less_2012_s4_q & (x_s4_q[2:0] == {all_s4_q, not_3082, 1'b0}));
  // hls/stages/agreement.hpp:773
  logic and_3091;
  assign and_3091 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & (less_2012_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_3092;
  assign not_3092 = ~and_3091;
  logic less_3093;
  assign less_3093 = $signed({9'h1, {2{not_3092}}, and_3091}) < $signed(registration_up_q[13:2]);
  logic select_3094;
  assign select_3094 = (equal_1936_s4_q & (x_s4_q[6] & and_3085)) ? less_3093 : registration_enough_q;
  // hls/stages/agreement.hpp:1094
  logic and_3098;
  assign and_3098 = x_s4_q[6] & (not_2341_s4_q & (less_2012_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:773
  logic and_3099;
  assign and_3099 = equal_1936_s4_q & and_3098;
  // hls/stages/registration.hpp:242
  logic less_3100;
  assign less_3100 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3102;
  assign less_3102 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3104;
  assign equal_3104 = x_s4_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:773
  logic and_3108;
  assign and_3108 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & (less_2012_s4_q & equal_3104)));
  // hls/stages/agreement.hpp:1094
  logic and_3115;
  assign and_3115 = x_s4_q[6] & (not_2341_s4_q & (less_2012_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3118;
  assign equal_3118 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1094
  logic and_3121;
  assign and_3121 = not_2341_s4_q & (less_2012_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_3118));
  // hls/stages/registration.hpp:244
  logic and_3125;
  assign and_3125 = (equal_1936_s4_q & (x_s4_q[6] & and_3121)) & (less_3102 | less_3100);
  // hls/stages/agreement.hpp:1094
  logic and_3130;
  assign and_3130 = not_2341_s4_q & (less_2012_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_3118)));
  // hls/stages/registration.hpp:244
  logic and_3133;
  assign and_3133 = registration_votes_up_q & registration_other_down_q;
  logic select_3135;
  assign select_3135 = registration_votes_down_q ? (registration_other_up_q | and_3133) : and_3133;
  // hls/stages/registration.hpp:138
  logic and_3137;
  assign and_3137 = (equal_1936_s4_q & (x_s4_q[6] & and_3130)) & (registration_other_enough_q & select_3135);
  // hls/stages/registration.hpp:245
  logic or_3140;
  assign or_3140 = registration_moved_q | (registration_enough_q & (and_3125 | and_3137));
  // hls/stages/agreement.hpp:264
  logic [7:0] select_3225;
  assign select_3225 = sample_pair_whole_s4_q ? (equal_2067_s4_q ? patches_place_0_slope_q : select_2168[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3230;
  assign select_3230 = sample_pair_whole_s4_q ? (equal_2067_s4_q ? patches_place_1_slope_q : select_2197[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:119
  logic select_3232;
  assign select_3232 = equal_2067_s4_q ? patches_valid_0_q : (select_2066_s4_q ? patches_valid_0_q : select_2165[0]);
  // hls/stages/agreement.hpp:264
  logic select_3235;
  assign select_3235 = sample_pair_whole_s4_q ? (and_2188 ? (sample_present_s4_q & select_3232) : select_3232) : patches_valid_0_q;
  // hls/stages/patches.hpp:119
  logic select_3237;
  assign select_3237 = equal_2067_s4_q ? patches_valid_1_q : (select_2066_s4_q ? select_2165[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:264
  logic select_3240;
  assign select_3240 = sample_pair_whole_s4_q ? (and_2208 ? (sample_present_s4_q & select_3237) : select_3237) : patches_valid_1_q;
  logic [5:0] select_3243;
  assign select_3243 = sample_pair_whole_s4_q ? (select_2186[5] ? {1'b1, select_2186[4:0]} : (select_2186 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3246;
  assign select_3246 = sample_pair_whole_s4_q ? (select_2206[5] ? {1'b1, select_2206[4:0]} : (select_2206 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3249;
  assign select_3249 = sample_pair_whole_s4_q ? (select_2219[4] ? {1'b1, select_2219[3:0]} : (select_2219 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3252;
  assign select_3252 = sample_pair_whole_s4_q ? (select_2224[4] ? {1'b1, select_2224[3:0]} : (select_2224 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:511
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3671_s4_q, parity_3667_s4_q, xor_3655_s4_q, parity_3627_s4_q, parity_3565_s4_q, parity_3436_s4_q} + (equal_3672_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:176
  logic [9:0] select_3676;
  assign select_3676 = equal_2149_s4_q ? patches_sums_values_0_q : (equal_2151_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3677;
  assign select_3677 = equal_2151_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3679;
  assign select_3679 = equal_2151_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3681;
  assign select_3681 = equal_2151_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3683;
  assign select_3683 = equal_2151_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3685;
  assign select_3685 = equal_2151_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3687;
  assign select_3687 = equal_2151_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3689;
  assign select_3689 = equal_2151_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3691;
  assign select_3691 = equal_2151_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3693;
  assign select_3693 = equal_2151_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3695;
  assign select_3695 = equal_2151_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3697;
  assign select_3697 = equal_2151_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3699;
  assign select_3699 = equal_2151_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3701;
  assign select_3701 = equal_2151_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3703;
  assign select_3703 = equal_2151_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3705;
  assign select_3705 = equal_2151_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3707;
  assign select_3707 = equal_2151_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:585
  logic or_3812;
  assign or_3812 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3811_s4_q;
  logic or_3815;
  assign or_3815 = equal_3803_s4_q | (less_3805_s4_q | (less_3806_s4_q | or_3812));
  // hls/stages/patches.hpp:565
  logic not_3816;
  assign not_3816 = ~or_3815;
  // hls/stages/patches.hpp:546
  logic and_3817;
  assign and_3817 = equal_2315_s4_q & not_3816;
  // hls/stages/patches.hpp:176
  logic and_3820;
  assign and_3820 = equal_2149_s4_q & (less_2312_s4_q ? (not_2314_s4_q & and_3817) : and_3817);
  // hls/stages/patches.hpp:636
  logic not_3821;
  assign not_3821 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:546
  logic and_3823;
  assign and_3823 = equal_2315_s4_q & (patches_second_s4_q & not_3816);
  // hls/stages/patches.hpp:176
  logic and_3826;
  assign and_3826 = equal_2149_s4_q & (less_2312_s4_q ? (not_2314_s4_q & and_3823) : and_3823);
  // hls/stages/patches.hpp:636
  logic not_3827;
  assign not_3827 = ~and_3826;
  // hls/stages/patches.hpp:180
  logic and_3829;
  assign and_3829 = and_3820 & (not_3821 & not_3827);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3831;
  assign sum_3831 = {7'h0, and_3829} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:583
  logic [7:0] select_3857;
  assign select_3857 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:582
  logic [5:0] select_3858;
  assign select_3858 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3859;
  assign sum_3859 = {2'h0, select_3791_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3860;
  assign sum_3860 = {select_3858[5], select_3858} + {{3{sum_3859[3]}}, sum_3859};
  // hls/stages/patches.hpp:583
  logic [17:0] product_3861;
  assign product_3861 = $signed({{10{select_3857[7]}}, select_3857}) * $signed({{8{sum_3860[6]}}, sum_3860, select_3791_s4_q[2:0]});
  // hls/stages/patches.hpp:584
  logic [13:0] difference_3862;
  assign difference_3862 = {{6{select_3856_s4_q[7]}}, select_3856_s4_q} - {product_3861[17], product_3861[17:5]};
  // hls/stages/patches.hpp:590
  logic less_3863;
  assign less_3863 = $signed({{7{difference_3833[6]}}, difference_3833}) < $signed(difference_3862);
  // hls/stages/patches.hpp:546
  logic and_3866;
  assign and_3866 = equal_2315_s4_q & (not_3816 & (~less_3863));
  // hls/stages/patches.hpp:176
  logic and_3869;
  assign and_3869 = equal_2149_s4_q & (less_2312_s4_q ? (not_2314_s4_q & and_3866) : and_3866);
  // hls/stages/patches.hpp:639
  logic and_3870;
  assign and_3870 = and_3869 & and_3829;
  logic [7:0] sum_3871;
  assign sum_3871 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3870};
  // hls/stages/patches.hpp:546
  logic and_3875;
  assign and_3875 = not_3816 & (~($signed(difference_3862) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3876;
  assign and_3876 = equal_2315_s4_q & and_3875;
  // hls/stages/patches.hpp:176
  logic and_3879;
  assign and_3879 = equal_2149_s4_q & (less_2312_s4_q ? (not_2314_s4_q & and_3876) : and_3876);
  // hls/stages/patches.hpp:640
  logic and_3880;
  assign and_3880 = and_3879 & and_3829;
  logic [7:0] sum_3881;
  assign sum_3881 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3880};
  // hls/stages/patches.hpp:180
  logic and_3883;
  assign and_3883 = and_3820 & (and_3826 & not_3821);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3885;
  assign sum_3885 = {7'h0, and_3883} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:639
  logic and_3887;
  assign and_3887 = and_3869 & and_3883;
  logic [7:0] sum_3888;
  assign sum_3888 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3887};
  // hls/stages/patches.hpp:640
  logic and_3890;
  assign and_3890 = and_3879 & and_3883;
  logic [7:0] sum_3891;
  assign sum_3891 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3890};
  // hls/stages/patches.hpp:180
  logic and_3893;
  assign and_3893 = and_3820 & (patches_lower_s4_q & not_3827);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3895;
  assign sum_3895 = {7'h0, and_3893} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:639
  logic and_3897;
  assign and_3897 = and_3869 & and_3893;
  logic [7:0] sum_3898;
  assign sum_3898 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3897};
  // hls/stages/patches.hpp:640
  logic and_3900;
  assign and_3900 = and_3879 & and_3893;
  logic [7:0] sum_3901;
  assign sum_3901 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3900};
  // hls/stages/patches.hpp:180
  logic and_3903;
  assign and_3903 = and_3820 & (patches_lower_s4_q & and_3826);
  // hls/stages/patches.hpp:638
  logic [7:0] sum_3905;
  assign sum_3905 = {7'h0, and_3903} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:639
  logic and_3907;
  assign and_3907 = and_3869 & and_3903;
  logic [7:0] sum_3908;
  assign sum_3908 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3907};
  // hls/stages/patches.hpp:640
  logic and_3910;
  assign and_3910 = and_3879 & and_3903;
  logic [7:0] sum_3911;
  assign sum_3911 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3910};
  // hls/stages/agreement.hpp:1164
  logic equal_3912;
  assign equal_3912 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1082
  logic less_3913;
  assign less_3913 = x_s4_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:773
  logic and_3917;
  assign and_3917 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & (equal_3912 & less_3913)));
  // hls/stages/agreement.hpp:1094
  logic and_3922;
  assign and_3922 = x_s4_q[6] & (not_2341_s4_q & (less_3913 & (x_s4_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:773
  logic and_3923;
  assign and_3923 = equal_1936_s4_q & and_3922;
  // hls/stages/patches.hpp:607
  logic [7:0] or_3925;
  assign or_3925 = (and_3917 ? patches_quarters_0_places_q : 8'h0) | (and_3923 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1094
  logic and_3929;
  assign and_3929 = x_s4_q[6] & (not_2341_s4_q & (less_3913 & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:773
  logic and_3930;
  assign and_3930 = equal_1936_s4_q & and_3929;
  // hls/stages/agreement.hpp:1094
  logic and_3936;
  assign and_3936 = x_s4_q[6] & (not_2341_s4_q & (less_3913 & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:773
  logic and_3937;
  assign and_3937 = equal_1936_s4_q & and_3936;
  // hls/stages/patches.hpp:607
  logic [7:0] or_3939;
  assign or_3939 = (or_3925 | (and_3930 ? patches_quarters_2_places_q : 8'h0)) | (and_3937 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:191
  logic select_3943;
  assign select_3943 = (x_s4_q[5:3] == 3'h2) ? x_s4_q[1] : (x_s4_q[0] & (x_s4_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:773
  logic and_3947;
  assign and_3947 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & (less_3913 & select_3943)));
  // hls/stages/patches.hpp:608
  logic [7:0] select_3949;
  assign select_3949 = and_3917 ? (and_3947 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3951;
  assign select_3951 = and_3923 ? (and_3947 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3954;
  assign select_3954 = and_3930 ? (and_3947 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3957;
  assign select_3957 = and_3937 ? (and_3947 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:609
  logic [7:0] select_3960;
  assign select_3960 = and_3917 ? (and_3947 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3962;
  assign select_3962 = and_3923 ? (and_3947 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3965;
  assign select_3965 = and_3930 ? (and_3947 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3968;
  assign select_3968 = and_3937 ? (and_3947 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:194
  logic [4:0] sum_3970;
  assign sum_3970 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1094
  logic and_3974;
  assign and_3974 = x_s4_q[6] & (not_2341_s4_q & (less_3913 & (sum_3970[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:773
  logic and_3975;
  assign and_3975 = equal_1936_s4_q & and_3974;
  // hls/stages/patches.hpp:604
  logic [7:0] select_3978;
  assign select_3978 = and_3975 ? (patches_word_places_q + (and_3923 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3981;
  assign select_3981 = and_3975 ? (patches_word_up_q + (and_3923 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3984;
  assign select_3984 = and_3975 ? (patches_word_down_q + (and_3923 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3988;
  assign select_3988 = ($signed(difference_3862[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3862[5:0];
  logic [5:0] select_3989;
  assign select_3989 = ($signed(14'h10) < $signed(difference_3862)) ? 6'h10 : select_3988;
  // hls/stages/patches.hpp:546
  logic [5:0] select_3991;
  assign select_3991 = equal_2315_s4_q ? (or_3815 ? 6'h0 : select_3989) : 6'h0;
  logic [5:0] select_3993;
  assign select_3993 = less_2312_s4_q ? (equal_2313_s4_q ? 6'h0 : select_3991) : select_3991;
  // hls/stages/patches.hpp:642
  logic [5:0] select_3995;
  assign select_3995 = and_3820 ? (equal_2149_s4_q ? select_3993 : 6'h0) : 6'h0;
  logic [11:0] sum_3996;
  assign sum_3996 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3995[5]}}, select_3995};
  // hls/stages/agreement.hpp:773
  logic and_4000;
  assign and_4000 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & (equal_3104 & less_3913)));
  // hls/stages/agreement.hpp:1094
  logic and_4004;
  assign and_4004 = x_s4_q[6] & (not_2341_s4_q & (less_3913 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:773
  logic and_4005;
  assign and_4005 = equal_1936_s4_q & and_4004;
  // hls/stages/patches.hpp:629
  logic [7:0] select_4007;
  assign select_4007 = and_4000 ? (and_4005 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:631
  logic or_4011;
  assign or_4011 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:632
  logic or_4014;
  assign or_4014 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:633
  logic [8:0] sum_4015;
  assign sum_4015 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:628
  logic select_4017;
  assign select_4017 = and_4000 ? (and_4005 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/agreement.hpp:773
  logic and_4022;
  assign and_4022 = equal_1936_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_4019_s4_q));
  // hls/stages/patches.hpp:180
  logic and_4024;
  assign and_4024 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:628
  logic [2:0] select_4026;
  assign select_4026 = and_4005 ? {and_4024, patches_found_q[2:1]} : (and_4000 ? {and_4024, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:627
  logic or_4030;
  assign or_4030 = patches_partly_q | (patches_doubted_q & (~and_4005));
  // hls/stages/patches.hpp:628
  logic select_4033;
  assign select_4033 = and_4000 ? (and_4005 ? or_4030 : (and_4000 ? or_4030 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:626
  logic select_4034;
  assign select_4034 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:617
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:618
  logic select_4044;
  assign select_4044 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:619
  logic and_4050;
  assign and_4050 = patches_frame_ended_q & (~patches_age_q[9]);
  logic [9:0] sum_4051;
  assign sum_4051 = patches_age_q + {9'h0, and_4050};
  logic [9:0] select_4054;
  assign select_4054 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4051)) : sum_4051;
  // hls/stages/agreement.hpp:1136
  logic or_4111;
  assign or_4111 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1158
  logic equal_4113;
  assign equal_4113 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1167
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1168
  logic select_4119;
  assign select_4119 = (equal_4113 & equal_3912) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1087
  logic [10:0] sum_4122;
  assign sum_4122 = {1'b0, select_2902} + {2'h0, select_2902[9:1]};
  logic select_4125;
  assign select_4125 = (select_2899[9:3] == 7'h0) ? ((~or_4111) & (~select_4119)) : (~({sum_4122, select_2902[0]} < {2'h0, select_2899}));
  // hls/stages/agreement.hpp:1094
  logic [47:0] select_4127;
  assign select_4127 = x_s4_q[6] ? (equal_1981_s4_q ? good_q : {select_4125, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:773
  logic select_4131;
  assign select_4131 = equal_1936_s4_q ? ((x_s4_q[6] & good_known_q) | equal_4019_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1158
  logic equal_4132;
  assign equal_4132 = x_s4_q[6:3] == 4'ha;
  logic equal_4134;
  assign equal_4134 = x_s4_q[6:3] == 4'h9;
  logic equal_4135;
  assign equal_4135 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1077
  logic [13:0] select_4137;
  assign select_4137 = equal_4134 ? counts_skin_unproven_q : (equal_4135 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4132 ? counts_nearer_q : select_4137;
  // hls/stages/agreement.hpp:1163
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1171
  logic select_4140;
  assign select_4140 = (equal_4132 & equal_3912) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1096
  logic not_4141;
  assign not_4141 = ~hidden_for_q[7];
  logic [7:0] select_4143;
  assign select_4143 = select_4140 ? (hidden_for_q + {7'h0, not_4141}) : 8'h0;
  // hls/stages/agreement.hpp:773
  logic [7:0] select_4145;
  assign select_4145 = equal_1936_s4_q ? (equal_4019_s4_q ? select_4143 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1171
  logic [13:0] select_4146;
  assign select_4146 = equal_3912 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1077
  logic [7:0] select_4148;
  assign select_4148 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4150;
  assign select_4150 = equal_4135 ? cfg_unproven_skin_limit_i : (equal_4113 ? cfg_unproven_limit_i : select_4148);
  logic [7:0] limit;
  assign limit = equal_4132 ? cfg_regions_limit_i : (equal_4134 ? cfg_hidden_limit_i : select_4150);
  // hls/stages/agreement.hpp:1171
  logic not_4153;
  assign not_4153 = ~x_s4_q[2];
  logic [3:0] select_4154;
  assign select_4154 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_4153, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_4153};
  logic [7:0] select_4155;
  assign select_4155 = x_s4_q[0] ? {select_4154[3], 1'b0, select_4154[2], 1'b0, select_4154[1], 1'b0, select_4154[0], 1'b0} : {1'b0, select_4154[3], 1'b0, select_4154[2], 1'b0, select_4154[1], 1'b0, select_4154[0]};
  // hls/stages/agreement.hpp:1077
  logic [13:0] select_4159;
  assign select_4159 = equal_4134 ? counts_skin_supervised_q : (equal_4135 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_4132 ? counts_textured_q : select_4159;
  // hls/stages/agreement.hpp:1171
  logic [13:0] select_4161;
  assign select_4161 = ((limit & select_4155) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4146} + {1'b0, select_4161};
  // hls/stages/agreement.hpp:773
  logic select_4166;
  assign select_4166 = equal_1936_s4_q ? (equal_3912 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1169
  logic and_4171;
  assign and_4171 = too_much_q & (~(equal_4135 & equal_3912));
  // hls/stages/agreement.hpp:1170
  logic select_4176;
  assign select_4176 = (over[14] & equal_3912) ? (and_4171 | ((equal_4135 | equal_4134) | (x_s4_q[6:3] == 4'hf))) : and_4171;
  // hls/stages/agreement.hpp:1245
  logic [1:0] select_4294;
  assign select_4294 = and_4293_s4_q ? {and_2471, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1246
  logic and_4295;
  assign and_4295 = proven_q & less_4283;
  // hls/stages/agreement.hpp:425
  logic select_4298;
  assign select_4298 = and_2401_s4_q ? (less_2402_s4_q ? (select_4294[0] & and_4295) : seen_q) : seen_q;
  logic select_4301;
  assign select_4301 = and_2401_s4_q ? (less_2402_s4_q ? (select_4294[1] & and_4295) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1179
  logic or_4309;
  assign or_4309 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4308_s4_q;
  // hls/stages/agreement.hpp:1181
  logic not_4317;
  assign not_4317 = ~(or_4111 | not_4302);
  // hls/stages/agreement.hpp:773
  logic and_4321;
  assign and_4321 = equal_1936_s4_q & (equal_4019_s4_q & (not_4317 & (select_4119 | select_4176)));
  logic and_4324;
  assign and_4324 = equal_4019_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1098
  logic or_4328;
  assign or_4328 = select_2724 | (select_2736 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:773
  logic and_4335;
  assign and_4335 = equal_1936_s4_q & (equal_4019_s4_q & (not_4317 & (select_2730 | select_2742)));
  // hls/stages/agreement.hpp:1098
  logic and_4340;
  assign and_4340 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4143 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:773
  logic and_4347;
  assign and_4347 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1092
  logic [31:0] select_4355;
  assign select_4355 = equal_2003_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4353_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4356;
  assign select_4356 = equal_2001_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4355;
  logic [31:0] select_4357;
  assign select_4357 = equal_1999_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4356;
  logic [31:0] select_4358;
  assign select_4358 = equal_1997_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_4357;
  logic [31:0] select_4359;
  assign select_4359 = equal_1995_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_4358;
  logic [31:0] select_4360;
  assign select_4360 = equal_1993_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4359;
  logic [31:0] select_4361;
  assign select_4361 = equal_1991_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4360;
  logic [31:0] select_4362;
  assign select_4362 = equal_1989_s4_q ? {9'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4361;
  // hls/stages/agreement.hpp:1090
  logic [9:0] select_4363;
  assign select_4363 = less_2898 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1094
  logic [31:0] select_4364;
  assign select_4364 = equal_1981_s4_q ? select_4362 : {2'h0, select_4363, select_2902, select_2899};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_504_s4_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s4_q, and_619, and_595_s4_q, and_594_s4_q, and_569_s4_q, less_561_s4_q, less_560_s4_q, less_559_s4_q, less_558_s4_q, less_557_s4_q, less_556_s4_q, less_555_s4_q, less_554_s4_q, less_553_s4_q, less_552_s4_q, less_551_s4_q, less_550_s4_q, less_549_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q, less_545_s4_q, less_544_s4_q, less_543_s4_q, less_542_s4_q, less_541_s4_q, less_540_s4_q, less_539_s4_q, less_538_s4_q};
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
  assign registration_sums_waddr = {sum_1987_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_2046_s4_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2045, sum_2041};
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
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_2075_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_2148_s4_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2141_s4_q};
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
  assign patches_right_0_waddr = {select_2179_s4_q, select_2176};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_2188);
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
  assign patches_right_1_waddr = {select_2179_s4_q, select_2205};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_2208);
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
  assign patches_left_waddr = {select_2227, select_2226_s4_q, column_7};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_2233);
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
  assign patches_rows_wdata = select_2329;
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
  assign regions_waddr = {region_row_s4_q, or_2339_s4_q, or_2336_s4_q, or_2333_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_2367_s4_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2366, sum_2360, sum_2355};
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
  assign map_waddr = {sum_2407_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_2481_s4_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2471, is_seen};
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
      census_left_misses_q <= select_2630;
      sharpness_before_last_mask_q <= select_2638;
      sharpness_sums_detail_0_q <= and_504_s4_q ? select_2652 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_504_s4_q ? select_2664 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_504_s4_q ? sum_2668 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_504_s4_q ? sum_2672 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2690 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2700 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2702 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2704 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2706 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2708 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2713;
      sharpness_comparing_carry_1_q <= select_2717;
      sharpness_comparing_less_detail_0_q <= select_2724;
      sharpness_comparing_less_detail_1_q <= select_2730;
      sharpness_comparing_less_contrast_0_q <= select_2736;
      sharpness_comparing_less_contrast_1_q <= select_2742;
      counts_supervised_q <= select_2856;
      counts_textured_q <= and_2850_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2859});
      counts_explained_q <= and_2850_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2864});
      counts_nearer_q <= and_2850_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2869});
      counts_unproven_q <= and_2850_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2895});
      counts_regions_bad_q <= select_2911;
      counts_skin_supervised_q <= select_2918;
      counts_skin_textured_q <= select_2925;
      counts_skin_unproven_q <= select_2933;
      registration_half_across_q <= select_2985;
      registration_half_measured_q <= select_2990;
      registration_half_votes_down_q <= and_2965_s4_q ? 7'h0 : sum_2996;
      registration_half_votes_up_q <= and_2965_s4_q ? 7'h0 : sum_3004;
      registration_half_half_votes_down_q <= and_2965_s4_q ? 7'h0 : sum_3011;
      registration_half_half_votes_up_q <= and_2965_s4_q ? 7'h0 : sum_3018;
      registration_down_q <= and_3052 ? sum_3071 : registration_down_q;
      registration_up_q <= and_3052 ? sum_3080 : registration_up_q;
      registration_enough_q <= select_3094;
      registration_votes_down_q <= and_3099 ? less_3100 : registration_votes_down_q;
      registration_votes_up_q <= and_3099 ? less_3102 : registration_votes_up_q;
      registration_other_enough_q <= and_3108 ? select_3094 : registration_other_enough_q;
      registration_other_down_q <= and_3108 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3108 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1936_s4_q & and_3115)) & or_3140;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_2167 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_2169 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_2170 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3225;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_2196 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_2198 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_2199 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3230;
      patches_valid_0_q <= select_3235;
      patches_valid_1_q <= select_3240;
      patches_right_next_0_q <= select_3243;
      patches_right_next_1_q <= select_3246;
      patches_left_next_0_q <= select_3249;
      patches_left_next_1_q <= select_3252;
      patches_sums_values_0_q <= select_3676;
      patches_sums_values_1_q <= equal_2149_s4_q ? patches_sums_values_1_q : select_3677;
      patches_sums_values_2_q <= equal_2149_s4_q ? patches_sums_values_2_q : select_3679;
      patches_sums_values_3_q <= equal_2149_s4_q ? patches_sums_values_3_q : select_3681;
      patches_sums_values_4_q <= equal_2149_s4_q ? patches_sums_values_4_q : select_3683;
      patches_sums_values_5_q <= equal_2149_s4_q ? patches_sums_values_5_q : select_3685;
      patches_sums_values_6_q <= equal_2149_s4_q ? patches_sums_values_6_q : select_3687;
      patches_sums_values_7_q <= equal_2149_s4_q ? patches_sums_values_7_q : select_3689;
      patches_sums_values_8_q <= equal_2149_s4_q ? patches_sums_values_8_q : select_3691;
      patches_sums_values_9_q <= equal_2149_s4_q ? patches_sums_values_9_q : select_3693;
      patches_sums_values_10_q <= equal_2149_s4_q ? patches_sums_values_10_q : select_3695;
      patches_sums_values_11_q <= equal_2149_s4_q ? patches_sums_values_11_q : select_3697;
      patches_sums_values_12_q <= equal_2149_s4_q ? patches_sums_values_12_q : select_3699;
      patches_sums_values_13_q <= equal_2149_s4_q ? patches_sums_values_13_q : select_3701;
      patches_sums_values_14_q <= equal_2149_s4_q ? patches_sums_values_14_q : select_3703;
      patches_sums_values_15_q <= equal_2149_s4_q ? patches_sums_values_15_q : select_3705;
      patches_sums_values_16_q <= equal_2149_s4_q ? patches_sums_values_16_q : select_3707;
      patches_best_differing_q <= select_2329[9:0];
      patches_best_column_q <= select_2329[14:10];
      patches_quarters_0_places_q <= sum_3831;
      patches_quarters_0_up_q <= sum_3871;
      patches_quarters_0_down_q <= sum_3881;
      patches_quarters_1_places_q <= sum_3885;
      patches_quarters_1_up_q <= sum_3888;
      patches_quarters_1_down_q <= sum_3891;
      patches_quarters_2_places_q <= sum_3895;
      patches_quarters_2_up_q <= sum_3898;
      patches_quarters_2_down_q <= sum_3901;
      patches_quarters_3_places_q <= sum_3905;
      patches_quarters_3_up_q <= sum_3908;
      patches_quarters_3_down_q <= sum_3911;
      patches_word_places_q <= or_3939;
      patches_word_up_q <= ((select_3949 | select_3951) | select_3954) | select_3957;
      patches_word_down_q <= ((select_3960 | select_3962) | select_3965) | select_3968;
      patches_sum_places_q <= select_3978;
      patches_sum_up_q <= select_3981;
      patches_sum_down_q <= select_3984;
      patches_across_q <= sum_3996;
      patches_places_q <= select_4007;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4011;
      patches_partly_q <= or_4014;
      patches_clear_limit_q <= sum_4015[8:2];
      patches_complete_q <= select_4017;
      patches_frame_ended_q <= and_4022;
      patches_round_ends_q <= patches_complete_q & and_4022;
      patches_found_q <= and_4000 ? select_4026 : patches_found_q;
      patches_doubted_q <= select_4033;
      patches_doubted_before_q <= select_4034;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4044;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4054;
      segment_textured_q <= select_2352 + {6'h0, and_2859};
      segment_explained_q <= select_2357 + {6'h0, and_2864};
      segment_nearer_q <= select_2363 + {6'h0, and_2869};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1936_s4_q ? select_4127 : good_q;
      good_known_q <= select_4131;
      hidden_for_q <= select_4145;
      product_q <= equal_1936_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4166;
      disagree_q <= equal_1936_s4_q ? select_4119 : disagree_q;
      too_much_q <= equal_1936_s4_q ? select_4176 : too_much_q;
      hides_q <= equal_1936_s4_q ? select_4140 : hides_q;
      seen_q <= select_4298;
      nearer_q <= select_4301;
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
      averager_quarter_1_0_q <= select_2505;
      averager_quarter_1_1_q <= select_2507;
      averager_quarter_2_0_q <= select_2509;
      averager_quarter_2_1_q <= select_2511;
      averager_detail_0_q <= select_2523;
      averager_detail_1_q <= select_2531;
      census_changes_values_0_left_q <= and_504_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_504_s4_q ? sum_2614 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2616;
      census_changes_values_1_right_q <= select_2617;
      census_changes_values_2_left_q <= select_2618;
      census_changes_values_2_right_q <= select_2619;
      sharpness_last_mask_q <= and_504_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_504_s4_q ? select_2635[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_504_s4_q ? select_2635[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_4278_s5_q;
  logic or_4303_s5_q;
  logic and_4304_s5_q;
  logic and_4312_s5_q;
  logic and_4315_s5_q;
  logic and_4321_s5_q;
  logic and_4325_s5_q;
  logic and_4331_s5_q;
  logic and_4335_s5_q;
  logic and_4343_s5_q;
  logic and_4347_s5_q;
  logic [5:0] select_4349_s5_q;
  logic [31:0] select_4366_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_0_q;
      pixel_1_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_4278_s5_q <= said_q;
      or_4303_s5_q <= not_4302 | select_4298;
      and_4304_s5_q <= cfg_prove_i & select_4301;
      and_4312_s5_q <= equal_1936_s4_q & (equal_4019_s4_q & (cfg_prove_i & or_4309));
      and_4315_s5_q <= equal_1936_s4_q & (equal_4019_s4_q & (cfg_prove_i & or_4111));
      and_4321_s5_q <= and_4321;
      and_4325_s5_q <= equal_1936_s4_q & and_4324;
      and_4331_s5_q <= equal_1936_s4_q & (equal_4019_s4_q & (not_4317 & or_4328));
      and_4335_s5_q <= and_4335;
      and_4343_s5_q <= equal_1936_s4_q & (equal_4019_s4_q & (cfg_prove_i & and_4340));
      and_4347_s5_q <= and_4347;
      select_4349_s5_q <= equal_1936_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_4366_s5_q <= equal_1936_s4_q ? (x_s4_q[6] ? select_4364 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4303_s5_q;
  assign marks_nearer_o = and_4304_s5_q;
  assign verdict_valid_o = and_4278_s5_q;
  assign verdict_unproven_yet_o = and_4312_s5_q;
  assign verdict_untextured_o = and_4315_s5_q;
  assign verdict_disagree_o = and_4321_s5_q;
  assign verdict_moved_o = and_4325_s5_q;
  assign verdict_unsharp_left_o = and_4331_s5_q;
  assign verdict_unsharp_right_o = and_4335_s5_q;
  assign verdict_hidden_o = and_4343_s5_q;
  assign frame_valid_o = and_4347_s5_q;
  assign frame_index_o = select_4349_s5_q;
  assign frame_word_o = select_4366_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_4015[1:0], sum_3970[1:0], product_3861[4:0], sum_2955[0], detail_4[1:0], detail_3[1:0], sum_2624[4:0], sum_2089[0], sum_2085[0], sum_617[4:0], cfg_width_i[2:0]};

endmodule
