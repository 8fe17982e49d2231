// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 4 enabled clocks, one beat a clock. en_i = 0: nothing changes. State, memories and outputs
// change only with a valid beat. rst_ni is synchronous and keeps memories.
// State 3072 bits, pipeline 860 bits, memories 127160 bits.
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
  input  logic [4:0] cfg_on_skin_limit_i,
  input  logic [7:0] cfg_on_skin_cells_i,
  input  logic cfg_alarm_before_i,
  input  logic cfg_same_table_i,
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
  logic not_2791;
  assign not_2791 = ~cfg_prove_i;
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[9:3]} + 8'hff;
  logic [5:0] sum_3001;
  assign sum_3001 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_4045;
  assign difference_4045 = 7'h0 - {1'b0, cfg_patch_limit_i};
  logic not_4259;
  assign not_4259 = ~(cfg_on_skin_limit_i == 5'h1f);
  logic [6:0] difference_4316;
  assign difference_4316 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_4532;
  assign less_4532 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_4533;
  assign sum_4533 = {2'h0, cfg_height_i[8:6]} + 5'h1f;

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
  logic [2:0] select_502;
  assign select_502 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_504;
  assign select_504 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:116
  logic [8:0] select_507;
  assign select_507 = ({select_504, select_502} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:117
  logic [8:0] select_508;
  assign select_508 = select_502[0] ? averager_place_q : select_507;
  // hls/stages/census.hpp:42
  logic or_509;
  assign or_509 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:418
  logic and_512;
  assign and_512 = (select_502[0] & or_509) & (select_508[8:6] < 3'h5);
  // hls/stages/census.hpp:42
  logic [2:0] select_517;
  assign select_517 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:276
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_504 : 7'h0;
  // hls/stages/census.hpp:51
  logic equal_534;
  assign equal_534 = select_502 == 3'h7;
  // hls/stages/census.hpp:54
  logic equal_535;
  assign equal_535 = select_517 == 3'h7;
  // hls/stages/census.hpp:127
  logic and_536;
  assign and_536 = equal_535 & and_512;
  // hls/stages/agreement.hpp:276
  logic and_538;
  assign and_538 = sample_pair_whole_q & (equal_534 & and_536);
  // hls/stages/agreement.hpp:196
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:624
  logic equal_567;
  assign equal_567 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:595
  logic or_568;
  assign or_568 = so | equal_567;
  // hls/stages/agreement.hpp:593
  logic [7:0] sum_569;
  assign sum_569 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:595
  logic [7:0] select_570;
  assign select_570 = run_shift_q[5] ? x_q : sum_569;
  logic less_571;
  assign less_571 = {1'b0, last_q} < select_570;
  // hls/stages/agreement.hpp:226
  logic not_572;
  assign not_572 = ~less_571;
  // hls/stages/agreement.hpp:615
  logic equal_582;
  assign equal_582 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:616
  logic equal_583;
  assign equal_583 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:149
  logic and_584;
  assign and_584 = equal_583 & not_572;
  logic select_586;
  assign select_586 = or_568 ? not_572 : (equal_582 ? not_572 : and_584);
  // hls/stages/agreement.hpp:799
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:149
  logic and_604;
  assign and_604 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_570)));
  logic and_605;
  assign and_605 = equal_582 & and_604;
  logic select_606;
  assign select_606 = or_568 ? not_572 : and_605;
  // hls/stages/agreement.hpp:822
  logic [6:0] right;
  assign right = sum_569[6:0] + 7'h7d;
  // hls/stages/agreement.hpp:595
  logic not_636;
  assign not_636 = ~or_568;
  // hls/stages/agreement.hpp:149
  logic and_639;
  assign and_639 = not_636 & ((~equal_582) & and_584);
  // hls/stages/census.hpp:42
  logic [5:0] select_666;
  assign select_666 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_666 : 6'h0;
  // hls/stages/patches.hpp:122
  logic and_2138;
  assign and_2138 = (select_502 == 3'h0) & (select_504 == 7'h0);
  // hls/stages/patches.hpp:392
  logic not_2139;
  assign not_2139 = ~patches_begins_q;
  // hls/stages/census.hpp:32
  logic not_2142;
  assign not_2142 = ~sample_pair_first_q;
  // hls/stages/patches.hpp:362
  logic and_2143;
  assign and_2143 = patches_capturing_q & not_2142;
  // hls/stages/patches.hpp:364
  logic equal_2144;
  assign equal_2144 = {or_509, select_517} == 4'hc;
  // hls/stages/patches.hpp:311
  logic equal_2146;
  assign equal_2146 = patches_band_rows_rows_to_next_q == 4'h0;
  // hls/stages/patches.hpp:125
  logic and_2151;
  assign and_2151 = (not_2139 & (patches_work_q == 3'h0)) & (~(and_2143 | ((~equal_2144) | (~equal_2146))));
  // hls/stages/patches.hpp:530
  logic equal_2242;
  assign equal_2242 = patches_work_q == 3'h4;
  // hls/stages/patches.hpp:508
  logic not_2243;
  assign not_2243 = ~equal_2242;
  // hls/stages/patches.hpp:501
  logic equal_2244;
  assign equal_2244 = patches_work_q == 3'h3;
  // hls/stages/patches.hpp:454
  logic not_2245;
  assign not_2245 = ~equal_2244;
  // hls/stages/patches.hpp:495
  logic equal_2246;
  assign equal_2246 = patches_work_q == 3'h2;
  // hls/stages/patches.hpp:167
  logic equal_2247;
  assign equal_2247 = patches_work_q == 3'h1;
  // hls/stages/patches.hpp:530
  logic or_2248;
  assign or_2248 = equal_2246 | equal_2247;
  // hls/stages/patches.hpp:456
  logic not_2249;
  assign not_2249 = ~patches_second_q;
  // hls/stages/patches.hpp:373
  logic [4:0] select_2271;
  assign select_2271 = and_2151 ? 5'h0 : (patches_row_q + 5'h1);
  // hls/stages/patches.hpp:126
  logic [4:0] select_2272;
  assign select_2272 = and_2138 ? select_2271 : patches_row_q;
  // hls/stages/patches.hpp:125
  logic and_2274;
  assign and_2274 = and_2143 & (patches_row_q == 5'h1f);
  // hls/stages/patches.hpp:126
  logic select_2278;
  assign select_2278 = and_2138 ? (and_2151 | (and_2143 & (~and_2274))) : patches_capturing_q;
  // hls/stages/patches.hpp:184
  logic and_2286;
  assign and_2286 = not_2243 & (not_2245 & (or_2248 & (patches_second_q & equal_2247)));
  // hls/stages/patches.hpp:167
  logic not_2303;
  assign not_2303 = ~equal_2247;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_2319;
  assign select_2319 = and_2138 ? {select_2271[4], select_2271[2:0]} : {patches_row_q[4], patches_row_q[2:0]};
  // hls/stages/patches.hpp:454
  logic and_2329;
  assign and_2329 = not_2243 & (or_2248 & not_2245);
  // hls/stages/agreement.hpp:276
  logic [2:0] select_2586;
  assign select_2586 = sample_pair_whole_q ? (sample_last_q ? (select_517 + 3'h1) : select_517) : raster_at_y_q;
  logic [6:0] select_2588;
  assign select_2588 = sample_pair_whole_q ? (select_504 + {6'h0, equal_534}) : raster_at_column_q;
  logic [5:0] select_2591;
  assign select_2591 = sample_pair_whole_q ? (sample_last_q ? (select_666 + {5'h0, equal_535}) : select_666) : raster_at_row_q;
  logic select_2595;
  assign select_2595 = sample_pair_whole_q ? (sample_last_q ? (or_509 & (~raster_final_row_q)) : or_509) : raster_at_live_q;
  // hls/stages/census.hpp:50
  logic [8:0] select_2597;
  assign select_2597 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:276
  logic select_2601;
  assign select_2601 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:460
  logic equal_2910;
  assign equal_2910 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:465
  logic and_2911;
  assign and_2911 = and_538 & equal_2910;
  // hls/stages/agreement.hpp:524
  logic select_2914;
  assign select_2914 = (and_2911 | (~ends_cell_q)) ? and_2911 : ends_q;
  // hls/stages/agreement.hpp:530
  logic [2:0] now;
  assign now = select_2914 ? (and_2911 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:535
  logic [5:0] select_2918;
  assign select_2918 = select_2914 ? (and_2911 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_2921;
  assign select_2921 = select_2914 ? (following_last_shift_q & (~and_2911)) : run_last_shift_q;
  // hls/stages/agreement.hpp:608
  logic and_2924;
  assign and_2924 = run_last_shift_q & equal_582;
  // hls/stages/agreement.hpp:617
  logic select_2926;
  assign select_2926 = equal_582 ? (~run_last_shift_q) : equal_583;
  // hls/stages/agreement.hpp:621
  logic equal_2927;
  assign equal_2927 = run_phase_q == 3'h1;
  logic not_2930;
  assign not_2930 = ~select_2926;
  // hls/stages/agreement.hpp:624
  logic equal_2932;
  assign equal_2932 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:608
  logic and_2933;
  assign and_2933 = final_row_q & so;
  // hls/stages/agreement.hpp:621
  logic [1:0] select_2934;
  assign select_2934 = equal_2932 ? 2'h1 : {2{and_2933}};
  logic [2:0] select_2936;
  assign select_2936 = (and_2924 | (select_2926 | equal_2927)) ? (equal_2927 ? 3'h2 : {not_2930, {2{select_2926}}}) : (equal_567 ? 3'h6 : {select_2934[0], select_2934});
  // hls/stages/agreement.hpp:608
  logic and_2939;
  assign and_2939 = select_2926 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:631
  logic [6:0] value;
  assign value = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2942;
  assign select_2942 = (plan_shift_q[5] & select_2926) ? value : 7'h0;
  logic [1:0] or_2943;
  assign or_2943 = {2{so}} | select_2942[5:4];
  // hls/stages/agreement.hpp:634
  logic [7:0] or_2947;
  assign or_2947 = (select_2926 ? plan_columns_q : 8'h0) | ((equal_2927 | equal_2932) ? whole_q : 8'h0);
  logic [1:0] or_2948;
  assign or_2948 = {2{and_2924}} | or_2947[3:2];
  // hls/stages/agreement.hpp:635
  logic [7:0] or_2950;
  assign or_2950 = {or_2947[7:4], or_2948, or_2947[1:0]} | (equal_567 ? drawn_q : 8'h0);
  logic [4:0] or_2951;
  assign or_2951 = {5{so}} | {or_2950[6], or_2950[3:0]};
  // hls/stages/agreement.hpp:641
  logic not_2955;
  assign not_2955 = ~run_shift_q[5];
  logic [7:0] select_2958;
  assign select_2958 = equal_582 ? ({{7{not_2955}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:524
  logic [6:0] select_2962;
  assign select_2962 = and_2911 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:527
  logic [7:0] select_2964;
  assign select_2964 = select_2914 ? {select_2962[6], select_2962} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_2967;
  assign select_2967 = select_2914 ? (and_2911 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:521
  logic [6:0] select_2975;
  assign select_2975 = and_538 ? (equal_2910 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_2978;
  assign select_2978 = and_538 ? (equal_2910 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_2981;
  assign select_2981 = and_538 ? (equal_2910 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:532
  logic select_2992;
  assign select_2992 = (ends_cell_q | select_2914) ? (~(now == 3'h6)) : (equal_582 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:527
  logic and_2996;
  assign and_2996 = (~select_2914) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:477
  logic [6:0] sum_2997;
  assign sum_2997 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:461
  logic select_2999;
  assign select_2999 = equal_2910 ? ({sum_2997[6], cfg_height_i[8:3]} == {1'b0, sum_2997[5:0]}) : final_row_q;
  // hls/stages/patches.hpp:317
  logic [3:0] phase;
  assign phase = (patches_phase_q == 4'h6) ? 4'h0 : (patches_phase_q + 4'h1);
  // hls/stages/patches.hpp:126
  logic [3:0] select_3358;
  assign select_3358 = and_2138 ? (sample_pair_first_q ? phase : patches_phase_q) : patches_phase_q;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3359;
  assign select_3359 = sample_pair_whole_q ? select_3358 : patches_phase_q;
  // hls/stages/patches.hpp:373
  logic and_3360;
  assign and_3360 = not_2142 & equal_2144;
  logic [8:0] select_3361;
  assign select_3361 = and_3360 ? {patches_choosing_number_q, patches_choosing_rows_to_next_q} : {4'h0, patches_first_band_number_q, patches_first_band_rows_to_next_q};
  logic [8:0] select_3362;
  assign select_3362 = and_3360 ? {patches_next_band_number_q, patches_next_band_rows_to_next_q} : {patches_band_rows_number_q, patches_band_rows_rows_to_next_q};
  logic [8:0] select_3363;
  assign select_3363 = sample_pair_first_q ? select_3361 : select_3362;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3365;
  assign select_3365 = sample_pair_whole_q ? (and_2138 ? select_3363[3:0] : patches_band_rows_rows_to_next_q) : patches_band_rows_rows_to_next_q;
  logic [4:0] select_3367;
  assign select_3367 = sample_pair_whole_q ? (and_2138 ? select_3363[8:4] : patches_band_rows_number_q) : patches_band_rows_number_q;
  logic [3:0] select_3370;
  assign select_3370 = sample_pair_whole_q ? (equal_2146 ? 4'h6 : (patches_band_rows_rows_to_next_q + 4'hf)) : patches_next_band_rows_to_next_q;
  logic [4:0] select_3372;
  assign select_3372 = sample_pair_whole_q ? (patches_band_rows_number_q + {4'h0, equal_2146}) : patches_next_band_number_q;
  // hls/stages/patches.hpp:330
  logic equal_3373;
  assign equal_3373 = phase[3:1] == 3'h0;
  // hls/stages/patches.hpp:331
  logic not_3374;
  assign not_3374 = ~equal_3373;
  // hls/stages/agreement.hpp:276
  logic [3:0] select_3376;
  assign select_3376 = sample_pair_whole_q ? (phase + {not_3374, 1'b1, not_3374, equal_3373}) : patches_first_band_rows_to_next_q;
  // hls/stages/agreement.hpp:471
  logic equal_3378;
  assign equal_3378 = row == 6'h3;
  // hls/stages/patches.hpp:87
  logic [3:0] select_3382;
  assign select_3382 = equal_3378 ? ((select_3359 == 4'h6) ? 4'h0 : (select_3359 + 4'h1)) : patches_choosing_rows_to_next_q;
  logic equal_3383;
  assign equal_3383 = select_3382 == 4'h0;
  // hls/stages/agreement.hpp:461
  logic [3:0] select_3386;
  assign select_3386 = equal_2910 ? (equal_3383 ? 4'h6 : (select_3382 + 4'hf)) : patches_choosing_rows_to_next_q;
  // hls/stages/patches.hpp:87
  logic [4:0] select_3388;
  assign select_3388 = equal_3378 ? 5'h0 : patches_choosing_number_q;
  // hls/stages/agreement.hpp:461
  logic [4:0] select_3390;
  assign select_3390 = equal_2910 ? (select_3388 + {4'h0, equal_3383}) : patches_choosing_number_q;
  // hls/stages/agreement.hpp:521
  logic select_3395;
  assign select_3395 = and_538 ? (equal_2910 ? ((6'h2 < row) & equal_3383) : patches_chooses_q) : patches_chooses_q;
  logic [4:0] select_3397;
  assign select_3397 = and_538 ? (equal_2910 ? select_3388 : patches_choosing_band_q) : patches_choosing_band_q;
  // hls/stages/patches.hpp:371
  logic or_3421;
  assign or_3421 = select_504[0] | select_666[5];
  logic [7:0] sum_3422;
  assign sum_3422 = {1'b0, select_504[2:1], or_3421, select_666[4:1]} + 8'h1;
  logic less_3423;
  assign less_3423 = {sum_3422, select_666[0], select_517, 1'b0} < {4'h0, cfg_height_i};
  // hls/stages/patches.hpp:126
  logic select_3426;
  assign select_3426 = and_2138 ? (and_2151 ? (~less_3423) : patches_lower_q) : patches_lower_q;
  // hls/stages/patches.hpp:393
  logic or_3465;
  assign or_3465 = patches_begins_q | patches_ends_q;
  // hls/stages/patches.hpp:395
  logic [2:0] following;
  assign following = patches_begins_q ? 3'h1 : patches_following_q;
  // hls/stages/patches.hpp:187
  logic and_3471;
  assign and_3471 = equal_2242 & not_2249;
  // hls/stages/patches.hpp:399
  logic and_3472;
  assign and_3472 = not_2303 & and_3471;
  logic [1:0] select_3474;
  assign select_3474 = equal_2244 ? 2'h0 : (equal_2246 ? 2'h3 : {equal_2247, and_3472});
  // hls/stages/patches.hpp:279
  logic equal_3476;
  assign equal_3476 = patches_following_q == 3'h4;
  // hls/stages/patches.hpp:277
  logic not_3477;
  assign not_3477 = ~equal_3476;
  // hls/stages/patches.hpp:279
  logic equal_3478;
  assign equal_3478 = patches_following_q == 3'h3;
  // hls/stages/patches.hpp:275
  logic not_3479;
  assign not_3479 = ~equal_3478;
  // hls/stages/patches.hpp:283
  logic not_3481;
  assign not_3481 = ~(patches_following_q == 3'h2);
  logic and_3484;
  assign and_3484 = (~(patches_following_q == 3'h1)) & not_3481;
  // hls/stages/patches.hpp:397
  logic [1:0] select_3485;
  assign select_3485 = equal_3478 ? 2'h2 : {and_3484, not_3481};
  logic [3:0] select_3486;
  assign select_3486 = equal_3476 ? 4'h2 : {select_3485, {2{not_3479}}};
  // hls/stages/patches.hpp:405
  logic not_3489;
  assign not_3489 = ~or_3465;
  // hls/stages/patches.hpp:394
  logic [4:0] beats;
  assign beats = patches_begins_q ? 5'hf : patches_following_beats_q;
  // hls/stages/patches.hpp:406
  logic [11:0] select_3494;
  assign select_3494 = or_3465 ? {beats[4], beats[4:3], {2{beats[0]}}, beats[2], beats[2:0], beats[1:0], beats[0]} : (patches_remaining_q + 12'hfff);
  // hls/stages/patches.hpp:187
  logic [4:0] select_3496;
  assign select_3496 = or_3465 ? 5'h0 : (patches_code_row_q + {4'h0, patches_column_ends_q});

  // Memory fresh, 80 x 33 and parity, DISTANCE 12, hls/stages/agreement.hpp:1373; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [33:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 34'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_639;
  logic [33:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [32:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[32:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 85 and parity, DISTANCE 12, hls/stages/agreement.hpp:1374; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [85:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 86'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & select_586;
  logic [85:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [84:0] left_rdata_q;
  assign left_rdata_q = left_word_q[84:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 99 and parity, DISTANCE 12, hls/stages/agreement.hpp:1375; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [99:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 100'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = or_568 ? x_q[6:0] : (equal_582 ? sum_569[6:0] : x_q[6:0]);
  logic right_codes_re;
  assign right_codes_re = s0_en & select_586;
  logic [99:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [98:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[98:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 62 and parity, DISTANCE 12, hls/stages/agreement.hpp:1376; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [62:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 63'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_568 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_606;
  logic [62:0] best_left_word_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_word_q <= best_left_mem[best_left_raddr];
  end
  logic [61:0] best_left_rdata_q;
  assign best_left_rdata_q = best_left_word_q[61:0];
  logic best_left_read_q, best_left_error;
  always_ff @(posedge clk_i) best_left_read_q <= rst_ni & best_left_re;
  assign best_left_error = best_left_read_q & ^best_left_word_q;

  // Memory patches_right_0, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_0_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_0_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_0_raddr;
  assign patches_right_0_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_0_re;
  assign patches_right_0_re = s0_en & (not_2243 & (not_2245 & (or_2248 & (equal_2247 & not_2249))));
  logic [8:0] patches_right_0_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_0_re) patches_right_0_word_q <= patches_right_0_mem[patches_right_0_raddr];
  end
  logic [7:0] patches_right_0_rdata_q;
  assign patches_right_0_rdata_q = patches_right_0_word_q[7:0];
  logic patches_right_0_read_q, patches_right_0_error;
  always_ff @(posedge clk_i) patches_right_0_read_q <= rst_ni & patches_right_0_re;
  assign patches_right_0_error = patches_right_0_read_q & ^patches_right_0_word_q;

  // Memory patches_right_1, 1024 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:775; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_right_1_mem [0:1023];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 1024; i++) patches_right_1_mem[i] = 9'h0;
`endif
  logic [9:0] patches_right_1_raddr;
  assign patches_right_1_raddr = {patches_code_row_q, patches_column_q};
  logic patches_right_1_re;
  assign patches_right_1_re = s0_en & and_2286;
  logic [8:0] patches_right_1_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_1_re) patches_right_1_word_q <= patches_right_1_mem[patches_right_1_raddr];
  end
  logic [7:0] patches_right_1_rdata_q;
  assign patches_right_1_rdata_q = patches_right_1_word_q[7:0];
  logic patches_right_1_read_q, patches_right_1_error;
  always_ff @(posedge clk_i) patches_right_1_read_q <= rst_ni & patches_right_1_re;
  assign patches_right_1_error = patches_right_1_read_q & ^patches_right_1_word_q;

  // Memory patches_left, 512 x 8 and parity, DISTANCE 12, hls/stages/patches.hpp:776; read in stage 0, written in stage 3: 0 < 3 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [8:0] patches_left_mem [0:511];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 512; i++) patches_left_mem[i] = 9'h0;
`endif
  logic [8:0] patches_left_raddr;
  assign patches_left_raddr = {patches_second_q, patches_code_row_q[3:0], patches_column_q[3:0]};
  logic patches_left_re;
  assign patches_left_re = s0_en & (not_2243 & (not_2245 & (not_2303 & or_2248)));
  logic [8:0] patches_left_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_re) patches_left_word_q <= patches_left_mem[patches_left_raddr];
  end
  logic [7:0] patches_left_rdata_q;
  assign patches_left_rdata_q = patches_left_word_q[7:0];
  logic patches_left_read_q, patches_left_error;
  always_ff @(posedge clk_i) patches_left_read_q <= rst_ni & patches_left_re;
  assign patches_left_error = patches_left_read_q & ^patches_left_word_q;

  // Memory patches_columns_above, 32 x 32 and parity, DISTANCE 12, hls/stages/patches.hpp:787; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] patches_columns_above_mem [0:31];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 32; i++) patches_columns_above_mem[i] = 33'h0;
`endif
  logic [4:0] patches_columns_above_raddr;
  assign patches_columns_above_raddr = patches_column_q;
  logic patches_columns_above_re;
  assign patches_columns_above_re = s0_en & and_2329;
  logic [32:0] patches_columns_above_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_columns_above_re) patches_columns_above_word_q <= patches_columns_above_mem[patches_columns_above_raddr];
  end
  logic [31:0] patches_columns_above_rdata_q;
  assign patches_columns_above_rdata_q = patches_columns_above_word_q[31:0];
  logic patches_columns_above_read_q, patches_columns_above_error;
  always_ff @(posedge clk_i) patches_columns_above_read_q <= rst_ni & patches_columns_above_re;
  assign patches_columns_above_error = patches_columns_above_read_q & ^patches_columns_above_word_q;

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
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_502 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2586;
      raster_at_column_q <= select_2588;
      raster_at_row_q <= select_2591;
      raster_at_live_q <= select_2595;
      raster_rows_left_q <= sample_pair_whole_q ? select_2597 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2601;
      averager_place_q <= sample_pair_whole_q ? select_508 : averager_place_q;
      run_phase_q <= now;
      run_shift_q <= select_2918;
      run_last_shift_q <= select_2921;
      run_span_q <= select_2914 ? (and_2911 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2936;
      following_shift_q <= select_2926 ? plan_shift_q : 6'h0;
      following_last_shift_q <= and_2939;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2942[6], or_2943, select_2942[3:0]};
      following_columns_q <= {or_2950[7], or_2951[4], or_2950[5:4], or_2951[3:0]};
      plan_shift_q <= equal_582 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
      plan_span_q <= select_2958;
      plan_columns_q <= (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
      x_q <= select_2964;
      columns_left_q <= select_2967;
      last_q <= and_538 ? (equal_2910 ? column : last_q) : last_q;
      least_q <= select_2975;
      whole_q <= select_2978;
      drawn_q <= select_2981;
      age_q <= select_2914 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_2914 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_2992;
      ends_q <= and_2996;
      final_row_q <= and_538 ? select_2999 : final_row_q;
      shift_first_q <= {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
      patches_phase_q <= select_3359;
      patches_band_rows_rows_to_next_q <= select_3365;
      patches_band_rows_number_q <= select_3367;
      patches_next_band_rows_to_next_q <= select_3370;
      patches_next_band_number_q <= select_3372;
      patches_first_band_rows_to_next_q <= select_3376;
      patches_first_band_number_q <= sample_pair_whole_q ? equal_3373 : patches_first_band_number_q;
      patches_choosing_rows_to_next_q <= and_538 ? select_3386 : patches_choosing_rows_to_next_q;
      patches_choosing_number_q <= and_538 ? select_3390 : patches_choosing_number_q;
      patches_chooses_q <= select_3395;
      patches_choosing_band_q <= select_3397;
      patches_capturing_q <= sample_pair_whole_q ? select_2278 : patches_capturing_q;
      patches_lower_q <= sample_pair_whole_q ? select_3426 : patches_lower_q;
      patches_row_q <= sample_pair_whole_q ? select_2272 : patches_row_q;
      patches_work_q <= or_3465 ? following : patches_work_q;
      patches_second_q <= not_2139 & (patches_second_q | (patches_ends_q & equal_2242));
      patches_following_q <= equal_2242 ? {2'h0, and_3471} : {equal_2244, select_3474};
      patches_following_beats_q <= {select_3486, not_3477};
      patches_begins_q <= sample_pair_whole_q & (and_2138 & and_2274);
      patches_ends_q <= not_3489 & (patches_remaining_q == 12'h1);
      patches_remaining_q <= select_3494;
      patches_code_row_q <= select_3496;
      patches_column_q <= or_3465 ? 5'h0 : (patches_column_q + 5'h1);
      patches_column_ends_q <= not_3489 & (patches_column_q == 5'h1e);
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic mask_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_present_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [6:0] last_s1_q;
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
  logic [2:0] select_502_s1_q;
  logic [6:0] select_504_s1_q;
  logic [8:0] select_508_s1_q;
  logic and_512_s1_q;
  logic equal_518_s1_q;
  logic [6:0] column_s1_q;
  logic and_536_s1_q;
  logic and_538_s1_q;
  logic equal_563_s1_q;
  logic so_s1_q;
  logic equal_567_s1_q;
  logic or_568_s1_q;
  logic less_571_s1_q;
  logic not_572_s1_q;
  logic equal_582_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_606_s1_q;
  logic [6:0] right_s1_q;
  logic and_639_s1_q;
  logic [5:0] row_s1_q;
  logic and_2024_s1_q;
  logic equal_2025_s1_q;
  logic and_2138_s1_q;
  logic and_2151_s1_q;
  logic equal_2242_s1_q;
  logic not_2243_s1_q;
  logic equal_2244_s1_q;
  logic not_2245_s1_q;
  logic equal_2246_s1_q;
  logic equal_2247_s1_q;
  logic or_2248_s1_q;
  logic [4:0] select_2272_s1_q;
  logic select_2278_s1_q;
  logic [3:0] select_2319_s1_q;
  logic and_2329_s1_q;
  logic equal_2910_s1_q;
  logic and_2911_s1_q;
  logic or_3465_s1_q;
  logic not_3489_s1_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      mask_s1_q <= mask_i;
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
      select_502_s1_q <= select_502;
      select_504_s1_q <= select_504;
      select_508_s1_q <= select_508;
      and_512_s1_q <= and_512;
      equal_518_s1_q <= select_517 == 3'h0;
      column_s1_q <= column;
      and_536_s1_q <= and_536;
      and_538_s1_q <= and_538;
      equal_563_s1_q <= run_phase_q == 3'h7;
      so_s1_q <= so;
      equal_567_s1_q <= equal_567;
      or_568_s1_q <= or_568;
      less_571_s1_q <= less_571;
      not_572_s1_q <= not_572;
      equal_582_s1_q <= equal_582;
      x_s1_2_q <= x[6:0];
      select_606_s1_q <= select_606;
      right_s1_q <= right;
      and_639_s1_q <= and_639;
      row_s1_q <= row;
      and_2024_s1_q <= not_636 & and_605;
      equal_2025_s1_q <= {x[7], last_q} == {1'b0, x[6:0]};
      and_2138_s1_q <= and_2138;
      and_2151_s1_q <= and_2151;
      equal_2242_s1_q <= equal_2242;
      not_2243_s1_q <= not_2243;
      equal_2244_s1_q <= equal_2244;
      not_2245_s1_q <= not_2245;
      equal_2246_s1_q <= equal_2246;
      equal_2247_s1_q <= equal_2247;
      or_2248_s1_q <= or_2248;
      select_2272_s1_q <= select_2272;
      select_2278_s1_q <= select_2278;
      select_2319_s1_q <= select_2319;
      and_2329_s1_q <= and_2329;
      equal_2910_s1_q <= equal_2910;
      and_2911_s1_q <= and_2911;
      or_3465_s1_q <= or_3465;
      not_3489_s1_q <= not_3489;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
  logic [13:0] moments_place_q;
  logic moments_taken_q;
  logic moments_starts_q;
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
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  // hls/stages/census.hpp:120
  logic and_513;
  assign and_513 = sample_pair_whole_s1_q & and_512_s1_q;
  // hls/stages/agreement.hpp:669
  logic equal_557;
  assign equal_557 = row_q == 6'h0;
  // hls/stages/patches.hpp:106
  logic equal_558;
  assign equal_558 = x_s1_q == 8'h0;
  // hls/stages/agreement.hpp:259
  logic first;
  assign first = equal_557 & equal_558;
  // hls/stages/moments.hpp:57
  logic [13:0] select_561;
  assign select_561 = moments_starts_q ? 14'h1 : (moments_place_q + {13'h0, moments_taken_q});
  // hls/stages/agreement.hpp:789
  logic [12:0] select_562;
  assign select_562 = first ? 13'h0 : select_561[12:0];
  // hls/stages/agreement.hpp:1010
  logic not_564;
  assign not_564 = ~equal_563_s1_q;
  // hls/stages/agreement.hpp:201
  logic not_566;
  assign not_566 = ~so_s1_q;
  // hls/stages/agreement.hpp:226
  logic inside_v;
  assign inside_v = or_568_s1_q & not_572_s1_q;
  // hls/stages/moments.hpp:63
  logic [7:0] place;
  assign place = first ? 8'h0 : select_561[13:6];
  // hls/stages/moments.hpp:104
  logic not_576;
  assign not_576 = ~(8'h4a < place);
  // hls/stages/agreement.hpp:789
  logic and_580;
  assign and_580 = not_564 & (not_566 & (equal_567_s1_q & (inside_v & not_576)));
  // hls/stages/agreement.hpp:976
  logic and_596;
  assign and_596 = (or_568_s1_q & (left_rdata_q[67] & not_572_s1_q)) & (~(row_q[5:3] == 3'h0));
  // hls/stages/agreement.hpp:967
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:968
  logic [7:0] found;
  assign found = x_s1_q + {{2{shift[5]}}, shift};
  // hls/stages/agreement.hpp:969
  logic [6:0] select_615;
  assign select_615 = ({1'b0, last_s1_q} < found) ? 7'h0 : found[6:0];
  // hls/stages/agreement.hpp:669
  logic not_736;
  assign not_736 = ~equal_557;
  // hls/stages/agreement.hpp:672
  logic and_737;
  assign and_737 = left_rdata_q[12] & not_736;
  logic and_738;
  assign and_738 = left_rdata_q[30] & not_736;
  logic and_739;
  assign and_739 = left_rdata_q[48] & not_736;
  logic and_740;
  assign and_740 = left_rdata_q[66] & not_736;
  // hls/stages/agreement.hpp:673
  logic and_741;
  assign and_741 = right_codes_rdata_q[12] & not_736;
  logic and_742;
  assign and_742 = right_codes_rdata_q[27] & not_736;
  logic and_743;
  assign and_743 = right_codes_rdata_q[42] & not_736;
  logic and_744;
  assign and_744 = right_codes_rdata_q[57] & not_736;
  logic and_745;
  assign and_745 = right_codes_rdata_q[72] & not_736;
  logic and_746;
  assign and_746 = right_codes_rdata_q[85] & not_736;
  // hls/stages/agreement.hpp:221
  logic and_751;
  assign and_751 = left_rdata_q[48] & not_572_s1_q;
  logic and_752;
  assign and_752 = right_codes_rdata_q[42] & not_572_s1_q;
  logic [11:0] select_753;
  assign select_753 = less_571_s1_q ? 12'h0 : left_rdata_q[47:36];
  logic [11:0] select_754;
  assign select_754 = less_571_s1_q ? 12'h0 : right_codes_rdata_q[41:30];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_758;
  assign select_758 = and_751 ? (and_752 ? (~(select_753 ^ select_754)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_764;
  assign parity_764 = ^select_758[5:3];
  logic parity_767;
  assign parity_767 = ^select_758[8:6];
  logic parity_770;
  assign parity_770 = ^select_758[11:3];
  // hls/stages/agreement.hpp:221
  logic and_774;
  assign and_774 = left_rdata_q[66] & not_572_s1_q;
  logic and_775;
  assign and_775 = right_codes_rdata_q[57] & not_572_s1_q;
  logic [11:0] select_776;
  assign select_776 = less_571_s1_q ? 12'h0 : left_rdata_q[65:54];
  logic [11:0] select_777;
  assign select_777 = less_571_s1_q ? 12'h0 : right_codes_rdata_q[56:45];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_781;
  assign select_781 = and_774 ? (and_775 ? (~(select_776 ^ select_777)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_784;
  assign parity_784 = ^select_781[8:6];
  logic parity_787;
  assign parity_787 = ^select_781[11:9];
  // hls/stages/agreement.hpp:221
  logic and_791;
  assign and_791 = left_rdata_q[84] & not_572_s1_q;
  logic and_792;
  assign and_792 = right_codes_rdata_q[72] & not_572_s1_q;
  logic [11:0] select_793;
  assign select_793 = less_571_s1_q ? 12'h0 : left_rdata_q[83:72];
  logic [11:0] select_794;
  assign select_794 = less_571_s1_q ? 12'h0 : right_codes_rdata_q[71:60];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_798;
  assign select_798 = and_791 ? (and_792 ? (~(select_793 ^ select_794)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_804;
  assign parity_804 = ^select_798[2:0];
  logic parity_807;
  assign parity_807 = ^select_798[5:3];
  logic parity_810;
  assign parity_810 = ^select_798[8:0];
  logic parity_816;
  assign parity_816 = ^select_798[11:9];
  logic parity_819;
  assign parity_819 = ^select_781[2:0];
  logic parity_822;
  assign parity_822 = ^{select_798[11:9], select_781[5:0]};
  logic parity_825;
  assign parity_825 = ^{select_798, select_781, select_758[2:0]};
  logic xor_826;
  assign xor_826 = parity_770 ^ parity_825;
  // hls/stages/count_bits.hpp:23
  logic or_830;
  assign or_830 = (select_758[1:0] == 2'h3) | (select_758[2] & (select_758[0] | select_758[1]));
  // hls/stages/count_bits.hpp:25
  logic or_834;
  assign or_834 = (select_781[7:6] == 2'h3) | (select_781[8] & (select_781[6] | select_781[7]));
  logic or_838;
  assign or_838 = (select_781[10:9] == 2'h3) | (select_781[11] & (select_781[9] | select_781[10]));
  // hls/stages/count_bits.hpp:23
  logic or_846;
  assign or_846 = (select_798[7:6] == 2'h3) | (select_798[8] & (~(select_798[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_850;
  assign or_850 = (select_798[1:0] == 2'h3) | (select_798[2] & (select_798[0] | select_798[1]));
  logic or_854;
  assign or_854 = (select_798[4:3] == 2'h3) | (select_798[5] & (select_798[3] | select_798[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_857;
  assign parity_857 = ^{or_854, or_850, or_846};
  // hls/stages/count_bits.hpp:23
  logic or_861;
  assign or_861 = (select_781[4:3] == 2'h3) | (select_781[5] & (select_781[3] | select_781[4]));
  // hls/stages/count_bits.hpp:25
  logic or_865;
  assign or_865 = (select_798[10:9] == 2'h3) | (select_798[11] & (select_798[9] | select_798[10]));
  logic or_869;
  assign or_869 = (select_781[1:0] == 2'h3) | (select_781[2] & (select_781[0] | select_781[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_872;
  assign parity_872 = ^{or_869, or_865, or_861};
  logic parity_875;
  assign parity_875 = ^{or_869, or_865, or_861, or_854, or_850, or_846, or_838, or_834, or_830};
  // hls/stages/count_bits.hpp:25
  logic and_876;
  assign and_876 = parity_770 & parity_825;
  logic or_880;
  assign or_880 = (parity_764 & parity_767) | ((^select_758[11:9]) & (parity_764 | parity_767));
  logic and_883;
  assign and_883 = (^{select_781[11:6], select_758[2:0]}) & (parity_810 | parity_822);
  logic or_884;
  assign or_884 = (parity_810 & parity_822) | and_883;
  // hls/stages/count_bits.hpp:23
  logic or_891;
  assign or_891 = (select_758[10:9] == 2'h3) | (select_758[11] & (select_758[9] | select_758[10]));
  // hls/stages/count_bits.hpp:25
  logic or_895;
  assign or_895 = (select_758[4:3] == 2'h3) | (select_758[5] & (select_758[3] | select_758[4]));
  logic or_899;
  assign or_899 = (select_758[7:6] == 2'h3) | (select_758[8] & (select_758[6] | select_758[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_902;
  assign parity_902 = ^{or_899, or_895, or_891};
  // hls/stages/count_bits.hpp:25
  logic or_906;
  assign or_906 = (parity_784 & parity_787) | ((^select_758[2:0]) & (parity_784 | parity_787));
  logic or_910;
  assign or_910 = (parity_804 & parity_807) | ((^select_798[8:6]) & (parity_804 | parity_807));
  logic or_914;
  assign or_914 = (parity_816 & parity_819) | ((^select_781[5:3]) & (parity_816 | parity_819));
  // hls/stages/count_bits.hpp:24
  logic parity_917;
  assign parity_917 = ^{or_914, or_910, or_906};
  logic parity_920;
  assign parity_920 = ^{or_914, or_910, or_906, or_899, or_895, or_891, or_884, or_880, and_876};
  logic xor_921;
  assign xor_921 = parity_875 ^ parity_920;
  // hls/stages/count_bits.hpp:25
  logic and_922;
  assign and_922 = parity_875 & parity_920;
  logic or_926;
  assign or_926 = (parity_857 & parity_872) | ((^{or_838, or_834, or_830}) & (parity_857 | parity_872));
  logic or_930;
  assign or_930 = (parity_902 & parity_917) | ((^{or_884, or_880, and_876}) & (parity_902 | parity_917));
  logic or_937;
  assign or_937 = (or_834 & or_838) | (or_830 & (or_834 | or_838));
  logic or_941;
  assign or_941 = (or_850 & or_854) | (or_846 & (or_850 | or_854));
  logic or_945;
  assign or_945 = (or_865 & or_869) | (or_861 & (or_865 | or_869));
  // hls/stages/count_bits.hpp:24
  logic parity_948;
  assign parity_948 = ^{or_945, or_941, or_937};
  // hls/stages/count_bits.hpp:25
  logic or_952;
  assign or_952 = (or_880 & or_884) | (and_876 & (or_880 | or_884));
  logic or_956;
  assign or_956 = (or_895 & or_899) | (or_891 & (or_895 | or_899));
  logic or_960;
  assign or_960 = (or_910 & or_914) | (or_906 & (or_910 | or_914));
  // hls/stages/count_bits.hpp:24
  logic parity_963;
  assign parity_963 = ^{or_960, or_956, or_952};
  logic parity_966;
  assign parity_966 = ^{or_960, or_956, or_952, or_945, or_941, or_937, or_930, or_926, and_922};
  // hls/stages/count_bits.hpp:25
  logic or_970;
  assign or_970 = (parity_948 & parity_963) | ((^{or_930, or_926, and_922}) & (parity_948 | parity_963));
  logic or_974;
  assign or_974 = (or_926 & or_930) | (and_922 & (or_926 | or_930));
  logic or_978;
  assign or_978 = (or_941 & or_945) | (or_937 & (or_941 | or_945));
  logic or_982;
  assign or_982 = (or_956 & or_960) | (or_952 & (or_956 | or_960));
  // hls/stages/count_bits.hpp:24
  logic parity_987;
  assign parity_987 = ^{or_982, or_978, or_974, or_970};
  // hls/stages/count_bits.hpp:25
  logic or_991;
  assign or_991 = (or_978 & or_982) | (or_974 & (or_978 | or_982));
  logic and_992;
  assign and_992 = or_970 & (^{or_982, or_978, or_974});
  // hls/stages/count_bits.hpp:24
  logic xor_993;
  assign xor_993 = or_991 ^ and_992;
  // hls/stages/count_bits.hpp:27
  logic and_994;
  assign and_994 = or_991 & and_992;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_995;
  assign select_995 = equal_582_s1_q ? {and_994, xor_993, parity_987, parity_966, xor_921, xor_826} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_568_s1_q ? 6'h0 : select_995;
  // hls/stages/agreement.hpp:779
  logic [5:0] select_997;
  assign select_997 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_998;
  assign difference_998 = {1'b0, column_2} - {1'b0, select_997};
  logic [7:0] sum_1000;
  assign sum_1000 = {difference_998[6], difference_998} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1004;
  assign select_1004 = and_751 ? (and_775 ? (~(select_753 ^ select_777)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1010;
  assign parity_1010 = ^select_1004[5:3];
  logic parity_1013;
  assign parity_1013 = ^select_1004[8:6];
  logic parity_1016;
  assign parity_1016 = ^select_1004[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1023;
  assign select_1023 = and_774 ? (and_792 ? (~(select_776 ^ select_794)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1026;
  assign parity_1026 = ^select_1023[8:6];
  logic parity_1029;
  assign parity_1029 = ^select_1023[11:9];
  // hls/stages/agreement.hpp:221
  logic and_1033;
  assign and_1033 = right_codes_rdata_q[85] & not_572_s1_q;
  logic [11:0] select_1034;
  assign select_1034 = less_571_s1_q ? 12'h0 : right_codes_rdata_q[84:73];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1038;
  assign select_1038 = and_791 ? (and_1033 ? (~(select_793 ^ select_1034)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1044;
  assign parity_1044 = ^select_1038[2:0];
  logic parity_1047;
  assign parity_1047 = ^select_1038[5:3];
  logic parity_1050;
  assign parity_1050 = ^select_1038[8:0];
  logic parity_1056;
  assign parity_1056 = ^select_1038[11:9];
  logic parity_1059;
  assign parity_1059 = ^select_1023[2:0];
  logic parity_1062;
  assign parity_1062 = ^{select_1038[11:9], select_1023[5:0]};
  logic parity_1065;
  assign parity_1065 = ^{select_1038, select_1023, select_1004[2:0]};
  logic xor_1066;
  assign xor_1066 = parity_1016 ^ parity_1065;
  // hls/stages/count_bits.hpp:23
  logic or_1070;
  assign or_1070 = (select_1004[1:0] == 2'h3) | (select_1004[2] & (select_1004[0] | select_1004[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1074;
  assign or_1074 = (select_1023[7:6] == 2'h3) | (select_1023[8] & (select_1023[6] | select_1023[7]));
  logic or_1078;
  assign or_1078 = (select_1023[10:9] == 2'h3) | (select_1023[11] & (select_1023[9] | select_1023[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1086;
  assign or_1086 = (select_1038[7:6] == 2'h3) | (select_1038[8] & (~(select_1038[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1090;
  assign or_1090 = (select_1038[1:0] == 2'h3) | (select_1038[2] & (select_1038[0] | select_1038[1]));
  logic or_1094;
  assign or_1094 = (select_1038[4:3] == 2'h3) | (select_1038[5] & (select_1038[3] | select_1038[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1097;
  assign parity_1097 = ^{or_1094, or_1090, or_1086};
  // hls/stages/count_bits.hpp:23
  logic or_1101;
  assign or_1101 = (select_1023[4:3] == 2'h3) | (select_1023[5] & (select_1023[3] | select_1023[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1105;
  assign or_1105 = (select_1038[10:9] == 2'h3) | (select_1038[11] & (select_1038[9] | select_1038[10]));
  logic or_1109;
  assign or_1109 = (select_1023[1:0] == 2'h3) | (select_1023[2] & (select_1023[0] | select_1023[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1112;
  assign parity_1112 = ^{or_1109, or_1105, or_1101};
  logic parity_1115;
  assign parity_1115 = ^{or_1109, or_1105, or_1101, or_1094, or_1090, or_1086, or_1078, or_1074, or_1070};
  // hls/stages/count_bits.hpp:25
  logic and_1116;
  assign and_1116 = parity_1016 & parity_1065;
  logic or_1120;
  assign or_1120 = (parity_1010 & parity_1013) | ((^select_1004[11:9]) & (parity_1010 | parity_1013));
  logic and_1123;
  assign and_1123 = (^{select_1023[11:6], select_1004[2:0]}) & (parity_1050 | parity_1062);
  logic or_1124;
  assign or_1124 = (parity_1050 & parity_1062) | and_1123;
  // hls/stages/count_bits.hpp:23
  logic or_1131;
  assign or_1131 = (select_1004[10:9] == 2'h3) | (select_1004[11] & (select_1004[9] | select_1004[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1135;
  assign or_1135 = (select_1004[4:3] == 2'h3) | (select_1004[5] & (select_1004[3] | select_1004[4]));
  logic or_1139;
  assign or_1139 = (select_1004[7:6] == 2'h3) | (select_1004[8] & (select_1004[6] | select_1004[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1142;
  assign parity_1142 = ^{or_1139, or_1135, or_1131};
  // hls/stages/count_bits.hpp:25
  logic or_1146;
  assign or_1146 = (parity_1026 & parity_1029) | ((^select_1004[2:0]) & (parity_1026 | parity_1029));
  logic or_1150;
  assign or_1150 = (parity_1044 & parity_1047) | ((^select_1038[8:6]) & (parity_1044 | parity_1047));
  logic or_1154;
  assign or_1154 = (parity_1056 & parity_1059) | ((^select_1023[5:3]) & (parity_1056 | parity_1059));
  // hls/stages/count_bits.hpp:24
  logic parity_1157;
  assign parity_1157 = ^{or_1154, or_1150, or_1146};
  logic parity_1160;
  assign parity_1160 = ^{or_1154, or_1150, or_1146, or_1139, or_1135, or_1131, or_1124, or_1120, and_1116};
  logic xor_1161;
  assign xor_1161 = parity_1115 ^ parity_1160;
  // hls/stages/count_bits.hpp:25
  logic and_1162;
  assign and_1162 = parity_1115 & parity_1160;
  logic or_1166;
  assign or_1166 = (parity_1097 & parity_1112) | ((^{or_1078, or_1074, or_1070}) & (parity_1097 | parity_1112));
  logic or_1170;
  assign or_1170 = (parity_1142 & parity_1157) | ((^{or_1124, or_1120, and_1116}) & (parity_1142 | parity_1157));
  logic or_1177;
  assign or_1177 = (or_1074 & or_1078) | (or_1070 & (or_1074 | or_1078));
  logic or_1181;
  assign or_1181 = (or_1090 & or_1094) | (or_1086 & (or_1090 | or_1094));
  logic or_1185;
  assign or_1185 = (or_1105 & or_1109) | (or_1101 & (or_1105 | or_1109));
  // hls/stages/count_bits.hpp:24
  logic parity_1188;
  assign parity_1188 = ^{or_1185, or_1181, or_1177};
  // hls/stages/count_bits.hpp:25
  logic or_1192;
  assign or_1192 = (or_1120 & or_1124) | (and_1116 & (or_1120 | or_1124));
  logic or_1196;
  assign or_1196 = (or_1135 & or_1139) | (or_1131 & (or_1135 | or_1139));
  logic or_1200;
  assign or_1200 = (or_1150 & or_1154) | (or_1146 & (or_1150 | or_1154));
  // hls/stages/count_bits.hpp:24
  logic parity_1203;
  assign parity_1203 = ^{or_1200, or_1196, or_1192};
  logic parity_1206;
  assign parity_1206 = ^{or_1200, or_1196, or_1192, or_1185, or_1181, or_1177, or_1170, or_1166, and_1162};
  // hls/stages/count_bits.hpp:25
  logic or_1210;
  assign or_1210 = (parity_1188 & parity_1203) | ((^{or_1170, or_1166, and_1162}) & (parity_1188 | parity_1203));
  logic or_1214;
  assign or_1214 = (or_1166 & or_1170) | (and_1162 & (or_1166 | or_1170));
  logic or_1218;
  assign or_1218 = (or_1181 & or_1185) | (or_1177 & (or_1181 | or_1185));
  logic or_1222;
  assign or_1222 = (or_1196 & or_1200) | (or_1192 & (or_1196 | or_1200));
  // hls/stages/count_bits.hpp:24
  logic parity_1227;
  assign parity_1227 = ^{or_1222, or_1218, or_1214, or_1210};
  // hls/stages/count_bits.hpp:25
  logic or_1231;
  assign or_1231 = (or_1218 & or_1222) | (or_1214 & (or_1218 | or_1222));
  logic and_1232;
  assign and_1232 = or_1210 & (^{or_1222, or_1218, or_1214});
  // hls/stages/count_bits.hpp:24
  logic xor_1233;
  assign xor_1233 = or_1231 ^ and_1232;
  // hls/stages/count_bits.hpp:27
  logic and_1234;
  assign and_1234 = or_1231 & and_1232;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1235;
  assign select_1235 = equal_582_s1_q ? {and_1234, xor_1233, parity_1227, parity_1206, xor_1161, xor_1066} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_568_s1_q ? 6'h0 : select_1235;
  // hls/stages/agreement.hpp:779
  logic [5:0] select_1237;
  assign select_1237 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1238;
  assign difference_1238 = {1'b0, column_3} - {1'b0, select_1237};
  logic [7:0] sum_1240;
  assign sum_1240 = {difference_1238[6], difference_1238} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:221
  logic and_1241;
  assign and_1241 = right_codes_rdata_q[27] & not_572_s1_q;
  logic [11:0] select_1242;
  assign select_1242 = less_571_s1_q ? 12'h0 : right_codes_rdata_q[26:15];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1246;
  assign select_1246 = and_751 ? (and_1241 ? (~(select_753 ^ select_1242)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1252;
  assign parity_1252 = ^select_1246[5:3];
  logic parity_1255;
  assign parity_1255 = ^select_1246[8:6];
  logic parity_1258;
  assign parity_1258 = ^select_1246[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1265;
  assign select_1265 = and_774 ? (and_752 ? (~(select_776 ^ select_754)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1268;
  assign parity_1268 = ^select_1265[8:6];
  logic parity_1271;
  assign parity_1271 = ^select_1265[11:9];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1278;
  assign select_1278 = and_791 ? (and_775 ? (~(select_793 ^ select_777)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1284;
  assign parity_1284 = ^select_1278[2:0];
  logic parity_1287;
  assign parity_1287 = ^select_1278[5:3];
  logic parity_1290;
  assign parity_1290 = ^select_1278[8:0];
  logic parity_1296;
  assign parity_1296 = ^select_1278[11:9];
  logic parity_1299;
  assign parity_1299 = ^select_1265[2:0];
  logic parity_1302;
  assign parity_1302 = ^{select_1278[11:9], select_1265[5:0]};
  logic parity_1305;
  assign parity_1305 = ^{select_1278, select_1265, select_1246[2:0]};
  logic xor_1306;
  assign xor_1306 = parity_1258 ^ parity_1305;
  // hls/stages/count_bits.hpp:23
  logic or_1310;
  assign or_1310 = (select_1246[1:0] == 2'h3) | (select_1246[2] & (select_1246[0] | select_1246[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1314;
  assign or_1314 = (select_1265[7:6] == 2'h3) | (select_1265[8] & (select_1265[6] | select_1265[7]));
  logic or_1318;
  assign or_1318 = (select_1265[10:9] == 2'h3) | (select_1265[11] & (select_1265[9] | select_1265[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1326;
  assign or_1326 = (select_1278[7:6] == 2'h3) | (select_1278[8] & (~(select_1278[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1330;
  assign or_1330 = (select_1278[1:0] == 2'h3) | (select_1278[2] & (select_1278[0] | select_1278[1]));
  logic or_1334;
  assign or_1334 = (select_1278[4:3] == 2'h3) | (select_1278[5] & (select_1278[3] | select_1278[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1337;
  assign parity_1337 = ^{or_1334, or_1330, or_1326};
  // hls/stages/count_bits.hpp:23
  logic or_1341;
  assign or_1341 = (select_1265[4:3] == 2'h3) | (select_1265[5] & (select_1265[3] | select_1265[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1345;
  assign or_1345 = (select_1278[10:9] == 2'h3) | (select_1278[11] & (select_1278[9] | select_1278[10]));
  logic or_1349;
  assign or_1349 = (select_1265[1:0] == 2'h3) | (select_1265[2] & (select_1265[0] | select_1265[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1352;
  assign parity_1352 = ^{or_1349, or_1345, or_1341};
  logic parity_1355;
  assign parity_1355 = ^{or_1349, or_1345, or_1341, or_1334, or_1330, or_1326, or_1318, or_1314, or_1310};
  // hls/stages/count_bits.hpp:25
  logic and_1356;
  assign and_1356 = parity_1258 & parity_1305;
  logic or_1360;
  assign or_1360 = (parity_1252 & parity_1255) | ((^select_1246[11:9]) & (parity_1252 | parity_1255));
  logic and_1363;
  assign and_1363 = (^{select_1265[11:6], select_1246[2:0]}) & (parity_1290 | parity_1302);
  logic or_1364;
  assign or_1364 = (parity_1290 & parity_1302) | and_1363;
  // hls/stages/count_bits.hpp:23
  logic or_1371;
  assign or_1371 = (select_1246[10:9] == 2'h3) | (select_1246[11] & (select_1246[9] | select_1246[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1375;
  assign or_1375 = (select_1246[4:3] == 2'h3) | (select_1246[5] & (select_1246[3] | select_1246[4]));
  logic or_1379;
  assign or_1379 = (select_1246[7:6] == 2'h3) | (select_1246[8] & (select_1246[6] | select_1246[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1382;
  assign parity_1382 = ^{or_1379, or_1375, or_1371};
  // hls/stages/count_bits.hpp:25
  logic or_1386;
  assign or_1386 = (parity_1268 & parity_1271) | ((^select_1246[2:0]) & (parity_1268 | parity_1271));
  logic or_1390;
  assign or_1390 = (parity_1284 & parity_1287) | ((^select_1278[8:6]) & (parity_1284 | parity_1287));
  logic or_1394;
  assign or_1394 = (parity_1296 & parity_1299) | ((^select_1265[5:3]) & (parity_1296 | parity_1299));
  // hls/stages/count_bits.hpp:24
  logic parity_1397;
  assign parity_1397 = ^{or_1394, or_1390, or_1386};
  logic parity_1400;
  assign parity_1400 = ^{or_1394, or_1390, or_1386, or_1379, or_1375, or_1371, or_1364, or_1360, and_1356};
  logic xor_1401;
  assign xor_1401 = parity_1355 ^ parity_1400;
  // hls/stages/count_bits.hpp:25
  logic and_1402;
  assign and_1402 = parity_1355 & parity_1400;
  logic or_1406;
  assign or_1406 = (parity_1337 & parity_1352) | ((^{or_1318, or_1314, or_1310}) & (parity_1337 | parity_1352));
  logic or_1410;
  assign or_1410 = (parity_1382 & parity_1397) | ((^{or_1364, or_1360, and_1356}) & (parity_1382 | parity_1397));
  logic or_1417;
  assign or_1417 = (or_1314 & or_1318) | (or_1310 & (or_1314 | or_1318));
  logic or_1421;
  assign or_1421 = (or_1330 & or_1334) | (or_1326 & (or_1330 | or_1334));
  logic or_1425;
  assign or_1425 = (or_1345 & or_1349) | (or_1341 & (or_1345 | or_1349));
  // hls/stages/count_bits.hpp:24
  logic parity_1428;
  assign parity_1428 = ^{or_1425, or_1421, or_1417};
  // hls/stages/count_bits.hpp:25
  logic or_1432;
  assign or_1432 = (or_1360 & or_1364) | (and_1356 & (or_1360 | or_1364));
  logic or_1436;
  assign or_1436 = (or_1375 & or_1379) | (or_1371 & (or_1375 | or_1379));
  logic or_1440;
  assign or_1440 = (or_1390 & or_1394) | (or_1386 & (or_1390 | or_1394));
  // hls/stages/count_bits.hpp:24
  logic parity_1443;
  assign parity_1443 = ^{or_1440, or_1436, or_1432};
  logic parity_1446;
  assign parity_1446 = ^{or_1440, or_1436, or_1432, or_1425, or_1421, or_1417, or_1410, or_1406, and_1402};
  // hls/stages/count_bits.hpp:25
  logic or_1450;
  assign or_1450 = (parity_1428 & parity_1443) | ((^{or_1410, or_1406, and_1402}) & (parity_1428 | parity_1443));
  logic or_1454;
  assign or_1454 = (or_1406 & or_1410) | (and_1402 & (or_1406 | or_1410));
  logic or_1458;
  assign or_1458 = (or_1421 & or_1425) | (or_1417 & (or_1421 | or_1425));
  logic or_1462;
  assign or_1462 = (or_1436 & or_1440) | (or_1432 & (or_1436 | or_1440));
  // hls/stages/count_bits.hpp:24
  logic parity_1467;
  assign parity_1467 = ^{or_1462, or_1458, or_1454, or_1450};
  // hls/stages/count_bits.hpp:25
  logic or_1471;
  assign or_1471 = (or_1458 & or_1462) | (or_1454 & (or_1458 | or_1462));
  logic and_1472;
  assign and_1472 = or_1450 & (^{or_1462, or_1458, or_1454});
  // hls/stages/count_bits.hpp:24
  logic xor_1473;
  assign xor_1473 = or_1471 ^ and_1472;
  // hls/stages/count_bits.hpp:27
  logic and_1474;
  assign and_1474 = or_1471 & and_1472;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1475;
  assign select_1475 = equal_582_s1_q ? {and_1474, xor_1473, parity_1467, parity_1446, xor_1401, xor_1306} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_568_s1_q ? 6'h0 : select_1475;
  // hls/stages/agreement.hpp:779
  logic [5:0] select_1477;
  assign select_1477 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1478;
  assign difference_1478 = {1'b0, column_4} - {1'b0, select_1477};
  logic [7:0] sum_1480;
  assign sum_1480 = {difference_1478[6], difference_1478} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1488;
  assign select_1488 = and_751 ? (and_792 ? (~(select_753 ^ select_794)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1494;
  assign parity_1494 = ^select_1488[5:3];
  logic parity_1497;
  assign parity_1497 = ^select_1488[8:6];
  logic parity_1500;
  assign parity_1500 = ^select_1488[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1507;
  assign select_1507 = and_774 ? (and_1033 ? (~(select_776 ^ select_1034)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1510;
  assign parity_1510 = ^select_1507[8:6];
  logic parity_1513;
  assign parity_1513 = ^select_1507[11:9];
  // hls/stages/agreement.hpp:685
  logic [11:0] xor_1519;
  assign xor_1519 = select_793 ^ (less_571_s1_q ? 12'h0 : right_codes_rdata_q[97:86]);
  logic [11:0] select_1522;
  assign select_1522 = and_791 ? ((right_codes_rdata_q[98] & not_572_s1_q) ? (~xor_1519) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1528;
  assign parity_1528 = ^select_1522[2:0];
  logic parity_1531;
  assign parity_1531 = ^select_1522[5:3];
  logic parity_1534;
  assign parity_1534 = ^select_1522[8:0];
  logic parity_1540;
  assign parity_1540 = ^select_1522[11:9];
  logic parity_1543;
  assign parity_1543 = ^select_1507[2:0];
  logic parity_1546;
  assign parity_1546 = ^{select_1522[11:9], select_1507[5:0]};
  logic parity_1549;
  assign parity_1549 = ^{select_1522, select_1507, select_1488[2:0]};
  logic xor_1550;
  assign xor_1550 = parity_1500 ^ parity_1549;
  // hls/stages/count_bits.hpp:23
  logic or_1554;
  assign or_1554 = (select_1488[1:0] == 2'h3) | (select_1488[2] & (select_1488[0] | select_1488[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1558;
  assign or_1558 = (select_1507[7:6] == 2'h3) | (select_1507[8] & (select_1507[6] | select_1507[7]));
  logic or_1562;
  assign or_1562 = (select_1507[10:9] == 2'h3) | (select_1507[11] & (select_1507[9] | select_1507[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1570;
  assign or_1570 = (select_1522[7:6] == 2'h3) | (select_1522[8] & (~(select_1522[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1574;
  assign or_1574 = (select_1522[1:0] == 2'h3) | (select_1522[2] & (select_1522[0] | select_1522[1]));
  logic or_1578;
  assign or_1578 = (select_1522[4:3] == 2'h3) | (select_1522[5] & (select_1522[3] | select_1522[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1581;
  assign parity_1581 = ^{or_1578, or_1574, or_1570};
  // hls/stages/count_bits.hpp:23
  logic or_1585;
  assign or_1585 = (select_1507[4:3] == 2'h3) | (select_1507[5] & (select_1507[3] | select_1507[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1589;
  assign or_1589 = (select_1522[10:9] == 2'h3) | (select_1522[11] & (select_1522[9] | select_1522[10]));
  logic or_1593;
  assign or_1593 = (select_1507[1:0] == 2'h3) | (select_1507[2] & (select_1507[0] | select_1507[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1596;
  assign parity_1596 = ^{or_1593, or_1589, or_1585};
  logic parity_1599;
  assign parity_1599 = ^{or_1593, or_1589, or_1585, or_1578, or_1574, or_1570, or_1562, or_1558, or_1554};
  // hls/stages/count_bits.hpp:25
  logic and_1600;
  assign and_1600 = parity_1500 & parity_1549;
  logic or_1604;
  assign or_1604 = (parity_1494 & parity_1497) | ((^select_1488[11:9]) & (parity_1494 | parity_1497));
  logic and_1607;
  assign and_1607 = (^{select_1507[11:6], select_1488[2:0]}) & (parity_1534 | parity_1546);
  logic or_1608;
  assign or_1608 = (parity_1534 & parity_1546) | and_1607;
  // hls/stages/count_bits.hpp:23
  logic or_1615;
  assign or_1615 = (select_1488[10:9] == 2'h3) | (select_1488[11] & (select_1488[9] | select_1488[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1619;
  assign or_1619 = (select_1488[4:3] == 2'h3) | (select_1488[5] & (select_1488[3] | select_1488[4]));
  logic or_1623;
  assign or_1623 = (select_1488[7:6] == 2'h3) | (select_1488[8] & (select_1488[6] | select_1488[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1626;
  assign parity_1626 = ^{or_1623, or_1619, or_1615};
  // hls/stages/count_bits.hpp:25
  logic or_1630;
  assign or_1630 = (parity_1510 & parity_1513) | ((^select_1488[2:0]) & (parity_1510 | parity_1513));
  logic or_1634;
  assign or_1634 = (parity_1528 & parity_1531) | ((^select_1522[8:6]) & (parity_1528 | parity_1531));
  logic or_1638;
  assign or_1638 = (parity_1540 & parity_1543) | ((^select_1507[5:3]) & (parity_1540 | parity_1543));
  // hls/stages/count_bits.hpp:24
  logic parity_1641;
  assign parity_1641 = ^{or_1638, or_1634, or_1630};
  logic parity_1644;
  assign parity_1644 = ^{or_1638, or_1634, or_1630, or_1623, or_1619, or_1615, or_1608, or_1604, and_1600};
  logic xor_1645;
  assign xor_1645 = parity_1599 ^ parity_1644;
  // hls/stages/count_bits.hpp:25
  logic and_1646;
  assign and_1646 = parity_1599 & parity_1644;
  logic or_1650;
  assign or_1650 = (parity_1581 & parity_1596) | ((^{or_1562, or_1558, or_1554}) & (parity_1581 | parity_1596));
  logic or_1654;
  assign or_1654 = (parity_1626 & parity_1641) | ((^{or_1608, or_1604, and_1600}) & (parity_1626 | parity_1641));
  logic or_1661;
  assign or_1661 = (or_1558 & or_1562) | (or_1554 & (or_1558 | or_1562));
  logic or_1665;
  assign or_1665 = (or_1574 & or_1578) | (or_1570 & (or_1574 | or_1578));
  logic or_1669;
  assign or_1669 = (or_1589 & or_1593) | (or_1585 & (or_1589 | or_1593));
  // hls/stages/count_bits.hpp:24
  logic parity_1672;
  assign parity_1672 = ^{or_1669, or_1665, or_1661};
  // hls/stages/count_bits.hpp:25
  logic or_1676;
  assign or_1676 = (or_1604 & or_1608) | (and_1600 & (or_1604 | or_1608));
  logic or_1680;
  assign or_1680 = (or_1619 & or_1623) | (or_1615 & (or_1619 | or_1623));
  logic or_1684;
  assign or_1684 = (or_1634 & or_1638) | (or_1630 & (or_1634 | or_1638));
  // hls/stages/count_bits.hpp:24
  logic parity_1687;
  assign parity_1687 = ^{or_1684, or_1680, or_1676};
  logic parity_1690;
  assign parity_1690 = ^{or_1684, or_1680, or_1676, or_1669, or_1665, or_1661, or_1654, or_1650, and_1646};
  // hls/stages/count_bits.hpp:25
  logic or_1694;
  assign or_1694 = (parity_1672 & parity_1687) | ((^{or_1654, or_1650, and_1646}) & (parity_1672 | parity_1687));
  logic or_1698;
  assign or_1698 = (or_1650 & or_1654) | (and_1646 & (or_1650 | or_1654));
  logic or_1702;
  assign or_1702 = (or_1665 & or_1669) | (or_1661 & (or_1665 | or_1669));
  logic or_1706;
  assign or_1706 = (or_1680 & or_1684) | (or_1676 & (or_1680 | or_1684));
  // hls/stages/count_bits.hpp:24
  logic parity_1711;
  assign parity_1711 = ^{or_1706, or_1702, or_1698, or_1694};
  // hls/stages/count_bits.hpp:25
  logic or_1715;
  assign or_1715 = (or_1702 & or_1706) | (or_1698 & (or_1702 | or_1706));
  logic and_1716;
  assign and_1716 = or_1694 & (^{or_1706, or_1702, or_1698});
  // hls/stages/count_bits.hpp:24
  logic xor_1717;
  assign xor_1717 = or_1715 ^ and_1716;
  // hls/stages/count_bits.hpp:27
  logic and_1718;
  assign and_1718 = or_1715 & and_1716;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1719;
  assign select_1719 = equal_582_s1_q ? {and_1718, xor_1717, parity_1711, parity_1690, xor_1645, xor_1550} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_568_s1_q ? 6'h0 : select_1719;
  // hls/stages/agreement.hpp:779
  logic [5:0] select_1721;
  assign select_1721 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1722;
  assign difference_1722 = {1'b0, column_5} - {1'b0, select_1721};
  logic [7:0] sum_1724;
  assign sum_1724 = {difference_1722[6], difference_1722} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:685
  logic [11:0] not_1728;
  assign not_1728 = ~(select_753 ^ (less_571_s1_q ? 12'h0 : right_codes_rdata_q[11:0]));
  logic [11:0] select_1730;
  assign select_1730 = and_751 ? ((right_codes_rdata_q[12] & not_572_s1_q) ? not_1728 : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1736;
  assign parity_1736 = ^select_1730[5:3];
  logic parity_1739;
  assign parity_1739 = ^select_1730[8:6];
  logic parity_1742;
  assign parity_1742 = ^select_1730[11:3];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1749;
  assign select_1749 = and_774 ? (and_1241 ? (~(select_776 ^ select_1242)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1752;
  assign parity_1752 = ^select_1749[8:6];
  logic parity_1755;
  assign parity_1755 = ^select_1749[11:9];
  // hls/stages/agreement.hpp:685
  logic [11:0] select_1762;
  assign select_1762 = and_791 ? (and_752 ? (~(select_793 ^ select_754)) : 12'h0) : 12'h0;
  // hls/stages/count_bits.hpp:24
  logic parity_1768;
  assign parity_1768 = ^select_1762[2:0];
  logic parity_1771;
  assign parity_1771 = ^select_1762[5:3];
  logic parity_1774;
  assign parity_1774 = ^select_1762[8:0];
  logic parity_1780;
  assign parity_1780 = ^select_1762[11:9];
  logic parity_1783;
  assign parity_1783 = ^select_1749[2:0];
  logic parity_1786;
  assign parity_1786 = ^{select_1762[11:9], select_1749[5:0]};
  logic parity_1789;
  assign parity_1789 = ^{select_1762, select_1749, select_1730[2:0]};
  logic xor_1790;
  assign xor_1790 = parity_1742 ^ parity_1789;
  // hls/stages/count_bits.hpp:23
  logic or_1794;
  assign or_1794 = (select_1730[1:0] == 2'h3) | (select_1730[2] & (select_1730[0] | select_1730[1]));
  // hls/stages/count_bits.hpp:25
  logic or_1798;
  assign or_1798 = (select_1749[7:6] == 2'h3) | (select_1749[8] & (select_1749[6] | select_1749[7]));
  logic or_1802;
  assign or_1802 = (select_1749[10:9] == 2'h3) | (select_1749[11] & (select_1749[9] | select_1749[10]));
  // hls/stages/count_bits.hpp:23
  logic or_1810;
  assign or_1810 = (select_1762[7:6] == 2'h3) | (select_1762[8] & (~(select_1762[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_1814;
  assign or_1814 = (select_1762[1:0] == 2'h3) | (select_1762[2] & (select_1762[0] | select_1762[1]));
  logic or_1818;
  assign or_1818 = (select_1762[4:3] == 2'h3) | (select_1762[5] & (select_1762[3] | select_1762[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_1821;
  assign parity_1821 = ^{or_1818, or_1814, or_1810};
  // hls/stages/count_bits.hpp:23
  logic or_1825;
  assign or_1825 = (select_1749[4:3] == 2'h3) | (select_1749[5] & (select_1749[3] | select_1749[4]));
  // hls/stages/count_bits.hpp:25
  logic or_1829;
  assign or_1829 = (select_1762[10:9] == 2'h3) | (select_1762[11] & (select_1762[9] | select_1762[10]));
  logic or_1833;
  assign or_1833 = (select_1749[1:0] == 2'h3) | (select_1749[2] & (select_1749[0] | select_1749[1]));
  // hls/stages/count_bits.hpp:24
  logic parity_1836;
  assign parity_1836 = ^{or_1833, or_1829, or_1825};
  logic parity_1839;
  assign parity_1839 = ^{or_1833, or_1829, or_1825, or_1818, or_1814, or_1810, or_1802, or_1798, or_1794};
  // hls/stages/count_bits.hpp:25
  logic and_1840;
  assign and_1840 = parity_1742 & parity_1789;
  logic or_1844;
  assign or_1844 = (parity_1736 & parity_1739) | ((^select_1730[11:9]) & (parity_1736 | parity_1739));
  logic and_1847;
  assign and_1847 = (^{select_1749[11:6], select_1730[2:0]}) & (parity_1774 | parity_1786);
  logic or_1848;
  assign or_1848 = (parity_1774 & parity_1786) | and_1847;
  // hls/stages/count_bits.hpp:23
  logic or_1855;
  assign or_1855 = (select_1730[10:9] == 2'h3) | (select_1730[11] & (select_1730[9] | select_1730[10]));
  // hls/stages/count_bits.hpp:25
  logic or_1859;
  assign or_1859 = (select_1730[4:3] == 2'h3) | (select_1730[5] & (select_1730[3] | select_1730[4]));
  logic or_1863;
  assign or_1863 = (select_1730[7:6] == 2'h3) | (select_1730[8] & (select_1730[6] | select_1730[7]));
  // hls/stages/count_bits.hpp:24
  logic parity_1866;
  assign parity_1866 = ^{or_1863, or_1859, or_1855};
  // hls/stages/count_bits.hpp:25
  logic or_1870;
  assign or_1870 = (parity_1752 & parity_1755) | ((^select_1730[2:0]) & (parity_1752 | parity_1755));
  logic or_1874;
  assign or_1874 = (parity_1768 & parity_1771) | ((^select_1762[8:6]) & (parity_1768 | parity_1771));
  logic or_1878;
  assign or_1878 = (parity_1780 & parity_1783) | ((^select_1749[5:3]) & (parity_1780 | parity_1783));
  // hls/stages/count_bits.hpp:24
  logic parity_1881;
  assign parity_1881 = ^{or_1878, or_1874, or_1870};
  logic parity_1884;
  assign parity_1884 = ^{or_1878, or_1874, or_1870, or_1863, or_1859, or_1855, or_1848, or_1844, and_1840};
  logic xor_1885;
  assign xor_1885 = parity_1839 ^ parity_1884;
  // hls/stages/count_bits.hpp:25
  logic and_1886;
  assign and_1886 = parity_1839 & parity_1884;
  logic or_1890;
  assign or_1890 = (parity_1821 & parity_1836) | ((^{or_1802, or_1798, or_1794}) & (parity_1821 | parity_1836));
  logic or_1894;
  assign or_1894 = (parity_1866 & parity_1881) | ((^{or_1848, or_1844, and_1840}) & (parity_1866 | parity_1881));
  logic or_1901;
  assign or_1901 = (or_1798 & or_1802) | (or_1794 & (or_1798 | or_1802));
  logic or_1905;
  assign or_1905 = (or_1814 & or_1818) | (or_1810 & (or_1814 | or_1818));
  logic or_1909;
  assign or_1909 = (or_1829 & or_1833) | (or_1825 & (or_1829 | or_1833));
  // hls/stages/count_bits.hpp:24
  logic parity_1912;
  assign parity_1912 = ^{or_1909, or_1905, or_1901};
  // hls/stages/count_bits.hpp:25
  logic or_1916;
  assign or_1916 = (or_1844 & or_1848) | (and_1840 & (or_1844 | or_1848));
  logic or_1920;
  assign or_1920 = (or_1859 & or_1863) | (or_1855 & (or_1859 | or_1863));
  logic or_1924;
  assign or_1924 = (or_1874 & or_1878) | (or_1870 & (or_1874 | or_1878));
  // hls/stages/count_bits.hpp:24
  logic parity_1927;
  assign parity_1927 = ^{or_1924, or_1920, or_1916};
  logic parity_1930;
  assign parity_1930 = ^{or_1924, or_1920, or_1916, or_1909, or_1905, or_1901, or_1894, or_1890, and_1886};
  // hls/stages/count_bits.hpp:25
  logic or_1934;
  assign or_1934 = (parity_1912 & parity_1927) | ((^{or_1894, or_1890, and_1886}) & (parity_1912 | parity_1927));
  logic or_1938;
  assign or_1938 = (or_1890 & or_1894) | (and_1886 & (or_1890 | or_1894));
  logic or_1942;
  assign or_1942 = (or_1905 & or_1909) | (or_1901 & (or_1905 | or_1909));
  logic or_1946;
  assign or_1946 = (or_1920 & or_1924) | (or_1916 & (or_1920 | or_1924));
  // hls/stages/count_bits.hpp:24
  logic parity_1951;
  assign parity_1951 = ^{or_1946, or_1942, or_1938, or_1934};
  // hls/stages/count_bits.hpp:25
  logic or_1955;
  assign or_1955 = (or_1942 & or_1946) | (or_1938 & (or_1942 | or_1946));
  logic and_1956;
  assign and_1956 = or_1934 & (^{or_1946, or_1942, or_1938});
  // hls/stages/count_bits.hpp:24
  logic xor_1957;
  assign xor_1957 = or_1955 ^ and_1956;
  // hls/stages/count_bits.hpp:27
  logic and_1958;
  assign and_1958 = or_1955 & and_1956;
  // hls/stages/agreement.hpp:149
  logic [5:0] select_1959;
  assign select_1959 = equal_582_s1_q ? {and_1958, xor_1957, parity_1951, parity_1930, xor_1885, xor_1790} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_568_s1_q ? 6'h0 : select_1959;
  // hls/stages/agreement.hpp:779
  logic [5:0] select_1961;
  assign select_1961 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1962;
  assign difference_1962 = {1'b0, column_6} - {1'b0, select_1961};
  logic [7:0] sum_1964;
  assign sum_1964 = {difference_1962[6], difference_1962} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:789
  logic and_2035;
  assign and_2035 = ends_cell_s1_q & inside_v;
  logic and_2037;
  assign and_2037 = not_564 & (so_s1_q & and_2035);
  logic [6:0] select_2041;
  assign select_2041 = so_s1_q ? x_s1_q[6:0] : (or_568_s1_q ? (less_571_s1_q ? 7'h0 : select_615) : 7'h0);
  // hls/stages/agreement.hpp:247
  logic or_2045;
  assign or_2045 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:149
  logic and_2054;
  assign and_2054 = or_568_s1_q & (slot_s1_q[2] & not_572_s1_q);
  // hls/stages/registration.hpp:218
  logic [16:0] select_2170;
  assign select_2170 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2170[16:7])) ? 8'h7f : select_2170[7:0];
  // hls/stages/patches.hpp:172
  logic [7:0] pixel;
  assign pixel = equal_2247_s1_q ? (patches_second_s1_q ? 8'h0 : patches_right_0_rdata_q) : 8'h0;
  logic [7:0] pixel_2;
  assign pixel_2 = equal_2247_s1_q ? (patches_second_s1_q ? patches_right_1_rdata_q : pixel) : patches_left_rdata_q;
  // hls/stages/patches.hpp:496
  logic less_2335;
  assign less_2335 = 5'he < patches_along_q;
  // hls/stages/patches.hpp:497
  logic or_2336;
  assign or_2336 = equal_2246_s1_q | less_2335;
  // hls/stages/patches.hpp:500
  logic new_row;
  assign new_row = patches_along_q == 5'h0;
  logic select_2341;
  assign select_2341 = equal_2246_s1_q ? patches_column_s1_q[0] : (or_2336 ? (patches_along_q == 5'h10) : (~new_row));
  logic not_2342;
  assign not_2342 = ~or_2336;
  // hls/stages/patches.hpp:497
  logic [4:0] sum_2343;
  assign sum_2343 = patches_down_by_q + {1'b0, patches_match_row_q};
  // hls/stages/patches.hpp:499
  logic [4:0] select_2346;
  assign select_2346 = or_2336 ? ((patches_match_row_ends_q ? patches_down_by_q : sum_2343) + 5'h1) : sum_2343;
  // hls/stages/patches.hpp:501
  logic [4:0] select_2347;
  assign select_2347 = equal_2246_s1_q ? 5'h0 : select_2346;
  logic or_2348;
  assign or_2348 = equal_2246_s1_q | equal_2244_s1_q;
  // hls/stages/patches.hpp:477
  logic equal_2350;
  assign equal_2350 = patches_column_s1_q == 5'h1f;
  logic of_row;
  assign of_row = patches_column_s1_q == 5'h11;
  logic equal_2352;
  assign equal_2352 = patches_column_s1_q == 5'h18;
  // hls/stages/patches.hpp:479
  logic and_2354;
  assign and_2354 = of_row & (~equal_2352);
  logic [1:0] of_row_2;
  assign of_row_2 = equal_2350 ? 2'h3 : {equal_2352, and_2354};
  // hls/stages/patches.hpp:465
  logic [8:0] sum_2357;
  assign sum_2357 = {1'b0, patches_columns_above_rdata_q[7:0]} + {2'h0, pixel_2[7:1]};
  logic [8:0] sum_2358;
  assign sum_2358 = {1'b0, patches_columns_above_rdata_q[23:16]} + {2'h0, patches_columns_above_rdata_q[31:25]};
  logic [10:0] down_2;
  assign down_2 = {1'b0, sum_2357, pixel_2[0]} - {1'b0, sum_2358, patches_columns_above_rdata_q[24]};
  // hls/stages/patches.hpp:467
  logic [11:0] sum_2360;
  assign sum_2360 = {patches_down_values_0_q[10], patches_down_values_0_q} + {patches_down_values_1_q[10], patches_down_values_1_q};
  logic [12:0] sum_2361;
  assign sum_2361 = {{4{down_2[10]}}, down_2[10:2]} + {sum_2360[11], sum_2360};
  logic [13:0] sum_2362;
  assign sum_2362 = {{3{patches_down_values_1_q[10]}}, patches_down_values_1_q} + {sum_2361, down_2[1]};
  logic [12:0] sum_2363;
  assign sum_2363 = {{2{patches_down_values_2_q[10]}}, patches_down_values_2_q} + sum_2362[13:1];
  logic [14:0] sum_2364;
  assign sum_2364 = {{4{patches_down_values_3_q[10]}}, patches_down_values_3_q} + {sum_2363, sum_2362[0], down_2[0]};
  // hls/stages/patches.hpp:463
  logic [8:0] sum_2367;
  assign sum_2367 = {1'b0, patches_columns_above_rdata_q[23:16]} + {3'h0, patches_columns_above_rdata_q[31:26]};
  logic [9:0] sum_2368;
  assign sum_2368 = {2'h0, patches_columns_above_rdata_q[15:8]} + {1'b0, sum_2367};
  logic [10:0] sum_2369;
  assign sum_2369 = {3'h0, patches_columns_above_rdata_q[15:8]} + {sum_2368, patches_columns_above_rdata_q[25]};
  logic [9:0] sum_2370;
  assign sum_2370 = {2'h0, patches_columns_above_rdata_q[7:0]} + sum_2369[10:1];
  // hls/stages/patches.hpp:464
  logic [11:0] smooth;
  assign smooth = {sum_2370, sum_2369[0], patches_columns_above_rdata_q[24]} + {4'h0, pixel_2};
  // hls/stages/patches.hpp:466
  logic [12:0] sum_2372;
  assign sum_2372 = {1'b0, patches_smooth_values_0_q} + {2'h0, smooth[11:1]};
  logic [12:0] sum_2373;
  assign sum_2373 = {1'b0, patches_smooth_values_2_q} + {2'h0, patches_smooth_values_3_q[11:1]};
  logic [14:0] difference_2374;
  assign difference_2374 = {1'b0, sum_2372, smooth[0]} - {1'b0, sum_2373, patches_smooth_values_3_q[0]};
  // hls/stages/patches.hpp:478
  logic or_2380;
  assign or_2380 = (((patches_column_s1_q == 5'ha) | of_row) | equal_2352) | equal_2350;
  // hls/stages/patches.hpp:473
  logic and_2385;
  assign and_2385 = (~(patches_code_row_s1_q[4:2] == 3'h0)) & (~(patches_column_s1_q[4:2] == 3'h0));
  // hls/stages/patches.hpp:184
  logic and_2389;
  assign and_2389 = not_2245_s1_q & (or_2248_s1_q & (or_2380 & (equal_2247_s1_q & and_2385)));
  // hls/stages/patches.hpp:172
  logic and_2399;
  assign and_2399 = (~(equal_2247_s1_q | (~and_2385))) & (~patches_column_s1_q[4]);
  // hls/stages/patches.hpp:184
  logic and_2403;
  assign and_2403 = not_2245_s1_q & (or_2248_s1_q & (and_2399 & (patches_column_s1_q == 5'hf)));
  // hls/stages/patches.hpp:542
  logic less_2405;
  assign less_2405 = patches_step_q[4:0] < 5'h11;
  logic equal_2406;
  assign equal_2406 = patches_step_q[6:5] == 2'h0;
  logic not_2407;
  assign not_2407 = ~equal_2406;
  logic equal_2408;
  assign equal_2408 = patches_step_q[6:5] == 2'h3;
  logic not_2409;
  assign not_2409 = ~equal_2408;
  // hls/stages/patches.hpp:556
  logic select_2412;
  assign select_2412 = equal_2408 ? (less_2405 & (less_2405 & not_2409)) : less_2405;
  // hls/stages/patches.hpp:184
  logic and_2415;
  assign and_2415 = equal_2242_s1_q & (less_2405 ? (not_2407 & select_2412) : select_2412);
  // hls/stages/division.hpp:34
  logic [5:0] sum_2437;
  assign sum_2437 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/agreement.hpp:457
  logic [5:0] or_2720;
  assign or_2720 = column_s1_q[5:0] | row_s1_q;
  // hls/stages/agreement.hpp:461
  logic select_3004;
  assign select_3004 = equal_2910_s1_q ? (~({row_s1_q, 1'b0} < {sum_3001, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:521
  logic and_3248;
  assign and_3248 = and_538_s1_q & (equal_2910_s1_q & (row_s1_q[5:2] == 4'h0));
  // hls/stages/registration.hpp:128
  logic and_3249;
  assign and_3249 = and_2911_s1_q & and_3248;
  // hls/stages/registration.hpp:127
  logic and_3251;
  assign and_3251 = and_2911_s1_q & (~and_3248);
  // hls/stages/registration.hpp:129
  logic [15:0] select_3252;
  assign select_3252 = and_3251 ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:132
  logic [23:0] select_3254;
  assign select_3254 = and_3249 ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3252[15]}}, select_3252});
  // hls/stages/registration.hpp:130
  logic [15:0] select_3255;
  assign select_3255 = and_3251 ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3255[15]}}, select_3255};
  // hls/stages/registration.hpp:132
  logic [27:0] select_3257;
  assign select_3257 = and_3249 ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/agreement.hpp:149
  logic and_3258;
  assign and_3258 = ends_cell_s1_q & so_s1_q;
  // hls/stages/registration.hpp:125
  logic [27:0] column_8;
  assign column_8 = registration_slope_q + (and_3258 ? registration_slope_change_q : 28'h0);
  // hls/stages/patches.hpp:187
  logic select_3504;
  assign select_3504 = patches_along_ends_q ? (patches_match_row_q == 4'ha) : patches_match_row_ends_q;
  // hls/stages/patches.hpp:184
  logic [11:0] select_3507;
  assign select_3507 = equal_2244_s1_q ? patches_smooth_values_0_q : (or_2248_s1_q ? smooth : patches_smooth_values_0_q);
  logic [11:0] select_3509;
  assign select_3509 = or_2248_s1_q ? patches_smooth_values_0_q : patches_smooth_values_1_q;
  logic [11:0] select_3511;
  assign select_3511 = equal_2242_s1_q ? patches_smooth_values_1_q : (equal_2244_s1_q ? patches_smooth_values_1_q : select_3509);
  logic [11:0] select_3512;
  assign select_3512 = or_2248_s1_q ? patches_smooth_values_1_q : patches_smooth_values_2_q;
  logic [11:0] select_3514;
  assign select_3514 = equal_2242_s1_q ? patches_smooth_values_2_q : (equal_2244_s1_q ? patches_smooth_values_2_q : select_3512);
  logic [11:0] select_3515;
  assign select_3515 = or_2248_s1_q ? patches_smooth_values_2_q : patches_smooth_values_3_q;
  logic [11:0] select_3517;
  assign select_3517 = equal_2242_s1_q ? patches_smooth_values_3_q : (equal_2244_s1_q ? patches_smooth_values_3_q : select_3515);
  logic [10:0] select_3519;
  assign select_3519 = equal_2244_s1_q ? patches_down_values_0_q : (or_2248_s1_q ? down_2 : patches_down_values_0_q);
  logic [10:0] select_3522;
  assign select_3522 = equal_2244_s1_q ? patches_down_values_1_q : (or_2248_s1_q ? patches_down_values_0_q : patches_down_values_1_q);
  logic [10:0] select_3525;
  assign select_3525 = equal_2244_s1_q ? patches_down_values_2_q : (or_2248_s1_q ? patches_down_values_1_q : patches_down_values_2_q);
  logic [10:0] select_3528;
  assign select_3528 = equal_2244_s1_q ? patches_down_values_3_q : (or_2248_s1_q ? patches_down_values_2_q : patches_down_values_3_q);
  // hls/stages/patches.hpp:175
  logic and_3565;
  assign and_3565 = patches_along_ends_q & patches_match_row_ends_q;
  // hls/stages/patches.hpp:413
  logic [4:0] select_3570;
  assign select_3570 = or_3465_s1_q ? 5'h0 : (patches_along_ends_q ? 5'h0 : (patches_along_q + 5'h1));
  // hls/stages/patches.hpp:415
  logic [3:0] select_3572;
  assign select_3572 = and_3565 ? 4'h0 : ({3'h0, patches_along_ends_q} + patches_match_row_q);
  // hls/stages/patches.hpp:184
  logic [4:0] select_3928;
  assign select_3928 = equal_2242_s1_q ? patches_summed_down_by_q : (equal_2244_s1_q ? patches_down_by_q : patches_summed_down_by_q);
  // hls/stages/patches.hpp:552
  logic and_3961;
  assign and_3961 = less_2405 & (patches_step_q[6:5] == 2'h1);
  // hls/stages/patches.hpp:556
  logic select_3964;
  assign select_3964 = equal_2408 ? (less_2405 ? (not_2409 & and_3961) : and_3961) : and_3961;
  // hls/stages/patches.hpp:184
  logic select_3967;
  assign select_3967 = equal_2242_s1_q ? (less_2405 ? (not_2407 & select_3964) : select_3964) : patches_read_searches_q;
  // hls/stages/agreement.hpp:205
  logic [8:0] select_4306;
  assign select_4306 = so_s1_q ? (and_3258 ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4308;
  assign sum_4308 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4309;
  assign select_4309 = sum_2437[5] ? {1'b1, sum_2437[4:0], region_across_rest_q[2:0]} : sum_4308;
  // hls/stages/agreement.hpp:461
  logic [8:0] select_4311;
  assign select_4311 = equal_2910_s1_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_4314;
  assign select_4314 = equal_2910_s1_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:227; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_508_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_513;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
  end
  logic [25:0] averager_memory_rdata_q;
  assign averager_memory_rdata_q = averager_memory_word_q[25:0];
  logic averager_memory_read_q, averager_memory_error;
  always_ff @(posedge clk_i) averager_memory_read_q <= rst_ni & averager_memory_re;
  assign averager_memory_error = averager_memory_read_q & ^averager_memory_word_q;

  // Memory census_memory, 80 x 78 and parity, DISTANCE 16, hls/stages/census.hpp:340; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [78:0] census_memory_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) census_memory_mem[i] = 79'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s1_q;
  logic census_memory_re;
  assign census_memory_re = s1_en & and_538_s1_q;
  logic [78:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [77:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[77:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory moments_memory, 4800 x 4 and parity, DISTANCE 16, hls/stages/moments.hpp:119; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [4:0] moments_memory_mem [0:4799];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 4800; i++) moments_memory_mem[i] = 5'h0;
`endif
  logic [12:0] moments_memory_raddr;
  assign moments_memory_raddr = select_562;
  logic moments_memory_re;
  assign moments_memory_re = s1_en & and_580;
  logic [4:0] moments_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (moments_memory_re) moments_memory_word_q <= moments_memory_mem[moments_memory_raddr];
  end
  logic [3:0] moments_memory_rdata_q;
  assign moments_memory_rdata_q = moments_memory_word_q[3:0];
  logic moments_memory_read_q, moments_memory_error;
  always_ff @(posedge clk_i) moments_memory_read_q <= rst_ni & moments_memory_re;
  assign moments_memory_error = moments_memory_read_q & ^moments_memory_word_q;

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1377; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_568_s1_q ? select_615 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_606_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1378; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s1_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s1_en & and_2037;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory left_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1379; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] left_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_turns_mem[i] = 3'h0;
`endif
  logic [6:0] left_turns_raddr;
  assign left_turns_raddr = x_s1_q[6:0];
  logic left_turns_re;
  assign left_turns_re = s1_en & and_2054;
  logic [2:0] left_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (left_turns_re) left_turns_word_q <= left_turns_mem[left_turns_raddr];
  end
  logic [1:0] left_turns_rdata_q;
  assign left_turns_rdata_q = left_turns_word_q[1:0];
  logic left_turns_read_q, left_turns_error;
  always_ff @(posedge clk_i) left_turns_read_q <= rst_ni & left_turns_re;
  assign left_turns_error = left_turns_read_q & ^left_turns_word_q;

  // Memory right_turns, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1379; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] right_turns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_turns_mem[i] = 3'h0;
`endif
  logic [6:0] right_turns_raddr;
  assign right_turns_raddr = select_615;
  logic right_turns_re;
  assign right_turns_re = s1_en & and_2054;
  logic [2:0] right_turns_word_q;
  always_ff @(posedge clk_i) begin
    if (right_turns_re) right_turns_word_q <= right_turns_mem[right_turns_raddr];
  end
  logic [1:0] right_turns_rdata_q;
  assign right_turns_rdata_q = right_turns_word_q[1:0];
  logic right_turns_read_q, right_turns_error;
  always_ff @(posedge clk_i) right_turns_read_q <= rst_ni & right_turns_re;
  assign right_turns_error = right_turns_read_q & ^right_turns_word_q;

  // Memory patches_right_codes, 112 x 28 and parity, DISTANCE 12, hls/stages/patches.hpp:792; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [28:0] patches_right_codes_mem [0:111];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 112; i++) patches_right_codes_mem[i] = 29'h0;
`endif
  logic [6:0] patches_right_codes_raddr;
  assign patches_right_codes_raddr = {select_2347, not_2342, select_2341};
  logic patches_right_codes_re;
  assign patches_right_codes_re = s1_en & or_2348;
  logic [28:0] patches_right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_right_codes_re) patches_right_codes_word_q <= patches_right_codes_mem[patches_right_codes_raddr];
  end
  logic [27:0] patches_right_codes_rdata_q;
  assign patches_right_codes_rdata_q = patches_right_codes_word_q[27:0];
  logic patches_right_codes_read_q, patches_right_codes_error;
  always_ff @(posedge clk_i) patches_right_codes_read_q <= rst_ni & patches_right_codes_re;
  assign patches_right_codes_error = patches_right_codes_read_q & ^patches_right_codes_word_q;

  // Memory patches_left_codes, 12 x 48 and parity, DISTANCE 12, hls/stages/patches.hpp:793; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [48:0] patches_left_codes_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) patches_left_codes_mem[i] = 49'h0;
`endif
  logic [3:0] patches_left_codes_raddr;
  assign patches_left_codes_raddr = patches_match_row_q;
  logic patches_left_codes_re;
  assign patches_left_codes_re = s1_en & (not_2243_s1_q & (new_row & equal_2244_s1_q));
  logic [48:0] patches_left_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_left_codes_re) patches_left_codes_word_q <= patches_left_codes_mem[patches_left_codes_raddr];
  end
  logic [47:0] patches_left_codes_rdata_q;
  assign patches_left_codes_rdata_q = patches_left_codes_word_q[47:0];
  logic patches_left_codes_read_q, patches_left_codes_error;
  always_ff @(posedge clk_i) patches_left_codes_read_q <= rst_ni & patches_left_codes_re;
  assign patches_left_codes_error = patches_left_codes_read_q & ^patches_left_codes_word_q;

  // Memory patches_rows, 17 x 15 and parity, DISTANCE 12, hls/stages/patches.hpp:807; read in stage 1, written in stage 3: 1 < 3 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [15:0] patches_rows_mem [0:16];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 17; i++) patches_rows_mem[i] = 16'h0;
`endif
  logic [4:0] patches_rows_raddr;
  assign patches_rows_raddr = patches_step_q[4:0];
  logic patches_rows_re;
  assign patches_rows_re = s1_en & and_2415;
  logic [15:0] patches_rows_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_rows_re) patches_rows_word_q <= patches_rows_mem[patches_rows_raddr];
  end
  logic [14:0] patches_rows_rdata_q;
  assign patches_rows_rdata_q = patches_rows_word_q[14:0];
  logic patches_rows_read_q, patches_rows_error;
  always_ff @(posedge clk_i) patches_rows_read_q <= rst_ni & patches_rows_re;
  assign patches_rows_error = patches_rows_read_q & ^patches_rows_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1406; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s1_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s1_en & and_2037;
  logic [18:0] seen_columns_word_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_word_q <= seen_columns_mem[seen_columns_raddr];
  end
  logic [17:0] seen_columns_rdata_q;
  assign seen_columns_rdata_q = seen_columns_word_q[17:0];
  logic seen_columns_read_q, seen_columns_error;
  always_ff @(posedge clk_i) seen_columns_read_q <= rst_ni & seen_columns_re;
  assign seen_columns_error = seen_columns_read_q & ^seen_columns_word_q;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s1_q[6:0];
  logic left_we;
  assign left_we = s1_en & and_639_s1_q;
  logic [84:0] left_wdata;
  assign left_wdata = {and_740, left_rdata_q[65:49], and_739, left_rdata_q[47:31], and_738, left_rdata_q[29:13], and_737, left_rdata_q[11:0], fresh_rdata_q[30:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_639_s1_q;
  logic [98:0] right_codes_wdata;
  assign right_codes_wdata = {and_746, right_codes_rdata_q[84:73], and_745, right_codes_rdata_q[71:60], and_744, right_codes_rdata_q[56:43], and_743, right_codes_rdata_q[41:28], and_742, right_codes_rdata_q[26:13], and_741, right_codes_rdata_q[11:0], fresh_rdata_q[32:31], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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

  // Memory patches_columns_above, write
  logic [4:0] patches_columns_above_waddr;
  assign patches_columns_above_waddr = patches_column_s1_q;
  logic patches_columns_above_we;
  assign patches_columns_above_we = s1_en & and_2329_s1_q;
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
      moments_place_q <= 14'h0;
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
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
    end else if (s1_en) begin
      moments_place_q <= select_561;
      moments_taken_q <= not_564 & (not_566 & (equal_567_s1_q & inside_v));
      moments_starts_q <= not_564 & (not_566 & (equal_567_s1_q & (inside_v & first)));
      row_q <= and_538_s1_q ? (equal_2910_s1_q ? row_s1_q : row_q) : row_q;
      lower_half_q <= and_538_s1_q ? select_3004 : lower_half_q;
      registration_slope_row_q <= select_3254;
      registration_slope_change_q <= select_3257;
      registration_slope_q <= so_s1_q ? column_8 : {registration_slope_row_q, 4'h0};
      patches_along_ends_q <= not_3489_s1_q & (patches_along_q == 5'hf);
      patches_match_row_ends_q <= not_3489_s1_q & select_3504;
      patches_smooth_values_0_q <= equal_2242_s1_q ? patches_smooth_values_0_q : select_3507;
      patches_smooth_values_1_q <= select_3511;
      patches_smooth_values_2_q <= select_3514;
      patches_smooth_values_3_q <= select_3517;
      patches_down_values_0_q <= equal_2242_s1_q ? patches_down_values_0_q : select_3519;
      patches_down_values_1_q <= equal_2242_s1_q ? patches_down_values_1_q : select_3522;
      patches_down_values_2_q <= equal_2242_s1_q ? patches_down_values_2_q : select_3525;
      patches_down_values_3_q <= equal_2242_s1_q ? patches_down_values_3_q : select_3528;
      patches_down_by_q <= or_3465_s1_q ? 5'h0 : (patches_down_by_q + {4'h0, and_3565});
      patches_along_q <= select_3570;
      patches_match_row_q <= or_3465_s1_q ? 4'h0 : select_3572;
      patches_summed_last_q <= not_2243_s1_q & (equal_2244_s1_q & and_3565);
      patches_summed_down_by_q <= select_3928;
      patches_step_q <= or_3465_s1_q ? 7'h0 : (patches_step_q + 7'h1);
      patches_read_searches_q <= select_3967;
      region_across_rest_q <= select_4306;
      region_across_back_q <= so_s1_q ? region_across_back_q : columns_begin_back_q;
      region_across_next_q <= select_4309;
      columns_begin_rest_q <= and_538_s1_q ? select_4311 : columns_begin_rest_q;
      columns_begin_back_q <= and_538_s1_q ? select_4314 : columns_begin_back_q;
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
      middle_sum_sum_sums_values_0_q <= sum_1000;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1240;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1480;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1724;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1964;
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
  logic moments_starts_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [6:0] last_s2_q;
  logic [1:0] age_s2_q;
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
  logic [2:0] select_502_s2_q;
  logic [6:0] select_504_s2_q;
  logic [8:0] select_508_s2_q;
  logic and_512_s2_q;
  logic and_513_s2_q;
  logic equal_518_s2_q;
  logic [6:0] column_s2_q;
  logic and_536_s2_q;
  logic and_538_s2_q;
  logic equal_558_s2_q;
  logic [12:0] select_562_s2_q;
  logic equal_563_s2_q;
  logic not_564_s2_q;
  logic so_s2_q;
  logic not_566_s2_q;
  logic equal_567_s2_q;
  logic or_568_s2_q;
  logic less_571_s2_q;
  logic not_572_s2_q;
  logic inside_v_s2_q;
  logic not_576_s2_q;
  logic and_580_s2_q;
  logic and_589_s2_q;
  logic and_597_s2_q;
  logic [6:0] x_s2_2_q;
  logic [61:0] best_left_rdata_s2_q;
  logic [6:0] right_s2_q;
  logic and_628_s2_q;
  logic and_633_s2_q;
  logic and_635_s2_q;
  logic equal_668_s2_q;
  logic and_2024_s2_q;
  logic equal_2025_s2_q;
  logic and_2035_s2_q;
  logic and_2037_s2_q;
  logic [6:0] select_2041_s2_q;
  logic or_2045_s2_q;
  logic and_2138_s2_q;
  logic and_2151_s2_q;
  logic less_2165_s2_q;
  logic [7:0] change_s2_q;
  logic equal_2242_s2_q;
  logic equal_2244_s2_q;
  logic equal_2247_s2_q;
  logic or_2248_s2_q;
  logic [4:0] select_2272_s2_q;
  logic select_2278_s2_q;
  logic [3:0] select_2319_s2_q;
  logic less_2335_s2_q;
  logic new_row_s2_q;
  logic or_2348_s2_q;
  logic [1:0] of_row_2_s2_q;
  logic less_2365_s2_q;
  logic less_2366_s2_q;
  logic less_2375_s2_q;
  logic less_2376_s2_q;
  logic and_2390_s2_q;
  logic and_2399_s2_q;
  logic and_2404_s2_q;
  logic less_2405_s2_q;
  logic equal_2406_s2_q;
  logic not_2407_s2_q;
  logic equal_2408_s2_q;
  logic not_2409_s2_q;
  logic sum_2437_s2_q;
  logic and_2458_s2_q;
  logic and_2575_s2_q;
  logic equal_2721_s2_q;
  logic equal_2910_s2_q;
  logic and_3017_s2_q;
  logic equal_3102_s2_q;
  logic less_3541_s2_q;
  logic equal_3884_s2_q;
  logic equal_3968_s2_q;
  logic less_4294_s2_q;
  logic equal_4513_s2_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= mask_s1_q;
      marks_first_s2_q <= sample_pair_first_q;
      marks_last_s2_q <= sample_last_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      moments_starts_s2_q <= moments_starts_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      last_s2_q <= last_s1_q;
      age_s2_q <= age_s1_q[2:1];
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
      select_502_s2_q <= select_502_s1_q;
      select_504_s2_q <= select_504_s1_q;
      select_508_s2_q <= select_508_s1_q;
      and_512_s2_q <= and_512_s1_q;
      and_513_s2_q <= and_513;
      equal_518_s2_q <= equal_518_s1_q;
      column_s2_q <= column_s1_q;
      and_536_s2_q <= and_536_s1_q;
      and_538_s2_q <= and_538_s1_q;
      equal_558_s2_q <= equal_558;
      select_562_s2_q <= select_562;
      equal_563_s2_q <= equal_563_s1_q;
      not_564_s2_q <= not_564;
      so_s2_q <= so_s1_q;
      not_566_s2_q <= not_566;
      equal_567_s2_q <= equal_567_s1_q;
      or_568_s2_q <= or_568_s1_q;
      less_571_s2_q <= less_571_s1_q;
      not_572_s2_q <= not_572_s1_q;
      inside_v_s2_q <= inside_v;
      not_576_s2_q <= not_576;
      and_580_s2_q <= and_580;
      and_589_s2_q <= or_568_s1_q & (left_rdata_q[70] & not_572_s1_q);
      and_597_s2_q <= (or_568_s1_q & (left_rdata_q[68] & not_572_s1_q)) & and_596;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      right_s2_q <= right_s1_q;
      and_628_s2_q <= or_568_s1_q & (left_rdata_q[71] & not_572_s1_q);
      and_633_s2_q <= or_568_s1_q & (right_codes_rdata_q[58] & not_572_s1_q);
      and_635_s2_q <= or_568_s1_q & (right_codes_rdata_q[59] & not_572_s1_q);
      equal_668_s2_q <= row_s1_q == 6'h0;
      and_2024_s2_q <= and_2024_s1_q;
      equal_2025_s2_q <= equal_2025_s1_q;
      and_2035_s2_q <= and_2035;
      and_2037_s2_q <= and_2037;
      select_2041_s2_q <= select_2041;
      or_2045_s2_q <= or_2045;
      and_2138_s2_q <= and_2138_s1_q;
      and_2151_s2_q <= and_2151_s1_q;
      less_2165_s2_q <= 5'h4 < row_q[5:1];
      change_s2_q <= change;
      equal_2242_s2_q <= equal_2242_s1_q;
      equal_2244_s2_q <= equal_2244_s1_q;
      equal_2247_s2_q <= equal_2247_s1_q;
      or_2248_s2_q <= or_2248_s1_q;
      select_2272_s2_q <= select_2272_s1_q;
      select_2278_s2_q <= select_2278_s1_q;
      select_2319_s2_q <= select_2319_s1_q;
      less_2335_s2_q <= less_2335;
      new_row_s2_q <= new_row;
      or_2348_s2_q <= or_2348;
      of_row_2_s2_q <= of_row_2;
      less_2365_s2_q <= $signed(15'h100) < $signed(sum_2364);
      less_2366_s2_q <= $signed(sum_2364[14:8]) < $signed(7'h7f);
      less_2375_s2_q <= $signed(15'h100) < $signed(difference_2374);
      less_2376_s2_q <= $signed(difference_2374[14:8]) < $signed(7'h7f);
      and_2390_s2_q <= not_2243_s1_q & and_2389;
      and_2399_s2_q <= and_2399;
      and_2404_s2_q <= not_2243_s1_q & and_2403;
      less_2405_s2_q <= less_2405;
      equal_2406_s2_q <= equal_2406;
      not_2407_s2_q <= not_2407;
      equal_2408_s2_q <= equal_2408;
      not_2409_s2_q <= not_2409;
      sum_2437_s2_q <= sum_2437[5];
      and_2458_s2_q <= or_568_s1_q & (left_rdata_q[69] & not_572_s1_q);
      and_2575_s2_q <= (6'h6 < row_q) & (~(x_s1_q[7:2] == 6'h0));
      equal_2721_s2_q <= {column_s1_q[6], or_2720} == 7'h0;
      equal_2910_s2_q <= equal_2910_s1_q;
      and_3017_s2_q <= or_568_s1_q & (not_572_s1_q & and_596);
      equal_3102_s2_q <= shift == 6'h0;
      less_3541_s2_q <= 4'he < patches_column_s1_q[4:1];
      equal_3884_s2_q <= patches_match_row_q == 4'h0;
      equal_3968_s2_q <= patches_step_q[6:5] == 2'h2;
      less_4294_s2_q <= 5'h2 < row_s1_q[5:1];
      equal_4513_s2_q <= row_s1_q[5:3] == 3'h0;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:113
  logic [11:0] select_516;
  assign select_516 = select_502_s2_q[0] ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:122
  logic [11:0] sum_520;
  assign sum_520 = select_516 + (equal_518_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:113
  logic [11:0] sum_522;
  assign sum_522 = {4'h0, sample_pair_pixel_1_q} + (select_502_s2_q[0] ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:122
  logic [11:0] sum_524;
  assign sum_524 = sum_522 + (equal_518_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:418
  logic whole;
  assign whole = select_502_s2_q[0] ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:123
  logic and_528;
  assign and_528 = whole & (averager_memory_rdata_q[24] | equal_518_s2_q);
  // hls/stages/agreement.hpp:418
  logic all_of_skin;
  assign all_of_skin = select_502_s2_q[0] ? (sample_of_skin_q & averager_running_of_skin_q) : sample_of_skin_q;
  // hls/stages/census.hpp:124
  logic and_532;
  assign and_532 = all_of_skin & (averager_memory_rdata_q[25] | equal_518_s2_q);
  // hls/stages/census.hpp:207
  logic [8:0] grey;
  assign grey = and_512_s2_q ? sum_520[11:3] : 9'h0;
  // hls/stages/census.hpp:127
  logic equal_541;
  assign equal_541 = select_502_s2_q == 3'h1;
  // hls/stages/census.hpp:208
  logic [10:0] total;
  assign total = {2'h0, grey} + (equal_541 ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_544;
  assign select_544 = sample_pair_whole_s2_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic [8:0] grey_2;
  assign grey_2 = and_512_s2_q ? sum_524[11:3] : 9'h0;
  // hls/stages/census.hpp:208
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2} + (equal_541 ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_548;
  assign select_548 = sample_pair_whole_s2_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:207
  logic and_549;
  assign and_549 = and_512_s2_q & and_528;
  // hls/stages/census.hpp:127
  logic select_551;
  assign select_551 = equal_541 ? and_549 : (averager_mask_q & and_549);
  // hls/stages/agreement.hpp:276
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_551;
  // hls/stages/census.hpp:207
  logic and_553;
  assign and_553 = and_512_s2_q & and_532;
  // hls/stages/census.hpp:127
  logic select_555;
  assign select_555 = equal_541 ? and_553 : (averager_of_skin_q & and_553);
  // hls/stages/agreement.hpp:276
  logic and_556;
  assign and_556 = sample_pair_whole_s2_q & select_555;
  // hls/stages/agreement.hpp:979
  logic select_610;
  assign select_610 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:980
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:993
  logic [8:0] difference_620;
  assign difference_620 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:994
  logic [9:0] sum_621;
  assign sum_621 = {difference_620[8], difference_620} + 10'h1;
  // hls/stages/agreement.hpp:247
  logic and_623;
  assign and_623 = (and_597_s2_q & select_610) & ({{22{sum_621[9]}}, sum_621} < 32'h3);
  // hls/stages/agreement.hpp:149
  logic and_625;
  assign and_625 = or_568_s2_q & (not_572_s2_q & and_623);
  // hls/stages/moments.hpp:77
  logic and_626;
  assign and_626 = and_589_s2_q & and_625;
  // hls/stages/census.hpp:296
  logic less_641;
  assign less_641 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_642;
  assign less_642 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_643;
  assign less_643 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_644;
  assign less_644 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_645;
  assign less_645 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_646;
  assign less_646 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_647;
  assign less_647 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_648;
  assign less_648 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_649;
  assign less_649 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_650;
  assign less_650 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_651;
  assign less_651 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_652;
  assign less_652 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:297
  logic less_653;
  assign less_653 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_654;
  assign less_654 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_655;
  assign less_655 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_656;
  assign less_656 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_657;
  assign less_657 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_658;
  assign less_658 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_659;
  assign less_659 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_660;
  assign less_660 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_661;
  assign less_661 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_662;
  assign less_662 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_663;
  assign less_663 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_664;
  assign less_664 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/agreement.hpp:456
  logic equal_665;
  assign equal_665 = column_s2_q == 7'h0;
  logic [3:0] select_669;
  assign select_669 = equal_668_s2_q ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:457
  logic [4:0] select_670;
  assign select_670 = equal_665 ? {select_669, 1'b1} : rows_passed_above_q;
  // hls/stages/census.hpp:278
  logic [3:0] select_671;
  assign select_671 = equal_665 ? 4'h0 : census_filled_q;
  // hls/stages/census.hpp:301
  logic and_672;
  assign and_672 = select_670[4] & select_671[3];
  // hls/stages/census.hpp:288
  logic and_674;
  assign and_674 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2);
  logic and_676;
  assign and_676 = census_memory_rdata_q[77] & (census_memory_rdata_q[58] & and_674);
  // hls/stages/agreement.hpp:457
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_676;
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
  logic [9:0] difference_699;
  assign difference_699 = {1'b0, select_544} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_700;
  assign xor_700 = difference_699[8:0] ^ {9{difference_699[9]}};
  logic [9:0] sum_701;
  assign sum_701 = {9'h0, difference_699[9]} + {1'b0, xor_700};
  logic [9:0] difference_702;
  assign difference_702 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_703;
  assign xor_703 = difference_702[8:0] ^ {9{difference_702[9]}};
  logic [9:0] sum_704;
  assign sum_704 = {9'h0, difference_702[9]} + {1'b0, xor_703};
  logic [9:0] difference_706;
  assign difference_706 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_707;
  assign xor_707 = difference_706[8:0] ^ {9{difference_706[9]}};
  logic [9:0] sum_708;
  assign sum_708 = {9'h0, difference_706[9]} + {1'b0, xor_707};
  logic [10:0] sum_709;
  assign sum_709 = ({1'b0, sum_701} + {1'b0, sum_704}) + {1'b0, sum_708};
  logic [9:0] difference_710;
  assign difference_710 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_711;
  assign xor_711 = difference_710[8:0] ^ {9{difference_710[9]}};
  logic [9:0] sum_712;
  assign sum_712 = {9'h0, difference_710[9]} + {1'b0, xor_711};
  logic [9:0] difference_714;
  assign difference_714 = {1'b0, census_memory_rdata_q[67:59]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_715;
  assign xor_715 = difference_714[8:0] ^ {9{difference_714[9]}};
  // hls/stages/agreement.hpp:457
  logic and_723;
  assign and_723 = census_columns_values_0_cell_2_mask_q & census_columns_values_1_cell_2_mask_q;
  logic and_724;
  assign and_724 = and_672 & and_723;
  // hls/stages/census.hpp:308
  logic [9:0] half_grey_levels;
  assign half_grey_levels = {1'b0, census_columns_values_0_cell_2_left_q} - {1'b0, census_columns_values_1_cell_2_left_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_726;
  assign sum_726 = {half_grey_levels[9], half_grey_levels[9:4]} + 7'h7f;
  // hls/stages/census.hpp:308
  logic and_728;
  assign and_728 = and_724 & ({{5{sum_726[6]}}, sum_726, half_grey_levels[3:0]} < 16'hffe1);
  // hls/stages/census.hpp:309
  logic [9:0] half_grey_levels_2;
  assign half_grey_levels_2 = {1'b0, census_columns_values_0_cell_2_right_q} - {1'b0, census_columns_values_1_cell_2_right_q};
  // hls/stages/moments.hpp:30
  logic [6:0] sum_732;
  assign sum_732 = {half_grey_levels_2[9], half_grey_levels_2[9:4]} + 7'h7f;
  // hls/stages/agreement.hpp:808
  logic or_748;
  assign or_748 = shift_first_s2_q | (~shift_not_right_q);
  // hls/stages/agreement.hpp:809
  logic select_750;
  assign select_750 = or_748 ? shift_first_s2_q : (~age_s2_q[0]);
  // hls/stages/agreement.hpp:752
  logic less_1481;
  assign less_1481 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1482;
  assign select_1482 = less_1481 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1483;
  assign less_1483 = middle_sum_sum_sums_values_0_q < select_1482;
  logic [7:0] select_1484;
  assign select_1484 = less_1483 ? select_1482 : middle_sum_sum_sums_values_0_q;
  logic less_1965;
  assign less_1965 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1966;
  assign select_1966 = less_1965 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1967;
  assign less_1967 = select_1484 < select_1966;
  // hls/stages/agreement.hpp:802
  logic [7:0] of_best;
  assign of_best = shift_allowed_q ? (less_1967 ? select_1966 : select_1484) : 8'h0;
  // hls/stages/agreement.hpp:809
  logic or_1971;
  assign or_1971 = select_750 | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:814
  logic [5:0] select_1972;
  assign select_1972 = or_1971 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:753
  logic or_1974;
  assign or_1974 = less_1481 | (~less_1483);
  logic [2:0] select_1975;
  assign select_1975 = less_1967 ? {less_1965, 2'h0} : {1'b0, or_1974, less_1483};
  // hls/stages/agreement.hpp:814
  logic [2:0] select_1976;
  assign select_1976 = or_1971 ? select_1975 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1977;
  assign select_1977 = or_1971 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:811
  logic equal_1978;
  assign equal_1978 = select_1975 == 3'h1;
  logic or_1981;
  assign or_1981 = equal_1978 | (~(select_1975 == 3'h2));
  logic [7:0] select_1983;
  assign select_1983 = or_1981 ? middle_sum_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic [7:0] select_1984;
  assign select_1984 = equal_1978 ? (or_1981 ? sums_2_sum_sums_values_0_q : {7'h0, shift_not_right_q}) : select_1983;
  // hls/stages/agreement.hpp:814
  logic [7:0] select_1985;
  assign select_1985 = or_1971 ? select_1984 : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:811
  logic [7:0] select_1986;
  assign select_1986 = or_1981 ? sums_3_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:814
  logic [7:0] select_1988;
  assign select_1988 = or_1971 ? (equal_1978 ? select_1983 : select_1986) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1990;
  assign sum_1990 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1991;
  assign sum_1991 = {1'b0, before_v} + sum_1990;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1993;
  assign sum_1993 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1994;
  assign sum_1994 = {1'b0, before_v_2} + sum_1993;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_1996;
  assign sum_1996 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1997;
  assign sum_1997 = {1'b0, before_v_3} + sum_1996;
  // hls/stages/agreement.hpp:752
  logic [6:0] select_1999;
  assign select_1999 = (sum_1994 < sum_1997) ? sum_1997 : sum_1994;
  logic [6:0] select_2001;
  assign select_2001 = (sum_1991 < select_1999) ? select_1999 : sum_1991;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_2003;
  assign sum_2003 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_2004;
  assign sum_2004 = {1'b0, before_v_4} + sum_2003;
  // hls/stages/agreement.hpp:780
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:781
  logic [6:0] sum_2006;
  assign sum_2006 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_2007;
  assign sum_2007 = {1'b0, before_v_5} + sum_2006;
  // hls/stages/agreement.hpp:752
  logic [6:0] select_2009;
  assign select_2009 = (sum_2004 < sum_2007) ? sum_2007 : sum_2004;
  // hls/stages/agreement.hpp:803
  logic [6:0] of_near;
  assign of_near = shift_allowed_q ? ((select_2001 < select_2009) ? select_2009 : select_2001) : 7'h0;
  // hls/stages/agreement.hpp:814
  logic less_2013;
  assign less_2013 = best_left_rdata_s2_q[39:33] < of_near;
  // hls/stages/agreement.hpp:818
  logic [6:0] select_2015;
  assign select_2015 = select_750 ? of_near : (less_2013 ? of_near : best_left_rdata_s2_q[39:33]);
  logic [5:0] select_2017;
  assign select_2017 = select_750 ? run_shift_s2_q : (less_2013 ? run_shift_s2_q : best_left_rdata_s2_q[45:40]);
  logic [7:0] select_2020;
  assign select_2020 = (run_shift_s2_q == 6'h3f) ? of_best : (select_750 ? 8'h0 : best_left_rdata_s2_q[53:46]);
  // hls/stages/agreement.hpp:819
  logic [7:0] select_2023;
  assign select_2023 = (run_shift_s2_q == 6'h1) ? of_best : (select_750 ? 8'h0 : best_left_rdata_s2_q[61:54]);
  // hls/stages/agreement.hpp:824
  logic select_2026;
  assign select_2026 = or_748 ? shift_first_s2_q : equal_2025_s2_q;
  // hls/stages/agreement.hpp:825
  logic or_2028;
  assign or_2028 = select_2026 | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:829
  logic [7:0] select_2029;
  assign select_2029 = or_2028 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_2030;
  assign select_2030 = or_2028 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_2032;
  assign or_2032 = select_2026 | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:833
  logic [6:0] select_2033;
  assign select_2033 = or_2032 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_2034;
  assign select_2034 = or_2032 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:149
  logic and_2048;
  assign and_2048 = or_568_s2_q & (not_572_s2_q & (and_623 & or_2045_s2_q));
  // hls/stages/agreement.hpp:789
  logic and_2049;
  assign and_2049 = not_566_s2_q & and_2048;
  logic and_2052;
  assign and_2052 = not_564_s2_q & (so_s2_q ? and_2035_s2_q : (equal_567_s2_q & and_625));
  // hls/stages/moments.hpp:73
  logic and_2056;
  assign and_2056 = moments_has_before_q & moments_memory_rdata_q[0];
  // hls/stages/agreement.hpp:1004
  logic and_2057;
  assign and_2057 = not_576_s2_q & and_2056;
  logic and_2060;
  assign and_2060 = not_576_s2_q & (and_2056 & (moments_memory_rdata_q[1] ^ and_628_s2_q));
  // hls/stages/moments.hpp:73
  logic and_2065;
  assign and_2065 = moments_has_before_q & moments_memory_rdata_q[2];
  // hls/stages/agreement.hpp:1004
  logic and_2066;
  assign and_2066 = not_576_s2_q & and_2065;
  logic and_2069;
  assign and_2069 = not_576_s2_q & (and_2065 & (moments_memory_rdata_q[3] ^ and_635_s2_q));
  // hls/stages/agreement.hpp:1129
  logic equal_2070;
  assign equal_2070 = x_s2_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:1179
  logic [1:0] quarter;
  assign quarter = x_s2_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:147
  logic all;
  assign all = x_s2_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:1130
  logic [1:0] select_2073;
  assign select_2073 = x_s2_q[4] ? {x_s2_q[3], x_s2_q[0]} : {x_s2_q[0], x_s2_q[3]};
  // hls/stages/agreement.hpp:1143
  logic [3:0] select_2075;
  assign select_2075 = equal_2070 ? {2'h0, quarter} : (all ? {1'b0, x_s2_q[2:0]} : {x_s2_q[2:1], select_2073});
  // hls/stages/registration.hpp:107
  logic [1:0] sum_2076;
  assign sum_2076 = slot_s2_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:789
  logic [3:0] select_2077;
  assign select_2077 = equal_563_s2_q ? select_2075 : {sum_2076, lower_half_s2_q, registration_of_right_q};
  // hls/stages/patches.hpp:210
  logic equal_2078;
  assign equal_2078 = x_s2_q[5:0] == 6'h3f;
  logic equal_2080;
  assign equal_2080 = x_s2_q[5:0] == 6'h3e;
  logic equal_2082;
  assign equal_2082 = x_s2_q[5:0] == 6'h3d;
  logic equal_2084;
  assign equal_2084 = x_s2_q[5:0] == 6'h3c;
  logic equal_2086;
  assign equal_2086 = x_s2_q[5:0] == 6'h3b;
  logic equal_2088;
  assign equal_2088 = x_s2_q[5:0] == 6'h36;
  logic equal_2090;
  assign equal_2090 = x_s2_q[5:0] == 6'h35;
  logic equal_2092;
  assign equal_2092 = x_s2_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:1179
  logic and_2096;
  assign and_2096 = (~equal_2086) & ((~equal_2088) & ((~equal_2090) & (~equal_2092)));
  logic and_2100;
  assign and_2100 = (~equal_2078) & ((~equal_2080) & ((~equal_2082) & ((~equal_2084) & and_2096)));
  // hls/stages/agreement.hpp:1130
  logic less_2101;
  assign less_2101 = x_s2_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:148
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s2_q[2]} : x_s2_q[2:1];
  // hls/stages/registration.hpp:160
  logic or_2105;
  assign or_2105 = (kind == 2'h3) | (x_s2_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:1010
  logic [5:0] sum_2110;
  assign sum_2110 = {1'b0, last_s2_q[6:2]} + 6'h1;
  // hls/stages/agreement.hpp:262
  logic right_2;
  assign right_2 = inside_v_s2_q & ({1'b0, sum_2110, last_s2_q[1]} < x_s2_q);
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s2_q ? (right_2 & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:107
  logic [4:0] sum_2116;
  assign sum_2116 = {2'h0, slot_s2_q} + 5'h1f;
  logic and_2118;
  assign and_2118 = half_ends & ({{3{sum_2116[4]}}, sum_2116} < 8'h3);
  // hls/stages/agreement.hpp:789
  logic and_2119;
  assign and_2119 = so_s2_q & and_2118;
  logic select_2120;
  assign select_2120 = equal_563_s2_q ? (x_s2_q[6] & (equal_2070 ? and_2100 : (less_2101 & (~or_2105)))) : and_2119;
  // hls/stages/registration.hpp:258
  logic not_2122;
  assign not_2122 = ~lower_half_s2_q;
  logic [3:0] select_2123;
  assign select_2123 = registration_of_right_q ? {lower_half_s2_q, 1'b0, not_2122, 1'b0} : {1'b0, lower_half_s2_q, 1'b0, not_2122};
  // hls/stages/patches.hpp:373
  logic [1:0] select_2152;
  assign select_2152 = and_2151_s2_q ? 2'h1 : patches_fetch_q;
  logic [4:0] select_2153;
  assign select_2153 = and_2151_s2_q ? patches_band_rows_number_s2_q : patches_band_q;
  // hls/stages/agreement.hpp:276
  logic [5:0] select_2154;
  assign select_2154 = and_2138_s2_q ? {select_2153, select_2152[1]} : {patches_band_q, patches_fetch_q[1]};
  // hls/stages/patches.hpp:126
  logic [1:0] select_2155;
  assign select_2155 = and_2138_s2_q ? select_2152 : patches_fetch_q;
  logic equal_2156;
  assign equal_2156 = select_2155 == 2'h0;
  // hls/stages/patches.hpp:103
  logic right_3;
  assign right_3 = {2'h0, last_s2_q[6:1]} < x_s2_q;
  // hls/stages/agreement.hpp:789
  logic and_2164;
  assign and_2164 = not_564_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & right_3)));
  // hls/stages/registration.hpp:83
  logic equal_2166;
  assign equal_2166 = slot_s2_q == 3'h7;
  // hls/stages/agreement.hpp:149
  logic [5:0] b;
  assign b = or_568_s2_q ? (less_571_s2_q ? 6'h0 : best_left_rdata_s2_q[5:0]) : 6'h0;
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2166 ? registration_slope_here_q : change_s2_q;
  // hls/stages/registration.hpp:211
  logic [6:0] select_2174;
  assign select_2174 = b[0] ? a[7:1] : 7'h0;
  logic [7:0] select_2175;
  assign select_2175 = b[1] ? a : 8'h0;
  logic [8:0] sum_2176;
  assign sum_2176 = {{2{select_2174[6]}}, select_2174} + {select_2175[7], select_2175};
  // hls/stages/registration.hpp:212
  logic [7:0] select_2177;
  assign select_2177 = b[2] ? a : 8'h0;
  logic [7:0] select_2178;
  assign select_2178 = b[3] ? a : 8'h0;
  logic [8:0] sum_2179;
  assign sum_2179 = {{2{select_2177[7]}}, select_2177[7:1]} + {select_2178[7], select_2178};
  // hls/stages/registration.hpp:214
  logic [10:0] sum_2180;
  assign sum_2180 = {{3{sum_2176[8]}}, sum_2176[8:1]} + {sum_2179[8], sum_2179, select_2177[0]};
  // hls/stages/registration.hpp:213
  logic [7:0] select_2181;
  assign select_2181 = b[4] ? a : 8'h0;
  logic [7:0] select_2182;
  assign select_2182 = b[5] ? a : 8'h0;
  logic [8:0] difference_2183;
  assign difference_2183 = {{2{select_2181[7]}}, select_2181[7:1]} - {select_2182[7], select_2182};
  // hls/stages/registration.hpp:214
  logic [9:0] sum_2184;
  assign sum_2184 = {difference_2183, select_2181[0]} + {sum_2180[10], sum_2180[10:2]};
  // hls/stages/registration.hpp:107
  logic [10:0] expected;
  assign expected = equal_2166 ? {sum_2184, sum_2180[1]} : registration_expected_q;
  // hls/stages/patches.hpp:98
  logic [9:0] sum_2186;
  assign sum_2186 = {expected[10], expected[10:2]} + 10'h5;
  // hls/stages/agreement.hpp:262
  logic and_2189;
  assign and_2189 = less_2165_s2_q & (and_625 & ({{4{sum_2186[9]}}, sum_2186, expected[1:0]} < 16'h29));
  // hls/stages/patches.hpp:104
  logic and_2193;
  assign and_2193 = ({3'h0, last_s2_q[6:1]} < ({1'b0, x_s2_q} + 9'h1)) & (~right_3);
  // hls/stages/patches.hpp:102
  logic [9:0] sum_2199;
  assign sum_2199 = {2'h0, x_s2_q} + {{4{b[5]}}, b};
  // hls/stages/patches.hpp:106
  logic [9:0] sum_2201;
  assign sum_2201 = {sum_2199[9], sum_2199[9:1]} + 10'h1;
  // hls/stages/agreement.hpp:1019
  logic and_2204;
  assign and_2204 = ($signed(9'h0) < $signed(sum_2199[9:1])) & (~($signed({4'h0, last_s2_q}) < $signed({sum_2201, sum_2199[0]})));
  logic and_2205;
  assign and_2205 = (~(and_2193 | (equal_558_s2_q | (~(x_s2_q < {1'b0, last_s2_q}))))) & and_2204;
  // hls/stages/agreement.hpp:789
  logic and_2209;
  assign and_2209 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2189 & and_2205)));
  logic and_2210;
  assign and_2210 = not_564_s2_q & and_2209;
  // hls/stages/patches.hpp:156
  logic and_2212;
  assign and_2212 = and_2210 & (~patches_fixed_q);
  // hls/stages/patches.hpp:344
  logic select_2213;
  assign select_2213 = and_2212 ? and_2210 : patches_choice_valid_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_2216;
  assign select_2216 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? x_s2_q : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:344
  logic [7:0] select_2218;
  assign select_2218 = and_2212 ? (equal_563_s2_q ? 8'h0 : select_2216) : patches_choice_column_q;
  // hls/stages/agreement.hpp:789
  logic [5:0] select_2221;
  assign select_2221 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? b : 6'h0) : 6'h0) : 6'h0;
  // hls/stages/patches.hpp:344
  logic [5:0] select_2223;
  assign select_2223 = and_2212 ? (equal_563_s2_q ? 6'h0 : select_2221) : patches_choice_shift_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2224;
  assign sum_2224 = {registration_slope_s2_q[11], registration_slope_s2_q} + {{5{sum_2184[9]}}, sum_2184[9:2]};
  // hls/stages/registration.hpp:218
  logic [7:0] select_2227;
  assign select_2227 = ($signed(sum_2224[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2224[7:0];
  // hls/stages/registration.hpp:107
  logic [7:0] slope;
  assign slope = equal_2166 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2224[12:7])) ? 8'h7f : select_2227);
  // hls/stages/agreement.hpp:789
  logic [7:0] select_2232;
  assign select_2232 = so_s2_q ? (ends_cell_s2_q ? (inside_v_s2_q ? slope : 8'h0) : 8'h0) : 8'h0;
  // hls/stages/patches.hpp:344
  logic [7:0] select_2234;
  assign select_2234 = and_2212 ? (equal_563_s2_q ? 8'h0 : select_2232) : patches_choice_slope_q;
  // hls/stages/patches.hpp:113
  logic equal_2235;
  assign equal_2235 = x_s2_q == {1'b0, last_s2_q};
  // hls/stages/agreement.hpp:789
  logic and_2239;
  assign and_2239 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_2193 | equal_2235)));
  logic and_2240;
  assign and_2240 = not_564_s2_q & and_2239;
  // hls/stages/patches.hpp:344
  logic and_2241;
  assign and_2241 = patches_chooses_s2_q & and_2240;
  // hls/stages/patches.hpp:126
  logic [4:0] select_2255;
  assign select_2255 = and_2138_s2_q ? select_2153 : patches_band_q;
  // hls/stages/patches.hpp:353
  logic equal_2256;
  assign equal_2256 = {patches_choosing_band_s2_q, and_2164} == {select_2255, select_2155[1]};
  // hls/stages/patches.hpp:482
  logic [2:0] sum_2356;
  assign sum_2356 = patches_code_row_s2_q[4:2] + 3'h7;
  // hls/stages/patches.hpp:486
  logic [1:0] sum_2394;
  assign sum_2394 = patches_code_row_s2_q[3:2] + 2'h3;
  // hls/stages/agreement.hpp:205
  logic [7:0] select_2424;
  assign select_2424 = so_s2_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:1051
  logic or_2427;
  assign or_2427 = select_2424[7] | (~({select_2424[5], select_2424[3], select_2424[1]} == 3'h0));
  // hls/stages/agreement.hpp:1050
  logic or_2430;
  assign or_2430 = select_2424[7] | (~({select_2424[6], select_2424[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:1049
  logic or_2433;
  assign or_2433 = select_2424[7] | (~(select_2424[6:4] == 3'h0));
  // hls/stages/agreement.hpp:789
  logic [5:0] select_2434;
  assign select_2434 = equal_563_s2_q ? x_s2_q[5:0] : {region_row_q, or_2433, or_2430, or_2427};
  // hls/stages/agreement.hpp:1129
  logic not_2435;
  assign not_2435 = ~equal_2070;
  // hls/stages/agreement.hpp:1059
  logic or_2439;
  assign or_2439 = (~sum_2437_s2_q) | equal_2235;
  // hls/stages/agreement.hpp:789
  logic and_2442;
  assign and_2442 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & or_2439));
  // hls/stages/agreement.hpp:262
  logic textured;
  assign textured = inside_v_s2_q & (or_568_s2_q & (not_572_s2_q & and_597_s2_q));
  logic explained;
  assign explained = inside_v_s2_q & and_625;
  // hls/stages/agreement.hpp:149
  logic and_2460;
  assign and_2460 = or_568_s2_q & (not_572_s2_q & and_2458_s2_q);
  // hls/stages/agreement.hpp:262
  logic and_2469;
  assign and_2469 = inside_v_s2_q & and_2460;
  // hls/stages/agreement.hpp:1015
  logic select_2470;
  assign select_2470 = slot_s2_q[2] ? shown_shown_q : and_625;
  // hls/stages/agreement.hpp:262
  logic shown;
  assign shown = inside_v_s2_q & (shown_right_rdata_q[0] | select_2470);
  // hls/stages/agreement.hpp:1015
  logic select_2473;
  assign select_2473 = slot_s2_q[2] ? shown_nearer_q : and_2048;
  // hls/stages/agreement.hpp:262
  logic near;
  assign near = inside_v_s2_q & (select_2470 ? select_2473 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:1276
  logic or_2476;
  assign or_2476 = marks_first_s2_q | line_ended_q;
  // hls/stages/agreement.hpp:1278
  logic [16:0] select_2478;
  assign select_2478 = marks_first_s2_q ? 17'h1 : (or_2476 ? {rows_passed_q[15:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:1277
  logic [8:0] select_2480;
  assign select_2480 = or_2476 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:1285
  logic select_2482;
  assign select_2482 = cfg_compete_i ? (or_2476 & select_2478[16]) : (select_2480[8] & select_2478[9]);
  // hls/stages/agreement.hpp:436
  logic next_row;
  assign next_row = select_2482 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1292
  logic [6:0] select_2485;
  assign select_2485 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2487;
  assign select_2487 = marks_first_s2_q ? 13'h0 : (seen_base_q + {6'h0, select_2485});
  // hls/stages/agreement.hpp:1302
  logic equal_2488;
  assign equal_2488 = seen_x_q == 3'h7;
  logic [7:0] select_2490;
  assign select_2490 = select_2482 ? 8'h0 : (seen_column_q + {7'h0, equal_2488});
  // hls/stages/agreement.hpp:1309
  logic [12:0] index;
  assign index = select_2487 + {5'h0, select_2490};
  // hls/stages/agreement.hpp:1276
  logic select_2493;
  assign select_2493 = marks_first_s2_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:1262
  logic [7:0] sum_2494;
  assign sum_2494 = {1'b0, select_2493, 2'h0, select_2493, 1'b0, {2{select_2493}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:1275
  logic not_2495;
  assign not_2495 = ~marks_first_s2_q;
  // hls/stages/agreement.hpp:436
  logic and_2497;
  assign and_2497 = not_2495 & (began_q | select_2482);
  // hls/stages/agreement.hpp:1303
  logic [2:0] select_2499;
  assign select_2499 = select_2482 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1308
  logic and_2501;
  assign and_2501 = and_2497 & (select_2499 == 3'h0);
  logic less_2502;
  assign less_2502 = select_2490 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:1112
  logic [7:0] sum_2505;
  assign sum_2505 = {2'h0, x_s2_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2505[7]}}, sum_2505, x_s2_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:1262
  logic [7:0] sum_2507;
  assign sum_2507 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:1031
  logic and_2508;
  assign and_2508 = seen_columns_rdata_q[14] & inside_v_s2_q;
  logic and_2509;
  assign and_2509 = seen_columns_rdata_q[10] & inside_v_s2_q;
  logic and_2510;
  assign and_2510 = seen_columns_rdata_q[5] & inside_v_s2_q;
  logic and_2511;
  assign and_2511 = seen_columns_rdata_q[0] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1088
  logic [1:0] sum_2513;
  assign sum_2513 = {1'b0, and_2510} + ({1'b0, textured} + {1'b0, and_2511});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2508} + ({2'h0, and_2509} + {1'b0, sum_2513});
  // hls/stages/agreement.hpp:1031
  logic [7:0] select_2522;
  assign select_2522 = inside_v_s2_q ? (sum_2437_s2_q ? select_2424 : {select_2424[6:0], 1'b0}) : select_2424;
  // hls/stages/agreement.hpp:1051
  logic or_2525;
  assign or_2525 = select_2522[7] | (~({select_2522[5], select_2522[3], select_2522[1]} == 3'h0));
  // hls/stages/agreement.hpp:1031
  logic and_2542;
  assign and_2542 = seen_columns_rdata_q[16] & inside_v_s2_q;
  logic and_2543;
  assign and_2543 = seen_columns_rdata_q[12] & inside_v_s2_q;
  logic and_2544;
  assign and_2544 = seen_columns_rdata_q[8] & inside_v_s2_q;
  logic and_2545;
  assign and_2545 = seen_columns_rdata_q[3] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1090
  logic [1:0] sum_2547;
  assign sum_2547 = {1'b0, and_2544} + ({1'b0, shown} + {1'b0, and_2545});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2542} + ({2'h0, and_2543} + {1'b0, sum_2547});
  // hls/stages/agreement.hpp:1031
  logic and_2558;
  assign and_2558 = seen_columns_rdata_q[17] & inside_v_s2_q;
  logic and_2559;
  assign and_2559 = seen_columns_rdata_q[13] & inside_v_s2_q;
  logic and_2560;
  assign and_2560 = seen_columns_rdata_q[9] & inside_v_s2_q;
  logic and_2561;
  assign and_2561 = seen_columns_rdata_q[4] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1091
  logic [1:0] sum_2563;
  assign sum_2563 = {1'b0, and_2560} + ({1'b0, near} + {1'b0, and_2561});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2558} + ({2'h0, and_2559} + {1'b0, sum_2563});
  // hls/stages/agreement.hpp:789
  logic and_2579;
  assign and_2579 = ends_cell_s2_q & (and_2575_s2_q & (~({sum_2110, last_s2_q[1:0]} < x_s2_q)));
  logic and_2581;
  assign and_2581 = not_564_s2_q & (so_s2_q & and_2579);
  // hls/stages/agreement.hpp:276
  logic [10:0] select_2613;
  assign select_2613 = sample_pair_whole_s2_q ? (and_536_s2_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2615;
  assign select_2615 = sample_pair_whole_s2_q ? (and_536_s2_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  logic select_2634;
  assign select_2634 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2636;
  assign select_2636 = sample_pair_whole_s2_q ? (and_536_s2_q ? select_551 : averager_mask_q) : averager_mask_q;
  logic select_2638;
  assign select_2638 = sample_pair_whole_s2_q ? (and_536_s2_q ? select_555 : averager_of_skin_q) : averager_of_skin_q;
  // hls/stages/agreement.hpp:521
  logic [8:0] select_2639;
  assign select_2639 = and_538_s2_q ? select_544 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2640;
  assign select_2640 = and_538_s2_q ? select_548 : census_columns_values_0_cell_0_right_q;
  logic [8:0] select_2642;
  assign select_2642 = and_538_s2_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2643;
  assign select_2643 = and_538_s2_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2644;
  assign select_2644 = and_538_s2_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic [8:0] select_2645;
  assign select_2645 = and_538_s2_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2646;
  assign select_2646 = and_538_s2_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2647;
  assign select_2647 = and_538_s2_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2648;
  assign select_2648 = and_538_s2_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2649;
  assign select_2649 = and_538_s2_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2650;
  assign select_2650 = and_538_s2_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2651;
  assign select_2651 = and_538_s2_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic [8:0] select_2652;
  assign select_2652 = and_538_s2_q ? census_memory_rdata_q[67:59] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2653;
  assign select_2653 = and_538_s2_q ? census_memory_rdata_q[76:68] : census_columns_values_0_cell_4_right_q;
  logic select_2654;
  assign select_2654 = and_538_s2_q ? census_memory_rdata_q[77] : census_columns_values_0_cell_4_mask_q;
  logic [8:0] select_2655;
  assign select_2655 = and_538_s2_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2656;
  assign select_2656 = and_538_s2_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2657;
  assign select_2657 = and_538_s2_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic [8:0] select_2658;
  assign select_2658 = and_538_s2_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2659;
  assign select_2659 = and_538_s2_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2660;
  assign select_2660 = and_538_s2_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic [8:0] select_2661;
  assign select_2661 = and_538_s2_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2662;
  assign select_2662 = and_538_s2_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2663;
  assign select_2663 = and_538_s2_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2664;
  assign select_2664 = and_538_s2_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2665;
  assign select_2665 = and_538_s2_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2666;
  assign select_2666 = and_538_s2_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2667;
  assign select_2667 = and_538_s2_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic [8:0] select_2668;
  assign select_2668 = and_538_s2_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2669;
  assign select_2669 = and_538_s2_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2670;
  assign select_2670 = and_538_s2_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic [8:0] select_2671;
  assign select_2671 = and_538_s2_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2672;
  assign select_2672 = and_538_s2_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2673;
  assign select_2673 = and_538_s2_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic [8:0] select_2674;
  assign select_2674 = and_538_s2_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2675;
  assign select_2675 = and_538_s2_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2676;
  assign select_2676 = and_538_s2_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic [8:0] select_2677;
  assign select_2677 = and_538_s2_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2678;
  assign select_2678 = and_538_s2_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2679;
  assign select_2679 = and_538_s2_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic [8:0] select_2680;
  assign select_2680 = and_538_s2_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2681;
  assign select_2681 = and_538_s2_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2682;
  assign select_2682 = and_538_s2_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic [8:0] select_2683;
  assign select_2683 = and_538_s2_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2684;
  assign select_2684 = and_538_s2_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2685;
  assign select_2685 = and_538_s2_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2686;
  assign select_2686 = and_538_s2_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic [8:0] select_2687;
  assign select_2687 = and_538_s2_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2688;
  assign select_2688 = and_538_s2_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2689;
  assign select_2689 = and_538_s2_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2690;
  assign select_2690 = and_538_s2_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic [8:0] select_2691;
  assign select_2691 = and_538_s2_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2692;
  assign select_2692 = and_538_s2_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2693;
  assign select_2693 = and_538_s2_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2694;
  assign select_2694 = and_538_s2_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  // hls/stages/census.hpp:274
  logic [9:0] difference_2696;
  assign difference_2696 = {1'b0, select_548} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2697;
  assign xor_2697 = difference_2696[8:0] ^ {9{difference_2696[9]}};
  logic [9:0] sum_2698;
  assign sum_2698 = {9'h0, difference_2696[9]} + {1'b0, xor_2697};
  logic [9:0] difference_2699;
  assign difference_2699 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2700;
  assign xor_2700 = difference_2699[8:0] ^ {9{difference_2699[9]}};
  logic [9:0] sum_2701;
  assign sum_2701 = {9'h0, difference_2699[9]} + {1'b0, xor_2700};
  logic [9:0] difference_2703;
  assign difference_2703 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2704;
  assign xor_2704 = difference_2703[8:0] ^ {9{difference_2703[9]}};
  logic [9:0] sum_2705;
  assign sum_2705 = {9'h0, difference_2703[9]} + {1'b0, xor_2704};
  logic [10:0] sum_2706;
  assign sum_2706 = ({1'b0, sum_2698} + {1'b0, sum_2701}) + {1'b0, sum_2705};
  logic [9:0] difference_2707;
  assign difference_2707 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2708;
  assign xor_2708 = difference_2707[8:0] ^ {9{difference_2707[9]}};
  logic [9:0] sum_2709;
  assign sum_2709 = {9'h0, difference_2707[9]} + {1'b0, xor_2708};
  logic [9:0] difference_2711;
  assign difference_2711 = {1'b0, census_memory_rdata_q[76:68]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2712;
  assign xor_2712 = difference_2711[8:0] ^ {9{difference_2711[9]}};
  // hls/stages/moments.hpp:54
  logic [13:0] sum_2733;
  assign sum_2733 = {13'h0, moments_turns_0_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_0_q);
  logic [13:0] sum_2735;
  assign sum_2735 = {13'h0, moments_turns_1_q} + (moments_starts_s2_q ? 14'h0 : moments_turned_1_q);
  // hls/stages/agreement.hpp:1143
  logic equal_2736;
  assign equal_2736 = x_s2_q[6:0] == 7'h70;
  // hls/stages/moments.hpp:117
  logic [13:0] select_2737;
  assign select_2737 = equal_2736 ? sum_2733 : moments_before_0_q;
  logic [13:0] select_2739;
  assign select_2739 = equal_2736 ? sum_2735 : moments_before_1_q;
  // hls/stages/agreement.hpp:789
  logic select_2742;
  assign select_2742 = equal_563_s2_q ? (moments_has_before_q | equal_2736) : moments_has_before_q;
  logic [13:0] select_2745;
  assign select_2745 = equal_563_s2_q ? ((select_2739 < select_2737) ? select_2737 : select_2739) : moments_most_before_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2746;
  assign sum_2746 = {1'b0, moments_most_before_q} + 15'h3;
  // hls/stages/agreement.hpp:789
  logic select_2749;
  assign select_2749 = equal_563_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2746)) : moments_left_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2750;
  assign sum_2750 = {1'b0, sum_2735} + 15'h3;
  // hls/stages/agreement.hpp:789
  logic select_2753;
  assign select_2753 = equal_563_s2_q ? (~({3'h0, counts_turned_left_q[13:2]} < sum_2750)) : moments_left_alone_q;
  logic select_2756;
  assign select_2756 = equal_563_s2_q ? (~({3'h0, select_2739[13:2]} < sum_2750)) : moments_left_other_stops_q;
  logic select_2759;
  assign select_2759 = equal_563_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2746)) : moments_right_begins_q;
  // hls/stages/moments.hpp:117
  logic [14:0] sum_2760;
  assign sum_2760 = {1'b0, sum_2733} + 15'h3;
  // hls/stages/agreement.hpp:789
  logic select_2763;
  assign select_2763 = equal_563_s2_q ? (~({3'h0, counts_turned_right_q[13:2]} < sum_2760)) : moments_right_alone_q;
  logic select_2766;
  assign select_2766 = equal_563_s2_q ? (~({3'h0, select_2737[13:2]} < sum_2760)) : moments_right_other_stops_q;
  // hls/stages/moments.hpp:51
  logic or_2769;
  assign or_2769 = moments_begins_alone_q | (moments_out_of_step_q & (~moments_ends_q));
  // hls/stages/agreement.hpp:789
  logic and_2777;
  assign and_2777 = not_564_s2_q & (not_566_s2_q & (equal_567_s2_q & (inside_v_s2_q & and_2060)));
  logic and_2781;
  assign and_2781 = not_564_s2_q & (not_566_s2_q & (equal_567_s2_q & (inside_v_s2_q & and_2069)));
  // hls/stages/moments.hpp:94
  logic and_2783;
  assign and_2783 = moments_right_alone_q & (moments_right_begins_q | moments_right_other_stops_q);
  logic select_2786;
  assign select_2786 = moments_left_alone_q ? (moments_left_begins_q | (moments_left_other_stops_q | and_2783)) : and_2783;
  // hls/stages/agreement.hpp:789
  logic and_2790;
  assign and_2790 = equal_563_s2_q & (equal_2736 & (cfg_prove_i & (cfg_same_table_i & select_2786)));
  // hls/stages/moments.hpp:95
  logic and_2793;
  assign and_2793 = cfg_same_table_i & (moments_left_begins_q & moments_right_begins_q);
  // hls/stages/census.hpp:359
  logic [9:0] difference_2807;
  assign difference_2807 = {1'b0, select_544} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2807[9]} + (difference_2807[8:0] ^ {9{difference_2807[9]}});
  logic [9:0] difference_2819;
  assign difference_2819 = {1'b0, select_548} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2819[9]} + (difference_2819[8:0] ^ {9{difference_2819[9]}});
  // hls/stages/agreement.hpp:789
  logic not_3007;
  assign not_3007 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_3008;
  assign less_3008 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:521
  logic and_3015;
  assign and_3015 = and_538_s2_q & (equal_668_s2_q & equal_2910_s2_q);
  // hls/stages/agreement.hpp:789
  logic and_3021;
  assign and_3021 = not_564_s2_q & (so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & and_3017_s2_q)));
  // hls/stages/agreement.hpp:1031
  logic and_3041;
  assign and_3041 = seen_columns_rdata_q[15] & inside_v_s2_q;
  logic and_3042;
  assign and_3042 = seen_columns_rdata_q[11] & inside_v_s2_q;
  logic and_3043;
  assign and_3043 = seen_columns_rdata_q[7] & inside_v_s2_q;
  logic and_3044;
  assign and_3044 = seen_columns_rdata_q[2] & inside_v_s2_q;
  // hls/stages/agreement.hpp:1089
  logic [1:0] sum_3046;
  assign sum_3046 = {1'b0, and_3043} + ({1'b0, explained} + {1'b0, and_3044});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3041} + ({2'h0, and_3042} + {1'b0, sum_3046});
  // hls/stages/agreement.hpp:789
  logic and_3082;
  assign and_3082 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (and_3017_s2_q & and_2460)));
  // hls/stages/agreement.hpp:987
  logic [8:0] rise;
  assign rise = {1'b0, best_left_rdata_s2_q[61:54]} - {1'b0, best_left_rdata_s2_q[53:46]};
  // hls/stages/agreement.hpp:988
  logic [7:0] lower;
  assign lower = rise[8] ? best_left_rdata_s2_q[61:54] : best_left_rdata_s2_q[53:46];
  // hls/stages/agreement.hpp:989
  logic [7:0] difference_3106;
  assign difference_3106 = best_left_rdata_s2_q[16:9] - lower;
  logic less_3109;
  assign less_3109 = {2'h0, difference_3106[7:2]} < ({7'h0, rise[8]} + (rise[7:0] ^ {8{rise[8]}}));
  // hls/stages/agreement.hpp:247
  logic and_3112;
  assign and_3112 = not_572_s2_q & (((and_2458_s2_q & and_623) & equal_3102_s2_q) & (~less_3109));
  // hls/stages/agreement.hpp:789
  logic and_3116;
  assign and_3116 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (or_568_s2_q & and_3112)));
  // hls/stages/agreement.hpp:149
  logic and_3121;
  assign and_3121 = not_572_s2_q & (slot_s2_q[2] & left_turns_rdata_q[0]);
  // hls/stages/agreement.hpp:247
  logic and_3123;
  assign and_3123 = not_572_s2_q & (slot_s2_q[2] & left_turns_rdata_q[1]);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3124;
  assign select_3124 = or_568_s2_q ? {and_3123, and_3121} : 2'h0;
  // hls/stages/agreement.hpp:247
  logic [1:0] select_3126;
  assign select_3126 = less_571_s2_q ? 2'h0 : (slot_s2_q[2] ? right_turns_rdata_q : 2'h0);
  // hls/stages/agreement.hpp:149
  logic [1:0] select_3127;
  assign select_3127 = or_568_s2_q ? select_3126 : 2'h0;
  // hls/stages/agreement.hpp:1028
  logic and_3129;
  assign and_3129 = and_625 & (select_3124[0] & select_3127[0]);
  // hls/stages/agreement.hpp:789
  logic and_3133;
  assign and_3133 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3124[1] & and_3129)));
  logic and_3134;
  assign and_3134 = not_564_s2_q & and_3133;
  logic and_3140;
  assign and_3140 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (select_3127[1] & and_3129)));
  logic and_3141;
  assign and_3141 = not_564_s2_q & and_3140;
  // hls/stages/registration.hpp:76
  logic less_3144;
  assign less_3144 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:149
  logic [7:0] select_3146;
  assign select_3146 = or_568_s2_q ? (less_571_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  logic [7:0] select_3148;
  assign select_3148 = or_568_s2_q ? (less_571_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_3150;
  assign select_3150 = or_568_s2_q ? (less_571_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise_2;
  assign rise_2 = {1'b0, select_3148} - {1'b0, select_3150};
  // hls/stages/registration.hpp:35
  logic [7:0] select_3152;
  assign select_3152 = rise_2[8] ? select_3148 : select_3150;
  logic [8:0] fall;
  assign fall = {1'b0, select_3146} - {1'b0, select_3152};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = fall[8] ? 8'h0 : fall[7:0];
  // hls/stages/registration.hpp:37
  logic not_3155;
  assign not_3155 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_3144 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_3155};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_3157;
  assign xor_3157 = rise_2[7:0] ^ {8{rise_2[8]}};
  logic [8:0] size_3;
  assign size_3 = {8'h0, rise_2[8]} + {1'b0, xor_3157};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size_3) ? {wide, 1'b0} : size_3);
  logic [7:0] select_3163;
  assign select_3163 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_3144 ? {taken, 1'b1} : {not_3155, select_3163, not_3155};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_3165;
  assign sum_3165 = {left, 1'b1} + {taken_2, less_3144};
  // hls/stages/agreement.hpp:257
  logic [4:0] select_3167;
  assign select_3167 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_3169;
  assign select_3169 = equal_563_s2_q ? registration_slope_here_q : (so_s2_q ? slope : registration_slope_here_q);
  logic [10:0] select_3171;
  assign select_3171 = equal_563_s2_q ? registration_expected_q : (so_s2_q ? expected : registration_expected_q);
  // hls/stages/registration.hpp:108
  logic equal_3172;
  assign equal_3172 = slot_s2_q == 3'h4;
  // hls/stages/agreement.hpp:262
  logic and_3176;
  assign and_3176 = and_625 & less_2165_s2_q;
  // hls/stages/agreement.hpp:149
  logic [2:0] select_3178;
  assign select_3178 = or_568_s2_q ? (less_571_s2_q ? 3'h0 : best_left_rdata_s2_q[8:6]) : 3'h0;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_3182;
  assign sum_3182 = select_3178[2:1] + 2'h3;
  // hls/stages/registration.hpp:102
  logic [7:0] select_3185;
  assign select_3185 = (select_3148 < select_3150) ? ({sum_3182, select_3178[0], 5'h0} - {3'h0, select_3167}) : {sum_3182, select_3178[0], select_3167};
  logic [7:0] select_3186;
  assign select_3186 = ((select_3178 == 3'h0) | (select_3178 == 3'h4)) ? {sum_3182, select_3178[0], 5'h0} : select_3185;
  logic [11:0] value_2;
  assign value_2 = {{4{select_3186[7]}}, select_3186} - {sum_2184[9], sum_2184, sum_2180[1]};
  // hls/stages/registration.hpp:218
  logic [11:0] select_3189;
  assign select_3189 = ($signed(value_2[11:7]) < $signed(5'h1f)) ? 12'hf80 : value_2;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_3189[11:7])) ? 12'h7f : select_3189;
  // hls/stages/registration.hpp:205
  logic [12:0] difference_3210;
  assign difference_3210 = 13'h0 - {residual[11], residual};
  // hls/stages/registration.hpp:107
  logic and_3212;
  assign and_3212 = and_3176 & ($signed(difference_3210) < $signed({7'h0, cfg_moved_limit_i}));
  // hls/stages/registration.hpp:205
  logic less_3225;
  assign less_3225 = $signed(difference_3210) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/agreement.hpp:789
  logic select_3233;
  assign select_3233 = so_s2_q ? (equal_3172 ? right_2 : registration_of_right_q) : registration_of_right_q;
  logic select_3236;
  assign select_3236 = so_s2_q ? (equal_2166 ? inside_v_s2_q : registration_was_inside_q) : registration_was_inside_q;
  // hls/stages/registration.hpp:269
  logic [3:0] select_3241;
  assign select_3241 = (sum_2076 == 2'h2) ? (registration_fresh_q & (~select_2123)) : registration_fresh_q;
  // hls/stages/agreement.hpp:789
  logic [3:0] select_3243;
  assign select_3243 = so_s2_q ? (and_2118 ? select_3241 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:242
  logic [3:0] select_3245;
  assign select_3245 = and_3015 ? 4'hf : (equal_563_s2_q ? registration_fresh_q : select_3243);
  // hls/stages/agreement.hpp:1130
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s2_q[1:0] : select_2073;
  // hls/stages/registration.hpp:258
  logic not_3266;
  assign not_3266 = ~quarter_2[1];
  logic [3:0] select_3267;
  assign select_3267 = quarter_2[0] ? {quarter_2[1], 1'b0, not_3266, 1'b0} : {1'b0, quarter_2[1], 1'b0, not_3266};
  // hls/stages/patches.hpp:91
  logic parity_3401;
  assign parity_3401 = ^{patches_chance_q[15], patches_chance_q[13:12], patches_chance_q[10]};
  // hls/stages/agreement.hpp:461
  logic [15:0] select_3402;
  assign select_3402 = equal_2910_s2_q ? {patches_chance_q[14:0], parity_3401} : patches_chance_q;
  // hls/stages/patches.hpp:345
  logic not_3404;
  assign not_3404 = ~and_2240;
  // hls/stages/patches.hpp:108
  logic [4:0] of_32;
  assign of_32 = right_3 ? patches_chance_q[4:0] : patches_chance_q[9:5];
  // hls/stages/patches.hpp:109
  logic [5:0] further;
  assign further = last_s2_q[6] ? {of_32, 1'b0} : {1'b0, of_32};
  // hls/stages/patches.hpp:110
  logic [5:0] select_3407;
  assign select_3407 = right_3 ? last_s2_q[6:1] : 6'h0;
  logic [6:0] from;
  assign from = {1'b0, further} + {1'b0, select_3407};
  // hls/stages/agreement.hpp:789
  logic and_3413;
  assign and_3413 = so_s2_q & (ends_cell_s2_q & (inside_v_s2_q & (~(x_s2_q < {1'b0, from}))));
  // hls/stages/patches.hpp:156
  logic and_3417;
  assign and_3417 = not_3404 & (patches_fixed_q | ((not_564_s2_q & and_3413) & and_2212));
  // hls/stages/patches.hpp:354
  logic not_3430;
  assign not_3430 = ~select_2155[1];
  // hls/stages/agreement.hpp:276
  logic [1:0] select_3432;
  assign select_3432 = sample_pair_whole_s2_q ? (equal_2156 ? select_2155 : {not_3430, 1'b0}) : patches_fetch_q;
  // hls/stages/patches.hpp:518
  logic [55:0] other;
  assign other = new_row_s2_q ? patches_next_codes_q : {patches_codes_further_q[3:0], patches_codes_at_q};
  // hls/stages/patches.hpp:184
  logic [51:0] select_3531;
  assign select_3531 = or_2248_s2_q ? {less_2376_s2_q, less_2375_s2_q, less_2366_s2_q, less_2365_s2_q, patches_codes_at_q[51:4]} : patches_codes_at_q;
  logic [51:0] select_3533;
  assign select_3533 = equal_2242_s2_q ? patches_codes_at_q : (equal_2244_s2_q ? other[55:4] : select_3531);
  // hls/stages/patches.hpp:501
  logic [27:0] word;
  assign word = or_2348_s2_q ? patches_right_codes_rdata_q : 28'h0;
  // hls/stages/patches.hpp:517
  logic [27:0] select_3536;
  assign select_3536 = (patches_along_s2_q == 5'h7) ? word : {4'h0, patches_codes_further_q[27:4]};
  // hls/stages/patches.hpp:184
  logic [27:0] select_3538;
  assign select_3538 = equal_2244_s2_q ? (new_row_s2_q ? word : select_3536) : patches_codes_further_q;
  // hls/stages/patches.hpp:519
  logic [55:0] select_3540;
  assign select_3540 = less_2335_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:489
  logic [55:0] select_3542;
  assign select_3542 = less_3541_s2_q ? {word, patches_next_codes_q[55:28]} : patches_next_codes_q;
  // hls/stages/patches.hpp:184
  logic [55:0] select_3544;
  assign select_3544 = or_2248_s2_q ? (equal_2247_s2_q ? patches_next_codes_q : select_3542) : patches_next_codes_q;
  logic [55:0] select_3546;
  assign select_3546 = equal_2242_s2_q ? patches_next_codes_q : (equal_2244_s2_q ? select_3540 : select_3544);
  // hls/stages/count_bits.hpp:24
  logic parity_3551;
  assign parity_3551 = ^{less_2376_s2_q, less_2375_s2_q, less_2366_s2_q, less_2365_s2_q};
  // hls/stages/count_bits.hpp:25
  logic or_3555;
  assign or_3555 = ({less_2366_s2_q, less_2365_s2_q} == 2'h3) | (less_2375_s2_q & (less_2366_s2_q | less_2365_s2_q));
  logic and_3556;
  assign and_3556 = less_2376_s2_q & (^{less_2375_s2_q, less_2366_s2_q, less_2365_s2_q});
  // hls/stages/count_bits.hpp:24
  logic xor_3557;
  assign xor_3557 = or_3555 ^ and_3556;
  // hls/stages/count_bits.hpp:27
  logic and_3558;
  assign and_3558 = or_3555 & and_3556;
  // hls/stages/patches.hpp:184
  logic [2:0] select_3560;
  assign select_3560 = or_2248_s2_q ? (and_2399_s2_q ? {and_3558, xor_3557, parity_3551} : 3'h0) : 3'h0;
  // hls/stages/patches.hpp:167
  logic [9:0] sum_3564;
  assign sum_3564 = {7'h0, patches_set_q} + (equal_2247_s2_q ? 10'h0 : patches_size_q);
  // hls/stages/patches.hpp:518
  logic [47:0] select_3574;
  assign select_3574 = new_row_s2_q ? patches_left_codes_rdata_q : patches_left_row_q;
  // hls/stages/patches.hpp:184
  logic [47:0] select_3576;
  assign select_3576 = equal_2242_s2_q ? patches_left_row_q : (equal_2244_s2_q ? select_3574 : patches_left_row_q);
  // hls/stages/patches.hpp:520
  logic [47:0] bits;
  assign bits = other[47:0] ^ select_3574;
  // hls/stages/count_bits.hpp:24
  logic xor_3580;
  assign xor_3580 = bits[17] ^ (^{select_3574[16:15], other[16:15]});
  logic xor_3583;
  assign xor_3583 = bits[11] ^ (^{select_3574[10:9], other[10:9]});
  logic xor_3586;
  assign xor_3586 = bits[14] ^ (^{select_3574[13:12], other[13:12]});
  logic xor_3589;
  assign xor_3589 = xor_3580 ^ (^{select_3574[14:9], other[14:9]});
  logic xor_3592;
  assign xor_3592 = bits[47] ^ (^{select_3574[46:45], other[46:45]});
  logic xor_3595;
  assign xor_3595 = bits[8] ^ (^{select_3574[7:6], other[7:6]});
  logic xor_3598;
  assign xor_3598 = bits[2] ^ (^{select_3574[1:0], other[1:0]});
  logic xor_3601;
  assign xor_3601 = bits[5] ^ (^{select_3574[4:3], other[4:3]});
  logic xor_3604;
  assign xor_3604 = xor_3595 ^ (^{select_3574[5:0], other[5:0]});
  logic parity_3606;
  assign parity_3606 = ^{select_3574[47:45], select_3574[8:0], other[47:45], other[8:0]};
  logic xor_3607;
  assign xor_3607 = xor_3589 ^ parity_3606;
  logic xor_3610;
  assign xor_3610 = bits[44] ^ (^{select_3574[43:42], other[43:42]});
  logic xor_3613;
  assign xor_3613 = bits[38] ^ (^{select_3574[37:36], other[37:36]});
  logic xor_3616;
  assign xor_3616 = bits[41] ^ (^{select_3574[40:39], other[40:39]});
  logic xor_3622;
  assign xor_3622 = bits[26] ^ (^{select_3574[25:24], other[25:24]});
  logic xor_3625;
  assign xor_3625 = bits[20] ^ (^{select_3574[19:18], other[19:18]});
  logic xor_3628;
  assign xor_3628 = bits[23] ^ (^{select_3574[22:21], other[22:21]});
  logic xor_3631;
  assign xor_3631 = xor_3622 ^ (^{select_3574[23:18], other[23:18]});
  logic xor_3634;
  assign xor_3634 = bits[35] ^ (^{select_3574[34:33], other[34:33]});
  logic xor_3637;
  assign xor_3637 = bits[29] ^ (^{select_3574[28:27], other[28:27]});
  logic xor_3640;
  assign xor_3640 = bits[32] ^ (^{select_3574[31:30], other[31:30]});
  logic xor_3643;
  assign xor_3643 = xor_3634 ^ (^{select_3574[32:27], other[32:27]});
  logic xor_3644;
  assign xor_3644 = xor_3631 ^ xor_3643;
  // hls/stages/count_bits.hpp:25
  logic or_3652;
  assign or_3652 = (xor_3583 & xor_3586) | (xor_3580 & (xor_3583 | xor_3586));
  logic or_3656;
  assign or_3656 = (bits[46:45] == 2'h3) | (bits[47] & (bits[45] | bits[46]));
  logic or_3660;
  assign or_3660 = (xor_3598 & xor_3601) | (xor_3595 & (xor_3598 | xor_3601));
  // hls/stages/count_bits.hpp:23
  logic or_3667;
  assign or_3667 = (bits[34:33] == 2'h3) | (bits[35] & (bits[33] | bits[34]));
  // hls/stages/count_bits.hpp:25
  logic or_3671;
  assign or_3671 = (bits[28:27] == 2'h3) | (bits[29] & (bits[27] | bits[28]));
  logic or_3675;
  assign or_3675 = (bits[31:30] == 2'h3) | (bits[32] & (bits[30] | bits[31]));
  // hls/stages/count_bits.hpp:24
  logic parity_3678;
  assign parity_3678 = ^{or_3675, or_3671, or_3667};
  // hls/stages/count_bits.hpp:23
  logic or_3682;
  assign or_3682 = (bits[43:42] == 2'h3) | (bits[44] & (bits[42] | bits[43]));
  // hls/stages/count_bits.hpp:25
  logic or_3686;
  assign or_3686 = (bits[37:36] == 2'h3) | (bits[38] & (bits[36] | bits[37]));
  logic or_3690;
  assign or_3690 = (bits[40:39] == 2'h3) | (bits[41] & (bits[39] | bits[40]));
  // hls/stages/count_bits.hpp:24
  logic parity_3693;
  assign parity_3693 = ^{or_3690, or_3686, or_3682};
  logic parity_3696;
  assign parity_3696 = ^{or_3690, or_3686, or_3682, or_3675, or_3671, or_3667, or_3660, or_3656, or_3652};
  // hls/stages/count_bits.hpp:23
  logic or_3700;
  assign or_3700 = (bits[25:24] == 2'h3) | (bits[26] & (bits[24] | bits[25]));
  // hls/stages/count_bits.hpp:25
  logic or_3704;
  assign or_3704 = (bits[19:18] == 2'h3) | (bits[20] & (bits[18] | bits[19]));
  logic or_3708;
  assign or_3708 = (bits[22:21] == 2'h3) | (bits[23] & (bits[21] | bits[22]));
  // hls/stages/count_bits.hpp:23
  logic or_3716;
  assign or_3716 = (bits[7:6] == 2'h3) | (bits[8] & (~(bits[7:6] == 2'h0)));
  // hls/stages/count_bits.hpp:25
  logic or_3720;
  assign or_3720 = (bits[1:0] == 2'h3) | (bits[2] & (bits[0] | bits[1]));
  logic or_3724;
  assign or_3724 = (bits[4:3] == 2'h3) | (bits[5] & (bits[3] | bits[4]));
  // hls/stages/count_bits.hpp:24
  logic parity_3727;
  assign parity_3727 = ^{or_3724, or_3720, or_3716};
  // hls/stages/count_bits.hpp:23
  logic or_3731;
  assign or_3731 = (bits[16:15] == 2'h3) | (bits[17] & (bits[15] | bits[16]));
  // hls/stages/count_bits.hpp:25
  logic or_3735;
  assign or_3735 = (bits[10:9] == 2'h3) | (bits[11] & (bits[9] | bits[10]));
  logic or_3739;
  assign or_3739 = (bits[13:12] == 2'h3) | (bits[14] & (bits[12] | bits[13]));
  // hls/stages/count_bits.hpp:24
  logic parity_3742;
  assign parity_3742 = ^{or_3739, or_3735, or_3731};
  logic parity_3745;
  assign parity_3745 = ^{or_3739, or_3735, or_3731, or_3724, or_3720, or_3716, or_3708, or_3704, or_3700};
  // hls/stages/count_bits.hpp:25
  logic or_3749;
  assign or_3749 = (xor_3613 & xor_3616) | (xor_3610 & (xor_3613 | xor_3616));
  logic or_3753;
  assign or_3753 = (xor_3625 & xor_3628) | (xor_3622 & (xor_3625 | xor_3628));
  logic or_3757;
  assign or_3757 = (xor_3637 & xor_3640) | (xor_3634 & (xor_3637 | xor_3640));
  // hls/stages/count_bits.hpp:24
  logic parity_3760;
  assign parity_3760 = ^{or_3757, or_3753, or_3749};
  // hls/stages/count_bits.hpp:25
  logic and_3761;
  assign and_3761 = xor_3607 & (^{xor_3644, select_3574[44:36], other[44:36]});
  logic or_3765;
  assign or_3765 = (xor_3592 & xor_3604) | (xor_3589 & (xor_3592 | xor_3604));
  logic and_3768;
  assign and_3768 = (xor_3610 ^ (^{select_3574[41:36], other[41:36]})) & (xor_3631 | xor_3643);
  logic or_3769;
  assign or_3769 = (xor_3631 & xor_3643) | and_3768;
  // hls/stages/count_bits.hpp:24
  logic parity_3772;
  assign parity_3772 = ^{or_3769, or_3765, and_3761};
  logic parity_3775;
  assign parity_3775 = ^{or_3769, or_3765, and_3761, or_3757, or_3753, or_3749, or_3739, or_3735, or_3731, or_3724, or_3720, or_3716, or_3708, or_3704, or_3700};
  logic parity_3777;
  assign parity_3777 = ^{or_3769, or_3765, and_3761, or_3757, or_3753, or_3749, or_3739, or_3735, or_3731, or_3724, or_3720, or_3716, or_3708, or_3704, or_3700, or_3690, or_3686, or_3682, or_3675, or_3671, or_3667, or_3660, or_3656, or_3652};
  // hls/stages/count_bits.hpp:25
  logic and_3778;
  assign and_3778 = parity_3696 & parity_3775;
  logic or_3782;
  assign or_3782 = (parity_3678 & parity_3693) | ((^{or_3660, or_3656, or_3652}) & (parity_3678 | parity_3693));
  logic or_3786;
  assign or_3786 = (parity_3760 & parity_3772) | (parity_3745 & (parity_3760 | parity_3772));
  logic or_3793;
  assign or_3793 = (parity_3727 & parity_3742) | ((^{or_3708, or_3704, or_3700}) & (parity_3727 | parity_3742));
  logic or_3797;
  assign or_3797 = (or_3753 & or_3757) | (or_3749 & (or_3753 | or_3757));
  logic or_3801;
  assign or_3801 = (or_3765 & or_3769) | (and_3761 & (or_3765 | or_3769));
  // hls/stages/count_bits.hpp:23
  logic or_3808;
  assign or_3808 = (or_3704 & or_3708) | (or_3700 & (or_3704 | or_3708));
  // hls/stages/count_bits.hpp:25
  logic or_3812;
  assign or_3812 = (or_3720 & or_3724) | (or_3716 & (or_3720 | or_3724));
  logic or_3816;
  assign or_3816 = (or_3735 & or_3739) | (or_3731 & (or_3735 | or_3739));
  // hls/stages/count_bits.hpp:24
  logic parity_3819;
  assign parity_3819 = ^{or_3816, or_3812, or_3808};
  // hls/stages/count_bits.hpp:23
  logic or_3823;
  assign or_3823 = (or_3656 & or_3660) | (or_3652 & (or_3656 | or_3660));
  // hls/stages/count_bits.hpp:25
  logic or_3827;
  assign or_3827 = (or_3671 & or_3675) | (or_3667 & (or_3671 | or_3675));
  logic or_3831;
  assign or_3831 = (or_3686 & or_3690) | (or_3682 & (or_3686 | or_3690));
  // hls/stages/count_bits.hpp:24
  logic parity_3834;
  assign parity_3834 = ^{or_3831, or_3827, or_3823};
  logic parity_3837;
  assign parity_3837 = ^{or_3831, or_3827, or_3823, or_3816, or_3812, or_3808, or_3801, or_3797, or_3793};
  logic parity_3839;
  assign parity_3839 = ^{or_3831, or_3827, or_3823, or_3816, or_3812, or_3808, or_3801, or_3797, or_3793, or_3786, or_3782, and_3778};
  // hls/stages/count_bits.hpp:25
  logic or_3843;
  assign or_3843 = (or_3797 & or_3801) | (or_3793 & (or_3797 | or_3801));
  logic or_3847;
  assign or_3847 = (or_3812 & or_3816) | (or_3808 & (or_3812 | or_3816));
  logic or_3851;
  assign or_3851 = (or_3827 & or_3831) | (or_3823 & (or_3827 | or_3831));
  // hls/stages/count_bits.hpp:24
  logic parity_3854;
  assign parity_3854 = ^{or_3851, or_3847, or_3843};
  // hls/stages/count_bits.hpp:25
  logic and_3855;
  assign and_3855 = (^{or_3786, or_3782, and_3778}) & parity_3837;
  logic or_3859;
  assign or_3859 = (or_3782 & or_3786) | (and_3778 & (or_3782 | or_3786));
  logic or_3863;
  assign or_3863 = (parity_3819 & parity_3834) | ((^{or_3801, or_3797, or_3793}) & (parity_3819 | parity_3834));
  // hls/stages/count_bits.hpp:24
  logic parity_3866;
  assign parity_3866 = ^{or_3863, or_3859, and_3855};
  // hls/stages/count_bits.hpp:25
  logic and_3868;
  assign and_3868 = parity_3854 & parity_3866;
  logic or_3872;
  assign or_3872 = (or_3847 & or_3851) | (or_3843 & (or_3847 | or_3851));
  logic or_3876;
  assign or_3876 = (or_3859 & or_3863) | (and_3855 & (or_3859 | or_3863));
  // hls/stages/patches.hpp:184
  logic [4:0] select_3921;
  assign select_3921 = equal_2244_s2_q ? patches_along_s2_q : patches_summed_row_column_q;
  logic select_3924;
  assign select_3924 = equal_2242_s2_q ? patches_summed_first_q : (equal_2244_s2_q ? new_row_s2_q : patches_summed_first_q);
  // hls/stages/patches.hpp:552
  logic [9:0] select_3931;
  assign select_3931 = less_2405_s2_q ? patches_rows_rdata_q[9:0] : 10'h0;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3934;
  assign select_3934 = equal_2408_s2_q ? (less_2405_s2_q ? (equal_2408_s2_q ? 10'h0 : select_3931) : 10'h0) : select_3931;
  logic [9:0] select_3936;
  assign select_3936 = less_2405_s2_q ? (equal_2406_s2_q ? 10'h0 : select_3934) : select_3934;
  // hls/stages/patches.hpp:552
  logic [4:0] select_3938;
  assign select_3938 = less_2405_s2_q ? patches_rows_rdata_q[14:10] : 5'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3941;
  assign select_3941 = equal_2408_s2_q ? (less_2405_s2_q ? (equal_2408_s2_q ? 5'h0 : select_3938) : 5'h0) : select_3938;
  logic [4:0] select_3943;
  assign select_3943 = less_2405_s2_q ? (equal_2406_s2_q ? 5'h0 : select_3941) : select_3941;
  // hls/stages/patches.hpp:552
  logic [4:0] select_3945;
  assign select_3945 = less_2405_s2_q ? patches_step_s2_q : 5'h0;
  // hls/stages/patches.hpp:556
  logic [4:0] select_3948;
  assign select_3948 = equal_2408_s2_q ? (less_2405_s2_q ? (equal_2408_s2_q ? 5'h0 : select_3945) : 5'h0) : select_3945;
  logic [4:0] select_3950;
  assign select_3950 = less_2405_s2_q ? (equal_2406_s2_q ? 5'h0 : select_3948) : select_3948;
  // hls/stages/patches.hpp:552
  logic and_3953;
  assign and_3953 = less_2405_s2_q & (patches_step_s2_q == 5'h0);
  // hls/stages/patches.hpp:556
  logic select_3956;
  assign select_3956 = equal_2408_s2_q ? (less_2405_s2_q ? (not_2409_s2_q & and_3953) : and_3953) : and_3953;
  // hls/stages/patches.hpp:184
  logic select_3959;
  assign select_3959 = equal_2242_s2_q ? (less_2405_s2_q ? (not_2407_s2_q & select_3956) : select_3956) : patches_read_first_q;
  // hls/stages/patches.hpp:178
  logic or_3970;
  assign or_3970 = patches_read_first_q | (patches_read_row_differing_q < patches_peak_best_differing_q);
  logic and_3971;
  assign and_3971 = patches_read_searches_s2_q & or_3970;
  // hls/stages/patches.hpp:536
  logic [4:0] select_3972;
  assign select_3972 = and_3971 ? patches_read_at_q : patches_peak_row_q;
  // hls/stages/patches.hpp:543
  logic [5:0] away;
  assign away = {1'b0, patches_step_s2_q} - {1'b0, select_3972};
  // hls/stages/patches.hpp:552
  logic and_3976;
  assign and_3976 = less_2405_s2_q & (equal_3968_s2_q & (away == 6'h3f));
  // hls/stages/patches.hpp:556
  logic select_3979;
  assign select_3979 = equal_2408_s2_q ? (less_2405_s2_q ? (not_2409_s2_q & and_3976) : and_3976) : and_3976;
  // hls/stages/patches.hpp:184
  logic select_3982;
  assign select_3982 = equal_2242_s2_q ? (less_2405_s2_q ? (not_2407_s2_q & select_3979) : select_3979) : patches_read_above_q;
  // hls/stages/patches.hpp:552
  logic and_3985;
  assign and_3985 = less_2405_s2_q & (equal_3968_s2_q & (away == 6'h1));
  // hls/stages/patches.hpp:556
  logic select_3988;
  assign select_3988 = equal_2408_s2_q ? (less_2405_s2_q ? (not_2409_s2_q & and_3985) : and_3985) : and_3985;
  // hls/stages/patches.hpp:184
  logic select_3991;
  assign select_3991 = equal_2242_s2_q ? (less_2405_s2_q ? (not_2407_s2_q & select_3988) : select_3988) : patches_read_below_q;
  // hls/stages/patches.hpp:549
  logic [6:0] sum_3992;
  assign sum_3992 = {away[5], away} + 7'h7d;
  // hls/stages/patches.hpp:550
  logic [9:0] select_3995;
  assign select_3995 = (equal_3968_s2_q & ({sum_3992[6], sum_3992} < 8'hfb)) ? patches_rows_rdata_q[9:0] : 10'h3ff;
  // hls/stages/patches.hpp:552
  logic [9:0] select_3996;
  assign select_3996 = less_2405_s2_q ? select_3995 : 10'h3ff;
  // hls/stages/patches.hpp:553
  logic [9:0] select_3998;
  assign select_3998 = less_2405_s2_q ? (equal_2408_s2_q ? 10'h3ff : select_3996) : 10'h3ff;
  // hls/stages/patches.hpp:556
  logic [9:0] select_3999;
  assign select_3999 = equal_2408_s2_q ? select_3998 : select_3996;
  logic [9:0] select_4001;
  assign select_4001 = less_2405_s2_q ? (equal_2406_s2_q ? 10'h3ff : select_3999) : select_3999;
  // hls/stages/patches.hpp:535
  logic [14:0] select_4003;
  assign select_4003 = and_3971 ? {patches_read_row_column_q, patches_read_row_differing_q} : {patches_peak_best_column_q, patches_peak_best_differing_q};
  // hls/stages/patches.hpp:184
  logic [9:0] select_4004;
  assign select_4004 = equal_2242_s2_q ? select_4003[9:0] : patches_peak_best_differing_q;
  logic [4:0] select_4005;
  assign select_4005 = equal_2242_s2_q ? select_4003[14:10] : patches_peak_best_column_q;
  // hls/stages/patches.hpp:537
  logic [9:0] select_4007;
  assign select_4007 = patches_read_above_q ? patches_read_row_differing_q : patches_peak_above_q;
  // hls/stages/patches.hpp:538
  logic [9:0] select_4009;
  assign select_4009 = patches_read_below_q ? patches_read_row_differing_q : patches_peak_below_q;
  // hls/stages/patches.hpp:539
  logic [9:0] select_4012;
  assign select_4012 = (patches_read_far_q < patches_peak_far_q) ? patches_read_far_q : patches_peak_far_q;
  logic [9:0] select_4013;
  assign select_4013 = patches_read_first_q ? patches_read_far_q : select_4012;
  // hls/stages/patches.hpp:590
  logic [9:0] difference_4016;
  assign difference_4016 = select_4013 - select_4003[9:0];
  // hls/stages/patches.hpp:575
  logic less_4046;
  assign less_4046 = select_4007 < select_4009;
  // hls/stages/patches.hpp:581
  logic [1:0] sum_4047;
  assign sum_4047 = select_3972[4:3] + 2'h3;
  // hls/stages/patches.hpp:576
  logic [9:0] high;
  assign high = less_4046 ? select_4009 : select_4007;
  logic [9:0] low;
  assign low = (select_4009 < select_4007) ? select_4009 : select_4007;
  // hls/stages/patches.hpp:577
  logic [9:0] eight;
  assign eight = high - low;
  logic [9:0] fall_2;
  assign fall_2 = high - select_4003[9:0];
  // hls/stages/patches.hpp:579
  logic not_4054;
  assign not_4054 = ~({eight, 3'h0} < {3'h0, fall_2});
  logic [10:0] sum_4055;
  assign sum_4055 = {1'b0, fall_2} + {2'h0, fall_2[9:1]};
  logic not_4057;
  assign not_4057 = ~({eight, 3'h0} < {1'b0, sum_4055, fall_2[0]});
  logic [1:0] sum_4058;
  assign sum_4058 = {1'b0, not_4054} + {1'b0, not_4057};
  // hls/stages/patches.hpp:580
  logic [10:0] sum_4059;
  assign sum_4059 = {1'b0, fall_2} + {3'h0, fall_2[9:2]};
  logic not_4061;
  assign not_4061 = ~({eight, 3'h0} < {sum_4059, fall_2[1:0]});
  logic not_4064;
  assign not_4064 = ~({eight, 3'h0} < ({fall_2, 3'h0} - {3'h0, fall_2}));
  logic [1:0] sum_4065;
  assign sum_4065 = {1'b0, not_4061} + {1'b0, not_4064};
  // hls/stages/patches.hpp:579
  logic [2:0] fraction;
  assign fraction = {1'b0, sum_4058} + {1'b0, sum_4065};
  // hls/stages/patches.hpp:582
  logic [7:0] select_4068;
  assign select_4068 = less_4046 ? ({sum_4047, select_3972[2:0], 3'h0} - {5'h0, fraction}) : {sum_4047, select_3972[2:0], fraction};
  // hls/stages/agreement.hpp:789
  logic select_4291;
  assign select_4291 = equal_563_s2_q ? shown_shown_q : (so_s2_q ? select_2470 : shown_shown_q);
  logic select_4293;
  assign select_4293 = equal_563_s2_q ? shown_nearer_q : (so_s2_q ? select_2473 : shown_nearer_q);
  // hls/stages/division.hpp:34
  logic [7:0] sum_4295;
  assign sum_4295 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/agreement.hpp:461
  logic [2:0] select_4297;
  assign select_4297 = less_4294_s2_q ? (sum_4295[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_4299;
  assign select_4299 = equal_2910_s2_q ? (equal_668_s2_q ? 3'h0 : select_4297) : region_row_q;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_4304;
  assign select_4304 = equal_563_s2_q ? select_2424 : (so_s2_q ? (ends_cell_s2_q ? select_2522 : select_2424) : 8'h1);
  // hls/stages/agreement.hpp:461
  logic [8:0] select_4318;
  assign select_4318 = equal_668_s2_q ? {{2{difference_4316[6]}}, difference_4316} : (less_4294_s2_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:521
  logic [8:0] select_4320;
  assign select_4320 = and_538_s2_q ? (equal_2910_s2_q ? select_4318 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:461
  logic [6:0] select_4322;
  assign select_4322 = equal_668_s2_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:521
  logic [6:0] select_4324;
  assign select_4324 = and_538_s2_q ? (equal_2910_s2_q ? select_4322 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:35
  logic [8:0] sum_4325;
  assign sum_4325 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_4326;
  assign select_4326 = sum_4295[7] ? {1'b1, sum_4295[6:0], region_down_rest_q[0]} : sum_4325;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_4295[7];
  // hls/stages/agreement.hpp:461
  logic select_4330;
  assign select_4330 = equal_2910_s2_q ? (equal_668_s2_q | (less_4294_s2_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:205
  logic or_4335;
  assign or_4335 = segment_starts_q | not_566_s2_q;
  // hls/stages/agreement.hpp:1031
  logic select_4338;
  assign select_4338 = inside_v_s2_q ? (sum_2437_s2_q ? (equal_2235 & or_2439) : or_2439) : or_4335;
  // hls/stages/agreement.hpp:789
  logic select_4341;
  assign select_4341 = equal_563_s2_q ? or_4335 : (so_s2_q ? (ends_cell_s2_q ? select_4338 : or_4335) : or_4335);
  // hls/stages/agreement.hpp:1148
  logic equal_4365;
  assign equal_4365 = x_s2_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:789
  logic select_4501;
  assign select_4501 = so_s2_q ? (ends_cell_s2_q ? and_2510 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_4504;
  assign select_4504 = ends_cell_s2_q ? (seen_columns_rdata_q[6] & inside_v_s2_q) : centres_values_0_of_skin_q;
  logic select_4506;
  assign select_4506 = equal_563_s2_q ? centres_values_0_of_skin_q : (so_s2_q ? select_4504 : centres_values_0_of_skin_q);
  logic select_4507;
  assign select_4507 = ends_cell_s2_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_4509;
  assign select_4509 = equal_563_s2_q ? centres_values_1_textured_q : (so_s2_q ? select_4507 : centres_values_1_textured_q);
  logic select_4510;
  assign select_4510 = ends_cell_s2_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_4512;
  assign select_4512 = equal_563_s2_q ? centres_values_1_of_skin_q : (so_s2_q ? select_4510 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:461
  logic [12:0] select_4516;
  assign select_4516 = equal_2910_s2_q ? (equal_4513_s2_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:521
  logic [6:0] select_4519;
  assign select_4519 = and_538_s2_q ? (equal_2910_s2_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1301
  logic [2:0] select_4530;
  assign select_4530 = select_2482 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:436
  logic [7:0] select_4536;
  assign select_4536 = marks_first_s2_q ? (less_4532 ? {sum_4533, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/registration.hpp:258
  logic not_4606;
  assign not_4606 = ~quarter[1];
  logic [3:0] select_4607;
  assign select_4607 = quarter[0] ? {quarter[1], 1'b0, not_4606, 1'b0} : {1'b0, quarter[1], 1'b0, not_4606};

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:277; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_2077;
  logic registration_sums_re;
  assign registration_sums_re = s2_en & select_2120;
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory patches_choices, 64 x 23 and parity, DISTANCE 12, hls/stages/patches.hpp:763; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [23:0] patches_choices_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) patches_choices_mem[i] = 24'h0;
`endif
  logic [5:0] patches_choices_raddr;
  assign patches_choices_raddr = select_2154;
  logic patches_choices_re;
  assign patches_choices_re = s2_en & (sample_pair_whole_s2_q & (~equal_2156));
  logic [23:0] patches_choices_word_q;
  always_ff @(posedge clk_i) begin
    if (patches_choices_re) patches_choices_word_q <= patches_choices_mem[patches_choices_raddr];
  end
  logic [22:0] patches_choices_rdata_q;
  assign patches_choices_rdata_q = patches_choices_word_q[22:0];
  logic patches_choices_read_q, patches_choices_error;
  always_ff @(posedge clk_i) patches_choices_read_q <= rst_ni & patches_choices_re;
  assign patches_choices_error = patches_choices_read_q & ^patches_choices_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1399; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  (* ram_style = "distributed" *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2434;
  logic regions_re;
  assign regions_re = s2_en & (equal_563_s2_q ? (x_s2_q[6] & not_2435) : and_2442);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1410; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2494, index[5:0]};
  logic map_re;
  assign map_re = s2_en & (and_2501 & less_2502);
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
  assign averager_memory_waddr = select_508_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_513_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_532, and_528, sum_524, sum_520};
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
  assign census_memory_waddr = column_s2_q;
  logic census_memory_we;
  assign census_memory_we = s2_en & and_538_s2_q;
  logic [77:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[58:40], census_memory_rdata_q[38:0], and_556, whole_2, select_548, select_544};
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

  // Memory moments_memory, write
  logic [12:0] moments_memory_waddr;
  assign moments_memory_waddr = select_562_s2_q;
  logic moments_memory_we;
  assign moments_memory_we = s2_en & and_580_s2_q;
  logic [3:0] moments_memory_wdata;
  assign moments_memory_wdata = {and_635_s2_q, and_633_s2_q, and_628_s2_q, and_626};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (moments_memory_we) moments_memory_mem[moments_memory_waddr] <= {^moments_memory_wdata, moments_memory_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && moments_memory_we) begin
      if (moments_memory_re && moments_memory_raddr == moments_memory_waddr) begin
        $error("moments_memory: address %0d is read less than DISTANCE steps after its write", moments_memory_waddr);
      end
      if (moments_memory_waddr >= 13'd4800) $error("moments_memory: write outside, address %0d", moments_memory_waddr);
    end
    if (rst_ni && moments_memory_re && moments_memory_raddr >= 13'd4800) $error("moments_memory: read outside, address %0d", moments_memory_raddr);
  end
`endif

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q;
  logic best_left_we;
  assign best_left_we = s2_en & and_2024_s2_q;
  logic [61:0] best_left_wdata;
  assign best_left_wdata = {select_2023, select_2020, select_2017, select_2015, select_1988, select_1985, select_1977, select_1976, select_1972};
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
  assign best_right_we = s2_en & and_2024_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_2034, select_2033, select_2030, select_2029};
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

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_2041_s2_q;
  logic shown_right_we;
  assign shown_right_we = s2_en & and_2052;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_2049, not_566_s2_q};
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

  // Memory left_turns, write
  logic [6:0] left_turns_waddr;
  assign left_turns_waddr = x_s2_q[6:0];
  logic left_turns_we;
  assign left_turns_we = s2_en & moments_taken_q;
  logic [1:0] left_turns_wdata;
  assign left_turns_wdata = {and_2060, and_2057};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (left_turns_we) left_turns_mem[left_turns_waddr] <= {^left_turns_wdata, left_turns_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && left_turns_we) begin
      if (left_turns_re && left_turns_raddr == left_turns_waddr) begin
        $error("left_turns: address %0d is read less than DISTANCE steps after its write", left_turns_waddr);
      end
      if (left_turns_waddr >= 7'd80) $error("left_turns: write outside, address %0d", left_turns_waddr);
    end
    if (rst_ni && left_turns_re && left_turns_raddr >= 7'd80) $error("left_turns: read outside, address %0d", left_turns_raddr);
  end
`endif

  // Memory right_turns, write
  logic [6:0] right_turns_waddr;
  assign right_turns_waddr = x_s2_q[6:0];
  logic right_turns_we;
  assign right_turns_we = s2_en & moments_taken_q;
  logic [1:0] right_turns_wdata;
  assign right_turns_wdata = {and_2069, and_2066};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (right_turns_we) right_turns_mem[right_turns_waddr] <= {^right_turns_wdata, right_turns_wdata};
  end
`ifndef SYNTHESIS
  always_ff @(posedge clk_i) begin
    if (rst_ni && right_turns_we) begin
      if (right_turns_re && right_turns_raddr == right_turns_waddr) begin
        $error("right_turns: address %0d is read less than DISTANCE steps after its write", right_turns_waddr);
      end
      if (right_turns_waddr >= 7'd80) $error("right_turns: write outside, address %0d", right_turns_waddr);
    end
    if (rst_ni && right_turns_re && right_turns_raddr >= 7'd80) $error("right_turns: read outside, address %0d", right_turns_raddr);
  end
`endif

  // Memory patches_right_codes, write
  logic [6:0] patches_right_codes_waddr;
  assign patches_right_codes_waddr = {sum_2356, patches_code_row_s2_q[1:0], of_row_2_s2_q};
  logic patches_right_codes_we;
  assign patches_right_codes_we = s2_en & and_2390_s2_q;
  logic [27:0] patches_right_codes_wdata;
  assign patches_right_codes_wdata = {less_2376_s2_q, less_2375_s2_q, less_2366_s2_q, less_2365_s2_q, patches_codes_at_q[51:28]};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_codes_we) patches_right_codes_mem[patches_right_codes_waddr] <= {^patches_right_codes_wdata, patches_right_codes_wdata};
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
  assign patches_left_codes_waddr = {sum_2394, patches_code_row_s2_q[1:0]};
  logic patches_left_codes_we;
  assign patches_left_codes_we = s2_en & and_2404_s2_q;
  logic [47:0] patches_left_codes_wdata;
  assign patches_left_codes_wdata = {less_2376_s2_q, less_2375_s2_q, less_2366_s2_q, less_2365_s2_q, patches_codes_at_q[51:8]};
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
  assign seen_columns_waddr = x_s2_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s2_en & and_2037_s2_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2469, textured};
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
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= pixel_0_s2_q;
      sample_pair_pixel_1_q <= pixel_1_s2_q;
      sample_of_skin_q <= mask_s2_q;
      averager_running_mask_q <= sample_pair_whole_s2_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2634;
      averager_mask_q <= select_2636;
      averager_of_skin_q <= select_2638;
      census_filled_q <= and_538_s2_q ? {select_671[2:0], 1'b1} : census_filled_q;
      moments_turned_0_q <= sum_2733;
      moments_turned_1_q <= sum_2735;
      moments_before_0_q <= equal_563_s2_q ? select_2737 : moments_before_0_q;
      moments_before_1_q <= equal_563_s2_q ? select_2739 : moments_before_1_q;
      moments_has_before_q <= select_2742;
      moments_most_before_q <= select_2745;
      moments_left_begins_q <= select_2749;
      moments_left_alone_q <= select_2753;
      moments_left_other_stops_q <= select_2756;
      moments_right_begins_q <= select_2759;
      moments_right_alone_q <= select_2763;
      moments_right_other_stops_q <= select_2766;
      moments_out_of_step_q <= or_2769;
      moments_turns_0_q <= and_2777;
      moments_turns_1_q <= and_2781;
      moments_begins_alone_q <= and_2790;
      moments_ends_q <= equal_563_s2_q & (equal_2736 & (not_2791 | and_2793));
      rows_passed_above_q <= and_538_s2_q ? select_670 : rows_passed_above_q;
      shift_allowed_q <= not_3007 & (~less_3008);
      shift_not_right_q <= $signed(run_shift_s2_q) < $signed(6'h1);
      counts_turned_left_q <= and_3015 ? 14'h0 : (counts_turned_left_q + {13'h0, and_3134});
      counts_turned_right_q <= and_3015 ? 14'h0 : (counts_turned_right_q + {13'h0, and_3141});
      registration_displacement_over_q <= so_s2_q ? sum_3165[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_3167;
      registration_slope_here_q <= select_3169;
      registration_expected_q <= select_3171;
      registration_of_right_q <= equal_563_s2_q ? registration_of_right_q : select_3233;
      registration_was_inside_q <= equal_563_s2_q ? registration_was_inside_q : select_3236;
      registration_fresh_q <= select_3245;
      patches_chance_q <= and_538_s2_q ? select_3402 : patches_chance_q;
      patches_fixed_q <= and_3417;
      patches_choice_valid_q <= and_2240 ? (select_2213 & not_3404) : select_2213;
      patches_choice_column_q <= select_2218;
      patches_choice_shift_q <= select_2223;
      patches_choice_slope_q <= select_2234;
      patches_band_q <= sample_pair_whole_s2_q ? select_2255 : patches_band_q;
      patches_fetch_q <= select_3432;
      patches_codes_at_q <= select_3533;
      patches_codes_further_q <= equal_2242_s2_q ? patches_codes_further_q : select_3538;
      patches_next_codes_q <= select_3546;
      patches_set_q <= equal_2242_s2_q ? 3'h0 : (equal_2244_s2_q ? 3'h0 : select_3560);
      patches_size_q <= sum_3564;
      patches_left_row_q <= select_3576;
      patches_summed_row_column_q <= equal_2242_s2_q ? patches_summed_row_column_q : select_3921;
      patches_summed_first_q <= select_3924;
      patches_read_row_differing_q <= equal_2242_s2_q ? select_3936 : patches_read_row_differing_q;
      patches_read_row_column_q <= equal_2242_s2_q ? select_3943 : patches_read_row_column_q;
      patches_read_at_q <= equal_2242_s2_q ? select_3950 : patches_read_at_q;
      patches_read_first_q <= select_3959;
      patches_read_above_q <= select_3982;
      patches_read_below_q <= select_3991;
      patches_read_far_q <= equal_2242_s2_q ? select_4001 : patches_read_far_q;
      patches_peak_best_differing_q <= select_4004;
      patches_peak_best_column_q <= select_4005;
      patches_peak_row_q <= equal_2242_s2_q ? select_3972 : patches_peak_row_q;
      patches_peak_above_q <= equal_2242_s2_q ? select_4007 : patches_peak_above_q;
      patches_peak_below_q <= equal_2242_s2_q ? select_4009 : patches_peak_below_q;
      patches_peak_far_q <= equal_2242_s2_q ? select_4013 : patches_peak_far_q;
      patches_frame_ended_q <= equal_563_s2_q & equal_2736;
      shown_shown_q <= select_4291;
      shown_nearer_q <= select_4293;
      region_row_q <= and_538_s2_q ? select_4299 : region_row_q;
      next_region_row_q <= region_row_q + 3'h1;
      region_columns_q <= select_4304;
      region_down_rest_q <= select_4320;
      region_down_back_q <= select_4324;
      region_down_next_q <= select_4326;
      region_fresh_q <= and_538_s2_q ? select_4330 : region_fresh_q;
      segment_starts_q <= select_4341;
      centres_values_0_textured_q <= equal_563_s2_q ? centres_values_0_textured_q : select_4501;
      centres_values_0_of_skin_q <= select_4506;
      centres_values_1_textured_q <= select_4509;
      centres_values_1_of_skin_q <= select_4512;
      map_row_q <= and_538_s2_q ? select_4516 : map_row_q;
      map_width_q <= select_4519;
      write_half_q <= marks_first_s2_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2493;
      done_q <= not_2495 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s2_q ? done_q : proven_q;
      drew_q <= so_s2_q;
      said_q <= equal_563_s2_q & equal_4365;
      rows_passed_q <= select_2478;
      columns_passed_q <= {select_2480[7:0], or_2476};
      line_ended_q <= marks_last_s2_q;
      began_q <= and_2497;
      seen_x_q <= select_2499;
      seen_y_q <= marks_first_s2_q ? 3'h0 : select_4530;
      seen_column_q <= select_2490;
      seen_rows_left_q <= select_4536;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2487;
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
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      averager_running_0_q <= sample_pair_whole_s2_q ? select_516 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_522 : averager_running_1_q;
      averager_total_0_q <= select_2613;
      averager_total_1_q <= select_2615;
      census_columns_values_0_cell_0_left_q <= select_2639;
      census_columns_values_0_cell_0_right_q <= select_2640;
      census_columns_values_0_cell_0_mask_q <= and_538_s2_q ? whole_2 : census_columns_values_0_cell_0_mask_q;
      census_columns_values_0_cell_1_left_q <= select_2642;
      census_columns_values_0_cell_1_right_q <= select_2643;
      census_columns_values_0_cell_1_mask_q <= select_2644;
      census_columns_values_0_cell_2_left_q <= select_2645;
      census_columns_values_0_cell_2_right_q <= select_2646;
      census_columns_values_0_cell_2_mask_q <= select_2647;
      census_columns_values_0_cell_2_of_skin_q <= select_2648;
      census_columns_values_0_cell_3_left_q <= select_2649;
      census_columns_values_0_cell_3_right_q <= select_2650;
      census_columns_values_0_cell_3_mask_q <= select_2651;
      census_columns_values_0_cell_4_left_q <= select_2652;
      census_columns_values_0_cell_4_right_q <= select_2653;
      census_columns_values_0_cell_4_mask_q <= select_2654;
      census_columns_values_1_cell_0_left_q <= select_2655;
      census_columns_values_1_cell_0_right_q <= select_2656;
      census_columns_values_1_cell_0_mask_q <= select_2657;
      census_columns_values_1_cell_1_left_q <= select_2658;
      census_columns_values_1_cell_1_right_q <= select_2659;
      census_columns_values_1_cell_1_mask_q <= select_2660;
      census_columns_values_1_cell_2_left_q <= select_2661;
      census_columns_values_1_cell_2_right_q <= select_2662;
      census_columns_values_1_cell_2_mask_q <= select_2663;
      census_columns_values_1_cell_2_of_skin_q <= select_2664;
      census_columns_values_1_cell_3_left_q <= select_2665;
      census_columns_values_1_cell_3_right_q <= select_2666;
      census_columns_values_1_cell_3_mask_q <= select_2667;
      census_columns_values_1_cell_4_left_q <= select_2668;
      census_columns_values_1_cell_4_right_q <= select_2669;
      census_columns_values_1_cell_4_mask_q <= select_2670;
      census_columns_values_2_cell_0_left_q <= select_2671;
      census_columns_values_2_cell_0_right_q <= select_2672;
      census_columns_values_2_cell_0_mask_q <= select_2673;
      census_columns_values_2_cell_1_left_q <= select_2674;
      census_columns_values_2_cell_1_right_q <= select_2675;
      census_columns_values_2_cell_1_mask_q <= select_2676;
      census_columns_values_2_cell_2_left_q <= select_2677;
      census_columns_values_2_cell_2_right_q <= select_2678;
      census_columns_values_2_cell_2_mask_q <= select_2679;
      census_columns_values_2_cell_3_left_q <= select_2680;
      census_columns_values_2_cell_3_right_q <= select_2681;
      census_columns_values_2_cell_3_mask_q <= select_2682;
      census_columns_values_2_cell_4_left_q <= select_2683;
      census_columns_values_2_cell_4_right_q <= select_2684;
      census_columns_values_2_cell_4_mask_q <= select_2685;
      census_columns_values_3_cell_0_mask_q <= select_2686;
      census_columns_values_3_cell_1_left_q <= select_2687;
      census_columns_values_3_cell_1_right_q <= select_2688;
      census_columns_values_3_cell_1_mask_q <= select_2689;
      census_columns_values_3_cell_2_mask_q <= select_2690;
      census_columns_values_3_cell_3_left_q <= select_2691;
      census_columns_values_3_cell_3_right_q <= select_2692;
      census_columns_values_3_cell_3_mask_q <= select_2693;
      census_columns_values_3_cell_4_mask_q <= select_2694;
      sharpness_last_mean_0_q <= and_538_s2_q ? select_544 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_538_s2_q ? select_548 : sharpness_last_mean_1_q;
    end
  end

  logic saturated_s3_q;
  logic marks_first_s3_q;
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
  logic [2:0] select_502_s3_q;
  logic [6:0] select_504_s3_q;
  logic [6:0] column_s3_q;
  logic and_536_s3_q;
  logic and_538_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_541_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic equal_558_s3_q;
  logic equal_563_s3_q;
  logic not_564_s3_q;
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
  logic less_658_s3_q;
  logic less_659_s3_q;
  logic less_660_s3_q;
  logic less_661_s3_q;
  logic less_662_s3_q;
  logic less_663_s3_q;
  logic less_664_s3_q;
  logic and_672_s3_q;
  logic and_697_s3_q;
  logic and_698_s3_q;
  logic [11:0] sum_713_s3_q;
  logic [9:0] sum_716_s3_q;
  logic and_724_s3_q;
  logic and_728_s3_q;
  logic less_729_s3_q;
  logic less_733_s3_q;
  logic less_735_s3_q;
  logic equal_2070_s3_q;
  logic all_s3_q;
  logic [1:0] sum_2076_s3_q;
  logic equal_2078_s3_q;
  logic equal_2080_s3_q;
  logic equal_2082_s3_q;
  logic equal_2084_s3_q;
  logic equal_2086_s3_q;
  logic equal_2088_s3_q;
  logic equal_2090_s3_q;
  logic equal_2092_s3_q;
  logic less_2101_s3_q;
  logic or_2105_s3_q;
  logic equal_2125_s3_q;
  logic and_2135_s3_q;
  logic and_2138_s3_q;
  logic select_2155_s3_q;
  logic equal_2156_s3_q;
  logic and_2164_s3_q;
  logic equal_2166_s3_q;
  logic select_2213_s3_q;
  logic and_2241_s3_q;
  logic equal_2242_s3_q;
  logic equal_2244_s3_q;
  logic and_2257_s3_q;
  logic [4:0] select_2272_s3_q;
  logic select_2278_s3_q;
  logic [3:0] select_2319_s3_q;
  logic less_2405_s3_q;
  logic equal_2406_s3_q;
  logic not_2407_s3_q;
  logic equal_2408_s3_q;
  logic or_2427_s3_q;
  logic or_2430_s3_q;
  logic or_2433_s3_q;
  logic not_2435_s3_q;
  logic textured_s3_q;
  logic explained_s3_q;
  logic and_2462_s3_q;
  logic and_2467_s3_q;
  logic and_2501_s3_q;
  logic less_2502_s3_q;
  logic [5:0] index_2_s3_q;
  logic [7:0] sum_2507_s3_q;
  logic [2:0] textured_2_s3_q;
  logic or_2525_s3_q;
  logic or_2528_s3_q;
  logic or_2531_s3_q;
  logic [2:0] shown_2_s3_q;
  logic [2:0] near_2_s3_q;
  logic and_2581_s3_q;
  logic [11:0] sum_2710_s3_q;
  logic [9:0] sum_2713_s3_q;
  logic equal_2721_s3_q;
  logic [8:0] contrast_s3_q;
  logic [8:0] contrast_2_s3_q;
  logic and_3015_s3_q;
  logic and_3021_s3_q;
  logic [2:0] explained_2_s3_q;
  logic and_3083_s3_q;
  logic and_3117_s3_q;
  logic and_3175_s3_q;
  logic and_3176_s3_q;
  logic [7:0] residual_s3_q;
  logic and_3212_s3_q;
  logic and_3226_s3_q;
  logic equal_3269_s3_q;
  logic parity_3648_s3_q;
  logic parity_3777_s3_q;
  logic parity_3839_s3_q;
  logic xor_3867_s3_q;
  logic parity_3879_s3_q;
  logic or_3883_s3_q;
  logic equal_3884_s3_q;
  logic [4:0] select_4003_s3_q;
  logic equal_4015_s3_q;
  logic less_4017_s3_q;
  logic less_4018_s3_q;
  logic or_4023_s3_q;
  logic [7:0] select_4068_s3_q;
  logic equal_4365_s3_q;
  logic and_4542_s3_q;
  logic not_4556_s3_q;
  logic equal_4609_s3_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      saturated_s3_q <= saturated_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      sample_pair_pixel_0_s3_q <= sample_pair_pixel_0_q;
      sample_pair_pixel_1_s3_q <= sample_pair_pixel_1_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      sample_present_s3_q <= sample_present_s2_q;
      census_columns_values_1_cell_2_of_skin_s3_q <= census_columns_values_1_cell_2_of_skin_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[1];
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
      select_502_s3_q <= select_502_s2_q;
      select_504_s3_q <= select_504_s2_q;
      column_s3_q <= column_s2_q;
      and_536_s3_q <= and_536_s2_q;
      and_538_s3_q <= and_538_s2_q;
      grey_s3_q <= grey;
      equal_541_s3_q <= equal_541;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      equal_558_s3_q <= equal_558_s2_q;
      equal_563_s3_q <= equal_563_s2_q;
      not_564_s3_q <= not_564_s2_q;
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
      less_658_s3_q <= less_658;
      less_659_s3_q <= less_659;
      less_660_s3_q <= less_660;
      less_661_s3_q <= less_661;
      less_662_s3_q <= less_662;
      less_663_s3_q <= less_663;
      less_664_s3_q <= less_664;
      and_672_s3_q <= and_672;
      and_697_s3_q <= whole_22 & and_672;
      and_698_s3_q <= census_columns_values_1_cell_2_mask_q & and_672;
      sum_713_s3_q <= {1'b0, sum_709} + {2'h0, sum_712};
      sum_716_s3_q <= {9'h0, difference_714[9]} + {1'b0, xor_715};
      and_724_s3_q <= and_724;
      and_728_s3_q <= and_728;
      less_729_s3_q <= $signed(10'h0) < $signed(half_grey_levels);
      less_733_s3_q <= {{5{sum_732[6]}}, sum_732, half_grey_levels_2[3:0]} < 16'hffe1;
      less_735_s3_q <= $signed(10'h0) < $signed(half_grey_levels_2);
      equal_2070_s3_q <= equal_2070;
      all_s3_q <= all;
      sum_2076_s3_q <= sum_2076;
      equal_2078_s3_q <= equal_2078;
      equal_2080_s3_q <= equal_2080;
      equal_2082_s3_q <= equal_2082;
      equal_2084_s3_q <= equal_2084;
      equal_2086_s3_q <= equal_2086;
      equal_2088_s3_q <= equal_2088;
      equal_2090_s3_q <= equal_2090;
      equal_2092_s3_q <= equal_2092;
      less_2101_s3_q <= less_2101;
      or_2105_s3_q <= or_2105;
      equal_2125_s3_q <= (registration_fresh_q & select_2123) == 4'h0;
      and_2135_s3_q <= not_564_s2_q & and_2119;
      and_2138_s3_q <= and_2138_s2_q;
      select_2155_s3_q <= select_2155[1];
      equal_2156_s3_q <= equal_2156;
      and_2164_s3_q <= and_2164;
      equal_2166_s3_q <= equal_2166;
      select_2213_s3_q <= select_2213;
      and_2241_s3_q <= and_2241;
      equal_2242_s3_q <= equal_2242_s2_q;
      equal_2244_s3_q <= equal_2244_s2_q;
      and_2257_s3_q <= and_2241 & equal_2256;
      select_2272_s3_q <= select_2272_s2_q;
      select_2278_s3_q <= select_2278_s2_q;
      select_2319_s3_q <= select_2319_s2_q;
      less_2405_s3_q <= less_2405_s2_q;
      equal_2406_s3_q <= equal_2406_s2_q;
      not_2407_s3_q <= not_2407_s2_q;
      equal_2408_s3_q <= equal_2408_s2_q;
      or_2427_s3_q <= or_2427;
      or_2430_s3_q <= or_2430;
      or_2433_s3_q <= or_2433;
      not_2435_s3_q <= not_2435;
      textured_s3_q <= textured;
      explained_s3_q <= explained;
      and_2462_s3_q <= inside_v_s2_q & (and_2460 & and_2048);
      and_2467_s3_q <= not_564_s2_q & and_2442;
      and_2501_s3_q <= and_2501;
      less_2502_s3_q <= less_2502;
      index_2_s3_q <= index_2[5:0];
      sum_2507_s3_q <= sum_2507;
      textured_2_s3_q <= textured_2;
      or_2525_s3_q <= or_2525;
      or_2528_s3_q <= select_2522[7] | (~({select_2522[6], select_2522[3:2]} == 3'h0));
      or_2531_s3_q <= select_2522[7] | (~(select_2522[6:4] == 3'h0));
      shown_2_s3_q <= shown_2;
      near_2_s3_q <= near_2;
      and_2581_s3_q <= and_2581;
      sum_2710_s3_q <= {1'b0, sum_2706} + {2'h0, sum_2709};
      sum_2713_s3_q <= {9'h0, difference_2711[9]} + {1'b0, xor_2712};
      equal_2721_s3_q <= equal_2721_s2_q;
      contrast_s3_q <= contrast;
      contrast_2_s3_q <= contrast_2;
      and_3015_s3_q <= and_3015;
      and_3021_s3_q <= and_3021;
      explained_2_s3_q <= explained_2;
      and_3083_s3_q <= not_564_s2_q & and_3082;
      and_3117_s3_q <= not_564_s2_q & and_3116;
      and_3175_s3_q <= not_564_s2_q & (so_s2_q & (half_ends & equal_3172));
      and_3176_s3_q <= and_3176;
      residual_s3_q <= residual[7:0];
      and_3212_s3_q <= and_3212;
      and_3226_s3_q <= and_3176 & less_3225;
      equal_3269_s3_q <= (registration_fresh_q & select_3267) == 4'h0;
      parity_3648_s3_q <= ^{xor_3644, xor_3607, select_3574[44:36], other[44:36]};
      parity_3777_s3_q <= parity_3777;
      parity_3839_s3_q <= parity_3839;
      xor_3867_s3_q <= parity_3854 ^ parity_3866;
      parity_3879_s3_q <= ^{or_3876, or_3872, and_3868};
      or_3883_s3_q <= (or_3872 & or_3876) | (and_3868 & (or_3872 | or_3876));
      equal_3884_s3_q <= equal_3884_s2_q;
      select_4003_s3_q <= select_4003[14:10];
      equal_4015_s3_q <= select_3972[3:0] == 4'h0;
      less_4017_s3_q <= {difference_4016, 3'h0} < {3'h0, sum_3564};
      less_4018_s3_q <= select_4013 < select_4003[9:0];
      or_4023_s3_q <= (sum_3564 < 10'h39) | ({1'b0, sum_3564[9:1]} < select_4003[9:0]);
      select_4068_s3_q <= select_4068;
      equal_4365_s3_q <= equal_4365;
      and_4542_s3_q <= and_2581 & ({sum_2507, index_2[5:0]} == {sum_2494, index[5:0]});
      not_4556_s3_q <= ~proven_q;
      equal_4609_s3_q <= (registration_fresh_q & select_4607) == 4'h0;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
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
  logic [7:0] patches_on_skin_most_q;
  logic patches_large_q;
  logic patches_overlooked_q;
  logic patches_spoiled_q;
  logic patches_suspected_q;
  logic patches_moved_q;
  logic patches_twice_q;
  logic patches_clear_q;
  logic [9:0] patches_age_q;
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
  // hls/stages/census.hpp:272
  logic [11:0] texture;
  assign texture = sum_713_s3_q + {2'h0, sum_716_s3_q};
  // hls/stages/census.hpp:283
  logic [12:0] sum_718;
  assign sum_718 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture};
  logic [13:0] sum_720;
  assign sum_720 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_718});
  // hls/stages/census.hpp:305
  logic less_721;
  assign less_721 = 9'h4 < sum_720[13:5];
  logic and_722;
  assign and_722 = and_672_s3_q & less_721;
  // hls/stages/moments.hpp:30
  logic and_734;
  assign and_734 = (and_697_s3_q & and_724_s3_q) & less_733_s3_q;
  // hls/stages/registration.hpp:265
  logic equal_2127;
  assign equal_2127 = sum_2076_s3_q == 2'h0;
  // hls/stages/registration.hpp:263
  logic [6:0] down;
  assign down = sum_2076_s3_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  // hls/stages/registration.hpp:265
  logic [13:0] select_2129;
  assign select_2129 = equal_2127 ? registration_half_across_q : {{7{down[6]}}, down};
  logic [19:0] sum_2130;
  assign sum_2130 = (equal_2125_s3_q ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_2129[13]}}, select_2129};
  // hls/stages/registration.hpp:264
  logic [6:0] up;
  assign up = sum_2076_s3_q[0] ? registration_half_votes_up_q : registration_half_half_votes_up_q;
  // hls/stages/registration.hpp:266
  logic [6:0] select_2133;
  assign select_2133 = equal_2127 ? {1'b0, registration_half_measured_q} : up;
  logic [11:0] sum_2134;
  assign sum_2134 = (equal_2125_s3_q ? registration_sums_rdata_q[31:20] : 12'h0) + {{5{select_2133[6]}}, select_2133};
  // hls/stages/patches.hpp:353
  logic [22:0] select_2258;
  assign select_2258 = and_2257_s3_q ? {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2213_s3_q} : patches_choices_rdata_q;
  // hls/stages/patches.hpp:127
  logic select_2260;
  assign select_2260 = equal_2156_s3_q ? patches_place_0_valid_q : (select_2155_s3_q ? patches_place_0_valid_q : select_2258[0]);
  // hls/stages/patches.hpp:354
  logic [21:0] select_2261;
  assign select_2261 = select_2155_s3_q ? {patches_place_0_slope_q, patches_place_0_shift_q, patches_place_0_column_q} : select_2258[22:1];
  // hls/stages/patches.hpp:127
  logic [7:0] select_2262;
  assign select_2262 = equal_2156_s3_q ? patches_place_0_column_q : select_2261[7:0];
  logic [5:0] select_2263;
  assign select_2263 = equal_2156_s3_q ? patches_place_0_shift_q : select_2261[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2264;
  assign sum_2264 = select_2262 + {{2{select_2263[5]}}, select_2263};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2265;
  assign sum_2265 = sum_2264[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2266;
  assign equal_2266 = {sum_2265[6], select_504_s3_q, select_502_s3_q} == {1'b0, sum_2265[5:0], sum_2264[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2268;
  assign or_2268 = and_2138_s3_q | (select_2260 & equal_2266);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2269;
  assign select_2269 = or_2268 ? 5'h0 : patches_right_next_0_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2279;
  assign select_2279 = or_2268 ? {and_2138_s3_q, 5'h0} : patches_right_next_0_q;
  // hls/stages/patches.hpp:137
  logic and_2281;
  assign and_2281 = select_2278_s3_q & (~select_2279[5]);
  // hls/stages/patches.hpp:127
  logic select_2289;
  assign select_2289 = equal_2156_s3_q ? patches_place_1_valid_q : (select_2155_s3_q ? select_2258[0] : patches_place_1_valid_q);
  // hls/stages/patches.hpp:354
  logic [21:0] select_2290;
  assign select_2290 = select_2155_s3_q ? select_2258[22:1] : {patches_place_1_slope_q, patches_place_1_shift_q, patches_place_1_column_q};
  // hls/stages/patches.hpp:127
  logic [7:0] select_2291;
  assign select_2291 = equal_2156_s3_q ? patches_place_1_column_q : select_2290[7:0];
  logic [5:0] select_2292;
  assign select_2292 = equal_2156_s3_q ? patches_place_1_shift_q : select_2290[13:8];
  // hls/stages/patches.hpp:323
  logic [7:0] sum_2293;
  assign sum_2293 = select_2291 + {{2{select_2292[5]}}, select_2292};
  // hls/stages/patches.hpp:324
  logic [6:0] sum_2294;
  assign sum_2294 = sum_2293[7:1] + 7'h7f;
  // hls/stages/patches.hpp:131
  logic equal_2295;
  assign equal_2295 = {sum_2294[6], select_504_s3_q, select_502_s3_q} == {1'b0, sum_2294[5:0], sum_2293[0], 3'h4};
  // hls/stages/patches.hpp:133
  logic or_2297;
  assign or_2297 = and_2138_s3_q | (select_2289 & equal_2295);
  // hls/stages/agreement.hpp:276
  logic [4:0] select_2298;
  assign select_2298 = or_2297 ? 5'h0 : patches_right_next_1_q[4:0];
  // hls/stages/patches.hpp:133
  logic [5:0] select_2299;
  assign select_2299 = or_2297 ? {and_2138_s3_q, 5'h0} : patches_right_next_1_q;
  // hls/stages/patches.hpp:137
  logic and_2301;
  assign and_2301 = select_2278_s3_q & (~select_2299[5]);
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2308;
  assign sum_2308 = select_2262 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2309;
  assign equal_2309 = {sum_2308[7], select_504_s3_q, select_502_s3_q} == {1'b0, sum_2308[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic or_2311;
  assign or_2311 = and_2138_s3_q | (select_2260 & equal_2309);
  logic [4:0] select_2312;
  assign select_2312 = or_2311 ? {and_2138_s3_q, 4'h0} : patches_left_next_0_q;
  // hls/stages/patches.hpp:319
  logic [7:0] sum_2313;
  assign sum_2313 = select_2291 + 8'hff;
  // hls/stages/patches.hpp:132
  logic equal_2314;
  assign equal_2314 = {sum_2313[7], select_504_s3_q, select_502_s3_q} == {1'b0, sum_2313[6:0], 3'h4};
  // hls/stages/patches.hpp:134
  logic [4:0] select_2317;
  assign select_2317 = (and_2138_s3_q | (select_2289 & equal_2314)) ? {and_2138_s3_q, 4'h0} : patches_left_next_1_q;
  // hls/stages/patches.hpp:142
  logic [3:0] column_7;
  assign column_7 = select_2312[4] ? select_2317[3:0] : select_2312[3:0];
  // hls/stages/agreement.hpp:276
  logic select_2320;
  assign select_2320 = or_2311 ? and_2138_s3_q : patches_left_next_0_q[4];
  // hls/stages/patches.hpp:142
  logic and_2326;
  assign and_2326 = (select_2278_s3_q & (select_2272_s3_q[3] ^ select_2272_s3_q[4])) & ((~select_2312[4]) | (~select_2317[4]));
  // hls/stages/patches.hpp:184
  logic less_2417;
  assign less_2417 = patches_sums_values_0_q < patches_best_differing_q;
  // hls/stages/patches.hpp:185
  logic not_2418;
  assign not_2418 = ~less_2417;
  logic [1:0] select_2419;
  assign select_2419 = patches_summed_first_s3_q ? 2'h2 : {less_2417, not_2418};
  logic [12:0] select_2421;
  assign select_2421 = select_2419[0] ? {4'h0, patches_summed_first_s3_q, 3'h0, patches_summed_row_column_s3_q} : {patches_summed_row_column_s3_q, patches_sums_values_0_q[7:0]};
  logic [14:0] select_2422;
  assign select_2422 = select_2419[0] ? {patches_best_column_q, patches_best_differing_q} : {7'h0, left_pixel_q};
  logic [14:0] select_2423;
  assign select_2423 = (select_2419 == 2'h2) ? {select_2421[12:8], patches_sums_values_0_q[9:8], select_2421[7:0]} : select_2422;
  // hls/stages/agreement.hpp:901
  logic [6:0] select_2448;
  assign select_2448 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2449;
  assign sum_2449 = {6'h0, textured_s3_q} + select_2448;
  // hls/stages/agreement.hpp:1062
  logic [9:0] sum_2451;
  assign sum_2451 = {3'h0, sum_2449} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:901
  logic [6:0] select_2453;
  assign select_2453 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:902
  logic [6:0] sum_2454;
  assign sum_2454 = {6'h0, explained_s3_q} + select_2453;
  // hls/stages/agreement.hpp:1063
  logic [9:0] sum_2456;
  assign sum_2456 = {3'h0, sum_2454} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:901
  logic [6:0] select_2463;
  assign select_2463 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:903
  logic [6:0] sum_2464;
  assign sum_2464 = {6'h0, and_2462_s3_q} + select_2463;
  // hls/stages/agreement.hpp:1064
  logic [9:0] sum_2466;
  assign sum_2466 = {3'h0, sum_2464} + (region_fresh_s3_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:1095
  logic [2:0] select_2516;
  assign select_2516 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2517;
  assign difference_2517 = {1'b0, textured_2_s3_q} - {1'b0, select_2516};
  logic [4:0] t;
  assign t = {difference_2517[3], difference_2517} + (equal_558_s3_q ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1101
  logic equal_2520;
  assign equal_2520 = t[4:1] == 4'h0;
  // hls/stages/agreement.hpp:1102
  logic not_2532;
  assign not_2532 = ~region_row_s3_q[2];
  logic [2:0] select_2533;
  assign select_2533 = region_row_s3_q[1] ? {1'b0, not_2532, 1'b0} : {region_row_s3_q[2], 1'b0, not_2532};
  logic [5:0] select_2534;
  assign select_2534 = region_row_s3_q[0] ? {select_2533[2], 1'b0, select_2533[1], 1'b0, select_2533[0], 1'b0} : {1'b0, select_2533[2], 1'b0, select_2533[1], 1'b0, select_2533[0]};
  logic [11:0] select_2535;
  assign select_2535 = or_2531_s3_q ? {select_2534[5], 1'b0, select_2534[4], 1'b0, select_2534[3], 1'b0, select_2534[2], 1'b0, select_2534[1], 1'b0, select_2534[0], 1'b0} : {1'b0, select_2534[5], 1'b0, select_2534[4], 1'b0, select_2534[3], 1'b0, select_2534[2], 1'b0, select_2534[1], 1'b0, select_2534[0]};
  logic [23:0] select_2536;
  assign select_2536 = or_2528_s3_q ? {select_2535[11], 1'b0, select_2535[10], 1'b0, select_2535[9], 1'b0, select_2535[8], 1'b0, select_2535[7], 1'b0, select_2535[6], 1'b0, select_2535[5], 1'b0, select_2535[4], 1'b0, select_2535[3], 1'b0, select_2535[2], 1'b0, select_2535[1], 1'b0, select_2535[0], 1'b0} : {1'b0, select_2535[11], 1'b0, select_2535[10], 1'b0, select_2535[9], 1'b0, select_2535[8], 1'b0, select_2535[7], 1'b0, select_2535[6], 1'b0, select_2535[5], 1'b0, select_2535[4], 1'b0, select_2535[3], 1'b0, select_2535[2], 1'b0, select_2535[1], 1'b0, select_2535[0]};
  logic [47:0] select_2537;
  assign select_2537 = or_2525_s3_q ? {select_2536[23], 1'b0, select_2536[22], 1'b0, select_2536[21], 1'b0, select_2536[20], 1'b0, select_2536[19], 1'b0, select_2536[18], 1'b0, select_2536[17], 1'b0, select_2536[16], 1'b0, select_2536[15], 1'b0, select_2536[14], 1'b0, select_2536[13], 1'b0, select_2536[12], 1'b0, select_2536[11], 1'b0, select_2536[10], 1'b0, select_2536[9], 1'b0, select_2536[8], 1'b0, select_2536[7], 1'b0, select_2536[6], 1'b0, select_2536[5], 1'b0, select_2536[4], 1'b0, select_2536[3], 1'b0, select_2536[2], 1'b0, select_2536[1], 1'b0, select_2536[0], 1'b0} : {1'b0, select_2536[23], 1'b0, select_2536[22], 1'b0, select_2536[21], 1'b0, select_2536[20], 1'b0, select_2536[19], 1'b0, select_2536[18], 1'b0, select_2536[17], 1'b0, select_2536[16], 1'b0, select_2536[15], 1'b0, select_2536[14], 1'b0, select_2536[13], 1'b0, select_2536[12], 1'b0, select_2536[11], 1'b0, select_2536[10], 1'b0, select_2536[9], 1'b0, select_2536[8], 1'b0, select_2536[7], 1'b0, select_2536[6], 1'b0, select_2536[5], 1'b0, select_2536[4], 1'b0, select_2536[3], 1'b0, select_2536[2], 1'b0, select_2536[1], 1'b0, select_2536[0]};
  // hls/stages/agreement.hpp:1031
  logic and_2541;
  assign and_2541 = good_known_q & (~((good_q & select_2537) == 48'h0));
  // hls/stages/agreement.hpp:1097
  logic [2:0] select_2550;
  assign select_2550 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2551;
  assign difference_2551 = {1'b0, shown_2_s3_q} - {1'b0, select_2550};
  logic [4:0] around;
  assign around = {difference_2551[3], difference_2551} + (equal_558_s3_q ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1104
  logic [5:0] sum_2554;
  assign sum_2554 = {1'b0, around} + {2'h0, around[4:1]};
  logic is_seen;
  assign is_seen = equal_2520 ? and_2541 : (~({sum_2554, around[0]} < {2'h0, t}));
  // hls/stages/agreement.hpp:1098
  logic [2:0] select_2566;
  assign select_2566 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2567;
  assign difference_2567 = {1'b0, near_2_s3_q} - {1'b0, select_2566};
  logic [4:0] n;
  assign n = {difference_2567[3], difference_2567} + (equal_558_s3_q ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1113
  logic and_2571;
  assign and_2571 = is_seen & ({1'b0, around[4:1]} < n);
  // hls/stages/agreement.hpp:276
  logic [8:0] select_2605;
  assign select_2605 = sample_pair_whole_s3_q ? (and_536_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2607;
  assign select_2607 = sample_pair_whole_s3_q ? (and_536_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2609;
  assign select_2609 = sample_pair_whole_s3_q ? (and_536_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2611;
  assign select_2611 = sample_pair_whole_s3_q ? (and_536_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2616;
  assign sum_2616 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2617;
  assign difference_2617 = {1'b0, sum_2616[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2618;
  assign xor_2618 = {difference_2617[8:0], sum_2616[0]} ^ {10{difference_2617[9]}};
  logic [10:0] size;
  assign size = {10'h0, difference_2617[9]} + {1'b0, xor_2618};
  // hls/stages/census.hpp:211
  logic [13:0] detail;
  assign detail = {3'h0, size} + (equal_541_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2623;
  assign select_2623 = sample_pair_whole_s3_q ? (and_536_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:209
  logic [9:0] sum_2624;
  assign sum_2624 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2625;
  assign difference_2625 = {1'b0, sum_2624[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:210
  logic [9:0] xor_2626;
  assign xor_2626 = {difference_2625[8:0], sum_2624[0]} ^ {10{difference_2625[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2625[9]} + {1'b0, xor_2626};
  // hls/stages/census.hpp:211
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_2} + (equal_541_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:276
  logic [13:0] select_2631;
  assign select_2631 = sample_pair_whole_s3_q ? (and_536_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/census.hpp:274
  logic [11:0] sum_2714;
  assign sum_2714 = sum_2710_s3_q + {2'h0, sum_2713_s3_q};
  // hls/stages/agreement.hpp:521
  logic [11:0] select_2716;
  assign select_2716 = and_538_s3_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2717;
  assign select_2717 = and_538_s3_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2718;
  assign select_2718 = and_538_s3_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2719;
  assign select_2719 = and_538_s3_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  // hls/stages/census.hpp:284
  logic [12:0] sum_2722;
  assign sum_2722 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2714};
  logic [13:0] sum_2724;
  assign sum_2724 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2722});
  // hls/stages/census.hpp:311
  logic and_2726;
  assign and_2726 = and_697_s3_q & (9'h4 < sum_2724[13:5]);
  // hls/stages/census.hpp:312
  logic and_2727;
  assign and_2727 = and_697_s3_q & less_721;
  // hls/stages/census.hpp:313
  logic [19:0] sum_2728;
  assign sum_2728 = census_left_misses_q + {{17{and_2727}}, and_2726, 1'b0, and_2726};
  // hls/stages/agreement.hpp:521
  logic [19:0] select_2730;
  assign select_2730 = and_538_s3_q ? (equal_2721_s3_q ? 20'h0 : sum_2728) : census_left_misses_q;
  // hls/stages/agreement.hpp:276
  logic [27:0] select_2800;
  assign select_2800 = sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
  // hls/stages/agreement.hpp:521
  logic select_2803;
  assign select_2803 = and_538_s3_q ? sharpness_last_mask_q : sharpness_before_last_mask_q;
  // hls/stages/census.hpp:361
  logic and_2806;
  assign and_2806 = whole_2_s3_q & (~(column_s3_q[6:1] == 6'h0));
  // hls/stages/agreement.hpp:458
  logic and_2812;
  assign and_2812 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_s3_q[8:2]));
  logic and_2813;
  assign and_2813 = and_2806 & and_2812;
  // hls/stages/census.hpp:360
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2800[13:0]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2815;
  assign select_2815 = and_2813 ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2817;
  assign select_2817 = equal_2721_s3_q ? {11'h0, select_2815} : (sharpness_sums_detail_0_q + {11'h0, select_2815});
  // hls/stages/agreement.hpp:458
  logic and_2824;
  assign and_2824 = sharpness_last_mask_q & (sharpness_before_last_mask_q & (7'h2 < contrast_2_s3_q[8:2]));
  logic and_2825;
  assign and_2825 = and_2806 & and_2824;
  // hls/stages/census.hpp:360
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2800[27:14]};
  // hls/stages/census.hpp:362
  logic [12:0] select_2827;
  assign select_2827 = and_2825 ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:363
  logic [23:0] select_2829;
  assign select_2829 = equal_2721_s3_q ? {11'h0, select_2827} : (sharpness_sums_detail_1_q + {11'h0, select_2827});
  logic [8:0] select_2832;
  assign select_2832 = and_2813 ? contrast_s3_q : 9'h0;
  logic [23:0] sum_2833;
  assign sum_2833 = (equal_2721_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2832};
  logic [8:0] select_2836;
  assign select_2836 = and_2825 ? contrast_2_s3_q : 9'h0;
  logic [23:0] sum_2837;
  assign sum_2837 = (equal_2721_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2836};
  // hls/stages/agreement.hpp:211
  logic equal_2839;
  assign equal_2839 = x_s3_q[7:3] == 5'h0;
  // hls/stages/census.hpp:376
  logic less_2840;
  assign less_2840 = 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
  // hls/stages/census.hpp:415
  logic less_2841;
  assign less_2841 = x_s3_q[4:0] < 5'h3;
  logic not_2842;
  assign not_2842 = ~x_s3_q[1];
  logic [2:0] select_2843;
  assign select_2843 = x_s3_q[0] ? {1'b0, not_2842, 1'b0} : {x_s3_q[1], 1'b0, not_2842};
  logic [5:0] select_2844;
  assign select_2844 = slot_s3_q[2] ? {select_2843[2], 1'b0, select_2843[1], 1'b0, select_2843[0], 1'b0} : {1'b0, select_2843[2], 1'b0, select_2843[1], 1'b0, select_2843[0]};
  logic [11:0] select_2845;
  assign select_2845 = slot_s3_q[1] ? {select_2844[5], 1'b0, select_2844[4], 1'b0, select_2844[3], 1'b0, select_2844[2], 1'b0, select_2844[1], 1'b0, select_2844[0], 1'b0} : {1'b0, select_2844[5], 1'b0, select_2844[4], 1'b0, select_2844[3], 1'b0, select_2844[2], 1'b0, select_2844[1], 1'b0, select_2844[0]};
  logic [23:0] select_2846;
  assign select_2846 = slot_s3_q[0] ? {select_2845[11], 1'b0, select_2845[10], 1'b0, select_2845[9], 1'b0, select_2845[8], 1'b0, select_2845[7], 1'b0, select_2845[6], 1'b0, select_2845[5], 1'b0, select_2845[4], 1'b0, select_2845[3], 1'b0, select_2845[2], 1'b0, select_2845[1], 1'b0, select_2845[0], 1'b0} : {1'b0, select_2845[11], 1'b0, select_2845[10], 1'b0, select_2845[9], 1'b0, select_2845[8], 1'b0, select_2845[7], 1'b0, select_2845[6], 1'b0, select_2845[5], 1'b0, select_2845[4], 1'b0, select_2845[3], 1'b0, select_2845[2], 1'b0, select_2845[1], 1'b0, select_2845[0]};
  // hls/stages/census.hpp:378
  logic and_2850;
  assign and_2850 = less_2841 & (~((sharpness_sums_contrast_1_q & select_2846) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2852;
  assign select_2852 = (less_2840 & and_2850) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2852};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2855;
  assign select_2855 = equal_2839 ? (less_2840 ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  // hls/stages/census.hpp:378
  logic and_2860;
  assign and_2860 = less_2841 & (~((sharpness_sums_contrast_0_q & select_2846) == 24'h0));
  // hls/stages/census.hpp:383
  logic [17:0] select_2862;
  assign select_2862 = (less_2840 & and_2860) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2862};
  // hls/stages/agreement.hpp:216
  logic [17:0] select_2865;
  assign select_2865 = equal_2839 ? (less_2840 ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [2:0] select_2867;
  assign select_2867 = equal_2839 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2869;
  assign select_2869 = equal_2839 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [1:0] select_2871;
  assign select_2871 = equal_2839 ? {sharpness_comparing_contrast_0_q[0], and_2860} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2873;
  assign select_2873 = equal_2839 ? {sharpness_comparing_contrast_1_q[0], and_2850} : sharpness_comparing_contrast_1_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/agreement.hpp:216
  logic select_2878;
  assign select_2878 = drew_q ? (equal_2839 ? five_times[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/census.hpp:389
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/agreement.hpp:216
  logic select_2882;
  assign select_2882 = drew_q ? (equal_2839 ? five_times_2[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  // hls/stages/census.hpp:375
  logic equal_2883;
  assign equal_2883 = {x_s3_q[4:0], slot_s3_q} == 8'h0;
  // hls/stages/census.hpp:391
  logic xor_2884;
  assign xor_2884 = sharpness_comparing_product_0_q[2] ^ five_times[0];
  logic select_2887;
  assign select_2887 = (equal_2883 | xor_2884) ? (five_times[0] & xor_2884) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2889;
  assign select_2889 = drew_q ? (equal_2839 ? select_2887 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  // hls/stages/census.hpp:391
  logic xor_2890;
  assign xor_2890 = sharpness_comparing_product_1_q[2] ^ five_times_2[0];
  logic select_2893;
  assign select_2893 = (equal_2883 | xor_2890) ? (five_times_2[0] & xor_2890) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2895;
  assign select_2895 = drew_q ? (equal_2839 ? select_2893 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:392
  logic xor_2896;
  assign xor_2896 = sharpness_comparing_contrast_0_q[1] ^ and_2850;
  logic select_2899;
  assign select_2899 = (equal_2883 | xor_2896) ? (and_2850 & xor_2896) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:216
  logic select_2901;
  assign select_2901 = drew_q ? (equal_2839 ? select_2899 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:392
  logic xor_2902;
  assign xor_2902 = sharpness_comparing_contrast_1_q[1] ^ and_2860;
  logic select_2905;
  assign select_2905 = (equal_2883 | xor_2902) ? (and_2860 & xor_2902) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:216
  logic select_2907;
  assign select_2907 = drew_q ? (equal_2839 ? select_2905 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:927
  logic [13:0] select_3023;
  assign select_3023 = and_3015_s3_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3021_s3_q});
  // hls/stages/agreement.hpp:789
  logic and_3026;
  assign and_3026 = not_564_s3_q & (drew_q & (ends_cell_s3_q & textured_s3_q));
  logic and_3031;
  assign and_3031 = not_564_s3_q & (drew_q & (ends_cell_s3_q & explained_s3_q));
  logic and_3036;
  assign and_3036 = not_564_s3_q & (drew_q & (ends_cell_s3_q & and_2462_s3_q));
  // hls/stages/agreement.hpp:1106
  logic not_3040;
  assign not_3040 = ~(x_s3_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:1096
  logic [2:0] select_3049;
  assign select_3049 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3050;
  assign difference_3050 = {1'b0, explained_2_s3_q} - {1'b0, select_3049};
  logic [4:0] e;
  assign e = {difference_3050[3], difference_3050} + (equal_558_s3_q ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:1103
  logic [5:0] sum_3053;
  assign sum_3053 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:1107
  logic not_3057;
  assign not_3057 = ~(equal_2520 ? and_2541 : (~({sum_3053, e[0]} < {2'h0, t})));
  // hls/stages/agreement.hpp:789
  logic and_3060;
  assign and_3060 = ends_cell_s3_q & (not_3040 & (centres_values_1_textured_s3_q & not_3057));
  logic and_3062;
  assign and_3062 = not_564_s3_q & (drew_q & and_3060);
  // hls/stages/agreement.hpp:1133
  logic less_3065;
  assign less_3065 = region_row_s3_q < x_s3_q[5:3];
  logic [9:0] select_3066;
  assign select_3066 = less_3065 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3069;
  assign select_3069 = less_3065 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:1134
  logic [10:0] sum_3070;
  assign sum_3070 = {1'b0, select_3069} + {3'h0, select_3069[9:2]};
  logic and_3072;
  assign and_3072 = (~(select_3066[9:4] == 6'h0)) & ({sum_3070, select_3069[1:0]} < {3'h0, select_3066});
  // hls/stages/agreement.hpp:1143
  logic [9:0] select_3075;
  assign select_3075 = x_s3_q[6] ? (equal_2070_s3_q ? 10'h0 : (and_3072 ? select_3066 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:789
  logic [9:0] select_3076;
  assign select_3076 = equal_563_s3_q ? select_3075 : 10'h0;
  // hls/stages/agreement.hpp:927
  logic [13:0] select_3078;
  assign select_3078 = and_3015_s3_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3076});
  logic [13:0] select_3085;
  assign select_3085 = and_3015_s3_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3083_s3_q});
  // hls/stages/agreement.hpp:1111
  logic and_3087;
  assign and_3087 = not_3040 & (centres_values_1_textured_s3_q & centres_values_1_of_skin_s3_q);
  // hls/stages/agreement.hpp:789
  logic and_3090;
  assign and_3090 = not_564_s3_q & (drew_q & (ends_cell_s3_q & and_3087));
  // hls/stages/agreement.hpp:927
  logic [13:0] select_3092;
  assign select_3092 = and_3015_s3_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3090});
  // hls/stages/agreement.hpp:1111
  logic and_3094;
  assign and_3094 = centres_values_1_textured_s3_q & (centres_values_1_of_skin_s3_q & not_3057);
  // hls/stages/agreement.hpp:789
  logic and_3098;
  assign and_3098 = not_564_s3_q & (drew_q & (ends_cell_s3_q & (not_3040 & and_3094)));
  // hls/stages/agreement.hpp:927
  logic [13:0] select_3100;
  assign select_3100 = and_3015_s3_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3098});
  logic [13:0] select_3119;
  assign select_3119 = and_3015_s3_q ? 14'h0 : (counts_on_skin_q + {13'h0, and_3117_s3_q});
  // hls/stages/agreement.hpp:789
  logic [7:0] select_3194;
  assign select_3194 = drew_q ? (equal_2166_s3_q ? (and_3176_s3_q ? residual_s3_q : 8'h0) : 8'h0) : 8'h0;
  logic [7:0] select_3195;
  assign select_3195 = equal_563_s3_q ? 8'h0 : select_3194;
  // hls/stages/registration.hpp:134
  logic [13:0] select_3197;
  assign select_3197 = and_3175_s3_q ? 14'h0 : (registration_half_across_q + {{6{select_3195[7]}}, select_3195});
  // hls/stages/agreement.hpp:789
  logic and_3200;
  assign and_3200 = not_564_s3_q & (drew_q & (and_3176_s3_q & equal_2166_s3_q));
  // hls/stages/registration.hpp:134
  logic [5:0] select_3202;
  assign select_3202 = and_3175_s3_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3200});
  // hls/stages/registration.hpp:107
  logic and_3204;
  assign and_3204 = and_3176_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_limit_i}));
  // hls/stages/agreement.hpp:789
  logic [1:0] select_3206;
  assign select_3206 = drew_q ? (equal_2166_s3_q ? {and_3204, and_3176_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3207;
  assign select_3207 = equal_563_s3_q ? 2'h0 : select_3206;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3208;
  assign sum_3208 = registration_half_votes_down_q + {{5{select_3207[1]}}, select_3207};
  // hls/stages/agreement.hpp:789
  logic [1:0] select_3214;
  assign select_3214 = drew_q ? (equal_2166_s3_q ? {and_3212_s3_q, and_3176_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3215;
  assign select_3215 = equal_563_s3_q ? 2'h0 : select_3214;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3216;
  assign sum_3216 = registration_half_votes_up_q + {{5{select_3215[1]}}, select_3215};
  // hls/stages/registration.hpp:107
  logic and_3219;
  assign and_3219 = and_3176_s3_q & ($signed(residual_s3_q) < $signed({2'h0, cfg_moved_half_limit_i}));
  // hls/stages/agreement.hpp:789
  logic [1:0] select_3221;
  assign select_3221 = drew_q ? (equal_2166_s3_q ? {and_3219, and_3176_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3222;
  assign select_3222 = equal_563_s3_q ? 2'h0 : select_3221;
  // hls/stages/registration.hpp:184
  logic [6:0] sum_3223;
  assign sum_3223 = registration_half_half_votes_down_q + {{5{select_3222[1]}}, select_3222};
  // hls/stages/agreement.hpp:789
  logic [1:0] select_3228;
  assign select_3228 = drew_q ? (equal_2166_s3_q ? {and_3226_s3_q, and_3176_s3_q} : 2'h0) : 2'h0;
  logic [1:0] select_3229;
  assign select_3229 = equal_563_s3_q ? 2'h0 : select_3228;
  // hls/stages/registration.hpp:185
  logic [6:0] sum_3230;
  assign sum_3230 = registration_half_half_votes_up_q + {{5{select_3229[1]}}, select_3229};
  // hls/stages/agreement.hpp:789
  logic and_3264;
  assign and_3264 = equal_563_s3_q & (x_s3_q[6] & (not_2435_s3_q & less_2101_s3_q));
  // hls/stages/agreement.hpp:1131
  logic [11:0] select_3271;
  assign select_3271 = or_2105_s3_q ? 12'h0 : (equal_3269_s3_q ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:1143
  logic [11:0] select_3274;
  assign select_3274 = x_s3_q[6] ? (equal_2070_s3_q ? 12'h0 : (less_2101_s3_q ? select_3271 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:789
  logic [11:0] select_3275;
  assign select_3275 = equal_563_s3_q ? select_3274 : 12'h0;
  // hls/stages/registration.hpp:153
  logic and_3276;
  assign and_3276 = x_s3_q[1] & all_s3_q;
  // hls/stages/agreement.hpp:1143
  logic and_3279;
  assign and_3279 = not_2435_s3_q & (less_2101_s3_q & ({and_3276, x_s3_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:789
  logic and_3281;
  assign and_3281 = equal_563_s3_q & (x_s3_q[6] & and_3279);
  // hls/stages/registration.hpp:252
  logic [13:0] sum_3283;
  assign sum_3283 = {{2{select_3275[11]}}, select_3275} + (and_3281 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:1131
  logic [11:0] select_3286;
  assign select_3286 = or_2105_s3_q ? 12'h0 : (equal_3269_s3_q ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:1143
  logic [11:0] select_3289;
  assign select_3289 = x_s3_q[6] ? (equal_2070_s3_q ? 12'h0 : (less_2101_s3_q ? select_3286 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:789
  logic [11:0] select_3290;
  assign select_3290 = equal_563_s3_q ? select_3289 : 12'h0;
  // hls/stages/registration.hpp:253
  logic [13:0] sum_3292;
  assign sum_3292 = {{2{select_3290[11]}}, select_3290} + (and_3281 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:150
  logic not_3294;
  assign not_3294 = ~all_s3_q;
  // hls/stages/agreement.hpp:1143
  logic and_3297;
  assign and_3297 = not_2435_s3_q & (less_2101_s3_q & (x_s3_q[2:0] == {all_s3_q, not_3294, 1'b0}));
  // hls/stages/agreement.hpp:789
  logic and_3303;
  assign and_3303 = equal_563_s3_q & (x_s3_q[6] & (not_2435_s3_q & (less_2101_s3_q & all_s3_q)));
  // hls/stages/registration.hpp:246
  logic not_3304;
  assign not_3304 = ~and_3303;
  logic less_3305;
  assign less_3305 = $signed({9'h1, {2{not_3304}}, and_3303}) < $signed(registration_up_q[13:2]);
  logic select_3306;
  assign select_3306 = (equal_563_s3_q & (x_s3_q[6] & and_3297)) ? less_3305 : registration_enough_q;
  // hls/stages/agreement.hpp:1143
  logic and_3310;
  assign and_3310 = x_s3_q[6] & (not_2435_s3_q & (less_2101_s3_q & (x_s3_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:789
  logic and_3311;
  assign and_3311 = equal_563_s3_q & and_3310;
  // hls/stages/registration.hpp:242
  logic less_3312;
  assign less_3312 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3314;
  assign less_3314 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/registration.hpp:159
  logic equal_3316;
  assign equal_3316 = x_s3_q[2:0] == 3'h7;
  // hls/stages/agreement.hpp:789
  logic and_3320;
  assign and_3320 = equal_563_s3_q & (x_s3_q[6] & (not_2435_s3_q & (less_2101_s3_q & equal_3316)));
  // hls/stages/agreement.hpp:1143
  logic and_3327;
  assign and_3327 = x_s3_q[6] & (not_2435_s3_q & (less_2101_s3_q & (x_s3_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:157
  logic equal_3330;
  assign equal_3330 = x_s3_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:1143
  logic and_3333;
  assign and_3333 = not_2435_s3_q & (less_2101_s3_q & (x_s3_q[5] ? x_s3_q[3] : equal_3330));
  // hls/stages/registration.hpp:244
  logic and_3337;
  assign and_3337 = (equal_563_s3_q & (x_s3_q[6] & and_3333)) & (less_3314 | less_3312);
  // hls/stages/agreement.hpp:1143
  logic and_3342;
  assign and_3342 = not_2435_s3_q & (less_2101_s3_q & ((~x_s3_q[5]) & (x_s3_q[3] & equal_3330)));
  // hls/stages/registration.hpp:244
  logic and_3345;
  assign and_3345 = registration_votes_up_q & registration_other_down_q;
  logic select_3347;
  assign select_3347 = registration_votes_down_q ? (registration_other_up_q | and_3345) : and_3345;
  // hls/stages/registration.hpp:138
  logic and_3349;
  assign and_3349 = (equal_563_s3_q & (x_s3_q[6] & and_3342)) & (registration_other_enough_q & select_3347);
  // hls/stages/registration.hpp:245
  logic or_3352;
  assign or_3352 = registration_moved_q | (registration_enough_q & (and_3337 | and_3349));
  // hls/stages/agreement.hpp:276
  logic [7:0] select_3437;
  assign select_3437 = sample_pair_whole_s3_q ? (equal_2156_s3_q ? patches_place_0_slope_q : select_2261[21:14]) : patches_place_0_slope_q;
  logic [7:0] select_3442;
  assign select_3442 = sample_pair_whole_s3_q ? (equal_2156_s3_q ? patches_place_1_slope_q : select_2290[21:14]) : patches_place_1_slope_q;
  // hls/stages/patches.hpp:127
  logic select_3444;
  assign select_3444 = equal_2156_s3_q ? patches_valid_0_q : (select_2155_s3_q ? patches_valid_0_q : select_2258[0]);
  // hls/stages/agreement.hpp:276
  logic select_3447;
  assign select_3447 = sample_pair_whole_s3_q ? (and_2281 ? (sample_present_s3_q & select_3444) : select_3444) : patches_valid_0_q;
  // hls/stages/patches.hpp:127
  logic select_3449;
  assign select_3449 = equal_2156_s3_q ? patches_valid_1_q : (select_2155_s3_q ? select_2258[0] : patches_valid_1_q);
  // hls/stages/agreement.hpp:276
  logic select_3452;
  assign select_3452 = sample_pair_whole_s3_q ? (and_2301 ? (sample_present_s3_q & select_3449) : select_3449) : patches_valid_1_q;
  logic [5:0] select_3455;
  assign select_3455 = sample_pair_whole_s3_q ? (select_2279[5] ? {1'b1, select_2279[4:0]} : (select_2279 + 6'h1)) : patches_right_next_0_q;
  logic [5:0] select_3458;
  assign select_3458 = sample_pair_whole_s3_q ? (select_2299[5] ? {1'b1, select_2299[4:0]} : (select_2299 + 6'h1)) : patches_right_next_1_q;
  logic [4:0] select_3461;
  assign select_3461 = sample_pair_whole_s3_q ? (select_2312[4] ? {1'b1, select_2312[3:0]} : (select_2312 + 5'h1)) : patches_left_next_0_q;
  logic [4:0] select_3464;
  assign select_3464 = sample_pair_whole_s3_q ? (select_2317[4] ? {1'b1, select_2317[3:0]} : (select_2317 + 5'h1)) : patches_left_next_1_q;
  // hls/stages/patches.hpp:521
  logic [9:0] sum_3;
  assign sum_3 = {4'h0, or_3883_s3_q, parity_3879_s3_q, xor_3867_s3_q, parity_3839_s3_q, parity_3777_s3_q, parity_3648_s3_q} + (equal_3884_s3_q ? 10'h0 : patches_sums_values_16_q);
  // hls/stages/patches.hpp:184
  logic [9:0] select_3888;
  assign select_3888 = equal_2242_s3_q ? patches_sums_values_0_q : (equal_2244_s3_q ? sum_3 : patches_sums_values_0_q);
  logic [9:0] select_3889;
  assign select_3889 = equal_2244_s3_q ? patches_sums_values_0_q : patches_sums_values_1_q;
  logic [9:0] select_3891;
  assign select_3891 = equal_2244_s3_q ? patches_sums_values_1_q : patches_sums_values_2_q;
  logic [9:0] select_3893;
  assign select_3893 = equal_2244_s3_q ? patches_sums_values_2_q : patches_sums_values_3_q;
  logic [9:0] select_3895;
  assign select_3895 = equal_2244_s3_q ? patches_sums_values_3_q : patches_sums_values_4_q;
  logic [9:0] select_3897;
  assign select_3897 = equal_2244_s3_q ? patches_sums_values_4_q : patches_sums_values_5_q;
  logic [9:0] select_3899;
  assign select_3899 = equal_2244_s3_q ? patches_sums_values_5_q : patches_sums_values_6_q;
  logic [9:0] select_3901;
  assign select_3901 = equal_2244_s3_q ? patches_sums_values_6_q : patches_sums_values_7_q;
  logic [9:0] select_3903;
  assign select_3903 = equal_2244_s3_q ? patches_sums_values_7_q : patches_sums_values_8_q;
  logic [9:0] select_3905;
  assign select_3905 = equal_2244_s3_q ? patches_sums_values_8_q : patches_sums_values_9_q;
  logic [9:0] select_3907;
  assign select_3907 = equal_2244_s3_q ? patches_sums_values_9_q : patches_sums_values_10_q;
  logic [9:0] select_3909;
  assign select_3909 = equal_2244_s3_q ? patches_sums_values_10_q : patches_sums_values_11_q;
  logic [9:0] select_3911;
  assign select_3911 = equal_2244_s3_q ? patches_sums_values_11_q : patches_sums_values_12_q;
  logic [9:0] select_3913;
  assign select_3913 = equal_2244_s3_q ? patches_sums_values_12_q : patches_sums_values_13_q;
  logic [9:0] select_3915;
  assign select_3915 = equal_2244_s3_q ? patches_sums_values_13_q : patches_sums_values_14_q;
  logic [9:0] select_3917;
  assign select_3917 = equal_2244_s3_q ? patches_sums_values_14_q : patches_sums_values_15_q;
  logic [9:0] select_3919;
  assign select_3919 = equal_2244_s3_q ? patches_sums_values_15_q : patches_sums_values_16_q;
  // hls/stages/patches.hpp:595
  logic or_4024;
  assign or_4024 = (~(patches_second_s3_q ? patches_valid_1_q : patches_valid_0_q)) | or_4023_s3_q;
  logic or_4027;
  assign or_4027 = equal_4015_s3_q | (less_4017_s3_q | (less_4018_s3_q | or_4024));
  // hls/stages/patches.hpp:575
  logic not_4028;
  assign not_4028 = ~or_4027;
  // hls/stages/patches.hpp:556
  logic and_4029;
  assign and_4029 = equal_2408_s3_q & not_4028;
  // hls/stages/patches.hpp:184
  logic and_4032;
  assign and_4032 = equal_2242_s3_q & (less_2405_s3_q ? (not_2407_s3_q & and_4029) : and_4029);
  // hls/stages/patches.hpp:653
  logic not_4033;
  assign not_4033 = ~patches_lower_s3_q;
  // hls/stages/patches.hpp:556
  logic and_4035;
  assign and_4035 = equal_2408_s3_q & (patches_second_s3_q & not_4028);
  // hls/stages/patches.hpp:184
  logic and_4038;
  assign and_4038 = equal_2242_s3_q & (less_2405_s3_q ? (not_2407_s3_q & and_4035) : and_4035);
  // hls/stages/patches.hpp:653
  logic not_4039;
  assign not_4039 = ~and_4038;
  // hls/stages/patches.hpp:188
  logic and_4041;
  assign and_4041 = and_4032 & (not_4033 & not_4039);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_4043;
  assign sum_4043 = {7'h0, and_4041} + (patches_round_ends_q ? 8'h0 : patches_quarters_0_places_q);
  // hls/stages/patches.hpp:593
  logic [7:0] select_4069;
  assign select_4069 = patches_second_s3_q ? patches_place_1_slope_q : patches_place_0_slope_q;
  // hls/stages/patches.hpp:592
  logic [5:0] select_4070;
  assign select_4070 = patches_second_s3_q ? patches_place_1_shift_q : patches_place_0_shift_q;
  logic [3:0] sum_4071;
  assign sum_4071 = {2'h0, select_4003_s3_q[4:3]} + 4'hf;
  logic [6:0] sum_4072;
  assign sum_4072 = {select_4070[5], select_4070} + {{3{sum_4071[3]}}, sum_4071};
  // hls/stages/patches.hpp:593
  logic [17:0] product_4073;
  assign product_4073 = $signed({{10{select_4069[7]}}, select_4069}) * $signed({{8{sum_4072[6]}}, sum_4072, select_4003_s3_q[2:0]});
  // hls/stages/patches.hpp:594
  logic [13:0] difference_4074;
  assign difference_4074 = {{6{select_4068_s3_q[7]}}, select_4068_s3_q} - {product_4073[17], product_4073[17:5]};
  // hls/stages/patches.hpp:600
  logic less_4075;
  assign less_4075 = $signed({{7{difference_4045[6]}}, difference_4045}) < $signed(difference_4074);
  // hls/stages/patches.hpp:556
  logic and_4078;
  assign and_4078 = equal_2408_s3_q & (not_4028 & (~less_4075));
  // hls/stages/patches.hpp:184
  logic and_4081;
  assign and_4081 = equal_2242_s3_q & (less_2405_s3_q ? (not_2407_s3_q & and_4078) : and_4078);
  // hls/stages/patches.hpp:656
  logic and_4082;
  assign and_4082 = and_4081 & and_4041;
  logic [7:0] sum_4083;
  assign sum_4083 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_up_q) + {7'h0, and_4082};
  // hls/stages/patches.hpp:556
  logic and_4087;
  assign and_4087 = not_4028 & (~($signed(difference_4074) < $signed({8'h0, cfg_patch_limit_i})));
  logic and_4088;
  assign and_4088 = equal_2408_s3_q & and_4087;
  // hls/stages/patches.hpp:184
  logic and_4091;
  assign and_4091 = equal_2242_s3_q & (less_2405_s3_q ? (not_2407_s3_q & and_4088) : and_4088);
  // hls/stages/patches.hpp:657
  logic and_4092;
  assign and_4092 = and_4091 & and_4041;
  logic [7:0] sum_4093;
  assign sum_4093 = (patches_round_ends_q ? 8'h0 : patches_quarters_0_down_q) + {7'h0, and_4092};
  // hls/stages/patches.hpp:188
  logic and_4095;
  assign and_4095 = and_4032 & (and_4038 & not_4033);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_4097;
  assign sum_4097 = {7'h0, and_4095} + (patches_round_ends_q ? 8'h0 : patches_quarters_1_places_q);
  // hls/stages/patches.hpp:656
  logic and_4099;
  assign and_4099 = and_4081 & and_4095;
  logic [7:0] sum_4100;
  assign sum_4100 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_up_q) + {7'h0, and_4099};
  // hls/stages/patches.hpp:657
  logic and_4102;
  assign and_4102 = and_4091 & and_4095;
  logic [7:0] sum_4103;
  assign sum_4103 = (patches_round_ends_q ? 8'h0 : patches_quarters_1_down_q) + {7'h0, and_4102};
  // hls/stages/patches.hpp:188
  logic and_4105;
  assign and_4105 = and_4032 & (patches_lower_s3_q & not_4039);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_4107;
  assign sum_4107 = {7'h0, and_4105} + (patches_round_ends_q ? 8'h0 : patches_quarters_2_places_q);
  // hls/stages/patches.hpp:656
  logic and_4109;
  assign and_4109 = and_4081 & and_4105;
  logic [7:0] sum_4110;
  assign sum_4110 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_up_q) + {7'h0, and_4109};
  // hls/stages/patches.hpp:657
  logic and_4112;
  assign and_4112 = and_4091 & and_4105;
  logic [7:0] sum_4113;
  assign sum_4113 = (patches_round_ends_q ? 8'h0 : patches_quarters_2_down_q) + {7'h0, and_4112};
  // hls/stages/patches.hpp:188
  logic and_4115;
  assign and_4115 = and_4032 & (patches_lower_s3_q & and_4038);
  // hls/stages/patches.hpp:655
  logic [7:0] sum_4117;
  assign sum_4117 = {7'h0, and_4115} + (patches_round_ends_q ? 8'h0 : patches_quarters_3_places_q);
  // hls/stages/patches.hpp:656
  logic and_4119;
  assign and_4119 = and_4081 & and_4115;
  logic [7:0] sum_4120;
  assign sum_4120 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_up_q) + {7'h0, and_4119};
  // hls/stages/patches.hpp:657
  logic and_4122;
  assign and_4122 = and_4091 & and_4115;
  logic [7:0] sum_4123;
  assign sum_4123 = (patches_round_ends_q ? 8'h0 : patches_quarters_3_down_q) + {7'h0, and_4122};
  // hls/stages/agreement.hpp:1224
  logic equal_4124;
  assign equal_4124 = x_s3_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:1131
  logic less_4125;
  assign less_4125 = x_s3_q[5:3] < 3'h3;
  // hls/stages/agreement.hpp:789
  logic and_4129;
  assign and_4129 = equal_563_s3_q & (x_s3_q[6] & (not_2435_s3_q & (equal_4124 & less_4125)));
  // hls/stages/agreement.hpp:1143
  logic and_4134;
  assign and_4134 = x_s3_q[6] & (not_2435_s3_q & (less_4125 & (x_s3_q[2:0] == 3'h1)));
  // hls/stages/agreement.hpp:789
  logic and_4135;
  assign and_4135 = equal_563_s3_q & and_4134;
  // hls/stages/patches.hpp:619
  logic [7:0] or_4137;
  assign or_4137 = (and_4129 ? patches_quarters_0_places_q : 8'h0) | (and_4135 ? patches_quarters_1_places_q : 8'h0);
  // hls/stages/agreement.hpp:1143
  logic and_4141;
  assign and_4141 = x_s3_q[6] & (not_2435_s3_q & (less_4125 & (x_s3_q[2:0] == 3'h2)));
  // hls/stages/agreement.hpp:789
  logic and_4142;
  assign and_4142 = equal_563_s3_q & and_4141;
  // hls/stages/agreement.hpp:1143
  logic and_4148;
  assign and_4148 = x_s3_q[6] & (not_2435_s3_q & (less_4125 & (x_s3_q[2:0] == 3'h3)));
  // hls/stages/agreement.hpp:789
  logic and_4149;
  assign and_4149 = equal_563_s3_q & and_4148;
  // hls/stages/patches.hpp:619
  logic [7:0] or_4151;
  assign or_4151 = (or_4137 | (and_4142 ? patches_quarters_2_places_q : 8'h0)) | (and_4149 ? patches_quarters_3_places_q : 8'h0);
  // hls/stages/patches.hpp:199
  logic select_4155;
  assign select_4155 = (x_s3_q[5:3] == 3'h2) ? x_s3_q[1] : (x_s3_q[0] & (x_s3_q[5:3] == 3'h1));
  // hls/stages/agreement.hpp:789
  logic and_4159;
  assign and_4159 = equal_563_s3_q & (x_s3_q[6] & (not_2435_s3_q & (less_4125 & select_4155)));
  // hls/stages/patches.hpp:620
  logic [7:0] select_4161;
  assign select_4161 = and_4129 ? (and_4159 ? patches_quarters_0_down_q : patches_quarters_0_up_q) : 8'h0;
  logic [7:0] select_4163;
  assign select_4163 = and_4135 ? (and_4159 ? patches_quarters_1_down_q : patches_quarters_1_up_q) : 8'h0;
  logic [7:0] select_4166;
  assign select_4166 = and_4142 ? (and_4159 ? patches_quarters_2_down_q : patches_quarters_2_up_q) : 8'h0;
  logic [7:0] select_4169;
  assign select_4169 = and_4149 ? (and_4159 ? patches_quarters_3_down_q : patches_quarters_3_up_q) : 8'h0;
  // hls/stages/patches.hpp:621
  logic [7:0] select_4172;
  assign select_4172 = and_4129 ? (and_4159 ? patches_quarters_0_up_q : patches_quarters_0_down_q) : 8'h0;
  logic [7:0] select_4174;
  assign select_4174 = and_4135 ? (and_4159 ? patches_quarters_1_up_q : patches_quarters_1_down_q) : 8'h0;
  logic [7:0] select_4177;
  assign select_4177 = and_4142 ? (and_4159 ? patches_quarters_2_up_q : patches_quarters_2_down_q) : 8'h0;
  logic [7:0] select_4180;
  assign select_4180 = and_4149 ? (and_4159 ? patches_quarters_3_up_q : patches_quarters_3_down_q) : 8'h0;
  // hls/stages/patches.hpp:202
  logic [4:0] sum_4182;
  assign sum_4182 = {2'h0, x_s3_q[2:0]} + 5'h1f;
  // hls/stages/agreement.hpp:1143
  logic and_4186;
  assign and_4186 = x_s3_q[6] & (not_2435_s3_q & (less_4125 & (sum_4182[4:2] == 3'h0)));
  // hls/stages/agreement.hpp:789
  logic and_4187;
  assign and_4187 = equal_563_s3_q & and_4186;
  // hls/stages/patches.hpp:616
  logic [7:0] select_4190;
  assign select_4190 = and_4187 ? (patches_word_places_q + (and_4135 ? 8'h0 : patches_sum_places_q)) : patches_sum_places_q;
  logic [7:0] select_4193;
  assign select_4193 = and_4187 ? (patches_word_up_q + (and_4135 ? 8'h0 : patches_sum_up_q)) : patches_sum_up_q;
  logic [7:0] select_4196;
  assign select_4196 = and_4187 ? (patches_word_down_q + (and_4135 ? 8'h0 : patches_sum_down_q)) : patches_sum_down_q;
  // hls/stages/patches.hpp:602
  logic [5:0] select_4200;
  assign select_4200 = ($signed(difference_4074[13:4]) < $signed(10'h3ff)) ? 6'h30 : difference_4074[5:0];
  logic [5:0] select_4201;
  assign select_4201 = ($signed(14'h10) < $signed(difference_4074)) ? 6'h10 : select_4200;
  // hls/stages/patches.hpp:556
  logic [5:0] select_4203;
  assign select_4203 = equal_2408_s3_q ? (or_4027 ? 6'h0 : select_4201) : 6'h0;
  logic [5:0] select_4205;
  assign select_4205 = less_2405_s3_q ? (equal_2406_s3_q ? 6'h0 : select_4203) : select_4203;
  // hls/stages/patches.hpp:659
  logic [5:0] select_4207;
  assign select_4207 = and_4032 ? (equal_2242_s3_q ? select_4205 : 6'h0) : 6'h0;
  logic [11:0] sum_4208;
  assign sum_4208 = (patches_round_ends_q ? 12'h0 : patches_across_q) + {{6{select_4207[5]}}, select_4207};
  // hls/stages/agreement.hpp:789
  logic and_4212;
  assign and_4212 = equal_563_s3_q & (x_s3_q[6] & (not_2435_s3_q & (equal_3316 & less_4125)));
  // hls/stages/agreement.hpp:1143
  logic and_4216;
  assign and_4216 = x_s3_q[6] & (not_2435_s3_q & (less_4125 & (x_s3_q[5:3] == 3'h0)));
  // hls/stages/agreement.hpp:789
  logic and_4217;
  assign and_4217 = equal_563_s3_q & and_4216;
  // hls/stages/patches.hpp:643
  logic [7:0] select_4219;
  assign select_4219 = and_4212 ? (and_4217 ? patches_sum_places_q : patches_places_q) : patches_places_q;
  // hls/stages/patches.hpp:645
  logic or_4223;
  assign or_4223 = ({1'b0, patches_sum_places_q[7:1]} < patches_sum_up_q) | ({1'b0, patches_sum_places_q[7:1]} < patches_sum_down_q);
  // hls/stages/patches.hpp:646
  logic or_4226;
  assign or_4226 = ({1'b0, patches_clear_limit_q} < patches_sum_up_q) | ({1'b0, patches_clear_limit_q} < patches_sum_down_q);
  // hls/stages/patches.hpp:647
  logic [8:0] sum_4227;
  assign sum_4227 = {1'b0, patches_sum_places_q} + {3'h0, patches_sum_places_q[7:2]};
  // hls/stages/patches.hpp:642
  logic select_4229;
  assign select_4229 = and_4212 ? (and_4217 ? patches_enough_q : patches_complete_q) : patches_complete_q;
  // hls/stages/patches.hpp:188
  logic and_4232;
  assign and_4232 = patches_enough_q & patches_mostly_q;
  // hls/stages/patches.hpp:642
  logic [2:0] select_4234;
  assign select_4234 = and_4217 ? {and_4232, patches_found_q[2:1]} : (and_4212 ? {and_4232, patches_found_q[2:1]} : patches_found_q);
  // hls/stages/patches.hpp:641
  logic or_4238;
  assign or_4238 = patches_partly_q | (patches_doubted_q & (~and_4217));
  // hls/stages/patches.hpp:642
  logic select_4241;
  assign select_4241 = and_4212 ? (and_4217 ? or_4238 : (and_4212 ? or_4238 : patches_doubted_q)) : patches_doubted_q;
  // hls/stages/patches.hpp:640
  logic select_4242;
  assign select_4242 = patches_round_ends_q ? patches_doubted_q : patches_doubted_before_q;
  // hls/stages/patches.hpp:629
  logic [7:0] select_4246;
  assign select_4246 = patches_round_ends_q ? patches_on_skin_q : patches_round_on_skin_q;
  // hls/stages/patches.hpp:601
  logic [10:0] sum_4248;
  assign sum_4248 = {sum_4072[6], sum_4072, select_4003_s3_q[2:0]} + 11'h1;
  // hls/stages/patches.hpp:556
  logic and_4251;
  assign and_4251 = equal_2408_s3_q & (not_4028 & ({{5{sum_4248[10]}}, sum_4248} < 16'h3));
  // hls/stages/patches.hpp:184
  logic and_4254;
  assign and_4254 = equal_2242_s3_q & (less_2405_s3_q ? (not_2407_s3_q & and_4251) : and_4251);
  // hls/stages/patches.hpp:188
  logic and_4255;
  assign and_4255 = and_4032 & and_4254;
  // hls/stages/patches.hpp:660
  logic [7:0] sum_4256;
  assign sum_4256 = (patches_round_ends_q ? 8'h0 : patches_on_skin_q) + {7'h0, and_4255};
  // hls/stages/patches.hpp:650
  logic [12:0] product_4257;
  assign product_4257 = {8'h0, cfg_on_skin_limit_i} * {5'h0, select_4219};
  // hls/stages/patches.hpp:188
  logic and_4263;
  assign and_4263 = (~(patches_on_skin_q[7:2] == 6'h0)) & (patches_on_skin_most_q < patches_on_skin_q);
  logic select_4268;
  assign select_4268 = patches_round_ends_q ? (patches_large_q & (~patches_spoiled_q)) : patches_overlooked_q;
  // hls/stages/patches.hpp:630
  logic or_4272;
  assign or_4272 = cfg_alarm_before_i | (patches_spoiled_q & (~patches_round_ends_q));
  // hls/stages/patches.hpp:631
  logic found_2;
  assign found_2 = ~(patches_found_q == 3'h0);
  // hls/stages/patches.hpp:632
  logic select_4279;
  assign select_4279 = patches_round_ends_q ? (patches_twice_q | (patches_moved_q & (~patches_clear_q))) : patches_moved_q;
  // hls/stages/patches.hpp:633
  logic and_4285;
  assign and_4285 = patches_frame_ended_s3_q & (~patches_age_q[9]);
  logic [9:0] sum_4286;
  assign sum_4286 = patches_age_q + {9'h0, and_4285};
  logic [9:0] select_4289;
  assign select_4289 = patches_round_ends_q ? (patches_twice_q ? 10'h0 : (patches_clear_q ? 10'h0 : sum_4286)) : sum_4286;
  // hls/stages/agreement.hpp:1189
  logic or_4346;
  assign or_4346 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:1218
  logic equal_4348;
  assign equal_4348 = x_s3_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:1227
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:1228
  logic select_4354;
  assign select_4354 = (equal_4348 & equal_4124) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:1136
  logic [10:0] sum_4357;
  assign sum_4357 = {1'b0, select_3069} + {2'h0, select_3069[9:1]};
  logic select_4360;
  assign select_4360 = (select_3066[9:3] == 7'h0) ? ((~or_4346) & (~select_4354)) : (~({sum_4357, select_3069[0]} < {2'h0, select_3066}));
  // hls/stages/agreement.hpp:1143
  logic [47:0] select_4362;
  assign select_4362 = x_s3_q[6] ? (equal_2070_s3_q ? good_q : {select_4360, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:789
  logic select_4367;
  assign select_4367 = equal_563_s3_q ? ((x_s3_q[6] & good_known_q) | equal_4365_s3_q) : good_known_q;
  // hls/stages/agreement.hpp:1218
  logic equal_4368;
  assign equal_4368 = x_s3_q[6:3] == 4'ha;
  logic equal_4370;
  assign equal_4370 = x_s3_q[6:3] == 4'hc;
  logic equal_4371;
  assign equal_4371 = x_s3_q[6:3] == 4'hb;
  logic equal_4372;
  assign equal_4372 = x_s3_q[6:3] == 4'h9;
  logic equal_4373;
  assign equal_4373 = x_s3_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:1126
  logic [13:0] select_4375;
  assign select_4375 = equal_4372 ? counts_skin_unproven_q : (equal_4373 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] select_4377;
  assign select_4377 = equal_4371 ? counts_regions_bad_q : (equal_4368 ? counts_nearer_q : select_4375);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_4370 ? counts_on_skin_q : select_4377;
  // hls/stages/agreement.hpp:1223
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:1231
  logic select_4380;
  assign select_4380 = (equal_4368 & equal_4124) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:1149
  logic not_4381;
  assign not_4381 = ~hidden_for_q[7];
  logic [7:0] select_4383;
  assign select_4383 = select_4380 ? (hidden_for_q + {7'h0, not_4381}) : 8'h0;
  // hls/stages/agreement.hpp:789
  logic [7:0] select_4385;
  assign select_4385 = equal_563_s3_q ? (equal_4365_s3_q ? select_4383 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:1232
  logic [13:0] select_4386;
  assign select_4386 = equal_4124 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:1126
  logic [7:0] select_4388;
  assign select_4388 = (x_s3_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_4390;
  assign select_4390 = equal_4373 ? cfg_unproven_skin_limit_i : (equal_4348 ? cfg_unproven_limit_i : select_4388);
  logic [7:0] select_4392;
  assign select_4392 = equal_4368 ? cfg_regions_limit_i : (equal_4372 ? cfg_hidden_limit_i : select_4390);
  logic [7:0] limit;
  assign limit = equal_4370 ? cfg_regions_limit_i : (equal_4371 ? {cfg_on_skin_limit_i, 3'h0} : select_4392);
  // hls/stages/agreement.hpp:1232
  logic not_4395;
  assign not_4395 = ~x_s3_q[2];
  logic [3:0] select_4396;
  assign select_4396 = x_s3_q[1] ? {x_s3_q[2], 1'b0, not_4395, 1'b0} : {1'b0, x_s3_q[2], 1'b0, not_4395};
  logic [7:0] select_4397;
  assign select_4397 = x_s3_q[0] ? {select_4396[3], 1'b0, select_4396[2], 1'b0, select_4396[1], 1'b0, select_4396[0], 1'b0} : {1'b0, select_4396[3], 1'b0, select_4396[2], 1'b0, select_4396[1], 1'b0, select_4396[0]};
  // hls/stages/agreement.hpp:1126
  logic [13:0] select_4401;
  assign select_4401 = equal_4372 ? counts_skin_supervised_q : (equal_4373 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] select_4403;
  assign select_4403 = equal_4371 ? counts_skin_textured_q : (equal_4368 ? counts_textured_q : select_4401);
  logic [13:0] of;
  assign of = equal_4370 ? counts_textured_q : select_4403;
  // hls/stages/agreement.hpp:1232
  logic [13:0] select_4405;
  assign select_4405 = ((limit & select_4397) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_4;
  assign sum_4 = {1'b0, select_4386} + {1'b0, select_4405};
  // hls/stages/agreement.hpp:789
  logic select_4410;
  assign select_4410 = equal_563_s3_q ? (equal_4124 ? sum_4[0] : (product_rest_q | sum_4[0])) : product_rest_q;
  // hls/stages/agreement.hpp:1229
  logic and_4415;
  assign and_4415 = too_much_q & (~(equal_4373 & equal_4124));
  // hls/stages/agreement.hpp:1230
  logic select_4420;
  assign select_4420 = (over[14] & equal_4124) ? (and_4415 | ((equal_4373 | equal_4372) | (x_s3_q[6:3] == 4'hf))) : and_4415;
  // hls/stages/agreement.hpp:1126
  logic and_4425;
  assign and_4425 = over[14] & ({4'h0, cfg_on_skin_cells_i, 2'h0} < counts_on_skin_q);
  // hls/stages/agreement.hpp:1232
  logic select_4426;
  assign select_4426 = (equal_4370 & equal_4124) ? and_4425 : overlooks_q;
  // hls/stages/agreement.hpp:789
  logic [2:0] select_4428;
  assign select_4428 = ends_cell_s3_q ? textured_2_s3_q : box_textured_columns_values_0_q;
  logic [2:0] select_4430;
  assign select_4430 = equal_563_s3_q ? box_textured_columns_values_0_q : (drew_q ? select_4428 : box_textured_columns_values_0_q);
  logic [2:0] select_4431;
  assign select_4431 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_4433;
  assign select_4433 = equal_563_s3_q ? box_textured_columns_values_1_q : (drew_q ? select_4431 : box_textured_columns_values_1_q);
  logic [2:0] select_4434;
  assign select_4434 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_4436;
  assign select_4436 = equal_563_s3_q ? box_textured_columns_values_2_q : (drew_q ? select_4434 : box_textured_columns_values_2_q);
  logic [2:0] select_4437;
  assign select_4437 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_4439;
  assign select_4439 = equal_563_s3_q ? box_textured_columns_values_3_q : (drew_q ? select_4437 : box_textured_columns_values_3_q);
  logic [2:0] select_4440;
  assign select_4440 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_4442;
  assign select_4442 = equal_563_s3_q ? box_textured_columns_values_4_q : (drew_q ? select_4440 : box_textured_columns_values_4_q);
  logic [4:0] select_4444;
  assign select_4444 = drew_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_4446;
  assign select_4446 = ends_cell_s3_q ? explained_2_s3_q : box_explained_columns_values_0_q;
  logic [2:0] select_4448;
  assign select_4448 = equal_563_s3_q ? box_explained_columns_values_0_q : (drew_q ? select_4446 : box_explained_columns_values_0_q);
  logic [2:0] select_4449;
  assign select_4449 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_4451;
  assign select_4451 = equal_563_s3_q ? box_explained_columns_values_1_q : (drew_q ? select_4449 : box_explained_columns_values_1_q);
  logic [2:0] select_4452;
  assign select_4452 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_4454;
  assign select_4454 = equal_563_s3_q ? box_explained_columns_values_2_q : (drew_q ? select_4452 : box_explained_columns_values_2_q);
  logic [2:0] select_4455;
  assign select_4455 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_4457;
  assign select_4457 = equal_563_s3_q ? box_explained_columns_values_3_q : (drew_q ? select_4455 : box_explained_columns_values_3_q);
  logic [2:0] select_4458;
  assign select_4458 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_4460;
  assign select_4460 = equal_563_s3_q ? box_explained_columns_values_4_q : (drew_q ? select_4458 : box_explained_columns_values_4_q);
  logic [4:0] select_4462;
  assign select_4462 = drew_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [2:0] select_4465;
  assign select_4465 = drew_q ? (ends_cell_s3_q ? shown_2_s3_q : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_4467;
  assign select_4467 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_4469;
  assign select_4469 = equal_563_s3_q ? box_shown_columns_values_1_q : (drew_q ? select_4467 : box_shown_columns_values_1_q);
  logic [2:0] select_4470;
  assign select_4470 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_4472;
  assign select_4472 = equal_563_s3_q ? box_shown_columns_values_2_q : (drew_q ? select_4470 : box_shown_columns_values_2_q);
  logic [2:0] select_4473;
  assign select_4473 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_4475;
  assign select_4475 = equal_563_s3_q ? box_shown_columns_values_3_q : (drew_q ? select_4473 : box_shown_columns_values_3_q);
  logic [2:0] select_4476;
  assign select_4476 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_4478;
  assign select_4478 = equal_563_s3_q ? box_shown_columns_values_4_q : (drew_q ? select_4476 : box_shown_columns_values_4_q);
  logic [4:0] select_4480;
  assign select_4480 = drew_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_4483;
  assign select_4483 = drew_q ? (ends_cell_s3_q ? near_2_s3_q : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_4485;
  assign select_4485 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_4487;
  assign select_4487 = equal_563_s3_q ? box_nearer_columns_values_1_q : (drew_q ? select_4485 : box_nearer_columns_values_1_q);
  logic [2:0] select_4488;
  assign select_4488 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_4490;
  assign select_4490 = equal_563_s3_q ? box_nearer_columns_values_2_q : (drew_q ? select_4488 : box_nearer_columns_values_2_q);
  logic [2:0] select_4491;
  assign select_4491 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_4493;
  assign select_4493 = equal_563_s3_q ? box_nearer_columns_values_3_q : (drew_q ? select_4491 : box_nearer_columns_values_3_q);
  logic [2:0] select_4494;
  assign select_4494 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_4496;
  assign select_4496 = equal_563_s3_q ? box_nearer_columns_values_4_q : (drew_q ? select_4494 : box_nearer_columns_values_4_q);
  logic [4:0] select_4498;
  assign select_4498 = drew_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:1309
  logic [1:0] select_4543;
  assign select_4543 = and_4542_s3_q ? {and_2571, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1310
  logic and_4544;
  assign and_4544 = proven_q & less_4532;
  // hls/stages/agreement.hpp:438
  logic select_4547;
  assign select_4547 = and_2501_s3_q ? (less_2502_s3_q ? (select_4543[0] & and_4544) : seen_q) : seen_q;
  logic select_4550;
  assign select_4550 = and_2501_s3_q ? (less_2502_s3_q ? (select_4543[1] & and_4544) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:1240
  logic or_4557;
  assign or_4557 = (patches_age_q[9] & (~(cfg_patch_limit_i == 6'h3f))) | not_4556_s3_q;
  // hls/stages/agreement.hpp:1242
  logic not_4565;
  assign not_4565 = ~(or_4346 | not_2791);
  // hls/stages/agreement.hpp:789
  logic and_4569;
  assign and_4569 = equal_563_s3_q & (equal_4365_s3_q & (not_4565 & (select_4354 | select_4420)));
  logic and_4572;
  assign and_4572 = equal_4365_s3_q & (cfg_prove_i & (registration_moved_q | patches_moved_q));
  // hls/stages/agreement.hpp:1151
  logic or_4576;
  assign or_4576 = select_2889 | (select_2901 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:789
  logic and_4583;
  assign and_4583 = equal_563_s3_q & (equal_4365_s3_q & (not_4565 & (select_2895 | select_2907)));
  // hls/stages/agreement.hpp:1151
  logic and_4588;
  assign and_4588 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_4383 < cfg_hidden_frames_i));
  logic select_4594;
  assign select_4594 = (not_2791 | (select_4426 & not_4259)) ? cfg_prove_i : patches_overlooked_q;
  // hls/stages/agreement.hpp:789
  logic and_4599;
  assign and_4599 = equal_563_s3_q & (equal_4365_s3_q & (cfg_prove_i & moments_out_of_step_q));
  logic and_4603;
  assign and_4603 = equal_563_s3_q & (x_s3_q[6] & (not_2435_s3_q | (4'hc < x_s3_q[5:2])));
  // hls/stages/agreement.hpp:1141
  logic [31:0] select_4611;
  assign select_4611 = equal_2092_s3_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : (equal_4609_s3_q ? registration_sums_rdata_q : 32'h0);
  logic [31:0] select_4612;
  assign select_4612 = equal_2090_s3_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_4611;
  logic [31:0] select_4613;
  assign select_4613 = equal_2088_s3_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_4612;
  logic [31:0] select_4614;
  assign select_4614 = equal_2086_s3_q ? {8'h0, sharpness_sums_detail_0_q} : select_4613;
  logic [31:0] select_4615;
  assign select_4615 = equal_2084_s3_q ? {8'h0, sharpness_sums_detail_1_q} : select_4614;
  logic [31:0] select_4616;
  assign select_4616 = equal_2082_s3_q ? {8'h0, sharpness_sums_contrast_0_q} : select_4615;
  logic [31:0] select_4617;
  assign select_4617 = equal_2080_s3_q ? {8'h0, sharpness_sums_contrast_1_q} : select_4616;
  logic [31:0] select_4618;
  assign select_4618 = equal_2078_s3_q ? {1'b0, patches_round_on_skin_q, patches_round_moved_q, patches_round_across_q, patches_round_places_q} : select_4617;
  // hls/stages/agreement.hpp:1139
  logic [9:0] select_4619;
  assign select_4619 = less_3065 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:1143
  logic [31:0] select_4620;
  assign select_4620 = equal_2070_s3_q ? select_4618 : {2'h0, select_4619, select_3069, select_3066};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s3_q;
  logic fresh_we;
  assign fresh_we = s3_en & and_538_s3_q;
  logic [32:0] fresh_wdata;
  assign fresh_wdata = {less_735_s3_q, and_734, less_729_s3_q, and_728_s3_q, census_columns_values_1_cell_2_of_skin_s3_q, and_722, and_698_s3_q, and_697_s3_q, and_672_s3_q, less_664_s3_q, less_663_s3_q, less_662_s3_q, less_661_s3_q, less_660_s3_q, less_659_s3_q, less_658_s3_q, less_657_s3_q, less_656_s3_q, less_655_s3_q, less_654_s3_q, less_653_s3_q, less_652_s3_q, less_651_s3_q, less_650_s3_q, less_649_s3_q, less_648_s3_q, less_647_s3_q, less_646_s3_q, less_645_s3_q, less_644_s3_q, less_643_s3_q, less_642_s3_q, less_641_s3_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {^fresh_wdata, fresh_wdata};
  end
`ifndef SYNTHESIS
  logic [6:0] fresh_raddr_s1_sim;
  logic fresh_re_s1_sim;
  logic [6:0] fresh_raddr_s2_sim;
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
      if (fresh_waddr >= 7'd80) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd80) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_2076_s3_q, lower_half_s3_q, registration_of_right_s3_q};
  logic registration_sums_we;
  assign registration_sums_we = s3_en & and_2135_s3_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2134, sum_2130};
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
  assign patches_choices_waddr = {patches_choosing_band_s3_q, and_2164_s3_q};
  logic patches_choices_we;
  assign patches_choices_we = s3_en & and_2241_s3_q;
  logic [22:0] patches_choices_wdata;
  assign patches_choices_wdata = {patches_choice_slope_q, patches_choice_shift_q, patches_choice_column_q, select_2213_s3_q};
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
  assign patches_right_0_waddr = {select_2272_s3_q, select_2269};
  logic patches_right_0_we;
  assign patches_right_0_we = s3_en & (sample_pair_whole_s3_q & and_2281);
  logic [7:0] patches_right_0_wdata;
  assign patches_right_0_wdata = sample_pair_pixel_1_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_0_we) patches_right_0_mem[patches_right_0_waddr] <= {^patches_right_0_wdata, patches_right_0_wdata};
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
  assign patches_right_1_waddr = {select_2272_s3_q, select_2298};
  logic patches_right_1_we;
  assign patches_right_1_we = s3_en & (sample_pair_whole_s3_q & and_2301);
  logic [7:0] patches_right_1_wdata;
  assign patches_right_1_wdata = sample_pair_pixel_1_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_right_1_we) patches_right_1_mem[patches_right_1_waddr] <= {^patches_right_1_wdata, patches_right_1_wdata};
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
  assign patches_left_waddr = {select_2320, select_2319_s3_q, column_7};
  logic patches_left_we;
  assign patches_left_we = s3_en & (sample_pair_whole_s3_q & and_2326);
  logic [7:0] patches_left_wdata;
  assign patches_left_wdata = sample_pair_pixel_0_s3_q;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_left_we) patches_left_mem[patches_left_waddr] <= {^patches_left_wdata, patches_left_wdata};
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
  logic [14:0] patches_rows_wdata;
  assign patches_rows_wdata = select_2423;
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (patches_rows_we) patches_rows_mem[patches_rows_waddr] <= {^patches_rows_wdata, patches_rows_wdata};
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
  assign regions_waddr = {region_row_s3_q, or_2433_s3_q, or_2430_s3_q, or_2427_s3_q};
  logic regions_we;
  assign regions_we = s3_en & and_2467_s3_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2466, sum_2456, sum_2451};
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
  assign map_waddr = {sum_2507_s3_q, index_2_s3_q};
  logic map_we;
  assign map_we = s3_en & and_2581_s3_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2571, is_seen};
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
      patches_on_skin_most_q <= 8'h0;
      patches_large_q <= 1'b0;
      patches_overlooked_q <= 1'b0;
      patches_spoiled_q <= 1'b0;
      patches_suspected_q <= 1'b0;
      patches_moved_q <= 1'b0;
      patches_twice_q <= 1'b0;
      patches_clear_q <= 1'b0;
      patches_age_q <= 10'h200;
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
      overlooks_q <= 1'b0;
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s3_en) begin
      census_left_misses_q <= select_2730;
      sharpness_before_last_mask_q <= select_2803;
      sharpness_sums_detail_0_q <= and_538_s3_q ? select_2817 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_538_s3_q ? select_2829 : sharpness_sums_detail_1_q;
      sharpness_sums_contrast_0_q <= and_538_s3_q ? sum_2833 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_538_s3_q ? sum_2837 : sharpness_sums_contrast_1_q;
      sharpness_comparing_rest_0_q <= drew_q ? select_2855 : sharpness_comparing_rest_0_q;
      sharpness_comparing_rest_1_q <= drew_q ? select_2865 : sharpness_comparing_rest_1_q;
      sharpness_comparing_product_0_q <= drew_q ? select_2867 : sharpness_comparing_product_0_q;
      sharpness_comparing_product_1_q <= drew_q ? select_2869 : sharpness_comparing_product_1_q;
      sharpness_comparing_contrast_0_q <= drew_q ? select_2871 : sharpness_comparing_contrast_0_q;
      sharpness_comparing_contrast_1_q <= drew_q ? select_2873 : sharpness_comparing_contrast_1_q;
      sharpness_comparing_carry_0_q <= select_2878;
      sharpness_comparing_carry_1_q <= select_2882;
      sharpness_comparing_less_detail_0_q <= select_2889;
      sharpness_comparing_less_detail_1_q <= select_2895;
      sharpness_comparing_less_contrast_0_q <= select_2901;
      sharpness_comparing_less_contrast_1_q <= select_2907;
      counts_supervised_q <= select_3023;
      counts_textured_q <= and_3015_s3_q ? 14'h0 : (counts_textured_q + {13'h0, and_3026});
      counts_explained_q <= and_3015_s3_q ? 14'h0 : (counts_explained_q + {13'h0, and_3031});
      counts_nearer_q <= and_3015_s3_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3036});
      counts_unproven_q <= and_3015_s3_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3062});
      counts_regions_bad_q <= select_3078;
      counts_skin_supervised_q <= select_3085;
      counts_skin_textured_q <= select_3092;
      counts_skin_unproven_q <= select_3100;
      counts_on_skin_q <= select_3119;
      registration_half_across_q <= select_3197;
      registration_half_measured_q <= select_3202;
      registration_half_votes_down_q <= and_3175_s3_q ? 7'h0 : sum_3208;
      registration_half_votes_up_q <= and_3175_s3_q ? 7'h0 : sum_3216;
      registration_half_half_votes_down_q <= and_3175_s3_q ? 7'h0 : sum_3223;
      registration_half_half_votes_up_q <= and_3175_s3_q ? 7'h0 : sum_3230;
      registration_down_q <= and_3264 ? sum_3283 : registration_down_q;
      registration_up_q <= and_3264 ? sum_3292 : registration_up_q;
      registration_enough_q <= select_3306;
      registration_votes_down_q <= and_3311 ? less_3312 : registration_votes_down_q;
      registration_votes_up_q <= and_3311 ? less_3314 : registration_votes_up_q;
      registration_other_enough_q <= and_3320 ? select_3306 : registration_other_enough_q;
      registration_other_down_q <= and_3320 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3320 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_563_s3_q & and_3327)) & or_3352;
      patches_place_0_valid_q <= sample_pair_whole_s3_q ? select_2260 : patches_place_0_valid_q;
      patches_place_0_column_q <= sample_pair_whole_s3_q ? select_2262 : patches_place_0_column_q;
      patches_place_0_shift_q <= sample_pair_whole_s3_q ? select_2263 : patches_place_0_shift_q;
      patches_place_0_slope_q <= select_3437;
      patches_place_1_valid_q <= sample_pair_whole_s3_q ? select_2289 : patches_place_1_valid_q;
      patches_place_1_column_q <= sample_pair_whole_s3_q ? select_2291 : patches_place_1_column_q;
      patches_place_1_shift_q <= sample_pair_whole_s3_q ? select_2292 : patches_place_1_shift_q;
      patches_place_1_slope_q <= select_3442;
      patches_valid_0_q <= select_3447;
      patches_valid_1_q <= select_3452;
      patches_right_next_0_q <= select_3455;
      patches_right_next_1_q <= select_3458;
      patches_left_next_0_q <= select_3461;
      patches_left_next_1_q <= select_3464;
      patches_sums_values_0_q <= select_3888;
      patches_sums_values_1_q <= equal_2242_s3_q ? patches_sums_values_1_q : select_3889;
      patches_sums_values_2_q <= equal_2242_s3_q ? patches_sums_values_2_q : select_3891;
      patches_sums_values_3_q <= equal_2242_s3_q ? patches_sums_values_3_q : select_3893;
      patches_sums_values_4_q <= equal_2242_s3_q ? patches_sums_values_4_q : select_3895;
      patches_sums_values_5_q <= equal_2242_s3_q ? patches_sums_values_5_q : select_3897;
      patches_sums_values_6_q <= equal_2242_s3_q ? patches_sums_values_6_q : select_3899;
      patches_sums_values_7_q <= equal_2242_s3_q ? patches_sums_values_7_q : select_3901;
      patches_sums_values_8_q <= equal_2242_s3_q ? patches_sums_values_8_q : select_3903;
      patches_sums_values_9_q <= equal_2242_s3_q ? patches_sums_values_9_q : select_3905;
      patches_sums_values_10_q <= equal_2242_s3_q ? patches_sums_values_10_q : select_3907;
      patches_sums_values_11_q <= equal_2242_s3_q ? patches_sums_values_11_q : select_3909;
      patches_sums_values_12_q <= equal_2242_s3_q ? patches_sums_values_12_q : select_3911;
      patches_sums_values_13_q <= equal_2242_s3_q ? patches_sums_values_13_q : select_3913;
      patches_sums_values_14_q <= equal_2242_s3_q ? patches_sums_values_14_q : select_3915;
      patches_sums_values_15_q <= equal_2242_s3_q ? patches_sums_values_15_q : select_3917;
      patches_sums_values_16_q <= equal_2242_s3_q ? patches_sums_values_16_q : select_3919;
      patches_best_differing_q <= select_2423[9:0];
      patches_best_column_q <= select_2423[14:10];
      patches_quarters_0_places_q <= sum_4043;
      patches_quarters_0_up_q <= sum_4083;
      patches_quarters_0_down_q <= sum_4093;
      patches_quarters_1_places_q <= sum_4097;
      patches_quarters_1_up_q <= sum_4100;
      patches_quarters_1_down_q <= sum_4103;
      patches_quarters_2_places_q <= sum_4107;
      patches_quarters_2_up_q <= sum_4110;
      patches_quarters_2_down_q <= sum_4113;
      patches_quarters_3_places_q <= sum_4117;
      patches_quarters_3_up_q <= sum_4120;
      patches_quarters_3_down_q <= sum_4123;
      patches_word_places_q <= or_4151;
      patches_word_up_q <= ((select_4161 | select_4163) | select_4166) | select_4169;
      patches_word_down_q <= ((select_4172 | select_4174) | select_4177) | select_4180;
      patches_sum_places_q <= select_4190;
      patches_sum_up_q <= select_4193;
      patches_sum_down_q <= select_4196;
      patches_across_q <= sum_4208;
      patches_places_q <= select_4219;
      patches_enough_q <= 5'h2 < patches_sum_places_q[7:3];
      patches_mostly_q <= or_4223;
      patches_partly_q <= or_4226;
      patches_clear_limit_q <= sum_4227[8:2];
      patches_complete_q <= select_4229;
      patches_round_ends_q <= patches_complete_q & patches_frame_ended_q;
      patches_found_q <= and_4212 ? select_4234 : patches_found_q;
      patches_doubted_q <= select_4241;
      patches_doubted_before_q <= select_4242;
      patches_round_places_q <= patches_round_ends_q ? patches_places_q : patches_round_places_q;
      patches_round_across_q <= patches_round_ends_q ? patches_across_q : patches_round_across_q;
      patches_round_moved_q <= patches_round_ends_q ? patches_found_q : patches_round_moved_q;
      patches_round_on_skin_q <= select_4246;
      patches_on_skin_q <= sum_4256;
      patches_on_skin_most_q <= product_4257[12:5];
      patches_large_q <= not_4259 & and_4263;
      patches_overlooked_q <= (~cfg_alarm_before_i) & select_4268;
      patches_spoiled_q <= or_4272;
      patches_suspected_q <= patches_round_ends_q ? found_2 : patches_suspected_q;
      patches_moved_q <= select_4279;
      patches_twice_q <= patches_suspected_q & found_2;
      patches_clear_q <= (~patches_doubted_q) & (~patches_doubted_before_q);
      patches_age_q <= select_4289;
      segment_textured_q <= select_2448 + {6'h0, and_3026};
      segment_explained_q <= select_2453 + {6'h0, and_3031};
      segment_nearer_q <= select_2463 + {6'h0, and_3036};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_563_s3_q ? select_4362 : good_q;
      good_known_q <= select_4367;
      hidden_for_q <= select_4385;
      product_q <= equal_563_s3_q ? sum_4[14:1] : product_q;
      product_rest_q <= select_4410;
      disagree_q <= equal_563_s3_q ? select_4354 : disagree_q;
      too_much_q <= equal_563_s3_q ? select_4420 : too_much_q;
      hides_q <= equal_563_s3_q ? select_4380 : hides_q;
      overlooks_q <= equal_563_s3_q ? select_4426 : overlooks_q;
      seen_q <= select_4547;
      nearer_q <= select_4550;
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
      left_pixel_q <= left_pixel_q;
      averager_quarter_1_0_q <= select_2605;
      averager_quarter_1_1_q <= select_2607;
      averager_quarter_2_0_q <= select_2609;
      averager_quarter_2_1_q <= select_2611;
      averager_detail_0_q <= select_2623;
      averager_detail_1_q <= select_2631;
      census_changes_values_0_left_q <= and_538_s3_q ? texture : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_538_s3_q ? sum_2714 : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2716;
      census_changes_values_1_right_q <= select_2717;
      census_changes_values_2_left_q <= select_2718;
      census_changes_values_2_right_q <= select_2719;
      sharpness_last_mask_q <= and_538_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_detail_0_q <= and_538_s3_q ? select_2800[13:0] : sharpness_last_detail_0_q;
      sharpness_last_detail_1_q <= and_538_s3_q ? select_2800[27:14] : sharpness_last_detail_1_q;
      box_textured_columns_values_0_q <= select_4430;
      box_textured_columns_values_1_q <= select_4433;
      box_textured_columns_values_2_q <= select_4436;
      box_textured_columns_values_3_q <= select_4439;
      box_textured_columns_values_4_q <= select_4442;
      box_textured_sum_sums_values_0_q <= equal_563_s3_q ? box_textured_sum_sums_values_0_q : select_4444;
      box_explained_columns_values_0_q <= select_4448;
      box_explained_columns_values_1_q <= select_4451;
      box_explained_columns_values_2_q <= select_4454;
      box_explained_columns_values_3_q <= select_4457;
      box_explained_columns_values_4_q <= select_4460;
      box_explained_sum_sums_values_0_q <= equal_563_s3_q ? box_explained_sum_sums_values_0_q : select_4462;
      box_shown_columns_values_0_q <= equal_563_s3_q ? box_shown_columns_values_0_q : select_4465;
      box_shown_columns_values_1_q <= select_4469;
      box_shown_columns_values_2_q <= select_4472;
      box_shown_columns_values_3_q <= select_4475;
      box_shown_columns_values_4_q <= select_4478;
      box_shown_sum_sums_values_0_q <= equal_563_s3_q ? box_shown_sum_sums_values_0_q : select_4480;
      box_nearer_columns_values_0_q <= equal_563_s3_q ? box_nearer_columns_values_0_q : select_4483;
      box_nearer_columns_values_1_q <= select_4487;
      box_nearer_columns_values_2_q <= select_4490;
      box_nearer_columns_values_3_q <= select_4493;
      box_nearer_columns_values_4_q <= select_4496;
      box_nearer_sum_sums_values_0_q <= equal_563_s3_q ? box_nearer_sum_sums_values_0_q : select_4498;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic marks_last_s4_q;
  logic and_4527_s4_q;
  logic or_4551_s4_q;
  logic and_4552_s4_q;
  logic and_4560_s4_q;
  logic and_4563_s4_q;
  logic and_4569_s4_q;
  logic and_4573_s4_q;
  logic and_4579_s4_q;
  logic and_4583_s4_q;
  logic and_4591_s4_q;
  logic and_4596_s4_q;
  logic and_4599_s4_q;
  logic and_4603_s4_q;
  logic [5:0] select_4605_s4_q;
  logic [31:0] select_4622_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= sample_of_skin_q;
      marks_first_s4_q <= marks_first_s3_q;
      marks_last_s4_q <= line_ended_q;
      and_4527_s4_q <= said_q;
      or_4551_s4_q <= not_2791 | select_4547;
      and_4552_s4_q <= cfg_prove_i & select_4550;
      and_4560_s4_q <= equal_563_s3_q & (equal_4365_s3_q & (cfg_prove_i & or_4557));
      and_4563_s4_q <= equal_563_s3_q & (equal_4365_s3_q & (cfg_prove_i & or_4346));
      and_4569_s4_q <= and_4569;
      and_4573_s4_q <= equal_563_s3_q & and_4572;
      and_4579_s4_q <= equal_563_s3_q & (equal_4365_s3_q & (not_4565 & or_4576));
      and_4583_s4_q <= and_4583;
      and_4591_s4_q <= equal_563_s3_q & (equal_4365_s3_q & (cfg_prove_i & and_4588));
      and_4596_s4_q <= equal_563_s3_q & (equal_4365_s3_q & select_4594);
      and_4599_s4_q <= and_4599;
      and_4603_s4_q <= and_4603;
      select_4605_s4_q <= equal_563_s3_q ? (x_s3_q[6] ? x_s3_q[5:0] : 6'h0) : 6'h0;
      select_4622_s4_q <= equal_563_s3_q ? (x_s3_q[6] ? select_4620 : 32'h0) : 32'h0;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (averager_memory_error | census_memory_error | moments_memory_error | fresh_error | left_error | right_codes_error | best_left_error | best_right_error | shown_right_error | left_turns_error | right_turns_error | registration_sums_error | patches_choices_error | patches_right_0_error | patches_right_1_error | patches_left_error | patches_columns_above_error | patches_right_codes_error | patches_left_codes_error | patches_rows_error | regions_error | seen_columns_error | map_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s4_q;
  assign pixel_1_o = pixel_1_s4_q;
  assign saturated_o = saturated_s4_q;
  assign mask_o = mask_s4_q;
  assign marks_first_o = marks_first_s4_q;
  assign marks_last_o = marks_last_s4_q;
  assign marks_seen_o = or_4551_s4_q;
  assign marks_nearer_o = and_4552_s4_q;
  assign verdict_valid_o = and_4527_s4_q;
  assign verdict_unproven_yet_o = and_4560_s4_q;
  assign verdict_untextured_o = and_4563_s4_q;
  assign verdict_disagree_o = and_4569_s4_q;
  assign verdict_moved_o = and_4573_s4_q;
  assign verdict_unsharp_left_o = and_4579_s4_q;
  assign verdict_unsharp_right_o = and_4583_s4_q;
  assign verdict_hidden_o = and_4591_s4_q;
  assign verdict_overlooked_o = and_4596_s4_q;
  assign verdict_out_of_step_o = and_4599_s4_q;
  assign frame_valid_o = and_4603_s4_q;
  assign frame_index_o = select_4605_s4_q;
  assign frame_word_o = select_4622_s4_q;
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
  assign unused_bits = ^{over[13:0], product_4257[4:0], sum_4227[1:0], sum_4182[1:0], product_4073[4:0], sum_3165[0], difference_3106[1:0], detail_4[1:0], detail_3[1:0], sum_2724[4:0], sum_2180[0], sum_2176[0], sum_720[4:0], cfg_width_i[2:0]};

endmodule
