// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3080 bits, pipeline 850 bits, memories 66527 bits.
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
  input  logic [7:0] cfg_on_skin_cells_i,
  input  logic cfg_alarm_before_i,
  input  logic cfg_same_table_i,
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
  output logic verdict_out_of_step_o,
  output logic frame_valid_o,
  output logic [5:0] frame_index_o,
  output logic [31:0] frame_word_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q;
  logic s0_en, s1_en, s2_en, s3_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;

  // Of the configuration alone: not pipelined.
  logic not_2354;
  assign not_2354 = ~cfg_prove_i;
  logic [5:0] sum_2567;
  assign sum_2567 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3627;
  assign difference_3627 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3840;
  assign not_3840 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3898;
  assign difference_3898 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4145;
  assign less_4145 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4146;
  assign sum_4146 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_4147;
  assign select_4147 = less_4145 ? {sum_4146, cfg_height_i[5:3]} : 8'h0;

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
  logic averager_inside_q;
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
  // hls/stages/census.hpp:36
  logic [2:0] select_509;
  assign select_509 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_511;
  assign select_511 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:117
  logic equal_512;
  assign equal_512 = {select_511, select_509} == 9'h0;
  // hls/stages/census.hpp:121
  logic [7:0] select_515;
  assign select_515 = select_509[0] ? averager_place_q : (equal_512 ? 8'h0 : (averager_place_q + 8'h1));
  logic select_520;
  assign select_520 = select_509[0] ? averager_inside_q : (equal_512 | (averager_inside_q & (~(averager_place_q == 8'hbc))));
  // hls/stages/census.hpp:42
  logic or_521;
  assign or_521 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_523;
  assign and_523 = select_520 & (select_509[0] & or_521);
  // hls/stages/census.hpp:42
  logic [2:0] select_528;
  assign select_528 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] last;
  assign last = sample_pair_whole_q ? select_511 : 6'h0;
  // hls/stages/census.hpp:51
  logic equal_545;
  assign equal_545 = select_509 == 3'h7;
  // hls/stages/census.hpp:54
  logic equal_546;
  assign equal_546 = select_528 == 3'h7;
  // hls/stages/census.hpp:131
  logic and_547;
  assign and_547 = equal_546 & and_523;
  // hls/stages/agreement.hpp:276
  logic and_549;
  assign and_549 = sample_pair_whole_q & (equal_545 & and_547);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_578;
  assign equal_578 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:594
  logic or_579;
  assign or_579 = so | equal_578;
  // hls/stages/agreement.hpp:592
  logic [7:0] sum_580;
  assign sum_580 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_581;
  assign select_581 = run_shift_q[5] ? x_q : sum_580;
  logic less_582;
  assign less_582 = {2'h0, last_q} < select_581;
  // hls/stages/agreement.hpp:226
  logic not_583;
  assign not_583 = ~less_582;
  // hls/stages/agreement.hpp:614
  logic equal_593;
  assign equal_593 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_594;
  assign equal_594 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_595;
  assign and_595 = equal_594 & not_583;
  logic select_597;
  assign select_597 = or_579 ? not_583 : (equal_593 ? not_583 : and_595);
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:796
  logic [6:0] sum_611;
  assign sum_611 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:149
  logic and_616;
  assign and_616 = equal_593 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_611} < select_581))));
  logic select_617;
  assign select_617 = or_579 ? not_583 : and_616;
  // hls/stages/agreement.hpp:821
  logic [5:0] right;
  assign right = sum_580[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:720
  logic not_647;
  assign not_647 = ~or_579;
  // hls/stages/agreement.hpp:149
  logic and_650;
  assign and_650 = not_647 & ((~equal_593) & and_595);
  // hls/stages/census.hpp:42
  logic [5:0] select_677;
  assign select_677 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_677 : 6'h0;
  // hls/stages/patches.hpp:122
  logic and_1675;
  assign and_1675 = (select_509 == 3'h0) & (select_511 == 6'h0);
  // hls/stages/patches.hpp:392
  logic not_1676;
  assign not_1676 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_1679;
  assign not_1679 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:362
  logic and_1680;
  assign and_1680 = patches_capturing_q & not_1679;
  // hls/stages/patches.hpp:364
  logic equal_1681;
  assign equal_1681 = {or_521, select_528} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_1683;
  assign equal_1683 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1688;
  assign and_1688 = (not_1676 & (patches_work_q == 3'h0)) & (~(and_1680 | ((~equal_1681) | (~equal_1683))));
  // hls/stages/patches.hpp:534
  logic equal_1779;
  assign equal_1779 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:512
  logic not_1780;
  assign not_1780 = ~equal_1779;
  // hls/stages/patches.hpp:505
  logic equal_1781;
  assign equal_1781 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:458
  logic not_1782;
  assign not_1782 = ~equal_1781;
  // hls/stages/patches.hpp:499
  logic equal_1783;
  assign equal_1783 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1784;
  assign equal_1784 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:534
  logic or_1785;
  assign or_1785 = equal_1783 | equal_1784;
  // hls/stages/patches.hpp:460
  logic not_1786;
  assign not_1786 = ~patches_second_q;
  // hls/stages/patches.hpp:373
  logic [4:0] select_1808;
  assign select_1808 = and_1688 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1809;
  assign select_1809 = and_1675 ? select_1808 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1811;
  assign and_1811 = and_1680 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1815;
  assign select_1815 = and_1675 ? (and_1688 | (and_1680 & (~and_1811))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_1823;
  assign and_1823 = not_1780 & (not_1782 & (or_1785 & (patches_second_q & equal_1784)));
  // hls/stages/patches.hpp:167
  logic not_1840;
  assign not_1840 = ~equal_1784;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1856;
  assign select_1856 = and_1675 ? {select_1808[4], select_1808[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:458
  logic and_1866;
  assign and_1866 = not_1780 & (or_1785 & not_1782);
  // hls/stages/agreement.hpp:190
  logic and_1977;
  assign and_1977 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2148;
  assign select_2148 = sample_pair_whole_q ? (sample_last_q ? (select_528 + 3'h1) : select_528) : raster_at_y_q;
  logic [5:0] select_2150;
  assign select_2150 = sample_pair_whole_q ? (select_511 + {5'h0, equal_545}) : raster_at_column_q;
  logic [5:0] select_2153;
  assign select_2153 = sample_pair_whole_q ? (sample_last_q ? (select_677 + {5'h0, equal_546}) : select_677) : raster_at_row_q;
  logic select_2157;
  assign select_2157 = sample_pair_whole_q ? (sample_last_q ? (or_521 & (~raster_final_row_q)) : or_521) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2159;
  assign select_2159 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2163;
  assign select_2163 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [6:0] sum_2472;
  assign sum_2472 = {1'b0, last} + 7'h1;
  logic equal_2473;
  assign equal_2473 = {sum_2472[6], cfg_width_i[8:3]} == {1'b0, sum_2472[5:0]};
  // hls/stages/agreement.hpp:464
  logic and_2474;
  assign and_2474 = and_549 & equal_2473;
  // hls/stages/agreement.hpp:523
  logic select_2477;
  assign select_2477 = (and_2474 | (~ends_cell_q)) ? and_2474 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2477 ? (and_2474 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2481;
  assign select_2481 = select_2477 ? (and_2474 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2484;
  assign select_2484 = select_2477 ? (following_last_shift_q & (~and_2474)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2487;
  assign and_2487 = run_last_shift_q & equal_593;
  // hls/stages/agreement.hpp:616
  logic select_2489;
  assign select_2489 = equal_593 ? (~run_last_shift_q) : equal_594;
  // hls/stages/agreement.hpp:620
  logic equal_2490;
  assign equal_2490 = run_phase_q == 3'h1;
  logic not_2493;
  assign not_2493 = ~select_2489;
  // hls/stages/agreement.hpp:623
  logic equal_2495;
  assign equal_2495 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2496;
  assign and_2496 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2497;
  assign select_2497 = equal_2495 ? 2'h1 : {2{and_2496}};
  logic [2:0] select_2499;
  assign select_2499 = (and_2487 | (select_2489 | equal_2490)) ? (equal_2490 ? 3'h2 : {not_2493, {2{select_2489}}}) : (equal_578 ? 3'h6 : {select_2497[0], select_2497});
  // hls/stages/agreement.hpp:607
  logic and_2502;
  assign and_2502 = select_2489 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2505;
  assign select_2505 = (plan_shift_q[5] & select_2489) ? value : 7'h0;
  logic [1:0] or_2506;
  assign or_2506 = {2{so}} | select_2505[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] select_2507;
  assign select_2507 = select_2489 ? plan_columns_q : 8'h0;
  logic [6:0] or_2510;
  assign or_2510 = select_2507[6:0] | ((equal_2490 | equal_2495) ? whole_q : 7'h0);
  logic [1:0] or_2511;
  assign or_2511 = {2{and_2487}} | or_2510[3:2];
  // hls/stages/agreement.hpp:634
  logic [6:0] or_2513;
  assign or_2513 = {or_2510[6:4], or_2511, or_2510[1:0]} | (equal_578 ? drawn_q : 7'h0);
  logic [4:0] or_2514;
  assign or_2514 = {5{so}} | {or_2513[6], or_2513[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2518;
  assign not_2518 = ~run_shift_q[5];
  logic [6:0] difference_2520;
  assign difference_2520 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2521;
  assign select_2521 = equal_593 ? ({{7{not_2518}}, 1'b1} + run_span_q) : {difference_2520[6], difference_2520};
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2525;
  assign select_2525 = and_2474 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2527;
  assign select_2527 = select_2477 ? {select_2525[6], select_2525} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2530;
  assign select_2530 = select_2477 ? (and_2474 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [5:0] select_2538;
  assign select_2538 = and_549 ? (equal_2473 ? ((5'he < last[5:1]) ? 6'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2539;
  assign sum_2539 = {1'b0, last[5:2]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2541;
  assign select_2541 = and_549 ? (equal_2473 ? {sum_2539, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [4:0] sum_2542;
  assign sum_2542 = {1'b0, last[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2544;
  assign select_2544 = and_549 ? (equal_2473 ? {sum_2542, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2558;
  assign select_2558 = (ends_cell_q | select_2477) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_593 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2562;
  assign and_2562 = (~select_2477) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_2563;
  assign sum_2563 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_2565;
  assign select_2565 = equal_2473 ? ({sum_2563[6], cfg_height_i[8:3]} == {1'b0, sum_2563[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2941;
  assign select_2941 = and_1675 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2942;
  assign select_2942 = sample_pair_whole_q ? select_2941 : patches_phase_q;
  // hls/stages/patches.hpp:373
  logic and_2943;
  assign and_2943 = not_1679 & equal_1681;
  logic [8:0] select_2944;
  assign select_2944 = and_2943 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2945;
  assign select_2945 = and_2943 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2946;
  assign select_2946 = sample_pair_first_q ? select_2944 : select_2945;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2948;
  assign select_2948 = sample_pair_whole_q ? (and_1675 ? select_2946[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2950;
  assign select_2950 = sample_pair_whole_q ? (and_1675 ? select_2946[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2953;
  assign select_2953 = sample_pair_whole_q ? (equal_1683 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2955;
  assign select_2955 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1683}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2956;
  assign equal_2956 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_2957;
  assign not_2957 = ~equal_2956;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2959;
  assign select_2959 = sample_pair_whole_q ? (phase + {not_2957, 1'b1, not_2957, equal_2956}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_2961;
  assign equal_2961 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2965;
  assign select_2965 = equal_2961 ? ((select_2942 == 4'h6) ? 4'h0 : (select_2942 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2966;
  assign equal_2966 = select_2965 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2969;
  assign select_2969 = equal_2473 ? (equal_2966 ? 4'h6 : (select_2965 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2971;
  assign select_2971 = equal_2961 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2973;
  assign select_2973 = equal_2473 ? (select_2971 + {4'h0, equal_2966}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_2978;
  assign select_2978 = and_549 ? (equal_2473 ? ((6'h2 < row) & equal_2966) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2980;
  assign select_2980 = and_549 ? (equal_2473 ? select_2971 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:371
  logic or_3003;
  assign or_3003 = select_511[0] | select_677[5];
  logic [7:0] sum_3004;
  assign sum_3004 = {1'b0, select_511[2:1], or_3003, select_677[4:1]} + 8'h1;
  logic less_3005;
  assign less_3005 = {sum_3004, select_677[0], select_528, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3008;
  assign select_3008 = and_1675 ? (and_1688 ? (~less_3005) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:393
  logic or_3047;
  assign or_3047 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3053;
  assign and_3053 = equal_1779 & not_1786;
  // hls/stages/patches.hpp:399
  logic and_3054;
  assign and_3054 = not_1840 & and_3053;
  logic [1:0] select_3056;
  assign select_3056 = equal_1781 ? 2'h0 : (equal_1783 ? 2'h3 : {equal_1784, and_3054});
  // hls/stages/patches.hpp:279
  logic equal_3058;
  assign equal_3058 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3059;
  assign not_3059 = ~equal_3058;
  // hls/stages/patches.hpp:279
  logic equal_3060;
  assign equal_3060 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3061;
  assign not_3061 = ~equal_3060;
  // hls/stages/patches.hpp:283
  logic not_3063;
  assign not_3063 = ~(patches_following_q == 3'h2);
  logic and_3066;
  assign and_3066 = (~(patches_following_q == 3'h1)) & not_3063;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3067;
  assign select_3067 = equal_3060 ? 2'h2 : {and_3066, not_3063};
  logic [3:0] select_3068;
  assign select_3068 = equal_3058 ? 4'h2 : {select_3067, {2{not_3061}}};
  // hls/stages/patches.hpp:405
  logic not_3071;
  assign not_3071 = ~or_3047;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3076;
  assign select_3076 = or_3047 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3078;
  assign select_3078 = or_3047 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 47 x 33, DISTANCE 12, hls/stages/agreement.hpp:1372; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 33'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
`ifndef SYNTHESIS
  logic fresh_re;
  assign fresh_re = s0_en & and_650;
`endif
  logic [32:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 85, DISTANCE 12, hls/stages/agreement.hpp:1373; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [84:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 85'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
`ifndef SYNTHESIS
  logic left_re;
  assign left_re = s0_en & select_597;
`endif
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 99, DISTANCE 12, hls/stages/agreement.hpp:1374; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [98:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = or_579 ? x_q[5:0] : (equal_593 ? sum_580[5:0] : x_q[5:0]);
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s0_en & select_597;
`endif
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 62, DISTANCE 12, hls/stages/agreement.hpp:1375; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [61:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 62'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_579 ? x_q[5:0] : x[5:0];
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s0_en & select_617;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:779; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
`ifndef SYNTHESIS
  logic patches_right_0_re;
  assign patches_right_0_re = s0_en & (not_1780 & (not_1782 & (or_1785 & (equal_1784 & not_1786))));
`endif
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:779; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
`ifndef SYNTHESIS
  logic patches_right_1_re;
  assign patches_right_1_re = s0_en & and_1823;
`endif
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:780; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
`ifndef SYNTHESIS
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_1780 & (not_1782 & (not_1840 & or_1785)));
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:791; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 32'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
`ifndef SYNTHESIS
  logic patches_columns_above_re;
  assign patches_columns_above_re = s0_en & and_1866;
`endif
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
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
      averager_inside_q <= 1'b1;
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
    end else if (s0_en) begin
      left_first_q <= and_1977 ? left_first_q : marks_first_i;
      right_q <= (~and_1977) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1977;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_509 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2148;
      raster_at_column_q <= select_2150;
      raster_at_row_q <= select_2153;
      raster_at_live_q <= select_2157;
      raster_rows_left_q <= sample_pair_whole_q ? select_2159 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2163;
      averager_place_q <= sample_pair_whole_q ? select_515 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_520 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2481;
      run_last_shift_q <= select_2484;
      run_span_q <= select_2477 ? (and_2474 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2499;
      following_shift_q <= select_2489 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2502;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2505[6], or_2506, select_2505[3:0]};
      following_columns_q <= {select_2507[7], or_2514[4], or_2513[5:4], or_2514[3:0]};
      plan_shift_q <= equal_593 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2521;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2527;
      columns_left_q <= select_2530;
      last_q <= and_549 ? (equal_2473 ? last : last_q) : last_q;
      least_q <= select_2538;
      whole_q <= select_2541;
      drawn_q <= select_2544;
      age_q <= select_2477 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2477 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2558;
      ends_q <= and_2562;
      final_row_q <= and_549 ? select_2565 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2942;
      patches_band_rows_rows_to_next_q <= select_2948;
      patches_band_rows_number_q <= select_2950;
      patches_next_band_rows_to_next_q <= select_2953;
      patches_next_band_number_q <= select_2955;
      patches_first_band_rows_to_next_q <= select_2959;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2956 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_549 ? select_2969 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_549 ? select_2973 : patches_choosing_number_q;
      patches_chooses_q <= select_2978;
      patches_choosing_band_q <= select_2980;
      patches_capturing_q <= sample_pair_whole_q ? select_1815 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3008 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1809 : patches_row_q;
      patches_work_q <= or_3047 ? following : patches_work_q;
      patches_second_q <= not_1676 & (patches_second_q | (patches_ends_q & equal_1779));
      patches_following_q <= equal_1779 ? {2'h0, and_3053} : {equal_1781, select_3056};
      patches_following_beats_q <= {select_3068, not_3059};
      patches_begins_q <= sample_pair_whole_q & (and_1675 & and_1811);
      patches_ends_q <= not_3071 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3076;
      patches_code_row_q <= select_3078;
      patches_column_q <= or_3047 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3071 & (patches_column_q == 5'h1e);
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic marks_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_present_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [5:0] last_s1_q;
  logic [3:0] age_s1_q;
  logic [2:0] slot_s1_q;
  logic ends_cell_s1_q;
  logic shift_first_s1_q;
  logic [4:0] patches_band_rows_number_s1_q;
  logic patches_chooses_s1_q;
  logic [4:0] patches_choosing_band_s1_q;
  logic patches_lower_s1_q;
  logic patches_second_s1_q;
  logic [4:0] patches_code_row_s1_q;
  logic [4:0] patches_column_s1_q;
  logic [2:0] select_509_s1_q;
  logic [5:0] select_511_s1_q;
  logic [7:0] select_515_s1_q;
  logic and_523_s1_q;
  logic equal_529_s1_q;
  logic [5:0] last_s1_2_q;
  logic and_547_s1_q;
  logic and_549_s1_q;
  logic equal_574_s1_q;
  logic so_s1_q;
  logic equal_578_s1_q;
  logic or_579_s1_q;
  logic less_582_s1_q;
  logic not_583_s1_q;
  logic equal_593_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_617_s1_q;
  logic [5:0] right_s1_q;
  logic and_650_s1_q;
  logic [5:0] row_s1_q;
  logic and_1561_s1_q;
  logic equal_1562_s1_q;
  logic and_1675_s1_q;
  logic and_1688_s1_q;
  logic equal_1779_s1_q;
  logic not_1780_s1_q;
  logic equal_1781_s1_q;
  logic not_1782_s1_q;
  logic equal_1783_s1_q;
  logic equal_1784_s1_q;
  logic or_1785_s1_q;
  logic [4:0] select_1809_s1_q;
  logic select_1815_s1_q;
  logic [3:0] select_1856_s1_q;
  logic and_1866_s1_q;
  logic equal_2473_s1_q;
  logic and_2474_s1_q;
  logic or_3047_s1_q;
  logic not_3071_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s1_q <= pixel_0_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
      marks_first_s1_q <= marks_first_i;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      sample_present_s1_q <= sample_present_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      last_s1_q <= last_q;
      age_s1_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s1_q <= slot_q;
      ends_cell_s1_q <= ends_cell_q;
      shift_first_s1_q <= shift_first_q;
      patches_band_rows_number_s1_q <= patches_band_rows_number_q;
      patches_chooses_s1_q <= patches_chooses_q;
      patches_choosing_band_s1_q <= patches_choosing_band_q;
      patches_lower_s1_q <= patches_lower_q;
      patches_second_s1_q <= patches_second_q;
      patches_code_row_s1_q <= patches_code_row_q;
      patches_column_s1_q <= patches_column_q;
      select_509_s1_q <= select_509;
      select_511_s1_q <= select_511;
      select_515_s1_q <= select_515;
      and_523_s1_q <= and_523;
      equal_529_s1_q <= select_528 == 3'h0;
      last_s1_2_q <= last;
      and_547_s1_q <= and_547;
      and_549_s1_q <= and_549;
      equal_574_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_578_s1_q <= equal_578;
      or_579_s1_q <= or_579;
      less_582_s1_q <= less_582;
      not_583_s1_q <= not_583;
      equal_593_s1_q <= equal_593;
      x_s1_2_q <= x[6:0];
      select_617_s1_q <= select_617;
      right_s1_q <= right;
      and_650_s1_q <= and_650;
      row_s1_q <= row;
      and_1561_s1_q <= not_647 & and_616;
      equal_1562_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      and_1675_s1_q <= and_1675;
      and_1688_s1_q <= and_1688;
      equal_1779_s1_q <= equal_1779;
      not_1780_s1_q <= not_1780;
      equal_1781_s1_q <= equal_1781;
      not_1782_s1_q <= not_1782;
      equal_1783_s1_q <= equal_1783;
      equal_1784_s1_q <= equal_1784;
      or_1785_s1_q <= or_1785;
      select_1809_s1_q <= select_1809;
      select_1815_s1_q <= select_1815;
      select_1856_s1_q <= select_1856;
      and_1866_s1_q <= and_1866;
      equal_2473_s1_q <= equal_2473;
      and_2474_s1_q <= and_2474;
      or_3047_s1_q <= or_3047;
      not_3071_s1_q <= not_3071;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [11:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
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
  // hls/stages/census.hpp:124
  logic and_524;
  assign and_524 = sample_pair_whole_s1_q & and_523_s1_q;
  // hls/stages/agreement.hpp:668
  logic equal_568;
  assign equal_568 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_569;
  assign equal_569 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_568 & equal_569;
  // hls/stages/moments.hpp:57
  logic [11:0] select_572;
  assign select_572 = moments_starts_q ? 12'h1 : (moments_place_q + {11'h0, moments_taken_q});
  // hls/stages/agreement.hpp:788
  logic [10:0] select_573;
  assign select_573 = first ? 11'h0 : select_572[10:0];
  // hls/stages/agreement.hpp:1009
  logic not_575;
  assign not_575 = ~equal_574_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_577;
  assign not_577 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_579_s1_q & not_583_s1_q;
  // hls/stages/moments.hpp:63
  logic [11:0] place;
  assign place = first ? 12'h0 : select_572;
  // hls/stages/moments.hpp:104
  logic not_587;
  assign not_587 = ~(12'h66c < place);
  // hls/stages/agreement.hpp:788
  logic and_591;
  assign and_591 = not_575 & (not_577 & (equal_578_s1_q & (inside_v & not_587)));
  // hls/stages/agreement.hpp:975
  logic and_607;
  assign and_607 = (or_579_s1_q & (left_rdata_q[67] & not_583_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:968
  logic [5:0] select_626;
  assign select_626 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:668
  logic not_747;
  assign not_747 = ~equal_568;
  // hls/stages/agreement.hpp:671
  logic and_748;
  assign and_748 = left_rdata_q[12] & not_747;
  logic and_749;
  assign and_749 = left_rdata_q[30] & not_747;
  logic and_750;
  assign and_750 = left_rdata_q[48] & not_747;
  logic and_751;
  assign and_751 = left_rdata_q[66] & not_747;
  // hls/stages/agreement.hpp:672
  logic and_752;
  assign and_752 = right_codes_rdata_q[12] & not_747;
  logic and_753;
  assign and_753 = right_codes_rdata_q[27] & not_747;
  logic and_754;
  assign and_754 = right_codes_rdata_q[42] & not_747;
  logic and_755;
  assign and_755 = right_codes_rdata_q[57] & not_747;
  logic and_756;
  assign and_756 = right_codes_rdata_q[72] & not_747;
  logic and_757;
  assign and_757 = right_codes_rdata_q[85] & not_747;
  // hls/stages/agreement.hpp:221
  logic and_762;
  assign and_762 = left_rdata_q[48] & not_583_s1_q;
  logic and_763;
  assign and_763 = right_codes_rdata_q[42] & not_583_s1_q;
  logic [11:0] select_764;
  assign select_764 = less_582_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_765;
  assign select_765 = less_582_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_769;
  assign select_769 = and_762 ? (and_763 ? (~(select_764 ^ select_765)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_775;
  assign parity_775 = ^select_769[5:3];
  logic parity_778;
  assign parity_778 = ^select_769[8:6];
  logic parity_781;
  assign parity_781 = ^select_769[11:3];
  // hls/stages/agreement.hpp:221
  logic and_785;
  assign and_785 = left_rdata_q[66] & not_583_s1_q;
  logic and_786;
  assign and_786 = right_codes_rdata_q[57] & not_583_s1_q;
  logic [11:0] select_787;
  assign select_787 = less_582_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_788;
  assign select_788 = less_582_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_792;
  assign select_792 = and_785 ? (and_786 ? (~(select_787 ^ select_788)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_795;
  assign parity_795 = ^select_792[8:6];
  logic parity_798;
  assign parity_798 = ^select_792[11:9];
  // hls/stages/agreement.hpp:221
  logic and_802;
  assign and_802 = left_rdata_q[84] & not_583_s1_q;
  logic and_803;
  assign and_803 = right_codes_rdata_q[72] & not_583_s1_q;
  logic [11:0] select_804;
  assign select_804 = less_582_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_805;
  assign select_805 = less_582_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_809;
  assign select_809 = and_802 ? (and_803 ? (~(select_804 ^ select_805)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_815;
  assign parity_815 = ^select_809[2:0];
  logic parity_818;
  assign parity_818 = ^select_809[5:3];
  logic parity_821;
  assign parity_821 = ^select_809[8:0];
  logic parity_827;
  assign parity_827 = ^select_809[11:9];
  logic parity_830;
  assign parity_830 = ^select_792[2:0];
  logic parity_833;
  assign parity_833 = ^{select_809[11:9], select_792[5:0]};
  logic parity_836;
  assign parity_836 = ^{select_809, select_792, select_769[2:0]};
  logic xor_837;
  assign xor_837 = parity_781 ^ parity_836;
  // hls/stages/count_bits.hpp:23
  logic or_841;
  assign or_841 = (select_769[1:0] == 2'h3) | (select_769[2] & (select_769[0] | select_769[1]));
  // hls/stages/count_bits.hpp:25
  logic or_845;
  assign or_845 = (select_792[7:6] == 2'h3) | (select_792[8] & (select_792[6] | select_792[7]));
  logic or_849;
  assign or_849 = (select_792[10:9] == 2'h3) | (select_792[11] & (select_792[9] | select_792[10]));
  // hls/stages/count_bits.hpp:23
  logic or_857;
  assign or_857 = (select_809[7:6] == 2'h3) | (select_809[8] & (~(select_809[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_861;
  assign or_861 = (select_809[1:0] == 2'h3) | (select_809[2] & (select_809[0] | select_809[1]));
  logic or_865;
  assign or_865 = (select_809[4:3] == 2'h3) | (select_809[5] & (select_809[3] | select_809[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_868;
  assign parity_868 = ^{or_865, or_861, or_857};
  // hls/stages/count_bits.hpp:23
  logic or_872;
  assign or_872 = (select_792[4:3] == 2'h3) | (select_792[5] & (select_792[3] | select_792[4]));
  // hls/stages/count_bits.hpp:25
  logic or_876;
  assign or_876 = (select_809[10:9] == 2'h3) | (select_809[11] & (select_809[9] | select_809[10]));
  logic or_880;
  assign or_880 = (select_792[1:0] == 2'h3) | (select_792[2] & (select_792[0] | select_792[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_883;
  assign parity_883 = ^{or_880, or_876, or_872};
  logic parity_886;
  assign parity_886 = ^{or_880, or_876, or_872, or_865, or_861, or_857, or_849, or_845, or_841};
  // hls/stages/count_bits.hpp:25
  logic and_887;
  assign and_887 = parity_781 & parity_836;
  logic or_891;
  assign or_891 = (parity_775 & parity_778) | ((^select_769[11:9]) & (parity_775 | parity_778));
  logic and_894;
  assign and_894 = (^{select_792[11:6], select_769[2:0]}) & (parity_821 | parity_833);
  logic or_895;
  assign or_895 = (parity_821 & parity_833) | and_894;
  // hls/stages/count_bits.hpp:23
  logic or_902;
  assign or_902 = (select_769[10:9] == 2'h3) | (select_769[11] & (select_769[9] | select_769[10]));
  // hls/stages/count_bits.hpp:25
  logic or_906;
  assign or_906 = (select_769[4:3] == 2'h3) | (select_769[5] & (select_769[3] | select_769[4]));
  logic or_910;
  assign or_910 = (select_769[7:6] == 2'h3) | (select_769[8] & (select_769[6] | select_769[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_913;
  assign parity_913 = ^{or_910, or_906, or_902};
  // hls/stages/count_bits.hpp:25
  logic or_917;
  assign or_917 = (parity_795 & parity_798) | ((^select_769[2:0]) & (parity_795 | parity_798));
  logic or_921;
  assign or_921 = (parity_815 & parity_818) | ((^select_809[8:6]) & (parity_815 | parity_818));
  logic or_925;
  assign or_925 = (parity_827 & parity_830) | ((^select_792[5:3]) & (parity_827 | parity_830));
  // hls/stages/count_bits.hpp:24
  logic parity_928;
  assign parity_928 = ^{or_925, or_921, or_917};
  logic parity_931;
  assign parity_931 = ^{or_925, or_921, or_917, or_910, or_906, or_902, or_895, or_891, and_887};
  logic xor_932;
  assign xor_932 = parity_886 ^ parity_931;
  // hls/stages/count_bits.hpp:25
  logic and_933;
  assign and_933 = parity_886 & parity_931;
  logic or_937;
  assign or_937 = (parity_868 & parity_883) | ((^{or_849, or_845, or_841}) & (parity_868 | parity_883));
  logic or_941;
  assign or_941 = (parity_913 & parity_928) | ((^{or_895, or_891, and_887}) & (parity_913 | parity_928));
  logic or_948;
  assign or_948 = (or_845 & or_849) | (or_841 & (or_845 | or_849));
  logic or_952;
  assign or_952 = (or_861 & or_865) | (or_857 & (or_861 | or_865));
  logic or_956;
  assign or_956 = (or_876 & or_880) | (or_872 & (or_876 | or_880));
  // hls/stages/count_bits.hpp:24
  logic parity_959;
  assign parity_959 = ^{or_956, or_952, or_948};
  // hls/stages/count_bits.hpp:25
  logic or_963;
  assign or_963 = (or_891 & or_895) | (and_887 & (or_891 | or_895));
  logic or_967;
  assign or_967 = (or_906 & or_910) | (or_902 & (or_906 | or_910));
  logic or_971;
  assign or_971 = (or_921 & or_925) | (or_917 & (or_921 | or_925));
  // hls/stages/count_bits.hpp:24
  logic parity_974;
  assign parity_974 = ^{or_971, or_967, or_963};
  logic parity_977;
  assign parity_977 = ^{or_971, or_967, or_963, or_956, or_952, or_948, or_941, or_937, and_933};
  // hls/stages/count_bits.hpp:25
  logic or_981;
  assign or_981 = (parity_959 & parity_974) | ((^{or_941, or_937, and_933}) & (parity_959 | parity_974));
  logic or_985;
  assign or_985 = (or_937 & or_941) | (and_933 & (or_937 | or_941));
  logic or_989;
  assign or_989 = (or_952 & or_956) | (or_948 & (or_952 | or_956));
  logic or_993;
  assign or_993 = (or_967 & or_971) | (or_963 & (or_967 | or_971));
  // hls/stages/count_bits.hpp:24
  logic parity_998;
  assign parity_998 = ^{or_993, or_989, or_985, or_981};
  // hls/stages/count_bits.hpp:25
  logic or_1002;
  assign or_1002 = (or_989 & or_993) | (or_985 & (or_989 | or_993));
  logic and_1003;
  assign and_1003 = or_981 & (^{or_993, or_989, or_985});
  // hls/stages/count_bits.hpp:24
  logic xor_1004;
  assign xor_1004 = or_1002 ^ and_1003;
  // hls/stages/count_bits.hpp:27
  logic and_1005;
  assign and_1005 = or_1002 & and_1003;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1006;
  assign select_1006 = equal_593_s1_q ? {and_1005, xor_1004, parity_998, parity_977, xor_932, xor_837} : 6'h0;
  logic [5:0] column;
  assign column = or_579_s1_q ? 6'h0 : select_1006;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1017;
  assign select_1017 = (slot_s1_q[0] ? and_803 : and_786) ? (~(select_764 ^ (slot_s1_q[0] ? select_805 : select_788))) : 12'h0;
  logic [11:0] select_1018;
  assign select_1018 = and_762 ? select_1017 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1024;
  assign parity_1024 = ^select_1018[5:3];
  logic parity_1027;
  assign parity_1027 = ^select_1018[8:6];
  logic parity_1030;
  assign parity_1030 = ^select_1018[11:3];
  // hls/stages/agreement.hpp:221
  logic and_1034;
  assign and_1034 = right_codes_rdata_q[85] & not_583_s1_q;
  logic [11:0] select_1036;
  assign select_1036 = less_582_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1040;
  assign select_1040 = (slot_s1_q[0] ? and_1034 : and_803) ? (~(select_787 ^ (slot_s1_q[0] ? select_1036 : select_805))) : 12'h0;
  logic [11:0] select_1041;
  assign select_1041 = and_785 ? select_1040 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1044;
  assign parity_1044 = ^select_1041[8:6];
  logic parity_1047;
  assign parity_1047 = ^select_1041[11:9];
  // hls/stages/agreement.hpp:734
  logic select_1052;
  assign select_1052 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_583_s1_q) : and_1034;
  logic [11:0] select_1054;
  assign select_1054 = slot_s1_q[0] ? (less_582_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1036;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1058;
  assign select_1058 = and_802 ? (select_1052 ? (~(select_804 ^ select_1054)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1064;
  assign parity_1064 = ^select_1058[2:0];
  logic parity_1067;
  assign parity_1067 = ^select_1058[5:3];
  logic parity_1070;
  assign parity_1070 = ^select_1058[8:0];
  logic parity_1076;
  assign parity_1076 = ^select_1058[11:9];
  logic parity_1079;
  assign parity_1079 = ^select_1041[2:0];
  logic parity_1082;
  assign parity_1082 = ^{select_1058[11:9], select_1041[5:0]};
  logic parity_1085;
  assign parity_1085 = ^{select_1058, select_1041, select_1018[2:0]};
  logic xor_1086;
  assign xor_1086 = parity_1030 ^ parity_1085;
  // hls/stages/count_bits.hpp:23
  logic or_1090;
  assign or_1090 = (select_1018[1:0] == 2'h3) | (select_1018[2] & (select_1018[0] | select_1018[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1094;
  assign or_1094 = (select_1041[7:6] == 2'h3) | (select_1041[8] & (select_1041[6] | select_1041[7]));
  logic or_1098;
  assign or_1098 = (select_1041[10:9] == 2'h3) | (select_1041[11] & (select_1041[9] | select_1041[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1106;
  assign or_1106 = (select_1058[7:6] == 2'h3) | (select_1058[8] & (~(select_1058[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1110;
  assign or_1110 = (select_1058[1:0] == 2'h3) | (select_1058[2] & (select_1058[0] | select_1058[1]));
  logic or_1114;
  assign or_1114 = (select_1058[4:3] == 2'h3) | (select_1058[5] & (select_1058[3] | select_1058[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1117;
  assign parity_1117 = ^{or_1114, or_1110, or_1106};
  // hls/stages/count_bits.hpp:23
  logic or_1121;
  assign or_1121 = (select_1041[4:3] == 2'h3) | (select_1041[5] & (select_1041[3] | select_1041[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1125;
  assign or_1125 = (select_1058[10:9] == 2'h3) | (select_1058[11] & (select_1058[9] | select_1058[10]));
  logic or_1129;
  assign or_1129 = (select_1041[1:0] == 2'h3) | (select_1041[2] & (select_1041[0] | select_1041[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1132;
  assign parity_1132 = ^{or_1129, or_1125, or_1121};
  logic parity_1135;
  assign parity_1135 = ^{or_1129, or_1125, or_1121, or_1114, or_1110, or_1106, or_1098, or_1094, or_1090};
  // hls/stages/count_bits.hpp:25
  logic and_1136;
  assign and_1136 = parity_1030 & parity_1085;
  logic or_1140;
  assign or_1140 = (parity_1024 & parity_1027) | ((^select_1018[11:9]) & (parity_1024 | parity_1027));
  logic and_1143;
  assign and_1143 = (^{select_1041[11:6], select_1018[2:0]}) & (parity_1070 | parity_1082);
  logic or_1144;
  assign or_1144 = (parity_1070 & parity_1082) | and_1143;
  // hls/stages/count_bits.hpp:23
  logic or_1151;
  assign or_1151 = (select_1018[10:9] == 2'h3) | (select_1018[11] & (select_1018[9] | select_1018[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1155;
  assign or_1155 = (select_1018[4:3] == 2'h3) | (select_1018[5] & (select_1018[3] | select_1018[4]));
  logic or_1159;
  assign or_1159 = (select_1018[7:6] == 2'h3) | (select_1018[8] & (select_1018[6] | select_1018[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1162;
  assign parity_1162 = ^{or_1159, or_1155, or_1151};
  // hls/stages/count_bits.hpp:25
  logic or_1166;
  assign or_1166 = (parity_1044 & parity_1047) | ((^select_1018[2:0]) & (parity_1044 | parity_1047));
  logic or_1170;
  assign or_1170 = (parity_1064 & parity_1067) | ((^select_1058[8:6]) & (parity_1064 | parity_1067));
  logic or_1174;
  assign or_1174 = (parity_1076 & parity_1079) | ((^select_1041[5:3]) & (parity_1076 | parity_1079));
  // hls/stages/count_bits.hpp:24
  logic parity_1177;
  assign parity_1177 = ^{or_1174, or_1170, or_1166};
  logic parity_1180;
  assign parity_1180 = ^{or_1174, or_1170, or_1166, or_1159, or_1155, or_1151, or_1144, or_1140, and_1136};
  logic xor_1181;
  assign xor_1181 = parity_1135 ^ parity_1180;
  // hls/stages/count_bits.hpp:25
  logic and_1182;
  assign and_1182 = parity_1135 & parity_1180;
  logic or_1186;
  assign or_1186 = (parity_1117 & parity_1132) | ((^{or_1098, or_1094, or_1090}) & (parity_1117 | parity_1132));
  logic or_1190;
  assign or_1190 = (parity_1162 & parity_1177) | ((^{or_1144, or_1140, and_1136}) & (parity_1162 | parity_1177));
  logic or_1197;
  assign or_1197 = (or_1094 & or_1098) | (or_1090 & (or_1094 | or_1098));
  logic or_1201;
  assign or_1201 = (or_1110 & or_1114) | (or_1106 & (or_1110 | or_1114));
  logic or_1205;
  assign or_1205 = (or_1125 & or_1129) | (or_1121 & (or_1125 | or_1129));
  // hls/stages/count_bits.hpp:24
  logic parity_1208;
  assign parity_1208 = ^{or_1205, or_1201, or_1197};
  // hls/stages/count_bits.hpp:25
  logic or_1212;
  assign or_1212 = (or_1140 & or_1144) | (and_1136 & (or_1140 | or_1144));
  logic or_1216;
  assign or_1216 = (or_1155 & or_1159) | (or_1151 & (or_1155 | or_1159));
  logic or_1220;
  assign or_1220 = (or_1170 & or_1174) | (or_1166 & (or_1170 | or_1174));
  // hls/stages/count_bits.hpp:24
  logic parity_1223;
  assign parity_1223 = ^{or_1220, or_1216, or_1212};
  logic parity_1226;
  assign parity_1226 = ^{or_1220, or_1216, or_1212, or_1205, or_1201, or_1197, or_1190, or_1186, and_1182};
  // hls/stages/count_bits.hpp:25
  logic or_1230;
  assign or_1230 = (parity_1208 & parity_1223) | ((^{or_1190, or_1186, and_1182}) & (parity_1208 | parity_1223));
  logic or_1234;
  assign or_1234 = (or_1186 & or_1190) | (and_1182 & (or_1186 | or_1190));
  logic or_1238;
  assign or_1238 = (or_1201 & or_1205) | (or_1197 & (or_1201 | or_1205));
  logic or_1242;
  assign or_1242 = (or_1216 & or_1220) | (or_1212 & (or_1216 | or_1220));
  // hls/stages/count_bits.hpp:24
  logic parity_1247;
  assign parity_1247 = ^{or_1242, or_1238, or_1234, or_1230};
  // hls/stages/count_bits.hpp:25
  logic or_1251;
  assign or_1251 = (or_1238 & or_1242) | (or_1234 & (or_1238 | or_1242));
  logic and_1252;
  assign and_1252 = or_1230 & (^{or_1242, or_1238, or_1234});
  // hls/stages/count_bits.hpp:24
  logic xor_1253;
  assign xor_1253 = or_1251 ^ and_1252;
  // hls/stages/count_bits.hpp:27
  logic and_1254;
  assign and_1254 = or_1251 & and_1252;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1255;
  assign select_1255 = equal_593_s1_q ? {and_1254, xor_1253, parity_1247, parity_1226, xor_1181, xor_1086} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_579_s1_q ? 6'h0 : select_1255;
  // hls/stages/agreement.hpp:221
  logic and_1263;
  assign and_1263 = right_codes_rdata_q[27] & not_583_s1_q;
  // hls/stages/agreement.hpp:734
  logic select_1264;
  assign select_1264 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_583_s1_q) : and_1263;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1266;
  assign select_1266 = less_582_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:734
  logic [11:0] select_1267;
  assign select_1267 = slot_s1_q[0] ? (less_582_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1266;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1271;
  assign select_1271 = and_762 ? (select_1264 ? (~(select_764 ^ select_1267)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1277;
  assign parity_1277 = ^select_1271[5:3];
  logic parity_1280;
  assign parity_1280 = ^select_1271[8:6];
  logic parity_1283;
  assign parity_1283 = ^select_1271[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1291;
  assign select_1291 = (slot_s1_q[0] ? and_1263 : and_763) ? (~(select_787 ^ (slot_s1_q[0] ? select_1266 : select_765))) : 12'h0;
  logic [11:0] select_1292;
  assign select_1292 = and_785 ? select_1291 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1295;
  assign parity_1295 = ^select_1292[8:6];
  logic parity_1298;
  assign parity_1298 = ^select_1292[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1306;
  assign select_1306 = (slot_s1_q[0] ? and_763 : and_786) ? (~(select_804 ^ (slot_s1_q[0] ? select_765 : select_788))) : 12'h0;
  logic [11:0] select_1307;
  assign select_1307 = and_802 ? select_1306 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1313;
  assign parity_1313 = ^select_1307[2:0];
  logic parity_1316;
  assign parity_1316 = ^select_1307[5:3];
  logic parity_1319;
  assign parity_1319 = ^select_1307[8:0];
  logic parity_1325;
  assign parity_1325 = ^select_1307[11:9];
  logic parity_1328;
  assign parity_1328 = ^select_1292[2:0];
  logic parity_1331;
  assign parity_1331 = ^{select_1307[11:9], select_1292[5:0]};
  logic parity_1334;
  assign parity_1334 = ^{select_1307, select_1292, select_1271[2:0]};
  logic xor_1335;
  assign xor_1335 = parity_1283 ^ parity_1334;
  // hls/stages/count_bits.hpp:23
  logic or_1339;
  assign or_1339 = (select_1271[1:0] == 2'h3) | (select_1271[2] & (select_1271[0] | select_1271[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1343;
  assign or_1343 = (select_1292[7:6] == 2'h3) | (select_1292[8] & (select_1292[6] | select_1292[7]));
  logic or_1347;
  assign or_1347 = (select_1292[10:9] == 2'h3) | (select_1292[11] & (select_1292[9] | select_1292[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1355;
  assign or_1355 = (select_1307[7:6] == 2'h3) | (select_1307[8] & (~(select_1307[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1359;
  assign or_1359 = (select_1307[1:0] == 2'h3) | (select_1307[2] & (select_1307[0] | select_1307[1]));
  logic or_1363;
  assign or_1363 = (select_1307[4:3] == 2'h3) | (select_1307[5] & (select_1307[3] | select_1307[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1366;
  assign parity_1366 = ^{or_1363, or_1359, or_1355};
  // hls/stages/count_bits.hpp:23
  logic or_1370;
  assign or_1370 = (select_1292[4:3] == 2'h3) | (select_1292[5] & (select_1292[3] | select_1292[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1374;
  assign or_1374 = (select_1307[10:9] == 2'h3) | (select_1307[11] & (select_1307[9] | select_1307[10]));
  logic or_1378;
  assign or_1378 = (select_1292[1:0] == 2'h3) | (select_1292[2] & (select_1292[0] | select_1292[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1381;
  assign parity_1381 = ^{or_1378, or_1374, or_1370};
  logic parity_1384;
  assign parity_1384 = ^{or_1378, or_1374, or_1370, or_1363, or_1359, or_1355, or_1347, or_1343, or_1339};
  // hls/stages/count_bits.hpp:25
  logic and_1385;
  assign and_1385 = parity_1283 & parity_1334;
  logic or_1389;
  assign or_1389 = (parity_1277 & parity_1280) | ((^select_1271[11:9]) & (parity_1277 | parity_1280));
  logic and_1392;
  assign and_1392 = (^{select_1292[11:6], select_1271[2:0]}) & (parity_1319 | parity_1331);
  logic or_1393;
  assign or_1393 = (parity_1319 & parity_1331) | and_1392;
  // hls/stages/count_bits.hpp:23
  logic or_1400;
  assign or_1400 = (select_1271[10:9] == 2'h3) | (select_1271[11] & (select_1271[9] | select_1271[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1404;
  assign or_1404 = (select_1271[4:3] == 2'h3) | (select_1271[5] & (select_1271[3] | select_1271[4]));
  logic or_1408;
  assign or_1408 = (select_1271[7:6] == 2'h3) | (select_1271[8] & (select_1271[6] | select_1271[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1411;
  assign parity_1411 = ^{or_1408, or_1404, or_1400};
  // hls/stages/count_bits.hpp:25
  logic or_1415;
  assign or_1415 = (parity_1295 & parity_1298) | ((^select_1271[2:0]) & (parity_1295 | parity_1298));
  logic or_1419;
  assign or_1419 = (parity_1313 & parity_1316) | ((^select_1307[8:6]) & (parity_1313 | parity_1316));
  logic or_1423;
  assign or_1423 = (parity_1325 & parity_1328) | ((^select_1292[5:3]) & (parity_1325 | parity_1328));
  // hls/stages/count_bits.hpp:24
  logic parity_1426;
  assign parity_1426 = ^{or_1423, or_1419, or_1415};
  logic parity_1429;
  assign parity_1429 = ^{or_1423, or_1419, or_1415, or_1408, or_1404, or_1400, or_1393, or_1389, and_1385};
  logic xor_1430;
  assign xor_1430 = parity_1384 ^ parity_1429;
  // hls/stages/count_bits.hpp:25
  logic and_1431;
  assign and_1431 = parity_1384 & parity_1429;
  logic or_1435;
  assign or_1435 = (parity_1366 & parity_1381) | ((^{or_1347, or_1343, or_1339}) & (parity_1366 | parity_1381));
  logic or_1439;
  assign or_1439 = (parity_1411 & parity_1426) | ((^{or_1393, or_1389, and_1385}) & (parity_1411 | parity_1426));
  logic or_1446;
  assign or_1446 = (or_1343 & or_1347) | (or_1339 & (or_1343 | or_1347));
  logic or_1450;
  assign or_1450 = (or_1359 & or_1363) | (or_1355 & (or_1359 | or_1363));
  logic or_1454;
  assign or_1454 = (or_1374 & or_1378) | (or_1370 & (or_1374 | or_1378));
  // hls/stages/count_bits.hpp:24
  logic parity_1457;
  assign parity_1457 = ^{or_1454, or_1450, or_1446};
  // hls/stages/count_bits.hpp:25
  logic or_1461;
  assign or_1461 = (or_1389 & or_1393) | (and_1385 & (or_1389 | or_1393));
  logic or_1465;
  assign or_1465 = (or_1404 & or_1408) | (or_1400 & (or_1404 | or_1408));
  logic or_1469;
  assign or_1469 = (or_1419 & or_1423) | (or_1415 & (or_1419 | or_1423));
  // hls/stages/count_bits.hpp:24
  logic parity_1472;
  assign parity_1472 = ^{or_1469, or_1465, or_1461};
  logic parity_1475;
  assign parity_1475 = ^{or_1469, or_1465, or_1461, or_1454, or_1450, or_1446, or_1439, or_1435, and_1431};
  // hls/stages/count_bits.hpp:25
  logic or_1479;
  assign or_1479 = (parity_1457 & parity_1472) | ((^{or_1439, or_1435, and_1431}) & (parity_1457 | parity_1472));
  logic or_1483;
  assign or_1483 = (or_1435 & or_1439) | (and_1431 & (or_1435 | or_1439));
  logic or_1487;
  assign or_1487 = (or_1450 & or_1454) | (or_1446 & (or_1450 | or_1454));
  logic or_1491;
  assign or_1491 = (or_1465 & or_1469) | (or_1461 & (or_1465 | or_1469));
  // hls/stages/count_bits.hpp:24
  logic parity_1496;
  assign parity_1496 = ^{or_1491, or_1487, or_1483, or_1479};
  // hls/stages/count_bits.hpp:25
  logic or_1500;
  assign or_1500 = (or_1487 & or_1491) | (or_1483 & (or_1487 | or_1491));
  logic and_1501;
  assign and_1501 = or_1479 & (^{or_1491, or_1487, or_1483});
  // hls/stages/count_bits.hpp:24
  logic xor_1502;
  assign xor_1502 = or_1500 ^ and_1501;
  // hls/stages/count_bits.hpp:27
  logic and_1503;
  assign and_1503 = or_1500 & and_1501;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1504;
  assign select_1504 = equal_593_s1_q ? {and_1503, xor_1502, parity_1496, parity_1475, xor_1430, xor_1335} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_579_s1_q ? 6'h0 : select_1504;
  // hls/stages/agreement.hpp:788
  logic and_1572;
  assign and_1572 = ends_cell_s1_q & inside_v;
  logic and_1574;
  assign and_1574 = not_575 & (so_s1_q & and_1572);
  logic [5:0] select_1578;
  assign select_1578 = so_s1_q ? x_s1_q[5:0] : (or_579_s1_q ? (less_582_s1_q ? 6'h0 : select_626) : 6'h0);
  // hls/stages/agreement.hpp:247
  logic or_1582;
  assign or_1582 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_1591;
  assign and_1591 = or_579_s1_q & (slot_s1_q[2] & not_583_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1707;
  assign select_1707 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1707[16:7])) ? 8'h7f : select_1707[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1784_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1784_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:500
  logic less_1872;
  assign less_1872 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:501
  logic or_1873;
  assign or_1873 = equal_1783_s1_q | less_1872;
  // hls/stages/patches.hpp:504
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1878;
  assign select_1878 = equal_1783_s1_q ? patches_column_s1_q[0] : (or_1873 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1879;
  assign not_1879 = ~or_1873;
  // hls/stages/patches.hpp:501
  logic [4:0] sum_1880;
  assign sum_1880 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:503
  logic [4:0] select_1883;
  assign select_1883 = or_1873 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1880) + 5'h1) : sum_1880;
  // hls/stages/patches.hpp:505
  logic [4:0] select_1884;
  assign select_1884 = equal_1783_s1_q ? 5'h0 : select_1883;
  logic or_1885;
  assign or_1885 = equal_1783_s1_q | equal_1781_s1_q;
  // hls/stages/patches.hpp:481
  logic equal_1887;
  assign equal_1887 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1889;
  assign equal_1889 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:483
  logic and_1891;
  assign and_1891 = of_row & (~equal_1889);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1887 ? 2'h3 : {equal_1889, and_1891};
  // hls/stages/patches.hpp:469
  logic [8:0] sum_1894;
  assign sum_1894 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1895;
  assign sum_1895 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1894, pixel_2[0]} - {1'b0, sum_1895, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:471
  logic [11:0] sum_1897;
  assign sum_1897 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1898;
  assign sum_1898 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1897[11], sum_1897};
  logic [13:0] sum_1899;
  assign sum_1899 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1898, down_2[1]};
  logic [12:0] sum_1900;
  assign sum_1900 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1899[13:1];
  logic [14:0] sum_1901;
  assign sum_1901 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1900, sum_1899[0], down_2[0]};
  // hls/stages/patches.hpp:453
  logic or_1908;
  assign or_1908 = (sum_1901[8] & (~(sum_1901[7:0] == 8'h0))) | (~(sum_1901[13:9] == 5'h0));
  // hls/stages/patches.hpp:467
  logic [8:0] sum_1913;
  assign sum_1913 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1914;
  assign sum_1914 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1913};
  logic [10:0] sum_1915;
  assign sum_1915 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1914, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1916;
  assign sum_1916 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1915[10:1];
  // hls/stages/patches.hpp:468
  logic [11:0] smooth;
  assign smooth = {sum_1916, sum_1915[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:470
  logic [12:0] sum_1918;
  assign sum_1918 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1919;
  assign sum_1919 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1920;
  assign difference_1920 = {1'b0, sum_1918, smooth[0]} - {1'b0, sum_1919, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:453
  logic or_1927;
  assign or_1927 = (difference_1920[8] & (~(difference_1920[7:0] == 8'h0))) | (~(difference_1920[13:9] == 5'h0));
  // hls/stages/patches.hpp:482
  logic or_1935;
  assign or_1935 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1889) | equal_1887;
  // hls/stages/patches.hpp:477
  logic and_1940;
  assign and_1940 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_1944;
  assign and_1944 = not_1782_s1_q & (or_1785_s1_q & (or_1935 & (equal_1784_s1_q & and_1940)));
  // hls/stages/patches.hpp:172
  logic and_1954;
  assign and_1954 = (~(equal_1784_s1_q | (~and_1940))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_1958;
  assign and_1958 = not_1782_s1_q & (or_1785_s1_q & (and_1954 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:546
  logic less_1960;
  assign less_1960 = patches_step_q[4:0] < 5'h11;
  logic equal_1961;
  assign equal_1961 = patches_step_q[6:5] == 2'h0;
  logic not_1962;
  assign not_1962 = ~equal_1961;
  logic equal_1963;
  assign equal_1963 = patches_step_q[6:5] == 2'h3;
  logic not_1964;
  assign not_1964 = ~equal_1963;
  // hls/stages/patches.hpp:560
  logic select_1967;
  assign select_1967 = equal_1963 ? (less_1960 & (less_1960 & not_1964)) : less_1960;
  // hls/stages/patches.hpp:184
  logic and_1970;
  assign and_1970 = equal_1779_s1_q & (less_1960 ? (not_1962 & select_1967) : select_1967);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1998;
  assign sum_1998 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:460
  logic select_2570;
  assign select_2570 = equal_2473_s1_q ? (~({row_s1_q, 1'b0} < {sum_2567, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_2831;
  assign and_2831 = and_549_s1_q & (equal_2473_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_2832;
  assign and_2832 = and_2474_s1_q & and_2831;
  // hls/stages/registration.hpp:127
  logic and_2834;
  assign and_2834 = and_2474_s1_q & (~and_2831);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2835;
  assign select_2835 = and_2834 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2837;
  assign select_2837 = and_2832 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2835[15]}}, select_2835});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2838;
  assign select_2838 = and_2834 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2838[15]}}, select_2838};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2840;
  assign select_2840 = and_2832 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_2841;
  assign and_2841 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2841 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_3086;
  assign select_3086 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3089;
  assign select_3089 = equal_1781_s1_q ? patches_smooth_values_0_q : (or_1785_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3091;
  assign select_3091 = or_1785_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3093;
  assign select_3093 = equal_1779_s1_q ? patches_smooth_values_1_q : (equal_1781_s1_q ? patches_smooth_values_1_q : select_3091);
  logic [11:0] select_3094;
  assign select_3094 = or_1785_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3096;
  assign select_3096 = equal_1779_s1_q ? patches_smooth_values_2_q : (equal_1781_s1_q ? patches_smooth_values_2_q : select_3094);
  logic [11:0] select_3097;
  assign select_3097 = or_1785_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3099;
  assign select_3099 = equal_1779_s1_q ? patches_smooth_values_3_q : (equal_1781_s1_q ? patches_smooth_values_3_q : select_3097);
  logic [10:0] select_3101;
  assign select_3101 = equal_1781_s1_q ? patches_down_values_0_q : (or_1785_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3104;
  assign select_3104 = equal_1781_s1_q ? patches_down_values_1_q : (or_1785_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3107;
  assign select_3107 = equal_1781_s1_q ? patches_down_values_2_q : (or_1785_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3110;
  assign select_3110 = equal_1781_s1_q ? patches_down_values_3_q : (or_1785_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3147;
  assign and_3147 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3152;
  assign select_3152 = or_3047_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3154;
  assign select_3154 = and_3147 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3510;
  assign select_3510 = equal_1779_s1_q ? patches_summed_down_by_q : (equal_1781_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:556
  logic and_3543;
  assign and_3543 = less_1960 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:560
  logic select_3546;
  assign select_3546 = equal_1963 ? (less_1960 ? (not_1964 & and_3543) : and_3543) : and_3543;
  // hls/stages/patches.hpp:184
  logic select_3549;
  assign select_3549 = equal_1779_s1_q ? (less_1960 ? (not_1962 & select_3546) : select_3546) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3888;
  assign select_3888 = so_s1_q ? (and_2841 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3890;
  assign sum_3890 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3891;
  assign select_3891 = sum_1998[5] ? {1'b1, sum_1998[4:0], region_across_rest_q[2:0]} : sum_3890;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3893;
  assign select_3893 = equal_2473_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3896;
  assign select_3896 = equal_2473_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:235; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_515_s1_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_524;
`endif
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:349; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [77:0] census_memory_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) census_memory_mem[i] = 78'h0;
`endif
  logic [5:0] census_memory_raddr;
  assign census_memory_raddr = last_s1_2_q;
`ifndef SYNTHESIS
  logic census_memory_re;
  assign census_memory_re = s1_en & and_549_s1_q;
`endif
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory moments_memory, 1645 x 4, DISTANCE 16, hls/stages/moments.hpp:119; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:1644];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1645; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [10:0] moments_memory_raddr;
  assign moments_memory_raddr = select_573;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_591;
`endif
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1376; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_579_s1_q ? select_626 : right_s1_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s1_en & select_617_s1_q;
`endif
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1377; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s1_q[5:0];
`ifndef SYNTHESIS
  logic shown_right_re;
  assign shown_right_re = s1_en & and_1574;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1378; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] left_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_turns_mem[i] = 2'h0;
`endif
  logic [5:0] left_turns_raddr;
  assign left_turns_raddr = x_s1_q[5:0];
`ifndef SYNTHESIS
  logic left_turns_re;
  assign left_turns_re = s1_en & and_1591;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1378; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [5:0] right_turns_raddr;
  assign right_turns_raddr = select_626;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s1_en & and_1591;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:796; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1884, not_1879, select_1878};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1885;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:797; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
`ifndef SYNTHESIS
  logic patches_left_codes_re;
  assign patches_left_codes_re = s1_en & (not_1780_s1_q & (new_row & equal_1781_s1_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:811; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
`ifndef SYNTHESIS
  logic patches_rows_re;
  assign patches_rows_re = s1_en & and_1970;
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1405; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[5:0];
`ifndef SYNTHESIS
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_1574;
`endif
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_650_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_751, left_rdata_q[65:49], and_750, left_rdata_q[47:31], and_749, left_rdata_q[29:13], and_748, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_650_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_757, right_codes_rdata_q[84:73], and_756, right_codes_rdata_q[71:60], and_755, right_codes_rdata_q[56:43], and_754, right_codes_rdata_q[41:28], and_753, right_codes_rdata_q[26:13], and_752, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s1_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s1_en & and_1866_s1_q;
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
      moments_place_q <= 12'h0;
      moments_taken_q <= 1'b0;
      moments_starts_q <= 1'b0;
      row_q <= 6'h0;
      lower_half_q <= 1'b0;
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
    end else if (s1_en) begin
      moments_place_q <= select_572;
      moments_taken_q <= not_575 & (not_577 & (equal_578_s1_q & inside_v));
      moments_starts_q <= not_575 & (not_577 & (equal_578_s1_q & (inside_v & first)));
      row_q <= and_549_s1_q ? (equal_2473_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_549_s1_q ? select_2570 : lower_half_q;
      registration_slope_row_q <= select_2837;
      registration_slope_change_q <= select_2840;
      registration_slope_q <= so_s1_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3071_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3071_s1_q & select_3086;
      patches_smooth_values_0_q <= equal_1779_s1_q ? patches_smooth_values_0_q : select_3089;
      patches_smooth_values_1_q <= select_3093;
      patches_smooth_values_2_q <= select_3096;
      patches_smooth_values_3_q <= select_3099;
      patches_down_values_0_q <= equal_1779_s1_q ? patches_down_values_0_q : select_3101;
      patches_down_values_1_q <= equal_1779_s1_q ? patches_down_values_1_q : select_3104;
      patches_down_values_2_q <= equal_1779_s1_q ? patches_down_values_2_q : select_3107;
      patches_down_values_3_q <= equal_1779_s1_q ? patches_down_values_3_q : select_3110;
      patches_down_by_q <= or_3047_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3147});
      patches_along_q <= select_3152;
      patches_match_row_q <= or_3047_s1_q ? 4'h0 : select_3154;
      patches_summed_last_q <= not_1780_s1_q & (equal_1781_s1_q & and_3147);
      patches_summed_down_by_q <= select_3510;
      patches_step_q <= or_3047_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3549;
      region_across_rest_q <= select_3888;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3891;
      columns_begin_rest_q <= and_549_s1_q ? select_3893 : columns_begin_rest_q;
      columns_begin_back_q <= and_549_s1_q ? select_3896 : columns_begin_back_q;
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
      sums_0_columns_values_0_q <= column_2;
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
      sums_1_columns_values_0_q <= column_3;
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
  logic moments_starts_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [5:0] last_s2_q;
  logic [3:0] age_s2_q;
  logic [2:0] slot_s2_q;
  logic ends_cell_s2_q;
  logic lower_half_s2_q;
  logic shift_first_s2_q;
  logic [11:0] registration_slope_s2_q;
  logic [4:0] patches_band_rows_number_s2_q;
  logic patches_chooses_s2_q;
  logic [4:0] patches_choosing_band_s2_q;
  logic patches_lower_s2_q;
  logic patches_second_s2_q;
  logic [4:0] patches_code_row_s2_q;
  logic [4:0] patches_along_s2_q;
  logic patches_summed_last_s2_q;
  logic [4:0] patches_summed_down_by_s2_q;
  logic [4:0] patches_step_s2_q;
  logic patches_read_searches_s2_q;
  logic [2:0] select_509_s2_q;
  logic [5:0] select_511_s2_q;
  logic [7:0] select_515_s2_q;
  logic and_523_s2_q;
  logic and_524_s2_q;
  logic equal_529_s2_q;
  logic [5:0] last_s2_2_q;
  logic and_547_s2_q;
  logic and_549_s2_q;
  logic equal_569_s2_q;
  logic [10:0] select_573_s2_q;
  logic equal_574_s2_q;
  logic not_575_s2_q;
  logic so_s2_q;
  logic not_577_s2_q;
  logic equal_578_s2_q;
  logic or_579_s2_q;
  logic less_582_s2_q;
  logic not_583_s2_q;
  logic inside_v_s2_q;
  logic not_587_s2_q;
  logic and_591_s2_q;
  logic and_600_s2_q;
  logic and_608_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] right_s2_q;
  logic and_639_s2_q;
  logic and_644_s2_q;
  logic and_646_s2_q;
  logic equal_679_s2_q;
  logic [5:0] column_s2_q;
  logic [5:0] select_1257_s2_q;
  logic [5:0] select_1506_s2_q;
  logic and_1561_s2_q;
  logic equal_1562_s2_q;
  logic and_1572_s2_q;
  logic and_1574_s2_q;
  logic [5:0] select_1578_s2_q;
  logic or_1582_s2_q;
  logic and_1675_s2_q;
  logic and_1688_s2_q;
  logic less_1702_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1779_s2_q;
  logic equal_1781_s2_q;
  logic equal_1784_s2_q;
  logic or_1785_s2_q;
  logic [4:0] select_1809_s2_q;
  logic select_1815_s2_q;
  logic [3:0] select_1856_s2_q;
  logic less_1872_s2_q;
  logic new_row_s2_q;
  logic or_1885_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_1902_s2_q;
  logic or_1908_s2_q;
  logic and_1912_s2_q;
  logic and_1928_s2_q;
  logic and_1931_s2_q;
  logic and_1945_s2_q;
  logic and_1954_s2_q;
  logic and_1959_s2_q;
  logic less_1960_s2_q;
  logic equal_1961_s2_q;
  logic not_1962_s2_q;
  logic equal_1963_s2_q;
  logic not_1964_s2_q;
  logic and_1977_s2_q;
  logic select_1979_s2_q;
  logic and_1982_s2_q;
  logic sum_1998_s2_q;
  logic and_2019_s2_q;
  logic and_2137_s2_q;
  logic equal_2284_s2_q;
  logic equal_2473_s2_q;
  logic and_2600_s2_q;
  logic equal_2685_s2_q;
  logic less_3123_s2_q;
  logic equal_3466_s2_q;
  logic equal_3550_s2_q;
  logic less_3876_s2_q;
  logic equal_4095_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= sample_last_q;
      left_first_s2_q <= sample_pair_first_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      moments_starts_s2_q <= moments_starts_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      last_s2_q <= last_s1_q;
      age_s2_q <= age_s1_q;
      slot_s2_q <= slot_s1_q;
      ends_cell_s2_q <= ends_cell_s1_q;
      lower_half_s2_q <= lower_half_q;
      shift_first_s2_q <= shift_first_s1_q;
      registration_slope_s2_q <= registration_slope_q[27:16];
      patches_band_rows_number_s2_q <= patches_band_rows_number_s1_q;
      patches_chooses_s2_q <= patches_chooses_s1_q;
      patches_choosing_band_s2_q <= patches_choosing_band_s1_q;
      patches_lower_s2_q <= patches_lower_s1_q;
      patches_second_s2_q <= patches_second_s1_q;
      patches_code_row_s2_q <= patches_code_row_s1_q;
      patches_along_s2_q <= patches_along_q;
      patches_summed_last_s2_q <= patches_summed_last_q;
      patches_summed_down_by_s2_q <= patches_summed_down_by_q;
      patches_step_s2_q <= patches_step_q[4:0];
      patches_read_searches_s2_q <= patches_read_searches_q;
      select_509_s2_q <= select_509_s1_q;
      select_511_s2_q <= select_511_s1_q;
      select_515_s2_q <= select_515_s1_q;
      and_523_s2_q <= and_523_s1_q;
      and_524_s2_q <= and_524;
      equal_529_s2_q <= equal_529_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_547_s2_q <= and_547_s1_q;
      and_549_s2_q <= and_549_s1_q;
      equal_569_s2_q <= equal_569;
      select_573_s2_q <= select_573;
      equal_574_s2_q <= equal_574_s1_q;
      not_575_s2_q <= not_575;
      so_s2_q <= so_s1_q;
      not_577_s2_q <= not_577;
      equal_578_s2_q <= equal_578_s1_q;
      or_579_s2_q <= or_579_s1_q;
      less_582_s2_q <= less_582_s1_q;
      not_583_s2_q <= not_583_s1_q;
      inside_v_s2_q <= inside_v;
      not_587_s2_q <= not_587;
      and_591_s2_q <= and_591;
      and_600_s2_q <= or_579_s1_q & (left_rdata_q[70] & not_583_s1_q);
      and_608_s2_q <= (or_579_s1_q & (left_rdata_q[68] & not_583_s1_q)) & and_607;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_639_s2_q <= or_579_s1_q & (left_rdata_q[71] & not_583_s1_q);
      and_644_s2_q <= or_579_s1_q & (right_codes_rdata_q[58] & not_583_s1_q);
      and_646_s2_q <= or_579_s1_q & (right_codes_rdata_q[59] & not_583_s1_q);
      equal_679_s2_q <= row_s1_q == 6'h0;
      column_s2_q <= column;
      select_1257_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1506_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1561_s2_q <= and_1561_s1_q;
      equal_1562_s2_q <= equal_1562_s1_q;
      and_1572_s2_q <= and_1572;
      and_1574_s2_q <= and_1574;
      select_1578_s2_q <= select_1578;
      or_1582_s2_q <= or_1582;
      and_1675_s2_q <= and_1675_s1_q;
      and_1688_s2_q <= and_1688_s1_q;
      less_1702_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1779_s2_q <= equal_1779_s1_q;
      equal_1781_s2_q <= equal_1781_s1_q;
      equal_1784_s2_q <= equal_1784_s1_q;
      or_1785_s2_q <= or_1785_s1_q;
      select_1809_s2_q <= select_1809_s1_q;
      select_1815_s2_q <= select_1815_s1_q;
      select_1856_s2_q <= select_1856_s1_q;
      less_1872_s2_q <= less_1872;
      new_row_s2_q <= new_row;
      or_1885_s2_q <= or_1885;
      of_row_2_s2_q <= of_row_2;
      not_1902_s2_q <= ~sum_1901[14];
      or_1908_s2_q <= or_1908;
      and_1912_s2_q <= sum_1901[14] & (~(sum_1901[13:8] == 6'h3f));
      and_1928_s2_q <= (~difference_1920[14]) & or_1927;
      and_1931_s2_q <= difference_1920[14] & (~(difference_1920[13:8] == 6'h3f));
      and_1945_s2_q <= not_1780_s1_q & and_1944;
      and_1954_s2_q <= and_1954;
      and_1959_s2_q <= not_1780_s1_q & and_1958;
      less_1960_s2_q <= less_1960;
      equal_1961_s2_q <= equal_1961;
      not_1962_s2_q <= not_1962;
      equal_1963_s2_q <= equal_1963;
      not_1964_s2_q <= not_1964;
      and_1977_s2_q <= sample_pair_whole_q;
      select_1979_s2_q <= left_first_q;
      and_1982_s2_q <= right_q;
      sum_1998_s2_q <= sum_1998[5];
      and_2019_s2_q <= or_579_s1_q & (left_rdata_q[69] & not_583_s1_q);
      and_2137_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2284_s2_q <= (last_s1_2_q | row_s1_q) == 6'h0;
      equal_2473_s2_q <= equal_2473_s1_q;
      and_2600_s2_q <= or_579_s1_q & (not_583_s1_q & and_607);
      equal_2685_s2_q <= shift == 6'h0;
      less_3123_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3466_s2_q <= patches_match_row_q == 4'h0;
      equal_3550_s2_q <= patches_step_q[6:5] == 2'h2;
      less_3876_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4095_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
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
  logic [13:0] moments_turned_0_q;
  logic [13:0] moments_turned_1_q;
  logic [13:0] moments_before_0_q;
  logic [13:0] moments_before_1_q;
  logic moments_has_before_q;
  logic [13:0] moments_most_before_q;
  logic moments_left_begins_q;
  logic moments_left_alone_q;
  logic moments_left_other_stops_q;
  logic moments_right_begins_q;
  logic moments_right_alone_q;
  logic moments_right_other_stops_q;
  logic moments_out_of_step_q;
  logic moments_turns_0_q;
  logic moments_turns_1_q;
  logic moments_begins_alone_q;
  logic moments_ends_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [4:0] rows_passed_above_q;
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
  logic [13:0] counts_turned_left_q;
  logic [13:0] counts_turned_right_q;
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
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
  logic patches_frame_ended_q;
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
  // hls/stages/census.hpp:113
  logic [11:0] select_527;
  assign select_527 = select_509_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:126
  logic [11:0] sum_531;
  assign sum_531 = select_527 + (equal_529_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:113
  logic [11:0] sum_533;
  assign sum_533 = {4'h0, sample_pair_pixel_1_q} + (select_509_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:126
  logic [11:0] sum_535;
  assign sum_535 = sum_533 + (equal_529_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_509_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:127
  logic and_539;
  assign and_539 = whole & (averager_memory_rdata_q[24] | equal_529_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_509_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:128
  logic and_543;
  assign and_543 = all_of_skin & (averager_memory_rdata_q[25] | equal_529_s2_q);
  // hls/stages/census.hpp:215
  logic [8:0] grey;
  assign grey = and_523_s2_q ? sum_531[11:3] : 9'h0;
  // hls/stages/census.hpp:131
  logic equal_552;
  assign equal_552 = select_509_s2_q == 3'h1;
  // hls/stages/census.hpp:216
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_552 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_555;
  assign select_555 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:215
  logic [8:0] grey_2;
  assign grey_2 = and_523_s2_q ? sum_535[11:3] : 9'h0;
  // hls/stages/census.hpp:216
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_552 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_559;
  assign select_559 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:215
  logic and_560;
  assign and_560 = and_523_s2_q & and_539;
  // hls/stages/census.hpp:131
  logic select_562;
  assign select_562 = equal_552 ? and_560 : (averager_mask_q & and_560);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_562;
  // hls/stages/census.hpp:215
  logic and_564;
  assign and_564 = and_523_s2_q & and_543;
  // hls/stages/census.hpp:131
  logic select_566;
  assign select_566 = equal_552 ? and_564 : (averager_of_skin_q & and_564);
  // hls/stages/agreement.hpp:276
  logic and_567;
  assign and_567 = sample_pair_whole_s2_q & select_566;
  // hls/stages/agreement.hpp:978
  logic select_621;
  assign select_621 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_631;
  assign difference_631 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:993
  logic [9:0] sum_632;
  assign sum_632 = {difference_631[8], difference_631} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_634;
  assign and_634 = (and_608_s2_q & select_621) & ({{22{sum_632[9]}}, sum_632} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_636;
  assign and_636 = or_579_s2_q & (not_583_s2_q & and_634);
  // hls/stages/moments.hpp:77
  logic and_637;
  assign and_637 = and_600_s2_q & and_636;
  // hls/stages/census.hpp:305
  logic less_652;
  assign less_652 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_662;
  assign less_662 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_663;
  assign less_663 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:306
  logic less_664;
  assign less_664 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_674;
  assign less_674 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_675;
  assign less_675 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_676;
  assign equal_676 = last_s2_2_q == 6'h0;
  logic [3:0] select_680;
  assign select_680 = equal_679_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_681;
  assign select_681 = equal_676 ? {select_680, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:287
  logic [3:0] select_682;
  assign select_682 = equal_676 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:310
  logic and_683;
  assign and_683 = select_681[4] & select_682[3];
  // hls/stages/census.hpp:297
  logic and_685;
  assign and_685 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_687;
  assign and_687 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_685);
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_687;
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
  // hls/stages/census.hpp:281
  logic [9:0] difference_710;
  assign difference_710 = {1'b0, select_555} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_711;
  assign xor_711 = difference_710[8:0] ^ {9{difference_710[9]}};
  logic [9:0] sum_712;
  assign sum_712 = {9'h0, difference_710[9]} + {1'b0, xor_711};
  logic [9:0] difference_713;
  assign difference_713 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_714;
  assign xor_714 = difference_713[8:0] ^ {9{difference_713[9]}};
  logic [9:0] sum_715;
  assign sum_715 = {9'h0, difference_713[9]} + {1'b0, xor_714};
  logic [9:0] difference_717;
  assign difference_717 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_718;
  assign xor_718 = difference_717[8:0] ^ {9{difference_717[9]}};
  logic [9:0] sum_719;
  assign sum_719 = {9'h0, difference_717[9]} + {1'b0, xor_718};
  logic [10:0] sum_720;
  assign sum_720 = ({1'b0, sum_712} + {1'b0, sum_715}) + {1'b0, sum_719};
  logic [9:0] difference_721;
  assign difference_721 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_722;
  assign xor_722 = difference_721[8:0] ^ {9{difference_721[9]}};
  logic [9:0] sum_723;
  assign sum_723 = {9'h0, difference_721[9]} + {1'b0, xor_722};
  logic [9:0] difference_725;
  assign difference_725 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_726;
  assign xor_726 = difference_725[8:0] ^ {9{difference_725[9]}};
  // hls/stages/agreement.hpp:456
  logic and_734;
  assign and_734 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_735;
  assign and_735 = and_683 & and_734;
  // hls/stages/census.hpp:317
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_737;
  assign sum_737 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:317
  logic and_739;
  assign and_739 = and_735 & ({{5{sum_737[6]}}, sum_737, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:318
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_743;
  assign sum_743 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:807
  logic or_759;
  assign or_759 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:808
  logic select_761;
  assign select_761 = or_759 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1008;
  assign select_1008 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1009;
  assign difference_1009 = {1'b0, column_s2_q} - {1'b0, select_1008};
  logic [7:0] sum_1011;
  assign sum_1011 = {difference_1009[6], difference_1009} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:755
  logic [7:0] select_1012;
  assign select_1012 = slot_s2_q[0] ? chosen_score_q : sum_1011;
  // hls/stages/agreement.hpp:778
  logic [6:0] difference_1258;
  assign difference_1258 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1257_s2_q};
  // hls/stages/agreement.hpp:749
  logic equal_1259;
  assign equal_1259 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:778
  logic [7:0] sum_1261;
  assign sum_1261 = {difference_1258[6], difference_1258} + (equal_1259 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1507;
  assign difference_1507 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1506_s2_q};
  logic [7:0] sum_1509;
  assign sum_1509 = {difference_1507[6], difference_1507} + (equal_1259 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:751
  logic less_1510;
  assign less_1510 = sum_1261 < sum_1509;
  logic [7:0] select_1511;
  assign select_1511 = less_1510 ? sum_1509 : sum_1261;
  logic less_1512;
  assign less_1512 = select_1012 < select_1511;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1512 ? select_1511 : select_1012) : 8'h0;
  // hls/stages/agreement.hpp:808
  logic or_1516;
  assign or_1516 = select_761 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:813
  logic [5:0] select_1517;
  assign select_1517 = or_1516 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:720
  logic not_1518;
  assign not_1518 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:752
  logic [1:0] select_1519;
  assign select_1519 = less_1510 ? {slot_s2_q[0], not_1518} : 2'h0;
  logic [2:0] select_1521;
  assign select_1521 = less_1512 ? {select_1519, not_1518} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:813
  logic [2:0] select_1522;
  assign select_1522 = or_1516 ? select_1521 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1523;
  assign select_1523 = or_1516 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:810
  logic equal_1524;
  assign equal_1524 = select_1521 == 3'h1;
  logic or_1527;
  assign or_1527 = equal_1524 | (~(select_1521 == 3'h2));
  logic [7:0] select_1529;
  assign select_1529 = or_1527 ? before_0_q : before_1_q;
  logic [7:0] select_1530;
  assign select_1530 = equal_1524 ? (or_1527 ? sum_1261 : {7'h0, shift_not_right_q}) : select_1529;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1531;
  assign select_1531 = or_1516 ? select_1530 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1534;
  assign select_1534 = or_1516 ? (equal_1524 ? select_1529 : (or_1527 ? sum_1509 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1536;
  assign sum_1536 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1537;
  assign sum_1537 = {1'b0, before_v} + sum_1536;
  // hls/stages/agreement.hpp:755
  logic [6:0] select_1538;
  assign select_1538 = slot_s2_q[0] ? chosen_near_q : sum_1537;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1540;
  assign sum_1540 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1541;
  assign sum_1541 = {1'b0, before_v_2} + sum_1540;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1543;
  assign sum_1543 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1544;
  assign sum_1544 = {1'b0, before_v_3} + sum_1543;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1546;
  assign select_1546 = (sum_1541 < sum_1544) ? sum_1544 : sum_1541;
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1538 < select_1546) ? select_1546 : select_1538) : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_1550;
  assign less_1550 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:817
  logic [6:0] select_1552;
  assign select_1552 = select_761 ? of_near : (less_1550 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1554;
  assign select_1554 = select_761 ? run_shift_s2_q : (less_1550 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1557;
  assign select_1557 = (run_shift_s2_q == 6'h3f) ? of_best : (select_761 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:818
  logic [7:0] select_1560;
  assign select_1560 = (run_shift_s2_q == 6'h1) ? of_best : (select_761 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:823
  logic select_1563;
  assign select_1563 = or_759 ? shift_first_s2_q : equal_1562_s2_q;
  // hls/stages/agreement.hpp:824
  logic or_1565;
  assign or_1565 = select_1563 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_1566;
  assign select_1566 = or_1565 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1567;
  assign select_1567 = or_1565 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1569;
  assign or_1569 = select_1563 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:832
  logic [6:0] select_1570;
  assign select_1570 = or_1569 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1571;
  assign select_1571 = or_1569 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_1585;
  assign and_1585 = or_579_s2_q & (not_583_s2_q & (and_634 & or_1582_s2_q));
  // hls/stages/agreement.hpp:788
  logic and_1586;
  assign and_1586 = not_577_s2_q & and_1585;
  logic and_1589;
  assign and_1589 = not_575_s2_q & (so_s2_q ? and_1572_s2_q : (equal_578_s2_q & and_636));
  // hls/stages/moments.hpp:73
  logic and_1593;
  assign and_1593 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_1594;
  assign and_1594 = not_587_s2_q & and_1593;
  logic and_1597;
  assign and_1597 = not_587_s2_q & (and_1593 & (moments_memory_rdata_q[1] ^ and_639_s2_q));
  // hls/stages/moments.hpp:73
  logic and_1602;
  assign and_1602 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_1603;
  assign and_1603 = not_587_s2_q & and_1602;
  logic and_1606;
  assign and_1606 = not_587_s2_q & (and_1602 & (moments_memory_rdata_q[3] ^ and_646_s2_q));
  // hls/stages/agreement.hpp:1128
  logic equal_1607;
  assign equal_1607 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_1610;
  assign select_1610 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_1612;
  assign select_1612 = equal_1607 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1610});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1613;
  assign sum_1613 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_1614;
  assign select_1614 = equal_574_s2_q ? select_1612 : {sum_1613, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1615;
  assign equal_1615 = x_s2_q[5:0] == 6'h3f;
  logic equal_1617;
  assign equal_1617 = x_s2_q[5:0] == 6'h3e;
  logic equal_1619;
  assign equal_1619 = x_s2_q[5:0] == 6'h3d;
  logic equal_1621;
  assign equal_1621 = x_s2_q[5:0] == 6'h3c;
  logic equal_1623;
  assign equal_1623 = x_s2_q[5:0] == 6'h3b;
  logic equal_1625;
  assign equal_1625 = x_s2_q[5:0] == 6'h36;
  logic equal_1627;
  assign equal_1627 = x_s2_q[5:0] == 6'h35;
  logic equal_1629;
  assign equal_1629 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_1633;
  assign and_1633 = (~equal_1623) & ((~equal_1625) & ((~equal_1627) & (~equal_1629)));
  logic and_1637;
  assign and_1637 = (~equal_1615) & ((~equal_1617) & ((~equal_1619) & ((~equal_1621) & and_1633)));
  // hls/stages/agreement.hpp:1129
  logic less_1638;
  assign less_1638 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1642;
  assign or_1642 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1009
  logic [4:0] sum_1647;
  assign sum_1647 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1647, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1653;
  assign sum_1653 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1655;
  assign and_1655 = half_ends & ({{3{sum_1653[4]}}, sum_1653} < 8'h3);
  // hls/stages/agreement.hpp:788
  logic and_1656;
  assign and_1656 = so_s2_q & and_1655;
  logic select_1657;
  assign select_1657 = equal_574_s2_q ? (x_s2_q[6] & (equal_1607 ? and_1637 : (less_1638 & (~or_1642)))) : and_1656;
  // hls/stages/registration.hpp:258
  logic not_1659;
  assign not_1659 = ~lower_half_s2_q;
  logic [3:0] select_1660;
  assign select_1660 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1659, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1659};
  // hls/stages/patches.hpp:373
  logic [1:0] select_1689;
  assign select_1689 = and_1688_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1690;
  assign select_1690 = and_1688_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1691;
  assign select_1691 = and_1675_s2_q ? {select_1690, select_1689[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1692;
  assign select_1692 = and_1675_s2_q ? select_1689 : patches_fetch_q;
  logic equal_1693;
  assign equal_1693 = select_1692 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < x_s2_q;
  // hls/stages/agreement.hpp:788
  logic and_1701;
  assign and_1701 = not_575_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1703;
  assign equal_1703 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_579_s2_q ? (less_582_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1703 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1711;
  assign select_1711 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_1712;
  assign select_1712 = b[1] ? a : 8'h0;
  logic [8:0] sum_1713;
  assign sum_1713 = {{2{select_1711[6]}}, select_1711} + {select_1712[7], select_1712};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1714;
  assign select_1714 = b[2] ? a : 8'h0;
  logic [7:0] select_1715;
  assign select_1715 = b[3] ? a : 8'h0;
  logic [8:0] sum_1716;
  assign sum_1716 = {{2{select_1714[7]}}, select_1714[7:1]} + {select_1715[7], select_1715};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1717;
  assign sum_1717 = {{3{sum_1713[8]}}, sum_1713[8:1]} + {sum_1716[8], sum_1716, select_1714[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1718;
  assign select_1718 = b[4] ? a : 8'h0;
  logic [7:0] select_1719;
  assign select_1719 = b[5] ? a : 8'h0;
  logic [8:0] difference_1720;
  assign difference_1720 = {{2{select_1718[7]}}, select_1718[7:1]} - {select_1719[7], select_1719};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1721;
  assign sum_1721 = {difference_1720, select_1718[0]} + {sum_1717[10], sum_1717[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1703 ? {sum_1721, sum_1717[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1723;
  assign sum_1723 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_1726;
  assign and_1726 = less_1702_s2_q & (and_636 & ({{4{sum_1723[9]}}, sum_1723, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_1730;
  assign and_1730 = ({4'h0, last_s2_q[5:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1736;
  assign sum_1736 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1738;
  assign sum_1738 = {sum_1736[9], sum_1736[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1018
  logic and_1741;
  assign and_1741 = ($signed(9'h0) < $signed(sum_1736[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1738, sum_1736[0]})));
  logic and_1742;
  assign and_1742 = (~(and_1730 | (equal_569_s2_q | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1741;
  // hls/stages/agreement.hpp:788
  logic and_1746;
  assign and_1746 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1726 & and_1742)));
  logic and_1747;
  assign and_1747 = not_575_s2_q & and_1746;
  // hls/stages/patches.hpp:156
  logic and_1749;
  assign and_1749 = and_1747 & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_1750;
  assign select_1750 = and_1749 ? and_1747 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:788
  logic [6:0] select_1753;
  assign select_1753 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  // hls/stages/patches.hpp:344
  logic [6:0] select_1755;
  assign select_1755 = and_1749 ? (equal_574_s2_q ? 7'h0 : select_1753) : patches_choice_column_q;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1758;
  assign select_1758 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:344
  logic [5:0] select_1760;
  assign select_1760 = and_1749 ? (equal_574_s2_q ? 6'h0 : select_1758) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1761;
  assign sum_1761 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_1721[9]}}, sum_1721[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1764;
  assign select_1764 = ($signed(sum_1761[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1761[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1703 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1761[12:7])) ? 8'h7f : select_1764);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1769;
  assign select_1769 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:344
  logic [7:0] select_1771;
  assign select_1771 = and_1749 ? (equal_574_s2_q ? 8'h0 : select_1769) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_1772;
  assign equal_1772 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:788
  logic and_1776;
  assign and_1776 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1730 | equal_1772)));
  logic and_1777;
  assign and_1777 = not_575_s2_q & and_1776;
  // hls/stages/patches.hpp:344
  logic and_1778;
  assign and_1778 = patches_chooses_s2_q & and_1777;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1792;
  assign select_1792 = and_1675_s2_q ? select_1690 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_1793;
  assign equal_1793 = {patches_choosing_band_s2_q, and_1701} == {select_1792, select_1692[1]};
  // hls/stages/patches.hpp:486
  logic [2:0] sum_1893;
  assign sum_1893 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:453
  logic and_1909;
  assign and_1909 = not_1902_s2_q & or_1908_s2_q;
  // hls/stages/patches.hpp:490
  logic [1:0] sum_1949;
  assign sum_1949 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1985;
  assign select_1985 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1988;
  assign or_1988 = select_1985[7] | (~({select_1985[5], select_1985[3], select_1985[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_1991;
  assign or_1991 = select_1985[7] | (~({select_1985[6], select_1985[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_1994;
  assign or_1994 = select_1985[7] | (~(select_1985[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1995;
  assign select_1995 = equal_574_s2_q ? x_s2_q[5:0] : {region_row_q, or_1994, or_1991, or_1988};
  // hls/stages/agreement.hpp:1128
  logic not_1996;
  assign not_1996 = ~equal_1607;
  // hls/stages/agreement.hpp:1058
  logic or_2000;
  assign or_2000 = (~sum_1998_s2_q) | equal_1772;
  // hls/stages/agreement.hpp:788
  logic and_2003;
  assign and_2003 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_2000));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_579_s2_q & (not_583_s2_q & and_608_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_636;
  // hls/stages/agreement.hpp:149
  logic and_2021;
  assign and_2021 = or_579_s2_q & (not_583_s2_q & and_2019_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2030;
  assign and_2030 = inside_v_s2_q & and_2021;
  // hls/stages/agreement.hpp:1014
  logic select_2031;
  assign select_2031 = slot_s2_q[2] ? shown_shown_q : and_636;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2031);
  // hls/stages/agreement.hpp:1014
  logic select_2034;
  assign select_2034 = slot_s2_q[2] ? shown_nearer_q : and_1585;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2031 ? select_2034 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1271
  logic select_2037;
  assign select_2037 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1275
  logic select_2038;
  assign select_2038 = left_first_s2_q ? select_2037 : read_half_q;
  logic or_2039;
  assign or_2039 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2040;
  assign select_2040 = or_2039 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1277
  logic [9:0] select_2042;
  assign select_2042 = left_first_s2_q ? 10'h1 : (or_2039 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1280
  logic and_2043;
  assign and_2043 = select_2040[8] & select_2042[9];
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = and_2043 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [5:0] select_2046;
  assign select_2046 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2048;
  assign select_2048 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2046});
  // hls/stages/agreement.hpp:1301
  logic equal_2049;
  assign equal_2049 = seen_x_q == 3'h7;
  logic [7:0] select_2051;
  assign select_2051 = and_2043 ? 8'h0 : (seen_column_q + {7'h0, equal_2049});
  // hls/stages/agreement.hpp:1308
  logic [10:0] index;
  assign index = select_2048 + {3'h0, select_2051};
  // hls/stages/agreement.hpp:1261
  logic [11:0] sum_2053;
  assign sum_2053 = {1'b0, {2{select_2038}}, 2'h0, {2{select_2038}}, 1'b0, {2{select_2038}}, 1'b0, select_2038} + {1'b0, index};
  // hls/stages/agreement.hpp:1274
  logic not_2054;
  assign not_2054 = ~left_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2056;
  assign and_2056 = not_2054 & (began_q | and_2043);
  // hls/stages/agreement.hpp:1302
  logic [2:0] select_2058;
  assign select_2058 = and_2043 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1307
  logic and_2060;
  assign and_2060 = and_2056 & (select_2058 == 3'h0);
  logic less_2061;
  assign less_2061 = select_2051 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:438
  logic and_2062;
  assign and_2062 = and_2060 & less_2061;
  logic and_2063;
  assign and_2063 = and_1977_s2_q & and_2062;
  // hls/stages/agreement.hpp:278
  logic select_2065;
  assign select_2065 = and_1977_s2_q ? (left_first_s2_q ? and_2062 : and_2063) : and_2063;
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2067;
  assign sum_2067 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2067[7], sum_2067, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [11:0] sum_2069;
  assign sum_2069 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1030
  logic and_2070;
  assign and_2070 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2071;
  assign and_2071 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2072;
  assign and_2072 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2073;
  assign and_2073 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2075;
  assign sum_2075 = {1'b0, and_2072} + ({1'b0, textured} + {1'b0, and_2073});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2070} + ({2'h0, and_2071} + {1'b0, sum_2075});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2084;
  assign select_2084 = inside_v_s2_q ? (sum_1998_s2_q ? select_1985 : {select_1985[6:0], 1'b0}) : select_1985;
  // hls/stages/agreement.hpp:1050
  logic or_2087;
  assign or_2087 = select_2084[7] | (~({select_2084[5], select_2084[3], select_2084[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2104;
  assign and_2104 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2105;
  assign and_2105 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2106;
  assign and_2106 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2107;
  assign and_2107 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2109;
  assign sum_2109 = {1'b0, and_2106} + ({1'b0, shown} + {1'b0, and_2107});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2104} + ({2'h0, and_2105} + {1'b0, sum_2109});
  // hls/stages/agreement.hpp:1030
  logic and_2120;
  assign and_2120 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2121;
  assign and_2121 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2122;
  assign and_2122 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2123;
  assign and_2123 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2125;
  assign sum_2125 = {1'b0, and_2122} + ({1'b0, near} + {1'b0, and_2123});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2120} + ({2'h0, and_2121} + {1'b0, sum_2125});
  // hls/stages/agreement.hpp:788
  logic and_2141;
  assign and_2141 = ends_cell_s2_q & (and_2137_s2_q & (~({1'b0, sum_1647, last_s2_q[1:0]} < x_s2_q)));
  logic and_2143;
  assign and_2143 = not_575_s2_q & (so_s2_q & and_2141);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2175;
  assign select_2175 = sample_pair_whole_s2_q ? (and_547_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2177;
  assign select_2177 = sample_pair_whole_s2_q ? (and_547_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2197;
  assign select_2197 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2199;
  assign select_2199 = sample_pair_whole_s2_q ? (and_547_s2_q ? select_562 : averager_mask_q) : averager_mask_q;
  logic select_2201;
  assign select_2201 = sample_pair_whole_s2_q ? (and_547_s2_q ? select_566 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2202;
  assign select_2202 = and_549_s2_q ? select_555 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2203;
  assign select_2203 = and_549_s2_q ? select_559 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2205;
  assign select_2205 = and_549_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2206;
  assign select_2206 = and_549_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2207;
  assign select_2207 = and_549_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2208;
  assign select_2208 = and_549_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2209;
  assign select_2209 = and_549_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2210;
  assign select_2210 = and_549_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2211;
  assign select_2211 = and_549_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2212;
  assign select_2212 = and_549_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2213;
  assign select_2213 = and_549_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2214;
  assign select_2214 = and_549_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2215;
  assign select_2215 = and_549_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2216;
  assign select_2216 = and_549_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2217;
  assign select_2217 = and_549_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2218;
  assign select_2218 = and_549_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2219;
  assign select_2219 = and_549_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2220;
  assign select_2220 = and_549_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2221;
  assign select_2221 = and_549_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2222;
  assign select_2222 = and_549_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2223;
  assign select_2223 = and_549_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2224;
  assign select_2224 = and_549_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2225;
  assign select_2225 = and_549_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2226;
  assign select_2226 = and_549_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2227;
  assign select_2227 = and_549_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2228;
  assign select_2228 = and_549_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2229;
  assign select_2229 = and_549_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2230;
  assign select_2230 = and_549_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2231;
  assign select_2231 = and_549_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2232;
  assign select_2232 = and_549_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2233;
  assign select_2233 = and_549_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2234;
  assign select_2234 = and_549_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2235;
  assign select_2235 = and_549_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2236;
  assign select_2236 = and_549_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2237;
  assign select_2237 = and_549_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2238;
  assign select_2238 = and_549_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2239;
  assign select_2239 = and_549_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2240;
  assign select_2240 = and_549_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2241;
  assign select_2241 = and_549_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2242;
  assign select_2242 = and_549_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2243;
  assign select_2243 = and_549_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2244;
  assign select_2244 = and_549_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2245;
  assign select_2245 = and_549_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2246;
  assign select_2246 = and_549_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2247;
  assign select_2247 = and_549_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2248;
  assign select_2248 = and_549_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2249;
  assign select_2249 = and_549_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2250;
  assign select_2250 = and_549_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2251;
  assign select_2251 = and_549_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2252;
  assign select_2252 = and_549_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2253;
  assign select_2253 = and_549_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2254;
  assign select_2254 = and_549_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2255;
  assign select_2255 = and_549_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2256;
  assign select_2256 = and_549_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2257;
  assign select_2257 = and_549_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:283
  logic [9:0] difference_2259;
  assign difference_2259 = {1'b0, select_559} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2260;
  assign xor_2260 = difference_2259[8:0] ^ {9{difference_2259[9]}};
  logic [9:0] sum_2261;
  assign sum_2261 = {9'h0, difference_2259[9]} + {1'b0, xor_2260};
  logic [9:0] difference_2262;
  assign difference_2262 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2263;
  assign xor_2263 = difference_2262[8:0] ^ {9{difference_2262[9]}};
  logic [9:0] sum_2264;
  assign sum_2264 = {9'h0, difference_2262[9]} + {1'b0, xor_2263};
  logic [9:0] difference_2266;
  assign difference_2266 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2267;
  assign xor_2267 = difference_2266[8:0] ^ {9{difference_2266[9]}};
  logic [9:0] sum_2268;
  assign sum_2268 = {9'h0, difference_2266[9]} + {1'b0, xor_2267};
  logic [10:0] sum_2269;
  assign sum_2269 = ({1'b0, sum_2261} + {1'b0, sum_2264}) + {1'b0, sum_2268};
  logic [9:0] difference_2270;
  assign difference_2270 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2271;
  assign xor_2271 = difference_2270[8:0] ^ {9{difference_2270[9]}};
  logic [9:0] sum_2272;
  assign sum_2272 = {9'h0, difference_2270[9]} + {1'b0, xor_2271};
  logic [9:0] difference_2274;
  assign difference_2274 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2275;
  assign xor_2275 = difference_2274[8:0] ^ {9{difference_2274[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2296;
  assign sum_2296 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2298;
  assign sum_2298 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1142
  logic equal_2299;
  assign equal_2299 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2300;
  assign select_2300 = equal_2299 ? sum_2296 : moments_before_0_q;
  logic [13:0] select_2302;
  assign select_2302 = equal_2299 ? sum_2298 : moments_before_1_q;
  // hls/stages/agreement.hpp:788
  logic select_2305;
  assign select_2305 = equal_574_s2_q ? (moments_has_before_q | equal_2299) : moments_has_before_q;
  logic [13:0] select_2308;
  assign select_2308 = equal_574_s2_q ? ((select_2302 < select_2300) ? select_2300 : select_2302) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2309;
  assign sum_2309 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2312;
  assign select_2312 = equal_574_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2309)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2313;
  assign sum_2313 = {1'b0, sum_2298} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2316;
  assign select_2316 = equal_574_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2313)) : moments_left_alone_q;
  logic select_2319;
  assign select_2319 = equal_574_s2_q ? (~({3'h0, select_2302[13:2]} < sum_2313)) : moments_left_other_stops_q;
  logic select_2322;
  assign select_2322 = equal_574_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2309)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2323;
  assign sum_2323 = {1'b0, sum_2296} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2326;
  assign select_2326 = equal_574_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2323)) : moments_right_alone_q;
  logic select_2329;
  assign select_2329 = equal_574_s2_q ? (~({3'h0, select_2300[13:2]} < sum_2323)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2332;
  assign or_2332 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2340;
  assign and_2340 = not_575_s2_q & (not_577_s2_q & (equal_578_s2_q & (inside_v_s2_q & and_1597)));
  logic and_2344;
  assign and_2344 = not_575_s2_q & (not_577_s2_q & (equal_578_s2_q & (inside_v_s2_q & and_1606)));
  // hls/stages/moments.hpp:94
  logic and_2346;
  assign and_2346 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2349;
  assign select_2349 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2346)) : and_2346;
  // hls/stages/agreement.hpp:788
  logic and_2353;
  assign and_2353 = equal_574_s2_q & (equal_2299 & (cfg_prove_i & (cfg_same_table_i & select_2349)));
  // hls/stages/moments.hpp:95
  logic and_2356;
  assign and_2356 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:368
  logic [9:0] difference_2370;
  assign difference_2370 = {1'b0, select_555} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2370[9]} + (difference_2370[8:0] ^ {9{difference_2370[9]}});
  logic [9:0] difference_2382;
  assign difference_2382 = {1'b0, select_559} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2382[9]} + (difference_2382[8:0] ^ {9{difference_2382[9]}});
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2573;
  assign select_2573 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2574;
  assign select_2574 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2575;
  assign select_2575 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2576;
  assign select_2576 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2577;
  assign select_2577 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2578;
  assign select_2578 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2582;
  assign select_2582 = slot_s2_q[0] ? 8'h0 : sum_1011;
  // hls/stages/agreement.hpp:751
  logic less_2583;
  assign less_2583 = select_2582 < select_1511;
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2585;
  assign select_2585 = slot_s2_q[0] ? 7'h0 : sum_1537;
  // hls/stages/agreement.hpp:788
  logic not_2590;
  assign not_2590 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2591;
  assign less_2591 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_2598;
  assign and_2598 = and_549_s2_q & (equal_679_s2_q & equal_2473_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_2604;
  assign and_2604 = not_575_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2600_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_2624;
  assign and_2624 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2625;
  assign and_2625 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2626;
  assign and_2626 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2627;
  assign and_2627 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2629;
  assign sum_2629 = {1'b0, and_2626} + ({1'b0, explained} + {1'b0, and_2627});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2624} + ({2'h0, and_2625} + {1'b0, sum_2629});
  // hls/stages/agreement.hpp:788
  logic and_2665;
  assign and_2665 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2600_s2_q & and_2021)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2689;
  assign difference_2689 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2692;
  assign less_2692 = {2'h0, difference_2689[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_2695;
  assign and_2695 = not_583_s2_q & (((and_2019_s2_q & and_634) & equal_2685_s2_q) & (~less_2692));
  // hls/stages/agreement.hpp:788
  logic and_2699;
  assign and_2699 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_579_s2_q & and_2695)));
  // hls/stages/agreement.hpp:149
  logic and_2704;
  assign and_2704 = not_583_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2706;
  assign and_2706 = not_583_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2707;
  assign select_2707 = or_579_s2_q ? {and_2706, and_2704} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2709;
  assign select_2709 = less_582_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2710;
  assign select_2710 = or_579_s2_q ? select_2709 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_2712;
  assign and_2712 = and_636 & (select_2707[0] & select_2710[0]);
  // hls/stages/agreement.hpp:788
  logic and_2716;
  assign and_2716 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2707[1] & and_2712)));
  logic and_2717;
  assign and_2717 = not_575_s2_q & and_2716;
  logic and_2723;
  assign and_2723 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2710[1] & and_2712)));
  logic and_2724;
  assign and_2724 = not_575_s2_q & and_2723;
  // hls/stages/registration.hpp:76
  logic less_2727;
  assign less_2727 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2729;
  assign select_2729 = or_579_s2_q ? (less_582_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2731;
  assign select_2731 = or_579_s2_q ? (less_582_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2733;
  assign select_2733 = or_579_s2_q ? (less_582_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2731} - {1'b0, select_2733};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2735;
  assign select_2735 = rise_2[8] ? select_2731 : select_2733;
  logic [8:0] fall;
  assign fall = {1'b0, select_2729} - {1'b0, select_2735};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2738;
  assign not_2738 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2727 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2738};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2740;
  assign xor_2740 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2740};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2746;
  assign select_2746 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2727 ? {taken, 1'b1} : {not_2738, select_2746, not_2738};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2748;
  assign sum_2748 = {left, 1'b1} + {taken_2, less_2727};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2750;
  assign select_2750 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2752;
  assign select_2752 = equal_574_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_2754;
  assign select_2754 = equal_574_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2755;
  assign equal_2755 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_2759;
  assign and_2759 = and_636 & less_1702_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2761;
  assign select_2761 = or_579_s2_q ? (less_582_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2765;
  assign sum_2765 = select_2761[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2768;
  assign select_2768 = (select_2731 < select_2733) ? ({sum_2765, select_2761[0], 5'h0} - {3'h0, select_2750}) : {sum_2765, select_2761[0], select_2750};
  logic [7:0] select_2769;
  assign select_2769 = ((select_2761 == 3'h0) | (select_2761 == 3'h4)) ? {sum_2765, select_2761[0], 5'h0} : select_2768;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2769[7]}}, select_2769} - {sum_1721[9], sum_1721, sum_1717[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2772;
  assign select_2772 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2772[11:7])) ? 12'h7f : select_2772;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2793;
  assign difference_2793 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2795;
  assign and_2795 = and_2759 & ($signed(difference_2793) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2808;
  assign less_2808 = $signed(difference_2793) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_2816;
  assign select_2816 = so_s2_q ? (equal_2755 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2819;
  assign select_2819 = so_s2_q ? (equal_1703 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2824;
  assign select_2824 = (sum_1613 == 2'h2) ? (registration_fresh_q & (~select_1660)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2826;
  assign select_2826 = so_s2_q ? (and_1655 ? select_2824 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2828;
  assign select_2828 = and_2598 ? 4'hf : (equal_574_s2_q ? registration_fresh_q : select_2826);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1610;
  // hls/stages/registration.hpp:258
  logic not_2849;
  assign not_2849 = ~quarter_2[1];
  logic [3:0] select_2850;
  assign select_2850 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2849, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2849};
  // hls/stages/patches.hpp:91
  logic parity_2984;
  assign parity_2984 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2985;
  assign select_2985 = equal_2473_s2_q ? {patches_chance_q[14:0], parity_2984} : patches_chance_q;
  // hls/stages/patches.hpp:345
  logic not_2987;
  assign not_2987 = ~and_1777;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_2989;
  assign select_2989 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2989};
  // hls/stages/agreement.hpp:788
  logic and_2995;
  assign and_2995 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:156
  logic and_2999;
  assign and_2999 = not_2987 & (patches_fixed_q | ((not_575_s2_q & and_2995) & and_1749));
  // hls/stages/patches.hpp:354
  logic not_3012;
  assign not_3012 = ~select_1692[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3014;
  assign select_3014 = sample_pair_whole_s2_q ? (equal_1693 ? select_1692 : {not_3012, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:522
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3113;
  assign select_3113 = or_1785_s2_q ? {and_1931_s2_q, and_1928_s2_q, and_1912_s2_q, and_1909, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3115;
  assign select_3115 = equal_1779_s2_q ? patches_codes_at_q : (equal_1781_s2_q ? other[55:4] : select_3113);
  // hls/stages/patches.hpp:505
  logic [27:0] word;
  assign word = or_1885_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:521
  logic [27:0] select_3118;
  assign select_3118 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3120;
  assign select_3120 = equal_1781_s2_q ? (new_row_s2_q ? word : select_3118) : patches_codes_further_q;
  // hls/stages/patches.hpp:523
  logic [55:0] select_3122;
  assign select_3122 = less_1872_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:493
  logic [55:0] select_3124;
  assign select_3124 = less_3123_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3126;
  assign select_3126 = or_1785_s2_q ? (equal_1784_s2_q ? patches_next_codes_q : select_3124) : patches_next_codes_q;
  logic [55:0] select_3128;
  assign select_3128 = equal_1779_s2_q ? patches_next_codes_q : (equal_1781_s2_q ? select_3122 : select_3126);
  // hls/stages/count_bits.hpp:24
  logic parity_3133;
  assign parity_3133 = ^{and_1931_s2_q, and_1928_s2_q, and_1912_s2_q, and_1909};
  // hls/stages/count_bits.hpp:25
  logic or_3137;
  assign or_3137 = ({and_1912_s2_q, and_1909} == 2'h3) | (and_1928_s2_q & (and_1912_s2_q | and_1909));
  logic and_3138;
  assign and_3138 = and_1931_s2_q & (^{and_1928_s2_q, and_1912_s2_q, and_1909});
  // hls/stages/count_bits.hpp:24
  logic xor_3139;
  assign xor_3139 = or_3137 ^ and_3138;
  // hls/stages/count_bits.hpp:27
  logic and_3140;
  assign and_3140 = or_3137 & and_3138;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3142;
  assign select_3142 = or_1785_s2_q ? (and_1954_s2_q ? {and_3140, xor_3139, parity_3133} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3146;
  assign sum_3146 = {7'h0, patches_set_q} + (equal_1784_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:522
  logic [47:0] select_3156;
  assign select_3156 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3158;
  assign select_3158 = equal_1779_s2_q ? patches_left_row_q : (equal_1781_s2_q ? select_3156 : patches_left_row_q);
  // hls/stages/patches.hpp:524
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3156;
  // hls/stages/count_bits.hpp:24
  logic xor_3162;
  assign xor_3162 = bits[17] ^ (^{select_3156[16:15], other[16:15]});
  logic xor_3165;
  assign xor_3165 = bits[11] ^ (^{select_3156[10:9], other[10:9]});
  logic xor_3168;
  assign xor_3168 = bits[14] ^ (^{select_3156[13:12], other[13:12]});
  logic xor_3171;
  assign xor_3171 = xor_3162 ^ (^{select_3156[14:9], other[14:9]});
  logic xor_3174;
  assign xor_3174 = bits[47] ^ (^{select_3156[46:45], other[46:45]});
  logic xor_3177;
  assign xor_3177 = bits[8] ^ (^{select_3156[7:6], other[7:6]});
  logic xor_3180;
  assign xor_3180 = bits[2] ^ (^{select_3156[1:0], other[1:0]});
  logic xor_3183;
  assign xor_3183 = bits[5] ^ (^{select_3156[4:3], other[4:3]});
  logic xor_3186;
  assign xor_3186 = xor_3177 ^ (^{select_3156[5:0], other[5:0]});
  logic parity_3188;
  assign parity_3188 = ^{select_3156[47:45], select_3156[8:0], other[47:45], other[8:0]};
  logic xor_3189;
  assign xor_3189 = xor_3171 ^ parity_3188;
  logic xor_3192;
  assign xor_3192 = bits[44] ^ (^{select_3156[43:42], other[43:42]});
  logic xor_3195;
  assign xor_3195 = bits[38] ^ (^{select_3156[37:36], other[37:36]});
  logic xor_3198;
  assign xor_3198 = bits[41] ^ (^{select_3156[40:39], other[40:39]});
  logic xor_3204;
  assign xor_3204 = bits[26] ^ (^{select_3156[25:24], other[25:24]});
  logic xor_3207;
  assign xor_3207 = bits[20] ^ (^{select_3156[19:18], other[19:18]});
  logic xor_3210;
  assign xor_3210 = bits[23] ^ (^{select_3156[22:21], other[22:21]});
  logic xor_3213;
  assign xor_3213 = xor_3204 ^ (^{select_3156[23:18], other[23:18]});
  logic xor_3216;
  assign xor_3216 = bits[35] ^ (^{select_3156[34:33], other[34:33]});
  logic xor_3219;
  assign xor_3219 = bits[29] ^ (^{select_3156[28:27], other[28:27]});
  logic xor_3222;
  assign xor_3222 = bits[32] ^ (^{select_3156[31:30], other[31:30]});
  logic xor_3225;
  assign xor_3225 = xor_3216 ^ (^{select_3156[32:27], other[32:27]});
  logic xor_3226;
  assign xor_3226 = xor_3213 ^ xor_3225;
  // hls/stages/count_bits.hpp:25
  logic or_3234;
  assign or_3234 = (xor_3165 & xor_3168) | (xor_3162 & (xor_3165 | xor_3168));
  logic or_3238;
  assign or_3238 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3242;
  assign or_3242 = (xor_3180 & xor_3183) | (xor_3177 & (xor_3180 | xor_3183));
  // hls/stages/count_bits.hpp:23
  logic or_3249;
  assign or_3249 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3253;
  assign or_3253 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3257;
  assign or_3257 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3260;
  assign parity_3260 = ^{or_3257, or_3253, or_3249};
  // hls/stages/count_bits.hpp:23
  logic or_3264;
  assign or_3264 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3268;
  assign or_3268 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3272;
  assign or_3272 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3275;
  assign parity_3275 = ^{or_3272, or_3268, or_3264};
  logic parity_3278;
  assign parity_3278 = ^{or_3272, or_3268, or_3264, or_3257, or_3253, or_3249, or_3242, or_3238, or_3234};
  // hls/stages/count_bits.hpp:23
  logic or_3282;
  assign or_3282 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3286;
  assign or_3286 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3290;
  assign or_3290 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3298;
  assign or_3298 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3302;
  assign or_3302 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3306;
  assign or_3306 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3309;
  assign parity_3309 = ^{or_3306, or_3302, or_3298};
  // hls/stages/count_bits.hpp:23
  logic or_3313;
  assign or_3313 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3317;
  assign or_3317 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3321;
  assign or_3321 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3324;
  assign parity_3324 = ^{or_3321, or_3317, or_3313};
  logic parity_3327;
  assign parity_3327 = ^{or_3321, or_3317, or_3313, or_3306, or_3302, or_3298, or_3290, or_3286, or_3282};
  // hls/stages/count_bits.hpp:25
  logic or_3331;
  assign or_3331 = (xor_3195 & xor_3198) | (xor_3192 & (xor_3195 | xor_3198));
  logic or_3335;
  assign or_3335 = (xor_3207 & xor_3210) | (xor_3204 & (xor_3207 | xor_3210));
  logic or_3339;
  assign or_3339 = (xor_3219 & xor_3222) | (xor_3216 & (xor_3219 | xor_3222));
  // hls/stages/count_bits.hpp:24
  logic parity_3342;
  assign parity_3342 = ^{or_3339, or_3335, or_3331};
  // hls/stages/count_bits.hpp:25
  logic and_3343;
  assign and_3343 = xor_3189 & (^{xor_3226, select_3156[44:36], other[44:36]});
  logic or_3347;
  assign or_3347 = (xor_3174 & xor_3186) | (xor_3171 & (xor_3174 | xor_3186));
  logic and_3350;
  assign and_3350 = (xor_3192 ^ (^{select_3156[41:36], other[41:36]})) & (xor_3213 | xor_3225);
  logic or_3351;
  assign or_3351 = (xor_3213 & xor_3225) | and_3350;
  // hls/stages/count_bits.hpp:24
  logic parity_3354;
  assign parity_3354 = ^{or_3351, or_3347, and_3343};
  logic parity_3357;
  assign parity_3357 = ^{or_3351, or_3347, and_3343, or_3339, or_3335, or_3331, or_3321, or_3317, or_3313, or_3306, or_3302, or_3298, or_3290, or_3286, or_3282};
  logic parity_3359;
  assign parity_3359 = ^{or_3351, or_3347, and_3343, or_3339, or_3335, or_3331, or_3321, or_3317, or_3313, or_3306, or_3302, or_3298, or_3290, or_3286, or_3282, or_3272, or_3268, or_3264, or_3257, or_3253, or_3249, or_3242, or_3238, or_3234};
  // hls/stages/count_bits.hpp:25
  logic and_3360;
  assign and_3360 = parity_3278 & parity_3357;
  logic or_3364;
  assign or_3364 = (parity_3260 & parity_3275) | ((^{or_3242, or_3238, or_3234}) & (parity_3260 | parity_3275));
  logic or_3368;
  assign or_3368 = (parity_3342 & parity_3354) | (parity_3327 & (parity_3342 | parity_3354));
  logic or_3375;
  assign or_3375 = (parity_3309 & parity_3324) | ((^{or_3290, or_3286, or_3282}) & (parity_3309 | parity_3324));
  logic or_3379;
  assign or_3379 = (or_3335 & or_3339) | (or_3331 & (or_3335 | or_3339));
  logic or_3383;
  assign or_3383 = (or_3347 & or_3351) | (and_3343 & (or_3347 | or_3351));
  // hls/stages/count_bits.hpp:23
  logic or_3390;
  assign or_3390 = (or_3286 & or_3290) | (or_3282 & (or_3286 | or_3290));
  // hls/stages/count_bits.hpp:25
  logic or_3394;
  assign or_3394 = (or_3302 & or_3306) | (or_3298 & (or_3302 | or_3306));
  logic or_3398;
  assign or_3398 = (or_3317 & or_3321) | (or_3313 & (or_3317 | or_3321));
  // hls/stages/count_bits.hpp:24
  logic parity_3401;
  assign parity_3401 = ^{or_3398, or_3394, or_3390};
  // hls/stages/count_bits.hpp:23
  logic or_3405;
  assign or_3405 = (or_3238 & or_3242) | (or_3234 & (or_3238 | or_3242));
  // hls/stages/count_bits.hpp:25
  logic or_3409;
  assign or_3409 = (or_3253 & or_3257) | (or_3249 & (or_3253 | or_3257));
  logic or_3413;
  assign or_3413 = (or_3268 & or_3272) | (or_3264 & (or_3268 | or_3272));
  // hls/stages/count_bits.hpp:24
  logic parity_3416;
  assign parity_3416 = ^{or_3413, or_3409, or_3405};
  logic parity_3419;
  assign parity_3419 = ^{or_3413, or_3409, or_3405, or_3398, or_3394, or_3390, or_3383, or_3379, or_3375};
  logic parity_3421;
  assign parity_3421 = ^{or_3413, or_3409, or_3405, or_3398, or_3394, or_3390, or_3383, or_3379, or_3375, or_3368, or_3364, and_3360};
  // hls/stages/count_bits.hpp:25
  logic or_3425;
  assign or_3425 = (or_3379 & or_3383) | (or_3375 & (or_3379 | or_3383));
  logic or_3429;
  assign or_3429 = (or_3394 & or_3398) | (or_3390 & (or_3394 | or_3398));
  logic or_3433;
  assign or_3433 = (or_3409 & or_3413) | (or_3405 & (or_3409 | or_3413));
  // hls/stages/count_bits.hpp:24
  logic parity_3436;
  assign parity_3436 = ^{or_3433, or_3429, or_3425};
  // hls/stages/count_bits.hpp:25
  logic and_3437;
  assign and_3437 = (^{or_3368, or_3364, and_3360}) & parity_3419;
  logic or_3441;
  assign or_3441 = (or_3364 & or_3368) | (and_3360 & (or_3364 | or_3368));
  logic or_3445;
  assign or_3445 = (parity_3401 & parity_3416) | ((^{or_3383, or_3379, or_3375}) & (parity_3401 | parity_3416));
  // hls/stages/count_bits.hpp:24
  logic parity_3448;
  assign parity_3448 = ^{or_3445, or_3441, and_3437};
  // hls/stages/count_bits.hpp:25
  logic and_3450;
  assign and_3450 = parity_3436 & parity_3448;
  logic or_3454;
  assign or_3454 = (or_3429 & or_3433) | (or_3425 & (or_3429 | or_3433));
  logic or_3458;
  assign or_3458 = (or_3441 & or_3445) | (and_3437 & (or_3441 | or_3445));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3503;
  assign select_3503 = equal_1781_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3506;
  assign select_3506 = equal_1779_s2_q ? patches_summed_first_q : (equal_1781_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:556
  logic [9:0] select_3513;
  assign select_3513 = less_1960_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:560
  logic [9:0] select_3516;
  assign select_3516 = equal_1963_s2_q ? (less_1960_s2_q ? (equal_1963_s2_q ? 10'h0 : select_3513) : 10'h0) : select_3513;
  logic [9:0] select_3518;
  assign select_3518 = less_1960_s2_q ? (equal_1961_s2_q ? 10'h0 : select_3516) : select_3516;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3520;
  assign select_3520 = less_1960_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3523;
  assign select_3523 = equal_1963_s2_q ? (less_1960_s2_q ? (equal_1963_s2_q ? 5'h0 : select_3520) : 5'h0) : select_3520;
  logic [4:0] select_3525;
  assign select_3525 = less_1960_s2_q ? (equal_1961_s2_q ? 5'h0 : select_3523) : select_3523;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3527;
  assign select_3527 = less_1960_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3530;
  assign select_3530 = equal_1963_s2_q ? (less_1960_s2_q ? (equal_1963_s2_q ? 5'h0 : select_3527) : 5'h0) : select_3527;
  logic [4:0] select_3532;
  assign select_3532 = less_1960_s2_q ? (equal_1961_s2_q ? 5'h0 : select_3530) : select_3530;
  // hls/stages/patches.hpp:556
  logic and_3535;
  assign and_3535 = less_1960_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:560
  logic select_3538;
  assign select_3538 = equal_1963_s2_q ? (less_1960_s2_q ? (not_1964_s2_q & and_3535) : and_3535) : and_3535;
  // hls/stages/patches.hpp:184
  logic select_3541;
  assign select_3541 = equal_1779_s2_q ? (less_1960_s2_q ? (not_1962_s2_q & select_3538) : select_3538) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3552;
  assign or_3552 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3553;
  assign and_3553 = patches_read_searches_s2_q & or_3552;
  // hls/stages/patches.hpp:540
  logic [4:0] select_3554;
  assign select_3554 = and_3553 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:547
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3554};
  // hls/stages/patches.hpp:556
  logic and_3558;
  assign and_3558 = less_1960_s2_q & (equal_3550_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:560
  logic select_3561;
  assign select_3561 = equal_1963_s2_q ? (less_1960_s2_q ? (not_1964_s2_q & and_3558) : and_3558) : and_3558;
  // hls/stages/patches.hpp:184
  logic select_3564;
  assign select_3564 = equal_1779_s2_q ? (less_1960_s2_q ? (not_1962_s2_q & select_3561) : select_3561) : patches_read_above_q;
  // hls/stages/patches.hpp:556
  logic and_3567;
  assign and_3567 = less_1960_s2_q & (equal_3550_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:560
  logic select_3570;
  assign select_3570 = equal_1963_s2_q ? (less_1960_s2_q ? (not_1964_s2_q & and_3567) : and_3567) : and_3567;
  // hls/stages/patches.hpp:184
  logic select_3573;
  assign select_3573 = equal_1779_s2_q ? (less_1960_s2_q ? (not_1962_s2_q & select_3570) : select_3570) : patches_read_below_q;
  // hls/stages/patches.hpp:553
  logic [6:0] sum_3574;
  assign sum_3574 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:554
  logic [9:0] select_3577;
  assign select_3577 = (equal_3550_s2_q & ({sum_3574[6], sum_3574} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3578;
  assign select_3578 = less_1960_s2_q ? select_3577 : 10'h3ff;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3580;
  assign select_3580 = less_1960_s2_q ? (equal_1963_s2_q ? 10'h3ff : select_3578) : 10'h3ff;
  // hls/stages/patches.hpp:560
  logic [9:0] select_3581;
  assign select_3581 = equal_1963_s2_q ? select_3580 : select_3578;
  logic [9:0] select_3583;
  assign select_3583 = less_1960_s2_q ? (equal_1961_s2_q ? 10'h3ff : select_3581) : select_3581;
  // hls/stages/patches.hpp:539
  logic [14:0] select_3585;
  assign select_3585 = and_3553 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3586;
  assign select_3586 = equal_1779_s2_q ? select_3585[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3587;
  assign select_3587 = equal_1779_s2_q ? select_3585[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:541
  logic [9:0] select_3589;
  assign select_3589 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3591;
  assign select_3591 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3594;
  assign select_3594 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3595;
  assign select_3595 = patches_read_first_q ? patches_read_far_q : select_3594;
  // hls/stages/patches.hpp:594
  logic [9:0] difference_3598;
  assign difference_3598 = select_3595 - select_3585[9:0];
  // hls/stages/patches.hpp:579
  logic less_3628;
  assign less_3628 = select_3589 < select_3591;
  // hls/stages/patches.hpp:585
  logic [1:0] sum_3629;
  assign sum_3629 = select_3554[4:3] + 2'h3;
  // hls/stages/patches.hpp:580
  logic [9:0] high;
  assign high = less_3628 ? select_3591 : select_3589;
  logic [9:0] low;
  assign low = (select_3591 < select_3589) ? select_3591 : select_3589;
  // hls/stages/patches.hpp:581
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3585[9:0];
  // hls/stages/patches.hpp:583
  logic not_3636;
  assign not_3636 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3637;
  assign sum_3637 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3639;
  assign not_3639 = ~({eight, 3'h0} < {1'b0, sum_3637, fall_2[0]});
  logic [1:0] sum_3640;
  assign sum_3640 = {1'b0, not_3636} + {1'b0, not_3639};
  // hls/stages/patches.hpp:584
  logic [10:0] sum_3641;
  assign sum_3641 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3643;
  assign not_3643 = ~({eight, 3'h0} < {sum_3641, fall_2[1:0]});
  logic not_3646;
  assign not_3646 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3647;
  assign sum_3647 = {1'b0, not_3643} + {1'b0, not_3646};
  // hls/stages/patches.hpp:583
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3640} + {1'b0, sum_3647};
  // hls/stages/patches.hpp:586
  logic [7:0] select_3650;
  assign select_3650 = less_3628 ? ({sum_3629, select_3554[2:0], 3'h0} - {5'h0, fraction}) : {sum_3629, select_3554[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_3873;
  assign select_3873 = equal_574_s2_q ? shown_shown_q : (so_s2_q ? select_2031 : shown_shown_q);
  logic select_3875;
  assign select_3875 = equal_574_s2_q ? shown_nearer_q : (so_s2_q ? select_2034 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3877;
  assign sum_3877 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3879;
  assign select_3879 = less_3876_s2_q ? (sum_3877[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3881;
  assign select_3881 = equal_2473_s2_q ? (equal_679_s2_q ? 3'h0 : select_3879) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3886;
  assign select_3886 = equal_574_s2_q ? select_1985 : (so_s2_q ? (ends_cell_s2_q ? select_2084 : select_1985) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3900;
  assign select_3900 = equal_679_s2_q ? {{2{difference_3898[6]}}, difference_3898} : (less_3876_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3902;
  assign select_3902 = and_549_s2_q ? (equal_2473_s2_q ? select_3900 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_3904;
  assign select_3904 = equal_679_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_3906;
  assign select_3906 = and_549_s2_q ? (equal_2473_s2_q ? select_3904 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3907;
  assign sum_3907 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3908;
  assign select_3908 = sum_3877[7] ? {1'b1, sum_3877[6:0], region_down_rest_q[0]} : sum_3907;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3877[7];
  // hls/stages/agreement.hpp:460
  logic select_3912;
  assign select_3912 = equal_2473_s2_q ? (equal_679_s2_q | (less_3876_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3917;
  assign or_3917 = segment_starts_q | not_577_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_3920;
  assign select_3920 = inside_v_s2_q ? (sum_1998_s2_q ? (equal_1772 & or_2000) : or_2000) : or_3917;
  // hls/stages/agreement.hpp:788
  logic select_3923;
  assign select_3923 = equal_574_s2_q ? or_3917 : (so_s2_q ? (ends_cell_s2_q ? select_3920 : or_3917) : or_3917);
  // hls/stages/agreement.hpp:1147
  logic equal_3947;
  assign equal_3947 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4083;
  assign select_4083 = so_s2_q ? (ends_cell_s2_q ? and_2072 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4086;
  assign select_4086 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4088;
  assign select_4088 = equal_574_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4086 : centres_values_0_of_skin_q);
  logic select_4089;
  assign select_4089 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4091;
  assign select_4091 = equal_574_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4089 : centres_values_1_textured_q);
  logic select_4092;
  assign select_4092 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4094;
  assign select_4094 = equal_574_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4092 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [10:0] select_4098;
  assign select_4098 = equal_2473_s2_q ? (equal_4095_s2_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [5:0] select_4101;
  assign select_4101 = and_549_s2_q ? (equal_2473_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1271
  logic xor_4102;
  assign xor_4102 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:438
  logic select_4104;
  assign select_4104 = and_1977_s2_q ? (left_first_s2_q ? xor_4102 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:278
  logic select_4106;
  assign select_4106 = and_1977_s2_q ? (left_first_s2_q ? xor_4102 : select_4104) : write_half_q;
  logic select_4108;
  assign select_4108 = left_first_s2_q ? select_2037 : (and_1977_s2_q ? select_2038 : read_half_q);
  logic and_4112;
  assign and_4112 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_4121;
  assign select_4121 = left_first_s2_q ? 10'h1 : (and_1977_s2_q ? select_2042 : rows_passed_q);
  logic [8:0] select_4124;
  assign select_4124 = left_first_s2_q ? {select_2040[7:0], or_2039} : (and_1977_s2_q ? {select_2040[7:0], or_2039} : columns_passed_q);
  logic select_4127;
  assign select_4127 = left_first_s2_q ? marks_last_s2_q : (and_1977_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4130;
  assign select_4130 = left_first_s2_q ? and_2056 : (and_1977_s2_q ? and_2056 : began_q);
  logic [2:0] select_4133;
  assign select_4133 = left_first_s2_q ? select_2058 : (and_1977_s2_q ? select_2058 : seen_x_q);
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4138;
  assign select_4138 = left_first_s2_q ? 3'h0 : (and_2043 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:278
  logic [2:0] select_4140;
  assign select_4140 = left_first_s2_q ? 3'h0 : (and_1977_s2_q ? select_4138 : seen_y_q);
  logic [7:0] select_4143;
  assign select_4143 = left_first_s2_q ? select_2051 : (and_1977_s2_q ? select_2051 : seen_column_q);
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4149;
  assign select_4149 = left_first_s2_q ? select_4147 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:278
  logic [7:0] select_4151;
  assign select_4151 = left_first_s2_q ? select_4147 : (and_1977_s2_q ? select_4149 : seen_rows_left_q);
  // hls/stages/agreement.hpp:436
  logic and_4156;
  assign and_4156 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:278
  logic select_4158;
  assign select_4158 = left_first_s2_q ? and_4156 : (and_1977_s2_q ? and_4156 : at_cell_end_q);
  logic select_4161;
  assign select_4161 = left_first_s2_q ? next_row : (and_1977_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4164;
  assign select_4164 = left_first_s2_q ? 11'h0 : (and_1977_s2_q ? select_2048 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4237;
  assign not_4237 = ~quarter[1];
  logic [3:0] select_4238;
  assign select_4238 = quarter[0] ? {quarter[1], 1'b0, not_4237, 1'b0} : {1'b0, quarter[1], 1'b0, not_4237};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1614;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1657;
`endif
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 22, DISTANCE 12, hls/stages/patches.hpp:767; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [21:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 22'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1691;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1693));
`endif
  logic [21:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1398; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1995;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s2_en & (equal_574_s2_q ? (x_s2_q[6] & not_1996) : and_2003);
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1409; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_2053;
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s2_en & select_2065;
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_515_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_524_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_543, and_539, sum_535, sum_531};
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
  assign census_memory_waddr = last_s2_2_q;
  logic census_memory_we;
  assign census_memory_we = s2_en & and_549_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_567, whole_2, select_559, select_555};
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

  // Memory moments_memory, write
  logic [10:0] moments_memory_waddr;
  assign moments_memory_waddr = select_573_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_591_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_646_s2_q, and_644_s2_q, and_639_s2_q, and_637};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && moments_memory_we) begin
      if (moments_memory_re && moments_memory_raddr == moments_memory_waddr) begin
        $error("moments_memory: address %0d is read less than DISTANCE steps after its write", moments_memory_waddr);
      end
      if (moments_memory_waddr >= 11'd1645) $error("moments_memory: write outside, address %0d", moments_memory_waddr);
    end
    if (rst_ni && moments_memory_re && moments_memory_raddr >= 11'd1645) $error("moments_memory: read outside, address %0d", moments_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1561_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1560, select_1557, select_1554, select_1552, select_1534, select_1531, select_1523, select_1522, select_1517};
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
  assign best_right_we = s2_en & and_1561_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1571, select_1570, select_1567, select_1566};
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

  // Memory shown_right, write
  logic [5:0] shown_right_waddr;
  assign shown_right_waddr = select_1578_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1589;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1586, not_577_s2_q};
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

  // Memory left_turns, write
  logic [5:0] left_turns_waddr;
  assign left_turns_waddr = x_s2_q[5:0];
  logic left_turns_we;
  assign left_turns_we = s2_en & moments_taken_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1597, and_1594};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_turns_we) begin
      if (left_turns_re && left_turns_raddr == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_waddr >= 6'd47) $error("left_turns: write outside, address %0d", left_turns_waddr);
    end
    if (rst_ni && left_turns_re && left_turns_raddr >= 6'd47) $error("left_turns: read outside, address %0d", left_turns_raddr);
  end
`endif

  // Memory right_turns, write
  logic [5:0] right_turns_waddr;
  assign right_turns_waddr = x_s2_q[5:0];
  logic right_turns_we;
  assign right_turns_we = s2_en & moments_taken_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1606, and_1603};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_turns_we) begin
      if (right_turns_re && right_turns_raddr == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_waddr >= 6'd47) $error("right_turns: write outside, address %0d", right_turns_waddr);
    end
    if (rst_ni && right_turns_re && right_turns_raddr >= 6'd47) $error("right_turns: read outside, address %0d", right_turns_raddr);
  end
`endif

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1893, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1945_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1931_s2_q, and_1928_s2_q, and_1912_s2_q, and_1909, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1949, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1959_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1931_s2_q, and_1928_s2_q, and_1912_s2_q, and_1909, patches_codes_at_q[51:8]};
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
  assign seen_columns_waddr = x_s2_q[5:0];
  logic seen_columns_we;
  assign seen_columns_we = s2_en & and_1574_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2030, textured};
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
      moments_turned_0_q <= 14'h0;
      moments_turned_1_q <= 14'h0;
      moments_before_0_q <= 14'h0;
      moments_before_1_q <= 14'h0;
      moments_has_before_q <= 1'b0;
      moments_most_before_q <= 14'h0;
      moments_left_begins_q <= 1'b0;
      moments_left_alone_q <= 1'b0;
      moments_left_other_stops_q <= 1'b0;
      moments_right_begins_q <= 1'b0;
      moments_right_alone_q <= 1'b0;
      moments_right_other_stops_q <= 1'b0;
      moments_out_of_step_q <= 1'b0;
      moments_turns_0_q <= 1'b0;
      moments_turns_1_q <= 1'b0;
      moments_begins_alone_q <= 1'b0;
      moments_ends_q <= 1'b0;
      rows_passed_above_q <= 5'h0;
      chosen_score_q <= 8'h0;
      chosen_near_q <= 7'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      shift_allowed_q <= 1'b0;
      shift_not_right_q <= 1'b0;
      counts_turned_left_q <= 14'h0;
      counts_turned_right_q <= 14'h0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
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
      patches_frame_ended_q <= 1'b0;
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
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= left_pixel_q;
      sample_pair_pixel_1_q <= pixel_0_s2_q;
      sample_of_skin_q <= mask_s2_q;
      averager_running_mask_q <= sample_pair_whole_s2_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2197;
      averager_mask_q <= select_2199;
      averager_of_skin_q <= select_2201;
      census_filled_q <= and_549_s2_q ? {select_682[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2296;
      moments_turned_1_q <= sum_2298;
      moments_before_0_q <= equal_574_s2_q ? select_2300 : moments_before_0_q;
      moments_before_1_q <= equal_574_s2_q ? select_2302 : moments_before_1_q;
      moments_has_before_q <= select_2305;
      moments_most_before_q <= select_2308;
      moments_left_begins_q <= select_2312;
      moments_left_alone_q <= select_2316;
      moments_left_other_stops_q <= select_2319;
      moments_right_begins_q <= select_2322;
      moments_right_alone_q <= select_2326;
      moments_right_other_stops_q <= select_2329;
      moments_out_of_step_q <= or_2332;
      moments_turns_0_q <= and_2340;
      moments_turns_1_q <= and_2344;
      moments_begins_alone_q <= and_2353;
      moments_ends_q <= equal_574_s2_q & (equal_2299 & (not_2354 | and_2356));
      rows_passed_above_q <= and_549_s2_q ? select_681 : rows_passed_above_q;
      chosen_score_q <= less_2583 ? select_1511 : select_2582;
      chosen_near_q <= (select_2585 < select_1546) ? select_1546 : select_2585;
      chosen_place_q <= less_2583 ? {select_1519, not_1518} : 3'h2;
      before_0_q <= select_2582;
      before_1_q <= sum_1261;
      before_2_q <= sum_1509;
      shift_allowed_q <= not_2590 & (~less_2591);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2598 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2717});
      counts_turned_right_q <= and_2598 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2724});
      registration_displacement_over_q <= so_s2_q ? sum_2748[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2750;
      registration_slope_here_q <= select_2752;
      registration_expected_q <= select_2754;
      registration_of_right_q <= equal_574_s2_q ? registration_of_right_q : select_2816;
      registration_was_inside_q <= equal_574_s2_q ? registration_was_inside_q : select_2819;
      registration_fresh_q <= select_2828;
      patches_chance_q <= and_549_s2_q ? select_2985 : patches_chance_q;
      patches_fixed_q <= and_2999;
      patches_choice_valid_q <= and_1777 ? (select_1750 & not_2987) : select_1750;
      patches_choice_column_q <= select_1755;
      patches_choice_shift_q <= select_1760;
      patches_choice_slope_q <= select_1771;
      patches_band_q <= sample_pair_whole_s2_q ? select_1792 : patches_band_q;
      patches_fetch_q <= select_3014;
      patches_codes_at_q <= select_3115;
      patches_codes_further_q <= equal_1779_s2_q ? patches_codes_further_q : select_3120;
      patches_next_codes_q <= select_3128;
      patches_set_q <= equal_1779_s2_q ? 3'h0 : (equal_1781_s2_q ? 3'h0 : select_3142);
      patches_size_q <= sum_3146;
      patches_left_row_q <= select_3158;
      patches_summed_row_column_q <= equal_1779_s2_q ? patches_summed_row_column_q : select_3503;
      patches_summed_first_q <= select_3506;
      patches_read_row_differing_q <= equal_1779_s2_q ? select_3518 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1779_s2_q ? select_3525 : patches_read_row_column_q;
      patches_read_at_q <= equal_1779_s2_q ? select_3532 : patches_read_at_q;
      patches_read_first_q <= select_3541;
      patches_read_above_q <= select_3564;
      patches_read_below_q <= select_3573;
      patches_read_far_q <= equal_1779_s2_q ? select_3583 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3586;
      patches_peak_best_column_q <= select_3587;
      patches_peak_row_q <= equal_1779_s2_q ? select_3554 : patches_peak_row_q;
      patches_peak_above_q <= equal_1779_s2_q ? select_3589 : patches_peak_above_q;
      patches_peak_below_q <= equal_1779_s2_q ? select_3591 : patches_peak_below_q;
      patches_peak_far_q <= equal_1779_s2_q ? select_3595 : patches_peak_far_q;
      patches_frame_ended_q <= equal_574_s2_q & equal_2299;
      shown_shown_q <= select_3873;
      shown_nearer_q <= select_3875;
      region_row_q <= and_549_s2_q ? select_3881 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3886;
      region_down_rest_q <= select_3902;
      region_down_back_q <= select_3906;
      region_down_next_q <= select_3908;
      region_fresh_q <= and_549_s2_q ? select_3912 : region_fresh_q;
      segment_starts_q <= select_3923;
      centres_values_0_textured_q <= equal_574_s2_q ? centres_values_0_textured_q : select_4083;
      centres_values_0_of_skin_q <= select_4088;
      centres_values_1_textured_q <= select_4091;
      centres_values_1_of_skin_q <= select_4094;
      map_row_q <= and_549_s2_q ? select_4098 : map_row_q;
      map_width_q <= select_4101;
      write_half_q <= select_4106;
      read_half_q <= and_1977_s2_q ? select_4108 : read_half_q;
      done_q <= and_1977_s2_q ? (not_2054 & and_4112) : and_4112;
      drew_q <= so_s2_q;
      said_q <= equal_574_s2_q & equal_3947;
      rows_passed_q <= and_1977_s2_q ? select_4121 : rows_passed_q;
      columns_passed_q <= and_1977_s2_q ? select_4124 : columns_passed_q;
      line_ended_q <= and_1977_s2_q ? select_4127 : line_ended_q;
      began_q <= and_1977_s2_q ? select_4130 : began_q;
      seen_x_q <= and_1977_s2_q ? select_4133 : seen_x_q;
      seen_y_q <= and_1977_s2_q ? select_4140 : seen_y_q;
      seen_column_q <= and_1977_s2_q ? select_4143 : seen_column_q;
      seen_rows_left_q <= and_1977_s2_q ? select_4151 : seen_rows_left_q;
      at_cell_end_q <= and_1977_s2_q ? select_4158 : at_cell_end_q;
      was_next_row_q <= and_1977_s2_q ? select_4161 : was_next_row_q;
      seen_base_q <= and_1977_s2_q ? select_4164 : seen_base_q;
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
      left_pixel_q <= and_1977_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_527 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_533 : averager_running_1_q;
      averager_total_0_q <= select_2175;
      averager_total_1_q <= select_2177;
      census_columns_values_0_cell_0_left_q <= select_2202;
      census_columns_values_0_cell_0_right_q <= select_2203;
      census_columns_values_0_cell_0_mask_q <= and_549_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2205;
      census_columns_values_0_cell_1_right_q <= select_2206;
      census_columns_values_0_cell_1_mask_q <= select_2207;
      census_columns_values_0_cell_2_left_q <= select_2208;
      census_columns_values_0_cell_2_right_q <= select_2209;
      census_columns_values_0_cell_2_mask_q <= select_2210;
      census_columns_values_0_cell_2_of_skin_q <= select_2211;
      census_columns_values_0_cell_3_left_q <= select_2212;
      census_columns_values_0_cell_3_right_q <= select_2213;
      census_columns_values_0_cell_3_mask_q <= select_2214;
      census_columns_values_0_cell_4_left_q <= select_2215;
      census_columns_values_0_cell_4_right_q <= select_2216;
      census_columns_values_0_cell_4_mask_q <= select_2217;
      census_columns_values_1_cell_0_left_q <= select_2218;
      census_columns_values_1_cell_0_right_q <= select_2219;
      census_columns_values_1_cell_0_mask_q <= select_2220;
      census_columns_values_1_cell_1_left_q <= select_2221;
      census_columns_values_1_cell_1_right_q <= select_2222;
      census_columns_values_1_cell_1_mask_q <= select_2223;
      census_columns_values_1_cell_2_left_q <= select_2224;
      census_columns_values_1_cell_2_right_q <= select_2225;
      census_columns_values_1_cell_2_mask_q <= select_2226;
      census_columns_values_1_cell_2_of_skin_q <= select_2227;
      census_columns_values_1_cell_3_left_q <= select_2228;
      census_columns_values_1_cell_3_right_q <= select_2229;
      census_columns_values_1_cell_3_mask_q <= select_2230;
      census_columns_values_1_cell_4_left_q <= select_2231;
      census_columns_values_1_cell_4_right_q <= select_2232;
      census_columns_values_1_cell_4_mask_q <= select_2233;
      census_columns_values_2_cell_0_left_q <= select_2234;
      census_columns_values_2_cell_0_right_q <= select_2235;
      census_columns_values_2_cell_0_mask_q <= select_2236;
      census_columns_values_2_cell_1_left_q <= select_2237;
      census_columns_values_2_cell_1_right_q <= select_2238;
      census_columns_values_2_cell_1_mask_q <= select_2239;
      census_columns_values_2_cell_2_left_q <= select_2240;
      census_columns_values_2_cell_2_right_q <= select_2241;
      census_columns_values_2_cell_2_mask_q <= select_2242;
      census_columns_values_2_cell_3_left_q <= select_2243;
      census_columns_values_2_cell_3_right_q <= select_2244;
      census_columns_values_2_cell_3_mask_q <= select_2245;
      census_columns_values_2_cell_4_left_q <= select_2246;
      census_columns_values_2_cell_4_right_q <= select_2247;
      census_columns_values_2_cell_4_mask_q <= select_2248;
      census_columns_values_3_cell_0_mask_q <= select_2249;
      census_columns_values_3_cell_1_left_q <= select_2250;
      census_columns_values_3_cell_1_right_q <= select_2251;
      census_columns_values_3_cell_1_mask_q <= select_2252;
      census_columns_values_3_cell_2_mask_q <= select_2253;
      census_columns_values_3_cell_3_left_q <= select_2254;
      census_columns_values_3_cell_3_right_q <= select_2255;
      census_columns_values_3_cell_3_mask_q <= select_2256;
      census_columns_values_3_cell_4_mask_q <= select_2257;
      sharpness_last_mean_0_q <= and_549_s2_q ? select_555 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_549_s2_q ? select_559 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_s2_q;
      middle_sum_columns_values_1_q <= select_2573;
      middle_sum_columns_values_2_q <= select_2574;
      middle_sum_columns_values_3_q <= select_2575;
      middle_sum_columns_values_4_q <= select_2576;
      middle_sum_columns_values_5_q <= select_2577;
      middle_sum_columns_values_6_q <= select_2578;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_1011;
      sums_0_sum_sums_values_0_q <= sum_1261;
      sums_0_sum_sums_values_1_q <= equal_1259 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1509;
      sums_1_sum_sums_values_1_q <= equal_1259 ? 8'h0 : sums_1_sum_sums_values_0_q;
    end
  end

  logic saturated_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic left_first_s3_q;
  logic [7:0] sample_pair_pixel_0_s3_q;
  logic [7:0] sample_pair_pixel_1_s3_q;
  logic sample_pair_whole_s3_q;
  logic sample_present_s3_q;
  logic census_columns_values_1_cell_2_of_skin_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic [2:0] slot_s3_q;
  logic ends_cell_s3_q;
  logic lower_half_s3_q;
  logic registration_of_right_s3_q;
  logic [4:0] patches_choosing_band_s3_q;
  logic patches_lower_s3_q;
  logic patches_second_s3_q;
  logic [4:0] patches_summed_row_column_s3_q;
  logic patches_summed_first_s3_q;
  logic patches_summed_last_s3_q;
  logic [4:0] patches_summed_down_by_s3_q;
  logic patches_frame_ended_s3_q;
  logic [2:0] region_row_s3_q;
  logic region_fresh_s3_q;
  logic centres_values_1_textured_s3_q;
  logic centres_values_1_of_skin_s3_q;
  logic done_s3_q;
  logic [2:0] select_509_s3_q;
  logic [5:0] select_511_s3_q;
  logic [5:0] last_s3_q;
  logic and_547_s3_q;
  logic and_549_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_552_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_569_s3_q;
  logic equal_574_s3_q;
  logic not_575_s3_q;
  logic less_652_s3_q;
  logic less_653_s3_q;
  logic less_654_s3_q;
  logic less_655_s3_q;
  logic less_656_s3_q;
  logic less_657_s3_q;
  logic less_658_s3_q;
  logic less_659_s3_q;
  logic less_660_s3_q;
  logic less_661_s3_q;
  logic less_662_s3_q;
  logic less_663_s3_q;
  logic less_664_s3_q;
  logic less_665_s3_q;
  logic less_666_s3_q;
  logic less_667_s3_q;
  logic less_668_s3_q;
  logic less_669_s3_q;
  logic less_670_s3_q;
  logic less_671_s3_q;
  logic less_672_s3_q;
  logic less_673_s3_q;
  logic less_674_s3_q;
  logic less_675_s3_q;
  logic and_683_s3_q;
  logic and_708_s3_q;
  logic and_709_s3_q;
  logic [11:0] sum_724_s3_q;
  logic [9:0] sum_727_s3_q;
  logic and_735_s3_q;
  logic and_739_s3_q;
  logic less_740_s3_q;
  logic less_744_s3_q;
  logic less_746_s3_q;
  logic equal_1607_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1613_s3_q;
  logic equal_1615_s3_q;
  logic equal_1617_s3_q;
  logic equal_1619_s3_q;
  logic equal_1621_s3_q;
  logic equal_1623_s3_q;
  logic equal_1625_s3_q;
  logic equal_1627_s3_q;
  logic equal_1629_s3_q;
  logic less_1638_s3_q;
  logic or_1642_s3_q;
  logic equal_1662_s3_q;
  logic and_1672_s3_q;
  logic and_1675_s3_q;
  logic select_1692_s3_q;
  logic equal_1693_s3_q;
  logic and_1701_s3_q;
  logic equal_1703_s3_q;
  logic select_1750_s3_q;
  logic and_1778_s3_q;
  logic equal_1779_s3_q;
  logic equal_1781_s3_q;
  logic and_1794_s3_q;
  logic [4:0] select_1809_s3_q;
  logic select_1815_s3_q;
  logic [3:0] select_1856_s3_q;
  logic less_1960_s3_q;
  logic equal_1961_s3_q;
  logic not_1962_s3_q;
  logic equal_1963_s3_q;
  logic and_1977_s3_q;
  logic select_1979_s3_q;
  logic and_1982_s3_q;
  logic or_1988_s3_q;
  logic or_1991_s3_q;
  logic or_1994_s3_q;
  logic not_1996_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2023_s3_q;
  logic and_2028_s3_q;
  logic and_2060_s3_q;
  logic less_2061_s3_q;
  logic [11:0] sum_2069_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2087_s3_q;
  logic or_2090_s3_q;
  logic or_2093_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2143_s3_q;
  logic [11:0] sum_2273_s3_q;
  logic [9:0] sum_2276_s3_q;
  logic equal_2284_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2598_s3_q;
  logic and_2604_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2666_s3_q;
  logic and_2700_s3_q;
  logic and_2758_s3_q;
  logic and_2759_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2795_s3_q;
  logic and_2809_s3_q;
  logic equal_2852_s3_q;
  logic parity_3230_s3_q;
  logic parity_3359_s3_q;
  logic parity_3421_s3_q;
  logic xor_3449_s3_q;
  logic parity_3461_s3_q;
  logic or_3465_s3_q;
  logic equal_3466_s3_q;
  logic [4:0] select_3585_s3_q;
  logic equal_3597_s3_q;
  logic less_3599_s3_q;
  logic less_3600_s3_q;
  logic or_3605_s3_q;
  logic [7:0] select_3650_s3_q;
  logic equal_3947_s3_q;
  logic and_4167_s3_q;
  logic equal_4240_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s3_q <= saturated_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      left_first_s3_q <= left_first_s2_q;
      sample_pair_pixel_0_s3_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s3_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      census_columns_values_1_cell_2_of_skin_s3_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[2];
      slot_s3_q <= slot_s2_q;
      ends_cell_s3_q <= ends_cell_s2_q;
      lower_half_s3_q <= lower_half_s2_q;
      registration_of_right_s3_q <= registration_of_right_q;
      patches_choosing_band_s3_q <= patches_choosing_band_s2_q;
      patches_lower_s3_q <= patches_lower_s2_q;
      patches_second_s3_q <= patches_second_s2_q;
      patches_summed_row_column_s3_q <= patches_summed_row_column_q;
      patches_summed_first_s3_q <= patches_summed_first_q;
      patches_summed_last_s3_q <= patches_summed_last_s2_q;
      patches_summed_down_by_s3_q <= patches_summed_down_by_s2_q;
      patches_frame_ended_s3_q <= patches_frame_ended_q;
      region_row_s3_q <= region_row_q;
      region_fresh_s3_q <= region_fresh_q;
      centres_values_1_textured_s3_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s3_q <= centres_values_1_of_skin_q;
      done_s3_q <= done_q;
      select_509_s3_q <= select_509_s2_q;
      select_511_s3_q <= select_511_s2_q;
      last_s3_q <= last_s2_2_q;
      and_547_s3_q <= and_547_s2_q;
      and_549_s3_q <= and_549_s2_q;
      grey_s3_q <= grey;
      equal_552_s3_q <= equal_552;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_569_s3_q <= equal_569_s2_q;
      equal_574_s3_q <= equal_574_s2_q;
      not_575_s3_q <= not_575_s2_q;
      less_652_s3_q <= less_652;
      less_653_s3_q <= less_653;
      less_654_s3_q <= less_654;
      less_655_s3_q <= less_655;
      less_656_s3_q <= less_656;
      less_657_s3_q <= less_657;
      less_658_s3_q <= less_658;
      less_659_s3_q <= less_659;
      less_660_s3_q <= less_660;
      less_661_s3_q <= less_661;
      less_662_s3_q <= less_662;
      less_663_s3_q <= less_663;
      less_664_s3_q <= less_664;
      less_665_s3_q <= less_665;
      less_666_s3_q <= less_666;
      less_667_s3_q <= less_667;
      less_668_s3_q <= less_668;
      less_669_s3_q <= less_669;
      less_670_s3_q <= less_670;
      less_671_s3_q <= less_671;
      less_672_s3_q <= less_672;
      less_673_s3_q <= less_673;
      less_674_s3_q <= less_674;
      less_675_s3_q <= less_675;
      and_683_s3_q <= and_683;
      and_708_s3_q <= whole_22 & and_683;
      and_709_s3_q <= census_columns_values_1_cell_2_mask_q & and_683;
      sum_724_s3_q <= {1'b0, sum_720} + {2'h0, sum_723};
      sum_727_s3_q <= {9'h0, difference_725[9]} + {1'b0, xor_726};
      and_735_s3_q <= and_735;
      and_739_s3_q <= and_739;
      less_740_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_744_s3_q <= {{5{sum_743[6]}}, sum_743, half_grey_levels_2[3:0]} < 16'hffe1;
      less_746_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_1607_s3_q <= equal_1607;
      all_s3_q <= all;
      sum_1613_s3_q <= sum_1613;
      equal_1615_s3_q <= equal_1615;
      equal_1617_s3_q <= equal_1617;
      equal_1619_s3_q <= equal_1619;
      equal_1621_s3_q <= equal_1621;
      equal_1623_s3_q <= equal_1623;
      equal_1625_s3_q <= equal_1625;
      equal_1627_s3_q <= equal_1627;
      equal_1629_s3_q <= equal_1629;
      less_1638_s3_q <= less_1638;
      or_1642_s3_q <= or_1642;
      equal_1662_s3_q <= (registration_fresh_q & select_1660) == 4'h0;
      and_1672_s3_q <= not_575_s2_q & and_1656;
      and_1675_s3_q <= and_1675_s2_q;
      select_1692_s3_q <= select_1692[1];
      equal_1693_s3_q <= equal_1693;
      and_1701_s3_q <= and_1701;
      equal_1703_s3_q <= equal_1703;
      select_1750_s3_q <= select_1750;
      and_1778_s3_q <= and_1778;
      equal_1779_s3_q <= equal_1779_s2_q;
      equal_1781_s3_q <= equal_1781_s2_q;
      and_1794_s3_q <= and_1778 & equal_1793;
      select_1809_s3_q <= select_1809_s2_q;
      select_1815_s3_q <= select_1815_s2_q;
      select_1856_s3_q <= select_1856_s2_q;
      less_1960_s3_q <= less_1960_s2_q;
      equal_1961_s3_q <= equal_1961_s2_q;
      not_1962_s3_q <= not_1962_s2_q;
      equal_1963_s3_q <= equal_1963_s2_q;
      and_1977_s3_q <= and_1977_s2_q;
      select_1979_s3_q <= select_1979_s2_q;
      and_1982_s3_q <= and_1982_s2_q;
      or_1988_s3_q <= or_1988;
      or_1991_s3_q <= or_1991;
      or_1994_s3_q <= or_1994;
      not_1996_s3_q <= not_1996;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2023_s3_q <= inside_v_s2_q & (and_2021 & and_1585);
      and_2028_s3_q <= not_575_s2_q & and_2003;
      and_2060_s3_q <= and_2060;
      less_2061_s3_q <= less_2061;
      sum_2069_s3_q <= sum_2069;
      textured_2_s3_q <= textured_2;
      or_2087_s3_q <= or_2087;
      or_2090_s3_q <= select_2084[7] | (~({select_2084[6], select_2084[3:2]} == 3'h0));
      or_2093_s3_q <= select_2084[7] | (~(select_2084[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2143_s3_q <= and_2143;
      sum_2273_s3_q <= {1'b0, sum_2269} + {2'h0, sum_2272};
      sum_2276_s3_q <= {9'h0, difference_2274[9]} + {1'b0, xor_2275};
      equal_2284_s3_q <= equal_2284_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2598_s3_q <= and_2598;
      and_2604_s3_q <= and_2604;
      explained_2_s3_q <= explained_2;
      and_2666_s3_q <= not_575_s2_q & and_2665;
      and_2700_s3_q <= not_575_s2_q & and_2699;
      and_2758_s3_q <= not_575_s2_q & (so_s2_q & (half_ends & equal_2755));
      and_2759_s3_q <= and_2759;
      residual_s3_q <= residual[7:0];
      and_2795_s3_q <= and_2795;
      and_2809_s3_q <= and_2759 & less_2808;
      equal_2852_s3_q <= (registration_fresh_q & select_2850) == 4'h0;
      parity_3230_s3_q <= ^{xor_3226, xor_3189, select_3156[44:36], other[44:36]};
      parity_3359_s3_q <= parity_3359;
      parity_3421_s3_q <= parity_3421;
      xor_3449_s3_q <= parity_3436 ^ parity_3448;
      parity_3461_s3_q <= ^{or_3458, or_3454, and_3450};
      or_3465_s3_q <= (or_3454 & or_3458) | (and_3450 & (or_3454 | or_3458));
      equal_3466_s3_q <= equal_3466_s2_q;
      select_3585_s3_q <= select_3585[14:10];
      equal_3597_s3_q <= select_3554[3:0] == 4'h0;
      less_3599_s3_q <= {difference_3598, 3'h0} < {3'h0, sum_3146};
      less_3600_s3_q <= select_3595 < select_3585[9:0];
      or_3605_s3_q <= (sum_3146 < 10'h39) | ({1'b0, sum_3146[9:1]} < select_3585[9:0]);
      select_3650_s3_q <= select_3650;
      equal_3947_s3_q <= equal_3947;
      and_4167_s3_q <= and_2143 & (sum_2069 == sum_2053);
      equal_4240_s3_q <= (registration_fresh_q & select_4238) == 4'h0;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
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
  logic [13:0] counts_on_skin_q;
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
  logic patches_round_ends_q;
  logic [2:0] patches_found_q;
  logic patches_doubted_q;
  logic patches_doubted_before_q;
  logic [7:0] patches_round_places_q;
  logic [11:0] patches_round_across_q;
  logic [2:0] patches_round_moved_q;
  logic [7:0] patches_round_on_skin_q;
  logic [7:0] patches_on_skin_q;
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
  logic overlooks_q;
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
  logic proven_q;
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:281
  logic [11:0] texture;
  assign texture = sum_724_s3_q + {2'h0, sum_727_s3_q};
  // hls/stages/census.hpp:292
  logic [12:0] sum_729;
  assign sum_729 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_731;
  assign sum_731 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_729});
  // hls/stages/census.hpp:314
  logic less_732;
  assign less_732 = 9'h4 < sum_731[13:5];
  logic and_733;
  assign and_733 = and_683_s3_q & less_732;
  // hls/stages/moments.hpp:30
  logic and_745;
  assign and_745 = (and_708_s3_q & and_735_s3_q) & less_744_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_1664;
  assign equal_1664 = sum_1613_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1613_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1666;
  assign select_1666 = equal_1664 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1667;
  assign sum_1667 = (equal_1662_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1666[13]}}, select_1666};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1613_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1670;
  assign select_1670 = equal_1664 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1671;
  assign sum_1671 = (equal_1662_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1670[6]}}, select_1670};
  // hls/stages/patches.hpp:353
  logic [21:0] select_1795;
  assign select_1795 = and_1794_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1750_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1797;
  assign select_1797 = equal_1693_s3_q ? patches_place_0_valid_q : (select_1692_s3_q ? patches_place_0_valid_q : select_1795[0]);
  // hls/stages/patches.hpp:354
  logic [20:0] select_1798;
  assign select_1798 = select_1692_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1795[21:1];
  // hls/stages/patches.hpp:127
  logic [6:0] select_1799;
  assign select_1799 = equal_1693_s3_q ? patches_place_0_column_q : select_1798[6:0];
  logic [5:0] select_1800;
  assign select_1800 = equal_1693_s3_q ? patches_place_0_shift_q : select_1798[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1801;
  assign sum_1801 = select_1799 + {select_1800[5], select_1800};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1802;
  assign sum_1802 = sum_1801[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1803;
  assign equal_1803 = {sum_1802[5], select_511_s3_q, select_509_s3_q} == {1'b0, sum_1802[4:0], sum_1801[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1805;
  assign or_1805 = and_1675_s3_q | (select_1797 & equal_1803);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1806;
  assign select_1806 = or_1805 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1816;
  assign select_1816 = or_1805 ? {and_1675_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1818;
  assign and_1818 = select_1815_s3_q & (~select_1816[5]);
  // hls/stages/patches.hpp:127
  logic select_1826;
  assign select_1826 = equal_1693_s3_q ? patches_place_1_valid_q : (select_1692_s3_q ? select_1795[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:354
  logic [20:0] select_1827;
  assign select_1827 = select_1692_s3_q ? select_1795[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [6:0] select_1828;
  assign select_1828 = equal_1693_s3_q ? patches_place_1_column_q : select_1827[6:0];
  logic [5:0] select_1829;
  assign select_1829 = equal_1693_s3_q ? patches_place_1_shift_q : select_1827[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1830;
  assign sum_1830 = select_1828 + {select_1829[5], select_1829};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1831;
  assign sum_1831 = sum_1830[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1832;
  assign equal_1832 = {sum_1831[5], select_511_s3_q, select_509_s3_q} == {1'b0, sum_1831[4:0], sum_1830[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1834;
  assign or_1834 = and_1675_s3_q | (select_1826 & equal_1832);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1835;
  assign select_1835 = or_1834 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1836;
  assign select_1836 = or_1834 ? {and_1675_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1838;
  assign and_1838 = select_1815_s3_q & (~select_1836[5]);
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1845;
  assign sum_1845 = select_1799 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1846;
  assign equal_1846 = {sum_1845[6], select_511_s3_q, select_509_s3_q} == {1'b0, sum_1845[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_1848;
  assign or_1848 = and_1675_s3_q | (select_1797 & equal_1846);
  logic [4:0] select_1849;
  assign select_1849 = or_1848 ? {and_1675_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1850;
  assign sum_1850 = select_1828 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1851;
  assign equal_1851 = {sum_1850[6], select_511_s3_q, select_509_s3_q} == {1'b0, sum_1850[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_1854;
  assign select_1854 = (and_1675_s3_q | (select_1826 & equal_1851)) ? {and_1675_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_4;
  assign column_4 = select_1849[4] ? select_1854[3:0] : select_1849[3:0];
  // hls/stages/agreement.hpp:276
  logic select_1857;
  assign select_1857 = or_1848 ? and_1675_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_1863;
  assign and_1863 = (select_1815_s3_q & (select_1809_s3_q[3] ^ select_1809_s3_q[4])) & ((~select_1849[4]) | (~select_1854[4]));
  // hls/stages/patches.hpp:184
  logic less_1972;
  assign less_1972 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1973;
  assign not_1973 = ~less_1972;
  logic [1:0] select_1974;
  assign select_1974 = patches_summed_first_s3_q ? 2'h2 : {less_1972, not_1973};
  logic [12:0] select_1975;
  assign select_1975 = select_1974[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1983;
  assign select_1983 = select_1974[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1982_s3_q, 1'b0, select_1979_s3_q, left_pixel_q};
  logic [14:0] select_1984;
  assign select_1984 = select_1974[1] ? {select_1975[12:8], patches_sums_values_0_q[9:8], select_1975[7:0]} : select_1983;
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2009;
  assign select_2009 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_2010;
  assign sum_2010 = {5'h0, textured_s3_q} + select_2009;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2012;
  assign sum_2012 = {4'h0, sum_2010} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2014;
  assign select_2014 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_2015;
  assign sum_2015 = {5'h0, explained_s3_q} + select_2014;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2017;
  assign sum_2017 = {4'h0, sum_2015} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2024;
  assign select_2024 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:902
  logic [5:0] sum_2025;
  assign sum_2025 = {5'h0, and_2023_s3_q} + select_2024;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2027;
  assign sum_2027 = {4'h0, sum_2025} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2078;
  assign select_2078 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2079;
  assign difference_2079 = {1'b0, textured_2_s3_q} - {1'b0, select_2078};
  logic [4:0] t;
  assign t = {difference_2079[3], difference_2079} + (equal_569_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2082;
  assign equal_2082 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2094;
  assign not_2094 = ~region_row_s3_q[2];
  logic [2:0] select_2095;
  assign select_2095 = region_row_s3_q[1] ? {1'b0, not_2094, 1'b0} : {region_row_s3_q[2], 1'b0, not_2094};
  logic [5:0] select_2096;
  assign select_2096 = region_row_s3_q[0] ? {select_2095[2], 1'b0, select_2095[1], 1'b0, select_2095[0], 1'b0} : {1'b0, select_2095[2], 1'b0, select_2095[1], 1'b0, select_2095[0]};
  logic [11:0] select_2097;
  assign select_2097 = or_2093_s3_q ? {select_2096[5], 1'b0, select_2096[4], 1'b0, select_2096[3], 1'b0, select_2096[2], 1'b0, select_2096[1], 1'b0, select_2096[0], 1'b0} : {1'b0, select_2096[5], 1'b0, select_2096[4], 1'b0, select_2096[3], 1'b0, select_2096[2], 1'b0, select_2096[1], 1'b0, select_2096[0]};
  logic [23:0] select_2098;
  assign select_2098 = or_2090_s3_q ? {select_2097[11], 1'b0, select_2097[10], 1'b0, select_2097[9], 1'b0, select_2097[8], 1'b0, select_2097[7], 1'b0, select_2097[6], 1'b0, select_2097[5], 1'b0, select_2097[4], 1'b0, select_2097[3], 1'b0, select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0], 1'b0} : {1'b0, select_2097[11], 1'b0, select_2097[10], 1'b0, select_2097[9], 1'b0, select_2097[8], 1'b0, select_2097[7], 1'b0, select_2097[6], 1'b0, select_2097[5], 1'b0, select_2097[4], 1'b0, select_2097[3], 1'b0, select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0]};
  logic [47:0] select_2099;
  assign select_2099 = or_2087_s3_q ? {select_2098[23], 1'b0, select_2098[22], 1'b0, select_2098[21], 1'b0, select_2098[20], 1'b0, select_2098[19], 1'b0, select_2098[18], 1'b0, select_2098[17], 1'b0, select_2098[16], 1'b0, select_2098[15], 1'b0, select_2098[14], 1'b0, select_2098[13], 1'b0, select_2098[12], 1'b0, select_2098[11], 1'b0, select_2098[10], 1'b0, select_2098[9], 1'b0, select_2098[8], 1'b0, select_2098[7], 1'b0, select_2098[6], 1'b0, select_2098[5], 1'b0, select_2098[4], 1'b0, select_2098[3], 1'b0, select_2098[2], 1'b0, select_2098[1], 1'b0, select_2098[0], 1'b0} : {1'b0, select_2098[23], 1'b0, select_2098[22], 1'b0, select_2098[21], 1'b0, select_2098[20], 1'b0, select_2098[19], 1'b0, select_2098[18], 1'b0, select_2098[17], 1'b0, select_2098[16], 1'b0, select_2098[15], 1'b0, select_2098[14], 1'b0, select_2098[13], 1'b0, select_2098[12], 1'b0, select_2098[11], 1'b0, select_2098[10], 1'b0, select_2098[9], 1'b0, select_2098[8], 1'b0, select_2098[7], 1'b0, select_2098[6], 1'b0, select_2098[5], 1'b0, select_2098[4], 1'b0, select_2098[3], 1'b0, select_2098[2], 1'b0, select_2098[1], 1'b0, select_2098[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2103;
  assign and_2103 = good_known_q & (~((good_q & select_2099) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2112;
  assign select_2112 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2113;
  assign difference_2113 = {1'b0, shown_2_s3_q} - {1'b0, select_2112};
  logic [4:0] around;
  assign around = {difference_2113[3], difference_2113} + (equal_569_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2116;
  assign sum_2116 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2082 ? and_2103 : (~({sum_2116, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2128;
  assign select_2128 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2129;
  assign difference_2129 = {1'b0, near_2_s3_q} - {1'b0, select_2128};
  logic [4:0] n;
  assign n = {difference_2129[3], difference_2129} + (equal_569_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2133;
  assign and_2133 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2167;
  assign select_2167 = sample_pair_whole_s3_q ? (and_547_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2169;
  assign select_2169 = sample_pair_whole_s3_q ? (and_547_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2171;
  assign select_2171 = sample_pair_whole_s3_q ? (and_547_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2173;
  assign select_2173 = sample_pair_whole_s3_q ? (and_547_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:217
  logic [9:0] sum_2178;
  assign sum_2178 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2179;
  assign difference_2179 = {1'b0, sum_2178[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:218
  logic [9:0] xor_2180;
  assign xor_2180 = {difference_2179[8:0], sum_2178[0]} ^ {10{difference_2179[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2179[9]} + {1'b0, xor_2180};
  // hls/stages/census.hpp:219
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_552_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2185;
  assign select_2185 = sample_pair_whole_s3_q ? (and_547_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:217
  logic [9:0] sum_2186;
  assign sum_2186 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2187;
  assign difference_2187 = {1'b0, sum_2186[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:218
  logic [9:0] xor_2188;
  assign xor_2188 = {difference_2187[8:0], sum_2186[0]} ^ {10{difference_2187[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2187[9]} + {1'b0, xor_2188};
  // hls/stages/census.hpp:219
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_552_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2193;
  assign select_2193 = sample_pair_whole_s3_q ? (and_547_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:283
  logic [11:0] sum_2277;
  assign sum_2277 = sum_2273_s3_q + {2'h0, sum_2276_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2279;
  assign select_2279 = and_549_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2280;
  assign select_2280 = and_549_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2281;
  assign select_2281 = and_549_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2282;
  assign select_2282 = and_549_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:293
  logic [12:0] sum_2285;
  assign sum_2285 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2277};
  logic [13:0] sum_2287;
  assign sum_2287 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2285});
  // hls/stages/census.hpp:320
  logic and_2289;
  assign and_2289 = and_708_s3_q & (9'h4 < sum_2287[13:5]);
  // hls/stages/census.hpp:321
  logic and_2290;
  assign and_2290 = and_708_s3_q & less_732;
  // hls/stages/census.hpp:322
  logic [19:0] sum_2291;
  assign sum_2291 = census_left_misses_q + {{17{and_2290}}, and_2289, 1'b0, and_2289};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2293;
  assign select_2293 = and_549_s3_q ? (equal_2284_s3_q ? 20'h0 : sum_2291) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2363;
  assign select_2363 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2366;
  assign select_2366 = and_549_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:370
  logic and_2369;
  assign and_2369 = whole_2_s3_q & (~(last_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:457
  logic and_2375;
  assign and_2375 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2376;
  assign and_2376 = and_2369 & and_2375;
  // hls/stages/census.hpp:369
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2363[13:0]};
  // hls/stages/census.hpp:371
  logic [12:0] select_2378;
  assign select_2378 = and_2376 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:372
  logic [23:0] select_2380;
  assign select_2380 = equal_2284_s3_q ? {11'h0, select_2378} : (sharpness_sums_detail_0_q + {11'h0, select_2378});
  // hls/stages/agreement.hpp:457
  logic and_2387;
  assign and_2387 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2388;
  assign and_2388 = and_2369 & and_2387;
  // hls/stages/census.hpp:369
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2363[27:14]};
  // hls/stages/census.hpp:371
  logic [12:0] select_2390;
  assign select_2390 = and_2388 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:372
  logic [23:0] select_2392;
  assign select_2392 = equal_2284_s3_q ? {11'h0, select_2390} : (sharpness_sums_detail_1_q + {11'h0, select_2390});
  logic [8:0] select_2395;
  assign select_2395 = and_2376 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2396;
  assign sum_2396 = (equal_2284_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2395};
  logic [8:0] select_2399;
  assign select_2399 = and_2388 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2400;
  assign sum_2400 = (equal_2284_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2399};
  // hls/stages/agreement.hpp:211
  logic equal_2402;
  assign equal_2402 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:385
  logic less_2403;
  assign less_2403 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:424
  logic less_2404;
  assign less_2404 = x_s3_q[4:0] < 5'h3;
  logic not_2405;
  assign not_2405 = ~x_s3_q[1];
  logic [2:0] select_2406;
  assign select_2406 = x_s3_q[0] ? {1'b0, not_2405, 1'b0} : {x_s3_q[1], 1'b0, not_2405};
  logic [5:0] select_2407;
  assign select_2407 = slot_s3_q[2] ? {select_2406[2], 1'b0, select_2406[1], 1'b0, select_2406[0], 1'b0} : {1'b0, select_2406[2], 1'b0, select_2406[1], 1'b0, select_2406[0]};
  logic [11:0] select_2408;
  assign select_2408 = slot_s3_q[1] ? {select_2407[5], 1'b0, select_2407[4], 1'b0, select_2407[3], 1'b0, select_2407[2], 1'b0, select_2407[1], 1'b0, select_2407[0], 1'b0} : {1'b0, select_2407[5], 1'b0, select_2407[4], 1'b0, select_2407[3], 1'b0, select_2407[2], 1'b0, select_2407[1], 1'b0, select_2407[0]};
  logic [23:0] select_2409;
  assign select_2409 = slot_s3_q[0] ? {select_2408[11], 1'b0, select_2408[10], 1'b0, select_2408[9], 1'b0, select_2408[8], 1'b0, select_2408[7], 1'b0, select_2408[6], 1'b0, select_2408[5], 1'b0, select_2408[4], 1'b0, select_2408[3], 1'b0, select_2408[2], 1'b0, select_2408[1], 1'b0, select_2408[0], 1'b0} : {1'b0, select_2408[11], 1'b0, select_2408[10], 1'b0, select_2408[9], 1'b0, select_2408[8], 1'b0, select_2408[7], 1'b0, select_2408[6], 1'b0, select_2408[5], 1'b0, select_2408[4], 1'b0, select_2408[3], 1'b0, select_2408[2], 1'b0, select_2408[1], 1'b0, select_2408[0]};
  // hls/stages/census.hpp:387
  logic and_2413;
  assign and_2413 = less_2404 & (~((sharpness_sums_contrast_1_q & select_2409) == 24'h0));
  // hls/stages/census.hpp:392
  logic [17:0] select_2415;
  assign select_2415 = (less_2403 & and_2413) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2415};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2418;
  assign select_2418 = equal_2402 ? (less_2403 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:387
  logic and_2423;
  assign and_2423 = less_2404 & (~((sharpness_sums_contrast_0_q & select_2409) == 24'h0));
  // hls/stages/census.hpp:392
  logic [17:0] select_2425;
  assign select_2425 = (less_2403 & and_2423) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2425};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2428;
  assign select_2428 = equal_2402 ? (less_2403 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2430;
  assign select_2430 = equal_2402 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2432;
  assign select_2432 = equal_2402 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2434;
  assign select_2434 = equal_2402 ? {sharpness_comparing_contrast_0_q[0], and_2423} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2436;
  assign select_2436 = equal_2402 ? {sharpness_comparing_contrast_1_q[0], and_2413} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2441;
  assign select_2441 = drew_q ? (equal_2402 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2445;
  assign select_2445 = drew_q ? (equal_2402 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:384
  logic equal_2446;
  assign equal_2446 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:400
  logic xor_2447;
  assign xor_2447 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2450;
  assign select_2450 = (equal_2446 | xor_2447) ? (five_times[0] & xor_2447) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2452;
  assign select_2452 = drew_q ? (equal_2402 ? select_2450 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:400
  logic xor_2453;
  assign xor_2453 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2456;
  assign select_2456 = (equal_2446 | xor_2453) ? (five_times_2[0] & xor_2453) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2458;
  assign select_2458 = drew_q ? (equal_2402 ? select_2456 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:401
  logic xor_2459;
  assign xor_2459 = sharpness_comparing_contrast_0_q[1] ^ and_2413;
  logic select_2462;
  assign select_2462 = (equal_2446 | xor_2459) ? (and_2413 & xor_2459) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2464;
  assign select_2464 = drew_q ? (equal_2402 ? select_2462 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:401
  logic xor_2465;
  assign xor_2465 = sharpness_comparing_contrast_1_q[1] ^ and_2423;
  logic select_2468;
  assign select_2468 = (equal_2446 | xor_2465) ? (and_2423 & xor_2465) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2470;
  assign select_2470 = drew_q ? (equal_2402 ? select_2468 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2606;
  assign select_2606 = and_2598_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2604_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_2609;
  assign and_2609 = not_575_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2614;
  assign and_2614 = not_575_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2619;
  assign and_2619 = not_575_s3_q & (drew_q & (ends_cell_s3_q & and_2023_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_2623;
  assign not_2623 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2632;
  assign select_2632 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2633;
  assign difference_2633 = {1'b0, explained_2_s3_q} - {1'b0, select_2632};
  logic [4:0] e;
  assign e = {difference_2633[3], difference_2633} + (equal_569_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2636;
  assign sum_2636 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_2640;
  assign not_2640 = ~(equal_2082 ? and_2103 : (~({sum_2636, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_2643;
  assign and_2643 = ends_cell_s3_q & (not_2623 & (centres_values_1_textured_s3_q & not_2640));
  logic and_2645;
  assign and_2645 = not_575_s3_q & (drew_q & and_2643);
  // hls/stages/agreement.hpp:1132
  logic less_2648;
  assign less_2648 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2649;
  assign select_2649 = less_2648 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2652;
  assign select_2652 = less_2648 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2653;
  assign sum_2653 = {1'b0, select_2652} + {3'h0, select_2652[9:2]};
  logic and_2655;
  assign and_2655 = (~(select_2649[9:4] == 6'h0)) & ({sum_2653, select_2652[1:0]} < {3'h0, select_2649});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_2658;
  assign select_2658 = x_s3_q[6] ? (equal_1607_s3_q ? 10'h0 : (and_2655 ? select_2649 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2659;
  assign select_2659 = equal_574_s3_q ? select_2658 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2661;
  assign select_2661 = and_2598_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2659});
  logic [13:0] select_2668;
  assign select_2668 = and_2598_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2666_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_2670;
  assign and_2670 = not_2623 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_2673;
  assign and_2673 = not_575_s3_q & (drew_q & (ends_cell_s3_q & and_2670));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2675;
  assign select_2675 = and_2598_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2673});
  // hls/stages/agreement.hpp:1110
  logic and_2677;
  assign and_2677 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2640);
  // hls/stages/agreement.hpp:788
  logic and_2681;
  assign and_2681 = not_575_s3_q & (drew_q & (ends_cell_s3_q & (not_2623 & and_2677)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2683;
  assign select_2683 = and_2598_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2681});
  logic [13:0] select_2702;
  assign select_2702 = and_2598_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2700_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2777;
  assign select_2777 = drew_q ? (equal_1703_s3_q ? (and_2759_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2778;
  assign select_2778 = equal_574_s3_q ? 8'h0 : select_2777;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2780;
  assign select_2780 = and_2758_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2778[7]}}, select_2778});
  // hls/stages/agreement.hpp:788
  logic and_2783;
  assign and_2783 = not_575_s3_q & (drew_q & (and_2759_s3_q & equal_1703_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2785;
  assign select_2785 = and_2758_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2783});
  // hls/stages/registration.hpp:107
  logic and_2787;
  assign and_2787 = and_2759_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2789;
  assign select_2789 = drew_q ? (equal_1703_s3_q ? {and_2787, and_2759_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2790;
  assign select_2790 = equal_574_s3_q ? 2'h0 : select_2789;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2791;
  assign sum_2791 = registration_half_votes_down_q + {{5{select_2790[1]}}, select_2790};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2797;
  assign select_2797 = drew_q ? (equal_1703_s3_q ? {and_2795_s3_q, and_2759_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2798;
  assign select_2798 = equal_574_s3_q ? 2'h0 : select_2797;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2799;
  assign sum_2799 = registration_half_votes_up_q + {{5{select_2798[1]}}, select_2798};
  // hls/stages/registration.hpp:107
  logic and_2802;
  assign and_2802 = and_2759_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2804;
  assign select_2804 = drew_q ? (equal_1703_s3_q ? {and_2802, and_2759_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2805;
  assign select_2805 = equal_574_s3_q ? 2'h0 : select_2804;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2806;
  assign sum_2806 = registration_half_half_votes_down_q + {{5{select_2805[1]}}, select_2805};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2811;
  assign select_2811 = drew_q ? (equal_1703_s3_q ? {and_2809_s3_q, and_2759_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2812;
  assign select_2812 = equal_574_s3_q ? 2'h0 : select_2811;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2813;
  assign sum_2813 = registration_half_half_votes_up_q + {{5{select_2812[1]}}, select_2812};
  // hls/stages/agreement.hpp:788
  logic and_2847;
  assign and_2847 = equal_574_s3_q & (x_s3_q[6] & (not_1996_s3_q & less_1638_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2854;
  assign select_2854 = or_1642_s3_q ? 12'h0 : (equal_2852_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2857;
  assign select_2857 = x_s3_q[6] ? (equal_1607_s3_q ? 12'h0 : (less_1638_s3_q ? select_2854 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2858;
  assign select_2858 = equal_574_s3_q ? select_2857 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2859;
  assign and_2859 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2862;
  assign and_2862 = not_1996_s3_q & (less_1638_s3_q & ({and_2859, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_2864;
  assign and_2864 = equal_574_s3_q & (x_s3_q[6] & and_2862);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2866;
  assign sum_2866 = {{2{select_2858[11]}}, select_2858} + (and_2864 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2869;
  assign select_2869 = or_1642_s3_q ? 12'h0 : (equal_2852_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2872;
  assign select_2872 = x_s3_q[6] ? (equal_1607_s3_q ? 12'h0 : (less_1638_s3_q ? select_2869 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2873;
  assign select_2873 = equal_574_s3_q ? select_2872 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2875;
  assign sum_2875 = {{2{select_2873[11]}}, select_2873} + (and_2864 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2877;
  assign not_2877 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2880;
  assign and_2880 = not_1996_s3_q & (less_1638_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2877, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2886;
  assign and_2886 = equal_574_s3_q & (x_s3_q[6] & (not_1996_s3_q & (less_1638_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2887;
  assign not_2887 = ~and_2886;
  logic less_2888;
  assign less_2888 = $signed({9'h1, {2{not_2887}}, and_2886}) < $signed(registration_up_q[13:2]);
  logic select_2889;
  assign select_2889 = (equal_574_s3_q & (x_s3_q[6] & and_2880)) ? less_2888 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2893;
  assign and_2893 = x_s3_q[6] & (not_1996_s3_q & (less_1638_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2894;
  assign and_2894 = equal_574_s3_q & and_2893;
  // hls/stages/registration.hpp:242
  logic less_2895;
  assign less_2895 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2897;
  assign less_2897 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2899;
  assign equal_2899 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2903;
  assign and_2903 = equal_574_s3_q & (x_s3_q[6] & (not_1996_s3_q & (less_1638_s3_q & equal_2899)));
  // hls/stages/agreement.hpp:1142
  logic and_2910;
  assign and_2910 = x_s3_q[6] & (not_1996_s3_q & (less_1638_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2913;
  assign equal_2913 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2916;
  assign and_2916 = not_1996_s3_q & (less_1638_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2913));
  // hls/stages/registration.hpp:244
  logic and_2920;
  assign and_2920 = (equal_574_s3_q & (x_s3_q[6] & and_2916)) & (less_2897 | less_2895);
  // hls/stages/agreement.hpp:1142
  logic and_2925;
  assign and_2925 = not_1996_s3_q & (less_1638_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2913)));
  // hls/stages/registration.hpp:244
  logic and_2928;
  assign and_2928 = registration_votes_up_q & registration_other_down_q;
  logic select_2930;
  assign select_2930 = registration_votes_down_q ? (registration_other_up_q | and_2928) : and_2928;
  // hls/stages/registration.hpp:138
  logic and_2932;
  assign and_2932 = (equal_574_s3_q & (x_s3_q[6] & and_2925)) & (registration_other_enough_q & select_2930);
  // hls/stages/registration.hpp:245
  logic or_2935;
  assign or_2935 = registration_moved_q | (registration_enough_q & (and_2920 | and_2932));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3019;
  assign select_3019 = sample_pair_whole_s3_q ? (equal_1693_s3_q ? patches_place_0_slope_q : select_1798[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_3024;
  assign select_3024 = sample_pair_whole_s3_q ? (equal_1693_s3_q ? patches_place_1_slope_q : select_1827[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3026;
  assign select_3026 = equal_1693_s3_q ? patches_valid_0_q : (select_1692_s3_q ? patches_valid_0_q : select_1795[0]);
  // hls/stages/agreement.hpp:276
  logic select_3029;
  assign select_3029 = sample_pair_whole_s3_q ? (and_1818 ? (sample_present_s3_q & select_3026) : select_3026) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3031;
  assign select_3031 = equal_1693_s3_q ? patches_valid_1_q : (select_1692_s3_q ? select_1795[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3034;
  assign select_3034 = sample_pair_whole_s3_q ? (and_1838 ? (sample_present_s3_q & select_3031) : select_3031) : patches_valid_1_q;
  logic [5:0] select_3037;
  assign select_3037 = sample_pair_whole_s3_q ? (select_1816[5] ? {1'b1, select_1816[4:0]} : (select_1816 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3040;
  assign select_3040 = sample_pair_whole_s3_q ? (select_1836[5] ? {1'b1, select_1836[4:0]} : (select_1836 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3043;
  assign select_3043 = sample_pair_whole_s3_q ? (select_1849[4] ? {1'b1, select_1849[3:0]} : (select_1849 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3046;
  assign select_3046 = sample_pair_whole_s3_q ? (select_1854[4] ? {1'b1, select_1854[3:0]} : (select_1854 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:525
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3465_s3_q, parity_3461_s3_q, xor_3449_s3_q, parity_3421_s3_q, parity_3359_s3_q, parity_3230_s3_q} + (equal_3466_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3470;
  assign select_3470 = equal_1779_s3_q ? patches_sums_values_0_q : (equal_1781_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3471;
  assign select_3471 = equal_1781_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3473;
  assign select_3473 = equal_1781_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3475;
  assign select_3475 = equal_1781_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3477;
  assign select_3477 = equal_1781_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3479;
  assign select_3479 = equal_1781_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3481;
  assign select_3481 = equal_1781_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3483;
  assign select_3483 = equal_1781_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3485;
  assign select_3485 = equal_1781_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3487;
  assign select_3487 = equal_1781_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3489;
  assign select_3489 = equal_1781_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3491;
  assign select_3491 = equal_1781_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3493;
  assign select_3493 = equal_1781_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3495;
  assign select_3495 = equal_1781_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3497;
  assign select_3497 = equal_1781_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3499;
  assign select_3499 = equal_1781_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3501;
  assign select_3501 = equal_1781_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:599
  logic or_3606;
  assign or_3606 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_3605_s3_q;
  logic or_3609;
  assign or_3609 = equal_3597_s3_q | (less_3599_s3_q | (less_3600_s3_q | or_3606));
  // hls/stages/patches.hpp:579
  logic not_3610;
  assign not_3610 = ~or_3609;
  // hls/stages/patches.hpp:560
  logic and_3611;
  assign and_3611 = equal_1963_s3_q & not_3610;
  // hls/stages/patches.hpp:184
  logic and_3614;
  assign and_3614 = equal_1779_s3_q & (less_1960_s3_q ? (not_1962_s3_q & and_3611) : and_3611);
  // hls/stages/patches.hpp:657
  logic not_3615;
  assign not_3615 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:560
  logic and_3617;
  assign and_3617 = equal_1963_s3_q & (patches_second_s3_q & not_3610);
  // hls/stages/patches.hpp:184
  logic and_3620;
  assign and_3620 = equal_1779_s3_q & (less_1960_s3_q ? (not_1962_s3_q & and_3617) : and_3617);
  // hls/stages/patches.hpp:657
  logic not_3621;
  assign not_3621 = ~and_3620;
  // hls/stages/patches.hpp:188
  logic and_3623;
  assign and_3623 = and_3614 & (not_3615 & not_3621);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3625;
  assign sum_3625 = {7'h0, and_3623} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:597
  logic [7:0] select_3651;
  assign select_3651 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:596
  logic [5:0] select_3652;
  assign select_3652 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3653;
  assign sum_3653 = {2'h0, select_3585_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_3654;
  assign sum_3654 = {select_3652[5], select_3652} + {{3{sum_3653[3]}}, sum_3653};
  // hls/stages/patches.hpp:597
  logic [17:0] product_3655;
  assign product_3655 = $signed({{10{select_3651[7]}}, select_3651}) * $signed({{8{sum_3654[6]}}, sum_3654, select_3585_s3_q[2:0]});
  // hls/stages/patches.hpp:598
  logic [13:0] difference_3656;
  assign difference_3656 = {{6{select_3650_s3_q[7]}}, select_3650_s3_q} - {product_3655[17], product_3655[17:5]};
  // hls/stages/patches.hpp:604
  logic less_3657;
  assign less_3657 = $signed({{7{difference_3627[6]}}, difference_3627}) < $signed(difference_3656);
  // hls/stages/patches.hpp:560
  logic and_3660;
  assign and_3660 = equal_1963_s3_q & (not_3610 & (~less_3657));
  // hls/stages/patches.hpp:184
  logic and_3663;
  assign and_3663 = equal_1779_s3_q & (less_1960_s3_q ? (not_1962_s3_q & and_3660) : and_3660);
  // hls/stages/patches.hpp:660
  logic and_3664;
  assign and_3664 = and_3663 & and_3623;
  logic [7:0] sum_3665;
  assign sum_3665 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3664};
  // hls/stages/patches.hpp:560
  logic and_3669;
  assign and_3669 = not_3610 & (~($signed(difference_3656) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3670;
  assign and_3670 = equal_1963_s3_q & and_3669;
  // hls/stages/patches.hpp:184
  logic and_3673;
  assign and_3673 = equal_1779_s3_q & (less_1960_s3_q ? (not_1962_s3_q & and_3670) : and_3670);
  // hls/stages/patches.hpp:661
  logic and_3674;
  assign and_3674 = and_3673 & and_3623;
  logic [7:0] sum_3675;
  assign sum_3675 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3674};
  // hls/stages/patches.hpp:188
  logic and_3677;
  assign and_3677 = and_3614 & (and_3620 & not_3615);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3679;
  assign sum_3679 = {7'h0, and_3677} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:660
  logic and_3681;
  assign and_3681 = and_3663 & and_3677;
  logic [7:0] sum_3682;
  assign sum_3682 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3681};
  // hls/stages/patches.hpp:661
  logic and_3684;
  assign and_3684 = and_3673 & and_3677;
  logic [7:0] sum_3685;
  assign sum_3685 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3684};
  // hls/stages/patches.hpp:188
  logic and_3687;
  assign and_3687 = and_3614 & (patches_lower_s3_q & not_3621);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3689;
  assign sum_3689 = {7'h0, and_3687} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:660
  logic and_3691;
  assign and_3691 = and_3663 & and_3687;
  logic [7:0] sum_3692;
  assign sum_3692 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3691};
  // hls/stages/patches.hpp:661
  logic and_3694;
  assign and_3694 = and_3673 & and_3687;
  logic [7:0] sum_3695;
  assign sum_3695 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3694};
  // hls/stages/patches.hpp:188
  logic and_3697;
  assign and_3697 = and_3614 & (patches_lower_s3_q & and_3620);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3699;
  assign sum_3699 = {7'h0, and_3697} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:660
  logic and_3701;
  assign and_3701 = and_3663 & and_3697;
  logic [7:0] sum_3702;
  assign sum_3702 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3701};
  // hls/stages/patches.hpp:661
  logic and_3704;
  assign and_3704 = and_3673 & and_3697;
  logic [7:0] sum_3705;
  assign sum_3705 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3704};
  // hls/stages/agreement.hpp:1223
  logic equal_3706;
  assign equal_3706 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_3707;
  assign less_3707 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3711;
  assign and_3711 = equal_574_s3_q & (x_s3_q[6] & (not_1996_s3_q & (equal_3706 & less_3707)));
  // hls/stages/agreement.hpp:1142
  logic and_3716;
  assign and_3716 = x_s3_q[6] & (not_1996_s3_q & (less_3707 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_3717;
  assign and_3717 = equal_574_s3_q & and_3716;
  // hls/stages/patches.hpp:623
  logic [7:0] or_3719;
  assign or_3719 = (and_3711 ? patches_quarters_0_places_q : 8'h0) | (and_3717 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_3723;
  assign and_3723 = x_s3_q[6] & (not_1996_s3_q & (less_3707 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_3724;
  assign and_3724 = equal_574_s3_q & and_3723;
  // hls/stages/agreement.hpp:1142
  logic and_3730;
  assign and_3730 = x_s3_q[6] & (not_1996_s3_q & (less_3707 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_3731;
  assign and_3731 = equal_574_s3_q & and_3730;
  // hls/stages/patches.hpp:623
  logic [7:0] or_3733;
  assign or_3733 = (or_3719 | (and_3724 ? patches_quarters_2_places_q : 8'h0)) | (and_3731 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_3737;
  assign select_3737 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_3741;
  assign and_3741 = equal_574_s3_q & (x_s3_q[6] & (not_1996_s3_q & (less_3707 & select_3737)));
  // hls/stages/patches.hpp:624
  logic [7:0] select_3743;
  assign select_3743 = and_3711 ? (and_3741 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3745;
  assign select_3745 = and_3717 ? (and_3741 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3748;
  assign select_3748 = and_3724 ? (and_3741 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3751;
  assign select_3751 = and_3731 ? (and_3741 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:625
  logic [7:0] select_3754;
  assign select_3754 = and_3711 ? (and_3741 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3756;
  assign select_3756 = and_3717 ? (and_3741 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3759;
  assign select_3759 = and_3724 ? (and_3741 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3762;
  assign select_3762 = and_3731 ? (and_3741 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3764;
  assign sum_3764 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_3768;
  assign and_3768 = x_s3_q[6] & (not_1996_s3_q & (less_3707 & (sum_3764[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3769;
  assign and_3769 = equal_574_s3_q & and_3768;
  // hls/stages/patches.hpp:620
  logic [7:0] select_3772;
  assign select_3772 = and_3769 ? (patches_word_places_q + (and_3717 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3775;
  assign select_3775 = and_3769 ? (patches_word_up_q + (and_3717 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3778;
  assign select_3778 = and_3769 ? (patches_word_down_q + (and_3717 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:606
  logic [5:0] select_3782;
  assign select_3782 = ($signed(difference_3656[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3656[5:0];
  logic [5:0] select_3783;
  assign select_3783 = ($signed(14'h10) < $signed(difference_3656)) ? 6'h10 : select_3782;
  // hls/stages/patches.hpp:560
  logic [5:0] select_3785;
  assign select_3785 = equal_1963_s3_q ? (or_3609 ? 6'h0 : select_3783) : 6'h0;
  logic [5:0] select_3787;
  assign select_3787 = less_1960_s3_q ? (equal_1961_s3_q ? 6'h0 : select_3785) : select_3785;
  // hls/stages/patches.hpp:663
  logic [5:0] select_3789;
  assign select_3789 = and_3614 ? (equal_1779_s3_q ? select_3787 : 6'h0) : 6'h0;
  logic [11:0] sum_3790;
  assign sum_3790 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3789[5]}}, select_3789};
  // hls/stages/agreement.hpp:788
  logic and_3794;
  assign and_3794 = equal_574_s3_q & (x_s3_q[6] & (not_1996_s3_q & (equal_2899 & less_3707)));
  // hls/stages/agreement.hpp:1142
  logic and_3798;
  assign and_3798 = x_s3_q[6] & (not_1996_s3_q & (less_3707 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3799;
  assign and_3799 = equal_574_s3_q & and_3798;
  // hls/stages/patches.hpp:647
  logic [7:0] select_3801;
  assign select_3801 = and_3794 ? (and_3799 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:649
  logic or_3805;
  assign or_3805 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:650
  logic or_3808;
  assign or_3808 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic [8:0] sum_3809;
  assign sum_3809 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:646
  logic select_3811;
  assign select_3811 = and_3794 ? (and_3799 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3814;
  assign and_3814 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:646
  logic [2:0] select_3816;
  assign select_3816 = and_3799 ? {and_3814, patches_found_q[2:1]} : (and_3794 ? {and_3814, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:645
  logic or_3820;
  assign or_3820 = patches_partly_q | (patches_doubted_q & (~and_3799));
  // hls/stages/patches.hpp:646
  logic select_3823;
  assign select_3823 = and_3794 ? (and_3799 ? or_3820 : (and_3794 ? or_3820 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:644
  logic select_3824;
  assign select_3824 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:633
  logic [7:0] select_3828;
  assign select_3828 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:605
  logic [10:0] sum_3830;
  assign sum_3830 = {sum_3654[6], sum_3654, select_3585_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:560
  logic and_3833;
  assign and_3833 = equal_1963_s3_q & (not_3610 & ({{5{sum_3830[10]}}, sum_3830} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_3836;
  assign and_3836 = equal_1779_s3_q & (less_1960_s3_q ? (not_1962_s3_q & and_3833) : and_3833);
  // hls/stages/patches.hpp:188
  logic and_3837;
  assign and_3837 = and_3614 & and_3836;
  // hls/stages/patches.hpp:664
  logic [7:0] sum_3838;
  assign sum_3838 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3837};
  // hls/stages/patches.hpp:653
  logic [12:0] product_3843;
  assign product_3843 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_3801};
  // hls/stages/patches.hpp:188
  logic and_3845;
  assign and_3845 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_3843[12:5] < patches_on_skin_q);
  logic select_3850;
  assign select_3850 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:634
  logic or_3854;
  assign or_3854 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:635
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:636
  logic select_3861;
  assign select_3861 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:637
  logic and_3867;
  assign and_3867 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3868;
  assign sum_3868 = patches_age_q + {9'h0, and_3867};
  logic [9:0] select_3871;
  assign select_3871 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3868)) : sum_3868;
  // hls/stages/agreement.hpp:1188
  logic or_3928;
  assign or_3928 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_3930;
  assign equal_3930 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_3936;
  assign select_3936 = (equal_3930 & equal_3706) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3939;
  assign sum_3939 = {1'b0, select_2652} + {2'h0, select_2652[9:1]};
  logic select_3942;
  assign select_3942 = (select_2649[9:3] == 7'h0) ? ((~or_3928) & (~select_3936)) : (~({sum_3939, select_2652[0]} < {2'h0, select_2649}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3944;
  assign select_3944 = x_s3_q[6] ? (equal_1607_s3_q ? good_q : {select_3942, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_3949;
  assign select_3949 = equal_574_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3947_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_3950;
  assign equal_3950 = x_s3_q[6:3] == 4'ha;
  logic equal_3952;
  assign equal_3952 = x_s3_q[6:3] == 4'hc;
  logic equal_3953;
  assign equal_3953 = x_s3_q[6:3] == 4'hb;
  logic equal_3954;
  assign equal_3954 = x_s3_q[6:3] == 4'h9;
  logic equal_3955;
  assign equal_3955 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3957;
  assign select_3957 = equal_3954 ? counts_skin_unproven_q : (equal_3955 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3959;
  assign select_3959 = equal_3953 ? counts_regions_bad_q : (equal_3950 ? counts_nearer_q : select_3957);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3952 ? counts_on_skin_q : select_3959;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1230
  logic select_3962;
  assign select_3962 = (equal_3950 & equal_3706) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_3963;
  assign not_3963 = ~hidden_for_q[7];
  logic [7:0] select_3965;
  assign select_3965 = select_3962 ? (hidden_for_q + {7'h0, not_3963}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3967;
  assign select_3967 = equal_574_s3_q ? (equal_3947_s3_q ? select_3965 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3968;
  assign select_3968 = equal_3706 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3970;
  assign select_3970 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3972;
  assign select_3972 = equal_3955 ? cfg_unproven_skin_limit_i : (equal_3930 ? cfg_unproven_limit_i : select_3970);
  logic [7:0] select_3974;
  assign select_3974 = equal_3950 ? cfg_regions_limit_i : (equal_3954 ? cfg_hidden_limit_i : select_3972);
  logic [7:0] limit;
  assign limit = equal_3952 ? cfg_regions_limit_i : (equal_3953 ? {cfg_on_skin_limit_i, 3'h0} : select_3974);
  // hls/stages/agreement.hpp:1231
  logic not_3977;
  assign not_3977 = ~x_s3_q[2];
  logic [3:0] select_3978;
  assign select_3978 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3977, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3977};
  logic [7:0] select_3979;
  assign select_3979 = x_s3_q[0] ? {select_3978[3], 1'b0, select_3978[2], 1'b0, select_3978[1], 1'b0, select_3978[0], 1'b0} : {1'b0, select_3978[3], 1'b0, select_3978[2], 1'b0, select_3978[1], 1'b0, select_3978[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3983;
  assign select_3983 = equal_3954 ? counts_skin_supervised_q : (equal_3955 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3985;
  assign select_3985 = equal_3953 ? counts_skin_textured_q : (equal_3950 ? counts_textured_q : select_3983);
  logic [13:0] of;
  assign of = equal_3952 ? counts_textured_q : select_3985;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3987;
  assign select_3987 = ((limit & select_3979) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3968} + {1'b0, select_3987};
  // hls/stages/agreement.hpp:788
  logic select_3992;
  assign select_3992 = equal_574_s3_q ? (equal_3706 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_3997;
  assign and_3997 = too_much_q & (~(equal_3955 & equal_3706));
  // hls/stages/agreement.hpp:1229
  logic select_4002;
  assign select_4002 = (over[14] & equal_3706) ? (and_3997 | ((equal_3955 | equal_3954) | (x_s3_q[6:3] == 4'hf))) : and_3997;
  // hls/stages/agreement.hpp:1125
  logic and_4007;
  assign and_4007 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_4008;
  assign select_4008 = (equal_3952 & equal_3706) ? and_4007 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4010;
  assign select_4010 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4012;
  assign select_4012 = equal_574_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4010 : box_textured_columns_values_0_q);
  logic [2:0] select_4013;
  assign select_4013 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4015;
  assign select_4015 = equal_574_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4013 : box_textured_columns_values_1_q);
  logic [2:0] select_4016;
  assign select_4016 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4018;
  assign select_4018 = equal_574_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4016 : box_textured_columns_values_2_q);
  logic [2:0] select_4019;
  assign select_4019 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4021;
  assign select_4021 = equal_574_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4019 : box_textured_columns_values_3_q);
  logic [2:0] select_4022;
  assign select_4022 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4024;
  assign select_4024 = equal_574_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4022 : box_textured_columns_values_4_q);
  logic [4:0] select_4026;
  assign select_4026 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4028;
  assign select_4028 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4030;
  assign select_4030 = equal_574_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4028 : box_explained_columns_values_0_q);
  logic [2:0] select_4031;
  assign select_4031 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4033;
  assign select_4033 = equal_574_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4031 : box_explained_columns_values_1_q);
  logic [2:0] select_4034;
  assign select_4034 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4036;
  assign select_4036 = equal_574_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4034 : box_explained_columns_values_2_q);
  logic [2:0] select_4037;
  assign select_4037 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4039;
  assign select_4039 = equal_574_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4037 : box_explained_columns_values_3_q);
  logic [2:0] select_4040;
  assign select_4040 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4042;
  assign select_4042 = equal_574_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4040 : box_explained_columns_values_4_q);
  logic [4:0] select_4044;
  assign select_4044 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4047;
  assign select_4047 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4049;
  assign select_4049 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4051;
  assign select_4051 = equal_574_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4049 : box_shown_columns_values_1_q);
  logic [2:0] select_4052;
  assign select_4052 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4054;
  assign select_4054 = equal_574_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4052 : box_shown_columns_values_2_q);
  logic [2:0] select_4055;
  assign select_4055 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4057;
  assign select_4057 = equal_574_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4055 : box_shown_columns_values_3_q);
  logic [2:0] select_4058;
  assign select_4058 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4060;
  assign select_4060 = equal_574_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4058 : box_shown_columns_values_4_q);
  logic [4:0] select_4062;
  assign select_4062 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4065;
  assign select_4065 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4067;
  assign select_4067 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4069;
  assign select_4069 = equal_574_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4067 : box_nearer_columns_values_1_q);
  logic [2:0] select_4070;
  assign select_4070 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4072;
  assign select_4072 = equal_574_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4070 : box_nearer_columns_values_2_q);
  logic [2:0] select_4073;
  assign select_4073 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4075;
  assign select_4075 = equal_574_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4073 : box_nearer_columns_values_3_q);
  logic [2:0] select_4076;
  assign select_4076 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4078;
  assign select_4078 = equal_574_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4076 : box_nearer_columns_values_4_q);
  logic [4:0] select_4080;
  assign select_4080 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1275
  logic select_4115;
  assign select_4115 = left_first_s3_q ? done_s3_q : proven_q;
  // hls/stages/agreement.hpp:278
  logic select_4117;
  assign select_4117 = left_first_s3_q ? done_s3_q : (and_1977_s3_q ? select_4115 : proven_q);
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4168;
  assign select_4168 = and_4167_s3_q ? {and_2133, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4169;
  assign and_4169 = select_4115 & less_4145;
  // hls/stages/agreement.hpp:438
  logic select_4172;
  assign select_4172 = and_2060_s3_q ? (less_2061_s3_q ? (select_4168[0] & and_4169) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:278
  logic select_4174;
  assign select_4174 = left_first_s3_q ? select_4172 : (and_1977_s3_q ? select_4172 : seen_q);
  logic select_4175;
  assign select_4175 = and_1977_s3_q ? select_4174 : seen_q;
  // hls/stages/agreement.hpp:438
  logic select_4178;
  assign select_4178 = and_2060_s3_q ? (less_2061_s3_q ? (select_4168[1] & and_4169) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:278
  logic select_4180;
  assign select_4180 = left_first_s3_q ? select_4178 : (and_1977_s3_q ? select_4178 : nearer_q);
  logic select_4181;
  assign select_4181 = and_1977_s3_q ? select_4180 : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4188;
  assign or_4188 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1241
  logic not_4196;
  assign not_4196 = ~(or_3928 | not_2354);
  // hls/stages/agreement.hpp:788
  logic and_4200;
  assign and_4200 = equal_574_s3_q & (equal_3947_s3_q & (not_4196 & (select_3936 | select_4002)));
  logic and_4203;
  assign and_4203 = equal_3947_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4207;
  assign or_4207 = select_2452 | (select_2464 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4214;
  assign and_4214 = equal_574_s3_q & (equal_3947_s3_q & (not_4196 & (select_2458 | select_2470)));
  // hls/stages/agreement.hpp:1150
  logic and_4219;
  assign and_4219 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3965 < cfg_hidden_frames_i));
  logic select_4225;
  assign select_4225 = (not_2354 | (select_4008 & not_3840)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4230;
  assign and_4230 = equal_574_s3_q & (equal_3947_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4234;
  assign and_4234 = equal_574_s3_q & (x_s3_q[6] & (not_1996_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4242;
  assign select_4242 = equal_1629_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4240_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4243;
  assign select_4243 = equal_1627_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4242;
  logic [31:0] select_4244;
  assign select_4244 = equal_1625_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4243;
  logic [31:0] select_4245;
  assign select_4245 = equal_1623_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4244;
  logic [31:0] select_4246;
  assign select_4246 = equal_1621_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4245;
  logic [31:0] select_4247;
  assign select_4247 = equal_1619_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4246;
  logic [31:0] select_4248;
  assign select_4248 = equal_1617_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4247;
  logic [31:0] select_4249;
  assign select_4249 = equal_1615_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4248;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4250;
  assign select_4250 = less_2648 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4251;
  assign select_4251 = equal_1607_s3_q ? select_4249 : {2'h0, select_4250, select_2652, select_2649};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_549_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_746_s3_q, and_745, less_740_s3_q, and_739_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_733, and_709_s3_q, and_708_s3_q, and_683_s3_q, less_675_s3_q, less_674_s3_q, less_673_s3_q, less_672_s3_q, less_671_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q};
  end
`ifndef SYNTHESIS
  logic [5:0] fresh_raddr_s1_sim;
  logic fresh_re_s1_sim;
  logic [5:0] fresh_raddr_s2_sim;
  logic fresh_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_re_s1_sim <= 1'b0;
      fresh_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s1_sim <= fresh_re;
      fresh_raddr_s1_sim <= fresh_raddr;
      fresh_re_s2_sim <= fresh_re_s1_sim;
      fresh_raddr_s2_sim <= fresh_raddr_s1_sim;
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
      if (fresh_waddr >= 6'd47) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 6'd47) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1613_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1672_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1671, sum_1667};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_1701_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_1778_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1750_s3_q};
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
  assign patches_right_0_waddr = {select_1809_s3_q, select_1806};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_1818);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= sample_pair_pixel_1_s3_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_0_raddr_s1_sim;
  logic patches_right_0_re_s1_sim;
  logic [9:0] patches_right_0_raddr_s2_sim;
  logic patches_right_0_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_0_re_s1_sim <= 1'b0;
      patches_right_0_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_0_re_s1_sim <= patches_right_0_re;
      patches_right_0_raddr_s1_sim <= patches_right_0_raddr;
      patches_right_0_re_s2_sim <= patches_right_0_re_s1_sim;
      patches_right_0_raddr_s2_sim <= patches_right_0_raddr_s1_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_0_we) begin
      if (patches_right_0_re && patches_right_0_raddr == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s1_sim && patches_right_0_raddr_s1_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
      if (patches_right_0_re_s2_sim && patches_right_0_raddr_s2_sim == patches_right_0_waddr) begin
        $error("patches_right_0: address %0d is read less than DISTANCE steps after its write", patches_right_0_waddr);
      end
    end
  end
`endif

  // Memory patches_right_1, write
  logic [9:0] patches_right_1_waddr;
  assign patches_right_1_waddr = {select_1809_s3_q, select_1835};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1838);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= sample_pair_pixel_1_s3_q;
  end
`ifndef SYNTHESIS
  logic [9:0] patches_right_1_raddr_s1_sim;
  logic patches_right_1_re_s1_sim;
  logic [9:0] patches_right_1_raddr_s2_sim;
  logic patches_right_1_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_right_1_re_s1_sim <= 1'b0;
      patches_right_1_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      patches_right_1_re_s1_sim <= patches_right_1_re;
      patches_right_1_raddr_s1_sim <= patches_right_1_raddr;
      patches_right_1_re_s2_sim <= patches_right_1_re_s1_sim;
      patches_right_1_raddr_s2_sim <= patches_right_1_raddr_s1_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_right_1_we) begin
      if (patches_right_1_re && patches_right_1_raddr == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s1_sim && patches_right_1_raddr_s1_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
      if (patches_right_1_re_s2_sim && patches_right_1_raddr_s2_sim == patches_right_1_waddr) begin
        $error("patches_right_1: address %0d is read less than DISTANCE steps after its write", patches_right_1_waddr);
      end
    end
  end
`endif

  // Memory patches_left, write
  logic [8:0] patches_left_waddr;
  assign patches_left_waddr = {select_1857, select_1856_s3_q, column_4};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1863);
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= sample_pair_pixel_0_s3_q;
  end
`ifndef SYNTHESIS
  logic [8:0] patches_left_raddr_s1_sim;
  logic patches_left_re_s1_sim;
  logic [8:0] patches_left_raddr_s2_sim;
  logic patches_left_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_left_re_s1_sim <= 1'b0;
      patches_left_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      patches_left_re_s1_sim <= patches_left_re;
      patches_left_raddr_s1_sim <= patches_left_raddr;
      patches_left_re_s2_sim <= patches_left_re_s1_sim;
      patches_left_raddr_s2_sim <= patches_left_raddr_s1_sim;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_left_we) begin
      if (patches_left_re && patches_left_raddr == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s1_sim && patches_left_raddr_s1_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
      if (patches_left_re_s2_sim && patches_left_raddr_s2_sim == patches_left_waddr) begin
        $error("patches_left: address %0d is read less than DISTANCE steps after its write", patches_left_waddr);
      end
    end
  end
`endif

  // Memory patches_rows, write
  logic [4:0] patches_rows_waddr;
  assign patches_rows_waddr = patches_summed_down_by_s3_q;
  logic patches_rows_we;
  assign patches_rows_we = s3_en & patches_summed_last_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1984;
  end
`ifndef SYNTHESIS
  logic [4:0] patches_rows_raddr_s2_sim;
  logic patches_rows_re_s2_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      patches_rows_re_s2_sim <= 1'b0;
    end else if (en_i) begin
      patches_rows_re_s2_sim <= patches_rows_re;
      patches_rows_raddr_s2_sim <= patches_rows_raddr;
    end
  end
  always_ff @(posedge clk_i) begin
    if (rst_ni && patches_rows_we) begin
      if (patches_rows_re && patches_rows_raddr == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_re_s2_sim && patches_rows_raddr_s2_sim == patches_rows_waddr) begin
        $error("patches_rows: address %0d is read less than DISTANCE steps after its write", patches_rows_waddr);
      end
      if (patches_rows_waddr >= 5'd17) $error("patches_rows: write outside, address %0d", patches_rows_waddr);
    end
    if (rst_ni && patches_rows_re && patches_rows_raddr >= 5'd17) $error("patches_rows: read outside, address %0d", patches_rows_raddr);
  end
`endif

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s3_q, or_1994_s3_q, or_1991_s3_q, or_1988_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2028_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2027, sum_2017, sum_2012};
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
  assign map_waddr = sum_2069_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2143_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2133, is_seen};
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
      counts_on_skin_q <= 14'h0;
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
      patches_round_ends_q <= 1'b0;
      patches_found_q <= 3'h0;
      patches_doubted_q <= 1'b0;
      patches_doubted_before_q <= 1'b0;
      patches_round_places_q <= 8'h0;
      patches_round_across_q <= 12'h0;
      patches_round_moved_q <= 3'h0;
      patches_round_on_skin_q <= 8'h0;
      patches_on_skin_q <= 8'h0;
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
      overlooks_q <= 1'b0;
      proven_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s3_en) begin
      census_left_misses_q <= select_2293;
      sharpness_before_last_mask_q <= select_2366;
      sharpness_sums_detail_0_q <= and_549_s3_q ? select_2380 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_549_s3_q ? select_2392 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_549_s3_q ? sum_2396 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_549_s3_q ? sum_2400 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2418 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2428 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2430 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2432 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2434 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2436 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2441;
      sharpness_comparing_carry_1_q <= select_2445;
      sharpness_comparing_less_detail_0_q <= select_2452;
      sharpness_comparing_less_detail_1_q <= select_2458;
      sharpness_comparing_less_contrast_0_q <= select_2464;
      sharpness_comparing_less_contrast_1_q <= select_2470;
      counts_supervised_q <= select_2606;
      counts_textured_q <= and_2598_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2609});
      counts_explained_q <= and_2598_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2614});
      counts_nearer_q <= and_2598_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2619});
      counts_unproven_q <= and_2598_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2645});
      counts_regions_bad_q <= select_2661;
      counts_skin_supervised_q <= select_2668;
      counts_skin_textured_q <= select_2675;
      counts_skin_unproven_q <= select_2683;
      counts_on_skin_q <= select_2702;
      registration_half_across_q <= select_2780;
      registration_half_measured_q <= select_2785;
      registration_half_votes_down_q <= and_2758_s3_q ? 7'h0 : sum_2791;
      registration_half_votes_up_q <= and_2758_s3_q ? 7'h0 : sum_2799;
      registration_half_half_votes_down_q <= and_2758_s3_q ? 7'h0 : sum_2806;
      registration_half_half_votes_up_q <= and_2758_s3_q ? 7'h0 : sum_2813;
      registration_down_q <= and_2847 ? sum_2866 : registration_down_q;
      registration_up_q <= and_2847 ? sum_2875 : registration_up_q;
      registration_enough_q <= select_2889;
      registration_votes_down_q <= and_2894 ? less_2895 : registration_votes_down_q;
      registration_votes_up_q <= and_2894 ? less_2897 : registration_votes_up_q;
      registration_other_enough_q <= and_2903 ? select_2889 : registration_other_enough_q;
      registration_other_down_q <= and_2903 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2903 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_574_s3_q & and_2910)) & or_2935;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1797 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1799 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1800 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3019;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1826 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1828 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1829 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3024;
      patches_valid_0_q <= select_3029;
      patches_valid_1_q <= select_3034;
      patches_right_next_0_q <= select_3037;
      patches_right_next_1_q <= select_3040;
      patches_left_next_0_q <= select_3043;
      patches_left_next_1_q <= select_3046;
      patches_sums_values_0_q <= select_3470;
      patches_sums_values_1_q <= equal_1779_s3_q ? patches_sums_values_1_q : select_3471;
      patches_sums_values_2_q <= equal_1779_s3_q ? patches_sums_values_2_q : select_3473;
      patches_sums_values_3_q <= equal_1779_s3_q ? patches_sums_values_3_q : select_3475;
      patches_sums_values_4_q <= equal_1779_s3_q ? patches_sums_values_4_q : select_3477;
      patches_sums_values_5_q <= equal_1779_s3_q ? patches_sums_values_5_q : select_3479;
      patches_sums_values_6_q <= equal_1779_s3_q ? patches_sums_values_6_q : select_3481;
      patches_sums_values_7_q <= equal_1779_s3_q ? patches_sums_values_7_q : select_3483;
      patches_sums_values_8_q <= equal_1779_s3_q ? patches_sums_values_8_q : select_3485;
      patches_sums_values_9_q <= equal_1779_s3_q ? patches_sums_values_9_q : select_3487;
      patches_sums_values_10_q <= equal_1779_s3_q ? patches_sums_values_10_q : select_3489;
      patches_sums_values_11_q <= equal_1779_s3_q ? patches_sums_values_11_q : select_3491;
      patches_sums_values_12_q <= equal_1779_s3_q ? patches_sums_values_12_q : select_3493;
      patches_sums_values_13_q <= equal_1779_s3_q ? patches_sums_values_13_q : select_3495;
      patches_sums_values_14_q <= equal_1779_s3_q ? patches_sums_values_14_q : select_3497;
      patches_sums_values_15_q <= equal_1779_s3_q ? patches_sums_values_15_q : select_3499;
      patches_sums_values_16_q <= equal_1779_s3_q ? patches_sums_values_16_q : select_3501;
      patches_best_differing_q <= select_1984[9:0];
      patches_best_column_q <= select_1984[14:10];
      patches_quarters_0_places_q <= sum_3625;
      patches_quarters_0_up_q <= sum_3665;
      patches_quarters_0_down_q <= sum_3675;
      patches_quarters_1_places_q <= sum_3679;
      patches_quarters_1_up_q <= sum_3682;
      patches_quarters_1_down_q <= sum_3685;
      patches_quarters_2_places_q <= sum_3689;
      patches_quarters_2_up_q <= sum_3692;
      patches_quarters_2_down_q <= sum_3695;
      patches_quarters_3_places_q <= sum_3699;
      patches_quarters_3_up_q <= sum_3702;
      patches_quarters_3_down_q <= sum_3705;
      patches_word_places_q <= or_3733;
      patches_word_up_q <= ((select_3743 | select_3745) | select_3748) | select_3751;
      patches_word_down_q <= ((select_3754 | select_3756) | select_3759) | select_3762;
      patches_sum_places_q <= select_3772;
      patches_sum_up_q <= select_3775;
      patches_sum_down_q <= select_3778;
      patches_across_q <= sum_3790;
      patches_places_q <= select_3801;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3805;
      patches_partly_q <= or_3808;
      patches_clear_limit_q <= sum_3809[8:2];
      patches_complete_q <= select_3811;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3794 ? select_3816 : patches_found_q;
      patches_doubted_q <= select_3823;
      patches_doubted_before_q <= select_3824;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3828;
      patches_on_skin_q <= sum_3838;
      patches_large_q <= not_3840 & and_3845;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3850;
      patches_spoiled_q <= or_3854;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3861;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3871;
      segment_textured_q <= select_2009 + {5'h0, and_2609};
      segment_explained_q <= select_2014 + {5'h0, and_2614};
      segment_nearer_q <= select_2024 + {5'h0, and_2619};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_574_s3_q ? select_3944 : good_q;
      good_known_q <= select_3949;
      hidden_for_q <= select_3967;
      product_q <= equal_574_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3992;
      disagree_q <= equal_574_s3_q ? select_3936 : disagree_q;
      too_much_q <= equal_574_s3_q ? select_4002 : too_much_q;
      hides_q <= equal_574_s3_q ? select_3962 : hides_q;
      overlooks_q <= equal_574_s3_q ? select_4008 : overlooks_q;
      proven_q <= and_1977_s3_q ? select_4117 : proven_q;
      seen_q <= select_4175;
      nearer_q <= select_4181;
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
      averager_quarter_1_0_q <= select_2167;
      averager_quarter_1_1_q <= select_2169;
      averager_quarter_2_0_q <= select_2171;
      averager_quarter_2_1_q <= select_2173;
      averager_detail_0_q <= select_2185;
      averager_detail_1_q <= select_2193;
      census_changes_values_0_left_q <= and_549_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_549_s3_q ? sum_2277 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2279;
      census_changes_values_1_right_q <= select_2280;
      census_changes_values_2_left_q <= select_2281;
      census_changes_values_2_right_q <= select_2282;
      sharpness_last_mask_q <= and_549_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_549_s3_q ? select_2363[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_549_s3_q ? select_2363[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4012;
      box_textured_columns_values_1_q <= select_4015;
      box_textured_columns_values_2_q <= select_4018;
      box_textured_columns_values_3_q <= select_4021;
      box_textured_columns_values_4_q <= select_4024;
      box_textured_sum_sums_values_0_q <= equal_574_s3_q ? box_textured_sum_sums_values_0_q : select_4026;
      box_explained_columns_values_0_q <= select_4030;
      box_explained_columns_values_1_q <= select_4033;
      box_explained_columns_values_2_q <= select_4036;
      box_explained_columns_values_3_q <= select_4039;
      box_explained_columns_values_4_q <= select_4042;
      box_explained_sum_sums_values_0_q <= equal_574_s3_q ? box_explained_sum_sums_values_0_q : select_4044;
      box_shown_columns_values_0_q <= equal_574_s3_q ? box_shown_columns_values_0_q : select_4047;
      box_shown_columns_values_1_q <= select_4051;
      box_shown_columns_values_2_q <= select_4054;
      box_shown_columns_values_3_q <= select_4057;
      box_shown_columns_values_4_q <= select_4060;
      box_shown_sum_sums_values_0_q <= equal_574_s3_q ? box_shown_sum_sums_values_0_q : select_4062;
      box_nearer_columns_values_0_q <= equal_574_s3_q ? box_nearer_columns_values_0_q : select_4065;
      box_nearer_columns_values_1_q <= select_4069;
      box_nearer_columns_values_2_q <= select_4072;
      box_nearer_columns_values_3_q <= select_4075;
      box_nearer_columns_values_4_q <= select_4078;
      box_nearer_sum_sums_values_0_q <= equal_574_s3_q ? box_nearer_sum_sums_values_0_q : select_4080;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4119_s4_q;
  logic or_4182_s4_q;
  logic and_4183_s4_q;
  logic and_4191_s4_q;
  logic and_4194_s4_q;
  logic and_4200_s4_q;
  logic and_4204_s4_q;
  logic and_4210_s4_q;
  logic and_4214_s4_q;
  logic and_4222_s4_q;
  logic and_4227_s4_q;
  logic and_4230_s4_q;
  logic and_4234_s4_q;
  logic [5:0] select_4236_s4_q;
  logic [31:0] select_4253_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4119_s4_q <= said_q;
      or_4182_s4_q <= not_2354 | select_4175;
      and_4183_s4_q <= cfg_prove_i & select_4181;
      and_4191_s4_q <= equal_574_s3_q & (equal_3947_s3_q & (cfg_prove_i & or_4188));
      and_4194_s4_q <= equal_574_s3_q & (equal_3947_s3_q & (cfg_prove_i & or_3928));
      and_4200_s4_q <= and_4200;
      and_4204_s4_q <= equal_574_s3_q & and_4203;
      and_4210_s4_q <= equal_574_s3_q & (equal_3947_s3_q & (not_4196 & or_4207));
      and_4214_s4_q <= and_4214;
      and_4222_s4_q <= equal_574_s3_q & (equal_3947_s3_q & (cfg_prove_i & and_4219));
      and_4227_s4_q <= equal_574_s3_q & (equal_3947_s3_q & select_4225);
      and_4230_s4_q <= and_4230;
      and_4234_s4_q <= and_4234;
      select_4236_s4_q <= equal_574_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4253_s4_q <= equal_574_s3_q ? (x_s3_q[6] ? select_4251 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4182_s4_q;
  assign marks_nearer_o = and_4183_s4_q;
  assign verdict_valid_o = and_4119_s4_q;
  assign verdict_unproven_yet_o = and_4191_s4_q;
  assign verdict_untextured_o = and_4194_s4_q;
  assign verdict_disagree_o = and_4200_s4_q;
  assign verdict_moved_o = and_4204_s4_q;
  assign verdict_unsharp_left_o = and_4210_s4_q;
  assign verdict_unsharp_right_o = and_4214_s4_q;
  assign verdict_hidden_o = and_4222_s4_q;
  assign verdict_overlooked_o = and_4227_s4_q;
  assign verdict_out_of_step_o = and_4230_s4_q;
  assign frame_valid_o = and_4234_s4_q;
  assign frame_index_o = select_4236_s4_q;
  assign frame_word_o = select_4253_s4_q;
  assign valid_o = valid_s4_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], product_3843[4:0], sum_3809[1:0], sum_3764[1:0], product_3655[4:0], sum_2748[0], difference_2689[1:0], detail_4[1:0], detail_3[1:0], sum_2287[4:0], sum_1717[0], sum_1713[0], sum_731[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
