// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::field>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2963 bits, pipeline 822 bits, memories 58819 bits.
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
  logic [5:0] sum_2403;
  assign sum_2403 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3439;
  assign difference_3439 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_3657;
  assign not_3657 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_3714;
  assign difference_3714 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_3960;
  assign less_3960 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_3961;
  assign sum_3961 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic [7:0] select_3962;
  assign select_3962 = less_3960 ? {sum_3961, cfg_height_i[5:3]} : 8'h0;
  logic not_3997;
  assign not_3997 = ~cfg_prove_i;

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
  // hls/stages/census.hpp:35
  logic [2:0] select_486;
  assign select_486 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [5:0] select_488;
  assign select_488 = sample_pair_first_q ? 6'h0 : (raster_row_ended_q ? 6'h0 : raster_at_column_q);
  // hls/stages/census.hpp:115
  logic [7:0] select_491;
  assign select_491 = ({select_488, select_486} == 9'h0) ? 8'h0 : (averager_place_q + 8'h1);
  // hls/stages/census.hpp:116
  logic [7:0] select_492;
  assign select_492 = select_486[0] ? averager_place_q : select_491;
  // hls/stages/census.hpp:41
  logic or_493;
  assign or_493 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:411
  logic and_496;
  assign and_496 = (select_486[0] & or_493) & (select_492 < 8'hbd);
  // hls/stages/census.hpp:41
  logic [2:0] select_501;
  assign select_501 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:270
  logic [5:0] column;
  assign column = sample_pair_whole_q ? select_488 : 6'h0;
  // hls/stages/census.hpp:50
  logic equal_518;
  assign equal_518 = select_486 == 3'h7;
  // hls/stages/census.hpp:53
  logic equal_519;
  assign equal_519 = select_501 == 3'h7;
  // hls/stages/census.hpp:126
  logic and_520;
  assign and_520 = equal_519 & and_496;
  // hls/stages/agreement.hpp:270
  logic and_522;
  assign and_522 = sample_pair_whole_q & (equal_518 & and_520);
  // hls/stages/agreement.hpp:194
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:617
  logic equal_542;
  assign equal_542 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:588
  logic or_543;
  assign or_543 = so | equal_542;
  // hls/stages/agreement.hpp:712
  logic not_544;
  assign not_544 = ~or_543;
  // hls/stages/agreement.hpp:608
  logic equal_545;
  assign equal_545 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:609
  logic equal_547;
  assign equal_547 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:586
  logic [7:0] sum_548;
  assign sum_548 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:588
  logic [7:0] select_549;
  assign select_549 = run_shift_q[5] ? x_q : sum_548;
  logic less_550;
  assign less_550 = {2'h0, last_q} < select_549;
  // hls/stages/agreement.hpp:222
  logic not_551;
  assign not_551 = ~less_550;
  // hls/stages/agreement.hpp:147
  logic and_552;
  assign and_552 = equal_547 & not_551;
  logic and_554;
  assign and_554 = not_544 & ((~equal_545) & and_552);
  // hls/stages/census.hpp:41
  logic [5:0] select_581;
  assign select_581 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:270
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_581 : 6'h0;
  // hls/stages/agreement.hpp:147
  logic select_638;
  assign select_638 = equal_545 ? not_551 : and_552;
  // hls/stages/agreement.hpp:790
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:788
  logic [6:0] sum_658;
  assign sum_658 = {1'b0, last_q} + 7'h3;
  // hls/stages/agreement.hpp:147
  logic and_663;
  assign and_663 = equal_545 & (age_q[2] & (ends_cell_q & (~({1'b0, sum_658} < select_549))));
  logic select_664;
  assign select_664 = or_543 ? not_551 : and_663;
  // hls/stages/agreement.hpp:813
  logic [5:0] right;
  assign right = sum_548[5:0] + 6'h3d;
  // hls/stages/patches.hpp:122
  logic and_1596;
  assign and_1596 = (select_486 == 3'h0) & (select_488 == 6'h0);
  // hls/stages/patches.hpp:391
  logic not_1597;
  assign not_1597 = ~patches_begins_q;
  // hls/stages/census.hpp:31
  logic not_1600;
  assign not_1600 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:361
  logic and_1601;
  assign and_1601 = patches_capturing_q & not_1600;
  // hls/stages/patches.hpp:363
  logic equal_1602;
  assign equal_1602 = {or_493, select_501} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_1604;
  assign equal_1604 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_1609;
  assign and_1609 = (not_1597 & (patches_work_q == 3'h0)) & (~(and_1601 | ((~equal_1602) | (~equal_1604))));
  // hls/stages/patches.hpp:529
  logic equal_1698;
  assign equal_1698 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:507
  logic not_1699;
  assign not_1699 = ~equal_1698;
  // hls/stages/patches.hpp:500
  logic equal_1700;
  assign equal_1700 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:453
  logic not_1701;
  assign not_1701 = ~equal_1700;
  // hls/stages/patches.hpp:494
  logic equal_1702;
  assign equal_1702 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_1703;
  assign equal_1703 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:529
  logic or_1704;
  assign or_1704 = equal_1702 | equal_1703;
  // hls/stages/patches.hpp:455
  logic not_1705;
  assign not_1705 = ~patches_second_q;
  // hls/stages/patches.hpp:372
  logic [4:0] select_1727;
  assign select_1727 = and_1609 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_1728;
  assign select_1728 = and_1596 ? select_1727 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_1730;
  assign and_1730 = and_1601 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_1734;
  assign select_1734 = and_1596 ? (and_1609 | (and_1601 & (~and_1730))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_1742;
  assign and_1742 = not_1699 & (not_1701 & (or_1704 & (patches_second_q & equal_1703)));
  // hls/stages/patches.hpp:167
  logic not_1759;
  assign not_1759 = ~equal_1703;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_1775;
  assign select_1775 = and_1596 ? {select_1727[4], select_1727[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:453
  logic and_1785;
  assign and_1785 = not_1699 & (or_1704 & not_1701);
  // hls/stages/agreement.hpp:188
  logic and_1879;
  assign and_1879 = right_q & (~marks_first_i);
  // hls/stages/agreement.hpp:270
  logic [2:0] select_2050;
  assign select_2050 = sample_pair_whole_q ? (sample_last_q ? (select_501 + 3'h1) : select_501) : raster_at_y_q;
  logic [5:0] select_2052;
  assign select_2052 = sample_pair_whole_q ? (select_488 + {5'h0, equal_518}) : raster_at_column_q;
  logic [5:0] select_2055;
  assign select_2055 = sample_pair_whole_q ? (sample_last_q ? (select_581 + {5'h0, equal_519}) : select_581) : raster_at_row_q;
  logic select_2059;
  assign select_2059 = sample_pair_whole_q ? (sample_last_q ? (or_493 & (~raster_final_row_q)) : or_493) : raster_at_live_q;
  // hls/stages/census.hpp:49
  logic [8:0] select_2061;
  assign select_2061 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:270
  logic select_2065;
  assign select_2065 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:453
  logic equal_2309;
  assign equal_2309 = {last[7:6], column} == {2'h0, last[5:0]};
  // hls/stages/agreement.hpp:458
  logic and_2310;
  assign and_2310 = and_522 & equal_2309;
  // hls/stages/agreement.hpp:517
  logic select_2313;
  assign select_2313 = (and_2310 | (~ends_cell_q)) ? and_2310 : ends_q;
  // hls/stages/agreement.hpp:523
  logic [2:0] now;
  assign now = select_2313 ? (and_2310 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:528
  logic [5:0] select_2317;
  assign select_2317 = select_2313 ? (and_2310 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2320;
  assign select_2320 = select_2313 ? (following_last_shift_q & (~and_2310)) : run_last_shift_q;
  // hls/stages/agreement.hpp:601
  logic and_2323;
  assign and_2323 = run_last_shift_q & equal_545;
  // hls/stages/agreement.hpp:610
  logic select_2325;
  assign select_2325 = equal_545 ? (~run_last_shift_q) : equal_547;
  // hls/stages/agreement.hpp:614
  logic equal_2326;
  assign equal_2326 = run_phase_q == 3'h1;
  logic not_2329;
  assign not_2329 = ~select_2325;
  // hls/stages/agreement.hpp:617
  logic equal_2331;
  assign equal_2331 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:601
  logic and_2332;
  assign and_2332 = final_row_q & so;
  // hls/stages/agreement.hpp:614
  logic [1:0] select_2333;
  assign select_2333 = equal_2331 ? 2'h1 : {2{and_2332}};
  logic [2:0] select_2335;
  assign select_2335 = (and_2323 | (select_2325 | equal_2326)) ? (equal_2326 ? 3'h2 : {not_2329, {2{select_2325}}}) : (equal_542 ? 3'h6 : {select_2333[0], select_2333});
  // hls/stages/agreement.hpp:601
  logic and_2338;
  assign and_2338 = select_2325 & ({plan_shift_q[5], plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:624
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2341;
  assign select_2341 = (plan_shift_q[5] & select_2325) ? value : 7'h0;
  logic [1:0] or_2342;
  assign or_2342 = {2{so}} | select_2341[5:4];
  // hls/stages/agreement.hpp:627
  logic [7:0] select_2343;
  assign select_2343 = select_2325 ? plan_columns_q : 8'h0;
  logic [6:0] or_2346;
  assign or_2346 = select_2343[6:0] | ((equal_2326 | equal_2331) ? whole_q : 7'h0);
  logic [1:0] or_2347;
  assign or_2347 = {2{and_2323}} | or_2346[3:2];
  // hls/stages/agreement.hpp:628
  logic [6:0] or_2349;
  assign or_2349 = {or_2346[6:4], or_2347, or_2346[1:0]} | (equal_542 ? drawn_q : 7'h0);
  logic [4:0] or_2350;
  assign or_2350 = {5{so}} | {or_2349[6], or_2349[3:0]};
  // hls/stages/agreement.hpp:634
  logic not_2354;
  assign not_2354 = ~run_shift_q[5];
  logic [6:0] difference_2356;
  assign difference_2356 = {1'b0, last_q} - {1'b0, least_q};
  logic [7:0] select_2357;
  assign select_2357 = equal_545 ? ({{7{not_2354}}, 1'b1} + run_span_q) : {difference_2356[6], difference_2356};
  // hls/stages/agreement.hpp:517
  logic [6:0] select_2361;
  assign select_2361 = and_2310 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:520
  logic [7:0] select_2363;
  assign select_2363 = select_2313 ? {select_2361[6], select_2361} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2366;
  assign select_2366 = select_2313 ? (and_2310 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:514
  logic [5:0] select_2374;
  assign select_2374 = and_522 ? (equal_2309 ? ((5'he < column[5:1]) ? 6'h1d : column) : least_q) : least_q;
  logic [6:0] select_2377;
  assign select_2377 = and_522 ? (equal_2309 ? ({1'b0, cfg_width_i[8:3]} + 7'hb) : whole_q) : whole_q;
  logic [6:0] select_2380;
  assign select_2380 = and_522 ? (equal_2309 ? ({1'b0, cfg_width_i[8:3]} + 7'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:525
  logic select_2394;
  assign select_2394 = (ends_cell_q | select_2313) ? ((~(now == 3'h6)) & (~(now == 3'h3))) : (equal_545 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:520
  logic and_2398;
  assign and_2398 = (~select_2313) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:470
  logic [6:0] sum_2399;
  assign sum_2399 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:454
  logic select_2401;
  assign select_2401 = equal_2309 ? ({sum_2399[6], cfg_height_i[8:3]} == {1'b0, sum_2399[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_2753;
  assign select_2753 = and_1596 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_2754;
  assign select_2754 = sample_pair_whole_q ? select_2753 : patches_phase_q;
  // hls/stages/patches.hpp:372
  logic and_2755;
  assign and_2755 = not_1600 & equal_1602;
  logic [8:0] select_2756;
  assign select_2756 = and_2755 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_2757;
  assign select_2757 = and_2755 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_2758;
  assign select_2758 = sample_pair_first_q ? select_2756 : select_2757;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_2760;
  assign select_2760 = sample_pair_whole_q ? (and_1596 ? select_2758[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_2762;
  assign select_2762 = sample_pair_whole_q ? (and_1596 ? select_2758[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_2765;
  assign select_2765 = sample_pair_whole_q ? (equal_1604 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_2767;
  assign select_2767 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_1604}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_2768;
  assign equal_2768 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_2769;
  assign not_2769 = ~equal_2768;
  // hls/stages/agreement.hpp:270
  logic [3:0] select_2771;
  assign select_2771 = sample_pair_whole_q ? (phase + {not_2769, 1'b1, not_2769, equal_2768}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:464
  logic equal_2773;
  assign equal_2773 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_2777;
  assign select_2777 = equal_2773 ? ((select_2754 == 4'h6) ? 4'h0 : (select_2754 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_2778;
  assign equal_2778 = select_2777 == 4'h0;
  // hls/stages/agreement.hpp:454
  logic [3:0] select_2781;
  assign select_2781 = equal_2309 ? (equal_2778 ? 4'h6 : (select_2777 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_2783;
  assign select_2783 = equal_2773 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:454
  logic [4:0] select_2785;
  assign select_2785 = equal_2309 ? (select_2783 + {4'h0, equal_2778}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:514
  logic select_2790;
  assign select_2790 = and_522 ? (equal_2309 ? ((6'h2 < row) & equal_2778) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_2792;
  assign select_2792 = and_522 ? (equal_2309 ? select_2783 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:370
  logic or_2815;
  assign or_2815 = select_488[0] | select_581[5];
  logic [7:0] sum_2816;
  assign sum_2816 = {1'b0, select_488[2:1], or_2815, select_581[4:1]} + 8'h1;
  logic less_2817;
  assign less_2817 = {sum_2816, select_581[0], select_501, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_2820;
  assign select_2820 = and_1596 ? (and_1609 ? (~less_2817) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:392
  logic or_2859;
  assign or_2859 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:394
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_2865;
  assign and_2865 = equal_1698 & not_1705;
  // hls/stages/patches.hpp:398
  logic and_2866;
  assign and_2866 = not_1759 & and_2865;
  logic [1:0] select_2868;
  assign select_2868 = equal_1700 ? 2'h0 : (equal_1702 ? 2'h3 : {equal_1703, and_2866});
  // hls/stages/patches.hpp:279
  logic equal_2870;
  assign equal_2870 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_2871;
  assign not_2871 = ~equal_2870;
  // hls/stages/patches.hpp:279
  logic equal_2872;
  assign equal_2872 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_2873;
  assign not_2873 = ~equal_2872;
  // hls/stages/patches.hpp:283
  logic not_2875;
  assign not_2875 = ~(patches_following_q == 3'h2);
  logic and_2878;
  assign and_2878 = (~(patches_following_q == 3'h1)) & not_2875;
  // hls/stages/patches.hpp:396
  logic [1:0] select_2879;
  assign select_2879 = equal_2872 ? 2'h2 : {and_2878, not_2875};
  logic [3:0] select_2880;
  assign select_2880 = equal_2870 ? 4'h2 : {select_2879, {2{not_2873}}};
  // hls/stages/patches.hpp:404
  logic not_2883;
  assign not_2883 = ~or_2859;
  // hls/stages/patches.hpp:393
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:405
  logic [11:0] select_2888;
  assign select_2888 = or_2859 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_2890;
  assign select_2890 = or_2859 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1339; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] fresh_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) fresh_mem[i] = 29'h0;
`endif
  logic [5:0] fresh_raddr;
  assign fresh_raddr = x_q[5:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_554;
  logic [28:0] fresh_rdata_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_rdata_q <= fresh_mem[fresh_raddr];
  end

  // Memory left, 47 x 77, DISTANCE 12, hls/stages/agreement.hpp:1340; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [76:0] left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) left_mem[i] = 77'h0;
`endif
  logic [5:0] left_raddr;
  assign left_raddr = x_q[5:0];
  logic left_re;
  assign left_re = s0_en & (or_543 ? not_551 : select_638);
  logic [76:0] left_rdata_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_rdata_q <= left_mem[left_raddr];
  end

  // Memory right_codes, 47 x 91, DISTANCE 12, hls/stages/agreement.hpp:1341; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [90:0] right_codes_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) right_codes_mem[i] = 91'h0;
`endif
  logic [5:0] right_codes_raddr;
  assign right_codes_raddr = equal_545 ? sum_548[5:0] : x_q[5:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_544 & select_638);
  logic [90:0] right_codes_rdata_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_rdata_q <= right_codes_mem[right_codes_raddr];
  end

  // Memory best_left, 47 x 62, DISTANCE 12, hls/stages/agreement.hpp:1342; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [61:0] best_left_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_left_mem[i] = 62'h0;
`endif
  logic [5:0] best_left_raddr;
  assign best_left_raddr = or_543 ? x_q[5:0] : x[5:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_664;
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
  assign patches_right_0_re = s0_en & (not_1699 & (not_1701 & (or_1704 & (equal_1703 & not_1705))));
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
  assign patches_right_1_re = s0_en & and_1742;
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
  assign patches_left_re = s0_en & (not_1699 & (not_1701 & (not_1759 & or_1704)));
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
  assign patches_columns_above_re = s0_en & and_1785;
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
      left_first_q <= and_1879 ? left_first_q : marks_first_i;
      right_q <= (~and_1879) & (~marks_last_i);
      sample_pair_first_q <= left_first_q;
      sample_pair_whole_q <= and_1879;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_486 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2050;
      raster_at_column_q <= select_2052;
      raster_at_row_q <= select_2055;
      raster_at_live_q <= select_2059;
      raster_rows_left_q <= sample_pair_whole_q ? select_2061 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2065;
      averager_place_q <= sample_pair_whole_q ? select_492 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2317;
      run_last_shift_q <= select_2320;
      run_span_q <= select_2313 ? (and_2310 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2335;
      following_shift_q <= select_2325 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2338;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2341[6], or_2342, select_2341[3:0]};
      following_columns_q <= {select_2343[7], or_2350[4], or_2349[5:4], or_2350[3:0]};
      plan_shift_q <= equal_545 ? (run_shift_q + 6'h1) : (6'h0 - least_q);
      plan_span_q <= select_2357;
      plan_columns_q <= (plan_span_q < 8'h3) ? 8'h6 : (plan_span_q + 8'h3);
      x_q <= select_2363;
      columns_left_q <= select_2366;
      last_q <= and_522 ? (equal_2309 ? column : last_q) : last_q;
      least_q <= select_2374;
      whole_q <= select_2377;
      drawn_q <= select_2380;
      age_q <= select_2313 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2313 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2394;
      ends_q <= and_2398;
      final_row_q <= and_522 ? select_2401 : final_row_q;
      shift_first_q <= {run_shift_q[5], run_shift_q} == (7'h0 - {1'b0, least_q});
      patches_phase_q <= select_2754;
      patches_band_rows_rows_to_next_q <= select_2760;
      patches_band_rows_number_q <= select_2762;
      patches_next_band_rows_to_next_q <= select_2765;
      patches_next_band_number_q <= select_2767;
      patches_first_band_rows_to_next_q <= select_2771;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_2768 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_522 ? select_2781 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_522 ? select_2785 : patches_choosing_number_q;
      patches_chooses_q <= select_2790;
      patches_choosing_band_q <= select_2792;
      patches_capturing_q <= sample_pair_whole_q ? select_1734 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_2820 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_1728 : patches_row_q;
      patches_work_q <= or_2859 ? following : patches_work_q;
      patches_second_q <= not_1597 & (patches_second_q | (patches_ends_q & equal_1698));
      patches_following_q <= equal_1698 ? {2'h0, and_2865} : {equal_1700, select_2868};
      patches_following_beats_q <= {select_2880, not_2871};
      patches_begins_q <= sample_pair_whole_q & (and_1596 & and_1730);
      patches_ends_q <= not_2883 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_2888;
      patches_code_row_q <= select_2890;
      patches_column_q <= or_2859 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_2883 & (patches_column_q == 5'h1e);
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
  logic [2:0] select_486_s1_q;
  logic [5:0] select_488_s1_q;
  logic [7:0] select_492_s1_q;
  logic and_496_s1_q;
  logic equal_502_s1_q;
  logic [5:0] column_s1_q;
  logic and_520_s1_q;
  logic and_522_s1_q;
  logic so_s1_q;
  logic equal_542_s1_q;
  logic or_543_s1_q;
  logic equal_545_s1_q;
  logic less_550_s1_q;
  logic not_551_s1_q;
  logic and_554_s1_q;
  logic [5:0] row_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_664_s1_q;
  logic and_1469_s1_q;
  logic [5:0] right_s1_q;
  logic equal_1477_s1_q;
  logic equal_1487_s1_q;
  logic and_1596_s1_q;
  logic and_1609_s1_q;
  logic equal_1698_s1_q;
  logic not_1699_s1_q;
  logic equal_1700_s1_q;
  logic not_1701_s1_q;
  logic equal_1702_s1_q;
  logic equal_1703_s1_q;
  logic or_1704_s1_q;
  logic [4:0] select_1728_s1_q;
  logic select_1734_s1_q;
  logic [3:0] select_1775_s1_q;
  logic and_1785_s1_q;
  logic equal_2309_s1_q;
  logic and_2310_s1_q;
  logic or_2859_s1_q;
  logic not_2883_s1_q;
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
      select_486_s1_q <= select_486;
      select_488_s1_q <= select_488;
      select_492_s1_q <= select_492;
      and_496_s1_q <= and_496;
      equal_502_s1_q <= select_501 == 3'h0;
      column_s1_q <= column;
      and_520_s1_q <= and_520;
      and_522_s1_q <= and_522;
      so_s1_q <= so;
      equal_542_s1_q <= equal_542;
      or_543_s1_q <= or_543;
      equal_545_s1_q <= equal_545;
      less_550_s1_q <= less_550;
      not_551_s1_q <= not_551;
      and_554_s1_q <= and_554;
      row_s1_q <= row;
      x_s1_2_q <= x[6:0];
      select_664_s1_q <= select_664;
      and_1469_s1_q <= not_544 & and_663;
      right_s1_q <= right;
      equal_1477_s1_q <= {x[7:6], last_q} == {2'h0, x[5:0]};
      equal_1487_s1_q <= run_phase_q == 3'h7;
      and_1596_s1_q <= and_1596;
      and_1609_s1_q <= and_1609;
      equal_1698_s1_q <= equal_1698;
      not_1699_s1_q <= not_1699;
      equal_1700_s1_q <= equal_1700;
      not_1701_s1_q <= not_1701;
      equal_1702_s1_q <= equal_1702;
      equal_1703_s1_q <= equal_1703;
      or_1704_s1_q <= or_1704;
      select_1728_s1_q <= select_1728;
      select_1734_s1_q <= select_1734;
      select_1775_s1_q <= select_1775;
      and_1785_s1_q <= and_1785;
      equal_2309_s1_q <= equal_2309;
      and_2310_s1_q <= and_2310;
      or_2859_s1_q <= or_2859;
      not_2883_s1_q <= not_2883;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:119
  logic and_497;
  assign and_497 = sample_pair_whole_s1_q & and_496_s1_q;
  // hls/stages/agreement.hpp:660
  logic not_642;
  assign not_642 = ~(row_q == 6'h0);
  // hls/stages/agreement.hpp:663
  logic and_643;
  assign and_643 = left_rdata_q[12] & not_642;
  logic and_644;
  assign and_644 = left_rdata_q[28] & not_642;
  logic and_645;
  assign and_645 = left_rdata_q[44] & not_642;
  logic and_646;
  assign and_646 = left_rdata_q[60] & not_642;
  // hls/stages/agreement.hpp:664
  logic and_650;
  assign and_650 = right_codes_rdata_q[12] & not_642;
  logic and_651;
  assign and_651 = right_codes_rdata_q[25] & not_642;
  logic and_652;
  assign and_652 = right_codes_rdata_q[38] & not_642;
  logic and_653;
  assign and_653 = right_codes_rdata_q[51] & not_642;
  logic and_654;
  assign and_654 = right_codes_rdata_q[64] & not_642;
  logic and_655;
  assign and_655 = right_codes_rdata_q[77] & not_642;
  // hls/stages/agreement.hpp:218
  logic and_670;
  assign and_670 = left_rdata_q[44] & not_551_s1_q;
  logic and_671;
  assign and_671 = right_codes_rdata_q[38] & not_551_s1_q;
  logic [11:0] select_672;
  assign select_672 = less_550_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_673;
  assign select_673 = less_550_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_677;
  assign select_677 = and_670 ? (and_671 ? (~(select_672 ^ select_673)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_683;
  assign parity_683 = ^select_677[5:3];
  logic parity_686;
  assign parity_686 = ^select_677[8:6];
  logic parity_689;
  assign parity_689 = ^select_677[11:3];
  // hls/stages/agreement.hpp:218
  logic and_693;
  assign and_693 = left_rdata_q[60] & not_551_s1_q;
  logic and_694;
  assign and_694 = right_codes_rdata_q[51] & not_551_s1_q;
  logic [11:0] select_695;
  assign select_695 = less_550_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_696;
  assign select_696 = less_550_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_700;
  assign select_700 = and_693 ? (and_694 ? (~(select_695 ^ select_696)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_703;
  assign parity_703 = ^select_700[8:6];
  logic parity_706;
  assign parity_706 = ^select_700[11:9];
  // hls/stages/agreement.hpp:218
  logic and_710;
  assign and_710 = left_rdata_q[76] & not_551_s1_q;
  logic and_711;
  assign and_711 = right_codes_rdata_q[64] & not_551_s1_q;
  logic [11:0] select_712;
  assign select_712 = less_550_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_713;
  assign select_713 = less_550_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_717;
  assign select_717 = and_710 ? (and_711 ? (~(select_712 ^ select_713)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_723;
  assign parity_723 = ^select_717[2:0];
  logic parity_726;
  assign parity_726 = ^select_717[5:3];
  logic parity_729;
  assign parity_729 = ^select_717[8:0];
  logic parity_735;
  assign parity_735 = ^select_717[11:9];
  logic parity_738;
  assign parity_738 = ^select_700[2:0];
  logic parity_741;
  assign parity_741 = ^{select_717[11:9], select_700[5:0]};
  logic parity_744;
  assign parity_744 = ^{select_717, select_700, select_677[2:0]};
  logic xor_745;
  assign xor_745 = parity_689 ^ parity_744;
  // hls/stages/count_bits.hpp:23
  logic or_749;
  assign or_749 = (select_677[1:0] == 2'h3) | (select_677[2] & (select_677[0] | select_677[1]));
  // hls/stages/count_bits.hpp:25
  logic or_753;
  assign or_753 = (select_700[7:6] == 2'h3) | (select_700[8] & (select_700[6] | select_700[7]));
  logic or_757;
  assign or_757 = (select_700[10:9] == 2'h3) | (select_700[11] & (select_700[9] | select_700[10]));
  // hls/stages/count_bits.hpp:23
  logic or_765;
  assign or_765 = (select_717[7:6] == 2'h3) | (select_717[8] & (~(select_717[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_769;
  assign or_769 = (select_717[1:0] == 2'h3) | (select_717[2] & (select_717[0] | select_717[1]));
  logic or_773;
  assign or_773 = (select_717[4:3] == 2'h3) | (select_717[5] & (select_717[3] | select_717[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_776;
  assign parity_776 = ^{or_773, or_769, or_765};
  // hls/stages/count_bits.hpp:23
  logic or_780;
  assign or_780 = (select_700[4:3] == 2'h3) | (select_700[5] & (select_700[3] | select_700[4]));
  // hls/stages/count_bits.hpp:25
  logic or_784;
  assign or_784 = (select_717[10:9] == 2'h3) | (select_717[11] & (select_717[9] | select_717[10]));
  logic or_788;
  assign or_788 = (select_700[1:0] == 2'h3) | (select_700[2] & (select_700[0] | select_700[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_791;
  assign parity_791 = ^{or_788, or_784, or_780};
  logic parity_794;
  assign parity_794 = ^{or_788, or_784, or_780, or_773, or_769, or_765, or_757, or_753, or_749};
  // hls/stages/count_bits.hpp:25
  logic and_795;
  assign and_795 = parity_689 & parity_744;
  logic or_799;
  assign or_799 = (parity_683 & parity_686) | ((^select_677[11:9]) & (parity_683 | parity_686));
  logic and_802;
  assign and_802 = (^{select_700[11:6], select_677[2:0]}) & (parity_729 | parity_741);
  logic or_803;
  assign or_803 = (parity_729 & parity_741) | and_802;
  // hls/stages/count_bits.hpp:23
  logic or_810;
  assign or_810 = (select_677[10:9] == 2'h3) | (select_677[11] & (select_677[9] | select_677[10]));
  // hls/stages/count_bits.hpp:25
  logic or_814;
  assign or_814 = (select_677[4:3] == 2'h3) | (select_677[5] & (select_677[3] | select_677[4]));
  logic or_818;
  assign or_818 = (select_677[7:6] == 2'h3) | (select_677[8] & (select_677[6] | select_677[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_821;
  assign parity_821 = ^{or_818, or_814, or_810};
  // hls/stages/count_bits.hpp:25
  logic or_825;
  assign or_825 = (parity_703 & parity_706) | ((^select_677[2:0]) & (parity_703 | parity_706));
  logic or_829;
  assign or_829 = (parity_723 & parity_726) | ((^select_717[8:6]) & (parity_723 | parity_726));
  logic or_833;
  assign or_833 = (parity_735 & parity_738) | ((^select_700[5:3]) & (parity_735 | parity_738));
  // hls/stages/count_bits.hpp:24
  logic parity_836;
  assign parity_836 = ^{or_833, or_829, or_825};
  logic parity_839;
  assign parity_839 = ^{or_833, or_829, or_825, or_818, or_814, or_810, or_803, or_799, and_795};
  logic xor_840;
  assign xor_840 = parity_794 ^ parity_839;
  // hls/stages/count_bits.hpp:25
  logic and_841;
  assign and_841 = parity_794 & parity_839;
  logic or_845;
  assign or_845 = (parity_776 & parity_791) | ((^{or_757, or_753, or_749}) & (parity_776 | parity_791));
  logic or_849;
  assign or_849 = (parity_821 & parity_836) | ((^{or_803, or_799, and_795}) & (parity_821 | parity_836));
  logic or_856;
  assign or_856 = (or_753 & or_757) | (or_749 & (or_753 | or_757));
  logic or_860;
  assign or_860 = (or_769 & or_773) | (or_765 & (or_769 | or_773));
  logic or_864;
  assign or_864 = (or_784 & or_788) | (or_780 & (or_784 | or_788));
  // hls/stages/count_bits.hpp:24
  logic parity_867;
  assign parity_867 = ^{or_864, or_860, or_856};
  // hls/stages/count_bits.hpp:25
  logic or_871;
  assign or_871 = (or_799 & or_803) | (and_795 & (or_799 | or_803));
  logic or_875;
  assign or_875 = (or_814 & or_818) | (or_810 & (or_814 | or_818));
  logic or_879;
  assign or_879 = (or_829 & or_833) | (or_825 & (or_829 | or_833));
  // hls/stages/count_bits.hpp:24
  logic parity_882;
  assign parity_882 = ^{or_879, or_875, or_871};
  logic parity_885;
  assign parity_885 = ^{or_879, or_875, or_871, or_864, or_860, or_856, or_849, or_845, and_841};
  // hls/stages/count_bits.hpp:25
  logic or_889;
  assign or_889 = (parity_867 & parity_882) | ((^{or_849, or_845, and_841}) & (parity_867 | parity_882));
  logic or_893;
  assign or_893 = (or_845 & or_849) | (and_841 & (or_845 | or_849));
  logic or_897;
  assign or_897 = (or_860 & or_864) | (or_856 & (or_860 | or_864));
  logic or_901;
  assign or_901 = (or_875 & or_879) | (or_871 & (or_875 | or_879));
  // hls/stages/count_bits.hpp:24
  logic parity_906;
  assign parity_906 = ^{or_901, or_897, or_893, or_889};
  // hls/stages/count_bits.hpp:25
  logic or_910;
  assign or_910 = (or_897 & or_901) | (or_893 & (or_897 | or_901));
  logic and_911;
  assign and_911 = or_889 & (^{or_901, or_897, or_893});
  // hls/stages/count_bits.hpp:24
  logic xor_912;
  assign xor_912 = or_910 ^ and_911;
  // hls/stages/count_bits.hpp:27
  logic and_913;
  assign and_913 = or_910 & and_911;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_914;
  assign select_914 = equal_545_s1_q ? {and_913, xor_912, parity_906, parity_885, xor_840, xor_745} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_543_s1_q ? 6'h0 : select_914;
  // hls/stages/agreement.hpp:676
  logic [11:0] select_925;
  assign select_925 = (slot_s1_q[0] ? and_711 : and_694) ? (~(select_673 ^ (slot_s1_q[0] ? select_712 : select_695))) : 12'h0;
  logic [11:0] select_926;
  assign select_926 = and_670 ? select_925 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_932;
  assign parity_932 = ^select_926[5:3];
  logic parity_935;
  assign parity_935 = ^select_926[8:6];
  logic parity_938;
  assign parity_938 = ^select_926[11:3];
  // hls/stages/agreement.hpp:218
  logic and_942;
  assign and_942 = right_codes_rdata_q[77] & not_551_s1_q;
  logic [11:0] select_944;
  assign select_944 = less_550_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_948;
  assign select_948 = (slot_s1_q[0] ? and_942 : and_711) ? (~(select_696 ^ (slot_s1_q[0] ? select_944 : select_712))) : 12'h0;
  logic [11:0] select_949;
  assign select_949 = and_693 ? select_948 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_952;
  assign parity_952 = ^select_949[8:6];
  logic parity_955;
  assign parity_955 = ^select_949[11:9];
  // hls/stages/agreement.hpp:726
  logic select_960;
  assign select_960 = slot_s1_q[0] ? (right_codes_rdata_q[90] & not_551_s1_q) : and_942;
  logic [11:0] select_962;
  assign select_962 = slot_s1_q[0] ? (less_550_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) : select_944;
  // hls/stages/agreement.hpp:676
  logic [11:0] select_966;
  assign select_966 = and_710 ? (select_960 ? (~(select_713 ^ select_962)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_972;
  assign parity_972 = ^select_966[2:0];
  logic parity_975;
  assign parity_975 = ^select_966[5:3];
  logic parity_978;
  assign parity_978 = ^select_966[8:0];
  logic parity_984;
  assign parity_984 = ^select_966[11:9];
  logic parity_987;
  assign parity_987 = ^select_949[2:0];
  logic parity_990;
  assign parity_990 = ^{select_966[11:9], select_949[5:0]};
  logic parity_993;
  assign parity_993 = ^{select_966, select_949, select_926[2:0]};
  logic xor_994;
  assign xor_994 = parity_938 ^ parity_993;
  // hls/stages/count_bits.hpp:23
  logic or_998;
  assign or_998 = (select_926[1:0] == 2'h3) | (select_926[2] & (select_926[0] | select_926[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1002;
  assign or_1002 = (select_949[7:6] == 2'h3) | (select_949[8] & (select_949[6] | select_949[7]));
  logic or_1006;
  assign or_1006 = (select_949[10:9] == 2'h3) | (select_949[11] & (select_949[9] | select_949[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1014;
  assign or_1014 = (select_966[7:6] == 2'h3) | (select_966[8] & (~(select_966[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1018;
  assign or_1018 = (select_966[1:0] == 2'h3) | (select_966[2] & (select_966[0] | select_966[1]));
  logic or_1022;
  assign or_1022 = (select_966[4:3] == 2'h3) | (select_966[5] & (select_966[3] | select_966[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1025;
  assign parity_1025 = ^{or_1022, or_1018, or_1014};
  // hls/stages/count_bits.hpp:23
  logic or_1029;
  assign or_1029 = (select_949[4:3] == 2'h3) | (select_949[5] & (select_949[3] | select_949[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1033;
  assign or_1033 = (select_966[10:9] == 2'h3) | (select_966[11] & (select_966[9] | select_966[10]));
  logic or_1037;
  assign or_1037 = (select_949[1:0] == 2'h3) | (select_949[2] & (select_949[0] | select_949[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1040;
  assign parity_1040 = ^{or_1037, or_1033, or_1029};
  logic parity_1043;
  assign parity_1043 = ^{or_1037, or_1033, or_1029, or_1022, or_1018, or_1014, or_1006, or_1002, or_998};
  // hls/stages/count_bits.hpp:25
  logic and_1044;
  assign and_1044 = parity_938 & parity_993;
  logic or_1048;
  assign or_1048 = (parity_932 & parity_935) | ((^select_926[11:9]) & (parity_932 | parity_935));
  logic and_1051;
  assign and_1051 = (^{select_949[11:6], select_926[2:0]}) & (parity_978 | parity_990);
  logic or_1052;
  assign or_1052 = (parity_978 & parity_990) | and_1051;
  // hls/stages/count_bits.hpp:23
  logic or_1059;
  assign or_1059 = (select_926[10:9] == 2'h3) | (select_926[11] & (select_926[9] | select_926[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1063;
  assign or_1063 = (select_926[4:3] == 2'h3) | (select_926[5] & (select_926[3] | select_926[4]));
  logic or_1067;
  assign or_1067 = (select_926[7:6] == 2'h3) | (select_926[8] & (select_926[6] | select_926[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1070;
  assign parity_1070 = ^{or_1067, or_1063, or_1059};
  // hls/stages/count_bits.hpp:25
  logic or_1074;
  assign or_1074 = (parity_952 & parity_955) | ((^select_926[2:0]) & (parity_952 | parity_955));
  logic or_1078;
  assign or_1078 = (parity_972 & parity_975) | ((^select_966[8:6]) & (parity_972 | parity_975));
  logic or_1082;
  assign or_1082 = (parity_984 & parity_987) | ((^select_949[5:3]) & (parity_984 | parity_987));
  // hls/stages/count_bits.hpp:24
  logic parity_1085;
  assign parity_1085 = ^{or_1082, or_1078, or_1074};
  logic parity_1088;
  assign parity_1088 = ^{or_1082, or_1078, or_1074, or_1067, or_1063, or_1059, or_1052, or_1048, and_1044};
  logic xor_1089;
  assign xor_1089 = parity_1043 ^ parity_1088;
  // hls/stages/count_bits.hpp:25
  logic and_1090;
  assign and_1090 = parity_1043 & parity_1088;
  logic or_1094;
  assign or_1094 = (parity_1025 & parity_1040) | ((^{or_1006, or_1002, or_998}) & (parity_1025 | parity_1040));
  logic or_1098;
  assign or_1098 = (parity_1070 & parity_1085) | ((^{or_1052, or_1048, and_1044}) & (parity_1070 | parity_1085));
  logic or_1105;
  assign or_1105 = (or_1002 & or_1006) | (or_998 & (or_1002 | or_1006));
  logic or_1109;
  assign or_1109 = (or_1018 & or_1022) | (or_1014 & (or_1018 | or_1022));
  logic or_1113;
  assign or_1113 = (or_1033 & or_1037) | (or_1029 & (or_1033 | or_1037));
  // hls/stages/count_bits.hpp:24
  logic parity_1116;
  assign parity_1116 = ^{or_1113, or_1109, or_1105};
  // hls/stages/count_bits.hpp:25
  logic or_1120;
  assign or_1120 = (or_1048 & or_1052) | (and_1044 & (or_1048 | or_1052));
  logic or_1124;
  assign or_1124 = (or_1063 & or_1067) | (or_1059 & (or_1063 | or_1067));
  logic or_1128;
  assign or_1128 = (or_1078 & or_1082) | (or_1074 & (or_1078 | or_1082));
  // hls/stages/count_bits.hpp:24
  logic parity_1131;
  assign parity_1131 = ^{or_1128, or_1124, or_1120};
  logic parity_1134;
  assign parity_1134 = ^{or_1128, or_1124, or_1120, or_1113, or_1109, or_1105, or_1098, or_1094, and_1090};
  // hls/stages/count_bits.hpp:25
  logic or_1138;
  assign or_1138 = (parity_1116 & parity_1131) | ((^{or_1098, or_1094, and_1090}) & (parity_1116 | parity_1131));
  logic or_1142;
  assign or_1142 = (or_1094 & or_1098) | (and_1090 & (or_1094 | or_1098));
  logic or_1146;
  assign or_1146 = (or_1109 & or_1113) | (or_1105 & (or_1109 | or_1113));
  logic or_1150;
  assign or_1150 = (or_1124 & or_1128) | (or_1120 & (or_1124 | or_1128));
  // hls/stages/count_bits.hpp:24
  logic parity_1155;
  assign parity_1155 = ^{or_1150, or_1146, or_1142, or_1138};
  // hls/stages/count_bits.hpp:25
  logic or_1159;
  assign or_1159 = (or_1146 & or_1150) | (or_1142 & (or_1146 | or_1150));
  logic and_1160;
  assign and_1160 = or_1138 & (^{or_1150, or_1146, or_1142});
  // hls/stages/count_bits.hpp:24
  logic xor_1161;
  assign xor_1161 = or_1159 ^ and_1160;
  // hls/stages/count_bits.hpp:27
  logic and_1162;
  assign and_1162 = or_1159 & and_1160;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_1163;
  assign select_1163 = equal_545_s1_q ? {and_1162, xor_1161, parity_1155, parity_1134, xor_1089, xor_994} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_543_s1_q ? 6'h0 : select_1163;
  // hls/stages/agreement.hpp:218
  logic and_1171;
  assign and_1171 = right_codes_rdata_q[25] & not_551_s1_q;
  // hls/stages/agreement.hpp:726
  logic select_1172;
  assign select_1172 = slot_s1_q[0] ? (right_codes_rdata_q[12] & not_551_s1_q) : and_1171;
  // hls/stages/agreement.hpp:218
  logic [11:0] select_1174;
  assign select_1174 = less_550_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:726
  logic [11:0] select_1175;
  assign select_1175 = slot_s1_q[0] ? (less_550_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) : select_1174;
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1179;
  assign select_1179 = and_670 ? (select_1172 ? (~(select_673 ^ select_1175)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1185;
  assign parity_1185 = ^select_1179[5:3];
  logic parity_1188;
  assign parity_1188 = ^select_1179[8:6];
  logic parity_1191;
  assign parity_1191 = ^select_1179[11:3];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1199;
  assign select_1199 = (slot_s1_q[0] ? and_1171 : and_671) ? (~(select_696 ^ (slot_s1_q[0] ? select_1174 : select_672))) : 12'h0;
  logic [11:0] select_1200;
  assign select_1200 = and_693 ? select_1199 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1203;
  assign parity_1203 = ^select_1200[8:6];
  logic parity_1206;
  assign parity_1206 = ^select_1200[11:9];
  // hls/stages/agreement.hpp:676
  logic [11:0] select_1214;
  assign select_1214 = (slot_s1_q[0] ? and_671 : and_694) ? (~(select_713 ^ (slot_s1_q[0] ? select_672 : select_695))) : 12'h0;
  logic [11:0] select_1215;
  assign select_1215 = and_710 ? select_1214 : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1221;
  assign parity_1221 = ^select_1215[2:0];
  logic parity_1224;
  assign parity_1224 = ^select_1215[5:3];
  logic parity_1227;
  assign parity_1227 = ^select_1215[8:0];
  logic parity_1233;
  assign parity_1233 = ^select_1215[11:9];
  logic parity_1236;
  assign parity_1236 = ^select_1200[2:0];
  logic parity_1239;
  assign parity_1239 = ^{select_1215[11:9], select_1200[5:0]};
  logic parity_1242;
  assign parity_1242 = ^{select_1215, select_1200, select_1179[2:0]};
  logic xor_1243;
  assign xor_1243 = parity_1191 ^ parity_1242;
  // hls/stages/count_bits.hpp:23
  logic or_1247;
  assign or_1247 = (select_1179[1:0] == 2'h3) | (select_1179[2] & (select_1179[0] | select_1179[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1251;
  assign or_1251 = (select_1200[7:6] == 2'h3) | (select_1200[8] & (select_1200[6] | select_1200[7]));
  logic or_1255;
  assign or_1255 = (select_1200[10:9] == 2'h3) | (select_1200[11] & (select_1200[9] | select_1200[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1263;
  assign or_1263 = (select_1215[7:6] == 2'h3) | (select_1215[8] & (~(select_1215[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1267;
  assign or_1267 = (select_1215[1:0] == 2'h3) | (select_1215[2] & (select_1215[0] | select_1215[1]));
  logic or_1271;
  assign or_1271 = (select_1215[4:3] == 2'h3) | (select_1215[5] & (select_1215[3] | select_1215[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1274;
  assign parity_1274 = ^{or_1271, or_1267, or_1263};
  // hls/stages/count_bits.hpp:23
  logic or_1278;
  assign or_1278 = (select_1200[4:3] == 2'h3) | (select_1200[5] & (select_1200[3] | select_1200[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1282;
  assign or_1282 = (select_1215[10:9] == 2'h3) | (select_1215[11] & (select_1215[9] | select_1215[10]));
  logic or_1286;
  assign or_1286 = (select_1200[1:0] == 2'h3) | (select_1200[2] & (select_1200[0] | select_1200[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1289;
  assign parity_1289 = ^{or_1286, or_1282, or_1278};
  logic parity_1292;
  assign parity_1292 = ^{or_1286, or_1282, or_1278, or_1271, or_1267, or_1263, or_1255, or_1251, or_1247};
  // hls/stages/count_bits.hpp:25
  logic and_1293;
  assign and_1293 = parity_1191 & parity_1242;
  logic or_1297;
  assign or_1297 = (parity_1185 & parity_1188) | ((^select_1179[11:9]) & (parity_1185 | parity_1188));
  logic and_1300;
  assign and_1300 = (^{select_1200[11:6], select_1179[2:0]}) & (parity_1227 | parity_1239);
  logic or_1301;
  assign or_1301 = (parity_1227 & parity_1239) | and_1300;
  // hls/stages/count_bits.hpp:23
  logic or_1308;
  assign or_1308 = (select_1179[10:9] == 2'h3) | (select_1179[11] & (select_1179[9] | select_1179[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1312;
  assign or_1312 = (select_1179[4:3] == 2'h3) | (select_1179[5] & (select_1179[3] | select_1179[4]));
  logic or_1316;
  assign or_1316 = (select_1179[7:6] == 2'h3) | (select_1179[8] & (select_1179[6] | select_1179[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1319;
  assign parity_1319 = ^{or_1316, or_1312, or_1308};
  // hls/stages/count_bits.hpp:25
  logic or_1323;
  assign or_1323 = (parity_1203 & parity_1206) | ((^select_1179[2:0]) & (parity_1203 | parity_1206));
  logic or_1327;
  assign or_1327 = (parity_1221 & parity_1224) | ((^select_1215[8:6]) & (parity_1221 | parity_1224));
  logic or_1331;
  assign or_1331 = (parity_1233 & parity_1236) | ((^select_1200[5:3]) & (parity_1233 | parity_1236));
  // hls/stages/count_bits.hpp:24
  logic parity_1334;
  assign parity_1334 = ^{or_1331, or_1327, or_1323};
  logic parity_1337;
  assign parity_1337 = ^{or_1331, or_1327, or_1323, or_1316, or_1312, or_1308, or_1301, or_1297, and_1293};
  logic xor_1338;
  assign xor_1338 = parity_1292 ^ parity_1337;
  // hls/stages/count_bits.hpp:25
  logic and_1339;
  assign and_1339 = parity_1292 & parity_1337;
  logic or_1343;
  assign or_1343 = (parity_1274 & parity_1289) | ((^{or_1255, or_1251, or_1247}) & (parity_1274 | parity_1289));
  logic or_1347;
  assign or_1347 = (parity_1319 & parity_1334) | ((^{or_1301, or_1297, and_1293}) & (parity_1319 | parity_1334));
  logic or_1354;
  assign or_1354 = (or_1251 & or_1255) | (or_1247 & (or_1251 | or_1255));
  logic or_1358;
  assign or_1358 = (or_1267 & or_1271) | (or_1263 & (or_1267 | or_1271));
  logic or_1362;
  assign or_1362 = (or_1282 & or_1286) | (or_1278 & (or_1282 | or_1286));
  // hls/stages/count_bits.hpp:24
  logic parity_1365;
  assign parity_1365 = ^{or_1362, or_1358, or_1354};
  // hls/stages/count_bits.hpp:25
  logic or_1369;
  assign or_1369 = (or_1297 & or_1301) | (and_1293 & (or_1297 | or_1301));
  logic or_1373;
  assign or_1373 = (or_1312 & or_1316) | (or_1308 & (or_1312 | or_1316));
  logic or_1377;
  assign or_1377 = (or_1327 & or_1331) | (or_1323 & (or_1327 | or_1331));
  // hls/stages/count_bits.hpp:24
  logic parity_1380;
  assign parity_1380 = ^{or_1377, or_1373, or_1369};
  logic parity_1383;
  assign parity_1383 = ^{or_1377, or_1373, or_1369, or_1362, or_1358, or_1354, or_1347, or_1343, and_1339};
  // hls/stages/count_bits.hpp:25
  logic or_1387;
  assign or_1387 = (parity_1365 & parity_1380) | ((^{or_1347, or_1343, and_1339}) & (parity_1365 | parity_1380));
  logic or_1391;
  assign or_1391 = (or_1343 & or_1347) | (and_1339 & (or_1343 | or_1347));
  logic or_1395;
  assign or_1395 = (or_1358 & or_1362) | (or_1354 & (or_1358 | or_1362));
  logic or_1399;
  assign or_1399 = (or_1373 & or_1377) | (or_1369 & (or_1373 | or_1377));
  // hls/stages/count_bits.hpp:24
  logic parity_1404;
  assign parity_1404 = ^{or_1399, or_1395, or_1391, or_1387};
  // hls/stages/count_bits.hpp:25
  logic or_1408;
  assign or_1408 = (or_1395 & or_1399) | (or_1391 & (or_1395 | or_1399));
  logic and_1409;
  assign and_1409 = or_1387 & (^{or_1399, or_1395, or_1391});
  // hls/stages/count_bits.hpp:24
  logic xor_1410;
  assign xor_1410 = or_1408 ^ and_1409;
  // hls/stages/count_bits.hpp:27
  logic and_1411;
  assign and_1411 = or_1408 & and_1409;
  // hls/stages/agreement.hpp:147
  logic [5:0] select_1412;
  assign select_1412 = equal_545_s1_q ? {and_1411, xor_1410, parity_1404, parity_1383, xor_1338, xor_1243} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_543_s1_q ? 6'h0 : select_1412;
  // hls/stages/agreement.hpp:953
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:954
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:955
  logic [5:0] select_1473;
  assign select_1473 = ({2'h0, last_s1_q} < found) ? 6'h0 : found[5:0];
  // hls/stages/agreement.hpp:988
  logic not_1488;
  assign not_1488 = ~equal_1487_s1_q;
  // hls/stages/agreement.hpp:222
  logic inside_v;
  assign inside_v = or_543_s1_q & not_551_s1_q;
  // hls/stages/agreement.hpp:780
  logic and_1490;
  assign and_1490 = ends_cell_s1_q & inside_v;
  logic and_1492;
  assign and_1492 = not_1488 & (so_s1_q & and_1490);
  logic [5:0] select_1496;
  assign select_1496 = so_s1_q ? x_s1_q[5:0] : (or_543_s1_q ? (less_550_s1_q ? 6'h0 : select_1473) : 6'h0);
  // hls/stages/agreement.hpp:958
  logic and_1504;
  assign and_1504 = (or_543_s1_q & (left_rdata_q[61] & not_551_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:241
  logic or_1518;
  assign or_1518 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/registration.hpp:218
  logic [16:0] select_1628;
  assign select_1628 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_1628[16:7])) ? 8'h7f : select_1628[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_1703_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_1703_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:495
  logic less_1791;
  assign less_1791 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:496
  logic or_1792;
  assign or_1792 = equal_1702_s1_q | less_1791;
  // hls/stages/patches.hpp:499
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_1797;
  assign select_1797 = equal_1702_s1_q ? patches_column_s1_q[0] : (or_1792 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_1798;
  assign not_1798 = ~or_1792;
  // hls/stages/patches.hpp:496
  logic [4:0] sum_1799;
  assign sum_1799 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:498
  logic [4:0] select_1802;
  assign select_1802 = or_1792 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_1799) + 5'h1) : sum_1799;
  // hls/stages/patches.hpp:500
  logic [4:0] select_1803;
  assign select_1803 = equal_1702_s1_q ? 5'h0 : select_1802;
  logic or_1804;
  assign or_1804 = equal_1702_s1_q | equal_1700_s1_q;
  // hls/stages/patches.hpp:476
  logic equal_1806;
  assign equal_1806 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_1808;
  assign equal_1808 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:478
  logic and_1810;
  assign and_1810 = of_row & (~equal_1808);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_1806 ? 2'h3 : {equal_1808, and_1810};
  // hls/stages/patches.hpp:464
  logic [8:0] sum_1813;
  assign sum_1813 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_1814;
  assign sum_1814 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_1813, pixel_2[0]} - {1'b0, sum_1814, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:466
  logic [11:0] sum_1816;
  assign sum_1816 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_1817;
  assign sum_1817 = {{4{down_2[10]}}, down_2[10:2]} + {sum_1816[11], sum_1816};
  logic [13:0] sum_1818;
  assign sum_1818 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_1817, down_2[1]};
  logic [12:0] sum_1819;
  assign sum_1819 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_1818[13:1];
  logic [14:0] sum_1820;
  assign sum_1820 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_1819, sum_1818[0], down_2[0]};
  // hls/stages/patches.hpp:462
  logic [8:0] sum_1823;
  assign sum_1823 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_1824;
  assign sum_1824 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_1823};
  logic [10:0] sum_1825;
  assign sum_1825 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_1824, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_1826;
  assign sum_1826 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_1825[10:1];
  // hls/stages/patches.hpp:463
  logic [11:0] smooth;
  assign smooth = {sum_1826, sum_1825[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:465
  logic [12:0] sum_1828;
  assign sum_1828 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_1829;
  assign sum_1829 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_1830;
  assign difference_1830 = {1'b0, sum_1828, smooth[0]} - {1'b0, sum_1829, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:477
  logic or_1836;
  assign or_1836 = (((patches_column_s1_q == 5'ha) | of_row) | equal_1808) | equal_1806;
  // hls/stages/patches.hpp:472
  logic and_1841;
  assign and_1841 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_1845;
  assign and_1845 = not_1701_s1_q & (or_1704_s1_q & (or_1836 & (equal_1703_s1_q & and_1841)));
  // hls/stages/patches.hpp:172
  logic and_1855;
  assign and_1855 = (~(equal_1703_s1_q | (~and_1841))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_1859;
  assign and_1859 = not_1701_s1_q & (or_1704_s1_q & (and_1855 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:541
  logic less_1861;
  assign less_1861 = patches_step_q[4:0] < 5'h11;
  logic equal_1862;
  assign equal_1862 = patches_step_q[6:5] == 2'h0;
  logic not_1863;
  assign not_1863 = ~equal_1862;
  logic equal_1864;
  assign equal_1864 = patches_step_q[6:5] == 2'h3;
  logic not_1865;
  assign not_1865 = ~equal_1864;
  // hls/stages/patches.hpp:555
  logic select_1868;
  assign select_1868 = equal_1864 ? (less_1861 & (less_1861 & not_1865)) : less_1861;
  // hls/stages/patches.hpp:184
  logic and_1871;
  assign and_1871 = equal_1698_s1_q & (less_1861 ? (not_1863 & select_1868) : select_1868);
  // hls/stages/division.hpp:34
  logic [5:0] sum_1900;
  assign sum_1900 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:454
  logic select_2406;
  assign select_2406 = equal_2309_s1_q ? (~({row_s1_q, 1'b0} < {sum_2403, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:514
  logic and_2643;
  assign and_2643 = and_522_s1_q & (equal_2309_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_2644;
  assign and_2644 = and_2310_s1_q & and_2643;
  // hls/stages/registration.hpp:127
  logic and_2646;
  assign and_2646 = and_2310_s1_q & (~and_2643);
  // hls/stages/registration.hpp:129
  logic [15:0] select_2647;
  assign select_2647 = and_2646 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_2649;
  assign select_2649 = and_2644 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_2647[15]}}, select_2647});
  // hls/stages/registration.hpp:130
  logic [15:0] select_2650;
  assign select_2650 = and_2646 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_2650[15]}}, select_2650};
  // hls/stages/registration.hpp:132
  logic [27:0] select_2652;
  assign select_2652 = and_2644 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:147
  logic and_2653;
  assign and_2653 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_6;
  assign column_6 = registration_slope_q + (and_2653 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_2898;
  assign select_2898 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_2901;
  assign select_2901 = equal_1700_s1_q ? patches_smooth_values_0_q : (or_1704_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_2903;
  assign select_2903 = or_1704_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_2905;
  assign select_2905 = equal_1698_s1_q ? patches_smooth_values_1_q : (equal_1700_s1_q ? patches_smooth_values_1_q : select_2903);
  logic [11:0] select_2906;
  assign select_2906 = or_1704_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_2908;
  assign select_2908 = equal_1698_s1_q ? patches_smooth_values_2_q : (equal_1700_s1_q ? patches_smooth_values_2_q : select_2906);
  logic [11:0] select_2909;
  assign select_2909 = or_1704_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_2911;
  assign select_2911 = equal_1698_s1_q ? patches_smooth_values_3_q : (equal_1700_s1_q ? patches_smooth_values_3_q : select_2909);
  logic [10:0] select_2913;
  assign select_2913 = equal_1700_s1_q ? patches_down_values_0_q : (or_1704_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_2916;
  assign select_2916 = equal_1700_s1_q ? patches_down_values_1_q : (or_1704_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_2919;
  assign select_2919 = equal_1700_s1_q ? patches_down_values_2_q : (or_1704_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_2922;
  assign select_2922 = equal_1700_s1_q ? patches_down_values_3_q : (or_1704_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_2959;
  assign and_2959 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:412
  logic [4:0] select_2964;
  assign select_2964 = or_2859_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:414
  logic [3:0] select_2966;
  assign select_2966 = and_2959 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3322;
  assign select_3322 = equal_1698_s1_q ? patches_summed_down_by_q : (equal_1700_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:551
  logic and_3355;
  assign and_3355 = less_1861 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:555
  logic select_3358;
  assign select_3358 = equal_1864 ? (less_1861 ? (not_1865 & and_3355) : and_3355) : and_3355;
  // hls/stages/patches.hpp:184
  logic select_3361;
  assign select_3361 = equal_1698_s1_q ? (less_1861 ? (not_1863 & select_3358) : select_3358) : patches_read_searches_q;
  // hls/stages/agreement.hpp:203
  logic [8:0] select_3704;
  assign select_3704 = so_s1_q ? (and_2653 ? region_across_next_q : region_across_rest_q) : {columns_begin_rest_q[7], columns_begin_rest_q};
  // hls/stages/division.hpp:35
  logic [8:0] sum_3706;
  assign sum_3706 = region_across_rest_q + {{2{region_across_back_q[6]}}, region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3707;
  assign select_3707 = sum_1900[5] ? {1'b1, sum_1900[4:0], region_across_rest_q[2:0]} : sum_3706;
  // hls/stages/agreement.hpp:454
  logic [7:0] select_3709;
  assign select_3709 = equal_2309_s1_q ? (8'hf0 - {2'h0, cfg_width_i[8:3]}) : columns_begin_rest_q;
  logic [6:0] select_3712;
  assign select_3712 = equal_2309_s1_q ? (7'h8 - {1'b0, cfg_width_i[8:3]}) : columns_begin_back_q;

  // Memory averager_memory, 189 x 26, DISTANCE 16, hls/stages/census.hpp:226; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [25:0] averager_memory_mem [0:188];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 189; i++) averager_memory_mem[i] = 26'h0;
`endif
  logic [7:0] averager_memory_raddr;
  assign averager_memory_raddr = select_492_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_497;
  logic [25:0] averager_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_rdata_q <= averager_memory_mem[averager_memory_raddr];
  end

  // Memory census_memory, 47 x 78, DISTANCE 16, hls/stages/census.hpp:334; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign census_memory_re = s1_en & and_522_s1_q;
  logic [77:0] census_memory_rdata_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_rdata_q <= census_memory_mem[census_memory_raddr];
  end

  // Memory best_right, 47 x 29, DISTANCE 12, hls/stages/agreement.hpp:1343; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [28:0] best_right_mem [0:46];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 47; i++) best_right_mem[i] = 29'h0;
`endif
  logic [5:0] best_right_raddr;
  assign best_right_raddr = or_543_s1_q ? select_1473 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_664_s1_q;
  logic [28:0] best_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_rdata_q <= best_right_mem[best_right_raddr];
  end

  // Memory shown_right, 47 x 2, DISTANCE 12, hls/stages/agreement.hpp:1344; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign shown_right_re = s1_en & and_1492;
  logic [1:0] shown_right_rdata_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_rdata_q <= shown_right_mem[shown_right_raddr];
  end

  // Memory patches_right_codes, 112 x 28, DISTANCE 12, hls/stages/patches.hpp:791; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [27:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 28'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_1803, not_1798, select_1797};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_1804;
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
  assign patches_left_codes_re = s1_en & (not_1699_s1_q & (new_row & equal_1700_s1_q));
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
  assign patches_rows_re = s1_en & and_1871;
  logic [14:0] patches_rows_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_rdata_q <= patches_rows_mem[patches_rows_raddr];
  end

  // Memory seen_columns, 47 x 18, DISTANCE 12, hls/stages/agreement.hpp:1371; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
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
  assign seen_columns_re = s1_en & and_1492;
  logic [17:0] seen_columns_rdata_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_rdata_q <= seen_columns_mem[seen_columns_raddr];
  end

  // Memory left, write
  logic [5:0] left_waddr;
  assign left_waddr = x_s1_q[5:0];
  logic left_we;
  assign left_we = s1_en & and_554_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_we) left_mem[left_waddr] <= {and_646, left_rdata_q[59:45], and_645, left_rdata_q[43:29], and_644, left_rdata_q[27:13], and_643, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_554_s1_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_codes_we) right_codes_mem[right_codes_waddr] <= {and_655, right_codes_rdata_q[76:65], and_654, right_codes_rdata_q[63:52], and_653, right_codes_rdata_q[50:39], and_652, right_codes_rdata_q[37:26], and_651, right_codes_rdata_q[24:13], and_650, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
  assign patches_columns_above_we = s1_en & and_1785_s1_q;
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
      row_q <= and_522_s1_q ? (equal_2309_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_522_s1_q ? select_2406 : lower_half_q;
      registration_slope_row_q <= select_2649;
      registration_slope_change_q <= select_2652;
      registration_slope_q <= so_s1_q ? column_6 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_2883_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_2883_s1_q & select_2898;
      patches_smooth_values_0_q <= equal_1698_s1_q ? patches_smooth_values_0_q : select_2901;
      patches_smooth_values_1_q <= select_2905;
      patches_smooth_values_2_q <= select_2908;
      patches_smooth_values_3_q <= select_2911;
      patches_down_values_0_q <= equal_1698_s1_q ? patches_down_values_0_q : select_2913;
      patches_down_values_1_q <= equal_1698_s1_q ? patches_down_values_1_q : select_2916;
      patches_down_values_2_q <= equal_1698_s1_q ? patches_down_values_2_q : select_2919;
      patches_down_values_3_q <= equal_1698_s1_q ? patches_down_values_3_q : select_2922;
      patches_down_by_q <= or_2859_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_2959});
      patches_along_q <= select_2964;
      patches_match_row_q <= or_2859_s1_q ? 4'h0 : select_2966;
      patches_summed_last_q <= not_1699_s1_q & (equal_1700_s1_q & and_2959);
      patches_summed_down_by_q <= select_3322;
      patches_step_q <= or_2859_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3361;
      region_across_rest_q <= select_3704;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_3707;
      columns_begin_rest_q <= and_522_s1_q ? select_3709 : columns_begin_rest_q;
      columns_begin_back_q <= and_522_s1_q ? select_3712 : columns_begin_back_q;
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
  logic [2:0] select_486_s2_q;
  logic [5:0] select_488_s2_q;
  logic [7:0] select_492_s2_q;
  logic and_496_s2_q;
  logic and_497_s2_q;
  logic equal_502_s2_q;
  logic [5:0] column_s2_q;
  logic and_520_s2_q;
  logic and_522_s2_q;
  logic so_s2_q;
  logic equal_542_s2_q;
  logic or_543_s2_q;
  logic less_550_s2_q;
  logic not_551_s2_q;
  logic equal_583_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [5:0] column_2_s2_q;
  logic [5:0] select_1165_s2_q;
  logic [5:0] select_1414_s2_q;
  logic and_1469_s2_q;
  logic [5:0] right_s2_q;
  logic equal_1477_s2_q;
  logic equal_1487_s2_q;
  logic not_1488_s2_q;
  logic inside_v_s2_q;
  logic and_1490_s2_q;
  logic and_1492_s2_q;
  logic [5:0] select_1496_s2_q;
  logic and_1505_s2_q;
  logic or_1518_s2_q;
  logic and_1596_s2_q;
  logic and_1609_s2_q;
  logic less_1623_s2_q;
  logic [7:0] change_s2_q;
  logic equal_1698_s2_q;
  logic equal_1700_s2_q;
  logic equal_1703_s2_q;
  logic or_1704_s2_q;
  logic [4:0] select_1728_s2_q;
  logic select_1734_s2_q;
  logic [3:0] select_1775_s2_q;
  logic less_1791_s2_q;
  logic new_row_s2_q;
  logic or_1804_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic less_1821_s2_q;
  logic less_1822_s2_q;
  logic less_1831_s2_q;
  logic less_1832_s2_q;
  logic and_1846_s2_q;
  logic and_1855_s2_q;
  logic and_1860_s2_q;
  logic less_1861_s2_q;
  logic equal_1862_s2_q;
  logic not_1863_s2_q;
  logic equal_1864_s2_q;
  logic not_1865_s2_q;
  logic and_1879_s2_q;
  logic select_1881_s2_q;
  logic and_1884_s2_q;
  logic sum_1900_s2_q;
  logic and_1921_s2_q;
  logic and_2039_s2_q;
  logic equal_2185_s2_q;
  logic equal_2309_s2_q;
  logic and_2436_s2_q;
  logic equal_2521_s2_q;
  logic less_2935_s2_q;
  logic equal_3278_s2_q;
  logic equal_3362_s2_q;
  logic less_3692_s2_q;
  logic equal_3910_s2_q;
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
      select_486_s2_q <= select_486_s1_q;
      select_488_s2_q <= select_488_s1_q;
      select_492_s2_q <= select_492_s1_q;
      and_496_s2_q <= and_496_s1_q;
      and_497_s2_q <= and_497;
      equal_502_s2_q <= equal_502_s1_q;
      column_s2_q <= column_s1_q;
      and_520_s2_q <= and_520_s1_q;
      and_522_s2_q <= and_522_s1_q;
      so_s2_q <= so_s1_q;
      equal_542_s2_q <= equal_542_s1_q;
      or_543_s2_q <= or_543_s1_q;
      less_550_s2_q <= less_550_s1_q;
      not_551_s2_q <= not_551_s1_q;
      equal_583_s2_q <= row_s1_q == 6'h0;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      column_2_s2_q <= column_2;
      select_1165_s2_q <= age_s1_q[3] ? sums_0_columns_values_13_q : 6'h0;
      select_1414_s2_q <= age_s1_q[3] ? sums_1_columns_values_13_q : 6'h0;
      and_1469_s2_q <= and_1469_s1_q;
      right_s2_q <= right_s1_q;
      equal_1477_s2_q <= equal_1477_s1_q;
      equal_1487_s2_q <= equal_1487_s1_q;
      not_1488_s2_q <= not_1488;
      inside_v_s2_q <= inside_v;
      and_1490_s2_q <= and_1490;
      and_1492_s2_q <= and_1492;
      select_1496_s2_q <= select_1496;
      and_1505_s2_q <= (or_543_s1_q & (left_rdata_q[62] & not_551_s1_q)) & and_1504;
      or_1518_s2_q <= or_1518;
      and_1596_s2_q <= and_1596_s1_q;
      and_1609_s2_q <= and_1609_s1_q;
      less_1623_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_1698_s2_q <= equal_1698_s1_q;
      equal_1700_s2_q <= equal_1700_s1_q;
      equal_1703_s2_q <= equal_1703_s1_q;
      or_1704_s2_q <= or_1704_s1_q;
      select_1728_s2_q <= select_1728_s1_q;
      select_1734_s2_q <= select_1734_s1_q;
      select_1775_s2_q <= select_1775_s1_q;
      less_1791_s2_q <= less_1791;
      new_row_s2_q <= new_row;
      or_1804_s2_q <= or_1804;
      of_row_2_s2_q <= of_row_2;
      less_1821_s2_q <= $signed(15'h100) < $signed(sum_1820);
      less_1822_s2_q <= $signed(sum_1820[14:8]) < $signed(7'h7f);
      less_1831_s2_q <= $signed(15'h100) < $signed(difference_1830);
      less_1832_s2_q <= $signed(difference_1830[14:8]) < $signed(7'h7f);
      and_1846_s2_q <= not_1699_s1_q & and_1845;
      and_1855_s2_q <= and_1855;
      and_1860_s2_q <= not_1699_s1_q & and_1859;
      less_1861_s2_q <= less_1861;
      equal_1862_s2_q <= equal_1862;
      not_1863_s2_q <= not_1863;
      equal_1864_s2_q <= equal_1864;
      not_1865_s2_q <= not_1865;
      and_1879_s2_q <= sample_pair_whole_q;
      select_1881_s2_q <= left_first_q;
      and_1884_s2_q <= right_q;
      sum_1900_s2_q <= sum_1900[5];
      and_1921_s2_q <= or_543_s1_q & (left_rdata_q[63] & not_551_s1_q);
      and_2039_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2185_s2_q <= (column_s1_q | row_s1_q) == 6'h0;
      equal_2309_s2_q <= equal_2309_s1_q;
      and_2436_s2_q <= or_543_s1_q & (not_551_s1_q & and_1504);
      equal_2521_s2_q <= shift == 6'h0;
      less_2935_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3278_s2_q <= patches_match_row_q == 4'h0;
      equal_3362_s2_q <= patches_step_q[6:5] == 2'h2;
      less_3692_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_3910_s2_q <= row_s1_q[5:3] == 3'h0;
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
  // hls/stages/census.hpp:112
  logic [11:0] select_500;
  assign select_500 = select_486_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:121
  logic [11:0] sum_504;
  assign sum_504 = select_500 + (equal_502_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:112
  logic [11:0] sum_506;
  assign sum_506 = {4'h0, sample_pair_pixel_1_q} + (select_486_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:121
  logic [11:0] sum_508;
  assign sum_508 = sum_506 + (equal_502_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:411
  logic whole;
  assign whole = select_486_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:122
  logic and_512;
  assign and_512 = whole & (averager_memory_rdata_q[24] | equal_502_s2_q);
  // hls/stages/agreement.hpp:411
  logic all_of_skin;
  assign all_of_skin = select_486_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:123
  logic and_516;
  assign and_516 = all_of_skin & (averager_memory_rdata_q[25] | equal_502_s2_q);
  // hls/stages/census.hpp:206
  logic [8:0] grey;
  assign grey = and_496_s2_q ? sum_504[11:3] : 9'h0;
  // hls/stages/census.hpp:126
  logic equal_525;
  assign equal_525 = select_486_s2_q == 3'h1;
  // hls/stages/census.hpp:207
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_525 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:270
  logic [8:0] select_528;
  assign select_528 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic [8:0] grey_2;
  assign grey_2 = and_496_s2_q ? sum_508[11:3] : 9'h0;
  // hls/stages/census.hpp:207
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_525 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:270
  logic [8:0] select_532;
  assign select_532 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:206
  logic and_533;
  assign and_533 = and_496_s2_q & and_512;
  // hls/stages/census.hpp:126
  logic select_535;
  assign select_535 = equal_525 ? and_533 : (averager_mask_q & and_533);
  // hls/stages/agreement.hpp:270
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_535;
  // hls/stages/census.hpp:206
  logic and_537;
  assign and_537 = and_496_s2_q & and_516;
  // hls/stages/census.hpp:126
  logic select_539;
  assign select_539 = equal_525 ? and_537 : (averager_of_skin_q & and_537);
  // hls/stages/agreement.hpp:270
  logic and_540;
  assign and_540 = sample_pair_whole_s2_q & select_539;
  // hls/stages/census.hpp:294
  logic less_556;
  assign less_556 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_557;
  assign less_557 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_558;
  assign less_558 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_559;
  assign less_559 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_560;
  assign less_560 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_561;
  assign less_561 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_562;
  assign less_562 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_563;
  assign less_563 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_564;
  assign less_564 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_565;
  assign less_565 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_566;
  assign less_566 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_567;
  assign less_567 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:295
  logic less_568;
  assign less_568 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_569;
  assign less_569 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_570;
  assign less_570 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_571;
  assign less_571 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_572;
  assign less_572 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_573;
  assign less_573 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_574;
  assign less_574 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_575;
  assign less_575 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_576;
  assign less_576 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_577;
  assign less_577 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_578;
  assign less_578 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_579;
  assign less_579 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:449
  logic equal_580;
  assign equal_580 = column_s2_q == 6'h0;
  logic [3:0] select_584;
  assign select_584 = equal_583_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:450
  logic [4:0] select_585;
  assign select_585 = equal_580 ? {select_584, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:276
  logic [3:0] select_586;
  assign select_586 = equal_580 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:299
  logic and_587;
  assign and_587 = select_585[4] & select_586[3];
  // hls/stages/census.hpp:286
  logic and_589;
  assign and_589 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_591;
  assign and_591 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_589);
  // hls/stages/agreement.hpp:450
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_591;
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
  logic [9:0] difference_614;
  assign difference_614 = {1'b0, select_528} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_615;
  assign xor_615 = difference_614[8:0] ^ {9{difference_614[9]}};
  logic [9:0] sum_616;
  assign sum_616 = {9'h0, difference_614[9]} + {1'b0, xor_615};
  logic [9:0] difference_617;
  assign difference_617 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_618;
  assign xor_618 = difference_617[8:0] ^ {9{difference_617[9]}};
  logic [9:0] sum_619;
  assign sum_619 = {9'h0, difference_617[9]} + {1'b0, xor_618};
  logic [9:0] difference_621;
  assign difference_621 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_622;
  assign xor_622 = difference_621[8:0] ^ {9{difference_621[9]}};
  logic [9:0] sum_623;
  assign sum_623 = {9'h0, difference_621[9]} + {1'b0, xor_622};
  logic [10:0] sum_624;
  assign sum_624 = ({1'b0, sum_616} + {1'b0, sum_619}) + {1'b0, sum_623};
  logic [9:0] difference_625;
  assign difference_625 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_626;
  assign xor_626 = difference_625[8:0] ^ {9{difference_625[9]}};
  logic [9:0] sum_627;
  assign sum_627 = {9'h0, difference_625[9]} + {1'b0, xor_626};
  logic [9:0] difference_629;
  assign difference_629 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_630;
  assign xor_630 = difference_629[8:0] ^ {9{difference_629[9]}};
  // hls/stages/agreement.hpp:799
  logic or_667;
  assign or_667 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:800
  logic select_669;
  assign select_669 = or_667 ? shift_first_s2_q : (~age_s2_q[1]);
  // hls/stages/agreement.hpp:770
  logic [5:0] select_916;
  assign select_916 = age_s2_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_917;
  assign difference_917 = {1'b0, column_2_s2_q} - {1'b0, select_916};
  logic [7:0] sum_919;
  assign sum_919 = {difference_917[6], difference_917} + (age_s2_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:747
  logic [7:0] select_920;
  assign select_920 = slot_s2_q[0] ? chosen_score_q : sum_919;
  // hls/stages/agreement.hpp:770
  logic [6:0] difference_1166;
  assign difference_1166 = {1'b0, sums_0_columns_values_0_q} - {1'b0, select_1165_s2_q};
  // hls/stages/agreement.hpp:741
  logic equal_1167;
  assign equal_1167 = {age_s2_q[0], slot_s2_q[0]} == 2'h0;
  // hls/stages/agreement.hpp:770
  logic [7:0] sum_1169;
  assign sum_1169 = {difference_1166[6], difference_1166} + (equal_1167 ? 8'h0 : sums_0_sum_sums_values_1_q);
  logic [6:0] difference_1415;
  assign difference_1415 = {1'b0, sums_1_columns_values_0_q} - {1'b0, select_1414_s2_q};
  logic [7:0] sum_1417;
  assign sum_1417 = {difference_1415[6], difference_1415} + (equal_1167 ? 8'h0 : sums_1_sum_sums_values_1_q);
  // hls/stages/agreement.hpp:743
  logic less_1418;
  assign less_1418 = sum_1169 < sum_1417;
  logic [7:0] select_1419;
  assign select_1419 = less_1418 ? sum_1417 : sum_1169;
  logic less_1420;
  assign less_1420 = select_920 < select_1419;
  // hls/stages/agreement.hpp:793
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1420 ? select_1419 : select_920) : 8'h0;
  // hls/stages/agreement.hpp:800
  logic or_1424;
  assign or_1424 = select_669 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:805
  logic [5:0] select_1425;
  assign select_1425 = or_1424 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:712
  logic not_1426;
  assign not_1426 = ~slot_s2_q[0];
  // hls/stages/agreement.hpp:744
  logic [1:0] select_1427;
  assign select_1427 = less_1418 ? {slot_s2_q[0], not_1426} : 2'h0;
  logic [2:0] select_1429;
  assign select_1429 = less_1420 ? {select_1427, not_1426} : (slot_s2_q[0] ? chosen_place_q : 3'h2);
  // hls/stages/agreement.hpp:805
  logic [2:0] select_1430;
  assign select_1430 = or_1424 ? select_1429 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1431;
  assign select_1431 = or_1424 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:802
  logic equal_1432;
  assign equal_1432 = select_1429 == 3'h1;
  logic or_1435;
  assign or_1435 = equal_1432 | (~(select_1429 == 3'h2));
  logic [7:0] select_1437;
  assign select_1437 = or_1435 ? before_0_q : before_1_q;
  logic [7:0] select_1438;
  assign select_1438 = equal_1432 ? (or_1435 ? sum_1169 : {7'h0, shift_not_right_q}) : select_1437;
  // hls/stages/agreement.hpp:805
  logic [7:0] select_1439;
  assign select_1439 = or_1424 ? select_1438 : best_left_rdata_s2_q[24:17];
  logic [7:0] select_1442;
  assign select_1442 = or_1424 ? (equal_1432 ? select_1437 : (or_1435 ? sum_1417 : before_2_q)) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v;
  assign before_v = age_s2_q[1] ? middle_sum_columns_values_3_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1444;
  assign sum_1444 = {1'b0, middle_sum_columns_values_1_q} + {1'b0, middle_sum_columns_values_2_q};
  logic [6:0] sum_1445;
  assign sum_1445 = {1'b0, before_v} + sum_1444;
  // hls/stages/agreement.hpp:747
  logic [6:0] select_1446;
  assign select_1446 = slot_s2_q[0] ? chosen_near_q : sum_1445;
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[1] ? sums_0_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1448;
  assign sum_1448 = {1'b0, sums_0_columns_values_4_q} + {1'b0, sums_0_columns_values_6_q};
  logic [6:0] sum_1449;
  assign sum_1449 = {1'b0, before_v_2} + sum_1448;
  // hls/stages/agreement.hpp:771
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[1] ? sums_1_columns_values_8_q : 6'h0;
  // hls/stages/agreement.hpp:772
  logic [6:0] sum_1451;
  assign sum_1451 = {1'b0, sums_1_columns_values_4_q} + {1'b0, sums_1_columns_values_6_q};
  logic [6:0] sum_1452;
  assign sum_1452 = {1'b0, before_v_3} + sum_1451;
  // hls/stages/agreement.hpp:743
  logic [6:0] select_1454;
  assign select_1454 = (sum_1449 < sum_1452) ? sum_1452 : sum_1449;
  // hls/stages/agreement.hpp:794
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_1446 < select_1454) ? select_1454 : select_1446) : 7'h0;
  // hls/stages/agreement.hpp:805
  logic less_1458;
  assign less_1458 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:809
  logic [6:0] select_1460;
  assign select_1460 = select_669 ? of_near : (less_1458 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_1462;
  assign select_1462 = select_669 ? run_shift_s2_q : (less_1458 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_1465;
  assign select_1465 = (run_shift_s2_q == 6'h3f) ? of_best : (select_669 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:810
  logic [7:0] select_1468;
  assign select_1468 = (run_shift_s2_q == 6'h1) ? of_best : (select_669 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:815
  logic select_1478;
  assign select_1478 = or_667 ? shift_first_s2_q : equal_1477_s2_q;
  // hls/stages/agreement.hpp:816
  logic or_1480;
  assign or_1480 = select_1478 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:820
  logic [7:0] select_1481;
  assign select_1481 = or_1480 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1482;
  assign select_1482 = or_1480 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1484;
  assign or_1484 = select_1478 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:824
  logic [6:0] select_1485;
  assign select_1485 = or_1484 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1486;
  assign select_1486 = or_1484 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:199
  logic not_1497;
  assign not_1497 = ~so_s2_q;
  // hls/stages/agreement.hpp:961
  logic select_1508;
  assign select_1508 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:962
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:975
  logic [8:0] difference_1511;
  assign difference_1511 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:976
  logic [9:0] sum_1512;
  assign sum_1512 = {difference_1511[8], difference_1511} + 10'h1;
  // hls/stages/agreement.hpp:241
  logic and_1514;
  assign and_1514 = (and_1505_s2_q & select_1508) & ({{22{sum_1512[9]}}, sum_1512} < 32'h3);
  // hls/stages/agreement.hpp:147
  logic and_1521;
  assign and_1521 = or_543_s2_q & (not_551_s2_q & (and_1514 & or_1518_s2_q));
  // hls/stages/agreement.hpp:780
  logic and_1522;
  assign and_1522 = not_1497 & and_1521;
  // hls/stages/agreement.hpp:147
  logic and_1524;
  assign and_1524 = or_543_s2_q & (not_551_s2_q & and_1514);
  // hls/stages/agreement.hpp:780
  logic and_1527;
  assign and_1527 = not_1488_s2_q & (so_s2_q ? and_1490_s2_q : (equal_542_s2_q & and_1524));
  // hls/stages/agreement.hpp:1104
  logic equal_1528;
  assign equal_1528 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1150
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1105
  logic [1:0] select_1531;
  assign select_1531 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1118
  logic [3:0] select_1533;
  assign select_1533 = equal_1528 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_1531});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_1534;
  assign sum_1534 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:780
  logic [3:0] select_1535;
  assign select_1535 = equal_1487_s2_q ? select_1533 : {sum_1534, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_1536;
  assign equal_1536 = x_s2_q[5:0] == 6'h3f;
  logic equal_1538;
  assign equal_1538 = x_s2_q[5:0] == 6'h3e;
  logic equal_1540;
  assign equal_1540 = x_s2_q[5:0] == 6'h3d;
  logic equal_1542;
  assign equal_1542 = x_s2_q[5:0] == 6'h3c;
  logic equal_1544;
  assign equal_1544 = x_s2_q[5:0] == 6'h3b;
  logic equal_1546;
  assign equal_1546 = x_s2_q[5:0] == 6'h36;
  logic equal_1548;
  assign equal_1548 = x_s2_q[5:0] == 6'h35;
  logic equal_1550;
  assign equal_1550 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1150
  logic and_1554;
  assign and_1554 = (~equal_1544) & ((~equal_1546) & ((~equal_1548) & (~equal_1550)));
  logic and_1558;
  assign and_1558 = (~equal_1536) & ((~equal_1538) & ((~equal_1540) & ((~equal_1542) & and_1554)));
  // hls/stages/agreement.hpp:1105
  logic less_1559;
  assign less_1559 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_1563;
  assign or_1563 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:988
  logic [4:0] sum_1568;
  assign sum_1568 = {1'b0, last_s2_q[5:2]} + 5'h1;
  // hls/stages/agreement.hpp:256
  logic right_2;
  assign right_2 = inside_v_s2_q & ({2'h0, sum_1568, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_1574;
  assign sum_1574 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_1576;
  assign and_1576 = half_ends & ({{3{sum_1574[4]}}, sum_1574} < 8'h3);
  // hls/stages/agreement.hpp:780
  logic and_1577;
  assign and_1577 = so_s2_q & and_1576;
  logic select_1578;
  assign select_1578 = equal_1487_s2_q ? (x_s2_q[6] & (equal_1528 ? and_1558 : (less_1559 & (~or_1563)))) : and_1577;
  // hls/stages/registration.hpp:258
  logic not_1580;
  assign not_1580 = ~lower_half_s2_q;
  logic [3:0] select_1581;
  assign select_1581 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_1580, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_1580};
  // hls/stages/patches.hpp:372
  logic [1:0] select_1610;
  assign select_1610 = and_1609_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_1611;
  assign select_1611 = and_1609_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:270
  logic [5:0] select_1612;
  assign select_1612 = and_1596_s2_q ? {select_1611, select_1610[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_1613;
  assign select_1613 = and_1596_s2_q ? select_1610 : patches_fetch_q;
  logic equal_1614;
  assign equal_1614 = select_1613 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {3'h0, last_s2_q[5:1]} < x_s2_q;
  // hls/stages/agreement.hpp:780
  logic and_1622;
  assign and_1622 = not_1488_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_1624;
  assign equal_1624 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:147
  logic [5:0] b;
  assign b = or_543_s2_q ? (less_550_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_1624 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_1632;
  assign select_1632 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_1633;
  assign select_1633 = b[1] ? a : 8'h0;
  logic [8:0] sum_1634;
  assign sum_1634 = {{2{select_1632[6]}}, select_1632} + {select_1633[7], select_1633};
  // hls/stages/registration.hpp:212
  logic [7:0] select_1635;
  assign select_1635 = b[2] ? a : 8'h0;
  logic [7:0] select_1636;
  assign select_1636 = b[3] ? a : 8'h0;
  logic [8:0] sum_1637;
  assign sum_1637 = {{2{select_1635[7]}}, select_1635[7:1]} + {select_1636[7], select_1636};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_1638;
  assign sum_1638 = {{3{sum_1634[8]}}, sum_1634[8:1]} + {sum_1637[8], sum_1637, select_1635[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_1639;
  assign select_1639 = b[4] ? a : 8'h0;
  logic [7:0] select_1640;
  assign select_1640 = b[5] ? a : 8'h0;
  logic [8:0] difference_1641;
  assign difference_1641 = {{2{select_1639[7]}}, select_1639[7:1]} - {select_1640[7], select_1640};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_1642;
  assign sum_1642 = {difference_1641, select_1639[0]} + {sum_1638[10], sum_1638[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_1624 ? {sum_1642, sum_1638[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_1644;
  assign sum_1644 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:997
  logic and_1646;
  assign and_1646 = and_1524 & ({{4{sum_1644[9]}}, sum_1644, expected[1:0]} < 16'h29);
  // hls/stages/patches.hpp:104
  logic and_1651;
  assign and_1651 = ({4'h0, last_s2_q[5:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:106
  logic equal_1652;
  assign equal_1652 = x_s2_q == 8'h0;
  // hls/stages/patches.hpp:102
  logic [9:0] sum_1658;
  assign sum_1658 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_1660;
  assign sum_1660 = {sum_1658[9], sum_1658[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:997
  logic and_1663;
  assign and_1663 = ($signed(9'h0) < $signed(sum_1658[9:1])) & (~($signed({5'h0, last_s2_q}) < $signed({sum_1660, sum_1658[0]})));
  logic and_1664;
  assign and_1664 = (~(and_1651 | (equal_1652 | (~(x_s2_q < {2'h0, last_s2_q}))))) & and_1663;
  // hls/stages/agreement.hpp:780
  logic and_1667;
  assign and_1667 = ends_cell_s2_q & (inside_v_s2_q & ((less_1623_s2_q & and_1646) & and_1664));
  logic and_1669;
  assign and_1669 = not_1488_s2_q & (so_s2_q & and_1667);
  // hls/stages/patches.hpp:156
  logic and_1671;
  assign and_1671 = and_1669 & (~patches_fixed_q);
  // hls/stages/agreement.hpp:780
  logic [6:0] select_1674;
  assign select_1674 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q[6:0] : 7'h0) : 7'h0) : 7'h0;
  logic [6:0] select_1675;
  assign select_1675 = equal_1487_s2_q ? 7'h0 : select_1674;
  logic [5:0] select_1678;
  assign select_1678 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  logic [5:0] select_1679;
  assign select_1679 = equal_1487_s2_q ? 6'h0 : select_1678;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_1680;
  assign sum_1680 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_1642[9]}}, sum_1642[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_1683;
  assign select_1683 = ($signed(sum_1680[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_1680[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_1624 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_1680[12:7])) ? 8'h7f : select_1683);
  // hls/stages/agreement.hpp:780
  logic [7:0] select_1688;
  assign select_1688 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_1689;
  assign select_1689 = equal_1487_s2_q ? 8'h0 : select_1688;
  // hls/stages/patches.hpp:342
  logic [21:0] select_1690;
  assign select_1690 = and_1671 ? {select_1689, select_1679, select_1675, and_1669} : {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, patches_choice_valid_q};
  // hls/stages/patches.hpp:113
  logic equal_1691;
  assign equal_1691 = x_s2_q == {2'h0, last_s2_q};
  // hls/stages/agreement.hpp:780
  logic and_1695;
  assign and_1695 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_1651 | equal_1691)));
  logic and_1696;
  assign and_1696 = not_1488_s2_q & and_1695;
  // hls/stages/patches.hpp:343
  logic and_1697;
  assign and_1697 = patches_chooses_s2_q & and_1696;
  // hls/stages/patches.hpp:126
  logic [4:0] select_1711;
  assign select_1711 = and_1596_s2_q ? select_1611 : patches_band_q;
  // hls/stages/patches.hpp:352
  logic equal_1712;
  assign equal_1712 = {patches_choosing_band_s2_q, and_1622} == {select_1711, select_1613[1]};
  // hls/stages/patches.hpp:481
  logic [2:0] sum_1812;
  assign sum_1812 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:485
  logic [1:0] sum_1850;
  assign sum_1850 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:203
  logic [7:0] select_1887;
  assign select_1887 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1026
  logic or_1890;
  assign or_1890 = select_1887[7] | (~({select_1887[5], select_1887[3], select_1887[1]} == 3'h0));
  // hls/stages/agreement.hpp:1025
  logic or_1893;
  assign or_1893 = select_1887[7] | (~({select_1887[6], select_1887[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1024
  logic or_1896;
  assign or_1896 = select_1887[7] | (~(select_1887[6:4] == 3'h0));
  // hls/stages/agreement.hpp:780
  logic [5:0] select_1897;
  assign select_1897 = equal_1487_s2_q ? x_s2_q[5:0] : {region_row_q, or_1896, or_1893, or_1890};
  // hls/stages/agreement.hpp:1104
  logic not_1898;
  assign not_1898 = ~equal_1528;
  // hls/stages/agreement.hpp:1034
  logic or_1902;
  assign or_1902 = (~sum_1900_s2_q) | equal_1691;
  // hls/stages/agreement.hpp:780
  logic and_1905;
  assign and_1905 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_1902));
  // hls/stages/agreement.hpp:256
  logic textured;
  assign textured = inside_v_s2_q & (or_543_s2_q & (not_551_s2_q & and_1505_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_1524;
  // hls/stages/agreement.hpp:147
  logic and_1923;
  assign and_1923 = or_543_s2_q & (not_551_s2_q & and_1921_s2_q);
  // hls/stages/agreement.hpp:256
  logic and_1932;
  assign and_1932 = inside_v_s2_q & and_1923;
  // hls/stages/agreement.hpp:993
  logic select_1933;
  assign select_1933 = slot_s2_q[2] ? shown_shown_q : and_1524;
  // hls/stages/agreement.hpp:256
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_1933);
  // hls/stages/agreement.hpp:993
  logic select_1936;
  assign select_1936 = slot_s2_q[2] ? shown_nearer_q : and_1521;
  // hls/stages/agreement.hpp:256
  logic near;
  assign near = inside_v_s2_q & (select_1933 ? select_1936 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1242
  logic select_1939;
  assign select_1939 = done_q ? write_half_q : read_half_q;
  // hls/stages/agreement.hpp:1246
  logic select_1940;
  assign select_1940 = left_first_s2_q ? select_1939 : read_half_q;
  logic or_1941;
  assign or_1941 = left_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1247
  logic [8:0] select_1942;
  assign select_1942 = or_1941 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1248
  logic [9:0] select_1944;
  assign select_1944 = left_first_s2_q ? 10'h1 : (or_1941 ? {rows_passed_q[8:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1251
  logic and_1945;
  assign and_1945 = select_1942[8] & select_1944[9];
  // hls/stages/agreement.hpp:429
  logic next_row;
  assign next_row = and_1945 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1262
  logic [5:0] select_1948;
  assign select_1948 = next_row ? cfg_width_i[8:3] : 6'h0;
  logic [10:0] select_1950;
  assign select_1950 = left_first_s2_q ? 11'h0 : (seen_base_q + {5'h0, select_1948});
  // hls/stages/agreement.hpp:1272
  logic equal_1951;
  assign equal_1951 = seen_x_q == 3'h7;
  logic [7:0] select_1953;
  assign select_1953 = and_1945 ? 8'h0 : (seen_column_q + {7'h0, equal_1951});
  // hls/stages/agreement.hpp:1279
  logic [10:0] index;
  assign index = select_1950 + {3'h0, select_1953};
  // hls/stages/agreement.hpp:1232
  logic [11:0] sum_1955;
  assign sum_1955 = {1'b0, {2{select_1940}}, 2'h0, {2{select_1940}}, 1'b0, {2{select_1940}}, 1'b0, select_1940} + {1'b0, index};
  // hls/stages/agreement.hpp:1245
  logic not_1956;
  assign not_1956 = ~left_first_s2_q;
  // hls/stages/agreement.hpp:429
  logic and_1958;
  assign and_1958 = not_1956 & (began_q | and_1945);
  // hls/stages/agreement.hpp:1273
  logic [2:0] select_1960;
  assign select_1960 = and_1945 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1278
  logic and_1962;
  assign and_1962 = and_1958 & (select_1960 == 3'h0);
  logic less_1963;
  assign less_1963 = select_1953 < {2'h0, cfg_width_i[8:3]};
  // hls/stages/agreement.hpp:431
  logic and_1964;
  assign and_1964 = and_1962 & less_1963;
  logic and_1965;
  assign and_1965 = and_1879_s2_q & and_1964;
  // hls/stages/agreement.hpp:272
  logic select_1967;
  assign select_1967 = and_1879_s2_q ? (left_first_s2_q ? and_1964 : and_1965) : and_1965;
  // hls/stages/agreement.hpp:1087
  logic [7:0] sum_1969;
  assign sum_1969 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [10:0] index_2;
  assign index_2 = {sum_1969[7], sum_1969, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1232
  logic [11:0] sum_1971;
  assign sum_1971 = {1'b0, {2{write_half_q}}, 2'h0, {2{write_half_q}}, 1'b0, {2{write_half_q}}, 1'b0, write_half_q} + {1'b0, index_2};
  // hls/stages/agreement.hpp:1009
  logic and_1972;
  assign and_1972 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_1973;
  assign and_1973 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_1974;
  assign and_1974 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_1975;
  assign and_1975 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1063
  logic [1:0] sum_1977;
  assign sum_1977 = {1'b0, and_1974} + ({1'b0, textured} + {1'b0, and_1975});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_1972} + ({2'h0, and_1973} + {1'b0, sum_1977});
  // hls/stages/agreement.hpp:1009
  logic [7:0] select_1986;
  assign select_1986 = inside_v_s2_q ? (sum_1900_s2_q ? select_1887 : {select_1887[6:0], 1'b0}) : select_1887;
  // hls/stages/agreement.hpp:1026
  logic or_1989;
  assign or_1989 = select_1986[7] | (~({select_1986[5], select_1986[3], select_1986[1]} == 3'h0));
  // hls/stages/agreement.hpp:1009
  logic and_2006;
  assign and_2006 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2007;
  assign and_2007 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2008;
  assign and_2008 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2009;
  assign and_2009 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1065
  logic [1:0] sum_2011;
  assign sum_2011 = {1'b0, and_2008} + ({1'b0, shown} + {1'b0, and_2009});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2006} + ({2'h0, and_2007} + {1'b0, sum_2011});
  // hls/stages/agreement.hpp:1009
  logic and_2022;
  assign and_2022 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2023;
  assign and_2023 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2024;
  assign and_2024 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2025;
  assign and_2025 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1066
  logic [1:0] sum_2027;
  assign sum_2027 = {1'b0, and_2024} + ({1'b0, near} + {1'b0, and_2025});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2022} + ({2'h0, and_2023} + {1'b0, sum_2027});
  // hls/stages/agreement.hpp:780
  logic and_2043;
  assign and_2043 = ends_cell_s2_q & (and_2039_s2_q & (~({1'b0, sum_1568, last_s2_q[1:0]} < x_s2_q)));
  logic and_2045;
  assign and_2045 = not_1488_s2_q & (so_s2_q & and_2043);
  // hls/stages/agreement.hpp:270
  logic [10:0] select_2077;
  assign select_2077 = sample_pair_whole_s2_q ? (and_520_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2079;
  assign select_2079 = sample_pair_whole_s2_q ? (and_520_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2098;
  assign select_2098 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2100;
  assign select_2100 = sample_pair_whole_s2_q ? (and_520_s2_q ? select_535 : averager_mask_q) : averager_mask_q;
  logic select_2102;
  assign select_2102 = sample_pair_whole_s2_q ? (and_520_s2_q ? select_539 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:514
  logic [8:0] select_2103;
  assign select_2103 = and_522_s2_q ? select_528 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2104;
  assign select_2104 = and_522_s2_q ? select_532 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2106;
  assign select_2106 = and_522_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2107;
  assign select_2107 = and_522_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2108;
  assign select_2108 = and_522_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2109;
  assign select_2109 = and_522_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2110;
  assign select_2110 = and_522_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2111;
  assign select_2111 = and_522_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2112;
  assign select_2112 = and_522_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2113;
  assign select_2113 = and_522_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2114;
  assign select_2114 = and_522_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2115;
  assign select_2115 = and_522_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2116;
  assign select_2116 = and_522_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2117;
  assign select_2117 = and_522_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2118;
  assign select_2118 = and_522_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2119;
  assign select_2119 = and_522_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2120;
  assign select_2120 = and_522_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2121;
  assign select_2121 = and_522_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2122;
  assign select_2122 = and_522_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2123;
  assign select_2123 = and_522_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2124;
  assign select_2124 = and_522_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2125;
  assign select_2125 = and_522_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2126;
  assign select_2126 = and_522_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2127;
  assign select_2127 = and_522_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2128;
  assign select_2128 = and_522_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2129;
  assign select_2129 = and_522_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2130;
  assign select_2130 = and_522_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2131;
  assign select_2131 = and_522_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2132;
  assign select_2132 = and_522_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2133;
  assign select_2133 = and_522_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2134;
  assign select_2134 = and_522_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2135;
  assign select_2135 = and_522_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2136;
  assign select_2136 = and_522_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2137;
  assign select_2137 = and_522_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2138;
  assign select_2138 = and_522_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2139;
  assign select_2139 = and_522_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2140;
  assign select_2140 = and_522_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2141;
  assign select_2141 = and_522_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2142;
  assign select_2142 = and_522_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2143;
  assign select_2143 = and_522_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2144;
  assign select_2144 = and_522_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2145;
  assign select_2145 = and_522_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2146;
  assign select_2146 = and_522_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2147;
  assign select_2147 = and_522_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2148;
  assign select_2148 = and_522_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2149;
  assign select_2149 = and_522_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2150;
  assign select_2150 = and_522_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2151;
  assign select_2151 = and_522_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2152;
  assign select_2152 = and_522_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2153;
  assign select_2153 = and_522_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2154;
  assign select_2154 = and_522_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2155;
  assign select_2155 = and_522_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2156;
  assign select_2156 = and_522_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2157;
  assign select_2157 = and_522_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2158;
  assign select_2158 = and_522_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:272
  logic [9:0] difference_2160;
  assign difference_2160 = {1'b0, select_532} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2161;
  assign xor_2161 = difference_2160[8:0] ^ {9{difference_2160[9]}};
  logic [9:0] sum_2162;
  assign sum_2162 = {9'h0, difference_2160[9]} + {1'b0, xor_2161};
  logic [9:0] difference_2163;
  assign difference_2163 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2164;
  assign xor_2164 = difference_2163[8:0] ^ {9{difference_2163[9]}};
  logic [9:0] sum_2165;
  assign sum_2165 = {9'h0, difference_2163[9]} + {1'b0, xor_2164};
  logic [9:0] difference_2167;
  assign difference_2167 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2168;
  assign xor_2168 = difference_2167[8:0] ^ {9{difference_2167[9]}};
  logic [9:0] sum_2169;
  assign sum_2169 = {9'h0, difference_2167[9]} + {1'b0, xor_2168};
  logic [10:0] sum_2170;
  assign sum_2170 = ({1'b0, sum_2162} + {1'b0, sum_2165}) + {1'b0, sum_2169};
  logic [9:0] difference_2171;
  assign difference_2171 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2172;
  assign xor_2172 = difference_2171[8:0] ^ {9{difference_2171[9]}};
  logic [9:0] sum_2173;
  assign sum_2173 = {9'h0, difference_2171[9]} + {1'b0, xor_2172};
  logic [9:0] difference_2175;
  assign difference_2175 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2176;
  assign xor_2176 = difference_2175[8:0] ^ {9{difference_2175[9]}};
  // hls/stages/census.hpp:353
  logic [9:0] difference_2206;
  assign difference_2206 = {1'b0, select_528} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2206[9]} + (difference_2206[8:0] ^ {9{difference_2206[9]}});
  logic [9:0] difference_2218;
  assign difference_2218 = {1'b0, select_532} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2218[9]} + (difference_2218[8:0] ^ {9{difference_2218[9]}});
  // hls/stages/agreement.hpp:233
  logic [5:0] select_2409;
  assign select_2409 = slot_s2_q[0] ? middle_sum_columns_values_1_q : middle_sum_columns_values_0_q;
  logic [5:0] select_2410;
  assign select_2410 = slot_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2411;
  assign select_2411 = slot_s2_q[0] ? middle_sum_columns_values_3_q : middle_sum_columns_values_2_q;
  logic [5:0] select_2412;
  assign select_2412 = slot_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2413;
  assign select_2413 = slot_s2_q[0] ? middle_sum_columns_values_5_q : middle_sum_columns_values_4_q;
  logic [5:0] select_2414;
  assign select_2414 = slot_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [7:0] select_2418;
  assign select_2418 = slot_s2_q[0] ? 8'h0 : sum_919;
  // hls/stages/agreement.hpp:743
  logic less_2419;
  assign less_2419 = select_2418 < select_1419;
  // hls/stages/agreement.hpp:233
  logic [6:0] select_2421;
  assign select_2421 = slot_s2_q[0] ? 7'h0 : sum_1445;
  // hls/stages/agreement.hpp:780
  logic not_2426;
  assign not_2426 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_2427;
  assign less_2427 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:514
  logic and_2434;
  assign and_2434 = and_522_s2_q & (equal_583_s2_q & equal_2309_s2_q);
  // hls/stages/agreement.hpp:780
  logic and_2440;
  assign and_2440 = not_1488_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_2436_s2_q)));
  // hls/stages/agreement.hpp:1009
  logic and_2460;
  assign and_2460 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_2461;
  assign and_2461 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_2462;
  assign and_2462 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_2463;
  assign and_2463 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1064
  logic [1:0] sum_2465;
  assign sum_2465 = {1'b0, and_2462} + ({1'b0, explained} + {1'b0, and_2463});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_2460} + ({2'h0, and_2461} + {1'b0, sum_2465});
  // hls/stages/agreement.hpp:780
  logic and_2501;
  assign and_2501 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2436_s2_q & and_1923)));
  // hls/stages/agreement.hpp:969
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:970
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:971
  logic [7:0] difference_2525;
  assign difference_2525 = best_left_rdata_s2_q[16:9] - lower;
  logic less_2528;
  assign less_2528 = {2'h0, difference_2525[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:147
  logic and_2531;
  assign and_2531 = not_551_s2_q & (((and_1921_s2_q & and_1514) & equal_2521_s2_q) & (~less_2528));
  // hls/stages/agreement.hpp:780
  logic and_2535;
  assign and_2535 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_543_s2_q & and_2531)));
  // hls/stages/registration.hpp:76
  logic less_2539;
  assign less_2539 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:147
  logic [7:0] select_2541;
  assign select_2541 = or_543_s2_q ? (less_550_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_2543;
  assign select_2543 = or_543_s2_q ? (less_550_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2545;
  assign select_2545 = or_543_s2_q ? (less_550_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_2543} - {1'b0, select_2545};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2547;
  assign select_2547 = rise_2[8] ? select_2543 : select_2545;
  logic [8:0] fall;
  assign fall = {1'b0, select_2541} - {1'b0, select_2547};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_2550;
  assign not_2550 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2539 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2550};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2552;
  assign xor_2552 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_2552};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_2558;
  assign select_2558 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2539 ? {taken, 1'b1} : {not_2550, select_2558, not_2550};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2560;
  assign sum_2560 = {left, 1'b1} + {taken_2, less_2539};
  // hls/stages/agreement.hpp:251
  logic [4:0] select_2562;
  assign select_2562 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:780
  logic [7:0] select_2564;
  assign select_2564 = equal_1487_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_2566;
  assign select_2566 = equal_1487_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_2567;
  assign equal_2567 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:256
  logic and_2571;
  assign and_2571 = and_1524 & less_1623_s2_q;
  // hls/stages/agreement.hpp:147
  logic [2:0] select_2573;
  assign select_2573 = or_543_s2_q ? (less_550_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2577;
  assign sum_2577 = select_2573[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_2580;
  assign select_2580 = (select_2543 < select_2545) ? ({sum_2577, select_2573[0], 5'h0} - {3'h0, select_2562}) : {sum_2577, select_2573[0], select_2562};
  logic [7:0] select_2581;
  assign select_2581 = ((select_2573 == 3'h0) | (select_2573 == 3'h4)) ? {sum_2577, select_2573[0], 5'h0} : select_2580;
  logic [11:0] value_2;
  assign value_2 = {{4{select_2581[7]}}, select_2581} - {sum_1642[9], sum_1642, sum_1638[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_2584;
  assign select_2584 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2584[11:7])) ? 12'h7f : select_2584;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_2605;
  assign difference_2605 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_2607;
  assign and_2607 = and_2571 & ($signed(difference_2605) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_2620;
  assign less_2620 = $signed(difference_2605) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:780
  logic select_2628;
  assign select_2628 = so_s2_q ? (equal_2567 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_2631;
  assign select_2631 = so_s2_q ? (equal_1624 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_2636;
  assign select_2636 = (sum_1534 == 2'h2) ? (registration_fresh_q & (~select_1581)) : registration_fresh_q;
  // hls/stages/agreement.hpp:780
  logic [3:0] select_2638;
  assign select_2638 = so_s2_q ? (and_1576 ? select_2636 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_2640;
  assign select_2640 = and_2434 ? 4'hf : (equal_1487_s2_q ? registration_fresh_q : select_2638);
  // hls/stages/agreement.hpp:1105
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_1531;
  // hls/stages/registration.hpp:258
  logic not_2661;
  assign not_2661 = ~quarter_2[1];
  logic [3:0] select_2662;
  assign select_2662 = quarter_2[0] ? {quarter_2[1], 1'b0, not_2661, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_2661};
  // hls/stages/patches.hpp:91
  logic parity_2796;
  assign parity_2796 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:454
  logic [15:0] select_2797;
  assign select_2797 = equal_2309_s2_q ? {patches_chance_q[14:0], parity_2796} : patches_chance_q;
  // hls/stages/patches.hpp:344
  logic not_2799;
  assign not_2799 = ~and_1696;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:110
  logic [4:0] select_2801;
  assign select_2801 = right_3 ? last_s2_q[5:1] : 5'h0;
  logic [5:0] from;
  assign from = {1'b0, of_32} + {1'b0, select_2801};
  // hls/stages/agreement.hpp:780
  logic and_2807;
  assign and_2807 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {2'h0, from}))));
  // hls/stages/patches.hpp:156
  logic and_2811;
  assign and_2811 = not_2799 & (patches_fixed_q | ((not_1488_s2_q & and_2807) & and_1671));
  // hls/stages/patches.hpp:353
  logic not_2824;
  assign not_2824 = ~select_1613[1];
  // hls/stages/agreement.hpp:270
  logic [1:0] select_2826;
  assign select_2826 = sample_pair_whole_s2_q ? (equal_1614 ? select_1613 : {not_2824, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:517
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_2925;
  assign select_2925 = or_1704_s2_q ? {less_1832_s2_q, less_1831_s2_q, less_1822_s2_q, less_1821_s2_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_2927;
  assign select_2927 = equal_1698_s2_q ? patches_codes_at_q : (equal_1700_s2_q ? other[55:4] : select_2925);
  // hls/stages/patches.hpp:500
  logic [27:0] word;
  assign word = or_1804_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:516
  logic [27:0] select_2930;
  assign select_2930 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_2932;
  assign select_2932 = equal_1700_s2_q ? (new_row_s2_q ? word : select_2930) : patches_codes_further_q;
  // hls/stages/patches.hpp:518
  logic [55:0] select_2934;
  assign select_2934 = less_1791_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:488
  logic [55:0] select_2936;
  assign select_2936 = less_2935_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_2938;
  assign select_2938 = or_1704_s2_q ? (equal_1703_s2_q ? patches_next_codes_q : select_2936) : patches_next_codes_q;
  logic [55:0] select_2940;
  assign select_2940 = equal_1698_s2_q ? patches_next_codes_q : (equal_1700_s2_q ? select_2934 : select_2938);
  // hls/stages/count_bits.hpp:24
  logic parity_2945;
  assign parity_2945 = ^{less_1832_s2_q, less_1831_s2_q, less_1822_s2_q, less_1821_s2_q};
  // hls/stages/count_bits.hpp:25
  logic or_2949;
  assign or_2949 = ({less_1822_s2_q, less_1821_s2_q} == 2'h3) | (less_1831_s2_q & (less_1822_s2_q | less_1821_s2_q));
  logic and_2950;
  assign and_2950 = less_1832_s2_q & (^{less_1831_s2_q, less_1822_s2_q, less_1821_s2_q});
  // hls/stages/count_bits.hpp:24
  logic xor_2951;
  assign xor_2951 = or_2949 ^ and_2950;
  // hls/stages/count_bits.hpp:27
  logic and_2952;
  assign and_2952 = or_2949 & and_2950;
  // hls/stages/patches.hpp:184
  logic [2:0] select_2954;
  assign select_2954 = or_1704_s2_q ? (and_1855_s2_q ? {and_2952, xor_2951, parity_2945} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_2958;
  assign sum_2958 = {7'h0, patches_set_q} + (equal_1703_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:517
  logic [47:0] select_2968;
  assign select_2968 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_2970;
  assign select_2970 = equal_1698_s2_q ? patches_left_row_q : (equal_1700_s2_q ? select_2968 : patches_left_row_q);
  // hls/stages/patches.hpp:519
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_2968;
  // hls/stages/count_bits.hpp:24
  logic xor_2974;
  assign xor_2974 = bits[17] ^ (^{select_2968[16:15], other[16:15]});
  logic xor_2977;
  assign xor_2977 = bits[11] ^ (^{select_2968[10:9], other[10:9]});
  logic xor_2980;
  assign xor_2980 = bits[14] ^ (^{select_2968[13:12], other[13:12]});
  logic xor_2983;
  assign xor_2983 = xor_2974 ^ (^{select_2968[14:9], other[14:9]});
  logic xor_2986;
  assign xor_2986 = bits[47] ^ (^{select_2968[46:45], other[46:45]});
  logic xor_2989;
  assign xor_2989 = bits[8] ^ (^{select_2968[7:6], other[7:6]});
  logic xor_2992;
  assign xor_2992 = bits[2] ^ (^{select_2968[1:0], other[1:0]});
  logic xor_2995;
  assign xor_2995 = bits[5] ^ (^{select_2968[4:3], other[4:3]});
  logic xor_2998;
  assign xor_2998 = xor_2989 ^ (^{select_2968[5:0], other[5:0]});
  logic parity_3000;
  assign parity_3000 = ^{select_2968[47:45], select_2968[8:0], other[47:45], other[8:0]};
  logic xor_3001;
  assign xor_3001 = xor_2983 ^ parity_3000;
  logic xor_3004;
  assign xor_3004 = bits[44] ^ (^{select_2968[43:42], other[43:42]});
  logic xor_3007;
  assign xor_3007 = bits[38] ^ (^{select_2968[37:36], other[37:36]});
  logic xor_3010;
  assign xor_3010 = bits[41] ^ (^{select_2968[40:39], other[40:39]});
  logic xor_3016;
  assign xor_3016 = bits[26] ^ (^{select_2968[25:24], other[25:24]});
  logic xor_3019;
  assign xor_3019 = bits[20] ^ (^{select_2968[19:18], other[19:18]});
  logic xor_3022;
  assign xor_3022 = bits[23] ^ (^{select_2968[22:21], other[22:21]});
  logic xor_3025;
  assign xor_3025 = xor_3016 ^ (^{select_2968[23:18], other[23:18]});
  logic xor_3028;
  assign xor_3028 = bits[35] ^ (^{select_2968[34:33], other[34:33]});
  logic xor_3031;
  assign xor_3031 = bits[29] ^ (^{select_2968[28:27], other[28:27]});
  logic xor_3034;
  assign xor_3034 = bits[32] ^ (^{select_2968[31:30], other[31:30]});
  logic xor_3037;
  assign xor_3037 = xor_3028 ^ (^{select_2968[32:27], other[32:27]});
  logic xor_3038;
  assign xor_3038 = xor_3025 ^ xor_3037;
  // hls/stages/count_bits.hpp:25
  logic or_3046;
  assign or_3046 = (xor_2977 & xor_2980) | (xor_2974 & (xor_2977 | xor_2980));
  logic or_3050;
  assign or_3050 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3054;
  assign or_3054 = (xor_2992 & xor_2995) | (xor_2989 & (xor_2992 | xor_2995));
  // hls/stages/count_bits.hpp:23
  logic or_3061;
  assign or_3061 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3065;
  assign or_3065 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3069;
  assign or_3069 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3072;
  assign parity_3072 = ^{or_3069, or_3065, or_3061};
  // hls/stages/count_bits.hpp:23
  logic or_3076;
  assign or_3076 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3080;
  assign or_3080 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3084;
  assign or_3084 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3087;
  assign parity_3087 = ^{or_3084, or_3080, or_3076};
  logic parity_3090;
  assign parity_3090 = ^{or_3084, or_3080, or_3076, or_3069, or_3065, or_3061, or_3054, or_3050, or_3046};
  // hls/stages/count_bits.hpp:23
  logic or_3094;
  assign or_3094 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3098;
  assign or_3098 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3102;
  assign or_3102 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3110;
  assign or_3110 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3114;
  assign or_3114 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3118;
  assign or_3118 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3121;
  assign parity_3121 = ^{or_3118, or_3114, or_3110};
  // hls/stages/count_bits.hpp:23
  logic or_3125;
  assign or_3125 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3129;
  assign or_3129 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3133;
  assign or_3133 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3136;
  assign parity_3136 = ^{or_3133, or_3129, or_3125};
  logic parity_3139;
  assign parity_3139 = ^{or_3133, or_3129, or_3125, or_3118, or_3114, or_3110, or_3102, or_3098, or_3094};
  // hls/stages/count_bits.hpp:25
  logic or_3143;
  assign or_3143 = (xor_3007 & xor_3010) | (xor_3004 & (xor_3007 | xor_3010));
  logic or_3147;
  assign or_3147 = (xor_3019 & xor_3022) | (xor_3016 & (xor_3019 | xor_3022));
  logic or_3151;
  assign or_3151 = (xor_3031 & xor_3034) | (xor_3028 & (xor_3031 | xor_3034));
  // hls/stages/count_bits.hpp:24
  logic parity_3154;
  assign parity_3154 = ^{or_3151, or_3147, or_3143};
  // hls/stages/count_bits.hpp:25
  logic and_3155;
  assign and_3155 = xor_3001 & (^{xor_3038, select_2968[44:36], other[44:36]});
  logic or_3159;
  assign or_3159 = (xor_2986 & xor_2998) | (xor_2983 & (xor_2986 | xor_2998));
  logic and_3162;
  assign and_3162 = (xor_3004 ^ (^{select_2968[41:36], other[41:36]})) & (xor_3025 | xor_3037);
  logic or_3163;
  assign or_3163 = (xor_3025 & xor_3037) | and_3162;
  // hls/stages/count_bits.hpp:24
  logic parity_3166;
  assign parity_3166 = ^{or_3163, or_3159, and_3155};
  logic parity_3169;
  assign parity_3169 = ^{or_3163, or_3159, and_3155, or_3151, or_3147, or_3143, or_3133, or_3129, or_3125, or_3118, or_3114, or_3110, or_3102, or_3098, or_3094};
  logic parity_3171;
  assign parity_3171 = ^{or_3163, or_3159, and_3155, or_3151, or_3147, or_3143, or_3133, or_3129, or_3125, or_3118, or_3114, or_3110, or_3102, or_3098, or_3094, or_3084, or_3080, or_3076, or_3069, or_3065, or_3061, or_3054, or_3050, or_3046};
  // hls/stages/count_bits.hpp:25
  logic and_3172;
  assign and_3172 = parity_3090 & parity_3169;
  logic or_3176;
  assign or_3176 = (parity_3072 & parity_3087) | ((^{or_3054, or_3050, or_3046}) & (parity_3072 | parity_3087));
  logic or_3180;
  assign or_3180 = (parity_3154 & parity_3166) | (parity_3139 & (parity_3154 | parity_3166));
  logic or_3187;
  assign or_3187 = (parity_3121 & parity_3136) | ((^{or_3102, or_3098, or_3094}) & (parity_3121 | parity_3136));
  logic or_3191;
  assign or_3191 = (or_3147 & or_3151) | (or_3143 & (or_3147 | or_3151));
  logic or_3195;
  assign or_3195 = (or_3159 & or_3163) | (and_3155 & (or_3159 | or_3163));
  // hls/stages/count_bits.hpp:23
  logic or_3202;
  assign or_3202 = (or_3098 & or_3102) | (or_3094 & (or_3098 | or_3102));
  // hls/stages/count_bits.hpp:25
  logic or_3206;
  assign or_3206 = (or_3114 & or_3118) | (or_3110 & (or_3114 | or_3118));
  logic or_3210;
  assign or_3210 = (or_3129 & or_3133) | (or_3125 & (or_3129 | or_3133));
  // hls/stages/count_bits.hpp:24
  logic parity_3213;
  assign parity_3213 = ^{or_3210, or_3206, or_3202};
  // hls/stages/count_bits.hpp:23
  logic or_3217;
  assign or_3217 = (or_3050 & or_3054) | (or_3046 & (or_3050 | or_3054));
  // hls/stages/count_bits.hpp:25
  logic or_3221;
  assign or_3221 = (or_3065 & or_3069) | (or_3061 & (or_3065 | or_3069));
  logic or_3225;
  assign or_3225 = (or_3080 & or_3084) | (or_3076 & (or_3080 | or_3084));
  // hls/stages/count_bits.hpp:24
  logic parity_3228;
  assign parity_3228 = ^{or_3225, or_3221, or_3217};
  logic parity_3231;
  assign parity_3231 = ^{or_3225, or_3221, or_3217, or_3210, or_3206, or_3202, or_3195, or_3191, or_3187};
  logic parity_3233;
  assign parity_3233 = ^{or_3225, or_3221, or_3217, or_3210, or_3206, or_3202, or_3195, or_3191, or_3187, or_3180, or_3176, and_3172};
  // hls/stages/count_bits.hpp:25
  logic or_3237;
  assign or_3237 = (or_3191 & or_3195) | (or_3187 & (or_3191 | or_3195));
  logic or_3241;
  assign or_3241 = (or_3206 & or_3210) | (or_3202 & (or_3206 | or_3210));
  logic or_3245;
  assign or_3245 = (or_3221 & or_3225) | (or_3217 & (or_3221 | or_3225));
  // hls/stages/count_bits.hpp:24
  logic parity_3248;
  assign parity_3248 = ^{or_3245, or_3241, or_3237};
  // hls/stages/count_bits.hpp:25
  logic and_3249;
  assign and_3249 = (^{or_3180, or_3176, and_3172}) & parity_3231;
  logic or_3253;
  assign or_3253 = (or_3176 & or_3180) | (and_3172 & (or_3176 | or_3180));
  logic or_3257;
  assign or_3257 = (parity_3213 & parity_3228) | ((^{or_3195, or_3191, or_3187}) & (parity_3213 | parity_3228));
  // hls/stages/count_bits.hpp:24
  logic parity_3260;
  assign parity_3260 = ^{or_3257, or_3253, and_3249};
  // hls/stages/count_bits.hpp:25
  logic and_3262;
  assign and_3262 = parity_3248 & parity_3260;
  logic or_3266;
  assign or_3266 = (or_3241 & or_3245) | (or_3237 & (or_3241 | or_3245));
  logic or_3270;
  assign or_3270 = (or_3253 & or_3257) | (and_3249 & (or_3253 | or_3257));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3315;
  assign select_3315 = equal_1700_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3318;
  assign select_3318 = equal_1698_s2_q ? patches_summed_first_q : (equal_1700_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:551
  logic [9:0] select_3325;
  assign select_3325 = less_1861_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3328;
  assign select_3328 = equal_1864_s2_q ? (less_1861_s2_q ? (equal_1864_s2_q ? 10'h0 : select_3325) : 10'h0) : select_3325;
  logic [9:0] select_3330;
  assign select_3330 = less_1861_s2_q ? (equal_1862_s2_q ? 10'h0 : select_3328) : select_3328;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3332;
  assign select_3332 = less_1861_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3335;
  assign select_3335 = equal_1864_s2_q ? (less_1861_s2_q ? (equal_1864_s2_q ? 5'h0 : select_3332) : 5'h0) : select_3332;
  logic [4:0] select_3337;
  assign select_3337 = less_1861_s2_q ? (equal_1862_s2_q ? 5'h0 : select_3335) : select_3335;
  // hls/stages/patches.hpp:551
  logic [4:0] select_3339;
  assign select_3339 = less_1861_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:555
  logic [4:0] select_3342;
  assign select_3342 = equal_1864_s2_q ? (less_1861_s2_q ? (equal_1864_s2_q ? 5'h0 : select_3339) : 5'h0) : select_3339;
  logic [4:0] select_3344;
  assign select_3344 = less_1861_s2_q ? (equal_1862_s2_q ? 5'h0 : select_3342) : select_3342;
  // hls/stages/patches.hpp:551
  logic and_3347;
  assign and_3347 = less_1861_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:555
  logic select_3350;
  assign select_3350 = equal_1864_s2_q ? (less_1861_s2_q ? (not_1865_s2_q & and_3347) : and_3347) : and_3347;
  // hls/stages/patches.hpp:184
  logic select_3353;
  assign select_3353 = equal_1698_s2_q ? (less_1861_s2_q ? (not_1863_s2_q & select_3350) : select_3350) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3364;
  assign or_3364 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3365;
  assign and_3365 = patches_read_searches_s2_q & or_3364;
  // hls/stages/patches.hpp:535
  logic [4:0] select_3366;
  assign select_3366 = and_3365 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:542
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3366};
  // hls/stages/patches.hpp:551
  logic and_3370;
  assign and_3370 = less_1861_s2_q & (equal_3362_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:555
  logic select_3373;
  assign select_3373 = equal_1864_s2_q ? (less_1861_s2_q ? (not_1865_s2_q & and_3370) : and_3370) : and_3370;
  // hls/stages/patches.hpp:184
  logic select_3376;
  assign select_3376 = equal_1698_s2_q ? (less_1861_s2_q ? (not_1863_s2_q & select_3373) : select_3373) : patches_read_above_q;
  // hls/stages/patches.hpp:551
  logic and_3379;
  assign and_3379 = less_1861_s2_q & (equal_3362_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:555
  logic select_3382;
  assign select_3382 = equal_1864_s2_q ? (less_1861_s2_q ? (not_1865_s2_q & and_3379) : and_3379) : and_3379;
  // hls/stages/patches.hpp:184
  logic select_3385;
  assign select_3385 = equal_1698_s2_q ? (less_1861_s2_q ? (not_1863_s2_q & select_3382) : select_3382) : patches_read_below_q;
  // hls/stages/patches.hpp:548
  logic [6:0] sum_3386;
  assign sum_3386 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:549
  logic [9:0] select_3389;
  assign select_3389 = (equal_3362_s2_q & ({sum_3386[6], sum_3386} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:551
  logic [9:0] select_3390;
  assign select_3390 = less_1861_s2_q ? select_3389 : 10'h3ff;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3392;
  assign select_3392 = less_1861_s2_q ? (equal_1864_s2_q ? 10'h3ff : select_3390) : 10'h3ff;
  // hls/stages/patches.hpp:555
  logic [9:0] select_3393;
  assign select_3393 = equal_1864_s2_q ? select_3392 : select_3390;
  logic [9:0] select_3395;
  assign select_3395 = less_1861_s2_q ? (equal_1862_s2_q ? 10'h3ff : select_3393) : select_3393;
  // hls/stages/patches.hpp:534
  logic [14:0] select_3397;
  assign select_3397 = and_3365 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_3398;
  assign select_3398 = equal_1698_s2_q ? select_3397[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_3399;
  assign select_3399 = equal_1698_s2_q ? select_3397[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:536
  logic [9:0] select_3401;
  assign select_3401 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_3403;
  assign select_3403 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_3406;
  assign select_3406 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_3407;
  assign select_3407 = patches_read_first_q ? patches_read_far_q : select_3406;
  // hls/stages/patches.hpp:589
  logic [9:0] difference_3410;
  assign difference_3410 = select_3407 - select_3397[9:0];
  // hls/stages/patches.hpp:574
  logic less_3440;
  assign less_3440 = select_3401 < select_3403;
  // hls/stages/patches.hpp:580
  logic [1:0] sum_3441;
  assign sum_3441 = select_3366[4:3] + 2'h3;
  // hls/stages/patches.hpp:575
  logic [9:0] high;
  assign high = less_3440 ? select_3403 : select_3401;
  logic [9:0] low;
  assign low = (select_3403 < select_3401) ? select_3403 : select_3401;
  // hls/stages/patches.hpp:576
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_3397[9:0];
  // hls/stages/patches.hpp:578
  logic not_3448;
  assign not_3448 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_3449;
  assign sum_3449 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_3451;
  assign not_3451 = ~({eight, 3'h0} < {1'b0, sum_3449, fall_2[0]});
  logic [1:0] sum_3452;
  assign sum_3452 = {1'b0, not_3448} + {1'b0, not_3451};
  // hls/stages/patches.hpp:579
  logic [10:0] sum_3453;
  assign sum_3453 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_3455;
  assign not_3455 = ~({eight, 3'h0} < {sum_3453, fall_2[1:0]});
  logic not_3458;
  assign not_3458 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_3459;
  assign sum_3459 = {1'b0, not_3455} + {1'b0, not_3458};
  // hls/stages/patches.hpp:578
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_3452} + {1'b0, sum_3459};
  // hls/stages/patches.hpp:581
  logic [7:0] select_3462;
  assign select_3462 = less_3440 ? ({sum_3441, select_3366[2:0], 3'h0} - {5'h0, fraction}) : {sum_3441, select_3366[2:0], fraction};
  // hls/stages/agreement.hpp:1120
  logic equal_3625;
  assign equal_3625 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:780
  logic select_3689;
  assign select_3689 = equal_1487_s2_q ? shown_shown_q : (so_s2_q ? select_1933 : shown_shown_q);
  logic select_3691;
  assign select_3691 = equal_1487_s2_q ? shown_nearer_q : (so_s2_q ? select_1936 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_3693;
  assign sum_3693 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:454
  logic [2:0] select_3695;
  assign select_3695 = less_3692_s2_q ? (sum_3693[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3697;
  assign select_3697 = equal_2309_s2_q ? (equal_583_s2_q ? 3'h0 : select_3695) : region_row_q;
  // hls/stages/agreement.hpp:780
  logic [7:0] select_3702;
  assign select_3702 = equal_1487_s2_q ? select_1887 : (so_s2_q ? (ends_cell_s2_q ? select_1986 : select_1887) : 8'h1);
  // hls/stages/agreement.hpp:454
  logic [8:0] select_3716;
  assign select_3716 = equal_583_s2_q ? {{2{difference_3714[6]}}, difference_3714} : (less_3692_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:514
  logic [8:0] select_3718;
  assign select_3718 = and_522_s2_q ? (equal_2309_s2_q ? select_3716 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:454
  logic [6:0] select_3720;
  assign select_3720 = equal_583_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:514
  logic [6:0] select_3722;
  assign select_3722 = and_522_s2_q ? (equal_2309_s2_q ? select_3720 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_3723;
  assign sum_3723 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_3724;
  assign select_3724 = sum_3693[7] ? {1'b1, sum_3693[6:0], region_down_rest_q[0]} : sum_3723;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_3693[7];
  // hls/stages/agreement.hpp:454
  logic select_3728;
  assign select_3728 = equal_2309_s2_q ? (equal_583_s2_q | (less_3692_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:203
  logic or_3733;
  assign or_3733 = segment_starts_q | not_1497;
  // hls/stages/agreement.hpp:1009
  logic select_3736;
  assign select_3736 = inside_v_s2_q ? (sum_1900_s2_q ? (equal_1691 & or_1902) : or_1902) : or_3733;
  // hls/stages/agreement.hpp:780
  logic select_3739;
  assign select_3739 = equal_1487_s2_q ? or_3733 : (so_s2_q ? (ends_cell_s2_q ? select_3736 : or_3733) : or_3733);
  logic select_3898;
  assign select_3898 = so_s2_q ? (ends_cell_s2_q ? and_1974 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3901;
  assign select_3901 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_3903;
  assign select_3903 = equal_1487_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_3901 : centres_values_0_of_skin_q);
  logic select_3904;
  assign select_3904 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3906;
  assign select_3906 = equal_1487_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_3904 : centres_values_1_textured_q);
  logic select_3907;
  assign select_3907 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3909;
  assign select_3909 = equal_1487_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_3907 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:454
  logic [10:0] select_3913;
  assign select_3913 = equal_2309_s2_q ? (equal_3910_s2_q ? 11'h0 : (map_row_q + {5'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:514
  logic [5:0] select_3916;
  assign select_3916 = and_522_s2_q ? (equal_2309_s2_q ? cfg_width_i[8:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1242
  logic xor_3917;
  assign xor_3917 = write_half_q ^ done_q;
  // hls/stages/agreement.hpp:431
  logic select_3919;
  assign select_3919 = and_1879_s2_q ? (left_first_s2_q ? xor_3917 : write_half_q) : write_half_q;
  // hls/stages/agreement.hpp:272
  logic select_3921;
  assign select_3921 = and_1879_s2_q ? (left_first_s2_q ? xor_3917 : select_3919) : write_half_q;
  logic select_3923;
  assign select_3923 = left_first_s2_q ? select_1939 : (and_1879_s2_q ? select_1940 : read_half_q);
  logic and_3927;
  assign and_3927 = (~drew_q) & (done_q | said_q);
  logic [9:0] select_3936;
  assign select_3936 = left_first_s2_q ? 10'h1 : (and_1879_s2_q ? select_1944 : rows_passed_q);
  logic [8:0] select_3939;
  assign select_3939 = left_first_s2_q ? {select_1942[7:0], or_1941} : (and_1879_s2_q ? {select_1942[7:0], or_1941} : columns_passed_q);
  logic select_3942;
  assign select_3942 = left_first_s2_q ? marks_last_s2_q : (and_1879_s2_q ? marks_last_s2_q : line_ended_q);
  logic select_3945;
  assign select_3945 = left_first_s2_q ? and_1958 : (and_1879_s2_q ? and_1958 : began_q);
  logic [2:0] select_3948;
  assign select_3948 = left_first_s2_q ? select_1960 : (and_1879_s2_q ? select_1960 : seen_x_q);
  // hls/stages/agreement.hpp:1271
  logic [2:0] select_3953;
  assign select_3953 = left_first_s2_q ? 3'h0 : (and_1945 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q);
  // hls/stages/agreement.hpp:272
  logic [2:0] select_3955;
  assign select_3955 = left_first_s2_q ? 3'h0 : (and_1879_s2_q ? select_3953 : seen_y_q);
  logic [7:0] select_3958;
  assign select_3958 = left_first_s2_q ? select_1953 : (and_1879_s2_q ? select_1953 : seen_column_q);
  // hls/stages/agreement.hpp:429
  logic [7:0] select_3964;
  assign select_3964 = left_first_s2_q ? select_3962 : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:272
  logic [7:0] select_3966;
  assign select_3966 = left_first_s2_q ? select_3962 : (and_1879_s2_q ? select_3964 : seen_rows_left_q);
  // hls/stages/agreement.hpp:429
  logic and_3971;
  assign and_3971 = (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
  // hls/stages/agreement.hpp:272
  logic select_3973;
  assign select_3973 = left_first_s2_q ? and_3971 : (and_1879_s2_q ? and_3971 : at_cell_end_q);
  logic select_3976;
  assign select_3976 = left_first_s2_q ? next_row : (and_1879_s2_q ? next_row : was_next_row_q);
  logic [10:0] select_3979;
  assign select_3979 = left_first_s2_q ? 11'h0 : (and_1879_s2_q ? select_1950 : seen_base_q);
  // hls/stages/registration.hpp:258
  logic not_4050;
  assign not_4050 = ~quarter[1];
  logic [3:0] select_4051;
  assign select_4051 = quarter[0] ? {quarter[1], 1'b0, not_4050, 1'b0} : {1'b0, quarter[1], 1'b0, not_4050};

  // Memory registration_sums, 12 x 32, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [31:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 32'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1535;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_1578;
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
  assign patches_choices_raddr = select_1612;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_1614));
  logic [21:0] patches_choices_rdata_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_rdata_q <= patches_choices_mem[patches_choices_raddr];
  end

  // Memory regions, 64 x 30, DISTANCE 12, hls/stages/agreement.hpp:1364; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [29:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 30'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_1897;
  logic regions_re;
  assign regions_re = s2_en & (equal_1487_s2_q ? (x_s2_q[6] & not_1898) : and_1905);
  logic [29:0] regions_rdata_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_rdata_q <= regions_mem[regions_raddr];
  end

  // Memory map, 3290 x 2, DISTANCE 16, hls/stages/agreement.hpp:1375; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [1:0] map_mem [0:3289];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 3290; i++) map_mem[i] = 2'h0;
`endif
  logic [11:0] map_raddr;
  assign map_raddr = sum_1955;
  logic map_re;
  assign map_re = s2_en & select_1967;
  logic [1:0] map_rdata_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_rdata_q <= map_mem[map_raddr];
  end

  // Memory averager_memory, write
  logic [7:0] averager_memory_waddr;
  assign averager_memory_waddr = select_492_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_497_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (averager_memory_we) averager_memory_mem[averager_memory_waddr] <= {and_516, and_512, sum_508, sum_504};
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
  assign census_memory_we = s2_en & and_522_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (census_memory_we) census_memory_mem[census_memory_waddr] <= {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_540, whole_2, select_532, select_528};
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

  // Memory best_left, write
  logic [5:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q[5:0];
  logic best_left_we;
  assign best_left_we = s2_en & and_1469_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_left_we) best_left_mem[best_left_waddr] <= {select_1468, select_1465, select_1462, select_1460, select_1442, select_1439, select_1431, select_1430, select_1425};
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
  assign best_right_we = s2_en & and_1469_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (best_right_we) best_right_mem[best_right_waddr] <= {select_1486, select_1485, select_1482, select_1481};
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
  assign shown_right_waddr = select_1496_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_1527;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (shown_right_we) shown_right_mem[shown_right_waddr] <= {and_1522, not_1497};
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

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_1812, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_1846_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {less_1832_s2_q, less_1831_s2_q, less_1822_s2_q, less_1821_s2_q, patches_codes_at_q[51:28]};
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
  assign patches_left_codes_waddr = {sum_1850, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_1860_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_codes_we) patches_left_codes_mem[patches_left_codes_waddr] <= {less_1832_s2_q, less_1831_s2_q, less_1822_s2_q, less_1821_s2_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_we = s2_en & and_1492_s2_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (seen_columns_we) seen_columns_mem[seen_columns_waddr] <= {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_1932, textured};
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
      rows_passed_above_q <= 5'h0;
      chosen_score_q <= 8'h0;
      chosen_near_q <= 7'h0;
      chosen_place_q <= 3'h0;
      before_0_q <= 8'h0;
      before_1_q <= 8'h0;
      before_2_q <= 8'h0;
      shift_allowed_q <= 1'b0;
      shift_not_right_q <= 1'b0;
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
      averager_running_of_skin_q <= select_2098;
      averager_mask_q <= select_2100;
      averager_of_skin_q <= select_2102;
      census_filled_q <= and_522_s2_q ? {select_586[2:0], 1'b1} : census_filled_q;
      rows_passed_above_q <= and_522_s2_q ? select_585 : rows_passed_above_q;
      chosen_score_q <= less_2419 ? select_1419 : select_2418;
      chosen_near_q <= (select_2421 < select_1454) ? select_1454 : select_2421;
      chosen_place_q <= less_2419 ? {select_1427, not_1426} : 3'h2;
      before_0_q <= select_2418;
      before_1_q <= sum_1169;
      before_2_q <= sum_1417;
      shift_allowed_q <= not_2426 & (~less_2427);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      registration_displacement_over_q <= so_s2_q ? sum_2560[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2562;
      registration_slope_here_q <= select_2564;
      registration_expected_q <= select_2566;
      registration_of_right_q <= equal_1487_s2_q ? registration_of_right_q : select_2628;
      registration_was_inside_q <= equal_1487_s2_q ? registration_was_inside_q : select_2631;
      registration_fresh_q <= select_2640;
      patches_chance_q <= and_522_s2_q ? select_2797 : patches_chance_q;
      patches_fixed_q <= and_2811;
      patches_choice_valid_q <= and_1696 ? (select_1690[0] & not_2799) : select_1690[0];
      patches_choice_column_q <= select_1690[7:1];
      patches_choice_shift_q <= select_1690[13:8];
      patches_choice_slope_q <= select_1690[21:14];
      patches_band_q <= sample_pair_whole_s2_q ? select_1711 : patches_band_q;
      patches_fetch_q <= select_2826;
      patches_codes_at_q <= select_2927;
      patches_codes_further_q <= equal_1698_s2_q ? patches_codes_further_q : select_2932;
      patches_next_codes_q <= select_2940;
      patches_set_q <= equal_1698_s2_q ? 3'h0 : (equal_1700_s2_q ? 3'h0 : select_2954);
      patches_size_q <= sum_2958;
      patches_left_row_q <= select_2970;
      patches_summed_row_column_q <= equal_1698_s2_q ? patches_summed_row_column_q : select_3315;
      patches_summed_first_q <= select_3318;
      patches_read_row_differing_q <= equal_1698_s2_q ? select_3330 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_1698_s2_q ? select_3337 : patches_read_row_column_q;
      patches_read_at_q <= equal_1698_s2_q ? select_3344 : patches_read_at_q;
      patches_read_first_q <= select_3353;
      patches_read_above_q <= select_3376;
      patches_read_below_q <= select_3385;
      patches_read_far_q <= equal_1698_s2_q ? select_3395 : patches_read_far_q;
      patches_peak_best_differing_q <= select_3398;
      patches_peak_best_column_q <= select_3399;
      patches_peak_row_q <= equal_1698_s2_q ? select_3366 : patches_peak_row_q;
      patches_peak_above_q <= equal_1698_s2_q ? select_3401 : patches_peak_above_q;
      patches_peak_below_q <= equal_1698_s2_q ? select_3403 : patches_peak_below_q;
      patches_peak_far_q <= equal_1698_s2_q ? select_3407 : patches_peak_far_q;
      shown_shown_q <= select_3689;
      shown_nearer_q <= select_3691;
      region_row_q <= and_522_s2_q ? select_3697 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_3702;
      region_down_rest_q <= select_3718;
      region_down_back_q <= select_3722;
      region_down_next_q <= select_3724;
      region_fresh_q <= and_522_s2_q ? select_3728 : region_fresh_q;
      segment_starts_q <= select_3739;
      centres_values_0_textured_q <= equal_1487_s2_q ? centres_values_0_textured_q : select_3898;
      centres_values_0_of_skin_q <= select_3903;
      centres_values_1_textured_q <= select_3906;
      centres_values_1_of_skin_q <= select_3909;
      map_row_q <= and_522_s2_q ? select_3913 : map_row_q;
      map_width_q <= select_3916;
      write_half_q <= select_3921;
      read_half_q <= and_1879_s2_q ? select_3923 : read_half_q;
      done_q <= and_1879_s2_q ? (not_1956 & and_3927) : and_3927;
      drew_q <= so_s2_q;
      said_q <= equal_1487_s2_q & equal_3625;
      rows_passed_q <= and_1879_s2_q ? select_3936 : rows_passed_q;
      columns_passed_q <= and_1879_s2_q ? select_3939 : columns_passed_q;
      line_ended_q <= and_1879_s2_q ? select_3942 : line_ended_q;
      began_q <= and_1879_s2_q ? select_3945 : began_q;
      seen_x_q <= and_1879_s2_q ? select_3948 : seen_x_q;
      seen_y_q <= and_1879_s2_q ? select_3955 : seen_y_q;
      seen_column_q <= and_1879_s2_q ? select_3958 : seen_column_q;
      seen_rows_left_q <= and_1879_s2_q ? select_3966 : seen_rows_left_q;
      at_cell_end_q <= and_1879_s2_q ? select_3973 : at_cell_end_q;
      was_next_row_q <= and_1879_s2_q ? select_3976 : was_next_row_q;
      seen_base_q <= and_1879_s2_q ? select_3979 : seen_base_q;
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
      left_pixel_q <= and_1879_s2_q ? left_pixel_q : pixel_0_s2_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_500 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_506 : averager_running_1_q;
      averager_total_0_q <= select_2077;
      averager_total_1_q <= select_2079;
      census_columns_values_0_cell_0_left_q <= select_2103;
      census_columns_values_0_cell_0_right_q <= select_2104;
      census_columns_values_0_cell_0_mask_q <= and_522_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2106;
      census_columns_values_0_cell_1_right_q <= select_2107;
      census_columns_values_0_cell_1_mask_q <= select_2108;
      census_columns_values_0_cell_2_left_q <= select_2109;
      census_columns_values_0_cell_2_right_q <= select_2110;
      census_columns_values_0_cell_2_mask_q <= select_2111;
      census_columns_values_0_cell_2_of_skin_q <= select_2112;
      census_columns_values_0_cell_3_left_q <= select_2113;
      census_columns_values_0_cell_3_right_q <= select_2114;
      census_columns_values_0_cell_3_mask_q <= select_2115;
      census_columns_values_0_cell_4_left_q <= select_2116;
      census_columns_values_0_cell_4_right_q <= select_2117;
      census_columns_values_0_cell_4_mask_q <= select_2118;
      census_columns_values_1_cell_0_left_q <= select_2119;
      census_columns_values_1_cell_0_right_q <= select_2120;
      census_columns_values_1_cell_0_mask_q <= select_2121;
      census_columns_values_1_cell_1_left_q <= select_2122;
      census_columns_values_1_cell_1_right_q <= select_2123;
      census_columns_values_1_cell_1_mask_q <= select_2124;
      census_columns_values_1_cell_2_left_q <= select_2125;
      census_columns_values_1_cell_2_right_q <= select_2126;
      census_columns_values_1_cell_2_mask_q <= select_2127;
      census_columns_values_1_cell_2_of_skin_q <= select_2128;
      census_columns_values_1_cell_3_left_q <= select_2129;
      census_columns_values_1_cell_3_right_q <= select_2130;
      census_columns_values_1_cell_3_mask_q <= select_2131;
      census_columns_values_1_cell_4_left_q <= select_2132;
      census_columns_values_1_cell_4_right_q <= select_2133;
      census_columns_values_1_cell_4_mask_q <= select_2134;
      census_columns_values_2_cell_0_left_q <= select_2135;
      census_columns_values_2_cell_0_right_q <= select_2136;
      census_columns_values_2_cell_0_mask_q <= select_2137;
      census_columns_values_2_cell_1_left_q <= select_2138;
      census_columns_values_2_cell_1_right_q <= select_2139;
      census_columns_values_2_cell_1_mask_q <= select_2140;
      census_columns_values_2_cell_2_left_q <= select_2141;
      census_columns_values_2_cell_2_right_q <= select_2142;
      census_columns_values_2_cell_2_mask_q <= select_2143;
      census_columns_values_2_cell_3_left_q <= select_2144;
      census_columns_values_2_cell_3_right_q <= select_2145;
      census_columns_values_2_cell_3_mask_q <= select_2146;
      census_columns_values_2_cell_4_left_q <= select_2147;
      census_columns_values_2_cell_4_right_q <= select_2148;
      census_columns_values_2_cell_4_mask_q <= select_2149;
      census_columns_values_3_cell_0_mask_q <= select_2150;
      census_columns_values_3_cell_1_left_q <= select_2151;
      census_columns_values_3_cell_1_right_q <= select_2152;
      census_columns_values_3_cell_1_mask_q <= select_2153;
      census_columns_values_3_cell_2_mask_q <= select_2154;
      census_columns_values_3_cell_3_left_q <= select_2155;
      census_columns_values_3_cell_3_right_q <= select_2156;
      census_columns_values_3_cell_3_mask_q <= select_2157;
      census_columns_values_3_cell_4_mask_q <= select_2158;
      sharpness_last_mean_0_q <= and_522_s2_q ? select_528 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_522_s2_q ? select_532 : sharpness_last_mean_1_q;
      middle_sum_columns_values_0_q <= slot_s2_q[0] ? middle_sum_columns_values_0_q : column_2_s2_q;
      middle_sum_columns_values_1_q <= select_2409;
      middle_sum_columns_values_2_q <= select_2410;
      middle_sum_columns_values_3_q <= select_2411;
      middle_sum_columns_values_4_q <= select_2412;
      middle_sum_columns_values_5_q <= select_2413;
      middle_sum_columns_values_6_q <= select_2414;
      middle_sum_sum_sums_values_0_q <= slot_s2_q[0] ? middle_sum_sum_sums_values_0_q : sum_919;
      sums_0_sum_sums_values_0_q <= sum_1169;
      sums_0_sum_sums_values_1_q <= equal_1167 ? 8'h0 : sums_0_sum_sums_values_0_q;
      sums_1_sum_sums_values_0_q <= sum_1417;
      sums_1_sum_sums_values_1_q <= equal_1167 ? 8'h0 : sums_1_sum_sums_values_0_q;
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
  logic [2:0] region_row_s3_q;
  logic region_fresh_s3_q;
  logic centres_values_1_textured_s3_q;
  logic centres_values_1_of_skin_s3_q;
  logic done_s3_q;
  logic [2:0] select_486_s3_q;
  logic [5:0] select_488_s3_q;
  logic [5:0] column_s3_q;
  logic and_520_s3_q;
  logic and_522_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_525_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic less_556_s3_q;
  logic less_557_s3_q;
  logic less_558_s3_q;
  logic less_559_s3_q;
  logic less_560_s3_q;
  logic less_561_s3_q;
  logic less_562_s3_q;
  logic less_563_s3_q;
  logic less_564_s3_q;
  logic less_565_s3_q;
  logic less_566_s3_q;
  logic less_567_s3_q;
  logic less_568_s3_q;
  logic less_569_s3_q;
  logic less_570_s3_q;
  logic less_571_s3_q;
  logic less_572_s3_q;
  logic less_573_s3_q;
  logic less_574_s3_q;
  logic less_575_s3_q;
  logic less_576_s3_q;
  logic less_577_s3_q;
  logic less_578_s3_q;
  logic less_579_s3_q;
  logic and_587_s3_q;
  logic and_612_s3_q;
  logic and_613_s3_q;
  logic [11:0] sum_628_s3_q;
  logic [9:0] sum_631_s3_q;
  logic equal_1487_s3_q;
  logic not_1488_s3_q;
  logic equal_1528_s3_q;
  logic all_s3_q;
  logic [1:0] sum_1534_s3_q;
  logic equal_1536_s3_q;
  logic equal_1538_s3_q;
  logic equal_1540_s3_q;
  logic equal_1542_s3_q;
  logic equal_1544_s3_q;
  logic equal_1546_s3_q;
  logic equal_1548_s3_q;
  logic equal_1550_s3_q;
  logic less_1559_s3_q;
  logic or_1563_s3_q;
  logic equal_1583_s3_q;
  logic and_1593_s3_q;
  logic and_1596_s3_q;
  logic select_1613_s3_q;
  logic equal_1614_s3_q;
  logic and_1622_s3_q;
  logic equal_1624_s3_q;
  logic equal_1652_s3_q;
  logic select_1690_s3_q;
  logic and_1697_s3_q;
  logic equal_1698_s3_q;
  logic equal_1700_s3_q;
  logic and_1713_s3_q;
  logic [4:0] select_1728_s3_q;
  logic select_1734_s3_q;
  logic [3:0] select_1775_s3_q;
  logic less_1861_s3_q;
  logic equal_1862_s3_q;
  logic not_1863_s3_q;
  logic equal_1864_s3_q;
  logic and_1879_s3_q;
  logic select_1881_s3_q;
  logic and_1884_s3_q;
  logic or_1890_s3_q;
  logic or_1893_s3_q;
  logic or_1896_s3_q;
  logic not_1898_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_1925_s3_q;
  logic and_1930_s3_q;
  logic and_1962_s3_q;
  logic less_1963_s3_q;
  logic [11:0] sum_1971_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_1989_s3_q;
  logic or_1992_s3_q;
  logic or_1995_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2045_s3_q;
  logic [11:0] sum_2174_s3_q;
  logic [9:0] sum_2177_s3_q;
  logic equal_2185_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_2434_s3_q;
  logic and_2440_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_2502_s3_q;
  logic and_2536_s3_q;
  logic and_2570_s3_q;
  logic and_2571_s3_q;
  logic [7:0] residual_s3_q;
  logic and_2607_s3_q;
  logic and_2621_s3_q;
  logic equal_2664_s3_q;
  logic parity_3042_s3_q;
  logic parity_3171_s3_q;
  logic parity_3233_s3_q;
  logic xor_3261_s3_q;
  logic parity_3273_s3_q;
  logic or_3277_s3_q;
  logic equal_3278_s3_q;
  logic [4:0] select_3397_s3_q;
  logic equal_3409_s3_q;
  logic less_3411_s3_q;
  logic less_3412_s3_q;
  logic or_3417_s3_q;
  logic [7:0] select_3462_s3_q;
  logic equal_3625_s3_q;
  logic and_3982_s3_q;
  logic equal_4053_s3_q;
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
      region_row_s3_q <= region_row_q;
      region_fresh_s3_q <= region_fresh_q;
      centres_values_1_textured_s3_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s3_q <= centres_values_1_of_skin_q;
      done_s3_q <= done_q;
      select_486_s3_q <= select_486_s2_q;
      select_488_s3_q <= select_488_s2_q;
      column_s3_q <= column_s2_q;
      and_520_s3_q <= and_520_s2_q;
      and_522_s3_q <= and_522_s2_q;
      grey_s3_q <= grey;
      equal_525_s3_q <= equal_525;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      less_556_s3_q <= less_556;
      less_557_s3_q <= less_557;
      less_558_s3_q <= less_558;
      less_559_s3_q <= less_559;
      less_560_s3_q <= less_560;
      less_561_s3_q <= less_561;
      less_562_s3_q <= less_562;
      less_563_s3_q <= less_563;
      less_564_s3_q <= less_564;
      less_565_s3_q <= less_565;
      less_566_s3_q <= less_566;
      less_567_s3_q <= less_567;
      less_568_s3_q <= less_568;
      less_569_s3_q <= less_569;
      less_570_s3_q <= less_570;
      less_571_s3_q <= less_571;
      less_572_s3_q <= less_572;
      less_573_s3_q <= less_573;
      less_574_s3_q <= less_574;
      less_575_s3_q <= less_575;
      less_576_s3_q <= less_576;
      less_577_s3_q <= less_577;
      less_578_s3_q <= less_578;
      less_579_s3_q <= less_579;
      and_587_s3_q <= and_587;
      and_612_s3_q <= whole_22 & and_587;
      and_613_s3_q <= census_columns_values_1_cell_2_mask_q & and_587;
      sum_628_s3_q <= {1'b0, sum_624} + {2'h0, sum_627};
      sum_631_s3_q <= {9'h0, difference_629[9]} + {1'b0, xor_630};
      equal_1487_s3_q <= equal_1487_s2_q;
      not_1488_s3_q <= not_1488_s2_q;
      equal_1528_s3_q <= equal_1528;
      all_s3_q <= all;
      sum_1534_s3_q <= sum_1534;
      equal_1536_s3_q <= equal_1536;
      equal_1538_s3_q <= equal_1538;
      equal_1540_s3_q <= equal_1540;
      equal_1542_s3_q <= equal_1542;
      equal_1544_s3_q <= equal_1544;
      equal_1546_s3_q <= equal_1546;
      equal_1548_s3_q <= equal_1548;
      equal_1550_s3_q <= equal_1550;
      less_1559_s3_q <= less_1559;
      or_1563_s3_q <= or_1563;
      equal_1583_s3_q <= (registration_fresh_q & select_1581) == 4'h0;
      and_1593_s3_q <= not_1488_s2_q & and_1577;
      and_1596_s3_q <= and_1596_s2_q;
      select_1613_s3_q <= select_1613[1];
      equal_1614_s3_q <= equal_1614;
      and_1622_s3_q <= and_1622;
      equal_1624_s3_q <= equal_1624;
      equal_1652_s3_q <= equal_1652;
      select_1690_s3_q <= select_1690[0];
      and_1697_s3_q <= and_1697;
      equal_1698_s3_q <= equal_1698_s2_q;
      equal_1700_s3_q <= equal_1700_s2_q;
      and_1713_s3_q <= and_1697 & equal_1712;
      select_1728_s3_q <= select_1728_s2_q;
      select_1734_s3_q <= select_1734_s2_q;
      select_1775_s3_q <= select_1775_s2_q;
      less_1861_s3_q <= less_1861_s2_q;
      equal_1862_s3_q <= equal_1862_s2_q;
      not_1863_s3_q <= not_1863_s2_q;
      equal_1864_s3_q <= equal_1864_s2_q;
      and_1879_s3_q <= and_1879_s2_q;
      select_1881_s3_q <= select_1881_s2_q;
      and_1884_s3_q <= and_1884_s2_q;
      or_1890_s3_q <= or_1890;
      or_1893_s3_q <= or_1893;
      or_1896_s3_q <= or_1896;
      not_1898_s3_q <= not_1898;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_1925_s3_q <= inside_v_s2_q & (and_1923 & and_1521);
      and_1930_s3_q <= not_1488_s2_q & and_1905;
      and_1962_s3_q <= and_1962;
      less_1963_s3_q <= less_1963;
      sum_1971_s3_q <= sum_1971;
      textured_2_s3_q <= textured_2;
      or_1989_s3_q <= or_1989;
      or_1992_s3_q <= select_1986[7] | (~({select_1986[6], select_1986[3:2]} == 3'h0));
      or_1995_s3_q <= select_1986[7] | (~(select_1986[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2045_s3_q <= and_2045;
      sum_2174_s3_q <= {1'b0, sum_2170} + {2'h0, sum_2173};
      sum_2177_s3_q <= {9'h0, difference_2175[9]} + {1'b0, xor_2176};
      equal_2185_s3_q <= equal_2185_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_2434_s3_q <= and_2434;
      and_2440_s3_q <= and_2440;
      explained_2_s3_q <= explained_2;
      and_2502_s3_q <= not_1488_s2_q & and_2501;
      and_2536_s3_q <= not_1488_s2_q & and_2535;
      and_2570_s3_q <= not_1488_s2_q & (so_s2_q & (half_ends & equal_2567));
      and_2571_s3_q <= and_2571;
      residual_s3_q <= residual[7:0];
      and_2607_s3_q <= and_2607;
      and_2621_s3_q <= and_2571 & less_2620;
      equal_2664_s3_q <= (registration_fresh_q & select_2662) == 4'h0;
      parity_3042_s3_q <= ^{xor_3038, xor_3001, select_2968[44:36], other[44:36]};
      parity_3171_s3_q <= parity_3171;
      parity_3233_s3_q <= parity_3233;
      xor_3261_s3_q <= parity_3248 ^ parity_3260;
      parity_3273_s3_q <= ^{or_3270, or_3266, and_3262};
      or_3277_s3_q <= (or_3266 & or_3270) | (and_3262 & (or_3266 | or_3270));
      equal_3278_s3_q <= equal_3278_s2_q;
      select_3397_s3_q <= select_3397[14:10];
      equal_3409_s3_q <= select_3366[3:0] == 4'h0;
      less_3411_s3_q <= {difference_3410, 3'h0} < {3'h0, sum_2958};
      less_3412_s3_q <= select_3407 < select_3397[9:0];
      or_3417_s3_q <= (sum_2958 < 10'h39) | ({1'b0, sum_2958[9:1]} < select_3397[9:0]);
      select_3462_s3_q <= select_3462;
      equal_3625_s3_q <= equal_3625;
      and_3982_s3_q <= and_2045 & (sum_1971 == sum_1955);
      equal_4053_s3_q <= (registration_fresh_q & select_4051) == 4'h0;
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
  logic patches_frame_ended_q;
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
  // hls/stages/census.hpp:270
  logic [11:0] texture;
  assign texture = sum_628_s3_q + {2'h0, sum_631_s3_q};
  // hls/stages/census.hpp:281
  logic [12:0] sum_633;
  assign sum_633 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_635;
  assign sum_635 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_633});
  // hls/stages/census.hpp:303
  logic less_636;
  assign less_636 = 9'h4 < sum_635[13:5];
  logic and_637;
  assign and_637 = and_587_s3_q & less_636;
  // hls/stages/registration.hpp:265
  logic equal_1585;
  assign equal_1585 = sum_1534_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_1534_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_1587;
  assign select_1587 = equal_1585 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_1588;
  assign sum_1588 = (equal_1583_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1587[13]}}, select_1587};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_1534_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_1591;
  assign select_1591 = equal_1585 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_1592;
  assign sum_1592 = (equal_1583_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_1591[6]}}, select_1591};
  // hls/stages/patches.hpp:352
  logic [21:0] select_1714;
  assign select_1714 = and_1713_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1690_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_1716;
  assign select_1716 = equal_1614_s3_q ? patches_place_0_valid_q : (select_1613_s3_q ? patches_place_0_valid_q : select_1714[0]);
  // hls/stages/patches.hpp:353
  logic [20:0] select_1717;
  assign select_1717 = select_1613_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_1714[21:1];
  // hls/stages/patches.hpp:127
  logic [6:0] select_1718;
  assign select_1718 = equal_1614_s3_q ? patches_place_0_column_q : select_1717[6:0];
  logic [5:0] select_1719;
  assign select_1719 = equal_1614_s3_q ? patches_place_0_shift_q : select_1717[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1720;
  assign sum_1720 = select_1718 + {select_1719[5], select_1719};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1721;
  assign sum_1721 = sum_1720[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1722;
  assign equal_1722 = {sum_1721[5], select_488_s3_q, select_486_s3_q} == {1'b0, sum_1721[4:0], sum_1720[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1724;
  assign or_1724 = and_1596_s3_q | (select_1716 & equal_1722);
  // hls/stages/agreement.hpp:270
  logic [4:0] select_1725;
  assign select_1725 = or_1724 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1735;
  assign select_1735 = or_1724 ? {and_1596_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_1737;
  assign and_1737 = select_1734_s3_q & (~select_1735[5]);
  // hls/stages/patches.hpp:127
  logic select_1745;
  assign select_1745 = equal_1614_s3_q ? patches_place_1_valid_q : (select_1613_s3_q ? select_1714[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:353
  logic [20:0] select_1746;
  assign select_1746 = select_1613_s3_q ? select_1714[21:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [6:0] select_1747;
  assign select_1747 = equal_1614_s3_q ? patches_place_1_column_q : select_1746[6:0];
  logic [5:0] select_1748;
  assign select_1748 = equal_1614_s3_q ? patches_place_1_shift_q : select_1746[12:7];
  // hls/stages/patches.hpp:323
  logic [6:0] sum_1749;
  assign sum_1749 = select_1747 + {select_1748[5], select_1748};
  // hls/stages/patches.hpp:324
  logic [5:0] sum_1750;
  assign sum_1750 = sum_1749[6:1] + 6'h3f;
  // hls/stages/patches.hpp:131
  logic equal_1751;
  assign equal_1751 = {sum_1750[5], select_488_s3_q, select_486_s3_q} == {1'b0, sum_1750[4:0], sum_1749[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_1753;
  assign or_1753 = and_1596_s3_q | (select_1745 & equal_1751);
  // hls/stages/agreement.hpp:270
  logic [4:0] select_1754;
  assign select_1754 = or_1753 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_1755;
  assign select_1755 = or_1753 ? {and_1596_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_1757;
  assign and_1757 = select_1734_s3_q & (~select_1755[5]);
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1764;
  assign sum_1764 = select_1718 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1765;
  assign equal_1765 = {sum_1764[6], select_488_s3_q, select_486_s3_q} == {1'b0, sum_1764[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_1767;
  assign or_1767 = and_1596_s3_q | (select_1716 & equal_1765);
  logic [4:0] select_1768;
  assign select_1768 = or_1767 ? {and_1596_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [6:0] sum_1769;
  assign sum_1769 = select_1747 + 7'h7f;
  // hls/stages/patches.hpp:132
  logic equal_1770;
  assign equal_1770 = {sum_1769[6], select_488_s3_q, select_486_s3_q} == {1'b0, sum_1769[5:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_1773;
  assign select_1773 = (and_1596_s3_q | (select_1745 & equal_1770)) ? {and_1596_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_5;
  assign column_5 = select_1768[4] ? select_1773[3:0] : select_1768[3:0];
  // hls/stages/agreement.hpp:270
  logic select_1776;
  assign select_1776 = or_1767 ? and_1596_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_1782;
  assign and_1782 = (select_1734_s3_q & (select_1728_s3_q[3] ^ select_1728_s3_q[4])) & ((~select_1768[4]) | (~select_1773[4]));
  // hls/stages/patches.hpp:184
  logic less_1873;
  assign less_1873 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_1874;
  assign not_1874 = ~less_1873;
  logic [1:0] select_1875;
  assign select_1875 = patches_summed_first_s3_q ? 2'h2 : {less_1873, not_1874};
  logic [12:0] select_1877;
  assign select_1877 = select_1875[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_1885;
  assign select_1885 = select_1875[0] ? {patches_best_column_q, patches_best_differing_q} : {4'h0, and_1884_s3_q, 1'b0, select_1881_s3_q, left_pixel_q};
  logic [14:0] select_1886;
  assign select_1886 = (select_1875 == 2'h2) ? {select_1877[12:8], patches_sums_values_0_q[9:8], select_1877[7:0]} : select_1885;
  // hls/stages/agreement.hpp:890
  logic [5:0] select_1911;
  assign select_1911 = segment_started_q ? segment_textured_q : 6'h0;
  // hls/stages/agreement.hpp:891
  logic [5:0] sum_1912;
  assign sum_1912 = {5'h0, textured_s3_q} + select_1911;
  // hls/stages/agreement.hpp:1037
  logic [9:0] sum_1914;
  assign sum_1914 = {4'h0, sum_1912} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:890
  logic [5:0] select_1916;
  assign select_1916 = segment_started_q ? segment_explained_q : 6'h0;
  // hls/stages/agreement.hpp:891
  logic [5:0] sum_1917;
  assign sum_1917 = {5'h0, explained_s3_q} + select_1916;
  // hls/stages/agreement.hpp:1038
  logic [9:0] sum_1919;
  assign sum_1919 = {4'h0, sum_1917} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:890
  logic [5:0] select_1926;
  assign select_1926 = segment_started_q ? segment_nearer_q : 6'h0;
  // hls/stages/agreement.hpp:892
  logic [5:0] sum_1927;
  assign sum_1927 = {5'h0, and_1925_s3_q} + select_1926;
  // hls/stages/agreement.hpp:1039
  logic [9:0] sum_1929;
  assign sum_1929 = {4'h0, sum_1927} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1070
  logic [2:0] select_1980;
  assign select_1980 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_1981;
  assign difference_1981 = {1'b0, textured_2_s3_q} - {1'b0, select_1980};
  logic [4:0] t;
  assign t = {difference_1981[3], difference_1981} + (equal_1652_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1076
  logic equal_1984;
  assign equal_1984 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1077
  logic not_1996;
  assign not_1996 = ~region_row_s3_q[2];
  logic [2:0] select_1997;
  assign select_1997 = region_row_s3_q[1] ? {1'b0, not_1996, 1'b0} : {region_row_s3_q[2], 1'b0, not_1996};
  logic [5:0] select_1998;
  assign select_1998 = region_row_s3_q[0] ? {select_1997[2], 1'b0, select_1997[1], 1'b0, select_1997[0], 1'b0} : {1'b0, select_1997[2], 1'b0, select_1997[1], 1'b0, select_1997[0]};
  logic [11:0] select_1999;
  assign select_1999 = or_1995_s3_q ? {select_1998[5], 1'b0, select_1998[4], 1'b0, select_1998[3], 1'b0, select_1998[2], 1'b0, select_1998[1], 1'b0, select_1998[0], 1'b0} : {1'b0, select_1998[5], 1'b0, select_1998[4], 1'b0, select_1998[3], 1'b0, select_1998[2], 1'b0, select_1998[1], 1'b0, select_1998[0]};
  logic [23:0] select_2000;
  assign select_2000 = or_1992_s3_q ? {select_1999[11], 1'b0, select_1999[10], 1'b0, select_1999[9], 1'b0, select_1999[8], 1'b0, select_1999[7], 1'b0, select_1999[6], 1'b0, select_1999[5], 1'b0, select_1999[4], 1'b0, select_1999[3], 1'b0, select_1999[2], 1'b0, select_1999[1], 1'b0, select_1999[0], 1'b0} : {1'b0, select_1999[11], 1'b0, select_1999[10], 1'b0, select_1999[9], 1'b0, select_1999[8], 1'b0, select_1999[7], 1'b0, select_1999[6], 1'b0, select_1999[5], 1'b0, select_1999[4], 1'b0, select_1999[3], 1'b0, select_1999[2], 1'b0, select_1999[1], 1'b0, select_1999[0]};
  logic [47:0] select_2001;
  assign select_2001 = or_1989_s3_q ? {select_2000[23], 1'b0, select_2000[22], 1'b0, select_2000[21], 1'b0, select_2000[20], 1'b0, select_2000[19], 1'b0, select_2000[18], 1'b0, select_2000[17], 1'b0, select_2000[16], 1'b0, select_2000[15], 1'b0, select_2000[14], 1'b0, select_2000[13], 1'b0, select_2000[12], 1'b0, select_2000[11], 1'b0, select_2000[10], 1'b0, select_2000[9], 1'b0, select_2000[8], 1'b0, select_2000[7], 1'b0, select_2000[6], 1'b0, select_2000[5], 1'b0, select_2000[4], 1'b0, select_2000[3], 1'b0, select_2000[2], 1'b0, select_2000[1], 1'b0, select_2000[0], 1'b0} : {1'b0, select_2000[23], 1'b0, select_2000[22], 1'b0, select_2000[21], 1'b0, select_2000[20], 1'b0, select_2000[19], 1'b0, select_2000[18], 1'b0, select_2000[17], 1'b0, select_2000[16], 1'b0, select_2000[15], 1'b0, select_2000[14], 1'b0, select_2000[13], 1'b0, select_2000[12], 1'b0, select_2000[11], 1'b0, select_2000[10], 1'b0, select_2000[9], 1'b0, select_2000[8], 1'b0, select_2000[7], 1'b0, select_2000[6], 1'b0, select_2000[5], 1'b0, select_2000[4], 1'b0, select_2000[3], 1'b0, select_2000[2], 1'b0, select_2000[1], 1'b0, select_2000[0]};
  // hls/stages/agreement.hpp:1009
  logic and_2005;
  assign and_2005 = good_known_q & (~((good_q & select_2001) == 48'h0));
  // hls/stages/agreement.hpp:1072
  logic [2:0] select_2014;
  assign select_2014 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2015;
  assign difference_2015 = {1'b0, shown_2_s3_q} - {1'b0, select_2014};
  logic [4:0] around;
  assign around = {difference_2015[3], difference_2015} + (equal_1652_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1079
  logic [5:0] sum_2018;
  assign sum_2018 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_1984 ? and_2005 : (~({sum_2018, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1073
  logic [2:0] select_2030;
  assign select_2030 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2031;
  assign difference_2031 = {1'b0, near_2_s3_q} - {1'b0, select_2030};
  logic [4:0] n;
  assign n = {difference_2031[3], difference_2031} + (equal_1652_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1088
  logic and_2035;
  assign and_2035 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:270
  logic [8:0] select_2069;
  assign select_2069 = sample_pair_whole_s3_q ? (and_520_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2071;
  assign select_2071 = sample_pair_whole_s3_q ? (and_520_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2073;
  assign select_2073 = sample_pair_whole_s3_q ? (and_520_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2075;
  assign select_2075 = sample_pair_whole_s3_q ? (and_520_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2080;
  assign sum_2080 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2081;
  assign difference_2081 = {1'b0, sum_2080[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2082;
  assign xor_2082 = {difference_2081[8:0], sum_2080[0]} ^ {10{difference_2081[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2081[9]} + {1'b0, xor_2082};
  // hls/stages/census.hpp:210
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_525_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:270
  logic [13:0] select_2087;
  assign select_2087 = sample_pair_whole_s3_q ? (and_520_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:208
  logic [9:0] sum_2088;
  assign sum_2088 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2089;
  assign difference_2089 = {1'b0, sum_2088[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:209
  logic [9:0] xor_2090;
  assign xor_2090 = {difference_2089[8:0], sum_2088[0]} ^ {10{difference_2089[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2089[9]} + {1'b0, xor_2090};
  // hls/stages/census.hpp:210
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_525_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:270
  logic [13:0] select_2095;
  assign select_2095 = sample_pair_whole_s3_q ? (and_520_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:272
  logic [11:0] sum_2178;
  assign sum_2178 = sum_2174_s3_q + {2'h0, sum_2177_s3_q};
  // hls/stages/agreement.hpp:514
  logic [11:0] select_2180;
  assign select_2180 = and_522_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2181;
  assign select_2181 = and_522_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2182;
  assign select_2182 = and_522_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2183;
  assign select_2183 = and_522_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:282
  logic [12:0] sum_2186;
  assign sum_2186 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2178};
  logic [13:0] sum_2188;
  assign sum_2188 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2186});
  // hls/stages/census.hpp:305
  logic and_2190;
  assign and_2190 = and_612_s3_q & (9'h4 < sum_2188[13:5]);
  // hls/stages/census.hpp:306
  logic and_2191;
  assign and_2191 = and_612_s3_q & less_636;
  // hls/stages/census.hpp:307
  logic [19:0] sum_2192;
  assign sum_2192 = census_left_misses_q + {{17{and_2191}}, and_2190, 1'b0, and_2190};
  // hls/stages/agreement.hpp:514
  logic [19:0] select_2194;
  assign select_2194 = and_522_s3_q ? (equal_2185_s3_q ? 20'h0 : sum_2192) : census_left_misses_q;
  // hls/stages/agreement.hpp:270
  logic [27:0] select_2199;
  assign select_2199 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:514
  logic select_2202;
  assign select_2202 = and_522_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:355
  logic and_2205;
  assign and_2205 = whole_2_s3_q & (~(column_s3_q[5:1] == 5'h0));
  // hls/stages/agreement.hpp:451
  logic and_2211;
  assign and_2211 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2212;
  assign and_2212 = and_2205 & and_2211;
  // hls/stages/census.hpp:354
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2199[13:0]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2214;
  assign select_2214 = and_2212 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2216;
  assign select_2216 = equal_2185_s3_q ? {11'h0, select_2214} : (sharpness_sums_detail_0_q + {11'h0, select_2214});
  // hls/stages/agreement.hpp:451
  logic and_2223;
  assign and_2223 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2224;
  assign and_2224 = and_2205 & and_2223;
  // hls/stages/census.hpp:354
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2199[27:14]};
  // hls/stages/census.hpp:356
  logic [12:0] select_2226;
  assign select_2226 = and_2224 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:357
  logic [23:0] select_2228;
  assign select_2228 = equal_2185_s3_q ? {11'h0, select_2226} : (sharpness_sums_detail_1_q + {11'h0, select_2226});
  logic [8:0] select_2231;
  assign select_2231 = and_2212 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2232;
  assign sum_2232 = (equal_2185_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2231};
  logic [8:0] select_2235;
  assign select_2235 = and_2224 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2236;
  assign sum_2236 = (equal_2185_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2235};
  // hls/stages/agreement.hpp:209
  logic equal_2238;
  assign equal_2238 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:370
  logic less_2239;
  assign less_2239 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:409
  logic less_2240;
  assign less_2240 = x_s3_q[4:0] < 5'h3;
  logic not_2241;
  assign not_2241 = ~x_s3_q[1];
  logic [2:0] select_2242;
  assign select_2242 = x_s3_q[0] ? {1'b0, not_2241, 1'b0} : {x_s3_q[1], 1'b0, not_2241};
  logic [5:0] select_2243;
  assign select_2243 = slot_s3_q[2] ? {select_2242[2], 1'b0, select_2242[1], 1'b0, select_2242[0], 1'b0} : {1'b0, select_2242[2], 1'b0, select_2242[1], 1'b0, select_2242[0]};
  logic [11:0] select_2244;
  assign select_2244 = slot_s3_q[1] ? {select_2243[5], 1'b0, select_2243[4], 1'b0, select_2243[3], 1'b0, select_2243[2], 1'b0, select_2243[1], 1'b0, select_2243[0], 1'b0} : {1'b0, select_2243[5], 1'b0, select_2243[4], 1'b0, select_2243[3], 1'b0, select_2243[2], 1'b0, select_2243[1], 1'b0, select_2243[0]};
  logic [23:0] select_2245;
  assign select_2245 = slot_s3_q[0] ? {select_2244[11], 1'b0, select_2244[10], 1'b0, select_2244[9], 1'b0, select_2244[8], 1'b0, select_2244[7], 1'b0, select_2244[6], 1'b0, select_2244[5], 1'b0, select_2244[4], 1'b0, select_2244[3], 1'b0, select_2244[2], 1'b0, select_2244[1], 1'b0, select_2244[0], 1'b0} : {1'b0, select_2244[11], 1'b0, select_2244[10], 1'b0, select_2244[9], 1'b0, select_2244[8], 1'b0, select_2244[7], 1'b0, select_2244[6], 1'b0, select_2244[5], 1'b0, select_2244[4], 1'b0, select_2244[3], 1'b0, select_2244[2], 1'b0, select_2244[1], 1'b0, select_2244[0]};
  // hls/stages/census.hpp:372
  logic and_2249;
  assign and_2249 = less_2240 & (~((sharpness_sums_contrast_1_q & select_2245) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2251;
  assign select_2251 = (less_2239 & and_2249) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2251};
  // hls/stages/agreement.hpp:213
  logic [17:0] select_2254;
  assign select_2254 = equal_2238 ? (less_2239 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:372
  logic and_2259;
  assign and_2259 = less_2240 & (~((sharpness_sums_contrast_0_q & select_2245) == 24'h0));
  // hls/stages/census.hpp:377
  logic [17:0] select_2261;
  assign select_2261 = (less_2239 & and_2259) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2261};
  // hls/stages/agreement.hpp:213
  logic [17:0] select_2264;
  assign select_2264 = equal_2238 ? (less_2239 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2266;
  assign select_2266 = equal_2238 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2268;
  assign select_2268 = equal_2238 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2270;
  assign select_2270 = equal_2238 ? {sharpness_comparing_contrast_0_q[0], and_2259} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2272;
  assign select_2272 = equal_2238 ? {sharpness_comparing_contrast_1_q[0], and_2249} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:213
  logic select_2277;
  assign select_2277 = drew_q ? (equal_2238 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:383
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:213
  logic select_2281;
  assign select_2281 = drew_q ? (equal_2238 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:369
  logic equal_2282;
  assign equal_2282 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:385
  logic xor_2283;
  assign xor_2283 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2286;
  assign select_2286 = (equal_2282 | xor_2283) ? (five_times[0] & xor_2283) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:213
  logic select_2288;
  assign select_2288 = drew_q ? (equal_2238 ? select_2286 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:385
  logic xor_2289;
  assign xor_2289 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2292;
  assign select_2292 = (equal_2282 | xor_2289) ? (five_times_2[0] & xor_2289) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:213
  logic select_2294;
  assign select_2294 = drew_q ? (equal_2238 ? select_2292 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:386
  logic xor_2295;
  assign xor_2295 = sharpness_comparing_contrast_0_q[1] ^ and_2249;
  logic select_2298;
  assign select_2298 = (equal_2282 | xor_2295) ? (and_2249 & xor_2295) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:213
  logic select_2300;
  assign select_2300 = drew_q ? (equal_2238 ? select_2298 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:386
  logic xor_2301;
  assign xor_2301 = sharpness_comparing_contrast_1_q[1] ^ and_2259;
  logic select_2304;
  assign select_2304 = (equal_2282 | xor_2301) ? (and_2259 & xor_2301) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:213
  logic select_2306;
  assign select_2306 = drew_q ? (equal_2238 ? select_2304 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2442;
  assign select_2442 = and_2434_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_2440_s3_q});
  // hls/stages/agreement.hpp:780
  logic and_2445;
  assign and_2445 = not_1488_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_2450;
  assign and_2450 = not_1488_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_2455;
  assign and_2455 = not_1488_s3_q & (drew_q & (ends_cell_s3_q & and_1925_s3_q));
  // hls/stages/agreement.hpp:1081
  logic not_2459;
  assign not_2459 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1071
  logic [2:0] select_2468;
  assign select_2468 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_2469;
  assign difference_2469 = {1'b0, explained_2_s3_q} - {1'b0, select_2468};
  logic [4:0] e;
  assign e = {difference_2469[3], difference_2469} + (equal_1652_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1078
  logic [5:0] sum_2472;
  assign sum_2472 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1082
  logic not_2476;
  assign not_2476 = ~(equal_1984 ? and_2005 : (~({sum_2472, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:780
  logic and_2479;
  assign and_2479 = ends_cell_s3_q & (not_2459 & (centres_values_1_textured_s3_q & not_2476));
  logic and_2481;
  assign and_2481 = not_1488_s3_q & (drew_q & and_2479);
  // hls/stages/agreement.hpp:1108
  logic less_2484;
  assign less_2484 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_2485;
  assign select_2485 = less_2484 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_2488;
  assign select_2488 = less_2484 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1109
  logic [10:0] sum_2489;
  assign sum_2489 = {1'b0, select_2488} + {3'h0, select_2488[9:2]};
  logic and_2491;
  assign and_2491 = (~(select_2485[9:4] == 6'h0)) & ({sum_2489, select_2488[1:0]} < {3'h0, select_2485});
  // hls/stages/agreement.hpp:1118
  logic [9:0] select_2494;
  assign select_2494 = x_s3_q[6] ? (equal_1528_s3_q ? 10'h0 : (and_2491 ? select_2485 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:780
  logic [9:0] select_2495;
  assign select_2495 = equal_1487_s3_q ? select_2494 : 10'h0;
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2497;
  assign select_2497 = and_2434_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_2495});
  logic [13:0] select_2504;
  assign select_2504 = and_2434_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_2502_s3_q});
  // hls/stages/agreement.hpp:1086
  logic and_2506;
  assign and_2506 = not_2459 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:780
  logic and_2509;
  assign and_2509 = not_1488_s3_q & (drew_q & (ends_cell_s3_q & and_2506));
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2511;
  assign select_2511 = and_2434_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_2509});
  // hls/stages/agreement.hpp:1086
  logic and_2513;
  assign and_2513 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_2476);
  // hls/stages/agreement.hpp:780
  logic and_2517;
  assign and_2517 = not_1488_s3_q & (drew_q & (ends_cell_s3_q & (not_2459 & and_2513)));
  // hls/stages/agreement.hpp:914
  logic [13:0] select_2519;
  assign select_2519 = and_2434_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_2517});
  logic [13:0] select_2538;
  assign select_2538 = and_2434_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_2536_s3_q});
  // hls/stages/agreement.hpp:780
  logic [7:0] select_2589;
  assign select_2589 = drew_q ? (equal_1624_s3_q ? (and_2571_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_2590;
  assign select_2590 = equal_1487_s3_q ? 8'h0 : select_2589;
  // hls/stages/registration.hpp:134
  logic [13:0] select_2592;
  assign select_2592 = and_2570_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_2590[7]}}, select_2590});
  // hls/stages/agreement.hpp:780
  logic and_2595;
  assign and_2595 = not_1488_s3_q & (drew_q & (and_2571_s3_q & equal_1624_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_2597;
  assign select_2597 = and_2570_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_2595});
  // hls/stages/registration.hpp:107
  logic and_2599;
  assign and_2599 = and_2571_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:780
  logic [1:0] select_2601;
  assign select_2601 = drew_q ? (equal_1624_s3_q ? {and_2599, and_2571_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2602;
  assign select_2602 = equal_1487_s3_q ? 2'h0 : select_2601;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2603;
  assign sum_2603 = registration_half_votes_down_q + {{5{select_2602[1]}}, select_2602};
  // hls/stages/agreement.hpp:780
  logic [1:0] select_2609;
  assign select_2609 = drew_q ? (equal_1624_s3_q ? {and_2607_s3_q, and_2571_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2610;
  assign select_2610 = equal_1487_s3_q ? 2'h0 : select_2609;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2611;
  assign sum_2611 = registration_half_votes_up_q + {{5{select_2610[1]}}, select_2610};
  // hls/stages/registration.hpp:107
  logic and_2614;
  assign and_2614 = and_2571_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:780
  logic [1:0] select_2616;
  assign select_2616 = drew_q ? (equal_1624_s3_q ? {and_2614, and_2571_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2617;
  assign select_2617 = equal_1487_s3_q ? 2'h0 : select_2616;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_2618;
  assign sum_2618 = registration_half_half_votes_down_q + {{5{select_2617[1]}}, select_2617};
  // hls/stages/agreement.hpp:780
  logic [1:0] select_2623;
  assign select_2623 = drew_q ? (equal_1624_s3_q ? {and_2621_s3_q, and_2571_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_2624;
  assign select_2624 = equal_1487_s3_q ? 2'h0 : select_2623;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_2625;
  assign sum_2625 = registration_half_half_votes_up_q + {{5{select_2624[1]}}, select_2624};
  // hls/stages/agreement.hpp:780
  logic and_2659;
  assign and_2659 = equal_1487_s3_q & (x_s3_q[6] & (not_1898_s3_q & less_1559_s3_q));
  // hls/stages/agreement.hpp:1106
  logic [11:0] select_2666;
  assign select_2666 = or_1563_s3_q ? 12'h0 : (equal_2664_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1118
  logic [11:0] select_2669;
  assign select_2669 = x_s3_q[6] ? (equal_1528_s3_q ? 12'h0 : (less_1559_s3_q ? select_2666 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:780
  logic [11:0] select_2670;
  assign select_2670 = equal_1487_s3_q ? select_2669 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_2671;
  assign and_2671 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1118
  logic and_2674;
  assign and_2674 = not_1898_s3_q & (less_1559_s3_q & ({and_2671, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:780
  logic and_2676;
  assign and_2676 = equal_1487_s3_q & (x_s3_q[6] & and_2674);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_2678;
  assign sum_2678 = {{2{select_2670[11]}}, select_2670} + (and_2676 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1106
  logic [11:0] select_2681;
  assign select_2681 = or_1563_s3_q ? 12'h0 : (equal_2664_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1118
  logic [11:0] select_2684;
  assign select_2684 = x_s3_q[6] ? (equal_1528_s3_q ? 12'h0 : (less_1559_s3_q ? select_2681 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:780
  logic [11:0] select_2685;
  assign select_2685 = equal_1487_s3_q ? select_2684 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_2687;
  assign sum_2687 = {{2{select_2685[11]}}, select_2685} + (and_2676 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_2689;
  assign not_2689 = ~all_s3_q;
  // hls/stages/agreement.hpp:1118
  logic and_2692;
  assign and_2692 = not_1898_s3_q & (less_1559_s3_q & (x_s3_q[2:0] == {all_s3_q, not_2689, 1'b0}));
  // hls/stages/agreement.hpp:780
  logic and_2698;
  assign and_2698 = equal_1487_s3_q & (x_s3_q[6] & (not_1898_s3_q & (less_1559_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_2699;
  assign not_2699 = ~and_2698;
  logic less_2700;
  assign less_2700 = $signed({9'h1, {2{not_2699}}, and_2698}) < $signed(registration_up_q[13:2]);
  logic select_2701;
  assign select_2701 = (equal_1487_s3_q & (x_s3_q[6] & and_2692)) ? less_2700 : registration_enough_q;
  // hls/stages/agreement.hpp:1118
  logic and_2705;
  assign and_2705 = x_s3_q[6] & (not_1898_s3_q & (less_1559_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:780
  logic and_2706;
  assign and_2706 = equal_1487_s3_q & and_2705;
  // hls/stages/registration.hpp:242
  logic less_2707;
  assign less_2707 = $signed(14'h0) < $signed(registration_down_q);
  logic less_2709;
  assign less_2709 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_2711;
  assign equal_2711 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:780
  logic and_2715;
  assign and_2715 = equal_1487_s3_q & (x_s3_q[6] & (not_1898_s3_q & (less_1559_s3_q & equal_2711)));
  // hls/stages/agreement.hpp:1118
  logic and_2722;
  assign and_2722 = x_s3_q[6] & (not_1898_s3_q & (less_1559_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_2725;
  assign equal_2725 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1118
  logic and_2728;
  assign and_2728 = not_1898_s3_q & (less_1559_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_2725));
  // hls/stages/registration.hpp:244
  logic and_2732;
  assign and_2732 = (equal_1487_s3_q & (x_s3_q[6] & and_2728)) & (less_2709 | less_2707);
  // hls/stages/agreement.hpp:1118
  logic and_2737;
  assign and_2737 = not_1898_s3_q & (less_1559_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_2725)));
  // hls/stages/registration.hpp:244
  logic and_2740;
  assign and_2740 = registration_votes_up_q & registration_other_down_q;
  logic select_2742;
  assign select_2742 = registration_votes_down_q ? (registration_other_up_q | and_2740) : and_2740;
  // hls/stages/registration.hpp:138
  logic and_2744;
  assign and_2744 = (equal_1487_s3_q & (x_s3_q[6] & and_2737)) & (registration_other_enough_q & select_2742);
  // hls/stages/registration.hpp:245
  logic or_2747;
  assign or_2747 = registration_moved_q | (registration_enough_q & (and_2732 | and_2744));
  // hls/stages/agreement.hpp:270
  logic [7:0] select_2831;
  assign select_2831 = sample_pair_whole_s3_q ? (equal_1614_s3_q ? patches_place_0_slope_q : select_1717[20:13]) : patches_place_0_slope_q;
  logic [7:0] select_2836;
  assign select_2836 = sample_pair_whole_s3_q ? (equal_1614_s3_q ? patches_place_1_slope_q : select_1746[20:13]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_2838;
  assign select_2838 = equal_1614_s3_q ? patches_valid_0_q : (select_1613_s3_q ? patches_valid_0_q : select_1714[0]);
  // hls/stages/agreement.hpp:270
  logic select_2841;
  assign select_2841 = sample_pair_whole_s3_q ? (and_1737 ? (sample_present_s3_q & select_2838) : select_2838) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_2843;
  assign select_2843 = equal_1614_s3_q ? patches_valid_1_q : (select_1613_s3_q ? select_1714[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:270
  logic select_2846;
  assign select_2846 = sample_pair_whole_s3_q ? (and_1757 ? (sample_present_s3_q & select_2843) : select_2843) : patches_valid_1_q;
  logic [5:0] select_2849;
  assign select_2849 = sample_pair_whole_s3_q ? (select_1735[5] ? {1'b1, select_1735[4:0]} : (select_1735 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_2852;
  assign select_2852 = sample_pair_whole_s3_q ? (select_1755[5] ? {1'b1, select_1755[4:0]} : (select_1755 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_2855;
  assign select_2855 = sample_pair_whole_s3_q ? (select_1768[4] ? {1'b1, select_1768[3:0]} : (select_1768 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_2858;
  assign select_2858 = sample_pair_whole_s3_q ? (select_1773[4] ? {1'b1, select_1773[3:0]} : (select_1773 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:520
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3277_s3_q, parity_3273_s3_q, xor_3261_s3_q, parity_3233_s3_q, parity_3171_s3_q, parity_3042_s3_q} + (equal_3278_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3282;
  assign select_3282 = equal_1698_s3_q ? patches_sums_values_0_q : (equal_1700_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3283;
  assign select_3283 = equal_1700_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3285;
  assign select_3285 = equal_1700_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3287;
  assign select_3287 = equal_1700_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3289;
  assign select_3289 = equal_1700_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3291;
  assign select_3291 = equal_1700_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3293;
  assign select_3293 = equal_1700_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3295;
  assign select_3295 = equal_1700_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3297;
  assign select_3297 = equal_1700_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3299;
  assign select_3299 = equal_1700_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3301;
  assign select_3301 = equal_1700_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3303;
  assign select_3303 = equal_1700_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3305;
  assign select_3305 = equal_1700_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3307;
  assign select_3307 = equal_1700_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3309;
  assign select_3309 = equal_1700_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3311;
  assign select_3311 = equal_1700_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3313;
  assign select_3313 = equal_1700_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:594
  logic or_3418;
  assign or_3418 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_3417_s3_q;
  logic or_3421;
  assign or_3421 = equal_3409_s3_q | (less_3411_s3_q | (less_3412_s3_q | or_3418));
  // hls/stages/patches.hpp:574
  logic not_3422;
  assign not_3422 = ~or_3421;
  // hls/stages/patches.hpp:555
  logic and_3423;
  assign and_3423 = equal_1864_s3_q & not_3422;
  // hls/stages/patches.hpp:184
  logic and_3426;
  assign and_3426 = equal_1698_s3_q & (less_1861_s3_q ? (not_1863_s3_q & and_3423) : and_3423);
  // hls/stages/patches.hpp:652
  logic not_3427;
  assign not_3427 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:555
  logic and_3429;
  assign and_3429 = equal_1864_s3_q & (patches_second_s3_q & not_3422);
  // hls/stages/patches.hpp:184
  logic and_3432;
  assign and_3432 = equal_1698_s3_q & (less_1861_s3_q ? (not_1863_s3_q & and_3429) : and_3429);
  // hls/stages/patches.hpp:652
  logic not_3433;
  assign not_3433 = ~and_3432;
  // hls/stages/patches.hpp:188
  logic and_3435;
  assign and_3435 = and_3426 & (not_3427 & not_3433);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3437;
  assign sum_3437 = {7'h0, and_3435} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:592
  logic [7:0] select_3463;
  assign select_3463 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:591
  logic [5:0] select_3464;
  assign select_3464 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_3465;
  assign sum_3465 = {2'h0, select_3397_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_3466;
  assign sum_3466 = {select_3464[5], select_3464} + {{3{sum_3465[3]}}, sum_3465};
  // hls/stages/patches.hpp:592
  logic [17:0] product_3467;
  assign product_3467 = $signed({{10{select_3463[7]}}, select_3463}) * $signed({{8{sum_3466[6]}}, sum_3466, select_3397_s3_q[2:0]});
  // hls/stages/patches.hpp:593
  logic [13:0] difference_3468;
  assign difference_3468 = {{6{select_3462_s3_q[7]}}, select_3462_s3_q} - {product_3467[17], product_3467[17:5]};
  // hls/stages/patches.hpp:599
  logic less_3469;
  assign less_3469 = $signed({{7{difference_3439[6]}}, difference_3439}) < $signed(difference_3468);
  // hls/stages/patches.hpp:555
  logic and_3472;
  assign and_3472 = equal_1864_s3_q & (not_3422 & (~less_3469));
  // hls/stages/patches.hpp:184
  logic and_3475;
  assign and_3475 = equal_1698_s3_q & (less_1861_s3_q ? (not_1863_s3_q & and_3472) : and_3472);
  // hls/stages/patches.hpp:655
  logic and_3476;
  assign and_3476 = and_3475 & and_3435;
  logic [7:0] sum_3477;
  assign sum_3477 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_3476};
  // hls/stages/patches.hpp:555
  logic and_3481;
  assign and_3481 = not_3422 & (~($signed(difference_3468) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_3482;
  assign and_3482 = equal_1864_s3_q & and_3481;
  // hls/stages/patches.hpp:184
  logic and_3485;
  assign and_3485 = equal_1698_s3_q & (less_1861_s3_q ? (not_1863_s3_q & and_3482) : and_3482);
  // hls/stages/patches.hpp:656
  logic and_3486;
  assign and_3486 = and_3485 & and_3435;
  logic [7:0] sum_3487;
  assign sum_3487 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_3486};
  // hls/stages/patches.hpp:188
  logic and_3489;
  assign and_3489 = and_3426 & (and_3432 & not_3427);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3491;
  assign sum_3491 = {7'h0, and_3489} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:655
  logic and_3493;
  assign and_3493 = and_3475 & and_3489;
  logic [7:0] sum_3494;
  assign sum_3494 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_3493};
  // hls/stages/patches.hpp:656
  logic and_3496;
  assign and_3496 = and_3485 & and_3489;
  logic [7:0] sum_3497;
  assign sum_3497 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_3496};
  // hls/stages/patches.hpp:188
  logic and_3499;
  assign and_3499 = and_3426 & (patches_lower_s3_q & not_3433);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3501;
  assign sum_3501 = {7'h0, and_3499} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:655
  logic and_3503;
  assign and_3503 = and_3475 & and_3499;
  logic [7:0] sum_3504;
  assign sum_3504 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_3503};
  // hls/stages/patches.hpp:656
  logic and_3506;
  assign and_3506 = and_3485 & and_3499;
  logic [7:0] sum_3507;
  assign sum_3507 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_3506};
  // hls/stages/patches.hpp:188
  logic and_3509;
  assign and_3509 = and_3426 & (patches_lower_s3_q & and_3432);
  // hls/stages/patches.hpp:654
  logic [7:0] sum_3511;
  assign sum_3511 = {7'h0, and_3509} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:655
  logic and_3513;
  assign and_3513 = and_3475 & and_3509;
  logic [7:0] sum_3514;
  assign sum_3514 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_3513};
  // hls/stages/patches.hpp:656
  logic and_3516;
  assign and_3516 = and_3485 & and_3509;
  logic [7:0] sum_3517;
  assign sum_3517 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_3516};
  // hls/stages/agreement.hpp:1195
  logic equal_3518;
  assign equal_3518 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1106
  logic less_3519;
  assign less_3519 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:780
  logic and_3523;
  assign and_3523 = equal_1487_s3_q & (x_s3_q[6] & (not_1898_s3_q & (equal_3518 & less_3519)));
  // hls/stages/agreement.hpp:1118
  logic and_3528;
  assign and_3528 = x_s3_q[6] & (not_1898_s3_q & (less_3519 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:780
  logic and_3529;
  assign and_3529 = equal_1487_s3_q & and_3528;
  // hls/stages/patches.hpp:618
  logic [7:0] or_3531;
  assign or_3531 = (and_3523 ? patches_quarters_0_places_q : 8'h0) | (and_3529 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1118
  logic and_3535;
  assign and_3535 = x_s3_q[6] & (not_1898_s3_q & (less_3519 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:780
  logic and_3536;
  assign and_3536 = equal_1487_s3_q & and_3535;
  // hls/stages/agreement.hpp:1118
  logic and_3542;
  assign and_3542 = x_s3_q[6] & (not_1898_s3_q & (less_3519 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:780
  logic and_3543;
  assign and_3543 = equal_1487_s3_q & and_3542;
  // hls/stages/patches.hpp:618
  logic [7:0] or_3545;
  assign or_3545 = (or_3531 | (and_3536 ? patches_quarters_2_places_q : 8'h0)) | (and_3543 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_3549;
  assign select_3549 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:780
  logic and_3553;
  assign and_3553 = equal_1487_s3_q & (x_s3_q[6] & (not_1898_s3_q & (less_3519 & select_3549)));
  // hls/stages/patches.hpp:619
  logic [7:0] select_3555;
  assign select_3555 = and_3523 ? (and_3553 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_3557;
  assign select_3557 = and_3529 ? (and_3553 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_3560;
  assign select_3560 = and_3536 ? (and_3553 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_3563;
  assign select_3563 = and_3543 ? (and_3553 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:620
  logic [7:0] select_3566;
  assign select_3566 = and_3523 ? (and_3553 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_3568;
  assign select_3568 = and_3529 ? (and_3553 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_3571;
  assign select_3571 = and_3536 ? (and_3553 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_3574;
  assign select_3574 = and_3543 ? (and_3553 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_3576;
  assign sum_3576 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1118
  logic and_3580;
  assign and_3580 = x_s3_q[6] & (not_1898_s3_q & (less_3519 & (sum_3576[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:780
  logic and_3581;
  assign and_3581 = equal_1487_s3_q & and_3580;
  // hls/stages/patches.hpp:615
  logic [7:0] select_3584;
  assign select_3584 = and_3581 ? (patches_word_places_q + (and_3529 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_3587;
  assign select_3587 = and_3581 ? (patches_word_up_q + (and_3529 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_3590;
  assign select_3590 = and_3581 ? (patches_word_down_q + (and_3529 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:601
  logic [5:0] select_3594;
  assign select_3594 = ($signed(difference_3468[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_3468[5:0];
  logic [5:0] select_3595;
  assign select_3595 = ($signed(14'h10) < $signed(difference_3468)) ? 6'h10 : select_3594;
  // hls/stages/patches.hpp:555
  logic [5:0] select_3597;
  assign select_3597 = equal_1864_s3_q ? (or_3421 ? 6'h0 : select_3595) : 6'h0;
  logic [5:0] select_3599;
  assign select_3599 = less_1861_s3_q ? (equal_1862_s3_q ? 6'h0 : select_3597) : select_3597;
  // hls/stages/patches.hpp:658
  logic [5:0] select_3601;
  assign select_3601 = and_3426 ? (equal_1698_s3_q ? select_3599 : 6'h0) : 6'h0;
  logic [11:0] sum_3602;
  assign sum_3602 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_3601[5]}}, select_3601};
  // hls/stages/agreement.hpp:780
  logic and_3606;
  assign and_3606 = equal_1487_s3_q & (x_s3_q[6] & (not_1898_s3_q & (equal_2711 & less_3519)));
  // hls/stages/agreement.hpp:1118
  logic and_3610;
  assign and_3610 = x_s3_q[6] & (not_1898_s3_q & (less_3519 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:780
  logic and_3611;
  assign and_3611 = equal_1487_s3_q & and_3610;
  // hls/stages/patches.hpp:642
  logic [7:0] select_3613;
  assign select_3613 = and_3606 ? (and_3611 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:644
  logic or_3617;
  assign or_3617 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:645
  logic or_3620;
  assign or_3620 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic [8:0] sum_3621;
  assign sum_3621 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:641
  logic select_3623;
  assign select_3623 = and_3606 ? (and_3611 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/agreement.hpp:780
  logic and_3628;
  assign and_3628 = equal_1487_s3_q & ((x_s3_q[6:0] == 7'h70) & (~equal_3625_s3_q));
  // hls/stages/patches.hpp:188
  logic and_3630;
  assign and_3630 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:641
  logic [2:0] select_3632;
  assign select_3632 = and_3611 ? {and_3630, patches_found_q[2:1]} : (and_3606 ? {and_3630, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:640
  logic or_3636;
  assign or_3636 = patches_partly_q | (patches_doubted_q & (~and_3611));
  // hls/stages/patches.hpp:641
  logic select_3639;
  assign select_3639 = and_3606 ? (and_3611 ? or_3636 : (and_3606 ? or_3636 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:639
  logic select_3640;
  assign select_3640 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:628
  logic [7:0] select_3644;
  assign select_3644 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:600
  logic [10:0] sum_3646;
  assign sum_3646 = {sum_3466[6], sum_3466, select_3397_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:555
  logic and_3649;
  assign and_3649 = equal_1864_s3_q & (not_3422 & ({{5{sum_3646[10]}}, sum_3646} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_3652;
  assign and_3652 = equal_1698_s3_q & (less_1861_s3_q ? (not_1863_s3_q & and_3649) : and_3649);
  // hls/stages/patches.hpp:188
  logic and_3653;
  assign and_3653 = and_3426 & and_3652;
  // hls/stages/patches.hpp:659
  logic [7:0] sum_3654;
  assign sum_3654 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_3653};
  // hls/stages/patches.hpp:649
  logic [12:0] product_3655;
  assign product_3655 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_3613};
  // hls/stages/patches.hpp:188
  logic and_3661;
  assign and_3661 = (~(patches_on_skin_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_q);
  logic select_3666;
  assign select_3666 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:629
  logic or_3670;
  assign or_3670 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:630
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:631
  logic select_3677;
  assign select_3677 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:632
  logic and_3683;
  assign and_3683 = patches_frame_ended_q & (~patches_age_q[9]);
  logic [9:0] sum_3684;
  assign sum_3684 = patches_age_q + {9'h0, and_3683};
  logic [9:0] select_3687;
  assign select_3687 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_3684)) : sum_3684;
  // hls/stages/agreement.hpp:1160
  logic or_3744;
  assign or_3744 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1189
  logic equal_3746;
  assign equal_3746 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1198
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1199
  logic select_3752;
  assign select_3752 = (equal_3746 & equal_3518) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1111
  logic [10:0] sum_3755;
  assign sum_3755 = {1'b0, select_2488} + {2'h0, select_2488[9:1]};
  logic select_3758;
  assign select_3758 = (select_2485[9:3] == 7'h0) ? ((~or_3744) & (~select_3752)) : (~({sum_3755, select_2488[0]} < {2'h0, select_2485}));
  // hls/stages/agreement.hpp:1118
  logic [47:0] select_3760;
  assign select_3760 = x_s3_q[6] ? (equal_1528_s3_q ? good_q : {select_3758, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:780
  logic select_3764;
  assign select_3764 = equal_1487_s3_q ? ((x_s3_q[6] & good_known_q) | equal_3625_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1189
  logic equal_3765;
  assign equal_3765 = x_s3_q[6:3] == 4'ha;
  logic equal_3767;
  assign equal_3767 = x_s3_q[6:3] == 4'hc;
  logic equal_3768;
  assign equal_3768 = x_s3_q[6:3] == 4'hb;
  logic equal_3769;
  assign equal_3769 = x_s3_q[6:3] == 4'h9;
  logic equal_3770;
  assign equal_3770 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1101
  logic [13:0] select_3772;
  assign select_3772 = equal_3769 ? counts_skin_unproven_q : (equal_3770 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_3774;
  assign select_3774 = equal_3768 ? counts_regions_bad_q : (equal_3765 ? counts_nearer_q : select_3772);
  logic [13:0] before_v_4;
  assign before_v_4 = equal_3767 ? counts_on_skin_q : select_3774;
  // hls/stages/agreement.hpp:1194
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_4};
  // hls/stages/agreement.hpp:1202
  logic select_3777;
  assign select_3777 = (equal_3765 & equal_3518) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1120
  logic not_3778;
  assign not_3778 = ~hidden_for_q[7];
  logic [7:0] select_3780;
  assign select_3780 = select_3777 ? (hidden_for_q + {7'h0, not_3778}) : 8'h0;
  // hls/stages/agreement.hpp:780
  logic [7:0] select_3782;
  assign select_3782 = equal_1487_s3_q ? (equal_3625_s3_q ? select_3780 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1203
  logic [13:0] select_3783;
  assign select_3783 = equal_3518 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1101
  logic [7:0] select_3785;
  assign select_3785 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3787;
  assign select_3787 = equal_3770 ? cfg_unproven_skin_limit_i : (equal_3746 ? cfg_unproven_limit_i : select_3785);
  logic [7:0] select_3789;
  assign select_3789 = equal_3765 ? cfg_regions_limit_i : (equal_3769 ? cfg_hidden_limit_i : select_3787);
  logic [7:0] limit;
  assign limit = equal_3767 ? cfg_regions_limit_i : (equal_3768 ? {cfg_on_skin_limit_i, 3'h0} : select_3789);
  // hls/stages/agreement.hpp:1203
  logic not_3792;
  assign not_3792 = ~x_s3_q[2];
  logic [3:0] select_3793;
  assign select_3793 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_3792, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_3792};
  logic [7:0] select_3794;
  assign select_3794 = x_s3_q[0] ? {select_3793[3], 1'b0, select_3793[2], 1'b0, select_3793[1], 1'b0, select_3793[0], 1'b0} : {1'b0, select_3793[3], 1'b0, select_3793[2], 1'b0, select_3793[1], 1'b0, select_3793[0]};
  // hls/stages/agreement.hpp:1101
  logic [13:0] select_3798;
  assign select_3798 = equal_3769 ? counts_skin_supervised_q : (equal_3770 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_3800;
  assign select_3800 = equal_3768 ? counts_skin_textured_q : (equal_3765 ? counts_textured_q : select_3798);
  logic [13:0] of;
  assign of = equal_3767 ? counts_textured_q : select_3800;
  // hls/stages/agreement.hpp:1203
  logic [13:0] select_3802;
  assign select_3802 = ((limit & select_3794) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_3783} + {1'b0, select_3802};
  // hls/stages/agreement.hpp:780
  logic select_3807;
  assign select_3807 = equal_1487_s3_q ? (equal_3518 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1200
  logic and_3812;
  assign and_3812 = too_much_q & (~(equal_3770 & equal_3518));
  // hls/stages/agreement.hpp:1201
  logic select_3817;
  assign select_3817 = (over[14] & equal_3518) ? (and_3812 | ((equal_3770 | equal_3769) | (x_s3_q[6:3] == 4'hf))) : and_3812;
  // hls/stages/agreement.hpp:1101
  logic and_3822;
  assign and_3822 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1203
  logic select_3823;
  assign select_3823 = (equal_3767 & equal_3518) ? and_3822 : overlooks_q;
  // hls/stages/agreement.hpp:780
  logic [2:0] select_3825;
  assign select_3825 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_3827;
  assign select_3827 = equal_1487_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_3825 : box_textured_columns_values_0_q);
  logic [2:0] select_3828;
  assign select_3828 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3830;
  assign select_3830 = equal_1487_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_3828 : box_textured_columns_values_1_q);
  logic [2:0] select_3831;
  assign select_3831 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3833;
  assign select_3833 = equal_1487_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_3831 : box_textured_columns_values_2_q);
  logic [2:0] select_3834;
  assign select_3834 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3836;
  assign select_3836 = equal_1487_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_3834 : box_textured_columns_values_3_q);
  logic [2:0] select_3837;
  assign select_3837 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3839;
  assign select_3839 = equal_1487_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_3837 : box_textured_columns_values_4_q);
  logic [4:0] select_3841;
  assign select_3841 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3843;
  assign select_3843 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_3845;
  assign select_3845 = equal_1487_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_3843 : box_explained_columns_values_0_q);
  logic [2:0] select_3846;
  assign select_3846 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3848;
  assign select_3848 = equal_1487_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_3846 : box_explained_columns_values_1_q);
  logic [2:0] select_3849;
  assign select_3849 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3851;
  assign select_3851 = equal_1487_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_3849 : box_explained_columns_values_2_q);
  logic [2:0] select_3852;
  assign select_3852 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3854;
  assign select_3854 = equal_1487_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_3852 : box_explained_columns_values_3_q);
  logic [2:0] select_3855;
  assign select_3855 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3857;
  assign select_3857 = equal_1487_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_3855 : box_explained_columns_values_4_q);
  logic [4:0] select_3859;
  assign select_3859 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3860;
  assign select_3860 = equal_1487_s3_q ? box_explained_sum_sums_values_0_q : select_3859;
  logic [2:0] select_3862;
  assign select_3862 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3864;
  assign select_3864 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3866;
  assign select_3866 = equal_1487_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_3864 : box_shown_columns_values_1_q);
  logic [2:0] select_3867;
  assign select_3867 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3869;
  assign select_3869 = equal_1487_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_3867 : box_shown_columns_values_2_q);
  logic [2:0] select_3870;
  assign select_3870 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3872;
  assign select_3872 = equal_1487_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_3870 : box_shown_columns_values_3_q);
  logic [2:0] select_3873;
  assign select_3873 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3875;
  assign select_3875 = equal_1487_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_3873 : box_shown_columns_values_4_q);
  logic [4:0] select_3877;
  assign select_3877 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_3880;
  assign select_3880 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3882;
  assign select_3882 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3884;
  assign select_3884 = equal_1487_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_3882 : box_nearer_columns_values_1_q);
  logic [2:0] select_3885;
  assign select_3885 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3887;
  assign select_3887 = equal_1487_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_3885 : box_nearer_columns_values_2_q);
  logic [2:0] select_3888;
  assign select_3888 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3890;
  assign select_3890 = equal_1487_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_3888 : box_nearer_columns_values_3_q);
  logic [2:0] select_3891;
  assign select_3891 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3893;
  assign select_3893 = equal_1487_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_3891 : box_nearer_columns_values_4_q);
  logic [4:0] select_3895;
  assign select_3895 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1246
  logic select_3930;
  assign select_3930 = left_first_s3_q ? done_s3_q : proven_q;
  // hls/stages/agreement.hpp:272
  logic select_3932;
  assign select_3932 = left_first_s3_q ? done_s3_q : (and_1879_s3_q ? select_3930 : proven_q);
  // hls/stages/agreement.hpp:1279
  logic [1:0] select_3983;
  assign select_3983 = and_3982_s3_q ? {and_2035, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1280
  logic and_3984;
  assign and_3984 = select_3930 & less_3960;
  // hls/stages/agreement.hpp:431
  logic select_3987;
  assign select_3987 = and_1962_s3_q ? (less_1963_s3_q ? (select_3983[0] & and_3984) : seen_q) : seen_q;
  // hls/stages/agreement.hpp:272
  logic select_3989;
  assign select_3989 = left_first_s3_q ? select_3987 : (and_1879_s3_q ? select_3987 : seen_q);
  logic select_3990;
  assign select_3990 = and_1879_s3_q ? select_3989 : seen_q;
  // hls/stages/agreement.hpp:431
  logic select_3993;
  assign select_3993 = and_1962_s3_q ? (less_1963_s3_q ? (select_3983[1] & and_3984) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:272
  logic select_3995;
  assign select_3995 = left_first_s3_q ? select_3993 : (and_1879_s3_q ? select_3993 : nearer_q);
  logic select_3996;
  assign select_3996 = and_1879_s3_q ? select_3995 : nearer_q;
  // hls/stages/agreement.hpp:1211
  logic or_4004;
  assign or_4004 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | (~proven_q);
  // hls/stages/agreement.hpp:1213
  logic not_4012;
  assign not_4012 = ~(or_3744 | not_3997);
  // hls/stages/agreement.hpp:780
  logic and_4016;
  assign and_4016 = equal_1487_s3_q & (equal_3625_s3_q & (not_4012 & (select_3752 | select_3817)));
  logic and_4019;
  assign and_4019 = equal_3625_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1122
  logic or_4023;
  assign or_4023 = select_2288 | (select_2300 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:780
  logic and_4030;
  assign and_4030 = equal_1487_s3_q & (equal_3625_s3_q & (not_4012 & (select_2294 | select_2306)));
  // hls/stages/agreement.hpp:1122
  logic and_4035;
  assign and_4035 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3780 < cfg_hidden_frames_i));
  logic select_4041;
  assign select_4041 = (not_3997 | (select_3823 & not_3657)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:780
  logic and_4047;
  assign and_4047 = equal_1487_s3_q & (x_s3_q[6] & (not_1898_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1116
  logic [31:0] select_4055;
  assign select_4055 = equal_1550_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4053_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4056;
  assign select_4056 = equal_1548_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4055;
  logic [31:0] select_4057;
  assign select_4057 = equal_1546_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4056;
  logic [31:0] select_4058;
  assign select_4058 = equal_1544_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4057;
  logic [31:0] select_4059;
  assign select_4059 = equal_1542_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4058;
  logic [31:0] select_4060;
  assign select_4060 = equal_1540_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4059;
  logic [31:0] select_4061;
  assign select_4061 = equal_1538_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4060;
  logic [31:0] select_4062;
  assign select_4062 = equal_1536_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4061;
  // hls/stages/agreement.hpp:1114
  logic [9:0] select_4063;
  assign select_4063 = less_2484 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1118
  logic [31:0] select_4064;
  assign select_4064 = equal_1528_s3_q ? select_4062 : {2'h0, select_4063, select_2488, select_2485};

  // Memory fresh, write
  logic [5:0] fresh_waddr;
  assign fresh_waddr = column_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_522_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {census_columns_values_1_cell_2_of_skin_s3_q, and_637, and_613_s3_q, and_612_s3_q, and_587_s3_q, less_579_s3_q, less_578_s3_q, less_577_s3_q, less_576_s3_q, less_575_s3_q, less_574_s3_q, less_573_s3_q, less_572_s3_q, less_571_s3_q, less_570_s3_q, less_569_s3_q, less_568_s3_q, less_567_s3_q, less_566_s3_q, less_565_s3_q, less_564_s3_q, less_563_s3_q, less_562_s3_q, less_561_s3_q, less_560_s3_q, less_559_s3_q, less_558_s3_q, less_557_s3_q, less_556_s3_q};
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
  assign registration_sums_waddr = {sum_1534_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_1593_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (registration_sums_we) registration_sums_mem[registration_sums_waddr] <= {sum_1592, sum_1588};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_1622_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_1697_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_choices_we) patches_choices_mem[patches_choices_waddr] <= {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_1690_s3_q};
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
  assign patches_right_0_waddr = {select_1728_s3_q, select_1725};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_1737);
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
  assign patches_right_1_waddr = {select_1728_s3_q, select_1754};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_1757);
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
  assign patches_left_waddr = {select_1776, select_1775_s3_q, column_5};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_1782);
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
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= select_1886;
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
  assign regions_waddr = {region_row_s3_q, or_1896_s3_q, or_1893_s3_q, or_1890_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_1930_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (regions_we) regions_mem[regions_waddr] <= {sum_1929, sum_1919, sum_1914};
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
  assign map_waddr = sum_1971_s3_q;
  logic map_we;
  assign map_we = s3_en & and_2045_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (map_we) map_mem[map_waddr] <= {and_2035, is_seen};
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
      patches_frame_ended_q <= 1'b0;
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
      census_left_misses_q <= select_2194;
      sharpness_before_last_mask_q <= select_2202;
      sharpness_sums_detail_0_q <= and_522_s3_q ? select_2216 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_522_s3_q ? select_2228 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_522_s3_q ? sum_2232 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_522_s3_q ? sum_2236 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2254 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2264 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2266 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2268 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2270 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2272 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2277;
      sharpness_comparing_carry_1_q <= select_2281;
      sharpness_comparing_less_detail_0_q <= select_2288;
      sharpness_comparing_less_detail_1_q <= select_2294;
      sharpness_comparing_less_contrast_0_q <= select_2300;
      sharpness_comparing_less_contrast_1_q <= select_2306;
      counts_supervised_q <= select_2442;
      counts_textured_q <= and_2434_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_2445});
      counts_explained_q <= and_2434_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_2450});
      counts_nearer_q <= and_2434_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_2455});
      counts_unproven_q <= and_2434_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_2481});
      counts_regions_bad_q <= select_2497;
      counts_skin_supervised_q <= select_2504;
      counts_skin_textured_q <= select_2511;
      counts_skin_unproven_q <= select_2519;
      counts_on_skin_q <= select_2538;
      registration_half_across_q <= select_2592;
      registration_half_measured_q <= select_2597;
      registration_half_votes_down_q <= and_2570_s3_q ? 7'h0 : sum_2603;
      registration_half_votes_up_q <= and_2570_s3_q ? 7'h0 : sum_2611;
      registration_half_half_votes_down_q <= and_2570_s3_q ? 7'h0 : sum_2618;
      registration_half_half_votes_up_q <= and_2570_s3_q ? 7'h0 : sum_2625;
      registration_down_q <= and_2659 ? sum_2678 : registration_down_q;
      registration_up_q <= and_2659 ? sum_2687 : registration_up_q;
      registration_enough_q <= select_2701;
      registration_votes_down_q <= and_2706 ? less_2707 : registration_votes_down_q;
      registration_votes_up_q <= and_2706 ? less_2709 : registration_votes_up_q;
      registration_other_enough_q <= and_2715 ? select_2701 : registration_other_enough_q;
      registration_other_down_q <= and_2715 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_2715 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1487_s3_q & and_2722)) & or_2747;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_1716 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_1718 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_1719 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_2831;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_1745 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_1747 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_1748 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_2836;
      patches_valid_0_q <= select_2841;
      patches_valid_1_q <= select_2846;
      patches_right_next_0_q <= select_2849;
      patches_right_next_1_q <= select_2852;
      patches_left_next_0_q <= select_2855;
      patches_left_next_1_q <= select_2858;
      patches_sums_values_0_q <= select_3282;
      patches_sums_values_1_q <= equal_1698_s3_q ? patches_sums_values_1_q : select_3283;
      patches_sums_values_2_q <= equal_1698_s3_q ? patches_sums_values_2_q : select_3285;
      patches_sums_values_3_q <= equal_1698_s3_q ? patches_sums_values_3_q : select_3287;
      patches_sums_values_4_q <= equal_1698_s3_q ? patches_sums_values_4_q : select_3289;
      patches_sums_values_5_q <= equal_1698_s3_q ? patches_sums_values_5_q : select_3291;
      patches_sums_values_6_q <= equal_1698_s3_q ? patches_sums_values_6_q : select_3293;
      patches_sums_values_7_q <= equal_1698_s3_q ? patches_sums_values_7_q : select_3295;
      patches_sums_values_8_q <= equal_1698_s3_q ? patches_sums_values_8_q : select_3297;
      patches_sums_values_9_q <= equal_1698_s3_q ? patches_sums_values_9_q : select_3299;
      patches_sums_values_10_q <= equal_1698_s3_q ? patches_sums_values_10_q : select_3301;
      patches_sums_values_11_q <= equal_1698_s3_q ? patches_sums_values_11_q : select_3303;
      patches_sums_values_12_q <= equal_1698_s3_q ? patches_sums_values_12_q : select_3305;
      patches_sums_values_13_q <= equal_1698_s3_q ? patches_sums_values_13_q : select_3307;
      patches_sums_values_14_q <= equal_1698_s3_q ? patches_sums_values_14_q : select_3309;
      patches_sums_values_15_q <= equal_1698_s3_q ? patches_sums_values_15_q : select_3311;
      patches_sums_values_16_q <= equal_1698_s3_q ? patches_sums_values_16_q : select_3313;
      patches_best_differing_q <= select_1886[9:0];
      patches_best_column_q <= select_1886[14:10];
      patches_quarters_0_places_q <= sum_3437;
      patches_quarters_0_up_q <= sum_3477;
      patches_quarters_0_down_q <= sum_3487;
      patches_quarters_1_places_q <= sum_3491;
      patches_quarters_1_up_q <= sum_3494;
      patches_quarters_1_down_q <= sum_3497;
      patches_quarters_2_places_q <= sum_3501;
      patches_quarters_2_up_q <= sum_3504;
      patches_quarters_2_down_q <= sum_3507;
      patches_quarters_3_places_q <= sum_3511;
      patches_quarters_3_up_q <= sum_3514;
      patches_quarters_3_down_q <= sum_3517;
      patches_word_places_q <= or_3545;
      patches_word_up_q <= ((select_3555 | select_3557) | select_3560) | select_3563;
      patches_word_down_q <= ((select_3566 | select_3568) | select_3571) | select_3574;
      patches_sum_places_q <= select_3584;
      patches_sum_up_q <= select_3587;
      patches_sum_down_q <= select_3590;
      patches_across_q <= sum_3602;
      patches_places_q <= select_3613;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_3617;
      patches_partly_q <= or_3620;
      patches_clear_limit_q <= sum_3621[8:2];
      patches_complete_q <= select_3623;
      patches_frame_ended_q <= and_3628;
      patches_round_ends_q <= patches_complete_q & and_3628;
      patches_found_q <= and_3606 ? select_3632 : patches_found_q;
      patches_doubted_q <= select_3639;
      patches_doubted_before_q <= select_3640;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_3644;
      patches_on_skin_q <= sum_3654;
      patches_on_skin_most_q <= product_3655[12:5];
      patches_large_q <= not_3657 & and_3661;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_3666;
      patches_spoiled_q <= or_3670;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_3677;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_3687;
      segment_textured_q <= select_1911 + {5'h0, and_2445};
      segment_explained_q <= select_1916 + {5'h0, and_2450};
      segment_nearer_q <= select_1926 + {5'h0, and_2455};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1487_s3_q ? select_3760 : good_q;
      good_known_q <= select_3764;
      hidden_for_q <= select_3782;
      product_q <= equal_1487_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_3807;
      disagree_q <= equal_1487_s3_q ? select_3752 : disagree_q;
      too_much_q <= equal_1487_s3_q ? select_3817 : too_much_q;
      hides_q <= equal_1487_s3_q ? select_3777 : hides_q;
      overlooks_q <= equal_1487_s3_q ? select_3823 : overlooks_q;
      proven_q <= and_1879_s3_q ? select_3932 : proven_q;
      seen_q <= select_3990;
      nearer_q <= select_3996;
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
      averager_quarter_1_0_q <= select_2069;
      averager_quarter_1_1_q <= select_2071;
      averager_quarter_2_0_q <= select_2073;
      averager_quarter_2_1_q <= select_2075;
      averager_detail_0_q <= select_2087;
      averager_detail_1_q <= select_2095;
      census_changes_values_0_left_q <= and_522_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_522_s3_q ? sum_2178 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2180;
      census_changes_values_1_right_q <= select_2181;
      census_changes_values_2_left_q <= select_2182;
      census_changes_values_2_right_q <= select_2183;
      sharpness_last_mask_q <= and_522_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_522_s3_q ? select_2199[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_522_s3_q ? select_2199[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_3827;
      box_textured_columns_values_1_q <= select_3830;
      box_textured_columns_values_2_q <= select_3833;
      box_textured_columns_values_3_q <= select_3836;
      box_textured_columns_values_4_q <= select_3839;
      box_textured_sum_sums_values_0_q <= equal_1487_s3_q ? box_textured_sum_sums_values_0_q : select_3841;
      box_explained_columns_values_0_q <= select_3845;
      box_explained_columns_values_1_q <= select_3848;
      box_explained_columns_values_2_q <= select_3851;
      box_explained_columns_values_3_q <= select_3854;
      box_explained_columns_values_4_q <= select_3857;
      box_explained_sum_sums_values_0_q <= select_3860;
      box_shown_columns_values_0_q <= equal_1487_s3_q ? box_shown_columns_values_0_q : select_3862;
      box_shown_columns_values_1_q <= select_3866;
      box_shown_columns_values_2_q <= select_3869;
      box_shown_columns_values_3_q <= select_3872;
      box_shown_columns_values_4_q <= select_3875;
      box_shown_sum_sums_values_0_q <= equal_1487_s3_q ? box_shown_sum_sums_values_0_q : select_3877;
      box_nearer_columns_values_0_q <= equal_1487_s3_q ? box_nearer_columns_values_0_q : select_3880;
      box_nearer_columns_values_1_q <= select_3884;
      box_nearer_columns_values_2_q <= select_3887;
      box_nearer_columns_values_3_q <= select_3890;
      box_nearer_columns_values_4_q <= select_3893;
      box_nearer_sum_sums_values_0_q <= equal_1487_s3_q ? box_nearer_sum_sums_values_0_q : select_3895;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_3934_s4_q;
  logic or_3998_s4_q;
  logic and_3999_s4_q;
  logic and_4007_s4_q;
  logic and_4010_s4_q;
  logic and_4016_s4_q;
  logic and_4020_s4_q;
  logic and_4026_s4_q;
  logic and_4030_s4_q;
  logic and_4038_s4_q;
  logic and_4043_s4_q;
  logic and_4047_s4_q;
  logic [5:0] select_4049_s4_q;
  logic [31:0] select_4066_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= marks_last_s3_q;
      and_3934_s4_q <= said_q;
      or_3998_s4_q <= not_3997 | select_3990;
      and_3999_s4_q <= cfg_prove_i & select_3996;
      and_4007_s4_q <= equal_1487_s3_q & (equal_3625_s3_q & (cfg_prove_i & or_4004));
      and_4010_s4_q <= equal_1487_s3_q & (equal_3625_s3_q & (cfg_prove_i & or_3744));
      and_4016_s4_q <= and_4016;
      and_4020_s4_q <= equal_1487_s3_q & and_4019;
      and_4026_s4_q <= equal_1487_s3_q & (equal_3625_s3_q & (not_4012 & or_4023));
      and_4030_s4_q <= and_4030;
      and_4038_s4_q <= equal_1487_s3_q & (equal_3625_s3_q & (cfg_prove_i & and_4035));
      and_4043_s4_q <= equal_1487_s3_q & (equal_3625_s3_q & select_4041);
      and_4047_s4_q <= and_4047;
      select_4049_s4_q <= equal_1487_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4066_s4_q <= equal_1487_s3_q ? (x_s3_q[6] ? select_4064 : 32'h0) : 32'h0;
    end
  end

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_3998_s4_q;
  assign marks_nearer_o = and_3999_s4_q;
  assign verdict_valid_o = and_3934_s4_q;
  assign verdict_unproven_yet_o = and_4007_s4_q;
  assign verdict_untextured_o = and_4010_s4_q;
  assign verdict_disagree_o = and_4016_s4_q;
  assign verdict_moved_o = and_4020_s4_q;
  assign verdict_unsharp_left_o = and_4026_s4_q;
  assign verdict_unsharp_right_o = and_4030_s4_q;
  assign verdict_hidden_o = and_4038_s4_q;
  assign verdict_overlooked_o = and_4043_s4_q;
  assign frame_valid_o = and_4047_s4_q;
  assign frame_index_o = select_4049_s4_q;
  assign frame_word_o = select_4066_s4_q;
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
  assign unused_bits = ^{over[13:0], product_3655[4:0], sum_3621[1:0], sum_3576[1:0], product_3467[4:0], sum_2560[0], difference_2525[1:0], detail_4[1:0], detail_3[1:0], sum_2188[4:0], sum_1638[0], sum_1634[0], sum_635[4:0], cfg_compete_i, cfg_width_i[2:0]};

endmodule
