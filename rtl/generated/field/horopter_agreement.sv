// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3079 bits, pipeline 850 bits, memories 66527 bits.
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
  logic [6:0] difference_3621;
  assign difference_3621 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3834;
  assign not_3834 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3892;
  assign difference_3892 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4139;
  assign less_4139 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4140;
  assign sum_4140 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_4141;
  assign select_4141 = less_4139 ? {sum_4140, cfg_height_i[5:3]} : 8'h0;

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
  logic [2:0] select_508;
  assign select_508 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_510;
  assign select_510 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:116
  logic [7:0] select_513;
  assign select_513 = ({select_510, select_508} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:117
  logic [7:0] select_514;
  assign select_514 = select_508[0] ? averager_place_q : select_513;
  // hls/stages/census.hpp:42
  logic or_515;
  assign or_515 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_518;
  assign and_518 = (select_508[0] & or_515) & (select_514 < 8'hbd);
  // hls/stages/census.hpp:42
  logic [2:0] select_523;
  assign select_523 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] last;
  assign last = sample_pair_whole_q ? select_510 : 6'h0;
  // hls/stages/census.hpp:51
  logic equal_540;
  assign equal_540 = select_508 == 3'h7;
  // hls/stages/census.hpp:54
  logic equal_541;
  assign equal_541 = select_523 == 3'h7;
  // hls/stages/census.hpp:127
  logic and_542;
  assign and_542 = equal_541 & and_518;
  // hls/stages/agreement.hpp:276
  logic and_544;
  assign and_544 = sample_pair_whole_q & (equal_540 & and_542);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_573;
  assign equal_573 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:594
  logic or_574;
  assign or_574 = so | equal_573;
  // hls/stages/agreement.hpp:592
  logic [7:0] sum_575;
  assign sum_575 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_576;
  assign select_576 = run_shift_q[5] ? x_q : sum_575;
  logic less_577;
  assign less_577 = {2'h0, last_q} < select_576;
  // hls/stages/agreement.hpp:226
  logic not_578;
  assign not_578 = ~less_577;
  // hls/stages/agreement.hpp:614
  logic equal_588;
  assign equal_588 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_589;
  assign equal_589 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_590;
  assign and_590 = equal_589 & not_578;
  logic select_592;
  assign select_592 = or_574 ? not_578 : (equal_588 ? not_578 : and_590);
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:796
  logic [6:0] sum_606;
  assign sum_606 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:149
  logic and_611;
  assign and_611 = equal_588 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_606} < select_576))));
  logic select_612;
  assign select_612 = or_574 ? not_578 : and_611;
  // hls/stages/agreement.hpp:821
  logic [5:0] right;
  assign right = sum_575[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:720
  logic not_642;
  assign not_642 = ~or_574;
  // hls/stages/agreement.hpp:149
  logic and_645;
  assign and_645 = not_642 & ((~equal_588) & and_590);
  // hls/stages/census.hpp:42
  logic [5:0] select_672;
  assign select_672 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_672 : 6'h0;
  // hls/stages/patches.hpp:122
  logic and_1670;
  assign and_1670 = (select_508 == 3'h0) & (select_510 == 6'h0);
  // hls/stages/patches.hpp:392
  logic not_1671;
  assign not_1671 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_1674;
  assign not_1674 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:362
  logic and_1675;
  assign and_1675 = patches_capturing_q & not_1674;
  // hls/stages/patches.hpp:364
  logic equal_1676;
  assign equal_1676 = {or_515, select_523} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_1678;
  assign equal_1678 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1683;
  assign and_1683 = (not_1671 & (patches_work_q == 3'h0)) & (~(and_1675 | ((~equal_1676) | (~equal_1678))));
  // hls/stages/patches.hpp:534
  logic equal_1774;
  assign equal_1774 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:512
  logic not_1775;
  assign not_1775 = ~equal_1774;
  // hls/stages/patches.hpp:505
  logic equal_1776;
  assign equal_1776 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:458
  logic not_1777;
  assign not_1777 = ~equal_1776;
  // hls/stages/patches.hpp:499
  logic equal_1778;
  assign equal_1778 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1779;
  assign equal_1779 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:534
  logic or_1780;
  assign or_1780 = equal_1778 | equal_1779;
  // hls/stages/patches.hpp:460
  logic not_1781;
  assign not_1781 = ~patches_second_q;
  // hls/stages/patches.hpp:373
  logic [4:0] select_1803;
  assign select_1803 = and_1683 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1804;
  assign select_1804 = and_1670 ? select_1803 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1806;
  assign and_1806 = and_1675 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1810;
  assign select_1810 = and_1670 ? (and_1683 | (and_1675 & (~and_1806))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_1818;
  assign and_1818 = not_1775 & (not_1777 & (or_1780 & (patches_second_q & equal_1779)));
  // hls/stages/patches.hpp:167
  logic not_1835;
  assign not_1835 = ~equal_1779;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1851;
  assign select_1851 = and_1670 ? {select_1803[4], select_1803[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:458
  logic and_1861;
  assign and_1861 = not_1775 & (or_1780 & not_1777);
  // hls/stages/agreement.hpp:190
  logic and_1972;
  assign and_1972 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2143;
  assign select_2143 = sample_pair_whole_q ? (sample_last_q ? (select_523 + 3'h1) : select_523) : raster_at_y_q;
  logic [5:0] select_2145;
  assign select_2145 = sample_pair_whole_q ? (select_510 + {5'h0, equal_540}) : raster_at_column_q;
  logic [5:0] select_2148;
  assign select_2148 = sample_pair_whole_q ? (sample_last_q ? (select_672 + {5'h0, equal_541}) : select_672) : raster_at_row_q;
  logic select_2152;
  assign select_2152 = sample_pair_whole_q ? (sample_last_q ? (or_515 & (~raster_final_row_q)) : or_515) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2154;
  assign select_2154 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2158;
  assign select_2158 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic [6:0] sum_2466;
  assign sum_2466 = {1'b0, last} + 7'h1;
  logic equal_2467;
  assign equal_2467 = {sum_2466[6], cfg_width_i[8:3]} == {1'b0, sum_2466[5:0]};
  // hls/stages/agreement.hpp:464
  logic and_2468;
  assign and_2468 = and_544 & equal_2467;
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
  assign and_2481 = run_last_shift_q & equal_588;
  // hls/stages/agreement.hpp:616
  logic select_2483;
  assign select_2483 = equal_588 ? (~run_last_shift_q) : equal_589;
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
  assign select_2493 = (and_2481 | (select_2483 | equal_2484)) ? (equal_2484 ? 3'h2 : {not_2487, {2{select_2483}}}) : (equal_573 ? 3'h6 : {select_2491[0], select_2491});
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
  assign or_2507 = {or_2504[6:4], or_2505, or_2504[1:0]} | (equal_573 ? drawn_q : 7'h0);
  logic [4:0] or_2508;
  assign or_2508 = {5{so}} | {or_2507[6], or_2507[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2512;
  assign not_2512 = ~run_shift_q[5];
  logic [6:0] difference_2514;
  assign difference_2514 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2515;
  assign select_2515 = equal_588 ? ({{7{not_2512}}, 1'b1} + run_span_q) : {difference_2514[6], difference_2514};
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
  assign select_2532 = and_544 ? (equal_2467 ? ((5'he < last[5:1]) ? 6'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:473
  logic [4:0] sum_2533;
  assign sum_2533 = {1'b0, last[5:2]} + 5'h3;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2535;
  assign select_2535 = and_544 ? (equal_2467 ? {sum_2533, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:474
  logic [4:0] sum_2536;
  assign sum_2536 = {1'b0, last[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_2538;
  assign select_2538 = and_544 ? (equal_2467 ? {sum_2536, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2552;
  assign select_2552 = (ends_cell_q | select_2471) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_588 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2556;
  assign and_2556 = (~select_2471) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_2557;
  assign sum_2557 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_2559;
  assign select_2559 = equal_2467 ? ({sum_2557[6], cfg_height_i[8:3]} == {1'b0, sum_2557[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2935;
  assign select_2935 = and_1670 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2936;
  assign select_2936 = sample_pair_whole_q ? select_2935 : patches_phase_q;
  // hls/stages/patches.hpp:373
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
  assign select_2942 = sample_pair_whole_q ? (and_1670 ? select_2940[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2944;
  assign select_2944 = sample_pair_whole_q ? (and_1670 ? select_2940[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2947;
  assign select_2947 = sample_pair_whole_q ? (equal_1678 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2949;
  assign select_2949 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1678}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2950;
  assign equal_2950 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
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
  assign select_2972 = and_544 ? (equal_2467 ? ((6'h2 < row) & equal_2960) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2974;
  assign select_2974 = and_544 ? (equal_2467 ? select_2965 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:371
  logic or_2997;
  assign or_2997 = select_510[0] | select_672[5];
  logic [7:0] sum_2998;
  assign sum_2998 = {1'b0, select_510[2:1], or_2997, select_672[4:1]} + 8'h1;
  logic less_2999;
  assign less_2999 = {sum_2998, select_672[0], select_523, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3002;
  assign select_3002 = and_1670 ? (and_1683 ? (~less_2999) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:393
  logic or_3041;
  assign or_3041 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3047;
  assign and_3047 = equal_1774 & not_1781;
  // hls/stages/patches.hpp:399
  logic and_3048;
  assign and_3048 = not_1835 & and_3047;
  logic [1:0] select_3050;
  assign select_3050 = equal_1776 ? 2'h0 : (equal_1778 ? 2'h3 : {equal_1779, and_3048});
  // hls/stages/patches.hpp:279
  logic equal_3052;
  assign equal_3052 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3053;
  assign not_3053 = ~equal_3052;
  // hls/stages/patches.hpp:279
  logic equal_3054;
  assign equal_3054 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3055;
  assign not_3055 = ~equal_3054;
  // hls/stages/patches.hpp:283
  logic not_3057;
  assign not_3057 = ~(patches_following_q == 3'h2);
  logic and_3060;
  assign and_3060 = (~(patches_following_q == 3'h1)) & not_3057;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3061;
  assign select_3061 = equal_3054 ? 2'h2 : {and_3060, not_3057};
  logic [3:0] select_3062;
  assign select_3062 = equal_3052 ? 4'h2 : {select_3061, {2{not_3055}}};
  // hls/stages/patches.hpp:405
  logic not_3065;
  assign not_3065 = ~or_3041;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3070;
  assign select_3070 = or_3041 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3072;
  assign select_3072 = or_3041 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

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
  assign fresh_re = s0_en & and_645;
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
  assign left_re = s0_en & select_592;
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
  assign right_codes_raddr = or_574 ? x_q[5:0] : (equal_588 ? sum_575[5:0] : x_q[5:0]);
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s0_en & select_592;
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
  assign best_left_raddr = or_574 ? x_q[5:0] : x[5:0];
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s0_en & select_612;
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
  assign patches_right_0_re = s0_en & (not_1775 & (not_1777 & (or_1780 & (equal_1779 & not_1781))));
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
  assign patches_right_1_re = s0_en & and_1818;
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
  assign patches_left_re = s0_en & (not_1775 & (not_1777 & (not_1835 & or_1780)));
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
  assign patches_columns_above_re = s0_en & and_1861;
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
      left_first_q <= and_1972 ? left_first_q : marks_first_i;
      right_q <= (~and_1972) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1972;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_508 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2143;
      raster_at_column_q <= select_2145;
      raster_at_row_q <= select_2148;
      raster_at_live_q <= select_2152;
      raster_rows_left_q <= sample_pair_whole_q ? select_2154 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2158;
      averager_place_q <= sample_pair_whole_q ? select_514 : averager_place_q;
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
      plan_shift_q <= equal_588 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2515;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2521;
      columns_left_q <= select_2524;
      last_q <= and_544 ? (equal_2467 ? last : last_q) : last_q;
      least_q <= select_2532;
      whole_q <= select_2535;
      drawn_q <= select_2538;
      age_q <= select_2471 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2471 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2552;
      ends_q <= and_2556;
      final_row_q <= and_544 ? select_2559 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2936;
      patches_band_rows_rows_to_next_q <= select_2942;
      patches_band_rows_number_q <= select_2944;
      patches_next_band_rows_to_next_q <= select_2947;
      patches_next_band_number_q <= select_2949;
      patches_first_band_rows_to_next_q <= select_2953;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2950 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_544 ? select_2963 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_544 ? select_2967 : patches_choosing_number_q;
      patches_chooses_q <= select_2972;
      patches_choosing_band_q <= select_2974;
      patches_capturing_q <= sample_pair_whole_q ? select_1810 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3002 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1804 : patches_row_q;
      patches_work_q <= or_3041 ? following : patches_work_q;
      patches_second_q <= not_1671 & (patches_second_q | (patches_ends_q & equal_1774));
      patches_following_q <= equal_1774 ? {2'h0, and_3047} : {equal_1776, select_3050};
      patches_following_beats_q <= {select_3062, not_3053};
      patches_begins_q <= sample_pair_whole_q & (and_1670 & and_1806);
      patches_ends_q <= not_3065 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3070;
      patches_code_row_q <= select_3072;
      patches_column_q <= or_3041 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3065 & (patches_column_q == 5'h1e);
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
  logic [5:0] select_510_s1_q;
  logic [7:0] select_514_s1_q;
  logic and_518_s1_q;
  logic equal_524_s1_q;
  logic [5:0] last_s1_2_q;
  logic and_542_s1_q;
  logic and_544_s1_q;
  logic equal_569_s1_q;
  logic so_s1_q;
  logic equal_573_s1_q;
  logic or_574_s1_q;
  logic less_577_s1_q;
  logic not_578_s1_q;
  logic equal_588_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_612_s1_q;
  logic [5:0] right_s1_q;
  logic and_645_s1_q;
  logic [5:0] row_s1_q;
  logic and_1556_s1_q;
  logic equal_1557_s1_q;
  logic and_1670_s1_q;
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
  logic [3:0] select_1851_s1_q;
  logic and_1861_s1_q;
  logic equal_2467_s1_q;
  logic and_2468_s1_q;
  logic or_3041_s1_q;
  logic not_3065_s1_q;
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
      select_510_s1_q <= select_510;
      select_514_s1_q <= select_514;
      and_518_s1_q <= and_518;
      equal_524_s1_q <= select_523 == 3'h0;
      last_s1_2_q <= last;
      and_542_s1_q <= and_542;
      and_544_s1_q <= and_544;
      equal_569_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_573_s1_q <= equal_573;
      or_574_s1_q <= or_574;
      less_577_s1_q <= less_577;
      not_578_s1_q <= not_578;
      equal_588_s1_q <= equal_588;
      x_s1_2_q <= x[6:0];
      select_612_s1_q <= select_612;
      right_s1_q <= right;
      and_645_s1_q <= and_645;
      row_s1_q <= row;
      and_1556_s1_q <= not_642 & and_611;
      equal_1557_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      and_1670_s1_q <= and_1670;
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
      select_1851_s1_q <= select_1851;
      and_1861_s1_q <= and_1861;
      equal_2467_s1_q <= equal_2467;
      and_2468_s1_q <= and_2468;
      or_3041_s1_q <= or_3041;
      not_3065_s1_q <= not_3065;
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
  // hls/stages/census.hpp:120
  logic and_519;
  assign and_519 = sample_pair_whole_s1_q & and_518_s1_q;
  // hls/stages/agreement.hpp:668
  logic equal_563;
  assign equal_563 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_564;
  assign equal_564 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_563 & equal_564;
  // hls/stages/moments.hpp:57
  logic [11:0] select_567;
  assign select_567 = moments_starts_q ? 12'h1 : (moments_place_q + {11'h0, moments_taken_q});
  // hls/stages/agreement.hpp:788
  logic [10:0] select_568;
  assign select_568 = first ? 11'h0 : select_567[10:0];
  // hls/stages/agreement.hpp:1009
  logic not_570;
  assign not_570 = ~equal_569_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_572;
  assign not_572 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_574_s1_q & not_578_s1_q;
  // hls/stages/moments.hpp:63
  logic [11:0] place;
  assign place = first ? 12'h0 : select_567;
  // hls/stages/moments.hpp:104
  logic not_582;
  assign not_582 = ~(12'h66c < place);
  // hls/stages/agreement.hpp:788
  logic and_586;
  assign and_586 = not_570 & (not_572 & (equal_573_s1_q & (inside_v & not_582)));
  // hls/stages/agreement.hpp:975
  logic and_602;
  assign and_602 = (or_574_s1_q & (left_rdata_q[67] & not_578_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:968
  logic [5:0] select_621;
  assign select_621 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:668
  logic not_742;
  assign not_742 = ~equal_563;
  // hls/stages/agreement.hpp:671
  logic and_743;
  assign and_743 = left_rdata_q[12] & not_742;
  logic and_744;
  assign and_744 = left_rdata_q[30] & not_742;
  logic and_745;
  assign and_745 = left_rdata_q[48] & not_742;
  logic and_746;
  assign and_746 = left_rdata_q[66] & not_742;
  // hls/stages/agreement.hpp:672
  logic and_747;
  assign and_747 = right_codes_rdata_q[12] & not_742;
  logic and_748;
  assign and_748 = right_codes_rdata_q[27] & not_742;
  logic and_749;
  assign and_749 = right_codes_rdata_q[42] & not_742;
  logic and_750;
  assign and_750 = right_codes_rdata_q[57] & not_742;
  logic and_751;
  assign and_751 = right_codes_rdata_q[72] & not_742;
  logic and_752;
  assign and_752 = right_codes_rdata_q[85] & not_742;
  // hls/stages/agreement.hpp:221
  logic and_757;
  assign and_757 = left_rdata_q[48] & not_578_s1_q;
  logic and_758;
  assign and_758 = right_codes_rdata_q[42] & not_578_s1_q;
  logic [11:0] select_759;
  assign select_759 = less_577_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_760;
  assign select_760 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_764;
  assign select_764 = and_757 ? (and_758 ? (~(select_759 ^ select_760)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_770;
  assign parity_770 = ^select_764[5:3];
  logic parity_773;
  assign parity_773 = ^select_764[8:6];
  logic parity_776;
  assign parity_776 = ^select_764[11:3];
  // hls/stages/agreement.hpp:221
  logic and_780;
  assign and_780 = left_rdata_q[66] & not_578_s1_q;
  logic and_781;
  assign and_781 = right_codes_rdata_q[57] & not_578_s1_q;
  logic [11:0] select_782;
  assign select_782 = less_577_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_783;
  assign select_783 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_787;
  assign select_787 = and_780 ? (and_781 ? (~(select_782 ^ select_783)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_790;
  assign parity_790 = ^select_787[8:6];
  logic parity_793;
  assign parity_793 = ^select_787[11:9];
  // hls/stages/agreement.hpp:221
  logic and_797;
  assign and_797 = left_rdata_q[84] & not_578_s1_q;
  logic and_798;
  assign and_798 = right_codes_rdata_q[72] & not_578_s1_q;
  logic [11:0] select_799;
  assign select_799 = less_577_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_800;
  assign select_800 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_804;
  assign select_804 = and_797 ? (and_798 ? (~(select_799 ^ select_800)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_810;
  assign parity_810 = ^select_804[2:0];
  logic parity_813;
  assign parity_813 = ^select_804[5:3];
  logic parity_816;
  assign parity_816 = ^select_804[8:0];
  logic parity_822;
  assign parity_822 = ^select_804[11:9];
  logic parity_825;
  assign parity_825 = ^select_787[2:0];
  logic parity_828;
  assign parity_828 = ^{select_804[11:9], select_787[5:0]};
  logic parity_831;
  assign parity_831 = ^{select_804, select_787, select_764[2:0]};
  logic xor_832;
  assign xor_832 = parity_776 ^ parity_831;
  // hls/stages/count_bits.hpp:23
  logic or_836;
  assign or_836 = (select_764[1:0] == 2'h3) | (select_764[2] & (select_764[0] | select_764[1]));
  // hls/stages/count_bits.hpp:25
  logic or_840;
  assign or_840 = (select_787[7:6] == 2'h3) | (select_787[8] & (select_787[6] | select_787[7]));
  logic or_844;
  assign or_844 = (select_787[10:9] == 2'h3) | (select_787[11] & (select_787[9] | select_787[10]));
  // hls/stages/count_bits.hpp:23
  logic or_852;
  assign or_852 = (select_804[7:6] == 2'h3) | (select_804[8] & (~(select_804[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_856;
  assign or_856 = (select_804[1:0] == 2'h3) | (select_804[2] & (select_804[0] | select_804[1]));
  logic or_860;
  assign or_860 = (select_804[4:3] == 2'h3) | (select_804[5] & (select_804[3] | select_804[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_863;
  assign parity_863 = ^{or_860, or_856, or_852};
  // hls/stages/count_bits.hpp:23
  logic or_867;
  assign or_867 = (select_787[4:3] == 2'h3) | (select_787[5] & (select_787[3] | select_787[4]));
  // hls/stages/count_bits.hpp:25
  logic or_871;
  assign or_871 = (select_804[10:9] == 2'h3) | (select_804[11] & (select_804[9] | select_804[10]));
  logic or_875;
  assign or_875 = (select_787[1:0] == 2'h3) | (select_787[2] & (select_787[0] | select_787[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_878;
  assign parity_878 = ^{or_875, or_871, or_867};
  logic parity_881;
  assign parity_881 = ^{or_875, or_871, or_867, or_860, or_856, or_852, or_844, or_840, or_836};
  // hls/stages/count_bits.hpp:25
  logic and_882;
  assign and_882 = parity_776 & parity_831;
  logic or_886;
  assign or_886 = (parity_770 & parity_773) | ((^select_764[11:9]) & (parity_770 | parity_773));
  logic and_889;
  assign and_889 = (^{select_787[11:6], select_764[2:0]}) & (parity_816 | parity_828);
  logic or_890;
  assign or_890 = (parity_816 & parity_828) | and_889;
  // hls/stages/count_bits.hpp:23
  logic or_897;
  assign or_897 = (select_764[10:9] == 2'h3) | (select_764[11] & (select_764[9] | select_764[10]));
  // hls/stages/count_bits.hpp:25
  logic or_901;
  assign or_901 = (select_764[4:3] == 2'h3) | (select_764[5] & (select_764[3] | select_764[4]));
  logic or_905;
  assign or_905 = (select_764[7:6] == 2'h3) | (select_764[8] & (select_764[6] | select_764[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_908;
  assign parity_908 = ^{or_905, or_901, or_897};
  // hls/stages/count_bits.hpp:25
  logic or_912;
  assign or_912 = (parity_790 & parity_793) | ((^select_764[2:0]) & (parity_790 | parity_793));
  logic or_916;
  assign or_916 = (parity_810 & parity_813) | ((^select_804[8:6]) & (parity_810 | parity_813));
  logic or_920;
  assign or_920 = (parity_822 & parity_825) | ((^select_787[5:3]) & (parity_822 | parity_825));
  // hls/stages/count_bits.hpp:24
  logic parity_923;
  assign parity_923 = ^{or_920, or_916, or_912};
  logic parity_926;
  assign parity_926 = ^{or_920, or_916, or_912, or_905, or_901, or_897, or_890, or_886, and_882};
  logic xor_927;
  assign xor_927 = parity_881 ^ parity_926;
  // hls/stages/count_bits.hpp:25
  logic and_928;
  assign and_928 = parity_881 & parity_926;
  logic or_932;
  assign or_932 = (parity_863 & parity_878) | ((^{or_844, or_840, or_836}) & (parity_863 | parity_878));
  logic or_936;
  assign or_936 = (parity_908 & parity_923) | ((^{or_890, or_886, and_882}) & (parity_908 | parity_923));
  logic or_943;
  assign or_943 = (or_840 & or_844) | (or_836 & (or_840 | or_844));
  logic or_947;
  assign or_947 = (or_856 & or_860) | (or_852 & (or_856 | or_860));
  logic or_951;
  assign or_951 = (or_871 & or_875) | (or_867 & (or_871 | or_875));
  // hls/stages/count_bits.hpp:24
  logic parity_954;
  assign parity_954 = ^{or_951, or_947, or_943};
  // hls/stages/count_bits.hpp:25
  logic or_958;
  assign or_958 = (or_886 & or_890) | (and_882 & (or_886 | or_890));
  logic or_962;
  assign or_962 = (or_901 & or_905) | (or_897 & (or_901 | or_905));
  logic or_966;
  assign or_966 = (or_916 & or_920) | (or_912 & (or_916 | or_920));
  // hls/stages/count_bits.hpp:24
  logic parity_969;
  assign parity_969 = ^{or_966, or_962, or_958};
  logic parity_972;
  assign parity_972 = ^{or_966, or_962, or_958, or_951, or_947, or_943, or_936, or_932, and_928};
  // hls/stages/count_bits.hpp:25
  logic or_976;
  assign or_976 = (parity_954 & parity_969) | ((^{or_936, or_932, and_928}) & (parity_954 | parity_969));
  logic or_980;
  assign or_980 = (or_932 & or_936) | (and_928 & (or_932 | or_936));
  logic or_984;
  assign or_984 = (or_947 & or_951) | (or_943 & (or_947 | or_951));
  logic or_988;
  assign or_988 = (or_962 & or_966) | (or_958 & (or_962 | or_966));
  // hls/stages/count_bits.hpp:24
  logic parity_993;
  assign parity_993 = ^{or_988, or_984, or_980, or_976};
  // hls/stages/count_bits.hpp:25
  logic or_997;
  assign or_997 = (or_984 & or_988) | (or_980 & (or_984 | or_988));
  logic and_998;
  assign and_998 = or_976 & (^{or_988, or_984, or_980});
  // hls/stages/count_bits.hpp:24
  logic xor_999;
  assign xor_999 = or_997 ^ and_998;
  // hls/stages/count_bits.hpp:27
  logic and_1000;
  assign and_1000 = or_997 & and_998;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1001;
  assign select_1001 = equal_588_s1_q ? {and_1000, xor_999, parity_993, parity_972, xor_927, xor_832} : 6'h0;
  logic [5:0] column;
  assign column = or_574_s1_q ? 6'h0 : select_1001;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1012;
  assign select_1012 = (slot_s1_q[0] ? and_798 : and_781) ? (~(select_759 ^ (slot_s1_q[0] ? select_800 : select_783))) : 12'h0;
  logic [11:0] select_1013;
  assign select_1013 = and_757 ? select_1012 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1019;
  assign parity_1019 = ^select_1013[5:3];
  logic parity_1022;
  assign parity_1022 = ^select_1013[8:6];
  logic parity_1025;
  assign parity_1025 = ^select_1013[11:3];
  // hls/stages/agreement.hpp:221
  logic and_1029;
  assign and_1029 = right_codes_rdata_q[85] & not_578_s1_q;
  logic [11:0] select_1031;
  assign select_1031 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1035;
  assign select_1035 = (slot_s1_q[0] ? and_1029 : and_798) ? (~(select_782 ^ (slot_s1_q[0] ? select_1031 : select_800))) : 12'h0;
  logic [11:0] select_1036;
  assign select_1036 = and_780 ? select_1035 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1039;
  assign parity_1039 = ^select_1036[8:6];
  logic parity_1042;
  assign parity_1042 = ^select_1036[11:9];
  // hls/stages/agreement.hpp:734
  logic select_1047;
  assign select_1047 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_578_s1_q) : and_1029;
  logic [11:0] select_1049;
  assign select_1049 = slot_s1_q[0] ? (less_577_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1031;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1053;
  assign select_1053 = and_797 ? (select_1047 ? (~(select_799 ^ select_1049)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1059;
  assign parity_1059 = ^select_1053[2:0];
  logic parity_1062;
  assign parity_1062 = ^select_1053[5:3];
  logic parity_1065;
  assign parity_1065 = ^select_1053[8:0];
  logic parity_1071;
  assign parity_1071 = ^select_1053[11:9];
  logic parity_1074;
  assign parity_1074 = ^select_1036[2:0];
  logic parity_1077;
  assign parity_1077 = ^{select_1053[11:9], select_1036[5:0]};
  logic parity_1080;
  assign parity_1080 = ^{select_1053, select_1036, select_1013[2:0]};
  logic xor_1081;
  assign xor_1081 = parity_1025 ^ parity_1080;
  // hls/stages/count_bits.hpp:23
  logic or_1085;
  assign or_1085 = (select_1013[1:0] == 2'h3) | (select_1013[2] & (select_1013[0] | select_1013[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1089;
  assign or_1089 = (select_1036[7:6] == 2'h3) | (select_1036[8] & (select_1036[6] | select_1036[7]));
  logic or_1093;
  assign or_1093 = (select_1036[10:9] == 2'h3) | (select_1036[11] & (select_1036[9] | select_1036[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1101;
  assign or_1101 = (select_1053[7:6] == 2'h3) | (select_1053[8] & (~(select_1053[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1105;
  assign or_1105 = (select_1053[1:0] == 2'h3) | (select_1053[2] & (select_1053[0] | select_1053[1]));
  logic or_1109;
  assign or_1109 = (select_1053[4:3] == 2'h3) | (select_1053[5] & (select_1053[3] | select_1053[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1112;
  assign parity_1112 = ^{or_1109, or_1105, or_1101};
  // hls/stages/count_bits.hpp:23
  logic or_1116;
  assign or_1116 = (select_1036[4:3] == 2'h3) | (select_1036[5] & (select_1036[3] | select_1036[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1120;
  assign or_1120 = (select_1053[10:9] == 2'h3) | (select_1053[11] & (select_1053[9] | select_1053[10]));
  logic or_1124;
  assign or_1124 = (select_1036[1:0] == 2'h3) | (select_1036[2] & (select_1036[0] | select_1036[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1127;
  assign parity_1127 = ^{or_1124, or_1120, or_1116};
  logic parity_1130;
  assign parity_1130 = ^{or_1124, or_1120, or_1116, or_1109, or_1105, or_1101, or_1093, or_1089, or_1085};
  // hls/stages/count_bits.hpp:25
  logic and_1131;
  assign and_1131 = parity_1025 & parity_1080;
  logic or_1135;
  assign or_1135 = (parity_1019 & parity_1022) | ((^select_1013[11:9]) & (parity_1019 | parity_1022));
  logic and_1138;
  assign and_1138 = (^{select_1036[11:6], select_1013[2:0]}) & (parity_1065 | parity_1077);
  logic or_1139;
  assign or_1139 = (parity_1065 & parity_1077) | and_1138;
  // hls/stages/count_bits.hpp:23
  logic or_1146;
  assign or_1146 = (select_1013[10:9] == 2'h3) | (select_1013[11] & (select_1013[9] | select_1013[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1150;
  assign or_1150 = (select_1013[4:3] == 2'h3) | (select_1013[5] & (select_1013[3] | select_1013[4]));
  logic or_1154;
  assign or_1154 = (select_1013[7:6] == 2'h3) | (select_1013[8] & (select_1013[6] | select_1013[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1157;
  assign parity_1157 = ^{or_1154, or_1150, or_1146};
  // hls/stages/count_bits.hpp:25
  logic or_1161;
  assign or_1161 = (parity_1039 & parity_1042) | ((^select_1013[2:0]) & (parity_1039 | parity_1042));
  logic or_1165;
  assign or_1165 = (parity_1059 & parity_1062) | ((^select_1053[8:6]) & (parity_1059 | parity_1062));
  logic or_1169;
  assign or_1169 = (parity_1071 & parity_1074) | ((^select_1036[5:3]) & (parity_1071 | parity_1074));
  // hls/stages/count_bits.hpp:24
  logic parity_1172;
  assign parity_1172 = ^{or_1169, or_1165, or_1161};
  logic parity_1175;
  assign parity_1175 = ^{or_1169, or_1165, or_1161, or_1154, or_1150, or_1146, or_1139, or_1135, and_1131};
  logic xor_1176;
  assign xor_1176 = parity_1130 ^ parity_1175;
  // hls/stages/count_bits.hpp:25
  logic and_1177;
  assign and_1177 = parity_1130 & parity_1175;
  logic or_1181;
  assign or_1181 = (parity_1112 & parity_1127) | ((^{or_1093, or_1089, or_1085}) & (parity_1112 | parity_1127));
  logic or_1185;
  assign or_1185 = (parity_1157 & parity_1172) | ((^{or_1139, or_1135, and_1131}) & (parity_1157 | parity_1172));
  logic or_1192;
  assign or_1192 = (or_1089 & or_1093) | (or_1085 & (or_1089 | or_1093));
  logic or_1196;
  assign or_1196 = (or_1105 & or_1109) | (or_1101 & (or_1105 | or_1109));
  logic or_1200;
  assign or_1200 = (or_1120 & or_1124) | (or_1116 & (or_1120 | or_1124));
  // hls/stages/count_bits.hpp:24
  logic parity_1203;
  assign parity_1203 = ^{or_1200, or_1196, or_1192};
  // hls/stages/count_bits.hpp:25
  logic or_1207;
  assign or_1207 = (or_1135 & or_1139) | (and_1131 & (or_1135 | or_1139));
  logic or_1211;
  assign or_1211 = (or_1150 & or_1154) | (or_1146 & (or_1150 | or_1154));
  logic or_1215;
  assign or_1215 = (or_1165 & or_1169) | (or_1161 & (or_1165 | or_1169));
  // hls/stages/count_bits.hpp:24
  logic parity_1218;
  assign parity_1218 = ^{or_1215, or_1211, or_1207};
  logic parity_1221;
  assign parity_1221 = ^{or_1215, or_1211, or_1207, or_1200, or_1196, or_1192, or_1185, or_1181, and_1177};
  // hls/stages/count_bits.hpp:25
  logic or_1225;
  assign or_1225 = (parity_1203 & parity_1218) | ((^{or_1185, or_1181, and_1177}) & (parity_1203 | parity_1218));
  logic or_1229;
  assign or_1229 = (or_1181 & or_1185) | (and_1177 & (or_1181 | or_1185));
  logic or_1233;
  assign or_1233 = (or_1196 & or_1200) | (or_1192 & (or_1196 | or_1200));
  logic or_1237;
  assign or_1237 = (or_1211 & or_1215) | (or_1207 & (or_1211 | or_1215));
  // hls/stages/count_bits.hpp:24
  logic parity_1242;
  assign parity_1242 = ^{or_1237, or_1233, or_1229, or_1225};
  // hls/stages/count_bits.hpp:25
  logic or_1246;
  assign or_1246 = (or_1233 & or_1237) | (or_1229 & (or_1233 | or_1237));
  logic and_1247;
  assign and_1247 = or_1225 & (^{or_1237, or_1233, or_1229});
  // hls/stages/count_bits.hpp:24
  logic xor_1248;
  assign xor_1248 = or_1246 ^ and_1247;
  // hls/stages/count_bits.hpp:27
  logic and_1249;
  assign and_1249 = or_1246 & and_1247;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1250;
  assign select_1250 = equal_588_s1_q ? {and_1249, xor_1248, parity_1242, parity_1221, xor_1176, xor_1081} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_574_s1_q ? 6'h0 : select_1250;
  // hls/stages/agreement.hpp:221
  logic and_1258;
  assign and_1258 = right_codes_rdata_q[27] & not_578_s1_q;
  // hls/stages/agreement.hpp:734
  logic select_1259;
  assign select_1259 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_578_s1_q) : and_1258;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1261;
  assign select_1261 = less_577_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:734
  logic [11:0] select_1262;
  assign select_1262 = slot_s1_q[0] ? (less_577_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1261;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1266;
  assign select_1266 = and_757 ? (select_1259 ? (~(select_759 ^ select_1262)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1272;
  assign parity_1272 = ^select_1266[5:3];
  logic parity_1275;
  assign parity_1275 = ^select_1266[8:6];
  logic parity_1278;
  assign parity_1278 = ^select_1266[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1286;
  assign select_1286 = (slot_s1_q[0] ? and_1258 : and_758) ? (~(select_782 ^ (slot_s1_q[0] ? select_1261 : select_760))) : 12'h0;
  logic [11:0] select_1287;
  assign select_1287 = and_780 ? select_1286 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1290;
  assign parity_1290 = ^select_1287[8:6];
  logic parity_1293;
  assign parity_1293 = ^select_1287[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1301;
  assign select_1301 = (slot_s1_q[0] ? and_758 : and_781) ? (~(select_799 ^ (slot_s1_q[0] ? select_760 : select_783))) : 12'h0;
  logic [11:0] select_1302;
  assign select_1302 = and_797 ? select_1301 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1308;
  assign parity_1308 = ^select_1302[2:0];
  logic parity_1311;
  assign parity_1311 = ^select_1302[5:3];
  logic parity_1314;
  assign parity_1314 = ^select_1302[8:0];
  logic parity_1320;
  assign parity_1320 = ^select_1302[11:9];
  logic parity_1323;
  assign parity_1323 = ^select_1287[2:0];
  logic parity_1326;
  assign parity_1326 = ^{select_1302[11:9], select_1287[5:0]};
  logic parity_1329;
  assign parity_1329 = ^{select_1302, select_1287, select_1266[2:0]};
  logic xor_1330;
  assign xor_1330 = parity_1278 ^ parity_1329;
  // hls/stages/count_bits.hpp:23
  logic or_1334;
  assign or_1334 = (select_1266[1:0] == 2'h3) | (select_1266[2] & (select_1266[0] | select_1266[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1338;
  assign or_1338 = (select_1287[7:6] == 2'h3) | (select_1287[8] & (select_1287[6] | select_1287[7]));
  logic or_1342;
  assign or_1342 = (select_1287[10:9] == 2'h3) | (select_1287[11] & (select_1287[9] | select_1287[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1350;
  assign or_1350 = (select_1302[7:6] == 2'h3) | (select_1302[8] & (~(select_1302[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1354;
  assign or_1354 = (select_1302[1:0] == 2'h3) | (select_1302[2] & (select_1302[0] | select_1302[1]));
  logic or_1358;
  assign or_1358 = (select_1302[4:3] == 2'h3) | (select_1302[5] & (select_1302[3] | select_1302[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1361;
  assign parity_1361 = ^{or_1358, or_1354, or_1350};
  // hls/stages/count_bits.hpp:23
  logic or_1365;
  assign or_1365 = (select_1287[4:3] == 2'h3) | (select_1287[5] & (select_1287[3] | select_1287[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1369;
  assign or_1369 = (select_1302[10:9] == 2'h3) | (select_1302[11] & (select_1302[9] | select_1302[10]));
  logic or_1373;
  assign or_1373 = (select_1287[1:0] == 2'h3) | (select_1287[2] & (select_1287[0] | select_1287[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1376;
  assign parity_1376 = ^{or_1373, or_1369, or_1365};
  logic parity_1379;
  assign parity_1379 = ^{or_1373, or_1369, or_1365, or_1358, or_1354, or_1350, or_1342, or_1338, or_1334};
  // hls/stages/count_bits.hpp:25
  logic and_1380;
  assign and_1380 = parity_1278 & parity_1329;
  logic or_1384;
  assign or_1384 = (parity_1272 & parity_1275) | ((^select_1266[11:9]) & (parity_1272 | parity_1275));
  logic and_1387;
  assign and_1387 = (^{select_1287[11:6], select_1266[2:0]}) & (parity_1314 | parity_1326);
  logic or_1388;
  assign or_1388 = (parity_1314 & parity_1326) | and_1387;
  // hls/stages/count_bits.hpp:23
  logic or_1395;
  assign or_1395 = (select_1266[10:9] == 2'h3) | (select_1266[11] & (select_1266[9] | select_1266[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1399;
  assign or_1399 = (select_1266[4:3] == 2'h3) | (select_1266[5] & (select_1266[3] | select_1266[4]));
  logic or_1403;
  assign or_1403 = (select_1266[7:6] == 2'h3) | (select_1266[8] & (select_1266[6] | select_1266[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1406;
  assign parity_1406 = ^{or_1403, or_1399, or_1395};
  // hls/stages/count_bits.hpp:25
  logic or_1410;
  assign or_1410 = (parity_1290 & parity_1293) | ((^select_1266[2:0]) & (parity_1290 | parity_1293));
  logic or_1414;
  assign or_1414 = (parity_1308 & parity_1311) | ((^select_1302[8:6]) & (parity_1308 | parity_1311));
  logic or_1418;
  assign or_1418 = (parity_1320 & parity_1323) | ((^select_1287[5:3]) & (parity_1320 | parity_1323));
  // hls/stages/count_bits.hpp:24
  logic parity_1421;
  assign parity_1421 = ^{or_1418, or_1414, or_1410};
  logic parity_1424;
  assign parity_1424 = ^{or_1418, or_1414, or_1410, or_1403, or_1399, or_1395, or_1388, or_1384, and_1380};
  logic xor_1425;
  assign xor_1425 = parity_1379 ^ parity_1424;
  // hls/stages/count_bits.hpp:25
  logic and_1426;
  assign and_1426 = parity_1379 & parity_1424;
  logic or_1430;
  assign or_1430 = (parity_1361 & parity_1376) | ((^{or_1342, or_1338, or_1334}) & (parity_1361 | parity_1376));
  logic or_1434;
  assign or_1434 = (parity_1406 & parity_1421) | ((^{or_1388, or_1384, and_1380}) & (parity_1406 | parity_1421));
  logic or_1441;
  assign or_1441 = (or_1338 & or_1342) | (or_1334 & (or_1338 | or_1342));
  logic or_1445;
  assign or_1445 = (or_1354 & or_1358) | (or_1350 & (or_1354 | or_1358));
  logic or_1449;
  assign or_1449 = (or_1369 & or_1373) | (or_1365 & (or_1369 | or_1373));
  // hls/stages/count_bits.hpp:24
  logic parity_1452;
  assign parity_1452 = ^{or_1449, or_1445, or_1441};
  // hls/stages/count_bits.hpp:25
  logic or_1456;
  assign or_1456 = (or_1384 & or_1388) | (and_1380 & (or_1384 | or_1388));
  logic or_1460;
  assign or_1460 = (or_1399 & or_1403) | (or_1395 & (or_1399 | or_1403));
  logic or_1464;
  assign or_1464 = (or_1414 & or_1418) | (or_1410 & (or_1414 | or_1418));
  // hls/stages/count_bits.hpp:24
  logic parity_1467;
  assign parity_1467 = ^{or_1464, or_1460, or_1456};
  logic parity_1470;
  assign parity_1470 = ^{or_1464, or_1460, or_1456, or_1449, or_1445, or_1441, or_1434, or_1430, and_1426};
  // hls/stages/count_bits.hpp:25
  logic or_1474;
  assign or_1474 = (parity_1452 & parity_1467) | ((^{or_1434, or_1430, and_1426}) & (parity_1452 | parity_1467));
  logic or_1478;
  assign or_1478 = (or_1430 & or_1434) | (and_1426 & (or_1430 | or_1434));
  logic or_1482;
  assign or_1482 = (or_1445 & or_1449) | (or_1441 & (or_1445 | or_1449));
  logic or_1486;
  assign or_1486 = (or_1460 & or_1464) | (or_1456 & (or_1460 | or_1464));
  // hls/stages/count_bits.hpp:24
  logic parity_1491;
  assign parity_1491 = ^{or_1486, or_1482, or_1478, or_1474};
  // hls/stages/count_bits.hpp:25
  logic or_1495;
  assign or_1495 = (or_1482 & or_1486) | (or_1478 & (or_1482 | or_1486));
  logic and_1496;
  assign and_1496 = or_1474 & (^{or_1486, or_1482, or_1478});
  // hls/stages/count_bits.hpp:24
  logic xor_1497;
  assign xor_1497 = or_1495 ^ and_1496;
  // hls/stages/count_bits.hpp:27
  logic and_1498;
  assign and_1498 = or_1495 & and_1496;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1499;
  assign select_1499 = equal_588_s1_q ? {and_1498, xor_1497, parity_1491, parity_1470, xor_1425, xor_1330} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_574_s1_q ? 6'h0 : select_1499;
  // hls/stages/agreement.hpp:788
  logic and_1567;
  assign and_1567 = ends_cell_s1_q & inside_v;
  logic and_1569;
  assign and_1569 = not_570 & (so_s1_q & and_1567);
  logic [5:0] select_1573;
  assign select_1573 = so_s1_q ? x_s1_q[5:0] : (or_574_s1_q ? (less_577_s1_q ? 6'h0 : select_621) : 6'h0);
  // hls/stages/agreement.hpp:247
  logic or_1577;
  assign or_1577 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_1586;
  assign and_1586 = or_574_s1_q & (slot_s1_q[2] & not_578_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1702;
  assign select_1702 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1702[16:7])) ? 8'h7f : select_1702[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1779_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1779_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:500
  logic less_1867;
  assign less_1867 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:501
  logic or_1868;
  assign or_1868 = equal_1778_s1_q | less_1867;
  // hls/stages/patches.hpp:504
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1873;
  assign select_1873 = equal_1778_s1_q ? patches_column_s1_q[0] : (or_1868 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1874;
  assign not_1874 = ~or_1868;
  // hls/stages/patches.hpp:501
  logic [4:0] sum_1875;
  assign sum_1875 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:503
  logic [4:0] select_1878;
  assign select_1878 = or_1868 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1875) + 5'h1) : sum_1875;
  // hls/stages/patches.hpp:505
  logic [4:0] select_1879;
  assign select_1879 = equal_1778_s1_q ? 5'h0 : select_1878;
  logic or_1880;
  assign or_1880 = equal_1778_s1_q | equal_1776_s1_q;
  // hls/stages/patches.hpp:481
  logic equal_1882;
  assign equal_1882 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1884;
  assign equal_1884 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:483
  logic and_1886;
  assign and_1886 = of_row & (~equal_1884);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1882 ? 2'h3 : {equal_1884, and_1886};
  // hls/stages/patches.hpp:469
  logic [8:0] sum_1889;
  assign sum_1889 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1890;
  assign sum_1890 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1889, pixel_2[0]} - {1'b0, sum_1890, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:471
  logic [11:0] sum_1892;
  assign sum_1892 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1893;
  assign sum_1893 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1892[11], sum_1892};
  logic [13:0] sum_1894;
  assign sum_1894 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1893, down_2[1]};
  logic [12:0] sum_1895;
  assign sum_1895 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1894[13:1];
  logic [14:0] sum_1896;
  assign sum_1896 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1895, sum_1894[0], down_2[0]};
  // hls/stages/patches.hpp:453
  logic or_1903;
  assign or_1903 = (sum_1896[8] & (~(sum_1896[7:0] == 8'h0))) | (~(sum_1896[13:9] == 5'h0));
  // hls/stages/patches.hpp:467
  logic [8:0] sum_1908;
  assign sum_1908 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1909;
  assign sum_1909 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1908};
  logic [10:0] sum_1910;
  assign sum_1910 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1909, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1911;
  assign sum_1911 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1910[10:1];
  // hls/stages/patches.hpp:468
  logic [11:0] smooth;
  assign smooth = {sum_1911, sum_1910[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:470
  logic [12:0] sum_1913;
  assign sum_1913 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1914;
  assign sum_1914 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1915;
  assign difference_1915 = {1'b0, sum_1913, smooth[0]} - {1'b0, sum_1914, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:453
  logic or_1922;
  assign or_1922 = (difference_1915[8] & (~(difference_1915[7:0] == 8'h0))) | (~(difference_1915[13:9] == 5'h0));
  // hls/stages/patches.hpp:482
  logic or_1930;
  assign or_1930 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1884) | equal_1882;
  // hls/stages/patches.hpp:477
  logic and_1935;
  assign and_1935 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_1939;
  assign and_1939 = not_1777_s1_q & (or_1780_s1_q & (or_1930 & (equal_1779_s1_q & and_1935)));
  // hls/stages/patches.hpp:172
  logic and_1949;
  assign and_1949 = (~(equal_1779_s1_q | (~and_1935))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_1953;
  assign and_1953 = not_1777_s1_q & (or_1780_s1_q & (and_1949 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:546
  logic less_1955;
  assign less_1955 = patches_step_q[4:0] < 5'h11;
  logic equal_1956;
  assign equal_1956 = patches_step_q[6:5] == 2'h0;
  logic not_1957;
  assign not_1957 = ~equal_1956;
  logic equal_1958;
  assign equal_1958 = patches_step_q[6:5] == 2'h3;
  logic not_1959;
  assign not_1959 = ~equal_1958;
  // hls/stages/patches.hpp:560
  logic select_1962;
  assign select_1962 = equal_1958 ? (less_1955 & (less_1955 & not_1959)) : less_1955;
  // hls/stages/patches.hpp:184
  logic and_1965;
  assign and_1965 = equal_1774_s1_q & (less_1955 ? (not_1957 & select_1962) : select_1962);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1993;
  assign sum_1993 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:460
  logic select_2564;
  assign select_2564 = equal_2467_s1_q ? (~({row_s1_q, 1'b0} < {sum_2561, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_2825;
  assign and_2825 = and_544_s1_q & (equal_2467_s1_q & (row_s1_q[5:2] == 4'h0));
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
  // hls/stages/patches.hpp:187
  logic select_3080;
  assign select_3080 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3083;
  assign select_3083 = equal_1776_s1_q ? patches_smooth_values_0_q : (or_1780_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3085;
  assign select_3085 = or_1780_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3087;
  assign select_3087 = equal_1774_s1_q ? patches_smooth_values_1_q : (equal_1776_s1_q ? patches_smooth_values_1_q : select_3085);
  logic [11:0] select_3088;
  assign select_3088 = or_1780_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3090;
  assign select_3090 = equal_1774_s1_q ? patches_smooth_values_2_q : (equal_1776_s1_q ? patches_smooth_values_2_q : select_3088);
  logic [11:0] select_3091;
  assign select_3091 = or_1780_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3093;
  assign select_3093 = equal_1774_s1_q ? patches_smooth_values_3_q : (equal_1776_s1_q ? patches_smooth_values_3_q : select_3091);
  logic [10:0] select_3095;
  assign select_3095 = equal_1776_s1_q ? patches_down_values_0_q : (or_1780_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3098;
  assign select_3098 = equal_1776_s1_q ? patches_down_values_1_q : (or_1780_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3101;
  assign select_3101 = equal_1776_s1_q ? patches_down_values_2_q : (or_1780_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3104;
  assign select_3104 = equal_1776_s1_q ? patches_down_values_3_q : (or_1780_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3141;
  assign and_3141 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3146;
  assign select_3146 = or_3041_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3148;
  assign select_3148 = and_3141 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3504;
  assign select_3504 = equal_1774_s1_q ? patches_summed_down_by_q : (equal_1776_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:556
  logic and_3537;
  assign and_3537 = less_1955 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:560
  logic select_3540;
  assign select_3540 = equal_1958 ? (less_1955 ? (not_1959 & and_3537) : and_3537) : and_3537;
  // hls/stages/patches.hpp:184
  logic select_3543;
  assign select_3543 = equal_1774_s1_q ? (less_1955 ? (not_1957 & select_3540) : select_3540) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3882;
  assign select_3882 = so_s1_q ? (and_2835 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3884;
  assign sum_3884 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3885;
  assign select_3885 = sum_1993[5] ? {1'b1, sum_1993[4:0], region_across_rest_q[2:0]} : sum_3884;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3887;
  assign select_3887 = equal_2467_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3890;
  assign select_3890 = equal_2467_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:227; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_514_s1_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_519;
`endif
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:340; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign census_memory_re = s1_en & and_544_s1_q;
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
  assign moments_memory_raddr = select_568;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_586;
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
  assign best_right_raddr = or_574_s1_q ? select_621 : right_s1_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s1_en & select_612_s1_q;
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
  assign shown_right_re = s1_en & and_1569;
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
  assign left_turns_re = s1_en & and_1586;
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
  assign right_turns_raddr = select_621;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s1_en & and_1586;
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
  assign patches_right_codes_raddr = {select_1879, not_1874, select_1873};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1880;
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
  assign patches_left_codes_re = s1_en & (not_1775_s1_q & (new_row & equal_1776_s1_q));
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
  assign patches_rows_re = s1_en & and_1965;
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
  assign seen_columns_re = s1_en & and_1569;
`endif
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_645_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_746, left_rdata_q[65:49], and_745, left_rdata_q[47:31], and_744, left_rdata_q[29:13], and_743, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_645_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_752, right_codes_rdata_q[84:73], and_751, right_codes_rdata_q[71:60], and_750, right_codes_rdata_q[56:43], and_749, right_codes_rdata_q[41:28], and_748, right_codes_rdata_q[26:13], and_747, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_1861_s1_q;
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
      moments_place_q <= select_567;
      moments_taken_q <= not_570 & (not_572 & (equal_573_s1_q & inside_v));
      moments_starts_q <= not_570 & (not_572 & (equal_573_s1_q & (inside_v & first)));
      row_q <= and_544_s1_q ? (equal_2467_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_544_s1_q ? select_2564 : lower_half_q;
      registration_slope_row_q <= select_2831;
      registration_slope_change_q <= select_2834;
      registration_slope_q <= so_s1_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3065_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3065_s1_q & select_3080;
      patches_smooth_values_0_q <= equal_1774_s1_q ? patches_smooth_values_0_q : select_3083;
      patches_smooth_values_1_q <= select_3087;
      patches_smooth_values_2_q <= select_3090;
      patches_smooth_values_3_q <= select_3093;
      patches_down_values_0_q <= equal_1774_s1_q ? patches_down_values_0_q : select_3095;
      patches_down_values_1_q <= equal_1774_s1_q ? patches_down_values_1_q : select_3098;
      patches_down_values_2_q <= equal_1774_s1_q ? patches_down_values_2_q : select_3101;
      patches_down_values_3_q <= equal_1774_s1_q ? patches_down_values_3_q : select_3104;
      patches_down_by_q <= or_3041_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3141});
      patches_along_q <= select_3146;
      patches_match_row_q <= or_3041_s1_q ? 4'h0 : select_3148;
      patches_summed_last_q <= not_1775_s1_q & (equal_1776_s1_q & and_3141);
      patches_summed_down_by_q <= select_3504;
      patches_step_q <= or_3041_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3543;
      region_across_rest_q <= select_3882;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3885;
      columns_begin_rest_q <= and_544_s1_q ? select_3887 : columns_begin_rest_q;
      columns_begin_back_q <= and_544_s1_q ? select_3890 : columns_begin_back_q;
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
  logic [5:0] select_510_s2_q;
  logic [7:0] select_514_s2_q;
  logic and_518_s2_q;
  logic and_519_s2_q;
  logic equal_524_s2_q;
  logic [5:0] last_s2_2_q;
  logic and_542_s2_q;
  logic and_544_s2_q;
  logic equal_564_s2_q;
  logic [10:0] select_568_s2_q;
  logic equal_569_s2_q;
  logic not_570_s2_q;
  logic so_s2_q;
  logic not_572_s2_q;
  logic equal_573_s2_q;
  logic or_574_s2_q;
  logic less_577_s2_q;
  logic not_578_s2_q;
  logic inside_v_s2_q;
  logic not_582_s2_q;
  logic and_586_s2_q;
  logic and_595_s2_q;
  logic and_603_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] right_s2_q;
  logic and_634_s2_q;
  logic and_639_s2_q;
  logic and_641_s2_q;
  logic equal_674_s2_q;
  logic [5:0] column_s2_q;
  logic [5:0] select_1252_s2_q;
  logic [5:0] select_1501_s2_q;
  logic and_1556_s2_q;
  logic equal_1557_s2_q;
  logic and_1567_s2_q;
  logic and_1569_s2_q;
  logic [5:0] select_1573_s2_q;
  logic or_1577_s2_q;
  logic and_1670_s2_q;
  logic and_1683_s2_q;
  logic less_1697_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1774_s2_q;
  logic equal_1776_s2_q;
  logic equal_1779_s2_q;
  logic or_1780_s2_q;
  logic [4:0] select_1804_s2_q;
  logic select_1810_s2_q;
  logic [3:0] select_1851_s2_q;
  logic less_1867_s2_q;
  logic new_row_s2_q;
  logic or_1880_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_1897_s2_q;
  logic or_1903_s2_q;
  logic and_1907_s2_q;
  logic and_1923_s2_q;
  logic and_1926_s2_q;
  logic and_1940_s2_q;
  logic and_1949_s2_q;
  logic and_1954_s2_q;
  logic less_1955_s2_q;
  logic equal_1956_s2_q;
  logic not_1957_s2_q;
  logic equal_1958_s2_q;
  logic not_1959_s2_q;
  logic and_1972_s2_q;
  logic select_1974_s2_q;
  logic and_1977_s2_q;
  logic sum_1993_s2_q;
  logic and_2014_s2_q;
  logic and_2132_s2_q;
  logic equal_2278_s2_q;
  logic equal_2467_s2_q;
  logic and_2594_s2_q;
  logic equal_2679_s2_q;
  logic less_3117_s2_q;
  logic equal_3460_s2_q;
  logic equal_3544_s2_q;
  logic less_3870_s2_q;
  logic equal_4089_s2_q;
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
      select_510_s2_q <= select_510_s1_q;
      select_514_s2_q <= select_514_s1_q;
      and_518_s2_q <= and_518_s1_q;
      and_519_s2_q <= and_519;
      equal_524_s2_q <= equal_524_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_542_s2_q <= and_542_s1_q;
      and_544_s2_q <= and_544_s1_q;
      equal_564_s2_q <= equal_564;
      select_568_s2_q <= select_568;
      equal_569_s2_q <= equal_569_s1_q;
      not_570_s2_q <= not_570;
      so_s2_q <= so_s1_q;
      not_572_s2_q <= not_572;
      equal_573_s2_q <= equal_573_s1_q;
      or_574_s2_q <= or_574_s1_q;
      less_577_s2_q <= less_577_s1_q;
      not_578_s2_q <= not_578_s1_q;
      inside_v_s2_q <= inside_v;
      not_582_s2_q <= not_582;
      and_586_s2_q <= and_586;
      and_595_s2_q <= or_574_s1_q & (left_rdata_q[70] & not_578_s1_q);
      and_603_s2_q <= (or_574_s1_q & (left_rdata_q[68] & not_578_s1_q)) & and_602;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_634_s2_q <= or_574_s1_q & (left_rdata_q[71] & not_578_s1_q);
      and_639_s2_q <= or_574_s1_q & (right_codes_rdata_q[58] & not_578_s1_q);
      and_641_s2_q <= or_574_s1_q & (right_codes_rdata_q[59] & not_578_s1_q);
      equal_674_s2_q <= row_s1_q == 6'h0;
      column_s2_q <= column;
      select_1252_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1501_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1556_s2_q <= and_1556_s1_q;
      equal_1557_s2_q <= equal_1557_s1_q;
      and_1567_s2_q <= and_1567;
      and_1569_s2_q <= and_1569;
      select_1573_s2_q <= select_1573;
      or_1577_s2_q <= or_1577;
      and_1670_s2_q <= and_1670_s1_q;
      and_1683_s2_q <= and_1683_s1_q;
      less_1697_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1774_s2_q <= equal_1774_s1_q;
      equal_1776_s2_q <= equal_1776_s1_q;
      equal_1779_s2_q <= equal_1779_s1_q;
      or_1780_s2_q <= or_1780_s1_q;
      select_1804_s2_q <= select_1804_s1_q;
      select_1810_s2_q <= select_1810_s1_q;
      select_1851_s2_q <= select_1851_s1_q;
      less_1867_s2_q <= less_1867;
      new_row_s2_q <= new_row;
      or_1880_s2_q <= or_1880;
      of_row_2_s2_q <= of_row_2;
      not_1897_s2_q <= ~sum_1896[14];
      or_1903_s2_q <= or_1903;
      and_1907_s2_q <= sum_1896[14] & (~(sum_1896[13:8] == 6'h3f));
      and_1923_s2_q <= (~difference_1915[14]) & or_1922;
      and_1926_s2_q <= difference_1915[14] & (~(difference_1915[13:8] == 6'h3f));
      and_1940_s2_q <= not_1775_s1_q & and_1939;
      and_1949_s2_q <= and_1949;
      and_1954_s2_q <= not_1775_s1_q & and_1953;
      less_1955_s2_q <= less_1955;
      equal_1956_s2_q <= equal_1956;
      not_1957_s2_q <= not_1957;
      equal_1958_s2_q <= equal_1958;
      not_1959_s2_q <= not_1959;
      and_1972_s2_q <= sample_pair_whole_q;
      select_1974_s2_q <= left_first_q;
      and_1977_s2_q <= right_q;
      sum_1993_s2_q <= sum_1993[5];
      and_2014_s2_q <= or_574_s1_q & (left_rdata_q[69] & not_578_s1_q);
      and_2132_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2278_s2_q <= (last_s1_2_q | row_s1_q) == 6'h0;
      equal_2467_s2_q <= equal_2467_s1_q;
      and_2594_s2_q <= or_574_s1_q & (not_578_s1_q & and_602);
      equal_2679_s2_q <= shift == 6'h0;
      less_3117_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3460_s2_q <= patches_match_row_q == 4'h0;
      equal_3544_s2_q <= patches_step_q[6:5] == 2'h2;
      less_3870_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4089_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic [11:0] select_522;
  assign select_522 = select_508_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:122
  logic [11:0] sum_526;
  assign sum_526 = select_522 + (equal_524_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:113
  logic [11:0] sum_528;
  assign sum_528 = {4'h0, sample_pair_pixel_1_q} + (select_508_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:122
  logic [11:0] sum_530;
  assign sum_530 = sum_528 + (equal_524_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_508_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:123
  logic and_534;
  assign and_534 = whole & (averager_memory_rdata_q[24] | equal_524_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_508_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:124
  logic and_538;
  assign and_538 = all_of_skin & (averager_memory_rdata_q[25] | equal_524_s2_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_518_s2_q ? sum_526[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic equal_547;
  assign equal_547 = select_508_s2_q == 3'h1;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_547 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_550;
  assign select_550 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_518_s2_q ? sum_530[11:3] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_547 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_554;
  assign select_554 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic and_555;
  assign and_555 = and_518_s2_q & and_534;
  // hls/stages/census.hpp:127
  logic select_557;
  assign select_557 = equal_547 ? and_555 : (averager_mask_q & and_555);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_557;
  // hls/stages/census.hpp:207
  logic and_559;
  assign and_559 = and_518_s2_q & and_538;
  // hls/stages/census.hpp:127
  logic select_561;
  assign select_561 = equal_547 ? and_559 : (averager_of_skin_q & and_559);
  // hls/stages/agreement.hpp:276
  logic and_562;
  assign and_562 = sample_pair_whole_s2_q & select_561;
  // hls/stages/agreement.hpp:978
  logic select_616;
  assign select_616 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_626;
  assign difference_626 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:993
  logic [9:0] sum_627;
  assign sum_627 = {difference_626[8], difference_626} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_629;
  assign and_629 = (and_603_s2_q & select_616) & ({{22{sum_627[9]}}, sum_627} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_631;
  assign and_631 = or_574_s2_q & (not_578_s2_q & and_629);
  // hls/stages/moments.hpp:77
  logic and_632;
  assign and_632 = and_595_s2_q & and_631;
  // hls/stages/census.hpp:296
  logic less_647;
  assign less_647 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_648;
  assign less_648 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_649;
  assign less_649 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_650;
  assign less_650 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_651;
  assign less_651 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_653;
  assign less_653 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_654;
  assign less_654 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_655;
  assign less_655 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_656;
  assign less_656 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_657;
  assign less_657 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_658;
  assign less_658 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:297
  logic less_659;
  assign less_659 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_660;
  assign less_660 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_661;
  assign less_661 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_662;
  assign less_662 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_663;
  assign less_663 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_665;
  assign less_665 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_666;
  assign less_666 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_667;
  assign less_667 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_668;
  assign less_668 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_669;
  assign less_669 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_670;
  assign less_670 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_671;
  assign equal_671 = last_s2_2_q == 6'h0;
  logic [3:0] select_675;
  assign select_675 = equal_674_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_676;
  assign select_676 = equal_671 ? {select_675, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:278
  logic [3:0] select_677;
  assign select_677 = equal_671 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:301
  logic and_678;
  assign and_678 = select_676[4] & select_677[3];
  // hls/stages/census.hpp:288
  logic and_680;
  assign and_680 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_682;
  assign and_682 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_680);
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_682;
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
  // hls/stages/census.hpp:272
  logic [9:0] difference_705;
  assign difference_705 = {1'b0, select_550} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_706;
  assign xor_706 = difference_705[8:0] ^ {9{difference_705[9]}};
  logic [9:0] sum_707;
  assign sum_707 = {9'h0, difference_705[9]} + {1'b0, xor_706};
  logic [9:0] difference_708;
  assign difference_708 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_709;
  assign xor_709 = difference_708[8:0] ^ {9{difference_708[9]}};
  logic [9:0] sum_710;
  assign sum_710 = {9'h0, difference_708[9]} + {1'b0, xor_709};
  logic [9:0] difference_712;
  assign difference_712 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_713;
  assign xor_713 = difference_712[8:0] ^ {9{difference_712[9]}};
  logic [9:0] sum_714;
  assign sum_714 = {9'h0, difference_712[9]} + {1'b0, xor_713};
  logic [10:0] sum_715;
  assign sum_715 = ({1'b0, sum_707} + {1'b0, sum_710}) + {1'b0, sum_714};
  logic [9:0] difference_716;
  assign difference_716 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_717;
  assign xor_717 = difference_716[8:0] ^ {9{difference_716[9]}};
  logic [9:0] sum_718;
  assign sum_718 = {9'h0, difference_716[9]} + {1'b0, xor_717};
  logic [9:0] difference_720;
  assign difference_720 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_721;
  assign xor_721 = difference_720[8:0] ^ {9{difference_720[9]}};
  // hls/stages/agreement.hpp:456
  logic and_729;
  assign and_729 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_730;
  assign and_730 = and_678 & and_729;
  // hls/stages/census.hpp:308
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_732;
  assign sum_732 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:308
  logic and_734;
  assign and_734 = and_730 & ({{5{sum_732[6]}}, sum_732, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:309
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_738;
  assign sum_738 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:807
  logic or_754;
  assign or_754 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:808
  logic select_756;
  assign select_756 = or_754 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:778
  logic [5:0] select_1003;
  assign select_1003 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1004;
  assign difference_1004 = {1'b0, column_s2_q} - {1'b0, select_1003};
  logic [7:0] sum_1006;
  assign sum_1006 = {difference_1004[6], difference_1004} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:755
  logic [7:0] select_1007;
  assign select_1007 = slot_s2_q[0] ? chosen_score_q : sum_1006;
  // hls/stages/agreement.hpp:778
  logic [6:0] difference_1253;
  assign difference_1253 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1252_s2_q};
  // hls/stages/agreement.hpp:749
  logic equal_1254;
  assign equal_1254 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:778
  logic [7:0] sum_1256;
  assign sum_1256 = {difference_1253[6], difference_1253} + (equal_1254 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1502;
  assign difference_1502 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1501_s2_q};
  logic [7:0] sum_1504;
  assign sum_1504 = {difference_1502[6], difference_1502} + (equal_1254 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:751
  logic less_1505;
  assign less_1505 = sum_1256 < sum_1504;
  logic [7:0] select_1506;
  assign select_1506 = less_1505 ? sum_1504 : sum_1256;
  logic less_1507;
  assign less_1507 = select_1007 < select_1506;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1507 ? select_1506 : select_1007) : 8'h0;
  // hls/stages/agreement.hpp:808
  logic or_1511;
  assign or_1511 = select_756 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:813
  logic [5:0] select_1512;
  assign select_1512 = or_1511 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:720
  logic not_1513;
  assign not_1513 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:752
  logic [1:0] select_1514;
  assign select_1514 = less_1505 ? {slot_s2_q[0], not_1513} : 2'h0;
  logic [2:0] select_1516;
  assign select_1516 = less_1507 ? {select_1514, not_1513} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:813
  logic [2:0] select_1517;
  assign select_1517 = or_1511 ? select_1516 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1518;
  assign select_1518 = or_1511 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:810
  logic equal_1519;
  assign equal_1519 = select_1516 == 3'h1;
  logic or_1522;
  assign or_1522 = equal_1519 | (~(select_1516 == 3'h2));
  logic [7:0] select_1524;
  assign select_1524 = or_1522 ? before_0_q : before_1_q;
  logic [7:0] select_1525;
  assign select_1525 = equal_1519 ? (or_1522 ? sum_1256 : {7'h0, shift_not_right_q}) : select_1524;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1526;
  assign select_1526 = or_1511 ? select_1525 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1529;
  assign select_1529 = or_1511 ? (equal_1519 ? select_1524 : (or_1522 ? sum_1504 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1531;
  assign sum_1531 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1532;
  assign sum_1532 = {1'b0, before_v} + sum_1531;
  // hls/stages/agreement.hpp:755
  logic [6:0] select_1533;
  assign select_1533 = slot_s2_q[0] ? chosen_near_q : sum_1532;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1535;
  assign sum_1535 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1536;
  assign sum_1536 = {1'b0, before_v_2} + sum_1535;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1538;
  assign sum_1538 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1539;
  assign sum_1539 = {1'b0, before_v_3} + sum_1538;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1541;
  assign select_1541 = (sum_1536 < sum_1539) ? sum_1539 : sum_1536;
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1533 < select_1541) ? select_1541 : select_1533) : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_1545;
  assign less_1545 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:817
  logic [6:0] select_1547;
  assign select_1547 = select_756 ? of_near : (less_1545 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1549;
  assign select_1549 = select_756 ? run_shift_s2_q : (less_1545 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1552;
  assign select_1552 = (run_shift_s2_q == 6'h3f) ? of_best : (select_756 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:818
  logic [7:0] select_1555;
  assign select_1555 = (run_shift_s2_q == 6'h1) ? of_best : (select_756 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:823
  logic select_1558;
  assign select_1558 = or_754 ? shift_first_s2_q : equal_1557_s2_q;
  // hls/stages/agreement.hpp:824
  logic or_1560;
  assign or_1560 = select_1558 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_1561;
  assign select_1561 = or_1560 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1562;
  assign select_1562 = or_1560 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1564;
  assign or_1564 = select_1558 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:832
  logic [6:0] select_1565;
  assign select_1565 = or_1564 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1566;
  assign select_1566 = or_1564 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_1580;
  assign and_1580 = or_574_s2_q & (not_578_s2_q & (and_629 & or_1577_s2_q));
  // hls/stages/agreement.hpp:788
  logic and_1581;
  assign and_1581 = not_572_s2_q & and_1580;
  logic and_1584;
  assign and_1584 = not_570_s2_q & (so_s2_q ? and_1567_s2_q : (equal_573_s2_q & and_631));
  // hls/stages/moments.hpp:73
  logic and_1588;
  assign and_1588 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_1589;
  assign and_1589 = not_582_s2_q & and_1588;
  logic and_1592;
  assign and_1592 = not_582_s2_q & (and_1588 & (moments_memory_rdata_q[1] ^ and_634_s2_q));
  // hls/stages/moments.hpp:73
  logic and_1597;
  assign and_1597 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_1598;
  assign and_1598 = not_582_s2_q & and_1597;
  logic and_1601;
  assign and_1601 = not_582_s2_q & (and_1597 & (moments_memory_rdata_q[3] ^ and_641_s2_q));
  // hls/stages/agreement.hpp:1128
  logic equal_1602;
  assign equal_1602 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1178
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_1605;
  assign select_1605 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_1607;
  assign select_1607 = equal_1602 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1605});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1608;
  assign sum_1608 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_1609;
  assign select_1609 = equal_569_s2_q ? select_1607 : {sum_1608, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1610;
  assign equal_1610 = x_s2_q[5:0] == 6'h3f;
  logic equal_1612;
  assign equal_1612 = x_s2_q[5:0] == 6'h3e;
  logic equal_1614;
  assign equal_1614 = x_s2_q[5:0] == 6'h3d;
  logic equal_1616;
  assign equal_1616 = x_s2_q[5:0] == 6'h3c;
  logic equal_1618;
  assign equal_1618 = x_s2_q[5:0] == 6'h3b;
  logic equal_1620;
  assign equal_1620 = x_s2_q[5:0] == 6'h36;
  logic equal_1622;
  assign equal_1622 = x_s2_q[5:0] == 6'h35;
  logic equal_1624;
  assign equal_1624 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1178
  logic and_1628;
  assign and_1628 = (~equal_1618) & ((~equal_1620) & ((~equal_1622) & (~equal_1624)));
  logic and_1632;
  assign and_1632 = (~equal_1610) & ((~equal_1612) & ((~equal_1614) & ((~equal_1616) & and_1628)));
  // hls/stages/agreement.hpp:1129
  logic less_1633;
  assign less_1633 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1637;
  assign or_1637 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1009
  logic [4:0] sum_1642;
  assign sum_1642 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1642, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1648;
  assign sum_1648 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1650;
  assign and_1650 = half_ends & ({{3{sum_1648[4]}}, sum_1648} < 8'h3);
  // hls/stages/agreement.hpp:788
  logic and_1651;
  assign and_1651 = so_s2_q & and_1650;
  logic select_1652;
  assign select_1652 = equal_569_s2_q ? (x_s2_q[6] & (equal_1602 ? and_1632 : (less_1633 & (~or_1637)))) : and_1651;
  // hls/stages/registration.hpp:258
  logic not_1654;
  assign not_1654 = ~lower_half_s2_q;
  logic [3:0] select_1655;
  assign select_1655 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1654, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1654};
  // hls/stages/patches.hpp:373
  logic [1:0] select_1684;
  assign select_1684 = and_1683_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1685;
  assign select_1685 = and_1683_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1686;
  assign select_1686 = and_1670_s2_q ? {select_1685, select_1684[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1687;
  assign select_1687 = and_1670_s2_q ? select_1684 : patches_fetch_q;
  logic equal_1688;
  assign equal_1688 = select_1687 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < x_s2_q;
  // hls/stages/agreement.hpp:788
  logic and_1696;
  assign and_1696 = not_570_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1698;
  assign equal_1698 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_574_s2_q ? (less_577_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
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
  assign and_1721 = less_1697_s2_q & (and_631 & ({{4{sum_1718[9]}}, sum_1718, expected[1:0]} < 16'h29));
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
  assign and_1737 = (~(and_1725 | (equal_564_s2_q | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1736;
  // hls/stages/agreement.hpp:788
  logic and_1741;
  assign and_1741 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1721 & and_1737)));
  logic and_1742;
  assign and_1742 = not_570_s2_q & and_1741;
  // hls/stages/patches.hpp:156
  logic and_1744;
  assign and_1744 = and_1742 & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_1745;
  assign select_1745 = and_1744 ? and_1742 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:788
  logic [6:0] select_1748;
  assign select_1748 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  // hls/stages/patches.hpp:344
  logic [6:0] select_1750;
  assign select_1750 = and_1744 ? (equal_569_s2_q ? 7'h0 : select_1748) : patches_choice_column_q;
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1753;
  assign select_1753 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:344
  logic [5:0] select_1755;
  assign select_1755 = and_1744 ? (equal_569_s2_q ? 6'h0 : select_1753) : patches_choice_shift_q;
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
  // hls/stages/patches.hpp:344
  logic [7:0] select_1766;
  assign select_1766 = and_1744 ? (equal_569_s2_q ? 8'h0 : select_1764) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_1767;
  assign equal_1767 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:788
  logic and_1771;
  assign and_1771 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1725 | equal_1767)));
  logic and_1772;
  assign and_1772 = not_570_s2_q & and_1771;
  // hls/stages/patches.hpp:344
  logic and_1773;
  assign and_1773 = patches_chooses_s2_q & and_1772;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1787;
  assign select_1787 = and_1670_s2_q ? select_1685 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_1788;
  assign equal_1788 = {patches_choosing_band_s2_q, and_1696} == {select_1787, select_1687[1]};
  // hls/stages/patches.hpp:486
  logic [2:0] sum_1888;
  assign sum_1888 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:453
  logic and_1904;
  assign and_1904 = not_1897_s2_q & or_1903_s2_q;
  // hls/stages/patches.hpp:490
  logic [1:0] sum_1944;
  assign sum_1944 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1980;
  assign select_1980 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1983;
  assign or_1983 = select_1980[7] | (~({select_1980[5], select_1980[3], select_1980[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_1986;
  assign or_1986 = select_1980[7] | (~({select_1980[6], select_1980[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_1989;
  assign or_1989 = select_1980[7] | (~(select_1980[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1990;
  assign select_1990 = equal_569_s2_q ? x_s2_q[5:0] : {region_row_q, or_1989, or_1986, or_1983};
  // hls/stages/agreement.hpp:1128
  logic not_1991;
  assign not_1991 = ~equal_1602;
  // hls/stages/agreement.hpp:1058
  logic or_1995;
  assign or_1995 = (~sum_1993_s2_q) | equal_1767;
  // hls/stages/agreement.hpp:788
  logic and_1998;
  assign and_1998 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_1995));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_574_s2_q & (not_578_s2_q & and_603_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_631;
  // hls/stages/agreement.hpp:149
  logic and_2016;
  assign and_2016 = or_574_s2_q & (not_578_s2_q & and_2014_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2025;
  assign and_2025 = inside_v_s2_q & and_2016;
  // hls/stages/agreement.hpp:1014
  logic select_2026;
  assign select_2026 = slot_s2_q[2] ? shown_shown_q : and_631;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2026);
  // hls/stages/agreement.hpp:1014
  logic select_2029;
  assign select_2029 = slot_s2_q[2] ? shown_nearer_q : and_1580;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2026 ? select_2029 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1271
  logic select_2032;
  assign select_2032 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1275
  logic select_2033;
  assign select_2033 = left_first_s2_q ? select_2032 : read_half_q;
  logic or_2034;
  assign or_2034 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1276
  logic [8:0] select_2035;
  assign select_2035 = or_2034 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1277
  logic [9:0] select_2037;
  assign select_2037 = left_first_s2_q ? 10'h1 : (or_2034 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1280
  logic and_2038;
  assign and_2038 = select_2035[8] & select_2037[9];
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = and_2038 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1291
  logic [5:0] select_2041;
  assign select_2041 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2043;
  assign select_2043 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2041});
  // hls/stages/agreement.hpp:1301
  logic equal_2044;
  assign equal_2044 = seen_x_q == 3'h7;
  logic [7:0] select_2046;
  assign select_2046 = and_2038 ? 8'h0 : (seen_column_q + {7'h0, equal_2044});
  // hls/stages/agreement.hpp:1308
  logic [10:0] index;
  assign index = select_2043 + {3'h0, select_2046};
  // hls/stages/agreement.hpp:1261
  logic [11:0] sum_2048;
  assign sum_2048 = {1'b0, {2{select_2033}}, 2'h0, {2{select_2033}}, 1'b0, {2{select_2033}}, 1'b0, select_2033} + {1'b0, index};
  // hls/stages/agreement.hpp:1274
  logic not_2049;
  assign not_2049 = ~left_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2051;
  assign and_2051 = not_2049 & (began_q | and_2038);
  // hls/stages/agreement.hpp:1302
  logic [2:0] select_2053;
  assign select_2053 = and_2038 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1307
  logic and_2055;
  assign and_2055 = and_2051 & (select_2053 == 3'h0);
  logic less_2056;
  assign less_2056 = select_2046 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:438
  logic and_2057;
  assign and_2057 = and_2055 & less_2056;
  logic and_2058;
  assign and_2058 = and_1972_s2_q & and_2057;
  // hls/stages/agreement.hpp:278
  logic select_2060;
  assign select_2060 = and_1972_s2_q ? (left_first_s2_q ? and_2057 : and_2058) : and_2058;
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2062;
  assign sum_2062 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2062[7], sum_2062, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1261
  logic [11:0] sum_2064;
  assign sum_2064 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1030
  logic and_2065;
  assign and_2065 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2066;
  assign and_2066 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2067;
  assign and_2067 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2068;
  assign and_2068 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2070;
  assign sum_2070 = {1'b0, and_2067} + ({1'b0, textured} + {1'b0, and_2068});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2065} + ({2'h0, and_2066} + {1'b0, sum_2070});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2079;
  assign select_2079 = inside_v_s2_q ? (sum_1993_s2_q ? select_1980 : {select_1980[6:0], 1'b0}) : select_1980;
  // hls/stages/agreement.hpp:1050
  logic or_2082;
  assign or_2082 = select_2079[7] | (~({select_2079[5], select_2079[3], select_2079[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2099;
  assign and_2099 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2100;
  assign and_2100 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2101;
  assign and_2101 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2102;
  assign and_2102 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2104;
  assign sum_2104 = {1'b0, and_2101} + ({1'b0, shown} + {1'b0, and_2102});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2099} + ({2'h0, and_2100} + {1'b0, sum_2104});
  // hls/stages/agreement.hpp:1030
  logic and_2115;
  assign and_2115 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2116;
  assign and_2116 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2117;
  assign and_2117 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2118;
  assign and_2118 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2120;
  assign sum_2120 = {1'b0, and_2117} + ({1'b0, near} + {1'b0, and_2118});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2115} + ({2'h0, and_2116} + {1'b0, sum_2120});
  // hls/stages/agreement.hpp:788
  logic and_2136;
  assign and_2136 = ends_cell_s2_q & (and_2132_s2_q & (~({1'b0, sum_1642, last_s2_q[1:0]} < x_s2_q)));
  logic and_2138;
  assign and_2138 = not_570_s2_q & (so_s2_q & and_2136);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2170;
  assign select_2170 = sample_pair_whole_s2_q ? (and_542_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2172;
  assign select_2172 = sample_pair_whole_s2_q ? (and_542_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2191;
  assign select_2191 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2193;
  assign select_2193 = sample_pair_whole_s2_q ? (and_542_s2_q ? select_557 : averager_mask_q) : averager_mask_q;
  logic select_2195;
  assign select_2195 = sample_pair_whole_s2_q ? (and_542_s2_q ? select_561 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2196;
  assign select_2196 = and_544_s2_q ? select_550 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2197;
  assign select_2197 = and_544_s2_q ? select_554 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2199;
  assign select_2199 = and_544_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2200;
  assign select_2200 = and_544_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2201;
  assign select_2201 = and_544_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2202;
  assign select_2202 = and_544_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2203;
  assign select_2203 = and_544_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2204;
  assign select_2204 = and_544_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2205;
  assign select_2205 = and_544_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2206;
  assign select_2206 = and_544_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2207;
  assign select_2207 = and_544_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2208;
  assign select_2208 = and_544_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2209;
  assign select_2209 = and_544_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2210;
  assign select_2210 = and_544_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2211;
  assign select_2211 = and_544_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2212;
  assign select_2212 = and_544_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2213;
  assign select_2213 = and_544_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2214;
  assign select_2214 = and_544_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2215;
  assign select_2215 = and_544_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2216;
  assign select_2216 = and_544_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2217;
  assign select_2217 = and_544_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2218;
  assign select_2218 = and_544_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2219;
  assign select_2219 = and_544_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2220;
  assign select_2220 = and_544_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2221;
  assign select_2221 = and_544_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2222;
  assign select_2222 = and_544_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2223;
  assign select_2223 = and_544_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2224;
  assign select_2224 = and_544_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2225;
  assign select_2225 = and_544_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2226;
  assign select_2226 = and_544_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2227;
  assign select_2227 = and_544_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2228;
  assign select_2228 = and_544_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2229;
  assign select_2229 = and_544_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2230;
  assign select_2230 = and_544_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2231;
  assign select_2231 = and_544_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2232;
  assign select_2232 = and_544_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2233;
  assign select_2233 = and_544_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2234;
  assign select_2234 = and_544_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2235;
  assign select_2235 = and_544_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2236;
  assign select_2236 = and_544_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2237;
  assign select_2237 = and_544_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2238;
  assign select_2238 = and_544_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2239;
  assign select_2239 = and_544_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2240;
  assign select_2240 = and_544_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2241;
  assign select_2241 = and_544_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2242;
  assign select_2242 = and_544_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2243;
  assign select_2243 = and_544_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2244;
  assign select_2244 = and_544_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2245;
  assign select_2245 = and_544_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2246;
  assign select_2246 = and_544_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2247;
  assign select_2247 = and_544_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2248;
  assign select_2248 = and_544_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2249;
  assign select_2249 = and_544_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2250;
  assign select_2250 = and_544_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2251;
  assign select_2251 = and_544_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:274
  logic [9:0] difference_2253;
  assign difference_2253 = {1'b0, select_554} - {1'b0, census_columns_values_0_cell_0_right_q};
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
  assign select_2299 = equal_569_s2_q ? (moments_has_before_q | equal_2293) : moments_has_before_q;
  logic [13:0] select_2302;
  assign select_2302 = equal_569_s2_q ? ((select_2296 < select_2294) ? select_2294 : select_2296) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2303;
  assign sum_2303 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2306;
  assign select_2306 = equal_569_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2303)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2307;
  assign sum_2307 = {1'b0, sum_2292} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2310;
  assign select_2310 = equal_569_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2307)) : moments_left_alone_q;
  logic select_2313;
  assign select_2313 = equal_569_s2_q ? (~({3'h0, select_2296[13:2]} < sum_2307)) : moments_left_other_stops_q;
  logic select_2316;
  assign select_2316 = equal_569_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2303)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2317;
  assign sum_2317 = {1'b0, sum_2290} + 15'h3;
  // hls/stages/agreement.hpp:788
  logic select_2320;
  assign select_2320 = equal_569_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2317)) : moments_right_alone_q;
  logic select_2323;
  assign select_2323 = equal_569_s2_q ? (~({3'h0, select_2294[13:2]} < sum_2317)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2326;
  assign or_2326 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:788
  logic and_2334;
  assign and_2334 = not_570_s2_q & (not_572_s2_q & (equal_573_s2_q & (inside_v_s2_q & and_1592)));
  logic and_2338;
  assign and_2338 = not_570_s2_q & (not_572_s2_q & (equal_573_s2_q & (inside_v_s2_q & and_1601)));
  // hls/stages/moments.hpp:94
  logic and_2340;
  assign and_2340 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2343;
  assign select_2343 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2340)) : and_2340;
  // hls/stages/agreement.hpp:788
  logic and_2347;
  assign and_2347 = equal_569_s2_q & (equal_2293 & (cfg_prove_i & (cfg_same_table_i & select_2343)));
  // hls/stages/moments.hpp:95
  logic and_2350;
  assign and_2350 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:359
  logic [9:0] difference_2364;
  assign difference_2364 = {1'b0, select_550} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2364[9]} + (difference_2364[8:0] ^ {9{difference_2364[9]}});
  logic [9:0] difference_2376;
  assign difference_2376 = {1'b0, select_554} - {1'b0, sharpness_last_mean_1_q};
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
  assign select_2576 = slot_s2_q[0] ? 8'h0 : sum_1006;
  // hls/stages/agreement.hpp:751
  logic less_2577;
  assign less_2577 = select_2576 < select_1506;
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2579;
  assign select_2579 = slot_s2_q[0] ? 7'h0 : sum_1532;
  // hls/stages/agreement.hpp:788
  logic not_2584;
  assign not_2584 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2585;
  assign less_2585 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_2592;
  assign and_2592 = and_544_s2_q & (equal_674_s2_q & equal_2467_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_2598;
  assign and_2598 = not_570_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2594_s2_q)));
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
  assign and_2659 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2594_s2_q & and_2016)));
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
  assign and_2689 = not_578_s2_q & (((and_2014_s2_q & and_629) & equal_2679_s2_q) & (~less_2686));
  // hls/stages/agreement.hpp:788
  logic and_2693;
  assign and_2693 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_574_s2_q & and_2689)));
  // hls/stages/agreement.hpp:149
  logic and_2698;
  assign and_2698 = not_578_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2700;
  assign and_2700 = not_578_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2701;
  assign select_2701 = or_574_s2_q ? {and_2700, and_2698} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2703;
  assign select_2703 = less_577_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2704;
  assign select_2704 = or_574_s2_q ? select_2703 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_2706;
  assign and_2706 = and_631 & (select_2701[0] & select_2704[0]);
  // hls/stages/agreement.hpp:788
  logic and_2710;
  assign and_2710 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2701[1] & and_2706)));
  logic and_2711;
  assign and_2711 = not_570_s2_q & and_2710;
  logic and_2717;
  assign and_2717 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2704[1] & and_2706)));
  logic and_2718;
  assign and_2718 = not_570_s2_q & and_2717;
  // hls/stages/registration.hpp:76
  logic less_2721;
  assign less_2721 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2723;
  assign select_2723 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2725;
  assign select_2725 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2727;
  assign select_2727 = or_574_s2_q ? (less_577_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
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
  assign select_2746 = equal_569_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_2748;
  assign select_2748 = equal_569_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2749;
  assign equal_2749 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_2753;
  assign and_2753 = and_631 & less_1697_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2755;
  assign select_2755 = or_574_s2_q ? (less_577_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
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
  assign select_2818 = (sum_1608 == 2'h2) ? (registration_fresh_q & (~select_1655)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2820;
  assign select_2820 = so_s2_q ? (and_1650 ? select_2818 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2822;
  assign select_2822 = and_2592 ? 4'hf : (equal_569_s2_q ? registration_fresh_q : select_2820);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1605;
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
  // hls/stages/patches.hpp:345
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
  // hls/stages/patches.hpp:156
  logic and_2993;
  assign and_2993 = not_2981 & (patches_fixed_q | ((not_570_s2_q & and_2989) & and_1744));
  // hls/stages/patches.hpp:354
  logic not_3006;
  assign not_3006 = ~select_1687[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3008;
  assign select_3008 = sample_pair_whole_s2_q ? (equal_1688 ? select_1687 : {not_3006, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:522
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3107;
  assign select_3107 = or_1780_s2_q ? {and_1926_s2_q, and_1923_s2_q, and_1907_s2_q, and_1904, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3109;
  assign select_3109 = equal_1774_s2_q ? patches_codes_at_q : (equal_1776_s2_q ? other[55:4] : select_3107);
  // hls/stages/patches.hpp:505
  logic [27:0] word;
  assign word = or_1880_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:521
  logic [27:0] select_3112;
  assign select_3112 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3114;
  assign select_3114 = equal_1776_s2_q ? (new_row_s2_q ? word : select_3112) : patches_codes_further_q;
  // hls/stages/patches.hpp:523
  logic [55:0] select_3116;
  assign select_3116 = less_1867_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:493
  logic [55:0] select_3118;
  assign select_3118 = less_3117_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3120;
  assign select_3120 = or_1780_s2_q ? (equal_1779_s2_q ? patches_next_codes_q : select_3118) : patches_next_codes_q;
  logic [55:0] select_3122;
  assign select_3122 = equal_1774_s2_q ? patches_next_codes_q : (equal_1776_s2_q ? select_3116 : select_3120);
  // hls/stages/count_bits.hpp:24
  logic parity_3127;
  assign parity_3127 = ^{and_1926_s2_q, and_1923_s2_q, and_1907_s2_q, and_1904};
  // hls/stages/count_bits.hpp:25
  logic or_3131;
  assign or_3131 = ({and_1907_s2_q, and_1904} == 2'h3) | (and_1923_s2_q & (and_1907_s2_q | and_1904));
  logic and_3132;
  assign and_3132 = and_1926_s2_q & (^{and_1923_s2_q, and_1907_s2_q, and_1904});
  // hls/stages/count_bits.hpp:24
  logic xor_3133;
  assign xor_3133 = or_3131 ^ and_3132;
  // hls/stages/count_bits.hpp:27
  logic and_3134;
  assign and_3134 = or_3131 & and_3132;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3136;
  assign select_3136 = or_1780_s2_q ? (and_1949_s2_q ? {and_3134, xor_3133, parity_3127} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3140;
  assign sum_3140 = {7'h0, patches_set_q} + (equal_1779_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:522
  logic [47:0] select_3150;
  assign select_3150 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3152;
  assign select_3152 = equal_1774_s2_q ? patches_left_row_q : (equal_1776_s2_q ? select_3150 : patches_left_row_q);
  // hls/stages/patches.hpp:524
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3150;
  // hls/stages/count_bits.hpp:24
  logic xor_3156;
  assign xor_3156 = bits[17] ^ (^{select_3150[16:15], other[16:15]});
  logic xor_3159;
  assign xor_3159 = bits[11] ^ (^{select_3150[10:9], other[10:9]});
  logic xor_3162;
  assign xor_3162 = bits[14] ^ (^{select_3150[13:12], other[13:12]});
  logic xor_3165;
  assign xor_3165 = xor_3156 ^ (^{select_3150[14:9], other[14:9]});
  logic xor_3168;
  assign xor_3168 = bits[47] ^ (^{select_3150[46:45], other[46:45]});
  logic xor_3171;
  assign xor_3171 = bits[8] ^ (^{select_3150[7:6], other[7:6]});
  logic xor_3174;
  assign xor_3174 = bits[2] ^ (^{select_3150[1:0], other[1:0]});
  logic xor_3177;
  assign xor_3177 = bits[5] ^ (^{select_3150[4:3], other[4:3]});
  logic xor_3180;
  assign xor_3180 = xor_3171 ^ (^{select_3150[5:0], other[5:0]});
  logic parity_3182;
  assign parity_3182 = ^{select_3150[47:45], select_3150[8:0], other[47:45], other[8:0]};
  logic xor_3183;
  assign xor_3183 = xor_3165 ^ parity_3182;
  logic xor_3186;
  assign xor_3186 = bits[44] ^ (^{select_3150[43:42], other[43:42]});
  logic xor_3189;
  assign xor_3189 = bits[38] ^ (^{select_3150[37:36], other[37:36]});
  logic xor_3192;
  assign xor_3192 = bits[41] ^ (^{select_3150[40:39], other[40:39]});
  logic xor_3198;
  assign xor_3198 = bits[26] ^ (^{select_3150[25:24], other[25:24]});
  logic xor_3201;
  assign xor_3201 = bits[20] ^ (^{select_3150[19:18], other[19:18]});
  logic xor_3204;
  assign xor_3204 = bits[23] ^ (^{select_3150[22:21], other[22:21]});
  logic xor_3207;
  assign xor_3207 = xor_3198 ^ (^{select_3150[23:18], other[23:18]});
  logic xor_3210;
  assign xor_3210 = bits[35] ^ (^{select_3150[34:33], other[34:33]});
  logic xor_3213;
  assign xor_3213 = bits[29] ^ (^{select_3150[28:27], other[28:27]});
  logic xor_3216;
  assign xor_3216 = bits[32] ^ (^{select_3150[31:30], other[31:30]});
  logic xor_3219;
  assign xor_3219 = xor_3210 ^ (^{select_3150[32:27], other[32:27]});
  logic xor_3220;
  assign xor_3220 = xor_3207 ^ xor_3219;
  // hls/stages/count_bits.hpp:25
  logic or_3228;
  assign or_3228 = (xor_3159 & xor_3162) | (xor_3156 & (xor_3159 | xor_3162));
  logic or_3232;
  assign or_3232 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3236;
  assign or_3236 = (xor_3174 & xor_3177) | (xor_3171 & (xor_3174 | xor_3177));
  // hls/stages/count_bits.hpp:23
  logic or_3243;
  assign or_3243 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3247;
  assign or_3247 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3251;
  assign or_3251 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3254;
  assign parity_3254 = ^{or_3251, or_3247, or_3243};
  // hls/stages/count_bits.hpp:23
  logic or_3258;
  assign or_3258 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3262;
  assign or_3262 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3266;
  assign or_3266 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3269;
  assign parity_3269 = ^{or_3266, or_3262, or_3258};
  logic parity_3272;
  assign parity_3272 = ^{or_3266, or_3262, or_3258, or_3251, or_3247, or_3243, or_3236, or_3232, or_3228};
  // hls/stages/count_bits.hpp:23
  logic or_3276;
  assign or_3276 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3280;
  assign or_3280 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3284;
  assign or_3284 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3292;
  assign or_3292 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3296;
  assign or_3296 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3300;
  assign or_3300 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3303;
  assign parity_3303 = ^{or_3300, or_3296, or_3292};
  // hls/stages/count_bits.hpp:23
  logic or_3307;
  assign or_3307 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3311;
  assign or_3311 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3315;
  assign or_3315 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3318;
  assign parity_3318 = ^{or_3315, or_3311, or_3307};
  logic parity_3321;
  assign parity_3321 = ^{or_3315, or_3311, or_3307, or_3300, or_3296, or_3292, or_3284, or_3280, or_3276};
  // hls/stages/count_bits.hpp:25
  logic or_3325;
  assign or_3325 = (xor_3189 & xor_3192) | (xor_3186 & (xor_3189 | xor_3192));
  logic or_3329;
  assign or_3329 = (xor_3201 & xor_3204) | (xor_3198 & (xor_3201 | xor_3204));
  logic or_3333;
  assign or_3333 = (xor_3213 & xor_3216) | (xor_3210 & (xor_3213 | xor_3216));
  // hls/stages/count_bits.hpp:24
  logic parity_3336;
  assign parity_3336 = ^{or_3333, or_3329, or_3325};
  // hls/stages/count_bits.hpp:25
  logic and_3337;
  assign and_3337 = xor_3183 & (^{xor_3220, select_3150[44:36], other[44:36]});
  logic or_3341;
  assign or_3341 = (xor_3168 & xor_3180) | (xor_3165 & (xor_3168 | xor_3180));
  logic and_3344;
  assign and_3344 = (xor_3186 ^ (^{select_3150[41:36], other[41:36]})) & (xor_3207 | xor_3219);
  logic or_3345;
  assign or_3345 = (xor_3207 & xor_3219) | and_3344;
  // hls/stages/count_bits.hpp:24
  logic parity_3348;
  assign parity_3348 = ^{or_3345, or_3341, and_3337};
  logic parity_3351;
  assign parity_3351 = ^{or_3345, or_3341, and_3337, or_3333, or_3329, or_3325, or_3315, or_3311, or_3307, or_3300, or_3296, or_3292, or_3284, or_3280, or_3276};
  logic parity_3353;
  assign parity_3353 = ^{or_3345, or_3341, and_3337, or_3333, or_3329, or_3325, or_3315, or_3311, or_3307, or_3300, or_3296, or_3292, or_3284, or_3280, or_3276, or_3266, or_3262, or_3258, or_3251, or_3247, or_3243, or_3236, or_3232, or_3228};
  // hls/stages/count_bits.hpp:25
  logic and_3354;
  assign and_3354 = parity_3272 & parity_3351;
  logic or_3358;
  assign or_3358 = (parity_3254 & parity_3269) | ((^{or_3236, or_3232, or_3228}) & (parity_3254 | parity_3269));
  logic or_3362;
  assign or_3362 = (parity_3336 & parity_3348) | (parity_3321 & (parity_3336 | parity_3348));
  logic or_3369;
  assign or_3369 = (parity_3303 & parity_3318) | ((^{or_3284, or_3280, or_3276}) & (parity_3303 | parity_3318));
  logic or_3373;
  assign or_3373 = (or_3329 & or_3333) | (or_3325 & (or_3329 | or_3333));
  logic or_3377;
  assign or_3377 = (or_3341 & or_3345) | (and_3337 & (or_3341 | or_3345));
  // hls/stages/count_bits.hpp:23
  logic or_3384;
  assign or_3384 = (or_3280 & or_3284) | (or_3276 & (or_3280 | or_3284));
  // hls/stages/count_bits.hpp:25
  logic or_3388;
  assign or_3388 = (or_3296 & or_3300) | (or_3292 & (or_3296 | or_3300));
  logic or_3392;
  assign or_3392 = (or_3311 & or_3315) | (or_3307 & (or_3311 | or_3315));
  // hls/stages/count_bits.hpp:24
  logic parity_3395;
  assign parity_3395 = ^{or_3392, or_3388, or_3384};
  // hls/stages/count_bits.hpp:23
  logic or_3399;
  assign or_3399 = (or_3232 & or_3236) | (or_3228 & (or_3232 | or_3236));
  // hls/stages/count_bits.hpp:25
  logic or_3403;
  assign or_3403 = (or_3247 & or_3251) | (or_3243 & (or_3247 | or_3251));
  logic or_3407;
  assign or_3407 = (or_3262 & or_3266) | (or_3258 & (or_3262 | or_3266));
  // hls/stages/count_bits.hpp:24
  logic parity_3410;
  assign parity_3410 = ^{or_3407, or_3403, or_3399};
  logic parity_3413;
  assign parity_3413 = ^{or_3407, or_3403, or_3399, or_3392, or_3388, or_3384, or_3377, or_3373, or_3369};
  logic parity_3415;
  assign parity_3415 = ^{or_3407, or_3403, or_3399, or_3392, or_3388, or_3384, or_3377, or_3373, or_3369, or_3362, or_3358, and_3354};
  // hls/stages/count_bits.hpp:25
  logic or_3419;
  assign or_3419 = (or_3373 & or_3377) | (or_3369 & (or_3373 | or_3377));
  logic or_3423;
  assign or_3423 = (or_3388 & or_3392) | (or_3384 & (or_3388 | or_3392));
  logic or_3427;
  assign or_3427 = (or_3403 & or_3407) | (or_3399 & (or_3403 | or_3407));
  // hls/stages/count_bits.hpp:24
  logic parity_3430;
  assign parity_3430 = ^{or_3427, or_3423, or_3419};
  // hls/stages/count_bits.hpp:25
  logic and_3431;
  assign and_3431 = (^{or_3362, or_3358, and_3354}) & parity_3413;
  logic or_3435;
  assign or_3435 = (or_3358 & or_3362) | (and_3354 & (or_3358 | or_3362));
  logic or_3439;
  assign or_3439 = (parity_3395 & parity_3410) | ((^{or_3377, or_3373, or_3369}) & (parity_3395 | parity_3410));
  // hls/stages/count_bits.hpp:24
  logic parity_3442;
  assign parity_3442 = ^{or_3439, or_3435, and_3431};
  // hls/stages/count_bits.hpp:25
  logic and_3444;
  assign and_3444 = parity_3430 & parity_3442;
  logic or_3448;
  assign or_3448 = (or_3423 & or_3427) | (or_3419 & (or_3423 | or_3427));
  logic or_3452;
  assign or_3452 = (or_3435 & or_3439) | (and_3431 & (or_3435 | or_3439));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3497;
  assign select_3497 = equal_1776_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3500;
  assign select_3500 = equal_1774_s2_q ? patches_summed_first_q : (equal_1776_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:556
  logic [9:0] select_3507;
  assign select_3507 = less_1955_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:560
  logic [9:0] select_3510;
  assign select_3510 = equal_1958_s2_q ? (less_1955_s2_q ? (equal_1958_s2_q ? 10'h0 : select_3507) : 10'h0) : select_3507;
  logic [9:0] select_3512;
  assign select_3512 = less_1955_s2_q ? (equal_1956_s2_q ? 10'h0 : select_3510) : select_3510;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3514;
  assign select_3514 = less_1955_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3517;
  assign select_3517 = equal_1958_s2_q ? (less_1955_s2_q ? (equal_1958_s2_q ? 5'h0 : select_3514) : 5'h0) : select_3514;
  logic [4:0] select_3519;
  assign select_3519 = less_1955_s2_q ? (equal_1956_s2_q ? 5'h0 : select_3517) : select_3517;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3521;
  assign select_3521 = less_1955_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:560
  logic [4:0] select_3524;
  assign select_3524 = equal_1958_s2_q ? (less_1955_s2_q ? (equal_1958_s2_q ? 5'h0 : select_3521) : 5'h0) : select_3521;
  logic [4:0] select_3526;
  assign select_3526 = less_1955_s2_q ? (equal_1956_s2_q ? 5'h0 : select_3524) : select_3524;
  // hls/stages/patches.hpp:556
  logic and_3529;
  assign and_3529 = less_1955_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:560
  logic select_3532;
  assign select_3532 = equal_1958_s2_q ? (less_1955_s2_q ? (not_1959_s2_q & and_3529) : and_3529) : and_3529;
  // hls/stages/patches.hpp:184
  logic select_3535;
  assign select_3535 = equal_1774_s2_q ? (less_1955_s2_q ? (not_1957_s2_q & select_3532) : select_3532) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3546;
  assign or_3546 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3547;
  assign and_3547 = patches_read_searches_s2_q & or_3546;
  // hls/stages/patches.hpp:540
  logic [4:0] select_3548;
  assign select_3548 = and_3547 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:547
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3548};
  // hls/stages/patches.hpp:556
  logic and_3552;
  assign and_3552 = less_1955_s2_q & (equal_3544_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:560
  logic select_3555;
  assign select_3555 = equal_1958_s2_q ? (less_1955_s2_q ? (not_1959_s2_q & and_3552) : and_3552) : and_3552;
  // hls/stages/patches.hpp:184
  logic select_3558;
  assign select_3558 = equal_1774_s2_q ? (less_1955_s2_q ? (not_1957_s2_q & select_3555) : select_3555) : patches_read_above_q;
  // hls/stages/patches.hpp:556
  logic and_3561;
  assign and_3561 = less_1955_s2_q & (equal_3544_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:560
  logic select_3564;
  assign select_3564 = equal_1958_s2_q ? (less_1955_s2_q ? (not_1959_s2_q & and_3561) : and_3561) : and_3561;
  // hls/stages/patches.hpp:184
  logic select_3567;
  assign select_3567 = equal_1774_s2_q ? (less_1955_s2_q ? (not_1957_s2_q & select_3564) : select_3564) : patches_read_below_q;
  // hls/stages/patches.hpp:553
  logic [6:0] sum_3568;
  assign sum_3568 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:554
  logic [9:0] select_3571;
  assign select_3571 = (equal_3544_s2_q & ({sum_3568[6], sum_3568} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3572;
  assign select_3572 = less_1955_s2_q ? select_3571 : 10'h3ff;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3574;
  assign select_3574 = less_1955_s2_q ? (equal_1958_s2_q ? 10'h3ff : select_3572) : 10'h3ff;
  // hls/stages/patches.hpp:560
  logic [9:0] select_3575;
  assign select_3575 = equal_1958_s2_q ? select_3574 : select_3572;
  logic [9:0] select_3577;
  assign select_3577 = less_1955_s2_q ? (equal_1956_s2_q ? 10'h3ff : select_3575) : select_3575;
  // hls/stages/patches.hpp:539
  logic [14:0] select_3579;
  assign select_3579 = and_3547 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3580;
  assign select_3580 = equal_1774_s2_q ? select_3579[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3581;
  assign select_3581 = equal_1774_s2_q ? select_3579[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:541
  logic [9:0] select_3583;
  assign select_3583 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:542
  logic [9:0] select_3585;
  assign select_3585 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:543
  logic [9:0] select_3588;
  assign select_3588 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3589;
  assign select_3589 = patches_read_first_q ? patches_read_far_q : select_3588;
  // hls/stages/patches.hpp:594
  logic [9:0] difference_3592;
  assign difference_3592 = select_3589 - select_3579[9:0];
  // hls/stages/patches.hpp:579
  logic less_3622;
  assign less_3622 = select_3583 < select_3585;
  // hls/stages/patches.hpp:585
  logic [1:0] sum_3623;
  assign sum_3623 = select_3548[4:3] + 2'h3;
  // hls/stages/patches.hpp:580
  logic [9:0] high;
  assign high = less_3622 ? select_3585 : select_3583;
  logic [9:0] low;
  assign low = (select_3585 < select_3583) ? select_3585 : select_3583;
  // hls/stages/patches.hpp:581
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3579[9:0];
  // hls/stages/patches.hpp:583
  logic not_3630;
  assign not_3630 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3631;
  assign sum_3631 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3633;
  assign not_3633 = ~({eight, 3'h0} < {1'b0, sum_3631, fall_2[0]});
  logic [1:0] sum_3634;
  assign sum_3634 = {1'b0, not_3630} + {1'b0, not_3633};
  // hls/stages/patches.hpp:584
  logic [10:0] sum_3635;
  assign sum_3635 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3637;
  assign not_3637 = ~({eight, 3'h0} < {sum_3635, fall_2[1:0]});
  logic not_3640;
  assign not_3640 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3641;
  assign sum_3641 = {1'b0, not_3637} + {1'b0, not_3640};
  // hls/stages/patches.hpp:583
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3634} + {1'b0, sum_3641};
  // hls/stages/patches.hpp:586
  logic [7:0] select_3644;
  assign select_3644 = less_3622 ? ({sum_3623, select_3548[2:0], 3'h0} - {5'h0, fraction}) : {sum_3623, select_3548[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_3867;
  assign select_3867 = equal_569_s2_q ? shown_shown_q : (so_s2_q ? select_2026 : shown_shown_q);
  logic select_3869;
  assign select_3869 = equal_569_s2_q ? shown_nearer_q : (so_s2_q ? select_2029 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3871;
  assign sum_3871 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3873;
  assign select_3873 = less_3870_s2_q ? (sum_3871[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3875;
  assign select_3875 = equal_2467_s2_q ? (equal_674_s2_q ? 3'h0 : select_3873) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3880;
  assign select_3880 = equal_569_s2_q ? select_1980 : (so_s2_q ? (ends_cell_s2_q ? select_2079 : select_1980) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3894;
  assign select_3894 = equal_674_s2_q ? {{2{difference_3892[6]}}, difference_3892} : (less_3870_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3896;
  assign select_3896 = and_544_s2_q ? (equal_2467_s2_q ? select_3894 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_3898;
  assign select_3898 = equal_674_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_3900;
  assign select_3900 = and_544_s2_q ? (equal_2467_s2_q ? select_3898 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3901;
  assign sum_3901 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3902;
  assign select_3902 = sum_3871[7] ? {1'b1, sum_3871[6:0], region_down_rest_q[0]} : sum_3901;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3871[7];
  // hls/stages/agreement.hpp:460
  logic select_3906;
  assign select_3906 = equal_2467_s2_q ? (equal_674_s2_q | (less_3870_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3911;
  assign or_3911 = segment_starts_q | not_572_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_3914;
  assign select_3914 = inside_v_s2_q ? (sum_1993_s2_q ? (equal_1767 & or_1995) : or_1995) : or_3911;
  // hls/stages/agreement.hpp:788
  logic select_3917;
  assign select_3917 = equal_569_s2_q ? or_3911 : (so_s2_q ? (ends_cell_s2_q ? select_3914 : or_3911) : or_3911);
  // hls/stages/agreement.hpp:1147
  logic equal_3941;
  assign equal_3941 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:788
  logic select_4077;
  assign select_4077 = so_s2_q ? (ends_cell_s2_q ? and_2067 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4080;
  assign select_4080 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4082;
  assign select_4082 = equal_569_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4080 : centres_values_0_of_skin_q);
  logic select_4083;
  assign select_4083 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4085;
  assign select_4085 = equal_569_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4083 : centres_values_1_textured_q);
  logic select_4086;
  assign select_4086 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4088;
  assign select_4088 = equal_569_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4086 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [10:0] select_4092;
  assign select_4092 = equal_2467_s2_q ? (equal_4089_s2_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [5:0] select_4095;
  assign select_4095 = and_544_s2_q ? (equal_2467_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1271
  logic xor_4096;
  assign xor_4096 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:438
  logic select_4098;
  assign select_4098 = and_1972_s2_q ? (left_first_s2_q ? xor_4096 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:278
  logic select_4100;
  assign select_4100 = and_1972_s2_q ? (left_first_s2_q ? xor_4096 : select_4098) : write_half_q;
  logic select_4102;
  assign select_4102 = left_first_s2_q ? select_2032 : (and_1972_s2_q ? select_2033 : read_half_q);
  logic and_4106;
  assign and_4106 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_4115;
  assign select_4115 = left_first_s2_q ? 10'h1 : (and_1972_s2_q ? select_2037 : rows_passed_q);
  logic [8:0] select_4118;
  assign select_4118 = left_first_s2_q ? {select_2035[7:0], or_2034} : (and_1972_s2_q ? {select_2035[7:0], or_2034} : columns_passed_q);
  logic select_4121;
  assign select_4121 = left_first_s2_q ? marks_last_s2_q : (and_1972_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4124;
  assign select_4124 = left_first_s2_q ? and_2051 : (and_1972_s2_q ? and_2051 : began_q);
  logic [2:0] select_4127;
  assign select_4127 = left_first_s2_q ? select_2053 : (and_1972_s2_q ? select_2053 : seen_x_q);
  // hls/stages/agreement.hpp:1300
  logic [2:0] select_4132;
  assign select_4132 = left_first_s2_q ? 3'h0 : (and_2038 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:278
  logic [2:0] select_4134;
  assign select_4134 = left_first_s2_q ? 3'h0 : (and_1972_s2_q ? select_4132 : seen_y_q);
  logic [7:0] select_4137;
  assign select_4137 = left_first_s2_q ? select_2046 : (and_1972_s2_q ? select_2046 : seen_column_q);
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4143;
  assign select_4143 = left_first_s2_q ? select_4141 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:278
  logic [7:0] select_4145;
  assign select_4145 = left_first_s2_q ? select_4141 : (and_1972_s2_q ? select_4143 : seen_rows_left_q);
  // hls/stages/agreement.hpp:436
  logic and_4150;
  assign and_4150 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:278
  logic select_4152;
  assign select_4152 = left_first_s2_q ? and_4150 : (and_1972_s2_q ? and_4150 : at_cell_end_q);
  logic select_4155;
  assign select_4155 = left_first_s2_q ? next_row : (and_1972_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4158;
  assign select_4158 = left_first_s2_q ? 11'h0 : (and_1972_s2_q ? select_2043 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4231;
  assign not_4231 = ~quarter[1];
  logic [3:0] select_4232;
  assign select_4232 = quarter[0] ? {quarter[1], 1'b0, not_4231, 1'b0} : {1'b0, quarter[1], 1'b0, not_4231};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1609;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1652;
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
  assign patches_choices_raddr = select_1686;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1688));
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
  assign regions_raddr = select_1990;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s2_en & (equal_569_s2_q ? (x_s2_q[6] & not_1991) : and_1998);
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
  assign map_raddr = sum_2048;
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s2_en & select_2060;
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_514_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_519_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_538, and_534, sum_530, sum_526};
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
  assign census_memory_we = s2_en & and_544_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_562, whole_2, select_554, select_550};
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
  assign moments_memory_waddr = select_568_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_586_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_641_s2_q, and_639_s2_q, and_634_s2_q, and_632};
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
  assign best_left_we = s2_en & and_1556_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1555, select_1552, select_1549, select_1547, select_1529, select_1526, select_1518, select_1517, select_1512};
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
  assign best_right_we = s2_en & and_1556_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1566, select_1565, select_1562, select_1561};
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
  assign shown_right_waddr = select_1573_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1584;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1581, not_572_s2_q};
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
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1592, and_1589};
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
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1601, and_1598};
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
  assign patches_right_codes_waddr = {sum_1888, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1940_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1926_s2_q, and_1923_s2_q, and_1907_s2_q, and_1904, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1944, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1954_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1926_s2_q, and_1923_s2_q, and_1907_s2_q, and_1904, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_1569_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2025, textured};
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
      averager_running_of_skin_q <= select_2191;
      averager_mask_q <= select_2193;
      averager_of_skin_q <= select_2195;
      census_filled_q <= and_544_s2_q ? {select_677[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2290;
      moments_turned_1_q <= sum_2292;
      moments_before_0_q <= equal_569_s2_q ? select_2294 : moments_before_0_q;
      moments_before_1_q <= equal_569_s2_q ? select_2296 : moments_before_1_q;
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
      moments_ends_q <= equal_569_s2_q & (equal_2293 & (not_2348 | and_2350));
      rows_passed_above_q <= and_544_s2_q ? select_676 : rows_passed_above_q;
      chosen_score_q <= less_2577 ? select_1506 : select_2576;
      chosen_near_q <= (select_2579 < select_1541) ? select_1541 : select_2579;
      chosen_place_q <= less_2577 ? {select_1514, not_1513} : 3'h2;
      before_0_q <= select_2576;
      before_1_q <= sum_1256;
      before_2_q <= sum_1504;
      shift_allowed_q <= not_2584 & (~less_2585);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2592 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2711});
      counts_turned_right_q <= and_2592 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2718});
      registration_displacement_over_q <= so_s2_q ? sum_2742[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2744;
      registration_slope_here_q <= select_2746;
      registration_expected_q <= select_2748;
      registration_of_right_q <= equal_569_s2_q ? registration_of_right_q : select_2810;
      registration_was_inside_q <= equal_569_s2_q ? registration_was_inside_q : select_2813;
      registration_fresh_q <= select_2822;
      patches_chance_q <= and_544_s2_q ? select_2979 : patches_chance_q;
      patches_fixed_q <= and_2993;
      patches_choice_valid_q <= and_1772 ? (select_1745 & not_2981) : select_1745;
      patches_choice_column_q <= select_1750;
      patches_choice_shift_q <= select_1755;
      patches_choice_slope_q <= select_1766;
      patches_band_q <= sample_pair_whole_s2_q ? select_1787 : patches_band_q;
      patches_fetch_q <= select_3008;
      patches_codes_at_q <= select_3109;
      patches_codes_further_q <= equal_1774_s2_q ? patches_codes_further_q : select_3114;
      patches_next_codes_q <= select_3122;
      patches_set_q <= equal_1774_s2_q ? 3'h0 : (equal_1776_s2_q ? 3'h0 : select_3136);
      patches_size_q <= sum_3140;
      patches_left_row_q <= select_3152;
      patches_summed_row_column_q <= equal_1774_s2_q ? patches_summed_row_column_q : select_3497;
      patches_summed_first_q <= select_3500;
      patches_read_row_differing_q <= equal_1774_s2_q ? select_3512 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1774_s2_q ? select_3519 : patches_read_row_column_q;
      patches_read_at_q <= equal_1774_s2_q ? select_3526 : patches_read_at_q;
      patches_read_first_q <= select_3535;
      patches_read_above_q <= select_3558;
      patches_read_below_q <= select_3567;
      patches_read_far_q <= equal_1774_s2_q ? select_3577 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3580;
      patches_peak_best_column_q <= select_3581;
      patches_peak_row_q <= equal_1774_s2_q ? select_3548 : patches_peak_row_q;
      patches_peak_above_q <= equal_1774_s2_q ? select_3583 : patches_peak_above_q;
      patches_peak_below_q <= equal_1774_s2_q ? select_3585 : patches_peak_below_q;
      patches_peak_far_q <= equal_1774_s2_q ? select_3589 : patches_peak_far_q;
      patches_frame_ended_q <= equal_569_s2_q & equal_2293;
      shown_shown_q <= select_3867;
      shown_nearer_q <= select_3869;
      region_row_q <= and_544_s2_q ? select_3875 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3880;
      region_down_rest_q <= select_3896;
      region_down_back_q <= select_3900;
      region_down_next_q <= select_3902;
      region_fresh_q <= and_544_s2_q ? select_3906 : region_fresh_q;
      segment_starts_q <= select_3917;
      centres_values_0_textured_q <= equal_569_s2_q ? centres_values_0_textured_q : select_4077;
      centres_values_0_of_skin_q <= select_4082;
      centres_values_1_textured_q <= select_4085;
      centres_values_1_of_skin_q <= select_4088;
      map_row_q <= and_544_s2_q ? select_4092 : map_row_q;
      map_width_q <= select_4095;
      write_half_q <= select_4100;
      read_half_q <= and_1972_s2_q ? select_4102 : read_half_q;
      done_q <= and_1972_s2_q ? (not_2049 & and_4106) : and_4106;
      drew_q <= so_s2_q;
      said_q <= equal_569_s2_q & equal_3941;
      rows_passed_q <= and_1972_s2_q ? select_4115 : rows_passed_q;
      columns_passed_q <= and_1972_s2_q ? select_4118 : columns_passed_q;
      line_ended_q <= and_1972_s2_q ? select_4121 : line_ended_q;
      began_q <= and_1972_s2_q ? select_4124 : began_q;
      seen_x_q <= and_1972_s2_q ? select_4127 : seen_x_q;
      seen_y_q <= and_1972_s2_q ? select_4134 : seen_y_q;
      seen_column_q <= and_1972_s2_q ? select_4137 : seen_column_q;
      seen_rows_left_q <= and_1972_s2_q ? select_4145 : seen_rows_left_q;
      at_cell_end_q <= and_1972_s2_q ? select_4152 : at_cell_end_q;
      was_next_row_q <= and_1972_s2_q ? select_4155 : was_next_row_q;
      seen_base_q <= and_1972_s2_q ? select_4158 : seen_base_q;
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
      left_pixel_q <= and_1972_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_522 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_528 : averager_running_1_q;
      averager_total_0_q <= select_2170;
      averager_total_1_q <= select_2172;
      census_columns_values_0_cell_0_left_q <= select_2196;
      census_columns_values_0_cell_0_right_q <= select_2197;
      census_columns_values_0_cell_0_mask_q <= and_544_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
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
      sharpness_last_mean_0_q <= and_544_s2_q ? select_550 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_544_s2_q ? select_554 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_s2_q;
      middle_sum_columns_values_1_q <= select_2567;
      middle_sum_columns_values_2_q <= select_2568;
      middle_sum_columns_values_3_q <= select_2569;
      middle_sum_columns_values_4_q <= select_2570;
      middle_sum_columns_values_5_q <= select_2571;
      middle_sum_columns_values_6_q <= select_2572;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_1006;
      sums_0_sum_sums_values_0_q <= sum_1256;
      sums_0_sum_sums_values_1_q <= equal_1254 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1504;
      sums_1_sum_sums_values_1_q <= equal_1254 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [5:0] select_510_s3_q;
  logic [5:0] last_s3_q;
  logic and_542_s3_q;
  logic and_544_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_547_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_564_s3_q;
  logic equal_569_s3_q;
  logic not_570_s3_q;
  logic less_647_s3_q;
  logic less_648_s3_q;
  logic less_649_s3_q;
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
  logic and_678_s3_q;
  logic and_703_s3_q;
  logic and_704_s3_q;
  logic [11:0] sum_719_s3_q;
  logic [9:0] sum_722_s3_q;
  logic and_730_s3_q;
  logic and_734_s3_q;
  logic less_735_s3_q;
  logic less_739_s3_q;
  logic less_741_s3_q;
  logic equal_1602_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1608_s3_q;
  logic equal_1610_s3_q;
  logic equal_1612_s3_q;
  logic equal_1614_s3_q;
  logic equal_1616_s3_q;
  logic equal_1618_s3_q;
  logic equal_1620_s3_q;
  logic equal_1622_s3_q;
  logic equal_1624_s3_q;
  logic less_1633_s3_q;
  logic or_1637_s3_q;
  logic equal_1657_s3_q;
  logic and_1667_s3_q;
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
  logic [3:0] select_1851_s3_q;
  logic less_1955_s3_q;
  logic equal_1956_s3_q;
  logic not_1957_s3_q;
  logic equal_1958_s3_q;
  logic and_1972_s3_q;
  logic select_1974_s3_q;
  logic and_1977_s3_q;
  logic or_1983_s3_q;
  logic or_1986_s3_q;
  logic or_1989_s3_q;
  logic not_1991_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2018_s3_q;
  logic and_2023_s3_q;
  logic and_2055_s3_q;
  logic less_2056_s3_q;
  logic [11:0] sum_2064_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2082_s3_q;
  logic or_2085_s3_q;
  logic or_2088_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2138_s3_q;
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
  logic parity_3224_s3_q;
  logic parity_3353_s3_q;
  logic parity_3415_s3_q;
  logic xor_3443_s3_q;
  logic parity_3455_s3_q;
  logic or_3459_s3_q;
  logic equal_3460_s3_q;
  logic [4:0] select_3579_s3_q;
  logic equal_3591_s3_q;
  logic less_3593_s3_q;
  logic less_3594_s3_q;
  logic or_3599_s3_q;
  logic [7:0] select_3644_s3_q;
  logic equal_3941_s3_q;
  logic and_4161_s3_q;
  logic equal_4234_s3_q;
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
      select_510_s3_q <= select_510_s2_q;
      last_s3_q <= last_s2_2_q;
      and_542_s3_q <= and_542_s2_q;
      and_544_s3_q <= and_544_s2_q;
      grey_s3_q <= grey;
      equal_547_s3_q <= equal_547;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_564_s3_q <= equal_564_s2_q;
      equal_569_s3_q <= equal_569_s2_q;
      not_570_s3_q <= not_570_s2_q;
      less_647_s3_q <= less_647;
      less_648_s3_q <= less_648;
      less_649_s3_q <= less_649;
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
      and_678_s3_q <= and_678;
      and_703_s3_q <= whole_22 & and_678;
      and_704_s3_q <= census_columns_values_1_cell_2_mask_q & and_678;
      sum_719_s3_q <= {1'b0, sum_715} + {2'h0, sum_718};
      sum_722_s3_q <= {9'h0, difference_720[9]} + {1'b0, xor_721};
      and_730_s3_q <= and_730;
      and_734_s3_q <= and_734;
      less_735_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_739_s3_q <= {{5{sum_738[6]}}, sum_738, half_grey_levels_2[3:0]} < 16'hffe1;
      less_741_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_1602_s3_q <= equal_1602;
      all_s3_q <= all;
      sum_1608_s3_q <= sum_1608;
      equal_1610_s3_q <= equal_1610;
      equal_1612_s3_q <= equal_1612;
      equal_1614_s3_q <= equal_1614;
      equal_1616_s3_q <= equal_1616;
      equal_1618_s3_q <= equal_1618;
      equal_1620_s3_q <= equal_1620;
      equal_1622_s3_q <= equal_1622;
      equal_1624_s3_q <= equal_1624;
      less_1633_s3_q <= less_1633;
      or_1637_s3_q <= or_1637;
      equal_1657_s3_q <= (registration_fresh_q & select_1655) == 4'h0;
      and_1667_s3_q <= not_570_s2_q & and_1651;
      and_1670_s3_q <= and_1670_s2_q;
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
      select_1851_s3_q <= select_1851_s2_q;
      less_1955_s3_q <= less_1955_s2_q;
      equal_1956_s3_q <= equal_1956_s2_q;
      not_1957_s3_q <= not_1957_s2_q;
      equal_1958_s3_q <= equal_1958_s2_q;
      and_1972_s3_q <= and_1972_s2_q;
      select_1974_s3_q <= select_1974_s2_q;
      and_1977_s3_q <= and_1977_s2_q;
      or_1983_s3_q <= or_1983;
      or_1986_s3_q <= or_1986;
      or_1989_s3_q <= or_1989;
      not_1991_s3_q <= not_1991;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2018_s3_q <= inside_v_s2_q & (and_2016 & and_1580);
      and_2023_s3_q <= not_570_s2_q & and_1998;
      and_2055_s3_q <= and_2055;
      less_2056_s3_q <= less_2056;
      sum_2064_s3_q <= sum_2064;
      textured_2_s3_q <= textured_2;
      or_2082_s3_q <= or_2082;
      or_2085_s3_q <= select_2079[7] | (~({select_2079[6], select_2079[3:2]} == 3'h0));
      or_2088_s3_q <= select_2079[7] | (~(select_2079[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2138_s3_q <= and_2138;
      sum_2267_s3_q <= {1'b0, sum_2263} + {2'h0, sum_2266};
      sum_2270_s3_q <= {9'h0, difference_2268[9]} + {1'b0, xor_2269};
      equal_2278_s3_q <= equal_2278_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2592_s3_q <= and_2592;
      and_2598_s3_q <= and_2598;
      explained_2_s3_q <= explained_2;
      and_2660_s3_q <= not_570_s2_q & and_2659;
      and_2694_s3_q <= not_570_s2_q & and_2693;
      and_2752_s3_q <= not_570_s2_q & (so_s2_q & (half_ends & equal_2749));
      and_2753_s3_q <= and_2753;
      residual_s3_q <= residual[7:0];
      and_2789_s3_q <= and_2789;
      and_2803_s3_q <= and_2753 & less_2802;
      equal_2846_s3_q <= (registration_fresh_q & select_2844) == 4'h0;
      parity_3224_s3_q <= ^{xor_3220, xor_3183, select_3150[44:36], other[44:36]};
      parity_3353_s3_q <= parity_3353;
      parity_3415_s3_q <= parity_3415;
      xor_3443_s3_q <= parity_3430 ^ parity_3442;
      parity_3455_s3_q <= ^{or_3452, or_3448, and_3444};
      or_3459_s3_q <= (or_3448 & or_3452) | (and_3444 & (or_3448 | or_3452));
      equal_3460_s3_q <= equal_3460_s2_q;
      select_3579_s3_q <= select_3579[14:10];
      equal_3591_s3_q <= select_3548[3:0] == 4'h0;
      less_3593_s3_q <= {difference_3592, 3'h0} < {3'h0, sum_3140};
      less_3594_s3_q <= select_3589 < select_3579[9:0];
      or_3599_s3_q <= (sum_3140 < 10'h39) | ({1'b0, sum_3140[9:1]} < select_3579[9:0]);
      select_3644_s3_q <= select_3644;
      equal_3941_s3_q <= equal_3941;
      and_4161_s3_q <= and_2138 & (sum_2064 == sum_2048);
      equal_4234_s3_q <= (registration_fresh_q & select_4232) == 4'h0;
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
  // hls/stages/census.hpp:272
  logic [11:0] texture;
  assign texture = sum_719_s3_q + {2'h0, sum_722_s3_q};
  // hls/stages/census.hpp:283
  logic [12:0] sum_724;
  assign sum_724 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_726;
  assign sum_726 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_724});
  // hls/stages/census.hpp:305
  logic less_727;
  assign less_727 = 9'h4 < sum_726[13:5];
  logic and_728;
  assign and_728 = and_678_s3_q & less_727;
  // hls/stages/moments.hpp:30
  logic and_740;
  assign and_740 = (and_703_s3_q & and_730_s3_q) & less_739_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_1659;
  assign equal_1659 = sum_1608_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1608_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1661;
  assign select_1661 = equal_1659 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1662;
  assign sum_1662 = (equal_1657_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1661[13]}}, select_1661};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1608_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1665;
  assign select_1665 = equal_1659 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1666;
  assign sum_1666 = (equal_1657_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1665[6]}}, select_1665};
  // hls/stages/patches.hpp:353
  logic [21:0] select_1790;
  assign select_1790 = and_1789_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1745_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1792;
  assign select_1792 = equal_1688_s3_q ? patches_place_0_valid_q : (select_1687_s3_q ? patches_place_0_valid_q : select_1790[0]);
  // hls/stages/patches.hpp:354
  logic [20:0] select_1793;
  assign select_1793 = select_1687_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1790[21:1];
  // hls/stages/patches.hpp:127
  logic [6:0] select_1794;
  assign select_1794 = equal_1688_s3_q ? patches_place_0_column_q : select_1793[6:0];
  logic [5:0] select_1795;
  assign select_1795 = equal_1688_s3_q ? patches_place_0_shift_q : select_1793[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1796;
  assign sum_1796 = select_1794 + {select_1795[5], select_1795};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1797;
  assign sum_1797 = sum_1796[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1798;
  assign equal_1798 = {sum_1797[5], select_510_s3_q, select_508_s3_q} == {1'b0, sum_1797[4:0], sum_1796[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1800;
  assign or_1800 = and_1670_s3_q | (select_1792 & equal_1798);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1801;
  assign select_1801 = or_1800 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1811;
  assign select_1811 = or_1800 ? {and_1670_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1813;
  assign and_1813 = select_1810_s3_q & (~select_1811[5]);
  // hls/stages/patches.hpp:127
  logic select_1821;
  assign select_1821 = equal_1688_s3_q ? patches_place_1_valid_q : (select_1687_s3_q ? select_1790[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:354
  logic [20:0] select_1822;
  assign select_1822 = select_1687_s3_q ? select_1790[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [6:0] select_1823;
  assign select_1823 = equal_1688_s3_q ? patches_place_1_column_q : select_1822[6:0];
  logic [5:0] select_1824;
  assign select_1824 = equal_1688_s3_q ? patches_place_1_shift_q : select_1822[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1825;
  assign sum_1825 = select_1823 + {select_1824[5], select_1824};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1826;
  assign sum_1826 = sum_1825[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1827;
  assign equal_1827 = {sum_1826[5], select_510_s3_q, select_508_s3_q} == {1'b0, sum_1826[4:0], sum_1825[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1829;
  assign or_1829 = and_1670_s3_q | (select_1821 & equal_1827);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1830;
  assign select_1830 = or_1829 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1831;
  assign select_1831 = or_1829 ? {and_1670_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1833;
  assign and_1833 = select_1810_s3_q & (~select_1831[5]);
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1840;
  assign sum_1840 = select_1794 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1841;
  assign equal_1841 = {sum_1840[6], select_510_s3_q, select_508_s3_q} == {1'b0, sum_1840[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_1843;
  assign or_1843 = and_1670_s3_q | (select_1792 & equal_1841);
  logic [4:0] select_1844;
  assign select_1844 = or_1843 ? {and_1670_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1845;
  assign sum_1845 = select_1823 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1846;
  assign equal_1846 = {sum_1845[6], select_510_s3_q, select_508_s3_q} == {1'b0, sum_1845[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_1849;
  assign select_1849 = (and_1670_s3_q | (select_1821 & equal_1846)) ? {and_1670_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_4;
  assign column_4 = select_1844[4] ? select_1849[3:0] : select_1844[3:0];
  // hls/stages/agreement.hpp:276
  logic select_1852;
  assign select_1852 = or_1843 ? and_1670_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_1858;
  assign and_1858 = (select_1810_s3_q & (select_1804_s3_q[3] ^ select_1804_s3_q[4])) & ((~select_1844[4]) | (~select_1849[4]));
  // hls/stages/patches.hpp:184
  logic less_1967;
  assign less_1967 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1968;
  assign not_1968 = ~less_1967;
  logic [1:0] select_1969;
  assign select_1969 = patches_summed_first_s3_q ? 2'h2 : {less_1967, not_1968};
  logic [12:0] select_1970;
  assign select_1970 = select_1969[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1978;
  assign select_1978 = select_1969[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1977_s3_q, 1'b0, select_1974_s3_q, left_pixel_q};
  logic [14:0] select_1979;
  assign select_1979 = select_1969[1] ? {select_1970[12:8], patches_sums_values_0_q[9:8], select_1970[7:0]} : select_1978;
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2004;
  assign select_2004 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_2005;
  assign sum_2005 = {5'h0, textured_s3_q} + select_2004;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_2007;
  assign sum_2007 = {4'h0, sum_2005} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2009;
  assign select_2009 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_2010;
  assign sum_2010 = {5'h0, explained_s3_q} + select_2009;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2012;
  assign sum_2012 = {4'h0, sum_2010} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_2019;
  assign select_2019 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:902
  logic [5:0] sum_2020;
  assign sum_2020 = {5'h0, and_2018_s3_q} + select_2019;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2022;
  assign sum_2022 = {4'h0, sum_2020} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2073;
  assign select_2073 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2074;
  assign difference_2074 = {1'b0, textured_2_s3_q} - {1'b0, select_2073};
  logic [4:0] t;
  assign t = {difference_2074[3], difference_2074} + (equal_564_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2077;
  assign equal_2077 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2089;
  assign not_2089 = ~region_row_s3_q[2];
  logic [2:0] select_2090;
  assign select_2090 = region_row_s3_q[1] ? {1'b0, not_2089, 1'b0} : {region_row_s3_q[2], 1'b0, not_2089};
  logic [5:0] select_2091;
  assign select_2091 = region_row_s3_q[0] ? {select_2090[2], 1'b0, select_2090[1], 1'b0, select_2090[0], 1'b0} : {1'b0, select_2090[2], 1'b0, select_2090[1], 1'b0, select_2090[0]};
  logic [11:0] select_2092;
  assign select_2092 = or_2088_s3_q ? {select_2091[5], 1'b0, select_2091[4], 1'b0, select_2091[3], 1'b0, select_2091[2], 1'b0, select_2091[1], 1'b0, select_2091[0], 1'b0} : {1'b0, select_2091[5], 1'b0, select_2091[4], 1'b0, select_2091[3], 1'b0, select_2091[2], 1'b0, select_2091[1], 1'b0, select_2091[0]};
  logic [23:0] select_2093;
  assign select_2093 = or_2085_s3_q ? {select_2092[11], 1'b0, select_2092[10], 1'b0, select_2092[9], 1'b0, select_2092[8], 1'b0, select_2092[7], 1'b0, select_2092[6], 1'b0, select_2092[5], 1'b0, select_2092[4], 1'b0, select_2092[3], 1'b0, select_2092[2], 1'b0, select_2092[1], 1'b0, select_2092[0], 1'b0} : {1'b0, select_2092[11], 1'b0, select_2092[10], 1'b0, select_2092[9], 1'b0, select_2092[8], 1'b0, select_2092[7], 1'b0, select_2092[6], 1'b0, select_2092[5], 1'b0, select_2092[4], 1'b0, select_2092[3], 1'b0, select_2092[2], 1'b0, select_2092[1], 1'b0, select_2092[0]};
  logic [47:0] select_2094;
  assign select_2094 = or_2082_s3_q ? {select_2093[23], 1'b0, select_2093[22], 1'b0, select_2093[21], 1'b0, select_2093[20], 1'b0, select_2093[19], 1'b0, select_2093[18], 1'b0, select_2093[17], 1'b0, select_2093[16], 1'b0, select_2093[15], 1'b0, select_2093[14], 1'b0, select_2093[13], 1'b0, select_2093[12], 1'b0, select_2093[11], 1'b0, select_2093[10], 1'b0, select_2093[9], 1'b0, select_2093[8], 1'b0, select_2093[7], 1'b0, select_2093[6], 1'b0, select_2093[5], 1'b0, select_2093[4], 1'b0, select_2093[3], 1'b0, select_2093[2], 1'b0, select_2093[1], 1'b0, select_2093[0], 1'b0} : {1'b0, select_2093[23], 1'b0, select_2093[22], 1'b0, select_2093[21], 1'b0, select_2093[20], 1'b0, select_2093[19], 1'b0, select_2093[18], 1'b0, select_2093[17], 1'b0, select_2093[16], 1'b0, select_2093[15], 1'b0, select_2093[14], 1'b0, select_2093[13], 1'b0, select_2093[12], 1'b0, select_2093[11], 1'b0, select_2093[10], 1'b0, select_2093[9], 1'b0, select_2093[8], 1'b0, select_2093[7], 1'b0, select_2093[6], 1'b0, select_2093[5], 1'b0, select_2093[4], 1'b0, select_2093[3], 1'b0, select_2093[2], 1'b0, select_2093[1], 1'b0, select_2093[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2098;
  assign and_2098 = good_known_q & (~((good_q & select_2094) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2107;
  assign select_2107 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2108;
  assign difference_2108 = {1'b0, shown_2_s3_q} - {1'b0, select_2107};
  logic [4:0] around;
  assign around = {difference_2108[3], difference_2108} + (equal_564_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2111;
  assign sum_2111 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2077 ? and_2098 : (~({sum_2111, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2123;
  assign select_2123 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2124;
  assign difference_2124 = {1'b0, near_2_s3_q} - {1'b0, select_2123};
  logic [4:0] n;
  assign n = {difference_2124[3], difference_2124} + (equal_564_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2128;
  assign and_2128 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2162;
  assign select_2162 = sample_pair_whole_s3_q ? (and_542_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2164;
  assign select_2164 = sample_pair_whole_s3_q ? (and_542_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2166;
  assign select_2166 = sample_pair_whole_s3_q ? (and_542_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2168;
  assign select_2168 = sample_pair_whole_s3_q ? (and_542_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2173;
  assign sum_2173 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2174;
  assign difference_2174 = {1'b0, sum_2173[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2175;
  assign xor_2175 = {difference_2174[8:0], sum_2173[0]} ^ {10{difference_2174[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2174[9]} + {1'b0, xor_2175};
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_547_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2180;
  assign select_2180 = sample_pair_whole_s3_q ? (and_542_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2181;
  assign sum_2181 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2182;
  assign difference_2182 = {1'b0, sum_2181[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2183;
  assign xor_2183 = {difference_2182[8:0], sum_2181[0]} ^ {10{difference_2182[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2182[9]} + {1'b0, xor_2183};
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_547_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2188;
  assign select_2188 = sample_pair_whole_s3_q ? (and_542_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:274
  logic [11:0] sum_2271;
  assign sum_2271 = sum_2267_s3_q + {2'h0, sum_2270_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2273;
  assign select_2273 = and_544_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2274;
  assign select_2274 = and_544_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2275;
  assign select_2275 = and_544_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2276;
  assign select_2276 = and_544_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:284
  logic [12:0] sum_2279;
  assign sum_2279 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2271};
  logic [13:0] sum_2281;
  assign sum_2281 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2279});
  // hls/stages/census.hpp:311
  logic and_2283;
  assign and_2283 = and_703_s3_q & (9'h4 < sum_2281[13:5]);
  // hls/stages/census.hpp:312
  logic and_2284;
  assign and_2284 = and_703_s3_q & less_727;
  // hls/stages/census.hpp:313
  logic [19:0] sum_2285;
  assign sum_2285 = census_left_misses_q + {{17{and_2284}}, and_2283, 1'b0, and_2283};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2287;
  assign select_2287 = and_544_s3_q ? (equal_2278_s3_q ? 20'h0 : sum_2285) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2357;
  assign select_2357 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2360;
  assign select_2360 = and_544_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:361
  logic and_2363;
  assign and_2363 = whole_2_s3_q & (~(last_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:457
  logic and_2369;
  assign and_2369 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2370;
  assign and_2370 = and_2363 & and_2369;
  // hls/stages/census.hpp:360
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2357[13:0]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2372;
  assign select_2372 = and_2370 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2374;
  assign select_2374 = equal_2278_s3_q ? {11'h0, select_2372} : (sharpness_sums_detail_0_q + {11'h0, select_2372});
  // hls/stages/agreement.hpp:457
  logic and_2381;
  assign and_2381 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2382;
  assign and_2382 = and_2363 & and_2381;
  // hls/stages/census.hpp:360
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2357[27:14]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2384;
  assign select_2384 = and_2382 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:363
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
  // hls/stages/census.hpp:376
  logic less_2397;
  assign less_2397 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:415
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
  // hls/stages/census.hpp:378
  logic and_2407;
  assign and_2407 = less_2398 & (~((sharpness_sums_contrast_1_q & select_2403) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2409;
  assign select_2409 = (less_2397 & and_2407) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2409};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2412;
  assign select_2412 = equal_2396 ? (less_2397 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:378
  logic and_2417;
  assign and_2417 = less_2398 & (~((sharpness_sums_contrast_0_q & select_2403) == 24'h0));
  // hls/stages/census.hpp:383
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
  // hls/stages/census.hpp:389
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2435;
  assign select_2435 = drew_q ? (equal_2396 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2439;
  assign select_2439 = drew_q ? (equal_2396 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:375
  logic equal_2440;
  assign equal_2440 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:391
  logic xor_2441;
  assign xor_2441 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2444;
  assign select_2444 = (equal_2440 | xor_2441) ? (five_times[0] & xor_2441) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2446;
  assign select_2446 = drew_q ? (equal_2396 ? select_2444 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:391
  logic xor_2447;
  assign xor_2447 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2450;
  assign select_2450 = (equal_2440 | xor_2447) ? (five_times_2[0] & xor_2447) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2452;
  assign select_2452 = drew_q ? (equal_2396 ? select_2450 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:392
  logic xor_2453;
  assign xor_2453 = sharpness_comparing_contrast_0_q[1] ^ and_2407;
  logic select_2456;
  assign select_2456 = (equal_2440 | xor_2453) ? (and_2407 & xor_2453) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2458;
  assign select_2458 = drew_q ? (equal_2396 ? select_2456 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:392
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
  assign and_2603 = not_570_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2608;
  assign and_2608 = not_570_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2613;
  assign and_2613 = not_570_s3_q & (drew_q & (ends_cell_s3_q & and_2018_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_2617;
  assign not_2617 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2626;
  assign select_2626 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2627;
  assign difference_2627 = {1'b0, explained_2_s3_q} - {1'b0, select_2626};
  logic [4:0] e;
  assign e = {difference_2627[3], difference_2627} + (equal_564_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2630;
  assign sum_2630 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_2634;
  assign not_2634 = ~(equal_2077 ? and_2098 : (~({sum_2630, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_2637;
  assign and_2637 = ends_cell_s3_q & (not_2617 & (centres_values_1_textured_s3_q & not_2634));
  logic and_2639;
  assign and_2639 = not_570_s3_q & (drew_q & and_2637);
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
  assign select_2652 = x_s3_q[6] ? (equal_1602_s3_q ? 10'h0 : (and_2649 ? select_2643 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2653;
  assign select_2653 = equal_569_s3_q ? select_2652 : 10'h0;
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
  assign and_2667 = not_570_s3_q & (drew_q & (ends_cell_s3_q & and_2664));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2669;
  assign select_2669 = and_2592_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2667});
  // hls/stages/agreement.hpp:1110
  logic and_2671;
  assign and_2671 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2634);
  // hls/stages/agreement.hpp:788
  logic and_2675;
  assign and_2675 = not_570_s3_q & (drew_q & (ends_cell_s3_q & (not_2617 & and_2671)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2677;
  assign select_2677 = and_2592_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2675});
  logic [13:0] select_2696;
  assign select_2696 = and_2592_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2694_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2771;
  assign select_2771 = drew_q ? (equal_1698_s3_q ? (and_2753_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2772;
  assign select_2772 = equal_569_s3_q ? 8'h0 : select_2771;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2774;
  assign select_2774 = and_2752_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2772[7]}}, select_2772});
  // hls/stages/agreement.hpp:788
  logic and_2777;
  assign and_2777 = not_570_s3_q & (drew_q & (and_2753_s3_q & equal_1698_s3_q));
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
  assign select_2784 = equal_569_s3_q ? 2'h0 : select_2783;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2785;
  assign sum_2785 = registration_half_votes_down_q + {{5{select_2784[1]}}, select_2784};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2791;
  assign select_2791 = drew_q ? (equal_1698_s3_q ? {and_2789_s3_q, and_2753_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2792;
  assign select_2792 = equal_569_s3_q ? 2'h0 : select_2791;
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
  assign select_2799 = equal_569_s3_q ? 2'h0 : select_2798;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2800;
  assign sum_2800 = registration_half_half_votes_down_q + {{5{select_2799[1]}}, select_2799};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2805;
  assign select_2805 = drew_q ? (equal_1698_s3_q ? {and_2803_s3_q, and_2753_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2806;
  assign select_2806 = equal_569_s3_q ? 2'h0 : select_2805;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2807;
  assign sum_2807 = registration_half_half_votes_up_q + {{5{select_2806[1]}}, select_2806};
  // hls/stages/agreement.hpp:788
  logic and_2841;
  assign and_2841 = equal_569_s3_q & (x_s3_q[6] & (not_1991_s3_q & less_1633_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2848;
  assign select_2848 = or_1637_s3_q ? 12'h0 : (equal_2846_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2851;
  assign select_2851 = x_s3_q[6] ? (equal_1602_s3_q ? 12'h0 : (less_1633_s3_q ? select_2848 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2852;
  assign select_2852 = equal_569_s3_q ? select_2851 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2853;
  assign and_2853 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2856;
  assign and_2856 = not_1991_s3_q & (less_1633_s3_q & ({and_2853, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_2858;
  assign and_2858 = equal_569_s3_q & (x_s3_q[6] & and_2856);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2860;
  assign sum_2860 = {{2{select_2852[11]}}, select_2852} + (and_2858 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2863;
  assign select_2863 = or_1637_s3_q ? 12'h0 : (equal_2846_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2866;
  assign select_2866 = x_s3_q[6] ? (equal_1602_s3_q ? 12'h0 : (less_1633_s3_q ? select_2863 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2867;
  assign select_2867 = equal_569_s3_q ? select_2866 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2869;
  assign sum_2869 = {{2{select_2867[11]}}, select_2867} + (and_2858 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2871;
  assign not_2871 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2874;
  assign and_2874 = not_1991_s3_q & (less_1633_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2871, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2880;
  assign and_2880 = equal_569_s3_q & (x_s3_q[6] & (not_1991_s3_q & (less_1633_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2881;
  assign not_2881 = ~and_2880;
  logic less_2882;
  assign less_2882 = $signed({9'h1, {2{not_2881}}, and_2880}) < $signed(registration_up_q[13:2]);
  logic select_2883;
  assign select_2883 = (equal_569_s3_q & (x_s3_q[6] & and_2874)) ? less_2882 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2887;
  assign and_2887 = x_s3_q[6] & (not_1991_s3_q & (less_1633_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2888;
  assign and_2888 = equal_569_s3_q & and_2887;
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
  assign and_2897 = equal_569_s3_q & (x_s3_q[6] & (not_1991_s3_q & (less_1633_s3_q & equal_2893)));
  // hls/stages/agreement.hpp:1142
  logic and_2904;
  assign and_2904 = x_s3_q[6] & (not_1991_s3_q & (less_1633_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2907;
  assign equal_2907 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2910;
  assign and_2910 = not_1991_s3_q & (less_1633_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2907));
  // hls/stages/registration.hpp:244
  logic and_2914;
  assign and_2914 = (equal_569_s3_q & (x_s3_q[6] & and_2910)) & (less_2891 | less_2889);
  // hls/stages/agreement.hpp:1142
  logic and_2919;
  assign and_2919 = not_1991_s3_q & (less_1633_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2907)));
  // hls/stages/registration.hpp:244
  logic and_2922;
  assign and_2922 = registration_votes_up_q & registration_other_down_q;
  logic select_2924;
  assign select_2924 = registration_votes_down_q ? (registration_other_up_q | and_2922) : and_2922;
  // hls/stages/registration.hpp:138
  logic and_2926;
  assign and_2926 = (equal_569_s3_q & (x_s3_q[6] & and_2919)) & (registration_other_enough_q & select_2924);
  // hls/stages/registration.hpp:245
  logic or_2929;
  assign or_2929 = registration_moved_q | (registration_enough_q & (and_2914 | and_2926));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3013;
  assign select_3013 = sample_pair_whole_s3_q ? (equal_1688_s3_q ? patches_place_0_slope_q : select_1793[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_3018;
  assign select_3018 = sample_pair_whole_s3_q ? (equal_1688_s3_q ? patches_place_1_slope_q : select_1822[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3020;
  assign select_3020 = equal_1688_s3_q ? patches_valid_0_q : (select_1687_s3_q ? patches_valid_0_q : select_1790[0]);
  // hls/stages/agreement.hpp:276
  logic select_3023;
  assign select_3023 = sample_pair_whole_s3_q ? (and_1813 ? (sample_present_s3_q & select_3020) : select_3020) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3025;
  assign select_3025 = equal_1688_s3_q ? patches_valid_1_q : (select_1687_s3_q ? select_1790[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3028;
  assign select_3028 = sample_pair_whole_s3_q ? (and_1833 ? (sample_present_s3_q & select_3025) : select_3025) : patches_valid_1_q;
  logic [5:0] select_3031;
  assign select_3031 = sample_pair_whole_s3_q ? (select_1811[5] ? {1'b1, select_1811[4:0]} : (select_1811 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3034;
  assign select_3034 = sample_pair_whole_s3_q ? (select_1831[5] ? {1'b1, select_1831[4:0]} : (select_1831 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3037;
  assign select_3037 = sample_pair_whole_s3_q ? (select_1844[4] ? {1'b1, select_1844[3:0]} : (select_1844 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3040;
  assign select_3040 = sample_pair_whole_s3_q ? (select_1849[4] ? {1'b1, select_1849[3:0]} : (select_1849 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:525
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3459_s3_q, parity_3455_s3_q, xor_3443_s3_q, parity_3415_s3_q, parity_3353_s3_q, parity_3224_s3_q} + (equal_3460_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3464;
  assign select_3464 = equal_1774_s3_q ? patches_sums_values_0_q : (equal_1776_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3465;
  assign select_3465 = equal_1776_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3467;
  assign select_3467 = equal_1776_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3469;
  assign select_3469 = equal_1776_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3471;
  assign select_3471 = equal_1776_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3473;
  assign select_3473 = equal_1776_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3475;
  assign select_3475 = equal_1776_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3477;
  assign select_3477 = equal_1776_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3479;
  assign select_3479 = equal_1776_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3481;
  assign select_3481 = equal_1776_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3483;
  assign select_3483 = equal_1776_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3485;
  assign select_3485 = equal_1776_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3487;
  assign select_3487 = equal_1776_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3489;
  assign select_3489 = equal_1776_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3491;
  assign select_3491 = equal_1776_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3493;
  assign select_3493 = equal_1776_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3495;
  assign select_3495 = equal_1776_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:599
  logic or_3600;
  assign or_3600 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_3599_s3_q;
  logic or_3603;
  assign or_3603 = equal_3591_s3_q | (less_3593_s3_q | (less_3594_s3_q | or_3600));
  // hls/stages/patches.hpp:579
  logic not_3604;
  assign not_3604 = ~or_3603;
  // hls/stages/patches.hpp:560
  logic and_3605;
  assign and_3605 = equal_1958_s3_q & not_3604;
  // hls/stages/patches.hpp:184
  logic and_3608;
  assign and_3608 = equal_1774_s3_q & (less_1955_s3_q ? (not_1957_s3_q & and_3605) : and_3605);
  // hls/stages/patches.hpp:657
  logic not_3609;
  assign not_3609 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:560
  logic and_3611;
  assign and_3611 = equal_1958_s3_q & (patches_second_s3_q & not_3604);
  // hls/stages/patches.hpp:184
  logic and_3614;
  assign and_3614 = equal_1774_s3_q & (less_1955_s3_q ? (not_1957_s3_q & and_3611) : and_3611);
  // hls/stages/patches.hpp:657
  logic not_3615;
  assign not_3615 = ~and_3614;
  // hls/stages/patches.hpp:188
  logic and_3617;
  assign and_3617 = and_3608 & (not_3609 & not_3615);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3619;
  assign sum_3619 = {7'h0, and_3617} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:597
  logic [7:0] select_3645;
  assign select_3645 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:596
  logic [5:0] select_3646;
  assign select_3646 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3647;
  assign sum_3647 = {2'h0, select_3579_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_3648;
  assign sum_3648 = {select_3646[5], select_3646} + {{3{sum_3647[3]}}, sum_3647};
  // hls/stages/patches.hpp:597
  logic [17:0] product_3649;
  assign product_3649 = $signed({{10{select_3645[7]}}, select_3645}) * $signed({{8{sum_3648[6]}}, sum_3648, select_3579_s3_q[2:0]});
  // hls/stages/patches.hpp:598
  logic [13:0] difference_3650;
  assign difference_3650 = {{6{select_3644_s3_q[7]}}, select_3644_s3_q} - {product_3649[17], product_3649[17:5]};
  // hls/stages/patches.hpp:604
  logic less_3651;
  assign less_3651 = $signed({{7{difference_3621[6]}}, difference_3621}) < $signed(difference_3650);
  // hls/stages/patches.hpp:560
  logic and_3654;
  assign and_3654 = equal_1958_s3_q & (not_3604 & (~less_3651));
  // hls/stages/patches.hpp:184
  logic and_3657;
  assign and_3657 = equal_1774_s3_q & (less_1955_s3_q ? (not_1957_s3_q & and_3654) : and_3654);
  // hls/stages/patches.hpp:660
  logic and_3658;
  assign and_3658 = and_3657 & and_3617;
  logic [7:0] sum_3659;
  assign sum_3659 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3658};
  // hls/stages/patches.hpp:560
  logic and_3663;
  assign and_3663 = not_3604 & (~($signed(difference_3650) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3664;
  assign and_3664 = equal_1958_s3_q & and_3663;
  // hls/stages/patches.hpp:184
  logic and_3667;
  assign and_3667 = equal_1774_s3_q & (less_1955_s3_q ? (not_1957_s3_q & and_3664) : and_3664);
  // hls/stages/patches.hpp:661
  logic and_3668;
  assign and_3668 = and_3667 & and_3617;
  logic [7:0] sum_3669;
  assign sum_3669 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3668};
  // hls/stages/patches.hpp:188
  logic and_3671;
  assign and_3671 = and_3608 & (and_3614 & not_3609);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3673;
  assign sum_3673 = {7'h0, and_3671} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:660
  logic and_3675;
  assign and_3675 = and_3657 & and_3671;
  logic [7:0] sum_3676;
  assign sum_3676 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3675};
  // hls/stages/patches.hpp:661
  logic and_3678;
  assign and_3678 = and_3667 & and_3671;
  logic [7:0] sum_3679;
  assign sum_3679 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3678};
  // hls/stages/patches.hpp:188
  logic and_3681;
  assign and_3681 = and_3608 & (patches_lower_s3_q & not_3615);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3683;
  assign sum_3683 = {7'h0, and_3681} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:660
  logic and_3685;
  assign and_3685 = and_3657 & and_3681;
  logic [7:0] sum_3686;
  assign sum_3686 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3685};
  // hls/stages/patches.hpp:661
  logic and_3688;
  assign and_3688 = and_3667 & and_3681;
  logic [7:0] sum_3689;
  assign sum_3689 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3688};
  // hls/stages/patches.hpp:188
  logic and_3691;
  assign and_3691 = and_3608 & (patches_lower_s3_q & and_3614);
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3693;
  assign sum_3693 = {7'h0, and_3691} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:660
  logic and_3695;
  assign and_3695 = and_3657 & and_3691;
  logic [7:0] sum_3696;
  assign sum_3696 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3695};
  // hls/stages/patches.hpp:661
  logic and_3698;
  assign and_3698 = and_3667 & and_3691;
  logic [7:0] sum_3699;
  assign sum_3699 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3698};
  // hls/stages/agreement.hpp:1223
  logic equal_3700;
  assign equal_3700 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_3701;
  assign less_3701 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3705;
  assign and_3705 = equal_569_s3_q & (x_s3_q[6] & (not_1991_s3_q & (equal_3700 & less_3701)));
  // hls/stages/agreement.hpp:1142
  logic and_3710;
  assign and_3710 = x_s3_q[6] & (not_1991_s3_q & (less_3701 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_3711;
  assign and_3711 = equal_569_s3_q & and_3710;
  // hls/stages/patches.hpp:623
  logic [7:0] or_3713;
  assign or_3713 = (and_3705 ? patches_quarters_0_places_q : 8'h0) | (and_3711 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_3717;
  assign and_3717 = x_s3_q[6] & (not_1991_s3_q & (less_3701 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_3718;
  assign and_3718 = equal_569_s3_q & and_3717;
  // hls/stages/agreement.hpp:1142
  logic and_3724;
  assign and_3724 = x_s3_q[6] & (not_1991_s3_q & (less_3701 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_3725;
  assign and_3725 = equal_569_s3_q & and_3724;
  // hls/stages/patches.hpp:623
  logic [7:0] or_3727;
  assign or_3727 = (or_3713 | (and_3718 ? patches_quarters_2_places_q : 8'h0)) | (and_3725 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_3731;
  assign select_3731 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_3735;
  assign and_3735 = equal_569_s3_q & (x_s3_q[6] & (not_1991_s3_q & (less_3701 & select_3731)));
  // hls/stages/patches.hpp:624
  logic [7:0] select_3737;
  assign select_3737 = and_3705 ? (and_3735 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3739;
  assign select_3739 = and_3711 ? (and_3735 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3742;
  assign select_3742 = and_3718 ? (and_3735 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3745;
  assign select_3745 = and_3725 ? (and_3735 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:625
  logic [7:0] select_3748;
  assign select_3748 = and_3705 ? (and_3735 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3750;
  assign select_3750 = and_3711 ? (and_3735 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3753;
  assign select_3753 = and_3718 ? (and_3735 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3756;
  assign select_3756 = and_3725 ? (and_3735 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3758;
  assign sum_3758 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_3762;
  assign and_3762 = x_s3_q[6] & (not_1991_s3_q & (less_3701 & (sum_3758[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3763;
  assign and_3763 = equal_569_s3_q & and_3762;
  // hls/stages/patches.hpp:620
  logic [7:0] select_3766;
  assign select_3766 = and_3763 ? (patches_word_places_q + (and_3711 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3769;
  assign select_3769 = and_3763 ? (patches_word_up_q + (and_3711 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3772;
  assign select_3772 = and_3763 ? (patches_word_down_q + (and_3711 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:606
  logic [5:0] select_3776;
  assign select_3776 = ($signed(difference_3650[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3650[5:0];
  logic [5:0] select_3777;
  assign select_3777 = ($signed(14'h10) < $signed(difference_3650)) ? 6'h10 : select_3776;
  // hls/stages/patches.hpp:560
  logic [5:0] select_3779;
  assign select_3779 = equal_1958_s3_q ? (or_3603 ? 6'h0 : select_3777) : 6'h0;
  logic [5:0] select_3781;
  assign select_3781 = less_1955_s3_q ? (equal_1956_s3_q ? 6'h0 : select_3779) : select_3779;
  // hls/stages/patches.hpp:663
  logic [5:0] select_3783;
  assign select_3783 = and_3608 ? (equal_1774_s3_q ? select_3781 : 6'h0) : 6'h0;
  logic [11:0] sum_3784;
  assign sum_3784 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3783[5]}}, select_3783};
  // hls/stages/agreement.hpp:788
  logic and_3788;
  assign and_3788 = equal_569_s3_q & (x_s3_q[6] & (not_1991_s3_q & (equal_2893 & less_3701)));
  // hls/stages/agreement.hpp:1142
  logic and_3792;
  assign and_3792 = x_s3_q[6] & (not_1991_s3_q & (less_3701 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3793;
  assign and_3793 = equal_569_s3_q & and_3792;
  // hls/stages/patches.hpp:647
  logic [7:0] select_3795;
  assign select_3795 = and_3788 ? (and_3793 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:649
  logic or_3799;
  assign or_3799 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:650
  logic or_3802;
  assign or_3802 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:651
  logic [8:0] sum_3803;
  assign sum_3803 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:646
  logic select_3805;
  assign select_3805 = and_3788 ? (and_3793 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3808;
  assign and_3808 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:646
  logic [2:0] select_3810;
  assign select_3810 = and_3793 ? {and_3808, patches_found_q[2:1]} : (and_3788 ? {and_3808, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:645
  logic or_3814;
  assign or_3814 = patches_partly_q | (patches_doubted_q & (~and_3793));
  // hls/stages/patches.hpp:646
  logic select_3817;
  assign select_3817 = and_3788 ? (and_3793 ? or_3814 : (and_3788 ? or_3814 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:644
  logic select_3818;
  assign select_3818 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:633
  logic [7:0] select_3822;
  assign select_3822 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:605
  logic [10:0] sum_3824;
  assign sum_3824 = {sum_3648[6], sum_3648, select_3579_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:560
  logic and_3827;
  assign and_3827 = equal_1958_s3_q & (not_3604 & ({{5{sum_3824[10]}}, sum_3824} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_3830;
  assign and_3830 = equal_1774_s3_q & (less_1955_s3_q ? (not_1957_s3_q & and_3827) : and_3827);
  // hls/stages/patches.hpp:188
  logic and_3831;
  assign and_3831 = and_3608 & and_3830;
  // hls/stages/patches.hpp:664
  logic [7:0] sum_3832;
  assign sum_3832 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3831};
  // hls/stages/patches.hpp:653
  logic [12:0] product_3837;
  assign product_3837 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_3795};
  // hls/stages/patches.hpp:188
  logic and_3839;
  assign and_3839 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_3837[12:5] < patches_on_skin_q);
  logic select_3844;
  assign select_3844 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:634
  logic or_3848;
  assign or_3848 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:635
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:636
  logic select_3855;
  assign select_3855 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:637
  logic and_3861;
  assign and_3861 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3862;
  assign sum_3862 = patches_age_q + {9'h0, and_3861};
  logic [9:0] select_3865;
  assign select_3865 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3862)) : sum_3862;
  // hls/stages/agreement.hpp:1188
  logic or_3922;
  assign or_3922 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1217
  logic equal_3924;
  assign equal_3924 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1226
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1227
  logic select_3930;
  assign select_3930 = (equal_3924 & equal_3700) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3933;
  assign sum_3933 = {1'b0, select_2646} + {2'h0, select_2646[9:1]};
  logic select_3936;
  assign select_3936 = (select_2643[9:3] == 7'h0) ? ((~or_3922) & (~select_3930)) : (~({sum_3933, select_2646[0]} < {2'h0, select_2643}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3938;
  assign select_3938 = x_s3_q[6] ? (equal_1602_s3_q ? good_q : {select_3936, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_3943;
  assign select_3943 = equal_569_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3941_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1217
  logic equal_3944;
  assign equal_3944 = x_s3_q[6:3] == 4'ha;
  logic equal_3946;
  assign equal_3946 = x_s3_q[6:3] == 4'hc;
  logic equal_3947;
  assign equal_3947 = x_s3_q[6:3] == 4'hb;
  logic equal_3948;
  assign equal_3948 = x_s3_q[6:3] == 4'h9;
  logic equal_3949;
  assign equal_3949 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3951;
  assign select_3951 = equal_3948 ? counts_skin_unproven_q : (equal_3949 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3953;
  assign select_3953 = equal_3947 ? counts_regions_bad_q : (equal_3944 ? counts_nearer_q : select_3951);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3946 ? counts_on_skin_q : select_3953;
  // hls/stages/agreement.hpp:1222
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1230
  logic select_3956;
  assign select_3956 = (equal_3944 & equal_3700) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1148
  logic not_3957;
  assign not_3957 = ~hidden_for_q[7];
  logic [7:0] select_3959;
  assign select_3959 = select_3956 ? (hidden_for_q + {7'h0, not_3957}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3961;
  assign select_3961 = equal_569_s3_q ? (equal_3941_s3_q ? select_3959 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3962;
  assign select_3962 = equal_3700 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3964;
  assign select_3964 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3966;
  assign select_3966 = equal_3949 ? cfg_unproven_skin_limit_i : (equal_3924 ? cfg_unproven_limit_i : select_3964);
  logic [7:0] select_3968;
  assign select_3968 = equal_3944 ? cfg_regions_limit_i : (equal_3948 ? cfg_hidden_limit_i : select_3966);
  logic [7:0] limit;
  assign limit = equal_3946 ? cfg_regions_limit_i : (equal_3947 ? {cfg_on_skin_limit_i, 3'h0} : select_3968);
  // hls/stages/agreement.hpp:1231
  logic not_3971;
  assign not_3971 = ~x_s3_q[2];
  logic [3:0] select_3972;
  assign select_3972 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3971, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3971};
  logic [7:0] select_3973;
  assign select_3973 = x_s3_q[0] ? {select_3972[3], 1'b0, select_3972[2], 1'b0, select_3972[1], 1'b0, select_3972[0], 1'b0} : {1'b0, select_3972[3], 1'b0, select_3972[2], 1'b0, select_3972[1], 1'b0, select_3972[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3977;
  assign select_3977 = equal_3948 ? counts_skin_supervised_q : (equal_3949 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3979;
  assign select_3979 = equal_3947 ? counts_skin_textured_q : (equal_3944 ? counts_textured_q : select_3977);
  logic [13:0] of;
  assign of = equal_3946 ? counts_textured_q : select_3979;
  // hls/stages/agreement.hpp:1231
  logic [13:0] select_3981;
  assign select_3981 = ((limit & select_3973) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3962} + {1'b0, select_3981};
  // hls/stages/agreement.hpp:788
  logic select_3986;
  assign select_3986 = equal_569_s3_q ? (equal_3700 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1228
  logic and_3991;
  assign and_3991 = too_much_q & (~(equal_3949 & equal_3700));
  // hls/stages/agreement.hpp:1229
  logic select_3996;
  assign select_3996 = (over[14] & equal_3700) ? (and_3991 | ((equal_3949 | equal_3948) | (x_s3_q[6:3] == 4'hf))) : and_3991;
  // hls/stages/agreement.hpp:1125
  logic and_4001;
  assign and_4001 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1231
  logic select_4002;
  assign select_4002 = (equal_3946 & equal_3700) ? and_4001 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_4004;
  assign select_4004 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4006;
  assign select_4006 = equal_569_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4004 : box_textured_columns_values_0_q);
  logic [2:0] select_4007;
  assign select_4007 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4009;
  assign select_4009 = equal_569_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4007 : box_textured_columns_values_1_q);
  logic [2:0] select_4010;
  assign select_4010 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4012;
  assign select_4012 = equal_569_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4010 : box_textured_columns_values_2_q);
  logic [2:0] select_4013;
  assign select_4013 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4015;
  assign select_4015 = equal_569_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4013 : box_textured_columns_values_3_q);
  logic [2:0] select_4016;
  assign select_4016 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4018;
  assign select_4018 = equal_569_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4016 : box_textured_columns_values_4_q);
  logic [4:0] select_4020;
  assign select_4020 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4022;
  assign select_4022 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4024;
  assign select_4024 = equal_569_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4022 : box_explained_columns_values_0_q);
  logic [2:0] select_4025;
  assign select_4025 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4027;
  assign select_4027 = equal_569_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4025 : box_explained_columns_values_1_q);
  logic [2:0] select_4028;
  assign select_4028 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4030;
  assign select_4030 = equal_569_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4028 : box_explained_columns_values_2_q);
  logic [2:0] select_4031;
  assign select_4031 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4033;
  assign select_4033 = equal_569_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4031 : box_explained_columns_values_3_q);
  logic [2:0] select_4034;
  assign select_4034 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4036;
  assign select_4036 = equal_569_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4034 : box_explained_columns_values_4_q);
  logic [4:0] select_4038;
  assign select_4038 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4041;
  assign select_4041 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4043;
  assign select_4043 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4045;
  assign select_4045 = equal_569_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4043 : box_shown_columns_values_1_q);
  logic [2:0] select_4046;
  assign select_4046 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4048;
  assign select_4048 = equal_569_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4046 : box_shown_columns_values_2_q);
  logic [2:0] select_4049;
  assign select_4049 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4051;
  assign select_4051 = equal_569_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4049 : box_shown_columns_values_3_q);
  logic [2:0] select_4052;
  assign select_4052 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4054;
  assign select_4054 = equal_569_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4052 : box_shown_columns_values_4_q);
  logic [4:0] select_4056;
  assign select_4056 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4059;
  assign select_4059 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4061;
  assign select_4061 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4063;
  assign select_4063 = equal_569_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4061 : box_nearer_columns_values_1_q);
  logic [2:0] select_4064;
  assign select_4064 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4066;
  assign select_4066 = equal_569_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4064 : box_nearer_columns_values_2_q);
  logic [2:0] select_4067;
  assign select_4067 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4069;
  assign select_4069 = equal_569_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4067 : box_nearer_columns_values_3_q);
  logic [2:0] select_4070;
  assign select_4070 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4072;
  assign select_4072 = equal_569_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4070 : box_nearer_columns_values_4_q);
  logic [4:0] select_4074;
  assign select_4074 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1275
  logic select_4109;
  assign select_4109 = left_first_s3_q ? done_s3_q : proven_q;
  // hls/stages/agreement.hpp:278
  logic select_4111;
  assign select_4111 = left_first_s3_q ? done_s3_q : (and_1972_s3_q ? select_4109 : proven_q);
  // hls/stages/agreement.hpp:1308
  logic [1:0] select_4162;
  assign select_4162 = and_4161_s3_q ? {and_2128, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1309
  logic and_4163;
  assign and_4163 = select_4109 & less_4139;
  // hls/stages/agreement.hpp:438
  logic select_4166;
  assign select_4166 = and_2055_s3_q ? (less_2056_s3_q ? (select_4162[0] & and_4163) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:278
  logic select_4168;
  assign select_4168 = left_first_s3_q ? select_4166 : (and_1972_s3_q ? select_4166 : seen_q);
  logic select_4169;
  assign select_4169 = and_1972_s3_q ? select_4168 : seen_q;
  // hls/stages/agreement.hpp:438
  logic select_4172;
  assign select_4172 = and_2055_s3_q ? (less_2056_s3_q ? (select_4162[1] & and_4163) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:278
  logic select_4174;
  assign select_4174 = left_first_s3_q ? select_4172 : (and_1972_s3_q ? select_4172 : nearer_q);
  logic select_4175;
  assign select_4175 = and_1972_s3_q ? select_4174 : nearer_q;
  // hls/stages/agreement.hpp:1239
  logic or_4182;
  assign or_4182 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1241
  logic not_4190;
  assign not_4190 = ~(or_3922 | not_2348);
  // hls/stages/agreement.hpp:788
  logic and_4194;
  assign and_4194 = equal_569_s3_q & (equal_3941_s3_q & (not_4190 & (select_3930 | select_3996)));
  logic and_4197;
  assign and_4197 = equal_3941_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1150
  logic or_4201;
  assign or_4201 = select_2446 | (select_2458 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4208;
  assign and_4208 = equal_569_s3_q & (equal_3941_s3_q & (not_4190 & (select_2452 | select_2464)));
  // hls/stages/agreement.hpp:1150
  logic and_4213;
  assign and_4213 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3959 < cfg_hidden_frames_i));
  logic select_4219;
  assign select_4219 = (not_2348 | (select_4002 & not_3834)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4224;
  assign and_4224 = equal_569_s3_q & (equal_3941_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4228;
  assign and_4228 = equal_569_s3_q & (x_s3_q[6] & (not_1991_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4236;
  assign select_4236 = equal_1624_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4234_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4237;
  assign select_4237 = equal_1622_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4236;
  logic [31:0] select_4238;
  assign select_4238 = equal_1620_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4237;
  logic [31:0] select_4239;
  assign select_4239 = equal_1618_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4238;
  logic [31:0] select_4240;
  assign select_4240 = equal_1616_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4239;
  logic [31:0] select_4241;
  assign select_4241 = equal_1614_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4240;
  logic [31:0] select_4242;
  assign select_4242 = equal_1612_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4241;
  logic [31:0] select_4243;
  assign select_4243 = equal_1610_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4242;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4244;
  assign select_4244 = less_2642 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4245;
  assign select_4245 = equal_1602_s3_q ? select_4243 : {2'h0, select_4244, select_2646, select_2643};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_544_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_741_s3_q, and_740, less_735_s3_q, and_734_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_728, and_704_s3_q, and_703_s3_q, and_678_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q, less_650_s3_q, less_649_s3_q, less_648_s3_q, less_647_s3_q};
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
  assign registration_sums_waddr = {sum_1608_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1667_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1666, sum_1662};
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
  assign patches_right_1_waddr = {select_1804_s3_q, select_1830};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1833);
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
  assign patches_left_waddr = {select_1852, select_1851_s3_q, column_4};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1858);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1979;
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
  assign regions_waddr = {region_row_s3_q, or_1989_s3_q, or_1986_s3_q, or_1983_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2023_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2022, sum_2012, sum_2007};
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
  assign map_waddr = sum_2064_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2138_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2128, is_seen};
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
      census_left_misses_q <= select_2287;
      sharpness_before_last_mask_q <= select_2360;
      sharpness_sums_detail_0_q <= and_544_s3_q ? select_2374 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_544_s3_q ? select_2386 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_544_s3_q ? sum_2390 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_544_s3_q ? sum_2394 : sharpness_sums_contrast_1_q;
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
      registration_moved_q <= (~(equal_569_s3_q & and_2904)) & or_2929;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1792 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1794 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1795 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3013;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1821 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1823 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1824 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3018;
      patches_valid_0_q <= select_3023;
      patches_valid_1_q <= select_3028;
      patches_right_next_0_q <= select_3031;
      patches_right_next_1_q <= select_3034;
      patches_left_next_0_q <= select_3037;
      patches_left_next_1_q <= select_3040;
      patches_sums_values_0_q <= select_3464;
      patches_sums_values_1_q <= equal_1774_s3_q ? patches_sums_values_1_q : select_3465;
      patches_sums_values_2_q <= equal_1774_s3_q ? patches_sums_values_2_q : select_3467;
      patches_sums_values_3_q <= equal_1774_s3_q ? patches_sums_values_3_q : select_3469;
      patches_sums_values_4_q <= equal_1774_s3_q ? patches_sums_values_4_q : select_3471;
      patches_sums_values_5_q <= equal_1774_s3_q ? patches_sums_values_5_q : select_3473;
      patches_sums_values_6_q <= equal_1774_s3_q ? patches_sums_values_6_q : select_3475;
      patches_sums_values_7_q <= equal_1774_s3_q ? patches_sums_values_7_q : select_3477;
      patches_sums_values_8_q <= equal_1774_s3_q ? patches_sums_values_8_q : select_3479;
      patches_sums_values_9_q <= equal_1774_s3_q ? patches_sums_values_9_q : select_3481;
      patches_sums_values_10_q <= equal_1774_s3_q ? patches_sums_values_10_q : select_3483;
      patches_sums_values_11_q <= equal_1774_s3_q ? patches_sums_values_11_q : select_3485;
      patches_sums_values_12_q <= equal_1774_s3_q ? patches_sums_values_12_q : select_3487;
      patches_sums_values_13_q <= equal_1774_s3_q ? patches_sums_values_13_q : select_3489;
      patches_sums_values_14_q <= equal_1774_s3_q ? patches_sums_values_14_q : select_3491;
      patches_sums_values_15_q <= equal_1774_s3_q ? patches_sums_values_15_q : select_3493;
      patches_sums_values_16_q <= equal_1774_s3_q ? patches_sums_values_16_q : select_3495;
      patches_best_differing_q <= select_1979[9:0];
      patches_best_column_q <= select_1979[14:10];
      patches_quarters_0_places_q <= sum_3619;
      patches_quarters_0_up_q <= sum_3659;
      patches_quarters_0_down_q <= sum_3669;
      patches_quarters_1_places_q <= sum_3673;
      patches_quarters_1_up_q <= sum_3676;
      patches_quarters_1_down_q <= sum_3679;
      patches_quarters_2_places_q <= sum_3683;
      patches_quarters_2_up_q <= sum_3686;
      patches_quarters_2_down_q <= sum_3689;
      patches_quarters_3_places_q <= sum_3693;
      patches_quarters_3_up_q <= sum_3696;
      patches_quarters_3_down_q <= sum_3699;
      patches_word_places_q <= or_3727;
      patches_word_up_q <= ((select_3737 | select_3739) | select_3742) | select_3745;
      patches_word_down_q <= ((select_3748 | select_3750) | select_3753) | select_3756;
      patches_sum_places_q <= select_3766;
      patches_sum_up_q <= select_3769;
      patches_sum_down_q <= select_3772;
      patches_across_q <= sum_3784;
      patches_places_q <= select_3795;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3799;
      patches_partly_q <= or_3802;
      patches_clear_limit_q <= sum_3803[8:2];
      patches_complete_q <= select_3805;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3788 ? select_3810 : patches_found_q;
      patches_doubted_q <= select_3817;
      patches_doubted_before_q <= select_3818;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3822;
      patches_on_skin_q <= sum_3832;
      patches_large_q <= not_3834 & and_3839;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3844;
      patches_spoiled_q <= or_3848;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3855;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3865;
      segment_textured_q <= select_2004 + {5'h0, and_2603};
      segment_explained_q <= select_2009 + {5'h0, and_2608};
      segment_nearer_q <= select_2019 + {5'h0, and_2613};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_569_s3_q ? select_3938 : good_q;
      good_known_q <= select_3943;
      hidden_for_q <= select_3961;
      product_q <= equal_569_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3986;
      disagree_q <= equal_569_s3_q ? select_3930 : disagree_q;
      too_much_q <= equal_569_s3_q ? select_3996 : too_much_q;
      hides_q <= equal_569_s3_q ? select_3956 : hides_q;
      overlooks_q <= equal_569_s3_q ? select_4002 : overlooks_q;
      proven_q <= and_1972_s3_q ? select_4111 : proven_q;
      seen_q <= select_4169;
      nearer_q <= select_4175;
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
      averager_quarter_1_0_q <= select_2162;
      averager_quarter_1_1_q <= select_2164;
      averager_quarter_2_0_q <= select_2166;
      averager_quarter_2_1_q <= select_2168;
      averager_detail_0_q <= select_2180;
      averager_detail_1_q <= select_2188;
      census_changes_values_0_left_q <= and_544_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_544_s3_q ? sum_2271 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2273;
      census_changes_values_1_right_q <= select_2274;
      census_changes_values_2_left_q <= select_2275;
      census_changes_values_2_right_q <= select_2276;
      sharpness_last_mask_q <= and_544_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_544_s3_q ? select_2357[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_544_s3_q ? select_2357[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4006;
      box_textured_columns_values_1_q <= select_4009;
      box_textured_columns_values_2_q <= select_4012;
      box_textured_columns_values_3_q <= select_4015;
      box_textured_columns_values_4_q <= select_4018;
      box_textured_sum_sums_values_0_q <= equal_569_s3_q ? box_textured_sum_sums_values_0_q : select_4020;
      box_explained_columns_values_0_q <= select_4024;
      box_explained_columns_values_1_q <= select_4027;
      box_explained_columns_values_2_q <= select_4030;
      box_explained_columns_values_3_q <= select_4033;
      box_explained_columns_values_4_q <= select_4036;
      box_explained_sum_sums_values_0_q <= equal_569_s3_q ? box_explained_sum_sums_values_0_q : select_4038;
      box_shown_columns_values_0_q <= equal_569_s3_q ? box_shown_columns_values_0_q : select_4041;
      box_shown_columns_values_1_q <= select_4045;
      box_shown_columns_values_2_q <= select_4048;
      box_shown_columns_values_3_q <= select_4051;
      box_shown_columns_values_4_q <= select_4054;
      box_shown_sum_sums_values_0_q <= equal_569_s3_q ? box_shown_sum_sums_values_0_q : select_4056;
      box_nearer_columns_values_0_q <= equal_569_s3_q ? box_nearer_columns_values_0_q : select_4059;
      box_nearer_columns_values_1_q <= select_4063;
      box_nearer_columns_values_2_q <= select_4066;
      box_nearer_columns_values_3_q <= select_4069;
      box_nearer_columns_values_4_q <= select_4072;
      box_nearer_sum_sums_values_0_q <= equal_569_s3_q ? box_nearer_sum_sums_values_0_q : select_4074;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4113_s4_q;
  logic or_4176_s4_q;
  logic and_4177_s4_q;
  logic and_4185_s4_q;
  logic and_4188_s4_q;
  logic and_4194_s4_q;
  logic and_4198_s4_q;
  logic and_4204_s4_q;
  logic and_4208_s4_q;
  logic and_4216_s4_q;
  logic and_4221_s4_q;
  logic and_4224_s4_q;
  logic and_4228_s4_q;
  logic [5:0] select_4230_s4_q;
  logic [31:0] select_4247_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4113_s4_q <= said_q;
      or_4176_s4_q <= not_2348 | select_4169;
      and_4177_s4_q <= cfg_prove_i & select_4175;
      and_4185_s4_q <= equal_569_s3_q & (equal_3941_s3_q & (cfg_prove_i & or_4182));
      and_4188_s4_q <= equal_569_s3_q & (equal_3941_s3_q & (cfg_prove_i & or_3922));
      and_4194_s4_q <= and_4194;
      and_4198_s4_q <= equal_569_s3_q & and_4197;
      and_4204_s4_q <= equal_569_s3_q & (equal_3941_s3_q & (not_4190 & or_4201));
      and_4208_s4_q <= and_4208;
      and_4216_s4_q <= equal_569_s3_q & (equal_3941_s3_q & (cfg_prove_i & and_4213));
      and_4221_s4_q <= equal_569_s3_q & (equal_3941_s3_q & select_4219);
      and_4224_s4_q <= and_4224;
      and_4228_s4_q <= and_4228;
      select_4230_s4_q <= equal_569_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4247_s4_q <= equal_569_s3_q ? (x_s3_q[6] ? select_4245 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4176_s4_q;
  assign marks_nearer_o = and_4177_s4_q;
  assign verdict_valid_o = and_4113_s4_q;
  assign verdict_unproven_yet_o = and_4185_s4_q;
  assign verdict_untextured_o = and_4188_s4_q;
  assign verdict_disagree_o = and_4194_s4_q;
  assign verdict_moved_o = and_4198_s4_q;
  assign verdict_unsharp_left_o = and_4204_s4_q;
  assign verdict_unsharp_right_o = and_4208_s4_q;
  assign verdict_hidden_o = and_4216_s4_q;
  assign verdict_overlooked_o = and_4221_s4_q;
  assign verdict_out_of_step_o = and_4224_s4_q;
  assign frame_valid_o = and_4228_s4_q;
  assign frame_index_o = select_4230_s4_q;
  assign frame_word_o = select_4247_s4_q;
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
  assign unused_bits = ^{over[13:0], product_3837[4:0], sum_3803[1:0], sum_3758[1:0], product_3649[4:0], sum_2742[0], difference_2683[1:0], detail_4[1:0], detail_3[1:0], sum_2281[4:0], sum_1712[0], sum_1708[0], sum_726[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
