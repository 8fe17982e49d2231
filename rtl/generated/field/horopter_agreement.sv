// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 3061 bits, pipeline 851 bits, memories 66527 bits.
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
  logic [7:0] last;
  assign last = {2'h0, cfg_width_i[8:3]} + 8'hff;
  logic [5:0] sum_2522;
  assign sum_2522 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3582;
  assign difference_3582 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3798;
  assign not_3798 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3855;
  assign difference_3855 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4101;
  assign less_4101 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4102;
  assign sum_4102 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_4103;
  assign select_4103 = less_4101 ? {sum_4102, cfg_height_i[5:3]} : 8'h0;
  logic not_4138;
  assign not_4138 = ~cfg_prove_i;

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
  logic [2:0] select_496;
  assign select_496 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_498;
  assign select_498 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:116
  logic [7:0] select_501;
  assign select_501 = ({select_498, select_496} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:117
  logic [7:0] select_502;
  assign select_502 = select_496[0] ? averager_place_q : select_501;
  // hls/stages/census.hpp:42
  logic or_503;
  assign or_503 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:417
  logic and_506;
  assign and_506 = (select_496[0] & or_503) & (select_502 < 8'hbd);
  // hls/stages/census.hpp:42
  logic [2:0] select_511;
  assign select_511 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_498 : 6'h0;
  // hls/stages/census.hpp:51
  logic equal_528;
  assign equal_528 = select_496 == 3'h7;
  // hls/stages/census.hpp:54
  logic equal_529;
  assign equal_529 = select_511 == 3'h7;
  // hls/stages/census.hpp:127
  logic and_530;
  assign and_530 = equal_529 & and_506;
  // hls/stages/agreement.hpp:276
  logic and_532;
  assign and_532 = sample_pair_whole_q & (equal_528 & and_530);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:623
  logic equal_560;
  assign equal_560 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:594
  logic or_561;
  assign or_561 = so | equal_560;
  // hls/stages/agreement.hpp:592
  logic [7:0] sum_562;
  assign sum_562 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:594
  logic [7:0] select_563;
  assign select_563 = run_shift_q[5] ? x_q : sum_562;
  logic less_564;
  assign less_564 = {2'h0, last_q} < select_563;
  // hls/stages/agreement.hpp:226
  logic not_565;
  assign not_565 = ~less_564;
  // hls/stages/agreement.hpp:614
  logic equal_575;
  assign equal_575 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:615
  logic equal_576;
  assign equal_576 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_577;
  assign and_577 = equal_576 & not_565;
  logic select_579;
  assign select_579 = or_561 ? not_565 : (equal_575 ? not_565 : and_577);
  // hls/stages/agreement.hpp:798
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:796
  logic [6:0] sum_593;
  assign sum_593 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:149
  logic and_598;
  assign and_598 = equal_575 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_593} < select_563))));
  logic select_599;
  assign select_599 = or_561 ? not_565 : and_598;
  // hls/stages/agreement.hpp:821
  logic [5:0] right;
  assign right = sum_562[5:0] + 6'h3d;
  // hls/stages/agreement.hpp:720
  logic not_629;
  assign not_629 = ~or_561;
  // hls/stages/agreement.hpp:149
  logic and_632;
  assign and_632 = not_629 & ((~equal_575) & and_577);
  // hls/stages/census.hpp:42
  logic [5:0] select_659;
  assign select_659 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_659 : 6'h0;
  // hls/stages/patches.hpp:122
  logic and_1657;
  assign and_1657 = (select_496 == 3'h0) & (select_498 == 6'h0);
  // hls/stages/patches.hpp:391
  logic not_1658;
  assign not_1658 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_1661;
  assign not_1661 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:361
  logic and_1662;
  assign and_1662 = patches_capturing_q & not_1661;
  // hls/stages/patches.hpp:363
  logic equal_1663;
  assign equal_1663 = {or_503, select_511} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_1665;
  assign equal_1665 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1670;
  assign and_1670 = (not_1658 & (patches_work_q == 3'h0)) & (~(and_1662 | ((~equal_1663) | (~equal_1665))));
  // hls/stages/patches.hpp:529
  logic equal_1758;
  assign equal_1758 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:507
  logic not_1759;
  assign not_1759 = ~equal_1758;
  // hls/stages/patches.hpp:500
  logic equal_1760;
  assign equal_1760 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:453
  logic not_1761;
  assign not_1761 = ~equal_1760;
  // hls/stages/patches.hpp:494
  logic equal_1762;
  assign equal_1762 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1763;
  assign equal_1763 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:529
  logic or_1764;
  assign or_1764 = equal_1762 | equal_1763;
  // hls/stages/patches.hpp:455
  logic not_1765;
  assign not_1765 = ~patches_second_q;
  // hls/stages/patches.hpp:372
  logic [4:0] select_1787;
  assign select_1787 = and_1670 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1788;
  assign select_1788 = and_1657 ? select_1787 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1790;
  assign and_1790 = and_1662 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1794;
  assign select_1794 = and_1657 ? (and_1670 | (and_1662 & (~and_1790))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_1802;
  assign and_1802 = not_1759 & (not_1761 & (or_1764 & (patches_second_q & equal_1763)));
  // hls/stages/patches.hpp:167
  logic not_1819;
  assign not_1819 = ~equal_1763;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_1835;
  assign select_1835 = and_1657 ? {select_1787[4], select_1787[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:453
  logic and_1845;
  assign and_1845 = not_1759 & (or_1764 & not_1761);
  // hls/stages/agreement.hpp:190
  logic and_1938;
  assign and_1938 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2109;
  assign select_2109 = sample_pair_whole_q ? (sample_last_q ? (select_511 + 3'h1) : select_511) : raster_at_y_q;
  logic [5:0] select_2111;
  assign select_2111 = sample_pair_whole_q ? (select_498 + {5'h0, equal_528}) : raster_at_column_q;
  logic [5:0] select_2114;
  assign select_2114 = sample_pair_whole_q ? (sample_last_q ? (select_659 + {5'h0, equal_529}) : select_659) : raster_at_row_q;
  logic select_2118;
  assign select_2118 = sample_pair_whole_q ? (sample_last_q ? (or_503 & (~raster_final_row_q)) : or_503) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2120;
  assign select_2120 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2124;
  assign select_2124 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:459
  logic equal_2428;
  assign equal_2428 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:464
  logic and_2429;
  assign and_2429 = and_532 & equal_2428;
  // hls/stages/agreement.hpp:523
  logic select_2432;
  assign select_2432 = (and_2429 | (~ends_cell_q)) ? and_2429 : ends_q;
  // hls/stages/agreement.hpp:529
  logic [2:0] now;
  assign now = select_2432 ? (and_2429 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:534
  logic [5:0] select_2436;
  assign select_2436 = select_2432 ? (and_2429 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2439;
  assign select_2439 = select_2432 ? (following_last_shift_q & (~and_2429)) : run_last_shift_q;
  // hls/stages/agreement.hpp:607
  logic and_2442;
  assign and_2442 = run_last_shift_q & equal_575;
  // hls/stages/agreement.hpp:616
  logic select_2444;
  assign select_2444 = equal_575 ? (~run_last_shift_q) : equal_576;
  // hls/stages/agreement.hpp:620
  logic equal_2445;
  assign equal_2445 = run_phase_q == 3'h1;
  logic not_2448;
  assign not_2448 = ~select_2444;
  // hls/stages/agreement.hpp:623
  logic equal_2450;
  assign equal_2450 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:607
  logic and_2451;
  assign and_2451 = final_row_q & so;
  // hls/stages/agreement.hpp:620
  logic [1:0] select_2452;
  assign select_2452 = equal_2450 ? 2'h1 : {2{and_2451}};
  logic [2:0] select_2454;
  assign select_2454 = (and_2442 | (select_2444 | equal_2445)) ? (equal_2445 ? 3'h2 : {not_2448, {2{select_2444}}}) : (equal_560 ? 3'h6 : {select_2452[0], select_2452});
  // hls/stages/agreement.hpp:607
  logic and_2457;
  assign and_2457 = select_2444 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:630
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2460;
  assign select_2460 = (plan_shift_q[5] & select_2444) ? value : 7'h0;
  logic [1:0] or_2461;
  assign or_2461 = {2{so}} | select_2460[5:4];
  // hls/stages/agreement.hpp:633
  logic [7:0] select_2462;
  assign select_2462 = select_2444 ? plan_columns_q : 8'h0;
  logic [6:0] or_2465;
  assign or_2465 = select_2462[6:0] | ((equal_2445 | equal_2450) ? whole_q : 7'h0);
  logic [1:0] or_2466;
  assign or_2466 = {2{and_2442}} | or_2465[3:2];
  // hls/stages/agreement.hpp:634
  logic [6:0] or_2468;
  assign or_2468 = {or_2465[6:4], or_2466, or_2465[1:0]} | (equal_560 ? drawn_q : 7'h0);
  logic [4:0] or_2469;
  assign or_2469 = {5{so}} | {or_2468[6], or_2468[3:0]};
  // hls/stages/agreement.hpp:640
  logic not_2473;
  assign not_2473 = ~run_shift_q[5];
  logic [6:0] difference_2475;
  assign difference_2475 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2476;
  assign select_2476 = equal_575 ? ({{7{not_2473}}, 1'b1} + run_span_q) : {difference_2475[6], difference_2475};
  // hls/stages/agreement.hpp:523
  logic [6:0] select_2480;
  assign select_2480 = and_2429 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:526
  logic [7:0] select_2482;
  assign select_2482 = select_2432 ? {select_2480[6], select_2480} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2485;
  assign select_2485 = select_2432 ? (and_2429 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:520
  logic [5:0] select_2493;
  assign select_2493 = and_532 ? (equal_2428 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2496;
  assign select_2496 = and_532 ? (equal_2428 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2499;
  assign select_2499 = and_532 ? (equal_2428 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:531
  logic select_2513;
  assign select_2513 = (ends_cell_q | select_2432) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_575 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:526
  logic and_2517;
  assign and_2517 = (~select_2432) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:476
  logic [6:0] sum_2518;
  assign sum_2518 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:460
  logic select_2520;
  assign select_2520 = equal_2428 ? ({sum_2518[6], cfg_height_i[8:3]} == {1'b0, sum_2518[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2896;
  assign select_2896 = and_1657 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2897;
  assign select_2897 = sample_pair_whole_q ? select_2896 : patches_phase_q;
  // hls/stages/patches.hpp:372
  logic and_2898;
  assign and_2898 = not_1661 & equal_1663;
  logic [8:0] select_2899;
  assign select_2899 = and_2898 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2900;
  assign select_2900 = and_2898 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2901;
  assign select_2901 = sample_pair_first_q ? select_2899 : select_2900;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2903;
  assign select_2903 = sample_pair_whole_q ? (and_1657 ? select_2901[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2905;
  assign select_2905 = sample_pair_whole_q ? (and_1657 ? select_2901[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2908;
  assign select_2908 = sample_pair_whole_q ? (equal_1665 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2910;
  assign select_2910 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1665}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2911;
  assign equal_2911 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_2912;
  assign not_2912 = ~equal_2911;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2914;
  assign select_2914 = sample_pair_whole_q ? (phase + {not_2912, 1'b1, not_2912, equal_2911}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:470
  logic equal_2916;
  assign equal_2916 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2920;
  assign select_2920 = equal_2916 ? ((select_2897 == 4'h6) ? 4'h0 : (select_2897 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2921;
  assign equal_2921 = select_2920 == 4'h0;
  // hls/stages/agreement.hpp:460
  logic [3:0] select_2924;
  assign select_2924 = equal_2428 ? (equal_2921 ? 4'h6 : (select_2920 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2926;
  assign select_2926 = equal_2916 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:460
  logic [4:0] select_2928;
  assign select_2928 = equal_2428 ? (select_2926 + {4'h0, equal_2921}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:520
  logic select_2933;
  assign select_2933 = and_532 ? (equal_2428 ? ((6'h2 < row) & equal_2921) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2935;
  assign select_2935 = and_532 ? (equal_2428 ? select_2926 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:370
  logic or_2958;
  assign or_2958 = select_498[0] | select_659[5];
  logic [7:0] sum_2959;
  assign sum_2959 = {1'b0, select_498[2:1], or_2958, select_659[4:1]} + 8'h1;
  logic less_2960;
  assign less_2960 = {sum_2959, select_659[0], select_511, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_2963;
  assign select_2963 = and_1657 ? (and_1670 ? (~less_2960) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:392
  logic or_3002;
  assign or_3002 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:394
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3008;
  assign and_3008 = equal_1758 & not_1765;
  // hls/stages/patches.hpp:398
  logic and_3009;
  assign and_3009 = not_1819 & and_3008;
  logic [1:0] select_3011;
  assign select_3011 = equal_1760 ? 2'h0 : (equal_1762 ? 2'h3 : {equal_1763, and_3009});
  // hls/stages/patches.hpp:279
  logic equal_3013;
  assign equal_3013 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3014;
  assign not_3014 = ~equal_3013;
  // hls/stages/patches.hpp:279
  logic equal_3015;
  assign equal_3015 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3016;
  assign not_3016 = ~equal_3015;
  // hls/stages/patches.hpp:283
  logic not_3018;
  assign not_3018 = ~(patches_following_q == 3'h2);
  logic and_3021;
  assign and_3021 = (~(patches_following_q == 3'h1)) & not_3018;
  // hls/stages/patches.hpp:396
  logic [1:0] select_3022;
  assign select_3022 = equal_3015 ? 2'h2 : {and_3021, not_3018};
  logic [3:0] select_3023;
  assign select_3023 = equal_3013 ? 4'h2 : {select_3022, {2{not_3016}}};
  // hls/stages/patches.hpp:404
  logic not_3026;
  assign not_3026 = ~or_3002;
  // hls/stages/patches.hpp:393
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:405
  logic [11:0] select_3031;
  assign select_3031 = or_3002 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3033;
  assign select_3033 = or_3002 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 47 x 33, DISTANCE 12, hls/stages/agreement.hpp:1371; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 33'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_632;
  logic [32:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 85, DISTANCE 12, hls/stages/agreement.hpp:1372; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [84:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 85'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & select_579;
  logic [84:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 99, DISTANCE 12, hls/stages/agreement.hpp:1373; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [98:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 99'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = or_561 ? x_q[5:0] : (equal_575 ? sum_562[5:0] : x_q[5:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_579;
  logic [98:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 62, DISTANCE 12, hls/stages/agreement.hpp:1374; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [61:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 62'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_561 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_599;
  logic [61:0] best_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_rdata_q <= best_left_mem[best_left_raddr];
  end

  // Memory patches_right_0, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s0_en & (not_1759 & (not_1761 & (or_1764 & (equal_1763 & not_1765))));
  logic [7:0] patches_right_0_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_rdata_q <= patches_right_0_mem[patches_right_0_raddr];
  end

  // Memory patches_right_1, 1024 x 8, DISTANCE 12, hls/stages/patches.hpp:774; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 8'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s0_en & and_1802;
  logic [7:0] patches_right_1_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_rdata_q <= patches_right_1_mem[patches_right_1_raddr];
  end

  // Memory patches_left, 512 x 8, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [7:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 8'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_1759 & (not_1761 & (not_1819 & or_1764)));
  logic [7:0] patches_left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_rdata_q <= patches_left_mem[patches_left_raddr];
  end

  // Memory patches_columns_above, 32 x 32, DISTANCE 12, hls/stages/patches.hpp:786; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 32'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s0_en & and_1845;
  logic [31:0] patches_columns_above_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_rdata_q <= patches_columns_above_mem[patches_columns_above_raddr];
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
      left_first_q <= and_1938 ? left_first_q : marks_first_i;
      right_q <= (~and_1938) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1938;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_496 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2109;
      raster_at_column_q <= select_2111;
      raster_at_row_q <= select_2114;
      raster_at_live_q <= select_2118;
      raster_rows_left_q <= sample_pair_whole_q ? select_2120 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2124;
      averager_place_q <= sample_pair_whole_q ? select_502 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2436;
      run_last_shift_q <= select_2439;
      run_span_q <= select_2432 ? (and_2429 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2454;
      following_shift_q <= select_2444 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2457;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2460[6], or_2461, select_2460[3:0]};
      following_columns_q <= {select_2462[7], or_2469[4], or_2468[5:4], or_2469[3:0]};
      plan_shift_q <= equal_575 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2476;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2482;
      columns_left_q <= select_2485;
      last_q <= and_532 ? (equal_2428 ? column : last_q) : last_q;
      least_q <= select_2493;
      whole_q <= select_2496;
      drawn_q <= select_2499;
      age_q <= select_2432 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2432 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2513;
      ends_q <= and_2517;
      final_row_q <= and_532 ? select_2520 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2897;
      patches_band_rows_rows_to_next_q <= select_2903;
      patches_band_rows_number_q <= select_2905;
      patches_next_band_rows_to_next_q <= select_2908;
      patches_next_band_number_q <= select_2910;
      patches_first_band_rows_to_next_q <= select_2914;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2911 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_532 ? select_2924 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_532 ? select_2928 : patches_choosing_number_q;
      patches_chooses_q <= select_2933;
      patches_choosing_band_q <= select_2935;
      patches_capturing_q <= sample_pair_whole_q ? select_1794 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_2963 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1788 : patches_row_q;
      patches_work_q <= or_3002 ? following : patches_work_q;
      patches_second_q <= not_1658 & (patches_second_q | (patches_ends_q & equal_1758));
      patches_following_q <= equal_1758 ? {2'h0, and_3008} : {equal_1760, select_3011};
      patches_following_beats_q <= {select_3023, not_3014};
      patches_begins_q <= sample_pair_whole_q & (and_1657 & and_1790);
      patches_ends_q <= not_3026 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3031;
      patches_code_row_q <= select_3033;
      patches_column_q <= or_3002 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3026 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_496_s1_q;
  logic [5:0] select_498_s1_q;
  logic [7:0] select_502_s1_q;
  logic and_506_s1_q;
  logic equal_512_s1_q;
  logic [5:0] column_s1_q;
  logic and_530_s1_q;
  logic and_532_s1_q;
  logic equal_556_s1_q;
  logic so_s1_q;
  logic equal_560_s1_q;
  logic or_561_s1_q;
  logic less_564_s1_q;
  logic not_565_s1_q;
  logic equal_575_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_599_s1_q;
  logic [5:0] right_s1_q;
  logic and_632_s1_q;
  logic [5:0] row_s1_q;
  logic and_1543_s1_q;
  logic equal_1544_s1_q;
  logic and_1657_s1_q;
  logic and_1670_s1_q;
  logic equal_1758_s1_q;
  logic not_1759_s1_q;
  logic equal_1760_s1_q;
  logic not_1761_s1_q;
  logic equal_1762_s1_q;
  logic equal_1763_s1_q;
  logic or_1764_s1_q;
  logic [4:0] select_1788_s1_q;
  logic select_1794_s1_q;
  logic [3:0] select_1835_s1_q;
  logic and_1845_s1_q;
  logic equal_2428_s1_q;
  logic and_2429_s1_q;
  logic or_3002_s1_q;
  logic not_3026_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
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
      select_496_s1_q <= select_496;
      select_498_s1_q <= select_498;
      select_502_s1_q <= select_502;
      and_506_s1_q <= and_506;
      equal_512_s1_q <= select_511 == 3'h0;
      column_s1_q <= column;
      and_530_s1_q <= and_530;
      and_532_s1_q <= and_532;
      equal_556_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_560_s1_q <= equal_560;
      or_561_s1_q <= or_561;
      less_564_s1_q <= less_564;
      not_565_s1_q <= not_565;
      equal_575_s1_q <= equal_575;
      x_s1_2_q <= x[6:0];
      select_599_s1_q <= select_599;
      right_s1_q <= right;
      and_632_s1_q <= and_632;
      row_s1_q <= row;
      and_1543_s1_q <= not_629 & and_598;
      equal_1544_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      and_1657_s1_q <= and_1657;
      and_1670_s1_q <= and_1670;
      equal_1758_s1_q <= equal_1758;
      not_1759_s1_q <= not_1759;
      equal_1760_s1_q <= equal_1760;
      not_1761_s1_q <= not_1761;
      equal_1762_s1_q <= equal_1762;
      equal_1763_s1_q <= equal_1763;
      or_1764_s1_q <= or_1764;
      select_1788_s1_q <= select_1788;
      select_1794_s1_q <= select_1794;
      select_1835_s1_q <= select_1835;
      and_1845_s1_q <= and_1845;
      equal_2428_s1_q <= equal_2428;
      and_2429_s1_q <= and_2429;
      or_3002_s1_q <= or_3002;
      not_3026_s1_q <= not_3026;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [11:0] moments_place_q;
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
  logic and_507;
  assign and_507 = sample_pair_whole_s1_q & and_506_s1_q;
  // hls/stages/agreement.hpp:668
  logic equal_551;
  assign equal_551 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_552;
  assign equal_552 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic and_553;
  assign and_553 = equal_551 & equal_552;
  // hls/stages/moments.hpp:52
  logic [11:0] sum_554;
  assign sum_554 = moments_place_q + 12'h1;
  // hls/stages/agreement.hpp:1003
  logic [10:0] select_555;
  assign select_555 = and_553 ? 11'h0 : sum_554[10:0];
  // hls/stages/agreement.hpp:1009
  logic not_557;
  assign not_557 = ~equal_556_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_559;
  assign not_559 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_561_s1_q & not_565_s1_q;
  // hls/stages/moments.hpp:52
  logic [11:0] select_567;
  assign select_567 = and_553 ? 12'h0 : sum_554;
  // hls/stages/moments.hpp:54
  logic less_568;
  assign less_568 = 12'h66c < select_567;
  // hls/stages/moments.hpp:90
  logic not_569;
  assign not_569 = ~less_568;
  // hls/stages/agreement.hpp:788
  logic and_573;
  assign and_573 = not_557 & (not_559 & (equal_560_s1_q & (inside_v & not_569)));
  // hls/stages/agreement.hpp:975
  logic and_589;
  assign and_589 = (or_561_s1_q & (left_rdata_q[67] & not_565_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:966
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:967
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:968
  logic [5:0] select_608;
  assign select_608 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:668
  logic not_729;
  assign not_729 = ~equal_551;
  // hls/stages/agreement.hpp:671
  logic and_730;
  assign and_730 = left_rdata_q[12] & not_729;
  logic and_731;
  assign and_731 = left_rdata_q[30] & not_729;
  logic and_732;
  assign and_732 = left_rdata_q[48] & not_729;
  logic and_733;
  assign and_733 = left_rdata_q[66] & not_729;
  // hls/stages/agreement.hpp:672
  logic and_734;
  assign and_734 = right_codes_rdata_q[12] & not_729;
  logic and_735;
  assign and_735 = right_codes_rdata_q[27] & not_729;
  logic and_736;
  assign and_736 = right_codes_rdata_q[42] & not_729;
  logic and_737;
  assign and_737 = right_codes_rdata_q[57] & not_729;
  logic and_738;
  assign and_738 = right_codes_rdata_q[72] & not_729;
  logic and_739;
  assign and_739 = right_codes_rdata_q[85] & not_729;
  // hls/stages/agreement.hpp:221
  logic and_744;
  assign and_744 = left_rdata_q[48] & not_565_s1_q;
  logic and_745;
  assign and_745 = right_codes_rdata_q[42] & not_565_s1_q;
  logic [11:0] select_746;
  assign select_746 = less_564_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  logic [11:0] select_747;
  assign select_747 = less_564_s1_q ? 12'h0 : left_rdata_q[47:36];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_751;
  assign select_751 = and_744 ? (and_745 ? (~(select_746 ^ select_747)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_757;
  assign parity_757 = ^select_751[5:3];
  logic parity_760;
  assign parity_760 = ^select_751[8:6];
  logic parity_763;
  assign parity_763 = ^select_751[11:3];
  // hls/stages/agreement.hpp:221
  logic and_767;
  assign and_767 = left_rdata_q[66] & not_565_s1_q;
  logic and_768;
  assign and_768 = right_codes_rdata_q[57] & not_565_s1_q;
  logic [11:0] select_769;
  assign select_769 = less_564_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  logic [11:0] select_770;
  assign select_770 = less_564_s1_q ? 12'h0 : left_rdata_q[65:54];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_774;
  assign select_774 = and_767 ? (and_768 ? (~(select_769 ^ select_770)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_777;
  assign parity_777 = ^select_774[8:6];
  logic parity_780;
  assign parity_780 = ^select_774[11:9];
  // hls/stages/agreement.hpp:221
  logic and_784;
  assign and_784 = left_rdata_q[84] & not_565_s1_q;
  logic and_785;
  assign and_785 = right_codes_rdata_q[72] & not_565_s1_q;
  logic [11:0] select_786;
  assign select_786 = less_564_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  logic [11:0] select_787;
  assign select_787 = less_564_s1_q ? 12'h0 : left_rdata_q[83:72];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_791;
  assign select_791 = and_784 ? (and_785 ? (~(select_786 ^ select_787)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_797;
  assign parity_797 = ^select_791[2:0];
  logic parity_800;
  assign parity_800 = ^select_791[5:3];
  logic parity_803;
  assign parity_803 = ^select_791[8:0];
  logic parity_809;
  assign parity_809 = ^select_791[11:9];
  logic parity_812;
  assign parity_812 = ^select_774[2:0];
  logic parity_815;
  assign parity_815 = ^{select_791[11:9], select_774[5:0]};
  logic parity_818;
  assign parity_818 = ^{select_791, select_774, select_751[2:0]};
  logic xor_819;
  assign xor_819 = parity_763 ^ parity_818;
  // hls/stages/count_bits.hpp:23
  logic or_823;
  assign or_823 = (select_751[1:0] == 2'h3) | (select_751[2] & (select_751[0] | select_751[1]));
  // hls/stages/count_bits.hpp:25
  logic or_827;
  assign or_827 = (select_774[7:6] == 2'h3) | (select_774[8] & (select_774[6] | select_774[7]));
  logic or_831;
  assign or_831 = (select_774[10:9] == 2'h3) | (select_774[11] & (select_774[9] | select_774[10]));
  // hls/stages/count_bits.hpp:23
  logic or_839;
  assign or_839 = (select_791[7:6] == 2'h3) | (select_791[8] & (~(select_791[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_843;
  assign or_843 = (select_791[1:0] == 2'h3) | (select_791[2] & (select_791[0] | select_791[1]));
  logic or_847;
  assign or_847 = (select_791[4:3] == 2'h3) | (select_791[5] & (select_791[3] | select_791[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_850;
  assign parity_850 = ^{or_847, or_843, or_839};
  // hls/stages/count_bits.hpp:23
  logic or_854;
  assign or_854 = (select_774[4:3] == 2'h3) | (select_774[5] & (select_774[3] | select_774[4]));
  // hls/stages/count_bits.hpp:25
  logic or_858;
  assign or_858 = (select_791[10:9] == 2'h3) | (select_791[11] & (select_791[9] | select_791[10]));
  logic or_862;
  assign or_862 = (select_774[1:0] == 2'h3) | (select_774[2] & (select_774[0] | select_774[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_865;
  assign parity_865 = ^{or_862, or_858, or_854};
  logic parity_868;
  assign parity_868 = ^{or_862, or_858, or_854, or_847, or_843, or_839, or_831, or_827, or_823};
  // hls/stages/count_bits.hpp:25
  logic and_869;
  assign and_869 = parity_763 & parity_818;
  logic or_873;
  assign or_873 = (parity_757 & parity_760) | ((^select_751[11:9]) & (parity_757 | parity_760));
  logic and_876;
  assign and_876 = (^{select_774[11:6], select_751[2:0]}) & (parity_803 | parity_815);
  logic or_877;
  assign or_877 = (parity_803 & parity_815) | and_876;
  // hls/stages/count_bits.hpp:23
  logic or_884;
  assign or_884 = (select_751[10:9] == 2'h3) | (select_751[11] & (select_751[9] | select_751[10]));
  // hls/stages/count_bits.hpp:25
  logic or_888;
  assign or_888 = (select_751[4:3] == 2'h3) | (select_751[5] & (select_751[3] | select_751[4]));
  logic or_892;
  assign or_892 = (select_751[7:6] == 2'h3) | (select_751[8] & (select_751[6] | select_751[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_895;
  assign parity_895 = ^{or_892, or_888, or_884};
  // hls/stages/count_bits.hpp:25
  logic or_899;
  assign or_899 = (parity_777 & parity_780) | ((^select_751[2:0]) & (parity_777 | parity_780));
  logic or_903;
  assign or_903 = (parity_797 & parity_800) | ((^select_791[8:6]) & (parity_797 | parity_800));
  logic or_907;
  assign or_907 = (parity_809 & parity_812) | ((^select_774[5:3]) & (parity_809 | parity_812));
  // hls/stages/count_bits.hpp:24
  logic parity_910;
  assign parity_910 = ^{or_907, or_903, or_899};
  logic parity_913;
  assign parity_913 = ^{or_907, or_903, or_899, or_892, or_888, or_884, or_877, or_873, and_869};
  logic xor_914;
  assign xor_914 = parity_868 ^ parity_913;
  // hls/stages/count_bits.hpp:25
  logic and_915;
  assign and_915 = parity_868 & parity_913;
  logic or_919;
  assign or_919 = (parity_850 & parity_865) | ((^{or_831, or_827, or_823}) & (parity_850 | parity_865));
  logic or_923;
  assign or_923 = (parity_895 & parity_910) | ((^{or_877, or_873, and_869}) & (parity_895 | parity_910));
  logic or_930;
  assign or_930 = (or_827 & or_831) | (or_823 & (or_827 | or_831));
  logic or_934;
  assign or_934 = (or_843 & or_847) | (or_839 & (or_843 | or_847));
  logic or_938;
  assign or_938 = (or_858 & or_862) | (or_854 & (or_858 | or_862));
  // hls/stages/count_bits.hpp:24
  logic parity_941;
  assign parity_941 = ^{or_938, or_934, or_930};
  // hls/stages/count_bits.hpp:25
  logic or_945;
  assign or_945 = (or_873 & or_877) | (and_869 & (or_873 | or_877));
  logic or_949;
  assign or_949 = (or_888 & or_892) | (or_884 & (or_888 | or_892));
  logic or_953;
  assign or_953 = (or_903 & or_907) | (or_899 & (or_903 | or_907));
  // hls/stages/count_bits.hpp:24
  logic parity_956;
  assign parity_956 = ^{or_953, or_949, or_945};
  logic parity_959;
  assign parity_959 = ^{or_953, or_949, or_945, or_938, or_934, or_930, or_923, or_919, and_915};
  // hls/stages/count_bits.hpp:25
  logic or_963;
  assign or_963 = (parity_941 & parity_956) | ((^{or_923, or_919, and_915}) & (parity_941 | parity_956));
  logic or_967;
  assign or_967 = (or_919 & or_923) | (and_915 & (or_919 | or_923));
  logic or_971;
  assign or_971 = (or_934 & or_938) | (or_930 & (or_934 | or_938));
  logic or_975;
  assign or_975 = (or_949 & or_953) | (or_945 & (or_949 | or_953));
  // hls/stages/count_bits.hpp:24
  logic parity_980;
  assign parity_980 = ^{or_975, or_971, or_967, or_963};
  // hls/stages/count_bits.hpp:25
  logic or_984;
  assign or_984 = (or_971 & or_975) | (or_967 & (or_971 | or_975));
  logic and_985;
  assign and_985 = or_963 & (^{or_975, or_971, or_967});
  // hls/stages/count_bits.hpp:24
  logic xor_986;
  assign xor_986 = or_984 ^ and_985;
  // hls/stages/count_bits.hpp:27
  logic and_987;
  assign and_987 = or_984 & and_985;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_988;
  assign select_988 = equal_575_s1_q ? {and_987, xor_986, parity_980, parity_959, xor_914, xor_819} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_561_s1_q ? 6'h0 : select_988;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_999;
  assign select_999 = (slot_s1_q[0] ? and_785 : and_768) ? (~(select_747 ^ (slot_s1_q[0] ? select_786 : select_769))) : 12'h0;
  logic [11:0] select_1000;
  assign select_1000 = and_744 ? select_999 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1006;
  assign parity_1006 = ^select_1000[5:3];
  logic parity_1009;
  assign parity_1009 = ^select_1000[8:6];
  logic parity_1012;
  assign parity_1012 = ^select_1000[11:3];
  // hls/stages/agreement.hpp:221
  logic and_1016;
  assign and_1016 = right_codes_rdata_q[85] & not_565_s1_q;
  logic [11:0] select_1018;
  assign select_1018 = less_564_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1022;
  assign select_1022 = (slot_s1_q[0] ? and_1016 : and_785) ? (~(select_770 ^ (slot_s1_q[0] ? select_1018 : select_786))) : 12'h0;
  logic [11:0] select_1023;
  assign select_1023 = and_767 ? select_1022 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1026;
  assign parity_1026 = ^select_1023[8:6];
  logic parity_1029;
  assign parity_1029 = ^select_1023[11:9];
  // hls/stages/agreement.hpp:734
  logic select_1034;
  assign select_1034 = slot_s1_q[0] ? (right_codes_rdata_q[98] & not_565_s1_q) : and_1016;
  logic [11:0] select_1036;
  assign select_1036 = slot_s1_q[0] ? (less_564_s1_q ? 12'h0 : right_codes_rdata_q[97:86]) : select_1018;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1040;
  assign select_1040 = and_784 ? (select_1034 ? (~(select_787 ^ select_1036)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1046;
  assign parity_1046 = ^select_1040[2:0];
  logic parity_1049;
  assign parity_1049 = ^select_1040[5:3];
  logic parity_1052;
  assign parity_1052 = ^select_1040[8:0];
  logic parity_1058;
  assign parity_1058 = ^select_1040[11:9];
  logic parity_1061;
  assign parity_1061 = ^select_1023[2:0];
  logic parity_1064;
  assign parity_1064 = ^{select_1040[11:9], select_1023[5:0]};
  logic parity_1067;
  assign parity_1067 = ^{select_1040, select_1023, select_1000[2:0]};
  logic xor_1068;
  assign xor_1068 = parity_1012 ^ parity_1067;
  // hls/stages/count_bits.hpp:23
  logic or_1072;
  assign or_1072 = (select_1000[1:0] == 2'h3) | (select_1000[2] & (select_1000[0] | select_1000[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1076;
  assign or_1076 = (select_1023[7:6] == 2'h3) | (select_1023[8] & (select_1023[6] | select_1023[7]));
  logic or_1080;
  assign or_1080 = (select_1023[10:9] == 2'h3) | (select_1023[11] & (select_1023[9] | select_1023[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1088;
  assign or_1088 = (select_1040[7:6] == 2'h3) | (select_1040[8] & (~(select_1040[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1092;
  assign or_1092 = (select_1040[1:0] == 2'h3) | (select_1040[2] & (select_1040[0] | select_1040[1]));
  logic or_1096;
  assign or_1096 = (select_1040[4:3] == 2'h3) | (select_1040[5] & (select_1040[3] | select_1040[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1099;
  assign parity_1099 = ^{or_1096, or_1092, or_1088};
  // hls/stages/count_bits.hpp:23
  logic or_1103;
  assign or_1103 = (select_1023[4:3] == 2'h3) | (select_1023[5] & (select_1023[3] | select_1023[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1107;
  assign or_1107 = (select_1040[10:9] == 2'h3) | (select_1040[11] & (select_1040[9] | select_1040[10]));
  logic or_1111;
  assign or_1111 = (select_1023[1:0] == 2'h3) | (select_1023[2] & (select_1023[0] | select_1023[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1114;
  assign parity_1114 = ^{or_1111, or_1107, or_1103};
  logic parity_1117;
  assign parity_1117 = ^{or_1111, or_1107, or_1103, or_1096, or_1092, or_1088, or_1080, or_1076, or_1072};
  // hls/stages/count_bits.hpp:25
  logic and_1118;
  assign and_1118 = parity_1012 & parity_1067;
  logic or_1122;
  assign or_1122 = (parity_1006 & parity_1009) | ((^select_1000[11:9]) & (parity_1006 | parity_1009));
  logic and_1125;
  assign and_1125 = (^{select_1023[11:6], select_1000[2:0]}) & (parity_1052 | parity_1064);
  logic or_1126;
  assign or_1126 = (parity_1052 & parity_1064) | and_1125;
  // hls/stages/count_bits.hpp:23
  logic or_1133;
  assign or_1133 = (select_1000[10:9] == 2'h3) | (select_1000[11] & (select_1000[9] | select_1000[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1137;
  assign or_1137 = (select_1000[4:3] == 2'h3) | (select_1000[5] & (select_1000[3] | select_1000[4]));
  logic or_1141;
  assign or_1141 = (select_1000[7:6] == 2'h3) | (select_1000[8] & (select_1000[6] | select_1000[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1144;
  assign parity_1144 = ^{or_1141, or_1137, or_1133};
  // hls/stages/count_bits.hpp:25
  logic or_1148;
  assign or_1148 = (parity_1026 & parity_1029) | ((^select_1000[2:0]) & (parity_1026 | parity_1029));
  logic or_1152;
  assign or_1152 = (parity_1046 & parity_1049) | ((^select_1040[8:6]) & (parity_1046 | parity_1049));
  logic or_1156;
  assign or_1156 = (parity_1058 & parity_1061) | ((^select_1023[5:3]) & (parity_1058 | parity_1061));
  // hls/stages/count_bits.hpp:24
  logic parity_1159;
  assign parity_1159 = ^{or_1156, or_1152, or_1148};
  logic parity_1162;
  assign parity_1162 = ^{or_1156, or_1152, or_1148, or_1141, or_1137, or_1133, or_1126, or_1122, and_1118};
  logic xor_1163;
  assign xor_1163 = parity_1117 ^ parity_1162;
  // hls/stages/count_bits.hpp:25
  logic and_1164;
  assign and_1164 = parity_1117 & parity_1162;
  logic or_1168;
  assign or_1168 = (parity_1099 & parity_1114) | ((^{or_1080, or_1076, or_1072}) & (parity_1099 | parity_1114));
  logic or_1172;
  assign or_1172 = (parity_1144 & parity_1159) | ((^{or_1126, or_1122, and_1118}) & (parity_1144 | parity_1159));
  logic or_1179;
  assign or_1179 = (or_1076 & or_1080) | (or_1072 & (or_1076 | or_1080));
  logic or_1183;
  assign or_1183 = (or_1092 & or_1096) | (or_1088 & (or_1092 | or_1096));
  logic or_1187;
  assign or_1187 = (or_1107 & or_1111) | (or_1103 & (or_1107 | or_1111));
  // hls/stages/count_bits.hpp:24
  logic parity_1190;
  assign parity_1190 = ^{or_1187, or_1183, or_1179};
  // hls/stages/count_bits.hpp:25
  logic or_1194;
  assign or_1194 = (or_1122 & or_1126) | (and_1118 & (or_1122 | or_1126));
  logic or_1198;
  assign or_1198 = (or_1137 & or_1141) | (or_1133 & (or_1137 | or_1141));
  logic or_1202;
  assign or_1202 = (or_1152 & or_1156) | (or_1148 & (or_1152 | or_1156));
  // hls/stages/count_bits.hpp:24
  logic parity_1205;
  assign parity_1205 = ^{or_1202, or_1198, or_1194};
  logic parity_1208;
  assign parity_1208 = ^{or_1202, or_1198, or_1194, or_1187, or_1183, or_1179, or_1172, or_1168, and_1164};
  // hls/stages/count_bits.hpp:25
  logic or_1212;
  assign or_1212 = (parity_1190 & parity_1205) | ((^{or_1172, or_1168, and_1164}) & (parity_1190 | parity_1205));
  logic or_1216;
  assign or_1216 = (or_1168 & or_1172) | (and_1164 & (or_1168 | or_1172));
  logic or_1220;
  assign or_1220 = (or_1183 & or_1187) | (or_1179 & (or_1183 | or_1187));
  logic or_1224;
  assign or_1224 = (or_1198 & or_1202) | (or_1194 & (or_1198 | or_1202));
  // hls/stages/count_bits.hpp:24
  logic parity_1229;
  assign parity_1229 = ^{or_1224, or_1220, or_1216, or_1212};
  // hls/stages/count_bits.hpp:25
  logic or_1233;
  assign or_1233 = (or_1220 & or_1224) | (or_1216 & (or_1220 | or_1224));
  logic and_1234;
  assign and_1234 = or_1212 & (^{or_1224, or_1220, or_1216});
  // hls/stages/count_bits.hpp:24
  logic xor_1235;
  assign xor_1235 = or_1233 ^ and_1234;
  // hls/stages/count_bits.hpp:27
  logic and_1236;
  assign and_1236 = or_1233 & and_1234;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1237;
  assign select_1237 = equal_575_s1_q ? {and_1236, xor_1235, parity_1229, parity_1208, xor_1163, xor_1068} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_561_s1_q ? 6'h0 : select_1237;
  // hls/stages/agreement.hpp:221
  logic and_1245;
  assign and_1245 = right_codes_rdata_q[27] & not_565_s1_q;
  // hls/stages/agreement.hpp:734
  logic select_1246;
  assign select_1246 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_565_s1_q) : and_1245;
  // hls/stages/agreement.hpp:221
  logic [11:0] select_1248;
  assign select_1248 = less_564_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:734
  logic [11:0] select_1249;
  assign select_1249 = slot_s1_q[0] ? (less_564_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1248;
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1253;
  assign select_1253 = and_744 ? (select_1246 ? (~(select_747 ^ select_1249)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1259;
  assign parity_1259 = ^select_1253[5:3];
  logic parity_1262;
  assign parity_1262 = ^select_1253[8:6];
  logic parity_1265;
  assign parity_1265 = ^select_1253[11:3];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1273;
  assign select_1273 = (slot_s1_q[0] ? and_1245 : and_745) ? (~(select_770 ^ (slot_s1_q[0] ? select_1248 : select_746))) : 12'h0;
  logic [11:0] select_1274;
  assign select_1274 = and_767 ? select_1273 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1277;
  assign parity_1277 = ^select_1274[8:6];
  logic parity_1280;
  assign parity_1280 = ^select_1274[11:9];
  // hls/stages/agreement.hpp:684
  logic [11:0] select_1288;
  assign select_1288 = (slot_s1_q[0] ? and_745 : and_768) ? (~(select_787 ^ (slot_s1_q[0] ? select_746 : select_769))) : 12'h0;
  logic [11:0] select_1289;
  assign select_1289 = and_784 ? select_1288 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1295;
  assign parity_1295 = ^select_1289[2:0];
  logic parity_1298;
  assign parity_1298 = ^select_1289[5:3];
  logic parity_1301;
  assign parity_1301 = ^select_1289[8:0];
  logic parity_1307;
  assign parity_1307 = ^select_1289[11:9];
  logic parity_1310;
  assign parity_1310 = ^select_1274[2:0];
  logic parity_1313;
  assign parity_1313 = ^{select_1289[11:9], select_1274[5:0]};
  logic parity_1316;
  assign parity_1316 = ^{select_1289, select_1274, select_1253[2:0]};
  logic xor_1317;
  assign xor_1317 = parity_1265 ^ parity_1316;
  // hls/stages/count_bits.hpp:23
  logic or_1321;
  assign or_1321 = (select_1253[1:0] == 2'h3) | (select_1253[2] & (select_1253[0] | select_1253[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1325;
  assign or_1325 = (select_1274[7:6] == 2'h3) | (select_1274[8] & (select_1274[6] | select_1274[7]));
  logic or_1329;
  assign or_1329 = (select_1274[10:9] == 2'h3) | (select_1274[11] & (select_1274[9] | select_1274[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1337;
  assign or_1337 = (select_1289[7:6] == 2'h3) | (select_1289[8] & (~(select_1289[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1341;
  assign or_1341 = (select_1289[1:0] == 2'h3) | (select_1289[2] & (select_1289[0] | select_1289[1]));
  logic or_1345;
  assign or_1345 = (select_1289[4:3] == 2'h3) | (select_1289[5] & (select_1289[3] | select_1289[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1348;
  assign parity_1348 = ^{or_1345, or_1341, or_1337};
  // hls/stages/count_bits.hpp:23
  logic or_1352;
  assign or_1352 = (select_1274[4:3] == 2'h3) | (select_1274[5] & (select_1274[3] | select_1274[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1356;
  assign or_1356 = (select_1289[10:9] == 2'h3) | (select_1289[11] & (select_1289[9] | select_1289[10]));
  logic or_1360;
  assign or_1360 = (select_1274[1:0] == 2'h3) | (select_1274[2] & (select_1274[0] | select_1274[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1363;
  assign parity_1363 = ^{or_1360, or_1356, or_1352};
  logic parity_1366;
  assign parity_1366 = ^{or_1360, or_1356, or_1352, or_1345, or_1341, or_1337, or_1329, or_1325, or_1321};
  // hls/stages/count_bits.hpp:25
  logic and_1367;
  assign and_1367 = parity_1265 & parity_1316;
  logic or_1371;
  assign or_1371 = (parity_1259 & parity_1262) | ((^select_1253[11:9]) & (parity_1259 | parity_1262));
  logic and_1374;
  assign and_1374 = (^{select_1274[11:6], select_1253[2:0]}) & (parity_1301 | parity_1313);
  logic or_1375;
  assign or_1375 = (parity_1301 & parity_1313) | and_1374;
  // hls/stages/count_bits.hpp:23
  logic or_1382;
  assign or_1382 = (select_1253[10:9] == 2'h3) | (select_1253[11] & (select_1253[9] | select_1253[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1386;
  assign or_1386 = (select_1253[4:3] == 2'h3) | (select_1253[5] & (select_1253[3] | select_1253[4]));
  logic or_1390;
  assign or_1390 = (select_1253[7:6] == 2'h3) | (select_1253[8] & (select_1253[6] | select_1253[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1393;
  assign parity_1393 = ^{or_1390, or_1386, or_1382};
  // hls/stages/count_bits.hpp:25
  logic or_1397;
  assign or_1397 = (parity_1277 & parity_1280) | ((^select_1253[2:0]) & (parity_1277 | parity_1280));
  logic or_1401;
  assign or_1401 = (parity_1295 & parity_1298) | ((^select_1289[8:6]) & (parity_1295 | parity_1298));
  logic or_1405;
  assign or_1405 = (parity_1307 & parity_1310) | ((^select_1274[5:3]) & (parity_1307 | parity_1310));
  // hls/stages/count_bits.hpp:24
  logic parity_1408;
  assign parity_1408 = ^{or_1405, or_1401, or_1397};
  logic parity_1411;
  assign parity_1411 = ^{or_1405, or_1401, or_1397, or_1390, or_1386, or_1382, or_1375, or_1371, and_1367};
  logic xor_1412;
  assign xor_1412 = parity_1366 ^ parity_1411;
  // hls/stages/count_bits.hpp:25
  logic and_1413;
  assign and_1413 = parity_1366 & parity_1411;
  logic or_1417;
  assign or_1417 = (parity_1348 & parity_1363) | ((^{or_1329, or_1325, or_1321}) & (parity_1348 | parity_1363));
  logic or_1421;
  assign or_1421 = (parity_1393 & parity_1408) | ((^{or_1375, or_1371, and_1367}) & (parity_1393 | parity_1408));
  logic or_1428;
  assign or_1428 = (or_1325 & or_1329) | (or_1321 & (or_1325 | or_1329));
  logic or_1432;
  assign or_1432 = (or_1341 & or_1345) | (or_1337 & (or_1341 | or_1345));
  logic or_1436;
  assign or_1436 = (or_1356 & or_1360) | (or_1352 & (or_1356 | or_1360));
  // hls/stages/count_bits.hpp:24
  logic parity_1439;
  assign parity_1439 = ^{or_1436, or_1432, or_1428};
  // hls/stages/count_bits.hpp:25
  logic or_1443;
  assign or_1443 = (or_1371 & or_1375) | (and_1367 & (or_1371 | or_1375));
  logic or_1447;
  assign or_1447 = (or_1386 & or_1390) | (or_1382 & (or_1386 | or_1390));
  logic or_1451;
  assign or_1451 = (or_1401 & or_1405) | (or_1397 & (or_1401 | or_1405));
  // hls/stages/count_bits.hpp:24
  logic parity_1454;
  assign parity_1454 = ^{or_1451, or_1447, or_1443};
  logic parity_1457;
  assign parity_1457 = ^{or_1451, or_1447, or_1443, or_1436, or_1432, or_1428, or_1421, or_1417, and_1413};
  // hls/stages/count_bits.hpp:25
  logic or_1461;
  assign or_1461 = (parity_1439 & parity_1454) | ((^{or_1421, or_1417, and_1413}) & (parity_1439 | parity_1454));
  logic or_1465;
  assign or_1465 = (or_1417 & or_1421) | (and_1413 & (or_1417 | or_1421));
  logic or_1469;
  assign or_1469 = (or_1432 & or_1436) | (or_1428 & (or_1432 | or_1436));
  logic or_1473;
  assign or_1473 = (or_1447 & or_1451) | (or_1443 & (or_1447 | or_1451));
  // hls/stages/count_bits.hpp:24
  logic parity_1478;
  assign parity_1478 = ^{or_1473, or_1469, or_1465, or_1461};
  // hls/stages/count_bits.hpp:25
  logic or_1482;
  assign or_1482 = (or_1469 & or_1473) | (or_1465 & (or_1469 | or_1473));
  logic and_1483;
  assign and_1483 = or_1461 & (^{or_1473, or_1469, or_1465});
  // hls/stages/count_bits.hpp:24
  logic xor_1484;
  assign xor_1484 = or_1482 ^ and_1483;
  // hls/stages/count_bits.hpp:27
  logic and_1485;
  assign and_1485 = or_1482 & and_1483;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1486;
  assign select_1486 = equal_575_s1_q ? {and_1485, xor_1484, parity_1478, parity_1457, xor_1412, xor_1317} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_561_s1_q ? 6'h0 : select_1486;
  // hls/stages/agreement.hpp:788
  logic and_1554;
  assign and_1554 = ends_cell_s1_q & inside_v;
  logic and_1556;
  assign and_1556 = not_557 & (so_s1_q & and_1554);
  logic [5:0] select_1560;
  assign select_1560 = so_s1_q ? x_s1_q[5:0] : (or_561_s1_q ? (less_564_s1_q ? 6'h0 : select_608) : 6'h0);
  // hls/stages/agreement.hpp:247
  logic or_1564;
  assign or_1564 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_1573;
  assign and_1573 = or_561_s1_q & (slot_s1_q[2] & not_565_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_1689;
  assign select_1689 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1689[16:7])) ? 8'h7f : select_1689[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1763_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1763_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:495
  logic less_1851;
  assign less_1851 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:496
  logic or_1852;
  assign or_1852 = equal_1762_s1_q | less_1851;
  // hls/stages/patches.hpp:499
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1857;
  assign select_1857 = equal_1762_s1_q ? patches_column_s1_q[0] : (or_1852 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1858;
  assign not_1858 = ~or_1852;
  // hls/stages/patches.hpp:496
  logic [4:0] sum_1859;
  assign sum_1859 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:498
  logic [4:0] select_1862;
  assign select_1862 = or_1852 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1859) + 5'h1) : sum_1859;
  // hls/stages/patches.hpp:500
  logic [4:0] select_1863;
  assign select_1863 = equal_1762_s1_q ? 5'h0 : select_1862;
  logic or_1864;
  assign or_1864 = equal_1762_s1_q | equal_1760_s1_q;
  // hls/stages/patches.hpp:476
  logic equal_1866;
  assign equal_1866 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1868;
  assign equal_1868 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:478
  logic and_1870;
  assign and_1870 = of_row & (~equal_1868);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1866 ? 2'h3 : {equal_1868, and_1870};
  // hls/stages/patches.hpp:464
  logic [8:0] sum_1873;
  assign sum_1873 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1874;
  assign sum_1874 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1873, pixel_2[0]} - {1'b0, sum_1874, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:466
  logic [11:0] sum_1876;
  assign sum_1876 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1877;
  assign sum_1877 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1876[11], sum_1876};
  logic [13:0] sum_1878;
  assign sum_1878 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1877, down_2[1]};
  logic [12:0] sum_1879;
  assign sum_1879 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1878[13:1];
  logic [14:0] sum_1880;
  assign sum_1880 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1879, sum_1878[0], down_2[0]};
  // hls/stages/patches.hpp:462
  logic [8:0] sum_1883;
  assign sum_1883 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1884;
  assign sum_1884 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1883};
  logic [10:0] sum_1885;
  assign sum_1885 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1884, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1886;
  assign sum_1886 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1885[10:1];
  // hls/stages/patches.hpp:463
  logic [11:0] smooth;
  assign smooth = {sum_1886, sum_1885[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:465
  logic [12:0] sum_1888;
  assign sum_1888 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1889;
  assign sum_1889 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1890;
  assign difference_1890 = {1'b0, sum_1888, smooth[0]} - {1'b0, sum_1889, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:477
  logic or_1896;
  assign or_1896 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1868) | equal_1866;
  // hls/stages/patches.hpp:472
  logic and_1901;
  assign and_1901 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_1905;
  assign and_1905 = not_1761_s1_q & (or_1764_s1_q & (or_1896 & (equal_1763_s1_q & and_1901)));
  // hls/stages/patches.hpp:172
  logic and_1915;
  assign and_1915 = (~(equal_1763_s1_q | (~and_1901))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_1919;
  assign and_1919 = not_1761_s1_q & (or_1764_s1_q & (and_1915 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:541
  logic less_1921;
  assign less_1921 = patches_step_q[4:0] < 5'h11;
  logic equal_1922;
  assign equal_1922 = patches_step_q[6:5] == 2'h0;
  logic not_1923;
  assign not_1923 = ~equal_1922;
  logic equal_1924;
  assign equal_1924 = patches_step_q[6:5] == 2'h3;
  logic not_1925;
  assign not_1925 = ~equal_1924;
  // hls/stages/patches.hpp:555
  logic select_1928;
  assign select_1928 = equal_1924 ? (less_1921 & (less_1921 & not_1925)) : less_1921;
  // hls/stages/patches.hpp:184
  logic and_1931;
  assign and_1931 = equal_1758_s1_q & (less_1921 ? (not_1923 & select_1928) : select_1928);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1959;
  assign sum_1959 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2256;
  assign select_2256 = equal_560_s1_q ? (inside_v ? select_567 : moments_place_q) : moments_place_q;
  logic [11:0] select_2258;
  assign select_2258 = equal_556_s1_q ? moments_place_q : (so_s1_q ? moments_place_q : select_2256);
  // hls/stages/agreement.hpp:460
  logic select_2525;
  assign select_2525 = equal_2428_s1_q ? (~({row_s1_q, 1'b0} < {sum_2522, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:520
  logic and_2786;
  assign and_2786 = and_532_s1_q & (equal_2428_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_2787;
  assign and_2787 = and_2429_s1_q & and_2786;
  // hls/stages/registration.hpp:127
  logic and_2789;
  assign and_2789 = and_2429_s1_q & (~and_2786);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2790;
  assign select_2790 = and_2789 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2792;
  assign select_2792 = and_2787 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2790[15]}}, select_2790});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2793;
  assign select_2793 = and_2789 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2793[15]}}, select_2793};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2795;
  assign select_2795 = and_2787 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_2796;
  assign and_2796 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2796 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_3041;
  assign select_3041 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3044;
  assign select_3044 = equal_1760_s1_q ? patches_smooth_values_0_q : (or_1764_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3046;
  assign select_3046 = or_1764_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3048;
  assign select_3048 = equal_1758_s1_q ? patches_smooth_values_1_q : (equal_1760_s1_q ? patches_smooth_values_1_q : select_3046);
  logic [11:0] select_3049;
  assign select_3049 = or_1764_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3051;
  assign select_3051 = equal_1758_s1_q ? patches_smooth_values_2_q : (equal_1760_s1_q ? patches_smooth_values_2_q : select_3049);
  logic [11:0] select_3052;
  assign select_3052 = or_1764_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3054;
  assign select_3054 = equal_1758_s1_q ? patches_smooth_values_3_q : (equal_1760_s1_q ? patches_smooth_values_3_q : select_3052);
  logic [10:0] select_3056;
  assign select_3056 = equal_1760_s1_q ? patches_down_values_0_q : (or_1764_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3059;
  assign select_3059 = equal_1760_s1_q ? patches_down_values_1_q : (or_1764_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3062;
  assign select_3062 = equal_1760_s1_q ? patches_down_values_2_q : (or_1764_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3065;
  assign select_3065 = equal_1760_s1_q ? patches_down_values_3_q : (or_1764_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3102;
  assign and_3102 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:412
  logic [4:0] select_3107;
  assign select_3107 = or_3002_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:414
  logic [3:0] select_3109;
  assign select_3109 = and_3102 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3465;
  assign select_3465 = equal_1758_s1_q ? patches_summed_down_by_q : (equal_1760_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:551
  logic and_3498;
  assign and_3498 = less_1921 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:555
  logic select_3501;
  assign select_3501 = equal_1924 ? (less_1921 ? (not_1925 & and_3498) : and_3498) : and_3498;
  // hls/stages/patches.hpp:184
  logic select_3504;
  assign select_3504 = equal_1758_s1_q ? (less_1921 ? (not_1923 & select_3501) : select_3501) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_3845;
  assign select_3845 = so_s1_q ? (and_2796 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3847;
  assign sum_3847 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3848;
  assign select_3848 = sum_1959[5] ? {1'b1, sum_1959[4:0], region_across_rest_q[2:0]} : sum_3847;
  // hls/stages/agreement.hpp:460
  logic [7:0] select_3850;
  assign select_3850 = equal_2428_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3853;
  assign select_3853 = equal_2428_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:227; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_502_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_507;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
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
  assign census_memory_raddr = column_s1_q;
  logic census_memory_re;
  assign census_memory_re = s1_en & and_532_s1_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory moments_memory, 1645 x 4, DISTANCE 16, hls/stages/moments.hpp:95; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [3:0] moments_memory_mem [0:1644];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1645; i++) moments_memory_mem[i] = 4'h0;
`endif
  logic [10:0] moments_memory_raddr;
  assign moments_memory_raddr = select_555;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_573;
  logic [3:0] moments_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (moments_memory_re) moments_memory_rdata_q <= moments_memory_mem[moments_memory_raddr];
  end

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1375; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_561_s1_q ? select_608 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_599_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1376; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] shown_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) shown_right_mem[i] = 2'h0;
`endif
  logic [5:0] shown_right_raddr;
  assign shown_right_raddr = x_s1_q[5:0];
  logic shown_right_re;
  assign shown_right_re = s1_en & and_1556;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory left_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1377; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] left_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_turns_mem[i] = 2'h0;
`endif
  logic [5:0] left_turns_raddr;
  assign left_turns_raddr = x_s1_q[5:0];
  logic left_turns_re;
  assign left_turns_re = s1_en & and_1573;
  logic [1:0] left_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_turns_re) left_turns_rdata_q <= left_turns_mem[left_turns_raddr];
  end

  // Memory right_turns, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1377; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [1:0] right_turns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_turns_mem[i] = 2'h0;
`endif
  logic [5:0] right_turns_raddr;
  assign right_turns_raddr = select_608;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_1573;
  logic [1:0] right_turns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_turns_re) right_turns_rdata_q <= right_turns_mem[right_turns_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:791; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1863, not_1858, select_1857};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1864;
  logic [27:0] patches_right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_rdata_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end

  // Memory patches_left_codes, 12 x 48, DISTANCE 12, hls/stages/patches.hpp:792; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [47:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 48'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s1_en & (not_1759_s1_q & (new_row & equal_1760_s1_q));
  logic [47:0] patches_left_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_rdata_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end

  // Memory patches_rows, 17 x 15, DISTANCE 12, hls/stages/patches.hpp:806; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [14:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 15'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s1_en & and_1931;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1404; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [17:0] seen_columns_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) seen_columns_mem[i] = 18'h0;
`endif
  logic [5:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[5:0];
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_1556;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_632_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_733, left_rdata_q[65:49], and_732, left_rdata_q[47:31], and_731, left_rdata_q[29:13], and_730, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_632_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_739, right_codes_rdata_q[84:73], and_738, right_codes_rdata_q[71:60], and_737, right_codes_rdata_q[56:43], and_736, right_codes_rdata_q[41:28], and_735, right_codes_rdata_q[26:13], and_734, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_1845_s1_q;
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
      moments_place_q <= select_2258;
      row_q <= and_532_s1_q ? (equal_2428_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_532_s1_q ? select_2525 : lower_half_q;
      registration_slope_row_q <= select_2792;
      registration_slope_change_q <= select_2795;
      registration_slope_q <= so_s1_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3026_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3026_s1_q & select_3041;
      patches_smooth_values_0_q <= equal_1758_s1_q ? patches_smooth_values_0_q : select_3044;
      patches_smooth_values_1_q <= select_3048;
      patches_smooth_values_2_q <= select_3051;
      patches_smooth_values_3_q <= select_3054;
      patches_down_values_0_q <= equal_1758_s1_q ? patches_down_values_0_q : select_3056;
      patches_down_values_1_q <= equal_1758_s1_q ? patches_down_values_1_q : select_3059;
      patches_down_values_2_q <= equal_1758_s1_q ? patches_down_values_2_q : select_3062;
      patches_down_values_3_q <= equal_1758_s1_q ? patches_down_values_3_q : select_3065;
      patches_down_by_q <= or_3002_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3102});
      patches_along_q <= select_3107;
      patches_match_row_q <= or_3002_s1_q ? 4'h0 : select_3109;
      patches_summed_last_q <= not_1759_s1_q & (equal_1760_s1_q & and_3102);
      patches_summed_down_by_q <= select_3465;
      patches_step_q <= or_3002_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3504;
      region_across_rest_q <= select_3845;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3848;
      columns_begin_rest_q <= and_532_s1_q ? select_3850 : columns_begin_rest_q;
      columns_begin_back_q <= and_532_s1_q ? select_3853 : columns_begin_back_q;
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
      sums_0_columns_values_0_q <= column_3;
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
      sums_1_columns_values_0_q <= column_4;
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
  logic [2:0] select_496_s2_q;
  logic [5:0] select_498_s2_q;
  logic [7:0] select_502_s2_q;
  logic and_506_s2_q;
  logic and_507_s2_q;
  logic equal_512_s2_q;
  logic [5:0] column_s2_q;
  logic and_530_s2_q;
  logic and_532_s2_q;
  logic equal_552_s2_q;
  logic and_553_s2_q;
  logic [10:0] select_555_s2_q;
  logic equal_556_s2_q;
  logic not_557_s2_q;
  logic so_s2_q;
  logic not_559_s2_q;
  logic equal_560_s2_q;
  logic or_561_s2_q;
  logic less_564_s2_q;
  logic not_565_s2_q;
  logic inside_v_s2_q;
  logic less_568_s2_q;
  logic not_569_s2_q;
  logic and_573_s2_q;
  logic and_582_s2_q;
  logic and_590_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] right_s2_q;
  logic and_621_s2_q;
  logic and_626_s2_q;
  logic and_628_s2_q;
  logic equal_661_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1239_s2_q;
  logic [5:0] select_1488_s2_q;
  logic and_1543_s2_q;
  logic equal_1544_s2_q;
  logic and_1554_s2_q;
  logic and_1556_s2_q;
  logic [5:0] select_1560_s2_q;
  logic or_1564_s2_q;
  logic and_1657_s2_q;
  logic and_1670_s2_q;
  logic less_1684_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1758_s2_q;
  logic equal_1760_s2_q;
  logic equal_1763_s2_q;
  logic or_1764_s2_q;
  logic [4:0] select_1788_s2_q;
  logic select_1794_s2_q;
  logic [3:0] select_1835_s2_q;
  logic less_1851_s2_q;
  logic new_row_s2_q;
  logic or_1864_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic less_1881_s2_q;
  logic less_1882_s2_q;
  logic less_1891_s2_q;
  logic less_1892_s2_q;
  logic and_1906_s2_q;
  logic and_1915_s2_q;
  logic and_1920_s2_q;
  logic less_1921_s2_q;
  logic equal_1922_s2_q;
  logic not_1923_s2_q;
  logic equal_1924_s2_q;
  logic not_1925_s2_q;
  logic and_1938_s2_q;
  logic select_1940_s2_q;
  logic and_1943_s2_q;
  logic sum_1959_s2_q;
  logic and_1980_s2_q;
  logic and_2098_s2_q;
  logic equal_2244_s2_q;
  logic equal_2428_s2_q;
  logic and_2555_s2_q;
  logic equal_2640_s2_q;
  logic less_3078_s2_q;
  logic equal_3421_s2_q;
  logic equal_3505_s2_q;
  logic less_3833_s2_q;
  logic equal_4051_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= marks_first_s1_q;
      marks_last_s2_q <= sample_last_q;
      left_first_s2_q <= sample_pair_first_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
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
      select_496_s2_q <= select_496_s1_q;
      select_498_s2_q <= select_498_s1_q;
      select_502_s2_q <= select_502_s1_q;
      and_506_s2_q <= and_506_s1_q;
      and_507_s2_q <= and_507;
      equal_512_s2_q <= equal_512_s1_q;
      column_s2_q <= column_s1_q;
      and_530_s2_q <= and_530_s1_q;
      and_532_s2_q <= and_532_s1_q;
      equal_552_s2_q <= equal_552;
      and_553_s2_q <= and_553;
      select_555_s2_q <= select_555;
      equal_556_s2_q <= equal_556_s1_q;
      not_557_s2_q <= not_557;
      so_s2_q <= so_s1_q;
      not_559_s2_q <= not_559;
      equal_560_s2_q <= equal_560_s1_q;
      or_561_s2_q <= or_561_s1_q;
      less_564_s2_q <= less_564_s1_q;
      not_565_s2_q <= not_565_s1_q;
      inside_v_s2_q <= inside_v;
      less_568_s2_q <= less_568;
      not_569_s2_q <= not_569;
      and_573_s2_q <= and_573;
      and_582_s2_q <= or_561_s1_q & (left_rdata_q[70] & not_565_s1_q);
      and_590_s2_q <= (or_561_s1_q & (left_rdata_q[68] & not_565_s1_q)) & and_589;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_621_s2_q <= or_561_s1_q & (left_rdata_q[71] & not_565_s1_q);
      and_626_s2_q <= or_561_s1_q & (right_codes_rdata_q[58] & not_565_s1_q);
      and_628_s2_q <= or_561_s1_q & (right_codes_rdata_q[59] & not_565_s1_q);
      equal_661_s2_q <= row_s1_q == 6'h0;
      column_2_s2_q <= column_2;
      select_1239_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1488_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1543_s2_q <= and_1543_s1_q;
      equal_1544_s2_q <= equal_1544_s1_q;
      and_1554_s2_q <= and_1554;
      and_1556_s2_q <= and_1556;
      select_1560_s2_q <= select_1560;
      or_1564_s2_q <= or_1564;
      and_1657_s2_q <= and_1657_s1_q;
      and_1670_s2_q <= and_1670_s1_q;
      less_1684_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1758_s2_q <= equal_1758_s1_q;
      equal_1760_s2_q <= equal_1760_s1_q;
      equal_1763_s2_q <= equal_1763_s1_q;
      or_1764_s2_q <= or_1764_s1_q;
      select_1788_s2_q <= select_1788_s1_q;
      select_1794_s2_q <= select_1794_s1_q;
      select_1835_s2_q <= select_1835_s1_q;
      less_1851_s2_q <= less_1851;
      new_row_s2_q <= new_row;
      or_1864_s2_q <= or_1864;
      of_row_2_s2_q <= of_row_2;
      less_1881_s2_q <= $signed(15'h100) < $signed(sum_1880);
      less_1882_s2_q <= $signed(sum_1880[14:8]) < $signed(7'h7f);
      less_1891_s2_q <= $signed(15'h100) < $signed(difference_1890);
      less_1892_s2_q <= $signed(difference_1890[14:8]) < $signed(7'h7f);
      and_1906_s2_q <= not_1759_s1_q & and_1905;
      and_1915_s2_q <= and_1915;
      and_1920_s2_q <= not_1759_s1_q & and_1919;
      less_1921_s2_q <= less_1921;
      equal_1922_s2_q <= equal_1922;
      not_1923_s2_q <= not_1923;
      equal_1924_s2_q <= equal_1924;
      not_1925_s2_q <= not_1925;
      and_1938_s2_q <= sample_pair_whole_q;
      select_1940_s2_q <= left_first_q;
      and_1943_s2_q <= right_q;
      sum_1959_s2_q <= sum_1959[5];
      and_1980_s2_q <= or_561_s1_q & (left_rdata_q[69] & not_565_s1_q);
      and_2098_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2244_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_2428_s2_q <= equal_2428_s1_q;
      and_2555_s2_q <= or_561_s1_q & (not_565_s1_q & and_589);
      equal_2640_s2_q <= shift == 6'h0;
      less_3078_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3421_s2_q <= patches_match_row_q == 4'h0;
      equal_3505_s2_q <= patches_step_q[6:5] == 2'h2;
      less_3833_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4051_s2_q <= row_s1_q[5:3] == 3'h0;
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
  logic moments_out_of_step_q;
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
  logic [11:0] select_510;
  assign select_510 = select_496_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:122
  logic [11:0] sum_514;
  assign sum_514 = select_510 + (equal_512_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:113
  logic [11:0] sum_516;
  assign sum_516 = {4'h0, sample_pair_pixel_1_q} + (select_496_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:122
  logic [11:0] sum_518;
  assign sum_518 = sum_516 + (equal_512_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:417
  logic whole;
  assign whole = select_496_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:123
  logic and_522;
  assign and_522 = whole & (averager_memory_rdata_q[24] | equal_512_s2_q);
  // hls/stages/agreement.hpp:417
  logic all_of_skin;
  assign all_of_skin = select_496_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:124
  logic and_526;
  assign and_526 = all_of_skin & (averager_memory_rdata_q[25] | equal_512_s2_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_506_s2_q ? sum_514[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic equal_535;
  assign equal_535 = select_496_s2_q == 3'h1;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_535 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_538;
  assign select_538 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_506_s2_q ? sum_518[11:3] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_535 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_542;
  assign select_542 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic and_543;
  assign and_543 = and_506_s2_q & and_522;
  // hls/stages/census.hpp:127
  logic select_545;
  assign select_545 = equal_535 ? and_543 : (averager_mask_q & and_543);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_545;
  // hls/stages/census.hpp:207
  logic and_547;
  assign and_547 = and_506_s2_q & and_526;
  // hls/stages/census.hpp:127
  logic select_549;
  assign select_549 = equal_535 ? and_547 : (averager_of_skin_q & and_547);
  // hls/stages/agreement.hpp:276
  logic and_550;
  assign and_550 = sample_pair_whole_s2_q & select_549;
  // hls/stages/agreement.hpp:978
  logic select_603;
  assign select_603 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:979
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:992
  logic [8:0] difference_613;
  assign difference_613 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:993
  logic [9:0] sum_614;
  assign sum_614 = {difference_613[8], difference_613} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_616;
  assign and_616 = (and_590_s2_q & select_603) & ({{22{sum_614[9]}}, sum_614} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_618;
  assign and_618 = or_561_s2_q & (not_565_s2_q & and_616);
  // hls/stages/moments.hpp:64
  logic and_619;
  assign and_619 = and_582_s2_q & and_618;
  // hls/stages/census.hpp:296
  logic less_634;
  assign less_634 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_635;
  assign less_635 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_636;
  assign less_636 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_637;
  assign less_637 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_638;
  assign less_638 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_639;
  assign less_639 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_640;
  assign less_640 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_641;
  assign less_641 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_642;
  assign less_642 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_643;
  assign less_643 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_644;
  assign less_644 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_645;
  assign less_645 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:297
  logic less_646;
  assign less_646 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_647;
  assign less_647 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_648;
  assign less_648 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_649;
  assign less_649 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_650;
  assign less_650 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_651;
  assign less_651 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_652;
  assign less_652 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_653;
  assign less_653 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_654;
  assign less_654 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_655;
  assign less_655 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_656;
  assign less_656 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_657;
  assign less_657 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:455
  logic equal_658;
  assign equal_658 = column_s2_q == 6'h0;
  logic [3:0] select_662;
  assign select_662 = equal_661_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:456
  logic [4:0] select_663;
  assign select_663 = equal_658 ? {select_662, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:278
  logic [3:0] select_664;
  assign select_664 = equal_658 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:301
  logic and_665;
  assign and_665 = select_663[4] & select_664[3];
  // hls/stages/census.hpp:288
  logic and_667;
  assign and_667 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_669;
  assign and_669 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_667);
  // hls/stages/agreement.hpp:456
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_669;
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
  logic [9:0] difference_692;
  assign difference_692 = {1'b0, select_538} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_693;
  assign xor_693 = difference_692[8:0] ^ {9{difference_692[9]}};
  logic [9:0] sum_694;
  assign sum_694 = {9'h0, difference_692[9]} + {1'b0, xor_693};
  logic [9:0] difference_695;
  assign difference_695 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_696;
  assign xor_696 = difference_695[8:0] ^ {9{difference_695[9]}};
  logic [9:0] sum_697;
  assign sum_697 = {9'h0, difference_695[9]} + {1'b0, xor_696};
  logic [9:0] difference_699;
  assign difference_699 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_700;
  assign xor_700 = difference_699[8:0] ^ {9{difference_699[9]}};
  logic [9:0] sum_701;
  assign sum_701 = {9'h0, difference_699[9]} + {1'b0, xor_700};
  logic [10:0] sum_702;
  assign sum_702 = ({1'b0, sum_694} + {1'b0, sum_697}) + {1'b0, sum_701};
  logic [9:0] difference_703;
  assign difference_703 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_704;
  assign xor_704 = difference_703[8:0] ^ {9{difference_703[9]}};
  logic [9:0] sum_705;
  assign sum_705 = {9'h0, difference_703[9]} + {1'b0, xor_704};
  logic [9:0] difference_707;
  assign difference_707 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_708;
  assign xor_708 = difference_707[8:0] ^ {9{difference_707[9]}};
  // hls/stages/agreement.hpp:456
  logic and_716;
  assign and_716 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_717;
  assign and_717 = and_665 & and_716;
  // hls/stages/census.hpp:308
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_719;
  assign sum_719 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:308
  logic and_721;
  assign and_721 = and_717 & ({{5{sum_719[6]}}, sum_719, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:309
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_725;
  assign sum_725 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:807
  logic or_741;
  assign or_741 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:808
  logic select_743;
  assign select_743 = or_741 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:778
  logic [5:0] select_990;
  assign select_990 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_991;
  assign difference_991 = {1'b0, column_2_s2_q} - {1'b0, select_990};
  logic [7:0] sum_993;
  assign sum_993 = {difference_991[6], difference_991} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:755
  logic [7:0] select_994;
  assign select_994 = slot_s2_q[0] ? chosen_score_q : sum_993;
  // hls/stages/agreement.hpp:778
  logic [6:0] difference_1240;
  assign difference_1240 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1239_s2_q};
  // hls/stages/agreement.hpp:749
  logic equal_1241;
  assign equal_1241 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:778
  logic [7:0] sum_1243;
  assign sum_1243 = {difference_1240[6], difference_1240} + (equal_1241 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1489;
  assign difference_1489 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1488_s2_q};
  logic [7:0] sum_1491;
  assign sum_1491 = {difference_1489[6], difference_1489} + (equal_1241 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:751
  logic less_1492;
  assign less_1492 = sum_1243 < sum_1491;
  logic [7:0] select_1493;
  assign select_1493 = less_1492 ? sum_1491 : sum_1243;
  logic less_1494;
  assign less_1494 = select_994 < select_1493;
  // hls/stages/agreement.hpp:801
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1494 ? select_1493 : select_994) : 8'h0;
  // hls/stages/agreement.hpp:808
  logic or_1498;
  assign or_1498 = select_743 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:813
  logic [5:0] select_1499;
  assign select_1499 = or_1498 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:720
  logic not_1500;
  assign not_1500 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:752
  logic [1:0] select_1501;
  assign select_1501 = less_1492 ? {slot_s2_q[0], not_1500} : 2'h0;
  logic [2:0] select_1503;
  assign select_1503 = less_1494 ? {select_1501, not_1500} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:813
  logic [2:0] select_1504;
  assign select_1504 = or_1498 ? select_1503 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1505;
  assign select_1505 = or_1498 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:810
  logic equal_1506;
  assign equal_1506 = select_1503 == 3'h1;
  logic or_1509;
  assign or_1509 = equal_1506 | (~(select_1503 == 3'h2));
  logic [7:0] select_1511;
  assign select_1511 = or_1509 ? before_0_q : before_1_q;
  logic [7:0] select_1512;
  assign select_1512 = equal_1506 ? (or_1509 ? sum_1243 : {7'h0, shift_not_right_q}) : select_1511;
  // hls/stages/agreement.hpp:813
  logic [7:0] select_1513;
  assign select_1513 = or_1498 ? select_1512 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1516;
  assign select_1516 = or_1498 ? (equal_1506 ? select_1511 : (or_1509 ? sum_1491 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1518;
  assign sum_1518 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1519;
  assign sum_1519 = {1'b0, before_v} + sum_1518;
  // hls/stages/agreement.hpp:755
  logic [6:0] select_1520;
  assign select_1520 = slot_s2_q[0] ? chosen_near_q : sum_1519;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1522;
  assign sum_1522 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1523;
  assign sum_1523 = {1'b0, before_v_2} + sum_1522;
  // hls/stages/agreement.hpp:779
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:780
  logic [6:0] sum_1525;
  assign sum_1525 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1526;
  assign sum_1526 = {1'b0, before_v_3} + sum_1525;
  // hls/stages/agreement.hpp:751
  logic [6:0] select_1528;
  assign select_1528 = (sum_1523 < sum_1526) ? sum_1526 : sum_1523;
  // hls/stages/agreement.hpp:802
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1520 < select_1528) ? select_1528 : select_1520) : 7'h0;
  // hls/stages/agreement.hpp:813
  logic less_1532;
  assign less_1532 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:817
  logic [6:0] select_1534;
  assign select_1534 = select_743 ? of_near : (less_1532 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1536;
  assign select_1536 = select_743 ? run_shift_s2_q : (less_1532 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1539;
  assign select_1539 = (run_shift_s2_q == 6'h3f) ? of_best : (select_743 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:818
  logic [7:0] select_1542;
  assign select_1542 = (run_shift_s2_q == 6'h1) ? of_best : (select_743 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:823
  logic select_1545;
  assign select_1545 = or_741 ? shift_first_s2_q : equal_1544_s2_q;
  // hls/stages/agreement.hpp:824
  logic or_1547;
  assign or_1547 = select_1545 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:828
  logic [7:0] select_1548;
  assign select_1548 = or_1547 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1549;
  assign select_1549 = or_1547 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1551;
  assign or_1551 = select_1545 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:832
  logic [6:0] select_1552;
  assign select_1552 = or_1551 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1553;
  assign select_1553 = or_1551 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_1567;
  assign and_1567 = or_561_s2_q & (not_565_s2_q & (and_616 & or_1564_s2_q));
  // hls/stages/agreement.hpp:788
  logic and_1568;
  assign and_1568 = not_559_s2_q & and_1567;
  logic and_1571;
  assign and_1571 = not_557_s2_q & (so_s2_q ? and_1554_s2_q : (equal_560_s2_q & and_618));
  // hls/stages/moments.hpp:60
  logic and_1575;
  assign and_1575 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1003
  logic and_1576;
  assign and_1576 = not_569_s2_q & and_1575;
  logic and_1578;
  assign and_1578 = and_1575 & (moments_memory_rdata_q[1] ^ and_621_s2_q);
  logic and_1579;
  assign and_1579 = not_569_s2_q & and_1578;
  // hls/stages/agreement.hpp:788
  logic and_1582;
  assign and_1582 = not_557_s2_q & (not_559_s2_q & (equal_560_s2_q & inside_v_s2_q));
  // hls/stages/moments.hpp:60
  logic and_1584;
  assign and_1584 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1003
  logic and_1585;
  assign and_1585 = not_569_s2_q & and_1584;
  // hls/stages/moments.hpp:61
  logic and_1587;
  assign and_1587 = and_1584 & (moments_memory_rdata_q[3] ^ and_628_s2_q);
  // hls/stages/agreement.hpp:1003
  logic and_1588;
  assign and_1588 = not_569_s2_q & and_1587;
  // hls/stages/agreement.hpp:1128
  logic equal_1589;
  assign equal_1589 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1177
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1129
  logic [1:0] select_1592;
  assign select_1592 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1142
  logic [3:0] select_1594;
  assign select_1594 = equal_1589 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1592});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1595;
  assign sum_1595 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_1596;
  assign select_1596 = equal_556_s2_q ? select_1594 : {sum_1595, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1597;
  assign equal_1597 = x_s2_q[5:0] == 6'h3f;
  logic equal_1599;
  assign equal_1599 = x_s2_q[5:0] == 6'h3e;
  logic equal_1601;
  assign equal_1601 = x_s2_q[5:0] == 6'h3d;
  logic equal_1603;
  assign equal_1603 = x_s2_q[5:0] == 6'h3c;
  logic equal_1605;
  assign equal_1605 = x_s2_q[5:0] == 6'h3b;
  logic equal_1607;
  assign equal_1607 = x_s2_q[5:0] == 6'h36;
  logic equal_1609;
  assign equal_1609 = x_s2_q[5:0] == 6'h35;
  logic equal_1611;
  assign equal_1611 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1177
  logic and_1615;
  assign and_1615 = (~equal_1605) & ((~equal_1607) & ((~equal_1609) & (~equal_1611)));
  logic and_1619;
  assign and_1619 = (~equal_1597) & ((~equal_1599) & ((~equal_1601) & ((~equal_1603) & and_1615)));
  // hls/stages/agreement.hpp:1129
  logic less_1620;
  assign less_1620 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1624;
  assign or_1624 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1009
  logic [4:0] sum_1629;
  assign sum_1629 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1629, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1635;
  assign sum_1635 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1637;
  assign and_1637 = half_ends & ({{3{sum_1635[4]}}, sum_1635} < 8'h3);
  // hls/stages/agreement.hpp:788
  logic and_1638;
  assign and_1638 = so_s2_q & and_1637;
  logic select_1639;
  assign select_1639 = equal_556_s2_q ? (x_s2_q[6] & (equal_1589 ? and_1619 : (less_1620 & (~or_1624)))) : and_1638;
  // hls/stages/registration.hpp:258
  logic not_1641;
  assign not_1641 = ~lower_half_s2_q;
  logic [3:0] select_1642;
  assign select_1642 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1641, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1641};
  // hls/stages/patches.hpp:372
  logic [1:0] select_1671;
  assign select_1671 = and_1670_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1672;
  assign select_1672 = and_1670_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_1673;
  assign select_1673 = and_1657_s2_q ? {select_1672, select_1671[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1674;
  assign select_1674 = and_1657_s2_q ? select_1671 : patches_fetch_q;
  logic equal_1675;
  assign equal_1675 = select_1674 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < x_s2_q;
  // hls/stages/agreement.hpp:788
  logic and_1683;
  assign and_1683 = not_557_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1685;
  assign equal_1685 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_561_s2_q ? (less_564_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1685 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1693;
  assign select_1693 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_1694;
  assign select_1694 = b[1] ? a : 8'h0;
  logic [8:0] sum_1695;
  assign sum_1695 = {{2{select_1693[6]}}, select_1693} + {select_1694[7], select_1694};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1696;
  assign select_1696 = b[2] ? a : 8'h0;
  logic [7:0] select_1697;
  assign select_1697 = b[3] ? a : 8'h0;
  logic [8:0] sum_1698;
  assign sum_1698 = {{2{select_1696[7]}}, select_1696[7:1]} + {select_1697[7], select_1697};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1699;
  assign sum_1699 = {{3{sum_1695[8]}}, sum_1695[8:1]} + {sum_1698[8], sum_1698, select_1696[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1700;
  assign select_1700 = b[4] ? a : 8'h0;
  logic [7:0] select_1701;
  assign select_1701 = b[5] ? a : 8'h0;
  logic [8:0] difference_1702;
  assign difference_1702 = {{2{select_1700[7]}}, select_1700[7:1]} - {select_1701[7], select_1701};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1703;
  assign sum_1703 = {difference_1702, select_1700[0]} + {sum_1699[10], sum_1699[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1685 ? {sum_1703, sum_1699[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1705;
  assign sum_1705 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_1708;
  assign and_1708 = less_1684_s2_q & (and_618 & ({{4{sum_1705[9]}}, sum_1705, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_1712;
  assign and_1712 = ({4'h0, last_s2_q[5:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1718;
  assign sum_1718 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1720;
  assign sum_1720 = {sum_1718[9], sum_1718[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1018
  logic and_1723;
  assign and_1723 = ($signed(9'h0) < $signed(sum_1718[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1720, sum_1718[0]})));
  logic and_1724;
  assign and_1724 = (~(and_1712 | (equal_552_s2_q | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1723;
  // hls/stages/agreement.hpp:788
  logic and_1728;
  assign and_1728 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1708 & and_1724)));
  logic and_1729;
  assign and_1729 = not_557_s2_q & and_1728;
  // hls/stages/patches.hpp:156
  logic and_1731;
  assign and_1731 = and_1729 & (~patches_fixed_q);
  // hls/stages/agreement.hpp:788
  logic [6:0] select_1734;
  assign select_1734 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  logic [6:0] select_1735;
  assign select_1735 = equal_556_s2_q ? 7'h0 : select_1734;
  logic [5:0] select_1738;
  assign select_1738 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  logic [5:0] select_1739;
  assign select_1739 = equal_556_s2_q ? 6'h0 : select_1738;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1740;
  assign sum_1740 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_1703[9]}}, sum_1703[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1743;
  assign select_1743 = ($signed(sum_1740[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1740[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1685 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1740[12:7])) ? 8'h7f : select_1743);
  // hls/stages/agreement.hpp:788
  logic [7:0] select_1748;
  assign select_1748 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_1749;
  assign select_1749 = equal_556_s2_q ? 8'h0 : select_1748;
  // hls/stages/patches.hpp:342
  logic [21:0] select_1750;
  assign select_1750 = and_1731 ? {select_1749, select_1739, select_1735, and_1729} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:113
  logic equal_1751;
  assign equal_1751 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:788
  logic and_1755;
  assign and_1755 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1712 | equal_1751)));
  logic and_1756;
  assign and_1756 = not_557_s2_q & and_1755;
  // hls/stages/patches.hpp:343
  logic and_1757;
  assign and_1757 = patches_chooses_s2_q & and_1756;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1771;
  assign select_1771 = and_1657_s2_q ? select_1672 : patches_band_q;
  // hls/stages/patches.hpp:352
  logic equal_1772;
  assign equal_1772 = {patches_choosing_band_s2_q, and_1683} == {select_1771, select_1674[1]};
  // hls/stages/patches.hpp:481
  logic [2:0] sum_1872;
  assign sum_1872 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:485
  logic [1:0] sum_1910;
  assign sum_1910 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_1946;
  assign select_1946 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1050
  logic or_1949;
  assign or_1949 = select_1946[7] | (~({select_1946[5], select_1946[3], select_1946[1]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_1952;
  assign or_1952 = select_1946[7] | (~({select_1946[6], select_1946[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1048
  logic or_1955;
  assign or_1955 = select_1946[7] | (~(select_1946[6:4] == 3'h0));
  // hls/stages/agreement.hpp:788
  logic [5:0] select_1956;
  assign select_1956 = equal_556_s2_q ? x_s2_q[5:0] : {region_row_q, or_1955, or_1952, or_1949};
  // hls/stages/agreement.hpp:1128
  logic not_1957;
  assign not_1957 = ~equal_1589;
  // hls/stages/agreement.hpp:1058
  logic or_1961;
  assign or_1961 = (~sum_1959_s2_q) | equal_1751;
  // hls/stages/agreement.hpp:788
  logic and_1964;
  assign and_1964 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_1961));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_561_s2_q & (not_565_s2_q & and_590_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_618;
  // hls/stages/agreement.hpp:149
  logic and_1982;
  assign and_1982 = or_561_s2_q & (not_565_s2_q & and_1980_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_1991;
  assign and_1991 = inside_v_s2_q & and_1982;
  // hls/stages/agreement.hpp:1014
  logic select_1992;
  assign select_1992 = slot_s2_q[2] ? shown_shown_q : and_618;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_1992);
  // hls/stages/agreement.hpp:1014
  logic select_1995;
  assign select_1995 = slot_s2_q[2] ? shown_nearer_q : and_1567;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_1992 ? select_1995 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1270
  logic select_1998;
  assign select_1998 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1274
  logic select_1999;
  assign select_1999 = left_first_s2_q ? select_1998 : read_half_q;
  logic or_2000;
  assign or_2000 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1275
  logic [8:0] select_2001;
  assign select_2001 = or_2000 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1276
  logic [9:0] select_2003;
  assign select_2003 = left_first_s2_q ? 10'h1 : (or_2000 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1279
  logic and_2004;
  assign and_2004 = select_2001[8] & select_2003[9];
  // hls/stages/agreement.hpp:435
  logic next_row;
  assign next_row = and_2004 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1290
  logic [5:0] select_2007;
  assign select_2007 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_2009;
  assign select_2009 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_2007});
  // hls/stages/agreement.hpp:1300
  logic equal_2010;
  assign equal_2010 = seen_x_q == 3'h7;
  logic [7:0] select_2012;
  assign select_2012 = and_2004 ? 8'h0 : (seen_column_q + {7'h0, equal_2010});
  // hls/stages/agreement.hpp:1307
  logic [10:0] index;
  assign index = select_2009 + {3'h0, select_2012};
  // hls/stages/agreement.hpp:1260
  logic [11:0] sum_2014;
  assign sum_2014 = {1'b0, {2{select_1999}}, 2'h0, {2{select_1999}}, 1'b0, {2{select_1999}}, 1'b0, select_1999} + {1'b0, index};
  // hls/stages/agreement.hpp:1273
  logic not_2015;
  assign not_2015 = ~left_first_s2_q;
  // hls/stages/agreement.hpp:435
  logic and_2017;
  assign and_2017 = not_2015 & (began_q | and_2004);
  // hls/stages/agreement.hpp:1301
  logic [2:0] select_2019;
  assign select_2019 = and_2004 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1306
  logic and_2021;
  assign and_2021 = and_2017 & (select_2019 == 3'h0);
  logic less_2022;
  assign less_2022 = select_2012 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:437
  logic and_2023;
  assign and_2023 = and_2021 & less_2022;
  logic and_2024;
  assign and_2024 = and_1938_s2_q & and_2023;
  // hls/stages/agreement.hpp:278
  logic select_2026;
  assign select_2026 = and_1938_s2_q ? (left_first_s2_q ? and_2023 : and_2024) : and_2024;
  // hls/stages/agreement.hpp:1111
  logic [7:0] sum_2028;
  assign sum_2028 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_2028[7], sum_2028, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1260
  logic [11:0] sum_2030;
  assign sum_2030 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1030
  logic and_2031;
  assign and_2031 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2032;
  assign and_2032 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2033;
  assign and_2033 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2034;
  assign and_2034 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1087
  logic [1:0] sum_2036;
  assign sum_2036 = {1'b0, and_2033} + ({1'b0, textured} + {1'b0, and_2034});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2031} + ({2'h0, and_2032} + {1'b0, sum_2036});
  // hls/stages/agreement.hpp:1030
  logic [7:0] select_2045;
  assign select_2045 = inside_v_s2_q ? (sum_1959_s2_q ? select_1946 : {select_1946[6:0], 1'b0}) : select_1946;
  // hls/stages/agreement.hpp:1050
  logic or_2048;
  assign or_2048 = select_2045[7] | (~({select_2045[5], select_2045[3], select_2045[1]} == 3'h0));
  // hls/stages/agreement.hpp:1030
  logic and_2065;
  assign and_2065 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2066;
  assign and_2066 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2067;
  assign and_2067 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2068;
  assign and_2068 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_2070;
  assign sum_2070 = {1'b0, and_2067} + ({1'b0, shown} + {1'b0, and_2068});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2065} + ({2'h0, and_2066} + {1'b0, sum_2070});
  // hls/stages/agreement.hpp:1030
  logic and_2081;
  assign and_2081 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2082;
  assign and_2082 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2083;
  assign and_2083 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2084;
  assign and_2084 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2086;
  assign sum_2086 = {1'b0, and_2083} + ({1'b0, near} + {1'b0, and_2084});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2081} + ({2'h0, and_2082} + {1'b0, sum_2086});
  // hls/stages/agreement.hpp:788
  logic and_2102;
  assign and_2102 = ends_cell_s2_q & (and_2098_s2_q & (~({1'b0, sum_1629, last_s2_q[1:0]} < x_s2_q)));
  logic and_2104;
  assign and_2104 = not_557_s2_q & (so_s2_q & and_2102);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2136;
  assign select_2136 = sample_pair_whole_s2_q ? (and_530_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2138;
  assign select_2138 = sample_pair_whole_s2_q ? (and_530_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2157;
  assign select_2157 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2159;
  assign select_2159 = sample_pair_whole_s2_q ? (and_530_s2_q ? select_545 : averager_mask_q) : averager_mask_q;
  logic select_2161;
  assign select_2161 = sample_pair_whole_s2_q ? (and_530_s2_q ? select_549 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:520
  logic [8:0] select_2162;
  assign select_2162 = and_532_s2_q ? select_538 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2163;
  assign select_2163 = and_532_s2_q ? select_542 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2165;
  assign select_2165 = and_532_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2166;
  assign select_2166 = and_532_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2167;
  assign select_2167 = and_532_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2168;
  assign select_2168 = and_532_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2169;
  assign select_2169 = and_532_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2170;
  assign select_2170 = and_532_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2171;
  assign select_2171 = and_532_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2172;
  assign select_2172 = and_532_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2173;
  assign select_2173 = and_532_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2174;
  assign select_2174 = and_532_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2175;
  assign select_2175 = and_532_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2176;
  assign select_2176 = and_532_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2177;
  assign select_2177 = and_532_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2178;
  assign select_2178 = and_532_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2179;
  assign select_2179 = and_532_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2180;
  assign select_2180 = and_532_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2181;
  assign select_2181 = and_532_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2182;
  assign select_2182 = and_532_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2183;
  assign select_2183 = and_532_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2184;
  assign select_2184 = and_532_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2185;
  assign select_2185 = and_532_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2186;
  assign select_2186 = and_532_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2187;
  assign select_2187 = and_532_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2188;
  assign select_2188 = and_532_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2189;
  assign select_2189 = and_532_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2190;
  assign select_2190 = and_532_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2191;
  assign select_2191 = and_532_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2192;
  assign select_2192 = and_532_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2193;
  assign select_2193 = and_532_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2194;
  assign select_2194 = and_532_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2195;
  assign select_2195 = and_532_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2196;
  assign select_2196 = and_532_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2197;
  assign select_2197 = and_532_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2198;
  assign select_2198 = and_532_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2199;
  assign select_2199 = and_532_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2200;
  assign select_2200 = and_532_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2201;
  assign select_2201 = and_532_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2202;
  assign select_2202 = and_532_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2203;
  assign select_2203 = and_532_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2204;
  assign select_2204 = and_532_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2205;
  assign select_2205 = and_532_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2206;
  assign select_2206 = and_532_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2207;
  assign select_2207 = and_532_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2208;
  assign select_2208 = and_532_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2209;
  assign select_2209 = and_532_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2210;
  assign select_2210 = and_532_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2211;
  assign select_2211 = and_532_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2212;
  assign select_2212 = and_532_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2213;
  assign select_2213 = and_532_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2214;
  assign select_2214 = and_532_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2215;
  assign select_2215 = and_532_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2216;
  assign select_2216 = and_532_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2217;
  assign select_2217 = and_532_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:274
  logic [9:0] difference_2219;
  assign difference_2219 = {1'b0, select_542} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2220;
  assign xor_2220 = difference_2219[8:0] ^ {9{difference_2219[9]}};
  logic [9:0] sum_2221;
  assign sum_2221 = {9'h0, difference_2219[9]} + {1'b0, xor_2220};
  logic [9:0] difference_2222;
  assign difference_2222 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2223;
  assign xor_2223 = difference_2222[8:0] ^ {9{difference_2222[9]}};
  logic [9:0] sum_2224;
  assign sum_2224 = {9'h0, difference_2222[9]} + {1'b0, xor_2223};
  logic [9:0] difference_2226;
  assign difference_2226 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2227;
  assign xor_2227 = difference_2226[8:0] ^ {9{difference_2226[9]}};
  logic [9:0] sum_2228;
  assign sum_2228 = {9'h0, difference_2226[9]} + {1'b0, xor_2227};
  logic [10:0] sum_2229;
  assign sum_2229 = ({1'b0, sum_2221} + {1'b0, sum_2224}) + {1'b0, sum_2228};
  logic [9:0] difference_2230;
  assign difference_2230 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2231;
  assign xor_2231 = difference_2230[8:0] ^ {9{difference_2230[9]}};
  logic [9:0] sum_2232;
  assign sum_2232 = {9'h0, difference_2230[9]} + {1'b0, xor_2231};
  logic [9:0] difference_2234;
  assign difference_2234 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2235;
  assign xor_2235 = difference_2234[8:0] ^ {9{difference_2234[9]}};
  // hls/stages/agreement.hpp:1003
  logic [13:0] select_2261;
  assign select_2261 = less_568_s2_q ? moments_turned_0_q : ({13'h0, and_1578} + (and_553_s2_q ? 14'h0 : moments_turned_0_q));
  // hls/stages/agreement.hpp:788
  logic [13:0] select_2263;
  assign select_2263 = equal_560_s2_q ? (inside_v_s2_q ? select_2261 : moments_turned_0_q) : moments_turned_0_q;
  logic [13:0] select_2265;
  assign select_2265 = equal_556_s2_q ? moments_turned_0_q : (so_s2_q ? moments_turned_0_q : select_2263);
  // hls/stages/agreement.hpp:1003
  logic [13:0] select_2268;
  assign select_2268 = less_568_s2_q ? moments_turned_1_q : ({13'h0, and_1587} + (and_553_s2_q ? 14'h0 : moments_turned_1_q));
  // hls/stages/agreement.hpp:788
  logic [13:0] select_2270;
  assign select_2270 = equal_560_s2_q ? (inside_v_s2_q ? select_2268 : moments_turned_1_q) : moments_turned_1_q;
  logic [13:0] select_2272;
  assign select_2272 = equal_556_s2_q ? moments_turned_1_q : (so_s2_q ? moments_turned_1_q : select_2270);
  // hls/stages/agreement.hpp:1147
  logic equal_2273;
  assign equal_2273 = x_s2_q[6:0] == 7'h7f;
  logic equal_2274;
  assign equal_2274 = x_s2_q[6:0] == 7'h70;
  // hls/stages/agreement.hpp:788
  logic [13:0] select_2276;
  assign select_2276 = equal_2273 ? moments_before_0_q : (equal_2274 ? moments_turned_0_q : moments_before_0_q);
  logic [13:0] select_2279;
  assign select_2279 = equal_2273 ? moments_before_1_q : (equal_2274 ? moments_turned_1_q : moments_before_1_q);
  logic select_2282;
  assign select_2282 = equal_2273 ? moments_has_before_q : (moments_has_before_q | equal_2274);
  // hls/stages/moments.hpp:72
  logic [13:0] most_before;
  assign most_before = (moments_before_1_q < moments_before_0_q) ? moments_before_0_q : moments_before_1_q;
  // hls/stages/moments.hpp:93
  logic [14:0] sum_2286;
  assign sum_2286 = {1'b0, most_before} + 15'h3;
  logic not_2288;
  assign not_2288 = ~({3'h0, counts_turned_left_q[13:2]} < sum_2286);
  logic [14:0] sum_2289;
  assign sum_2289 = {1'b0, moments_turned_1_q} + 15'h3;
  logic less_2290;
  assign less_2290 = {3'h0, counts_turned_left_q[13:2]} < sum_2289;
  // hls/stages/moments.hpp:77
  logic select_2295;
  assign select_2295 = (not_2288 | less_2290) ? (~less_2290) : (~({3'h0, moments_before_1_q[13:2]} < sum_2289));
  // hls/stages/moments.hpp:93
  logic not_2297;
  assign not_2297 = ~({3'h0, counts_turned_right_q[13:2]} < sum_2286);
  logic [14:0] sum_2298;
  assign sum_2298 = {1'b0, moments_turned_0_q} + 15'h3;
  logic less_2299;
  assign less_2299 = {3'h0, counts_turned_right_q[13:2]} < sum_2298;
  // hls/stages/agreement.hpp:1144
  logic select_2304;
  assign select_2304 = (not_2297 | less_2299) ? (~less_2299) : (~({3'h0, moments_before_0_q[13:2]} < sum_2298));
  // hls/stages/moments.hpp:80
  logic or_2309;
  assign or_2309 = (select_2295 | select_2304) | (moments_out_of_step_q & (~(not_2288 & not_2297)));
  // hls/stages/moments.hpp:82
  logic and_2311;
  assign and_2311 = cfg_prove_i & (cfg_same_table_i ? or_2309 : moments_out_of_step_q);
  // hls/stages/agreement.hpp:788
  logic select_2313;
  assign select_2313 = equal_2273 ? moments_out_of_step_q : (equal_2274 ? and_2311 : moments_out_of_step_q);
  // hls/stages/census.hpp:359
  logic [9:0] difference_2325;
  assign difference_2325 = {1'b0, select_538} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2325[9]} + (difference_2325[8:0] ^ {9{difference_2325[9]}});
  logic [9:0] difference_2337;
  assign difference_2337 = {1'b0, select_542} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2337[9]} + (difference_2337[8:0] ^ {9{difference_2337[9]}});
  // hls/stages/agreement.hpp:239
  logic [5:0] select_2528;
  assign select_2528 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2529;
  assign select_2529 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2530;
  assign select_2530 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2531;
  assign select_2531 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2532;
  assign select_2532 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2533;
  assign select_2533 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2537;
  assign select_2537 = slot_s2_q[0] ? 8'h0 : sum_993;
  // hls/stages/agreement.hpp:751
  logic less_2538;
  assign less_2538 = select_2537 < select_1493;
  // hls/stages/agreement.hpp:239
  logic [6:0] select_2540;
  assign select_2540 = slot_s2_q[0] ? 7'h0 : sum_1519;
  // hls/stages/agreement.hpp:788
  logic not_2545;
  assign not_2545 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2546;
  assign less_2546 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:520
  logic and_2553;
  assign and_2553 = and_532_s2_q & (equal_661_s2_q & equal_2428_s2_q);
  // hls/stages/agreement.hpp:788
  logic and_2559;
  assign and_2559 = not_557_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2555_s2_q)));
  // hls/stages/agreement.hpp:1030
  logic and_2579;
  assign and_2579 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2580;
  assign and_2580 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2581;
  assign and_2581 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2582;
  assign and_2582 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2584;
  assign sum_2584 = {1'b0, and_2581} + ({1'b0, explained} + {1'b0, and_2582});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2579} + ({2'h0, and_2580} + {1'b0, sum_2584});
  // hls/stages/agreement.hpp:788
  logic and_2620;
  assign and_2620 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2555_s2_q & and_1982)));
  // hls/stages/agreement.hpp:986
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:987
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:988
  logic [7:0] difference_2644;
  assign difference_2644 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2647;
  assign less_2647 = {2'h0, difference_2644[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_2650;
  assign and_2650 = not_565_s2_q & (((and_1980_s2_q & and_616) & equal_2640_s2_q) & (~less_2647));
  // hls/stages/agreement.hpp:788
  logic and_2654;
  assign and_2654 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_561_s2_q & and_2650)));
  // hls/stages/agreement.hpp:149
  logic and_2659;
  assign and_2659 = not_565_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_2661;
  assign and_2661 = not_565_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2662;
  assign select_2662 = or_561_s2_q ? {and_2661, and_2659} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_2664;
  assign select_2664 = less_564_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_2665;
  assign select_2665 = or_561_s2_q ? select_2664 : 2'h0;
  // hls/stages/agreement.hpp:1027
  logic and_2667;
  assign and_2667 = and_618 & (select_2662[0] & select_2665[0]);
  // hls/stages/agreement.hpp:788
  logic and_2671;
  assign and_2671 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2662[1] & and_2667)));
  logic and_2672;
  assign and_2672 = not_557_s2_q & and_2671;
  logic and_2678;
  assign and_2678 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_2665[1] & and_2667)));
  logic and_2679;
  assign and_2679 = not_557_s2_q & and_2678;
  // hls/stages/registration.hpp:76
  logic less_2682;
  assign less_2682 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_2684;
  assign select_2684 = or_561_s2_q ? (less_564_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2686;
  assign select_2686 = or_561_s2_q ? (less_564_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2688;
  assign select_2688 = or_561_s2_q ? (less_564_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2686} - {1'b0, select_2688};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2690;
  assign select_2690 = rise_2[8] ? select_2686 : select_2688;
  logic [8:0] fall;
  assign fall = {1'b0, select_2684} - {1'b0, select_2690};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2693;
  assign not_2693 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2682 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2693};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2695;
  assign xor_2695 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2695};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2701;
  assign select_2701 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2682 ? {taken, 1'b1} : {not_2693, select_2701, not_2693};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2703;
  assign sum_2703 = {left, 1'b1} + {taken_2, less_2682};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_2705;
  assign select_2705 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2707;
  assign select_2707 = equal_556_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_2709;
  assign select_2709 = equal_556_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2710;
  assign equal_2710 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_2714;
  assign and_2714 = and_618 & less_1684_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_2716;
  assign select_2716 = or_561_s2_q ? (less_564_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2720;
  assign sum_2720 = select_2716[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2723;
  assign select_2723 = (select_2686 < select_2688) ? ({sum_2720, select_2716[0], 5'h0} - {3'h0, select_2705}) : {sum_2720, select_2716[0], select_2705};
  logic [7:0] select_2724;
  assign select_2724 = ((select_2716 == 3'h0) | (select_2716 == 3'h4)) ? {sum_2720, select_2716[0], 5'h0} : select_2723;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2724[7]}}, select_2724} - {sum_1703[9], sum_1703, sum_1699[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2727;
  assign select_2727 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2727[11:7])) ? 12'h7f : select_2727;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2748;
  assign difference_2748 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2750;
  assign and_2750 = and_2714 & ($signed(difference_2748) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2763;
  assign less_2763 = $signed(difference_2748) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:788
  logic select_2771;
  assign select_2771 = so_s2_q ? (equal_2710 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2774;
  assign select_2774 = so_s2_q ? (equal_1685 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2779;
  assign select_2779 = (sum_1595 == 2'h2) ? (registration_fresh_q & (~select_1642)) : registration_fresh_q;
  // hls/stages/agreement.hpp:788
  logic [3:0] select_2781;
  assign select_2781 = so_s2_q ? (and_1637 ? select_2779 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2783;
  assign select_2783 = and_2553 ? 4'hf : (equal_556_s2_q ? registration_fresh_q : select_2781);
  // hls/stages/agreement.hpp:1129
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1592;
  // hls/stages/registration.hpp:258
  logic not_2804;
  assign not_2804 = ~quarter_2[1];
  logic [3:0] select_2805;
  assign select_2805 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2804, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2804};
  // hls/stages/patches.hpp:91
  logic parity_2939;
  assign parity_2939 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:460
  logic [15:0] select_2940;
  assign select_2940 = equal_2428_s2_q ? {patches_chance_q[14:0], parity_2939} : patches_chance_q;
  // hls/stages/patches.hpp:344
  logic not_2942;
  assign not_2942 = ~and_1756;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_2944;
  assign select_2944 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2944};
  // hls/stages/agreement.hpp:788
  logic and_2950;
  assign and_2950 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:156
  logic and_2954;
  assign and_2954 = not_2942 & (patches_fixed_q | ((not_557_s2_q & and_2950) & and_1731));
  // hls/stages/patches.hpp:353
  logic not_2967;
  assign not_2967 = ~select_1674[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_2969;
  assign select_2969 = sample_pair_whole_s2_q ? (equal_1675 ? select_1674 : {not_2967, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:517
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3068;
  assign select_3068 = or_1764_s2_q ? {less_1892_s2_q, less_1891_s2_q, less_1882_s2_q, less_1881_s2_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3070;
  assign select_3070 = equal_1758_s2_q ? patches_codes_at_q : (equal_1760_s2_q ? other[55:4] : select_3068);
  // hls/stages/patches.hpp:500
  logic [27:0] word;
  assign word = or_1864_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:516
  logic [27:0] select_3073;
  assign select_3073 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3075;
  assign select_3075 = equal_1760_s2_q ? (new_row_s2_q ? word : select_3073) : patches_codes_further_q;
  // hls/stages/patches.hpp:518
  logic [55:0] select_3077;
  assign select_3077 = less_1851_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:488
  logic [55:0] select_3079;
  assign select_3079 = less_3078_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3081;
  assign select_3081 = or_1764_s2_q ? (equal_1763_s2_q ? patches_next_codes_q : select_3079) : patches_next_codes_q;
  logic [55:0] select_3083;
  assign select_3083 = equal_1758_s2_q ? patches_next_codes_q : (equal_1760_s2_q ? select_3077 : select_3081);
  // hls/stages/count_bits.hpp:24
  logic parity_3088;
  assign parity_3088 = ^{less_1892_s2_q, less_1891_s2_q, less_1882_s2_q, less_1881_s2_q};
  // hls/stages/count_bits.hpp:25
  logic or_3092;
  assign or_3092 = ({less_1882_s2_q, less_1881_s2_q} == 2'h3) | (less_1891_s2_q & (less_1882_s2_q | less_1881_s2_q));
  logic and_3093;
  assign and_3093 = less_1892_s2_q & (^{less_1891_s2_q, less_1882_s2_q, less_1881_s2_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3094;
  assign xor_3094 = or_3092 ^ and_3093;
  // hls/stages/count_bits.hpp:27
  logic and_3095;
  assign and_3095 = or_3092 & and_3093;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3097;
  assign select_3097 = or_1764_s2_q ? (and_1915_s2_q ? {and_3095, xor_3094, parity_3088} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3101;
  assign sum_3101 = {7'h0, patches_set_q} + (equal_1763_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:517
  logic [47:0] select_3111;
  assign select_3111 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3113;
  assign select_3113 = equal_1758_s2_q ? patches_left_row_q : (equal_1760_s2_q ? select_3111 : patches_left_row_q);
  // hls/stages/patches.hpp:519
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3111;
  // hls/stages/count_bits.hpp:24
  logic xor_3117;
  assign xor_3117 = bits[17] ^ (^{select_3111[16:15], other[16:15]});
  logic xor_3120;
  assign xor_3120 = bits[11] ^ (^{select_3111[10:9], other[10:9]});
  logic xor_3123;
  assign xor_3123 = bits[14] ^ (^{select_3111[13:12], other[13:12]});
  logic xor_3126;
  assign xor_3126 = xor_3117 ^ (^{select_3111[14:9], other[14:9]});
  logic xor_3129;
  assign xor_3129 = bits[47] ^ (^{select_3111[46:45], other[46:45]});
  logic xor_3132;
  assign xor_3132 = bits[8] ^ (^{select_3111[7:6], other[7:6]});
  logic xor_3135;
  assign xor_3135 = bits[2] ^ (^{select_3111[1:0], other[1:0]});
  logic xor_3138;
  assign xor_3138 = bits[5] ^ (^{select_3111[4:3], other[4:3]});
  logic xor_3141;
  assign xor_3141 = xor_3132 ^ (^{select_3111[5:0], other[5:0]});
  logic parity_3143;
  assign parity_3143 = ^{select_3111[47:45], select_3111[8:0], other[47:45], other[8:0]};
  logic xor_3144;
  assign xor_3144 = xor_3126 ^ parity_3143;
  logic xor_3147;
  assign xor_3147 = bits[44] ^ (^{select_3111[43:42], other[43:42]});
  logic xor_3150;
  assign xor_3150 = bits[38] ^ (^{select_3111[37:36], other[37:36]});
  logic xor_3153;
  assign xor_3153 = bits[41] ^ (^{select_3111[40:39], other[40:39]});
  logic xor_3159;
  assign xor_3159 = bits[26] ^ (^{select_3111[25:24], other[25:24]});
  logic xor_3162;
  assign xor_3162 = bits[20] ^ (^{select_3111[19:18], other[19:18]});
  logic xor_3165;
  assign xor_3165 = bits[23] ^ (^{select_3111[22:21], other[22:21]});
  logic xor_3168;
  assign xor_3168 = xor_3159 ^ (^{select_3111[23:18], other[23:18]});
  logic xor_3171;
  assign xor_3171 = bits[35] ^ (^{select_3111[34:33], other[34:33]});
  logic xor_3174;
  assign xor_3174 = bits[29] ^ (^{select_3111[28:27], other[28:27]});
  logic xor_3177;
  assign xor_3177 = bits[32] ^ (^{select_3111[31:30], other[31:30]});
  logic xor_3180;
  assign xor_3180 = xor_3171 ^ (^{select_3111[32:27], other[32:27]});
  logic xor_3181;
  assign xor_3181 = xor_3168 ^ xor_3180;
  // hls/stages/count_bits.hpp:25
  logic or_3189;
  assign or_3189 = (xor_3120 & xor_3123) | (xor_3117 & (xor_3120 | xor_3123));
  logic or_3193;
  assign or_3193 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3197;
  assign or_3197 = (xor_3135 & xor_3138) | (xor_3132 & (xor_3135 | xor_3138));
  // hls/stages/count_bits.hpp:23
  logic or_3204;
  assign or_3204 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3208;
  assign or_3208 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3212;
  assign or_3212 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3215;
  assign parity_3215 = ^{or_3212, or_3208, or_3204};
  // hls/stages/count_bits.hpp:23
  logic or_3219;
  assign or_3219 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3223;
  assign or_3223 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3227;
  assign or_3227 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3230;
  assign parity_3230 = ^{or_3227, or_3223, or_3219};
  logic parity_3233;
  assign parity_3233 = ^{or_3227, or_3223, or_3219, or_3212, or_3208, or_3204, or_3197, or_3193, or_3189};
  // hls/stages/count_bits.hpp:23
  logic or_3237;
  assign or_3237 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3241;
  assign or_3241 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3245;
  assign or_3245 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3253;
  assign or_3253 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3257;
  assign or_3257 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3261;
  assign or_3261 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3264;
  assign parity_3264 = ^{or_3261, or_3257, or_3253};
  // hls/stages/count_bits.hpp:23
  logic or_3268;
  assign or_3268 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3272;
  assign or_3272 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3276;
  assign or_3276 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3279;
  assign parity_3279 = ^{or_3276, or_3272, or_3268};
  logic parity_3282;
  assign parity_3282 = ^{or_3276, or_3272, or_3268, or_3261, or_3257, or_3253, or_3245, or_3241, or_3237};
  // hls/stages/count_bits.hpp:25
  logic or_3286;
  assign or_3286 = (xor_3150 & xor_3153) | (xor_3147 & (xor_3150 | xor_3153));
  logic or_3290;
  assign or_3290 = (xor_3162 & xor_3165) | (xor_3159 & (xor_3162 | xor_3165));
  logic or_3294;
  assign or_3294 = (xor_3174 & xor_3177) | (xor_3171 & (xor_3174 | xor_3177));
  // hls/stages/count_bits.hpp:24
  logic parity_3297;
  assign parity_3297 = ^{or_3294, or_3290, or_3286};
  // hls/stages/count_bits.hpp:25
  logic and_3298;
  assign and_3298 = xor_3144 & (^{xor_3181, select_3111[44:36], other[44:36]});
  logic or_3302;
  assign or_3302 = (xor_3129 & xor_3141) | (xor_3126 & (xor_3129 | xor_3141));
  logic and_3305;
  assign and_3305 = (xor_3147 ^ (^{select_3111[41:36], other[41:36]})) & (xor_3168 | xor_3180);
  logic or_3306;
  assign or_3306 = (xor_3168 & xor_3180) | and_3305;
  // hls/stages/count_bits.hpp:24
  logic parity_3309;
  assign parity_3309 = ^{or_3306, or_3302, and_3298};
  logic parity_3312;
  assign parity_3312 = ^{or_3306, or_3302, and_3298, or_3294, or_3290, or_3286, or_3276, or_3272, or_3268, or_3261, or_3257, or_3253, or_3245, or_3241, or_3237};
  logic parity_3314;
  assign parity_3314 = ^{or_3306, or_3302, and_3298, or_3294, or_3290, or_3286, or_3276, or_3272, or_3268, or_3261, or_3257, or_3253, or_3245, or_3241, or_3237, or_3227, or_3223, or_3219, or_3212, or_3208, or_3204, or_3197, or_3193, or_3189};
  // hls/stages/count_bits.hpp:25
  logic and_3315;
  assign and_3315 = parity_3233 & parity_3312;
  logic or_3319;
  assign or_3319 = (parity_3215 & parity_3230) | ((^{or_3197, or_3193, or_3189}) & (parity_3215 | parity_3230));
  logic or_3323;
  assign or_3323 = (parity_3297 & parity_3309) | (parity_3282 & (parity_3297 | parity_3309));
  logic or_3330;
  assign or_3330 = (parity_3264 & parity_3279) | ((^{or_3245, or_3241, or_3237}) & (parity_3264 | parity_3279));
  logic or_3334;
  assign or_3334 = (or_3290 & or_3294) | (or_3286 & (or_3290 | or_3294));
  logic or_3338;
  assign or_3338 = (or_3302 & or_3306) | (and_3298 & (or_3302 | or_3306));
  // hls/stages/count_bits.hpp:23
  logic or_3345;
  assign or_3345 = (or_3241 & or_3245) | (or_3237 & (or_3241 | or_3245));
  // hls/stages/count_bits.hpp:25
  logic or_3349;
  assign or_3349 = (or_3257 & or_3261) | (or_3253 & (or_3257 | or_3261));
  logic or_3353;
  assign or_3353 = (or_3272 & or_3276) | (or_3268 & (or_3272 | or_3276));
  // hls/stages/count_bits.hpp:24
  logic parity_3356;
  assign parity_3356 = ^{or_3353, or_3349, or_3345};
  // hls/stages/count_bits.hpp:23
  logic or_3360;
  assign or_3360 = (or_3193 & or_3197) | (or_3189 & (or_3193 | or_3197));
  // hls/stages/count_bits.hpp:25
  logic or_3364;
  assign or_3364 = (or_3208 & or_3212) | (or_3204 & (or_3208 | or_3212));
  logic or_3368;
  assign or_3368 = (or_3223 & or_3227) | (or_3219 & (or_3223 | or_3227));
  // hls/stages/count_bits.hpp:24
  logic parity_3371;
  assign parity_3371 = ^{or_3368, or_3364, or_3360};
  logic parity_3374;
  assign parity_3374 = ^{or_3368, or_3364, or_3360, or_3353, or_3349, or_3345, or_3338, or_3334, or_3330};
  logic parity_3376;
  assign parity_3376 = ^{or_3368, or_3364, or_3360, or_3353, or_3349, or_3345, or_3338, or_3334, or_3330, or_3323, or_3319, and_3315};
  // hls/stages/count_bits.hpp:25
  logic or_3380;
  assign or_3380 = (or_3334 & or_3338) | (or_3330 & (or_3334 | or_3338));
  logic or_3384;
  assign or_3384 = (or_3349 & or_3353) | (or_3345 & (or_3349 | or_3353));
  logic or_3388;
  assign or_3388 = (or_3364 & or_3368) | (or_3360 & (or_3364 | or_3368));
  // hls/stages/count_bits.hpp:24
  logic parity_3391;
  assign parity_3391 = ^{or_3388, or_3384, or_3380};
  // hls/stages/count_bits.hpp:25
  logic and_3392;
  assign and_3392 = (^{or_3323, or_3319, and_3315}) & parity_3374;
  logic or_3396;
  assign or_3396 = (or_3319 & or_3323) | (and_3315 & (or_3319 | or_3323));
  logic or_3400;
  assign or_3400 = (parity_3356 & parity_3371) | ((^{or_3338, or_3334, or_3330}) & (parity_3356 | parity_3371));
  // hls/stages/count_bits.hpp:24
  logic parity_3403;
  assign parity_3403 = ^{or_3400, or_3396, and_3392};
  // hls/stages/count_bits.hpp:25
  logic and_3405;
  assign and_3405 = parity_3391 & parity_3403;
  logic or_3409;
  assign or_3409 = (or_3384 & or_3388) | (or_3380 & (or_3384 | or_3388));
  logic or_3413;
  assign or_3413 = (or_3396 & or_3400) | (and_3392 & (or_3396 | or_3400));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3458;
  assign select_3458 = equal_1760_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3461;
  assign select_3461 = equal_1758_s2_q ? patches_summed_first_q : (equal_1760_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:551
  logic [9:0] select_3468;
  assign select_3468 = less_1921_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3471;
  assign select_3471 = equal_1924_s2_q ? (less_1921_s2_q ? (equal_1924_s2_q ? 10'h0 : select_3468) : 10'h0) : select_3468;
  logic [9:0] select_3473;
  assign select_3473 = less_1921_s2_q ? (equal_1922_s2_q ? 10'h0 : select_3471) : select_3471;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3475;
  assign select_3475 = less_1921_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3478;
  assign select_3478 = equal_1924_s2_q ? (less_1921_s2_q ? (equal_1924_s2_q ? 5'h0 : select_3475) : 5'h0) : select_3475;
  logic [4:0] select_3480;
  assign select_3480 = less_1921_s2_q ? (equal_1922_s2_q ? 5'h0 : select_3478) : select_3478;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3482;
  assign select_3482 = less_1921_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3485;
  assign select_3485 = equal_1924_s2_q ? (less_1921_s2_q ? (equal_1924_s2_q ? 5'h0 : select_3482) : 5'h0) : select_3482;
  logic [4:0] select_3487;
  assign select_3487 = less_1921_s2_q ? (equal_1922_s2_q ? 5'h0 : select_3485) : select_3485;
  // hls/stages/patches.hpp:551
  logic and_3490;
  assign and_3490 = less_1921_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:555
  logic select_3493;
  assign select_3493 = equal_1924_s2_q ? (less_1921_s2_q ? (not_1925_s2_q & and_3490) : and_3490) : and_3490;
  // hls/stages/patches.hpp:184
  logic select_3496;
  assign select_3496 = equal_1758_s2_q ? (less_1921_s2_q ? (not_1923_s2_q & select_3493) : select_3493) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3507;
  assign or_3507 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3508;
  assign and_3508 = patches_read_searches_s2_q & or_3507;
  // hls/stages/patches.hpp:535
  logic [4:0] select_3509;
  assign select_3509 = and_3508 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:542
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3509};
  // hls/stages/patches.hpp:551
  logic and_3513;
  assign and_3513 = less_1921_s2_q & (equal_3505_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:555
  logic select_3516;
  assign select_3516 = equal_1924_s2_q ? (less_1921_s2_q ? (not_1925_s2_q & and_3513) : and_3513) : and_3513;
  // hls/stages/patches.hpp:184
  logic select_3519;
  assign select_3519 = equal_1758_s2_q ? (less_1921_s2_q ? (not_1923_s2_q & select_3516) : select_3516) : patches_read_above_q;
  // hls/stages/patches.hpp:551
  logic and_3522;
  assign and_3522 = less_1921_s2_q & (equal_3505_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:555
  logic select_3525;
  assign select_3525 = equal_1924_s2_q ? (less_1921_s2_q ? (not_1925_s2_q & and_3522) : and_3522) : and_3522;
  // hls/stages/patches.hpp:184
  logic select_3528;
  assign select_3528 = equal_1758_s2_q ? (less_1921_s2_q ? (not_1923_s2_q & select_3525) : select_3525) : patches_read_below_q;
  // hls/stages/patches.hpp:548
  logic [6:0] sum_3529;
  assign sum_3529 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:549
  logic [9:0] select_3532;
  assign select_3532 = (equal_3505_s2_q & ({sum_3529[6], sum_3529} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3533;
  assign select_3533 = less_1921_s2_q ? select_3532 : 10'h3ff;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3535;
  assign select_3535 = less_1921_s2_q ? (equal_1924_s2_q ? 10'h3ff : select_3533) : 10'h3ff;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3536;
  assign select_3536 = equal_1924_s2_q ? select_3535 : select_3533;
  logic [9:0] select_3538;
  assign select_3538 = less_1921_s2_q ? (equal_1922_s2_q ? 10'h3ff : select_3536) : select_3536;
  // hls/stages/patches.hpp:534
  logic [14:0] select_3540;
  assign select_3540 = and_3508 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3541;
  assign select_3541 = equal_1758_s2_q ? select_3540[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3542;
  assign select_3542 = equal_1758_s2_q ? select_3540[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:536
  logic [9:0] select_3544;
  assign select_3544 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3546;
  assign select_3546 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3549;
  assign select_3549 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3550;
  assign select_3550 = patches_read_first_q ? patches_read_far_q : select_3549;
  // hls/stages/patches.hpp:589
  logic [9:0] difference_3553;
  assign difference_3553 = select_3550 - select_3540[9:0];
  // hls/stages/patches.hpp:574
  logic less_3583;
  assign less_3583 = select_3544 < select_3546;
  // hls/stages/patches.hpp:580
  logic [1:0] sum_3584;
  assign sum_3584 = select_3509[4:3] + 2'h3;
  // hls/stages/patches.hpp:575
  logic [9:0] high;
  assign high = less_3583 ? select_3546 : select_3544;
  logic [9:0] low;
  assign low = (select_3546 < select_3544) ? select_3546 : select_3544;
  // hls/stages/patches.hpp:576
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3540[9:0];
  // hls/stages/patches.hpp:578
  logic not_3591;
  assign not_3591 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3592;
  assign sum_3592 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3594;
  assign not_3594 = ~({eight, 3'h0} < {1'b0, sum_3592, fall_2[0]});
  logic [1:0] sum_3595;
  assign sum_3595 = {1'b0, not_3591} + {1'b0, not_3594};
  // hls/stages/patches.hpp:579
  logic [10:0] sum_3596;
  assign sum_3596 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3598;
  assign not_3598 = ~({eight, 3'h0} < {sum_3596, fall_2[1:0]});
  logic not_3601;
  assign not_3601 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3602;
  assign sum_3602 = {1'b0, not_3598} + {1'b0, not_3601};
  // hls/stages/patches.hpp:578
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3595} + {1'b0, sum_3602};
  // hls/stages/patches.hpp:581
  logic [7:0] select_3605;
  assign select_3605 = less_3583 ? ({sum_3584, select_3509[2:0], 3'h0} - {5'h0, fraction}) : {sum_3584, select_3509[2:0], fraction};
  // hls/stages/agreement.hpp:788
  logic select_3830;
  assign select_3830 = equal_556_s2_q ? shown_shown_q : (so_s2_q ? select_1992 : shown_shown_q);
  logic select_3832;
  assign select_3832 = equal_556_s2_q ? shown_nearer_q : (so_s2_q ? select_1995 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3834;
  assign sum_3834 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:460
  logic [2:0] select_3836;
  assign select_3836 = less_3833_s2_q ? (sum_3834[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3838;
  assign select_3838 = equal_2428_s2_q ? (equal_661_s2_q ? 3'h0 : select_3836) : region_row_q;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3843;
  assign select_3843 = equal_556_s2_q ? select_1946 : (so_s2_q ? (ends_cell_s2_q ? select_2045 : select_1946) : 8'h1);
  // hls/stages/agreement.hpp:460
  logic [8:0] select_3857;
  assign select_3857 = equal_661_s2_q ? {{2{difference_3855[6]}}, difference_3855} : (less_3833_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:520
  logic [8:0] select_3859;
  assign select_3859 = and_532_s2_q ? (equal_2428_s2_q ? select_3857 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:460
  logic [6:0] select_3861;
  assign select_3861 = equal_661_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:520
  logic [6:0] select_3863;
  assign select_3863 = and_532_s2_q ? (equal_2428_s2_q ? select_3861 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3864;
  assign sum_3864 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3865;
  assign select_3865 = sum_3834[7] ? {1'b1, sum_3834[6:0], region_down_rest_q[0]} : sum_3864;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3834[7];
  // hls/stages/agreement.hpp:460
  logic select_3869;
  assign select_3869 = equal_2428_s2_q ? (equal_661_s2_q | (less_3833_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_3874;
  assign or_3874 = segment_starts_q | not_559_s2_q;
  // hls/stages/agreement.hpp:1030
  logic select_3877;
  assign select_3877 = inside_v_s2_q ? (sum_1959_s2_q ? (equal_1751 & or_1961) : or_1961) : or_3874;
  // hls/stages/agreement.hpp:788
  logic select_3880;
  assign select_3880 = equal_556_s2_q ? or_3874 : (so_s2_q ? (ends_cell_s2_q ? select_3877 : or_3874) : or_3874);
  logic select_4039;
  assign select_4039 = so_s2_q ? (ends_cell_s2_q ? and_2033 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4042;
  assign select_4042 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4044;
  assign select_4044 = equal_556_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4042 : centres_values_0_of_skin_q);
  logic select_4045;
  assign select_4045 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4047;
  assign select_4047 = equal_556_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4045 : centres_values_1_textured_q);
  logic select_4048;
  assign select_4048 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4050;
  assign select_4050 = equal_556_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4048 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:460
  logic [10:0] select_4054;
  assign select_4054 = equal_2428_s2_q ? (equal_4051_s2_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:520
  logic [5:0] select_4057;
  assign select_4057 = and_532_s2_q ? (equal_2428_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1270
  logic xor_4058;
  assign xor_4058 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:437
  logic select_4060;
  assign select_4060 = and_1938_s2_q ? (left_first_s2_q ? xor_4058 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:278
  logic select_4062;
  assign select_4062 = and_1938_s2_q ? (left_first_s2_q ? xor_4058 : select_4060) : write_half_q;
  logic select_4064;
  assign select_4064 = left_first_s2_q ? select_1998 : (and_1938_s2_q ? select_1999 : read_half_q);
  logic and_4068;
  assign and_4068 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_4077;
  assign select_4077 = left_first_s2_q ? 10'h1 : (and_1938_s2_q ? select_2003 : rows_passed_q);
  logic [8:0] select_4080;
  assign select_4080 = left_first_s2_q ? {select_2001[7:0], or_2000} : (and_1938_s2_q ? {select_2001[7:0], or_2000} : columns_passed_q);
  logic select_4083;
  assign select_4083 = left_first_s2_q ? marks_last_s2_q : (and_1938_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_4086;
  assign select_4086 = left_first_s2_q ? and_2017 : (and_1938_s2_q ? and_2017 : began_q);
  logic [2:0] select_4089;
  assign select_4089 = left_first_s2_q ? select_2019 : (and_1938_s2_q ? select_2019 : seen_x_q);
  // hls/stages/agreement.hpp:1299
  logic [2:0] select_4094;
  assign select_4094 = left_first_s2_q ? 3'h0 : (and_2004 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:278
  logic [2:0] select_4096;
  assign select_4096 = left_first_s2_q ? 3'h0 : (and_1938_s2_q ? select_4094 : seen_y_q);
  logic [7:0] select_4099;
  assign select_4099 = left_first_s2_q ? select_2012 : (and_1938_s2_q ? select_2012 : seen_column_q);
  // hls/stages/agreement.hpp:435
  logic [7:0] select_4105;
  assign select_4105 = left_first_s2_q ? select_4103 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:278
  logic [7:0] select_4107;
  assign select_4107 = left_first_s2_q ? select_4103 : (and_1938_s2_q ? select_4105 : seen_rows_left_q);
  // hls/stages/agreement.hpp:435
  logic and_4112;
  assign and_4112 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:278
  logic select_4114;
  assign select_4114 = left_first_s2_q ? and_4112 : (and_1938_s2_q ? and_4112 : at_cell_end_q);
  logic select_4117;
  assign select_4117 = left_first_s2_q ? next_row : (and_1938_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_4120;
  assign select_4120 = left_first_s2_q ? 11'h0 : (and_1938_s2_q ? select_2009 : seen_base_q);
  // hls/stages/agreement.hpp:788
  logic and_4187;
  assign and_4187 = equal_556_s2_q & (equal_2273 & (cfg_prove_i & moments_out_of_step_q));
  // hls/stages/registration.hpp:258
  logic not_4194;
  assign not_4194 = ~quarter[1];
  logic [3:0] select_4195;
  assign select_4195 = quarter[0] ? {quarter[1], 1'b0, not_4194, 1'b0} : {1'b0, quarter[1], 1'b0, not_4194};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1596;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1639;
  logic [31:0] registration_sums_rdata_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_rdata_q <= registration_sums_mem[registration_sums_raddr];
  end

  // Memory patches_choices, 64 x 22, DISTANCE 12, hls/stages/patches.hpp:762; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [21:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 22'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_1673;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1675));
  logic [21:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1397; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1956;
  logic regions_re;
  assign regions_re = s2_en & (equal_556_s2_q ? (x_s2_q[6] & not_1957) : and_1964);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1408; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_2014;
  logic map_re;
  assign map_re = s2_en & select_2026;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_502_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_507_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_526, and_522, sum_518, sum_514};
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
  assign census_memory_waddr = column_s2_q;
  logic census_memory_we;
  assign census_memory_we = s2_en & and_532_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_550, whole_2, select_542, select_538};
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
  assign moments_memory_waddr = select_555_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_573_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {and_628_s2_q, and_626_s2_q, and_621_s2_q, and_619};
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
  assign best_left_we = s2_en & and_1543_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1542, select_1539, select_1536, select_1534, select_1516, select_1513, select_1505, select_1504, select_1499};
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
  assign best_right_we = s2_en & and_1543_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1553, select_1552, select_1549, select_1548};
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
  assign shown_right_waddr = select_1560_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1571;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1568, not_559_s2_q};
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
  assign left_turns_we = s2_en & and_1582;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {and_1579, and_1576};
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
  assign right_turns_we = s2_en & and_1582;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {and_1588, and_1585};
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
  assign patches_right_codes_waddr = {sum_1872, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1906_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1892_s2_q, less_1891_s2_q, less_1882_s2_q, less_1881_s2_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1910, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1920_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1892_s2_q, less_1891_s2_q, less_1882_s2_q, less_1881_s2_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_1556_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1991, textured};
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
      moments_out_of_step_q <= 1'b0;
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
      averager_running_of_skin_q <= select_2157;
      averager_mask_q <= select_2159;
      averager_of_skin_q <= select_2161;
      census_filled_q <= and_532_s2_q ? {select_664[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= select_2265;
      moments_turned_1_q <= select_2272;
      moments_before_0_q <= equal_556_s2_q ? select_2276 : moments_before_0_q;
      moments_before_1_q <= equal_556_s2_q ? select_2279 : moments_before_1_q;
      moments_has_before_q <= equal_556_s2_q ? select_2282 : moments_has_before_q;
      moments_out_of_step_q <= equal_556_s2_q ? select_2313 : moments_out_of_step_q;
      rows_passed_above_q <= and_532_s2_q ? select_663 : rows_passed_above_q;
      chosen_score_q <= less_2538 ? select_1493 : select_2537;
      chosen_near_q <= (select_2540 < select_1528) ? select_1528 : select_2540;
      chosen_place_q <= less_2538 ? {select_1501, not_1500} : 3'h2;
      before_0_q <= select_2537;
      before_1_q <= sum_1243;
      before_2_q <= sum_1491;
      shift_allowed_q <= not_2545 & (~less_2546);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_2553 ? 14'h0 : (counts_turned_left_q + {13'h0, and_2672});
      counts_turned_right_q <= and_2553 ? 14'h0 : (counts_turned_right_q + {13'h0, and_2679});
      registration_displacement_over_q <= so_s2_q ? sum_2703[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2705;
      registration_slope_here_q <= select_2707;
      registration_expected_q <= select_2709;
      registration_of_right_q <= equal_556_s2_q ? registration_of_right_q : select_2771;
      registration_was_inside_q <= equal_556_s2_q ? registration_was_inside_q : select_2774;
      registration_fresh_q <= select_2783;
      patches_chance_q <= and_532_s2_q ? select_2940 : patches_chance_q;
      patches_fixed_q <= and_2954;
      patches_choice_valid_q <= and_1756 ? (select_1750[0] & not_2942) : select_1750[0];
      patches_choice_column_q <= select_1750[7:1];
      patches_choice_shift_q <= select_1750[13:8];
      patches_choice_slope_q <= select_1750[21:14];
      patches_band_q <= sample_pair_whole_s2_q ? select_1771 : patches_band_q;
      patches_fetch_q <= select_2969;
      patches_codes_at_q <= select_3070;
      patches_codes_further_q <= equal_1758_s2_q ? patches_codes_further_q : select_3075;
      patches_next_codes_q <= select_3083;
      patches_set_q <= equal_1758_s2_q ? 3'h0 : (equal_1760_s2_q ? 3'h0 : select_3097);
      patches_size_q <= sum_3101;
      patches_left_row_q <= select_3113;
      patches_summed_row_column_q <= equal_1758_s2_q ? patches_summed_row_column_q : select_3458;
      patches_summed_first_q <= select_3461;
      patches_read_row_differing_q <= equal_1758_s2_q ? select_3473 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1758_s2_q ? select_3480 : patches_read_row_column_q;
      patches_read_at_q <= equal_1758_s2_q ? select_3487 : patches_read_at_q;
      patches_read_first_q <= select_3496;
      patches_read_above_q <= select_3519;
      patches_read_below_q <= select_3528;
      patches_read_far_q <= equal_1758_s2_q ? select_3538 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3541;
      patches_peak_best_column_q <= select_3542;
      patches_peak_row_q <= equal_1758_s2_q ? select_3509 : patches_peak_row_q;
      patches_peak_above_q <= equal_1758_s2_q ? select_3544 : patches_peak_above_q;
      patches_peak_below_q <= equal_1758_s2_q ? select_3546 : patches_peak_below_q;
      patches_peak_far_q <= equal_1758_s2_q ? select_3550 : patches_peak_far_q;
      patches_frame_ended_q <= equal_556_s2_q & (equal_2274 & (~equal_2273));
      shown_shown_q <= select_3830;
      shown_nearer_q <= select_3832;
      region_row_q <= and_532_s2_q ? select_3838 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3843;
      region_down_rest_q <= select_3859;
      region_down_back_q <= select_3863;
      region_down_next_q <= select_3865;
      region_fresh_q <= and_532_s2_q ? select_3869 : region_fresh_q;
      segment_starts_q <= select_3880;
      centres_values_0_textured_q <= equal_556_s2_q ? centres_values_0_textured_q : select_4039;
      centres_values_0_of_skin_q <= select_4044;
      centres_values_1_textured_q <= select_4047;
      centres_values_1_of_skin_q <= select_4050;
      map_row_q <= and_532_s2_q ? select_4054 : map_row_q;
      map_width_q <= select_4057;
      write_half_q <= select_4062;
      read_half_q <= and_1938_s2_q ? select_4064 : read_half_q;
      done_q <= and_1938_s2_q ? (not_2015 & and_4068) : and_4068;
      drew_q <= so_s2_q;
      said_q <= equal_556_s2_q & equal_2273;
      rows_passed_q <= and_1938_s2_q ? select_4077 : rows_passed_q;
      columns_passed_q <= and_1938_s2_q ? select_4080 : columns_passed_q;
      line_ended_q <= and_1938_s2_q ? select_4083 : line_ended_q;
      began_q <= and_1938_s2_q ? select_4086 : began_q;
      seen_x_q <= and_1938_s2_q ? select_4089 : seen_x_q;
      seen_y_q <= and_1938_s2_q ? select_4096 : seen_y_q;
      seen_column_q <= and_1938_s2_q ? select_4099 : seen_column_q;
      seen_rows_left_q <= and_1938_s2_q ? select_4107 : seen_rows_left_q;
      at_cell_end_q <= and_1938_s2_q ? select_4114 : at_cell_end_q;
      was_next_row_q <= and_1938_s2_q ? select_4117 : was_next_row_q;
      seen_base_q <= and_1938_s2_q ? select_4120 : seen_base_q;
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
      left_pixel_q <= and_1938_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_510 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_516 : averager_running_1_q;
      averager_total_0_q <= select_2136;
      averager_total_1_q <= select_2138;
      census_columns_values_0_cell_0_left_q <= select_2162;
      census_columns_values_0_cell_0_right_q <= select_2163;
      census_columns_values_0_cell_0_mask_q <= and_532_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2165;
      census_columns_values_0_cell_1_right_q <= select_2166;
      census_columns_values_0_cell_1_mask_q <= select_2167;
      census_columns_values_0_cell_2_left_q <= select_2168;
      census_columns_values_0_cell_2_right_q <= select_2169;
      census_columns_values_0_cell_2_mask_q <= select_2170;
      census_columns_values_0_cell_2_of_skin_q <= select_2171;
      census_columns_values_0_cell_3_left_q <= select_2172;
      census_columns_values_0_cell_3_right_q <= select_2173;
      census_columns_values_0_cell_3_mask_q <= select_2174;
      census_columns_values_0_cell_4_left_q <= select_2175;
      census_columns_values_0_cell_4_right_q <= select_2176;
      census_columns_values_0_cell_4_mask_q <= select_2177;
      census_columns_values_1_cell_0_left_q <= select_2178;
      census_columns_values_1_cell_0_right_q <= select_2179;
      census_columns_values_1_cell_0_mask_q <= select_2180;
      census_columns_values_1_cell_1_left_q <= select_2181;
      census_columns_values_1_cell_1_right_q <= select_2182;
      census_columns_values_1_cell_1_mask_q <= select_2183;
      census_columns_values_1_cell_2_left_q <= select_2184;
      census_columns_values_1_cell_2_right_q <= select_2185;
      census_columns_values_1_cell_2_mask_q <= select_2186;
      census_columns_values_1_cell_2_of_skin_q <= select_2187;
      census_columns_values_1_cell_3_left_q <= select_2188;
      census_columns_values_1_cell_3_right_q <= select_2189;
      census_columns_values_1_cell_3_mask_q <= select_2190;
      census_columns_values_1_cell_4_left_q <= select_2191;
      census_columns_values_1_cell_4_right_q <= select_2192;
      census_columns_values_1_cell_4_mask_q <= select_2193;
      census_columns_values_2_cell_0_left_q <= select_2194;
      census_columns_values_2_cell_0_right_q <= select_2195;
      census_columns_values_2_cell_0_mask_q <= select_2196;
      census_columns_values_2_cell_1_left_q <= select_2197;
      census_columns_values_2_cell_1_right_q <= select_2198;
      census_columns_values_2_cell_1_mask_q <= select_2199;
      census_columns_values_2_cell_2_left_q <= select_2200;
      census_columns_values_2_cell_2_right_q <= select_2201;
      census_columns_values_2_cell_2_mask_q <= select_2202;
      census_columns_values_2_cell_3_left_q <= select_2203;
      census_columns_values_2_cell_3_right_q <= select_2204;
      census_columns_values_2_cell_3_mask_q <= select_2205;
      census_columns_values_2_cell_4_left_q <= select_2206;
      census_columns_values_2_cell_4_right_q <= select_2207;
      census_columns_values_2_cell_4_mask_q <= select_2208;
      census_columns_values_3_cell_0_mask_q <= select_2209;
      census_columns_values_3_cell_1_left_q <= select_2210;
      census_columns_values_3_cell_1_right_q <= select_2211;
      census_columns_values_3_cell_1_mask_q <= select_2212;
      census_columns_values_3_cell_2_mask_q <= select_2213;
      census_columns_values_3_cell_3_left_q <= select_2214;
      census_columns_values_3_cell_3_right_q <= select_2215;
      census_columns_values_3_cell_3_mask_q <= select_2216;
      census_columns_values_3_cell_4_mask_q <= select_2217;
      sharpness_last_mean_0_q <= and_532_s2_q ? select_538 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_532_s2_q ? select_542 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_2_s2_q;
      middle_sum_columns_values_1_q <= select_2528;
      middle_sum_columns_values_2_q <= select_2529;
      middle_sum_columns_values_3_q <= select_2530;
      middle_sum_columns_values_4_q <= select_2531;
      middle_sum_columns_values_5_q <= select_2532;
      middle_sum_columns_values_6_q <= select_2533;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_993;
      sums_0_sum_sums_values_0_q <= sum_1243;
      sums_0_sum_sums_values_1_q <= equal_1241 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1491;
      sums_1_sum_sums_values_1_q <= equal_1241 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [2:0] select_496_s3_q;
  logic [5:0] select_498_s3_q;
  logic [5:0] column_s3_q;
  logic and_530_s3_q;
  logic and_532_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_535_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_552_s3_q;
  logic equal_556_s3_q;
  logic not_557_s3_q;
  logic less_634_s3_q;
  logic less_635_s3_q;
  logic less_636_s3_q;
  logic less_637_s3_q;
  logic less_638_s3_q;
  logic less_639_s3_q;
  logic less_640_s3_q;
  logic less_641_s3_q;
  logic less_642_s3_q;
  logic less_643_s3_q;
  logic less_644_s3_q;
  logic less_645_s3_q;
  logic less_646_s3_q;
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
  logic and_665_s3_q;
  logic and_690_s3_q;
  logic and_691_s3_q;
  logic [11:0] sum_706_s3_q;
  logic [9:0] sum_709_s3_q;
  logic and_717_s3_q;
  logic and_721_s3_q;
  logic less_722_s3_q;
  logic less_726_s3_q;
  logic less_728_s3_q;
  logic equal_1589_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1595_s3_q;
  logic equal_1597_s3_q;
  logic equal_1599_s3_q;
  logic equal_1601_s3_q;
  logic equal_1603_s3_q;
  logic equal_1605_s3_q;
  logic equal_1607_s3_q;
  logic equal_1609_s3_q;
  logic equal_1611_s3_q;
  logic less_1620_s3_q;
  logic or_1624_s3_q;
  logic equal_1644_s3_q;
  logic and_1654_s3_q;
  logic and_1657_s3_q;
  logic select_1674_s3_q;
  logic equal_1675_s3_q;
  logic and_1683_s3_q;
  logic equal_1685_s3_q;
  logic select_1750_s3_q;
  logic and_1757_s3_q;
  logic equal_1758_s3_q;
  logic equal_1760_s3_q;
  logic and_1773_s3_q;
  logic [4:0] select_1788_s3_q;
  logic select_1794_s3_q;
  logic [3:0] select_1835_s3_q;
  logic less_1921_s3_q;
  logic equal_1922_s3_q;
  logic not_1923_s3_q;
  logic equal_1924_s3_q;
  logic and_1938_s3_q;
  logic select_1940_s3_q;
  logic and_1943_s3_q;
  logic or_1949_s3_q;
  logic or_1952_s3_q;
  logic or_1955_s3_q;
  logic not_1957_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_1984_s3_q;
  logic and_1989_s3_q;
  logic and_2021_s3_q;
  logic less_2022_s3_q;
  logic [11:0] sum_2030_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2048_s3_q;
  logic or_2051_s3_q;
  logic or_2054_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2104_s3_q;
  logic [11:0] sum_2233_s3_q;
  logic [9:0] sum_2236_s3_q;
  logic equal_2244_s3_q;
  logic equal_2273_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2553_s3_q;
  logic and_2559_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2621_s3_q;
  logic and_2655_s3_q;
  logic and_2713_s3_q;
  logic and_2714_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2750_s3_q;
  logic and_2764_s3_q;
  logic equal_2807_s3_q;
  logic parity_3185_s3_q;
  logic parity_3314_s3_q;
  logic parity_3376_s3_q;
  logic xor_3404_s3_q;
  logic parity_3416_s3_q;
  logic or_3420_s3_q;
  logic equal_3421_s3_q;
  logic [4:0] select_3540_s3_q;
  logic equal_3552_s3_q;
  logic less_3554_s3_q;
  logic less_3555_s3_q;
  logic or_3560_s3_q;
  logic [7:0] select_3605_s3_q;
  logic and_4123_s3_q;
  logic and_4187_s3_q;
  logic equal_4197_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
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
      select_496_s3_q <= select_496_s2_q;
      select_498_s3_q <= select_498_s2_q;
      column_s3_q <= column_s2_q;
      and_530_s3_q <= and_530_s2_q;
      and_532_s3_q <= and_532_s2_q;
      grey_s3_q <= grey;
      equal_535_s3_q <= equal_535;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_552_s3_q <= equal_552_s2_q;
      equal_556_s3_q <= equal_556_s2_q;
      not_557_s3_q <= not_557_s2_q;
      less_634_s3_q <= less_634;
      less_635_s3_q <= less_635;
      less_636_s3_q <= less_636;
      less_637_s3_q <= less_637;
      less_638_s3_q <= less_638;
      less_639_s3_q <= less_639;
      less_640_s3_q <= less_640;
      less_641_s3_q <= less_641;
      less_642_s3_q <= less_642;
      less_643_s3_q <= less_643;
      less_644_s3_q <= less_644;
      less_645_s3_q <= less_645;
      less_646_s3_q <= less_646;
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
      and_665_s3_q <= and_665;
      and_690_s3_q <= whole_22 & and_665;
      and_691_s3_q <= census_columns_values_1_cell_2_mask_q & and_665;
      sum_706_s3_q <= {1'b0, sum_702} + {2'h0, sum_705};
      sum_709_s3_q <= {9'h0, difference_707[9]} + {1'b0, xor_708};
      and_717_s3_q <= and_717;
      and_721_s3_q <= and_721;
      less_722_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_726_s3_q <= {{5{sum_725[6]}}, sum_725, half_grey_levels_2[3:0]} < 16'hffe1;
      less_728_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_1589_s3_q <= equal_1589;
      all_s3_q <= all;
      sum_1595_s3_q <= sum_1595;
      equal_1597_s3_q <= equal_1597;
      equal_1599_s3_q <= equal_1599;
      equal_1601_s3_q <= equal_1601;
      equal_1603_s3_q <= equal_1603;
      equal_1605_s3_q <= equal_1605;
      equal_1607_s3_q <= equal_1607;
      equal_1609_s3_q <= equal_1609;
      equal_1611_s3_q <= equal_1611;
      less_1620_s3_q <= less_1620;
      or_1624_s3_q <= or_1624;
      equal_1644_s3_q <= (registration_fresh_q & select_1642) == 4'h0;
      and_1654_s3_q <= not_557_s2_q & and_1638;
      and_1657_s3_q <= and_1657_s2_q;
      select_1674_s3_q <= select_1674[1];
      equal_1675_s3_q <= equal_1675;
      and_1683_s3_q <= and_1683;
      equal_1685_s3_q <= equal_1685;
      select_1750_s3_q <= select_1750[0];
      and_1757_s3_q <= and_1757;
      equal_1758_s3_q <= equal_1758_s2_q;
      equal_1760_s3_q <= equal_1760_s2_q;
      and_1773_s3_q <= and_1757 & equal_1772;
      select_1788_s3_q <= select_1788_s2_q;
      select_1794_s3_q <= select_1794_s2_q;
      select_1835_s3_q <= select_1835_s2_q;
      less_1921_s3_q <= less_1921_s2_q;
      equal_1922_s3_q <= equal_1922_s2_q;
      not_1923_s3_q <= not_1923_s2_q;
      equal_1924_s3_q <= equal_1924_s2_q;
      and_1938_s3_q <= and_1938_s2_q;
      select_1940_s3_q <= select_1940_s2_q;
      and_1943_s3_q <= and_1943_s2_q;
      or_1949_s3_q <= or_1949;
      or_1952_s3_q <= or_1952;
      or_1955_s3_q <= or_1955;
      not_1957_s3_q <= not_1957;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_1984_s3_q <= inside_v_s2_q & (and_1982 & and_1567);
      and_1989_s3_q <= not_557_s2_q & and_1964;
      and_2021_s3_q <= and_2021;
      less_2022_s3_q <= less_2022;
      sum_2030_s3_q <= sum_2030;
      textured_2_s3_q <= textured_2;
      or_2048_s3_q <= or_2048;
      or_2051_s3_q <= select_2045[7] | (~({select_2045[6], select_2045[3:2]} == 3'h0));
      or_2054_s3_q <= select_2045[7] | (~(select_2045[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2104_s3_q <= and_2104;
      sum_2233_s3_q <= {1'b0, sum_2229} + {2'h0, sum_2232};
      sum_2236_s3_q <= {9'h0, difference_2234[9]} + {1'b0, xor_2235};
      equal_2244_s3_q <= equal_2244_s2_q;
      equal_2273_s3_q <= equal_2273;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2553_s3_q <= and_2553;
      and_2559_s3_q <= and_2559;
      explained_2_s3_q <= explained_2;
      and_2621_s3_q <= not_557_s2_q & and_2620;
      and_2655_s3_q <= not_557_s2_q & and_2654;
      and_2713_s3_q <= not_557_s2_q & (so_s2_q & (half_ends & equal_2710));
      and_2714_s3_q <= and_2714;
      residual_s3_q <= residual[7:0];
      and_2750_s3_q <= and_2750;
      and_2764_s3_q <= and_2714 & less_2763;
      equal_2807_s3_q <= (registration_fresh_q & select_2805) == 4'h0;
      parity_3185_s3_q <= ^{xor_3181, xor_3144, select_3111[44:36], other[44:36]};
      parity_3314_s3_q <= parity_3314;
      parity_3376_s3_q <= parity_3376;
      xor_3404_s3_q <= parity_3391 ^ parity_3403;
      parity_3416_s3_q <= ^{or_3413, or_3409, and_3405};
      or_3420_s3_q <= (or_3409 & or_3413) | (and_3405 & (or_3409 | or_3413));
      equal_3421_s3_q <= equal_3421_s2_q;
      select_3540_s3_q <= select_3540[14:10];
      equal_3552_s3_q <= select_3509[3:0] == 4'h0;
      less_3554_s3_q <= {difference_3553, 3'h0} < {3'h0, sum_3101};
      less_3555_s3_q <= select_3550 < select_3540[9:0];
      or_3560_s3_q <= (sum_3101 < 10'h39) | ({1'b0, sum_3101[9:1]} < select_3540[9:0]);
      select_3605_s3_q <= select_3605;
      and_4123_s3_q <= and_2104 & (sum_2030 == sum_2014);
      and_4187_s3_q <= and_4187;
      equal_4197_s3_q <= (registration_fresh_q & select_4195) == 4'h0;
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
  logic [7:0] patches_on_skin_most_q;
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
  assign texture = sum_706_s3_q + {2'h0, sum_709_s3_q};
  // hls/stages/census.hpp:283
  logic [12:0] sum_711;
  assign sum_711 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_713;
  assign sum_713 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_711});
  // hls/stages/census.hpp:305
  logic less_714;
  assign less_714 = 9'h4 < sum_713[13:5];
  logic and_715;
  assign and_715 = and_665_s3_q & less_714;
  // hls/stages/moments.hpp:30
  logic and_727;
  assign and_727 = (and_690_s3_q & and_717_s3_q) & less_726_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_1646;
  assign equal_1646 = sum_1595_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1595_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1648;
  assign select_1648 = equal_1646 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1649;
  assign sum_1649 = (equal_1644_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1648[13]}}, select_1648};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1595_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1652;
  assign select_1652 = equal_1646 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1653;
  assign sum_1653 = (equal_1644_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1652[6]}}, select_1652};
  // hls/stages/patches.hpp:352
  logic [21:0] select_1774;
  assign select_1774 = and_1773_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1750_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1776;
  assign select_1776 = equal_1675_s3_q ? patches_place_0_valid_q : (select_1674_s3_q ? patches_place_0_valid_q : select_1774[0]);
  // hls/stages/patches.hpp:353
  logic [20:0] select_1777;
  assign select_1777 = select_1674_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1774[21:1];
  // hls/stages/patches.hpp:127
  logic [6:0] select_1778;
  assign select_1778 = equal_1675_s3_q ? patches_place_0_column_q : select_1777[6:0];
  logic [5:0] select_1779;
  assign select_1779 = equal_1675_s3_q ? patches_place_0_shift_q : select_1777[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1780;
  assign sum_1780 = select_1778 + {select_1779[5], select_1779};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1781;
  assign sum_1781 = sum_1780[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1782;
  assign equal_1782 = {sum_1781[5], select_498_s3_q, select_496_s3_q} == {1'b0, sum_1781[4:0], sum_1780[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1784;
  assign or_1784 = and_1657_s3_q | (select_1776 & equal_1782);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1785;
  assign select_1785 = or_1784 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1795;
  assign select_1795 = or_1784 ? {and_1657_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1797;
  assign and_1797 = select_1794_s3_q & (~select_1795[5]);
  // hls/stages/patches.hpp:127
  logic select_1805;
  assign select_1805 = equal_1675_s3_q ? patches_place_1_valid_q : (select_1674_s3_q ? select_1774[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:353
  logic [20:0] select_1806;
  assign select_1806 = select_1674_s3_q ? select_1774[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [6:0] select_1807;
  assign select_1807 = equal_1675_s3_q ? patches_place_1_column_q : select_1806[6:0];
  logic [5:0] select_1808;
  assign select_1808 = equal_1675_s3_q ? patches_place_1_shift_q : select_1806[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1809;
  assign sum_1809 = select_1807 + {select_1808[5], select_1808};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1810;
  assign sum_1810 = sum_1809[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1811;
  assign equal_1811 = {sum_1810[5], select_498_s3_q, select_496_s3_q} == {1'b0, sum_1810[4:0], sum_1809[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1813;
  assign or_1813 = and_1657_s3_q | (select_1805 & equal_1811);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_1814;
  assign select_1814 = or_1813 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1815;
  assign select_1815 = or_1813 ? {and_1657_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1817;
  assign and_1817 = select_1794_s3_q & (~select_1815[5]);
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1824;
  assign sum_1824 = select_1778 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1825;
  assign equal_1825 = {sum_1824[6], select_498_s3_q, select_496_s3_q} == {1'b0, sum_1824[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_1827;
  assign or_1827 = and_1657_s3_q | (select_1776 & equal_1825);
  logic [4:0] select_1828;
  assign select_1828 = or_1827 ? {and_1657_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1829;
  assign sum_1829 = select_1807 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1830;
  assign equal_1830 = {sum_1829[6], select_498_s3_q, select_496_s3_q} == {1'b0, sum_1829[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_1833;
  assign select_1833 = (and_1657_s3_q | (select_1805 & equal_1830)) ? {and_1657_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_5;
  assign column_5 = select_1828[4] ? select_1833[3:0] : select_1828[3:0];
  // hls/stages/agreement.hpp:276
  logic select_1836;
  assign select_1836 = or_1827 ? and_1657_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_1842;
  assign and_1842 = (select_1794_s3_q & (select_1788_s3_q[3] ^ select_1788_s3_q[4])) & ((~select_1828[4]) | (~select_1833[4]));
  // hls/stages/patches.hpp:184
  logic less_1933;
  assign less_1933 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1934;
  assign not_1934 = ~less_1933;
  logic [1:0] select_1935;
  assign select_1935 = patches_summed_first_s3_q ? 2'h2 : {less_1933, not_1934};
  logic [12:0] select_1936;
  assign select_1936 = select_1935[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1944;
  assign select_1944 = select_1935[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1943_s3_q, 1'b0, select_1940_s3_q, left_pixel_q};
  logic [14:0] select_1945;
  assign select_1945 = select_1935[1] ? {select_1936[12:8], patches_sums_values_0_q[9:8], select_1936[7:0]} : select_1944;
  // hls/stages/agreement.hpp:900
  logic [5:0] select_1970;
  assign select_1970 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_1971;
  assign sum_1971 = {5'h0, textured_s3_q} + select_1970;
  // hls/stages/agreement.hpp:1061
  logic [9:0] sum_1973;
  assign sum_1973 = {4'h0, sum_1971} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_1975;
  assign select_1975 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:901
  logic [5:0] sum_1976;
  assign sum_1976 = {5'h0, explained_s3_q} + select_1975;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_1978;
  assign sum_1978 = {4'h0, sum_1976} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:900
  logic [5:0] select_1985;
  assign select_1985 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:902
  logic [5:0] sum_1986;
  assign sum_1986 = {5'h0, and_1984_s3_q} + select_1985;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_1988;
  assign sum_1988 = {4'h0, sum_1986} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1094
  logic [2:0] select_2039;
  assign select_2039 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2040;
  assign difference_2040 = {1'b0, textured_2_s3_q} - {1'b0, select_2039};
  logic [4:0] t;
  assign t = {difference_2040[3], difference_2040} + (equal_552_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1100
  logic equal_2043;
  assign equal_2043 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1101
  logic not_2055;
  assign not_2055 = ~region_row_s3_q[2];
  logic [2:0] select_2056;
  assign select_2056 = region_row_s3_q[1] ? {1'b0, not_2055, 1'b0} : {region_row_s3_q[2], 1'b0, not_2055};
  logic [5:0] select_2057;
  assign select_2057 = region_row_s3_q[0] ? {select_2056[2], 1'b0, select_2056[1], 1'b0, select_2056[0], 1'b0} : {1'b0, select_2056[2], 1'b0, select_2056[1], 1'b0, select_2056[0]};
  logic [11:0] select_2058;
  assign select_2058 = or_2054_s3_q ? {select_2057[5], 1'b0, select_2057[4], 1'b0, select_2057[3], 1'b0, select_2057[2], 1'b0, select_2057[1], 1'b0, select_2057[0], 1'b0} : {1'b0, select_2057[5], 1'b0, select_2057[4], 1'b0, select_2057[3], 1'b0, select_2057[2], 1'b0, select_2057[1], 1'b0, select_2057[0]};
  logic [23:0] select_2059;
  assign select_2059 = or_2051_s3_q ? {select_2058[11], 1'b0, select_2058[10], 1'b0, select_2058[9], 1'b0, select_2058[8], 1'b0, select_2058[7], 1'b0, select_2058[6], 1'b0, select_2058[5], 1'b0, select_2058[4], 1'b0, select_2058[3], 1'b0, select_2058[2], 1'b0, select_2058[1], 1'b0, select_2058[0], 1'b0} : {1'b0, select_2058[11], 1'b0, select_2058[10], 1'b0, select_2058[9], 1'b0, select_2058[8], 1'b0, select_2058[7], 1'b0, select_2058[6], 1'b0, select_2058[5], 1'b0, select_2058[4], 1'b0, select_2058[3], 1'b0, select_2058[2], 1'b0, select_2058[1], 1'b0, select_2058[0]};
  logic [47:0] select_2060;
  assign select_2060 = or_2048_s3_q ? {select_2059[23], 1'b0, select_2059[22], 1'b0, select_2059[21], 1'b0, select_2059[20], 1'b0, select_2059[19], 1'b0, select_2059[18], 1'b0, select_2059[17], 1'b0, select_2059[16], 1'b0, select_2059[15], 1'b0, select_2059[14], 1'b0, select_2059[13], 1'b0, select_2059[12], 1'b0, select_2059[11], 1'b0, select_2059[10], 1'b0, select_2059[9], 1'b0, select_2059[8], 1'b0, select_2059[7], 1'b0, select_2059[6], 1'b0, select_2059[5], 1'b0, select_2059[4], 1'b0, select_2059[3], 1'b0, select_2059[2], 1'b0, select_2059[1], 1'b0, select_2059[0], 1'b0} : {1'b0, select_2059[23], 1'b0, select_2059[22], 1'b0, select_2059[21], 1'b0, select_2059[20], 1'b0, select_2059[19], 1'b0, select_2059[18], 1'b0, select_2059[17], 1'b0, select_2059[16], 1'b0, select_2059[15], 1'b0, select_2059[14], 1'b0, select_2059[13], 1'b0, select_2059[12], 1'b0, select_2059[11], 1'b0, select_2059[10], 1'b0, select_2059[9], 1'b0, select_2059[8], 1'b0, select_2059[7], 1'b0, select_2059[6], 1'b0, select_2059[5], 1'b0, select_2059[4], 1'b0, select_2059[3], 1'b0, select_2059[2], 1'b0, select_2059[1], 1'b0, select_2059[0]};
  // hls/stages/agreement.hpp:1030
  logic and_2064;
  assign and_2064 = good_known_q & (~((good_q & select_2060) == 48'h0));
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_2073;
  assign select_2073 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2074;
  assign difference_2074 = {1'b0, shown_2_s3_q} - {1'b0, select_2073};
  logic [4:0] around;
  assign around = {difference_2074[3], difference_2074} + (equal_552_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_2077;
  assign sum_2077 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2043 ? and_2064 : (~({sum_2077, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2089;
  assign select_2089 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2090;
  assign difference_2090 = {1'b0, near_2_s3_q} - {1'b0, select_2089};
  logic [4:0] n;
  assign n = {difference_2090[3], difference_2090} + (equal_552_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1112
  logic and_2094;
  assign and_2094 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2128;
  assign select_2128 = sample_pair_whole_s3_q ? (and_530_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2130;
  assign select_2130 = sample_pair_whole_s3_q ? (and_530_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2132;
  assign select_2132 = sample_pair_whole_s3_q ? (and_530_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2134;
  assign select_2134 = sample_pair_whole_s3_q ? (and_530_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2139;
  assign sum_2139 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2140;
  assign difference_2140 = {1'b0, sum_2139[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2141;
  assign xor_2141 = {difference_2140[8:0], sum_2139[0]} ^ {10{difference_2140[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2140[9]} + {1'b0, xor_2141};
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_535_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2146;
  assign select_2146 = sample_pair_whole_s3_q ? (and_530_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2147;
  assign sum_2147 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2148;
  assign difference_2148 = {1'b0, sum_2147[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2149;
  assign xor_2149 = {difference_2148[8:0], sum_2147[0]} ^ {10{difference_2148[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2148[9]} + {1'b0, xor_2149};
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_535_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2154;
  assign select_2154 = sample_pair_whole_s3_q ? (and_530_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:274
  logic [11:0] sum_2237;
  assign sum_2237 = sum_2233_s3_q + {2'h0, sum_2236_s3_q};
  // hls/stages/agreement.hpp:520
  logic [11:0] select_2239;
  assign select_2239 = and_532_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2240;
  assign select_2240 = and_532_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2241;
  assign select_2241 = and_532_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2242;
  assign select_2242 = and_532_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:284
  logic [12:0] sum_2245;
  assign sum_2245 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2237};
  logic [13:0] sum_2247;
  assign sum_2247 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2245});
  // hls/stages/census.hpp:311
  logic and_2249;
  assign and_2249 = and_690_s3_q & (9'h4 < sum_2247[13:5]);
  // hls/stages/census.hpp:312
  logic and_2250;
  assign and_2250 = and_690_s3_q & less_714;
  // hls/stages/census.hpp:313
  logic [19:0] sum_2251;
  assign sum_2251 = census_left_misses_q + {{17{and_2250}}, and_2249, 1'b0, and_2249};
  // hls/stages/agreement.hpp:520
  logic [19:0] select_2253;
  assign select_2253 = and_532_s3_q ? (equal_2244_s3_q ? 20'h0 : sum_2251) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2318;
  assign select_2318 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:520
  logic select_2321;
  assign select_2321 = and_532_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:361
  logic and_2324;
  assign and_2324 = whole_2_s3_q & (~(column_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:457
  logic and_2330;
  assign and_2330 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2331;
  assign and_2331 = and_2324 & and_2330;
  // hls/stages/census.hpp:360
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2318[13:0]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2333;
  assign select_2333 = and_2331 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2335;
  assign select_2335 = equal_2244_s3_q ? {11'h0, select_2333} : (sharpness_sums_detail_0_q + {11'h0, select_2333});
  // hls/stages/agreement.hpp:457
  logic and_2342;
  assign and_2342 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2343;
  assign and_2343 = and_2324 & and_2342;
  // hls/stages/census.hpp:360
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2318[27:14]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2345;
  assign select_2345 = and_2343 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2347;
  assign select_2347 = equal_2244_s3_q ? {11'h0, select_2345} : (sharpness_sums_detail_1_q + {11'h0, select_2345});
  logic [8:0] select_2350;
  assign select_2350 = and_2331 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2351;
  assign sum_2351 = (equal_2244_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2350};
  logic [8:0] select_2354;
  assign select_2354 = and_2343 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2355;
  assign sum_2355 = (equal_2244_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2354};
  // hls/stages/agreement.hpp:211
  logic equal_2357;
  assign equal_2357 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:376
  logic less_2358;
  assign less_2358 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:415
  logic less_2359;
  assign less_2359 = x_s3_q[4:0] < 5'h3;
  logic not_2360;
  assign not_2360 = ~x_s3_q[1];
  logic [2:0] select_2361;
  assign select_2361 = x_s3_q[0] ? {1'b0, not_2360, 1'b0} : {x_s3_q[1], 1'b0, not_2360};
  logic [5:0] select_2362;
  assign select_2362 = slot_s3_q[2] ? {select_2361[2], 1'b0, select_2361[1], 1'b0, select_2361[0], 1'b0} : {1'b0, select_2361[2], 1'b0, select_2361[1], 1'b0, select_2361[0]};
  logic [11:0] select_2363;
  assign select_2363 = slot_s3_q[1] ? {select_2362[5], 1'b0, select_2362[4], 1'b0, select_2362[3], 1'b0, select_2362[2], 1'b0, select_2362[1], 1'b0, select_2362[0], 1'b0} : {1'b0, select_2362[5], 1'b0, select_2362[4], 1'b0, select_2362[3], 1'b0, select_2362[2], 1'b0, select_2362[1], 1'b0, select_2362[0]};
  logic [23:0] select_2364;
  assign select_2364 = slot_s3_q[0] ? {select_2363[11], 1'b0, select_2363[10], 1'b0, select_2363[9], 1'b0, select_2363[8], 1'b0, select_2363[7], 1'b0, select_2363[6], 1'b0, select_2363[5], 1'b0, select_2363[4], 1'b0, select_2363[3], 1'b0, select_2363[2], 1'b0, select_2363[1], 1'b0, select_2363[0], 1'b0} : {1'b0, select_2363[11], 1'b0, select_2363[10], 1'b0, select_2363[9], 1'b0, select_2363[8], 1'b0, select_2363[7], 1'b0, select_2363[6], 1'b0, select_2363[5], 1'b0, select_2363[4], 1'b0, select_2363[3], 1'b0, select_2363[2], 1'b0, select_2363[1], 1'b0, select_2363[0]};
  // hls/stages/census.hpp:378
  logic and_2368;
  assign and_2368 = less_2359 & (~((sharpness_sums_contrast_1_q & select_2364) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2370;
  assign select_2370 = (less_2358 & and_2368) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2370};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2373;
  assign select_2373 = equal_2357 ? (less_2358 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:378
  logic and_2378;
  assign and_2378 = less_2359 & (~((sharpness_sums_contrast_0_q & select_2364) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2380;
  assign select_2380 = (less_2358 & and_2378) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2380};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2383;
  assign select_2383 = equal_2357 ? (less_2358 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2385;
  assign select_2385 = equal_2357 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2387;
  assign select_2387 = equal_2357 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2389;
  assign select_2389 = equal_2357 ? {sharpness_comparing_contrast_0_q[0], and_2378} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2391;
  assign select_2391 = equal_2357 ? {sharpness_comparing_contrast_1_q[0], and_2368} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2396;
  assign select_2396 = drew_q ? (equal_2357 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2400;
  assign select_2400 = drew_q ? (equal_2357 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:375
  logic equal_2401;
  assign equal_2401 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:391
  logic xor_2402;
  assign xor_2402 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2405;
  assign select_2405 = (equal_2401 | xor_2402) ? (five_times[0] & xor_2402) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2407;
  assign select_2407 = drew_q ? (equal_2357 ? select_2405 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:391
  logic xor_2408;
  assign xor_2408 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2411;
  assign select_2411 = (equal_2401 | xor_2408) ? (five_times_2[0] & xor_2408) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2413;
  assign select_2413 = drew_q ? (equal_2357 ? select_2411 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:392
  logic xor_2414;
  assign xor_2414 = sharpness_comparing_contrast_0_q[1] ^ and_2368;
  logic select_2417;
  assign select_2417 = (equal_2401 | xor_2414) ? (and_2368 & xor_2414) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2419;
  assign select_2419 = drew_q ? (equal_2357 ? select_2417 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:392
  logic xor_2420;
  assign xor_2420 = sharpness_comparing_contrast_1_q[1] ^ and_2378;
  logic select_2423;
  assign select_2423 = (equal_2401 | xor_2420) ? (and_2378 & xor_2420) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2425;
  assign select_2425 = drew_q ? (equal_2357 ? select_2423 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2561;
  assign select_2561 = and_2553_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2559_s3_q});
  // hls/stages/agreement.hpp:788
  logic and_2564;
  assign and_2564 = not_557_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2569;
  assign and_2569 = not_557_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2574;
  assign and_2574 = not_557_s3_q & (drew_q & (ends_cell_s3_q & and_1984_s3_q));
  // hls/stages/agreement.hpp:1105
  logic not_2578;
  assign not_2578 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2587;
  assign select_2587 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2588;
  assign difference_2588 = {1'b0, explained_2_s3_q} - {1'b0, select_2587};
  logic [4:0] e;
  assign e = {difference_2588[3], difference_2588} + (equal_552_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1102
  logic [5:0] sum_2591;
  assign sum_2591 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1106
  logic not_2595;
  assign not_2595 = ~(equal_2043 ? and_2064 : (~({sum_2591, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:788
  logic and_2598;
  assign and_2598 = ends_cell_s3_q & (not_2578 & (centres_values_1_textured_s3_q & not_2595));
  logic and_2600;
  assign and_2600 = not_557_s3_q & (drew_q & and_2598);
  // hls/stages/agreement.hpp:1132
  logic less_2603;
  assign less_2603 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2604;
  assign select_2604 = less_2603 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2607;
  assign select_2607 = less_2603 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1133
  logic [10:0] sum_2608;
  assign sum_2608 = {1'b0, select_2607} + {3'h0, select_2607[9:2]};
  logic and_2610;
  assign and_2610 = (~(select_2604[9:4] == 6'h0)) & ({sum_2608, select_2607[1:0]} < {3'h0, select_2604});
  // hls/stages/agreement.hpp:1142
  logic [9:0] select_2613;
  assign select_2613 = x_s3_q[6] ? (equal_1589_s3_q ? 10'h0 : (and_2610 ? select_2604 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:788
  logic [9:0] select_2614;
  assign select_2614 = equal_556_s3_q ? select_2613 : 10'h0;
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2616;
  assign select_2616 = and_2553_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2614});
  logic [13:0] select_2623;
  assign select_2623 = and_2553_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2621_s3_q});
  // hls/stages/agreement.hpp:1110
  logic and_2625;
  assign and_2625 = not_2578 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:788
  logic and_2628;
  assign and_2628 = not_557_s3_q & (drew_q & (ends_cell_s3_q & and_2625));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2630;
  assign select_2630 = and_2553_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2628});
  // hls/stages/agreement.hpp:1110
  logic and_2632;
  assign and_2632 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2595);
  // hls/stages/agreement.hpp:788
  logic and_2636;
  assign and_2636 = not_557_s3_q & (drew_q & (ends_cell_s3_q & (not_2578 & and_2632)));
  // hls/stages/agreement.hpp:926
  logic [13:0] select_2638;
  assign select_2638 = and_2553_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2636});
  logic [13:0] select_2657;
  assign select_2657 = and_2553_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2655_s3_q});
  // hls/stages/agreement.hpp:788
  logic [7:0] select_2732;
  assign select_2732 = drew_q ? (equal_1685_s3_q ? (and_2714_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2733;
  assign select_2733 = equal_556_s3_q ? 8'h0 : select_2732;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2735;
  assign select_2735 = and_2713_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2733[7]}}, select_2733});
  // hls/stages/agreement.hpp:788
  logic and_2738;
  assign and_2738 = not_557_s3_q & (drew_q & (and_2714_s3_q & equal_1685_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2740;
  assign select_2740 = and_2713_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2738});
  // hls/stages/registration.hpp:107
  logic and_2742;
  assign and_2742 = and_2714_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2744;
  assign select_2744 = drew_q ? (equal_1685_s3_q ? {and_2742, and_2714_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2745;
  assign select_2745 = equal_556_s3_q ? 2'h0 : select_2744;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2746;
  assign sum_2746 = registration_half_votes_down_q + {{5{select_2745[1]}}, select_2745};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2752;
  assign select_2752 = drew_q ? (equal_1685_s3_q ? {and_2750_s3_q, and_2714_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2753;
  assign select_2753 = equal_556_s3_q ? 2'h0 : select_2752;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2754;
  assign sum_2754 = registration_half_votes_up_q + {{5{select_2753[1]}}, select_2753};
  // hls/stages/registration.hpp:107
  logic and_2757;
  assign and_2757 = and_2714_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2759;
  assign select_2759 = drew_q ? (equal_1685_s3_q ? {and_2757, and_2714_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2760;
  assign select_2760 = equal_556_s3_q ? 2'h0 : select_2759;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2761;
  assign sum_2761 = registration_half_half_votes_down_q + {{5{select_2760[1]}}, select_2760};
  // hls/stages/agreement.hpp:788
  logic [1:0] select_2766;
  assign select_2766 = drew_q ? (equal_1685_s3_q ? {and_2764_s3_q, and_2714_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2767;
  assign select_2767 = equal_556_s3_q ? 2'h0 : select_2766;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2768;
  assign sum_2768 = registration_half_half_votes_up_q + {{5{select_2767[1]}}, select_2767};
  // hls/stages/agreement.hpp:788
  logic and_2802;
  assign and_2802 = equal_556_s3_q & (x_s3_q[6] & (not_1957_s3_q & less_1620_s3_q));
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2809;
  assign select_2809 = or_1624_s3_q ? 12'h0 : (equal_2807_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2812;
  assign select_2812 = x_s3_q[6] ? (equal_1589_s3_q ? 12'h0 : (less_1620_s3_q ? select_2809 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2813;
  assign select_2813 = equal_556_s3_q ? select_2812 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2814;
  assign and_2814 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2817;
  assign and_2817 = not_1957_s3_q & (less_1620_s3_q & ({and_2814, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:788
  logic and_2819;
  assign and_2819 = equal_556_s3_q & (x_s3_q[6] & and_2817);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2821;
  assign sum_2821 = {{2{select_2813[11]}}, select_2813} + (and_2819 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1130
  logic [11:0] select_2824;
  assign select_2824 = or_1624_s3_q ? 12'h0 : (equal_2807_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1142
  logic [11:0] select_2827;
  assign select_2827 = x_s3_q[6] ? (equal_1589_s3_q ? 12'h0 : (less_1620_s3_q ? select_2824 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:788
  logic [11:0] select_2828;
  assign select_2828 = equal_556_s3_q ? select_2827 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2830;
  assign sum_2830 = {{2{select_2828[11]}}, select_2828} + (and_2819 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2832;
  assign not_2832 = ~all_s3_q;
  // hls/stages/agreement.hpp:1142
  logic and_2835;
  assign and_2835 = not_1957_s3_q & (less_1620_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2832, 1'b0}));
  // hls/stages/agreement.hpp:788
  logic and_2841;
  assign and_2841 = equal_556_s3_q & (x_s3_q[6] & (not_1957_s3_q & (less_1620_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2842;
  assign not_2842 = ~and_2841;
  logic less_2843;
  assign less_2843 = $signed({9'h1, {2{not_2842}}, and_2841}) < $signed(registration_up_q[13:2]);
  logic select_2844;
  assign select_2844 = (equal_556_s3_q & (x_s3_q[6] & and_2835)) ? less_2843 : registration_enough_q;
  // hls/stages/agreement.hpp:1142
  logic and_2848;
  assign and_2848 = x_s3_q[6] & (not_1957_s3_q & (less_1620_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:788
  logic and_2849;
  assign and_2849 = equal_556_s3_q & and_2848;
  // hls/stages/registration.hpp:242
  logic less_2850;
  assign less_2850 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2852;
  assign less_2852 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2854;
  assign equal_2854 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:788
  logic and_2858;
  assign and_2858 = equal_556_s3_q & (x_s3_q[6] & (not_1957_s3_q & (less_1620_s3_q & equal_2854)));
  // hls/stages/agreement.hpp:1142
  logic and_2865;
  assign and_2865 = x_s3_q[6] & (not_1957_s3_q & (less_1620_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2868;
  assign equal_2868 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1142
  logic and_2871;
  assign and_2871 = not_1957_s3_q & (less_1620_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2868));
  // hls/stages/registration.hpp:244
  logic and_2875;
  assign and_2875 = (equal_556_s3_q & (x_s3_q[6] & and_2871)) & (less_2852 | less_2850);
  // hls/stages/agreement.hpp:1142
  logic and_2880;
  assign and_2880 = not_1957_s3_q & (less_1620_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2868)));
  // hls/stages/registration.hpp:244
  logic and_2883;
  assign and_2883 = registration_votes_up_q & registration_other_down_q;
  logic select_2885;
  assign select_2885 = registration_votes_down_q ? (registration_other_up_q | and_2883) : and_2883;
  // hls/stages/registration.hpp:138
  logic and_2887;
  assign and_2887 = (equal_556_s3_q & (x_s3_q[6] & and_2880)) & (registration_other_enough_q & select_2885);
  // hls/stages/registration.hpp:245
  logic or_2890;
  assign or_2890 = registration_moved_q | (registration_enough_q & (and_2875 | and_2887));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_2974;
  assign select_2974 = sample_pair_whole_s3_q ? (equal_1675_s3_q ? patches_place_0_slope_q : select_1777[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_2979;
  assign select_2979 = sample_pair_whole_s3_q ? (equal_1675_s3_q ? patches_place_1_slope_q : select_1806[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_2981;
  assign select_2981 = equal_1675_s3_q ? patches_valid_0_q : (select_1674_s3_q ? patches_valid_0_q : select_1774[0]);
  // hls/stages/agreement.hpp:276
  logic select_2984;
  assign select_2984 = sample_pair_whole_s3_q ? (and_1797 ? (sample_present_s3_q & select_2981) : select_2981) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_2986;
  assign select_2986 = equal_1675_s3_q ? patches_valid_1_q : (select_1674_s3_q ? select_1774[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_2989;
  assign select_2989 = sample_pair_whole_s3_q ? (and_1817 ? (sample_present_s3_q & select_2986) : select_2986) : patches_valid_1_q;
  logic [5:0] select_2992;
  assign select_2992 = sample_pair_whole_s3_q ? (select_1795[5] ? {1'b1, select_1795[4:0]} : (select_1795 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2995;
  assign select_2995 = sample_pair_whole_s3_q ? (select_1815[5] ? {1'b1, select_1815[4:0]} : (select_1815 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_2998;
  assign select_2998 = sample_pair_whole_s3_q ? (select_1828[4] ? {1'b1, select_1828[3:0]} : (select_1828 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3001;
  assign select_3001 = sample_pair_whole_s3_q ? (select_1833[4] ? {1'b1, select_1833[3:0]} : (select_1833 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:520
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3420_s3_q, parity_3416_s3_q, xor_3404_s3_q, parity_3376_s3_q, parity_3314_s3_q, parity_3185_s3_q} + (equal_3421_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3425;
  assign select_3425 = equal_1758_s3_q ? patches_sums_values_0_q : (equal_1760_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3426;
  assign select_3426 = equal_1760_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3428;
  assign select_3428 = equal_1760_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3430;
  assign select_3430 = equal_1760_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3432;
  assign select_3432 = equal_1760_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3434;
  assign select_3434 = equal_1760_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3436;
  assign select_3436 = equal_1760_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3438;
  assign select_3438 = equal_1760_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3440;
  assign select_3440 = equal_1760_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3442;
  assign select_3442 = equal_1760_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3444;
  assign select_3444 = equal_1760_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3446;
  assign select_3446 = equal_1760_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3448;
  assign select_3448 = equal_1760_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3450;
  assign select_3450 = equal_1760_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3452;
  assign select_3452 = equal_1760_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3454;
  assign select_3454 = equal_1760_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3456;
  assign select_3456 = equal_1760_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:594
  logic or_3561;
  assign or_3561 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_3560_s3_q;
  logic or_3564;
  assign or_3564 = equal_3552_s3_q | (less_3554_s3_q | (less_3555_s3_q | or_3561));
  // hls/stages/patches.hpp:574
  logic not_3565;
  assign not_3565 = ~or_3564;
  // hls/stages/patches.hpp:555
  logic and_3566;
  assign and_3566 = equal_1924_s3_q & not_3565;
  // hls/stages/patches.hpp:184
  logic and_3569;
  assign and_3569 = equal_1758_s3_q & (less_1921_s3_q ? (not_1923_s3_q & and_3566) : and_3566);
  // hls/stages/patches.hpp:652
  logic not_3570;
  assign not_3570 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:555
  logic and_3572;
  assign and_3572 = equal_1924_s3_q & (patches_second_s3_q & not_3565);
  // hls/stages/patches.hpp:184
  logic and_3575;
  assign and_3575 = equal_1758_s3_q & (less_1921_s3_q ? (not_1923_s3_q & and_3572) : and_3572);
  // hls/stages/patches.hpp:652
  logic not_3576;
  assign not_3576 = ~and_3575;
  // hls/stages/patches.hpp:188
  logic and_3578;
  assign and_3578 = and_3569 & (not_3570 & not_3576);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3580;
  assign sum_3580 = {7'h0, and_3578} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:592
  logic [7:0] select_3606;
  assign select_3606 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3607;
  assign select_3607 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3608;
  assign sum_3608 = {2'h0, select_3540_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_3609;
  assign sum_3609 = {select_3607[5], select_3607} + {{3{sum_3608[3]}}, sum_3608};
  // hls/stages/patches.hpp:592
  logic [17:0] product_3610;
  assign product_3610 = $signed({{10{select_3606[7]}}, select_3606}) * $signed({{8{sum_3609[6]}}, sum_3609, select_3540_s3_q[2:0]});
  // hls/stages/patches.hpp:593
  logic [13:0] difference_3611;
  assign difference_3611 = {{6{select_3605_s3_q[7]}}, select_3605_s3_q} - {product_3610[17], product_3610[17:5]};
  // hls/stages/patches.hpp:599
  logic less_3612;
  assign less_3612 = $signed({{7{difference_3582[6]}}, difference_3582}) < $signed(difference_3611);
  // hls/stages/patches.hpp:555
  logic and_3615;
  assign and_3615 = equal_1924_s3_q & (not_3565 & (~less_3612));
  // hls/stages/patches.hpp:184
  logic and_3618;
  assign and_3618 = equal_1758_s3_q & (less_1921_s3_q ? (not_1923_s3_q & and_3615) : and_3615);
  // hls/stages/patches.hpp:655
  logic and_3619;
  assign and_3619 = and_3618 & and_3578;
  logic [7:0] sum_3620;
  assign sum_3620 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3619};
  // hls/stages/patches.hpp:555
  logic and_3624;
  assign and_3624 = not_3565 & (~($signed(difference_3611) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3625;
  assign and_3625 = equal_1924_s3_q & and_3624;
  // hls/stages/patches.hpp:184
  logic and_3628;
  assign and_3628 = equal_1758_s3_q & (less_1921_s3_q ? (not_1923_s3_q & and_3625) : and_3625);
  // hls/stages/patches.hpp:656
  logic and_3629;
  assign and_3629 = and_3628 & and_3578;
  logic [7:0] sum_3630;
  assign sum_3630 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3629};
  // hls/stages/patches.hpp:188
  logic and_3632;
  assign and_3632 = and_3569 & (and_3575 & not_3570);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3634;
  assign sum_3634 = {7'h0, and_3632} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:655
  logic and_3636;
  assign and_3636 = and_3618 & and_3632;
  logic [7:0] sum_3637;
  assign sum_3637 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3636};
  // hls/stages/patches.hpp:656
  logic and_3639;
  assign and_3639 = and_3628 & and_3632;
  logic [7:0] sum_3640;
  assign sum_3640 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3639};
  // hls/stages/patches.hpp:188
  logic and_3642;
  assign and_3642 = and_3569 & (patches_lower_s3_q & not_3576);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3644;
  assign sum_3644 = {7'h0, and_3642} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:655
  logic and_3646;
  assign and_3646 = and_3618 & and_3642;
  logic [7:0] sum_3647;
  assign sum_3647 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3646};
  // hls/stages/patches.hpp:656
  logic and_3649;
  assign and_3649 = and_3628 & and_3642;
  logic [7:0] sum_3650;
  assign sum_3650 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3649};
  // hls/stages/patches.hpp:188
  logic and_3652;
  assign and_3652 = and_3569 & (patches_lower_s3_q & and_3575);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3654;
  assign sum_3654 = {7'h0, and_3652} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:655
  logic and_3656;
  assign and_3656 = and_3618 & and_3652;
  logic [7:0] sum_3657;
  assign sum_3657 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3656};
  // hls/stages/patches.hpp:656
  logic and_3659;
  assign and_3659 = and_3628 & and_3652;
  logic [7:0] sum_3660;
  assign sum_3660 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3659};
  // hls/stages/agreement.hpp:1222
  logic equal_3661;
  assign equal_3661 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1130
  logic less_3662;
  assign less_3662 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:788
  logic and_3666;
  assign and_3666 = equal_556_s3_q & (x_s3_q[6] & (not_1957_s3_q & (equal_3661 & less_3662)));
  // hls/stages/agreement.hpp:1142
  logic and_3671;
  assign and_3671 = x_s3_q[6] & (not_1957_s3_q & (less_3662 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:788
  logic and_3672;
  assign and_3672 = equal_556_s3_q & and_3671;
  // hls/stages/patches.hpp:618
  logic [7:0] or_3674;
  assign or_3674 = (and_3666 ? patches_quarters_0_places_q : 8'h0) | (and_3672 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1142
  logic and_3678;
  assign and_3678 = x_s3_q[6] & (not_1957_s3_q & (less_3662 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:788
  logic and_3679;
  assign and_3679 = equal_556_s3_q & and_3678;
  // hls/stages/agreement.hpp:1142
  logic and_3685;
  assign and_3685 = x_s3_q[6] & (not_1957_s3_q & (less_3662 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:788
  logic and_3686;
  assign and_3686 = equal_556_s3_q & and_3685;
  // hls/stages/patches.hpp:618
  logic [7:0] or_3688;
  assign or_3688 = (or_3674 | (and_3679 ? patches_quarters_2_places_q : 8'h0)) | (and_3686 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_3692;
  assign select_3692 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:788
  logic and_3696;
  assign and_3696 = equal_556_s3_q & (x_s3_q[6] & (not_1957_s3_q & (less_3662 & select_3692)));
  // hls/stages/patches.hpp:619
  logic [7:0] select_3698;
  assign select_3698 = and_3666 ? (and_3696 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3700;
  assign select_3700 = and_3672 ? (and_3696 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3703;
  assign select_3703 = and_3679 ? (and_3696 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3706;
  assign select_3706 = and_3686 ? (and_3696 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:620
  logic [7:0] select_3709;
  assign select_3709 = and_3666 ? (and_3696 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3711;
  assign select_3711 = and_3672 ? (and_3696 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3714;
  assign select_3714 = and_3679 ? (and_3696 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3717;
  assign select_3717 = and_3686 ? (and_3696 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3719;
  assign sum_3719 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1142
  logic and_3723;
  assign and_3723 = x_s3_q[6] & (not_1957_s3_q & (less_3662 & (sum_3719[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3724;
  assign and_3724 = equal_556_s3_q & and_3723;
  // hls/stages/patches.hpp:615
  logic [7:0] select_3727;
  assign select_3727 = and_3724 ? (patches_word_places_q + (and_3672 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3730;
  assign select_3730 = and_3724 ? (patches_word_up_q + (and_3672 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3733;
  assign select_3733 = and_3724 ? (patches_word_down_q + (and_3672 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:601
  logic [5:0] select_3737;
  assign select_3737 = ($signed(difference_3611[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3611[5:0];
  logic [5:0] select_3738;
  assign select_3738 = ($signed(14'h10) < $signed(difference_3611)) ? 6'h10 : select_3737;
  // hls/stages/patches.hpp:555
  logic [5:0] select_3740;
  assign select_3740 = equal_1924_s3_q ? (or_3564 ? 6'h0 : select_3738) : 6'h0;
  logic [5:0] select_3742;
  assign select_3742 = less_1921_s3_q ? (equal_1922_s3_q ? 6'h0 : select_3740) : select_3740;
  // hls/stages/patches.hpp:658
  logic [5:0] select_3744;
  assign select_3744 = and_3569 ? (equal_1758_s3_q ? select_3742 : 6'h0) : 6'h0;
  logic [11:0] sum_3745;
  assign sum_3745 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3744[5]}}, select_3744};
  // hls/stages/agreement.hpp:788
  logic and_3749;
  assign and_3749 = equal_556_s3_q & (x_s3_q[6] & (not_1957_s3_q & (equal_2854 & less_3662)));
  // hls/stages/agreement.hpp:1142
  logic and_3753;
  assign and_3753 = x_s3_q[6] & (not_1957_s3_q & (less_3662 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:788
  logic and_3754;
  assign and_3754 = equal_556_s3_q & and_3753;
  // hls/stages/patches.hpp:642
  logic [7:0] select_3756;
  assign select_3756 = and_3749 ? (and_3754 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:644
  logic or_3760;
  assign or_3760 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:645
  logic or_3763;
  assign or_3763 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic [8:0] sum_3764;
  assign sum_3764 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:641
  logic select_3766;
  assign select_3766 = and_3749 ? (and_3754 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_3771;
  assign and_3771 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:641
  logic [2:0] select_3773;
  assign select_3773 = and_3754 ? {and_3771, patches_found_q[2:1]} : (and_3749 ? {and_3771, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:640
  logic or_3777;
  assign or_3777 = patches_partly_q | (patches_doubted_q & (~and_3754));
  // hls/stages/patches.hpp:641
  logic select_3780;
  assign select_3780 = and_3749 ? (and_3754 ? or_3777 : (and_3749 ? or_3777 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:639
  logic select_3781;
  assign select_3781 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:628
  logic [7:0] select_3785;
  assign select_3785 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:600
  logic [10:0] sum_3787;
  assign sum_3787 = {sum_3609[6], sum_3609, select_3540_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:555
  logic and_3790;
  assign and_3790 = equal_1924_s3_q & (not_3565 & ({{5{sum_3787[10]}}, sum_3787} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_3793;
  assign and_3793 = equal_1758_s3_q & (less_1921_s3_q ? (not_1923_s3_q & and_3790) : and_3790);
  // hls/stages/patches.hpp:188
  logic and_3794;
  assign and_3794 = and_3569 & and_3793;
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3795;
  assign sum_3795 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3794};
  // hls/stages/patches.hpp:649
  logic [12:0] product_3796;
  assign product_3796 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_3756};
  // hls/stages/patches.hpp:188
  logic and_3802;
  assign and_3802 = (~(patches_on_skin_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_q);
  logic select_3807;
  assign select_3807 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:629
  logic or_3811;
  assign or_3811 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:630
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:631
  logic select_3818;
  assign select_3818 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:632
  logic and_3824;
  assign and_3824 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_3825;
  assign sum_3825 = patches_age_q + {9'h0, and_3824};
  logic [9:0] select_3828;
  assign select_3828 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3825)) : sum_3825;
  // hls/stages/agreement.hpp:1187
  logic or_3885;
  assign or_3885 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1216
  logic equal_3887;
  assign equal_3887 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1225
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1226
  logic select_3893;
  assign select_3893 = (equal_3887 & equal_3661) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1135
  logic [10:0] sum_3896;
  assign sum_3896 = {1'b0, select_2607} + {2'h0, select_2607[9:1]};
  logic select_3899;
  assign select_3899 = (select_2604[9:3] == 7'h0) ? ((~or_3885) & (~select_3893)) : (~({sum_3896, select_2607[0]} < {2'h0, select_2604}));
  // hls/stages/agreement.hpp:1142
  logic [47:0] select_3901;
  assign select_3901 = x_s3_q[6] ? (equal_1589_s3_q ? good_q : {select_3899, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:788
  logic select_3905;
  assign select_3905 = equal_556_s3_q ? ((x_s3_q[6] & good_known_q) | equal_2273_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1216
  logic equal_3906;
  assign equal_3906 = x_s3_q[6:3] == 4'ha;
  logic equal_3908;
  assign equal_3908 = x_s3_q[6:3] == 4'hc;
  logic equal_3909;
  assign equal_3909 = x_s3_q[6:3] == 4'hb;
  logic equal_3910;
  assign equal_3910 = x_s3_q[6:3] == 4'h9;
  logic equal_3911;
  assign equal_3911 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3913;
  assign select_3913 = equal_3910 ? counts_skin_unproven_q : (equal_3911 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3915;
  assign select_3915 = equal_3909 ? counts_regions_bad_q : (equal_3906 ? counts_nearer_q : select_3913);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3908 ? counts_on_skin_q : select_3915;
  // hls/stages/agreement.hpp:1221
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1229
  logic select_3918;
  assign select_3918 = (equal_3906 & equal_3661) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1147
  logic not_3919;
  assign not_3919 = ~hidden_for_q[7];
  logic [7:0] select_3921;
  assign select_3921 = select_3918 ? (hidden_for_q + {7'h0, not_3919}) : 8'h0;
  // hls/stages/agreement.hpp:788
  logic [7:0] select_3923;
  assign select_3923 = equal_556_s3_q ? (equal_2273_s3_q ? select_3921 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1230
  logic [13:0] select_3924;
  assign select_3924 = equal_3661 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1125
  logic [7:0] select_3926;
  assign select_3926 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3928;
  assign select_3928 = equal_3911 ? cfg_unproven_skin_limit_i : (equal_3887 ? cfg_unproven_limit_i : select_3926);
  logic [7:0] select_3930;
  assign select_3930 = equal_3906 ? cfg_regions_limit_i : (equal_3910 ? cfg_hidden_limit_i : select_3928);
  logic [7:0] limit;
  assign limit = equal_3908 ? cfg_regions_limit_i : (equal_3909 ? {cfg_on_skin_limit_i, 3'h0} : select_3930);
  // hls/stages/agreement.hpp:1230
  logic not_3933;
  assign not_3933 = ~x_s3_q[2];
  logic [3:0] select_3934;
  assign select_3934 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3933, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3933};
  logic [7:0] select_3935;
  assign select_3935 = x_s3_q[0] ? {select_3934[3], 1'b0, select_3934[2], 1'b0, select_3934[1], 1'b0, select_3934[0], 1'b0} : {1'b0, select_3934[3], 1'b0, select_3934[2], 1'b0, select_3934[1], 1'b0, select_3934[0]};
  // hls/stages/agreement.hpp:1125
  logic [13:0] select_3939;
  assign select_3939 = equal_3910 ? counts_skin_supervised_q : (equal_3911 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3941;
  assign select_3941 = equal_3909 ? counts_skin_textured_q : (equal_3906 ? counts_textured_q : select_3939);
  logic [13:0] of;
  assign of = equal_3908 ? counts_textured_q : select_3941;
  // hls/stages/agreement.hpp:1230
  logic [13:0] select_3943;
  assign select_3943 = ((limit & select_3935) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3924} + {1'b0, select_3943};
  // hls/stages/agreement.hpp:788
  logic select_3948;
  assign select_3948 = equal_556_s3_q ? (equal_3661 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1227
  logic and_3953;
  assign and_3953 = too_much_q & (~(equal_3911 & equal_3661));
  // hls/stages/agreement.hpp:1228
  logic select_3958;
  assign select_3958 = (over[14] & equal_3661) ? (and_3953 | ((equal_3911 | equal_3910) | (x_s3_q[6:3] == 4'hf))) : and_3953;
  // hls/stages/agreement.hpp:1125
  logic and_3963;
  assign and_3963 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1230
  logic select_3964;
  assign select_3964 = (equal_3908 & equal_3661) ? and_3963 : overlooks_q;
  // hls/stages/agreement.hpp:788
  logic [2:0] select_3966;
  assign select_3966 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_3968;
  assign select_3968 = equal_556_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_3966 : box_textured_columns_values_0_q);
  logic [2:0] select_3969;
  assign select_3969 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3971;
  assign select_3971 = equal_556_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_3969 : box_textured_columns_values_1_q);
  logic [2:0] select_3972;
  assign select_3972 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3974;
  assign select_3974 = equal_556_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_3972 : box_textured_columns_values_2_q);
  logic [2:0] select_3975;
  assign select_3975 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3977;
  assign select_3977 = equal_556_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_3975 : box_textured_columns_values_3_q);
  logic [2:0] select_3978;
  assign select_3978 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3980;
  assign select_3980 = equal_556_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_3978 : box_textured_columns_values_4_q);
  logic [4:0] select_3982;
  assign select_3982 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3984;
  assign select_3984 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_3986;
  assign select_3986 = equal_556_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_3984 : box_explained_columns_values_0_q);
  logic [2:0] select_3987;
  assign select_3987 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3989;
  assign select_3989 = equal_556_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_3987 : box_explained_columns_values_1_q);
  logic [2:0] select_3990;
  assign select_3990 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3992;
  assign select_3992 = equal_556_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_3990 : box_explained_columns_values_2_q);
  logic [2:0] select_3993;
  assign select_3993 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3995;
  assign select_3995 = equal_556_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_3993 : box_explained_columns_values_3_q);
  logic [2:0] select_3996;
  assign select_3996 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3998;
  assign select_3998 = equal_556_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_3996 : box_explained_columns_values_4_q);
  logic [4:0] select_4000;
  assign select_4000 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4003;
  assign select_4003 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4005;
  assign select_4005 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4007;
  assign select_4007 = equal_556_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4005 : box_shown_columns_values_1_q);
  logic [2:0] select_4008;
  assign select_4008 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4010;
  assign select_4010 = equal_556_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4008 : box_shown_columns_values_2_q);
  logic [2:0] select_4011;
  assign select_4011 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4013;
  assign select_4013 = equal_556_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4011 : box_shown_columns_values_3_q);
  logic [2:0] select_4014;
  assign select_4014 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4016;
  assign select_4016 = equal_556_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4014 : box_shown_columns_values_4_q);
  logic [4:0] select_4018;
  assign select_4018 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4021;
  assign select_4021 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4023;
  assign select_4023 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4025;
  assign select_4025 = equal_556_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4023 : box_nearer_columns_values_1_q);
  logic [2:0] select_4026;
  assign select_4026 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4028;
  assign select_4028 = equal_556_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4026 : box_nearer_columns_values_2_q);
  logic [2:0] select_4029;
  assign select_4029 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4031;
  assign select_4031 = equal_556_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4029 : box_nearer_columns_values_3_q);
  logic [2:0] select_4032;
  assign select_4032 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4034;
  assign select_4034 = equal_556_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4032 : box_nearer_columns_values_4_q);
  logic [4:0] select_4036;
  assign select_4036 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1274
  logic select_4071;
  assign select_4071 = left_first_s3_q ? done_s3_q : proven_q;
  // hls/stages/agreement.hpp:278
  logic select_4073;
  assign select_4073 = left_first_s3_q ? done_s3_q : (and_1938_s3_q ? select_4071 : proven_q);
  // hls/stages/agreement.hpp:1307
  logic [1:0] select_4124;
  assign select_4124 = and_4123_s3_q ? {and_2094, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1308
  logic and_4125;
  assign and_4125 = select_4071 & less_4101;
  // hls/stages/agreement.hpp:437
  logic select_4128;
  assign select_4128 = and_2021_s3_q ? (less_2022_s3_q ? (select_4124[0] & and_4125) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:278
  logic select_4130;
  assign select_4130 = left_first_s3_q ? select_4128 : (and_1938_s3_q ? select_4128 : seen_q);
  logic select_4131;
  assign select_4131 = and_1938_s3_q ? select_4130 : seen_q;
  // hls/stages/agreement.hpp:437
  logic select_4134;
  assign select_4134 = and_2021_s3_q ? (less_2022_s3_q ? (select_4124[1] & and_4125) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:278
  logic select_4136;
  assign select_4136 = left_first_s3_q ? select_4134 : (and_1938_s3_q ? select_4134 : nearer_q);
  logic select_4137;
  assign select_4137 = and_1938_s3_q ? select_4136 : nearer_q;
  // hls/stages/agreement.hpp:1238
  logic or_4145;
  assign or_4145 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1240
  logic not_4153;
  assign not_4153 = ~(or_3885 | not_4138);
  // hls/stages/agreement.hpp:788
  logic and_4157;
  assign and_4157 = equal_556_s3_q & (equal_2273_s3_q & (not_4153 & (select_3893 | select_3958)));
  logic and_4160;
  assign and_4160 = equal_2273_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1149
  logic or_4164;
  assign or_4164 = select_2407 | (select_2419 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:788
  logic and_4171;
  assign and_4171 = equal_556_s3_q & (equal_2273_s3_q & (not_4153 & (select_2413 | select_2425)));
  // hls/stages/agreement.hpp:1149
  logic and_4176;
  assign and_4176 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3921 < cfg_hidden_frames_i));
  logic select_4182;
  assign select_4182 = (not_4138 | (select_3964 & not_3798)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:788
  logic and_4191;
  assign and_4191 = equal_556_s3_q & (x_s3_q[6] & (not_1957_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1140
  logic [31:0] select_4199;
  assign select_4199 = equal_1611_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4197_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4200;
  assign select_4200 = equal_1609_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4199;
  logic [31:0] select_4201;
  assign select_4201 = equal_1607_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4200;
  logic [31:0] select_4202;
  assign select_4202 = equal_1605_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4201;
  logic [31:0] select_4203;
  assign select_4203 = equal_1603_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4202;
  logic [31:0] select_4204;
  assign select_4204 = equal_1601_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4203;
  logic [31:0] select_4205;
  assign select_4205 = equal_1599_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4204;
  logic [31:0] select_4206;
  assign select_4206 = equal_1597_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4205;
  // hls/stages/agreement.hpp:1138
  logic [9:0] select_4207;
  assign select_4207 = less_2603 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1142
  logic [31:0] select_4208;
  assign select_4208 = equal_1589_s3_q ? select_4206 : {2'h0, select_4207, select_2607, select_2604};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_532_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {less_728_s3_q, and_727, less_722_s3_q, and_721_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_715, and_691_s3_q, and_690_s3_q, and_665_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q, less_650_s3_q, less_649_s3_q, less_648_s3_q, less_647_s3_q, less_646_s3_q, less_645_s3_q, less_644_s3_q, less_643_s3_q, less_642_s3_q, less_641_s3_q, less_640_s3_q, less_639_s3_q, less_638_s3_q, less_637_s3_q, less_636_s3_q, less_635_s3_q, less_634_s3_q};
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
  assign registration_sums_waddr = {sum_1595_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1654_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1653, sum_1649};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_1683_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_1757_s3_q;
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
  assign patches_right_0_waddr = {select_1788_s3_q, select_1785};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_1797);
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
  assign patches_right_1_waddr = {select_1788_s3_q, select_1814};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1817);
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
  assign patches_left_waddr = {select_1836, select_1835_s3_q, column_5};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1842);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1945;
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
  assign regions_waddr = {region_row_s3_q, or_1955_s3_q, or_1952_s3_q, or_1949_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_1989_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1988, sum_1978, sum_1973};
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
  assign map_waddr = sum_2030_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2104_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2094, is_seen};
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
      patches_on_skin_most_q <= 8'h0;
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
      census_left_misses_q <= select_2253;
      sharpness_before_last_mask_q <= select_2321;
      sharpness_sums_detail_0_q <= and_532_s3_q ? select_2335 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_532_s3_q ? select_2347 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_532_s3_q ? sum_2351 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_532_s3_q ? sum_2355 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2373 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2383 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2385 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2387 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2389 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2391 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2396;
      sharpness_comparing_carry_1_q <= select_2400;
      sharpness_comparing_less_detail_0_q <= select_2407;
      sharpness_comparing_less_detail_1_q <= select_2413;
      sharpness_comparing_less_contrast_0_q <= select_2419;
      sharpness_comparing_less_contrast_1_q <= select_2425;
      counts_supervised_q <= select_2561;
      counts_textured_q <= and_2553_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2564});
      counts_explained_q <= and_2553_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2569});
      counts_nearer_q <= and_2553_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2574});
      counts_unproven_q <= and_2553_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2600});
      counts_regions_bad_q <= select_2616;
      counts_skin_supervised_q <= select_2623;
      counts_skin_textured_q <= select_2630;
      counts_skin_unproven_q <= select_2638;
      counts_on_skin_q <= select_2657;
      registration_half_across_q <= select_2735;
      registration_half_measured_q <= select_2740;
      registration_half_votes_down_q <= and_2713_s3_q ? 7'h0 : sum_2746;
      registration_half_votes_up_q <= and_2713_s3_q ? 7'h0 : sum_2754;
      registration_half_half_votes_down_q <= and_2713_s3_q ? 7'h0 : sum_2761;
      registration_half_half_votes_up_q <= and_2713_s3_q ? 7'h0 : sum_2768;
      registration_down_q <= and_2802 ? sum_2821 : registration_down_q;
      registration_up_q <= and_2802 ? sum_2830 : registration_up_q;
      registration_enough_q <= select_2844;
      registration_votes_down_q <= and_2849 ? less_2850 : registration_votes_down_q;
      registration_votes_up_q <= and_2849 ? less_2852 : registration_votes_up_q;
      registration_other_enough_q <= and_2858 ? select_2844 : registration_other_enough_q;
      registration_other_down_q <= and_2858 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2858 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_556_s3_q & and_2865)) & or_2890;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1776 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1778 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1779 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2974;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1805 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1807 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1808 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2979;
      patches_valid_0_q <= select_2984;
      patches_valid_1_q <= select_2989;
      patches_right_next_0_q <= select_2992;
      patches_right_next_1_q <= select_2995;
      patches_left_next_0_q <= select_2998;
      patches_left_next_1_q <= select_3001;
      patches_sums_values_0_q <= select_3425;
      patches_sums_values_1_q <= equal_1758_s3_q ? patches_sums_values_1_q : select_3426;
      patches_sums_values_2_q <= equal_1758_s3_q ? patches_sums_values_2_q : select_3428;
      patches_sums_values_3_q <= equal_1758_s3_q ? patches_sums_values_3_q : select_3430;
      patches_sums_values_4_q <= equal_1758_s3_q ? patches_sums_values_4_q : select_3432;
      patches_sums_values_5_q <= equal_1758_s3_q ? patches_sums_values_5_q : select_3434;
      patches_sums_values_6_q <= equal_1758_s3_q ? patches_sums_values_6_q : select_3436;
      patches_sums_values_7_q <= equal_1758_s3_q ? patches_sums_values_7_q : select_3438;
      patches_sums_values_8_q <= equal_1758_s3_q ? patches_sums_values_8_q : select_3440;
      patches_sums_values_9_q <= equal_1758_s3_q ? patches_sums_values_9_q : select_3442;
      patches_sums_values_10_q <= equal_1758_s3_q ? patches_sums_values_10_q : select_3444;
      patches_sums_values_11_q <= equal_1758_s3_q ? patches_sums_values_11_q : select_3446;
      patches_sums_values_12_q <= equal_1758_s3_q ? patches_sums_values_12_q : select_3448;
      patches_sums_values_13_q <= equal_1758_s3_q ? patches_sums_values_13_q : select_3450;
      patches_sums_values_14_q <= equal_1758_s3_q ? patches_sums_values_14_q : select_3452;
      patches_sums_values_15_q <= equal_1758_s3_q ? patches_sums_values_15_q : select_3454;
      patches_sums_values_16_q <= equal_1758_s3_q ? patches_sums_values_16_q : select_3456;
      patches_best_differing_q <= select_1945[9:0];
      patches_best_column_q <= select_1945[14:10];
      patches_quarters_0_places_q <= sum_3580;
      patches_quarters_0_up_q <= sum_3620;
      patches_quarters_0_down_q <= sum_3630;
      patches_quarters_1_places_q <= sum_3634;
      patches_quarters_1_up_q <= sum_3637;
      patches_quarters_1_down_q <= sum_3640;
      patches_quarters_2_places_q <= sum_3644;
      patches_quarters_2_up_q <= sum_3647;
      patches_quarters_2_down_q <= sum_3650;
      patches_quarters_3_places_q <= sum_3654;
      patches_quarters_3_up_q <= sum_3657;
      patches_quarters_3_down_q <= sum_3660;
      patches_word_places_q <= or_3688;
      patches_word_up_q <= ((select_3698 | select_3700) | select_3703) | select_3706;
      patches_word_down_q <= ((select_3709 | select_3711) | select_3714) | select_3717;
      patches_sum_places_q <= select_3727;
      patches_sum_up_q <= select_3730;
      patches_sum_down_q <= select_3733;
      patches_across_q <= sum_3745;
      patches_places_q <= select_3756;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3760;
      patches_partly_q <= or_3763;
      patches_clear_limit_q <= sum_3764[8:2];
      patches_complete_q <= select_3766;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_3749 ? select_3773 : patches_found_q;
      patches_doubted_q <= select_3780;
      patches_doubted_before_q <= select_3781;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3785;
      patches_on_skin_q <= sum_3795;
      patches_on_skin_most_q <= product_3796[12:5];
      patches_large_q <= not_3798 & and_3802;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3807;
      patches_spoiled_q <= or_3811;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3818;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3828;
      segment_textured_q <= select_1970 + {5'h0, and_2564};
      segment_explained_q <= select_1975 + {5'h0, and_2569};
      segment_nearer_q <= select_1985 + {5'h0, and_2574};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_556_s3_q ? select_3901 : good_q;
      good_known_q <= select_3905;
      hidden_for_q <= select_3923;
      product_q <= equal_556_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3948;
      disagree_q <= equal_556_s3_q ? select_3893 : disagree_q;
      too_much_q <= equal_556_s3_q ? select_3958 : too_much_q;
      hides_q <= equal_556_s3_q ? select_3918 : hides_q;
      overlooks_q <= equal_556_s3_q ? select_3964 : overlooks_q;
      proven_q <= and_1938_s3_q ? select_4073 : proven_q;
      seen_q <= select_4131;
      nearer_q <= select_4137;
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
      averager_quarter_1_0_q <= select_2128;
      averager_quarter_1_1_q <= select_2130;
      averager_quarter_2_0_q <= select_2132;
      averager_quarter_2_1_q <= select_2134;
      averager_detail_0_q <= select_2146;
      averager_detail_1_q <= select_2154;
      census_changes_values_0_left_q <= and_532_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_532_s3_q ? sum_2237 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2239;
      census_changes_values_1_right_q <= select_2240;
      census_changes_values_2_left_q <= select_2241;
      census_changes_values_2_right_q <= select_2242;
      sharpness_last_mask_q <= and_532_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_532_s3_q ? select_2318[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_532_s3_q ? select_2318[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_3968;
      box_textured_columns_values_1_q <= select_3971;
      box_textured_columns_values_2_q <= select_3974;
      box_textured_columns_values_3_q <= select_3977;
      box_textured_columns_values_4_q <= select_3980;
      box_textured_sum_sums_values_0_q <= equal_556_s3_q ? box_textured_sum_sums_values_0_q : select_3982;
      box_explained_columns_values_0_q <= select_3986;
      box_explained_columns_values_1_q <= select_3989;
      box_explained_columns_values_2_q <= select_3992;
      box_explained_columns_values_3_q <= select_3995;
      box_explained_columns_values_4_q <= select_3998;
      box_explained_sum_sums_values_0_q <= equal_556_s3_q ? box_explained_sum_sums_values_0_q : select_4000;
      box_shown_columns_values_0_q <= equal_556_s3_q ? box_shown_columns_values_0_q : select_4003;
      box_shown_columns_values_1_q <= select_4007;
      box_shown_columns_values_2_q <= select_4010;
      box_shown_columns_values_3_q <= select_4013;
      box_shown_columns_values_4_q <= select_4016;
      box_shown_sum_sums_values_0_q <= equal_556_s3_q ? box_shown_sum_sums_values_0_q : select_4018;
      box_nearer_columns_values_0_q <= equal_556_s3_q ? box_nearer_columns_values_0_q : select_4021;
      box_nearer_columns_values_1_q <= select_4025;
      box_nearer_columns_values_2_q <= select_4028;
      box_nearer_columns_values_3_q <= select_4031;
      box_nearer_columns_values_4_q <= select_4034;
      box_nearer_sum_sums_values_0_q <= equal_556_s3_q ? box_nearer_sum_sums_values_0_q : select_4036;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4075_s4_q;
  logic or_4139_s4_q;
  logic and_4140_s4_q;
  logic and_4148_s4_q;
  logic and_4151_s4_q;
  logic and_4157_s4_q;
  logic and_4161_s4_q;
  logic and_4167_s4_q;
  logic and_4171_s4_q;
  logic and_4179_s4_q;
  logic and_4184_s4_q;
  logic and_4187_s4_q;
  logic and_4191_s4_q;
  logic [5:0] select_4193_s4_q;
  logic [31:0] select_4210_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_4075_s4_q <= said_q;
      or_4139_s4_q <= not_4138 | select_4131;
      and_4140_s4_q <= cfg_prove_i & select_4137;
      and_4148_s4_q <= equal_556_s3_q & (equal_2273_s3_q & (cfg_prove_i & or_4145));
      and_4151_s4_q <= equal_556_s3_q & (equal_2273_s3_q & (cfg_prove_i & or_3885));
      and_4157_s4_q <= and_4157;
      and_4161_s4_q <= equal_556_s3_q & and_4160;
      and_4167_s4_q <= equal_556_s3_q & (equal_2273_s3_q & (not_4153 & or_4164));
      and_4171_s4_q <= and_4171;
      and_4179_s4_q <= equal_556_s3_q & (equal_2273_s3_q & (cfg_prove_i & and_4176));
      and_4184_s4_q <= equal_556_s3_q & (equal_2273_s3_q & select_4182);
      and_4187_s4_q <= and_4187_s3_q;
      and_4191_s4_q <= and_4191;
      select_4193_s4_q <= equal_556_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4210_s4_q <= equal_556_s3_q ? (x_s3_q[6] ? select_4208 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4139_s4_q;
  assign marks_nearer_o = and_4140_s4_q;
  assign verdict_valid_o = and_4075_s4_q;
  assign verdict_unproven_yet_o = and_4148_s4_q;
  assign verdict_untextured_o = and_4151_s4_q;
  assign verdict_disagree_o = and_4157_s4_q;
  assign verdict_moved_o = and_4161_s4_q;
  assign verdict_unsharp_left_o = and_4167_s4_q;
  assign verdict_unsharp_right_o = and_4171_s4_q;
  assign verdict_hidden_o = and_4179_s4_q;
  assign verdict_overlooked_o = and_4184_s4_q;
  assign verdict_out_of_step_o = and_4187_s4_q;
  assign frame_valid_o = and_4191_s4_q;
  assign frame_index_o = select_4193_s4_q;
  assign frame_word_o = select_4210_s4_q;
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
  assign unused_bits = ^{over[13:0], product_3796[4:0], sum_3764[1:0], sum_3719[1:0], product_3610[4:0], sum_2703[0], difference_2644[1:0], detail_4[1:0], detail_3[1:0], sum_2247[4:0], sum_1699[0], sum_1695[0], sum_713[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
