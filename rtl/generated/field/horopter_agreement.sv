// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3140 bits, pipeline 850 bits, memories 73171 bits.
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
  logic not_2374;
  assign not_2374 = ~cfg_prove_i;
  logic [5:0] sum_2597;
  assign sum_2597 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic less_2602;
  assign less_2602 = 6'h8 < cfg_height_i[8:3];
  logic [6:0] difference_3634;
  assign difference_3634 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3826;
  assign not_3826 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3884;
  assign difference_3884 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic [5:0] sum_4143;
  assign sum_4143 = {2'h0, cfg_height_i[8:5]} + 6'h3f;
  logic [7:0] select_4144;
  assign select_4144 = (6'h4 < cfg_height_i[8:3]) ? {sum_4143, cfg_height_i[4:3]} : 8'h0;

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
  logic [2:0] select_520;
  assign select_520 = sample_pair_first_q ? 3'h0 : raster_at_x_q;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [7:0] select_524;
  assign select_524 = select_520[0] ? averager_place_q : (row_starts ? 8'h0 : (averager_place_q + 8'h1));
  // hls/stages/census.hpp:122
  logic or_528;
  assign or_528 = row_starts | (averager_inside_q & (~(averager_place_q == 8'hbc)));
  // hls/stages/census.hpp:124
  logic select_529;
  assign select_529 = select_520[0] ? averager_inside_q : or_528;
  // hls/stages/census.hpp:42
  logic or_530;
  assign or_530 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:423
  logic and_532;
  assign and_532 = select_529 & (select_520[0] & or_530);
  // hls/stages/census.hpp:42
  logic [2:0] select_537;
  assign select_537 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [5:0] select_553;
  assign select_553 = sample_pair_first_q ? 6'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] last;
  assign last = sample_pair_whole_q ? select_553 : 6'h0;
  // hls/stages/census.hpp:53
  logic equal_555;
  assign equal_555 = select_520 == 3'h7;
  // hls/stages/census.hpp:58
  logic equal_556;
  assign equal_556 = select_537 == 3'h7;
  // hls/stages/census.hpp:134
  logic and_557;
  assign and_557 = equal_556 & and_532;
  // hls/stages/agreement.hpp:277
  logic and_559;
  assign and_559 = sample_pair_whole_q & (equal_555 & and_557);
  // hls/stages/agreement.hpp:197
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:634
  logic equal_590;
  assign equal_590 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:605
  logic or_591;
  assign or_591 = so | equal_590;
  // hls/stages/agreement.hpp:603
  logic [7:0] sum_592;
  assign sum_592 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:605
  logic [7:0] select_593;
  assign select_593 = run_shift_q[5] ? x_q : sum_592;
  logic less_594;
  assign less_594 = {2'h0, last_q} < select_593;
  // hls/stages/agreement.hpp:227
  logic not_595;
  assign not_595 = ~less_594;
  // hls/stages/agreement.hpp:625
  logic equal_604;
  assign equal_604 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:626
  logic equal_605;
  assign equal_605 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:150
  logic and_606;
  assign and_606 = equal_605 & not_595;
  logic select_608;
  assign select_608 = or_591 ? not_595 : (equal_604 ? not_595 : and_606);
  // hls/stages/agreement.hpp:809
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:807
  logic [6:0] sum_621;
  assign sum_621 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:150
  logic and_626;
  assign and_626 = equal_604 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_621} < select_593))));
  logic select_627;
  assign select_627 = or_591 ? not_595 : and_626;
  // hls/stages/agreement.hpp:832
  logic [5:0] right;
  assign right = sum_592[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:731
  logic not_662;
  assign not_662 = ~or_591;
  // hls/stages/agreement.hpp:150
  logic and_665;
  assign and_665 = not_662 & ((~equal_604) & and_606);
  // hls/stages/census.hpp:42
  logic [5:0] select_692;
  assign select_692 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_692 : 6'h0;
  // hls/stages/patches.hpp:401
  logic not_1689;
  assign not_1689 = ~patches_begins_q;
  // hls/stages/census.hpp:33
  logic not_1692;
  assign not_1692 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:371
  logic and_1693;
  assign and_1693 = patches_capturing_q & not_1692;
  // hls/stages/patches.hpp:373
  logic equal_1694;
  assign equal_1694 = {or_530, select_537} == 4'hc;
  // hls/stages/patches.hpp:318
  logic equal_1696;
  assign equal_1696 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1701;
  assign and_1701 = (not_1689 & (patches_work_q == 3'h0)) & (~(and_1693 | ((~equal_1694) | (~equal_1696))));
  // hls/stages/patches.hpp:542
  logic equal_1788;
  assign equal_1788 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:521
  logic not_1789;
  assign not_1789 = ~equal_1788;
  // hls/stages/patches.hpp:514
  logic equal_1790;
  assign equal_1790 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:467
  logic not_1791;
  assign not_1791 = ~equal_1790;
  // hls/stages/patches.hpp:508
  logic equal_1792;
  assign equal_1792 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1793;
  assign equal_1793 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:542
  logic or_1794;
  assign or_1794 = equal_1792 | equal_1793;
  // hls/stages/patches.hpp:469
  logic not_1795;
  assign not_1795 = ~patches_second_q;
  // hls/stages/patches.hpp:382
  logic [4:0] select_1822;
  assign select_1822 = and_1701 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1823;
  assign select_1823 = row_starts ? select_1822 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1825;
  assign and_1825 = and_1693 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1829;
  assign select_1829 = row_starts ? (and_1701 | (and_1693 & (~and_1825))) : patches_capturing_q;
  // hls/stages/agreement.hpp:276
  logic and_1837;
  assign and_1837 = not_1789 & (not_1791 & (or_1794 & (patches_second_q & equal_1793)));
  // hls/stages/patches.hpp:168
  logic not_1853;
  assign not_1853 = ~equal_1793;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_1869;
  assign select_1869 = row_starts ? {select_1822[4], select_1822[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:467
  logic and_1879;
  assign and_1879 = not_1789 & (or_1794 & not_1791);
  // hls/stages/agreement.hpp:191
  logic and_1985;
  assign and_1985 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:277
  logic [2:0] select_2164;
  assign select_2164 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_520 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2167;
  assign select_2167 = sample_pair_whole_q ? (sample_last_q ? (select_537 + 3'h1) : select_537) : raster_at_y_q;
  logic [5:0] select_2170;
  assign select_2170 = sample_pair_whole_q ? (sample_last_q ? 6'h0 : (select_553 + {5'h0, equal_555})) : raster_at_column_q;
  logic [5:0] select_2173;
  assign select_2173 = sample_pair_whole_q ? (sample_last_q ? (select_692 + {5'h0, equal_556}) : select_692) : raster_at_row_q;
  logic select_2177;
  assign select_2177 = sample_pair_whole_q ? (sample_last_q ? (or_530 & (~raster_final_row_q)) : or_530) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2179;
  assign select_2179 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:277
  logic select_2183;
  assign select_2183 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:464
  logic [6:0] sum_2502;
  assign sum_2502 = {1'b0, last} + 7'h1;
  logic equal_2503;
  assign equal_2503 = {sum_2502[6], cfg_width_i[8:3]} == {1'b0, sum_2502[5:0]};
  // hls/stages/agreement.hpp:469
  logic and_2504;
  assign and_2504 = and_559 & equal_2503;
  // hls/stages/agreement.hpp:534
  logic select_2507;
  assign select_2507 = (and_2504 | (~ends_cell_q)) ? and_2504 : ends_q;
  // hls/stages/agreement.hpp:540
  logic [2:0] now;
  assign now = select_2507 ? (and_2504 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:545
  logic [5:0] select_2511;
  assign select_2511 = select_2507 ? (and_2504 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2514;
  assign select_2514 = select_2507 ? (following_last_shift_q & (~and_2504)) : run_last_shift_q;
  // hls/stages/agreement.hpp:618
  logic and_2517;
  assign and_2517 = run_last_shift_q & equal_604;
  // hls/stages/agreement.hpp:627
  logic select_2519;
  assign select_2519 = equal_604 ? (~run_last_shift_q) : equal_605;
  // hls/stages/agreement.hpp:631
  logic equal_2520;
  assign equal_2520 = run_phase_q == 3'h1;
  logic not_2523;
  assign not_2523 = ~select_2519;
  // hls/stages/agreement.hpp:634
  logic equal_2525;
  assign equal_2525 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:618
  logic and_2526;
  assign and_2526 = final_row_q & so;
  // hls/stages/agreement.hpp:631
  logic [1:0] select_2527;
  assign select_2527 = equal_2525 ? 2'h1 : {2{and_2526}};
  logic [2:0] select_2529;
  assign select_2529 = (and_2517 | (select_2519 | equal_2520)) ? (equal_2520 ? 3'h2 : {not_2523, {2{select_2519}}}) : (equal_590 ? 3'h6 : {select_2527[0], select_2527});
  // hls/stages/agreement.hpp:618
  logic and_2532;
  assign and_2532 = select_2519 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:641
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2535;
  assign select_2535 = (plan_shift_q[5] & select_2519) ? value : 7'h0;
  logic [1:0] or_2536;
  assign or_2536 = {2{so}} | select_2535[5:4];
  // hls/stages/agreement.hpp:644
  logic [7:0] select_2537;
  assign select_2537 = select_2519 ? plan_columns_q : 8'h0;
  logic [6:0] or_2540;
  assign or_2540 = select_2537[6:0] | ((equal_2520 | equal_2525) ? whole_q : 7'h0);
  logic [1:0] or_2541;
  assign or_2541 = {2{and_2517}} | or_2540[3:2];
  // hls/stages/agreement.hpp:645
  logic [6:0] or_2543;
  assign or_2543 = {or_2540[6:4], or_2541, or_2540[1:0]} | (equal_590 ? drawn_q : 7'h0);
  logic [4:0] or_2544;
  assign or_2544 = {5{so}} | {or_2543[6], or_2543[3:0]};
  // hls/stages/agreement.hpp:651
  logic not_2548;
  assign not_2548 = ~run_shift_q[5];
  logic [6:0] difference_2550;
  assign difference_2550 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2551;
  assign select_2551 = equal_604 ? ({{7{not_2548}}, 1'b1} + run_span_q) : {difference_2550[6], difference_2550};
  // hls/stages/agreement.hpp:534
  logic [6:0] select_2555;
  assign select_2555 = and_2504 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:537
  logic [7:0] select_2557;
  assign select_2557 = select_2507 ? {select_2555[6], select_2555} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2560;
  assign select_2560 = select_2507 ? (and_2504 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:531
  logic [5:0] select_2568;
  assign select_2568 = and_559 ? (equal_2503 ? ((5'he < last[5:1]) ? 6'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:481
  logic [4:0] sum_2569;
  assign sum_2569 = {1'b0, last[5:2]} + 5'h3;
  // hls/stages/agreement.hpp:531
  logic [6:0] select_2571;
  assign select_2571 = and_559 ? (equal_2503 ? {sum_2569, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:482
  logic [4:0] sum_2572;
  assign sum_2572 = {1'b0, last[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:531
  logic [6:0] select_2574;
  assign select_2574 = and_559 ? (equal_2503 ? {sum_2572, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:542
  logic select_2588;
  assign select_2588 = (ends_cell_q | select_2507) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_604 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:537
  logic and_2592;
  assign and_2592 = (~select_2507) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:484
  logic [6:0] sum_2593;
  assign sum_2593 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:465
  logic select_2595;
  assign select_2595 = equal_2503 ? ({sum_2593[6], cfg_height_i[8:3]} == {1'b0, sum_2593[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:324
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2987;
  assign select_2987 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2988;
  assign select_2988 = sample_pair_whole_q ? select_2987 : patches_phase_q;
  // hls/stages/patches.hpp:382
  logic and_2989;
  assign and_2989 = not_1692 & equal_1694;
  logic [8:0] select_2990;
  assign select_2990 = and_2989 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2991;
  assign select_2991 = and_2989 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2992;
  assign select_2992 = sample_pair_first_q ? select_2990 : select_2991;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2994;
  assign select_2994 = sample_pair_whole_q ? (row_starts ? select_2992[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2996;
  assign select_2996 = sample_pair_whole_q ? (row_starts ? select_2992[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2999;
  assign select_2999 = sample_pair_whole_q ? (equal_1696 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3001;
  assign select_3001 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1696}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:337
  logic equal_3002;
  assign equal_3002 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:338
  logic not_3003;
  assign not_3003 = ~equal_3002;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3005;
  assign select_3005 = sample_pair_whole_q ? (phase + {not_3003, 1'b1, not_3003, equal_3002}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:478
  logic equal_3007;
  assign equal_3007 = row == 6'h5;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3011;
  assign select_3011 = equal_3007 ? ((select_2988 == 4'h6) ? 4'h0 : (select_2988 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3012;
  assign equal_3012 = select_3011 == 4'h0;
  // hls/stages/agreement.hpp:465
  logic [3:0] select_3015;
  assign select_3015 = equal_2503 ? (equal_3012 ? 4'h6 : (select_3011 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3017;
  assign select_3017 = equal_3007 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:465
  logic [4:0] select_3019;
  assign select_3019 = equal_2503 ? (select_3017 + {4'h0, equal_3012}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:531
  logic select_3024;
  assign select_3024 = and_559 ? (equal_2503 ? ((6'h4 < row) & equal_3012) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3026;
  assign select_3026 = and_559 ? (equal_2503 ? select_3017 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:380
  logic [5:0] sum_3048;
  assign sum_3048 = {1'b0, select_692[5:1]} + 6'h1;
  logic less_3049;
  assign less_3049 = {sum_3048, select_692[0], select_537, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3052;
  assign select_3052 = row_starts ? (and_1701 ? (~less_3049) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:402
  logic or_3091;
  assign or_3091 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:404
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3096;
  assign select_3096 = (patches_second_q | patches_begins_q) ? not_1689 : (patches_ends_q & equal_1788);
  logic and_3097;
  assign and_3097 = equal_1788 & not_1795;
  // hls/stages/patches.hpp:408
  logic and_3098;
  assign and_3098 = not_1853 & and_3097;
  logic [1:0] select_3100;
  assign select_3100 = equal_1790 ? 2'h0 : (equal_1792 ? 2'h3 : {equal_1793, and_3098});
  // hls/stages/patches.hpp:286
  logic equal_3102;
  assign equal_3102 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:284
  logic not_3103;
  assign not_3103 = ~equal_3102;
  // hls/stages/patches.hpp:286
  logic equal_3104;
  assign equal_3104 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:282
  logic not_3105;
  assign not_3105 = ~equal_3104;
  // hls/stages/patches.hpp:290
  logic not_3107;
  assign not_3107 = ~(patches_following_q == 3'h2);
  logic and_3110;
  assign and_3110 = (~(patches_following_q == 3'h1)) & not_3107;
  // hls/stages/patches.hpp:406
  logic [1:0] select_3111;
  assign select_3111 = equal_3104 ? 2'h2 : {and_3110, not_3107};
  logic [3:0] select_3112;
  assign select_3112 = equal_3102 ? 4'h2 : {select_3111, {2{not_3105}}};
  // hls/stages/patches.hpp:414
  logic not_3115;
  assign not_3115 = ~or_3091;
  // hls/stages/patches.hpp:403
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:415
  logic [11:0] select_3120;
  assign select_3120 = or_3091 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:191
  logic [4:0] select_3122;
  assign select_3122 = or_3091 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 47 x 33, DISTANCE 12, hls/stages/agreement.hpp:1405; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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
  assign fresh_re = s0_en & and_665;
`endif
  logic [32:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 85, DISTANCE 12, hls/stages/agreement.hpp:1406; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign left_re = s0_en & select_608;
`endif
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 99, DISTANCE 12, hls/stages/agreement.hpp:1407; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [98:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = or_591 ? x_q[5:0] : (equal_604 ? sum_592[5:0] : x_q[5:0]);
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s0_en & select_608;
`endif
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 62, DISTANCE 12, hls/stages/agreement.hpp:1408; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [61:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 62'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_591 ? x_q[5:0] : x[5:0];
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s0_en & select_627;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:794; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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
  assign patches_right_0_re = s0_en & (not_1789 & (not_1791 & (or_1794 & (equal_1793 & not_1795))));
`endif
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:794; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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
  assign patches_right_1_re = s0_en & and_1837;
`endif
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:795; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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
  assign patches_left_re = s0_en & (not_1789 & (not_1791 & (not_1853 & or_1794)));
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:806; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign patches_columns_above_re = s0_en & and_1879;
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
      left_first_q <= and_1985 ? left_first_q : marks_first_i;
      right_q <= (~and_1985) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1985;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= select_2164;
      raster_at_y_q <= select_2167;
      raster_at_column_q <= select_2170;
      raster_at_row_q <= select_2173;
      raster_at_live_q <= select_2177;
      raster_rows_left_q <= sample_pair_whole_q ? select_2179 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2183;
      averager_place_q <= sample_pair_whole_q ? select_524 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_529 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2511;
      run_last_shift_q <= select_2514;
      run_span_q <= select_2507 ? (and_2504 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2529;
      following_shift_q <= select_2519 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2532;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2535[6], or_2536, select_2535[3:0]};
      following_columns_q <= {select_2537[7], or_2544[4], or_2543[5:4], or_2544[3:0]};
      plan_shift_q <= equal_604 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2551;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2557;
      columns_left_q <= select_2560;
      last_q <= and_559 ? (equal_2503 ? last : last_q) : last_q;
      least_q <= select_2568;
      whole_q <= select_2571;
      drawn_q <= select_2574;
      age_q <= select_2507 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2507 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2588;
      ends_q <= and_2592;
      final_row_q <= and_559 ? select_2595 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2988;
      patches_band_rows_rows_to_next_q <= select_2994;
      patches_band_rows_number_q <= select_2996;
      patches_next_band_rows_to_next_q <= select_2999;
      patches_next_band_number_q <= select_3001;
      patches_first_band_rows_to_next_q <= select_3005;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3002 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_559 ? select_3015 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_559 ? select_3019 : patches_choosing_number_q;
      patches_chooses_q <= select_3024;
      patches_choosing_band_q <= select_3026;
      patches_capturing_q <= sample_pair_whole_q ? select_1829 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3052 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1823 : patches_row_q;
      patches_work_q <= or_3091 ? following : patches_work_q;
      patches_second_q <= select_3096;
      patches_following_q <= equal_1788 ? {2'h0, and_3097} : {equal_1790, select_3100};
      patches_following_beats_q <= {select_3112, not_3103};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_1825);
      patches_ends_q <= not_3115 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3120;
      patches_code_row_q <= select_3122;
      patches_column_q <= or_3091 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3115 & (patches_column_q == 5'h1e);
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
  logic [4:0] patches_choosing_number_s1_q;
  logic patches_chooses_s1_q;
  logic [4:0] patches_choosing_band_s1_q;
  logic patches_lower_s1_q;
  logic patches_second_s1_q;
  logic [4:0] patches_code_row_s1_q;
  logic [4:0] patches_column_s1_q;
  logic [2:0] select_520_s1_q;
  logic row_starts_s1_q;
  logic [7:0] select_524_s1_q;
  logic and_532_s1_q;
  logic equal_538_s1_q;
  logic [5:0] select_553_s1_q;
  logic [5:0] last_s1_2_q;
  logic and_557_s1_q;
  logic and_559_s1_q;
  logic equal_586_s1_q;
  logic so_s1_q;
  logic equal_590_s1_q;
  logic or_591_s1_q;
  logic less_594_s1_q;
  logic not_595_s1_q;
  logic equal_604_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_627_s1_q;
  logic [5:0] right_s1_q;
  logic and_665_s1_q;
  logic [5:0] row_s1_q;
  logic and_1577_s1_q;
  logic equal_1578_s1_q;
  logic and_1701_s1_q;
  logic equal_1788_s1_q;
  logic not_1789_s1_q;
  logic equal_1790_s1_q;
  logic not_1791_s1_q;
  logic equal_1792_s1_q;
  logic equal_1793_s1_q;
  logic or_1794_s1_q;
  logic not_1795_s1_q;
  logic [4:0] select_1823_s1_q;
  logic select_1829_s1_q;
  logic [3:0] select_1869_s1_q;
  logic and_1879_s1_q;
  logic equal_2503_s1_q;
  logic and_2504_s1_q;
  logic or_3091_s1_q;
  logic not_3115_s1_q;
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
      patches_choosing_number_s1_q <= patches_choosing_number_q;
      patches_chooses_s1_q <= patches_chooses_q;
      patches_choosing_band_s1_q <= patches_choosing_band_q;
      patches_lower_s1_q <= patches_lower_q;
      patches_second_s1_q <= patches_second_q;
      patches_code_row_s1_q <= patches_code_row_q;
      patches_column_s1_q <= patches_column_q;
      select_520_s1_q <= select_520;
      row_starts_s1_q <= row_starts;
      select_524_s1_q <= select_524;
      and_532_s1_q <= and_532;
      equal_538_s1_q <= select_537 == 3'h0;
      select_553_s1_q <= select_553;
      last_s1_2_q <= last;
      and_557_s1_q <= and_557;
      and_559_s1_q <= and_559;
      equal_586_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_590_s1_q <= equal_590;
      or_591_s1_q <= or_591;
      less_594_s1_q <= less_594;
      not_595_s1_q <= not_595;
      equal_604_s1_q <= equal_604;
      x_s1_2_q <= x[6:0];
      select_627_s1_q <= select_627;
      right_s1_q <= right;
      and_665_s1_q <= and_665;
      row_s1_q <= row;
      and_1577_s1_q <= not_662 & and_626;
      equal_1578_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      and_1701_s1_q <= and_1701;
      equal_1788_s1_q <= equal_1788;
      not_1789_s1_q <= not_1789;
      equal_1790_s1_q <= equal_1790;
      not_1791_s1_q <= not_1791;
      equal_1792_s1_q <= equal_1792;
      equal_1793_s1_q <= equal_1793;
      or_1794_s1_q <= or_1794;
      not_1795_s1_q <= not_1795;
      select_1823_s1_q <= select_1823;
      select_1829_s1_q <= select_1829;
      select_1869_s1_q <= select_1869;
      and_1879_s1_q <= and_1879;
      equal_2503_s1_q <= equal_2503;
      and_2504_s1_q <= and_2504;
      or_3091_s1_q <= or_3091;
      not_3115_s1_q <= not_3115;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [11:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
  logic moments_other_field_second_q;
  logic [5:0] row_q;
  logic lower_half_q;
  logic late_q;
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
  logic [4:0] patches_bands_chosen_q;
  logic [8:0] region_across_rest_q;
  logic [6:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [7:0] columns_begin_rest_q;
  logic [6:0] columns_begin_back_q;
  logic done_q;
  logic proven_q;
  logic drew_q;
  logic said_q;
  // hls/stages/census.hpp:127
  logic and_533;
  assign and_533 = sample_pair_whole_s1_q & and_532_s1_q;
  // hls/stages/agreement.hpp:679
  logic equal_578;
  assign equal_578 = row_q == 6'h0;
  // hls/stages/agreement.hpp:1108
  logic equal_579;
  assign equal_579 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:260
  logic first;
  assign first = equal_578 & equal_579;
  // hls/stages/moments.hpp:68
  logic [11:0] select_582;
  assign select_582 = moments_starts_q ? 12'h1 : (moments_place_q + {11'h0, moments_taken_q});
  // hls/stages/moments.hpp:74
  logic [11:0] place;
  assign place = first ? 12'h0 : select_582;
  // hls/stages/moments.hpp:149
  logic [11:0] address;
  assign address = moments_other_field_second_q ? (place + 12'h66d) : place;
  // hls/stages/agreement.hpp:1023
  logic not_587;
  assign not_587 = ~equal_586_s1_q;
  // hls/stages/agreement.hpp:202
  logic not_589;
  assign not_589 = ~so_s1_q;
  // hls/stages/agreement.hpp:227
  logic inside_v;
  assign inside_v = or_591_s1_q & not_595_s1_q;
  // hls/stages/moments.hpp:149
  logic not_598;
  assign not_598 = ~(12'h66c < place);
  // hls/stages/agreement.hpp:799
  logic and_602;
  assign and_602 = not_587 & (not_589 & (equal_590_s1_q & (inside_v & not_598)));
  // hls/stages/agreement.hpp:986
  logic and_617;
  assign and_617 = (or_591_s1_q & (left_rdata_q[67] & not_595_s1_q)) & (late_q | (~(row_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:977
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:978
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:979
  logic [5:0] select_636;
  assign select_636 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:1015
  logic less_649;
  assign less_649 = 6'h2 < row_q;
  // hls/stages/agreement.hpp:1017
  logic and_659;
  assign and_659 = (or_591_s1_q & (right_codes_rdata_q[58] & not_595_s1_q)) & less_649;
  // hls/stages/agreement.hpp:680
  logic or_763;
  assign or_763 = late_q | (~equal_578);
  // hls/stages/agreement.hpp:682
  logic and_764;
  assign and_764 = left_rdata_q[12] & or_763;
  logic and_765;
  assign and_765 = left_rdata_q[30] & or_763;
  logic and_766;
  assign and_766 = left_rdata_q[48] & or_763;
  logic and_767;
  assign and_767 = left_rdata_q[66] & or_763;
  // hls/stages/agreement.hpp:683
  logic and_768;
  assign and_768 = right_codes_rdata_q[12] & or_763;
  logic and_769;
  assign and_769 = right_codes_rdata_q[27] & or_763;
  logic and_770;
  assign and_770 = right_codes_rdata_q[42] & or_763;
  logic and_771;
  assign and_771 = right_codes_rdata_q[57] & or_763;
  logic and_772;
  assign and_772 = right_codes_rdata_q[72] & or_763;
  logic and_773;
  assign and_773 = right_codes_rdata_q[85] & or_763;
  // hls/stages/agreement.hpp:222
  logic and_778;
  assign and_778 = left_rdata_q[48] & not_595_s1_q;
  logic and_779;
  assign and_779 = right_codes_rdata_q[42] & not_595_s1_q;
  logic [11:0] select_780;
  assign select_780 = less_594_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_781;
  assign select_781 = less_594_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_785;
  assign select_785 = and_778 ? (and_779 ? (~(select_780 ^ select_781)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_791;
  assign parity_791 = ^select_785[5:3];
  logic parity_794;
  assign parity_794 = ^select_785[8:6];
  logic parity_797;
  assign parity_797 = ^select_785[11:3];
  // hls/stages/agreement.hpp:222
  logic and_801;
  assign and_801 = left_rdata_q[66] & not_595_s1_q;
  logic and_802;
  assign and_802 = right_codes_rdata_q[57] & not_595_s1_q;
  logic [11:0] select_803;
  assign select_803 = less_594_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_804;
  assign select_804 = less_594_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_808;
  assign select_808 = and_801 ? (and_802 ? (~(select_803 ^ select_804)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_811;
  assign parity_811 = ^select_808[8:6];
  logic parity_814;
  assign parity_814 = ^select_808[11:9];
  // hls/stages/agreement.hpp:222
  logic and_818;
  assign and_818 = left_rdata_q[84] & not_595_s1_q;
  logic and_819;
  assign and_819 = right_codes_rdata_q[72] & not_595_s1_q;
  logic [11:0] select_820;
  assign select_820 = less_594_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_821;
  assign select_821 = less_594_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_825;
  assign select_825 = and_818 ? (and_819 ? (~(select_820 ^ select_821)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_831;
  assign parity_831 = ^select_825[2:0];
  logic parity_834;
  assign parity_834 = ^select_825[5:3];
  logic parity_837;
  assign parity_837 = ^select_825[8:0];
  logic parity_843;
  assign parity_843 = ^select_825[11:9];
  logic parity_846;
  assign parity_846 = ^select_808[2:0];
  logic parity_849;
  assign parity_849 = ^{select_825[11:9], select_808[5:0]};
  logic parity_852;
  assign parity_852 = ^{select_825, select_808, select_785[2:0]};
  logic xor_853;
  assign xor_853 = parity_797 ^ parity_852;
  // hls/stages/count_bits.hpp:23
  logic or_857;
  assign or_857 = (select_785[1:0] == 2'h3) | (select_785[2] & (select_785[0] | select_785[1]));
  // hls/stages/count_bits.hpp:25
  logic or_861;
  assign or_861 = (select_808[7:6] == 2'h3) | (select_808[8] & (select_808[6] | select_808[7]));
  logic or_865;
  assign or_865 = (select_808[10:9] == 2'h3) | (select_808[11] & (select_808[9] | select_808[10]));
  // hls/stages/count_bits.hpp:23
  logic or_873;
  assign or_873 = (select_825[7:6] == 2'h3) | (select_825[8] & (~(select_825[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_877;
  assign or_877 = (select_825[1:0] == 2'h3) | (select_825[2] & (select_825[0] | select_825[1]));
  logic or_881;
  assign or_881 = (select_825[4:3] == 2'h3) | (select_825[5] & (select_825[3] | select_825[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_884;
  assign parity_884 = ^{or_881, or_877, or_873};
  // hls/stages/count_bits.hpp:23
  logic or_888;
  assign or_888 = (select_808[4:3] == 2'h3) | (select_808[5] & (select_808[3] | select_808[4]));
  // hls/stages/count_bits.hpp:25
  logic or_892;
  assign or_892 = (select_825[10:9] == 2'h3) | (select_825[11] & (select_825[9] | select_825[10]));
  logic or_896;
  assign or_896 = (select_808[1:0] == 2'h3) | (select_808[2] & (select_808[0] | select_808[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_899;
  assign parity_899 = ^{or_896, or_892, or_888};
  logic parity_902;
  assign parity_902 = ^{or_896, or_892, or_888, or_881, or_877, or_873, or_865, or_861, or_857};
  // hls/stages/count_bits.hpp:25
  logic and_903;
  assign and_903 = parity_797 & parity_852;
  logic or_907;
  assign or_907 = (parity_791 & parity_794) | ((^select_785[11:9]) & (parity_791 | parity_794));
  logic and_910;
  assign and_910 = (^{select_808[11:6], select_785[2:0]}) & (parity_837 | parity_849);
  logic or_911;
  assign or_911 = (parity_837 & parity_849) | and_910;
  // hls/stages/count_bits.hpp:23
  logic or_918;
  assign or_918 = (select_785[10:9] == 2'h3) | (select_785[11] & (select_785[9] | select_785[10]));
  // hls/stages/count_bits.hpp:25
  logic or_922;
  assign or_922 = (select_785[4:3] == 2'h3) | (select_785[5] & (select_785[3] | select_785[4]));
  logic or_926;
  assign or_926 = (select_785[7:6] == 2'h3) | (select_785[8] & (select_785[6] | select_785[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_929;
  assign parity_929 = ^{or_926, or_922, or_918};
  // hls/stages/count_bits.hpp:25
  logic or_933;
  assign or_933 = (parity_811 & parity_814) | ((^select_785[2:0]) & (parity_811 | parity_814));
  logic or_937;
  assign or_937 = (parity_831 & parity_834) | ((^select_825[8:6]) & (parity_831 | parity_834));
  logic or_941;
  assign or_941 = (parity_843 & parity_846) | ((^select_808[5:3]) & (parity_843 | parity_846));
  // hls/stages/count_bits.hpp:24
  logic parity_944;
  assign parity_944 = ^{or_941, or_937, or_933};
  logic parity_947;
  assign parity_947 = ^{or_941, or_937, or_933, or_926, or_922, or_918, or_911, or_907, and_903};
  logic xor_948;
  assign xor_948 = parity_902 ^ parity_947;
  // hls/stages/count_bits.hpp:25
  logic and_949;
  assign and_949 = parity_902 & parity_947;
  logic or_953;
  assign or_953 = (parity_884 & parity_899) | ((^{or_865, or_861, or_857}) & (parity_884 | parity_899));
  logic or_957;
  assign or_957 = (parity_929 & parity_944) | ((^{or_911, or_907, and_903}) & (parity_929 | parity_944));
  logic or_964;
  assign or_964 = (or_861 & or_865) | (or_857 & (or_861 | or_865));
  logic or_968;
  assign or_968 = (or_877 & or_881) | (or_873 & (or_877 | or_881));
  logic or_972;
  assign or_972 = (or_892 & or_896) | (or_888 & (or_892 | or_896));
  // hls/stages/count_bits.hpp:24
  logic parity_975;
  assign parity_975 = ^{or_972, or_968, or_964};
  // hls/stages/count_bits.hpp:25
  logic or_979;
  assign or_979 = (or_907 & or_911) | (and_903 & (or_907 | or_911));
  logic or_983;
  assign or_983 = (or_922 & or_926) | (or_918 & (or_922 | or_926));
  logic or_987;
  assign or_987 = (or_937 & or_941) | (or_933 & (or_937 | or_941));
  // hls/stages/count_bits.hpp:24
  logic parity_990;
  assign parity_990 = ^{or_987, or_983, or_979};
  logic parity_993;
  assign parity_993 = ^{or_987, or_983, or_979, or_972, or_968, or_964, or_957, or_953, and_949};
  // hls/stages/count_bits.hpp:25
  logic or_997;
  assign or_997 = (parity_975 & parity_990) | ((^{or_957, or_953, and_949}) & (parity_975 | parity_990));
  logic or_1001;
  assign or_1001 = (or_953 & or_957) | (and_949 & (or_953 | or_957));
  logic or_1005;
  assign or_1005 = (or_968 & or_972) | (or_964 & (or_968 | or_972));
  logic or_1009;
  assign or_1009 = (or_983 & or_987) | (or_979 & (or_983 | or_987));
  // hls/stages/count_bits.hpp:24
  logic parity_1014;
  assign parity_1014 = ^{or_1009, or_1005, or_1001, or_997};
  // hls/stages/count_bits.hpp:25
  logic or_1018;
  assign or_1018 = (or_1005 & or_1009) | (or_1001 & (or_1005 | or_1009));
  logic and_1019;
  assign and_1019 = or_997 & (^{or_1009, or_1005, or_1001});
  // hls/stages/count_bits.hpp:24
  logic xor_1020;
  assign xor_1020 = or_1018 ^ and_1019;
  // hls/stages/count_bits.hpp:27
  logic and_1021;
  assign and_1021 = or_1018 & and_1019;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1022;
  assign select_1022 = equal_604_s1_q ? {and_1021, xor_1020, parity_1014, parity_993, xor_948, xor_853} : 6'h0;
  logic [5:0] column;
  assign column = or_591_s1_q ? 6'h0 : select_1022;
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1033;
  assign select_1033 = (slot_s1_q[0] ? and_819 : and_802) ? (~(select_780 ^ (slot_s1_q[0] ? select_821 : select_804))) : 12'h0;
  logic [11:0] select_1034;
  assign select_1034 = and_778 ? select_1033 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1040;
  assign parity_1040 = ^select_1034[5:3];
  logic parity_1043;
  assign parity_1043 = ^select_1034[8:6];
  logic parity_1046;
  assign parity_1046 = ^select_1034[11:3];
  // hls/stages/agreement.hpp:222
  logic and_1050;
  assign and_1050 = right_codes_rdata_q[85] & not_595_s1_q;
  logic [11:0] select_1052;
  assign select_1052 = less_594_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1056;
  assign select_1056 = (slot_s1_q[0] ? and_1050 : and_819) ? (~(select_803 ^ (slot_s1_q[0] ? select_1052 : select_821))) : 12'h0;
  logic [11:0] select_1057;
  assign select_1057 = and_801 ? select_1056 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1060;
  assign parity_1060 = ^select_1057[8:6];
  logic parity_1063;
  assign parity_1063 = ^select_1057[11:9];
  // hls/stages/agreement.hpp:745
  logic select_1068;
  assign select_1068 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_595_s1_q) : and_1050;
  logic [11:0] select_1070;
  assign select_1070 = slot_s1_q[0] ? (less_594_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1052;
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1074;
  assign select_1074 = and_818 ? (select_1068 ? (~(select_820 ^ select_1070)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1080;
  assign parity_1080 = ^select_1074[2:0];
  logic parity_1083;
  assign parity_1083 = ^select_1074[5:3];
  logic parity_1086;
  assign parity_1086 = ^select_1074[8:0];
  logic parity_1092;
  assign parity_1092 = ^select_1074[11:9];
  logic parity_1095;
  assign parity_1095 = ^select_1057[2:0];
  logic parity_1098;
  assign parity_1098 = ^{select_1074[11:9], select_1057[5:0]};
  logic parity_1101;
  assign parity_1101 = ^{select_1074, select_1057, select_1034[2:0]};
  logic xor_1102;
  assign xor_1102 = parity_1046 ^ parity_1101;
  // hls/stages/count_bits.hpp:23
  logic or_1106;
  assign or_1106 = (select_1034[1:0] == 2'h3) | (select_1034[2] & (select_1034[0] | select_1034[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1110;
  assign or_1110 = (select_1057[7:6] == 2'h3) | (select_1057[8] & (select_1057[6] | select_1057[7]));
  logic or_1114;
  assign or_1114 = (select_1057[10:9] == 2'h3) | (select_1057[11] & (select_1057[9] | select_1057[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1122;
  assign or_1122 = (select_1074[7:6] == 2'h3) | (select_1074[8] & (~(select_1074[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1126;
  assign or_1126 = (select_1074[1:0] == 2'h3) | (select_1074[2] & (select_1074[0] | select_1074[1]));
  logic or_1130;
  assign or_1130 = (select_1074[4:3] == 2'h3) | (select_1074[5] & (select_1074[3] | select_1074[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1133;
  assign parity_1133 = ^{or_1130, or_1126, or_1122};
  // hls/stages/count_bits.hpp:23
  logic or_1137;
  assign or_1137 = (select_1057[4:3] == 2'h3) | (select_1057[5] & (select_1057[3] | select_1057[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1141;
  assign or_1141 = (select_1074[10:9] == 2'h3) | (select_1074[11] & (select_1074[9] | select_1074[10]));
  logic or_1145;
  assign or_1145 = (select_1057[1:0] == 2'h3) | (select_1057[2] & (select_1057[0] | select_1057[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1148;
  assign parity_1148 = ^{or_1145, or_1141, or_1137};
  logic parity_1151;
  assign parity_1151 = ^{or_1145, or_1141, or_1137, or_1130, or_1126, or_1122, or_1114, or_1110, or_1106};
  // hls/stages/count_bits.hpp:25
  logic and_1152;
  assign and_1152 = parity_1046 & parity_1101;
  logic or_1156;
  assign or_1156 = (parity_1040 & parity_1043) | ((^select_1034[11:9]) & (parity_1040 | parity_1043));
  logic and_1159;
  assign and_1159 = (^{select_1057[11:6], select_1034[2:0]}) & (parity_1086 | parity_1098);
  logic or_1160;
  assign or_1160 = (parity_1086 & parity_1098) | and_1159;
  // hls/stages/count_bits.hpp:23
  logic or_1167;
  assign or_1167 = (select_1034[10:9] == 2'h3) | (select_1034[11] & (select_1034[9] | select_1034[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1171;
  assign or_1171 = (select_1034[4:3] == 2'h3) | (select_1034[5] & (select_1034[3] | select_1034[4]));
  logic or_1175;
  assign or_1175 = (select_1034[7:6] == 2'h3) | (select_1034[8] & (select_1034[6] | select_1034[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1178;
  assign parity_1178 = ^{or_1175, or_1171, or_1167};
  // hls/stages/count_bits.hpp:25
  logic or_1182;
  assign or_1182 = (parity_1060 & parity_1063) | ((^select_1034[2:0]) & (parity_1060 | parity_1063));
  logic or_1186;
  assign or_1186 = (parity_1080 & parity_1083) | ((^select_1074[8:6]) & (parity_1080 | parity_1083));
  logic or_1190;
  assign or_1190 = (parity_1092 & parity_1095) | ((^select_1057[5:3]) & (parity_1092 | parity_1095));
  // hls/stages/count_bits.hpp:24
  logic parity_1193;
  assign parity_1193 = ^{or_1190, or_1186, or_1182};
  logic parity_1196;
  assign parity_1196 = ^{or_1190, or_1186, or_1182, or_1175, or_1171, or_1167, or_1160, or_1156, and_1152};
  logic xor_1197;
  assign xor_1197 = parity_1151 ^ parity_1196;
  // hls/stages/count_bits.hpp:25
  logic and_1198;
  assign and_1198 = parity_1151 & parity_1196;
  logic or_1202;
  assign or_1202 = (parity_1133 & parity_1148) | ((^{or_1114, or_1110, or_1106}) & (parity_1133 | parity_1148));
  logic or_1206;
  assign or_1206 = (parity_1178 & parity_1193) | ((^{or_1160, or_1156, and_1152}) & (parity_1178 | parity_1193));
  logic or_1213;
  assign or_1213 = (or_1110 & or_1114) | (or_1106 & (or_1110 | or_1114));
  logic or_1217;
  assign or_1217 = (or_1126 & or_1130) | (or_1122 & (or_1126 | or_1130));
  logic or_1221;
  assign or_1221 = (or_1141 & or_1145) | (or_1137 & (or_1141 | or_1145));
  // hls/stages/count_bits.hpp:24
  logic parity_1224;
  assign parity_1224 = ^{or_1221, or_1217, or_1213};
  // hls/stages/count_bits.hpp:25
  logic or_1228;
  assign or_1228 = (or_1156 & or_1160) | (and_1152 & (or_1156 | or_1160));
  logic or_1232;
  assign or_1232 = (or_1171 & or_1175) | (or_1167 & (or_1171 | or_1175));
  logic or_1236;
  assign or_1236 = (or_1186 & or_1190) | (or_1182 & (or_1186 | or_1190));
  // hls/stages/count_bits.hpp:24
  logic parity_1239;
  assign parity_1239 = ^{or_1236, or_1232, or_1228};
  logic parity_1242;
  assign parity_1242 = ^{or_1236, or_1232, or_1228, or_1221, or_1217, or_1213, or_1206, or_1202, and_1198};
  // hls/stages/count_bits.hpp:25
  logic or_1246;
  assign or_1246 = (parity_1224 & parity_1239) | ((^{or_1206, or_1202, and_1198}) & (parity_1224 | parity_1239));
  logic or_1250;
  assign or_1250 = (or_1202 & or_1206) | (and_1198 & (or_1202 | or_1206));
  logic or_1254;
  assign or_1254 = (or_1217 & or_1221) | (or_1213 & (or_1217 | or_1221));
  logic or_1258;
  assign or_1258 = (or_1232 & or_1236) | (or_1228 & (or_1232 | or_1236));
  // hls/stages/count_bits.hpp:24
  logic parity_1263;
  assign parity_1263 = ^{or_1258, or_1254, or_1250, or_1246};
  // hls/stages/count_bits.hpp:25
  logic or_1267;
  assign or_1267 = (or_1254 & or_1258) | (or_1250 & (or_1254 | or_1258));
  logic and_1268;
  assign and_1268 = or_1246 & (^{or_1258, or_1254, or_1250});
  // hls/stages/count_bits.hpp:24
  logic xor_1269;
  assign xor_1269 = or_1267 ^ and_1268;
  // hls/stages/count_bits.hpp:27
  logic and_1270;
  assign and_1270 = or_1267 & and_1268;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1271;
  assign select_1271 = equal_604_s1_q ? {and_1270, xor_1269, parity_1263, parity_1242, xor_1197, xor_1102} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_591_s1_q ? 6'h0 : select_1271;
  // hls/stages/agreement.hpp:222
  logic and_1279;
  assign and_1279 = right_codes_rdata_q[27] & not_595_s1_q;
  // hls/stages/agreement.hpp:745
  logic select_1280;
  assign select_1280 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_595_s1_q) : and_1279;
  // hls/stages/agreement.hpp:222
  logic [11:0] select_1282;
  assign select_1282 = less_594_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:745
  logic [11:0] select_1283;
  assign select_1283 = slot_s1_q[0] ? (less_594_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1282;
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1287;
  assign select_1287 = and_778 ? (select_1280 ? (~(select_780 ^ select_1283)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1293;
  assign parity_1293 = ^select_1287[5:3];
  logic parity_1296;
  assign parity_1296 = ^select_1287[8:6];
  logic parity_1299;
  assign parity_1299 = ^select_1287[11:3];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1307;
  assign select_1307 = (slot_s1_q[0] ? and_1279 : and_779) ? (~(select_803 ^ (slot_s1_q[0] ? select_1282 : select_781))) : 12'h0;
  logic [11:0] select_1308;
  assign select_1308 = and_801 ? select_1307 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1311;
  assign parity_1311 = ^select_1308[8:6];
  logic parity_1314;
  assign parity_1314 = ^select_1308[11:9];
  // hls/stages/agreement.hpp:695
  logic [11:0] select_1322;
  assign select_1322 = (slot_s1_q[0] ? and_779 : and_802) ? (~(select_820 ^ (slot_s1_q[0] ? select_781 : select_804))) : 12'h0;
  logic [11:0] select_1323;
  assign select_1323 = and_818 ? select_1322 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1329;
  assign parity_1329 = ^select_1323[2:0];
  logic parity_1332;
  assign parity_1332 = ^select_1323[5:3];
  logic parity_1335;
  assign parity_1335 = ^select_1323[8:0];
  logic parity_1341;
  assign parity_1341 = ^select_1323[11:9];
  logic parity_1344;
  assign parity_1344 = ^select_1308[2:0];
  logic parity_1347;
  assign parity_1347 = ^{select_1323[11:9], select_1308[5:0]};
  logic parity_1350;
  assign parity_1350 = ^{select_1323, select_1308, select_1287[2:0]};
  logic xor_1351;
  assign xor_1351 = parity_1299 ^ parity_1350;
  // hls/stages/count_bits.hpp:23
  logic or_1355;
  assign or_1355 = (select_1287[1:0] == 2'h3) | (select_1287[2] & (select_1287[0] | select_1287[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1359;
  assign or_1359 = (select_1308[7:6] == 2'h3) | (select_1308[8] & (select_1308[6] | select_1308[7]));
  logic or_1363;
  assign or_1363 = (select_1308[10:9] == 2'h3) | (select_1308[11] & (select_1308[9] | select_1308[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1371;
  assign or_1371 = (select_1323[7:6] == 2'h3) | (select_1323[8] & (~(select_1323[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1375;
  assign or_1375 = (select_1323[1:0] == 2'h3) | (select_1323[2] & (select_1323[0] | select_1323[1]));
  logic or_1379;
  assign or_1379 = (select_1323[4:3] == 2'h3) | (select_1323[5] & (select_1323[3] | select_1323[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1382;
  assign parity_1382 = ^{or_1379, or_1375, or_1371};
  // hls/stages/count_bits.hpp:23
  logic or_1386;
  assign or_1386 = (select_1308[4:3] == 2'h3) | (select_1308[5] & (select_1308[3] | select_1308[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1390;
  assign or_1390 = (select_1323[10:9] == 2'h3) | (select_1323[11] & (select_1323[9] | select_1323[10]));
  logic or_1394;
  assign or_1394 = (select_1308[1:0] == 2'h3) | (select_1308[2] & (select_1308[0] | select_1308[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1397;
  assign parity_1397 = ^{or_1394, or_1390, or_1386};
  logic parity_1400;
  assign parity_1400 = ^{or_1394, or_1390, or_1386, or_1379, or_1375, or_1371, or_1363, or_1359, or_1355};
  // hls/stages/count_bits.hpp:25
  logic and_1401;
  assign and_1401 = parity_1299 & parity_1350;
  logic or_1405;
  assign or_1405 = (parity_1293 & parity_1296) | ((^select_1287[11:9]) & (parity_1293 | parity_1296));
  logic and_1408;
  assign and_1408 = (^{select_1308[11:6], select_1287[2:0]}) & (parity_1335 | parity_1347);
  logic or_1409;
  assign or_1409 = (parity_1335 & parity_1347) | and_1408;
  // hls/stages/count_bits.hpp:23
  logic or_1416;
  assign or_1416 = (select_1287[10:9] == 2'h3) | (select_1287[11] & (select_1287[9] | select_1287[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1420;
  assign or_1420 = (select_1287[4:3] == 2'h3) | (select_1287[5] & (select_1287[3] | select_1287[4]));
  logic or_1424;
  assign or_1424 = (select_1287[7:6] == 2'h3) | (select_1287[8] & (select_1287[6] | select_1287[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1427;
  assign parity_1427 = ^{or_1424, or_1420, or_1416};
  // hls/stages/count_bits.hpp:25
  logic or_1431;
  assign or_1431 = (parity_1311 & parity_1314) | ((^select_1287[2:0]) & (parity_1311 | parity_1314));
  logic or_1435;
  assign or_1435 = (parity_1329 & parity_1332) | ((^select_1323[8:6]) & (parity_1329 | parity_1332));
  logic or_1439;
  assign or_1439 = (parity_1341 & parity_1344) | ((^select_1308[5:3]) & (parity_1341 | parity_1344));
  // hls/stages/count_bits.hpp:24
  logic parity_1442;
  assign parity_1442 = ^{or_1439, or_1435, or_1431};
  logic parity_1445;
  assign parity_1445 = ^{or_1439, or_1435, or_1431, or_1424, or_1420, or_1416, or_1409, or_1405, and_1401};
  logic xor_1446;
  assign xor_1446 = parity_1400 ^ parity_1445;
  // hls/stages/count_bits.hpp:25
  logic and_1447;
  assign and_1447 = parity_1400 & parity_1445;
  logic or_1451;
  assign or_1451 = (parity_1382 & parity_1397) | ((^{or_1363, or_1359, or_1355}) & (parity_1382 | parity_1397));
  logic or_1455;
  assign or_1455 = (parity_1427 & parity_1442) | ((^{or_1409, or_1405, and_1401}) & (parity_1427 | parity_1442));
  logic or_1462;
  assign or_1462 = (or_1359 & or_1363) | (or_1355 & (or_1359 | or_1363));
  logic or_1466;
  assign or_1466 = (or_1375 & or_1379) | (or_1371 & (or_1375 | or_1379));
  logic or_1470;
  assign or_1470 = (or_1390 & or_1394) | (or_1386 & (or_1390 | or_1394));
  // hls/stages/count_bits.hpp:24
  logic parity_1473;
  assign parity_1473 = ^{or_1470, or_1466, or_1462};
  // hls/stages/count_bits.hpp:25
  logic or_1477;
  assign or_1477 = (or_1405 & or_1409) | (and_1401 & (or_1405 | or_1409));
  logic or_1481;
  assign or_1481 = (or_1420 & or_1424) | (or_1416 & (or_1420 | or_1424));
  logic or_1485;
  assign or_1485 = (or_1435 & or_1439) | (or_1431 & (or_1435 | or_1439));
  // hls/stages/count_bits.hpp:24
  logic parity_1488;
  assign parity_1488 = ^{or_1485, or_1481, or_1477};
  logic parity_1491;
  assign parity_1491 = ^{or_1485, or_1481, or_1477, or_1470, or_1466, or_1462, or_1455, or_1451, and_1447};
  // hls/stages/count_bits.hpp:25
  logic or_1495;
  assign or_1495 = (parity_1473 & parity_1488) | ((^{or_1455, or_1451, and_1447}) & (parity_1473 | parity_1488));
  logic or_1499;
  assign or_1499 = (or_1451 & or_1455) | (and_1447 & (or_1451 | or_1455));
  logic or_1503;
  assign or_1503 = (or_1466 & or_1470) | (or_1462 & (or_1466 | or_1470));
  logic or_1507;
  assign or_1507 = (or_1481 & or_1485) | (or_1477 & (or_1481 | or_1485));
  // hls/stages/count_bits.hpp:24
  logic parity_1512;
  assign parity_1512 = ^{or_1507, or_1503, or_1499, or_1495};
  // hls/stages/count_bits.hpp:25
  logic or_1516;
  assign or_1516 = (or_1503 & or_1507) | (or_1499 & (or_1503 | or_1507));
  logic and_1517;
  assign and_1517 = or_1495 & (^{or_1507, or_1503, or_1499});
  // hls/stages/count_bits.hpp:24
  logic xor_1518;
  assign xor_1518 = or_1516 ^ and_1517;
  // hls/stages/count_bits.hpp:27
  logic and_1519;
  assign and_1519 = or_1516 & and_1517;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1520;
  assign select_1520 = equal_604_s1_q ? {and_1519, xor_1518, parity_1512, parity_1491, xor_1446, xor_1351} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_591_s1_q ? 6'h0 : select_1520;
  // hls/stages/agreement.hpp:799
  logic and_1588;
  assign and_1588 = ends_cell_s1_q & inside_v;
  logic and_1590;
  assign and_1590 = not_587 & (so_s1_q & and_1588);
  logic [5:0] select_1594;
  assign select_1594 = so_s1_q ? x_s1_q[5:0] : (or_591_s1_q ? (less_594_s1_q ? 6'h0 : select_636) : 6'h0);
  // hls/stages/agreement.hpp:248
  logic or_1598;
  assign or_1598 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:150
  logic and_1607;
  assign and_1607 = or_591_s1_q & (slot_s1_q[2] & not_595_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1720;
  assign select_1720 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1720[16:7])) ? 8'h7f : select_1720[7:0];
  // hls/stages/agreement.hpp:1159
  logic equal_1805;
  assign equal_1805 = x_s1_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:153
  logic [4:0] select_1806;
  assign select_1806 = equal_1805 ? patches_choosing_number_s1_q : patches_bands_chosen_q;
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_1793_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1793_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:509
  logic less_1885;
  assign less_1885 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:510
  logic or_1886;
  assign or_1886 = equal_1792_s1_q | less_1885;
  // hls/stages/patches.hpp:513
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1891;
  assign select_1891 = equal_1792_s1_q ? patches_column_s1_q[0] : (or_1886 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1892;
  assign not_1892 = ~or_1886;
  // hls/stages/patches.hpp:510
  logic [4:0] sum_1893;
  assign sum_1893 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:512
  logic [4:0] select_1896;
  assign select_1896 = or_1886 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1893) + 5'h1) : sum_1893;
  // hls/stages/patches.hpp:514
  logic [4:0] select_1897;
  assign select_1897 = equal_1792_s1_q ? 5'h0 : select_1896;
  logic or_1898;
  assign or_1898 = equal_1792_s1_q | equal_1790_s1_q;
  // hls/stages/patches.hpp:490
  logic equal_1900;
  assign equal_1900 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1902;
  assign equal_1902 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:492
  logic and_1904;
  assign and_1904 = of_row & (~equal_1902);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1900 ? 2'h3 : {equal_1902, and_1904};
  // hls/stages/patches.hpp:478
  logic [8:0] sum_1907;
  assign sum_1907 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1908;
  assign sum_1908 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1907, pixel_2[0]} - {1'b0, sum_1908, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:480
  logic [11:0] sum_1910;
  assign sum_1910 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1911;
  assign sum_1911 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1910[11], sum_1910};
  logic [13:0] sum_1912;
  assign sum_1912 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1911, down_2[1]};
  logic [12:0] sum_1913;
  assign sum_1913 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1912[13:1];
  logic [14:0] sum_1914;
  assign sum_1914 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1913, sum_1912[0], down_2[0]};
  // hls/stages/patches.hpp:462
  logic or_1921;
  assign or_1921 = (sum_1914[8] & (~(sum_1914[7:0] == 8'h0))) | (~(sum_1914[13:9] == 5'h0));
  // hls/stages/patches.hpp:476
  logic [8:0] sum_1926;
  assign sum_1926 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1927;
  assign sum_1927 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1926};
  logic [10:0] sum_1928;
  assign sum_1928 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1927, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1929;
  assign sum_1929 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1928[10:1];
  // hls/stages/patches.hpp:477
  logic [11:0] smooth;
  assign smooth = {sum_1929, sum_1928[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:479
  logic [12:0] sum_1931;
  assign sum_1931 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1932;
  assign sum_1932 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1933;
  assign difference_1933 = {1'b0, sum_1931, smooth[0]} - {1'b0, sum_1932, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:462
  logic or_1940;
  assign or_1940 = (difference_1933[8] & (~(difference_1933[7:0] == 8'h0))) | (~(difference_1933[13:9] == 5'h0));
  // hls/stages/patches.hpp:491
  logic or_1948;
  assign or_1948 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1902) | equal_1900;
  // hls/stages/patches.hpp:486
  logic and_1953;
  assign and_1953 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/agreement.hpp:276
  logic and_1957;
  assign and_1957 = not_1791_s1_q & (or_1794_s1_q & (or_1948 & (equal_1793_s1_q & and_1953)));
  // hls/stages/patches.hpp:174
  logic and_1967;
  assign and_1967 = (~(equal_1793_s1_q | (~and_1953))) & (~patches_column_s1_q[4]);
  // hls/stages/agreement.hpp:276
  logic and_1971;
  assign and_1971 = not_1791_s1_q & (or_1794_s1_q & (and_1967 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:554
  logic less_1973;
  assign less_1973 = patches_step_q[4:0] < 5'h11;
  logic equal_1974;
  assign equal_1974 = patches_step_q[6:5] == 2'h2;
  logic equal_1975;
  assign equal_1975 = patches_step_q[6:5] == 2'h1;
  logic or_1976;
  assign or_1976 = equal_1974 | equal_1975;
  // hls/stages/division.hpp:34
  logic [5:0] sum_2006;
  assign sum_2006 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:1305
  logic not_2069;
  assign not_2069 = ~sample_pair_first_q;
  // hls/stages/agreement.hpp:799
  logic select_2388;
  assign select_2388 = equal_586_s1_q ? (moments_other_field_second_q ^ equal_1805) : moments_other_field_second_q;
  // hls/stages/agreement.hpp:465
  logic select_2600;
  assign select_2600 = equal_2503_s1_q ? (~({row_s1_q, 1'b0} < {sum_2597, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:472
  logic and_2603;
  assign and_2603 = proven_q & less_2602;
  // hls/stages/agreement.hpp:531
  logic select_2607;
  assign select_2607 = and_559_s1_q ? (equal_2503_s1_q ? (and_2603 & (row_s1_q[5:1] == 5'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:473
  logic equal_2608;
  assign equal_2608 = row_s1_q[5:2] == 4'h0;
  // hls/stages/agreement.hpp:474
  logic and_2609;
  assign and_2609 = and_2603 & equal_2608;
  // hls/stages/agreement.hpp:531
  logic and_2877;
  assign and_2877 = and_559_s1_q & (equal_2503_s1_q & equal_2608);
  // hls/stages/registration.hpp:128
  logic and_2878;
  assign and_2878 = and_2504_s1_q & and_2877;
  // hls/stages/registration.hpp:127
  logic and_2880;
  assign and_2880 = and_2504_s1_q & (~and_2877);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2881;
  assign select_2881 = and_2880 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2883;
  assign select_2883 = and_2878 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2881[15]}}, select_2881});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2884;
  assign select_2884 = and_2880 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2884[15]}}, select_2884};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2886;
  assign select_2886 = and_2878 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:150
  logic and_2887;
  assign and_2887 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2887 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:191
  logic select_3130;
  assign select_3130 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/agreement.hpp:276
  logic [11:0] select_3133;
  assign select_3133 = equal_1790_s1_q ? patches_smooth_values_0_q : (or_1794_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3135;
  assign select_3135 = or_1794_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3137;
  assign select_3137 = equal_1788_s1_q ? patches_smooth_values_1_q : (equal_1790_s1_q ? patches_smooth_values_1_q : select_3135);
  logic [11:0] select_3138;
  assign select_3138 = or_1794_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3140;
  assign select_3140 = equal_1788_s1_q ? patches_smooth_values_2_q : (equal_1790_s1_q ? patches_smooth_values_2_q : select_3138);
  logic [11:0] select_3141;
  assign select_3141 = or_1794_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3143;
  assign select_3143 = equal_1788_s1_q ? patches_smooth_values_3_q : (equal_1790_s1_q ? patches_smooth_values_3_q : select_3141);
  logic [10:0] select_3145;
  assign select_3145 = equal_1790_s1_q ? patches_down_values_0_q : (or_1794_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3148;
  assign select_3148 = equal_1790_s1_q ? patches_down_values_1_q : (or_1794_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3151;
  assign select_3151 = equal_1790_s1_q ? patches_down_values_2_q : (or_1794_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3154;
  assign select_3154 = equal_1790_s1_q ? patches_down_values_3_q : (or_1794_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:177
  logic and_3191;
  assign and_3191 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:422
  logic [4:0] select_3196;
  assign select_3196 = or_3091_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:424
  logic [3:0] select_3198;
  assign select_3198 = and_3191 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3554;
  assign select_3554 = equal_1788_s1_q ? patches_summed_down_by_q : (equal_1790_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  logic select_3572;
  assign select_3572 = equal_1788_s1_q ? (less_1973 & (equal_1975 & or_1976)) : patches_read_searches_q;
  // hls/stages/agreement.hpp:206
  logic [8:0] select_3874;
  assign select_3874 = so_s1_q ? (and_2887 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3876;
  assign sum_3876 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3877;
  assign select_3877 = sum_2006[5] ? {1'b1, sum_2006[4:0], region_across_rest_q[2:0]} : sum_3876;
  // hls/stages/agreement.hpp:465
  logic [7:0] select_3879;
  assign select_3879 = equal_2503_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3882;
  assign select_3882 = equal_2503_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  // hls/stages/agreement.hpp:1165
  logic equal_3934;
  assign equal_3934 = x_s1_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:279
  logic and_4109;
  assign and_4109 = (~drew_q) & (done_q | said_q);
  // hls/stages/agreement.hpp:1306
  logic select_4112;
  assign select_4112 = sample_pair_first_q ? done_q : proven_q;
  // hls/stages/agreement.hpp:279
  logic select_4114;
  assign select_4114 = sample_pair_first_q ? done_q : (sample_pair_whole_q ? select_4112 : proven_q);

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:238; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_524_s1_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_533;
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
  assign census_memory_re = s1_en & and_559_s1_q;
`endif
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory moments_memory, 3290 x 4, DISTANCE 16, hls/stages/moments.hpp:155; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [11:0] moments_memory_raddr;
  assign moments_memory_raddr = address;
`ifndef SYNTHESIS
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_602;
`endif
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1409; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_591_s1_q ? select_636 : right_s1_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s1_en & select_627_s1_q;
`endif
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1410; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign shown_right_re = s1_en & and_1590;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1411; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign left_turns_re = s1_en & and_1607;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1411; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [5:0] right_turns_raddr;
  assign right_turns_raddr = select_636;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s1_en & and_1607;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:811; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1897, not_1892, select_1891};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1898;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:812; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign patches_left_codes_re = s1_en & (not_1789_s1_q & (new_row & equal_1790_s1_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:826; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
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
  assign patches_rows_re = s1_en & (equal_1788_s1_q & (less_1973 & or_1976));
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1440; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign seen_columns_re = s1_en & and_1590;
`endif
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_665_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_767, left_rdata_q[65:49], and_766, left_rdata_q[47:31], and_765, left_rdata_q[29:13], and_764, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_665_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_773, right_codes_rdata_q[84:73], and_772, right_codes_rdata_q[71:60], and_771, right_codes_rdata_q[56:43], and_770, right_codes_rdata_q[41:28], and_769, right_codes_rdata_q[26:13], and_768, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_1879_s1_q;
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
      moments_other_field_second_q <= 1'b0;
      row_q <= 6'h0;
      lower_half_q <= 1'b0;
      late_q <= 1'b0;
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
      patches_bands_chosen_q <= 5'h0;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 7'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 8'h0;
      columns_begin_back_q <= 7'h0;
      done_q <= 1'b0;
      proven_q <= 1'b0;
      drew_q <= 1'b0;
      said_q <= 1'b0;
    end else if (s1_en) begin
      moments_place_q <= select_582;
      moments_taken_q <= not_587 & (not_589 & (equal_590_s1_q & inside_v));
      moments_starts_q <= not_587 & (not_589 & (equal_590_s1_q & (inside_v & first)));
      moments_other_field_second_q <= select_2388;
      row_q <= and_559_s1_q ? (equal_2503_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_559_s1_q ? select_2600 : lower_half_q;
      late_q <= select_2607;
      registration_slope_row_q <= select_2883;
      registration_slope_change_q <= select_2886;
      registration_slope_q <= so_s1_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3115_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3115_s1_q & select_3130;
      patches_smooth_values_0_q <= equal_1788_s1_q ? patches_smooth_values_0_q : select_3133;
      patches_smooth_values_1_q <= select_3137;
      patches_smooth_values_2_q <= select_3140;
      patches_smooth_values_3_q <= select_3143;
      patches_down_values_0_q <= equal_1788_s1_q ? patches_down_values_0_q : select_3145;
      patches_down_values_1_q <= equal_1788_s1_q ? patches_down_values_1_q : select_3148;
      patches_down_values_2_q <= equal_1788_s1_q ? patches_down_values_2_q : select_3151;
      patches_down_values_3_q <= equal_1788_s1_q ? patches_down_values_3_q : select_3154;
      patches_down_by_q <= or_3091_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3191});
      patches_along_q <= select_3196;
      patches_match_row_q <= or_3091_s1_q ? 4'h0 : select_3198;
      patches_summed_last_q <= not_1789_s1_q & (equal_1790_s1_q & and_3191);
      patches_summed_down_by_q <= select_3554;
      patches_step_q <= or_3091_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3572;
      patches_bands_chosen_q <= equal_586_s1_q ? select_1806 : patches_bands_chosen_q;
      region_across_rest_q <= select_3874;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3877;
      columns_begin_rest_q <= and_559_s1_q ? select_3879 : columns_begin_rest_q;
      columns_begin_back_q <= and_559_s1_q ? select_3882 : columns_begin_back_q;
      done_q <= sample_pair_whole_q ? (not_2069 & and_4109) : and_4109;
      proven_q <= sample_pair_whole_q ? select_4114 : proven_q;
      drew_q <= so_s1_q;
      said_q <= equal_586_s1_q & equal_3934;
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
  logic done_s2_q;
  logic proven_s2_q;
  logic [2:0] select_520_s2_q;
  logic row_starts_s2_q;
  logic [7:0] select_524_s2_q;
  logic and_532_s2_q;
  logic and_533_s2_q;
  logic equal_538_s2_q;
  logic [5:0] select_553_s2_q;
  logic [5:0] last_s2_2_q;
  logic and_557_s2_q;
  logic and_559_s2_q;
  logic equal_579_s2_q;
  logic [11:0] address_s2_q;
  logic equal_586_s2_q;
  logic not_587_s2_q;
  logic not_589_s2_q;
  logic equal_590_s2_q;
  logic or_591_s2_q;
  logic less_594_s2_q;
  logic not_595_s2_q;
  logic inside_v_s2_q;
  logic not_598_s2_q;
  logic and_602_s2_q;
  logic and_618_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] right_s2_q;
  logic and_650_s2_q;
  logic and_653_s2_q;
  logic and_659_s2_q;
  logic and_661_s2_q;
  logic equal_694_s2_q;
  logic [5:0] column_s2_q;
  logic [5:0] select_1273_s2_q;
  logic [5:0] select_1522_s2_q;
  logic and_1577_s2_q;
  logic equal_1578_s2_q;
  logic and_1588_s2_q;
  logic and_1590_s2_q;
  logic [5:0] select_1594_s2_q;
  logic or_1598_s2_q;
  logic and_1701_s2_q;
  logic less_1715_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1788_s2_q;
  logic equal_1790_s2_q;
  logic equal_1793_s2_q;
  logic or_1794_s2_q;
  logic not_1795_s2_q;
  logic equal_1805_s2_q;
  logic [4:0] select_1823_s2_q;
  logic select_1829_s2_q;
  logic [3:0] select_1869_s2_q;
  logic less_1885_s2_q;
  logic new_row_s2_q;
  logic or_1898_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_1915_s2_q;
  logic or_1921_s2_q;
  logic and_1925_s2_q;
  logic and_1941_s2_q;
  logic and_1944_s2_q;
  logic and_1958_s2_q;
  logic and_1967_s2_q;
  logic and_1972_s2_q;
  logic less_1973_s2_q;
  logic equal_1974_s2_q;
  logic or_1976_s2_q;
  logic and_1985_s2_q;
  logic select_1987_s2_q;
  logic and_1990_s2_q;
  logic sum_2006_s2_q;
  logic not_2017_s2_q;
  logic and_2031_s2_q;
  logic not_2069_s2_q;
  logic less_2150_s2_q;
  logic equal_2304_s2_q;
  logic equal_2503_s2_q;
  logic and_2609_s2_q;
  logic and_2640_s2_q;
  logic equal_2729_s2_q;
  logic less_3167_s2_q;
  logic equal_3510_s2_q;
  logic equal_3607_s2_q;
  logic less_3862_s2_q;
  logic equal_3934_s2_q;
  logic or_4092_s2_q;
  logic and_4166_s2_q;
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
      done_s2_q <= done_q;
      proven_s2_q <= proven_q;
      select_520_s2_q <= select_520_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_524_s2_q <= select_524_s1_q;
      and_532_s2_q <= and_532_s1_q;
      and_533_s2_q <= and_533;
      equal_538_s2_q <= equal_538_s1_q;
      select_553_s2_q <= select_553_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_557_s2_q <= and_557_s1_q;
      and_559_s2_q <= and_559_s1_q;
      equal_579_s2_q <= equal_579;
      address_s2_q <= address;
      equal_586_s2_q <= equal_586_s1_q;
      not_587_s2_q <= not_587;
      not_589_s2_q <= not_589;
      equal_590_s2_q <= equal_590_s1_q;
      or_591_s2_q <= or_591_s1_q;
      less_594_s2_q <= less_594_s1_q;
      not_595_s2_q <= not_595_s1_q;
      inside_v_s2_q <= inside_v;
      not_598_s2_q <= not_598;
      and_602_s2_q <= and_602;
      and_618_s2_q <= (or_591_s1_q & (left_rdata_q[68] & not_595_s1_q)) & and_617;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_650_s2_q <= (or_591_s1_q & (left_rdata_q[70] & not_595_s1_q)) & less_649;
      and_653_s2_q <= or_591_s1_q & (left_rdata_q[71] & not_595_s1_q);
      and_659_s2_q <= and_659;
      and_661_s2_q <= or_591_s1_q & (right_codes_rdata_q[59] & not_595_s1_q);
      equal_694_s2_q <= row_s1_q == 6'h0;
      column_s2_q <= column;
      select_1273_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1522_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1577_s2_q <= and_1577_s1_q;
      equal_1578_s2_q <= equal_1578_s1_q;
      and_1588_s2_q <= and_1588;
      and_1590_s2_q <= and_1590;
      select_1594_s2_q <= select_1594;
      or_1598_s2_q <= or_1598;
      and_1701_s2_q <= and_1701_s1_q;
      less_1715_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1788_s2_q <= equal_1788_s1_q;
      equal_1790_s2_q <= equal_1790_s1_q;
      equal_1793_s2_q <= equal_1793_s1_q;
      or_1794_s2_q <= or_1794_s1_q;
      not_1795_s2_q <= not_1795_s1_q;
      equal_1805_s2_q <= equal_1805;
      select_1823_s2_q <= select_1823_s1_q;
      select_1829_s2_q <= select_1829_s1_q;
      select_1869_s2_q <= select_1869_s1_q;
      less_1885_s2_q <= less_1885;
      new_row_s2_q <= new_row;
      or_1898_s2_q <= or_1898;
      of_row_2_s2_q <= of_row_2;
      not_1915_s2_q <= ~sum_1914[14];
      or_1921_s2_q <= or_1921;
      and_1925_s2_q <= sum_1914[14] & (~(sum_1914[13:8] == 6'h3f));
      and_1941_s2_q <= (~difference_1933[14]) & or_1940;
      and_1944_s2_q <= difference_1933[14] & (~(difference_1933[13:8] == 6'h3f));
      and_1958_s2_q <= not_1789_s1_q & and_1957;
      and_1967_s2_q <= and_1967;
      and_1972_s2_q <= not_1789_s1_q & and_1971;
      less_1973_s2_q <= less_1973;
      equal_1974_s2_q <= equal_1974;
      or_1976_s2_q <= or_1976;
      and_1985_s2_q <= sample_pair_whole_q;
      select_1987_s2_q <= left_first_q;
      and_1990_s2_q <= right_q;
      sum_2006_s2_q <= sum_2006[5];
      not_2017_s2_q <= ~late_q;
      and_2031_s2_q <= or_591_s1_q & (left_rdata_q[69] & not_595_s1_q);
      not_2069_s2_q <= not_2069;
      less_2150_s2_q <= 6'h6 < row_q;
      equal_2304_s2_q <= (last_s1_2_q | row_s1_q) == 6'h0;
      equal_2503_s2_q <= equal_2503_s1_q;
      and_2609_s2_q <= and_2609;
      and_2640_s2_q <= or_591_s1_q & (not_595_s1_q & and_617);
      equal_2729_s2_q <= shift == 6'h0;
      less_3167_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3510_s2_q <= patches_match_row_q == 4'h0;
      equal_3607_s2_q <= patches_step_q[6:5] == 2'h3;
      less_3862_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3934_s2_q <= equal_3934;
      or_4092_s2_q <= and_2609 | (~(row_s1_q[5:3] == 3'h0));
      and_4166_s2_q <= less_2602 & select_4112;
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
  logic [13:0] moments_other_field_before_0_q;
  logic [13:0] moments_other_field_before_1_q;
  logic moments_other_field_has_before_q;
  logic moments_other_field_out_of_step_q;
  logic moments_ended_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic [4:0] rows_passed_above_q;
  logic draws_late_q;
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
  logic [9:0] patches_peak_size_q;
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
  logic [11:0] select_536;
  assign select_536 = select_520_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:129
  logic [11:0] sum_540;
  assign sum_540 = select_536 + (equal_538_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:117
  logic [11:0] sum_542;
  assign sum_542 = {4'h0, sample_pair_pixel_1_q} + (select_520_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:129
  logic [11:0] sum_544;
  assign sum_544 = sum_542 + (equal_538_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:423
  logic whole;
  assign whole = select_520_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_548;
  assign and_548 = whole & (averager_memory_rdata_q[24] | equal_538_s2_q);
  // hls/stages/agreement.hpp:423
  logic all_of_skin;
  assign all_of_skin = select_520_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:131
  logic and_552;
  assign and_552 = all_of_skin & (averager_memory_rdata_q[25] | equal_538_s2_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_532_s2_q ? sum_540[11:3] : 9'h0;
  // hls/stages/census.hpp:134
  logic equal_562;
  assign equal_562 = select_520_s2_q == 3'h1;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_562 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_565;
  assign select_565 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_532_s2_q ? sum_544[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_562 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_569;
  assign select_569 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_570;
  assign and_570 = and_532_s2_q & and_548;
  // hls/stages/census.hpp:134
  logic select_572;
  assign select_572 = equal_562 ? and_570 : (averager_mask_q & and_570);
  // hls/stages/agreement.hpp:277
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_572;
  // hls/stages/census.hpp:218
  logic and_574;
  assign and_574 = and_532_s2_q & and_552;
  // hls/stages/census.hpp:134
  logic select_576;
  assign select_576 = equal_562 ? and_574 : (averager_of_skin_q & and_574);
  // hls/stages/agreement.hpp:277
  logic and_577;
  assign and_577 = sample_pair_whole_s2_q & select_576;
  // hls/stages/agreement.hpp:989
  logic select_631;
  assign select_631 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:990
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:1003
  logic [8:0] difference_641;
  assign difference_641 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:1004
  logic [9:0] sum_642;
  assign sum_642 = {difference_641[8], difference_641} + 10'h1;
  // hls/stages/agreement.hpp:248
  logic and_644;
  assign and_644 = (and_618_s2_q & select_631) & ({{22{sum_642[9]}}, sum_642} < 32'h3);
  // hls/stages/agreement.hpp:150
  logic and_646;
  assign and_646 = or_591_s2_q & (not_595_s2_q & and_644);
  // hls/stages/moments.hpp:89
  logic and_651;
  assign and_651 = and_646 & and_650_s2_q;
  // hls/stages/census.hpp:308
  logic less_667;
  assign less_667 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_668;
  assign less_668 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_669;
  assign less_669 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_670;
  assign less_670 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_671;
  assign less_671 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_672;
  assign less_672 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_673;
  assign less_673 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_674;
  assign less_674 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_675;
  assign less_675 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_676;
  assign less_676 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_677;
  assign less_677 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_678;
  assign less_678 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_679;
  assign less_679 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_680;
  assign less_680 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_681;
  assign less_681 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_682;
  assign less_682 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_683;
  assign less_683 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_684;
  assign less_684 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_685;
  assign less_685 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_686;
  assign less_686 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_687;
  assign less_687 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_688;
  assign less_688 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_689;
  assign less_689 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_690;
  assign less_690 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:460
  logic equal_691;
  assign equal_691 = last_s2_2_q == 6'h0;
  logic [3:0] select_695;
  assign select_695 = equal_694_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:461
  logic [4:0] select_696;
  assign select_696 = equal_691 ? {select_695, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_697;
  assign select_697 = equal_691 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:313
  logic and_698;
  assign and_698 = select_696[4] & select_697[3];
  // hls/stages/census.hpp:300
  logic and_700;
  assign and_700 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_702;
  assign and_702 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_700);
  // hls/stages/agreement.hpp:461
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_702;
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
  logic [9:0] difference_725;
  assign difference_725 = {1'b0, select_565} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_726;
  assign xor_726 = difference_725[8:0] ^ {9{difference_725[9]}};
  logic [9:0] sum_727;
  assign sum_727 = {9'h0, difference_725[9]} + {1'b0, xor_726};
  logic [9:0] difference_728;
  assign difference_728 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_729;
  assign xor_729 = difference_728[8:0] ^ {9{difference_728[9]}};
  logic [9:0] sum_730;
  assign sum_730 = {9'h0, difference_728[9]} + {1'b0, xor_729};
  logic [9:0] difference_732;
  assign difference_732 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_733;
  assign xor_733 = difference_732[8:0] ^ {9{difference_732[9]}};
  logic [9:0] sum_734;
  assign sum_734 = {9'h0, difference_732[9]} + {1'b0, xor_733};
  logic [10:0] sum_735;
  assign sum_735 = ({1'b0, sum_727} + {1'b0, sum_730}) + {1'b0, sum_734};
  logic [9:0] difference_736;
  assign difference_736 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_737;
  assign xor_737 = difference_736[8:0] ^ {9{difference_736[9]}};
  logic [9:0] sum_738;
  assign sum_738 = {9'h0, difference_736[9]} + {1'b0, xor_737};
  logic [9:0] difference_740;
  assign difference_740 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_741;
  assign xor_741 = difference_740[8:0] ^ {9{difference_740[9]}};
  // hls/stages/agreement.hpp:461
  logic and_749;
  assign and_749 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_750;
  assign and_750 = and_698 & and_749;
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:33
  logic [6:0] sum_752;
  assign sum_752 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:320
  logic and_754;
  assign and_754 = and_750 & ({{5{sum_752[6]}}, sum_752, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:33
  logic [6:0] sum_758;
  assign sum_758 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:818
  logic or_775;
  assign or_775 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:819
  logic select_777;
  assign select_777 = or_775 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:789
  logic [5:0] select_1024;
  assign select_1024 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1025;
  assign difference_1025 = {1'b0, column_s2_q} - {1'b0, select_1024};
  logic [7:0] sum_1027;
  assign sum_1027 = {difference_1025[6], difference_1025} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:766
  logic [7:0] select_1028;
  assign select_1028 = slot_s2_q[0] ? chosen_score_q : sum_1027;
  // hls/stages/agreement.hpp:789
  logic [6:0] difference_1274;
  assign difference_1274 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1273_s2_q};
  // hls/stages/agreement.hpp:760
  logic equal_1275;
  assign equal_1275 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:789
  logic [7:0] sum_1277;
  assign sum_1277 = {difference_1274[6], difference_1274} + (equal_1275 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1523;
  assign difference_1523 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1522_s2_q};
  logic [7:0] sum_1525;
  assign sum_1525 = {difference_1523[6], difference_1523} + (equal_1275 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:762
  logic less_1526;
  assign less_1526 = sum_1277 < sum_1525;
  logic [7:0] select_1527;
  assign select_1527 = less_1526 ? sum_1525 : sum_1277;
  logic less_1528;
  assign less_1528 = select_1028 < select_1527;
  // hls/stages/agreement.hpp:812
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1528 ? select_1527 : select_1028) : 8'h0;
  // hls/stages/agreement.hpp:819
  logic or_1532;
  assign or_1532 = select_777 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:824
  logic [5:0] select_1533;
  assign select_1533 = or_1532 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:731
  logic not_1534;
  assign not_1534 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:763
  logic [1:0] select_1535;
  assign select_1535 = less_1526 ? {slot_s2_q[0], not_1534} : 2'h0;
  logic [2:0] select_1537;
  assign select_1537 = less_1528 ? {select_1535, not_1534} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:824
  logic [2:0] select_1538;
  assign select_1538 = or_1532 ? select_1537 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1539;
  assign select_1539 = or_1532 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:821
  logic equal_1540;
  assign equal_1540 = select_1537 == 3'h1;
  logic or_1543;
  assign or_1543 = equal_1540 | (~(select_1537 == 3'h2));
  logic [7:0] select_1545;
  assign select_1545 = or_1543 ? before_0_q : before_1_q;
  logic [7:0] select_1546;
  assign select_1546 = equal_1540 ? (or_1543 ? sum_1277 : {7'h0, shift_not_right_q}) : select_1545;
  // hls/stages/agreement.hpp:824
  logic [7:0] select_1547;
  assign select_1547 = or_1532 ? select_1546 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1550;
  assign select_1550 = or_1532 ? (equal_1540 ? select_1545 : (or_1543 ? sum_1525 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_1552;
  assign sum_1552 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1553;
  assign sum_1553 = {1'b0, before_v} + sum_1552;
  // hls/stages/agreement.hpp:766
  logic [6:0] select_1554;
  assign select_1554 = slot_s2_q[0] ? chosen_near_q : sum_1553;
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_1556;
  assign sum_1556 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1557;
  assign sum_1557 = {1'b0, before_v_2} + sum_1556;
  // hls/stages/agreement.hpp:790
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:791
  logic [6:0] sum_1559;
  assign sum_1559 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1560;
  assign sum_1560 = {1'b0, before_v_3} + sum_1559;
  // hls/stages/agreement.hpp:762
  logic [6:0] select_1562;
  assign select_1562 = (sum_1557 < sum_1560) ? sum_1560 : sum_1557;
  // hls/stages/agreement.hpp:813
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1554 < select_1562) ? select_1562 : select_1554) : 7'h0;
  // hls/stages/agreement.hpp:824
  logic less_1566;
  assign less_1566 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:828
  logic [6:0] select_1568;
  assign select_1568 = select_777 ? of_near : (less_1566 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1570;
  assign select_1570 = select_777 ? run_shift_s2_q : (less_1566 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1573;
  assign select_1573 = (run_shift_s2_q == 6'h3f) ? of_best : (select_777 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:829
  logic [7:0] select_1576;
  assign select_1576 = (run_shift_s2_q == 6'h1) ? of_best : (select_777 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:834
  logic select_1579;
  assign select_1579 = or_775 ? shift_first_s2_q : equal_1578_s2_q;
  // hls/stages/agreement.hpp:835
  logic or_1581;
  assign or_1581 = select_1579 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:839
  logic [7:0] select_1582;
  assign select_1582 = or_1581 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1583;
  assign select_1583 = or_1581 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1585;
  assign or_1585 = select_1579 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:843
  logic [6:0] select_1586;
  assign select_1586 = or_1585 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1587;
  assign select_1587 = or_1585 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:150
  logic and_1601;
  assign and_1601 = or_591_s2_q & (not_595_s2_q & (and_644 & or_1598_s2_q));
  // hls/stages/agreement.hpp:799
  logic and_1602;
  assign and_1602 = not_589_s2_q & and_1601;
  logic and_1605;
  assign and_1605 = not_587_s2_q & (drew_q ? and_1588_s2_q : (equal_590_s2_q & and_646));
  // hls/stages/moments.hpp:85
  logic and_1609;
  assign and_1609 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1016
  logic and_1610;
  assign and_1610 = not_598_s2_q & and_1609;
  logic and_1613;
  assign and_1613 = not_598_s2_q & (and_1609 & (moments_memory_rdata_q[1] ^ and_653_s2_q));
  // hls/stages/moments.hpp:85
  logic and_1618;
  assign and_1618 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1016
  logic and_1619;
  assign and_1619 = not_598_s2_q & and_1618;
  logic and_1622;
  assign and_1622 = not_598_s2_q & (and_1618 & (moments_memory_rdata_q[3] ^ and_661_s2_q));
  // hls/stages/agreement.hpp:1145
  logic equal_1623;
  assign equal_1623 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1208
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1146
  logic [1:0] select_1626;
  assign select_1626 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1159
  logic [3:0] select_1628;
  assign select_1628 = equal_1623 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1626});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1629;
  assign sum_1629 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:799
  logic [3:0] select_1630;
  assign select_1630 = equal_586_s2_q ? select_1628 : {sum_1629, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:217
  logic equal_1631;
  assign equal_1631 = x_s2_q[5:0] == 6'h3f;
  logic equal_1633;
  assign equal_1633 = x_s2_q[5:0] == 6'h3e;
  logic equal_1635;
  assign equal_1635 = x_s2_q[5:0] == 6'h3d;
  logic equal_1637;
  assign equal_1637 = x_s2_q[5:0] == 6'h3c;
  logic equal_1639;
  assign equal_1639 = x_s2_q[5:0] == 6'h3b;
  logic equal_1641;
  assign equal_1641 = x_s2_q[5:0] == 6'h36;
  logic equal_1643;
  assign equal_1643 = x_s2_q[5:0] == 6'h35;
  logic equal_1645;
  assign equal_1645 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1208
  logic and_1649;
  assign and_1649 = (~equal_1639) & ((~equal_1641) & ((~equal_1643) & (~equal_1645)));
  logic and_1653;
  assign and_1653 = (~equal_1631) & ((~equal_1633) & ((~equal_1635) & ((~equal_1637) & and_1649)));
  // hls/stages/agreement.hpp:1146
  logic less_1654;
  assign less_1654 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1658;
  assign or_1658 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1023
  logic [4:0] sum_1663;
  assign sum_1663 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:263
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1663, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1669;
  assign sum_1669 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1671;
  assign and_1671 = half_ends & ({{3{sum_1669[4]}}, sum_1669} < 8'h3);
  // hls/stages/agreement.hpp:799
  logic and_1672;
  assign and_1672 = drew_q & and_1671;
  logic select_1673;
  assign select_1673 = equal_586_s2_q ? (x_s2_q[6] & (equal_1623 ? and_1653 : (less_1654 & (~or_1658)))) : and_1672;
  // hls/stages/registration.hpp:258
  logic not_1675;
  assign not_1675 = ~lower_half_s2_q;
  logic [3:0] select_1676;
  assign select_1676 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1675, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1675};
  // hls/stages/patches.hpp:382
  logic [1:0] select_1702;
  assign select_1702 = and_1701_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1703;
  assign select_1703 = and_1701_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] select_1704;
  assign select_1704 = row_starts_s2_q ? {select_1703, select_1702[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1705;
  assign select_1705 = row_starts_s2_q ? select_1702 : patches_fetch_q;
  logic equal_1706;
  assign equal_1706 = select_1705 == 2'h0;
  // hls/stages/agreement.hpp:1032
  logic [6:0] sum_1710;
  assign sum_1710 = x_s2_q[7:1] + 7'h7f;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < {sum_1710, x_s2_q[0]};
  // hls/stages/agreement.hpp:799
  logic and_1714;
  assign and_1714 = not_587_s2_q & (drew_q & (ends_cell_s2_q & right_3));
  // hls/stages/registration.hpp:83
  logic equal_1716;
  assign equal_1716 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:150
  logic [5:0] b;
  assign b = or_591_s2_q ? (less_594_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1716 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1724;
  assign select_1724 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_1725;
  assign select_1725 = b[1] ? a : 8'h0;
  logic [8:0] sum_1726;
  assign sum_1726 = {{2{select_1724[6]}}, select_1724} + {select_1725[7], select_1725};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1727;
  assign select_1727 = b[2] ? a : 8'h0;
  logic [7:0] select_1728;
  assign select_1728 = b[3] ? a : 8'h0;
  logic [8:0] sum_1729;
  assign sum_1729 = {{2{select_1727[7]}}, select_1727[7:1]} + {select_1728[7], select_1728};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1730;
  assign sum_1730 = {{3{sum_1726[8]}}, sum_1726[8:1]} + {sum_1729[8], sum_1729, select_1727[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1731;
  assign select_1731 = b[4] ? a : 8'h0;
  logic [7:0] select_1732;
  assign select_1732 = b[5] ? a : 8'h0;
  logic [8:0] difference_1733;
  assign difference_1733 = {{2{select_1731[7]}}, select_1731[7:1]} - {select_1732[7], select_1732};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1734;
  assign sum_1734 = {difference_1733, select_1731[0]} + {sum_1730[10], sum_1730[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1716 ? {sum_1734, sum_1730[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1736;
  assign sum_1736 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:263
  logic and_1739;
  assign and_1739 = less_1715_s2_q & (and_646 & ({{4{sum_1736[9]}}, sum_1736, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_1743;
  assign and_1743 = ({4'h0, last_s2_q[5:1]} < ({1'b0, sum_1710, x_s2_q[0]} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:106
  logic or_1747;
  assign or_1747 = ({sum_1710, x_s2_q[0]} == 8'h0) | (~({sum_1710, x_s2_q[0]} < {2'h0, last_s2_q}));
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1750;
  assign sum_1750 = {2'h0, sum_1710, x_s2_q[0]} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1752;
  assign sum_1752 = {sum_1750[9], sum_1750[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1032
  logic and_1755;
  assign and_1755 = ($signed(9'h0) < $signed(sum_1750[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1752, sum_1750[0]})));
  // hls/stages/agreement.hpp:799
  logic and_1758;
  assign and_1758 = ends_cell_s2_q & (and_1739 & ((~(and_1743 | or_1747)) & and_1755));
  logic and_1760;
  assign and_1760 = not_587_s2_q & (drew_q & and_1758);
  // hls/stages/patches.hpp:157
  logic and_1762;
  assign and_1762 = and_1760 & (~patches_fixed_q);
  // hls/stages/patches.hpp:351
  logic select_1763;
  assign select_1763 = and_1762 ? and_1760 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:799
  logic [7:0] select_1766;
  assign select_1766 = equal_586_s2_q ? 8'h0 : (drew_q ? (ends_cell_s2_q ? {sum_1710, x_s2_q[0]} : 8'h0) : 8'h0);
  logic [5:0] select_1770;
  assign select_1770 = equal_586_s2_q ? 6'h0 : (drew_q ? (ends_cell_s2_q ? b : 6'h0) : 6'h0);
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1772;
  assign sum_1772 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_1734[9]}}, sum_1734[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1775;
  assign select_1775 = ($signed(sum_1772[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1772[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1716 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1772[12:7])) ? 8'h7f : select_1775);
  // hls/stages/agreement.hpp:799
  logic [7:0] select_1780;
  assign select_1780 = equal_586_s2_q ? 8'h0 : (drew_q ? (ends_cell_s2_q ? slope : 8'h0) : 8'h0);
  // hls/stages/patches.hpp:113
  logic equal_1782;
  assign equal_1782 = {sum_1710[6:5], last_s2_q[5:1], x_s2_q[0]} == {2'h0, sum_1710[4:0], last_s2_q[0]};
  // hls/stages/agreement.hpp:799
  logic and_1786;
  assign and_1786 = not_587_s2_q & (drew_q & (ends_cell_s2_q & (and_1743 | equal_1782)));
  // hls/stages/patches.hpp:351
  logic and_1787;
  assign and_1787 = patches_chooses_s2_q & and_1786;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1801;
  assign select_1801 = row_starts_s2_q ? select_1703 : patches_band_q;
  // hls/stages/patches.hpp:360
  logic equal_1802;
  assign equal_1802 = {patches_choosing_band_s2_q, and_1714} == {select_1801, select_1705[1]};
  // hls/stages/patches.hpp:495
  logic [2:0] sum_1906;
  assign sum_1906 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:462
  logic and_1922;
  assign and_1922 = not_1915_s2_q & or_1921_s2_q;
  // hls/stages/patches.hpp:499
  logic [1:0] sum_1962;
  assign sum_1962 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:206
  logic [7:0] select_1993;
  assign select_1993 = drew_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1066
  logic or_1996;
  assign or_1996 = select_1993[7] | (~({select_1993[5], select_1993[3], select_1993[1]} == 3'h0));
  // hls/stages/agreement.hpp:1065
  logic or_1999;
  assign or_1999 = select_1993[7] | (~({select_1993[6], select_1993[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1064
  logic or_2002;
  assign or_2002 = select_1993[7] | (~(select_1993[6:4] == 3'h0));
  // hls/stages/agreement.hpp:799
  logic [5:0] select_2003;
  assign select_2003 = equal_586_s2_q ? x_s2_q[5:0] : {region_row_q, or_2002, or_1999, or_1996};
  // hls/stages/agreement.hpp:1145
  logic not_2004;
  assign not_2004 = ~equal_1623;
  // hls/stages/agreement.hpp:1072
  logic equal_2008;
  assign equal_2008 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:1074
  logic or_2009;
  assign or_2009 = (~sum_2006_s2_q) | equal_2008;
  // hls/stages/agreement.hpp:799
  logic and_2012;
  assign and_2012 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & or_2009));
  // hls/stages/agreement.hpp:150
  logic and_2016;
  assign and_2016 = or_591_s2_q & (not_595_s2_q & and_618_s2_q);
  logic and_2033;
  assign and_2033 = or_591_s2_q & (not_595_s2_q & and_2031_s2_q);
  // hls/stages/agreement.hpp:263
  logic textured;
  assign textured = inside_v_s2_q & and_2016;
  logic and_2044;
  assign and_2044 = inside_v_s2_q & and_2033;
  logic explained;
  assign explained = inside_v_s2_q & and_646;
  // hls/stages/agreement.hpp:1028
  logic select_2046;
  assign select_2046 = slot_s2_q[2] ? shown_shown_q : and_646;
  // hls/stages/agreement.hpp:263
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2046);
  // hls/stages/agreement.hpp:1028
  logic select_2049;
  assign select_2049 = slot_s2_q[2] ? shown_nearer_q : and_1601;
  // hls/stages/agreement.hpp:263
  logic near;
  assign near = inside_v_s2_q & (select_2046 ? select_2049 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1302
  logic select_2052;
  assign select_2052 = done_s2_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1306
  logic select_2053;
  assign select_2053 = left_first_s2_q ? select_2052 : read_half_q;
  logic or_2054;
  assign or_2054 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1307
  logic [8:0] select_2055;
  assign select_2055 = or_2054 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1308
  logic [9:0] select_2057;
  assign select_2057 = left_first_s2_q ? 10'h1 : (or_2054 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1311
  logic and_2058;
  assign and_2058 = select_2055[8] & select_2057[9];
  // hls/stages/agreement.hpp:441
  logic next_row;
  assign next_row = and_2058 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1322
  logic [5:0] select_2061;
  assign select_2061 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2063;
  assign select_2063 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2061});
  // hls/stages/agreement.hpp:1333
  logic equal_2064;
  assign equal_2064 = seen_x_q == 3'h7;
  logic [7:0] select_2066;
  assign select_2066 = and_2058 ? 8'h0 : (seen_column_q + {7'h0, equal_2064});
  // hls/stages/agreement.hpp:1340
  logic [10:0] index;
  assign index = select_2063 + {3'h0, select_2066};
  // hls/stages/agreement.hpp:1292
  logic [11:0] sum_2068;
  assign sum_2068 = {1'b0, {2{select_2053}}, 2'h0, {2{select_2053}}, 1'b0, {2{select_2053}}, 1'b0, select_2053} + {1'b0, index};
  // hls/stages/agreement.hpp:441
  logic and_2071;
  assign and_2071 = not_2069_s2_q & (began_q | and_2058);
  // hls/stages/agreement.hpp:1334
  logic [2:0] select_2073;
  assign select_2073 = and_2058 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1339
  logic and_2075;
  assign and_2075 = and_2071 & (select_2073 == 3'h0);
  logic less_2076;
  assign less_2076 = select_2066 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:443
  logic and_2077;
  assign and_2077 = and_2075 & less_2076;
  logic and_2078;
  assign and_2078 = and_1985_s2_q & and_2077;
  // hls/stages/agreement.hpp:279
  logic select_2080;
  assign select_2080 = and_1985_s2_q ? (left_first_s2_q ? and_2077 : and_2078) : and_2078;
  // hls/stages/agreement.hpp:1128
  logic select_2082;
  assign select_2082 = draws_late_q ? read_half_q : write_half_q;
  logic [7:0] sum_2083;
  assign sum_2083 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2083[7], sum_2083, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1292
  logic [11:0] sum_2085;
  assign sum_2085 = {1'b0, {2{select_2082}}, 2'h0, {2{select_2082}}, 1'b0, {2{select_2082}}, 1'b0, select_2082} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1045
  logic and_2086;
  assign and_2086 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2087;
  assign and_2087 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2088;
  assign and_2088 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2089;
  assign and_2089 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1103
  logic [1:0] sum_2091;
  assign sum_2091 = {1'b0, and_2088} + ({1'b0, textured} + {1'b0, and_2089});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2086} + ({2'h0, and_2087} + {1'b0, sum_2091});
  // hls/stages/agreement.hpp:1045
  logic [7:0] select_2100;
  assign select_2100 = inside_v_s2_q ? (sum_2006_s2_q ? select_1993 : {select_1993[6:0], 1'b0}) : select_1993;
  // hls/stages/agreement.hpp:1066
  logic or_2103;
  assign or_2103 = select_2100[7] | (~({select_2100[5], select_2100[3], select_2100[1]} == 3'h0));
  // hls/stages/agreement.hpp:1045
  logic and_2120;
  assign and_2120 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2121;
  assign and_2121 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2122;
  assign and_2122 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2123;
  assign and_2123 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1105
  logic [1:0] sum_2125;
  assign sum_2125 = {1'b0, and_2122} + ({1'b0, shown} + {1'b0, and_2123});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2120} + ({2'h0, and_2121} + {1'b0, sum_2125});
  // hls/stages/agreement.hpp:1045
  logic and_2136;
  assign and_2136 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2137;
  assign and_2137 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2138;
  assign and_2138 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2139;
  assign and_2139 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1106
  logic [1:0] sum_2141;
  assign sum_2141 = {1'b0, and_2138} + ({1'b0, near} + {1'b0, and_2139});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2136} + ({2'h0, and_2137} + {1'b0, sum_2141});
  // hls/stages/agreement.hpp:1127
  logic not_2152;
  assign not_2152 = ~(x_s2_q[7:2] == 6'h0);
  // hls/stages/agreement.hpp:1128
  logic not_2154;
  assign not_2154 = ~({1'b0, sum_1663, last_s2_q[1:0]} < x_s2_q);
  // hls/stages/agreement.hpp:799
  logic select_2158;
  assign select_2158 = less_2150_s2_q ? (not_2152 & not_2154) : ((draws_late_q & not_2152) & not_2154);
  logic and_2161;
  assign and_2161 = not_587_s2_q & (drew_q & (ends_cell_s2_q & select_2158));
  // hls/stages/agreement.hpp:277
  logic [10:0] select_2195;
  assign select_2195 = sample_pair_whole_s2_q ? (and_557_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2197;
  assign select_2197 = sample_pair_whole_s2_q ? (and_557_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2217;
  assign select_2217 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2219;
  assign select_2219 = sample_pair_whole_s2_q ? (and_557_s2_q ? select_572 : averager_mask_q) : averager_mask_q;
  logic select_2221;
  assign select_2221 = sample_pair_whole_s2_q ? (and_557_s2_q ? select_576 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:531
  logic [8:0] select_2222;
  assign select_2222 = and_559_s2_q ? select_565 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2223;
  assign select_2223 = and_559_s2_q ? select_569 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2225;
  assign select_2225 = and_559_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2226;
  assign select_2226 = and_559_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2227;
  assign select_2227 = and_559_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2228;
  assign select_2228 = and_559_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2229;
  assign select_2229 = and_559_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2230;
  assign select_2230 = and_559_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2231;
  assign select_2231 = and_559_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2232;
  assign select_2232 = and_559_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2233;
  assign select_2233 = and_559_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2234;
  assign select_2234 = and_559_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2235;
  assign select_2235 = and_559_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2236;
  assign select_2236 = and_559_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2237;
  assign select_2237 = and_559_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2238;
  assign select_2238 = and_559_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2239;
  assign select_2239 = and_559_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2240;
  assign select_2240 = and_559_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2241;
  assign select_2241 = and_559_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2242;
  assign select_2242 = and_559_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2243;
  assign select_2243 = and_559_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2244;
  assign select_2244 = and_559_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2245;
  assign select_2245 = and_559_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2246;
  assign select_2246 = and_559_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2247;
  assign select_2247 = and_559_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2248;
  assign select_2248 = and_559_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2249;
  assign select_2249 = and_559_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2250;
  assign select_2250 = and_559_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2251;
  assign select_2251 = and_559_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2252;
  assign select_2252 = and_559_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2253;
  assign select_2253 = and_559_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2254;
  assign select_2254 = and_559_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2255;
  assign select_2255 = and_559_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2256;
  assign select_2256 = and_559_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2257;
  assign select_2257 = and_559_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2258;
  assign select_2258 = and_559_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2259;
  assign select_2259 = and_559_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2260;
  assign select_2260 = and_559_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2261;
  assign select_2261 = and_559_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2262;
  assign select_2262 = and_559_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2263;
  assign select_2263 = and_559_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2264;
  assign select_2264 = and_559_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2265;
  assign select_2265 = and_559_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2266;
  assign select_2266 = and_559_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2267;
  assign select_2267 = and_559_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2268;
  assign select_2268 = and_559_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2269;
  assign select_2269 = and_559_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2270;
  assign select_2270 = and_559_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2271;
  assign select_2271 = and_559_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2272;
  assign select_2272 = and_559_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2273;
  assign select_2273 = and_559_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2274;
  assign select_2274 = and_559_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2275;
  assign select_2275 = and_559_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2276;
  assign select_2276 = and_559_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2277;
  assign select_2277 = and_559_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2279;
  assign difference_2279 = {1'b0, select_569} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2280;
  assign xor_2280 = difference_2279[8:0] ^ {9{difference_2279[9]}};
  logic [9:0] sum_2281;
  assign sum_2281 = {9'h0, difference_2279[9]} + {1'b0, xor_2280};
  logic [9:0] difference_2282;
  assign difference_2282 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2283;
  assign xor_2283 = difference_2282[8:0] ^ {9{difference_2282[9]}};
  logic [9:0] sum_2284;
  assign sum_2284 = {9'h0, difference_2282[9]} + {1'b0, xor_2283};
  logic [9:0] difference_2286;
  assign difference_2286 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2287;
  assign xor_2287 = difference_2286[8:0] ^ {9{difference_2286[9]}};
  logic [9:0] sum_2288;
  assign sum_2288 = {9'h0, difference_2286[9]} + {1'b0, xor_2287};
  logic [10:0] sum_2289;
  assign sum_2289 = ({1'b0, sum_2281} + {1'b0, sum_2284}) + {1'b0, sum_2288};
  logic [9:0] difference_2290;
  assign difference_2290 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2291;
  assign xor_2291 = difference_2290[8:0] ^ {9{difference_2290[9]}};
  logic [9:0] sum_2292;
  assign sum_2292 = {9'h0, difference_2290[9]} + {1'b0, xor_2291};
  logic [9:0] difference_2294;
  assign difference_2294 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2295;
  assign xor_2295 = difference_2294[8:0] ^ {9{difference_2294[9]}};
  // hls/stages/moments.hpp:65
  logic [13:0] sum_2316;
  assign sum_2316 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2318;
  assign sum_2318 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/moments.hpp:153
  logic [13:0] select_2319;
  assign select_2319 = equal_1805_s2_q ? moments_other_field_before_0_q : moments_before_0_q;
  logic [13:0] select_2321;
  assign select_2321 = equal_1805_s2_q ? moments_other_field_before_1_q : moments_before_1_q;
  logic select_2323;
  assign select_2323 = equal_1805_s2_q ? moments_other_field_has_before_q : moments_has_before_q;
  // hls/stages/agreement.hpp:799
  logic [13:0] select_2327;
  assign select_2327 = equal_586_s2_q ? ((select_2321 < select_2319) ? select_2319 : select_2321) : moments_most_before_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2328;
  assign sum_2328 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:799
  logic select_2331;
  assign select_2331 = equal_586_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2328)) : moments_left_begins_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2332;
  assign sum_2332 = {1'b0, sum_2318} + 15'h3;
  // hls/stages/agreement.hpp:799
  logic select_2335;
  assign select_2335 = equal_586_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2332)) : moments_left_alone_q;
  logic select_2338;
  assign select_2338 = equal_586_s2_q ? (~({3'h0, select_2321[13:2]} < sum_2332)) : moments_left_other_stops_q;
  logic select_2341;
  assign select_2341 = equal_586_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2328)) : moments_right_begins_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2342;
  assign sum_2342 = {1'b0, sum_2316} + 15'h3;
  // hls/stages/agreement.hpp:799
  logic select_2345;
  assign select_2345 = equal_586_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2342)) : moments_right_alone_q;
  logic select_2348;
  assign select_2348 = equal_586_s2_q ? (~({3'h0, select_2319[13:2]} < sum_2342)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:55
  logic out_of_step;
  assign out_of_step = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/moments.hpp:59
  logic select_2352;
  assign select_2352 = moments_ended_q ? moments_other_field_out_of_step_q : out_of_step;
  // hls/stages/agreement.hpp:799
  logic and_2360;
  assign and_2360 = not_587_s2_q & (not_589_s2_q & (equal_590_s2_q & (inside_v_s2_q & and_1613)));
  logic and_2364;
  assign and_2364 = not_587_s2_q & (not_589_s2_q & (equal_590_s2_q & (inside_v_s2_q & and_1622)));
  // hls/stages/moments.hpp:106
  logic and_2366;
  assign and_2366 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2369;
  assign select_2369 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2366)) : and_2366;
  // hls/stages/moments.hpp:153
  logic and_2372;
  assign and_2372 = equal_1805_s2_q & (cfg_prove_i & (cfg_same_table_i & select_2369));
  // hls/stages/moments.hpp:107
  logic and_2376;
  assign and_2376 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/agreement.hpp:799
  logic [13:0] select_2381;
  assign select_2381 = equal_586_s2_q ? (equal_1805_s2_q ? sum_2316 : moments_other_field_before_0_q) : moments_other_field_before_0_q;
  logic [13:0] select_2383;
  assign select_2383 = equal_586_s2_q ? (equal_1805_s2_q ? sum_2318 : moments_other_field_before_1_q) : moments_other_field_before_1_q;
  logic select_2385;
  assign select_2385 = equal_586_s2_q ? (moments_other_field_has_before_q | equal_1805_s2_q) : moments_other_field_has_before_q;
  // hls/stages/moments.hpp:61
  logic select_2386;
  assign select_2386 = moments_ended_q ? out_of_step : moments_other_field_out_of_step_q;
  // hls/stages/census.hpp:371
  logic [9:0] difference_2400;
  assign difference_2400 = {1'b0, select_565} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2400[9]} + (difference_2400[8:0] ^ {9{difference_2400[9]}});
  logic [9:0] difference_2412;
  assign difference_2412 = {1'b0, select_569} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2412[9]} + (difference_2412[8:0] ^ {9{difference_2412[9]}});
  // hls/stages/agreement.hpp:531
  logic select_2611;
  assign select_2611 = and_559_s2_q ? (equal_2503_s2_q ? and_2609_s2_q : draws_late_q) : draws_late_q;
  // hls/stages/agreement.hpp:240
  logic [5:0] select_2613;
  assign select_2613 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2614;
  assign select_2614 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2615;
  assign select_2615 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2616;
  assign select_2616 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2617;
  assign select_2617 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2618;
  assign select_2618 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2622;
  assign select_2622 = slot_s2_q[0] ? 8'h0 : sum_1027;
  // hls/stages/agreement.hpp:762
  logic less_2623;
  assign less_2623 = select_2622 < select_1527;
  // hls/stages/agreement.hpp:240
  logic [6:0] select_2625;
  assign select_2625 = slot_s2_q[0] ? 7'h0 : sum_1553;
  // hls/stages/agreement.hpp:799
  logic not_2630;
  assign not_2630 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2631;
  assign less_2631 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:531
  logic and_2638;
  assign and_2638 = and_559_s2_q & (equal_694_s2_q & equal_2503_s2_q);
  // hls/stages/agreement.hpp:799
  logic and_2643;
  assign and_2643 = ends_cell_s2_q & (inside_v_s2_q & (and_2640_s2_q & not_2017_s2_q));
  // hls/stages/agreement.hpp:1045
  logic and_2667;
  assign and_2667 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2668;
  assign and_2668 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2669;
  assign and_2669 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2670;
  assign and_2670 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1104
  logic [1:0] sum_2672;
  assign sum_2672 = {1'b0, and_2669} + ({1'b0, explained} + {1'b0, and_2670});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2667} + ({2'h0, and_2668} + {1'b0, sum_2672});
  // hls/stages/agreement.hpp:799
  logic and_2708;
  assign and_2708 = ends_cell_s2_q & (inside_v_s2_q & (not_2017_s2_q & (and_2640_s2_q & and_2033)));
  // hls/stages/agreement.hpp:997
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:998
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:999
  logic [7:0] difference_2733;
  assign difference_2733 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2736;
  assign less_2736 = {2'h0, difference_2733[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:248
  logic and_2739;
  assign and_2739 = not_595_s2_q & (((and_2031_s2_q & and_644) & equal_2729_s2_q) & (~less_2736));
  // hls/stages/agreement.hpp:799
  logic and_2743;
  assign and_2743 = ends_cell_s2_q & (inside_v_s2_q & ((or_591_s2_q & and_2739) & not_2017_s2_q));
  // hls/stages/agreement.hpp:150
  logic and_2749;
  assign and_2749 = not_595_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:248
  logic and_2751;
  assign and_2751 = not_595_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2752;
  assign select_2752 = or_591_s2_q ? {and_2751, and_2749} : 2'h0;
  // hls/stages/agreement.hpp:248
  logic [1:0] select_2754;
  assign select_2754 = less_594_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2755;
  assign select_2755 = or_591_s2_q ? select_2754 : 2'h0;
  // hls/stages/agreement.hpp:1042
  logic and_2757;
  assign and_2757 = and_646 & (select_2752[0] & select_2755[0]);
  // hls/stages/agreement.hpp:799
  logic and_2761;
  assign and_2761 = ends_cell_s2_q & (inside_v_s2_q & (not_2017_s2_q & (select_2752[1] & and_2757)));
  logic and_2763;
  assign and_2763 = not_587_s2_q & (drew_q & and_2761);
  logic and_2769;
  assign and_2769 = ends_cell_s2_q & (inside_v_s2_q & (not_2017_s2_q & (select_2755[1] & and_2757)));
  logic and_2771;
  assign and_2771 = not_587_s2_q & (drew_q & and_2769);
  // hls/stages/registration.hpp:76
  logic less_2774;
  assign less_2774 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_2776;
  assign select_2776 = or_591_s2_q ? (less_594_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2778;
  assign select_2778 = or_591_s2_q ? (less_594_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2780;
  assign select_2780 = or_591_s2_q ? (less_594_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2778} - {1'b0, select_2780};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2782;
  assign select_2782 = rise_2[8] ? select_2778 : select_2780;
  logic [8:0] fall;
  assign fall = {1'b0, select_2776} - {1'b0, select_2782};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2785;
  assign not_2785 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2774 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2785};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2787;
  assign xor_2787 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2787};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2793;
  assign select_2793 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2774 ? {taken, 1'b1} : {not_2785, select_2793, not_2785};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2795;
  assign sum_2795 = {left, 1'b1} + {taken_2, less_2774};
  // hls/stages/agreement.hpp:258
  logic [4:0] select_2797;
  assign select_2797 = drew_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:799
  logic [7:0] select_2799;
  assign select_2799 = equal_586_s2_q ? registration_slope_here_q : (drew_q ? slope : registration_slope_here_q);
  logic [10:0] select_2801;
  assign select_2801 = equal_586_s2_q ? registration_expected_q : (drew_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2802;
  assign equal_2802 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:263
  logic and_2806;
  assign and_2806 = and_646 & less_1715_s2_q;
  // hls/stages/agreement.hpp:150
  logic [2:0] select_2808;
  assign select_2808 = or_591_s2_q ? (less_594_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2812;
  assign sum_2812 = select_2808[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2815;
  assign select_2815 = (select_2778 < select_2780) ? ({sum_2812, select_2808[0], 5'h0} - {3'h0, select_2797}) : {sum_2812, select_2808[0], select_2797};
  logic [7:0] select_2816;
  assign select_2816 = ((select_2808 == 3'h0) | (select_2808 == 3'h4)) ? {sum_2812, select_2808[0], 5'h0} : select_2815;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2816[7]}}, select_2816} - {sum_1734[9], sum_1734, sum_1730[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2819;
  assign select_2819 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2819[11:7])) ? 12'h7f : select_2819;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2840;
  assign difference_2840 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2842;
  assign and_2842 = and_2806 & ($signed(difference_2840) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2855;
  assign less_2855 = $signed(difference_2840) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:799
  logic select_2863;
  assign select_2863 = drew_q ? (equal_2802 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2866;
  assign select_2866 = drew_q ? (equal_1716 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2871;
  assign select_2871 = (sum_1629 == 2'h2) ? (registration_fresh_q & (~select_1676)) : registration_fresh_q;
  // hls/stages/agreement.hpp:799
  logic [3:0] select_2873;
  assign select_2873 = drew_q ? (and_1671 ? select_2871 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2875;
  assign select_2875 = and_2638 ? 4'hf : (equal_586_s2_q ? registration_fresh_q : select_2873);
  // hls/stages/agreement.hpp:1146
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1626;
  // hls/stages/registration.hpp:258
  logic not_2895;
  assign not_2895 = ~quarter_2[1];
  logic [3:0] select_2896;
  assign select_2896 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2895, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2895};
  // hls/stages/patches.hpp:91
  logic parity_3030;
  assign parity_3030 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:465
  logic [15:0] select_3031;
  assign select_3031 = equal_2503_s2_q ? {patches_chance_q[14:0], parity_3030} : patches_chance_q;
  // hls/stages/patches.hpp:352
  logic not_3033;
  assign not_3033 = ~and_1786;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_3035;
  assign select_3035 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_3035};
  // hls/stages/agreement.hpp:799
  logic and_3040;
  assign and_3040 = drew_q & (ends_cell_s2_q & (~({sum_1710, x_s2_q[0]} < {2'h0, from})));
  // hls/stages/patches.hpp:157
  logic and_3044;
  assign and_3044 = not_3033 & (patches_fixed_q | ((not_587_s2_q & and_3040) & and_1762));
  // hls/stages/patches.hpp:362
  logic not_3056;
  assign not_3056 = ~select_1705[1];
  // hls/stages/agreement.hpp:277
  logic [1:0] select_3058;
  assign select_3058 = sample_pair_whole_s2_q ? (equal_1706 ? select_1705 : {not_3056, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:531
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:276
  logic [51:0] select_3157;
  assign select_3157 = or_1794_s2_q ? {and_1944_s2_q, and_1941_s2_q, and_1925_s2_q, and_1922, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3159;
  assign select_3159 = equal_1788_s2_q ? patches_codes_at_q : (equal_1790_s2_q ? other[55:4] : select_3157);
  // hls/stages/patches.hpp:514
  logic [27:0] word;
  assign word = or_1898_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:530
  logic [27:0] select_3162;
  assign select_3162 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:276
  logic [27:0] select_3164;
  assign select_3164 = equal_1790_s2_q ? (new_row_s2_q ? word : select_3162) : patches_codes_further_q;
  // hls/stages/patches.hpp:532
  logic [55:0] select_3166;
  assign select_3166 = less_1885_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:502
  logic [55:0] select_3168;
  assign select_3168 = less_3167_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:276
  logic [55:0] select_3170;
  assign select_3170 = or_1794_s2_q ? (equal_1793_s2_q ? patches_next_codes_q : select_3168) : patches_next_codes_q;
  logic [55:0] select_3172;
  assign select_3172 = equal_1788_s2_q ? patches_next_codes_q : (equal_1790_s2_q ? select_3166 : select_3170);
  // hls/stages/count_bits.hpp:24
  logic parity_3177;
  assign parity_3177 = ^{and_1944_s2_q, and_1941_s2_q, and_1925_s2_q, and_1922};
  // hls/stages/count_bits.hpp:25
  logic or_3181;
  assign or_3181 = ({and_1925_s2_q, and_1922} == 2'h3) | (and_1941_s2_q & (and_1925_s2_q | and_1922));
  logic and_3182;
  assign and_3182 = and_1944_s2_q & (^{and_1941_s2_q, and_1925_s2_q, and_1922});
  // hls/stages/count_bits.hpp:24
  logic xor_3183;
  assign xor_3183 = or_3181 ^ and_3182;
  // hls/stages/count_bits.hpp:27
  logic and_3184;
  assign and_3184 = or_3181 & and_3182;
  // hls/stages/agreement.hpp:276
  logic [2:0] select_3186;
  assign select_3186 = or_1794_s2_q ? (and_1967_s2_q ? {and_3184, xor_3183, parity_3177} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3190;
  assign sum_3190 = {7'h0, patches_set_q} + (equal_1793_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:531
  logic [47:0] select_3200;
  assign select_3200 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/agreement.hpp:276
  logic [47:0] select_3202;
  assign select_3202 = equal_1788_s2_q ? patches_left_row_q : (equal_1790_s2_q ? select_3200 : patches_left_row_q);
  // hls/stages/patches.hpp:533
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3200;
  // hls/stages/count_bits.hpp:24
  logic xor_3206;
  assign xor_3206 = bits[17] ^ (^{select_3200[16:15], other[16:15]});
  logic xor_3209;
  assign xor_3209 = bits[11] ^ (^{select_3200[10:9], other[10:9]});
  logic xor_3212;
  assign xor_3212 = bits[14] ^ (^{select_3200[13:12], other[13:12]});
  logic xor_3215;
  assign xor_3215 = xor_3206 ^ (^{select_3200[14:9], other[14:9]});
  logic xor_3218;
  assign xor_3218 = bits[47] ^ (^{select_3200[46:45], other[46:45]});
  logic xor_3221;
  assign xor_3221 = bits[8] ^ (^{select_3200[7:6], other[7:6]});
  logic xor_3224;
  assign xor_3224 = bits[2] ^ (^{select_3200[1:0], other[1:0]});
  logic xor_3227;
  assign xor_3227 = bits[5] ^ (^{select_3200[4:3], other[4:3]});
  logic xor_3230;
  assign xor_3230 = xor_3221 ^ (^{select_3200[5:0], other[5:0]});
  logic parity_3232;
  assign parity_3232 = ^{select_3200[47:45], select_3200[8:0], other[47:45], other[8:0]};
  logic xor_3233;
  assign xor_3233 = xor_3215 ^ parity_3232;
  logic xor_3236;
  assign xor_3236 = bits[44] ^ (^{select_3200[43:42], other[43:42]});
  logic xor_3239;
  assign xor_3239 = bits[38] ^ (^{select_3200[37:36], other[37:36]});
  logic xor_3242;
  assign xor_3242 = bits[41] ^ (^{select_3200[40:39], other[40:39]});
  logic xor_3248;
  assign xor_3248 = bits[26] ^ (^{select_3200[25:24], other[25:24]});
  logic xor_3251;
  assign xor_3251 = bits[20] ^ (^{select_3200[19:18], other[19:18]});
  logic xor_3254;
  assign xor_3254 = bits[23] ^ (^{select_3200[22:21], other[22:21]});
  logic xor_3257;
  assign xor_3257 = xor_3248 ^ (^{select_3200[23:18], other[23:18]});
  logic xor_3260;
  assign xor_3260 = bits[35] ^ (^{select_3200[34:33], other[34:33]});
  logic xor_3263;
  assign xor_3263 = bits[29] ^ (^{select_3200[28:27], other[28:27]});
  logic xor_3266;
  assign xor_3266 = bits[32] ^ (^{select_3200[31:30], other[31:30]});
  logic xor_3269;
  assign xor_3269 = xor_3260 ^ (^{select_3200[32:27], other[32:27]});
  logic xor_3270;
  assign xor_3270 = xor_3257 ^ xor_3269;
  // hls/stages/count_bits.hpp:25
  logic or_3278;
  assign or_3278 = (xor_3209 & xor_3212) | (xor_3206 & (xor_3209 | xor_3212));
  logic or_3282;
  assign or_3282 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3286;
  assign or_3286 = (xor_3224 & xor_3227) | (xor_3221 & (xor_3224 | xor_3227));
  // hls/stages/count_bits.hpp:23
  logic or_3293;
  assign or_3293 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3297;
  assign or_3297 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3301;
  assign or_3301 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3304;
  assign parity_3304 = ^{or_3301, or_3297, or_3293};
  // hls/stages/count_bits.hpp:23
  logic or_3308;
  assign or_3308 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3312;
  assign or_3312 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3316;
  assign or_3316 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3319;
  assign parity_3319 = ^{or_3316, or_3312, or_3308};
  logic parity_3322;
  assign parity_3322 = ^{or_3316, or_3312, or_3308, or_3301, or_3297, or_3293, or_3286, or_3282, or_3278};
  // hls/stages/count_bits.hpp:23
  logic or_3326;
  assign or_3326 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3330;
  assign or_3330 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3334;
  assign or_3334 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3342;
  assign or_3342 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3346;
  assign or_3346 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3350;
  assign or_3350 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3353;
  assign parity_3353 = ^{or_3350, or_3346, or_3342};
  // hls/stages/count_bits.hpp:23
  logic or_3357;
  assign or_3357 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3361;
  assign or_3361 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3365;
  assign or_3365 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3368;
  assign parity_3368 = ^{or_3365, or_3361, or_3357};
  logic parity_3371;
  assign parity_3371 = ^{or_3365, or_3361, or_3357, or_3350, or_3346, or_3342, or_3334, or_3330, or_3326};
  // hls/stages/count_bits.hpp:25
  logic or_3375;
  assign or_3375 = (xor_3239 & xor_3242) | (xor_3236 & (xor_3239 | xor_3242));
  logic or_3379;
  assign or_3379 = (xor_3251 & xor_3254) | (xor_3248 & (xor_3251 | xor_3254));
  logic or_3383;
  assign or_3383 = (xor_3263 & xor_3266) | (xor_3260 & (xor_3263 | xor_3266));
  // hls/stages/count_bits.hpp:24
  logic parity_3386;
  assign parity_3386 = ^{or_3383, or_3379, or_3375};
  // hls/stages/count_bits.hpp:25
  logic and_3387;
  assign and_3387 = xor_3233 & (^{xor_3270, select_3200[44:36], other[44:36]});
  logic or_3391;
  assign or_3391 = (xor_3218 & xor_3230) | (xor_3215 & (xor_3218 | xor_3230));
  logic and_3394;
  assign and_3394 = (xor_3236 ^ (^{select_3200[41:36], other[41:36]})) & (xor_3257 | xor_3269);
  logic or_3395;
  assign or_3395 = (xor_3257 & xor_3269) | and_3394;
  // hls/stages/count_bits.hpp:24
  logic parity_3398;
  assign parity_3398 = ^{or_3395, or_3391, and_3387};
  logic parity_3401;
  assign parity_3401 = ^{or_3395, or_3391, and_3387, or_3383, or_3379, or_3375, or_3365, or_3361, or_3357, or_3350, or_3346, or_3342, or_3334, or_3330, or_3326};
  logic parity_3403;
  assign parity_3403 = ^{or_3395, or_3391, and_3387, or_3383, or_3379, or_3375, or_3365, or_3361, or_3357, or_3350, or_3346, or_3342, or_3334, or_3330, or_3326, or_3316, or_3312, or_3308, or_3301, or_3297, or_3293, or_3286, or_3282, or_3278};
  // hls/stages/count_bits.hpp:25
  logic and_3404;
  assign and_3404 = parity_3322 & parity_3401;
  logic or_3408;
  assign or_3408 = (parity_3304 & parity_3319) | ((^{or_3286, or_3282, or_3278}) & (parity_3304 | parity_3319));
  logic or_3412;
  assign or_3412 = (parity_3386 & parity_3398) | (parity_3371 & (parity_3386 | parity_3398));
  logic or_3419;
  assign or_3419 = (parity_3353 & parity_3368) | ((^{or_3334, or_3330, or_3326}) & (parity_3353 | parity_3368));
  logic or_3423;
  assign or_3423 = (or_3379 & or_3383) | (or_3375 & (or_3379 | or_3383));
  logic or_3427;
  assign or_3427 = (or_3391 & or_3395) | (and_3387 & (or_3391 | or_3395));
  // hls/stages/count_bits.hpp:23
  logic or_3434;
  assign or_3434 = (or_3330 & or_3334) | (or_3326 & (or_3330 | or_3334));
  // hls/stages/count_bits.hpp:25
  logic or_3438;
  assign or_3438 = (or_3346 & or_3350) | (or_3342 & (or_3346 | or_3350));
  logic or_3442;
  assign or_3442 = (or_3361 & or_3365) | (or_3357 & (or_3361 | or_3365));
  // hls/stages/count_bits.hpp:24
  logic parity_3445;
  assign parity_3445 = ^{or_3442, or_3438, or_3434};
  // hls/stages/count_bits.hpp:23
  logic or_3449;
  assign or_3449 = (or_3282 & or_3286) | (or_3278 & (or_3282 | or_3286));
  // hls/stages/count_bits.hpp:25
  logic or_3453;
  assign or_3453 = (or_3297 & or_3301) | (or_3293 & (or_3297 | or_3301));
  logic or_3457;
  assign or_3457 = (or_3312 & or_3316) | (or_3308 & (or_3312 | or_3316));
  // hls/stages/count_bits.hpp:24
  logic parity_3460;
  assign parity_3460 = ^{or_3457, or_3453, or_3449};
  logic parity_3463;
  assign parity_3463 = ^{or_3457, or_3453, or_3449, or_3442, or_3438, or_3434, or_3427, or_3423, or_3419};
  logic parity_3465;
  assign parity_3465 = ^{or_3457, or_3453, or_3449, or_3442, or_3438, or_3434, or_3427, or_3423, or_3419, or_3412, or_3408, and_3404};
  // hls/stages/count_bits.hpp:25
  logic or_3469;
  assign or_3469 = (or_3423 & or_3427) | (or_3419 & (or_3423 | or_3427));
  logic or_3473;
  assign or_3473 = (or_3438 & or_3442) | (or_3434 & (or_3438 | or_3442));
  logic or_3477;
  assign or_3477 = (or_3453 & or_3457) | (or_3449 & (or_3453 | or_3457));
  // hls/stages/count_bits.hpp:24
  logic parity_3480;
  assign parity_3480 = ^{or_3477, or_3473, or_3469};
  // hls/stages/count_bits.hpp:25
  logic and_3481;
  assign and_3481 = (^{or_3412, or_3408, and_3404}) & parity_3463;
  logic or_3485;
  assign or_3485 = (or_3408 & or_3412) | (and_3404 & (or_3408 | or_3412));
  logic or_3489;
  assign or_3489 = (parity_3445 & parity_3460) | ((^{or_3427, or_3423, or_3419}) & (parity_3445 | parity_3460));
  // hls/stages/count_bits.hpp:24
  logic parity_3492;
  assign parity_3492 = ^{or_3489, or_3485, and_3481};
  // hls/stages/count_bits.hpp:25
  logic and_3494;
  assign and_3494 = parity_3480 & parity_3492;
  logic or_3498;
  assign or_3498 = (or_3473 & or_3477) | (or_3469 & (or_3473 | or_3477));
  logic or_3502;
  assign or_3502 = (or_3485 & or_3489) | (and_3481 & (or_3485 | or_3489));
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3547;
  assign select_3547 = equal_1790_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3550;
  assign select_3550 = equal_1788_s2_q ? patches_summed_first_q : (equal_1790_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:564
  logic [9:0] select_3558;
  assign select_3558 = less_1973_s2_q ? (or_1976_s2_q ? patches_rows_rdata_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3561;
  assign select_3561 = less_1973_s2_q ? (or_1976_s2_q ? patches_rows_rdata_q[14:10] : 5'h0) : 5'h0;
  logic [4:0] select_3564;
  assign select_3564 = less_1973_s2_q ? (or_1976_s2_q ? patches_step_s2_q : 5'h0) : 5'h0;
  // hls/stages/agreement.hpp:276
  logic select_3569;
  assign select_3569 = equal_1788_s2_q ? (less_1973_s2_q & (or_1976_s2_q & (patches_step_s2_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3574;
  assign or_3574 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3575;
  assign and_3575 = patches_read_searches_s2_q & or_3574;
  // hls/stages/patches.hpp:548
  logic [4:0] select_3576;
  assign select_3576 = and_3575 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:555
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3576};
  // hls/stages/patches.hpp:564
  logic and_3581;
  assign and_3581 = less_1973_s2_q & (or_1976_s2_q & (equal_1974_s2_q & (away == 6'h3f)));
  logic and_3586;
  assign and_3586 = less_1973_s2_q & (or_1976_s2_q & (equal_1974_s2_q & (away == 6'h1)));
  // hls/stages/patches.hpp:561
  logic [6:0] sum_3588;
  assign sum_3588 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:562
  logic [9:0] select_3591;
  assign select_3591 = (equal_1974_s2_q & ({sum_3588[6], sum_3588} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:564
  logic [9:0] select_3593;
  assign select_3593 = less_1973_s2_q ? (or_1976_s2_q ? select_3591 : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:547
  logic [14:0] select_3595;
  assign select_3595 = and_3575 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3596;
  assign select_3596 = equal_1788_s2_q ? select_3595[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3597;
  assign select_3597 = equal_1788_s2_q ? select_3595[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:549
  logic [9:0] select_3599;
  assign select_3599 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3600;
  assign select_3600 = equal_1788_s2_q ? select_3599 : patches_peak_above_q;
  // hls/stages/patches.hpp:550
  logic [9:0] select_3601;
  assign select_3601 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3602;
  assign select_3602 = equal_1788_s2_q ? select_3601 : patches_peak_below_q;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3604;
  assign select_3604 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3606;
  assign select_3606 = equal_1788_s2_q ? (patches_read_first_q ? patches_read_far_q : select_3604) : patches_peak_far_q;
  logic [9:0] select_3609;
  assign select_3609 = equal_1788_s2_q ? (equal_3607_s2_q ? sum_3190 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/agreement.hpp:799
  logic select_3859;
  assign select_3859 = equal_586_s2_q ? shown_shown_q : (drew_q ? select_2046 : shown_shown_q);
  logic select_3861;
  assign select_3861 = equal_586_s2_q ? shown_nearer_q : (drew_q ? select_2049 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3863;
  assign sum_3863 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:465
  logic [2:0] select_3866;
  assign select_3866 = less_3862_s2_q ? (sum_3863[7] ? region_row_q : next_region_row_q) : (and_2609_s2_q ? region_row_q : 3'h0);
  // hls/stages/agreement.hpp:531
  logic [2:0] select_3868;
  assign select_3868 = and_559_s2_q ? (equal_2503_s2_q ? select_3866 : region_row_q) : region_row_q;
  // hls/stages/agreement.hpp:799
  logic [7:0] select_3872;
  assign select_3872 = equal_586_s2_q ? select_1993 : (drew_q ? (ends_cell_s2_q ? select_2100 : select_1993) : 8'h1);
  // hls/stages/agreement.hpp:465
  logic [8:0] select_3885;
  assign select_3885 = equal_694_s2_q ? {{2{difference_3884[6]}}, difference_3884} : region_down_rest_q;
  logic [8:0] select_3887;
  assign select_3887 = equal_2503_s2_q ? (less_3862_s2_q ? region_down_next_q : select_3885) : region_down_rest_q;
  logic [6:0] select_3890;
  assign select_3890 = equal_694_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  logic [6:0] select_3892;
  assign select_3892 = equal_2503_s2_q ? (less_3862_s2_q ? region_down_back_q : select_3890) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3894;
  assign sum_3894 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3895;
  assign select_3895 = sum_3863[7] ? {1'b1, sum_3863[6:0], region_down_rest_q[0]} : sum_3894;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3863[7];
  // hls/stages/agreement.hpp:465
  logic select_3899;
  assign select_3899 = equal_2503_s2_q ? (less_3862_s2_q ? next : (region_fresh_q | equal_694_s2_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:206
  logic or_3904;
  assign or_3904 = segment_starts_q | not_589_s2_q;
  // hls/stages/agreement.hpp:1045
  logic select_3907;
  assign select_3907 = inside_v_s2_q ? (sum_2006_s2_q ? (equal_2008 & or_2009) : or_2009) : or_3904;
  // hls/stages/agreement.hpp:799
  logic select_3910;
  assign select_3910 = equal_586_s2_q ? or_3904 : (drew_q ? (ends_cell_s2_q ? select_3907 : or_3904) : or_3904);
  logic select_4078;
  assign select_4078 = drew_q ? (ends_cell_s2_q ? and_2088 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4081;
  assign select_4081 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4083;
  assign select_4083 = equal_586_s2_q ? centres_values_0_of_skin_q : (drew_q ? select_4081 : centres_values_0_of_skin_q);
  logic select_4084;
  assign select_4084 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4086;
  assign select_4086 = equal_586_s2_q ? centres_values_1_textured_q : (drew_q ? select_4084 : centres_values_1_textured_q);
  logic select_4087;
  assign select_4087 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4089;
  assign select_4089 = equal_586_s2_q ? centres_values_1_of_skin_q : (drew_q ? select_4087 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:465
  logic [10:0] select_4095;
  assign select_4095 = equal_2503_s2_q ? (or_4092_s2_q ? (map_row_q + {5'h0, map_width_q}) : 11'h0) : map_row_q;
  // hls/stages/agreement.hpp:531
  logic [5:0] select_4098;
  assign select_4098 = and_559_s2_q ? (equal_2503_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1302
  logic xor_4099;
  assign xor_4099 = write_half_q ^ done_s2_q;
  // hls/stages/agreement.hpp:443
  logic select_4101;
  assign select_4101 = and_1985_s2_q ? (left_first_s2_q ? xor_4099 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:279
  logic select_4103;
  assign select_4103 = and_1985_s2_q ? (left_first_s2_q ? xor_4099 : select_4101) : write_half_q;
  logic select_4105;
  assign select_4105 = left_first_s2_q ? select_2052 : (and_1985_s2_q ? select_2053 : read_half_q);
  logic [9:0] select_4118;
  assign select_4118 = left_first_s2_q ? 10'h1 : (and_1985_s2_q ? select_2057 : rows_passed_q);
  logic [8:0] select_4121;
  assign select_4121 = left_first_s2_q ? {select_2055[7:0], or_2054} : (and_1985_s2_q ? {select_2055[7:0], or_2054} : columns_passed_q);
  logic select_4124;
  assign select_4124 = left_first_s2_q ? marks_last_s2_q : (and_1985_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4127;
  assign select_4127 = left_first_s2_q ? and_2071 : (and_1985_s2_q ? and_2071 : began_q);
  logic [2:0] select_4130;
  assign select_4130 = left_first_s2_q ? select_2073 : (and_1985_s2_q ? select_2073 : seen_x_q);
  // hls/stages/agreement.hpp:1332
  logic [2:0] select_4135;
  assign select_4135 = left_first_s2_q ? 3'h0 : (and_2058 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:279
  logic [2:0] select_4137;
  assign select_4137 = left_first_s2_q ? 3'h0 : (and_1985_s2_q ? select_4135 : seen_y_q);
  logic [7:0] select_4140;
  assign select_4140 = left_first_s2_q ? select_2066 : (and_1985_s2_q ? select_2066 : seen_column_q);
  // hls/stages/agreement.hpp:441
  logic [7:0] select_4146;
  assign select_4146 = left_first_s2_q ? select_4144 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:279
  logic [7:0] select_4148;
  assign select_4148 = left_first_s2_q ? select_4144 : (and_1985_s2_q ? select_4146 : seen_rows_left_q);
  // hls/stages/agreement.hpp:441
  logic and_4153;
  assign and_4153 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:279
  logic select_4155;
  assign select_4155 = left_first_s2_q ? and_4153 : (and_1985_s2_q ? and_4153 : at_cell_end_q);
  logic select_4158;
  assign select_4158 = left_first_s2_q ? next_row : (and_1985_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4161;
  assign select_4161 = left_first_s2_q ? 11'h0 : (and_1985_s2_q ? select_2063 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4241;
  assign not_4241 = ~quarter[1];
  logic [3:0] select_4242;
  assign select_4242 = quarter[0] ? {quarter[1], 1'b0, not_4241, 1'b0} : {1'b0, quarter[1], 1'b0, not_4241};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1630;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1673;
`endif
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 23, DISTANCE 12, hls/stages/patches.hpp:782; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1704;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1706));
`endif
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1431; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2003;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s2_en & (equal_586_s2_q ? (x_s2_q[6] & not_2004) : and_2012);
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1444; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_2068;
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s2_en & select_2080;
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_524_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_533_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_552, and_548, sum_544, sum_540};
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
  assign census_memory_we = s2_en & and_559_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_577, whole_2, select_569, select_565};
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
  logic [11:0] moments_memory_waddr;
  assign moments_memory_waddr = address_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_602_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_661_s2_q, and_659_s2_q, and_653_s2_q, and_651};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && moments_memory_we) begin
      if (moments_memory_re && moments_memory_raddr == moments_memory_waddr) begin
        $error("moments_memory: address %0d is read less than DISTANCE steps after its write", moments_memory_waddr);
      end
      if (moments_memory_waddr >= 12'd3290) $error("moments_memory: write outside, address %0d", moments_memory_waddr);
    end
    if (rst_ni && moments_memory_re && moments_memory_raddr >= 12'd3290) $error("moments_memory: read outside, address %0d", moments_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1577_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1576, select_1573, select_1570, select_1568, select_1550, select_1547, select_1539, select_1538, select_1533};
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
  assign best_right_we = s2_en & and_1577_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1587, select_1586, select_1583, select_1582};
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
  assign shown_right_waddr = select_1594_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1605;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1602, not_589_s2_q};
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
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1613, and_1610};
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
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1622, and_1619};
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
  assign patches_right_codes_waddr = {sum_1906, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1958_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1944_s2_q, and_1941_s2_q, and_1925_s2_q, and_1922, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1962, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1972_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1944_s2_q, and_1941_s2_q, and_1925_s2_q, and_1922, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_1590_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2044, textured};
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
      moments_other_field_before_0_q <= 14'h0;
      moments_other_field_before_1_q <= 14'h0;
      moments_other_field_has_before_q <= 1'b0;
      moments_other_field_out_of_step_q <= 1'b0;
      moments_ended_q <= 1'b0;
      rows_passed_above_q <= 5'h0;
      draws_late_q <= 1'b0;
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
      patches_peak_size_q <= 10'h0;
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
      averager_running_of_skin_q <= select_2217;
      averager_mask_q <= select_2219;
      averager_of_skin_q <= select_2221;
      census_filled_q <= and_559_s2_q ? {select_697[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2316;
      moments_turned_1_q <= sum_2318;
      moments_before_0_q <= equal_586_s2_q ? select_2319 : moments_before_0_q;
      moments_before_1_q <= equal_586_s2_q ? select_2321 : moments_before_1_q;
      moments_has_before_q <= equal_586_s2_q ? select_2323 : moments_has_before_q;
      moments_most_before_q <= select_2327;
      moments_left_begins_q <= select_2331;
      moments_left_alone_q <= select_2335;
      moments_left_other_stops_q <= select_2338;
      moments_right_begins_q <= select_2341;
      moments_right_alone_q <= select_2345;
      moments_right_other_stops_q <= select_2348;
      moments_out_of_step_q <= select_2352;
      moments_turns_0_q <= and_2360;
      moments_turns_1_q <= and_2364;
      moments_begins_alone_q <= equal_586_s2_q & and_2372;
      moments_ends_q <= equal_586_s2_q & (equal_1805_s2_q & (not_2374 | and_2376));
      moments_other_field_before_0_q <= select_2381;
      moments_other_field_before_1_q <= select_2383;
      moments_other_field_has_before_q <= select_2385;
      moments_other_field_out_of_step_q <= select_2386;
      moments_ended_q <= equal_586_s2_q & equal_1805_s2_q;
      rows_passed_above_q <= and_559_s2_q ? select_696 : rows_passed_above_q;
      draws_late_q <= select_2611;
      chosen_score_q <= less_2623 ? select_1527 : select_2622;
      chosen_near_q <= (select_2625 < select_1562) ? select_1562 : select_2625;
      chosen_place_q <= less_2623 ? {select_1535, not_1534} : 3'h2;
      before_0_q <= select_2622;
      before_1_q <= sum_1277;
      before_2_q <= sum_1525;
      shift_allowed_q <= not_2630 & (~less_2631);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2638 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2763});
      counts_turned_right_q <= and_2638 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2771});
      registration_displacement_over_q <= drew_q ? sum_2795[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2797;
      registration_slope_here_q <= select_2799;
      registration_expected_q <= select_2801;
      registration_of_right_q <= equal_586_s2_q ? registration_of_right_q : select_2863;
      registration_was_inside_q <= equal_586_s2_q ? registration_was_inside_q : select_2866;
      registration_fresh_q <= select_2875;
      patches_chance_q <= and_559_s2_q ? select_3031 : patches_chance_q;
      patches_fixed_q <= and_3044;
      patches_choice_valid_q <= and_1786 ? (select_1763 & not_3033) : select_1763;
      patches_choice_column_q <= and_1762 ? select_1766 : patches_choice_column_q;
      patches_choice_shift_q <= and_1762 ? select_1770 : patches_choice_shift_q;
      patches_choice_slope_q <= and_1762 ? select_1780 : patches_choice_slope_q;
      patches_band_q <= sample_pair_whole_s2_q ? select_1801 : patches_band_q;
      patches_fetch_q <= select_3058;
      patches_codes_at_q <= select_3159;
      patches_codes_further_q <= equal_1788_s2_q ? patches_codes_further_q : select_3164;
      patches_next_codes_q <= select_3172;
      patches_set_q <= equal_1788_s2_q ? 3'h0 : (equal_1790_s2_q ? 3'h0 : select_3186);
      patches_size_q <= sum_3190;
      patches_left_row_q <= select_3202;
      patches_summed_row_column_q <= equal_1788_s2_q ? patches_summed_row_column_q : select_3547;
      patches_summed_first_q <= select_3550;
      patches_read_row_differing_q <= equal_1788_s2_q ? select_3558 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1788_s2_q ? select_3561 : patches_read_row_column_q;
      patches_read_at_q <= equal_1788_s2_q ? select_3564 : patches_read_at_q;
      patches_read_first_q <= select_3569;
      patches_read_above_q <= equal_1788_s2_q ? and_3581 : patches_read_above_q;
      patches_read_below_q <= equal_1788_s2_q ? and_3586 : patches_read_below_q;
      patches_read_far_q <= equal_1788_s2_q ? select_3593 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3596;
      patches_peak_best_column_q <= select_3597;
      patches_peak_row_q <= equal_1788_s2_q ? select_3576 : patches_peak_row_q;
      patches_peak_above_q <= select_3600;
      patches_peak_below_q <= select_3602;
      patches_peak_far_q <= select_3606;
      patches_peak_size_q <= select_3609;
      shown_shown_q <= select_3859;
      shown_nearer_q <= select_3861;
      region_row_q <= select_3868;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3872;
      region_down_rest_q <= and_559_s2_q ? select_3887 : region_down_rest_q;
      region_down_back_q <= and_559_s2_q ? select_3892 : region_down_back_q;
      region_down_next_q <= select_3895;
      region_fresh_q <= and_559_s2_q ? select_3899 : region_fresh_q;
      segment_starts_q <= select_3910;
      centres_values_0_textured_q <= equal_586_s2_q ? centres_values_0_textured_q : select_4078;
      centres_values_0_of_skin_q <= select_4083;
      centres_values_1_textured_q <= select_4086;
      centres_values_1_of_skin_q <= select_4089;
      map_row_q <= and_559_s2_q ? select_4095 : map_row_q;
      map_width_q <= select_4098;
      write_half_q <= select_4103;
      read_half_q <= and_1985_s2_q ? select_4105 : read_half_q;
      rows_passed_q <= and_1985_s2_q ? select_4118 : rows_passed_q;
      columns_passed_q <= and_1985_s2_q ? select_4121 : columns_passed_q;
      line_ended_q <= and_1985_s2_q ? select_4124 : line_ended_q;
      began_q <= and_1985_s2_q ? select_4127 : began_q;
      seen_x_q <= and_1985_s2_q ? select_4130 : seen_x_q;
      seen_y_q <= and_1985_s2_q ? select_4137 : seen_y_q;
      seen_column_q <= and_1985_s2_q ? select_4140 : seen_column_q;
      seen_rows_left_q <= and_1985_s2_q ? select_4148 : seen_rows_left_q;
      at_cell_end_q <= and_1985_s2_q ? select_4155 : at_cell_end_q;
      was_next_row_q <= and_1985_s2_q ? select_4158 : was_next_row_q;
      seen_base_q <= and_1985_s2_q ? select_4161 : seen_base_q;
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
      left_pixel_q <= and_1985_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_536 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_542 : averager_running_1_q;
      averager_total_0_q <= select_2195;
      averager_total_1_q <= select_2197;
      census_columns_values_0_cell_0_left_q <= select_2222;
      census_columns_values_0_cell_0_right_q <= select_2223;
      census_columns_values_0_cell_0_mask_q <= and_559_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2225;
      census_columns_values_0_cell_1_right_q <= select_2226;
      census_columns_values_0_cell_1_mask_q <= select_2227;
      census_columns_values_0_cell_2_left_q <= select_2228;
      census_columns_values_0_cell_2_right_q <= select_2229;
      census_columns_values_0_cell_2_mask_q <= select_2230;
      census_columns_values_0_cell_2_of_skin_q <= select_2231;
      census_columns_values_0_cell_3_left_q <= select_2232;
      census_columns_values_0_cell_3_right_q <= select_2233;
      census_columns_values_0_cell_3_mask_q <= select_2234;
      census_columns_values_0_cell_4_left_q <= select_2235;
      census_columns_values_0_cell_4_right_q <= select_2236;
      census_columns_values_0_cell_4_mask_q <= select_2237;
      census_columns_values_1_cell_0_left_q <= select_2238;
      census_columns_values_1_cell_0_right_q <= select_2239;
      census_columns_values_1_cell_0_mask_q <= select_2240;
      census_columns_values_1_cell_1_left_q <= select_2241;
      census_columns_values_1_cell_1_right_q <= select_2242;
      census_columns_values_1_cell_1_mask_q <= select_2243;
      census_columns_values_1_cell_2_left_q <= select_2244;
      census_columns_values_1_cell_2_right_q <= select_2245;
      census_columns_values_1_cell_2_mask_q <= select_2246;
      census_columns_values_1_cell_2_of_skin_q <= select_2247;
      census_columns_values_1_cell_3_left_q <= select_2248;
      census_columns_values_1_cell_3_right_q <= select_2249;
      census_columns_values_1_cell_3_mask_q <= select_2250;
      census_columns_values_1_cell_4_left_q <= select_2251;
      census_columns_values_1_cell_4_right_q <= select_2252;
      census_columns_values_1_cell_4_mask_q <= select_2253;
      census_columns_values_2_cell_0_left_q <= select_2254;
      census_columns_values_2_cell_0_right_q <= select_2255;
      census_columns_values_2_cell_0_mask_q <= select_2256;
      census_columns_values_2_cell_1_left_q <= select_2257;
      census_columns_values_2_cell_1_right_q <= select_2258;
      census_columns_values_2_cell_1_mask_q <= select_2259;
      census_columns_values_2_cell_2_left_q <= select_2260;
      census_columns_values_2_cell_2_right_q <= select_2261;
      census_columns_values_2_cell_2_mask_q <= select_2262;
      census_columns_values_2_cell_3_left_q <= select_2263;
      census_columns_values_2_cell_3_right_q <= select_2264;
      census_columns_values_2_cell_3_mask_q <= select_2265;
      census_columns_values_2_cell_4_left_q <= select_2266;
      census_columns_values_2_cell_4_right_q <= select_2267;
      census_columns_values_2_cell_4_mask_q <= select_2268;
      census_columns_values_3_cell_0_mask_q <= select_2269;
      census_columns_values_3_cell_1_left_q <= select_2270;
      census_columns_values_3_cell_1_right_q <= select_2271;
      census_columns_values_3_cell_1_mask_q <= select_2272;
      census_columns_values_3_cell_2_mask_q <= select_2273;
      census_columns_values_3_cell_3_left_q <= select_2274;
      census_columns_values_3_cell_3_right_q <= select_2275;
      census_columns_values_3_cell_3_mask_q <= select_2276;
      census_columns_values_3_cell_4_mask_q <= select_2277;
      sharpness_last_mean_0_q <= and_559_s2_q ? select_565 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_559_s2_q ? select_569 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_s2_q;
      middle_sum_columns_values_1_q <= select_2613;
      middle_sum_columns_values_2_q <= select_2614;
      middle_sum_columns_values_3_q <= select_2615;
      middle_sum_columns_values_4_q <= select_2616;
      middle_sum_columns_values_5_q <= select_2617;
      middle_sum_columns_values_6_q <= select_2618;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_1027;
      sums_0_sum_sums_values_0_q <= sum_1277;
      sums_0_sum_sums_values_1_q <= equal_1275 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1525;
      sums_1_sum_sums_values_1_q <= equal_1275 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic moments_ended_s3_q;
  logic [6:0] x_s3_q;
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
  logic [2:0] region_row_s3_q;
  logic region_fresh_s3_q;
  logic centres_values_1_textured_s3_q;
  logic centres_values_1_of_skin_s3_q;
  logic proven_s3_q;
  logic [2:0] select_520_s3_q;
  logic row_starts_s3_q;
  logic [5:0] select_553_s3_q;
  logic [5:0] last_s3_q;
  logic and_557_s3_q;
  logic and_559_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_562_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_579_s3_q;
  logic equal_586_s3_q;
  logic not_587_s3_q;
  logic so_s3_q;
  logic less_667_s3_q;
  logic less_668_s3_q;
  logic less_669_s3_q;
  logic less_670_s3_q;
  logic less_671_s3_q;
  logic less_672_s3_q;
  logic less_673_s3_q;
  logic less_674_s3_q;
  logic less_675_s3_q;
  logic less_676_s3_q;
  logic less_677_s3_q;
  logic less_678_s3_q;
  logic less_679_s3_q;
  logic less_680_s3_q;
  logic less_681_s3_q;
  logic less_682_s3_q;
  logic less_683_s3_q;
  logic less_684_s3_q;
  logic less_685_s3_q;
  logic less_686_s3_q;
  logic less_687_s3_q;
  logic less_688_s3_q;
  logic less_689_s3_q;
  logic less_690_s3_q;
  logic and_698_s3_q;
  logic and_723_s3_q;
  logic and_724_s3_q;
  logic [11:0] sum_739_s3_q;
  logic [9:0] sum_742_s3_q;
  logic and_750_s3_q;
  logic and_754_s3_q;
  logic less_755_s3_q;
  logic less_759_s3_q;
  logic less_761_s3_q;
  logic equal_1623_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1629_s3_q;
  logic equal_1631_s3_q;
  logic equal_1633_s3_q;
  logic equal_1635_s3_q;
  logic equal_1637_s3_q;
  logic equal_1639_s3_q;
  logic equal_1641_s3_q;
  logic equal_1643_s3_q;
  logic equal_1645_s3_q;
  logic less_1654_s3_q;
  logic or_1658_s3_q;
  logic equal_1678_s3_q;
  logic and_1688_s3_q;
  logic select_1705_s3_q;
  logic equal_1706_s3_q;
  logic and_1714_s3_q;
  logic equal_1716_s3_q;
  logic select_1763_s3_q;
  logic and_1787_s3_q;
  logic equal_1788_s3_q;
  logic equal_1790_s3_q;
  logic not_1795_s3_q;
  logic and_1803_s3_q;
  logic less_1808_s3_q;
  logic [4:0] select_1823_s3_q;
  logic select_1829_s3_q;
  logic [3:0] select_1869_s3_q;
  logic and_1985_s3_q;
  logic select_1987_s3_q;
  logic and_1990_s3_q;
  logic or_1996_s3_q;
  logic or_1999_s3_q;
  logic or_2002_s3_q;
  logic not_2004_s3_q;
  logic and_2019_s3_q;
  logic and_2025_s3_q;
  logic and_2036_s3_q;
  logic and_2041_s3_q;
  logic and_2075_s3_q;
  logic less_2076_s3_q;
  logic [11:0] sum_2085_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2103_s3_q;
  logic or_2106_s3_q;
  logic or_2109_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2161_s3_q;
  logic [11:0] sum_2293_s3_q;
  logic [9:0] sum_2296_s3_q;
  logic equal_2304_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic equal_2432_s3_q;
  logic and_2638_s3_q;
  logic and_2645_s3_q;
  logic not_2666_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2710_s3_q;
  logic and_2745_s3_q;
  logic and_2805_s3_q;
  logic and_2806_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2842_s3_q;
  logic and_2856_s3_q;
  logic equal_2898_s3_q;
  logic parity_3274_s3_q;
  logic parity_3403_s3_q;
  logic parity_3465_s3_q;
  logic xor_3493_s3_q;
  logic parity_3505_s3_q;
  logic or_3509_s3_q;
  logic equal_3510_s3_q;
  logic and_3610_s3_q;
  logic less_3635_s3_q;
  logic equal_3934_s3_q;
  logic and_4116_s3_q;
  logic and_4164_s3_q;
  logic and_4166_s3_q;
  logic equal_4244_s3_q;
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
      moments_ended_s3_q <= moments_ended_q;
      x_s3_q <= x_s2_q[6:0];
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
      region_row_s3_q <= region_row_q;
      region_fresh_s3_q <= region_fresh_q;
      centres_values_1_textured_s3_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s3_q <= centres_values_1_of_skin_q;
      proven_s3_q <= proven_s2_q;
      select_520_s3_q <= select_520_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_553_s3_q <= select_553_s2_q;
      last_s3_q <= last_s2_2_q;
      and_557_s3_q <= and_557_s2_q;
      and_559_s3_q <= and_559_s2_q;
      grey_s3_q <= grey;
      equal_562_s3_q <= equal_562;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_579_s3_q <= equal_579_s2_q;
      equal_586_s3_q <= equal_586_s2_q;
      not_587_s3_q <= not_587_s2_q;
      so_s3_q <= drew_q;
      less_667_s3_q <= less_667;
      less_668_s3_q <= less_668;
      less_669_s3_q <= less_669;
      less_670_s3_q <= less_670;
      less_671_s3_q <= less_671;
      less_672_s3_q <= less_672;
      less_673_s3_q <= less_673;
      less_674_s3_q <= less_674;
      less_675_s3_q <= less_675;
      less_676_s3_q <= less_676;
      less_677_s3_q <= less_677;
      less_678_s3_q <= less_678;
      less_679_s3_q <= less_679;
      less_680_s3_q <= less_680;
      less_681_s3_q <= less_681;
      less_682_s3_q <= less_682;
      less_683_s3_q <= less_683;
      less_684_s3_q <= less_684;
      less_685_s3_q <= less_685;
      less_686_s3_q <= less_686;
      less_687_s3_q <= less_687;
      less_688_s3_q <= less_688;
      less_689_s3_q <= less_689;
      less_690_s3_q <= less_690;
      and_698_s3_q <= and_698;
      and_723_s3_q <= whole_22 & and_698;
      and_724_s3_q <= census_columns_values_1_cell_2_mask_q & and_698;
      sum_739_s3_q <= {1'b0, sum_735} + {2'h0, sum_738};
      sum_742_s3_q <= {9'h0, difference_740[9]} + {1'b0, xor_741};
      and_750_s3_q <= and_750;
      and_754_s3_q <= and_754;
      less_755_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_759_s3_q <= {{5{sum_758[6]}}, sum_758, half_grey_levels_2[3:0]} < 16'hffe1;
      less_761_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_1623_s3_q <= equal_1623;
      all_s3_q <= all;
      sum_1629_s3_q <= sum_1629;
      equal_1631_s3_q <= equal_1631;
      equal_1633_s3_q <= equal_1633;
      equal_1635_s3_q <= equal_1635;
      equal_1637_s3_q <= equal_1637;
      equal_1639_s3_q <= equal_1639;
      equal_1641_s3_q <= equal_1641;
      equal_1643_s3_q <= equal_1643;
      equal_1645_s3_q <= equal_1645;
      less_1654_s3_q <= less_1654;
      or_1658_s3_q <= or_1658;
      equal_1678_s3_q <= (registration_fresh_q & select_1676) == 4'h0;
      and_1688_s3_q <= not_587_s2_q & and_1672;
      select_1705_s3_q <= select_1705[1];
      equal_1706_s3_q <= equal_1706;
      and_1714_s3_q <= and_1714;
      equal_1716_s3_q <= equal_1716;
      select_1763_s3_q <= select_1763;
      and_1787_s3_q <= and_1787;
      equal_1788_s3_q <= equal_1788_s2_q;
      equal_1790_s3_q <= equal_1790_s2_q;
      not_1795_s3_q <= not_1795_s2_q;
      and_1803_s3_q <= and_1787 & equal_1802;
      less_1808_s3_q <= select_1801 < patches_bands_chosen_q;
      select_1823_s3_q <= select_1823_s2_q;
      select_1829_s3_q <= select_1829_s2_q;
      select_1869_s3_q <= select_1869_s2_q;
      and_1985_s3_q <= and_1985_s2_q;
      select_1987_s3_q <= select_1987_s2_q;
      and_1990_s3_q <= and_1990_s2_q;
      or_1996_s3_q <= or_1996;
      or_1999_s3_q <= or_1999;
      or_2002_s3_q <= or_2002;
      not_2004_s3_q <= not_2004;
      and_2019_s3_q <= inside_v_s2_q & (and_2016 & not_2017_s2_q);
      and_2025_s3_q <= inside_v_s2_q & (and_646 & not_2017_s2_q);
      and_2036_s3_q <= inside_v_s2_q & (not_2017_s2_q & (and_2033 & and_1601));
      and_2041_s3_q <= not_587_s2_q & and_2012;
      and_2075_s3_q <= and_2075;
      less_2076_s3_q <= less_2076;
      sum_2085_s3_q <= sum_2085;
      textured_2_s3_q <= textured_2;
      or_2103_s3_q <= or_2103;
      or_2106_s3_q <= select_2100[7] | (~({select_2100[6], select_2100[3:2]} == 3'h0));
      or_2109_s3_q <= select_2100[7] | (~(select_2100[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2161_s3_q <= and_2161;
      sum_2293_s3_q <= {1'b0, sum_2289} + {2'h0, sum_2292};
      sum_2296_s3_q <= {9'h0, difference_2294[9]} + {1'b0, xor_2295};
      equal_2304_s3_q <= equal_2304_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      equal_2432_s3_q <= x_s2_q[7:3] == 5'h0;
      and_2638_s3_q <= and_2638;
      and_2645_s3_q <= not_587_s2_q & (drew_q & and_2643);
      not_2666_s3_q <= ~((draws_late_q & not_2017_s2_q) | (x_s2_q[7:1] == 7'h0));
      explained_2_s3_q <= explained_2;
      and_2710_s3_q <= not_587_s2_q & (drew_q & and_2708);
      and_2745_s3_q <= not_587_s2_q & (drew_q & and_2743);
      and_2805_s3_q <= not_587_s2_q & (drew_q & (half_ends & equal_2802));
      and_2806_s3_q <= and_2806;
      residual_s3_q <= residual[7:0];
      and_2842_s3_q <= and_2842;
      and_2856_s3_q <= and_2806 & less_2855;
      equal_2898_s3_q <= (registration_fresh_q & select_2896) == 4'h0;
      parity_3274_s3_q <= ^{xor_3270, xor_3233, select_3200[44:36], other[44:36]};
      parity_3403_s3_q <= parity_3403;
      parity_3465_s3_q <= parity_3465;
      xor_3493_s3_q <= parity_3480 ^ parity_3492;
      parity_3505_s3_q <= ^{or_3502, or_3498, and_3494};
      or_3509_s3_q <= (or_3498 & or_3502) | (and_3494 & (or_3498 | or_3502));
      equal_3510_s3_q <= equal_3510_s2_q;
      and_3610_s3_q <= equal_1788_s2_q & equal_3607_s2_q;
      less_3635_s3_q <= select_3600 < select_3602;
      equal_3934_s3_q <= equal_3934_s2_q;
      and_4116_s3_q <= said_q;
      and_4164_s3_q <= and_2161 & (sum_2085 == sum_2068);
      and_4166_s3_q <= and_4166_s2_q;
      equal_4244_s3_q <= (registration_fresh_q & select_4242) == 4'h0;
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
  logic [4:0] patches_on_skin_limit_q;
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
  logic [8:0] hidden_for_q;
  logic [1:0] hidden_more_q;
  logic hidden_ends_q;
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
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:284
  logic [11:0] texture;
  assign texture = sum_739_s3_q + {2'h0, sum_742_s3_q};
  // hls/stages/census.hpp:295
  logic [12:0] sum_744;
  assign sum_744 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_746;
  assign sum_746 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_744});
  // hls/stages/census.hpp:317
  logic less_747;
  assign less_747 = 9'h4 < sum_746[13:5];
  logic and_748;
  assign and_748 = and_698_s3_q & less_747;
  // hls/stages/moments.hpp:33
  logic and_760;
  assign and_760 = (and_723_s3_q & and_750_s3_q) & less_759_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_1680;
  assign equal_1680 = sum_1629_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1629_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1682;
  assign select_1682 = equal_1680 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1683;
  assign sum_1683 = (equal_1678_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1682[13]}}, select_1682};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1629_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1686;
  assign select_1686 = equal_1680 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1687;
  assign sum_1687 = (equal_1678_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1686[6]}}, select_1686};
  // hls/stages/patches.hpp:360
  logic [22:0] select_1804;
  assign select_1804 = and_1803_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1763_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:126
  logic is_chosen;
  assign is_chosen = select_1804[0] & less_1808_s3_q;
  // hls/stages/patches.hpp:127
  logic select_1811;
  assign select_1811 = equal_1706_s3_q ? patches_place_0_valid_q : (select_1705_s3_q ? patches_place_0_valid_q : is_chosen);
  // hls/stages/patches.hpp:132
  logic [7:0] sum_1812;
  assign sum_1812 = {1'b0, select_553_s3_q, select_520_s3_q[2]} + 8'h3;
  // hls/stages/patches.hpp:362
  logic [21:0] select_1813;
  assign select_1813 = select_1705_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1804[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1814;
  assign select_1814 = equal_1706_s3_q ? patches_place_0_column_q : select_1813[7:0];
  logic [5:0] select_1815;
  assign select_1815 = equal_1706_s3_q ? patches_place_0_shift_q : select_1813[13:8];
  // hls/stages/patches.hpp:331
  logic [7:0] sum_1816;
  assign sum_1816 = select_1814 + {{2{select_1815[5]}}, select_1815};
  // hls/stages/patches.hpp:132
  logic equal_1817;
  assign equal_1817 = {sum_1816, sum_1812[0], select_520_s3_q[1:0]} == {1'b0, sum_1812[7:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1819;
  assign or_1819 = row_starts_s3_q | (select_1811 & equal_1817);
  // hls/stages/agreement.hpp:277
  logic [4:0] select_1820;
  assign select_1820 = or_1819 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1830;
  assign select_1830 = or_1819 ? {row_starts_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1832;
  assign and_1832 = select_1829_s3_q & (~select_1830[5]);
  // hls/stages/patches.hpp:127
  logic select_1840;
  assign select_1840 = equal_1706_s3_q ? patches_place_1_valid_q : (select_1705_s3_q ? is_chosen : patches_place_1_valid_q);
  // hls/stages/patches.hpp:362
  logic [21:0] select_1841;
  assign select_1841 = select_1705_s3_q ? select_1804[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1842;
  assign select_1842 = equal_1706_s3_q ? patches_place_1_column_q : select_1841[7:0];
  logic [5:0] select_1843;
  assign select_1843 = equal_1706_s3_q ? patches_place_1_shift_q : select_1841[13:8];
  // hls/stages/patches.hpp:331
  logic [7:0] sum_1844;
  assign sum_1844 = select_1842 + {{2{select_1843[5]}}, select_1843};
  // hls/stages/patches.hpp:132
  logic equal_1845;
  assign equal_1845 = {sum_1844[7], sum_1812, select_520_s3_q[1:0]} == {1'b0, sum_1844[6:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1847;
  assign or_1847 = row_starts_s3_q | (select_1840 & equal_1845);
  // hls/stages/agreement.hpp:277
  logic [4:0] select_1848;
  assign select_1848 = or_1847 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1849;
  assign select_1849 = or_1847 ? {row_starts_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1851;
  assign and_1851 = select_1829_s3_q & (~select_1849[5]);
  // hls/stages/patches.hpp:326
  logic [6:0] sum_1858;
  assign sum_1858 = select_1814[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1859;
  assign equal_1859 = {sum_1858[6], select_553_s3_q, select_520_s3_q} == {1'b0, sum_1858[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_1861;
  assign or_1861 = row_starts_s3_q | (select_1811 & equal_1859);
  logic [4:0] select_1862;
  assign select_1862 = or_1861 ? {row_starts_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:326
  logic [6:0] sum_1863;
  assign sum_1863 = select_1842[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1864;
  assign equal_1864 = {sum_1863[6], select_553_s3_q, select_520_s3_q} == {1'b0, sum_1863[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_1867;
  assign select_1867 = (row_starts_s3_q | (select_1840 & equal_1864)) ? {row_starts_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1862[4] ? select_1867[3:0] : select_1862[3:0];
  // hls/stages/agreement.hpp:277
  logic select_1870;
  assign select_1870 = or_1861 ? row_starts_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_1876;
  assign and_1876 = (select_1829_s3_q & (select_1823_s3_q[3] ^ select_1823_s3_q[4])) & ((~select_1862[4]) | (~select_1867[4]));
  // hls/stages/patches.hpp:186
  logic less_1980;
  assign less_1980 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_1981;
  assign not_1981 = ~less_1980;
  logic [1:0] select_1982;
  assign select_1982 = patches_summed_first_s3_q ? 2'h2 : {less_1980, not_1981};
  logic [12:0] select_1983;
  assign select_1983 = select_1982[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1991;
  assign select_1991 = select_1982[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1990_s3_q, 1'b0, select_1987_s3_q, left_pixel_q};
  logic [14:0] select_1992;
  assign select_1992 = select_1982[1] ? {select_1983[12:8], patches_sums_values_0_q[9:8], select_1983[7:0]} : select_1991;
  // hls/stages/agreement.hpp:911
  logic [5:0] select_2020;
  assign select_2020 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:912
  logic [5:0] sum_2021;
  assign sum_2021 = {5'h0, and_2019_s3_q} + select_2020;
  // hls/stages/agreement.hpp:1077
  logic [9:0] sum_2023;
  assign sum_2023 = {4'h0, sum_2021} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:911
  logic [5:0] select_2026;
  assign select_2026 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:912
  logic [5:0] sum_2027;
  assign sum_2027 = {5'h0, and_2025_s3_q} + select_2026;
  // hls/stages/agreement.hpp:1078
  logic [9:0] sum_2029;
  assign sum_2029 = {4'h0, sum_2027} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:911
  logic [5:0] select_2037;
  assign select_2037 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:913
  logic [5:0] sum_2038;
  assign sum_2038 = {5'h0, and_2036_s3_q} + select_2037;
  // hls/stages/agreement.hpp:1079
  logic [9:0] sum_2040;
  assign sum_2040 = {4'h0, sum_2038} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1110
  logic [2:0] select_2094;
  assign select_2094 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2095;
  assign difference_2095 = {1'b0, textured_2_s3_q} - {1'b0, select_2094};
  logic [4:0] t;
  assign t = {difference_2095[3], difference_2095} + (equal_579_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1116
  logic equal_2098;
  assign equal_2098 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1117
  logic not_2110;
  assign not_2110 = ~region_row_s3_q[2];
  logic [2:0] select_2111;
  assign select_2111 = region_row_s3_q[1] ? {1'b0, not_2110, 1'b0} : {region_row_s3_q[2], 1'b0, not_2110};
  logic [5:0] select_2112;
  assign select_2112 = region_row_s3_q[0] ? {select_2111[2], 1'b0, select_2111[1], 1'b0, select_2111[0], 1'b0} : {1'b0, select_2111[2], 1'b0, select_2111[1], 1'b0, select_2111[0]};
  logic [11:0] select_2113;
  assign select_2113 = or_2109_s3_q ? {select_2112[5], 1'b0, select_2112[4], 1'b0, select_2112[3], 1'b0, select_2112[2], 1'b0, select_2112[1], 1'b0, select_2112[0], 1'b0} : {1'b0, select_2112[5], 1'b0, select_2112[4], 1'b0, select_2112[3], 1'b0, select_2112[2], 1'b0, select_2112[1], 1'b0, select_2112[0]};
  logic [23:0] select_2114;
  assign select_2114 = or_2106_s3_q ? {select_2113[11], 1'b0, select_2113[10], 1'b0, select_2113[9], 1'b0, select_2113[8], 1'b0, select_2113[7], 1'b0, select_2113[6], 1'b0, select_2113[5], 1'b0, select_2113[4], 1'b0, select_2113[3], 1'b0, select_2113[2], 1'b0, select_2113[1], 1'b0, select_2113[0], 1'b0} : {1'b0, select_2113[11], 1'b0, select_2113[10], 1'b0, select_2113[9], 1'b0, select_2113[8], 1'b0, select_2113[7], 1'b0, select_2113[6], 1'b0, select_2113[5], 1'b0, select_2113[4], 1'b0, select_2113[3], 1'b0, select_2113[2], 1'b0, select_2113[1], 1'b0, select_2113[0]};
  logic [47:0] select_2115;
  assign select_2115 = or_2103_s3_q ? {select_2114[23], 1'b0, select_2114[22], 1'b0, select_2114[21], 1'b0, select_2114[20], 1'b0, select_2114[19], 1'b0, select_2114[18], 1'b0, select_2114[17], 1'b0, select_2114[16], 1'b0, select_2114[15], 1'b0, select_2114[14], 1'b0, select_2114[13], 1'b0, select_2114[12], 1'b0, select_2114[11], 1'b0, select_2114[10], 1'b0, select_2114[9], 1'b0, select_2114[8], 1'b0, select_2114[7], 1'b0, select_2114[6], 1'b0, select_2114[5], 1'b0, select_2114[4], 1'b0, select_2114[3], 1'b0, select_2114[2], 1'b0, select_2114[1], 1'b0, select_2114[0], 1'b0} : {1'b0, select_2114[23], 1'b0, select_2114[22], 1'b0, select_2114[21], 1'b0, select_2114[20], 1'b0, select_2114[19], 1'b0, select_2114[18], 1'b0, select_2114[17], 1'b0, select_2114[16], 1'b0, select_2114[15], 1'b0, select_2114[14], 1'b0, select_2114[13], 1'b0, select_2114[12], 1'b0, select_2114[11], 1'b0, select_2114[10], 1'b0, select_2114[9], 1'b0, select_2114[8], 1'b0, select_2114[7], 1'b0, select_2114[6], 1'b0, select_2114[5], 1'b0, select_2114[4], 1'b0, select_2114[3], 1'b0, select_2114[2], 1'b0, select_2114[1], 1'b0, select_2114[0]};
  // hls/stages/agreement.hpp:1045
  logic and_2119;
  assign and_2119 = good_known_q & (~((good_q & select_2115) == 48'h0));
  // hls/stages/agreement.hpp:1112
  logic [2:0] select_2128;
  assign select_2128 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2129;
  assign difference_2129 = {1'b0, shown_2_s3_q} - {1'b0, select_2128};
  logic [4:0] around;
  assign around = {difference_2129[3], difference_2129} + (equal_579_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1119
  logic [5:0] sum_2132;
  assign sum_2132 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2098 ? and_2119 : (~({sum_2132, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1113
  logic [2:0] select_2144;
  assign select_2144 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2145;
  assign difference_2145 = {1'b0, near_2_s3_q} - {1'b0, select_2144};
  logic [4:0] n;
  assign n = {difference_2145[3], difference_2145} + (equal_579_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1129
  logic and_2149;
  assign and_2149 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_2187;
  assign select_2187 = sample_pair_whole_s3_q ? (and_557_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2189;
  assign select_2189 = sample_pair_whole_s3_q ? (and_557_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2191;
  assign select_2191 = sample_pair_whole_s3_q ? (and_557_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2193;
  assign select_2193 = sample_pair_whole_s3_q ? (and_557_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2198;
  assign sum_2198 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2199;
  assign difference_2199 = {1'b0, sum_2198[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2200;
  assign xor_2200 = {difference_2199[8:0], sum_2198[0]} ^ {10{difference_2199[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2199[9]} + {1'b0, xor_2200};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_562_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2205;
  assign select_2205 = sample_pair_whole_s3_q ? (and_557_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2206;
  assign sum_2206 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2207;
  assign difference_2207 = {1'b0, sum_2206[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2208;
  assign xor_2208 = {difference_2207[8:0], sum_2206[0]} ^ {10{difference_2207[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2207[9]} + {1'b0, xor_2208};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_562_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2213;
  assign select_2213 = sample_pair_whole_s3_q ? (and_557_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2297;
  assign sum_2297 = sum_2293_s3_q + {2'h0, sum_2296_s3_q};
  // hls/stages/agreement.hpp:531
  logic [11:0] select_2299;
  assign select_2299 = and_559_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2300;
  assign select_2300 = and_559_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2301;
  assign select_2301 = and_559_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2302;
  assign select_2302 = and_559_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2305;
  assign sum_2305 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2297};
  logic [13:0] sum_2307;
  assign sum_2307 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2305});
  // hls/stages/census.hpp:323
  logic and_2309;
  assign and_2309 = and_723_s3_q & (9'h4 < sum_2307[13:5]);
  // hls/stages/census.hpp:324
  logic and_2310;
  assign and_2310 = and_723_s3_q & less_747;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2311;
  assign sum_2311 = census_left_misses_q + {{17{and_2310}}, and_2309, 1'b0, and_2309};
  // hls/stages/agreement.hpp:531
  logic [19:0] select_2313;
  assign select_2313 = and_559_s3_q ? (equal_2304_s3_q ? 20'h0 : sum_2311) : census_left_misses_q;
  // hls/stages/agreement.hpp:277
  logic [27:0] select_2393;
  assign select_2393 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:531
  logic select_2396;
  assign select_2396 = and_559_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2399;
  assign and_2399 = whole_2_s3_q & (~(last_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:462
  logic and_2405;
  assign and_2405 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2406;
  assign and_2406 = and_2399 & and_2405;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2393[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2408;
  assign select_2408 = and_2406 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2410;
  assign select_2410 = equal_2304_s3_q ? {11'h0, select_2408} : (sharpness_sums_detail_0_q + {11'h0, select_2408});
  // hls/stages/agreement.hpp:462
  logic and_2417;
  assign and_2417 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2418;
  assign and_2418 = and_2399 & and_2417;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2393[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2420;
  assign select_2420 = and_2418 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2422;
  assign select_2422 = equal_2304_s3_q ? {11'h0, select_2420} : (sharpness_sums_detail_1_q + {11'h0, select_2420});
  logic [8:0] select_2425;
  assign select_2425 = and_2406 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2426;
  assign sum_2426 = (equal_2304_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2425};
  logic [8:0] select_2429;
  assign select_2429 = and_2418 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2430;
  assign sum_2430 = (equal_2304_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2429};
  // hls/stages/census.hpp:388
  logic less_2433;
  assign less_2433 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2434;
  assign less_2434 = x_s3_q[4:0] < 5'h3;
  logic not_2435;
  assign not_2435 = ~x_s3_q[1];
  logic [2:0] select_2436;
  assign select_2436 = x_s3_q[0] ? {1'b0, not_2435, 1'b0} : {x_s3_q[1], 1'b0, not_2435};
  logic [5:0] select_2437;
  assign select_2437 = slot_s3_q[2] ? {select_2436[2], 1'b0, select_2436[1], 1'b0, select_2436[0], 1'b0} : {1'b0, select_2436[2], 1'b0, select_2436[1], 1'b0, select_2436[0]};
  logic [11:0] select_2438;
  assign select_2438 = slot_s3_q[1] ? {select_2437[5], 1'b0, select_2437[4], 1'b0, select_2437[3], 1'b0, select_2437[2], 1'b0, select_2437[1], 1'b0, select_2437[0], 1'b0} : {1'b0, select_2437[5], 1'b0, select_2437[4], 1'b0, select_2437[3], 1'b0, select_2437[2], 1'b0, select_2437[1], 1'b0, select_2437[0]};
  logic [23:0] select_2439;
  assign select_2439 = slot_s3_q[0] ? {select_2438[11], 1'b0, select_2438[10], 1'b0, select_2438[9], 1'b0, select_2438[8], 1'b0, select_2438[7], 1'b0, select_2438[6], 1'b0, select_2438[5], 1'b0, select_2438[4], 1'b0, select_2438[3], 1'b0, select_2438[2], 1'b0, select_2438[1], 1'b0, select_2438[0], 1'b0} : {1'b0, select_2438[11], 1'b0, select_2438[10], 1'b0, select_2438[9], 1'b0, select_2438[8], 1'b0, select_2438[7], 1'b0, select_2438[6], 1'b0, select_2438[5], 1'b0, select_2438[4], 1'b0, select_2438[3], 1'b0, select_2438[2], 1'b0, select_2438[1], 1'b0, select_2438[0]};
  // hls/stages/census.hpp:390
  logic and_2443;
  assign and_2443 = less_2434 & (~((sharpness_sums_contrast_1_q & select_2439) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2445;
  assign select_2445 = (less_2433 & and_2443) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2445};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2448;
  assign select_2448 = equal_2432_s3_q ? (less_2433 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2453;
  assign and_2453 = less_2434 & (~((sharpness_sums_contrast_0_q & select_2439) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2455;
  assign select_2455 = (less_2433 & and_2453) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2455};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2458;
  assign select_2458 = equal_2432_s3_q ? (less_2433 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2460;
  assign select_2460 = equal_2432_s3_q ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2462;
  assign select_2462 = equal_2432_s3_q ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2464;
  assign select_2464 = equal_2432_s3_q ? {sharpness_comparing_contrast_0_q[0], and_2453} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2466;
  assign select_2466 = equal_2432_s3_q ? {sharpness_comparing_contrast_1_q[0], and_2443} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:217
  logic select_2471;
  assign select_2471 = so_s3_q ? (equal_2432_s3_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:217
  logic select_2474;
  assign select_2474 = equal_2432_s3_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2476;
  assign equal_2476 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2477;
  assign xor_2477 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2480;
  assign select_2480 = (equal_2476 | xor_2477) ? (five_times[0] & xor_2477) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2481;
  assign select_2481 = equal_2432_s3_q ? select_2480 : sharpness_comparing_less_detail_0_q;
  logic select_2482;
  assign select_2482 = so_s3_q ? select_2481 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2483;
  assign xor_2483 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2486;
  assign select_2486 = (equal_2476 | xor_2483) ? (five_times_2[0] & xor_2483) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2487;
  assign select_2487 = equal_2432_s3_q ? select_2486 : sharpness_comparing_less_detail_1_q;
  logic select_2488;
  assign select_2488 = so_s3_q ? select_2487 : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2489;
  assign xor_2489 = sharpness_comparing_contrast_0_q[1] ^ and_2443;
  logic select_2492;
  assign select_2492 = (equal_2476 | xor_2489) ? (and_2443 & xor_2489) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2493;
  assign select_2493 = equal_2432_s3_q ? select_2492 : sharpness_comparing_less_contrast_0_q;
  logic select_2494;
  assign select_2494 = so_s3_q ? select_2493 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2495;
  assign xor_2495 = sharpness_comparing_contrast_1_q[1] ^ and_2453;
  logic select_2498;
  assign select_2498 = (equal_2476 | xor_2495) ? (and_2453 & xor_2495) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2499;
  assign select_2499 = equal_2432_s3_q ? select_2498 : sharpness_comparing_less_contrast_1_q;
  logic select_2500;
  assign select_2500 = so_s3_q ? select_2499 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:937
  logic [13:0] select_2647;
  assign select_2647 = and_2638_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2645_s3_q});
  // hls/stages/agreement.hpp:799
  logic and_2650;
  assign and_2650 = not_587_s3_q & (so_s3_q & (ends_cell_s3_q & and_2019_s3_q));
  logic and_2655;
  assign and_2655 = not_587_s3_q & (so_s3_q & (ends_cell_s3_q & and_2025_s3_q));
  logic and_2660;
  assign and_2660 = not_587_s3_q & (so_s3_q & (ends_cell_s3_q & and_2036_s3_q));
  // hls/stages/agreement.hpp:1111
  logic [2:0] select_2675;
  assign select_2675 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2676;
  assign difference_2676 = {1'b0, explained_2_s3_q} - {1'b0, select_2675};
  logic [4:0] e;
  assign e = {difference_2676[3], difference_2676} + (equal_579_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1118
  logic [5:0] sum_2679;
  assign sum_2679 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1123
  logic not_2683;
  assign not_2683 = ~(equal_2098 ? and_2119 : (~({sum_2679, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:799
  logic and_2686;
  assign and_2686 = ends_cell_s3_q & (not_2666_s3_q & (centres_values_1_textured_s3_q & not_2683));
  logic and_2688;
  assign and_2688 = not_587_s3_q & (so_s3_q & and_2686);
  // hls/stages/agreement.hpp:1149
  logic less_2691;
  assign less_2691 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2692;
  assign select_2692 = less_2691 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2695;
  assign select_2695 = less_2691 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1150
  logic [10:0] sum_2696;
  assign sum_2696 = {1'b0, select_2695} + {3'h0, select_2695[9:2]};
  logic and_2698;
  assign and_2698 = (~(select_2692[9:4] == 6'h0)) & ({sum_2696, select_2695[1:0]} < {3'h0, select_2692});
  // hls/stages/agreement.hpp:1159
  logic [9:0] select_2701;
  assign select_2701 = x_s3_q[6] ? (equal_1623_s3_q ? 10'h0 : (and_2698 ? select_2692 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:799
  logic [9:0] select_2702;
  assign select_2702 = equal_586_s3_q ? select_2701 : 10'h0;
  // hls/stages/agreement.hpp:937
  logic [13:0] select_2704;
  assign select_2704 = and_2638_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2702});
  logic [13:0] select_2712;
  assign select_2712 = and_2638_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2710_s3_q});
  // hls/stages/agreement.hpp:1127
  logic and_2714;
  assign and_2714 = not_2666_s3_q & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:799
  logic and_2717;
  assign and_2717 = not_587_s3_q & (so_s3_q & (ends_cell_s3_q & and_2714));
  // hls/stages/agreement.hpp:937
  logic [13:0] select_2719;
  assign select_2719 = and_2638_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2717});
  // hls/stages/agreement.hpp:1127
  logic and_2721;
  assign and_2721 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2683);
  // hls/stages/agreement.hpp:799
  logic and_2725;
  assign and_2725 = not_587_s3_q & (so_s3_q & (ends_cell_s3_q & (not_2666_s3_q & and_2721)));
  // hls/stages/agreement.hpp:937
  logic [13:0] select_2727;
  assign select_2727 = and_2638_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2725});
  logic [13:0] select_2747;
  assign select_2747 = and_2638_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2745_s3_q});
  // hls/stages/agreement.hpp:799
  logic [7:0] select_2824;
  assign select_2824 = so_s3_q ? (equal_1716_s3_q ? (and_2806_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2825;
  assign select_2825 = equal_586_s3_q ? 8'h0 : select_2824;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2827;
  assign select_2827 = and_2805_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2825[7]}}, select_2825});
  // hls/stages/agreement.hpp:799
  logic and_2830;
  assign and_2830 = not_587_s3_q & (so_s3_q & (and_2806_s3_q & equal_1716_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2832;
  assign select_2832 = and_2805_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2830});
  // hls/stages/registration.hpp:107
  logic and_2834;
  assign and_2834 = and_2806_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:799
  logic [1:0] select_2836;
  assign select_2836 = so_s3_q ? (equal_1716_s3_q ? {and_2834, and_2806_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2837;
  assign select_2837 = equal_586_s3_q ? 2'h0 : select_2836;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2838;
  assign sum_2838 = registration_half_votes_down_q + {{5{select_2837[1]}}, select_2837};
  // hls/stages/agreement.hpp:799
  logic [1:0] select_2844;
  assign select_2844 = so_s3_q ? (equal_1716_s3_q ? {and_2842_s3_q, and_2806_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2845;
  assign select_2845 = equal_586_s3_q ? 2'h0 : select_2844;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2846;
  assign sum_2846 = registration_half_votes_up_q + {{5{select_2845[1]}}, select_2845};
  // hls/stages/registration.hpp:107
  logic and_2849;
  assign and_2849 = and_2806_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:799
  logic [1:0] select_2851;
  assign select_2851 = so_s3_q ? (equal_1716_s3_q ? {and_2849, and_2806_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2852;
  assign select_2852 = equal_586_s3_q ? 2'h0 : select_2851;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2853;
  assign sum_2853 = registration_half_half_votes_down_q + {{5{select_2852[1]}}, select_2852};
  // hls/stages/agreement.hpp:799
  logic [1:0] select_2858;
  assign select_2858 = so_s3_q ? (equal_1716_s3_q ? {and_2856_s3_q, and_2806_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2859;
  assign select_2859 = equal_586_s3_q ? 2'h0 : select_2858;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2860;
  assign sum_2860 = registration_half_half_votes_up_q + {{5{select_2859[1]}}, select_2859};
  // hls/stages/agreement.hpp:799
  logic and_2893;
  assign and_2893 = equal_586_s3_q & (x_s3_q[6] & (not_2004_s3_q & less_1654_s3_q));
  // hls/stages/agreement.hpp:1147
  logic [11:0] select_2900;
  assign select_2900 = or_1658_s3_q ? 12'h0 : (equal_2898_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1159
  logic [11:0] select_2903;
  assign select_2903 = x_s3_q[6] ? (equal_1623_s3_q ? 12'h0 : (less_1654_s3_q ? select_2900 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:799
  logic [11:0] select_2904;
  assign select_2904 = equal_586_s3_q ? select_2903 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2905;
  assign and_2905 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1159
  logic and_2908;
  assign and_2908 = not_2004_s3_q & (less_1654_s3_q & ({and_2905, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:799
  logic and_2910;
  assign and_2910 = equal_586_s3_q & (x_s3_q[6] & and_2908);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2912;
  assign sum_2912 = {{2{select_2904[11]}}, select_2904} + (and_2910 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1147
  logic [11:0] select_2915;
  assign select_2915 = or_1658_s3_q ? 12'h0 : (equal_2898_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1159
  logic [11:0] select_2918;
  assign select_2918 = x_s3_q[6] ? (equal_1623_s3_q ? 12'h0 : (less_1654_s3_q ? select_2915 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:799
  logic [11:0] select_2919;
  assign select_2919 = equal_586_s3_q ? select_2918 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2921;
  assign sum_2921 = {{2{select_2919[11]}}, select_2919} + (and_2910 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2923;
  assign not_2923 = ~all_s3_q;
  // hls/stages/agreement.hpp:1159
  logic and_2926;
  assign and_2926 = not_2004_s3_q & (less_1654_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2923, 1'b0}));
  // hls/stages/agreement.hpp:799
  logic and_2932;
  assign and_2932 = equal_586_s3_q & (x_s3_q[6] & (not_2004_s3_q & (less_1654_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2933;
  assign not_2933 = ~and_2932;
  logic less_2934;
  assign less_2934 = $signed({9'h1, {2{not_2933}}, and_2932}) < $signed(registration_up_q[13:2]);
  logic select_2935;
  assign select_2935 = (equal_586_s3_q & (x_s3_q[6] & and_2926)) ? less_2934 : registration_enough_q;
  // hls/stages/agreement.hpp:1159
  logic and_2939;
  assign and_2939 = x_s3_q[6] & (not_2004_s3_q & (less_1654_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:799
  logic and_2940;
  assign and_2940 = equal_586_s3_q & and_2939;
  // hls/stages/registration.hpp:242
  logic less_2941;
  assign less_2941 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2943;
  assign less_2943 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2945;
  assign equal_2945 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:799
  logic and_2949;
  assign and_2949 = equal_586_s3_q & (x_s3_q[6] & (not_2004_s3_q & (less_1654_s3_q & equal_2945)));
  // hls/stages/agreement.hpp:1159
  logic and_2956;
  assign and_2956 = x_s3_q[6] & (not_2004_s3_q & (less_1654_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2959;
  assign equal_2959 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1159
  logic and_2962;
  assign and_2962 = not_2004_s3_q & (less_1654_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2959));
  // hls/stages/registration.hpp:244
  logic and_2966;
  assign and_2966 = (equal_586_s3_q & (x_s3_q[6] & and_2962)) & (less_2943 | less_2941);
  // hls/stages/agreement.hpp:1159
  logic and_2971;
  assign and_2971 = not_2004_s3_q & (less_1654_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2959)));
  // hls/stages/registration.hpp:244
  logic and_2974;
  assign and_2974 = registration_votes_up_q & registration_other_down_q;
  logic select_2976;
  assign select_2976 = registration_votes_down_q ? (registration_other_up_q | and_2974) : and_2974;
  // hls/stages/registration.hpp:138
  logic and_2978;
  assign and_2978 = (equal_586_s3_q & (x_s3_q[6] & and_2971)) & (registration_other_enough_q & select_2976);
  // hls/stages/registration.hpp:245
  logic or_2981;
  assign or_2981 = registration_moved_q | (registration_enough_q & (and_2966 | and_2978));
  // hls/stages/agreement.hpp:277
  logic [7:0] select_3063;
  assign select_3063 = sample_pair_whole_s3_q ? (equal_1706_s3_q ? patches_place_0_slope_q : select_1813[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3068;
  assign select_3068 = sample_pair_whole_s3_q ? (equal_1706_s3_q ? patches_place_1_slope_q : select_1841[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3070;
  assign select_3070 = equal_1706_s3_q ? patches_valid_0_q : (select_1705_s3_q ? patches_valid_0_q : is_chosen);
  // hls/stages/agreement.hpp:277
  logic select_3073;
  assign select_3073 = sample_pair_whole_s3_q ? (and_1832 ? (sample_present_s3_q & select_3070) : select_3070) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3075;
  assign select_3075 = equal_1706_s3_q ? patches_valid_1_q : (select_1705_s3_q ? is_chosen : patches_valid_1_q);
  // hls/stages/agreement.hpp:277
  logic select_3078;
  assign select_3078 = sample_pair_whole_s3_q ? (and_1851 ? (sample_present_s3_q & select_3075) : select_3075) : patches_valid_1_q;
  logic [5:0] select_3081;
  assign select_3081 = sample_pair_whole_s3_q ? (select_1830[5] ? {1'b1, select_1830[4:0]} : (select_1830 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3084;
  assign select_3084 = sample_pair_whole_s3_q ? (select_1849[5] ? {1'b1, select_1849[4:0]} : (select_1849 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3087;
  assign select_3087 = sample_pair_whole_s3_q ? (select_1862[4] ? {1'b1, select_1862[3:0]} : (select_1862 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3090;
  assign select_3090 = sample_pair_whole_s3_q ? (select_1867[4] ? {1'b1, select_1867[3:0]} : (select_1867 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:534
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3509_s3_q, parity_3505_s3_q, xor_3493_s3_q, parity_3465_s3_q, parity_3403_s3_q, parity_3274_s3_q} + (equal_3510_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3514;
  assign select_3514 = equal_1788_s3_q ? patches_sums_values_0_q : (equal_1790_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3515;
  assign select_3515 = equal_1790_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3517;
  assign select_3517 = equal_1790_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3519;
  assign select_3519 = equal_1790_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3521;
  assign select_3521 = equal_1790_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3523;
  assign select_3523 = equal_1790_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3525;
  assign select_3525 = equal_1790_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3527;
  assign select_3527 = equal_1790_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3529;
  assign select_3529 = equal_1790_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3531;
  assign select_3531 = equal_1790_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3533;
  assign select_3533 = equal_1790_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3535;
  assign select_3535 = equal_1790_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3537;
  assign select_3537 = equal_1790_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3539;
  assign select_3539 = equal_1790_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3541;
  assign select_3541 = equal_1790_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3543;
  assign select_3543 = equal_1790_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3545;
  assign select_3545 = equal_1790_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:606
  logic [9:0] difference_3616;
  assign difference_3616 = patches_peak_far_q - patches_peak_best_differing_q;
  logic and_3619;
  assign and_3619 = (~(patches_peak_far_q < patches_peak_best_differing_q)) & (~({difference_3616, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:605
  logic not_3622;
  assign not_3622 = ~({1'b0, patches_peak_size_q[9:1]} < patches_peak_best_differing_q);
  // hls/stages/patches.hpp:613
  logic and_3625;
  assign and_3625 = (patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q) & (and_3619 & ((10'h38 < patches_peak_size_q) & not_3622));
  // hls/stages/patches.hpp:190
  logic and_3627;
  assign and_3627 = and_3610_s3_q & ((~(patches_peak_row_q[3:0] == 4'h0)) & and_3625);
  // hls/stages/patches.hpp:672
  logic not_3628;
  assign not_3628 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:192
  logic and_3630;
  assign and_3630 = and_3627 & (not_1795_s3_q & not_3628);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3632;
  assign sum_3632 = {7'h0, and_3630} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:591
  logic [1:0] sum_3636;
  assign sum_3636 = patches_peak_row_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:586
  logic [9:0] high;
  assign high = less_3635_s3_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = (patches_peak_below_q < patches_peak_above_q) ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:587
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - patches_peak_best_differing_q;
  // hls/stages/patches.hpp:589
  logic not_3643;
  assign not_3643 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3644;
  assign sum_3644 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3646;
  assign not_3646 = ~({eight, 3'h0} < {1'b0, sum_3644, fall_2[0]});
  logic [1:0] sum_3647;
  assign sum_3647 = {1'b0, not_3643} + {1'b0, not_3646};
  // hls/stages/patches.hpp:590
  logic [10:0] sum_3648;
  assign sum_3648 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3650;
  assign not_3650 = ~({eight, 3'h0} < {sum_3648, fall_2[1:0]});
  logic not_3653;
  assign not_3653 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3654;
  assign sum_3654 = {1'b0, not_3650} + {1'b0, not_3653};
  // hls/stages/patches.hpp:589
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3647} + {1'b0, sum_3654};
  // hls/stages/patches.hpp:592
  logic [7:0] select_3657;
  assign select_3657 = less_3635_s3_q ? ({sum_3636, patches_peak_row_q[2:0], 3'h0} - {5'h0, fraction}) : {sum_3636, patches_peak_row_q[2:0], fraction};
  // hls/stages/patches.hpp:609
  logic [7:0] select_3658;
  assign select_3658 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:608
  logic [5:0] select_3659;
  assign select_3659 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3660;
  assign sum_3660 = {2'h0, patches_peak_best_column_q[4:3]} + 4'hf;
  logic [6:0] sum_3661;
  assign sum_3661 = {select_3659[5], select_3659} + {{3{sum_3660[3]}}, sum_3660};
  // hls/stages/patches.hpp:609
  logic [17:0] product_3662;
  assign product_3662 = $signed({{10{select_3658[7]}}, select_3658}) * $signed({{8{sum_3661[6]}}, sum_3661, patches_peak_best_column_q[2:0]});
  // hls/stages/patches.hpp:610
  logic [13:0] difference_3663;
  assign difference_3663 = {{6{select_3657[7]}}, select_3657} - {product_3662[17], product_3662[17:5]};
  // hls/stages/patches.hpp:616
  logic less_3664;
  assign less_3664 = $signed({{7{difference_3634[6]}}, difference_3634}) < $signed(difference_3663);
  // hls/stages/patches.hpp:189
  logic not_3665;
  assign not_3665 = ~less_3664;
  // hls/stages/patches.hpp:675
  logic and_3666;
  assign and_3666 = not_3665 & and_3630;
  logic [7:0] sum_3667;
  assign sum_3667 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3666};
  // hls/stages/patches.hpp:189
  logic not_3670;
  assign not_3670 = ~($signed(difference_3663) < $signed({8'h0, cfg_patch_limit_i}));
  // hls/stages/patches.hpp:676
  logic and_3671;
  assign and_3671 = not_3670 & and_3630;
  logic [7:0] sum_3672;
  assign sum_3672 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3671};
  // hls/stages/patches.hpp:192
  logic and_3674;
  assign and_3674 = and_3627 & (patches_second_s3_q & not_3628);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3676;
  assign sum_3676 = {7'h0, and_3674} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:675
  logic and_3678;
  assign and_3678 = not_3665 & and_3674;
  logic [7:0] sum_3679;
  assign sum_3679 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3678};
  // hls/stages/patches.hpp:676
  logic and_3681;
  assign and_3681 = not_3670 & and_3674;
  logic [7:0] sum_3682;
  assign sum_3682 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3681};
  // hls/stages/patches.hpp:192
  logic and_3684;
  assign and_3684 = and_3627 & (patches_lower_s3_q & not_1795_s3_q);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3686;
  assign sum_3686 = {7'h0, and_3684} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:675
  logic and_3688;
  assign and_3688 = not_3665 & and_3684;
  logic [7:0] sum_3689;
  assign sum_3689 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3688};
  // hls/stages/patches.hpp:676
  logic and_3691;
  assign and_3691 = not_3670 & and_3684;
  logic [7:0] sum_3692;
  assign sum_3692 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3691};
  // hls/stages/patches.hpp:192
  logic and_3694;
  assign and_3694 = and_3627 & (patches_lower_s3_q & patches_second_s3_q);
  // hls/stages/patches.hpp:674
  logic [7:0] sum_3696;
  assign sum_3696 = {7'h0, and_3694} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:675
  logic and_3698;
  assign and_3698 = not_3665 & and_3694;
  logic [7:0] sum_3699;
  assign sum_3699 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3698};
  // hls/stages/patches.hpp:676
  logic and_3701;
  assign and_3701 = not_3670 & and_3694;
  logic [7:0] sum_3702;
  assign sum_3702 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3701};
  // hls/stages/agreement.hpp:1253
  logic equal_3703;
  assign equal_3703 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1147
  logic less_3704;
  assign less_3704 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:799
  logic and_3708;
  assign and_3708 = equal_586_s3_q & (x_s3_q[6] & (not_2004_s3_q & (equal_3703 & less_3704)));
  // hls/stages/agreement.hpp:1159
  logic and_3713;
  assign and_3713 = x_s3_q[6] & (not_2004_s3_q & (less_3704 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:799
  logic and_3714;
  assign and_3714 = equal_586_s3_q & and_3713;
  // hls/stages/patches.hpp:638
  logic [7:0] or_3716;
  assign or_3716 = (and_3708 ? patches_quarters_0_places_q : 8'h0) | (and_3714 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1159
  logic and_3720;
  assign and_3720 = x_s3_q[6] & (not_2004_s3_q & (less_3704 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:799
  logic and_3721;
  assign and_3721 = equal_586_s3_q & and_3720;
  // hls/stages/agreement.hpp:1159
  logic and_3727;
  assign and_3727 = x_s3_q[6] & (not_2004_s3_q & (less_3704 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:799
  logic and_3728;
  assign and_3728 = equal_586_s3_q & and_3727;
  // hls/stages/patches.hpp:638
  logic [7:0] or_3730;
  assign or_3730 = (or_3716 | (and_3721 ? patches_quarters_2_places_q : 8'h0)) | (and_3728 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:203
  logic select_3734;
  assign select_3734 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:799
  logic and_3738;
  assign and_3738 = equal_586_s3_q & (x_s3_q[6] & (not_2004_s3_q & (less_3704 & select_3734)));
  // hls/stages/patches.hpp:639
  logic [7:0] select_3740;
  assign select_3740 = and_3708 ? (and_3738 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3742;
  assign select_3742 = and_3714 ? (and_3738 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3745;
  assign select_3745 = and_3721 ? (and_3738 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3748;
  assign select_3748 = and_3728 ? (and_3738 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:640
  logic [7:0] select_3751;
  assign select_3751 = and_3708 ? (and_3738 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3753;
  assign select_3753 = and_3714 ? (and_3738 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3756;
  assign select_3756 = and_3721 ? (and_3738 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3759;
  assign select_3759 = and_3728 ? (and_3738 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:206
  logic [4:0] sum_3761;
  assign sum_3761 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1159
  logic and_3765;
  assign and_3765 = x_s3_q[6] & (not_2004_s3_q & (less_3704 & (sum_3761[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:799
  logic and_3766;
  assign and_3766 = equal_586_s3_q & and_3765;
  // hls/stages/patches.hpp:635
  logic [7:0] select_3769;
  assign select_3769 = and_3766 ? (patches_word_places_q + (and_3714 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3772;
  assign select_3772 = and_3766 ? (patches_word_up_q + (and_3714 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3775;
  assign select_3775 = and_3766 ? (patches_word_down_q + (and_3714 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:189
  logic [5:0] select_3778;
  assign select_3778 = ($signed(difference_3663[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3663[5:0];
  logic [5:0] select_3779;
  assign select_3779 = ($signed(14'h10) < $signed(difference_3663)) ? 6'h10 : select_3778;
  // hls/stages/patches.hpp:678
  logic [5:0] select_3780;
  assign select_3780 = and_3627 ? select_3779 : 6'h0;
  // hls/stages/patches.hpp:679
  logic [11:0] select_3782;
  assign select_3782 = patches_round_ends_q ? {{6{select_3780[5]}}, select_3780} : (patches_across_q + {{6{select_3780[5]}}, select_3780});
  // hls/stages/agreement.hpp:799
  logic and_3786;
  assign and_3786 = equal_586_s3_q & (x_s3_q[6] & (not_2004_s3_q & (equal_2945 & less_3704)));
  // hls/stages/agreement.hpp:1159
  logic and_3790;
  assign and_3790 = x_s3_q[6] & (not_2004_s3_q & (less_3704 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:799
  logic and_3791;
  assign and_3791 = equal_586_s3_q & and_3790;
  // hls/stages/patches.hpp:662
  logic [7:0] select_3793;
  assign select_3793 = and_3786 ? (and_3791 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:664
  logic or_3797;
  assign or_3797 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:665
  logic or_3800;
  assign or_3800 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:666
  logic [8:0] sum_3801;
  assign sum_3801 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:661
  logic select_3803;
  assign select_3803 = and_3786 ? (and_3791 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_3805;
  assign and_3805 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:661
  logic [2:0] select_3807;
  assign select_3807 = and_3791 ? {and_3805, patches_found_q[2:1]} : (and_3786 ? {and_3805, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:660
  logic or_3811;
  assign or_3811 = patches_partly_q | (patches_doubted_q & (~and_3791));
  // hls/stages/patches.hpp:661
  logic select_3814;
  assign select_3814 = and_3786 ? (and_3791 ? or_3811 : (and_3786 ? or_3811 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:659
  logic select_3815;
  assign select_3815 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:648
  logic [7:0] select_3819;
  assign select_3819 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:617
  logic [10:0] sum_3821;
  assign sum_3821 = {sum_3661[6], sum_3661, patches_peak_best_column_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:679
  logic and_3823;
  assign and_3823 = ({{5{sum_3821[10]}}, sum_3821} < 16'h3) & and_3627;
  logic [7:0] sum_3824;
  assign sum_3824 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3823};
  // hls/stages/patches.hpp:668
  logic [12:0] product_3829;
  assign product_3829 = {8'h0, patches_on_skin_limit_q} * {5'h0, select_3793};
  // hls/stages/patches.hpp:192
  logic and_3831;
  assign and_3831 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_3829[12:5] < patches_on_skin_q);
  logic select_3836;
  assign select_3836 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:649
  logic or_3840;
  assign or_3840 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:650
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:651
  logic select_3847;
  assign select_3847 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:652
  logic and_3853;
  assign and_3853 = moments_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3854;
  assign sum_3854 = patches_age_q + {9'h0, and_3853};
  logic [9:0] select_3857;
  assign select_3857 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3854)) : sum_3854;
  // hls/stages/agreement.hpp:1218
  logic or_3915;
  assign or_3915 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1247
  logic equal_3917;
  assign equal_3917 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1256
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1257
  logic select_3923;
  assign select_3923 = (equal_3917 & equal_3703) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1152
  logic [10:0] sum_3926;
  assign sum_3926 = {1'b0, select_2695} + {2'h0, select_2695[9:1]};
  logic select_3929;
  assign select_3929 = (select_2692[9:3] == 7'h0) ? ((~or_3915) & (~select_3923)) : (~({sum_3926, select_2695[0]} < {2'h0, select_2692}));
  // hls/stages/agreement.hpp:1159
  logic [47:0] select_3931;
  assign select_3931 = x_s3_q[6] ? (equal_1623_s3_q ? good_q : {select_3929, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:799
  logic select_3936;
  assign select_3936 = equal_586_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3934_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1165
  logic [8:0] select_3938;
  assign select_3938 = hidden_ends_q ? 9'h0 : (hidden_for_q + {{7{hidden_more_q[0]}}, hidden_more_q});
  // hls/stages/agreement.hpp:1177
  logic [8:0] select_3939;
  assign select_3939 = equal_3934_s3_q ? select_3938 : hidden_for_q;
  // hls/stages/agreement.hpp:1247
  logic equal_3941;
  assign equal_3941 = x_s3_q[6:3] == 4'ha;
  logic equal_3943;
  assign equal_3943 = x_s3_q[6:3] == 4'hc;
  logic equal_3944;
  assign equal_3944 = x_s3_q[6:3] == 4'hb;
  logic equal_3945;
  assign equal_3945 = x_s3_q[6:3] == 4'h9;
  logic equal_3946;
  assign equal_3946 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1142
  logic [13:0] select_3948;
  assign select_3948 = equal_3945 ? counts_skin_unproven_q : (equal_3946 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3950;
  assign select_3950 = equal_3944 ? counts_regions_bad_q : (equal_3941 ? counts_nearer_q : select_3948);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3943 ? counts_on_skin_q : select_3950;
  // hls/stages/agreement.hpp:1252
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1260
  logic select_3953;
  assign select_3953 = (equal_3941 & equal_3703) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1179
  logic not_3954;
  assign not_3954 = ~select_3953;
  // hls/stages/agreement.hpp:1180
  logic or_3957;
  assign or_3957 = not_3954 | (~(hidden_for_q[8:1] == 8'hff));
  // hls/stages/agreement.hpp:799
  logic select_3962;
  assign select_3962 = equal_586_s3_q ? (not_3954 & (cfg_same_table_i | (hidden_for_q == 9'h0))) : hidden_ends_q;
  // hls/stages/agreement.hpp:1261
  logic [13:0] select_3963;
  assign select_3963 = equal_3703 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1142
  logic [7:0] select_3965;
  assign select_3965 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3967;
  assign select_3967 = equal_3946 ? cfg_unproven_skin_limit_i : (equal_3917 ? cfg_unproven_limit_i : select_3965);
  logic [7:0] select_3969;
  assign select_3969 = equal_3941 ? cfg_regions_limit_i : (equal_3945 ? cfg_hidden_limit_i : select_3967);
  logic [7:0] limit;
  assign limit = equal_3943 ? cfg_regions_limit_i : (equal_3944 ? {cfg_on_skin_limit_i, 3'h0} : select_3969);
  // hls/stages/agreement.hpp:1261
  logic not_3972;
  assign not_3972 = ~x_s3_q[2];
  logic [3:0] select_3973;
  assign select_3973 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3972, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3972};
  logic [7:0] select_3974;
  assign select_3974 = x_s3_q[0] ? {select_3973[3], 1'b0, select_3973[2], 1'b0, select_3973[1], 1'b0, select_3973[0], 1'b0} : {1'b0, select_3973[3], 1'b0, select_3973[2], 1'b0, select_3973[1], 1'b0, select_3973[0]};
  // hls/stages/agreement.hpp:1142
  logic [13:0] select_3978;
  assign select_3978 = equal_3945 ? counts_skin_supervised_q : (equal_3946 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3980;
  assign select_3980 = equal_3944 ? counts_skin_textured_q : (equal_3941 ? counts_textured_q : select_3978);
  logic [13:0] of;
  assign of = equal_3943 ? counts_textured_q : select_3980;
  // hls/stages/agreement.hpp:1261
  logic [13:0] select_3982;
  assign select_3982 = ((limit & select_3974) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3963} + {1'b0, select_3982};
  // hls/stages/agreement.hpp:799
  logic select_3987;
  assign select_3987 = equal_586_s3_q ? (equal_3703 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1258
  logic and_3992;
  assign and_3992 = too_much_q & (~(equal_3946 & equal_3703));
  // hls/stages/agreement.hpp:1259
  logic select_3997;
  assign select_3997 = (over[14] & equal_3703) ? (and_3992 | ((equal_3946 | equal_3945) | (x_s3_q[6:3] == 4'hf))) : and_3992;
  // hls/stages/agreement.hpp:1142
  logic and_4002;
  assign and_4002 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1261
  logic select_4003;
  assign select_4003 = (equal_3943 & equal_3703) ? and_4002 : overlooks_q;
  // hls/stages/agreement.hpp:799
  logic [2:0] select_4005;
  assign select_4005 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4007;
  assign select_4007 = equal_586_s3_q ? box_textured_columns_values_0_q : (so_s3_q ? select_4005 : box_textured_columns_values_0_q);
  logic [2:0] select_4008;
  assign select_4008 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4010;
  assign select_4010 = equal_586_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_4008 : box_textured_columns_values_1_q);
  logic [2:0] select_4011;
  assign select_4011 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4013;
  assign select_4013 = equal_586_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4011 : box_textured_columns_values_2_q);
  logic [2:0] select_4014;
  assign select_4014 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4016;
  assign select_4016 = equal_586_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4014 : box_textured_columns_values_3_q);
  logic [2:0] select_4017;
  assign select_4017 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4019;
  assign select_4019 = equal_586_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4017 : box_textured_columns_values_4_q);
  logic [4:0] select_4021;
  assign select_4021 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4023;
  assign select_4023 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4025;
  assign select_4025 = equal_586_s3_q ? box_explained_columns_values_0_q : (so_s3_q ? select_4023 : box_explained_columns_values_0_q);
  logic [2:0] select_4026;
  assign select_4026 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4028;
  assign select_4028 = equal_586_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4026 : box_explained_columns_values_1_q);
  logic [2:0] select_4029;
  assign select_4029 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4031;
  assign select_4031 = equal_586_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4029 : box_explained_columns_values_2_q);
  logic [2:0] select_4032;
  assign select_4032 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4034;
  assign select_4034 = equal_586_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4032 : box_explained_columns_values_3_q);
  logic [2:0] select_4035;
  assign select_4035 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4037;
  assign select_4037 = equal_586_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4035 : box_explained_columns_values_4_q);
  logic [4:0] select_4039;
  assign select_4039 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4042;
  assign select_4042 = so_s3_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4044;
  assign select_4044 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4046;
  assign select_4046 = equal_586_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4044 : box_shown_columns_values_1_q);
  logic [2:0] select_4047;
  assign select_4047 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4049;
  assign select_4049 = equal_586_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4047 : box_shown_columns_values_2_q);
  logic [2:0] select_4050;
  assign select_4050 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4052;
  assign select_4052 = equal_586_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4050 : box_shown_columns_values_3_q);
  logic [2:0] select_4053;
  assign select_4053 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4055;
  assign select_4055 = equal_586_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4053 : box_shown_columns_values_4_q);
  logic [4:0] select_4057;
  assign select_4057 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4060;
  assign select_4060 = so_s3_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4062;
  assign select_4062 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4064;
  assign select_4064 = equal_586_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4062 : box_nearer_columns_values_1_q);
  logic [2:0] select_4065;
  assign select_4065 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4067;
  assign select_4067 = equal_586_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4065 : box_nearer_columns_values_2_q);
  logic [2:0] select_4068;
  assign select_4068 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4070;
  assign select_4070 = equal_586_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4068 : box_nearer_columns_values_3_q);
  logic [2:0] select_4071;
  assign select_4071 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4073;
  assign select_4073 = equal_586_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4071 : box_nearer_columns_values_4_q);
  logic [4:0] select_4075;
  assign select_4075 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1340
  logic [1:0] select_4165;
  assign select_4165 = and_4164_s3_q ? {and_2149, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:443
  logic select_4169;
  assign select_4169 = and_2075_s3_q ? (less_2076_s3_q ? (select_4165[0] & and_4166_s3_q) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:279
  logic select_4171;
  assign select_4171 = left_first_s3_q ? select_4169 : (and_1985_s3_q ? select_4169 : seen_q);
  logic select_4172;
  assign select_4172 = and_1985_s3_q ? select_4171 : seen_q;
  // hls/stages/agreement.hpp:443
  logic select_4175;
  assign select_4175 = and_2075_s3_q ? (less_2076_s3_q ? (select_4165[1] & and_4166_s3_q) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:279
  logic select_4177;
  assign select_4177 = left_first_s3_q ? select_4175 : (and_1985_s3_q ? select_4175 : nearer_q);
  logic select_4178;
  assign select_4178 = and_1985_s3_q ? select_4177 : nearer_q;
  // hls/stages/agreement.hpp:1269
  logic or_4185;
  assign or_4185 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_s3_q);
  // hls/stages/agreement.hpp:1271
  logic not_4193;
  assign not_4193 = ~(or_3915 | not_2374);
  // hls/stages/agreement.hpp:799
  logic and_4197;
  assign and_4197 = equal_586_s3_q & (equal_3934_s3_q & (not_4193 & (select_3923 | select_3997)));
  logic and_4200;
  assign and_4200 = equal_3934_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1169
  logic or_4204;
  assign or_4204 = select_2482 | (select_2494 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:799
  logic and_4211;
  assign and_4211 = equal_586_s3_q & (equal_3934_s3_q & (not_4193 & (select_2488 | select_2500)));
  // hls/stages/agreement.hpp:1169
  logic and_4216;
  assign and_4216 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3939[8:1] < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:1181
  logic [14:0] sum_4220;
  assign sum_4220 = {1'b0, counts_skin_textured_q} + {2'h0, counts_skin_textured_q[13:1]};
  // hls/stages/agreement.hpp:1166
  logic and_4222;
  assign and_4222 = (proven_s3_q & (~cfg_same_table_i)) & (sum_4220[14:1] < counts_nearer_q);
  // hls/stages/agreement.hpp:799
  logic and_4224;
  assign and_4224 = equal_3934_s3_q & ((not_2374 | and_4216) ? cfg_prove_i : and_4222);
  // hls/stages/agreement.hpp:1169
  logic select_4228;
  assign select_4228 = (not_2374 | (select_4003 & not_3826)) ? cfg_prove_i : patches_overlooked_q;
  logic and_4232;
  assign and_4232 = cfg_prove_i & (moments_out_of_step_q | moments_other_field_out_of_step_q);
  // hls/stages/agreement.hpp:799
  logic and_4238;
  assign and_4238 = equal_586_s3_q & (x_s3_q[6] & (not_2004_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1157
  logic [31:0] select_4246;
  assign select_4246 = equal_1645_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4244_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4247;
  assign select_4247 = equal_1643_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4246;
  logic [31:0] select_4248;
  assign select_4248 = equal_1641_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4247;
  logic [31:0] select_4249;
  assign select_4249 = equal_1639_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4248;
  logic [31:0] select_4250;
  assign select_4250 = equal_1637_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4249;
  logic [31:0] select_4251;
  assign select_4251 = equal_1635_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4250;
  logic [31:0] select_4252;
  assign select_4252 = equal_1633_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4251;
  logic [31:0] select_4253;
  assign select_4253 = equal_1631_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4252;
  // hls/stages/agreement.hpp:1155
  logic [9:0] select_4254;
  assign select_4254 = less_2691 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1159
  logic [31:0] select_4255;
  assign select_4255 = equal_1623_s3_q ? select_4253 : {2'h0, select_4254, select_2695, select_2692};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_559_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_761_s3_q, and_760, less_755_s3_q, and_754_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_748, and_724_s3_q, and_723_s3_q, and_698_s3_q, less_690_s3_q, less_689_s3_q, less_688_s3_q, less_687_s3_q, less_686_s3_q, less_685_s3_q, less_684_s3_q, less_683_s3_q, less_682_s3_q, less_681_s3_q, less_680_s3_q, less_679_s3_q, less_678_s3_q, less_677_s3_q, less_676_s3_q, less_675_s3_q, less_674_s3_q, less_673_s3_q, less_672_s3_q, less_671_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q};
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
  assign registration_sums_waddr = {sum_1629_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1688_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1687, sum_1683};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_1714_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_1787_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1763_s3_q};
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
  assign patches_right_0_waddr = {select_1823_s3_q, select_1820};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_1832);
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
  assign patches_right_1_waddr = {select_1823_s3_q, select_1848};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1851);
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
  assign patches_left_waddr = {select_1870, select_1869_s3_q, column_4};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1876);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1992;
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
  assign regions_waddr = {region_row_s3_q, or_2002_s3_q, or_1999_s3_q, or_1996_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2041_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2040, sum_2029, sum_2023};
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
  assign map_waddr = sum_2085_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2161_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2149, is_seen};
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
      patches_on_skin_limit_q <= 5'h0;
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
      hidden_for_q <= 9'h0;
      hidden_more_q <= 2'h0;
      hidden_ends_q <= 1'b0;
      product_q <= 14'h0;
      product_rest_q <= 1'b0;
      disagree_q <= 1'b0;
      too_much_q <= 1'b0;
      hides_q <= 1'b0;
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s3_en) begin
      census_left_misses_q <= select_2313;
      sharpness_before_last_mask_q <= select_2396;
      sharpness_sums_detail_0_q <= and_559_s3_q ? select_2410 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_559_s3_q ? select_2422 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_559_s3_q ? sum_2426 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_559_s3_q ? sum_2430 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= so_s3_q ? select_2448 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s3_q ? select_2458 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= so_s3_q ? select_2460 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s3_q ? select_2462 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= so_s3_q ? select_2464 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s3_q ? select_2466 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2471;
      sharpness_comparing_carry_1_q <= so_s3_q ? select_2474 : sharpness_comparing_carry_1_q;
      sharpness_comparing_less_detail_0_q <= select_2482;
      sharpness_comparing_less_detail_1_q <= select_2488;
      sharpness_comparing_less_contrast_0_q <= select_2494;
      sharpness_comparing_less_contrast_1_q <= select_2500;
      counts_supervised_q <= select_2647;
      counts_textured_q <= and_2638_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2650});
      counts_explained_q <= and_2638_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2655});
      counts_nearer_q <= and_2638_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2660});
      counts_unproven_q <= and_2638_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2688});
      counts_regions_bad_q <= select_2704;
      counts_skin_supervised_q <= select_2712;
      counts_skin_textured_q <= select_2719;
      counts_skin_unproven_q <= select_2727;
      counts_on_skin_q <= select_2747;
      registration_half_across_q <= select_2827;
      registration_half_measured_q <= select_2832;
      registration_half_votes_down_q <= and_2805_s3_q ? 7'h0 : sum_2838;
      registration_half_votes_up_q <= and_2805_s3_q ? 7'h0 : sum_2846;
      registration_half_half_votes_down_q <= and_2805_s3_q ? 7'h0 : sum_2853;
      registration_half_half_votes_up_q <= and_2805_s3_q ? 7'h0 : sum_2860;
      registration_down_q <= and_2893 ? sum_2912 : registration_down_q;
      registration_up_q <= and_2893 ? sum_2921 : registration_up_q;
      registration_enough_q <= select_2935;
      registration_votes_down_q <= and_2940 ? less_2941 : registration_votes_down_q;
      registration_votes_up_q <= and_2940 ? less_2943 : registration_votes_up_q;
      registration_other_enough_q <= and_2949 ? select_2935 : registration_other_enough_q;
      registration_other_down_q <= and_2949 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2949 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_586_s3_q & and_2956)) & or_2981;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1811 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1814 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1815 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3063;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1840 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1842 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1843 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3068;
      patches_valid_0_q <= select_3073;
      patches_valid_1_q <= select_3078;
      patches_right_next_0_q <= select_3081;
      patches_right_next_1_q <= select_3084;
      patches_left_next_0_q <= select_3087;
      patches_left_next_1_q <= select_3090;
      patches_sums_values_0_q <= select_3514;
      patches_sums_values_1_q <= equal_1788_s3_q ? patches_sums_values_1_q : select_3515;
      patches_sums_values_2_q <= equal_1788_s3_q ? patches_sums_values_2_q : select_3517;
      patches_sums_values_3_q <= equal_1788_s3_q ? patches_sums_values_3_q : select_3519;
      patches_sums_values_4_q <= equal_1788_s3_q ? patches_sums_values_4_q : select_3521;
      patches_sums_values_5_q <= equal_1788_s3_q ? patches_sums_values_5_q : select_3523;
      patches_sums_values_6_q <= equal_1788_s3_q ? patches_sums_values_6_q : select_3525;
      patches_sums_values_7_q <= equal_1788_s3_q ? patches_sums_values_7_q : select_3527;
      patches_sums_values_8_q <= equal_1788_s3_q ? patches_sums_values_8_q : select_3529;
      patches_sums_values_9_q <= equal_1788_s3_q ? patches_sums_values_9_q : select_3531;
      patches_sums_values_10_q <= equal_1788_s3_q ? patches_sums_values_10_q : select_3533;
      patches_sums_values_11_q <= equal_1788_s3_q ? patches_sums_values_11_q : select_3535;
      patches_sums_values_12_q <= equal_1788_s3_q ? patches_sums_values_12_q : select_3537;
      patches_sums_values_13_q <= equal_1788_s3_q ? patches_sums_values_13_q : select_3539;
      patches_sums_values_14_q <= equal_1788_s3_q ? patches_sums_values_14_q : select_3541;
      patches_sums_values_15_q <= equal_1788_s3_q ? patches_sums_values_15_q : select_3543;
      patches_sums_values_16_q <= equal_1788_s3_q ? patches_sums_values_16_q : select_3545;
      patches_best_differing_q <= select_1992[9:0];
      patches_best_column_q <= select_1992[14:10];
      patches_quarters_0_places_q <= sum_3632;
      patches_quarters_0_up_q <= sum_3667;
      patches_quarters_0_down_q <= sum_3672;
      patches_quarters_1_places_q <= sum_3676;
      patches_quarters_1_up_q <= sum_3679;
      patches_quarters_1_down_q <= sum_3682;
      patches_quarters_2_places_q <= sum_3686;
      patches_quarters_2_up_q <= sum_3689;
      patches_quarters_2_down_q <= sum_3692;
      patches_quarters_3_places_q <= sum_3696;
      patches_quarters_3_up_q <= sum_3699;
      patches_quarters_3_down_q <= sum_3702;
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      patches_word_places_q <= or_3730;
      patches_word_up_q <= ((select_3740 | select_3742) | select_3745) | select_3748;
      patches_word_down_q <= ((select_3751 | select_3753) | select_3756) | select_3759;
      patches_sum_places_q <= select_3769;
      patches_sum_up_q <= select_3772;
      patches_sum_down_q <= select_3775;
      patches_across_q <= select_3782;
      patches_places_q <= select_3793;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3797;
      patches_partly_q <= or_3800;
      patches_clear_limit_q <= sum_3801[8:2];
      patches_complete_q <= select_3803;
      patches_round_ends_q <= patches_complete_q & moments_ended_q;
      patches_found_q <= and_3786 ? select_3807 : patches_found_q;
      patches_doubted_q <= select_3814;
      patches_doubted_before_q <= select_3815;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3819;
      patches_on_skin_q <= sum_3824;
      patches_large_q <= not_3826 & and_3831;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3836;
      patches_spoiled_q <= or_3840;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3847;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3857;
      segment_textured_q <= select_2020 + {5'h0, and_2650};
      segment_explained_q <= select_2026 + {5'h0, and_2655};
      segment_nearer_q <= select_2037 + {5'h0, and_2660};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_586_s3_q ? select_3931 : good_q;
      good_known_q <= select_3936;
      hidden_for_q <= equal_586_s3_q ? select_3939 : hidden_for_q;
      hidden_more_q <= equal_586_s3_q ? {or_3957, not_3954} : hidden_more_q;
      hidden_ends_q <= select_3962;
      product_q <= equal_586_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3987;
      disagree_q <= equal_586_s3_q ? select_3923 : disagree_q;
      too_much_q <= equal_586_s3_q ? select_3997 : too_much_q;
      hides_q <= equal_586_s3_q ? select_3953 : hides_q;
      overlooks_q <= equal_586_s3_q ? select_4003 : overlooks_q;
      seen_q <= select_4172;
      nearer_q <= select_4178;
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
      averager_quarter_1_0_q <= select_2187;
      averager_quarter_1_1_q <= select_2189;
      averager_quarter_2_0_q <= select_2191;
      averager_quarter_2_1_q <= select_2193;
      averager_detail_0_q <= select_2205;
      averager_detail_1_q <= select_2213;
      census_changes_values_0_left_q <= and_559_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_559_s3_q ? sum_2297 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2299;
      census_changes_values_1_right_q <= select_2300;
      census_changes_values_2_left_q <= select_2301;
      census_changes_values_2_right_q <= select_2302;
      sharpness_last_mask_q <= and_559_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_559_s3_q ? select_2393[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_559_s3_q ? select_2393[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4007;
      box_textured_columns_values_1_q <= select_4010;
      box_textured_columns_values_2_q <= select_4013;
      box_textured_columns_values_3_q <= select_4016;
      box_textured_columns_values_4_q <= select_4019;
      box_textured_sum_sums_values_0_q <= equal_586_s3_q ? box_textured_sum_sums_values_0_q : select_4021;
      box_explained_columns_values_0_q <= select_4025;
      box_explained_columns_values_1_q <= select_4028;
      box_explained_columns_values_2_q <= select_4031;
      box_explained_columns_values_3_q <= select_4034;
      box_explained_columns_values_4_q <= select_4037;
      box_explained_sum_sums_values_0_q <= equal_586_s3_q ? box_explained_sum_sums_values_0_q : select_4039;
      box_shown_columns_values_0_q <= equal_586_s3_q ? box_shown_columns_values_0_q : select_4042;
      box_shown_columns_values_1_q <= select_4046;
      box_shown_columns_values_2_q <= select_4049;
      box_shown_columns_values_3_q <= select_4052;
      box_shown_columns_values_4_q <= select_4055;
      box_shown_sum_sums_values_0_q <= equal_586_s3_q ? box_shown_sum_sums_values_0_q : select_4057;
      box_nearer_columns_values_0_q <= equal_586_s3_q ? box_nearer_columns_values_0_q : select_4060;
      box_nearer_columns_values_1_q <= select_4064;
      box_nearer_columns_values_2_q <= select_4067;
      box_nearer_columns_values_3_q <= select_4070;
      box_nearer_columns_values_4_q <= select_4073;
      box_nearer_sum_sums_values_0_q <= equal_586_s3_q ? box_nearer_sum_sums_values_0_q : select_4075;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4116_s4_q;
  logic or_4179_s4_q;
  logic and_4180_s4_q;
  logic and_4188_s4_q;
  logic and_4191_s4_q;
  logic and_4197_s4_q;
  logic and_4201_s4_q;
  logic and_4207_s4_q;
  logic and_4211_s4_q;
  logic and_4225_s4_q;
  logic and_4230_s4_q;
  logic and_4234_s4_q;
  logic and_4238_s4_q;
  logic [5:0] select_4240_s4_q;
  logic [31:0] select_4257_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4116_s4_q <= and_4116_s3_q;
      or_4179_s4_q <= not_2374 | select_4172;
      and_4180_s4_q <= cfg_prove_i & select_4178;
      and_4188_s4_q <= equal_586_s3_q & (equal_3934_s3_q & (cfg_prove_i & or_4185));
      and_4191_s4_q <= equal_586_s3_q & (equal_3934_s3_q & (cfg_prove_i & or_3915));
      and_4197_s4_q <= and_4197;
      and_4201_s4_q <= equal_586_s3_q & and_4200;
      and_4207_s4_q <= equal_586_s3_q & (equal_3934_s3_q & (not_4193 & or_4204));
      and_4211_s4_q <= and_4211;
      and_4225_s4_q <= equal_586_s3_q & and_4224;
      and_4230_s4_q <= equal_586_s3_q & (equal_3934_s3_q & select_4228);
      and_4234_s4_q <= equal_586_s3_q & (equal_3934_s3_q & and_4232);
      and_4238_s4_q <= and_4238;
      select_4240_s4_q <= equal_586_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4257_s4_q <= equal_586_s3_q ? (x_s3_q[6] ? select_4255 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4179_s4_q;
  assign marks_nearer_o = and_4180_s4_q;
  assign verdict_valid_o = and_4116_s4_q;
  assign verdict_unproven_yet_o = and_4188_s4_q;
  assign verdict_untextured_o = and_4191_s4_q;
  assign verdict_disagree_o = and_4197_s4_q;
  assign verdict_moved_o = and_4201_s4_q;
  assign verdict_unsharp_left_o = and_4207_s4_q;
  assign verdict_unsharp_right_o = and_4211_s4_q;
  assign verdict_hidden_o = and_4225_s4_q;
  assign verdict_overlooked_o = and_4230_s4_q;
  assign verdict_out_of_step_o = and_4234_s4_q;
  assign frame_valid_o = and_4238_s4_q;
  assign frame_index_o = select_4240_s4_q;
  assign frame_word_o = select_4257_s4_q;
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
  assign unused_bits = ^{sum_4220[0], over[13:0], product_3829[4:0], sum_3801[1:0], sum_3761[1:0], product_3662[4:0], sum_2795[0], difference_2733[1:0], detail_4[1:0], detail_3[1:0], sum_2307[4:0], sum_1730[0], sum_1726[0], sum_746[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
