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
  logic not_2350;
  assign not_2350 = ~cfg_prove_i;
  logic [5:0] sum_2563;
  assign sum_2563 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3622;
  assign difference_3622 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3835;
  assign not_3835 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3893;
  assign difference_3893 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4140;
  assign less_4140 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4141;
  assign sum_4141 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_4142;
  assign select_4142 = less_4140 ? {sum_4141, cfg_height_i[5:3]} : 8'h0;

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
  // hls/stages/census.hpp:42
  logic [2:0] select_508;
  assign select_508 = sample_pair_first_q ? 3'h0 : raster_at_x_q;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [7:0] select_512;
  assign select_512 = select_508[0] ? averager_place_q : (row_starts ? 8'h0 : (averager_place_q + 8'h1));
  // hls/stages/census.hpp:122
  logic or_516;
  assign or_516 = row_starts | (averager_inside_q & (~(averager_place_q == 8'hbc)));
  // hls/stages/census.hpp:124
  logic select_517;
  assign select_517 = select_508[0] ? averager_inside_q : or_516;
  // hls/stages/census.hpp:42
  logic or_518;
  assign or_518 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_520;
  assign and_520 = select_517 & (select_508[0] & or_518);
  // hls/stages/census.hpp:42
  logic [2:0] select_525;
  assign select_525 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [5:0] select_541;
  assign select_541 = sample_pair_first_q ? 6'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] last;
  assign last = sample_pair_whole_q ? select_541 : 6'h0;
  // hls/stages/census.hpp:53
  logic equal_543;
  assign equal_543 = select_508 == 3'h7;
  // hls/stages/census.hpp:58
  logic equal_544;
  assign equal_544 = select_525 == 3'h7;
  // hls/stages/census.hpp:134
  logic and_545;
  assign and_545 = equal_544 & and_520;
  // hls/stages/agreement.hpp:276
  logic and_547;
  assign and_547 = sample_pair_whole_q & (equal_543 & and_545);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_576;
  assign equal_576 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:594
  logic or_577;
  assign or_577 = so | equal_576;
  // hls/stages/agreement.hpp:592
  logic [7:0] sum_578;
  assign sum_578 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_579;
  assign select_579 = run_shift_q[5] ? x_q : sum_578;
  logic less_580;
  assign less_580 = {2'h0, last_q} < select_579;
  // hls/stages/agreement.hpp:226
  logic not_581;
  assign not_581 = ~less_580;
  // hls/stages/agreement.hpp:614
  logic equal_591;
  assign equal_591 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_592;
  assign equal_592 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_593;
  assign and_593 = equal_592 & not_581;
  logic select_595;
  assign select_595 = or_577 ? not_581 : (equal_591 ? not_581 : and_593);
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:796
  logic [6:0] sum_609;
  assign sum_609 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:149
  logic and_614;
  assign and_614 = equal_591 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_609} < select_579))));
  logic select_615;
  assign select_615 = or_577 ? not_581 : and_614;
  // hls/stages/agreement.hpp:821
  logic [5:0] right;
  assign right = sum_578[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:720
  logic not_645;
  assign not_645 = ~or_577;
  // hls/stages/agreement.hpp:149
  logic and_648;
  assign and_648 = not_645 & ((~equal_591) & and_593);
  // hls/stages/census.hpp:42
  logic [5:0] select_675;
  assign select_675 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_675 : 6'h0;
  // hls/stages/patches.hpp:393
  logic not_1671;
  assign not_1671 = ~patches_begins_q;
  // hls/stages/census.hpp:33
  logic not_1674;
  assign not_1674 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:363
  logic and_1675;
  assign and_1675 = patches_capturing_q & not_1674;
  // hls/stages/patches.hpp:365
  logic equal_1676;
  assign equal_1676 = {or_518, select_525} == 4'hc;
  // hls/stages/patches.hpp:312
  logic equal_1678;
  assign equal_1678 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1683;
  assign and_1683 = (not_1671 & (patches_work_q == 3'h0)) & (~(and_1675 | ((~equal_1676) | (~equal_1678))));
  // hls/stages/patches.hpp:535
  logic equal_1774;
  assign equal_1774 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:513
  logic not_1775;
  assign not_1775 = ~equal_1774;
  // hls/stages/patches.hpp:506
  logic equal_1776;
  assign equal_1776 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:459
  logic not_1777;
  assign not_1777 = ~equal_1776;
  // hls/stages/patches.hpp:500
  logic equal_1778;
  assign equal_1778 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1779;
  assign equal_1779 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:535
  logic or_1780;
  assign or_1780 = equal_1778 | equal_1779;
  // hls/stages/patches.hpp:461
  logic not_1781;
  assign not_1781 = ~patches_second_q;
  // hls/stages/patches.hpp:374
  logic [4:0] select_1803;
  assign select_1803 = and_1683 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1804;
  assign select_1804 = row_starts ? select_1803 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1806;
  assign and_1806 = and_1675 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1810;
  assign select_1810 = row_starts ? (and_1683 | (and_1675 & (~and_1806))) : patches_capturing_q;
  // hls/stages/patches.hpp:185
  logic and_1818;
  assign and_1818 = not_1775 & (not_1777 & (or_1780 & (patches_second_q & equal_1779)));
  // hls/stages/patches.hpp:168
  logic not_1834;
  assign not_1834 = ~equal_1779;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1850;
  assign select_1850 = row_starts ? {select_1803[4], select_1803[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:459
  logic and_1860;
  assign and_1860 = not_1775 & (or_1780 & not_1777);
  // hls/stages/agreement.hpp:190
  logic and_1971;
  assign and_1971 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2140;
  assign select_2140 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_508 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2143;
  assign select_2143 = sample_pair_whole_q ? (sample_last_q ? (select_525 + 3'h1) : select_525) : raster_at_y_q;
  logic [5:0] select_2146;
  assign select_2146 = sample_pair_whole_q ? (sample_last_q ? 6'h0 : (select_541 + {5'h0, equal_543})) : raster_at_column_q;
  logic [5:0] select_2149;
  assign select_2149 = sample_pair_whole_q ? (sample_last_q ? (select_675 + {5'h0, equal_544}) : select_675) : raster_at_row_q;
  logic select_2153;
  assign select_2153 = sample_pair_whole_q ? (sample_last_q ? (or_518 & (~raster_final_row_q)) : or_518) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2155;
  assign select_2155 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2159;
  assign select_2159 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [6:0] sum_2468;
  assign sum_2468 = {1'b0, last} + 7'h1;
  logic equal_2469;
  assign equal_2469 = {sum_2468[6], cfg_width_i[8:3]} == {1'b0, sum_2468[5:0]};
  // hls/stages/agreement.hpp:464
  logic and_2470;
  assign and_2470 = and_547 & equal_2469;
  // hls/stages/agreement.hpp:523
  logic select_2473;
  assign select_2473 = (and_2470 | (~ends_cell_q)) ? and_2470 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2473 ? (and_2470 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2477;
  assign select_2477 = select_2473 ? (and_2470 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2480;
  assign select_2480 = select_2473 ? (following_last_shift_q & (~and_2470)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2483;
  assign and_2483 = run_last_shift_q & equal_591;
  // hls/stages/agreement.hpp:616
  logic select_2485;
  assign select_2485 = equal_591 ? (~run_last_shift_q) : equal_592;
  // hls/stages/agreement.hpp:620
  logic equal_2486;
  assign equal_2486 = run_phase_q == 3'h1;
  logic not_2489;
  assign not_2489 = ~select_2485;
  // hls/stages/agreement.hpp:623
  logic equal_2491;
  assign equal_2491 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2492;
  assign and_2492 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2493;
  assign select_2493 = equal_2491 ? 2'h1 : {2{and_2492}};
  logic [2:0] select_2495;
  assign select_2495 = (and_2483 | (select_2485 | equal_2486)) ? (equal_2486 ? 3'h2 : {not_2489, {2{select_2485}}}) : (equal_576 ? 3'h6 : {select_2493[0], select_2493});
  // hls/stages/agreement.hpp:607
  logic and_2498;
  assign and_2498 = select_2485 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2501;
  assign select_2501 = (plan_shift_q[5] & select_2485) ? value : 7'h0;
  logic [1:0] or_2502;
  assign or_2502 = {2{so}} | select_2501[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] select_2503;
  assign select_2503 = select_2485 ? plan_columns_q : 8'h0;
  logic [6:0] or_2506;
  assign or_2506 = select_2503[6:0] | ((equal_2486 | equal_2491) ? whole_q : 7'h0);
  logic [1:0] or_2507;
  assign or_2507 = {2{and_2483}} | or_2506[3:2];
  // hls/stages/agreement.hpp:634
  logic [6:0] or_2509;
  assign or_2509 = {or_2506[6:4], or_2507, or_2506[1:0]} | (equal_576 ? drawn_q : 7'h0);
  logic [4:0] or_2510;
  assign or_2510 = {5{so}} | {or_2509[6], or_2509[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2514;
  assign not_2514 = ~run_shift_q[5];
  logic [6:0] difference_2516;
  assign difference_2516 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2517;
  assign select_2517 = equal_591 ? ({{7{not_2514}}, 1'b1} + run_span_q) : {difference_2516[6], difference_2516};
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2521;
  assign select_2521 = and_2470 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2523;
  assign select_2523 = select_2473 ? {select_2521[6], select_2521} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2526;
  assign select_2526 = select_2473 ? (and_2470 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [5:0] select_2534;
  assign select_2534 = and_547 ? (equal_2469 ? ((5'he < last[5:1]) ? 6'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2535;
  assign sum_2535 = {1'b0, last[5:2]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2537;
  assign select_2537 = and_547 ? (equal_2469 ? {sum_2535, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [4:0] sum_2538;
  assign sum_2538 = {1'b0, last[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2540;
  assign select_2540 = and_547 ? (equal_2469 ? {sum_2538, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2554;
  assign select_2554 = (ends_cell_q | select_2473) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_591 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2558;
  assign and_2558 = (~select_2473) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_2559;
  assign sum_2559 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_2561;
  assign select_2561 = equal_2469 ? ({sum_2559[6], cfg_height_i[8:3]} == {1'b0, sum_2559[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:318
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2937;
  assign select_2937 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2938;
  assign select_2938 = sample_pair_whole_q ? select_2937 : patches_phase_q;
  // hls/stages/patches.hpp:374
  logic and_2939;
  assign and_2939 = not_1674 & equal_1676;
  logic [8:0] select_2940;
  assign select_2940 = and_2939 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2941;
  assign select_2941 = and_2939 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2942;
  assign select_2942 = sample_pair_first_q ? select_2940 : select_2941;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2944;
  assign select_2944 = sample_pair_whole_q ? (row_starts ? select_2942[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2946;
  assign select_2946 = sample_pair_whole_q ? (row_starts ? select_2942[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2949;
  assign select_2949 = sample_pair_whole_q ? (equal_1678 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2951;
  assign select_2951 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1678}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:331
  logic equal_2952;
  assign equal_2952 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:332
  logic not_2953;
  assign not_2953 = ~equal_2952;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2955;
  assign select_2955 = sample_pair_whole_q ? (phase + {not_2953, 1'b1, not_2953, equal_2952}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_2957;
  assign equal_2957 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2961;
  assign select_2961 = equal_2957 ? ((select_2938 == 4'h6) ? 4'h0 : (select_2938 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2962;
  assign equal_2962 = select_2961 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2965;
  assign select_2965 = equal_2469 ? (equal_2962 ? 4'h6 : (select_2961 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2967;
  assign select_2967 = equal_2957 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2969;
  assign select_2969 = equal_2469 ? (select_2967 + {4'h0, equal_2962}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_2974;
  assign select_2974 = and_547 ? (equal_2469 ? ((6'h2 < row) & equal_2962) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2976;
  assign select_2976 = and_547 ? (equal_2469 ? select_2967 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:372
  logic [5:0] sum_2999;
  assign sum_2999 = {1'b0, select_675[5:1]} + 6'h1;
  logic less_3000;
  assign less_3000 = {sum_2999, select_675[0], select_525, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3003;
  assign select_3003 = row_starts ? (and_1683 ? (~less_3000) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:394
  logic or_3042;
  assign or_3042 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:396
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:188
  logic and_3048;
  assign and_3048 = equal_1774 & not_1781;
  // hls/stages/patches.hpp:400
  logic and_3049;
  assign and_3049 = not_1834 & and_3048;
  logic [1:0] select_3051;
  assign select_3051 = equal_1776 ? 2'h0 : (equal_1778 ? 2'h3 : {equal_1779, and_3049});
  // hls/stages/patches.hpp:280
  logic equal_3053;
  assign equal_3053 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:278
  logic not_3054;
  assign not_3054 = ~equal_3053;
  // hls/stages/patches.hpp:280
  logic equal_3055;
  assign equal_3055 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:276
  logic not_3056;
  assign not_3056 = ~equal_3055;
  // hls/stages/patches.hpp:284
  logic not_3058;
  assign not_3058 = ~(patches_following_q == 3'h2);
  logic and_3061;
  assign and_3061 = (~(patches_following_q == 3'h1)) & not_3058;
  // hls/stages/patches.hpp:398
  logic [1:0] select_3062;
  assign select_3062 = equal_3055 ? 2'h2 : {and_3061, not_3058};
  logic [3:0] select_3063;
  assign select_3063 = equal_3053 ? 4'h2 : {select_3062, {2{not_3056}}};
  // hls/stages/patches.hpp:406
  logic not_3066;
  assign not_3066 = ~or_3042;
  // hls/stages/patches.hpp:395
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:407
  logic [11:0] select_3071;
  assign select_3071 = or_3042 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:188
  logic [4:0] select_3073;
  assign select_3073 = or_3042 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

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
  assign fresh_re = s0_en & and_648;
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
  assign left_re = s0_en & select_595;
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
  assign right_codes_raddr = or_577 ? x_q[5:0] : (equal_591 ? sum_578[5:0] : x_q[5:0]);
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s0_en & select_595;
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
  assign best_left_raddr = or_577 ? x_q[5:0] : x[5:0];
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s0_en & select_615;
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
  assign patches_right_0_re = s0_en & (not_1775 & (not_1777 & (or_1780 & (equal_1779 & not_1781))));
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
  assign patches_right_1_re = s0_en & and_1818;
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
  assign patches_left_re = s0_en & (not_1775 & (not_1777 & (not_1834 & or_1780)));
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
  assign patches_columns_above_re = s0_en & and_1860;
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
      left_first_q <= and_1971 ? left_first_q : marks_first_i;
      right_q <= (~and_1971) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1971;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= select_2140;
      raster_at_y_q <= select_2143;
      raster_at_column_q <= select_2146;
      raster_at_row_q <= select_2149;
      raster_at_live_q <= select_2153;
      raster_rows_left_q <= sample_pair_whole_q ? select_2155 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2159;
      averager_place_q <= sample_pair_whole_q ? select_512 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_517 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2477;
      run_last_shift_q <= select_2480;
      run_span_q <= select_2473 ? (and_2470 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2495;
      following_shift_q <= select_2485 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2498;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2501[6], or_2502, select_2501[3:0]};
      following_columns_q <= {select_2503[7], or_2510[4], or_2509[5:4], or_2510[3:0]};
      plan_shift_q <= equal_591 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2517;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2523;
      columns_left_q <= select_2526;
      last_q <= and_547 ? (equal_2469 ? last : last_q) : last_q;
      least_q <= select_2534;
      whole_q <= select_2537;
      drawn_q <= select_2540;
      age_q <= select_2473 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2473 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2554;
      ends_q <= and_2558;
      final_row_q <= and_547 ? select_2561 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2938;
      patches_band_rows_rows_to_next_q <= select_2944;
      patches_band_rows_number_q <= select_2946;
      patches_next_band_rows_to_next_q <= select_2949;
      patches_next_band_number_q <= select_2951;
      patches_first_band_rows_to_next_q <= select_2955;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2952 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_547 ? select_2965 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_547 ? select_2969 : patches_choosing_number_q;
      patches_chooses_q <= select_2974;
      patches_choosing_band_q <= select_2976;
      patches_capturing_q <= sample_pair_whole_q ? select_1810 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3003 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1804 : patches_row_q;
      patches_work_q <= or_3042 ? following : patches_work_q;
      patches_second_q <= not_1671 & (patches_second_q | (patches_ends_q & equal_1774));
      patches_following_q <= equal_1774 ? {2'h0, and_3048} : {equal_1776, select_3051};
      patches_following_beats_q <= {select_3063, not_3054};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_1806);
      patches_ends_q <= not_3066 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3071;
      patches_code_row_q <= select_3073;
      patches_column_q <= or_3042 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3066 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_508_s1_q;
  logic row_starts_s1_q;
  logic [7:0] select_512_s1_q;
  logic and_520_s1_q;
  logic equal_526_s1_q;
  logic [5:0] select_541_s1_q;
  logic [5:0] last_s1_2_q;
  logic and_545_s1_q;
  logic and_547_s1_q;
  logic equal_572_s1_q;
  logic so_s1_q;
  logic equal_576_s1_q;
  logic or_577_s1_q;
  logic less_580_s1_q;
  logic not_581_s1_q;
  logic equal_591_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_615_s1_q;
  logic [5:0] right_s1_q;
  logic and_648_s1_q;
  logic [5:0] row_s1_q;
  logic and_1559_s1_q;
  logic equal_1560_s1_q;
  logic and_1683_s1_q;
  logic equal_1774_s1_q;
  logic not_1775_s1_q;
  logic equal_1776_s1_q;
  logic not_1777_s1_q;
  logic equal_1778_s1_q;
  logic equal_1779_s1_q;
  logic or_1780_s1_q;
  logic [4:0] select_1804_s1_q;
  logic select_1810_s1_q;
  logic [3:0] select_1850_s1_q;
  logic and_1860_s1_q;
  logic equal_2469_s1_q;
  logic and_2470_s1_q;
  logic or_3042_s1_q;
  logic not_3066_s1_q;
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
      select_508_s1_q <= select_508;
      row_starts_s1_q <= row_starts;
      select_512_s1_q <= select_512;
      and_520_s1_q <= and_520;
      equal_526_s1_q <= select_525 == 3'h0;
      select_541_s1_q <= select_541;
      last_s1_2_q <= last;
      and_545_s1_q <= and_545;
      and_547_s1_q <= and_547;
      equal_572_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_576_s1_q <= equal_576;
      or_577_s1_q <= or_577;
      less_580_s1_q <= less_580;
      not_581_s1_q <= not_581;
      equal_591_s1_q <= equal_591;
      x_s1_2_q <= x[6:0];
      select_615_s1_q <= select_615;
      right_s1_q <= right;
      and_648_s1_q <= and_648;
      row_s1_q <= row;
      and_1559_s1_q <= not_645 & and_614;
      equal_1560_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      and_1683_s1_q <= and_1683;
      equal_1774_s1_q <= equal_1774;
      not_1775_s1_q <= not_1775;
      equal_1776_s1_q <= equal_1776;
      not_1777_s1_q <= not_1777;
      equal_1778_s1_q <= equal_1778;
      equal_1779_s1_q <= equal_1779;
      or_1780_s1_q <= or_1780;
      select_1804_s1_q <= select_1804;
      select_1810_s1_q <= select_1810;
      select_1850_s1_q <= select_1850;
      and_1860_s1_q <= and_1860;
      equal_2469_s1_q <= equal_2469;
      and_2470_s1_q <= and_2470;
      or_3042_s1_q <= or_3042;
      not_3066_s1_q <= not_3066;
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
  // hls/stages/census.hpp:127
  logic and_521;
  assign and_521 = sample_pair_whole_s1_q & and_520_s1_q;
  // hls/stages/agreement.hpp:668
  logic equal_566;
  assign equal_566 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_567;
  assign equal_567 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_566 & equal_567;
  // hls/stages/moments.hpp:57
  logic [11:0] select_570;
  assign select_570 = moments_starts_q ? 12'h1 : (moments_place_q + {11'h0, moments_taken_q});
  // hls/stages/agreement.hpp:788
  logic [10:0] select_571;
  assign select_571 = first ? 11'h0 : select_570[10:0];
  // hls/stages/agreement.hpp:1009
  logic not_573;
  assign not_573 = ~equal_572_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_575;
  assign not_575 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_577_s1_q & not_581_s1_q;
  // hls/stages/moments.hpp:63
  logic [11:0] place;
  assign place = first ? 12'h0 : select_570;
  // hls/stages/moments.hpp:104
  logic not_585;
  assign not_585 = ~(12'h66c < place);
  // hls/stages/agreement.hpp:788
  logic and_589;
  assign and_589 = not_573 & (not_575 & (equal_576_s1_q & (inside_v & not_585)));
  // hls/stages/agreement.hpp:975
  logic and_605;
  assign and_605 = (or_577_s1_q & (left_rdata_q[67] & not_581_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:968
  logic [5:0] select_624;
  assign select_624 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:668
  logic not_745;
  assign not_745 = ~equal_566;
  // hls/stages/agreement.hpp:671
  logic and_746;
  assign and_746 = left_rdata_q[12] & not_745;
  logic and_747;
  assign and_747 = left_rdata_q[30] & not_745;
  logic and_748;
  assign and_748 = left_rdata_q[48] & not_745;
  logic and_749;
  assign and_749 = left_rdata_q[66] & not_745;
  // hls/stages/agreement.hpp:672
  logic and_750;
  assign and_750 = right_codes_rdata_q[12] & not_745;
  logic and_751;
  assign and_751 = right_codes_rdata_q[27] & not_745;
  logic and_752;
  assign and_752 = right_codes_rdata_q[42] & not_745;
  logic and_753;
  assign and_753 = right_codes_rdata_q[57] & not_745;
  logic and_754;
  assign and_754 = right_codes_rdata_q[72] & not_745;
  logic and_755;
  assign and_755 = right_codes_rdata_q[85] & not_745;
  // hls/stages/agreement.hpp:221
  logic and_760;
  assign and_760 = left_rdata_q[48] & not_581_s1_q;
  logic and_761;
  assign and_761 = right_codes_rdata_q[42] & not_581_s1_q;
  logic [11:0] select_762;
  assign select_762 = less_580_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_763;
  assign select_763 = less_580_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_767;
  assign select_767 = and_760 ? (and_761 ? (~(select_762 ^ select_763)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_773;
  assign parity_773 = ^select_767[5:3];
  logic parity_776;
  assign parity_776 = ^select_767[8:6];
  logic parity_779;
  assign parity_779 = ^select_767[11:3];
  // hls/stages/agreement.hpp:221
  logic and_783;
  assign and_783 = left_rdata_q[66] & not_581_s1_q;
  logic and_784;
  assign and_784 = right_codes_rdata_q[57] & not_581_s1_q;
  logic [11:0] select_785;
  assign select_785 = less_580_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_786;
  assign select_786 = less_580_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_790;
  assign select_790 = and_783 ? (and_784 ? (~(select_785 ^ select_786)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_793;
  assign parity_793 = ^select_790[8:6];
  logic parity_796;
  assign parity_796 = ^select_790[11:9];
  // hls/stages/agreement.hpp:221
  logic and_800;
  assign and_800 = left_rdata_q[84] & not_581_s1_q;
  logic and_801;
  assign and_801 = right_codes_rdata_q[72] & not_581_s1_q;
  logic [11:0] select_802;
  assign select_802 = less_580_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_803;
  assign select_803 = less_580_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_807;
  assign select_807 = and_800 ? (and_801 ? (~(select_802 ^ select_803)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_813;
  assign parity_813 = ^select_807[2:0];
  logic parity_816;
  assign parity_816 = ^select_807[5:3];
  logic parity_819;
  assign parity_819 = ^select_807[8:0];
  logic parity_825;
  assign parity_825 = ^select_807[11:9];
  logic parity_828;
  assign parity_828 = ^select_790[2:0];
  logic parity_831;
  assign parity_831 = ^{select_807[11:9], select_790[5:0]};
  logic parity_834;
  assign parity_834 = ^{select_807, select_790, select_767[2:0]};
  logic xor_835;
  assign xor_835 = parity_779 ^ parity_834;
  // hls/stages/count_bits.hpp:23
  logic or_839;
  assign or_839 = (select_767[1:0] == 2'h3) | (select_767[2] & (select_767[0] | select_767[1]));
  // hls/stages/count_bits.hpp:25
  logic or_843;
  assign or_843 = (select_790[7:6] == 2'h3) | (select_790[8] & (select_790[6] | select_790[7]));
  logic or_847;
  assign or_847 = (select_790[10:9] == 2'h3) | (select_790[11] & (select_790[9] | select_790[10]));
  // hls/stages/count_bits.hpp:23
  logic or_855;
  assign or_855 = (select_807[7:6] == 2'h3) | (select_807[8] & (~(select_807[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_859;
  assign or_859 = (select_807[1:0] == 2'h3) | (select_807[2] & (select_807[0] | select_807[1]));
  logic or_863;
  assign or_863 = (select_807[4:3] == 2'h3) | (select_807[5] & (select_807[3] | select_807[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_866;
  assign parity_866 = ^{or_863, or_859, or_855};
  // hls/stages/count_bits.hpp:23
  logic or_870;
  assign or_870 = (select_790[4:3] == 2'h3) | (select_790[5] & (select_790[3] | select_790[4]));
  // hls/stages/count_bits.hpp:25
  logic or_874;
  assign or_874 = (select_807[10:9] == 2'h3) | (select_807[11] & (select_807[9] | select_807[10]));
  logic or_878;
  assign or_878 = (select_790[1:0] == 2'h3) | (select_790[2] & (select_790[0] | select_790[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_881;
  assign parity_881 = ^{or_878, or_874, or_870};
  logic parity_884;
  assign parity_884 = ^{or_878, or_874, or_870, or_863, or_859, or_855, or_847, or_843, or_839};
  // hls/stages/count_bits.hpp:25
  logic and_885;
  assign and_885 = parity_779 & parity_834;
  logic or_889;
  assign or_889 = (parity_773 & parity_776) | ((^select_767[11:9]) & (parity_773 | parity_776));
  logic and_892;
  assign and_892 = (^{select_790[11:6], select_767[2:0]}) & (parity_819 | parity_831);
  logic or_893;
  assign or_893 = (parity_819 & parity_831) | and_892;
  // hls/stages/count_bits.hpp:23
  logic or_900;
  assign or_900 = (select_767[10:9] == 2'h3) | (select_767[11] & (select_767[9] | select_767[10]));
  // hls/stages/count_bits.hpp:25
  logic or_904;
  assign or_904 = (select_767[4:3] == 2'h3) | (select_767[5] & (select_767[3] | select_767[4]));
  logic or_908;
  assign or_908 = (select_767[7:6] == 2'h3) | (select_767[8] & (select_767[6] | select_767[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_911;
  assign parity_911 = ^{or_908, or_904, or_900};
  // hls/stages/count_bits.hpp:25
  logic or_915;
  assign or_915 = (parity_793 & parity_796) | ((^select_767[2:0]) & (parity_793 | parity_796));
  logic or_919;
  assign or_919 = (parity_813 & parity_816) | ((^select_807[8:6]) & (parity_813 | parity_816));
  logic or_923;
  assign or_923 = (parity_825 & parity_828) | ((^select_790[5:3]) & (parity_825 | parity_828));
  // hls/stages/count_bits.hpp:24
  logic parity_926;
  assign parity_926 = ^{or_923, or_919, or_915};
  logic parity_929;
  assign parity_929 = ^{or_923, or_919, or_915, or_908, or_904, or_900, or_893, or_889, and_885};
  logic xor_930;
  assign xor_930 = parity_884 ^ parity_929;
  // hls/stages/count_bits.hpp:25
  logic and_931;
  assign and_931 = parity_884 & parity_929;
  logic or_935;
  assign or_935 = (parity_866 & parity_881) | ((^{or_847, or_843, or_839}) & (parity_866 | parity_881));
  logic or_939;
  assign or_939 = (parity_911 & parity_926) | ((^{or_893, or_889, and_885}) & (parity_911 | parity_926));
  logic or_946;
  assign or_946 = (or_843 & or_847) | (or_839 & (or_843 | or_847));
  logic or_950;
  assign or_950 = (or_859 & or_863) | (or_855 & (or_859 | or_863));
  logic or_954;
  assign or_954 = (or_874 & or_878) | (or_870 & (or_874 | or_878));
  // hls/stages/count_bits.hpp:24
  logic parity_957;
  assign parity_957 = ^{or_954, or_950, or_946};
  // hls/stages/count_bits.hpp:25
  logic or_961;
  assign or_961 = (or_889 & or_893) | (and_885 & (or_889 | or_893));
  logic or_965;
  assign or_965 = (or_904 & or_908) | (or_900 & (or_904 | or_908));
  logic or_969;
  assign or_969 = (or_919 & or_923) | (or_915 & (or_919 | or_923));
  // hls/stages/count_bits.hpp:24
  logic parity_972;
  assign parity_972 = ^{or_969, or_965, or_961};
  logic parity_975;
  assign parity_975 = ^{or_969, or_965, or_961, or_954, or_950, or_946, or_939, or_935, and_931};
  // hls/stages/count_bits.hpp:25
  logic or_979;
  assign or_979 = (parity_957 & parity_972) | ((^{or_939, or_935, and_931}) & (parity_957 | parity_972));
  logic or_983;
  assign or_983 = (or_935 & or_939) | (and_931 & (or_935 | or_939));
  logic or_987;
  assign or_987 = (or_950 & or_954) | (or_946 & (or_950 | or_954));
  logic or_991;
  assign or_991 = (or_965 & or_969) | (or_961 & (or_965 | or_969));
  // hls/stages/count_bits.hpp:24
  logic parity_996;
  assign parity_996 = ^{or_991, or_987, or_983, or_979};
  // hls/stages/count_bits.hpp:25
  logic or_1000;
  assign or_1000 = (or_987 & or_991) | (or_983 & (or_987 | or_991));
  logic and_1001;
  assign and_1001 = or_979 & (^{or_991, or_987, or_983});
  // hls/stages/count_bits.hpp:24
  logic xor_1002;
  assign xor_1002 = or_1000 ^ and_1001;
  // hls/stages/count_bits.hpp:27
  logic and_1003;
  assign and_1003 = or_1000 & and_1001;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1004;
  assign select_1004 = equal_591_s1_q ? {and_1003, xor_1002, parity_996, parity_975, xor_930, xor_835} : 6'h0;
  logic [5:0] column;
  assign column = or_577_s1_q ? 6'h0 : select_1004;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1015;
  assign select_1015 = (slot_s1_q[0] ? and_801 : and_784) ? (~(select_762 ^ (slot_s1_q[0] ? select_803 : select_786))) : 12'h0;
  logic [11:0] select_1016;
  assign select_1016 = and_760 ? select_1015 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1022;
  assign parity_1022 = ^select_1016[5:3];
  logic parity_1025;
  assign parity_1025 = ^select_1016[8:6];
  logic parity_1028;
  assign parity_1028 = ^select_1016[11:3];
  // hls/stages/agreement.hpp:221
  logic and_1032;
  assign and_1032 = right_codes_rdata_q[85] & not_581_s1_q;
  logic [11:0] select_1034;
  assign select_1034 = less_580_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1038;
  assign select_1038 = (slot_s1_q[0] ? and_1032 : and_801) ? (~(select_785 ^ (slot_s1_q[0] ? select_1034 : select_803))) : 12'h0;
  logic [11:0] select_1039;
  assign select_1039 = and_783 ? select_1038 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1042;
  assign parity_1042 = ^select_1039[8:6];
  logic parity_1045;
  assign parity_1045 = ^select_1039[11:9];
  // hls/stages/agreement.hpp:734
  logic select_1050;
  assign select_1050 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_581_s1_q) : and_1032;
  logic [11:0] select_1052;
  assign select_1052 = slot_s1_q[0] ? (less_580_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1034;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1056;
  assign select_1056 = and_800 ? (select_1050 ? (~(select_802 ^ select_1052)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1062;
  assign parity_1062 = ^select_1056[2:0];
  logic parity_1065;
  assign parity_1065 = ^select_1056[5:3];
  logic parity_1068;
  assign parity_1068 = ^select_1056[8:0];
  logic parity_1074;
  assign parity_1074 = ^select_1056[11:9];
  logic parity_1077;
  assign parity_1077 = ^select_1039[2:0];
  logic parity_1080;
  assign parity_1080 = ^{select_1056[11:9], select_1039[5:0]};
  logic parity_1083;
  assign parity_1083 = ^{select_1056, select_1039, select_1016[2:0]};
  logic xor_1084;
  assign xor_1084 = parity_1028 ^ parity_1083;
  // hls/stages/count_bits.hpp:23
  logic or_1088;
  assign or_1088 = (select_1016[1:0] == 2'h3) | (select_1016[2] & (select_1016[0] | select_1016[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1092;
  assign or_1092 = (select_1039[7:6] == 2'h3) | (select_1039[8] & (select_1039[6] | select_1039[7]));
  logic or_1096;
  assign or_1096 = (select_1039[10:9] == 2'h3) | (select_1039[11] & (select_1039[9] | select_1039[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1104;
  assign or_1104 = (select_1056[7:6] == 2'h3) | (select_1056[8] & (~(select_1056[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1108;
  assign or_1108 = (select_1056[1:0] == 2'h3) | (select_1056[2] & (select_1056[0] | select_1056[1]));
  logic or_1112;
  assign or_1112 = (select_1056[4:3] == 2'h3) | (select_1056[5] & (select_1056[3] | select_1056[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1115;
  assign parity_1115 = ^{or_1112, or_1108, or_1104};
  // hls/stages/count_bits.hpp:23
  logic or_1119;
  assign or_1119 = (select_1039[4:3] == 2'h3) | (select_1039[5] & (select_1039[3] | select_1039[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1123;
  assign or_1123 = (select_1056[10:9] == 2'h3) | (select_1056[11] & (select_1056[9] | select_1056[10]));
  logic or_1127;
  assign or_1127 = (select_1039[1:0] == 2'h3) | (select_1039[2] & (select_1039[0] | select_1039[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1130;
  assign parity_1130 = ^{or_1127, or_1123, or_1119};
  logic parity_1133;
  assign parity_1133 = ^{or_1127, or_1123, or_1119, or_1112, or_1108, or_1104, or_1096, or_1092, or_1088};
  // hls/stages/count_bits.hpp:25
  logic and_1134;
  assign and_1134 = parity_1028 & parity_1083;
  logic or_1138;
  assign or_1138 = (parity_1022 & parity_1025) | ((^select_1016[11:9]) & (parity_1022 | parity_1025));
  logic and_1141;
  assign and_1141 = (^{select_1039[11:6], select_1016[2:0]}) & (parity_1068 | parity_1080);
  logic or_1142;
  assign or_1142 = (parity_1068 & parity_1080) | and_1141;
  // hls/stages/count_bits.hpp:23
  logic or_1149;
  assign or_1149 = (select_1016[10:9] == 2'h3) | (select_1016[11] & (select_1016[9] | select_1016[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1153;
  assign or_1153 = (select_1016[4:3] == 2'h3) | (select_1016[5] & (select_1016[3] | select_1016[4]));
  logic or_1157;
  assign or_1157 = (select_1016[7:6] == 2'h3) | (select_1016[8] & (select_1016[6] | select_1016[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1160;
  assign parity_1160 = ^{or_1157, or_1153, or_1149};
  // hls/stages/count_bits.hpp:25
  logic or_1164;
  assign or_1164 = (parity_1042 & parity_1045) | ((^select_1016[2:0]) & (parity_1042 | parity_1045));
  logic or_1168;
  assign or_1168 = (parity_1062 & parity_1065) | ((^select_1056[8:6]) & (parity_1062 | parity_1065));
  logic or_1172;
  assign or_1172 = (parity_1074 & parity_1077) | ((^select_1039[5:3]) & (parity_1074 | parity_1077));
  // hls/stages/count_bits.hpp:24
  logic parity_1175;
  assign parity_1175 = ^{or_1172, or_1168, or_1164};
  logic parity_1178;
  assign parity_1178 = ^{or_1172, or_1168, or_1164, or_1157, or_1153, or_1149, or_1142, or_1138, and_1134};
  logic xor_1179;
  assign xor_1179 = parity_1133 ^ parity_1178;
  // hls/stages/count_bits.hpp:25
  logic and_1180;
  assign and_1180 = parity_1133 & parity_1178;
  logic or_1184;
  assign or_1184 = (parity_1115 & parity_1130) | ((^{or_1096, or_1092, or_1088}) & (parity_1115 | parity_1130));
  logic or_1188;
  assign or_1188 = (parity_1160 & parity_1175) | ((^{or_1142, or_1138, and_1134}) & (parity_1160 | parity_1175));
  logic or_1195;
  assign or_1195 = (or_1092 & or_1096) | (or_1088 & (or_1092 | or_1096));
  logic or_1199;
  assign or_1199 = (or_1108 & or_1112) | (or_1104 & (or_1108 | or_1112));
  logic or_1203;
  assign or_1203 = (or_1123 & or_1127) | (or_1119 & (or_1123 | or_1127));
  // hls/stages/count_bits.hpp:24
  logic parity_1206;
  assign parity_1206 = ^{or_1203, or_1199, or_1195};
  // hls/stages/count_bits.hpp:25
  logic or_1210;
  assign or_1210 = (or_1138 & or_1142) | (and_1134 & (or_1138 | or_1142));
  logic or_1214;
  assign or_1214 = (or_1153 & or_1157) | (or_1149 & (or_1153 | or_1157));
  logic or_1218;
  assign or_1218 = (or_1168 & or_1172) | (or_1164 & (or_1168 | or_1172));
  // hls/stages/count_bits.hpp:24
  logic parity_1221;
  assign parity_1221 = ^{or_1218, or_1214, or_1210};
  logic parity_1224;
  assign parity_1224 = ^{or_1218, or_1214, or_1210, or_1203, or_1199, or_1195, or_1188, or_1184, and_1180};
  // hls/stages/count_bits.hpp:25
  logic or_1228;
  assign or_1228 = (parity_1206 & parity_1221) | ((^{or_1188, or_1184, and_1180}) & (parity_1206 | parity_1221));
  logic or_1232;
  assign or_1232 = (or_1184 & or_1188) | (and_1180 & (or_1184 | or_1188));
  logic or_1236;
  assign or_1236 = (or_1199 & or_1203) | (or_1195 & (or_1199 | or_1203));
  logic or_1240;
  assign or_1240 = (or_1214 & or_1218) | (or_1210 & (or_1214 | or_1218));
  // hls/stages/count_bits.hpp:24
  logic parity_1245;
  assign parity_1245 = ^{or_1240, or_1236, or_1232, or_1228};
  // hls/stages/count_bits.hpp:25
  logic or_1249;
  assign or_1249 = (or_1236 & or_1240) | (or_1232 & (or_1236 | or_1240));
  logic and_1250;
  assign and_1250 = or_1228 & (^{or_1240, or_1236, or_1232});
  // hls/stages/count_bits.hpp:24
  logic xor_1251;
  assign xor_1251 = or_1249 ^ and_1250;
  // hls/stages/count_bits.hpp:27
  logic and_1252;
  assign and_1252 = or_1249 & and_1250;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1253;
  assign select_1253 = equal_591_s1_q ? {and_1252, xor_1251, parity_1245, parity_1224, xor_1179, xor_1084} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_577_s1_q ? 6'h0 : select_1253;
  // hls/stages/agreement.hpp:221
  logic and_1261;
  assign and_1261 = right_codes_rdata_q[27] & not_581_s1_q;
  // hls/stages/agreement.hpp:734
  logic select_1262;
  assign select_1262 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_581_s1_q) : and_1261;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1264;
  assign select_1264 = less_580_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:734
  logic [11:0] select_1265;
  assign select_1265 = slot_s1_q[0] ? (less_580_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1264;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1269;
  assign select_1269 = and_760 ? (select_1262 ? (~(select_762 ^ select_1265)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1275;
  assign parity_1275 = ^select_1269[5:3];
  logic parity_1278;
  assign parity_1278 = ^select_1269[8:6];
  logic parity_1281;
  assign parity_1281 = ^select_1269[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1289;
  assign select_1289 = (slot_s1_q[0] ? and_1261 : and_761) ? (~(select_785 ^ (slot_s1_q[0] ? select_1264 : select_763))) : 12'h0;
  logic [11:0] select_1290;
  assign select_1290 = and_783 ? select_1289 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1293;
  assign parity_1293 = ^select_1290[8:6];
  logic parity_1296;
  assign parity_1296 = ^select_1290[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1304;
  assign select_1304 = (slot_s1_q[0] ? and_761 : and_784) ? (~(select_802 ^ (slot_s1_q[0] ? select_763 : select_786))) : 12'h0;
  logic [11:0] select_1305;
  assign select_1305 = and_800 ? select_1304 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1311;
  assign parity_1311 = ^select_1305[2:0];
  logic parity_1314;
  assign parity_1314 = ^select_1305[5:3];
  logic parity_1317;
  assign parity_1317 = ^select_1305[8:0];
  logic parity_1323;
  assign parity_1323 = ^select_1305[11:9];
  logic parity_1326;
  assign parity_1326 = ^select_1290[2:0];
  logic parity_1329;
  assign parity_1329 = ^{select_1305[11:9], select_1290[5:0]};
  logic parity_1332;
  assign parity_1332 = ^{select_1305, select_1290, select_1269[2:0]};
  logic xor_1333;
  assign xor_1333 = parity_1281 ^ parity_1332;
  // hls/stages/count_bits.hpp:23
  logic or_1337;
  assign or_1337 = (select_1269[1:0] == 2'h3) | (select_1269[2] & (select_1269[0] | select_1269[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1341;
  assign or_1341 = (select_1290[7:6] == 2'h3) | (select_1290[8] & (select_1290[6] | select_1290[7]));
  logic or_1345;
  assign or_1345 = (select_1290[10:9] == 2'h3) | (select_1290[11] & (select_1290[9] | select_1290[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1353;
  assign or_1353 = (select_1305[7:6] == 2'h3) | (select_1305[8] & (~(select_1305[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1357;
  assign or_1357 = (select_1305[1:0] == 2'h3) | (select_1305[2] & (select_1305[0] | select_1305[1]));
  logic or_1361;
  assign or_1361 = (select_1305[4:3] == 2'h3) | (select_1305[5] & (select_1305[3] | select_1305[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1364;
  assign parity_1364 = ^{or_1361, or_1357, or_1353};
  // hls/stages/count_bits.hpp:23
  logic or_1368;
  assign or_1368 = (select_1290[4:3] == 2'h3) | (select_1290[5] & (select_1290[3] | select_1290[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1372;
  assign or_1372 = (select_1305[10:9] == 2'h3) | (select_1305[11] & (select_1305[9] | select_1305[10]));
  logic or_1376;
  assign or_1376 = (select_1290[1:0] == 2'h3) | (select_1290[2] & (select_1290[0] | select_1290[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1379;
  assign parity_1379 = ^{or_1376, or_1372, or_1368};
  logic parity_1382;
  assign parity_1382 = ^{or_1376, or_1372, or_1368, or_1361, or_1357, or_1353, or_1345, or_1341, or_1337};
  // hls/stages/count_bits.hpp:25
  logic and_1383;
  assign and_1383 = parity_1281 & parity_1332;
  logic or_1387;
  assign or_1387 = (parity_1275 & parity_1278) | ((^select_1269[11:9]) & (parity_1275 | parity_1278));
  logic and_1390;
  assign and_1390 = (^{select_1290[11:6], select_1269[2:0]}) & (parity_1317 | parity_1329);
  logic or_1391;
  assign or_1391 = (parity_1317 & parity_1329) | and_1390;
  // hls/stages/count_bits.hpp:23
  logic or_1398;
  assign or_1398 = (select_1269[10:9] == 2'h3) | (select_1269[11] & (select_1269[9] | select_1269[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1402;
  assign or_1402 = (select_1269[4:3] == 2'h3) | (select_1269[5] & (select_1269[3] | select_1269[4]));
  logic or_1406;
  assign or_1406 = (select_1269[7:6] == 2'h3) | (select_1269[8] & (select_1269[6] | select_1269[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1409;
  assign parity_1409 = ^{or_1406, or_1402, or_1398};
  // hls/stages/count_bits.hpp:25
  logic or_1413;
  assign or_1413 = (parity_1293 & parity_1296) | ((^select_1269[2:0]) & (parity_1293 | parity_1296));
  logic or_1417;
  assign or_1417 = (parity_1311 & parity_1314) | ((^select_1305[8:6]) & (parity_1311 | parity_1314));
  logic or_1421;
  assign or_1421 = (parity_1323 & parity_1326) | ((^select_1290[5:3]) & (parity_1323 | parity_1326));
  // hls/stages/count_bits.hpp:24
  logic parity_1424;
  assign parity_1424 = ^{or_1421, or_1417, or_1413};
  logic parity_1427;
  assign parity_1427 = ^{or_1421, or_1417, or_1413, or_1406, or_1402, or_1398, or_1391, or_1387, and_1383};
  logic xor_1428;
  assign xor_1428 = parity_1382 ^ parity_1427;
  // hls/stages/count_bits.hpp:25
  logic and_1429;
  assign and_1429 = parity_1382 & parity_1427;
  logic or_1433;
  assign or_1433 = (parity_1364 & parity_1379) | ((^{or_1345, or_1341, or_1337}) & (parity_1364 | parity_1379));
  logic or_1437;
  assign or_1437 = (parity_1409 & parity_1424) | ((^{or_1391, or_1387, and_1383}) & (parity_1409 | parity_1424));
  logic or_1444;
  assign or_1444 = (or_1341 & or_1345) | (or_1337 & (or_1341 | or_1345));
  logic or_1448;
  assign or_1448 = (or_1357 & or_1361) | (or_1353 & (or_1357 | or_1361));
  logic or_1452;
  assign or_1452 = (or_1372 & or_1376) | (or_1368 & (or_1372 | or_1376));
  // hls/stages/count_bits.hpp:24
  logic parity_1455;
  assign parity_1455 = ^{or_1452, or_1448, or_1444};
  // hls/stages/count_bits.hpp:25
  logic or_1459;
  assign or_1459 = (or_1387 & or_1391) | (and_1383 & (or_1387 | or_1391));
  logic or_1463;
  assign or_1463 = (or_1402 & or_1406) | (or_1398 & (or_1402 | or_1406));
  logic or_1467;
  assign or_1467 = (or_1417 & or_1421) | (or_1413 & (or_1417 | or_1421));
  // hls/stages/count_bits.hpp:24
  logic parity_1470;
  assign parity_1470 = ^{or_1467, or_1463, or_1459};
  logic parity_1473;
  assign parity_1473 = ^{or_1467, or_1463, or_1459, or_1452, or_1448, or_1444, or_1437, or_1433, and_1429};
  // hls/stages/count_bits.hpp:25
  logic or_1477;
  assign or_1477 = (parity_1455 & parity_1470) | ((^{or_1437, or_1433, and_1429}) & (parity_1455 | parity_1470));
  logic or_1481;
  assign or_1481 = (or_1433 & or_1437) | (and_1429 & (or_1433 | or_1437));
  logic or_1485;
  assign or_1485 = (or_1448 & or_1452) | (or_1444 & (or_1448 | or_1452));
  logic or_1489;
  assign or_1489 = (or_1463 & or_1467) | (or_1459 & (or_1463 | or_1467));
  // hls/stages/count_bits.hpp:24
  logic parity_1494;
  assign parity_1494 = ^{or_1489, or_1485, or_1481, or_1477};
  // hls/stages/count_bits.hpp:25
  logic or_1498;
  assign or_1498 = (or_1485 & or_1489) | (or_1481 & (or_1485 | or_1489));
  logic and_1499;
  assign and_1499 = or_1477 & (^{or_1489, or_1485, or_1481});
  // hls/stages/count_bits.hpp:24
  logic xor_1500;
  assign xor_1500 = or_1498 ^ and_1499;
  // hls/stages/count_bits.hpp:27
  logic and_1501;
  assign and_1501 = or_1498 & and_1499;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1502;
  assign select_1502 = equal_591_s1_q ? {and_1501, xor_1500, parity_1494, parity_1473, xor_1428, xor_1333} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_577_s1_q ? 6'h0 : select_1502;
  // hls/stages/agreement.hpp:788
  logic and_1570;
  assign and_1570 = ends_cell_s1_q & inside_v;
  logic and_1572;
  assign and_1572 = not_573 & (so_s1_q & and_1570);
  logic [5:0] select_1576;
  assign select_1576 = so_s1_q ? x_s1_q[5:0] : (or_577_s1_q ? (less_580_s1_q ? 6'h0 : select_624) : 6'h0);
  // hls/stages/agreement.hpp:247
  logic or_1580;
  assign or_1580 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_1589;
  assign and_1589 = or_577_s1_q & (slot_s1_q[2] & not_581_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1702;
  assign select_1702 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1702[16:7])) ? 8'h7f : select_1702[7:0];
  // hls/stages/patches.hpp:173
  logic [7:0] pixel;
  assign pixel = equal_1779_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1779_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:501
  logic less_1866;
  assign less_1866 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:502
  logic or_1867;
  assign or_1867 = equal_1778_s1_q | less_1866;
  // hls/stages/patches.hpp:505
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1872;
  assign select_1872 = equal_1778_s1_q ? patches_column_s1_q[0] : (or_1867 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1873;
  assign not_1873 = ~or_1867;
  // hls/stages/patches.hpp:502
  logic [4:0] sum_1874;
  assign sum_1874 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:504
  logic [4:0] select_1877;
  assign select_1877 = or_1867 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1874) + 5'h1) : sum_1874;
  // hls/stages/patches.hpp:506
  logic [4:0] select_1878;
  assign select_1878 = equal_1778_s1_q ? 5'h0 : select_1877;
  logic or_1879;
  assign or_1879 = equal_1778_s1_q | equal_1776_s1_q;
  // hls/stages/patches.hpp:482
  logic equal_1881;
  assign equal_1881 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1883;
  assign equal_1883 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:484
  logic and_1885;
  assign and_1885 = of_row & (~equal_1883);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1881 ? 2'h3 : {equal_1883, and_1885};
  // hls/stages/patches.hpp:470
  logic [8:0] sum_1888;
  assign sum_1888 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1889;
  assign sum_1889 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1888, pixel_2[0]} - {1'b0, sum_1889, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:472
  logic [11:0] sum_1891;
  assign sum_1891 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1892;
  assign sum_1892 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1891[11], sum_1891};
  logic [13:0] sum_1893;
  assign sum_1893 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1892, down_2[1]};
  logic [12:0] sum_1894;
  assign sum_1894 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1893[13:1];
  logic [14:0] sum_1895;
  assign sum_1895 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1894, sum_1893[0], down_2[0]};
  // hls/stages/patches.hpp:454
  logic or_1902;
  assign or_1902 = (sum_1895[8] & (~(sum_1895[7:0] == 8'h0))) | (~(sum_1895[13:9] == 5'h0));
  // hls/stages/patches.hpp:468
  logic [8:0] sum_1907;
  assign sum_1907 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1908;
  assign sum_1908 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1907};
  logic [10:0] sum_1909;
  assign sum_1909 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1908, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1910;
  assign sum_1910 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1909[10:1];
  // hls/stages/patches.hpp:469
  logic [11:0] smooth;
  assign smooth = {sum_1910, sum_1909[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:471
  logic [12:0] sum_1912;
  assign sum_1912 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1913;
  assign sum_1913 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1914;
  assign difference_1914 = {1'b0, sum_1912, smooth[0]} - {1'b0, sum_1913, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:454
  logic or_1921;
  assign or_1921 = (difference_1914[8] & (~(difference_1914[7:0] == 8'h0))) | (~(difference_1914[13:9] == 5'h0));
  // hls/stages/patches.hpp:483
  logic or_1929;
  assign or_1929 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1883) | equal_1881;
  // hls/stages/patches.hpp:478
  logic and_1934;
  assign and_1934 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:185
  logic and_1938;
  assign and_1938 = not_1777_s1_q & (or_1780_s1_q & (or_1929 & (equal_1779_s1_q & and_1934)));
  // hls/stages/patches.hpp:173
  logic and_1948;
  assign and_1948 = (~(equal_1779_s1_q | (~and_1934))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:185
  logic and_1952;
  assign and_1952 = not_1777_s1_q & (or_1780_s1_q & (and_1948 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:547
  logic less_1954;
  assign less_1954 = patches_step_q[4:0] < 5'h11;
  logic equal_1955;
  assign equal_1955 = patches_step_q[6:5] == 2'h0;
  logic not_1956;
  assign not_1956 = ~equal_1955;
  logic equal_1957;
  assign equal_1957 = patches_step_q[6:5] == 2'h3;
  logic not_1958;
  assign not_1958 = ~equal_1957;
  // hls/stages/patches.hpp:561
  logic select_1961;
  assign select_1961 = equal_1957 ? (less_1954 & (less_1954 & not_1958)) : less_1954;
  // hls/stages/patches.hpp:185
  logic and_1964;
  assign and_1964 = equal_1774_s1_q & (less_1954 ? (not_1956 & select_1961) : select_1961);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1992;
  assign sum_1992 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:460
  logic select_2566;
  assign select_2566 = equal_2469_s1_q ? (~({row_s1_q, 1'b0} < {sum_2563, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_2827;
  assign and_2827 = and_547_s1_q & (equal_2469_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_2828;
  assign and_2828 = and_2470_s1_q & and_2827;
  // hls/stages/registration.hpp:127
  logic and_2830;
  assign and_2830 = and_2470_s1_q & (~and_2827);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2831;
  assign select_2831 = and_2830 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2833;
  assign select_2833 = and_2828 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2831[15]}}, select_2831});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2834;
  assign select_2834 = and_2830 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2834[15]}}, select_2834};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2836;
  assign select_2836 = and_2828 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_2837;
  assign and_2837 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2837 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:188
  logic select_3081;
  assign select_3081 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:185
  logic [11:0] select_3084;
  assign select_3084 = equal_1776_s1_q ? patches_smooth_values_0_q : (or_1780_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3086;
  assign select_3086 = or_1780_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3088;
  assign select_3088 = equal_1774_s1_q ? patches_smooth_values_1_q : (equal_1776_s1_q ? patches_smooth_values_1_q : select_3086);
  logic [11:0] select_3089;
  assign select_3089 = or_1780_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3091;
  assign select_3091 = equal_1774_s1_q ? patches_smooth_values_2_q : (equal_1776_s1_q ? patches_smooth_values_2_q : select_3089);
  logic [11:0] select_3092;
  assign select_3092 = or_1780_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3094;
  assign select_3094 = equal_1774_s1_q ? patches_smooth_values_3_q : (equal_1776_s1_q ? patches_smooth_values_3_q : select_3092);
  logic [10:0] select_3096;
  assign select_3096 = equal_1776_s1_q ? patches_down_values_0_q : (or_1780_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3099;
  assign select_3099 = equal_1776_s1_q ? patches_down_values_1_q : (or_1780_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3102;
  assign select_3102 = equal_1776_s1_q ? patches_down_values_2_q : (or_1780_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3105;
  assign select_3105 = equal_1776_s1_q ? patches_down_values_3_q : (or_1780_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:176
  logic and_3142;
  assign and_3142 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:414
  logic [4:0] select_3147;
  assign select_3147 = or_3042_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:416
  logic [3:0] select_3149;
  assign select_3149 = and_3142 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:185
  logic [4:0] select_3505;
  assign select_3505 = equal_1774_s1_q ? patches_summed_down_by_q : (equal_1776_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:557
  logic and_3538;
  assign and_3538 = less_1954 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:561
  logic select_3541;
  assign select_3541 = equal_1957 ? (less_1954 ? (not_1958 & and_3538) : and_3538) : and_3538;
  // hls/stages/patches.hpp:185
  logic select_3544;
  assign select_3544 = equal_1774_s1_q ? (less_1954 ? (not_1956 & select_3541) : select_3541) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3883;
  assign select_3883 = so_s1_q ? (and_2837 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3885;
  assign sum_3885 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3886;
  assign select_3886 = sum_1992[5] ? {1'b1, sum_1992[4:0], region_across_rest_q[2:0]} : sum_3885;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3888;
  assign select_3888 = equal_2469_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3891;
  assign select_3891 = equal_2469_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:238; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_512_s1_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_521;
`endif
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:352; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign census_memory_re = s1_en & and_547_s1_q;
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
  assign moments_memory_raddr = select_571;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_589;
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
  assign best_right_raddr = or_577_s1_q ? select_624 : right_s1_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s1_en & select_615_s1_q;
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
  assign shown_right_re = s1_en & and_1572;
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
  assign left_turns_re = s1_en & and_1589;
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
  assign right_turns_raddr = select_624;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s1_en & and_1589;
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
  assign patches_right_codes_raddr = {select_1878, not_1873, select_1872};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1879;
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
  assign patches_left_codes_re = s1_en & (not_1775_s1_q & (new_row & equal_1776_s1_q));
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
  assign patches_rows_re = s1_en & and_1964;
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
  assign seen_columns_re = s1_en & and_1572;
`endif
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_648_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_749, left_rdata_q[65:49], and_748, left_rdata_q[47:31], and_747, left_rdata_q[29:13], and_746, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_648_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_755, right_codes_rdata_q[84:73], and_754, right_codes_rdata_q[71:60], and_753, right_codes_rdata_q[56:43], and_752, right_codes_rdata_q[41:28], and_751, right_codes_rdata_q[26:13], and_750, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_1860_s1_q;
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
      moments_place_q <= select_570;
      moments_taken_q <= not_573 & (not_575 & (equal_576_s1_q & inside_v));
      moments_starts_q <= not_573 & (not_575 & (equal_576_s1_q & (inside_v & first)));
      row_q <= and_547_s1_q ? (equal_2469_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_547_s1_q ? select_2566 : lower_half_q;
      registration_slope_row_q <= select_2833;
      registration_slope_change_q <= select_2836;
      registration_slope_q <= so_s1_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3066_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3066_s1_q & select_3081;
      patches_smooth_values_0_q <= equal_1774_s1_q ? patches_smooth_values_0_q : select_3084;
      patches_smooth_values_1_q <= select_3088;
      patches_smooth_values_2_q <= select_3091;
      patches_smooth_values_3_q <= select_3094;
      patches_down_values_0_q <= equal_1774_s1_q ? patches_down_values_0_q : select_3096;
      patches_down_values_1_q <= equal_1774_s1_q ? patches_down_values_1_q : select_3099;
      patches_down_values_2_q <= equal_1774_s1_q ? patches_down_values_2_q : select_3102;
      patches_down_values_3_q <= equal_1774_s1_q ? patches_down_values_3_q : select_3105;
      patches_down_by_q <= or_3042_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3142});
      patches_along_q <= select_3147;
      patches_match_row_q <= or_3042_s1_q ? 4'h0 : select_3149;
      patches_summed_last_q <= not_1775_s1_q & (equal_1776_s1_q & and_3142);
      patches_summed_down_by_q <= select_3505;
      patches_step_q <= or_3042_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3544;
      region_across_rest_q <= select_3883;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3886;
      columns_begin_rest_q <= and_547_s1_q ? select_3888 : columns_begin_rest_q;
      columns_begin_back_q <= and_547_s1_q ? select_3891 : columns_begin_back_q;
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
  logic [2:0] select_508_s2_q;
  logic row_starts_s2_q;
  logic [7:0] select_512_s2_q;
  logic and_520_s2_q;
  logic and_521_s2_q;
  logic equal_526_s2_q;
  logic [5:0] select_541_s2_q;
  logic [5:0] last_s2_2_q;
  logic and_545_s2_q;
  logic and_547_s2_q;
  logic equal_567_s2_q;
  logic [10:0] select_571_s2_q;
  logic equal_572_s2_q;
  logic not_573_s2_q;
  logic so_s2_q;
  logic not_575_s2_q;
  logic equal_576_s2_q;
  logic or_577_s2_q;
  logic less_580_s2_q;
  logic not_581_s2_q;
  logic inside_v_s2_q;
  logic not_585_s2_q;
  logic and_589_s2_q;
  logic and_598_s2_q;
  logic and_606_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] right_s2_q;
  logic and_637_s2_q;
  logic and_642_s2_q;
  logic and_644_s2_q;
  logic equal_677_s2_q;
  logic [5:0] column_s2_q;
  logic [5:0] select_1255_s2_q;
  logic [5:0] select_1504_s2_q;
  logic and_1559_s2_q;
  logic equal_1560_s2_q;
  logic and_1570_s2_q;
  logic and_1572_s2_q;
  logic [5:0] select_1576_s2_q;
  logic or_1580_s2_q;
  logic and_1683_s2_q;
  logic less_1697_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1774_s2_q;
  logic equal_1776_s2_q;
  logic equal_1779_s2_q;
  logic or_1780_s2_q;
  logic [4:0] select_1804_s2_q;
  logic select_1810_s2_q;
  logic [3:0] select_1850_s2_q;
  logic less_1866_s2_q;
  logic new_row_s2_q;
  logic or_1879_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_1896_s2_q;
  logic or_1902_s2_q;
  logic and_1906_s2_q;
  logic and_1922_s2_q;
  logic and_1925_s2_q;
  logic and_1939_s2_q;
  logic and_1948_s2_q;
  logic and_1953_s2_q;
  logic less_1954_s2_q;
  logic equal_1955_s2_q;
  logic not_1956_s2_q;
  logic equal_1957_s2_q;
  logic not_1958_s2_q;
  logic and_1971_s2_q;
  logic select_1973_s2_q;
  logic and_1976_s2_q;
  logic sum_1992_s2_q;
  logic and_2013_s2_q;
  logic and_2131_s2_q;
  logic equal_2280_s2_q;
  logic equal_2469_s2_q;
  logic and_2596_s2_q;
  logic equal_2681_s2_q;
  logic less_3118_s2_q;
  logic equal_3461_s2_q;
  logic equal_3545_s2_q;
  logic less_3871_s2_q;
  logic equal_4090_s2_q;
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
      select_508_s2_q <= select_508_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_512_s2_q <= select_512_s1_q;
      and_520_s2_q <= and_520_s1_q;
      and_521_s2_q <= and_521;
      equal_526_s2_q <= equal_526_s1_q;
      select_541_s2_q <= select_541_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_545_s2_q <= and_545_s1_q;
      and_547_s2_q <= and_547_s1_q;
      equal_567_s2_q <= equal_567;
      select_571_s2_q <= select_571;
      equal_572_s2_q <= equal_572_s1_q;
      not_573_s2_q <= not_573;
      so_s2_q <= so_s1_q;
      not_575_s2_q <= not_575;
      equal_576_s2_q <= equal_576_s1_q;
      or_577_s2_q <= or_577_s1_q;
      less_580_s2_q <= less_580_s1_q;
      not_581_s2_q <= not_581_s1_q;
      inside_v_s2_q <= inside_v;
      not_585_s2_q <= not_585;
      and_589_s2_q <= and_589;
      and_598_s2_q <= or_577_s1_q & (left_rdata_q[70] & not_581_s1_q);
      and_606_s2_q <= (or_577_s1_q & (left_rdata_q[68] & not_581_s1_q)) & and_605;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_637_s2_q <= or_577_s1_q & (left_rdata_q[71] & not_581_s1_q);
      and_642_s2_q <= or_577_s1_q & (right_codes_rdata_q[58] & not_581_s1_q);
      and_644_s2_q <= or_577_s1_q & (right_codes_rdata_q[59] & not_581_s1_q);
      equal_677_s2_q <= row_s1_q == 6'h0;
      column_s2_q <= column;
      select_1255_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1504_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1559_s2_q <= and_1559_s1_q;
      equal_1560_s2_q <= equal_1560_s1_q;
      and_1570_s2_q <= and_1570;
      and_1572_s2_q <= and_1572;
      select_1576_s2_q <= select_1576;
      or_1580_s2_q <= or_1580;
      and_1683_s2_q <= and_1683_s1_q;
      less_1697_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1774_s2_q <= equal_1774_s1_q;
      equal_1776_s2_q <= equal_1776_s1_q;
      equal_1779_s2_q <= equal_1779_s1_q;
      or_1780_s2_q <= or_1780_s1_q;
      select_1804_s2_q <= select_1804_s1_q;
      select_1810_s2_q <= select_1810_s1_q;
      select_1850_s2_q <= select_1850_s1_q;
      less_1866_s2_q <= less_1866;
      new_row_s2_q <= new_row;
      or_1879_s2_q <= or_1879;
      of_row_2_s2_q <= of_row_2;
      not_1896_s2_q <= ~sum_1895[14];
      or_1902_s2_q <= or_1902;
      and_1906_s2_q <= sum_1895[14] & (~(sum_1895[13:8] == 6'h3f));
      and_1922_s2_q <= (~difference_1914[14]) & or_1921;
      and_1925_s2_q <= difference_1914[14] & (~(difference_1914[13:8] == 6'h3f));
      and_1939_s2_q <= not_1775_s1_q & and_1938;
      and_1948_s2_q <= and_1948;
      and_1953_s2_q <= not_1775_s1_q & and_1952;
      less_1954_s2_q <= less_1954;
      equal_1955_s2_q <= equal_1955;
      not_1956_s2_q <= not_1956;
      equal_1957_s2_q <= equal_1957;
      not_1958_s2_q <= not_1958;
      and_1971_s2_q <= sample_pair_whole_q;
      select_1973_s2_q <= left_first_q;
      and_1976_s2_q <= right_q;
      sum_1992_s2_q <= sum_1992[5];
      and_2013_s2_q <= or_577_s1_q & (left_rdata_q[69] & not_581_s1_q);
      and_2131_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2280_s2_q <= (last_s1_2_q | row_s1_q) == 6'h0;
      equal_2469_s2_q <= equal_2469_s1_q;
      and_2596_s2_q <= or_577_s1_q & (not_581_s1_q & and_605);
      equal_2681_s2_q <= shift == 6'h0;
      less_3118_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3461_s2_q <= patches_match_row_q == 4'h0;
      equal_3545_s2_q <= patches_step_q[6:5] == 2'h2;
      less_3871_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4090_s2_q <= row_s1_q[5:3] == 3'h0;
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
  // hls/stages/census.hpp:117
  logic [11:0] select_524;
  assign select_524 = select_508_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:129
  logic [11:0] sum_528;
  assign sum_528 = select_524 + (equal_526_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:117
  logic [11:0] sum_530;
  assign sum_530 = {4'h0, sample_pair_pixel_1_q} + (select_508_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:129
  logic [11:0] sum_532;
  assign sum_532 = sum_530 + (equal_526_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_508_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_536;
  assign and_536 = whole & (averager_memory_rdata_q[24] | equal_526_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_508_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:131
  logic and_540;
  assign and_540 = all_of_skin & (averager_memory_rdata_q[25] | equal_526_s2_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_520_s2_q ? sum_528[11:3] : 9'h0;
  // hls/stages/census.hpp:134
  logic equal_550;
  assign equal_550 = select_508_s2_q == 3'h1;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_550 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_553;
  assign select_553 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_520_s2_q ? sum_532[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_550 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_557;
  assign select_557 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_558;
  assign and_558 = and_520_s2_q & and_536;
  // hls/stages/census.hpp:134
  logic select_560;
  assign select_560 = equal_550 ? and_558 : (averager_mask_q & and_558);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_560;
  // hls/stages/census.hpp:218
  logic and_562;
  assign and_562 = and_520_s2_q & and_540;
  // hls/stages/census.hpp:134
  logic select_564;
  assign select_564 = equal_550 ? and_562 : (averager_of_skin_q & and_562);
  // hls/stages/agreement.hpp:276
  logic and_565;
  assign and_565 = sample_pair_whole_s2_q & select_564;
  // hls/stages/agreement.hpp:978
  logic select_619;
  assign select_619 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_629;
  assign difference_629 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:993
  logic [9:0] sum_630;
  assign sum_630 = {difference_629[8], difference_629} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_632;
  assign and_632 = (and_606_s2_q & select_619) & ({{22{sum_630[9]}}, sum_630} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_634;
  assign and_634 = or_577_s2_q & (not_581_s2_q & and_632);
  // hls/stages/moments.hpp:77
  logic and_635;
  assign and_635 = and_598_s2_q & and_634;
  // hls/stages/census.hpp:308
  logic less_650;
  assign less_650 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_651;
  assign less_651 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_659;
  assign less_659 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_660;
  assign less_660 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_661;
  assign less_661 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_662;
  assign less_662 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_663;
  assign less_663 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_671;
  assign less_671 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_672;
  assign less_672 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_673;
  assign less_673 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_674;
  assign equal_674 = last_s2_2_q == 6'h0;
  logic [3:0] select_678;
  assign select_678 = equal_677_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_679;
  assign select_679 = equal_674 ? {select_678, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_680;
  assign select_680 = equal_674 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:313
  logic and_681;
  assign and_681 = select_679[4] & select_680[3];
  // hls/stages/census.hpp:300
  logic and_683;
  assign and_683 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_685;
  assign and_685 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_683);
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_685;
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
  // hls/stages/census.hpp:284
  logic [9:0] difference_708;
  assign difference_708 = {1'b0, select_553} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_709;
  assign xor_709 = difference_708[8:0] ^ {9{difference_708[9]}};
  logic [9:0] sum_710;
  assign sum_710 = {9'h0, difference_708[9]} + {1'b0, xor_709};
  logic [9:0] difference_711;
  assign difference_711 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_712;
  assign xor_712 = difference_711[8:0] ^ {9{difference_711[9]}};
  logic [9:0] sum_713;
  assign sum_713 = {9'h0, difference_711[9]} + {1'b0, xor_712};
  logic [9:0] difference_715;
  assign difference_715 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_716;
  assign xor_716 = difference_715[8:0] ^ {9{difference_715[9]}};
  logic [9:0] sum_717;
  assign sum_717 = {9'h0, difference_715[9]} + {1'b0, xor_716};
  logic [10:0] sum_718;
  assign sum_718 = ({1'b0, sum_710} + {1'b0, sum_713}) + {1'b0, sum_717};
  logic [9:0] difference_719;
  assign difference_719 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_720;
  assign xor_720 = difference_719[8:0] ^ {9{difference_719[9]}};
  logic [9:0] sum_721;
  assign sum_721 = {9'h0, difference_719[9]} + {1'b0, xor_720};
  logic [9:0] difference_723;
  assign difference_723 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_724;
  assign xor_724 = difference_723[8:0] ^ {9{difference_723[9]}};
  // hls/stages/agreement.hpp:456
  logic and_732;
  assign and_732 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_733;
  assign and_733 = and_681 & and_732;
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_735;
  assign sum_735 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:320
  logic and_737;
  assign and_737 = and_733 & ({{5{sum_735[6]}}, sum_735, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_741;
  assign sum_741 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:807
  logic or_757;
  assign or_757 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:808
  logic select_759;
  assign select_759 = or_757 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1006;
  assign select_1006 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1007;
  assign difference_1007 = {1'b0, column_s2_q} - {1'b0, select_1006};
  logic [7:0] sum_1009;
  assign sum_1009 = {difference_1007[6], difference_1007} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:755
  logic [7:0] select_1010;
  assign select_1010 = slot_s2_q[0] ? chosen_score_q : sum_1009;
  // hls/stages/agreement.hpp:778
  logic [6:0] difference_1256;
  assign difference_1256 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1255_s2_q};
  // hls/stages/agreement.hpp:749
  logic equal_1257;
  assign equal_1257 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:778
  logic [7:0] sum_1259;
  assign sum_1259 = {difference_1256[6], difference_1256} + (equal_1257 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1505;
  assign difference_1505 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1504_s2_q};
  logic [7:0] sum_1507;
  assign sum_1507 = {difference_1505[6], difference_1505} + (equal_1257 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:751
  logic less_1508;
  assign less_1508 = sum_1259 < sum_1507;
  logic [7:0] select_1509;
  assign select_1509 = less_1508 ? sum_1507 : sum_1259;
  logic less_1510;
  assign less_1510 = select_1010 < select_1509;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1510 ? select_1509 : select_1010) : 8'h0;
  // hls/stages/agreement.hpp:808
  logic or_1514;
  assign or_1514 = select_759 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:813
  logic [5:0] select_1515;
  assign select_1515 = or_1514 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:720
  logic not_1516;
  assign not_1516 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:752
  logic [1:0] select_1517;
  assign select_1517 = less_1508 ? {slot_s2_q[0], not_1516} : 2'h0;
  logic [2:0] select_1519;
  assign select_1519 = less_1510 ? {select_1517, not_1516} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:813
  logic [2:0] select_1520;
  assign select_1520 = or_1514 ? select_1519 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1521;
  assign select_1521 = or_1514 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:810
  logic equal_1522;
  assign equal_1522 = select_1519 == 3'h1;
  logic or_1525;
  assign or_1525 = equal_1522 | (~(select_1519 == 3'h2));
  logic [7:0] select_1527;
  assign select_1527 = or_1525 ? before_0_q : before_1_q;
  logic [7:0] select_1528;
  assign select_1528 = equal_1522 ? (or_1525 ? sum_1259 : {7'h0, shift_not_right_q}) : select_1527;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1529;
  assign select_1529 = or_1514 ? select_1528 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1532;
  assign select_1532 = or_1514 ? (equal_1522 ? select_1527 : (or_1525 ? sum_1507 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1534;
  assign sum_1534 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1535;
  assign sum_1535 = {1'b0, before_v} + sum_1534;
  // hls/stages/agreement.hpp:755
  logic [6:0] select_1536;
  assign select_1536 = slot_s2_q[0] ? chosen_near_q : sum_1535;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1538;
  assign sum_1538 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1539;
  assign sum_1539 = {1'b0, before_v_2} + sum_1538;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1541;
  assign sum_1541 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1542;
  assign sum_1542 = {1'b0, before_v_3} + sum_1541;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1544;
  assign select_1544 = (sum_1539 < sum_1542) ? sum_1542 : sum_1539;
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1536 < select_1544) ? select_1544 : select_1536) : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_1548;
  assign less_1548 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:817
  logic [6:0] select_1550;
  assign select_1550 = select_759 ? of_near : (less_1548 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1552;
  assign select_1552 = select_759 ? run_shift_s2_q : (less_1548 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1555;
  assign select_1555 = (run_shift_s2_q == 6'h3f) ? of_best : (select_759 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:818
  logic [7:0] select_1558;
  assign select_1558 = (run_shift_s2_q == 6'h1) ? of_best : (select_759 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:823
  logic select_1561;
  assign select_1561 = or_757 ? shift_first_s2_q : equal_1560_s2_q;
  // hls/stages/agreement.hpp:824
  logic or_1563;
  assign or_1563 = select_1561 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_1564;
  assign select_1564 = or_1563 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1565;
  assign select_1565 = or_1563 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1567;
  assign or_1567 = select_1561 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:832
  logic [6:0] select_1568;
  assign select_1568 = or_1567 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1569;
  assign select_1569 = or_1567 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_1583;
  assign and_1583 = or_577_s2_q & (not_581_s2_q & (and_632 & or_1580_s2_q));
  // hls/stages/agreement.hpp:788
  logic and_1584;
  assign and_1584 = not_575_s2_q & and_1583;
  logic and_1587;
  assign and_1587 = not_573_s2_q & (so_s2_q ? and_1570_s2_q : (equal_576_s2_q & and_634));
  // hls/stages/moments.hpp:73
  logic and_1591;
  assign and_1591 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_1592;
  assign and_1592 = not_585_s2_q & and_1591;
  logic and_1595;
  assign and_1595 = not_585_s2_q & (and_1591 & (moments_memory_rdata_q[1] ^ and_637_s2_q));
  // hls/stages/moments.hpp:73
  logic and_1600;
  assign and_1600 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_1601;
  assign and_1601 = not_585_s2_q & and_1600;
  logic and_1604;
  assign and_1604 = not_585_s2_q & (and_1600 & (moments_memory_rdata_q[3] ^ and_644_s2_q));
  // hls/stages/agreement.hpp:1128
  logic equal_1605;
  assign equal_1605 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_1608;
  assign select_1608 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_1610;
  assign select_1610 = equal_1605 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1608});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1611;
  assign sum_1611 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_1612;
  assign select_1612 = equal_572_s2_q ? select_1610 : {sum_1611, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:211
  logic equal_1613;
  assign equal_1613 = x_s2_q[5:0] == 6'h3f;
  logic equal_1615;
  assign equal_1615 = x_s2_q[5:0] == 6'h3e;
  logic equal_1617;
  assign equal_1617 = x_s2_q[5:0] == 6'h3d;
  logic equal_1619;
  assign equal_1619 = x_s2_q[5:0] == 6'h3c;
  logic equal_1621;
  assign equal_1621 = x_s2_q[5:0] == 6'h3b;
  logic equal_1623;
  assign equal_1623 = x_s2_q[5:0] == 6'h36;
  logic equal_1625;
  assign equal_1625 = x_s2_q[5:0] == 6'h35;
  logic equal_1627;
  assign equal_1627 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_1631;
  assign and_1631 = (~equal_1621) & ((~equal_1623) & ((~equal_1625) & (~equal_1627)));
  logic and_1635;
  assign and_1635 = (~equal_1613) & ((~equal_1615) & ((~equal_1617) & ((~equal_1619) & and_1631)));
  // hls/stages/agreement.hpp:1129
  logic less_1636;
  assign less_1636 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1640;
  assign or_1640 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1009
  logic [4:0] sum_1645;
  assign sum_1645 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1645, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1651;
  assign sum_1651 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1653;
  assign and_1653 = half_ends & ({{3{sum_1651[4]}}, sum_1651} < 8'h3);
  // hls/stages/agreement.hpp:788
  logic and_1654;
  assign and_1654 = so_s2_q & and_1653;
  logic select_1655;
  assign select_1655 = equal_572_s2_q ? (x_s2_q[6] & (equal_1605 ? and_1635 : (less_1636 & (~or_1640)))) : and_1654;
  // hls/stages/registration.hpp:258
  logic not_1657;
  assign not_1657 = ~lower_half_s2_q;
  logic [3:0] select_1658;
  assign select_1658 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1657, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1657};
  // hls/stages/patches.hpp:374
  logic [1:0] select_1684;
  assign select_1684 = and_1683_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1685;
  assign select_1685 = and_1683_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1686;
  assign select_1686 = row_starts_s2_q ? {select_1685, select_1684[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1687;
  assign select_1687 = row_starts_s2_q ? select_1684 : patches_fetch_q;
  logic equal_1688;
  assign equal_1688 = select_1687 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < x_s2_q;
  // hls/stages/agreement.hpp:788
  logic and_1696;
  assign and_1696 = not_573_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1698;
  assign equal_1698 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_577_s2_q ? (less_580_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1698 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1706;
  assign select_1706 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_1707;
  assign select_1707 = b[1] ? a : 8'h0;
  logic [8:0] sum_1708;
  assign sum_1708 = {{2{select_1706[6]}}, select_1706} + {select_1707[7], select_1707};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1709;
  assign select_1709 = b[2] ? a : 8'h0;
  logic [7:0] select_1710;
  assign select_1710 = b[3] ? a : 8'h0;
  logic [8:0] sum_1711;
  assign sum_1711 = {{2{select_1709[7]}}, select_1709[7:1]} + {select_1710[7], select_1710};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1712;
  assign sum_1712 = {{3{sum_1708[8]}}, sum_1708[8:1]} + {sum_1711[8], sum_1711, select_1709[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1713;
  assign select_1713 = b[4] ? a : 8'h0;
  logic [7:0] select_1714;
  assign select_1714 = b[5] ? a : 8'h0;
  logic [8:0] difference_1715;
  assign difference_1715 = {{2{select_1713[7]}}, select_1713[7:1]} - {select_1714[7], select_1714};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1716;
  assign sum_1716 = {difference_1715, select_1713[0]} + {sum_1712[10], sum_1712[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1698 ? {sum_1716, sum_1712[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1718;
  assign sum_1718 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_1721;
  assign and_1721 = less_1697_s2_q & (and_634 & ({{4{sum_1718[9]}}, sum_1718, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_1725;
  assign and_1725 = ({4'h0, last_s2_q[5:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1731;
  assign sum_1731 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1733;
  assign sum_1733 = {sum_1731[9], sum_1731[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1018
  logic and_1736;
  assign and_1736 = ($signed(9'h0) < $signed(sum_1731[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1733, sum_1731[0]})));
  logic and_1737;
  assign and_1737 = (~(and_1725 | (equal_567_s2_q | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1736;
  // hls/stages/agreement.hpp:788
  logic and_1741;
  assign and_1741 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1721 & and_1737)));
  logic and_1742;
  assign and_1742 = not_573_s2_q & and_1741;
  // hls/stages/patches.hpp:157
  logic and_1744;
  assign and_1744 = and_1742 & (~patches_fixed_q);
  // hls/stages/patches.hpp:345
  logic select_1745;
  assign select_1745 = and_1744 ? and_1742 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1748;
  assign select_1748 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:345
  logic [7:0] select_1750;
  assign select_1750 = and_1744 ? (equal_572_s2_q ? 8'h0 : select_1748) : patches_choice_column_q;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1753;
  assign select_1753 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:345
  logic [5:0] select_1755;
  assign select_1755 = and_1744 ? (equal_572_s2_q ? 6'h0 : select_1753) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1756;
  assign sum_1756 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_1716[9]}}, sum_1716[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1759;
  assign select_1759 = ($signed(sum_1756[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1756[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1698 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1756[12:7])) ? 8'h7f : select_1759);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1764;
  assign select_1764 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:345
  logic [7:0] select_1766;
  assign select_1766 = and_1744 ? (equal_572_s2_q ? 8'h0 : select_1764) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_1767;
  assign equal_1767 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:788
  logic and_1771;
  assign and_1771 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1725 | equal_1767)));
  logic and_1772;
  assign and_1772 = not_573_s2_q & and_1771;
  // hls/stages/patches.hpp:345
  logic and_1773;
  assign and_1773 = patches_chooses_s2_q & and_1772;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1787;
  assign select_1787 = row_starts_s2_q ? select_1685 : patches_band_q;
  // hls/stages/patches.hpp:354
  logic equal_1788;
  assign equal_1788 = {patches_choosing_band_s2_q, and_1696} == {select_1787, select_1687[1]};
  // hls/stages/patches.hpp:487
  logic [2:0] sum_1887;
  assign sum_1887 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:454
  logic and_1903;
  assign and_1903 = not_1896_s2_q & or_1902_s2_q;
  // hls/stages/patches.hpp:491
  logic [1:0] sum_1943;
  assign sum_1943 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1979;
  assign select_1979 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1982;
  assign or_1982 = select_1979[7] | (~({select_1979[5], select_1979[3], select_1979[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_1985;
  assign or_1985 = select_1979[7] | (~({select_1979[6], select_1979[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_1988;
  assign or_1988 = select_1979[7] | (~(select_1979[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1989;
  assign select_1989 = equal_572_s2_q ? x_s2_q[5:0] : {region_row_q, or_1988, or_1985, or_1982};
  // hls/stages/agreement.hpp:1128
  logic not_1990;
  assign not_1990 = ~equal_1605;
  // hls/stages/agreement.hpp:1058
  logic or_1994;
  assign or_1994 = (~sum_1992_s2_q) | equal_1767;
  // hls/stages/agreement.hpp:788
  logic and_1997;
  assign and_1997 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_1994));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_577_s2_q & (not_581_s2_q & and_606_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_634;
  // hls/stages/agreement.hpp:149
  logic and_2015;
  assign and_2015 = or_577_s2_q & (not_581_s2_q & and_2013_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2024;
  assign and_2024 = inside_v_s2_q & and_2015;
  // hls/stages/agreement.hpp:1014
  logic select_2025;
  assign select_2025 = slot_s2_q[2] ? shown_shown_q : and_634;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2025);
  // hls/stages/agreement.hpp:1014
  logic select_2028;
  assign select_2028 = slot_s2_q[2] ? shown_nearer_q : and_1583;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2025 ? select_2028 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1271
  logic select_2031;
  assign select_2031 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1275
  logic select_2032;
  assign select_2032 = left_first_s2_q ? select_2031 : read_half_q;
  logic or_2033;
  assign or_2033 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2034;
  assign select_2034 = or_2033 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1277
  logic [9:0] select_2036;
  assign select_2036 = left_first_s2_q ? 10'h1 : (or_2033 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1280
  logic and_2037;
  assign and_2037 = select_2034[8] & select_2036[9];
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = and_2037 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [5:0] select_2040;
  assign select_2040 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2042;
  assign select_2042 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2040});
  // hls/stages/agreement.hpp:1301
  logic equal_2043;
  assign equal_2043 = seen_x_q == 3'h7;
  logic [7:0] select_2045;
  assign select_2045 = and_2037 ? 8'h0 : (seen_column_q + {7'h0, equal_2043});
  // hls/stages/agreement.hpp:1308
  logic [10:0] index;
  assign index = select_2042 + {3'h0, select_2045};
  // hls/stages/agreement.hpp:1261
  logic [11:0] sum_2047;
  assign sum_2047 = {1'b0, {2{select_2032}}, 2'h0, {2{select_2032}}, 1'b0, {2{select_2032}}, 1'b0, select_2032} + {1'b0, index};
  // hls/stages/agreement.hpp:1274
  logic not_2048;
  assign not_2048 = ~left_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2050;
  assign and_2050 = not_2048 & (began_q | and_2037);
  // hls/stages/agreement.hpp:1302
  logic [2:0] select_2052;
  assign select_2052 = and_2037 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1307
  logic and_2054;
  assign and_2054 = and_2050 & (select_2052 == 3'h0);
  logic less_2055;
  assign less_2055 = select_2045 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:438
  logic and_2056;
  assign and_2056 = and_2054 & less_2055;
  logic and_2057;
  assign and_2057 = and_1971_s2_q & and_2056;
  // hls/stages/agreement.hpp:278
  logic select_2059;
  assign select_2059 = and_1971_s2_q ? (left_first_s2_q ? and_2056 : and_2057) : and_2057;
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2061;
  assign sum_2061 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2061[7], sum_2061, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [11:0] sum_2063;
  assign sum_2063 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1030
  logic and_2064;
  assign and_2064 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2065;
  assign and_2065 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2066;
  assign and_2066 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2067;
  assign and_2067 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2069;
  assign sum_2069 = {1'b0, and_2066} + ({1'b0, textured} + {1'b0, and_2067});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2064} + ({2'h0, and_2065} + {1'b0, sum_2069});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2078;
  assign select_2078 = inside_v_s2_q ? (sum_1992_s2_q ? select_1979 : {select_1979[6:0], 1'b0}) : select_1979;
  // hls/stages/agreement.hpp:1050
  logic or_2081;
  assign or_2081 = select_2078[7] | (~({select_2078[5], select_2078[3], select_2078[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2098;
  assign and_2098 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2099;
  assign and_2099 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2100;
  assign and_2100 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2101;
  assign and_2101 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2103;
  assign sum_2103 = {1'b0, and_2100} + ({1'b0, shown} + {1'b0, and_2101});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2098} + ({2'h0, and_2099} + {1'b0, sum_2103});
  // hls/stages/agreement.hpp:1030
  logic and_2114;
  assign and_2114 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2115;
  assign and_2115 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2116;
  assign and_2116 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2117;
  assign and_2117 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2119;
  assign sum_2119 = {1'b0, and_2116} + ({1'b0, near} + {1'b0, and_2117});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2114} + ({2'h0, and_2115} + {1'b0, sum_2119});
  // hls/stages/agreement.hpp:788
  logic and_2135;
  assign and_2135 = ends_cell_s2_q & (and_2131_s2_q & (~({1'b0, sum_1645, last_s2_q[1:0]} < x_s2_q)));
  logic and_2137;
  assign and_2137 = not_573_s2_q & (so_s2_q & and_2135);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2171;
  assign select_2171 = sample_pair_whole_s2_q ? (and_545_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2173;
  assign select_2173 = sample_pair_whole_s2_q ? (and_545_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2193;
  assign select_2193 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2195;
  assign select_2195 = sample_pair_whole_s2_q ? (and_545_s2_q ? select_560 : averager_mask_q) : averager_mask_q;
  logic select_2197;
  assign select_2197 = sample_pair_whole_s2_q ? (and_545_s2_q ? select_564 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2198;
  assign select_2198 = and_547_s2_q ? select_553 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2199;
  assign select_2199 = and_547_s2_q ? select_557 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2201;
  assign select_2201 = and_547_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2202;
  assign select_2202 = and_547_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2203;
  assign select_2203 = and_547_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2204;
  assign select_2204 = and_547_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2205;
  assign select_2205 = and_547_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2206;
  assign select_2206 = and_547_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2207;
  assign select_2207 = and_547_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2208;
  assign select_2208 = and_547_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2209;
  assign select_2209 = and_547_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2210;
  assign select_2210 = and_547_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2211;
  assign select_2211 = and_547_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2212;
  assign select_2212 = and_547_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2213;
  assign select_2213 = and_547_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2214;
  assign select_2214 = and_547_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_547_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2216;
  assign select_2216 = and_547_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2217;
  assign select_2217 = and_547_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2218;
  assign select_2218 = and_547_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2219;
  assign select_2219 = and_547_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2220;
  assign select_2220 = and_547_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2221;
  assign select_2221 = and_547_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2222;
  assign select_2222 = and_547_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2223;
  assign select_2223 = and_547_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2224;
  assign select_2224 = and_547_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2225;
  assign select_2225 = and_547_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2226;
  assign select_2226 = and_547_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2227;
  assign select_2227 = and_547_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_547_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2229;
  assign select_2229 = and_547_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2230;
  assign select_2230 = and_547_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_547_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2232;
  assign select_2232 = and_547_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2233;
  assign select_2233 = and_547_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2234;
  assign select_2234 = and_547_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2235;
  assign select_2235 = and_547_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2236;
  assign select_2236 = and_547_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2237;
  assign select_2237 = and_547_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2238;
  assign select_2238 = and_547_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2239;
  assign select_2239 = and_547_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2240;
  assign select_2240 = and_547_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2241;
  assign select_2241 = and_547_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2242;
  assign select_2242 = and_547_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2243;
  assign select_2243 = and_547_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2244;
  assign select_2244 = and_547_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2245;
  assign select_2245 = and_547_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2246;
  assign select_2246 = and_547_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2247;
  assign select_2247 = and_547_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2248;
  assign select_2248 = and_547_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2249;
  assign select_2249 = and_547_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2250;
  assign select_2250 = and_547_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2251;
  assign select_2251 = and_547_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2252;
  assign select_2252 = and_547_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2253;
  assign select_2253 = and_547_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2255;
  assign difference_2255 = {1'b0, select_557} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2256;
  assign xor_2256 = difference_2255[8:0] ^ {9{difference_2255[9]}};
  logic [9:0] sum_2257;
  assign sum_2257 = {9'h0, difference_2255[9]} + {1'b0, xor_2256};
  logic [9:0] difference_2258;
  assign difference_2258 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2259;
  assign xor_2259 = difference_2258[8:0] ^ {9{difference_2258[9]}};
  logic [9:0] sum_2260;
  assign sum_2260 = {9'h0, difference_2258[9]} + {1'b0, xor_2259};
  logic [9:0] difference_2262;
  assign difference_2262 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2263;
  assign xor_2263 = difference_2262[8:0] ^ {9{difference_2262[9]}};
  logic [9:0] sum_2264;
  assign sum_2264 = {9'h0, difference_2262[9]} + {1'b0, xor_2263};
  logic [10:0] sum_2265;
  assign sum_2265 = ({1'b0, sum_2257} + {1'b0, sum_2260}) + {1'b0, sum_2264};
  logic [9:0] difference_2266;
  assign difference_2266 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2267;
  assign xor_2267 = difference_2266[8:0] ^ {9{difference_2266[9]}};
  logic [9:0] sum_2268;
  assign sum_2268 = {9'h0, difference_2266[9]} + {1'b0, xor_2267};
  logic [9:0] difference_2270;
  assign difference_2270 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2271;
  assign xor_2271 = difference_2270[8:0] ^ {9{difference_2270[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2292;
  assign sum_2292 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2294;
  assign sum_2294 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1142
  logic equal_2295;
  assign equal_2295 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2296;
  assign select_2296 = equal_2295 ? sum_2292 : moments_before_0_q;
  logic [13:0] select_2298;
  assign select_2298 = equal_2295 ? sum_2294 : moments_before_1_q;
  // hls/stages/agreement.hpp:788
  logic select_2301;
  assign select_2301 = equal_572_s2_q ? (moments_has_before_q | equal_2295) : moments_has_before_q;
  logic [13:0] select_2304;
  assign select_2304 = equal_572_s2_q ? ((select_2298 < select_2296) ? select_2296 : select_2298) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2305;
  assign sum_2305 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2308;
  assign select_2308 = equal_572_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2305)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2309;
  assign sum_2309 = {1'b0, sum_2294} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2312;
  assign select_2312 = equal_572_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2309)) : moments_left_alone_q;
  logic select_2315;
  assign select_2315 = equal_572_s2_q ? (~({3'h0, select_2298[13:2]} < sum_2309)) : moments_left_other_stops_q;
  logic select_2318;
  assign select_2318 = equal_572_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2305)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2319;
  assign sum_2319 = {1'b0, sum_2292} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2322;
  assign select_2322 = equal_572_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2319)) : moments_right_alone_q;
  logic select_2325;
  assign select_2325 = equal_572_s2_q ? (~({3'h0, select_2296[13:2]} < sum_2319)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2328;
  assign or_2328 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2336;
  assign and_2336 = not_573_s2_q & (not_575_s2_q & (equal_576_s2_q & (inside_v_s2_q & and_1595)));
  logic and_2340;
  assign and_2340 = not_573_s2_q & (not_575_s2_q & (equal_576_s2_q & (inside_v_s2_q & and_1604)));
  // hls/stages/moments.hpp:94
  logic and_2342;
  assign and_2342 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2345;
  assign select_2345 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2342)) : and_2342;
  // hls/stages/agreement.hpp:788
  logic and_2349;
  assign and_2349 = equal_572_s2_q & (equal_2295 & (cfg_prove_i & (cfg_same_table_i & select_2345)));
  // hls/stages/moments.hpp:95
  logic and_2352;
  assign and_2352 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2366;
  assign difference_2366 = {1'b0, select_553} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2366[9]} + (difference_2366[8:0] ^ {9{difference_2366[9]}});
  logic [9:0] difference_2378;
  assign difference_2378 = {1'b0, select_557} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2378[9]} + (difference_2378[8:0] ^ {9{difference_2378[9]}});
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2569;
  assign select_2569 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2570;
  assign select_2570 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2571;
  assign select_2571 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2572;
  assign select_2572 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2573;
  assign select_2573 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2574;
  assign select_2574 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2578;
  assign select_2578 = slot_s2_q[0] ? 8'h0 : sum_1009;
  // hls/stages/agreement.hpp:751
  logic less_2579;
  assign less_2579 = select_2578 < select_1509;
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2581;
  assign select_2581 = slot_s2_q[0] ? 7'h0 : sum_1535;
  // hls/stages/agreement.hpp:788
  logic not_2586;
  assign not_2586 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2587;
  assign less_2587 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_2594;
  assign and_2594 = and_547_s2_q & (equal_677_s2_q & equal_2469_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_2600;
  assign and_2600 = not_573_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2596_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_2620;
  assign and_2620 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2621;
  assign and_2621 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2622;
  assign and_2622 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2623;
  assign and_2623 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2625;
  assign sum_2625 = {1'b0, and_2622} + ({1'b0, explained} + {1'b0, and_2623});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2620} + ({2'h0, and_2621} + {1'b0, sum_2625});
  // hls/stages/agreement.hpp:788
  logic and_2661;
  assign and_2661 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2596_s2_q & and_2015)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2685;
  assign difference_2685 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2688;
  assign less_2688 = {2'h0, difference_2685[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_2691;
  assign and_2691 = not_581_s2_q & (((and_2013_s2_q & and_632) & equal_2681_s2_q) & (~less_2688));
  // hls/stages/agreement.hpp:788
  logic and_2695;
  assign and_2695 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_577_s2_q & and_2691)));
  // hls/stages/agreement.hpp:149
  logic and_2700;
  assign and_2700 = not_581_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2702;
  assign and_2702 = not_581_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2703;
  assign select_2703 = or_577_s2_q ? {and_2702, and_2700} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2705;
  assign select_2705 = less_580_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2706;
  assign select_2706 = or_577_s2_q ? select_2705 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_2708;
  assign and_2708 = and_634 & (select_2703[0] & select_2706[0]);
  // hls/stages/agreement.hpp:788
  logic and_2712;
  assign and_2712 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2703[1] & and_2708)));
  logic and_2713;
  assign and_2713 = not_573_s2_q & and_2712;
  logic and_2719;
  assign and_2719 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2706[1] & and_2708)));
  logic and_2720;
  assign and_2720 = not_573_s2_q & and_2719;
  // hls/stages/registration.hpp:76
  logic less_2723;
  assign less_2723 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2725;
  assign select_2725 = or_577_s2_q ? (less_580_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2727;
  assign select_2727 = or_577_s2_q ? (less_580_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2729;
  assign select_2729 = or_577_s2_q ? (less_580_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2727} - {1'b0, select_2729};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2731;
  assign select_2731 = rise_2[8] ? select_2727 : select_2729;
  logic [8:0] fall;
  assign fall = {1'b0, select_2725} - {1'b0, select_2731};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2734;
  assign not_2734 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2723 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2734};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2736;
  assign xor_2736 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2736};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2742;
  assign select_2742 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2723 ? {taken, 1'b1} : {not_2734, select_2742, not_2734};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2744;
  assign sum_2744 = {left, 1'b1} + {taken_2, less_2723};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2746;
  assign select_2746 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2748;
  assign select_2748 = equal_572_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_2750;
  assign select_2750 = equal_572_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2751;
  assign equal_2751 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_2755;
  assign and_2755 = and_634 & less_1697_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2757;
  assign select_2757 = or_577_s2_q ? (less_580_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2761;
  assign sum_2761 = select_2757[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2764;
  assign select_2764 = (select_2727 < select_2729) ? ({sum_2761, select_2757[0], 5'h0} - {3'h0, select_2746}) : {sum_2761, select_2757[0], select_2746};
  logic [7:0] select_2765;
  assign select_2765 = ((select_2757 == 3'h0) | (select_2757 == 3'h4)) ? {sum_2761, select_2757[0], 5'h0} : select_2764;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2765[7]}}, select_2765} - {sum_1716[9], sum_1716, sum_1712[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2768;
  assign select_2768 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2768[11:7])) ? 12'h7f : select_2768;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2789;
  assign difference_2789 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2791;
  assign and_2791 = and_2755 & ($signed(difference_2789) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2804;
  assign less_2804 = $signed(difference_2789) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_2812;
  assign select_2812 = so_s2_q ? (equal_2751 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2815;
  assign select_2815 = so_s2_q ? (equal_1698 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2820;
  assign select_2820 = (sum_1611 == 2'h2) ? (registration_fresh_q & (~select_1658)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2822;
  assign select_2822 = so_s2_q ? (and_1653 ? select_2820 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2824;
  assign select_2824 = and_2594 ? 4'hf : (equal_572_s2_q ? registration_fresh_q : select_2822);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1608;
  // hls/stages/registration.hpp:258
  logic not_2845;
  assign not_2845 = ~quarter_2[1];
  logic [3:0] select_2846;
  assign select_2846 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2845, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2845};
  // hls/stages/patches.hpp:91
  logic parity_2980;
  assign parity_2980 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2981;
  assign select_2981 = equal_2469_s2_q ? {patches_chance_q[14:0], parity_2980} : patches_chance_q;
  // hls/stages/patches.hpp:346
  logic not_2983;
  assign not_2983 = ~and_1772;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_2985;
  assign select_2985 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2985};
  // hls/stages/agreement.hpp:788
  logic and_2991;
  assign and_2991 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:157
  logic and_2995;
  assign and_2995 = not_2983 & (patches_fixed_q | ((not_573_s2_q & and_2991) & and_1744));
  // hls/stages/patches.hpp:355
  logic not_3007;
  assign not_3007 = ~select_1687[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3009;
  assign select_3009 = sample_pair_whole_s2_q ? (equal_1688 ? select_1687 : {not_3007, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:523
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:185
  logic [51:0] select_3108;
  assign select_3108 = or_1780_s2_q ? {and_1925_s2_q, and_1922_s2_q, and_1906_s2_q, and_1903, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3110;
  assign select_3110 = equal_1774_s2_q ? patches_codes_at_q : (equal_1776_s2_q ? other[55:4] : select_3108);
  // hls/stages/patches.hpp:506
  logic [27:0] word;
  assign word = or_1879_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:522
  logic [27:0] select_3113;
  assign select_3113 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:185
  logic [27:0] select_3115;
  assign select_3115 = equal_1776_s2_q ? (new_row_s2_q ? word : select_3113) : patches_codes_further_q;
  // hls/stages/patches.hpp:524
  logic [55:0] select_3117;
  assign select_3117 = less_1866_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:494
  logic [55:0] select_3119;
  assign select_3119 = less_3118_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:185
  logic [55:0] select_3121;
  assign select_3121 = or_1780_s2_q ? (equal_1779_s2_q ? patches_next_codes_q : select_3119) : patches_next_codes_q;
  logic [55:0] select_3123;
  assign select_3123 = equal_1774_s2_q ? patches_next_codes_q : (equal_1776_s2_q ? select_3117 : select_3121);
  // hls/stages/count_bits.hpp:24
  logic parity_3128;
  assign parity_3128 = ^{and_1925_s2_q, and_1922_s2_q, and_1906_s2_q, and_1903};
  // hls/stages/count_bits.hpp:25
  logic or_3132;
  assign or_3132 = ({and_1906_s2_q, and_1903} == 2'h3) | (and_1922_s2_q & (and_1906_s2_q | and_1903));
  logic and_3133;
  assign and_3133 = and_1925_s2_q & (^{and_1922_s2_q, and_1906_s2_q, and_1903});
  // hls/stages/count_bits.hpp:24
  logic xor_3134;
  assign xor_3134 = or_3132 ^ and_3133;
  // hls/stages/count_bits.hpp:27
  logic and_3135;
  assign and_3135 = or_3132 & and_3133;
  // hls/stages/patches.hpp:185
  logic [2:0] select_3137;
  assign select_3137 = or_1780_s2_q ? (and_1948_s2_q ? {and_3135, xor_3134, parity_3128} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3141;
  assign sum_3141 = {7'h0, patches_set_q} + (equal_1779_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:523
  logic [47:0] select_3151;
  assign select_3151 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:185
  logic [47:0] select_3153;
  assign select_3153 = equal_1774_s2_q ? patches_left_row_q : (equal_1776_s2_q ? select_3151 : patches_left_row_q);
  // hls/stages/patches.hpp:525
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3151;
  // hls/stages/count_bits.hpp:24
  logic xor_3157;
  assign xor_3157 = bits[17] ^ (^{select_3151[16:15], other[16:15]});
  logic xor_3160;
  assign xor_3160 = bits[11] ^ (^{select_3151[10:9], other[10:9]});
  logic xor_3163;
  assign xor_3163 = bits[14] ^ (^{select_3151[13:12], other[13:12]});
  logic xor_3166;
  assign xor_3166 = xor_3157 ^ (^{select_3151[14:9], other[14:9]});
  logic xor_3169;
  assign xor_3169 = bits[47] ^ (^{select_3151[46:45], other[46:45]});
  logic xor_3172;
  assign xor_3172 = bits[8] ^ (^{select_3151[7:6], other[7:6]});
  logic xor_3175;
  assign xor_3175 = bits[2] ^ (^{select_3151[1:0], other[1:0]});
  logic xor_3178;
  assign xor_3178 = bits[5] ^ (^{select_3151[4:3], other[4:3]});
  logic xor_3181;
  assign xor_3181 = xor_3172 ^ (^{select_3151[5:0], other[5:0]});
  logic parity_3183;
  assign parity_3183 = ^{select_3151[47:45], select_3151[8:0], other[47:45], other[8:0]};
  logic xor_3184;
  assign xor_3184 = xor_3166 ^ parity_3183;
  logic xor_3187;
  assign xor_3187 = bits[44] ^ (^{select_3151[43:42], other[43:42]});
  logic xor_3190;
  assign xor_3190 = bits[38] ^ (^{select_3151[37:36], other[37:36]});
  logic xor_3193;
  assign xor_3193 = bits[41] ^ (^{select_3151[40:39], other[40:39]});
  logic xor_3199;
  assign xor_3199 = bits[26] ^ (^{select_3151[25:24], other[25:24]});
  logic xor_3202;
  assign xor_3202 = bits[20] ^ (^{select_3151[19:18], other[19:18]});
  logic xor_3205;
  assign xor_3205 = bits[23] ^ (^{select_3151[22:21], other[22:21]});
  logic xor_3208;
  assign xor_3208 = xor_3199 ^ (^{select_3151[23:18], other[23:18]});
  logic xor_3211;
  assign xor_3211 = bits[35] ^ (^{select_3151[34:33], other[34:33]});
  logic xor_3214;
  assign xor_3214 = bits[29] ^ (^{select_3151[28:27], other[28:27]});
  logic xor_3217;
  assign xor_3217 = bits[32] ^ (^{select_3151[31:30], other[31:30]});
  logic xor_3220;
  assign xor_3220 = xor_3211 ^ (^{select_3151[32:27], other[32:27]});
  logic xor_3221;
  assign xor_3221 = xor_3208 ^ xor_3220;
  // hls/stages/count_bits.hpp:25
  logic or_3229;
  assign or_3229 = (xor_3160 & xor_3163) | (xor_3157 & (xor_3160 | xor_3163));
  logic or_3233;
  assign or_3233 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3237;
  assign or_3237 = (xor_3175 & xor_3178) | (xor_3172 & (xor_3175 | xor_3178));
  // hls/stages/count_bits.hpp:23
  logic or_3244;
  assign or_3244 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3248;
  assign or_3248 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3252;
  assign or_3252 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3255;
  assign parity_3255 = ^{or_3252, or_3248, or_3244};
  // hls/stages/count_bits.hpp:23
  logic or_3259;
  assign or_3259 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3263;
  assign or_3263 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3267;
  assign or_3267 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3270;
  assign parity_3270 = ^{or_3267, or_3263, or_3259};
  logic parity_3273;
  assign parity_3273 = ^{or_3267, or_3263, or_3259, or_3252, or_3248, or_3244, or_3237, or_3233, or_3229};
  // hls/stages/count_bits.hpp:23
  logic or_3277;
  assign or_3277 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3281;
  assign or_3281 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3285;
  assign or_3285 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3293;
  assign or_3293 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3297;
  assign or_3297 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3301;
  assign or_3301 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3304;
  assign parity_3304 = ^{or_3301, or_3297, or_3293};
  // hls/stages/count_bits.hpp:23
  logic or_3308;
  assign or_3308 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3312;
  assign or_3312 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3316;
  assign or_3316 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3319;
  assign parity_3319 = ^{or_3316, or_3312, or_3308};
  logic parity_3322;
  assign parity_3322 = ^{or_3316, or_3312, or_3308, or_3301, or_3297, or_3293, or_3285, or_3281, or_3277};
  // hls/stages/count_bits.hpp:25
  logic or_3326;
  assign or_3326 = (xor_3190 & xor_3193) | (xor_3187 & (xor_3190 | xor_3193));
  logic or_3330;
  assign or_3330 = (xor_3202 & xor_3205) | (xor_3199 & (xor_3202 | xor_3205));
  logic or_3334;
  assign or_3334 = (xor_3214 & xor_3217) | (xor_3211 & (xor_3214 | xor_3217));
  // hls/stages/count_bits.hpp:24
  logic parity_3337;
  assign parity_3337 = ^{or_3334, or_3330, or_3326};
  // hls/stages/count_bits.hpp:25
  logic and_3338;
  assign and_3338 = xor_3184 & (^{xor_3221, select_3151[44:36], other[44:36]});
  logic or_3342;
  assign or_3342 = (xor_3169 & xor_3181) | (xor_3166 & (xor_3169 | xor_3181));
  logic and_3345;
  assign and_3345 = (xor_3187 ^ (^{select_3151[41:36], other[41:36]})) & (xor_3208 | xor_3220);
  logic or_3346;
  assign or_3346 = (xor_3208 & xor_3220) | and_3345;
  // hls/stages/count_bits.hpp:24
  logic parity_3349;
  assign parity_3349 = ^{or_3346, or_3342, and_3338};
  logic parity_3352;
  assign parity_3352 = ^{or_3346, or_3342, and_3338, or_3334, or_3330, or_3326, or_3316, or_3312, or_3308, or_3301, or_3297, or_3293, or_3285, or_3281, or_3277};
  logic parity_3354;
  assign parity_3354 = ^{or_3346, or_3342, and_3338, or_3334, or_3330, or_3326, or_3316, or_3312, or_3308, or_3301, or_3297, or_3293, or_3285, or_3281, or_3277, or_3267, or_3263, or_3259, or_3252, or_3248, or_3244, or_3237, or_3233, or_3229};
  // hls/stages/count_bits.hpp:25
  logic and_3355;
  assign and_3355 = parity_3273 & parity_3352;
  logic or_3359;
  assign or_3359 = (parity_3255 & parity_3270) | ((^{or_3237, or_3233, or_3229}) & (parity_3255 | parity_3270));
  logic or_3363;
  assign or_3363 = (parity_3337 & parity_3349) | (parity_3322 & (parity_3337 | parity_3349));
  logic or_3370;
  assign or_3370 = (parity_3304 & parity_3319) | ((^{or_3285, or_3281, or_3277}) & (parity_3304 | parity_3319));
  logic or_3374;
  assign or_3374 = (or_3330 & or_3334) | (or_3326 & (or_3330 | or_3334));
  logic or_3378;
  assign or_3378 = (or_3342 & or_3346) | (and_3338 & (or_3342 | or_3346));
  // hls/stages/count_bits.hpp:23
  logic or_3385;
  assign or_3385 = (or_3281 & or_3285) | (or_3277 & (or_3281 | or_3285));
  // hls/stages/count_bits.hpp:25
  logic or_3389;
  assign or_3389 = (or_3297 & or_3301) | (or_3293 & (or_3297 | or_3301));
  logic or_3393;
  assign or_3393 = (or_3312 & or_3316) | (or_3308 & (or_3312 | or_3316));
  // hls/stages/count_bits.hpp:24
  logic parity_3396;
  assign parity_3396 = ^{or_3393, or_3389, or_3385};
  // hls/stages/count_bits.hpp:23
  logic or_3400;
  assign or_3400 = (or_3233 & or_3237) | (or_3229 & (or_3233 | or_3237));
  // hls/stages/count_bits.hpp:25
  logic or_3404;
  assign or_3404 = (or_3248 & or_3252) | (or_3244 & (or_3248 | or_3252));
  logic or_3408;
  assign or_3408 = (or_3263 & or_3267) | (or_3259 & (or_3263 | or_3267));
  // hls/stages/count_bits.hpp:24
  logic parity_3411;
  assign parity_3411 = ^{or_3408, or_3404, or_3400};
  logic parity_3414;
  assign parity_3414 = ^{or_3408, or_3404, or_3400, or_3393, or_3389, or_3385, or_3378, or_3374, or_3370};
  logic parity_3416;
  assign parity_3416 = ^{or_3408, or_3404, or_3400, or_3393, or_3389, or_3385, or_3378, or_3374, or_3370, or_3363, or_3359, and_3355};
  // hls/stages/count_bits.hpp:25
  logic or_3420;
  assign or_3420 = (or_3374 & or_3378) | (or_3370 & (or_3374 | or_3378));
  logic or_3424;
  assign or_3424 = (or_3389 & or_3393) | (or_3385 & (or_3389 | or_3393));
  logic or_3428;
  assign or_3428 = (or_3404 & or_3408) | (or_3400 & (or_3404 | or_3408));
  // hls/stages/count_bits.hpp:24
  logic parity_3431;
  assign parity_3431 = ^{or_3428, or_3424, or_3420};
  // hls/stages/count_bits.hpp:25
  logic and_3432;
  assign and_3432 = (^{or_3363, or_3359, and_3355}) & parity_3414;
  logic or_3436;
  assign or_3436 = (or_3359 & or_3363) | (and_3355 & (or_3359 | or_3363));
  logic or_3440;
  assign or_3440 = (parity_3396 & parity_3411) | ((^{or_3378, or_3374, or_3370}) & (parity_3396 | parity_3411));
  // hls/stages/count_bits.hpp:24
  logic parity_3443;
  assign parity_3443 = ^{or_3440, or_3436, and_3432};
  // hls/stages/count_bits.hpp:25
  logic and_3445;
  assign and_3445 = parity_3431 & parity_3443;
  logic or_3449;
  assign or_3449 = (or_3424 & or_3428) | (or_3420 & (or_3424 | or_3428));
  logic or_3453;
  assign or_3453 = (or_3436 & or_3440) | (and_3432 & (or_3436 | or_3440));
  // hls/stages/patches.hpp:185
  logic [4:0] select_3498;
  assign select_3498 = equal_1776_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3501;
  assign select_3501 = equal_1774_s2_q ? patches_summed_first_q : (equal_1776_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:557
  logic [9:0] select_3508;
  assign select_3508 = less_1954_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3511;
  assign select_3511 = equal_1957_s2_q ? (less_1954_s2_q ? (equal_1957_s2_q ? 10'h0 : select_3508) : 10'h0) : select_3508;
  logic [9:0] select_3513;
  assign select_3513 = less_1954_s2_q ? (equal_1955_s2_q ? 10'h0 : select_3511) : select_3511;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3515;
  assign select_3515 = less_1954_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3518;
  assign select_3518 = equal_1957_s2_q ? (less_1954_s2_q ? (equal_1957_s2_q ? 5'h0 : select_3515) : 5'h0) : select_3515;
  logic [4:0] select_3520;
  assign select_3520 = less_1954_s2_q ? (equal_1955_s2_q ? 5'h0 : select_3518) : select_3518;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3522;
  assign select_3522 = less_1954_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3525;
  assign select_3525 = equal_1957_s2_q ? (less_1954_s2_q ? (equal_1957_s2_q ? 5'h0 : select_3522) : 5'h0) : select_3522;
  logic [4:0] select_3527;
  assign select_3527 = less_1954_s2_q ? (equal_1955_s2_q ? 5'h0 : select_3525) : select_3525;
  // hls/stages/patches.hpp:557
  logic and_3530;
  assign and_3530 = less_1954_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:561
  logic select_3533;
  assign select_3533 = equal_1957_s2_q ? (less_1954_s2_q ? (not_1958_s2_q & and_3530) : and_3530) : and_3530;
  // hls/stages/patches.hpp:185
  logic select_3536;
  assign select_3536 = equal_1774_s2_q ? (less_1954_s2_q ? (not_1956_s2_q & select_3533) : select_3533) : patches_read_first_q;
  // hls/stages/patches.hpp:179
  logic or_3547;
  assign or_3547 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3548;
  assign and_3548 = patches_read_searches_s2_q & or_3547;
  // hls/stages/patches.hpp:541
  logic [4:0] select_3549;
  assign select_3549 = and_3548 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:548
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3549};
  // hls/stages/patches.hpp:557
  logic and_3553;
  assign and_3553 = less_1954_s2_q & (equal_3545_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:561
  logic select_3556;
  assign select_3556 = equal_1957_s2_q ? (less_1954_s2_q ? (not_1958_s2_q & and_3553) : and_3553) : and_3553;
  // hls/stages/patches.hpp:185
  logic select_3559;
  assign select_3559 = equal_1774_s2_q ? (less_1954_s2_q ? (not_1956_s2_q & select_3556) : select_3556) : patches_read_above_q;
  // hls/stages/patches.hpp:557
  logic and_3562;
  assign and_3562 = less_1954_s2_q & (equal_3545_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:561
  logic select_3565;
  assign select_3565 = equal_1957_s2_q ? (less_1954_s2_q ? (not_1958_s2_q & and_3562) : and_3562) : and_3562;
  // hls/stages/patches.hpp:185
  logic select_3568;
  assign select_3568 = equal_1774_s2_q ? (less_1954_s2_q ? (not_1956_s2_q & select_3565) : select_3565) : patches_read_below_q;
  // hls/stages/patches.hpp:554
  logic [6:0] sum_3569;
  assign sum_3569 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3572;
  assign select_3572 = (equal_3545_s2_q & ({sum_3569[6], sum_3569} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3573;
  assign select_3573 = less_1954_s2_q ? select_3572 : 10'h3ff;
  // hls/stages/patches.hpp:558
  logic [9:0] select_3575;
  assign select_3575 = less_1954_s2_q ? (equal_1957_s2_q ? 10'h3ff : select_3573) : 10'h3ff;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3576;
  assign select_3576 = equal_1957_s2_q ? select_3575 : select_3573;
  logic [9:0] select_3578;
  assign select_3578 = less_1954_s2_q ? (equal_1955_s2_q ? 10'h3ff : select_3576) : select_3576;
  // hls/stages/patches.hpp:540
  logic [14:0] select_3580;
  assign select_3580 = and_3548 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:185
  logic [9:0] select_3581;
  assign select_3581 = equal_1774_s2_q ? select_3580[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3582;
  assign select_3582 = equal_1774_s2_q ? select_3580[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3584;
  assign select_3584 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3586;
  assign select_3586 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3589;
  assign select_3589 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3590;
  assign select_3590 = patches_read_first_q ? patches_read_far_q : select_3589;
  // hls/stages/patches.hpp:595
  logic [9:0] difference_3593;
  assign difference_3593 = select_3590 - select_3580[9:0];
  // hls/stages/patches.hpp:580
  logic less_3623;
  assign less_3623 = select_3584 < select_3586;
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3624;
  assign sum_3624 = select_3549[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3623 ? select_3586 : select_3584;
  logic [9:0] low;
  assign low = (select_3586 < select_3584) ? select_3586 : select_3584;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3580[9:0];
  // hls/stages/patches.hpp:584
  logic not_3631;
  assign not_3631 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3632;
  assign sum_3632 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3634;
  assign not_3634 = ~({eight, 3'h0} < {1'b0, sum_3632, fall_2[0]});
  logic [1:0] sum_3635;
  assign sum_3635 = {1'b0, not_3631} + {1'b0, not_3634};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3636;
  assign sum_3636 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3638;
  assign not_3638 = ~({eight, 3'h0} < {sum_3636, fall_2[1:0]});
  logic not_3641;
  assign not_3641 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3642;
  assign sum_3642 = {1'b0, not_3638} + {1'b0, not_3641};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3635} + {1'b0, sum_3642};
  // hls/stages/patches.hpp:587
  logic [7:0] select_3645;
  assign select_3645 = less_3623 ? ({sum_3624, select_3549[2:0], 3'h0} - {5'h0, fraction}) : {sum_3624, select_3549[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_3868;
  assign select_3868 = equal_572_s2_q ? shown_shown_q : (so_s2_q ? select_2025 : shown_shown_q);
  logic select_3870;
  assign select_3870 = equal_572_s2_q ? shown_nearer_q : (so_s2_q ? select_2028 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3872;
  assign sum_3872 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3874;
  assign select_3874 = less_3871_s2_q ? (sum_3872[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3876;
  assign select_3876 = equal_2469_s2_q ? (equal_677_s2_q ? 3'h0 : select_3874) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3881;
  assign select_3881 = equal_572_s2_q ? select_1979 : (so_s2_q ? (ends_cell_s2_q ? select_2078 : select_1979) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3895;
  assign select_3895 = equal_677_s2_q ? {{2{difference_3893[6]}}, difference_3893} : (less_3871_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3897;
  assign select_3897 = and_547_s2_q ? (equal_2469_s2_q ? select_3895 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_3899;
  assign select_3899 = equal_677_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_3901;
  assign select_3901 = and_547_s2_q ? (equal_2469_s2_q ? select_3899 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3902;
  assign sum_3902 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3903;
  assign select_3903 = sum_3872[7] ? {1'b1, sum_3872[6:0], region_down_rest_q[0]} : sum_3902;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3872[7];
  // hls/stages/agreement.hpp:460
  logic select_3907;
  assign select_3907 = equal_2469_s2_q ? (equal_677_s2_q | (less_3871_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3912;
  assign or_3912 = segment_starts_q | not_575_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_3915;
  assign select_3915 = inside_v_s2_q ? (sum_1992_s2_q ? (equal_1767 & or_1994) : or_1994) : or_3912;
  // hls/stages/agreement.hpp:788
  logic select_3918;
  assign select_3918 = equal_572_s2_q ? or_3912 : (so_s2_q ? (ends_cell_s2_q ? select_3915 : or_3912) : or_3912);
  // hls/stages/agreement.hpp:1147
  logic equal_3942;
  assign equal_3942 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4078;
  assign select_4078 = so_s2_q ? (ends_cell_s2_q ? and_2066 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4081;
  assign select_4081 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4083;
  assign select_4083 = equal_572_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4081 : centres_values_0_of_skin_q);
  logic select_4084;
  assign select_4084 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4086;
  assign select_4086 = equal_572_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4084 : centres_values_1_textured_q);
  logic select_4087;
  assign select_4087 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4089;
  assign select_4089 = equal_572_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4087 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [10:0] select_4093;
  assign select_4093 = equal_2469_s2_q ? (equal_4090_s2_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [5:0] select_4096;
  assign select_4096 = and_547_s2_q ? (equal_2469_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1271
  logic xor_4097;
  assign xor_4097 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:438
  logic select_4099;
  assign select_4099 = and_1971_s2_q ? (left_first_s2_q ? xor_4097 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:278
  logic select_4101;
  assign select_4101 = and_1971_s2_q ? (left_first_s2_q ? xor_4097 : select_4099) : write_half_q;
  logic select_4103;
  assign select_4103 = left_first_s2_q ? select_2031 : (and_1971_s2_q ? select_2032 : read_half_q);
  logic and_4107;
  assign and_4107 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_4116;
  assign select_4116 = left_first_s2_q ? 10'h1 : (and_1971_s2_q ? select_2036 : rows_passed_q);
  logic [8:0] select_4119;
  assign select_4119 = left_first_s2_q ? {select_2034[7:0], or_2033} : (and_1971_s2_q ? {select_2034[7:0], or_2033} : columns_passed_q);
  logic select_4122;
  assign select_4122 = left_first_s2_q ? marks_last_s2_q : (and_1971_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4125;
  assign select_4125 = left_first_s2_q ? and_2050 : (and_1971_s2_q ? and_2050 : began_q);
  logic [2:0] select_4128;
  assign select_4128 = left_first_s2_q ? select_2052 : (and_1971_s2_q ? select_2052 : seen_x_q);
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4133;
  assign select_4133 = left_first_s2_q ? 3'h0 : (and_2037 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:278
  logic [2:0] select_4135;
  assign select_4135 = left_first_s2_q ? 3'h0 : (and_1971_s2_q ? select_4133 : seen_y_q);
  logic [7:0] select_4138;
  assign select_4138 = left_first_s2_q ? select_2045 : (and_1971_s2_q ? select_2045 : seen_column_q);
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4144;
  assign select_4144 = left_first_s2_q ? select_4142 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:278
  logic [7:0] select_4146;
  assign select_4146 = left_first_s2_q ? select_4142 : (and_1971_s2_q ? select_4144 : seen_rows_left_q);
  // hls/stages/agreement.hpp:436
  logic and_4151;
  assign and_4151 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:278
  logic select_4153;
  assign select_4153 = left_first_s2_q ? and_4151 : (and_1971_s2_q ? and_4151 : at_cell_end_q);
  logic select_4156;
  assign select_4156 = left_first_s2_q ? next_row : (and_1971_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4159;
  assign select_4159 = left_first_s2_q ? 11'h0 : (and_1971_s2_q ? select_2042 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4232;
  assign not_4232 = ~quarter[1];
  logic [3:0] select_4233;
  assign select_4233 = quarter[0] ? {quarter[1], 1'b0, not_4232, 1'b0} : {1'b0, quarter[1], 1'b0, not_4232};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1612;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1655;
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
  assign patches_choices_raddr = select_1686;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1688));
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
  assign regions_raddr = select_1989;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s2_en & (equal_572_s2_q ? (x_s2_q[6] & not_1990) : and_1997);
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
  assign map_raddr = sum_2047;
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s2_en & select_2059;
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_512_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_521_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_540, and_536, sum_532, sum_528};
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
  assign census_memory_we = s2_en & and_547_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_565, whole_2, select_557, select_553};
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
  assign moments_memory_waddr = select_571_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_589_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_644_s2_q, and_642_s2_q, and_637_s2_q, and_635};
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
  assign best_left_we = s2_en & and_1559_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1558, select_1555, select_1552, select_1550, select_1532, select_1529, select_1521, select_1520, select_1515};
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
  assign best_right_we = s2_en & and_1559_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1569, select_1568, select_1565, select_1564};
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
  assign shown_right_waddr = select_1576_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1587;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1584, not_575_s2_q};
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
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1595, and_1592};
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
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1604, and_1601};
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
  assign patches_right_codes_waddr = {sum_1887, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1939_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1925_s2_q, and_1922_s2_q, and_1906_s2_q, and_1903, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1943, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1953_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1925_s2_q, and_1922_s2_q, and_1906_s2_q, and_1903, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_1572_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2024, textured};
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
      averager_running_of_skin_q <= select_2193;
      averager_mask_q <= select_2195;
      averager_of_skin_q <= select_2197;
      census_filled_q <= and_547_s2_q ? {select_680[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2292;
      moments_turned_1_q <= sum_2294;
      moments_before_0_q <= equal_572_s2_q ? select_2296 : moments_before_0_q;
      moments_before_1_q <= equal_572_s2_q ? select_2298 : moments_before_1_q;
      moments_has_before_q <= select_2301;
      moments_most_before_q <= select_2304;
      moments_left_begins_q <= select_2308;
      moments_left_alone_q <= select_2312;
      moments_left_other_stops_q <= select_2315;
      moments_right_begins_q <= select_2318;
      moments_right_alone_q <= select_2322;
      moments_right_other_stops_q <= select_2325;
      moments_out_of_step_q <= or_2328;
      moments_turns_0_q <= and_2336;
      moments_turns_1_q <= and_2340;
      moments_begins_alone_q <= and_2349;
      moments_ends_q <= equal_572_s2_q & (equal_2295 & (not_2350 | and_2352));
      rows_passed_above_q <= and_547_s2_q ? select_679 : rows_passed_above_q;
      chosen_score_q <= less_2579 ? select_1509 : select_2578;
      chosen_near_q <= (select_2581 < select_1544) ? select_1544 : select_2581;
      chosen_place_q <= less_2579 ? {select_1517, not_1516} : 3'h2;
      before_0_q <= select_2578;
      before_1_q <= sum_1259;
      before_2_q <= sum_1507;
      shift_allowed_q <= not_2586 & (~less_2587);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2594 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2713});
      counts_turned_right_q <= and_2594 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2720});
      registration_displacement_over_q <= so_s2_q ? sum_2744[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2746;
      registration_slope_here_q <= select_2748;
      registration_expected_q <= select_2750;
      registration_of_right_q <= equal_572_s2_q ? registration_of_right_q : select_2812;
      registration_was_inside_q <= equal_572_s2_q ? registration_was_inside_q : select_2815;
      registration_fresh_q <= select_2824;
      patches_chance_q <= and_547_s2_q ? select_2981 : patches_chance_q;
      patches_fixed_q <= and_2995;
      patches_choice_valid_q <= and_1772 ? (select_1745 & not_2983) : select_1745;
      patches_choice_column_q <= select_1750;
      patches_choice_shift_q <= select_1755;
      patches_choice_slope_q <= select_1766;
      patches_band_q <= sample_pair_whole_s2_q ? select_1787 : patches_band_q;
      patches_fetch_q <= select_3009;
      patches_codes_at_q <= select_3110;
      patches_codes_further_q <= equal_1774_s2_q ? patches_codes_further_q : select_3115;
      patches_next_codes_q <= select_3123;
      patches_set_q <= equal_1774_s2_q ? 3'h0 : (equal_1776_s2_q ? 3'h0 : select_3137);
      patches_size_q <= sum_3141;
      patches_left_row_q <= select_3153;
      patches_summed_row_column_q <= equal_1774_s2_q ? patches_summed_row_column_q : select_3498;
      patches_summed_first_q <= select_3501;
      patches_read_row_differing_q <= equal_1774_s2_q ? select_3513 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1774_s2_q ? select_3520 : patches_read_row_column_q;
      patches_read_at_q <= equal_1774_s2_q ? select_3527 : patches_read_at_q;
      patches_read_first_q <= select_3536;
      patches_read_above_q <= select_3559;
      patches_read_below_q <= select_3568;
      patches_read_far_q <= equal_1774_s2_q ? select_3578 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3581;
      patches_peak_best_column_q <= select_3582;
      patches_peak_row_q <= equal_1774_s2_q ? select_3549 : patches_peak_row_q;
      patches_peak_above_q <= equal_1774_s2_q ? select_3584 : patches_peak_above_q;
      patches_peak_below_q <= equal_1774_s2_q ? select_3586 : patches_peak_below_q;
      patches_peak_far_q <= equal_1774_s2_q ? select_3590 : patches_peak_far_q;
      patches_frame_ended_q <= equal_572_s2_q & equal_2295;
      shown_shown_q <= select_3868;
      shown_nearer_q <= select_3870;
      region_row_q <= and_547_s2_q ? select_3876 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3881;
      region_down_rest_q <= select_3897;
      region_down_back_q <= select_3901;
      region_down_next_q <= select_3903;
      region_fresh_q <= and_547_s2_q ? select_3907 : region_fresh_q;
      segment_starts_q <= select_3918;
      centres_values_0_textured_q <= equal_572_s2_q ? centres_values_0_textured_q : select_4078;
      centres_values_0_of_skin_q <= select_4083;
      centres_values_1_textured_q <= select_4086;
      centres_values_1_of_skin_q <= select_4089;
      map_row_q <= and_547_s2_q ? select_4093 : map_row_q;
      map_width_q <= select_4096;
      write_half_q <= select_4101;
      read_half_q <= and_1971_s2_q ? select_4103 : read_half_q;
      done_q <= and_1971_s2_q ? (not_2048 & and_4107) : and_4107;
      drew_q <= so_s2_q;
      said_q <= equal_572_s2_q & equal_3942;
      rows_passed_q <= and_1971_s2_q ? select_4116 : rows_passed_q;
      columns_passed_q <= and_1971_s2_q ? select_4119 : columns_passed_q;
      line_ended_q <= and_1971_s2_q ? select_4122 : line_ended_q;
      began_q <= and_1971_s2_q ? select_4125 : began_q;
      seen_x_q <= and_1971_s2_q ? select_4128 : seen_x_q;
      seen_y_q <= and_1971_s2_q ? select_4135 : seen_y_q;
      seen_column_q <= and_1971_s2_q ? select_4138 : seen_column_q;
      seen_rows_left_q <= and_1971_s2_q ? select_4146 : seen_rows_left_q;
      at_cell_end_q <= and_1971_s2_q ? select_4153 : at_cell_end_q;
      was_next_row_q <= and_1971_s2_q ? select_4156 : was_next_row_q;
      seen_base_q <= and_1971_s2_q ? select_4159 : seen_base_q;
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
      left_pixel_q <= and_1971_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_524 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_530 : averager_running_1_q;
      averager_total_0_q <= select_2171;
      averager_total_1_q <= select_2173;
      census_columns_values_0_cell_0_left_q <= select_2198;
      census_columns_values_0_cell_0_right_q <= select_2199;
      census_columns_values_0_cell_0_mask_q <= and_547_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2201;
      census_columns_values_0_cell_1_right_q <= select_2202;
      census_columns_values_0_cell_1_mask_q <= select_2203;
      census_columns_values_0_cell_2_left_q <= select_2204;
      census_columns_values_0_cell_2_right_q <= select_2205;
      census_columns_values_0_cell_2_mask_q <= select_2206;
      census_columns_values_0_cell_2_of_skin_q <= select_2207;
      census_columns_values_0_cell_3_left_q <= select_2208;
      census_columns_values_0_cell_3_right_q <= select_2209;
      census_columns_values_0_cell_3_mask_q <= select_2210;
      census_columns_values_0_cell_4_left_q <= select_2211;
      census_columns_values_0_cell_4_right_q <= select_2212;
      census_columns_values_0_cell_4_mask_q <= select_2213;
      census_columns_values_1_cell_0_left_q <= select_2214;
      census_columns_values_1_cell_0_right_q <= select_2215;
      census_columns_values_1_cell_0_mask_q <= select_2216;
      census_columns_values_1_cell_1_left_q <= select_2217;
      census_columns_values_1_cell_1_right_q <= select_2218;
      census_columns_values_1_cell_1_mask_q <= select_2219;
      census_columns_values_1_cell_2_left_q <= select_2220;
      census_columns_values_1_cell_2_right_q <= select_2221;
      census_columns_values_1_cell_2_mask_q <= select_2222;
      census_columns_values_1_cell_2_of_skin_q <= select_2223;
      census_columns_values_1_cell_3_left_q <= select_2224;
      census_columns_values_1_cell_3_right_q <= select_2225;
      census_columns_values_1_cell_3_mask_q <= select_2226;
      census_columns_values_1_cell_4_left_q <= select_2227;
      census_columns_values_1_cell_4_right_q <= select_2228;
      census_columns_values_1_cell_4_mask_q <= select_2229;
      census_columns_values_2_cell_0_left_q <= select_2230;
      census_columns_values_2_cell_0_right_q <= select_2231;
      census_columns_values_2_cell_0_mask_q <= select_2232;
      census_columns_values_2_cell_1_left_q <= select_2233;
      census_columns_values_2_cell_1_right_q <= select_2234;
      census_columns_values_2_cell_1_mask_q <= select_2235;
      census_columns_values_2_cell_2_left_q <= select_2236;
      census_columns_values_2_cell_2_right_q <= select_2237;
      census_columns_values_2_cell_2_mask_q <= select_2238;
      census_columns_values_2_cell_3_left_q <= select_2239;
      census_columns_values_2_cell_3_right_q <= select_2240;
      census_columns_values_2_cell_3_mask_q <= select_2241;
      census_columns_values_2_cell_4_left_q <= select_2242;
      census_columns_values_2_cell_4_right_q <= select_2243;
      census_columns_values_2_cell_4_mask_q <= select_2244;
      census_columns_values_3_cell_0_mask_q <= select_2245;
      census_columns_values_3_cell_1_left_q <= select_2246;
      census_columns_values_3_cell_1_right_q <= select_2247;
      census_columns_values_3_cell_1_mask_q <= select_2248;
      census_columns_values_3_cell_2_mask_q <= select_2249;
      census_columns_values_3_cell_3_left_q <= select_2250;
      census_columns_values_3_cell_3_right_q <= select_2251;
      census_columns_values_3_cell_3_mask_q <= select_2252;
      census_columns_values_3_cell_4_mask_q <= select_2253;
      sharpness_last_mean_0_q <= and_547_s2_q ? select_553 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_547_s2_q ? select_557 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_s2_q;
      middle_sum_columns_values_1_q <= select_2569;
      middle_sum_columns_values_2_q <= select_2570;
      middle_sum_columns_values_3_q <= select_2571;
      middle_sum_columns_values_4_q <= select_2572;
      middle_sum_columns_values_5_q <= select_2573;
      middle_sum_columns_values_6_q <= select_2574;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_1009;
      sums_0_sum_sums_values_0_q <= sum_1259;
      sums_0_sum_sums_values_1_q <= equal_1257 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1507;
      sums_1_sum_sums_values_1_q <= equal_1257 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [2:0] select_508_s3_q;
  logic row_starts_s3_q;
  logic [5:0] select_541_s3_q;
  logic [5:0] last_s3_q;
  logic and_545_s3_q;
  logic and_547_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_550_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_567_s3_q;
  logic equal_572_s3_q;
  logic not_573_s3_q;
  logic less_650_s3_q;
  logic less_651_s3_q;
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
  logic and_681_s3_q;
  logic and_706_s3_q;
  logic and_707_s3_q;
  logic [11:0] sum_722_s3_q;
  logic [9:0] sum_725_s3_q;
  logic and_733_s3_q;
  logic and_737_s3_q;
  logic less_738_s3_q;
  logic less_742_s3_q;
  logic less_744_s3_q;
  logic equal_1605_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1611_s3_q;
  logic equal_1613_s3_q;
  logic equal_1615_s3_q;
  logic equal_1617_s3_q;
  logic equal_1619_s3_q;
  logic equal_1621_s3_q;
  logic equal_1623_s3_q;
  logic equal_1625_s3_q;
  logic equal_1627_s3_q;
  logic less_1636_s3_q;
  logic or_1640_s3_q;
  logic equal_1660_s3_q;
  logic and_1670_s3_q;
  logic select_1687_s3_q;
  logic equal_1688_s3_q;
  logic and_1696_s3_q;
  logic equal_1698_s3_q;
  logic select_1745_s3_q;
  logic and_1773_s3_q;
  logic equal_1774_s3_q;
  logic equal_1776_s3_q;
  logic and_1789_s3_q;
  logic [4:0] select_1804_s3_q;
  logic select_1810_s3_q;
  logic [3:0] select_1850_s3_q;
  logic less_1954_s3_q;
  logic equal_1955_s3_q;
  logic not_1956_s3_q;
  logic equal_1957_s3_q;
  logic and_1971_s3_q;
  logic select_1973_s3_q;
  logic and_1976_s3_q;
  logic or_1982_s3_q;
  logic or_1985_s3_q;
  logic or_1988_s3_q;
  logic not_1990_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2017_s3_q;
  logic and_2022_s3_q;
  logic and_2054_s3_q;
  logic less_2055_s3_q;
  logic [11:0] sum_2063_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2081_s3_q;
  logic or_2084_s3_q;
  logic or_2087_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2137_s3_q;
  logic [11:0] sum_2269_s3_q;
  logic [9:0] sum_2272_s3_q;
  logic equal_2280_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2594_s3_q;
  logic and_2600_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2662_s3_q;
  logic and_2696_s3_q;
  logic and_2754_s3_q;
  logic and_2755_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2791_s3_q;
  logic and_2805_s3_q;
  logic equal_2848_s3_q;
  logic parity_3225_s3_q;
  logic parity_3354_s3_q;
  logic parity_3416_s3_q;
  logic xor_3444_s3_q;
  logic parity_3456_s3_q;
  logic or_3460_s3_q;
  logic equal_3461_s3_q;
  logic [4:0] select_3580_s3_q;
  logic equal_3592_s3_q;
  logic less_3594_s3_q;
  logic less_3595_s3_q;
  logic or_3600_s3_q;
  logic [7:0] select_3645_s3_q;
  logic equal_3942_s3_q;
  logic and_4162_s3_q;
  logic equal_4235_s3_q;
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
      select_508_s3_q <= select_508_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_541_s3_q <= select_541_s2_q;
      last_s3_q <= last_s2_2_q;
      and_545_s3_q <= and_545_s2_q;
      and_547_s3_q <= and_547_s2_q;
      grey_s3_q <= grey;
      equal_550_s3_q <= equal_550;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_567_s3_q <= equal_567_s2_q;
      equal_572_s3_q <= equal_572_s2_q;
      not_573_s3_q <= not_573_s2_q;
      less_650_s3_q <= less_650;
      less_651_s3_q <= less_651;
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
      and_681_s3_q <= and_681;
      and_706_s3_q <= whole_22 & and_681;
      and_707_s3_q <= census_columns_values_1_cell_2_mask_q & and_681;
      sum_722_s3_q <= {1'b0, sum_718} + {2'h0, sum_721};
      sum_725_s3_q <= {9'h0, difference_723[9]} + {1'b0, xor_724};
      and_733_s3_q <= and_733;
      and_737_s3_q <= and_737;
      less_738_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_742_s3_q <= {{5{sum_741[6]}}, sum_741, half_grey_levels_2[3:0]} < 16'hffe1;
      less_744_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_1605_s3_q <= equal_1605;
      all_s3_q <= all;
      sum_1611_s3_q <= sum_1611;
      equal_1613_s3_q <= equal_1613;
      equal_1615_s3_q <= equal_1615;
      equal_1617_s3_q <= equal_1617;
      equal_1619_s3_q <= equal_1619;
      equal_1621_s3_q <= equal_1621;
      equal_1623_s3_q <= equal_1623;
      equal_1625_s3_q <= equal_1625;
      equal_1627_s3_q <= equal_1627;
      less_1636_s3_q <= less_1636;
      or_1640_s3_q <= or_1640;
      equal_1660_s3_q <= (registration_fresh_q & select_1658) == 4'h0;
      and_1670_s3_q <= not_573_s2_q & and_1654;
      select_1687_s3_q <= select_1687[1];
      equal_1688_s3_q <= equal_1688;
      and_1696_s3_q <= and_1696;
      equal_1698_s3_q <= equal_1698;
      select_1745_s3_q <= select_1745;
      and_1773_s3_q <= and_1773;
      equal_1774_s3_q <= equal_1774_s2_q;
      equal_1776_s3_q <= equal_1776_s2_q;
      and_1789_s3_q <= and_1773 & equal_1788;
      select_1804_s3_q <= select_1804_s2_q;
      select_1810_s3_q <= select_1810_s2_q;
      select_1850_s3_q <= select_1850_s2_q;
      less_1954_s3_q <= less_1954_s2_q;
      equal_1955_s3_q <= equal_1955_s2_q;
      not_1956_s3_q <= not_1956_s2_q;
      equal_1957_s3_q <= equal_1957_s2_q;
      and_1971_s3_q <= and_1971_s2_q;
      select_1973_s3_q <= select_1973_s2_q;
      and_1976_s3_q <= and_1976_s2_q;
      or_1982_s3_q <= or_1982;
      or_1985_s3_q <= or_1985;
      or_1988_s3_q <= or_1988;
      not_1990_s3_q <= not_1990;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2017_s3_q <= inside_v_s2_q & (and_2015 & and_1583);
      and_2022_s3_q <= not_573_s2_q & and_1997;
      and_2054_s3_q <= and_2054;
      less_2055_s3_q <= less_2055;
      sum_2063_s3_q <= sum_2063;
      textured_2_s3_q <= textured_2;
      or_2081_s3_q <= or_2081;
      or_2084_s3_q <= select_2078[7] | (~({select_2078[6], select_2078[3:2]} == 3'h0));
      or_2087_s3_q <= select_2078[7] | (~(select_2078[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2137_s3_q <= and_2137;
      sum_2269_s3_q <= {1'b0, sum_2265} + {2'h0, sum_2268};
      sum_2272_s3_q <= {9'h0, difference_2270[9]} + {1'b0, xor_2271};
      equal_2280_s3_q <= equal_2280_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2594_s3_q <= and_2594;
      and_2600_s3_q <= and_2600;
      explained_2_s3_q <= explained_2;
      and_2662_s3_q <= not_573_s2_q & and_2661;
      and_2696_s3_q <= not_573_s2_q & and_2695;
      and_2754_s3_q <= not_573_s2_q & (so_s2_q & (half_ends & equal_2751));
      and_2755_s3_q <= and_2755;
      residual_s3_q <= residual[7:0];
      and_2791_s3_q <= and_2791;
      and_2805_s3_q <= and_2755 & less_2804;
      equal_2848_s3_q <= (registration_fresh_q & select_2846) == 4'h0;
      parity_3225_s3_q <= ^{xor_3221, xor_3184, select_3151[44:36], other[44:36]};
      parity_3354_s3_q <= parity_3354;
      parity_3416_s3_q <= parity_3416;
      xor_3444_s3_q <= parity_3431 ^ parity_3443;
      parity_3456_s3_q <= ^{or_3453, or_3449, and_3445};
      or_3460_s3_q <= (or_3449 & or_3453) | (and_3445 & (or_3449 | or_3453));
      equal_3461_s3_q <= equal_3461_s2_q;
      select_3580_s3_q <= select_3580[14:10];
      equal_3592_s3_q <= select_3549[3:0] == 4'h0;
      less_3594_s3_q <= {difference_3593, 3'h0} < {3'h0, sum_3141};
      less_3595_s3_q <= select_3590 < select_3580[9:0];
      or_3600_s3_q <= (sum_3141 < 10'h39) | ({1'b0, sum_3141[9:1]} < select_3580[9:0]);
      select_3645_s3_q <= select_3645;
      equal_3942_s3_q <= equal_3942;
      and_4162_s3_q <= and_2137 & (sum_2063 == sum_2047);
      equal_4235_s3_q <= (registration_fresh_q & select_4233) == 4'h0;
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
  // hls/stages/census.hpp:284
  logic [11:0] texture;
  assign texture = sum_722_s3_q + {2'h0, sum_725_s3_q};
  // hls/stages/census.hpp:295
  logic [12:0] sum_727;
  assign sum_727 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_729;
  assign sum_729 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_727});
  // hls/stages/census.hpp:317
  logic less_730;
  assign less_730 = 9'h4 < sum_729[13:5];
  logic and_731;
  assign and_731 = and_681_s3_q & less_730;
  // hls/stages/moments.hpp:30
  logic and_743;
  assign and_743 = (and_706_s3_q & and_733_s3_q) & less_742_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_1662;
  assign equal_1662 = sum_1611_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1611_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1664;
  assign select_1664 = equal_1662 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1665;
  assign sum_1665 = (equal_1660_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1664[13]}}, select_1664};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1611_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1668;
  assign select_1668 = equal_1662 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1669;
  assign sum_1669 = (equal_1660_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1668[6]}}, select_1668};
  // hls/stages/patches.hpp:354
  logic [22:0] select_1790;
  assign select_1790 = and_1789_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1745_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1792;
  assign select_1792 = equal_1688_s3_q ? patches_place_0_valid_q : (select_1687_s3_q ? patches_place_0_valid_q : select_1790[0]);
  // hls/stages/patches.hpp:132
  logic [7:0] sum_1793;
  assign sum_1793 = {1'b0, select_541_s3_q, select_508_s3_q[2]} + 8'h3;
  // hls/stages/patches.hpp:355
  logic [21:0] select_1794;
  assign select_1794 = select_1687_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1790[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1795;
  assign select_1795 = equal_1688_s3_q ? patches_place_0_column_q : select_1794[7:0];
  logic [5:0] select_1796;
  assign select_1796 = equal_1688_s3_q ? patches_place_0_shift_q : select_1794[13:8];
  // hls/stages/patches.hpp:325
  logic [7:0] sum_1797;
  assign sum_1797 = select_1795 + {{2{select_1796[5]}}, select_1796};
  // hls/stages/patches.hpp:132
  logic equal_1798;
  assign equal_1798 = {sum_1797, sum_1793[0], select_508_s3_q[1:0]} == {1'b0, sum_1793[7:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1800;
  assign or_1800 = row_starts_s3_q | (select_1792 & equal_1798);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1801;
  assign select_1801 = or_1800 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1811;
  assign select_1811 = or_1800 ? {row_starts_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1813;
  assign and_1813 = select_1810_s3_q & (~select_1811[5]);
  // hls/stages/patches.hpp:127
  logic select_1821;
  assign select_1821 = equal_1688_s3_q ? patches_place_1_valid_q : (select_1687_s3_q ? select_1790[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:355
  logic [21:0] select_1822;
  assign select_1822 = select_1687_s3_q ? select_1790[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1823;
  assign select_1823 = equal_1688_s3_q ? patches_place_1_column_q : select_1822[7:0];
  logic [5:0] select_1824;
  assign select_1824 = equal_1688_s3_q ? patches_place_1_shift_q : select_1822[13:8];
  // hls/stages/patches.hpp:325
  logic [7:0] sum_1825;
  assign sum_1825 = select_1823 + {{2{select_1824[5]}}, select_1824};
  // hls/stages/patches.hpp:132
  logic equal_1826;
  assign equal_1826 = {sum_1825[7], sum_1793, select_508_s3_q[1:0]} == {1'b0, sum_1825[6:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1828;
  assign or_1828 = row_starts_s3_q | (select_1821 & equal_1826);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1829;
  assign select_1829 = or_1828 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1830;
  assign select_1830 = or_1828 ? {row_starts_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1832;
  assign and_1832 = select_1810_s3_q & (~select_1830[5]);
  // hls/stages/patches.hpp:320
  logic [6:0] sum_1839;
  assign sum_1839 = select_1795[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1840;
  assign equal_1840 = {sum_1839[6], select_541_s3_q, select_508_s3_q} == {1'b0, sum_1839[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_1842;
  assign or_1842 = row_starts_s3_q | (select_1792 & equal_1840);
  logic [4:0] select_1843;
  assign select_1843 = or_1842 ? {row_starts_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:320
  logic [6:0] sum_1844;
  assign sum_1844 = select_1823[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1845;
  assign equal_1845 = {sum_1844[6], select_541_s3_q, select_508_s3_q} == {1'b0, sum_1844[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_1848;
  assign select_1848 = (row_starts_s3_q | (select_1821 & equal_1845)) ? {row_starts_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1843[4] ? select_1848[3:0] : select_1843[3:0];
  // hls/stages/agreement.hpp:276
  logic select_1851;
  assign select_1851 = or_1842 ? row_starts_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_1857;
  assign and_1857 = (select_1810_s3_q & (select_1804_s3_q[3] ^ select_1804_s3_q[4])) & ((~select_1843[4]) | (~select_1848[4]));
  // hls/stages/patches.hpp:185
  logic less_1966;
  assign less_1966 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:186
  logic not_1967;
  assign not_1967 = ~less_1966;
  logic [1:0] select_1968;
  assign select_1968 = patches_summed_first_s3_q ? 2'h2 : {less_1966, not_1967};
  logic [12:0] select_1969;
  assign select_1969 = select_1968[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1977;
  assign select_1977 = select_1968[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1976_s3_q, 1'b0, select_1973_s3_q, left_pixel_q};
  logic [14:0] select_1978;
  assign select_1978 = select_1968[1] ? {select_1969[12:8], patches_sums_values_0_q[9:8], select_1969[7:0]} : select_1977;
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2003;
  assign select_2003 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_2004;
  assign sum_2004 = {5'h0, textured_s3_q} + select_2003;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2006;
  assign sum_2006 = {4'h0, sum_2004} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2008;
  assign select_2008 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_2009;
  assign sum_2009 = {5'h0, explained_s3_q} + select_2008;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2011;
  assign sum_2011 = {4'h0, sum_2009} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2018;
  assign select_2018 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:902
  logic [5:0] sum_2019;
  assign sum_2019 = {5'h0, and_2017_s3_q} + select_2018;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2021;
  assign sum_2021 = {4'h0, sum_2019} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2072;
  assign select_2072 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2073;
  assign difference_2073 = {1'b0, textured_2_s3_q} - {1'b0, select_2072};
  logic [4:0] t;
  assign t = {difference_2073[3], difference_2073} + (equal_567_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2076;
  assign equal_2076 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2088;
  assign not_2088 = ~region_row_s3_q[2];
  logic [2:0] select_2089;
  assign select_2089 = region_row_s3_q[1] ? {1'b0, not_2088, 1'b0} : {region_row_s3_q[2], 1'b0, not_2088};
  logic [5:0] select_2090;
  assign select_2090 = region_row_s3_q[0] ? {select_2089[2], 1'b0, select_2089[1], 1'b0, select_2089[0], 1'b0} : {1'b0, select_2089[2], 1'b0, select_2089[1], 1'b0, select_2089[0]};
  logic [11:0] select_2091;
  assign select_2091 = or_2087_s3_q ? {select_2090[5], 1'b0, select_2090[4], 1'b0, select_2090[3], 1'b0, select_2090[2], 1'b0, select_2090[1], 1'b0, select_2090[0], 1'b0} : {1'b0, select_2090[5], 1'b0, select_2090[4], 1'b0, select_2090[3], 1'b0, select_2090[2], 1'b0, select_2090[1], 1'b0, select_2090[0]};
  logic [23:0] select_2092;
  assign select_2092 = or_2084_s3_q ? {select_2091[11], 1'b0, select_2091[10], 1'b0, select_2091[9], 1'b0, select_2091[8], 1'b0, select_2091[7], 1'b0, select_2091[6], 1'b0, select_2091[5], 1'b0, select_2091[4], 1'b0, select_2091[3], 1'b0, select_2091[2], 1'b0, select_2091[1], 1'b0, select_2091[0], 1'b0} : {1'b0, select_2091[11], 1'b0, select_2091[10], 1'b0, select_2091[9], 1'b0, select_2091[8], 1'b0, select_2091[7], 1'b0, select_2091[6], 1'b0, select_2091[5], 1'b0, select_2091[4], 1'b0, select_2091[3], 1'b0, select_2091[2], 1'b0, select_2091[1], 1'b0, select_2091[0]};
  logic [47:0] select_2093;
  assign select_2093 = or_2081_s3_q ? {select_2092[23], 1'b0, select_2092[22], 1'b0, select_2092[21], 1'b0, select_2092[20], 1'b0, select_2092[19], 1'b0, select_2092[18], 1'b0, select_2092[17], 1'b0, select_2092[16], 1'b0, select_2092[15], 1'b0, select_2092[14], 1'b0, select_2092[13], 1'b0, select_2092[12], 1'b0, select_2092[11], 1'b0, select_2092[10], 1'b0, select_2092[9], 1'b0, select_2092[8], 1'b0, select_2092[7], 1'b0, select_2092[6], 1'b0, select_2092[5], 1'b0, select_2092[4], 1'b0, select_2092[3], 1'b0, select_2092[2], 1'b0, select_2092[1], 1'b0, select_2092[0], 1'b0} : {1'b0, select_2092[23], 1'b0, select_2092[22], 1'b0, select_2092[21], 1'b0, select_2092[20], 1'b0, select_2092[19], 1'b0, select_2092[18], 1'b0, select_2092[17], 1'b0, select_2092[16], 1'b0, select_2092[15], 1'b0, select_2092[14], 1'b0, select_2092[13], 1'b0, select_2092[12], 1'b0, select_2092[11], 1'b0, select_2092[10], 1'b0, select_2092[9], 1'b0, select_2092[8], 1'b0, select_2092[7], 1'b0, select_2092[6], 1'b0, select_2092[5], 1'b0, select_2092[4], 1'b0, select_2092[3], 1'b0, select_2092[2], 1'b0, select_2092[1], 1'b0, select_2092[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2097;
  assign and_2097 = good_known_q & (~((good_q & select_2093) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2106;
  assign select_2106 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2107;
  assign difference_2107 = {1'b0, shown_2_s3_q} - {1'b0, select_2106};
  logic [4:0] around;
  assign around = {difference_2107[3], difference_2107} + (equal_567_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2110;
  assign sum_2110 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2076 ? and_2097 : (~({sum_2110, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2122;
  assign select_2122 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2123;
  assign difference_2123 = {1'b0, near_2_s3_q} - {1'b0, select_2122};
  logic [4:0] n;
  assign n = {difference_2123[3], difference_2123} + (equal_567_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2127;
  assign and_2127 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2163;
  assign select_2163 = sample_pair_whole_s3_q ? (and_545_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2165;
  assign select_2165 = sample_pair_whole_s3_q ? (and_545_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2167;
  assign select_2167 = sample_pair_whole_s3_q ? (and_545_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2169;
  assign select_2169 = sample_pair_whole_s3_q ? (and_545_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2174;
  assign sum_2174 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2175;
  assign difference_2175 = {1'b0, sum_2174[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2176;
  assign xor_2176 = {difference_2175[8:0], sum_2174[0]} ^ {10{difference_2175[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2175[9]} + {1'b0, xor_2176};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_550_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2181;
  assign select_2181 = sample_pair_whole_s3_q ? (and_545_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2182;
  assign sum_2182 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2183;
  assign difference_2183 = {1'b0, sum_2182[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2184;
  assign xor_2184 = {difference_2183[8:0], sum_2182[0]} ^ {10{difference_2183[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2183[9]} + {1'b0, xor_2184};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_550_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2189;
  assign select_2189 = sample_pair_whole_s3_q ? (and_545_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2273;
  assign sum_2273 = sum_2269_s3_q + {2'h0, sum_2272_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2275;
  assign select_2275 = and_547_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2276;
  assign select_2276 = and_547_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2277;
  assign select_2277 = and_547_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2278;
  assign select_2278 = and_547_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2281;
  assign sum_2281 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2273};
  logic [13:0] sum_2283;
  assign sum_2283 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2281});
  // hls/stages/census.hpp:323
  logic and_2285;
  assign and_2285 = and_706_s3_q & (9'h4 < sum_2283[13:5]);
  // hls/stages/census.hpp:324
  logic and_2286;
  assign and_2286 = and_706_s3_q & less_730;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2287;
  assign sum_2287 = census_left_misses_q + {{17{and_2286}}, and_2285, 1'b0, and_2285};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2289;
  assign select_2289 = and_547_s3_q ? (equal_2280_s3_q ? 20'h0 : sum_2287) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2359;
  assign select_2359 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2362;
  assign select_2362 = and_547_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2365;
  assign and_2365 = whole_2_s3_q & (~(last_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:457
  logic and_2371;
  assign and_2371 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2372;
  assign and_2372 = and_2365 & and_2371;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2359[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2374;
  assign select_2374 = and_2372 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2376;
  assign select_2376 = equal_2280_s3_q ? {11'h0, select_2374} : (sharpness_sums_detail_0_q + {11'h0, select_2374});
  // hls/stages/agreement.hpp:457
  logic and_2383;
  assign and_2383 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2384;
  assign and_2384 = and_2365 & and_2383;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2359[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2386;
  assign select_2386 = and_2384 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2388;
  assign select_2388 = equal_2280_s3_q ? {11'h0, select_2386} : (sharpness_sums_detail_1_q + {11'h0, select_2386});
  logic [8:0] select_2391;
  assign select_2391 = and_2372 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2392;
  assign sum_2392 = (equal_2280_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2391};
  logic [8:0] select_2395;
  assign select_2395 = and_2384 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2396;
  assign sum_2396 = (equal_2280_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2395};
  // hls/stages/agreement.hpp:211
  logic equal_2398;
  assign equal_2398 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:388
  logic less_2399;
  assign less_2399 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2400;
  assign less_2400 = x_s3_q[4:0] < 5'h3;
  logic not_2401;
  assign not_2401 = ~x_s3_q[1];
  logic [2:0] select_2402;
  assign select_2402 = x_s3_q[0] ? {1'b0, not_2401, 1'b0} : {x_s3_q[1], 1'b0, not_2401};
  logic [5:0] select_2403;
  assign select_2403 = slot_s3_q[2] ? {select_2402[2], 1'b0, select_2402[1], 1'b0, select_2402[0], 1'b0} : {1'b0, select_2402[2], 1'b0, select_2402[1], 1'b0, select_2402[0]};
  logic [11:0] select_2404;
  assign select_2404 = slot_s3_q[1] ? {select_2403[5], 1'b0, select_2403[4], 1'b0, select_2403[3], 1'b0, select_2403[2], 1'b0, select_2403[1], 1'b0, select_2403[0], 1'b0} : {1'b0, select_2403[5], 1'b0, select_2403[4], 1'b0, select_2403[3], 1'b0, select_2403[2], 1'b0, select_2403[1], 1'b0, select_2403[0]};
  logic [23:0] select_2405;
  assign select_2405 = slot_s3_q[0] ? {select_2404[11], 1'b0, select_2404[10], 1'b0, select_2404[9], 1'b0, select_2404[8], 1'b0, select_2404[7], 1'b0, select_2404[6], 1'b0, select_2404[5], 1'b0, select_2404[4], 1'b0, select_2404[3], 1'b0, select_2404[2], 1'b0, select_2404[1], 1'b0, select_2404[0], 1'b0} : {1'b0, select_2404[11], 1'b0, select_2404[10], 1'b0, select_2404[9], 1'b0, select_2404[8], 1'b0, select_2404[7], 1'b0, select_2404[6], 1'b0, select_2404[5], 1'b0, select_2404[4], 1'b0, select_2404[3], 1'b0, select_2404[2], 1'b0, select_2404[1], 1'b0, select_2404[0]};
  // hls/stages/census.hpp:390
  logic and_2409;
  assign and_2409 = less_2400 & (~((sharpness_sums_contrast_1_q & select_2405) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2411;
  assign select_2411 = (less_2399 & and_2409) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2411};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2414;
  assign select_2414 = equal_2398 ? (less_2399 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2419;
  assign and_2419 = less_2400 & (~((sharpness_sums_contrast_0_q & select_2405) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2421;
  assign select_2421 = (less_2399 & and_2419) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2421};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2424;
  assign select_2424 = equal_2398 ? (less_2399 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2426;
  assign select_2426 = equal_2398 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2428;
  assign select_2428 = equal_2398 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2430;
  assign select_2430 = equal_2398 ? {sharpness_comparing_contrast_0_q[0], and_2419} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2432;
  assign select_2432 = equal_2398 ? {sharpness_comparing_contrast_1_q[0], and_2409} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2437;
  assign select_2437 = drew_q ? (equal_2398 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2441;
  assign select_2441 = drew_q ? (equal_2398 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2442;
  assign equal_2442 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2443;
  assign xor_2443 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2446;
  assign select_2446 = (equal_2442 | xor_2443) ? (five_times[0] & xor_2443) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2448;
  assign select_2448 = drew_q ? (equal_2398 ? select_2446 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2449;
  assign xor_2449 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2452;
  assign select_2452 = (equal_2442 | xor_2449) ? (five_times_2[0] & xor_2449) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2454;
  assign select_2454 = drew_q ? (equal_2398 ? select_2452 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2455;
  assign xor_2455 = sharpness_comparing_contrast_0_q[1] ^ and_2409;
  logic select_2458;
  assign select_2458 = (equal_2442 | xor_2455) ? (and_2409 & xor_2455) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2460;
  assign select_2460 = drew_q ? (equal_2398 ? select_2458 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2461;
  assign xor_2461 = sharpness_comparing_contrast_1_q[1] ^ and_2419;
  logic select_2464;
  assign select_2464 = (equal_2442 | xor_2461) ? (and_2419 & xor_2461) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2466;
  assign select_2466 = drew_q ? (equal_2398 ? select_2464 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2602;
  assign select_2602 = and_2594_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2600_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_2605;
  assign and_2605 = not_573_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2610;
  assign and_2610 = not_573_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2615;
  assign and_2615 = not_573_s3_q & (drew_q & (ends_cell_s3_q & and_2017_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_2619;
  assign not_2619 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2628;
  assign select_2628 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2629;
  assign difference_2629 = {1'b0, explained_2_s3_q} - {1'b0, select_2628};
  logic [4:0] e;
  assign e = {difference_2629[3], difference_2629} + (equal_567_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2632;
  assign sum_2632 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_2636;
  assign not_2636 = ~(equal_2076 ? and_2097 : (~({sum_2632, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_2639;
  assign and_2639 = ends_cell_s3_q & (not_2619 & (centres_values_1_textured_s3_q & not_2636));
  logic and_2641;
  assign and_2641 = not_573_s3_q & (drew_q & and_2639);
  // hls/stages/agreement.hpp:1132
  logic less_2644;
  assign less_2644 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2645;
  assign select_2645 = less_2644 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2648;
  assign select_2648 = less_2644 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2649;
  assign sum_2649 = {1'b0, select_2648} + {3'h0, select_2648[9:2]};
  logic and_2651;
  assign and_2651 = (~(select_2645[9:4] == 6'h0)) & ({sum_2649, select_2648[1:0]} < {3'h0, select_2645});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_2654;
  assign select_2654 = x_s3_q[6] ? (equal_1605_s3_q ? 10'h0 : (and_2651 ? select_2645 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2655;
  assign select_2655 = equal_572_s3_q ? select_2654 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2657;
  assign select_2657 = and_2594_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2655});
  logic [13:0] select_2664;
  assign select_2664 = and_2594_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2662_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_2666;
  assign and_2666 = not_2619 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_2669;
  assign and_2669 = not_573_s3_q & (drew_q & (ends_cell_s3_q & and_2666));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2671;
  assign select_2671 = and_2594_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2669});
  // hls/stages/agreement.hpp:1110
  logic and_2673;
  assign and_2673 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2636);
  // hls/stages/agreement.hpp:788
  logic and_2677;
  assign and_2677 = not_573_s3_q & (drew_q & (ends_cell_s3_q & (not_2619 & and_2673)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2679;
  assign select_2679 = and_2594_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2677});
  logic [13:0] select_2698;
  assign select_2698 = and_2594_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2696_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2773;
  assign select_2773 = drew_q ? (equal_1698_s3_q ? (and_2755_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2774;
  assign select_2774 = equal_572_s3_q ? 8'h0 : select_2773;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2776;
  assign select_2776 = and_2754_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2774[7]}}, select_2774});
  // hls/stages/agreement.hpp:788
  logic and_2779;
  assign and_2779 = not_573_s3_q & (drew_q & (and_2755_s3_q & equal_1698_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2781;
  assign select_2781 = and_2754_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2779});
  // hls/stages/registration.hpp:107
  logic and_2783;
  assign and_2783 = and_2755_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2785;
  assign select_2785 = drew_q ? (equal_1698_s3_q ? {and_2783, and_2755_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2786;
  assign select_2786 = equal_572_s3_q ? 2'h0 : select_2785;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2787;
  assign sum_2787 = registration_half_votes_down_q + {{5{select_2786[1]}}, select_2786};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2793;
  assign select_2793 = drew_q ? (equal_1698_s3_q ? {and_2791_s3_q, and_2755_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2794;
  assign select_2794 = equal_572_s3_q ? 2'h0 : select_2793;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2795;
  assign sum_2795 = registration_half_votes_up_q + {{5{select_2794[1]}}, select_2794};
  // hls/stages/registration.hpp:107
  logic and_2798;
  assign and_2798 = and_2755_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2800;
  assign select_2800 = drew_q ? (equal_1698_s3_q ? {and_2798, and_2755_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2801;
  assign select_2801 = equal_572_s3_q ? 2'h0 : select_2800;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2802;
  assign sum_2802 = registration_half_half_votes_down_q + {{5{select_2801[1]}}, select_2801};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2807;
  assign select_2807 = drew_q ? (equal_1698_s3_q ? {and_2805_s3_q, and_2755_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2808;
  assign select_2808 = equal_572_s3_q ? 2'h0 : select_2807;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2809;
  assign sum_2809 = registration_half_half_votes_up_q + {{5{select_2808[1]}}, select_2808};
  // hls/stages/agreement.hpp:788
  logic and_2843;
  assign and_2843 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & less_1636_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2850;
  assign select_2850 = or_1640_s3_q ? 12'h0 : (equal_2848_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2853;
  assign select_2853 = x_s3_q[6] ? (equal_1605_s3_q ? 12'h0 : (less_1636_s3_q ? select_2850 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2854;
  assign select_2854 = equal_572_s3_q ? select_2853 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2855;
  assign and_2855 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2858;
  assign and_2858 = not_1990_s3_q & (less_1636_s3_q & ({and_2855, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_2860;
  assign and_2860 = equal_572_s3_q & (x_s3_q[6] & and_2858);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2862;
  assign sum_2862 = {{2{select_2854[11]}}, select_2854} + (and_2860 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2865;
  assign select_2865 = or_1640_s3_q ? 12'h0 : (equal_2848_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2868;
  assign select_2868 = x_s3_q[6] ? (equal_1605_s3_q ? 12'h0 : (less_1636_s3_q ? select_2865 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2869;
  assign select_2869 = equal_572_s3_q ? select_2868 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2871;
  assign sum_2871 = {{2{select_2869[11]}}, select_2869} + (and_2860 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2873;
  assign not_2873 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2876;
  assign and_2876 = not_1990_s3_q & (less_1636_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2873, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2882;
  assign and_2882 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & (less_1636_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2883;
  assign not_2883 = ~and_2882;
  logic less_2884;
  assign less_2884 = $signed({9'h1, {2{not_2883}}, and_2882}) < $signed(registration_up_q[13:2]);
  logic select_2885;
  assign select_2885 = (equal_572_s3_q & (x_s3_q[6] & and_2876)) ? less_2884 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2889;
  assign and_2889 = x_s3_q[6] & (not_1990_s3_q & (less_1636_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2890;
  assign and_2890 = equal_572_s3_q & and_2889;
  // hls/stages/registration.hpp:242
  logic less_2891;
  assign less_2891 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2893;
  assign less_2893 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2895;
  assign equal_2895 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2899;
  assign and_2899 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & (less_1636_s3_q & equal_2895)));
  // hls/stages/agreement.hpp:1142
  logic and_2906;
  assign and_2906 = x_s3_q[6] & (not_1990_s3_q & (less_1636_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2909;
  assign equal_2909 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2912;
  assign and_2912 = not_1990_s3_q & (less_1636_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2909));
  // hls/stages/registration.hpp:244
  logic and_2916;
  assign and_2916 = (equal_572_s3_q & (x_s3_q[6] & and_2912)) & (less_2893 | less_2891);
  // hls/stages/agreement.hpp:1142
  logic and_2921;
  assign and_2921 = not_1990_s3_q & (less_1636_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2909)));
  // hls/stages/registration.hpp:244
  logic and_2924;
  assign and_2924 = registration_votes_up_q & registration_other_down_q;
  logic select_2926;
  assign select_2926 = registration_votes_down_q ? (registration_other_up_q | and_2924) : and_2924;
  // hls/stages/registration.hpp:138
  logic and_2928;
  assign and_2928 = (equal_572_s3_q & (x_s3_q[6] & and_2921)) & (registration_other_enough_q & select_2926);
  // hls/stages/registration.hpp:245
  logic or_2931;
  assign or_2931 = registration_moved_q | (registration_enough_q & (and_2916 | and_2928));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3014;
  assign select_3014 = sample_pair_whole_s3_q ? (equal_1688_s3_q ? patches_place_0_slope_q : select_1794[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3019;
  assign select_3019 = sample_pair_whole_s3_q ? (equal_1688_s3_q ? patches_place_1_slope_q : select_1822[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3021;
  assign select_3021 = equal_1688_s3_q ? patches_valid_0_q : (select_1687_s3_q ? patches_valid_0_q : select_1790[0]);
  // hls/stages/agreement.hpp:276
  logic select_3024;
  assign select_3024 = sample_pair_whole_s3_q ? (and_1813 ? (sample_present_s3_q & select_3021) : select_3021) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3026;
  assign select_3026 = equal_1688_s3_q ? patches_valid_1_q : (select_1687_s3_q ? select_1790[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3029;
  assign select_3029 = sample_pair_whole_s3_q ? (and_1832 ? (sample_present_s3_q & select_3026) : select_3026) : patches_valid_1_q;
  logic [5:0] select_3032;
  assign select_3032 = sample_pair_whole_s3_q ? (select_1811[5] ? {1'b1, select_1811[4:0]} : (select_1811 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3035;
  assign select_3035 = sample_pair_whole_s3_q ? (select_1830[5] ? {1'b1, select_1830[4:0]} : (select_1830 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3038;
  assign select_3038 = sample_pair_whole_s3_q ? (select_1843[4] ? {1'b1, select_1843[3:0]} : (select_1843 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3041;
  assign select_3041 = sample_pair_whole_s3_q ? (select_1848[4] ? {1'b1, select_1848[3:0]} : (select_1848 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:526
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3460_s3_q, parity_3456_s3_q, xor_3444_s3_q, parity_3416_s3_q, parity_3354_s3_q, parity_3225_s3_q} + (equal_3461_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:185
  logic [9:0] select_3465;
  assign select_3465 = equal_1774_s3_q ? patches_sums_values_0_q : (equal_1776_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3466;
  assign select_3466 = equal_1776_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3468;
  assign select_3468 = equal_1776_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3470;
  assign select_3470 = equal_1776_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3472;
  assign select_3472 = equal_1776_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3474;
  assign select_3474 = equal_1776_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3476;
  assign select_3476 = equal_1776_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3478;
  assign select_3478 = equal_1776_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3480;
  assign select_3480 = equal_1776_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3482;
  assign select_3482 = equal_1776_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3484;
  assign select_3484 = equal_1776_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3486;
  assign select_3486 = equal_1776_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3488;
  assign select_3488 = equal_1776_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3490;
  assign select_3490 = equal_1776_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3492;
  assign select_3492 = equal_1776_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3494;
  assign select_3494 = equal_1776_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3496;
  assign select_3496 = equal_1776_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:600
  logic or_3601;
  assign or_3601 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_3600_s3_q;
  logic or_3604;
  assign or_3604 = equal_3592_s3_q | (less_3594_s3_q | (less_3595_s3_q | or_3601));
  // hls/stages/patches.hpp:580
  logic not_3605;
  assign not_3605 = ~or_3604;
  // hls/stages/patches.hpp:561
  logic and_3606;
  assign and_3606 = equal_1957_s3_q & not_3605;
  // hls/stages/patches.hpp:185
  logic and_3609;
  assign and_3609 = equal_1774_s3_q & (less_1954_s3_q ? (not_1956_s3_q & and_3606) : and_3606);
  // hls/stages/patches.hpp:658
  logic not_3610;
  assign not_3610 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:561
  logic and_3612;
  assign and_3612 = equal_1957_s3_q & (patches_second_s3_q & not_3605);
  // hls/stages/patches.hpp:185
  logic and_3615;
  assign and_3615 = equal_1774_s3_q & (less_1954_s3_q ? (not_1956_s3_q & and_3612) : and_3612);
  // hls/stages/patches.hpp:658
  logic not_3616;
  assign not_3616 = ~and_3615;
  // hls/stages/patches.hpp:189
  logic and_3618;
  assign and_3618 = and_3609 & (not_3610 & not_3616);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3620;
  assign sum_3620 = {7'h0, and_3618} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:598
  logic [7:0] select_3646;
  assign select_3646 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:597
  logic [5:0] select_3647;
  assign select_3647 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3648;
  assign sum_3648 = {2'h0, select_3580_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_3649;
  assign sum_3649 = {select_3647[5], select_3647} + {{3{sum_3648[3]}}, sum_3648};
  // hls/stages/patches.hpp:598
  logic [17:0] product_3650;
  assign product_3650 = $signed({{10{select_3646[7]}}, select_3646}) * $signed({{8{sum_3649[6]}}, sum_3649, select_3580_s3_q[2:0]});
  // hls/stages/patches.hpp:599
  logic [13:0] difference_3651;
  assign difference_3651 = {{6{select_3645_s3_q[7]}}, select_3645_s3_q} - {product_3650[17], product_3650[17:5]};
  // hls/stages/patches.hpp:605
  logic less_3652;
  assign less_3652 = $signed({{7{difference_3622[6]}}, difference_3622}) < $signed(difference_3651);
  // hls/stages/patches.hpp:561
  logic and_3655;
  assign and_3655 = equal_1957_s3_q & (not_3605 & (~less_3652));
  // hls/stages/patches.hpp:185
  logic and_3658;
  assign and_3658 = equal_1774_s3_q & (less_1954_s3_q ? (not_1956_s3_q & and_3655) : and_3655);
  // hls/stages/patches.hpp:661
  logic and_3659;
  assign and_3659 = and_3658 & and_3618;
  logic [7:0] sum_3660;
  assign sum_3660 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3659};
  // hls/stages/patches.hpp:561
  logic and_3664;
  assign and_3664 = not_3605 & (~($signed(difference_3651) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3665;
  assign and_3665 = equal_1957_s3_q & and_3664;
  // hls/stages/patches.hpp:185
  logic and_3668;
  assign and_3668 = equal_1774_s3_q & (less_1954_s3_q ? (not_1956_s3_q & and_3665) : and_3665);
  // hls/stages/patches.hpp:662
  logic and_3669;
  assign and_3669 = and_3668 & and_3618;
  logic [7:0] sum_3670;
  assign sum_3670 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3669};
  // hls/stages/patches.hpp:189
  logic and_3672;
  assign and_3672 = and_3609 & (and_3615 & not_3610);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3674;
  assign sum_3674 = {7'h0, and_3672} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:661
  logic and_3676;
  assign and_3676 = and_3658 & and_3672;
  logic [7:0] sum_3677;
  assign sum_3677 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3676};
  // hls/stages/patches.hpp:662
  logic and_3679;
  assign and_3679 = and_3668 & and_3672;
  logic [7:0] sum_3680;
  assign sum_3680 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3679};
  // hls/stages/patches.hpp:189
  logic and_3682;
  assign and_3682 = and_3609 & (patches_lower_s3_q & not_3616);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3684;
  assign sum_3684 = {7'h0, and_3682} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:661
  logic and_3686;
  assign and_3686 = and_3658 & and_3682;
  logic [7:0] sum_3687;
  assign sum_3687 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3686};
  // hls/stages/patches.hpp:662
  logic and_3689;
  assign and_3689 = and_3668 & and_3682;
  logic [7:0] sum_3690;
  assign sum_3690 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3689};
  // hls/stages/patches.hpp:189
  logic and_3692;
  assign and_3692 = and_3609 & (patches_lower_s3_q & and_3615);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3694;
  assign sum_3694 = {7'h0, and_3692} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:661
  logic and_3696;
  assign and_3696 = and_3658 & and_3692;
  logic [7:0] sum_3697;
  assign sum_3697 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3696};
  // hls/stages/patches.hpp:662
  logic and_3699;
  assign and_3699 = and_3668 & and_3692;
  logic [7:0] sum_3700;
  assign sum_3700 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3699};
  // hls/stages/agreement.hpp:1223
  logic equal_3701;
  assign equal_3701 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_3702;
  assign less_3702 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3706;
  assign and_3706 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & (equal_3701 & less_3702)));
  // hls/stages/agreement.hpp:1142
  logic and_3711;
  assign and_3711 = x_s3_q[6] & (not_1990_s3_q & (less_3702 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_3712;
  assign and_3712 = equal_572_s3_q & and_3711;
  // hls/stages/patches.hpp:624
  logic [7:0] or_3714;
  assign or_3714 = (and_3706 ? patches_quarters_0_places_q : 8'h0) | (and_3712 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_3718;
  assign and_3718 = x_s3_q[6] & (not_1990_s3_q & (less_3702 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_3719;
  assign and_3719 = equal_572_s3_q & and_3718;
  // hls/stages/agreement.hpp:1142
  logic and_3725;
  assign and_3725 = x_s3_q[6] & (not_1990_s3_q & (less_3702 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_3726;
  assign and_3726 = equal_572_s3_q & and_3725;
  // hls/stages/patches.hpp:624
  logic [7:0] or_3728;
  assign or_3728 = (or_3714 | (and_3719 ? patches_quarters_2_places_q : 8'h0)) | (and_3726 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:200
  logic select_3732;
  assign select_3732 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_3736;
  assign and_3736 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & (less_3702 & select_3732)));
  // hls/stages/patches.hpp:625
  logic [7:0] select_3738;
  assign select_3738 = and_3706 ? (and_3736 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3740;
  assign select_3740 = and_3712 ? (and_3736 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3743;
  assign select_3743 = and_3719 ? (and_3736 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3746;
  assign select_3746 = and_3726 ? (and_3736 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:626
  logic [7:0] select_3749;
  assign select_3749 = and_3706 ? (and_3736 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3751;
  assign select_3751 = and_3712 ? (and_3736 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3754;
  assign select_3754 = and_3719 ? (and_3736 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3757;
  assign select_3757 = and_3726 ? (and_3736 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:203
  logic [4:0] sum_3759;
  assign sum_3759 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_3763;
  assign and_3763 = x_s3_q[6] & (not_1990_s3_q & (less_3702 & (sum_3759[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3764;
  assign and_3764 = equal_572_s3_q & and_3763;
  // hls/stages/patches.hpp:621
  logic [7:0] select_3767;
  assign select_3767 = and_3764 ? (patches_word_places_q + (and_3712 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3770;
  assign select_3770 = and_3764 ? (patches_word_up_q + (and_3712 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3773;
  assign select_3773 = and_3764 ? (patches_word_down_q + (and_3712 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:607
  logic [5:0] select_3777;
  assign select_3777 = ($signed(difference_3651[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3651[5:0];
  logic [5:0] select_3778;
  assign select_3778 = ($signed(14'h10) < $signed(difference_3651)) ? 6'h10 : select_3777;
  // hls/stages/patches.hpp:561
  logic [5:0] select_3780;
  assign select_3780 = equal_1957_s3_q ? (or_3604 ? 6'h0 : select_3778) : 6'h0;
  logic [5:0] select_3782;
  assign select_3782 = less_1954_s3_q ? (equal_1955_s3_q ? 6'h0 : select_3780) : select_3780;
  // hls/stages/patches.hpp:664
  logic [5:0] select_3784;
  assign select_3784 = and_3609 ? (equal_1774_s3_q ? select_3782 : 6'h0) : 6'h0;
  logic [11:0] sum_3785;
  assign sum_3785 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3784[5]}}, select_3784};
  // hls/stages/agreement.hpp:788
  logic and_3789;
  assign and_3789 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & (equal_2895 & less_3702)));
  // hls/stages/agreement.hpp:1142
  logic and_3793;
  assign and_3793 = x_s3_q[6] & (not_1990_s3_q & (less_3702 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3794;
  assign and_3794 = equal_572_s3_q & and_3793;
  // hls/stages/patches.hpp:648
  logic [7:0] select_3796;
  assign select_3796 = and_3789 ? (and_3794 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:650
  logic or_3800;
  assign or_3800 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic or_3803;
  assign or_3803 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:652
  logic [8:0] sum_3804;
  assign sum_3804 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:647
  logic select_3806;
  assign select_3806 = and_3789 ? (and_3794 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:189
  logic and_3809;
  assign and_3809 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:647
  logic [2:0] select_3811;
  assign select_3811 = and_3794 ? {and_3809, patches_found_q[2:1]} : (and_3789 ? {and_3809, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:646
  logic or_3815;
  assign or_3815 = patches_partly_q | (patches_doubted_q & (~and_3794));
  // hls/stages/patches.hpp:647
  logic select_3818;
  assign select_3818 = and_3789 ? (and_3794 ? or_3815 : (and_3789 ? or_3815 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:645
  logic select_3819;
  assign select_3819 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:634
  logic [7:0] select_3823;
  assign select_3823 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:606
  logic [10:0] sum_3825;
  assign sum_3825 = {sum_3649[6], sum_3649, select_3580_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:561
  logic and_3828;
  assign and_3828 = equal_1957_s3_q & (not_3605 & ({{5{sum_3825[10]}}, sum_3825} < 16'h3));
  // hls/stages/patches.hpp:185
  logic and_3831;
  assign and_3831 = equal_1774_s3_q & (less_1954_s3_q ? (not_1956_s3_q & and_3828) : and_3828);
  // hls/stages/patches.hpp:189
  logic and_3832;
  assign and_3832 = and_3609 & and_3831;
  // hls/stages/patches.hpp:665
  logic [7:0] sum_3833;
  assign sum_3833 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3832};
  // hls/stages/patches.hpp:654
  logic [12:0] product_3838;
  assign product_3838 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_3796};
  // hls/stages/patches.hpp:189
  logic and_3840;
  assign and_3840 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_3838[12:5] < patches_on_skin_q);
  logic select_3845;
  assign select_3845 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:635
  logic or_3849;
  assign or_3849 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:636
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:637
  logic select_3856;
  assign select_3856 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:638
  logic and_3862;
  assign and_3862 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3863;
  assign sum_3863 = patches_age_q + {9'h0, and_3862};
  logic [9:0] select_3866;
  assign select_3866 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3863)) : sum_3863;
  // hls/stages/agreement.hpp:1188
  logic or_3923;
  assign or_3923 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_3925;
  assign equal_3925 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_3931;
  assign select_3931 = (equal_3925 & equal_3701) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3934;
  assign sum_3934 = {1'b0, select_2648} + {2'h0, select_2648[9:1]};
  logic select_3937;
  assign select_3937 = (select_2645[9:3] == 7'h0) ? ((~or_3923) & (~select_3931)) : (~({sum_3934, select_2648[0]} < {2'h0, select_2645}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3939;
  assign select_3939 = x_s3_q[6] ? (equal_1605_s3_q ? good_q : {select_3937, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_3944;
  assign select_3944 = equal_572_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3942_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_3945;
  assign equal_3945 = x_s3_q[6:3] == 4'ha;
  logic equal_3947;
  assign equal_3947 = x_s3_q[6:3] == 4'hc;
  logic equal_3948;
  assign equal_3948 = x_s3_q[6:3] == 4'hb;
  logic equal_3949;
  assign equal_3949 = x_s3_q[6:3] == 4'h9;
  logic equal_3950;
  assign equal_3950 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3952;
  assign select_3952 = equal_3949 ? counts_skin_unproven_q : (equal_3950 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3954;
  assign select_3954 = equal_3948 ? counts_regions_bad_q : (equal_3945 ? counts_nearer_q : select_3952);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3947 ? counts_on_skin_q : select_3954;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1230
  logic select_3957;
  assign select_3957 = (equal_3945 & equal_3701) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_3958;
  assign not_3958 = ~hidden_for_q[7];
  logic [7:0] select_3960;
  assign select_3960 = select_3957 ? (hidden_for_q + {7'h0, not_3958}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3962;
  assign select_3962 = equal_572_s3_q ? (equal_3942_s3_q ? select_3960 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3963;
  assign select_3963 = equal_3701 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3965;
  assign select_3965 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3967;
  assign select_3967 = equal_3950 ? cfg_unproven_skin_limit_i : (equal_3925 ? cfg_unproven_limit_i : select_3965);
  logic [7:0] select_3969;
  assign select_3969 = equal_3945 ? cfg_regions_limit_i : (equal_3949 ? cfg_hidden_limit_i : select_3967);
  logic [7:0] limit;
  assign limit = equal_3947 ? cfg_regions_limit_i : (equal_3948 ? {cfg_on_skin_limit_i, 3'h0} : select_3969);
  // hls/stages/agreement.hpp:1231
  logic not_3972;
  assign not_3972 = ~x_s3_q[2];
  logic [3:0] select_3973;
  assign select_3973 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3972, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3972};
  logic [7:0] select_3974;
  assign select_3974 = x_s3_q[0] ? {select_3973[3], 1'b0, select_3973[2], 1'b0, select_3973[1], 1'b0, select_3973[0], 1'b0} : {1'b0, select_3973[3], 1'b0, select_3973[2], 1'b0, select_3973[1], 1'b0, select_3973[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3978;
  assign select_3978 = equal_3949 ? counts_skin_supervised_q : (equal_3950 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3980;
  assign select_3980 = equal_3948 ? counts_skin_textured_q : (equal_3945 ? counts_textured_q : select_3978);
  logic [13:0] of;
  assign of = equal_3947 ? counts_textured_q : select_3980;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3982;
  assign select_3982 = ((limit & select_3974) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3963} + {1'b0, select_3982};
  // hls/stages/agreement.hpp:788
  logic select_3987;
  assign select_3987 = equal_572_s3_q ? (equal_3701 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_3992;
  assign and_3992 = too_much_q & (~(equal_3950 & equal_3701));
  // hls/stages/agreement.hpp:1229
  logic select_3997;
  assign select_3997 = (over[14] & equal_3701) ? (and_3992 | ((equal_3950 | equal_3949) | (x_s3_q[6:3] == 4'hf))) : and_3992;
  // hls/stages/agreement.hpp:1125
  logic and_4002;
  assign and_4002 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_4003;
  assign select_4003 = (equal_3947 & equal_3701) ? and_4002 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4005;
  assign select_4005 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4007;
  assign select_4007 = equal_572_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4005 : box_textured_columns_values_0_q);
  logic [2:0] select_4008;
  assign select_4008 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4010;
  assign select_4010 = equal_572_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4008 : box_textured_columns_values_1_q);
  logic [2:0] select_4011;
  assign select_4011 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4013;
  assign select_4013 = equal_572_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4011 : box_textured_columns_values_2_q);
  logic [2:0] select_4014;
  assign select_4014 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4016;
  assign select_4016 = equal_572_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4014 : box_textured_columns_values_3_q);
  logic [2:0] select_4017;
  assign select_4017 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4019;
  assign select_4019 = equal_572_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4017 : box_textured_columns_values_4_q);
  logic [4:0] select_4021;
  assign select_4021 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4023;
  assign select_4023 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4025;
  assign select_4025 = equal_572_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4023 : box_explained_columns_values_0_q);
  logic [2:0] select_4026;
  assign select_4026 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4028;
  assign select_4028 = equal_572_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4026 : box_explained_columns_values_1_q);
  logic [2:0] select_4029;
  assign select_4029 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4031;
  assign select_4031 = equal_572_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4029 : box_explained_columns_values_2_q);
  logic [2:0] select_4032;
  assign select_4032 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4034;
  assign select_4034 = equal_572_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4032 : box_explained_columns_values_3_q);
  logic [2:0] select_4035;
  assign select_4035 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4037;
  assign select_4037 = equal_572_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4035 : box_explained_columns_values_4_q);
  logic [4:0] select_4039;
  assign select_4039 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4042;
  assign select_4042 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4044;
  assign select_4044 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4046;
  assign select_4046 = equal_572_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4044 : box_shown_columns_values_1_q);
  logic [2:0] select_4047;
  assign select_4047 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4049;
  assign select_4049 = equal_572_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4047 : box_shown_columns_values_2_q);
  logic [2:0] select_4050;
  assign select_4050 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4052;
  assign select_4052 = equal_572_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4050 : box_shown_columns_values_3_q);
  logic [2:0] select_4053;
  assign select_4053 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4055;
  assign select_4055 = equal_572_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4053 : box_shown_columns_values_4_q);
  logic [4:0] select_4057;
  assign select_4057 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4060;
  assign select_4060 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4062;
  assign select_4062 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4064;
  assign select_4064 = equal_572_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4062 : box_nearer_columns_values_1_q);
  logic [2:0] select_4065;
  assign select_4065 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4067;
  assign select_4067 = equal_572_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4065 : box_nearer_columns_values_2_q);
  logic [2:0] select_4068;
  assign select_4068 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4070;
  assign select_4070 = equal_572_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4068 : box_nearer_columns_values_3_q);
  logic [2:0] select_4071;
  assign select_4071 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4073;
  assign select_4073 = equal_572_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4071 : box_nearer_columns_values_4_q);
  logic [4:0] select_4075;
  assign select_4075 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1275
  logic select_4110;
  assign select_4110 = left_first_s3_q ? done_s3_q : proven_q;
  // hls/stages/agreement.hpp:278
  logic select_4112;
  assign select_4112 = left_first_s3_q ? done_s3_q : (and_1971_s3_q ? select_4110 : proven_q);
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4163;
  assign select_4163 = and_4162_s3_q ? {and_2127, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4164;
  assign and_4164 = select_4110 & less_4140;
  // hls/stages/agreement.hpp:438
  logic select_4167;
  assign select_4167 = and_2054_s3_q ? (less_2055_s3_q ? (select_4163[0] & and_4164) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:278
  logic select_4169;
  assign select_4169 = left_first_s3_q ? select_4167 : (and_1971_s3_q ? select_4167 : seen_q);
  logic select_4170;
  assign select_4170 = and_1971_s3_q ? select_4169 : seen_q;
  // hls/stages/agreement.hpp:438
  logic select_4173;
  assign select_4173 = and_2054_s3_q ? (less_2055_s3_q ? (select_4163[1] & and_4164) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:278
  logic select_4175;
  assign select_4175 = left_first_s3_q ? select_4173 : (and_1971_s3_q ? select_4173 : nearer_q);
  logic select_4176;
  assign select_4176 = and_1971_s3_q ? select_4175 : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4183;
  assign or_4183 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1241
  logic not_4191;
  assign not_4191 = ~(or_3923 | not_2350);
  // hls/stages/agreement.hpp:788
  logic and_4195;
  assign and_4195 = equal_572_s3_q & (equal_3942_s3_q & (not_4191 & (select_3931 | select_3997)));
  logic and_4198;
  assign and_4198 = equal_3942_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4202;
  assign or_4202 = select_2448 | (select_2460 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4209;
  assign and_4209 = equal_572_s3_q & (equal_3942_s3_q & (not_4191 & (select_2454 | select_2466)));
  // hls/stages/agreement.hpp:1150
  logic and_4214;
  assign and_4214 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3960 < cfg_hidden_frames_i));
  logic select_4220;
  assign select_4220 = (not_2350 | (select_4003 & not_3835)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4225;
  assign and_4225 = equal_572_s3_q & (equal_3942_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4229;
  assign and_4229 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4237;
  assign select_4237 = equal_1627_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4235_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4238;
  assign select_4238 = equal_1625_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4237;
  logic [31:0] select_4239;
  assign select_4239 = equal_1623_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4238;
  logic [31:0] select_4240;
  assign select_4240 = equal_1621_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4239;
  logic [31:0] select_4241;
  assign select_4241 = equal_1619_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4240;
  logic [31:0] select_4242;
  assign select_4242 = equal_1617_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4241;
  logic [31:0] select_4243;
  assign select_4243 = equal_1615_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4242;
  logic [31:0] select_4244;
  assign select_4244 = equal_1613_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4243;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4245;
  assign select_4245 = less_2644 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4246;
  assign select_4246 = equal_1605_s3_q ? select_4244 : {2'h0, select_4245, select_2648, select_2645};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_547_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_744_s3_q, and_743, less_738_s3_q, and_737_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_731, and_707_s3_q, and_706_s3_q, and_681_s3_q, less_673_s3_q, less_672_s3_q, less_671_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q, less_650_s3_q};
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
  assign registration_sums_waddr = {sum_1611_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1670_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1669, sum_1665};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_1696_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_1773_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1745_s3_q};
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
  assign patches_right_0_waddr = {select_1804_s3_q, select_1801};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_1813);
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
  assign patches_right_1_waddr = {select_1804_s3_q, select_1829};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1832);
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
  assign patches_left_waddr = {select_1851, select_1850_s3_q, column_4};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1857);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1978;
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
  assign regions_waddr = {region_row_s3_q, or_1988_s3_q, or_1985_s3_q, or_1982_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2022_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2021, sum_2011, sum_2006};
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
  assign map_waddr = sum_2063_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2137_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2127, is_seen};
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
      census_left_misses_q <= select_2289;
      sharpness_before_last_mask_q <= select_2362;
      sharpness_sums_detail_0_q <= and_547_s3_q ? select_2376 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_547_s3_q ? select_2388 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_547_s3_q ? sum_2392 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_547_s3_q ? sum_2396 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2414 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2424 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2426 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2428 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2430 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2432 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2437;
      sharpness_comparing_carry_1_q <= select_2441;
      sharpness_comparing_less_detail_0_q <= select_2448;
      sharpness_comparing_less_detail_1_q <= select_2454;
      sharpness_comparing_less_contrast_0_q <= select_2460;
      sharpness_comparing_less_contrast_1_q <= select_2466;
      counts_supervised_q <= select_2602;
      counts_textured_q <= and_2594_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2605});
      counts_explained_q <= and_2594_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2610});
      counts_nearer_q <= and_2594_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2615});
      counts_unproven_q <= and_2594_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2641});
      counts_regions_bad_q <= select_2657;
      counts_skin_supervised_q <= select_2664;
      counts_skin_textured_q <= select_2671;
      counts_skin_unproven_q <= select_2679;
      counts_on_skin_q <= select_2698;
      registration_half_across_q <= select_2776;
      registration_half_measured_q <= select_2781;
      registration_half_votes_down_q <= and_2754_s3_q ? 7'h0 : sum_2787;
      registration_half_votes_up_q <= and_2754_s3_q ? 7'h0 : sum_2795;
      registration_half_half_votes_down_q <= and_2754_s3_q ? 7'h0 : sum_2802;
      registration_half_half_votes_up_q <= and_2754_s3_q ? 7'h0 : sum_2809;
      registration_down_q <= and_2843 ? sum_2862 : registration_down_q;
      registration_up_q <= and_2843 ? sum_2871 : registration_up_q;
      registration_enough_q <= select_2885;
      registration_votes_down_q <= and_2890 ? less_2891 : registration_votes_down_q;
      registration_votes_up_q <= and_2890 ? less_2893 : registration_votes_up_q;
      registration_other_enough_q <= and_2899 ? select_2885 : registration_other_enough_q;
      registration_other_down_q <= and_2899 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2899 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_572_s3_q & and_2906)) & or_2931;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1792 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1795 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1796 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3014;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1821 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1823 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1824 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3019;
      patches_valid_0_q <= select_3024;
      patches_valid_1_q <= select_3029;
      patches_right_next_0_q <= select_3032;
      patches_right_next_1_q <= select_3035;
      patches_left_next_0_q <= select_3038;
      patches_left_next_1_q <= select_3041;
      patches_sums_values_0_q <= select_3465;
      patches_sums_values_1_q <= equal_1774_s3_q ? patches_sums_values_1_q : select_3466;
      patches_sums_values_2_q <= equal_1774_s3_q ? patches_sums_values_2_q : select_3468;
      patches_sums_values_3_q <= equal_1774_s3_q ? patches_sums_values_3_q : select_3470;
      patches_sums_values_4_q <= equal_1774_s3_q ? patches_sums_values_4_q : select_3472;
      patches_sums_values_5_q <= equal_1774_s3_q ? patches_sums_values_5_q : select_3474;
      patches_sums_values_6_q <= equal_1774_s3_q ? patches_sums_values_6_q : select_3476;
      patches_sums_values_7_q <= equal_1774_s3_q ? patches_sums_values_7_q : select_3478;
      patches_sums_values_8_q <= equal_1774_s3_q ? patches_sums_values_8_q : select_3480;
      patches_sums_values_9_q <= equal_1774_s3_q ? patches_sums_values_9_q : select_3482;
      patches_sums_values_10_q <= equal_1774_s3_q ? patches_sums_values_10_q : select_3484;
      patches_sums_values_11_q <= equal_1774_s3_q ? patches_sums_values_11_q : select_3486;
      patches_sums_values_12_q <= equal_1774_s3_q ? patches_sums_values_12_q : select_3488;
      patches_sums_values_13_q <= equal_1774_s3_q ? patches_sums_values_13_q : select_3490;
      patches_sums_values_14_q <= equal_1774_s3_q ? patches_sums_values_14_q : select_3492;
      patches_sums_values_15_q <= equal_1774_s3_q ? patches_sums_values_15_q : select_3494;
      patches_sums_values_16_q <= equal_1774_s3_q ? patches_sums_values_16_q : select_3496;
      patches_best_differing_q <= select_1978[9:0];
      patches_best_column_q <= select_1978[14:10];
      patches_quarters_0_places_q <= sum_3620;
      patches_quarters_0_up_q <= sum_3660;
      patches_quarters_0_down_q <= sum_3670;
      patches_quarters_1_places_q <= sum_3674;
      patches_quarters_1_up_q <= sum_3677;
      patches_quarters_1_down_q <= sum_3680;
      patches_quarters_2_places_q <= sum_3684;
      patches_quarters_2_up_q <= sum_3687;
      patches_quarters_2_down_q <= sum_3690;
      patches_quarters_3_places_q <= sum_3694;
      patches_quarters_3_up_q <= sum_3697;
      patches_quarters_3_down_q <= sum_3700;
      patches_word_places_q <= or_3728;
      patches_word_up_q <= ((select_3738 | select_3740) | select_3743) | select_3746;
      patches_word_down_q <= ((select_3749 | select_3751) | select_3754) | select_3757;
      patches_sum_places_q <= select_3767;
      patches_sum_up_q <= select_3770;
      patches_sum_down_q <= select_3773;
      patches_across_q <= sum_3785;
      patches_places_q <= select_3796;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3800;
      patches_partly_q <= or_3803;
      patches_clear_limit_q <= sum_3804[8:2];
      patches_complete_q <= select_3806;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3789 ? select_3811 : patches_found_q;
      patches_doubted_q <= select_3818;
      patches_doubted_before_q <= select_3819;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3823;
      patches_on_skin_q <= sum_3833;
      patches_large_q <= not_3835 & and_3840;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3845;
      patches_spoiled_q <= or_3849;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3856;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3866;
      segment_textured_q <= select_2003 + {5'h0, and_2605};
      segment_explained_q <= select_2008 + {5'h0, and_2610};
      segment_nearer_q <= select_2018 + {5'h0, and_2615};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_572_s3_q ? select_3939 : good_q;
      good_known_q <= select_3944;
      hidden_for_q <= select_3962;
      product_q <= equal_572_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3987;
      disagree_q <= equal_572_s3_q ? select_3931 : disagree_q;
      too_much_q <= equal_572_s3_q ? select_3997 : too_much_q;
      hides_q <= equal_572_s3_q ? select_3957 : hides_q;
      overlooks_q <= equal_572_s3_q ? select_4003 : overlooks_q;
      proven_q <= and_1971_s3_q ? select_4112 : proven_q;
      seen_q <= select_4170;
      nearer_q <= select_4176;
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
      averager_quarter_1_0_q <= select_2163;
      averager_quarter_1_1_q <= select_2165;
      averager_quarter_2_0_q <= select_2167;
      averager_quarter_2_1_q <= select_2169;
      averager_detail_0_q <= select_2181;
      averager_detail_1_q <= select_2189;
      census_changes_values_0_left_q <= and_547_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_547_s3_q ? sum_2273 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2275;
      census_changes_values_1_right_q <= select_2276;
      census_changes_values_2_left_q <= select_2277;
      census_changes_values_2_right_q <= select_2278;
      sharpness_last_mask_q <= and_547_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_547_s3_q ? select_2359[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_547_s3_q ? select_2359[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4007;
      box_textured_columns_values_1_q <= select_4010;
      box_textured_columns_values_2_q <= select_4013;
      box_textured_columns_values_3_q <= select_4016;
      box_textured_columns_values_4_q <= select_4019;
      box_textured_sum_sums_values_0_q <= equal_572_s3_q ? box_textured_sum_sums_values_0_q : select_4021;
      box_explained_columns_values_0_q <= select_4025;
      box_explained_columns_values_1_q <= select_4028;
      box_explained_columns_values_2_q <= select_4031;
      box_explained_columns_values_3_q <= select_4034;
      box_explained_columns_values_4_q <= select_4037;
      box_explained_sum_sums_values_0_q <= equal_572_s3_q ? box_explained_sum_sums_values_0_q : select_4039;
      box_shown_columns_values_0_q <= equal_572_s3_q ? box_shown_columns_values_0_q : select_4042;
      box_shown_columns_values_1_q <= select_4046;
      box_shown_columns_values_2_q <= select_4049;
      box_shown_columns_values_3_q <= select_4052;
      box_shown_columns_values_4_q <= select_4055;
      box_shown_sum_sums_values_0_q <= equal_572_s3_q ? box_shown_sum_sums_values_0_q : select_4057;
      box_nearer_columns_values_0_q <= equal_572_s3_q ? box_nearer_columns_values_0_q : select_4060;
      box_nearer_columns_values_1_q <= select_4064;
      box_nearer_columns_values_2_q <= select_4067;
      box_nearer_columns_values_3_q <= select_4070;
      box_nearer_columns_values_4_q <= select_4073;
      box_nearer_sum_sums_values_0_q <= equal_572_s3_q ? box_nearer_sum_sums_values_0_q : select_4075;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4114_s4_q;
  logic or_4177_s4_q;
  logic and_4178_s4_q;
  logic and_4186_s4_q;
  logic and_4189_s4_q;
  logic and_4195_s4_q;
  logic and_4199_s4_q;
  logic and_4205_s4_q;
  logic and_4209_s4_q;
  logic and_4217_s4_q;
  logic and_4222_s4_q;
  logic and_4225_s4_q;
  logic and_4229_s4_q;
  logic [5:0] select_4231_s4_q;
  logic [31:0] select_4248_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4114_s4_q <= said_q;
      or_4177_s4_q <= not_2350 | select_4170;
      and_4178_s4_q <= cfg_prove_i & select_4176;
      and_4186_s4_q <= equal_572_s3_q & (equal_3942_s3_q & (cfg_prove_i & or_4183));
      and_4189_s4_q <= equal_572_s3_q & (equal_3942_s3_q & (cfg_prove_i & or_3923));
      and_4195_s4_q <= and_4195;
      and_4199_s4_q <= equal_572_s3_q & and_4198;
      and_4205_s4_q <= equal_572_s3_q & (equal_3942_s3_q & (not_4191 & or_4202));
      and_4209_s4_q <= and_4209;
      and_4217_s4_q <= equal_572_s3_q & (equal_3942_s3_q & (cfg_prove_i & and_4214));
      and_4222_s4_q <= equal_572_s3_q & (equal_3942_s3_q & select_4220);
      and_4225_s4_q <= and_4225;
      and_4229_s4_q <= and_4229;
      select_4231_s4_q <= equal_572_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4248_s4_q <= equal_572_s3_q ? (x_s3_q[6] ? select_4246 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4177_s4_q;
  assign marks_nearer_o = and_4178_s4_q;
  assign verdict_valid_o = and_4114_s4_q;
  assign verdict_unproven_yet_o = and_4186_s4_q;
  assign verdict_untextured_o = and_4189_s4_q;
  assign verdict_disagree_o = and_4195_s4_q;
  assign verdict_moved_o = and_4199_s4_q;
  assign verdict_unsharp_left_o = and_4205_s4_q;
  assign verdict_unsharp_right_o = and_4209_s4_q;
  assign verdict_hidden_o = and_4217_s4_q;
  assign verdict_overlooked_o = and_4222_s4_q;
  assign verdict_out_of_step_o = and_4225_s4_q;
  assign frame_valid_o = and_4229_s4_q;
  assign frame_index_o = select_4231_s4_q;
  assign frame_word_o = select_4248_s4_q;
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
  assign unused_bits = ^{over[13:0], product_3838[4:0], sum_3804[1:0], sum_3759[1:0], product_3650[4:0], sum_2744[0], difference_2685[1:0], detail_4[1:0], detail_3[1:0], sum_2283[4:0], sum_1712[0], sum_1708[0], sum_729[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
