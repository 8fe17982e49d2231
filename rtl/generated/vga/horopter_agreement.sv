// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2853 bits, pipeline 907 bits, memories 99716 bits.
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
  logic [5:0] sum_2812;
  assign sum_2812 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3793;
  assign difference_3793 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic [6:0] difference_4013;
  assign difference_4013 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4215;
  assign less_4215 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4216;
  assign sum_4216 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_4234;
  assign not_4234 = ~cfg_prove_i;

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
  logic [2:0] select_455;
  assign select_455 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_457;
  assign select_457 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [8:0] select_460;
  assign select_460 = ({select_457, select_455} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:116
  logic [8:0] select_461;
  assign select_461 = select_455[0] ? averager_place_q : select_460;
  // hls/stages/census.hpp:41
  logic or_462;
  assign or_462 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:404
  logic and_465;
  assign and_465 = (select_455[0] & or_462) & (select_461[8:6] < 3'h5);
  // hls/stages/census.hpp:41
  logic [2:0] select_470;
  assign select_470 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:263
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_457 : 7'h0;
  // hls/stages/census.hpp:50
  logic equal_487;
  assign equal_487 = select_455 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_488;
  assign equal_488 = select_470 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_489;
  assign and_489 = equal_488 & and_465;
  // hls/stages/agreement.hpp:263
  logic and_491;
  assign and_491 = sample_pair_whole_q & (equal_487 & and_489);
  // hls/stages/agreement.hpp:188
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:610
  logic equal_511;
  assign equal_511 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:581
  logic or_512;
  assign or_512 = so | equal_511;
  logic not_513;
  assign not_513 = ~or_512;
  // hls/stages/agreement.hpp:601
  logic equal_514;
  assign equal_514 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:602
  logic equal_516;
  assign equal_516 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:579
  logic [7:0] sum_517;
  assign sum_517 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:581
  logic [7:0] select_518;
  assign select_518 = run_shift_q[5] ? x_q : sum_517;
  logic less_519;
  assign less_519 = {1'b0, last_q} < select_518;
  // hls/stages/agreement.hpp:216
  logic not_520;
  assign not_520 = ~less_519;
  // hls/stages/agreement.hpp:141
  logic and_521;
  assign and_521 = equal_516 & not_520;
  logic and_523;
  assign and_523 = not_513 & ((~equal_514) & and_521);
  // hls/stages/census.hpp:41
  logic [5:0] select_550;
  assign select_550 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_550 : 6'h0;
  // hls/stages/agreement.hpp:141
  logic select_607;
  assign select_607 = equal_514 ? not_520 : and_521;
  // hls/stages/agreement.hpp:773
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:141
  logic and_631;
  assign and_631 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_518)));
  logic and_632;
  assign and_632 = equal_514 & and_631;
  logic select_633;
  assign select_633 = or_512 ? not_520 : and_632;
  // hls/stages/agreement.hpp:778
  logic equal_636;
  assign equal_636 = {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:782
  logic or_638;
  assign or_638 = equal_636 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:794
  logic [6:0] right;
  assign right = sum_517[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:263
  logic [2:0] select_2462;
  assign select_2462 = sample_pair_whole_q ? (sample_last_q ? (select_470 + 3'h1) : select_470) : raster_at_y_q;
  logic [6:0] select_2464;
  assign select_2464 = sample_pair_whole_q ? (select_457 + {6'h0, equal_487}) : raster_at_column_q;
  logic [5:0] select_2467;
  assign select_2467 = sample_pair_whole_q ? (sample_last_q ? (select_550 + {5'h0, equal_488}) : select_550) : raster_at_row_q;
  logic select_2471;
  assign select_2471 = sample_pair_whole_q ? (sample_last_q ? (or_462 & (~raster_final_row_q)) : or_462) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2473;
  assign select_2473 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:263
  logic select_2477;
  assign select_2477 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:446
  logic equal_2721;
  assign equal_2721 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:451
  logic and_2722;
  assign and_2722 = and_491 & equal_2721;
  // hls/stages/agreement.hpp:510
  logic select_2725;
  assign select_2725 = (and_2722 | (~ends_cell_q)) ? and_2722 : ends_q;
  // hls/stages/agreement.hpp:516
  logic [2:0] now;
  assign now = select_2725 ? (and_2722 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:521
  logic [5:0] select_2729;
  assign select_2729 = select_2725 ? (and_2722 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2732;
  assign select_2732 = select_2725 ? (following_last_shift_q & (~and_2722)) : run_last_shift_q;
  // hls/stages/agreement.hpp:594
  logic and_2735;
  assign and_2735 = run_last_shift_q & equal_514;
  // hls/stages/agreement.hpp:603
  logic select_2737;
  assign select_2737 = equal_514 ? (~run_last_shift_q) : equal_516;
  // hls/stages/agreement.hpp:607
  logic equal_2738;
  assign equal_2738 = run_phase_q == 3'h1;
  logic not_2741;
  assign not_2741 = ~select_2737;
  // hls/stages/agreement.hpp:610
  logic equal_2743;
  assign equal_2743 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:594
  logic and_2744;
  assign and_2744 = final_row_q & so;
  // hls/stages/agreement.hpp:607
  logic [1:0] select_2745;
  assign select_2745 = equal_2743 ? 2'h1 : {2{and_2744}};
  logic [2:0] select_2747;
  assign select_2747 = (and_2735 | (select_2737 | equal_2738)) ? (equal_2738 ? 3'h2 : {not_2741, {2{select_2737}}}) : (equal_511 ? 3'h6 : {select_2745[0], select_2745});
  // hls/stages/agreement.hpp:594
  logic and_2750;
  assign and_2750 = select_2737 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:617
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2753;
  assign select_2753 = (plan_shift_q[5] & select_2737) ? value : 7'h0;
  logic [1:0] or_2754;
  assign or_2754 = {2{so}} | select_2753[5:4];
  // hls/stages/agreement.hpp:620
  logic [7:0] or_2758;
  assign or_2758 = (select_2737 ? plan_columns_q : 8'h0) | ((equal_2738 | equal_2743) ? whole_q : 8'h0);
  logic [1:0] or_2759;
  assign or_2759 = {2{and_2735}} | or_2758[3:2];
  // hls/stages/agreement.hpp:621
  logic [7:0] or_2761;
  assign or_2761 = {or_2758[7:4], or_2759, or_2758[1:0]} | (equal_511 ? drawn_q : 8'h0);
  logic [4:0] or_2762;
  assign or_2762 = {5{so}} | {or_2761[6], or_2761[3:0]};
  // hls/stages/agreement.hpp:627
  logic not_2766;
  assign not_2766 = ~run_shift_q[5];
  logic [7:0] select_2769;
  assign select_2769 = equal_514 ? ({{7{not_2766}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:510
  logic [6:0] select_2773;
  assign select_2773 = and_2722 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:513
  logic [7:0] select_2775;
  assign select_2775 = select_2725 ? {select_2773[6], select_2773} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2778;
  assign select_2778 = select_2725 ? (and_2722 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:507
  logic [6:0] select_2786;
  assign select_2786 = and_491 ? (equal_2721 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2789;
  assign select_2789 = and_491 ? (equal_2721 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2792;
  assign select_2792 = and_491 ? (equal_2721 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:518
  logic select_2803;
  assign select_2803 = (ends_cell_q | select_2725) ? (~(now == 3'h6)) : (equal_514 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:513
  logic and_2807;
  assign and_2807 = (~select_2725) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:463
  logic [6:0] sum_2808;
  assign sum_2808 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:447
  logic select_2810;
  assign select_2810 = equal_2721 ? ({sum_2808[6], cfg_height_i[8:3]} == {1'b0, sum_2808[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:344
  logic or_3177;
  assign or_3177 = select_457[0] | select_550[5];
  logic [7:0] sum_3178;
  assign sum_3178 = {1'b0, select_457[2:1], or_3177, select_550[4:1]} + 8'h1;
  logic less_3179;
  assign less_3179 = {sum_3178, select_550[0], select_470, 1'b0} < {4'h0, cfg_height_i};

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1293; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 30'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_523;
  logic [29:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [28:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[28:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:1294; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 78'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (or_512 ? not_520 : select_607);
  logic [77:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [76:0] left_rdata_q;
  assign left_rdata_q = left_word_q[76:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:1295; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [91:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 92'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_514 ? sum_517[6:0] : x_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_513 & select_607);
  logic [91:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [90:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[90:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 46 and parity, DISTANCE 12, hls/stages/agreement.hpp:1296; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [46:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 47'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_512 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_633;
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
      raster_at_x_q <= sample_pair_whole_q ? (select_455 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2462;
      raster_at_column_q <= select_2464;
      raster_at_row_q <= select_2467;
      raster_at_live_q <= select_2471;
      raster_rows_left_q <= sample_pair_whole_q ? select_2473 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2477;
      averager_place_q <= sample_pair_whole_q ? select_461 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2729;
      run_last_shift_q <= select_2732;
      run_span_q <= select_2725 ? (and_2722 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2747;
      following_shift_q <= select_2737 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2750;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2753[6], or_2754, select_2753[3:0]};
      following_columns_q <= {or_2761[7], or_2762[4], or_2761[5:4], or_2762[3:0]};
      plan_shift_q <= equal_514 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2769;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2775;
      columns_left_q <= select_2778;
      last_q <= and_491 ? (equal_2721 ? column : last_q) : last_q;
      least_q <= select_2786;
      whole_q <= select_2789;
      drawn_q <= select_2792;
      age_q <= select_2725 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2725 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2803;
      ends_q <= and_2807;
      final_row_q <= and_491 ? select_2810 : final_row_q;
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
  logic [2:0] select_455_s1_q;
  logic [6:0] select_457_s1_q;
  logic [8:0] select_461_s1_q;
  logic and_465_s1_q;
  logic equal_471_s1_q;
  logic [6:0] column_s1_q;
  logic and_489_s1_q;
  logic and_491_s1_q;
  logic so_s1_q;
  logic equal_511_s1_q;
  logic or_512_s1_q;
  logic equal_514_s1_q;
  logic less_519_s1_q;
  logic not_520_s1_q;
  logic and_523_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_633_s1_q;
  logic select_640_s1_q;
  logic and_1915_s1_q;
  logic [6:0] right_s1_q;
  logic select_1924_s1_q;
  logic equal_1933_s1_q;
  logic equal_2052_s1_q;
  logic equal_2721_s1_q;
  logic and_2722_s1_q;
  logic not_3180_s1_q;
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
      select_455_s1_q <= select_455;
      select_457_s1_q <= select_457;
      select_461_s1_q <= select_461;
      and_465_s1_q <= and_465;
      equal_471_s1_q <= select_470 == 3'h0;
      column_s1_q <= column;
      and_489_s1_q <= and_489;
      and_491_s1_q <= and_491;
      so_s1_q <= so;
      equal_511_s1_q <= equal_511;
      or_512_s1_q <= or_512;
      equal_514_s1_q <= equal_514;
      less_519_s1_q <= less_519;
      not_520_s1_q <= not_520;
      and_523_s1_q <= and_523;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_633_s1_q <= select_633;
      select_640_s1_q <= or_638 ? equal_636 : (~age_q[3]);
      and_1915_s1_q <= not_513 & and_632;
      right_s1_q <= right;
      select_1924_s1_q <= or_638 ? equal_636 : ({x[7], last_q} == {1'b0, x[6:0]});
      equal_1933_s1_q <= run_phase_q == 3'h7;
      equal_2052_s1_q <= {or_462, select_470} == 4'hc;
      equal_2721_s1_q <= equal_2721;
      and_2722_s1_q <= and_2722;
      not_3180_s1_q <= ~less_3179;
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
  logic not_611;
  assign not_611 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:656
  logic and_612;
  assign and_612 = left_rdata_q[12] & not_611;
  logic and_613;
  assign and_613 = left_rdata_q[28] & not_611;
  logic and_614;
  assign and_614 = left_rdata_q[44] & not_611;
  logic and_615;
  assign and_615 = left_rdata_q[60] & not_611;
  // hls/stages/agreement.hpp:657
  logic and_619;
  assign and_619 = right_codes_rdata_q[12] & not_611;
  logic and_620;
  assign and_620 = right_codes_rdata_q[25] & not_611;
  logic and_621;
  assign and_621 = right_codes_rdata_q[38] & not_611;
  logic and_622;
  assign and_622 = right_codes_rdata_q[51] & not_611;
  logic and_623;
  assign and_623 = right_codes_rdata_q[64] & not_611;
  logic and_624;
  assign and_624 = right_codes_rdata_q[77] & not_611;
  // hls/stages/agreement.hpp:212
  logic and_646;
  assign and_646 = left_rdata_q[44] & not_520_s1_q;
  logic and_647;
  assign and_647 = right_codes_rdata_q[38] & not_520_s1_q;
  logic [11:0] select_648;
  assign select_648 = less_519_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_649;
  assign select_649 = less_519_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_653;
  assign select_653 = and_646 ? (and_647 ? (~(select_648 ^ select_649)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_659;
  assign parity_659 = ^select_653[5:3];
  logic parity_662;
  assign parity_662 = ^select_653[8:6];
  logic parity_665;
  assign parity_665 = ^select_653[11:3];
  // hls/stages/agreement.hpp:212
  logic and_669;
  assign and_669 = left_rdata_q[60] & not_520_s1_q;
  logic and_670;
  assign and_670 = right_codes_rdata_q[51] & not_520_s1_q;
  logic [11:0] select_671;
  assign select_671 = less_519_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_672;
  assign select_672 = less_519_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_676;
  assign select_676 = and_669 ? (and_670 ? (~(select_671 ^ select_672)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_679;
  assign parity_679 = ^select_676[8:6];
  logic parity_682;
  assign parity_682 = ^select_676[11:9];
  // hls/stages/agreement.hpp:212
  logic and_686;
  assign and_686 = left_rdata_q[76] & not_520_s1_q;
  logic and_687;
  assign and_687 = right_codes_rdata_q[64] & not_520_s1_q;
  logic [11:0] select_688;
  assign select_688 = less_519_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_689;
  assign select_689 = less_519_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_693;
  assign select_693 = and_686 ? (and_687 ? (~(select_688 ^ select_689)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_699;
  assign parity_699 = ^select_693[2:0];
  logic parity_702;
  assign parity_702 = ^select_693[5:3];
  logic parity_705;
  assign parity_705 = ^select_693[8:0];
  logic parity_711;
  assign parity_711 = ^select_693[11:9];
  logic parity_714;
  assign parity_714 = ^select_676[2:0];
  logic parity_717;
  assign parity_717 = ^{select_693[11:9], select_676[5:0]};
  logic parity_720;
  assign parity_720 = ^{select_693, select_676, select_653[2:0]};
  logic xor_721;
  assign xor_721 = parity_665 ^ parity_720;
  // hls/stages/count_bits.hpp:23
  logic or_725;
  assign or_725 = (select_653[1:0] == 2'h3) | (select_653[2] & (select_653[0] | select_653[1]));
  // hls/stages/count_bits.hpp:25
  logic or_729;
  assign or_729 = (select_676[7:6] == 2'h3) | (select_676[8] & (select_676[6] | select_676[7]));
  logic or_733;
  assign or_733 = (select_676[10:9] == 2'h3) | (select_676[11] & (select_676[9] | select_676[10]));
  // hls/stages/count_bits.hpp:23
  logic or_741;
  assign or_741 = (select_693[7:6] == 2'h3) | (select_693[8] & (~(select_693[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_745;
  assign or_745 = (select_693[1:0] == 2'h3) | (select_693[2] & (select_693[0] | select_693[1]));
  logic or_749;
  assign or_749 = (select_693[4:3] == 2'h3) | (select_693[5] & (select_693[3] | select_693[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_752;
  assign parity_752 = ^{or_749, or_745, or_741};
  // hls/stages/count_bits.hpp:23
  logic or_756;
  assign or_756 = (select_676[4:3] == 2'h3) | (select_676[5] & (select_676[3] | select_676[4]));
  // hls/stages/count_bits.hpp:25
  logic or_760;
  assign or_760 = (select_693[10:9] == 2'h3) | (select_693[11] & (select_693[9] | select_693[10]));
  logic or_764;
  assign or_764 = (select_676[1:0] == 2'h3) | (select_676[2] & (select_676[0] | select_676[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_767;
  assign parity_767 = ^{or_764, or_760, or_756};
  logic parity_770;
  assign parity_770 = ^{or_764, or_760, or_756, or_749, or_745, or_741, or_733, or_729, or_725};
  // hls/stages/count_bits.hpp:25
  logic and_771;
  assign and_771 = parity_665 & parity_720;
  logic or_775;
  assign or_775 = (parity_659 & parity_662) | ((^select_653[11:9]) & (parity_659 | parity_662));
  logic and_778;
  assign and_778 = (^{select_676[11:6], select_653[2:0]}) & (parity_705 | parity_717);
  logic or_779;
  assign or_779 = (parity_705 & parity_717) | and_778;
  // hls/stages/count_bits.hpp:23
  logic or_786;
  assign or_786 = (select_653[10:9] == 2'h3) | (select_653[11] & (select_653[9] | select_653[10]));
  // hls/stages/count_bits.hpp:25
  logic or_790;
  assign or_790 = (select_653[4:3] == 2'h3) | (select_653[5] & (select_653[3] | select_653[4]));
  logic or_794;
  assign or_794 = (select_653[7:6] == 2'h3) | (select_653[8] & (select_653[6] | select_653[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_797;
  assign parity_797 = ^{or_794, or_790, or_786};
  // hls/stages/count_bits.hpp:25
  logic or_801;
  assign or_801 = (parity_679 & parity_682) | ((^select_653[2:0]) & (parity_679 | parity_682));
  logic or_805;
  assign or_805 = (parity_699 & parity_702) | ((^select_693[8:6]) & (parity_699 | parity_702));
  logic or_809;
  assign or_809 = (parity_711 & parity_714) | ((^select_676[5:3]) & (parity_711 | parity_714));
  // hls/stages/count_bits.hpp:24
  logic parity_812;
  assign parity_812 = ^{or_809, or_805, or_801};
  logic parity_815;
  assign parity_815 = ^{or_809, or_805, or_801, or_794, or_790, or_786, or_779, or_775, and_771};
  logic xor_816;
  assign xor_816 = parity_770 ^ parity_815;
  // hls/stages/count_bits.hpp:25
  logic and_817;
  assign and_817 = parity_770 & parity_815;
  logic or_821;
  assign or_821 = (parity_752 & parity_767) | ((^{or_733, or_729, or_725}) & (parity_752 | parity_767));
  logic or_825;
  assign or_825 = (parity_797 & parity_812) | ((^{or_779, or_775, and_771}) & (parity_797 | parity_812));
  logic or_832;
  assign or_832 = (or_729 & or_733) | (or_725 & (or_729 | or_733));
  logic or_836;
  assign or_836 = (or_745 & or_749) | (or_741 & (or_745 | or_749));
  logic or_840;
  assign or_840 = (or_760 & or_764) | (or_756 & (or_760 | or_764));
  // hls/stages/count_bits.hpp:24
  logic parity_843;
  assign parity_843 = ^{or_840, or_836, or_832};
  // hls/stages/count_bits.hpp:25
  logic or_847;
  assign or_847 = (or_775 & or_779) | (and_771 & (or_775 | or_779));
  logic or_851;
  assign or_851 = (or_790 & or_794) | (or_786 & (or_790 | or_794));
  logic or_855;
  assign or_855 = (or_805 & or_809) | (or_801 & (or_805 | or_809));
  // hls/stages/count_bits.hpp:24
  logic parity_858;
  assign parity_858 = ^{or_855, or_851, or_847};
  logic parity_861;
  assign parity_861 = ^{or_855, or_851, or_847, or_840, or_836, or_832, or_825, or_821, and_817};
  // hls/stages/count_bits.hpp:25
  logic or_865;
  assign or_865 = (parity_843 & parity_858) | ((^{or_825, or_821, and_817}) & (parity_843 | parity_858));
  logic or_869;
  assign or_869 = (or_821 & or_825) | (and_817 & (or_821 | or_825));
  logic or_873;
  assign or_873 = (or_836 & or_840) | (or_832 & (or_836 | or_840));
  logic or_877;
  assign or_877 = (or_851 & or_855) | (or_847 & (or_851 | or_855));
  // hls/stages/count_bits.hpp:24
  logic parity_882;
  assign parity_882 = ^{or_877, or_873, or_869, or_865};
  // hls/stages/count_bits.hpp:25
  logic or_886;
  assign or_886 = (or_873 & or_877) | (or_869 & (or_873 | or_877));
  logic and_887;
  assign and_887 = or_865 & (^{or_877, or_873, or_869});
  // hls/stages/count_bits.hpp:24
  logic xor_888;
  assign xor_888 = or_886 ^ and_887;
  // hls/stages/count_bits.hpp:27
  logic and_889;
  assign and_889 = or_886 & and_887;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_890;
  assign select_890 = equal_514_s1_q ? {and_889, xor_888, parity_882, parity_861, xor_816, xor_721} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_512_s1_q ? 6'h0 : select_890;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_892;
  assign select_892 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_893;
  assign difference_893 = {1'b0, column_2} - {1'b0, select_892};
  logic [7:0] sum_895;
  assign sum_895 = {difference_893[6], difference_893} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] select_899;
  assign select_899 = and_646 ? (and_670 ? (~(select_671 ^ select_649)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_905;
  assign parity_905 = ^select_899[5:3];
  logic parity_908;
  assign parity_908 = ^select_899[8:6];
  logic parity_911;
  assign parity_911 = ^select_899[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_918;
  assign select_918 = and_669 ? (and_687 ? (~(select_688 ^ select_672)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_921;
  assign parity_921 = ^select_918[8:6];
  logic parity_924;
  assign parity_924 = ^select_918[11:9];
  // hls/stages/agreement.hpp:212
  logic and_928;
  assign and_928 = right_codes_rdata_q[77] & not_520_s1_q;
  logic [11:0] select_929;
  assign select_929 = less_519_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_933;
  assign select_933 = and_686 ? (and_928 ? (~(select_929 ^ select_689)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_939;
  assign parity_939 = ^select_933[2:0];
  logic parity_942;
  assign parity_942 = ^select_933[5:3];
  logic parity_945;
  assign parity_945 = ^select_933[8:0];
  logic parity_951;
  assign parity_951 = ^select_933[11:9];
  logic parity_954;
  assign parity_954 = ^select_918[2:0];
  logic parity_957;
  assign parity_957 = ^{select_933[11:9], select_918[5:0]};
  logic parity_960;
  assign parity_960 = ^{select_933, select_918, select_899[2:0]};
  logic xor_961;
  assign xor_961 = parity_911 ^ parity_960;
  // hls/stages/count_bits.hpp:23
  logic or_965;
  assign or_965 = (select_899[1:0] == 2'h3) | (select_899[2] & (select_899[0] | select_899[1]));
  // hls/stages/count_bits.hpp:25
  logic or_969;
  assign or_969 = (select_918[7:6] == 2'h3) | (select_918[8] & (select_918[6] | select_918[7]));
  logic or_973;
  assign or_973 = (select_918[10:9] == 2'h3) | (select_918[11] & (select_918[9] | select_918[10]));
  // hls/stages/count_bits.hpp:23
  logic or_981;
  assign or_981 = (select_933[7:6] == 2'h3) | (select_933[8] & (~(select_933[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_985;
  assign or_985 = (select_933[1:0] == 2'h3) | (select_933[2] & (select_933[0] | select_933[1]));
  logic or_989;
  assign or_989 = (select_933[4:3] == 2'h3) | (select_933[5] & (select_933[3] | select_933[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_992;
  assign parity_992 = ^{or_989, or_985, or_981};
  // hls/stages/count_bits.hpp:23
  logic or_996;
  assign or_996 = (select_918[4:3] == 2'h3) | (select_918[5] & (select_918[3] | select_918[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1000;
  assign or_1000 = (select_933[10:9] == 2'h3) | (select_933[11] & (select_933[9] | select_933[10]));
  logic or_1004;
  assign or_1004 = (select_918[1:0] == 2'h3) | (select_918[2] & (select_918[0] | select_918[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1007;
  assign parity_1007 = ^{or_1004, or_1000, or_996};
  logic parity_1010;
  assign parity_1010 = ^{or_1004, or_1000, or_996, or_989, or_985, or_981, or_973, or_969, or_965};
  // hls/stages/count_bits.hpp:25
  logic and_1011;
  assign and_1011 = parity_911 & parity_960;
  logic or_1015;
  assign or_1015 = (parity_905 & parity_908) | ((^select_899[11:9]) & (parity_905 | parity_908));
  logic and_1018;
  assign and_1018 = (^{select_918[11:6], select_899[2:0]}) & (parity_945 | parity_957);
  logic or_1019;
  assign or_1019 = (parity_945 & parity_957) | and_1018;
  // hls/stages/count_bits.hpp:23
  logic or_1026;
  assign or_1026 = (select_899[10:9] == 2'h3) | (select_899[11] & (select_899[9] | select_899[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1030;
  assign or_1030 = (select_899[4:3] == 2'h3) | (select_899[5] & (select_899[3] | select_899[4]));
  logic or_1034;
  assign or_1034 = (select_899[7:6] == 2'h3) | (select_899[8] & (select_899[6] | select_899[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1037;
  assign parity_1037 = ^{or_1034, or_1030, or_1026};
  // hls/stages/count_bits.hpp:25
  logic or_1041;
  assign or_1041 = (parity_921 & parity_924) | ((^select_899[2:0]) & (parity_921 | parity_924));
  logic or_1045;
  assign or_1045 = (parity_939 & parity_942) | ((^select_933[8:6]) & (parity_939 | parity_942));
  logic or_1049;
  assign or_1049 = (parity_951 & parity_954) | ((^select_918[5:3]) & (parity_951 | parity_954));
  // hls/stages/count_bits.hpp:24
  logic parity_1052;
  assign parity_1052 = ^{or_1049, or_1045, or_1041};
  logic parity_1055;
  assign parity_1055 = ^{or_1049, or_1045, or_1041, or_1034, or_1030, or_1026, or_1019, or_1015, and_1011};
  logic xor_1056;
  assign xor_1056 = parity_1010 ^ parity_1055;
  // hls/stages/count_bits.hpp:25
  logic and_1057;
  assign and_1057 = parity_1010 & parity_1055;
  logic or_1061;
  assign or_1061 = (parity_992 & parity_1007) | ((^{or_973, or_969, or_965}) & (parity_992 | parity_1007));
  logic or_1065;
  assign or_1065 = (parity_1037 & parity_1052) | ((^{or_1019, or_1015, and_1011}) & (parity_1037 | parity_1052));
  logic or_1072;
  assign or_1072 = (or_969 & or_973) | (or_965 & (or_969 | or_973));
  logic or_1076;
  assign or_1076 = (or_985 & or_989) | (or_981 & (or_985 | or_989));
  logic or_1080;
  assign or_1080 = (or_1000 & or_1004) | (or_996 & (or_1000 | or_1004));
  // hls/stages/count_bits.hpp:24
  logic parity_1083;
  assign parity_1083 = ^{or_1080, or_1076, or_1072};
  // hls/stages/count_bits.hpp:25
  logic or_1087;
  assign or_1087 = (or_1015 & or_1019) | (and_1011 & (or_1015 | or_1019));
  logic or_1091;
  assign or_1091 = (or_1030 & or_1034) | (or_1026 & (or_1030 | or_1034));
  logic or_1095;
  assign or_1095 = (or_1045 & or_1049) | (or_1041 & (or_1045 | or_1049));
  // hls/stages/count_bits.hpp:24
  logic parity_1098;
  assign parity_1098 = ^{or_1095, or_1091, or_1087};
  logic parity_1101;
  assign parity_1101 = ^{or_1095, or_1091, or_1087, or_1080, or_1076, or_1072, or_1065, or_1061, and_1057};
  // hls/stages/count_bits.hpp:25
  logic or_1105;
  assign or_1105 = (parity_1083 & parity_1098) | ((^{or_1065, or_1061, and_1057}) & (parity_1083 | parity_1098));
  logic or_1109;
  assign or_1109 = (or_1061 & or_1065) | (and_1057 & (or_1061 | or_1065));
  logic or_1113;
  assign or_1113 = (or_1076 & or_1080) | (or_1072 & (or_1076 | or_1080));
  logic or_1117;
  assign or_1117 = (or_1091 & or_1095) | (or_1087 & (or_1091 | or_1095));
  // hls/stages/count_bits.hpp:24
  logic parity_1122;
  assign parity_1122 = ^{or_1117, or_1113, or_1109, or_1105};
  // hls/stages/count_bits.hpp:25
  logic or_1126;
  assign or_1126 = (or_1113 & or_1117) | (or_1109 & (or_1113 | or_1117));
  logic and_1127;
  assign and_1127 = or_1105 & (^{or_1117, or_1113, or_1109});
  // hls/stages/count_bits.hpp:24
  logic xor_1128;
  assign xor_1128 = or_1126 ^ and_1127;
  // hls/stages/count_bits.hpp:27
  logic and_1129;
  assign and_1129 = or_1126 & and_1127;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1130;
  assign select_1130 = equal_514_s1_q ? {and_1129, xor_1128, parity_1122, parity_1101, xor_1056, xor_961} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_512_s1_q ? 6'h0 : select_1130;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1132;
  assign select_1132 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1133;
  assign difference_1133 = {1'b0, column_3} - {1'b0, select_1132};
  logic [7:0] sum_1135;
  assign sum_1135 = {difference_1133[6], difference_1133} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:212
  logic and_1136;
  assign and_1136 = right_codes_rdata_q[25] & not_520_s1_q;
  logic [11:0] select_1137;
  assign select_1137 = less_519_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1141;
  assign select_1141 = and_646 ? (and_1136 ? (~(select_1137 ^ select_649)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1147;
  assign parity_1147 = ^select_1141[5:3];
  logic parity_1150;
  assign parity_1150 = ^select_1141[8:6];
  logic parity_1153;
  assign parity_1153 = ^select_1141[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1160;
  assign select_1160 = and_669 ? (and_647 ? (~(select_648 ^ select_672)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1163;
  assign parity_1163 = ^select_1160[8:6];
  logic parity_1166;
  assign parity_1166 = ^select_1160[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1173;
  assign select_1173 = and_686 ? (and_670 ? (~(select_671 ^ select_689)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1179;
  assign parity_1179 = ^select_1173[2:0];
  logic parity_1182;
  assign parity_1182 = ^select_1173[5:3];
  logic parity_1185;
  assign parity_1185 = ^select_1173[8:0];
  logic parity_1191;
  assign parity_1191 = ^select_1173[11:9];
  logic parity_1194;
  assign parity_1194 = ^select_1160[2:0];
  logic parity_1197;
  assign parity_1197 = ^{select_1173[11:9], select_1160[5:0]};
  logic parity_1200;
  assign parity_1200 = ^{select_1173, select_1160, select_1141[2:0]};
  logic xor_1201;
  assign xor_1201 = parity_1153 ^ parity_1200;
  // hls/stages/count_bits.hpp:23
  logic or_1205;
  assign or_1205 = (select_1141[1:0] == 2'h3) | (select_1141[2] & (select_1141[0] | select_1141[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1209;
  assign or_1209 = (select_1160[7:6] == 2'h3) | (select_1160[8] & (select_1160[6] | select_1160[7]));
  logic or_1213;
  assign or_1213 = (select_1160[10:9] == 2'h3) | (select_1160[11] & (select_1160[9] | select_1160[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1221;
  assign or_1221 = (select_1173[7:6] == 2'h3) | (select_1173[8] & (~(select_1173[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1225;
  assign or_1225 = (select_1173[1:0] == 2'h3) | (select_1173[2] & (select_1173[0] | select_1173[1]));
  logic or_1229;
  assign or_1229 = (select_1173[4:3] == 2'h3) | (select_1173[5] & (select_1173[3] | select_1173[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1232;
  assign parity_1232 = ^{or_1229, or_1225, or_1221};
  // hls/stages/count_bits.hpp:23
  logic or_1236;
  assign or_1236 = (select_1160[4:3] == 2'h3) | (select_1160[5] & (select_1160[3] | select_1160[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1240;
  assign or_1240 = (select_1173[10:9] == 2'h3) | (select_1173[11] & (select_1173[9] | select_1173[10]));
  logic or_1244;
  assign or_1244 = (select_1160[1:0] == 2'h3) | (select_1160[2] & (select_1160[0] | select_1160[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1247;
  assign parity_1247 = ^{or_1244, or_1240, or_1236};
  logic parity_1250;
  assign parity_1250 = ^{or_1244, or_1240, or_1236, or_1229, or_1225, or_1221, or_1213, or_1209, or_1205};
  // hls/stages/count_bits.hpp:25
  logic and_1251;
  assign and_1251 = parity_1153 & parity_1200;
  logic or_1255;
  assign or_1255 = (parity_1147 & parity_1150) | ((^select_1141[11:9]) & (parity_1147 | parity_1150));
  logic and_1258;
  assign and_1258 = (^{select_1160[11:6], select_1141[2:0]}) & (parity_1185 | parity_1197);
  logic or_1259;
  assign or_1259 = (parity_1185 & parity_1197) | and_1258;
  // hls/stages/count_bits.hpp:23
  logic or_1266;
  assign or_1266 = (select_1141[10:9] == 2'h3) | (select_1141[11] & (select_1141[9] | select_1141[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1270;
  assign or_1270 = (select_1141[4:3] == 2'h3) | (select_1141[5] & (select_1141[3] | select_1141[4]));
  logic or_1274;
  assign or_1274 = (select_1141[7:6] == 2'h3) | (select_1141[8] & (select_1141[6] | select_1141[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1277;
  assign parity_1277 = ^{or_1274, or_1270, or_1266};
  // hls/stages/count_bits.hpp:25
  logic or_1281;
  assign or_1281 = (parity_1163 & parity_1166) | ((^select_1141[2:0]) & (parity_1163 | parity_1166));
  logic or_1285;
  assign or_1285 = (parity_1179 & parity_1182) | ((^select_1173[8:6]) & (parity_1179 | parity_1182));
  logic or_1289;
  assign or_1289 = (parity_1191 & parity_1194) | ((^select_1160[5:3]) & (parity_1191 | parity_1194));
  // hls/stages/count_bits.hpp:24
  logic parity_1292;
  assign parity_1292 = ^{or_1289, or_1285, or_1281};
  logic parity_1295;
  assign parity_1295 = ^{or_1289, or_1285, or_1281, or_1274, or_1270, or_1266, or_1259, or_1255, and_1251};
  logic xor_1296;
  assign xor_1296 = parity_1250 ^ parity_1295;
  // hls/stages/count_bits.hpp:25
  logic and_1297;
  assign and_1297 = parity_1250 & parity_1295;
  logic or_1301;
  assign or_1301 = (parity_1232 & parity_1247) | ((^{or_1213, or_1209, or_1205}) & (parity_1232 | parity_1247));
  logic or_1305;
  assign or_1305 = (parity_1277 & parity_1292) | ((^{or_1259, or_1255, and_1251}) & (parity_1277 | parity_1292));
  logic or_1312;
  assign or_1312 = (or_1209 & or_1213) | (or_1205 & (or_1209 | or_1213));
  logic or_1316;
  assign or_1316 = (or_1225 & or_1229) | (or_1221 & (or_1225 | or_1229));
  logic or_1320;
  assign or_1320 = (or_1240 & or_1244) | (or_1236 & (or_1240 | or_1244));
  // hls/stages/count_bits.hpp:24
  logic parity_1323;
  assign parity_1323 = ^{or_1320, or_1316, or_1312};
  // hls/stages/count_bits.hpp:25
  logic or_1327;
  assign or_1327 = (or_1255 & or_1259) | (and_1251 & (or_1255 | or_1259));
  logic or_1331;
  assign or_1331 = (or_1270 & or_1274) | (or_1266 & (or_1270 | or_1274));
  logic or_1335;
  assign or_1335 = (or_1285 & or_1289) | (or_1281 & (or_1285 | or_1289));
  // hls/stages/count_bits.hpp:24
  logic parity_1338;
  assign parity_1338 = ^{or_1335, or_1331, or_1327};
  logic parity_1341;
  assign parity_1341 = ^{or_1335, or_1331, or_1327, or_1320, or_1316, or_1312, or_1305, or_1301, and_1297};
  // hls/stages/count_bits.hpp:25
  logic or_1345;
  assign or_1345 = (parity_1323 & parity_1338) | ((^{or_1305, or_1301, and_1297}) & (parity_1323 | parity_1338));
  logic or_1349;
  assign or_1349 = (or_1301 & or_1305) | (and_1297 & (or_1301 | or_1305));
  logic or_1353;
  assign or_1353 = (or_1316 & or_1320) | (or_1312 & (or_1316 | or_1320));
  logic or_1357;
  assign or_1357 = (or_1331 & or_1335) | (or_1327 & (or_1331 | or_1335));
  // hls/stages/count_bits.hpp:24
  logic parity_1362;
  assign parity_1362 = ^{or_1357, or_1353, or_1349, or_1345};
  // hls/stages/count_bits.hpp:25
  logic or_1366;
  assign or_1366 = (or_1353 & or_1357) | (or_1349 & (or_1353 | or_1357));
  logic and_1367;
  assign and_1367 = or_1345 & (^{or_1357, or_1353, or_1349});
  // hls/stages/count_bits.hpp:24
  logic xor_1368;
  assign xor_1368 = or_1366 ^ and_1367;
  // hls/stages/count_bits.hpp:27
  logic and_1369;
  assign and_1369 = or_1366 & and_1367;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1370;
  assign select_1370 = equal_514_s1_q ? {and_1369, xor_1368, parity_1362, parity_1341, xor_1296, xor_1201} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_512_s1_q ? 6'h0 : select_1370;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1372;
  assign select_1372 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1373;
  assign difference_1373 = {1'b0, column_4} - {1'b0, select_1372};
  logic [7:0] sum_1375;
  assign sum_1375 = {difference_1373[6], difference_1373} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1383;
  assign select_1383 = and_646 ? (and_687 ? (~(select_688 ^ select_649)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1389;
  assign parity_1389 = ^select_1383[5:3];
  logic parity_1392;
  assign parity_1392 = ^select_1383[8:6];
  logic parity_1395;
  assign parity_1395 = ^select_1383[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1402;
  assign select_1402 = and_669 ? (and_928 ? (~(select_929 ^ select_672)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1405;
  assign parity_1405 = ^select_1402[8:6];
  logic parity_1408;
  assign parity_1408 = ^select_1402[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] xor_1414;
  assign xor_1414 = (less_519_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_689;
  logic [11:0] select_1417;
  assign select_1417 = and_686 ? ((right_codes_rdata_q[90] & not_520_s1_q) ? (~xor_1414) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1423;
  assign parity_1423 = ^select_1417[2:0];
  logic parity_1426;
  assign parity_1426 = ^select_1417[5:3];
  logic parity_1429;
  assign parity_1429 = ^select_1417[8:0];
  logic parity_1435;
  assign parity_1435 = ^select_1417[11:9];
  logic parity_1438;
  assign parity_1438 = ^select_1402[2:0];
  logic parity_1441;
  assign parity_1441 = ^{select_1417[11:9], select_1402[5:0]};
  logic parity_1444;
  assign parity_1444 = ^{select_1417, select_1402, select_1383[2:0]};
  logic xor_1445;
  assign xor_1445 = parity_1395 ^ parity_1444;
  // hls/stages/count_bits.hpp:23
  logic or_1449;
  assign or_1449 = (select_1383[1:0] == 2'h3) | (select_1383[2] & (select_1383[0] | select_1383[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1453;
  assign or_1453 = (select_1402[7:6] == 2'h3) | (select_1402[8] & (select_1402[6] | select_1402[7]));
  logic or_1457;
  assign or_1457 = (select_1402[10:9] == 2'h3) | (select_1402[11] & (select_1402[9] | select_1402[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1465;
  assign or_1465 = (select_1417[7:6] == 2'h3) | (select_1417[8] & (~(select_1417[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1469;
  assign or_1469 = (select_1417[1:0] == 2'h3) | (select_1417[2] & (select_1417[0] | select_1417[1]));
  logic or_1473;
  assign or_1473 = (select_1417[4:3] == 2'h3) | (select_1417[5] & (select_1417[3] | select_1417[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1476;
  assign parity_1476 = ^{or_1473, or_1469, or_1465};
  // hls/stages/count_bits.hpp:23
  logic or_1480;
  assign or_1480 = (select_1402[4:3] == 2'h3) | (select_1402[5] & (select_1402[3] | select_1402[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1484;
  assign or_1484 = (select_1417[10:9] == 2'h3) | (select_1417[11] & (select_1417[9] | select_1417[10]));
  logic or_1488;
  assign or_1488 = (select_1402[1:0] == 2'h3) | (select_1402[2] & (select_1402[0] | select_1402[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1491;
  assign parity_1491 = ^{or_1488, or_1484, or_1480};
  logic parity_1494;
  assign parity_1494 = ^{or_1488, or_1484, or_1480, or_1473, or_1469, or_1465, or_1457, or_1453, or_1449};
  // hls/stages/count_bits.hpp:25
  logic and_1495;
  assign and_1495 = parity_1395 & parity_1444;
  logic or_1499;
  assign or_1499 = (parity_1389 & parity_1392) | ((^select_1383[11:9]) & (parity_1389 | parity_1392));
  logic and_1502;
  assign and_1502 = (^{select_1402[11:6], select_1383[2:0]}) & (parity_1429 | parity_1441);
  logic or_1503;
  assign or_1503 = (parity_1429 & parity_1441) | and_1502;
  // hls/stages/count_bits.hpp:23
  logic or_1510;
  assign or_1510 = (select_1383[10:9] == 2'h3) | (select_1383[11] & (select_1383[9] | select_1383[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1514;
  assign or_1514 = (select_1383[4:3] == 2'h3) | (select_1383[5] & (select_1383[3] | select_1383[4]));
  logic or_1518;
  assign or_1518 = (select_1383[7:6] == 2'h3) | (select_1383[8] & (select_1383[6] | select_1383[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1521;
  assign parity_1521 = ^{or_1518, or_1514, or_1510};
  // hls/stages/count_bits.hpp:25
  logic or_1525;
  assign or_1525 = (parity_1405 & parity_1408) | ((^select_1383[2:0]) & (parity_1405 | parity_1408));
  logic or_1529;
  assign or_1529 = (parity_1423 & parity_1426) | ((^select_1417[8:6]) & (parity_1423 | parity_1426));
  logic or_1533;
  assign or_1533 = (parity_1435 & parity_1438) | ((^select_1402[5:3]) & (parity_1435 | parity_1438));
  // hls/stages/count_bits.hpp:24
  logic parity_1536;
  assign parity_1536 = ^{or_1533, or_1529, or_1525};
  logic parity_1539;
  assign parity_1539 = ^{or_1533, or_1529, or_1525, or_1518, or_1514, or_1510, or_1503, or_1499, and_1495};
  logic xor_1540;
  assign xor_1540 = parity_1494 ^ parity_1539;
  // hls/stages/count_bits.hpp:25
  logic and_1541;
  assign and_1541 = parity_1494 & parity_1539;
  logic or_1545;
  assign or_1545 = (parity_1476 & parity_1491) | ((^{or_1457, or_1453, or_1449}) & (parity_1476 | parity_1491));
  logic or_1549;
  assign or_1549 = (parity_1521 & parity_1536) | ((^{or_1503, or_1499, and_1495}) & (parity_1521 | parity_1536));
  logic or_1556;
  assign or_1556 = (or_1453 & or_1457) | (or_1449 & (or_1453 | or_1457));
  logic or_1560;
  assign or_1560 = (or_1469 & or_1473) | (or_1465 & (or_1469 | or_1473));
  logic or_1564;
  assign or_1564 = (or_1484 & or_1488) | (or_1480 & (or_1484 | or_1488));
  // hls/stages/count_bits.hpp:24
  logic parity_1567;
  assign parity_1567 = ^{or_1564, or_1560, or_1556};
  // hls/stages/count_bits.hpp:25
  logic or_1571;
  assign or_1571 = (or_1499 & or_1503) | (and_1495 & (or_1499 | or_1503));
  logic or_1575;
  assign or_1575 = (or_1514 & or_1518) | (or_1510 & (or_1514 | or_1518));
  logic or_1579;
  assign or_1579 = (or_1529 & or_1533) | (or_1525 & (or_1529 | or_1533));
  // hls/stages/count_bits.hpp:24
  logic parity_1582;
  assign parity_1582 = ^{or_1579, or_1575, or_1571};
  logic parity_1585;
  assign parity_1585 = ^{or_1579, or_1575, or_1571, or_1564, or_1560, or_1556, or_1549, or_1545, and_1541};
  // hls/stages/count_bits.hpp:25
  logic or_1589;
  assign or_1589 = (parity_1567 & parity_1582) | ((^{or_1549, or_1545, and_1541}) & (parity_1567 | parity_1582));
  logic or_1593;
  assign or_1593 = (or_1545 & or_1549) | (and_1541 & (or_1545 | or_1549));
  logic or_1597;
  assign or_1597 = (or_1560 & or_1564) | (or_1556 & (or_1560 | or_1564));
  logic or_1601;
  assign or_1601 = (or_1575 & or_1579) | (or_1571 & (or_1575 | or_1579));
  // hls/stages/count_bits.hpp:24
  logic parity_1606;
  assign parity_1606 = ^{or_1601, or_1597, or_1593, or_1589};
  // hls/stages/count_bits.hpp:25
  logic or_1610;
  assign or_1610 = (or_1597 & or_1601) | (or_1593 & (or_1597 | or_1601));
  logic and_1611;
  assign and_1611 = or_1589 & (^{or_1601, or_1597, or_1593});
  // hls/stages/count_bits.hpp:24
  logic xor_1612;
  assign xor_1612 = or_1610 ^ and_1611;
  // hls/stages/count_bits.hpp:27
  logic and_1613;
  assign and_1613 = or_1610 & and_1611;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1614;
  assign select_1614 = equal_514_s1_q ? {and_1613, xor_1612, parity_1606, parity_1585, xor_1540, xor_1445} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_512_s1_q ? 6'h0 : select_1614;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1616;
  assign select_1616 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1617;
  assign difference_1617 = {1'b0, column_5} - {1'b0, select_1616};
  logic [7:0] sum_1619;
  assign sum_1619 = {difference_1617[6], difference_1617} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:669
  logic [11:0] not_1623;
  assign not_1623 = ~((less_519_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_649);
  logic [11:0] select_1625;
  assign select_1625 = and_646 ? ((right_codes_rdata_q[12] & not_520_s1_q) ? not_1623 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1631;
  assign parity_1631 = ^select_1625[5:3];
  logic parity_1634;
  assign parity_1634 = ^select_1625[8:6];
  logic parity_1637;
  assign parity_1637 = ^select_1625[11:3];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1644;
  assign select_1644 = and_669 ? (and_1136 ? (~(select_1137 ^ select_672)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1647;
  assign parity_1647 = ^select_1644[8:6];
  logic parity_1650;
  assign parity_1650 = ^select_1644[11:9];
  // hls/stages/agreement.hpp:669
  logic [11:0] select_1657;
  assign select_1657 = and_686 ? (and_647 ? (~(select_648 ^ select_689)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1663;
  assign parity_1663 = ^select_1657[2:0];
  logic parity_1666;
  assign parity_1666 = ^select_1657[5:3];
  logic parity_1669;
  assign parity_1669 = ^select_1657[8:0];
  logic parity_1675;
  assign parity_1675 = ^select_1657[11:9];
  logic parity_1678;
  assign parity_1678 = ^select_1644[2:0];
  logic parity_1681;
  assign parity_1681 = ^{select_1657[11:9], select_1644[5:0]};
  logic parity_1684;
  assign parity_1684 = ^{select_1657, select_1644, select_1625[2:0]};
  logic xor_1685;
  assign xor_1685 = parity_1637 ^ parity_1684;
  // hls/stages/count_bits.hpp:23
  logic or_1689;
  assign or_1689 = (select_1625[1:0] == 2'h3) | (select_1625[2] & (select_1625[0] | select_1625[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1693;
  assign or_1693 = (select_1644[7:6] == 2'h3) | (select_1644[8] & (select_1644[6] | select_1644[7]));
  logic or_1697;
  assign or_1697 = (select_1644[10:9] == 2'h3) | (select_1644[11] & (select_1644[9] | select_1644[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1705;
  assign or_1705 = (select_1657[7:6] == 2'h3) | (select_1657[8] & (~(select_1657[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1709;
  assign or_1709 = (select_1657[1:0] == 2'h3) | (select_1657[2] & (select_1657[0] | select_1657[1]));
  logic or_1713;
  assign or_1713 = (select_1657[4:3] == 2'h3) | (select_1657[5] & (select_1657[3] | select_1657[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1716;
  assign parity_1716 = ^{or_1713, or_1709, or_1705};
  // hls/stages/count_bits.hpp:23
  logic or_1720;
  assign or_1720 = (select_1644[4:3] == 2'h3) | (select_1644[5] & (select_1644[3] | select_1644[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1724;
  assign or_1724 = (select_1657[10:9] == 2'h3) | (select_1657[11] & (select_1657[9] | select_1657[10]));
  logic or_1728;
  assign or_1728 = (select_1644[1:0] == 2'h3) | (select_1644[2] & (select_1644[0] | select_1644[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1731;
  assign parity_1731 = ^{or_1728, or_1724, or_1720};
  logic parity_1734;
  assign parity_1734 = ^{or_1728, or_1724, or_1720, or_1713, or_1709, or_1705, or_1697, or_1693, or_1689};
  // hls/stages/count_bits.hpp:25
  logic and_1735;
  assign and_1735 = parity_1637 & parity_1684;
  logic or_1739;
  assign or_1739 = (parity_1631 & parity_1634) | ((^select_1625[11:9]) & (parity_1631 | parity_1634));
  logic and_1742;
  assign and_1742 = (^{select_1644[11:6], select_1625[2:0]}) & (parity_1669 | parity_1681);
  logic or_1743;
  assign or_1743 = (parity_1669 & parity_1681) | and_1742;
  // hls/stages/count_bits.hpp:23
  logic or_1750;
  assign or_1750 = (select_1625[10:9] == 2'h3) | (select_1625[11] & (select_1625[9] | select_1625[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1754;
  assign or_1754 = (select_1625[4:3] == 2'h3) | (select_1625[5] & (select_1625[3] | select_1625[4]));
  logic or_1758;
  assign or_1758 = (select_1625[7:6] == 2'h3) | (select_1625[8] & (select_1625[6] | select_1625[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1761;
  assign parity_1761 = ^{or_1758, or_1754, or_1750};
  // hls/stages/count_bits.hpp:25
  logic or_1765;
  assign or_1765 = (parity_1647 & parity_1650) | ((^select_1625[2:0]) & (parity_1647 | parity_1650));
  logic or_1769;
  assign or_1769 = (parity_1663 & parity_1666) | ((^select_1657[8:6]) & (parity_1663 | parity_1666));
  logic or_1773;
  assign or_1773 = (parity_1675 & parity_1678) | ((^select_1644[5:3]) & (parity_1675 | parity_1678));
  // hls/stages/count_bits.hpp:24
  logic parity_1776;
  assign parity_1776 = ^{or_1773, or_1769, or_1765};
  logic parity_1779;
  assign parity_1779 = ^{or_1773, or_1769, or_1765, or_1758, or_1754, or_1750, or_1743, or_1739, and_1735};
  logic xor_1780;
  assign xor_1780 = parity_1734 ^ parity_1779;
  // hls/stages/count_bits.hpp:25
  logic and_1781;
  assign and_1781 = parity_1734 & parity_1779;
  logic or_1785;
  assign or_1785 = (parity_1716 & parity_1731) | ((^{or_1697, or_1693, or_1689}) & (parity_1716 | parity_1731));
  logic or_1789;
  assign or_1789 = (parity_1761 & parity_1776) | ((^{or_1743, or_1739, and_1735}) & (parity_1761 | parity_1776));
  logic or_1796;
  assign or_1796 = (or_1693 & or_1697) | (or_1689 & (or_1693 | or_1697));
  logic or_1800;
  assign or_1800 = (or_1709 & or_1713) | (or_1705 & (or_1709 | or_1713));
  logic or_1804;
  assign or_1804 = (or_1724 & or_1728) | (or_1720 & (or_1724 | or_1728));
  // hls/stages/count_bits.hpp:24
  logic parity_1807;
  assign parity_1807 = ^{or_1804, or_1800, or_1796};
  // hls/stages/count_bits.hpp:25
  logic or_1811;
  assign or_1811 = (or_1739 & or_1743) | (and_1735 & (or_1739 | or_1743));
  logic or_1815;
  assign or_1815 = (or_1754 & or_1758) | (or_1750 & (or_1754 | or_1758));
  logic or_1819;
  assign or_1819 = (or_1769 & or_1773) | (or_1765 & (or_1769 | or_1773));
  // hls/stages/count_bits.hpp:24
  logic parity_1822;
  assign parity_1822 = ^{or_1819, or_1815, or_1811};
  logic parity_1825;
  assign parity_1825 = ^{or_1819, or_1815, or_1811, or_1804, or_1800, or_1796, or_1789, or_1785, and_1781};
  // hls/stages/count_bits.hpp:25
  logic or_1829;
  assign or_1829 = (parity_1807 & parity_1822) | ((^{or_1789, or_1785, and_1781}) & (parity_1807 | parity_1822));
  logic or_1833;
  assign or_1833 = (or_1785 & or_1789) | (and_1781 & (or_1785 | or_1789));
  logic or_1837;
  assign or_1837 = (or_1800 & or_1804) | (or_1796 & (or_1800 | or_1804));
  logic or_1841;
  assign or_1841 = (or_1815 & or_1819) | (or_1811 & (or_1815 | or_1819));
  // hls/stages/count_bits.hpp:24
  logic parity_1846;
  assign parity_1846 = ^{or_1841, or_1837, or_1833, or_1829};
  // hls/stages/count_bits.hpp:25
  logic or_1850;
  assign or_1850 = (or_1837 & or_1841) | (or_1833 & (or_1837 | or_1841));
  logic and_1851;
  assign and_1851 = or_1829 & (^{or_1841, or_1837, or_1833});
  // hls/stages/count_bits.hpp:24
  logic xor_1852;
  assign xor_1852 = or_1850 ^ and_1851;
  // hls/stages/count_bits.hpp:27
  logic and_1853;
  assign and_1853 = or_1850 & and_1851;
  // hls/stages/agreement.hpp:141
  logic [5:0] select_1854;
  assign select_1854 = equal_514_s1_q ? {and_1853, xor_1852, parity_1846, parity_1825, xor_1780, xor_1685} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_512_s1_q ? 6'h0 : select_1854;
  // hls/stages/agreement.hpp:762
  logic [5:0] select_1856;
  assign select_1856 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1857;
  assign difference_1857 = {1'b0, column_6} - {1'b0, select_1856};
  logic [7:0] sum_1859;
  assign sum_1859 = {difference_1857[6], difference_1857} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:927
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:928
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:929
  logic [6:0] select_1919;
  assign select_1919 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:932
  logic and_1939;
  assign and_1939 = (or_512_s1_q & (left_rdata_q[61] & not_520_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:235
  logic or_1961;
  assign or_1961 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/patches.hpp:313
  logic [6:0] select_1972;
  assign select_1972 = so_s1_q ? x_s1_q[6:0] : (or_512_s1_q ? (less_519_s1_q ? 7'h0 : select_1919) : 7'h0);
  // hls/stages/patches.hpp:99
  logic and_2046;
  assign and_2046 = (select_455_s1_q == 3'h0) & (select_457_s1_q == 7'h0);
  // hls/stages/patches.hpp:365
  logic not_2047;
  assign not_2047 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_2050;
  assign not_2050 = ~sample_pair_first_s1_q;
  // hls/stages/patches.hpp:335
  logic and_2051;
  assign and_2051 = patches_capturing_q & not_2050;
  // hls/stages/patches.hpp:285
  logic equal_2054;
  assign equal_2054 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:102
  logic and_2059;
  assign and_2059 = (not_2047 & (patches_work_q == 3'h0)) & (~(and_2051 | ((~equal_2052_s1_q) | (~equal_2054))));
  // hls/stages/patches.hpp:473
  logic equal_2146;
  assign equal_2146 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:454
  logic not_2147;
  assign not_2147 = ~equal_2146;
  // hls/stages/patches.hpp:473
  logic equal_2148;
  assign equal_2148 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:420
  logic not_2149;
  assign not_2149 = ~equal_2148;
  // hls/stages/patches.hpp:143
  logic equal_2150;
  assign equal_2150 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:473
  logic equal_2151;
  assign equal_2151 = patches_work_q == 3'h2;
  logic or_2152;
  assign or_2152 = equal_2150 | equal_2151;
  // hls/stages/patches.hpp:422
  logic not_2153;
  assign not_2153 = ~patches_second_q;
  // hls/stages/patches.hpp:346
  logic [4:0] select_2175;
  assign select_2175 = and_2059 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:103
  logic [4:0] select_2176;
  assign select_2176 = and_2046 ? select_2175 : patches_row_q;
  // hls/stages/patches.hpp:102
  logic and_2178;
  assign and_2178 = and_2051 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:103
  logic select_2182;
  assign select_2182 = and_2046 ? (and_2059 | (and_2051 & (~and_2178))) : patches_capturing_q;
  // hls/stages/patches.hpp:160
  logic and_2190;
  assign and_2190 = not_2147 & (not_2149 & (or_2152 & (patches_second_q & equal_2150)));
  // hls/stages/patches.hpp:143
  logic not_2207;
  assign not_2207 = ~equal_2150;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_2223;
  assign select_2223 = and_2046 ? {select_2175[4], select_2175[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:420
  logic and_2233;
  assign and_2233 = not_2147 & (or_2152 & not_2149);
  // hls/stages/agreement.hpp:443
  logic [5:0] or_2596;
  assign or_2596 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:447
  logic select_2815;
  assign select_2815 = equal_2721_s1_q ? (~({row_s1_q, 1'b0} < {sum_2812, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:507
  logic and_3004;
  assign and_3004 = and_491_s1_q & (equal_2721_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/patches.hpp:291
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:103
  logic [3:0] select_3114;
  assign select_3114 = and_2046 ? (sample_pair_first_s1_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3115;
  assign select_3115 = sample_pair_whole_s1_q ? select_3114 : patches_phase_q;
  // hls/stages/patches.hpp:346
  logic and_3116;
  assign and_3116 = not_2050 & equal_2052_s1_q;
  logic [8:0] select_3117;
  assign select_3117 = and_3116 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3118;
  assign select_3118 = and_3116 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3119;
  assign select_3119 = sample_pair_first_s1_q ? select_3117 : select_3118;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3121;
  assign select_3121 = sample_pair_whole_s1_q ? (and_2046 ? select_3119[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3123;
  assign select_3123 = sample_pair_whole_s1_q ? (and_2046 ? select_3119[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3126;
  assign select_3126 = sample_pair_whole_s1_q ? (equal_2054 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3128;
  assign select_3128 = sample_pair_whole_s1_q ? (patches_band_rows_number_q + {4'h0, equal_2054}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:304
  logic equal_3129;
  assign equal_3129 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:305
  logic not_3130;
  assign not_3130 = ~equal_3129;
  // hls/stages/agreement.hpp:263
  logic [3:0] select_3132;
  assign select_3132 = sample_pair_whole_s1_q ? (phase + {not_3130, 1'b1, not_3130, equal_3129}) : patches_first_band_rows_to_next_q;
  logic select_3133;
  assign select_3133 = sample_pair_whole_s1_q ? equal_3129 : patches_first_band_number_q;
  // hls/stages/agreement.hpp:457
  logic equal_3134;
  assign equal_3134 = row_s1_q == 6'h3;
  // hls/stages/patches.hpp:64
  logic [3:0] select_3138;
  assign select_3138 = equal_3134 ? ((select_3115 == 4'h6) ? 4'h0 : (select_3115 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3139;
  assign equal_3139 = select_3138 == 4'h0;
  // hls/stages/agreement.hpp:447
  logic [3:0] select_3142;
  assign select_3142 = equal_2721_s1_q ? (equal_3139 ? 4'h6 : (select_3138 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:64
  logic [4:0] select_3144;
  assign select_3144 = equal_3134 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:447
  logic [4:0] select_3146;
  assign select_3146 = equal_2721_s1_q ? (select_3144 + {4'h0, equal_3139}) : patches_choosing_number_q;
  logic select_3150;
  assign select_3150 = equal_2721_s1_q ? ((6'h2 < row_s1_q) & equal_3139) : patches_chooses_q;
  // hls/stages/agreement.hpp:507
  logic [4:0] select_3153;
  assign select_3153 = and_491_s1_q ? (equal_2721_s1_q ? select_3144 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:103
  logic select_3182;
  assign select_3182 = and_2046 ? (and_2059 ? not_3180_s1_q : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:366
  logic or_3221;
  assign or_3221 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:368
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:163
  logic and_3227;
  assign and_3227 = equal_2146 & not_2153;
  // hls/stages/patches.hpp:372
  logic and_3228;
  assign and_3228 = not_2207 & and_3227;
  logic [1:0] select_3230;
  assign select_3230 = equal_2148 ? 2'h0 : (equal_2151 ? 2'h3 : {equal_2150, and_3228});
  // hls/stages/patches.hpp:253
  logic equal_3232;
  assign equal_3232 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:251
  logic not_3233;
  assign not_3233 = ~equal_3232;
  // hls/stages/patches.hpp:253
  logic equal_3234;
  assign equal_3234 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:249
  logic not_3235;
  assign not_3235 = ~equal_3234;
  // hls/stages/patches.hpp:257
  logic not_3237;
  assign not_3237 = ~(patches_following_q == 3'h2);
  logic and_3240;
  assign and_3240 = (~(patches_following_q == 3'h1)) & not_3237;
  // hls/stages/patches.hpp:370
  logic [1:0] select_3241;
  assign select_3241 = equal_3234 ? 2'h2 : {and_3240, not_3237};
  logic [3:0] select_3242;
  assign select_3242 = equal_3232 ? 4'h2 : {select_3241, {2{not_3235}}};
  // hls/stages/patches.hpp:378
  logic not_3245;
  assign not_3245 = ~or_3221;
  // hls/stages/patches.hpp:367
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:379
  logic [11:0] select_3250;
  assign select_3250 = or_3221 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:163
  logic [4:0] select_3252;
  assign select_3252 = or_3221 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1297; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_512_s1_q ? select_1919 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_633_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:697; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s1_en & (not_2147 & (not_2149 & (or_2152 & (equal_2150 & not_2153))));
  logic [8:0] patches_right_0_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_word_q <= patches_right_0_mem[patches_right_0_raddr];
  end
  logic [7:0] patches_right_0_rdata_q;
  assign patches_right_0_rdata_q = patches_right_0_word_q[7:0];
  logic patches_right_0_read_q, patches_right_0_error;
  always_ff @(posedge clk_i) patches_right_0_read_q <= rst_ni & patches_right_0_re;
  assign patches_right_0_error = patches_right_0_read_q & ^patches_right_0_word_q;

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:697; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s1_en & and_2190;
  logic [8:0] patches_right_1_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_word_q <= patches_right_1_mem[patches_right_1_raddr];
  end
  logic [7:0] patches_right_1_rdata_q;
  assign patches_right_1_rdata_q = patches_right_1_word_q[7:0];
  logic patches_right_1_read_q, patches_right_1_error;
  always_ff @(posedge clk_i) patches_right_1_read_q <= rst_ni & patches_right_1_re;
  assign patches_right_1_error = patches_right_1_read_q & ^patches_right_1_word_q;

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:698; read in stage 1, written in stage 4: 1 < 4 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s1_en & (not_2147 & (not_2149 & (not_2207 & or_2152)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:709; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 33'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s1_en & and_2233;
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
  assign left_we = s1_en & and_523_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_615, left_rdata_q[59:45], and_614, left_rdata_q[43:29], and_613, left_rdata_q[27:13], and_612, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_523_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_624, right_codes_rdata_q[76:65], and_623, right_codes_rdata_q[63:52], and_622, right_codes_rdata_q[50:39], and_621, right_codes_rdata_q[37:26], and_620, right_codes_rdata_q[24:13], and_619, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      row_q <= and_491_s1_q ? (equal_2721_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_491_s1_q ? select_2815 : lower_half_q;
      patches_phase_q <= select_3115;
      patches_band_rows_rows_to_next_q <= select_3121;
      patches_band_rows_number_q <= select_3123;
      patches_next_band_rows_to_next_q <= select_3126;
      patches_next_band_number_q <= select_3128;
      patches_first_band_rows_to_next_q <= select_3132;
      patches_first_band_number_q <= select_3133;
      patches_choosing_rows_to_next_q <= and_491_s1_q ? select_3142 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_491_s1_q ? select_3146 : patches_choosing_number_q;
      patches_chooses_q <= and_491_s1_q ? select_3150 : patches_chooses_q;
      patches_choosing_band_q <= select_3153;
      patches_capturing_q <= sample_pair_whole_s1_q ? select_2182 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_s1_q ? select_3182 : patches_lower_q;
      patches_row_q <= sample_pair_whole_s1_q ? select_2176 : patches_row_q;
      patches_work_q <= or_3221 ? following : patches_work_q;
      patches_second_q <= not_2047 & (patches_second_q | (patches_ends_q & equal_2146));
      patches_following_q <= equal_2146 ? {2'h0, and_3227} : {equal_2148, select_3230};
      patches_following_beats_q <= {select_3242, not_3233};
      patches_begins_q <= sample_pair_whole_s1_q & (and_2046 & and_2178);
      patches_ends_q <= not_3245 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3250;
      patches_code_row_q <= select_3252;
      patches_column_q <= or_3221 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3245 & (patches_column_q == 5'h1e);
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
      middle_sum_sum_sums_values_0_q <= sum_895;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1135;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1375;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1619;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1859;
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
  logic [2:0] select_455_s2_q;
  logic [6:0] select_457_s2_q;
  logic [8:0] select_461_s2_q;
  logic and_465_s2_q;
  logic equal_471_s2_q;
  logic [6:0] column_s2_q;
  logic and_489_s2_q;
  logic and_491_s2_q;
  logic so_s2_q;
  logic equal_511_s2_q;
  logic or_512_s2_q;
  logic less_519_s2_q;
  logic not_520_s2_q;
  logic equal_552_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_640_s2_q;
  logic and_1915_s2_q;
  logic [6:0] right_s2_q;
  logic select_1924_s2_q;
  logic equal_1933_s2_q;
  logic and_1940_s2_q;
  logic and_1943_s2_q;
  logic and_1947_s2_q;
  logic or_1961_s2_q;
  logic [6:0] select_1972_s2_q;
  logic and_2046_s2_q;
  logic and_2059_s2_q;
  logic less_2073_s2_q;
  logic equal_2146_s2_q;
  logic not_2147_s2_q;
  logic equal_2148_s2_q;
  logic not_2149_s2_q;
  logic equal_2150_s2_q;
  logic or_2152_s2_q;
  logic [4:0] select_2176_s2_q;
  logic select_2182_s2_q;
  logic [3:0] select_2223_s2_q;
  logic and_2233_s2_q;
  logic and_2451_s2_q;
  logic equal_2597_s2_q;
  logic equal_2721_s2_q;
  logic and_3005_s2_q;
  logic and_3007_s2_q;
  logic or_3221_s2_q;
  logic not_3245_s2_q;
  logic less_3991_s2_q;
  logic equal_4196_s2_q;
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
      select_455_s2_q <= select_455_s1_q;
      select_457_s2_q <= select_457_s1_q;
      select_461_s2_q <= select_461_s1_q;
      and_465_s2_q <= and_465_s1_q;
      equal_471_s2_q <= equal_471_s1_q;
      column_s2_q <= column_s1_q;
      and_489_s2_q <= and_489_s1_q;
      and_491_s2_q <= and_491_s1_q;
      so_s2_q <= so_s1_q;
      equal_511_s2_q <= equal_511_s1_q;
      or_512_s2_q <= or_512_s1_q;
      less_519_s2_q <= less_519_s1_q;
      not_520_s2_q <= not_520_s1_q;
      equal_552_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_640_s2_q <= select_640_s1_q;
      and_1915_s2_q <= and_1915_s1_q;
      right_s2_q <= right_s1_q;
      select_1924_s2_q <= select_1924_s1_q;
      equal_1933_s2_q <= equal_1933_s1_q;
      and_1940_s2_q <= not_520_s1_q & and_1939;
      and_1943_s2_q <= (or_512_s1_q & (left_rdata_q[62] & not_520_s1_q)) & and_1939;
      and_1947_s2_q <= not_520_s1_q & (or_512_s1_q & (left_rdata_q[63] & not_520_s1_q));
      or_1961_s2_q <= or_1961;
      select_1972_s2_q <= select_1972;
      and_2046_s2_q <= and_2046;
      and_2059_s2_q <= and_2059;
      less_2073_s2_q <= 5'h4 < row_q[5:1];
      equal_2146_s2_q <= equal_2146;
      not_2147_s2_q <= not_2147;
      equal_2148_s2_q <= equal_2148;
      not_2149_s2_q <= not_2149;
      equal_2150_s2_q <= equal_2150;
      or_2152_s2_q <= or_2152;
      select_2176_s2_q <= select_2176;
      select_2182_s2_q <= select_2182;
      select_2223_s2_q <= select_2223;
      and_2233_s2_q <= and_2233;
      and_2451_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2597_s2_q <= {column_s1_q[6], or_2596} == 7'h0;
      equal_2721_s2_q <= equal_2721_s1_q;
      and_3005_s2_q <= and_2722_s1_q & and_3004;
      and_3007_s2_q <= and_2722_s1_q & (~and_3004);
      or_3221_s2_q <= or_3221;
      not_3245_s2_q <= not_3245;
      less_3991_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4196_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic and_466;
  assign and_466 = sample_pair_whole_s2_q & and_465_s2_q;
  // hls/stages/agreement.hpp:772
  logic not_642;
  assign not_642 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_643;
  assign less_643 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:231
  logic and_645;
  assign and_645 = not_642 & (~less_643);
  // hls/stages/agreement.hpp:735
  logic less_1376;
  assign less_1376 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1377;
  assign select_1377 = less_1376 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1378;
  assign less_1378 = middle_sum_sum_sums_values_0_q < select_1377;
  logic [7:0] select_1379;
  assign select_1379 = less_1378 ? select_1377 : middle_sum_sum_sums_values_0_q;
  logic less_1860;
  assign less_1860 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1861;
  assign select_1861 = less_1860 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1862;
  assign less_1862 = select_1379 < select_1861;
  // hls/stages/agreement.hpp:776
  logic [7:0] of_best;
  assign of_best = and_645 ? (less_1862 ? select_1861 : select_1379) : 8'h0;
  // hls/stages/agreement.hpp:783
  logic or_1866;
  assign or_1866 = select_640_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1867;
  assign select_1867 = or_1866 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:736
  logic or_1869;
  assign or_1869 = less_1376 | (~less_1378);
  logic [2:0] select_1870;
  assign select_1870 = less_1862 ? {less_1860, 2'h0} : {1'b0, or_1869, less_1378};
  // hls/stages/agreement.hpp:788
  logic [2:0] select_1871;
  assign select_1871 = or_1866 ? select_1870 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1872;
  assign select_1872 = or_1866 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:785
  logic equal_1873;
  assign equal_1873 = select_1870 == 3'h1;
  logic equal_1874;
  assign equal_1874 = select_1870 == 3'h2;
  logic not_1875;
  assign not_1875 = ~equal_1874;
  logic [1:0] select_1876;
  assign select_1876 = equal_1873 ? 2'h0 : {not_1875, equal_1874};
  logic [7:0] select_1877;
  assign select_1877 = select_1876[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1878;
  assign select_1878 = select_1876[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1880;
  assign select_1880 = or_1866 ? (select_1876[1] ? select_1877 : select_1878) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:786
  logic [2:0] select_1881;
  assign select_1881 = equal_1873 ? 3'h2 : {not_1875, {2{equal_1874}}};
  logic [7:0] select_1882;
  assign select_1882 = select_1881[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1883;
  assign select_1883 = select_1881[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic [7:0] select_1885;
  assign select_1885 = select_1881[2] ? sums_3_sum_sums_values_0_q : (select_1881[1] ? select_1882 : select_1883);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1886;
  assign select_1886 = or_1866 ? select_1885 : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1888;
  assign sum_1888 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1889;
  assign sum_1889 = {1'b0, before_v} + sum_1888;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1891;
  assign sum_1891 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1892;
  assign sum_1892 = {1'b0, before_v_2} + sum_1891;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1894;
  assign sum_1894 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1895;
  assign sum_1895 = {1'b0, before_v_3} + sum_1894;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1897;
  assign select_1897 = (sum_1892 < sum_1895) ? sum_1895 : sum_1892;
  logic [6:0] select_1899;
  assign select_1899 = (sum_1889 < select_1897) ? select_1897 : sum_1889;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1901;
  assign sum_1901 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1902;
  assign sum_1902 = {1'b0, before_v_4} + sum_1901;
  // hls/stages/agreement.hpp:763
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:764
  logic [6:0] sum_1904;
  assign sum_1904 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1905;
  assign sum_1905 = {1'b0, before_v_5} + sum_1904;
  // hls/stages/agreement.hpp:735
  logic [6:0] select_1907;
  assign select_1907 = (sum_1902 < sum_1905) ? sum_1905 : sum_1902;
  // hls/stages/agreement.hpp:777
  logic [6:0] of_near;
  assign of_near = and_645 ? ((select_1899 < select_1907) ? select_1907 : select_1899) : 7'h0;
  // hls/stages/agreement.hpp:788
  logic or_1912;
  assign or_1912 = select_640_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:792
  logic [6:0] select_1913;
  assign select_1913 = or_1912 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1914;
  assign select_1914 = or_1912 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:797
  logic or_1926;
  assign or_1926 = select_1924_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:801
  logic [7:0] select_1927;
  assign select_1927 = or_1926 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1928;
  assign select_1928 = or_1926 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1930;
  assign or_1930 = select_1924_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:805
  logic [6:0] select_1931;
  assign select_1931 = or_1930 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1932;
  assign select_1932 = or_1930 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:955
  logic not_1934;
  assign not_1934 = ~equal_1933_s2_q;
  // hls/stages/agreement.hpp:235
  logic and_1944;
  assign and_1944 = not_520_s2_q & and_1943_s2_q;
  // hls/stages/agreement.hpp:935
  logic select_1950;
  assign select_1950 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:936
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:942
  logic [8:0] difference_1953;
  assign difference_1953 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:943
  logic [9:0] sum_1954;
  assign sum_1954 = {difference_1953[8], difference_1953} + 10'h1;
  // hls/stages/agreement.hpp:235
  logic and_1956;
  assign and_1956 = (and_1943_s2_q & select_1950) & ({{22{sum_1954[9]}}, sum_1954} < 32'h3);
  logic and_1957;
  assign and_1957 = not_520_s2_q & and_1956;
  logic and_1963;
  assign and_1963 = not_520_s2_q & (and_1956 & or_1961_s2_q);
  // hls/stages/agreement.hpp:141
  logic [8:0] select_1964;
  assign select_1964 = less_519_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] shift_2;
  assign shift_2 = or_512_s2_q ? {select_1964, and_1963, and_1957, and_1947_s2_q, and_1944, and_1940_s2_q, not_520_s2_q} : 15'h0;
  // hls/stages/patches.hpp:313
  logic and_1966;
  assign and_1966 = ends_cell_s2_q & shift_2[0];
  logic and_1968;
  assign and_1968 = not_1934 & (so_s2_q & and_1966);
  // hls/stages/agreement.hpp:955
  logic [5:0] sum_2018;
  assign sum_2018 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:250
  logic right_2;
  assign right_2 = shift_2[0] & ({1'b0, sum_2018, last_s2_q[1]} < x_s2_q);
  // hls/stages/patches.hpp:80
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/registration.hpp:218
  logic [16:0] select_2076;
  assign select_2076 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2076[16:7])) ? 8'h7f : select_2076[7:0];
  // hls/stages/patches.hpp:81
  logic and_2099;
  assign and_2099 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:83
  logic equal_2100;
  assign equal_2100 = x_s2_q == 8'h0;
  // hls/stages/patches.hpp:79
  logic [9:0] sum_2106;
  assign sum_2106 = {2'h0, x_s2_q} + {{4{shift_2[11]}}, shift_2[11:6]};
  // hls/stages/patches.hpp:83
  logic [9:0] sum_2108;
  assign sum_2108 = {sum_2106[9], sum_2106[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:964
  logic and_2111;
  assign and_2111 = ($signed(9'h0) < $signed(sum_2106[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2108, sum_2106[0]})));
  logic and_2112;
  assign and_2112 = (~(and_2099 | (equal_2100 | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2111;
  // hls/stages/patches.hpp:90
  logic equal_2139;
  assign equal_2139 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/patches.hpp:313
  logic and_2143;
  assign and_2143 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (and_2099 | equal_2139)));
  logic and_2144;
  assign and_2144 = not_1934 & and_2143;
  // hls/stages/patches.hpp:148
  logic [7:0] pixel;
  assign pixel = equal_2150_s2_q ? (patches_second_s2_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2150_s2_q ? (patches_second_s2_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:454
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  // hls/stages/patches.hpp:160
  logic and_2242;
  assign and_2242 = not_2147_s2_q & (equal_2148_s2_q & new_row);
  // hls/stages/patches.hpp:431
  logic [8:0] sum_2245;
  assign sum_2245 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2246;
  assign sum_2246 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2245, pixel_2[0]} - {1'b0, sum_2246, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:433
  logic [11:0] sum_2248;
  assign sum_2248 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2249;
  assign sum_2249 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2248[11], sum_2248};
  logic [13:0] sum_2250;
  assign sum_2250 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2249, down_2[1]};
  logic [12:0] sum_2251;
  assign sum_2251 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2250[13:1];
  logic [14:0] sum_2252;
  assign sum_2252 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2251, sum_2250[0], down_2[0]};
  // hls/stages/patches.hpp:429
  logic [8:0] sum_2255;
  assign sum_2255 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2256;
  assign sum_2256 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2255};
  logic [10:0] sum_2257;
  assign sum_2257 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2256, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2258;
  assign sum_2258 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2257[10:1];
  // hls/stages/patches.hpp:430
  logic [11:0] smooth;
  assign smooth = {sum_2258, sum_2257[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:432
  logic [12:0] sum_2260;
  assign sum_2260 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2261;
  assign sum_2261 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2262;
  assign difference_2262 = {1'b0, sum_2260, smooth[0]} - {1'b0, sum_2261, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:148
  logic and_2269;
  assign and_2269 = (~(patches_code_row_s2_q[4:2] == 3'h0)) & (~(patches_column_s2_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:160
  logic and_2273;
  assign and_2273 = or_2152_s2_q & ((equal_2150_s2_q & and_2269) & (patches_column_s2_q == 5'h1f));
  // hls/stages/patches.hpp:444
  logic or_2279;
  assign or_2279 = equal_2150_s2_q | (~and_2269);
  // hls/stages/patches.hpp:448
  logic and_2284;
  assign and_2284 = (~or_2279) & ((~patches_column_s2_q[4]) & (patches_column_s2_q == 5'hf));
  // hls/stages/patches.hpp:485
  logic less_2288;
  assign less_2288 = patches_step_q[4:0] < 5'h11;
  logic equal_2289;
  assign equal_2289 = patches_step_q[6:5] == 2'h0;
  logic not_2290;
  assign not_2290 = ~equal_2289;
  logic equal_2291;
  assign equal_2291 = patches_step_q[6:5] == 2'h3;
  logic not_2292;
  assign not_2292 = ~equal_2291;
  // hls/stages/patches.hpp:499
  logic select_2295;
  assign select_2295 = equal_2291 ? (less_2288 & (less_2288 & not_2292)) : less_2288;
  // hls/stages/patches.hpp:160
  logic and_2298;
  assign and_2298 = equal_2146_s2_q & (less_2288 ? (not_2290 & select_2295) : select_2295);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2319;
  assign sum_2319 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:250
  logic textured;
  assign textured = shift_2[0] & shift_2[2];
  // hls/stages/patches.hpp:313
  logic and_2455;
  assign and_2455 = ends_cell_s2_q & (and_2451_s2_q & (~({sum_2018, last_s2_q[1:0]} < x_s2_q)));
  // hls/stages/registration.hpp:76
  logic less_2902;
  assign less_2902 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:141
  logic [7:0] select_2904;
  assign select_2904 = or_512_s2_q ? (less_519_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2906;
  assign select_2906 = or_512_s2_q ? (less_519_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2908;
  assign select_2908 = or_512_s2_q ? (less_519_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2906} - {1'b0, select_2908};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2910;
  assign select_2910 = rise[8] ? select_2906 : select_2908;
  logic [8:0] difference_2911;
  assign difference_2911 = {1'b0, select_2904} - {1'b0, select_2910};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2911[8] ? 8'h0 : difference_2911[7:0];
  // hls/stages/registration.hpp:37
  logic not_2913;
  assign not_2913 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2902 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2913};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2915;
  assign xor_2915 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise[8]} + {1'b0, xor_2915};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2921;
  assign select_2921 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2902 ? {taken, 1'b1} : {not_2913, select_2921, not_2913};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2923;
  assign sum_2923 = {left, 1'b1} + {taken_2, less_2902};
  // hls/stages/agreement.hpp:245
  logic [4:0] select_2925;
  assign select_2925 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:129
  logic [15:0] select_3008;
  assign select_3008 = and_3007_s2_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3010;
  assign select_3010 = and_3005_s2_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3008[15]}}, select_3008});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3011;
  assign select_3011 = and_3007_s2_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3011[15]}}, select_3011};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3013;
  assign select_3013 = and_3005_s2_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:141
  logic and_3014;
  assign and_3014 = ends_cell_s2_q & so_s2_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_8;
  assign column_8 = registration_slope_q + (and_3014 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:68
  logic parity_3157;
  assign parity_3157 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:447
  logic [15:0] select_3158;
  assign select_3158 = equal_2721_s2_q ? {patches_chance_q[14:0], parity_3157} : patches_chance_q;
  // hls/stages/patches.hpp:85
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:86
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:87
  logic [5:0] select_3163;
  assign select_3163 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3163};
  // hls/stages/patches.hpp:313
  logic and_3169;
  assign and_3169 = so_s2_q & (ends_cell_s2_q & (shift_2[0] & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:163
  logic select_3260;
  assign select_3260 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:160
  logic [11:0] select_3263;
  assign select_3263 = equal_2148_s2_q ? patches_smooth_values_0_q : (or_2152_s2_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3265;
  assign select_3265 = or_2152_s2_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3267;
  assign select_3267 = equal_2146_s2_q ? patches_smooth_values_1_q : (equal_2148_s2_q ? patches_smooth_values_1_q : select_3265);
  logic [11:0] select_3268;
  assign select_3268 = or_2152_s2_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3270;
  assign select_3270 = equal_2146_s2_q ? patches_smooth_values_2_q : (equal_2148_s2_q ? patches_smooth_values_2_q : select_3268);
  logic [11:0] select_3271;
  assign select_3271 = or_2152_s2_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3273;
  assign select_3273 = equal_2146_s2_q ? patches_smooth_values_3_q : (equal_2148_s2_q ? patches_smooth_values_3_q : select_3271);
  logic [10:0] select_3275;
  assign select_3275 = equal_2148_s2_q ? patches_down_values_0_q : (or_2152_s2_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3278;
  assign select_3278 = equal_2148_s2_q ? patches_down_values_1_q : (or_2152_s2_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3281;
  assign select_3281 = equal_2148_s2_q ? patches_down_values_2_q : (or_2152_s2_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3284;
  assign select_3284 = equal_2148_s2_q ? patches_down_values_3_q : (or_2152_s2_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:151
  logic and_3313;
  assign and_3313 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:386
  logic [4:0] select_3318;
  assign select_3318 = or_3221_s2_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:388
  logic [3:0] select_3320;
  assign select_3320 = and_3313 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:160
  logic [4:0] select_3670;
  assign select_3670 = equal_2146_s2_q ? patches_summed_row_column_q : (equal_2148_s2_q ? patches_along_q : patches_summed_row_column_q);
  logic [4:0] select_3676;
  assign select_3676 = equal_2146_s2_q ? patches_summed_down_by_q : (equal_2148_s2_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:495
  logic and_3709;
  assign and_3709 = less_2288 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:499
  logic select_3712;
  assign select_3712 = equal_2291 ? (less_2288 ? (not_2292 & and_3709) : and_3709) : and_3709;
  // hls/stages/patches.hpp:160
  logic select_3715;
  assign select_3715 = equal_2146_s2_q ? (less_2288 ? (not_2290 & select_3712) : select_3712) : patches_read_searches_q;
  // hls/stages/agreement.hpp:197
  logic [8:0] select_4003;
  assign select_4003 = so_s2_q ? (and_3014 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4005;
  assign sum_4005 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4006;
  assign select_4006 = sum_2319[5] ? {1'b1, sum_2319[4:0], region_across_rest_q[2:0]} : sum_4005;
  // hls/stages/agreement.hpp:447
  logic [8:0] select_4008;
  assign select_4008 = equal_2721_s2_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4011;
  assign select_4011 = equal_2721_s2_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:226; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_461_s2_q;
  logic averager_memory_re;
  assign averager_memory_re = s2_en & and_466;
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
  assign census_memory_re = s2_en & and_491_s2_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1298; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1968;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory patches_right_codes, 28 x 112 and parity, DISTANCE 12, hls/stages/patches.hpp:713; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [112:0] patches_right_codes_mem [0:27];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 28; i++) patches_right_codes_mem[i] = 113'h0;
`endif
  logic [4:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = patches_down_by_q + {1'b0, patches_match_row_q};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s2_en & and_2242;
  logic [112:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [111:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[111:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:714; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [48:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 49'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s2_en & and_2242;
  logic [48:0] patches_left_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_word_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end
  logic [47:0] patches_left_codes_rdata_q;
  assign patches_left_codes_rdata_q = patches_left_codes_word_q[47:0];
  logic patches_left_codes_read_q, patches_left_codes_error;
  always_ff @(posedge clk_i) patches_left_codes_read_q <= rst_ni & patches_left_codes_re;
  assign patches_left_codes_error = patches_left_codes_read_q & ^patches_left_codes_word_q;

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:728; read in stage 2, written in stage 4: 2 < 4 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [15:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 16'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s2_en & and_2298;
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1325; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1968;
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
  assign best_left_we = s2_en & and_1915_s2_q;
  logic [45:0] best_left_wdata;
  assign best_left_wdata = {select_1914, select_1913, select_1886, select_1880, select_1872, select_1871, select_1867};
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
  assign best_right_we = s2_en & and_1915_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_1932, select_1931, select_1928, select_1927};
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
  assign patches_columns_above_we = s2_en & and_2233_s2_q;
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
      registration_displacement_over_q <= so_s2_q ? sum_2923[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2925;
      registration_slope_row_q <= select_3010;
      registration_slope_change_q <= select_3013;
      registration_slope_q <= so_s2_q ? column_8 : {registration_slope_row_q, 4'h0};
      patches_chance_q <= and_491_s2_q ? select_3158 : patches_chance_q;
      patches_along_ends_q <= not_3245_s2_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3245_s2_q & select_3260;
      patches_smooth_values_0_q <= equal_2146_s2_q ? patches_smooth_values_0_q : select_3263;
      patches_smooth_values_1_q <= select_3267;
      patches_smooth_values_2_q <= select_3270;
      patches_smooth_values_3_q <= select_3273;
      patches_down_values_0_q <= equal_2146_s2_q ? patches_down_values_0_q : select_3275;
      patches_down_values_1_q <= equal_2146_s2_q ? patches_down_values_1_q : select_3278;
      patches_down_values_2_q <= equal_2146_s2_q ? patches_down_values_2_q : select_3281;
      patches_down_values_3_q <= equal_2146_s2_q ? patches_down_values_3_q : select_3284;
      patches_down_by_q <= or_3221_s2_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3313});
      patches_along_q <= select_3318;
      patches_match_row_q <= or_3221_s2_q ? 4'h0 : select_3320;
      patches_summed_row_column_q <= select_3670;
      patches_summed_last_q <= not_2147_s2_q & (equal_2148_s2_q & and_3313);
      patches_summed_down_by_q <= select_3676;
      patches_step_q <= or_3221_s2_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3715;
      region_across_rest_q <= select_4003;
      region_across_back_q <= so_s2_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4006;
      columns_begin_rest_q <= and_491_s2_q ? select_4008 : columns_begin_rest_q;
      columns_begin_back_q <= and_491_s2_q ? select_4011 : columns_begin_back_q;
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
  logic [2:0] select_455_s3_q;
  logic [6:0] select_457_s3_q;
  logic [8:0] select_461_s3_q;
  logic and_465_s3_q;
  logic and_466_s3_q;
  logic equal_471_s3_q;
  logic [6:0] column_s3_q;
  logic and_489_s3_q;
  logic and_491_s3_q;
  logic so_s3_q;
  logic equal_552_s3_q;
  logic equal_1933_s3_q;
  logic not_1934_s3_q;
  logic [13:0] shift_2_s3_q;
  logic and_1968_s3_q;
  logic [6:0] select_1972_s3_q;
  logic and_1977_s3_q;
  logic right_2_s3_q;
  logic and_2046_s3_q;
  logic and_2059_s3_q;
  logic and_2072_s3_q;
  logic less_2073_s3_q;
  logic [7:0] change_s3_q;
  logic equal_2100_s3_q;
  logic and_2112_s3_q;
  logic equal_2139_s3_q;
  logic and_2144_s3_q;
  logic and_2145_s3_q;
  logic equal_2146_s3_q;
  logic equal_2148_s3_q;
  logic equal_2150_s3_q;
  logic or_2152_s3_q;
  logic [4:0] select_2176_s3_q;
  logic select_2182_s3_q;
  logic [3:0] select_2223_s3_q;
  logic new_row_s3_q;
  logic less_2253_s3_q;
  logic less_2254_s3_q;
  logic less_2263_s3_q;
  logic less_2264_s3_q;
  logic and_2275_s3_q;
  logic or_2279_s3_q;
  logic and_2287_s3_q;
  logic less_2288_s3_q;
  logic equal_2289_s3_q;
  logic not_2290_s3_q;
  logic equal_2291_s3_q;
  logic not_2292_s3_q;
  logic sum_2319_s3_q;
  logic textured_s3_q;
  logic and_2457_s3_q;
  logic equal_2597_s3_q;
  logic equal_2721_s3_q;
  logic less_2939_s3_q;
  logic and_3170_s3_q;
  logic equal_3632_s3_q;
  logic equal_3716_s3_q;
  logic less_3991_s3_q;
  logic equal_4196_s3_q;
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
      select_455_s3_q <= select_455_s2_q;
      select_457_s3_q <= select_457_s2_q;
      select_461_s3_q <= select_461_s2_q;
      and_465_s3_q <= and_465_s2_q;
      and_466_s3_q <= and_466;
      equal_471_s3_q <= equal_471_s2_q;
      column_s3_q <= column_s2_q;
      and_489_s3_q <= and_489_s2_q;
      and_491_s3_q <= and_491_s2_q;
      so_s3_q <= so_s2_q;
      equal_552_s3_q <= equal_552_s2_q;
      equal_1933_s3_q <= equal_1933_s2_q;
      not_1934_s3_q <= not_1934;
      shift_2_s3_q <= {shift_2[14:3], shift_2[1:0]};
      and_1968_s3_q <= and_1968;
      select_1972_s3_q <= select_1972_s2_q;
      and_1977_s3_q <= not_1934 & (so_s2_q ? and_1966 : (equal_511_s2_q & shift_2[4]));
      right_2_s3_q <= right_2;
      and_2046_s3_q <= and_2046_s2_q;
      and_2059_s3_q <= and_2059_s2_q;
      and_2072_s3_q <= not_1934 & (so_s2_q & (ends_cell_s2_q & (shift_2[0] & right_3)));
      less_2073_s3_q <= less_2073_s2_q;
      change_s3_q <= change;
      equal_2100_s3_q <= equal_2100;
      and_2112_s3_q <= and_2112;
      equal_2139_s3_q <= equal_2139;
      and_2144_s3_q <= and_2144;
      and_2145_s3_q <= patches_chooses_s2_q & and_2144;
      equal_2146_s3_q <= equal_2146_s2_q;
      equal_2148_s3_q <= equal_2148_s2_q;
      equal_2150_s3_q <= equal_2150_s2_q;
      or_2152_s3_q <= or_2152_s2_q;
      select_2176_s3_q <= select_2176_s2_q;
      select_2182_s3_q <= select_2182_s2_q;
      select_2223_s3_q <= select_2223_s2_q;
      new_row_s3_q <= new_row;
      less_2253_s3_q <= $signed(15'h100) < $signed(sum_2252);
      less_2254_s3_q <= $signed(sum_2252[14:8]) < $signed(7'h7f);
      less_2263_s3_q <= $signed(15'h100) < $signed(difference_2262);
      less_2264_s3_q <= $signed(difference_2262[14:8]) < $signed(7'h7f);
      and_2275_s3_q <= not_2147_s2_q & (not_2149_s2_q & and_2273);
      or_2279_s3_q <= or_2279;
      and_2287_s3_q <= not_2147_s2_q & (not_2149_s2_q & (or_2152_s2_q & and_2284));
      less_2288_s3_q <= less_2288;
      equal_2289_s3_q <= equal_2289;
      not_2290_s3_q <= not_2290;
      equal_2291_s3_q <= equal_2291;
      not_2292_s3_q <= not_2292;
      sum_2319_s3_q <= sum_2319[5];
      textured_s3_q <= textured;
      and_2457_s3_q <= not_1934 & (so_s2_q & and_2455);
      equal_2597_s3_q <= equal_2597_s2_q;
      equal_2721_s3_q <= equal_2721_s2_q;
      less_2939_s3_q <= select_2906 < select_2908;
      and_3170_s3_q <= not_1934 & and_3169;
      equal_3632_s3_q <= patches_match_row_q == 4'h0;
      equal_3716_s3_q <= patches_step_q[6:5] == 2'h2;
      less_3991_s3_q <= less_3991_s2_q;
      equal_4196_s3_q <= equal_4196_s2_q;
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
  logic [11:0] select_469;
  assign select_469 = select_455_s3_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_473;
  assign sum_473 = select_469 + (equal_471_s3_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_475;
  assign sum_475 = {4'h0, sample_pair_pixel_1_q} + (select_455_s3_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_477;
  assign sum_477 = sum_475 + (equal_471_s3_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:404
  logic whole;
  assign whole = select_455_s3_q[0] ? (sample_present_s3_q & averager_running_mask_q) : sample_present_s3_q;
  // hls/stages/census.hpp:122
  logic and_481;
  assign and_481 = whole & (averager_memory_rdata_q[24] | equal_471_s3_q);
  // hls/stages/agreement.hpp:404
  logic all_of_skin;
  assign all_of_skin = select_455_s3_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_485;
  assign and_485 = all_of_skin & (averager_memory_rdata_q[25] | equal_471_s3_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_465_s3_q ? sum_473[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_494;
  assign equal_494 = select_455_s3_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_494 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_497;
  assign select_497 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_465_s3_q ? sum_477[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_494 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:263
  logic [8:0] select_501;
  assign select_501 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_502;
  assign and_502 = and_465_s3_q & and_481;
  // hls/stages/census.hpp:126
  logic select_504;
  assign select_504 = equal_494 ? and_502 : (averager_mask_q & and_502);
  // hls/stages/agreement.hpp:263
  logic whole_2;
  assign whole_2 = sample_pair_whole_s3_q & select_504;
  // hls/stages/census.hpp:206
  logic and_506;
  assign and_506 = and_465_s3_q & and_485;
  // hls/stages/census.hpp:126
  logic select_508;
  assign select_508 = equal_494 ? and_506 : (averager_of_skin_q & and_506);
  // hls/stages/agreement.hpp:263
  logic and_509;
  assign and_509 = sample_pair_whole_s3_q & select_508;
  // hls/stages/census.hpp:294
  logic less_525;
  assign less_525 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_526;
  assign less_526 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_527;
  assign less_527 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_528;
  assign less_528 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_529;
  assign less_529 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_530;
  assign less_530 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_531;
  assign less_531 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_532;
  assign less_532 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_533;
  assign less_533 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_534;
  assign less_534 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_535;
  assign less_535 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_536;
  assign less_536 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_537;
  assign less_537 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_538;
  assign less_538 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_539;
  assign less_539 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_540;
  assign less_540 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_541;
  assign less_541 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_542;
  assign less_542 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_543;
  assign less_543 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_544;
  assign less_544 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_545;
  assign less_545 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_546;
  assign less_546 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_547;
  assign less_547 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_548;
  assign less_548 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:442
  logic equal_549;
  assign equal_549 = column_s3_q == 7'h0;
  logic [3:0] select_553;
  assign select_553 = equal_552_s3_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:443
  logic [4:0] select_554;
  assign select_554 = equal_549 ? {select_553, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_555;
  assign select_555 = equal_549 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_556;
  assign and_556 = select_554[4] & select_555[3];
  // hls/stages/census.hpp:286
  logic and_558;
  assign and_558 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_560;
  assign and_560 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_558);
  // hls/stages/agreement.hpp:443
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_560;
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
  logic [9:0] difference_583;
  assign difference_583 = {1'b0, select_497} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_584;
  assign xor_584 = difference_583[8:0] ^ {9{difference_583[9]}};
  logic [9:0] sum_585;
  assign sum_585 = {9'h0, difference_583[9]} + {1'b0, xor_584};
  logic [9:0] difference_586;
  assign difference_586 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_587;
  assign xor_587 = difference_586[8:0] ^ {9{difference_586[9]}};
  logic [9:0] sum_588;
  assign sum_588 = {9'h0, difference_586[9]} + {1'b0, xor_587};
  logic [9:0] difference_590;
  assign difference_590 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_591;
  assign xor_591 = difference_590[8:0] ^ {9{difference_590[9]}};
  logic [9:0] sum_592;
  assign sum_592 = {9'h0, difference_590[9]} + {1'b0, xor_591};
  logic [10:0] sum_593;
  assign sum_593 = ({1'b0, sum_585} + {1'b0, sum_588}) + {1'b0, sum_592};
  logic [9:0] difference_594;
  assign difference_594 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_595;
  assign xor_595 = difference_594[8:0] ^ {9{difference_594[9]}};
  logic [9:0] sum_596;
  assign sum_596 = {9'h0, difference_594[9]} + {1'b0, xor_595};
  logic [9:0] difference_598;
  assign difference_598 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_599;
  assign xor_599 = difference_598[8:0] ^ {9{difference_598[9]}};
  // hls/stages/agreement.hpp:193
  logic not_1973;
  assign not_1973 = ~so_s3_q;
  // hls/stages/patches.hpp:313
  logic and_1974;
  assign and_1974 = not_1973 & shift_2_s3_q[4];
  // hls/stages/agreement.hpp:1070
  logic equal_1978;
  assign equal_1978 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1116
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1071
  logic [1:0] select_1981;
  assign select_1981 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:1084
  logic [3:0] select_1983;
  assign select_1983 = equal_1978 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1981});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1984;
  assign sum_1984 = slot_s3_q[1:0] + 2'h3;
  // hls/stages/patches.hpp:313
  logic [3:0] select_1985;
  assign select_1985 = equal_1933_s3_q ? select_1983 : {sum_1984, lower_half_s3_q, registration_of_right_q};
  // hls/stages/patches.hpp:185
  logic equal_1986;
  assign equal_1986 = x_s3_q[5:0] == 6'h3f;
  logic equal_1988;
  assign equal_1988 = x_s3_q[5:0] == 6'h3e;
  logic equal_1990;
  assign equal_1990 = x_s3_q[5:0] == 6'h3d;
  logic equal_1992;
  assign equal_1992 = x_s3_q[5:0] == 6'h3c;
  logic equal_1994;
  assign equal_1994 = x_s3_q[5:0] == 6'h3b;
  logic equal_1996;
  assign equal_1996 = x_s3_q[5:0] == 6'h36;
  logic equal_1998;
  assign equal_1998 = x_s3_q[5:0] == 6'h35;
  logic equal_2000;
  assign equal_2000 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1116
  logic and_2004;
  assign and_2004 = (~equal_1994) & ((~equal_1996) & ((~equal_1998) & (~equal_2000)));
  logic and_2008;
  assign and_2008 = (~equal_1986) & ((~equal_1988) & ((~equal_1990) & ((~equal_1992) & and_2004)));
  // hls/stages/agreement.hpp:1071
  logic less_2009;
  assign less_2009 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2013;
  assign or_2013 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = shift_2_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2024;
  assign sum_2024 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_2026;
  assign and_2026 = half_ends & ({{3{sum_2024[4]}}, sum_2024} < 8'h3);
  // hls/stages/patches.hpp:313
  logic and_2027;
  assign and_2027 = so_s3_q & and_2026;
  logic select_2028;
  assign select_2028 = equal_1933_s3_q ? (x_s3_q[6] & (equal_1978 ? and_2008 : (less_2009 & (~or_2013)))) : and_2027;
  // hls/stages/registration.hpp:258
  logic not_2030;
  assign not_2030 = ~lower_half_s3_q;
  logic [3:0] select_2031;
  assign select_2031 = registration_of_right_q ? {lower_half_s3_q, 1'b0, not_2030, 1'b0} : {1'b0, lower_half_s3_q, 1'b0, not_2030};
  // hls/stages/patches.hpp:346
  logic [1:0] select_2060;
  assign select_2060 = and_2059_s3_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2061;
  assign select_2061 = and_2059_s3_q ? patches_band_rows_number_s3_q : patches_band_q;
  // hls/stages/agreement.hpp:263
  logic [5:0] select_2062;
  assign select_2062 = and_2046_s3_q ? {select_2061, select_2060[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:103
  logic [1:0] select_2063;
  assign select_2063 = and_2046_s3_q ? select_2060 : patches_fetch_q;
  logic equal_2064;
  assign equal_2064 = select_2063 == 2'h0;
  // hls/stages/registration.hpp:83
  logic equal_2074;
  assign equal_2074 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2074 ? registration_slope_here_q : change_s3_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2080;
  assign select_2080 = shift_2_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2081;
  assign select_2081 = shift_2_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2082;
  assign sum_2082 = {{2{select_2080[6]}}, select_2080} + {select_2081[7], select_2081};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2083;
  assign select_2083 = shift_2_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2084;
  assign select_2084 = shift_2_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2085;
  assign sum_2085 = {{2{select_2083[7]}}, select_2083[7:1]} + {select_2084[7], select_2084};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2086;
  assign sum_2086 = {{3{sum_2082[8]}}, sum_2082[8:1]} + {sum_2085[8], sum_2085, select_2083[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2087;
  assign select_2087 = shift_2_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2088;
  assign select_2088 = shift_2_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2089;
  assign difference_2089 = {{2{select_2087[7]}}, select_2087[7:1]} - {select_2088[7], select_2088};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2090;
  assign sum_2090 = {difference_2089, select_2087[0]} + {sum_2086[10], sum_2086[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2074 ? {sum_2090, sum_2086[1]} : registration_expected_q;
  // hls/stages/patches.hpp:75
  logic [9:0] sum_2092;
  assign sum_2092 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:964
  logic and_2094;
  assign and_2094 = shift_2_s3_q[3] & ({{4{sum_2092[9]}}, sum_2092, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:313
  logic and_2115;
  assign and_2115 = ends_cell_s3_q & (shift_2_s3_q[0] & ((less_2073_s3_q & and_2094) & and_2112_s3_q));
  logic and_2117;
  assign and_2117 = not_1934_s3_q & (so_s3_q & and_2115);
  // hls/stages/patches.hpp:133
  logic and_2119;
  assign and_2119 = and_2117 & (~patches_fixed_q);
  // hls/stages/patches.hpp:313
  logic [7:0] select_2122;
  assign select_2122 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? x_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2123;
  assign select_2123 = equal_1933_s3_q ? 8'h0 : select_2122;
  logic [5:0] select_2125;
  assign select_2125 = ends_cell_s3_q ? (shift_2_s3_q[0] ? shift_2_s3_q[10:5] : 6'h0) : 6'h0;
  logic [5:0] select_2127;
  assign select_2127 = equal_1933_s3_q ? 6'h0 : (so_s3_q ? select_2125 : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2128;
  assign sum_2128 = {registration_slope_s3_q[11], registration_slope_s3_q} + {{5{sum_2090[9]}}, sum_2090[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2131;
  assign select_2131 = ($signed(sum_2128[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2128[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2074 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2128[12:7])) ? 8'h7f : select_2131);
  // hls/stages/patches.hpp:313
  logic [7:0] select_2136;
  assign select_2136 = so_s3_q ? (ends_cell_s3_q ? (shift_2_s3_q[0] ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2137;
  assign select_2137 = equal_1933_s3_q ? 8'h0 : select_2136;
  // hls/stages/patches.hpp:316
  logic [22:0] select_2138;
  assign select_2138 = and_2119 ? {select_2137, select_2127, select_2123, and_2117} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:103
  logic [4:0] select_2159;
  assign select_2159 = and_2046_s3_q ? select_2061 : patches_band_q;
  // hls/stages/patches.hpp:326
  logic equal_2160;
  assign equal_2160 = {patches_choosing_band_s3_q, and_2072_s3_q} == {select_2159, select_2063[1]};
  // hls/stages/patches.hpp:442
  logic [2:0] sum_2244;
  assign sum_2244 = patches_code_row_s3_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:446
  logic [1:0] sum_2277;
  assign sum_2277 = patches_code_row_s3_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:197
  logic [7:0] select_2306;
  assign select_2306 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:992
  logic or_2309;
  assign or_2309 = select_2306[7] | (~({select_2306[5], select_2306[3], select_2306[1]} == 3'h0));
  // hls/stages/agreement.hpp:991
  logic or_2312;
  assign or_2312 = select_2306[7] | (~({select_2306[6], select_2306[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:990
  logic or_2315;
  assign or_2315 = select_2306[7] | (~(select_2306[6:4] == 3'h0));
  // hls/stages/patches.hpp:313
  logic [5:0] select_2316;
  assign select_2316 = equal_1933_s3_q ? x_s3_q[5:0] : {region_row_q, or_2315, or_2312, or_2309};
  // hls/stages/agreement.hpp:1070
  logic not_2317;
  assign not_2317 = ~equal_1978;
  // hls/stages/agreement.hpp:1000
  logic or_2321;
  assign or_2321 = (~sum_2319_s3_q) | equal_2139_s3_q;
  // hls/stages/patches.hpp:313
  logic and_2324;
  assign and_2324 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & or_2321));
  // hls/stages/agreement.hpp:250
  logic explained;
  assign explained = shift_2_s3_q[0] & shift_2_s3_q[3];
  logic and_2345;
  assign and_2345 = shift_2_s3_q[0] & shift_2_s3_q[2];
  // hls/stages/agreement.hpp:960
  logic select_2346;
  assign select_2346 = slot_s3_q[2] ? shown_shown_q : shift_2_s3_q[3];
  // hls/stages/agreement.hpp:250
  logic shown;
  assign shown = shift_2_s3_q[0] & (shown_right_rdata_q[0] | select_2346);
  // hls/stages/agreement.hpp:960
  logic select_2349;
  assign select_2349 = slot_s3_q[2] ? shown_nearer_q : shift_2_s3_q[4];
  // hls/stages/agreement.hpp:250
  logic near;
  assign near = shift_2_s3_q[0] & (select_2346 ? select_2349 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1201
  logic or_2352;
  assign or_2352 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:1203
  logic [16:0] select_2354;
  assign select_2354 = marks_first_s3_q ? 17'h1 : (or_2352 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1202
  logic [8:0] select_2356;
  assign select_2356 = or_2352 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1210
  logic select_2358;
  assign select_2358 = cfg_compete_i ? (or_2352 & select_2354[16]) : (select_2356[8] & select_2354[9]);
  // hls/stages/agreement.hpp:422
  logic next_row;
  assign next_row = select_2358 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1217
  logic [6:0] select_2361;
  assign select_2361 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2363;
  assign select_2363 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_2361});
  // hls/stages/agreement.hpp:1227
  logic equal_2364;
  assign equal_2364 = seen_x_q == 3'h7;
  logic [7:0] select_2366;
  assign select_2366 = select_2358 ? 8'h0 : (seen_column_q + {7'h0, equal_2364});
  // hls/stages/agreement.hpp:1234
  logic [12:0] index;
  assign index = select_2363 + {5'h0, select_2366};
  // hls/stages/agreement.hpp:1201
  logic select_2369;
  assign select_2369 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1187
  logic [7:0] sum_2370;
  assign sum_2370 = {1'b0, select_2369, 2'h0, select_2369, 1'b0, {2{select_2369}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1200
  logic not_2371;
  assign not_2371 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:422
  logic and_2373;
  assign and_2373 = not_2371 & (began_q | select_2358);
  // hls/stages/agreement.hpp:1228
  logic [2:0] select_2375;
  assign select_2375 = select_2358 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1233
  logic and_2377;
  assign and_2377 = and_2373 & (select_2375 == 3'h0);
  logic less_2378;
  assign less_2378 = select_2366 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1053
  logic [7:0] sum_2381;
  assign sum_2381 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2381[7]}}, sum_2381, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1187
  logic [7:0] sum_2383;
  assign sum_2383 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:976
  logic and_2384;
  assign and_2384 = seen_columns_rdata_q[14] & shift_2_s3_q[0];
  logic and_2385;
  assign and_2385 = seen_columns_rdata_q[10] & shift_2_s3_q[0];
  logic and_2386;
  assign and_2386 = seen_columns_rdata_q[5] & shift_2_s3_q[0];
  logic and_2387;
  assign and_2387 = seen_columns_rdata_q[0] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1029
  logic [1:0] sum_2389;
  assign sum_2389 = {1'b0, and_2386} + ({1'b0, textured_s3_q} + {1'b0, and_2387});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2384} + ({2'h0, and_2385} + {1'b0, sum_2389});
  // hls/stages/agreement.hpp:1036
  logic [2:0] select_2392;
  assign select_2392 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2393;
  assign difference_2393 = {1'b0, textured_2} - {1'b0, select_2392};
  logic [4:0] t;
  assign t = {difference_2393[3], difference_2393} + (equal_2100_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:976
  logic [7:0] select_2398;
  assign select_2398 = shift_2_s3_q[0] ? (sum_2319_s3_q ? select_2306 : {select_2306[6:0], 1'b0}) : select_2306;
  // hls/stages/agreement.hpp:992
  logic or_2401;
  assign or_2401 = select_2398[7] | (~({select_2398[5], select_2398[3], select_2398[1]} == 3'h0));
  // hls/stages/agreement.hpp:976
  logic and_2418;
  assign and_2418 = seen_columns_rdata_q[16] & shift_2_s3_q[0];
  logic and_2419;
  assign and_2419 = seen_columns_rdata_q[12] & shift_2_s3_q[0];
  logic and_2420;
  assign and_2420 = seen_columns_rdata_q[8] & shift_2_s3_q[0];
  logic and_2421;
  assign and_2421 = seen_columns_rdata_q[3] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1031
  logic [1:0] sum_2423;
  assign sum_2423 = {1'b0, and_2420} + ({1'b0, shown} + {1'b0, and_2421});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2418} + ({2'h0, and_2419} + {1'b0, sum_2423});
  // hls/stages/agreement.hpp:1038
  logic [2:0] select_2426;
  assign select_2426 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2427;
  assign difference_2427 = {1'b0, shown_2} - {1'b0, select_2426};
  logic [4:0] around;
  assign around = {difference_2427[3], difference_2427} + (equal_2100_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1045
  logic [5:0] sum_2430;
  assign sum_2430 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:976
  logic and_2434;
  assign and_2434 = seen_columns_rdata_q[17] & shift_2_s3_q[0];
  logic and_2435;
  assign and_2435 = seen_columns_rdata_q[13] & shift_2_s3_q[0];
  logic and_2436;
  assign and_2436 = seen_columns_rdata_q[9] & shift_2_s3_q[0];
  logic and_2437;
  assign and_2437 = seen_columns_rdata_q[4] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1032
  logic [1:0] sum_2439;
  assign sum_2439 = {1'b0, and_2436} + ({1'b0, near} + {1'b0, and_2437});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2434} + ({2'h0, and_2435} + {1'b0, sum_2439});
  // hls/stages/agreement.hpp:1039
  logic [2:0] select_2442;
  assign select_2442 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2443;
  assign difference_2443 = {1'b0, near_2} - {1'b0, select_2442};
  logic [4:0] n;
  assign n = {difference_2443[3], difference_2443} + (equal_2100_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:263
  logic [10:0] select_2489;
  assign select_2489 = sample_pair_whole_s3_q ? (and_489_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2491;
  assign select_2491 = sample_pair_whole_s3_q ? (and_489_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2510;
  assign select_2510 = sample_pair_whole_s3_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2512;
  assign select_2512 = sample_pair_whole_s3_q ? (and_489_s3_q ? select_504 : averager_mask_q) : averager_mask_q;
  logic select_2514;
  assign select_2514 = sample_pair_whole_s3_q ? (and_489_s3_q ? select_508 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:507
  logic [8:0] select_2515;
  assign select_2515 = and_491_s3_q ? select_497 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2516;
  assign select_2516 = and_491_s3_q ? select_501 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2518;
  assign select_2518 = and_491_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2519;
  assign select_2519 = and_491_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2520;
  assign select_2520 = and_491_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2521;
  assign select_2521 = and_491_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2522;
  assign select_2522 = and_491_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2523;
  assign select_2523 = and_491_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2524;
  assign select_2524 = and_491_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2525;
  assign select_2525 = and_491_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2526;
  assign select_2526 = and_491_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2527;
  assign select_2527 = and_491_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2528;
  assign select_2528 = and_491_s3_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2529;
  assign select_2529 = and_491_s3_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2530;
  assign select_2530 = and_491_s3_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2531;
  assign select_2531 = and_491_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2532;
  assign select_2532 = and_491_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2533;
  assign select_2533 = and_491_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2534;
  assign select_2534 = and_491_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2535;
  assign select_2535 = and_491_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2536;
  assign select_2536 = and_491_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2537;
  assign select_2537 = and_491_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2538;
  assign select_2538 = and_491_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2539;
  assign select_2539 = and_491_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2540;
  assign select_2540 = and_491_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2541;
  assign select_2541 = and_491_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2542;
  assign select_2542 = and_491_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2543;
  assign select_2543 = and_491_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2544;
  assign select_2544 = and_491_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2545;
  assign select_2545 = and_491_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2546;
  assign select_2546 = and_491_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2547;
  assign select_2547 = and_491_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2548;
  assign select_2548 = and_491_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2549;
  assign select_2549 = and_491_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2550;
  assign select_2550 = and_491_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2551;
  assign select_2551 = and_491_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2552;
  assign select_2552 = and_491_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2553;
  assign select_2553 = and_491_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2554;
  assign select_2554 = and_491_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2555;
  assign select_2555 = and_491_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2556;
  assign select_2556 = and_491_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2557;
  assign select_2557 = and_491_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2558;
  assign select_2558 = and_491_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2559;
  assign select_2559 = and_491_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2560;
  assign select_2560 = and_491_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2561;
  assign select_2561 = and_491_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2562;
  assign select_2562 = and_491_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2563;
  assign select_2563 = and_491_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2564;
  assign select_2564 = and_491_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2565;
  assign select_2565 = and_491_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2566;
  assign select_2566 = and_491_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2567;
  assign select_2567 = and_491_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2568;
  assign select_2568 = and_491_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2569;
  assign select_2569 = and_491_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2570;
  assign select_2570 = and_491_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2572;
  assign difference_2572 = {1'b0, select_501} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2573;
  assign xor_2573 = difference_2572[8:0] ^ {9{difference_2572[9]}};
  logic [9:0] sum_2574;
  assign sum_2574 = {9'h0, difference_2572[9]} + {1'b0, xor_2573};
  logic [9:0] difference_2575;
  assign difference_2575 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2576;
  assign xor_2576 = difference_2575[8:0] ^ {9{difference_2575[9]}};
  logic [9:0] sum_2577;
  assign sum_2577 = {9'h0, difference_2575[9]} + {1'b0, xor_2576};
  logic [9:0] difference_2579;
  assign difference_2579 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2580;
  assign xor_2580 = difference_2579[8:0] ^ {9{difference_2579[9]}};
  logic [9:0] sum_2581;
  assign sum_2581 = {9'h0, difference_2579[9]} + {1'b0, xor_2580};
  logic [10:0] sum_2582;
  assign sum_2582 = ({1'b0, sum_2574} + {1'b0, sum_2577}) + {1'b0, sum_2581};
  logic [9:0] difference_2583;
  assign difference_2583 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2584;
  assign xor_2584 = difference_2583[8:0] ^ {9{difference_2583[9]}};
  logic [9:0] sum_2585;
  assign sum_2585 = {9'h0, difference_2583[9]} + {1'b0, xor_2584};
  logic [9:0] difference_2587;
  assign difference_2587 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2588;
  assign xor_2588 = difference_2587[8:0] ^ {9{difference_2587[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2618;
  assign difference_2618 = {1'b0, select_497} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2618[9]} + (difference_2618[8:0] ^ {9{difference_2618[9]}});
  logic [9:0] difference_2630;
  assign difference_2630 = {1'b0, select_501} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2630[9]} + (difference_2630[8:0] ^ {9{difference_2630[9]}});
  // hls/stages/agreement.hpp:507
  logic and_2818;
  assign and_2818 = and_491_s3_q & (equal_552_s3_q & equal_2721_s3_q);
  // hls/stages/patches.hpp:313
  logic and_2822;
  assign and_2822 = not_1934_s3_q & (so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & shift_2_s3_q[1])));
  // hls/stages/agreement.hpp:976
  logic and_2842;
  assign and_2842 = seen_columns_rdata_q[15] & shift_2_s3_q[0];
  logic and_2843;
  assign and_2843 = seen_columns_rdata_q[11] & shift_2_s3_q[0];
  logic and_2844;
  assign and_2844 = seen_columns_rdata_q[7] & shift_2_s3_q[0];
  logic and_2845;
  assign and_2845 = seen_columns_rdata_q[2] & shift_2_s3_q[0];
  // hls/stages/agreement.hpp:1030
  logic [1:0] sum_2847;
  assign sum_2847 = {1'b0, and_2844} + ({1'b0, explained} + {1'b0, and_2845});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2842} + ({2'h0, and_2843} + {1'b0, sum_2847});
  // hls/stages/agreement.hpp:1037
  logic [2:0] select_2850;
  assign select_2850 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2851;
  assign difference_2851 = {1'b0, explained_2} - {1'b0, select_2850};
  logic [4:0] e;
  assign e = {difference_2851[3], difference_2851} + (equal_2100_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1044
  logic [5:0] sum_2854;
  assign sum_2854 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/patches.hpp:313
  logic and_2883;
  assign and_2883 = so_s3_q & (ends_cell_s3_q & (shift_2_s3_q[0] & (shift_2_s3_q[2:1] == 2'h3)));
  logic [7:0] select_2927;
  assign select_2927 = equal_1933_s3_q ? registration_slope_here_q : (so_s3_q ? slope : registration_slope_here_q);
  logic [10:0] select_2929;
  assign select_2929 = equal_1933_s3_q ? registration_expected_q : (so_s3_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2930;
  assign equal_2930 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:250
  logic and_2934;
  assign and_2934 = shift_2_s3_q[3] & less_2073_s3_q;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2938;
  assign sum_2938 = shift_2_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2940;
  assign difference_2940 = {sum_2938, shift_2_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:102
  logic [7:0] select_2941;
  assign select_2941 = less_2939_s3_q ? difference_2940 : {sum_2938, shift_2_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2942;
  assign select_2942 = ((shift_2_s3_q[13:11] == 3'h0) | (shift_2_s3_q[13:11] == 3'h4)) ? {sum_2938, shift_2_s3_q[11], 5'h0} : select_2941;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2942[7]}}, select_2942} - {sum_2090[9], sum_2090, sum_2086[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2945;
  assign select_2945 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2945[11:7])) ? 12'h7f : select_2945;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2966;
  assign difference_2966 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2968;
  assign and_2968 = and_2934 & ($signed(difference_2966) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2981;
  assign less_2981 = $signed(difference_2966) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/patches.hpp:313
  logic select_2989;
  assign select_2989 = so_s3_q ? (equal_2930 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_2992;
  assign select_2992 = so_s3_q ? (equal_2074 ? shift_2_s3_q[0] : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2997;
  assign select_2997 = (sum_1984 == 2'h2) ? (registration_fresh_q & (~select_2031)) : registration_fresh_q;
  // hls/stages/patches.hpp:313
  logic [3:0] select_2999;
  assign select_2999 = so_s3_q ? (and_2026 ? select_2997 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3001;
  assign select_3001 = and_2818 ? 4'hf : (equal_1933_s3_q ? registration_fresh_q : select_2999);
  // hls/stages/agreement.hpp:1071
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1981;
  // hls/stages/registration.hpp:258
  logic not_3022;
  assign not_3022 = ~quarter_2[1];
  logic [3:0] select_3023;
  assign select_3023 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3022, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3022};
  // hls/stages/patches.hpp:318
  logic not_3160;
  assign not_3160 = ~and_2144_s3_q;
  // hls/stages/patches.hpp:327
  logic not_3186;
  assign not_3186 = ~select_2063[1];
  // hls/stages/agreement.hpp:263
  logic [1:0] select_3188;
  assign select_3188 = sample_pair_whole_s3_q ? (equal_2064 ? select_2063 : {not_3186, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:462
  logic [55:0] other;
  assign other = new_row_s3_q ? patches_right_codes_rdata_q[55:0] : {patches_codes_high_q[3:0], patches_codes_low_q};
  // hls/stages/patches.hpp:160
  logic [51:0] select_3287;
  assign select_3287 = or_2152_s3_q ? {patches_codes_high_q[3:0], patches_codes_low_q[51:4]} : patches_codes_low_q;
  logic [51:0] select_3289;
  assign select_3289 = equal_2146_s3_q ? patches_codes_low_q : (equal_2148_s3_q ? other[55:4] : select_3287);
  // hls/stages/patches.hpp:462
  logic [55:0] select_3290;
  assign select_3290 = new_row_s3_q ? patches_right_codes_rdata_q[111:56] : {4'h0, patches_codes_high_q[55:4]};
  // hls/stages/patches.hpp:160
  logic [55:0] select_3291;
  assign select_3291 = or_2152_s3_q ? {less_2264_s3_q, less_2263_s3_q, less_2254_s3_q, less_2253_s3_q, patches_codes_high_q[55:4]} : patches_codes_high_q;
  logic [55:0] select_3293;
  assign select_3293 = equal_2146_s3_q ? patches_codes_high_q : (equal_2148_s3_q ? select_3290 : select_3291);
  // hls/stages/count_bits.hpp:24
  logic parity_3298;
  assign parity_3298 = ^{less_2264_s3_q, less_2263_s3_q, less_2254_s3_q, less_2253_s3_q};
  // hls/stages/count_bits.hpp:25
  logic or_3302;
  assign or_3302 = ({less_2254_s3_q, less_2253_s3_q} == 2'h3) | (less_2263_s3_q & (less_2254_s3_q | less_2253_s3_q));
  logic and_3303;
  assign and_3303 = less_2264_s3_q & (^{less_2263_s3_q, less_2254_s3_q, less_2253_s3_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3304;
  assign xor_3304 = or_3302 ^ and_3303;
  // hls/stages/count_bits.hpp:27
  logic and_3305;
  assign and_3305 = or_3302 & and_3303;
  // hls/stages/patches.hpp:448
  logic [2:0] select_3307;
  assign select_3307 = or_2279_s3_q ? 3'h0 : (patches_column_s3_q ? 3'h0 : {and_3305, xor_3304, parity_3298});
  // hls/stages/patches.hpp:160
  logic [2:0] select_3310;
  assign select_3310 = equal_2146_s3_q ? 3'h0 : (equal_2148_s3_q ? 3'h0 : (or_2152_s3_q ? select_3307 : 3'h0));
  // hls/stages/patches.hpp:143
  logic [9:0] sum_3312;
  assign sum_3312 = {7'h0, patches_set_q} + (equal_2150_s3_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:463
  logic [47:0] select_3322;
  assign select_3322 = new_row_s3_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:160
  logic [47:0] select_3324;
  assign select_3324 = equal_2146_s3_q ? patches_left_row_q : (equal_2148_s3_q ? select_3322 : patches_left_row_q);
  // hls/stages/patches.hpp:463
  logic [47:0] bits;
  assign bits = select_3322 ^ other[47:0];
  // hls/stages/count_bits.hpp:24
  logic xor_3328;
  assign xor_3328 = bits[17] ^ (^{select_3322[16:15], other[16:15]});
  logic xor_3331;
  assign xor_3331 = bits[11] ^ (^{select_3322[10:9], other[10:9]});
  logic xor_3334;
  assign xor_3334 = bits[14] ^ (^{select_3322[13:12], other[13:12]});
  logic xor_3337;
  assign xor_3337 = xor_3328 ^ (^{select_3322[14:9], other[14:9]});
  logic xor_3340;
  assign xor_3340 = bits[47] ^ (^{select_3322[46:45], other[46:45]});
  logic xor_3343;
  assign xor_3343 = bits[8] ^ (^{select_3322[7:6], other[7:6]});
  logic xor_3346;
  assign xor_3346 = bits[2] ^ (^{select_3322[1:0], other[1:0]});
  logic xor_3349;
  assign xor_3349 = bits[5] ^ (^{select_3322[4:3], other[4:3]});
  logic xor_3352;
  assign xor_3352 = xor_3343 ^ (^{select_3322[5:0], other[5:0]});
  logic parity_3354;
  assign parity_3354 = ^{select_3322[47:45], select_3322[8:0], other[47:45], other[8:0]};
  logic xor_3355;
  assign xor_3355 = xor_3337 ^ parity_3354;
  logic xor_3358;
  assign xor_3358 = bits[44] ^ (^{select_3322[43:42], other[43:42]});
  logic xor_3361;
  assign xor_3361 = bits[38] ^ (^{select_3322[37:36], other[37:36]});
  logic xor_3364;
  assign xor_3364 = bits[41] ^ (^{select_3322[40:39], other[40:39]});
  logic xor_3370;
  assign xor_3370 = bits[26] ^ (^{select_3322[25:24], other[25:24]});
  logic xor_3373;
  assign xor_3373 = bits[20] ^ (^{select_3322[19:18], other[19:18]});
  logic xor_3376;
  assign xor_3376 = bits[23] ^ (^{select_3322[22:21], other[22:21]});
  logic xor_3379;
  assign xor_3379 = xor_3370 ^ (^{select_3322[23:18], other[23:18]});
  logic xor_3382;
  assign xor_3382 = bits[35] ^ (^{select_3322[34:33], other[34:33]});
  logic xor_3385;
  assign xor_3385 = bits[29] ^ (^{select_3322[28:27], other[28:27]});
  logic xor_3388;
  assign xor_3388 = bits[32] ^ (^{select_3322[31:30], other[31:30]});
  logic xor_3391;
  assign xor_3391 = xor_3382 ^ (^{select_3322[32:27], other[32:27]});
  logic xor_3392;
  assign xor_3392 = xor_3379 ^ xor_3391;
  // hls/stages/count_bits.hpp:25
  logic or_3400;
  assign or_3400 = (xor_3331 & xor_3334) | (xor_3328 & (xor_3331 | xor_3334));
  logic or_3404;
  assign or_3404 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3408;
  assign or_3408 = (xor_3346 & xor_3349) | (xor_3343 & (xor_3346 | xor_3349));
  // hls/stages/count_bits.hpp:23
  logic or_3415;
  assign or_3415 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3419;
  assign or_3419 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3423;
  assign or_3423 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3426;
  assign parity_3426 = ^{or_3423, or_3419, or_3415};
  // hls/stages/count_bits.hpp:23
  logic or_3430;
  assign or_3430 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3434;
  assign or_3434 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3438;
  assign or_3438 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3441;
  assign parity_3441 = ^{or_3438, or_3434, or_3430};
  logic parity_3444;
  assign parity_3444 = ^{or_3438, or_3434, or_3430, or_3423, or_3419, or_3415, or_3408, or_3404, or_3400};
  // hls/stages/count_bits.hpp:23
  logic or_3448;
  assign or_3448 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3452;
  assign or_3452 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3456;
  assign or_3456 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3464;
  assign or_3464 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3468;
  assign or_3468 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3472;
  assign or_3472 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3475;
  assign parity_3475 = ^{or_3472, or_3468, or_3464};
  // hls/stages/count_bits.hpp:23
  logic or_3479;
  assign or_3479 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3483;
  assign or_3483 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3487;
  assign or_3487 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3490;
  assign parity_3490 = ^{or_3487, or_3483, or_3479};
  logic parity_3493;
  assign parity_3493 = ^{or_3487, or_3483, or_3479, or_3472, or_3468, or_3464, or_3456, or_3452, or_3448};
  // hls/stages/count_bits.hpp:25
  logic or_3497;
  assign or_3497 = (xor_3361 & xor_3364) | (xor_3358 & (xor_3361 | xor_3364));
  logic or_3501;
  assign or_3501 = (xor_3373 & xor_3376) | (xor_3370 & (xor_3373 | xor_3376));
  logic or_3505;
  assign or_3505 = (xor_3385 & xor_3388) | (xor_3382 & (xor_3385 | xor_3388));
  // hls/stages/count_bits.hpp:24
  logic parity_3508;
  assign parity_3508 = ^{or_3505, or_3501, or_3497};
  // hls/stages/count_bits.hpp:25
  logic and_3509;
  assign and_3509 = xor_3355 & (^{xor_3392, select_3322[44:36], other[44:36]});
  logic or_3513;
  assign or_3513 = (xor_3340 & xor_3352) | (xor_3337 & (xor_3340 | xor_3352));
  logic and_3516;
  assign and_3516 = (xor_3358 ^ (^{select_3322[41:36], other[41:36]})) & (xor_3379 | xor_3391);
  logic or_3517;
  assign or_3517 = (xor_3379 & xor_3391) | and_3516;
  // hls/stages/count_bits.hpp:24
  logic parity_3520;
  assign parity_3520 = ^{or_3517, or_3513, and_3509};
  logic parity_3523;
  assign parity_3523 = ^{or_3517, or_3513, and_3509, or_3505, or_3501, or_3497, or_3487, or_3483, or_3479, or_3472, or_3468, or_3464, or_3456, or_3452, or_3448};
  logic parity_3525;
  assign parity_3525 = ^{or_3517, or_3513, and_3509, or_3505, or_3501, or_3497, or_3487, or_3483, or_3479, or_3472, or_3468, or_3464, or_3456, or_3452, or_3448, or_3438, or_3434, or_3430, or_3423, or_3419, or_3415, or_3408, or_3404, or_3400};
  // hls/stages/count_bits.hpp:25
  logic and_3526;
  assign and_3526 = parity_3444 & parity_3523;
  logic or_3530;
  assign or_3530 = (parity_3426 & parity_3441) | ((^{or_3408, or_3404, or_3400}) & (parity_3426 | parity_3441));
  logic or_3534;
  assign or_3534 = (parity_3508 & parity_3520) | (parity_3493 & (parity_3508 | parity_3520));
  logic or_3541;
  assign or_3541 = (parity_3475 & parity_3490) | ((^{or_3456, or_3452, or_3448}) & (parity_3475 | parity_3490));
  logic or_3545;
  assign or_3545 = (or_3501 & or_3505) | (or_3497 & (or_3501 | or_3505));
  logic or_3549;
  assign or_3549 = (or_3513 & or_3517) | (and_3509 & (or_3513 | or_3517));
  // hls/stages/count_bits.hpp:23
  logic or_3556;
  assign or_3556 = (or_3452 & or_3456) | (or_3448 & (or_3452 | or_3456));
  // hls/stages/count_bits.hpp:25
  logic or_3560;
  assign or_3560 = (or_3468 & or_3472) | (or_3464 & (or_3468 | or_3472));
  logic or_3564;
  assign or_3564 = (or_3483 & or_3487) | (or_3479 & (or_3483 | or_3487));
  // hls/stages/count_bits.hpp:24
  logic parity_3567;
  assign parity_3567 = ^{or_3564, or_3560, or_3556};
  // hls/stages/count_bits.hpp:23
  logic or_3571;
  assign or_3571 = (or_3404 & or_3408) | (or_3400 & (or_3404 | or_3408));
  // hls/stages/count_bits.hpp:25
  logic or_3575;
  assign or_3575 = (or_3419 & or_3423) | (or_3415 & (or_3419 | or_3423));
  logic or_3579;
  assign or_3579 = (or_3434 & or_3438) | (or_3430 & (or_3434 | or_3438));
  // hls/stages/count_bits.hpp:24
  logic parity_3582;
  assign parity_3582 = ^{or_3579, or_3575, or_3571};
  logic parity_3585;
  assign parity_3585 = ^{or_3579, or_3575, or_3571, or_3564, or_3560, or_3556, or_3549, or_3545, or_3541};
  logic parity_3587;
  assign parity_3587 = ^{or_3579, or_3575, or_3571, or_3564, or_3560, or_3556, or_3549, or_3545, or_3541, or_3534, or_3530, and_3526};
  // hls/stages/count_bits.hpp:25
  logic or_3591;
  assign or_3591 = (or_3545 & or_3549) | (or_3541 & (or_3545 | or_3549));
  logic or_3595;
  assign or_3595 = (or_3560 & or_3564) | (or_3556 & (or_3560 | or_3564));
  logic or_3599;
  assign or_3599 = (or_3575 & or_3579) | (or_3571 & (or_3575 | or_3579));
  // hls/stages/count_bits.hpp:24
  logic parity_3602;
  assign parity_3602 = ^{or_3599, or_3595, or_3591};
  // hls/stages/count_bits.hpp:25
  logic and_3603;
  assign and_3603 = (^{or_3534, or_3530, and_3526}) & parity_3585;
  logic or_3607;
  assign or_3607 = (or_3530 & or_3534) | (and_3526 & (or_3530 | or_3534));
  logic or_3611;
  assign or_3611 = (parity_3567 & parity_3582) | ((^{or_3549, or_3545, or_3541}) & (parity_3567 | parity_3582));
  // hls/stages/count_bits.hpp:24
  logic parity_3614;
  assign parity_3614 = ^{or_3611, or_3607, and_3603};
  // hls/stages/count_bits.hpp:25
  logic and_3616;
  assign and_3616 = parity_3602 & parity_3614;
  logic or_3620;
  assign or_3620 = (or_3595 & or_3599) | (or_3591 & (or_3595 | or_3599));
  logic or_3624;
  assign or_3624 = (or_3607 & or_3611) | (and_3603 & (or_3607 | or_3611));
  // hls/stages/patches.hpp:160
  logic select_3672;
  assign select_3672 = equal_2146_s3_q ? patches_summed_first_q : (equal_2148_s3_q ? new_row_s3_q : patches_summed_first_q);
  // hls/stages/patches.hpp:495
  logic [9:0] select_3679;
  assign select_3679 = less_2288_s3_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:499
  logic [9:0] select_3682;
  assign select_3682 = equal_2291_s3_q ? (less_2288_s3_q ? (equal_2291_s3_q ? 10'h0 : select_3679) : 10'h0) : select_3679;
  logic [9:0] select_3684;
  assign select_3684 = less_2288_s3_q ? (equal_2289_s3_q ? 10'h0 : select_3682) : select_3682;
  // hls/stages/patches.hpp:495
  logic [4:0] select_3686;
  assign select_3686 = less_2288_s3_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:499
  logic [4:0] select_3689;
  assign select_3689 = equal_2291_s3_q ? (less_2288_s3_q ? (equal_2291_s3_q ? 5'h0 : select_3686) : 5'h0) : select_3686;
  logic [4:0] select_3691;
  assign select_3691 = less_2288_s3_q ? (equal_2289_s3_q ? 5'h0 : select_3689) : select_3689;
  // hls/stages/patches.hpp:495
  logic [4:0] select_3693;
  assign select_3693 = less_2288_s3_q ? patches_step_s3_q : 5'h0;
  // hls/stages/patches.hpp:499
  logic [4:0] select_3696;
  assign select_3696 = equal_2291_s3_q ? (less_2288_s3_q ? (equal_2291_s3_q ? 5'h0 : select_3693) : 5'h0) : select_3693;
  logic [4:0] select_3698;
  assign select_3698 = less_2288_s3_q ? (equal_2289_s3_q ? 5'h0 : select_3696) : select_3696;
  // hls/stages/patches.hpp:495
  logic and_3701;
  assign and_3701 = less_2288_s3_q & (patches_step_s3_q == 5'h0);
  // hls/stages/patches.hpp:499
  logic select_3704;
  assign select_3704 = equal_2291_s3_q ? (less_2288_s3_q ? (not_2292_s3_q & and_3701) : and_3701) : and_3701;
  // hls/stages/patches.hpp:160
  logic select_3707;
  assign select_3707 = equal_2146_s3_q ? (less_2288_s3_q ? (not_2290_s3_q & select_3704) : select_3704) : patches_read_first_q;
  // hls/stages/patches.hpp:154
  logic or_3718;
  assign or_3718 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3719;
  assign and_3719 = patches_read_searches_s3_q & or_3718;
  // hls/stages/patches.hpp:479
  logic [4:0] select_3720;
  assign select_3720 = and_3719 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:486
  logic [5:0] away;
  assign away = {1'b0, patches_step_s3_q} - {1'b0, select_3720};
  // hls/stages/patches.hpp:495
  logic and_3724;
  assign and_3724 = less_2288_s3_q & (equal_3716_s3_q & (away == 6'h3f));
  // hls/stages/patches.hpp:499
  logic select_3727;
  assign select_3727 = equal_2291_s3_q ? (less_2288_s3_q ? (not_2292_s3_q & and_3724) : and_3724) : and_3724;
  // hls/stages/patches.hpp:160
  logic select_3730;
  assign select_3730 = equal_2146_s3_q ? (less_2288_s3_q ? (not_2290_s3_q & select_3727) : select_3727) : patches_read_above_q;
  // hls/stages/patches.hpp:495
  logic and_3733;
  assign and_3733 = less_2288_s3_q & (equal_3716_s3_q & (away == 6'h1));
  // hls/stages/patches.hpp:499
  logic select_3736;
  assign select_3736 = equal_2291_s3_q ? (less_2288_s3_q ? (not_2292_s3_q & and_3733) : and_3733) : and_3733;
  // hls/stages/patches.hpp:160
  logic select_3739;
  assign select_3739 = equal_2146_s3_q ? (less_2288_s3_q ? (not_2290_s3_q & select_3736) : select_3736) : patches_read_below_q;
  // hls/stages/patches.hpp:492
  logic [6:0] sum_3740;
  assign sum_3740 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:493
  logic [9:0] select_3743;
  assign select_3743 = (equal_3716_s3_q & ({sum_3740[6], sum_3740} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:495
  logic [9:0] select_3744;
  assign select_3744 = less_2288_s3_q ? select_3743 : 10'h3ff;
  // hls/stages/patches.hpp:496
  logic [9:0] select_3746;
  assign select_3746 = less_2288_s3_q ? (equal_2291_s3_q ? 10'h3ff : select_3744) : 10'h3ff;
  // hls/stages/patches.hpp:499
  logic [9:0] select_3747;
  assign select_3747 = equal_2291_s3_q ? select_3746 : select_3744;
  logic [9:0] select_3749;
  assign select_3749 = less_2288_s3_q ? (equal_2289_s3_q ? 10'h3ff : select_3747) : select_3747;
  // hls/stages/patches.hpp:478
  logic [14:0] select_3751;
  assign select_3751 = and_3719 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:160
  logic [9:0] select_3752;
  assign select_3752 = equal_2146_s3_q ? select_3751[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3753;
  assign select_3753 = equal_2146_s3_q ? select_3751[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:480
  logic [9:0] select_3755;
  assign select_3755 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:481
  logic [9:0] select_3757;
  assign select_3757 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:482
  logic [9:0] select_3760;
  assign select_3760 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3761;
  assign select_3761 = patches_read_first_q ? patches_read_far_q : select_3760;
  // hls/stages/patches.hpp:533
  logic [9:0] difference_3764;
  assign difference_3764 = select_3761 - select_3751[9:0];
  // hls/stages/patches.hpp:518
  logic less_3794;
  assign less_3794 = select_3755 < select_3757;
  // hls/stages/patches.hpp:524
  logic [1:0] sum_3795;
  assign sum_3795 = select_3720[4:3] + 2'h3;
  // hls/stages/patches.hpp:519
  logic [9:0] high;
  assign high = less_3794 ? select_3757 : select_3755;
  logic [9:0] low;
  assign low = (select_3757 < select_3755) ? select_3757 : select_3755;
  // hls/stages/patches.hpp:520
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall;
  assign fall = high - select_3751[9:0];
  // hls/stages/patches.hpp:522
  logic not_3802;
  assign not_3802 = ~({eight, 3'h0} < {3'h0, fall});
  logic [10:0] sum_3803;
  assign sum_3803 = {1'b0, fall} + {2'h0, fall[9:1]};
  logic not_3805;
  assign not_3805 = ~({eight, 3'h0} < {1'b0, sum_3803, fall[0]});
  logic [1:0] sum_3806;
  assign sum_3806 = {1'b0, not_3802} + {1'b0, not_3805};
  // hls/stages/patches.hpp:523
  logic [10:0] sum_3807;
  assign sum_3807 = {1'b0, fall} + {3'h0, fall[9:2]};
  logic not_3809;
  assign not_3809 = ~({eight, 3'h0} < {sum_3807, fall[1:0]});
  logic not_3812;
  assign not_3812 = ~({eight, 3'h0} < ({fall, 3'h0} - {3'h0, fall}));
  logic [1:0] sum_3813;
  assign sum_3813 = {1'b0, not_3809} + {1'b0, not_3812};
  // hls/stages/patches.hpp:522
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3806} + {1'b0, sum_3813};
  // hls/stages/patches.hpp:525
  logic [7:0] select_3816;
  assign select_3816 = less_3794 ? ({sum_3795, select_3720[2:0], 3'h0} - {5'h0, fraction}) : {sum_3795, select_3720[2:0], fraction};
  // hls/stages/agreement.hpp:1086
  logic equal_3972;
  assign equal_3972 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/patches.hpp:313
  logic select_3988;
  assign select_3988 = equal_1933_s3_q ? shown_shown_q : (so_s3_q ? select_2346 : shown_shown_q);
  logic select_3990;
  assign select_3990 = equal_1933_s3_q ? shown_nearer_q : (so_s3_q ? select_2349 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3992;
  assign sum_3992 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:447
  logic [2:0] select_3994;
  assign select_3994 = less_3991_s3_q ? (sum_3992[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3996;
  assign select_3996 = equal_2721_s3_q ? (equal_552_s3_q ? 3'h0 : select_3994) : region_row_q;
  // hls/stages/patches.hpp:313
  logic [7:0] select_4001;
  assign select_4001 = equal_1933_s3_q ? select_2306 : (so_s3_q ? (ends_cell_s3_q ? select_2398 : select_2306) : 8'h1);
  // hls/stages/agreement.hpp:447
  logic [8:0] select_4015;
  assign select_4015 = equal_552_s3_q ? {{2{difference_4013[6]}}, difference_4013} : (less_3991_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:507
  logic [8:0] select_4017;
  assign select_4017 = and_491_s3_q ? (equal_2721_s3_q ? select_4015 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:447
  logic [6:0] select_4019;
  assign select_4019 = equal_552_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_4021;
  assign select_4021 = and_491_s3_q ? (equal_2721_s3_q ? select_4019 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4022;
  assign sum_4022 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4023;
  assign select_4023 = sum_3992[7] ? {1'b1, sum_3992[6:0], region_down_rest_q[0]} : sum_4022;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3992[7];
  // hls/stages/agreement.hpp:447
  logic select_4027;
  assign select_4027 = equal_2721_s3_q ? (equal_552_s3_q | (less_3991_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:197
  logic or_4032;
  assign or_4032 = segment_starts_q | not_1973;
  // hls/stages/agreement.hpp:976
  logic select_4035;
  assign select_4035 = shift_2_s3_q[0] ? (sum_2319_s3_q ? (equal_2139_s3_q & or_2321) : or_2321) : or_4032;
  // hls/stages/patches.hpp:313
  logic select_4038;
  assign select_4038 = equal_1933_s3_q ? or_4032 : (so_s3_q ? (ends_cell_s3_q ? select_4035 : or_4032) : or_4032);
  logic [2:0] select_4112;
  assign select_4112 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_4114;
  assign select_4114 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4116;
  assign select_4116 = equal_1933_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4114 : box_textured_columns_values_1_q);
  logic [2:0] select_4117;
  assign select_4117 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4119;
  assign select_4119 = equal_1933_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4117 : box_textured_columns_values_2_q);
  logic [2:0] select_4120;
  assign select_4120 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4122;
  assign select_4122 = equal_1933_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4120 : box_textured_columns_values_3_q);
  logic [2:0] select_4123;
  assign select_4123 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4125;
  assign select_4125 = equal_1933_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4123 : box_textured_columns_values_4_q);
  logic [4:0] select_4127;
  assign select_4127 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4130;
  assign select_4130 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_4132;
  assign select_4132 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4134;
  assign select_4134 = equal_1933_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4132 : box_explained_columns_values_1_q);
  logic [2:0] select_4135;
  assign select_4135 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4137;
  assign select_4137 = equal_1933_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4135 : box_explained_columns_values_2_q);
  logic [2:0] select_4138;
  assign select_4138 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4140;
  assign select_4140 = equal_1933_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4138 : box_explained_columns_values_3_q);
  logic [2:0] select_4141;
  assign select_4141 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4143;
  assign select_4143 = equal_1933_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4141 : box_explained_columns_values_4_q);
  logic [4:0] select_4145;
  assign select_4145 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_4146;
  assign select_4146 = equal_1933_s3_q ? box_explained_sum_sums_values_0_q : select_4145;
  logic [2:0] select_4148;
  assign select_4148 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4150;
  assign select_4150 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4152;
  assign select_4152 = equal_1933_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4150 : box_shown_columns_values_1_q);
  logic [2:0] select_4153;
  assign select_4153 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4155;
  assign select_4155 = equal_1933_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4153 : box_shown_columns_values_2_q);
  logic [2:0] select_4156;
  assign select_4156 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4158;
  assign select_4158 = equal_1933_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4156 : box_shown_columns_values_3_q);
  logic [2:0] select_4159;
  assign select_4159 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4161;
  assign select_4161 = equal_1933_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4159 : box_shown_columns_values_4_q);
  logic [4:0] select_4163;
  assign select_4163 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4166;
  assign select_4166 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4168;
  assign select_4168 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4170;
  assign select_4170 = equal_1933_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4168 : box_nearer_columns_values_1_q);
  logic [2:0] select_4171;
  assign select_4171 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4173;
  assign select_4173 = equal_1933_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4171 : box_nearer_columns_values_2_q);
  logic [2:0] select_4174;
  assign select_4174 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4176;
  assign select_4176 = equal_1933_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4174 : box_nearer_columns_values_3_q);
  logic [2:0] select_4177;
  assign select_4177 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4179;
  assign select_4179 = equal_1933_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4177 : box_nearer_columns_values_4_q);
  logic [4:0] select_4181;
  assign select_4181 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_4184;
  assign select_4184 = so_s3_q ? (ends_cell_s3_q ? and_2386 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4187;
  assign select_4187 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & shift_2_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_4189;
  assign select_4189 = equal_1933_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_4187 : centres_values_0_of_skin_q);
  logic select_4190;
  assign select_4190 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4192;
  assign select_4192 = equal_1933_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_4190 : centres_values_1_textured_q);
  logic select_4193;
  assign select_4193 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4195;
  assign select_4195 = equal_1933_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_4193 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:447
  logic [12:0] select_4199;
  assign select_4199 = equal_2721_s3_q ? (equal_4196_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:507
  logic [6:0] select_4202;
  assign select_4202 = and_491_s3_q ? (equal_2721_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1226
  logic [2:0] select_4213;
  assign select_4213 = select_2358 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:422
  logic [7:0] select_4219;
  assign select_4219 = marks_first_s3_q ? (less_4215 ? {sum_4216, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1234
  logic and_4225;
  assign and_4225 = and_2457_s3_q & ({sum_2383, index_2[5:0]} == {sum_2370, index[5:0]});
  // hls/stages/registration.hpp:258
  logic not_4278;
  assign not_4278 = ~quarter[1];
  logic [3:0] select_4279;
  assign select_4279 = quarter[0] ? {quarter[1], 1'b0, not_4278, 1'b0} : {1'b0, quarter[1], 1'b0, not_4278};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1985;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & select_2028;
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:685; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [23:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 24'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_2062;
  logic patches_choices_re;
  assign patches_choices_re = s3_en & (sample_pair_whole_s3_q & (~equal_2064));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1318; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2316;
  logic regions_re;
  assign regions_re = s3_en & (equal_1933_s3_q ? (x_s3_q[6] & not_2317) : and_2324);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1329; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2370, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_2377 & less_2378);
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
  assign averager_memory_waddr = select_461_s3_q;
  logic averager_memory_we;
  assign averager_memory_we = s3_en & and_466_s3_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_485, and_481, sum_477, sum_473};
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
  assign census_memory_we = s3_en & and_491_s3_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_509, whole_2, select_501, select_497};
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
  assign shown_right_waddr = select_1972_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1977_s3_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_1974, not_1973};
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
  assign patches_right_codes_waddr = {sum_2244, patches_code_row_s3_q[1:0]};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s3_en & and_2275_s3_q;
  logic [111:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {less_2264_s3_q, less_2263_s3_q, less_2254_s3_q, less_2253_s3_q, patches_codes_high_q, patches_codes_low_q};
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
  assign patches_left_codes_waddr = {sum_2277, patches_code_row_s3_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s3_en & and_2287_s3_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {less_2264_s3_q, less_2263_s3_q, less_2254_s3_q, less_2253_s3_q, patches_codes_high_q[55:12]};
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
  assign seen_columns_we = s3_en & and_1968_s3_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2345, textured_s3_q};
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
      averager_running_of_skin_q <= select_2510;
      averager_mask_q <= select_2512;
      averager_of_skin_q <= select_2514;
      census_filled_q <= and_491_s3_q ? {select_555[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_491_s3_q ? select_554 : rows_passed_above_q;
      registration_slope_here_q <= select_2927;
      registration_expected_q <= select_2929;
      registration_of_right_q <= equal_1933_s3_q ? registration_of_right_q : select_2989;
      registration_was_inside_q <= equal_1933_s3_q ? registration_was_inside_q : select_2992;
      registration_fresh_q <= select_3001;
      patches_fixed_q <= not_3160 & (patches_fixed_q | (and_3170_s3_q & and_2119));
      patches_choice_valid_q <= and_2144_s3_q ? (select_2138[0] & not_3160) : select_2138[0];
      patches_choice_column_q <= select_2138[8:1];
      patches_choice_shift_q <= select_2138[14:9];
      patches_choice_slope_q <= select_2138[22:15];
      patches_band_q <= sample_pair_whole_s3_q ? select_2159 : patches_band_q;
      patches_fetch_q <= select_3188;
      patches_codes_low_q <= select_3289;
      patches_codes_high_q <= select_3293;
      patches_set_q <= select_3310;
      patches_size_q <= sum_3312;
      patches_left_row_q <= select_3324;
      patches_summed_first_q <= select_3672;
      patches_read_row_differing_q <= equal_2146_s3_q ? select_3684 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2146_s3_q ? select_3691 : patches_read_row_column_q;
      patches_read_at_q <= equal_2146_s3_q ? select_3698 : patches_read_at_q;
      patches_read_first_q <= select_3707;
      patches_read_above_q <= select_3730;
      patches_read_below_q <= select_3739;
      patches_read_far_q <= equal_2146_s3_q ? select_3749 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3752;
      patches_peak_best_column_q <= select_3753;
      patches_peak_row_q <= equal_2146_s3_q ? select_3720 : patches_peak_row_q;
      patches_peak_above_q <= equal_2146_s3_q ? select_3755 : patches_peak_above_q;
      patches_peak_below_q <= equal_2146_s3_q ? select_3757 : patches_peak_below_q;
      patches_peak_far_q <= equal_2146_s3_q ? select_3761 : patches_peak_far_q;
      shown_shown_q <= select_3988;
      shown_nearer_q <= select_3990;
      region_row_q <= and_491_s3_q ? select_3996 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4001;
      region_down_rest_q <= select_4017;
      region_down_back_q <= select_4021;
      region_down_next_q <= select_4023;
      region_fresh_q <= and_491_s3_q ? select_4027 : region_fresh_q;
      segment_starts_q <= select_4038;
      centres_values_0_textured_q <= equal_1933_s3_q ? centres_values_0_textured_q : select_4184;
      centres_values_0_of_skin_q <= select_4189;
      centres_values_1_textured_q <= select_4192;
      centres_values_1_of_skin_q <= select_4195;
      map_row_q <= and_491_s3_q ? select_4199 : map_row_q;
      map_width_q <= select_4202;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2369;
      done_q <= not_2371 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      drew_q <= so_s3_q;
      said_q <= equal_1933_s3_q & equal_3972;
      rows_passed_q <= select_2354;
      columns_passed_q <= {select_2356[7:0], or_2352};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_2373;
      seen_x_q <= select_2375;
      seen_y_q <= marks_first_s3_q ? 3'h0 : select_4213;
      seen_column_q <= select_2366;
      seen_rows_left_q <= select_4219;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2363;
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
      averager_running_0_q <= sample_pair_whole_s3_q ? select_469 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s3_q ? sum_475 : averager_running_1_q;
      averager_total_0_q <= select_2489;
      averager_total_1_q <= select_2491;
      census_columns_values_0_cell_0_left_q <= select_2515;
      census_columns_values_0_cell_0_right_q <= select_2516;
      census_columns_values_0_cell_0_mask_q <= and_491_s3_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2518;
      census_columns_values_0_cell_1_right_q <= select_2519;
      census_columns_values_0_cell_1_mask_q <= select_2520;
      census_columns_values_0_cell_2_left_q <= select_2521;
      census_columns_values_0_cell_2_right_q <= select_2522;
      census_columns_values_0_cell_2_mask_q <= select_2523;
      census_columns_values_0_cell_2_of_skin_q <= select_2524;
      census_columns_values_0_cell_3_left_q <= select_2525;
      census_columns_values_0_cell_3_right_q <= select_2526;
      census_columns_values_0_cell_3_mask_q <= select_2527;
      census_columns_values_0_cell_4_left_q <= select_2528;
      census_columns_values_0_cell_4_right_q <= select_2529;
      census_columns_values_0_cell_4_mask_q <= select_2530;
      census_columns_values_1_cell_0_left_q <= select_2531;
      census_columns_values_1_cell_0_right_q <= select_2532;
      census_columns_values_1_cell_0_mask_q <= select_2533;
      census_columns_values_1_cell_1_left_q <= select_2534;
      census_columns_values_1_cell_1_right_q <= select_2535;
      census_columns_values_1_cell_1_mask_q <= select_2536;
      census_columns_values_1_cell_2_left_q <= select_2537;
      census_columns_values_1_cell_2_right_q <= select_2538;
      census_columns_values_1_cell_2_mask_q <= select_2539;
      census_columns_values_1_cell_2_of_skin_q <= select_2540;
      census_columns_values_1_cell_3_left_q <= select_2541;
      census_columns_values_1_cell_3_right_q <= select_2542;
      census_columns_values_1_cell_3_mask_q <= select_2543;
      census_columns_values_1_cell_4_left_q <= select_2544;
      census_columns_values_1_cell_4_right_q <= select_2545;
      census_columns_values_1_cell_4_mask_q <= select_2546;
      census_columns_values_2_cell_0_left_q <= select_2547;
      census_columns_values_2_cell_0_right_q <= select_2548;
      census_columns_values_2_cell_0_mask_q <= select_2549;
      census_columns_values_2_cell_1_left_q <= select_2550;
      census_columns_values_2_cell_1_right_q <= select_2551;
      census_columns_values_2_cell_1_mask_q <= select_2552;
      census_columns_values_2_cell_2_left_q <= select_2553;
      census_columns_values_2_cell_2_right_q <= select_2554;
      census_columns_values_2_cell_2_mask_q <= select_2555;
      census_columns_values_2_cell_3_left_q <= select_2556;
      census_columns_values_2_cell_3_right_q <= select_2557;
      census_columns_values_2_cell_3_mask_q <= select_2558;
      census_columns_values_2_cell_4_left_q <= select_2559;
      census_columns_values_2_cell_4_right_q <= select_2560;
      census_columns_values_2_cell_4_mask_q <= select_2561;
      census_columns_values_3_cell_0_mask_q <= select_2562;
      census_columns_values_3_cell_1_left_q <= select_2563;
      census_columns_values_3_cell_1_right_q <= select_2564;
      census_columns_values_3_cell_1_mask_q <= select_2565;
      census_columns_values_3_cell_2_mask_q <= select_2566;
      census_columns_values_3_cell_3_left_q <= select_2567;
      census_columns_values_3_cell_3_right_q <= select_2568;
      census_columns_values_3_cell_3_mask_q <= select_2569;
      census_columns_values_3_cell_4_mask_q <= select_2570;
      sharpness_last_mean_0_q <= and_491_s3_q ? select_497 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_491_s3_q ? select_501 : sharpness_last_mean_1_q;
      box_textured_columns_values_0_q <= equal_1933_s3_q ? box_textured_columns_values_0_q : select_4112;
      box_textured_columns_values_1_q <= select_4116;
      box_textured_columns_values_2_q <= select_4119;
      box_textured_columns_values_3_q <= select_4122;
      box_textured_columns_values_4_q <= select_4125;
      box_textured_sum_sums_values_0_q <= equal_1933_s3_q ? box_textured_sum_sums_values_0_q : select_4127;
      box_explained_columns_values_0_q <= equal_1933_s3_q ? box_explained_columns_values_0_q : select_4130;
      box_explained_columns_values_1_q <= select_4134;
      box_explained_columns_values_2_q <= select_4137;
      box_explained_columns_values_3_q <= select_4140;
      box_explained_columns_values_4_q <= select_4143;
      box_explained_sum_sums_values_0_q <= select_4146;
      box_shown_columns_values_0_q <= equal_1933_s3_q ? box_shown_columns_values_0_q : select_4148;
      box_shown_columns_values_1_q <= select_4152;
      box_shown_columns_values_2_q <= select_4155;
      box_shown_columns_values_3_q <= select_4158;
      box_shown_columns_values_4_q <= select_4161;
      box_shown_sum_sums_values_0_q <= equal_1933_s3_q ? box_shown_sum_sums_values_0_q : select_4163;
      box_nearer_columns_values_0_q <= equal_1933_s3_q ? box_nearer_columns_values_0_q : select_4166;
      box_nearer_columns_values_1_q <= select_4170;
      box_nearer_columns_values_2_q <= select_4173;
      box_nearer_columns_values_3_q <= select_4176;
      box_nearer_columns_values_4_q <= select_4179;
      box_nearer_sum_sums_values_0_q <= equal_1933_s3_q ? box_nearer_sum_sums_values_0_q : select_4181;
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
  logic [2:0] select_455_s4_q;
  logic [6:0] select_457_s4_q;
  logic [6:0] column_s4_q;
  logic and_489_s4_q;
  logic and_491_s4_q;
  logic [8:0] grey_s4_q;
  logic equal_494_s4_q;
  logic [8:0] grey_2_s4_q;
  logic whole_2_s4_q;
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
  logic less_546_s4_q;
  logic less_547_s4_q;
  logic less_548_s4_q;
  logic and_556_s4_q;
  logic and_581_s4_q;
  logic and_582_s4_q;
  logic [11:0] sum_597_s4_q;
  logic [9:0] sum_600_s4_q;
  logic equal_1933_s4_q;
  logic not_1934_s4_q;
  logic equal_1978_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1984_s4_q;
  logic equal_1986_s4_q;
  logic equal_1988_s4_q;
  logic equal_1990_s4_q;
  logic equal_1992_s4_q;
  logic equal_1994_s4_q;
  logic equal_1996_s4_q;
  logic equal_1998_s4_q;
  logic equal_2000_s4_q;
  logic less_2009_s4_q;
  logic or_2013_s4_q;
  logic equal_2033_s4_q;
  logic and_2043_s4_q;
  logic and_2046_s4_q;
  logic select_2063_s4_q;
  logic equal_2064_s4_q;
  logic and_2072_s4_q;
  logic equal_2074_s4_q;
  logic select_2138_s4_q;
  logic and_2145_s4_q;
  logic equal_2146_s4_q;
  logic equal_2148_s4_q;
  logic and_2161_s4_q;
  logic [4:0] select_2176_s4_q;
  logic select_2182_s4_q;
  logic [3:0] select_2223_s4_q;
  logic less_2288_s4_q;
  logic equal_2289_s4_q;
  logic not_2290_s4_q;
  logic equal_2291_s4_q;
  logic or_2309_s4_q;
  logic or_2312_s4_q;
  logic or_2315_s4_q;
  logic not_2317_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_2338_s4_q;
  logic and_2343_s4_q;
  logic and_2377_s4_q;
  logic less_2378_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_2383_s4_q;
  logic equal_2396_s4_q;
  logic or_2401_s4_q;
  logic or_2404_s4_q;
  logic or_2407_s4_q;
  logic not_2432_s4_q;
  logic less_2446_s4_q;
  logic and_2457_s4_q;
  logic [11:0] sum_2586_s4_q;
  logic [9:0] sum_2589_s4_q;
  logic equal_2597_s4_q;
  logic [8:0] contrast_s4_q;
  logic [8:0] contrast_2_s4_q;
  logic and_2818_s4_q;
  logic and_2822_s4_q;
  logic not_2856_s4_q;
  logic and_2884_s4_q;
  logic and_2933_s4_q;
  logic and_2934_s4_q;
  logic [7:0] residual_s4_q;
  logic and_2968_s4_q;
  logic and_2982_s4_q;
  logic equal_3025_s4_q;
  logic parity_3396_s4_q;
  logic parity_3525_s4_q;
  logic parity_3587_s4_q;
  logic xor_3615_s4_q;
  logic parity_3627_s4_q;
  logic or_3631_s4_q;
  logic equal_3632_s4_q;
  logic [4:0] select_3751_s4_q;
  logic equal_3763_s4_q;
  logic less_3765_s4_q;
  logic less_3766_s4_q;
  logic or_3771_s4_q;
  logic [7:0] select_3816_s4_q;
  logic equal_3972_s4_q;
  logic and_4225_s4_q;
  logic and_4240_s4_q;
  logic equal_4281_s4_q;
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
      select_455_s4_q <= select_455_s3_q;
      select_457_s4_q <= select_457_s3_q;
      column_s4_q <= column_s3_q;
      and_489_s4_q <= and_489_s3_q;
      and_491_s4_q <= and_491_s3_q;
      grey_s4_q <= grey;
      equal_494_s4_q <= equal_494;
      grey_2_s4_q <= grey_2;
      whole_2_s4_q <= whole_2;
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
      less_546_s4_q <= less_546;
      less_547_s4_q <= less_547;
      less_548_s4_q <= less_548;
      and_556_s4_q <= and_556;
      and_581_s4_q <= whole_22 & and_556;
      and_582_s4_q <= census_columns_values_1_cell_2_mask_q & and_556;
      sum_597_s4_q <= {1'b0, sum_593} + {2'h0, sum_596};
      sum_600_s4_q <= {9'h0, difference_598[9]} + {1'b0, xor_599};
      equal_1933_s4_q <= equal_1933_s3_q;
      not_1934_s4_q <= not_1934_s3_q;
      equal_1978_s4_q <= equal_1978;
      all_s4_q <= all;
      sum_1984_s4_q <= sum_1984;
      equal_1986_s4_q <= equal_1986;
      equal_1988_s4_q <= equal_1988;
      equal_1990_s4_q <= equal_1990;
      equal_1992_s4_q <= equal_1992;
      equal_1994_s4_q <= equal_1994;
      equal_1996_s4_q <= equal_1996;
      equal_1998_s4_q <= equal_1998;
      equal_2000_s4_q <= equal_2000;
      less_2009_s4_q <= less_2009;
      or_2013_s4_q <= or_2013;
      equal_2033_s4_q <= (registration_fresh_q & select_2031) == 4'h0;
      and_2043_s4_q <= not_1934_s3_q & and_2027;
      and_2046_s4_q <= and_2046_s3_q;
      select_2063_s4_q <= select_2063[1];
      equal_2064_s4_q <= equal_2064;
      and_2072_s4_q <= and_2072_s3_q;
      equal_2074_s4_q <= equal_2074;
      select_2138_s4_q <= select_2138[0];
      and_2145_s4_q <= and_2145_s3_q;
      equal_2146_s4_q <= equal_2146_s3_q;
      equal_2148_s4_q <= equal_2148_s3_q;
      and_2161_s4_q <= and_2145_s3_q & equal_2160;
      select_2176_s4_q <= select_2176_s3_q;
      select_2182_s4_q <= select_2182_s3_q;
      select_2223_s4_q <= select_2223_s3_q;
      less_2288_s4_q <= less_2288_s3_q;
      equal_2289_s4_q <= equal_2289_s3_q;
      not_2290_s4_q <= not_2290_s3_q;
      equal_2291_s4_q <= equal_2291_s3_q;
      or_2309_s4_q <= or_2309;
      or_2312_s4_q <= or_2312;
      or_2315_s4_q <= or_2315;
      not_2317_s4_q <= not_2317;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_2338_s4_q <= shift_2_s3_q[0] & ({shift_2_s3_q[4], shift_2_s3_q[2]} == 2'h3);
      and_2343_s4_q <= not_1934_s3_q & and_2324;
      and_2377_s4_q <= and_2377;
      less_2378_s4_q <= less_2378;
      index_2_s4_q <= index_2[5:0];
      sum_2383_s4_q <= sum_2383;
      equal_2396_s4_q <= t[4:1] == 4'h0;
      or_2401_s4_q <= or_2401;
      or_2404_s4_q <= select_2398[7] | (~({select_2398[6], select_2398[3:2]} == 3'h0));
      or_2407_s4_q <= select_2398[7] | (~(select_2398[6:4] == 3'h0));
      not_2432_s4_q <= ~({sum_2430, around[0]} < {2'h0, t});
      less_2446_s4_q <= {1'b0, around[4:1]} < n;
      and_2457_s4_q <= and_2457_s3_q;
      sum_2586_s4_q <= {1'b0, sum_2582} + {2'h0, sum_2585};
      sum_2589_s4_q <= {9'h0, difference_2587[9]} + {1'b0, xor_2588};
      equal_2597_s4_q <= equal_2597_s3_q;
      contrast_s4_q <= contrast;
      contrast_2_s4_q <= contrast_2;
      and_2818_s4_q <= and_2818;
      and_2822_s4_q <= and_2822;
      not_2856_s4_q <= ~({sum_2854, e[0]} < {2'h0, t});
      and_2884_s4_q <= not_1934_s3_q & and_2883;
      and_2933_s4_q <= not_1934_s3_q & (so_s3_q & (half_ends & equal_2930));
      and_2934_s4_q <= and_2934;
      residual_s4_q <= residual[7:0];
      and_2968_s4_q <= and_2968;
      and_2982_s4_q <= and_2934 & less_2981;
      equal_3025_s4_q <= (registration_fresh_q & select_3023) == 4'h0;
      parity_3396_s4_q <= ^{xor_3392, xor_3355, select_3322[44:36], other[44:36]};
      parity_3525_s4_q <= parity_3525;
      parity_3587_s4_q <= parity_3587;
      xor_3615_s4_q <= parity_3602 ^ parity_3614;
      parity_3627_s4_q <= ^{or_3624, or_3620, and_3616};
      or_3631_s4_q <= (or_3620 & or_3624) | (and_3616 & (or_3620 | or_3624));
      equal_3632_s4_q <= equal_3632_s3_q;
      select_3751_s4_q <= select_3751[14:10];
      equal_3763_s4_q <= select_3720[3:0] == 4'h0;
      less_3765_s4_q <= {difference_3764, 2'h0} < {2'h0, sum_3312};
      less_3766_s4_q <= select_3761 < select_3751[9:0];
      or_3771_s4_q <= (sum_3312 < 10'h39) | ({1'b0, sum_3312[9:1]} < select_3751[9:0]);
      select_3816_s4_q <= select_3816;
      equal_3972_s4_q <= equal_3972;
      and_4225_s4_q <= and_4225;
      and_4240_s4_q <= equal_1933_s3_q & (equal_3972 & (cfg_prove_i & (~proven_q)));
      equal_4281_s4_q <= (registration_fresh_q & select_4279) == 4'h0;
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
  assign texture = sum_597_s4_q + {2'h0, sum_600_s4_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_602;
  assign sum_602 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_604;
  assign sum_604 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_602});
  // hls/stages/census.hpp:303
  logic less_605;
  assign less_605 = 9'h4 < sum_604[13:5];
  logic and_606;
  assign and_606 = and_556_s4_q & less_605;
  // hls/stages/registration.hpp:265
  logic equal_2035;
  assign equal_2035 = sum_1984_s4_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1984_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2037;
  assign select_2037 = equal_2035 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2038;
  assign sum_2038 = (equal_2033_s4_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2037[13]}}, select_2037};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1984_s4_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2041;
  assign select_2041 = equal_2035 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2042;
  assign sum_2042 = (equal_2033_s4_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2041[6]}}, select_2041};
  // hls/stages/patches.hpp:326
  logic [22:0] select_2162;
  assign select_2162 = and_2161_s4_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2138_s4_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:104
  logic select_2164;
  assign select_2164 = equal_2064_s4_q ? patches_place_0_valid_q : (select_2063_s4_q ? patches_place_0_valid_q : select_2162[0]);
  // hls/stages/patches.hpp:327
  logic [21:0] select_2165;
  assign select_2165 = select_2063_s4_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2162[22:1];
  // hls/stages/patches.hpp:104
  logic [7:0] select_2166;
  assign select_2166 = equal_2064_s4_q ? patches_place_0_column_q : select_2165[7:0];
  logic [5:0] select_2167;
  assign select_2167 = equal_2064_s4_q ? patches_place_0_shift_q : select_2165[13:8];
  // hls/stages/patches.hpp:297
  logic [7:0] sum_2168;
  assign sum_2168 = select_2166 + {{2{select_2167[5]}}, select_2167};
  // hls/stages/patches.hpp:298
  logic [6:0] sum_2169;
  assign sum_2169 = sum_2168[7:1] + 7'h7f;
  // hls/stages/patches.hpp:108
  logic equal_2170;
  assign equal_2170 = {sum_2169[6], select_457_s4_q, select_455_s4_q} == {1'b0, sum_2169[5:0], sum_2168[0], 3'h4};
  // hls/stages/patches.hpp:110
  logic or_2172;
  assign or_2172 = and_2046_s4_q | (select_2164 & equal_2170);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2173;
  assign select_2173 = or_2172 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:110
  logic [5:0] select_2183;
  assign select_2183 = or_2172 ? {and_2046_s4_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:114
  logic and_2185;
  assign and_2185 = select_2182_s4_q & (~select_2183[5]);
  // hls/stages/patches.hpp:104
  logic select_2193;
  assign select_2193 = equal_2064_s4_q ? patches_place_1_valid_q : (select_2063_s4_q ? select_2162[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:327
  logic [21:0] select_2194;
  assign select_2194 = select_2063_s4_q ? select_2162[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:104
  logic [7:0] select_2195;
  assign select_2195 = equal_2064_s4_q ? patches_place_1_column_q : select_2194[7:0];
  logic [5:0] select_2196;
  assign select_2196 = equal_2064_s4_q ? patches_place_1_shift_q : select_2194[13:8];
  // hls/stages/patches.hpp:297
  logic [7:0] sum_2197;
  assign sum_2197 = select_2195 + {{2{select_2196[5]}}, select_2196};
  // hls/stages/patches.hpp:298
  logic [6:0] sum_2198;
  assign sum_2198 = sum_2197[7:1] + 7'h7f;
  // hls/stages/patches.hpp:108
  logic equal_2199;
  assign equal_2199 = {sum_2198[6], select_457_s4_q, select_455_s4_q} == {1'b0, sum_2198[5:0], sum_2197[0], 3'h4};
  // hls/stages/patches.hpp:110
  logic or_2201;
  assign or_2201 = and_2046_s4_q | (select_2193 & equal_2199);
  // hls/stages/agreement.hpp:263
  logic [4:0] select_2202;
  assign select_2202 = or_2201 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:110
  logic [5:0] select_2203;
  assign select_2203 = or_2201 ? {and_2046_s4_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:114
  logic and_2205;
  assign and_2205 = select_2182_s4_q & (~select_2203[5]);
  // hls/stages/patches.hpp:293
  logic [7:0] sum_2212;
  assign sum_2212 = select_2166 + 8'hff;
  // hls/stages/patches.hpp:109
  logic equal_2213;
  assign equal_2213 = {sum_2212[7], select_457_s4_q, select_455_s4_q} == {1'b0, sum_2212[6:0], 3'h4};
  // hls/stages/patches.hpp:111
  logic or_2215;
  assign or_2215 = and_2046_s4_q | (select_2164 & equal_2213);
  logic [4:0] select_2216;
  assign select_2216 = or_2215 ? {and_2046_s4_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:293
  logic [7:0] sum_2217;
  assign sum_2217 = select_2195 + 8'hff;
  // hls/stages/patches.hpp:109
  logic equal_2218;
  assign equal_2218 = {sum_2217[7], select_457_s4_q, select_455_s4_q} == {1'b0, sum_2217[6:0], 3'h4};
  // hls/stages/patches.hpp:111
  logic [4:0] select_2221;
  assign select_2221 = (and_2046_s4_q | (select_2193 & equal_2218)) ? {and_2046_s4_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:119
  logic [3:0] column_7;
  assign column_7 = select_2216[4] ? select_2221[3:0] : select_2216[3:0];
  // hls/stages/agreement.hpp:263
  logic select_2224;
  assign select_2224 = or_2215 ? and_2046_s4_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:119
  logic and_2230;
  assign and_2230 = (select_2182_s4_q & (select_2176_s4_q[3] ^ select_2176_s4_q[4])) & ((~select_2216[4]) | (~select_2221[4]));
  // hls/stages/patches.hpp:160
  logic less_2300;
  assign less_2300 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:161
  logic not_2301;
  assign not_2301 = ~less_2300;
  logic [1:0] select_2302;
  assign select_2302 = patches_summed_first_s4_q ? 2'h2 : {less_2300, not_2301};
  logic [12:0] select_2303;
  assign select_2303 = select_2302[0] ? {4'h0, patches_summed_first_s4_q, 3'h0, patches_summed_row_column_s4_q} : {patches_summed_row_column_s4_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2304;
  assign select_2304 = select_2302[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2305;
  assign select_2305 = select_2302[1] ? {select_2303[12:8], patches_sums_values_0_q[9:8], select_2303[7:0]} : select_2304;
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2328;
  assign select_2328 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_2329;
  assign sum_2329 = {6'h0, textured_s4_q} + select_2328;
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_2331;
  assign sum_2331 = {3'h0, sum_2329} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2333;
  assign select_2333 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:867
  logic [6:0] sum_2334;
  assign sum_2334 = {6'h0, explained_s4_q} + select_2333;
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_2336;
  assign sum_2336 = {3'h0, sum_2334} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:866
  logic [6:0] select_2339;
  assign select_2339 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:868
  logic [6:0] sum_2340;
  assign sum_2340 = {6'h0, and_2338_s4_q} + select_2339;
  // hls/stages/agreement.hpp:1005
  logic [9:0] sum_2342;
  assign sum_2342 = {3'h0, sum_2340} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1043
  logic not_2408;
  assign not_2408 = ~region_row_s4_q[2];
  logic [2:0] select_2409;
  assign select_2409 = region_row_s4_q[1] ? {1'b0, not_2408, 1'b0} : {region_row_s4_q[2], 1'b0, not_2408};
  logic [5:0] select_2410;
  assign select_2410 = region_row_s4_q[0] ? {select_2409[2], 1'b0, select_2409[1], 1'b0, select_2409[0], 1'b0} : {1'b0, select_2409[2], 1'b0, select_2409[1], 1'b0, select_2409[0]};
  logic [11:0] select_2411;
  assign select_2411 = or_2407_s4_q ? {select_2410[5], 1'b0, select_2410[4], 1'b0, select_2410[3], 1'b0, select_2410[2], 1'b0, select_2410[1], 1'b0, select_2410[0], 1'b0} : {1'b0, select_2410[5], 1'b0, select_2410[4], 1'b0, select_2410[3], 1'b0, select_2410[2], 1'b0, select_2410[1], 1'b0, select_2410[0]};
  logic [23:0] select_2412;
  assign select_2412 = or_2404_s4_q ? {select_2411[11], 1'b0, select_2411[10], 1'b0, select_2411[9], 1'b0, select_2411[8], 1'b0, select_2411[7], 1'b0, select_2411[6], 1'b0, select_2411[5], 1'b0, select_2411[4], 1'b0, select_2411[3], 1'b0, select_2411[2], 1'b0, select_2411[1], 1'b0, select_2411[0], 1'b0} : {1'b0, select_2411[11], 1'b0, select_2411[10], 1'b0, select_2411[9], 1'b0, select_2411[8], 1'b0, select_2411[7], 1'b0, select_2411[6], 1'b0, select_2411[5], 1'b0, select_2411[4], 1'b0, select_2411[3], 1'b0, select_2411[2], 1'b0, select_2411[1], 1'b0, select_2411[0]};
  logic [47:0] select_2413;
  assign select_2413 = or_2401_s4_q ? {select_2412[23], 1'b0, select_2412[22], 1'b0, select_2412[21], 1'b0, select_2412[20], 1'b0, select_2412[19], 1'b0, select_2412[18], 1'b0, select_2412[17], 1'b0, select_2412[16], 1'b0, select_2412[15], 1'b0, select_2412[14], 1'b0, select_2412[13], 1'b0, select_2412[12], 1'b0, select_2412[11], 1'b0, select_2412[10], 1'b0, select_2412[9], 1'b0, select_2412[8], 1'b0, select_2412[7], 1'b0, select_2412[6], 1'b0, select_2412[5], 1'b0, select_2412[4], 1'b0, select_2412[3], 1'b0, select_2412[2], 1'b0, select_2412[1], 1'b0, select_2412[0], 1'b0} : {1'b0, select_2412[23], 1'b0, select_2412[22], 1'b0, select_2412[21], 1'b0, select_2412[20], 1'b0, select_2412[19], 1'b0, select_2412[18], 1'b0, select_2412[17], 1'b0, select_2412[16], 1'b0, select_2412[15], 1'b0, select_2412[14], 1'b0, select_2412[13], 1'b0, select_2412[12], 1'b0, select_2412[11], 1'b0, select_2412[10], 1'b0, select_2412[9], 1'b0, select_2412[8], 1'b0, select_2412[7], 1'b0, select_2412[6], 1'b0, select_2412[5], 1'b0, select_2412[4], 1'b0, select_2412[3], 1'b0, select_2412[2], 1'b0, select_2412[1], 1'b0, select_2412[0]};
  // hls/stages/agreement.hpp:976
  logic and_2417;
  assign and_2417 = good_known_q & (~((good_q & select_2413) == 48'h0));
  // hls/stages/agreement.hpp:1045
  logic is_seen;
  assign is_seen = equal_2396_s4_q ? and_2417 : not_2432_s4_q;
  // hls/stages/agreement.hpp:1054
  logic and_2447;
  assign and_2447 = is_seen & less_2446_s4_q;
  // hls/stages/agreement.hpp:263
  logic [8:0] select_2481;
  assign select_2481 = sample_pair_whole_s4_q ? (and_489_s4_q ? grey_s4_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2483;
  assign select_2483 = sample_pair_whole_s4_q ? (and_489_s4_q ? grey_2_s4_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2485;
  assign select_2485 = sample_pair_whole_s4_q ? (and_489_s4_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2487;
  assign select_2487 = sample_pair_whole_s4_q ? (and_489_s4_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2492;
  assign sum_2492 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s4_q};
  logic [9:0] difference_2493;
  assign difference_2493 = {1'b0, sum_2492[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2494;
  assign xor_2494 = {difference_2493[8:0], sum_2492[0]} ^ {10{difference_2493[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2493[9]} + {1'b0, xor_2494};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_494_s4_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2499;
  assign select_2499 = sample_pair_whole_s4_q ? (and_489_s4_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2500;
  assign sum_2500 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s4_q};
  logic [9:0] difference_2501;
  assign difference_2501 = {1'b0, sum_2500[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2502;
  assign xor_2502 = {difference_2501[8:0], sum_2500[0]} ^ {10{difference_2501[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2501[9]} + {1'b0, xor_2502};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_494_s4_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:263
  logic [13:0] select_2507;
  assign select_2507 = sample_pair_whole_s4_q ? (and_489_s4_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2590;
  assign sum_2590 = sum_2586_s4_q + {2'h0, sum_2589_s4_q};
  // hls/stages/agreement.hpp:507
  logic [11:0] select_2592;
  assign select_2592 = and_491_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2593;
  assign select_2593 = and_491_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2594;
  assign select_2594 = and_491_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2595;
  assign select_2595 = and_491_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2598;
  assign sum_2598 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2590};
  logic [13:0] sum_2600;
  assign sum_2600 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2598});
  // hls/stages/census.hpp:305
  logic and_2602;
  assign and_2602 = and_581_s4_q & (9'h4 < sum_2600[13:5]);
  // hls/stages/census.hpp:306
  logic and_2603;
  assign and_2603 = and_581_s4_q & less_605;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2604;
  assign sum_2604 = census_left_misses_q + {{17{and_2603}}, and_2602, 1'b0, and_2602};
  // hls/stages/agreement.hpp:507
  logic [19:0] select_2606;
  assign select_2606 = and_491_s4_q ? (equal_2597_s4_q ? 20'h0 : sum_2604) : census_left_misses_q;
  // hls/stages/agreement.hpp:263
  logic [27:0] select_2611;
  assign select_2611 = sample_pair_whole_s4_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:507
  logic select_2614;
  assign select_2614 = and_491_s4_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2617;
  assign and_2617 = whole_2_s4_q & (~(column_s4_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:444
  logic and_2623;
  assign and_2623 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s4_q[8:2]));
  logic and_2624;
  assign and_2624 = and_2617 & and_2623;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2611[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2626;
  assign select_2626 = and_2624 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2628;
  assign select_2628 = equal_2597_s4_q ? {11'h0, select_2626} : (sharpness_sums_detail_0_q + {11'h0, select_2626});
  // hls/stages/agreement.hpp:444
  logic and_2635;
  assign and_2635 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s4_q[8:2]));
  logic and_2636;
  assign and_2636 = and_2617 & and_2635;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2611[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2638;
  assign select_2638 = and_2636 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2640;
  assign select_2640 = equal_2597_s4_q ? {11'h0, select_2638} : (sharpness_sums_detail_1_q + {11'h0, select_2638});
  logic [8:0] select_2643;
  assign select_2643 = and_2624 ? contrast_s4_q : 9'h0;
  logic [23:0] sum_2644;
  assign sum_2644 = (equal_2597_s4_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2643};
  logic [8:0] select_2647;
  assign select_2647 = and_2636 ? contrast_2_s4_q : 9'h0;
  logic [23:0] sum_2648;
  assign sum_2648 = (equal_2597_s4_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2647};
  // hls/stages/agreement.hpp:203
  logic equal_2650;
  assign equal_2650 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2651;
  assign less_2651 = 7'h2 < {x_s4_q[4:0], slot_s4_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2652;
  assign less_2652 = x_s4_q[4:0] < 5'h3;
  logic not_2653;
  assign not_2653 = ~x_s4_q[1];
  logic [2:0] select_2654;
  assign select_2654 = x_s4_q[0] ? {1'b0, not_2653, 1'b0} : {x_s4_q[1], 1'b0, not_2653};
  logic [5:0] select_2655;
  assign select_2655 = slot_s4_q[2] ? {select_2654[2], 1'b0, select_2654[1], 1'b0, select_2654[0], 1'b0} : {1'b0, select_2654[2], 1'b0, select_2654[1], 1'b0, select_2654[0]};
  logic [11:0] select_2656;
  assign select_2656 = slot_s4_q[1] ? {select_2655[5], 1'b0, select_2655[4], 1'b0, select_2655[3], 1'b0, select_2655[2], 1'b0, select_2655[1], 1'b0, select_2655[0], 1'b0} : {1'b0, select_2655[5], 1'b0, select_2655[4], 1'b0, select_2655[3], 1'b0, select_2655[2], 1'b0, select_2655[1], 1'b0, select_2655[0]};
  logic [23:0] select_2657;
  assign select_2657 = slot_s4_q[0] ? {select_2656[11], 1'b0, select_2656[10], 1'b0, select_2656[9], 1'b0, select_2656[8], 1'b0, select_2656[7], 1'b0, select_2656[6], 1'b0, select_2656[5], 1'b0, select_2656[4], 1'b0, select_2656[3], 1'b0, select_2656[2], 1'b0, select_2656[1], 1'b0, select_2656[0], 1'b0} : {1'b0, select_2656[11], 1'b0, select_2656[10], 1'b0, select_2656[9], 1'b0, select_2656[8], 1'b0, select_2656[7], 1'b0, select_2656[6], 1'b0, select_2656[5], 1'b0, select_2656[4], 1'b0, select_2656[3], 1'b0, select_2656[2], 1'b0, select_2656[1], 1'b0, select_2656[0]};
  // hls/stages/census.hpp:372
  logic and_2661;
  assign and_2661 = less_2652 & (~((sharpness_sums_contrast_1_q & select_2657) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2663;
  assign select_2663 = (less_2651 & and_2661) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2663};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2666;
  assign select_2666 = equal_2650 ? (less_2651 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2671;
  assign and_2671 = less_2652 & (~((sharpness_sums_contrast_0_q & select_2657) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2673;
  assign select_2673 = (less_2651 & and_2671) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2673};
  // hls/stages/agreement.hpp:207
  logic [17:0] select_2676;
  assign select_2676 = equal_2650 ? (less_2651 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2678;
  assign select_2678 = equal_2650 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2680;
  assign select_2680 = equal_2650 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2682;
  assign select_2682 = equal_2650 ? {sharpness_comparing_contrast_0_q[0], and_2671} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2684;
  assign select_2684 = equal_2650 ? {sharpness_comparing_contrast_1_q[0], and_2661} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:207
  logic select_2689;
  assign select_2689 = drew_q ? (equal_2650 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:207
  logic select_2693;
  assign select_2693 = drew_q ? (equal_2650 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2694;
  assign equal_2694 = {x_s4_q[4:0], slot_s4_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2695;
  assign xor_2695 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2698;
  assign select_2698 = (equal_2694 | xor_2695) ? (five_times[0] & xor_2695) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2700;
  assign select_2700 = drew_q ? (equal_2650 ? select_2698 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2701;
  assign xor_2701 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2704;
  assign select_2704 = (equal_2694 | xor_2701) ? (five_times_2[0] & xor_2701) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2706;
  assign select_2706 = drew_q ? (equal_2650 ? select_2704 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2707;
  assign xor_2707 = sharpness_comparing_contrast_0_q[1] ^ and_2661;
  logic select_2710;
  assign select_2710 = (equal_2694 | xor_2707) ? (and_2661 & xor_2707) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:207
  logic select_2712;
  assign select_2712 = drew_q ? (equal_2650 ? select_2710 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2713;
  assign xor_2713 = sharpness_comparing_contrast_1_q[1] ^ and_2671;
  logic select_2716;
  assign select_2716 = (equal_2694 | xor_2713) ? (and_2671 & xor_2713) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:207
  logic select_2718;
  assign select_2718 = drew_q ? (equal_2650 ? select_2716 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2824;
  assign select_2824 = and_2818_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2822_s4_q});
  // hls/stages/patches.hpp:313
  logic and_2827;
  assign and_2827 = not_1934_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_2832;
  assign and_2832 = not_1934_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_2837;
  assign and_2837 = not_1934_s4_q & (drew_q & (ends_cell_s4_q & and_2338_s4_q));
  // hls/stages/agreement.hpp:1047
  logic not_2841;
  assign not_2841 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1048
  logic not_2858;
  assign not_2858 = ~(equal_2396_s4_q ? and_2417 : not_2856_s4_q);
  // hls/stages/patches.hpp:313
  logic and_2861;
  assign and_2861 = ends_cell_s4_q & (not_2841 & (centres_values_1_textured_s4_q & not_2858));
  logic and_2863;
  assign and_2863 = not_1934_s4_q & (drew_q & and_2861);
  // hls/stages/agreement.hpp:1074
  logic less_2866;
  assign less_2866 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_2867;
  assign select_2867 = less_2866 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2870;
  assign select_2870 = less_2866 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1075
  logic [10:0] sum_2871;
  assign sum_2871 = {1'b0, select_2870} + {3'h0, select_2870[9:2]};
  logic and_2873;
  assign and_2873 = (~(select_2867[9:4] == 6'h0)) & ({sum_2871, select_2870[1:0]} < {3'h0, select_2867});
  // hls/stages/agreement.hpp:1084
  logic [9:0] select_2876;
  assign select_2876 = x_s4_q[6] ? (equal_1978_s4_q ? 10'h0 : (and_2873 ? select_2867 : 10'h0)) : 10'h0;
  // hls/stages/patches.hpp:313
  logic [9:0] select_2877;
  assign select_2877 = equal_1933_s4_q ? select_2876 : 10'h0;
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2879;
  assign select_2879 = and_2818_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2877});
  logic [13:0] select_2886;
  assign select_2886 = and_2818_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2884_s4_q});
  // hls/stages/agreement.hpp:1052
  logic and_2888;
  assign and_2888 = not_2841 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/patches.hpp:313
  logic and_2891;
  assign and_2891 = not_1934_s4_q & (drew_q & (ends_cell_s4_q & and_2888));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2893;
  assign select_2893 = and_2818_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2891});
  // hls/stages/agreement.hpp:1052
  logic and_2895;
  assign and_2895 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_2858);
  // hls/stages/patches.hpp:313
  logic and_2899;
  assign and_2899 = not_1934_s4_q & (drew_q & (ends_cell_s4_q & (not_2841 & and_2895)));
  // hls/stages/agreement.hpp:889
  logic [13:0] select_2901;
  assign select_2901 = and_2818_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2899});
  // hls/stages/patches.hpp:313
  logic [7:0] select_2950;
  assign select_2950 = drew_q ? (equal_2074_s4_q ? (and_2934_s4_q ? residual_s4_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2951;
  assign select_2951 = equal_1933_s4_q ? 8'h0 : select_2950;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2953;
  assign select_2953 = and_2933_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_2951[7]}}, select_2951});
  // hls/stages/patches.hpp:313
  logic and_2956;
  assign and_2956 = not_1934_s4_q & (drew_q & (and_2934_s4_q & equal_2074_s4_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2958;
  assign select_2958 = and_2933_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2956});
  // hls/stages/registration.hpp:107
  logic and_2960;
  assign and_2960 = and_2934_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/patches.hpp:313
  logic [1:0] select_2962;
  assign select_2962 = drew_q ? (equal_2074_s4_q ? {and_2960, and_2934_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2963;
  assign select_2963 = equal_1933_s4_q ? 2'h0 : select_2962;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2964;
  assign sum_2964 = registration_half_votes_down_q + {{5{select_2963[1]}}, select_2963};
  // hls/stages/patches.hpp:313
  logic [1:0] select_2970;
  assign select_2970 = drew_q ? (equal_2074_s4_q ? {and_2968_s4_q, and_2934_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2971;
  assign select_2971 = equal_1933_s4_q ? 2'h0 : select_2970;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2972;
  assign sum_2972 = registration_half_votes_up_q + {{5{select_2971[1]}}, select_2971};
  // hls/stages/registration.hpp:107
  logic and_2975;
  assign and_2975 = and_2934_s4_q & ($signed(residual_s4_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/patches.hpp:313
  logic [1:0] select_2977;
  assign select_2977 = drew_q ? (equal_2074_s4_q ? {and_2975, and_2934_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2978;
  assign select_2978 = equal_1933_s4_q ? 2'h0 : select_2977;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2979;
  assign sum_2979 = registration_half_half_votes_down_q + {{5{select_2978[1]}}, select_2978};
  // hls/stages/patches.hpp:313
  logic [1:0] select_2984;
  assign select_2984 = drew_q ? (equal_2074_s4_q ? {and_2982_s4_q, and_2934_s4_q} : 2'h0) : 2'h0;
  logic [1:0] select_2985;
  assign select_2985 = equal_1933_s4_q ? 2'h0 : select_2984;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2986;
  assign sum_2986 = registration_half_half_votes_up_q + {{5{select_2985[1]}}, select_2985};
  // hls/stages/patches.hpp:313
  logic and_3020;
  assign and_3020 = equal_1933_s4_q & (x_s4_q[6] & (not_2317_s4_q & less_2009_s4_q));
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_3027;
  assign select_3027 = or_2013_s4_q ? 12'h0 : (equal_3025_s4_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_3030;
  assign select_3030 = x_s4_q[6] ? (equal_1978_s4_q ? 12'h0 : (less_2009_s4_q ? select_3027 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:313
  logic [11:0] select_3031;
  assign select_3031 = equal_1933_s4_q ? select_3030 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3032;
  assign and_3032 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_3035;
  assign and_3035 = not_2317_s4_q & (less_2009_s4_q & ({and_3032, x_s4_q[0]} == 2'h0));
  // hls/stages/patches.hpp:313
  logic and_3037;
  assign and_3037 = equal_1933_s4_q & (x_s4_q[6] & and_3035);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3039;
  assign sum_3039 = {{2{select_3031[11]}}, select_3031} + (and_3037 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1072
  logic [11:0] select_3042;
  assign select_3042 = or_2013_s4_q ? 12'h0 : (equal_3025_s4_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1084
  logic [11:0] select_3045;
  assign select_3045 = x_s4_q[6] ? (equal_1978_s4_q ? 12'h0 : (less_2009_s4_q ? select_3042 : 12'h0)) : 12'h0;
  // hls/stages/patches.hpp:313
  logic [11:0] select_3046;
  assign select_3046 = equal_1933_s4_q ? select_3045 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3048;
  assign sum_3048 = {{2{select_3046[11]}}, select_3046} + (and_3037 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3050;
  assign not_3050 = ~all_s4_q;
  // hls/stages/agreement.hpp:1084
  logic and_3053;
  assign and_3053 = not_2317_s4_q & (less_2009_s4_q & (x_s4_q[2:0] == {all_s4_q, not_3050, 1'b0}));
  // hls/stages/patches.hpp:313
  logic and_3059;
  assign and_3059 = equal_1933_s4_q & (x_s4_q[6] & (not_2317_s4_q & (less_2009_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:246
  logic not_3060;
  assign not_3060 = ~and_3059;
  logic less_3061;
  assign less_3061 = $signed({9'h1, {2{not_3060}}, and_3059}) < $signed(registration_up_q[13:2]);
  logic select_3062;
  assign select_3062 = (equal_1933_s4_q & (x_s4_q[6] & and_3053)) ? less_3061 : registration_enough_q;
  // hls/stages/agreement.hpp:1084
  logic and_3066;
  assign and_3066 = x_s4_q[6] & (not_2317_s4_q & (less_2009_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/patches.hpp:313
  logic and_3067;
  assign and_3067 = equal_1933_s4_q & and_3066;
  // hls/stages/registration.hpp:242
  logic less_3068;
  assign less_3068 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3070;
  assign less_3070 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:1084
  logic and_3075;
  assign and_3075 = x_s4_q[6] & (not_2317_s4_q & (less_2009_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/patches.hpp:313
  logic and_3076;
  assign and_3076 = equal_1933_s4_q & and_3075;
  // hls/stages/agreement.hpp:1084
  logic and_3083;
  assign and_3083 = x_s4_q[6] & (not_2317_s4_q & (less_2009_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3086;
  assign equal_3086 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1084
  logic and_3089;
  assign and_3089 = not_2317_s4_q & (less_2009_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_3086));
  // hls/stages/registration.hpp:244
  logic and_3093;
  assign and_3093 = (equal_1933_s4_q & (x_s4_q[6] & and_3089)) & (less_3070 | less_3068);
  // hls/stages/agreement.hpp:1084
  logic and_3098;
  assign and_3098 = not_2317_s4_q & (less_2009_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_3086)));
  // hls/stages/registration.hpp:244
  logic and_3101;
  assign and_3101 = registration_votes_up_q & registration_other_down_q;
  logic select_3103;
  assign select_3103 = registration_votes_down_q ? (registration_other_up_q | and_3101) : and_3101;
  // hls/stages/registration.hpp:138
  logic and_3105;
  assign and_3105 = (equal_1933_s4_q & (x_s4_q[6] & and_3098)) & (registration_other_enough_q & select_3103);
  // hls/stages/registration.hpp:245
  logic or_3108;
  assign or_3108 = registration_moved_q | (registration_enough_q & (and_3093 | and_3105));
  // hls/stages/agreement.hpp:263
  logic [7:0] select_3193;
  assign select_3193 = sample_pair_whole_s4_q ? (equal_2064_s4_q ? patches_place_0_slope_q : select_2165[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3198;
  assign select_3198 = sample_pair_whole_s4_q ? (equal_2064_s4_q ? patches_place_1_slope_q : select_2194[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:104
  logic select_3200;
  assign select_3200 = equal_2064_s4_q ? patches_valid_0_q : (select_2063_s4_q ? patches_valid_0_q : select_2162[0]);
  // hls/stages/agreement.hpp:263
  logic select_3203;
  assign select_3203 = sample_pair_whole_s4_q ? (and_2185 ? (sample_present_s4_q & select_3200) : select_3200) : patches_valid_0_q;
  // hls/stages/patches.hpp:104
  logic select_3205;
  assign select_3205 = equal_2064_s4_q ? patches_valid_1_q : (select_2063_s4_q ? select_2162[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:263
  logic select_3208;
  assign select_3208 = sample_pair_whole_s4_q ? (and_2205 ? (sample_present_s4_q & select_3205) : select_3205) : patches_valid_1_q;
  logic [5:0] select_3211;
  assign select_3211 = sample_pair_whole_s4_q ? (select_2183[5] ? {1'b1, select_2183[4:0]} : (select_2183 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3214;
  assign select_3214 = sample_pair_whole_s4_q ? (select_2203[5] ? {1'b1, select_2203[4:0]} : (select_2203 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3217;
  assign select_3217 = sample_pair_whole_s4_q ? (select_2216[4] ? {1'b1, select_2216[3:0]} : (select_2216 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3220;
  assign select_3220 = sample_pair_whole_s4_q ? (select_2221[4] ? {1'b1, select_2221[3:0]} : (select_2221 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:464
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3631_s4_q, parity_3627_s4_q, xor_3615_s4_q, parity_3587_s4_q, parity_3525_s4_q, parity_3396_s4_q} + (equal_3632_s4_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:160
  logic [9:0] select_3636;
  assign select_3636 = equal_2146_s4_q ? patches_sums_values_0_q : (equal_2148_s4_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3637;
  assign select_3637 = equal_2148_s4_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3639;
  assign select_3639 = equal_2148_s4_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3641;
  assign select_3641 = equal_2148_s4_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3643;
  assign select_3643 = equal_2148_s4_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3645;
  assign select_3645 = equal_2148_s4_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3647;
  assign select_3647 = equal_2148_s4_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3649;
  assign select_3649 = equal_2148_s4_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3651;
  assign select_3651 = equal_2148_s4_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3653;
  assign select_3653 = equal_2148_s4_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3655;
  assign select_3655 = equal_2148_s4_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3657;
  assign select_3657 = equal_2148_s4_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3659;
  assign select_3659 = equal_2148_s4_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3661;
  assign select_3661 = equal_2148_s4_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3663;
  assign select_3663 = equal_2148_s4_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3665;
  assign select_3665 = equal_2148_s4_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3667;
  assign select_3667 = equal_2148_s4_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:538
  logic or_3772;
  assign or_3772 = (~(patches_second_s4_q ? patches_valid_1_q : patches_valid_0_q)) | or_3771_s4_q;
  logic or_3775;
  assign or_3775 = equal_3763_s4_q | (less_3765_s4_q | (less_3766_s4_q | or_3772));
  // hls/stages/patches.hpp:518
  logic not_3776;
  assign not_3776 = ~or_3775;
  // hls/stages/patches.hpp:499
  logic and_3777;
  assign and_3777 = equal_2291_s4_q & not_3776;
  // hls/stages/patches.hpp:160
  logic and_3780;
  assign and_3780 = equal_2146_s4_q & (less_2288_s4_q ? (not_2290_s4_q & and_3777) : and_3777);
  // hls/stages/patches.hpp:576
  logic not_3781;
  assign not_3781 = ~patches_lower_s4_q;
  // hls/stages/patches.hpp:499
  logic and_3783;
  assign and_3783 = equal_2291_s4_q & (patches_second_s4_q & not_3776);
  // hls/stages/patches.hpp:160
  logic and_3786;
  assign and_3786 = equal_2146_s4_q & (less_2288_s4_q ? (not_2290_s4_q & and_3783) : and_3783);
  // hls/stages/patches.hpp:576
  logic not_3787;
  assign not_3787 = ~and_3786;
  // hls/stages/patches.hpp:164
  logic and_3789;
  assign and_3789 = and_3780 & (not_3781 & not_3787);
  // hls/stages/patches.hpp:578
  logic [7:0] sum_3791;
  assign sum_3791 = {7'h0, and_3789} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:536
  logic [7:0] select_3817;
  assign select_3817 = patches_second_s4_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:535
  logic [5:0] select_3818;
  assign select_3818 = patches_second_s4_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3819;
  assign sum_3819 = {2'h0, select_3751_s4_q[4:3]} + 4'hf;
  logic [6:0] sum_3820;
  assign sum_3820 = {select_3818[5], select_3818} + {{3{sum_3819[3]}}, sum_3819};
  // hls/stages/patches.hpp:536
  logic [17:0] product_3821;
  assign product_3821 = $signed({{10{select_3817[7]}}, select_3817}) * $signed({{8{sum_3820[6]}}, sum_3820, select_3751_s4_q[2:0]});
  // hls/stages/patches.hpp:537
  logic [13:0] difference_3822;
  assign difference_3822 = {{6{select_3816_s4_q[7]}}, select_3816_s4_q} - {product_3821[17], product_3821[17:5]};
  // hls/stages/patches.hpp:543
  logic less_3823;
  assign less_3823 = $signed({{7{difference_3793[6]}}, difference_3793}) < $signed(difference_3822);
  // hls/stages/patches.hpp:499
  logic and_3826;
  assign and_3826 = equal_2291_s4_q & (not_3776 & (~less_3823));
  // hls/stages/patches.hpp:160
  logic and_3829;
  assign and_3829 = equal_2146_s4_q & (less_2288_s4_q ? (not_2290_s4_q & and_3826) : and_3826);
  // hls/stages/patches.hpp:579
  logic and_3830;
  assign and_3830 = and_3829 & and_3789;
  logic [7:0] sum_3831;
  assign sum_3831 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3830};
  // hls/stages/patches.hpp:499
  logic and_3835;
  assign and_3835 = not_3776 & (~($signed(difference_3822) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3836;
  assign and_3836 = equal_2291_s4_q & and_3835;
  // hls/stages/patches.hpp:160
  logic and_3839;
  assign and_3839 = equal_2146_s4_q & (less_2288_s4_q ? (not_2290_s4_q & and_3836) : and_3836);
  // hls/stages/patches.hpp:580
  logic and_3840;
  assign and_3840 = and_3839 & and_3789;
  logic [7:0] sum_3841;
  assign sum_3841 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3840};
  // hls/stages/patches.hpp:164
  logic and_3843;
  assign and_3843 = and_3780 & (and_3786 & not_3781);
  // hls/stages/patches.hpp:578
  logic [7:0] sum_3845;
  assign sum_3845 = {7'h0, and_3843} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:579
  logic and_3847;
  assign and_3847 = and_3829 & and_3843;
  logic [7:0] sum_3848;
  assign sum_3848 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3847};
  // hls/stages/patches.hpp:580
  logic and_3850;
  assign and_3850 = and_3839 & and_3843;
  logic [7:0] sum_3851;
  assign sum_3851 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3850};
  // hls/stages/patches.hpp:164
  logic and_3853;
  assign and_3853 = and_3780 & (patches_lower_s4_q & not_3787);
  // hls/stages/patches.hpp:578
  logic [7:0] sum_3855;
  assign sum_3855 = {7'h0, and_3853} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:579
  logic and_3857;
  assign and_3857 = and_3829 & and_3853;
  logic [7:0] sum_3858;
  assign sum_3858 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3857};
  // hls/stages/patches.hpp:580
  logic and_3860;
  assign and_3860 = and_3839 & and_3853;
  logic [7:0] sum_3861;
  assign sum_3861 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3860};
  // hls/stages/patches.hpp:164
  logic and_3863;
  assign and_3863 = and_3780 & (patches_lower_s4_q & and_3786);
  // hls/stages/patches.hpp:578
  logic [7:0] sum_3865;
  assign sum_3865 = {7'h0, and_3863} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:579
  logic and_3867;
  assign and_3867 = and_3829 & and_3863;
  logic [7:0] sum_3868;
  assign sum_3868 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3867};
  // hls/stages/patches.hpp:580
  logic and_3870;
  assign and_3870 = and_3839 & and_3863;
  logic [7:0] sum_3871;
  assign sum_3871 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3870};
  // hls/stages/agreement.hpp:1072
  logic less_3872;
  assign less_3872 = x_s4_q[5:3] < 3'h5;
  // hls/stages/agreement.hpp:1154
  logic equal_3873;
  assign equal_3873 = x_s4_q[2:0] == 3'h0;
  // hls/stages/registration.hpp:150
  logic not_3874;
  assign not_3874 = ~x_s4_q[4];
  // hls/stages/registration.hpp:157
  logic not_3875;
  assign not_3875 = ~x_s4_q[3];
  // hls/stages/patches.hpp:176
  logic and_3876;
  assign and_3876 = not_3874 & not_3875;
  logic [1:0] select_3877;
  assign select_3877 = x_s4_q[4] ? {1'b1, x_s4_q[3]} : {not_3875, 1'b1};
  logic [3:0] select_3878;
  assign select_3878 = x_s4_q[5] ? {{2{and_3876}}, 2'h0} : {not_3875, not_3874, select_3877};
  // hls/stages/agreement.hpp:1084
  logic and_3882;
  assign and_3882 = x_s4_q[6] & (not_2317_s4_q & (less_3872 & (equal_3873 & select_3878[0])));
  // hls/stages/patches.hpp:313
  logic and_3883;
  assign and_3883 = equal_1933_s4_q & and_3882;
  // hls/stages/patches.hpp:176
  logic equal_3885;
  assign equal_3885 = x_s4_q[2:0] == 3'h1;
  // hls/stages/agreement.hpp:1084
  logic and_3889;
  assign and_3889 = x_s4_q[6] & (not_2317_s4_q & (less_3872 & (select_3878[1] & equal_3885)));
  // hls/stages/patches.hpp:313
  logic and_3890;
  assign and_3890 = equal_1933_s4_q & and_3889;
  // hls/stages/patches.hpp:560
  logic [7:0] or_3892;
  assign or_3892 = (and_3883 ? patches_quarters_0_places_q : 8'h0) | (and_3890 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1084
  logic and_3896;
  assign and_3896 = not_2317_s4_q & (less_3872 & (select_3878[2] & (x_s4_q[2:0] == 3'h2)));
  // hls/stages/patches.hpp:313
  logic and_3898;
  assign and_3898 = equal_1933_s4_q & (x_s4_q[6] & and_3896);
  // hls/stages/agreement.hpp:1084
  logic and_3904;
  assign and_3904 = not_2317_s4_q & (less_3872 & (select_3878[3] & (x_s4_q[2:0] == 3'h3)));
  // hls/stages/patches.hpp:313
  logic and_3906;
  assign and_3906 = equal_1933_s4_q & (x_s4_q[6] & and_3904);
  // hls/stages/patches.hpp:560
  logic [7:0] or_3908;
  assign or_3908 = (or_3892 | (and_3898 ? patches_quarters_2_places_q : 8'h0)) | (and_3906 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:561
  logic [7:0] or_3911;
  assign or_3911 = (and_3883 ? patches_quarters_0_up_q : 8'h0) | (and_3890 ? patches_quarters_1_up_q : 8'h0);
  logic [7:0] or_3915;
  assign or_3915 = (or_3911 | (and_3898 ? patches_quarters_2_up_q : 8'h0)) | (and_3906 ? patches_quarters_3_up_q : 8'h0);
  // hls/stages/patches.hpp:562
  logic [7:0] or_3918;
  assign or_3918 = (and_3883 ? patches_quarters_0_down_q : 8'h0) | (and_3890 ? patches_quarters_1_down_q : 8'h0);
  logic [7:0] or_3922;
  assign or_3922 = (or_3918 | (and_3898 ? patches_quarters_2_down_q : 8'h0)) | (and_3906 ? patches_quarters_3_down_q : 8'h0);
  // hls/stages/patches.hpp:180
  logic [4:0] sum_3923;
  assign sum_3923 = {2'h0, x_s4_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1084
  logic and_3927;
  assign and_3927 = x_s4_q[6] & (not_2317_s4_q & (less_3872 & (sum_3923[4:2] == 3'h0)));
  // hls/stages/patches.hpp:313
  logic and_3928;
  assign and_3928 = equal_1933_s4_q & and_3927;
  logic and_3932;
  assign and_3932 = equal_1933_s4_q & (x_s4_q[6] & (not_2317_s4_q & (less_3872 & equal_3885)));
  // hls/stages/patches.hpp:557
  logic [7:0] select_3935;
  assign select_3935 = and_3928 ? (patches_word_places_q + (and_3932 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3938;
  assign select_3938 = and_3928 ? (patches_word_up_q + (and_3932 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3941;
  assign select_3941 = and_3928 ? (patches_word_down_q + (and_3932 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:544
  logic [5:0] select_3945;
  assign select_3945 = ($signed(difference_3822[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3822[5:0];
  logic [5:0] select_3946;
  assign select_3946 = ($signed(14'h10) < $signed(difference_3822)) ? 6'h10 : select_3945;
  // hls/stages/patches.hpp:499
  logic [5:0] select_3948;
  assign select_3948 = equal_2291_s4_q ? (or_3775 ? 6'h0 : select_3946) : 6'h0;
  logic [5:0] select_3950;
  assign select_3950 = less_2288_s4_q ? (equal_2289_s4_q ? 6'h0 : select_3948) : select_3948;
  // hls/stages/patches.hpp:582
  logic [5:0] select_3952;
  assign select_3952 = and_3780 ? (equal_2146_s4_q ? select_3950 : 6'h0) : 6'h0;
  logic [11:0] sum_3953;
  assign sum_3953 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3952[5]}}, select_3952};
  // hls/stages/patches.hpp:313
  logic and_3957;
  assign and_3957 = equal_1933_s4_q & (x_s4_q[6] & (not_2317_s4_q & (equal_3086 & less_3872)));
  // hls/stages/agreement.hpp:1084
  logic and_3961;
  assign and_3961 = x_s4_q[6] & (not_2317_s4_q & (less_3872 & (x_s4_q[5:3] == 3'h0)));
  // hls/stages/patches.hpp:313
  logic and_3962;
  assign and_3962 = equal_1933_s4_q & and_3961;
  // hls/stages/patches.hpp:571
  logic [7:0] select_3964;
  assign select_3964 = and_3957 ? (and_3962 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:573
  logic or_3968;
  assign or_3968 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:570
  logic select_3970;
  assign select_3970 = and_3957 ? (and_3962 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:164
  logic and_3976;
  assign and_3976 = patches_complete_q & (equal_1933_s4_q & ((x_s4_q[6:0] == 7'h70) & (~equal_3972_s4_q)));
  logic and_3977;
  assign and_3977 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:570
  logic [4:0] select_3979;
  assign select_3979 = and_3962 ? {and_3977, patches_found_q[4:1]} : (and_3957 ? {and_3977, patches_found_q[4:1]} : patches_found_q);
  // hls/stages/patches.hpp:569
  logic select_3986;
  assign select_3986 = patches_round_ends_q ? (~(patches_found_q == 5'h0)) : patches_moved_q;
  // hls/stages/agreement.hpp:1126
  logic or_4043;
  assign or_4043 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1148
  logic equal_4045;
  assign equal_4045 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1157
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1158
  logic select_4051;
  assign select_4051 = (equal_4045 & equal_3873) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1077
  logic [10:0] sum_4054;
  assign sum_4054 = {1'b0, select_2870} + {2'h0, select_2870[9:1]};
  logic select_4057;
  assign select_4057 = (select_2867[9:3] == 7'h0) ? ((~or_4043) & (~select_4051)) : (~({sum_4054, select_2870[0]} < {2'h0, select_2867}));
  // hls/stages/agreement.hpp:1084
  logic [47:0] select_4059;
  assign select_4059 = x_s4_q[6] ? (equal_1978_s4_q ? good_q : {select_4057, good_q[47:1]}) : good_q;
  // hls/stages/patches.hpp:313
  logic select_4063;
  assign select_4063 = equal_1933_s4_q ? ((x_s4_q[6] & good_known_q) | equal_3972_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:1148
  logic equal_4064;
  assign equal_4064 = x_s4_q[6:3] == 4'ha;
  logic equal_4066;
  assign equal_4066 = x_s4_q[6:3] == 4'h9;
  logic equal_4067;
  assign equal_4067 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_4069;
  assign select_4069 = equal_4066 ? counts_skin_unproven_q : (equal_4067 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4064 ? counts_nearer_q : select_4069;
  // hls/stages/agreement.hpp:1153
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1161
  logic select_4072;
  assign select_4072 = (equal_4064 & equal_3873) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1086
  logic not_4073;
  assign not_4073 = ~hidden_for_q[7];
  logic [7:0] select_4075;
  assign select_4075 = select_4072 ? (hidden_for_q + {7'h0, not_4073}) : 8'h0;
  // hls/stages/patches.hpp:313
  logic [7:0] select_4077;
  assign select_4077 = equal_1933_s4_q ? (equal_3972_s4_q ? select_4075 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_4078;
  assign select_4078 = equal_3873 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1067
  logic [7:0] select_4080;
  assign select_4080 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4082;
  assign select_4082 = equal_4067 ? cfg_unproven_skin_limit_i : (equal_4045 ? cfg_unproven_limit_i : select_4080);
  logic [7:0] limit;
  assign limit = equal_4064 ? cfg_regions_limit_i : (equal_4066 ? cfg_hidden_limit_i : select_4082);
  // hls/stages/agreement.hpp:1161
  logic not_4085;
  assign not_4085 = ~x_s4_q[2];
  logic [3:0] select_4086;
  assign select_4086 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_4085, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_4085};
  logic [7:0] select_4087;
  assign select_4087 = x_s4_q[0] ? {select_4086[3], 1'b0, select_4086[2], 1'b0, select_4086[1], 1'b0, select_4086[0], 1'b0} : {1'b0, select_4086[3], 1'b0, select_4086[2], 1'b0, select_4086[1], 1'b0, select_4086[0]};
  // hls/stages/agreement.hpp:1067
  logic [13:0] select_4091;
  assign select_4091 = equal_4066 ? counts_skin_supervised_q : (equal_4067 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_4064 ? counts_textured_q : select_4091;
  // hls/stages/agreement.hpp:1161
  logic [13:0] select_4093;
  assign select_4093 = ((limit & select_4087) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4078} + {1'b0, select_4093};
  // hls/stages/patches.hpp:313
  logic select_4098;
  assign select_4098 = equal_1933_s4_q ? (equal_3873 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1159
  logic and_4103;
  assign and_4103 = too_much_q & (~(equal_4067 & equal_3873));
  // hls/stages/agreement.hpp:1160
  logic select_4108;
  assign select_4108 = (over[14] & equal_3873) ? (and_4103 | ((equal_4067 | equal_4066) | (x_s4_q[6:3] == 4'hf))) : and_4103;
  // hls/stages/agreement.hpp:1234
  logic [1:0] select_4226;
  assign select_4226 = and_4225_s4_q ? {and_2447, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1235
  logic and_4227;
  assign and_4227 = proven_q & less_4215;
  // hls/stages/agreement.hpp:424
  logic select_4230;
  assign select_4230 = and_2377_s4_q ? (less_2378_s4_q ? (select_4226[0] & and_4227) : seen_q) : seen_q;
  logic select_4233;
  assign select_4233 = and_2377_s4_q ? (less_2378_s4_q ? (select_4226[1] & and_4227) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1170
  logic not_4245;
  assign not_4245 = ~(or_4043 | not_4234);
  // hls/stages/patches.hpp:313
  logic and_4249;
  assign and_4249 = equal_1933_s4_q & (equal_3972_s4_q & (not_4245 & (select_4051 | select_4108)));
  logic and_4252;
  assign and_4252 = equal_3972_s4_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1088
  logic or_4256;
  assign or_4256 = select_2700 | (select_2712 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/patches.hpp:313
  logic and_4263;
  assign and_4263 = equal_1933_s4_q & (equal_3972_s4_q & (not_4245 & (select_2706 | select_2718)));
  // hls/stages/agreement.hpp:1088
  logic and_4268;
  assign and_4268 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4075 < cfg_hidden_frames_i));
  // hls/stages/patches.hpp:313
  logic and_4275;
  assign and_4275 = equal_1933_s4_q & (x_s4_q[6] & (not_2317_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/agreement.hpp:1082
  logic [31:0] select_4283;
  assign select_4283 = equal_2000_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4281_s4_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4284;
  assign select_4284 = equal_1998_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4283;
  logic [31:0] select_4285;
  assign select_4285 = equal_1996_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4284;
  logic [31:0] select_4286;
  assign select_4286 = equal_1994_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_4285;
  logic [31:0] select_4287;
  assign select_4287 = equal_1992_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_4286;
  logic [31:0] select_4288;
  assign select_4288 = equal_1990_s4_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4287;
  logic [31:0] select_4289;
  assign select_4289 = equal_1988_s4_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4288;
  logic [31:0] select_4290;
  assign select_4290 = equal_1986_s4_q ? {7'h0, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4289;
  // hls/stages/agreement.hpp:1080
  logic [9:0] select_4291;
  assign select_4291 = less_2866 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1084
  logic [31:0] select_4292;
  assign select_4292 = equal_1978_s4_q ? select_4290 : {2'h0, select_4291, select_2870, select_2867};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_491_s4_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s4_q, and_606, and_582_s4_q, and_581_s4_q, and_556_s4_q, less_548_s4_q, less_547_s4_q, less_546_s4_q, less_545_s4_q, less_544_s4_q, less_543_s4_q, less_542_s4_q, less_541_s4_q, less_540_s4_q, less_539_s4_q, less_538_s4_q, less_537_s4_q, less_536_s4_q, less_535_s4_q, less_534_s4_q, less_533_s4_q, less_532_s4_q, less_531_s4_q, less_530_s4_q, less_529_s4_q, less_528_s4_q, less_527_s4_q, less_526_s4_q, less_525_s4_q};
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
  assign registration_sums_waddr = {sum_1984_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_2043_s4_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2042, sum_2038};
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
  assign patches_choices_waddr = {patches_choosing_band_s4_q, and_2072_s4_q};
  logic patches_choices_we;
  assign patches_choices_we = s4_en & and_2145_s4_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2138_s4_q};
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
  assign patches_right_0_waddr = {select_2176_s4_q, select_2173};
  logic patches_right_0_we;
  assign patches_right_0_we = s4_en & (sample_pair_whole_s4_q & and_2185);
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
  assign patches_right_1_waddr = {select_2176_s4_q, select_2202};
  logic patches_right_1_we;
  assign patches_right_1_we = s4_en & (sample_pair_whole_s4_q & and_2205);
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
  assign patches_left_waddr = {select_2224, select_2223_s4_q, column_7};
  logic patches_left_we;
  assign patches_left_we = s4_en & (sample_pair_whole_s4_q & and_2230);
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
  assign patches_rows_wdata = select_2305;
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
  assign regions_waddr = {region_row_s4_q, or_2315_s4_q, or_2312_s4_q, or_2309_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_2343_s4_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2342, sum_2336, sum_2331};
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
  assign map_waddr = {sum_2383_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_2457_s4_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2447, is_seen};
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
      census_left_misses_q <= select_2606;
      sharpness_before_last_mask_q <= select_2614;
      sharpness_sums_detail_0_q <= and_491_s4_q ? select_2628 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_491_s4_q ? select_2640 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_491_s4_q ? sum_2644 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_491_s4_q ? sum_2648 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2666 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2676 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2678 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2680 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2682 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2684 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2689;
      sharpness_comparing_carry_1_q <= select_2693;
      sharpness_comparing_less_detail_0_q <= select_2700;
      sharpness_comparing_less_detail_1_q <= select_2706;
      sharpness_comparing_less_contrast_0_q <= select_2712;
      sharpness_comparing_less_contrast_1_q <= select_2718;
      counts_supervised_q <= select_2824;
      counts_textured_q <= and_2818_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_2827});
      counts_explained_q <= and_2818_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_2832});
      counts_nearer_q <= and_2818_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2837});
      counts_unproven_q <= and_2818_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2863});
      counts_regions_bad_q <= select_2879;
      counts_skin_supervised_q <= select_2886;
      counts_skin_textured_q <= select_2893;
      counts_skin_unproven_q <= select_2901;
      registration_half_across_q <= select_2953;
      registration_half_measured_q <= select_2958;
      registration_half_votes_down_q <= and_2933_s4_q ? 7'h0 : sum_2964;
      registration_half_votes_up_q <= and_2933_s4_q ? 7'h0 : sum_2972;
      registration_half_half_votes_down_q <= and_2933_s4_q ? 7'h0 : sum_2979;
      registration_half_half_votes_up_q <= and_2933_s4_q ? 7'h0 : sum_2986;
      registration_down_q <= and_3020 ? sum_3039 : registration_down_q;
      registration_up_q <= and_3020 ? sum_3048 : registration_up_q;
      registration_enough_q <= select_3062;
      registration_votes_down_q <= and_3067 ? less_3068 : registration_votes_down_q;
      registration_votes_up_q <= and_3067 ? less_3070 : registration_votes_up_q;
      registration_other_enough_q <= and_3076 ? select_3062 : registration_other_enough_q;
      registration_other_down_q <= and_3076 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3076 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1933_s4_q & and_3083)) & or_3108;
      patches_place_0_valid_q <= sample_pair_whole_s4_q ? select_2164 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s4_q ? select_2166 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s4_q ? select_2167 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3193;
      patches_place_1_valid_q <= sample_pair_whole_s4_q ? select_2193 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s4_q ? select_2195 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s4_q ? select_2196 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3198;
      patches_valid_0_q <= select_3203;
      patches_valid_1_q <= select_3208;
      patches_right_next_0_q <= select_3211;
      patches_right_next_1_q <= select_3214;
      patches_left_next_0_q <= select_3217;
      patches_left_next_1_q <= select_3220;
      patches_sums_values_0_q <= select_3636;
      patches_sums_values_1_q <= equal_2146_s4_q ? patches_sums_values_1_q : select_3637;
      patches_sums_values_2_q <= equal_2146_s4_q ? patches_sums_values_2_q : select_3639;
      patches_sums_values_3_q <= equal_2146_s4_q ? patches_sums_values_3_q : select_3641;
      patches_sums_values_4_q <= equal_2146_s4_q ? patches_sums_values_4_q : select_3643;
      patches_sums_values_5_q <= equal_2146_s4_q ? patches_sums_values_5_q : select_3645;
      patches_sums_values_6_q <= equal_2146_s4_q ? patches_sums_values_6_q : select_3647;
      patches_sums_values_7_q <= equal_2146_s4_q ? patches_sums_values_7_q : select_3649;
      patches_sums_values_8_q <= equal_2146_s4_q ? patches_sums_values_8_q : select_3651;
      patches_sums_values_9_q <= equal_2146_s4_q ? patches_sums_values_9_q : select_3653;
      patches_sums_values_10_q <= equal_2146_s4_q ? patches_sums_values_10_q : select_3655;
      patches_sums_values_11_q <= equal_2146_s4_q ? patches_sums_values_11_q : select_3657;
      patches_sums_values_12_q <= equal_2146_s4_q ? patches_sums_values_12_q : select_3659;
      patches_sums_values_13_q <= equal_2146_s4_q ? patches_sums_values_13_q : select_3661;
      patches_sums_values_14_q <= equal_2146_s4_q ? patches_sums_values_14_q : select_3663;
      patches_sums_values_15_q <= equal_2146_s4_q ? patches_sums_values_15_q : select_3665;
      patches_sums_values_16_q <= equal_2146_s4_q ? patches_sums_values_16_q : select_3667;
      patches_best_differing_q <= select_2305[9:0];
      patches_best_column_q <= select_2305[14:10];
      patches_quarters_0_places_q <= sum_3791;
      patches_quarters_0_up_q <= sum_3831;
      patches_quarters_0_down_q <= sum_3841;
      patches_quarters_1_places_q <= sum_3845;
      patches_quarters_1_up_q <= sum_3848;
      patches_quarters_1_down_q <= sum_3851;
      patches_quarters_2_places_q <= sum_3855;
      patches_quarters_2_up_q <= sum_3858;
      patches_quarters_2_down_q <= sum_3861;
      patches_quarters_3_places_q <= sum_3865;
      patches_quarters_3_up_q <= sum_3868;
      patches_quarters_3_down_q <= sum_3871;
      patches_word_places_q <= or_3908;
      patches_word_up_q <= or_3915;
      patches_word_down_q <= or_3922;
      patches_sum_places_q <= select_3935;
      patches_sum_up_q <= select_3938;
      patches_sum_down_q <= select_3941;
      patches_across_q <= sum_3953;
      patches_places_q <= select_3964;
      patches_enough_q <= {3'h0, and_3962, 1'b0} < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3968;
      patches_complete_q <= select_3970;
      patches_round_ends_q <= and_3976;
      patches_found_q <= and_3957 ? select_3979 : patches_found_q;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_moved_q <= select_3986;
      segment_textured_q <= select_2328 + {6'h0, and_2827};
      segment_explained_q <= select_2333 + {6'h0, and_2832};
      segment_nearer_q <= select_2339 + {6'h0, and_2837};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1933_s4_q ? select_4059 : good_q;
      good_known_q <= select_4063;
      hidden_for_q <= select_4077;
      product_q <= equal_1933_s4_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4098;
      disagree_q <= equal_1933_s4_q ? select_4051 : disagree_q;
      too_much_q <= equal_1933_s4_q ? select_4108 : too_much_q;
      hides_q <= equal_1933_s4_q ? select_4072 : hides_q;
      seen_q <= select_4230;
      nearer_q <= select_4233;
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
      averager_quarter_1_0_q <= select_2481;
      averager_quarter_1_1_q <= select_2483;
      averager_quarter_2_0_q <= select_2485;
      averager_quarter_2_1_q <= select_2487;
      averager_detail_0_q <= select_2499;
      averager_detail_1_q <= select_2507;
      census_changes_values_0_left_q <= and_491_s4_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_491_s4_q ? sum_2590 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2592;
      census_changes_values_1_right_q <= select_2593;
      census_changes_values_2_left_q <= select_2594;
      census_changes_values_2_right_q <= select_2595;
      sharpness_last_mask_q <= and_491_s4_q ? whole_2_s4_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_491_s4_q ? select_2611[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_491_s4_q ? select_2611[27:14] : sharpness_last_detail_1_q;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_4210_s5_q;
  logic or_4235_s5_q;
  logic and_4236_s5_q;
  logic and_4240_s5_q;
  logic and_4243_s5_q;
  logic and_4249_s5_q;
  logic and_4253_s5_q;
  logic and_4259_s5_q;
  logic and_4263_s5_q;
  logic and_4271_s5_q;
  logic and_4275_s5_q;
  logic [5:0] select_4277_s5_q;
  logic [31:0] select_4294_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= sample_pair_pixel_0_q;
      pixel_1_s5_q <= sample_pair_pixel_1_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= sample_of_skin_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_4210_s5_q <= said_q;
      or_4235_s5_q <= not_4234 | select_4230;
      and_4236_s5_q <= cfg_prove_i & select_4233;
      and_4240_s5_q <= and_4240_s4_q;
      and_4243_s5_q <= equal_1933_s4_q & (equal_3972_s4_q & (cfg_prove_i & or_4043));
      and_4249_s5_q <= and_4249;
      and_4253_s5_q <= equal_1933_s4_q & and_4252;
      and_4259_s5_q <= equal_1933_s4_q & (equal_3972_s4_q & (not_4245 & or_4256));
      and_4263_s5_q <= and_4263;
      and_4271_s5_q <= equal_1933_s4_q & (equal_3972_s4_q & (cfg_prove_i & and_4268));
      and_4275_s5_q <= and_4275;
      select_4277_s5_q <= equal_1933_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_4294_s5_q <= equal_1933_s4_q ? (x_s4_q[6] ? select_4292 : 32'h0) : 32'h0;
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
  assign marks_seen_o = or_4235_s5_q;
  assign marks_nearer_o = and_4236_s5_q;
  assign verdict_valid_o = and_4210_s5_q;
  assign verdict_unproven_yet_o = and_4240_s5_q;
  assign verdict_untextured_o = and_4243_s5_q;
  assign verdict_disagree_o = and_4249_s5_q;
  assign verdict_moved_o = and_4253_s5_q;
  assign verdict_unsharp_left_o = and_4259_s5_q;
  assign verdict_unsharp_right_o = and_4263_s5_q;
  assign verdict_hidden_o = and_4271_s5_q;
  assign frame_valid_o = and_4275_s5_q;
  assign frame_index_o = select_4277_s5_q;
  assign frame_word_o = select_4294_s5_q;
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
  assign unused_bits = ^{over[13:0], sum_3923[1:0], product_3821[4:0], sum_2923[0], detail_4[1:0], detail_3[1:0], sum_2600[4:0], sum_2086[0], sum_2082[0], sum_604[4:0], cfg_width_i[2:0]};

endmodule
