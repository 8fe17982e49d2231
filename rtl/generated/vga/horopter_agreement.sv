// SPDX-License-Identifier: Apache-2.0
// Made by hlsc from horopter::stages::Agreement<horopter::hls::profiles::vga>, hls/stages/agreement.hpp. Do not edit.
//
// Latency 5 enabled clocks, one beat a clock. en_i = 0: nothing changes. A pipeline stage
// loads its registers only for a valid beat. rst_ni is synchronous and keeps memories.
// State 2075 bits, pipeline 1003 bits, memories 70220 bits.
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
  output logic frame_valid_o,
  output logic [5:0] frame_index_o,
  output logic [31:0] frame_word_o
);

  // A beat is in stage k, k enabled clocks after it entered.
  logic valid_s1_q, valid_s2_q, valid_s3_q, valid_s4_q, valid_s5_q;
  logic s0_en, s1_en, s2_en, s3_en, s4_en;
  assign s0_en = en_i & valid_i;
  assign s1_en = en_i & valid_s1_q;
  assign s2_en = en_i & valid_s2_q;
  assign s3_en = en_i & valid_s3_q;
  assign s4_en = en_i & valid_s4_q;

  // Of the configuration alone: not pipelined.
  logic [7:0] last;
  assign last = {1'b0, cfg_width_i[9:3]} + 8'hff;
  logic [5:0] sum_3052;
  assign sum_3052 = {1'b0, cfg_height_i[8:4]} + 6'h5;
  logic [6:0] difference_3311;
  assign difference_3311 = 7'h0 - {1'b0, cfg_height_i[8:3]};
  logic less_3512;
  assign less_3512 = 6'h8 < cfg_height_i[8:3];
  logic [4:0] sum_3513;
  assign sum_3513 = {2'h0, cfg_height_i[8:6]} + 5'h1f;
  logic not_3531;
  assign not_3531 = ~cfg_prove_i;

  // Stage 0 -----------------------------------------------------------------------------------------------------------
  logic sample_pair_first_q;
  logic sample_pair_whole_q;
  logic sample_last_q;
  logic sample_present_q;
  logic sample_of_skin_q;
  logic [2:0] raster_at_x_q;
  logic [2:0] raster_at_y_q;
  logic [6:0] raster_at_column_q;
  logic [5:0] raster_at_row_q;
  logic raster_at_first_q;
  logic raster_at_live_q;
  logic [8:0] raster_rows_left_q;
  logic raster_row_ended_q;
  logic raster_final_row_q;
  logic [8:0] averager_place_q;
  logic [4:0] rows_passed_above_q;
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
  logic [5:0] row_q;
  logic [6:0] least_q;
  logic [7:0] whole_q;
  logic [7:0] drawn_q;
  logic [6:0] age_q;
  logic [2:0] slot_q;
  logic ends_cell_q;
  logic ends_q;
  logic final_row_q;
  logic lower_half_q;
  // hls/stages/census.hpp:35
  logic [2:0] select_370;
  assign select_370 = sample_pair_first_q ? 3'h0 : (raster_row_ended_q ? 3'h0 : raster_at_x_q);
  logic [6:0] select_372;
  assign select_372 = sample_pair_first_q ? 7'h0 : (raster_row_ended_q ? 7'h0 : raster_at_column_q);
  // hls/stages/census.hpp:94
  logic [8:0] select_375;
  assign select_375 = ({select_372, select_370} == 10'h0) ? 9'h0 : (averager_place_q + 9'h1);
  // hls/stages/census.hpp:95
  logic [8:0] select_376;
  assign select_376 = select_370[0] ? averager_place_q : select_375;
  // hls/stages/census.hpp:40
  logic or_377;
  assign or_377 = sample_pair_first_q | raster_at_live_q;
  // hls/stages/agreement.hpp:213
  logic and_383;
  assign and_383 = (~((~or_377) | (~select_370[0]))) & (select_376[8:6] < 3'h5);
  // hls/stages/census.hpp:40
  logic [2:0] select_388;
  assign select_388 = sample_pair_first_q ? 3'h0 : raster_at_y_q;
  // hls/stages/agreement.hpp:215
  logic [6:0] column;
  assign column = sample_pair_whole_q ? select_372 : 7'h0;
  // hls/stages/census.hpp:45
  logic equal_405;
  assign equal_405 = select_370 == 3'h7;
  // hls/stages/census.hpp:48
  logic equal_406;
  assign equal_406 = select_388 == 3'h7;
  // hls/stages/census.hpp:105
  logic and_407;
  assign and_407 = equal_406 & and_383;
  // hls/stages/agreement.hpp:215
  logic and_409;
  assign and_409 = sample_pair_whole_q & (equal_405 & and_407);
  // hls/stages/agreement.hpp:134
  logic so;
  assign so = run_phase_q == 3'h6;
  // hls/stages/agreement.hpp:406
  logic equal_429;
  assign equal_429 = run_phase_q == 3'h5;
  // hls/stages/agreement.hpp:391
  logic or_430;
  assign or_430 = so | equal_429;
  logic not_431;
  assign not_431 = ~or_430;
  // hls/stages/agreement.hpp:397
  logic equal_432;
  assign equal_432 = run_phase_q == 3'h3;
  // hls/stages/agreement.hpp:398
  logic equal_434;
  assign equal_434 = run_phase_q == 3'h2;
  // hls/stages/agreement.hpp:389
  logic [7:0] sum_435;
  assign sum_435 = {{2{run_shift_q[5]}}, run_shift_q} + x_q;
  // hls/stages/agreement.hpp:391
  logic [7:0] select_436;
  assign select_436 = run_shift_q[5] ? x_q : sum_435;
  logic less_437;
  assign less_437 = {1'b0, last_q} < select_436;
  // hls/stages/agreement.hpp:163
  logic not_438;
  assign not_438 = ~less_437;
  // hls/stages/agreement.hpp:554
  logic and_439;
  assign and_439 = equal_434 & not_438;
  logic and_441;
  assign and_441 = not_431 & ((~equal_432) & and_439);
  // hls/stages/agreement.hpp:309
  logic equal_467;
  assign equal_467 = column == 7'h0;
  // hls/stages/census.hpp:40
  logic [5:0] select_468;
  assign select_468 = sample_pair_first_q ? 6'h0 : raster_at_row_q;
  // hls/stages/agreement.hpp:215
  logic [5:0] row;
  assign row = sample_pair_whole_q ? select_468 : 6'h0;
  // hls/stages/agreement.hpp:309
  logic equal_470;
  assign equal_470 = row == 6'h0;
  logic [3:0] select_471;
  assign select_471 = equal_470 ? 4'h0 : rows_passed_above_q[3:0];
  // hls/stages/agreement.hpp:310
  logic [4:0] select_472;
  assign select_472 = equal_467 ? {select_471, 1'b1} : rows_passed_above_q;
  // hls/stages/agreement.hpp:554
  logic select_525;
  assign select_525 = equal_432 ? not_438 : and_439;
  // hls/stages/agreement.hpp:597
  logic [7:0] x;
  assign x = x_q + 8'hfd;
  // hls/stages/agreement.hpp:191
  logic and_549;
  assign and_549 = age_q[2] & (ends_cell_q & (~(({1'b0, last_q} + 8'h3) < select_436)));
  logic and_550;
  assign and_550 = equal_432 & and_549;
  logic select_551;
  assign select_551 = or_430 ? not_438 : and_550;
  // hls/stages/agreement.hpp:602
  logic equal_554;
  assign equal_554 = {{2{run_shift_q[5]}}, run_shift_q} == (8'h0 - {1'b0, least_q});
  // hls/stages/agreement.hpp:606
  logic or_556;
  assign or_556 = equal_554 | ($signed(6'h0) < $signed(run_shift_q));
  // hls/stages/agreement.hpp:618
  logic [6:0] right;
  assign right = sum_435[6:0] + 7'h7d;
  // hls/stages/registration.hpp:106
  logic [1:0] sum_1900;
  assign sum_1900 = slot_q[1:0] + 2'h3;
  // hls/stages/agreement.hpp:747
  logic [5:0] sum_1931;
  assign sum_1931 = {1'b0, last_q[6:2]} + 6'h1;
  // hls/stages/registration.hpp:249
  logic equal_1948;
  assign equal_1948 = sum_1900 == 2'h0;
  // hls/stages/registration.hpp:248
  logic not_1953;
  assign not_1953 = ~sum_1900[0];
  // hls/stages/registration.hpp:250
  logic [8:0] select_1955;
  assign select_1955 = equal_1948 ? 9'h18c : ({7'h63, not_1953, 1'b1} + 9'h1);
  // hls/stages/agreement.hpp:135
  logic and_1985;
  assign and_1985 = ends_cell_q & so;
  // hls/stages/registration.hpp:250
  logic select_2204;
  assign select_2204 = select_1955[1] ? (final_row_q & select_1955[0]) : (and_1985 & (~select_1955[0]));
  logic select_2205;
  assign select_2205 = select_1955[0] ? so : ends_q;
  logic [2:0] select_2207;
  assign select_2207 = select_1955[1] ? {2'h0, select_2205} : (select_1955[0] ? {2'h0, ends_cell_q} : slot_q);
  logic [2:0] select_2208;
  assign select_2208 = select_1955[2] ? {2'h0, select_2204} : select_2207;
  logic [7:0] select_2211;
  assign select_2211 = select_1955[1] ? (select_1955[0] ? {age_q, 1'b1} : drawn_q) : (select_1955[0] ? whole_q : {1'b0, least_q});
  logic [6:0] select_2212;
  assign select_2212 = select_1955[0] ? {1'b0, row_q} : last_q;
  logic [7:0] select_2214;
  assign select_2214 = select_1955[1] ? {1'b0, select_2212} : (select_1955[0] ? columns_left_q : x_q);
  logic [7:0] select_2216;
  assign select_2216 = select_1955[3] ? {5'h0, select_2208} : (select_1955[2] ? select_2211 : select_2214);
  // hls/stages/agreement.hpp:421
  logic [7:0] select_2220;
  assign select_2220 = (plan_span_q < 8'h9) ? 8'hc : (plan_span_q + 8'h3);
  // hls/stages/agreement.hpp:423
  logic not_2221;
  assign not_2221 = ~run_shift_q[5];
  logic [7:0] select_2224;
  assign select_2224 = equal_432 ? ({{7{not_2221}}, 1'b1} + run_span_q) : ({1'b0, last_q} - {1'b0, least_q});
  // hls/stages/agreement.hpp:422
  logic [5:0] select_2228;
  assign select_2228 = equal_432 ? (run_shift_q + 6'h1) : (6'h0 - least_q[5:0]);
  // hls/stages/agreement.hpp:399
  logic select_2230;
  assign select_2230 = equal_432 ? (~run_last_shift_q) : equal_434;
  // hls/stages/agreement.hpp:403
  logic equal_2232;
  assign equal_2232 = run_phase_q == 3'h1;
  // hls/stages/agreement.hpp:406
  logic equal_2233;
  assign equal_2233 = run_phase_q == 3'h4;
  // hls/stages/agreement.hpp:416
  logic [7:0] or_2236;
  assign or_2236 = (select_2230 ? plan_columns_q : 8'h0) | ((equal_2232 | equal_2233) ? whole_q : 8'h0);
  // hls/stages/agreement.hpp:146
  logic and_2237;
  assign and_2237 = run_last_shift_q & equal_432;
  // hls/stages/agreement.hpp:416
  logic [1:0] or_2238;
  assign or_2238 = {2{and_2237}} | or_2236[3:2];
  // hls/stages/agreement.hpp:417
  logic [7:0] or_2240;
  assign or_2240 = {or_2236[7:4], or_2238, or_2236[1:0]} | (equal_429 ? drawn_q : 8'h0);
  logic [4:0] or_2241;
  assign or_2241 = {5{so}} | {or_2240[6], or_2240[3:0]};
  // hls/stages/registration.hpp:250
  logic [7:0] select_2242;
  assign select_2242 = select_1955[0] ? {{2{select_2228[5]}}, select_2228} : {or_2240[7], or_2241[4], or_2240[5:4], or_2241[3:0]};
  logic [7:0] select_2243;
  assign select_2243 = select_1955[1] ? (select_1955[0] ? select_2220 : select_2224) : select_2242;
  // hls/stages/agreement.hpp:413
  logic [6:0] value_2;
  assign value_2 = 7'h0 - {plan_shift_q[5], plan_shift_q};
  logic [6:0] select_2246;
  assign select_2246 = (plan_shift_q[5] & select_2230) ? value_2 : 7'h0;
  logic [1:0] or_2247;
  assign or_2247 = {2{so}} | select_2246[5:4];
  // hls/stages/registration.hpp:250
  logic [7:0] select_2248;
  assign select_2248 = select_1955[0] ? {{2{select_2246[6]}}, or_2247, select_2246[3:0]} : plan_span_q;
  // hls/stages/agreement.hpp:146
  logic and_2250;
  assign and_2250 = select_2230 & ({{2{plan_shift_q[5]}}, plan_shift_q} == {1'b0, least_q});
  // hls/stages/agreement.hpp:410
  logic [5:0] select_2251;
  assign select_2251 = select_2230 ? plan_shift_q : 6'h0;
  // hls/stages/registration.hpp:250
  logic [5:0] select_2252;
  assign select_2252 = select_1955[0] ? {5'h0, and_2250} : select_2251;
  logic [7:0] select_2253;
  assign select_2253 = select_1955[1] ? select_2248 : {{2{select_2252[5]}}, select_2252};
  // hls/stages/agreement.hpp:403
  logic not_2257;
  assign not_2257 = ~select_2230;
  // hls/stages/agreement.hpp:146
  logic and_2259;
  assign and_2259 = final_row_q & so;
  // hls/stages/agreement.hpp:403
  logic [1:0] select_2260;
  assign select_2260 = equal_2233 ? 2'h1 : {2{and_2259}};
  logic [2:0] select_2262;
  assign select_2262 = (and_2237 | (select_2230 | equal_2232)) ? (equal_2232 ? 3'h2 : {not_2257, {2{select_2230}}}) : (equal_429 ? 3'h6 : {select_2260[0], select_2260});
  // hls/stages/registration.hpp:250
  logic [2:0] select_2263;
  assign select_2263 = select_1955[0] ? select_2262 : 3'h0;
  logic [7:0] select_2265;
  assign select_2265 = select_1955[1] ? {5'h0, select_2263} : (select_1955[0] ? 8'h0 : run_span_q);
  logic [4:0] select_2267;
  assign select_2267 = select_1955[0] ? {2'h0, run_phase_q} : rows_passed_above_q;
  logic [5:0] select_2268;
  assign select_2268 = select_1955[1] ? (select_1955[0] ? {5'h0, run_last_shift_q} : run_shift_q) : {1'b0, select_2267};
  logic [7:0] select_2269;
  assign select_2269 = select_1955[2] ? select_2265 : {{2{select_2268[5]}}, select_2268};
  logic [7:0] select_2270;
  assign select_2270 = select_1955[3] ? (select_1955[2] ? select_2243 : select_2253) : select_2269;
  logic [7:0] select_2559;
  assign select_2559 = select_1955[0] ? {7'h0, averager_place_q[8]} : averager_place_q[7:0];
  logic select_2580;
  assign select_2580 = select_1955[0] ? raster_final_row_q : raster_row_ended_q;
  logic [7:0] select_2581;
  assign select_2581 = select_1955[0] ? {7'h0, raster_rows_left_q[8]} : raster_rows_left_q[7:0];
  logic select_2585;
  assign select_2585 = select_1955[0] ? raster_at_live_q : raster_at_first_q;
  logic [6:0] select_2587;
  assign select_2587 = select_1955[1] ? {6'h0, select_2585} : (select_1955[0] ? {1'b0, raster_at_row_q} : raster_at_column_q);
  logic select_2589;
  assign select_2589 = select_1955[0] ? sample_of_skin_q : sample_present_q;
  logic [2:0] select_2590;
  assign select_2590 = select_1955[1] ? (select_1955[0] ? raster_at_y_q : raster_at_x_q) : {2'h0, select_2589};
  // hls/stages/agreement.hpp:211
  logic and_2755;
  assign and_2755 = ((6'h6 < row_q) & (~(x_q[7:2] == 6'h0))) & (~({sum_1931, last_q[1:0]} < x_q));
  // hls/stages/agreement.hpp:215
  logic [2:0] select_2763;
  assign select_2763 = sample_pair_whole_q ? (sample_last_q ? (select_388 + 3'h1) : select_388) : raster_at_y_q;
  logic [6:0] select_2765;
  assign select_2765 = sample_pair_whole_q ? (select_372 + {6'h0, equal_405}) : raster_at_column_q;
  logic [5:0] select_2768;
  assign select_2768 = sample_pair_whole_q ? (sample_last_q ? (select_468 + {5'h0, equal_406}) : select_468) : raster_at_row_q;
  logic select_2773;
  assign select_2773 = sample_pair_whole_q ? (sample_last_q ? (or_377 & (~raster_final_row_q)) : or_377) : raster_at_live_q;
  // hls/stages/census.hpp:44
  logic [8:0] select_2775;
  assign select_2775 = sample_pair_first_q ? cfg_height_i : (raster_rows_left_q - {8'h0, sample_last_q});
  // hls/stages/agreement.hpp:215
  logic select_2779;
  assign select_2779 = sample_pair_whole_q ? (raster_rows_left_q == 9'h1) : raster_final_row_q;
  // hls/stages/agreement.hpp:310
  logic [5:0] or_2944;
  assign or_2944 = column[5:0] | row;
  // hls/stages/agreement.hpp:313
  logic equal_2999;
  assign equal_2999 = {last[7], column} == {1'b0, last[6:0]};
  // hls/stages/agreement.hpp:318
  logic and_3000;
  assign and_3000 = and_409 & equal_2999;
  // hls/stages/agreement.hpp:368
  logic select_3003;
  assign select_3003 = (and_3000 | (~ends_cell_q)) ? and_3000 : ends_q;
  // hls/stages/agreement.hpp:374
  logic [2:0] now;
  assign now = select_3003 ? (and_3000 ? 3'h1 : following_phase_q) : run_phase_q;
  // hls/stages/agreement.hpp:379
  logic [5:0] select_3007;
  assign select_3007 = select_3003 ? (and_3000 ? 6'h0 : following_shift_q) : run_shift_q;
  logic select_3010;
  assign select_3010 = select_3003 ? (following_last_shift_q & (~and_3000)) : run_last_shift_q;
  // hls/stages/agreement.hpp:368
  logic [6:0] select_3013;
  assign select_3013 = and_3000 ? 7'h0 : following_lowest_q;
  // hls/stages/agreement.hpp:371
  logic [7:0] select_3015;
  assign select_3015 = select_3003 ? {select_3013[6], select_3013} : (x_q + {7'h0, ends_cell_q});
  logic [7:0] select_3018;
  assign select_3018 = select_3003 ? (and_3000 ? 8'hc : following_columns_q) : (columns_left_q - {7'h0, ends_cell_q});
  // hls/stages/agreement.hpp:365
  logic [6:0] select_3026;
  assign select_3026 = and_409 ? (equal_2999 ? ((6'he < column[6:1]) ? 7'h1d : column) : least_q) : least_q;
  logic [7:0] select_3029;
  assign select_3029 = and_409 ? (equal_2999 ? ({1'b0, cfg_width_i[9:3]} + 8'hb) : whole_q) : whole_q;
  logic [7:0] select_3032;
  assign select_3032 = and_409 ? (equal_2999 ? ({1'b0, cfg_width_i[9:3]} + 8'h3) : drawn_q) : drawn_q;
  // hls/stages/agreement.hpp:376
  logic select_3043;
  assign select_3043 = (ends_cell_q | select_3003) ? (~(now == 3'h6)) : (equal_432 | (slot_q == 3'h6));
  // hls/stages/agreement.hpp:371
  logic and_3047;
  assign and_3047 = (~select_3003) & (ends_cell_q ? (columns_left_q == 8'h1) : ends_q);
  // hls/stages/agreement.hpp:329
  logic [6:0] sum_3048;
  assign sum_3048 = {1'b0, row} + 7'h1;
  // hls/stages/agreement.hpp:314
  logic select_3050;
  assign select_3050 = equal_2999 ? ({sum_3048[6], cfg_height_i[8:3]} == {1'b0, sum_3048[5:0]}) : final_row_q;
  logic select_3055;
  assign select_3055 = equal_2999 ? (~({row, 1'b0} < {sum_3052, cfg_height_i[3]})) : lower_half_q;
  // hls/stages/agreement.hpp:365
  logic and_3187;
  assign and_3187 = and_409 & (equal_2999 & (row[5:2] == 4'h0));

  // Memory fresh, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1071; read in stage 0, written in stage 4: 0 < 4 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] fresh_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) fresh_mem[i] = 30'h0;
`endif
  logic [6:0] fresh_raddr;
  assign fresh_raddr = x_q[6:0];
  logic fresh_re;
  assign fresh_re = s0_en & and_441;
  logic [29:0] fresh_word_q;
  always_ff @(posedge clk_i) begin
    if (fresh_re) fresh_word_q <= fresh_mem[fresh_raddr];
  end
  logic [28:0] fresh_rdata_q;
  assign fresh_rdata_q = fresh_word_q[28:0];
  logic fresh_read_q, fresh_error;
  always_ff @(posedge clk_i) fresh_read_q <= rst_ni & fresh_re;
  assign fresh_error = fresh_read_q & ^fresh_word_q;

  // Memory left, 80 x 77 and parity, DISTANCE 12, hls/stages/agreement.hpp:1072; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [77:0] left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) left_mem[i] = 78'h0;
`endif
  logic [6:0] left_raddr;
  assign left_raddr = x_q[6:0];
  logic left_re;
  assign left_re = s0_en & (or_430 ? not_438 : select_525);
  logic [77:0] left_word_q;
  always_ff @(posedge clk_i) begin
    if (left_re) left_word_q <= left_mem[left_raddr];
  end
  logic [76:0] left_rdata_q;
  assign left_rdata_q = left_word_q[76:0];
  logic left_read_q, left_error;
  always_ff @(posedge clk_i) left_read_q <= rst_ni & left_re;
  assign left_error = left_read_q & ^left_word_q;

  // Memory right_codes, 80 x 91 and parity, DISTANCE 12, hls/stages/agreement.hpp:1073; read in stage 0, written in stage 1: 0 < 1 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [91:0] right_codes_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) right_codes_mem[i] = 92'h0;
`endif
  logic [6:0] right_codes_raddr;
  assign right_codes_raddr = equal_432 ? sum_435[6:0] : x_q[6:0];
  logic right_codes_re;
  assign right_codes_re = s0_en & (not_431 & select_525);
  logic [91:0] right_codes_word_q;
  always_ff @(posedge clk_i) begin
    if (right_codes_re) right_codes_word_q <= right_codes_mem[right_codes_raddr];
  end
  logic [90:0] right_codes_rdata_q;
  assign right_codes_rdata_q = right_codes_word_q[90:0];
  logic right_codes_read_q, right_codes_error;
  always_ff @(posedge clk_i) right_codes_read_q <= rst_ni & right_codes_re;
  assign right_codes_error = right_codes_read_q & ^right_codes_word_q;

  // Memory best_left, 80 x 46 and parity, DISTANCE 12, hls/stages/agreement.hpp:1074; read in stage 0, written in stage 2: 0 < 2 < 0 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [46:0] best_left_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_left_mem[i] = 47'h0;
`endif
  logic [6:0] best_left_raddr;
  assign best_left_raddr = or_430 ? x_q[6:0] : x[6:0];
  logic best_left_re;
  assign best_left_re = s0_en & select_551;
  logic [46:0] best_left_word_q;
  always_ff @(posedge clk_i) begin
    if (best_left_re) best_left_word_q <= best_left_mem[best_left_raddr];
  end
  logic [45:0] best_left_rdata_q;
  assign best_left_rdata_q = best_left_word_q[45:0];
  logic best_left_read_q, best_left_error;
  always_ff @(posedge clk_i) best_left_read_q <= rst_ni & best_left_re;
  assign best_left_error = best_left_read_q & ^best_left_word_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_first_q <= 1'b0;
      sample_pair_whole_q <= 1'b0;
      sample_last_q <= 1'b0;
      sample_present_q <= 1'b0;
      sample_of_skin_q <= 1'b0;
      raster_at_x_q <= 3'h0;
      raster_at_y_q <= 3'h0;
      raster_at_column_q <= 7'h0;
      raster_at_row_q <= 6'h0;
      raster_at_first_q <= 1'b0;
      raster_at_live_q <= 1'b0;
      raster_rows_left_q <= 9'h0;
      raster_row_ended_q <= 1'b1;
      raster_final_row_q <= 1'b0;
      averager_place_q <= 9'h0;
      rows_passed_above_q <= 5'h0;
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
      row_q <= 6'h0;
      least_q <= 7'h0;
      whole_q <= 8'h0;
      drawn_q <= 8'h0;
      age_q <= 7'h0;
      slot_q <= 3'h0;
      ends_cell_q <= 1'b1;
      ends_q <= 1'b0;
      final_row_q <= 1'b0;
      lower_half_q <= 1'b0;
    end else if (s0_en) begin
      sample_pair_first_q <= marks_first_i;
      sample_pair_whole_q <= 1'b1;
      sample_last_q <= marks_last_i;
      sample_present_q <= present_i;
      sample_of_skin_q <= mask_i;
      raster_at_x_q <= sample_pair_whole_q ? (select_370 + 3'h1) : raster_at_x_q;
      raster_at_y_q <= select_2763;
      raster_at_column_q <= select_2765;
      raster_at_row_q <= select_2768;
      raster_at_first_q <= sample_pair_whole_q ? sample_pair_first_q : raster_at_first_q;
      raster_at_live_q <= select_2773;
      raster_rows_left_q <= sample_pair_whole_q ? select_2775 : raster_rows_left_q;
      raster_row_ended_q <= sample_pair_whole_q ? sample_last_q : raster_row_ended_q;
      raster_final_row_q <= select_2779;
      averager_place_q <= sample_pair_whole_q ? select_376 : averager_place_q;
      rows_passed_above_q <= and_409 ? select_472 : rows_passed_above_q;
      run_phase_q <= now;
      run_shift_q <= select_3007;
      run_last_shift_q <= select_3010;
      run_span_q <= select_3003 ? (and_3000 ? 8'h0 : following_span_q) : run_span_q;
      following_phase_q <= select_2262;
      following_shift_q <= select_2251;
      following_last_shift_q <= and_2250;
      following_span_q <= plan_span_q;
      following_lowest_q <= {select_2246[6], or_2247, select_2246[3:0]};
      following_columns_q <= {or_2240[7], or_2241[4], or_2240[5:4], or_2241[3:0]};
      plan_shift_q <= select_2228;
      plan_span_q <= select_2224;
      plan_columns_q <= select_2220;
      x_q <= select_3015;
      columns_left_q <= select_3018;
      last_q <= and_409 ? (equal_2999 ? column : last_q) : last_q;
      row_q <= and_409 ? (equal_2999 ? row : row_q) : row_q;
      least_q <= select_3026;
      whole_q <= select_3029;
      drawn_q <= select_3032;
      age_q <= select_3003 ? 7'h0 : (ends_cell_q ? {age_q[5:0], 1'b1} : age_q);
      slot_q <= select_3003 ? 3'h0 : (ends_cell_q ? 3'h0 : (slot_q + 3'h1));
      ends_cell_q <= select_3043;
      ends_q <= and_3047;
      final_row_q <= and_409 ? select_3050 : final_row_q;
      lower_half_q <= and_409 ? select_3055 : lower_half_q;
    end
  end

  logic [7:0] pixel_0_s1_q;
  logic [7:0] pixel_1_s1_q;
  logic saturated_s1_q;
  logic sample_pair_first_s1_q;
  logic sample_pair_whole_s1_q;
  logic sample_present_s1_q;
  logic sample_of_skin_s1_q;
  logic [5:0] run_shift_s1_q;
  logic [7:0] x_s1_q;
  logic [3:0] age_s1_q;
  logic [2:0] slot_s1_q;
  logic ends_cell_s1_q;
  logic lower_half_s1_q;
  logic select_370_s1_q;
  logic [8:0] select_376_s1_q;
  logic and_383_s1_q;
  logic equal_389_s1_q;
  logic [6:0] column_s1_q;
  logic and_407_s1_q;
  logic and_409_s1_q;
  logic equal_412_s1_q;
  logic so_s1_q;
  logic equal_429_s1_q;
  logic or_430_s1_q;
  logic equal_432_s1_q;
  logic less_437_s1_q;
  logic not_438_s1_q;
  logic and_441_s1_q;
  logic equal_467_s1_q;
  logic equal_470_s1_q;
  logic select_472_s1_q;
  logic not_529_s1_q;
  logic [6:0] x_s1_2_q;
  logic select_551_s1_q;
  logic select_558_s1_q;
  logic and_1833_s1_q;
  logic [6:0] right_s1_q;
  logic select_1840_s1_q;
  logic equal_1849_s1_q;
  logic not_1854_s1_q;
  logic [1:0] sum_1900_s1_q;
  logic less_1932_s1_q;
  logic equal_1948_s1_q;
  logic [8:0] select_1955_s1_q;
  logic and_1985_s1_q;
  logic less_2005_s1_q;
  logic [7:0] select_2216_s1_q;
  logic [7:0] select_2270_s1_q;
  logic [7:0] select_2559_s1_q;
  logic [7:0] select_2582_s1_q;
  logic [6:0] select_2591_s1_q;
  logic select_2592_s1_q;
  logic equal_2620_s1_q;
  logic and_2757_s1_q;
  logic equal_2945_s1_q;
  logic equal_2999_s1_q;
  logic and_3188_s1_q;
  logic and_3190_s1_q;
  logic less_3296_s1_q;
  logic equal_3493_s1_q;
  always_ff @(posedge clk_i) begin
    if (s0_en) begin
      pixel_0_s1_q <= pixel_0_i;
      pixel_1_s1_q <= pixel_1_i;
      saturated_s1_q <= saturated_i;
      sample_pair_first_s1_q <= sample_pair_first_q;
      sample_pair_whole_s1_q <= sample_pair_whole_q;
      sample_present_s1_q <= sample_present_q;
      sample_of_skin_s1_q <= sample_of_skin_q;
      run_shift_s1_q <= run_shift_q;
      x_s1_q <= x_q;
      age_s1_q <= {age_q[6], age_q[4:3], age_q[0]};
      slot_s1_q <= slot_q;
      ends_cell_s1_q <= ends_cell_q;
      lower_half_s1_q <= lower_half_q;
      select_370_s1_q <= select_370[0];
      select_376_s1_q <= select_376;
      and_383_s1_q <= and_383;
      equal_389_s1_q <= select_388 == 3'h0;
      column_s1_q <= column;
      and_407_s1_q <= and_407;
      and_409_s1_q <= and_409;
      equal_412_s1_q <= select_370 == 3'h1;
      so_s1_q <= so;
      equal_429_s1_q <= equal_429;
      or_430_s1_q <= or_430;
      equal_432_s1_q <= equal_432;
      less_437_s1_q <= less_437;
      not_438_s1_q <= not_438;
      and_441_s1_q <= and_441;
      equal_467_s1_q <= equal_467;
      equal_470_s1_q <= equal_470;
      select_472_s1_q <= select_472[4];
      not_529_s1_q <= ~(row_q == 6'h0);
      x_s1_2_q <= x[6:0];
      select_551_s1_q <= select_551;
      select_558_s1_q <= or_556 ? equal_554 : (~age_q[3]);
      and_1833_s1_q <= not_431 & and_550;
      right_s1_q <= right;
      select_1840_s1_q <= or_556 ? equal_554 : ({x[7], last_q} == {1'b0, x[6:0]});
      equal_1849_s1_q <= run_phase_q == 3'h7;
      not_1854_s1_q <= ~(row_q[5:3] == 3'h0);
      sum_1900_s1_q <= sum_1900;
      less_1932_s1_q <= {1'b0, sum_1931, last_q[1]} < x_q;
      equal_1948_s1_q <= equal_1948;
      select_1955_s1_q <= select_1955;
      and_1985_s1_q <= and_1985;
      less_2005_s1_q <= 5'h4 < row_q[5:1];
      select_2216_s1_q <= select_2216;
      select_2270_s1_q <= select_2270;
      select_2559_s1_q <= select_2559;
      select_2582_s1_q <= select_1955[1] ? {7'h0, select_2580} : select_2581;
      select_2591_s1_q <= select_1955[2] ? select_2587 : {4'h0, select_2590};
      select_2592_s1_q <= select_1955[0] ? sample_last_q : sample_pair_whole_q;
      equal_2620_s1_q <= x_q == {1'b0, last_q};
      and_2757_s1_q <= so & (ends_cell_q & and_2755);
      equal_2945_s1_q <= {column[6], or_2944} == 7'h0;
      equal_2999_s1_q <= equal_2999;
      and_3188_s1_q <= and_3000 & and_3187;
      and_3190_s1_q <= and_3000 & (~and_3187);
      less_3296_s1_q <= 5'h2 < row[5:1];
      equal_3493_s1_q <= row[5:3] == 3'h0;
    end
  end

  // Stage 1 -----------------------------------------------------------------------------------------------------------
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
  // hls/stages/census.hpp:98
  logic and_384;
  assign and_384 = sample_pair_whole_s1_q & and_383_s1_q;
  // hls/stages/agreement.hpp:452
  logic and_530;
  assign and_530 = left_rdata_q[12] & not_529_s1_q;
  logic and_531;
  assign and_531 = left_rdata_q[28] & not_529_s1_q;
  logic and_532;
  assign and_532 = left_rdata_q[44] & not_529_s1_q;
  logic and_533;
  assign and_533 = left_rdata_q[60] & not_529_s1_q;
  // hls/stages/agreement.hpp:453
  logic and_537;
  assign and_537 = right_codes_rdata_q[12] & not_529_s1_q;
  logic and_538;
  assign and_538 = right_codes_rdata_q[25] & not_529_s1_q;
  logic and_539;
  assign and_539 = right_codes_rdata_q[38] & not_529_s1_q;
  logic and_540;
  assign and_540 = right_codes_rdata_q[51] & not_529_s1_q;
  logic and_541;
  assign and_541 = right_codes_rdata_q[64] & not_529_s1_q;
  logic and_542;
  assign and_542 = right_codes_rdata_q[77] & not_529_s1_q;
  // hls/stages/agreement.hpp:159
  logic and_564;
  assign and_564 = left_rdata_q[44] & not_438_s1_q;
  logic and_565;
  assign and_565 = right_codes_rdata_q[38] & not_438_s1_q;
  logic [11:0] select_566;
  assign select_566 = less_437_s1_q ? 12'h0 : right_codes_rdata_q[37:26];
  logic [11:0] select_567;
  assign select_567 = less_437_s1_q ? 12'h0 : left_rdata_q[43:32];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_571;
  assign select_571 = and_564 ? (and_565 ? (~(select_566 ^ select_567)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_577;
  assign parity_577 = ^select_571[5:3];
  logic parity_580;
  assign parity_580 = ^select_571[8:6];
  logic parity_583;
  assign parity_583 = ^select_571[11:3];
  // hls/stages/agreement.hpp:159
  logic and_587;
  assign and_587 = left_rdata_q[60] & not_438_s1_q;
  logic and_588;
  assign and_588 = right_codes_rdata_q[51] & not_438_s1_q;
  logic [11:0] select_589;
  assign select_589 = less_437_s1_q ? 12'h0 : right_codes_rdata_q[50:39];
  logic [11:0] select_590;
  assign select_590 = less_437_s1_q ? 12'h0 : left_rdata_q[59:48];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_594;
  assign select_594 = and_587 ? (and_588 ? (~(select_589 ^ select_590)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_597;
  assign parity_597 = ^select_594[8:6];
  logic parity_600;
  assign parity_600 = ^select_594[11:9];
  // hls/stages/agreement.hpp:159
  logic and_604;
  assign and_604 = left_rdata_q[76] & not_438_s1_q;
  logic and_605;
  assign and_605 = right_codes_rdata_q[64] & not_438_s1_q;
  logic [11:0] select_606;
  assign select_606 = less_437_s1_q ? 12'h0 : right_codes_rdata_q[63:52];
  logic [11:0] select_607;
  assign select_607 = less_437_s1_q ? 12'h0 : left_rdata_q[75:64];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_611;
  assign select_611 = and_604 ? (and_605 ? (~(select_606 ^ select_607)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_617;
  assign parity_617 = ^select_611[2:0];
  logic parity_620;
  assign parity_620 = ^select_611[5:3];
  logic parity_623;
  assign parity_623 = ^select_611[8:0];
  logic parity_629;
  assign parity_629 = ^select_611[11:9];
  logic parity_632;
  assign parity_632 = ^select_594[2:0];
  logic parity_635;
  assign parity_635 = ^{select_611[11:9], select_594[5:0]};
  logic parity_638;
  assign parity_638 = ^{select_611, select_594, select_571[2:0]};
  logic xor_639;
  assign xor_639 = parity_583 ^ parity_638;
  // hls/stages/agreement.hpp:479
  logic or_643;
  assign or_643 = (select_571[1:0] == 2'h3) | (select_571[2] & (select_571[0] | select_571[1]));
  // hls/stages/agreement.hpp:481
  logic or_647;
  assign or_647 = (select_594[7:6] == 2'h3) | (select_594[8] & (select_594[6] | select_594[7]));
  logic or_651;
  assign or_651 = (select_594[10:9] == 2'h3) | (select_594[11] & (select_594[9] | select_594[10]));
  // hls/stages/agreement.hpp:479
  logic or_659;
  assign or_659 = (select_611[7:6] == 2'h3) | (select_611[8] & (~(select_611[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_663;
  assign or_663 = (select_611[1:0] == 2'h3) | (select_611[2] & (select_611[0] | select_611[1]));
  logic or_667;
  assign or_667 = (select_611[4:3] == 2'h3) | (select_611[5] & (select_611[3] | select_611[4]));
  // hls/stages/agreement.hpp:480
  logic parity_670;
  assign parity_670 = ^{or_667, or_663, or_659};
  // hls/stages/agreement.hpp:479
  logic or_674;
  assign or_674 = (select_594[4:3] == 2'h3) | (select_594[5] & (select_594[3] | select_594[4]));
  // hls/stages/agreement.hpp:481
  logic or_678;
  assign or_678 = (select_611[10:9] == 2'h3) | (select_611[11] & (select_611[9] | select_611[10]));
  logic or_682;
  assign or_682 = (select_594[1:0] == 2'h3) | (select_594[2] & (select_594[0] | select_594[1]));
  // hls/stages/agreement.hpp:480
  logic parity_685;
  assign parity_685 = ^{or_682, or_678, or_674};
  logic parity_688;
  assign parity_688 = ^{or_682, or_678, or_674, or_667, or_663, or_659, or_651, or_647, or_643};
  // hls/stages/agreement.hpp:481
  logic and_689;
  assign and_689 = parity_583 & parity_638;
  logic or_693;
  assign or_693 = (parity_577 & parity_580) | ((^select_571[11:9]) & (parity_577 | parity_580));
  logic and_696;
  assign and_696 = (^{select_594[11:6], select_571[2:0]}) & (parity_623 | parity_635);
  logic or_697;
  assign or_697 = (parity_623 & parity_635) | and_696;
  // hls/stages/agreement.hpp:479
  logic or_704;
  assign or_704 = (select_571[10:9] == 2'h3) | (select_571[11] & (select_571[9] | select_571[10]));
  // hls/stages/agreement.hpp:481
  logic or_708;
  assign or_708 = (select_571[4:3] == 2'h3) | (select_571[5] & (select_571[3] | select_571[4]));
  logic or_712;
  assign or_712 = (select_571[7:6] == 2'h3) | (select_571[8] & (select_571[6] | select_571[7]));
  // hls/stages/agreement.hpp:480
  logic parity_715;
  assign parity_715 = ^{or_712, or_708, or_704};
  // hls/stages/agreement.hpp:481
  logic or_719;
  assign or_719 = (parity_597 & parity_600) | ((^select_571[2:0]) & (parity_597 | parity_600));
  logic or_723;
  assign or_723 = (parity_617 & parity_620) | ((^select_611[8:6]) & (parity_617 | parity_620));
  logic or_727;
  assign or_727 = (parity_629 & parity_632) | ((^select_594[5:3]) & (parity_629 | parity_632));
  // hls/stages/agreement.hpp:480
  logic parity_730;
  assign parity_730 = ^{or_727, or_723, or_719};
  logic parity_733;
  assign parity_733 = ^{or_727, or_723, or_719, or_712, or_708, or_704, or_697, or_693, and_689};
  logic xor_734;
  assign xor_734 = parity_688 ^ parity_733;
  // hls/stages/agreement.hpp:481
  logic and_735;
  assign and_735 = parity_688 & parity_733;
  logic or_739;
  assign or_739 = (parity_670 & parity_685) | ((^{or_651, or_647, or_643}) & (parity_670 | parity_685));
  logic or_743;
  assign or_743 = (parity_715 & parity_730) | ((^{or_697, or_693, and_689}) & (parity_715 | parity_730));
  logic or_750;
  assign or_750 = (or_647 & or_651) | (or_643 & (or_647 | or_651));
  logic or_754;
  assign or_754 = (or_663 & or_667) | (or_659 & (or_663 | or_667));
  logic or_758;
  assign or_758 = (or_678 & or_682) | (or_674 & (or_678 | or_682));
  // hls/stages/agreement.hpp:480
  logic parity_761;
  assign parity_761 = ^{or_758, or_754, or_750};
  // hls/stages/agreement.hpp:481
  logic or_765;
  assign or_765 = (or_693 & or_697) | (and_689 & (or_693 | or_697));
  logic or_769;
  assign or_769 = (or_708 & or_712) | (or_704 & (or_708 | or_712));
  logic or_773;
  assign or_773 = (or_723 & or_727) | (or_719 & (or_723 | or_727));
  // hls/stages/agreement.hpp:480
  logic parity_776;
  assign parity_776 = ^{or_773, or_769, or_765};
  logic parity_779;
  assign parity_779 = ^{or_773, or_769, or_765, or_758, or_754, or_750, or_743, or_739, and_735};
  // hls/stages/agreement.hpp:481
  logic or_783;
  assign or_783 = (parity_761 & parity_776) | ((^{or_743, or_739, and_735}) & (parity_761 | parity_776));
  logic or_787;
  assign or_787 = (or_739 & or_743) | (and_735 & (or_739 | or_743));
  logic or_791;
  assign or_791 = (or_754 & or_758) | (or_750 & (or_754 | or_758));
  logic or_795;
  assign or_795 = (or_769 & or_773) | (or_765 & (or_769 | or_773));
  // hls/stages/agreement.hpp:480
  logic parity_800;
  assign parity_800 = ^{or_795, or_791, or_787, or_783};
  // hls/stages/agreement.hpp:481
  logic or_804;
  assign or_804 = (or_791 & or_795) | (or_787 & (or_791 | or_795));
  logic and_805;
  assign and_805 = or_783 & (^{or_795, or_791, or_787});
  // hls/stages/agreement.hpp:480
  logic xor_806;
  assign xor_806 = or_804 ^ and_805;
  // hls/stages/agreement.hpp:483
  logic and_807;
  assign and_807 = or_804 & and_805;
  // hls/stages/agreement.hpp:554
  logic [5:0] select_808;
  assign select_808 = equal_432_s1_q ? {and_807, xor_806, parity_800, parity_779, xor_734, xor_639} : 6'h0;
  logic [5:0] column_2;
  assign column_2 = or_430_s1_q ? 6'h0 : select_808;
  // hls/stages/agreement.hpp:586
  logic [5:0] select_810;
  assign select_810 = age_s1_q[3] ? middle_sum_columns_values_6_q : 6'h0;
  logic [6:0] difference_811;
  assign difference_811 = {1'b0, column_2} - {1'b0, select_810};
  logic [7:0] sum_813;
  assign sum_813 = {difference_811[6], difference_811} + (age_s1_q[0] ? middle_sum_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:465
  logic [11:0] select_817;
  assign select_817 = and_564 ? (and_588 ? (~(select_589 ^ select_567)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_823;
  assign parity_823 = ^select_817[5:3];
  logic parity_826;
  assign parity_826 = ^select_817[8:6];
  logic parity_829;
  assign parity_829 = ^select_817[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_836;
  assign select_836 = and_587 ? (and_605 ? (~(select_606 ^ select_590)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_839;
  assign parity_839 = ^select_836[8:6];
  logic parity_842;
  assign parity_842 = ^select_836[11:9];
  // hls/stages/agreement.hpp:159
  logic and_846;
  assign and_846 = right_codes_rdata_q[77] & not_438_s1_q;
  logic [11:0] select_847;
  assign select_847 = less_437_s1_q ? 12'h0 : right_codes_rdata_q[76:65];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_851;
  assign select_851 = and_604 ? (and_846 ? (~(select_847 ^ select_607)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_857;
  assign parity_857 = ^select_851[2:0];
  logic parity_860;
  assign parity_860 = ^select_851[5:3];
  logic parity_863;
  assign parity_863 = ^select_851[8:0];
  logic parity_869;
  assign parity_869 = ^select_851[11:9];
  logic parity_872;
  assign parity_872 = ^select_836[2:0];
  logic parity_875;
  assign parity_875 = ^{select_851[11:9], select_836[5:0]};
  logic parity_878;
  assign parity_878 = ^{select_851, select_836, select_817[2:0]};
  logic xor_879;
  assign xor_879 = parity_829 ^ parity_878;
  // hls/stages/agreement.hpp:479
  logic or_883;
  assign or_883 = (select_817[1:0] == 2'h3) | (select_817[2] & (select_817[0] | select_817[1]));
  // hls/stages/agreement.hpp:481
  logic or_887;
  assign or_887 = (select_836[7:6] == 2'h3) | (select_836[8] & (select_836[6] | select_836[7]));
  logic or_891;
  assign or_891 = (select_836[10:9] == 2'h3) | (select_836[11] & (select_836[9] | select_836[10]));
  // hls/stages/agreement.hpp:479
  logic or_899;
  assign or_899 = (select_851[7:6] == 2'h3) | (select_851[8] & (~(select_851[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_903;
  assign or_903 = (select_851[1:0] == 2'h3) | (select_851[2] & (select_851[0] | select_851[1]));
  logic or_907;
  assign or_907 = (select_851[4:3] == 2'h3) | (select_851[5] & (select_851[3] | select_851[4]));
  // hls/stages/agreement.hpp:480
  logic parity_910;
  assign parity_910 = ^{or_907, or_903, or_899};
  // hls/stages/agreement.hpp:479
  logic or_914;
  assign or_914 = (select_836[4:3] == 2'h3) | (select_836[5] & (select_836[3] | select_836[4]));
  // hls/stages/agreement.hpp:481
  logic or_918;
  assign or_918 = (select_851[10:9] == 2'h3) | (select_851[11] & (select_851[9] | select_851[10]));
  logic or_922;
  assign or_922 = (select_836[1:0] == 2'h3) | (select_836[2] & (select_836[0] | select_836[1]));
  // hls/stages/agreement.hpp:480
  logic parity_925;
  assign parity_925 = ^{or_922, or_918, or_914};
  logic parity_928;
  assign parity_928 = ^{or_922, or_918, or_914, or_907, or_903, or_899, or_891, or_887, or_883};
  // hls/stages/agreement.hpp:481
  logic and_929;
  assign and_929 = parity_829 & parity_878;
  logic or_933;
  assign or_933 = (parity_823 & parity_826) | ((^select_817[11:9]) & (parity_823 | parity_826));
  logic and_936;
  assign and_936 = (^{select_836[11:6], select_817[2:0]}) & (parity_863 | parity_875);
  logic or_937;
  assign or_937 = (parity_863 & parity_875) | and_936;
  // hls/stages/agreement.hpp:479
  logic or_944;
  assign or_944 = (select_817[10:9] == 2'h3) | (select_817[11] & (select_817[9] | select_817[10]));
  // hls/stages/agreement.hpp:481
  logic or_948;
  assign or_948 = (select_817[4:3] == 2'h3) | (select_817[5] & (select_817[3] | select_817[4]));
  logic or_952;
  assign or_952 = (select_817[7:6] == 2'h3) | (select_817[8] & (select_817[6] | select_817[7]));
  // hls/stages/agreement.hpp:480
  logic parity_955;
  assign parity_955 = ^{or_952, or_948, or_944};
  // hls/stages/agreement.hpp:481
  logic or_959;
  assign or_959 = (parity_839 & parity_842) | ((^select_817[2:0]) & (parity_839 | parity_842));
  logic or_963;
  assign or_963 = (parity_857 & parity_860) | ((^select_851[8:6]) & (parity_857 | parity_860));
  logic or_967;
  assign or_967 = (parity_869 & parity_872) | ((^select_836[5:3]) & (parity_869 | parity_872));
  // hls/stages/agreement.hpp:480
  logic parity_970;
  assign parity_970 = ^{or_967, or_963, or_959};
  logic parity_973;
  assign parity_973 = ^{or_967, or_963, or_959, or_952, or_948, or_944, or_937, or_933, and_929};
  logic xor_974;
  assign xor_974 = parity_928 ^ parity_973;
  // hls/stages/agreement.hpp:481
  logic and_975;
  assign and_975 = parity_928 & parity_973;
  logic or_979;
  assign or_979 = (parity_910 & parity_925) | ((^{or_891, or_887, or_883}) & (parity_910 | parity_925));
  logic or_983;
  assign or_983 = (parity_955 & parity_970) | ((^{or_937, or_933, and_929}) & (parity_955 | parity_970));
  logic or_990;
  assign or_990 = (or_887 & or_891) | (or_883 & (or_887 | or_891));
  logic or_994;
  assign or_994 = (or_903 & or_907) | (or_899 & (or_903 | or_907));
  logic or_998;
  assign or_998 = (or_918 & or_922) | (or_914 & (or_918 | or_922));
  // hls/stages/agreement.hpp:480
  logic parity_1001;
  assign parity_1001 = ^{or_998, or_994, or_990};
  // hls/stages/agreement.hpp:481
  logic or_1005;
  assign or_1005 = (or_933 & or_937) | (and_929 & (or_933 | or_937));
  logic or_1009;
  assign or_1009 = (or_948 & or_952) | (or_944 & (or_948 | or_952));
  logic or_1013;
  assign or_1013 = (or_963 & or_967) | (or_959 & (or_963 | or_967));
  // hls/stages/agreement.hpp:480
  logic parity_1016;
  assign parity_1016 = ^{or_1013, or_1009, or_1005};
  logic parity_1019;
  assign parity_1019 = ^{or_1013, or_1009, or_1005, or_998, or_994, or_990, or_983, or_979, and_975};
  // hls/stages/agreement.hpp:481
  logic or_1023;
  assign or_1023 = (parity_1001 & parity_1016) | ((^{or_983, or_979, and_975}) & (parity_1001 | parity_1016));
  logic or_1027;
  assign or_1027 = (or_979 & or_983) | (and_975 & (or_979 | or_983));
  logic or_1031;
  assign or_1031 = (or_994 & or_998) | (or_990 & (or_994 | or_998));
  logic or_1035;
  assign or_1035 = (or_1009 & or_1013) | (or_1005 & (or_1009 | or_1013));
  // hls/stages/agreement.hpp:480
  logic parity_1040;
  assign parity_1040 = ^{or_1035, or_1031, or_1027, or_1023};
  // hls/stages/agreement.hpp:481
  logic or_1044;
  assign or_1044 = (or_1031 & or_1035) | (or_1027 & (or_1031 | or_1035));
  logic and_1045;
  assign and_1045 = or_1023 & (^{or_1035, or_1031, or_1027});
  // hls/stages/agreement.hpp:480
  logic xor_1046;
  assign xor_1046 = or_1044 ^ and_1045;
  // hls/stages/agreement.hpp:483
  logic and_1047;
  assign and_1047 = or_1044 & and_1045;
  // hls/stages/agreement.hpp:554
  logic [5:0] select_1048;
  assign select_1048 = equal_432_s1_q ? {and_1047, xor_1046, parity_1040, parity_1019, xor_974, xor_879} : 6'h0;
  logic [5:0] column_3;
  assign column_3 = or_430_s1_q ? 6'h0 : select_1048;
  // hls/stages/agreement.hpp:586
  logic [5:0] select_1050;
  assign select_1050 = age_s1_q[3] ? sums_0_columns_values_6_q : 6'h0;
  logic [6:0] difference_1051;
  assign difference_1051 = {1'b0, column_3} - {1'b0, select_1050};
  logic [7:0] sum_1053;
  assign sum_1053 = {difference_1051[6], difference_1051} + (age_s1_q[0] ? sums_0_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:159
  logic and_1054;
  assign and_1054 = right_codes_rdata_q[25] & not_438_s1_q;
  logic [11:0] select_1055;
  assign select_1055 = less_437_s1_q ? 12'h0 : right_codes_rdata_q[24:13];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1059;
  assign select_1059 = and_564 ? (and_1054 ? (~(select_1055 ^ select_567)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1065;
  assign parity_1065 = ^select_1059[5:3];
  logic parity_1068;
  assign parity_1068 = ^select_1059[8:6];
  logic parity_1071;
  assign parity_1071 = ^select_1059[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1078;
  assign select_1078 = and_587 ? (and_565 ? (~(select_566 ^ select_590)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1081;
  assign parity_1081 = ^select_1078[8:6];
  logic parity_1084;
  assign parity_1084 = ^select_1078[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1091;
  assign select_1091 = and_604 ? (and_588 ? (~(select_589 ^ select_607)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1097;
  assign parity_1097 = ^select_1091[2:0];
  logic parity_1100;
  assign parity_1100 = ^select_1091[5:3];
  logic parity_1103;
  assign parity_1103 = ^select_1091[8:0];
  logic parity_1109;
  assign parity_1109 = ^select_1091[11:9];
  logic parity_1112;
  assign parity_1112 = ^select_1078[2:0];
  logic parity_1115;
  assign parity_1115 = ^{select_1091[11:9], select_1078[5:0]};
  logic parity_1118;
  assign parity_1118 = ^{select_1091, select_1078, select_1059[2:0]};
  logic xor_1119;
  assign xor_1119 = parity_1071 ^ parity_1118;
  // hls/stages/agreement.hpp:479
  logic or_1123;
  assign or_1123 = (select_1059[1:0] == 2'h3) | (select_1059[2] & (select_1059[0] | select_1059[1]));
  // hls/stages/agreement.hpp:481
  logic or_1127;
  assign or_1127 = (select_1078[7:6] == 2'h3) | (select_1078[8] & (select_1078[6] | select_1078[7]));
  logic or_1131;
  assign or_1131 = (select_1078[10:9] == 2'h3) | (select_1078[11] & (select_1078[9] | select_1078[10]));
  // hls/stages/agreement.hpp:479
  logic or_1139;
  assign or_1139 = (select_1091[7:6] == 2'h3) | (select_1091[8] & (~(select_1091[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_1143;
  assign or_1143 = (select_1091[1:0] == 2'h3) | (select_1091[2] & (select_1091[0] | select_1091[1]));
  logic or_1147;
  assign or_1147 = (select_1091[4:3] == 2'h3) | (select_1091[5] & (select_1091[3] | select_1091[4]));
  // hls/stages/agreement.hpp:480
  logic parity_1150;
  assign parity_1150 = ^{or_1147, or_1143, or_1139};
  // hls/stages/agreement.hpp:479
  logic or_1154;
  assign or_1154 = (select_1078[4:3] == 2'h3) | (select_1078[5] & (select_1078[3] | select_1078[4]));
  // hls/stages/agreement.hpp:481
  logic or_1158;
  assign or_1158 = (select_1091[10:9] == 2'h3) | (select_1091[11] & (select_1091[9] | select_1091[10]));
  logic or_1162;
  assign or_1162 = (select_1078[1:0] == 2'h3) | (select_1078[2] & (select_1078[0] | select_1078[1]));
  // hls/stages/agreement.hpp:480
  logic parity_1165;
  assign parity_1165 = ^{or_1162, or_1158, or_1154};
  logic parity_1168;
  assign parity_1168 = ^{or_1162, or_1158, or_1154, or_1147, or_1143, or_1139, or_1131, or_1127, or_1123};
  // hls/stages/agreement.hpp:481
  logic and_1169;
  assign and_1169 = parity_1071 & parity_1118;
  logic or_1173;
  assign or_1173 = (parity_1065 & parity_1068) | ((^select_1059[11:9]) & (parity_1065 | parity_1068));
  logic and_1176;
  assign and_1176 = (^{select_1078[11:6], select_1059[2:0]}) & (parity_1103 | parity_1115);
  logic or_1177;
  assign or_1177 = (parity_1103 & parity_1115) | and_1176;
  // hls/stages/agreement.hpp:479
  logic or_1184;
  assign or_1184 = (select_1059[10:9] == 2'h3) | (select_1059[11] & (select_1059[9] | select_1059[10]));
  // hls/stages/agreement.hpp:481
  logic or_1188;
  assign or_1188 = (select_1059[4:3] == 2'h3) | (select_1059[5] & (select_1059[3] | select_1059[4]));
  logic or_1192;
  assign or_1192 = (select_1059[7:6] == 2'h3) | (select_1059[8] & (select_1059[6] | select_1059[7]));
  // hls/stages/agreement.hpp:480
  logic parity_1195;
  assign parity_1195 = ^{or_1192, or_1188, or_1184};
  // hls/stages/agreement.hpp:481
  logic or_1199;
  assign or_1199 = (parity_1081 & parity_1084) | ((^select_1059[2:0]) & (parity_1081 | parity_1084));
  logic or_1203;
  assign or_1203 = (parity_1097 & parity_1100) | ((^select_1091[8:6]) & (parity_1097 | parity_1100));
  logic or_1207;
  assign or_1207 = (parity_1109 & parity_1112) | ((^select_1078[5:3]) & (parity_1109 | parity_1112));
  // hls/stages/agreement.hpp:480
  logic parity_1210;
  assign parity_1210 = ^{or_1207, or_1203, or_1199};
  logic parity_1213;
  assign parity_1213 = ^{or_1207, or_1203, or_1199, or_1192, or_1188, or_1184, or_1177, or_1173, and_1169};
  logic xor_1214;
  assign xor_1214 = parity_1168 ^ parity_1213;
  // hls/stages/agreement.hpp:481
  logic and_1215;
  assign and_1215 = parity_1168 & parity_1213;
  logic or_1219;
  assign or_1219 = (parity_1150 & parity_1165) | ((^{or_1131, or_1127, or_1123}) & (parity_1150 | parity_1165));
  logic or_1223;
  assign or_1223 = (parity_1195 & parity_1210) | ((^{or_1177, or_1173, and_1169}) & (parity_1195 | parity_1210));
  logic or_1230;
  assign or_1230 = (or_1127 & or_1131) | (or_1123 & (or_1127 | or_1131));
  logic or_1234;
  assign or_1234 = (or_1143 & or_1147) | (or_1139 & (or_1143 | or_1147));
  logic or_1238;
  assign or_1238 = (or_1158 & or_1162) | (or_1154 & (or_1158 | or_1162));
  // hls/stages/agreement.hpp:480
  logic parity_1241;
  assign parity_1241 = ^{or_1238, or_1234, or_1230};
  // hls/stages/agreement.hpp:481
  logic or_1245;
  assign or_1245 = (or_1173 & or_1177) | (and_1169 & (or_1173 | or_1177));
  logic or_1249;
  assign or_1249 = (or_1188 & or_1192) | (or_1184 & (or_1188 | or_1192));
  logic or_1253;
  assign or_1253 = (or_1203 & or_1207) | (or_1199 & (or_1203 | or_1207));
  // hls/stages/agreement.hpp:480
  logic parity_1256;
  assign parity_1256 = ^{or_1253, or_1249, or_1245};
  logic parity_1259;
  assign parity_1259 = ^{or_1253, or_1249, or_1245, or_1238, or_1234, or_1230, or_1223, or_1219, and_1215};
  // hls/stages/agreement.hpp:481
  logic or_1263;
  assign or_1263 = (parity_1241 & parity_1256) | ((^{or_1223, or_1219, and_1215}) & (parity_1241 | parity_1256));
  logic or_1267;
  assign or_1267 = (or_1219 & or_1223) | (and_1215 & (or_1219 | or_1223));
  logic or_1271;
  assign or_1271 = (or_1234 & or_1238) | (or_1230 & (or_1234 | or_1238));
  logic or_1275;
  assign or_1275 = (or_1249 & or_1253) | (or_1245 & (or_1249 | or_1253));
  // hls/stages/agreement.hpp:480
  logic parity_1280;
  assign parity_1280 = ^{or_1275, or_1271, or_1267, or_1263};
  // hls/stages/agreement.hpp:481
  logic or_1284;
  assign or_1284 = (or_1271 & or_1275) | (or_1267 & (or_1271 | or_1275));
  logic and_1285;
  assign and_1285 = or_1263 & (^{or_1275, or_1271, or_1267});
  // hls/stages/agreement.hpp:480
  logic xor_1286;
  assign xor_1286 = or_1284 ^ and_1285;
  // hls/stages/agreement.hpp:483
  logic and_1287;
  assign and_1287 = or_1284 & and_1285;
  // hls/stages/agreement.hpp:554
  logic [5:0] select_1288;
  assign select_1288 = equal_432_s1_q ? {and_1287, xor_1286, parity_1280, parity_1259, xor_1214, xor_1119} : 6'h0;
  logic [5:0] column_4;
  assign column_4 = or_430_s1_q ? 6'h0 : select_1288;
  // hls/stages/agreement.hpp:586
  logic [5:0] select_1290;
  assign select_1290 = age_s1_q[3] ? sums_1_columns_values_6_q : 6'h0;
  logic [6:0] difference_1291;
  assign difference_1291 = {1'b0, column_4} - {1'b0, select_1290};
  logic [7:0] sum_1293;
  assign sum_1293 = {difference_1291[6], difference_1291} + (age_s1_q[0] ? sums_1_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1301;
  assign select_1301 = and_564 ? (and_605 ? (~(select_606 ^ select_567)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1307;
  assign parity_1307 = ^select_1301[5:3];
  logic parity_1310;
  assign parity_1310 = ^select_1301[8:6];
  logic parity_1313;
  assign parity_1313 = ^select_1301[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1320;
  assign select_1320 = and_587 ? (and_846 ? (~(select_847 ^ select_590)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1323;
  assign parity_1323 = ^select_1320[8:6];
  logic parity_1326;
  assign parity_1326 = ^select_1320[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] xor_1332;
  assign xor_1332 = (less_437_s1_q ? 12'h0 : right_codes_rdata_q[89:78]) ^ select_607;
  logic [11:0] select_1335;
  assign select_1335 = and_604 ? ((right_codes_rdata_q[90] & not_438_s1_q) ? (~xor_1332) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1341;
  assign parity_1341 = ^select_1335[2:0];
  logic parity_1344;
  assign parity_1344 = ^select_1335[5:3];
  logic parity_1347;
  assign parity_1347 = ^select_1335[8:0];
  logic parity_1353;
  assign parity_1353 = ^select_1335[11:9];
  logic parity_1356;
  assign parity_1356 = ^select_1320[2:0];
  logic parity_1359;
  assign parity_1359 = ^{select_1335[11:9], select_1320[5:0]};
  logic parity_1362;
  assign parity_1362 = ^{select_1335, select_1320, select_1301[2:0]};
  logic xor_1363;
  assign xor_1363 = parity_1313 ^ parity_1362;
  // hls/stages/agreement.hpp:479
  logic or_1367;
  assign or_1367 = (select_1301[1:0] == 2'h3) | (select_1301[2] & (select_1301[0] | select_1301[1]));
  // hls/stages/agreement.hpp:481
  logic or_1371;
  assign or_1371 = (select_1320[7:6] == 2'h3) | (select_1320[8] & (select_1320[6] | select_1320[7]));
  logic or_1375;
  assign or_1375 = (select_1320[10:9] == 2'h3) | (select_1320[11] & (select_1320[9] | select_1320[10]));
  // hls/stages/agreement.hpp:479
  logic or_1383;
  assign or_1383 = (select_1335[7:6] == 2'h3) | (select_1335[8] & (~(select_1335[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_1387;
  assign or_1387 = (select_1335[1:0] == 2'h3) | (select_1335[2] & (select_1335[0] | select_1335[1]));
  logic or_1391;
  assign or_1391 = (select_1335[4:3] == 2'h3) | (select_1335[5] & (select_1335[3] | select_1335[4]));
  // hls/stages/agreement.hpp:480
  logic parity_1394;
  assign parity_1394 = ^{or_1391, or_1387, or_1383};
  // hls/stages/agreement.hpp:479
  logic or_1398;
  assign or_1398 = (select_1320[4:3] == 2'h3) | (select_1320[5] & (select_1320[3] | select_1320[4]));
  // hls/stages/agreement.hpp:481
  logic or_1402;
  assign or_1402 = (select_1335[10:9] == 2'h3) | (select_1335[11] & (select_1335[9] | select_1335[10]));
  logic or_1406;
  assign or_1406 = (select_1320[1:0] == 2'h3) | (select_1320[2] & (select_1320[0] | select_1320[1]));
  // hls/stages/agreement.hpp:480
  logic parity_1409;
  assign parity_1409 = ^{or_1406, or_1402, or_1398};
  logic parity_1412;
  assign parity_1412 = ^{or_1406, or_1402, or_1398, or_1391, or_1387, or_1383, or_1375, or_1371, or_1367};
  // hls/stages/agreement.hpp:481
  logic and_1413;
  assign and_1413 = parity_1313 & parity_1362;
  logic or_1417;
  assign or_1417 = (parity_1307 & parity_1310) | ((^select_1301[11:9]) & (parity_1307 | parity_1310));
  logic and_1420;
  assign and_1420 = (^{select_1320[11:6], select_1301[2:0]}) & (parity_1347 | parity_1359);
  logic or_1421;
  assign or_1421 = (parity_1347 & parity_1359) | and_1420;
  // hls/stages/agreement.hpp:479
  logic or_1428;
  assign or_1428 = (select_1301[10:9] == 2'h3) | (select_1301[11] & (select_1301[9] | select_1301[10]));
  // hls/stages/agreement.hpp:481
  logic or_1432;
  assign or_1432 = (select_1301[4:3] == 2'h3) | (select_1301[5] & (select_1301[3] | select_1301[4]));
  logic or_1436;
  assign or_1436 = (select_1301[7:6] == 2'h3) | (select_1301[8] & (select_1301[6] | select_1301[7]));
  // hls/stages/agreement.hpp:480
  logic parity_1439;
  assign parity_1439 = ^{or_1436, or_1432, or_1428};
  // hls/stages/agreement.hpp:481
  logic or_1443;
  assign or_1443 = (parity_1323 & parity_1326) | ((^select_1301[2:0]) & (parity_1323 | parity_1326));
  logic or_1447;
  assign or_1447 = (parity_1341 & parity_1344) | ((^select_1335[8:6]) & (parity_1341 | parity_1344));
  logic or_1451;
  assign or_1451 = (parity_1353 & parity_1356) | ((^select_1320[5:3]) & (parity_1353 | parity_1356));
  // hls/stages/agreement.hpp:480
  logic parity_1454;
  assign parity_1454 = ^{or_1451, or_1447, or_1443};
  logic parity_1457;
  assign parity_1457 = ^{or_1451, or_1447, or_1443, or_1436, or_1432, or_1428, or_1421, or_1417, and_1413};
  logic xor_1458;
  assign xor_1458 = parity_1412 ^ parity_1457;
  // hls/stages/agreement.hpp:481
  logic and_1459;
  assign and_1459 = parity_1412 & parity_1457;
  logic or_1463;
  assign or_1463 = (parity_1394 & parity_1409) | ((^{or_1375, or_1371, or_1367}) & (parity_1394 | parity_1409));
  logic or_1467;
  assign or_1467 = (parity_1439 & parity_1454) | ((^{or_1421, or_1417, and_1413}) & (parity_1439 | parity_1454));
  logic or_1474;
  assign or_1474 = (or_1371 & or_1375) | (or_1367 & (or_1371 | or_1375));
  logic or_1478;
  assign or_1478 = (or_1387 & or_1391) | (or_1383 & (or_1387 | or_1391));
  logic or_1482;
  assign or_1482 = (or_1402 & or_1406) | (or_1398 & (or_1402 | or_1406));
  // hls/stages/agreement.hpp:480
  logic parity_1485;
  assign parity_1485 = ^{or_1482, or_1478, or_1474};
  // hls/stages/agreement.hpp:481
  logic or_1489;
  assign or_1489 = (or_1417 & or_1421) | (and_1413 & (or_1417 | or_1421));
  logic or_1493;
  assign or_1493 = (or_1432 & or_1436) | (or_1428 & (or_1432 | or_1436));
  logic or_1497;
  assign or_1497 = (or_1447 & or_1451) | (or_1443 & (or_1447 | or_1451));
  // hls/stages/agreement.hpp:480
  logic parity_1500;
  assign parity_1500 = ^{or_1497, or_1493, or_1489};
  logic parity_1503;
  assign parity_1503 = ^{or_1497, or_1493, or_1489, or_1482, or_1478, or_1474, or_1467, or_1463, and_1459};
  // hls/stages/agreement.hpp:481
  logic or_1507;
  assign or_1507 = (parity_1485 & parity_1500) | ((^{or_1467, or_1463, and_1459}) & (parity_1485 | parity_1500));
  logic or_1511;
  assign or_1511 = (or_1463 & or_1467) | (and_1459 & (or_1463 | or_1467));
  logic or_1515;
  assign or_1515 = (or_1478 & or_1482) | (or_1474 & (or_1478 | or_1482));
  logic or_1519;
  assign or_1519 = (or_1493 & or_1497) | (or_1489 & (or_1493 | or_1497));
  // hls/stages/agreement.hpp:480
  logic parity_1524;
  assign parity_1524 = ^{or_1519, or_1515, or_1511, or_1507};
  // hls/stages/agreement.hpp:481
  logic or_1528;
  assign or_1528 = (or_1515 & or_1519) | (or_1511 & (or_1515 | or_1519));
  logic and_1529;
  assign and_1529 = or_1507 & (^{or_1519, or_1515, or_1511});
  // hls/stages/agreement.hpp:480
  logic xor_1530;
  assign xor_1530 = or_1528 ^ and_1529;
  // hls/stages/agreement.hpp:483
  logic and_1531;
  assign and_1531 = or_1528 & and_1529;
  // hls/stages/agreement.hpp:554
  logic [5:0] select_1532;
  assign select_1532 = equal_432_s1_q ? {and_1531, xor_1530, parity_1524, parity_1503, xor_1458, xor_1363} : 6'h0;
  logic [5:0] column_5;
  assign column_5 = or_430_s1_q ? 6'h0 : select_1532;
  // hls/stages/agreement.hpp:586
  logic [5:0] select_1534;
  assign select_1534 = age_s1_q[3] ? sums_2_columns_values_6_q : 6'h0;
  logic [6:0] difference_1535;
  assign difference_1535 = {1'b0, column_5} - {1'b0, select_1534};
  logic [7:0] sum_1537;
  assign sum_1537 = {difference_1535[6], difference_1535} + (age_s1_q[0] ? sums_2_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:465
  logic [11:0] not_1541;
  assign not_1541 = ~((less_437_s1_q ? 12'h0 : right_codes_rdata_q[11:0]) ^ select_567);
  logic [11:0] select_1543;
  assign select_1543 = and_564 ? ((right_codes_rdata_q[12] & not_438_s1_q) ? not_1541 : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1549;
  assign parity_1549 = ^select_1543[5:3];
  logic parity_1552;
  assign parity_1552 = ^select_1543[8:6];
  logic parity_1555;
  assign parity_1555 = ^select_1543[11:3];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1562;
  assign select_1562 = and_587 ? (and_1054 ? (~(select_1055 ^ select_590)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1565;
  assign parity_1565 = ^select_1562[8:6];
  logic parity_1568;
  assign parity_1568 = ^select_1562[11:9];
  // hls/stages/agreement.hpp:465
  logic [11:0] select_1575;
  assign select_1575 = and_604 ? (and_565 ? (~(select_566 ^ select_607)) : 12'h0) : 12'h0;
  // hls/stages/agreement.hpp:480
  logic parity_1581;
  assign parity_1581 = ^select_1575[2:0];
  logic parity_1584;
  assign parity_1584 = ^select_1575[5:3];
  logic parity_1587;
  assign parity_1587 = ^select_1575[8:0];
  logic parity_1593;
  assign parity_1593 = ^select_1575[11:9];
  logic parity_1596;
  assign parity_1596 = ^select_1562[2:0];
  logic parity_1599;
  assign parity_1599 = ^{select_1575[11:9], select_1562[5:0]};
  logic parity_1602;
  assign parity_1602 = ^{select_1575, select_1562, select_1543[2:0]};
  logic xor_1603;
  assign xor_1603 = parity_1555 ^ parity_1602;
  // hls/stages/agreement.hpp:479
  logic or_1607;
  assign or_1607 = (select_1543[1:0] == 2'h3) | (select_1543[2] & (select_1543[0] | select_1543[1]));
  // hls/stages/agreement.hpp:481
  logic or_1611;
  assign or_1611 = (select_1562[7:6] == 2'h3) | (select_1562[8] & (select_1562[6] | select_1562[7]));
  logic or_1615;
  assign or_1615 = (select_1562[10:9] == 2'h3) | (select_1562[11] & (select_1562[9] | select_1562[10]));
  // hls/stages/agreement.hpp:479
  logic or_1623;
  assign or_1623 = (select_1575[7:6] == 2'h3) | (select_1575[8] & (~(select_1575[7:6] == 2'h0)));
  // hls/stages/agreement.hpp:481
  logic or_1627;
  assign or_1627 = (select_1575[1:0] == 2'h3) | (select_1575[2] & (select_1575[0] | select_1575[1]));
  logic or_1631;
  assign or_1631 = (select_1575[4:3] == 2'h3) | (select_1575[5] & (select_1575[3] | select_1575[4]));
  // hls/stages/agreement.hpp:480
  logic parity_1634;
  assign parity_1634 = ^{or_1631, or_1627, or_1623};
  // hls/stages/agreement.hpp:479
  logic or_1638;
  assign or_1638 = (select_1562[4:3] == 2'h3) | (select_1562[5] & (select_1562[3] | select_1562[4]));
  // hls/stages/agreement.hpp:481
  logic or_1642;
  assign or_1642 = (select_1575[10:9] == 2'h3) | (select_1575[11] & (select_1575[9] | select_1575[10]));
  logic or_1646;
  assign or_1646 = (select_1562[1:0] == 2'h3) | (select_1562[2] & (select_1562[0] | select_1562[1]));
  // hls/stages/agreement.hpp:480
  logic parity_1649;
  assign parity_1649 = ^{or_1646, or_1642, or_1638};
  logic parity_1652;
  assign parity_1652 = ^{or_1646, or_1642, or_1638, or_1631, or_1627, or_1623, or_1615, or_1611, or_1607};
  // hls/stages/agreement.hpp:481
  logic and_1653;
  assign and_1653 = parity_1555 & parity_1602;
  logic or_1657;
  assign or_1657 = (parity_1549 & parity_1552) | ((^select_1543[11:9]) & (parity_1549 | parity_1552));
  logic and_1660;
  assign and_1660 = (^{select_1562[11:6], select_1543[2:0]}) & (parity_1587 | parity_1599);
  logic or_1661;
  assign or_1661 = (parity_1587 & parity_1599) | and_1660;
  // hls/stages/agreement.hpp:479
  logic or_1668;
  assign or_1668 = (select_1543[10:9] == 2'h3) | (select_1543[11] & (select_1543[9] | select_1543[10]));
  // hls/stages/agreement.hpp:481
  logic or_1672;
  assign or_1672 = (select_1543[4:3] == 2'h3) | (select_1543[5] & (select_1543[3] | select_1543[4]));
  logic or_1676;
  assign or_1676 = (select_1543[7:6] == 2'h3) | (select_1543[8] & (select_1543[6] | select_1543[7]));
  // hls/stages/agreement.hpp:480
  logic parity_1679;
  assign parity_1679 = ^{or_1676, or_1672, or_1668};
  // hls/stages/agreement.hpp:481
  logic or_1683;
  assign or_1683 = (parity_1565 & parity_1568) | ((^select_1543[2:0]) & (parity_1565 | parity_1568));
  logic or_1687;
  assign or_1687 = (parity_1581 & parity_1584) | ((^select_1575[8:6]) & (parity_1581 | parity_1584));
  logic or_1691;
  assign or_1691 = (parity_1593 & parity_1596) | ((^select_1562[5:3]) & (parity_1593 | parity_1596));
  // hls/stages/agreement.hpp:480
  logic parity_1694;
  assign parity_1694 = ^{or_1691, or_1687, or_1683};
  logic parity_1697;
  assign parity_1697 = ^{or_1691, or_1687, or_1683, or_1676, or_1672, or_1668, or_1661, or_1657, and_1653};
  logic xor_1698;
  assign xor_1698 = parity_1652 ^ parity_1697;
  // hls/stages/agreement.hpp:481
  logic and_1699;
  assign and_1699 = parity_1652 & parity_1697;
  logic or_1703;
  assign or_1703 = (parity_1634 & parity_1649) | ((^{or_1615, or_1611, or_1607}) & (parity_1634 | parity_1649));
  logic or_1707;
  assign or_1707 = (parity_1679 & parity_1694) | ((^{or_1661, or_1657, and_1653}) & (parity_1679 | parity_1694));
  logic or_1714;
  assign or_1714 = (or_1611 & or_1615) | (or_1607 & (or_1611 | or_1615));
  logic or_1718;
  assign or_1718 = (or_1627 & or_1631) | (or_1623 & (or_1627 | or_1631));
  logic or_1722;
  assign or_1722 = (or_1642 & or_1646) | (or_1638 & (or_1642 | or_1646));
  // hls/stages/agreement.hpp:480
  logic parity_1725;
  assign parity_1725 = ^{or_1722, or_1718, or_1714};
  // hls/stages/agreement.hpp:481
  logic or_1729;
  assign or_1729 = (or_1657 & or_1661) | (and_1653 & (or_1657 | or_1661));
  logic or_1733;
  assign or_1733 = (or_1672 & or_1676) | (or_1668 & (or_1672 | or_1676));
  logic or_1737;
  assign or_1737 = (or_1687 & or_1691) | (or_1683 & (or_1687 | or_1691));
  // hls/stages/agreement.hpp:480
  logic parity_1740;
  assign parity_1740 = ^{or_1737, or_1733, or_1729};
  logic parity_1743;
  assign parity_1743 = ^{or_1737, or_1733, or_1729, or_1722, or_1718, or_1714, or_1707, or_1703, and_1699};
  // hls/stages/agreement.hpp:481
  logic or_1747;
  assign or_1747 = (parity_1725 & parity_1740) | ((^{or_1707, or_1703, and_1699}) & (parity_1725 | parity_1740));
  logic or_1751;
  assign or_1751 = (or_1703 & or_1707) | (and_1699 & (or_1703 | or_1707));
  logic or_1755;
  assign or_1755 = (or_1718 & or_1722) | (or_1714 & (or_1718 | or_1722));
  logic or_1759;
  assign or_1759 = (or_1733 & or_1737) | (or_1729 & (or_1733 | or_1737));
  // hls/stages/agreement.hpp:480
  logic parity_1764;
  assign parity_1764 = ^{or_1759, or_1755, or_1751, or_1747};
  // hls/stages/agreement.hpp:481
  logic or_1768;
  assign or_1768 = (or_1755 & or_1759) | (or_1751 & (or_1755 | or_1759));
  logic and_1769;
  assign and_1769 = or_1747 & (^{or_1759, or_1755, or_1751});
  // hls/stages/agreement.hpp:480
  logic xor_1770;
  assign xor_1770 = or_1768 ^ and_1769;
  // hls/stages/agreement.hpp:483
  logic and_1771;
  assign and_1771 = or_1768 & and_1769;
  // hls/stages/agreement.hpp:554
  logic [5:0] select_1772;
  assign select_1772 = equal_432_s1_q ? {and_1771, xor_1770, parity_1764, parity_1743, xor_1698, xor_1603} : 6'h0;
  logic [5:0] column_6;
  assign column_6 = or_430_s1_q ? 6'h0 : select_1772;
  // hls/stages/agreement.hpp:586
  logic [5:0] select_1774;
  assign select_1774 = age_s1_q[3] ? sums_3_columns_values_6_q : 6'h0;
  logic [6:0] difference_1775;
  assign difference_1775 = {1'b0, column_6} - {1'b0, select_1774};
  logic [7:0] sum_1777;
  assign sum_1777 = {difference_1775[6], difference_1775} + (age_s1_q[0] ? sums_3_sum_sums_values_0_q : 8'h0);
  // hls/stages/agreement.hpp:720
  logic [5:0] shift;
  assign shift = slot_s1_q[2] ? best_left_rdata_q[5:0] : best_left_rdata_q[45:40];
  // hls/stages/agreement.hpp:721
  logic [6:0] sum_1835;
  assign sum_1835 = x_s1_q[6:0] + {shift[5], shift};
  // hls/stages/agreement.hpp:724
  logic and_1855;
  assign and_1855 = (or_430_s1_q & (left_rdata_q[61] & not_438_s1_q)) & not_1854_s1_q;
  // hls/stages/agreement.hpp:182
  logic or_1877;
  assign or_1877 = (cfg_nearer_below_i & shift[5]) | (cfg_nearer_above_i & ($signed(6'h0) < $signed(shift)));
  // hls/stages/agreement.hpp:211
  logic [6:0] select_1888;
  assign select_1888 = so_s1_q ? x_s1_q[6:0] : (or_430_s1_q ? (less_437_s1_q ? 7'h0 : sum_1835) : 7'h0);

  // Memory averager_memory, 320 x 26 and parity, DISTANCE 16, hls/stages/census.hpp:146; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [26:0] averager_memory_mem [0:319];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 320; i++) averager_memory_mem[i] = 27'h0;
`endif
  logic [8:0] averager_memory_raddr;
  assign averager_memory_raddr = select_376_s1_q;
  logic averager_memory_re;
  assign averager_memory_re = s1_en & and_384;
  logic [26:0] averager_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (averager_memory_re) averager_memory_word_q <= averager_memory_mem[averager_memory_raddr];
  end
  logic [25:0] averager_memory_rdata_q;
  assign averager_memory_rdata_q = averager_memory_word_q[25:0];
  logic averager_memory_read_q, averager_memory_error;
  always_ff @(posedge clk_i) averager_memory_read_q <= rst_ni & averager_memory_re;
  assign averager_memory_error = averager_memory_read_q & ^averager_memory_word_q;

  // Memory best_right, 80 x 29 and parity, DISTANCE 12, hls/stages/agreement.hpp:1075; read in stage 1, written in stage 2: 1 < 2 < 1 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [29:0] best_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) best_right_mem[i] = 30'h0;
`endif
  logic [6:0] best_right_raddr;
  assign best_right_raddr = or_430_s1_q ? sum_1835 : right_s1_q;
  logic best_right_re;
  assign best_right_re = s1_en & select_551_s1_q;
  logic [29:0] best_right_word_q;
  always_ff @(posedge clk_i) begin
    if (best_right_re) best_right_word_q <= best_right_mem[best_right_raddr];
  end
  logic [28:0] best_right_rdata_q;
  assign best_right_rdata_q = best_right_word_q[28:0];
  logic best_right_read_q, best_right_error;
  always_ff @(posedge clk_i) best_right_read_q <= rst_ni & best_right_re;
  assign best_right_error = best_right_read_q & ^best_right_word_q;

  // Memory left, write
  logic [6:0] left_waddr;
  assign left_waddr = x_s1_q[6:0];
  logic left_we;
  assign left_we = s1_en & and_441_s1_q;
  logic [76:0] left_wdata;
  assign left_wdata = {and_533, left_rdata_q[59:45], and_532, left_rdata_q[43:29], and_531, left_rdata_q[27:13], and_530, left_rdata_q[11:0], fresh_rdata_q[28:26], fresh_rdata_q[24], fresh_rdata_q[11:0]};
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
  assign right_codes_we = s1_en & and_441_s1_q;
  logic [90:0] right_codes_wdata;
  assign right_codes_wdata = {and_542, right_codes_rdata_q[76:65], and_541, right_codes_rdata_q[63:52], and_540, right_codes_rdata_q[50:39], and_539, right_codes_rdata_q[37:26], and_538, right_codes_rdata_q[24:13], and_537, right_codes_rdata_q[11:0], fresh_rdata_q[25], fresh_rdata_q[23:12]};
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
      middle_sum_sum_sums_values_0_q <= sum_813;
      sums_0_columns_values_0_q <= column_3;
      sums_0_columns_values_1_q <= sums_0_columns_values_0_q;
      sums_0_columns_values_2_q <= sums_0_columns_values_1_q;
      sums_0_columns_values_3_q <= sums_0_columns_values_2_q;
      sums_0_columns_values_4_q <= sums_0_columns_values_3_q;
      sums_0_columns_values_5_q <= sums_0_columns_values_4_q;
      sums_0_columns_values_6_q <= sums_0_columns_values_5_q;
      sums_0_sum_sums_values_0_q <= sum_1053;
      sums_1_columns_values_0_q <= column_4;
      sums_1_columns_values_1_q <= sums_1_columns_values_0_q;
      sums_1_columns_values_2_q <= sums_1_columns_values_1_q;
      sums_1_columns_values_3_q <= sums_1_columns_values_2_q;
      sums_1_columns_values_4_q <= sums_1_columns_values_3_q;
      sums_1_columns_values_5_q <= sums_1_columns_values_4_q;
      sums_1_columns_values_6_q <= sums_1_columns_values_5_q;
      sums_1_sum_sums_values_0_q <= sum_1293;
      sums_2_columns_values_0_q <= column_5;
      sums_2_columns_values_1_q <= sums_2_columns_values_0_q;
      sums_2_columns_values_2_q <= sums_2_columns_values_1_q;
      sums_2_columns_values_3_q <= sums_2_columns_values_2_q;
      sums_2_columns_values_4_q <= sums_2_columns_values_3_q;
      sums_2_columns_values_5_q <= sums_2_columns_values_4_q;
      sums_2_columns_values_6_q <= sums_2_columns_values_5_q;
      sums_2_sum_sums_values_0_q <= sum_1537;
      sums_3_columns_values_0_q <= column_6;
      sums_3_columns_values_1_q <= sums_3_columns_values_0_q;
      sums_3_columns_values_2_q <= sums_3_columns_values_1_q;
      sums_3_columns_values_3_q <= sums_3_columns_values_2_q;
      sums_3_columns_values_4_q <= sums_3_columns_values_3_q;
      sums_3_columns_values_5_q <= sums_3_columns_values_4_q;
      sums_3_columns_values_6_q <= sums_3_columns_values_5_q;
      sums_3_sum_sums_values_0_q <= sum_1777;
    end
  end

  logic [7:0] pixel_0_s2_q;
  logic [7:0] pixel_1_s2_q;
  logic saturated_s2_q;
  logic mask_s2_q;
  logic marks_first_s2_q;
  logic marks_last_s2_q;
  logic sample_pair_first_s2_q;
  logic sample_pair_whole_s2_q;
  logic sample_present_s2_q;
  logic sample_of_skin_s2_q;
  logic [5:0] run_shift_s2_q;
  logic [7:0] x_s2_q;
  logic [1:0] age_s2_q;
  logic [2:0] slot_s2_q;
  logic ends_cell_s2_q;
  logic lower_half_s2_q;
  logic select_370_s2_q;
  logic [8:0] select_376_s2_q;
  logic and_383_s2_q;
  logic and_384_s2_q;
  logic equal_389_s2_q;
  logic [6:0] column_s2_q;
  logic and_407_s2_q;
  logic and_409_s2_q;
  logic equal_412_s2_q;
  logic so_s2_q;
  logic equal_429_s2_q;
  logic or_430_s2_q;
  logic less_437_s2_q;
  logic not_438_s2_q;
  logic equal_467_s2_q;
  logic equal_470_s2_q;
  logic select_472_s2_q;
  logic [6:0] x_s2_2_q;
  logic [45:0] best_left_rdata_s2_q;
  logic select_558_s2_q;
  logic and_1833_s2_q;
  logic [6:0] right_s2_q;
  logic select_1840_s2_q;
  logic equal_1849_s2_q;
  logic and_1856_s2_q;
  logic and_1859_s2_q;
  logic and_1863_s2_q;
  logic or_1877_s2_q;
  logic [6:0] select_1888_s2_q;
  logic [1:0] sum_1900_s2_q;
  logic less_1932_s2_q;
  logic equal_1948_s2_q;
  logic [8:0] select_1955_s2_q;
  logic and_1985_s2_q;
  logic less_2005_s2_q;
  logic [7:0] select_2216_s2_q;
  logic [7:0] select_2270_s2_q;
  logic [7:0] select_2559_s2_q;
  logic [7:0] select_2582_s2_q;
  logic [6:0] select_2591_s2_q;
  logic select_2592_s2_q;
  logic equal_2620_s2_q;
  logic and_2757_s2_q;
  logic equal_2945_s2_q;
  logic equal_2999_s2_q;
  logic and_3188_s2_q;
  logic and_3190_s2_q;
  logic less_3296_s2_q;
  logic equal_3493_s2_q;
  always_ff @(posedge clk_i) begin
    if (s1_en) begin
      pixel_0_s2_q <= pixel_0_s1_q;
      pixel_1_s2_q <= pixel_1_s1_q;
      saturated_s2_q <= saturated_s1_q;
      mask_s2_q <= sample_of_skin_q;
      marks_first_s2_q <= sample_pair_first_q;
      marks_last_s2_q <= sample_last_q;
      sample_pair_first_s2_q <= sample_pair_first_s1_q;
      sample_pair_whole_s2_q <= sample_pair_whole_s1_q;
      sample_present_s2_q <= sample_present_s1_q;
      sample_of_skin_s2_q <= sample_of_skin_s1_q;
      run_shift_s2_q <= run_shift_s1_q;
      x_s2_q <= x_s1_q;
      age_s2_q <= age_s1_q[2:1];
      slot_s2_q <= slot_s1_q;
      ends_cell_s2_q <= ends_cell_s1_q;
      lower_half_s2_q <= lower_half_s1_q;
      select_370_s2_q <= select_370_s1_q;
      select_376_s2_q <= select_376_s1_q;
      and_383_s2_q <= and_383_s1_q;
      and_384_s2_q <= and_384;
      equal_389_s2_q <= equal_389_s1_q;
      column_s2_q <= column_s1_q;
      and_407_s2_q <= and_407_s1_q;
      and_409_s2_q <= and_409_s1_q;
      equal_412_s2_q <= equal_412_s1_q;
      so_s2_q <= so_s1_q;
      equal_429_s2_q <= equal_429_s1_q;
      or_430_s2_q <= or_430_s1_q;
      less_437_s2_q <= less_437_s1_q;
      not_438_s2_q <= not_438_s1_q;
      equal_467_s2_q <= equal_467_s1_q;
      equal_470_s2_q <= equal_470_s1_q;
      select_472_s2_q <= select_472_s1_q;
      x_s2_2_q <= x_s1_2_q;
      best_left_rdata_s2_q <= best_left_rdata_q;
      select_558_s2_q <= select_558_s1_q;
      and_1833_s2_q <= and_1833_s1_q;
      right_s2_q <= right_s1_q;
      select_1840_s2_q <= select_1840_s1_q;
      equal_1849_s2_q <= equal_1849_s1_q;
      and_1856_s2_q <= not_438_s1_q & and_1855;
      and_1859_s2_q <= (or_430_s1_q & (left_rdata_q[62] & not_438_s1_q)) & and_1855;
      and_1863_s2_q <= not_438_s1_q & (or_430_s1_q & (left_rdata_q[63] & not_438_s1_q));
      or_1877_s2_q <= or_1877;
      select_1888_s2_q <= select_1888;
      sum_1900_s2_q <= sum_1900_s1_q;
      less_1932_s2_q <= less_1932_s1_q;
      equal_1948_s2_q <= equal_1948_s1_q;
      select_1955_s2_q <= select_1955_s1_q;
      and_1985_s2_q <= and_1985_s1_q;
      less_2005_s2_q <= less_2005_s1_q;
      select_2216_s2_q <= select_2216_s1_q;
      select_2270_s2_q <= select_2270_s1_q;
      select_2559_s2_q <= select_2559_s1_q;
      select_2582_s2_q <= select_2582_s1_q;
      select_2591_s2_q <= select_2591_s1_q;
      select_2592_s2_q <= select_2592_s1_q;
      equal_2620_s2_q <= equal_2620_s1_q;
      and_2757_s2_q <= and_2757_s1_q;
      equal_2945_s2_q <= equal_2945_s1_q;
      equal_2999_s2_q <= equal_2999_s1_q;
      and_3188_s2_q <= and_3188_s1_q;
      and_3190_s2_q <= and_3190_s1_q;
      less_3296_s2_q <= less_3296_s1_q;
      equal_3493_s2_q <= equal_3493_s1_q;
    end
  end

  // Stage 2 -----------------------------------------------------------------------------------------------------------
  logic [7:0] left_pixel_q;
  logic [7:0] sample_pair_pixel_0_q;
  logic [7:0] sample_pair_pixel_1_q;
  logic [11:0] averager_running_0_q;
  logic [11:0] averager_running_1_q;
  logic averager_running_mask_q;
  logic averager_running_of_skin_q;
  logic averager_mask_q;
  logic averager_of_skin_q;
  logic [9:0] registration_displacement_over_q;
  logic [4:0] registration_displacement_fraction_q;
  // hls/stages/census.hpp:91
  logic [11:0] select_387;
  assign select_387 = select_370_s2_q ? ({4'h0, sample_pair_pixel_0_q} + averager_running_0_q) : {4'h0, sample_pair_pixel_0_q};
  // hls/stages/census.hpp:100
  logic [11:0] sum_391;
  assign sum_391 = select_387 + (equal_389_s2_q ? 12'h0 : averager_memory_rdata_q[11:0]);
  // hls/stages/census.hpp:91
  logic [11:0] sum_393;
  assign sum_393 = {4'h0, sample_pair_pixel_1_q} + (select_370_s2_q ? averager_running_1_q : 12'h0);
  // hls/stages/census.hpp:100
  logic [11:0] sum_395;
  assign sum_395 = sum_393 + (equal_389_s2_q ? 12'h0 : averager_memory_rdata_q[23:12]);
  // hls/stages/agreement.hpp:213
  logic whole;
  assign whole = select_370_s2_q ? (sample_present_s2_q & averager_running_mask_q) : sample_present_s2_q;
  // hls/stages/census.hpp:101
  logic and_399;
  assign and_399 = whole & (averager_memory_rdata_q[24] | equal_389_s2_q);
  // hls/stages/agreement.hpp:213
  logic all_of_skin;
  assign all_of_skin = select_370_s2_q ? (sample_of_skin_s2_q & averager_running_of_skin_q) : sample_of_skin_s2_q;
  // hls/stages/census.hpp:102
  logic and_403;
  assign and_403 = all_of_skin & (averager_memory_rdata_q[25] | equal_389_s2_q);
  // hls/stages/census.hpp:126
  logic [8:0] grey;
  assign grey = and_383_s2_q ? sum_391[11:3] : 9'h0;
  logic [8:0] grey_2;
  assign grey_2 = and_383_s2_q ? sum_395[11:3] : 9'h0;
  logic and_420;
  assign and_420 = and_383_s2_q & and_399;
  // hls/stages/census.hpp:105
  logic select_422;
  assign select_422 = equal_412_s2_q ? and_420 : (averager_mask_q & and_420);
  // hls/stages/agreement.hpp:215
  logic whole_2;
  assign whole_2 = sample_pair_whole_s2_q & select_422;
  // hls/stages/census.hpp:126
  logic and_424;
  assign and_424 = and_383_s2_q & and_403;
  // hls/stages/census.hpp:105
  logic select_426;
  assign select_426 = equal_412_s2_q ? and_424 : (averager_of_skin_q & and_424);
  // hls/stages/agreement.hpp:596
  logic not_560;
  assign not_560 = ~($signed(run_shift_s2_q) < $signed($unsigned(cfg_shift_lowest_i)));
  logic less_561;
  assign less_561 = $signed($unsigned(cfg_shift_highest_i)) < $signed(run_shift_s2_q);
  // hls/stages/agreement.hpp:178
  logic and_563;
  assign and_563 = not_560 & (~less_561);
  // hls/stages/agreement.hpp:558
  logic less_1294;
  assign less_1294 = sums_0_sum_sums_values_0_q < sums_1_sum_sums_values_0_q;
  logic [7:0] select_1295;
  assign select_1295 = less_1294 ? sums_1_sum_sums_values_0_q : sums_0_sum_sums_values_0_q;
  logic less_1296;
  assign less_1296 = middle_sum_sum_sums_values_0_q < select_1295;
  logic [7:0] select_1297;
  assign select_1297 = less_1296 ? select_1295 : middle_sum_sum_sums_values_0_q;
  logic less_1778;
  assign less_1778 = sums_2_sum_sums_values_0_q < sums_3_sum_sums_values_0_q;
  logic [7:0] select_1779;
  assign select_1779 = less_1778 ? sums_3_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic less_1780;
  assign less_1780 = select_1297 < select_1779;
  logic [7:0] select_1781;
  assign select_1781 = less_1780 ? select_1779 : select_1297;
  // hls/stages/agreement.hpp:600
  logic [7:0] of_best;
  assign of_best = and_563 ? select_1781 : 8'h0;
  // hls/stages/agreement.hpp:607
  logic or_1784;
  assign or_1784 = select_558_s2_q | (best_left_rdata_s2_q[16:9] < of_best);
  // hls/stages/agreement.hpp:612
  logic [5:0] select_1785;
  assign select_1785 = or_1784 ? run_shift_s2_q : best_left_rdata_s2_q[5:0];
  // hls/stages/agreement.hpp:559
  logic or_1787;
  assign or_1787 = less_1294 | (~less_1296);
  logic [2:0] select_1788;
  assign select_1788 = less_1780 ? {less_1778, 2'h0} : {1'b0, or_1787, less_1296};
  // hls/stages/agreement.hpp:612
  logic [2:0] select_1789;
  assign select_1789 = or_1784 ? select_1788 : best_left_rdata_s2_q[8:6];
  logic [7:0] select_1790;
  assign select_1790 = or_1784 ? of_best : best_left_rdata_s2_q[16:9];
  // hls/stages/agreement.hpp:609
  logic equal_1791;
  assign equal_1791 = select_1788 == 3'h1;
  logic equal_1792;
  assign equal_1792 = select_1788 == 3'h2;
  logic not_1793;
  assign not_1793 = ~equal_1792;
  logic [1:0] select_1794;
  assign select_1794 = equal_1791 ? 2'h0 : {not_1793, equal_1792};
  logic [7:0] select_1795;
  assign select_1795 = select_1794[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1796;
  assign select_1796 = select_1794[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  // hls/stages/agreement.hpp:612
  logic [7:0] select_1798;
  assign select_1798 = or_1784 ? (select_1794[1] ? select_1795 : select_1796) : best_left_rdata_s2_q[24:17];
  // hls/stages/agreement.hpp:610
  logic [2:0] select_1799;
  assign select_1799 = equal_1791 ? 3'h2 : {not_1793, {2{equal_1792}}};
  logic [7:0] select_1800;
  assign select_1800 = select_1799[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_1802;
  assign select_1802 = select_1799[1] ? select_1800 : (select_1799[0] ? select_1781 : sums_3_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:612
  logic [7:0] select_1804;
  assign select_1804 = or_1784 ? (select_1799[2] ? sums_3_sum_sums_values_0_q : select_1802) : best_left_rdata_s2_q[32:25];
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v;
  assign before_v = age_s2_q[0] ? middle_sum_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1806;
  assign sum_1806 = {1'b0, middle_sum_columns_values_2_q} + {1'b0, middle_sum_columns_values_3_q};
  logic [6:0] sum_1807;
  assign sum_1807 = {1'b0, before_v} + sum_1806;
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v_2;
  assign before_v_2 = age_s2_q[0] ? sums_0_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1809;
  assign sum_1809 = {1'b0, sums_0_columns_values_2_q} + {1'b0, sums_0_columns_values_3_q};
  logic [6:0] sum_1810;
  assign sum_1810 = {1'b0, before_v_2} + sum_1809;
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v_3;
  assign before_v_3 = age_s2_q[0] ? sums_1_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1812;
  assign sum_1812 = {1'b0, sums_1_columns_values_2_q} + {1'b0, sums_1_columns_values_3_q};
  logic [6:0] sum_1813;
  assign sum_1813 = {1'b0, before_v_3} + sum_1812;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1815;
  assign select_1815 = (sum_1810 < sum_1813) ? sum_1813 : sum_1810;
  logic [6:0] select_1817;
  assign select_1817 = (sum_1807 < select_1815) ? select_1815 : sum_1807;
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v_4;
  assign before_v_4 = age_s2_q[0] ? sums_2_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1819;
  assign sum_1819 = {1'b0, sums_2_columns_values_2_q} + {1'b0, sums_2_columns_values_3_q};
  logic [6:0] sum_1820;
  assign sum_1820 = {1'b0, before_v_4} + sum_1819;
  // hls/stages/agreement.hpp:587
  logic [5:0] before_v_5;
  assign before_v_5 = age_s2_q[0] ? sums_3_columns_values_4_q : 6'h0;
  // hls/stages/agreement.hpp:588
  logic [6:0] sum_1822;
  assign sum_1822 = {1'b0, sums_3_columns_values_2_q} + {1'b0, sums_3_columns_values_3_q};
  logic [6:0] sum_1823;
  assign sum_1823 = {1'b0, before_v_5} + sum_1822;
  // hls/stages/agreement.hpp:558
  logic [6:0] select_1825;
  assign select_1825 = (sum_1820 < sum_1823) ? sum_1823 : sum_1820;
  logic [6:0] select_1827;
  assign select_1827 = (select_1817 < select_1825) ? select_1825 : select_1817;
  // hls/stages/agreement.hpp:601
  logic [6:0] of_near;
  assign of_near = and_563 ? select_1827 : 7'h0;
  // hls/stages/agreement.hpp:612
  logic or_1830;
  assign or_1830 = select_558_s2_q | (best_left_rdata_s2_q[39:33] < of_near);
  // hls/stages/agreement.hpp:616
  logic [6:0] select_1831;
  assign select_1831 = or_1830 ? of_near : best_left_rdata_s2_q[39:33];
  logic [5:0] select_1832;
  assign select_1832 = or_1830 ? run_shift_s2_q : best_left_rdata_s2_q[45:40];
  // hls/stages/agreement.hpp:621
  logic or_1842;
  assign or_1842 = select_1840_s2_q | (best_right_rdata_q[7:0] < of_best);
  // hls/stages/agreement.hpp:625
  logic [7:0] select_1843;
  assign select_1843 = or_1842 ? of_best : best_right_rdata_q[7:0];
  logic [6:0] select_1844;
  assign select_1844 = or_1842 ? x_s2_2_q : best_right_rdata_q[14:8];
  logic or_1846;
  assign or_1846 = select_1840_s2_q | (best_right_rdata_q[21:15] < of_near);
  // hls/stages/agreement.hpp:629
  logic [6:0] select_1847;
  assign select_1847 = or_1846 ? of_near : best_right_rdata_q[21:15];
  logic [6:0] select_1848;
  assign select_1848 = or_1846 ? x_s2_2_q : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:747
  logic not_1850;
  assign not_1850 = ~equal_1849_s2_q;
  // hls/stages/agreement.hpp:182
  logic and_1860;
  assign and_1860 = not_438_s2_q & and_1859_s2_q;
  // hls/stages/agreement.hpp:727
  logic select_1866;
  assign select_1866 = slot_s2_q[2] ? (8'hb6 < best_left_rdata_s2_q[16:9]) : (6'h2a < best_left_rdata_s2_q[39:34]);
  // hls/stages/agreement.hpp:728
  logic [6:0] chosen;
  assign chosen = slot_s2_q[2] ? best_right_rdata_q[14:8] : best_right_rdata_q[28:22];
  // hls/stages/agreement.hpp:734
  logic [8:0] difference_1869;
  assign difference_1869 = {2'h0, chosen} - {1'b0, x_s2_q};
  // hls/stages/agreement.hpp:735
  logic [9:0] sum_1870;
  assign sum_1870 = {difference_1869[8], difference_1869} + 10'h1;
  // hls/stages/agreement.hpp:182
  logic and_1872;
  assign and_1872 = (and_1859_s2_q & select_1866) & ({{22{sum_1870[9]}}, sum_1870} < 32'h3);
  logic and_1873;
  assign and_1873 = not_438_s2_q & and_1872;
  logic and_1879;
  assign and_1879 = not_438_s2_q & (and_1872 & or_1877_s2_q);
  // hls/stages/agreement.hpp:191
  logic [8:0] select_1880;
  assign select_1880 = less_437_s2_q ? 9'h0 : best_left_rdata_s2_q[8:0];
  logic [14:0] inside_v;
  assign inside_v = or_430_s2_q ? {select_1880, and_1879, and_1873, and_1863_s2_q, and_1860, and_1856_s2_q, not_438_s2_q} : 15'h0;
  // hls/stages/agreement.hpp:211
  logic and_1882;
  assign and_1882 = ends_cell_s2_q & inside_v[0];
  logic and_1884;
  assign and_1884 = not_1850 & (so_s2_q & and_1882);
  // hls/stages/agreement.hpp:197
  logic right_2;
  assign right_2 = inside_v[0] & less_1932_s2_q;
  // hls/stages/agreement.hpp:191
  logic [7:0] select_2012;
  assign select_2012 = or_430_s2_q ? (less_437_s2_q ? 8'h0 : best_left_rdata_s2_q[32:25]) : 8'h0;
  logic [7:0] select_2014;
  assign select_2014 = or_430_s2_q ? (less_437_s2_q ? 8'h0 : best_left_rdata_s2_q[24:17]) : 8'h0;
  // hls/stages/agreement.hpp:192
  logic [4:0] select_2016;
  assign select_2016 = so_s2_q ? {registration_displacement_fraction_q[3:0], registration_displacement_over_q[9]} : registration_displacement_fraction_q;
  // hls/stages/registration.hpp:76
  logic less_2106;
  assign less_2106 = slot_s2_q < 3'h3;
  // hls/stages/agreement.hpp:191
  logic [7:0] select_2108;
  assign select_2108 = or_430_s2_q ? (less_437_s2_q ? 8'h0 : best_left_rdata_s2_q[16:9]) : 8'h0;
  // hls/stages/registration.hpp:33
  logic [8:0] rise;
  assign rise = {1'b0, select_2012} - {1'b0, select_2014};
  // hls/stages/registration.hpp:35
  logic [7:0] select_2110;
  assign select_2110 = rise[8] ? select_2012 : select_2014;
  logic [8:0] difference_2111;
  assign difference_2111 = {1'b0, select_2108} - {1'b0, select_2110};
  // hls/stages/registration.hpp:36
  logic [7:0] wide;
  assign wide = difference_2111[8] ? 8'h0 : difference_2111[7:0];
  // hls/stages/registration.hpp:37
  logic not_2113;
  assign not_2113 = ~registration_displacement_over_q[9];
  // hls/stages/registration.hpp:39
  logic [9:0] left;
  assign left = less_2106 ? {1'b0, wide, 1'b0} : {registration_displacement_over_q[8:0], not_2113};
  // hls/stages/registration.hpp:34
  logic [7:0] xor_2115;
  assign xor_2115 = rise[7:0] ^ {8{rise[8]}};
  logic [8:0] size;
  assign size = {8'h0, rise[8]} + {1'b0, xor_2115};
  // hls/stages/registration.hpp:40
  logic [8:0] taken;
  assign taken = ~(({wide, 1'b0} < size) ? {wide, 1'b0} : size);
  logic [7:0] select_2121;
  assign select_2121 = registration_displacement_over_q[9] ? wide : (~wide);
  logic [9:0] taken_2;
  assign taken_2 = less_2106 ? {taken, 1'b1} : {not_2113, select_2121, not_2113};
  // hls/stages/registration.hpp:42
  logic [10:0] sum_2123;
  assign sum_2123 = {left, 1'b1} + {taken_2, less_2106};
  // hls/stages/registration.hpp:250
  logic [7:0] select_2148;
  assign select_2148 = select_1955_s2_q[0] ? sums_1_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_2149;
  assign select_2149 = select_1955_s2_q[0] ? sums_0_sum_sums_values_0_q : sums_2_sum_sums_values_0_q;
  logic [6:0] select_2151;
  assign select_2151 = select_1955_s2_q[0] ? {4'h0, select_1788} : select_1827;
  logic [7:0] select_2153;
  assign select_2153 = select_1955_s2_q[1] ? {1'b0, select_2151} : (select_1955_s2_q[0] ? select_1781 : sums_3_sum_sums_values_0_q);
  logic [7:0] select_2154;
  assign select_2154 = select_1955_s2_q[2] ? (select_1955_s2_q[1] ? select_2148 : select_2149) : select_2153;
  logic [7:0] select_2157;
  assign select_2157 = select_1955_s2_q[0] ? sums_2_sum_sums_values_0_q : sums_1_sum_sums_values_0_q;
  logic [7:0] select_2158;
  assign select_2158 = select_1955_s2_q[0] ? sums_0_sum_sums_values_0_q : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_2160;
  assign select_2160 = select_1955_s2_q[2] ? (select_1955_s2_q[1] ? select_2157 : select_2158) : select_2153;
  logic [5:0] select_2161;
  assign select_2161 = select_1955_s2_q[0] ? sums_3_columns_values_6_q : sums_3_columns_values_5_q;
  logic [5:0] select_2162;
  assign select_2162 = select_1955_s2_q[0] ? sums_3_columns_values_4_q : sums_3_columns_values_3_q;
  logic [5:0] select_2163;
  assign select_2163 = select_1955_s2_q[1] ? select_2161 : select_2162;
  logic [5:0] select_2164;
  assign select_2164 = select_1955_s2_q[0] ? sums_3_columns_values_2_q : sums_3_columns_values_1_q;
  logic [7:0] select_2165;
  assign select_2165 = select_1955_s2_q[0] ? {2'h0, sums_3_columns_values_0_q} : sums_2_sum_sums_values_0_q;
  logic [7:0] select_2167;
  assign select_2167 = select_1955_s2_q[2] ? {2'h0, select_2163} : (select_1955_s2_q[1] ? {2'h0, select_2164} : select_2165);
  logic [5:0] select_2169;
  assign select_2169 = select_1955_s2_q[0] ? sums_2_columns_values_6_q : sums_2_columns_values_5_q;
  logic [5:0] select_2170;
  assign select_2170 = select_1955_s2_q[0] ? sums_2_columns_values_4_q : sums_2_columns_values_3_q;
  logic [5:0] select_2171;
  assign select_2171 = select_1955_s2_q[1] ? select_2169 : select_2170;
  logic [5:0] select_2172;
  assign select_2172 = select_1955_s2_q[0] ? sums_2_columns_values_2_q : sums_2_columns_values_1_q;
  logic [7:0] select_2173;
  assign select_2173 = select_1955_s2_q[0] ? {2'h0, sums_2_columns_values_0_q} : sums_1_sum_sums_values_0_q;
  logic [7:0] select_2175;
  assign select_2175 = select_1955_s2_q[2] ? {2'h0, select_2171} : (select_1955_s2_q[1] ? {2'h0, select_2172} : select_2173);
  logic [5:0] select_2176;
  assign select_2176 = select_1955_s2_q[0] ? sums_1_columns_values_6_q : sums_1_columns_values_5_q;
  logic [5:0] select_2177;
  assign select_2177 = select_1955_s2_q[0] ? sums_1_columns_values_4_q : sums_1_columns_values_3_q;
  logic [5:0] select_2178;
  assign select_2178 = select_1955_s2_q[1] ? select_2176 : select_2177;
  logic [5:0] select_2179;
  assign select_2179 = select_1955_s2_q[0] ? sums_1_columns_values_2_q : sums_1_columns_values_1_q;
  logic [7:0] select_2180;
  assign select_2180 = select_1955_s2_q[0] ? {2'h0, sums_1_columns_values_0_q} : sums_0_sum_sums_values_0_q;
  logic [7:0] select_2182;
  assign select_2182 = select_1955_s2_q[2] ? {2'h0, select_2178} : (select_1955_s2_q[1] ? {2'h0, select_2179} : select_2180);
  logic [7:0] select_2184;
  assign select_2184 = select_1955_s2_q[4] ? (select_1955_s2_q[3] ? select_2160 : select_2167) : (select_1955_s2_q[3] ? select_2175 : select_2182);
  logic [5:0] select_2186;
  assign select_2186 = select_1955_s2_q[0] ? sums_0_columns_values_6_q : sums_0_columns_values_5_q;
  logic [5:0] select_2187;
  assign select_2187 = select_1955_s2_q[0] ? sums_0_columns_values_4_q : sums_0_columns_values_3_q;
  logic [5:0] select_2188;
  assign select_2188 = select_1955_s2_q[1] ? select_2186 : select_2187;
  logic [5:0] select_2189;
  assign select_2189 = select_1955_s2_q[0] ? sums_0_columns_values_2_q : sums_0_columns_values_1_q;
  logic [7:0] select_2190;
  assign select_2190 = select_1955_s2_q[0] ? {2'h0, sums_0_columns_values_0_q} : middle_sum_sum_sums_values_0_q;
  logic [7:0] select_2192;
  assign select_2192 = select_1955_s2_q[2] ? {2'h0, select_2188} : (select_1955_s2_q[1] ? {2'h0, select_2189} : select_2190);
  logic [5:0] select_2193;
  assign select_2193 = select_1955_s2_q[0] ? middle_sum_columns_values_6_q : middle_sum_columns_values_5_q;
  logic [5:0] select_2194;
  assign select_2194 = select_1955_s2_q[0] ? middle_sum_columns_values_4_q : middle_sum_columns_values_3_q;
  logic [5:0] select_2196;
  assign select_2196 = select_1955_s2_q[0] ? middle_sum_columns_values_2_q : middle_sum_columns_values_1_q;
  logic [5:0] select_2197;
  assign select_2197 = select_1955_s2_q[0] ? middle_sum_columns_values_0_q : {5'h0, lower_half_s2_q};
  logic [5:0] select_2199;
  assign select_2199 = select_1955_s2_q[2] ? (select_1955_s2_q[1] ? select_2193 : select_2194) : (select_1955_s2_q[1] ? select_2196 : select_2197);
  logic [7:0] select_2217;
  assign select_2217 = select_1955_s2_q[4] ? (select_1955_s2_q[3] ? select_2192 : {2'h0, select_2199}) : select_2216_s2_q;
  logic select_2557;
  assign select_2557 = select_1955_s2_q[0] ? averager_running_of_skin_q : averager_running_mask_q;
  logic select_2558;
  assign select_2558 = select_1955_s2_q[1] ? (select_1955_s2_q[0] ? averager_of_skin_q : averager_mask_q) : select_2557;
  logic [7:0] select_2576;
  assign select_2576 = select_1955_s2_q[0] ? {4'h0, averager_running_1_q[11:8]} : averager_running_1_q[7:0];
  logic [7:0] select_2579;
  assign select_2579 = select_1955_s2_q[0] ? {4'h0, averager_running_0_q[11:8]} : averager_running_0_q[7:0];
  logic [7:0] select_2593;
  assign select_2593 = select_1955_s2_q[0] ? {7'h0, sample_pair_first_s2_q} : sample_pair_pixel_1_q;
  logic [7:0] select_2597;
  assign select_2597 = select_1955_s2_q[1] ? (select_1955_s2_q[0] ? sample_pair_pixel_0_q : 8'h0) : (select_1955_s2_q[0] ? 8'h0 : left_pixel_q);
  logic [7:0] select_2598;
  assign select_2598 = select_1955_s2_q[2] ? (select_1955_s2_q[1] ? {7'h0, select_2592_s2_q} : select_2593) : select_2597;
  // hls/stages/agreement.hpp:197
  logic textured;
  assign textured = inside_v[0] & inside_v[2];
  // hls/stages/agreement.hpp:215
  logic select_2812;
  assign select_2812 = sample_pair_whole_s2_q ? all_of_skin : averager_running_of_skin_q;
  logic select_2814;
  assign select_2814 = sample_pair_whole_s2_q ? (and_407_s2_q ? select_422 : averager_mask_q) : averager_mask_q;
  logic select_2816;
  assign select_2816 = sample_pair_whole_s2_q ? (and_407_s2_q ? select_426 : averager_of_skin_q) : averager_of_skin_q;

  // Memory census_memory, 80 x 80 and parity, DISTANCE 16, hls/stages/census.hpp:254; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [80:0] census_memory_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) census_memory_mem[i] = 81'h0;
`endif
  logic [6:0] census_memory_raddr;
  assign census_memory_raddr = column_s2_q;
  logic census_memory_re;
  assign census_memory_re = s2_en & and_409_s2_q;
  logic [80:0] census_memory_word_q;
  always_ff @(posedge clk_i) begin
    if (census_memory_re) census_memory_word_q <= census_memory_mem[census_memory_raddr];
  end
  logic [79:0] census_memory_rdata_q;
  assign census_memory_rdata_q = census_memory_word_q[79:0];
  logic census_memory_read_q, census_memory_error;
  always_ff @(posedge clk_i) census_memory_read_q <= rst_ni & census_memory_re;
  assign census_memory_error = census_memory_read_q & ^census_memory_word_q;

  // Memory shown_right, 80 x 2 and parity, DISTANCE 12, hls/stages/agreement.hpp:1076; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] shown_right_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) shown_right_mem[i] = 3'h0;
`endif
  logic [6:0] shown_right_raddr;
  assign shown_right_raddr = x_s2_q[6:0];
  logic shown_right_re;
  assign shown_right_re = s2_en & and_1884;
  logic [2:0] shown_right_word_q;
  always_ff @(posedge clk_i) begin
    if (shown_right_re) shown_right_word_q <= shown_right_mem[shown_right_raddr];
  end
  logic [1:0] shown_right_rdata_q;
  assign shown_right_rdata_q = shown_right_word_q[1:0];
  logic shown_right_read_q, shown_right_error;
  always_ff @(posedge clk_i) shown_right_read_q <= rst_ni & shown_right_re;
  assign shown_right_error = shown_right_read_q & ^shown_right_word_q;

  // Memory seen_columns, 80 x 18 and parity, DISTANCE 12, hls/stages/agreement.hpp:1100; read in stage 2, written in stage 3: 2 < 3 < 2 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [18:0] seen_columns_mem [0:79];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 80; i++) seen_columns_mem[i] = 19'h0;
`endif
  logic [6:0] seen_columns_raddr;
  assign seen_columns_raddr = x_s2_q[6:0];
  logic seen_columns_re;
  assign seen_columns_re = s2_en & and_1884;
  logic [18:0] seen_columns_word_q;
  always_ff @(posedge clk_i) begin
    if (seen_columns_re) seen_columns_word_q <= seen_columns_mem[seen_columns_raddr];
  end
  logic [17:0] seen_columns_rdata_q;
  assign seen_columns_rdata_q = seen_columns_word_q[17:0];
  logic seen_columns_read_q, seen_columns_error;
  always_ff @(posedge clk_i) seen_columns_read_q <= rst_ni & seen_columns_re;
  assign seen_columns_error = seen_columns_read_q & ^seen_columns_word_q;

  // Memory averager_memory, write
  logic [8:0] averager_memory_waddr;
  assign averager_memory_waddr = select_376_s2_q;
  logic averager_memory_we;
  assign averager_memory_we = s2_en & and_384_s2_q;
  logic [25:0] averager_memory_wdata;
  assign averager_memory_wdata = {and_403, and_399, sum_395, sum_391};
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

  // Memory best_left, write
  logic [6:0] best_left_waddr;
  assign best_left_waddr = x_s2_2_q;
  logic best_left_we;
  assign best_left_we = s2_en & and_1833_s2_q;
  logic [45:0] best_left_wdata;
  assign best_left_wdata = {select_1832, select_1831, select_1804, select_1798, select_1790, select_1789, select_1785};
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
  assign best_right_we = s2_en & and_1833_s2_q;
  logic [28:0] best_right_wdata;
  assign best_right_wdata = {select_1848, select_1847, select_1844, select_1843};
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

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sample_pair_pixel_0_q <= 8'h0;
      sample_pair_pixel_1_q <= 8'h0;
      averager_running_mask_q <= 1'b0;
      averager_running_of_skin_q <= 1'b0;
      averager_mask_q <= 1'b0;
      averager_of_skin_q <= 1'b0;
      registration_displacement_over_q <= 10'h0;
      registration_displacement_fraction_q <= 5'h0;
    end else if (s2_en) begin
      sample_pair_pixel_0_q <= pixel_0_s2_q;
      sample_pair_pixel_1_q <= pixel_1_s2_q;
      averager_running_mask_q <= sample_pair_whole_s2_q ? whole : averager_running_mask_q;
      averager_running_of_skin_q <= select_2812;
      averager_mask_q <= select_2814;
      averager_of_skin_q <= select_2816;
      registration_displacement_over_q <= so_s2_q ? sum_2123[10:1] : registration_displacement_over_q;
      registration_displacement_fraction_q <= select_2016;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    left_pixel_q = 8'h0;
    averager_running_0_q = 12'h0;
    averager_running_1_q = 12'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s2_en) begin
      left_pixel_q <= left_pixel_q;
      averager_running_0_q <= sample_pair_whole_s2_q ? select_387 : averager_running_0_q;
      averager_running_1_q <= sample_pair_whole_s2_q ? sum_393 : averager_running_1_q;
    end
  end

  logic saturated_s3_q;
  logic mask_s3_q;
  logic marks_first_s3_q;
  logic marks_last_s3_q;
  logic sample_pair_whole_s3_q;
  logic [7:0] x_s3_q;
  logic age_s3_q;
  logic [2:0] slot_s3_q;
  logic ends_cell_s3_q;
  logic lower_half_s3_q;
  logic [6:0] column_s3_q;
  logic and_407_s3_q;
  logic and_409_s3_q;
  logic [8:0] grey_s3_q;
  logic equal_412_s3_q;
  logic [8:0] grey_2_s3_q;
  logic whole_2_s3_q;
  logic and_427_s3_q;
  logic so_s3_q;
  logic equal_467_s3_q;
  logic equal_470_s3_q;
  logic select_472_s3_q;
  logic equal_1849_s3_q;
  logic not_1850_s3_q;
  logic [13:0] inside_v_s3_q;
  logic and_1884_s3_q;
  logic [6:0] select_1888_s3_q;
  logic and_1893_s3_q;
  logic [1:0] sum_1900_s3_q;
  logic right_2_s3_q;
  logic equal_1948_s3_q;
  logic [8:0] select_1955_s3_q;
  logic and_1985_s3_q;
  logic and_2006_s3_q;
  logic less_2015_s3_q;
  logic [7:0] select_2155_s3_q;
  logic [7:0] select_2184_s3_q;
  logic [7:0] select_2217_s3_q;
  logic [7:0] select_2270_s3_q;
  logic select_2558_s3_q;
  logic [7:0] select_2559_s3_q;
  logic [7:0] select_2576_s3_q;
  logic [7:0] select_2583_s3_q;
  logic [7:0] select_2599_s3_q;
  logic equal_2620_s3_q;
  logic textured_s3_q;
  logic and_2758_s3_q;
  logic equal_2945_s3_q;
  logic equal_2999_s3_q;
  logic and_3188_s3_q;
  logic and_3190_s3_q;
  logic less_3296_s3_q;
  logic equal_3493_s3_q;
  always_ff @(posedge clk_i) begin
    if (s2_en) begin
      saturated_s3_q <= saturated_s2_q;
      mask_s3_q <= mask_s2_q;
      marks_first_s3_q <= marks_first_s2_q;
      marks_last_s3_q <= marks_last_s2_q;
      sample_pair_whole_s3_q <= sample_pair_whole_s2_q;
      x_s3_q <= x_s2_q;
      age_s3_q <= age_s2_q[1];
      slot_s3_q <= slot_s2_q;
      ends_cell_s3_q <= ends_cell_s2_q;
      lower_half_s3_q <= lower_half_s2_q;
      column_s3_q <= column_s2_q;
      and_407_s3_q <= and_407_s2_q;
      and_409_s3_q <= and_409_s2_q;
      grey_s3_q <= grey;
      equal_412_s3_q <= equal_412_s2_q;
      grey_2_s3_q <= grey_2;
      whole_2_s3_q <= whole_2;
      and_427_s3_q <= sample_pair_whole_s2_q & select_426;
      so_s3_q <= so_s2_q;
      equal_467_s3_q <= equal_467_s2_q;
      equal_470_s3_q <= equal_470_s2_q;
      select_472_s3_q <= select_472_s2_q;
      equal_1849_s3_q <= equal_1849_s2_q;
      not_1850_s3_q <= not_1850;
      inside_v_s3_q <= {inside_v[14:3], inside_v[1:0]};
      and_1884_s3_q <= and_1884;
      select_1888_s3_q <= select_1888_s2_q;
      and_1893_s3_q <= not_1850 & (so_s2_q ? and_1882 : (equal_429_s2_q & inside_v[4]));
      sum_1900_s3_q <= sum_1900_s2_q;
      right_2_s3_q <= right_2;
      equal_1948_s3_q <= equal_1948_s2_q;
      select_1955_s3_q <= select_1955_s2_q;
      and_1985_s3_q <= and_1985_s2_q;
      and_2006_s3_q <= inside_v[4] & less_2005_s2_q;
      less_2015_s3_q <= select_2012 < select_2014;
      select_2155_s3_q <= select_1955_s2_q[3] ? sums_3_sum_sums_values_0_q : select_2154;
      select_2184_s3_q <= select_2184;
      select_2217_s3_q <= select_2217;
      select_2270_s3_q <= select_2270_s2_q;
      select_2558_s3_q <= select_2558;
      select_2559_s3_q <= select_2559_s2_q;
      select_2576_s3_q <= select_2576;
      select_2583_s3_q <= select_1955_s2_q[2] ? select_2579 : select_2582_s2_q;
      select_2599_s3_q <= select_1955_s2_q[3] ? {1'b0, select_2591_s2_q} : select_2598;
      equal_2620_s3_q <= equal_2620_s2_q;
      textured_s3_q <= textured;
      and_2758_s3_q <= not_1850 & and_2757_s2_q;
      equal_2945_s3_q <= equal_2945_s2_q;
      equal_2999_s3_q <= equal_2999_s2_q;
      and_3188_s3_q <= and_3188_s2_q;
      and_3190_s3_q <= and_3190_s2_q;
      less_3296_s3_q <= less_3296_s2_q;
      equal_3493_s3_q <= equal_3493_s2_q;
    end
  end

  // Stage 3 -----------------------------------------------------------------------------------------------------------
  logic [8:0] averager_quarter_1_0_q;
  logic [8:0] averager_quarter_1_1_q;
  logic [8:0] averager_quarter_2_0_q;
  logic [8:0] averager_quarter_2_1_q;
  logic [10:0] averager_total_0_q;
  logic [10:0] averager_total_1_q;
  logic [13:0] averager_detail_0_q;
  logic [13:0] averager_detail_1_q;
  logic [8:0] census_columns_values_0_cell_0_left_q;
  logic [8:0] census_columns_values_0_cell_0_right_q;
  logic census_columns_values_0_cell_0_mask_q;
  logic census_columns_values_0_cell_0_of_skin_q;
  logic [8:0] census_columns_values_0_cell_1_left_q;
  logic [8:0] census_columns_values_0_cell_1_right_q;
  logic census_columns_values_0_cell_1_mask_q;
  logic census_columns_values_0_cell_1_of_skin_q;
  logic [8:0] census_columns_values_0_cell_2_left_q;
  logic [8:0] census_columns_values_0_cell_2_right_q;
  logic census_columns_values_0_cell_2_mask_q;
  logic census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] census_columns_values_0_cell_3_left_q;
  logic [8:0] census_columns_values_0_cell_3_right_q;
  logic census_columns_values_0_cell_3_mask_q;
  logic census_columns_values_0_cell_3_of_skin_q;
  logic [8:0] census_columns_values_0_cell_4_left_q;
  logic [8:0] census_columns_values_0_cell_4_right_q;
  logic census_columns_values_0_cell_4_mask_q;
  logic census_columns_values_0_cell_4_of_skin_q;
  logic [8:0] census_columns_values_1_cell_0_left_q;
  logic [8:0] census_columns_values_1_cell_0_right_q;
  logic census_columns_values_1_cell_0_mask_q;
  logic census_columns_values_1_cell_0_of_skin_q;
  logic [8:0] census_columns_values_1_cell_1_left_q;
  logic [8:0] census_columns_values_1_cell_1_right_q;
  logic census_columns_values_1_cell_1_mask_q;
  logic census_columns_values_1_cell_1_of_skin_q;
  logic [8:0] census_columns_values_1_cell_2_left_q;
  logic [8:0] census_columns_values_1_cell_2_right_q;
  logic census_columns_values_1_cell_2_mask_q;
  logic census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] census_columns_values_1_cell_3_left_q;
  logic [8:0] census_columns_values_1_cell_3_right_q;
  logic census_columns_values_1_cell_3_mask_q;
  logic census_columns_values_1_cell_3_of_skin_q;
  logic [8:0] census_columns_values_1_cell_4_left_q;
  logic [8:0] census_columns_values_1_cell_4_right_q;
  logic census_columns_values_1_cell_4_mask_q;
  logic census_columns_values_1_cell_4_of_skin_q;
  logic [8:0] census_columns_values_2_cell_0_left_q;
  logic [8:0] census_columns_values_2_cell_0_right_q;
  logic census_columns_values_2_cell_0_mask_q;
  logic census_columns_values_2_cell_0_of_skin_q;
  logic [8:0] census_columns_values_2_cell_1_left_q;
  logic [8:0] census_columns_values_2_cell_1_right_q;
  logic census_columns_values_2_cell_1_mask_q;
  logic census_columns_values_2_cell_1_of_skin_q;
  logic [8:0] census_columns_values_2_cell_2_left_q;
  logic [8:0] census_columns_values_2_cell_2_right_q;
  logic census_columns_values_2_cell_2_mask_q;
  logic census_columns_values_2_cell_2_of_skin_q;
  logic [8:0] census_columns_values_2_cell_3_left_q;
  logic [8:0] census_columns_values_2_cell_3_right_q;
  logic census_columns_values_2_cell_3_mask_q;
  logic census_columns_values_2_cell_3_of_skin_q;
  logic [8:0] census_columns_values_2_cell_4_left_q;
  logic [8:0] census_columns_values_2_cell_4_right_q;
  logic census_columns_values_2_cell_4_mask_q;
  logic census_columns_values_2_cell_4_of_skin_q;
  logic [8:0] census_columns_values_3_cell_0_left_q;
  logic [8:0] census_columns_values_3_cell_0_right_q;
  logic census_columns_values_3_cell_0_mask_q;
  logic census_columns_values_3_cell_0_of_skin_q;
  logic [8:0] census_columns_values_3_cell_1_left_q;
  logic [8:0] census_columns_values_3_cell_1_right_q;
  logic census_columns_values_3_cell_1_mask_q;
  logic census_columns_values_3_cell_1_of_skin_q;
  logic [8:0] census_columns_values_3_cell_2_left_q;
  logic [8:0] census_columns_values_3_cell_2_right_q;
  logic census_columns_values_3_cell_2_mask_q;
  logic census_columns_values_3_cell_2_of_skin_q;
  logic [8:0] census_columns_values_3_cell_3_left_q;
  logic [8:0] census_columns_values_3_cell_3_right_q;
  logic census_columns_values_3_cell_3_mask_q;
  logic census_columns_values_3_cell_3_of_skin_q;
  logic [8:0] census_columns_values_3_cell_4_left_q;
  logic [8:0] census_columns_values_3_cell_4_right_q;
  logic census_columns_values_3_cell_4_mask_q;
  logic census_columns_values_3_cell_4_of_skin_q;
  logic [8:0] census_columns_values_4_cell_0_left_q;
  logic [8:0] census_columns_values_4_cell_0_right_q;
  logic census_columns_values_4_cell_0_mask_q;
  logic census_columns_values_4_cell_0_of_skin_q;
  logic [8:0] census_columns_values_4_cell_1_left_q;
  logic [8:0] census_columns_values_4_cell_1_right_q;
  logic census_columns_values_4_cell_1_mask_q;
  logic census_columns_values_4_cell_1_of_skin_q;
  logic [8:0] census_columns_values_4_cell_2_left_q;
  logic [8:0] census_columns_values_4_cell_2_right_q;
  logic census_columns_values_4_cell_2_mask_q;
  logic census_columns_values_4_cell_2_of_skin_q;
  logic [8:0] census_columns_values_4_cell_3_left_q;
  logic [8:0] census_columns_values_4_cell_3_right_q;
  logic census_columns_values_4_cell_3_mask_q;
  logic census_columns_values_4_cell_3_of_skin_q;
  logic [8:0] census_columns_values_4_cell_4_left_q;
  logic [8:0] census_columns_values_4_cell_4_right_q;
  logic census_columns_values_4_cell_4_mask_q;
  logic census_columns_values_4_cell_4_of_skin_q;
  logic sharpness_last_valid_q;
  logic [8:0] sharpness_last_mean_0_q;
  logic [8:0] sharpness_last_mean_1_q;
  logic sharpness_last_mask_q;
  logic sharpness_last_of_skin_q;
  logic [23:0] sharpness_sums_contrast_0_q;
  logic [23:0] sharpness_sums_contrast_1_q;
  logic [7:0] registration_slope_here_q;
  logic registration_of_right_q;
  logic registration_was_inside_q;
  logic [23:0] registration_slope_row_q;
  logic [27:0] registration_slope_change_q;
  logic [27:0] registration_slope_q;
  logic shown_shown_q;
  logic shown_nearer_q;
  logic [2:0] region_row_q;
  logic [2:0] next_region_row_q;
  logic [7:0] region_columns_q;
  logic [8:0] region_across_rest_q;
  logic [7:0] region_across_back_q;
  logic [8:0] region_across_next_q;
  logic [8:0] columns_begin_rest_q;
  logic [7:0] columns_begin_back_q;
  logic [8:0] region_down_rest_q;
  logic [6:0] region_down_back_q;
  logic [8:0] region_down_next_q;
  logic region_fresh_q;
  logic segment_starts_q;
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
  logic [17:0] rows_passed_q;
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
  // hls/stages/census.hpp:127
  logic [10:0] total;
  assign total = {2'h0, grey_s3_q} + (equal_412_s3_q ? 11'h0 : averager_total_0_q);
  // hls/stages/agreement.hpp:215
  logic [8:0] select_415;
  assign select_415 = sample_pair_whole_s3_q ? total[10:2] : 9'h0;
  // hls/stages/census.hpp:127
  logic [10:0] total_2;
  assign total_2 = {2'h0, grey_2_s3_q} + (equal_412_s3_q ? 11'h0 : averager_total_1_q);
  // hls/stages/agreement.hpp:215
  logic [8:0] select_419;
  assign select_419 = sample_pair_whole_s3_q ? total_2[10:2] : 9'h0;
  // hls/stages/census.hpp:214
  logic less_443;
  assign less_443 = census_memory_rdata_q[8:0] < census_columns_values_1_cell_2_left_q;
  logic less_444;
  assign less_444 = census_memory_rdata_q[48:40] < census_columns_values_1_cell_2_left_q;
  logic less_445;
  assign less_445 = census_columns_values_0_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_446;
  assign less_446 = census_columns_values_0_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_447;
  assign less_447 = census_columns_values_0_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_448;
  assign less_448 = census_columns_values_1_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_449;
  assign less_449 = census_columns_values_1_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  logic less_450;
  assign less_450 = census_columns_values_2_cell_0_left_q < census_columns_values_1_cell_2_left_q;
  logic less_451;
  assign less_451 = census_columns_values_2_cell_2_left_q < census_columns_values_1_cell_2_left_q;
  logic less_452;
  assign less_452 = census_columns_values_2_cell_4_left_q < census_columns_values_1_cell_2_left_q;
  logic less_453;
  assign less_453 = census_columns_values_3_cell_1_left_q < census_columns_values_1_cell_2_left_q;
  logic less_454;
  assign less_454 = census_columns_values_3_cell_3_left_q < census_columns_values_1_cell_2_left_q;
  // hls/stages/census.hpp:215
  logic less_455;
  assign less_455 = census_memory_rdata_q[17:9] < census_columns_values_1_cell_2_right_q;
  logic less_456;
  assign less_456 = census_memory_rdata_q[57:49] < census_columns_values_1_cell_2_right_q;
  logic less_457;
  assign less_457 = census_columns_values_0_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_458;
  assign less_458 = census_columns_values_0_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_459;
  assign less_459 = census_columns_values_0_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_460;
  assign less_460 = census_columns_values_1_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_461;
  assign less_461 = census_columns_values_1_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  logic less_462;
  assign less_462 = census_columns_values_2_cell_0_right_q < census_columns_values_1_cell_2_right_q;
  logic less_463;
  assign less_463 = census_columns_values_2_cell_2_right_q < census_columns_values_1_cell_2_right_q;
  logic less_464;
  assign less_464 = census_columns_values_2_cell_4_right_q < census_columns_values_1_cell_2_right_q;
  logic less_465;
  assign less_465 = census_columns_values_3_cell_1_right_q < census_columns_values_1_cell_2_right_q;
  logic less_466;
  assign less_466 = census_columns_values_3_cell_3_right_q < census_columns_values_1_cell_2_right_q;
  // hls/stages/census.hpp:206
  logic and_476;
  assign and_476 = census_memory_rdata_q[38] & (census_memory_rdata_q[18] & whole_2_s3_q);
  logic and_478;
  assign and_478 = census_memory_rdata_q[78] & (census_memory_rdata_q[58] & and_476);
  // hls/stages/agreement.hpp:310
  logic whole_3;
  assign whole_3 = census_columns_values_0_cell_0_mask_q & and_478;
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
  // hls/stages/census.hpp:190
  logic [9:0] difference_501;
  assign difference_501 = {1'b0, select_415} - {1'b0, census_columns_values_0_cell_0_left_q};
  logic [8:0] xor_502;
  assign xor_502 = difference_501[8:0] ^ {9{difference_501[9]}};
  logic [9:0] sum_503;
  assign sum_503 = {9'h0, difference_501[9]} + {1'b0, xor_502};
  logic [9:0] difference_504;
  assign difference_504 = {1'b0, census_memory_rdata_q[8:0]} - {1'b0, census_columns_values_0_cell_1_left_q};
  logic [8:0] xor_505;
  assign xor_505 = difference_504[8:0] ^ {9{difference_504[9]}};
  logic [9:0] sum_506;
  assign sum_506 = {9'h0, difference_504[9]} + {1'b0, xor_505};
  logic [9:0] difference_508;
  assign difference_508 = {1'b0, census_memory_rdata_q[28:20]} - {1'b0, census_columns_values_0_cell_2_left_q};
  logic [8:0] xor_509;
  assign xor_509 = difference_508[8:0] ^ {9{difference_508[9]}};
  logic [9:0] sum_510;
  assign sum_510 = {9'h0, difference_508[9]} + {1'b0, xor_509};
  logic [10:0] sum_511;
  assign sum_511 = ({1'b0, sum_503} + {1'b0, sum_506}) + {1'b0, sum_510};
  logic [9:0] difference_512;
  assign difference_512 = {1'b0, census_memory_rdata_q[48:40]} - {1'b0, census_columns_values_0_cell_3_left_q};
  logic [8:0] xor_513;
  assign xor_513 = difference_512[8:0] ^ {9{difference_512[9]}};
  logic [9:0] sum_514;
  assign sum_514 = {9'h0, difference_512[9]} + {1'b0, xor_513};
  logic [9:0] difference_516;
  assign difference_516 = {1'b0, census_memory_rdata_q[68:60]} - {1'b0, census_columns_values_0_cell_4_left_q};
  logic [8:0] xor_517;
  assign xor_517 = difference_516[8:0] ^ {9{difference_516[9]}};
  logic [9:0] sum_518;
  assign sum_518 = {9'h0, difference_516[9]} + {1'b0, xor_517};
  logic [11:0] texture;
  assign texture = ({1'b0, sum_511} + {2'h0, sum_514}) + {2'h0, sum_518};
  // hls/stages/agreement.hpp:139
  logic not_1889;
  assign not_1889 = ~so_s3_q;
  // hls/stages/agreement.hpp:211
  logic and_1890;
  assign and_1890 = not_1889 & inside_v_s3_q[4];
  // hls/stages/agreement.hpp:859
  logic equal_1894;
  assign equal_1894 = x_s3_q[6:4] == 3'h7;
  // hls/stages/agreement.hpp:899
  logic [1:0] quarter;
  assign quarter = x_s3_q[1:0] + 2'h1;
  // hls/stages/registration.hpp:139
  logic all;
  assign all = x_s3_q[5:3] == 3'h4;
  // hls/stages/agreement.hpp:860
  logic [1:0] select_1897;
  assign select_1897 = x_s3_q[4] ? {x_s3_q[3], x_s3_q[0]} : {x_s3_q[0], x_s3_q[3]};
  // hls/stages/agreement.hpp:872
  logic [3:0] select_1899;
  assign select_1899 = equal_1894 ? {2'h0, quarter} : (all ? {1'b0, x_s3_q[2:0]} : {x_s3_q[2:1], select_1897});
  // hls/stages/agreement.hpp:211
  logic [3:0] select_1901;
  assign select_1901 = equal_1849_s3_q ? select_1899 : {sum_1900_s3_q, lower_half_s3_q, registration_of_right_q};
  // hls/stages/agreement.hpp:897
  logic equal_1902;
  assign equal_1902 = x_s3_q[5:0] == 6'h3e;
  logic equal_1904;
  assign equal_1904 = x_s3_q[5:0] == 6'h3d;
  logic equal_1906;
  assign equal_1906 = x_s3_q[5:0] == 6'h3c;
  logic equal_1908;
  assign equal_1908 = x_s3_q[5:0] == 6'h3b;
  logic equal_1910;
  assign equal_1910 = x_s3_q[5:0] == 6'h36;
  logic equal_1912;
  assign equal_1912 = x_s3_q[5:0] == 6'h35;
  logic equal_1914;
  assign equal_1914 = x_s3_q[5:0] == 6'h34;
  // hls/stages/agreement.hpp:899
  logic and_1918;
  assign and_1918 = (~equal_1908) & ((~equal_1910) & ((~equal_1912) & (~equal_1914)));
  // hls/stages/agreement.hpp:860
  logic less_1922;
  assign less_1922 = x_s3_q[5:0] < 6'h29;
  // hls/stages/registration.hpp:140
  logic [1:0] kind;
  assign kind = all ? {1'b0, x_s3_q[2]} : x_s3_q[2:1];
  // hls/stages/registration.hpp:152
  logic or_1926;
  assign or_1926 = (kind == 2'h3) | (x_s3_q[5:3] == 3'h5);
  // hls/stages/agreement.hpp:872
  logic select_1929;
  assign select_1929 = equal_1894 ? ((~equal_1902) & ((~equal_1904) & ((~equal_1906) & and_1918))) : (less_1922 & (~or_1926));
  // hls/stages/registration.hpp:94
  logic half_ends;
  assign half_ends = inside_v_s3_q[0] ? (right_2_s3_q & (~registration_of_right_q)) : registration_was_inside_q;
  // hls/stages/registration.hpp:106
  logic [4:0] sum_1937;
  assign sum_1937 = {2'h0, slot_s3_q} + 5'h1f;
  logic and_1939;
  assign and_1939 = half_ends & ({{3{sum_1937[4]}}, sum_1937} < 8'h3);
  // hls/stages/agreement.hpp:211
  logic and_1940;
  assign and_1940 = so_s3_q & and_1939;
  // hls/stages/agreement.hpp:143
  logic or_1956;
  assign or_1956 = segment_starts_q | not_1889;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1962;
  assign select_1962 = select_1955_s3_q[0] ? {8{region_down_next_q[8]}} : region_down_next_q[7:0];
  // hls/stages/division.hpp:34
  logic [7:0] sum_1963;
  assign sum_1963 = region_down_rest_q[8:1] + 8'h3;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1964;
  assign sum_1964 = region_down_rest_q + {{2{region_down_back_q[6]}}, region_down_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1965;
  assign select_1965 = sum_1963[7] ? {1'b1, sum_1963[6:0], region_down_rest_q[0]} : sum_1964;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1967;
  assign select_1967 = select_1955_s3_q[1] ? select_1962 : (select_1955_s3_q[0] ? {8{select_1965[8]}} : select_1965[7:0]);
  logic [5:0] select_1968;
  assign select_1968 = select_1955_s3_q[0] ? {6{region_down_back_q[6]}} : region_down_back_q[5:0];
  logic [7:0] select_1969;
  assign select_1969 = select_1955_s3_q[0] ? {8{region_down_rest_q[8]}} : region_down_rest_q[7:0];
  logic [7:0] select_1970;
  assign select_1970 = select_1955_s3_q[1] ? {{2{region_down_back_q[6]}}, select_1968} : select_1969;
  logic [6:0] select_1973;
  assign select_1973 = select_1955_s3_q[0] ? {7{columns_begin_back_q[7]}} : columns_begin_back_q[6:0];
  logic [7:0] select_1974;
  assign select_1974 = select_1955_s3_q[0] ? {8{columns_begin_rest_q[8]}} : columns_begin_rest_q[7:0];
  logic [7:0] select_1975;
  assign select_1975 = select_1955_s3_q[1] ? {columns_begin_back_q[7], select_1973} : select_1974;
  logic [7:0] select_1977;
  assign select_1977 = select_1955_s3_q[0] ? {8{region_across_next_q[8]}} : region_across_next_q[7:0];
  // hls/stages/division.hpp:34
  logic [5:0] sum_1978;
  assign sum_1978 = region_across_rest_q[8:3] + 6'h1;
  // hls/stages/division.hpp:35
  logic [8:0] sum_1979;
  assign sum_1979 = region_across_rest_q + {region_across_back_q[7], region_across_back_q};
  // hls/stages/division.hpp:36
  logic [8:0] select_1980;
  assign select_1980 = sum_1978[5] ? {1'b1, sum_1978[4:0], region_across_rest_q[2:0]} : sum_1979;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1982;
  assign select_1982 = select_1955_s3_q[1] ? select_1977 : (select_1955_s3_q[0] ? {8{select_1980[8]}} : select_1980[7:0]);
  // hls/stages/agreement.hpp:143
  logic [7:0] select_1983;
  assign select_1983 = so_s3_q ? region_across_back_q : columns_begin_back_q;
  // hls/stages/registration.hpp:250
  logic [6:0] select_1984;
  assign select_1984 = select_1955_s3_q[0] ? {7{select_1983[7]}} : select_1983[6:0];
  // hls/stages/agreement.hpp:143
  logic [8:0] select_1987;
  assign select_1987 = so_s3_q ? (and_1985_s3_q ? region_across_next_q : region_across_rest_q) : columns_begin_rest_q;
  // hls/stages/registration.hpp:250
  logic [7:0] select_1989;
  assign select_1989 = select_1955_s3_q[1] ? {select_1983[7], select_1984} : (select_1955_s3_q[0] ? {8{select_1987[8]}} : select_1987[7:0]);
  logic [7:0] select_1991;
  assign select_1991 = select_1955_s3_q[3] ? (select_1955_s3_q[2] ? 8'h0 : select_1975) : (select_1955_s3_q[2] ? select_1982 : select_1989);
  // hls/stages/agreement.hpp:143
  logic [7:0] select_1993;
  assign select_1993 = so_s3_q ? region_columns_q : 8'h1;
  // hls/stages/agreement.hpp:131
  logic [2:0] sum_1994;
  assign sum_1994 = region_row_q + 3'h1;
  // hls/stages/registration.hpp:250
  logic [2:0] select_1995;
  assign select_1995 = select_1955_s3_q[0] ? next_region_row_q : sum_1994;
  logic [2:0] select_1998;
  assign select_1998 = select_1955_s3_q[1] ? (select_1955_s3_q[0] ? region_row_q : 3'h0) : 3'h0;
  logic [7:0] select_1999;
  assign select_1999 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_1993 : {5'h0, select_1995}) : {5'h0, select_1998};
  logic and_2003;
  assign and_2003 = (select_1955_s3_q[0] ? shown_nearer_q : shown_shown_q) & (~select_1955_s3_q[1]);
  // hls/stages/registration.hpp:83
  logic equal_2004;
  assign equal_2004 = slot_s3_q == 3'h7;
  // hls/stages/registration.hpp:45
  logic [1:0] sum_2010;
  assign sum_2010 = inside_v_s3_q[13:12] + 2'h3;
  // hls/stages/registration.hpp:47
  logic [7:0] difference_2017;
  assign difference_2017 = {sum_2010, inside_v_s3_q[11], 5'h0} - {3'h0, registration_displacement_fraction_q};
  // hls/stages/registration.hpp:101
  logic [7:0] select_2018;
  assign select_2018 = less_2015_s3_q ? difference_2017 : {sum_2010, inside_v_s3_q[11], registration_displacement_fraction_q};
  logic [7:0] select_2019;
  assign select_2019 = ((inside_v_s3_q[13:11] == 3'h0) | (inside_v_s3_q[13:11] == 3'h4)) ? {sum_2010, inside_v_s3_q[11], 5'h0} : select_2018;
  // hls/stages/registration.hpp:206
  logic [16:0] select_2021;
  assign select_2021 = ($signed(registration_slope_change_q[27:18]) < $signed(10'h3ff)) ? 17'h1ff80 : registration_slope_change_q[27:11];
  logic [7:0] change;
  assign change = ($signed(10'h0) < $signed(select_2021[16:7])) ? 8'h7f : select_2021[7:0];
  // hls/stages/registration.hpp:89
  logic [7:0] a;
  assign a = equal_2004 ? registration_slope_here_q : change;
  // hls/stages/registration.hpp:199
  logic [6:0] select_2025;
  assign select_2025 = inside_v_s3_q[5] ? a[7:1] : 7'h0;
  logic [7:0] select_2026;
  assign select_2026 = inside_v_s3_q[6] ? a : 8'h0;
  logic [8:0] sum_2027;
  assign sum_2027 = {{2{select_2025[6]}}, select_2025} + {select_2026[7], select_2026};
  // hls/stages/registration.hpp:200
  logic [7:0] select_2028;
  assign select_2028 = inside_v_s3_q[7] ? a : 8'h0;
  logic [7:0] select_2029;
  assign select_2029 = inside_v_s3_q[8] ? a : 8'h0;
  logic [8:0] sum_2030;
  assign sum_2030 = {{2{select_2028[7]}}, select_2028[7:1]} + {select_2029[7], select_2029};
  // hls/stages/registration.hpp:202
  logic [10:0] sum_2031;
  assign sum_2031 = {{3{sum_2027[8]}}, sum_2027[8:1]} + {sum_2030[8], sum_2030, select_2028[0]};
  // hls/stages/registration.hpp:201
  logic [7:0] select_2032;
  assign select_2032 = inside_v_s3_q[9] ? a : 8'h0;
  logic [7:0] select_2033;
  assign select_2033 = inside_v_s3_q[10] ? a : 8'h0;
  logic [8:0] difference_2034;
  assign difference_2034 = {{2{select_2032[7]}}, select_2032[7:1]} - {select_2033[7], select_2033};
  // hls/stages/registration.hpp:202
  logic [9:0] sum_2035;
  assign sum_2035 = {difference_2034, select_2032[0]} + {sum_2031[10], sum_2031[10:2]};
  // hls/stages/registration.hpp:101
  logic [11:0] value;
  assign value = {{4{select_2019[7]}}, select_2019} - {sum_2035[9], sum_2035, sum_2031[1]};
  // hls/stages/registration.hpp:206
  logic [11:0] select_2038;
  assign select_2038 = ($signed(value[11:7]) < $signed(5'h1f)) ? 12'hf80 : value;
  logic [11:0] residual;
  assign residual = ($signed(5'h0) < $signed(select_2038[11:7])) ? 12'h7f : select_2038;
  // hls/stages/registration.hpp:250
  logic [7:0] select_2076;
  assign select_2076 = select_1955_s3_q[0] ? {{4{registration_slope_q[27]}}, registration_slope_q[27:24]} : registration_slope_q[23:16];
  logic [7:0] select_2077;
  assign select_2077 = select_1955_s3_q[0] ? registration_slope_q[15:8] : registration_slope_q[7:0];
  logic [7:0] select_2082;
  assign select_2082 = select_1955_s3_q[0] ? {{4{registration_slope_change_q[27]}}, registration_slope_change_q[27:24]} : registration_slope_change_q[23:16];
  logic [7:0] select_2083;
  assign select_2083 = select_1955_s3_q[0] ? registration_slope_change_q[15:8] : registration_slope_change_q[7:0];
  logic [7:0] select_2085;
  assign select_2085 = select_1955_s3_q[0] ? {{4{registration_slope_row_q[23]}}, registration_slope_row_q[23:20]} : registration_slope_row_q[19:12];
  logic [7:0] select_2086;
  assign select_2086 = select_1955_s3_q[0] ? registration_slope_row_q[11:4] : {registration_slope_row_q[3:0], 4'h0};
  logic [7:0] select_2088;
  assign select_2088 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2082 : select_2083) : (select_1955_s3_q[1] ? select_2085 : select_2086);
  // hls/stages/registration.hpp:106
  logic select_2089;
  assign select_2089 = equal_2004 ? inside_v_s3_q[0] : registration_was_inside_q;
  // hls/stages/registration.hpp:96
  logic [12:0] sum_2098;
  assign sum_2098 = {registration_slope_q[27], registration_slope_q[27:16]} + {{5{sum_2035[9]}}, sum_2035[9:2]};
  // hls/stages/registration.hpp:206
  logic [7:0] select_2101;
  assign select_2101 = ($signed(sum_2098[12:7]) < $signed(6'h3f)) ? 8'h80 : sum_2098[7:0];
  // hls/stages/registration.hpp:106
  logic [7:0] select_2103;
  assign select_2103 = equal_2004 ? registration_slope_here_q : (($signed(6'h0) < $signed(sum_2098[12:7])) ? 8'h7f : select_2101);
  // hls/stages/registration.hpp:250
  logic [7:0] select_2125;
  assign select_2125 = select_1955_s3_q[0] ? {6'h0, registration_displacement_over_q[9:8]} : registration_displacement_over_q[7:0];
  logic [7:0] select_2126;
  assign select_2126 = select_1955_s3_q[1] ? {3'h0, registration_displacement_fraction_q} : select_2125;
  // hls/stages/census.hpp:328
  logic less_2273;
  assign less_2273 = x_s3_q[4:0] < 5'h3;
  logic not_2274;
  assign not_2274 = ~x_s3_q[1];
  logic [2:0] select_2275;
  assign select_2275 = x_s3_q[0] ? {1'b0, not_2274, 1'b0} : {x_s3_q[1], 1'b0, not_2274};
  logic [5:0] select_2276;
  assign select_2276 = slot_s3_q[2] ? {select_2275[2], 1'b0, select_2275[1], 1'b0, select_2275[0], 1'b0} : {1'b0, select_2275[2], 1'b0, select_2275[1], 1'b0, select_2275[0]};
  logic [11:0] select_2277;
  assign select_2277 = slot_s3_q[1] ? {select_2276[5], 1'b0, select_2276[4], 1'b0, select_2276[3], 1'b0, select_2276[2], 1'b0, select_2276[1], 1'b0, select_2276[0], 1'b0} : {1'b0, select_2276[5], 1'b0, select_2276[4], 1'b0, select_2276[3], 1'b0, select_2276[2], 1'b0, select_2276[1], 1'b0, select_2276[0]};
  logic [23:0] select_2278;
  assign select_2278 = slot_s3_q[0] ? {select_2277[11], 1'b0, select_2277[10], 1'b0, select_2277[9], 1'b0, select_2277[8], 1'b0, select_2277[7], 1'b0, select_2277[6], 1'b0, select_2277[5], 1'b0, select_2277[4], 1'b0, select_2277[3], 1'b0, select_2277[2], 1'b0, select_2277[1], 1'b0, select_2277[0], 1'b0} : {1'b0, select_2277[11], 1'b0, select_2277[10], 1'b0, select_2277[9], 1'b0, select_2277[8], 1'b0, select_2277[7], 1'b0, select_2277[6], 1'b0, select_2277[5], 1'b0, select_2277[4], 1'b0, select_2277[3], 1'b0, select_2277[2], 1'b0, select_2277[1], 1'b0, select_2277[0]};
  // hls/stages/census.hpp:291
  logic and_2282;
  assign and_2282 = less_2273 & (~((sharpness_sums_contrast_0_q & select_2278) == 24'h0));
  logic and_2292;
  assign and_2292 = less_2273 & (~((sharpness_sums_contrast_1_q & select_2278) == 24'h0));
  // hls/stages/registration.hpp:250
  logic select_2379;
  assign select_2379 = select_1955_s3_q[0] ? sharpness_last_of_skin_q : sharpness_last_mask_q;
  logic [7:0] select_2380;
  assign select_2380 = select_1955_s3_q[0] ? {7'h0, sharpness_last_mean_1_q[8]} : sharpness_last_mean_1_q[7:0];
  logic [7:0] select_2382;
  assign select_2382 = select_1955_s3_q[0] ? {7'h0, sharpness_last_mean_0_q[8]} : sharpness_last_mean_0_q[7:0];
  logic [7:0] select_2383;
  assign select_2383 = select_1955_s3_q[1] ? select_2382 : {7'h0, sharpness_last_valid_q};
  logic [7:0] select_2384;
  assign select_2384 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? {7'h0, select_2379} : select_2380) : select_2383;
  logic select_2406;
  assign select_2406 = select_1955_s3_q[0] ? census_columns_values_4_cell_4_of_skin_q : census_columns_values_4_cell_4_mask_q;
  logic [7:0] select_2407;
  assign select_2407 = select_1955_s3_q[0] ? {7'h0, census_columns_values_4_cell_4_right_q[8]} : census_columns_values_4_cell_4_right_q[7:0];
  logic [7:0] select_2409;
  assign select_2409 = select_1955_s3_q[0] ? {7'h0, census_columns_values_4_cell_4_left_q[8]} : census_columns_values_4_cell_4_left_q[7:0];
  logic select_2410;
  assign select_2410 = select_1955_s3_q[0] ? census_columns_values_4_cell_3_of_skin_q : census_columns_values_4_cell_3_mask_q;
  logic [7:0] select_2412;
  assign select_2412 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? {7'h0, select_2406} : select_2407) : (select_1955_s3_q[1] ? select_2409 : {7'h0, select_2410});
  logic [7:0] select_2416;
  assign select_2416 = select_1955_s3_q[0] ? {7'h0, census_columns_values_4_cell_3_right_q[8]} : census_columns_values_4_cell_3_right_q[7:0];
  logic [7:0] select_2417;
  assign select_2417 = select_1955_s3_q[0] ? {7'h0, census_columns_values_4_cell_3_left_q[8]} : census_columns_values_4_cell_3_left_q[7:0];
  logic select_2419;
  assign select_2419 = select_1955_s3_q[0] ? census_columns_values_4_cell_2_of_skin_q : census_columns_values_4_cell_2_mask_q;
  logic [7:0] select_2420;
  assign select_2420 = select_1955_s3_q[0] ? {7'h0, census_columns_values_4_cell_2_right_q[8]} : census_columns_values_4_cell_2_right_q[7:0];
  logic [7:0] select_2422;
  assign select_2422 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2416 : select_2417) : (select_1955_s3_q[1] ? {7'h0, select_2419} : select_2420);
  logic [7:0] select_2423;
  assign select_2423 = select_1955_s3_q[0] ? {7'h0, census_columns_values_4_cell_2_left_q[8]} : census_columns_values_4_cell_2_left_q[7:0];
  logic select_2424;
  assign select_2424 = select_1955_s3_q[0] ? census_columns_values_4_cell_1_of_skin_q : census_columns_values_4_cell_1_mask_q;
  logic [7:0] select_2426;
  assign select_2426 = select_1955_s3_q[0] ? {7'h0, census_columns_values_4_cell_1_right_q[8]} : census_columns_values_4_cell_1_right_q[7:0];
  logic [7:0] select_2427;
  assign select_2427 = select_1955_s3_q[0] ? {7'h0, census_columns_values_4_cell_1_left_q[8]} : census_columns_values_4_cell_1_left_q[7:0];
  logic [7:0] select_2429;
  assign select_2429 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2423 : {7'h0, select_2424}) : (select_1955_s3_q[1] ? select_2426 : select_2427);
  logic select_2431;
  assign select_2431 = select_1955_s3_q[0] ? census_columns_values_4_cell_0_of_skin_q : census_columns_values_4_cell_0_mask_q;
  logic [7:0] select_2432;
  assign select_2432 = select_1955_s3_q[0] ? {7'h0, census_columns_values_4_cell_0_right_q[8]} : census_columns_values_4_cell_0_right_q[7:0];
  logic [7:0] select_2434;
  assign select_2434 = select_1955_s3_q[0] ? {7'h0, census_columns_values_4_cell_0_left_q[8]} : census_columns_values_4_cell_0_left_q[7:0];
  logic select_2435;
  assign select_2435 = select_1955_s3_q[0] ? census_columns_values_3_cell_4_of_skin_q : census_columns_values_3_cell_4_mask_q;
  logic [7:0] select_2437;
  assign select_2437 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? {7'h0, select_2431} : select_2432) : (select_1955_s3_q[1] ? select_2434 : {7'h0, select_2435});
  logic [7:0] select_2438;
  assign select_2438 = select_1955_s3_q[0] ? {7'h0, census_columns_values_3_cell_4_right_q[8]} : census_columns_values_3_cell_4_right_q[7:0];
  logic [7:0] select_2439;
  assign select_2439 = select_1955_s3_q[0] ? {7'h0, census_columns_values_3_cell_4_left_q[8]} : census_columns_values_3_cell_4_left_q[7:0];
  logic select_2441;
  assign select_2441 = select_1955_s3_q[0] ? census_columns_values_3_cell_3_of_skin_q : census_columns_values_3_cell_3_mask_q;
  logic [7:0] select_2442;
  assign select_2442 = select_1955_s3_q[0] ? {7'h0, census_columns_values_3_cell_3_right_q[8]} : census_columns_values_3_cell_3_right_q[7:0];
  logic [7:0] select_2444;
  assign select_2444 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2438 : select_2439) : (select_1955_s3_q[1] ? {7'h0, select_2441} : select_2442);
  logic [7:0] select_2446;
  assign select_2446 = select_1955_s3_q[4] ? (select_1955_s3_q[3] ? select_2422 : select_2429) : (select_1955_s3_q[3] ? select_2437 : select_2444);
  logic [7:0] select_2447;
  assign select_2447 = select_1955_s3_q[0] ? {7'h0, census_columns_values_3_cell_3_left_q[8]} : census_columns_values_3_cell_3_left_q[7:0];
  logic select_2448;
  assign select_2448 = select_1955_s3_q[0] ? census_columns_values_3_cell_2_of_skin_q : census_columns_values_3_cell_2_mask_q;
  logic [7:0] select_2450;
  assign select_2450 = select_1955_s3_q[0] ? {7'h0, census_columns_values_3_cell_2_right_q[8]} : census_columns_values_3_cell_2_right_q[7:0];
  logic [7:0] select_2451;
  assign select_2451 = select_1955_s3_q[0] ? {7'h0, census_columns_values_3_cell_2_left_q[8]} : census_columns_values_3_cell_2_left_q[7:0];
  logic [7:0] select_2453;
  assign select_2453 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2447 : {7'h0, select_2448}) : (select_1955_s3_q[1] ? select_2450 : select_2451);
  logic select_2454;
  assign select_2454 = select_1955_s3_q[0] ? census_columns_values_3_cell_1_of_skin_q : census_columns_values_3_cell_1_mask_q;
  logic [7:0] select_2455;
  assign select_2455 = select_1955_s3_q[0] ? {7'h0, census_columns_values_3_cell_1_right_q[8]} : census_columns_values_3_cell_1_right_q[7:0];
  logic [7:0] select_2457;
  assign select_2457 = select_1955_s3_q[0] ? {7'h0, census_columns_values_3_cell_1_left_q[8]} : census_columns_values_3_cell_1_left_q[7:0];
  logic select_2458;
  assign select_2458 = select_1955_s3_q[0] ? census_columns_values_3_cell_0_of_skin_q : census_columns_values_3_cell_0_mask_q;
  logic [7:0] select_2460;
  assign select_2460 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? {7'h0, select_2454} : select_2455) : (select_1955_s3_q[1] ? select_2457 : {7'h0, select_2458});
  logic [7:0] select_2462;
  assign select_2462 = select_1955_s3_q[0] ? {7'h0, census_columns_values_3_cell_0_right_q[8]} : census_columns_values_3_cell_0_right_q[7:0];
  logic [7:0] select_2463;
  assign select_2463 = select_1955_s3_q[0] ? {7'h0, census_columns_values_3_cell_0_left_q[8]} : census_columns_values_3_cell_0_left_q[7:0];
  logic select_2465;
  assign select_2465 = select_1955_s3_q[0] ? census_columns_values_2_cell_4_of_skin_q : census_columns_values_2_cell_4_mask_q;
  logic [7:0] select_2466;
  assign select_2466 = select_1955_s3_q[0] ? {7'h0, census_columns_values_2_cell_4_right_q[8]} : census_columns_values_2_cell_4_right_q[7:0];
  logic [7:0] select_2468;
  assign select_2468 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2462 : select_2463) : (select_1955_s3_q[1] ? {7'h0, select_2465} : select_2466);
  logic [7:0] select_2469;
  assign select_2469 = select_1955_s3_q[0] ? {7'h0, census_columns_values_2_cell_4_left_q[8]} : census_columns_values_2_cell_4_left_q[7:0];
  logic select_2470;
  assign select_2470 = select_1955_s3_q[0] ? census_columns_values_2_cell_3_of_skin_q : census_columns_values_2_cell_3_mask_q;
  logic [7:0] select_2472;
  assign select_2472 = select_1955_s3_q[0] ? {7'h0, census_columns_values_2_cell_3_right_q[8]} : census_columns_values_2_cell_3_right_q[7:0];
  logic [7:0] select_2473;
  assign select_2473 = select_1955_s3_q[0] ? {7'h0, census_columns_values_2_cell_3_left_q[8]} : census_columns_values_2_cell_3_left_q[7:0];
  logic [7:0] select_2475;
  assign select_2475 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2469 : {7'h0, select_2470}) : (select_1955_s3_q[1] ? select_2472 : select_2473);
  logic [7:0] select_2477;
  assign select_2477 = select_1955_s3_q[4] ? (select_1955_s3_q[3] ? select_2453 : select_2460) : (select_1955_s3_q[3] ? select_2468 : select_2475);
  logic select_2480;
  assign select_2480 = select_1955_s3_q[0] ? census_columns_values_2_cell_2_of_skin_q : census_columns_values_2_cell_2_mask_q;
  logic [7:0] select_2481;
  assign select_2481 = select_1955_s3_q[0] ? {7'h0, census_columns_values_2_cell_2_right_q[8]} : census_columns_values_2_cell_2_right_q[7:0];
  logic [7:0] select_2483;
  assign select_2483 = select_1955_s3_q[0] ? {7'h0, census_columns_values_2_cell_2_left_q[8]} : census_columns_values_2_cell_2_left_q[7:0];
  logic select_2484;
  assign select_2484 = select_1955_s3_q[0] ? census_columns_values_2_cell_1_of_skin_q : census_columns_values_2_cell_1_mask_q;
  logic [7:0] select_2486;
  assign select_2486 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? {7'h0, select_2480} : select_2481) : (select_1955_s3_q[1] ? select_2483 : {7'h0, select_2484});
  logic [7:0] select_2487;
  assign select_2487 = select_1955_s3_q[0] ? {7'h0, census_columns_values_2_cell_1_right_q[8]} : census_columns_values_2_cell_1_right_q[7:0];
  logic [7:0] select_2488;
  assign select_2488 = select_1955_s3_q[0] ? {7'h0, census_columns_values_2_cell_1_left_q[8]} : census_columns_values_2_cell_1_left_q[7:0];
  logic select_2490;
  assign select_2490 = select_1955_s3_q[0] ? census_columns_values_2_cell_0_of_skin_q : census_columns_values_2_cell_0_mask_q;
  logic [7:0] select_2491;
  assign select_2491 = select_1955_s3_q[0] ? {7'h0, census_columns_values_2_cell_0_right_q[8]} : census_columns_values_2_cell_0_right_q[7:0];
  logic [7:0] select_2493;
  assign select_2493 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2487 : select_2488) : (select_1955_s3_q[1] ? {7'h0, select_2490} : select_2491);
  logic [7:0] select_2495;
  assign select_2495 = select_1955_s3_q[0] ? {7'h0, census_columns_values_2_cell_0_left_q[8]} : census_columns_values_2_cell_0_left_q[7:0];
  logic select_2496;
  assign select_2496 = select_1955_s3_q[0] ? census_columns_values_1_cell_4_of_skin_q : census_columns_values_1_cell_4_mask_q;
  logic [7:0] select_2498;
  assign select_2498 = select_1955_s3_q[0] ? {7'h0, census_columns_values_1_cell_4_right_q[8]} : census_columns_values_1_cell_4_right_q[7:0];
  logic [7:0] select_2499;
  assign select_2499 = select_1955_s3_q[0] ? {7'h0, census_columns_values_1_cell_4_left_q[8]} : census_columns_values_1_cell_4_left_q[7:0];
  logic [7:0] select_2501;
  assign select_2501 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2495 : {7'h0, select_2496}) : (select_1955_s3_q[1] ? select_2498 : select_2499);
  logic select_2502;
  assign select_2502 = select_1955_s3_q[0] ? census_columns_values_1_cell_3_of_skin_q : census_columns_values_1_cell_3_mask_q;
  logic [7:0] select_2503;
  assign select_2503 = select_1955_s3_q[0] ? {7'h0, census_columns_values_1_cell_3_right_q[8]} : census_columns_values_1_cell_3_right_q[7:0];
  logic [7:0] select_2505;
  assign select_2505 = select_1955_s3_q[0] ? {7'h0, census_columns_values_1_cell_3_left_q[8]} : census_columns_values_1_cell_3_left_q[7:0];
  logic select_2506;
  assign select_2506 = select_1955_s3_q[0] ? census_columns_values_1_cell_2_of_skin_q : census_columns_values_1_cell_2_mask_q;
  logic [7:0] select_2508;
  assign select_2508 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? {7'h0, select_2502} : select_2503) : (select_1955_s3_q[1] ? select_2505 : {7'h0, select_2506});
  logic [7:0] select_2510;
  assign select_2510 = select_1955_s3_q[4] ? (select_1955_s3_q[3] ? select_2486 : select_2493) : (select_1955_s3_q[3] ? select_2501 : select_2508);
  logic [7:0] select_2511;
  assign select_2511 = select_1955_s3_q[0] ? {7'h0, census_columns_values_1_cell_2_right_q[8]} : census_columns_values_1_cell_2_right_q[7:0];
  logic [7:0] select_2512;
  assign select_2512 = select_1955_s3_q[0] ? {7'h0, census_columns_values_1_cell_2_left_q[8]} : census_columns_values_1_cell_2_left_q[7:0];
  logic select_2514;
  assign select_2514 = select_1955_s3_q[0] ? census_columns_values_1_cell_1_of_skin_q : census_columns_values_1_cell_1_mask_q;
  logic [7:0] select_2515;
  assign select_2515 = select_1955_s3_q[0] ? {7'h0, census_columns_values_1_cell_1_right_q[8]} : census_columns_values_1_cell_1_right_q[7:0];
  logic [7:0] select_2517;
  assign select_2517 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2511 : select_2512) : (select_1955_s3_q[1] ? {7'h0, select_2514} : select_2515);
  logic [7:0] select_2518;
  assign select_2518 = select_1955_s3_q[0] ? {7'h0, census_columns_values_1_cell_1_left_q[8]} : census_columns_values_1_cell_1_left_q[7:0];
  logic select_2519;
  assign select_2519 = select_1955_s3_q[0] ? census_columns_values_1_cell_0_of_skin_q : census_columns_values_1_cell_0_mask_q;
  logic [7:0] select_2521;
  assign select_2521 = select_1955_s3_q[0] ? {7'h0, census_columns_values_1_cell_0_right_q[8]} : census_columns_values_1_cell_0_right_q[7:0];
  logic [7:0] select_2522;
  assign select_2522 = select_1955_s3_q[0] ? {7'h0, census_columns_values_1_cell_0_left_q[8]} : census_columns_values_1_cell_0_left_q[7:0];
  logic [7:0] select_2524;
  assign select_2524 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2518 : {7'h0, select_2519}) : (select_1955_s3_q[1] ? select_2521 : select_2522);
  logic select_2526;
  assign select_2526 = select_1955_s3_q[0] ? census_columns_values_0_cell_4_of_skin_q : census_columns_values_0_cell_4_mask_q;
  logic [7:0] select_2527;
  assign select_2527 = select_1955_s3_q[0] ? {7'h0, census_columns_values_0_cell_4_right_q[8]} : census_columns_values_0_cell_4_right_q[7:0];
  logic [7:0] select_2529;
  assign select_2529 = select_1955_s3_q[0] ? {7'h0, census_columns_values_0_cell_4_left_q[8]} : census_columns_values_0_cell_4_left_q[7:0];
  logic select_2530;
  assign select_2530 = select_1955_s3_q[0] ? census_columns_values_0_cell_3_of_skin_q : census_columns_values_0_cell_3_mask_q;
  logic [7:0] select_2532;
  assign select_2532 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? {7'h0, select_2526} : select_2527) : (select_1955_s3_q[1] ? select_2529 : {7'h0, select_2530});
  logic [7:0] select_2533;
  assign select_2533 = select_1955_s3_q[0] ? {7'h0, census_columns_values_0_cell_3_right_q[8]} : census_columns_values_0_cell_3_right_q[7:0];
  logic [7:0] select_2534;
  assign select_2534 = select_1955_s3_q[0] ? {7'h0, census_columns_values_0_cell_3_left_q[8]} : census_columns_values_0_cell_3_left_q[7:0];
  logic select_2536;
  assign select_2536 = select_1955_s3_q[0] ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_0_cell_2_mask_q;
  logic [7:0] select_2537;
  assign select_2537 = select_1955_s3_q[0] ? {7'h0, census_columns_values_0_cell_2_right_q[8]} : census_columns_values_0_cell_2_right_q[7:0];
  logic [7:0] select_2539;
  assign select_2539 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2533 : select_2534) : (select_1955_s3_q[1] ? {7'h0, select_2536} : select_2537);
  logic [7:0] select_2541;
  assign select_2541 = select_1955_s3_q[4] ? (select_1955_s3_q[3] ? select_2517 : select_2524) : (select_1955_s3_q[3] ? select_2532 : select_2539);
  logic [7:0] select_2543;
  assign select_2543 = select_1955_s3_q[0] ? {7'h0, census_columns_values_0_cell_2_left_q[8]} : census_columns_values_0_cell_2_left_q[7:0];
  logic select_2544;
  assign select_2544 = select_1955_s3_q[0] ? census_columns_values_0_cell_1_of_skin_q : census_columns_values_0_cell_1_mask_q;
  logic [7:0] select_2546;
  assign select_2546 = select_1955_s3_q[0] ? {7'h0, census_columns_values_0_cell_1_right_q[8]} : census_columns_values_0_cell_1_right_q[7:0];
  logic [7:0] select_2547;
  assign select_2547 = select_1955_s3_q[0] ? {7'h0, census_columns_values_0_cell_1_left_q[8]} : census_columns_values_0_cell_1_left_q[7:0];
  logic [7:0] select_2549;
  assign select_2549 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2543 : {7'h0, select_2544}) : (select_1955_s3_q[1] ? select_2546 : select_2547);
  logic select_2550;
  assign select_2550 = select_1955_s3_q[0] ? census_columns_values_0_cell_0_of_skin_q : census_columns_values_0_cell_0_mask_q;
  logic [7:0] select_2551;
  assign select_2551 = select_1955_s3_q[0] ? {7'h0, census_columns_values_0_cell_0_right_q[8]} : census_columns_values_0_cell_0_right_q[7:0];
  logic [7:0] select_2553;
  assign select_2553 = select_1955_s3_q[0] ? {7'h0, census_columns_values_0_cell_0_left_q[8]} : census_columns_values_0_cell_0_left_q[7:0];
  logic [7:0] select_2554;
  assign select_2554 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? {7'h0, select_2550} : select_2551) : select_2553;
  logic [7:0] select_2560;
  assign select_2560 = select_1955_s3_q[0] ? {2'h0, averager_detail_1_q[13:8]} : averager_detail_1_q[7:0];
  logic [7:0] select_2562;
  assign select_2562 = select_1955_s3_q[2] ? {7'h0, select_2558_s3_q} : (select_1955_s3_q[1] ? select_2559_s3_q : select_2560);
  logic [7:0] select_2563;
  assign select_2563 = select_1955_s3_q[0] ? {2'h0, averager_detail_0_q[13:8]} : averager_detail_0_q[7:0];
  logic [7:0] select_2564;
  assign select_2564 = select_1955_s3_q[0] ? {5'h0, averager_total_1_q[10:8]} : averager_total_1_q[7:0];
  logic [7:0] select_2566;
  assign select_2566 = select_1955_s3_q[0] ? {5'h0, averager_total_0_q[10:8]} : averager_total_0_q[7:0];
  logic [7:0] select_2567;
  assign select_2567 = select_1955_s3_q[0] ? {7'h0, averager_quarter_2_1_q[8]} : averager_quarter_2_1_q[7:0];
  logic [7:0] select_2569;
  assign select_2569 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2563 : select_2564) : (select_1955_s3_q[1] ? select_2566 : select_2567);
  logic [7:0] select_2571;
  assign select_2571 = select_1955_s3_q[4] ? (select_1955_s3_q[3] ? select_2549 : select_2554) : (select_1955_s3_q[3] ? select_2562 : select_2569);
  logic [7:0] select_2572;
  assign select_2572 = select_1955_s3_q[0] ? {7'h0, averager_quarter_2_0_q[8]} : averager_quarter_2_0_q[7:0];
  logic [7:0] select_2573;
  assign select_2573 = select_1955_s3_q[0] ? {7'h0, averager_quarter_1_1_q[8]} : averager_quarter_1_1_q[7:0];
  logic [7:0] select_2575;
  assign select_2575 = select_1955_s3_q[0] ? {7'h0, averager_quarter_1_0_q[8]} : averager_quarter_1_0_q[7:0];
  logic [7:0] select_2578;
  assign select_2578 = select_1955_s3_q[2] ? (select_1955_s3_q[1] ? select_2572 : select_2573) : (select_1955_s3_q[1] ? select_2575 : select_2576_s3_q);
  logic [7:0] select_2600;
  assign select_2600 = select_1955_s3_q[4] ? (select_1955_s3_q[3] ? select_2578 : select_2583_s3_q) : select_2599_s3_q;
  logic [7:0] select_2602;
  assign select_2602 = select_1955_s3_q[6] ? (select_1955_s3_q[5] ? select_2510 : select_2541) : (select_1955_s3_q[5] ? select_2571 : select_2600);
  // hls/stages/agreement.hpp:781
  logic or_2609;
  assign or_2609 = select_1993[7] | (~({select_1993[5], select_1993[3], select_1993[1]} == 3'h0));
  // hls/stages/agreement.hpp:780
  logic or_2612;
  assign or_2612 = select_1993[7] | (~({select_1993[6], select_1993[3:2]} == 3'h0));
  // hls/stages/agreement.hpp:779
  logic or_2615;
  assign or_2615 = select_1993[7] | (~(select_1993[6:4] == 3'h0));
  // hls/stages/agreement.hpp:211
  logic [5:0] select_2616;
  assign select_2616 = equal_1849_s3_q ? x_s3_q[5:0] : {region_row_q, or_2615, or_2612, or_2609};
  // hls/stages/agreement.hpp:859
  logic not_2617;
  assign not_2617 = ~equal_1894;
  // hls/stages/agreement.hpp:789
  logic or_2621;
  assign or_2621 = (~sum_1978[5]) | equal_2620_s3_q;
  // hls/stages/agreement.hpp:211
  logic and_2624;
  assign and_2624 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & or_2621));
  // hls/stages/agreement.hpp:197
  logic explained;
  assign explained = inside_v_s3_q[0] & inside_v_s3_q[3];
  logic and_2638;
  assign and_2638 = inside_v_s3_q[0] & ({inside_v_s3_q[4], inside_v_s3_q[2]} == 2'h3);
  logic and_2645;
  assign and_2645 = inside_v_s3_q[0] & inside_v_s3_q[2];
  // hls/stages/agreement.hpp:752
  logic select_2646;
  assign select_2646 = slot_s3_q[2] ? shown_shown_q : inside_v_s3_q[3];
  // hls/stages/agreement.hpp:197
  logic shown;
  assign shown = inside_v_s3_q[0] & (shown_right_rdata_q[0] | select_2646);
  // hls/stages/agreement.hpp:752
  logic select_2649;
  assign select_2649 = slot_s3_q[2] ? shown_nearer_q : inside_v_s3_q[4];
  // hls/stages/agreement.hpp:197
  logic near;
  assign near = inside_v_s3_q[0] & (select_2646 ? select_2649 : shown_right_rdata_q[1]);
  // hls/stages/agreement.hpp:984
  logic or_2652;
  assign or_2652 = marks_first_s3_q | line_ended_q;
  // hls/stages/agreement.hpp:986
  logic [17:0] select_2654;
  assign select_2654 = marks_first_s3_q ? 18'h1 : (or_2652 ? {rows_passed_q[16:0], 1'b1} : rows_passed_q);
  // hls/stages/agreement.hpp:985
  logic [8:0] select_2656;
  assign select_2656 = or_2652 ? 9'h0 : columns_passed_q;
  // hls/stages/agreement.hpp:993
  logic select_2658;
  assign select_2658 = cfg_compete_i ? (or_2652 & select_2654[17]) : (select_2656[8] & select_2654[9]);
  // hls/stages/agreement.hpp:218
  logic next_row;
  assign next_row = select_2658 & (began_q & at_cell_end_q);
  // hls/stages/agreement.hpp:1000
  logic [6:0] select_2661;
  assign select_2661 = next_row ? cfg_width_i[9:3] : 7'h0;
  logic [12:0] select_2663;
  assign select_2663 = marks_first_s3_q ? 13'h0 : (seen_base_q + {6'h0, select_2661});
  // hls/stages/agreement.hpp:1010
  logic equal_2664;
  assign equal_2664 = seen_x_q == 3'h7;
  logic [7:0] select_2666;
  assign select_2666 = select_2658 ? 8'h0 : (seen_column_q + {7'h0, equal_2664});
  // hls/stages/agreement.hpp:1013
  logic [12:0] index;
  assign index = select_2663 + {5'h0, select_2666};
  // hls/stages/agreement.hpp:984
  logic select_2669;
  assign select_2669 = marks_first_s3_q ? (done_q ? write_half_q : read_half_q) : read_half_q;
  // hls/stages/agreement.hpp:970
  logic [7:0] sum_2670;
  assign sum_2670 = {1'b0, select_2669, 2'h0, select_2669, 1'b0, {2{select_2669}}} + {1'b0, index[12:6]};
  // hls/stages/agreement.hpp:983
  logic not_2671;
  assign not_2671 = ~marks_first_s3_q;
  // hls/stages/agreement.hpp:218
  logic and_2673;
  assign and_2673 = not_2671 & (began_q | select_2658);
  // hls/stages/agreement.hpp:1011
  logic [2:0] select_2675;
  assign select_2675 = select_2658 ? 3'h0 : (seen_x_q + 3'h1);
  // hls/stages/agreement.hpp:1012
  logic and_2677;
  assign and_2677 = and_2673 & (select_2675 == 3'h0);
  logic less_2678;
  assign less_2678 = select_2666 < {1'b0, cfg_width_i[9:3]};
  // hls/stages/agreement.hpp:842
  logic [7:0] sum_2681;
  assign sum_2681 = {2'h0, x_s3_q[7:2]} + 8'hff;
  logic [12:0] index_2;
  assign index_2 = {{3{sum_2681[7]}}, sum_2681, x_s3_q[1:0]} + map_row_q;
  // hls/stages/agreement.hpp:970
  logic [7:0] sum_2683;
  assign sum_2683 = {1'b0, write_half_q, 2'h0, write_half_q, 1'b0, {2{write_half_q}}} + {1'b0, index_2[12:6]};
  // hls/stages/agreement.hpp:765
  logic and_2684;
  assign and_2684 = seen_columns_rdata_q[14] & inside_v_s3_q[0];
  logic and_2685;
  assign and_2685 = seen_columns_rdata_q[10] & inside_v_s3_q[0];
  logic and_2686;
  assign and_2686 = seen_columns_rdata_q[5] & inside_v_s3_q[0];
  logic and_2687;
  assign and_2687 = seen_columns_rdata_q[0] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:818
  logic [1:0] sum_2689;
  assign sum_2689 = {1'b0, and_2686} + ({1'b0, textured_s3_q} + {1'b0, and_2687});
  logic [2:0] textured_2;
  assign textured_2 = {2'h0, and_2684} + ({2'h0, and_2685} + {1'b0, sum_2689});
  // hls/stages/agreement.hpp:825
  logic [2:0] select_2692;
  assign select_2692 = age_s3_q ? box_textured_columns_values_4_q : 3'h0;
  logic [3:0] difference_2693;
  assign difference_2693 = {1'b0, textured_2} - {1'b0, select_2692};
  // hls/stages/agreement.hpp:823
  logic equal_2694;
  assign equal_2694 = x_s3_q == 8'h0;
  // hls/stages/agreement.hpp:825
  logic [4:0] t;
  assign t = {difference_2693[3], difference_2693} + (equal_2694 ? 5'h0 : box_textured_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:765
  logic [7:0] select_2699;
  assign select_2699 = inside_v_s3_q[0] ? (sum_1978[5] ? select_1993 : {select_1993[6:0], 1'b0}) : select_1993;
  // hls/stages/agreement.hpp:781
  logic or_2702;
  assign or_2702 = select_2699[7] | (~({select_2699[5], select_2699[3], select_2699[1]} == 3'h0));
  // hls/stages/agreement.hpp:765
  logic and_2719;
  assign and_2719 = seen_columns_rdata_q[16] & inside_v_s3_q[0];
  logic and_2720;
  assign and_2720 = seen_columns_rdata_q[12] & inside_v_s3_q[0];
  logic and_2721;
  assign and_2721 = seen_columns_rdata_q[8] & inside_v_s3_q[0];
  logic and_2722;
  assign and_2722 = seen_columns_rdata_q[3] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:820
  logic [1:0] sum_2724;
  assign sum_2724 = {1'b0, and_2721} + ({1'b0, shown} + {1'b0, and_2722});
  logic [2:0] shown_2;
  assign shown_2 = {2'h0, and_2719} + ({2'h0, and_2720} + {1'b0, sum_2724});
  // hls/stages/agreement.hpp:827
  logic [2:0] select_2727;
  assign select_2727 = age_s3_q ? box_shown_columns_values_4_q : 3'h0;
  logic [3:0] difference_2728;
  assign difference_2728 = {1'b0, shown_2} - {1'b0, select_2727};
  logic [4:0] around;
  assign around = {difference_2728[3], difference_2728} + (equal_2694 ? 5'h0 : box_shown_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:834
  logic [5:0] sum_2731;
  assign sum_2731 = {1'b0, around} + {2'h0, around[4:1]};
  // hls/stages/agreement.hpp:765
  logic and_2735;
  assign and_2735 = seen_columns_rdata_q[17] & inside_v_s3_q[0];
  logic and_2736;
  assign and_2736 = seen_columns_rdata_q[13] & inside_v_s3_q[0];
  logic and_2737;
  assign and_2737 = seen_columns_rdata_q[9] & inside_v_s3_q[0];
  logic and_2738;
  assign and_2738 = seen_columns_rdata_q[4] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:821
  logic [1:0] sum_2740;
  assign sum_2740 = {1'b0, and_2737} + ({1'b0, near} + {1'b0, and_2738});
  logic [2:0] near_2;
  assign near_2 = {2'h0, and_2735} + ({2'h0, and_2736} + {1'b0, sum_2740});
  // hls/stages/agreement.hpp:828
  logic [2:0] select_2743;
  assign select_2743 = age_s3_q ? box_nearer_columns_values_4_q : 3'h0;
  logic [3:0] difference_2744;
  assign difference_2744 = {1'b0, near_2} - {1'b0, select_2743};
  logic [4:0] n;
  assign n = {difference_2744[3], difference_2744} + (equal_2694 ? 5'h0 : box_nearer_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:215
  logic [8:0] select_2783;
  assign select_2783 = sample_pair_whole_s3_q ? (and_407_s3_q ? grey_s3_q : averager_quarter_1_0_q) : averager_quarter_1_0_q;
  logic [8:0] select_2785;
  assign select_2785 = sample_pair_whole_s3_q ? (and_407_s3_q ? grey_2_s3_q : averager_quarter_1_1_q) : averager_quarter_1_1_q;
  logic [8:0] select_2787;
  assign select_2787 = sample_pair_whole_s3_q ? (and_407_s3_q ? averager_quarter_1_0_q : averager_quarter_2_0_q) : averager_quarter_2_0_q;
  logic [8:0] select_2789;
  assign select_2789 = sample_pair_whole_s3_q ? (and_407_s3_q ? averager_quarter_1_1_q : averager_quarter_2_1_q) : averager_quarter_2_1_q;
  logic [10:0] select_2791;
  assign select_2791 = sample_pair_whole_s3_q ? (and_407_s3_q ? total : averager_total_0_q) : averager_total_0_q;
  logic [10:0] select_2793;
  assign select_2793 = sample_pair_whole_s3_q ? (and_407_s3_q ? total_2 : averager_total_1_q) : averager_total_1_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_2794;
  assign sum_2794 = {1'b0, averager_quarter_2_0_q} + {1'b0, grey_s3_q};
  logic [9:0] difference_2795;
  assign difference_2795 = {1'b0, sum_2794[9:1]} - {1'b0, averager_quarter_1_0_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_2796;
  assign xor_2796 = {difference_2795[8:0], sum_2794[0]} ^ {10{difference_2795[9]}};
  logic [10:0] size_2;
  assign size_2 = {10'h0, difference_2795[9]} + {1'b0, xor_2796};
  // hls/stages/census.hpp:130
  logic [13:0] detail;
  assign detail = {3'h0, size_2} + (equal_412_s3_q ? 14'h0 : averager_detail_0_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_2801;
  assign select_2801 = sample_pair_whole_s3_q ? (and_407_s3_q ? detail : averager_detail_0_q) : averager_detail_0_q;
  // hls/stages/census.hpp:128
  logic [9:0] sum_2802;
  assign sum_2802 = {1'b0, averager_quarter_2_1_q} + {1'b0, grey_2_s3_q};
  logic [9:0] difference_2803;
  assign difference_2803 = {1'b0, sum_2802[9:1]} - {1'b0, averager_quarter_1_1_q};
  // hls/stages/census.hpp:129
  logic [9:0] xor_2804;
  assign xor_2804 = {difference_2803[8:0], sum_2802[0]} ^ {10{difference_2803[9]}};
  logic [10:0] size_3;
  assign size_3 = {10'h0, difference_2803[9]} + {1'b0, xor_2804};
  // hls/stages/census.hpp:130
  logic [13:0] detail_2;
  assign detail_2 = {3'h0, size_3} + (equal_412_s3_q ? 14'h0 : averager_detail_1_q);
  // hls/stages/agreement.hpp:215
  logic [13:0] select_2809;
  assign select_2809 = sample_pair_whole_s3_q ? (and_407_s3_q ? detail_2 : averager_detail_1_q) : averager_detail_1_q;
  // hls/stages/agreement.hpp:365
  logic [8:0] select_2817;
  assign select_2817 = and_409_s3_q ? select_415 : census_columns_values_0_cell_0_left_q;
  logic [8:0] select_2818;
  assign select_2818 = and_409_s3_q ? select_419 : census_columns_values_0_cell_0_right_q;
  logic select_2819;
  assign select_2819 = and_409_s3_q ? whole_2_s3_q : census_columns_values_0_cell_0_mask_q;
  logic select_2820;
  assign select_2820 = and_409_s3_q ? and_427_s3_q : census_columns_values_0_cell_0_of_skin_q;
  logic [8:0] select_2821;
  assign select_2821 = and_409_s3_q ? census_memory_rdata_q[8:0] : census_columns_values_0_cell_1_left_q;
  logic [8:0] select_2822;
  assign select_2822 = and_409_s3_q ? census_memory_rdata_q[17:9] : census_columns_values_0_cell_1_right_q;
  logic select_2823;
  assign select_2823 = and_409_s3_q ? census_memory_rdata_q[18] : census_columns_values_0_cell_1_mask_q;
  logic select_2824;
  assign select_2824 = and_409_s3_q ? census_memory_rdata_q[19] : census_columns_values_0_cell_1_of_skin_q;
  logic [8:0] select_2825;
  assign select_2825 = and_409_s3_q ? census_memory_rdata_q[28:20] : census_columns_values_0_cell_2_left_q;
  logic [8:0] select_2826;
  assign select_2826 = and_409_s3_q ? census_memory_rdata_q[37:29] : census_columns_values_0_cell_2_right_q;
  logic select_2827;
  assign select_2827 = and_409_s3_q ? census_memory_rdata_q[38] : census_columns_values_0_cell_2_mask_q;
  logic select_2828;
  assign select_2828 = and_409_s3_q ? census_memory_rdata_q[39] : census_columns_values_0_cell_2_of_skin_q;
  logic [8:0] select_2829;
  assign select_2829 = and_409_s3_q ? census_memory_rdata_q[48:40] : census_columns_values_0_cell_3_left_q;
  logic [8:0] select_2830;
  assign select_2830 = and_409_s3_q ? census_memory_rdata_q[57:49] : census_columns_values_0_cell_3_right_q;
  logic select_2831;
  assign select_2831 = and_409_s3_q ? census_memory_rdata_q[58] : census_columns_values_0_cell_3_mask_q;
  logic select_2832;
  assign select_2832 = and_409_s3_q ? census_memory_rdata_q[59] : census_columns_values_0_cell_3_of_skin_q;
  logic [8:0] select_2833;
  assign select_2833 = and_409_s3_q ? census_memory_rdata_q[68:60] : census_columns_values_0_cell_4_left_q;
  logic [8:0] select_2834;
  assign select_2834 = and_409_s3_q ? census_memory_rdata_q[77:69] : census_columns_values_0_cell_4_right_q;
  logic select_2835;
  assign select_2835 = and_409_s3_q ? census_memory_rdata_q[78] : census_columns_values_0_cell_4_mask_q;
  logic select_2836;
  assign select_2836 = and_409_s3_q ? census_memory_rdata_q[79] : census_columns_values_0_cell_4_of_skin_q;
  logic [8:0] select_2837;
  assign select_2837 = and_409_s3_q ? census_columns_values_0_cell_0_left_q : census_columns_values_1_cell_0_left_q;
  logic [8:0] select_2838;
  assign select_2838 = and_409_s3_q ? census_columns_values_0_cell_0_right_q : census_columns_values_1_cell_0_right_q;
  logic select_2839;
  assign select_2839 = and_409_s3_q ? census_columns_values_0_cell_0_mask_q : census_columns_values_1_cell_0_mask_q;
  logic select_2840;
  assign select_2840 = and_409_s3_q ? census_columns_values_0_cell_0_of_skin_q : census_columns_values_1_cell_0_of_skin_q;
  logic [8:0] select_2841;
  assign select_2841 = and_409_s3_q ? census_columns_values_0_cell_1_left_q : census_columns_values_1_cell_1_left_q;
  logic [8:0] select_2842;
  assign select_2842 = and_409_s3_q ? census_columns_values_0_cell_1_right_q : census_columns_values_1_cell_1_right_q;
  logic select_2843;
  assign select_2843 = and_409_s3_q ? census_columns_values_0_cell_1_mask_q : census_columns_values_1_cell_1_mask_q;
  logic select_2844;
  assign select_2844 = and_409_s3_q ? census_columns_values_0_cell_1_of_skin_q : census_columns_values_1_cell_1_of_skin_q;
  logic [8:0] select_2845;
  assign select_2845 = and_409_s3_q ? census_columns_values_0_cell_2_left_q : census_columns_values_1_cell_2_left_q;
  logic [8:0] select_2846;
  assign select_2846 = and_409_s3_q ? census_columns_values_0_cell_2_right_q : census_columns_values_1_cell_2_right_q;
  logic select_2847;
  assign select_2847 = and_409_s3_q ? census_columns_values_0_cell_2_mask_q : census_columns_values_1_cell_2_mask_q;
  logic select_2848;
  assign select_2848 = and_409_s3_q ? census_columns_values_0_cell_2_of_skin_q : census_columns_values_1_cell_2_of_skin_q;
  logic [8:0] select_2849;
  assign select_2849 = and_409_s3_q ? census_columns_values_0_cell_3_left_q : census_columns_values_1_cell_3_left_q;
  logic [8:0] select_2850;
  assign select_2850 = and_409_s3_q ? census_columns_values_0_cell_3_right_q : census_columns_values_1_cell_3_right_q;
  logic select_2851;
  assign select_2851 = and_409_s3_q ? census_columns_values_0_cell_3_mask_q : census_columns_values_1_cell_3_mask_q;
  logic select_2852;
  assign select_2852 = and_409_s3_q ? census_columns_values_0_cell_3_of_skin_q : census_columns_values_1_cell_3_of_skin_q;
  logic [8:0] select_2853;
  assign select_2853 = and_409_s3_q ? census_columns_values_0_cell_4_left_q : census_columns_values_1_cell_4_left_q;
  logic [8:0] select_2854;
  assign select_2854 = and_409_s3_q ? census_columns_values_0_cell_4_right_q : census_columns_values_1_cell_4_right_q;
  logic select_2855;
  assign select_2855 = and_409_s3_q ? census_columns_values_0_cell_4_mask_q : census_columns_values_1_cell_4_mask_q;
  logic select_2856;
  assign select_2856 = and_409_s3_q ? census_columns_values_0_cell_4_of_skin_q : census_columns_values_1_cell_4_of_skin_q;
  logic [8:0] select_2857;
  assign select_2857 = and_409_s3_q ? census_columns_values_1_cell_0_left_q : census_columns_values_2_cell_0_left_q;
  logic [8:0] select_2858;
  assign select_2858 = and_409_s3_q ? census_columns_values_1_cell_0_right_q : census_columns_values_2_cell_0_right_q;
  logic select_2859;
  assign select_2859 = and_409_s3_q ? census_columns_values_1_cell_0_mask_q : census_columns_values_2_cell_0_mask_q;
  logic select_2860;
  assign select_2860 = and_409_s3_q ? census_columns_values_1_cell_0_of_skin_q : census_columns_values_2_cell_0_of_skin_q;
  logic [8:0] select_2861;
  assign select_2861 = and_409_s3_q ? census_columns_values_1_cell_1_left_q : census_columns_values_2_cell_1_left_q;
  logic [8:0] select_2862;
  assign select_2862 = and_409_s3_q ? census_columns_values_1_cell_1_right_q : census_columns_values_2_cell_1_right_q;
  logic select_2863;
  assign select_2863 = and_409_s3_q ? census_columns_values_1_cell_1_mask_q : census_columns_values_2_cell_1_mask_q;
  logic select_2864;
  assign select_2864 = and_409_s3_q ? census_columns_values_1_cell_1_of_skin_q : census_columns_values_2_cell_1_of_skin_q;
  logic [8:0] select_2865;
  assign select_2865 = and_409_s3_q ? census_columns_values_1_cell_2_left_q : census_columns_values_2_cell_2_left_q;
  logic [8:0] select_2866;
  assign select_2866 = and_409_s3_q ? census_columns_values_1_cell_2_right_q : census_columns_values_2_cell_2_right_q;
  logic select_2867;
  assign select_2867 = and_409_s3_q ? census_columns_values_1_cell_2_mask_q : census_columns_values_2_cell_2_mask_q;
  logic select_2868;
  assign select_2868 = and_409_s3_q ? census_columns_values_1_cell_2_of_skin_q : census_columns_values_2_cell_2_of_skin_q;
  logic [8:0] select_2869;
  assign select_2869 = and_409_s3_q ? census_columns_values_1_cell_3_left_q : census_columns_values_2_cell_3_left_q;
  logic [8:0] select_2870;
  assign select_2870 = and_409_s3_q ? census_columns_values_1_cell_3_right_q : census_columns_values_2_cell_3_right_q;
  logic select_2871;
  assign select_2871 = and_409_s3_q ? census_columns_values_1_cell_3_mask_q : census_columns_values_2_cell_3_mask_q;
  logic select_2872;
  assign select_2872 = and_409_s3_q ? census_columns_values_1_cell_3_of_skin_q : census_columns_values_2_cell_3_of_skin_q;
  logic [8:0] select_2873;
  assign select_2873 = and_409_s3_q ? census_columns_values_1_cell_4_left_q : census_columns_values_2_cell_4_left_q;
  logic [8:0] select_2874;
  assign select_2874 = and_409_s3_q ? census_columns_values_1_cell_4_right_q : census_columns_values_2_cell_4_right_q;
  logic select_2875;
  assign select_2875 = and_409_s3_q ? census_columns_values_1_cell_4_mask_q : census_columns_values_2_cell_4_mask_q;
  logic select_2876;
  assign select_2876 = and_409_s3_q ? census_columns_values_1_cell_4_of_skin_q : census_columns_values_2_cell_4_of_skin_q;
  logic [8:0] select_2877;
  assign select_2877 = and_409_s3_q ? census_columns_values_2_cell_0_left_q : census_columns_values_3_cell_0_left_q;
  logic [8:0] select_2878;
  assign select_2878 = and_409_s3_q ? census_columns_values_2_cell_0_right_q : census_columns_values_3_cell_0_right_q;
  logic select_2879;
  assign select_2879 = and_409_s3_q ? census_columns_values_2_cell_0_mask_q : census_columns_values_3_cell_0_mask_q;
  logic select_2880;
  assign select_2880 = and_409_s3_q ? census_columns_values_2_cell_0_of_skin_q : census_columns_values_3_cell_0_of_skin_q;
  logic [8:0] select_2881;
  assign select_2881 = and_409_s3_q ? census_columns_values_2_cell_1_left_q : census_columns_values_3_cell_1_left_q;
  logic [8:0] select_2882;
  assign select_2882 = and_409_s3_q ? census_columns_values_2_cell_1_right_q : census_columns_values_3_cell_1_right_q;
  logic select_2883;
  assign select_2883 = and_409_s3_q ? census_columns_values_2_cell_1_mask_q : census_columns_values_3_cell_1_mask_q;
  logic select_2884;
  assign select_2884 = and_409_s3_q ? census_columns_values_2_cell_1_of_skin_q : census_columns_values_3_cell_1_of_skin_q;
  logic [8:0] select_2885;
  assign select_2885 = and_409_s3_q ? census_columns_values_2_cell_2_left_q : census_columns_values_3_cell_2_left_q;
  logic [8:0] select_2886;
  assign select_2886 = and_409_s3_q ? census_columns_values_2_cell_2_right_q : census_columns_values_3_cell_2_right_q;
  logic select_2887;
  assign select_2887 = and_409_s3_q ? census_columns_values_2_cell_2_mask_q : census_columns_values_3_cell_2_mask_q;
  logic select_2888;
  assign select_2888 = and_409_s3_q ? census_columns_values_2_cell_2_of_skin_q : census_columns_values_3_cell_2_of_skin_q;
  logic [8:0] select_2889;
  assign select_2889 = and_409_s3_q ? census_columns_values_2_cell_3_left_q : census_columns_values_3_cell_3_left_q;
  logic [8:0] select_2890;
  assign select_2890 = and_409_s3_q ? census_columns_values_2_cell_3_right_q : census_columns_values_3_cell_3_right_q;
  logic select_2891;
  assign select_2891 = and_409_s3_q ? census_columns_values_2_cell_3_mask_q : census_columns_values_3_cell_3_mask_q;
  logic select_2892;
  assign select_2892 = and_409_s3_q ? census_columns_values_2_cell_3_of_skin_q : census_columns_values_3_cell_3_of_skin_q;
  logic [8:0] select_2893;
  assign select_2893 = and_409_s3_q ? census_columns_values_2_cell_4_left_q : census_columns_values_3_cell_4_left_q;
  logic [8:0] select_2894;
  assign select_2894 = and_409_s3_q ? census_columns_values_2_cell_4_right_q : census_columns_values_3_cell_4_right_q;
  logic select_2895;
  assign select_2895 = and_409_s3_q ? census_columns_values_2_cell_4_mask_q : census_columns_values_3_cell_4_mask_q;
  logic select_2896;
  assign select_2896 = and_409_s3_q ? census_columns_values_2_cell_4_of_skin_q : census_columns_values_3_cell_4_of_skin_q;
  logic [8:0] select_2897;
  assign select_2897 = and_409_s3_q ? census_columns_values_3_cell_0_left_q : census_columns_values_4_cell_0_left_q;
  logic [8:0] select_2898;
  assign select_2898 = and_409_s3_q ? census_columns_values_3_cell_0_right_q : census_columns_values_4_cell_0_right_q;
  logic select_2899;
  assign select_2899 = and_409_s3_q ? census_columns_values_3_cell_0_mask_q : census_columns_values_4_cell_0_mask_q;
  logic select_2900;
  assign select_2900 = and_409_s3_q ? census_columns_values_3_cell_0_of_skin_q : census_columns_values_4_cell_0_of_skin_q;
  logic [8:0] select_2901;
  assign select_2901 = and_409_s3_q ? census_columns_values_3_cell_1_left_q : census_columns_values_4_cell_1_left_q;
  logic [8:0] select_2902;
  assign select_2902 = and_409_s3_q ? census_columns_values_3_cell_1_right_q : census_columns_values_4_cell_1_right_q;
  logic select_2903;
  assign select_2903 = and_409_s3_q ? census_columns_values_3_cell_1_mask_q : census_columns_values_4_cell_1_mask_q;
  logic select_2904;
  assign select_2904 = and_409_s3_q ? census_columns_values_3_cell_1_of_skin_q : census_columns_values_4_cell_1_of_skin_q;
  logic [8:0] select_2905;
  assign select_2905 = and_409_s3_q ? census_columns_values_3_cell_2_left_q : census_columns_values_4_cell_2_left_q;
  logic [8:0] select_2906;
  assign select_2906 = and_409_s3_q ? census_columns_values_3_cell_2_right_q : census_columns_values_4_cell_2_right_q;
  logic select_2907;
  assign select_2907 = and_409_s3_q ? census_columns_values_3_cell_2_mask_q : census_columns_values_4_cell_2_mask_q;
  logic select_2908;
  assign select_2908 = and_409_s3_q ? census_columns_values_3_cell_2_of_skin_q : census_columns_values_4_cell_2_of_skin_q;
  logic [8:0] select_2909;
  assign select_2909 = and_409_s3_q ? census_columns_values_3_cell_3_left_q : census_columns_values_4_cell_3_left_q;
  logic [8:0] select_2910;
  assign select_2910 = and_409_s3_q ? census_columns_values_3_cell_3_right_q : census_columns_values_4_cell_3_right_q;
  logic select_2911;
  assign select_2911 = and_409_s3_q ? census_columns_values_3_cell_3_mask_q : census_columns_values_4_cell_3_mask_q;
  logic select_2912;
  assign select_2912 = and_409_s3_q ? census_columns_values_3_cell_3_of_skin_q : census_columns_values_4_cell_3_of_skin_q;
  logic [8:0] select_2913;
  assign select_2913 = and_409_s3_q ? census_columns_values_3_cell_4_left_q : census_columns_values_4_cell_4_left_q;
  logic [8:0] select_2914;
  assign select_2914 = and_409_s3_q ? census_columns_values_3_cell_4_right_q : census_columns_values_4_cell_4_right_q;
  logic select_2915;
  assign select_2915 = and_409_s3_q ? census_columns_values_3_cell_4_mask_q : census_columns_values_4_cell_4_mask_q;
  logic select_2916;
  assign select_2916 = and_409_s3_q ? census_columns_values_3_cell_4_of_skin_q : census_columns_values_4_cell_4_of_skin_q;
  // hls/stages/census.hpp:192
  logic [9:0] difference_2918;
  assign difference_2918 = {1'b0, select_419} - {1'b0, census_columns_values_0_cell_0_right_q};
  logic [8:0] xor_2919;
  assign xor_2919 = difference_2918[8:0] ^ {9{difference_2918[9]}};
  logic [9:0] sum_2920;
  assign sum_2920 = {9'h0, difference_2918[9]} + {1'b0, xor_2919};
  logic [9:0] difference_2921;
  assign difference_2921 = {1'b0, census_memory_rdata_q[17:9]} - {1'b0, census_columns_values_0_cell_1_right_q};
  logic [8:0] xor_2922;
  assign xor_2922 = difference_2921[8:0] ^ {9{difference_2921[9]}};
  logic [9:0] sum_2923;
  assign sum_2923 = {9'h0, difference_2921[9]} + {1'b0, xor_2922};
  logic [9:0] difference_2925;
  assign difference_2925 = {1'b0, census_memory_rdata_q[37:29]} - {1'b0, census_columns_values_0_cell_2_right_q};
  logic [8:0] xor_2926;
  assign xor_2926 = difference_2925[8:0] ^ {9{difference_2925[9]}};
  logic [9:0] sum_2927;
  assign sum_2927 = {9'h0, difference_2925[9]} + {1'b0, xor_2926};
  logic [10:0] sum_2928;
  assign sum_2928 = ({1'b0, sum_2920} + {1'b0, sum_2923}) + {1'b0, sum_2927};
  logic [9:0] difference_2929;
  assign difference_2929 = {1'b0, census_memory_rdata_q[57:49]} - {1'b0, census_columns_values_0_cell_3_right_q};
  logic [8:0] xor_2930;
  assign xor_2930 = difference_2929[8:0] ^ {9{difference_2929[9]}};
  logic [9:0] sum_2931;
  assign sum_2931 = {9'h0, difference_2929[9]} + {1'b0, xor_2930};
  logic [9:0] difference_2933;
  assign difference_2933 = {1'b0, census_memory_rdata_q[77:69]} - {1'b0, census_columns_values_0_cell_4_right_q};
  logic [8:0] xor_2934;
  assign xor_2934 = difference_2933[8:0] ^ {9{difference_2933[9]}};
  logic [9:0] sum_2935;
  assign sum_2935 = {9'h0, difference_2933[9]} + {1'b0, xor_2934};
  // hls/stages/census.hpp:275
  logic and_2966;
  assign and_2966 = whole_2_s3_q & (~(column_s3_q[6:1] == 6'h0));
  // hls/stages/census.hpp:273
  logic [9:0] difference_2967;
  assign difference_2967 = {1'b0, select_415} - {1'b0, sharpness_last_mean_0_q};
  logic [8:0] contrast;
  assign contrast = {8'h0, difference_2967[9]} + (difference_2967[8:0] ^ {9{difference_2967[9]}});
  // hls/stages/agreement.hpp:311
  logic and_2972;
  assign and_2972 = and_2966 & (sharpness_last_mask_q & (7'h2 < contrast[8:2]));
  // hls/stages/census.hpp:273
  logic [9:0] difference_2978;
  assign difference_2978 = {1'b0, select_419} - {1'b0, sharpness_last_mean_1_q};
  logic [8:0] contrast_2;
  assign contrast_2 = {8'h0, difference_2978[9]} + (difference_2978[8:0] ^ {9{difference_2978[9]}});
  // hls/stages/agreement.hpp:311
  logic and_2983;
  assign and_2983 = and_2966 & (sharpness_last_mask_q & (7'h2 < contrast_2[8:2]));
  // hls/stages/census.hpp:277
  logic [8:0] select_2990;
  assign select_2990 = and_2972 ? contrast : 9'h0;
  logic [23:0] sum_2991;
  assign sum_2991 = (equal_2945_s3_q ? 24'h0 : sharpness_sums_contrast_0_q) + {15'h0, select_2990};
  logic [8:0] select_2994;
  assign select_2994 = and_2983 ? contrast_2 : 9'h0;
  logic [23:0] sum_2995;
  assign sum_2995 = (equal_2945_s3_q ? 24'h0 : sharpness_sums_contrast_1_q) + {15'h0, select_2994};
  // hls/stages/agreement.hpp:211
  logic and_3061;
  assign and_3061 = so_s3_q & (ends_cell_s3_q & (inside_v_s3_q[0] & inside_v_s3_q[1]));
  // hls/stages/agreement.hpp:765
  logic and_3082;
  assign and_3082 = seen_columns_rdata_q[15] & inside_v_s3_q[0];
  logic and_3083;
  assign and_3083 = seen_columns_rdata_q[11] & inside_v_s3_q[0];
  logic and_3084;
  assign and_3084 = seen_columns_rdata_q[7] & inside_v_s3_q[0];
  logic and_3085;
  assign and_3085 = seen_columns_rdata_q[2] & inside_v_s3_q[0];
  // hls/stages/agreement.hpp:819
  logic [1:0] sum_3087;
  assign sum_3087 = {1'b0, and_3084} + ({1'b0, explained} + {1'b0, and_3085});
  logic [2:0] explained_2;
  assign explained_2 = {2'h0, and_3082} + ({2'h0, and_3083} + {1'b0, sum_3087});
  // hls/stages/agreement.hpp:826
  logic [2:0] select_3090;
  assign select_3090 = age_s3_q ? box_explained_columns_values_4_q : 3'h0;
  logic [3:0] difference_3091;
  assign difference_3091 = {1'b0, explained_2} - {1'b0, select_3090};
  logic [4:0] e;
  assign e = {difference_3091[3], difference_3091} + (equal_2694 ? 5'h0 : box_explained_sum_sums_values_0_q);
  // hls/stages/agreement.hpp:833
  logic [5:0] sum_3094;
  assign sum_3094 = {1'b0, e} + {2'h0, e[4:1]};
  // hls/stages/agreement.hpp:211
  logic and_3122;
  assign and_3122 = ends_cell_s3_q & (inside_v_s3_q[0] & (inside_v_s3_q[2:1] == 2'h3));
  logic [7:0] select_3143;
  assign select_3143 = equal_1849_s3_q ? registration_slope_here_q : (so_s3_q ? select_2103 : registration_slope_here_q);
  // hls/stages/registration.hpp:107
  logic equal_3144;
  assign equal_3144 = slot_s3_q == 3'h4;
  // hls/stages/agreement.hpp:211
  logic select_3173;
  assign select_3173 = so_s3_q ? (equal_3144 ? right_2_s3_q : registration_of_right_q) : registration_of_right_q;
  logic select_3176;
  assign select_3176 = equal_1849_s3_q ? registration_was_inside_q : (so_s3_q ? select_2089 : registration_was_inside_q);
  // hls/stages/registration.hpp:121
  logic [15:0] select_3191;
  assign select_3191 = and_3190_s3_q ? $unsigned(cfg_epipolar_row_i) : 16'h0;
  // hls/stages/registration.hpp:124
  logic [23:0] select_3193;
  assign select_3193 = and_3188_s3_q ? {{3{cfg_epipolar_slope_i[15]}}, $unsigned(cfg_epipolar_slope_i), 5'h0} : (registration_slope_row_q + {{8{select_3191[15]}}, select_3191});
  // hls/stages/registration.hpp:122
  logic [15:0] select_3194;
  assign select_3194 = and_3190_s3_q ? $unsigned(cfg_epipolar_both_i) : 16'h0;
  logic [27:0] both;
  assign both = registration_slope_change_q + {{12{select_3194[15]}}, select_3194};
  // hls/stages/registration.hpp:124
  logic [27:0] select_3196;
  assign select_3196 = and_3188_s3_q ? {{8{cfg_epipolar_column_i[15]}}, $unsigned(cfg_epipolar_column_i), 4'h0} : both;
  // hls/stages/registration.hpp:117
  logic [27:0] column_7;
  assign column_7 = registration_slope_q + (and_1985_s3_q ? registration_slope_change_q : 28'h0);
  // hls/stages/agreement.hpp:860
  logic [1:0] quarter_2;
  assign quarter_2 = all ? x_s3_q[1:0] : select_1897;
  // hls/stages/agreement.hpp:211
  logic select_3293;
  assign select_3293 = equal_1849_s3_q ? shown_shown_q : (so_s3_q ? select_2646 : shown_shown_q);
  logic select_3295;
  assign select_3295 = equal_1849_s3_q ? shown_nearer_q : (so_s3_q ? select_2649 : shown_nearer_q);
  // hls/stages/agreement.hpp:314
  logic [2:0] select_3298;
  assign select_3298 = less_3296_s3_q ? (sum_1963[7] ? region_row_q : next_region_row_q) : region_row_q;
  logic [2:0] select_3300;
  assign select_3300 = equal_2999_s3_q ? (equal_470_s3_q ? 3'h0 : select_3298) : region_row_q;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_3304;
  assign select_3304 = equal_1849_s3_q ? select_1993 : (so_s3_q ? (ends_cell_s3_q ? select_2699 : select_1993) : 8'h1);
  // hls/stages/agreement.hpp:314
  logic [8:0] select_3306;
  assign select_3306 = equal_2999_s3_q ? (9'h1f0 - {2'h0, cfg_width_i[9:3]}) : columns_begin_rest_q;
  logic [7:0] select_3309;
  assign select_3309 = equal_2999_s3_q ? (8'h8 - {1'b0, cfg_width_i[9:3]}) : columns_begin_back_q;
  logic [8:0] select_3313;
  assign select_3313 = equal_470_s3_q ? {{2{difference_3311[6]}}, difference_3311} : (less_3296_s3_q ? region_down_next_q : region_down_rest_q);
  // hls/stages/agreement.hpp:365
  logic [8:0] select_3315;
  assign select_3315 = and_409_s3_q ? (equal_2999_s3_q ? select_3313 : region_down_rest_q) : region_down_rest_q;
  // hls/stages/agreement.hpp:314
  logic [6:0] select_3317;
  assign select_3317 = equal_470_s3_q ? (7'h6 - {1'b0, cfg_height_i[8:3]}) : region_down_back_q;
  // hls/stages/agreement.hpp:365
  logic [6:0] select_3319;
  assign select_3319 = and_409_s3_q ? (equal_2999_s3_q ? select_3317 : region_down_back_q) : region_down_back_q;
  // hls/stages/division.hpp:18
  logic next;
  assign next = ~sum_1963[7];
  // hls/stages/agreement.hpp:314
  logic select_3323;
  assign select_3323 = equal_2999_s3_q ? (equal_470_s3_q | (less_3296_s3_q ? next : region_fresh_q)) : region_fresh_q;
  // hls/stages/agreement.hpp:765
  logic select_3330;
  assign select_3330 = inside_v_s3_q[0] ? (sum_1978[5] ? (equal_2620_s3_q & or_2621) : or_2621) : or_1956;
  // hls/stages/agreement.hpp:211
  logic select_3333;
  assign select_3333 = equal_1849_s3_q ? or_1956 : (so_s3_q ? (ends_cell_s3_q ? select_3330 : or_1956) : or_1956);
  // hls/stages/agreement.hpp:872
  logic equal_3358;
  assign equal_3358 = x_s3_q[6:0] == 7'h7f;
  // hls/stages/agreement.hpp:211
  logic [2:0] select_3409;
  assign select_3409 = so_s3_q ? (ends_cell_s3_q ? textured_2 : box_textured_columns_values_0_q) : box_textured_columns_values_0_q;
  logic [2:0] select_3411;
  assign select_3411 = ends_cell_s3_q ? box_textured_columns_values_0_q : box_textured_columns_values_1_q;
  logic [2:0] select_3413;
  assign select_3413 = equal_1849_s3_q ? box_textured_columns_values_1_q : (so_s3_q ? select_3411 : box_textured_columns_values_1_q);
  logic [2:0] select_3414;
  assign select_3414 = ends_cell_s3_q ? box_textured_columns_values_1_q : box_textured_columns_values_2_q;
  logic [2:0] select_3416;
  assign select_3416 = equal_1849_s3_q ? box_textured_columns_values_2_q : (so_s3_q ? select_3414 : box_textured_columns_values_2_q);
  logic [2:0] select_3417;
  assign select_3417 = ends_cell_s3_q ? box_textured_columns_values_2_q : box_textured_columns_values_3_q;
  logic [2:0] select_3419;
  assign select_3419 = equal_1849_s3_q ? box_textured_columns_values_3_q : (so_s3_q ? select_3417 : box_textured_columns_values_3_q);
  logic [2:0] select_3420;
  assign select_3420 = ends_cell_s3_q ? box_textured_columns_values_3_q : box_textured_columns_values_4_q;
  logic [2:0] select_3422;
  assign select_3422 = equal_1849_s3_q ? box_textured_columns_values_4_q : (so_s3_q ? select_3420 : box_textured_columns_values_4_q);
  logic [4:0] select_3424;
  assign select_3424 = so_s3_q ? (ends_cell_s3_q ? t : box_textured_sum_sums_values_0_q) : box_textured_sum_sums_values_0_q;
  logic [2:0] select_3427;
  assign select_3427 = so_s3_q ? (ends_cell_s3_q ? explained_2 : box_explained_columns_values_0_q) : box_explained_columns_values_0_q;
  logic [2:0] select_3429;
  assign select_3429 = ends_cell_s3_q ? box_explained_columns_values_0_q : box_explained_columns_values_1_q;
  logic [2:0] select_3431;
  assign select_3431 = equal_1849_s3_q ? box_explained_columns_values_1_q : (so_s3_q ? select_3429 : box_explained_columns_values_1_q);
  logic [2:0] select_3432;
  assign select_3432 = ends_cell_s3_q ? box_explained_columns_values_1_q : box_explained_columns_values_2_q;
  logic [2:0] select_3434;
  assign select_3434 = equal_1849_s3_q ? box_explained_columns_values_2_q : (so_s3_q ? select_3432 : box_explained_columns_values_2_q);
  logic [2:0] select_3435;
  assign select_3435 = ends_cell_s3_q ? box_explained_columns_values_2_q : box_explained_columns_values_3_q;
  logic [2:0] select_3437;
  assign select_3437 = equal_1849_s3_q ? box_explained_columns_values_3_q : (so_s3_q ? select_3435 : box_explained_columns_values_3_q);
  logic [2:0] select_3438;
  assign select_3438 = ends_cell_s3_q ? box_explained_columns_values_3_q : box_explained_columns_values_4_q;
  logic [2:0] select_3440;
  assign select_3440 = equal_1849_s3_q ? box_explained_columns_values_4_q : (so_s3_q ? select_3438 : box_explained_columns_values_4_q);
  logic [4:0] select_3442;
  assign select_3442 = so_s3_q ? (ends_cell_s3_q ? e : box_explained_sum_sums_values_0_q) : box_explained_sum_sums_values_0_q;
  logic [4:0] select_3443;
  assign select_3443 = equal_1849_s3_q ? box_explained_sum_sums_values_0_q : select_3442;
  logic [2:0] select_3445;
  assign select_3445 = so_s3_q ? (ends_cell_s3_q ? shown_2 : box_shown_columns_values_0_q) : box_shown_columns_values_0_q;
  logic [2:0] select_3447;
  assign select_3447 = ends_cell_s3_q ? box_shown_columns_values_0_q : box_shown_columns_values_1_q;
  logic [2:0] select_3449;
  assign select_3449 = equal_1849_s3_q ? box_shown_columns_values_1_q : (so_s3_q ? select_3447 : box_shown_columns_values_1_q);
  logic [2:0] select_3450;
  assign select_3450 = ends_cell_s3_q ? box_shown_columns_values_1_q : box_shown_columns_values_2_q;
  logic [2:0] select_3452;
  assign select_3452 = equal_1849_s3_q ? box_shown_columns_values_2_q : (so_s3_q ? select_3450 : box_shown_columns_values_2_q);
  logic [2:0] select_3453;
  assign select_3453 = ends_cell_s3_q ? box_shown_columns_values_2_q : box_shown_columns_values_3_q;
  logic [2:0] select_3455;
  assign select_3455 = equal_1849_s3_q ? box_shown_columns_values_3_q : (so_s3_q ? select_3453 : box_shown_columns_values_3_q);
  logic [2:0] select_3456;
  assign select_3456 = ends_cell_s3_q ? box_shown_columns_values_3_q : box_shown_columns_values_4_q;
  logic [2:0] select_3458;
  assign select_3458 = equal_1849_s3_q ? box_shown_columns_values_4_q : (so_s3_q ? select_3456 : box_shown_columns_values_4_q);
  logic [4:0] select_3460;
  assign select_3460 = so_s3_q ? (ends_cell_s3_q ? around : box_shown_sum_sums_values_0_q) : box_shown_sum_sums_values_0_q;
  logic [2:0] select_3463;
  assign select_3463 = so_s3_q ? (ends_cell_s3_q ? near_2 : box_nearer_columns_values_0_q) : box_nearer_columns_values_0_q;
  logic [2:0] select_3465;
  assign select_3465 = ends_cell_s3_q ? box_nearer_columns_values_0_q : box_nearer_columns_values_1_q;
  logic [2:0] select_3467;
  assign select_3467 = equal_1849_s3_q ? box_nearer_columns_values_1_q : (so_s3_q ? select_3465 : box_nearer_columns_values_1_q);
  logic [2:0] select_3468;
  assign select_3468 = ends_cell_s3_q ? box_nearer_columns_values_1_q : box_nearer_columns_values_2_q;
  logic [2:0] select_3470;
  assign select_3470 = equal_1849_s3_q ? box_nearer_columns_values_2_q : (so_s3_q ? select_3468 : box_nearer_columns_values_2_q);
  logic [2:0] select_3471;
  assign select_3471 = ends_cell_s3_q ? box_nearer_columns_values_2_q : box_nearer_columns_values_3_q;
  logic [2:0] select_3473;
  assign select_3473 = equal_1849_s3_q ? box_nearer_columns_values_3_q : (so_s3_q ? select_3471 : box_nearer_columns_values_3_q);
  logic [2:0] select_3474;
  assign select_3474 = ends_cell_s3_q ? box_nearer_columns_values_3_q : box_nearer_columns_values_4_q;
  logic [2:0] select_3476;
  assign select_3476 = equal_1849_s3_q ? box_nearer_columns_values_4_q : (so_s3_q ? select_3474 : box_nearer_columns_values_4_q);
  logic [4:0] select_3478;
  assign select_3478 = so_s3_q ? (ends_cell_s3_q ? n : box_nearer_sum_sums_values_0_q) : box_nearer_sum_sums_values_0_q;
  logic select_3481;
  assign select_3481 = so_s3_q ? (ends_cell_s3_q ? and_2686 : centres_values_0_textured_q) : centres_values_0_textured_q;
  logic select_3484;
  assign select_3484 = ends_cell_s3_q ? (seen_columns_rdata_q[6] & inside_v_s3_q[0]) : centres_values_0_of_skin_q;
  logic select_3486;
  assign select_3486 = equal_1849_s3_q ? centres_values_0_of_skin_q : (so_s3_q ? select_3484 : centres_values_0_of_skin_q);
  logic select_3487;
  assign select_3487 = ends_cell_s3_q ? centres_values_0_textured_q : centres_values_1_textured_q;
  logic select_3489;
  assign select_3489 = equal_1849_s3_q ? centres_values_1_textured_q : (so_s3_q ? select_3487 : centres_values_1_textured_q);
  logic select_3490;
  assign select_3490 = ends_cell_s3_q ? centres_values_0_of_skin_q : centres_values_1_of_skin_q;
  logic select_3492;
  assign select_3492 = equal_1849_s3_q ? centres_values_1_of_skin_q : (so_s3_q ? select_3490 : centres_values_1_of_skin_q);
  // hls/stages/agreement.hpp:314
  logic [12:0] select_3496;
  assign select_3496 = equal_2999_s3_q ? (equal_3493_s3_q ? 13'h0 : (map_row_q + {6'h0, map_width_q})) : map_row_q;
  // hls/stages/agreement.hpp:365
  logic [6:0] select_3499;
  assign select_3499 = and_409_s3_q ? (equal_2999_s3_q ? cfg_width_i[9:3] : map_width_q) : map_width_q;
  // hls/stages/agreement.hpp:1009
  logic [2:0] select_3510;
  assign select_3510 = select_2658 ? (began_q ? (seen_y_q + 3'h1) : seen_y_q) : seen_y_q;
  // hls/stages/agreement.hpp:218
  logic [7:0] select_3516;
  assign select_3516 = marks_first_s3_q ? (less_3512 ? {sum_3513, cfg_height_i[5:3]} : 8'h0) : (seen_rows_left_q - {7'h0, was_next_row_q});
  // hls/stages/agreement.hpp:1013
  logic and_3522;
  assign and_3522 = and_2758_s3_q & ({sum_2683, index_2[5:0]} == {sum_2670, index[5:0]});

  // Memory registration_sums, 12 x 32 and parity, DISTANCE 12, hls/stages/registration.hpp:260; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [32:0] registration_sums_mem [0:11];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 12; i++) registration_sums_mem[i] = 33'h0;
`endif
  logic [3:0] registration_sums_raddr;
  assign registration_sums_raddr = select_1901;
  logic registration_sums_re;
  assign registration_sums_re = s3_en & (equal_1849_s3_q ? (x_s3_q[6] & select_1929) : and_1940);
  logic [32:0] registration_sums_word_q;
  always_ff @(posedge clk_i) begin
    if (registration_sums_re) registration_sums_word_q <= registration_sums_mem[registration_sums_raddr];
  end
  logic [31:0] registration_sums_rdata_q;
  assign registration_sums_rdata_q = registration_sums_word_q[31:0];
  logic registration_sums_read_q, registration_sums_error;
  always_ff @(posedge clk_i) registration_sums_read_q <= rst_ni & registration_sums_re;
  assign registration_sums_error = registration_sums_read_q & ^registration_sums_word_q;

  // Memory regions, 64 x 30 and parity, DISTANCE 12, hls/stages/agreement.hpp:1093; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [30:0] regions_mem [0:63];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 64; i++) regions_mem[i] = 31'h0;
`endif
  logic [5:0] regions_raddr;
  assign regions_raddr = select_2616;
  logic regions_re;
  assign regions_re = s3_en & (equal_1849_s3_q ? (x_s3_q[6] & not_2617) : and_2624);
  logic [30:0] regions_word_q;
  always_ff @(posedge clk_i) begin
    if (regions_re) regions_word_q <= regions_mem[regions_raddr];
  end
  logic [29:0] regions_rdata_q;
  assign regions_rdata_q = regions_word_q[29:0];
  logic regions_read_q, regions_error;
  always_ff @(posedge clk_i) regions_read_q <= rst_ni & regions_re;
  assign regions_error = regions_read_q & ^regions_word_q;

  // Memory map, 9600 x 2 and parity, DISTANCE 16, hls/stages/agreement.hpp:1104; read in stage 3, written in stage 4: 3 < 4 < 3 + DISTANCE.
  // So no address is read and written in one clock, and synthesis needs no bypass.
  (* no_rw_check *)
  logic [2:0] map_mem [0:9599];
`ifndef SYNTHESIS  // the memories of FPGAs start with zeros; yosys takes seconds for the loop
  initial for (int i = 0; i < 9600; i++) map_mem[i] = 3'h0;
`endif
  logic [13:0] map_raddr;
  assign map_raddr = {sum_2670, index[5:0]};
  logic map_re;
  assign map_re = s3_en & (and_2677 & less_2678);
  logic [2:0] map_word_q;
  always_ff @(posedge clk_i) begin
    if (map_re) map_word_q <= map_mem[map_raddr];
  end
  logic [1:0] map_rdata_q;
  assign map_rdata_q = map_word_q[1:0];
  logic map_read_q, map_error;
  always_ff @(posedge clk_i) map_read_q <= rst_ni & map_re;
  assign map_error = map_read_q & ^map_word_q;

  // Memory census_memory, write
  logic [6:0] census_memory_waddr;
  assign census_memory_waddr = column_s3_q;
  logic census_memory_we;
  assign census_memory_we = s3_en & and_409_s3_q;
  logic [79:0] census_memory_wdata;
  assign census_memory_wdata = {census_memory_rdata_q[59:0], and_427_s3_q, whole_2_s3_q, select_419, select_415};
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

  // Memory shown_right, write
  logic [6:0] shown_right_waddr;
  assign shown_right_waddr = select_1888_s3_q;
  logic shown_right_we;
  assign shown_right_we = s3_en & and_1893_s3_q;
  logic [1:0] shown_right_wdata;
  assign shown_right_wdata = {and_1890, not_1889};
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

  // Memory seen_columns, write
  logic [6:0] seen_columns_waddr;
  assign seen_columns_waddr = x_s3_q[6:0];
  logic seen_columns_we;
  assign seen_columns_we = s3_en & and_1884_s3_q;
  logic [17:0] seen_columns_wdata;
  assign seen_columns_wdata = {seen_columns_rdata_q[13:7], seen_columns_rdata_q[5:0], near, shown, explained, and_2645, textured_s3_q};
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
      sharpness_sums_contrast_0_q <= 24'h0;
      sharpness_sums_contrast_1_q <= 24'h0;
      registration_slope_here_q <= 8'h0;
      registration_of_right_q <= 1'b0;
      registration_was_inside_q <= 1'b0;
      registration_slope_row_q <= 24'h0;
      registration_slope_change_q <= 28'h0;
      registration_slope_q <= 28'h0;
      shown_shown_q <= 1'b0;
      shown_nearer_q <= 1'b0;
      region_row_q <= 3'h0;
      next_region_row_q <= 3'h0;
      region_columns_q <= 8'h1;
      region_across_rest_q <= 9'h0;
      region_across_back_q <= 8'h0;
      region_across_next_q <= 9'h0;
      columns_begin_rest_q <= 9'h0;
      columns_begin_back_q <= 8'h0;
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
      rows_passed_q <= 18'h0;
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
    end else if (s3_en) begin
      sharpness_sums_contrast_0_q <= and_409_s3_q ? sum_2991 : sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_q <= and_409_s3_q ? sum_2995 : sharpness_sums_contrast_1_q;
      registration_slope_here_q <= select_3143;
      registration_of_right_q <= equal_1849_s3_q ? registration_of_right_q : select_3173;
      registration_was_inside_q <= select_3176;
      registration_slope_row_q <= select_3193;
      registration_slope_change_q <= select_3196;
      registration_slope_q <= so_s3_q ? column_7 : {registration_slope_row_q, 4'h0};
      shown_shown_q <= select_3293;
      shown_nearer_q <= select_3295;
      region_row_q <= and_409_s3_q ? select_3300 : region_row_q;
      next_region_row_q <= sum_1994;
      region_columns_q <= select_3304;
      region_across_rest_q <= select_1987;
      region_across_back_q <= select_1983;
      region_across_next_q <= select_1980;
      columns_begin_rest_q <= and_409_s3_q ? select_3306 : columns_begin_rest_q;
      columns_begin_back_q <= and_409_s3_q ? select_3309 : columns_begin_back_q;
      region_down_rest_q <= select_3315;
      region_down_back_q <= select_3319;
      region_down_next_q <= select_1965;
      region_fresh_q <= and_409_s3_q ? select_3323 : region_fresh_q;
      segment_starts_q <= select_3333;
      centres_values_0_textured_q <= equal_1849_s3_q ? centres_values_0_textured_q : select_3481;
      centres_values_0_of_skin_q <= select_3486;
      centres_values_1_textured_q <= select_3489;
      centres_values_1_of_skin_q <= select_3492;
      map_row_q <= and_409_s3_q ? select_3496 : map_row_q;
      map_width_q <= select_3499;
      write_half_q <= marks_first_s3_q ? (write_half_q ^ done_q) : write_half_q;
      read_half_q <= select_2669;
      done_q <= not_2671 & ((~drew_q) & (done_q | said_q));
      proven_q <= marks_first_s3_q ? done_q : proven_q;
      drew_q <= so_s3_q;
      said_q <= equal_1849_s3_q & equal_3358;
      rows_passed_q <= select_2654;
      columns_passed_q <= {select_2656[7:0], or_2652};
      line_ended_q <= marks_last_s3_q;
      began_q <= and_2673;
      seen_x_q <= select_2675;
      seen_y_q <= marks_first_s3_q ? 3'h0 : select_3510;
      seen_column_q <= select_2666;
      seen_rows_left_q <= select_3516;
      at_cell_end_q <= (seen_y_q == 3'h7) & (~(seen_rows_left_q == 8'h0));
      was_next_row_q <= next_row;
      seen_base_q <= select_2663;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    averager_quarter_1_0_q = 9'h0;
    averager_quarter_1_1_q = 9'h0;
    averager_quarter_2_0_q = 9'h0;
    averager_quarter_2_1_q = 9'h0;
    averager_total_0_q = 11'h0;
    averager_total_1_q = 11'h0;
    averager_detail_0_q = 14'h0;
    averager_detail_1_q = 14'h0;
    census_columns_values_0_cell_0_left_q = 9'h0;
    census_columns_values_0_cell_0_right_q = 9'h0;
    census_columns_values_0_cell_0_mask_q = 1'b0;
    census_columns_values_0_cell_0_of_skin_q = 1'b0;
    census_columns_values_0_cell_1_left_q = 9'h0;
    census_columns_values_0_cell_1_right_q = 9'h0;
    census_columns_values_0_cell_1_mask_q = 1'b0;
    census_columns_values_0_cell_1_of_skin_q = 1'b0;
    census_columns_values_0_cell_2_left_q = 9'h0;
    census_columns_values_0_cell_2_right_q = 9'h0;
    census_columns_values_0_cell_2_mask_q = 1'b0;
    census_columns_values_0_cell_2_of_skin_q = 1'b0;
    census_columns_values_0_cell_3_left_q = 9'h0;
    census_columns_values_0_cell_3_right_q = 9'h0;
    census_columns_values_0_cell_3_mask_q = 1'b0;
    census_columns_values_0_cell_3_of_skin_q = 1'b0;
    census_columns_values_0_cell_4_left_q = 9'h0;
    census_columns_values_0_cell_4_right_q = 9'h0;
    census_columns_values_0_cell_4_mask_q = 1'b0;
    census_columns_values_0_cell_4_of_skin_q = 1'b0;
    census_columns_values_1_cell_0_left_q = 9'h0;
    census_columns_values_1_cell_0_right_q = 9'h0;
    census_columns_values_1_cell_0_mask_q = 1'b0;
    census_columns_values_1_cell_0_of_skin_q = 1'b0;
    census_columns_values_1_cell_1_left_q = 9'h0;
    census_columns_values_1_cell_1_right_q = 9'h0;
    census_columns_values_1_cell_1_mask_q = 1'b0;
    census_columns_values_1_cell_1_of_skin_q = 1'b0;
    census_columns_values_1_cell_2_left_q = 9'h0;
    census_columns_values_1_cell_2_right_q = 9'h0;
    census_columns_values_1_cell_2_mask_q = 1'b0;
    census_columns_values_1_cell_2_of_skin_q = 1'b0;
    census_columns_values_1_cell_3_left_q = 9'h0;
    census_columns_values_1_cell_3_right_q = 9'h0;
    census_columns_values_1_cell_3_mask_q = 1'b0;
    census_columns_values_1_cell_3_of_skin_q = 1'b0;
    census_columns_values_1_cell_4_left_q = 9'h0;
    census_columns_values_1_cell_4_right_q = 9'h0;
    census_columns_values_1_cell_4_mask_q = 1'b0;
    census_columns_values_1_cell_4_of_skin_q = 1'b0;
    census_columns_values_2_cell_0_left_q = 9'h0;
    census_columns_values_2_cell_0_right_q = 9'h0;
    census_columns_values_2_cell_0_mask_q = 1'b0;
    census_columns_values_2_cell_0_of_skin_q = 1'b0;
    census_columns_values_2_cell_1_left_q = 9'h0;
    census_columns_values_2_cell_1_right_q = 9'h0;
    census_columns_values_2_cell_1_mask_q = 1'b0;
    census_columns_values_2_cell_1_of_skin_q = 1'b0;
    census_columns_values_2_cell_2_left_q = 9'h0;
    census_columns_values_2_cell_2_right_q = 9'h0;
    census_columns_values_2_cell_2_mask_q = 1'b0;
    census_columns_values_2_cell_2_of_skin_q = 1'b0;
    census_columns_values_2_cell_3_left_q = 9'h0;
    census_columns_values_2_cell_3_right_q = 9'h0;
    census_columns_values_2_cell_3_mask_q = 1'b0;
    census_columns_values_2_cell_3_of_skin_q = 1'b0;
    census_columns_values_2_cell_4_left_q = 9'h0;
    census_columns_values_2_cell_4_right_q = 9'h0;
    census_columns_values_2_cell_4_mask_q = 1'b0;
    census_columns_values_2_cell_4_of_skin_q = 1'b0;
    census_columns_values_3_cell_0_left_q = 9'h0;
    census_columns_values_3_cell_0_right_q = 9'h0;
    census_columns_values_3_cell_0_mask_q = 1'b0;
    census_columns_values_3_cell_0_of_skin_q = 1'b0;
    census_columns_values_3_cell_1_left_q = 9'h0;
    census_columns_values_3_cell_1_right_q = 9'h0;
    census_columns_values_3_cell_1_mask_q = 1'b0;
    census_columns_values_3_cell_1_of_skin_q = 1'b0;
    census_columns_values_3_cell_2_left_q = 9'h0;
    census_columns_values_3_cell_2_right_q = 9'h0;
    census_columns_values_3_cell_2_mask_q = 1'b0;
    census_columns_values_3_cell_2_of_skin_q = 1'b0;
    census_columns_values_3_cell_3_left_q = 9'h0;
    census_columns_values_3_cell_3_right_q = 9'h0;
    census_columns_values_3_cell_3_mask_q = 1'b0;
    census_columns_values_3_cell_3_of_skin_q = 1'b0;
    census_columns_values_3_cell_4_left_q = 9'h0;
    census_columns_values_3_cell_4_right_q = 9'h0;
    census_columns_values_3_cell_4_mask_q = 1'b0;
    census_columns_values_3_cell_4_of_skin_q = 1'b0;
    census_columns_values_4_cell_0_left_q = 9'h0;
    census_columns_values_4_cell_0_right_q = 9'h0;
    census_columns_values_4_cell_0_mask_q = 1'b0;
    census_columns_values_4_cell_0_of_skin_q = 1'b0;
    census_columns_values_4_cell_1_left_q = 9'h0;
    census_columns_values_4_cell_1_right_q = 9'h0;
    census_columns_values_4_cell_1_mask_q = 1'b0;
    census_columns_values_4_cell_1_of_skin_q = 1'b0;
    census_columns_values_4_cell_2_left_q = 9'h0;
    census_columns_values_4_cell_2_right_q = 9'h0;
    census_columns_values_4_cell_2_mask_q = 1'b0;
    census_columns_values_4_cell_2_of_skin_q = 1'b0;
    census_columns_values_4_cell_3_left_q = 9'h0;
    census_columns_values_4_cell_3_right_q = 9'h0;
    census_columns_values_4_cell_3_mask_q = 1'b0;
    census_columns_values_4_cell_3_of_skin_q = 1'b0;
    census_columns_values_4_cell_4_left_q = 9'h0;
    census_columns_values_4_cell_4_right_q = 9'h0;
    census_columns_values_4_cell_4_mask_q = 1'b0;
    census_columns_values_4_cell_4_of_skin_q = 1'b0;
    sharpness_last_valid_q = 1'b0;
    sharpness_last_mean_0_q = 9'h0;
    sharpness_last_mean_1_q = 9'h0;
    sharpness_last_mask_q = 1'b0;
    sharpness_last_of_skin_q = 1'b0;
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
      averager_quarter_1_0_q <= select_2783;
      averager_quarter_1_1_q <= select_2785;
      averager_quarter_2_0_q <= select_2787;
      averager_quarter_2_1_q <= select_2789;
      averager_total_0_q <= select_2791;
      averager_total_1_q <= select_2793;
      averager_detail_0_q <= select_2801;
      averager_detail_1_q <= select_2809;
      census_columns_values_0_cell_0_left_q <= select_2817;
      census_columns_values_0_cell_0_right_q <= select_2818;
      census_columns_values_0_cell_0_mask_q <= select_2819;
      census_columns_values_0_cell_0_of_skin_q <= select_2820;
      census_columns_values_0_cell_1_left_q <= select_2821;
      census_columns_values_0_cell_1_right_q <= select_2822;
      census_columns_values_0_cell_1_mask_q <= select_2823;
      census_columns_values_0_cell_1_of_skin_q <= select_2824;
      census_columns_values_0_cell_2_left_q <= select_2825;
      census_columns_values_0_cell_2_right_q <= select_2826;
      census_columns_values_0_cell_2_mask_q <= select_2827;
      census_columns_values_0_cell_2_of_skin_q <= select_2828;
      census_columns_values_0_cell_3_left_q <= select_2829;
      census_columns_values_0_cell_3_right_q <= select_2830;
      census_columns_values_0_cell_3_mask_q <= select_2831;
      census_columns_values_0_cell_3_of_skin_q <= select_2832;
      census_columns_values_0_cell_4_left_q <= select_2833;
      census_columns_values_0_cell_4_right_q <= select_2834;
      census_columns_values_0_cell_4_mask_q <= select_2835;
      census_columns_values_0_cell_4_of_skin_q <= select_2836;
      census_columns_values_1_cell_0_left_q <= select_2837;
      census_columns_values_1_cell_0_right_q <= select_2838;
      census_columns_values_1_cell_0_mask_q <= select_2839;
      census_columns_values_1_cell_0_of_skin_q <= select_2840;
      census_columns_values_1_cell_1_left_q <= select_2841;
      census_columns_values_1_cell_1_right_q <= select_2842;
      census_columns_values_1_cell_1_mask_q <= select_2843;
      census_columns_values_1_cell_1_of_skin_q <= select_2844;
      census_columns_values_1_cell_2_left_q <= select_2845;
      census_columns_values_1_cell_2_right_q <= select_2846;
      census_columns_values_1_cell_2_mask_q <= select_2847;
      census_columns_values_1_cell_2_of_skin_q <= select_2848;
      census_columns_values_1_cell_3_left_q <= select_2849;
      census_columns_values_1_cell_3_right_q <= select_2850;
      census_columns_values_1_cell_3_mask_q <= select_2851;
      census_columns_values_1_cell_3_of_skin_q <= select_2852;
      census_columns_values_1_cell_4_left_q <= select_2853;
      census_columns_values_1_cell_4_right_q <= select_2854;
      census_columns_values_1_cell_4_mask_q <= select_2855;
      census_columns_values_1_cell_4_of_skin_q <= select_2856;
      census_columns_values_2_cell_0_left_q <= select_2857;
      census_columns_values_2_cell_0_right_q <= select_2858;
      census_columns_values_2_cell_0_mask_q <= select_2859;
      census_columns_values_2_cell_0_of_skin_q <= select_2860;
      census_columns_values_2_cell_1_left_q <= select_2861;
      census_columns_values_2_cell_1_right_q <= select_2862;
      census_columns_values_2_cell_1_mask_q <= select_2863;
      census_columns_values_2_cell_1_of_skin_q <= select_2864;
      census_columns_values_2_cell_2_left_q <= select_2865;
      census_columns_values_2_cell_2_right_q <= select_2866;
      census_columns_values_2_cell_2_mask_q <= select_2867;
      census_columns_values_2_cell_2_of_skin_q <= select_2868;
      census_columns_values_2_cell_3_left_q <= select_2869;
      census_columns_values_2_cell_3_right_q <= select_2870;
      census_columns_values_2_cell_3_mask_q <= select_2871;
      census_columns_values_2_cell_3_of_skin_q <= select_2872;
      census_columns_values_2_cell_4_left_q <= select_2873;
      census_columns_values_2_cell_4_right_q <= select_2874;
      census_columns_values_2_cell_4_mask_q <= select_2875;
      census_columns_values_2_cell_4_of_skin_q <= select_2876;
      census_columns_values_3_cell_0_left_q <= select_2877;
      census_columns_values_3_cell_0_right_q <= select_2878;
      census_columns_values_3_cell_0_mask_q <= select_2879;
      census_columns_values_3_cell_0_of_skin_q <= select_2880;
      census_columns_values_3_cell_1_left_q <= select_2881;
      census_columns_values_3_cell_1_right_q <= select_2882;
      census_columns_values_3_cell_1_mask_q <= select_2883;
      census_columns_values_3_cell_1_of_skin_q <= select_2884;
      census_columns_values_3_cell_2_left_q <= select_2885;
      census_columns_values_3_cell_2_right_q <= select_2886;
      census_columns_values_3_cell_2_mask_q <= select_2887;
      census_columns_values_3_cell_2_of_skin_q <= select_2888;
      census_columns_values_3_cell_3_left_q <= select_2889;
      census_columns_values_3_cell_3_right_q <= select_2890;
      census_columns_values_3_cell_3_mask_q <= select_2891;
      census_columns_values_3_cell_3_of_skin_q <= select_2892;
      census_columns_values_3_cell_4_left_q <= select_2893;
      census_columns_values_3_cell_4_right_q <= select_2894;
      census_columns_values_3_cell_4_mask_q <= select_2895;
      census_columns_values_3_cell_4_of_skin_q <= select_2896;
      census_columns_values_4_cell_0_left_q <= select_2897;
      census_columns_values_4_cell_0_right_q <= select_2898;
      census_columns_values_4_cell_0_mask_q <= select_2899;
      census_columns_values_4_cell_0_of_skin_q <= select_2900;
      census_columns_values_4_cell_1_left_q <= select_2901;
      census_columns_values_4_cell_1_right_q <= select_2902;
      census_columns_values_4_cell_1_mask_q <= select_2903;
      census_columns_values_4_cell_1_of_skin_q <= select_2904;
      census_columns_values_4_cell_2_left_q <= select_2905;
      census_columns_values_4_cell_2_right_q <= select_2906;
      census_columns_values_4_cell_2_mask_q <= select_2907;
      census_columns_values_4_cell_2_of_skin_q <= select_2908;
      census_columns_values_4_cell_3_left_q <= select_2909;
      census_columns_values_4_cell_3_right_q <= select_2910;
      census_columns_values_4_cell_3_mask_q <= select_2911;
      census_columns_values_4_cell_3_of_skin_q <= select_2912;
      census_columns_values_4_cell_4_left_q <= select_2913;
      census_columns_values_4_cell_4_right_q <= select_2914;
      census_columns_values_4_cell_4_mask_q <= select_2915;
      census_columns_values_4_cell_4_of_skin_q <= select_2916;
      sharpness_last_valid_q <= sharpness_last_valid_q | and_409_s3_q;
      sharpness_last_mean_0_q <= and_409_s3_q ? select_415 : sharpness_last_mean_0_q;
      sharpness_last_mean_1_q <= and_409_s3_q ? select_419 : sharpness_last_mean_1_q;
      sharpness_last_mask_q <= and_409_s3_q ? whole_2_s3_q : sharpness_last_mask_q;
      sharpness_last_of_skin_q <= and_409_s3_q ? and_427_s3_q : sharpness_last_of_skin_q;
      box_textured_columns_values_0_q <= equal_1849_s3_q ? box_textured_columns_values_0_q : select_3409;
      box_textured_columns_values_1_q <= select_3413;
      box_textured_columns_values_2_q <= select_3416;
      box_textured_columns_values_3_q <= select_3419;
      box_textured_columns_values_4_q <= select_3422;
      box_textured_sum_sums_values_0_q <= equal_1849_s3_q ? box_textured_sum_sums_values_0_q : select_3424;
      box_explained_columns_values_0_q <= equal_1849_s3_q ? box_explained_columns_values_0_q : select_3427;
      box_explained_columns_values_1_q <= select_3431;
      box_explained_columns_values_2_q <= select_3434;
      box_explained_columns_values_3_q <= select_3437;
      box_explained_columns_values_4_q <= select_3440;
      box_explained_sum_sums_values_0_q <= select_3443;
      box_shown_columns_values_0_q <= equal_1849_s3_q ? box_shown_columns_values_0_q : select_3445;
      box_shown_columns_values_1_q <= select_3449;
      box_shown_columns_values_2_q <= select_3452;
      box_shown_columns_values_3_q <= select_3455;
      box_shown_columns_values_4_q <= select_3458;
      box_shown_sum_sums_values_0_q <= equal_1849_s3_q ? box_shown_sum_sums_values_0_q : select_3460;
      box_nearer_columns_values_0_q <= equal_1849_s3_q ? box_nearer_columns_values_0_q : select_3463;
      box_nearer_columns_values_1_q <= select_3467;
      box_nearer_columns_values_2_q <= select_3470;
      box_nearer_columns_values_3_q <= select_3473;
      box_nearer_columns_values_4_q <= select_3476;
      box_nearer_sum_sums_values_0_q <= equal_1849_s3_q ? box_nearer_sum_sums_values_0_q : select_3478;
    end
  end

  logic [7:0] pixel_0_s4_q;
  logic [7:0] pixel_1_s4_q;
  logic saturated_s4_q;
  logic mask_s4_q;
  logic marks_first_s4_q;
  logic census_columns_values_1_cell_2_mask_s4_q;
  logic census_columns_values_1_cell_2_of_skin_s4_q;
  logic [23:0] sharpness_sums_contrast_0_s4_q;
  logic [23:0] sharpness_sums_contrast_1_s4_q;
  logic [7:0] x_s4_q;
  logic ends_cell_s4_q;
  logic lower_half_s4_q;
  logic registration_of_right_s4_q;
  logic [2:0] region_row_s4_q;
  logic region_fresh_s4_q;
  logic centres_values_1_textured_s4_q;
  logic centres_values_1_of_skin_s4_q;
  logic [6:0] column_s4_q;
  logic and_409_s4_q;
  logic less_443_s4_q;
  logic less_444_s4_q;
  logic less_445_s4_q;
  logic less_446_s4_q;
  logic less_447_s4_q;
  logic less_448_s4_q;
  logic less_449_s4_q;
  logic less_450_s4_q;
  logic less_451_s4_q;
  logic less_452_s4_q;
  logic less_453_s4_q;
  logic less_454_s4_q;
  logic less_455_s4_q;
  logic less_456_s4_q;
  logic less_457_s4_q;
  logic less_458_s4_q;
  logic less_459_s4_q;
  logic less_460_s4_q;
  logic less_461_s4_q;
  logic less_462_s4_q;
  logic less_463_s4_q;
  logic less_464_s4_q;
  logic less_465_s4_q;
  logic less_466_s4_q;
  logic equal_467_s4_q;
  logic select_472_s4_q;
  logic whole_22_s4_q;
  logic [11:0] texture_s4_q;
  logic equal_1849_s4_q;
  logic not_1850_s4_q;
  logic equal_1894_s4_q;
  logic [1:0] quarter_s4_q;
  logic all_s4_q;
  logic [1:0] sum_1900_s4_q;
  logic equal_1902_s4_q;
  logic equal_1904_s4_q;
  logic equal_1906_s4_q;
  logic equal_1908_s4_q;
  logic equal_1910_s4_q;
  logic equal_1912_s4_q;
  logic equal_1914_s4_q;
  logic less_1922_s4_q;
  logic or_1926_s4_q;
  logic and_1939_s4_q;
  logic equal_1948_s4_q;
  logic [8:0] select_1955_s4_q;
  logic or_1956_s4_q;
  logic [7:0] select_1971_s4_q;
  logic [7:0] select_1991_s4_q;
  logic [7:0] select_2000_s4_q;
  logic and_2003_s4_q;
  logic equal_2004_s4_q;
  logic and_2006_s4_q;
  logic [11:0] residual_s4_q;
  logic [7:0] select_2078_s4_q;
  logic [7:0] select_2088_s4_q;
  logic select_2090_s4_q;
  logic [7:0] select_2103_s4_q;
  logic [7:0] select_2126_s4_q;
  logic [7:0] select_2155_s4_q;
  logic [7:0] select_2184_s4_q;
  logic [7:0] select_2217_s4_q;
  logic [7:0] select_2270_s4_q;
  logic equal_2272_s4_q;
  logic and_2282_s4_q;
  logic and_2292_s4_q;
  logic less_2300_s4_q;
  logic [7:0] select_2384_s4_q;
  logic [7:0] select_2412_s4_q;
  logic [7:0] select_2478_s4_q;
  logic [7:0] select_2602_s4_q;
  logic and_2606_s4_q;
  logic or_2609_s4_q;
  logic or_2612_s4_q;
  logic or_2615_s4_q;
  logic not_2617_s4_q;
  logic textured_s4_q;
  logic explained_s4_q;
  logic and_2638_s4_q;
  logic and_2643_s4_q;
  logic and_2677_s4_q;
  logic less_2678_s4_q;
  logic [5:0] index_2_s4_q;
  logic [7:0] sum_2683_s4_q;
  logic equal_2697_s4_q;
  logic or_2702_s4_q;
  logic or_2705_s4_q;
  logic or_2708_s4_q;
  logic not_2733_s4_q;
  logic less_2747_s4_q;
  logic and_2758_s4_q;
  logic [11:0] sum_2936_s4_q;
  logic equal_2945_s4_q;
  logic [27:0] select_2961_s4_q;
  logic and_2972_s4_q;
  logic and_2983_s4_q;
  logic and_3058_s4_q;
  logic and_3062_s4_q;
  logic not_3096_s4_q;
  logic and_3124_s4_q;
  logic and_3147_s4_q;
  logic [1:0] quarter_2_s4_q;
  logic equal_3358_s4_q;
  logic and_3522_s4_q;
  logic and_3537_s4_q;
  always_ff @(posedge clk_i) begin
    if (s3_en) begin
      pixel_0_s4_q <= sample_pair_pixel_0_q;
      pixel_1_s4_q <= sample_pair_pixel_1_q;
      saturated_s4_q <= saturated_s3_q;
      mask_s4_q <= mask_s3_q;
      marks_first_s4_q <= marks_first_s3_q;
      census_columns_values_1_cell_2_mask_s4_q <= census_columns_values_1_cell_2_mask_q;
      census_columns_values_1_cell_2_of_skin_s4_q <= census_columns_values_1_cell_2_of_skin_q;
      sharpness_sums_contrast_0_s4_q <= sharpness_sums_contrast_0_q;
      sharpness_sums_contrast_1_s4_q <= sharpness_sums_contrast_1_q;
      x_s4_q <= x_s3_q;
      ends_cell_s4_q <= ends_cell_s3_q;
      lower_half_s4_q <= lower_half_s3_q;
      registration_of_right_s4_q <= registration_of_right_q;
      region_row_s4_q <= region_row_q;
      region_fresh_s4_q <= region_fresh_q;
      centres_values_1_textured_s4_q <= centres_values_1_textured_q;
      centres_values_1_of_skin_s4_q <= centres_values_1_of_skin_q;
      column_s4_q <= column_s3_q;
      and_409_s4_q <= and_409_s3_q;
      less_443_s4_q <= less_443;
      less_444_s4_q <= less_444;
      less_445_s4_q <= less_445;
      less_446_s4_q <= less_446;
      less_447_s4_q <= less_447;
      less_448_s4_q <= less_448;
      less_449_s4_q <= less_449;
      less_450_s4_q <= less_450;
      less_451_s4_q <= less_451;
      less_452_s4_q <= less_452;
      less_453_s4_q <= less_453;
      less_454_s4_q <= less_454;
      less_455_s4_q <= less_455;
      less_456_s4_q <= less_456;
      less_457_s4_q <= less_457;
      less_458_s4_q <= less_458;
      less_459_s4_q <= less_459;
      less_460_s4_q <= less_460;
      less_461_s4_q <= less_461;
      less_462_s4_q <= less_462;
      less_463_s4_q <= less_463;
      less_464_s4_q <= less_464;
      less_465_s4_q <= less_465;
      less_466_s4_q <= less_466;
      equal_467_s4_q <= equal_467_s3_q;
      select_472_s4_q <= select_472_s3_q;
      whole_22_s4_q <= whole_22;
      texture_s4_q <= texture;
      equal_1849_s4_q <= equal_1849_s3_q;
      not_1850_s4_q <= not_1850_s3_q;
      equal_1894_s4_q <= equal_1894;
      quarter_s4_q <= quarter;
      all_s4_q <= all;
      sum_1900_s4_q <= sum_1900_s3_q;
      equal_1902_s4_q <= equal_1902;
      equal_1904_s4_q <= equal_1904;
      equal_1906_s4_q <= equal_1906;
      equal_1908_s4_q <= equal_1908;
      equal_1910_s4_q <= equal_1910;
      equal_1912_s4_q <= equal_1912;
      equal_1914_s4_q <= equal_1914;
      less_1922_s4_q <= less_1922;
      or_1926_s4_q <= or_1926;
      and_1939_s4_q <= and_1939;
      equal_1948_s4_q <= equal_1948_s3_q;
      select_1955_s4_q <= select_1955_s3_q;
      or_1956_s4_q <= or_1956;
      select_1971_s4_q <= select_1955_s3_q[2] ? select_1967 : select_1970;
      select_1991_s4_q <= select_1991;
      select_2000_s4_q <= select_1955_s3_q[3] ? select_1999 : 8'h0;
      and_2003_s4_q <= and_2003;
      equal_2004_s4_q <= equal_2004;
      and_2006_s4_q <= and_2006_s3_q;
      residual_s4_q <= residual;
      select_2078_s4_q <= select_1955_s3_q[1] ? select_2076 : select_2077;
      select_2088_s4_q <= select_2088;
      select_2090_s4_q <= select_1955_s3_q[0] ? select_2089 : registration_of_right_q;
      select_2103_s4_q <= select_2103;
      select_2126_s4_q <= select_2126;
      select_2155_s4_q <= select_2155_s3_q;
      select_2184_s4_q <= select_2184_s3_q;
      select_2217_s4_q <= select_2217_s3_q;
      select_2270_s4_q <= select_2270_s3_q;
      equal_2272_s4_q <= {x_s3_q[4:0], slot_s3_q} == 8'h0;
      and_2282_s4_q <= and_2282;
      and_2292_s4_q <= and_2292;
      less_2300_s4_q <= 7'h2 < {x_s3_q[4:0], slot_s3_q[2:1]};
      select_2384_s4_q <= select_2384;
      select_2412_s4_q <= select_2412;
      select_2478_s4_q <= select_1955_s3_q[5] ? select_2446 : select_2477;
      select_2602_s4_q <= select_2602;
      and_2606_s4_q <= not_1850_s3_q & and_1940;
      or_2609_s4_q <= or_2609;
      or_2612_s4_q <= or_2612;
      or_2615_s4_q <= or_2615;
      not_2617_s4_q <= not_2617;
      textured_s4_q <= textured_s3_q;
      explained_s4_q <= explained;
      and_2638_s4_q <= and_2638;
      and_2643_s4_q <= not_1850_s3_q & and_2624;
      and_2677_s4_q <= and_2677;
      less_2678_s4_q <= less_2678;
      index_2_s4_q <= index_2[5:0];
      sum_2683_s4_q <= sum_2683;
      equal_2697_s4_q <= t[4:1] == 4'h0;
      or_2702_s4_q <= or_2702;
      or_2705_s4_q <= select_2699[7] | (~({select_2699[6], select_2699[3:2]} == 3'h0));
      or_2708_s4_q <= select_2699[7] | (~(select_2699[6:4] == 3'h0));
      not_2733_s4_q <= ~({sum_2731, around[0]} < {2'h0, t});
      less_2747_s4_q <= {1'b0, around[4:1]} < n;
      and_2758_s4_q <= and_2758_s3_q;
      sum_2936_s4_q <= ({1'b0, sum_2928} + {2'h0, sum_2931}) + {2'h0, sum_2935};
      equal_2945_s4_q <= equal_2945_s3_q;
      select_2961_s4_q <= sample_pair_whole_s3_q ? {detail_2, detail} : 28'h0;
      and_2972_s4_q <= and_2972;
      and_2983_s4_q <= and_2983;
      and_3058_s4_q <= and_409_s3_q & (equal_470_s3_q & equal_2999_s3_q);
      and_3062_s4_q <= not_1850_s3_q & and_3061;
      not_3096_s4_q <= ~({sum_3094, e[0]} < {2'h0, t});
      and_3124_s4_q <= not_1850_s3_q & (so_s3_q & and_3122);
      and_3147_s4_q <= not_1850_s3_q & (so_s3_q & (half_ends & equal_3144));
      quarter_2_s4_q <= quarter_2;
      equal_3358_s4_q <= equal_3358;
      and_3522_s4_q <= and_3522;
      and_3537_s4_q <= equal_1849_s3_q & (equal_3358 & (cfg_prove_i & (~proven_q)));
    end
  end

  // Stage 4 -----------------------------------------------------------------------------------------------------------
  logic [11:0] census_changes_values_0_left_q;
  logic [11:0] census_changes_values_0_right_q;
  logic [11:0] census_changes_values_1_left_q;
  logic [11:0] census_changes_values_1_right_q;
  logic [11:0] census_changes_values_2_left_q;
  logic [11:0] census_changes_values_2_right_q;
  logic [11:0] census_changes_values_3_left_q;
  logic [11:0] census_changes_values_3_right_q;
  logic [19:0] census_left_misses_q;
  logic [4:0] census_filled_q;
  logic [13:0] sharpness_last_detail_0_q;
  logic [13:0] sharpness_last_detail_1_q;
  logic [23:0] sharpness_sums_detail_0_q;
  logic [23:0] sharpness_sums_detail_1_q;
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
  logic [13:0] registration_half_across_q;
  logic [5:0] registration_half_measured_q;
  logic [6:0] registration_half_votes_down_q;
  logic [6:0] registration_half_votes_up_q;
  logic [6:0] registration_half_half_votes_down_q;
  logic [6:0] registration_half_half_votes_up_q;
  logic [3:0] registration_fresh_q;
  logic [13:0] registration_down_q;
  logic [13:0] registration_up_q;
  logic registration_enough_q;
  logic registration_votes_down_q;
  logic registration_votes_up_q;
  logic registration_other_enough_q;
  logic registration_other_down_q;
  logic registration_other_up_q;
  logic registration_moved_q;
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
  logic seen_q;
  logic nearer_q;
  // hls/stages/census.hpp:196
  logic [3:0] select_473;
  assign select_473 = equal_467_s4_q ? 4'h0 : census_filled_q[3:0];
  // hls/stages/census.hpp:219
  logic and_474;
  assign and_474 = select_472_s4_q & select_473[3];
  // hls/stages/census.hpp:220
  logic and_499;
  assign and_499 = whole_22_s4_q & and_474;
  // hls/stages/census.hpp:229
  logic and_500;
  assign and_500 = census_columns_values_1_cell_2_mask_s4_q & and_474;
  // hls/stages/census.hpp:201
  logic [12:0] sum_520;
  assign sum_520 = {1'b0, census_changes_values_0_left_q} + {1'b0, texture_s4_q};
  logic [13:0] sum_522;
  assign sum_522 = {2'h0, census_changes_values_2_left_q} + ({2'h0, census_changes_values_1_left_q} + {1'b0, sum_520});
  // hls/stages/census.hpp:223
  logic less_523;
  assign less_523 = 9'h4 < sum_522[13:5];
  logic and_524;
  assign and_524 = and_474 & less_523;
  // hls/stages/registration.hpp:243
  logic not_1943;
  assign not_1943 = ~lower_half_s4_q;
  logic [3:0] select_1944;
  assign select_1944 = registration_of_right_s4_q ? {lower_half_s4_q, 1'b0, not_1943, 1'b0} : {1'b0, lower_half_s4_q, 1'b0, not_1943};
  logic equal_1946;
  assign equal_1946 = (registration_fresh_q & select_1944) == 4'h0;
  // hls/stages/registration.hpp:249
  logic [6:0] select_1949;
  assign select_1949 = sum_1900_s4_q[0] ? registration_half_votes_down_q : registration_half_half_votes_down_q;
  logic [13:0] select_1950;
  assign select_1950 = equal_1948_s4_q ? registration_half_across_q : {{7{select_1949[6]}}, select_1949};
  logic [19:0] sum_1951;
  assign sum_1951 = (equal_1946 ? registration_sums_rdata_q[19:0] : 20'h0) + {{6{select_1950[13]}}, select_1950};
  // hls/stages/registration.hpp:250
  logic select_1957;
  assign select_1957 = select_1955_s4_q[0] ? segment_started_q : or_1956_s4_q;
  logic [6:0] select_1959;
  assign select_1959 = select_1955_s4_q[0] ? segment_textured_q : {6'h0, region_fresh_s4_q};
  logic [6:0] select_1960;
  assign select_1960 = select_1955_s4_q[1] ? (select_1955_s4_q[0] ? segment_nearer_q : segment_explained_q) : select_1959;
  logic [6:0] select_1961;
  assign select_1961 = select_1955_s4_q[2] ? {6'h0, select_1957} : select_1960;
  logic [7:0] select_1992;
  assign select_1992 = select_1955_s4_q[4] ? (select_1955_s4_q[3] ? {1'b0, select_1961} : select_1971_s4_q) : select_1991_s4_q;
  // hls/stages/registration.hpp:193
  logic [12:0] difference_2041;
  assign difference_2041 = 13'h0 - {residual_s4_q[11], residual_s4_q};
  logic less_2042;
  assign less_2042 = $signed(difference_2041) < $signed({7'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2043;
  assign and_2043 = and_2006_s4_q & less_2042;
  logic [1:0] select_2044;
  assign select_2044 = equal_2004_s4_q ? {and_2043, and_2006_s4_q} : 2'h0;
  // hls/stages/registration.hpp:193
  logic less_2045;
  assign less_2045 = $signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_half_limit_i});
  // hls/stages/registration.hpp:106
  logic and_2046;
  assign and_2046 = and_2006_s4_q & less_2045;
  logic [1:0] select_2047;
  assign select_2047 = equal_2004_s4_q ? {and_2046, and_2006_s4_q} : 2'h0;
  logic and_2049;
  assign and_2049 = and_2006_s4_q & ($signed(difference_2041) < $signed({7'h0, cfg_moved_limit_i}));
  logic [1:0] select_2050;
  assign select_2050 = equal_2004_s4_q ? {and_2049, and_2006_s4_q} : 2'h0;
  // hls/stages/registration.hpp:250
  logic [1:0] select_2052;
  assign select_2052 = select_1955_s4_q[1] ? select_2044 : (select_1955_s4_q[0] ? select_2047 : select_2050);
  logic [1:0] select_2053;
  assign select_2053 = select_1955_s4_q[2] ? {1'b0, and_2003_s4_q} : select_2052;
  // hls/stages/registration.hpp:106
  logic and_2055;
  assign and_2055 = and_2006_s4_q & ($signed(residual_s4_q[7:0]) < $signed({2'h0, cfg_moved_limit_i}));
  logic [1:0] select_2056;
  assign select_2056 = equal_2004_s4_q ? {and_2055, and_2006_s4_q} : 2'h0;
  logic and_2057;
  assign and_2057 = and_2006_s4_q & equal_2004_s4_q;
  // hls/stages/registration.hpp:250
  logic [1:0] select_2058;
  assign select_2058 = select_1955_s4_q[0] ? select_2056 : {1'b0, and_2057};
  // hls/stages/registration.hpp:106
  logic [7:0] select_2060;
  assign select_2060 = equal_2004_s4_q ? (and_2006_s4_q ? residual_s4_q[7:0] : 8'h0) : 8'h0;
  // hls/stages/registration.hpp:250
  logic [7:0] select_2062;
  assign select_2062 = select_1955_s4_q[1] ? {{6{select_2058[1]}}, select_2058} : (select_1955_s4_q[0] ? select_2060 : 8'h0);
  logic [7:0] select_2064;
  assign select_2064 = select_1955_s4_q[3] ? {{6{select_2053[1]}}, select_2053} : (select_1955_s4_q[2] ? select_2062 : 8'h0);
  logic [7:0] select_2066;
  assign select_2066 = select_1955_s4_q[5] ? select_1992 : (select_1955_s4_q[4] ? select_2000_s4_q : select_2064);
  logic select_2067;
  assign select_2067 = select_1955_s4_q[0] ? registration_other_up_q : registration_other_down_q;
  logic select_2069;
  assign select_2069 = select_1955_s4_q[0] ? registration_other_enough_q : registration_votes_up_q;
  logic select_2070;
  assign select_2070 = select_1955_s4_q[0] ? registration_votes_down_q : registration_enough_q;
  logic select_2072;
  assign select_2072 = select_1955_s4_q[2] ? (select_1955_s4_q[1] ? registration_moved_q : select_2067) : (select_1955_s4_q[1] ? select_2069 : select_2070);
  logic [7:0] select_2073;
  assign select_2073 = select_1955_s4_q[0] ? {{2{registration_up_q[13]}}, registration_up_q[13:8]} : registration_up_q[7:0];
  logic [7:0] select_2074;
  assign select_2074 = select_1955_s4_q[0] ? {{2{registration_down_q[13]}}, registration_down_q[13:8]} : registration_down_q[7:0];
  logic [7:0] select_2079;
  assign select_2079 = select_1955_s4_q[2] ? (select_1955_s4_q[1] ? select_2073 : select_2074) : select_2078_s4_q;
  logic [7:0] select_2081;
  assign select_2081 = select_1955_s4_q[4] ? 8'h0 : (select_1955_s4_q[3] ? {7'h0, select_2072} : select_2079);
  logic [6:0] select_2091;
  assign select_2091 = select_1955_s4_q[1] ? {6'h0, select_2090_s4_q} : registration_half_half_votes_up_q;
  logic [6:0] select_2092;
  assign select_2092 = select_1955_s4_q[2] ? {3'h0, registration_fresh_q} : select_2091;
  logic [7:0] select_2093;
  assign select_2093 = select_1955_s4_q[3] ? select_2088_s4_q : {select_2092[6], select_2092};
  logic [6:0] select_2094;
  assign select_2094 = select_1955_s4_q[0] ? registration_half_half_votes_down_q : registration_half_votes_up_q;
  logic [6:0] select_2095;
  assign select_2095 = select_1955_s4_q[0] ? registration_half_votes_down_q : {1'b0, registration_half_measured_q};
  logic [6:0] select_2096;
  assign select_2096 = select_1955_s4_q[1] ? select_2094 : select_2095;
  logic [7:0] select_2097;
  assign select_2097 = select_1955_s4_q[0] ? {{2{registration_half_across_q[13]}}, registration_half_across_q[13:8]} : registration_half_across_q[7:0];
  logic [7:0] select_2105;
  assign select_2105 = select_1955_s4_q[2] ? {select_2096[6], select_2096} : (select_1955_s4_q[1] ? select_2097 : select_2103_s4_q);
  logic [7:0] select_2127;
  assign select_2127 = select_1955_s4_q[0] ? {2'h0, counts_skin_unproven_q[13:8]} : counts_skin_unproven_q[7:0];
  logic [7:0] select_2129;
  assign select_2129 = select_1955_s4_q[3] ? select_2105 : (select_1955_s4_q[2] ? select_2126_s4_q : select_2127);
  logic [7:0] select_2131;
  assign select_2131 = select_1955_s4_q[5] ? select_2081 : (select_1955_s4_q[4] ? select_2093 : select_2129);
  logic [7:0] select_2133;
  assign select_2133 = select_1955_s4_q[0] ? {2'h0, counts_skin_textured_q[13:8]} : counts_skin_textured_q[7:0];
  logic [7:0] select_2134;
  assign select_2134 = select_1955_s4_q[0] ? {2'h0, counts_skin_supervised_q[13:8]} : counts_skin_supervised_q[7:0];
  logic [7:0] select_2136;
  assign select_2136 = select_1955_s4_q[0] ? {2'h0, counts_regions_bad_q[13:8]} : counts_regions_bad_q[7:0];
  logic [7:0] select_2137;
  assign select_2137 = select_1955_s4_q[0] ? {2'h0, counts_unproven_q[13:8]} : counts_unproven_q[7:0];
  logic [7:0] select_2139;
  assign select_2139 = select_1955_s4_q[2] ? (select_1955_s4_q[1] ? select_2133 : select_2134) : (select_1955_s4_q[1] ? select_2136 : select_2137);
  logic [7:0] select_2140;
  assign select_2140 = select_1955_s4_q[0] ? {2'h0, counts_nearer_q[13:8]} : counts_nearer_q[7:0];
  logic [7:0] select_2141;
  assign select_2141 = select_1955_s4_q[0] ? {2'h0, counts_explained_q[13:8]} : counts_explained_q[7:0];
  logic [7:0] select_2143;
  assign select_2143 = select_1955_s4_q[0] ? {2'h0, counts_textured_q[13:8]} : counts_textured_q[7:0];
  logic [7:0] select_2144;
  assign select_2144 = select_1955_s4_q[0] ? {2'h0, counts_supervised_q[13:8]} : counts_supervised_q[7:0];
  logic [7:0] select_2146;
  assign select_2146 = select_1955_s4_q[2] ? (select_1955_s4_q[1] ? select_2140 : select_2141) : (select_1955_s4_q[1] ? select_2143 : select_2144);
  logic [7:0] select_2156;
  assign select_2156 = select_1955_s4_q[4] ? (select_1955_s4_q[3] ? select_2139 : select_2146) : select_2155_s4_q;
  // hls/stages/agreement.hpp:150
  logic equal_2271;
  assign equal_2271 = x_s4_q[7:3] == 5'h0;
  // hls/stages/census.hpp:305
  logic xor_2283;
  assign xor_2283 = sharpness_comparing_contrast_1_q[1] ^ and_2282_s4_q;
  logic select_2286;
  assign select_2286 = (equal_2272_s4_q | xor_2283) ? (and_2282_s4_q & xor_2283) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/agreement.hpp:154
  logic select_2288;
  assign select_2288 = drew_q ? (equal_2271 ? select_2286 : sharpness_comparing_less_contrast_1_q) : sharpness_comparing_less_contrast_1_q;
  // hls/stages/census.hpp:305
  logic xor_2293;
  assign xor_2293 = sharpness_comparing_contrast_0_q[1] ^ and_2292_s4_q;
  logic select_2296;
  assign select_2296 = (equal_2272_s4_q | xor_2293) ? (and_2292_s4_q & xor_2293) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/agreement.hpp:154
  logic select_2298;
  assign select_2298 = drew_q ? (equal_2271 ? select_2296 : sharpness_comparing_less_contrast_0_q) : sharpness_comparing_less_contrast_0_q;
  // hls/stages/census.hpp:296
  logic [17:0] select_2302;
  assign select_2302 = (less_2300_s4_q & and_2292_s4_q) ? sharpness_sums_detail_0_q[23:6] : 18'h0;
  logic [18:0] sum;
  assign sum = {1'b0, sharpness_comparing_rest_0_q} + {1'b0, select_2302};
  // hls/stages/census.hpp:302
  logic [1:0] five_times;
  assign five_times = {1'b0, sharpness_comparing_carry_1_q} + ({1'b0, sharpness_comparing_product_0_q[1]} + {1'b0, sum[0]});
  // hls/stages/census.hpp:304
  logic xor_2306;
  assign xor_2306 = sharpness_comparing_product_1_q[2] ^ five_times[0];
  logic select_2309;
  assign select_2309 = (equal_2272_s4_q | xor_2306) ? (five_times[0] & xor_2306) : sharpness_comparing_less_detail_1_q;
  // hls/stages/agreement.hpp:154
  logic select_2311;
  assign select_2311 = drew_q ? (equal_2271 ? select_2309 : sharpness_comparing_less_detail_1_q) : sharpness_comparing_less_detail_1_q;
  // hls/stages/census.hpp:296
  logic [17:0] select_2313;
  assign select_2313 = (less_2300_s4_q & and_2282_s4_q) ? sharpness_sums_detail_1_q[23:6] : 18'h0;
  logic [18:0] sum_2;
  assign sum_2 = {1'b0, sharpness_comparing_rest_1_q} + {1'b0, select_2313};
  // hls/stages/census.hpp:302
  logic [1:0] five_times_2;
  assign five_times_2 = {1'b0, sharpness_comparing_carry_0_q} + ({1'b0, sharpness_comparing_product_1_q[1]} + {1'b0, sum_2[0]});
  // hls/stages/census.hpp:304
  logic xor_2317;
  assign xor_2317 = sharpness_comparing_product_0_q[2] ^ five_times_2[0];
  logic select_2320;
  assign select_2320 = (equal_2272_s4_q | xor_2317) ? (five_times_2[0] & xor_2317) : sharpness_comparing_less_detail_0_q;
  // hls/stages/agreement.hpp:154
  logic select_2322;
  assign select_2322 = drew_q ? (equal_2271 ? select_2320 : sharpness_comparing_less_detail_0_q) : sharpness_comparing_less_detail_0_q;
  logic select_2325;
  assign select_2325 = drew_q ? (equal_2271 ? five_times[1] : sharpness_comparing_carry_1_q) : sharpness_comparing_carry_1_q;
  logic select_2327;
  assign select_2327 = drew_q ? (equal_2271 ? five_times_2[1] : sharpness_comparing_carry_0_q) : sharpness_comparing_carry_0_q;
  // hls/stages/registration.hpp:250
  logic select_2329;
  assign select_2329 = select_1955_s4_q[1] ? (select_1955_s4_q[0] ? select_2311 : select_2322) : (select_1955_s4_q[0] ? select_2325 : select_2327);
  logic select_2330;
  assign select_2330 = select_1955_s4_q[2] ? (select_1955_s4_q[0] ? select_2288 : select_2298) : select_2329;
  // hls/stages/agreement.hpp:154
  logic [1:0] select_2331;
  assign select_2331 = equal_2271 ? {sharpness_comparing_contrast_1_q[0], and_2292_s4_q} : sharpness_comparing_contrast_1_q;
  logic [1:0] select_2332;
  assign select_2332 = drew_q ? select_2331 : sharpness_comparing_contrast_1_q;
  logic [1:0] select_2333;
  assign select_2333 = equal_2271 ? {sharpness_comparing_contrast_0_q[0], and_2282_s4_q} : sharpness_comparing_contrast_0_q;
  logic [1:0] select_2334;
  assign select_2334 = drew_q ? select_2333 : sharpness_comparing_contrast_0_q;
  // hls/stages/registration.hpp:250
  logic [1:0] select_2335;
  assign select_2335 = select_1955_s4_q[0] ? select_2332 : select_2334;
  // hls/stages/agreement.hpp:154
  logic [2:0] select_2336;
  assign select_2336 = equal_2271 ? {sharpness_comparing_product_1_q[1:0], sum_2[0]} : sharpness_comparing_product_1_q;
  logic [2:0] select_2337;
  assign select_2337 = drew_q ? select_2336 : sharpness_comparing_product_1_q;
  logic [2:0] select_2338;
  assign select_2338 = equal_2271 ? {sharpness_comparing_product_0_q[1:0], sum[0]} : sharpness_comparing_product_0_q;
  logic [2:0] select_2339;
  assign select_2339 = drew_q ? select_2338 : sharpness_comparing_product_0_q;
  // hls/stages/registration.hpp:250
  logic [2:0] select_2341;
  assign select_2341 = select_1955_s4_q[1] ? {1'b0, select_2335} : (select_1955_s4_q[0] ? select_2337 : select_2339);
  // hls/stages/agreement.hpp:154
  logic [17:0] select_2343;
  assign select_2343 = equal_2271 ? (less_2300_s4_q ? sum_2[18:1] : 18'h0) : sharpness_comparing_rest_1_q;
  logic [17:0] select_2344;
  assign select_2344 = drew_q ? select_2343 : sharpness_comparing_rest_1_q;
  // hls/stages/registration.hpp:250
  logic [1:0] select_2345;
  assign select_2345 = select_1955_s4_q[0] ? 2'h0 : select_2344[17:16];
  logic [7:0] select_2347;
  assign select_2347 = select_1955_s4_q[1] ? {6'h0, select_2345} : (select_1955_s4_q[0] ? select_2344[15:8] : select_2344[7:0]);
  logic [7:0] select_2349;
  assign select_2349 = select_1955_s4_q[3] ? {7'h0, select_2330} : (select_1955_s4_q[2] ? {5'h0, select_2341} : select_2347);
  logic [7:0] select_2351;
  assign select_2351 = select_1955_s4_q[5] ? select_2217_s4_q : (select_1955_s4_q[4] ? select_2270_s4_q : select_2349);
  logic [7:0] select_2352;
  assign select_2352 = select_1955_s4_q[6] ? (select_1955_s4_q[5] ? select_2156 : select_2184_s4_q) : select_2351;
  logic [7:0] select_2353;
  assign select_2353 = select_1955_s4_q[7] ? (select_1955_s4_q[6] ? select_2066 : select_2131) : select_2352;
  // hls/stages/agreement.hpp:154
  logic [17:0] select_2355;
  assign select_2355 = equal_2271 ? (less_2300_s4_q ? sum[18:1] : 18'h0) : sharpness_comparing_rest_0_q;
  logic [17:0] select_2356;
  assign select_2356 = drew_q ? select_2355 : sharpness_comparing_rest_0_q;
  // hls/stages/registration.hpp:250
  logic [1:0] select_2357;
  assign select_2357 = select_1955_s4_q[0] ? 2'h0 : select_2356[17:16];
  logic [7:0] select_2359;
  assign select_2359 = select_1955_s4_q[1] ? {6'h0, select_2357} : (select_1955_s4_q[0] ? select_2356[15:8] : select_2356[7:0]);
  logic [7:0] select_2360;
  assign select_2360 = select_1955_s4_q[0] ? 8'h0 : sharpness_sums_contrast_1_s4_q[23:16];
  logic [7:0] select_2361;
  assign select_2361 = select_1955_s4_q[0] ? sharpness_sums_contrast_1_s4_q[15:8] : sharpness_sums_contrast_1_s4_q[7:0];
  logic [7:0] select_2363;
  assign select_2363 = select_1955_s4_q[2] ? select_2359 : (select_1955_s4_q[1] ? select_2360 : select_2361);
  logic [7:0] select_2364;
  assign select_2364 = select_1955_s4_q[0] ? 8'h0 : sharpness_sums_contrast_0_s4_q[23:16];
  logic [7:0] select_2365;
  assign select_2365 = select_1955_s4_q[0] ? sharpness_sums_contrast_0_s4_q[15:8] : sharpness_sums_contrast_0_s4_q[7:0];
  logic [7:0] select_2368;
  assign select_2368 = select_1955_s4_q[0] ? sharpness_sums_detail_1_q[15:8] : sharpness_sums_detail_1_q[7:0];
  logic [7:0] select_2369;
  assign select_2369 = select_1955_s4_q[1] ? (select_1955_s4_q[0] ? 8'h0 : sharpness_sums_detail_1_q[23:16]) : select_2368;
  logic [7:0] select_2370;
  assign select_2370 = select_1955_s4_q[2] ? (select_1955_s4_q[1] ? select_2364 : select_2365) : select_2369;
  logic [7:0] select_2373;
  assign select_2373 = select_1955_s4_q[0] ? sharpness_sums_detail_0_q[15:8] : sharpness_sums_detail_0_q[7:0];
  logic [7:0] select_2374;
  assign select_2374 = select_1955_s4_q[1] ? (select_1955_s4_q[0] ? 8'h0 : sharpness_sums_detail_0_q[23:16]) : select_2373;
  logic [7:0] select_2375;
  assign select_2375 = select_1955_s4_q[0] ? {2'h0, sharpness_last_detail_1_q[13:8]} : sharpness_last_detail_1_q[7:0];
  logic [7:0] select_2376;
  assign select_2376 = select_1955_s4_q[0] ? {2'h0, sharpness_last_detail_0_q[13:8]} : sharpness_last_detail_0_q[7:0];
  logic [7:0] select_2378;
  assign select_2378 = select_1955_s4_q[2] ? select_2374 : (select_1955_s4_q[1] ? select_2375 : select_2376);
  logic [7:0] select_2386;
  assign select_2386 = select_1955_s4_q[4] ? (select_1955_s4_q[3] ? select_2363 : select_2370) : (select_1955_s4_q[3] ? select_2378 : select_2384_s4_q);
  logic [2:0] select_2387;
  assign select_2387 = select_1955_s4_q[0] ? {3{census_left_misses_q[19]}} : census_left_misses_q[18:16];
  logic [7:0] select_2388;
  assign select_2388 = select_1955_s4_q[0] ? census_left_misses_q[15:8] : census_left_misses_q[7:0];
  logic [7:0] select_2389;
  assign select_2389 = select_1955_s4_q[1] ? {{5{census_left_misses_q[19]}}, select_2387} : select_2388;
  logic [7:0] select_2391;
  assign select_2391 = select_1955_s4_q[0] ? {4'h0, census_changes_values_3_right_q[11:8]} : census_changes_values_3_right_q[7:0];
  logic [7:0] select_2392;
  assign select_2392 = select_1955_s4_q[0] ? {4'h0, census_changes_values_3_left_q[11:8]} : census_changes_values_3_left_q[7:0];
  logic [7:0] select_2394;
  assign select_2394 = select_1955_s4_q[0] ? {4'h0, census_changes_values_2_right_q[11:8]} : census_changes_values_2_right_q[7:0];
  logic [7:0] select_2395;
  assign select_2395 = select_1955_s4_q[0] ? {4'h0, census_changes_values_2_left_q[11:8]} : census_changes_values_2_left_q[7:0];
  logic [7:0] select_2397;
  assign select_2397 = select_1955_s4_q[2] ? (select_1955_s4_q[1] ? select_2391 : select_2392) : (select_1955_s4_q[1] ? select_2394 : select_2395);
  logic [7:0] select_2398;
  assign select_2398 = select_1955_s4_q[3] ? (select_1955_s4_q[2] ? {3'h0, census_filled_q} : select_2389) : select_2397;
  logic [7:0] select_2399;
  assign select_2399 = select_1955_s4_q[0] ? {4'h0, census_changes_values_1_right_q[11:8]} : census_changes_values_1_right_q[7:0];
  logic [7:0] select_2400;
  assign select_2400 = select_1955_s4_q[0] ? {4'h0, census_changes_values_1_left_q[11:8]} : census_changes_values_1_left_q[7:0];
  logic [7:0] select_2402;
  assign select_2402 = select_1955_s4_q[0] ? {4'h0, census_changes_values_0_right_q[11:8]} : census_changes_values_0_right_q[7:0];
  logic [7:0] select_2403;
  assign select_2403 = select_1955_s4_q[0] ? {4'h0, census_changes_values_0_left_q[11:8]} : census_changes_values_0_left_q[7:0];
  logic [7:0] select_2405;
  assign select_2405 = select_1955_s4_q[2] ? (select_1955_s4_q[1] ? select_2399 : select_2400) : (select_1955_s4_q[1] ? select_2402 : select_2403);
  logic [7:0] select_2414;
  assign select_2414 = select_1955_s4_q[4] ? select_2398 : (select_1955_s4_q[3] ? select_2405 : select_2412_s4_q);
  logic [7:0] select_2479;
  assign select_2479 = select_1955_s4_q[6] ? (select_1955_s4_q[5] ? select_2386 : select_2414) : select_2478_s4_q;
  logic [7:0] select_2604;
  assign select_2604 = select_1955_s4_q[8] ? select_2353 : (select_1955_s4_q[7] ? select_2479 : select_2602_s4_q);
  logic [11:0] sum_2605;
  assign sum_2605 = (equal_1946 ? registration_sums_rdata_q[31:20] : 12'h0) + {{4{select_2604[7]}}, select_2604};
  // hls/stages/agreement.hpp:659
  logic [6:0] select_2628;
  assign select_2628 = segment_started_q ? segment_textured_q : 7'h0;
  // hls/stages/agreement.hpp:660
  logic [6:0] sum_2629;
  assign sum_2629 = {6'h0, textured_s4_q} + select_2628;
  // hls/stages/agreement.hpp:792
  logic [9:0] sum_2631;
  assign sum_2631 = {3'h0, sum_2629} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[9:0]);
  // hls/stages/agreement.hpp:659
  logic [6:0] select_2633;
  assign select_2633 = segment_started_q ? segment_explained_q : 7'h0;
  // hls/stages/agreement.hpp:660
  logic [6:0] sum_2634;
  assign sum_2634 = {6'h0, explained_s4_q} + select_2633;
  // hls/stages/agreement.hpp:793
  logic [9:0] sum_2636;
  assign sum_2636 = {3'h0, sum_2634} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[19:10]);
  // hls/stages/agreement.hpp:659
  logic [6:0] select_2639;
  assign select_2639 = segment_started_q ? segment_nearer_q : 7'h0;
  // hls/stages/agreement.hpp:661
  logic [6:0] sum_2640;
  assign sum_2640 = {6'h0, and_2638_s4_q} + select_2639;
  // hls/stages/agreement.hpp:794
  logic [9:0] sum_2642;
  assign sum_2642 = {3'h0, sum_2640} + (region_fresh_s4_q ? 10'h0 : regions_rdata_q[29:20]);
  // hls/stages/agreement.hpp:832
  logic not_2709;
  assign not_2709 = ~region_row_s4_q[2];
  logic [2:0] select_2710;
  assign select_2710 = region_row_s4_q[1] ? {1'b0, not_2709, 1'b0} : {region_row_s4_q[2], 1'b0, not_2709};
  logic [5:0] select_2711;
  assign select_2711 = region_row_s4_q[0] ? {select_2710[2], 1'b0, select_2710[1], 1'b0, select_2710[0], 1'b0} : {1'b0, select_2710[2], 1'b0, select_2710[1], 1'b0, select_2710[0]};
  logic [11:0] select_2712;
  assign select_2712 = or_2708_s4_q ? {select_2711[5], 1'b0, select_2711[4], 1'b0, select_2711[3], 1'b0, select_2711[2], 1'b0, select_2711[1], 1'b0, select_2711[0], 1'b0} : {1'b0, select_2711[5], 1'b0, select_2711[4], 1'b0, select_2711[3], 1'b0, select_2711[2], 1'b0, select_2711[1], 1'b0, select_2711[0]};
  logic [23:0] select_2713;
  assign select_2713 = or_2705_s4_q ? {select_2712[11], 1'b0, select_2712[10], 1'b0, select_2712[9], 1'b0, select_2712[8], 1'b0, select_2712[7], 1'b0, select_2712[6], 1'b0, select_2712[5], 1'b0, select_2712[4], 1'b0, select_2712[3], 1'b0, select_2712[2], 1'b0, select_2712[1], 1'b0, select_2712[0], 1'b0} : {1'b0, select_2712[11], 1'b0, select_2712[10], 1'b0, select_2712[9], 1'b0, select_2712[8], 1'b0, select_2712[7], 1'b0, select_2712[6], 1'b0, select_2712[5], 1'b0, select_2712[4], 1'b0, select_2712[3], 1'b0, select_2712[2], 1'b0, select_2712[1], 1'b0, select_2712[0]};
  logic [47:0] select_2714;
  assign select_2714 = or_2702_s4_q ? {select_2713[23], 1'b0, select_2713[22], 1'b0, select_2713[21], 1'b0, select_2713[20], 1'b0, select_2713[19], 1'b0, select_2713[18], 1'b0, select_2713[17], 1'b0, select_2713[16], 1'b0, select_2713[15], 1'b0, select_2713[14], 1'b0, select_2713[13], 1'b0, select_2713[12], 1'b0, select_2713[11], 1'b0, select_2713[10], 1'b0, select_2713[9], 1'b0, select_2713[8], 1'b0, select_2713[7], 1'b0, select_2713[6], 1'b0, select_2713[5], 1'b0, select_2713[4], 1'b0, select_2713[3], 1'b0, select_2713[2], 1'b0, select_2713[1], 1'b0, select_2713[0], 1'b0} : {1'b0, select_2713[23], 1'b0, select_2713[22], 1'b0, select_2713[21], 1'b0, select_2713[20], 1'b0, select_2713[19], 1'b0, select_2713[18], 1'b0, select_2713[17], 1'b0, select_2713[16], 1'b0, select_2713[15], 1'b0, select_2713[14], 1'b0, select_2713[13], 1'b0, select_2713[12], 1'b0, select_2713[11], 1'b0, select_2713[10], 1'b0, select_2713[9], 1'b0, select_2713[8], 1'b0, select_2713[7], 1'b0, select_2713[6], 1'b0, select_2713[5], 1'b0, select_2713[4], 1'b0, select_2713[3], 1'b0, select_2713[2], 1'b0, select_2713[1], 1'b0, select_2713[0]};
  // hls/stages/agreement.hpp:765
  logic and_2718;
  assign and_2718 = good_known_q & (~((good_q & select_2714) == 48'h0));
  // hls/stages/agreement.hpp:834
  logic is_seen;
  assign is_seen = equal_2697_s4_q ? and_2718 : not_2733_s4_q;
  // hls/stages/agreement.hpp:843
  logic and_2748;
  assign and_2748 = is_seen & less_2747_s4_q;
  // hls/stages/agreement.hpp:365
  logic [11:0] select_2938;
  assign select_2938 = and_409_s4_q ? census_changes_values_0_left_q : census_changes_values_1_left_q;
  logic [11:0] select_2939;
  assign select_2939 = and_409_s4_q ? census_changes_values_0_right_q : census_changes_values_1_right_q;
  logic [11:0] select_2940;
  assign select_2940 = and_409_s4_q ? census_changes_values_1_left_q : census_changes_values_2_left_q;
  logic [11:0] select_2941;
  assign select_2941 = and_409_s4_q ? census_changes_values_1_right_q : census_changes_values_2_right_q;
  logic [11:0] select_2942;
  assign select_2942 = and_409_s4_q ? census_changes_values_2_left_q : census_changes_values_3_left_q;
  logic [11:0] select_2943;
  assign select_2943 = and_409_s4_q ? census_changes_values_2_right_q : census_changes_values_3_right_q;
  // hls/stages/census.hpp:202
  logic [12:0] sum_2946;
  assign sum_2946 = {1'b0, census_changes_values_0_right_q} + {1'b0, sum_2936_s4_q};
  logic [13:0] sum_2948;
  assign sum_2948 = {2'h0, census_changes_values_2_right_q} + ({2'h0, census_changes_values_1_right_q} + {1'b0, sum_2946});
  // hls/stages/census.hpp:225
  logic and_2950;
  assign and_2950 = and_499 & (9'h4 < sum_2948[13:5]);
  // hls/stages/census.hpp:226
  logic and_2951;
  assign and_2951 = and_499 & less_523;
  // hls/stages/census.hpp:227
  logic [19:0] sum_2952;
  assign sum_2952 = census_left_misses_q + {{17{and_2951}}, and_2950, 1'b0, and_2950};
  // hls/stages/agreement.hpp:365
  logic [19:0] select_2954;
  assign select_2954 = and_409_s4_q ? (equal_2945_s4_q ? 20'h0 : sum_2952) : census_left_misses_q;
  logic [13:0] select_2962;
  assign select_2962 = and_409_s4_q ? select_2961_s4_q[13:0] : sharpness_last_detail_0_q;
  logic [13:0] select_2963;
  assign select_2963 = and_409_s4_q ? select_2961_s4_q[27:14] : sharpness_last_detail_1_q;
  // hls/stages/census.hpp:274
  logic [14:0] detail_3;
  assign detail_3 = {1'b0, sharpness_last_detail_0_q} + {1'b0, select_2961_s4_q[13:0]};
  // hls/stages/census.hpp:276
  logic [12:0] select_2974;
  assign select_2974 = and_2972_s4_q ? detail_3[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_2976;
  assign select_2976 = equal_2945_s4_q ? {11'h0, select_2974} : (sharpness_sums_detail_0_q + {11'h0, select_2974});
  // hls/stages/census.hpp:274
  logic [14:0] detail_4;
  assign detail_4 = {1'b0, sharpness_last_detail_1_q} + {1'b0, select_2961_s4_q[27:14]};
  // hls/stages/census.hpp:276
  logic [12:0] select_2985;
  assign select_2985 = and_2983_s4_q ? detail_4[14:2] : 13'h0;
  // hls/stages/census.hpp:277
  logic [23:0] select_2987;
  assign select_2987 = equal_2945_s4_q ? {11'h0, select_2985} : (sharpness_sums_detail_1_q + {11'h0, select_2985});
  // hls/stages/agreement.hpp:682
  logic [13:0] select_3064;
  assign select_3064 = and_3058_s4_q ? 14'h0 : (counts_supervised_q + {13'h0, and_3062_s4_q});
  // hls/stages/agreement.hpp:211
  logic and_3067;
  assign and_3067 = not_1850_s4_q & (drew_q & (ends_cell_s4_q & textured_s4_q));
  logic and_3072;
  assign and_3072 = not_1850_s4_q & (drew_q & (ends_cell_s4_q & explained_s4_q));
  logic and_3077;
  assign and_3077 = not_1850_s4_q & (drew_q & (ends_cell_s4_q & and_2638_s4_q));
  // hls/stages/agreement.hpp:836
  logic not_3081;
  assign not_3081 = ~(x_s4_q[7:1] == 7'h0);
  // hls/stages/agreement.hpp:837
  logic not_3098;
  assign not_3098 = ~(equal_2697_s4_q ? and_2718 : not_3096_s4_q);
  // hls/stages/agreement.hpp:211
  logic and_3101;
  assign and_3101 = ends_cell_s4_q & (not_3081 & (centres_values_1_textured_s4_q & not_3098));
  logic and_3103;
  assign and_3103 = not_1850_s4_q & (drew_q & and_3101);
  // hls/stages/agreement.hpp:862
  logic less_3106;
  assign less_3106 = region_row_s4_q < x_s4_q[5:3];
  logic [9:0] select_3107;
  assign select_3107 = less_3106 ? 10'h0 : regions_rdata_q[9:0];
  logic [9:0] select_3110;
  assign select_3110 = less_3106 ? 10'h0 : regions_rdata_q[19:10];
  // hls/stages/agreement.hpp:863
  logic [10:0] sum_3111;
  assign sum_3111 = {1'b0, select_3110} + {3'h0, select_3110[9:2]};
  logic and_3113;
  assign and_3113 = (~(select_3107[9:4] == 6'h0)) & ({sum_3111, select_3110[1:0]} < {3'h0, select_3107});
  // hls/stages/agreement.hpp:872
  logic [9:0] select_3116;
  assign select_3116 = x_s4_q[6] ? (equal_1894_s4_q ? 10'h0 : (and_3113 ? select_3107 : 10'h0)) : 10'h0;
  // hls/stages/agreement.hpp:211
  logic [9:0] select_3117;
  assign select_3117 = equal_1849_s4_q ? select_3116 : 10'h0;
  // hls/stages/agreement.hpp:682
  logic [13:0] select_3119;
  assign select_3119 = and_3058_s4_q ? 14'h0 : (counts_regions_bad_q + {4'h0, select_3117});
  logic [13:0] select_3126;
  assign select_3126 = and_3058_s4_q ? 14'h0 : (counts_skin_supervised_q + {13'h0, and_3124_s4_q});
  // hls/stages/agreement.hpp:841
  logic and_3128;
  assign and_3128 = not_3081 & (centres_values_1_textured_s4_q & centres_values_1_of_skin_s4_q);
  // hls/stages/agreement.hpp:211
  logic and_3131;
  assign and_3131 = not_1850_s4_q & (drew_q & (ends_cell_s4_q & and_3128));
  // hls/stages/agreement.hpp:682
  logic [13:0] select_3133;
  assign select_3133 = and_3058_s4_q ? 14'h0 : (counts_skin_textured_q + {13'h0, and_3131});
  // hls/stages/agreement.hpp:841
  logic and_3135;
  assign and_3135 = centres_values_1_textured_s4_q & (centres_values_1_of_skin_s4_q & not_3098);
  // hls/stages/agreement.hpp:211
  logic and_3139;
  assign and_3139 = not_1850_s4_q & (drew_q & (ends_cell_s4_q & (not_3081 & and_3135)));
  // hls/stages/agreement.hpp:682
  logic [13:0] select_3141;
  assign select_3141 = and_3058_s4_q ? 14'h0 : (counts_skin_unproven_q + {13'h0, and_3139});
  // hls/stages/agreement.hpp:211
  logic [7:0] select_3149;
  assign select_3149 = equal_1849_s4_q ? 8'h0 : (drew_q ? select_2060 : 8'h0);
  // hls/stages/registration.hpp:126
  logic [13:0] select_3151;
  assign select_3151 = and_3147_s4_q ? 14'h0 : (registration_half_across_q + {{6{select_3149[7]}}, select_3149});
  // hls/stages/agreement.hpp:211
  logic and_3153;
  assign and_3153 = not_1850_s4_q & (drew_q & and_2057);
  // hls/stages/registration.hpp:126
  logic [5:0] select_3155;
  assign select_3155 = and_3147_s4_q ? 6'h0 : (registration_half_measured_q + {5'h0, and_3153});
  // hls/stages/agreement.hpp:211
  logic [1:0] select_3157;
  assign select_3157 = equal_1849_s4_q ? 2'h0 : (drew_q ? select_2056 : 2'h0);
  // hls/stages/registration.hpp:172
  logic [6:0] sum_3158;
  assign sum_3158 = registration_half_votes_down_q + {{5{select_3157[1]}}, select_3157};
  // hls/stages/agreement.hpp:211
  logic [1:0] select_3161;
  assign select_3161 = equal_1849_s4_q ? 2'h0 : (drew_q ? select_2050 : 2'h0);
  // hls/stages/registration.hpp:173
  logic [6:0] sum_3162;
  assign sum_3162 = registration_half_votes_up_q + {{5{select_3161[1]}}, select_3161};
  // hls/stages/agreement.hpp:211
  logic [1:0] select_3165;
  assign select_3165 = equal_1849_s4_q ? 2'h0 : (drew_q ? select_2047 : 2'h0);
  // hls/stages/registration.hpp:172
  logic [6:0] sum_3166;
  assign sum_3166 = registration_half_half_votes_down_q + {{5{select_3165[1]}}, select_3165};
  // hls/stages/agreement.hpp:211
  logic [1:0] select_3169;
  assign select_3169 = equal_1849_s4_q ? 2'h0 : (drew_q ? select_2044 : 2'h0);
  // hls/stages/registration.hpp:173
  logic [6:0] sum_3170;
  assign sum_3170 = registration_half_half_votes_up_q + {{5{select_3169[1]}}, select_3169};
  // hls/stages/registration.hpp:253
  logic [3:0] select_3180;
  assign select_3180 = (sum_1900_s4_q == 2'h2) ? (registration_fresh_q & (~select_1944)) : registration_fresh_q;
  // hls/stages/agreement.hpp:211
  logic [3:0] select_3182;
  assign select_3182 = drew_q ? (and_1939_s4_q ? select_3180 : registration_fresh_q) : registration_fresh_q;
  // hls/stages/registration.hpp:227
  logic [3:0] select_3184;
  assign select_3184 = and_3058_s4_q ? 4'hf : (equal_1849_s4_q ? registration_fresh_q : select_3182);
  // hls/stages/agreement.hpp:211
  logic and_3202;
  assign and_3202 = equal_1849_s4_q & (x_s4_q[6] & (not_2617_s4_q & less_1922_s4_q));
  // hls/stages/registration.hpp:243
  logic not_3204;
  assign not_3204 = ~quarter_2_s4_q[1];
  logic [3:0] select_3205;
  assign select_3205 = quarter_2_s4_q[0] ? {quarter_2_s4_q[1], 1'b0, not_3204, 1'b0} : {1'b0, quarter_2_s4_q[1], 1'b0, not_3204};
  logic equal_3207;
  assign equal_3207 = (registration_fresh_q & select_3205) == 4'h0;
  // hls/stages/agreement.hpp:862
  logic [11:0] select_3209;
  assign select_3209 = or_1926_s4_q ? 12'h0 : (equal_3207 ? registration_sums_rdata_q[11:0] : 12'h0);
  // hls/stages/agreement.hpp:872
  logic [11:0] select_3212;
  assign select_3212 = x_s4_q[6] ? (equal_1894_s4_q ? 12'h0 : (less_1922_s4_q ? select_3209 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:211
  logic [11:0] select_3213;
  assign select_3213 = equal_1849_s4_q ? select_3212 : 12'h0;
  // hls/stages/registration.hpp:145
  logic and_3214;
  assign and_3214 = x_s4_q[1] & all_s4_q;
  // hls/stages/agreement.hpp:872
  logic and_3217;
  assign and_3217 = not_2617_s4_q & (less_1922_s4_q & ({and_3214, x_s4_q[0]} == 2'h0));
  // hls/stages/agreement.hpp:211
  logic and_3219;
  assign and_3219 = equal_1849_s4_q & (x_s4_q[6] & and_3217);
  // hls/stages/registration.hpp:237
  logic [13:0] sum_3221;
  assign sum_3221 = {{2{select_3213[11]}}, select_3213} + (and_3219 ? 14'h0 : registration_down_q);
  // hls/stages/agreement.hpp:862
  logic [11:0] select_3224;
  assign select_3224 = or_1926_s4_q ? 12'h0 : (equal_3207 ? registration_sums_rdata_q[31:20] : 12'h0);
  // hls/stages/agreement.hpp:872
  logic [11:0] select_3227;
  assign select_3227 = x_s4_q[6] ? (equal_1894_s4_q ? 12'h0 : (less_1922_s4_q ? select_3224 : 12'h0)) : 12'h0;
  // hls/stages/agreement.hpp:211
  logic [11:0] select_3228;
  assign select_3228 = equal_1849_s4_q ? select_3227 : 12'h0;
  // hls/stages/registration.hpp:238
  logic [13:0] sum_3230;
  assign sum_3230 = {{2{select_3228[11]}}, select_3228} + (and_3219 ? 14'h0 : registration_up_q);
  // hls/stages/registration.hpp:142
  logic not_3232;
  assign not_3232 = ~all_s4_q;
  // hls/stages/agreement.hpp:872
  logic and_3235;
  assign and_3235 = not_2617_s4_q & (less_1922_s4_q & (x_s4_q[2:0] == {all_s4_q, not_3232, 1'b0}));
  // hls/stages/agreement.hpp:211
  logic and_3241;
  assign and_3241 = equal_1849_s4_q & (x_s4_q[6] & (not_2617_s4_q & (less_1922_s4_q & all_s4_q)));
  // hls/stages/registration.hpp:231
  logic not_3242;
  assign not_3242 = ~and_3241;
  logic less_3243;
  assign less_3243 = $signed({9'h1, {2{not_3242}}, and_3241}) < $signed(registration_up_q[13:2]);
  logic select_3244;
  assign select_3244 = (equal_1849_s4_q & (x_s4_q[6] & and_3235)) ? less_3243 : registration_enough_q;
  // hls/stages/agreement.hpp:872
  logic and_3248;
  assign and_3248 = x_s4_q[6] & (not_2617_s4_q & (less_1922_s4_q & (x_s4_q[2:0] == 3'h4)));
  // hls/stages/agreement.hpp:211
  logic and_3249;
  assign and_3249 = equal_1849_s4_q & and_3248;
  // hls/stages/registration.hpp:227
  logic less_3250;
  assign less_3250 = $signed(14'h0) < $signed(registration_down_q);
  logic less_3252;
  assign less_3252 = $signed(14'h0) < $signed(registration_up_q);
  // hls/stages/agreement.hpp:872
  logic and_3257;
  assign and_3257 = x_s4_q[6] & (not_2617_s4_q & (less_1922_s4_q & (x_s4_q[2:0] == 3'h7)));
  // hls/stages/agreement.hpp:211
  logic and_3258;
  assign and_3258 = equal_1849_s4_q & and_3257;
  // hls/stages/agreement.hpp:872
  logic and_3265;
  assign and_3265 = x_s4_q[6] & (not_2617_s4_q & (less_1922_s4_q & (x_s4_q[5:0] == 6'h0)));
  // hls/stages/registration.hpp:149
  logic equal_3268;
  assign equal_3268 = x_s4_q[2:0] == 3'h6;
  // hls/stages/agreement.hpp:872
  logic and_3271;
  assign and_3271 = not_2617_s4_q & (less_1922_s4_q & (x_s4_q[5] ? x_s4_q[3] : equal_3268));
  // hls/stages/registration.hpp:229
  logic and_3275;
  assign and_3275 = (equal_1849_s4_q & (x_s4_q[6] & and_3271)) & (less_3252 | less_3250);
  // hls/stages/agreement.hpp:872
  logic and_3280;
  assign and_3280 = not_2617_s4_q & (less_1922_s4_q & ((~x_s4_q[5]) & (x_s4_q[3] & equal_3268)));
  // hls/stages/registration.hpp:229
  logic and_3283;
  assign and_3283 = registration_votes_up_q & registration_other_down_q;
  logic select_3285;
  assign select_3285 = registration_votes_down_q ? (registration_other_up_q | and_3283) : and_3283;
  // hls/stages/registration.hpp:130
  logic and_3287;
  assign and_3287 = (equal_1849_s4_q & (x_s4_q[6] & and_3280)) & (registration_other_enough_q & select_3285);
  // hls/stages/registration.hpp:230
  logic or_3290;
  assign or_3290 = registration_moved_q | (registration_enough_q & (and_3275 | and_3287));
  // hls/stages/agreement.hpp:909
  logic or_3338;
  assign or_3338 = ({counts_textured_q, 4'h0} < {4'h0, counts_supervised_q}) | (counts_textured_q[13:3] < 11'h5);
  // hls/stages/agreement.hpp:931
  logic equal_3340;
  assign equal_3340 = x_s4_q[6:3] == 4'h7;
  // hls/stages/agreement.hpp:937
  logic equal_3341;
  assign equal_3341 = x_s4_q[2:0] == 3'h0;
  // hls/stages/agreement.hpp:940
  logic too_little;
  assign too_little = (counts_explained_q < product_q) | (product_rest_q & (counts_explained_q == product_q));
  // hls/stages/agreement.hpp:941
  logic select_3347;
  assign select_3347 = (equal_3340 & equal_3341) ? too_little : disagree_q;
  // hls/stages/agreement.hpp:865
  logic [10:0] sum_3350;
  assign sum_3350 = {1'b0, select_3110} + {2'h0, select_3110[9:1]};
  logic select_3353;
  assign select_3353 = (select_3107[9:3] == 7'h0) ? ((~or_3338) & (~select_3347)) : (~({sum_3350, select_3110[0]} < {2'h0, select_3107}));
  // hls/stages/agreement.hpp:872
  logic [47:0] select_3355;
  assign select_3355 = x_s4_q[6] ? (equal_1894_s4_q ? good_q : {select_3353, good_q[47:1]}) : good_q;
  // hls/stages/agreement.hpp:211
  logic select_3360;
  assign select_3360 = equal_1849_s4_q ? ((x_s4_q[6] & good_known_q) | equal_3358_s4_q) : good_known_q;
  // hls/stages/agreement.hpp:931
  logic equal_3361;
  assign equal_3361 = x_s4_q[6:3] == 4'ha;
  logic equal_3363;
  assign equal_3363 = x_s4_q[6:3] == 4'h9;
  logic equal_3364;
  assign equal_3364 = x_s4_q[6:3] == 4'h8;
  // hls/stages/agreement.hpp:856
  logic [13:0] select_3366;
  assign select_3366 = equal_3363 ? counts_skin_unproven_q : (equal_3364 ? counts_unproven_q : counts_regions_bad_q);
  logic [13:0] before_v_6;
  assign before_v_6 = equal_3361 ? counts_nearer_q : select_3366;
  // hls/stages/agreement.hpp:936
  logic [14:0] over;
  assign over = {1'b0, product_q} - {1'b0, before_v_6};
  // hls/stages/agreement.hpp:944
  logic select_3369;
  assign select_3369 = (equal_3361 & equal_3341) ? over[14] : hides_q;
  // hls/stages/agreement.hpp:873
  logic not_3370;
  assign not_3370 = ~hidden_for_q[7];
  logic [7:0] select_3372;
  assign select_3372 = select_3369 ? (hidden_for_q + {7'h0, not_3370}) : 8'h0;
  // hls/stages/agreement.hpp:211
  logic [7:0] select_3374;
  assign select_3374 = equal_1849_s4_q ? (equal_3358_s4_q ? select_3372 : hidden_for_q) : hidden_for_q;
  // hls/stages/agreement.hpp:944
  logic [13:0] select_3375;
  assign select_3375 = equal_3341 ? 14'h0 : product_q;
  // hls/stages/agreement.hpp:856
  logic [7:0] select_3377;
  assign select_3377 = (x_s4_q[6:3] == 4'h6) ? cfg_explained_limit_i : cfg_regions_limit_i;
  logic [7:0] select_3379;
  assign select_3379 = equal_3364 ? cfg_unproven_skin_limit_i : (equal_3340 ? cfg_unproven_limit_i : select_3377);
  logic [7:0] limit;
  assign limit = equal_3361 ? cfg_regions_limit_i : (equal_3363 ? cfg_hidden_limit_i : select_3379);
  // hls/stages/agreement.hpp:944
  logic not_3382;
  assign not_3382 = ~x_s4_q[2];
  logic [3:0] select_3383;
  assign select_3383 = x_s4_q[1] ? {x_s4_q[2], 1'b0, not_3382, 1'b0} : {1'b0, x_s4_q[2], 1'b0, not_3382};
  logic [7:0] select_3384;
  assign select_3384 = x_s4_q[0] ? {select_3383[3], 1'b0, select_3383[2], 1'b0, select_3383[1], 1'b0, select_3383[0], 1'b0} : {1'b0, select_3383[3], 1'b0, select_3383[2], 1'b0, select_3383[1], 1'b0, select_3383[0]};
  // hls/stages/agreement.hpp:856
  logic [13:0] select_3388;
  assign select_3388 = equal_3363 ? counts_skin_supervised_q : (equal_3364 ? counts_skin_textured_q : counts_textured_q);
  logic [13:0] of;
  assign of = equal_3361 ? counts_textured_q : select_3388;
  // hls/stages/agreement.hpp:944
  logic [13:0] select_3390;
  assign select_3390 = ((limit & select_3384) == 8'h0) ? 14'h0 : of;
  logic [14:0] sum_3;
  assign sum_3 = {1'b0, select_3375} + {1'b0, select_3390};
  // hls/stages/agreement.hpp:211
  logic select_3395;
  assign select_3395 = equal_1849_s4_q ? (equal_3341 ? sum_3[0] : (product_rest_q | sum_3[0])) : product_rest_q;
  // hls/stages/agreement.hpp:942
  logic and_3400;
  assign and_3400 = too_much_q & (~(equal_3364 & equal_3341));
  // hls/stages/agreement.hpp:943
  logic select_3405;
  assign select_3405 = (over[14] & equal_3341) ? (and_3400 | ((equal_3364 | equal_3363) | (x_s4_q[6:3] == 4'hf))) : and_3400;
  // hls/stages/agreement.hpp:1013
  logic [1:0] select_3523;
  assign select_3523 = and_3522_s4_q ? {and_2748, is_seen} : map_rdata_q;
  // hls/stages/agreement.hpp:1014
  logic and_3524;
  assign and_3524 = proven_q & less_3512;
  // hls/stages/agreement.hpp:220
  logic select_3527;
  assign select_3527 = and_2677_s4_q ? (less_2678_s4_q ? (select_3523[0] & and_3524) : seen_q) : seen_q;
  logic select_3530;
  assign select_3530 = and_2677_s4_q ? (less_2678_s4_q ? (select_3523[1] & and_3524) : nearer_q) : nearer_q;
  // hls/stages/agreement.hpp:953
  logic not_3542;
  assign not_3542 = ~(or_3338 | not_3531);
  // hls/stages/agreement.hpp:211
  logic and_3546;
  assign and_3546 = equal_1849_s4_q & (equal_3358_s4_q & (not_3542 & (select_3347 | select_3405)));
  logic and_3549;
  assign and_3549 = equal_1849_s4_q & (equal_3358_s4_q & (cfg_prove_i & registration_moved_q));
  // hls/stages/agreement.hpp:875
  logic or_3552;
  assign or_3552 = select_2322 | (select_2298 | ($signed(20'h0) < $signed(census_left_misses_q)));
  // hls/stages/agreement.hpp:211
  logic and_3559;
  assign and_3559 = equal_1849_s4_q & (equal_3358_s4_q & (not_3542 & (select_2311 | select_2288)));
  // hls/stages/agreement.hpp:875
  logic and_3564;
  assign and_3564 = (~(cfg_hidden_frames_i == 8'h0)) & (~(select_3372 < cfg_hidden_frames_i));
  // hls/stages/agreement.hpp:211
  logic and_3571;
  assign and_3571 = equal_1849_s4_q & (x_s4_q[6] & (not_2617_s4_q | (4'hc < x_s4_q[5:2])));
  // hls/stages/registration.hpp:243
  logic not_3574;
  assign not_3574 = ~quarter_s4_q[1];
  logic [3:0] select_3575;
  assign select_3575 = quarter_s4_q[0] ? {quarter_s4_q[1], 1'b0, not_3574, 1'b0} : {1'b0, quarter_s4_q[1], 1'b0, not_3574};
  // hls/stages/agreement.hpp:900
  logic [31:0] select_3578;
  assign select_3578 = ((registration_fresh_q & select_3575) == 4'h0) ? registration_sums_rdata_q : 32'h0;
  // hls/stages/agreement.hpp:870
  logic [31:0] select_3579;
  assign select_3579 = equal_1914_s4_q ? {2'h0, counts_explained_q, 2'h0, counts_textured_q} : select_3578;
  logic [31:0] select_3580;
  assign select_3580 = equal_1912_s4_q ? {2'h0, counts_nearer_q, 2'h0, counts_supervised_q} : select_3579;
  logic [31:0] select_3581;
  assign select_3581 = equal_1910_s4_q ? {2'h0, counts_regions_bad_q, 2'h0, counts_unproven_q} : select_3580;
  logic [31:0] select_3582;
  assign select_3582 = equal_1908_s4_q ? {8'h0, sharpness_sums_detail_0_q} : select_3581;
  logic [31:0] select_3583;
  assign select_3583 = equal_1906_s4_q ? {8'h0, sharpness_sums_detail_1_q} : select_3582;
  logic [31:0] select_3584;
  assign select_3584 = equal_1904_s4_q ? {8'h0, sharpness_sums_contrast_0_s4_q} : select_3583;
  logic [31:0] select_3585;
  assign select_3585 = equal_1902_s4_q ? {8'h0, sharpness_sums_contrast_1_s4_q} : select_3584;
  // hls/stages/agreement.hpp:868
  logic [9:0] select_3586;
  assign select_3586 = less_3106 ? 10'h0 : regions_rdata_q[29:20];
  // hls/stages/agreement.hpp:872
  logic [31:0] select_3587;
  assign select_3587 = equal_1894_s4_q ? select_3585 : {2'h0, select_3586, select_3110, select_3107};

  // Memory fresh, write
  logic [6:0] fresh_waddr;
  assign fresh_waddr = column_s4_q;
  logic fresh_we;
  assign fresh_we = s4_en & and_409_s4_q;
  logic [28:0] fresh_wdata;
  assign fresh_wdata = {census_columns_values_1_cell_2_of_skin_s4_q, and_524, and_500, and_499, and_474, less_466_s4_q, less_465_s4_q, less_464_s4_q, less_463_s4_q, less_462_s4_q, less_461_s4_q, less_460_s4_q, less_459_s4_q, less_458_s4_q, less_457_s4_q, less_456_s4_q, less_455_s4_q, less_454_s4_q, less_453_s4_q, less_452_s4_q, less_451_s4_q, less_450_s4_q, less_449_s4_q, less_448_s4_q, less_447_s4_q, less_446_s4_q, less_445_s4_q, less_444_s4_q, less_443_s4_q};
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (fresh_we) fresh_mem[fresh_waddr] <= {^fresh_wdata, fresh_wdata};
  end
`ifndef SYNTHESIS
  logic [6:0] fresh_raddr_s1_sim;
  logic fresh_re_s1_sim;
  logic [6:0] fresh_raddr_s2_sim;
  logic fresh_re_s2_sim;
  logic [6:0] fresh_raddr_s3_sim;
  logic fresh_re_s3_sim;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      fresh_re_s1_sim <= 1'b0;
      fresh_re_s2_sim <= 1'b0;
      fresh_re_s3_sim <= 1'b0;
    end else if (en_i) begin
      fresh_re_s1_sim <= fresh_re;
      fresh_raddr_s1_sim <= fresh_raddr;
      fresh_re_s2_sim <= fresh_re_s1_sim;
      fresh_raddr_s2_sim <= fresh_raddr_s1_sim;
      fresh_re_s3_sim <= fresh_re_s2_sim;
      fresh_raddr_s3_sim <= fresh_raddr_s2_sim;
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
      if (fresh_re_s3_sim && fresh_raddr_s3_sim == fresh_waddr) begin
        $error("fresh: address %0d is read less than DISTANCE steps after its write", fresh_waddr);
      end
      if (fresh_waddr >= 7'd80) $error("fresh: write outside, address %0d", fresh_waddr);
    end
    if (rst_ni && fresh_re && fresh_raddr >= 7'd80) $error("fresh: read outside, address %0d", fresh_raddr);
  end
`endif

  // Memory registration_sums, write
  logic [3:0] registration_sums_waddr;
  assign registration_sums_waddr = {sum_1900_s4_q, lower_half_s4_q, registration_of_right_s4_q};
  logic registration_sums_we;
  assign registration_sums_we = s4_en & and_2606_s4_q;
  logic [31:0] registration_sums_wdata;
  assign registration_sums_wdata = {sum_2605, sum_1951};
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

  // Memory regions, write
  logic [5:0] regions_waddr;
  assign regions_waddr = {region_row_s4_q, or_2615_s4_q, or_2612_s4_q, or_2609_s4_q};
  logic regions_we;
  assign regions_we = s4_en & and_2643_s4_q;
  logic [29:0] regions_wdata;
  assign regions_wdata = {sum_2642, sum_2636, sum_2631};
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
  assign map_waddr = {sum_2683_s4_q, index_2_s4_q};
  logic map_we;
  assign map_we = s4_en & and_2758_s4_q;
  logic [1:0] map_wdata;
  assign map_wdata = {and_2748, is_seen};
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
      census_filled_q <= 5'h0;
      sharpness_sums_detail_0_q <= 24'h0;
      sharpness_sums_detail_1_q <= 24'h0;
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
      registration_half_across_q <= 14'h0;
      registration_half_measured_q <= 6'h0;
      registration_half_votes_down_q <= 7'h0;
      registration_half_votes_up_q <= 7'h0;
      registration_half_half_votes_down_q <= 7'h0;
      registration_half_half_votes_up_q <= 7'h0;
      registration_fresh_q <= 4'hf;
      registration_down_q <= 14'h0;
      registration_up_q <= 14'h0;
      registration_enough_q <= 1'b0;
      registration_votes_down_q <= 1'b0;
      registration_votes_up_q <= 1'b0;
      registration_other_enough_q <= 1'b0;
      registration_other_down_q <= 1'b0;
      registration_other_up_q <= 1'b0;
      registration_moved_q <= 1'b0;
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
      seen_q <= 1'b0;
      nearer_q <= 1'b0;
    end else if (s4_en) begin
      census_left_misses_q <= select_2954;
      census_filled_q <= and_409_s4_q ? {select_473, 1'b1} : census_filled_q;
      sharpness_sums_detail_0_q <= and_409_s4_q ? select_2976 : sharpness_sums_detail_0_q;
      sharpness_sums_detail_1_q <= and_409_s4_q ? select_2987 : sharpness_sums_detail_1_q;
      sharpness_comparing_rest_0_q <= select_2356;
      sharpness_comparing_rest_1_q <= select_2344;
      sharpness_comparing_product_0_q <= select_2339;
      sharpness_comparing_product_1_q <= select_2337;
      sharpness_comparing_contrast_0_q <= select_2334;
      sharpness_comparing_contrast_1_q <= select_2332;
      sharpness_comparing_carry_0_q <= select_2327;
      sharpness_comparing_carry_1_q <= select_2325;
      sharpness_comparing_less_detail_0_q <= select_2322;
      sharpness_comparing_less_detail_1_q <= select_2311;
      sharpness_comparing_less_contrast_0_q <= select_2298;
      sharpness_comparing_less_contrast_1_q <= select_2288;
      counts_supervised_q <= select_3064;
      counts_textured_q <= and_3058_s4_q ? 14'h0 : (counts_textured_q + {13'h0, and_3067});
      counts_explained_q <= and_3058_s4_q ? 14'h0 : (counts_explained_q + {13'h0, and_3072});
      counts_nearer_q <= and_3058_s4_q ? 14'h0 : (counts_nearer_q + {13'h0, and_3077});
      counts_unproven_q <= and_3058_s4_q ? 14'h0 : (counts_unproven_q + {13'h0, and_3103});
      counts_regions_bad_q <= select_3119;
      counts_skin_supervised_q <= select_3126;
      counts_skin_textured_q <= select_3133;
      counts_skin_unproven_q <= select_3141;
      registration_half_across_q <= select_3151;
      registration_half_measured_q <= select_3155;
      registration_half_votes_down_q <= and_3147_s4_q ? 7'h0 : sum_3158;
      registration_half_votes_up_q <= and_3147_s4_q ? 7'h0 : sum_3162;
      registration_half_half_votes_down_q <= and_3147_s4_q ? 7'h0 : sum_3166;
      registration_half_half_votes_up_q <= and_3147_s4_q ? 7'h0 : sum_3170;
      registration_fresh_q <= select_3184;
      registration_down_q <= and_3202 ? sum_3221 : registration_down_q;
      registration_up_q <= and_3202 ? sum_3230 : registration_up_q;
      registration_enough_q <= select_3244;
      registration_votes_down_q <= and_3249 ? less_3250 : registration_votes_down_q;
      registration_votes_up_q <= and_3249 ? less_3252 : registration_votes_up_q;
      registration_other_enough_q <= and_3258 ? select_3244 : registration_other_enough_q;
      registration_other_down_q <= and_3258 ? registration_votes_down_q : registration_other_down_q;
      registration_other_up_q <= and_3258 ? registration_votes_up_q : registration_other_up_q;
      registration_moved_q <= (~(equal_1849_s4_q & and_3265)) & or_3290;
      segment_textured_q <= select_2628 + {6'h0, and_3067};
      segment_explained_q <= select_2633 + {6'h0, and_3072};
      segment_nearer_q <= select_2639 + {6'h0, and_3077};
      segment_started_q <= ~segment_starts_q;
      good_q <= equal_1849_s4_q ? select_3355 : good_q;
      good_known_q <= select_3360;
      hidden_for_q <= select_3374;
      product_q <= equal_1849_s4_q ? sum_3[14:1] : product_q;
      product_rest_q <= select_3395;
      disagree_q <= equal_1849_s4_q ? select_3347 : disagree_q;
      too_much_q <= equal_1849_s4_q ? select_3405 : too_much_q;
      hides_q <= equal_1849_s4_q ? select_3369 : hides_q;
      seen_q <= select_3527;
      nearer_q <= select_3530;
    end
  end

  // Not reset: nothing of it counts before it is written anew.
`ifndef SYNTHESIS
  initial begin
    census_changes_values_0_left_q = 12'h0;
    census_changes_values_0_right_q = 12'h0;
    census_changes_values_1_left_q = 12'h0;
    census_changes_values_1_right_q = 12'h0;
    census_changes_values_2_left_q = 12'h0;
    census_changes_values_2_right_q = 12'h0;
    census_changes_values_3_left_q = 12'h0;
    census_changes_values_3_right_q = 12'h0;
    sharpness_last_detail_0_q = 14'h0;
    sharpness_last_detail_1_q = 14'h0;
  end
`endif
  always @(posedge clk_i) begin  // not always_ff: `initial` writes it, too
    if (s4_en) begin
      census_changes_values_0_left_q <= and_409_s4_q ? texture_s4_q : census_changes_values_0_left_q;
      census_changes_values_0_right_q <= and_409_s4_q ? sum_2936_s4_q : census_changes_values_0_right_q;
      census_changes_values_1_left_q <= select_2938;
      census_changes_values_1_right_q <= select_2939;
      census_changes_values_2_left_q <= select_2940;
      census_changes_values_2_right_q <= select_2941;
      census_changes_values_3_left_q <= select_2942;
      census_changes_values_3_right_q <= select_2943;
      sharpness_last_detail_0_q <= select_2962;
      sharpness_last_detail_1_q <= select_2963;
    end
  end

  logic [7:0] pixel_0_s5_q;
  logic [7:0] pixel_1_s5_q;
  logic saturated_s5_q;
  logic mask_s5_q;
  logic marks_first_s5_q;
  logic marks_last_s5_q;
  logic and_3507_s5_q;
  logic or_3532_s5_q;
  logic and_3533_s5_q;
  logic and_3537_s5_q;
  logic and_3540_s5_q;
  logic and_3546_s5_q;
  logic and_3549_s5_q;
  logic and_3555_s5_q;
  logic and_3559_s5_q;
  logic and_3567_s5_q;
  logic and_3571_s5_q;
  logic [5:0] select_3573_s5_q;
  logic [31:0] select_3589_s5_q;
  always_ff @(posedge clk_i) begin
    if (s4_en) begin
      pixel_0_s5_q <= pixel_0_s4_q;
      pixel_1_s5_q <= pixel_1_s4_q;
      saturated_s5_q <= saturated_s4_q;
      mask_s5_q <= mask_s4_q;
      marks_first_s5_q <= marks_first_s4_q;
      marks_last_s5_q <= line_ended_q;
      and_3507_s5_q <= said_q;
      or_3532_s5_q <= not_3531 | select_3527;
      and_3533_s5_q <= cfg_prove_i & select_3530;
      and_3537_s5_q <= and_3537_s4_q;
      and_3540_s5_q <= equal_1849_s4_q & (equal_3358_s4_q & (cfg_prove_i & or_3338));
      and_3546_s5_q <= and_3546;
      and_3549_s5_q <= and_3549;
      and_3555_s5_q <= equal_1849_s4_q & (equal_3358_s4_q & (not_3542 & or_3552));
      and_3559_s5_q <= and_3559;
      and_3567_s5_q <= equal_1849_s4_q & (equal_3358_s4_q & (cfg_prove_i & and_3564));
      and_3571_s5_q <= and_3571;
      select_3573_s5_q <= equal_1849_s4_q ? (x_s4_q[6] ? x_s4_q[5:0] : 6'h0) : 6'h0;
      select_3589_s5_q <= equal_1849_s4_q ? (x_s4_q[6] ? select_3587 : 32'h0) : 32'h0;
    end
  end

  // Parity ------------------------------------------------------------------------------------------------------------
  always_ff @(posedge clk_i) parity_error_o <= rst_ni & (averager_memory_error | census_memory_error | fresh_error | left_error | right_codes_error | best_left_error | best_right_error | shown_right_error | registration_sums_error | regions_error | seen_columns_error | map_error);

  // Outputs -----------------------------------------------------------------------------------------------------------
  assign pixel_0_o = pixel_0_s5_q;
  assign pixel_1_o = pixel_1_s5_q;
  assign saturated_o = saturated_s5_q;
  assign mask_o = mask_s5_q;
  assign marks_first_o = marks_first_s5_q;
  assign marks_last_o = marks_last_s5_q;
  assign marks_seen_o = or_3532_s5_q;
  assign marks_nearer_o = and_3533_s5_q;
  assign verdict_valid_o = and_3507_s5_q;
  assign verdict_unproven_yet_o = and_3537_s5_q;
  assign verdict_untextured_o = and_3540_s5_q;
  assign verdict_disagree_o = and_3546_s5_q;
  assign verdict_moved_o = and_3549_s5_q;
  assign verdict_unsharp_left_o = and_3555_s5_q;
  assign verdict_unsharp_right_o = and_3559_s5_q;
  assign verdict_hidden_o = and_3567_s5_q;
  assign frame_valid_o = and_3571_s5_q;
  assign frame_index_o = select_3573_s5_q;
  assign frame_word_o = select_3589_s5_q;
  assign valid_o = valid_s5_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_s1_q <= 1'b0;
      valid_s2_q <= 1'b0;
      valid_s3_q <= 1'b0;
      valid_s4_q <= 1'b0;
      valid_s5_q <= 1'b0;
    end else if (en_i) begin
      valid_s1_q <= valid_i;
      valid_s2_q <= valid_s1_q;
      valid_s3_q <= valid_s2_q;
      valid_s4_q <= valid_s3_q;
      valid_s5_q <= valid_s4_q;
    end
  end

  // Nothing depends on these bits.
  logic unused_bits;
  assign unused_bits = ^{over[13:0], detail_4[1:0], detail_3[1:0], sum_2948[4:0], sum_2123[0], sum_2031[0], sum_2027[0], sum_522[4:0], cfg_width_i[2:0]};

endmodule
