// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3083 bits, pipeline 850 bits, memories 66591 bits.
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
  logic not_2353;
  assign not_2353 = ~cfg_prove_i;
  logic [5:0] sum_2566;
  assign sum_2566 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3626;
  assign difference_3626 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3839;
  assign not_3839 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3897;
  assign difference_3897 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4144;
  assign less_4144 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4145;
  assign sum_4145 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_4146;
  assign select_4146 = less_4144 ? {sum_4145, cfg_height_i[5:3]} : 8'h0;

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
  // hls/stages/patches.hpp:393
  logic not_1676;
  assign not_1676 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_1679;
  assign not_1679 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:363
  logic and_1680;
  assign and_1680 = patches_capturing_q & not_1679;
  // hls/stages/patches.hpp:365
  logic equal_1681;
  assign equal_1681 = {or_521, select_528} == 4'hc;
  // hls/stages/patches.hpp:312
  logic equal_1683;
  assign equal_1683 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1688;
  assign and_1688 = (not_1676 & (patches_work_q == 3'h0)) & (~(and_1680 | ((~equal_1681) | (~equal_1683))));
  // hls/stages/patches.hpp:535
  logic equal_1779;
  assign equal_1779 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:513
  logic not_1780;
  assign not_1780 = ~equal_1779;
  // hls/stages/patches.hpp:506
  logic equal_1781;
  assign equal_1781 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:459
  logic not_1782;
  assign not_1782 = ~equal_1781;
  // hls/stages/patches.hpp:500
  logic equal_1783;
  assign equal_1783 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1784;
  assign equal_1784 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:535
  logic or_1785;
  assign or_1785 = equal_1783 | equal_1784;
  // hls/stages/patches.hpp:461
  logic not_1786;
  assign not_1786 = ~patches_second_q;
  // hls/stages/patches.hpp:374
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
  // hls/stages/patches.hpp:185
  logic and_1823;
  assign and_1823 = not_1780 & (not_1782 & (or_1785 & (patches_second_q & equal_1784)));
  // hls/stages/patches.hpp:168
  logic not_1839;
  assign not_1839 = ~equal_1784;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1855;
  assign select_1855 = and_1675 ? {select_1808[4], select_1808[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:459
  logic and_1865;
  assign and_1865 = not_1780 & (or_1785 & not_1782);
  // hls/stages/agreement.hpp:190
  logic and_1976;
  assign and_1976 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2147;
  assign select_2147 = sample_pair_whole_q ? (sample_last_q ? (select_528 + 3'h1) : select_528) : raster_at_y_q;
  logic [5:0] select_2149;
  assign select_2149 = sample_pair_whole_q ? (select_511 + {5'h0, equal_545}) : raster_at_column_q;
  logic [5:0] select_2152;
  assign select_2152 = sample_pair_whole_q ? (sample_last_q ? (select_677 + {5'h0, equal_546}) : select_677) : raster_at_row_q;
  logic select_2156;
  assign select_2156 = sample_pair_whole_q ? (sample_last_q ? (or_521 & (~raster_final_row_q)) : or_521) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2158;
  assign select_2158 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2162;
  assign select_2162 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [6:0] sum_2471;
  assign sum_2471 = {1'b0, last} + 7'h1;
  logic equal_2472;
  assign equal_2472 = {sum_2471[6], cfg_width_i[8:3]} == {1'b0, sum_2471[5:0]};
  // hls/stages/agreement.hpp:464
  logic and_2473;
  assign and_2473 = and_549 & equal_2472;
  // hls/stages/agreement.hpp:523
  logic select_2476;
  assign select_2476 = (and_2473 | (~ends_cell_q)) ? and_2473 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2476 ? (and_2473 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2480;
  assign select_2480 = select_2476 ? (and_2473 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2483;
  assign select_2483 = select_2476 ? (following_last_shift_q & (~and_2473)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2486;
  assign and_2486 = run_last_shift_q & equal_593;
  // hls/stages/agreement.hpp:616
  logic select_2488;
  assign select_2488 = equal_593 ? (~run_last_shift_q) : equal_594;
  // hls/stages/agreement.hpp:620
  logic equal_2489;
  assign equal_2489 = run_phase_q == 3'h1;
  logic not_2492;
  assign not_2492 = ~select_2488;
  // hls/stages/agreement.hpp:623
  logic equal_2494;
  assign equal_2494 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2495;
  assign and_2495 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2496;
  assign select_2496 = equal_2494 ? 2'h1 : {2{and_2495}};
  logic [2:0] select_2498;
  assign select_2498 = (and_2486 | (select_2488 | equal_2489)) ? (equal_2489 ? 3'h2 : {not_2492, {2{select_2488}}}) : (equal_578 ? 3'h6 : {select_2496[0], select_2496});
  // hls/stages/agreement.hpp:607
  logic and_2501;
  assign and_2501 = select_2488 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2504;
  assign select_2504 = (plan_shift_q[5] & select_2488) ? value : 7'h0;
  logic [1:0] or_2505;
  assign or_2505 = {2{so}} | select_2504[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] select_2506;
  assign select_2506 = select_2488 ? plan_columns_q : 8'h0;
  logic [6:0] or_2509;
  assign or_2509 = select_2506[6:0] | ((equal_2489 | equal_2494) ? whole_q : 7'h0);
  logic [1:0] or_2510;
  assign or_2510 = {2{and_2486}} | or_2509[3:2];
  // hls/stages/agreement.hpp:634
  logic [6:0] or_2512;
  assign or_2512 = {or_2509[6:4], or_2510, or_2509[1:0]} | (equal_578 ? drawn_q : 7'h0);
  logic [4:0] or_2513;
  assign or_2513 = {5{so}} | {or_2512[6], or_2512[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2517;
  assign not_2517 = ~run_shift_q[5];
  logic [6:0] difference_2519;
  assign difference_2519 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2520;
  assign select_2520 = equal_593 ? ({{7{not_2517}}, 1'b1} + run_span_q) : {difference_2519[6], difference_2519};
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2524;
  assign select_2524 = and_2473 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2526;
  assign select_2526 = select_2476 ? {select_2524[6], select_2524} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2529;
  assign select_2529 = select_2476 ? (and_2473 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [5:0] select_2537;
  assign select_2537 = and_549 ? (equal_2472 ? ((5'he < last[5:1]) ? 6'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2538;
  assign sum_2538 = {1'b0, last[5:2]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2540;
  assign select_2540 = and_549 ? (equal_2472 ? {sum_2538, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [4:0] sum_2541;
  assign sum_2541 = {1'b0, last[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2543;
  assign select_2543 = and_549 ? (equal_2472 ? {sum_2541, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2557;
  assign select_2557 = (ends_cell_q | select_2476) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_593 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2561;
  assign and_2561 = (~select_2476) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_2562;
  assign sum_2562 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_2564;
  assign select_2564 = equal_2472 ? ({sum_2562[6], cfg_height_i[8:3]} == {1'b0, sum_2562[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:318
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2940;
  assign select_2940 = and_1675 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2941;
  assign select_2941 = sample_pair_whole_q ? select_2940 : patches_phase_q;
  // hls/stages/patches.hpp:374
  logic and_2942;
  assign and_2942 = not_1679 & equal_1681;
  logic [8:0] select_2943;
  assign select_2943 = and_2942 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2944;
  assign select_2944 = and_2942 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2945;
  assign select_2945 = sample_pair_first_q ? select_2943 : select_2944;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2947;
  assign select_2947 = sample_pair_whole_q ? (and_1675 ? select_2945[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2949;
  assign select_2949 = sample_pair_whole_q ? (and_1675 ? select_2945[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2952;
  assign select_2952 = sample_pair_whole_q ? (equal_1683 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2954;
  assign select_2954 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1683}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:331
  logic equal_2955;
  assign equal_2955 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:332
  logic not_2956;
  assign not_2956 = ~equal_2955;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2958;
  assign select_2958 = sample_pair_whole_q ? (phase + {not_2956, 1'b1, not_2956, equal_2955}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_2960;
  assign equal_2960 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2964;
  assign select_2964 = equal_2960 ? ((select_2941 == 4'h6) ? 4'h0 : (select_2941 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2965;
  assign equal_2965 = select_2964 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2968;
  assign select_2968 = equal_2472 ? (equal_2965 ? 4'h6 : (select_2964 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2970;
  assign select_2970 = equal_2960 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2972;
  assign select_2972 = equal_2472 ? (select_2970 + {4'h0, equal_2965}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_2977;
  assign select_2977 = and_549 ? (equal_2472 ? ((6'h2 < row) & equal_2965) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2979;
  assign select_2979 = and_549 ? (equal_2472 ? select_2970 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:372
  logic or_3002;
  assign or_3002 = select_511[0] | select_677[5];
  logic [7:0] sum_3003;
  assign sum_3003 = {1'b0, select_511[2:1], or_3002, select_677[4:1]} + 8'h1;
  logic less_3004;
  assign less_3004 = {sum_3003, select_677[0], select_528, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3007;
  assign select_3007 = and_1675 ? (and_1688 ? (~less_3004) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:394
  logic or_3046;
  assign or_3046 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:396
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:188
  logic and_3052;
  assign and_3052 = equal_1779 & not_1786;
  // hls/stages/patches.hpp:400
  logic and_3053;
  assign and_3053 = not_1839 & and_3052;
  logic [1:0] select_3055;
  assign select_3055 = equal_1781 ? 2'h0 : (equal_1783 ? 2'h3 : {equal_1784, and_3053});
  // hls/stages/patches.hpp:280
  logic equal_3057;
  assign equal_3057 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:278
  logic not_3058;
  assign not_3058 = ~equal_3057;
  // hls/stages/patches.hpp:280
  logic equal_3059;
  assign equal_3059 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:276
  logic not_3060;
  assign not_3060 = ~equal_3059;
  // hls/stages/patches.hpp:284
  logic not_3062;
  assign not_3062 = ~(patches_following_q == 3'h2);
  logic and_3065;
  assign and_3065 = (~(patches_following_q == 3'h1)) & not_3062;
  // hls/stages/patches.hpp:398
  logic [1:0] select_3066;
  assign select_3066 = equal_3059 ? 2'h2 : {and_3065, not_3062};
  logic [3:0] select_3067;
  assign select_3067 = equal_3057 ? 4'h2 : {select_3066, {2{not_3060}}};
  // hls/stages/patches.hpp:406
  logic not_3070;
  assign not_3070 = ~or_3046;
  // hls/stages/patches.hpp:395
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:407
  logic [11:0] select_3075;
  assign select_3075 = or_3046 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:188
  logic [4:0] select_3077;
  assign select_3077 = or_3046 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

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

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:780; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:780; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:781; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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
  assign patches_left_re = s0_en & (not_1780 & (not_1782 & (not_1839 & or_1785)));
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:792; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign patches_columns_above_re = s0_en & and_1865;
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
      left_first_q <= and_1976 ? left_first_q : marks_first_i;
      right_q <= (~and_1976) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1976;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_509 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2147;
      raster_at_column_q <= select_2149;
      raster_at_row_q <= select_2152;
      raster_at_live_q <= select_2156;
      raster_rows_left_q <= sample_pair_whole_q ? select_2158 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2162;
      averager_place_q <= sample_pair_whole_q ? select_515 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_520 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2480;
      run_last_shift_q <= select_2483;
      run_span_q <= select_2476 ? (and_2473 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2498;
      following_shift_q <= select_2488 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2501;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2504[6], or_2505, select_2504[3:0]};
      following_columns_q <= {select_2506[7], or_2513[4], or_2512[5:4], or_2513[3:0]};
      plan_shift_q <= equal_593 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2520;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2526;
      columns_left_q <= select_2529;
      last_q <= and_549 ? (equal_2472 ? last : last_q) : last_q;
      least_q <= select_2537;
      whole_q <= select_2540;
      drawn_q <= select_2543;
      age_q <= select_2476 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2476 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2557;
      ends_q <= and_2561;
      final_row_q <= and_549 ? select_2564 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2941;
      patches_band_rows_rows_to_next_q <= select_2947;
      patches_band_rows_number_q <= select_2949;
      patches_next_band_rows_to_next_q <= select_2952;
      patches_next_band_number_q <= select_2954;
      patches_first_band_rows_to_next_q <= select_2958;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2955 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_549 ? select_2968 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_549 ? select_2972 : patches_choosing_number_q;
      patches_chooses_q <= select_2977;
      patches_choosing_band_q <= select_2979;
      patches_capturing_q <= sample_pair_whole_q ? select_1815 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3007 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1809 : patches_row_q;
      patches_work_q <= or_3046 ? following : patches_work_q;
      patches_second_q <= not_1676 & (patches_second_q | (patches_ends_q & equal_1779));
      patches_following_q <= equal_1779 ? {2'h0, and_3052} : {equal_1781, select_3055};
      patches_following_beats_q <= {select_3067, not_3058};
      patches_begins_q <= sample_pair_whole_q & (and_1675 & and_1811);
      patches_ends_q <= not_3070 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3075;
      patches_code_row_q <= select_3077;
      patches_column_q <= or_3046 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3070 & (patches_column_q == 5'h1e);
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
  logic [3:0] select_1855_s1_q;
  logic and_1865_s1_q;
  logic equal_2472_s1_q;
  logic and_2473_s1_q;
  logic or_3046_s1_q;
  logic not_3070_s1_q;
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
      select_1855_s1_q <= select_1855;
      and_1865_s1_q <= and_1865;
      equal_2472_s1_q <= equal_2472;
      and_2473_s1_q <= and_2473;
      or_3046_s1_q <= or_3046;
      not_3070_s1_q <= not_3070;
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
  // hls/stages/patches.hpp:173
  logic [7:0] pixel;
  assign pixel = equal_1784_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1784_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:501
  logic less_1871;
  assign less_1871 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:502
  logic or_1872;
  assign or_1872 = equal_1783_s1_q | less_1871;
  // hls/stages/patches.hpp:505
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1877;
  assign select_1877 = equal_1783_s1_q ? patches_column_s1_q[0] : (or_1872 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1878;
  assign not_1878 = ~or_1872;
  // hls/stages/patches.hpp:502
  logic [4:0] sum_1879;
  assign sum_1879 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:504
  logic [4:0] select_1882;
  assign select_1882 = or_1872 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1879) + 5'h1) : sum_1879;
  // hls/stages/patches.hpp:506
  logic [4:0] select_1883;
  assign select_1883 = equal_1783_s1_q ? 5'h0 : select_1882;
  logic or_1884;
  assign or_1884 = equal_1783_s1_q | equal_1781_s1_q;
  // hls/stages/patches.hpp:482
  logic equal_1886;
  assign equal_1886 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1888;
  assign equal_1888 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:484
  logic and_1890;
  assign and_1890 = of_row & (~equal_1888);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1886 ? 2'h3 : {equal_1888, and_1890};
  // hls/stages/patches.hpp:470
  logic [8:0] sum_1893;
  assign sum_1893 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1894;
  assign sum_1894 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1893, pixel_2[0]} - {1'b0, sum_1894, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:472
  logic [11:0] sum_1896;
  assign sum_1896 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1897;
  assign sum_1897 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1896[11], sum_1896};
  logic [13:0] sum_1898;
  assign sum_1898 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1897, down_2[1]};
  logic [12:0] sum_1899;
  assign sum_1899 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1898[13:1];
  logic [14:0] sum_1900;
  assign sum_1900 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1899, sum_1898[0], down_2[0]};
  // hls/stages/patches.hpp:454
  logic or_1907;
  assign or_1907 = (sum_1900[8] & (~(sum_1900[7:0] == 8'h0))) | (~(sum_1900[13:9] == 5'h0));
  // hls/stages/patches.hpp:468
  logic [8:0] sum_1912;
  assign sum_1912 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1913;
  assign sum_1913 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1912};
  logic [10:0] sum_1914;
  assign sum_1914 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1913, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1915;
  assign sum_1915 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1914[10:1];
  // hls/stages/patches.hpp:469
  logic [11:0] smooth;
  assign smooth = {sum_1915, sum_1914[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:471
  logic [12:0] sum_1917;
  assign sum_1917 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1918;
  assign sum_1918 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1919;
  assign difference_1919 = {1'b0, sum_1917, smooth[0]} - {1'b0, sum_1918, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:454
  logic or_1926;
  assign or_1926 = (difference_1919[8] & (~(difference_1919[7:0] == 8'h0))) | (~(difference_1919[13:9] == 5'h0));
  // hls/stages/patches.hpp:483
  logic or_1934;
  assign or_1934 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1888) | equal_1886;
  // hls/stages/patches.hpp:478
  logic and_1939;
  assign and_1939 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:185
  logic and_1943;
  assign and_1943 = not_1782_s1_q & (or_1785_s1_q & (or_1934 & (equal_1784_s1_q & and_1939)));
  // hls/stages/patches.hpp:173
  logic and_1953;
  assign and_1953 = (~(equal_1784_s1_q | (~and_1939))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:185
  logic and_1957;
  assign and_1957 = not_1782_s1_q & (or_1785_s1_q & (and_1953 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:547
  logic less_1959;
  assign less_1959 = patches_step_q[4:0] < 5'h11;
  logic equal_1960;
  assign equal_1960 = patches_step_q[6:5] == 2'h0;
  logic not_1961;
  assign not_1961 = ~equal_1960;
  logic equal_1962;
  assign equal_1962 = patches_step_q[6:5] == 2'h3;
  logic not_1963;
  assign not_1963 = ~equal_1962;
  // hls/stages/patches.hpp:561
  logic select_1966;
  assign select_1966 = equal_1962 ? (less_1959 & (less_1959 & not_1963)) : less_1959;
  // hls/stages/patches.hpp:185
  logic and_1969;
  assign and_1969 = equal_1779_s1_q & (less_1959 ? (not_1961 & select_1966) : select_1966);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1997;
  assign sum_1997 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:460
  logic select_2569;
  assign select_2569 = equal_2472_s1_q ? (~({row_s1_q, 1'b0} < {sum_2566, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_2830;
  assign and_2830 = and_549_s1_q & (equal_2472_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_2831;
  assign and_2831 = and_2473_s1_q & and_2830;
  // hls/stages/registration.hpp:127
  logic and_2833;
  assign and_2833 = and_2473_s1_q & (~and_2830);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2834;
  assign select_2834 = and_2833 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2836;
  assign select_2836 = and_2831 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2834[15]}}, select_2834});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2837;
  assign select_2837 = and_2833 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2837[15]}}, select_2837};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2839;
  assign select_2839 = and_2831 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_2840;
  assign and_2840 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2840 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:188
  logic select_3085;
  assign select_3085 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:185
  logic [11:0] select_3088;
  assign select_3088 = equal_1781_s1_q ? patches_smooth_values_0_q : (or_1785_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3090;
  assign select_3090 = or_1785_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3092;
  assign select_3092 = equal_1779_s1_q ? patches_smooth_values_1_q : (equal_1781_s1_q ? patches_smooth_values_1_q : select_3090);
  logic [11:0] select_3093;
  assign select_3093 = or_1785_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3095;
  assign select_3095 = equal_1779_s1_q ? patches_smooth_values_2_q : (equal_1781_s1_q ? patches_smooth_values_2_q : select_3093);
  logic [11:0] select_3096;
  assign select_3096 = or_1785_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3098;
  assign select_3098 = equal_1779_s1_q ? patches_smooth_values_3_q : (equal_1781_s1_q ? patches_smooth_values_3_q : select_3096);
  logic [10:0] select_3100;
  assign select_3100 = equal_1781_s1_q ? patches_down_values_0_q : (or_1785_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3103;
  assign select_3103 = equal_1781_s1_q ? patches_down_values_1_q : (or_1785_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3106;
  assign select_3106 = equal_1781_s1_q ? patches_down_values_2_q : (or_1785_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3109;
  assign select_3109 = equal_1781_s1_q ? patches_down_values_3_q : (or_1785_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:176
  logic and_3146;
  assign and_3146 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:414
  logic [4:0] select_3151;
  assign select_3151 = or_3046_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:416
  logic [3:0] select_3153;
  assign select_3153 = and_3146 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:185
  logic [4:0] select_3509;
  assign select_3509 = equal_1779_s1_q ? patches_summed_down_by_q : (equal_1781_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:557
  logic and_3542;
  assign and_3542 = less_1959 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:561
  logic select_3545;
  assign select_3545 = equal_1962 ? (less_1959 ? (not_1963 & and_3542) : and_3542) : and_3542;
  // hls/stages/patches.hpp:185
  logic select_3548;
  assign select_3548 = equal_1779_s1_q ? (less_1959 ? (not_1961 & select_3545) : select_3545) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3887;
  assign select_3887 = so_s1_q ? (and_2840 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3889;
  assign sum_3889 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3890;
  assign select_3890 = sum_1997[5] ? {1'b1, sum_1997[4:0], region_across_rest_q[2:0]} : sum_3889;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3892;
  assign select_3892 = equal_2472_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3895;
  assign select_3895 = equal_2472_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

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

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:797; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1883, not_1878, select_1877};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1884;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:798; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:812; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
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
  assign patches_rows_re = s1_en & and_1969;
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
  assign patches_columns_above_we = s1_en & and_1865_s1_q;
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
      row_q <= and_549_s1_q ? (equal_2472_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_549_s1_q ? select_2569 : lower_half_q;
      registration_slope_row_q <= select_2836;
      registration_slope_change_q <= select_2839;
      registration_slope_q <= so_s1_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3070_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3070_s1_q & select_3085;
      patches_smooth_values_0_q <= equal_1779_s1_q ? patches_smooth_values_0_q : select_3088;
      patches_smooth_values_1_q <= select_3092;
      patches_smooth_values_2_q <= select_3095;
      patches_smooth_values_3_q <= select_3098;
      patches_down_values_0_q <= equal_1779_s1_q ? patches_down_values_0_q : select_3100;
      patches_down_values_1_q <= equal_1779_s1_q ? patches_down_values_1_q : select_3103;
      patches_down_values_2_q <= equal_1779_s1_q ? patches_down_values_2_q : select_3106;
      patches_down_values_3_q <= equal_1779_s1_q ? patches_down_values_3_q : select_3109;
      patches_down_by_q <= or_3046_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3146});
      patches_along_q <= select_3151;
      patches_match_row_q <= or_3046_s1_q ? 4'h0 : select_3153;
      patches_summed_last_q <= not_1780_s1_q & (equal_1781_s1_q & and_3146);
      patches_summed_down_by_q <= select_3509;
      patches_step_q <= or_3046_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3548;
      region_across_rest_q <= select_3887;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3890;
      columns_begin_rest_q <= and_549_s1_q ? select_3892 : columns_begin_rest_q;
      columns_begin_back_q <= and_549_s1_q ? select_3895 : columns_begin_back_q;
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
  logic [3:0] select_1855_s2_q;
  logic less_1871_s2_q;
  logic new_row_s2_q;
  logic or_1884_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_1901_s2_q;
  logic or_1907_s2_q;
  logic and_1911_s2_q;
  logic and_1927_s2_q;
  logic and_1930_s2_q;
  logic and_1944_s2_q;
  logic and_1953_s2_q;
  logic and_1958_s2_q;
  logic less_1959_s2_q;
  logic equal_1960_s2_q;
  logic not_1961_s2_q;
  logic equal_1962_s2_q;
  logic not_1963_s2_q;
  logic and_1976_s2_q;
  logic select_1978_s2_q;
  logic and_1981_s2_q;
  logic sum_1997_s2_q;
  logic and_2018_s2_q;
  logic and_2136_s2_q;
  logic equal_2283_s2_q;
  logic equal_2472_s2_q;
  logic and_2599_s2_q;
  logic equal_2684_s2_q;
  logic less_3122_s2_q;
  logic equal_3465_s2_q;
  logic equal_3549_s2_q;
  logic less_3875_s2_q;
  logic equal_4094_s2_q;
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
      select_1855_s2_q <= select_1855_s1_q;
      less_1871_s2_q <= less_1871;
      new_row_s2_q <= new_row;
      or_1884_s2_q <= or_1884;
      of_row_2_s2_q <= of_row_2;
      not_1901_s2_q <= ~sum_1900[14];
      or_1907_s2_q <= or_1907;
      and_1911_s2_q <= sum_1900[14] & (~(sum_1900[13:8] == 6'h3f));
      and_1927_s2_q <= (~difference_1919[14]) & or_1926;
      and_1930_s2_q <= difference_1919[14] & (~(difference_1919[13:8] == 6'h3f));
      and_1944_s2_q <= not_1780_s1_q & and_1943;
      and_1953_s2_q <= and_1953;
      and_1958_s2_q <= not_1780_s1_q & and_1957;
      less_1959_s2_q <= less_1959;
      equal_1960_s2_q <= equal_1960;
      not_1961_s2_q <= not_1961;
      equal_1962_s2_q <= equal_1962;
      not_1963_s2_q <= not_1963;
      and_1976_s2_q <= sample_pair_whole_q;
      select_1978_s2_q <= left_first_q;
      and_1981_s2_q <= right_q;
      sum_1997_s2_q <= sum_1997[5];
      and_2018_s2_q <= or_579_s1_q & (left_rdata_q[69] & not_583_s1_q);
      and_2136_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2283_s2_q <= (last_s1_2_q | row_s1_q) == 6'h0;
      equal_2472_s2_q <= equal_2472_s1_q;
      and_2599_s2_q <= or_579_s1_q & (not_583_s1_q & and_607);
      equal_2684_s2_q <= shift == 6'h0;
      less_3122_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3465_s2_q <= patches_match_row_q == 4'h0;
      equal_3549_s2_q <= patches_step_q[6:5] == 2'h2;
      less_3875_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4094_s2_q <= row_s1_q[5:3] == 3'h0;
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
  // hls/stages/patches.hpp:211
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
  // hls/stages/patches.hpp:374
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
  // hls/stages/patches.hpp:157
  logic and_1749;
  assign and_1749 = and_1747 & (~patches_fixed_q);
  // hls/stages/patches.hpp:345
  logic select_1750;
  assign select_1750 = and_1749 ? and_1747 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1753;
  assign select_1753 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:345
  logic [7:0] select_1755;
  assign select_1755 = and_1749 ? (equal_574_s2_q ? 8'h0 : select_1753) : patches_choice_column_q;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1758;
  assign select_1758 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:345
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
  // hls/stages/patches.hpp:345
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
  // hls/stages/patches.hpp:345
  logic and_1778;
  assign and_1778 = patches_chooses_s2_q & and_1777;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1792;
  assign select_1792 = and_1675_s2_q ? select_1690 : patches_band_q;
  // hls/stages/patches.hpp:354
  logic equal_1793;
  assign equal_1793 = {patches_choosing_band_s2_q, and_1701} == {select_1792, select_1692[1]};
  // hls/stages/patches.hpp:487
  logic [2:0] sum_1892;
  assign sum_1892 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:454
  logic and_1908;
  assign and_1908 = not_1901_s2_q & or_1907_s2_q;
  // hls/stages/patches.hpp:491
  logic [1:0] sum_1948;
  assign sum_1948 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1984;
  assign select_1984 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1987;
  assign or_1987 = select_1984[7] | (~({select_1984[5], select_1984[3], select_1984[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_1990;
  assign or_1990 = select_1984[7] | (~({select_1984[6], select_1984[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_1993;
  assign or_1993 = select_1984[7] | (~(select_1984[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1994;
  assign select_1994 = equal_574_s2_q ? x_s2_q[5:0] : {region_row_q, or_1993, or_1990, or_1987};
  // hls/stages/agreement.hpp:1128
  logic not_1995;
  assign not_1995 = ~equal_1607;
  // hls/stages/agreement.hpp:1058
  logic or_1999;
  assign or_1999 = (~sum_1997_s2_q) | equal_1772;
  // hls/stages/agreement.hpp:788
  logic and_2002;
  assign and_2002 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_1999));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_579_s2_q & (not_583_s2_q & and_608_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_636;
  // hls/stages/agreement.hpp:149
  logic and_2020;
  assign and_2020 = or_579_s2_q & (not_583_s2_q & and_2018_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2029;
  assign and_2029 = inside_v_s2_q & and_2020;
  // hls/stages/agreement.hpp:1014
  logic select_2030;
  assign select_2030 = slot_s2_q[2] ? shown_shown_q : and_636;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2030);
  // hls/stages/agreement.hpp:1014
  logic select_2033;
  assign select_2033 = slot_s2_q[2] ? shown_nearer_q : and_1585;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2030 ? select_2033 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1271
  logic select_2036;
  assign select_2036 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1275
  logic select_2037;
  assign select_2037 = left_first_s2_q ? select_2036 : read_half_q;
  logic or_2038;
  assign or_2038 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2039;
  assign select_2039 = or_2038 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1277
  logic [9:0] select_2041;
  assign select_2041 = left_first_s2_q ? 10'h1 : (or_2038 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1280
  logic and_2042;
  assign and_2042 = select_2039[8] & select_2041[9];
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = and_2042 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [5:0] select_2045;
  assign select_2045 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2047;
  assign select_2047 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2045});
  // hls/stages/agreement.hpp:1301
  logic equal_2048;
  assign equal_2048 = seen_x_q == 3'h7;
  logic [7:0] select_2050;
  assign select_2050 = and_2042 ? 8'h0 : (seen_column_q + {7'h0, equal_2048});
  // hls/stages/agreement.hpp:1308
  logic [10:0] index;
  assign index = select_2047 + {3'h0, select_2050};
  // hls/stages/agreement.hpp:1261
  logic [11:0] sum_2052;
  assign sum_2052 = {1'b0, {2{select_2037}}, 2'h0, {2{select_2037}}, 1'b0, {2{select_2037}}, 1'b0, select_2037} + {1'b0, index};
  // hls/stages/agreement.hpp:1274
  logic not_2053;
  assign not_2053 = ~left_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2055;
  assign and_2055 = not_2053 & (began_q | and_2042);
  // hls/stages/agreement.hpp:1302
  logic [2:0] select_2057;
  assign select_2057 = and_2042 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1307
  logic and_2059;
  assign and_2059 = and_2055 & (select_2057 == 3'h0);
  logic less_2060;
  assign less_2060 = select_2050 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:438
  logic and_2061;
  assign and_2061 = and_2059 & less_2060;
  logic and_2062;
  assign and_2062 = and_1976_s2_q & and_2061;
  // hls/stages/agreement.hpp:278
  logic select_2064;
  assign select_2064 = and_1976_s2_q ? (left_first_s2_q ? and_2061 : and_2062) : and_2062;
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2066;
  assign sum_2066 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2066[7], sum_2066, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [11:0] sum_2068;
  assign sum_2068 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1030
  logic and_2069;
  assign and_2069 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2070;
  assign and_2070 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2071;
  assign and_2071 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2072;
  assign and_2072 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2074;
  assign sum_2074 = {1'b0, and_2071} + ({1'b0, textured} + {1'b0, and_2072});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2069} + ({2'h0, and_2070} + {1'b0, sum_2074});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2083;
  assign select_2083 = inside_v_s2_q ? (sum_1997_s2_q ? select_1984 : {select_1984[6:0], 1'b0}) : select_1984;
  // hls/stages/agreement.hpp:1050
  logic or_2086;
  assign or_2086 = select_2083[7] | (~({select_2083[5], select_2083[3], select_2083[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2103;
  assign and_2103 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2104;
  assign and_2104 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2105;
  assign and_2105 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2106;
  assign and_2106 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2108;
  assign sum_2108 = {1'b0, and_2105} + ({1'b0, shown} + {1'b0, and_2106});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2103} + ({2'h0, and_2104} + {1'b0, sum_2108});
  // hls/stages/agreement.hpp:1030
  logic and_2119;
  assign and_2119 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2120;
  assign and_2120 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2121;
  assign and_2121 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2122;
  assign and_2122 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2124;
  assign sum_2124 = {1'b0, and_2121} + ({1'b0, near} + {1'b0, and_2122});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2119} + ({2'h0, and_2120} + {1'b0, sum_2124});
  // hls/stages/agreement.hpp:788
  logic and_2140;
  assign and_2140 = ends_cell_s2_q & (and_2136_s2_q & (~({1'b0, sum_1647, last_s2_q[1:0]} < x_s2_q)));
  logic and_2142;
  assign and_2142 = not_575_s2_q & (so_s2_q & and_2140);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2174;
  assign select_2174 = sample_pair_whole_s2_q ? (and_547_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2176;
  assign select_2176 = sample_pair_whole_s2_q ? (and_547_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2196;
  assign select_2196 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2198;
  assign select_2198 = sample_pair_whole_s2_q ? (and_547_s2_q ? select_562 : averager_mask_q) : averager_mask_q;
  logic select_2200;
  assign select_2200 = sample_pair_whole_s2_q ? (and_547_s2_q ? select_566 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2201;
  assign select_2201 = and_549_s2_q ? select_555 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2202;
  assign select_2202 = and_549_s2_q ? select_559 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2204;
  assign select_2204 = and_549_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2205;
  assign select_2205 = and_549_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2206;
  assign select_2206 = and_549_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2207;
  assign select_2207 = and_549_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2208;
  assign select_2208 = and_549_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2209;
  assign select_2209 = and_549_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2210;
  assign select_2210 = and_549_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2211;
  assign select_2211 = and_549_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2212;
  assign select_2212 = and_549_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2213;
  assign select_2213 = and_549_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2214;
  assign select_2214 = and_549_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_549_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2216;
  assign select_2216 = and_549_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2217;
  assign select_2217 = and_549_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2218;
  assign select_2218 = and_549_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2219;
  assign select_2219 = and_549_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2220;
  assign select_2220 = and_549_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2221;
  assign select_2221 = and_549_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2222;
  assign select_2222 = and_549_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2223;
  assign select_2223 = and_549_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2224;
  assign select_2224 = and_549_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2225;
  assign select_2225 = and_549_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2226;
  assign select_2226 = and_549_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2227;
  assign select_2227 = and_549_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_549_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2229;
  assign select_2229 = and_549_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2230;
  assign select_2230 = and_549_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_549_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2232;
  assign select_2232 = and_549_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2233;
  assign select_2233 = and_549_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2234;
  assign select_2234 = and_549_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2235;
  assign select_2235 = and_549_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2236;
  assign select_2236 = and_549_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2237;
  assign select_2237 = and_549_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2238;
  assign select_2238 = and_549_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2239;
  assign select_2239 = and_549_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2240;
  assign select_2240 = and_549_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2241;
  assign select_2241 = and_549_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2242;
  assign select_2242 = and_549_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2243;
  assign select_2243 = and_549_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2244;
  assign select_2244 = and_549_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2245;
  assign select_2245 = and_549_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2246;
  assign select_2246 = and_549_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2247;
  assign select_2247 = and_549_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2248;
  assign select_2248 = and_549_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2249;
  assign select_2249 = and_549_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2250;
  assign select_2250 = and_549_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2251;
  assign select_2251 = and_549_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2252;
  assign select_2252 = and_549_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2253;
  assign select_2253 = and_549_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2254;
  assign select_2254 = and_549_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2255;
  assign select_2255 = and_549_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2256;
  assign select_2256 = and_549_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:283
  logic [9:0] difference_2258;
  assign difference_2258 = {1'b0, select_559} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2259;
  assign xor_2259 = difference_2258[8:0] ^ {9{difference_2258[9]}};
  logic [9:0] sum_2260;
  assign sum_2260 = {9'h0, difference_2258[9]} + {1'b0, xor_2259};
  logic [9:0] difference_2261;
  assign difference_2261 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2262;
  assign xor_2262 = difference_2261[8:0] ^ {9{difference_2261[9]}};
  logic [9:0] sum_2263;
  assign sum_2263 = {9'h0, difference_2261[9]} + {1'b0, xor_2262};
  logic [9:0] difference_2265;
  assign difference_2265 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2266;
  assign xor_2266 = difference_2265[8:0] ^ {9{difference_2265[9]}};
  logic [9:0] sum_2267;
  assign sum_2267 = {9'h0, difference_2265[9]} + {1'b0, xor_2266};
  logic [10:0] sum_2268;
  assign sum_2268 = ({1'b0, sum_2260} + {1'b0, sum_2263}) + {1'b0, sum_2267};
  logic [9:0] difference_2269;
  assign difference_2269 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2270;
  assign xor_2270 = difference_2269[8:0] ^ {9{difference_2269[9]}};
  logic [9:0] sum_2271;
  assign sum_2271 = {9'h0, difference_2269[9]} + {1'b0, xor_2270};
  logic [9:0] difference_2273;
  assign difference_2273 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2274;
  assign xor_2274 = difference_2273[8:0] ^ {9{difference_2273[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2295;
  assign sum_2295 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2297;
  assign sum_2297 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1142
  logic equal_2298;
  assign equal_2298 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2299;
  assign select_2299 = equal_2298 ? sum_2295 : moments_before_0_q;
  logic [13:0] select_2301;
  assign select_2301 = equal_2298 ? sum_2297 : moments_before_1_q;
  // hls/stages/agreement.hpp:788
  logic select_2304;
  assign select_2304 = equal_574_s2_q ? (moments_has_before_q | equal_2298) : moments_has_before_q;
  logic [13:0] select_2307;
  assign select_2307 = equal_574_s2_q ? ((select_2301 < select_2299) ? select_2299 : select_2301) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2308;
  assign sum_2308 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2311;
  assign select_2311 = equal_574_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2308)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2312;
  assign sum_2312 = {1'b0, sum_2297} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2315;
  assign select_2315 = equal_574_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2312)) : moments_left_alone_q;
  logic select_2318;
  assign select_2318 = equal_574_s2_q ? (~({3'h0, select_2301[13:2]} < sum_2312)) : moments_left_other_stops_q;
  logic select_2321;
  assign select_2321 = equal_574_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2308)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2322;
  assign sum_2322 = {1'b0, sum_2295} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2325;
  assign select_2325 = equal_574_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2322)) : moments_right_alone_q;
  logic select_2328;
  assign select_2328 = equal_574_s2_q ? (~({3'h0, select_2299[13:2]} < sum_2322)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2331;
  assign or_2331 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2339;
  assign and_2339 = not_575_s2_q & (not_577_s2_q & (equal_578_s2_q & (inside_v_s2_q & and_1597)));
  logic and_2343;
  assign and_2343 = not_575_s2_q & (not_577_s2_q & (equal_578_s2_q & (inside_v_s2_q & and_1606)));
  // hls/stages/moments.hpp:94
  logic and_2345;
  assign and_2345 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2348;
  assign select_2348 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2345)) : and_2345;
  // hls/stages/agreement.hpp:788
  logic and_2352;
  assign and_2352 = equal_574_s2_q & (equal_2298 & (cfg_prove_i & (cfg_same_table_i & select_2348)));
  // hls/stages/moments.hpp:95
  logic and_2355;
  assign and_2355 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:368
  logic [9:0] difference_2369;
  assign difference_2369 = {1'b0, select_555} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2369[9]} + (difference_2369[8:0] ^ {9{difference_2369[9]}});
  logic [9:0] difference_2381;
  assign difference_2381 = {1'b0, select_559} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2381[9]} + (difference_2381[8:0] ^ {9{difference_2381[9]}});
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2572;
  assign select_2572 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2573;
  assign select_2573 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2574;
  assign select_2574 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2575;
  assign select_2575 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2576;
  assign select_2576 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2577;
  assign select_2577 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2581;
  assign select_2581 = slot_s2_q[0] ? 8'h0 : sum_1011;
  // hls/stages/agreement.hpp:751
  logic less_2582;
  assign less_2582 = select_2581 < select_1511;
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2584;
  assign select_2584 = slot_s2_q[0] ? 7'h0 : sum_1537;
  // hls/stages/agreement.hpp:788
  logic not_2589;
  assign not_2589 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2590;
  assign less_2590 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_2597;
  assign and_2597 = and_549_s2_q & (equal_679_s2_q & equal_2472_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_2603;
  assign and_2603 = not_575_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2599_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_2623;
  assign and_2623 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2624;
  assign and_2624 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2625;
  assign and_2625 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2626;
  assign and_2626 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2628;
  assign sum_2628 = {1'b0, and_2625} + ({1'b0, explained} + {1'b0, and_2626});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2623} + ({2'h0, and_2624} + {1'b0, sum_2628});
  // hls/stages/agreement.hpp:788
  logic and_2664;
  assign and_2664 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2599_s2_q & and_2020)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2688;
  assign difference_2688 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2691;
  assign less_2691 = {2'h0, difference_2688[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_2694;
  assign and_2694 = not_583_s2_q & (((and_2018_s2_q & and_634) & equal_2684_s2_q) & (~less_2691));
  // hls/stages/agreement.hpp:788
  logic and_2698;
  assign and_2698 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_579_s2_q & and_2694)));
  // hls/stages/agreement.hpp:149
  logic and_2703;
  assign and_2703 = not_583_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2705;
  assign and_2705 = not_583_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2706;
  assign select_2706 = or_579_s2_q ? {and_2705, and_2703} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2708;
  assign select_2708 = less_582_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2709;
  assign select_2709 = or_579_s2_q ? select_2708 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_2711;
  assign and_2711 = and_636 & (select_2706[0] & select_2709[0]);
  // hls/stages/agreement.hpp:788
  logic and_2715;
  assign and_2715 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2706[1] & and_2711)));
  logic and_2716;
  assign and_2716 = not_575_s2_q & and_2715;
  logic and_2722;
  assign and_2722 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2709[1] & and_2711)));
  logic and_2723;
  assign and_2723 = not_575_s2_q & and_2722;
  // hls/stages/registration.hpp:76
  logic less_2726;
  assign less_2726 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2728;
  assign select_2728 = or_579_s2_q ? (less_582_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2730;
  assign select_2730 = or_579_s2_q ? (less_582_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2732;
  assign select_2732 = or_579_s2_q ? (less_582_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2730} - {1'b0, select_2732};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2734;
  assign select_2734 = rise_2[8] ? select_2730 : select_2732;
  logic [8:0] fall;
  assign fall = {1'b0, select_2728} - {1'b0, select_2734};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2737;
  assign not_2737 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2726 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2737};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2739;
  assign xor_2739 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2739};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2745;
  assign select_2745 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2726 ? {taken, 1'b1} : {not_2737, select_2745, not_2737};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2747;
  assign sum_2747 = {left, 1'b1} + {taken_2, less_2726};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2749;
  assign select_2749 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2751;
  assign select_2751 = equal_574_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_2753;
  assign select_2753 = equal_574_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2754;
  assign equal_2754 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_2758;
  assign and_2758 = and_636 & less_1702_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2760;
  assign select_2760 = or_579_s2_q ? (less_582_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2764;
  assign sum_2764 = select_2760[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2767;
  assign select_2767 = (select_2730 < select_2732) ? ({sum_2764, select_2760[0], 5'h0} - {3'h0, select_2749}) : {sum_2764, select_2760[0], select_2749};
  logic [7:0] select_2768;
  assign select_2768 = ((select_2760 == 3'h0) | (select_2760 == 3'h4)) ? {sum_2764, select_2760[0], 5'h0} : select_2767;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2768[7]}}, select_2768} - {sum_1721[9], sum_1721, sum_1717[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2771;
  assign select_2771 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2771[11:7])) ? 12'h7f : select_2771;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2792;
  assign difference_2792 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2794;
  assign and_2794 = and_2758 & ($signed(difference_2792) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2807;
  assign less_2807 = $signed(difference_2792) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_2815;
  assign select_2815 = so_s2_q ? (equal_2754 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2818;
  assign select_2818 = so_s2_q ? (equal_1703 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2823;
  assign select_2823 = (sum_1613 == 2'h2) ? (registration_fresh_q & (~select_1660)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2825;
  assign select_2825 = so_s2_q ? (and_1655 ? select_2823 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2827;
  assign select_2827 = and_2597 ? 4'hf : (equal_574_s2_q ? registration_fresh_q : select_2825);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1610;
  // hls/stages/registration.hpp:258
  logic not_2848;
  assign not_2848 = ~quarter_2[1];
  logic [3:0] select_2849;
  assign select_2849 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2848, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2848};
  // hls/stages/patches.hpp:91
  logic parity_2983;
  assign parity_2983 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2984;
  assign select_2984 = equal_2472_s2_q ? {patches_chance_q[14:0], parity_2983} : patches_chance_q;
  // hls/stages/patches.hpp:346
  logic not_2986;
  assign not_2986 = ~and_1777;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_2988;
  assign select_2988 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2988};
  // hls/stages/agreement.hpp:788
  logic and_2994;
  assign and_2994 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:157
  logic and_2998;
  assign and_2998 = not_2986 & (patches_fixed_q | ((not_575_s2_q & and_2994) & and_1749));
  // hls/stages/patches.hpp:355
  logic not_3011;
  assign not_3011 = ~select_1692[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3013;
  assign select_3013 = sample_pair_whole_s2_q ? (equal_1693 ? select_1692 : {not_3011, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:523
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:185
  logic [51:0] select_3112;
  assign select_3112 = or_1785_s2_q ? {and_1930_s2_q, and_1927_s2_q, and_1911_s2_q, and_1908, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3114;
  assign select_3114 = equal_1779_s2_q ? patches_codes_at_q : (equal_1781_s2_q ? other[55:4] : select_3112);
  // hls/stages/patches.hpp:506
  logic [27:0] word;
  assign word = or_1884_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:522
  logic [27:0] select_3117;
  assign select_3117 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:185
  logic [27:0] select_3119;
  assign select_3119 = equal_1781_s2_q ? (new_row_s2_q ? word : select_3117) : patches_codes_further_q;
  // hls/stages/patches.hpp:524
  logic [55:0] select_3121;
  assign select_3121 = less_1871_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:494
  logic [55:0] select_3123;
  assign select_3123 = less_3122_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:185
  logic [55:0] select_3125;
  assign select_3125 = or_1785_s2_q ? (equal_1784_s2_q ? patches_next_codes_q : select_3123) : patches_next_codes_q;
  logic [55:0] select_3127;
  assign select_3127 = equal_1779_s2_q ? patches_next_codes_q : (equal_1781_s2_q ? select_3121 : select_3125);
  // hls/stages/count_bits.hpp:24
  logic parity_3132;
  assign parity_3132 = ^{and_1930_s2_q, and_1927_s2_q, and_1911_s2_q, and_1908};
  // hls/stages/count_bits.hpp:25
  logic or_3136;
  assign or_3136 = ({and_1911_s2_q, and_1908} == 2'h3) | (and_1927_s2_q & (and_1911_s2_q | and_1908));
  logic and_3137;
  assign and_3137 = and_1930_s2_q & (^{and_1927_s2_q, and_1911_s2_q, and_1908});
  // hls/stages/count_bits.hpp:24
  logic xor_3138;
  assign xor_3138 = or_3136 ^ and_3137;
  // hls/stages/count_bits.hpp:27
  logic and_3139;
  assign and_3139 = or_3136 & and_3137;
  // hls/stages/patches.hpp:185
  logic [2:0] select_3141;
  assign select_3141 = or_1785_s2_q ? (and_1953_s2_q ? {and_3139, xor_3138, parity_3132} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3145;
  assign sum_3145 = {7'h0, patches_set_q} + (equal_1784_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:523
  logic [47:0] select_3155;
  assign select_3155 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:185
  logic [47:0] select_3157;
  assign select_3157 = equal_1779_s2_q ? patches_left_row_q : (equal_1781_s2_q ? select_3155 : patches_left_row_q);
  // hls/stages/patches.hpp:525
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3155;
  // hls/stages/count_bits.hpp:24
  logic xor_3161;
  assign xor_3161 = bits[17] ^ (^{select_3155[16:15], other[16:15]});
  logic xor_3164;
  assign xor_3164 = bits[11] ^ (^{select_3155[10:9], other[10:9]});
  logic xor_3167;
  assign xor_3167 = bits[14] ^ (^{select_3155[13:12], other[13:12]});
  logic xor_3170;
  assign xor_3170 = xor_3161 ^ (^{select_3155[14:9], other[14:9]});
  logic xor_3173;
  assign xor_3173 = bits[47] ^ (^{select_3155[46:45], other[46:45]});
  logic xor_3176;
  assign xor_3176 = bits[8] ^ (^{select_3155[7:6], other[7:6]});
  logic xor_3179;
  assign xor_3179 = bits[2] ^ (^{select_3155[1:0], other[1:0]});
  logic xor_3182;
  assign xor_3182 = bits[5] ^ (^{select_3155[4:3], other[4:3]});
  logic xor_3185;
  assign xor_3185 = xor_3176 ^ (^{select_3155[5:0], other[5:0]});
  logic parity_3187;
  assign parity_3187 = ^{select_3155[47:45], select_3155[8:0], other[47:45], other[8:0]};
  logic xor_3188;
  assign xor_3188 = xor_3170 ^ parity_3187;
  logic xor_3191;
  assign xor_3191 = bits[44] ^ (^{select_3155[43:42], other[43:42]});
  logic xor_3194;
  assign xor_3194 = bits[38] ^ (^{select_3155[37:36], other[37:36]});
  logic xor_3197;
  assign xor_3197 = bits[41] ^ (^{select_3155[40:39], other[40:39]});
  logic xor_3203;
  assign xor_3203 = bits[26] ^ (^{select_3155[25:24], other[25:24]});
  logic xor_3206;
  assign xor_3206 = bits[20] ^ (^{select_3155[19:18], other[19:18]});
  logic xor_3209;
  assign xor_3209 = bits[23] ^ (^{select_3155[22:21], other[22:21]});
  logic xor_3212;
  assign xor_3212 = xor_3203 ^ (^{select_3155[23:18], other[23:18]});
  logic xor_3215;
  assign xor_3215 = bits[35] ^ (^{select_3155[34:33], other[34:33]});
  logic xor_3218;
  assign xor_3218 = bits[29] ^ (^{select_3155[28:27], other[28:27]});
  logic xor_3221;
  assign xor_3221 = bits[32] ^ (^{select_3155[31:30], other[31:30]});
  logic xor_3224;
  assign xor_3224 = xor_3215 ^ (^{select_3155[32:27], other[32:27]});
  logic xor_3225;
  assign xor_3225 = xor_3212 ^ xor_3224;
  // hls/stages/count_bits.hpp:25
  logic or_3233;
  assign or_3233 = (xor_3164 & xor_3167) | (xor_3161 & (xor_3164 | xor_3167));
  logic or_3237;
  assign or_3237 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3241;
  assign or_3241 = (xor_3179 & xor_3182) | (xor_3176 & (xor_3179 | xor_3182));
  // hls/stages/count_bits.hpp:23
  logic or_3248;
  assign or_3248 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3252;
  assign or_3252 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3256;
  assign or_3256 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3259;
  assign parity_3259 = ^{or_3256, or_3252, or_3248};
  // hls/stages/count_bits.hpp:23
  logic or_3263;
  assign or_3263 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3267;
  assign or_3267 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3271;
  assign or_3271 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3274;
  assign parity_3274 = ^{or_3271, or_3267, or_3263};
  logic parity_3277;
  assign parity_3277 = ^{or_3271, or_3267, or_3263, or_3256, or_3252, or_3248, or_3241, or_3237, or_3233};
  // hls/stages/count_bits.hpp:23
  logic or_3281;
  assign or_3281 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3285;
  assign or_3285 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3289;
  assign or_3289 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3297;
  assign or_3297 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3301;
  assign or_3301 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3305;
  assign or_3305 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3308;
  assign parity_3308 = ^{or_3305, or_3301, or_3297};
  // hls/stages/count_bits.hpp:23
  logic or_3312;
  assign or_3312 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3316;
  assign or_3316 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3320;
  assign or_3320 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3323;
  assign parity_3323 = ^{or_3320, or_3316, or_3312};
  logic parity_3326;
  assign parity_3326 = ^{or_3320, or_3316, or_3312, or_3305, or_3301, or_3297, or_3289, or_3285, or_3281};
  // hls/stages/count_bits.hpp:25
  logic or_3330;
  assign or_3330 = (xor_3194 & xor_3197) | (xor_3191 & (xor_3194 | xor_3197));
  logic or_3334;
  assign or_3334 = (xor_3206 & xor_3209) | (xor_3203 & (xor_3206 | xor_3209));
  logic or_3338;
  assign or_3338 = (xor_3218 & xor_3221) | (xor_3215 & (xor_3218 | xor_3221));
  // hls/stages/count_bits.hpp:24
  logic parity_3341;
  assign parity_3341 = ^{or_3338, or_3334, or_3330};
  // hls/stages/count_bits.hpp:25
  logic and_3342;
  assign and_3342 = xor_3188 & (^{xor_3225, select_3155[44:36], other[44:36]});
  logic or_3346;
  assign or_3346 = (xor_3173 & xor_3185) | (xor_3170 & (xor_3173 | xor_3185));
  logic and_3349;
  assign and_3349 = (xor_3191 ^ (^{select_3155[41:36], other[41:36]})) & (xor_3212 | xor_3224);
  logic or_3350;
  assign or_3350 = (xor_3212 & xor_3224) | and_3349;
  // hls/stages/count_bits.hpp:24
  logic parity_3353;
  assign parity_3353 = ^{or_3350, or_3346, and_3342};
  logic parity_3356;
  assign parity_3356 = ^{or_3350, or_3346, and_3342, or_3338, or_3334, or_3330, or_3320, or_3316, or_3312, or_3305, or_3301, or_3297, or_3289, or_3285, or_3281};
  logic parity_3358;
  assign parity_3358 = ^{or_3350, or_3346, and_3342, or_3338, or_3334, or_3330, or_3320, or_3316, or_3312, or_3305, or_3301, or_3297, or_3289, or_3285, or_3281, or_3271, or_3267, or_3263, or_3256, or_3252, or_3248, or_3241, or_3237, or_3233};
  // hls/stages/count_bits.hpp:25
  logic and_3359;
  assign and_3359 = parity_3277 & parity_3356;
  logic or_3363;
  assign or_3363 = (parity_3259 & parity_3274) | ((^{or_3241, or_3237, or_3233}) & (parity_3259 | parity_3274));
  logic or_3367;
  assign or_3367 = (parity_3341 & parity_3353) | (parity_3326 & (parity_3341 | parity_3353));
  logic or_3374;
  assign or_3374 = (parity_3308 & parity_3323) | ((^{or_3289, or_3285, or_3281}) & (parity_3308 | parity_3323));
  logic or_3378;
  assign or_3378 = (or_3334 & or_3338) | (or_3330 & (or_3334 | or_3338));
  logic or_3382;
  assign or_3382 = (or_3346 & or_3350) | (and_3342 & (or_3346 | or_3350));
  // hls/stages/count_bits.hpp:23
  logic or_3389;
  assign or_3389 = (or_3285 & or_3289) | (or_3281 & (or_3285 | or_3289));
  // hls/stages/count_bits.hpp:25
  logic or_3393;
  assign or_3393 = (or_3301 & or_3305) | (or_3297 & (or_3301 | or_3305));
  logic or_3397;
  assign or_3397 = (or_3316 & or_3320) | (or_3312 & (or_3316 | or_3320));
  // hls/stages/count_bits.hpp:24
  logic parity_3400;
  assign parity_3400 = ^{or_3397, or_3393, or_3389};
  // hls/stages/count_bits.hpp:23
  logic or_3404;
  assign or_3404 = (or_3237 & or_3241) | (or_3233 & (or_3237 | or_3241));
  // hls/stages/count_bits.hpp:25
  logic or_3408;
  assign or_3408 = (or_3252 & or_3256) | (or_3248 & (or_3252 | or_3256));
  logic or_3412;
  assign or_3412 = (or_3267 & or_3271) | (or_3263 & (or_3267 | or_3271));
  // hls/stages/count_bits.hpp:24
  logic parity_3415;
  assign parity_3415 = ^{or_3412, or_3408, or_3404};
  logic parity_3418;
  assign parity_3418 = ^{or_3412, or_3408, or_3404, or_3397, or_3393, or_3389, or_3382, or_3378, or_3374};
  logic parity_3420;
  assign parity_3420 = ^{or_3412, or_3408, or_3404, or_3397, or_3393, or_3389, or_3382, or_3378, or_3374, or_3367, or_3363, and_3359};
  // hls/stages/count_bits.hpp:25
  logic or_3424;
  assign or_3424 = (or_3378 & or_3382) | (or_3374 & (or_3378 | or_3382));
  logic or_3428;
  assign or_3428 = (or_3393 & or_3397) | (or_3389 & (or_3393 | or_3397));
  logic or_3432;
  assign or_3432 = (or_3408 & or_3412) | (or_3404 & (or_3408 | or_3412));
  // hls/stages/count_bits.hpp:24
  logic parity_3435;
  assign parity_3435 = ^{or_3432, or_3428, or_3424};
  // hls/stages/count_bits.hpp:25
  logic and_3436;
  assign and_3436 = (^{or_3367, or_3363, and_3359}) & parity_3418;
  logic or_3440;
  assign or_3440 = (or_3363 & or_3367) | (and_3359 & (or_3363 | or_3367));
  logic or_3444;
  assign or_3444 = (parity_3400 & parity_3415) | ((^{or_3382, or_3378, or_3374}) & (parity_3400 | parity_3415));
  // hls/stages/count_bits.hpp:24
  logic parity_3447;
  assign parity_3447 = ^{or_3444, or_3440, and_3436};
  // hls/stages/count_bits.hpp:25
  logic and_3449;
  assign and_3449 = parity_3435 & parity_3447;
  logic or_3453;
  assign or_3453 = (or_3428 & or_3432) | (or_3424 & (or_3428 | or_3432));
  logic or_3457;
  assign or_3457 = (or_3440 & or_3444) | (and_3436 & (or_3440 | or_3444));
  // hls/stages/patches.hpp:185
  logic [4:0] select_3502;
  assign select_3502 = equal_1781_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3505;
  assign select_3505 = equal_1779_s2_q ? patches_summed_first_q : (equal_1781_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:557
  logic [9:0] select_3512;
  assign select_3512 = less_1959_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3515;
  assign select_3515 = equal_1962_s2_q ? (less_1959_s2_q ? (equal_1962_s2_q ? 10'h0 : select_3512) : 10'h0) : select_3512;
  logic [9:0] select_3517;
  assign select_3517 = less_1959_s2_q ? (equal_1960_s2_q ? 10'h0 : select_3515) : select_3515;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3519;
  assign select_3519 = less_1959_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3522;
  assign select_3522 = equal_1962_s2_q ? (less_1959_s2_q ? (equal_1962_s2_q ? 5'h0 : select_3519) : 5'h0) : select_3519;
  logic [4:0] select_3524;
  assign select_3524 = less_1959_s2_q ? (equal_1960_s2_q ? 5'h0 : select_3522) : select_3522;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3526;
  assign select_3526 = less_1959_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3529;
  assign select_3529 = equal_1962_s2_q ? (less_1959_s2_q ? (equal_1962_s2_q ? 5'h0 : select_3526) : 5'h0) : select_3526;
  logic [4:0] select_3531;
  assign select_3531 = less_1959_s2_q ? (equal_1960_s2_q ? 5'h0 : select_3529) : select_3529;
  // hls/stages/patches.hpp:557
  logic and_3534;
  assign and_3534 = less_1959_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:561
  logic select_3537;
  assign select_3537 = equal_1962_s2_q ? (less_1959_s2_q ? (not_1963_s2_q & and_3534) : and_3534) : and_3534;
  // hls/stages/patches.hpp:185
  logic select_3540;
  assign select_3540 = equal_1779_s2_q ? (less_1959_s2_q ? (not_1961_s2_q & select_3537) : select_3537) : patches_read_first_q;
  // hls/stages/patches.hpp:179
  logic or_3551;
  assign or_3551 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3552;
  assign and_3552 = patches_read_searches_s2_q & or_3551;
  // hls/stages/patches.hpp:541
  logic [4:0] select_3553;
  assign select_3553 = and_3552 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:548
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3553};
  // hls/stages/patches.hpp:557
  logic and_3557;
  assign and_3557 = less_1959_s2_q & (equal_3549_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:561
  logic select_3560;
  assign select_3560 = equal_1962_s2_q ? (less_1959_s2_q ? (not_1963_s2_q & and_3557) : and_3557) : and_3557;
  // hls/stages/patches.hpp:185
  logic select_3563;
  assign select_3563 = equal_1779_s2_q ? (less_1959_s2_q ? (not_1961_s2_q & select_3560) : select_3560) : patches_read_above_q;
  // hls/stages/patches.hpp:557
  logic and_3566;
  assign and_3566 = less_1959_s2_q & (equal_3549_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:561
  logic select_3569;
  assign select_3569 = equal_1962_s2_q ? (less_1959_s2_q ? (not_1963_s2_q & and_3566) : and_3566) : and_3566;
  // hls/stages/patches.hpp:185
  logic select_3572;
  assign select_3572 = equal_1779_s2_q ? (less_1959_s2_q ? (not_1961_s2_q & select_3569) : select_3569) : patches_read_below_q;
  // hls/stages/patches.hpp:554
  logic [6:0] sum_3573;
  assign sum_3573 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3576;
  assign select_3576 = (equal_3549_s2_q & ({sum_3573[6], sum_3573} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3577;
  assign select_3577 = less_1959_s2_q ? select_3576 : 10'h3ff;
  // hls/stages/patches.hpp:558
  logic [9:0] select_3579;
  assign select_3579 = less_1959_s2_q ? (equal_1962_s2_q ? 10'h3ff : select_3577) : 10'h3ff;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3580;
  assign select_3580 = equal_1962_s2_q ? select_3579 : select_3577;
  logic [9:0] select_3582;
  assign select_3582 = less_1959_s2_q ? (equal_1960_s2_q ? 10'h3ff : select_3580) : select_3580;
  // hls/stages/patches.hpp:540
  logic [14:0] select_3584;
  assign select_3584 = and_3552 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:185
  logic [9:0] select_3585;
  assign select_3585 = equal_1779_s2_q ? select_3584[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3586;
  assign select_3586 = equal_1779_s2_q ? select_3584[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3588;
  assign select_3588 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3590;
  assign select_3590 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3593;
  assign select_3593 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3594;
  assign select_3594 = patches_read_first_q ? patches_read_far_q : select_3593;
  // hls/stages/patches.hpp:595
  logic [9:0] difference_3597;
  assign difference_3597 = select_3594 - select_3584[9:0];
  // hls/stages/patches.hpp:580
  logic less_3627;
  assign less_3627 = select_3588 < select_3590;
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3628;
  assign sum_3628 = select_3553[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3627 ? select_3590 : select_3588;
  logic [9:0] low;
  assign low = (select_3590 < select_3588) ? select_3590 : select_3588;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3584[9:0];
  // hls/stages/patches.hpp:584
  logic not_3635;
  assign not_3635 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3636;
  assign sum_3636 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3638;
  assign not_3638 = ~({eight, 3'h0} < {1'b0, sum_3636, fall_2[0]});
  logic [1:0] sum_3639;
  assign sum_3639 = {1'b0, not_3635} + {1'b0, not_3638};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3640;
  assign sum_3640 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3642;
  assign not_3642 = ~({eight, 3'h0} < {sum_3640, fall_2[1:0]});
  logic not_3645;
  assign not_3645 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3646;
  assign sum_3646 = {1'b0, not_3642} + {1'b0, not_3645};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3639} + {1'b0, sum_3646};
  // hls/stages/patches.hpp:587
  logic [7:0] select_3649;
  assign select_3649 = less_3627 ? ({sum_3628, select_3553[2:0], 3'h0} - {5'h0, fraction}) : {sum_3628, select_3553[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_3872;
  assign select_3872 = equal_574_s2_q ? shown_shown_q : (so_s2_q ? select_2030 : shown_shown_q);
  logic select_3874;
  assign select_3874 = equal_574_s2_q ? shown_nearer_q : (so_s2_q ? select_2033 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3876;
  assign sum_3876 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3878;
  assign select_3878 = less_3875_s2_q ? (sum_3876[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3880;
  assign select_3880 = equal_2472_s2_q ? (equal_679_s2_q ? 3'h0 : select_3878) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3885;
  assign select_3885 = equal_574_s2_q ? select_1984 : (so_s2_q ? (ends_cell_s2_q ? select_2083 : select_1984) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3899;
  assign select_3899 = equal_679_s2_q ? {{2{difference_3897[6]}}, difference_3897} : (less_3875_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3901;
  assign select_3901 = and_549_s2_q ? (equal_2472_s2_q ? select_3899 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_3903;
  assign select_3903 = equal_679_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_3905;
  assign select_3905 = and_549_s2_q ? (equal_2472_s2_q ? select_3903 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3906;
  assign sum_3906 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3907;
  assign select_3907 = sum_3876[7] ? {1'b1, sum_3876[6:0], region_down_rest_q[0]} : sum_3906;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3876[7];
  // hls/stages/agreement.hpp:460
  logic select_3911;
  assign select_3911 = equal_2472_s2_q ? (equal_679_s2_q | (less_3875_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3916;
  assign or_3916 = segment_starts_q | not_577_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_3919;
  assign select_3919 = inside_v_s2_q ? (sum_1997_s2_q ? (equal_1772 & or_1999) : or_1999) : or_3916;
  // hls/stages/agreement.hpp:788
  logic select_3922;
  assign select_3922 = equal_574_s2_q ? or_3916 : (so_s2_q ? (ends_cell_s2_q ? select_3919 : or_3916) : or_3916);
  // hls/stages/agreement.hpp:1147
  logic equal_3946;
  assign equal_3946 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4082;
  assign select_4082 = so_s2_q ? (ends_cell_s2_q ? and_2071 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4085;
  assign select_4085 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4087;
  assign select_4087 = equal_574_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4085 : centres_values_0_of_skin_q);
  logic select_4088;
  assign select_4088 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4090;
  assign select_4090 = equal_574_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4088 : centres_values_1_textured_q);
  logic select_4091;
  assign select_4091 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4093;
  assign select_4093 = equal_574_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4091 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [10:0] select_4097;
  assign select_4097 = equal_2472_s2_q ? (equal_4094_s2_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [5:0] select_4100;
  assign select_4100 = and_549_s2_q ? (equal_2472_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1271
  logic xor_4101;
  assign xor_4101 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:438
  logic select_4103;
  assign select_4103 = and_1976_s2_q ? (left_first_s2_q ? xor_4101 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:278
  logic select_4105;
  assign select_4105 = and_1976_s2_q ? (left_first_s2_q ? xor_4101 : select_4103) : write_half_q;
  logic select_4107;
  assign select_4107 = left_first_s2_q ? select_2036 : (and_1976_s2_q ? select_2037 : read_half_q);
  logic and_4111;
  assign and_4111 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_4120;
  assign select_4120 = left_first_s2_q ? 10'h1 : (and_1976_s2_q ? select_2041 : rows_passed_q);
  logic [8:0] select_4123;
  assign select_4123 = left_first_s2_q ? {select_2039[7:0], or_2038} : (and_1976_s2_q ? {select_2039[7:0], or_2038} : columns_passed_q);
  logic select_4126;
  assign select_4126 = left_first_s2_q ? marks_last_s2_q : (and_1976_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4129;
  assign select_4129 = left_first_s2_q ? and_2055 : (and_1976_s2_q ? and_2055 : began_q);
  logic [2:0] select_4132;
  assign select_4132 = left_first_s2_q ? select_2057 : (and_1976_s2_q ? select_2057 : seen_x_q);
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4137;
  assign select_4137 = left_first_s2_q ? 3'h0 : (and_2042 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:278
  logic [2:0] select_4139;
  assign select_4139 = left_first_s2_q ? 3'h0 : (and_1976_s2_q ? select_4137 : seen_y_q);
  logic [7:0] select_4142;
  assign select_4142 = left_first_s2_q ? select_2050 : (and_1976_s2_q ? select_2050 : seen_column_q);
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4148;
  assign select_4148 = left_first_s2_q ? select_4146 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:278
  logic [7:0] select_4150;
  assign select_4150 = left_first_s2_q ? select_4146 : (and_1976_s2_q ? select_4148 : seen_rows_left_q);
  // hls/stages/agreement.hpp:436
  logic and_4155;
  assign and_4155 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:278
  logic select_4157;
  assign select_4157 = left_first_s2_q ? and_4155 : (and_1976_s2_q ? and_4155 : at_cell_end_q);
  logic select_4160;
  assign select_4160 = left_first_s2_q ? next_row : (and_1976_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4163;
  assign select_4163 = left_first_s2_q ? 11'h0 : (and_1976_s2_q ? select_2047 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4236;
  assign not_4236 = ~quarter[1];
  logic [3:0] select_4237;
  assign select_4237 = quarter[0] ? {quarter[1], 1'b0, not_4236, 1'b0} : {1'b0, quarter[1], 1'b0, not_4236};

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

  // Memory patches_choices, 64 x 23, DISTANCE 12, hls/stages/patches.hpp:768; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1691;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1693));
`endif
  logic [22:0] patches_choices_rdata_q;
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
  assign regions_raddr = select_1994;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s2_en & (equal_574_s2_q ? (x_s2_q[6] & not_1995) : and_2002);
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
  assign map_raddr = sum_2052;
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s2_en & select_2064;
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
  assign patches_right_codes_waddr = {sum_1892, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1944_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1930_s2_q, and_1927_s2_q, and_1911_s2_q, and_1908, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1948, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1958_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1930_s2_q, and_1927_s2_q, and_1911_s2_q, and_1908, patches_codes_at_q[51:8]};
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
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2029, textured};
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
      averager_running_of_skin_q <= select_2196;
      averager_mask_q <= select_2198;
      averager_of_skin_q <= select_2200;
      census_filled_q <= and_549_s2_q ? {select_682[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2295;
      moments_turned_1_q <= sum_2297;
      moments_before_0_q <= equal_574_s2_q ? select_2299 : moments_before_0_q;
      moments_before_1_q <= equal_574_s2_q ? select_2301 : moments_before_1_q;
      moments_has_before_q <= select_2304;
      moments_most_before_q <= select_2307;
      moments_left_begins_q <= select_2311;
      moments_left_alone_q <= select_2315;
      moments_left_other_stops_q <= select_2318;
      moments_right_begins_q <= select_2321;
      moments_right_alone_q <= select_2325;
      moments_right_other_stops_q <= select_2328;
      moments_out_of_step_q <= or_2331;
      moments_turns_0_q <= and_2339;
      moments_turns_1_q <= and_2343;
      moments_begins_alone_q <= and_2352;
      moments_ends_q <= equal_574_s2_q & (equal_2298 & (not_2353 | and_2355));
      rows_passed_above_q <= and_549_s2_q ? select_681 : rows_passed_above_q;
      chosen_score_q <= less_2582 ? select_1511 : select_2581;
      chosen_near_q <= (select_2584 < select_1546) ? select_1546 : select_2584;
      chosen_place_q <= less_2582 ? {select_1519, not_1518} : 3'h2;
      before_0_q <= select_2581;
      before_1_q <= sum_1261;
      before_2_q <= sum_1509;
      shift_allowed_q <= not_2589 & (~less_2590);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2597 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2716});
      counts_turned_right_q <= and_2597 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2723});
      registration_displacement_over_q <= so_s2_q ? sum_2747[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2749;
      registration_slope_here_q <= select_2751;
      registration_expected_q <= select_2753;
      registration_of_right_q <= equal_574_s2_q ? registration_of_right_q : select_2815;
      registration_was_inside_q <= equal_574_s2_q ? registration_was_inside_q : select_2818;
      registration_fresh_q <= select_2827;
      patches_chance_q <= and_549_s2_q ? select_2984 : patches_chance_q;
      patches_fixed_q <= and_2998;
      patches_choice_valid_q <= and_1777 ? (select_1750 & not_2986) : select_1750;
      patches_choice_column_q <= select_1755;
      patches_choice_shift_q <= select_1760;
      patches_choice_slope_q <= select_1771;
      patches_band_q <= sample_pair_whole_s2_q ? select_1792 : patches_band_q;
      patches_fetch_q <= select_3013;
      patches_codes_at_q <= select_3114;
      patches_codes_further_q <= equal_1779_s2_q ? patches_codes_further_q : select_3119;
      patches_next_codes_q <= select_3127;
      patches_set_q <= equal_1779_s2_q ? 3'h0 : (equal_1781_s2_q ? 3'h0 : select_3141);
      patches_size_q <= sum_3145;
      patches_left_row_q <= select_3157;
      patches_summed_row_column_q <= equal_1779_s2_q ? patches_summed_row_column_q : select_3502;
      patches_summed_first_q <= select_3505;
      patches_read_row_differing_q <= equal_1779_s2_q ? select_3517 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1779_s2_q ? select_3524 : patches_read_row_column_q;
      patches_read_at_q <= equal_1779_s2_q ? select_3531 : patches_read_at_q;
      patches_read_first_q <= select_3540;
      patches_read_above_q <= select_3563;
      patches_read_below_q <= select_3572;
      patches_read_far_q <= equal_1779_s2_q ? select_3582 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3585;
      patches_peak_best_column_q <= select_3586;
      patches_peak_row_q <= equal_1779_s2_q ? select_3553 : patches_peak_row_q;
      patches_peak_above_q <= equal_1779_s2_q ? select_3588 : patches_peak_above_q;
      patches_peak_below_q <= equal_1779_s2_q ? select_3590 : patches_peak_below_q;
      patches_peak_far_q <= equal_1779_s2_q ? select_3594 : patches_peak_far_q;
      patches_frame_ended_q <= equal_574_s2_q & equal_2298;
      shown_shown_q <= select_3872;
      shown_nearer_q <= select_3874;
      region_row_q <= and_549_s2_q ? select_3880 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3885;
      region_down_rest_q <= select_3901;
      region_down_back_q <= select_3905;
      region_down_next_q <= select_3907;
      region_fresh_q <= and_549_s2_q ? select_3911 : region_fresh_q;
      segment_starts_q <= select_3922;
      centres_values_0_textured_q <= equal_574_s2_q ? centres_values_0_textured_q : select_4082;
      centres_values_0_of_skin_q <= select_4087;
      centres_values_1_textured_q <= select_4090;
      centres_values_1_of_skin_q <= select_4093;
      map_row_q <= and_549_s2_q ? select_4097 : map_row_q;
      map_width_q <= select_4100;
      write_half_q <= select_4105;
      read_half_q <= and_1976_s2_q ? select_4107 : read_half_q;
      done_q <= and_1976_s2_q ? (not_2053 & and_4111) : and_4111;
      drew_q <= so_s2_q;
      said_q <= equal_574_s2_q & equal_3946;
      rows_passed_q <= and_1976_s2_q ? select_4120 : rows_passed_q;
      columns_passed_q <= and_1976_s2_q ? select_4123 : columns_passed_q;
      line_ended_q <= and_1976_s2_q ? select_4126 : line_ended_q;
      began_q <= and_1976_s2_q ? select_4129 : began_q;
      seen_x_q <= and_1976_s2_q ? select_4132 : seen_x_q;
      seen_y_q <= and_1976_s2_q ? select_4139 : seen_y_q;
      seen_column_q <= and_1976_s2_q ? select_4142 : seen_column_q;
      seen_rows_left_q <= and_1976_s2_q ? select_4150 : seen_rows_left_q;
      at_cell_end_q <= and_1976_s2_q ? select_4157 : at_cell_end_q;
      was_next_row_q <= and_1976_s2_q ? select_4160 : was_next_row_q;
      seen_base_q <= and_1976_s2_q ? select_4163 : seen_base_q;
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
      left_pixel_q <= and_1976_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_527 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_533 : averager_running_1_q;
      averager_total_0_q <= select_2174;
      averager_total_1_q <= select_2176;
      census_columns_values_0_cell_0_left_q <= select_2201;
      census_columns_values_0_cell_0_right_q <= select_2202;
      census_columns_values_0_cell_0_mask_q <= and_549_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2204;
      census_columns_values_0_cell_1_right_q <= select_2205;
      census_columns_values_0_cell_1_mask_q <= select_2206;
      census_columns_values_0_cell_2_left_q <= select_2207;
      census_columns_values_0_cell_2_right_q <= select_2208;
      census_columns_values_0_cell_2_mask_q <= select_2209;
      census_columns_values_0_cell_2_of_skin_q <= select_2210;
      census_columns_values_0_cell_3_left_q <= select_2211;
      census_columns_values_0_cell_3_right_q <= select_2212;
      census_columns_values_0_cell_3_mask_q <= select_2213;
      census_columns_values_0_cell_4_left_q <= select_2214;
      census_columns_values_0_cell_4_right_q <= select_2215;
      census_columns_values_0_cell_4_mask_q <= select_2216;
      census_columns_values_1_cell_0_left_q <= select_2217;
      census_columns_values_1_cell_0_right_q <= select_2218;
      census_columns_values_1_cell_0_mask_q <= select_2219;
      census_columns_values_1_cell_1_left_q <= select_2220;
      census_columns_values_1_cell_1_right_q <= select_2221;
      census_columns_values_1_cell_1_mask_q <= select_2222;
      census_columns_values_1_cell_2_left_q <= select_2223;
      census_columns_values_1_cell_2_right_q <= select_2224;
      census_columns_values_1_cell_2_mask_q <= select_2225;
      census_columns_values_1_cell_2_of_skin_q <= select_2226;
      census_columns_values_1_cell_3_left_q <= select_2227;
      census_columns_values_1_cell_3_right_q <= select_2228;
      census_columns_values_1_cell_3_mask_q <= select_2229;
      census_columns_values_1_cell_4_left_q <= select_2230;
      census_columns_values_1_cell_4_right_q <= select_2231;
      census_columns_values_1_cell_4_mask_q <= select_2232;
      census_columns_values_2_cell_0_left_q <= select_2233;
      census_columns_values_2_cell_0_right_q <= select_2234;
      census_columns_values_2_cell_0_mask_q <= select_2235;
      census_columns_values_2_cell_1_left_q <= select_2236;
      census_columns_values_2_cell_1_right_q <= select_2237;
      census_columns_values_2_cell_1_mask_q <= select_2238;
      census_columns_values_2_cell_2_left_q <= select_2239;
      census_columns_values_2_cell_2_right_q <= select_2240;
      census_columns_values_2_cell_2_mask_q <= select_2241;
      census_columns_values_2_cell_3_left_q <= select_2242;
      census_columns_values_2_cell_3_right_q <= select_2243;
      census_columns_values_2_cell_3_mask_q <= select_2244;
      census_columns_values_2_cell_4_left_q <= select_2245;
      census_columns_values_2_cell_4_right_q <= select_2246;
      census_columns_values_2_cell_4_mask_q <= select_2247;
      census_columns_values_3_cell_0_mask_q <= select_2248;
      census_columns_values_3_cell_1_left_q <= select_2249;
      census_columns_values_3_cell_1_right_q <= select_2250;
      census_columns_values_3_cell_1_mask_q <= select_2251;
      census_columns_values_3_cell_2_mask_q <= select_2252;
      census_columns_values_3_cell_3_left_q <= select_2253;
      census_columns_values_3_cell_3_right_q <= select_2254;
      census_columns_values_3_cell_3_mask_q <= select_2255;
      census_columns_values_3_cell_4_mask_q <= select_2256;
      sharpness_last_mean_0_q <= and_549_s2_q ? select_555 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_549_s2_q ? select_559 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_s2_q;
      middle_sum_columns_values_1_q <= select_2572;
      middle_sum_columns_values_2_q <= select_2573;
      middle_sum_columns_values_3_q <= select_2574;
      middle_sum_columns_values_4_q <= select_2575;
      middle_sum_columns_values_5_q <= select_2576;
      middle_sum_columns_values_6_q <= select_2577;
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
  logic [3:0] select_1855_s3_q;
  logic less_1959_s3_q;
  logic equal_1960_s3_q;
  logic not_1961_s3_q;
  logic equal_1962_s3_q;
  logic and_1976_s3_q;
  logic select_1978_s3_q;
  logic and_1981_s3_q;
  logic or_1987_s3_q;
  logic or_1990_s3_q;
  logic or_1993_s3_q;
  logic not_1995_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2022_s3_q;
  logic and_2027_s3_q;
  logic and_2059_s3_q;
  logic less_2060_s3_q;
  logic [11:0] sum_2068_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2086_s3_q;
  logic or_2089_s3_q;
  logic or_2092_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2142_s3_q;
  logic [11:0] sum_2272_s3_q;
  logic [9:0] sum_2275_s3_q;
  logic equal_2283_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2597_s3_q;
  logic and_2603_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2665_s3_q;
  logic and_2699_s3_q;
  logic and_2757_s3_q;
  logic and_2758_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2794_s3_q;
  logic and_2808_s3_q;
  logic equal_2851_s3_q;
  logic parity_3229_s3_q;
  logic parity_3358_s3_q;
  logic parity_3420_s3_q;
  logic xor_3448_s3_q;
  logic parity_3460_s3_q;
  logic or_3464_s3_q;
  logic equal_3465_s3_q;
  logic [4:0] select_3584_s3_q;
  logic equal_3596_s3_q;
  logic less_3598_s3_q;
  logic less_3599_s3_q;
  logic or_3604_s3_q;
  logic [7:0] select_3649_s3_q;
  logic equal_3946_s3_q;
  logic and_4166_s3_q;
  logic equal_4239_s3_q;
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
      select_1855_s3_q <= select_1855_s2_q;
      less_1959_s3_q <= less_1959_s2_q;
      equal_1960_s3_q <= equal_1960_s2_q;
      not_1961_s3_q <= not_1961_s2_q;
      equal_1962_s3_q <= equal_1962_s2_q;
      and_1976_s3_q <= and_1976_s2_q;
      select_1978_s3_q <= select_1978_s2_q;
      and_1981_s3_q <= and_1981_s2_q;
      or_1987_s3_q <= or_1987;
      or_1990_s3_q <= or_1990;
      or_1993_s3_q <= or_1993;
      not_1995_s3_q <= not_1995;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2022_s3_q <= inside_v_s2_q & (and_2020 & and_1585);
      and_2027_s3_q <= not_575_s2_q & and_2002;
      and_2059_s3_q <= and_2059;
      less_2060_s3_q <= less_2060;
      sum_2068_s3_q <= sum_2068;
      textured_2_s3_q <= textured_2;
      or_2086_s3_q <= or_2086;
      or_2089_s3_q <= select_2083[7] | (~({select_2083[6], select_2083[3:2]} == 3'h0));
      or_2092_s3_q <= select_2083[7] | (~(select_2083[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2142_s3_q <= and_2142;
      sum_2272_s3_q <= {1'b0, sum_2268} + {2'h0, sum_2271};
      sum_2275_s3_q <= {9'h0, difference_2273[9]} + {1'b0, xor_2274};
      equal_2283_s3_q <= equal_2283_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2597_s3_q <= and_2597;
      and_2603_s3_q <= and_2603;
      explained_2_s3_q <= explained_2;
      and_2665_s3_q <= not_575_s2_q & and_2664;
      and_2699_s3_q <= not_575_s2_q & and_2698;
      and_2757_s3_q <= not_575_s2_q & (so_s2_q & (half_ends & equal_2754));
      and_2758_s3_q <= and_2758;
      residual_s3_q <= residual[7:0];
      and_2794_s3_q <= and_2794;
      and_2808_s3_q <= and_2758 & less_2807;
      equal_2851_s3_q <= (registration_fresh_q & select_2849) == 4'h0;
      parity_3229_s3_q <= ^{xor_3225, xor_3188, select_3155[44:36], other[44:36]};
      parity_3358_s3_q <= parity_3358;
      parity_3420_s3_q <= parity_3420;
      xor_3448_s3_q <= parity_3435 ^ parity_3447;
      parity_3460_s3_q <= ^{or_3457, or_3453, and_3449};
      or_3464_s3_q <= (or_3453 & or_3457) | (and_3449 & (or_3453 | or_3457));
      equal_3465_s3_q <= equal_3465_s2_q;
      select_3584_s3_q <= select_3584[14:10];
      equal_3596_s3_q <= select_3553[3:0] == 4'h0;
      less_3598_s3_q <= {difference_3597, 3'h0} < {3'h0, sum_3145};
      less_3599_s3_q <= select_3594 < select_3584[9:0];
      or_3604_s3_q <= (sum_3145 < 10'h39) | ({1'b0, sum_3145[9:1]} < select_3584[9:0]);
      select_3649_s3_q <= select_3649;
      equal_3946_s3_q <= equal_3946;
      and_4166_s3_q <= and_2142 & (sum_2068 == sum_2052);
      equal_4239_s3_q <= (registration_fresh_q & select_4237) == 4'h0;
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
  // hls/stages/patches.hpp:354
  logic [22:0] select_1795;
  assign select_1795 = and_1794_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1750_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1797;
  assign select_1797 = equal_1693_s3_q ? patches_place_0_valid_q : (select_1692_s3_q ? patches_place_0_valid_q : select_1795[0]);
  // hls/stages/patches.hpp:132
  logic [7:0] sum_1798;
  assign sum_1798 = {1'b0, select_511_s3_q, select_509_s3_q[2]} + 8'h3;
  // hls/stages/patches.hpp:355
  logic [21:0] select_1799;
  assign select_1799 = select_1692_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1795[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1800;
  assign select_1800 = equal_1693_s3_q ? patches_place_0_column_q : select_1799[7:0];
  logic [5:0] select_1801;
  assign select_1801 = equal_1693_s3_q ? patches_place_0_shift_q : select_1799[13:8];
  // hls/stages/patches.hpp:325
  logic [7:0] sum_1802;
  assign sum_1802 = select_1800 + {{2{select_1801[5]}}, select_1801};
  // hls/stages/patches.hpp:132
  logic equal_1803;
  assign equal_1803 = {sum_1802, sum_1798[0], select_509_s3_q[1:0]} == {1'b0, sum_1798[7:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1805;
  assign or_1805 = and_1675_s3_q | (select_1797 & equal_1803);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1806;
  assign select_1806 = or_1805 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1816;
  assign select_1816 = or_1805 ? {and_1675_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1818;
  assign and_1818 = select_1815_s3_q & (~select_1816[5]);
  // hls/stages/patches.hpp:127
  logic select_1826;
  assign select_1826 = equal_1693_s3_q ? patches_place_1_valid_q : (select_1692_s3_q ? select_1795[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:355
  logic [21:0] select_1827;
  assign select_1827 = select_1692_s3_q ? select_1795[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1828;
  assign select_1828 = equal_1693_s3_q ? patches_place_1_column_q : select_1827[7:0];
  logic [5:0] select_1829;
  assign select_1829 = equal_1693_s3_q ? patches_place_1_shift_q : select_1827[13:8];
  // hls/stages/patches.hpp:325
  logic [7:0] sum_1830;
  assign sum_1830 = select_1828 + {{2{select_1829[5]}}, select_1829};
  // hls/stages/patches.hpp:132
  logic equal_1831;
  assign equal_1831 = {sum_1830[7], sum_1798, select_509_s3_q[1:0]} == {1'b0, sum_1830[6:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1833;
  assign or_1833 = and_1675_s3_q | (select_1826 & equal_1831);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1834;
  assign select_1834 = or_1833 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1835;
  assign select_1835 = or_1833 ? {and_1675_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1837;
  assign and_1837 = select_1815_s3_q & (~select_1835[5]);
  // hls/stages/patches.hpp:320
  logic [6:0] sum_1844;
  assign sum_1844 = select_1800[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1845;
  assign equal_1845 = {sum_1844[6], select_511_s3_q, select_509_s3_q} == {1'b0, sum_1844[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_1847;
  assign or_1847 = and_1675_s3_q | (select_1797 & equal_1845);
  logic [4:0] select_1848;
  assign select_1848 = or_1847 ? {and_1675_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:320
  logic [6:0] sum_1849;
  assign sum_1849 = select_1828[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1850;
  assign equal_1850 = {sum_1849[6], select_511_s3_q, select_509_s3_q} == {1'b0, sum_1849[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_1853;
  assign select_1853 = (and_1675_s3_q | (select_1826 & equal_1850)) ? {and_1675_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1848[4] ? select_1853[3:0] : select_1848[3:0];
  // hls/stages/agreement.hpp:276
  logic select_1856;
  assign select_1856 = or_1847 ? and_1675_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_1862;
  assign and_1862 = (select_1815_s3_q & (select_1809_s3_q[3] ^ select_1809_s3_q[4])) & ((~select_1848[4]) | (~select_1853[4]));
  // hls/stages/patches.hpp:185
  logic less_1971;
  assign less_1971 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:186
  logic not_1972;
  assign not_1972 = ~less_1971;
  logic [1:0] select_1973;
  assign select_1973 = patches_summed_first_s3_q ? 2'h2 : {less_1971, not_1972};
  logic [12:0] select_1974;
  assign select_1974 = select_1973[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1982;
  assign select_1982 = select_1973[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1981_s3_q, 1'b0, select_1978_s3_q, left_pixel_q};
  logic [14:0] select_1983;
  assign select_1983 = select_1973[1] ? {select_1974[12:8], patches_sums_values_0_q[9:8], select_1974[7:0]} : select_1982;
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2008;
  assign select_2008 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_2009;
  assign sum_2009 = {5'h0, textured_s3_q} + select_2008;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2011;
  assign sum_2011 = {4'h0, sum_2009} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2013;
  assign select_2013 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_2014;
  assign sum_2014 = {5'h0, explained_s3_q} + select_2013;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2016;
  assign sum_2016 = {4'h0, sum_2014} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2023;
  assign select_2023 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:902
  logic [5:0] sum_2024;
  assign sum_2024 = {5'h0, and_2022_s3_q} + select_2023;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2026;
  assign sum_2026 = {4'h0, sum_2024} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2077;
  assign select_2077 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2078;
  assign difference_2078 = {1'b0, textured_2_s3_q} - {1'b0, select_2077};
  logic [4:0] t;
  assign t = {difference_2078[3], difference_2078} + (equal_569_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2081;
  assign equal_2081 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2093;
  assign not_2093 = ~region_row_s3_q[2];
  logic [2:0] select_2094;
  assign select_2094 = region_row_s3_q[1] ? {1'b0, not_2093, 1'b0} : {region_row_s3_q[2], 1'b0, not_2093};
  logic [5:0] select_2095;
  assign select_2095 = region_row_s3_q[0] ? {select_2094[2], 1'b0, select_2094[1], 1'b0, select_2094[0], 1'b0} : {1'b0, select_2094[2], 1'b0, select_2094[1], 1'b0, select_2094[0]};
  logic [11:0] select_2096;
  assign select_2096 = or_2092_s3_q ? {select_2095[5], 1'b0, select_2095[4], 1'b0, select_2095[3], 1'b0, select_2095[2], 1'b0, select_2095[1], 1'b0, select_2095[0], 1'b0} : {1'b0, select_2095[5], 1'b0, select_2095[4], 1'b0, select_2095[3], 1'b0, select_2095[2], 1'b0, select_2095[1], 1'b0, select_2095[0]};
  logic [23:0] select_2097;
  assign select_2097 = or_2089_s3_q ? {select_2096[11], 1'b0, select_2096[10], 1'b0, select_2096[9], 1'b0, select_2096[8], 1'b0, select_2096[7], 1'b0, select_2096[6], 1'b0, select_2096[5], 1'b0, select_2096[4], 1'b0, select_2096[3], 1'b0, select_2096[2], 1'b0, select_2096[1], 1'b0, select_2096[0], 1'b0} : {1'b0, select_2096[11], 1'b0, select_2096[10], 1'b0, select_2096[9], 1'b0, select_2096[8], 1'b0, select_2096[7], 1'b0, select_2096[6], 1'b0, select_2096[5], 1'b0, select_2096[4], 1'b0, select_2096[3], 1'b0, select_2096[2], 1'b0, select_2096[1], 1'b0, select_2096[0]};
  logic [47:0] select_2098;
  assign select_2098 = or_2086_s3_q ? {select_2097[23], 1'b0, select_2097[22], 1'b0, select_2097[21], 1'b0, select_2097[20], 1'b0, select_2097[19], 1'b0, select_2097[18], 1'b0, select_2097[17], 1'b0, select_2097[16], 1'b0, select_2097[15], 1'b0, select_2097[14], 1'b0, select_2097[13], 1'b0, select_2097[12], 1'b0, select_2097[11], 1'b0, select_2097[10], 1'b0, select_2097[9], 1'b0, select_2097[8], 1'b0, select_2097[7], 1'b0, select_2097[6], 1'b0, select_2097[5], 1'b0, select_2097[4], 1'b0, select_2097[3], 1'b0, select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0], 1'b0} : {1'b0, select_2097[23], 1'b0, select_2097[22], 1'b0, select_2097[21], 1'b0, select_2097[20], 1'b0, select_2097[19], 1'b0, select_2097[18], 1'b0, select_2097[17], 1'b0, select_2097[16], 1'b0, select_2097[15], 1'b0, select_2097[14], 1'b0, select_2097[13], 1'b0, select_2097[12], 1'b0, select_2097[11], 1'b0, select_2097[10], 1'b0, select_2097[9], 1'b0, select_2097[8], 1'b0, select_2097[7], 1'b0, select_2097[6], 1'b0, select_2097[5], 1'b0, select_2097[4], 1'b0, select_2097[3], 1'b0, select_2097[2], 1'b0, select_2097[1], 1'b0, select_2097[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2102;
  assign and_2102 = good_known_q & (~((good_q & select_2098) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2111;
  assign select_2111 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2112;
  assign difference_2112 = {1'b0, shown_2_s3_q} - {1'b0, select_2111};
  logic [4:0] around;
  assign around = {difference_2112[3], difference_2112} + (equal_569_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2115;
  assign sum_2115 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2081 ? and_2102 : (~({sum_2115, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2127;
  assign select_2127 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2128;
  assign difference_2128 = {1'b0, near_2_s3_q} - {1'b0, select_2127};
  logic [4:0] n;
  assign n = {difference_2128[3], difference_2128} + (equal_569_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2132;
  assign and_2132 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2166;
  assign select_2166 = sample_pair_whole_s3_q ? (and_547_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2168;
  assign select_2168 = sample_pair_whole_s3_q ? (and_547_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2170;
  assign select_2170 = sample_pair_whole_s3_q ? (and_547_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2172;
  assign select_2172 = sample_pair_whole_s3_q ? (and_547_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:217
  logic [9:0] sum_2177;
  assign sum_2177 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2178;
  assign difference_2178 = {1'b0, sum_2177[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:218
  logic [9:0] xor_2179;
  assign xor_2179 = {difference_2178[8:0], sum_2177[0]} ^ {10{difference_2178[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2178[9]} + {1'b0, xor_2179};
  // hls/stages/census.hpp:219
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_552_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2184;
  assign select_2184 = sample_pair_whole_s3_q ? (and_547_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:217
  logic [9:0] sum_2185;
  assign sum_2185 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2186;
  assign difference_2186 = {1'b0, sum_2185[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:218
  logic [9:0] xor_2187;
  assign xor_2187 = {difference_2186[8:0], sum_2185[0]} ^ {10{difference_2186[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2186[9]} + {1'b0, xor_2187};
  // hls/stages/census.hpp:219
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_552_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2192;
  assign select_2192 = sample_pair_whole_s3_q ? (and_547_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:283
  logic [11:0] sum_2276;
  assign sum_2276 = sum_2272_s3_q + {2'h0, sum_2275_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2278;
  assign select_2278 = and_549_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2279;
  assign select_2279 = and_549_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2280;
  assign select_2280 = and_549_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2281;
  assign select_2281 = and_549_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:293
  logic [12:0] sum_2284;
  assign sum_2284 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2276};
  logic [13:0] sum_2286;
  assign sum_2286 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2284});
  // hls/stages/census.hpp:320
  logic and_2288;
  assign and_2288 = and_708_s3_q & (9'h4 < sum_2286[13:5]);
  // hls/stages/census.hpp:321
  logic and_2289;
  assign and_2289 = and_708_s3_q & less_732;
  // hls/stages/census.hpp:322
  logic [19:0] sum_2290;
  assign sum_2290 = census_left_misses_q + {{17{and_2289}}, and_2288, 1'b0, and_2288};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2292;
  assign select_2292 = and_549_s3_q ? (equal_2283_s3_q ? 20'h0 : sum_2290) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2362;
  assign select_2362 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2365;
  assign select_2365 = and_549_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:370
  logic and_2368;
  assign and_2368 = whole_2_s3_q & (~(last_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:457
  logic and_2374;
  assign and_2374 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2375;
  assign and_2375 = and_2368 & and_2374;
  // hls/stages/census.hpp:369
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2362[13:0]};
  // hls/stages/census.hpp:371
  logic [12:0] select_2377;
  assign select_2377 = and_2375 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:372
  logic [23:0] select_2379;
  assign select_2379 = equal_2283_s3_q ? {11'h0, select_2377} : (sharpness_sums_detail_0_q + {11'h0, select_2377});
  // hls/stages/agreement.hpp:457
  logic and_2386;
  assign and_2386 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2387;
  assign and_2387 = and_2368 & and_2386;
  // hls/stages/census.hpp:369
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2362[27:14]};
  // hls/stages/census.hpp:371
  logic [12:0] select_2389;
  assign select_2389 = and_2387 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:372
  logic [23:0] select_2391;
  assign select_2391 = equal_2283_s3_q ? {11'h0, select_2389} : (sharpness_sums_detail_1_q + {11'h0, select_2389});
  logic [8:0] select_2394;
  assign select_2394 = and_2375 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2395;
  assign sum_2395 = (equal_2283_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2394};
  logic [8:0] select_2398;
  assign select_2398 = and_2387 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2399;
  assign sum_2399 = (equal_2283_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2398};
  // hls/stages/agreement.hpp:211
  logic equal_2401;
  assign equal_2401 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:385
  logic less_2402;
  assign less_2402 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:424
  logic less_2403;
  assign less_2403 = x_s3_q[4:0] < 5'h3;
  logic not_2404;
  assign not_2404 = ~x_s3_q[1];
  logic [2:0] select_2405;
  assign select_2405 = x_s3_q[0] ? {1'b0, not_2404, 1'b0} : {x_s3_q[1], 1'b0, not_2404};
  logic [5:0] select_2406;
  assign select_2406 = slot_s3_q[2] ? {select_2405[2], 1'b0, select_2405[1], 1'b0, select_2405[0], 1'b0} : {1'b0, select_2405[2], 1'b0, select_2405[1], 1'b0, select_2405[0]};
  logic [11:0] select_2407;
  assign select_2407 = slot_s3_q[1] ? {select_2406[5], 1'b0, select_2406[4], 1'b0, select_2406[3], 1'b0, select_2406[2], 1'b0, select_2406[1], 1'b0, select_2406[0], 1'b0} : {1'b0, select_2406[5], 1'b0, select_2406[4], 1'b0, select_2406[3], 1'b0, select_2406[2], 1'b0, select_2406[1], 1'b0, select_2406[0]};
  logic [23:0] select_2408;
  assign select_2408 = slot_s3_q[0] ? {select_2407[11], 1'b0, select_2407[10], 1'b0, select_2407[9], 1'b0, select_2407[8], 1'b0, select_2407[7], 1'b0, select_2407[6], 1'b0, select_2407[5], 1'b0, select_2407[4], 1'b0, select_2407[3], 1'b0, select_2407[2], 1'b0, select_2407[1], 1'b0, select_2407[0], 1'b0} : {1'b0, select_2407[11], 1'b0, select_2407[10], 1'b0, select_2407[9], 1'b0, select_2407[8], 1'b0, select_2407[7], 1'b0, select_2407[6], 1'b0, select_2407[5], 1'b0, select_2407[4], 1'b0, select_2407[3], 1'b0, select_2407[2], 1'b0, select_2407[1], 1'b0, select_2407[0]};
  // hls/stages/census.hpp:387
  logic and_2412;
  assign and_2412 = less_2403 & (~((sharpness_sums_contrast_1_q & select_2408) == 24'h0));
  // hls/stages/census.hpp:392
  logic [17:0] select_2414;
  assign select_2414 = (less_2402 & and_2412) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2414};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2417;
  assign select_2417 = equal_2401 ? (less_2402 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:387
  logic and_2422;
  assign and_2422 = less_2403 & (~((sharpness_sums_contrast_0_q & select_2408) == 24'h0));
  // hls/stages/census.hpp:392
  logic [17:0] select_2424;
  assign select_2424 = (less_2402 & and_2422) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2424};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2427;
  assign select_2427 = equal_2401 ? (less_2402 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2429;
  assign select_2429 = equal_2401 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2431;
  assign select_2431 = equal_2401 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2433;
  assign select_2433 = equal_2401 ? {sharpness_comparing_contrast_0_q[0], and_2422} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2435;
  assign select_2435 = equal_2401 ? {sharpness_comparing_contrast_1_q[0], and_2412} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2440;
  assign select_2440 = drew_q ? (equal_2401 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:398
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2444;
  assign select_2444 = drew_q ? (equal_2401 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:384
  logic equal_2445;
  assign equal_2445 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:400
  logic xor_2446;
  assign xor_2446 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2449;
  assign select_2449 = (equal_2445 | xor_2446) ? (five_times[0] & xor_2446) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2451;
  assign select_2451 = drew_q ? (equal_2401 ? select_2449 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:400
  logic xor_2452;
  assign xor_2452 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2455;
  assign select_2455 = (equal_2445 | xor_2452) ? (five_times_2[0] & xor_2452) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2457;
  assign select_2457 = drew_q ? (equal_2401 ? select_2455 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:401
  logic xor_2458;
  assign xor_2458 = sharpness_comparing_contrast_0_q[1] ^ and_2412;
  logic select_2461;
  assign select_2461 = (equal_2445 | xor_2458) ? (and_2412 & xor_2458) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2463;
  assign select_2463 = drew_q ? (equal_2401 ? select_2461 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:401
  logic xor_2464;
  assign xor_2464 = sharpness_comparing_contrast_1_q[1] ^ and_2422;
  logic select_2467;
  assign select_2467 = (equal_2445 | xor_2464) ? (and_2422 & xor_2464) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2469;
  assign select_2469 = drew_q ? (equal_2401 ? select_2467 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2605;
  assign select_2605 = and_2597_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2603_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_2608;
  assign and_2608 = not_575_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2613;
  assign and_2613 = not_575_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2618;
  assign and_2618 = not_575_s3_q & (drew_q & (ends_cell_s3_q & and_2022_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_2622;
  assign not_2622 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2631;
  assign select_2631 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2632;
  assign difference_2632 = {1'b0, explained_2_s3_q} - {1'b0, select_2631};
  logic [4:0] e;
  assign e = {difference_2632[3], difference_2632} + (equal_569_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2635;
  assign sum_2635 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_2639;
  assign not_2639 = ~(equal_2081 ? and_2102 : (~({sum_2635, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_2642;
  assign and_2642 = ends_cell_s3_q & (not_2622 & (centres_values_1_textured_s3_q & not_2639));
  logic and_2644;
  assign and_2644 = not_575_s3_q & (drew_q & and_2642);
  // hls/stages/agreement.hpp:1132
  logic less_2647;
  assign less_2647 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2648;
  assign select_2648 = less_2647 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2651;
  assign select_2651 = less_2647 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2652;
  assign sum_2652 = {1'b0, select_2651} + {3'h0, select_2651[9:2]};
  logic and_2654;
  assign and_2654 = (~(select_2648[9:4] == 6'h0)) & ({sum_2652, select_2651[1:0]} < {3'h0, select_2648});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_2657;
  assign select_2657 = x_s3_q[6] ? (equal_1607_s3_q ? 10'h0 : (and_2654 ? select_2648 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2658;
  assign select_2658 = equal_574_s3_q ? select_2657 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2660;
  assign select_2660 = and_2597_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2658});
  logic [13:0] select_2667;
  assign select_2667 = and_2597_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2665_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_2669;
  assign and_2669 = not_2622 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_2672;
  assign and_2672 = not_575_s3_q & (drew_q & (ends_cell_s3_q & and_2669));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2674;
  assign select_2674 = and_2597_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2672});
  // hls/stages/agreement.hpp:1110
  logic and_2676;
  assign and_2676 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2639);
  // hls/stages/agreement.hpp:788
  logic and_2680;
  assign and_2680 = not_575_s3_q & (drew_q & (ends_cell_s3_q & (not_2622 & and_2676)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2682;
  assign select_2682 = and_2597_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2680});
  logic [13:0] select_2701;
  assign select_2701 = and_2597_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2699_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2776;
  assign select_2776 = drew_q ? (equal_1703_s3_q ? (and_2758_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2777;
  assign select_2777 = equal_574_s3_q ? 8'h0 : select_2776;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2779;
  assign select_2779 = and_2757_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2777[7]}}, select_2777});
  // hls/stages/agreement.hpp:788
  logic and_2782;
  assign and_2782 = not_575_s3_q & (drew_q & (and_2758_s3_q & equal_1703_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2784;
  assign select_2784 = and_2757_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2782});
  // hls/stages/registration.hpp:107
  logic and_2786;
  assign and_2786 = and_2758_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2788;
  assign select_2788 = drew_q ? (equal_1703_s3_q ? {and_2786, and_2758_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2789;
  assign select_2789 = equal_574_s3_q ? 2'h0 : select_2788;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2790;
  assign sum_2790 = registration_half_votes_down_q + {{5{select_2789[1]}}, select_2789};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2796;
  assign select_2796 = drew_q ? (equal_1703_s3_q ? {and_2794_s3_q, and_2758_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2797;
  assign select_2797 = equal_574_s3_q ? 2'h0 : select_2796;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2798;
  assign sum_2798 = registration_half_votes_up_q + {{5{select_2797[1]}}, select_2797};
  // hls/stages/registration.hpp:107
  logic and_2801;
  assign and_2801 = and_2758_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2803;
  assign select_2803 = drew_q ? (equal_1703_s3_q ? {and_2801, and_2758_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2804;
  assign select_2804 = equal_574_s3_q ? 2'h0 : select_2803;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2805;
  assign sum_2805 = registration_half_half_votes_down_q + {{5{select_2804[1]}}, select_2804};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2810;
  assign select_2810 = drew_q ? (equal_1703_s3_q ? {and_2808_s3_q, and_2758_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2811;
  assign select_2811 = equal_574_s3_q ? 2'h0 : select_2810;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2812;
  assign sum_2812 = registration_half_half_votes_up_q + {{5{select_2811[1]}}, select_2811};
  // hls/stages/agreement.hpp:788
  logic and_2846;
  assign and_2846 = equal_574_s3_q & (x_s3_q[6] & (not_1995_s3_q & less_1638_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2853;
  assign select_2853 = or_1642_s3_q ? 12'h0 : (equal_2851_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2856;
  assign select_2856 = x_s3_q[6] ? (equal_1607_s3_q ? 12'h0 : (less_1638_s3_q ? select_2853 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2857;
  assign select_2857 = equal_574_s3_q ? select_2856 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2858;
  assign and_2858 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2861;
  assign and_2861 = not_1995_s3_q & (less_1638_s3_q & ({and_2858, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_2863;
  assign and_2863 = equal_574_s3_q & (x_s3_q[6] & and_2861);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2865;
  assign sum_2865 = {{2{select_2857[11]}}, select_2857} + (and_2863 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2868;
  assign select_2868 = or_1642_s3_q ? 12'h0 : (equal_2851_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2871;
  assign select_2871 = x_s3_q[6] ? (equal_1607_s3_q ? 12'h0 : (less_1638_s3_q ? select_2868 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2872;
  assign select_2872 = equal_574_s3_q ? select_2871 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2874;
  assign sum_2874 = {{2{select_2872[11]}}, select_2872} + (and_2863 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2876;
  assign not_2876 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2879;
  assign and_2879 = not_1995_s3_q & (less_1638_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2876, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2885;
  assign and_2885 = equal_574_s3_q & (x_s3_q[6] & (not_1995_s3_q & (less_1638_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2886;
  assign not_2886 = ~and_2885;
  logic less_2887;
  assign less_2887 = $signed({9'h1, {2{not_2886}}, and_2885}) < $signed(registration_up_q[13:2]);
  logic select_2888;
  assign select_2888 = (equal_574_s3_q & (x_s3_q[6] & and_2879)) ? less_2887 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2892;
  assign and_2892 = x_s3_q[6] & (not_1995_s3_q & (less_1638_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2893;
  assign and_2893 = equal_574_s3_q & and_2892;
  // hls/stages/registration.hpp:242
  logic less_2894;
  assign less_2894 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2896;
  assign less_2896 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2898;
  assign equal_2898 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2902;
  assign and_2902 = equal_574_s3_q & (x_s3_q[6] & (not_1995_s3_q & (less_1638_s3_q & equal_2898)));
  // hls/stages/agreement.hpp:1142
  logic and_2909;
  assign and_2909 = x_s3_q[6] & (not_1995_s3_q & (less_1638_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2912;
  assign equal_2912 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2915;
  assign and_2915 = not_1995_s3_q & (less_1638_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2912));
  // hls/stages/registration.hpp:244
  logic and_2919;
  assign and_2919 = (equal_574_s3_q & (x_s3_q[6] & and_2915)) & (less_2896 | less_2894);
  // hls/stages/agreement.hpp:1142
  logic and_2924;
  assign and_2924 = not_1995_s3_q & (less_1638_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2912)));
  // hls/stages/registration.hpp:244
  logic and_2927;
  assign and_2927 = registration_votes_up_q & registration_other_down_q;
  logic select_2929;
  assign select_2929 = registration_votes_down_q ? (registration_other_up_q | and_2927) : and_2927;
  // hls/stages/registration.hpp:138
  logic and_2931;
  assign and_2931 = (equal_574_s3_q & (x_s3_q[6] & and_2924)) & (registration_other_enough_q & select_2929);
  // hls/stages/registration.hpp:245
  logic or_2934;
  assign or_2934 = registration_moved_q | (registration_enough_q & (and_2919 | and_2931));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3018;
  assign select_3018 = sample_pair_whole_s3_q ? (equal_1693_s3_q ? patches_place_0_slope_q : select_1799[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3023;
  assign select_3023 = sample_pair_whole_s3_q ? (equal_1693_s3_q ? patches_place_1_slope_q : select_1827[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3025;
  assign select_3025 = equal_1693_s3_q ? patches_valid_0_q : (select_1692_s3_q ? patches_valid_0_q : select_1795[0]);
  // hls/stages/agreement.hpp:276
  logic select_3028;
  assign select_3028 = sample_pair_whole_s3_q ? (and_1818 ? (sample_present_s3_q & select_3025) : select_3025) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3030;
  assign select_3030 = equal_1693_s3_q ? patches_valid_1_q : (select_1692_s3_q ? select_1795[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3033;
  assign select_3033 = sample_pair_whole_s3_q ? (and_1837 ? (sample_present_s3_q & select_3030) : select_3030) : patches_valid_1_q;
  logic [5:0] select_3036;
  assign select_3036 = sample_pair_whole_s3_q ? (select_1816[5] ? {1'b1, select_1816[4:0]} : (select_1816 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3039;
  assign select_3039 = sample_pair_whole_s3_q ? (select_1835[5] ? {1'b1, select_1835[4:0]} : (select_1835 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3042;
  assign select_3042 = sample_pair_whole_s3_q ? (select_1848[4] ? {1'b1, select_1848[3:0]} : (select_1848 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3045;
  assign select_3045 = sample_pair_whole_s3_q ? (select_1853[4] ? {1'b1, select_1853[3:0]} : (select_1853 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:526
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3464_s3_q, parity_3460_s3_q, xor_3448_s3_q, parity_3420_s3_q, parity_3358_s3_q, parity_3229_s3_q} + (equal_3465_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:185
  logic [9:0] select_3469;
  assign select_3469 = equal_1779_s3_q ? patches_sums_values_0_q : (equal_1781_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3470;
  assign select_3470 = equal_1781_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3472;
  assign select_3472 = equal_1781_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3474;
  assign select_3474 = equal_1781_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3476;
  assign select_3476 = equal_1781_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3478;
  assign select_3478 = equal_1781_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3480;
  assign select_3480 = equal_1781_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3482;
  assign select_3482 = equal_1781_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3484;
  assign select_3484 = equal_1781_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3486;
  assign select_3486 = equal_1781_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3488;
  assign select_3488 = equal_1781_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3490;
  assign select_3490 = equal_1781_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3492;
  assign select_3492 = equal_1781_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3494;
  assign select_3494 = equal_1781_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3496;
  assign select_3496 = equal_1781_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3498;
  assign select_3498 = equal_1781_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3500;
  assign select_3500 = equal_1781_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:600
  logic or_3605;
  assign or_3605 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_3604_s3_q;
  logic or_3608;
  assign or_3608 = equal_3596_s3_q | (less_3598_s3_q | (less_3599_s3_q | or_3605));
  // hls/stages/patches.hpp:580
  logic not_3609;
  assign not_3609 = ~or_3608;
  // hls/stages/patches.hpp:561
  logic and_3610;
  assign and_3610 = equal_1962_s3_q & not_3609;
  // hls/stages/patches.hpp:185
  logic and_3613;
  assign and_3613 = equal_1779_s3_q & (less_1959_s3_q ? (not_1961_s3_q & and_3610) : and_3610);
  // hls/stages/patches.hpp:658
  logic not_3614;
  assign not_3614 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:561
  logic and_3616;
  assign and_3616 = equal_1962_s3_q & (patches_second_s3_q & not_3609);
  // hls/stages/patches.hpp:185
  logic and_3619;
  assign and_3619 = equal_1779_s3_q & (less_1959_s3_q ? (not_1961_s3_q & and_3616) : and_3616);
  // hls/stages/patches.hpp:658
  logic not_3620;
  assign not_3620 = ~and_3619;
  // hls/stages/patches.hpp:189
  logic and_3622;
  assign and_3622 = and_3613 & (not_3614 & not_3620);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3624;
  assign sum_3624 = {7'h0, and_3622} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:598
  logic [7:0] select_3650;
  assign select_3650 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:597
  logic [5:0] select_3651;
  assign select_3651 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3652;
  assign sum_3652 = {2'h0, select_3584_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_3653;
  assign sum_3653 = {select_3651[5], select_3651} + {{3{sum_3652[3]}}, sum_3652};
  // hls/stages/patches.hpp:598
  logic [17:0] product_3654;
  assign product_3654 = $signed({{10{select_3650[7]}}, select_3650}) * $signed({{8{sum_3653[6]}}, sum_3653, select_3584_s3_q[2:0]});
  // hls/stages/patches.hpp:599
  logic [13:0] difference_3655;
  assign difference_3655 = {{6{select_3649_s3_q[7]}}, select_3649_s3_q} - {product_3654[17], product_3654[17:5]};
  // hls/stages/patches.hpp:605
  logic less_3656;
  assign less_3656 = $signed({{7{difference_3626[6]}}, difference_3626}) < $signed(difference_3655);
  // hls/stages/patches.hpp:561
  logic and_3659;
  assign and_3659 = equal_1962_s3_q & (not_3609 & (~less_3656));
  // hls/stages/patches.hpp:185
  logic and_3662;
  assign and_3662 = equal_1779_s3_q & (less_1959_s3_q ? (not_1961_s3_q & and_3659) : and_3659);
  // hls/stages/patches.hpp:661
  logic and_3663;
  assign and_3663 = and_3662 & and_3622;
  logic [7:0] sum_3664;
  assign sum_3664 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3663};
  // hls/stages/patches.hpp:561
  logic and_3668;
  assign and_3668 = not_3609 & (~($signed(difference_3655) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3669;
  assign and_3669 = equal_1962_s3_q & and_3668;
  // hls/stages/patches.hpp:185
  logic and_3672;
  assign and_3672 = equal_1779_s3_q & (less_1959_s3_q ? (not_1961_s3_q & and_3669) : and_3669);
  // hls/stages/patches.hpp:662
  logic and_3673;
  assign and_3673 = and_3672 & and_3622;
  logic [7:0] sum_3674;
  assign sum_3674 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3673};
  // hls/stages/patches.hpp:189
  logic and_3676;
  assign and_3676 = and_3613 & (and_3619 & not_3614);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3678;
  assign sum_3678 = {7'h0, and_3676} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:661
  logic and_3680;
  assign and_3680 = and_3662 & and_3676;
  logic [7:0] sum_3681;
  assign sum_3681 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3680};
  // hls/stages/patches.hpp:662
  logic and_3683;
  assign and_3683 = and_3672 & and_3676;
  logic [7:0] sum_3684;
  assign sum_3684 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3683};
  // hls/stages/patches.hpp:189
  logic and_3686;
  assign and_3686 = and_3613 & (patches_lower_s3_q & not_3620);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3688;
  assign sum_3688 = {7'h0, and_3686} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:661
  logic and_3690;
  assign and_3690 = and_3662 & and_3686;
  logic [7:0] sum_3691;
  assign sum_3691 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3690};
  // hls/stages/patches.hpp:662
  logic and_3693;
  assign and_3693 = and_3672 & and_3686;
  logic [7:0] sum_3694;
  assign sum_3694 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3693};
  // hls/stages/patches.hpp:189
  logic and_3696;
  assign and_3696 = and_3613 & (patches_lower_s3_q & and_3619);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3698;
  assign sum_3698 = {7'h0, and_3696} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:661
  logic and_3700;
  assign and_3700 = and_3662 & and_3696;
  logic [7:0] sum_3701;
  assign sum_3701 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3700};
  // hls/stages/patches.hpp:662
  logic and_3703;
  assign and_3703 = and_3672 & and_3696;
  logic [7:0] sum_3704;
  assign sum_3704 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3703};
  // hls/stages/agreement.hpp:1223
  logic equal_3705;
  assign equal_3705 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_3706;
  assign less_3706 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3710;
  assign and_3710 = equal_574_s3_q & (x_s3_q[6] & (not_1995_s3_q & (equal_3705 & less_3706)));
  // hls/stages/agreement.hpp:1142
  logic and_3715;
  assign and_3715 = x_s3_q[6] & (not_1995_s3_q & (less_3706 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_3716;
  assign and_3716 = equal_574_s3_q & and_3715;
  // hls/stages/patches.hpp:624
  logic [7:0] or_3718;
  assign or_3718 = (and_3710 ? patches_quarters_0_places_q : 8'h0) | (and_3716 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_3722;
  assign and_3722 = x_s3_q[6] & (not_1995_s3_q & (less_3706 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_3723;
  assign and_3723 = equal_574_s3_q & and_3722;
  // hls/stages/agreement.hpp:1142
  logic and_3729;
  assign and_3729 = x_s3_q[6] & (not_1995_s3_q & (less_3706 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_3730;
  assign and_3730 = equal_574_s3_q & and_3729;
  // hls/stages/patches.hpp:624
  logic [7:0] or_3732;
  assign or_3732 = (or_3718 | (and_3723 ? patches_quarters_2_places_q : 8'h0)) | (and_3730 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:200
  logic select_3736;
  assign select_3736 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_3740;
  assign and_3740 = equal_574_s3_q & (x_s3_q[6] & (not_1995_s3_q & (less_3706 & select_3736)));
  // hls/stages/patches.hpp:625
  logic [7:0] select_3742;
  assign select_3742 = and_3710 ? (and_3740 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3744;
  assign select_3744 = and_3716 ? (and_3740 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3747;
  assign select_3747 = and_3723 ? (and_3740 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3750;
  assign select_3750 = and_3730 ? (and_3740 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:626
  logic [7:0] select_3753;
  assign select_3753 = and_3710 ? (and_3740 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3755;
  assign select_3755 = and_3716 ? (and_3740 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3758;
  assign select_3758 = and_3723 ? (and_3740 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3761;
  assign select_3761 = and_3730 ? (and_3740 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:203
  logic [4:0] sum_3763;
  assign sum_3763 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_3767;
  assign and_3767 = x_s3_q[6] & (not_1995_s3_q & (less_3706 & (sum_3763[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3768;
  assign and_3768 = equal_574_s3_q & and_3767;
  // hls/stages/patches.hpp:621
  logic [7:0] select_3771;
  assign select_3771 = and_3768 ? (patches_word_places_q + (and_3716 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3774;
  assign select_3774 = and_3768 ? (patches_word_up_q + (and_3716 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3777;
  assign select_3777 = and_3768 ? (patches_word_down_q + (and_3716 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:607
  logic [5:0] select_3781;
  assign select_3781 = ($signed(difference_3655[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3655[5:0];
  logic [5:0] select_3782;
  assign select_3782 = ($signed(14'h10) < $signed(difference_3655)) ? 6'h10 : select_3781;
  // hls/stages/patches.hpp:561
  logic [5:0] select_3784;
  assign select_3784 = equal_1962_s3_q ? (or_3608 ? 6'h0 : select_3782) : 6'h0;
  logic [5:0] select_3786;
  assign select_3786 = less_1959_s3_q ? (equal_1960_s3_q ? 6'h0 : select_3784) : select_3784;
  // hls/stages/patches.hpp:664
  logic [5:0] select_3788;
  assign select_3788 = and_3613 ? (equal_1779_s3_q ? select_3786 : 6'h0) : 6'h0;
  logic [11:0] sum_3789;
  assign sum_3789 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3788[5]}}, select_3788};
  // hls/stages/agreement.hpp:788
  logic and_3793;
  assign and_3793 = equal_574_s3_q & (x_s3_q[6] & (not_1995_s3_q & (equal_2898 & less_3706)));
  // hls/stages/agreement.hpp:1142
  logic and_3797;
  assign and_3797 = x_s3_q[6] & (not_1995_s3_q & (less_3706 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3798;
  assign and_3798 = equal_574_s3_q & and_3797;
  // hls/stages/patches.hpp:648
  logic [7:0] select_3800;
  assign select_3800 = and_3793 ? (and_3798 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:650
  logic or_3804;
  assign or_3804 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic or_3807;
  assign or_3807 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:652
  logic [8:0] sum_3808;
  assign sum_3808 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:647
  logic select_3810;
  assign select_3810 = and_3793 ? (and_3798 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:189
  logic and_3813;
  assign and_3813 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:647
  logic [2:0] select_3815;
  assign select_3815 = and_3798 ? {and_3813, patches_found_q[2:1]} : (and_3793 ? {and_3813, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:646
  logic or_3819;
  assign or_3819 = patches_partly_q | (patches_doubted_q & (~and_3798));
  // hls/stages/patches.hpp:647
  logic select_3822;
  assign select_3822 = and_3793 ? (and_3798 ? or_3819 : (and_3793 ? or_3819 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:645
  logic select_3823;
  assign select_3823 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:634
  logic [7:0] select_3827;
  assign select_3827 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:606
  logic [10:0] sum_3829;
  assign sum_3829 = {sum_3653[6], sum_3653, select_3584_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:561
  logic and_3832;
  assign and_3832 = equal_1962_s3_q & (not_3609 & ({{5{sum_3829[10]}}, sum_3829} < 16'h3));
  // hls/stages/patches.hpp:185
  logic and_3835;
  assign and_3835 = equal_1779_s3_q & (less_1959_s3_q ? (not_1961_s3_q & and_3832) : and_3832);
  // hls/stages/patches.hpp:189
  logic and_3836;
  assign and_3836 = and_3613 & and_3835;
  // hls/stages/patches.hpp:665
  logic [7:0] sum_3837;
  assign sum_3837 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3836};
  // hls/stages/patches.hpp:654
  logic [12:0] product_3842;
  assign product_3842 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_3800};
  // hls/stages/patches.hpp:189
  logic and_3844;
  assign and_3844 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_3842[12:5] < patches_on_skin_q);
  logic select_3849;
  assign select_3849 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:635
  logic or_3853;
  assign or_3853 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:636
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:637
  logic select_3860;
  assign select_3860 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:638
  logic and_3866;
  assign and_3866 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3867;
  assign sum_3867 = patches_age_q + {9'h0, and_3866};
  logic [9:0] select_3870;
  assign select_3870 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3867)) : sum_3867;
  // hls/stages/agreement.hpp:1188
  logic or_3927;
  assign or_3927 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_3929;
  assign equal_3929 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_3935;
  assign select_3935 = (equal_3929 & equal_3705) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3938;
  assign sum_3938 = {1'b0, select_2651} + {2'h0, select_2651[9:1]};
  logic select_3941;
  assign select_3941 = (select_2648[9:3] == 7'h0) ? ((~or_3927) & (~select_3935)) : (~({sum_3938, select_2651[0]} < {2'h0, select_2648}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3943;
  assign select_3943 = x_s3_q[6] ? (equal_1607_s3_q ? good_q : {select_3941, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_3948;
  assign select_3948 = equal_574_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3946_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_3949;
  assign equal_3949 = x_s3_q[6:3] == 4'ha;
  logic equal_3951;
  assign equal_3951 = x_s3_q[6:3] == 4'hc;
  logic equal_3952;
  assign equal_3952 = x_s3_q[6:3] == 4'hb;
  logic equal_3953;
  assign equal_3953 = x_s3_q[6:3] == 4'h9;
  logic equal_3954;
  assign equal_3954 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3956;
  assign select_3956 = equal_3953 ? counts_skin_unproven_q : (equal_3954 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3958;
  assign select_3958 = equal_3952 ? counts_regions_bad_q : (equal_3949 ? counts_nearer_q : select_3956);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3951 ? counts_on_skin_q : select_3958;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1230
  logic select_3961;
  assign select_3961 = (equal_3949 & equal_3705) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_3962;
  assign not_3962 = ~hidden_for_q[7];
  logic [7:0] select_3964;
  assign select_3964 = select_3961 ? (hidden_for_q + {7'h0, not_3962}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3966;
  assign select_3966 = equal_574_s3_q ? (equal_3946_s3_q ? select_3964 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3967;
  assign select_3967 = equal_3705 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3969;
  assign select_3969 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3971;
  assign select_3971 = equal_3954 ? cfg_unproven_skin_limit_i : (equal_3929 ? cfg_unproven_limit_i : select_3969);
  logic [7:0] select_3973;
  assign select_3973 = equal_3949 ? cfg_regions_limit_i : (equal_3953 ? cfg_hidden_limit_i : select_3971);
  logic [7:0] limit;
  assign limit = equal_3951 ? cfg_regions_limit_i : (equal_3952 ? {cfg_on_skin_limit_i, 3'h0} : select_3973);
  // hls/stages/agreement.hpp:1231
  logic not_3976;
  assign not_3976 = ~x_s3_q[2];
  logic [3:0] select_3977;
  assign select_3977 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3976, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3976};
  logic [7:0] select_3978;
  assign select_3978 = x_s3_q[0] ? {select_3977[3], 1'b0, select_3977[2], 1'b0, select_3977[1], 1'b0, select_3977[0], 1'b0} : {1'b0, select_3977[3], 1'b0, select_3977[2], 1'b0, select_3977[1], 1'b0, select_3977[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3982;
  assign select_3982 = equal_3953 ? counts_skin_supervised_q : (equal_3954 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3984;
  assign select_3984 = equal_3952 ? counts_skin_textured_q : (equal_3949 ? counts_textured_q : select_3982);
  logic [13:0] of;
  assign of = equal_3951 ? counts_textured_q : select_3984;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3986;
  assign select_3986 = ((limit & select_3978) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3967} + {1'b0, select_3986};
  // hls/stages/agreement.hpp:788
  logic select_3991;
  assign select_3991 = equal_574_s3_q ? (equal_3705 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_3996;
  assign and_3996 = too_much_q & (~(equal_3954 & equal_3705));
  // hls/stages/agreement.hpp:1229
  logic select_4001;
  assign select_4001 = (over[14] & equal_3705) ? (and_3996 | ((equal_3954 | equal_3953) | (x_s3_q[6:3] == 4'hf))) : and_3996;
  // hls/stages/agreement.hpp:1125
  logic and_4006;
  assign and_4006 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_4007;
  assign select_4007 = (equal_3951 & equal_3705) ? and_4006 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4009;
  assign select_4009 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4011;
  assign select_4011 = equal_574_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4009 : box_textured_columns_values_0_q);
  logic [2:0] select_4012;
  assign select_4012 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4014;
  assign select_4014 = equal_574_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4012 : box_textured_columns_values_1_q);
  logic [2:0] select_4015;
  assign select_4015 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4017;
  assign select_4017 = equal_574_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4015 : box_textured_columns_values_2_q);
  logic [2:0] select_4018;
  assign select_4018 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4020;
  assign select_4020 = equal_574_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4018 : box_textured_columns_values_3_q);
  logic [2:0] select_4021;
  assign select_4021 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4023;
  assign select_4023 = equal_574_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4021 : box_textured_columns_values_4_q);
  logic [4:0] select_4025;
  assign select_4025 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4027;
  assign select_4027 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4029;
  assign select_4029 = equal_574_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4027 : box_explained_columns_values_0_q);
  logic [2:0] select_4030;
  assign select_4030 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4032;
  assign select_4032 = equal_574_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4030 : box_explained_columns_values_1_q);
  logic [2:0] select_4033;
  assign select_4033 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4035;
  assign select_4035 = equal_574_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4033 : box_explained_columns_values_2_q);
  logic [2:0] select_4036;
  assign select_4036 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4038;
  assign select_4038 = equal_574_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4036 : box_explained_columns_values_3_q);
  logic [2:0] select_4039;
  assign select_4039 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4041;
  assign select_4041 = equal_574_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4039 : box_explained_columns_values_4_q);
  logic [4:0] select_4043;
  assign select_4043 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4046;
  assign select_4046 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4048;
  assign select_4048 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4050;
  assign select_4050 = equal_574_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4048 : box_shown_columns_values_1_q);
  logic [2:0] select_4051;
  assign select_4051 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4053;
  assign select_4053 = equal_574_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4051 : box_shown_columns_values_2_q);
  logic [2:0] select_4054;
  assign select_4054 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4056;
  assign select_4056 = equal_574_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4054 : box_shown_columns_values_3_q);
  logic [2:0] select_4057;
  assign select_4057 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4059;
  assign select_4059 = equal_574_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4057 : box_shown_columns_values_4_q);
  logic [4:0] select_4061;
  assign select_4061 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4064;
  assign select_4064 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4066;
  assign select_4066 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4068;
  assign select_4068 = equal_574_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4066 : box_nearer_columns_values_1_q);
  logic [2:0] select_4069;
  assign select_4069 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4071;
  assign select_4071 = equal_574_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4069 : box_nearer_columns_values_2_q);
  logic [2:0] select_4072;
  assign select_4072 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4074;
  assign select_4074 = equal_574_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4072 : box_nearer_columns_values_3_q);
  logic [2:0] select_4075;
  assign select_4075 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4077;
  assign select_4077 = equal_574_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4075 : box_nearer_columns_values_4_q);
  logic [4:0] select_4079;
  assign select_4079 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1275
  logic select_4114;
  assign select_4114 = left_first_s3_q ? done_s3_q : proven_q;
  // hls/stages/agreement.hpp:278
  logic select_4116;
  assign select_4116 = left_first_s3_q ? done_s3_q : (and_1976_s3_q ? select_4114 : proven_q);
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4167;
  assign select_4167 = and_4166_s3_q ? {and_2132, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4168;
  assign and_4168 = select_4114 & less_4144;
  // hls/stages/agreement.hpp:438
  logic select_4171;
  assign select_4171 = and_2059_s3_q ? (less_2060_s3_q ? (select_4167[0] & and_4168) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:278
  logic select_4173;
  assign select_4173 = left_first_s3_q ? select_4171 : (and_1976_s3_q ? select_4171 : seen_q);
  logic select_4174;
  assign select_4174 = and_1976_s3_q ? select_4173 : seen_q;
  // hls/stages/agreement.hpp:438
  logic select_4177;
  assign select_4177 = and_2059_s3_q ? (less_2060_s3_q ? (select_4167[1] & and_4168) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:278
  logic select_4179;
  assign select_4179 = left_first_s3_q ? select_4177 : (and_1976_s3_q ? select_4177 : nearer_q);
  logic select_4180;
  assign select_4180 = and_1976_s3_q ? select_4179 : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4187;
  assign or_4187 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1241
  logic not_4195;
  assign not_4195 = ~(or_3927 | not_2353);
  // hls/stages/agreement.hpp:788
  logic and_4199;
  assign and_4199 = equal_574_s3_q & (equal_3946_s3_q & (not_4195 & (select_3935 | select_4001)));
  logic and_4202;
  assign and_4202 = equal_3946_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4206;
  assign or_4206 = select_2451 | (select_2463 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4213;
  assign and_4213 = equal_574_s3_q & (equal_3946_s3_q & (not_4195 & (select_2457 | select_2469)));
  // hls/stages/agreement.hpp:1150
  logic and_4218;
  assign and_4218 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3964 < cfg_hidden_frames_i));
  logic select_4224;
  assign select_4224 = (not_2353 | (select_4007 & not_3839)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4229;
  assign and_4229 = equal_574_s3_q & (equal_3946_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4233;
  assign and_4233 = equal_574_s3_q & (x_s3_q[6] & (not_1995_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4241;
  assign select_4241 = equal_1629_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4239_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4242;
  assign select_4242 = equal_1627_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4241;
  logic [31:0] select_4243;
  assign select_4243 = equal_1625_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4242;
  logic [31:0] select_4244;
  assign select_4244 = equal_1623_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4243;
  logic [31:0] select_4245;
  assign select_4245 = equal_1621_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4244;
  logic [31:0] select_4246;
  assign select_4246 = equal_1619_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4245;
  logic [31:0] select_4247;
  assign select_4247 = equal_1617_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4246;
  logic [31:0] select_4248;
  assign select_4248 = equal_1615_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4247;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4249;
  assign select_4249 = less_2647 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4250;
  assign select_4250 = equal_1607_s3_q ? select_4248 : {2'h0, select_4249, select_2651, select_2648};

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
  assign patches_right_1_waddr = {select_1809_s3_q, select_1834};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1837);
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
  assign patches_left_waddr = {select_1856, select_1855_s3_q, column_4};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1862);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1983;
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
  assign regions_waddr = {region_row_s3_q, or_1993_s3_q, or_1990_s3_q, or_1987_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2027_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2026, sum_2016, sum_2011};
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
  assign map_waddr = sum_2068_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2142_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2132, is_seen};
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
      census_left_misses_q <= select_2292;
      sharpness_before_last_mask_q <= select_2365;
      sharpness_sums_detail_0_q <= and_549_s3_q ? select_2379 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_549_s3_q ? select_2391 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_549_s3_q ? sum_2395 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_549_s3_q ? sum_2399 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2417 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2427 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2429 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2431 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2433 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2435 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2440;
      sharpness_comparing_carry_1_q <= select_2444;
      sharpness_comparing_less_detail_0_q <= select_2451;
      sharpness_comparing_less_detail_1_q <= select_2457;
      sharpness_comparing_less_contrast_0_q <= select_2463;
      sharpness_comparing_less_contrast_1_q <= select_2469;
      counts_supervised_q <= select_2605;
      counts_textured_q <= and_2597_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2608});
      counts_explained_q <= and_2597_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2613});
      counts_nearer_q <= and_2597_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2618});
      counts_unproven_q <= and_2597_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2644});
      counts_regions_bad_q <= select_2660;
      counts_skin_supervised_q <= select_2667;
      counts_skin_textured_q <= select_2674;
      counts_skin_unproven_q <= select_2682;
      counts_on_skin_q <= select_2701;
      registration_half_across_q <= select_2779;
      registration_half_measured_q <= select_2784;
      registration_half_votes_down_q <= and_2757_s3_q ? 7'h0 : sum_2790;
      registration_half_votes_up_q <= and_2757_s3_q ? 7'h0 : sum_2798;
      registration_half_half_votes_down_q <= and_2757_s3_q ? 7'h0 : sum_2805;
      registration_half_half_votes_up_q <= and_2757_s3_q ? 7'h0 : sum_2812;
      registration_down_q <= and_2846 ? sum_2865 : registration_down_q;
      registration_up_q <= and_2846 ? sum_2874 : registration_up_q;
      registration_enough_q <= select_2888;
      registration_votes_down_q <= and_2893 ? less_2894 : registration_votes_down_q;
      registration_votes_up_q <= and_2893 ? less_2896 : registration_votes_up_q;
      registration_other_enough_q <= and_2902 ? select_2888 : registration_other_enough_q;
      registration_other_down_q <= and_2902 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2902 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_574_s3_q & and_2909)) & or_2934;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1797 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1800 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1801 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3018;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1826 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1828 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1829 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3023;
      patches_valid_0_q <= select_3028;
      patches_valid_1_q <= select_3033;
      patches_right_next_0_q <= select_3036;
      patches_right_next_1_q <= select_3039;
      patches_left_next_0_q <= select_3042;
      patches_left_next_1_q <= select_3045;
      patches_sums_values_0_q <= select_3469;
      patches_sums_values_1_q <= equal_1779_s3_q ? patches_sums_values_1_q : select_3470;
      patches_sums_values_2_q <= equal_1779_s3_q ? patches_sums_values_2_q : select_3472;
      patches_sums_values_3_q <= equal_1779_s3_q ? patches_sums_values_3_q : select_3474;
      patches_sums_values_4_q <= equal_1779_s3_q ? patches_sums_values_4_q : select_3476;
      patches_sums_values_5_q <= equal_1779_s3_q ? patches_sums_values_5_q : select_3478;
      patches_sums_values_6_q <= equal_1779_s3_q ? patches_sums_values_6_q : select_3480;
      patches_sums_values_7_q <= equal_1779_s3_q ? patches_sums_values_7_q : select_3482;
      patches_sums_values_8_q <= equal_1779_s3_q ? patches_sums_values_8_q : select_3484;
      patches_sums_values_9_q <= equal_1779_s3_q ? patches_sums_values_9_q : select_3486;
      patches_sums_values_10_q <= equal_1779_s3_q ? patches_sums_values_10_q : select_3488;
      patches_sums_values_11_q <= equal_1779_s3_q ? patches_sums_values_11_q : select_3490;
      patches_sums_values_12_q <= equal_1779_s3_q ? patches_sums_values_12_q : select_3492;
      patches_sums_values_13_q <= equal_1779_s3_q ? patches_sums_values_13_q : select_3494;
      patches_sums_values_14_q <= equal_1779_s3_q ? patches_sums_values_14_q : select_3496;
      patches_sums_values_15_q <= equal_1779_s3_q ? patches_sums_values_15_q : select_3498;
      patches_sums_values_16_q <= equal_1779_s3_q ? patches_sums_values_16_q : select_3500;
      patches_best_differing_q <= select_1983[9:0];
      patches_best_column_q <= select_1983[14:10];
      patches_quarters_0_places_q <= sum_3624;
      patches_quarters_0_up_q <= sum_3664;
      patches_quarters_0_down_q <= sum_3674;
      patches_quarters_1_places_q <= sum_3678;
      patches_quarters_1_up_q <= sum_3681;
      patches_quarters_1_down_q <= sum_3684;
      patches_quarters_2_places_q <= sum_3688;
      patches_quarters_2_up_q <= sum_3691;
      patches_quarters_2_down_q <= sum_3694;
      patches_quarters_3_places_q <= sum_3698;
      patches_quarters_3_up_q <= sum_3701;
      patches_quarters_3_down_q <= sum_3704;
      patches_word_places_q <= or_3732;
      patches_word_up_q <= ((select_3742 | select_3744) | select_3747) | select_3750;
      patches_word_down_q <= ((select_3753 | select_3755) | select_3758) | select_3761;
      patches_sum_places_q <= select_3771;
      patches_sum_up_q <= select_3774;
      patches_sum_down_q <= select_3777;
      patches_across_q <= sum_3789;
      patches_places_q <= select_3800;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3804;
      patches_partly_q <= or_3807;
      patches_clear_limit_q <= sum_3808[8:2];
      patches_complete_q <= select_3810;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3793 ? select_3815 : patches_found_q;
      patches_doubted_q <= select_3822;
      patches_doubted_before_q <= select_3823;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3827;
      patches_on_skin_q <= sum_3837;
      patches_large_q <= not_3839 & and_3844;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3849;
      patches_spoiled_q <= or_3853;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3860;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3870;
      segment_textured_q <= select_2008 + {5'h0, and_2608};
      segment_explained_q <= select_2013 + {5'h0, and_2613};
      segment_nearer_q <= select_2023 + {5'h0, and_2618};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_574_s3_q ? select_3943 : good_q;
      good_known_q <= select_3948;
      hidden_for_q <= select_3966;
      product_q <= equal_574_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3991;
      disagree_q <= equal_574_s3_q ? select_3935 : disagree_q;
      too_much_q <= equal_574_s3_q ? select_4001 : too_much_q;
      hides_q <= equal_574_s3_q ? select_3961 : hides_q;
      overlooks_q <= equal_574_s3_q ? select_4007 : overlooks_q;
      proven_q <= and_1976_s3_q ? select_4116 : proven_q;
      seen_q <= select_4174;
      nearer_q <= select_4180;
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
      averager_quarter_1_0_q <= select_2166;
      averager_quarter_1_1_q <= select_2168;
      averager_quarter_2_0_q <= select_2170;
      averager_quarter_2_1_q <= select_2172;
      averager_detail_0_q <= select_2184;
      averager_detail_1_q <= select_2192;
      census_changes_values_0_left_q <= and_549_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_549_s3_q ? sum_2276 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2278;
      census_changes_values_1_right_q <= select_2279;
      census_changes_values_2_left_q <= select_2280;
      census_changes_values_2_right_q <= select_2281;
      sharpness_last_mask_q <= and_549_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_549_s3_q ? select_2362[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_549_s3_q ? select_2362[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4011;
      box_textured_columns_values_1_q <= select_4014;
      box_textured_columns_values_2_q <= select_4017;
      box_textured_columns_values_3_q <= select_4020;
      box_textured_columns_values_4_q <= select_4023;
      box_textured_sum_sums_values_0_q <= equal_574_s3_q ? box_textured_sum_sums_values_0_q : select_4025;
      box_explained_columns_values_0_q <= select_4029;
      box_explained_columns_values_1_q <= select_4032;
      box_explained_columns_values_2_q <= select_4035;
      box_explained_columns_values_3_q <= select_4038;
      box_explained_columns_values_4_q <= select_4041;
      box_explained_sum_sums_values_0_q <= equal_574_s3_q ? box_explained_sum_sums_values_0_q : select_4043;
      box_shown_columns_values_0_q <= equal_574_s3_q ? box_shown_columns_values_0_q : select_4046;
      box_shown_columns_values_1_q <= select_4050;
      box_shown_columns_values_2_q <= select_4053;
      box_shown_columns_values_3_q <= select_4056;
      box_shown_columns_values_4_q <= select_4059;
      box_shown_sum_sums_values_0_q <= equal_574_s3_q ? box_shown_sum_sums_values_0_q : select_4061;
      box_nearer_columns_values_0_q <= equal_574_s3_q ? box_nearer_columns_values_0_q : select_4064;
      box_nearer_columns_values_1_q <= select_4068;
      box_nearer_columns_values_2_q <= select_4071;
      box_nearer_columns_values_3_q <= select_4074;
      box_nearer_columns_values_4_q <= select_4077;
      box_nearer_sum_sums_values_0_q <= equal_574_s3_q ? box_nearer_sum_sums_values_0_q : select_4079;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4118_s4_q;
  logic or_4181_s4_q;
  logic and_4182_s4_q;
  logic and_4190_s4_q;
  logic and_4193_s4_q;
  logic and_4199_s4_q;
  logic and_4203_s4_q;
  logic and_4209_s4_q;
  logic and_4213_s4_q;
  logic and_4221_s4_q;
  logic and_4226_s4_q;
  logic and_4229_s4_q;
  logic and_4233_s4_q;
  logic [5:0] select_4235_s4_q;
  logic [31:0] select_4252_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4118_s4_q <= said_q;
      or_4181_s4_q <= not_2353 | select_4174;
      and_4182_s4_q <= cfg_prove_i & select_4180;
      and_4190_s4_q <= equal_574_s3_q & (equal_3946_s3_q & (cfg_prove_i & or_4187));
      and_4193_s4_q <= equal_574_s3_q & (equal_3946_s3_q & (cfg_prove_i & or_3927));
      and_4199_s4_q <= and_4199;
      and_4203_s4_q <= equal_574_s3_q & and_4202;
      and_4209_s4_q <= equal_574_s3_q & (equal_3946_s3_q & (not_4195 & or_4206));
      and_4213_s4_q <= and_4213;
      and_4221_s4_q <= equal_574_s3_q & (equal_3946_s3_q & (cfg_prove_i & and_4218));
      and_4226_s4_q <= equal_574_s3_q & (equal_3946_s3_q & select_4224);
      and_4229_s4_q <= and_4229;
      and_4233_s4_q <= and_4233;
      select_4235_s4_q <= equal_574_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4252_s4_q <= equal_574_s3_q ? (x_s3_q[6] ? select_4250 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4181_s4_q;
  assign marks_nearer_o = and_4182_s4_q;
  assign verdict_valid_o = and_4118_s4_q;
  assign verdict_unproven_yet_o = and_4190_s4_q;
  assign verdict_untextured_o = and_4193_s4_q;
  assign verdict_disagree_o = and_4199_s4_q;
  assign verdict_moved_o = and_4203_s4_q;
  assign verdict_unsharp_left_o = and_4209_s4_q;
  assign verdict_unsharp_right_o = and_4213_s4_q;
  assign verdict_hidden_o = and_4221_s4_q;
  assign verdict_overlooked_o = and_4226_s4_q;
  assign verdict_out_of_step_o = and_4229_s4_q;
  assign frame_valid_o = and_4233_s4_q;
  assign frame_index_o = select_4235_s4_q;
  assign frame_word_o = select_4252_s4_q;
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
  assign unused_bits = ^{over[13:0], product_3842[4:0], sum_3808[1:0], sum_3763[1:0], product_3654[4:0], sum_2747[0], difference_2688[1:0], detail_4[1:0], detail_3[1:0], sum_2286[4:0], sum_1717[0], sum_1713[0], sum_731[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
