// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3131 bits, pipeline 844 bits, memories 73171 bits.
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
  logic not_2370;
  assign not_2370 = ~cfg_prove_i;
  logic [5:0] sum_2593;
  assign sum_2593 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic less_2598;
  assign less_2598 = 6'h8 < cfg_height_i[8:3];
  logic [6:0] difference_3631;
  assign difference_3631 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3823;
  assign not_3823 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3860;
  assign difference_3860 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic [5:0] sum_4132;
  assign sum_4132 = {2'h0, cfg_height_i[8:5]} + 6'h3f;
  logic [7:0] select_4133;
  assign select_4133 = (6'h4 < cfg_height_i[8:3]) ? {sum_4132, cfg_height_i[4:3]} : 8'h0;

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
  logic [2:0] select_517;
  assign select_517 = sample_pair_first_q ? 3'h0 : raster_at_x_q;
  // hls/stages/census.hpp:34
  logic row_starts;
  assign row_starts = sample_pair_first_q | raster_row_ended_q;
  // hls/stages/census.hpp:124
  logic [7:0] select_521;
  assign select_521 = select_517[0] ? averager_place_q : (row_starts ? 8'h0 : (averager_place_q + 8'h1));
  // hls/stages/census.hpp:122
  logic or_525;
  assign or_525 = row_starts | (averager_inside_q & (~(averager_place_q == 8'hbc)));
  // hls/stages/census.hpp:124
  logic select_526;
  assign select_526 = select_517[0] ? averager_inside_q : or_525;
  // hls/stages/census.hpp:42
  logic or_527;
  assign or_527 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:423
  logic and_529;
  assign and_529 = select_526 & (select_517[0] & or_527);
  // hls/stages/census.hpp:42
  logic [2:0] select_534;
  assign select_534 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  logic [5:0] select_550;
  assign select_550 = sample_pair_first_q ? 6'h0 : raster_at_column_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] last;
  assign last = sample_pair_whole_q ? select_550 : 6'h0;
  // hls/stages/census.hpp:53
  logic equal_552;
  assign equal_552 = select_517 == 3'h7;
  // hls/stages/census.hpp:58
  logic equal_553;
  assign equal_553 = select_534 == 3'h7;
  // hls/stages/census.hpp:134
  logic and_554;
  assign and_554 = equal_553 & and_529;
  // hls/stages/agreement.hpp:277
  logic and_556;
  assign and_556 = sample_pair_whole_q & (equal_552 & and_554);
  // hls/stages/agreement.hpp:197
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:633
  logic equal_587;
  assign equal_587 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:604
  logic or_588;
  assign or_588 = so | equal_587;
  // hls/stages/agreement.hpp:602
  logic [7:0] sum_589;
  assign sum_589 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:604
  logic [7:0] select_590;
  assign select_590 = run_shift_q[5] ? x_q : sum_589;
  logic less_591;
  assign less_591 = {2'h0, last_q} < select_590;
  // hls/stages/agreement.hpp:227
  logic not_592;
  assign not_592 = ~less_591;
  // hls/stages/agreement.hpp:624
  logic equal_601;
  assign equal_601 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:625
  logic equal_602;
  assign equal_602 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:150
  logic and_603;
  assign and_603 = equal_602 & not_592;
  logic select_605;
  assign select_605 = or_588 ? not_592 : (equal_601 ? not_592 : and_603);
  // hls/stages/agreement.hpp:808
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:806
  logic [6:0] sum_618;
  assign sum_618 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:150
  logic and_623;
  assign and_623 = equal_601 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_618} < select_590))));
  logic select_624;
  assign select_624 = or_588 ? not_592 : and_623;
  // hls/stages/agreement.hpp:831
  logic [5:0] right;
  assign right = sum_589[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:730
  logic not_659;
  assign not_659 = ~or_588;
  // hls/stages/agreement.hpp:150
  logic and_662;
  assign and_662 = not_659 & ((~equal_601) & and_603);
  // hls/stages/census.hpp:42
  logic [5:0] select_689;
  assign select_689 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_689 : 6'h0;
  // hls/stages/patches.hpp:396
  logic not_1686;
  assign not_1686 = ~patches_begins_q;
  // hls/stages/census.hpp:33
  logic not_1689;
  assign not_1689 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:366
  logic and_1690;
  assign and_1690 = patches_capturing_q & not_1689;
  // hls/stages/patches.hpp:368
  logic equal_1691;
  assign equal_1691 = {or_527, select_534} == 4'hc;
  // hls/stages/patches.hpp:315
  logic equal_1693;
  assign equal_1693 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1698;
  assign and_1698 = (not_1686 & (patches_work_q == 3'h0)) & (~(and_1690 | ((~equal_1691) | (~equal_1693))));
  // hls/stages/patches.hpp:537
  logic equal_1789;
  assign equal_1789 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:516
  logic not_1790;
  assign not_1790 = ~equal_1789;
  // hls/stages/patches.hpp:509
  logic equal_1791;
  assign equal_1791 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:462
  logic not_1792;
  assign not_1792 = ~equal_1791;
  // hls/stages/patches.hpp:503
  logic equal_1793;
  assign equal_1793 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:168
  logic equal_1794;
  assign equal_1794 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:537
  logic or_1795;
  assign or_1795 = equal_1793 | equal_1794;
  // hls/stages/patches.hpp:464
  logic not_1796;
  assign not_1796 = ~patches_second_q;
  // hls/stages/patches.hpp:377
  logic [4:0] select_1818;
  assign select_1818 = and_1698 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1819;
  assign select_1819 = row_starts ? select_1818 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1821;
  assign and_1821 = and_1690 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1825;
  assign select_1825 = row_starts ? (and_1698 | (and_1690 & (~and_1821))) : patches_capturing_q;
  // hls/stages/agreement.hpp:276
  logic and_1833;
  assign and_1833 = not_1790 & (not_1792 & (or_1795 & (patches_second_q & equal_1794)));
  // hls/stages/patches.hpp:168
  logic not_1849;
  assign not_1849 = ~equal_1794;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_1865;
  assign select_1865 = row_starts ? {select_1818[4], select_1818[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:462
  logic and_1875;
  assign and_1875 = not_1790 & (or_1795 & not_1792);
  // hls/stages/agreement.hpp:191
  logic and_1981;
  assign and_1981 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:277
  logic [2:0] select_2159;
  assign select_2159 = sample_pair_whole_q ? (sample_last_q ? 3'h0 : (select_517 + 3'h1)) : raster_at_x_q;
  logic [2:0] select_2162;
  assign select_2162 = sample_pair_whole_q ? (sample_last_q ? (select_534 + 3'h1) : select_534) : raster_at_y_q;
  logic [5:0] select_2165;
  assign select_2165 = sample_pair_whole_q ? (sample_last_q ? 6'h0 : (select_550 + {5'h0, equal_552})) : raster_at_column_q;
  logic [5:0] select_2168;
  assign select_2168 = sample_pair_whole_q ? (sample_last_q ? (select_689 + {5'h0, equal_553}) : select_689) : raster_at_row_q;
  logic select_2172;
  assign select_2172 = sample_pair_whole_q ? (sample_last_q ? (or_527 & (~raster_final_row_q)) : or_527) : raster_at_live_q;
  // hls/stages/census.hpp:52
  logic [8:0] select_2174;
  assign select_2174 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:277
  logic select_2178;
  assign select_2178 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:464
  logic [6:0] sum_2498;
  assign sum_2498 = {1'b0, last} + 7'h1;
  logic equal_2499;
  assign equal_2499 = {sum_2498[6], cfg_width_i[8:3]} == {1'b0, sum_2498[5:0]};
  // hls/stages/agreement.hpp:469
  logic and_2500;
  assign and_2500 = and_556 & equal_2499;
  // hls/stages/agreement.hpp:533
  logic select_2503;
  assign select_2503 = (and_2500 | (~ends_cell_q)) ? and_2500 : ends_q;
  // hls/stages/agreement.hpp:539
  logic [2:0] now;
  assign now = select_2503 ? (and_2500 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:544
  logic [5:0] select_2507;
  assign select_2507 = select_2503 ? (and_2500 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2510;
  assign select_2510 = select_2503 ? (following_last_shift_q & (~and_2500)) : run_last_shift_q;
  // hls/stages/agreement.hpp:617
  logic and_2513;
  assign and_2513 = run_last_shift_q & equal_601;
  // hls/stages/agreement.hpp:626
  logic select_2515;
  assign select_2515 = equal_601 ? (~run_last_shift_q) : equal_602;
  // hls/stages/agreement.hpp:630
  logic equal_2516;
  assign equal_2516 = run_phase_q == 3'h1;
  logic not_2519;
  assign not_2519 = ~select_2515;
  // hls/stages/agreement.hpp:633
  logic equal_2521;
  assign equal_2521 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:617
  logic and_2522;
  assign and_2522 = final_row_q & so;
  // hls/stages/agreement.hpp:630
  logic [1:0] select_2523;
  assign select_2523 = equal_2521 ? 2'h1 : {2{and_2522}};
  logic [2:0] select_2525;
  assign select_2525 = (and_2513 | (select_2515 | equal_2516)) ? (equal_2516 ? 3'h2 : {not_2519, {2{select_2515}}}) : (equal_587 ? 3'h6 : {select_2523[0], select_2523});
  // hls/stages/agreement.hpp:617
  logic and_2528;
  assign and_2528 = select_2515 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:640
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2531;
  assign select_2531 = (plan_shift_q[5] & select_2515) ? value : 7'h0;
  logic [1:0] or_2532;
  assign or_2532 = {2{so}} | select_2531[5:4];
  // hls/stages/agreement.hpp:643
  logic [7:0] select_2533;
  assign select_2533 = select_2515 ? plan_columns_q : 8'h0;
  logic [6:0] or_2536;
  assign or_2536 = select_2533[6:0] | ((equal_2516 | equal_2521) ? whole_q : 7'h0);
  logic [1:0] or_2537;
  assign or_2537 = {2{and_2513}} | or_2536[3:2];
  // hls/stages/agreement.hpp:644
  logic [6:0] or_2539;
  assign or_2539 = {or_2536[6:4], or_2537, or_2536[1:0]} | (equal_587 ? drawn_q : 7'h0);
  logic [4:0] or_2540;
  assign or_2540 = {5{so}} | {or_2539[6], or_2539[3:0]};
  // hls/stages/agreement.hpp:650
  logic not_2544;
  assign not_2544 = ~run_shift_q[5];
  logic [6:0] difference_2546;
  assign difference_2546 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2547;
  assign select_2547 = equal_601 ? ({{7{not_2544}}, 1'b1} + run_span_q) : {difference_2546[6], difference_2546};
  // hls/stages/agreement.hpp:533
  logic [6:0] select_2551;
  assign select_2551 = and_2500 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:536
  logic [7:0] select_2553;
  assign select_2553 = select_2503 ? {select_2551[6], select_2551} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2556;
  assign select_2556 = select_2503 ? (and_2500 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:530
  logic [5:0] select_2564;
  assign select_2564 = and_556 ? (equal_2499 ? ((5'he < last[5:1]) ? 6'h1d : last) : least_q) : least_q;
  // hls/stages/agreement.hpp:481
  logic [4:0] sum_2565;
  assign sum_2565 = {1'b0, last[5:2]} + 5'h3;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_2567;
  assign select_2567 = and_556 ? (equal_2499 ? {sum_2565, last[1:0]} : whole_q) : whole_q;
  // hls/stages/agreement.hpp:482
  logic [4:0] sum_2568;
  assign sum_2568 = {1'b0, last[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_2570;
  assign select_2570 = and_556 ? (equal_2499 ? {sum_2568, last[1:0]} : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:541
  logic select_2584;
  assign select_2584 = (ends_cell_q | select_2503) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_601 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:536
  logic and_2588;
  assign and_2588 = (~select_2503) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:484
  logic [6:0] sum_2589;
  assign sum_2589 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:465
  logic select_2591;
  assign select_2591 = equal_2499 ? ({sum_2589[6], cfg_height_i[8:3]} == {1'b0, sum_2589[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:321
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2983;
  assign select_2983 = row_starts ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2984;
  assign select_2984 = sample_pair_whole_q ? select_2983 : patches_phase_q;
  // hls/stages/patches.hpp:377
  logic and_2985;
  assign and_2985 = not_1689 & equal_1691;
  logic [8:0] select_2986;
  assign select_2986 = and_2985 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2987;
  assign select_2987 = and_2985 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2988;
  assign select_2988 = sample_pair_first_q ? select_2986 : select_2987;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_2990;
  assign select_2990 = sample_pair_whole_q ? (row_starts ? select_2988[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2992;
  assign select_2992 = sample_pair_whole_q ? (row_starts ? select_2988[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2995;
  assign select_2995 = sample_pair_whole_q ? (equal_1693 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2997;
  assign select_2997 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1693}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:334
  logic equal_2998;
  assign equal_2998 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:335
  logic not_2999;
  assign not_2999 = ~equal_2998;
  // hls/stages/agreement.hpp:277
  logic [3:0] select_3001;
  assign select_3001 = sample_pair_whole_q ? (phase + {not_2999, 1'b1, not_2999, equal_2998}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:478
  logic equal_3003;
  assign equal_3003 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3007;
  assign select_3007 = equal_3003 ? ((select_2984 == 4'h6) ? 4'h0 : (select_2984 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3008;
  assign equal_3008 = select_3007 == 4'h0;
  // hls/stages/agreement.hpp:465
  logic [3:0] select_3011;
  assign select_3011 = equal_2499 ? (equal_3008 ? 4'h6 : (select_3007 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3013;
  assign select_3013 = equal_3003 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:465
  logic [4:0] select_3015;
  assign select_3015 = equal_2499 ? (select_3013 + {4'h0, equal_3008}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:530
  logic select_3020;
  assign select_3020 = and_556 ? (equal_2499 ? ((6'h2 < row) & equal_3008) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3022;
  assign select_3022 = and_556 ? (equal_2499 ? select_3013 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:375
  logic [5:0] sum_3045;
  assign sum_3045 = {1'b0, select_689[5:1]} + 6'h1;
  logic less_3046;
  assign less_3046 = {sum_3045, select_689[0], select_534, 1'b0} < {2'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3049;
  assign select_3049 = row_starts ? (and_1698 ? (~less_3046) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:397
  logic or_3088;
  assign or_3088 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:399
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:191
  logic select_3093;
  assign select_3093 = (patches_second_q | patches_begins_q) ? not_1686 : (patches_ends_q & equal_1789);
  logic and_3094;
  assign and_3094 = equal_1789 & not_1796;
  // hls/stages/patches.hpp:403
  logic and_3095;
  assign and_3095 = not_1849 & and_3094;
  logic [1:0] select_3097;
  assign select_3097 = equal_1791 ? 2'h0 : (equal_1793 ? 2'h3 : {equal_1794, and_3095});
  // hls/stages/patches.hpp:283
  logic equal_3099;
  assign equal_3099 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:281
  logic not_3100;
  assign not_3100 = ~equal_3099;
  // hls/stages/patches.hpp:283
  logic equal_3101;
  assign equal_3101 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:279
  logic not_3102;
  assign not_3102 = ~equal_3101;
  // hls/stages/patches.hpp:287
  logic not_3104;
  assign not_3104 = ~(patches_following_q == 3'h2);
  logic and_3107;
  assign and_3107 = (~(patches_following_q == 3'h1)) & not_3104;
  // hls/stages/patches.hpp:401
  logic [1:0] select_3108;
  assign select_3108 = equal_3101 ? 2'h2 : {and_3107, not_3104};
  logic [3:0] select_3109;
  assign select_3109 = equal_3099 ? 4'h2 : {select_3108, {2{not_3102}}};
  // hls/stages/patches.hpp:409
  logic not_3112;
  assign not_3112 = ~or_3088;
  // hls/stages/patches.hpp:398
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:410
  logic [11:0] select_3117;
  assign select_3117 = or_3088 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:191
  logic [4:0] select_3119;
  assign select_3119 = or_3088 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 47 x 33, DISTANCE 12, hls/stages/agreement.hpp:1389; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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
  assign fresh_re = s0_en & and_662;
`endif
  logic [32:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 85, DISTANCE 12, hls/stages/agreement.hpp:1390; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign left_re = s0_en & select_605;
`endif
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 99, DISTANCE 12, hls/stages/agreement.hpp:1391; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [98:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = or_588 ? x_q[5:0] : (equal_601 ? sum_589[5:0] : x_q[5:0]);
`ifndef SYNTHESIS
  logic right_codes_re;
  assign right_codes_re = s0_en & select_605;
`endif
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 62, DISTANCE 12, hls/stages/agreement.hpp:1392; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [61:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 62'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_588 ? x_q[5:0] : x[5:0];
`ifndef SYNTHESIS
  logic best_left_re;
  assign best_left_re = s0_en & select_624;
`endif
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:789; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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
  assign patches_right_0_re = s0_en & (not_1790 & (not_1792 & (or_1795 & (equal_1794 & not_1796))));
`endif
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:789; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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
  assign patches_right_1_re = s0_en & and_1833;
`endif
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:790; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
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
  assign patches_left_re = s0_en & (not_1790 & (not_1792 & (not_1849 & or_1795)));
`endif
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:801; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
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
  assign patches_columns_above_re = s0_en & and_1875;
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
      left_first_q <= and_1981 ? left_first_q : marks_first_i;
      right_q <= (~and_1981) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1981;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= select_2159;
      raster_at_y_q <= select_2162;
      raster_at_column_q <= select_2165;
      raster_at_row_q <= select_2168;
      raster_at_live_q <= select_2172;
      raster_rows_left_q <= sample_pair_whole_q ? select_2174 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2178;
      averager_place_q <= sample_pair_whole_q ? select_521 : averager_place_q;
      averager_inside_q <= sample_pair_whole_q ? select_526 : averager_inside_q;
      run_phase_q <= now;
      run_shift_q <= select_2507;
      run_last_shift_q <= select_2510;
      run_span_q <= select_2503 ? (and_2500 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2525;
      following_shift_q <= select_2515 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2528;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2531[6], or_2532, select_2531[3:0]};
      following_columns_q <= {select_2533[7], or_2540[4], or_2539[5:4], or_2540[3:0]};
      plan_shift_q <= equal_601 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2547;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2553;
      columns_left_q <= select_2556;
      last_q <= and_556 ? (equal_2499 ? last : last_q) : last_q;
      least_q <= select_2564;
      whole_q <= select_2567;
      drawn_q <= select_2570;
      age_q <= select_2503 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2503 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2584;
      ends_q <= and_2588;
      final_row_q <= and_556 ? select_2591 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2984;
      patches_band_rows_rows_to_next_q <= select_2990;
      patches_band_rows_number_q <= select_2992;
      patches_next_band_rows_to_next_q <= select_2995;
      patches_next_band_number_q <= select_2997;
      patches_first_band_rows_to_next_q <= select_3001;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2998 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_556 ? select_3011 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_556 ? select_3015 : patches_choosing_number_q;
      patches_chooses_q <= select_3020;
      patches_choosing_band_q <= select_3022;
      patches_capturing_q <= sample_pair_whole_q ? select_1825 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3049 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1819 : patches_row_q;
      patches_work_q <= or_3088 ? following : patches_work_q;
      patches_second_q <= select_3093;
      patches_following_q <= equal_1789 ? {2'h0, and_3094} : {equal_1791, select_3097};
      patches_following_beats_q <= {select_3109, not_3100};
      patches_begins_q <= sample_pair_whole_q & (row_starts & and_1821);
      patches_ends_q <= not_3112 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3117;
      patches_code_row_q <= select_3119;
      patches_column_q <= or_3088 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3112 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_517_s1_q;
  logic row_starts_s1_q;
  logic [7:0] select_521_s1_q;
  logic and_529_s1_q;
  logic equal_535_s1_q;
  logic [5:0] select_550_s1_q;
  logic [5:0] last_s1_2_q;
  logic and_554_s1_q;
  logic and_556_s1_q;
  logic equal_583_s1_q;
  logic so_s1_q;
  logic equal_587_s1_q;
  logic or_588_s1_q;
  logic less_591_s1_q;
  logic not_592_s1_q;
  logic equal_601_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_624_s1_q;
  logic [5:0] right_s1_q;
  logic and_662_s1_q;
  logic [5:0] row_s1_q;
  logic and_1574_s1_q;
  logic equal_1575_s1_q;
  logic and_1698_s1_q;
  logic equal_1789_s1_q;
  logic not_1790_s1_q;
  logic equal_1791_s1_q;
  logic not_1792_s1_q;
  logic equal_1793_s1_q;
  logic equal_1794_s1_q;
  logic or_1795_s1_q;
  logic not_1796_s1_q;
  logic [4:0] select_1819_s1_q;
  logic select_1825_s1_q;
  logic [3:0] select_1865_s1_q;
  logic and_1875_s1_q;
  logic equal_2499_s1_q;
  logic and_2500_s1_q;
  logic or_3088_s1_q;
  logic not_3112_s1_q;
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
      select_517_s1_q <= select_517;
      row_starts_s1_q <= row_starts;
      select_521_s1_q <= select_521;
      and_529_s1_q <= and_529;
      equal_535_s1_q <= select_534 == 3'h0;
      select_550_s1_q <= select_550;
      last_s1_2_q <= last;
      and_554_s1_q <= and_554;
      and_556_s1_q <= and_556;
      equal_583_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_587_s1_q <= equal_587;
      or_588_s1_q <= or_588;
      less_591_s1_q <= less_591;
      not_592_s1_q <= not_592;
      equal_601_s1_q <= equal_601;
      x_s1_2_q <= x[6:0];
      select_624_s1_q <= select_624;
      right_s1_q <= right;
      and_662_s1_q <= and_662;
      row_s1_q <= row;
      and_1574_s1_q <= not_659 & and_623;
      equal_1575_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      and_1698_s1_q <= and_1698;
      equal_1789_s1_q <= equal_1789;
      not_1790_s1_q <= not_1790;
      equal_1791_s1_q <= equal_1791;
      not_1792_s1_q <= not_1792;
      equal_1793_s1_q <= equal_1793;
      equal_1794_s1_q <= equal_1794;
      or_1795_s1_q <= or_1795;
      not_1796_s1_q <= not_1796;
      select_1819_s1_q <= select_1819;
      select_1825_s1_q <= select_1825;
      select_1865_s1_q <= select_1865;
      and_1875_s1_q <= and_1875;
      equal_2499_s1_q <= equal_2499;
      and_2500_s1_q <= and_2500;
      or_3088_s1_q <= or_3088;
      not_3112_s1_q <= not_3112;
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
  logic and_530;
  assign and_530 = sample_pair_whole_s1_q & and_529_s1_q;
  // hls/stages/agreement.hpp:678
  logic equal_575;
  assign equal_575 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_576;
  assign equal_576 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:260
  logic first;
  assign first = equal_575 & equal_576;
  // hls/stages/moments.hpp:68
  logic [11:0] select_579;
  assign select_579 = moments_starts_q ? 12'h1 : (moments_place_q + {11'h0, moments_taken_q});
  // hls/stages/moments.hpp:74
  logic [11:0] place;
  assign place = first ? 12'h0 : select_579;
  // hls/stages/moments.hpp:149
  logic [11:0] address;
  assign address = moments_other_field_second_q ? (place + 12'h66d) : place;
  // hls/stages/agreement.hpp:1022
  logic not_584;
  assign not_584 = ~equal_583_s1_q;
  // hls/stages/agreement.hpp:202
  logic not_586;
  assign not_586 = ~so_s1_q;
  // hls/stages/agreement.hpp:227
  logic inside_v;
  assign inside_v = or_588_s1_q & not_592_s1_q;
  // hls/stages/moments.hpp:149
  logic not_595;
  assign not_595 = ~(12'h66c < place);
  // hls/stages/agreement.hpp:798
  logic and_599;
  assign and_599 = not_584 & (not_586 & (equal_587_s1_q & (inside_v & not_595)));
  // hls/stages/agreement.hpp:985
  logic and_614;
  assign and_614 = (or_588_s1_q & (left_rdata_q[67] & not_592_s1_q)) & (late_q | (~(row_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:976
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:977
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:978
  logic [5:0] select_633;
  assign select_633 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:1014
  logic less_646;
  assign less_646 = 6'h2 < row_q;
  // hls/stages/agreement.hpp:1016
  logic and_656;
  assign and_656 = (or_588_s1_q & (right_codes_rdata_q[58] & not_592_s1_q)) & less_646;
  // hls/stages/agreement.hpp:679
  logic or_760;
  assign or_760 = late_q | (~equal_575);
  // hls/stages/agreement.hpp:681
  logic and_761;
  assign and_761 = left_rdata_q[12] & or_760;
  logic and_762;
  assign and_762 = left_rdata_q[30] & or_760;
  logic and_763;
  assign and_763 = left_rdata_q[48] & or_760;
  logic and_764;
  assign and_764 = left_rdata_q[66] & or_760;
  // hls/stages/agreement.hpp:682
  logic and_765;
  assign and_765 = right_codes_rdata_q[12] & or_760;
  logic and_766;
  assign and_766 = right_codes_rdata_q[27] & or_760;
  logic and_767;
  assign and_767 = right_codes_rdata_q[42] & or_760;
  logic and_768;
  assign and_768 = right_codes_rdata_q[57] & or_760;
  logic and_769;
  assign and_769 = right_codes_rdata_q[72] & or_760;
  logic and_770;
  assign and_770 = right_codes_rdata_q[85] & or_760;
  // hls/stages/agreement.hpp:222
  logic and_775;
  assign and_775 = left_rdata_q[48] & not_592_s1_q;
  logic and_776;
  assign and_776 = right_codes_rdata_q[42] & not_592_s1_q;
  logic [11:0] select_777;
  assign select_777 = less_591_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_778;
  assign select_778 = less_591_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_782;
  assign select_782 = and_775 ? (and_776 ? (~(select_777 ^ select_778)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_788;
  assign parity_788 = ^select_782[5:3];
  logic parity_791;
  assign parity_791 = ^select_782[8:6];
  logic parity_794;
  assign parity_794 = ^select_782[11:3];
  // hls/stages/agreement.hpp:222
  logic and_798;
  assign and_798 = left_rdata_q[66] & not_592_s1_q;
  logic and_799;
  assign and_799 = right_codes_rdata_q[57] & not_592_s1_q;
  logic [11:0] select_800;
  assign select_800 = less_591_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_801;
  assign select_801 = less_591_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_805;
  assign select_805 = and_798 ? (and_799 ? (~(select_800 ^ select_801)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_808;
  assign parity_808 = ^select_805[8:6];
  logic parity_811;
  assign parity_811 = ^select_805[11:9];
  // hls/stages/agreement.hpp:222
  logic and_815;
  assign and_815 = left_rdata_q[84] & not_592_s1_q;
  logic and_816;
  assign and_816 = right_codes_rdata_q[72] & not_592_s1_q;
  logic [11:0] select_817;
  assign select_817 = less_591_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_818;
  assign select_818 = less_591_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_822;
  assign select_822 = and_815 ? (and_816 ? (~(select_817 ^ select_818)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_828;
  assign parity_828 = ^select_822[2:0];
  logic parity_831;
  assign parity_831 = ^select_822[5:3];
  logic parity_834;
  assign parity_834 = ^select_822[8:0];
  logic parity_840;
  assign parity_840 = ^select_822[11:9];
  logic parity_843;
  assign parity_843 = ^select_805[2:0];
  logic parity_846;
  assign parity_846 = ^{select_822[11:9], select_805[5:0]};
  logic parity_849;
  assign parity_849 = ^{select_822, select_805, select_782[2:0]};
  logic xor_850;
  assign xor_850 = parity_794 ^ parity_849;
  // hls/stages/count_bits.hpp:23
  logic or_854;
  assign or_854 = (select_782[1:0] == 2'h3) | (select_782[2] & (select_782[0] | select_782[1]));
  // hls/stages/count_bits.hpp:25
  logic or_858;
  assign or_858 = (select_805[7:6] == 2'h3) | (select_805[8] & (select_805[6] | select_805[7]));
  logic or_862;
  assign or_862 = (select_805[10:9] == 2'h3) | (select_805[11] & (select_805[9] | select_805[10]));
  // hls/stages/count_bits.hpp:23
  logic or_870;
  assign or_870 = (select_822[7:6] == 2'h3) | (select_822[8] & (~(select_822[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_874;
  assign or_874 = (select_822[1:0] == 2'h3) | (select_822[2] & (select_822[0] | select_822[1]));
  logic or_878;
  assign or_878 = (select_822[4:3] == 2'h3) | (select_822[5] & (select_822[3] | select_822[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_881;
  assign parity_881 = ^{or_878, or_874, or_870};
  // hls/stages/count_bits.hpp:23
  logic or_885;
  assign or_885 = (select_805[4:3] == 2'h3) | (select_805[5] & (select_805[3] | select_805[4]));
  // hls/stages/count_bits.hpp:25
  logic or_889;
  assign or_889 = (select_822[10:9] == 2'h3) | (select_822[11] & (select_822[9] | select_822[10]));
  logic or_893;
  assign or_893 = (select_805[1:0] == 2'h3) | (select_805[2] & (select_805[0] | select_805[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_896;
  assign parity_896 = ^{or_893, or_889, or_885};
  logic parity_899;
  assign parity_899 = ^{or_893, or_889, or_885, or_878, or_874, or_870, or_862, or_858, or_854};
  // hls/stages/count_bits.hpp:25
  logic and_900;
  assign and_900 = parity_794 & parity_849;
  logic or_904;
  assign or_904 = (parity_788 & parity_791) | ((^select_782[11:9]) & (parity_788 | parity_791));
  logic and_907;
  assign and_907 = (^{select_805[11:6], select_782[2:0]}) & (parity_834 | parity_846);
  logic or_908;
  assign or_908 = (parity_834 & parity_846) | and_907;
  // hls/stages/count_bits.hpp:23
  logic or_915;
  assign or_915 = (select_782[10:9] == 2'h3) | (select_782[11] & (select_782[9] | select_782[10]));
  // hls/stages/count_bits.hpp:25
  logic or_919;
  assign or_919 = (select_782[4:3] == 2'h3) | (select_782[5] & (select_782[3] | select_782[4]));
  logic or_923;
  assign or_923 = (select_782[7:6] == 2'h3) | (select_782[8] & (select_782[6] | select_782[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_926;
  assign parity_926 = ^{or_923, or_919, or_915};
  // hls/stages/count_bits.hpp:25
  logic or_930;
  assign or_930 = (parity_808 & parity_811) | ((^select_782[2:0]) & (parity_808 | parity_811));
  logic or_934;
  assign or_934 = (parity_828 & parity_831) | ((^select_822[8:6]) & (parity_828 | parity_831));
  logic or_938;
  assign or_938 = (parity_840 & parity_843) | ((^select_805[5:3]) & (parity_840 | parity_843));
  // hls/stages/count_bits.hpp:24
  logic parity_941;
  assign parity_941 = ^{or_938, or_934, or_930};
  logic parity_944;
  assign parity_944 = ^{or_938, or_934, or_930, or_923, or_919, or_915, or_908, or_904, and_900};
  logic xor_945;
  assign xor_945 = parity_899 ^ parity_944;
  // hls/stages/count_bits.hpp:25
  logic and_946;
  assign and_946 = parity_899 & parity_944;
  logic or_950;
  assign or_950 = (parity_881 & parity_896) | ((^{or_862, or_858, or_854}) & (parity_881 | parity_896));
  logic or_954;
  assign or_954 = (parity_926 & parity_941) | ((^{or_908, or_904, and_900}) & (parity_926 | parity_941));
  logic or_961;
  assign or_961 = (or_858 & or_862) | (or_854 & (or_858 | or_862));
  logic or_965;
  assign or_965 = (or_874 & or_878) | (or_870 & (or_874 | or_878));
  logic or_969;
  assign or_969 = (or_889 & or_893) | (or_885 & (or_889 | or_893));
  // hls/stages/count_bits.hpp:24
  logic parity_972;
  assign parity_972 = ^{or_969, or_965, or_961};
  // hls/stages/count_bits.hpp:25
  logic or_976;
  assign or_976 = (or_904 & or_908) | (and_900 & (or_904 | or_908));
  logic or_980;
  assign or_980 = (or_919 & or_923) | (or_915 & (or_919 | or_923));
  logic or_984;
  assign or_984 = (or_934 & or_938) | (or_930 & (or_934 | or_938));
  // hls/stages/count_bits.hpp:24
  logic parity_987;
  assign parity_987 = ^{or_984, or_980, or_976};
  logic parity_990;
  assign parity_990 = ^{or_984, or_980, or_976, or_969, or_965, or_961, or_954, or_950, and_946};
  // hls/stages/count_bits.hpp:25
  logic or_994;
  assign or_994 = (parity_972 & parity_987) | ((^{or_954, or_950, and_946}) & (parity_972 | parity_987));
  logic or_998;
  assign or_998 = (or_950 & or_954) | (and_946 & (or_950 | or_954));
  logic or_1002;
  assign or_1002 = (or_965 & or_969) | (or_961 & (or_965 | or_969));
  logic or_1006;
  assign or_1006 = (or_980 & or_984) | (or_976 & (or_980 | or_984));
  // hls/stages/count_bits.hpp:24
  logic parity_1011;
  assign parity_1011 = ^{or_1006, or_1002, or_998, or_994};
  // hls/stages/count_bits.hpp:25
  logic or_1015;
  assign or_1015 = (or_1002 & or_1006) | (or_998 & (or_1002 | or_1006));
  logic and_1016;
  assign and_1016 = or_994 & (^{or_1006, or_1002, or_998});
  // hls/stages/count_bits.hpp:24
  logic xor_1017;
  assign xor_1017 = or_1015 ^ and_1016;
  // hls/stages/count_bits.hpp:27
  logic and_1018;
  assign and_1018 = or_1015 & and_1016;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1019;
  assign select_1019 = equal_601_s1_q ? {and_1018, xor_1017, parity_1011, parity_990, xor_945, xor_850} : 6'h0;
  logic [5:0] column;
  assign column = or_588_s1_q ? 6'h0 : select_1019;
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1030;
  assign select_1030 = (slot_s1_q[0] ? and_816 : and_799) ? (~(select_777 ^ (slot_s1_q[0] ? select_818 : select_801))) : 12'h0;
  logic [11:0] select_1031;
  assign select_1031 = and_775 ? select_1030 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1037;
  assign parity_1037 = ^select_1031[5:3];
  logic parity_1040;
  assign parity_1040 = ^select_1031[8:6];
  logic parity_1043;
  assign parity_1043 = ^select_1031[11:3];
  // hls/stages/agreement.hpp:222
  logic and_1047;
  assign and_1047 = right_codes_rdata_q[85] & not_592_s1_q;
  logic [11:0] select_1049;
  assign select_1049 = less_591_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1053;
  assign select_1053 = (slot_s1_q[0] ? and_1047 : and_816) ? (~(select_800 ^ (slot_s1_q[0] ? select_1049 : select_818))) : 12'h0;
  logic [11:0] select_1054;
  assign select_1054 = and_798 ? select_1053 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1057;
  assign parity_1057 = ^select_1054[8:6];
  logic parity_1060;
  assign parity_1060 = ^select_1054[11:9];
  // hls/stages/agreement.hpp:744
  logic select_1065;
  assign select_1065 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_592_s1_q) : and_1047;
  logic [11:0] select_1067;
  assign select_1067 = slot_s1_q[0] ? (less_591_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1049;
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1071;
  assign select_1071 = and_815 ? (select_1065 ? (~(select_817 ^ select_1067)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1077;
  assign parity_1077 = ^select_1071[2:0];
  logic parity_1080;
  assign parity_1080 = ^select_1071[5:3];
  logic parity_1083;
  assign parity_1083 = ^select_1071[8:0];
  logic parity_1089;
  assign parity_1089 = ^select_1071[11:9];
  logic parity_1092;
  assign parity_1092 = ^select_1054[2:0];
  logic parity_1095;
  assign parity_1095 = ^{select_1071[11:9], select_1054[5:0]};
  logic parity_1098;
  assign parity_1098 = ^{select_1071, select_1054, select_1031[2:0]};
  logic xor_1099;
  assign xor_1099 = parity_1043 ^ parity_1098;
  // hls/stages/count_bits.hpp:23
  logic or_1103;
  assign or_1103 = (select_1031[1:0] == 2'h3) | (select_1031[2] & (select_1031[0] | select_1031[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1107;
  assign or_1107 = (select_1054[7:6] == 2'h3) | (select_1054[8] & (select_1054[6] | select_1054[7]));
  logic or_1111;
  assign or_1111 = (select_1054[10:9] == 2'h3) | (select_1054[11] & (select_1054[9] | select_1054[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1119;
  assign or_1119 = (select_1071[7:6] == 2'h3) | (select_1071[8] & (~(select_1071[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1123;
  assign or_1123 = (select_1071[1:0] == 2'h3) | (select_1071[2] & (select_1071[0] | select_1071[1]));
  logic or_1127;
  assign or_1127 = (select_1071[4:3] == 2'h3) | (select_1071[5] & (select_1071[3] | select_1071[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1130;
  assign parity_1130 = ^{or_1127, or_1123, or_1119};
  // hls/stages/count_bits.hpp:23
  logic or_1134;
  assign or_1134 = (select_1054[4:3] == 2'h3) | (select_1054[5] & (select_1054[3] | select_1054[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1138;
  assign or_1138 = (select_1071[10:9] == 2'h3) | (select_1071[11] & (select_1071[9] | select_1071[10]));
  logic or_1142;
  assign or_1142 = (select_1054[1:0] == 2'h3) | (select_1054[2] & (select_1054[0] | select_1054[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1145;
  assign parity_1145 = ^{or_1142, or_1138, or_1134};
  logic parity_1148;
  assign parity_1148 = ^{or_1142, or_1138, or_1134, or_1127, or_1123, or_1119, or_1111, or_1107, or_1103};
  // hls/stages/count_bits.hpp:25
  logic and_1149;
  assign and_1149 = parity_1043 & parity_1098;
  logic or_1153;
  assign or_1153 = (parity_1037 & parity_1040) | ((^select_1031[11:9]) & (parity_1037 | parity_1040));
  logic and_1156;
  assign and_1156 = (^{select_1054[11:6], select_1031[2:0]}) & (parity_1083 | parity_1095);
  logic or_1157;
  assign or_1157 = (parity_1083 & parity_1095) | and_1156;
  // hls/stages/count_bits.hpp:23
  logic or_1164;
  assign or_1164 = (select_1031[10:9] == 2'h3) | (select_1031[11] & (select_1031[9] | select_1031[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1168;
  assign or_1168 = (select_1031[4:3] == 2'h3) | (select_1031[5] & (select_1031[3] | select_1031[4]));
  logic or_1172;
  assign or_1172 = (select_1031[7:6] == 2'h3) | (select_1031[8] & (select_1031[6] | select_1031[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1175;
  assign parity_1175 = ^{or_1172, or_1168, or_1164};
  // hls/stages/count_bits.hpp:25
  logic or_1179;
  assign or_1179 = (parity_1057 & parity_1060) | ((^select_1031[2:0]) & (parity_1057 | parity_1060));
  logic or_1183;
  assign or_1183 = (parity_1077 & parity_1080) | ((^select_1071[8:6]) & (parity_1077 | parity_1080));
  logic or_1187;
  assign or_1187 = (parity_1089 & parity_1092) | ((^select_1054[5:3]) & (parity_1089 | parity_1092));
  // hls/stages/count_bits.hpp:24
  logic parity_1190;
  assign parity_1190 = ^{or_1187, or_1183, or_1179};
  logic parity_1193;
  assign parity_1193 = ^{or_1187, or_1183, or_1179, or_1172, or_1168, or_1164, or_1157, or_1153, and_1149};
  logic xor_1194;
  assign xor_1194 = parity_1148 ^ parity_1193;
  // hls/stages/count_bits.hpp:25
  logic and_1195;
  assign and_1195 = parity_1148 & parity_1193;
  logic or_1199;
  assign or_1199 = (parity_1130 & parity_1145) | ((^{or_1111, or_1107, or_1103}) & (parity_1130 | parity_1145));
  logic or_1203;
  assign or_1203 = (parity_1175 & parity_1190) | ((^{or_1157, or_1153, and_1149}) & (parity_1175 | parity_1190));
  logic or_1210;
  assign or_1210 = (or_1107 & or_1111) | (or_1103 & (or_1107 | or_1111));
  logic or_1214;
  assign or_1214 = (or_1123 & or_1127) | (or_1119 & (or_1123 | or_1127));
  logic or_1218;
  assign or_1218 = (or_1138 & or_1142) | (or_1134 & (or_1138 | or_1142));
  // hls/stages/count_bits.hpp:24
  logic parity_1221;
  assign parity_1221 = ^{or_1218, or_1214, or_1210};
  // hls/stages/count_bits.hpp:25
  logic or_1225;
  assign or_1225 = (or_1153 & or_1157) | (and_1149 & (or_1153 | or_1157));
  logic or_1229;
  assign or_1229 = (or_1168 & or_1172) | (or_1164 & (or_1168 | or_1172));
  logic or_1233;
  assign or_1233 = (or_1183 & or_1187) | (or_1179 & (or_1183 | or_1187));
  // hls/stages/count_bits.hpp:24
  logic parity_1236;
  assign parity_1236 = ^{or_1233, or_1229, or_1225};
  logic parity_1239;
  assign parity_1239 = ^{or_1233, or_1229, or_1225, or_1218, or_1214, or_1210, or_1203, or_1199, and_1195};
  // hls/stages/count_bits.hpp:25
  logic or_1243;
  assign or_1243 = (parity_1221 & parity_1236) | ((^{or_1203, or_1199, and_1195}) & (parity_1221 | parity_1236));
  logic or_1247;
  assign or_1247 = (or_1199 & or_1203) | (and_1195 & (or_1199 | or_1203));
  logic or_1251;
  assign or_1251 = (or_1214 & or_1218) | (or_1210 & (or_1214 | or_1218));
  logic or_1255;
  assign or_1255 = (or_1229 & or_1233) | (or_1225 & (or_1229 | or_1233));
  // hls/stages/count_bits.hpp:24
  logic parity_1260;
  assign parity_1260 = ^{or_1255, or_1251, or_1247, or_1243};
  // hls/stages/count_bits.hpp:25
  logic or_1264;
  assign or_1264 = (or_1251 & or_1255) | (or_1247 & (or_1251 | or_1255));
  logic and_1265;
  assign and_1265 = or_1243 & (^{or_1255, or_1251, or_1247});
  // hls/stages/count_bits.hpp:24
  logic xor_1266;
  assign xor_1266 = or_1264 ^ and_1265;
  // hls/stages/count_bits.hpp:27
  logic and_1267;
  assign and_1267 = or_1264 & and_1265;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1268;
  assign select_1268 = equal_601_s1_q ? {and_1267, xor_1266, parity_1260, parity_1239, xor_1194, xor_1099} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_588_s1_q ? 6'h0 : select_1268;
  // hls/stages/agreement.hpp:222
  logic and_1276;
  assign and_1276 = right_codes_rdata_q[27] & not_592_s1_q;
  // hls/stages/agreement.hpp:744
  logic select_1277;
  assign select_1277 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_592_s1_q) : and_1276;
  // hls/stages/agreement.hpp:222
  logic [11:0] select_1279;
  assign select_1279 = less_591_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:744
  logic [11:0] select_1280;
  assign select_1280 = slot_s1_q[0] ? (less_591_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1279;
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1284;
  assign select_1284 = and_775 ? (select_1277 ? (~(select_777 ^ select_1280)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1290;
  assign parity_1290 = ^select_1284[5:3];
  logic parity_1293;
  assign parity_1293 = ^select_1284[8:6];
  logic parity_1296;
  assign parity_1296 = ^select_1284[11:3];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1304;
  assign select_1304 = (slot_s1_q[0] ? and_1276 : and_776) ? (~(select_800 ^ (slot_s1_q[0] ? select_1279 : select_778))) : 12'h0;
  logic [11:0] select_1305;
  assign select_1305 = and_798 ? select_1304 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1308;
  assign parity_1308 = ^select_1305[8:6];
  logic parity_1311;
  assign parity_1311 = ^select_1305[11:9];
  // hls/stages/agreement.hpp:694
  logic [11:0] select_1319;
  assign select_1319 = (slot_s1_q[0] ? and_776 : and_799) ? (~(select_817 ^ (slot_s1_q[0] ? select_778 : select_801))) : 12'h0;
  logic [11:0] select_1320;
  assign select_1320 = and_815 ? select_1319 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1326;
  assign parity_1326 = ^select_1320[2:0];
  logic parity_1329;
  assign parity_1329 = ^select_1320[5:3];
  logic parity_1332;
  assign parity_1332 = ^select_1320[8:0];
  logic parity_1338;
  assign parity_1338 = ^select_1320[11:9];
  logic parity_1341;
  assign parity_1341 = ^select_1305[2:0];
  logic parity_1344;
  assign parity_1344 = ^{select_1320[11:9], select_1305[5:0]};
  logic parity_1347;
  assign parity_1347 = ^{select_1320, select_1305, select_1284[2:0]};
  logic xor_1348;
  assign xor_1348 = parity_1296 ^ parity_1347;
  // hls/stages/count_bits.hpp:23
  logic or_1352;
  assign or_1352 = (select_1284[1:0] == 2'h3) | (select_1284[2] & (select_1284[0] | select_1284[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1356;
  assign or_1356 = (select_1305[7:6] == 2'h3) | (select_1305[8] & (select_1305[6] | select_1305[7]));
  logic or_1360;
  assign or_1360 = (select_1305[10:9] == 2'h3) | (select_1305[11] & (select_1305[9] | select_1305[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1368;
  assign or_1368 = (select_1320[7:6] == 2'h3) | (select_1320[8] & (~(select_1320[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1372;
  assign or_1372 = (select_1320[1:0] == 2'h3) | (select_1320[2] & (select_1320[0] | select_1320[1]));
  logic or_1376;
  assign or_1376 = (select_1320[4:3] == 2'h3) | (select_1320[5] & (select_1320[3] | select_1320[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1379;
  assign parity_1379 = ^{or_1376, or_1372, or_1368};
  // hls/stages/count_bits.hpp:23
  logic or_1383;
  assign or_1383 = (select_1305[4:3] == 2'h3) | (select_1305[5] & (select_1305[3] | select_1305[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1387;
  assign or_1387 = (select_1320[10:9] == 2'h3) | (select_1320[11] & (select_1320[9] | select_1320[10]));
  logic or_1391;
  assign or_1391 = (select_1305[1:0] == 2'h3) | (select_1305[2] & (select_1305[0] | select_1305[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1394;
  assign parity_1394 = ^{or_1391, or_1387, or_1383};
  logic parity_1397;
  assign parity_1397 = ^{or_1391, or_1387, or_1383, or_1376, or_1372, or_1368, or_1360, or_1356, or_1352};
  // hls/stages/count_bits.hpp:25
  logic and_1398;
  assign and_1398 = parity_1296 & parity_1347;
  logic or_1402;
  assign or_1402 = (parity_1290 & parity_1293) | ((^select_1284[11:9]) & (parity_1290 | parity_1293));
  logic and_1405;
  assign and_1405 = (^{select_1305[11:6], select_1284[2:0]}) & (parity_1332 | parity_1344);
  logic or_1406;
  assign or_1406 = (parity_1332 & parity_1344) | and_1405;
  // hls/stages/count_bits.hpp:23
  logic or_1413;
  assign or_1413 = (select_1284[10:9] == 2'h3) | (select_1284[11] & (select_1284[9] | select_1284[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1417;
  assign or_1417 = (select_1284[4:3] == 2'h3) | (select_1284[5] & (select_1284[3] | select_1284[4]));
  logic or_1421;
  assign or_1421 = (select_1284[7:6] == 2'h3) | (select_1284[8] & (select_1284[6] | select_1284[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1424;
  assign parity_1424 = ^{or_1421, or_1417, or_1413};
  // hls/stages/count_bits.hpp:25
  logic or_1428;
  assign or_1428 = (parity_1308 & parity_1311) | ((^select_1284[2:0]) & (parity_1308 | parity_1311));
  logic or_1432;
  assign or_1432 = (parity_1326 & parity_1329) | ((^select_1320[8:6]) & (parity_1326 | parity_1329));
  logic or_1436;
  assign or_1436 = (parity_1338 & parity_1341) | ((^select_1305[5:3]) & (parity_1338 | parity_1341));
  // hls/stages/count_bits.hpp:24
  logic parity_1439;
  assign parity_1439 = ^{or_1436, or_1432, or_1428};
  logic parity_1442;
  assign parity_1442 = ^{or_1436, or_1432, or_1428, or_1421, or_1417, or_1413, or_1406, or_1402, and_1398};
  logic xor_1443;
  assign xor_1443 = parity_1397 ^ parity_1442;
  // hls/stages/count_bits.hpp:25
  logic and_1444;
  assign and_1444 = parity_1397 & parity_1442;
  logic or_1448;
  assign or_1448 = (parity_1379 & parity_1394) | ((^{or_1360, or_1356, or_1352}) & (parity_1379 | parity_1394));
  logic or_1452;
  assign or_1452 = (parity_1424 & parity_1439) | ((^{or_1406, or_1402, and_1398}) & (parity_1424 | parity_1439));
  logic or_1459;
  assign or_1459 = (or_1356 & or_1360) | (or_1352 & (or_1356 | or_1360));
  logic or_1463;
  assign or_1463 = (or_1372 & or_1376) | (or_1368 & (or_1372 | or_1376));
  logic or_1467;
  assign or_1467 = (or_1387 & or_1391) | (or_1383 & (or_1387 | or_1391));
  // hls/stages/count_bits.hpp:24
  logic parity_1470;
  assign parity_1470 = ^{or_1467, or_1463, or_1459};
  // hls/stages/count_bits.hpp:25
  logic or_1474;
  assign or_1474 = (or_1402 & or_1406) | (and_1398 & (or_1402 | or_1406));
  logic or_1478;
  assign or_1478 = (or_1417 & or_1421) | (or_1413 & (or_1417 | or_1421));
  logic or_1482;
  assign or_1482 = (or_1432 & or_1436) | (or_1428 & (or_1432 | or_1436));
  // hls/stages/count_bits.hpp:24
  logic parity_1485;
  assign parity_1485 = ^{or_1482, or_1478, or_1474};
  logic parity_1488;
  assign parity_1488 = ^{or_1482, or_1478, or_1474, or_1467, or_1463, or_1459, or_1452, or_1448, and_1444};
  // hls/stages/count_bits.hpp:25
  logic or_1492;
  assign or_1492 = (parity_1470 & parity_1485) | ((^{or_1452, or_1448, and_1444}) & (parity_1470 | parity_1485));
  logic or_1496;
  assign or_1496 = (or_1448 & or_1452) | (and_1444 & (or_1448 | or_1452));
  logic or_1500;
  assign or_1500 = (or_1463 & or_1467) | (or_1459 & (or_1463 | or_1467));
  logic or_1504;
  assign or_1504 = (or_1478 & or_1482) | (or_1474 & (or_1478 | or_1482));
  // hls/stages/count_bits.hpp:24
  logic parity_1509;
  assign parity_1509 = ^{or_1504, or_1500, or_1496, or_1492};
  // hls/stages/count_bits.hpp:25
  logic or_1513;
  assign or_1513 = (or_1500 & or_1504) | (or_1496 & (or_1500 | or_1504));
  logic and_1514;
  assign and_1514 = or_1492 & (^{or_1504, or_1500, or_1496});
  // hls/stages/count_bits.hpp:24
  logic xor_1515;
  assign xor_1515 = or_1513 ^ and_1514;
  // hls/stages/count_bits.hpp:27
  logic and_1516;
  assign and_1516 = or_1513 & and_1514;
  // hls/stages/agreement.hpp:150
  logic [5:0] select_1517;
  assign select_1517 = equal_601_s1_q ? {and_1516, xor_1515, parity_1509, parity_1488, xor_1443, xor_1348} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_588_s1_q ? 6'h0 : select_1517;
  // hls/stages/agreement.hpp:798
  logic and_1585;
  assign and_1585 = ends_cell_s1_q & inside_v;
  logic and_1587;
  assign and_1587 = not_584 & (so_s1_q & and_1585);
  logic [5:0] select_1591;
  assign select_1591 = so_s1_q ? x_s1_q[5:0] : (or_588_s1_q ? (less_591_s1_q ? 6'h0 : select_633) : 6'h0);
  // hls/stages/agreement.hpp:248
  logic or_1595;
  assign or_1595 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:150
  logic and_1604;
  assign and_1604 = or_588_s1_q & (slot_s1_q[2] & not_592_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1717;
  assign select_1717 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1717[16:7])) ? 8'h7f : select_1717[7:0];
  // hls/stages/patches.hpp:174
  logic [7:0] pixel;
  assign pixel = equal_1794_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1794_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:504
  logic less_1881;
  assign less_1881 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:505
  logic or_1882;
  assign or_1882 = equal_1793_s1_q | less_1881;
  // hls/stages/patches.hpp:508
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1887;
  assign select_1887 = equal_1793_s1_q ? patches_column_s1_q[0] : (or_1882 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1888;
  assign not_1888 = ~or_1882;
  // hls/stages/patches.hpp:505
  logic [4:0] sum_1889;
  assign sum_1889 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:507
  logic [4:0] select_1892;
  assign select_1892 = or_1882 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1889) + 5'h1) : sum_1889;
  // hls/stages/patches.hpp:509
  logic [4:0] select_1893;
  assign select_1893 = equal_1793_s1_q ? 5'h0 : select_1892;
  logic or_1894;
  assign or_1894 = equal_1793_s1_q | equal_1791_s1_q;
  // hls/stages/patches.hpp:485
  logic equal_1896;
  assign equal_1896 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1898;
  assign equal_1898 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:487
  logic and_1900;
  assign and_1900 = of_row & (~equal_1898);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1896 ? 2'h3 : {equal_1898, and_1900};
  // hls/stages/patches.hpp:473
  logic [8:0] sum_1903;
  assign sum_1903 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1904;
  assign sum_1904 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1903, pixel_2[0]} - {1'b0, sum_1904, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:475
  logic [11:0] sum_1906;
  assign sum_1906 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1907;
  assign sum_1907 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1906[11], sum_1906};
  logic [13:0] sum_1908;
  assign sum_1908 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1907, down_2[1]};
  logic [12:0] sum_1909;
  assign sum_1909 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1908[13:1];
  logic [14:0] sum_1910;
  assign sum_1910 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1909, sum_1908[0], down_2[0]};
  // hls/stages/patches.hpp:457
  logic or_1917;
  assign or_1917 = (sum_1910[8] & (~(sum_1910[7:0] == 8'h0))) | (~(sum_1910[13:9] == 5'h0));
  // hls/stages/patches.hpp:471
  logic [8:0] sum_1922;
  assign sum_1922 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1923;
  assign sum_1923 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1922};
  logic [10:0] sum_1924;
  assign sum_1924 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1923, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1925;
  assign sum_1925 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1924[10:1];
  // hls/stages/patches.hpp:472
  logic [11:0] smooth;
  assign smooth = {sum_1925, sum_1924[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:474
  logic [12:0] sum_1927;
  assign sum_1927 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1928;
  assign sum_1928 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1929;
  assign difference_1929 = {1'b0, sum_1927, smooth[0]} - {1'b0, sum_1928, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:457
  logic or_1936;
  assign or_1936 = (difference_1929[8] & (~(difference_1929[7:0] == 8'h0))) | (~(difference_1929[13:9] == 5'h0));
  // hls/stages/patches.hpp:486
  logic or_1944;
  assign or_1944 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1898) | equal_1896;
  // hls/stages/patches.hpp:481
  logic and_1949;
  assign and_1949 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/agreement.hpp:276
  logic and_1953;
  assign and_1953 = not_1792_s1_q & (or_1795_s1_q & (or_1944 & (equal_1794_s1_q & and_1949)));
  // hls/stages/patches.hpp:174
  logic and_1963;
  assign and_1963 = (~(equal_1794_s1_q | (~and_1949))) & (~patches_column_s1_q[4]);
  // hls/stages/agreement.hpp:276
  logic and_1967;
  assign and_1967 = not_1792_s1_q & (or_1795_s1_q & (and_1963 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:549
  logic less_1969;
  assign less_1969 = patches_step_q[4:0] < 5'h11;
  logic equal_1970;
  assign equal_1970 = patches_step_q[6:5] == 2'h2;
  logic equal_1971;
  assign equal_1971 = patches_step_q[6:5] == 2'h1;
  logic or_1972;
  assign or_1972 = equal_1970 | equal_1971;
  // hls/stages/division.hpp:34
  logic [5:0] sum_2002;
  assign sum_2002 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:1289
  logic not_2064;
  assign not_2064 = ~sample_pair_first_q;
  // hls/stages/agreement.hpp:1157
  logic equal_2314;
  assign equal_2314 = x_s1_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:798
  logic select_2384;
  assign select_2384 = equal_583_s1_q ? (moments_other_field_second_q ^ equal_2314) : moments_other_field_second_q;
  // hls/stages/agreement.hpp:465
  logic select_2596;
  assign select_2596 = equal_2499_s1_q ? (~({row_s1_q, 1'b0} < {sum_2593, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:472
  logic and_2599;
  assign and_2599 = proven_q & less_2598;
  // hls/stages/agreement.hpp:530
  logic select_2603;
  assign select_2603 = and_556_s1_q ? (equal_2499_s1_q ? (and_2599 & (row_s1_q[5:1] == 5'h0)) : late_q) : late_q;
  // hls/stages/agreement.hpp:473
  logic equal_2604;
  assign equal_2604 = row_s1_q[5:2] == 4'h0;
  // hls/stages/agreement.hpp:474
  logic and_2605;
  assign and_2605 = and_2599 & equal_2604;
  // hls/stages/agreement.hpp:530
  logic and_2873;
  assign and_2873 = and_556_s1_q & (equal_2499_s1_q & equal_2604);
  // hls/stages/registration.hpp:128
  logic and_2874;
  assign and_2874 = and_2500_s1_q & and_2873;
  // hls/stages/registration.hpp:127
  logic and_2876;
  assign and_2876 = and_2500_s1_q & (~and_2873);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2877;
  assign select_2877 = and_2876 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2879;
  assign select_2879 = and_2874 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2877[15]}}, select_2877});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2880;
  assign select_2880 = and_2876 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2880[15]}}, select_2880};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2882;
  assign select_2882 = and_2874 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:150
  logic and_2883;
  assign and_2883 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_5;
  assign column_5 = registration_slope_q + (and_2883 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:191
  logic select_3127;
  assign select_3127 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/agreement.hpp:276
  logic [11:0] select_3130;
  assign select_3130 = equal_1791_s1_q ? patches_smooth_values_0_q : (or_1795_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3132;
  assign select_3132 = or_1795_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3134;
  assign select_3134 = equal_1789_s1_q ? patches_smooth_values_1_q : (equal_1791_s1_q ? patches_smooth_values_1_q : select_3132);
  logic [11:0] select_3135;
  assign select_3135 = or_1795_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3137;
  assign select_3137 = equal_1789_s1_q ? patches_smooth_values_2_q : (equal_1791_s1_q ? patches_smooth_values_2_q : select_3135);
  logic [11:0] select_3138;
  assign select_3138 = or_1795_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3140;
  assign select_3140 = equal_1789_s1_q ? patches_smooth_values_3_q : (equal_1791_s1_q ? patches_smooth_values_3_q : select_3138);
  logic [10:0] select_3142;
  assign select_3142 = equal_1791_s1_q ? patches_down_values_0_q : (or_1795_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3145;
  assign select_3145 = equal_1791_s1_q ? patches_down_values_1_q : (or_1795_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3148;
  assign select_3148 = equal_1791_s1_q ? patches_down_values_2_q : (or_1795_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3151;
  assign select_3151 = equal_1791_s1_q ? patches_down_values_3_q : (or_1795_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:177
  logic and_3188;
  assign and_3188 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:417
  logic [4:0] select_3193;
  assign select_3193 = or_3088_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:419
  logic [3:0] select_3195;
  assign select_3195 = and_3188 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3551;
  assign select_3551 = equal_1789_s1_q ? patches_summed_down_by_q : (equal_1791_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  logic select_3569;
  assign select_3569 = equal_1789_s1_q ? (less_1969 & (equal_1971 & or_1972)) : patches_read_searches_q;
  // hls/stages/agreement.hpp:206
  logic [8:0] select_3873;
  assign select_3873 = so_s1_q ? (and_2883 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3875;
  assign sum_3875 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3876;
  assign select_3876 = sum_2002[5] ? {1'b1, sum_2002[4:0], region_across_rest_q[2:0]} : sum_3875;
  // hls/stages/agreement.hpp:465
  logic [7:0] select_3878;
  assign select_3878 = equal_2499_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3881;
  assign select_3881 = equal_2499_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;
  // hls/stages/agreement.hpp:1162
  logic equal_3931;
  assign equal_3931 = x_s1_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:279
  logic and_4098;
  assign and_4098 = (~drew_q) & (done_q | said_q);
  // hls/stages/agreement.hpp:1290
  logic select_4101;
  assign select_4101 = sample_pair_first_q ? done_q : proven_q;
  // hls/stages/agreement.hpp:279
  logic select_4103;
  assign select_4103 = sample_pair_first_q ? done_q : (sample_pair_whole_q ? select_4101 : proven_q);

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:238; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_521_s1_q;
`ifndef SYNTHESIS
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_530;
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
  assign census_memory_re = s1_en & and_556_s1_q;
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
  assign moments_memory_re = s1_en & and_599;
`endif
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1393; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_588_s1_q ? select_633 : right_s1_q;
`ifndef SYNTHESIS
  logic best_right_re;
  assign best_right_re = s1_en & select_624_s1_q;
`endif
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1394; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign shown_right_re = s1_en & and_1587;
`endif
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1395; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign left_turns_re = s1_en & and_1604;
`endif
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1395; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [5:0] right_turns_raddr;
  assign right_turns_raddr = select_633;
`ifndef SYNTHESIS
  logic right_turns_re;
  assign right_turns_re = s1_en & and_1604;
`endif
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:806; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1893, not_1888, select_1887};
`ifndef SYNTHESIS
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1894;
`endif
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:807; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign patches_left_codes_re = s1_en & (not_1790_s1_q & (new_row & equal_1791_s1_q));
`endif
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:821; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
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
  assign patches_rows_re = s1_en & (equal_1789_s1_q & (less_1969 & or_1972));
`endif
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1422; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign seen_columns_re = s1_en & and_1587;
`endif
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_662_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_764, left_rdata_q[65:49], and_763, left_rdata_q[47:31], and_762, left_rdata_q[29:13], and_761, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_662_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_770, right_codes_rdata_q[84:73], and_769, right_codes_rdata_q[71:60], and_768, right_codes_rdata_q[56:43], and_767, right_codes_rdata_q[41:28], and_766, right_codes_rdata_q[26:13], and_765, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_1875_s1_q;
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
      moments_place_q <= select_579;
      moments_taken_q <= not_584 & (not_586 & (equal_587_s1_q & inside_v));
      moments_starts_q <= not_584 & (not_586 & (equal_587_s1_q & (inside_v & first)));
      moments_other_field_second_q <= select_2384;
      row_q <= and_556_s1_q ? (equal_2499_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_556_s1_q ? select_2596 : lower_half_q;
      late_q <= select_2603;
      registration_slope_row_q <= select_2879;
      registration_slope_change_q <= select_2882;
      registration_slope_q <= so_s1_q ? column_5 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3112_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3112_s1_q & select_3127;
      patches_smooth_values_0_q <= equal_1789_s1_q ? patches_smooth_values_0_q : select_3130;
      patches_smooth_values_1_q <= select_3134;
      patches_smooth_values_2_q <= select_3137;
      patches_smooth_values_3_q <= select_3140;
      patches_down_values_0_q <= equal_1789_s1_q ? patches_down_values_0_q : select_3142;
      patches_down_values_1_q <= equal_1789_s1_q ? patches_down_values_1_q : select_3145;
      patches_down_values_2_q <= equal_1789_s1_q ? patches_down_values_2_q : select_3148;
      patches_down_values_3_q <= equal_1789_s1_q ? patches_down_values_3_q : select_3151;
      patches_down_by_q <= or_3088_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3188});
      patches_along_q <= select_3193;
      patches_match_row_q <= or_3088_s1_q ? 4'h0 : select_3195;
      patches_summed_last_q <= not_1790_s1_q & (equal_1791_s1_q & and_3188);
      patches_summed_down_by_q <= select_3551;
      patches_step_q <= or_3088_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3569;
      region_across_rest_q <= select_3873;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3876;
      columns_begin_rest_q <= and_556_s1_q ? select_3878 : columns_begin_rest_q;
      columns_begin_back_q <= and_556_s1_q ? select_3881 : columns_begin_back_q;
      done_q <= sample_pair_whole_q ? (not_2064 & and_4098) : and_4098;
      proven_q <= sample_pair_whole_q ? select_4103 : proven_q;
      drew_q <= so_s1_q;
      said_q <= equal_583_s1_q & equal_3931;
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
  logic [2:0] select_517_s2_q;
  logic row_starts_s2_q;
  logic [7:0] select_521_s2_q;
  logic and_529_s2_q;
  logic and_530_s2_q;
  logic equal_535_s2_q;
  logic [5:0] select_550_s2_q;
  logic [5:0] last_s2_2_q;
  logic and_554_s2_q;
  logic and_556_s2_q;
  logic equal_576_s2_q;
  logic [11:0] address_s2_q;
  logic equal_583_s2_q;
  logic not_584_s2_q;
  logic not_586_s2_q;
  logic equal_587_s2_q;
  logic or_588_s2_q;
  logic less_591_s2_q;
  logic not_592_s2_q;
  logic inside_v_s2_q;
  logic not_595_s2_q;
  logic and_599_s2_q;
  logic and_615_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] right_s2_q;
  logic and_647_s2_q;
  logic and_650_s2_q;
  logic and_656_s2_q;
  logic and_658_s2_q;
  logic equal_691_s2_q;
  logic [5:0] column_s2_q;
  logic [5:0] select_1270_s2_q;
  logic [5:0] select_1519_s2_q;
  logic and_1574_s2_q;
  logic equal_1575_s2_q;
  logic and_1585_s2_q;
  logic and_1587_s2_q;
  logic [5:0] select_1591_s2_q;
  logic or_1595_s2_q;
  logic and_1698_s2_q;
  logic less_1712_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1789_s2_q;
  logic equal_1791_s2_q;
  logic equal_1794_s2_q;
  logic or_1795_s2_q;
  logic not_1796_s2_q;
  logic [4:0] select_1819_s2_q;
  logic select_1825_s2_q;
  logic [3:0] select_1865_s2_q;
  logic less_1881_s2_q;
  logic new_row_s2_q;
  logic or_1894_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic not_1911_s2_q;
  logic or_1917_s2_q;
  logic and_1921_s2_q;
  logic and_1937_s2_q;
  logic and_1940_s2_q;
  logic and_1954_s2_q;
  logic and_1963_s2_q;
  logic and_1968_s2_q;
  logic less_1969_s2_q;
  logic equal_1970_s2_q;
  logic or_1972_s2_q;
  logic and_1981_s2_q;
  logic select_1983_s2_q;
  logic and_1986_s2_q;
  logic sum_2002_s2_q;
  logic not_2012_s2_q;
  logic and_2026_s2_q;
  logic not_2064_s2_q;
  logic less_2145_s2_q;
  logic equal_2299_s2_q;
  logic equal_2314_s2_q;
  logic equal_2499_s2_q;
  logic and_2605_s2_q;
  logic and_2636_s2_q;
  logic equal_2725_s2_q;
  logic less_3164_s2_q;
  logic equal_3507_s2_q;
  logic equal_3604_s2_q;
  logic less_3859_s2_q;
  logic equal_3931_s2_q;
  logic or_4081_s2_q;
  logic and_4155_s2_q;
  logic not_4173_s2_q;
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
      select_517_s2_q <= select_517_s1_q;
      row_starts_s2_q <= row_starts_s1_q;
      select_521_s2_q <= select_521_s1_q;
      and_529_s2_q <= and_529_s1_q;
      and_530_s2_q <= and_530;
      equal_535_s2_q <= equal_535_s1_q;
      select_550_s2_q <= select_550_s1_q;
      last_s2_2_q <= last_s1_2_q;
      and_554_s2_q <= and_554_s1_q;
      and_556_s2_q <= and_556_s1_q;
      equal_576_s2_q <= equal_576;
      address_s2_q <= address;
      equal_583_s2_q <= equal_583_s1_q;
      not_584_s2_q <= not_584;
      not_586_s2_q <= not_586;
      equal_587_s2_q <= equal_587_s1_q;
      or_588_s2_q <= or_588_s1_q;
      less_591_s2_q <= less_591_s1_q;
      not_592_s2_q <= not_592_s1_q;
      inside_v_s2_q <= inside_v;
      not_595_s2_q <= not_595;
      and_599_s2_q <= and_599;
      and_615_s2_q <= (or_588_s1_q & (left_rdata_q[68] & not_592_s1_q)) & and_614;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_647_s2_q <= (or_588_s1_q & (left_rdata_q[70] & not_592_s1_q)) & less_646;
      and_650_s2_q <= or_588_s1_q & (left_rdata_q[71] & not_592_s1_q);
      and_656_s2_q <= and_656;
      and_658_s2_q <= or_588_s1_q & (right_codes_rdata_q[59] & not_592_s1_q);
      equal_691_s2_q <= row_s1_q == 6'h0;
      column_s2_q <= column;
      select_1270_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1519_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1574_s2_q <= and_1574_s1_q;
      equal_1575_s2_q <= equal_1575_s1_q;
      and_1585_s2_q <= and_1585;
      and_1587_s2_q <= and_1587;
      select_1591_s2_q <= select_1591;
      or_1595_s2_q <= or_1595;
      and_1698_s2_q <= and_1698_s1_q;
      less_1712_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1789_s2_q <= equal_1789_s1_q;
      equal_1791_s2_q <= equal_1791_s1_q;
      equal_1794_s2_q <= equal_1794_s1_q;
      or_1795_s2_q <= or_1795_s1_q;
      not_1796_s2_q <= not_1796_s1_q;
      select_1819_s2_q <= select_1819_s1_q;
      select_1825_s2_q <= select_1825_s1_q;
      select_1865_s2_q <= select_1865_s1_q;
      less_1881_s2_q <= less_1881;
      new_row_s2_q <= new_row;
      or_1894_s2_q <= or_1894;
      of_row_2_s2_q <= of_row_2;
      not_1911_s2_q <= ~sum_1910[14];
      or_1917_s2_q <= or_1917;
      and_1921_s2_q <= sum_1910[14] & (~(sum_1910[13:8] == 6'h3f));
      and_1937_s2_q <= (~difference_1929[14]) & or_1936;
      and_1940_s2_q <= difference_1929[14] & (~(difference_1929[13:8] == 6'h3f));
      and_1954_s2_q <= not_1790_s1_q & and_1953;
      and_1963_s2_q <= and_1963;
      and_1968_s2_q <= not_1790_s1_q & and_1967;
      less_1969_s2_q <= less_1969;
      equal_1970_s2_q <= equal_1970;
      or_1972_s2_q <= or_1972;
      and_1981_s2_q <= sample_pair_whole_q;
      select_1983_s2_q <= left_first_q;
      and_1986_s2_q <= right_q;
      sum_2002_s2_q <= sum_2002[5];
      not_2012_s2_q <= ~late_q;
      and_2026_s2_q <= or_588_s1_q & (left_rdata_q[69] & not_592_s1_q);
      not_2064_s2_q <= not_2064;
      less_2145_s2_q <= 6'h6 < row_q;
      equal_2299_s2_q <= (last_s1_2_q | row_s1_q) == 6'h0;
      equal_2314_s2_q <= equal_2314;
      equal_2499_s2_q <= equal_2499_s1_q;
      and_2605_s2_q <= and_2605;
      and_2636_s2_q <= or_588_s1_q & (not_592_s1_q & and_614);
      equal_2725_s2_q <= shift == 6'h0;
      less_3164_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3507_s2_q <= patches_match_row_q == 4'h0;
      equal_3604_s2_q <= patches_step_q[6:5] == 2'h3;
      less_3859_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3931_s2_q <= equal_3931;
      or_4081_s2_q <= and_2605 | (~(row_s1_q[5:3] == 3'h0));
      and_4155_s2_q <= less_2598 & select_4101;
      not_4173_s2_q <= ~proven_q;
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
  logic [11:0] select_533;
  assign select_533 = select_517_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:129
  logic [11:0] sum_537;
  assign sum_537 = select_533 + (equal_535_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:117
  logic [11:0] sum_539;
  assign sum_539 = {4'h0, sample_pair_pixel_1_q} + (select_517_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:129
  logic [11:0] sum_541;
  assign sum_541 = sum_539 + (equal_535_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:423
  logic whole;
  assign whole = select_517_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:130
  logic and_545;
  assign and_545 = whole & (averager_memory_rdata_q[24] | equal_535_s2_q);
  // hls/stages/agreement.hpp:423
  logic all_of_skin;
  assign all_of_skin = select_517_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:131
  logic and_549;
  assign and_549 = all_of_skin & (averager_memory_rdata_q[25] | equal_535_s2_q);
  // hls/stages/census.hpp:218
  logic [8:0] grey;
  assign grey = and_529_s2_q ? sum_537[11:3] : 9'h0;
  // hls/stages/census.hpp:134
  logic equal_559;
  assign equal_559 = select_517_s2_q == 3'h1;
  // hls/stages/census.hpp:219
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_559 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_562;
  assign select_562 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic [8:0] grey_2;
  assign grey_2 = and_529_s2_q ? sum_541[11:3] : 9'h0;
  // hls/stages/census.hpp:219
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_559 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_566;
  assign select_566 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:218
  logic and_567;
  assign and_567 = and_529_s2_q & and_545;
  // hls/stages/census.hpp:134
  logic select_569;
  assign select_569 = equal_559 ? and_567 : (averager_mask_q & and_567);
  // hls/stages/agreement.hpp:277
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_569;
  // hls/stages/census.hpp:218
  logic and_571;
  assign and_571 = and_529_s2_q & and_549;
  // hls/stages/census.hpp:134
  logic select_573;
  assign select_573 = equal_559 ? and_571 : (averager_of_skin_q & and_571);
  // hls/stages/agreement.hpp:277
  logic and_574;
  assign and_574 = sample_pair_whole_s2_q & select_573;
  // hls/stages/agreement.hpp:988
  logic select_628;
  assign select_628 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:989
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:1002
  logic [8:0] difference_638;
  assign difference_638 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:1003
  logic [9:0] sum_639;
  assign sum_639 = {difference_638[8], difference_638} + 10'h1;
  // hls/stages/agreement.hpp:248
  logic and_641;
  assign and_641 = (and_615_s2_q & select_628) & ({{22{sum_639[9]}}, sum_639} < 32'h3);
  // hls/stages/agreement.hpp:150
  logic and_643;
  assign and_643 = or_588_s2_q & (not_592_s2_q & and_641);
  // hls/stages/moments.hpp:89
  logic and_648;
  assign and_648 = and_643 & and_647_s2_q;
  // hls/stages/census.hpp:308
  logic less_664;
  assign less_664 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_665;
  assign less_665 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_666;
  assign less_666 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_667;
  assign less_667 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_668;
  assign less_668 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_669;
  assign less_669 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_670;
  assign less_670 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_671;
  assign less_671 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_672;
  assign less_672 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_673;
  assign less_673 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_674;
  assign less_674 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_675;
  assign less_675 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:309
  logic less_676;
  assign less_676 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_677;
  assign less_677 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_678;
  assign less_678 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_679;
  assign less_679 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_680;
  assign less_680 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_681;
  assign less_681 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_682;
  assign less_682 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_683;
  assign less_683 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_684;
  assign less_684 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_685;
  assign less_685 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_686;
  assign less_686 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_687;
  assign less_687 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:460
  logic equal_688;
  assign equal_688 = last_s2_2_q == 6'h0;
  logic [3:0] select_692;
  assign select_692 = equal_691_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:461
  logic [4:0] select_693;
  assign select_693 = equal_688 ? {select_692, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:290
  logic [3:0] select_694;
  assign select_694 = equal_688 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:313
  logic and_695;
  assign and_695 = select_693[4] & select_694[3];
  // hls/stages/census.hpp:300
  logic and_697;
  assign and_697 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_699;
  assign and_699 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_697);
  // hls/stages/agreement.hpp:461
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_699;
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
  logic [9:0] difference_722;
  assign difference_722 = {1'b0, select_562} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_723;
  assign xor_723 = difference_722[8:0] ^ {9{difference_722[9]}};
  logic [9:0] sum_724;
  assign sum_724 = {9'h0, difference_722[9]} + {1'b0, xor_723};
  logic [9:0] difference_725;
  assign difference_725 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_726;
  assign xor_726 = difference_725[8:0] ^ {9{difference_725[9]}};
  logic [9:0] sum_727;
  assign sum_727 = {9'h0, difference_725[9]} + {1'b0, xor_726};
  logic [9:0] difference_729;
  assign difference_729 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_730;
  assign xor_730 = difference_729[8:0] ^ {9{difference_729[9]}};
  logic [9:0] sum_731;
  assign sum_731 = {9'h0, difference_729[9]} + {1'b0, xor_730};
  logic [10:0] sum_732;
  assign sum_732 = ({1'b0, sum_724} + {1'b0, sum_727}) + {1'b0, sum_731};
  logic [9:0] difference_733;
  assign difference_733 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_734;
  assign xor_734 = difference_733[8:0] ^ {9{difference_733[9]}};
  logic [9:0] sum_735;
  assign sum_735 = {9'h0, difference_733[9]} + {1'b0, xor_734};
  logic [9:0] difference_737;
  assign difference_737 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_738;
  assign xor_738 = difference_737[8:0] ^ {9{difference_737[9]}};
  // hls/stages/agreement.hpp:461
  logic and_746;
  assign and_746 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_747;
  assign and_747 = and_695 & and_746;
  // hls/stages/census.hpp:320
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:33
  logic [6:0] sum_749;
  assign sum_749 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:320
  logic and_751;
  assign and_751 = and_747 & ({{5{sum_749[6]}}, sum_749, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:321
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:33
  logic [6:0] sum_755;
  assign sum_755 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:817
  logic or_772;
  assign or_772 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:818
  logic select_774;
  assign select_774 = or_772 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1021;
  assign select_1021 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_1022;
  assign difference_1022 = {1'b0, column_s2_q} - {1'b0, select_1021};
  logic [7:0] sum_1024;
  assign sum_1024 = {difference_1022[6], difference_1022} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:765
  logic [7:0] select_1025;
  assign select_1025 = slot_s2_q[0] ? chosen_score_q : sum_1024;
  // hls/stages/agreement.hpp:788
  logic [6:0] difference_1271;
  assign difference_1271 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1270_s2_q};
  // hls/stages/agreement.hpp:759
  logic equal_1272;
  assign equal_1272 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] sum_1274;
  assign sum_1274 = {difference_1271[6], difference_1271} + (equal_1272 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1520;
  assign difference_1520 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1519_s2_q};
  logic [7:0] sum_1522;
  assign sum_1522 = {difference_1520[6], difference_1520} + (equal_1272 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:761
  logic less_1523;
  assign less_1523 = sum_1274 < sum_1522;
  logic [7:0] select_1524;
  assign select_1524 = less_1523 ? sum_1522 : sum_1274;
  logic less_1525;
  assign less_1525 = select_1025 < select_1524;
  // hls/stages/agreement.hpp:811
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1525 ? select_1524 : select_1025) : 8'h0;
  // hls/stages/agreement.hpp:818
  logic or_1529;
  assign or_1529 = select_774 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:823
  logic [5:0] select_1530;
  assign select_1530 = or_1529 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:730
  logic not_1531;
  assign not_1531 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:762
  logic [1:0] select_1532;
  assign select_1532 = less_1523 ? {slot_s2_q[0], not_1531} : 2'h0;
  logic [2:0] select_1534;
  assign select_1534 = less_1525 ? {select_1532, not_1531} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:823
  logic [2:0] select_1535;
  assign select_1535 = or_1529 ? select_1534 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1536;
  assign select_1536 = or_1529 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:820
  logic equal_1537;
  assign equal_1537 = select_1534 == 3'h1;
  logic or_1540;
  assign or_1540 = equal_1537 | (~(select_1534 == 3'h2));
  logic [7:0] select_1542;
  assign select_1542 = or_1540 ? before_0_q : before_1_q;
  logic [7:0] select_1543;
  assign select_1543 = equal_1537 ? (or_1540 ? sum_1274 : {7'h0, shift_not_right_q}) : select_1542;
  // hls/stages/agreement.hpp:823
  logic [7:0] select_1544;
  assign select_1544 = or_1529 ? select_1543 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1547;
  assign select_1547 = or_1529 ? (equal_1537 ? select_1542 : (or_1540 ? sum_1522 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1549;
  assign sum_1549 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1550;
  assign sum_1550 = {1'b0, before_v} + sum_1549;
  // hls/stages/agreement.hpp:765
  logic [6:0] select_1551;
  assign select_1551 = slot_s2_q[0] ? chosen_near_q : sum_1550;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1553;
  assign sum_1553 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1554;
  assign sum_1554 = {1'b0, before_v_2} + sum_1553;
  // hls/stages/agreement.hpp:789
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:790
  logic [6:0] sum_1556;
  assign sum_1556 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1557;
  assign sum_1557 = {1'b0, before_v_3} + sum_1556;
  // hls/stages/agreement.hpp:761
  logic [6:0] select_1559;
  assign select_1559 = (sum_1554 < sum_1557) ? sum_1557 : sum_1554;
  // hls/stages/agreement.hpp:812
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1551 < select_1559) ? select_1559 : select_1551) : 7'h0;
  // hls/stages/agreement.hpp:823
  logic less_1563;
  assign less_1563 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:827
  logic [6:0] select_1565;
  assign select_1565 = select_774 ? of_near : (less_1563 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1567;
  assign select_1567 = select_774 ? run_shift_s2_q : (less_1563 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1570;
  assign select_1570 = (run_shift_s2_q == 6'h3f) ? of_best : (select_774 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_1573;
  assign select_1573 = (run_shift_s2_q == 6'h1) ? of_best : (select_774 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:833
  logic select_1576;
  assign select_1576 = or_772 ? shift_first_s2_q : equal_1575_s2_q;
  // hls/stages/agreement.hpp:834
  logic or_1578;
  assign or_1578 = select_1576 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:838
  logic [7:0] select_1579;
  assign select_1579 = or_1578 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1580;
  assign select_1580 = or_1578 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1582;
  assign or_1582 = select_1576 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:842
  logic [6:0] select_1583;
  assign select_1583 = or_1582 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1584;
  assign select_1584 = or_1582 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:150
  logic and_1598;
  assign and_1598 = or_588_s2_q & (not_592_s2_q & (and_641 & or_1595_s2_q));
  // hls/stages/agreement.hpp:798
  logic and_1599;
  assign and_1599 = not_586_s2_q & and_1598;
  logic and_1602;
  assign and_1602 = not_584_s2_q & (drew_q ? and_1585_s2_q : (equal_587_s2_q & and_643));
  // hls/stages/moments.hpp:85
  logic and_1606;
  assign and_1606 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1015
  logic and_1607;
  assign and_1607 = not_595_s2_q & and_1606;
  logic and_1610;
  assign and_1610 = not_595_s2_q & (and_1606 & (moments_memory_rdata_q[1] ^ and_650_s2_q));
  // hls/stages/moments.hpp:85
  logic and_1615;
  assign and_1615 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1015
  logic and_1616;
  assign and_1616 = not_595_s2_q & and_1615;
  logic and_1619;
  assign and_1619 = not_595_s2_q & (and_1615 & (moments_memory_rdata_q[3] ^ and_658_s2_q));
  // hls/stages/agreement.hpp:1143
  logic equal_1620;
  assign equal_1620 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1193
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1144
  logic [1:0] select_1623;
  assign select_1623 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1157
  logic [3:0] select_1625;
  assign select_1625 = equal_1620 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1623});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1626;
  assign sum_1626 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:798
  logic [3:0] select_1627;
  assign select_1627 = equal_583_s2_q ? select_1625 : {sum_1626, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:214
  logic equal_1628;
  assign equal_1628 = x_s2_q[5:0] == 6'h3f;
  logic equal_1630;
  assign equal_1630 = x_s2_q[5:0] == 6'h3e;
  logic equal_1632;
  assign equal_1632 = x_s2_q[5:0] == 6'h3d;
  logic equal_1634;
  assign equal_1634 = x_s2_q[5:0] == 6'h3c;
  logic equal_1636;
  assign equal_1636 = x_s2_q[5:0] == 6'h3b;
  logic equal_1638;
  assign equal_1638 = x_s2_q[5:0] == 6'h36;
  logic equal_1640;
  assign equal_1640 = x_s2_q[5:0] == 6'h35;
  logic equal_1642;
  assign equal_1642 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1193
  logic and_1646;
  assign and_1646 = (~equal_1636) & ((~equal_1638) & ((~equal_1640) & (~equal_1642)));
  logic and_1650;
  assign and_1650 = (~equal_1628) & ((~equal_1630) & ((~equal_1632) & ((~equal_1634) & and_1646)));
  // hls/stages/agreement.hpp:1144
  logic less_1651;
  assign less_1651 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1655;
  assign or_1655 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1022
  logic [4:0] sum_1660;
  assign sum_1660 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:263
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1660, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1666;
  assign sum_1666 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1668;
  assign and_1668 = half_ends & ({{3{sum_1666[4]}}, sum_1666} < 8'h3);
  // hls/stages/agreement.hpp:798
  logic and_1669;
  assign and_1669 = drew_q & and_1668;
  logic select_1670;
  assign select_1670 = equal_583_s2_q ? (x_s2_q[6] & (equal_1620 ? and_1650 : (less_1651 & (~or_1655)))) : and_1669;
  // hls/stages/registration.hpp:258
  logic not_1672;
  assign not_1672 = ~lower_half_s2_q;
  logic [3:0] select_1673;
  assign select_1673 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1672, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1672};
  // hls/stages/patches.hpp:377
  logic [1:0] select_1699;
  assign select_1699 = and_1698_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1700;
  assign select_1700 = and_1698_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:277
  logic [5:0] select_1701;
  assign select_1701 = row_starts_s2_q ? {select_1700, select_1699[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1702;
  assign select_1702 = row_starts_s2_q ? select_1699 : patches_fetch_q;
  logic equal_1703;
  assign equal_1703 = select_1702 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < x_s2_q;
  // hls/stages/agreement.hpp:798
  logic and_1711;
  assign and_1711 = not_584_s2_q & (drew_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1713;
  assign equal_1713 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:150
  logic [5:0] b;
  assign b = or_588_s2_q ? (less_591_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1713 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1721;
  assign select_1721 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_1722;
  assign select_1722 = b[1] ? a : 8'h0;
  logic [8:0] sum_1723;
  assign sum_1723 = {{2{select_1721[6]}}, select_1721} + {select_1722[7], select_1722};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1724;
  assign select_1724 = b[2] ? a : 8'h0;
  logic [7:0] select_1725;
  assign select_1725 = b[3] ? a : 8'h0;
  logic [8:0] sum_1726;
  assign sum_1726 = {{2{select_1724[7]}}, select_1724[7:1]} + {select_1725[7], select_1725};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1727;
  assign sum_1727 = {{3{sum_1723[8]}}, sum_1723[8:1]} + {sum_1726[8], sum_1726, select_1724[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1728;
  assign select_1728 = b[4] ? a : 8'h0;
  logic [7:0] select_1729;
  assign select_1729 = b[5] ? a : 8'h0;
  logic [8:0] difference_1730;
  assign difference_1730 = {{2{select_1728[7]}}, select_1728[7:1]} - {select_1729[7], select_1729};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1731;
  assign sum_1731 = {difference_1730, select_1728[0]} + {sum_1727[10], sum_1727[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1713 ? {sum_1731, sum_1727[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1733;
  assign sum_1733 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:263
  logic and_1736;
  assign and_1736 = less_1712_s2_q & (and_643 & ({{4{sum_1733[9]}}, sum_1733, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_1740;
  assign and_1740 = ({4'h0, last_s2_q[5:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1746;
  assign sum_1746 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1748;
  assign sum_1748 = {sum_1746[9], sum_1746[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1031
  logic and_1751;
  assign and_1751 = ($signed(9'h0) < $signed(sum_1746[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1748, sum_1746[0]})));
  logic and_1752;
  assign and_1752 = (~(and_1740 | (equal_576_s2_q | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1751;
  // hls/stages/agreement.hpp:798
  logic and_1756;
  assign and_1756 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1736 & and_1752)));
  logic and_1757;
  assign and_1757 = not_584_s2_q & and_1756;
  // hls/stages/patches.hpp:157
  logic and_1759;
  assign and_1759 = and_1757 & (~patches_fixed_q);
  // hls/stages/patches.hpp:348
  logic select_1760;
  assign select_1760 = and_1759 ? and_1757 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_1763;
  assign select_1763 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_1765;
  assign select_1765 = and_1759 ? (equal_583_s2_q ? 8'h0 : select_1763) : patches_choice_column_q;
  // hls/stages/agreement.hpp:798
  logic [5:0] select_1768;
  assign select_1768 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:348
  logic [5:0] select_1770;
  assign select_1770 = and_1759 ? (equal_583_s2_q ? 6'h0 : select_1768) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1771;
  assign sum_1771 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_1731[9]}}, sum_1731[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1774;
  assign select_1774 = ($signed(sum_1771[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1771[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1713 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1771[12:7])) ? 8'h7f : select_1774);
  // hls/stages/agreement.hpp:798
  logic [7:0] select_1779;
  assign select_1779 = drew_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:348
  logic [7:0] select_1781;
  assign select_1781 = and_1759 ? (equal_583_s2_q ? 8'h0 : select_1779) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_1782;
  assign equal_1782 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:798
  logic and_1786;
  assign and_1786 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1740 | equal_1782)));
  logic and_1787;
  assign and_1787 = not_584_s2_q & and_1786;
  // hls/stages/patches.hpp:348
  logic and_1788;
  assign and_1788 = patches_chooses_s2_q & and_1787;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1802;
  assign select_1802 = row_starts_s2_q ? select_1700 : patches_band_q;
  // hls/stages/patches.hpp:357
  logic equal_1803;
  assign equal_1803 = {patches_choosing_band_s2_q, and_1711} == {select_1802, select_1702[1]};
  // hls/stages/patches.hpp:490
  logic [2:0] sum_1902;
  assign sum_1902 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:457
  logic and_1918;
  assign and_1918 = not_1911_s2_q & or_1917_s2_q;
  // hls/stages/patches.hpp:494
  logic [1:0] sum_1958;
  assign sum_1958 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:206
  logic [7:0] select_1989;
  assign select_1989 = drew_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1064
  logic or_1992;
  assign or_1992 = select_1989[7] | (~({select_1989[5], select_1989[3], select_1989[1]} == 3'h0));
  // hls/stages/agreement.hpp:1063
  logic or_1995;
  assign or_1995 = select_1989[7] | (~({select_1989[6], select_1989[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1062
  logic or_1998;
  assign or_1998 = select_1989[7] | (~(select_1989[6:4] == 3'h0));
  // hls/stages/agreement.hpp:798
  logic [5:0] select_1999;
  assign select_1999 = equal_583_s2_q ? x_s2_q[5:0] : {region_row_q, or_1998, or_1995, or_1992};
  // hls/stages/agreement.hpp:1143
  logic not_2000;
  assign not_2000 = ~equal_1620;
  // hls/stages/agreement.hpp:1072
  logic or_2004;
  assign or_2004 = (~sum_2002_s2_q) | equal_1782;
  // hls/stages/agreement.hpp:798
  logic and_2007;
  assign and_2007 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & or_2004));
  // hls/stages/agreement.hpp:150
  logic and_2011;
  assign and_2011 = or_588_s2_q & (not_592_s2_q & and_615_s2_q);
  logic and_2028;
  assign and_2028 = or_588_s2_q & (not_592_s2_q & and_2026_s2_q);
  // hls/stages/agreement.hpp:263
  logic textured;
  assign textured = inside_v_s2_q & and_2011;
  logic and_2039;
  assign and_2039 = inside_v_s2_q & and_2028;
  logic explained;
  assign explained = inside_v_s2_q & and_643;
  // hls/stages/agreement.hpp:1027
  logic select_2041;
  assign select_2041 = slot_s2_q[2] ? shown_shown_q : and_643;
  // hls/stages/agreement.hpp:263
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2041);
  // hls/stages/agreement.hpp:1027
  logic select_2044;
  assign select_2044 = slot_s2_q[2] ? shown_nearer_q : and_1598;
  // hls/stages/agreement.hpp:263
  logic near;
  assign near = inside_v_s2_q & (select_2041 ? select_2044 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1286
  logic select_2047;
  assign select_2047 = done_s2_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1290
  logic select_2048;
  assign select_2048 = left_first_s2_q ? select_2047 : read_half_q;
  logic or_2049;
  assign or_2049 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1291
  logic [8:0] select_2050;
  assign select_2050 = or_2049 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1292
  logic [9:0] select_2052;
  assign select_2052 = left_first_s2_q ? 10'h1 : (or_2049 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1295
  logic and_2053;
  assign and_2053 = select_2050[8] & select_2052[9];
  // hls/stages/agreement.hpp:441
  logic next_row;
  assign next_row = and_2053 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1306
  logic [5:0] select_2056;
  assign select_2056 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2058;
  assign select_2058 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2056});
  // hls/stages/agreement.hpp:1317
  logic equal_2059;
  assign equal_2059 = seen_x_q == 3'h7;
  logic [7:0] select_2061;
  assign select_2061 = and_2053 ? 8'h0 : (seen_column_q + {7'h0, equal_2059});
  // hls/stages/agreement.hpp:1324
  logic [10:0] index;
  assign index = select_2058 + {3'h0, select_2061};
  // hls/stages/agreement.hpp:1276
  logic [11:0] sum_2063;
  assign sum_2063 = {1'b0, {2{select_2048}}, 2'h0, {2{select_2048}}, 1'b0, {2{select_2048}}, 1'b0, select_2048} + {1'b0, index};
  // hls/stages/agreement.hpp:441
  logic and_2066;
  assign and_2066 = not_2064_s2_q & (began_q | and_2053);
  // hls/stages/agreement.hpp:1318
  logic [2:0] select_2068;
  assign select_2068 = and_2053 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1323
  logic and_2070;
  assign and_2070 = and_2066 & (select_2068 == 3'h0);
  logic less_2071;
  assign less_2071 = select_2061 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:443
  logic and_2072;
  assign and_2072 = and_2070 & less_2071;
  logic and_2073;
  assign and_2073 = and_1981_s2_q & and_2072;
  // hls/stages/agreement.hpp:279
  logic select_2075;
  assign select_2075 = and_1981_s2_q ? (left_first_s2_q ? and_2072 : and_2073) : and_2073;
  // hls/stages/agreement.hpp:1126
  logic select_2077;
  assign select_2077 = draws_late_q ? read_half_q : write_half_q;
  logic [7:0] sum_2078;
  assign sum_2078 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2078[7], sum_2078, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1276
  logic [11:0] sum_2080;
  assign sum_2080 = {1'b0, {2{select_2077}}, 2'h0, {2{select_2077}}, 1'b0, {2{select_2077}}, 1'b0, select_2077} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1043
  logic and_2081;
  assign and_2081 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2082;
  assign and_2082 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2083;
  assign and_2083 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2084;
  assign and_2084 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1101
  logic [1:0] sum_2086;
  assign sum_2086 = {1'b0, and_2083} + ({1'b0, textured} + {1'b0, and_2084});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2081} + ({2'h0, and_2082} + {1'b0, sum_2086});
  // hls/stages/agreement.hpp:1043
  logic [7:0] select_2095;
  assign select_2095 = inside_v_s2_q ? (sum_2002_s2_q ? select_1989 : {select_1989[6:0], 1'b0}) : select_1989;
  // hls/stages/agreement.hpp:1064
  logic or_2098;
  assign or_2098 = select_2095[7] | (~({select_2095[5], select_2095[3], select_2095[1]} == 3'h0));
  // hls/stages/agreement.hpp:1043
  logic and_2115;
  assign and_2115 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2116;
  assign and_2116 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2117;
  assign and_2117 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2118;
  assign and_2118 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1103
  logic [1:0] sum_2120;
  assign sum_2120 = {1'b0, and_2117} + ({1'b0, shown} + {1'b0, and_2118});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2115} + ({2'h0, and_2116} + {1'b0, sum_2120});
  // hls/stages/agreement.hpp:1043
  logic and_2131;
  assign and_2131 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2132;
  assign and_2132 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2133;
  assign and_2133 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2134;
  assign and_2134 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1104
  logic [1:0] sum_2136;
  assign sum_2136 = {1'b0, and_2133} + ({1'b0, near} + {1'b0, and_2134});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2131} + ({2'h0, and_2132} + {1'b0, sum_2136});
  // hls/stages/agreement.hpp:1125
  logic not_2147;
  assign not_2147 = ~(x_s2_q[7:2] == 6'h0);
  // hls/stages/agreement.hpp:1126
  logic not_2149;
  assign not_2149 = ~({1'b0, sum_1660, last_s2_q[1:0]} < x_s2_q);
  // hls/stages/agreement.hpp:798
  logic select_2153;
  assign select_2153 = less_2145_s2_q ? (not_2147 & not_2149) : ((draws_late_q & not_2147) & not_2149);
  logic and_2156;
  assign and_2156 = not_584_s2_q & (drew_q & (ends_cell_s2_q & select_2153));
  // hls/stages/agreement.hpp:277
  logic [10:0] select_2190;
  assign select_2190 = sample_pair_whole_s2_q ? (and_554_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2192;
  assign select_2192 = sample_pair_whole_s2_q ? (and_554_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2212;
  assign select_2212 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2214;
  assign select_2214 = sample_pair_whole_s2_q ? (and_554_s2_q ? select_569 : averager_mask_q) : averager_mask_q;
  logic select_2216;
  assign select_2216 = sample_pair_whole_s2_q ? (and_554_s2_q ? select_573 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:530
  logic [8:0] select_2217;
  assign select_2217 = and_556_s2_q ? select_562 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2218;
  assign select_2218 = and_556_s2_q ? select_566 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2220;
  assign select_2220 = and_556_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2221;
  assign select_2221 = and_556_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2222;
  assign select_2222 = and_556_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2223;
  assign select_2223 = and_556_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2224;
  assign select_2224 = and_556_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2225;
  assign select_2225 = and_556_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2226;
  assign select_2226 = and_556_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2227;
  assign select_2227 = and_556_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2228;
  assign select_2228 = and_556_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2229;
  assign select_2229 = and_556_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2230;
  assign select_2230 = and_556_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2231;
  assign select_2231 = and_556_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2232;
  assign select_2232 = and_556_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2233;
  assign select_2233 = and_556_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2234;
  assign select_2234 = and_556_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2235;
  assign select_2235 = and_556_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2236;
  assign select_2236 = and_556_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2237;
  assign select_2237 = and_556_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2238;
  assign select_2238 = and_556_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2239;
  assign select_2239 = and_556_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2240;
  assign select_2240 = and_556_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2241;
  assign select_2241 = and_556_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2242;
  assign select_2242 = and_556_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2243;
  assign select_2243 = and_556_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2244;
  assign select_2244 = and_556_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2245;
  assign select_2245 = and_556_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2246;
  assign select_2246 = and_556_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2247;
  assign select_2247 = and_556_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2248;
  assign select_2248 = and_556_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2249;
  assign select_2249 = and_556_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2250;
  assign select_2250 = and_556_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2251;
  assign select_2251 = and_556_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2252;
  assign select_2252 = and_556_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2253;
  assign select_2253 = and_556_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2254;
  assign select_2254 = and_556_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2255;
  assign select_2255 = and_556_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2256;
  assign select_2256 = and_556_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2257;
  assign select_2257 = and_556_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2258;
  assign select_2258 = and_556_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2259;
  assign select_2259 = and_556_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2260;
  assign select_2260 = and_556_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2261;
  assign select_2261 = and_556_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2262;
  assign select_2262 = and_556_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2263;
  assign select_2263 = and_556_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2264;
  assign select_2264 = and_556_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2265;
  assign select_2265 = and_556_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2266;
  assign select_2266 = and_556_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2267;
  assign select_2267 = and_556_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2268;
  assign select_2268 = and_556_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2269;
  assign select_2269 = and_556_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2270;
  assign select_2270 = and_556_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2271;
  assign select_2271 = and_556_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2272;
  assign select_2272 = and_556_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:286
  logic [9:0] difference_2274;
  assign difference_2274 = {1'b0, select_566} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2275;
  assign xor_2275 = difference_2274[8:0] ^ {9{difference_2274[9]}};
  logic [9:0] sum_2276;
  assign sum_2276 = {9'h0, difference_2274[9]} + {1'b0, xor_2275};
  logic [9:0] difference_2277;
  assign difference_2277 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2278;
  assign xor_2278 = difference_2277[8:0] ^ {9{difference_2277[9]}};
  logic [9:0] sum_2279;
  assign sum_2279 = {9'h0, difference_2277[9]} + {1'b0, xor_2278};
  logic [9:0] difference_2281;
  assign difference_2281 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2282;
  assign xor_2282 = difference_2281[8:0] ^ {9{difference_2281[9]}};
  logic [9:0] sum_2283;
  assign sum_2283 = {9'h0, difference_2281[9]} + {1'b0, xor_2282};
  logic [10:0] sum_2284;
  assign sum_2284 = ({1'b0, sum_2276} + {1'b0, sum_2279}) + {1'b0, sum_2283};
  logic [9:0] difference_2285;
  assign difference_2285 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2286;
  assign xor_2286 = difference_2285[8:0] ^ {9{difference_2285[9]}};
  logic [9:0] sum_2287;
  assign sum_2287 = {9'h0, difference_2285[9]} + {1'b0, xor_2286};
  logic [9:0] difference_2289;
  assign difference_2289 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2290;
  assign xor_2290 = difference_2289[8:0] ^ {9{difference_2289[9]}};
  // hls/stages/moments.hpp:65
  logic [13:0] sum_2311;
  assign sum_2311 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2313;
  assign sum_2313 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/moments.hpp:153
  logic [13:0] select_2315;
  assign select_2315 = equal_2314_s2_q ? moments_other_field_before_0_q : moments_before_0_q;
  logic [13:0] select_2317;
  assign select_2317 = equal_2314_s2_q ? moments_other_field_before_1_q : moments_before_1_q;
  logic select_2319;
  assign select_2319 = equal_2314_s2_q ? moments_other_field_has_before_q : moments_has_before_q;
  // hls/stages/agreement.hpp:798
  logic [13:0] select_2323;
  assign select_2323 = equal_583_s2_q ? ((select_2317 < select_2315) ? select_2315 : select_2317) : moments_most_before_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2324;
  assign sum_2324 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2327;
  assign select_2327 = equal_583_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2324)) : moments_left_begins_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2328;
  assign sum_2328 = {1'b0, sum_2313} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2331;
  assign select_2331 = equal_583_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2328)) : moments_left_alone_q;
  logic select_2334;
  assign select_2334 = equal_583_s2_q ? (~({3'h0, select_2317[13:2]} < sum_2328)) : moments_left_other_stops_q;
  logic select_2337;
  assign select_2337 = equal_583_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2324)) : moments_right_begins_q;
  // hls/stages/moments.hpp:153
  logic [14:0] sum_2338;
  assign sum_2338 = {1'b0, sum_2311} + 15'h3;
  // hls/stages/agreement.hpp:798
  logic select_2341;
  assign select_2341 = equal_583_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2338)) : moments_right_alone_q;
  logic select_2344;
  assign select_2344 = equal_583_s2_q ? (~({3'h0, select_2315[13:2]} < sum_2338)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:55
  logic out_of_step;
  assign out_of_step = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/moments.hpp:59
  logic select_2348;
  assign select_2348 = moments_ended_q ? moments_other_field_out_of_step_q : out_of_step;
  // hls/stages/agreement.hpp:798
  logic and_2356;
  assign and_2356 = not_584_s2_q & (not_586_s2_q & (equal_587_s2_q & (inside_v_s2_q & and_1610)));
  logic and_2360;
  assign and_2360 = not_584_s2_q & (not_586_s2_q & (equal_587_s2_q & (inside_v_s2_q & and_1619)));
  // hls/stages/moments.hpp:106
  logic and_2362;
  assign and_2362 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2365;
  assign select_2365 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2362)) : and_2362;
  // hls/stages/moments.hpp:153
  logic and_2368;
  assign and_2368 = equal_2314_s2_q & (cfg_prove_i & (cfg_same_table_i & select_2365));
  // hls/stages/moments.hpp:107
  logic and_2372;
  assign and_2372 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/agreement.hpp:798
  logic [13:0] select_2377;
  assign select_2377 = equal_583_s2_q ? (equal_2314_s2_q ? sum_2311 : moments_other_field_before_0_q) : moments_other_field_before_0_q;
  logic [13:0] select_2379;
  assign select_2379 = equal_583_s2_q ? (equal_2314_s2_q ? sum_2313 : moments_other_field_before_1_q) : moments_other_field_before_1_q;
  logic select_2381;
  assign select_2381 = equal_583_s2_q ? (moments_other_field_has_before_q | equal_2314_s2_q) : moments_other_field_has_before_q;
  // hls/stages/moments.hpp:61
  logic select_2382;
  assign select_2382 = moments_ended_q ? out_of_step : moments_other_field_out_of_step_q;
  // hls/stages/census.hpp:371
  logic [9:0] difference_2396;
  assign difference_2396 = {1'b0, select_562} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2396[9]} + (difference_2396[8:0] ^ {9{difference_2396[9]}});
  logic [9:0] difference_2408;
  assign difference_2408 = {1'b0, select_566} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2408[9]} + (difference_2408[8:0] ^ {9{difference_2408[9]}});
  // hls/stages/agreement.hpp:530
  logic select_2607;
  assign select_2607 = and_556_s2_q ? (equal_2499_s2_q ? and_2605_s2_q : draws_late_q) : draws_late_q;
  // hls/stages/agreement.hpp:240
  logic [5:0] select_2609;
  assign select_2609 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2610;
  assign select_2610 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2611;
  assign select_2611 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2612;
  assign select_2612 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2613;
  assign select_2613 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2614;
  assign select_2614 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2618;
  assign select_2618 = slot_s2_q[0] ? 8'h0 : sum_1024;
  // hls/stages/agreement.hpp:761
  logic less_2619;
  assign less_2619 = select_2618 < select_1524;
  // hls/stages/agreement.hpp:240
  logic [6:0] select_2621;
  assign select_2621 = slot_s2_q[0] ? 7'h0 : sum_1550;
  // hls/stages/agreement.hpp:798
  logic not_2626;
  assign not_2626 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2627;
  assign less_2627 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:530
  logic and_2634;
  assign and_2634 = and_556_s2_q & (equal_691_s2_q & equal_2499_s2_q);
  // hls/stages/agreement.hpp:798
  logic and_2639;
  assign and_2639 = ends_cell_s2_q & (inside_v_s2_q & (and_2636_s2_q & not_2012_s2_q));
  // hls/stages/agreement.hpp:1043
  logic and_2663;
  assign and_2663 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2664;
  assign and_2664 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2665;
  assign and_2665 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2666;
  assign and_2666 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1102
  logic [1:0] sum_2668;
  assign sum_2668 = {1'b0, and_2665} + ({1'b0, explained} + {1'b0, and_2666});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2663} + ({2'h0, and_2664} + {1'b0, sum_2668});
  // hls/stages/agreement.hpp:798
  logic and_2704;
  assign and_2704 = ends_cell_s2_q & (inside_v_s2_q & (not_2012_s2_q & (and_2636_s2_q & and_2028)));
  // hls/stages/agreement.hpp:996
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:997
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:998
  logic [7:0] difference_2729;
  assign difference_2729 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2732;
  assign less_2732 = {2'h0, difference_2729[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:248
  logic and_2735;
  assign and_2735 = not_592_s2_q & (((and_2026_s2_q & and_641) & equal_2725_s2_q) & (~less_2732));
  // hls/stages/agreement.hpp:798
  logic and_2739;
  assign and_2739 = ends_cell_s2_q & (inside_v_s2_q & ((or_588_s2_q & and_2735) & not_2012_s2_q));
  // hls/stages/agreement.hpp:150
  logic and_2745;
  assign and_2745 = not_592_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:248
  logic and_2747;
  assign and_2747 = not_592_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2748;
  assign select_2748 = or_588_s2_q ? {and_2747, and_2745} : 2'h0;
  // hls/stages/agreement.hpp:248
  logic [1:0] select_2750;
  assign select_2750 = less_591_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:150
  logic [1:0] select_2751;
  assign select_2751 = or_588_s2_q ? select_2750 : 2'h0;
  // hls/stages/agreement.hpp:1040
  logic and_2753;
  assign and_2753 = and_643 & (select_2748[0] & select_2751[0]);
  // hls/stages/agreement.hpp:798
  logic and_2757;
  assign and_2757 = ends_cell_s2_q & (inside_v_s2_q & (not_2012_s2_q & (select_2748[1] & and_2753)));
  logic and_2759;
  assign and_2759 = not_584_s2_q & (drew_q & and_2757);
  logic and_2765;
  assign and_2765 = ends_cell_s2_q & (inside_v_s2_q & (not_2012_s2_q & (select_2751[1] & and_2753)));
  logic and_2767;
  assign and_2767 = not_584_s2_q & (drew_q & and_2765);
  // hls/stages/registration.hpp:76
  logic less_2770;
  assign less_2770 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:150
  logic [7:0] select_2772;
  assign select_2772 = or_588_s2_q ? (less_591_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2774;
  assign select_2774 = or_588_s2_q ? (less_591_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2776;
  assign select_2776 = or_588_s2_q ? (less_591_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2774} - {1'b0, select_2776};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2778;
  assign select_2778 = rise_2[8] ? select_2774 : select_2776;
  logic [8:0] fall;
  assign fall = {1'b0, select_2772} - {1'b0, select_2778};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2781;
  assign not_2781 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2770 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2781};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2783;
  assign xor_2783 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2783};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2789;
  assign select_2789 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2770 ? {taken, 1'b1} : {not_2781, select_2789, not_2781};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2791;
  assign sum_2791 = {left, 1'b1} + {taken_2, less_2770};
  // hls/stages/agreement.hpp:258
  logic [4:0] select_2793;
  assign select_2793 = drew_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_2795;
  assign select_2795 = equal_583_s2_q ? registration_slope_here_q : (drew_q ? slope : registration_slope_here_q);
  logic [10:0] select_2797;
  assign select_2797 = equal_583_s2_q ? registration_expected_q : (drew_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2798;
  assign equal_2798 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:263
  logic and_2802;
  assign and_2802 = and_643 & less_1712_s2_q;
  // hls/stages/agreement.hpp:150
  logic [2:0] select_2804;
  assign select_2804 = or_588_s2_q ? (less_591_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2808;
  assign sum_2808 = select_2804[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2811;
  assign select_2811 = (select_2774 < select_2776) ? ({sum_2808, select_2804[0], 5'h0} - {3'h0, select_2793}) : {sum_2808, select_2804[0], select_2793};
  logic [7:0] select_2812;
  assign select_2812 = ((select_2804 == 3'h0) | (select_2804 == 3'h4)) ? {sum_2808, select_2804[0], 5'h0} : select_2811;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2812[7]}}, select_2812} - {sum_1731[9], sum_1731, sum_1727[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2815;
  assign select_2815 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2815[11:7])) ? 12'h7f : select_2815;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2836;
  assign difference_2836 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2838;
  assign and_2838 = and_2802 & ($signed(difference_2836) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2851;
  assign less_2851 = $signed(difference_2836) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:798
  logic select_2859;
  assign select_2859 = drew_q ? (equal_2798 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2862;
  assign select_2862 = drew_q ? (equal_1713 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2867;
  assign select_2867 = (sum_1626 == 2'h2) ? (registration_fresh_q & (~select_1673)) : registration_fresh_q;
  // hls/stages/agreement.hpp:798
  logic [3:0] select_2869;
  assign select_2869 = drew_q ? (and_1668 ? select_2867 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2871;
  assign select_2871 = and_2634 ? 4'hf : (equal_583_s2_q ? registration_fresh_q : select_2869);
  // hls/stages/agreement.hpp:1144
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1623;
  // hls/stages/registration.hpp:258
  logic not_2891;
  assign not_2891 = ~quarter_2[1];
  logic [3:0] select_2892;
  assign select_2892 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2891, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2891};
  // hls/stages/patches.hpp:91
  logic parity_3026;
  assign parity_3026 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:465
  logic [15:0] select_3027;
  assign select_3027 = equal_2499_s2_q ? {patches_chance_q[14:0], parity_3026} : patches_chance_q;
  // hls/stages/patches.hpp:349
  logic not_3029;
  assign not_3029 = ~and_1787;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_3031;
  assign select_3031 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_3031};
  // hls/stages/agreement.hpp:798
  logic and_3037;
  assign and_3037 = drew_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:157
  logic and_3041;
  assign and_3041 = not_3029 & (patches_fixed_q | ((not_584_s2_q & and_3037) & and_1759));
  // hls/stages/patches.hpp:358
  logic not_3053;
  assign not_3053 = ~select_1702[1];
  // hls/stages/agreement.hpp:277
  logic [1:0] select_3055;
  assign select_3055 = sample_pair_whole_s2_q ? (equal_1703 ? select_1702 : {not_3053, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:526
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/agreement.hpp:276
  logic [51:0] select_3154;
  assign select_3154 = or_1795_s2_q ? {and_1940_s2_q, and_1937_s2_q, and_1921_s2_q, and_1918, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3156;
  assign select_3156 = equal_1789_s2_q ? patches_codes_at_q : (equal_1791_s2_q ? other[55:4] : select_3154);
  // hls/stages/patches.hpp:509
  logic [27:0] word;
  assign word = or_1894_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:525
  logic [27:0] select_3159;
  assign select_3159 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/agreement.hpp:276
  logic [27:0] select_3161;
  assign select_3161 = equal_1791_s2_q ? (new_row_s2_q ? word : select_3159) : patches_codes_further_q;
  // hls/stages/patches.hpp:527
  logic [55:0] select_3163;
  assign select_3163 = less_1881_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:497
  logic [55:0] select_3165;
  assign select_3165 = less_3164_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/agreement.hpp:276
  logic [55:0] select_3167;
  assign select_3167 = or_1795_s2_q ? (equal_1794_s2_q ? patches_next_codes_q : select_3165) : patches_next_codes_q;
  logic [55:0] select_3169;
  assign select_3169 = equal_1789_s2_q ? patches_next_codes_q : (equal_1791_s2_q ? select_3163 : select_3167);
  // hls/stages/count_bits.hpp:24
  logic parity_3174;
  assign parity_3174 = ^{and_1940_s2_q, and_1937_s2_q, and_1921_s2_q, and_1918};
  // hls/stages/count_bits.hpp:25
  logic or_3178;
  assign or_3178 = ({and_1921_s2_q, and_1918} == 2'h3) | (and_1937_s2_q & (and_1921_s2_q | and_1918));
  logic and_3179;
  assign and_3179 = and_1940_s2_q & (^{and_1937_s2_q, and_1921_s2_q, and_1918});
  // hls/stages/count_bits.hpp:24
  logic xor_3180;
  assign xor_3180 = or_3178 ^ and_3179;
  // hls/stages/count_bits.hpp:27
  logic and_3181;
  assign and_3181 = or_3178 & and_3179;
  // hls/stages/agreement.hpp:276
  logic [2:0] select_3183;
  assign select_3183 = or_1795_s2_q ? (and_1963_s2_q ? {and_3181, xor_3180, parity_3174} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:168
  logic [9:0] sum_3187;
  assign sum_3187 = {7'h0, patches_set_q} + (equal_1794_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:526
  logic [47:0] select_3197;
  assign select_3197 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/agreement.hpp:276
  logic [47:0] select_3199;
  assign select_3199 = equal_1789_s2_q ? patches_left_row_q : (equal_1791_s2_q ? select_3197 : patches_left_row_q);
  // hls/stages/patches.hpp:528
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3197;
  // hls/stages/count_bits.hpp:24
  logic xor_3203;
  assign xor_3203 = bits[17] ^ (^{select_3197[16:15], other[16:15]});
  logic xor_3206;
  assign xor_3206 = bits[11] ^ (^{select_3197[10:9], other[10:9]});
  logic xor_3209;
  assign xor_3209 = bits[14] ^ (^{select_3197[13:12], other[13:12]});
  logic xor_3212;
  assign xor_3212 = xor_3203 ^ (^{select_3197[14:9], other[14:9]});
  logic xor_3215;
  assign xor_3215 = bits[47] ^ (^{select_3197[46:45], other[46:45]});
  logic xor_3218;
  assign xor_3218 = bits[8] ^ (^{select_3197[7:6], other[7:6]});
  logic xor_3221;
  assign xor_3221 = bits[2] ^ (^{select_3197[1:0], other[1:0]});
  logic xor_3224;
  assign xor_3224 = bits[5] ^ (^{select_3197[4:3], other[4:3]});
  logic xor_3227;
  assign xor_3227 = xor_3218 ^ (^{select_3197[5:0], other[5:0]});
  logic parity_3229;
  assign parity_3229 = ^{select_3197[47:45], select_3197[8:0], other[47:45], other[8:0]};
  logic xor_3230;
  assign xor_3230 = xor_3212 ^ parity_3229;
  logic xor_3233;
  assign xor_3233 = bits[44] ^ (^{select_3197[43:42], other[43:42]});
  logic xor_3236;
  assign xor_3236 = bits[38] ^ (^{select_3197[37:36], other[37:36]});
  logic xor_3239;
  assign xor_3239 = bits[41] ^ (^{select_3197[40:39], other[40:39]});
  logic xor_3245;
  assign xor_3245 = bits[26] ^ (^{select_3197[25:24], other[25:24]});
  logic xor_3248;
  assign xor_3248 = bits[20] ^ (^{select_3197[19:18], other[19:18]});
  logic xor_3251;
  assign xor_3251 = bits[23] ^ (^{select_3197[22:21], other[22:21]});
  logic xor_3254;
  assign xor_3254 = xor_3245 ^ (^{select_3197[23:18], other[23:18]});
  logic xor_3257;
  assign xor_3257 = bits[35] ^ (^{select_3197[34:33], other[34:33]});
  logic xor_3260;
  assign xor_3260 = bits[29] ^ (^{select_3197[28:27], other[28:27]});
  logic xor_3263;
  assign xor_3263 = bits[32] ^ (^{select_3197[31:30], other[31:30]});
  logic xor_3266;
  assign xor_3266 = xor_3257 ^ (^{select_3197[32:27], other[32:27]});
  logic xor_3267;
  assign xor_3267 = xor_3254 ^ xor_3266;
  // hls/stages/count_bits.hpp:25
  logic or_3275;
  assign or_3275 = (xor_3206 & xor_3209) | (xor_3203 & (xor_3206 | xor_3209));
  logic or_3279;
  assign or_3279 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3283;
  assign or_3283 = (xor_3221 & xor_3224) | (xor_3218 & (xor_3221 | xor_3224));
  // hls/stages/count_bits.hpp:23
  logic or_3290;
  assign or_3290 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3294;
  assign or_3294 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3298;
  assign or_3298 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3301;
  assign parity_3301 = ^{or_3298, or_3294, or_3290};
  // hls/stages/count_bits.hpp:23
  logic or_3305;
  assign or_3305 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3309;
  assign or_3309 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3313;
  assign or_3313 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3316;
  assign parity_3316 = ^{or_3313, or_3309, or_3305};
  logic parity_3319;
  assign parity_3319 = ^{or_3313, or_3309, or_3305, or_3298, or_3294, or_3290, or_3283, or_3279, or_3275};
  // hls/stages/count_bits.hpp:23
  logic or_3323;
  assign or_3323 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3327;
  assign or_3327 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3331;
  assign or_3331 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3339;
  assign or_3339 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3343;
  assign or_3343 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3347;
  assign or_3347 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3350;
  assign parity_3350 = ^{or_3347, or_3343, or_3339};
  // hls/stages/count_bits.hpp:23
  logic or_3354;
  assign or_3354 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3358;
  assign or_3358 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3362;
  assign or_3362 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3365;
  assign parity_3365 = ^{or_3362, or_3358, or_3354};
  logic parity_3368;
  assign parity_3368 = ^{or_3362, or_3358, or_3354, or_3347, or_3343, or_3339, or_3331, or_3327, or_3323};
  // hls/stages/count_bits.hpp:25
  logic or_3372;
  assign or_3372 = (xor_3236 & xor_3239) | (xor_3233 & (xor_3236 | xor_3239));
  logic or_3376;
  assign or_3376 = (xor_3248 & xor_3251) | (xor_3245 & (xor_3248 | xor_3251));
  logic or_3380;
  assign or_3380 = (xor_3260 & xor_3263) | (xor_3257 & (xor_3260 | xor_3263));
  // hls/stages/count_bits.hpp:24
  logic parity_3383;
  assign parity_3383 = ^{or_3380, or_3376, or_3372};
  // hls/stages/count_bits.hpp:25
  logic and_3384;
  assign and_3384 = xor_3230 & (^{xor_3267, select_3197[44:36], other[44:36]});
  logic or_3388;
  assign or_3388 = (xor_3215 & xor_3227) | (xor_3212 & (xor_3215 | xor_3227));
  logic and_3391;
  assign and_3391 = (xor_3233 ^ (^{select_3197[41:36], other[41:36]})) & (xor_3254 | xor_3266);
  logic or_3392;
  assign or_3392 = (xor_3254 & xor_3266) | and_3391;
  // hls/stages/count_bits.hpp:24
  logic parity_3395;
  assign parity_3395 = ^{or_3392, or_3388, and_3384};
  logic parity_3398;
  assign parity_3398 = ^{or_3392, or_3388, and_3384, or_3380, or_3376, or_3372, or_3362, or_3358, or_3354, or_3347, or_3343, or_3339, or_3331, or_3327, or_3323};
  logic parity_3400;
  assign parity_3400 = ^{or_3392, or_3388, and_3384, or_3380, or_3376, or_3372, or_3362, or_3358, or_3354, or_3347, or_3343, or_3339, or_3331, or_3327, or_3323, or_3313, or_3309, or_3305, or_3298, or_3294, or_3290, or_3283, or_3279, or_3275};
  // hls/stages/count_bits.hpp:25
  logic and_3401;
  assign and_3401 = parity_3319 & parity_3398;
  logic or_3405;
  assign or_3405 = (parity_3301 & parity_3316) | ((^{or_3283, or_3279, or_3275}) & (parity_3301 | parity_3316));
  logic or_3409;
  assign or_3409 = (parity_3383 & parity_3395) | (parity_3368 & (parity_3383 | parity_3395));
  logic or_3416;
  assign or_3416 = (parity_3350 & parity_3365) | ((^{or_3331, or_3327, or_3323}) & (parity_3350 | parity_3365));
  logic or_3420;
  assign or_3420 = (or_3376 & or_3380) | (or_3372 & (or_3376 | or_3380));
  logic or_3424;
  assign or_3424 = (or_3388 & or_3392) | (and_3384 & (or_3388 | or_3392));
  // hls/stages/count_bits.hpp:23
  logic or_3431;
  assign or_3431 = (or_3327 & or_3331) | (or_3323 & (or_3327 | or_3331));
  // hls/stages/count_bits.hpp:25
  logic or_3435;
  assign or_3435 = (or_3343 & or_3347) | (or_3339 & (or_3343 | or_3347));
  logic or_3439;
  assign or_3439 = (or_3358 & or_3362) | (or_3354 & (or_3358 | or_3362));
  // hls/stages/count_bits.hpp:24
  logic parity_3442;
  assign parity_3442 = ^{or_3439, or_3435, or_3431};
  // hls/stages/count_bits.hpp:23
  logic or_3446;
  assign or_3446 = (or_3279 & or_3283) | (or_3275 & (or_3279 | or_3283));
  // hls/stages/count_bits.hpp:25
  logic or_3450;
  assign or_3450 = (or_3294 & or_3298) | (or_3290 & (or_3294 | or_3298));
  logic or_3454;
  assign or_3454 = (or_3309 & or_3313) | (or_3305 & (or_3309 | or_3313));
  // hls/stages/count_bits.hpp:24
  logic parity_3457;
  assign parity_3457 = ^{or_3454, or_3450, or_3446};
  logic parity_3460;
  assign parity_3460 = ^{or_3454, or_3450, or_3446, or_3439, or_3435, or_3431, or_3424, or_3420, or_3416};
  logic parity_3462;
  assign parity_3462 = ^{or_3454, or_3450, or_3446, or_3439, or_3435, or_3431, or_3424, or_3420, or_3416, or_3409, or_3405, and_3401};
  // hls/stages/count_bits.hpp:25
  logic or_3466;
  assign or_3466 = (or_3420 & or_3424) | (or_3416 & (or_3420 | or_3424));
  logic or_3470;
  assign or_3470 = (or_3435 & or_3439) | (or_3431 & (or_3435 | or_3439));
  logic or_3474;
  assign or_3474 = (or_3450 & or_3454) | (or_3446 & (or_3450 | or_3454));
  // hls/stages/count_bits.hpp:24
  logic parity_3477;
  assign parity_3477 = ^{or_3474, or_3470, or_3466};
  // hls/stages/count_bits.hpp:25
  logic and_3478;
  assign and_3478 = (^{or_3409, or_3405, and_3401}) & parity_3460;
  logic or_3482;
  assign or_3482 = (or_3405 & or_3409) | (and_3401 & (or_3405 | or_3409));
  logic or_3486;
  assign or_3486 = (parity_3442 & parity_3457) | ((^{or_3424, or_3420, or_3416}) & (parity_3442 | parity_3457));
  // hls/stages/count_bits.hpp:24
  logic parity_3489;
  assign parity_3489 = ^{or_3486, or_3482, and_3478};
  // hls/stages/count_bits.hpp:25
  logic and_3491;
  assign and_3491 = parity_3477 & parity_3489;
  logic or_3495;
  assign or_3495 = (or_3470 & or_3474) | (or_3466 & (or_3470 | or_3474));
  logic or_3499;
  assign or_3499 = (or_3482 & or_3486) | (and_3478 & (or_3482 | or_3486));
  // hls/stages/agreement.hpp:276
  logic [4:0] select_3544;
  assign select_3544 = equal_1791_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3547;
  assign select_3547 = equal_1789_s2_q ? patches_summed_first_q : (equal_1791_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:559
  logic [9:0] select_3555;
  assign select_3555 = less_1969_s2_q ? (or_1972_s2_q ? patches_rows_rdata_q[9:0] : 10'h0) : 10'h0;
  logic [4:0] select_3558;
  assign select_3558 = less_1969_s2_q ? (or_1972_s2_q ? patches_rows_rdata_q[14:10] : 5'h0) : 5'h0;
  logic [4:0] select_3561;
  assign select_3561 = less_1969_s2_q ? (or_1972_s2_q ? patches_step_s2_q : 5'h0) : 5'h0;
  // hls/stages/agreement.hpp:276
  logic select_3566;
  assign select_3566 = equal_1789_s2_q ? (less_1969_s2_q & (or_1972_s2_q & (patches_step_s2_q == 5'h0))) : patches_read_first_q;
  // hls/stages/patches.hpp:180
  logic or_3571;
  assign or_3571 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3572;
  assign and_3572 = patches_read_searches_s2_q & or_3571;
  // hls/stages/patches.hpp:543
  logic [4:0] select_3573;
  assign select_3573 = and_3572 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:550
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3573};
  // hls/stages/patches.hpp:559
  logic and_3578;
  assign and_3578 = less_1969_s2_q & (or_1972_s2_q & (equal_1970_s2_q & (away == 6'h3f)));
  logic and_3583;
  assign and_3583 = less_1969_s2_q & (or_1972_s2_q & (equal_1970_s2_q & (away == 6'h1)));
  // hls/stages/patches.hpp:556
  logic [6:0] sum_3585;
  assign sum_3585 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:557
  logic [9:0] select_3588;
  assign select_3588 = (equal_1970_s2_q & ({sum_3585[6], sum_3585} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:559
  logic [9:0] select_3590;
  assign select_3590 = less_1969_s2_q ? (or_1972_s2_q ? select_3588 : 10'h3ff) : 10'h3ff;
  // hls/stages/patches.hpp:542
  logic [14:0] select_3592;
  assign select_3592 = and_3572 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3593;
  assign select_3593 = equal_1789_s2_q ? select_3592[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3594;
  assign select_3594 = equal_1789_s2_q ? select_3592[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:544
  logic [9:0] select_3596;
  assign select_3596 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3597;
  assign select_3597 = equal_1789_s2_q ? select_3596 : patches_peak_above_q;
  // hls/stages/patches.hpp:545
  logic [9:0] select_3598;
  assign select_3598 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3599;
  assign select_3599 = equal_1789_s2_q ? select_3598 : patches_peak_below_q;
  // hls/stages/patches.hpp:546
  logic [9:0] select_3601;
  assign select_3601 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3603;
  assign select_3603 = equal_1789_s2_q ? (patches_read_first_q ? patches_read_far_q : select_3601) : patches_peak_far_q;
  logic [9:0] select_3606;
  assign select_3606 = equal_1789_s2_q ? (equal_3604_s2_q ? sum_3187 : patches_peak_size_q) : patches_peak_size_q;
  // hls/stages/agreement.hpp:798
  logic select_3856;
  assign select_3856 = equal_583_s2_q ? shown_shown_q : (drew_q ? select_2041 : shown_shown_q);
  logic select_3858;
  assign select_3858 = equal_583_s2_q ? shown_nearer_q : (drew_q ? select_2044 : shown_nearer_q);
  // hls/stages/agreement.hpp:499
  logic [8:0] select_3861;
  assign select_3861 = equal_691_s2_q ? {{2{difference_3860[6]}}, difference_3860} : region_down_rest_q;
  // hls/stages/division.hpp:18
  logic [7:0] sum_3862;
  assign sum_3862 = select_3861[8:1] + 8'h3;
  // hls/stages/agreement.hpp:465
  logic [2:0] select_3865;
  assign select_3865 = less_3859_s2_q ? (sum_3862[7] ? region_row_q : next_region_row_q) : (and_2605_s2_q ? region_row_q : 3'h0);
  // hls/stages/agreement.hpp:530
  logic [2:0] select_3867;
  assign select_3867 = and_556_s2_q ? (equal_2499_s2_q ? select_3865 : region_row_q) : region_row_q;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3871;
  assign select_3871 = equal_583_s2_q ? select_1989 : (drew_q ? (ends_cell_s2_q ? select_2095 : select_1989) : 8'h1);
  // hls/stages/agreement.hpp:465
  logic [8:0] select_3884;
  assign select_3884 = equal_2499_s2_q ? (less_3859_s2_q ? region_down_next_q : select_3861) : region_down_rest_q;
  // hls/stages/agreement.hpp:499
  logic [6:0] select_3887;
  assign select_3887 = equal_691_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:530
  logic [6:0] select_3889;
  assign select_3889 = and_556_s2_q ? (equal_2499_s2_q ? select_3887 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:34
  logic [7:0] sum_3890;
  assign sum_3890 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3891;
  assign sum_3891 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3892;
  assign select_3892 = sum_3890[7] ? {1'b1, sum_3890[6:0], region_down_rest_q[0]} : sum_3891;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3862[7];
  // hls/stages/agreement.hpp:465
  logic select_3896;
  assign select_3896 = equal_2499_s2_q ? (less_3859_s2_q ? next : (region_fresh_q | equal_691_s2_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:206
  logic or_3901;
  assign or_3901 = segment_starts_q | not_586_s2_q;
  // hls/stages/agreement.hpp:1043
  logic select_3904;
  assign select_3904 = inside_v_s2_q ? (sum_2002_s2_q ? (equal_1782 & or_2004) : or_2004) : or_3901;
  // hls/stages/agreement.hpp:798
  logic select_3907;
  assign select_3907 = equal_583_s2_q ? or_3901 : (drew_q ? (ends_cell_s2_q ? select_3904 : or_3901) : or_3901);
  logic select_4067;
  assign select_4067 = drew_q ? (ends_cell_s2_q ? and_2083 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4070;
  assign select_4070 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4072;
  assign select_4072 = equal_583_s2_q ? centres_values_0_of_skin_q : (drew_q ? select_4070 : centres_values_0_of_skin_q);
  logic select_4073;
  assign select_4073 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4075;
  assign select_4075 = equal_583_s2_q ? centres_values_1_textured_q : (drew_q ? select_4073 : centres_values_1_textured_q);
  logic select_4076;
  assign select_4076 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4078;
  assign select_4078 = equal_583_s2_q ? centres_values_1_of_skin_q : (drew_q ? select_4076 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:465
  logic [10:0] select_4084;
  assign select_4084 = equal_2499_s2_q ? (or_4081_s2_q ? (map_row_q + {5'h0, map_width_q}) : 11'h0) : map_row_q;
  // hls/stages/agreement.hpp:530
  logic [5:0] select_4087;
  assign select_4087 = and_556_s2_q ? (equal_2499_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1286
  logic xor_4088;
  assign xor_4088 = write_half_q ^ done_s2_q;
  // hls/stages/agreement.hpp:443
  logic select_4090;
  assign select_4090 = and_1981_s2_q ? (left_first_s2_q ? xor_4088 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:279
  logic select_4092;
  assign select_4092 = and_1981_s2_q ? (left_first_s2_q ? xor_4088 : select_4090) : write_half_q;
  logic select_4094;
  assign select_4094 = left_first_s2_q ? select_2047 : (and_1981_s2_q ? select_2048 : read_half_q);
  logic [9:0] select_4107;
  assign select_4107 = left_first_s2_q ? 10'h1 : (and_1981_s2_q ? select_2052 : rows_passed_q);
  logic [8:0] select_4110;
  assign select_4110 = left_first_s2_q ? {select_2050[7:0], or_2049} : (and_1981_s2_q ? {select_2050[7:0], or_2049} : columns_passed_q);
  logic select_4113;
  assign select_4113 = left_first_s2_q ? marks_last_s2_q : (and_1981_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4116;
  assign select_4116 = left_first_s2_q ? and_2066 : (and_1981_s2_q ? and_2066 : began_q);
  logic [2:0] select_4119;
  assign select_4119 = left_first_s2_q ? select_2068 : (and_1981_s2_q ? select_2068 : seen_x_q);
  // hls/stages/agreement.hpp:1316
  logic [2:0] select_4124;
  assign select_4124 = left_first_s2_q ? 3'h0 : (and_2053 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:279
  logic [2:0] select_4126;
  assign select_4126 = left_first_s2_q ? 3'h0 : (and_1981_s2_q ? select_4124 : seen_y_q);
  logic [7:0] select_4129;
  assign select_4129 = left_first_s2_q ? select_2061 : (and_1981_s2_q ? select_2061 : seen_column_q);
  // hls/stages/agreement.hpp:441
  logic [7:0] select_4135;
  assign select_4135 = left_first_s2_q ? select_4133 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:279
  logic [7:0] select_4137;
  assign select_4137 = left_first_s2_q ? select_4133 : (and_1981_s2_q ? select_4135 : seen_rows_left_q);
  // hls/stages/agreement.hpp:441
  logic and_4142;
  assign and_4142 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:279
  logic select_4144;
  assign select_4144 = left_first_s2_q ? and_4142 : (and_1981_s2_q ? and_4142 : at_cell_end_q);
  logic select_4147;
  assign select_4147 = left_first_s2_q ? next_row : (and_1981_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4150;
  assign select_4150 = left_first_s2_q ? 11'h0 : (and_1981_s2_q ? select_2058 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4224;
  assign not_4224 = ~quarter[1];
  logic [3:0] select_4225;
  assign select_4225 = quarter[0] ? {quarter[1], 1'b0, not_4224, 1'b0} : {1'b0, quarter[1], 1'b0, not_4224};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1627;
`ifndef SYNTHESIS
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1670;
`endif
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 23, DISTANCE 12, hls/stages/patches.hpp:777; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [22:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 23'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1701;
`ifndef SYNTHESIS
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1703));
`endif
  logic [22:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1415; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1999;
`ifndef SYNTHESIS
  logic regions_re;
  assign regions_re = s2_en & (equal_583_s2_q ? (x_s2_q[6] & not_2000) : and_2007);
`endif
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1426; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_2063;
`ifndef SYNTHESIS
  logic map_re;
  assign map_re = s2_en & select_2075;
`endif
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (en_i) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_521_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_530_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_549, and_545, sum_541, sum_537};
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
  assign census_memory_we = s2_en & and_556_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_574, whole_2, select_566, select_562};
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
  assign moments_memory_we = s2_en & and_599_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_658_s2_q, and_656_s2_q, and_650_s2_q, and_648};
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
  assign best_left_we = s2_en & and_1574_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1573, select_1570, select_1567, select_1565, select_1547, select_1544, select_1536, select_1535, select_1530};
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
  assign best_right_we = s2_en & and_1574_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1584, select_1583, select_1580, select_1579};
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
  assign shown_right_waddr = select_1591_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1602;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1599, not_586_s2_q};
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
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1610, and_1607};
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
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1619, and_1616};
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
  assign patches_right_codes_waddr = {sum_1902, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1954_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {and_1940_s2_q, and_1937_s2_q, and_1921_s2_q, and_1918, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1958, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1968_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {and_1940_s2_q, and_1937_s2_q, and_1921_s2_q, and_1918, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_1587_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2039, textured};
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
      averager_running_of_skin_q <= select_2212;
      averager_mask_q <= select_2214;
      averager_of_skin_q <= select_2216;
      census_filled_q <= and_556_s2_q ? {select_694[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2311;
      moments_turned_1_q <= sum_2313;
      moments_before_0_q <= equal_583_s2_q ? select_2315 : moments_before_0_q;
      moments_before_1_q <= equal_583_s2_q ? select_2317 : moments_before_1_q;
      moments_has_before_q <= equal_583_s2_q ? select_2319 : moments_has_before_q;
      moments_most_before_q <= select_2323;
      moments_left_begins_q <= select_2327;
      moments_left_alone_q <= select_2331;
      moments_left_other_stops_q <= select_2334;
      moments_right_begins_q <= select_2337;
      moments_right_alone_q <= select_2341;
      moments_right_other_stops_q <= select_2344;
      moments_out_of_step_q <= select_2348;
      moments_turns_0_q <= and_2356;
      moments_turns_1_q <= and_2360;
      moments_begins_alone_q <= equal_583_s2_q & and_2368;
      moments_ends_q <= equal_583_s2_q & (equal_2314_s2_q & (not_2370 | and_2372));
      moments_other_field_before_0_q <= select_2377;
      moments_other_field_before_1_q <= select_2379;
      moments_other_field_has_before_q <= select_2381;
      moments_other_field_out_of_step_q <= select_2382;
      moments_ended_q <= equal_583_s2_q & equal_2314_s2_q;
      rows_passed_above_q <= and_556_s2_q ? select_693 : rows_passed_above_q;
      draws_late_q <= select_2607;
      chosen_score_q <= less_2619 ? select_1524 : select_2618;
      chosen_near_q <= (select_2621 < select_1559) ? select_1559 : select_2621;
      chosen_place_q <= less_2619 ? {select_1532, not_1531} : 3'h2;
      before_0_q <= select_2618;
      before_1_q <= sum_1274;
      before_2_q <= sum_1522;
      shift_allowed_q <= not_2626 & (~less_2627);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2634 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2759});
      counts_turned_right_q <= and_2634 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2767});
      registration_displacement_over_q <= drew_q ? sum_2791[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2793;
      registration_slope_here_q <= select_2795;
      registration_expected_q <= select_2797;
      registration_of_right_q <= equal_583_s2_q ? registration_of_right_q : select_2859;
      registration_was_inside_q <= equal_583_s2_q ? registration_was_inside_q : select_2862;
      registration_fresh_q <= select_2871;
      patches_chance_q <= and_556_s2_q ? select_3027 : patches_chance_q;
      patches_fixed_q <= and_3041;
      patches_choice_valid_q <= and_1787 ? (select_1760 & not_3029) : select_1760;
      patches_choice_column_q <= select_1765;
      patches_choice_shift_q <= select_1770;
      patches_choice_slope_q <= select_1781;
      patches_band_q <= sample_pair_whole_s2_q ? select_1802 : patches_band_q;
      patches_fetch_q <= select_3055;
      patches_codes_at_q <= select_3156;
      patches_codes_further_q <= equal_1789_s2_q ? patches_codes_further_q : select_3161;
      patches_next_codes_q <= select_3169;
      patches_set_q <= equal_1789_s2_q ? 3'h0 : (equal_1791_s2_q ? 3'h0 : select_3183);
      patches_size_q <= sum_3187;
      patches_left_row_q <= select_3199;
      patches_summed_row_column_q <= equal_1789_s2_q ? patches_summed_row_column_q : select_3544;
      patches_summed_first_q <= select_3547;
      patches_read_row_differing_q <= equal_1789_s2_q ? select_3555 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1789_s2_q ? select_3558 : patches_read_row_column_q;
      patches_read_at_q <= equal_1789_s2_q ? select_3561 : patches_read_at_q;
      patches_read_first_q <= select_3566;
      patches_read_above_q <= equal_1789_s2_q ? and_3578 : patches_read_above_q;
      patches_read_below_q <= equal_1789_s2_q ? and_3583 : patches_read_below_q;
      patches_read_far_q <= equal_1789_s2_q ? select_3590 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3593;
      patches_peak_best_column_q <= select_3594;
      patches_peak_row_q <= equal_1789_s2_q ? select_3573 : patches_peak_row_q;
      patches_peak_above_q <= select_3597;
      patches_peak_below_q <= select_3599;
      patches_peak_far_q <= select_3603;
      patches_peak_size_q <= select_3606;
      shown_shown_q <= select_3856;
      shown_nearer_q <= select_3858;
      region_row_q <= select_3867;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3871;
      region_down_rest_q <= and_556_s2_q ? select_3884 : region_down_rest_q;
      region_down_back_q <= select_3889;
      region_down_next_q <= select_3892;
      region_fresh_q <= and_556_s2_q ? select_3896 : region_fresh_q;
      segment_starts_q <= select_3907;
      centres_values_0_textured_q <= equal_583_s2_q ? centres_values_0_textured_q : select_4067;
      centres_values_0_of_skin_q <= select_4072;
      centres_values_1_textured_q <= select_4075;
      centres_values_1_of_skin_q <= select_4078;
      map_row_q <= and_556_s2_q ? select_4084 : map_row_q;
      map_width_q <= select_4087;
      write_half_q <= select_4092;
      read_half_q <= and_1981_s2_q ? select_4094 : read_half_q;
      rows_passed_q <= and_1981_s2_q ? select_4107 : rows_passed_q;
      columns_passed_q <= and_1981_s2_q ? select_4110 : columns_passed_q;
      line_ended_q <= and_1981_s2_q ? select_4113 : line_ended_q;
      began_q <= and_1981_s2_q ? select_4116 : began_q;
      seen_x_q <= and_1981_s2_q ? select_4119 : seen_x_q;
      seen_y_q <= and_1981_s2_q ? select_4126 : seen_y_q;
      seen_column_q <= and_1981_s2_q ? select_4129 : seen_column_q;
      seen_rows_left_q <= and_1981_s2_q ? select_4137 : seen_rows_left_q;
      at_cell_end_q <= and_1981_s2_q ? select_4144 : at_cell_end_q;
      was_next_row_q <= and_1981_s2_q ? select_4147 : was_next_row_q;
      seen_base_q <= and_1981_s2_q ? select_4150 : seen_base_q;
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
      left_pixel_q <= and_1981_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_533 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_539 : averager_running_1_q;
      averager_total_0_q <= select_2190;
      averager_total_1_q <= select_2192;
      census_columns_values_0_cell_0_left_q <= select_2217;
      census_columns_values_0_cell_0_right_q <= select_2218;
      census_columns_values_0_cell_0_mask_q <= and_556_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2220;
      census_columns_values_0_cell_1_right_q <= select_2221;
      census_columns_values_0_cell_1_mask_q <= select_2222;
      census_columns_values_0_cell_2_left_q <= select_2223;
      census_columns_values_0_cell_2_right_q <= select_2224;
      census_columns_values_0_cell_2_mask_q <= select_2225;
      census_columns_values_0_cell_2_of_skin_q <= select_2226;
      census_columns_values_0_cell_3_left_q <= select_2227;
      census_columns_values_0_cell_3_right_q <= select_2228;
      census_columns_values_0_cell_3_mask_q <= select_2229;
      census_columns_values_0_cell_4_left_q <= select_2230;
      census_columns_values_0_cell_4_right_q <= select_2231;
      census_columns_values_0_cell_4_mask_q <= select_2232;
      census_columns_values_1_cell_0_left_q <= select_2233;
      census_columns_values_1_cell_0_right_q <= select_2234;
      census_columns_values_1_cell_0_mask_q <= select_2235;
      census_columns_values_1_cell_1_left_q <= select_2236;
      census_columns_values_1_cell_1_right_q <= select_2237;
      census_columns_values_1_cell_1_mask_q <= select_2238;
      census_columns_values_1_cell_2_left_q <= select_2239;
      census_columns_values_1_cell_2_right_q <= select_2240;
      census_columns_values_1_cell_2_mask_q <= select_2241;
      census_columns_values_1_cell_2_of_skin_q <= select_2242;
      census_columns_values_1_cell_3_left_q <= select_2243;
      census_columns_values_1_cell_3_right_q <= select_2244;
      census_columns_values_1_cell_3_mask_q <= select_2245;
      census_columns_values_1_cell_4_left_q <= select_2246;
      census_columns_values_1_cell_4_right_q <= select_2247;
      census_columns_values_1_cell_4_mask_q <= select_2248;
      census_columns_values_2_cell_0_left_q <= select_2249;
      census_columns_values_2_cell_0_right_q <= select_2250;
      census_columns_values_2_cell_0_mask_q <= select_2251;
      census_columns_values_2_cell_1_left_q <= select_2252;
      census_columns_values_2_cell_1_right_q <= select_2253;
      census_columns_values_2_cell_1_mask_q <= select_2254;
      census_columns_values_2_cell_2_left_q <= select_2255;
      census_columns_values_2_cell_2_right_q <= select_2256;
      census_columns_values_2_cell_2_mask_q <= select_2257;
      census_columns_values_2_cell_3_left_q <= select_2258;
      census_columns_values_2_cell_3_right_q <= select_2259;
      census_columns_values_2_cell_3_mask_q <= select_2260;
      census_columns_values_2_cell_4_left_q <= select_2261;
      census_columns_values_2_cell_4_right_q <= select_2262;
      census_columns_values_2_cell_4_mask_q <= select_2263;
      census_columns_values_3_cell_0_mask_q <= select_2264;
      census_columns_values_3_cell_1_left_q <= select_2265;
      census_columns_values_3_cell_1_right_q <= select_2266;
      census_columns_values_3_cell_1_mask_q <= select_2267;
      census_columns_values_3_cell_2_mask_q <= select_2268;
      census_columns_values_3_cell_3_left_q <= select_2269;
      census_columns_values_3_cell_3_right_q <= select_2270;
      census_columns_values_3_cell_3_mask_q <= select_2271;
      census_columns_values_3_cell_4_mask_q <= select_2272;
      sharpness_last_mean_0_q <= and_556_s2_q ? select_562 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_556_s2_q ? select_566 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_s2_q;
      middle_sum_columns_values_1_q <= select_2609;
      middle_sum_columns_values_2_q <= select_2610;
      middle_sum_columns_values_3_q <= select_2611;
      middle_sum_columns_values_4_q <= select_2612;
      middle_sum_columns_values_5_q <= select_2613;
      middle_sum_columns_values_6_q <= select_2614;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_1024;
      sums_0_sum_sums_values_0_q <= sum_1274;
      sums_0_sum_sums_values_1_q <= equal_1272 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1522;
      sums_1_sum_sums_values_1_q <= equal_1272 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [2:0] select_517_s3_q;
  logic row_starts_s3_q;
  logic [5:0] select_550_s3_q;
  logic [5:0] last_s3_q;
  logic and_554_s3_q;
  logic and_556_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_559_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_576_s3_q;
  logic equal_583_s3_q;
  logic not_584_s3_q;
  logic so_s3_q;
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
  logic and_695_s3_q;
  logic and_720_s3_q;
  logic and_721_s3_q;
  logic [11:0] sum_736_s3_q;
  logic [9:0] sum_739_s3_q;
  logic and_747_s3_q;
  logic and_751_s3_q;
  logic less_752_s3_q;
  logic less_756_s3_q;
  logic less_758_s3_q;
  logic equal_1620_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1626_s3_q;
  logic equal_1628_s3_q;
  logic equal_1630_s3_q;
  logic equal_1632_s3_q;
  logic equal_1634_s3_q;
  logic equal_1636_s3_q;
  logic equal_1638_s3_q;
  logic equal_1640_s3_q;
  logic equal_1642_s3_q;
  logic less_1651_s3_q;
  logic or_1655_s3_q;
  logic equal_1675_s3_q;
  logic and_1685_s3_q;
  logic select_1702_s3_q;
  logic equal_1703_s3_q;
  logic and_1711_s3_q;
  logic equal_1713_s3_q;
  logic select_1760_s3_q;
  logic and_1788_s3_q;
  logic equal_1789_s3_q;
  logic equal_1791_s3_q;
  logic not_1796_s3_q;
  logic and_1804_s3_q;
  logic [4:0] select_1819_s3_q;
  logic select_1825_s3_q;
  logic [3:0] select_1865_s3_q;
  logic and_1981_s3_q;
  logic select_1983_s3_q;
  logic and_1986_s3_q;
  logic or_1992_s3_q;
  logic or_1995_s3_q;
  logic or_1998_s3_q;
  logic not_2000_s3_q;
  logic and_2014_s3_q;
  logic and_2020_s3_q;
  logic and_2031_s3_q;
  logic and_2036_s3_q;
  logic and_2070_s3_q;
  logic less_2071_s3_q;
  logic [11:0] sum_2080_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2098_s3_q;
  logic or_2101_s3_q;
  logic or_2104_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2156_s3_q;
  logic [11:0] sum_2288_s3_q;
  logic [9:0] sum_2291_s3_q;
  logic equal_2299_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic equal_2428_s3_q;
  logic and_2634_s3_q;
  logic and_2641_s3_q;
  logic not_2662_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2706_s3_q;
  logic and_2741_s3_q;
  logic and_2801_s3_q;
  logic and_2802_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2838_s3_q;
  logic and_2852_s3_q;
  logic equal_2894_s3_q;
  logic parity_3271_s3_q;
  logic parity_3400_s3_q;
  logic parity_3462_s3_q;
  logic xor_3490_s3_q;
  logic parity_3502_s3_q;
  logic or_3506_s3_q;
  logic equal_3507_s3_q;
  logic and_3607_s3_q;
  logic less_3632_s3_q;
  logic equal_3931_s3_q;
  logic and_4105_s3_q;
  logic and_4153_s3_q;
  logic and_4155_s3_q;
  logic not_4173_s3_q;
  logic equal_4227_s3_q;
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
      select_517_s3_q <= select_517_s2_q;
      row_starts_s3_q <= row_starts_s2_q;
      select_550_s3_q <= select_550_s2_q;
      last_s3_q <= last_s2_2_q;
      and_554_s3_q <= and_554_s2_q;
      and_556_s3_q <= and_556_s2_q;
      grey_s3_q <= grey;
      equal_559_s3_q <= equal_559;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_576_s3_q <= equal_576_s2_q;
      equal_583_s3_q <= equal_583_s2_q;
      not_584_s3_q <= not_584_s2_q;
      so_s3_q <= drew_q;
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
      and_695_s3_q <= and_695;
      and_720_s3_q <= whole_22 & and_695;
      and_721_s3_q <= census_columns_values_1_cell_2_mask_q & and_695;
      sum_736_s3_q <= {1'b0, sum_732} + {2'h0, sum_735};
      sum_739_s3_q <= {9'h0, difference_737[9]} + {1'b0, xor_738};
      and_747_s3_q <= and_747;
      and_751_s3_q <= and_751;
      less_752_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_756_s3_q <= {{5{sum_755[6]}}, sum_755, half_grey_levels_2[3:0]} < 16'hffe1;
      less_758_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_1620_s3_q <= equal_1620;
      all_s3_q <= all;
      sum_1626_s3_q <= sum_1626;
      equal_1628_s3_q <= equal_1628;
      equal_1630_s3_q <= equal_1630;
      equal_1632_s3_q <= equal_1632;
      equal_1634_s3_q <= equal_1634;
      equal_1636_s3_q <= equal_1636;
      equal_1638_s3_q <= equal_1638;
      equal_1640_s3_q <= equal_1640;
      equal_1642_s3_q <= equal_1642;
      less_1651_s3_q <= less_1651;
      or_1655_s3_q <= or_1655;
      equal_1675_s3_q <= (registration_fresh_q & select_1673) == 4'h0;
      and_1685_s3_q <= not_584_s2_q & and_1669;
      select_1702_s3_q <= select_1702[1];
      equal_1703_s3_q <= equal_1703;
      and_1711_s3_q <= and_1711;
      equal_1713_s3_q <= equal_1713;
      select_1760_s3_q <= select_1760;
      and_1788_s3_q <= and_1788;
      equal_1789_s3_q <= equal_1789_s2_q;
      equal_1791_s3_q <= equal_1791_s2_q;
      not_1796_s3_q <= not_1796_s2_q;
      and_1804_s3_q <= and_1788 & equal_1803;
      select_1819_s3_q <= select_1819_s2_q;
      select_1825_s3_q <= select_1825_s2_q;
      select_1865_s3_q <= select_1865_s2_q;
      and_1981_s3_q <= and_1981_s2_q;
      select_1983_s3_q <= select_1983_s2_q;
      and_1986_s3_q <= and_1986_s2_q;
      or_1992_s3_q <= or_1992;
      or_1995_s3_q <= or_1995;
      or_1998_s3_q <= or_1998;
      not_2000_s3_q <= not_2000;
      and_2014_s3_q <= inside_v_s2_q & (and_2011 & not_2012_s2_q);
      and_2020_s3_q <= inside_v_s2_q & (and_643 & not_2012_s2_q);
      and_2031_s3_q <= inside_v_s2_q & (not_2012_s2_q & (and_2028 & and_1598));
      and_2036_s3_q <= not_584_s2_q & and_2007;
      and_2070_s3_q <= and_2070;
      less_2071_s3_q <= less_2071;
      sum_2080_s3_q <= sum_2080;
      textured_2_s3_q <= textured_2;
      or_2098_s3_q <= or_2098;
      or_2101_s3_q <= select_2095[7] | (~({select_2095[6], select_2095[3:2]} == 3'h0));
      or_2104_s3_q <= select_2095[7] | (~(select_2095[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2156_s3_q <= and_2156;
      sum_2288_s3_q <= {1'b0, sum_2284} + {2'h0, sum_2287};
      sum_2291_s3_q <= {9'h0, difference_2289[9]} + {1'b0, xor_2290};
      equal_2299_s3_q <= equal_2299_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      equal_2428_s3_q <= x_s2_q[7:3] == 5'h0;
      and_2634_s3_q <= and_2634;
      and_2641_s3_q <= not_584_s2_q & (drew_q & and_2639);
      not_2662_s3_q <= ~((draws_late_q & not_2012_s2_q) | (x_s2_q[7:1] == 7'h0));
      explained_2_s3_q <= explained_2;
      and_2706_s3_q <= not_584_s2_q & (drew_q & and_2704);
      and_2741_s3_q <= not_584_s2_q & (drew_q & and_2739);
      and_2801_s3_q <= not_584_s2_q & (drew_q & (half_ends & equal_2798));
      and_2802_s3_q <= and_2802;
      residual_s3_q <= residual[7:0];
      and_2838_s3_q <= and_2838;
      and_2852_s3_q <= and_2802 & less_2851;
      equal_2894_s3_q <= (registration_fresh_q & select_2892) == 4'h0;
      parity_3271_s3_q <= ^{xor_3267, xor_3230, select_3197[44:36], other[44:36]};
      parity_3400_s3_q <= parity_3400;
      parity_3462_s3_q <= parity_3462;
      xor_3490_s3_q <= parity_3477 ^ parity_3489;
      parity_3502_s3_q <= ^{or_3499, or_3495, and_3491};
      or_3506_s3_q <= (or_3495 & or_3499) | (and_3491 & (or_3495 | or_3499));
      equal_3507_s3_q <= equal_3507_s2_q;
      and_3607_s3_q <= equal_1789_s2_q & equal_3604_s2_q;
      less_3632_s3_q <= select_3597 < select_3599;
      equal_3931_s3_q <= equal_3931_s2_q;
      and_4105_s3_q <= said_q;
      and_4153_s3_q <= and_2156 & (sum_2080 == sum_2063);
      and_4155_s3_q <= and_4155_s2_q;
      not_4173_s3_q <= not_4173_s2_q;
      equal_4227_s3_q <= (registration_fresh_q & select_4225) == 4'h0;
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
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:284
  logic [11:0] texture;
  assign texture = sum_736_s3_q + {2'h0, sum_739_s3_q};
  // hls/stages/census.hpp:295
  logic [12:0] sum_741;
  assign sum_741 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_743;
  assign sum_743 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_741});
  // hls/stages/census.hpp:317
  logic less_744;
  assign less_744 = 9'h4 < sum_743[13:5];
  logic and_745;
  assign and_745 = and_695_s3_q & less_744;
  // hls/stages/moments.hpp:33
  logic and_757;
  assign and_757 = (and_720_s3_q & and_747_s3_q) & less_756_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_1677;
  assign equal_1677 = sum_1626_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1626_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1679;
  assign select_1679 = equal_1677 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1680;
  assign sum_1680 = (equal_1675_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1679[13]}}, select_1679};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1626_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1683;
  assign select_1683 = equal_1677 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1684;
  assign sum_1684 = (equal_1675_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1683[6]}}, select_1683};
  // hls/stages/patches.hpp:357
  logic [22:0] select_1805;
  assign select_1805 = and_1804_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1760_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1807;
  assign select_1807 = equal_1703_s3_q ? patches_place_0_valid_q : (select_1702_s3_q ? patches_place_0_valid_q : select_1805[0]);
  // hls/stages/patches.hpp:132
  logic [7:0] sum_1808;
  assign sum_1808 = {1'b0, select_550_s3_q, select_517_s3_q[2]} + 8'h3;
  // hls/stages/patches.hpp:358
  logic [21:0] select_1809;
  assign select_1809 = select_1702_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1805[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_1810;
  assign select_1810 = equal_1703_s3_q ? patches_place_0_column_q : select_1809[7:0];
  logic [5:0] select_1811;
  assign select_1811 = equal_1703_s3_q ? patches_place_0_shift_q : select_1809[13:8];
  // hls/stages/patches.hpp:328
  logic [7:0] sum_1812;
  assign sum_1812 = select_1810 + {{2{select_1811[5]}}, select_1811};
  // hls/stages/patches.hpp:132
  logic equal_1813;
  assign equal_1813 = {sum_1812, sum_1808[0], select_517_s3_q[1:0]} == {1'b0, sum_1808[7:1], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1815;
  assign or_1815 = row_starts_s3_q | (select_1807 & equal_1813);
  // hls/stages/agreement.hpp:277
  logic [4:0] select_1816;
  assign select_1816 = or_1815 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1826;
  assign select_1826 = or_1815 ? {row_starts_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:138
  logic and_1828;
  assign and_1828 = select_1825_s3_q & (~select_1826[5]);
  // hls/stages/patches.hpp:127
  logic select_1836;
  assign select_1836 = equal_1703_s3_q ? patches_place_1_valid_q : (select_1702_s3_q ? select_1805[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:358
  logic [21:0] select_1837;
  assign select_1837 = select_1702_s3_q ? select_1805[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_1838;
  assign select_1838 = equal_1703_s3_q ? patches_place_1_column_q : select_1837[7:0];
  logic [5:0] select_1839;
  assign select_1839 = equal_1703_s3_q ? patches_place_1_shift_q : select_1837[13:8];
  // hls/stages/patches.hpp:328
  logic [7:0] sum_1840;
  assign sum_1840 = select_1838 + {{2{select_1839[5]}}, select_1839};
  // hls/stages/patches.hpp:132
  logic equal_1841;
  assign equal_1841 = {sum_1840[7], sum_1808, select_517_s3_q[1:0]} == {1'b0, sum_1840[6:0], 3'h0};
  // hls/stages/patches.hpp:134
  logic or_1843;
  assign or_1843 = row_starts_s3_q | (select_1836 & equal_1841);
  // hls/stages/agreement.hpp:277
  logic [4:0] select_1844;
  assign select_1844 = or_1843 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:134
  logic [5:0] select_1845;
  assign select_1845 = or_1843 ? {row_starts_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:138
  logic and_1847;
  assign and_1847 = select_1825_s3_q & (~select_1845[5]);
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1854;
  assign sum_1854 = select_1810[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1855;
  assign equal_1855 = {sum_1854[6], select_550_s3_q, select_517_s3_q} == {1'b0, sum_1854[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic or_1857;
  assign or_1857 = row_starts_s3_q | (select_1807 & equal_1855);
  logic [4:0] select_1858;
  assign select_1858 = or_1857 ? {row_starts_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1859;
  assign sum_1859 = select_1838[6:0] + 7'h7f;
  // hls/stages/patches.hpp:133
  logic equal_1860;
  assign equal_1860 = {sum_1859[6], select_550_s3_q, select_517_s3_q} == {1'b0, sum_1859[5:0], 3'h4};
  // hls/stages/patches.hpp:135
  logic [4:0] select_1863;
  assign select_1863 = (row_starts_s3_q | (select_1836 & equal_1860)) ? {row_starts_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:143
  logic [3:0] column_4;
  assign column_4 = select_1858[4] ? select_1863[3:0] : select_1858[3:0];
  // hls/stages/agreement.hpp:277
  logic select_1866;
  assign select_1866 = or_1857 ? row_starts_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:143
  logic and_1872;
  assign and_1872 = (select_1825_s3_q & (select_1819_s3_q[3] ^ select_1819_s3_q[4])) & ((~select_1858[4]) | (~select_1863[4]));
  // hls/stages/patches.hpp:186
  logic less_1976;
  assign less_1976 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:187
  logic not_1977;
  assign not_1977 = ~less_1976;
  logic [1:0] select_1978;
  assign select_1978 = patches_summed_first_s3_q ? 2'h2 : {less_1976, not_1977};
  logic [12:0] select_1979;
  assign select_1979 = select_1978[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1987;
  assign select_1987 = select_1978[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1986_s3_q, 1'b0, select_1983_s3_q, left_pixel_q};
  logic [14:0] select_1988;
  assign select_1988 = select_1978[1] ? {select_1979[12:8], patches_sums_values_0_q[9:8], select_1979[7:0]} : select_1987;
  // hls/stages/agreement.hpp:910
  logic [5:0] select_2015;
  assign select_2015 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:911
  logic [5:0] sum_2016;
  assign sum_2016 = {5'h0, and_2014_s3_q} + select_2015;
  // hls/stages/agreement.hpp:1075
  logic [9:0] sum_2018;
  assign sum_2018 = {4'h0, sum_2016} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:910
  logic [5:0] select_2021;
  assign select_2021 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:911
  logic [5:0] sum_2022;
  assign sum_2022 = {5'h0, and_2020_s3_q} + select_2021;
  // hls/stages/agreement.hpp:1076
  logic [9:0] sum_2024;
  assign sum_2024 = {4'h0, sum_2022} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:910
  logic [5:0] select_2032;
  assign select_2032 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:912
  logic [5:0] sum_2033;
  assign sum_2033 = {5'h0, and_2031_s3_q} + select_2032;
  // hls/stages/agreement.hpp:1077
  logic [9:0] sum_2035;
  assign sum_2035 = {4'h0, sum_2033} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1108
  logic [2:0] select_2089;
  assign select_2089 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2090;
  assign difference_2090 = {1'b0, textured_2_s3_q} - {1'b0, select_2089};
  logic [4:0] t;
  assign t = {difference_2090[3], difference_2090} + (equal_576_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1114
  logic equal_2093;
  assign equal_2093 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1115
  logic not_2105;
  assign not_2105 = ~region_row_s3_q[2];
  logic [2:0] select_2106;
  assign select_2106 = region_row_s3_q[1] ? {1'b0, not_2105, 1'b0} : {region_row_s3_q[2], 1'b0, not_2105};
  logic [5:0] select_2107;
  assign select_2107 = region_row_s3_q[0] ? {select_2106[2], 1'b0, select_2106[1], 1'b0, select_2106[0], 1'b0} : {1'b0, select_2106[2], 1'b0, select_2106[1], 1'b0, select_2106[0]};
  logic [11:0] select_2108;
  assign select_2108 = or_2104_s3_q ? {select_2107[5], 1'b0, select_2107[4], 1'b0, select_2107[3], 1'b0, select_2107[2], 1'b0, select_2107[1], 1'b0, select_2107[0], 1'b0} : {1'b0, select_2107[5], 1'b0, select_2107[4], 1'b0, select_2107[3], 1'b0, select_2107[2], 1'b0, select_2107[1], 1'b0, select_2107[0]};
  logic [23:0] select_2109;
  assign select_2109 = or_2101_s3_q ? {select_2108[11], 1'b0, select_2108[10], 1'b0, select_2108[9], 1'b0, select_2108[8], 1'b0, select_2108[7], 1'b0, select_2108[6], 1'b0, select_2108[5], 1'b0, select_2108[4], 1'b0, select_2108[3], 1'b0, select_2108[2], 1'b0, select_2108[1], 1'b0, select_2108[0], 1'b0} : {1'b0, select_2108[11], 1'b0, select_2108[10], 1'b0, select_2108[9], 1'b0, select_2108[8], 1'b0, select_2108[7], 1'b0, select_2108[6], 1'b0, select_2108[5], 1'b0, select_2108[4], 1'b0, select_2108[3], 1'b0, select_2108[2], 1'b0, select_2108[1], 1'b0, select_2108[0]};
  logic [47:0] select_2110;
  assign select_2110 = or_2098_s3_q ? {select_2109[23], 1'b0, select_2109[22], 1'b0, select_2109[21], 1'b0, select_2109[20], 1'b0, select_2109[19], 1'b0, select_2109[18], 1'b0, select_2109[17], 1'b0, select_2109[16], 1'b0, select_2109[15], 1'b0, select_2109[14], 1'b0, select_2109[13], 1'b0, select_2109[12], 1'b0, select_2109[11], 1'b0, select_2109[10], 1'b0, select_2109[9], 1'b0, select_2109[8], 1'b0, select_2109[7], 1'b0, select_2109[6], 1'b0, select_2109[5], 1'b0, select_2109[4], 1'b0, select_2109[3], 1'b0, select_2109[2], 1'b0, select_2109[1], 1'b0, select_2109[0], 1'b0} : {1'b0, select_2109[23], 1'b0, select_2109[22], 1'b0, select_2109[21], 1'b0, select_2109[20], 1'b0, select_2109[19], 1'b0, select_2109[18], 1'b0, select_2109[17], 1'b0, select_2109[16], 1'b0, select_2109[15], 1'b0, select_2109[14], 1'b0, select_2109[13], 1'b0, select_2109[12], 1'b0, select_2109[11], 1'b0, select_2109[10], 1'b0, select_2109[9], 1'b0, select_2109[8], 1'b0, select_2109[7], 1'b0, select_2109[6], 1'b0, select_2109[5], 1'b0, select_2109[4], 1'b0, select_2109[3], 1'b0, select_2109[2], 1'b0, select_2109[1], 1'b0, select_2109[0]};
  // hls/stages/agreement.hpp:1043
  logic and_2114;
  assign and_2114 = good_known_q & (~((good_q & select_2110) == 48'h0));
  // hls/stages/agreement.hpp:1110
  logic [2:0] select_2123;
  assign select_2123 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2124;
  assign difference_2124 = {1'b0, shown_2_s3_q} - {1'b0, select_2123};
  logic [4:0] around;
  assign around = {difference_2124[3], difference_2124} + (equal_576_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1117
  logic [5:0] sum_2127;
  assign sum_2127 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2093 ? and_2114 : (~({sum_2127, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1111
  logic [2:0] select_2139;
  assign select_2139 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2140;
  assign difference_2140 = {1'b0, near_2_s3_q} - {1'b0, select_2139};
  logic [4:0] n;
  assign n = {difference_2140[3], difference_2140} + (equal_576_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1127
  logic and_2144;
  assign and_2144 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:277
  logic [8:0] select_2182;
  assign select_2182 = sample_pair_whole_s3_q ? (and_554_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2184;
  assign select_2184 = sample_pair_whole_s3_q ? (and_554_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2186;
  assign select_2186 = sample_pair_whole_s3_q ? (and_554_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2188;
  assign select_2188 = sample_pair_whole_s3_q ? (and_554_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2193;
  assign sum_2193 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2194;
  assign difference_2194 = {1'b0, sum_2193[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2195;
  assign xor_2195 = {difference_2194[8:0], sum_2193[0]} ^ {10{difference_2194[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2194[9]} + {1'b0, xor_2195};
  // hls/stages/census.hpp:222
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_559_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2200;
  assign select_2200 = sample_pair_whole_s3_q ? (and_554_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:220
  logic [9:0] sum_2201;
  assign sum_2201 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2202;
  assign difference_2202 = {1'b0, sum_2201[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:221
  logic [9:0] xor_2203;
  assign xor_2203 = {difference_2202[8:0], sum_2201[0]} ^ {10{difference_2202[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2202[9]} + {1'b0, xor_2203};
  // hls/stages/census.hpp:222
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_559_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:277
  logic [13:0] select_2208;
  assign select_2208 = sample_pair_whole_s3_q ? (and_554_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:286
  logic [11:0] sum_2292;
  assign sum_2292 = sum_2288_s3_q + {2'h0, sum_2291_s3_q};
  // hls/stages/agreement.hpp:530
  logic [11:0] select_2294;
  assign select_2294 = and_556_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2295;
  assign select_2295 = and_556_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2296;
  assign select_2296 = and_556_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2297;
  assign select_2297 = and_556_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:296
  logic [12:0] sum_2300;
  assign sum_2300 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2292};
  logic [13:0] sum_2302;
  assign sum_2302 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2300});
  // hls/stages/census.hpp:323
  logic and_2304;
  assign and_2304 = and_720_s3_q & (9'h4 < sum_2302[13:5]);
  // hls/stages/census.hpp:324
  logic and_2305;
  assign and_2305 = and_720_s3_q & less_744;
  // hls/stages/census.hpp:325
  logic [19:0] sum_2306;
  assign sum_2306 = census_left_misses_q + {{17{and_2305}}, and_2304, 1'b0, and_2304};
  // hls/stages/agreement.hpp:530
  logic [19:0] select_2308;
  assign select_2308 = and_556_s3_q ? (equal_2299_s3_q ? 20'h0 : sum_2306) : census_left_misses_q;
  // hls/stages/agreement.hpp:277
  logic [27:0] select_2389;
  assign select_2389 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:530
  logic select_2392;
  assign select_2392 = and_556_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:373
  logic and_2395;
  assign and_2395 = whole_2_s3_q & (~(last_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:462
  logic and_2401;
  assign and_2401 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2402;
  assign and_2402 = and_2395 & and_2401;
  // hls/stages/census.hpp:372
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2389[13:0]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2404;
  assign select_2404 = and_2402 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2406;
  assign select_2406 = equal_2299_s3_q ? {11'h0, select_2404} : (sharpness_sums_detail_0_q + {11'h0, select_2404});
  // hls/stages/agreement.hpp:462
  logic and_2413;
  assign and_2413 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2414;
  assign and_2414 = and_2395 & and_2413;
  // hls/stages/census.hpp:372
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2389[27:14]};
  // hls/stages/census.hpp:374
  logic [12:0] select_2416;
  assign select_2416 = and_2414 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:375
  logic [23:0] select_2418;
  assign select_2418 = equal_2299_s3_q ? {11'h0, select_2416} : (sharpness_sums_detail_1_q + {11'h0, select_2416});
  logic [8:0] select_2421;
  assign select_2421 = and_2402 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2422;
  assign sum_2422 = (equal_2299_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2421};
  logic [8:0] select_2425;
  assign select_2425 = and_2414 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2426;
  assign sum_2426 = (equal_2299_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2425};
  // hls/stages/census.hpp:388
  logic less_2429;
  assign less_2429 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:427
  logic less_2430;
  assign less_2430 = x_s3_q[4:0] < 5'h3;
  logic not_2431;
  assign not_2431 = ~x_s3_q[1];
  logic [2:0] select_2432;
  assign select_2432 = x_s3_q[0] ? {1'b0, not_2431, 1'b0} : {x_s3_q[1], 1'b0, not_2431};
  logic [5:0] select_2433;
  assign select_2433 = slot_s3_q[2] ? {select_2432[2], 1'b0, select_2432[1], 1'b0, select_2432[0], 1'b0} : {1'b0, select_2432[2], 1'b0, select_2432[1], 1'b0, select_2432[0]};
  logic [11:0] select_2434;
  assign select_2434 = slot_s3_q[1] ? {select_2433[5], 1'b0, select_2433[4], 1'b0, select_2433[3], 1'b0, select_2433[2], 1'b0, select_2433[1], 1'b0, select_2433[0], 1'b0} : {1'b0, select_2433[5], 1'b0, select_2433[4], 1'b0, select_2433[3], 1'b0, select_2433[2], 1'b0, select_2433[1], 1'b0, select_2433[0]};
  logic [23:0] select_2435;
  assign select_2435 = slot_s3_q[0] ? {select_2434[11], 1'b0, select_2434[10], 1'b0, select_2434[9], 1'b0, select_2434[8], 1'b0, select_2434[7], 1'b0, select_2434[6], 1'b0, select_2434[5], 1'b0, select_2434[4], 1'b0, select_2434[3], 1'b0, select_2434[2], 1'b0, select_2434[1], 1'b0, select_2434[0], 1'b0} : {1'b0, select_2434[11], 1'b0, select_2434[10], 1'b0, select_2434[9], 1'b0, select_2434[8], 1'b0, select_2434[7], 1'b0, select_2434[6], 1'b0, select_2434[5], 1'b0, select_2434[4], 1'b0, select_2434[3], 1'b0, select_2434[2], 1'b0, select_2434[1], 1'b0, select_2434[0]};
  // hls/stages/census.hpp:390
  logic and_2439;
  assign and_2439 = less_2430 & (~((sharpness_sums_contrast_1_q & select_2435) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2441;
  assign select_2441 = (less_2429 & and_2439) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2441};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2444;
  assign select_2444 = equal_2428_s3_q ? (less_2429 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:390
  logic and_2449;
  assign and_2449 = less_2430 & (~((sharpness_sums_contrast_0_q & select_2435) == 24'h0));
  // hls/stages/census.hpp:395
  logic [17:0] select_2451;
  assign select_2451 = (less_2429 & and_2449) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2451};
  // hls/stages/agreement.hpp:217
  logic [17:0] select_2454;
  assign select_2454 = equal_2428_s3_q ? (less_2429 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2456;
  assign select_2456 = equal_2428_s3_q ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2458;
  assign select_2458 = equal_2428_s3_q ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2460;
  assign select_2460 = equal_2428_s3_q ? {sharpness_comparing_contrast_0_q[0], and_2449} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2462;
  assign select_2462 = equal_2428_s3_q ? {sharpness_comparing_contrast_1_q[0], and_2439} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:217
  logic select_2467;
  assign select_2467 = so_s3_q ? (equal_2428_s3_q ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:401
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:217
  logic select_2470;
  assign select_2470 = equal_2428_s3_q ? five_times_2[1] : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:387
  logic equal_2472;
  assign equal_2472 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:403
  logic xor_2473;
  assign xor_2473 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2476;
  assign select_2476 = (equal_2472 | xor_2473) ? (five_times[0] & xor_2473) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2477;
  assign select_2477 = equal_2428_s3_q ? select_2476 : sharpness_comparing_less_detail_0_q;
  logic select_2478;
  assign select_2478 = so_s3_q ? select_2477 : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:403
  logic xor_2479;
  assign xor_2479 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2482;
  assign select_2482 = (equal_2472 | xor_2479) ? (five_times_2[0] & xor_2479) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2483;
  assign select_2483 = equal_2428_s3_q ? select_2482 : sharpness_comparing_less_detail_1_q;
  logic select_2484;
  assign select_2484 = so_s3_q ? select_2483 : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:404
  logic xor_2485;
  assign xor_2485 = sharpness_comparing_contrast_0_q[1] ^ and_2439;
  logic select_2488;
  assign select_2488 = (equal_2472 | xor_2485) ? (and_2439 & xor_2485) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:217
  logic select_2489;
  assign select_2489 = equal_2428_s3_q ? select_2488 : sharpness_comparing_less_contrast_0_q;
  logic select_2490;
  assign select_2490 = so_s3_q ? select_2489 : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:404
  logic xor_2491;
  assign xor_2491 = sharpness_comparing_contrast_1_q[1] ^ and_2449;
  logic select_2494;
  assign select_2494 = (equal_2472 | xor_2491) ? (and_2449 & xor_2491) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:217
  logic select_2495;
  assign select_2495 = equal_2428_s3_q ? select_2494 : sharpness_comparing_less_contrast_1_q;
  logic select_2496;
  assign select_2496 = so_s3_q ? select_2495 : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2643;
  assign select_2643 = and_2634_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2641_s3_q});
  // hls/stages/agreement.hpp:798
  logic and_2646;
  assign and_2646 = not_584_s3_q & (so_s3_q & (ends_cell_s3_q & and_2014_s3_q));
  logic and_2651;
  assign and_2651 = not_584_s3_q & (so_s3_q & (ends_cell_s3_q & and_2020_s3_q));
  logic and_2656;
  assign and_2656 = not_584_s3_q & (so_s3_q & (ends_cell_s3_q & and_2031_s3_q));
  // hls/stages/agreement.hpp:1109
  logic [2:0] select_2671;
  assign select_2671 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2672;
  assign difference_2672 = {1'b0, explained_2_s3_q} - {1'b0, select_2671};
  logic [4:0] e;
  assign e = {difference_2672[3], difference_2672} + (equal_576_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1116
  logic [5:0] sum_2675;
  assign sum_2675 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1121
  logic not_2679;
  assign not_2679 = ~(equal_2093 ? and_2114 : (~({sum_2675, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:798
  logic and_2682;
  assign and_2682 = ends_cell_s3_q & (not_2662_s3_q & (centres_values_1_textured_s3_q & not_2679));
  logic and_2684;
  assign and_2684 = not_584_s3_q & (so_s3_q & and_2682);
  // hls/stages/agreement.hpp:1147
  logic less_2687;
  assign less_2687 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2688;
  assign select_2688 = less_2687 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2691;
  assign select_2691 = less_2687 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1148
  logic [10:0] sum_2692;
  assign sum_2692 = {1'b0, select_2691} + {3'h0, select_2691[9:2]};
  logic and_2694;
  assign and_2694 = (~(select_2688[9:4] == 6'h0)) & ({sum_2692, select_2691[1:0]} < {3'h0, select_2688});
  // hls/stages/agreement.hpp:1157
  logic [9:0] select_2697;
  assign select_2697 = x_s3_q[6] ? (equal_1620_s3_q ? 10'h0 : (and_2694 ? select_2688 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:798
  logic [9:0] select_2698;
  assign select_2698 = equal_583_s3_q ? select_2697 : 10'h0;
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2700;
  assign select_2700 = and_2634_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2698});
  logic [13:0] select_2708;
  assign select_2708 = and_2634_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2706_s3_q});
  // hls/stages/agreement.hpp:1125
  logic and_2710;
  assign and_2710 = not_2662_s3_q & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:798
  logic and_2713;
  assign and_2713 = not_584_s3_q & (so_s3_q & (ends_cell_s3_q & and_2710));
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2715;
  assign select_2715 = and_2634_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2713});
  // hls/stages/agreement.hpp:1125
  logic and_2717;
  assign and_2717 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2679);
  // hls/stages/agreement.hpp:798
  logic and_2721;
  assign and_2721 = not_584_s3_q & (so_s3_q & (ends_cell_s3_q & (not_2662_s3_q & and_2717)));
  // hls/stages/agreement.hpp:936
  logic [13:0] select_2723;
  assign select_2723 = and_2634_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2721});
  logic [13:0] select_2743;
  assign select_2743 = and_2634_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2741_s3_q});
  // hls/stages/agreement.hpp:798
  logic [7:0] select_2820;
  assign select_2820 = so_s3_q ? (equal_1713_s3_q ? (and_2802_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2821;
  assign select_2821 = equal_583_s3_q ? 8'h0 : select_2820;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2823;
  assign select_2823 = and_2801_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2821[7]}}, select_2821});
  // hls/stages/agreement.hpp:798
  logic and_2826;
  assign and_2826 = not_584_s3_q & (so_s3_q & (and_2802_s3_q & equal_1713_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2828;
  assign select_2828 = and_2801_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2826});
  // hls/stages/registration.hpp:107
  logic and_2830;
  assign and_2830 = and_2802_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2832;
  assign select_2832 = so_s3_q ? (equal_1713_s3_q ? {and_2830, and_2802_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2833;
  assign select_2833 = equal_583_s3_q ? 2'h0 : select_2832;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2834;
  assign sum_2834 = registration_half_votes_down_q + {{5{select_2833[1]}}, select_2833};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2840;
  assign select_2840 = so_s3_q ? (equal_1713_s3_q ? {and_2838_s3_q, and_2802_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2841;
  assign select_2841 = equal_583_s3_q ? 2'h0 : select_2840;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2842;
  assign sum_2842 = registration_half_votes_up_q + {{5{select_2841[1]}}, select_2841};
  // hls/stages/registration.hpp:107
  logic and_2845;
  assign and_2845 = and_2802_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2847;
  assign select_2847 = so_s3_q ? (equal_1713_s3_q ? {and_2845, and_2802_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2848;
  assign select_2848 = equal_583_s3_q ? 2'h0 : select_2847;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2849;
  assign sum_2849 = registration_half_half_votes_down_q + {{5{select_2848[1]}}, select_2848};
  // hls/stages/agreement.hpp:798
  logic [1:0] select_2854;
  assign select_2854 = so_s3_q ? (equal_1713_s3_q ? {and_2852_s3_q, and_2802_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2855;
  assign select_2855 = equal_583_s3_q ? 2'h0 : select_2854;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2856;
  assign sum_2856 = registration_half_half_votes_up_q + {{5{select_2855[1]}}, select_2855};
  // hls/stages/agreement.hpp:798
  logic and_2889;
  assign and_2889 = equal_583_s3_q & (x_s3_q[6] & (not_2000_s3_q & less_1651_s3_q));
  // hls/stages/agreement.hpp:1145
  logic [11:0] select_2896;
  assign select_2896 = or_1655_s3_q ? 12'h0 : (equal_2894_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1157
  logic [11:0] select_2899;
  assign select_2899 = x_s3_q[6] ? (equal_1620_s3_q ? 12'h0 : (less_1651_s3_q ? select_2896 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:798
  logic [11:0] select_2900;
  assign select_2900 = equal_583_s3_q ? select_2899 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2901;
  assign and_2901 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1157
  logic and_2904;
  assign and_2904 = not_2000_s3_q & (less_1651_s3_q & ({and_2901, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:798
  logic and_2906;
  assign and_2906 = equal_583_s3_q & (x_s3_q[6] & and_2904);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2908;
  assign sum_2908 = {{2{select_2900[11]}}, select_2900} + (and_2906 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1145
  logic [11:0] select_2911;
  assign select_2911 = or_1655_s3_q ? 12'h0 : (equal_2894_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1157
  logic [11:0] select_2914;
  assign select_2914 = x_s3_q[6] ? (equal_1620_s3_q ? 12'h0 : (less_1651_s3_q ? select_2911 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:798
  logic [11:0] select_2915;
  assign select_2915 = equal_583_s3_q ? select_2914 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2917;
  assign sum_2917 = {{2{select_2915[11]}}, select_2915} + (and_2906 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2919;
  assign not_2919 = ~all_s3_q;
  // hls/stages/agreement.hpp:1157
  logic and_2922;
  assign and_2922 = not_2000_s3_q & (less_1651_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2919, 1'b0}));
  // hls/stages/agreement.hpp:798
  logic and_2928;
  assign and_2928 = equal_583_s3_q & (x_s3_q[6] & (not_2000_s3_q & (less_1651_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2929;
  assign not_2929 = ~and_2928;
  logic less_2930;
  assign less_2930 = $signed({9'h1, {2{not_2929}}, and_2928}) < $signed(registration_up_q[13:2]);
  logic select_2931;
  assign select_2931 = (equal_583_s3_q & (x_s3_q[6] & and_2922)) ? less_2930 : registration_enough_q;
  // hls/stages/agreement.hpp:1157
  logic and_2935;
  assign and_2935 = x_s3_q[6] & (not_2000_s3_q & (less_1651_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:798
  logic and_2936;
  assign and_2936 = equal_583_s3_q & and_2935;
  // hls/stages/registration.hpp:242
  logic less_2937;
  assign less_2937 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2939;
  assign less_2939 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2941;
  assign equal_2941 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:798
  logic and_2945;
  assign and_2945 = equal_583_s3_q & (x_s3_q[6] & (not_2000_s3_q & (less_1651_s3_q & equal_2941)));
  // hls/stages/agreement.hpp:1157
  logic and_2952;
  assign and_2952 = x_s3_q[6] & (not_2000_s3_q & (less_1651_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2955;
  assign equal_2955 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1157
  logic and_2958;
  assign and_2958 = not_2000_s3_q & (less_1651_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2955));
  // hls/stages/registration.hpp:244
  logic and_2962;
  assign and_2962 = (equal_583_s3_q & (x_s3_q[6] & and_2958)) & (less_2939 | less_2937);
  // hls/stages/agreement.hpp:1157
  logic and_2967;
  assign and_2967 = not_2000_s3_q & (less_1651_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2955)));
  // hls/stages/registration.hpp:244
  logic and_2970;
  assign and_2970 = registration_votes_up_q & registration_other_down_q;
  logic select_2972;
  assign select_2972 = registration_votes_down_q ? (registration_other_up_q | and_2970) : and_2970;
  // hls/stages/registration.hpp:138
  logic and_2974;
  assign and_2974 = (equal_583_s3_q & (x_s3_q[6] & and_2967)) & (registration_other_enough_q & select_2972);
  // hls/stages/registration.hpp:245
  logic or_2977;
  assign or_2977 = registration_moved_q | (registration_enough_q & (and_2962 | and_2974));
  // hls/stages/agreement.hpp:277
  logic [7:0] select_3060;
  assign select_3060 = sample_pair_whole_s3_q ? (equal_1703_s3_q ? patches_place_0_slope_q : select_1809[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3065;
  assign select_3065 = sample_pair_whole_s3_q ? (equal_1703_s3_q ? patches_place_1_slope_q : select_1837[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3067;
  assign select_3067 = equal_1703_s3_q ? patches_valid_0_q : (select_1702_s3_q ? patches_valid_0_q : select_1805[0]);
  // hls/stages/agreement.hpp:277
  logic select_3070;
  assign select_3070 = sample_pair_whole_s3_q ? (and_1828 ? (sample_present_s3_q & select_3067) : select_3067) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3072;
  assign select_3072 = equal_1703_s3_q ? patches_valid_1_q : (select_1702_s3_q ? select_1805[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:277
  logic select_3075;
  assign select_3075 = sample_pair_whole_s3_q ? (and_1847 ? (sample_present_s3_q & select_3072) : select_3072) : patches_valid_1_q;
  logic [5:0] select_3078;
  assign select_3078 = sample_pair_whole_s3_q ? (select_1826[5] ? {1'b1, select_1826[4:0]} : (select_1826 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3081;
  assign select_3081 = sample_pair_whole_s3_q ? (select_1845[5] ? {1'b1, select_1845[4:0]} : (select_1845 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3084;
  assign select_3084 = sample_pair_whole_s3_q ? (select_1858[4] ? {1'b1, select_1858[3:0]} : (select_1858 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3087;
  assign select_3087 = sample_pair_whole_s3_q ? (select_1863[4] ? {1'b1, select_1863[3:0]} : (select_1863 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:529
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3506_s3_q, parity_3502_s3_q, xor_3490_s3_q, parity_3462_s3_q, parity_3400_s3_q, parity_3271_s3_q} + (equal_3507_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/agreement.hpp:276
  logic [9:0] select_3511;
  assign select_3511 = equal_1789_s3_q ? patches_sums_values_0_q : (equal_1791_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3512;
  assign select_3512 = equal_1791_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3514;
  assign select_3514 = equal_1791_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3516;
  assign select_3516 = equal_1791_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3518;
  assign select_3518 = equal_1791_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3520;
  assign select_3520 = equal_1791_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3522;
  assign select_3522 = equal_1791_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3524;
  assign select_3524 = equal_1791_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3526;
  assign select_3526 = equal_1791_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3528;
  assign select_3528 = equal_1791_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3530;
  assign select_3530 = equal_1791_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3532;
  assign select_3532 = equal_1791_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3534;
  assign select_3534 = equal_1791_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3536;
  assign select_3536 = equal_1791_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3538;
  assign select_3538 = equal_1791_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3540;
  assign select_3540 = equal_1791_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3542;
  assign select_3542 = equal_1791_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:601
  logic [9:0] difference_3613;
  assign difference_3613 = patches_peak_far_q - patches_peak_best_differing_q;
  logic and_3616;
  assign and_3616 = (~(patches_peak_far_q < patches_peak_best_differing_q)) & (~({difference_3613, 3'h0} < {3'h0, patches_peak_size_q}));
  // hls/stages/patches.hpp:600
  logic not_3619;
  assign not_3619 = ~({1'b0, patches_peak_size_q[9:1]} < patches_peak_best_differing_q);
  // hls/stages/patches.hpp:608
  logic and_3622;
  assign and_3622 = (patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q) & (and_3616 & ((10'h38 < patches_peak_size_q) & not_3619));
  // hls/stages/patches.hpp:190
  logic and_3624;
  assign and_3624 = and_3607_s3_q & ((~(patches_peak_row_q[3:0] == 4'h0)) & and_3622);
  // hls/stages/patches.hpp:667
  logic not_3625;
  assign not_3625 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:192
  logic and_3627;
  assign and_3627 = and_3624 & (not_1796_s3_q & not_3625);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3629;
  assign sum_3629 = {7'h0, and_3627} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:586
  logic [1:0] sum_3633;
  assign sum_3633 = patches_peak_row_q[4:3] + 2'h3;
  // hls/stages/patches.hpp:581
  logic [9:0] high;
  assign high = less_3632_s3_q ? patches_peak_below_q : patches_peak_above_q;
  logic [9:0] low;
  assign low = (patches_peak_below_q < patches_peak_above_q) ? patches_peak_below_q : patches_peak_above_q;
  // hls/stages/patches.hpp:582
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - patches_peak_best_differing_q;
  // hls/stages/patches.hpp:584
  logic not_3640;
  assign not_3640 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3641;
  assign sum_3641 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3643;
  assign not_3643 = ~({eight, 3'h0} < {1'b0, sum_3641, fall_2[0]});
  logic [1:0] sum_3644;
  assign sum_3644 = {1'b0, not_3640} + {1'b0, not_3643};
  // hls/stages/patches.hpp:585
  logic [10:0] sum_3645;
  assign sum_3645 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3647;
  assign not_3647 = ~({eight, 3'h0} < {sum_3645, fall_2[1:0]});
  logic not_3650;
  assign not_3650 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3651;
  assign sum_3651 = {1'b0, not_3647} + {1'b0, not_3650};
  // hls/stages/patches.hpp:584
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3644} + {1'b0, sum_3651};
  // hls/stages/patches.hpp:587
  logic [7:0] select_3654;
  assign select_3654 = less_3632_s3_q ? ({sum_3633, patches_peak_row_q[2:0], 3'h0} - {5'h0, fraction}) : {sum_3633, patches_peak_row_q[2:0], fraction};
  // hls/stages/patches.hpp:604
  logic [7:0] select_3655;
  assign select_3655 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:603
  logic [5:0] select_3656;
  assign select_3656 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3657;
  assign sum_3657 = {2'h0, patches_peak_best_column_q[4:3]} + 4'hf;
  logic [6:0] sum_3658;
  assign sum_3658 = {select_3656[5], select_3656} + {{3{sum_3657[3]}}, sum_3657};
  // hls/stages/patches.hpp:604
  logic [17:0] product_3659;
  assign product_3659 = $signed({{10{select_3655[7]}}, select_3655}) * $signed({{8{sum_3658[6]}}, sum_3658, patches_peak_best_column_q[2:0]});
  // hls/stages/patches.hpp:605
  logic [13:0] difference_3660;
  assign difference_3660 = {{6{select_3654[7]}}, select_3654} - {product_3659[17], product_3659[17:5]};
  // hls/stages/patches.hpp:611
  logic less_3661;
  assign less_3661 = $signed({{7{difference_3631[6]}}, difference_3631}) < $signed(difference_3660);
  // hls/stages/patches.hpp:189
  logic not_3662;
  assign not_3662 = ~less_3661;
  // hls/stages/patches.hpp:670
  logic and_3663;
  assign and_3663 = not_3662 & and_3627;
  logic [7:0] sum_3664;
  assign sum_3664 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3663};
  // hls/stages/patches.hpp:189
  logic not_3667;
  assign not_3667 = ~($signed(difference_3660) < $signed({8'h0, cfg_patch_limit_i}));
  // hls/stages/patches.hpp:671
  logic and_3668;
  assign and_3668 = not_3667 & and_3627;
  logic [7:0] sum_3669;
  assign sum_3669 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3668};
  // hls/stages/patches.hpp:192
  logic and_3671;
  assign and_3671 = and_3624 & (patches_second_s3_q & not_3625);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3673;
  assign sum_3673 = {7'h0, and_3671} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:670
  logic and_3675;
  assign and_3675 = not_3662 & and_3671;
  logic [7:0] sum_3676;
  assign sum_3676 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3675};
  // hls/stages/patches.hpp:671
  logic and_3678;
  assign and_3678 = not_3667 & and_3671;
  logic [7:0] sum_3679;
  assign sum_3679 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3678};
  // hls/stages/patches.hpp:192
  logic and_3681;
  assign and_3681 = and_3624 & (patches_lower_s3_q & not_1796_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3683;
  assign sum_3683 = {7'h0, and_3681} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:670
  logic and_3685;
  assign and_3685 = not_3662 & and_3681;
  logic [7:0] sum_3686;
  assign sum_3686 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3685};
  // hls/stages/patches.hpp:671
  logic and_3688;
  assign and_3688 = not_3667 & and_3681;
  logic [7:0] sum_3689;
  assign sum_3689 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3688};
  // hls/stages/patches.hpp:192
  logic and_3691;
  assign and_3691 = and_3624 & (patches_lower_s3_q & patches_second_s3_q);
  // hls/stages/patches.hpp:669
  logic [7:0] sum_3693;
  assign sum_3693 = {7'h0, and_3691} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:670
  logic and_3695;
  assign and_3695 = not_3662 & and_3691;
  logic [7:0] sum_3696;
  assign sum_3696 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3695};
  // hls/stages/patches.hpp:671
  logic and_3698;
  assign and_3698 = not_3667 & and_3691;
  logic [7:0] sum_3699;
  assign sum_3699 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3698};
  // hls/stages/agreement.hpp:1238
  logic equal_3700;
  assign equal_3700 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1145
  logic less_3701;
  assign less_3701 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:798
  logic and_3705;
  assign and_3705 = equal_583_s3_q & (x_s3_q[6] & (not_2000_s3_q & (equal_3700 & less_3701)));
  // hls/stages/agreement.hpp:1157
  logic and_3710;
  assign and_3710 = x_s3_q[6] & (not_2000_s3_q & (less_3701 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:798
  logic and_3711;
  assign and_3711 = equal_583_s3_q & and_3710;
  // hls/stages/patches.hpp:633
  logic [7:0] or_3713;
  assign or_3713 = (and_3705 ? patches_quarters_0_places_q : 8'h0) | (and_3711 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1157
  logic and_3717;
  assign and_3717 = x_s3_q[6] & (not_2000_s3_q & (less_3701 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:798
  logic and_3718;
  assign and_3718 = equal_583_s3_q & and_3717;
  // hls/stages/agreement.hpp:1157
  logic and_3724;
  assign and_3724 = x_s3_q[6] & (not_2000_s3_q & (less_3701 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:798
  logic and_3725;
  assign and_3725 = equal_583_s3_q & and_3724;
  // hls/stages/patches.hpp:633
  logic [7:0] or_3727;
  assign or_3727 = (or_3713 | (and_3718 ? patches_quarters_2_places_q : 8'h0)) | (and_3725 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:203
  logic select_3731;
  assign select_3731 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:798
  logic and_3735;
  assign and_3735 = equal_583_s3_q & (x_s3_q[6] & (not_2000_s3_q & (less_3701 & select_3731)));
  // hls/stages/patches.hpp:634
  logic [7:0] select_3737;
  assign select_3737 = and_3705 ? (and_3735 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3739;
  assign select_3739 = and_3711 ? (and_3735 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3742;
  assign select_3742 = and_3718 ? (and_3735 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3745;
  assign select_3745 = and_3725 ? (and_3735 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:635
  logic [7:0] select_3748;
  assign select_3748 = and_3705 ? (and_3735 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3750;
  assign select_3750 = and_3711 ? (and_3735 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3753;
  assign select_3753 = and_3718 ? (and_3735 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3756;
  assign select_3756 = and_3725 ? (and_3735 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:206
  logic [4:0] sum_3758;
  assign sum_3758 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1157
  logic and_3762;
  assign and_3762 = x_s3_q[6] & (not_2000_s3_q & (less_3701 & (sum_3758[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:798
  logic and_3763;
  assign and_3763 = equal_583_s3_q & and_3762;
  // hls/stages/patches.hpp:630
  logic [7:0] select_3766;
  assign select_3766 = and_3763 ? (patches_word_places_q + (and_3711 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3769;
  assign select_3769 = and_3763 ? (patches_word_up_q + (and_3711 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3772;
  assign select_3772 = and_3763 ? (patches_word_down_q + (and_3711 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:189
  logic [5:0] select_3775;
  assign select_3775 = ($signed(difference_3660[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3660[5:0];
  logic [5:0] select_3776;
  assign select_3776 = ($signed(14'h10) < $signed(difference_3660)) ? 6'h10 : select_3775;
  // hls/stages/patches.hpp:673
  logic [5:0] select_3777;
  assign select_3777 = and_3624 ? select_3776 : 6'h0;
  // hls/stages/patches.hpp:674
  logic [11:0] select_3779;
  assign select_3779 = patches_round_ends_q ? {{6{select_3777[5]}}, select_3777} : (patches_across_q + {{6{select_3777[5]}}, select_3777});
  // hls/stages/agreement.hpp:798
  logic and_3783;
  assign and_3783 = equal_583_s3_q & (x_s3_q[6] & (not_2000_s3_q & (equal_2941 & less_3701)));
  // hls/stages/agreement.hpp:1157
  logic and_3787;
  assign and_3787 = x_s3_q[6] & (not_2000_s3_q & (less_3701 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:798
  logic and_3788;
  assign and_3788 = equal_583_s3_q & and_3787;
  // hls/stages/patches.hpp:657
  logic [7:0] select_3790;
  assign select_3790 = and_3783 ? (and_3788 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:659
  logic or_3794;
  assign or_3794 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:660
  logic or_3797;
  assign or_3797 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:661
  logic [8:0] sum_3798;
  assign sum_3798 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:656
  logic select_3800;
  assign select_3800 = and_3783 ? (and_3788 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:192
  logic and_3802;
  assign and_3802 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:656
  logic [2:0] select_3804;
  assign select_3804 = and_3788 ? {and_3802, patches_found_q[2:1]} : (and_3783 ? {and_3802, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:655
  logic or_3808;
  assign or_3808 = patches_partly_q | (patches_doubted_q & (~and_3788));
  // hls/stages/patches.hpp:656
  logic select_3811;
  assign select_3811 = and_3783 ? (and_3788 ? or_3808 : (and_3783 ? or_3808 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:654
  logic select_3812;
  assign select_3812 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:643
  logic [7:0] select_3816;
  assign select_3816 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:612
  logic [10:0] sum_3818;
  assign sum_3818 = {sum_3658[6], sum_3658, patches_peak_best_column_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:674
  logic and_3820;
  assign and_3820 = ({{5{sum_3818[10]}}, sum_3818} < 16'h3) & and_3624;
  logic [7:0] sum_3821;
  assign sum_3821 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3820};
  // hls/stages/patches.hpp:663
  logic [12:0] product_3826;
  assign product_3826 = {8'h0, patches_on_skin_limit_q} * {5'h0, select_3790};
  // hls/stages/patches.hpp:192
  logic and_3828;
  assign and_3828 = (~(patches_on_skin_q[7:2] == 6'h0)) & (product_3826[12:5] < patches_on_skin_q);
  logic select_3833;
  assign select_3833 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:644
  logic or_3837;
  assign or_3837 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:645
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:646
  logic select_3844;
  assign select_3844 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:647
  logic and_3850;
  assign and_3850 = moments_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3851;
  assign sum_3851 = patches_age_q + {9'h0, and_3850};
  logic [9:0] select_3854;
  assign select_3854 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3851)) : sum_3851;
  // hls/stages/agreement.hpp:1203
  logic or_3912;
  assign or_3912 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1232
  logic equal_3914;
  assign equal_3914 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1241
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1242
  logic select_3920;
  assign select_3920 = (equal_3914 & equal_3700) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1150
  logic [10:0] sum_3923;
  assign sum_3923 = {1'b0, select_2691} + {2'h0, select_2691[9:1]};
  logic select_3926;
  assign select_3926 = (select_2688[9:3] == 7'h0) ? ((~or_3912) & (~select_3920)) : (~({sum_3923, select_2691[0]} < {2'h0, select_2688}));
  // hls/stages/agreement.hpp:1157
  logic [47:0] select_3928;
  assign select_3928 = x_s3_q[6] ? (equal_1620_s3_q ? good_q : {select_3926, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:798
  logic select_3933;
  assign select_3933 = equal_583_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3931_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1232
  logic equal_3934;
  assign equal_3934 = x_s3_q[6:3] == 4'ha;
  logic equal_3936;
  assign equal_3936 = x_s3_q[6:3] == 4'hc;
  logic equal_3937;
  assign equal_3937 = x_s3_q[6:3] == 4'hb;
  logic equal_3938;
  assign equal_3938 = x_s3_q[6:3] == 4'h9;
  logic equal_3939;
  assign equal_3939 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1140
  logic [13:0] select_3941;
  assign select_3941 = equal_3938 ? counts_skin_unproven_q : (equal_3939 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3943;
  assign select_3943 = equal_3937 ? counts_regions_bad_q : (equal_3934 ? counts_nearer_q : select_3941);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3936 ? counts_on_skin_q : select_3943;
  // hls/stages/agreement.hpp:1237
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1245
  logic select_3946;
  assign select_3946 = (equal_3934 & equal_3700) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1163
  logic not_3947;
  assign not_3947 = ~hidden_for_q[7];
  logic [7:0] select_3949;
  assign select_3949 = select_3946 ? (hidden_for_q + {7'h0, not_3947}) : 8'h0;
  // hls/stages/agreement.hpp:798
  logic [7:0] select_3951;
  assign select_3951 = equal_583_s3_q ? (equal_3931_s3_q ? select_3949 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1246
  logic [13:0] select_3952;
  assign select_3952 = equal_3700 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1140
  logic [7:0] select_3954;
  assign select_3954 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3956;
  assign select_3956 = equal_3939 ? cfg_unproven_skin_limit_i : (equal_3914 ? cfg_unproven_limit_i : select_3954);
  logic [7:0] select_3958;
  assign select_3958 = equal_3934 ? cfg_regions_limit_i : (equal_3938 ? cfg_hidden_limit_i : select_3956);
  logic [7:0] limit;
  assign limit = equal_3936 ? cfg_regions_limit_i : (equal_3937 ? {cfg_on_skin_limit_i, 3'h0} : select_3958);
  // hls/stages/agreement.hpp:1246
  logic not_3961;
  assign not_3961 = ~x_s3_q[2];
  logic [3:0] select_3962;
  assign select_3962 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3961, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3961};
  logic [7:0] select_3963;
  assign select_3963 = x_s3_q[0] ? {select_3962[3], 1'b0, select_3962[2], 1'b0, select_3962[1], 1'b0, select_3962[0], 1'b0} : {1'b0, select_3962[3], 1'b0, select_3962[2], 1'b0, select_3962[1], 1'b0, select_3962[0]};
  // hls/stages/agreement.hpp:1140
  logic [13:0] select_3967;
  assign select_3967 = equal_3938 ? counts_skin_supervised_q : (equal_3939 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3969;
  assign select_3969 = equal_3937 ? counts_skin_textured_q : (equal_3934 ? counts_textured_q : select_3967);
  logic [13:0] of;
  assign of = equal_3936 ? counts_textured_q : select_3969;
  // hls/stages/agreement.hpp:1246
  logic [13:0] select_3971;
  assign select_3971 = ((limit & select_3963) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3952} + {1'b0, select_3971};
  // hls/stages/agreement.hpp:798
  logic select_3976;
  assign select_3976 = equal_583_s3_q ? (equal_3700 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1243
  logic and_3981;
  assign and_3981 = too_much_q & (~(equal_3939 & equal_3700));
  // hls/stages/agreement.hpp:1244
  logic select_3986;
  assign select_3986 = (over[14] & equal_3700) ? (and_3981 | ((equal_3939 | equal_3938) | (x_s3_q[6:3] == 4'hf))) : and_3981;
  // hls/stages/agreement.hpp:1140
  logic and_3991;
  assign and_3991 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1246
  logic select_3992;
  assign select_3992 = (equal_3936 & equal_3700) ? and_3991 : overlooks_q;
  // hls/stages/agreement.hpp:798
  logic [2:0] select_3994;
  assign select_3994 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_3996;
  assign select_3996 = equal_583_s3_q ? box_textured_columns_values_0_q : (so_s3_q ? select_3994 : box_textured_columns_values_0_q);
  logic [2:0] select_3997;
  assign select_3997 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3999;
  assign select_3999 = equal_583_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3997 : box_textured_columns_values_1_q);
  logic [2:0] select_4000;
  assign select_4000 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4002;
  assign select_4002 = equal_583_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_4000 : box_textured_columns_values_2_q);
  logic [2:0] select_4003;
  assign select_4003 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4005;
  assign select_4005 = equal_583_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_4003 : box_textured_columns_values_3_q);
  logic [2:0] select_4006;
  assign select_4006 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4008;
  assign select_4008 = equal_583_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_4006 : box_textured_columns_values_4_q);
  logic [4:0] select_4010;
  assign select_4010 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4012;
  assign select_4012 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4014;
  assign select_4014 = equal_583_s3_q ? box_explained_columns_values_0_q : (so_s3_q ? select_4012 : box_explained_columns_values_0_q);
  logic [2:0] select_4015;
  assign select_4015 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4017;
  assign select_4017 = equal_583_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_4015 : box_explained_columns_values_1_q);
  logic [2:0] select_4018;
  assign select_4018 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4020;
  assign select_4020 = equal_583_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_4018 : box_explained_columns_values_2_q);
  logic [2:0] select_4021;
  assign select_4021 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4023;
  assign select_4023 = equal_583_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_4021 : box_explained_columns_values_3_q);
  logic [2:0] select_4024;
  assign select_4024 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4026;
  assign select_4026 = equal_583_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_4024 : box_explained_columns_values_4_q);
  logic [4:0] select_4028;
  assign select_4028 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4031;
  assign select_4031 = so_s3_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4033;
  assign select_4033 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4035;
  assign select_4035 = equal_583_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_4033 : box_shown_columns_values_1_q);
  logic [2:0] select_4036;
  assign select_4036 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4038;
  assign select_4038 = equal_583_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_4036 : box_shown_columns_values_2_q);
  logic [2:0] select_4039;
  assign select_4039 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4041;
  assign select_4041 = equal_583_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_4039 : box_shown_columns_values_3_q);
  logic [2:0] select_4042;
  assign select_4042 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4044;
  assign select_4044 = equal_583_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_4042 : box_shown_columns_values_4_q);
  logic [4:0] select_4046;
  assign select_4046 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4049;
  assign select_4049 = so_s3_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4051;
  assign select_4051 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4053;
  assign select_4053 = equal_583_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_4051 : box_nearer_columns_values_1_q);
  logic [2:0] select_4054;
  assign select_4054 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4056;
  assign select_4056 = equal_583_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_4054 : box_nearer_columns_values_2_q);
  logic [2:0] select_4057;
  assign select_4057 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4059;
  assign select_4059 = equal_583_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_4057 : box_nearer_columns_values_3_q);
  logic [2:0] select_4060;
  assign select_4060 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4062;
  assign select_4062 = equal_583_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_4060 : box_nearer_columns_values_4_q);
  logic [4:0] select_4064;
  assign select_4064 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1324
  logic [1:0] select_4154;
  assign select_4154 = and_4153_s3_q ? {and_2144, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:443
  logic select_4158;
  assign select_4158 = and_2070_s3_q ? (less_2071_s3_q ? (select_4154[0] & and_4155_s3_q) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:279
  logic select_4160;
  assign select_4160 = left_first_s3_q ? select_4158 : (and_1981_s3_q ? select_4158 : seen_q);
  logic select_4161;
  assign select_4161 = and_1981_s3_q ? select_4160 : seen_q;
  // hls/stages/agreement.hpp:443
  logic select_4164;
  assign select_4164 = and_2070_s3_q ? (less_2071_s3_q ? (select_4154[1] & and_4155_s3_q) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:279
  logic select_4166;
  assign select_4166 = left_first_s3_q ? select_4164 : (and_1981_s3_q ? select_4164 : nearer_q);
  logic select_4167;
  assign select_4167 = and_1981_s3_q ? select_4166 : nearer_q;
  // hls/stages/agreement.hpp:1254
  logic or_4174;
  assign or_4174 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4173_s3_q;
  // hls/stages/agreement.hpp:1256
  logic not_4182;
  assign not_4182 = ~(or_3912 | not_2370);
  // hls/stages/agreement.hpp:798
  logic and_4186;
  assign and_4186 = equal_583_s3_q & (equal_3931_s3_q & (not_4182 & (select_3920 | select_3986)));
  logic and_4189;
  assign and_4189 = equal_3931_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1165
  logic or_4193;
  assign or_4193 = select_2478 | (select_2490 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:798
  logic and_4200;
  assign and_4200 = equal_583_s3_q & (equal_3931_s3_q & (not_4182 & (select_2484 | select_2496)));
  // hls/stages/agreement.hpp:1165
  logic and_4205;
  assign and_4205 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3949 < cfg_hidden_frames_i));
  logic select_4211;
  assign select_4211 = (not_2370 | (select_3992 & not_3823)) ? cfg_prove_i : patches_overlooked_q;
  logic and_4215;
  assign and_4215 = cfg_prove_i & (moments_out_of_step_q | moments_other_field_out_of_step_q);
  // hls/stages/agreement.hpp:798
  logic and_4221;
  assign and_4221 = equal_583_s3_q & (x_s3_q[6] & (not_2000_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1155
  logic [31:0] select_4229;
  assign select_4229 = equal_1642_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4227_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4230;
  assign select_4230 = equal_1640_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4229;
  logic [31:0] select_4231;
  assign select_4231 = equal_1638_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4230;
  logic [31:0] select_4232;
  assign select_4232 = equal_1636_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4231;
  logic [31:0] select_4233;
  assign select_4233 = equal_1634_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4232;
  logic [31:0] select_4234;
  assign select_4234 = equal_1632_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4233;
  logic [31:0] select_4235;
  assign select_4235 = equal_1630_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4234;
  logic [31:0] select_4236;
  assign select_4236 = equal_1628_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4235;
  // hls/stages/agreement.hpp:1153
  logic [9:0] select_4237;
  assign select_4237 = less_2687 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1157
  logic [31:0] select_4238;
  assign select_4238 = equal_1620_s3_q ? select_4236 : {2'h0, select_4237, select_2691, select_2688};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = last_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_556_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_758_s3_q, and_757, less_752_s3_q, and_751_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_745, and_721_s3_q, and_720_s3_q, and_695_s3_q, less_687_s3_q, less_686_s3_q, less_685_s3_q, less_684_s3_q, less_683_s3_q, less_682_s3_q, less_681_s3_q, less_680_s3_q, less_679_s3_q, less_678_s3_q, less_677_s3_q, less_676_s3_q, less_675_s3_q, less_674_s3_q, less_673_s3_q, less_672_s3_q, less_671_s3_q, less_670_s3_q, less_669_s3_q, less_668_s3_q, less_667_s3_q, less_666_s3_q, less_665_s3_q, less_664_s3_q};
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
  assign registration_sums_waddr = {sum_1626_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1685_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1684, sum_1680};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_1711_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_1788_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1760_s3_q};
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
  assign patches_right_0_waddr = {select_1819_s3_q, select_1816};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_1828);
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
  assign patches_right_1_waddr = {select_1819_s3_q, select_1844};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1847);
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
  assign patches_left_waddr = {select_1866, select_1865_s3_q, column_4};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1872);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1988;
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
  assign regions_waddr = {region_row_s3_q, or_1998_s3_q, or_1995_s3_q, or_1992_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2036_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_2035, sum_2024, sum_2018};
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
  assign map_waddr = sum_2080_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2156_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2144, is_seen};
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
      hidden_for_q <= 8'h0;
      product_q <= 14'h0;
      product_rest_q <= 1'b0;
      disagree_q <= 1'b0;
      too_much_q <= 1'b0;
      hides_q <= 1'b0;
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s3_en) begin
      census_left_misses_q <= select_2308;
      sharpness_before_last_mask_q <= select_2392;
      sharpness_sums_detail_0_q <= and_556_s3_q ? select_2406 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_556_s3_q ? select_2418 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_556_s3_q ? sum_2422 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_556_s3_q ? sum_2426 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= so_s3_q ? select_2444 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= so_s3_q ? select_2454 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= so_s3_q ? select_2456 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= so_s3_q ? select_2458 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= so_s3_q ? select_2460 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= so_s3_q ? select_2462 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2467;
      sharpness_comparing_carry_1_q <= so_s3_q ? select_2470 : sharpness_comparing_carry_1_q;
      sharpness_comparing_less_detail_0_q <= select_2478;
      sharpness_comparing_less_detail_1_q <= select_2484;
      sharpness_comparing_less_contrast_0_q <= select_2490;
      sharpness_comparing_less_contrast_1_q <= select_2496;
      counts_supervised_q <= select_2643;
      counts_textured_q <= and_2634_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2646});
      counts_explained_q <= and_2634_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2651});
      counts_nearer_q <= and_2634_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2656});
      counts_unproven_q <= and_2634_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2684});
      counts_regions_bad_q <= select_2700;
      counts_skin_supervised_q <= select_2708;
      counts_skin_textured_q <= select_2715;
      counts_skin_unproven_q <= select_2723;
      counts_on_skin_q <= select_2743;
      registration_half_across_q <= select_2823;
      registration_half_measured_q <= select_2828;
      registration_half_votes_down_q <= and_2801_s3_q ? 7'h0 : sum_2834;
      registration_half_votes_up_q <= and_2801_s3_q ? 7'h0 : sum_2842;
      registration_half_half_votes_down_q <= and_2801_s3_q ? 7'h0 : sum_2849;
      registration_half_half_votes_up_q <= and_2801_s3_q ? 7'h0 : sum_2856;
      registration_down_q <= and_2889 ? sum_2908 : registration_down_q;
      registration_up_q <= and_2889 ? sum_2917 : registration_up_q;
      registration_enough_q <= select_2931;
      registration_votes_down_q <= and_2936 ? less_2937 : registration_votes_down_q;
      registration_votes_up_q <= and_2936 ? less_2939 : registration_votes_up_q;
      registration_other_enough_q <= and_2945 ? select_2931 : registration_other_enough_q;
      registration_other_down_q <= and_2945 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2945 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_583_s3_q & and_2952)) & or_2977;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1807 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1810 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1811 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3060;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1836 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1838 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1839 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3065;
      patches_valid_0_q <= select_3070;
      patches_valid_1_q <= select_3075;
      patches_right_next_0_q <= select_3078;
      patches_right_next_1_q <= select_3081;
      patches_left_next_0_q <= select_3084;
      patches_left_next_1_q <= select_3087;
      patches_sums_values_0_q <= select_3511;
      patches_sums_values_1_q <= equal_1789_s3_q ? patches_sums_values_1_q : select_3512;
      patches_sums_values_2_q <= equal_1789_s3_q ? patches_sums_values_2_q : select_3514;
      patches_sums_values_3_q <= equal_1789_s3_q ? patches_sums_values_3_q : select_3516;
      patches_sums_values_4_q <= equal_1789_s3_q ? patches_sums_values_4_q : select_3518;
      patches_sums_values_5_q <= equal_1789_s3_q ? patches_sums_values_5_q : select_3520;
      patches_sums_values_6_q <= equal_1789_s3_q ? patches_sums_values_6_q : select_3522;
      patches_sums_values_7_q <= equal_1789_s3_q ? patches_sums_values_7_q : select_3524;
      patches_sums_values_8_q <= equal_1789_s3_q ? patches_sums_values_8_q : select_3526;
      patches_sums_values_9_q <= equal_1789_s3_q ? patches_sums_values_9_q : select_3528;
      patches_sums_values_10_q <= equal_1789_s3_q ? patches_sums_values_10_q : select_3530;
      patches_sums_values_11_q <= equal_1789_s3_q ? patches_sums_values_11_q : select_3532;
      patches_sums_values_12_q <= equal_1789_s3_q ? patches_sums_values_12_q : select_3534;
      patches_sums_values_13_q <= equal_1789_s3_q ? patches_sums_values_13_q : select_3536;
      patches_sums_values_14_q <= equal_1789_s3_q ? patches_sums_values_14_q : select_3538;
      patches_sums_values_15_q <= equal_1789_s3_q ? patches_sums_values_15_q : select_3540;
      patches_sums_values_16_q <= equal_1789_s3_q ? patches_sums_values_16_q : select_3542;
      patches_best_differing_q <= select_1988[9:0];
      patches_best_column_q <= select_1988[14:10];
      patches_quarters_0_places_q <= sum_3629;
      patches_quarters_0_up_q <= sum_3664;
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
      patches_on_skin_limit_q <= cfg_on_skin_limit_i;
      patches_word_places_q <= or_3727;
      patches_word_up_q <= ((select_3737 | select_3739) | select_3742) | select_3745;
      patches_word_down_q <= ((select_3748 | select_3750) | select_3753) | select_3756;
      patches_sum_places_q <= select_3766;
      patches_sum_up_q <= select_3769;
      patches_sum_down_q <= select_3772;
      patches_across_q <= select_3779;
      patches_places_q <= select_3790;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3794;
      patches_partly_q <= or_3797;
      patches_clear_limit_q <= sum_3798[8:2];
      patches_complete_q <= select_3800;
      patches_round_ends_q <= patches_complete_q & moments_ended_q;
      patches_found_q <= and_3783 ? select_3804 : patches_found_q;
      patches_doubted_q <= select_3811;
      patches_doubted_before_q <= select_3812;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3816;
      patches_on_skin_q <= sum_3821;
      patches_large_q <= not_3823 & and_3828;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3833;
      patches_spoiled_q <= or_3837;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3844;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3854;
      segment_textured_q <= select_2015 + {5'h0, and_2646};
      segment_explained_q <= select_2021 + {5'h0, and_2651};
      segment_nearer_q <= select_2032 + {5'h0, and_2656};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_583_s3_q ? select_3928 : good_q;
      good_known_q <= select_3933;
      hidden_for_q <= select_3951;
      product_q <= equal_583_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3976;
      disagree_q <= equal_583_s3_q ? select_3920 : disagree_q;
      too_much_q <= equal_583_s3_q ? select_3986 : too_much_q;
      hides_q <= equal_583_s3_q ? select_3946 : hides_q;
      overlooks_q <= equal_583_s3_q ? select_3992 : overlooks_q;
      seen_q <= select_4161;
      nearer_q <= select_4167;
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
      averager_quarter_1_0_q <= select_2182;
      averager_quarter_1_1_q <= select_2184;
      averager_quarter_2_0_q <= select_2186;
      averager_quarter_2_1_q <= select_2188;
      averager_detail_0_q <= select_2200;
      averager_detail_1_q <= select_2208;
      census_changes_values_0_left_q <= and_556_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_556_s3_q ? sum_2292 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2294;
      census_changes_values_1_right_q <= select_2295;
      census_changes_values_2_left_q <= select_2296;
      census_changes_values_2_right_q <= select_2297;
      sharpness_last_mask_q <= and_556_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_556_s3_q ? select_2389[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_556_s3_q ? select_2389[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_3996;
      box_textured_columns_values_1_q <= select_3999;
      box_textured_columns_values_2_q <= select_4002;
      box_textured_columns_values_3_q <= select_4005;
      box_textured_columns_values_4_q <= select_4008;
      box_textured_sum_sums_values_0_q <= equal_583_s3_q ? box_textured_sum_sums_values_0_q : select_4010;
      box_explained_columns_values_0_q <= select_4014;
      box_explained_columns_values_1_q <= select_4017;
      box_explained_columns_values_2_q <= select_4020;
      box_explained_columns_values_3_q <= select_4023;
      box_explained_columns_values_4_q <= select_4026;
      box_explained_sum_sums_values_0_q <= equal_583_s3_q ? box_explained_sum_sums_values_0_q : select_4028;
      box_shown_columns_values_0_q <= equal_583_s3_q ? box_shown_columns_values_0_q : select_4031;
      box_shown_columns_values_1_q <= select_4035;
      box_shown_columns_values_2_q <= select_4038;
      box_shown_columns_values_3_q <= select_4041;
      box_shown_columns_values_4_q <= select_4044;
      box_shown_sum_sums_values_0_q <= equal_583_s3_q ? box_shown_sum_sums_values_0_q : select_4046;
      box_nearer_columns_values_0_q <= equal_583_s3_q ? box_nearer_columns_values_0_q : select_4049;
      box_nearer_columns_values_1_q <= select_4053;
      box_nearer_columns_values_2_q <= select_4056;
      box_nearer_columns_values_3_q <= select_4059;
      box_nearer_columns_values_4_q <= select_4062;
      box_nearer_sum_sums_values_0_q <= equal_583_s3_q ? box_nearer_sum_sums_values_0_q : select_4064;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4105_s4_q;
  logic or_4168_s4_q;
  logic and_4169_s4_q;
  logic and_4177_s4_q;
  logic and_4180_s4_q;
  logic and_4186_s4_q;
  logic and_4190_s4_q;
  logic and_4196_s4_q;
  logic and_4200_s4_q;
  logic and_4208_s4_q;
  logic and_4213_s4_q;
  logic and_4217_s4_q;
  logic and_4221_s4_q;
  logic [5:0] select_4223_s4_q;
  logic [31:0] select_4240_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4105_s4_q <= and_4105_s3_q;
      or_4168_s4_q <= not_2370 | select_4161;
      and_4169_s4_q <= cfg_prove_i & select_4167;
      and_4177_s4_q <= equal_583_s3_q & (equal_3931_s3_q & (cfg_prove_i & or_4174));
      and_4180_s4_q <= equal_583_s3_q & (equal_3931_s3_q & (cfg_prove_i & or_3912));
      and_4186_s4_q <= and_4186;
      and_4190_s4_q <= equal_583_s3_q & and_4189;
      and_4196_s4_q <= equal_583_s3_q & (equal_3931_s3_q & (not_4182 & or_4193));
      and_4200_s4_q <= and_4200;
      and_4208_s4_q <= equal_583_s3_q & (equal_3931_s3_q & (cfg_prove_i & and_4205));
      and_4213_s4_q <= equal_583_s3_q & (equal_3931_s3_q & select_4211);
      and_4217_s4_q <= equal_583_s3_q & (equal_3931_s3_q & and_4215);
      and_4221_s4_q <= and_4221;
      select_4223_s4_q <= equal_583_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4240_s4_q <= equal_583_s3_q ? (x_s3_q[6] ? select_4238 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4168_s4_q;
  assign marks_nearer_o = and_4169_s4_q;
  assign verdict_valid_o = and_4105_s4_q;
  assign verdict_unproven_yet_o = and_4177_s4_q;
  assign verdict_untextured_o = and_4180_s4_q;
  assign verdict_disagree_o = and_4186_s4_q;
  assign verdict_moved_o = and_4190_s4_q;
  assign verdict_unsharp_left_o = and_4196_s4_q;
  assign verdict_unsharp_right_o = and_4200_s4_q;
  assign verdict_hidden_o = and_4208_s4_q;
  assign verdict_overlooked_o = and_4213_s4_q;
  assign verdict_out_of_step_o = and_4217_s4_q;
  assign frame_valid_o = and_4221_s4_q;
  assign frame_index_o = select_4223_s4_q;
  assign frame_word_o = select_4240_s4_q;
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
  assign unused_bits = ^{over[13:0], sum_3862[6:0], product_3826[4:0], sum_3798[1:0], sum_3758[1:0], product_3659[4:0], sum_2791[0], difference_2729[1:0], detail_4[1:0], detail_3[1:0], sum_2302[4:0], sum_1727[0], sum_1723[0], sum_743[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
