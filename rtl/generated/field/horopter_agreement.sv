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
  logic not_2348;
  assign not_2348 = ~cfg_prove_i;
  logic [5:0] sum_2561;
  assign sum_2561 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3620;
  assign difference_3620 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3833;
  assign not_3833 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3891;
  assign difference_3891 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4138;
  assign less_4138 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4139;
  assign sum_4139 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_4140;
  assign select_4140 = less_4138 ? {sum_4139, cfg_height_i[5:3]} : 8'h0;

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
  // hls/stages/census.hpp:33
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:38
  logic [2:0] select_509;
  assign select_509 = row_starts ? 3'h0 : raster_at_x_q;
  // hls/stages/census.hpp:124
  logic [7:0] select_512;
  assign select_512 = select_509[0] ? averager_place_q : (row_starts ? 8'h0 : (averager_place_q + 8'h1));
  // hls/stages/census.hpp:122
  logic or_516;
  assign or_516 = row_starts | (averager_inside_q & (~(averager_place_q == 8'hbc)));
  // hls/stages/census.hpp:124
  logic select_517;
  assign select_517 = select_509[0] ? averager_inside_q : or_516;
  // hls/stages/census.hpp:44
  logic or_518;
  assign or_518 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_520;
  assign and_520 = select_517 & (select_509[0] & or_518);
  // hls/stages/census.hpp:44
  logic [2:0] select_525;
  assign select_525 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/census.hpp:38
  logic [5:0] select_541;
  assign select_541 = row_starts ? 6'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] last;
  assign last = sample_pair_whole_q ? select_541 : 6'h0;
  // hls/stages/census.hpp:55
  logic equal_543;
  assign equal_543 = select_509 == 3'h7;
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
  // hls/stages/census.hpp:44
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
  logic [2:0] select_2142;
  assign select_2142 = sample_pair_whole_q ? (sample_last_q ? (select_525 + 3'h1) : select_525) : raster_at_y_q;
  logic [5:0] select_2144;
  assign select_2144 = sample_pair_whole_q ? (select_541 + {5'h0, equal_543}) : raster_at_column_q;
  logic [5:0] select_2147;
  assign select_2147 = sample_pair_whole_q ? (sample_last_q ? (select_675 + {5'h0, equal_544}) : select_675) : raster_at_row_q;
  logic select_2151;
  assign select_2151 = sample_pair_whole_q ? (sample_last_q ? (or_518 & (~raster_final_row_q)) : or_518) : raster_at_live_q;
  // hls/stages/census.hpp:54
  logic [8:0] select_2153;
  assign select_2153 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2157;
  assign select_2157 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [6:0] sum_2466;
  assign sum_2466 = {1'b0, last} + 7'h1;
  logic equal_2467;
  assign equal_2467 = {sum_2466[6], cfg_width_i[8:3]} == {1'b0, sum_2466[5:0]};
  // hls/stages/agreement.hpp:464
  logic and_2468;
  assign and_2468 = and_547 & equal_2467;
  // hls/stages/agreement.hpp:523
  logic select_2471;
  assign select_2471 = (and_2468 | (~ends_cell_q)) ? and_2468 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2471 ? (and_2468 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2475;
  assign select_2475 = select_2471 ? (and_2468 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2478;
  assign select_2478 = select_2471 ? (following_last_shift_q & (~and_2468)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2481;
  assign and_2481 = run_last_shift_q & equal_591;
  // hls/stages/agreement.hpp:616
  logic select_2483;
  assign select_2483 = equal_591 ? (~run_last_shift_q) : equal_592;
  // hls/stages/agreement.hpp:620
  logic equal_2484;
  assign equal_2484 = run_phase_q == 3'h1;
  logic not_2487;
  assign not_2487 = ~select_2483;
  // hls/stages/agreement.hpp:623
  logic equal_2489;
  assign equal_2489 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2490;
  assign and_2490 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2491;
  assign select_2491 = equal_2489 ? 2'h1 : {2{and_2490}};
  logic [2:0] select_2493;
  assign select_2493 = (and_2481 | (select_2483 | equal_2484)) ? (equal_2484 ? 3'h2 : {not_2487, {2{select_2483}}}) : (equal_576 ? 3'h6 : {select_2491[0], select_2491});
  // hls/stages/agreement.hpp:607
  logic and_2496;
  assign and_2496 = select_2483 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2499;
  assign select_2499 = (plan_shift_q[5] & select_2483) ? value : 7'h0;
  logic [1:0] or_2500;
  assign or_2500 = {2{so}} | select_2499[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] select_2501;
  assign select_2501 = select_2483 ? plan_columns_q : 8'h0;
  logic [6:0] or_2504;
  assign or_2504 = select_2501[6:0] | ((equal_2484 | equal_2489) ? whole_q : 7'h0);
  logic [1:0] or_2505;
  assign or_2505 = {2{and_2481}} | or_2504[3:2];
  // hls/stages/agreement.hpp:634
  logic [6:0] or_2507;
  assign or_2507 = {or_2504[6:4], or_2505, or_2504[1:0]} | (equal_576 ? drawn_q : 7'h0);
  logic [4:0] or_2508;
  assign or_2508 = {5{so}} | {or_2507[6], or_2507[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2512;
  assign not_2512 = ~run_shift_q[5];
  logic [6:0] difference_2514;
  assign difference_2514 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2515;
  assign select_2515 = equal_591 ? ({{7{not_2512}}, 1'b1} + run_span_q) : {difference_2514[6], difference_2514};
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2519;
  assign select_2519 = and_2468 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2521;
  assign select_2521 = select_2471 ? {select_2519[6], select_2519} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2524;
  assign select_2524 = select_2471 ? (and_2468 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [5:0] select_2532;
  assign select_2532 = and_547 ? (equal_2467 ? ((5'he < last[5:1]) ? 6'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2533;
  assign sum_2533 = {1'b0, last[5:2]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2535;
  assign select_2535 = and_547 ? (equal_2467 ? {sum_2533, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [4:0] sum_2536;
  assign sum_2536 = {1'b0, last[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2538;
  assign select_2538 = and_547 ? (equal_2467 ? {sum_2536, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2552;
  assign select_2552 = (ends_cell_q | select_2471) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_591 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2556;
  assign and_2556 = (~select_2471) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_2557;
  assign sum_2557 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_2559;
  assign select_2559 = equal_2467 ? ({sum_2557[6], cfg_height_i[8:3]} == {1'b0, sum_2557[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:318
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2935;
  assign select_2935 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2936;
  assign select_2936 = sample_pair_whole_q ? select_2935 : patches_phase_q;
  // hls/stages/patches.hpp:374
  logic and_2937;
  assign and_2937 = not_1674 & equal_1676;
  logic [8:0] select_2938;
  assign select_2938 = and_2937 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2939;
  assign select_2939 = and_2937 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2940;
  assign select_2940 = sample_pair_first_q ? select_2938 : select_2939;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2942;
  assign select_2942 = sample_pair_whole_q ? (row_starts ? select_2940[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2944;
  assign select_2944 = sample_pair_whole_q ? (row_starts ? select_2940[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2947;
  assign select_2947 = sample_pair_whole_q ? (equal_1678 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2949;
  assign select_2949 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1678}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:331
  logic equal_2950;
  assign equal_2950 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:332
  logic not_2951;
  assign not_2951 = ~equal_2950;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2953;
  assign select_2953 = sample_pair_whole_q ? (phase + {not_2951, 1'b1, not_2951, equal_2950}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_2955;
  assign equal_2955 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2959;
  assign select_2959 = equal_2955 ? ((select_2936 == 4'h6) ? 4'h0 : (select_2936 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2960;
  assign equal_2960 = select_2959 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2963;
  assign select_2963 = equal_2467 ? (equal_2960 ? 4'h6 : (select_2959 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2965;
  assign select_2965 = equal_2955 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2967;
  assign select_2967 = equal_2467 ? (select_2965 + {4'h0, equal_2960}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_2972;
  assign select_2972 = and_547 ? (equal_2467 ? ((6'h2 < row) & equal_2960) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2974;
  assign select_2974 = and_547 ? (equal_2467 ? select_2965 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:372
  logic [5:0] sum_2997;
  assign sum_2997 = {1'b0, select_675[5:1]} + 6'h1;
  logic less_2998;
  assign less_2998 = {sum_2997, select_675[0], select_525, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3001;
  assign select_3001 = row_starts ? (and_1683 ? (~less_2998) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:394
  logic or_3040;
  assign or_3040 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:396
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:188
  logic and_3046;
  assign and_3046 = equal_1774 & not_1781;
  // hls/stages/patches.hpp:400
  logic and_3047;
  assign and_3047 = not_1834 & and_3046;
  logic [1:0] select_3049;
  assign select_3049 = equal_1776 ? 2'h0 : (equal_1778 ? 2'h3 : {equal_1779, and_3047});
  // hls/stages/patches.hpp:280
  logic equal_3051;
  assign equal_3051 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:278
  logic not_3052;
  assign not_3052 = ~equal_3051;
  // hls/stages/patches.hpp:280
  logic equal_3053;
  assign equal_3053 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:276
  logic not_3054;
  assign not_3054 = ~equal_3053;
  // hls/stages/patches.hpp:284
  logic not_3056;
  assign not_3056 = ~(patches_following_q == 3'h2);
  logic and_3059;
  assign and_3059 = (~(patches_following_q == 3'h1)) & not_3056;
  // hls/stages/patches.hpp:398
  logic [1:0] select_3060;
  assign select_3060 = equal_3053 ? 2'h2 : {and_3059, not_3056};
  logic [3:0] select_3061;
  assign select_3061 = equal_3051 ? 4'h2 : {select_3060, {2{not_3054}}};
  // hls/stages/patches.hpp:406
  logic not_3064;
  assign not_3064 = ~or_3040;
  // hls/stages/patches.hpp:395
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:407
  logic [11:0] select_3069;
  assign select_3069 = or_3040 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:188
  logic [4:0] select_3071;
  assign select_3071 = or_3040 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

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
      raster_at_x_q <= sample_pair_whole_q ? (select_509 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2142;
      raster_at_column_q <= select_2144;
      raster_at_row_q <= select_2147;
      raster_at_live_q <= select_2151;
      raster_rows_left_q <= sample_pair_whole_q ? select_2153 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2157;
      averager_place_q <= sample_pair_whole_q ? select_512 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_517 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2475;
      run_last_shift_q <= select_2478;
      run_span_q <= select_2471 ? (and_2468 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2493;
      following_shift_q <= select_2483 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2496;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2499[6], or_2500, select_2499[3:0]};
      following_columns_q <= {select_2501[7], or_2508[4], or_2507[5:4], or_2508[3:0]};
      plan_shift_q <= equal_591 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2515;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2521;
      columns_left_q <= select_2524;
      last_q <= and_547 ? (equal_2467 ? last : last_q) : last_q;
      least_q <= select_2532;
      whole_q <= select_2535;
      drawn_q <= select_2538;
      age_q <= select_2471 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2471 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2552;
      ends_q <= and_2556;
      final_row_q <= and_547 ? select_2559 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2936;
      patches_band_rows_rows_to_next_q <= select_2942;
      patches_band_rows_number_q <= select_2944;
      patches_next_band_rows_to_next_q <= select_2947;
      patches_next_band_number_q <= select_2949;
      patches_first_band_rows_to_next_q <= select_2953;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2950 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_547 ? select_2963 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_547 ? select_2967 : patches_choosing_number_q;
      patches_chooses_q <= select_2972;
      patches_choosing_band_q <= select_2974;
      patches_capturing_q <= sample_pair_whole_q ? select_1810 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3001 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1804 : patches_row_q;
      patches_work_q <= or_3040 ? following : patches_work_q;
      patches_second_q <= not_1671 & (patches_second_q | (patches_ends_q & equal_1774));
      patches_following_q <= equal_1774 ? {2'h0, and_3046} : {equal_1776, select_3049};
      patches_following_beats_q <= {select_3061, not_3052};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_1806);
      patches_ends_q <= not_3064 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3069;
      patches_code_row_q <= select_3071;
      patches_column_q <= or_3040 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3064 & (patches_column_q == 5'h1e);
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
  logic row_starts_s1_q;
  logic [2:0] select_509_s1_q;
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
  logic equal_2467_s1_q;
  logic and_2468_s1_q;
  logic or_3040_s1_q;
  logic not_3064_s1_q;
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
      row_starts_s1_q <= row_starts;
      select_509_s1_q <= select_509;
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
      equal_2467_s1_q <= equal_2467;
      and_2468_s1_q <= and_2468;
      or_3040_s1_q <= or_3040;
      not_3064_s1_q <= not_3064;
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
  logic select_2564;
  assign select_2564 = equal_2467_s1_q ? (~({row_s1_q, 1'b0} < {sum_2561, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_2825;
  assign and_2825 = and_547_s1_q & (equal_2467_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_2826;
  assign and_2826 = and_2468_s1_q & and_2825;
  // hls/stages/registration.hpp:127
  logic and_2828;
  assign and_2828 = and_2468_s1_q & (~and_2825);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2829;
  assign select_2829 = and_2828 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2831;
  assign select_2831 = and_2826 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2829[15]}}, select_2829});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2832;
  assign select_2832 = and_2828 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2832[15]}}, select_2832};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2834;
  assign select_2834 = and_2826 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_2835;
  assign and_2835 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2835 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:188
  logic select_3079;
  assign select_3079 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:185
  logic [11:0] select_3082;
  assign select_3082 = equal_1776_s1_q ? patches_smooth_values_0_q : (or_1780_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3084;
  assign select_3084 = or_1780_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3086;
  assign select_3086 = equal_1774_s1_q ? patches_smooth_values_1_q : (equal_1776_s1_q ? patches_smooth_values_1_q : select_3084);
  logic [11:0] select_3087;
  assign select_3087 = or_1780_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3089;
  assign select_3089 = equal_1774_s1_q ? patches_smooth_values_2_q : (equal_1776_s1_q ? patches_smooth_values_2_q : select_3087);
  logic [11:0] select_3090;
  assign select_3090 = or_1780_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3092;
  assign select_3092 = equal_1774_s1_q ? patches_smooth_values_3_q : (equal_1776_s1_q ? patches_smooth_values_3_q : select_3090);
  logic [10:0] select_3094;
  assign select_3094 = equal_1776_s1_q ? patches_down_values_0_q : (or_1780_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3097;
  assign select_3097 = equal_1776_s1_q ? patches_down_values_1_q : (or_1780_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3100;
  assign select_3100 = equal_1776_s1_q ? patches_down_values_2_q : (or_1780_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3103;
  assign select_3103 = equal_1776_s1_q ? patches_down_values_3_q : (or_1780_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:176
  logic and_3140;
  assign and_3140 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:414
  logic [4:0] select_3145;
  assign select_3145 = or_3040_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:416
  logic [3:0] select_3147;
  assign select_3147 = and_3140 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:185
  logic [4:0] select_3503;
  assign select_3503 = equal_1774_s1_q ? patches_summed_down_by_q : (equal_1776_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:557
  logic and_3536;
  assign and_3536 = less_1954 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:561
  logic select_3539;
  assign select_3539 = equal_1957 ? (less_1954 ? (not_1958 & and_3536) : and_3536) : and_3536;
  // hls/stages/patches.hpp:185
  logic select_3542;
  assign select_3542 = equal_1774_s1_q ? (less_1954 ? (not_1956 & select_3539) : select_3539) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3881;
  assign select_3881 = so_s1_q ? (and_2835 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3883;
  assign sum_3883 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3884;
  assign select_3884 = sum_1992[5] ? {1'b1, sum_1992[4:0], region_across_rest_q[2:0]} : sum_3883;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3886;
  assign select_3886 = equal_2467_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3889;
  assign select_3889 = equal_2467_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

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
      row_q <= and_547_s1_q ? (equal_2467_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_547_s1_q ? select_2564 : lower_half_q;
      registration_slope_row_q <= select_2831;
      registration_slope_change_q <= select_2834;
      registration_slope_q <= so_s1_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3064_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3064_s1_q & select_3079;
      patches_smooth_values_0_q <= equal_1774_s1_q ? patches_smooth_values_0_q : select_3082;
      patches_smooth_values_1_q <= select_3086;
      patches_smooth_values_2_q <= select_3089;
      patches_smooth_values_3_q <= select_3092;
      patches_down_values_0_q <= equal_1774_s1_q ? patches_down_values_0_q : select_3094;
      patches_down_values_1_q <= equal_1774_s1_q ? patches_down_values_1_q : select_3097;
      patches_down_values_2_q <= equal_1774_s1_q ? patches_down_values_2_q : select_3100;
      patches_down_values_3_q <= equal_1774_s1_q ? patches_down_values_3_q : select_3103;
      patches_down_by_q <= or_3040_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3140});
      patches_along_q <= select_3145;
      patches_match_row_q <= or_3040_s1_q ? 4'h0 : select_3147;
      patches_summed_last_q <= not_1775_s1_q & (equal_1776_s1_q & and_3140);
      patches_summed_down_by_q <= select_3503;
      patches_step_q <= or_3040_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3542;
      region_across_rest_q <= select_3881;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3884;
      columns_begin_rest_q <= and_547_s1_q ? select_3886 : columns_begin_rest_q;
      columns_begin_back_q <= and_547_s1_q ? select_3889 : columns_begin_back_q;
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
  logic row_starts_s2_q;
  logic [2:0] select_509_s2_q;
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
  logic equal_2278_s2_q;
  logic equal_2467_s2_q;
  logic and_2594_s2_q;
  logic equal_2679_s2_q;
  logic less_3116_s2_q;
  logic equal_3459_s2_q;
  logic equal_3543_s2_q;
  logic less_3869_s2_q;
  logic equal_4088_s2_q;
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
      row_starts_s2_q <= row_starts_s1_q;
      select_509_s2_q <= select_509_s1_q;
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
      equal_2278_s2_q <= (last_s1_2_q | row_s1_q) == 6'h0;
      equal_2467_s2_q <= equal_2467_s1_q;
      and_2594_s2_q <= or_577_s1_q & (not_581_s1_q & and_605);
      equal_2679_s2_q <= shift == 6'h0;
      less_3116_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3459_s2_q <= patches_match_row_q == 4'h0;
      equal_3543_s2_q <= patches_step_q[6:5] == 2'h2;
      less_3869_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4088_s2_q <= row_s1_q[5:3] == 3'h0;
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
  assign select_524 = select_509_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:129
  logic [11:0] sum_528;
  assign sum_528 = select_524 + (equal_526_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:117
  logic [11:0] sum_530;
  assign sum_530 = {4'h0, sample_pair_pixel_1_q} + (select_509_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:129
  logic [11:0] sum_532;
  assign sum_532 = sum_530 + (equal_526_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_509_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_536;
  assign and_536 = whole & (averager_memory_rdata_q[24] | equal_526_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_509_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:131
  logic and_540;
  assign and_540 = all_of_skin & (averager_memory_rdata_q[25] | equal_526_s2_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_520_s2_q ? sum_528[11:3] : 9'h0;
  // hls/stages/census.hpp:134
  logic equal_550;
  assign equal_550 = select_509_s2_q == 3'h1;
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
  logic [10:0] select_2169;
  assign select_2169 = sample_pair_whole_s2_q ? (and_545_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2171;
  assign select_2171 = sample_pair_whole_s2_q ? (and_545_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2191;
  assign select_2191 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2193;
  assign select_2193 = sample_pair_whole_s2_q ? (and_545_s2_q ? select_560 : averager_mask_q) : averager_mask_q;
  logic select_2195;
  assign select_2195 = sample_pair_whole_s2_q ? (and_545_s2_q ? select_564 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2196;
  assign select_2196 = and_547_s2_q ? select_553 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2197;
  assign select_2197 = and_547_s2_q ? select_557 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2199;
  assign select_2199 = and_547_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2200;
  assign select_2200 = and_547_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2201;
  assign select_2201 = and_547_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2202;
  assign select_2202 = and_547_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2203;
  assign select_2203 = and_547_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2204;
  assign select_2204 = and_547_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2205;
  assign select_2205 = and_547_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2206;
  assign select_2206 = and_547_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2207;
  assign select_2207 = and_547_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2208;
  assign select_2208 = and_547_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2209;
  assign select_2209 = and_547_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2210;
  assign select_2210 = and_547_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2211;
  assign select_2211 = and_547_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2212;
  assign select_2212 = and_547_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2213;
  assign select_2213 = and_547_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2214;
  assign select_2214 = and_547_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2215;
  assign select_2215 = and_547_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2216;
  assign select_2216 = and_547_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2217;
  assign select_2217 = and_547_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2218;
  assign select_2218 = and_547_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2219;
  assign select_2219 = and_547_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2220;
  assign select_2220 = and_547_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2221;
  assign select_2221 = and_547_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2222;
  assign select_2222 = and_547_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2223;
  assign select_2223 = and_547_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2224;
  assign select_2224 = and_547_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2225;
  assign select_2225 = and_547_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2226;
  assign select_2226 = and_547_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2227;
  assign select_2227 = and_547_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2228;
  assign select_2228 = and_547_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2229;
  assign select_2229 = and_547_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2230;
  assign select_2230 = and_547_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2231;
  assign select_2231 = and_547_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2232;
  assign select_2232 = and_547_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2233;
  assign select_2233 = and_547_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2234;
  assign select_2234 = and_547_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2235;
  assign select_2235 = and_547_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2236;
  assign select_2236 = and_547_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2237;
  assign select_2237 = and_547_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2238;
  assign select_2238 = and_547_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2239;
  assign select_2239 = and_547_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2240;
  assign select_2240 = and_547_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2241;
  assign select_2241 = and_547_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2242;
  assign select_2242 = and_547_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2243;
  assign select_2243 = and_547_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2244;
  assign select_2244 = and_547_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2245;
  assign select_2245 = and_547_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2246;
  assign select_2246 = and_547_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2247;
  assign select_2247 = and_547_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2248;
  assign select_2248 = and_547_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2249;
  assign select_2249 = and_547_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2250;
  assign select_2250 = and_547_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2251;
  assign select_2251 = and_547_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2253;
  assign difference_2253 = {1'b0, select_557} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2254;
  assign xor_2254 = difference_2253[8:0] ^ {9{difference_2253[9]}};
  logic [9:0] sum_2255;
  assign sum_2255 = {9'h0, difference_2253[9]} + {1'b0, xor_2254};
  logic [9:0] difference_2256;
  assign difference_2256 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2257;
  assign xor_2257 = difference_2256[8:0] ^ {9{difference_2256[9]}};
  logic [9:0] sum_2258;
  assign sum_2258 = {9'h0, difference_2256[9]} + {1'b0, xor_2257};
  logic [9:0] difference_2260;
  assign difference_2260 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2261;
  assign xor_2261 = difference_2260[8:0] ^ {9{difference_2260[9]}};
  logic [9:0] sum_2262;
  assign sum_2262 = {9'h0, difference_2260[9]} + {1'b0, xor_2261};
  logic [10:0] sum_2263;
  assign sum_2263 = ({1'b0, sum_2255} + {1'b0, sum_2258}) + {1'b0, sum_2262};
  logic [9:0] difference_2264;
  assign difference_2264 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2265;
  assign xor_2265 = difference_2264[8:0] ^ {9{difference_2264[9]}};
  logic [9:0] sum_2266;
  assign sum_2266 = {9'h0, difference_2264[9]} + {1'b0, xor_2265};
  logic [9:0] difference_2268;
  assign difference_2268 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2269;
  assign xor_2269 = difference_2268[8:0] ^ {9{difference_2268[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2290;
  assign sum_2290 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2292;
  assign sum_2292 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1142
  logic equal_2293;
  assign equal_2293 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2294;
  assign select_2294 = equal_2293 ? sum_2290 : moments_before_0_q;
  logic [13:0] select_2296;
  assign select_2296 = equal_2293 ? sum_2292 : moments_before_1_q;
  // hls/stages/agreement.hpp:788
  logic select_2299;
  assign select_2299 = equal_572_s2_q ? (moments_has_before_q | equal_2293) : moments_has_before_q;
  logic [13:0] select_2302;
  assign select_2302 = equal_572_s2_q ? ((select_2296 < select_2294) ? select_2294 : select_2296) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2303;
  assign sum_2303 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2306;
  assign select_2306 = equal_572_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2303)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2307;
  assign sum_2307 = {1'b0, sum_2292} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2310;
  assign select_2310 = equal_572_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2307)) : moments_left_alone_q;
  logic select_2313;
  assign select_2313 = equal_572_s2_q ? (~({3'h0, select_2296[13:2]} < sum_2307)) : moments_left_other_stops_q;
  logic select_2316;
  assign select_2316 = equal_572_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2303)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2317;
  assign sum_2317 = {1'b0, sum_2290} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2320;
  assign select_2320 = equal_572_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2317)) : moments_right_alone_q;
  logic select_2323;
  assign select_2323 = equal_572_s2_q ? (~({3'h0, select_2294[13:2]} < sum_2317)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2326;
  assign or_2326 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2334;
  assign and_2334 = not_573_s2_q & (not_575_s2_q & (equal_576_s2_q & (inside_v_s2_q & and_1595)));
  logic and_2338;
  assign and_2338 = not_573_s2_q & (not_575_s2_q & (equal_576_s2_q & (inside_v_s2_q & and_1604)));
  // hls/stages/moments.hpp:94
  logic and_2340;
  assign and_2340 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2343;
  assign select_2343 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2340)) : and_2340;
  // hls/stages/agreement.hpp:788
  logic and_2347;
  assign and_2347 = equal_572_s2_q & (equal_2293 & (cfg_prove_i & (cfg_same_table_i & select_2343)));
  // hls/stages/moments.hpp:95
  logic and_2350;
  assign and_2350 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:371
  logic [9:0] difference_2364;
  assign difference_2364 = {1'b0, select_553} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2364[9]} + (difference_2364[8:0] ^ {9{difference_2364[9]}});
  logic [9:0] difference_2376;
  assign difference_2376 = {1'b0, select_557} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2376[9]} + (difference_2376[8:0] ^ {9{difference_2376[9]}});
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2567;
  assign select_2567 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2568;
  assign select_2568 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2569;
  assign select_2569 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2570;
  assign select_2570 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2571;
  assign select_2571 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2572;
  assign select_2572 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2576;
  assign select_2576 = slot_s2_q[0] ? 8'h0 : sum_1009;
  // hls/stages/agreement.hpp:751
  logic less_2577;
  assign less_2577 = select_2576 < select_1509;
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2579;
  assign select_2579 = slot_s2_q[0] ? 7'h0 : sum_1535;
  // hls/stages/agreement.hpp:788
  logic not_2584;
  assign not_2584 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2585;
  assign less_2585 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_2592;
  assign and_2592 = and_547_s2_q & (equal_677_s2_q & equal_2467_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_2598;
  assign and_2598 = not_573_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2594_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_2618;
  assign and_2618 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2619;
  assign and_2619 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2620;
  assign and_2620 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2621;
  assign and_2621 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2623;
  assign sum_2623 = {1'b0, and_2620} + ({1'b0, explained} + {1'b0, and_2621});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2618} + ({2'h0, and_2619} + {1'b0, sum_2623});
  // hls/stages/agreement.hpp:788
  logic and_2659;
  assign and_2659 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2594_s2_q & and_2015)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2683;
  assign difference_2683 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2686;
  assign less_2686 = {2'h0, difference_2683[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_2689;
  assign and_2689 = not_581_s2_q & (((and_2013_s2_q & and_632) & equal_2679_s2_q) & (~less_2686));
  // hls/stages/agreement.hpp:788
  logic and_2693;
  assign and_2693 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_577_s2_q & and_2689)));
  // hls/stages/agreement.hpp:149
  logic and_2698;
  assign and_2698 = not_581_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2700;
  assign and_2700 = not_581_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2701;
  assign select_2701 = or_577_s2_q ? {and_2700, and_2698} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2703;
  assign select_2703 = less_580_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2704;
  assign select_2704 = or_577_s2_q ? select_2703 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_2706;
  assign and_2706 = and_634 & (select_2701[0] & select_2704[0]);
  // hls/stages/agreement.hpp:788
  logic and_2710;
  assign and_2710 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2701[1] & and_2706)));
  logic and_2711;
  assign and_2711 = not_573_s2_q & and_2710;
  logic and_2717;
  assign and_2717 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2704[1] & and_2706)));
  logic and_2718;
  assign and_2718 = not_573_s2_q & and_2717;
  // hls/stages/registration.hpp:76
  logic less_2721;
  assign less_2721 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2723;
  assign select_2723 = or_577_s2_q ? (less_580_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2725;
  assign select_2725 = or_577_s2_q ? (less_580_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2727;
  assign select_2727 = or_577_s2_q ? (less_580_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2725} - {1'b0, select_2727};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2729;
  assign select_2729 = rise_2[8] ? select_2725 : select_2727;
  logic [8:0] fall;
  assign fall = {1'b0, select_2723} - {1'b0, select_2729};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2732;
  assign not_2732 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2721 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2732};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2734;
  assign xor_2734 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2734};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2740;
  assign select_2740 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2721 ? {taken, 1'b1} : {not_2732, select_2740, not_2732};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2742;
  assign sum_2742 = {left, 1'b1} + {taken_2, less_2721};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2744;
  assign select_2744 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2746;
  assign select_2746 = equal_572_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_2748;
  assign select_2748 = equal_572_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2749;
  assign equal_2749 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_2753;
  assign and_2753 = and_634 & less_1697_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2755;
  assign select_2755 = or_577_s2_q ? (less_580_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2759;
  assign sum_2759 = select_2755[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2762;
  assign select_2762 = (select_2725 < select_2727) ? ({sum_2759, select_2755[0], 5'h0} - {3'h0, select_2744}) : {sum_2759, select_2755[0], select_2744};
  logic [7:0] select_2763;
  assign select_2763 = ((select_2755 == 3'h0) | (select_2755 == 3'h4)) ? {sum_2759, select_2755[0], 5'h0} : select_2762;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2763[7]}}, select_2763} - {sum_1716[9], sum_1716, sum_1712[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2766;
  assign select_2766 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2766[11:7])) ? 12'h7f : select_2766;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2787;
  assign difference_2787 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2789;
  assign and_2789 = and_2753 & ($signed(difference_2787) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2802;
  assign less_2802 = $signed(difference_2787) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_2810;
  assign select_2810 = so_s2_q ? (equal_2749 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2813;
  assign select_2813 = so_s2_q ? (equal_1698 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2818;
  assign select_2818 = (sum_1611 == 2'h2) ? (registration_fresh_q & (~select_1658)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2820;
  assign select_2820 = so_s2_q ? (and_1653 ? select_2818 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2822;
  assign select_2822 = and_2592 ? 4'hf : (equal_572_s2_q ? registration_fresh_q : select_2820);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1608;
  // hls/stages/registration.hpp:258
  logic not_2843;
  assign not_2843 = ~quarter_2[1];
  logic [3:0] select_2844;
  assign select_2844 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2843, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2843};
  // hls/stages/patches.hpp:91
  logic parity_2978;
  assign parity_2978 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2979;
  assign select_2979 = equal_2467_s2_q ? {patches_chance_q[14:0], parity_2978} : patches_chance_q;
  // hls/stages/patches.hpp:346
  logic not_2981;
  assign not_2981 = ~and_1772;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_2983;
  assign select_2983 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2983};
  // hls/stages/agreement.hpp:788
  logic and_2989;
  assign and_2989 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:157
  logic and_2993;
  assign and_2993 = not_2981 & (patches_fixed_q | ((not_573_s2_q & and_2989) & and_1744));
  // hls/stages/patches.hpp:355
  logic not_3005;
  assign not_3005 = ~select_1687[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3007;
  assign select_3007 = sample_pair_whole_s2_q ? (equal_1688 ? select_1687 : {not_3005, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:523
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:185
  logic [51:0] select_3106;
  assign select_3106 = or_1780_s2_q ? {and_1925_s2_q, and_1922_s2_q, and_1906_s2_q, and_1903, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3108;
  assign select_3108 = equal_1774_s2_q ? patches_codes_at_q : (equal_1776_s2_q ? other[55:4] : select_3106);
  // hls/stages/patches.hpp:506
  logic [27:0] word;
  assign word = or_1879_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:522
  logic [27:0] select_3111;
  assign select_3111 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:185
  logic [27:0] select_3113;
  assign select_3113 = equal_1776_s2_q ? (new_row_s2_q ? word : select_3111) : patches_codes_further_q;
  // hls/stages/patches.hpp:524
  logic [55:0] select_3115;
  assign select_3115 = less_1866_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:494
  logic [55:0] select_3117;
  assign select_3117 = less_3116_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:185
  logic [55:0] select_3119;
  assign select_3119 = or_1780_s2_q ? (equal_1779_s2_q ? patches_next_codes_q : select_3117) : patches_next_codes_q;
  logic [55:0] select_3121;
  assign select_3121 = equal_1774_s2_q ? patches_next_codes_q : (equal_1776_s2_q ? select_3115 : select_3119);
  // hls/stages/count_bits.hpp:24
  logic parity_3126;
  assign parity_3126 = ^{and_1925_s2_q, and_1922_s2_q, and_1906_s2_q, and_1903};
  // hls/stages/count_bits.hpp:25
  logic or_3130;
  assign or_3130 = ({and_1906_s2_q, and_1903} == 2'h3) | (and_1922_s2_q & (and_1906_s2_q | and_1903));
  logic and_3131;
  assign and_3131 = and_1925_s2_q & (^{and_1922_s2_q, and_1906_s2_q, and_1903});
  // hls/stages/count_bits.hpp:24
  logic xor_3132;
  assign xor_3132 = or_3130 ^ and_3131;
  // hls/stages/count_bits.hpp:27
  logic and_3133;
  assign and_3133 = or_3130 & and_3131;
  // hls/stages/patches.hpp:185
  logic [2:0] select_3135;
  assign select_3135 = or_1780_s2_q ? (and_1948_s2_q ? {and_3133, xor_3132, parity_3126} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3139;
  assign sum_3139 = {7'h0, patches_set_q} + (equal_1779_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:523
  logic [47:0] select_3149;
  assign select_3149 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:185
  logic [47:0] select_3151;
  assign select_3151 = equal_1774_s2_q ? patches_left_row_q : (equal_1776_s2_q ? select_3149 : patches_left_row_q);
  // hls/stages/patches.hpp:525
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3149;
  // hls/stages/count_bits.hpp:24
  logic xor_3155;
  assign xor_3155 = bits[17] ^ (^{select_3149[16:15], other[16:15]});
  logic xor_3158;
  assign xor_3158 = bits[11] ^ (^{select_3149[10:9], other[10:9]});
  logic xor_3161;
  assign xor_3161 = bits[14] ^ (^{select_3149[13:12], other[13:12]});
  logic xor_3164;
  assign xor_3164 = xor_3155 ^ (^{select_3149[14:9], other[14:9]});
  logic xor_3167;
  assign xor_3167 = bits[47] ^ (^{select_3149[46:45], other[46:45]});
  logic xor_3170;
  assign xor_3170 = bits[8] ^ (^{select_3149[7:6], other[7:6]});
  logic xor_3173;
  assign xor_3173 = bits[2] ^ (^{select_3149[1:0], other[1:0]});
  logic xor_3176;
  assign xor_3176 = bits[5] ^ (^{select_3149[4:3], other[4:3]});
  logic xor_3179;
  assign xor_3179 = xor_3170 ^ (^{select_3149[5:0], other[5:0]});
  logic parity_3181;
  assign parity_3181 = ^{select_3149[47:45], select_3149[8:0], other[47:45], other[8:0]};
  logic xor_3182;
  assign xor_3182 = xor_3164 ^ parity_3181;
  logic xor_3185;
  assign xor_3185 = bits[44] ^ (^{select_3149[43:42], other[43:42]});
  logic xor_3188;
  assign xor_3188 = bits[38] ^ (^{select_3149[37:36], other[37:36]});
  logic xor_3191;
  assign xor_3191 = bits[41] ^ (^{select_3149[40:39], other[40:39]});
  logic xor_3197;
  assign xor_3197 = bits[26] ^ (^{select_3149[25:24], other[25:24]});
  logic xor_3200;
  assign xor_3200 = bits[20] ^ (^{select_3149[19:18], other[19:18]});
  logic xor_3203;
  assign xor_3203 = bits[23] ^ (^{select_3149[22:21], other[22:21]});
  logic xor_3206;
  assign xor_3206 = xor_3197 ^ (^{select_3149[23:18], other[23:18]});
  logic xor_3209;
  assign xor_3209 = bits[35] ^ (^{select_3149[34:33], other[34:33]});
  logic xor_3212;
  assign xor_3212 = bits[29] ^ (^{select_3149[28:27], other[28:27]});
  logic xor_3215;
  assign xor_3215 = bits[32] ^ (^{select_3149[31:30], other[31:30]});
  logic xor_3218;
  assign xor_3218 = xor_3209 ^ (^{select_3149[32:27], other[32:27]});
  logic xor_3219;
  assign xor_3219 = xor_3206 ^ xor_3218;
  // hls/stages/count_bits.hpp:25
  logic or_3227;
  assign or_3227 = (xor_3158 & xor_3161) | (xor_3155 & (xor_3158 | xor_3161));
  logic or_3231;
  assign or_3231 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3235;
  assign or_3235 = (xor_3173 & xor_3176) | (xor_3170 & (xor_3173 | xor_3176));
  // hls/stages/count_bits.hpp:23
  logic or_3242;
  assign or_3242 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3246;
  assign or_3246 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3250;
  assign or_3250 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3253;
  assign parity_3253 = ^{or_3250, or_3246, or_3242};
  // hls/stages/count_bits.hpp:23
  logic or_3257;
  assign or_3257 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3261;
  assign or_3261 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3265;
  assign or_3265 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3268;
  assign parity_3268 = ^{or_3265, or_3261, or_3257};
  logic parity_3271;
  assign parity_3271 = ^{or_3265, or_3261, or_3257, or_3250, or_3246, or_3242, or_3235, or_3231, or_3227};
  // hls/stages/count_bits.hpp:23
  logic or_3275;
  assign or_3275 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3279;
  assign or_3279 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3283;
  assign or_3283 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3291;
  assign or_3291 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3295;
  assign or_3295 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3299;
  assign or_3299 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3302;
  assign parity_3302 = ^{or_3299, or_3295, or_3291};
  // hls/stages/count_bits.hpp:23
  logic or_3306;
  assign or_3306 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3310;
  assign or_3310 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3314;
  assign or_3314 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3317;
  assign parity_3317 = ^{or_3314, or_3310, or_3306};
  logic parity_3320;
  assign parity_3320 = ^{or_3314, or_3310, or_3306, or_3299, or_3295, or_3291, or_3283, or_3279, or_3275};
  // hls/stages/count_bits.hpp:25
  logic or_3324;
  assign or_3324 = (xor_3188 & xor_3191) | (xor_3185 & (xor_3188 | xor_3191));
  logic or_3328;
  assign or_3328 = (xor_3200 & xor_3203) | (xor_3197 & (xor_3200 | xor_3203));
  logic or_3332;
  assign or_3332 = (xor_3212 & xor_3215) | (xor_3209 & (xor_3212 | xor_3215));
  // hls/stages/count_bits.hpp:24
  logic parity_3335;
  assign parity_3335 = ^{or_3332, or_3328, or_3324};
  // hls/stages/count_bits.hpp:25
  logic and_3336;
  assign and_3336 = xor_3182 & (^{xor_3219, select_3149[44:36], other[44:36]});
  logic or_3340;
  assign or_3340 = (xor_3167 & xor_3179) | (xor_3164 & (xor_3167 | xor_3179));
  logic and_3343;
  assign and_3343 = (xor_3185 ^ (^{select_3149[41:36], other[41:36]})) & (xor_3206 | xor_3218);
  logic or_3344;
  assign or_3344 = (xor_3206 & xor_3218) | and_3343;
  // hls/stages/count_bits.hpp:24
  logic parity_3347;
  assign parity_3347 = ^{or_3344, or_3340, and_3336};
  logic parity_3350;
  assign parity_3350 = ^{or_3344, or_3340, and_3336, or_3332, or_3328, or_3324, or_3314, or_3310, or_3306, or_3299, or_3295, or_3291, or_3283, or_3279, or_3275};
  logic parity_3352;
  assign parity_3352 = ^{or_3344, or_3340, and_3336, or_3332, or_3328, or_3324, or_3314, or_3310, or_3306, or_3299, or_3295, or_3291, or_3283, or_3279, or_3275, or_3265, or_3261, or_3257, or_3250, or_3246, or_3242, or_3235, or_3231, or_3227};
  // hls/stages/count_bits.hpp:25
  logic and_3353;
  assign and_3353 = parity_3271 & parity_3350;
  logic or_3357;
  assign or_3357 = (parity_3253 & parity_3268) | ((^{or_3235, or_3231, or_3227}) & (parity_3253 | parity_3268));
  logic or_3361;
  assign or_3361 = (parity_3335 & parity_3347) | (parity_3320 & (parity_3335 | parity_3347));
  logic or_3368;
  assign or_3368 = (parity_3302 & parity_3317) | ((^{or_3283, or_3279, or_3275}) & (parity_3302 | parity_3317));
  logic or_3372;
  assign or_3372 = (or_3328 & or_3332) | (or_3324 & (or_3328 | or_3332));
  logic or_3376;
  assign or_3376 = (or_3340 & or_3344) | (and_3336 & (or_3340 | or_3344));
  // hls/stages/count_bits.hpp:23
  logic or_3383;
  assign or_3383 = (or_3279 & or_3283) | (or_3275 & (or_3279 | or_3283));
  // hls/stages/count_bits.hpp:25
  logic or_3387;
  assign or_3387 = (or_3295 & or_3299) | (or_3291 & (or_3295 | or_3299));
  logic or_3391;
  assign or_3391 = (or_3310 & or_3314) | (or_3306 & (or_3310 | or_3314));
  // hls/stages/count_bits.hpp:24
  logic parity_3394;
  assign parity_3394 = ^{or_3391, or_3387, or_3383};
  // hls/stages/count_bits.hpp:23
  logic or_3398;
  assign or_3398 = (or_3231 & or_3235) | (or_3227 & (or_3231 | or_3235));
  // hls/stages/count_bits.hpp:25
  logic or_3402;
  assign or_3402 = (or_3246 & or_3250) | (or_3242 & (or_3246 | or_3250));
  logic or_3406;
  assign or_3406 = (or_3261 & or_3265) | (or_3257 & (or_3261 | or_3265));
  // hls/stages/count_bits.hpp:24
  logic parity_3409;
  assign parity_3409 = ^{or_3406, or_3402, or_3398};
  logic parity_3412;
  assign parity_3412 = ^{or_3406, or_3402, or_3398, or_3391, or_3387, or_3383, or_3376, or_3372, or_3368};
  logic parity_3414;
  assign parity_3414 = ^{or_3406, or_3402, or_3398, or_3391, or_3387, or_3383, or_3376, or_3372, or_3368, or_3361, or_3357, and_3353};
  // hls/stages/count_bits.hpp:25
  logic or_3418;
  assign or_3418 = (or_3372 & or_3376) | (or_3368 & (or_3372 | or_3376));
  logic or_3422;
  assign or_3422 = (or_3387 & or_3391) | (or_3383 & (or_3387 | or_3391));
  logic or_3426;
  assign or_3426 = (or_3402 & or_3406) | (or_3398 & (or_3402 | or_3406));
  // hls/stages/count_bits.hpp:24
  logic parity_3429;
  assign parity_3429 = ^{or_3426, or_3422, or_3418};
  // hls/stages/count_bits.hpp:25
  logic and_3430;
  assign and_3430 = (^{or_3361, or_3357, and_3353}) & parity_3412;
  logic or_3434;
  assign or_3434 = (or_3357 & or_3361) | (and_3353 & (or_3357 | or_3361));
  logic or_3438;
  assign or_3438 = (parity_3394 & parity_3409) | ((^{or_3376, or_3372, or_3368}) & (parity_3394 | parity_3409));
  // hls/stages/count_bits.hpp:24
  logic parity_3441;
  assign parity_3441 = ^{or_3438, or_3434, and_3430};
  // hls/stages/count_bits.hpp:25
  logic and_3443;
  assign and_3443 = parity_3429 & parity_3441;
  logic or_3447;
  assign or_3447 = (or_3422 & or_3426) | (or_3418 & (or_3422 | or_3426));
  logic or_3451;
  assign or_3451 = (or_3434 & or_3438) | (and_3430 & (or_3434 | or_3438));
  // hls/stages/patches.hpp:185
  logic [4:0] select_3496;
  assign select_3496 = equal_1776_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3499;
  assign select_3499 = equal_1774_s2_q ? patches_summed_first_q : (equal_1776_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:557
  logic [9:0] select_3506;
  assign select_3506 = less_1954_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3509;
  assign select_3509 = equal_1957_s2_q ? (less_1954_s2_q ? (equal_1957_s2_q ? 10'h0 : select_3506) : 10'h0) : select_3506;
  logic [9:0] select_3511;
  assign select_3511 = less_1954_s2_q ? (equal_1955_s2_q ? 10'h0 : select_3509) : select_3509;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3513;
  assign select_3513 = less_1954_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3516;
  assign select_3516 = equal_1957_s2_q ? (less_1954_s2_q ? (equal_1957_s2_q ? 5'h0 : select_3513) : 5'h0) : select_3513;
  logic [4:0] select_3518;
  assign select_3518 = less_1954_s2_q ? (equal_1955_s2_q ? 5'h0 : select_3516) : select_3516;
  // hls/stages/patches.hpp:557
  logic [4:0] select_3520;
  assign select_3520 = less_1954_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:561
  logic [4:0] select_3523;
  assign select_3523 = equal_1957_s2_q ? (less_1954_s2_q ? (equal_1957_s2_q ? 5'h0 : select_3520) : 5'h0) : select_3520;
  logic [4:0] select_3525;
  assign select_3525 = less_1954_s2_q ? (equal_1955_s2_q ? 5'h0 : select_3523) : select_3523;
  // hls/stages/patches.hpp:557
  logic and_3528;
  assign and_3528 = less_1954_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:561
  logic select_3531;
  assign select_3531 = equal_1957_s2_q ? (less_1954_s2_q ? (not_1958_s2_q & and_3528) : and_3528) : and_3528;
  // hls/stages/patches.hpp:185
  logic select_3534;
  assign select_3534 = equal_1774_s2_q ? (less_1954_s2_q ? (not_1956_s2_q & select_3531) : select_3531) : patches_read_first_q;
  // hls/stages/patches.hpp:179
  logic or_3545;
  assign or_3545 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3546;
  assign and_3546 = patches_read_searches_s2_q & or_3545;
  // hls/stages/patches.hpp:541
  logic [4:0] select_3547;
  assign select_3547 = and_3546 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:548
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3547};
  // hls/stages/patches.hpp:557
  logic and_3551;
  assign and_3551 = less_1954_s2_q & (equal_3543_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:561
  logic select_3554;
  assign select_3554 = equal_1957_s2_q ? (less_1954_s2_q ? (not_1958_s2_q & and_3551) : and_3551) : and_3551;
  // hls/stages/patches.hpp:185
  logic select_3557;
  assign select_3557 = equal_1774_s2_q ? (less_1954_s2_q ? (not_1956_s2_q & select_3554) : select_3554) : patches_read_above_q;
  // hls/stages/patches.hpp:557
  logic and_3560;
  assign and_3560 = less_1954_s2_q & (equal_3543_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:561
  logic select_3563;
  assign select_3563 = equal_1957_s2_q ? (less_1954_s2_q ? (not_1958_s2_q & and_3560) : and_3560) : and_3560;
  // hls/stages/patches.hpp:185
  logic select_3566;
  assign select_3566 = equal_1774_s2_q ? (less_1954_s2_q ? (not_1956_s2_q & select_3563) : select_3563) : patches_read_below_q;
  // hls/stages/patches.hpp:554
  logic [6:0] sum_3567;
  assign sum_3567 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3570;
  assign select_3570 = (equal_3543_s2_q & ({sum_3567[6], sum_3567} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3571;
  assign select_3571 = less_1954_s2_q ? select_3570 : 10'h3ff;
  // hls/stages/patches.hpp:558
  logic [9:0] select_3573;
  assign select_3573 = less_1954_s2_q ? (equal_1957_s2_q ? 10'h3ff : select_3571) : 10'h3ff;
  // hls/stages/patches.hpp:561
  logic [9:0] select_3574;
  assign select_3574 = equal_1957_s2_q ? select_3573 : select_3571;
  logic [9:0] select_3576;
  assign select_3576 = less_1954_s2_q ? (equal_1955_s2_q ? 10'h3ff : select_3574) : select_3574;
  // hls/stages/patches.hpp:540
  logic [14:0] select_3578;
  assign select_3578 = and_3546 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:185
  logic [9:0] select_3579;
  assign select_3579 = equal_1774_s2_q ? select_3578[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3580;
  assign select_3580 = equal_1774_s2_q ? select_3578[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3582;
  assign select_3582 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3584;
  assign select_3584 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3587;
  assign select_3587 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3588;
  assign select_3588 = patches_read_first_q ? patches_read_far_q : select_3587;
  // hls/stages/patches.hpp:595
  logic [9:0] difference_3591;
  assign difference_3591 = select_3588 - select_3578[9:0];
  // hls/stages/patches.hpp:580
  logic less_3621;
  assign less_3621 = select_3582 < select_3584;
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3622;
  assign sum_3622 = select_3547[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3621 ? select_3584 : select_3582;
  logic [9:0] low;
  assign low = (select_3584 < select_3582) ? select_3584 : select_3582;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3578[9:0];
  // hls/stages/patches.hpp:584
  logic not_3629;
  assign not_3629 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3630;
  assign sum_3630 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3632;
  assign not_3632 = ~({eight, 3'h0} < {1'b0, sum_3630, fall_2[0]});
  logic [1:0] sum_3633;
  assign sum_3633 = {1'b0, not_3629} + {1'b0, not_3632};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3634;
  assign sum_3634 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3636;
  assign not_3636 = ~({eight, 3'h0} < {sum_3634, fall_2[1:0]});
  logic not_3639;
  assign not_3639 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3640;
  assign sum_3640 = {1'b0, not_3636} + {1'b0, not_3639};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3633} + {1'b0, sum_3640};
  // hls/stages/patches.hpp:587
  logic [7:0] select_3643;
  assign select_3643 = less_3621 ? ({sum_3622, select_3547[2:0], 3'h0} - {5'h0, fraction}) : {sum_3622, select_3547[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_3866;
  assign select_3866 = equal_572_s2_q ? shown_shown_q : (so_s2_q ? select_2025 : shown_shown_q);
  logic select_3868;
  assign select_3868 = equal_572_s2_q ? shown_nearer_q : (so_s2_q ? select_2028 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3870;
  assign sum_3870 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3872;
  assign select_3872 = less_3869_s2_q ? (sum_3870[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3874;
  assign select_3874 = equal_2467_s2_q ? (equal_677_s2_q ? 3'h0 : select_3872) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3879;
  assign select_3879 = equal_572_s2_q ? select_1979 : (so_s2_q ? (ends_cell_s2_q ? select_2078 : select_1979) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3893;
  assign select_3893 = equal_677_s2_q ? {{2{difference_3891[6]}}, difference_3891} : (less_3869_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3895;
  assign select_3895 = and_547_s2_q ? (equal_2467_s2_q ? select_3893 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_3897;
  assign select_3897 = equal_677_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_3899;
  assign select_3899 = and_547_s2_q ? (equal_2467_s2_q ? select_3897 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3900;
  assign sum_3900 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3901;
  assign select_3901 = sum_3870[7] ? {1'b1, sum_3870[6:0], region_down_rest_q[0]} : sum_3900;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3870[7];
  // hls/stages/agreement.hpp:460
  logic select_3905;
  assign select_3905 = equal_2467_s2_q ? (equal_677_s2_q | (less_3869_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3910;
  assign or_3910 = segment_starts_q | not_575_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_3913;
  assign select_3913 = inside_v_s2_q ? (sum_1992_s2_q ? (equal_1767 & or_1994) : or_1994) : or_3910;
  // hls/stages/agreement.hpp:788
  logic select_3916;
  assign select_3916 = equal_572_s2_q ? or_3910 : (so_s2_q ? (ends_cell_s2_q ? select_3913 : or_3910) : or_3910);
  // hls/stages/agreement.hpp:1147
  logic equal_3940;
  assign equal_3940 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4076;
  assign select_4076 = so_s2_q ? (ends_cell_s2_q ? and_2066 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4079;
  assign select_4079 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4081;
  assign select_4081 = equal_572_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4079 : centres_values_0_of_skin_q);
  logic select_4082;
  assign select_4082 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4084;
  assign select_4084 = equal_572_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4082 : centres_values_1_textured_q);
  logic select_4085;
  assign select_4085 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4087;
  assign select_4087 = equal_572_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4085 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [10:0] select_4091;
  assign select_4091 = equal_2467_s2_q ? (equal_4088_s2_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [5:0] select_4094;
  assign select_4094 = and_547_s2_q ? (equal_2467_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1271
  logic xor_4095;
  assign xor_4095 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:438
  logic select_4097;
  assign select_4097 = and_1971_s2_q ? (left_first_s2_q ? xor_4095 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:278
  logic select_4099;
  assign select_4099 = and_1971_s2_q ? (left_first_s2_q ? xor_4095 : select_4097) : write_half_q;
  logic select_4101;
  assign select_4101 = left_first_s2_q ? select_2031 : (and_1971_s2_q ? select_2032 : read_half_q);
  logic and_4105;
  assign and_4105 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_4114;
  assign select_4114 = left_first_s2_q ? 10'h1 : (and_1971_s2_q ? select_2036 : rows_passed_q);
  logic [8:0] select_4117;
  assign select_4117 = left_first_s2_q ? {select_2034[7:0], or_2033} : (and_1971_s2_q ? {select_2034[7:0], or_2033} : columns_passed_q);
  logic select_4120;
  assign select_4120 = left_first_s2_q ? marks_last_s2_q : (and_1971_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4123;
  assign select_4123 = left_first_s2_q ? and_2050 : (and_1971_s2_q ? and_2050 : began_q);
  logic [2:0] select_4126;
  assign select_4126 = left_first_s2_q ? select_2052 : (and_1971_s2_q ? select_2052 : seen_x_q);
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4131;
  assign select_4131 = left_first_s2_q ? 3'h0 : (and_2037 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:278
  logic [2:0] select_4133;
  assign select_4133 = left_first_s2_q ? 3'h0 : (and_1971_s2_q ? select_4131 : seen_y_q);
  logic [7:0] select_4136;
  assign select_4136 = left_first_s2_q ? select_2045 : (and_1971_s2_q ? select_2045 : seen_column_q);
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4142;
  assign select_4142 = left_first_s2_q ? select_4140 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:278
  logic [7:0] select_4144;
  assign select_4144 = left_first_s2_q ? select_4140 : (and_1971_s2_q ? select_4142 : seen_rows_left_q);
  // hls/stages/agreement.hpp:436
  logic and_4149;
  assign and_4149 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:278
  logic select_4151;
  assign select_4151 = left_first_s2_q ? and_4149 : (and_1971_s2_q ? and_4149 : at_cell_end_q);
  logic select_4154;
  assign select_4154 = left_first_s2_q ? next_row : (and_1971_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4157;
  assign select_4157 = left_first_s2_q ? 11'h0 : (and_1971_s2_q ? select_2042 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4230;
  assign not_4230 = ~quarter[1];
  logic [3:0] select_4231;
  assign select_4231 = quarter[0] ? {quarter[1], 1'b0, not_4230, 1'b0} : {1'b0, quarter[1], 1'b0, not_4230};

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
      averager_running_of_skin_q <= select_2191;
      averager_mask_q <= select_2193;
      averager_of_skin_q <= select_2195;
      census_filled_q <= and_547_s2_q ? {select_680[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2290;
      moments_turned_1_q <= sum_2292;
      moments_before_0_q <= equal_572_s2_q ? select_2294 : moments_before_0_q;
      moments_before_1_q <= equal_572_s2_q ? select_2296 : moments_before_1_q;
      moments_has_before_q <= select_2299;
      moments_most_before_q <= select_2302;
      moments_left_begins_q <= select_2306;
      moments_left_alone_q <= select_2310;
      moments_left_other_stops_q <= select_2313;
      moments_right_begins_q <= select_2316;
      moments_right_alone_q <= select_2320;
      moments_right_other_stops_q <= select_2323;
      moments_out_of_step_q <= or_2326;
      moments_turns_0_q <= and_2334;
      moments_turns_1_q <= and_2338;
      moments_begins_alone_q <= and_2347;
      moments_ends_q <= equal_572_s2_q & (equal_2293 & (not_2348 | and_2350));
      rows_passed_above_q <= and_547_s2_q ? select_679 : rows_passed_above_q;
      chosen_score_q <= less_2577 ? select_1509 : select_2576;
      chosen_near_q <= (select_2579 < select_1544) ? select_1544 : select_2579;
      chosen_place_q <= less_2577 ? {select_1517, not_1516} : 3'h2;
      before_0_q <= select_2576;
      before_1_q <= sum_1259;
      before_2_q <= sum_1507;
      shift_allowed_q <= not_2584 & (~less_2585);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2592 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2711});
      counts_turned_right_q <= and_2592 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2718});
      registration_displacement_over_q <= so_s2_q ? sum_2742[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2744;
      registration_slope_here_q <= select_2746;
      registration_expected_q <= select_2748;
      registration_of_right_q <= equal_572_s2_q ? registration_of_right_q : select_2810;
      registration_was_inside_q <= equal_572_s2_q ? registration_was_inside_q : select_2813;
      registration_fresh_q <= select_2822;
      patches_chance_q <= and_547_s2_q ? select_2979 : patches_chance_q;
      patches_fixed_q <= and_2993;
      patches_choice_valid_q <= and_1772 ? (select_1745 & not_2981) : select_1745;
      patches_choice_column_q <= select_1750;
      patches_choice_shift_q <= select_1755;
      patches_choice_slope_q <= select_1766;
      patches_band_q <= sample_pair_whole_s2_q ? select_1787 : patches_band_q;
      patches_fetch_q <= select_3007;
      patches_codes_at_q <= select_3108;
      patches_codes_further_q <= equal_1774_s2_q ? patches_codes_further_q : select_3113;
      patches_next_codes_q <= select_3121;
      patches_set_q <= equal_1774_s2_q ? 3'h0 : (equal_1776_s2_q ? 3'h0 : select_3135);
      patches_size_q <= sum_3139;
      patches_left_row_q <= select_3151;
      patches_summed_row_column_q <= equal_1774_s2_q ? patches_summed_row_column_q : select_3496;
      patches_summed_first_q <= select_3499;
      patches_read_row_differing_q <= equal_1774_s2_q ? select_3511 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1774_s2_q ? select_3518 : patches_read_row_column_q;
      patches_read_at_q <= equal_1774_s2_q ? select_3525 : patches_read_at_q;
      patches_read_first_q <= select_3534;
      patches_read_above_q <= select_3557;
      patches_read_below_q <= select_3566;
      patches_read_far_q <= equal_1774_s2_q ? select_3576 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3579;
      patches_peak_best_column_q <= select_3580;
      patches_peak_row_q <= equal_1774_s2_q ? select_3547 : patches_peak_row_q;
      patches_peak_above_q <= equal_1774_s2_q ? select_3582 : patches_peak_above_q;
      patches_peak_below_q <= equal_1774_s2_q ? select_3584 : patches_peak_below_q;
      patches_peak_far_q <= equal_1774_s2_q ? select_3588 : patches_peak_far_q;
      patches_frame_ended_q <= equal_572_s2_q & equal_2293;
      shown_shown_q <= select_3866;
      shown_nearer_q <= select_3868;
      region_row_q <= and_547_s2_q ? select_3874 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3879;
      region_down_rest_q <= select_3895;
      region_down_back_q <= select_3899;
      region_down_next_q <= select_3901;
      region_fresh_q <= and_547_s2_q ? select_3905 : region_fresh_q;
      segment_starts_q <= select_3916;
      centres_values_0_textured_q <= equal_572_s2_q ? centres_values_0_textured_q : select_4076;
      centres_values_0_of_skin_q <= select_4081;
      centres_values_1_textured_q <= select_4084;
      centres_values_1_of_skin_q <= select_4087;
      map_row_q <= and_547_s2_q ? select_4091 : map_row_q;
      map_width_q <= select_4094;
      write_half_q <= select_4099;
      read_half_q <= and_1971_s2_q ? select_4101 : read_half_q;
      done_q <= and_1971_s2_q ? (not_2048 & and_4105) : and_4105;
      drew_q <= so_s2_q;
      said_q <= equal_572_s2_q & equal_3940;
      rows_passed_q <= and_1971_s2_q ? select_4114 : rows_passed_q;
      columns_passed_q <= and_1971_s2_q ? select_4117 : columns_passed_q;
      line_ended_q <= and_1971_s2_q ? select_4120 : line_ended_q;
      began_q <= and_1971_s2_q ? select_4123 : began_q;
      seen_x_q <= and_1971_s2_q ? select_4126 : seen_x_q;
      seen_y_q <= and_1971_s2_q ? select_4133 : seen_y_q;
      seen_column_q <= and_1971_s2_q ? select_4136 : seen_column_q;
      seen_rows_left_q <= and_1971_s2_q ? select_4144 : seen_rows_left_q;
      at_cell_end_q <= and_1971_s2_q ? select_4151 : at_cell_end_q;
      was_next_row_q <= and_1971_s2_q ? select_4154 : was_next_row_q;
      seen_base_q <= and_1971_s2_q ? select_4157 : seen_base_q;
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
      averager_total_0_q <= select_2169;
      averager_total_1_q <= select_2171;
      census_columns_values_0_cell_0_left_q <= select_2196;
      census_columns_values_0_cell_0_right_q <= select_2197;
      census_columns_values_0_cell_0_mask_q <= and_547_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2199;
      census_columns_values_0_cell_1_right_q <= select_2200;
      census_columns_values_0_cell_1_mask_q <= select_2201;
      census_columns_values_0_cell_2_left_q <= select_2202;
      census_columns_values_0_cell_2_right_q <= select_2203;
      census_columns_values_0_cell_2_mask_q <= select_2204;
      census_columns_values_0_cell_2_of_skin_q <= select_2205;
      census_columns_values_0_cell_3_left_q <= select_2206;
      census_columns_values_0_cell_3_right_q <= select_2207;
      census_columns_values_0_cell_3_mask_q <= select_2208;
      census_columns_values_0_cell_4_left_q <= select_2209;
      census_columns_values_0_cell_4_right_q <= select_2210;
      census_columns_values_0_cell_4_mask_q <= select_2211;
      census_columns_values_1_cell_0_left_q <= select_2212;
      census_columns_values_1_cell_0_right_q <= select_2213;
      census_columns_values_1_cell_0_mask_q <= select_2214;
      census_columns_values_1_cell_1_left_q <= select_2215;
      census_columns_values_1_cell_1_right_q <= select_2216;
      census_columns_values_1_cell_1_mask_q <= select_2217;
      census_columns_values_1_cell_2_left_q <= select_2218;
      census_columns_values_1_cell_2_right_q <= select_2219;
      census_columns_values_1_cell_2_mask_q <= select_2220;
      census_columns_values_1_cell_2_of_skin_q <= select_2221;
      census_columns_values_1_cell_3_left_q <= select_2222;
      census_columns_values_1_cell_3_right_q <= select_2223;
      census_columns_values_1_cell_3_mask_q <= select_2224;
      census_columns_values_1_cell_4_left_q <= select_2225;
      census_columns_values_1_cell_4_right_q <= select_2226;
      census_columns_values_1_cell_4_mask_q <= select_2227;
      census_columns_values_2_cell_0_left_q <= select_2228;
      census_columns_values_2_cell_0_right_q <= select_2229;
      census_columns_values_2_cell_0_mask_q <= select_2230;
      census_columns_values_2_cell_1_left_q <= select_2231;
      census_columns_values_2_cell_1_right_q <= select_2232;
      census_columns_values_2_cell_1_mask_q <= select_2233;
      census_columns_values_2_cell_2_left_q <= select_2234;
      census_columns_values_2_cell_2_right_q <= select_2235;
      census_columns_values_2_cell_2_mask_q <= select_2236;
      census_columns_values_2_cell_3_left_q <= select_2237;
      census_columns_values_2_cell_3_right_q <= select_2238;
      census_columns_values_2_cell_3_mask_q <= select_2239;
      census_columns_values_2_cell_4_left_q <= select_2240;
      census_columns_values_2_cell_4_right_q <= select_2241;
      census_columns_values_2_cell_4_mask_q <= select_2242;
      census_columns_values_3_cell_0_mask_q <= select_2243;
      census_columns_values_3_cell_1_left_q <= select_2244;
      census_columns_values_3_cell_1_right_q <= select_2245;
      census_columns_values_3_cell_1_mask_q <= select_2246;
      census_columns_values_3_cell_2_mask_q <= select_2247;
      census_columns_values_3_cell_3_left_q <= select_2248;
      census_columns_values_3_cell_3_right_q <= select_2249;
      census_columns_values_3_cell_3_mask_q <= select_2250;
      census_columns_values_3_cell_4_mask_q <= select_2251;
      sharpness_last_mean_0_q <= and_547_s2_q ? select_553 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_547_s2_q ? select_557 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_s2_q;
      middle_sum_columns_values_1_q <= select_2567;
      middle_sum_columns_values_2_q <= select_2568;
      middle_sum_columns_values_3_q <= select_2569;
      middle_sum_columns_values_4_q <= select_2570;
      middle_sum_columns_values_5_q <= select_2571;
      middle_sum_columns_values_6_q <= select_2572;
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
  logic row_starts_s3_q;
  logic [2:0] select_509_s3_q;
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
  logic [11:0] sum_2267_s3_q;
  logic [9:0] sum_2270_s3_q;
  logic equal_2278_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2592_s3_q;
  logic and_2598_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2660_s3_q;
  logic and_2694_s3_q;
  logic and_2752_s3_q;
  logic and_2753_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2789_s3_q;
  logic and_2803_s3_q;
  logic equal_2846_s3_q;
  logic parity_3223_s3_q;
  logic parity_3352_s3_q;
  logic parity_3414_s3_q;
  logic xor_3442_s3_q;
  logic parity_3454_s3_q;
  logic or_3458_s3_q;
  logic equal_3459_s3_q;
  logic [4:0] select_3578_s3_q;
  logic equal_3590_s3_q;
  logic less_3592_s3_q;
  logic less_3593_s3_q;
  logic or_3598_s3_q;
  logic [7:0] select_3643_s3_q;
  logic equal_3940_s3_q;
  logic and_4160_s3_q;
  logic equal_4233_s3_q;
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
      row_starts_s3_q <= row_starts_s2_q;
      select_509_s3_q <= select_509_s2_q;
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
      sum_2267_s3_q <= {1'b0, sum_2263} + {2'h0, sum_2266};
      sum_2270_s3_q <= {9'h0, difference_2268[9]} + {1'b0, xor_2269};
      equal_2278_s3_q <= equal_2278_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2592_s3_q <= and_2592;
      and_2598_s3_q <= and_2598;
      explained_2_s3_q <= explained_2;
      and_2660_s3_q <= not_573_s2_q & and_2659;
      and_2694_s3_q <= not_573_s2_q & and_2693;
      and_2752_s3_q <= not_573_s2_q & (so_s2_q & (half_ends & equal_2749));
      and_2753_s3_q <= and_2753;
      residual_s3_q <= residual[7:0];
      and_2789_s3_q <= and_2789;
      and_2803_s3_q <= and_2753 & less_2802;
      equal_2846_s3_q <= (registration_fresh_q & select_2844) == 4'h0;
      parity_3223_s3_q <= ^{xor_3219, xor_3182, select_3149[44:36], other[44:36]};
      parity_3352_s3_q <= parity_3352;
      parity_3414_s3_q <= parity_3414;
      xor_3442_s3_q <= parity_3429 ^ parity_3441;
      parity_3454_s3_q <= ^{or_3451, or_3447, and_3443};
      or_3458_s3_q <= (or_3447 & or_3451) | (and_3443 & (or_3447 | or_3451));
      equal_3459_s3_q <= equal_3459_s2_q;
      select_3578_s3_q <= select_3578[14:10];
      equal_3590_s3_q <= select_3547[3:0] == 4'h0;
      less_3592_s3_q <= {difference_3591, 3'h0} < {3'h0, sum_3139};
      less_3593_s3_q <= select_3588 < select_3578[9:0];
      or_3598_s3_q <= (sum_3139 < 10'h39) | ({1'b0, sum_3139[9:1]} < select_3578[9:0]);
      select_3643_s3_q <= select_3643;
      equal_3940_s3_q <= equal_3940;
      and_4160_s3_q <= and_2137 & (sum_2063 == sum_2047);
      equal_4233_s3_q <= (registration_fresh_q & select_4231) == 4'h0;
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
  assign sum_1793 = {1'b0, select_541_s3_q, select_509_s3_q[2]} + 8'h3;
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
  assign equal_1798 = {sum_1797, sum_1793[0], select_509_s3_q[1:0]} == {1'b0, sum_1793[7:1], 3'h0};
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
  assign equal_1826 = {sum_1825[7], sum_1793, select_509_s3_q[1:0]} == {1'b0, sum_1825[6:0], 3'h0};
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
  assign equal_1840 = {sum_1839[6], select_541_s3_q, select_509_s3_q} == {1'b0, sum_1839[5:0], 3'h4};
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
  assign equal_1845 = {sum_1844[6], select_541_s3_q, select_509_s3_q} == {1'b0, sum_1844[5:0], 3'h4};
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
  logic [8:0] select_2161;
  assign select_2161 = sample_pair_whole_s3_q ? (and_545_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2163;
  assign select_2163 = sample_pair_whole_s3_q ? (and_545_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2165;
  assign select_2165 = sample_pair_whole_s3_q ? (and_545_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2167;
  assign select_2167 = sample_pair_whole_s3_q ? (and_545_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2172;
  assign sum_2172 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2173;
  assign difference_2173 = {1'b0, sum_2172[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2174;
  assign xor_2174 = {difference_2173[8:0], sum_2172[0]} ^ {10{difference_2173[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2173[9]} + {1'b0, xor_2174};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_550_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2179;
  assign select_2179 = sample_pair_whole_s3_q ? (and_545_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2180;
  assign sum_2180 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2181;
  assign difference_2181 = {1'b0, sum_2180[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2182;
  assign xor_2182 = {difference_2181[8:0], sum_2180[0]} ^ {10{difference_2181[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2181[9]} + {1'b0, xor_2182};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_550_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2187;
  assign select_2187 = sample_pair_whole_s3_q ? (and_545_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2271;
  assign sum_2271 = sum_2267_s3_q + {2'h0, sum_2270_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2273;
  assign select_2273 = and_547_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2274;
  assign select_2274 = and_547_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2275;
  assign select_2275 = and_547_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2276;
  assign select_2276 = and_547_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2279;
  assign sum_2279 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2271};
  logic [13:0] sum_2281;
  assign sum_2281 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2279});
  // hls/stages/census.hpp:323
  logic and_2283;
  assign and_2283 = and_706_s3_q & (9'h4 < sum_2281[13:5]);
  // hls/stages/census.hpp:324
  logic and_2284;
  assign and_2284 = and_706_s3_q & less_730;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2285;
  assign sum_2285 = census_left_misses_q + {{17{and_2284}}, and_2283, 1'b0, and_2283};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2287;
  assign select_2287 = and_547_s3_q ? (equal_2278_s3_q ? 20'h0 : sum_2285) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2357;
  assign select_2357 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2360;
  assign select_2360 = and_547_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2363;
  assign and_2363 = whole_2_s3_q & (~(last_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:457
  logic and_2369;
  assign and_2369 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2370;
  assign and_2370 = and_2363 & and_2369;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2357[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2372;
  assign select_2372 = and_2370 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2374;
  assign select_2374 = equal_2278_s3_q ? {11'h0, select_2372} : (sharpness_sums_detail_0_q + {11'h0, select_2372});
  // hls/stages/agreement.hpp:457
  logic and_2381;
  assign and_2381 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2382;
  assign and_2382 = and_2363 & and_2381;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2357[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2384;
  assign select_2384 = and_2382 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2386;
  assign select_2386 = equal_2278_s3_q ? {11'h0, select_2384} : (sharpness_sums_detail_1_q + {11'h0, select_2384});
  logic [8:0] select_2389;
  assign select_2389 = and_2370 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2390;
  assign sum_2390 = (equal_2278_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2389};
  logic [8:0] select_2393;
  assign select_2393 = and_2382 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2394;
  assign sum_2394 = (equal_2278_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2393};
  // hls/stages/agreement.hpp:211
  logic equal_2396;
  assign equal_2396 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:388
  logic less_2397;
  assign less_2397 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2398;
  assign less_2398 = x_s3_q[4:0] < 5'h3;
  logic not_2399;
  assign not_2399 = ~x_s3_q[1];
  logic [2:0] select_2400;
  assign select_2400 = x_s3_q[0] ? {1'b0, not_2399, 1'b0} : {x_s3_q[1], 1'b0, not_2399};
  logic [5:0] select_2401;
  assign select_2401 = slot_s3_q[2] ? {select_2400[2], 1'b0, select_2400[1], 1'b0, select_2400[0], 1'b0} : {1'b0, select_2400[2], 1'b0, select_2400[1], 1'b0, select_2400[0]};
  logic [11:0] select_2402;
  assign select_2402 = slot_s3_q[1] ? {select_2401[5], 1'b0, select_2401[4], 1'b0, select_2401[3], 1'b0, select_2401[2], 1'b0, select_2401[1], 1'b0, select_2401[0], 1'b0} : {1'b0, select_2401[5], 1'b0, select_2401[4], 1'b0, select_2401[3], 1'b0, select_2401[2], 1'b0, select_2401[1], 1'b0, select_2401[0]};
  logic [23:0] select_2403;
  assign select_2403 = slot_s3_q[0] ? {select_2402[11], 1'b0, select_2402[10], 1'b0, select_2402[9], 1'b0, select_2402[8], 1'b0, select_2402[7], 1'b0, select_2402[6], 1'b0, select_2402[5], 1'b0, select_2402[4], 1'b0, select_2402[3], 1'b0, select_2402[2], 1'b0, select_2402[1], 1'b0, select_2402[0], 1'b0} : {1'b0, select_2402[11], 1'b0, select_2402[10], 1'b0, select_2402[9], 1'b0, select_2402[8], 1'b0, select_2402[7], 1'b0, select_2402[6], 1'b0, select_2402[5], 1'b0, select_2402[4], 1'b0, select_2402[3], 1'b0, select_2402[2], 1'b0, select_2402[1], 1'b0, select_2402[0]};
  // hls/stages/census.hpp:390
  logic and_2407;
  assign and_2407 = less_2398 & (~((sharpness_sums_contrast_1_q & select_2403) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2409;
  assign select_2409 = (less_2397 & and_2407) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2409};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2412;
  assign select_2412 = equal_2396 ? (less_2397 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2417;
  assign and_2417 = less_2398 & (~((sharpness_sums_contrast_0_q & select_2403) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2419;
  assign select_2419 = (less_2397 & and_2417) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2419};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2422;
  assign select_2422 = equal_2396 ? (less_2397 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2424;
  assign select_2424 = equal_2396 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2426;
  assign select_2426 = equal_2396 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2428;
  assign select_2428 = equal_2396 ? {sharpness_comparing_contrast_0_q[0], and_2417} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2430;
  assign select_2430 = equal_2396 ? {sharpness_comparing_contrast_1_q[0], and_2407} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2435;
  assign select_2435 = drew_q ? (equal_2396 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2439;
  assign select_2439 = drew_q ? (equal_2396 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2440;
  assign equal_2440 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2441;
  assign xor_2441 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2444;
  assign select_2444 = (equal_2440 | xor_2441) ? (five_times[0] & xor_2441) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2446;
  assign select_2446 = drew_q ? (equal_2396 ? select_2444 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2447;
  assign xor_2447 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2450;
  assign select_2450 = (equal_2440 | xor_2447) ? (five_times_2[0] & xor_2447) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2452;
  assign select_2452 = drew_q ? (equal_2396 ? select_2450 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2453;
  assign xor_2453 = sharpness_comparing_contrast_0_q[1] ^ and_2407;
  logic select_2456;
  assign select_2456 = (equal_2440 | xor_2453) ? (and_2407 & xor_2453) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2458;
  assign select_2458 = drew_q ? (equal_2396 ? select_2456 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2459;
  assign xor_2459 = sharpness_comparing_contrast_1_q[1] ^ and_2417;
  logic select_2462;
  assign select_2462 = (equal_2440 | xor_2459) ? (and_2417 & xor_2459) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2464;
  assign select_2464 = drew_q ? (equal_2396 ? select_2462 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2600;
  assign select_2600 = and_2592_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2598_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_2603;
  assign and_2603 = not_573_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2608;
  assign and_2608 = not_573_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2613;
  assign and_2613 = not_573_s3_q & (drew_q & (ends_cell_s3_q & and_2017_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_2617;
  assign not_2617 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2626;
  assign select_2626 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2627;
  assign difference_2627 = {1'b0, explained_2_s3_q} - {1'b0, select_2626};
  logic [4:0] e;
  assign e = {difference_2627[3], difference_2627} + (equal_567_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2630;
  assign sum_2630 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_2634;
  assign not_2634 = ~(equal_2076 ? and_2097 : (~({sum_2630, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_2637;
  assign and_2637 = ends_cell_s3_q & (not_2617 & (centres_values_1_textured_s3_q & not_2634));
  logic and_2639;
  assign and_2639 = not_573_s3_q & (drew_q & and_2637);
  // hls/stages/agreement.hpp:1132
  logic less_2642;
  assign less_2642 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2643;
  assign select_2643 = less_2642 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2646;
  assign select_2646 = less_2642 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2647;
  assign sum_2647 = {1'b0, select_2646} + {3'h0, select_2646[9:2]};
  logic and_2649;
  assign and_2649 = (~(select_2643[9:4] == 6'h0)) & ({sum_2647, select_2646[1:0]} < {3'h0, select_2643});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_2652;
  assign select_2652 = x_s3_q[6] ? (equal_1605_s3_q ? 10'h0 : (and_2649 ? select_2643 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2653;
  assign select_2653 = equal_572_s3_q ? select_2652 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2655;
  assign select_2655 = and_2592_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2653});
  logic [13:0] select_2662;
  assign select_2662 = and_2592_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2660_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_2664;
  assign and_2664 = not_2617 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_2667;
  assign and_2667 = not_573_s3_q & (drew_q & (ends_cell_s3_q & and_2664));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2669;
  assign select_2669 = and_2592_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2667});
  // hls/stages/agreement.hpp:1110
  logic and_2671;
  assign and_2671 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2634);
  // hls/stages/agreement.hpp:788
  logic and_2675;
  assign and_2675 = not_573_s3_q & (drew_q & (ends_cell_s3_q & (not_2617 & and_2671)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2677;
  assign select_2677 = and_2592_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2675});
  logic [13:0] select_2696;
  assign select_2696 = and_2592_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2694_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2771;
  assign select_2771 = drew_q ? (equal_1698_s3_q ? (and_2753_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2772;
  assign select_2772 = equal_572_s3_q ? 8'h0 : select_2771;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2774;
  assign select_2774 = and_2752_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2772[7]}}, select_2772});
  // hls/stages/agreement.hpp:788
  logic and_2777;
  assign and_2777 = not_573_s3_q & (drew_q & (and_2753_s3_q & equal_1698_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2779;
  assign select_2779 = and_2752_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2777});
  // hls/stages/registration.hpp:107
  logic and_2781;
  assign and_2781 = and_2753_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2783;
  assign select_2783 = drew_q ? (equal_1698_s3_q ? {and_2781, and_2753_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2784;
  assign select_2784 = equal_572_s3_q ? 2'h0 : select_2783;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2785;
  assign sum_2785 = registration_half_votes_down_q + {{5{select_2784[1]}}, select_2784};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2791;
  assign select_2791 = drew_q ? (equal_1698_s3_q ? {and_2789_s3_q, and_2753_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2792;
  assign select_2792 = equal_572_s3_q ? 2'h0 : select_2791;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2793;
  assign sum_2793 = registration_half_votes_up_q + {{5{select_2792[1]}}, select_2792};
  // hls/stages/registration.hpp:107
  logic and_2796;
  assign and_2796 = and_2753_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2798;
  assign select_2798 = drew_q ? (equal_1698_s3_q ? {and_2796, and_2753_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2799;
  assign select_2799 = equal_572_s3_q ? 2'h0 : select_2798;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2800;
  assign sum_2800 = registration_half_half_votes_down_q + {{5{select_2799[1]}}, select_2799};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2805;
  assign select_2805 = drew_q ? (equal_1698_s3_q ? {and_2803_s3_q, and_2753_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2806;
  assign select_2806 = equal_572_s3_q ? 2'h0 : select_2805;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2807;
  assign sum_2807 = registration_half_half_votes_up_q + {{5{select_2806[1]}}, select_2806};
  // hls/stages/agreement.hpp:788
  logic and_2841;
  assign and_2841 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & less_1636_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2848;
  assign select_2848 = or_1640_s3_q ? 12'h0 : (equal_2846_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2851;
  assign select_2851 = x_s3_q[6] ? (equal_1605_s3_q ? 12'h0 : (less_1636_s3_q ? select_2848 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2852;
  assign select_2852 = equal_572_s3_q ? select_2851 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2853;
  assign and_2853 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2856;
  assign and_2856 = not_1990_s3_q & (less_1636_s3_q & ({and_2853, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_2858;
  assign and_2858 = equal_572_s3_q & (x_s3_q[6] & and_2856);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2860;
  assign sum_2860 = {{2{select_2852[11]}}, select_2852} + (and_2858 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2863;
  assign select_2863 = or_1640_s3_q ? 12'h0 : (equal_2846_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2866;
  assign select_2866 = x_s3_q[6] ? (equal_1605_s3_q ? 12'h0 : (less_1636_s3_q ? select_2863 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2867;
  assign select_2867 = equal_572_s3_q ? select_2866 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2869;
  assign sum_2869 = {{2{select_2867[11]}}, select_2867} + (and_2858 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2871;
  assign not_2871 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2874;
  assign and_2874 = not_1990_s3_q & (less_1636_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2871, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2880;
  assign and_2880 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & (less_1636_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2881;
  assign not_2881 = ~and_2880;
  logic less_2882;
  assign less_2882 = $signed({9'h1, {2{not_2881}}, and_2880}) < $signed(registration_up_q[13:2]);
  logic select_2883;
  assign select_2883 = (equal_572_s3_q & (x_s3_q[6] & and_2874)) ? less_2882 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2887;
  assign and_2887 = x_s3_q[6] & (not_1990_s3_q & (less_1636_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2888;
  assign and_2888 = equal_572_s3_q & and_2887;
  // hls/stages/registration.hpp:242
  logic less_2889;
  assign less_2889 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2891;
  assign less_2891 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2893;
  assign equal_2893 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2897;
  assign and_2897 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & (less_1636_s3_q & equal_2893)));
  // hls/stages/agreement.hpp:1142
  logic and_2904;
  assign and_2904 = x_s3_q[6] & (not_1990_s3_q & (less_1636_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2907;
  assign equal_2907 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2910;
  assign and_2910 = not_1990_s3_q & (less_1636_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2907));
  // hls/stages/registration.hpp:244
  logic and_2914;
  assign and_2914 = (equal_572_s3_q & (x_s3_q[6] & and_2910)) & (less_2891 | less_2889);
  // hls/stages/agreement.hpp:1142
  logic and_2919;
  assign and_2919 = not_1990_s3_q & (less_1636_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2907)));
  // hls/stages/registration.hpp:244
  logic and_2922;
  assign and_2922 = registration_votes_up_q & registration_other_down_q;
  logic select_2924;
  assign select_2924 = registration_votes_down_q ? (registration_other_up_q | and_2922) : and_2922;
  // hls/stages/registration.hpp:138
  logic and_2926;
  assign and_2926 = (equal_572_s3_q & (x_s3_q[6] & and_2919)) & (registration_other_enough_q & select_2924);
  // hls/stages/registration.hpp:245
  logic or_2929;
  assign or_2929 = registration_moved_q | (registration_enough_q & (and_2914 | and_2926));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3012;
  assign select_3012 = sample_pair_whole_s3_q ? (equal_1688_s3_q ? patches_place_0_slope_q : select_1794[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3017;
  assign select_3017 = sample_pair_whole_s3_q ? (equal_1688_s3_q ? patches_place_1_slope_q : select_1822[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3019;
  assign select_3019 = equal_1688_s3_q ? patches_valid_0_q : (select_1687_s3_q ? patches_valid_0_q : select_1790[0]);
  // hls/stages/agreement.hpp:276
  logic select_3022;
  assign select_3022 = sample_pair_whole_s3_q ? (and_1813 ? (sample_present_s3_q & select_3019) : select_3019) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3024;
  assign select_3024 = equal_1688_s3_q ? patches_valid_1_q : (select_1687_s3_q ? select_1790[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3027;
  assign select_3027 = sample_pair_whole_s3_q ? (and_1832 ? (sample_present_s3_q & select_3024) : select_3024) : patches_valid_1_q;
  logic [5:0] select_3030;
  assign select_3030 = sample_pair_whole_s3_q ? (select_1811[5] ? {1'b1, select_1811[4:0]} : (select_1811 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3033;
  assign select_3033 = sample_pair_whole_s3_q ? (select_1830[5] ? {1'b1, select_1830[4:0]} : (select_1830 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3036;
  assign select_3036 = sample_pair_whole_s3_q ? (select_1843[4] ? {1'b1, select_1843[3:0]} : (select_1843 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3039;
  assign select_3039 = sample_pair_whole_s3_q ? (select_1848[4] ? {1'b1, select_1848[3:0]} : (select_1848 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:526
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3458_s3_q, parity_3454_s3_q, xor_3442_s3_q, parity_3414_s3_q, parity_3352_s3_q, parity_3223_s3_q} + (equal_3459_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:185
  logic [9:0] select_3463;
  assign select_3463 = equal_1774_s3_q ? patches_sums_values_0_q : (equal_1776_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3464;
  assign select_3464 = equal_1776_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3466;
  assign select_3466 = equal_1776_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3468;
  assign select_3468 = equal_1776_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3470;
  assign select_3470 = equal_1776_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3472;
  assign select_3472 = equal_1776_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3474;
  assign select_3474 = equal_1776_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3476;
  assign select_3476 = equal_1776_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3478;
  assign select_3478 = equal_1776_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3480;
  assign select_3480 = equal_1776_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3482;
  assign select_3482 = equal_1776_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3484;
  assign select_3484 = equal_1776_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3486;
  assign select_3486 = equal_1776_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3488;
  assign select_3488 = equal_1776_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3490;
  assign select_3490 = equal_1776_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3492;
  assign select_3492 = equal_1776_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3494;
  assign select_3494 = equal_1776_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:600
  logic or_3599;
  assign or_3599 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_3598_s3_q;
  logic or_3602;
  assign or_3602 = equal_3590_s3_q | (less_3592_s3_q | (less_3593_s3_q | or_3599));
  // hls/stages/patches.hpp:580
  logic not_3603;
  assign not_3603 = ~or_3602;
  // hls/stages/patches.hpp:561
  logic and_3604;
  assign and_3604 = equal_1957_s3_q & not_3603;
  // hls/stages/patches.hpp:185
  logic and_3607;
  assign and_3607 = equal_1774_s3_q & (less_1954_s3_q ? (not_1956_s3_q & and_3604) : and_3604);
  // hls/stages/patches.hpp:658
  logic not_3608;
  assign not_3608 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:561
  logic and_3610;
  assign and_3610 = equal_1957_s3_q & (patches_second_s3_q & not_3603);
  // hls/stages/patches.hpp:185
  logic and_3613;
  assign and_3613 = equal_1774_s3_q & (less_1954_s3_q ? (not_1956_s3_q & and_3610) : and_3610);
  // hls/stages/patches.hpp:658
  logic not_3614;
  assign not_3614 = ~and_3613;
  // hls/stages/patches.hpp:189
  logic and_3616;
  assign and_3616 = and_3607 & (not_3608 & not_3614);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3618;
  assign sum_3618 = {7'h0, and_3616} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:598
  logic [7:0] select_3644;
  assign select_3644 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:597
  logic [5:0] select_3645;
  assign select_3645 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3646;
  assign sum_3646 = {2'h0, select_3578_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_3647;
  assign sum_3647 = {select_3645[5], select_3645} + {{3{sum_3646[3]}}, sum_3646};
  // hls/stages/patches.hpp:598
  logic [17:0] product_3648;
  assign product_3648 = $signed({{10{select_3644[7]}}, select_3644}) * $signed({{8{sum_3647[6]}}, sum_3647, select_3578_s3_q[2:0]});
  // hls/stages/patches.hpp:599
  logic [13:0] difference_3649;
  assign difference_3649 = {{6{select_3643_s3_q[7]}}, select_3643_s3_q} - {product_3648[17], product_3648[17:5]};
  // hls/stages/patches.hpp:605
  logic less_3650;
  assign less_3650 = $signed({{7{difference_3620[6]}}, difference_3620}) < $signed(difference_3649);
  // hls/stages/patches.hpp:561
  logic and_3653;
  assign and_3653 = equal_1957_s3_q & (not_3603 & (~less_3650));
  // hls/stages/patches.hpp:185
  logic and_3656;
  assign and_3656 = equal_1774_s3_q & (less_1954_s3_q ? (not_1956_s3_q & and_3653) : and_3653);
  // hls/stages/patches.hpp:661
  logic and_3657;
  assign and_3657 = and_3656 & and_3616;
  logic [7:0] sum_3658;
  assign sum_3658 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3657};
  // hls/stages/patches.hpp:561
  logic and_3662;
  assign and_3662 = not_3603 & (~($signed(difference_3649) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3663;
  assign and_3663 = equal_1957_s3_q & and_3662;
  // hls/stages/patches.hpp:185
  logic and_3666;
  assign and_3666 = equal_1774_s3_q & (less_1954_s3_q ? (not_1956_s3_q & and_3663) : and_3663);
  // hls/stages/patches.hpp:662
  logic and_3667;
  assign and_3667 = and_3666 & and_3616;
  logic [7:0] sum_3668;
  assign sum_3668 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3667};
  // hls/stages/patches.hpp:189
  logic and_3670;
  assign and_3670 = and_3607 & (and_3613 & not_3608);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3672;
  assign sum_3672 = {7'h0, and_3670} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:661
  logic and_3674;
  assign and_3674 = and_3656 & and_3670;
  logic [7:0] sum_3675;
  assign sum_3675 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3674};
  // hls/stages/patches.hpp:662
  logic and_3677;
  assign and_3677 = and_3666 & and_3670;
  logic [7:0] sum_3678;
  assign sum_3678 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3677};
  // hls/stages/patches.hpp:189
  logic and_3680;
  assign and_3680 = and_3607 & (patches_lower_s3_q & not_3614);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3682;
  assign sum_3682 = {7'h0, and_3680} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:661
  logic and_3684;
  assign and_3684 = and_3656 & and_3680;
  logic [7:0] sum_3685;
  assign sum_3685 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3684};
  // hls/stages/patches.hpp:662
  logic and_3687;
  assign and_3687 = and_3666 & and_3680;
  logic [7:0] sum_3688;
  assign sum_3688 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3687};
  // hls/stages/patches.hpp:189
  logic and_3690;
  assign and_3690 = and_3607 & (patches_lower_s3_q & and_3613);
  // hls/stages/patches.hpp:660
  logic [7:0] sum_3692;
  assign sum_3692 = {7'h0, and_3690} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:661
  logic and_3694;
  assign and_3694 = and_3656 & and_3690;
  logic [7:0] sum_3695;
  assign sum_3695 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3694};
  // hls/stages/patches.hpp:662
  logic and_3697;
  assign and_3697 = and_3666 & and_3690;
  logic [7:0] sum_3698;
  assign sum_3698 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3697};
  // hls/stages/agreement.hpp:1223
  logic equal_3699;
  assign equal_3699 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_3700;
  assign less_3700 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3704;
  assign and_3704 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & (equal_3699 & less_3700)));
  // hls/stages/agreement.hpp:1142
  logic and_3709;
  assign and_3709 = x_s3_q[6] & (not_1990_s3_q & (less_3700 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_3710;
  assign and_3710 = equal_572_s3_q & and_3709;
  // hls/stages/patches.hpp:624
  logic [7:0] or_3712;
  assign or_3712 = (and_3704 ? patches_quarters_0_places_q : 8'h0) | (and_3710 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_3716;
  assign and_3716 = x_s3_q[6] & (not_1990_s3_q & (less_3700 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_3717;
  assign and_3717 = equal_572_s3_q & and_3716;
  // hls/stages/agreement.hpp:1142
  logic and_3723;
  assign and_3723 = x_s3_q[6] & (not_1990_s3_q & (less_3700 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_3724;
  assign and_3724 = equal_572_s3_q & and_3723;
  // hls/stages/patches.hpp:624
  logic [7:0] or_3726;
  assign or_3726 = (or_3712 | (and_3717 ? patches_quarters_2_places_q : 8'h0)) | (and_3724 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:200
  logic select_3730;
  assign select_3730 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_3734;
  assign and_3734 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & (less_3700 & select_3730)));
  // hls/stages/patches.hpp:625
  logic [7:0] select_3736;
  assign select_3736 = and_3704 ? (and_3734 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3738;
  assign select_3738 = and_3710 ? (and_3734 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3741;
  assign select_3741 = and_3717 ? (and_3734 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3744;
  assign select_3744 = and_3724 ? (and_3734 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:626
  logic [7:0] select_3747;
  assign select_3747 = and_3704 ? (and_3734 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3749;
  assign select_3749 = and_3710 ? (and_3734 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3752;
  assign select_3752 = and_3717 ? (and_3734 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3755;
  assign select_3755 = and_3724 ? (and_3734 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:203
  logic [4:0] sum_3757;
  assign sum_3757 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_3761;
  assign and_3761 = x_s3_q[6] & (not_1990_s3_q & (less_3700 & (sum_3757[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3762;
  assign and_3762 = equal_572_s3_q & and_3761;
  // hls/stages/patches.hpp:621
  logic [7:0] select_3765;
  assign select_3765 = and_3762 ? (patches_word_places_q + (and_3710 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3768;
  assign select_3768 = and_3762 ? (patches_word_up_q + (and_3710 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3771;
  assign select_3771 = and_3762 ? (patches_word_down_q + (and_3710 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:607
  logic [5:0] select_3775;
  assign select_3775 = ($signed(difference_3649[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3649[5:0];
  logic [5:0] select_3776;
  assign select_3776 = ($signed(14'h10) < $signed(difference_3649)) ? 6'h10 : select_3775;
  // hls/stages/patches.hpp:561
  logic [5:0] select_3778;
  assign select_3778 = equal_1957_s3_q ? (or_3602 ? 6'h0 : select_3776) : 6'h0;
  logic [5:0] select_3780;
  assign select_3780 = less_1954_s3_q ? (equal_1955_s3_q ? 6'h0 : select_3778) : select_3778;
  // hls/stages/patches.hpp:664
  logic [5:0] select_3782;
  assign select_3782 = and_3607 ? (equal_1774_s3_q ? select_3780 : 6'h0) : 6'h0;
  logic [11:0] sum_3783;
  assign sum_3783 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3782[5]}}, select_3782};
  // hls/stages/agreement.hpp:788
  logic and_3787;
  assign and_3787 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q & (equal_2893 & less_3700)));
  // hls/stages/agreement.hpp:1142
  logic and_3791;
  assign and_3791 = x_s3_q[6] & (not_1990_s3_q & (less_3700 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3792;
  assign and_3792 = equal_572_s3_q & and_3791;
  // hls/stages/patches.hpp:648
  logic [7:0] select_3794;
  assign select_3794 = and_3787 ? (and_3792 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:650
  logic or_3798;
  assign or_3798 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic or_3801;
  assign or_3801 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:652
  logic [8:0] sum_3802;
  assign sum_3802 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:647
  logic select_3804;
  assign select_3804 = and_3787 ? (and_3792 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:189
  logic and_3807;
  assign and_3807 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:647
  logic [2:0] select_3809;
  assign select_3809 = and_3792 ? {and_3807, patches_found_q[2:1]} : (and_3787 ? {and_3807, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:646
  logic or_3813;
  assign or_3813 = patches_partly_q | (patches_doubted_q & (~and_3792));
  // hls/stages/patches.hpp:647
  logic select_3816;
  assign select_3816 = and_3787 ? (and_3792 ? or_3813 : (and_3787 ? or_3813 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:645
  logic select_3817;
  assign select_3817 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:634
  logic [7:0] select_3821;
  assign select_3821 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:606
  logic [10:0] sum_3823;
  assign sum_3823 = {sum_3647[6], sum_3647, select_3578_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:561
  logic and_3826;
  assign and_3826 = equal_1957_s3_q & (not_3603 & ({{5{sum_3823[10]}}, sum_3823} < 16'h3));
  // hls/stages/patches.hpp:185
  logic and_3829;
  assign and_3829 = equal_1774_s3_q & (less_1954_s3_q ? (not_1956_s3_q & and_3826) : and_3826);
  // hls/stages/patches.hpp:189
  logic and_3830;
  assign and_3830 = and_3607 & and_3829;
  // hls/stages/patches.hpp:665
  logic [7:0] sum_3831;
  assign sum_3831 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3830};
  // hls/stages/patches.hpp:654
  logic [12:0] product_3836;
  assign product_3836 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_3794};
  // hls/stages/patches.hpp:189
  logic and_3838;
  assign and_3838 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_3836[12:5] < patches_on_skin_q);
  logic select_3843;
  assign select_3843 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:635
  logic or_3847;
  assign or_3847 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:636
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:637
  logic select_3854;
  assign select_3854 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:638
  logic and_3860;
  assign and_3860 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3861;
  assign sum_3861 = patches_age_q + {9'h0, and_3860};
  logic [9:0] select_3864;
  assign select_3864 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3861)) : sum_3861;
  // hls/stages/agreement.hpp:1188
  logic or_3921;
  assign or_3921 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_3923;
  assign equal_3923 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_3929;
  assign select_3929 = (equal_3923 & equal_3699) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3932;
  assign sum_3932 = {1'b0, select_2646} + {2'h0, select_2646[9:1]};
  logic select_3935;
  assign select_3935 = (select_2643[9:3] == 7'h0) ? ((~or_3921) & (~select_3929)) : (~({sum_3932, select_2646[0]} < {2'h0, select_2643}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3937;
  assign select_3937 = x_s3_q[6] ? (equal_1605_s3_q ? good_q : {select_3935, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_3942;
  assign select_3942 = equal_572_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3940_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_3943;
  assign equal_3943 = x_s3_q[6:3] == 4'ha;
  logic equal_3945;
  assign equal_3945 = x_s3_q[6:3] == 4'hc;
  logic equal_3946;
  assign equal_3946 = x_s3_q[6:3] == 4'hb;
  logic equal_3947;
  assign equal_3947 = x_s3_q[6:3] == 4'h9;
  logic equal_3948;
  assign equal_3948 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3950;
  assign select_3950 = equal_3947 ? counts_skin_unproven_q : (equal_3948 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3952;
  assign select_3952 = equal_3946 ? counts_regions_bad_q : (equal_3943 ? counts_nearer_q : select_3950);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3945 ? counts_on_skin_q : select_3952;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1230
  logic select_3955;
  assign select_3955 = (equal_3943 & equal_3699) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_3956;
  assign not_3956 = ~hidden_for_q[7];
  logic [7:0] select_3958;
  assign select_3958 = select_3955 ? (hidden_for_q + {7'h0, not_3956}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3960;
  assign select_3960 = equal_572_s3_q ? (equal_3940_s3_q ? select_3958 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3961;
  assign select_3961 = equal_3699 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3963;
  assign select_3963 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3965;
  assign select_3965 = equal_3948 ? cfg_unproven_skin_limit_i : (equal_3923 ? cfg_unproven_limit_i : select_3963);
  logic [7:0] select_3967;
  assign select_3967 = equal_3943 ? cfg_regions_limit_i : (equal_3947 ? cfg_hidden_limit_i : select_3965);
  logic [7:0] limit;
  assign limit = equal_3945 ? cfg_regions_limit_i : (equal_3946 ? {cfg_on_skin_limit_i, 3'h0} : select_3967);
  // hls/stages/agreement.hpp:1231
  logic not_3970;
  assign not_3970 = ~x_s3_q[2];
  logic [3:0] select_3971;
  assign select_3971 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3970, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3970};
  logic [7:0] select_3972;
  assign select_3972 = x_s3_q[0] ? {select_3971[3], 1'b0, select_3971[2], 1'b0, select_3971[1], 1'b0, select_3971[0], 1'b0} : {1'b0, select_3971[3], 1'b0, select_3971[2], 1'b0, select_3971[1], 1'b0, select_3971[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3976;
  assign select_3976 = equal_3947 ? counts_skin_supervised_q : (equal_3948 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3978;
  assign select_3978 = equal_3946 ? counts_skin_textured_q : (equal_3943 ? counts_textured_q : select_3976);
  logic [13:0] of;
  assign of = equal_3945 ? counts_textured_q : select_3978;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3980;
  assign select_3980 = ((limit & select_3972) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3961} + {1'b0, select_3980};
  // hls/stages/agreement.hpp:788
  logic select_3985;
  assign select_3985 = equal_572_s3_q ? (equal_3699 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_3990;
  assign and_3990 = too_much_q & (~(equal_3948 & equal_3699));
  // hls/stages/agreement.hpp:1229
  logic select_3995;
  assign select_3995 = (over[14] & equal_3699) ? (and_3990 | ((equal_3948 | equal_3947) | (x_s3_q[6:3] == 4'hf))) : and_3990;
  // hls/stages/agreement.hpp:1125
  logic and_4000;
  assign and_4000 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_4001;
  assign select_4001 = (equal_3945 & equal_3699) ? and_4000 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4003;
  assign select_4003 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4005;
  assign select_4005 = equal_572_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4003 : box_textured_columns_values_0_q);
  logic [2:0] select_4006;
  assign select_4006 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4008;
  assign select_4008 = equal_572_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4006 : box_textured_columns_values_1_q);
  logic [2:0] select_4009;
  assign select_4009 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4011;
  assign select_4011 = equal_572_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4009 : box_textured_columns_values_2_q);
  logic [2:0] select_4012;
  assign select_4012 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4014;
  assign select_4014 = equal_572_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4012 : box_textured_columns_values_3_q);
  logic [2:0] select_4015;
  assign select_4015 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4017;
  assign select_4017 = equal_572_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4015 : box_textured_columns_values_4_q);
  logic [4:0] select_4019;
  assign select_4019 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4021;
  assign select_4021 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4023;
  assign select_4023 = equal_572_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4021 : box_explained_columns_values_0_q);
  logic [2:0] select_4024;
  assign select_4024 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4026;
  assign select_4026 = equal_572_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4024 : box_explained_columns_values_1_q);
  logic [2:0] select_4027;
  assign select_4027 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4029;
  assign select_4029 = equal_572_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4027 : box_explained_columns_values_2_q);
  logic [2:0] select_4030;
  assign select_4030 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4032;
  assign select_4032 = equal_572_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4030 : box_explained_columns_values_3_q);
  logic [2:0] select_4033;
  assign select_4033 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4035;
  assign select_4035 = equal_572_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4033 : box_explained_columns_values_4_q);
  logic [4:0] select_4037;
  assign select_4037 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4040;
  assign select_4040 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4042;
  assign select_4042 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4044;
  assign select_4044 = equal_572_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4042 : box_shown_columns_values_1_q);
  logic [2:0] select_4045;
  assign select_4045 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4047;
  assign select_4047 = equal_572_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4045 : box_shown_columns_values_2_q);
  logic [2:0] select_4048;
  assign select_4048 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4050;
  assign select_4050 = equal_572_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4048 : box_shown_columns_values_3_q);
  logic [2:0] select_4051;
  assign select_4051 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4053;
  assign select_4053 = equal_572_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4051 : box_shown_columns_values_4_q);
  logic [4:0] select_4055;
  assign select_4055 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4058;
  assign select_4058 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4060;
  assign select_4060 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4062;
  assign select_4062 = equal_572_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4060 : box_nearer_columns_values_1_q);
  logic [2:0] select_4063;
  assign select_4063 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4065;
  assign select_4065 = equal_572_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4063 : box_nearer_columns_values_2_q);
  logic [2:0] select_4066;
  assign select_4066 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4068;
  assign select_4068 = equal_572_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4066 : box_nearer_columns_values_3_q);
  logic [2:0] select_4069;
  assign select_4069 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4071;
  assign select_4071 = equal_572_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4069 : box_nearer_columns_values_4_q);
  logic [4:0] select_4073;
  assign select_4073 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1275
  logic select_4108;
  assign select_4108 = left_first_s3_q ? done_s3_q : proven_q;
  // hls/stages/agreement.hpp:278
  logic select_4110;
  assign select_4110 = left_first_s3_q ? done_s3_q : (and_1971_s3_q ? select_4108 : proven_q);
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4161;
  assign select_4161 = and_4160_s3_q ? {and_2127, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4162;
  assign and_4162 = select_4108 & less_4138;
  // hls/stages/agreement.hpp:438
  logic select_4165;
  assign select_4165 = and_2054_s3_q ? (less_2055_s3_q ? (select_4161[0] & and_4162) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:278
  logic select_4167;
  assign select_4167 = left_first_s3_q ? select_4165 : (and_1971_s3_q ? select_4165 : seen_q);
  logic select_4168;
  assign select_4168 = and_1971_s3_q ? select_4167 : seen_q;
  // hls/stages/agreement.hpp:438
  logic select_4171;
  assign select_4171 = and_2054_s3_q ? (less_2055_s3_q ? (select_4161[1] & and_4162) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:278
  logic select_4173;
  assign select_4173 = left_first_s3_q ? select_4171 : (and_1971_s3_q ? select_4171 : nearer_q);
  logic select_4174;
  assign select_4174 = and_1971_s3_q ? select_4173 : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4181;
  assign or_4181 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1241
  logic not_4189;
  assign not_4189 = ~(or_3921 | not_2348);
  // hls/stages/agreement.hpp:788
  logic and_4193;
  assign and_4193 = equal_572_s3_q & (equal_3940_s3_q & (not_4189 & (select_3929 | select_3995)));
  logic and_4196;
  assign and_4196 = equal_3940_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4200;
  assign or_4200 = select_2446 | (select_2458 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4207;
  assign and_4207 = equal_572_s3_q & (equal_3940_s3_q & (not_4189 & (select_2452 | select_2464)));
  // hls/stages/agreement.hpp:1150
  logic and_4212;
  assign and_4212 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3958 < cfg_hidden_frames_i));
  logic select_4218;
  assign select_4218 = (not_2348 | (select_4001 & not_3833)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4223;
  assign and_4223 = equal_572_s3_q & (equal_3940_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4227;
  assign and_4227 = equal_572_s3_q & (x_s3_q[6] & (not_1990_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4235;
  assign select_4235 = equal_1627_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4233_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4236;
  assign select_4236 = equal_1625_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4235;
  logic [31:0] select_4237;
  assign select_4237 = equal_1623_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4236;
  logic [31:0] select_4238;
  assign select_4238 = equal_1621_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4237;
  logic [31:0] select_4239;
  assign select_4239 = equal_1619_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4238;
  logic [31:0] select_4240;
  assign select_4240 = equal_1617_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4239;
  logic [31:0] select_4241;
  assign select_4241 = equal_1615_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4240;
  logic [31:0] select_4242;
  assign select_4242 = equal_1613_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4241;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4243;
  assign select_4243 = less_2642 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4244;
  assign select_4244 = equal_1605_s3_q ? select_4242 : {2'h0, select_4243, select_2646, select_2643};

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
      census_left_misses_q <= select_2287;
      sharpness_before_last_mask_q <= select_2360;
      sharpness_sums_detail_0_q <= and_547_s3_q ? select_2374 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_547_s3_q ? select_2386 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_547_s3_q ? sum_2390 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_547_s3_q ? sum_2394 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2412 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2422 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2424 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2426 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2428 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2430 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2435;
      sharpness_comparing_carry_1_q <= select_2439;
      sharpness_comparing_less_detail_0_q <= select_2446;
      sharpness_comparing_less_detail_1_q <= select_2452;
      sharpness_comparing_less_contrast_0_q <= select_2458;
      sharpness_comparing_less_contrast_1_q <= select_2464;
      counts_supervised_q <= select_2600;
      counts_textured_q <= and_2592_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2603});
      counts_explained_q <= and_2592_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2608});
      counts_nearer_q <= and_2592_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2613});
      counts_unproven_q <= and_2592_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2639});
      counts_regions_bad_q <= select_2655;
      counts_skin_supervised_q <= select_2662;
      counts_skin_textured_q <= select_2669;
      counts_skin_unproven_q <= select_2677;
      counts_on_skin_q <= select_2696;
      registration_half_across_q <= select_2774;
      registration_half_measured_q <= select_2779;
      registration_half_votes_down_q <= and_2752_s3_q ? 7'h0 : sum_2785;
      registration_half_votes_up_q <= and_2752_s3_q ? 7'h0 : sum_2793;
      registration_half_half_votes_down_q <= and_2752_s3_q ? 7'h0 : sum_2800;
      registration_half_half_votes_up_q <= and_2752_s3_q ? 7'h0 : sum_2807;
      registration_down_q <= and_2841 ? sum_2860 : registration_down_q;
      registration_up_q <= and_2841 ? sum_2869 : registration_up_q;
      registration_enough_q <= select_2883;
      registration_votes_down_q <= and_2888 ? less_2889 : registration_votes_down_q;
      registration_votes_up_q <= and_2888 ? less_2891 : registration_votes_up_q;
      registration_other_enough_q <= and_2897 ? select_2883 : registration_other_enough_q;
      registration_other_down_q <= and_2897 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2897 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_572_s3_q & and_2904)) & or_2929;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1792 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1795 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1796 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3012;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1821 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1823 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1824 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3017;
      patches_valid_0_q <= select_3022;
      patches_valid_1_q <= select_3027;
      patches_right_next_0_q <= select_3030;
      patches_right_next_1_q <= select_3033;
      patches_left_next_0_q <= select_3036;
      patches_left_next_1_q <= select_3039;
      patches_sums_values_0_q <= select_3463;
      patches_sums_values_1_q <= equal_1774_s3_q ? patches_sums_values_1_q : select_3464;
      patches_sums_values_2_q <= equal_1774_s3_q ? patches_sums_values_2_q : select_3466;
      patches_sums_values_3_q <= equal_1774_s3_q ? patches_sums_values_3_q : select_3468;
      patches_sums_values_4_q <= equal_1774_s3_q ? patches_sums_values_4_q : select_3470;
      patches_sums_values_5_q <= equal_1774_s3_q ? patches_sums_values_5_q : select_3472;
      patches_sums_values_6_q <= equal_1774_s3_q ? patches_sums_values_6_q : select_3474;
      patches_sums_values_7_q <= equal_1774_s3_q ? patches_sums_values_7_q : select_3476;
      patches_sums_values_8_q <= equal_1774_s3_q ? patches_sums_values_8_q : select_3478;
      patches_sums_values_9_q <= equal_1774_s3_q ? patches_sums_values_9_q : select_3480;
      patches_sums_values_10_q <= equal_1774_s3_q ? patches_sums_values_10_q : select_3482;
      patches_sums_values_11_q <= equal_1774_s3_q ? patches_sums_values_11_q : select_3484;
      patches_sums_values_12_q <= equal_1774_s3_q ? patches_sums_values_12_q : select_3486;
      patches_sums_values_13_q <= equal_1774_s3_q ? patches_sums_values_13_q : select_3488;
      patches_sums_values_14_q <= equal_1774_s3_q ? patches_sums_values_14_q : select_3490;
      patches_sums_values_15_q <= equal_1774_s3_q ? patches_sums_values_15_q : select_3492;
      patches_sums_values_16_q <= equal_1774_s3_q ? patches_sums_values_16_q : select_3494;
      patches_best_differing_q <= select_1978[9:0];
      patches_best_column_q <= select_1978[14:10];
      patches_quarters_0_places_q <= sum_3618;
      patches_quarters_0_up_q <= sum_3658;
      patches_quarters_0_down_q <= sum_3668;
      patches_quarters_1_places_q <= sum_3672;
      patches_quarters_1_up_q <= sum_3675;
      patches_quarters_1_down_q <= sum_3678;
      patches_quarters_2_places_q <= sum_3682;
      patches_quarters_2_up_q <= sum_3685;
      patches_quarters_2_down_q <= sum_3688;
      patches_quarters_3_places_q <= sum_3692;
      patches_quarters_3_up_q <= sum_3695;
      patches_quarters_3_down_q <= sum_3698;
      patches_word_places_q <= or_3726;
      patches_word_up_q <= ((select_3736 | select_3738) | select_3741) | select_3744;
      patches_word_down_q <= ((select_3747 | select_3749) | select_3752) | select_3755;
      patches_sum_places_q <= select_3765;
      patches_sum_up_q <= select_3768;
      patches_sum_down_q <= select_3771;
      patches_across_q <= sum_3783;
      patches_places_q <= select_3794;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3798;
      patches_partly_q <= or_3801;
      patches_clear_limit_q <= sum_3802[8:2];
      patches_complete_q <= select_3804;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3787 ? select_3809 : patches_found_q;
      patches_doubted_q <= select_3816;
      patches_doubted_before_q <= select_3817;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3821;
      patches_on_skin_q <= sum_3831;
      patches_large_q <= not_3833 & and_3838;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3843;
      patches_spoiled_q <= or_3847;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3854;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3864;
      segment_textured_q <= select_2003 + {5'h0, and_2603};
      segment_explained_q <= select_2008 + {5'h0, and_2608};
      segment_nearer_q <= select_2018 + {5'h0, and_2613};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_572_s3_q ? select_3937 : good_q;
      good_known_q <= select_3942;
      hidden_for_q <= select_3960;
      product_q <= equal_572_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3985;
      disagree_q <= equal_572_s3_q ? select_3929 : disagree_q;
      too_much_q <= equal_572_s3_q ? select_3995 : too_much_q;
      hides_q <= equal_572_s3_q ? select_3955 : hides_q;
      overlooks_q <= equal_572_s3_q ? select_4001 : overlooks_q;
      proven_q <= and_1971_s3_q ? select_4110 : proven_q;
      seen_q <= select_4168;
      nearer_q <= select_4174;
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
      averager_quarter_1_0_q <= select_2161;
      averager_quarter_1_1_q <= select_2163;
      averager_quarter_2_0_q <= select_2165;
      averager_quarter_2_1_q <= select_2167;
      averager_detail_0_q <= select_2179;
      averager_detail_1_q <= select_2187;
      census_changes_values_0_left_q <= and_547_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_547_s3_q ? sum_2271 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2273;
      census_changes_values_1_right_q <= select_2274;
      census_changes_values_2_left_q <= select_2275;
      census_changes_values_2_right_q <= select_2276;
      sharpness_last_mask_q <= and_547_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_547_s3_q ? select_2357[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_547_s3_q ? select_2357[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4005;
      box_textured_columns_values_1_q <= select_4008;
      box_textured_columns_values_2_q <= select_4011;
      box_textured_columns_values_3_q <= select_4014;
      box_textured_columns_values_4_q <= select_4017;
      box_textured_sum_sums_values_0_q <= equal_572_s3_q ? box_textured_sum_sums_values_0_q : select_4019;
      box_explained_columns_values_0_q <= select_4023;
      box_explained_columns_values_1_q <= select_4026;
      box_explained_columns_values_2_q <= select_4029;
      box_explained_columns_values_3_q <= select_4032;
      box_explained_columns_values_4_q <= select_4035;
      box_explained_sum_sums_values_0_q <= equal_572_s3_q ? box_explained_sum_sums_values_0_q : select_4037;
      box_shown_columns_values_0_q <= equal_572_s3_q ? box_shown_columns_values_0_q : select_4040;
      box_shown_columns_values_1_q <= select_4044;
      box_shown_columns_values_2_q <= select_4047;
      box_shown_columns_values_3_q <= select_4050;
      box_shown_columns_values_4_q <= select_4053;
      box_shown_sum_sums_values_0_q <= equal_572_s3_q ? box_shown_sum_sums_values_0_q : select_4055;
      box_nearer_columns_values_0_q <= equal_572_s3_q ? box_nearer_columns_values_0_q : select_4058;
      box_nearer_columns_values_1_q <= select_4062;
      box_nearer_columns_values_2_q <= select_4065;
      box_nearer_columns_values_3_q <= select_4068;
      box_nearer_columns_values_4_q <= select_4071;
      box_nearer_sum_sums_values_0_q <= equal_572_s3_q ? box_nearer_sum_sums_values_0_q : select_4073;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4112_s4_q;
  logic or_4175_s4_q;
  logic and_4176_s4_q;
  logic and_4184_s4_q;
  logic and_4187_s4_q;
  logic and_4193_s4_q;
  logic and_4197_s4_q;
  logic and_4203_s4_q;
  logic and_4207_s4_q;
  logic and_4215_s4_q;
  logic and_4220_s4_q;
  logic and_4223_s4_q;
  logic and_4227_s4_q;
  logic [5:0] select_4229_s4_q;
  logic [31:0] select_4246_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4112_s4_q <= said_q;
      or_4175_s4_q <= not_2348 | select_4168;
      and_4176_s4_q <= cfg_prove_i & select_4174;
      and_4184_s4_q <= equal_572_s3_q & (equal_3940_s3_q & (cfg_prove_i & or_4181));
      and_4187_s4_q <= equal_572_s3_q & (equal_3940_s3_q & (cfg_prove_i & or_3921));
      and_4193_s4_q <= and_4193;
      and_4197_s4_q <= equal_572_s3_q & and_4196;
      and_4203_s4_q <= equal_572_s3_q & (equal_3940_s3_q & (not_4189 & or_4200));
      and_4207_s4_q <= and_4207;
      and_4215_s4_q <= equal_572_s3_q & (equal_3940_s3_q & (cfg_prove_i & and_4212));
      and_4220_s4_q <= equal_572_s3_q & (equal_3940_s3_q & select_4218);
      and_4223_s4_q <= and_4223;
      and_4227_s4_q <= and_4227;
      select_4229_s4_q <= equal_572_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4246_s4_q <= equal_572_s3_q ? (x_s3_q[6] ? select_4244 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4175_s4_q;
  assign marks_nearer_o = and_4176_s4_q;
  assign verdict_valid_o = and_4112_s4_q;
  assign verdict_unproven_yet_o = and_4184_s4_q;
  assign verdict_untextured_o = and_4187_s4_q;
  assign verdict_disagree_o = and_4193_s4_q;
  assign verdict_moved_o = and_4197_s4_q;
  assign verdict_unsharp_left_o = and_4203_s4_q;
  assign verdict_unsharp_right_o = and_4207_s4_q;
  assign verdict_hidden_o = and_4215_s4_q;
  assign verdict_overlooked_o = and_4220_s4_q;
  assign verdict_out_of_step_o = and_4223_s4_q;
  assign frame_valid_o = and_4227_s4_q;
  assign frame_index_o = select_4229_s4_q;
  assign frame_word_o = select_4246_s4_q;
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
  assign unused_bits = ^{over[13:0], product_3836[4:0], sum_3802[1:0], sum_3757[1:0], product_3648[4:0], sum_2742[0], difference_2683[1:0], detail_4[1:0], detail_3[1:0], sum_2281[4:0], sum_1712[0], sum_1708[0], sum_729[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
