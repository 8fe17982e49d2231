// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2879 bits, pipeline 912 bits, memories 99800 bits.
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
  logic [6:0] difference_3825;
  assign difference_3825 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_4053;
  assign difference_4053 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4255;
  assign less_4255 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4256;
  assign sum_4256 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_4274;
  assign not_4274 = ~cfg_prove_i;

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
  logic [2:0] select_458;
  assign select_458 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_460;
  assign select_460 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [8:0] select_463;
  assign select_463 = ({select_460, select_458} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_464;
  assign select_464 = select_458[0] ? averager_place_q : select_463;
  // hls/stages/census.hpp:41
  logic or_465;
  assign or_465 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_468;
  assign and_468 = (select_458[0] & or_465) & (select_464[8:6] < 3'h5);
  // hls/stages/census.hpp:41
  logic [2:0] select_473;
  assign select_473 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_460 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_490;
  assign equal_490 = select_458 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_491;
  assign equal_491 = select_473 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_492;
  assign and_492 = equal_491 & and_468;
  // hls/stages/agreement.hpp:263
  logic and_494;
  assign and_494 = sample_pair_whole_q & (equal_490 & and_492);
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:610
  logic equal_514;
  assign equal_514 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:581
  logic or_515;
  assign or_515 = so | equal_514;
  logic not_516;
  assign not_516 = ~or_515;
  // hls/stages/agreement.hpp:601
  logic equal_517;
  assign equal_517 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_519;
  assign equal_519 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:579
  logic [7:0] sum_520;
  assign sum_520 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_521;
  assign select_521 = run_shift_q[5] ? x_q : sum_520;
  logic less_522;
  assign less_522 = {1'b0, last_q} < select_521;
  // hls/stages/agreement.hpp:216
  logic not_523;
  assign not_523 = ~less_522;
  // hls/stages/agreement.hpp:141
  logic and_524;
  assign and_524 = equal_519 & not_523;
  logic and_526;
  assign and_526 = not_516 & ((~equal_517) & and_524);
  // hls/stages/census.hpp:41
  logic [5:0] select_553;
  assign select_553 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_553 : 6'h0;
  // hls/stages/agreement.hpp:141
  logic select_610;
  assign select_610 = equal_517 ? not_523 : and_524;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:141
  logic and_634;
  assign and_634 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_521)));
  logic and_635;
  assign and_635 = equal_517 & and_634;
  logic select_636;
  assign select_636 = or_515 ? not_523 : and_635;
  // hls/stages/agreement.hpp:778
  logic equal_639;
  assign equal_639 = {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:782
  logic or_641;
  assign or_641 = equal_639 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:794
  logic [6:0] right;
  assign right = sum_520[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:263
  logic [2:0] select_2486;
  assign select_2486 = sample_pair_whole_q ? (sample_last_q ? (select_473 + 3'h1) : select_473) : raster_at_y_q;
  logic [6:0] select_2488;
  assign select_2488 = sample_pair_whole_q ? (select_460 + {6'h0, equal_490}) : raster_at_column_q;
  logic [5:0] select_2491;
  assign select_2491 = sample_pair_whole_q ? (sample_last_q ? (select_553 + {5'h0, equal_491}) : select_553) : raster_at_row_q;
  logic select_2495;
  assign select_2495 = sample_pair_whole_q ? (sample_last_q ? (or_465 & (~raster_final_row_q)) : or_465) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2497;
  assign select_2497 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:263
  logic select_2501;
  assign select_2501 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2745;
  assign equal_2745 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:451
  logic and_2746;
  assign and_2746 = and_494 & equal_2745;
  // hls/stages/agreement.hpp:510
  logic select_2749;
  assign select_2749 = (and_2746 | (~ends_cell_q)) ? and_2746 : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2749 ? (and_2746 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2753;
  assign select_2753 = select_2749 ? (and_2746 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2756;
  assign select_2756 = select_2749 ? (following_last_shift_q & (~and_2746)) : run_last_shift_q;
  // hls/stages/agreement.hpp:594
  logic and_2759;
  assign and_2759 = run_last_shift_q & equal_517;
  // hls/stages/agreement.hpp:603
  logic select_2761;
  assign select_2761 = equal_517 ? (~run_last_shift_q) : equal_519;
  // hls/stages/agreement.hpp:607
  logic equal_2762;
  assign equal_2762 = run_phase_q == 3'h1;
  logic not_2765;
  assign not_2765 = ~select_2761;
  // hls/stages/agreement.hpp:610
  logic equal_2767;
  assign equal_2767 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2768;
  assign and_2768 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2769;
  assign select_2769 = equal_2767 ? 2'h1 : {2{and_2768}};
  logic [2:0] select_2771;
  assign select_2771 = (and_2759 | (select_2761 | equal_2762)) ? (equal_2762 ? 3'h2 : {not_2765, {2{select_2761}}}) : (equal_514 ? 3'h6 : {select_2769[0], select_2769});
  // hls/stages/agreement.hpp:594
  logic and_2774;
  assign and_2774 = select_2761 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2777;
  assign select_2777 = (plan_shift_q[5] & select_2761) ? value : 7'h0;
  logic [1:0] or_2778;
  assign or_2778 = {2{so}} | select_2777[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] or_2782;
  assign or_2782 = (select_2761 ? plan_columns_q : 8'h0) | ((equal_2762 | equal_2767) ? whole_q : 8'h0);
  logic [1:0] or_2783;
  assign or_2783 = {2{and_2759}} | or_2782[3:2];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_2785;
  assign or_2785 = {or_2782[7:4], or_2783, or_2782[1:0]} | (equal_514 ? drawn_q : 8'h0);
  logic [4:0] or_2786;
  assign or_2786 = {5{so}} | {or_2785[6], or_2785[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2790;
  assign not_2790 = ~run_shift_q[5];
  logic [7:0] select_2793;
  assign select_2793 = equal_517 ? ({{7{not_2790}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2797;
  assign select_2797 = and_2746 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2799;
  assign select_2799 = select_2749 ? {select_2797[6], select_2797} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2802;
  assign select_2802 = select_2749 ? (and_2746 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:507
  logic [6:0] select_2810;
  assign select_2810 = and_494 ? (equal_2745 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2813;
  assign select_2813 = and_494 ? (equal_2745 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2816;
  assign select_2816 = and_494 ? (equal_2745 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2827;
  assign select_2827 = (ends_cell_q | select_2749) ? (~(now == 3'h6)) : (equal_517 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2831;
  assign and_2831 = (~select_2749) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic [6:0] sum_2832;
  assign sum_2832 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:447
  logic select_2834;
  assign select_2834 = equal_2745 ? ({sum_2832[6], cfg_height_i[8:3]} == {1'b0, sum_2832[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:352
  logic or_3201;
  assign or_3201 = select_460[0] | select_553[5];
  logic [7:0] sum_3202;
  assign sum_3202 = {1'b0, select_460[2:1], or_3201, select_553[4:1]} + 8'h1;
  logic less_3203;
  assign less_3203 = {sum_3202, select_553[0], select_473, 1'b0} < {4'h0, cfg_height_i};

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
  assign fresh_re = s0_en & and_526;
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
  assign left_re = s0_en & (or_515 ? not_523 : select_610);
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
  assign right_codes_raddr = equal_517 ? sum_520[6:0] : x_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_516 & select_610);
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
  assign best_left_raddr = or_515 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_636;
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
      raster_at_x_q <= sample_pair_whole_q ? (select_458 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2486;
      raster_at_column_q <= select_2488;
      raster_at_row_q <= select_2491;
      raster_at_live_q <= select_2495;
      raster_rows_left_q <= sample_pair_whole_q ? select_2497 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2501;
      averager_place_q <= sample_pair_whole_q ? select_464 : averager_place_q;
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
      plan_shift_q <= equal_517 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2793;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2799;
      columns_left_q <= select_2802;
      last_q <= and_494 ? (equal_2745 ? column : last_q) : last_q;
      least_q <= select_2810;
      whole_q <= select_2813;
      drawn_q <= select_2816;
      age_q <= select_2749 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2749 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2827;
      ends_q <= and_2831;
      final_row_q <= and_494 ? select_2834 : final_row_q;
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
  logic [2:0] select_458_s1_q;
  logic [6:0] select_460_s1_q;
  logic [8:0] select_464_s1_q;
  logic and_468_s1_q;
  logic equal_474_s1_q;
  logic [6:0] column_s1_q;
  logic and_492_s1_q;
  logic and_494_s1_q;
  logic so_s1_q;
  logic equal_514_s1_q;
  logic or_515_s1_q;
  logic equal_517_s1_q;
  logic less_522_s1_q;
  logic not_523_s1_q;
  logic and_526_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_636_s1_q;
  logic select_643_s1_q;
  logic and_1918_s1_q;
  logic [6:0] right_s1_q;
  logic select_1927_s1_q;
  logic equal_1936_s1_q;
  logic equal_2055_s1_q;
  logic equal_2745_s1_q;
  logic and_2746_s1_q;
  logic not_3204_s1_q;
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
      select_458_s1_q <= select_458;
      select_460_s1_q <= select_460;
      select_464_s1_q <= select_464;
      and_468_s1_q <= and_468;
      equal_474_s1_q <= select_473 == 3'h0;
      column_s1_q <= column;
      and_492_s1_q <= and_492;
      and_494_s1_q <= and_494;
      so_s1_q <= so;
      equal_514_s1_q <= equal_514;
      or_515_s1_q <= or_515;
      equal_517_s1_q <= equal_517;
      less_522_s1_q <= less_522;
      not_523_s1_q <= not_523;
      and_526_s1_q <= and_526;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_636_s1_q <= select_636;
      select_643_s1_q <= or_641 ? equal_639 : (~age_q[3]);
      and_1918_s1_q <= not_516 & and_635;
      right_s1_q <= right;
      select_1927_s1_q <= or_641 ? equal_639 : ({x[7], last_q} == {1'b0, x[6:0]});
      equal_1936_s1_q <= run_phase_q == 3'h7;
      equal_2055_s1_q <= {or_465, select_473} == 4'hc;
      equal_2745_s1_q <= equal_2745;
      and_2746_s1_q <= and_2746;
      not_3204_s1_q <= ~less_3203;
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
  logic not_614;
  assign not_614 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:656
  logic and_615;
  assign and_615 = left_rdata_q[12] & not_614;
  logic and_616;
  assign and_616 = left_rdata_q[28] & not_614;
  logic and_617;
  assign and_617 = left_rdata_q[44] & not_614;
  logic and_618;
  assign and_618 = left_rdata_q[60] & not_614;
  // hls/stages/agreement.hpp:657
  logic and_622;
  assign and_622 = right_codes_rdata_q[12] & not_614;
  logic and_623;
  assign and_623 = right_codes_rdata_q[25] & not_614;
  logic and_624;
  assign and_624 = right_codes_rdata_q[38] & not_614;
  logic and_625;
  assign and_625 = right_codes_rdata_q[51] & not_614;
  logic and_626;
  assign and_626 = right_codes_rdata_q[64] & not_614;
  logic and_627;
  assign and_627 = right_codes_rdata_q[77] & not_614;
  // hls/stages/agreement.hpp:212
  logic and_649;
  assign and_649 = left_rdata_q[44] & not_523_s1_q;
  logic and_650;
  assign and_650 = right_codes_rdata_q[38] & not_523_s1_q;
  logic [11:0] select_651;
  assign select_651 = less_522_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_652;
  assign select_652 = less_522_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_656;
  assign select_656 = and_649 ? (and_650 ? (~(select_651 ^ select_652)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_662;
  assign parity_662 = ^select_656[5:3];
  logic parity_665;
  assign parity_665 = ^select_656[8:6];
  logic parity_668;
  assign parity_668 = ^select_656[11:3];
  // hls/stages/agreement.hpp:212
  logic and_672;
  assign and_672 = left_rdata_q[60] & not_523_s1_q;
  logic and_673;
  assign and_673 = right_codes_rdata_q[51] & not_523_s1_q;
  logic [11:0] select_674;
  assign select_674 = less_522_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_675;
  assign select_675 = less_522_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_679;
  assign select_679 = and_672 ? (and_673 ? (~(select_674 ^ select_675)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_682;
  assign parity_682 = ^select_679[8:6];
  logic parity_685;
  assign parity_685 = ^select_679[11:9];
  // hls/stages/agreement.hpp:212
  logic and_689;
  assign and_689 = left_rdata_q[76] & not_523_s1_q;
  logic and_690;
  assign and_690 = right_codes_rdata_q[64] & not_523_s1_q;
  logic [11:0] select_691;
  assign select_691 = less_522_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_692;
  assign select_692 = less_522_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_696;
  assign select_696 = and_689 ? (and_690 ? (~(select_691 ^ select_692)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_702;
  assign parity_702 = ^select_696[2:0];
  logic parity_705;
  assign parity_705 = ^select_696[5:3];
  logic parity_708;
  assign parity_708 = ^select_696[8:0];
  logic parity_714;
  assign parity_714 = ^select_696[11:9];
  logic parity_717;
  assign parity_717 = ^select_679[2:0];
  logic parity_720;
  assign parity_720 = ^{select_696[11:9], select_679[5:0]};
  logic parity_723;
  assign parity_723 = ^{select_696, select_679, select_656[2:0]};
  logic xor_724;
  assign xor_724 = parity_668 ^ parity_723;
  // hls/stages/count_bits.hpp:23
  logic or_728;
  assign or_728 = (select_656[1:0] == 2'h3) | (select_656[2] & (select_656[0] | select_656[1]));
  // hls/stages/count_bits.hpp:25
  logic or_732;
  assign or_732 = (select_679[7:6] == 2'h3) | (select_679[8] & (select_679[6] | select_679[7]));
  logic or_736;
  assign or_736 = (select_679[10:9] == 2'h3) | (select_679[11] & (select_679[9] | select_679[10]));
  // hls/stages/count_bits.hpp:23
  logic or_744;
  assign or_744 = (select_696[7:6] == 2'h3) | (select_696[8] & (~(select_696[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_748;
  assign or_748 = (select_696[1:0] == 2'h3) | (select_696[2] & (select_696[0] | select_696[1]));
  logic or_752;
  assign or_752 = (select_696[4:3] == 2'h3) | (select_696[5] & (select_696[3] | select_696[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_755;
  assign parity_755 = ^{or_752, or_748, or_744};
  // hls/stages/count_bits.hpp:23
  logic or_759;
  assign or_759 = (select_679[4:3] == 2'h3) | (select_679[5] & (select_679[3] | select_679[4]));
  // hls/stages/count_bits.hpp:25
  logic or_763;
  assign or_763 = (select_696[10:9] == 2'h3) | (select_696[11] & (select_696[9] | select_696[10]));
  logic or_767;
  assign or_767 = (select_679[1:0] == 2'h3) | (select_679[2] & (select_679[0] | select_679[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_770;
  assign parity_770 = ^{or_767, or_763, or_759};
  logic parity_773;
  assign parity_773 = ^{or_767, or_763, or_759, or_752, or_748, or_744, or_736, or_732, or_728};
  // hls/stages/count_bits.hpp:25
  logic and_774;
  assign and_774 = parity_668 & parity_723;
  logic or_778;
  assign or_778 = (parity_662 & parity_665) | ((^select_656[11:9]) & (parity_662 | parity_665));
  logic and_781;
  assign and_781 = (^{select_679[11:6], select_656[2:0]}) & (parity_708 | parity_720);
  logic or_782;
  assign or_782 = (parity_708 & parity_720) | and_781;
  // hls/stages/count_bits.hpp:23
  logic or_789;
  assign or_789 = (select_656[10:9] == 2'h3) | (select_656[11] & (select_656[9] | select_656[10]));
  // hls/stages/count_bits.hpp:25
  logic or_793;
  assign or_793 = (select_656[4:3] == 2'h3) | (select_656[5] & (select_656[3] | select_656[4]));
  logic or_797;
  assign or_797 = (select_656[7:6] == 2'h3) | (select_656[8] & (select_656[6] | select_656[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_800;
  assign parity_800 = ^{or_797, or_793, or_789};
  // hls/stages/count_bits.hpp:25
  logic or_804;
  assign or_804 = (parity_682 & parity_685) | ((^select_656[2:0]) & (parity_682 | parity_685));
  logic or_808;
  assign or_808 = (parity_702 & parity_705) | ((^select_696[8:6]) & (parity_702 | parity_705));
  logic or_812;
  assign or_812 = (parity_714 & parity_717) | ((^select_679[5:3]) & (parity_714 | parity_717));
  // hls/stages/count_bits.hpp:24
  logic parity_815;
  assign parity_815 = ^{or_812, or_808, or_804};
  logic parity_818;
  assign parity_818 = ^{or_812, or_808, or_804, or_797, or_793, or_789, or_782, or_778, and_774};
  logic xor_819;
  assign xor_819 = parity_773 ^ parity_818;
  // hls/stages/count_bits.hpp:25
  logic and_820;
  assign and_820 = parity_773 & parity_818;
  logic or_824;
  assign or_824 = (parity_755 & parity_770) | ((^{or_736, or_732, or_728}) & (parity_755 | parity_770));
  logic or_828;
  assign or_828 = (parity_800 & parity_815) | ((^{or_782, or_778, and_774}) & (parity_800 | parity_815));
  logic or_835;
  assign or_835 = (or_732 & or_736) | (or_728 & (or_732 | or_736));
  logic or_839;
  assign or_839 = (or_748 & or_752) | (or_744 & (or_748 | or_752));
  logic or_843;
  assign or_843 = (or_763 & or_767) | (or_759 & (or_763 | or_767));
  // hls/stages/count_bits.hpp:24
  logic parity_846;
  assign parity_846 = ^{or_843, or_839, or_835};
  // hls/stages/count_bits.hpp:25
  logic or_850;
  assign or_850 = (or_778 & or_782) | (and_774 & (or_778 | or_782));
  logic or_854;
  assign or_854 = (or_793 & or_797) | (or_789 & (or_793 | or_797));
  logic or_858;
  assign or_858 = (or_808 & or_812) | (or_804 & (or_808 | or_812));
  // hls/stages/count_bits.hpp:24
  logic parity_861;
  assign parity_861 = ^{or_858, or_854, or_850};
  logic parity_864;
  assign parity_864 = ^{or_858, or_854, or_850, or_843, or_839, or_835, or_828, or_824, and_820};
  // hls/stages/count_bits.hpp:25
  logic or_868;
  assign or_868 = (parity_846 & parity_861) | ((^{or_828, or_824, and_820}) & (parity_846 | parity_861));
  logic or_872;
  assign or_872 = (or_824 & or_828) | (and_820 & (or_824 | or_828));
  logic or_876;
  assign or_876 = (or_839 & or_843) | (or_835 & (or_839 | or_843));
  logic or_880;
  assign or_880 = (or_854 & or_858) | (or_850 & (or_854 | or_858));
  // hls/stages/count_bits.hpp:24
  logic parity_885;
  assign parity_885 = ^{or_880, or_876, or_872, or_868};
  // hls/stages/count_bits.hpp:25
  logic or_889;
  assign or_889 = (or_876 & or_880) | (or_872 & (or_876 | or_880));
  logic and_890;
  assign and_890 = or_868 & (^{or_880, or_876, or_872});
  // hls/stages/count_bits.hpp:24
  logic xor_891;
  assign xor_891 = or_889 ^ and_890;
  // hls/stages/count_bits.hpp:27
  logic and_892;
  assign and_892 = or_889 & and_890;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_893;
  assign select_893 = equal_517_s1_q ? {and_892, xor_891, parity_885, parity_864, xor_819, xor_724} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_515_s1_q ? 6'h0 : select_893;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_895;
  assign select_895 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_896;
  assign difference_896 = {1'b0, column_2} - {1'b0, select_895};
  logic [7:0] sum_898;
  assign sum_898 = {difference_896[6], difference_896} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] select_902;
  assign select_902 = and_649 ? (and_673 ? (~(select_674 ^ select_652)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_908;
  assign parity_908 = ^select_902[5:3];
  logic parity_911;
  assign parity_911 = ^select_902[8:6];
  logic parity_914;
  assign parity_914 = ^select_902[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_921;
  assign select_921 = and_672 ? (and_690 ? (~(select_691 ^ select_675)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_924;
  assign parity_924 = ^select_921[8:6];
  logic parity_927;
  assign parity_927 = ^select_921[11:9];
  // hls/stages/agreement.hpp:212
  logic and_931;
  assign and_931 = right_codes_rdata_q[77] & not_523_s1_q;
  logic [11:0] select_932;
  assign select_932 = less_522_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_936;
  assign select_936 = and_689 ? (and_931 ? (~(select_932 ^ select_692)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_942;
  assign parity_942 = ^select_936[2:0];
  logic parity_945;
  assign parity_945 = ^select_936[5:3];
  logic parity_948;
  assign parity_948 = ^select_936[8:0];
  logic parity_954;
  assign parity_954 = ^select_936[11:9];
  logic parity_957;
  assign parity_957 = ^select_921[2:0];
  logic parity_960;
  assign parity_960 = ^{select_936[11:9], select_921[5:0]};
  logic parity_963;
  assign parity_963 = ^{select_936, select_921, select_902[2:0]};
  logic xor_964;
  assign xor_964 = parity_914 ^ parity_963;
  // hls/stages/count_bits.hpp:23
  logic or_968;
  assign or_968 = (select_902[1:0] == 2'h3) | (select_902[2] & (select_902[0] | select_902[1]));
  // hls/stages/count_bits.hpp:25
  logic or_972;
  assign or_972 = (select_921[7:6] == 2'h3) | (select_921[8] & (select_921[6] | select_921[7]));
  logic or_976;
  assign or_976 = (select_921[10:9] == 2'h3) | (select_921[11] & (select_921[9] | select_921[10]));
  // hls/stages/count_bits.hpp:23
  logic or_984;
  assign or_984 = (select_936[7:6] == 2'h3) | (select_936[8] & (~(select_936[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_988;
  assign or_988 = (select_936[1:0] == 2'h3) | (select_936[2] & (select_936[0] | select_936[1]));
  logic or_992;
  assign or_992 = (select_936[4:3] == 2'h3) | (select_936[5] & (select_936[3] | select_936[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_995;
  assign parity_995 = ^{or_992, or_988, or_984};
  // hls/stages/count_bits.hpp:23
  logic or_999;
  assign or_999 = (select_921[4:3] == 2'h3) | (select_921[5] & (select_921[3] | select_921[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1003;
  assign or_1003 = (select_936[10:9] == 2'h3) | (select_936[11] & (select_936[9] | select_936[10]));
  logic or_1007;
  assign or_1007 = (select_921[1:0] == 2'h3) | (select_921[2] & (select_921[0] | select_921[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1010;
  assign parity_1010 = ^{or_1007, or_1003, or_999};
  logic parity_1013;
  assign parity_1013 = ^{or_1007, or_1003, or_999, or_992, or_988, or_984, or_976, or_972, or_968};
  // hls/stages/count_bits.hpp:25
  logic and_1014;
  assign and_1014 = parity_914 & parity_963;
  logic or_1018;
  assign or_1018 = (parity_908 & parity_911) | ((^select_902[11:9]) & (parity_908 | parity_911));
  logic and_1021;
  assign and_1021 = (^{select_921[11:6], select_902[2:0]}) & (parity_948 | parity_960);
  logic or_1022;
  assign or_1022 = (parity_948 & parity_960) | and_1021;
  // hls/stages/count_bits.hpp:23
  logic or_1029;
  assign or_1029 = (select_902[10:9] == 2'h3) | (select_902[11] & (select_902[9] | select_902[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1033;
  assign or_1033 = (select_902[4:3] == 2'h3) | (select_902[5] & (select_902[3] | select_902[4]));
  logic or_1037;
  assign or_1037 = (select_902[7:6] == 2'h3) | (select_902[8] & (select_902[6] | select_902[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1040;
  assign parity_1040 = ^{or_1037, or_1033, or_1029};
  // hls/stages/count_bits.hpp:25
  logic or_1044;
  assign or_1044 = (parity_924 & parity_927) | ((^select_902[2:0]) & (parity_924 | parity_927));
  logic or_1048;
  assign or_1048 = (parity_942 & parity_945) | ((^select_936[8:6]) & (parity_942 | parity_945));
  logic or_1052;
  assign or_1052 = (parity_954 & parity_957) | ((^select_921[5:3]) & (parity_954 | parity_957));
  // hls/stages/count_bits.hpp:24
  logic parity_1055;
  assign parity_1055 = ^{or_1052, or_1048, or_1044};
  logic parity_1058;
  assign parity_1058 = ^{or_1052, or_1048, or_1044, or_1037, or_1033, or_1029, or_1022, or_1018, and_1014};
  logic xor_1059;
  assign xor_1059 = parity_1013 ^ parity_1058;
  // hls/stages/count_bits.hpp:25
  logic and_1060;
  assign and_1060 = parity_1013 & parity_1058;
  logic or_1064;
  assign or_1064 = (parity_995 & parity_1010) | ((^{or_976, or_972, or_968}) & (parity_995 | parity_1010));
  logic or_1068;
  assign or_1068 = (parity_1040 & parity_1055) | ((^{or_1022, or_1018, and_1014}) & (parity_1040 | parity_1055));
  logic or_1075;
  assign or_1075 = (or_972 & or_976) | (or_968 & (or_972 | or_976));
  logic or_1079;
  assign or_1079 = (or_988 & or_992) | (or_984 & (or_988 | or_992));
  logic or_1083;
  assign or_1083 = (or_1003 & or_1007) | (or_999 & (or_1003 | or_1007));
  // hls/stages/count_bits.hpp:24
  logic parity_1086;
  assign parity_1086 = ^{or_1083, or_1079, or_1075};
  // hls/stages/count_bits.hpp:25
  logic or_1090;
  assign or_1090 = (or_1018 & or_1022) | (and_1014 & (or_1018 | or_1022));
  logic or_1094;
  assign or_1094 = (or_1033 & or_1037) | (or_1029 & (or_1033 | or_1037));
  logic or_1098;
  assign or_1098 = (or_1048 & or_1052) | (or_1044 & (or_1048 | or_1052));
  // hls/stages/count_bits.hpp:24
  logic parity_1101;
  assign parity_1101 = ^{or_1098, or_1094, or_1090};
  logic parity_1104;
  assign parity_1104 = ^{or_1098, or_1094, or_1090, or_1083, or_1079, or_1075, or_1068, or_1064, and_1060};
  // hls/stages/count_bits.hpp:25
  logic or_1108;
  assign or_1108 = (parity_1086 & parity_1101) | ((^{or_1068, or_1064, and_1060}) & (parity_1086 | parity_1101));
  logic or_1112;
  assign or_1112 = (or_1064 & or_1068) | (and_1060 & (or_1064 | or_1068));
  logic or_1116;
  assign or_1116 = (or_1079 & or_1083) | (or_1075 & (or_1079 | or_1083));
  logic or_1120;
  assign or_1120 = (or_1094 & or_1098) | (or_1090 & (or_1094 | or_1098));
  // hls/stages/count_bits.hpp:24
  logic parity_1125;
  assign parity_1125 = ^{or_1120, or_1116, or_1112, or_1108};
  // hls/stages/count_bits.hpp:25
  logic or_1129;
  assign or_1129 = (or_1116 & or_1120) | (or_1112 & (or_1116 | or_1120));
  logic and_1130;
  assign and_1130 = or_1108 & (^{or_1120, or_1116, or_1112});
  // hls/stages/count_bits.hpp:24
  logic xor_1131;
  assign xor_1131 = or_1129 ^ and_1130;
  // hls/stages/count_bits.hpp:27
  logic and_1132;
  assign and_1132 = or_1129 & and_1130;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1133;
  assign select_1133 = equal_517_s1_q ? {and_1132, xor_1131, parity_1125, parity_1104, xor_1059, xor_964} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_515_s1_q ? 6'h0 : select_1133;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1135;
  assign select_1135 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1136;
  assign difference_1136 = {1'b0, column_3} - {1'b0, select_1135};
  logic [7:0] sum_1138;
  assign sum_1138 = {difference_1136[6], difference_1136} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:212
  logic and_1139;
  assign and_1139 = right_codes_rdata_q[25] & not_523_s1_q;
  logic [11:0] select_1140;
  assign select_1140 = less_522_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1144;
  assign select_1144 = and_649 ? (and_1139 ? (~(select_1140 ^ select_652)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1150;
  assign parity_1150 = ^select_1144[5:3];
  logic parity_1153;
  assign parity_1153 = ^select_1144[8:6];
  logic parity_1156;
  assign parity_1156 = ^select_1144[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1163;
  assign select_1163 = and_672 ? (and_650 ? (~(select_651 ^ select_675)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1166;
  assign parity_1166 = ^select_1163[8:6];
  logic parity_1169;
  assign parity_1169 = ^select_1163[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1176;
  assign select_1176 = and_689 ? (and_673 ? (~(select_674 ^ select_692)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1182;
  assign parity_1182 = ^select_1176[2:0];
  logic parity_1185;
  assign parity_1185 = ^select_1176[5:3];
  logic parity_1188;
  assign parity_1188 = ^select_1176[8:0];
  logic parity_1194;
  assign parity_1194 = ^select_1176[11:9];
  logic parity_1197;
  assign parity_1197 = ^select_1163[2:0];
  logic parity_1200;
  assign parity_1200 = ^{select_1176[11:9], select_1163[5:0]};
  logic parity_1203;
  assign parity_1203 = ^{select_1176, select_1163, select_1144[2:0]};
  logic xor_1204;
  assign xor_1204 = parity_1156 ^ parity_1203;
  // hls/stages/count_bits.hpp:23
  logic or_1208;
  assign or_1208 = (select_1144[1:0] == 2'h3) | (select_1144[2] & (select_1144[0] | select_1144[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1212;
  assign or_1212 = (select_1163[7:6] == 2'h3) | (select_1163[8] & (select_1163[6] | select_1163[7]));
  logic or_1216;
  assign or_1216 = (select_1163[10:9] == 2'h3) | (select_1163[11] & (select_1163[9] | select_1163[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1224;
  assign or_1224 = (select_1176[7:6] == 2'h3) | (select_1176[8] & (~(select_1176[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1228;
  assign or_1228 = (select_1176[1:0] == 2'h3) | (select_1176[2] & (select_1176[0] | select_1176[1]));
  logic or_1232;
  assign or_1232 = (select_1176[4:3] == 2'h3) | (select_1176[5] & (select_1176[3] | select_1176[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1235;
  assign parity_1235 = ^{or_1232, or_1228, or_1224};
  // hls/stages/count_bits.hpp:23
  logic or_1239;
  assign or_1239 = (select_1163[4:3] == 2'h3) | (select_1163[5] & (select_1163[3] | select_1163[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1243;
  assign or_1243 = (select_1176[10:9] == 2'h3) | (select_1176[11] & (select_1176[9] | select_1176[10]));
  logic or_1247;
  assign or_1247 = (select_1163[1:0] == 2'h3) | (select_1163[2] & (select_1163[0] | select_1163[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1250;
  assign parity_1250 = ^{or_1247, or_1243, or_1239};
  logic parity_1253;
  assign parity_1253 = ^{or_1247, or_1243, or_1239, or_1232, or_1228, or_1224, or_1216, or_1212, or_1208};
  // hls/stages/count_bits.hpp:25
  logic and_1254;
  assign and_1254 = parity_1156 & parity_1203;
  logic or_1258;
  assign or_1258 = (parity_1150 & parity_1153) | ((^select_1144[11:9]) & (parity_1150 | parity_1153));
  logic and_1261;
  assign and_1261 = (^{select_1163[11:6], select_1144[2:0]}) & (parity_1188 | parity_1200);
  logic or_1262;
  assign or_1262 = (parity_1188 & parity_1200) | and_1261;
  // hls/stages/count_bits.hpp:23
  logic or_1269;
  assign or_1269 = (select_1144[10:9] == 2'h3) | (select_1144[11] & (select_1144[9] | select_1144[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1273;
  assign or_1273 = (select_1144[4:3] == 2'h3) | (select_1144[5] & (select_1144[3] | select_1144[4]));
  logic or_1277;
  assign or_1277 = (select_1144[7:6] == 2'h3) | (select_1144[8] & (select_1144[6] | select_1144[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1280;
  assign parity_1280 = ^{or_1277, or_1273, or_1269};
  // hls/stages/count_bits.hpp:25
  logic or_1284;
  assign or_1284 = (parity_1166 & parity_1169) | ((^select_1144[2:0]) & (parity_1166 | parity_1169));
  logic or_1288;
  assign or_1288 = (parity_1182 & parity_1185) | ((^select_1176[8:6]) & (parity_1182 | parity_1185));
  logic or_1292;
  assign or_1292 = (parity_1194 & parity_1197) | ((^select_1163[5:3]) & (parity_1194 | parity_1197));
  // hls/stages/count_bits.hpp:24
  logic parity_1295;
  assign parity_1295 = ^{or_1292, or_1288, or_1284};
  logic parity_1298;
  assign parity_1298 = ^{or_1292, or_1288, or_1284, or_1277, or_1273, or_1269, or_1262, or_1258, and_1254};
  logic xor_1299;
  assign xor_1299 = parity_1253 ^ parity_1298;
  // hls/stages/count_bits.hpp:25
  logic and_1300;
  assign and_1300 = parity_1253 & parity_1298;
  logic or_1304;
  assign or_1304 = (parity_1235 & parity_1250) | ((^{or_1216, or_1212, or_1208}) & (parity_1235 | parity_1250));
  logic or_1308;
  assign or_1308 = (parity_1280 & parity_1295) | ((^{or_1262, or_1258, and_1254}) & (parity_1280 | parity_1295));
  logic or_1315;
  assign or_1315 = (or_1212 & or_1216) | (or_1208 & (or_1212 | or_1216));
  logic or_1319;
  assign or_1319 = (or_1228 & or_1232) | (or_1224 & (or_1228 | or_1232));
  logic or_1323;
  assign or_1323 = (or_1243 & or_1247) | (or_1239 & (or_1243 | or_1247));
  // hls/stages/count_bits.hpp:24
  logic parity_1326;
  assign parity_1326 = ^{or_1323, or_1319, or_1315};
  // hls/stages/count_bits.hpp:25
  logic or_1330;
  assign or_1330 = (or_1258 & or_1262) | (and_1254 & (or_1258 | or_1262));
  logic or_1334;
  assign or_1334 = (or_1273 & or_1277) | (or_1269 & (or_1273 | or_1277));
  logic or_1338;
  assign or_1338 = (or_1288 & or_1292) | (or_1284 & (or_1288 | or_1292));
  // hls/stages/count_bits.hpp:24
  logic parity_1341;
  assign parity_1341 = ^{or_1338, or_1334, or_1330};
  logic parity_1344;
  assign parity_1344 = ^{or_1338, or_1334, or_1330, or_1323, or_1319, or_1315, or_1308, or_1304, and_1300};
  // hls/stages/count_bits.hpp:25
  logic or_1348;
  assign or_1348 = (parity_1326 & parity_1341) | ((^{or_1308, or_1304, and_1300}) & (parity_1326 | parity_1341));
  logic or_1352;
  assign or_1352 = (or_1304 & or_1308) | (and_1300 & (or_1304 | or_1308));
  logic or_1356;
  assign or_1356 = (or_1319 & or_1323) | (or_1315 & (or_1319 | or_1323));
  logic or_1360;
  assign or_1360 = (or_1334 & or_1338) | (or_1330 & (or_1334 | or_1338));
  // hls/stages/count_bits.hpp:24
  logic parity_1365;
  assign parity_1365 = ^{or_1360, or_1356, or_1352, or_1348};
  // hls/stages/count_bits.hpp:25
  logic or_1369;
  assign or_1369 = (or_1356 & or_1360) | (or_1352 & (or_1356 | or_1360));
  logic and_1370;
  assign and_1370 = or_1348 & (^{or_1360, or_1356, or_1352});
  // hls/stages/count_bits.hpp:24
  logic xor_1371;
  assign xor_1371 = or_1369 ^ and_1370;
  // hls/stages/count_bits.hpp:27
  logic and_1372;
  assign and_1372 = or_1369 & and_1370;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1373;
  assign select_1373 = equal_517_s1_q ? {and_1372, xor_1371, parity_1365, parity_1344, xor_1299, xor_1204} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_515_s1_q ? 6'h0 : select_1373;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1375;
  assign select_1375 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1376;
  assign difference_1376 = {1'b0, column_4} - {1'b0, select_1375};
  logic [7:0] sum_1378;
  assign sum_1378 = {difference_1376[6], difference_1376} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1386;
  assign select_1386 = and_649 ? (and_690 ? (~(select_691 ^ select_652)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1392;
  assign parity_1392 = ^select_1386[5:3];
  logic parity_1395;
  assign parity_1395 = ^select_1386[8:6];
  logic parity_1398;
  assign parity_1398 = ^select_1386[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1405;
  assign select_1405 = and_672 ? (and_931 ? (~(select_932 ^ select_675)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1408;
  assign parity_1408 = ^select_1405[8:6];
  logic parity_1411;
  assign parity_1411 = ^select_1405[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] xor_1417;
  assign xor_1417 = (less_522_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_692;
  logic [11:0] select_1420;
  assign select_1420 = and_689 ? ((right_codes_rdata_q[90] & not_523_s1_q) ? (~xor_1417) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1426;
  assign parity_1426 = ^select_1420[2:0];
  logic parity_1429;
  assign parity_1429 = ^select_1420[5:3];
  logic parity_1432;
  assign parity_1432 = ^select_1420[8:0];
  logic parity_1438;
  assign parity_1438 = ^select_1420[11:9];
  logic parity_1441;
  assign parity_1441 = ^select_1405[2:0];
  logic parity_1444;
  assign parity_1444 = ^{select_1420[11:9], select_1405[5:0]};
  logic parity_1447;
  assign parity_1447 = ^{select_1420, select_1405, select_1386[2:0]};
  logic xor_1448;
  assign xor_1448 = parity_1398 ^ parity_1447;
  // hls/stages/count_bits.hpp:23
  logic or_1452;
  assign or_1452 = (select_1386[1:0] == 2'h3) | (select_1386[2] & (select_1386[0] | select_1386[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1456;
  assign or_1456 = (select_1405[7:6] == 2'h3) | (select_1405[8] & (select_1405[6] | select_1405[7]));
  logic or_1460;
  assign or_1460 = (select_1405[10:9] == 2'h3) | (select_1405[11] & (select_1405[9] | select_1405[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1468;
  assign or_1468 = (select_1420[7:6] == 2'h3) | (select_1420[8] & (~(select_1420[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1472;
  assign or_1472 = (select_1420[1:0] == 2'h3) | (select_1420[2] & (select_1420[0] | select_1420[1]));
  logic or_1476;
  assign or_1476 = (select_1420[4:3] == 2'h3) | (select_1420[5] & (select_1420[3] | select_1420[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1479;
  assign parity_1479 = ^{or_1476, or_1472, or_1468};
  // hls/stages/count_bits.hpp:23
  logic or_1483;
  assign or_1483 = (select_1405[4:3] == 2'h3) | (select_1405[5] & (select_1405[3] | select_1405[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1487;
  assign or_1487 = (select_1420[10:9] == 2'h3) | (select_1420[11] & (select_1420[9] | select_1420[10]));
  logic or_1491;
  assign or_1491 = (select_1405[1:0] == 2'h3) | (select_1405[2] & (select_1405[0] | select_1405[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1494;
  assign parity_1494 = ^{or_1491, or_1487, or_1483};
  logic parity_1497;
  assign parity_1497 = ^{or_1491, or_1487, or_1483, or_1476, or_1472, or_1468, or_1460, or_1456, or_1452};
  // hls/stages/count_bits.hpp:25
  logic and_1498;
  assign and_1498 = parity_1398 & parity_1447;
  logic or_1502;
  assign or_1502 = (parity_1392 & parity_1395) | ((^select_1386[11:9]) & (parity_1392 | parity_1395));
  logic and_1505;
  assign and_1505 = (^{select_1405[11:6], select_1386[2:0]}) & (parity_1432 | parity_1444);
  logic or_1506;
  assign or_1506 = (parity_1432 & parity_1444) | and_1505;
  // hls/stages/count_bits.hpp:23
  logic or_1513;
  assign or_1513 = (select_1386[10:9] == 2'h3) | (select_1386[11] & (select_1386[9] | select_1386[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1517;
  assign or_1517 = (select_1386[4:3] == 2'h3) | (select_1386[5] & (select_1386[3] | select_1386[4]));
  logic or_1521;
  assign or_1521 = (select_1386[7:6] == 2'h3) | (select_1386[8] & (select_1386[6] | select_1386[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1524;
  assign parity_1524 = ^{or_1521, or_1517, or_1513};
  // hls/stages/count_bits.hpp:25
  logic or_1528;
  assign or_1528 = (parity_1408 & parity_1411) | ((^select_1386[2:0]) & (parity_1408 | parity_1411));
  logic or_1532;
  assign or_1532 = (parity_1426 & parity_1429) | ((^select_1420[8:6]) & (parity_1426 | parity_1429));
  logic or_1536;
  assign or_1536 = (parity_1438 & parity_1441) | ((^select_1405[5:3]) & (parity_1438 | parity_1441));
  // hls/stages/count_bits.hpp:24
  logic parity_1539;
  assign parity_1539 = ^{or_1536, or_1532, or_1528};
  logic parity_1542;
  assign parity_1542 = ^{or_1536, or_1532, or_1528, or_1521, or_1517, or_1513, or_1506, or_1502, and_1498};
  logic xor_1543;
  assign xor_1543 = parity_1497 ^ parity_1542;
  // hls/stages/count_bits.hpp:25
  logic and_1544;
  assign and_1544 = parity_1497 & parity_1542;
  logic or_1548;
  assign or_1548 = (parity_1479 & parity_1494) | ((^{or_1460, or_1456, or_1452}) & (parity_1479 | parity_1494));
  logic or_1552;
  assign or_1552 = (parity_1524 & parity_1539) | ((^{or_1506, or_1502, and_1498}) & (parity_1524 | parity_1539));
  logic or_1559;
  assign or_1559 = (or_1456 & or_1460) | (or_1452 & (or_1456 | or_1460));
  logic or_1563;
  assign or_1563 = (or_1472 & or_1476) | (or_1468 & (or_1472 | or_1476));
  logic or_1567;
  assign or_1567 = (or_1487 & or_1491) | (or_1483 & (or_1487 | or_1491));
  // hls/stages/count_bits.hpp:24
  logic parity_1570;
  assign parity_1570 = ^{or_1567, or_1563, or_1559};
  // hls/stages/count_bits.hpp:25
  logic or_1574;
  assign or_1574 = (or_1502 & or_1506) | (and_1498 & (or_1502 | or_1506));
  logic or_1578;
  assign or_1578 = (or_1517 & or_1521) | (or_1513 & (or_1517 | or_1521));
  logic or_1582;
  assign or_1582 = (or_1532 & or_1536) | (or_1528 & (or_1532 | or_1536));
  // hls/stages/count_bits.hpp:24
  logic parity_1585;
  assign parity_1585 = ^{or_1582, or_1578, or_1574};
  logic parity_1588;
  assign parity_1588 = ^{or_1582, or_1578, or_1574, or_1567, or_1563, or_1559, or_1552, or_1548, and_1544};
  // hls/stages/count_bits.hpp:25
  logic or_1592;
  assign or_1592 = (parity_1570 & parity_1585) | ((^{or_1552, or_1548, and_1544}) & (parity_1570 | parity_1585));
  logic or_1596;
  assign or_1596 = (or_1548 & or_1552) | (and_1544 & (or_1548 | or_1552));
  logic or_1600;
  assign or_1600 = (or_1563 & or_1567) | (or_1559 & (or_1563 | or_1567));
  logic or_1604;
  assign or_1604 = (or_1578 & or_1582) | (or_1574 & (or_1578 | or_1582));
  // hls/stages/count_bits.hpp:24
  logic parity_1609;
  assign parity_1609 = ^{or_1604, or_1600, or_1596, or_1592};
  // hls/stages/count_bits.hpp:25
  logic or_1613;
  assign or_1613 = (or_1600 & or_1604) | (or_1596 & (or_1600 | or_1604));
  logic and_1614;
  assign and_1614 = or_1592 & (^{or_1604, or_1600, or_1596});
  // hls/stages/count_bits.hpp:24
  logic xor_1615;
  assign xor_1615 = or_1613 ^ and_1614;
  // hls/stages/count_bits.hpp:27
  logic and_1616;
  assign and_1616 = or_1613 & and_1614;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1617;
  assign select_1617 = equal_517_s1_q ? {and_1616, xor_1615, parity_1609, parity_1588, xor_1543, xor_1448} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_515_s1_q ? 6'h0 : select_1617;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1619;
  assign select_1619 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1620;
  assign difference_1620 = {1'b0, column_5} - {1'b0, select_1619};
  logic [7:0] sum_1622;
  assign sum_1622 = {difference_1620[6], difference_1620} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] not_1626;
  assign not_1626 = ~((less_522_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_652);
  logic [11:0] select_1628;
  assign select_1628 = and_649 ? ((right_codes_rdata_q[12] & not_523_s1_q) ? not_1626 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1634;
  assign parity_1634 = ^select_1628[5:3];
  logic parity_1637;
  assign parity_1637 = ^select_1628[8:6];
  logic parity_1640;
  assign parity_1640 = ^select_1628[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1647;
  assign select_1647 = and_672 ? (and_1139 ? (~(select_1140 ^ select_675)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1650;
  assign parity_1650 = ^select_1647[8:6];
  logic parity_1653;
  assign parity_1653 = ^select_1647[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1660;
  assign select_1660 = and_689 ? (and_650 ? (~(select_651 ^ select_692)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1666;
  assign parity_1666 = ^select_1660[2:0];
  logic parity_1669;
  assign parity_1669 = ^select_1660[5:3];
  logic parity_1672;
  assign parity_1672 = ^select_1660[8:0];
  logic parity_1678;
  assign parity_1678 = ^select_1660[11:9];
  logic parity_1681;
  assign parity_1681 = ^select_1647[2:0];
  logic parity_1684;
  assign parity_1684 = ^{select_1660[11:9], select_1647[5:0]};
  logic parity_1687;
  assign parity_1687 = ^{select_1660, select_1647, select_1628[2:0]};
  logic xor_1688;
  assign xor_1688 = parity_1640 ^ parity_1687;
  // hls/stages/count_bits.hpp:23
  logic or_1692;
  assign or_1692 = (select_1628[1:0] == 2'h3) | (select_1628[2] & (select_1628[0] | select_1628[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1696;
  assign or_1696 = (select_1647[7:6] == 2'h3) | (select_1647[8] & (select_1647[6] | select_1647[7]));
  logic or_1700;
  assign or_1700 = (select_1647[10:9] == 2'h3) | (select_1647[11] & (select_1647[9] | select_1647[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1708;
  assign or_1708 = (select_1660[7:6] == 2'h3) | (select_1660[8] & (~(select_1660[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1712;
  assign or_1712 = (select_1660[1:0] == 2'h3) | (select_1660[2] & (select_1660[0] | select_1660[1]));
  logic or_1716;
  assign or_1716 = (select_1660[4:3] == 2'h3) | (select_1660[5] & (select_1660[3] | select_1660[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1719;
  assign parity_1719 = ^{or_1716, or_1712, or_1708};
  // hls/stages/count_bits.hpp:23
  logic or_1723;
  assign or_1723 = (select_1647[4:3] == 2'h3) | (select_1647[5] & (select_1647[3] | select_1647[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1727;
  assign or_1727 = (select_1660[10:9] == 2'h3) | (select_1660[11] & (select_1660[9] | select_1660[10]));
  logic or_1731;
  assign or_1731 = (select_1647[1:0] == 2'h3) | (select_1647[2] & (select_1647[0] | select_1647[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1734;
  assign parity_1734 = ^{or_1731, or_1727, or_1723};
  logic parity_1737;
  assign parity_1737 = ^{or_1731, or_1727, or_1723, or_1716, or_1712, or_1708, or_1700, or_1696, or_1692};
  // hls/stages/count_bits.hpp:25
  logic and_1738;
  assign and_1738 = parity_1640 & parity_1687;
  logic or_1742;
  assign or_1742 = (parity_1634 & parity_1637) | ((^select_1628[11:9]) & (parity_1634 | parity_1637));
  logic and_1745;
  assign and_1745 = (^{select_1647[11:6], select_1628[2:0]}) & (parity_1672 | parity_1684);
  logic or_1746;
  assign or_1746 = (parity_1672 & parity_1684) | and_1745;
  // hls/stages/count_bits.hpp:23
  logic or_1753;
  assign or_1753 = (select_1628[10:9] == 2'h3) | (select_1628[11] & (select_1628[9] | select_1628[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1757;
  assign or_1757 = (select_1628[4:3] == 2'h3) | (select_1628[5] & (select_1628[3] | select_1628[4]));
  logic or_1761;
  assign or_1761 = (select_1628[7:6] == 2'h3) | (select_1628[8] & (select_1628[6] | select_1628[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1764;
  assign parity_1764 = ^{or_1761, or_1757, or_1753};
  // hls/stages/count_bits.hpp:25
  logic or_1768;
  assign or_1768 = (parity_1650 & parity_1653) | ((^select_1628[2:0]) & (parity_1650 | parity_1653));
  logic or_1772;
  assign or_1772 = (parity_1666 & parity_1669) | ((^select_1660[8:6]) & (parity_1666 | parity_1669));
  logic or_1776;
  assign or_1776 = (parity_1678 & parity_1681) | ((^select_1647[5:3]) & (parity_1678 | parity_1681));
  // hls/stages/count_bits.hpp:24
  logic parity_1779;
  assign parity_1779 = ^{or_1776, or_1772, or_1768};
  logic parity_1782;
  assign parity_1782 = ^{or_1776, or_1772, or_1768, or_1761, or_1757, or_1753, or_1746, or_1742, and_1738};
  logic xor_1783;
  assign xor_1783 = parity_1737 ^ parity_1782;
  // hls/stages/count_bits.hpp:25
  logic and_1784;
  assign and_1784 = parity_1737 & parity_1782;
  logic or_1788;
  assign or_1788 = (parity_1719 & parity_1734) | ((^{or_1700, or_1696, or_1692}) & (parity_1719 | parity_1734));
  logic or_1792;
  assign or_1792 = (parity_1764 & parity_1779) | ((^{or_1746, or_1742, and_1738}) & (parity_1764 | parity_1779));
  logic or_1799;
  assign or_1799 = (or_1696 & or_1700) | (or_1692 & (or_1696 | or_1700));
  logic or_1803;
  assign or_1803 = (or_1712 & or_1716) | (or_1708 & (or_1712 | or_1716));
  logic or_1807;
  assign or_1807 = (or_1727 & or_1731) | (or_1723 & (or_1727 | or_1731));
  // hls/stages/count_bits.hpp:24
  logic parity_1810;
  assign parity_1810 = ^{or_1807, or_1803, or_1799};
  // hls/stages/count_bits.hpp:25
  logic or_1814;
  assign or_1814 = (or_1742 & or_1746) | (and_1738 & (or_1742 | or_1746));
  logic or_1818;
  assign or_1818 = (or_1757 & or_1761) | (or_1753 & (or_1757 | or_1761));
  logic or_1822;
  assign or_1822 = (or_1772 & or_1776) | (or_1768 & (or_1772 | or_1776));
  // hls/stages/count_bits.hpp:24
  logic parity_1825;
  assign parity_1825 = ^{or_1822, or_1818, or_1814};
  logic parity_1828;
  assign parity_1828 = ^{or_1822, or_1818, or_1814, or_1807, or_1803, or_1799, or_1792, or_1788, and_1784};
  // hls/stages/count_bits.hpp:25
  logic or_1832;
  assign or_1832 = (parity_1810 & parity_1825) | ((^{or_1792, or_1788, and_1784}) & (parity_1810 | parity_1825));
  logic or_1836;
  assign or_1836 = (or_1788 & or_1792) | (and_1784 & (or_1788 | or_1792));
  logic or_1840;
  assign or_1840 = (or_1803 & or_1807) | (or_1799 & (or_1803 | or_1807));
  logic or_1844;
  assign or_1844 = (or_1818 & or_1822) | (or_1814 & (or_1818 | or_1822));
  // hls/stages/count_bits.hpp:24
  logic parity_1849;
  assign parity_1849 = ^{or_1844, or_1840, or_1836, or_1832};
  // hls/stages/count_bits.hpp:25
  logic or_1853;
  assign or_1853 = (or_1840 & or_1844) | (or_1836 & (or_1840 | or_1844));
  logic and_1854;
  assign and_1854 = or_1832 & (^{or_1844, or_1840, or_1836});
  // hls/stages/count_bits.hpp:24
  logic xor_1855;
  assign xor_1855 = or_1853 ^ and_1854;
  // hls/stages/count_bits.hpp:27
  logic and_1856;
  assign and_1856 = or_1853 & and_1854;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1857;
  assign select_1857 = equal_517_s1_q ? {and_1856, xor_1855, parity_1849, parity_1828, xor_1783, xor_1688} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_515_s1_q ? 6'h0 : select_1857;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1859;
  assign select_1859 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1860;
  assign difference_1860 = {1'b0, column_6} - {1'b0, select_1859};
  logic [7:0] sum_1862;
  assign sum_1862 = {difference_1860[6], difference_1860} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:929
  logic [6:0] select_1922;
  assign select_1922 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:932
  logic and_1942;
  assign and_1942 = (or_515_s1_q & (left_rdata_q[61] & not_523_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1964;
  assign or_1964 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/patches.hpp:321
  logic [6:0] select_1975;
  assign select_1975 = so_s1_q ? x_s1_q[6:0] : (or_515_s1_q ? (less_522_s1_q ? 7'h0 : select_1922) : 7'h0);
  // hls/stages/patches.hpp:105
  logic and_2049;
  assign and_2049 = (select_458_s1_q == 3'h0) & (select_460_s1_q == 7'h0);
  // hls/stages/patches.hpp:373
  logic not_2050;
  assign not_2050 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_2053;
  assign not_2053 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:343
  logic and_2054;
  assign and_2054 = patches_capturing_q & not_2053;
  // hls/stages/patches.hpp:293
  logic equal_2057;
  assign equal_2057 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:108
  logic and_2062;
  assign and_2062 = (not_2050 & (patches_work_q == 3'h0)) & (~(and_2054 | ((~equal_2055_s1_q) | (~equal_2057))));
  // hls/stages/patches.hpp:511
  logic equal_2149;
  assign equal_2149 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:489
  logic not_2150;
  assign not_2150 = ~equal_2149;
  // hls/stages/patches.hpp:482
  logic equal_2151;
  assign equal_2151 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:435
  logic not_2152;
  assign not_2152 = ~equal_2151;
  // hls/stages/patches.hpp:476
  logic equal_2153;
  assign equal_2153 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:150
  logic equal_2154;
  assign equal_2154 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:511
  logic or_2155;
  assign or_2155 = equal_2153 | equal_2154;
  // hls/stages/patches.hpp:437
  logic not_2156;
  assign not_2156 = ~patches_second_q;
  // hls/stages/patches.hpp:354
  logic [4:0] select_2178;
  assign select_2178 = and_2062 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:109
  logic [4:0] select_2179;
  assign select_2179 = and_2049 ? select_2178 : patches_row_q;
  // hls/stages/patches.hpp:108
  logic and_2181;
  assign and_2181 = and_2054 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:109
  logic select_2185;
  assign select_2185 = and_2049 ? (and_2062 | (and_2054 & (~and_2181))) : patches_capturing_q;
  // hls/stages/patches.hpp:167
  logic and_2193;
  assign and_2193 = not_2150 & (not_2152 & (or_2155 & (patches_second_q & equal_2154)));
  // hls/stages/patches.hpp:150
  logic not_2210;
  assign not_2210 = ~equal_2154;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2226;
  assign select_2226 = and_2049 ? {select_2178[4], select_2178[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:435
  logic and_2236;
  assign and_2236 = not_2150 & (or_2155 & not_2152);
  // hls/stages/agreement.hpp:443
  logic [5:0] or_2620;
  assign or_2620 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:447
  logic select_2839;
  assign select_2839 = equal_2745_s1_q ? (~({row_s1_q, 1'b0} < {sum_2836, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_3028;
  assign and_3028 = and_494_s1_q & (equal_2745_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:299
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:109
  logic [3:0] select_3138;
  assign select_3138 = and_2049 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3139;
  assign select_3139 = sample_pair_whole_s1_q ? select_3138 : patches_phase_q;
  // hls/stages/patches.hpp:354
  logic and_3140;
  assign and_3140 = not_2053 & equal_2055_s1_q;
  logic [8:0] select_3141;
  assign select_3141 = and_3140 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3142;
  assign select_3142 = and_3140 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3143;
  assign select_3143 = sample_pair_first_s1_q ? select_3141 : select_3142;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3145;
  assign select_3145 = sample_pair_whole_s1_q ? (and_2049 ? select_3143[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3147;
  assign select_3147 = sample_pair_whole_s1_q ? (and_2049 ? select_3143[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3150;
  assign select_3150 = sample_pair_whole_s1_q ? (equal_2057 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3152;
  assign select_3152 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_2057}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:312
  logic equal_3153;
  assign equal_3153 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:313
  logic not_3154;
  assign not_3154 = ~equal_3153;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3156;
  assign select_3156 = sample_pair_whole_s1_q ? (phase + {not_3154, 1'b1, not_3154, equal_3153}) : patches_first_band_rows_to_next_q;
  logic select_3157;
  assign select_3157 = sample_pair_whole_s1_q ? equal_3153 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:457
  logic equal_3158;
  assign equal_3158 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:70
  logic [3:0] select_3162;
  assign select_3162 = equal_3158 ? ((select_3139 == 4'h6) ? 4'h0 : (select_3139 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3163;
  assign equal_3163 = select_3162 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_3166;
  assign select_3166 = equal_2745_s1_q ? (equal_3163 ? 4'h6 : (select_3162 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:70
  logic [4:0] select_3168;
  assign select_3168 = equal_3158 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_3170;
  assign select_3170 = equal_2745_s1_q ? (select_3168 + {4'h0, equal_3163}) : patches_choosing_number_q;
  logic select_3174;
  assign select_3174 = equal_2745_s1_q ? ((6'h2 < row_s1_q) & equal_3163) : patches_chooses_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_3177;
  assign select_3177 = and_494_s1_q ? (equal_2745_s1_q ? select_3168 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:109
  logic select_3206;
  assign select_3206 = and_2049 ? (and_2062 ? not_3204_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:374
  logic or_3245;
  assign or_3245 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:376
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:170
  logic and_3251;
  assign and_3251 = equal_2149 & not_2156;
  // hls/stages/patches.hpp:380
  logic and_3252;
  assign and_3252 = not_2210 & and_3251;
  logic [1:0] select_3254;
  assign select_3254 = equal_2151 ? 2'h0 : (equal_2153 ? 2'h3 : {equal_2154, and_3252});
  // hls/stages/patches.hpp:261
  logic equal_3256;
  assign equal_3256 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:259
  logic not_3257;
  assign not_3257 = ~equal_3256;
  // hls/stages/patches.hpp:261
  logic equal_3258;
  assign equal_3258 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:257
  logic not_3259;
  assign not_3259 = ~equal_3258;
  // hls/stages/patches.hpp:265
  logic not_3261;
  assign not_3261 = ~(patches_following_q == 3'h2);
  logic and_3264;
  assign and_3264 = (~(patches_following_q == 3'h1)) & not_3261;
  // hls/stages/patches.hpp:378
  logic [1:0] select_3265;
  assign select_3265 = equal_3258 ? 2'h2 : {and_3264, not_3261};
  logic [3:0] select_3266;
  assign select_3266 = equal_3256 ? 4'h2 : {select_3265, {2{not_3259}}};
  // hls/stages/patches.hpp:386
  logic not_3269;
  assign not_3269 = ~or_3245;
  // hls/stages/patches.hpp:375
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:387
  logic [11:0] select_3274;
  assign select_3274 = or_3245 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:170
  logic [4:0] select_3276;
  assign select_3276 = or_3245 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1298; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_515_s1_q ? select_1922 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_636_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:740; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
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

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:740; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
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

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:741; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
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

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:752; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign left_we = s1_en & and_526_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_618, left_rdata_q[59:45], and_617, left_rdata_q[43:29], and_616, left_rdata_q[27:13], and_615, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_526_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_627, right_codes_rdata_q[76:65], and_626, right_codes_rdata_q[63:52], and_625, right_codes_rdata_q[50:39], and_624, right_codes_rdata_q[37:26], and_623, right_codes_rdata_q[24:13], and_622, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_494_s1_q ? (equal_2745_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_494_s1_q ? select_2839 : lower_half_q;
      patches_phase_q <= select_3139;
      patches_band_rows_rows_to_next_q <= select_3145;
      patches_band_rows_number_q <= select_3147;
      patches_next_band_rows_to_next_q <= select_3150;
      patches_next_band_number_q <= select_3152;
      patches_first_band_rows_to_next_q <= select_3156;
      patches_first_band_number_q <= select_3157;
      patches_choosing_rows_to_next_q <= and_494_s1_q ? select_3166 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_494_s1_q ? select_3170 : patches_choosing_number_q;
      patches_chooses_q <= and_494_s1_q ? select_3174 : patches_chooses_q;
      patches_choosing_band_q <= select_3177;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_2185 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_3206 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_2179 : patches_row_q;
      patches_work_q <= or_3245 ? following : patches_work_q;
      patches_second_q <= not_2050 & (patches_second_q | (patches_ends_q & equal_2149));
      patches_following_q <= equal_2149 ? {2'h0, and_3251} : {equal_2151, select_3254};
      patches_following_beats_q <= {select_3266, not_3257};
      patches_begins_q <= sample_pair_whole_s1_q & (and_2049 & and_2181);
      patches_ends_q <= not_3269 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3274;
      patches_code_row_q <= select_3276;
      patches_column_q <= or_3245 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3269 & (patches_column_q == 5'h1e);
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
      middle_sum_sum_sums_values_0_q <= sum_898;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1138;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1378;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1622;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1862;
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
  logic [2:0] select_458_s2_q;
  logic [6:0] select_460_s2_q;
  logic [8:0] select_464_s2_q;
  logic and_468_s2_q;
  logic equal_474_s2_q;
  logic [6:0] column_s2_q;
  logic and_492_s2_q;
  logic and_494_s2_q;
  logic so_s2_q;
  logic equal_514_s2_q;
  logic or_515_s2_q;
  logic less_522_s2_q;
  logic not_523_s2_q;
  logic equal_555_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_643_s2_q;
  logic and_1918_s2_q;
  logic [6:0] right_s2_q;
  logic select_1927_s2_q;
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
  logic and_3029_s2_q;
  logic and_3031_s2_q;
  logic or_3245_s2_q;
  logic not_3269_s2_q;
  logic less_4031_s2_q;
  logic equal_4236_s2_q;
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
      select_458_s2_q <= select_458_s1_q;
      select_460_s2_q <= select_460_s1_q;
      select_464_s2_q <= select_464_s1_q;
      and_468_s2_q <= and_468_s1_q;
      equal_474_s2_q <= equal_474_s1_q;
      column_s2_q <= column_s1_q;
      and_492_s2_q <= and_492_s1_q;
      and_494_s2_q <= and_494_s1_q;
      so_s2_q <= so_s1_q;
      equal_514_s2_q <= equal_514_s1_q;
      or_515_s2_q <= or_515_s1_q;
      less_522_s2_q <= less_522_s1_q;
      not_523_s2_q <= not_523_s1_q;
      equal_555_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_643_s2_q <= select_643_s1_q;
      and_1918_s2_q <= and_1918_s1_q;
      right_s2_q <= right_s1_q;
      select_1927_s2_q <= select_1927_s1_q;
      equal_1936_s2_q <= equal_1936_s1_q;
      and_1943_s2_q <= not_523_s1_q & and_1942;
      and_1946_s2_q <= (or_515_s1_q & (left_rdata_q[62] & not_523_s1_q)) & and_1942;
      and_1950_s2_q <= not_523_s1_q & (or_515_s1_q & (left_rdata_q[63] & not_523_s1_q));
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
      and_3029_s2_q <= and_2746_s1_q & and_3028;
      and_3031_s2_q <= and_2746_s1_q & (~and_3028);
      or_3245_s2_q <= or_3245;
      not_3269_s2_q <= not_3269;
      less_4031_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4236_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic and_469;
  assign and_469 = sample_pair_whole_s2_q & and_468_s2_q;
  // hls/stages/agreement.hpp:772
  logic not_645;
  assign not_645 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_646;
  assign less_646 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:231
  logic and_648;
  assign and_648 = not_645 & (~less_646);
  // hls/stages/agreement.hpp:735
  logic less_1379;
  assign less_1379 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1380;
  assign select_1380 = less_1379 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1381;
  assign less_1381 = middle_sum_sum_sums_values_0_q < select_1380;
  logic [7:0] select_1382;
  assign select_1382 = less_1381 ? select_1380 : middle_sum_sum_sums_values_0_q;
  logic less_1863;
  assign less_1863 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1864;
  assign select_1864 = less_1863 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1865;
  assign less_1865 = select_1382 < select_1864;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_648 ? (less_1865 ? select_1864 : select_1382) : 8'h0;
  // hls/stages/agreement.hpp:783
  logic or_1869;
  assign or_1869 = select_643_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1870;
  assign select_1870 = or_1869 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:736
  logic or_1872;
  assign or_1872 = less_1379 | (~less_1381);
  logic [2:0] select_1873;
  assign select_1873 = less_1865 ? {less_1863, 2'h0} : {1'b0, or_1872, less_1381};
  // hls/stages/agreement.hpp:788
  logic [2:0] select_1874;
  assign select_1874 = or_1869 ? select_1873 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1875;
  assign select_1875 = or_1869 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:785
  logic equal_1876;
  assign equal_1876 = select_1873 == 3'h1;
  logic equal_1877;
  assign equal_1877 = select_1873 == 3'h2;
  logic not_1878;
  assign not_1878 = ~equal_1877;
  logic [1:0] select_1879;
  assign select_1879 = equal_1876 ? 2'h0 : {not_1878, equal_1877};
  logic [7:0] select_1880;
  assign select_1880 = select_1879[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1881;
  assign select_1881 = select_1879[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1883;
  assign select_1883 = or_1869 ? (select_1879[1] ? select_1880 : select_1881) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:786
  logic [2:0] select_1884;
  assign select_1884 = equal_1876 ? 3'h2 : {not_1878, {2{equal_1877}}};
  logic [7:0] select_1885;
  assign select_1885 = select_1884[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1886;
  assign select_1886 = select_1884[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic [7:0] select_1888;
  assign select_1888 = select_1884[2] ? sums_3_sum_sums_values_0_q : (select_1884[1] ? select_1885 : select_1886);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1889;
  assign select_1889 = or_1869 ? select_1888 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1891;
  assign sum_1891 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1892;
  assign sum_1892 = {1'b0, before_v} + sum_1891;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1894;
  assign sum_1894 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1895;
  assign sum_1895 = {1'b0, before_v_2} + sum_1894;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1897;
  assign sum_1897 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1898;
  assign sum_1898 = {1'b0, before_v_3} + sum_1897;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1900;
  assign select_1900 = (sum_1895 < sum_1898) ? sum_1898 : sum_1895;
  logic [6:0] select_1902;
  assign select_1902 = (sum_1892 < select_1900) ? select_1900 : sum_1892;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1904;
  assign sum_1904 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1905;
  assign sum_1905 = {1'b0, before_v_4} + sum_1904;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1907;
  assign sum_1907 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1908;
  assign sum_1908 = {1'b0, before_v_5} + sum_1907;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1910;
  assign select_1910 = (sum_1905 < sum_1908) ? sum_1908 : sum_1905;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_648 ? ((select_1902 < select_1910) ? select_1910 : select_1902) : 7'h0;
  // hls/stages/agreement.hpp:788
  logic or_1915;
  assign or_1915 = select_643_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:792
  logic [6:0] select_1916;
  assign select_1916 = or_1915 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1917;
  assign select_1917 = or_1915 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:797
  logic or_1929;
  assign or_1929 = select_1927_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1930;
  assign select_1930 = or_1929 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1931;
  assign select_1931 = or_1929 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1933;
  assign or_1933 = select_1927_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1934;
  assign select_1934 = or_1933 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1935;
  assign select_1935 = or_1933 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic not_1937;
  assign not_1937 = ~equal_1936_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1947;
  assign and_1947 = not_523_s2_q & and_1946_s2_q;
  // hls/stages/agreement.hpp:935
  logic select_1953;
  assign select_1953 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1956;
  assign difference_1956 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:943
  logic [9:0] sum_1957;
  assign sum_1957 = {difference_1956[8], difference_1956} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1959;
  assign and_1959 = (and_1946_s2_q & select_1953) & ({{22{sum_1957[9]}}, sum_1957} < 32'h3);
  logic and_1960;
  assign and_1960 = not_523_s2_q & and_1959;
  logic and_1966;
  assign and_1966 = not_523_s2_q & (and_1959 & or_1964_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1967;
  assign select_1967 = less_522_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_515_s2_q ? {select_1967, and_1966, and_1960, and_1950_s2_q, and_1947, and_1943_s2_q, not_523_s2_q} : 15'h0;
  // hls/stages/patches.hpp:321
  logic and_1969;
  assign and_1969 = ends_cell_s2_q & shift_2[0];
  logic and_1971;
  assign and_1971 = not_1937 & (so_s2_q & and_1969);
  // hls/stages/agreement.hpp:955
  logic [5:0] sum_2021;
  assign sum_2021 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2[0] & ({1'b0, sum_2021, last_s2_q[1]} < x_s2_q);
  // hls/stages/patches.hpp:86
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/registration.hpp:218
  logic [16:0] select_2079;
  assign select_2079 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2079[16:7])) ? 8'h7f : select_2079[7:0];
  // hls/stages/patches.hpp:87
  logic and_2102;
  assign and_2102 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:89
  logic equal_2103;
  assign equal_2103 = x_s2_q == 8'h0;
  // hls/stages/patches.hpp:85
  logic [9:0] sum_2109;
  assign sum_2109 = {2'h0, x_s2_q} + {{4{shift_2[11]}}, shift_2[11:6]};
  // hls/stages/patches.hpp:89
  logic [9:0] sum_2111;
  assign sum_2111 = {sum_2109[9], sum_2109[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:964
  logic and_2114;
  assign and_2114 = ($signed(9'h0) < $signed(sum_2109[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2111, sum_2109[0]})));
  logic and_2115;
  assign and_2115 = (~(and_2102 | (equal_2103 | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2114;
  // hls/stages/patches.hpp:96
  logic equal_2142;
  assign equal_2142 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/patches.hpp:321
  logic and_2146;
  assign and_2146 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (and_2102 | equal_2142)));
  logic and_2147;
  assign and_2147 = not_1937 & and_2146;
  // hls/stages/patches.hpp:155
  logic [7:0] pixel;
  assign pixel = equal_2154_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2154_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:477
  logic less_2242;
  assign less_2242 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:478
  logic or_2243;
  assign or_2243 = equal_2153_s2_q | less_2242;
  // hls/stages/patches.hpp:481
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2248;
  assign select_2248 = equal_2153_s2_q ? patches_column_s2_q[0] : (or_2243 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2249;
  assign not_2249 = ~or_2243;
  // hls/stages/patches.hpp:478
  logic [4:0] sum_2250;
  assign sum_2250 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:480
  logic [4:0] select_2253;
  assign select_2253 = or_2243 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2250) + 5'h1) : sum_2250;
  // hls/stages/patches.hpp:482
  logic [4:0] select_2254;
  assign select_2254 = equal_2153_s2_q ? 5'h0 : select_2253;
  logic or_2255;
  assign or_2255 = equal_2153_s2_q | equal_2151_s2_q;
  // hls/stages/patches.hpp:458
  logic equal_2257;
  assign equal_2257 = patches_column_s2_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s2_q == 5'h11;
  logic equal_2259;
  assign equal_2259 = patches_column_s2_q == 5'h18;
  // hls/stages/patches.hpp:460
  logic and_2261;
  assign and_2261 = of_row & (~equal_2259);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2257 ? 2'h3 : {equal_2259, and_2261};
  // hls/stages/patches.hpp:446
  logic [8:0] sum_2264;
  assign sum_2264 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2265;
  assign sum_2265 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2264, pixel_2[0]} - {1'b0, sum_2265, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:448
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
  // hls/stages/patches.hpp:444
  logic [8:0] sum_2274;
  assign sum_2274 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2275;
  assign sum_2275 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2274};
  logic [10:0] sum_2276;
  assign sum_2276 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2275, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2277;
  assign sum_2277 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2276[10:1];
  // hls/stages/patches.hpp:445
  logic [11:0] smooth;
  assign smooth = {sum_2277, sum_2276[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:447
  logic [12:0] sum_2279;
  assign sum_2279 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2280;
  assign sum_2280 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2281;
  assign difference_2281 = {1'b0, sum_2279, smooth[0]} - {1'b0, sum_2280, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:459
  logic or_2287;
  assign or_2287 = (((patches_column_s2_q == 5'ha) | of_row) | equal_2259) | equal_2257;
  // hls/stages/patches.hpp:454
  logic and_2292;
  assign and_2292 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:167
  logic and_2296;
  assign and_2296 = not_2152_s2_q & (or_2155_s2_q & (or_2287 & (equal_2154_s2_q & and_2292)));
  // hls/stages/patches.hpp:155
  logic and_2306;
  assign and_2306 = (~(equal_2154_s2_q | (~and_2292))) & (~patches_column_s2_q[4]);
  // hls/stages/patches.hpp:167
  logic and_2310;
  assign and_2310 = not_2152_s2_q & (or_2155_s2_q & (and_2306 & (patches_column_s2_q == 5'hf)));
  // hls/stages/patches.hpp:523
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
  // hls/stages/patches.hpp:537
  logic select_2319;
  assign select_2319 = equal_2315 ? (less_2312 & (less_2312 & not_2316)) : less_2312;
  // hls/stages/patches.hpp:167
  logic and_2322;
  assign and_2322 = equal_2149_s2_q & (less_2312 ? (not_2314 & select_2319) : select_2319);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2343;
  assign sum_2343 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/patches.hpp:321
  logic and_2479;
  assign and_2479 = ends_cell_s2_q & (and_2475_s2_q & (~({sum_2021, last_s2_q[1:0]} < x_s2_q)));
  // hls/stages/registration.hpp:76
  logic less_2926;
  assign less_2926 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2928;
  assign select_2928 = or_515_s2_q ? (less_522_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2930;
  assign select_2930 = or_515_s2_q ? (less_522_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2932;
  assign select_2932 = or_515_s2_q ? (less_522_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2930} - {1'b0, select_2932};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2934;
  assign select_2934 = rise[8] ? select_2930 : select_2932;
  logic [8:0] difference_2935;
  assign difference_2935 = {1'b0, select_2928} - {1'b0, select_2934};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2935[8] ? 8'h0 : difference_2935[7:0];
  // hls/stages/registration.hpp:37
  logic not_2937;
  assign not_2937 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2926 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2937};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2939;
  assign xor_2939 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2939};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2945;
  assign select_2945 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2926 ? {taken, 1'b1} : {not_2937, select_2945, not_2937};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2947;
  assign sum_2947 = {left, 1'b1} + {taken_2, less_2926};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2949;
  assign select_2949 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_3032;
  assign select_3032 = and_3031_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3034;
  assign select_3034 = and_3029_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3032[15]}}, select_3032});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3035;
  assign select_3035 = and_3031_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3035[15]}}, select_3035};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3037;
  assign select_3037 = and_3029_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_3038;
  assign and_3038 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_8;
  assign column_8 = registration_slope_q + (and_3038 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:74
  logic parity_3181;
  assign parity_3181 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_3182;
  assign select_3182 = equal_2745_s2_q ? {patches_chance_q[14:0], parity_3181} : patches_chance_q;
  // hls/stages/patches.hpp:91
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:92
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:93
  logic [5:0] select_3187;
  assign select_3187 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3187};
  // hls/stages/patches.hpp:321
  logic and_3193;
  assign and_3193 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:170
  logic select_3284;
  assign select_3284 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:167
  logic [11:0] select_3287;
  assign select_3287 = equal_2151_s2_q ? patches_smooth_values_0_q : (or_2155_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3289;
  assign select_3289 = or_2155_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3291;
  assign select_3291 = equal_2149_s2_q ? patches_smooth_values_1_q : (equal_2151_s2_q ? patches_smooth_values_1_q : select_3289);
  logic [11:0] select_3292;
  assign select_3292 = or_2155_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3294;
  assign select_3294 = equal_2149_s2_q ? patches_smooth_values_2_q : (equal_2151_s2_q ? patches_smooth_values_2_q : select_3292);
  logic [11:0] select_3295;
  assign select_3295 = or_2155_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3297;
  assign select_3297 = equal_2149_s2_q ? patches_smooth_values_3_q : (equal_2151_s2_q ? patches_smooth_values_3_q : select_3295);
  logic [10:0] select_3299;
  assign select_3299 = equal_2151_s2_q ? patches_down_values_0_q : (or_2155_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3302;
  assign select_3302 = equal_2151_s2_q ? patches_down_values_1_q : (or_2155_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3305;
  assign select_3305 = equal_2151_s2_q ? patches_down_values_2_q : (or_2155_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3308;
  assign select_3308 = equal_2151_s2_q ? patches_down_values_3_q : (or_2155_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:158
  logic and_3345;
  assign and_3345 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:394
  logic [4:0] select_3350;
  assign select_3350 = or_3245_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:396
  logic [3:0] select_3352;
  assign select_3352 = and_3345 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:167
  logic [4:0] select_3708;
  assign select_3708 = equal_2149_s2_q ? patches_summed_down_by_q : (equal_2151_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:533
  logic and_3741;
  assign and_3741 = less_2312 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:537
  logic select_3744;
  assign select_3744 = equal_2315 ? (less_2312 ? (not_2316 & and_3741) : and_3741) : and_3741;
  // hls/stages/patches.hpp:167
  logic select_3747;
  assign select_3747 = equal_2149_s2_q ? (less_2312 ? (not_2314 & select_3744) : select_3744) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_4043;
  assign select_4043 = so_s2_q ? (and_3038 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4045;
  assign sum_4045 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4046;
  assign select_4046 = sum_2343[5] ? {1'b1, sum_2343[4:0], region_across_rest_q[2:0]} : sum_4045;
  // hls/stages/agreement.hpp:447
  logic [8:0] select_4048;
  assign select_4048 = equal_2745_s2_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4051;
  assign select_4051 = equal_2745_s2_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_464_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_469;
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
  assign census_memory_re = s2_en & and_494_s2_q;
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

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:757; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:758; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
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

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:772; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
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
  assign best_left_wdata = {select_1917, select_1916, select_1889, select_1883, select_1875, select_1874, select_1870};
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
      registration_displacement_over_q <= so_s2_q ? sum_2947[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2949;
      registration_slope_row_q <= select_3034;
      registration_slope_change_q <= select_3037;
      registration_slope_q <= so_s2_q ? column_8 : {registration_slope_row_q, 4'h0};
      patches_chance_q <= and_494_s2_q ? select_3182 : patches_chance_q;
      patches_along_ends_q <= not_3269_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3269_s2_q & select_3284;
      patches_smooth_values_0_q <= equal_2149_s2_q ? patches_smooth_values_0_q : select_3287;
      patches_smooth_values_1_q <= select_3291;
      patches_smooth_values_2_q <= select_3294;
      patches_smooth_values_3_q <= select_3297;
      patches_down_values_0_q <= equal_2149_s2_q ? patches_down_values_0_q : select_3299;
      patches_down_values_1_q <= equal_2149_s2_q ? patches_down_values_1_q : select_3302;
      patches_down_values_2_q <= equal_2149_s2_q ? patches_down_values_2_q : select_3305;
      patches_down_values_3_q <= equal_2149_s2_q ? patches_down_values_3_q : select_3308;
      patches_down_by_q <= or_3245_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3345});
      patches_along_q <= select_3350;
      patches_match_row_q <= or_3245_s2_q ? 4'h0 : select_3352;
      patches_summed_last_q <= not_2150_s2_q & (equal_2151_s2_q & and_3345);
      patches_summed_down_by_q <= select_3708;
      patches_step_q <= or_3245_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3747;
      region_across_rest_q <= select_4043;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4046;
      columns_begin_rest_q <= and_494_s2_q ? select_4048 : columns_begin_rest_q;
      columns_begin_back_q <= and_494_s2_q ? select_4051 : columns_begin_back_q;
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
  logic [2:0] select_458_s3_q;
  logic [6:0] select_460_s3_q;
  logic [8:0] select_464_s3_q;
  logic and_468_s3_q;
  logic and_469_s3_q;
  logic equal_474_s3_q;
  logic [6:0] column_s3_q;
  logic and_492_s3_q;
  logic and_494_s3_q;
  logic so_s3_q;
  logic equal_555_s3_q;
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
  logic less_2963_s3_q;
  logic and_3194_s3_q;
  logic less_3321_s3_q;
  logic equal_3664_s3_q;
  logic equal_3748_s3_q;
  logic less_4031_s3_q;
  logic equal_4236_s3_q;
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
      select_458_s3_q <= select_458_s2_q;
      select_460_s3_q <= select_460_s2_q;
      select_464_s3_q <= select_464_s2_q;
      and_468_s3_q <= and_468_s2_q;
      and_469_s3_q <= and_469;
      equal_474_s3_q <= equal_474_s2_q;
      column_s3_q <= column_s2_q;
      and_492_s3_q <= and_492_s2_q;
      and_494_s3_q <= and_494_s2_q;
      so_s3_q <= so_s2_q;
      equal_555_s3_q <= equal_555_s2_q;
      equal_1936_s3_q <= equal_1936_s2_q;
      not_1937_s3_q <= not_1937;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1971_s3_q <= and_1971;
      select_1975_s3_q <= select_1975_s2_q;
      and_1980_s3_q <= not_1937 & (so_s2_q ? and_1969 : (equal_514_s2_q & shift_2[4]));
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
      less_2963_s3_q <= select_2930 < select_2932;
      and_3194_s3_q <= not_1937 & and_3193;
      less_3321_s3_q <= 4'he < patches_column_s2_q[4:1];
      equal_3664_s3_q <= patches_match_row_q == 4'h0;
      equal_3748_s3_q <= patches_step_q[6:5] == 2'h2;
      less_4031_s3_q <= less_4031_s2_q;
      equal_4236_s3_q <= equal_4236_s2_q;
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
  logic [11:0] select_472;
  assign select_472 = select_458_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_476;
  assign sum_476 = select_472 + (equal_474_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_478;
  assign sum_478 = {4'h0, sample_pair_pixel_1_q} + (select_458_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_480;
  assign sum_480 = sum_478 + (equal_474_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = select_458_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_484;
  assign and_484 = whole & (averager_memory_rdata_q[24] | equal_474_s3_q);
  // hls/stages/agreement.hpp:404
  logic all_of_skin;
  assign all_of_skin = select_458_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_488;
  assign and_488 = all_of_skin & (averager_memory_rdata_q[25] | equal_474_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_468_s3_q ? sum_476[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_497;
  assign equal_497 = select_458_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_497 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_500;
  assign select_500 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_468_s3_q ? sum_480[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_497 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_504;
  assign select_504 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_505;
  assign and_505 = and_468_s3_q & and_484;
  // hls/stages/census.hpp:126
  logic select_507;
  assign select_507 = equal_497 ? and_505 : (averager_mask_q & and_505);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_507;
  // hls/stages/census.hpp:206
  logic and_509;
  assign and_509 = and_468_s3_q & and_488;
  // hls/stages/census.hpp:126
  logic select_511;
  assign select_511 = equal_497 ? and_509 : (averager_of_skin_q & and_509);
  // hls/stages/agreement.hpp:263
  logic and_512;
  assign and_512 = sample_pair_whole_s3_q & select_511;
  // hls/stages/census.hpp:294
  logic less_528;
  assign less_528 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_529;
  assign less_529 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_530;
  assign less_530 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_531;
  assign less_531 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_532;
  assign less_532 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_533;
  assign less_533 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_534;
  assign less_534 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_535;
  assign less_535 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_536;
  assign less_536 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_537;
  assign less_537 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_538;
  assign less_538 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_539;
  assign less_539 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_540;
  assign less_540 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_541;
  assign less_541 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_542;
  assign less_542 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_543;
  assign less_543 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_544;
  assign less_544 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_545;
  assign less_545 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_546;
  assign less_546 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_547;
  assign less_547 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_548;
  assign less_548 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_549;
  assign less_549 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_550;
  assign less_550 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_551;
  assign less_551 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:442
  logic equal_552;
  assign equal_552 = column_s3_q == 7'h0;
  logic [3:0] select_556;
  assign select_556 = equal_555_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_557;
  assign select_557 = equal_552 ? {select_556, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_558;
  assign select_558 = equal_552 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_559;
  assign and_559 = select_557[4] & select_558[3];
  // hls/stages/census.hpp:286
  logic and_561;
  assign and_561 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_563;
  assign and_563 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_561);
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_563;
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
  logic [9:0] difference_586;
  assign difference_586 = {1'b0, select_500} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_587;
  assign xor_587 = difference_586[8:0] ^ {9{difference_586[9]}};
  logic [9:0] sum_588;
  assign sum_588 = {9'h0, difference_586[9]} + {1'b0, xor_587};
  logic [9:0] difference_589;
  assign difference_589 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_590;
  assign xor_590 = difference_589[8:0] ^ {9{difference_589[9]}};
  logic [9:0] sum_591;
  assign sum_591 = {9'h0, difference_589[9]} + {1'b0, xor_590};
  logic [9:0] difference_593;
  assign difference_593 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_594;
  assign xor_594 = difference_593[8:0] ^ {9{difference_593[9]}};
  logic [9:0] sum_595;
  assign sum_595 = {9'h0, difference_593[9]} + {1'b0, xor_594};
  logic [10:0] sum_596;
  assign sum_596 = ({1'b0, sum_588} + {1'b0, sum_591}) + {1'b0, sum_595};
  logic [9:0] difference_597;
  assign difference_597 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_598;
  assign xor_598 = difference_597[8:0] ^ {9{difference_597[9]}};
  logic [9:0] sum_599;
  assign sum_599 = {9'h0, difference_597[9]} + {1'b0, xor_598};
  logic [9:0] difference_601;
  assign difference_601 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_602;
  assign xor_602 = difference_601[8:0] ^ {9{difference_601[9]}};
  // hls/stages/agreement.hpp:193
  logic not_1976;
  assign not_1976 = ~so_s3_q;
  // hls/stages/patches.hpp:321
  logic and_1977;
  assign and_1977 = not_1976 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1070
  logic equal_1981;
  assign equal_1981 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1984;
  assign select_1984 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1084
  logic [3:0] select_1986;
  assign select_1986 = equal_1981 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1984});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1987;
  assign sum_1987 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:321
  logic [3:0] select_1988;
  assign select_1988 = equal_1936_s3_q ? select_1986 : {sum_1987, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:192
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
  // hls/stages/agreement.hpp:1116
  logic and_2007;
  assign and_2007 = (~equal_1997) & ((~equal_1999) & ((~equal_2001) & (~equal_2003)));
  logic and_2011;
  assign and_2011 = (~equal_1989) & ((~equal_1991) & ((~equal_1993) & ((~equal_1995) & and_2007)));
  // hls/stages/agreement.hpp:1071
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
  // hls/stages/patches.hpp:321
  logic and_2030;
  assign and_2030 = so_s3_q & and_2029;
  logic select_2031;
  assign select_2031 = equal_1936_s3_q ? (x_s3_q[6] & (equal_1981 ? and_2011 : (less_2012 & (~or_2016)))) : and_2030;
  // hls/stages/registration.hpp:258
  logic not_2033;
  assign not_2033 = ~lower_half_s3_q;
  logic [3:0] select_2034;
  assign select_2034 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_2033, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_2033};
  // hls/stages/patches.hpp:354
  logic [1:0] select_2063;
  assign select_2063 = and_2062_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2064;
  assign select_2064 = and_2062_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_2065;
  assign select_2065 = and_2049_s3_q ? {select_2064, select_2063[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:109
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
  // hls/stages/patches.hpp:81
  logic [9:0] sum_2095;
  assign sum_2095 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:964
  logic and_2097;
  assign and_2097 = shift_2_s3_q[3] & ({{4{sum_2095[9]}}, sum_2095, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:321
  logic and_2118;
  assign and_2118 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_2076_s3_q & and_2097) & and_2115_s3_q));
  logic and_2120;
  assign and_2120 = not_1937_s3_q & (so_s3_q & and_2118);
  // hls/stages/patches.hpp:139
  logic and_2122;
  assign and_2122 = and_2120 & (~patches_fixed_q);
  // hls/stages/patches.hpp:321
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
  // hls/stages/patches.hpp:321
  logic [7:0] select_2139;
  assign select_2139 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2140;
  assign select_2140 = equal_1936_s3_q ? 8'h0 : select_2139;
  // hls/stages/patches.hpp:324
  logic [22:0] select_2141;
  assign select_2141 = and_2122 ? {select_2140, select_2130, select_2126, and_2120} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:109
  logic [4:0] select_2162;
  assign select_2162 = and_2049_s3_q ? select_2064 : patches_band_q;
  // hls/stages/patches.hpp:334
  logic equal_2163;
  assign equal_2163 = {patches_choosing_band_s3_q, and_2075_s3_q} == {select_2162, select_2066[1]};
  // hls/stages/patches.hpp:463
  logic [2:0] sum_2263;
  assign sum_2263 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:467
  logic [1:0] sum_2301;
  assign sum_2301 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_2330;
  assign select_2330 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_2333;
  assign or_2333 = select_2330[7] | (~({select_2330[5], select_2330[3], select_2330[1]} == 3'h0));
  // hls/stages/agreement.hpp:991
  logic or_2336;
  assign or_2336 = select_2330[7] | (~({select_2330[6], select_2330[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:990
  logic or_2339;
  assign or_2339 = select_2330[7] | (~(select_2330[6:4] == 3'h0));
  // hls/stages/patches.hpp:321
  logic [5:0] select_2340;
  assign select_2340 = equal_1936_s3_q ? x_s3_q[5:0] : {region_row_q, or_2339, or_2336, or_2333};
  // hls/stages/agreement.hpp:1070
  logic not_2341;
  assign not_2341 = ~equal_1981;
  // hls/stages/agreement.hpp:1000
  logic or_2345;
  assign or_2345 = (~sum_2343_s3_q) | equal_2142_s3_q;
  // hls/stages/patches.hpp:321
  logic and_2348;
  assign and_2348 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_2345));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_2369;
  assign and_2369 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:960
  logic select_2370;
  assign select_2370 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_2370);
  // hls/stages/agreement.hpp:960
  logic select_2373;
  assign select_2373 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_2370 ? select_2373 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1202
  logic or_2376;
  assign or_2376 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1204
  logic [16:0] select_2378;
  assign select_2378 = marks_first_s3_q ? 17'h1 : (or_2376 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1203
  logic [8:0] select_2380;
  assign select_2380 = or_2376 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1211
  logic select_2382;
  assign select_2382 = cfg_compete_i ? (or_2376 & select_2378[16]) : (select_2380[8] & select_2378[9]);
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = select_2382 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1218
  logic [6:0] select_2385;
  assign select_2385 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2387;
  assign select_2387 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_2385});
  // hls/stages/agreement.hpp:1228
  logic equal_2388;
  assign equal_2388 = seen_x_q == 3'h7;
  logic [7:0] select_2390;
  assign select_2390 = select_2382 ? 8'h0 : (seen_column_q + {7'h0, equal_2388});
  // hls/stages/agreement.hpp:1235
  logic [12:0] index;
  assign index = select_2387 + {5'h0, select_2390};
  // hls/stages/agreement.hpp:1202
  logic select_2393;
  assign select_2393 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1188
  logic [7:0] sum_2394;
  assign sum_2394 = {1'b0, select_2393, 2'h0, select_2393, 1'b0, {2{select_2393}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1201
  logic not_2395;
  assign not_2395 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:422
  logic and_2397;
  assign and_2397 = not_2395 & (began_q | select_2382);
  // hls/stages/agreement.hpp:1229
  logic [2:0] select_2399;
  assign select_2399 = select_2382 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1234
  logic and_2401;
  assign and_2401 = and_2397 & (select_2399 == 3'h0);
  logic less_2402;
  assign less_2402 = select_2390 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1053
  logic [7:0] sum_2405;
  assign sum_2405 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2405[7]}}, sum_2405, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1188
  logic [7:0] sum_2407;
  assign sum_2407 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:976
  logic and_2408;
  assign and_2408 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_2409;
  assign and_2409 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_2410;
  assign and_2410 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_2411;
  assign and_2411 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_2413;
  assign sum_2413 = {1'b0, and_2410} + ({1'b0, textured_s3_q} + {1'b0, and_2411});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2408} + ({2'h0, and_2409} + {1'b0, sum_2413});
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_2416;
  assign select_2416 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2417;
  assign difference_2417 = {1'b0, textured_2} - {1'b0, select_2416};
  logic [4:0] t;
  assign t = {difference_2417[3], difference_2417} + (equal_2103_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_2422;
  assign select_2422 = shift_2_s3_q[0] ? (sum_2343_s3_q ? select_2330 : {select_2330[6:0], 1'b0}) : select_2330;
  // hls/stages/agreement.hpp:992
  logic or_2425;
  assign or_2425 = select_2422[7] | (~({select_2422[5], select_2422[3], select_2422[1]} == 3'h0));
  // hls/stages/agreement.hpp:976
  logic and_2442;
  assign and_2442 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_2443;
  assign and_2443 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_2444;
  assign and_2444 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_2445;
  assign and_2445 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_2447;
  assign sum_2447 = {1'b0, and_2444} + ({1'b0, shown} + {1'b0, and_2445});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2442} + ({2'h0, and_2443} + {1'b0, sum_2447});
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_2450;
  assign select_2450 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2451;
  assign difference_2451 = {1'b0, shown_2} - {1'b0, select_2450};
  logic [4:0] around;
  assign around = {difference_2451[3], difference_2451} + (equal_2103_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_2454;
  assign sum_2454 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:976
  logic and_2458;
  assign and_2458 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2459;
  assign and_2459 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2460;
  assign and_2460 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2461;
  assign and_2461 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_2463;
  assign sum_2463 = {1'b0, and_2460} + ({1'b0, near} + {1'b0, and_2461});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2458} + ({2'h0, and_2459} + {1'b0, sum_2463});
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_2466;
  assign select_2466 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2467;
  assign difference_2467 = {1'b0, near_2} - {1'b0, select_2466};
  logic [4:0] n;
  assign n = {difference_2467[3], difference_2467} + (equal_2103_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2513;
  assign select_2513 = sample_pair_whole_s3_q ? (and_492_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2515;
  assign select_2515 = sample_pair_whole_s3_q ? (and_492_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2534;
  assign select_2534 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2536;
  assign select_2536 = sample_pair_whole_s3_q ? (and_492_s3_q ? select_507 : averager_mask_q) : averager_mask_q;
  logic select_2538;
  assign select_2538 = sample_pair_whole_s3_q ? (and_492_s3_q ? select_511 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2539;
  assign select_2539 = and_494_s3_q ? select_500 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2540;
  assign select_2540 = and_494_s3_q ? select_504 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2542;
  assign select_2542 = and_494_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2543;
  assign select_2543 = and_494_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2544;
  assign select_2544 = and_494_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2545;
  assign select_2545 = and_494_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2546;
  assign select_2546 = and_494_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2547;
  assign select_2547 = and_494_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2548;
  assign select_2548 = and_494_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2549;
  assign select_2549 = and_494_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2550;
  assign select_2550 = and_494_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2551;
  assign select_2551 = and_494_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2552;
  assign select_2552 = and_494_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2553;
  assign select_2553 = and_494_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2554;
  assign select_2554 = and_494_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2555;
  assign select_2555 = and_494_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2556;
  assign select_2556 = and_494_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2557;
  assign select_2557 = and_494_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2558;
  assign select_2558 = and_494_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2559;
  assign select_2559 = and_494_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2560;
  assign select_2560 = and_494_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2561;
  assign select_2561 = and_494_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2562;
  assign select_2562 = and_494_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2563;
  assign select_2563 = and_494_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2564;
  assign select_2564 = and_494_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2565;
  assign select_2565 = and_494_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2566;
  assign select_2566 = and_494_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2567;
  assign select_2567 = and_494_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2568;
  assign select_2568 = and_494_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2569;
  assign select_2569 = and_494_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2570;
  assign select_2570 = and_494_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2571;
  assign select_2571 = and_494_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2572;
  assign select_2572 = and_494_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2573;
  assign select_2573 = and_494_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2574;
  assign select_2574 = and_494_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2575;
  assign select_2575 = and_494_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2576;
  assign select_2576 = and_494_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2577;
  assign select_2577 = and_494_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2578;
  assign select_2578 = and_494_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2579;
  assign select_2579 = and_494_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2580;
  assign select_2580 = and_494_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2581;
  assign select_2581 = and_494_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2582;
  assign select_2582 = and_494_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2583;
  assign select_2583 = and_494_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2584;
  assign select_2584 = and_494_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2585;
  assign select_2585 = and_494_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2586;
  assign select_2586 = and_494_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2587;
  assign select_2587 = and_494_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2588;
  assign select_2588 = and_494_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2589;
  assign select_2589 = and_494_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2590;
  assign select_2590 = and_494_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2591;
  assign select_2591 = and_494_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2592;
  assign select_2592 = and_494_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2593;
  assign select_2593 = and_494_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2594;
  assign select_2594 = and_494_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2596;
  assign difference_2596 = {1'b0, select_504} - {1'b0, census_columns_values_0_cell_0_right_q};
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
  assign difference_2642 = {1'b0, select_500} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2642[9]} + (difference_2642[8:0] ^ {9{difference_2642[9]}});
  logic [9:0] difference_2654;
  assign difference_2654 = {1'b0, select_504} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2654[9]} + (difference_2654[8:0] ^ {9{difference_2654[9]}});
  // hls/stages/agreement.hpp:507
  logic and_2842;
  assign and_2842 = and_494_s3_q & (equal_555_s3_q & equal_2745_s3_q);
  // hls/stages/patches.hpp:321
  logic and_2846;
  assign and_2846 = not_1937_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:976
  logic and_2866;
  assign and_2866 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2867;
  assign and_2867 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2868;
  assign and_2868 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2869;
  assign and_2869 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2871;
  assign sum_2871 = {1'b0, and_2868} + ({1'b0, explained} + {1'b0, and_2869});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2866} + ({2'h0, and_2867} + {1'b0, sum_2871});
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2874;
  assign select_2874 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2875;
  assign difference_2875 = {1'b0, explained_2} - {1'b0, select_2874};
  logic [4:0] e;
  assign e = {difference_2875[3], difference_2875} + (equal_2103_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2878;
  assign sum_2878 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/patches.hpp:321
  logic and_2907;
  assign and_2907 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2951;
  assign select_2951 = equal_1936_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2953;
  assign select_2953 = equal_1936_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2954;
  assign equal_2954 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:250
  logic and_2958;
  assign and_2958 = shift_2_s3_q[3] & less_2076_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2962;
  assign sum_2962 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2964;
  assign difference_2964 = {sum_2962, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2965;
  assign select_2965 = less_2963_s3_q ? difference_2964 : {sum_2962, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2966;
  assign select_2966 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2962, shift_2_s3_q[11], 5'h0} : select_2965;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2966[7]}}, select_2966} - {sum_2093[9], sum_2093, sum_2089[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2969;
  assign select_2969 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2969[11:7])) ? 12'h7f : select_2969;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2990;
  assign difference_2990 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2992;
  assign and_2992 = and_2958 & ($signed(difference_2990) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3005;
  assign less_3005 = $signed(difference_2990) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:321
  logic select_3013;
  assign select_3013 = so_s3_q ? (equal_2954 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_3016;
  assign select_3016 = so_s3_q ? (equal_2077 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3021;
  assign select_3021 = (sum_1987 == 2'h2) ? (registration_fresh_q & (~select_2034)) : registration_fresh_q;
  // hls/stages/patches.hpp:321
  logic [3:0] select_3023;
  assign select_3023 = so_s3_q ? (and_2029 ? select_3021 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3025;
  assign select_3025 = and_2842 ? 4'hf : (equal_1936_s3_q ? registration_fresh_q : select_3023);
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1984;
  // hls/stages/registration.hpp:258
  logic not_3046;
  assign not_3046 = ~quarter_2[1];
  logic [3:0] select_3047;
  assign select_3047 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3046, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3046};
  // hls/stages/patches.hpp:326
  logic not_3184;
  assign not_3184 = ~and_2147_s3_q;
  // hls/stages/patches.hpp:335
  logic not_3210;
  assign not_3210 = ~select_2066[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_3212;
  assign select_3212 = sample_pair_whole_s3_q ? (equal_2067 ? select_2066 : {not_3210, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:499
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:167
  logic [51:0] select_3311;
  assign select_3311 = or_2155_s3_q ? {less_2283_s3_q, less_2282_s3_q, less_2273_s3_q, less_2272_s3_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3313;
  assign select_3313 = equal_2149_s3_q ? patches_codes_at_q : (equal_2151_s3_q ? other[55:4] : select_3311);
  // hls/stages/patches.hpp:482
  logic [27:0] word;
  assign word = or_2255_s3_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:498
  logic [27:0] select_3316;
  assign select_3316 = (patches_along_s3_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:167
  logic [27:0] select_3318;
  assign select_3318 = equal_2151_s3_q ? (new_row_s3_q ? word : select_3316) : patches_codes_further_q;
  // hls/stages/patches.hpp:500
  logic [55:0] select_3320;
  assign select_3320 = less_2242_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:470
  logic [55:0] select_3322;
  assign select_3322 = less_3321_s3_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:167
  logic [55:0] select_3324;
  assign select_3324 = or_2155_s3_q ? (equal_2154_s3_q ? patches_next_codes_q : select_3322) : patches_next_codes_q;
  logic [55:0] select_3326;
  assign select_3326 = equal_2149_s3_q ? patches_next_codes_q : (equal_2151_s3_q ? select_3320 : select_3324);
  // hls/stages/count_bits.hpp:24
  logic parity_3331;
  assign parity_3331 = ^{less_2283_s3_q, less_2282_s3_q, less_2273_s3_q, less_2272_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_3335;
  assign or_3335 = ({less_2273_s3_q, less_2272_s3_q} == 2'h3) | (less_2282_s3_q & (less_2273_s3_q | less_2272_s3_q));
  logic and_3336;
  assign and_3336 = less_2283_s3_q & (^{less_2282_s3_q, less_2273_s3_q, less_2272_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3337;
  assign xor_3337 = or_3335 ^ and_3336;
  // hls/stages/count_bits.hpp:27
  logic and_3338;
  assign and_3338 = or_3335 & and_3336;
  // hls/stages/patches.hpp:167
  logic [2:0] select_3340;
  assign select_3340 = or_2155_s3_q ? (and_2306_s3_q ? {and_3338, xor_3337, parity_3331} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:150
  logic [9:0] sum_3344;
  assign sum_3344 = {7'h0, patches_set_q} + (equal_2154_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:499
  logic [47:0] select_3354;
  assign select_3354 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:167
  logic [47:0] select_3356;
  assign select_3356 = equal_2149_s3_q ? patches_left_row_q : (equal_2151_s3_q ? select_3354 : patches_left_row_q);
  // hls/stages/patches.hpp:501
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3354;
  // hls/stages/count_bits.hpp:24
  logic xor_3360;
  assign xor_3360 = bits[17] ^ (^{select_3354[16:15], other[16:15]});
  logic xor_3363;
  assign xor_3363 = bits[11] ^ (^{select_3354[10:9], other[10:9]});
  logic xor_3366;
  assign xor_3366 = bits[14] ^ (^{select_3354[13:12], other[13:12]});
  logic xor_3369;
  assign xor_3369 = xor_3360 ^ (^{select_3354[14:9], other[14:9]});
  logic xor_3372;
  assign xor_3372 = bits[47] ^ (^{select_3354[46:45], other[46:45]});
  logic xor_3375;
  assign xor_3375 = bits[8] ^ (^{select_3354[7:6], other[7:6]});
  logic xor_3378;
  assign xor_3378 = bits[2] ^ (^{select_3354[1:0], other[1:0]});
  logic xor_3381;
  assign xor_3381 = bits[5] ^ (^{select_3354[4:3], other[4:3]});
  logic xor_3384;
  assign xor_3384 = xor_3375 ^ (^{select_3354[5:0], other[5:0]});
  logic parity_3386;
  assign parity_3386 = ^{select_3354[47:45], select_3354[8:0], other[47:45], other[8:0]};
  logic xor_3387;
  assign xor_3387 = xor_3369 ^ parity_3386;
  logic xor_3390;
  assign xor_3390 = bits[44] ^ (^{select_3354[43:42], other[43:42]});
  logic xor_3393;
  assign xor_3393 = bits[38] ^ (^{select_3354[37:36], other[37:36]});
  logic xor_3396;
  assign xor_3396 = bits[41] ^ (^{select_3354[40:39], other[40:39]});
  logic xor_3402;
  assign xor_3402 = bits[26] ^ (^{select_3354[25:24], other[25:24]});
  logic xor_3405;
  assign xor_3405 = bits[20] ^ (^{select_3354[19:18], other[19:18]});
  logic xor_3408;
  assign xor_3408 = bits[23] ^ (^{select_3354[22:21], other[22:21]});
  logic xor_3411;
  assign xor_3411 = xor_3402 ^ (^{select_3354[23:18], other[23:18]});
  logic xor_3414;
  assign xor_3414 = bits[35] ^ (^{select_3354[34:33], other[34:33]});
  logic xor_3417;
  assign xor_3417 = bits[29] ^ (^{select_3354[28:27], other[28:27]});
  logic xor_3420;
  assign xor_3420 = bits[32] ^ (^{select_3354[31:30], other[31:30]});
  logic xor_3423;
  assign xor_3423 = xor_3414 ^ (^{select_3354[32:27], other[32:27]});
  logic xor_3424;
  assign xor_3424 = xor_3411 ^ xor_3423;
  // hls/stages/count_bits.hpp:25
  logic or_3432;
  assign or_3432 = (xor_3363 & xor_3366) | (xor_3360 & (xor_3363 | xor_3366));
  logic or_3436;
  assign or_3436 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3440;
  assign or_3440 = (xor_3378 & xor_3381) | (xor_3375 & (xor_3378 | xor_3381));
  // hls/stages/count_bits.hpp:23
  logic or_3447;
  assign or_3447 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3451;
  assign or_3451 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3455;
  assign or_3455 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3458;
  assign parity_3458 = ^{or_3455, or_3451, or_3447};
  // hls/stages/count_bits.hpp:23
  logic or_3462;
  assign or_3462 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3466;
  assign or_3466 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3470;
  assign or_3470 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3473;
  assign parity_3473 = ^{or_3470, or_3466, or_3462};
  logic parity_3476;
  assign parity_3476 = ^{or_3470, or_3466, or_3462, or_3455, or_3451, or_3447, or_3440, or_3436, or_3432};
  // hls/stages/count_bits.hpp:23
  logic or_3480;
  assign or_3480 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3484;
  assign or_3484 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3488;
  assign or_3488 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3496;
  assign or_3496 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3500;
  assign or_3500 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3504;
  assign or_3504 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3507;
  assign parity_3507 = ^{or_3504, or_3500, or_3496};
  // hls/stages/count_bits.hpp:23
  logic or_3511;
  assign or_3511 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3515;
  assign or_3515 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3519;
  assign or_3519 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3522;
  assign parity_3522 = ^{or_3519, or_3515, or_3511};
  logic parity_3525;
  assign parity_3525 = ^{or_3519, or_3515, or_3511, or_3504, or_3500, or_3496, or_3488, or_3484, or_3480};
  // hls/stages/count_bits.hpp:25
  logic or_3529;
  assign or_3529 = (xor_3393 & xor_3396) | (xor_3390 & (xor_3393 | xor_3396));
  logic or_3533;
  assign or_3533 = (xor_3405 & xor_3408) | (xor_3402 & (xor_3405 | xor_3408));
  logic or_3537;
  assign or_3537 = (xor_3417 & xor_3420) | (xor_3414 & (xor_3417 | xor_3420));
  // hls/stages/count_bits.hpp:24
  logic parity_3540;
  assign parity_3540 = ^{or_3537, or_3533, or_3529};
  // hls/stages/count_bits.hpp:25
  logic and_3541;
  assign and_3541 = xor_3387 & (^{xor_3424, select_3354[44:36], other[44:36]});
  logic or_3545;
  assign or_3545 = (xor_3372 & xor_3384) | (xor_3369 & (xor_3372 | xor_3384));
  logic and_3548;
  assign and_3548 = (xor_3390 ^ (^{select_3354[41:36], other[41:36]})) & (xor_3411 | xor_3423);
  logic or_3549;
  assign or_3549 = (xor_3411 & xor_3423) | and_3548;
  // hls/stages/count_bits.hpp:24
  logic parity_3552;
  assign parity_3552 = ^{or_3549, or_3545, and_3541};
  logic parity_3555;
  assign parity_3555 = ^{or_3549, or_3545, and_3541, or_3537, or_3533, or_3529, or_3519, or_3515, or_3511, or_3504, or_3500, or_3496, or_3488, or_3484, or_3480};
  logic parity_3557;
  assign parity_3557 = ^{or_3549, or_3545, and_3541, or_3537, or_3533, or_3529, or_3519, or_3515, or_3511, or_3504, or_3500, or_3496, or_3488, or_3484, or_3480, or_3470, or_3466, or_3462, or_3455, or_3451, or_3447, or_3440, or_3436, or_3432};
  // hls/stages/count_bits.hpp:25
  logic and_3558;
  assign and_3558 = parity_3476 & parity_3555;
  logic or_3562;
  assign or_3562 = (parity_3458 & parity_3473) | ((^{or_3440, or_3436, or_3432}) & (parity_3458 | parity_3473));
  logic or_3566;
  assign or_3566 = (parity_3540 & parity_3552) | (parity_3525 & (parity_3540 | parity_3552));
  logic or_3573;
  assign or_3573 = (parity_3507 & parity_3522) | ((^{or_3488, or_3484, or_3480}) & (parity_3507 | parity_3522));
  logic or_3577;
  assign or_3577 = (or_3533 & or_3537) | (or_3529 & (or_3533 | or_3537));
  logic or_3581;
  assign or_3581 = (or_3545 & or_3549) | (and_3541 & (or_3545 | or_3549));
  // hls/stages/count_bits.hpp:23
  logic or_3588;
  assign or_3588 = (or_3484 & or_3488) | (or_3480 & (or_3484 | or_3488));
  // hls/stages/count_bits.hpp:25
  logic or_3592;
  assign or_3592 = (or_3500 & or_3504) | (or_3496 & (or_3500 | or_3504));
  logic or_3596;
  assign or_3596 = (or_3515 & or_3519) | (or_3511 & (or_3515 | or_3519));
  // hls/stages/count_bits.hpp:24
  logic parity_3599;
  assign parity_3599 = ^{or_3596, or_3592, or_3588};
  // hls/stages/count_bits.hpp:23
  logic or_3603;
  assign or_3603 = (or_3436 & or_3440) | (or_3432 & (or_3436 | or_3440));
  // hls/stages/count_bits.hpp:25
  logic or_3607;
  assign or_3607 = (or_3451 & or_3455) | (or_3447 & (or_3451 | or_3455));
  logic or_3611;
  assign or_3611 = (or_3466 & or_3470) | (or_3462 & (or_3466 | or_3470));
  // hls/stages/count_bits.hpp:24
  logic parity_3614;
  assign parity_3614 = ^{or_3611, or_3607, or_3603};
  logic parity_3617;
  assign parity_3617 = ^{or_3611, or_3607, or_3603, or_3596, or_3592, or_3588, or_3581, or_3577, or_3573};
  logic parity_3619;
  assign parity_3619 = ^{or_3611, or_3607, or_3603, or_3596, or_3592, or_3588, or_3581, or_3577, or_3573, or_3566, or_3562, and_3558};
  // hls/stages/count_bits.hpp:25
  logic or_3623;
  assign or_3623 = (or_3577 & or_3581) | (or_3573 & (or_3577 | or_3581));
  logic or_3627;
  assign or_3627 = (or_3592 & or_3596) | (or_3588 & (or_3592 | or_3596));
  logic or_3631;
  assign or_3631 = (or_3607 & or_3611) | (or_3603 & (or_3607 | or_3611));
  // hls/stages/count_bits.hpp:24
  logic parity_3634;
  assign parity_3634 = ^{or_3631, or_3627, or_3623};
  // hls/stages/count_bits.hpp:25
  logic and_3635;
  assign and_3635 = (^{or_3566, or_3562, and_3558}) & parity_3617;
  logic or_3639;
  assign or_3639 = (or_3562 & or_3566) | (and_3558 & (or_3562 | or_3566));
  logic or_3643;
  assign or_3643 = (parity_3599 & parity_3614) | ((^{or_3581, or_3577, or_3573}) & (parity_3599 | parity_3614));
  // hls/stages/count_bits.hpp:24
  logic parity_3646;
  assign parity_3646 = ^{or_3643, or_3639, and_3635};
  // hls/stages/count_bits.hpp:25
  logic and_3648;
  assign and_3648 = parity_3634 & parity_3646;
  logic or_3652;
  assign or_3652 = (or_3627 & or_3631) | (or_3623 & (or_3627 | or_3631));
  logic or_3656;
  assign or_3656 = (or_3639 & or_3643) | (and_3635 & (or_3639 | or_3643));
  // hls/stages/patches.hpp:167
  logic [4:0] select_3701;
  assign select_3701 = equal_2151_s3_q ? patches_along_s3_q : patches_summed_row_column_q;
  logic select_3704;
  assign select_3704 = equal_2149_s3_q ? patches_summed_first_q : (equal_2151_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:533
  logic [9:0] select_3711;
  assign select_3711 = less_2312_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3714;
  assign select_3714 = equal_2315_s3_q ? (less_2312_s3_q ? (equal_2315_s3_q ? 10'h0 : select_3711) : 10'h0) : select_3711;
  logic [9:0] select_3716;
  assign select_3716 = less_2312_s3_q ? (equal_2313_s3_q ? 10'h0 : select_3714) : select_3714;
  // hls/stages/patches.hpp:533
  logic [4:0] select_3718;
  assign select_3718 = less_2312_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:537
  logic [4:0] select_3721;
  assign select_3721 = equal_2315_s3_q ? (less_2312_s3_q ? (equal_2315_s3_q ? 5'h0 : select_3718) : 5'h0) : select_3718;
  logic [4:0] select_3723;
  assign select_3723 = less_2312_s3_q ? (equal_2313_s3_q ? 5'h0 : select_3721) : select_3721;
  // hls/stages/patches.hpp:533
  logic [4:0] select_3725;
  assign select_3725 = less_2312_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:537
  logic [4:0] select_3728;
  assign select_3728 = equal_2315_s3_q ? (less_2312_s3_q ? (equal_2315_s3_q ? 5'h0 : select_3725) : 5'h0) : select_3725;
  logic [4:0] select_3730;
  assign select_3730 = less_2312_s3_q ? (equal_2313_s3_q ? 5'h0 : select_3728) : select_3728;
  // hls/stages/patches.hpp:533
  logic and_3733;
  assign and_3733 = less_2312_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:537
  logic select_3736;
  assign select_3736 = equal_2315_s3_q ? (less_2312_s3_q ? (not_2316_s3_q & and_3733) : and_3733) : and_3733;
  // hls/stages/patches.hpp:167
  logic select_3739;
  assign select_3739 = equal_2149_s3_q ? (less_2312_s3_q ? (not_2314_s3_q & select_3736) : select_3736) : patches_read_first_q;
  // hls/stages/patches.hpp:161
  logic or_3750;
  assign or_3750 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3751;
  assign and_3751 = patches_read_searches_s3_q & or_3750;
  // hls/stages/patches.hpp:517
  logic [4:0] select_3752;
  assign select_3752 = and_3751 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:524
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3752};
  // hls/stages/patches.hpp:533
  logic and_3756;
  assign and_3756 = less_2312_s3_q & (equal_3748_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:537
  logic select_3759;
  assign select_3759 = equal_2315_s3_q ? (less_2312_s3_q ? (not_2316_s3_q & and_3756) : and_3756) : and_3756;
  // hls/stages/patches.hpp:167
  logic select_3762;
  assign select_3762 = equal_2149_s3_q ? (less_2312_s3_q ? (not_2314_s3_q & select_3759) : select_3759) : patches_read_above_q;
  // hls/stages/patches.hpp:533
  logic and_3765;
  assign and_3765 = less_2312_s3_q & (equal_3748_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:537
  logic select_3768;
  assign select_3768 = equal_2315_s3_q ? (less_2312_s3_q ? (not_2316_s3_q & and_3765) : and_3765) : and_3765;
  // hls/stages/patches.hpp:167
  logic select_3771;
  assign select_3771 = equal_2149_s3_q ? (less_2312_s3_q ? (not_2314_s3_q & select_3768) : select_3768) : patches_read_below_q;
  // hls/stages/patches.hpp:530
  logic [6:0] sum_3772;
  assign sum_3772 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:531
  logic [9:0] select_3775;
  assign select_3775 = (equal_3748_s3_q & ({sum_3772[6], sum_3772} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:533
  logic [9:0] select_3776;
  assign select_3776 = less_2312_s3_q ? select_3775 : 10'h3ff;
  // hls/stages/patches.hpp:534
  logic [9:0] select_3778;
  assign select_3778 = less_2312_s3_q ? (equal_2315_s3_q ? 10'h3ff : select_3776) : 10'h3ff;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3779;
  assign select_3779 = equal_2315_s3_q ? select_3778 : select_3776;
  logic [9:0] select_3781;
  assign select_3781 = less_2312_s3_q ? (equal_2313_s3_q ? 10'h3ff : select_3779) : select_3779;
  // hls/stages/patches.hpp:516
  logic [14:0] select_3783;
  assign select_3783 = and_3751 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:167
  logic [9:0] select_3784;
  assign select_3784 = equal_2149_s3_q ? select_3783[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3785;
  assign select_3785 = equal_2149_s3_q ? select_3783[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:518
  logic [9:0] select_3787;
  assign select_3787 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:519
  logic [9:0] select_3789;
  assign select_3789 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:520
  logic [9:0] select_3792;
  assign select_3792 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3793;
  assign select_3793 = patches_read_first_q ? patches_read_far_q : select_3792;
  // hls/stages/patches.hpp:571
  logic [9:0] difference_3796;
  assign difference_3796 = select_3793 - select_3783[9:0];
  // hls/stages/patches.hpp:556
  logic less_3826;
  assign less_3826 = select_3787 < select_3789;
  // hls/stages/patches.hpp:562
  logic [1:0] sum_3827;
  assign sum_3827 = select_3752[4:3] + 2'h3;
  // hls/stages/patches.hpp:557
  logic [9:0] high;
  assign high = less_3826 ? select_3789 : select_3787;
  logic [9:0] low;
  assign low = (select_3789 < select_3787) ? select_3789 : select_3787;
  // hls/stages/patches.hpp:558
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3783[9:0];
  // hls/stages/patches.hpp:560
  logic not_3834;
  assign not_3834 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3835;
  assign sum_3835 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3837;
  assign not_3837 = ~({eight, 3'h0} < {1'b0, sum_3835, fall[0]});
  logic [1:0] sum_3838;
  assign sum_3838 = {1'b0, not_3834} + {1'b0, not_3837};
  // hls/stages/patches.hpp:561
  logic [10:0] sum_3839;
  assign sum_3839 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3841;
  assign not_3841 = ~({eight, 3'h0} < {sum_3839, fall[1:0]});
  logic not_3844;
  assign not_3844 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3845;
  assign sum_3845 = {1'b0, not_3841} + {1'b0, not_3844};
  // hls/stages/patches.hpp:560
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3838} + {1'b0, sum_3845};
  // hls/stages/patches.hpp:563
  logic [7:0] select_3848;
  assign select_3848 = less_3826 ? ({sum_3827, select_3752[2:0], 3'h0} - {5'h0, fraction}) : {sum_3827, select_3752[2:0], fraction};
  // hls/stages/agreement.hpp:1086
  logic equal_4007;
  assign equal_4007 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/patches.hpp:321
  logic select_4028;
  assign select_4028 = equal_1936_s3_q ? shown_shown_q : (so_s3_q ? select_2370 : shown_shown_q);
  logic select_4030;
  assign select_4030 = equal_1936_s3_q ? shown_nearer_q : (so_s3_q ? select_2373 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4032;
  assign sum_4032 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_4034;
  assign select_4034 = less_4031_s3_q ? (sum_4032[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4036;
  assign select_4036 = equal_2745_s3_q ? (equal_555_s3_q ? 3'h0 : select_4034) : region_row_q;
  // hls/stages/patches.hpp:321
  logic [7:0] select_4041;
  assign select_4041 = equal_1936_s3_q ? select_2330 : (so_s3_q ? (ends_cell_s3_q ? select_2422 : select_2330) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_4055;
  assign select_4055 = equal_555_s3_q ? {{2{difference_4053[6]}}, difference_4053} : (less_4031_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_4057;
  assign select_4057 = and_494_s3_q ? (equal_2745_s3_q ? select_4055 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [6:0] select_4059;
  assign select_4059 = equal_555_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_4061;
  assign select_4061 = and_494_s3_q ? (equal_2745_s3_q ? select_4059 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4062;
  assign sum_4062 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4063;
  assign select_4063 = sum_4032[7] ? {1'b1, sum_4032[6:0], region_down_rest_q[0]} : sum_4062;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4032[7];
  // hls/stages/agreement.hpp:447
  logic select_4067;
  assign select_4067 = equal_2745_s3_q ? (equal_555_s3_q | (less_4031_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_4072;
  assign or_4072 = segment_starts_q | not_1976;
  // hls/stages/agreement.hpp:976
  logic select_4075;
  assign select_4075 = shift_2_s3_q[0] ? (sum_2343_s3_q ? (equal_2142_s3_q & or_2345) : or_2345) : or_4072;
  // hls/stages/patches.hpp:321
  logic select_4078;
  assign select_4078 = equal_1936_s3_q ? or_4072 : (so_s3_q ? (ends_cell_s3_q ? select_4075 : or_4072) : or_4072);
  logic [2:0] select_4152;
  assign select_4152 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_4154;
  assign select_4154 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4156;
  assign select_4156 = equal_1936_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4154 : box_textured_columns_values_1_q);
  logic [2:0] select_4157;
  assign select_4157 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4159;
  assign select_4159 = equal_1936_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4157 : box_textured_columns_values_2_q);
  logic [2:0] select_4160;
  assign select_4160 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4162;
  assign select_4162 = equal_1936_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4160 : box_textured_columns_values_3_q);
  logic [2:0] select_4163;
  assign select_4163 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4165;
  assign select_4165 = equal_1936_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4163 : box_textured_columns_values_4_q);
  logic [4:0] select_4167;
  assign select_4167 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4170;
  assign select_4170 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4172;
  assign select_4172 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4174;
  assign select_4174 = equal_1936_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4172 : box_explained_columns_values_1_q);
  logic [2:0] select_4175;
  assign select_4175 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4177;
  assign select_4177 = equal_1936_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4175 : box_explained_columns_values_2_q);
  logic [2:0] select_4178;
  assign select_4178 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4180;
  assign select_4180 = equal_1936_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4178 : box_explained_columns_values_3_q);
  logic [2:0] select_4181;
  assign select_4181 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4183;
  assign select_4183 = equal_1936_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4181 : box_explained_columns_values_4_q);
  logic [4:0] select_4185;
  assign select_4185 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4186;
  assign select_4186 = equal_1936_s3_q ? box_explained_sum_sums_values_0_q : select_4185;
  logic [2:0] select_4188;
  assign select_4188 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4190;
  assign select_4190 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4192;
  assign select_4192 = equal_1936_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4190 : box_shown_columns_values_1_q);
  logic [2:0] select_4193;
  assign select_4193 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4195;
  assign select_4195 = equal_1936_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4193 : box_shown_columns_values_2_q);
  logic [2:0] select_4196;
  assign select_4196 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4198;
  assign select_4198 = equal_1936_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4196 : box_shown_columns_values_3_q);
  logic [2:0] select_4199;
  assign select_4199 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4201;
  assign select_4201 = equal_1936_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4199 : box_shown_columns_values_4_q);
  logic [4:0] select_4203;
  assign select_4203 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4206;
  assign select_4206 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4208;
  assign select_4208 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4210;
  assign select_4210 = equal_1936_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4208 : box_nearer_columns_values_1_q);
  logic [2:0] select_4211;
  assign select_4211 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4213;
  assign select_4213 = equal_1936_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4211 : box_nearer_columns_values_2_q);
  logic [2:0] select_4214;
  assign select_4214 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4216;
  assign select_4216 = equal_1936_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4214 : box_nearer_columns_values_3_q);
  logic [2:0] select_4217;
  assign select_4217 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4219;
  assign select_4219 = equal_1936_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4217 : box_nearer_columns_values_4_q);
  logic [4:0] select_4221;
  assign select_4221 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_4224;
  assign select_4224 = so_s3_q ? (ends_cell_s3_q ? and_2410 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4227;
  assign select_4227 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_4229;
  assign select_4229 = equal_1936_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_4227 : centres_values_0_of_skin_q);
  logic select_4230;
  assign select_4230 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4232;
  assign select_4232 = equal_1936_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_4230 : centres_values_1_textured_q);
  logic select_4233;
  assign select_4233 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4235;
  assign select_4235 = equal_1936_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_4233 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:447
  logic [12:0] select_4239;
  assign select_4239 = equal_2745_s3_q ? (equal_4236_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_4242;
  assign select_4242 = and_494_s3_q ? (equal_2745_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1227
  logic [2:0] select_4253;
  assign select_4253 = select_2382 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_4259;
  assign select_4259 = marks_first_s3_q ? (less_4255 ? {sum_4256, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1235
  logic and_4265;
  assign and_4265 = and_2481_s3_q & ({sum_2407, index_2[5:0]} == {sum_2394, index[5:0]});
  // hls/stages/registration.hpp:258
  logic not_4323;
  assign not_4323 = ~quarter[1];
  logic [3:0] select_4324;
  assign select_4324 = quarter[0] ? {quarter[1], 1'b0, not_4323, 1'b0} : {1'b0, quarter[1], 1'b0, not_4323};

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

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:728; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
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

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1319; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
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

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1330; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
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
  assign averager_memory_waddr = select_464_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_469_s3_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_488, and_484, sum_480, sum_476};
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
  assign census_memory_we = s3_en & and_494_s3_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_512, whole_2, select_504, select_500};
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
      census_filled_q <= and_494_s3_q ? {select_558[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_494_s3_q ? select_557 : rows_passed_above_q;
      registration_slope_here_q <= select_2951;
      registration_expected_q <= select_2953;
      registration_of_right_q <= equal_1936_s3_q ? registration_of_right_q : select_3013;
      registration_was_inside_q <= equal_1936_s3_q ? registration_was_inside_q : select_3016;
      registration_fresh_q <= select_3025;
      patches_fixed_q <= not_3184 & (patches_fixed_q | (and_3194_s3_q & and_2122));
      patches_choice_valid_q <= and_2147_s3_q ? (select_2141[0] & not_3184) : select_2141[0];
      patches_choice_column_q <= select_2141[8:1];
      patches_choice_shift_q <= select_2141[14:9];
      patches_choice_slope_q <= select_2141[22:15];
      patches_band_q <= sample_pair_whole_s3_q ? select_2162 : patches_band_q;
      patches_fetch_q <= select_3212;
      patches_codes_at_q <= select_3313;
      patches_codes_further_q <= equal_2149_s3_q ? patches_codes_further_q : select_3318;
      patches_next_codes_q <= select_3326;
      patches_set_q <= equal_2149_s3_q ? 3'h0 : (equal_2151_s3_q ? 3'h0 : select_3340);
      patches_size_q <= sum_3344;
      patches_left_row_q <= select_3356;
      patches_summed_row_column_q <= equal_2149_s3_q ? patches_summed_row_column_q : select_3701;
      patches_summed_first_q <= select_3704;
      patches_read_row_differing_q <= equal_2149_s3_q ? select_3716 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2149_s3_q ? select_3723 : patches_read_row_column_q;
      patches_read_at_q <= equal_2149_s3_q ? select_3730 : patches_read_at_q;
      patches_read_first_q <= select_3739;
      patches_read_above_q <= select_3762;
      patches_read_below_q <= select_3771;
      patches_read_far_q <= equal_2149_s3_q ? select_3781 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3784;
      patches_peak_best_column_q <= select_3785;
      patches_peak_row_q <= equal_2149_s3_q ? select_3752 : patches_peak_row_q;
      patches_peak_above_q <= equal_2149_s3_q ? select_3787 : patches_peak_above_q;
      patches_peak_below_q <= equal_2149_s3_q ? select_3789 : patches_peak_below_q;
      patches_peak_far_q <= equal_2149_s3_q ? select_3793 : patches_peak_far_q;
      shown_shown_q <= select_4028;
      shown_nearer_q <= select_4030;
      region_row_q <= and_494_s3_q ? select_4036 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4041;
      region_down_rest_q <= select_4057;
      region_down_back_q <= select_4061;
      region_down_next_q <= select_4063;
      region_fresh_q <= and_494_s3_q ? select_4067 : region_fresh_q;
      segment_starts_q <= select_4078;
      centres_values_0_textured_q <= equal_1936_s3_q ? centres_values_0_textured_q : select_4224;
      centres_values_0_of_skin_q <= select_4229;
      centres_values_1_textured_q <= select_4232;
      centres_values_1_of_skin_q <= select_4235;
      map_row_q <= and_494_s3_q ? select_4239 : map_row_q;
      map_width_q <= select_4242;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2393;
      done_q <= not_2395 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      drew_q <= so_s3_q;
      said_q <= equal_1936_s3_q & equal_4007;
      rows_passed_q <= select_2378;
      columns_passed_q <= {select_2380[7:0], or_2376};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_2397;
      seen_x_q <= select_2399;
      seen_y_q <= marks_first_s3_q ? 3'h0 : select_4253;
      seen_column_q <= select_2390;
      seen_rows_left_q <= select_4259;
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
      averager_running_0_q <= sample_pair_whole_s3_q ? select_472 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_478 : averager_running_1_q;
      averager_total_0_q <= select_2513;
      averager_total_1_q <= select_2515;
      census_columns_values_0_cell_0_left_q <= select_2539;
      census_columns_values_0_cell_0_right_q <= select_2540;
      census_columns_values_0_cell_0_mask_q <= and_494_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
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
      sharpness_last_mean_0_q <= and_494_s3_q ? select_500 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_494_s3_q ? select_504 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1936_s3_q ? box_textured_columns_values_0_q : select_4152;
      box_textured_columns_values_1_q <= select_4156;
      box_textured_columns_values_2_q <= select_4159;
      box_textured_columns_values_3_q <= select_4162;
      box_textured_columns_values_4_q <= select_4165;
      box_textured_sum_sums_values_0_q <= equal_1936_s3_q ? box_textured_sum_sums_values_0_q : select_4167;
      box_explained_columns_values_0_q <= equal_1936_s3_q ? box_explained_columns_values_0_q : select_4170;
      box_explained_columns_values_1_q <= select_4174;
      box_explained_columns_values_2_q <= select_4177;
      box_explained_columns_values_3_q <= select_4180;
      box_explained_columns_values_4_q <= select_4183;
      box_explained_sum_sums_values_0_q <= select_4186;
      box_shown_columns_values_0_q <= equal_1936_s3_q ? box_shown_columns_values_0_q : select_4188;
      box_shown_columns_values_1_q <= select_4192;
      box_shown_columns_values_2_q <= select_4195;
      box_shown_columns_values_3_q <= select_4198;
      box_shown_columns_values_4_q <= select_4201;
      box_shown_sum_sums_values_0_q <= equal_1936_s3_q ? box_shown_sum_sums_values_0_q : select_4203;
      box_nearer_columns_values_0_q <= equal_1936_s3_q ? box_nearer_columns_values_0_q : select_4206;
      box_nearer_columns_values_1_q <= select_4210;
      box_nearer_columns_values_2_q <= select_4213;
      box_nearer_columns_values_3_q <= select_4216;
      box_nearer_columns_values_4_q <= select_4219;
      box_nearer_sum_sums_values_0_q <= equal_1936_s3_q ? box_nearer_sum_sums_values_0_q : select_4221;
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
  logic [2:0] select_458_s4_q;
  logic [6:0] select_460_s4_q;
  logic [6:0] column_s4_q;
  logic and_492_s4_q;
  logic and_494_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_497_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
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
  logic less_546_s4_q;
  logic less_547_s4_q;
  logic less_548_s4_q;
  logic less_549_s4_q;
  logic less_550_s4_q;
  logic less_551_s4_q;
  logic and_559_s4_q;
  logic and_584_s4_q;
  logic and_585_s4_q;
  logic [11:0] sum_600_s4_q;
  logic [9:0] sum_603_s4_q;
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
  logic and_2842_s4_q;
  logic and_2846_s4_q;
  logic not_2880_s4_q;
  logic and_2908_s4_q;
  logic and_2957_s4_q;
  logic and_2958_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2992_s4_q;
  logic and_3006_s4_q;
  logic equal_3049_s4_q;
  logic parity_3428_s4_q;
  logic parity_3557_s4_q;
  logic parity_3619_s4_q;
  logic xor_3647_s4_q;
  logic parity_3659_s4_q;
  logic or_3663_s4_q;
  logic equal_3664_s4_q;
  logic [4:0] select_3783_s4_q;
  logic equal_3795_s4_q;
  logic less_3797_s4_q;
  logic less_3798_s4_q;
  logic or_3803_s4_q;
  logic [7:0] select_3848_s4_q;
  logic equal_4007_s4_q;
  logic and_4265_s4_q;
  logic not_4281_s4_q;
  logic equal_4326_s4_q;
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
      select_458_s4_q <= select_458_s3_q;
      select_460_s4_q <= select_460_s3_q;
      column_s4_q <= column_s3_q;
      and_492_s4_q <= and_492_s3_q;
      and_494_s4_q <= and_494_s3_q;
      grey_s4_q <= grey;
      equal_497_s4_q <= equal_497;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
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
      less_546_s4_q <= less_546;
      less_547_s4_q <= less_547;
      less_548_s4_q <= less_548;
      less_549_s4_q <= less_549;
      less_550_s4_q <= less_550;
      less_551_s4_q <= less_551;
      and_559_s4_q <= and_559;
      and_584_s4_q <= whole_22 & and_559;
      and_585_s4_q <= census_columns_values_1_cell_2_mask_q & and_559;
      sum_600_s4_q <= {1'b0, sum_596} + {2'h0, sum_599};
      sum_603_s4_q <= {9'h0, difference_601[9]} + {1'b0, xor_602};
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
      and_2842_s4_q <= and_2842;
      and_2846_s4_q <= and_2846;
      not_2880_s4_q <= ~({sum_2878, e[0]} < {2'h0, t});
      and_2908_s4_q <= not_1937_s3_q & and_2907;
      and_2957_s4_q <= not_1937_s3_q & (so_s3_q & (half_ends & equal_2954));
      and_2958_s4_q <= and_2958;
      residual_s4_q <= residual[7:0];
      and_2992_s4_q <= and_2992;
      and_3006_s4_q <= and_2958 & less_3005;
      equal_3049_s4_q <= (registration_fresh_q & select_3047) == 4'h0;
      parity_3428_s4_q <= ^{xor_3424, xor_3387, select_3354[44:36], other[44:36]};
      parity_3557_s4_q <= parity_3557;
      parity_3619_s4_q <= parity_3619;
      xor_3647_s4_q <= parity_3634 ^ parity_3646;
      parity_3659_s4_q <= ^{or_3656, or_3652, and_3648};
      or_3663_s4_q <= (or_3652 & or_3656) | (and_3648 & (or_3652 | or_3656));
      equal_3664_s4_q <= equal_3664_s3_q;
      select_3783_s4_q <= select_3783[14:10];
      equal_3795_s4_q <= select_3752[3:0] == 4'h0;
      less_3797_s4_q <= {difference_3796, 3'h0} < {3'h0, sum_3344};
      less_3798_s4_q <= select_3793 < select_3783[9:0];
      or_3803_s4_q <= (sum_3344 < 10'h39) | ({1'b0, sum_3344[9:1]} < select_3783[9:0]);
      select_3848_s4_q <= select_3848;
      equal_4007_s4_q <= equal_4007;
      and_4265_s4_q <= and_4265;
      not_4281_s4_q <= ~proven_q;
      equal_4326_s4_q <= (registration_fresh_q & select_4324) == 4'h0;
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
  logic patches_complete_q;
  logic patches_round_ends_q;
  logic [2:0] patches_found_q;
  logic [7:0] patches_round_places_q;
  logic [11:0] patches_round_across_q;
  logic [2:0] patches_round_moved_q;
  logic patches_suspected_q;
  logic patches_moved_q;
  logic patches_settled_q;
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
  assign texture = sum_600_s4_q + {2'h0, sum_603_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_605;
  assign sum_605 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_607;
  assign sum_607 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_605});
  // hls/stages/census.hpp:303
  logic less_608;
  assign less_608 = 9'h4 < sum_607[13:5];
  logic and_609;
  assign and_609 = and_559_s4_q & less_608;
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
  // hls/stages/patches.hpp:334
  logic [22:0] select_2165;
  assign select_2165 = and_2164_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2141_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:110
  logic select_2167;
  assign select_2167 = equal_2067_s4_q ? patches_place_0_valid_q : (select_2066_s4_q ? patches_place_0_valid_q : select_2165[0]);
  // hls/stages/patches.hpp:335
  logic [21:0] select_2168;
  assign select_2168 = select_2066_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2165[22:1];
  // hls/stages/patches.hpp:110
  logic [7:0] select_2169;
  assign select_2169 = equal_2067_s4_q ? patches_place_0_column_q : select_2168[7:0];
  logic [5:0] select_2170;
  assign select_2170 = equal_2067_s4_q ? patches_place_0_shift_q : select_2168[13:8];
  // hls/stages/patches.hpp:305
  logic [7:0] sum_2171;
  assign sum_2171 = select_2169 + {{2{select_2170[5]}}, select_2170};
  // hls/stages/patches.hpp:306
  logic [6:0] sum_2172;
  assign sum_2172 = sum_2171[7:1] + 7'h7f;
  // hls/stages/patches.hpp:114
  logic equal_2173;
  assign equal_2173 = {sum_2172[6], select_460_s4_q, select_458_s4_q} == {1'b0, sum_2172[5:0], sum_2171[0], 3'h4};
  // hls/stages/patches.hpp:116
  logic or_2175;
  assign or_2175 = and_2049_s4_q | (select_2167 & equal_2173);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2176;
  assign select_2176 = or_2175 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:116
  logic [5:0] select_2186;
  assign select_2186 = or_2175 ? {and_2049_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:120
  logic and_2188;
  assign and_2188 = select_2185_s4_q & (~select_2186[5]);
  // hls/stages/patches.hpp:110
  logic select_2196;
  assign select_2196 = equal_2067_s4_q ? patches_place_1_valid_q : (select_2066_s4_q ? select_2165[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:335
  logic [21:0] select_2197;
  assign select_2197 = select_2066_s4_q ? select_2165[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:110
  logic [7:0] select_2198;
  assign select_2198 = equal_2067_s4_q ? patches_place_1_column_q : select_2197[7:0];
  logic [5:0] select_2199;
  assign select_2199 = equal_2067_s4_q ? patches_place_1_shift_q : select_2197[13:8];
  // hls/stages/patches.hpp:305
  logic [7:0] sum_2200;
  assign sum_2200 = select_2198 + {{2{select_2199[5]}}, select_2199};
  // hls/stages/patches.hpp:306
  logic [6:0] sum_2201;
  assign sum_2201 = sum_2200[7:1] + 7'h7f;
  // hls/stages/patches.hpp:114
  logic equal_2202;
  assign equal_2202 = {sum_2201[6], select_460_s4_q, select_458_s4_q} == {1'b0, sum_2201[5:0], sum_2200[0], 3'h4};
  // hls/stages/patches.hpp:116
  logic or_2204;
  assign or_2204 = and_2049_s4_q | (select_2196 & equal_2202);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2205;
  assign select_2205 = or_2204 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:116
  logic [5:0] select_2206;
  assign select_2206 = or_2204 ? {and_2049_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:120
  logic and_2208;
  assign and_2208 = select_2185_s4_q & (~select_2206[5]);
  // hls/stages/patches.hpp:301
  logic [7:0] sum_2215;
  assign sum_2215 = select_2169 + 8'hff;
  // hls/stages/patches.hpp:115
  logic equal_2216;
  assign equal_2216 = {sum_2215[7], select_460_s4_q, select_458_s4_q} == {1'b0, sum_2215[6:0], 3'h4};
  // hls/stages/patches.hpp:117
  logic or_2218;
  assign or_2218 = and_2049_s4_q | (select_2167 & equal_2216);
  logic [4:0] select_2219;
  assign select_2219 = or_2218 ? {and_2049_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:301
  logic [7:0] sum_2220;
  assign sum_2220 = select_2198 + 8'hff;
  // hls/stages/patches.hpp:115
  logic equal_2221;
  assign equal_2221 = {sum_2220[7], select_460_s4_q, select_458_s4_q} == {1'b0, sum_2220[6:0], 3'h4};
  // hls/stages/patches.hpp:117
  logic [4:0] select_2224;
  assign select_2224 = (and_2049_s4_q | (select_2196 & equal_2221)) ? {and_2049_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:125
  logic [3:0] column_7;
  assign column_7 = select_2219[4] ? select_2224[3:0] : select_2219[3:0];
  // hls/stages/agreement.hpp:263
  logic select_2227;
  assign select_2227 = or_2218 ? and_2049_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:125
  logic and_2233;
  assign and_2233 = (select_2185_s4_q & (select_2179_s4_q[3] ^ select_2179_s4_q[4])) & ((~select_2219[4]) | (~select_2224[4]));
  // hls/stages/patches.hpp:167
  logic less_2324;
  assign less_2324 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:168
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
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2352;
  assign select_2352 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_2353;
  assign sum_2353 = {6'h0, textured_s4_q} + select_2352;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_2355;
  assign sum_2355 = {3'h0, sum_2353} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2357;
  assign select_2357 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_2358;
  assign sum_2358 = {6'h0, explained_s4_q} + select_2357;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_2360;
  assign sum_2360 = {3'h0, sum_2358} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2363;
  assign select_2363 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:868
  logic [6:0] sum_2364;
  assign sum_2364 = {6'h0, and_2362_s4_q} + select_2363;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_2366;
  assign sum_2366 = {3'h0, sum_2364} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1043
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
  // hls/stages/agreement.hpp:976
  logic and_2441;
  assign and_2441 = good_known_q & (~((good_q & select_2437) == 48'h0));
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_2420_s4_q ? and_2441 : not_2456_s4_q;
  // hls/stages/agreement.hpp:1054
  logic and_2471;
  assign and_2471 = is_seen & less_2470_s4_q;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2505;
  assign select_2505 = sample_pair_whole_s4_q ? (and_492_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2507;
  assign select_2507 = sample_pair_whole_s4_q ? (and_492_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2509;
  assign select_2509 = sample_pair_whole_s4_q ? (and_492_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2511;
  assign select_2511 = sample_pair_whole_s4_q ? (and_492_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
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
  assign detail = {3'h0, size} + (equal_497_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2523;
  assign select_2523 = sample_pair_whole_s4_q ? (and_492_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
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
  assign detail_2 = {3'h0, size_2} + (equal_497_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2531;
  assign select_2531 = sample_pair_whole_s4_q ? (and_492_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2614;
  assign sum_2614 = sum_2610_s4_q + {2'h0, sum_2613_s4_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2616;
  assign select_2616 = and_494_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2617;
  assign select_2617 = and_494_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2618;
  assign select_2618 = and_494_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2619;
  assign select_2619 = and_494_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2622;
  assign sum_2622 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2614};
  logic [13:0] sum_2624;
  assign sum_2624 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2622});
  // hls/stages/census.hpp:305
  logic and_2626;
  assign and_2626 = and_584_s4_q & (9'h4 < sum_2624[13:5]);
  // hls/stages/census.hpp:306
  logic and_2627;
  assign and_2627 = and_584_s4_q & less_608;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2628;
  assign sum_2628 = census_left_misses_q + {{17{and_2627}}, and_2626, 1'b0, and_2626};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2630;
  assign select_2630 = and_494_s4_q ? (equal_2621_s4_q ? 20'h0 : sum_2628) : census_left_misses_q;
  // hls/stages/agreement.hpp:263
  logic [27:0] select_2635;
  assign select_2635 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:507
  logic select_2638;
  assign select_2638 = and_494_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2641;
  assign and_2641 = whole_2_s4_q & (~(column_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:444
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
  // hls/stages/agreement.hpp:444
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
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2848;
  assign select_2848 = and_2842_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2846_s4_q});
  // hls/stages/patches.hpp:321
  logic and_2851;
  assign and_2851 = not_1937_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2856;
  assign and_2856 = not_1937_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2861;
  assign and_2861 = not_1937_s4_q & (drew_q & (ends_cell_s4_q & and_2362_s4_q));
  // hls/stages/agreement.hpp:1047
  logic not_2865;
  assign not_2865 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1048
  logic not_2882;
  assign not_2882 = ~(equal_2420_s4_q ? and_2441 : not_2880_s4_q);
  // hls/stages/patches.hpp:321
  logic and_2885;
  assign and_2885 = ends_cell_s4_q & (not_2865 & (centres_values_1_textured_s4_q & not_2882));
  logic and_2887;
  assign and_2887 = not_1937_s4_q & (drew_q & and_2885);
  // hls/stages/agreement.hpp:1074
  logic less_2890;
  assign less_2890 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2891;
  assign select_2891 = less_2890 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2894;
  assign select_2894 = less_2890 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2895;
  assign sum_2895 = {1'b0, select_2894} + {3'h0, select_2894[9:2]};
  logic and_2897;
  assign and_2897 = (~(select_2891[9:4] == 6'h0)) & ({sum_2895, select_2894[1:0]} < {3'h0, select_2891});
  // hls/stages/agreement.hpp:1084
  logic [9:0] select_2900;
  assign select_2900 = x_s4_q[6] ? (equal_1981_s4_q ? 10'h0 : (and_2897 ? select_2891 : 10'h0)) : 10'h0;
  // hls/stages/patches.hpp:321
  logic [9:0] select_2901;
  assign select_2901 = equal_1936_s4_q ? select_2900 : 10'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2903;
  assign select_2903 = and_2842_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2901});
  logic [13:0] select_2910;
  assign select_2910 = and_2842_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2908_s4_q});
  // hls/stages/agreement.hpp:1052
  logic and_2912;
  assign and_2912 = not_2865 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/patches.hpp:321
  logic and_2915;
  assign and_2915 = not_1937_s4_q & (drew_q & (ends_cell_s4_q & and_2912));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2917;
  assign select_2917 = and_2842_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2915});
  // hls/stages/agreement.hpp:1052
  logic and_2919;
  assign and_2919 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2882);
  // hls/stages/patches.hpp:321
  logic and_2923;
  assign and_2923 = not_1937_s4_q & (drew_q & (ends_cell_s4_q & (not_2865 & and_2919)));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2925;
  assign select_2925 = and_2842_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2923});
  // hls/stages/patches.hpp:321
  logic [7:0] select_2974;
  assign select_2974 = drew_q ? (equal_2077_s4_q ? (and_2958_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2975;
  assign select_2975 = equal_1936_s4_q ? 8'h0 : select_2974;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2977;
  assign select_2977 = and_2957_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2975[7]}}, select_2975});
  // hls/stages/patches.hpp:321
  logic and_2980;
  assign and_2980 = not_1937_s4_q & (drew_q & (and_2958_s4_q & equal_2077_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2982;
  assign select_2982 = and_2957_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2980});
  // hls/stages/registration.hpp:107
  logic and_2984;
  assign and_2984 = and_2958_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/patches.hpp:321
  logic [1:0] select_2986;
  assign select_2986 = drew_q ? (equal_2077_s4_q ? {and_2984, and_2958_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2987;
  assign select_2987 = equal_1936_s4_q ? 2'h0 : select_2986;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2988;
  assign sum_2988 = registration_half_votes_down_q + {{5{select_2987[1]}}, select_2987};
  // hls/stages/patches.hpp:321
  logic [1:0] select_2994;
  assign select_2994 = drew_q ? (equal_2077_s4_q ? {and_2992_s4_q, and_2958_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2995;
  assign select_2995 = equal_1936_s4_q ? 2'h0 : select_2994;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2996;
  assign sum_2996 = registration_half_votes_up_q + {{5{select_2995[1]}}, select_2995};
  // hls/stages/registration.hpp:107
  logic and_2999;
  assign and_2999 = and_2958_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/patches.hpp:321
  logic [1:0] select_3001;
  assign select_3001 = drew_q ? (equal_2077_s4_q ? {and_2999, and_2958_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3002;
  assign select_3002 = equal_1936_s4_q ? 2'h0 : select_3001;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3003;
  assign sum_3003 = registration_half_half_votes_down_q + {{5{select_3002[1]}}, select_3002};
  // hls/stages/patches.hpp:321
  logic [1:0] select_3008;
  assign select_3008 = drew_q ? (equal_2077_s4_q ? {and_3006_s4_q, and_2958_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_3009;
  assign select_3009 = equal_1936_s4_q ? 2'h0 : select_3008;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3010;
  assign sum_3010 = registration_half_half_votes_up_q + {{5{select_3009[1]}}, select_3009};
  // hls/stages/patches.hpp:321
  logic and_3044;
  assign and_3044 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & less_2012_s4_q));
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_3051;
  assign select_3051 = or_2016_s4_q ? 12'h0 : (equal_3049_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_3054;
  assign select_3054 = x_s4_q[6] ? (equal_1981_s4_q ? 12'h0 : (less_2012_s4_q ? select_3051 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:321
  logic [11:0] select_3055;
  assign select_3055 = equal_1936_s4_q ? select_3054 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3056;
  assign and_3056 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_3059;
  assign and_3059 = not_2341_s4_q & (less_2012_s4_q & ({and_3056, x_s4_q[0]} == 2'h0));
  // hls/stages/patches.hpp:321
  logic and_3061;
  assign and_3061 = equal_1936_s4_q & (x_s4_q[6] & and_3059);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3063;
  assign sum_3063 = {{2{select_3055[11]}}, select_3055} + (and_3061 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_3066;
  assign select_3066 = or_2016_s4_q ? 12'h0 : (equal_3049_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_3069;
  assign select_3069 = x_s4_q[6] ? (equal_1981_s4_q ? 12'h0 : (less_2012_s4_q ? select_3066 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:321
  logic [11:0] select_3070;
  assign select_3070 = equal_1936_s4_q ? select_3069 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3072;
  assign sum_3072 = {{2{select_3070[11]}}, select_3070} + (and_3061 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3074;
  assign not_3074 = ~all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_3077;
  assign and_3077 = not_2341_s4_q & (less_2012_s4_q & (x_s4_q[2:0] == {all_s4_q, not_3074, 1'b0}));
  // hls/stages/patches.hpp:321
  logic and_3083;
  assign and_3083 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & (less_2012_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_3084;
  assign not_3084 = ~and_3083;
  logic less_3085;
  assign less_3085 = $signed({9'h1, {2{not_3084}}, and_3083}) < $signed(registration_up_q[13:2]);
  logic select_3086;
  assign select_3086 = (equal_1936_s4_q & (x_s4_q[6] & and_3077)) ? less_3085 : registration_enough_q;
  // hls/stages/agreement.hpp:1084
  logic and_3090;
  assign and_3090 = x_s4_q[6] & (not_2341_s4_q & (less_2012_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:321
  logic and_3091;
  assign and_3091 = equal_1936_s4_q & and_3090;
  // hls/stages/registration.hpp:242
  logic less_3092;
  assign less_3092 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3094;
  assign less_3094 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1084
  logic and_3099;
  assign and_3099 = x_s4_q[6] & (not_2341_s4_q & (less_2012_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/patches.hpp:321
  logic and_3100;
  assign and_3100 = equal_1936_s4_q & and_3099;
  // hls/stages/agreement.hpp:1084
  logic and_3107;
  assign and_3107 = x_s4_q[6] & (not_2341_s4_q & (less_2012_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3110;
  assign equal_3110 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1084
  logic and_3113;
  assign and_3113 = not_2341_s4_q & (less_2012_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_3110));
  // hls/stages/registration.hpp:244
  logic and_3117;
  assign and_3117 = (equal_1936_s4_q & (x_s4_q[6] & and_3113)) & (less_3094 | less_3092);
  // hls/stages/agreement.hpp:1084
  logic and_3122;
  assign and_3122 = not_2341_s4_q & (less_2012_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_3110)));
  // hls/stages/registration.hpp:244
  logic and_3125;
  assign and_3125 = registration_votes_up_q & registration_other_down_q;
  logic select_3127;
  assign select_3127 = registration_votes_down_q ? (registration_other_up_q | and_3125) : and_3125;
  // hls/stages/registration.hpp:138
  logic and_3129;
  assign and_3129 = (equal_1936_s4_q & (x_s4_q[6] & and_3122)) & (registration_other_enough_q & select_3127);
  // hls/stages/registration.hpp:245
  logic or_3132;
  assign or_3132 = registration_moved_q | (registration_enough_q & (and_3117 | and_3129));
  // hls/stages/agreement.hpp:263
  logic [7:0] select_3217;
  assign select_3217 = sample_pair_whole_s4_q ? (equal_2067_s4_q ? patches_place_0_slope_q : select_2168[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3222;
  assign select_3222 = sample_pair_whole_s4_q ? (equal_2067_s4_q ? patches_place_1_slope_q : select_2197[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:110
  logic select_3224;
  assign select_3224 = equal_2067_s4_q ? patches_valid_0_q : (select_2066_s4_q ? patches_valid_0_q : select_2165[0]);
  // hls/stages/agreement.hpp:263
  logic select_3227;
  assign select_3227 = sample_pair_whole_s4_q ? (and_2188 ? (sample_present_s4_q & select_3224) : select_3224) : patches_valid_0_q;
  // hls/stages/patches.hpp:110
  logic select_3229;
  assign select_3229 = equal_2067_s4_q ? patches_valid_1_q : (select_2066_s4_q ? select_2165[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_3232;
  assign select_3232 = sample_pair_whole_s4_q ? (and_2208 ? (sample_present_s4_q & select_3229) : select_3229) : patches_valid_1_q;
  logic [5:0] select_3235;
  assign select_3235 = sample_pair_whole_s4_q ? (select_2186[5] ? {1'b1, select_2186[4:0]} : (select_2186 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3238;
  assign select_3238 = sample_pair_whole_s4_q ? (select_2206[5] ? {1'b1, select_2206[4:0]} : (select_2206 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3241;
  assign select_3241 = sample_pair_whole_s4_q ? (select_2219[4] ? {1'b1, select_2219[3:0]} : (select_2219 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3244;
  assign select_3244 = sample_pair_whole_s4_q ? (select_2224[4] ? {1'b1, select_2224[3:0]} : (select_2224 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:502
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3663_s4_q, parity_3659_s4_q, xor_3647_s4_q, parity_3619_s4_q, parity_3557_s4_q, parity_3428_s4_q} + (equal_3664_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:167
  logic [9:0] select_3668;
  assign select_3668 = equal_2149_s4_q ? patches_sums_values_0_q : (equal_2151_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3669;
  assign select_3669 = equal_2151_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3671;
  assign select_3671 = equal_2151_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3673;
  assign select_3673 = equal_2151_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3675;
  assign select_3675 = equal_2151_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3677;
  assign select_3677 = equal_2151_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3679;
  assign select_3679 = equal_2151_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3681;
  assign select_3681 = equal_2151_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3683;
  assign select_3683 = equal_2151_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3685;
  assign select_3685 = equal_2151_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3687;
  assign select_3687 = equal_2151_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3689;
  assign select_3689 = equal_2151_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3691;
  assign select_3691 = equal_2151_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3693;
  assign select_3693 = equal_2151_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3695;
  assign select_3695 = equal_2151_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3697;
  assign select_3697 = equal_2151_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3699;
  assign select_3699 = equal_2151_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:576
  logic or_3804;
  assign or_3804 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3803_s4_q;
  logic or_3807;
  assign or_3807 = equal_3795_s4_q | (less_3797_s4_q | (less_3798_s4_q | or_3804));
  // hls/stages/patches.hpp:556
  logic not_3808;
  assign not_3808 = ~or_3807;
  // hls/stages/patches.hpp:537
  logic and_3809;
  assign and_3809 = equal_2315_s4_q & not_3808;
  // hls/stages/patches.hpp:167
  logic and_3812;
  assign and_3812 = equal_2149_s4_q & (less_2312_s4_q ? (not_2314_s4_q & and_3809) : and_3809);
  // hls/stages/patches.hpp:619
  logic not_3813;
  assign not_3813 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:537
  logic and_3815;
  assign and_3815 = equal_2315_s4_q & (patches_second_s4_q & not_3808);
  // hls/stages/patches.hpp:167
  logic and_3818;
  assign and_3818 = equal_2149_s4_q & (less_2312_s4_q ? (not_2314_s4_q & and_3815) : and_3815);
  // hls/stages/patches.hpp:619
  logic not_3819;
  assign not_3819 = ~and_3818;
  // hls/stages/patches.hpp:171
  logic and_3821;
  assign and_3821 = and_3812 & (not_3813 & not_3819);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3823;
  assign sum_3823 = {7'h0, and_3821} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:574
  logic [7:0] select_3849;
  assign select_3849 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:573
  logic [5:0] select_3850;
  assign select_3850 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3851;
  assign sum_3851 = {2'h0, select_3783_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3852;
  assign sum_3852 = {select_3850[5], select_3850} + {{3{sum_3851[3]}}, sum_3851};
  // hls/stages/patches.hpp:574
  logic [17:0] product_3853;
  assign product_3853 = $signed({{10{select_3849[7]}}, select_3849}) * $signed({{8{sum_3852[6]}}, sum_3852, select_3783_s4_q[2:0]});
  // hls/stages/patches.hpp:575
  logic [13:0] difference_3854;
  assign difference_3854 = {{6{select_3848_s4_q[7]}}, select_3848_s4_q} - {product_3853[17], product_3853[17:5]};
  // hls/stages/patches.hpp:581
  logic less_3855;
  assign less_3855 = $signed({{7{difference_3825[6]}}, difference_3825}) < $signed(difference_3854);
  // hls/stages/patches.hpp:537
  logic and_3858;
  assign and_3858 = equal_2315_s4_q & (not_3808 & (~less_3855));
  // hls/stages/patches.hpp:167
  logic and_3861;
  assign and_3861 = equal_2149_s4_q & (less_2312_s4_q ? (not_2314_s4_q & and_3858) : and_3858);
  // hls/stages/patches.hpp:622
  logic and_3862;
  assign and_3862 = and_3861 & and_3821;
  logic [7:0] sum_3863;
  assign sum_3863 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3862};
  // hls/stages/patches.hpp:537
  logic and_3867;
  assign and_3867 = not_3808 & (~($signed(difference_3854) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3868;
  assign and_3868 = equal_2315_s4_q & and_3867;
  // hls/stages/patches.hpp:167
  logic and_3871;
  assign and_3871 = equal_2149_s4_q & (less_2312_s4_q ? (not_2314_s4_q & and_3868) : and_3868);
  // hls/stages/patches.hpp:623
  logic and_3872;
  assign and_3872 = and_3871 & and_3821;
  logic [7:0] sum_3873;
  assign sum_3873 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3872};
  // hls/stages/patches.hpp:171
  logic and_3875;
  assign and_3875 = and_3812 & (and_3818 & not_3813);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3877;
  assign sum_3877 = {7'h0, and_3875} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:622
  logic and_3879;
  assign and_3879 = and_3861 & and_3875;
  logic [7:0] sum_3880;
  assign sum_3880 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3879};
  // hls/stages/patches.hpp:623
  logic and_3882;
  assign and_3882 = and_3871 & and_3875;
  logic [7:0] sum_3883;
  assign sum_3883 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3882};
  // hls/stages/patches.hpp:171
  logic and_3885;
  assign and_3885 = and_3812 & (patches_lower_s4_q & not_3819);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3887;
  assign sum_3887 = {7'h0, and_3885} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:622
  logic and_3889;
  assign and_3889 = and_3861 & and_3885;
  logic [7:0] sum_3890;
  assign sum_3890 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3889};
  // hls/stages/patches.hpp:623
  logic and_3892;
  assign and_3892 = and_3871 & and_3885;
  logic [7:0] sum_3893;
  assign sum_3893 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3892};
  // hls/stages/patches.hpp:171
  logic and_3895;
  assign and_3895 = and_3812 & (patches_lower_s4_q & and_3818);
  // hls/stages/patches.hpp:621
  logic [7:0] sum_3897;
  assign sum_3897 = {7'h0, and_3895} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:622
  logic and_3899;
  assign and_3899 = and_3861 & and_3895;
  logic [7:0] sum_3900;
  assign sum_3900 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3899};
  // hls/stages/patches.hpp:623
  logic and_3902;
  assign and_3902 = and_3871 & and_3895;
  logic [7:0] sum_3903;
  assign sum_3903 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3902};
  // hls/stages/agreement.hpp:1154
  logic equal_3904;
  assign equal_3904 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1072
  logic less_3905;
  assign less_3905 = x_s4_q[5:3] < 3'h3;
  // hls/stages/patches.hpp:321
  logic and_3909;
  assign and_3909 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & (equal_3904 & less_3905)));
  // hls/stages/agreement.hpp:1084
  logic and_3914;
  assign and_3914 = x_s4_q[6] & (not_2341_s4_q & (less_3905 & (x_s4_q[2:0] == 3'h1)));
  // hls/stages/patches.hpp:321
  logic and_3915;
  assign and_3915 = equal_1936_s4_q & and_3914;
  // hls/stages/patches.hpp:598
  logic [7:0] or_3917;
  assign or_3917 = (and_3909 ? patches_quarters_0_places_q : 8'h0) | (and_3915 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1084
  logic and_3921;
  assign and_3921 = x_s4_q[6] & (not_2341_s4_q & (less_3905 & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/patches.hpp:321
  logic and_3922;
  assign and_3922 = equal_1936_s4_q & and_3921;
  // hls/stages/agreement.hpp:1084
  logic and_3928;
  assign and_3928 = x_s4_q[6] & (not_2341_s4_q & (less_3905 & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:321
  logic and_3929;
  assign and_3929 = equal_1936_s4_q & and_3928;
  // hls/stages/patches.hpp:598
  logic [7:0] or_3931;
  assign or_3931 = (or_3917 | (and_3922 ? patches_quarters_2_places_q : 8'h0)) | (and_3929 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:182
  logic select_3935;
  assign select_3935 = (x_s4_q[5:3] == 3'h2) ? x_s4_q[1] : (x_s4_q[0] & (x_s4_q[5:3] == 3'h1));
  // hls/stages/patches.hpp:321
  logic and_3939;
  assign and_3939 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & (less_3905 & select_3935)));
  // hls/stages/patches.hpp:599
  logic [7:0] select_3941;
  assign select_3941 = and_3909 ? (and_3939 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3943;
  assign select_3943 = and_3915 ? (and_3939 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3946;
  assign select_3946 = and_3922 ? (and_3939 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3949;
  assign select_3949 = and_3929 ? (and_3939 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:600
  logic [7:0] select_3952;
  assign select_3952 = and_3909 ? (and_3939 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3954;
  assign select_3954 = and_3915 ? (and_3939 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3957;
  assign select_3957 = and_3922 ? (and_3939 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3960;
  assign select_3960 = and_3929 ? (and_3939 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:185
  logic [4:0] sum_3962;
  assign sum_3962 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1084
  logic and_3966;
  assign and_3966 = x_s4_q[6] & (not_2341_s4_q & (less_3905 & (sum_3962[4:2] == 3'h0)));
  // hls/stages/patches.hpp:321
  logic and_3967;
  assign and_3967 = equal_1936_s4_q & and_3966;
  // hls/stages/patches.hpp:595
  logic [7:0] select_3970;
  assign select_3970 = and_3967 ? (patches_word_places_q + (and_3915 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3973;
  assign select_3973 = and_3967 ? (patches_word_up_q + (and_3915 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3976;
  assign select_3976 = and_3967 ? (patches_word_down_q + (and_3915 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:582
  logic [5:0] select_3980;
  assign select_3980 = ($signed(difference_3854[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3854[5:0];
  logic [5:0] select_3981;
  assign select_3981 = ($signed(14'h10) < $signed(difference_3854)) ? 6'h10 : select_3980;
  // hls/stages/patches.hpp:537
  logic [5:0] select_3983;
  assign select_3983 = equal_2315_s4_q ? (or_3807 ? 6'h0 : select_3981) : 6'h0;
  logic [5:0] select_3985;
  assign select_3985 = less_2312_s4_q ? (equal_2313_s4_q ? 6'h0 : select_3983) : select_3983;
  // hls/stages/patches.hpp:625
  logic [5:0] select_3987;
  assign select_3987 = and_3812 ? (equal_2149_s4_q ? select_3985 : 6'h0) : 6'h0;
  logic [11:0] sum_3988;
  assign sum_3988 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3987[5]}}, select_3987};
  // hls/stages/patches.hpp:321
  logic and_3992;
  assign and_3992 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q & (equal_3110 & less_3905)));
  // hls/stages/agreement.hpp:1084
  logic and_3996;
  assign and_3996 = x_s4_q[6] & (not_2341_s4_q & (less_3905 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:321
  logic and_3997;
  assign and_3997 = equal_1936_s4_q & and_3996;
  // hls/stages/patches.hpp:614
  logic [7:0] select_3999;
  assign select_3999 = and_3992 ? (and_3997 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:616
  logic or_4003;
  assign or_4003 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:613
  logic select_4005;
  assign select_4005 = and_3992 ? (and_3997 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:171
  logic and_4011;
  assign and_4011 = patches_complete_q & (equal_1936_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_4007_s4_q)));
  logic and_4012;
  assign and_4012 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:613
  logic [2:0] select_4014;
  assign select_4014 = and_3997 ? {and_4012, patches_found_q[2:1]} : (and_3992 ? {and_4012, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:607
  logic equal_4019;
  assign equal_4019 = patches_found_q == 3'h0;
  logic now_2;
  assign now_2 = ~equal_4019;
  // hls/stages/patches.hpp:612
  logic select_4023;
  assign select_4023 = patches_round_ends_q ? (patches_suspected_q & now_2) : patches_moved_q;
  logic select_4026;
  assign select_4026 = patches_round_ends_q ? (patches_suspected_q | (patches_settled_q | equal_4019)) : patches_settled_q;
  // hls/stages/agreement.hpp:1126
  logic or_4083;
  assign or_4083 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1148
  logic equal_4085;
  assign equal_4085 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1158
  logic select_4091;
  assign select_4091 = (equal_4085 & equal_3904) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_4094;
  assign sum_4094 = {1'b0, select_2894} + {2'h0, select_2894[9:1]};
  logic select_4097;
  assign select_4097 = (select_2891[9:3] == 7'h0) ? ((~or_4083) & (~select_4091)) : (~({sum_4094, select_2894[0]} < {2'h0, select_2891}));
  // hls/stages/agreement.hpp:1084
  logic [47:0] select_4099;
  assign select_4099 = x_s4_q[6] ? (equal_1981_s4_q ? good_q : {select_4097, good_q[47:1]}) : good_q;
  // hls/stages/patches.hpp:321
  logic select_4103;
  assign select_4103 = equal_1936_s4_q ? ((x_s4_q[6] & good_known_q) | equal_4007_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1148
  logic equal_4104;
  assign equal_4104 = x_s4_q[6:3] == 4'ha;
  logic equal_4106;
  assign equal_4106 = x_s4_q[6:3] == 4'h9;
  logic equal_4107;
  assign equal_4107 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_4109;
  assign select_4109 = equal_4106 ? counts_skin_unproven_q : (equal_4107 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4104 ? counts_nearer_q : select_4109;
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1161
  logic select_4112;
  assign select_4112 = (equal_4104 & equal_3904) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1086
  logic not_4113;
  assign not_4113 = ~hidden_for_q[7];
  logic [7:0] select_4115;
  assign select_4115 = select_4112 ? (hidden_for_q + {7'h0, not_4113}) : 8'h0;
  // hls/stages/patches.hpp:321
  logic [7:0] select_4117;
  assign select_4117 = equal_1936_s4_q ? (equal_4007_s4_q ? select_4115 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_4118;
  assign select_4118 = equal_3904 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_4120;
  assign select_4120 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4122;
  assign select_4122 = equal_4107 ? cfg_unproven_skin_limit_i : (equal_4085 ? cfg_unproven_limit_i : select_4120);
  logic [7:0] limit;
  assign limit = equal_4104 ? cfg_regions_limit_i : (equal_4106 ? cfg_hidden_limit_i : select_4122);
  // hls/stages/agreement.hpp:1161
  logic not_4125;
  assign not_4125 = ~x_s4_q[2];
  logic [3:0] select_4126;
  assign select_4126 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_4125, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_4125};
  logic [7:0] select_4127;
  assign select_4127 = x_s4_q[0] ? {select_4126[3], 1'b0, select_4126[2], 1'b0, select_4126[1], 1'b0, select_4126[0], 1'b0} : {1'b0, select_4126[3], 1'b0, select_4126[2], 1'b0, select_4126[1], 1'b0, select_4126[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_4131;
  assign select_4131 = equal_4106 ? counts_skin_supervised_q : (equal_4107 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_4104 ? counts_textured_q : select_4131;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_4133;
  assign select_4133 = ((limit & select_4127) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4118} + {1'b0, select_4133};
  // hls/stages/patches.hpp:321
  logic select_4138;
  assign select_4138 = equal_1936_s4_q ? (equal_3904 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1159
  logic and_4143;
  assign and_4143 = too_much_q & (~(equal_4107 & equal_3904));
  // hls/stages/agreement.hpp:1160
  logic select_4148;
  assign select_4148 = (over[14] & equal_3904) ? (and_4143 | ((equal_4107 | equal_4106) | (x_s4_q[6:3] == 4'hf))) : and_4143;
  // hls/stages/agreement.hpp:1235
  logic [1:0] select_4266;
  assign select_4266 = and_4265_s4_q ? {and_2471, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1236
  logic and_4267;
  assign and_4267 = proven_q & less_4255;
  // hls/stages/agreement.hpp:424
  logic select_4270;
  assign select_4270 = and_2401_s4_q ? (less_2402_s4_q ? (select_4266[0] & and_4267) : seen_q) : seen_q;
  logic select_4273;
  assign select_4273 = and_2401_s4_q ? (less_2402_s4_q ? (select_4266[1] & and_4267) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1169
  logic or_4282;
  assign or_4282 = ((~(cfg_patch_limit_i == 6'h3f)) & (~patches_settled_q)) | not_4281_s4_q;
  // hls/stages/agreement.hpp:1171
  logic not_4290;
  assign not_4290 = ~(or_4083 | not_4274);
  // hls/stages/patches.hpp:321
  logic and_4294;
  assign and_4294 = equal_1936_s4_q & (equal_4007_s4_q & (not_4290 & (select_4091 | select_4148)));
  logic and_4297;
  assign and_4297 = equal_4007_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1088
  logic or_4301;
  assign or_4301 = select_2724 | (select_2736 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/patches.hpp:321
  logic and_4308;
  assign and_4308 = equal_1936_s4_q & (equal_4007_s4_q & (not_4290 & (select_2730 | select_2742)));
  // hls/stages/agreement.hpp:1088
  logic and_4313;
  assign and_4313 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4115 < cfg_hidden_frames_i));
  // hls/stages/patches.hpp:321
  logic and_4320;
  assign and_4320 = equal_1936_s4_q & (x_s4_q[6] & (not_2341_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_4328;
  assign select_4328 = equal_2003_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4326_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4329;
  assign select_4329 = equal_2001_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4328;
  logic [31:0] select_4330;
  assign select_4330 = equal_1999_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4329;
  logic [31:0] select_4331;
  assign select_4331 = equal_1997_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_4330;
  logic [31:0] select_4332;
  assign select_4332 = equal_1995_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_4331;
  logic [31:0] select_4333;
  assign select_4333 = equal_1993_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4332;
  logic [31:0] select_4334;
  assign select_4334 = equal_1991_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4333;
  logic [31:0] select_4335;
  assign select_4335 = equal_1989_s4_q ? {9'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4334;
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_4336;
  assign select_4336 = less_2890 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1084
  logic [31:0] select_4337;
  assign select_4337 = equal_1981_s4_q ? select_4335 : {2'h0, select_4336, select_2894, select_2891};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_494_s4_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s4_q, and_609, and_585_s4_q, and_584_s4_q, and_559_s4_q, less_551_s4_q, less_550_s4_q, less_549_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q, less_545_s4_q, less_544_s4_q, less_543_s4_q, less_542_s4_q, less_541_s4_q, less_540_s4_q, less_539_s4_q, less_538_s4_q, less_537_s4_q, less_536_s4_q, less_535_s4_q, less_534_s4_q, less_533_s4_q, less_532_s4_q, less_531_s4_q, less_530_s4_q, less_529_s4_q, less_528_s4_q};
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
      patches_complete_q <= 1'b0;
      patches_round_ends_q <= 1'b0;
      patches_found_q <= 3'h0;
      patches_round_places_q <= 8'h0;
      patches_round_across_q <= 12'h0;
      patches_round_moved_q <= 3'h0;
      patches_suspected_q <= 1'b0;
      patches_moved_q <= 1'b0;
      patches_settled_q <= 1'b0;
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
      sharpness_sums_detail_0_q <= and_494_s4_q ? select_2652 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_494_s4_q ? select_2664 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_494_s4_q ? sum_2668 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_494_s4_q ? sum_2672 : sharpness_sums_contrast_1_q;
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
      counts_supervised_q <= select_2848;
      counts_textured_q <= and_2842_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2851});
      counts_explained_q <= and_2842_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2856});
      counts_nearer_q <= and_2842_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2861});
      counts_unproven_q <= and_2842_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2887});
      counts_regions_bad_q <= select_2903;
      counts_skin_supervised_q <= select_2910;
      counts_skin_textured_q <= select_2917;
      counts_skin_unproven_q <= select_2925;
      registration_half_across_q <= select_2977;
      registration_half_measured_q <= select_2982;
      registration_half_votes_down_q <= and_2957_s4_q ? 7'h0 : sum_2988;
      registration_half_votes_up_q <= and_2957_s4_q ? 7'h0 : sum_2996;
      registration_half_half_votes_down_q <= and_2957_s4_q ? 7'h0 : sum_3003;
      registration_half_half_votes_up_q <= and_2957_s4_q ? 7'h0 : sum_3010;
      registration_down_q <= and_3044 ? sum_3063 : registration_down_q;
      registration_up_q <= and_3044 ? sum_3072 : registration_up_q;
      registration_enough_q <= select_3086;
      registration_votes_down_q <= and_3091 ? less_3092 : registration_votes_down_q;
      registration_votes_up_q <= and_3091 ? less_3094 : registration_votes_up_q;
      registration_other_enough_q <= and_3100 ? select_3086 : registration_other_enough_q;
      registration_other_down_q <= and_3100 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3100 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1936_s4_q & and_3107)) & or_3132;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_2167 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_2169 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_2170 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3217;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_2196 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_2198 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_2199 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3222;
      patches_valid_0_q <= select_3227;
      patches_valid_1_q <= select_3232;
      patches_right_next_0_q <= select_3235;
      patches_right_next_1_q <= select_3238;
      patches_left_next_0_q <= select_3241;
      patches_left_next_1_q <= select_3244;
      patches_sums_values_0_q <= select_3668;
      patches_sums_values_1_q <= equal_2149_s4_q ? patches_sums_values_1_q : select_3669;
      patches_sums_values_2_q <= equal_2149_s4_q ? patches_sums_values_2_q : select_3671;
      patches_sums_values_3_q <= equal_2149_s4_q ? patches_sums_values_3_q : select_3673;
      patches_sums_values_4_q <= equal_2149_s4_q ? patches_sums_values_4_q : select_3675;
      patches_sums_values_5_q <= equal_2149_s4_q ? patches_sums_values_5_q : select_3677;
      patches_sums_values_6_q <= equal_2149_s4_q ? patches_sums_values_6_q : select_3679;
      patches_sums_values_7_q <= equal_2149_s4_q ? patches_sums_values_7_q : select_3681;
      patches_sums_values_8_q <= equal_2149_s4_q ? patches_sums_values_8_q : select_3683;
      patches_sums_values_9_q <= equal_2149_s4_q ? patches_sums_values_9_q : select_3685;
      patches_sums_values_10_q <= equal_2149_s4_q ? patches_sums_values_10_q : select_3687;
      patches_sums_values_11_q <= equal_2149_s4_q ? patches_sums_values_11_q : select_3689;
      patches_sums_values_12_q <= equal_2149_s4_q ? patches_sums_values_12_q : select_3691;
      patches_sums_values_13_q <= equal_2149_s4_q ? patches_sums_values_13_q : select_3693;
      patches_sums_values_14_q <= equal_2149_s4_q ? patches_sums_values_14_q : select_3695;
      patches_sums_values_15_q <= equal_2149_s4_q ? patches_sums_values_15_q : select_3697;
      patches_sums_values_16_q <= equal_2149_s4_q ? patches_sums_values_16_q : select_3699;
      patches_best_differing_q <= select_2329[9:0];
      patches_best_column_q <= select_2329[14:10];
      patches_quarters_0_places_q <= sum_3823;
      patches_quarters_0_up_q <= sum_3863;
      patches_quarters_0_down_q <= sum_3873;
      patches_quarters_1_places_q <= sum_3877;
      patches_quarters_1_up_q <= sum_3880;
      patches_quarters_1_down_q <= sum_3883;
      patches_quarters_2_places_q <= sum_3887;
      patches_quarters_2_up_q <= sum_3890;
      patches_quarters_2_down_q <= sum_3893;
      patches_quarters_3_places_q <= sum_3897;
      patches_quarters_3_up_q <= sum_3900;
      patches_quarters_3_down_q <= sum_3903;
      patches_word_places_q <= or_3931;
      patches_word_up_q <= ((select_3941 | select_3943) | select_3946) | select_3949;
      patches_word_down_q <= ((select_3952 | select_3954) | select_3957) | select_3960;
      patches_sum_places_q <= select_3970;
      patches_sum_up_q <= select_3973;
      patches_sum_down_q <= select_3976;
      patches_across_q <= sum_3988;
      patches_places_q <= select_3999;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4003;
      patches_complete_q <= select_4005;
      patches_round_ends_q <= and_4011;
      patches_found_q <= and_3992 ? select_4014 : patches_found_q;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_suspected_q <= patches_round_ends_q ? now_2 : patches_suspected_q;
      patches_moved_q <= select_4023;
      patches_settled_q <= select_4026;
      segment_textured_q <= select_2352 + {6'h0, and_2851};
      segment_explained_q <= select_2357 + {6'h0, and_2856};
      segment_nearer_q <= select_2363 + {6'h0, and_2861};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1936_s4_q ? select_4099 : good_q;
      good_known_q <= select_4103;
      hidden_for_q <= select_4117;
      product_q <= equal_1936_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4138;
      disagree_q <= equal_1936_s4_q ? select_4091 : disagree_q;
      too_much_q <= equal_1936_s4_q ? select_4148 : too_much_q;
      hides_q <= equal_1936_s4_q ? select_4112 : hides_q;
      seen_q <= select_4270;
      nearer_q <= select_4273;
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
      census_changes_values_0_left_q <= and_494_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_494_s4_q ? sum_2614 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2616;
      census_changes_values_1_right_q <= select_2617;
      census_changes_values_2_left_q <= select_2618;
      census_changes_values_2_right_q <= select_2619;
      sharpness_last_mask_q <= and_494_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_494_s4_q ? select_2635[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_494_s4_q ? select_2635[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_4250_s5_q;
  logic or_4275_s5_q;
  logic and_4276_s5_q;
  logic and_4285_s5_q;
  logic and_4288_s5_q;
  logic and_4294_s5_q;
  logic and_4298_s5_q;
  logic and_4304_s5_q;
  logic and_4308_s5_q;
  logic and_4316_s5_q;
  logic and_4320_s5_q;
  logic [5:0] select_4322_s5_q;
  logic [31:0] select_4339_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_0_q;
      pixel_1_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_4250_s5_q <= said_q;
      or_4275_s5_q <= not_4274 | select_4270;
      and_4276_s5_q <= cfg_prove_i & select_4273;
      and_4285_s5_q <= equal_1936_s4_q & (equal_4007_s4_q & (cfg_prove_i & or_4282));
      and_4288_s5_q <= equal_1936_s4_q & (equal_4007_s4_q & (cfg_prove_i & or_4083));
      and_4294_s5_q <= and_4294;
      and_4298_s5_q <= equal_1936_s4_q & and_4297;
      and_4304_s5_q <= equal_1936_s4_q & (equal_4007_s4_q & (not_4290 & or_4301));
      and_4308_s5_q <= and_4308;
      and_4316_s5_q <= equal_1936_s4_q & (equal_4007_s4_q & (cfg_prove_i & and_4313));
      and_4320_s5_q <= and_4320;
      select_4322_s5_q <= equal_1936_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_4339_s5_q <= equal_1936_s4_q ? (x_s4_q[6] ? select_4337 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4275_s5_q;
  assign marks_nearer_o = and_4276_s5_q;
  assign verdict_valid_o = and_4250_s5_q;
  assign verdict_unproven_yet_o = and_4285_s5_q;
  assign verdict_untextured_o = and_4288_s5_q;
  assign verdict_disagree_o = and_4294_s5_q;
  assign verdict_moved_o = and_4298_s5_q;
  assign verdict_unsharp_left_o = and_4304_s5_q;
  assign verdict_unsharp_right_o = and_4308_s5_q;
  assign verdict_hidden_o = and_4316_s5_q;
  assign frame_valid_o = and_4320_s5_q;
  assign frame_index_o = select_4322_s5_q;
  assign frame_word_o = select_4339_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_3962[1:0], product_3853[4:0], sum_2947[0], detail_4[1:0], detail_3[1:0], sum_2624[4:0], sum_2089[0], sum_2085[0], sum_607[4:0], cfg_width_i[2:0]};

endmodule
